/* illustrate: turns 3D models into technical illustrations, without a window. `illustrate --help` says how. */
#define _POSIX_C_SOURCE 200809L

#include <errno.h>
#include <fnmatch.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "headless.h"
#include "illustrate_render.h"
#include "load_model.h"
#include "models.h"
#include "scene.h"
#include "transfer_image.h"
#include "write_png.h"

#define ILLUSTRATE_VERSION "0.2.0"

enum { DONE = 0, FAILED = 1, USAGE = 2 };

/* In pieces, since C99 promises no more than 4,095 bytes for one. */
static const char *const HELP[] = {
    "illustrate MODEL... -o OUT.png: 3D models as technical illustrations, in one command.\n"
    "\n"
    "MODEL is a file (glTF, GLB, OBJ, STL, PLY, 3DS, FBX, DAE and others) or one that is built in:\n"
    "  model:mug  model:crank  model:gearbox  model:torus_knot  model:shells  model:squares  model:cylinders\n"
    "  model:cube_and_sphere  model:klein_bottle  model:stream_surface\n"
    "  model:dirty_open  model:dirty_doubled  model:dirty_degenerate  model:dirty_nonmanifold  model:dirty_flipped\n"
    "  model:battlefield  model:abstract  model:walkthrough\n"
    "Several make one scene; the parts of each file then have its name in front of theirs.\n"
    "\n"
    "  -o, --output OUT.png     where the picture goes; written whole or not at all. OUT.svg: its lines alone, a group\n"
    "                           for each part, without the need of OpenGL; hidden lines are left out\n"
    "  --style STYLE            auto (default): smart for a single open surface that rolls up, so that both of its sides\n"
    "                           are seen; else hodges where something is or can be transparent, else opaque;\n"
    "                           hodges: parts that enclose others, or are see-through in the file, are transparent by\n"
    "                           Hodges' rules; glass: the same parts, with every layer seen through the others, lines\n"
    "                           among them (OpenGL 4.3 or ES 3.1); smart: glass whose silhouettes show through, with\n"
    "                           halos; curvature: glass that is clear where it is flat, shaded by its curvature; lines:\n"
    "                           ink on paper, hidden lines left out; opaque: nothing transparent. smart and curvature\n"
    "                           draw no --lines unless asked to\n"
    "  --size WxH               pixels, 1x1 to 16384x16384; default 1024x768\n"
    "  --view AZIMUTH,ELEVATION degrees; 0,0 looks at the front, 90,0 at the right side; default 30,20\n"
    "  --ortho                  parallel lines stay parallel\n"
    "  --transparent PART[,PART...]\n"
    "  --opaque PART[,PART...]  overrule what the style would do\n"
    "  --hide PART[,PART...]    PART is a path as --list shows it, the path of a group (all parts in it), a path's\n"
    "                           last component, or any of these with the wildcards * and ?; later ones win\n"
    "  --list                   print the parts and stop, unless there is -o as well\n"
    "  --lines WORD[,WORD...][:WIDTH]\n"
    "                           which: silhouettes, boundaries, creases; all (default) or none; width in pixels, default\n"
    "                           1.5. How heavy: thick-thin, outlines and borders heavy; outer, where nothing is behind;\n"
    "                           perspective, the foreground heavy; light, thin toward the upper left. phantom: parts that\n"
    "                           would be transparent are drawn as dashed lines only; smooth: rounder silhouettes, on\n"
    "                           meshes without creases;\n"
    "                           hidden: hidden lines as short dashes\n",
    "  --shade SHADE            cool-to-warm (default) or flat\n"
    "  --background RRGGBB      or none for a see-through one; default ffffff\n"
    "  --k K                    how fast transparent surfaces clear away from their silhouettes (exponent)\n"
    "  --alpha-quality N        how that is found: 1: alpha at vertices, as published; 2: distance at vertices; 3\n"
    "                           (default): distance at each pixel, to the edges that its triangle carries; 4: at each\n"
    "                           pixel, to all edges. 1 and 2 divide the mesh finely first\n"
    "  --blend BLEND            over (default), normalised or published; the last two weigh what is behind\n"
    "  --weights OPAQUE,BACKGROUND\n"
    "                           how much of what is behind shines through, 0 to 1 each; for --blend normalised and\n"
    "                           published\n"
    "  --interior HOW           auto (default): explicit where transparent parts have inner walls, else implicit;\n"
    "                           implicit; explicit; published: with the paper's faults; layers:N: the N closest\n"
    "  --glass LAW[:OPACITY]    constant (default): each layer of --style glass hides OPACITY, 0 to 1, default 0.3;\n"
    "                           adaptive: all layers of a pixel do together, however many; default 0.7. Parts that are\n"
    "                           see-through in the file keep their own\n"
    "  --law LAW[:OPACITY]      --style smart and curvature, what a layer starts with: adaptive (default, 0.6), all\n"
    "                           layers of a pixel together; constant; angle and variation, more where the surface turns\n"
    "                           away or bends; distance, more near silhouettes; given: as in the file. Default 0.3\n"
    "  --iterations N           --style smart: pixels over which silhouettes fade, 1 to 500, default 20; 0: neither they\n"
    "                           nor halos, but the law alone\n"
    "  --halo N                 --style smart: the same of halos, 0 to 500, 0 for none; default 5\n"
    "  --transfer WORD[,WORD]   --style curvature: shade convex or curved, opacity front or deep; default convex,deep.\n"
    "                           FILE.png: of one row, a shade for curvatures from convex to concave, 128 leaving\n"
    "                           colours alone; of several, opacity: flat to curved, near (top) to far\n"
    "  --neighbours HOW         --style smart and curvature, which places of a surface go on in one another: mutual\n"
    "                           (default); carnecky, murray: as their papers have it; one-sided: the latter without\n"
    "                           asking back\n"
    "  --contours KIND[:LEAST]  --style smart and curvature, lines within surfaces: suggestive, where they would turn away\n"
    "                           if seen from nearby; LEAST leaves out faint ones, default 1; or none (default)\n"
    "  --group PART[,PART...]   transparent parts that show through each other; several --group are several groups\n"
    "  --group-distance D       only where closer than D along the view\n"
    "  --enter SHADE            darken opaque parts where they enter transparent ones, 0 to 1\n"
    "  --quality N              samples per pixel along each axis, 1 to 8; default 3\n"
    "  --up AXIS                y or z, where a file's convention is wrong\n"
    "  --gles                   OpenGL ES 3 instead of desktop OpenGL\n"
    "  --explain                print the plan with times and bytes as JSON\n"
    "  --verbose                say which driver drew, by which path, and how long each step took\n"
    "  --version, --help\n"
    "\n"
    "Exit status: 0 done, 1 failed, 2 wrong usage. One line on stderr says what was wrong.\n"};

typedef enum fate { MAKE_TRANSPARENT, MAKE_OPAQUE, HIDE, JOIN } fate;

static const char *const FATES[] = {"--transparent", "--opaque", "--hide", "--group"};

/* What the command line says of each part. */
typedef struct wishes {
    unsigned char *transparent, *groups;
} wishes;

typedef struct selector {
    fate fate;
    char *names; /* separated by commas */
} selector;

typedef struct options {
    const char **models;
    int group_count;
    selector *selectors;
    size_t model_count, selector_count;
    const char *output;
    int up_axis; /* 0: as in the file */
    bool list, gles, svg;
    transfer_image *transfers[2]; /* opacity, shade */
    illustrate_job job;
} options;

/* ---- messages -------------------------------------------------------------------------------------------- */

static bool progress_shown;

static void clear_progress(void) {
    if (progress_shown)
        fputs("\r\033[K", stderr);
    progress_shown = false;
}

/* One line on stderr, whatever is in the names that it tells. */
static void say(const char *format, va_list arguments) {
    char text[1024];
    vsnprintf(text, sizeof text, format, arguments);
    for (char *c = text; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 127)
            *c = '?';
    clear_progress();
    fprintf(stderr, "illustrate: %s\n", text);
}

#if defined(__GNUC__)
#define PRINTF_LIKE __attribute__((format(printf, 1, 2)))
#else
#define PRINTF_LIKE
#endif

PRINTF_LIKE static void note(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    say(format, arguments);
    va_end(arguments);
}

PRINTF_LIKE static int failed(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    say(format, arguments);
    va_end(arguments);
    return FAILED;
}

PRINTF_LIKE static int misused(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    say(format, arguments);
    va_end(arguments);
    return USAGE;
}

static void show_progress(const char *what, double fraction, void *user) {
    (void)user;
    if (!isatty(STDERR_FILENO))
        return;
    if (fraction >= 0)
        fprintf(stderr, "\r\033[K%s %.0f %%", what, 100 * fraction);
    else
        fprintf(stderr, "\r\033[K%s", what);
    fflush(stderr);
    progress_shown = true;
}

static double seconds_now(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* ---- what is nearest to a name that is not known --------------------------------------------------------- */

enum { LONGEST_COMPARED = 128 };

/* How many letters to insert, drop or change; upper and lower case count as equal. */
static size_t edit_distance(const char *a, const char *b) {
    size_t row[LONGEST_COMPARED + 1], columns = strlen(b), rows = strlen(a);
    if (columns > LONGEST_COMPARED || rows > LONGEST_COMPARED)
        return SIZE_MAX;
    for (size_t j = 0; j <= columns; j++)
        row[j] = j;
    for (size_t i = 1; i <= rows; i++) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= columns; j++) {
            size_t change = diagonal + (strncasecmp(&a[i - 1], &b[j - 1], 1) != 0);
            size_t step = (row[j] < row[j - 1] ? row[j] : row[j - 1]) + 1;
            diagonal = row[j];
            row[j] = change < step ? change : step;
        }
    }
    return row[columns];
}

typedef struct suggestion {
    const char *path; /* of a part; the first `length` bytes are it or a group that it is in */
    size_t length, distance;
} suggestion;

/* The smaller of the distances to the path and to its last component. */
static size_t path_distance(const char *wanted, const char *path, size_t length) {
    char whole[LONGEST_COMPARED + 1];
    if (length > LONGEST_COMPARED)
        return SIZE_MAX;
    memcpy(whole, path, length);
    whole[length] = '\0';
    const char *slash = strrchr(whole, '/');
    size_t distance = edit_distance(wanted, whole), last = slash ? edit_distance(wanted, slash + 1) : distance;
    return last < distance ? last : distance;
}

enum { SUGGESTIONS = 3 };

static void suggest(suggestion *best, const char *wanted, const char *path, size_t length) {
    suggestion next = {path, length, path_distance(wanted, path, length)};
    for (size_t i = 0; i < SUGGESTIONS; i++)
        if (best[i].path && best[i].length == length && strncmp(best[i].path, path, length) == 0)
            return; /* a group that another part has named already */
    for (size_t i = 0; i < SUGGESTIONS; i++)
        if (!best[i].path || next.distance < best[i].distance) {
            suggestion pushed = best[i];
            best[i] = next;
            next = pushed;
            if (!next.path)
                return;
        }
}

/* The parts and groups whose names are nearest, in words. */
static void nearest_parts(const scene *s, const char *wanted, char *text, size_t size) {
    suggestion best[SUGGESTIONS] = {{NULL, 0, 0}};
    for (size_t i = 0; i < s->part_count; i++)
        for (size_t length = 1; length == 1 || s->parts[i].name[length - 1]; length++)
            if (s->parts[i].name[length] == '/' || s->parts[i].name[length] == '\0')
                suggest(best, wanted, s->parts[i].name, length);
    text[0] = '\0';
    for (size_t i = 0, length = 0; i < SUGGESTIONS && best[i].path && length < size; i++) {
        snprintf(text + length, size - length, "%s%.*s", i ? ", " : "", (int)best[i].length, best[i].path);
        length = strlen(text);
    }
}

/* ---- numbers and words ----------------------------------------------------------------------------------- */

/* The whole text has to be a number; blanks, hexadecimals, NaN and infinity are none here. */
static bool read_number(const char *text, size_t length, double low, double high, double *out) {
    char copy[64];
    if (length == 0 || length >= sizeof copy)
        return false;
    memcpy(copy, text, length);
    copy[length] = '\0';
    if (strspn(copy, "0123456789+-.eE") != length)
        return false;
    char *end;
    errno = 0;
    double value = strtod(copy, &end);
    if (*end != '\0' || errno == ERANGE || !(value >= low && value <= high))
        return false;
    *out = value;
    return true;
}

static bool read_whole(const char *text, size_t length, int low, int high, int *out) {
    double value;
    if (length == 0 || strspn(text, "0123456789") < length || !read_number(text, length, low, high, &value))
        return false;
    *out = (int)value;
    return true;
}

/* Two numbers with a comma between them. */
static bool read_pair(const char *text, const double low[2], const double high[2], double out[2]) {
    const char *comma = strchr(text, ',');
    return comma && read_number(text, (size_t)(comma - text), low[0], high[0], &out[0]) &&
           read_number(comma + 1, strlen(comma + 1), low[1], high[1], &out[1]);
}

/* The place of a word in a list that ends with NULL, -1 where it is not there. */
static int read_word(const char *text, size_t length, const char *const *words) {
    for (int i = 0; words[i]; i++)
        if (strlen(words[i]) == length && strncmp(words[i], text, length) == 0)
            return i;
    return -1;
}

static int read_choice(const char *option, const char *text, const char *const *words, int *chosen) {
    *chosen = read_word(text, strlen(text), words);
    if (*chosen >= 0)
        return DONE;
    char list[128] = "";
    for (size_t i = 0; words[i]; i++)
        snprintf(list + strlen(list), sizeof list - strlen(list), "%s%s",
                 !i             ? ""
                 : words[i + 1] ? ", "
                                : " and ",
                 words[i]);
    return misused("%s %s: not known; there are %s", option, text, list);
}

/* ---- options --------------------------------------------------------------------------------------------- */

static int set_style(options *o, const char *value) {
    static const char *const words[] = {"auto", "hodges", "lines", "opaque", "glass", "smart", "curvature", NULL};
    static const illustrate_style styles[] = {STYLE_AUTO,  STYLE_HODGES, STYLE_LINES,    STYLE_OPAQUE,
                                              STYLE_GLASS, STYLE_SMART,  STYLE_CURVATURE};
    int chosen;
    int result = read_choice("--style", value, words, &chosen);
    if (result == DONE)
        o->job.style = styles[chosen];
    return result;
}

static int set_size(options *o, const char *value) {
    const char *x = strchr(value, 'x');
    if (!x || !read_whole(value, (size_t)(x - value), 1, 16384, &o->job.width) ||
        !read_whole(x + 1, strlen(x + 1), 1, 16384, &o->job.height))
        return misused("--size %s: not WxH with whole numbers from 1 to 16384", value);
    return DONE;
}

static int set_view(options *o, const char *value) {
    static const double low[2] = {-36000, -90}, high[2] = {36000, 90};
    double angles[2];
    if (!read_pair(value, low, high, angles))
        return misused("--view %s: not AZIMUTH,ELEVATION in degrees, the latter from -90 to 90", value);
    o->job.azimuth = angles[0];
    o->job.elevation = angles[1];
    return DONE;
}

static int set_weights(options *o, const char *value) {
    static const double low[2] = {0, 0}, high[2] = {1, 1};
    double weights[2];
    if (!read_pair(value, low, high, weights))
        return misused("--weights %s: not OPAQUE,BACKGROUND with numbers from 0 to 1", value);
    o->job.opaque_weight = (float)weights[0];
    o->job.background_weight = (float)weights[1];
    return DONE;
}

/* A word of --lines: the first five say which lines, the next four how heavy. */
static int set_lines_word(options *o, const char *text, size_t length, bool kinds[5]) {
    static const char *const words[] = {"silhouettes", "boundaries", "creases",     "all",   "none",
                                        "thick-thin",  "outer",      "perspective", "light", "phantom",
                                        "smooth",      "hidden",     NULL};
    static const illustrate_weight weights[] = {WEIGHT_THICK_THIN, WEIGHT_OUTER, WEIGHT_PERSPECTIVE, WEIGHT_LIGHT};
    int word = read_word(text, length, words);
    if (word < 0)
        return misused("--lines %.*s: not known; there are silhouettes, boundaries, creases, all and none; thick-thin, "
                       "outer, perspective and light; phantom, smooth and hidden",
                       (int)length, text);
    if (word < 5) {
        kinds[word] = true;
        return DONE;
    }
    if (word < 9 && o->job.weight != WEIGHT_ONE && o->job.weight != weights[word - 5])
        return misused("--lines %.*s: another way to weigh lines was asked for before", (int)length, text);
    if (word < 9)
        o->job.weight = weights[word - 5];
    o->job.phantom = o->job.phantom || word == 9;
    o->job.smooth = o->job.smooth || word == 10;
    o->job.hidden = o->job.hidden || word == 11;
    return DONE;
}

static int set_lines(options *o, const char *value) {
    bool kinds[5] = {false};
    const char *colon = strchr(value, ':'), *end = colon ? colon : value + strlen(value);
    double width = (double)o->job.line_width;
    if (colon && !read_number(colon + 1, strlen(colon + 1), 0.1, 64, &width))
        return misused("--lines %s: the width is not a number of pixels from 0.1 to 64", value);
    for (const char *at = value;; at++) {
        size_t length = strcspn(at, ",:");
        int result = set_lines_word(o, at, length, kinds);
        if (result != DONE)
            return result;
        at += length;
        if (at >= end)
            break;
    }
    bool some = kinds[0] || kinds[1] || kinds[2] || kinds[3];
    if (kinds[4] && some)
        return misused("--lines %s: none and another kind", value);
    if (some || kinds[4]) {
        o->job.lines_asked = true;
        o->job.silhouettes = kinds[0] || kinds[3];
        o->job.boundaries = kinds[1] || kinds[3];
        o->job.creases = kinds[2] || kinds[3];
    }
    o->job.line_width = (float)width;
    return DONE;
}

static int set_shade(options *o, const char *value) {
    static const char *const words[] = {"cool-to-warm", "flat", NULL};
    int chosen, result = read_choice("--shade", value, words, &chosen);
    if (result == DONE)
        o->job.shade = chosen ? SHADE_FLAT : SHADE_COOL_TO_WARM;
    return result;
}

static int set_blend(options *o, const char *value) {
    static const char *const words[] = {"over", "normalised", "published", NULL};
    static const illustrate_blend blends[] = {BLEND_OVER, BLEND_NORMALISED, BLEND_PUBLISHED};
    int chosen, result = read_choice("--blend", value, words, &chosen);
    if (result == DONE)
        o->job.blending = blends[chosen];
    return result;
}

static int set_interior(options *o, const char *value) {
    static const char *const words[] = {"auto", "implicit", "explicit", "published", NULL};
    static const illustrate_interior interiors[] = {INTERIOR_AUTO, INTERIOR_IMPLICIT, INTERIOR_EXPLICIT,
                                                    INTERIOR_PUBLISHED};
    int chosen, result;
    if (strncmp(value, "layers:", 7) == 0) {
        o->job.interior = INTERIOR_LAYERS;
        if (read_whole(value + 7, strlen(value + 7), 1, 8, &o->job.layers))
            return DONE;
        return misused("--interior %s: not layers:N with a whole number from 1 to 8", value);
    }
    result = read_choice("--interior", value, words, &chosen);
    if (result == DONE)
        o->job.interior = interiors[chosen];
    return result;
}

static int set_group_distance(options *o, const char *value) {
    if (!read_number(value, strlen(value), 1e-30, 1e30, &o->job.group_distance))
        return misused("--group-distance %s: not a positive number", value);
    return DONE;
}

static int set_glass(options *o, const char *value) {
    static const char *const words[] = {"constant", "adaptive", NULL};
    size_t length = strcspn(value, ":");
    int law = read_word(value, length, words);
    double opacity = 0;
    if (law < 0 || (value[length] == ':' &&
                    (!read_number(value + length + 1, strlen(value + length + 1), 0, 1, &opacity) || opacity <= 0)))
        return misused("--glass %s: not constant or adaptive, and after a colon a number above 0 and up to 1", value);
    o->job.adaptive = law == 1;
    o->job.opacity = (float)opacity;
    return DONE;
}

static int set_law(options *o, const char *value) {
    static const char *const words[] = {"given", "constant", "adaptive", "angle", "variation", "distance", NULL};
    static const illustrate_law laws[] = {LAW_GIVEN, LAW_CONSTANT,  LAW_ADAPTIVE,
                                          LAW_ANGLE, LAW_VARIATION, LAW_DISTANCE};
    size_t length = strcspn(value, ":");
    int law = read_word(value, length, words);
    double opacity = 0;
    if (law < 0 || (value[length] == ':' &&
                    (!read_number(value + length + 1, strlen(value + length + 1), 0, 1, &opacity) || opacity <= 0)))
        return misused("--law %s: not given, constant, adaptive, angle, variation or distance, and after a colon a "
                       "number above 0 and up to 1",
                       value);
    o->job.law = laws[law];
    o->job.law_opacity = (float)opacity;
    return DONE;
}

static int set_iterations(options *o, const char *value) {
    if (!read_whole(value, strlen(value), 0, 500, &o->job.iterations))
        return misused("--iterations %s: not a whole number from 0 to 500", value);
    o->job.iterations = o->job.iterations > 0 ? o->job.iterations : -1;
    return DONE;
}

static int set_neighbours(options *o, const char *value) {
    static const char *const words[] = {"mutual", "murray", "one-sided", "carnecky", NULL};
    static const illustrate_neighbours all[] = {NEIGHBOURS_MUTUAL, NEIGHBOURS_MURRAY, NEIGHBOURS_ONE_SIDED,
                                                NEIGHBOURS_CARNECKY};
    int chosen, result = read_choice("--neighbours", value, words, &chosen);
    if (result == DONE)
        o->job.neighbours = all[chosen];
    return result;
}

static int set_halo(options *o, const char *value) {
    if (!read_number(value, strlen(value), 0, 500, &o->job.halo))
        return misused("--halo %s: not a number of pixels from 0 to 500", value);
    o->job.halo = o->job.halo > 0 ? o->job.halo : -1;
    return DONE;
}

static int set_transfer_file(options *o, const char *path) {
    char message[128];
    transfer_image *image = calloc(1, sizeof *image);
    if (!image)
        return failed("out of memory");
    if (!transfer_image_read(path, image, message, sizeof message)) {
        free(image);
        return failed("--transfer %s: %s", path, message);
    }
    free(o->transfers[image->is_shade]);
    o->transfers[image->is_shade] = image;
    o->job.shades = o->transfers[1] ? o->transfers[1]->shades : NULL;
    o->job.opacities = o->transfers[0] ? o->transfers[0]->opacities : NULL;
    return DONE;
}

static int set_transfer(options *o, const char *value) {
    static const char *const words[] = {"convex", "curved", "front", "deep", NULL};
    bool *const presets[] = {&o->job.shade_convex, &o->job.shade_curved, &o->job.opacity_front, &o->job.opacity_deep};
    size_t size = strlen(value);
    if (size > 4 && strcasecmp(value + size - 4, ".png") == 0)
        return set_transfer_file(o, value);
    for (const char *at = value;; at++) {
        size_t length = strcspn(at, ",");
        int word = read_word(at, length, words);
        if (word < 0)
            return misused("--transfer %.*s: not known; there are convex, curved, front, deep and a FILE.png",
                           (int)length, at);
        *presets[word] = true;
        *presets[word ^ 1] = false;
        at += length;
        if (!*at)
            return DONE;
    }
}

static int set_contours(options *o, const char *value) {
    static const char *const words[] = {"none", "suggestive", NULL};
    size_t length = strcspn(value, ":");
    int word = read_word(value, length, words);
    double least = -1;
    const char *number = value + length + (value[length] ? 1 : 0);
    if (word < 0 || (value[length] && (word == 0 || !read_number(number, strlen(number), 1e-6, 1e6, &least))))
        return misused("--contours %s: there are none, suggestive and suggestive:LEAST with 1e-6 to 1e6", value);
    o->job.contours = word ? least : 0;
    return DONE;
}

static int set_enter(options *o, const char *value) {
    double shade;
    if (!read_number(value, strlen(value), 0, 1, &shade))
        return misused("--enter %s: not a number from 0 to 1", value);
    o->job.enter = (float)shade;
    return DONE;
}

static int set_up(options *o, const char *value) {
    static const char *const words[] = {"y", "z", NULL};
    int chosen, result = read_choice("--up", value, words, &chosen);
    if (result == DONE)
        o->up_axis = chosen + 1;
    return result;
}

static int set_background(options *o, const char *value) {
    const char *digits = value[0] == '#' ? value + 1 : value;
    if (strcmp(value, "none") == 0) {
        o->job.background[3] = 0;
        return DONE;
    }
    if (strlen(digits) != 6 || strspn(digits, "0123456789abcdefABCDEF") != 6)
        return misused("--background %s: neither RRGGBB in hexadecimal digits nor none", value);
    unsigned long rgb = strtoul(digits, NULL, 16);
    for (unsigned i = 0; i < 3; i++)
        o->job.background[i] = (float)(rgb >> (16 - 8 * i) & 255) / 255;
    o->job.background[3] = 1;
    return DONE;
}

static int set_k(options *o, const char *value) {
    double k;
    if (!read_number(value, strlen(value), 0, 1000, &k))
        return misused("--k %s: not a number from 0 to 1000", value);
    o->job.k = (float)k;
    return DONE;
}

static int set_alpha_quality(options *o, const char *value) {
    if (!read_whole(value, strlen(value), 1, 4, &o->job.alpha_quality))
        return misused("--alpha-quality %s: not a whole number from 1 to 4", value);
    return DONE;
}

static int set_quality(options *o, const char *value) {
    if (!read_whole(value, strlen(value), 1, 8, &o->job.quality))
        return misused("--quality %s: not a whole number from 1 to 8", value);
    return DONE;
}

static int set_output(options *o, const char *value) {
    struct stat there;
    size_t length = strlen(value);
    bool special = stat(value, &there) == 0 && !S_ISREG(there.st_mode) && !S_ISDIR(there.st_mode);
    o->svg = length >= 5 && strcasecmp(value + length - 4, ".svg") == 0;
    if (!special && !o->svg && (length < 5 || strcasecmp(value + length - 4, ".png") != 0))
        return misused("-o %s: not a name that ends with .png or .svg, and these are what is written", value);
    o->output = value;
    return DONE;
}

static int add_selector(options *o, fate what, const char *value) {
    if (strspn(value, ",") == strlen(value))
        return misused("%s: names no part", FATES[what]);
    selector *more = realloc(o->selectors, (o->selector_count + 1) * sizeof *more);
    char *names = strdup(value);
    if (more)
        o->selectors = more;
    if (!more || !names) {
        free(names);
        return failed("out of memory");
    }
    more[o->selector_count++] = (selector){what, names};
    return DONE;
}

static int set_transparent(options *o, const char *value) {
    return add_selector(o, MAKE_TRANSPARENT, value);
}

static int set_opaque(options *o, const char *value) {
    return add_selector(o, MAKE_OPAQUE, value);
}

static int set_group(options *o, const char *value) {
    if (++o->group_count > 127)
        return misused("--group: more than 127 groups");
    return add_selector(o, JOIN, value);
}

static int set_hide(options *o, const char *value) {
    return add_selector(o, HIDE, value);
}

static int set_ortho(options *o, const char *value) {
    (void)value;
    o->job.ortho = true;
    return DONE;
}

static int set_list(options *o, const char *value) {
    (void)value;
    o->list = true;
    return DONE;
}

static int set_gles(options *o, const char *value) {
    (void)value;
    o->gles = true;
    return DONE;
}

static int set_explain(options *o, const char *value) {
    (void)value;
    o->job.explain = true;
    return DONE;
}

static int set_verbose(options *o, const char *value) {
    (void)value;
    o->job.verbose = true;
    return DONE;
}

typedef struct option {
    const char *name;
    bool has_value;
    int (*set)(options *, const char *);
} option;

static const option OPTIONS[] = {{"--output", true, set_output},
                                 {"--style", true, set_style},
                                 {"--size", true, set_size},
                                 {"--view", true, set_view},
                                 {"--ortho", false, set_ortho},
                                 {"--transparent", true, set_transparent},
                                 {"--opaque", true, set_opaque},
                                 {"--hide", true, set_hide},
                                 {"--list", false, set_list},
                                 {"--lines", true, set_lines},
                                 {"--shade", true, set_shade},
                                 {"--background", true, set_background},
                                 {"--k", true, set_k},
                                 {"--alpha-quality", true, set_alpha_quality},
                                 {"--blend", true, set_blend},
                                 {"--weights", true, set_weights},
                                 {"--interior", true, set_interior},
                                 {"--glass", true, set_glass},
                                 {"--law", true, set_law},
                                 {"--iterations", true, set_iterations},
                                 {"--neighbours", true, set_neighbours},
                                 {"--halo", true, set_halo},
                                 {"--transfer", true, set_transfer},
                                 {"--contours", true, set_contours},
                                 {"--group", true, set_group},
                                 {"--group-distance", true, set_group_distance},
                                 {"--enter", true, set_enter},
                                 {"--quality", true, set_quality},
                                 {"--up", true, set_up},
                                 {"--gles", false, set_gles},
                                 {"--explain", false, set_explain},
                                 {"--verbose", false, set_verbose}};
enum { OPTION_COUNT = sizeof OPTIONS / sizeof OPTIONS[0] };

static int unknown_option(const char *argument, size_t length) {
    char name[LONGEST_COMPARED];
    snprintf(name, sizeof name, "%.*s", (int)length, argument);
    size_t best = 4, nearest = OPTION_COUNT;
    for (size_t i = 0; i < OPTION_COUNT; i++) {
        size_t distance = edit_distance(name, OPTIONS[i].name);
        if (distance < best) {
            best = distance;
            nearest = i;
        }
    }
    if (nearest < OPTION_COUNT)
        return misused("%s: no such option; is it %s?", name, OPTIONS[nearest].name);
    return misused("%s: no such option; see illustrate --help", name);
}

/* One option, with its value from behind an = or from the next argument. */
static int take_option(options *o, int count, char **arguments, int *at) {
    const char *argument = arguments[*at];
    size_t length = strcspn(argument, "=");
    if (strcmp(argument, "-o") == 0)
        argument = "--output", length = strlen(argument);
    for (size_t i = 0; i < OPTION_COUNT; i++) {
        if (strlen(OPTIONS[i].name) != length || strncmp(OPTIONS[i].name, argument, length) != 0)
            continue;
        const char *value = argument[length] == '=' ? argument + length + 1 : NULL;
        if (value && !OPTIONS[i].has_value)
            return misused("%s: takes no value", OPTIONS[i].name);
        if (!value && OPTIONS[i].has_value && ++*at >= count)
            return misused("%s: a value is missing after it", arguments[count - 1]);
        return OPTIONS[i].set(o, value ? value : OPTIONS[i].has_value ? arguments[*at] : "");
    }
    return unknown_option(argument, length);
}

static int check_options(const options *o) {
    if (o->model_count == 0)
        return misused("no model is given; see illustrate --help");
    if (!o->output && !o->list)
        return misused("no -o OUT.png is given");
    if (o->job.law == LAW_DISTANCE && o->job.iterations < 0)
        return misused("--iterations 0: there are no silhouettes for --law distance");
    bool varies = o->job.weight == WEIGHT_PERSPECTIVE || o->job.weight == WEIGHT_LIGHT;
    if (o->svg && (varies || o->job.explain || (o->job.style != STYLE_AUTO && o->job.style != STYLE_LINES)))
        return misused(
            "-o %s: an SVG has lines alone, each of one width: no --style but lines, no --lines perspective or "
            "light, no --explain",
            o->output);
    return DONE;
}

static void set_defaults(options *o) {
    illustrate_job *job = &o->job;
    job->width = 1024;
    job->height = 768;
    job->azimuth = 30;
    job->elevation = 20;
    job->quality = 3;
    job->silhouettes = job->boundaries = job->creases = true;
    job->line_width = 1.5f;
    job->background[0] = job->background[1] = job->background[2] = job->background[3] = 1;
    job->opaque_weight = job->background_weight = job->k = -1;
}

static int parse(options *o, int count, char **arguments) {
    bool only_models = false;
    int result = DONE;
    set_defaults(o);
    o->models = calloc((size_t)count + 1, sizeof *o->models);
    if (!o->models)
        return failed("out of memory");
    for (int i = 1; i < count && result == DONE; i++) {
        if (!only_models && strcmp(arguments[i], "--") == 0)
            only_models = true;
        else if (!only_models && arguments[i][0] == '-')
            result = take_option(o, count, arguments, &i);
        else
            o->models[o->model_count++] = arguments[i];
    }
    return result == DONE ? check_options(o) : result;
}

/* ---- models ---------------------------------------------------------------------------------------------- */

static scene *make_built_in(const char *name, int *result) {
    scene *s = models_make(name);
    if (s)
        return s;
    size_t best = SIZE_MAX, nearest = 0, known = 0;
    for (size_t i = 0; models_names[i]; i++) {
        size_t distance = edit_distance(name, models_names[i]);
        known |= distance == 0;
        if (distance < best) {
            best = distance;
            nearest = i;
        }
    }
    *result = known ? failed("model:%s: out of memory", name)
                    : misused("model:%s: no such model; is it model:%s?", name, models_names[nearest]);
    return NULL;
}

static void tell_report(const char *path, const load_report *report, bool verbose) {
    if (report->faces_dropped > 0)
        note("%s: %zu triangles with NaN or infinite coordinates left out", path, report->faces_dropped);
    if (report->parts_dropped > 0)
        note("%s: %zu parts with a transform that is not finite left out", path, report->parts_dropped);
    if (verbose && report->others_dropped > 0)
        note("%s: %zu points and lines left out", path, report->others_dropped);
    if (verbose && report->textures_missed > 0)
        note("%s: a base colour texture was not found or cannot be read; the material's colour stands for it", path);
}

static scene *load_file(const options *o, const char *path, int *result) {
    char message[256];
    load_report report;
    double start = seconds_now();
    show_progress("loading", -1, NULL);
    scene *s = load_model(path, &report, message, sizeof message);
    clear_progress();
    if (!s) {
        *result = failed("%s: %s", path, message);
        return NULL;
    }
    tell_report(path, &report, o->job.verbose);
    if (o->up_axis)
        s->up_axis = o->up_axis;
    if (o->job.verbose)
        note("%s: %zu parts, %zu meshes, %c up, %.3f s", path, s->part_count, s->mesh_count,
             s->up_axis == 1 ? 'y' : 'z', seconds_now() - start);
    return s;
}

/* The name in front of a file's parts where there are several models. */
static void stem_of(const char *path, char *stem, size_t size) {
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');
    snprintf(stem, size, "%.*s", dot && dot > name ? (int)(dot - name) : (int)strlen(name), name);
    for (char *c = stem; *c; c++)
        if (*c == ',' || (unsigned char)*c < ' ')
            *c = '_';
}

static scene *load_models(const options *o, int *result) {
    scene *all = NULL;
    for (size_t i = 0; i < o->model_count && *result == DONE; i++) {
        bool built_in = strncmp(o->models[i], "model:", 6) == 0;
        scene *s = built_in ? make_built_in(o->models[i] + 6, result) : load_file(o, o->models[i], result);
        char stem[256];
        stem_of(o->models[i], stem, sizeof stem);
        if (!s)
            break;
        if (!all) {
            all = scene_create();
            if (all)
                all->up_axis = s->up_axis;
        }
        if (!all || !scene_merge(all, s, built_in || o->model_count == 1 ? NULL : stem))
            *result = failed("out of memory");
    }
    if (*result == DONE && !scene_center_meshes(all))
        *result = failed("out of memory");
    if (*result == DONE)
        return all;
    scene_destroy(all);
    return NULL;
}

/* ---- parts ----------------------------------------------------------------------------------------------- */

/* Whether a name means the path up to `length`: the whole of it, its last component, or a pattern for either. */
static bool means(const char *name, const char *path, size_t length) {
    char prefix[1024];
    if (length >= sizeof prefix)
        return false;
    memcpy(prefix, path, length);
    prefix[length] = '\0';
    const char *slash = strrchr(prefix, '/'), *last = slash ? slash + 1 : prefix;
    return strcmp(name, prefix) == 0 || strcmp(name, last) == 0 || fnmatch(name, prefix, 0) == 0 ||
           fnmatch(name, last, 0) == 0;
}

/* A part is meant by its own name or by that of a group that it is in. */
static bool selects(const char *name, const char *path) {
    for (size_t length = 1;; length++)
        if (path[length] == '/' || path[length] == '\0') {
            if (means(name, path, length))
                return true;
            if (path[length] == '\0')
                return false;
        }
}

static void choose(scene *s, const wishes *w, size_t part, fate what, int group) {
    if (what == HIDE)
        s->parts[part].hidden = true;
    else if (what == JOIN)
        w->groups[part] = (unsigned char)group;
    else
        w->transparent[part] = what == MAKE_TRANSPARENT ? PART_TRANSPARENT : PART_OPAQUE;
}

static int apply_name(scene *s, const wishes *w, const char *name, fate what, int group) {
    size_t found = 0;
    size_t exact = scene_find_part(s, name); /* even with a * or ? in its name */
    for (size_t i = 0; i < s->part_count; i++)
        if (exact == SIZE_MAX ? selects(name, s->parts[i].name) : i == exact) {
            choose(s, w, i, what, group);
            found++;
        }
    if (found > 0)
        return DONE;
    char nearest[600];
    nearest_parts(s, name, nearest, sizeof nearest);
    return misused("%s %s: no such part; nearest: %s", FATES[what], name, nearest);
}

static int apply_selectors(const options *o, scene *s, const wishes *w) {
    int result = DONE, group = 0;
    for (size_t i = 0; i < o->selector_count && result == DONE; i++) {
        char *rest = NULL;
        group += o->selectors[i].fate == JOIN;
        for (char *name = strtok_r(o->selectors[i].names, ",", &rest); name && result == DONE;
             name = strtok_r(NULL, ",", &rest))
            result = apply_name(s, w, name, o->selectors[i].fate, group);
    }
    double low[3], high[3];
    if (result == DONE && !o->list && !scene_bounds(s, low, high))
        result = misused("all parts are hidden, so there is nothing to draw");
    return result;
}

static int finish_stdout(void) {
    if (fflush(stdout) != 0 || ferror(stdout))
        return failed("standard output: %s", strerror(errno));
    return DONE;
}

/* "shared" counts the parts that have the mesh in common. */
static int list_parts(const scene *s) {
    size_t *uses = calloc(s->mesh_count + 1, sizeof *uses);
    bool *closed = calloc(s->mesh_count + 1, sizeof *closed);
    size_t triangles = 0;
    if (!uses || !closed) {
        free(uses);
        free(closed);
        return failed("out of memory");
    }
    for (size_t i = 0; i < s->part_count; i++)
        uses[s->parts[i].mesh]++;
    for (size_t i = 0; i < s->mesh_count; i++)
        closed[i] = uses[i] > 0 && scene_mesh_closed(&s->meshes[i], NULL);
    printf("%10s  %6s  %-7s  %s\n", "triangles", "shared", "surface", "part");
    for (size_t i = 0; i < s->part_count; i++) {
        const scene_part *part = &s->parts[i];
        size_t count = s->meshes[part->mesh].index_count / 3;
        triangles += count;
        printf("%10zu  %6zu  %-7s  %s%s\n", count, uses[part->mesh], closed[part->mesh] ? "closed" : "open", part->name,
               part->hidden ? "  (hidden)" : "");
    }
    printf("%10zu  %zu parts, %zu meshes, %c up\n", triangles, s->part_count, s->mesh_count,
           s->up_axis == 1 ? 'y' : 'z');
    free(uses);
    free(closed);
    return finish_stdout();
}

/* ---- drawing --------------------------------------------------------------------------------------------- */

static int finish_picture(const options *o, const illustrate_result *drawn) {
    char message[256];
    if (!write_png(o->output, drawn->rgba, o->job.width, o->job.height, message, sizeof message))
        return failed("%s: %s", o->output, message);
    if (!o->job.explain || !drawn->explain_json)
        return DONE;
    fputs(drawn->explain_json, stdout);
    if (drawn->explain_json[0] && drawn->explain_json[strlen(drawn->explain_json) - 1] != '\n')
        putchar('\n');
    return finish_stdout();
}

static int draw_svg(const options *o, const scene *s, const wishes *w) {
    illustrate_job job = o->job;
    illustrate_result drawn = {0};
    char message[256];
    size_t length = 0;
    job.scene = s;
    job.transparent = w->transparent;
    char *text = illustrate_svg(&job, &length, &drawn);
    if (!text)
        return failed("%s: %s", o->models[0], drawn.message);
    bool ok = write_file(o->output, (const unsigned char *)text, length, message, sizeof message);
    free(text);
    return ok ? DONE : failed("%s: %s", o->output, message);
}

static int draw(const options *o, const scene *s, const wishes *w) {
    headless context;
    char message[512];
    double start = seconds_now();
    if (!headless_create(&context, 0, 0, o->gles, message, sizeof message))
        return failed("no OpenGL%s context: %s", o->gles ? " ES" : "", message);
    if (o->job.verbose)
        note("%s, %s (%s, by the %s platform), %.3f s", context.renderer, context.version, context.vendor,
             context.platform, seconds_now() - start);
    illustrate_job job = o->job;
    illustrate_result drawn = {0};
    job.scene = s;
    job.transparent = w->transparent;
    job.groups = w->groups;
    job.progress = show_progress;
    start = seconds_now();
    bool ok = illustrate_render(&job, headless_get_proc, &drawn);
    clear_progress();
    double drawing = seconds_now() - start;
    headless_destroy(&context);
    if (!ok)
        return failed("%s: %s", o->models[0], drawn.message);
    start = seconds_now();
    int result = finish_picture(o, &drawn);
    if (result == DONE && o->job.verbose)
        note("%s: %dx%d, drawn in %.3f s, written in %.3f s", o->output, job.width, job.height, drawing,
             seconds_now() - start);
    free(drawn.rgba);
    free(drawn.explain_json);
    return result;
}

static int run(const options *o) {
    char message[256];
    int result = DONE;
    if (o->output && !write_png_possible(o->output, message, sizeof message))
        return failed("%s: %s", o->output, message);
    scene *s = load_models(o, &result);
    size_t parts = s ? s->part_count + 1 : 1;
    wishes w = {calloc(parts, 1), calloc(parts, 1)};
    if (s && (!w.transparent || !w.groups))
        result = failed("out of memory");
    if (result == DONE)
        result = apply_selectors(o, s, &w);
    if (result == DONE && o->list)
        result = list_parts(s);
    if (result == DONE && o->output)
        result = o->svg ? draw_svg(o, s, &w) : draw(o, s, &w);
    free(w.transparent);
    free(w.groups);
    scene_destroy(s);
    return result;
}

/* --help and --version count wherever they stand, except behind -- or as another option's value. */
static bool asks_for(int count, char **arguments, const char *wanted) {
    for (int i = 1; i < count && strcmp(arguments[i], "--") != 0; i++)
        if (strcmp(arguments[i], wanted) == 0)
            return true;
    return false;
}

int main(int count, char **arguments) {
    options o = {0};
    if (asks_for(count, arguments, "--help") || asks_for(count, arguments, "-h")) {
        for (size_t i = 0; i < sizeof HELP / sizeof HELP[0]; ++i)
            fputs(HELP[i], stdout);
        return finish_stdout();
    }
    if (asks_for(count, arguments, "--version")) {
        printf("illustrate %s\n", ILLUSTRATE_VERSION);
        return finish_stdout();
    }
    int result = parse(&o, count, arguments);
    if (result == DONE)
        result = run(&o);
    for (size_t i = 0; i < o.selector_count; i++)
        free(o.selectors[i].names);
    free(o.transfers[0]);
    free(o.transfers[1]);
    free(o.models);
    return result;
}

/* rts: a battlefield whose units are never lost behind a tree, by dynamic transparency. Without a window into PNG files, or
 * in one. `rts --help` says how. */
#define _POSIX_C_SOURCE 200809L

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define GLAD_GL_IMPLEMENTATION
#define GLAD_GLES2_IMPLEMENTATION
#include <glad/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "battlefield.h"
#include "battlefield_gl.h"
#include "battlefield_see.h"
#include "headless.h"
#include "kaykit.h"
#include "write_png.h"

#define TRANSPARENCY_IMPLEMENTATION
#include "transparency.h"

enum { DONE = 0, FAILED = 1, USAGE = 2 };

/* In pieces, since C99 promises no more than 4,095 bytes for one. */
static const char *const HELP[] = {
    "rts [OPTION...]: a battlefield in a window; rts -o OUT.png: without one.\n"
    "\n"
    "  -o, --output OUT.png     where the picture goes; written whole or not at all\n"
    "  --frames N               N pictures, OUT_0001.png and so on, one 25th of a second apart\n"
    "  --turn DEGREES           how far the eye goes around from the first of them to the last\n"
    "  --scene SCENE            battlefield (default), abstract, walkthrough\n"
    "  --kaykit DIR             trees and houses of the KayKit medieval models in that folder; battlefield only\n"
    "  --size WxH               pixels, 1x1 to 8192x8192; default 1280x800\n"
    "  --quality N              samples per pixel along each axis, 1 to 4; default 2, in windows 1\n"
    "  --time SECONDS           where units are; default 3\n"
    "  --eye X,Y,Z  --at X,Y,Z  where to stand and where to look, metres, z up\n"
    "  --flat                   no shadows, no haze\n"
    "\n"
    "Units are never lost behind things:\n"
    "  --method METHOD          one-mask (default), dither, exact, sequence, published, off; docs/dynamic.md tells\n"
    "                           what each costs and how exact it is\n"
    "  --shape SHAPE            of masks: outline (default), circle, ellipse, hull\n"
    "  --combine HOW            where masks overlap: min (default), product\n"
    "  --occluders HOW          together (default): however many, a unit keeps its weight; each: the paper's\n"
    "  --alpha-target A         opacity left before a unit, 0 to 1; default 0.3\n"
    "  --alpha-start A          and beside it; default 0.1\n"
    "  --mask-width PIXELS      over which it rises to 1, 0 to 25; default 12\n"
    "  --mask-divisor N         pixels a mask texel: 1, 2, 4 or 8; default 4, of sequences 2, of exact 1\n"
    "  --layers N               only the N layers nearest to the eye yield; default 0: all\n"
    "  --active                 units are seen inside the search light only; in the window it follows the mouse\n"
    "  --light X,Y,RADIUS,EDGE  the light, in pixels from the lower left corner; default 0.3 of the height, in the middle\n"
    "  --fade SHARE             how far masks have faded out, 0 to 1\n"
    "\n"
    "  --gles                   OpenGL ES 3 instead of desktop OpenGL; not in windows\n"
    "  --explain                print what was drawn by which passes, and how long it took, as JSON\n"
    "  --help\n"
    "\n"
    "In the window: drag to go around, wheel to come nearer; 1 to 6 choose the method, M the shape of masks, C and O how\n"
    "they combine and whom they count, A the search light, F fades masks in and out, space stops time, Esc ends.\n"
    "\n"
    "Exit status: 0 done, 1 failed, 2 wrong usage. One line on stderr says what was wrong.\n"};

typedef enum scene_kind { SCENE_BATTLEFIELD, SCENE_ABSTRACT, SCENE_WALKTHROUGH } scene_kind;

typedef struct options {
    const char *output, *kaykit;
    int scene, width, height, quality, frames;
    int method, shape, combine, occluders, mask_divisor, layers;
    double time, turn, eye[3], at[3], alpha_target, alpha_start, mask_width, light[4], fade;
    bool eye_given, at_given, flat, gles, explain, active;
} options;

/* ---- messages and words ---------------------------------------------------------------------------------- */

#if defined(__GNUC__)
#define PRINTF_LIKE(n) __attribute__((format(printf, n, n + 1)))
#else
#define PRINTF_LIKE(n)
#endif

PRINTF_LIKE(2) static int complain(int status, const char *format, ...) {
    va_list arguments;
    fputs("rts: ", stderr);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return status;
}

static double seconds_now(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* `count` numbers with `separator` between them, each within its limits. */
static bool read_numbers(const char *text, char separator, int count, double low, double high, double *out) {
    for (int i = 0; i < count; i++) {
        char *end;
        if (strspn(text, "0123456789+-.eE") == 0)
            return false;
        errno = 0;
        out[i] = strtod(text, &end);
        if (end == text || errno == ERANGE || !(out[i] >= low && out[i] <= high) ||
            *end != (i + 1 < count ? separator : '\0'))
            return false;
        text = end + 1;
    }
    return true;
}

static bool read_whole(const char *text, int low, int high, int *out) {
    double value;
    if (!read_numbers(text, ',', 1, low, high, &value) || value != floor(value))
        return false;
    *out = (int)value;
    return true;
}

/* ---- options --------------------------------------------------------------------------------------------- */

typedef enum option_kind {
    OPTION_FLAG,
    OPTION_WHOLE,
    OPTION_NUMBER,
    OPTION_NUMBERS,
    OPTION_WORD,
    OPTION_TEXT
} option_kind;

/* What an option reads and where it goes in the struct of options. */
typedef struct option {
    const char *name;
    option_kind kind;
    size_t at;
    double low, high;
    const char
        *words; /* of OPTION_WORD, with blanks between: the enumerators in their order; of OPTION_NUMBERS: names */
} option;

/* The enumerators of tr_see and of tr_mask_shape. */
#define METHODS "one-mask dither exact sequence published off"
#define SHAPES "outline circle ellipse hull"

#define PLACE(member) offsetof(options, member)
static const option OPTIONS[] = {
    {"--output", OPTION_TEXT, PLACE(output), 0, 0, NULL},
    {"-o", OPTION_TEXT, PLACE(output), 0, 0, NULL},
    {"--kaykit", OPTION_TEXT, PLACE(kaykit), 0, 0, NULL},
    {"--scene", OPTION_WORD, PLACE(scene), 0, 0, "battlefield abstract walkthrough"},
    {"--frames", OPTION_WHOLE, PLACE(frames), 1, 100000, NULL},
    {"--turn", OPTION_NUMBER, PLACE(turn), -36000, 36000, NULL},
    {"--quality", OPTION_WHOLE, PLACE(quality), 1, 4, NULL},
    {"--time", OPTION_NUMBER, PLACE(time), 0, 1e6, NULL},
    {"--eye", OPTION_NUMBERS, PLACE(eye), -1e4, 1e4, "X,Y,Z"},
    {"--at", OPTION_NUMBERS, PLACE(at), -1e4, 1e4, "X,Y,Z"},
    {"--method", OPTION_WORD, PLACE(method), 0, 0, METHODS},
    {"--shape", OPTION_WORD, PLACE(shape), 0, 0, SHAPES},
    {"--combine", OPTION_WORD, PLACE(combine), 0, 0, "min product"},
    {"--occluders", OPTION_WORD, PLACE(occluders), 0, 0, "together each"},
    {"--alpha-target", OPTION_NUMBER, PLACE(alpha_target), 0, 1, NULL},
    {"--alpha-start", OPTION_NUMBER, PLACE(alpha_start), 0, 1, NULL},
    {"--mask-width", OPTION_NUMBER, PLACE(mask_width), 0, 25, NULL},
    {"--mask-divisor", OPTION_WHOLE, PLACE(mask_divisor), 1, 8, NULL},
    {"--layers", OPTION_WHOLE, PLACE(layers), 0, 64, NULL},
    {"--light", OPTION_NUMBERS, PLACE(light), -1e5, 1e5, "X,Y,RADIUS,EDGE"},
    {"--fade", OPTION_NUMBER, PLACE(fade), 0, 1, NULL},
    {"--active", OPTION_FLAG, PLACE(active), 0, 0, NULL},
    {"--flat", OPTION_FLAG, PLACE(flat), 0, 0, NULL},
    {"--gles", OPTION_FLAG, PLACE(gles), 0, 0, NULL},
    {"--explain", OPTION_FLAG, PLACE(explain), 0, 0, NULL},
};

static int word_index(const char *words, const char *word) {
    size_t length = strlen(word);
    int index = 0;
    for (const char *at = words; *at; index++) {
        size_t own = strcspn(at, " ");
        if (own == length && strncmp(at, word, own) == 0)
            return index;
        at += own + (at[own] == ' ');
    }
    return -1;
}

/* Until the next call. */
static const char *nth_word(const char *words, int n) {
    static char word[32];
    for (; n > 0 && *words; n--)
        words += strcspn(words, " ") + (words[strcspn(words, " ")] == ' ');
    snprintf(word, sizeof word, "%.*s", (int)strcspn(words, " "), words);
    return word;
}

static int set_option(options *o, const option *which, const char *value) {
    void *place = (char *)o + which->at;
    int word, count = 1;
    switch (which->kind) {
    case OPTION_FLAG:
        *(bool *)place = true;
        return DONE;
    case OPTION_TEXT:
        *(const char **)place = value;
        return DONE;
    case OPTION_WORD:
        word = word_index(which->words, value);
        if (word < 0)
            return complain(USAGE, "%s %s: not known; there are %s", which->name, value, which->words);
        *(int *)place = word;
        return DONE;
    case OPTION_WHOLE:
        if (!read_whole(value, (int)which->low, (int)which->high, place))
            return complain(USAGE, "%s %s: not a whole number from %g to %g", which->name, value, which->low,
                            which->high);
        return DONE;
    case OPTION_NUMBER:
        if (!read_numbers(value, ',', 1, which->low, which->high, place))
            return complain(USAGE, "%s %s: not a number from %g to %g", which->name, value, which->low, which->high);
        return DONE;
    case OPTION_NUMBERS:
        for (const char *comma = which->words; (comma = strchr(comma, ',')) != NULL; comma++)
            count++;
        if (!read_numbers(value, ',', count, which->low, which->high, place))
            return complain(USAGE, "%s %s: not %s, each from %g to %g", which->name, value, which->words, which->low,
                            which->high);
        return DONE;
    }
    return FAILED;
}

static int read_size(options *o, const char *value) {
    double size[2];
    if (!read_numbers(value, 'x', 2, 1, 8192, size) || size[0] != floor(size[0]) || size[1] != floor(size[1]))
        return complain(USAGE, "--size %s: not WxH with whole numbers from 1 to 8192", value);
    o->width = (int)size[0];
    o->height = (int)size[1];
    return DONE;
}

static int read_option(options *o, char **arguments, int left, int *used) {
    const char *name = arguments[0], *value = left > 1 ? arguments[1] : NULL;
    *used = 2;
    if (strcmp(name, "--size") == 0 && value)
        return read_size(o, value);
    for (size_t i = 0; i < sizeof OPTIONS / sizeof OPTIONS[0]; i++)
        if (strcmp(name, OPTIONS[i].name) == 0) {
            *used = OPTIONS[i].kind == OPTION_FLAG ? 1 : 2;
            o->eye_given = o->eye_given || OPTIONS[i].at == PLACE(eye);
            o->at_given = o->at_given || OPTIONS[i].at == PLACE(at);
            if (OPTIONS[i].kind != OPTION_FLAG && !value)
                return complain(USAGE, "%s: a value is missing", name);
            return set_option(o, &OPTIONS[i], value);
        }
    if (strcmp(name, "--size") == 0)
        return complain(USAGE, "--size: a value is missing");
    return complain(USAGE, "%s: not known; --help tells what is", name);
}

static int read_options(options *o, int argc, char **argv) {
    o->width = 1280;
    o->height = 800;
    o->time = 3;
    o->alpha_target = 0.3;
    o->alpha_start = 0.1;
    o->mask_width = 12;
    for (int i = 1, used; i < argc; i += used) {
        int result = read_option(o, argv + i, argc - i, &used);
        if (result != DONE)
            return result;
    }
    if (o->kaykit && o->scene != SCENE_BATTLEFIELD)
        return complain(USAGE, "--kaykit is for the battlefield");
    if ((o->frames || o->gles) && !o->output)
        return complain(USAGE, "%s is for pictures: name one by -o", o->frames ? "--frames" : "--gles");
    if (o->mask_divisor & (o->mask_divisor - 1))
        return complain(USAGE, "--mask-divisor %d: not 1, 2, 4 or 8", o->mask_divisor);
    o->quality = o->quality ? o->quality : o->output ? 2 : 1;
    return DONE;
}

/* ---- the stage ------------------------------------------------------------------------------------------- */

enum { SHADOW_SIZE = 4096 };

typedef struct stage {
    options *o;
    battlefield *field;
    battlefield_gl gl;
    battlefield_look look;
    battlefield_see see;
    tr_context *tr;
    uint32_t shadow_program;
    uint32_t framebuffer, color, depth;
    int width, height; /* of the target: samples */
    double eye[3], at[3], fov, nearest, farthest;
    bool outdoors; /* the sun casts shadows, and there is haze */
    uint32_t frame;
    char said[256];      /* by the header, of what went wrong */
    float *wanted;       /* how far each unit's mask is to fade */
    double milliseconds; /* of the last frame, until it was there */
} stage;

static int make_field(stage *s) {
    static const double near_eye[3] = {40, -60, 24}, near_at[3] = {0, 0, 1};
    char message[256];
    s->field = s->o->scene == SCENE_ABSTRACT      ? battlefield_create_abstract(0)
               : s->o->scene == SCENE_WALKTHROUGH ? battlefield_create_walkthrough(0)
                                                  : battlefield_create(NULL);
    if (!s->field)
        return complain(FAILED, "out of memory");
    if (s->o->kaykit && !kaykit_replace(s->field, s->o->kaykit, message, sizeof message))
        return complain(FAILED, "%s: %s", s->o->kaykit, message);
    memcpy(s->eye, s->field->eye, sizeof s->eye);
    memcpy(s->at, s->field->look_at, sizeof s->at);
    s->fov = s->o->scene == SCENE_ABSTRACT ? 30 : s->o->scene == SCENE_WALKTHROUGH ? 65 : 48;
    s->nearest = s->o->scene == SCENE_WALKTHROUGH ? 0.1 : 1;
    s->farthest = s->o->scene == SCENE_WALKTHROUGH ? 120 : 600;
    if (s->o->scene == SCENE_BATTLEFIELD) {
        memcpy(s->eye, near_eye, sizeof s->eye);
        memcpy(s->at, near_at, sizeof s->at);
    }
    if (s->o->eye_given)
        memcpy(s->eye, s->o->eye, sizeof s->eye);
    if (s->o->at_given)
        memcpy(s->at, s->o->at, sizeof s->at);
    for (size_t i = 0; i < s->field->scene->part_count; i++) /* walkers see the ceiling */
        s->field->scene->parts[i].hidden = s->field->scene->parts[i].hidden && s->o->scene != SCENE_WALKTHROUGH;
    return DONE;
}

/* Kept for the one line that is printed when something fails. */
static void log_line(tr_log_level level, tr_result code, const char *text, void *user) {
    stage *s = user;
    (void)code;
    if (level != TR_LOG_INFO)
        snprintf(s->said, sizeof s->said, "%s", text);
}

static int make_programs(stage *s, void (*(*get_proc)(const char *))(void)) {
    char message[1024] = "";
    tr_desc desc = {0};
    tr_result result;
    desc.get_proc = get_proc;
    desc.log_fn = log_line;
    desc.log_user = s;
    desc.first_texture_unit = 1; /* the shadow has unit 0 */
    s->tr = tr_create(&desc, &result);
    if (!s->tr)
        return complain(FAILED, "%s", tr_result_string(result));
    if (!battlefield_see_create(&s->see, s->tr, &s->gl, s->o->gles, s->outdoors ? "#define SHADOWS\n" : ""))
        return complain(FAILED, "out of memory");
    s->wanted = calloc(s->gl.part_count + 1, sizeof *s->wanted);
    if (!s->wanted)
        return complain(FAILED, "out of memory");
    for (size_t i = 0; i < s->see.unit_count; i++)
        s->see.units[i].fade = (float)s->o->fade;
    s->shadow_program = battlefield_gl_program(NULL, s->o->gles, "", message, sizeof message);
    if (!s->shadow_program)
        return complain(FAILED, "a shader cannot be built: %s", message);
    return DONE;
}

static void drop_target(stage *s) {
    glDeleteFramebuffers(1, &s->framebuffer);
    glDeleteRenderbuffers(1, &s->color);
    glDeleteRenderbuffers(1, &s->depth);
}

static int make_target(stage *s, int width, int height) {
    drop_target(s);
    s->width = width * s->o->quality;
    s->height = height * s->o->quality;
    glGenRenderbuffers(1, &s->color);
    glBindRenderbuffer(GL_RENDERBUFFER, s->color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, s->width, s->height);
    glGenRenderbuffers(1, &s->depth);
    glBindRenderbuffer(GL_RENDERBUFFER, s->depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, s->width, s->height);
    glGenFramebuffers(1, &s->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, s->framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, s->color);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, s->depth);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return complain(FAILED, "the driver has no target of %d x %d", s->width, s->height);
    return DONE;
}

static int open_stage(stage *s, options *o, void (*(*get_proc)(const char *))(void), int width, int height) {
    static const float cool[4] = {0.0f, 0.03f, 0.13f, 0.48f}, warm[4] = {0.14f, 0.10f, 0.0f, 0.92f};
    s->o = o;
    battlefield_default_look(&s->look);
    memcpy(s->look.cool, cool, sizeof cool);
    memcpy(s->look.warm, warm, sizeof warm);
    s->outdoors = o->scene == SCENE_BATTLEFIELD && !o->flat;
    s->look.haze = s->outdoors ? 0.0016f : 0;
    int result = make_field(s);
    if (result == DONE && !battlefield_gl_create(&s->gl, s->field, false))
        result = complain(FAILED, "out of memory");
    if (result == DONE)
        result = make_programs(s, get_proc);
    if (result == DONE)
        result = make_target(s, width, height);
    return result;
}

static void close_stage(stage *s) {
    drop_target(s);
    glDeleteTextures(1, &s->look.shadow);
    glDeleteProgram(s->shadow_program);
    battlefield_see_destroy(&s->see);
    tr_destroy(s->tr);
    free(s->wanted);
    battlefield_gl_destroy(&s->gl);
    battlefield_destroy(s->field);
}

/* ---- a frame --------------------------------------------------------------------------------------------- */

/* Zero is a wish here, and the default there. */
static float wished(double value) {
    return value > 0 ? (float)value : -1.0f;
}

static tr_dynamic wish_of(const stage *s, tr_light *light) {
    const options *o = s->o;
    float scale = (float)o->quality, height = (float)s->height / scale, width = (float)s->width / scale;
    tr_dynamic wish = {0};
    bool given = o->light[2] > 0;
    light->x = scale * (given ? (float)o->light[0] : 0.5f * width);
    light->y = scale * (given ? (float)o->light[1] : 0.5f * height);
    light->radius = scale * (given ? (float)o->light[2] : 0.2f * height);
    light->edge = scale * (given ? (float)o->light[3] : 0.1f * height);
    wish.see = (tr_see)o->method;
    wish.shape = (tr_mask_shape)o->shape;
    wish.combine = (tr_mask_combine)o->combine;
    wish.occluders = (tr_occluders)o->occluders;
    wish.alpha_target = wished(o->alpha_target);
    wish.alpha_start = wished(o->alpha_start);
    wish.width = wished(o->mask_width * o->quality);
    wish.mask_divisor = o->mask_divisor;
    wish.in_parts = 1; /* cleared before, and passes draw what they ask for */
    wish.layers = o->layers;
    wish.lights = light;
    wish.light_count = o->active;
    wish.frame_index = s->frame;
    memcpy(wish.background, s->look.background, sizeof wish.background);
    return wish;
}

/* In a window keys choose one thing after the other: what a method cannot do waits until there is one that can. */
static void take_what_can_be(tr_dynamic *wish) {
    if (wish->see == TR_SEE_ONE_MASK)
        wish->occluders = TR_OCCLUDERS_TOGETHER;
    if (wish->see == TR_SEE_ONE_MASK || wish->see == TR_SEE_DITHER) {
        wish->shape = TR_MASK_OUTLINE;
        wish->combine = TR_MASK_MIN;
        wish->layers = 0;
    }
}

static int draw_units(stage *s) {
    char message[2048] = "";
    tr_light light;
    tr_dynamic wish = wish_of(s, &light);
    if (!s->o->output)
        take_what_can_be(&wish);
    tr_frame frame = {0};
    frame.framebuffer = s->framebuffer;
    frame.width = s->width;
    frame.height = s->height;
    for (size_t i = 0; i < s->see.unit_count; i++) {
        if (s->see.units[i].flags & TR_UNIT_TARGET)
            s->see.units[i].flags = TR_UNIT_TARGET | (s->o->active ? (uint32_t)TR_UNIT_ACTIVE : 0u);
    }
    battlefield_see_move(&s->see);
    if (!battlefield_see_draw(&s->see, &s->look, &frame, &wish, message, sizeof message))
        return complain(FAILED, "%s", s->said[0] ? s->said : message);
    return DONE;
}

static int draw_frame(stage *s, double time) {
    double start = seconds_now();
    if (s->o->scene == SCENE_BATTLEFIELD)
        battlefield_move(s->field, time);
    battlefield_gl_move(&s->gl);
    if (s->outdoors)
        battlefield_gl_shadow(&s->gl, &s->look, s->shadow_program, SHADOW_SIZE);
    battlefield_look_at(&s->look, s->eye, s->at);
    battlefield_lens(&s->look, s->fov, s->width, s->height, s->nearest, s->farthest);
    glBindFramebuffer(GL_FRAMEBUFFER, s->framebuffer);
    glViewport(0, 0, s->width, s->height);
    glClearColor(s->look.background[0], s->look.background[1], s->look.background[2], 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnable(GL_CULL_FACE);
    int result = draw_units(s);
    s->frame++;
    s->milliseconds = 1000 * (seconds_now() - start);
    return result;
}

/* ---- pictures -------------------------------------------------------------------------------------------- */

/* Averages squares of samples; rows from the top. */
static void shrink(const unsigned char *samples, int quality, int width, int height, unsigned char *out) {
    int area = quality * quality;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            for (int c = 0; c < 4; c++) {
                int sum = area / 2;
                for (int i = 0; i < area; i++) {
                    size_t row = (size_t)((height - 1 - y) * quality + i / quality);
                    sum += samples[4 * (row * (size_t)(width * quality) + (size_t)(x * quality + i % quality)) +
                                   (size_t)c];
                }
                out[4 * ((size_t)y * (size_t)width + (size_t)x) + (size_t)c] =
                    c == 3 ? 255 : (unsigned char)(sum / area);
            }
}

static int write_frame(stage *s, const char *path, unsigned char *samples, unsigned char *pixels) {
    char message[256];
    glBindFramebuffer(GL_FRAMEBUFFER, s->framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, s->width, s->height, GL_RGBA, GL_UNSIGNED_BYTE, samples);
    shrink(samples, s->o->quality, s->o->width, s->o->height, pixels);
    if (!write_png(path, pixels, s->o->width, s->o->height, message, sizeof message))
        return complain(FAILED, "%s: %s", path, message);
    return DONE;
}

/* OUT_0001.png for OUT.png. */
static void frame_path(const options *o, int frame, char *path, size_t size) {
    const char *dot = strrchr(o->output, '.');
    size_t stem = dot && !strchr(dot, '/') ? (size_t)(dot - o->output) : strlen(o->output);
    if (o->frames)
        snprintf(path, size, "%.*s_%04d%s", (int)stem, o->output, frame + 1, o->output + stem);
    else
        snprintf(path, size, "%s", o->output);
}

/* Around the place that is looked at; a walker turns on the spot. */
static void turn_eye(stage *s, double degrees) {
    double angle = degrees * 3.14159265358979323846 / 180, c = cos(angle), d = sin(angle);
    bool walker = s->o->scene == SCENE_WALKTHROUGH;
    const double *middle = walker ? s->eye : s->at;
    double *moved = walker ? s->at : s->eye;
    double x = moved[0] - middle[0], y = moved[1] - middle[1];
    moved[0] = middle[0] + c * x - d * y;
    moved[1] = middle[1] + d * x + c * y;
}

/* Text of the header's own: words without quotes. */
static void explain(const stage *s, const headless *context) {
    size_t triangles = 0;
    const tr_see_plan *plan = tr_get_info(s->tr).see_plan;
    for (size_t i = 0; i < s->gl.shown; i++)
        triangles += s->field->scene->meshes[s->field->scene->parts[s->gl.all[i]].mesh].index_count / 3;
    printf("{\"driver\": \"%s\", \"parts\": %zu, \"triangles\": %zu, \"meshes\": %zu, \"milliseconds\": %.2f,\n"
           " \"method\": \"%s\", \"why\": \"%s\", \"targets\": %u, \"in_view\": %u, \"masks\": %u, \"covered\": %.3f,"
           " \"bytes\": %llu,\n \"passes\": [",
           context->renderer, s->gl.shown, triangles, s->gl.mesh_count, s->milliseconds,
           nth_word(METHODS, (int)plan->see), plan->why, plan->targets, plan->targets_in_view, plan->masks,
           (double)plan->covered, (unsigned long long)plan->bytes);
    for (int i = 0; i < plan->pass_count; i++)
        printf("%s\n  {\"pass\": \"%s\", \"units\": %u, \"why\": \"%s\"}", i ? "," : "",
               tr_pass_kind_name(plan->passes[i].kind), plan->passes[i].unit_count, plan->passes[i].why);
    printf("]}\n");
}

static int draw_pictures(stage *s, const headless *context) {
    size_t count = (size_t)s->width * (size_t)s->height;
    unsigned char *samples = malloc(4 * count), *pixels = malloc(4 * (size_t)s->o->width * (size_t)s->o->height);
    int frames = s->o->frames ? s->o->frames : 1, result = samples && pixels ? DONE : complain(FAILED, "out of memory");
    for (int i = 0; i < frames && result == DONE; i++) {
        char path[4096];
        result = draw_frame(s, s->o->time + i / 25.0);
        double start = seconds_now();
        glFinish();
        s->milliseconds += 1000 * (seconds_now() - start);
        if (s->o->explain)
            explain(s, context);
        frame_path(s->o, i, path, sizeof path);
        if (result == DONE)
            result = write_frame(s, path, samples, pixels);
        turn_eye(s, s->o->turn / (frames > 1 ? frames - 1 : 1));
    }
    free(samples);
    free(pixels);
    return result;
}

static int run_headless(options *o) {
    char message[512], path[4096];
    headless context;
    stage s = {0};
    frame_path(o, 0, path, sizeof path);
    if (!write_png_possible(path, message, sizeof message))
        return complain(FAILED, "%s: %s", path, message);
    if (!headless_create(&context, 0, 0, o->gles, message, sizeof message))
        return complain(FAILED, "no OpenGL: %s", message);
    int result = DONE;
    if (!(o->gles ? gladLoadGLES2 : gladLoadGL)((GLADloadfunc)headless_get_proc))
        result = complain(FAILED, "no OpenGL functions");
    if (result == DONE)
        result = open_stage(&s, o, headless_get_proc, o->width, o->height);
    if (result == DONE)
        result = draw_pictures(&s, &context);
    if (s.o)
        close_stage(&s);
    headless_destroy(&context);
    return result;
}

/* ---- the window ------------------------------------------------------------------------------------------ */

typedef struct hand {
    stage *s;
    double x, y, time, last;
    bool dragging, stopped, fading;
} hand;

static void orbit(stage *s, double azimuth, double lift) {
    double *eye = s->o->scene == SCENE_WALKTHROUGH ? s->at : s->eye;
    const double *at = s->o->scene == SCENE_WALKTHROUGH ? s->eye : s->at;
    turn_eye(s, azimuth);
    double x = eye[0] - at[0], y = eye[1] - at[1], z = eye[2] - at[2], flat = hypot(x, y), length = hypot(flat, z);
    double angle = fmin(fmax(atan2(z, flat) + lift * 0.0174533, -0.6), 1.5);
    eye[0] = at[0] + x / flat * length * cos(angle);
    eye[1] = at[1] + y / flat * length * cos(angle);
    eye[2] = at[2] + length * sin(angle);
}

static void on_cursor(GLFWwindow *window, double x, double y) {
    hand *h = glfwGetWindowUserPointer(window);
    if (h->dragging)
        orbit(h->s, -0.3 * (x - h->x), 0.3 * (y - h->y));
    h->x = x;
    h->y = y;
}

static void on_button(GLFWwindow *window, int button, int action, int mods) {
    hand *h = glfwGetWindowUserPointer(window);
    (void)mods;
    if (button == GLFW_MOUSE_BUTTON_LEFT)
        h->dragging = action == GLFW_PRESS;
}

static void on_wheel(GLFWwindow *window, double dx, double dy) {
    hand *h = glfwGetWindowUserPointer(window);
    stage *s = h->s;
    double step = pow(0.9, dy);
    (void)dx;
    for (int k = 0; k < 3; k++) {
        double way = s->at[k] - s->eye[k];
        if (s->o->scene == SCENE_WALKTHROUGH && k < 2) { /* a walker walks */
            s->eye[k] += 0.05 * dy * way;
            s->at[k] += 0.05 * dy * way;
        } else if (s->o->scene != SCENE_WALKTHROUGH) {
            s->eye[k] = s->at[k] - way * step;
        }
    }
}

static void on_key(GLFWwindow *window, int key, int code, int action, int mods) {
    hand *h = glfwGetWindowUserPointer(window);
    (void)code, (void)mods;
    if (action != GLFW_PRESS)
        return;
    if (key == GLFW_KEY_ESCAPE)
        glfwSetWindowShouldClose(window, GLFW_TRUE);
    options *o = h->s->o;
    if (key == GLFW_KEY_SPACE)
        h->stopped = !h->stopped;
    if (key >= GLFW_KEY_1 && key <= GLFW_KEY_6)
        o->method = key - GLFW_KEY_1;
    if (key == GLFW_KEY_M)
        o->shape = (o->shape + 1) % 4;
    if (key == GLFW_KEY_C)
        o->combine = !o->combine;
    if (key == GLFW_KEY_O)
        o->occluders = !o->occluders;
    if (key == GLFW_KEY_A)
        o->active = !o->active;
    if (key == GLFW_KEY_F)
        h->fading = !h->fading;
}

static GLFWwindow *open_window(const options *o) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    GLFWwindow *window = glfwCreateWindow(o->width, o->height, "rts", NULL, NULL);
    if (!window)
        return NULL;
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    glfwSetCursorPosCallback(window, on_cursor);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetScrollCallback(window, on_wheel);
    glfwSetKeyCallback(window, on_key);
    return window;
}

/* The light follows the mouse; the wheel would be for its size, but brings the eye nearer. */
static void move_light(GLFWwindow *window, hand *h, int width, int height) {
    options *o = h->s->o;
    int across, down;
    glfwGetWindowSize(window, &across, &down);
    o->light[0] = h->x * width / (across > 0 ? across : 1);
    o->light[1] = height - h->y * height / (down > 0 ? down : 1);
    o->light[2] = 0.17 * height;
    o->light[3] = 0.07 * height;
}

static void tell_in_title(GLFWwindow *window, const stage *s, double seconds) {
    char title[160];
    snprintf(title, sizeof title, "rts: %s, %s masks%s, %.1f ms", nth_word(METHODS, s->o->method),
             s->o->shape && s->o->method >= TR_SEE_EXACT ? "drawn" : "outline", s->o->active ? ", search light" : "",
             1000 * seconds);
    glfwSetWindowTitle(window, title);
}

static int show_frame(GLFWwindow *window, hand *h) {
    stage *s = h->s;
    int width, height;
    glfwGetFramebufferSize(window, &width, &height);
    if (width == 0 || height == 0) /* hidden */
        return DONE;
    if ((width * s->o->quality != s->width || height * s->o->quality != s->height) &&
        make_target(s, width, height) != DONE)
        return FAILED;
    double now = seconds_now();
    if (!h->stopped)
        h->time += now - h->last;
    double seconds = now - h->last;
    for (size_t i = 0; i < s->see.unit_count; i++)
        s->wanted[i] = h->fading ? 1.0f : (float)s->o->fade;
    tr_advance(s->see.units, s->see.unit_count, sizeof *s->see.units, s->wanted, (float)seconds, 0.4f);
    move_light(window, h, width, height);
    if (s->frame % 30 == 0)
        tell_in_title(window, s, seconds);
    h->last = now;
    if (draw_frame(s, h->time) != DONE)
        return FAILED;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, s->framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, s->width, s->height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glfwSwapBuffers(window);
    return DONE;
}

static int run_window(options *o) {
    stage s = {0};
    hand h = {&s, 0, 0, o->time, seconds_now(), false, false, false};
    const char *why = "no display";
    if (!glfwInit()) {
        glfwGetError(&why);
        return complain(FAILED, "no window (%s); -o OUT.png makes a picture without one", why ? why : "no display");
    }
    GLFWwindow *window = open_window(o);
    int result = DONE;
    if (!window)
        result = complain(FAILED, "no window with OpenGL 3.3; -o OUT.png makes a picture without one");
    else if (!gladLoadGL((GLADloadfunc)glfwGetProcAddress))
        result = complain(FAILED, "no OpenGL functions");
    else
        result = open_stage(&s, o, (void (*(*)(const char *))(void))glfwGetProcAddress, o->width, o->height);
    if (result == DONE)
        glfwSetWindowUserPointer(window, &h);
    while (result == DONE && !glfwWindowShouldClose(window)) {
        result = show_frame(window, &h);
        glfwPollEvents();
    }
    if (s.o)
        close_stage(&s);
    glfwTerminate();
    return result;
}

int main(int argc, char **argv) {
    options o = {0};
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], "--help") == 0) {
            for (size_t k = 0; k < sizeof HELP / sizeof HELP[0]; k++)
                fputs(HELP[k], stdout);
            return DONE;
        }
    int result = read_options(&o, argc, argv);
    if (result != DONE)
        return result;
    return o.output ? run_headless(&o) : run_window(&o);
}

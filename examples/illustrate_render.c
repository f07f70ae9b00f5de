/* illustrate_render.c: a scene becomes a picture. silhouette.h finds the lines and the distances on the CPU,
 * transparency.h says what is drawn when, and this file owns the buffers, the camera and the pixels.
 *
 * The picture is drawn larger (job.quality a side) in tiles and averaged: lines and edges come out clean on every
 * driver, and no size is too large for a texture. */
#include "illustrate_render.h"
#include "depth_image.h"
#include "line_svg.h"
#include "overlap.h"
#include "refine.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define GLAD_GL_IMPLEMENTATION
#define GLAD_GLES2_IMPLEMENTATION
#include <glad/gl.h>

#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"
#define TRANSPARENCY_IMPLEMENTATION
#include "transparency.h"
#define OIT_BUFFERS_IMPLEMENTATION
#include "oit_buffers.h"

enum { TILE = 2048, SMALLEST_TILE = 128 }; /* drawn pixels */

#define HEAVIEST 2.4f /* times its width, the heaviest line */

/* One mesh on the GPU and as silhouette.h knows it. Parts that are transparent have one of their own on the GPU, finely
 * divided; their lines are those of the coarse one. */
typedef struct surface {
    float *positions, *normals, *colors; /* colors may be NULL */
    uint32_t *indices;
    size_t vertex_count, index_count;
    bool owned; /* the arrays are ours, not the scene's */
    sil_mesh *mesh;
    GLuint buffer, index_buffer; /* positions, normals, colours one after the other */
    bool sheet, inward;
    double box_volume; /* of the bounding box */
} surface;

typedef struct figure {
    tr_object object; /* first: tr_scene_count reads it */
    const scene_part *part;
    size_t surface;
    double model_view[16];
    bool mirrored;
    float d_max;
    int crossing_first, crossing_count; /* where it enters transparent parts, among the segments of all */
    size_t edge_set;                    /* of a transparent figure: which of the renderer's, from 1 */
    tr_edge_set alpha_edges;
    GLuint array, alpha_buffer, line_array, line_buffer; /* alpha_buffer: distances, or numbers of triangles */
    sil_edge *edges;
    sil_strip *strips;
    uint32_t *strip_vertices;
    sil_smooth_point *smooth; /* NULL, or where smooth silhouettes run, and their strips */
    sil_strip *smooth_strips;
    size_t smooth_count, smooth_strip_count;
    bool phantom;                                               /* lines only */
    size_t crease_strips, strip_count;                          /* creases come first */
    GLsizei crease_vertices, outline_vertices, hidden_vertices; /* in this order */
} figure;

/* What is done with the fragments of a tile, in this order. */
typedef enum glass_stage {
    GLASS_STORE,
    GLASS_LINK,
    GLASS_LAW,
    GLASS_SMART,
    GLASS_CURVATURE,
    GLASS_COMPOSE,
    GLASS_STAGES
} glass_stage;

typedef struct glass_cost {
    bool run;
    double ms;
    int64_t bytes;
} glass_cost;

typedef struct renderer {
    const illustrate_job *job;
    illustrate_result *result;
    illustrate_style style;
    surface *surfaces;
    figure *figures;
    size_t surface_count, figure_count;
    double view[16], projection[16];
    double reach[2]; /* distances of the nearest and the farthest place along the view */
    sil_image drawn; /* what covers a tile, for outer lines */
    tr_context *tr;
    tr_alpha alpha;
    tr_edges *edges; /* of the transparent figures, one after the other, until they are uploaded */
    size_t edge_sets;
    tr_interior interior;
    tr_wishes wishes; /* as drawn */
    double radius;    /* of the scene */
    GLuint framebuffer, color, depth;
    int tile_width, tile_height, margin; /* of tiles, around what is kept of them: lines are whole across borders */
    double pass_ms[TR_MAX_PASSES], cpu_ms;
    int tile;         /* how wide and tall a tile may be without its margin, drawn pixels */
    oit_context *oit; /* glass */
    GLuint ink[2];    /* its programs for lines: counting, storing */
    GLuint seal[2];   /* the same for opaque parts among layers that operators look at; see draw_seals */
    GLuint canvas, opaque, opaque_color, opaque_depth; /* color without depth; a copy of what is opaque */
    bool tile_too_large;
    double glass_ms, since; /* since: when the last stage ended, and `held` what buffers were there */
    uint64_t held;
    glass_cost costs[GLASS_STAGES];   /* of all tiles, for --explain */
    uint32_t most_fragments, deepest; /* of a tile, of a pixel */
    int tiles;
} renderer;

/* ---- small things -------------------------------------------------------------------------------------------- */

static bool broken(renderer *r, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(r->result->message, sizeof r->result->message, format, arguments);
    va_end(arguments);
    return false;
}

static bool no_memory(renderer *r) {
    return broken(r, "out of memory");
}

static void report(const renderer *r, const char *what, double fraction) {
    if (r->job->progress)
        r->job->progress(what, fraction, r->job->user);
}

static double now_ms(void) {
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static void to_float(const double m[16], float out[16]) {
    for (int i = 0; i < 16; ++i)
        out[i] = (float)m[i];
}

static double determinant3(const double m[16]) {
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) +
           m[8] * (m[1] * m[6] - m[2] * m[5]);
}

/* Of the upper left 3x3: cofactors, signed so that normals keep their side under mirroring. */
static void normal_matrix(const double m[16], float out[9]) {
    double sign = determinant3(m) < 0 ? -1 : 1, largest = 0, cofactors[9];
    for (int c = 0; c < 3; ++c) {
        const double *p = m + 4 * ((c + 1) % 3), *q = m + 4 * ((c + 2) % 3);
        for (int i = 0; i < 3; ++i) {
            int a = (i + 1) % 3, b = (i + 2) % 3;
            cofactors[3 * c + i] = sign * (p[a] * q[b] - p[b] * q[a]);
            largest = fmax(largest, fabs(cofactors[3 * c + i]));
        }
    }
    for (int i = 0; i < 9; ++i)
        out[i] = (float)(largest > 0 ? cofactors[i] / largest : 0);
}

static void transform_point(const double m[16], const float p[3], double out[4]) {
    for (int i = 0; i < 4; ++i)
        out[i] = m[i] * (double)p[0] + m[4 + i] * (double)p[1] + m[8 + i] * (double)p[2] + m[12 + i];
}

/* ---- surfaces ------------------------------------------------------------------------------------------------ */

static void sil_said(int level, int code, const char *text, void *user) {
    (void)level, (void)code;
    if (((const illustrate_job *)user)->verbose)
        fprintf(stderr, "%s\n", text);
}

/* The longest side of its box. */
static double surface_size(const surface *s) {
    double size = 0;
    for (size_t k = 0; k < 3; ++k) {
        float low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < s->vertex_count; ++i) {
            low = fminf(low, s->positions[3 * i + k]);
            high = fmaxf(high, s->positions[3 * i + k]);
        }
        size = fmax(size, (double)high - (double)low);
    }
    return isfinite(size) ? size : 0;
}

/* Closed enough to have an inside: the areas of a closed surface, as vectors, add up to nothing. Small cracks change
 * little. Also which way the triangles face, and how much of its box the surface fills. */
static void classify_surface(surface *s) {
    double area[3] = {0, 0, 0}, total = 0, volume = 0, low[3], high[3];
    for (int k = 0; k < 3; ++k)
        low[k] = high[k] = s->vertex_count ? (double)s->positions[k] : 0;
    for (size_t i = 0; i < s->vertex_count; ++i)
        for (int k = 0; k < 3; ++k) {
            low[k] = fmin(low[k], (double)s->positions[3 * i + (size_t)k]);
            high[k] = fmax(high[k], (double)s->positions[3 * i + (size_t)k]);
        }
    for (size_t t = 0; t + 2 < s->index_count; t += 3) {
        double v[3][3], n[3];
        for (int c = 0; c < 3; ++c)
            for (int k = 0; k < 3; ++k)
                v[c][k] = (double)s->positions[3 * s->indices[t + (size_t)c] + (size_t)k] - low[k];
        for (int k = 0; k < 3; ++k) {
            int a = (k + 1) % 3, b = (k + 2) % 3;
            n[k] = (v[1][a] - v[0][a]) * (v[2][b] - v[0][b]) - (v[1][b] - v[0][b]) * (v[2][a] - v[0][a]);
            area[k] += n[k];
            volume += n[k] * v[0][k] / 6;
        }
        total += sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    }
    double box = (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
    double open = sqrt(area[0] * area[0] + area[1] * area[1] + area[2] * area[2]);
    sil_mesh_info info = sil_mesh_get_info(s->mesh);
    /* Lines are those of faces that agree; what is drawn is wound as the file has it. */
    bool mixed =
        info.flipped_edge_count > 0 ||
        (info.reversed_face_count > 0 && info.reversed_face_count + info.two_sided_face_count < info.face_count);
    s->sheet = !(open <= 0.02 * total) || mixed || !(fabs(volume) > 1e-6 * box);
    s->inward = !s->sheet && volume < 0;
    s->box_volume = box;
}

static bool find_edges_of(renderer *r, surface *s) {
    sil_mesh_desc desc;
    sil_result result;
    memset(&desc, 0, sizeof desc);
    desc.crease_degrees = SCENE_CREASE_DEGREES; /* no line where the shading is smooth */
    desc.positions = s->positions;
    desc.vertex_count = s->vertex_count;
    desc.indices = s->indices;
    desc.index_count = s->index_count;
    desc.flags = SIL_MESH_ORIENT;
    desc.t_junction_distance = (float)(1e-5 * surface_size(s)); /* what rounding and tessellators leave open */
    desc.log_fn = sil_said;
    desc.log_user = (void *)(uintptr_t)r->job;
    s->mesh = sil_mesh_create(&desc, &result);
    if (!s->mesh)
        return broken(r, "silhouettes: %s", sil_result_string(result));
    classify_surface(s);
    return true;
}

static void upload_surface(surface *s) {
    size_t bytes = s->vertex_count * 3 * sizeof(float);
    glGenBuffers(1, &s->buffer);
    glBindBuffer(GL_ARRAY_BUFFER, s->buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(3 * bytes), NULL, GL_STATIC_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)bytes, s->positions);
    glBufferSubData(GL_ARRAY_BUFFER, (GLintptr)bytes, (GLsizeiptr)bytes, s->normals);
    if (s->colors)
        glBufferSubData(GL_ARRAY_BUFFER, (GLintptr)(2 * bytes), (GLsizeiptr)bytes, s->colors);
    glGenBuffers(1, &s->index_buffer);
    glBindVertexArray(0);
    glBindBuffer(GL_COPY_WRITE_BUFFER, s->index_buffer);
    glBufferData(GL_COPY_WRITE_BUFFER, (GLsizeiptr)(s->index_count * sizeof(uint32_t)), s->indices, GL_STATIC_DRAW);
}

/* ---- which parts are transparent ------------------------------------------------------------------------------ */

static void part_box(const scene *s, const scene_part *part, double low[3], double high[3]) {
    const scene_mesh *mesh = &s->meshes[part->mesh];
    for (int k = 0; k < 3; ++k)
        low[k] = HUGE_VAL, high[k] = -HUGE_VAL;
    for (size_t i = 0; i < mesh->vertex_count; ++i) {
        double p[4];
        transform_point(part->transform, mesh->positions + 3 * i, p);
        for (int k = 0; k < 3; ++k) {
            low[k] = fmin(low[k], p[k]);
            high[k] = fmax(high[k], p[k]);
        }
    }
}

/* Whether a ray from `start` along an axis meets the triangle: the point's projection within it, the plane ahead. */
static bool ray_meets(const double v[3][4], const double start[3], int axis, double sign) {
    int a = (axis + 1) % 3, b = (axis + 2) % 3;
    double area[3], sum = 0, at = 0;
    for (int c = 0; c < 3; ++c) {
        const double *p = v[(c + 1) % 3], *q = v[(c + 2) % 3];
        area[c] = (p[a] - start[a]) * (q[b] - start[b]) - (p[b] - start[b]) * (q[a] - start[a]);
        sum += area[c];
        at += area[c] * v[c][axis];
    }
    bool inside = (area[0] >= 0 && area[1] >= 0 && area[2] >= 0) || (area[0] <= 0 && area[1] <= 0 && area[2] <= 0);
    return inside && sum != 0 && (at / sum - start[axis]) * sign > 0;
}

/* Whether `outer` closes `start` off in at least five of the six axis directions. */
static bool surrounds(const scene *s, const scene_part *outer, const double start[3]) {
    const scene_mesh *mesh = &s->meshes[outer->mesh];
    bool met[6] = {false, false, false, false, false, false};
    for (size_t t = 0; t + 2 < mesh->index_count; t += 3) {
        double v[3][4];
        for (size_t c = 0; c < 3; ++c)
            transform_point(outer->transform, mesh->positions + 3 * (size_t)mesh->indices[t + c], v[c]);
        for (int d = 0; d < 6; ++d)
            met[d] = met[d] || ray_meets((const double(*)[4])v, start, d / 2, d % 2 ? -1 : 1);
    }
    return met[0] + met[1] + met[2] + met[3] + met[4] + met[5] >= 5;
}

typedef struct boxes {
    double (*low)[3], (*high)[3];
} boxes;

static bool within_box(const boxes *b, size_t inner, size_t outer) {
    bool within = inner != outer;
    for (int k = 0; k < 3; ++k)
        within = within && b->low[inner][k] >= b->low[outer][k] && b->high[inner][k] <= b->high[outer][k];
    return within;
}

static bool encloses(const scene *s, const boxes *b, size_t outer, size_t inner) {
    double middle[3];
    for (int k = 0; k < 3; ++k)
        middle[k] = 0.5 * (b->low[inner][k] + b->high[inner][k]);
    return within_box(b, inner, outer) && !s->parts[inner].hidden && !s->parts[outer].hidden &&
           surrounds(s, &s->parts[outer], middle);
}

/* Parts that enclose another one: `found`. Eight that lie within a part's box are tried. */
static void find_enclosing(const scene *s, const boxes *b, unsigned char *found) {
    for (size_t i = 0; i < s->part_count; ++i) {
        size_t tried = 0;
        for (size_t j = 0; j < s->part_count && !found[i] && tried < 8; ++j) {
            tried += within_box(b, j, i);
            found[i] = encloses(s, b, i, j);
        }
    }
}

/* Of transparent parts within transparent parts only the outermost stays so, where the host did not say more: nothing
 * would show through the second one, and it would not be seen itself. */
static void keep_outermost(const renderer *r, const boxes *b, unsigned char *transparent) {
    const scene *s = r->job->scene;
    for (size_t i = 0; i < s->part_count; ++i) {
        bool asked = r->job->transparent && r->job->transparent[i] == PART_TRANSPARENT;
        for (size_t j = 0; j < s->part_count && transparent[i] && !asked; ++j)
            if (transparent[j] && !within_box(b, j, i) && encloses(s, b, j, i))
                transparent[i] = 0;
    }
}

static bool measure_boxes(const scene *s, boxes *b) {
    b->low = malloc((s->part_count + 1) * sizeof *b->low);
    b->high = malloc((s->part_count + 1) * sizeof *b->high);
    for (size_t i = 0; b->low && b->high && i < s->part_count; ++i)
        part_box(s, &s->parts[i], b->low[i], b->high[i]);
    return b->low && b->high;
}

static bool has_layers(illustrate_style style) {
    return style == STYLE_GLASS || style == STYLE_SMART || style == STYLE_CURVATURE;
}

static void all_where_none(const scene *s, unsigned char *transparent) {
    for (size_t i = 0; i < s->part_count; ++i)
        if (transparent[i])
            return;
    for (size_t i = 0; i < s->part_count; ++i)
        transparent[i] = !s->parts[i].hidden;
}

/* One byte a part: transparent or not. Where the file has no transparent part, parts that enclose others are; what the
 * job says of a part overrules that. */
static unsigned char *choose_transparent(renderer *r) {
    const scene *s = r->job->scene;
    unsigned char *transparent = calloc(s->part_count + 1, 1);
    boxes b = {NULL, NULL};
    bool file_says = false, ok = transparent && measure_boxes(s, &b);
    bool glass = has_layers(r->job->style);
    bool hodges = r->job->style == STYLE_AUTO || r->job->style == STYLE_HODGES || r->job->phantom || glass;
    for (size_t i = 0; ok && hodges && i < s->part_count; ++i) {
        transparent[i] = !s->parts[i].hidden && s->parts[i].opacity < 1.0f;
        file_says = file_says || transparent[i];
    }
    if (ok && hodges && !file_says)
        find_enclosing(s, &b, transparent);
    if (ok && glass && r->job->style != STYLE_GLASS && !file_says) /* of surfaces, which enclose nothing */
        all_where_none(s, transparent);
    for (size_t i = 0; ok && r->job->transparent && i < s->part_count; ++i)
        if (r->job->transparent[i] != PART_AUTO)
            transparent[i] = hodges && !s->parts[i].hidden && r->job->transparent[i] == PART_TRANSPARENT;
    if (ok && !glass) /* which shows every layer */
        keep_outermost(r, &b, transparent);
    free(b.low);
    free(b.high);
    if (ok)
        return transparent;
    free(transparent);
    no_memory(r);
    return NULL;
}

/* ---- figures: parts as they are drawn -------------------------------------------------------------------------- */

/* The surface of a mesh, shared by all opaque parts of it. */
static void borrow_surface(const scene_mesh *mesh, surface *s) {
    s->positions = mesh->positions;
    s->normals = mesh->normals;
    s->colors = mesh->colors;
    s->indices = mesh->indices;
    s->vertex_count = mesh->vertex_count;
    s->index_count = mesh->index_count - mesh->index_count % 3;
}

/* A finer copy for a transparent part. Distances are linear within a triangle, and need about this many steps to look
 * right; candidates are exact without, but the larger a triangle, the more edges it carries to all of its pixels. */
static bool refine_surface(renderer *r, const scene_mesh *mesh, surface *s) {
    static const double steps[TR_ALPHA_COUNT] = {40, 40, 16, 0.5};
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, diagonal = 0;
    scene_mesh fine;
    for (size_t i = 0; i < 3 * mesh->vertex_count; ++i) {
        low[i % 3] = fmin(low[i % 3], (double)mesh->positions[i]);
        high[i % 3] = fmax(high[i % 3], (double)mesh->positions[i]);
    }
    for (int k = 0; k < 3; ++k)
        diagonal += (high[k] - low[k]) * (high[k] - low[k]);
    if (!refine_mesh(mesh, sqrt(diagonal) / steps[r->alpha], 400000, &fine))
        return no_memory(r);
    borrow_surface(&fine, s);
    s->owned = true;
    return true;
}

/* One value a corner, in place of one a vertex. */
static bool spread(float **values, const uint32_t *indices, size_t corners) {
    float *spread_out = *values ? malloc((corners + 1) * 3 * sizeof(float)) : NULL;
    if (!spread_out)
        return !*values;
    for (size_t i = 0; i < corners; ++i)
        memcpy(spread_out + 3 * i, *values + 3 * (size_t)indices[i], 3 * sizeof(float));
    free(*values);
    *values = spread_out;
    return true;
}

/* A surface of ours shares no vertices any more, so that its triangles can be numbered at theirs. */
static bool flatten_surface(renderer *r, surface *s) {
    if (!spread(&s->positions, s->indices, s->index_count) || !spread(&s->normals, s->indices, s->index_count) ||
        !spread(&s->colors, s->indices, s->index_count))
        return no_memory(r);
    for (size_t i = 0; i < s->index_count; ++i)
        s->indices[i] = (uint32_t)i;
    s->vertex_count = s->index_count;
    return true;
}

static bool make_figures(renderer *r) {
    const scene *s = r->job->scene;
    unsigned char *transparent = choose_transparent(r);
    size_t extra = 0;
    if (!transparent)
        return false;
    for (size_t i = 0; i < s->part_count; ++i)
        extra += transparent[i] != 0;
    r->surface_count = s->mesh_count + extra;
    r->surfaces = calloc(r->surface_count + 1, sizeof *r->surfaces);
    r->figures = calloc(s->part_count + 1, sizeof *r->figures);
    bool ok = r->surfaces && r->figures ? true : no_memory(r);
    extra = s->mesh_count;
    for (size_t m = 0; ok && m < s->mesh_count; ++m) {
        borrow_surface(&s->meshes[m], &r->surfaces[m]);
        ok = find_edges_of(r, &r->surfaces[m]);
    }
    for (size_t i = 0; ok && i < s->part_count; ++i) {
        figure *f = &r->figures[r->figure_count];
        if (s->parts[i].hidden || s->meshes[s->parts[i].mesh].index_count < 3)
            continue;
        f->part = &s->parts[i];
        f->surface = f->part->mesh;
        f->object.id = (uint32_t)++r->figure_count;
        f->phantom = transparent[i] && r->job->phantom;
        f->object.flags = transparent[i] && !f->phantom ? (uint32_t)TR_TRANSPARENT : 0;
        if (f->object.flags & TR_TRANSPARENT) {
            f->object.flags |= TR_GROUP(r->job->groups ? r->job->groups[i] : 0);
            f->surface = extra++;
            ok = refine_surface(r, &s->meshes[f->part->mesh], &r->surfaces[f->surface]) &&
                 (r->alpha != TR_ALPHA_CANDIDATES || flatten_surface(r, &r->surfaces[f->surface]));
            r->surfaces[f->surface].sheet = r->surfaces[f->part->mesh].sheet;
            r->surfaces[f->surface].inward = r->surfaces[f->part->mesh].inward;
        }
        if (r->surfaces[f->surface].sheet)
            f->object.flags |= TR_TWO_SIDED;
    }
    free(transparent);
    return ok ? true : r->result->message[0] ? false : no_memory(r);
}

/* ---- the camera ------------------------------------------------------------------------------------------------ */

/* The view's rotation: rows right, up, toward the eye. */
static void camera_axes(const illustrate_job *job, double axes[3][3]) {
    double a = job->azimuth * 0.017453292519943295, e = job->elevation * 0.017453292519943295;
    const double right[3] = {cos(a), 0, -sin(a)}, up[3] = {-sin(a) * sin(e), cos(e), -cos(a) * sin(e)};
    const double toward[3] = {sin(a) * cos(e), sin(e), cos(a) * cos(e)};
    const double *rows[3] = {right, up, toward};
    for (int i = 0; i < 3; ++i) {
        axes[i][0] = rows[i][0];
        axes[i][1] = job->scene->up_axis == 2 ? -rows[i][2] : rows[i][1];
        axes[i][2] = job->scene->up_axis == 2 ? rows[i][1] : rows[i][2];
    }
}

/* Extents of all that is drawn, in eye space seen from `distance` (HUGE_VAL: orthographic): the projected rectangle and
 * the depth range. */
typedef struct extent {
    double low[3], high[3];
} extent;

static extent measure(const renderer *r, bool perspective) {
    extent e = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (size_t i = 0; i < r->figure_count; ++i) {
        const figure *f = &r->figures[i];
        const surface *s = &r->surfaces[f->part->mesh];
        double to_eye[16];
        scene_multiply(r->view, f->part->transform, to_eye);
        for (size_t v = 0; v < s->vertex_count; ++v) {
            double p[4];
            transform_point(to_eye, s->positions + 3 * v, p);
            double scale = perspective ? -1 / p[2] : 1;
            for (int k = 0; k < 3; ++k) {
                double x = k < 2 ? p[k] * scale : p[k];
                e.low[k] = fmin(e.low[k], x);
                e.high[k] = fmax(e.high[k], x);
            }
        }
    }
    return e;
}

static void make_view(renderer *r, const double axes[3][3], const double center[3], double distance) {
    for (int row = 0; row < 3; ++row) {
        r->view[12 + row] = row == 2 ? -distance : 0;
        for (int k = 0; k < 3; ++k) {
            r->view[4 * k + row] = axes[row][k];
            r->view[12 + row] -= axes[row][k] * center[k];
        }
        r->view[4 * row + 3] = 0;
    }
    r->view[15] = 1;
}

/* The window of the projection is shifted so that the picture is filled, with a margin for lines and air. */
static bool make_camera(renderer *r) {
    const illustrate_job *job = r->job;
    double low[3], high[3], center[3], axes[3][3], radius = 0;
    if (!scene_bounds(job->scene, low, high))
        return broken(r, "nothing to draw");
    for (int k = 0; k < 3; ++k) {
        center[k] = 0.5 * (low[k] + high[k]);
        radius += 0.25 * (high[k] - low[k]) * (high[k] - low[k]);
    }
    radius = sqrt(radius);
    if (!(radius > 0) || !(radius < 1e30))
        return broken(r, "the scene has no extent");
    camera_axes(job, axes);
    r->radius = radius;
    double distance = 4.2 * radius;
    make_view(r, (const double(*)[3])axes, center, distance);
    extent e = measure(r, !job->ortho);
    double aspect = (double)job->width / job->height, half[2], middle[2];
    for (int k = 0; k < 2; ++k) {
        middle[k] = 0.5 * (e.low[k] + e.high[k]);
        half[k] = 0.5 * (e.high[k] - e.low[k]) * 1.09 + 1e-6 * (job->ortho ? radius : 1);
        half[k] *= 1 + 2 * (double)job->line_width / (k ? job->height : job->width);
    }
    half[1] = fmax(half[1], half[0] / aspect);
    half[0] = half[1] * aspect;
    r->reach[0] = -e.high[2];
    r->reach[1] = -e.low[2];
    double n = fmax(-e.high[2] - 0.01 * radius, 0.01 * radius), f = -e.low[2] + 0.01 * radius;
    memset(r->projection, 0, sizeof r->projection);
    for (int k = 0; k < 2; ++k) {
        r->projection[5 * k] = 1 / half[k];
        r->projection[(job->ortho ? 12 : 8) + k] = (job->ortho ? -1 : 1) * middle[k] / half[k];
    }
    r->projection[10] = job->ortho ? -2 / (f - n) : -(f + n) / (f - n);
    r->projection[14] = job->ortho ? -(f + n) / (f - n) : -2 * f * n / (f - n);
    r->projection[11] = job->ortho ? 0 : -1;
    r->projection[15] = job->ortho ? 1 : 0;
    for (size_t i = 0; i < r->figure_count; ++i) {
        scene_multiply(r->view, r->figures[i].part->transform, r->figures[i].model_view);
        r->figures[i].mirrored = determinant3(r->figures[i].model_view) < 0;
    }
    return true;
}

/* ---- lines and distances --------------------------------------------------------------------------------------- */

static double wanted_k(const renderer *r) {
    return r->job->k >= 0 ? (double)r->job->k : 0.45;
}

static void upload_alpha(figure *f, const void *values, size_t count) {
    glGenBuffers(1, &f->alpha_buffer);
    glBindBuffer(GL_ARRAY_BUFFER, f->alpha_buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(count * sizeof(float)), values, GL_STATIC_DRAW); /* or of uint32_t */
}

/* Distances at the vertices of the fine mesh to the outline of the coarse one. */
static bool find_distances(renderer *r, figure *f, const sil_edge_tree *tree) {
    const surface *s = &r->surfaces[f->surface];
    float *distances = malloc((s->vertex_count + 1) * sizeof *distances);
    if (!distances)
        return no_memory(r);
    sil_result result = sil_distances_at(tree, s->positions, 0, s->vertex_count, distances, NULL);
    if (result == SIL_OK)
        upload_alpha(f, distances, s->vertex_count);
    free(distances);
    return result == SIL_OK ? true : broken(r, "distances: %s", sil_result_string(result));
}

/* Which edges each triangle carries, and the triangles' numbers. */
static bool find_candidates(renderer *r, figure *f, const sil_edge_tree *tree, tr_edges *edges) {
    const surface *s = &r->surfaces[f->surface];
    size_t triangles = s->index_count / 3, capacity = 8 * triangles, needed = 0;
    uint32_t *offsets = malloc((triangles + 1) * sizeof *offsets), *list = malloc((capacity + 1) * sizeof *list);
    uint32_t *numbers = malloc((s->vertex_count + 1) * sizeof *numbers);
    sil_result result = SIL_OUT_OF_MEMORY;
    if (offsets && list && numbers)
        result =
            sil_candidates(tree, s->positions, 0, s->vertex_count, NULL, triangles, offsets, list, capacity, &needed);
    if (result == SIL_OK && needed > capacity) {
        free(list);
        list = malloc(needed * sizeof *list);
        result = list ? sil_candidates(tree, s->positions, 0, s->vertex_count, NULL, triangles, offsets, list, needed,
                                       &needed)
                      : SIL_OUT_OF_MEMORY;
    }
    for (size_t i = 0; result == SIL_OK && i < s->vertex_count; ++i)
        numbers[i] = (uint32_t)(i / 3);
    if (result == SIL_OK)
        upload_alpha(f, numbers, s->vertex_count);
    free(numbers);
    edges->offsets = offsets;
    edges->candidates = list;
    edges->triangle_count = triangles;
    return result == SIL_OK ? true : broken(r, "candidates: %s", sil_result_string(result));
}

static bool find_order(renderer *r, const sil_edge_tree *tree, tr_edges *edges) {
    uint32_t *order = malloc((edges->edge_count + 1) * sizeof *order);
    if (!order)
        return no_memory(r);
    edges->edge_count = sil_edge_tree_order(tree, order, edges->edge_count);
    edges->order = order;
    return true;
}

/* What alpha is found by: the outline of the coarse mesh, and what the rung makes of it. */
static bool prepare_alpha(renderer *r, figure *f, const sil_view *view) {
    const surface *coarse = &r->surfaces[f->part->mesh];
    const unsigned kinds = SIL_SILHOUETTE | SIL_BOUNDARY;
    tr_edges *set = &r->edges[r->edge_sets];
    f->edge_set = ++r->edge_sets;
    size_t count = sil_extract(coarse->mesh, NULL, view, kinds, NULL, 0);
    sil_edge *edges = malloc((count + 1) * sizeof *edges);
    sil_edge_tree *tree = sil_edge_tree_create(coarse->mesh, NULL);
    sil_distance_desc desc;
    memset(&desc, 0, sizeof desc);
    for (int i = 0; i < 9; ++i)
        set->model[i] = desc.model[i] = (float)f->part->transform[i / 3 * 4 + i % 3];
    bool ok = edges && tree ? true : no_memory(r);
    set->positions = coarse->positions;
    set->position_count = coarse->vertex_count;
    set->ends = ok ? &edges[0].a : NULL; /* freed with the sets */
    set->end_stride = sizeof *edges;
    set->edge_count = ok ? count : 0;
    if (ok) {
        sil_extract(coarse->mesh, NULL, view, kinds, edges, count);
        sil_result result = sil_edge_tree_build(tree, NULL, edges, count, &desc);
        ok = result == SIL_OK ? true : broken(r, "distances: %s", sil_result_string(result));
        f->d_max = sil_max_distance(coarse->mesh, NULL, desc.model);
    } else
        free(edges);
    if (ok)
        ok = r->alpha == TR_ALPHA_CANDIDATES ? find_candidates(r, f, tree, set)
             : r->alpha == TR_ALPHA_EXACT    ? find_order(r, tree, set)
                                             : find_distances(r, f, tree);
    sil_edge_tree_destroy(tree);
    return ok;
}

static void free_lists(tr_edges *set) {
    free((void *)(uintptr_t)set->offsets);
    free((void *)(uintptr_t)set->candidates);
    free((void *)(uintptr_t)set->order);
    set->offsets = set->candidates = set->order = NULL;
}

/* Lists that are too long for the driver's textures are left out: alpha is then searched for among all edges. */
static bool upload_edges(renderer *r) {
    tr_edge_set *sets = calloc(r->edge_sets + 1, sizeof *sets);
    if (!sets)
        return no_memory(r);
    tr_result result = tr_set_edges(r->tr, r->edges, r->edge_sets, sets);
    if (result == TR_TOO_LARGE && r->alpha == TR_ALPHA_CANDIDATES) {
        for (size_t i = 0; i < r->edge_sets; ++i)
            free_lists(&r->edges[i]);
        r->alpha = TR_ALPHA_EXACT;
        result = tr_set_edges(r->tr, r->edges, r->edge_sets, sets);
    }
    for (size_t i = 0; i < r->figure_count; ++i)
        if (r->figures[i].edge_set > 0)
            r->figures[i].alpha_edges = sets[r->figures[i].edge_set - 1];
    free(sets);
    return result == TR_OK ? true : broken(r, "edges for alpha: %s", tr_result_string(result));
}

/* Length of a strip in pixels of the picture; infinite where it comes before the eye. */
static double strip_length(const renderer *r, const figure *f, const sil_strip *strip, const uint32_t *vertices) {
    const float *positions = r->surfaces[f->part->mesh].positions;
    double to_clip[16], length = 0, last[2] = {0, 0};
    scene_multiply(r->projection, f->model_view, to_clip);
    for (uint32_t i = 0; i < strip->count; ++i) {
        double p[4], now[2];
        transform_point(to_clip, positions + 3 * (size_t)vertices[strip->first + i], p);
        if (!(p[3] > 0))
            return HUGE_VAL;
        now[0] = p[0] / p[3] * 0.5 * r->job->width;
        now[1] = p[1] / p[3] * 0.5 * r->job->height;
        length += i ? hypot(now[0] - last[0], now[1] - last[1]) : 0;
        memcpy(last, now, sizeof last);
    }
    return length;
}

/* Creases too short to say anything, as scanned surfaces have by the hundred, are noise. */
static size_t drop_short(const renderer *r, const figure *f, sil_strip *strips, size_t count) {
    size_t kept = 0;
    for (size_t i = 0; i < count; ++i)
        if (strip_length(r, f, &strips[i], f->strip_vertices) >= 8)
            strips[kept++] = strips[i];
    return kept;
}

/* Where lines end. Silhouettes in a valley are hidden by their own surface, from every eye: without them the turning
 * points are clean, where a polygonal silhouette runs back behind itself. At corners dashes begin anew, and so does the
 * way that the light looks at. */
static sil_chain_desc chain_desc(const renderer *r, const figure *f) {
    sil_chain_desc desc;
    double to_clip[16];
    memset(&desc, 0, sizeof desc);
    if (!(f->object.flags & TR_TWO_SIDED))
        desc.flags = SIL_CHAIN_NO_CONCAVE;
    if (f->phantom || r->job->weight == WEIGHT_LIGHT)
        desc.corner_degrees = 50;
    scene_multiply(r->projection, f->model_view, to_clip);
    to_float(to_clip, desc.matrix);
    desc.viewport_width = (float)r->job->width;
    desc.viewport_height = (float)r->job->height;
    return desc;
}

/* Chains one kind of lines after another: creases first. */
static bool chain_lines(renderer *r, figure *f, const sil_mesh *mesh, sil_pose *pose, const sil_view *view) {
    const illustrate_job *job = r->job;
    const sil_chain_desc chains = chain_desc(r, f);
    unsigned outlines = (job->silhouettes && !f->smooth ? SIL_SILHOUETTE : 0u) | (job->boundaries ? SIL_BOUNDARY : 0u);
    unsigned kinds[2] = {job->creases ? SIL_CREASE : 0u, outlines};
    size_t edges = sil_mesh_get_info(mesh).edge_count, vertices = 0;
    f->edges = malloc((edges + 1) * sizeof *f->edges);
    f->strips = malloc((2 * edges + 1) * sizeof *f->strips);
    f->strip_vertices = malloc((4 * edges + 1) * sizeof *f->strip_vertices);
    if (!f->edges || !f->strips || !f->strip_vertices)
        return no_memory(r);
    for (int i = 0; i < 2; ++i) {
        size_t needed = 0, count = kinds[i] ? sil_extract(mesh, pose, view, kinds[i], f->edges, edges) : 0, strips;
        strips = sil_chain_corners(mesh, pose, &chains, f->edges, count, f->strips + f->strip_count, edges,
                                   f->strip_vertices + vertices, 2 * edges, &needed);
        if (needed == SIZE_MAX)
            return no_memory(r);
        for (size_t k = f->strip_count; k < f->strip_count + strips; ++k)
            f->strips[k].first += (uint32_t)vertices;
        vertices += needed;
        if (i == 0)
            strips = drop_short(r, f, f->strips, strips);
        f->strip_count += strips;
        if (i == 0)
            f->crease_strips = f->strip_count;
    }
    return true;
}

/* Smooth silhouettes run through the inside of faces, which says nothing where these are meant to be flat. */
static bool find_smooth(renderer *r, figure *f, const sil_mesh *mesh, sil_pose *pose, const sil_view *view) {
    if (!r->job->smooth || !r->job->silhouettes || sil_mesh_get_info(mesh).crease_edge_count > 0)
        return true;
    f->smooth_strip_count =
        sil_smooth(mesh, pose, view, NULL, 0, SIL_SMOOTH_HERMITE, NULL, 0, NULL, 0, &f->smooth_count);
    if (f->smooth_count == SIZE_MAX)
        return no_memory(r);
    f->smooth = malloc((f->smooth_count + 1) * sizeof *f->smooth);
    f->smooth_strips = malloc((f->smooth_strip_count + 1) * sizeof *f->smooth_strips);
    if (!f->smooth || !f->smooth_strips)
        return no_memory(r);
    sil_smooth(mesh, pose, view, NULL, 0, SIL_SMOOTH_HERMITE, f->smooth, f->smooth_count, f->smooth_strips,
               f->smooth_strip_count, NULL);
    return true;
}

static bool find_lines(renderer *r, figure *f) {
    const sil_mesh *mesh = r->surfaces[f->part->mesh].mesh;
    float model_view[16], projection[16];
    sil_view view;
    sil_result result;
    to_float(f->model_view, model_view);
    to_float(r->projection, projection);
    /* A part that is flattened to nothing has no lines: every face is edge-on. */
    if (sil_view_from_matrices(model_view, projection, &view) != SIL_OK)
        return true;
    sil_pose *pose = sil_pose_create(mesh, &result);
    if (!pose)
        return broken(r, "silhouettes: %s", sil_result_string(result));
    bool ok = find_smooth(r, f, mesh, pose, &view) && chain_lines(r, f, mesh, pose, &view);
    if (ok && (f->object.flags & TR_TRANSPARENT))
        ok = prepare_alpha(r, f, &view);
    sil_pose_destroy(pose);
    free(f->edges);
    f->edges = NULL;
    return ok;
}

static void upload_figure(figure *f, const surface *s, bool numbered) {
    size_t bytes = s->vertex_count * 3 * sizeof(float);
    glGenVertexArrays(1, &f->array);
    glBindVertexArray(f->array);
    glBindBuffer(GL_ARRAY_BUFFER, s->buffer);
    for (GLuint i = 0; i < 2; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 0, (const void *)(i * bytes));
    }
    if (s->colors) {
        glEnableVertexAttribArray(3);
        glVertexAttribPointer(3, 3, GL_FLOAT, GL_FALSE, 0, (const void *)(2 * bytes));
    }
    if (f->alpha_buffer && numbered) {
        glBindBuffer(GL_ARRAY_BUFFER, f->alpha_buffer);
        glEnableVertexAttribArray(4);
        glVertexAttribIPointer(4, 1, GL_UNSIGNED_INT, 0, NULL);
    } else if (f->alpha_buffer) {
        glBindBuffer(GL_ARRAY_BUFFER, f->alpha_buffer);
        glEnableVertexAttribArray(2);
        glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, 0, NULL);
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, s->index_buffer);
    glGenVertexArrays(1, &f->line_array);
    glGenBuffers(1, &f->line_buffer);
    glBindVertexArray(f->line_array);
    glBindBuffer(GL_ARRAY_BUFFER, f->line_buffer);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(sil_ribbon_vertex), NULL);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(sil_ribbon_vertex),
                          (const void *)offsetof(sil_ribbon_vertex, center_x));
    glBindVertexArray(0);
}

static bool prepare(renderer *r) {
    double start = now_ms();
    report(r, "geometry", 0);
    if (!make_figures(r) || !make_camera(r))
        return false;
    r->edges = calloc(r->figure_count + 1, sizeof *r->edges);
    if (!r->edges)
        return no_memory(r);
    for (size_t i = 0; i < r->figure_count; ++i) {
        figure *f = &r->figures[i];
        surface *s = &r->surfaces[f->surface];
        if (!s->buffer)
            upload_surface(s);
        if (!find_lines(r, f))
            return false;
        upload_figure(f, s, r->alpha == TR_ALPHA_CANDIDATES);
        report(r, "lines", (double)(i + 1) / (double)r->figure_count);
    }
    if (r->alpha >= TR_ALPHA_CANDIDATES && r->edge_sets > 0 && !upload_edges(r))
        return false;
    r->cpu_ms = now_ms() - start;
    return true;
}

/* ---- drawing --------------------------------------------------------------------------------------------------- */

static int silhouette_reach(const illustrate_job *job) {
    return job->iterations < 0 ? 0 : job->iterations > 0 ? job->iterations : 20;
}

/* In drawn pixels, of which a pixel of the result has several, so that a halo may be narrower than one of those. */
static int halo_reach(const illustrate_job *job) {
    return job->halo < 0 ? 0 : (int)ceil((job->halo > 0 ? job->halo : 5) * job->quality);
}

static int smart_reach(const renderer *r) {
    int silhouette = silhouette_reach(r->job) * r->job->quality, halo = halo_reach(r->job);
    return silhouette > halo ? silhouette : halo;
}

static GLuint make_texture(GLenum format, int width, int height) {
    bool depth = format == GL_DEPTH_COMPONENT32F;
    GLuint texture;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)format, width, height, 0, depth ? GL_DEPTH_COMPONENT : GL_RGBA,
                 depth ? GL_FLOAT : GL_UNSIGNED_BYTE, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

static GLuint make_framebuffer(GLuint color, GLuint depth) {
    GLuint framebuffer;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    if (depth)
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    return framebuffer;
}

static bool contours_are_drawn(const illustrate_job *job) {
    return job->contours != 0;
}

static bool make_target(renderer *r) {
    int quality = r->job->quality;
    int wide = r->job->width * quality, tall = r->job->height * quality;
    /* Whole pixels of the result in a tile, so that tiles are averaged on their own. */
    int most = r->tile / quality * quality;
    r->margin = 16 + (int)(0.5f * HEAVIEST * r->job->line_width * (float)quality);
    if (r->style == STYLE_SMART) { /* what is so near to a silhouette shows it */
        int reach = smart_reach(r);
        r->margin = r->margin < reach ? reach : r->margin;
    }
    if (contours_are_drawn(r->job)) { /* by 4 pixels of the result smoothed: three times that, and differences */
        int reach = 12 * quality + 4;
        r->margin = r->margin < reach ? reach : r->margin;
    }
    r->tile_width = (wide < most ? wide : most) + 2 * r->margin;
    r->tile_height = (tall < most ? tall : most) + 2 * r->margin;
    r->color = make_texture(GL_RGBA8, r->tile_width, r->tile_height);
    r->depth = make_texture(GL_DEPTH_COMPONENT32F, r->tile_width, r->tile_height);
    if (r->seal[0]) {
        r->canvas = make_framebuffer(r->color, 0);
        r->opaque_color = make_texture(GL_RGBA8, r->tile_width, r->tile_height);
        r->opaque_depth = make_texture(GL_DEPTH_COMPONENT32F, r->tile_width, r->tile_height);
        r->opaque = make_framebuffer(r->opaque_color, r->opaque_depth);
    }
    r->framebuffer = make_framebuffer(r->color, r->depth);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return broken(r, "the driver has no %d x %d target", r->tile_width, r->tile_height);
    return true;
}

/* The projection of a tile whose lower left drawn pixel is x, y, margin included. */
static void tile_projection(const renderer *r, int x, int y, double out[16]) {
    double wide = (double)r->job->width * r->job->quality, tall = (double)r->job->height * r->job->quality;
    double crop[16] = {0};
    crop[0] = wide / r->tile_width;
    crop[5] = tall / r->tile_height;
    crop[12] = crop[0] * (1 - 2.0 * x / wide) - 1;
    crop[13] = crop[5] * (1 - 2.0 * y / tall) - 1;
    crop[10] = crop[15] = 1;
    scene_multiply(crop, r->projection, out);
}

/* Diepstraten 2002, figure 2: a long dash and two short ones, in pixels of the picture. */
static void set_phantom(const renderer *r, sil_ribbon_desc *desc, float dashes[6]) {
    static const float pattern[6] = {16, 5, 4, 5, 4, 5};
    for (int i = 0; i < 6; ++i)
        dashes[i] = pattern[i] * (float)r->job->quality * fmaxf(1, r->job->line_width / 1.5f);
    desc->cap = SIL_CAP_BUTT;
    desc->dashes = dashes;
    desc->dash_count = 6;
}

static sil_ribbon_desc ribbon_desc(const renderer *r, const figure *f, const double projection[16]) {
    static const sil_weight weights[] = {SIL_WEIGHT_ONE, SIL_WEIGHT_THICK_THIN, SIL_WEIGHT_OUTER,
                                         SIL_WEIGHT_PERSPECTIVE, SIL_WEIGHT_LIGHT};
    sil_ribbon_desc desc;
    memset(&desc, 0, sizeof desc);
    to_float(f->model_view, desc.model_view);
    to_float(projection, desc.projection);
    desc.viewport_width = (float)r->tile_width;
    desc.viewport_height = (float)r->tile_height;
    desc.width = r->job->line_width * (float)r->job->quality;
    desc.width_scale[2] = 0.7f; /* creases, lighter than what bounds a shape */
    desc.weight = weights[r->job->weight];
    if (r->job->weight == WEIGHT_PERSPECTIVE || r->job->weight == WEIGHT_LIGHT) {
        desc.heavy = HEAVIEST;
        desc.thin = 0.6f;
    }
    desc.reach[0] = (float)r->reach[0];
    desc.reach[1] = (float)r->reach[1];
    desc.image = &r->drawn;
    return desc;
}

/* The ribbons of one figure in a tile: creases, outlines, smooth silhouettes. Counts without `out`. */
static void make_ribbons(const renderer *r, const figure *f, const sil_ribbon_desc *desc, sil_ribbon_vertex *out,
                         size_t count[3]) {
    const sil_mesh *mesh = r->surfaces[f->part->mesh].mesh;
    sil_ribbon_desc smooth = *desc;
    count[0] = sil_ribbons(mesh, NULL, f->strips, f->crease_strips, f->strip_vertices, desc, out, out ? count[0] : 0);
    out = out ? out + count[0] : NULL;
    count[1] = sil_ribbons(mesh, NULL, f->strips + f->crease_strips, f->strip_count - f->crease_strips,
                           f->strip_vertices, desc, out, out ? count[1] : 0);
    out = out ? out + count[1] : NULL;
    count[2] = 0;
    if (f->smooth) {
        smooth.points = f->smooth[0].position;
        smooth.point_stride = sizeof *f->smooth;
        smooth.point_count = f->smooth_count;
        count[2] =
            sil_ribbons(mesh, NULL, f->smooth_strips, f->smooth_strip_count, NULL, &smooth, out, out ? SIZE_MAX : 0);
    }
}

/* All of them once more, for where they are hidden: thin, in short dashes. */
static void make_hidden(const renderer *r, const figure *f, const sil_ribbon_desc *desc, sil_ribbon_vertex *out,
                        size_t count[3]) {
    const float unit = (float)r->job->quality * fmaxf(1, r->job->line_width / 1.5f);
    const float dashes[2] = {5 * unit, 3 * unit};
    sil_ribbon_desc thin = *desc;
    thin.width *= 0.6f;
    thin.weight = SIL_WEIGHT_ONE;
    thin.cap = SIL_CAP_BUTT;
    thin.dashes = dashes;
    thin.dash_count = 2;
    make_ribbons(r, f, &thin, out, count);
}

static bool upload_lines(renderer *r, figure *f, const double projection[16]) {
    sil_ribbon_desc desc = ribbon_desc(r, f, projection);
    float dashes[6];
    size_t count[3], hidden[3] = {0, 0, 0}, seen, all;
    if (!f->strips) /* a flattened part */
        return true;
    if (f->phantom)
        set_phantom(r, &desc, dashes);
    make_ribbons(r, f, &desc, NULL, count);
    if (r->job->hidden && !f->phantom)
        make_hidden(r, f, &desc, NULL, hidden);
    seen = count[0] + count[1] + count[2];
    all = seen + hidden[0] + hidden[1] + hidden[2];
    sil_ribbon_vertex *v = malloc((all + 1) * sizeof *v);
    if (!v)
        return no_memory(r);
    make_ribbons(r, f, &desc, v, count);
    if (all > seen)
        make_hidden(r, f, &desc, v + seen, hidden);
    glBindBuffer(GL_ARRAY_BUFFER, f->line_buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(all * sizeof *v), v, GL_STREAM_DRAW);
    f->crease_vertices = (GLsizei)count[0];
    f->outline_vertices = (GLsizei)(count[1] + count[2]);
    f->hidden_vertices = (GLsizei)(all - seen);
    free(v);
    return true;
}

/* What hides lines, and where nothing is. */
static bool draw_depths(renderer *r, const double projection[16], int width, int height, depth_image *image) {
    if (!depth_image_create(image, width, height))
        return no_memory(r);
    for (size_t i = 0; i < r->figure_count; ++i) {
        const figure *f = &r->figures[i];
        const surface *s = &r->surfaces[f->part->mesh];
        double to_clip[16];
        scene_multiply(projection, f->model_view, to_clip);
        if (!f->phantom)
            depth_image_draw(image, s->positions, s->vertex_count, s->indices, s->index_count, to_clip);
    }
    return true;
}

static bool upload_all_lines(renderer *r, const double projection[16]) {
    depth_image image = {NULL, 0, 0};
    bool ok = r->job->weight != WEIGHT_OUTER || draw_depths(r, projection, r->tile_width, r->tile_height, &image);
    r->drawn.depth = image.depth;
    r->drawn.width = (uint32_t)image.width;
    r->drawn.height = (uint32_t)image.height;
    for (size_t i = 0; ok && i < r->figure_count; ++i)
        ok = upload_lines(r, &r->figures[i], projection);
    depth_image_destroy(&image);
    return ok;
}

static bool is_dark(const float background[4]) {
    return background[3] >= 1.0f && 0.3f * background[0] + 0.6f * background[1] + 0.1f * background[2] < 0.4f;
}

static tr_frame make_frame(const renderer *r) {
    const illustrate_job *job = r->job;
    static const tr_blending blendings[] = {TR_BLENDING_OVER, TR_BLENDING_NORMALISED, TR_BLENDING_PUBLISHED};
    tr_frame frame;
    memset(&frame, 0, sizeof frame);
    frame.framebuffer = r->framebuffer;
    frame.width = r->tile_width;
    frame.height = r->tile_height;
    frame.scene = tr_scene_count(r->figures, r->figure_count, sizeof *r->figures);
    if (has_layers(r->style)) { /* what is transparent follows by itself */
        tr_scene all = frame.scene;
        memset(&frame.scene, 0, sizeof frame.scene);
        frame.scene.opaque = all.opaque;
        frame.scene.opaque_two_sided = all.opaque_two_sided;
    }
    frame.wishes.interior = r->interior;
    frame.wishes.layers = r->interior == TR_INTERIOR_LAYERS ? (uint32_t)job->layers : 0;
    frame.group_distance = (float)job->group_distance;
    if (job->enter > 0) {
        frame.wishes.options = TR_WISH_ENTERING;
        frame.enter_strength = job->enter;
        frame.enter_distance = (float)(0.06 * r->radius);
    }
    frame.wishes.blending = blendings[job->blending];
    frame.wishes.alpha = r->edge_sets > 0 ? r->alpha : TR_ALPHA_DISTANCE;
    frame.wishes.lines = (job->creases ? (uint32_t)TR_LINES_CREASES : 0u) |
                         (job->silhouettes || job->boundaries ? (uint32_t)TR_LINES_OUTLINES : 0u) |
                         (job->hidden ? (uint32_t)TR_LINES_HIDDEN : 0u);
    frame.opaque_weight = job->opaque_weight > 0 ? job->opaque_weight : job->opaque_weight == 0 ? -1.0f : 0.0f;
    frame.background_weight = job->background_weight > 0    ? job->background_weight
                              : job->background_weight == 0 ? -1.0f
                                                            : 0.0f;
    frame.flat_shading = r->style == STYLE_LINES || job->shade == SHADE_FLAT;
    frame.black_creases = r->style == STYLE_LINES;
    if (r->style == STYLE_LINES && is_dark(job->background)) { /* chalk on a blackboard */
        for (int k = 0; k < 3; ++k)
            frame.outline_color[k] = 1.0f;
        frame.black_creases = 0;
    }
    return frame;
}

static void draw_surface(renderer *r, const tr_pass *pass, const figure *f, const double projection[16]) {
    const surface *s = &r->surfaces[f->surface];
    bool paper = r->style == STYLE_LINES;
    double mvp[16];
    tr_material material;
    memset(&material, 0, sizeof material);
    scene_multiply(projection, f->model_view, mvp);
    to_float(mvp, material.model_view_projection);
    normal_matrix(f->model_view, material.normal_matrix);
    for (int k = 0; k < 3; ++k)
        material.color[k] = paper       ? (r->job->background[3] < 1.0f ? 1.0f : r->job->background[k])
                            : s->colors ? 0.0f
                                        : f->part->color[k];
    material.color[3] = 1.0f;
    material.d_max = f->d_max;
    material.k = (float)wanted_k(r);
    material.edges = &f->alpha_edges;
    material.object = tr_object_code(&f->object, &r->wishes);
    to_float(f->model_view, material.model);
    material.crossing_first = f->crossing_first;
    material.crossing_count = f->crossing_count;
    tr_set_material(r->tr, pass, &material);
    glFrontFace(f->mirrored != s->inward ? GL_CW : GL_CCW);
    glBindVertexArray(f->array);
    if (paper)
        glDisableVertexAttribArray(3);
    glDrawElements(GL_TRIANGLES, (GLsizei)s->index_count, GL_UNSIGNED_INT, NULL);
}

static void draw_pass(renderer *r, const tr_pass *pass, const double projection[16]) {
    for (size_t i = 0; i < r->figure_count; ++i) {
        const figure *f = &r->figures[i];
        if (!tr_pass_draws(pass, &f->object))
            continue;
        if (!pass->lines) {
            if (!f->phantom)
                draw_surface(r, pass, f, projection);
            continue;
        }
        glBindVertexArray(f->line_array);
        GLint first = pass->lines == TR_LINES_CREASES    ? 0
                      : pass->lines == TR_LINES_OUTLINES ? f->crease_vertices
                                                         : f->crease_vertices + f->outline_vertices;
        glDrawArrays(GL_TRIANGLES, first,
                     pass->lines == TR_LINES_CREASES    ? f->crease_vertices
                     : pass->lines == TR_LINES_OUTLINES ? f->outline_vertices
                                                        : f->hidden_vertices);
    }
}

/* Milliseconds by pass of the plan; those that the header draws itself lie between two that it hands out. */
static void add_time(renderer *r, const tr_pass *pass, int *index, double *since) {
    const tr_plan *plan = tr_get_info(r->tr).plan;
    if (!r->job->explain)
        return;
    glFinish();
    double now = now_ms();
    while (*index < plan->pass_count &&
           (!pass || plan->passes[*index].kind != pass->kind || plan->passes[*index].classes != pass->classes ||
            plan->passes[*index].lines != pass->lines)) {
        r->pass_ms[(*index)++] += now - *since;
        *since = now;
    }
}

/* ---- glass: every layer of what is transparent, and its lines among them ---------------------------------------- */

static const char *style_name(illustrate_style style) {
    static const char *const names[] = {"auto", "hodges", "lines", "opaque", "glass", "smart", "curvature"};
    return names[style];
}

/* What goes wrong is said in one line by whoever is told the result. */
static void oit_said(oit_log_level level, oit_result code, const char *what, void *user) {
    (void)level, (void)code;
    if (((const illustrate_job *)user)->verbose)
        fprintf(stderr, "%s\n", what);
}

/* A program of the two texts behind the header's. */
static GLuint make_storing(const renderer *r, oit_pass_kind kind, const char *const own[2]) {
    static const GLenum types[2] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
    GLuint program = glCreateProgram();
    GLint linked = 0;
    for (int stage = 0; stage < 2; ++stage) {
        const char *strings[OIT_I_MAX_STRINGS + 1];
        int count = 0;
        const char *const *first = oit_glsl(r->oit, (oit_stage)stage, kind, &count);
        GLuint shader = glCreateShader(types[stage]);
        memcpy(strings, first, (size_t)count * sizeof *strings);
        strings[count] = own[stage];
        glShaderSource(shader, count + 1, strings, NULL);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked)
        return program;
    glDeleteProgram(program);
    return 0;
}

/* No surface, so that operators leave it as it is. */
#define STORE_LINE                                                                                                     \
    "#if OIT_HAS_BLEND && OIT_PASS == OIT_FILL\n"                                                                      \
    "    oit_fragment f;\n    f.color = ink;\n    f.part = 0u;\n    f.normal = vec3(0.0, 0.0, 1.0);\n"                 \
    "    f.blend = OIT_BLEND_LINE;\n    oit_store(f);\n#else\n    oit_store(ink);\n#endif\n}\n"

/* Ribbons as fragments like any other, so that lines behind glass look as if behind glass. */
static GLuint make_ink(const renderer *r, oit_pass_kind kind) {
    static const char *const own[2] = {
        "layout(location = 0) in vec4 corner; // x, y in pixels, window depth, depth per pixel toward the eye\n"
        "uniform vec2 size;\n"
        "void main() {\n"
        "    float z = clamp(corner.z - 2.0 * corner.w, 0.0, 1.0);\n"
        "    gl_Position = vec4(2.0 * corner.xy / size - 1.0, 2.0 * z - 1.0, 1.0);\n}\n",
        "uniform vec4 ink;\nvoid main() {\n" STORE_LINE};
    return make_storing(r, kind, own);
}

/* Opaque parts as they were drawn before, where they are in front; the same vertex as drew them then but for rounding, since
   the matrices are multiplied in another order: some 30 steps of a float at depth 1 are let pass. */
static GLuint make_seal(const renderer *r, oit_pass_kind kind) {
    static const char *const own[2] = {
        "layout(location = 0) in vec3 place;\nuniform mat4 whole;\n"
        "void main() {\n    gl_Position = whole * vec4(place, 1.0);\n}\n",
        "uniform highp sampler2D colors, depths;\nvoid main() {\n"
        "    if (gl_FragCoord.z > texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r + 2.0e-6)\n        discard;\n"
        "    vec4 ink = vec4(texelFetch(colors, ivec2(gl_FragCoord.xy), 0).rgb, 1.0);\n" STORE_LINE};
    return make_storing(r, kind, own);
}

static bool has_opaque(const renderer *r) {
    for (size_t i = 0; i < r->figure_count; ++i)
        if (!(r->figures[i].object.flags & TR_TRANSPARENT) && !r->figures[i].phantom)
            return true;
    return false;
}

static bool start_glass(renderer *r, oit_proc (*get_proc)(const char *)) {
    oit_desc desc;
    oit_result result;
    memset(&desc, 0, sizeof desc);
    desc.get_proc = get_proc;
    desc.log_fn = oit_said;
    desc.log_user = (void *)(uintptr_t)r->job;
    desc.state = OIT_STATE_LEAVE_DEFAULTS;
    if (r->job->style == STYLE_GLASS)
        desc.alpha_law = r->job->adaptive ? OIT_ALPHA_ADAPTIVE : OIT_ALPHA_CONSTANT;
    else
        desc.fields = OIT_FIELD_BLEND | OIT_FIELD_PART | OIT_FIELD_NORMAL; /* lines are no surfaces */
    if (r->job->style == STYLE_SMART)
        desc.operators = r->job->iterations < 0 ? OIT_OPERATE_LINKS | OIT_OPERATE_LAW : OIT_OPERATE_SMART;
    if (r->job->style == STYLE_CURVATURE)
        desc.operators = OIT_OPERATE_CURVATURE | (r->job->law == LAW_DISTANCE ? OIT_OPERATE_SMART : 0);
    if (r->job->style != STYLE_GLASS && contours_are_drawn(r->job))
        desc.operators |= OIT_OPERATE_CONTOURS;
    desc.ceiling_bytes = r->job->style == STYLE_GLASS ? 0 : (int64_t)2 << 30; /* operators need all of a tile at once */
    r->oit = oit_create(&desc, &result);
    if (!r->oit)
        return broken(r, "--style %s: %s; --style hodges needs less", style_name(r->job->style),
                      oit_result_string(result));
    for (int i = 0; i < 2; ++i) {
        bool seals = r->job->style != STYLE_GLASS;
        r->ink[i] = make_ink(r, i ? OIT_PASS_FILL : OIT_PASS_COUNT);
        r->seal[i] = seals ? make_seal(r, i ? OIT_PASS_FILL : OIT_PASS_COUNT) : 0;
        if (!r->ink[i] || (seals && !r->seal[i]))
            return broken(r, "the driver's compiler refuses a shader for lines");
    }
    return true;
}

static void draw_glass_surface(renderer *r, const oit_pass *pass, const figure *f, const double projection[16]) {
    const surface *s = &r->surfaces[f->surface];
    oit_material material;
    double mvp[16];
    memset(&material, 0, sizeof material);
    scene_multiply(projection, f->model_view, mvp);
    to_float(mvp, material.model_view_projection);
    normal_matrix(f->model_view, material.normal_matrix);
    for (int k = 0; k < 3; ++k)
        material.color[k] = s->colors ? 0.0f : f->part->color[k];
    material.part = (uint32_t)(f - r->figures) + 1;
    material.color[3] = f->part->opacity < 1.0f  ? f->part->opacity
                        : r->job->opacity > 0.0f ? r->job->opacity
                        : r->job->adaptive       ? 0.7f
                                                 : 0.3f;
    material.two_sided = s->sheet;
    glFrontFace(f->mirrored ? GL_CW : GL_CCW);
    oit_set_material(r->oit, pass, &material);
    glBindVertexArray(f->array);
    glDrawElements(GL_TRIANGLES, (GLsizei)s->index_count, GL_UNSIGNED_INT, NULL);
}

/* Creases are light and outlines dark, as in the other styles. */
static void draw_glass_lines(const renderer *r, const oit_pass *pass, const figure *f) {
    const GLuint program = r->ink[pass->kind == OIT_PASS_FILL];
    const GLint ink = glGetUniformLocation(program, "ink");
    glUseProgram(program);
    glUniform2f(glGetUniformLocation(program, "size"), (float)r->tile_width, (float)r->tile_height);
    glBindVertexArray(f->line_array);
    if (r->job->creases && f->crease_vertices) {
        glUniform4f(ink, 1.0f, 1.0f, 1.0f, 0.8f);
        glDrawArrays(GL_TRIANGLES, 0, f->crease_vertices);
    }
    if (f->outline_vertices) {
        glUniform4f(ink, 0.0f, 0.0f, 0.0f, 1.0f);
        glDrawArrays(GL_TRIANGLES, f->crease_vertices, f->outline_vertices);
    }
    glUseProgram(pass->state.program);
}

/* Operators take a surface to end where it has no fragment, and where something opaque hides it there would be none: a rim
 * around every bolt. So all of it is stored, and what hides it as well: opaque fragments at the depths of opaque parts. */
static void copy_opaque(const renderer *r) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, r->framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, r->opaque);
    glDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(0, 0, r->tile_width, r->tile_height, 0, 0, r->tile_width, r->tile_height,
                      GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

static void draw_seals(const renderer *r, const oit_pass *pass, const double projection[16]) {
    const GLuint program = r->seal[pass->kind == OIT_PASS_FILL];
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "depths"), 1);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, r->opaque_depth);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, r->opaque_color);
    for (size_t i = 0; i < r->figure_count; ++i) {
        const figure *f = &r->figures[i];
        double mvp[16];
        float whole[16];
        if (f->object.flags & TR_TRANSPARENT || f->phantom)
            continue;
        scene_multiply(projection, f->model_view, mvp);
        to_float(mvp, whole);
        glUniformMatrix4fv(glGetUniformLocation(program, "whole"), 1, GL_FALSE, whole);
        glBindVertexArray(f->array);
        glDrawElements(GL_TRIANGLES, (GLsizei)r->surfaces[f->surface].index_count, GL_UNSIGNED_INT, NULL);
    }
    glUseProgram(pass->state.program);
}

static oit_operator link_operator(const renderer *r) {
    static const oit_criterion criteria[] = {OIT_LINK_DEPTH, OIT_LINK_MURRAY, OIT_LINK_MURRAY, OIT_LINK_PUBLISHED};
    oit_operator op;
    memset(&op, 0, sizeof op);
    op.kind = OIT_RUN_LINK;
    op.link.radius = (float)r->radius;
    op.link.criterion = criteria[r->job->neighbours];
    op.link.no_reverse_check = r->job->neighbours == NEIGHBOURS_ONE_SIDED;
    return op;
}

/* Opacity that layers start with. */
static oit_operator law_operator(const illustrate_job *job) {
    static const oit_law_kind kinds[] = {OIT_LAW_ADAPTIVE, OIT_LAW_GIVEN,     OIT_LAW_CONSTANT, OIT_LAW_ADAPTIVE,
                                         OIT_LAW_ANGLE,    OIT_LAW_VARIATION, OIT_LAW_DISTANCE};
    oit_operator op;
    memset(&op, 0, sizeof op);
    op.kind = OIT_RUN_LAW;
    op.law.kind = kinds[job->law];
    op.law.s = job->law_opacity > 0.0f ? job->law_opacity : op.law.kind == OIT_LAW_ADAPTIVE ? 0.6f : 0.3f;
    op.law.reach = (float)(silhouette_reach(job) * job->quality);
    return op;
}

/* Reaches are pixels of the result, of which each is several drawn ones. */
static oit_operator smart_operator(const illustrate_job *job) {
    int silhouette = silhouette_reach(job) * job->quality, halo = halo_reach(job);
    oit_operator op;
    memset(&op, 0, sizeof op);
    op.kind = OIT_RUN_SMART;
    op.smart.jumps = 1;
    op.smart.base.iterations = 20 * job->quality;
    op.smart.beta.iterations = silhouette;
    op.smart.beta.lambda = 1.0f / (float)silhouette;
    op.smart.beta.profile = OIT_PROFILE_10;
    op.smart.gamma.iterations = halo > 0 ? halo : -1;
    op.smart.gamma.lambda = halo > 0 ? 1.0f / (float)halo : 1.0f;
    op.smart.gamma.profile = OIT_PROFILE_11;
    op.smart.gamma.p = 1.0f;
    return op;
}

static void add_contours(const illustrate_job *job, oit_curvature *curvature) {
    if (!contours_are_drawn(job))
        return;
    curvature->contours = OIT_CONTOURS_SUGGESTIVE;
    curvature->contour_width = 1.2f * (float)job->quality;
    curvature->contour_iterations = 64 * job->quality * job->quality; /* 4 pixels of the result */
    curvature->contour_least = (float)fmax(job->contours, 0);
}

static oit_operator curvature_operator(const renderer *r) {
    const illustrate_job *job = r->job;
    bool none = !(job->shade_convex || job->shade_curved || job->opacity_front || job->opacity_deep || job->shades ||
                  job->opacities);
    oit_operator op;
    memset(&op, 0, sizeof op);
    op.kind = OIT_RUN_CURVATURE;
    op.curvature.unit = (float)(0.06 * r->radius); /* radii of a tenth of the scene bend well */
    add_contours(job, &op.curvature);
    if (r->style == STYLE_SMART) /* contours alone */
        return op;
    op.curvature.shade = job->shade_curved           ? OIT_SHADE_CURVED
                         : job->shade_convex || none ? OIT_SHADE_CONVEX
                                                     : OIT_SHADE_NONE;
    op.curvature.opacity = job->opacity_front          ? OIT_OPACITY_FRONT
                           : job->opacity_deep || none ? OIT_OPACITY_DEEP
                                                       : OIT_OPACITY_NONE;
    op.curvature.shades = job->shades;
    op.curvature.opacities = job->opacities;
    op.curvature.first = (float)r->reach[0];
    op.curvature.last = (float)r->reach[1];
    return op;
}

/* What a stage took since the one before, and what buffers it has added. */
static void end_stage(renderer *r, glass_stage stage) {
    if (!r->job->explain)
        return;
    glFinish();
    double now = now_ms();
    uint64_t held = oit_get_info(r->oit).bytes;
    r->costs[stage].run = true;
    r->costs[stage].ms += now - r->since;
    r->costs[stage].bytes += (int64_t)held - (int64_t)r->held;
    r->since = now;
    r->held = held;
}

/* Smart transparency, or curvature, on what has been stored. */
static oit_result operate(renderer *r) {
    oit_operator ops[5];
    size_t count = 0;
    bool late = r->job->law == LAW_DISTANCE, is_smart = r->style == STYLE_SMART && r->job->iterations >= 0;
    ops[count++] = link_operator(r);
    if (!late)
        ops[count++] = law_operator(r->job);
    if (is_smart || late)
        ops[count++] = smart_operator(r->job);
    if (late) /* by the distances that SMART has found */
        ops[count++] = law_operator(r->job);
    if (r->style == STYLE_CURVATURE || contours_are_drawn(r->job))
        ops[count++] = curvature_operator(r);
    oit_result result = OIT_OK;
    for (size_t i = 0; i < count && result == OIT_OK; ++i) {
        static const glass_stage stages[] = {GLASS_LINK, GLASS_LAW, GLASS_SMART, GLASS_CURVATURE}; /* by oit_run_kind */
        result = oit_run(r->oit, &ops[i]);
        if (result == OIT_OK)
            end_stage(r, stages[ops[i].kind]);
    }
    return result;
}

static void count_fragments(renderer *r) {
    oit_report report;
    if (!r->job->explain || oit_get_report(r->oit, &report) != OIT_OK)
        return;
    r->most_fragments = report.needed > r->most_fragments ? report.needed : r->most_fragments;
    r->deepest = report.deepest > r->deepest ? report.deepest : r->deepest;
    ++r->tiles;
}

static bool draw_glass(renderer *r, const double projection[16]) {
    oit_frame frame;
    oit_pass pass;
    double begun = r->since = now_ms();
    memset(&frame, 0, sizeof frame);
    bool sealed = r->seal[0] && has_opaque(r);
    if (sealed)
        copy_opaque(r);
    frame.framebuffer = sealed ? r->canvas : r->framebuffer;
    frame.width = r->tile_width;
    frame.height = r->tile_height;
    to_float(projection, frame.projection);
    if (r->job->shade != SHADE_FLAT) { /* as transparency.h lights by default */
        frame.light[0] = -0.45f;
        frame.light[1] = 0.65f;
        frame.light[2] = 0.62f;
    }
    oit_result result = oit_begin(r->oit, &frame);
    if (result != OIT_OK)
        return broken(r, "%s", oit_result_string(result));
    while (oit_next_pass(r->oit, &pass)) {
        for (size_t i = 0; i < r->figure_count; ++i)
            if (r->figures[i].object.flags & TR_TRANSPARENT) {
                draw_glass_surface(r, &pass, &r->figures[i], projection);
                draw_glass_lines(r, &pass, &r->figures[i]);
            }
        if (sealed)
            draw_seals(r, &pass, projection);
    }
    end_stage(r, GLASS_STORE);
    if (r->style != STYLE_GLASS)
        result = operate(r);
    r->tile_too_large = result == OIT_TOO_LARGE;
    oit_result composed = oit_compose(r->oit);
    result = result == OIT_OK ? composed : result;
    end_stage(r, GLASS_COMPOSE);
    oit_result end = oit_end(r->oit);
    if (r->tile_too_large)
        return broken(r, "more layers than the driver's storage blocks hold, even in small tiles");
    if (result != OIT_OK || end != OIT_OK)
        return broken(r, "%s", oit_result_string(result != OIT_OK ? result : end));
    count_fragments(r);
    r->glass_ms += now_ms() - begun;
    return true;
}

static bool draw_tile(renderer *r, int x, int y, const float background[3]) {
    tr_frame frame = make_frame(r);
    tr_pass pass;
    double projection[16], since;
    int index = 0;
    tile_projection(r, x - r->margin, y - r->margin, projection);
    to_float(projection, frame.projection);
    r->wishes = frame.wishes;
    if (!upload_all_lines(r, projection))
        return false;
    glBindFramebuffer(GL_FRAMEBUFFER, r->framebuffer);
    glViewport(0, 0, r->tile_width, r->tile_height);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(background[0], background[1], background[2], 1.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    tr_result result = tr_begin(r->tr, &frame);
    if (result != TR_OK)
        return broken(r, "%s", tr_result_string(result));
    glFinish();
    since = now_ms();
    while (tr_next_pass(r->tr, &pass)) {
        add_time(r, &pass, &index, &since);
        draw_pass(r, &pass, projection);
        if (r->job->explain) {
            glFinish();
            double now = now_ms();
            r->pass_ms[index++] += now - since;
            since = now;
        }
    }
    add_time(r, NULL, &index, &since);
    tr_end(r->tr);
    return !has_layers(r->style) || draw_glass(r, projection);
}

/* Averages quality x quality drawn pixels into each pixel of the picture; rows run down in it. */
static void average_tile(const renderer *r, const unsigned char *drawn, int x, int y, float *picture) {
    int q = r->job->quality, inner_width = r->tile_width - 2 * r->margin, inner_height = r->tile_height - 2 * r->margin;
    for (int py = 0; py < inner_height / q && y / q + py < r->job->height; ++py) {
        float *row = picture + (size_t)(r->job->height - 1 - (y / q + py)) * (size_t)r->job->width * 3;
        for (int px = 0; px < inner_width / q && x / q + px < r->job->width; ++px) {
            int sum[3] = {0, 0, 0};
            for (int sy = 0; sy < q; ++sy)
                for (int sx = 0; sx < q; ++sx) {
                    const unsigned char *p = drawn + 4 * ((size_t)(r->margin + py * q + sy) * (size_t)r->tile_width +
                                                          (size_t)(r->margin + px * q + sx));
                    for (int k = 0; k < 3; ++k)
                        sum[k] += p[k];
                }
            for (int k = 0; k < 3; ++k)
                row[3 * (x / q + px) + k] = (float)sum[k] / (float)(255 * q * q);
        }
    }
}

static bool draw_picture(renderer *r, const float background[3], float *picture) {
    int wide = r->job->width * r->job->quality, tall = r->job->height * r->job->quality;
    int step_x = r->tile_width - 2 * r->margin, step_y = r->tile_height - 2 * r->margin, done = 0;
    int tiles = ((wide + step_x - 1) / step_x) * ((tall + step_y - 1) / step_y);
    unsigned char *drawn = malloc((size_t)r->tile_width * (size_t)r->tile_height * 4);
    bool ok = drawn ? true : no_memory(r);
    for (int y = 0; ok && y < tall; y += step_y)
        for (int x = 0; ok && x < wide; x += step_x) {
            ok = draw_tile(r, x, y, background);
            if (!ok)
                break;
            glBindFramebuffer(GL_FRAMEBUFFER, r->framebuffer);
            glPixelStorei(GL_PACK_ALIGNMENT, 1);
            glReadPixels(0, 0, r->tile_width, r->tile_height, GL_RGBA, GL_UNSIGNED_BYTE, drawn);
            average_tile(r, drawn, x, y, picture);
            report(r, "drawing", (double)++done / tiles);
        }
    free(drawn);
    return ok;
}

/* A background that is see-through is found out by drawing on white and on black: what differs shines through. */
static bool draw(renderer *r) {
    const illustrate_job *job = r->job;
    size_t pixels = (size_t)job->width * (size_t)job->height;
    static const float white[3] = {1, 1, 1}, black[3] = {0, 0, 0};
    bool see_through = job->background[3] < 1.0f;
    float *first = malloc(pixels * 3 * sizeof *first),
          *second = see_through ? malloc(pixels * 3 * sizeof *second) : NULL;
    unsigned char *out = malloc(pixels * 4);
    bool ok = first && out && (second || !see_through) ? true : no_memory(r);
    ok = ok && draw_picture(r, see_through ? white : job->background, first) &&
         (!see_through || draw_picture(r, black, second));
    for (size_t i = 0; ok && i < pixels; ++i) {
        float opacity = 1.0f;
        if (see_through) {
            float shine = 0;
            for (size_t k = 0; k < 3; ++k)
                shine += (first[3 * i + k] - second[3 * i + k]) / 3.0f;
            opacity = 1.0f - fminf(fmaxf(shine, 0.0f), 1.0f);
        }
        for (size_t k = 0; k < 3; ++k) {
            float c = see_through ? (opacity > 0.0f ? second[3 * i + k] / opacity : 0.0f) : first[3 * i + k];
            out[4 * i + k] = (unsigned char)(fminf(c, 1.0f) * 255.0f + 0.5f);
        }
        out[4 * i + 3] = (unsigned char)(opacity * 255.0f + 0.5f);
    }
    free(first);
    free(second);
    if (!ok) {
        free(out);
        return false;
    }
    r->result->rgba = out;
    return true;
}

static void drop_target(renderer *r) {
    const GLuint textures[4] = {r->color, r->depth, r->opaque_color, r->opaque_depth};
    const GLuint framebuffers[3] = {r->framebuffer, r->canvas, r->opaque};
    glDeleteFramebuffers(3, framebuffers);
    glDeleteTextures(4, textures);
}

static void stop_glass(renderer *r) {
    for (int i = 0; i < 2; ++i) {
        if (r->ink[i])
            glDeleteProgram(r->ink[i]);
        if (r->seal[i])
            glDeleteProgram(r->seal[i]);
        r->ink[i] = r->seal[i] = 0;
    }
    oit_destroy(r->oit);
    r->oit = NULL;
}

/* Operators need all fragments of a tile at once. Where they are more than a storage block of the driver's holds, tiles of
 * half the width and height are drawn, from a buffer that is as small. */
static bool draw_in_tiles(renderer *r, oit_proc (*get_proc)(const char *)) {
    for (r->tile = TILE;; r->tile /= 2) {
        r->tile_too_large = false;
        bool ok = make_target(r) && draw(r);
        if (ok || !r->tile_too_large || r->tile / 2 < SMALLEST_TILE)
            return ok;
        drop_target(r);
        stop_glass(r);
        memset(r->costs, 0, sizeof r->costs);
        r->glass_ms = 0;
        r->held = 0;
        if (!start_glass(r, get_proc))
            return false;
    }
}

/* ---- what was done --------------------------------------------------------------------------------------------- */

typedef struct text {
    char *at;
    size_t length, capacity;
    bool failed;
} text;

static void put(text *t, const char *format, ...) {
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    int needed = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    if (needed >= 0 && !t->failed && t->length + (size_t)needed + 1 > t->capacity) {
        size_t capacity = 2 * t->capacity + (size_t)needed + 256;
        char *grown = realloc(t->at, capacity);
        t->failed = !grown;
        t->at = grown ? grown : t->at;
        t->capacity = grown ? capacity : t->capacity;
    }
    if (needed >= 0 && !t->failed)
        t->length += (size_t)vsnprintf(t->at + t->length, t->capacity - t->length, format, again);
    va_end(again);
}

/* As JSON has it; bytes that are no UTF-8 are taken for Latin-1. */
static void put_string(text *t, const char *string) {
    put(t, "\"");
    while (*string) {
        int length = utf8_length(string);
        if (*string == '"' || *string == '\\')
            put(t, "\\%c", *string);
        else if (length == 0 || (unsigned char)*string < 32)
            put(t, "\\u%04x", (unsigned)(unsigned char)*string);
        else
            put(t, "%.*s", length, string);
        string += length ? length : 1;
    }
    put(t, "\"");
}

static const char *alpha_name(tr_alpha alpha) {
    static const char *const names[TR_ALPHA_COUNT] = {"distance at vertices", "published", "candidates", "exact"};
    return names[alpha];
}

static const char *interior_name(tr_interior interior) {
    static const char *const names[] = {"implicit", "published", "explicit", "chosen part by part", "layers"};
    return names[interior];
}

static const char *drawn_interior(const renderer *r) {
    const tr_plan *plan = tr_get_info(r->tr).plan;
    return plan->mixed ? "mixed" : interior_name(plan->interior);
}

/* The stages of glass, which have no place in the plan of transparency.h. */
static void put_stages(const renderer *r, text *t, bool first) {
    static const char *const said[GLASS_STAGES][2] = {
        {"store", "every fragment of what is transparent, and of lines, is counted, then kept"},
        {"link", "neighbours along each surface, by depth and normal"},
        {"law", "the opacity that a layer starts with"},
        {"smart", "silhouettes strengthened, halos before what lies behind them"},
        {"curvature", "opacity and shade by curvature"},
        {"compose", "layers over one another, from the eye on"}};
    for (int i = 0; i < GLASS_STAGES; ++i)
        if (r->costs[i].run) {
            put(t, "%s\n    {\"pass\": \"%s\", \"why\": \"%s\", \"milliseconds\": %.3f, \"bytes\": %lld}",
                first ? "" : ",", said[i][0], said[i][1], r->costs[i].ms, (long long)r->costs[i].bytes);
            first = false;
        }
}

static void put_passes(const renderer *r, text *t) {
    tr_info info = tr_get_info(r->tr);
    unsigned long long pixels = (unsigned long long)r->tile_width * (unsigned long long)r->tile_height;
    put(t, "  \"passes\": [");
    for (int i = 0; i < info.plan->pass_count; ++i) {
        const tr_plan_pass *pass = &info.plan->passes[i];
        put(t, "%s\n    {\"pass\": \"%s\", \"why\": ", i ? "," : "", tr_pass_kind_name(pass->kind));
        put_string(t, pass->why);
        put(t, ", \"milliseconds\": %.3f, \"bytes\": %llu}", r->pass_ms[i], pass->bytes_per_pixel * pixels);
    }
    put_stages(r, t, info.plan->pass_count == 0);
    put(t, "\n  ],\n  \"bytes_per_pixel\": %u,\n  \"bytes\": %llu\n", (unsigned)info.plan->bytes_per_pixel,
        (unsigned long long)info.bytes);
}

static void explain(renderer *r) {
    text t = {NULL, 0, 0, false};
    size_t listed = 0;
    put(&t, "{\n  \"style\": \"%s\",\n  \"interior\": \"%s\",\n  \"alpha\": \"%s\",\n  \"transparent\": [",
        style_name(r->style), drawn_interior(r), alpha_name(r->alpha));
    for (size_t i = 0; i < r->figure_count; ++i)
        if (r->figures[i].object.flags & TR_TRANSPARENT) {
            put(&t, listed++ ? ", " : "");
            put_string(&t, r->figures[i].part->name);
        }
    put(&t,
        "],\n  \"parts\": %zu,\n  \"drawn_width\": %d,\n  \"drawn_height\": %d,\n  \"geometry_milliseconds\": %.3f,\n",
        r->figure_count, r->job->width * r->job->quality, r->job->height * r->job->quality, r->cpu_ms);
    if (has_layers(r->style)) {
        put(&t,
            "  \"glass\": {\"milliseconds\": %.3f, \"tiles\": %d, \"fragments\": %u, \"deepest\": %u, \"bytes\": "
            "%llu},\n",
            r->glass_ms, r->tiles, (unsigned)r->most_fragments, (unsigned)r->deepest,
            (unsigned long long)oit_get_info(r->oit).bytes);
    }
    put_passes(r, &t);
    put(&t, "}\n");
    r->result->explain_json = t.failed ? NULL : t.at;
    if (t.failed)
        free(t.at);
}

/* ---- the whole ------------------------------------------------------------------------------------------------- */

/* Where the ray from `start` along `direction` meets a triangle, as a multiple of direction; infinite where it does not. */
static double meet_triangle(const surface *s, size_t triangle, const double start[3], const double direction[3]) {
    const uint32_t *v = s->indices + 3 * triangle;
    double e[2][3], o[3], p[3], q[3], det = 0, u = 0, w = 0, t = 0;
    for (int k = 0; k < 3; ++k) {
        double corner = (double)s->positions[3 * v[0] + (size_t)k];
        e[0][k] = (double)s->positions[3 * v[1] + (size_t)k] - corner;
        e[1][k] = (double)s->positions[3 * v[2] + (size_t)k] - corner;
        o[k] = start[k] - corner;
    }
    for (int k = 0; k < 3; ++k) {
        int a = (k + 1) % 3, b = (k + 2) % 3;
        p[k] = direction[a] * e[1][b] - direction[b] * e[1][a];
        q[k] = o[a] * e[0][b] - o[b] * e[0][a];
    }
    for (int k = 0; k < 3; ++k) {
        det += e[0][k] * p[k];
        u += o[k] * p[k];
        w += direction[k] * q[k];
        t += e[1][k] * q[k];
    }
    if (det == 0 || u / det < 0 || w / det < 0 || (u + w) / det > 1)
        return HUGE_VAL;
    return t / det;
}

/* How thick the surface is behind one of its triangles, as a share of its size; infinite where nothing is behind. */
static double thickness_behind(const surface *s, size_t triangle, double size) {
    const uint32_t *v = s->indices + 3 * triangle;
    double middle[3] = {0, 0, 0}, e[2][3], inward[3], length = 0, nearest = HUGE_VAL;
    for (int k = 0; k < 3; ++k) {
        for (int c = 0; c < 3; ++c)
            middle[k] += (double)s->positions[3 * v[c] + (size_t)k] / 3;
        e[0][k] = (double)s->positions[3 * v[1] + (size_t)k] - (double)s->positions[3 * v[0] + (size_t)k];
        e[1][k] = (double)s->positions[3 * v[2] + (size_t)k] - (double)s->positions[3 * v[0] + (size_t)k];
    }
    for (int k = 0; k < 3; ++k) {
        int a = (k + 1) % 3, b = (k + 2) % 3;
        inward[k] = (s->inward ? 1 : -1) * (e[0][a] * e[1][b] - e[0][b] * e[1][a]);
        length += inward[k] * inward[k];
    }
    for (int k = 0; k < 3; ++k)
        inward[k] *= length > 0 ? size / sqrt(length) : 0;
    for (size_t t = 0; 3 * t + 2 < s->index_count; ++t) {
        double at = t == triangle ? HUGE_VAL : meet_triangle(s, t, middle, inward);
        if (at > 1e-6 && at < nearest)
            nearest = at;
    }
    return nearest;
}

/* Whether inner walls are modelled: most of the surface has its other side close behind it. */
static bool is_thin_walled(const surface *s) {
    size_t triangles = s->index_count / 3, step = triangles / 48 + 1, tried = 0, thin = 0;
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, size = 0;
    for (size_t i = 0; i < 3 * s->vertex_count; ++i) {
        low[i % 3] = fmin(low[i % 3], (double)s->positions[i]);
        high[i % 3] = fmax(high[i % 3], (double)s->positions[i]);
    }
    for (int k = 0; k < 3; ++k)
        size += (high[k] - low[k]) * (high[k] - low[k]);
    for (size_t t = step / 2; t < triangles; t += step, ++tried)
        thin += thickness_behind(s, t, sqrt(size)) < 0.1;
    return 2 * thin > tried;
}

/* Closed parts are told for themselves: thin walls mean that what is inside lies in a hollow, not in the solid. Sheets
 * go with the larger ones. */
static void note_interiors(renderer *r) {
    double hollow = 0, solid = 0;
    for (size_t i = 0; i < r->figure_count; ++i) {
        figure *f = &r->figures[i];
        const surface *s = &r->surfaces[f->part->mesh];
        if (!(f->object.flags & TR_TRANSPARENT) || s->sheet)
            continue;
        bool thin = is_thin_walled(s);
        f->object.flags |= TR_CLOSED | (thin ? 0u : (uint32_t)TR_HOLDING);
        *(thin ? &hollow : &solid) += s->box_volume;
    }
    for (size_t i = 0; i < r->figure_count; ++i)
        if ((r->figures[i].object.flags & (TR_TRANSPARENT | TR_CLOSED)) == TR_TRANSPARENT)
            r->figures[i].object.flags |= hollow > solid ? TR_EXPLICIT : TR_IMPLICIT;
}

static tr_interior choose_interior(renderer *r) {
    static const tr_interior interiors[] = {TR_INTERIOR_AUTO, TR_INTERIOR_IMPLICIT, TR_INTERIOR_EXPLICIT,
                                            TR_INTERIOR_IMPLICIT_PUBLISHED, TR_INTERIOR_LAYERS};
    if (r->job->interior == INTERIOR_AUTO)
        note_interiors(r);
    return interiors[r->job->interior];
}

static tr_mesh crossing_mesh(const renderer *r, const figure *f) {
    const surface *s = &r->surfaces[f->part->mesh];
    tr_mesh mesh;
    mesh.positions = s->positions;
    mesh.indices = s->indices;
    mesh.vertex_count = s->vertex_count;
    mesh.index_count = s->index_count;
    to_float(f->model_view, mesh.model);
    return mesh;
}

/* Where opaque parts enter transparent ones, in eye space. */
static bool find_crossings(renderer *r) {
    tr_mesh *others = malloc((r->figure_count + 1) * sizeof *others);
    size_t other_count = 0, total = 0;
    float *segments = NULL;
    bool ok = others != NULL;
    for (size_t i = 0; ok && i < r->figure_count; ++i)
        if (r->figures[i].object.flags & TR_TRANSPARENT)
            others[other_count++] = crossing_mesh(r, &r->figures[i]);
    for (size_t i = 0; ok && i < r->figure_count; ++i) {
        figure *f = &r->figures[i];
        tr_mesh mesh = crossing_mesh(r, f);
        bool opaque = !(f->object.flags & TR_TRANSPARENT);
        size_t count = opaque ? tr_crossings(&mesh, others, other_count, NULL, 0) : 0;
        float *more = count < SIZE_MAX / 64 - total ? realloc(segments, (total + count + 1) * 6 * sizeof *more) : NULL;
        segments = more ? more : segments;
        ok = more != NULL;
        if (ok && count)
            tr_crossings(&mesh, others, other_count, segments + 6 * total, count);
        f->crossing_first = (int)total;
        f->crossing_count = ok ? (int)count : 0;
        total += ok ? count : 0;
    }
    tr_result result = ok ? tr_set_crossings(r->tr, segments, total) : TR_OUT_OF_MEMORY;
    free(others);
    free(segments);
    return result == TR_OK ? true : broken(r, "where parts enter others: %s", tr_result_string(result));
}

static void tr_said(tr_log_level level, tr_result code, const char *what, void *user) {
    (void)code;
    if (level == TR_LOG_ERROR || ((const illustrate_job *)user)->verbose)
        fprintf(stderr, "%s\n", what);
}

static bool start(renderer *r, tr_proc (*get_proc)(const char *)) {
    tr_desc desc;
    tr_result result;
    memset(&desc, 0, sizeof desc);
    desc.get_proc = get_proc;
    desc.log_fn = tr_said;
    desc.log_user = (void *)(uintptr_t)r->job;
    desc.state = TR_STATE_LEAVE_DIRTY;
    r->tr = tr_create(&desc, &result);
    if (!r->tr)
        return broken(r, "%s", tr_result_string(result));
    bool es = tr_get_info(r->tr).es != 0;
    if (!(es ? gladLoadGLES2 : gladLoadGL)((GLADloadfunc)get_proc))
        return broken(r, "the driver's functions could not be loaded");
    return true;
}

static void finish(renderer *r) {
    for (size_t i = 0; i < r->figure_count; ++i) {
        figure *f = &r->figures[i];
        const GLuint arrays[2] = {f->array, f->line_array}, buffers[2] = {f->alpha_buffer, f->line_buffer};
        if (r->tr) {
            glDeleteVertexArrays(2, arrays);
            glDeleteBuffers(2, buffers);
        }
        free(f->edges);
        free(f->strips);
        free(f->strip_vertices);
        free(f->smooth);
        free(f->smooth_strips);
    }
    for (size_t i = 0; r->surfaces && i < r->surface_count; ++i) {
        surface *s = &r->surfaces[i];
        const GLuint buffers[2] = {s->buffer, s->index_buffer};
        if (s->buffer)
            glDeleteBuffers(2, buffers);
        sil_mesh_destroy(s->mesh);
        if (s->owned) {
            free(s->positions);
            free(s->normals);
            free(s->colors);
            free(s->indices);
        }
    }
    for (size_t i = 0; r->edges && i < r->edge_sets; ++i) {
        free_lists(&r->edges[i]);
        free((void *)(uintptr_t)r->edges[i].ends);
    }
    free(r->edges);
    free(r->figures);
    free(r->surfaces);
    if (r->framebuffer)
        drop_target(r);
    if (r->oit)
        stop_glass(r);
    tr_destroy(r->tr);
}

/* A single open surface that rolls up, which Hodges' rules say nothing of, for they are of things with an inside. */
static bool is_rolled_surface(const illustrate_job *job) {
    const scene *s = job->scene;
    size_t shown = 0, only = 0;
    overlap views[OVERLAP_VIEWS];
    for (size_t i = 0; i < s->part_count; ++i)
        if (!s->parts[i].hidden) {
            only = i;
            ++shown;
        }
    if (shown != 1 || job->phantom || (job->transparent && job->transparent[only] == PART_OPAQUE))
        return false;
    const scene_mesh *mesh = &s->meshes[s->parts[only].mesh];
    return overlap_measure(mesh, views) && overlap_is_rolled(views) && !scene_mesh_closed(mesh, NULL);
}

/* What there is to draw with: fragments of all layers where the style has them. Where it was chosen here and the context is
 * too old for it, another one is. */
static bool start_style(renderer *r, illustrate_job *job, oit_proc (*get_proc)(const char *)) {
    bool chosen = job->style == STYLE_AUTO && is_rolled_surface(job);
    if (chosen)
        r->style = job->style = STYLE_SMART;
    if (has_layers(job->style) && !start_glass(r, get_proc)) {
        if (!chosen)
            return false;
        stop_glass(r);
        r->style = job->style = STYLE_AUTO;
    }
    if (!job->lines_asked && (job->style == STYLE_SMART || job->style == STYLE_CURVATURE))
        job->silhouettes = job->boundaries = job->creases = false; /* they show their own */
    return true;
}

bool illustrate_render(const illustrate_job *wanted, void (*(*get_proc)(const char *))(void),
                       illustrate_result *result) {
    static const tr_alpha rungs[5] = {TR_ALPHA_CANDIDATES, TR_ALPHA_PUBLISHED, TR_ALPHA_DISTANCE, TR_ALPHA_CANDIDATES,
                                      TR_ALPHA_EXACT};
    illustrate_job job = *wanted;
    renderer r;
    memset(&r, 0, sizeof r);
    memset(result, 0, sizeof *result);
    r.job = &job;
    r.result = result;
    r.style = job.style;
    r.alpha = rungs[job.alpha_quality];
    bool ok = start(&r, get_proc) && start_style(&r, &job, get_proc) && prepare(&r);
    if (ok && r.style == STYLE_AUTO) {
        tr_scene found = tr_scene_count(r.figures, r.figure_count, sizeof *r.figures);
        r.style = found.transparent || found.transparent_two_sided ? STYLE_HODGES : STYLE_OPAQUE;
    }
    r.interior = ok ? choose_interior(&r) : TR_INTERIOR_IMPLICIT;
    ok = ok && (job.enter <= 0 || find_crossings(&r));
    if (ok && job.verbose)
        fprintf(stderr, "style %s, %s interiors, %zu parts\n", style_name(r.style), interior_name(r.interior),
                r.figure_count);
    ok = ok && draw_in_tiles(&r, get_proc);
    if (ok && job.explain)
        explain(&r);
    finish(&r);
    return ok;
}

/* ---- lines as SVG ---------------------------------------------------------------------------------------------- */

static void add_strips(svg *s, const renderer *r, const figure *f, const sil_strip *strips, size_t count,
                       uint32_t kinds) {
    const float *positions = r->surfaces[f->part->mesh].positions;
    for (size_t i = 0; i < count; ++i) {
        float *places = strips[i].kinds & kinds ? malloc((size_t)strips[i].count * 3 * sizeof *places) : NULL;
        if (!places) {
            s->out_of_memory = s->out_of_memory || strips[i].kinds & kinds;
            continue;
        }
        for (size_t k = 0; k < strips[i].count; ++k)
            memcpy(places + 3 * k, positions + 3 * (size_t)f->strip_vertices[strips[i].first + k], 3 * sizeof *places);
        svg_strip(s, places, 3 * sizeof *places, strips[i].count, f->model_view, r->projection);
        free(places);
    }
}

static void add_figure(svg *s, const renderer *r, const figure *f) {
    const illustrate_job *job = r->job;
    const double heavy = (double)job->line_width * (job->weight == WEIGHT_THICK_THIN ? 2 : 1);
    const sil_strip *outlines = f->strips + f->crease_strips;
    const size_t count = f->strip_count - f->crease_strips;
    svg_part(s, f->object.id, f->part->name, f->phantom);
    svg_kind(s, "creases", 0.7 * (double)job->line_width);
    add_strips(s, r, f, f->strips, f->crease_strips, SIL_CREASE);
    svg_end_group(s);
    svg_kind(s, "boundaries", heavy);
    add_strips(s, r, f, outlines, count, SIL_BOUNDARY);
    svg_end_group(s);
    svg_kind(s, "silhouettes", heavy);
    add_strips(s, r, f, outlines, count, SIL_SILHOUETTE);
    for (size_t i = 0; i < f->smooth_strip_count; ++i)
        svg_strip(s, f->smooth[f->smooth_strips[i].first].position, sizeof *f->smooth, f->smooth_strips[i].count,
                  f->model_view, r->projection);
    svg_end_group(s);
    svg_end_group(s);
}

static char *write_svg(renderer *r, size_t *length) {
    const illustrate_job *job = r->job;
    const int fine = job->width <= 4096 && job->height <= 4096 ? 2 : 1;
    depth_image image = {NULL, 0, 0};
    svg s;
    memset(&s, 0, sizeof s);
    s.width = job->width;
    s.height = job->height;
    s.line_width = (double)job->line_width;
    s.outer = job->weight == WEIGHT_OUTER;
    s.hidden = job->hidden;
    s.image = &image;
    if (!draw_depths(r, r->projection, fine * job->width, fine * job->height, &image))
        return NULL;
    svg_begin(&s, job->background);
    for (size_t i = 0; i < r->figure_count; ++i)
        if (r->figures[i].strips) /* a flattened part has none */
            add_figure(&s, r, &r->figures[i]);
    svg_end(&s);
    depth_image_destroy(&image);
    *length = s.length;
    if (!s.out_of_memory)
        return s.text;
    free(s.text);
    no_memory(r);
    return NULL;
}

char *illustrate_svg(const illustrate_job *job, size_t *length, illustrate_result *result) {
    illustrate_job lines = *job;
    renderer r;
    lines.style = STYLE_LINES; /* nothing is transparent: parts are solid or phantoms */
    memset(&r, 0, sizeof r);
    memset(result, 0, sizeof *result);
    r.job = &lines;
    r.result = result;
    r.style = STYLE_LINES;
    bool ok = make_figures(&r) && make_camera(&r);
    for (size_t i = 0; ok && i < r.figure_count; ++i)
        ok = find_lines(&r, &r.figures[i]);
    char *written = ok ? write_svg(&r, length) : NULL;
    finish(&r);
    return written;
}

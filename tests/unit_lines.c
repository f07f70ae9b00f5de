/* Unit tests of silhouette.h's lines as they are drawn: weights, dashes, corners, dashes that stay from frame to frame,
   smooth silhouettes. Widths are measured across the triangles; truth comes from closed forms and brute force.
   Build: cc -std=c11 -I. tests/unit_lines.c -lcmocka -lm */
#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define PI 3.14159265358979323846

/* ---- random numbers: the same everywhere ---- */

static uint64_t random_state = 88172645463325252u;

static uint32_t random_bits(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (uint32_t)(random_state >> 32);
}

static double random_in(double low, double high) {
    return low + (high - low) * ((double)random_bits() / 4294967296.0);
}

/* ---- what was drawn ---- */

enum { SCREEN = 200 };

/* Points are pixels; z from -10 to 10 is depth 1 to 0. */
static sil_ribbon_desc screen_desc(const float *points, size_t count) {
    sil_ribbon_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.model_view[0] = desc.model_view[5] = desc.model_view[10] = desc.model_view[15] = 1;
    desc.projection[0] = desc.projection[5] = 2.0f / SCREEN;
    desc.projection[10] = -0.1f;
    desc.projection[12] = desc.projection[13] = -1;
    desc.projection[15] = 1;
    desc.viewport_width = desc.viewport_height = SCREEN;
    desc.points = points;
    desc.point_count = count;
    return desc;
}

typedef struct drawing {
    sil_ribbon_vertex *v;
    size_t count;
} drawing;

static drawing draw(const sil_mesh *mesh, const sil_strip *strips, size_t strip_count, const uint32_t *vertices,
                    const sil_ribbon_desc *desc) {
    drawing d;
    d.count = sil_ribbons(mesh, NULL, strips, strip_count, vertices, desc, NULL, 0);
    assert_int_equal(d.count % 3, 0);
    d.v = (sil_ribbon_vertex *)malloc((d.count + 1) * sizeof *d.v);
    assert_non_null(d.v);
    assert_int_equal(sil_ribbons(mesh, NULL, strips, strip_count, vertices, desc, d.v, d.count), d.count);
    return d;
}

/* How much is drawn of what makes no sense. */
static size_t count_of(const sil_ribbon_desc *desc) {
    const sil_strip strip = {0, 2, 0, SIL_CREASE, 0};
    return sil_ribbons(NULL, NULL, &strip, 1, NULL, desc, NULL, 0);
}

/* One strip that runs through points 0, 1, 2, ... */
static drawing draw_points(const sil_ribbon_desc *desc, uint32_t kinds, int closed) {
    sil_strip strip;
    memset(&strip, 0, sizeof strip);
    strip.count = (uint32_t)desc->point_count;
    strip.kinds = kinds;
    strip.closed = (uint32_t)closed;
    return draw(NULL, &strip, 1, NULL, desc);
}

static double side_of(const sil_ribbon_vertex *a, const sil_ribbon_vertex *b, double x, double y) {
    return ((double)b->x - (double)a->x) * (y - (double)a->y) - ((double)b->y - (double)a->y) * (x - (double)a->x);
}

static int covered(const drawing *d, double x, double y) {
    size_t i;
    for (i = 0; i < d->count; i += 3) {
        const sil_ribbon_vertex *t = d->v + i;
        const double a = side_of(t, t + 1, x, y), b = side_of(t + 1, t + 2, x, y), c = side_of(t + 2, t, x, y);
        if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0))
            return 1;
    }
    return 0;
}

static double area_of(const drawing *d) {
    double sum = 0;
    size_t i;
    for (i = 0; i < d->count; i += 3)
        sum += 0.5 * fabs(side_of(d->v + i, d->v + i + 1, (double)d->v[i + 2].x, (double)d->v[i + 2].y));
    return sum;
}

/* Width of what is drawn at a place, across the direction x, y: to a hundredth of a pixel. */
static double width_at(const drawing *d, double px, double py, double x, double y) {
    const double length = hypot(x, y), nx = -y / length, ny = x / length;
    int low = 0, high = 0;
    if (!covered(d, px, py))
        return 0;
    while (covered(d, px + 0.01 * (high + 1) * nx, py + 0.01 * (high + 1) * ny))
        ++high;
    while (covered(d, px - 0.01 * (low + 1) * nx, py - 0.01 * (low + 1) * ny))
        ++low;
    return 0.01 * (low + high);
}

#define WIDTH_IS(d, px, py, x, y, wanted) assert_true(fabs(width_at(d, px, py, x, y) - (wanted)) < 0.03)

/* ---- meshes and cameras ---- */

typedef struct shape {
    float *positions;
    uint32_t *indices;
    size_t vertex_count, index_count;
    sil_mesh *mesh;
} shape;

static shape shape_new(size_t vertices, size_t triangles) {
    shape s;
    memset(&s, 0, sizeof s);
    s.positions = (float *)calloc(3 * vertices + 1, sizeof(float));
    s.indices = (uint32_t *)calloc(3 * triangles + 1, sizeof(uint32_t));
    assert_non_null(s.positions);
    assert_non_null(s.indices);
    return s;
}

static uint32_t add_vertex(shape *s, double x, double y, double z) {
    float *p = s->positions + 3 * s->vertex_count;
    p[0] = (float)x;
    p[1] = (float)y;
    p[2] = (float)z;
    return (uint32_t)s->vertex_count++;
}

static void add_face(shape *s, uint32_t a, uint32_t b, uint32_t c) {
    s->indices[s->index_count++] = a;
    s->indices[s->index_count++] = b;
    s->indices[s->index_count++] = c;
}

static void shape_finish(shape *s) {
    sil_mesh_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.positions = s->positions;
    desc.vertex_count = s->vertex_count;
    desc.indices = s->indices;
    desc.index_count = s->index_count;
    s->mesh = sil_mesh_create(&desc, NULL);
    assert_non_null(s->mesh);
}

static void shape_free(shape *s) {
    sil_mesh_destroy(s->mesh);
    free(s->positions);
    free(s->indices);
}

/* A torus about z; bumps > 0 makes it a smooth blob of a kind. */
static shape make_torus(int rings, int sides, double tube, double bumps) {
    shape s = shape_new((size_t)(rings * sides), (size_t)(2 * rings * sides));
    int i, j;
    for (i = 0; i < rings; ++i)
        for (j = 0; j < sides; ++j) {
            const double u = 2 * PI * i / rings, v = 2 * PI * j / sides;
            const double r = tube * (1 + bumps * sin(3 * u) * cos(2 * v)), x = 1 + r * cos(v);
            add_vertex(&s, x * cos(u), x * sin(u), r * sin(v));
        }
    for (i = 0; i < rings; ++i)
        for (j = 0; j < sides; ++j) {
            const uint32_t a = (uint32_t)(i * sides + j), b = (uint32_t)((i + 1) % rings * sides + j);
            const uint32_t c = (uint32_t)((i + 1) % rings * sides + (j + 1) % sides);
            const uint32_t d = (uint32_t)(i * sides + (j + 1) % sides);
            add_face(&s, a, b, c);
            add_face(&s, a, c, d);
        }
    shape_finish(&s);
    return s;
}

static shape make_box(void) {
    shape s = shape_new(8, 12);
    static const uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    int i;
    for (i = 0; i < 8; ++i)
        add_vertex(&s, i & 1 ? 0.8 : -0.8, i & 2 ? 0.6 : -0.6, i & 4 ? 0.5 : -0.5);
    for (i = 0; i < 6; ++i) {
        add_face(&s, quads[i][0], quads[i][1], quads[i][2]);
        add_face(&s, quads[i][0], quads[i][2], quads[i][3]);
    }
    shape_finish(&s);
    return s;
}

/* An eye at an azimuth and an elevation that looks at the origin. */
static void look(sil_ribbon_desc *desc, double azimuth, double elevation, double distance, double focal, float size) {
    const double ca = cos(azimuth), sa = sin(azimuth), ce = cos(elevation), se = sin(elevation);
    const double m[12] = {-sa, -se * ca, ce * ca, ca, -se * sa, ce * sa, 0, ce, se, 0, 0, -distance};
    int i;
    memset(desc, 0, sizeof *desc);
    for (i = 0; i < 12; ++i)
        desc->model_view[i / 3 * 4 + i % 3] = (float)m[i];
    desc->model_view[15] = 1;
    desc->projection[0] = desc->projection[5] = (float)focal;
    desc->projection[10] = -1.002f;
    desc->projection[14] = -0.2f;
    desc->projection[11] = -1;
    desc->viewport_width = desc->viewport_height = size;
}

/* Pixels of a place; what the tests compare with, in double. */
static void project(const sil_ribbon_desc *desc, const double p[3], double out[3]) {
    double eye[4], clip[4];
    int k;
    for (k = 0; k < 4; ++k)
        eye[k] = (double)desc->model_view[k] * p[0] + (double)desc->model_view[4 + k] * p[1] +
                 (double)desc->model_view[8 + k] * p[2] + (double)desc->model_view[12 + k];
    for (k = 0; k < 4; ++k)
        clip[k] = (double)desc->projection[k] * eye[0] + (double)desc->projection[4 + k] * eye[1] +
                  (double)desc->projection[8 + k] * eye[2] + (double)desc->projection[12 + k] * eye[3];
    out[0] = 0.5 * (double)desc->viewport_width * (clip[0] / clip[3] + 1);
    out[1] = 0.5 * (double)desc->viewport_height * (clip[1] / clip[3] + 1);
    out[2] = clip[3];
}

typedef struct lines {
    sil_edge *edges;
    sil_strip *strips;
    uint32_t *vertices;
    float *along;
    double (*screen)[3]; /* pixels and clip w of each strip vertex */
    size_t edge_count, strip_count, vertex_count;
} lines;

static lines lines_of(const shape *s, const sil_ribbon_desc *desc, unsigned kinds, const sil_chain_desc *chain) {
    const size_t most = sil_mesh_get_info(s->mesh).edge_count;
    sil_view view;
    lines l;
    size_t i, k;
    assert_int_equal(sil_view_from_matrices(desc->model_view, desc->projection, &view), SIL_OK);
    l.edges = (sil_edge *)malloc((most + 1) * sizeof *l.edges);
    l.strips = (sil_strip *)malloc((most + 1) * sizeof *l.strips);
    l.vertices = (uint32_t *)malloc((2 * most + 1) * sizeof *l.vertices);
    l.along = (float *)calloc(2 * most + 1, sizeof *l.along);
    assert_true(l.edges && l.strips && l.vertices && l.along);
    l.edge_count = sil_extract(s->mesh, NULL, &view, kinds, l.edges, most);
    l.strip_count = sil_chain_corners(s->mesh, NULL, chain, l.edges, l.edge_count, l.strips, most, l.vertices, 2 * most,
                                      &l.vertex_count);
    l.screen = (double(*)[3])malloc((l.vertex_count + 1) * sizeof *l.screen);
    assert_non_null(l.screen);
    for (i = 0; i < l.vertex_count; ++i) {
        double place[3];
        for (k = 0; k < 3; ++k)
            place[k] = (double)s->positions[3 * l.vertices[i] + k];
        project(desc, place, l.screen[i]);
    }
    return l;
}

static void lines_free(lines *l) {
    free(l->edges);
    free(l->strips);
    free(l->vertices);
    free(l->along);
    free(l->screen);
}

/* ---- weights ---- */

static const float level_line[6] = {20, 100, 0, 180, 100, 0};

static void test_widths_of_vertices(void **state) {
    /* a vertex given twice makes a step */
    const float points[15] = {20, 100, 0, 60, 100, 0, 100, 100, 0, 100, 100, 0, 180, 100, 0};
    const float widths[5] = {0, 1, 1, 3, 3}, bad[5] = {1, NAN, -2, INFINITY, 1};
    sil_ribbon_desc desc = screen_desc(points, 5);
    drawing d;
    size_t i;
    (void)state;
    desc.width = 4;
    desc.widths = widths;
    d = draw_points(&desc, SIL_CREASE, 0);
    WIDTH_IS(&d, 40, 100, 1, 0, 2.0);
    WIDTH_IS(&d, 50, 100, 1, 0, 3.0);
    WIDTH_IS(&d, 80, 100, 1, 0, 4.0);
    WIDTH_IS(&d, 99.5, 100, 1, 0, 4.0);
    WIDTH_IS(&d, 100.5, 100, 1, 0, 12.0);
    WIDTH_IS(&d, 150, 100, 1, 0, 12.0);
    free(d.v);
    desc.widths = bad; /* taken for 0 */
    d = draw_points(&desc, SIL_CREASE, 0);
    WIDTH_IS(&d, 40, 100, 1, 0, 2.0);
    WIDTH_IS(&d, 80, 100, 1, 0, 0.0);
    WIDTH_IS(&d, 140, 100, 1, 0, 2.0);
    for (i = 0; i < d.count; ++i)
        assert_true(isfinite(d.v[i].x) && isfinite(d.v[i].y));
    free(d.v);
}

/* The width of a segment that is cut at the viewport is that of the whole one: tiles of a picture fit. */
static void test_widths_do_not_depend_on_the_cut(void **state) {
    const float points[6] = {-5000, 100, 0, 5200, 100, 0}, widths[2] = {1, 11};
    sil_ribbon_desc desc = screen_desc(points, 2);
    drawing d;
    (void)state;
    desc.width = 2;
    desc.widths = widths;
    d = draw_points(&desc, SIL_CREASE, 0);
    WIDTH_IS(&d, 10, 100, 1, 0, 2 * (1 + 10 * 5010.0 / 10200));
    WIDTH_IS(&d, 190, 100, 1, 0, 2 * (1 + 10 * 5190.0 / 10200));
    free(d.v);
}

static void test_taper(void **state) {
    const float points[12] = {20, 100, 0, 60, 100, 0, 100, 100, 0, 180, 100, 0};
    const float around[12] = {60, 60, 0, 140, 60, 0, 140, 140, 0, 60, 60, 0};
    sil_ribbon_desc desc = screen_desc(points, 4);
    drawing d;
    (void)state;
    desc.width = 8;
    desc.taper = 60;
    d = draw_points(&desc, SIL_CREASE, 0);
    WIDTH_IS(&d, 35, 100, 1, 0, 2.0);
    WIDTH_IS(&d, 65, 100, 1, 0, 6.0);
    WIDTH_IS(&d, 100, 100, 1, 0, 8.0);
    WIDTH_IS(&d, 165, 100, 1, 0, 2.0);
    free(d.v);
    desc.taper = 1000; /* longer than the line: its middle has half its length over the taper's */
    desc.width = 40;
    d = draw_points(&desc, SIL_CREASE, 0);
    WIDTH_IS(&d, 100, 100, 1, 0, 40 * 80.0 / 1000);
    WIDTH_IS(&d, 60, 100, 1, 0, 40 * 40.0 / 1000);
    free(d.v);
    desc = screen_desc(around, 4); /* loops have no ends */
    desc.width = 8;
    desc.taper = 60;
    d = draw_points(&desc, SIL_CREASE, 1);
    WIDTH_IS(&d, 70, 60, 1, 0, 8.0);
    free(d.v);
}

static void test_thick_and_thin(void **state) {
    static const struct {
        uint32_t kinds;
        double width;
    } cases[] = {{SIL_SILHOUETTE, 4},
                 {SIL_BOUNDARY, 4},
                 {SIL_CREASE, 2},
                 {SIL_NONMANIFOLD, 2},
                 {SIL_NONMANIFOLD | SIL_SILHOUETTE, 4}};
    sil_ribbon_desc desc = screen_desc(level_line, 2);
    size_t i;
    (void)state;
    desc.width = 2;
    desc.weight = SIL_WEIGHT_THICK_THIN;
    for (i = 0; i < sizeof cases / sizeof *cases; ++i) {
        drawing d = draw_points(&desc, cases[i].kinds, 0);
        WIDTH_IS(&d, 100, 100, 1, 0, cases[i].width);
        free(d.v);
    }
    desc.heavy = 5;
    desc.thin = 0.5f;
    for (i = 0; i < sizeof cases / sizeof *cases; ++i) {
        drawing d = draw_points(&desc, cases[i].kinds, 0);
        WIDTH_IS(&d, 100, 100, 1, 0, cases[i].width > 3 ? 10 : 1);
        free(d.v);
    }
    desc.weight = SIL_WEIGHT_ONE;
    for (i = 0; i < sizeof cases / sizeof *cases; ++i) {
        drawing d = draw_points(&desc, cases[i].kinds, 0);
        WIDTH_IS(&d, 100, 100, 1, 0, 2);
        free(d.v);
    }
}

static void test_weight_by_perspective(void **state) {
    /* four units from the eye on the left, twelve on the right */
    const float points[6] = {-2, 0, -4, 6, 0, -12};
    sil_ribbon_desc desc = screen_desc(points, 2);
    sil_mesh_desc mesh_desc;
    sil_mesh *mesh;
    sil_strip strip = {0, 2, 0, SIL_CREASE, 0};
    const uint32_t face[3] = {0, 1, 2}, ends[2] = {0, 1};
    const float corners[9] = {-2, 0, -4, 6, 0, -12, 0, 1, -8};
    drawing d;
    (void)state;
    memset(desc.projection, 0, sizeof desc.projection);
    desc.projection[0] = desc.projection[5] = 1;
    desc.projection[10] = -1.02f;
    desc.projection[14] = -2.02f;
    desc.projection[11] = -1;
    desc.width = 2;
    desc.weight = SIL_WEIGHT_PERSPECTIVE;
    desc.heavy = 4;
    desc.reach[0] = 4;
    desc.reach[1] = 12;
    d = draw_points(&desc, SIL_CREASE, 0);
    WIDTH_IS(&d, 50.01, 100, 1, 0, 8);
    WIDTH_IS(&d, 100, 100, 1, 0, 5);
    WIDTH_IS(&d, 149.99, 100, 1, 0, 2);
    free(d.v);
    desc.reach[0] = 20; /* all in the foreground */
    desc.reach[1] = 30;
    d = draw_points(&desc, SIL_CREASE, 0);
    WIDTH_IS(&d, 149.99, 100, 1, 0, 8);
    free(d.v);
    desc.reach[0] = desc.reach[1] = 0; /* from the mesh's box */
    desc.points = NULL;
    memset(&mesh_desc, 0, sizeof mesh_desc);
    mesh_desc.positions = corners;
    mesh_desc.vertex_count = 3;
    mesh_desc.indices = face;
    mesh_desc.index_count = 3;
    mesh = sil_mesh_create(&mesh_desc, NULL);
    assert_non_null(mesh);
    d = draw(mesh, &strip, 1, ends, &desc);
    WIDTH_IS(&d, 50.01, 100, 1, 0, 8);
    WIDTH_IS(&d, 149.99, 100, 1, 0, 2);
    free(d.v);
    sil_mesh_destroy(mesh);
}

enum { CIRCLE = 64 };

/* Counter-clockwise: what is in front lies inside, on the left. */
static void make_circle(float points[3 * (CIRCLE + 1)], double radius) {
    int i;
    for (i = 0; i <= CIRCLE; ++i) {
        points[3 * i] = (float)(100 + radius * cos(2 * PI * (i % CIRCLE) / CIRCLE));
        points[3 * i + 1] = (float)(100 + radius * sin(2 * PI * (i % CIRCLE) / CIRCLE));
        points[3 * i + 2] = 0;
    }
}

/* Width at an angle on the circle, in the middle of a chord. */
static double circle_width(const drawing *d, int at) {
    const double angle = 2 * PI * (at + 0.5) / CIRCLE, radius = 50 * cos(PI / CIRCLE);
    return width_at(d, 100 + radius * cos(angle), 100 + radius * sin(angle), -sin(angle), cos(angle));
}

static void test_weight_by_light(void **state) {
    float points[3 * (CIRCLE + 1)];
    sil_ribbon_desc desc;
    drawing d;
    int i, mirrored;
    (void)state;
    make_circle(points, 50);
    for (mirrored = 0; mirrored < 3; ++mirrored) {
        desc = screen_desc(points, CIRCLE + 1);
        if (mirrored == 1) { /* the model: x to 200 - x */
            desc.model_view[0] = -1;
            desc.model_view[12] = SCREEN;
        }
        if (mirrored == 2) { /* the picture, upside down */
            desc.projection[5] *= -1;
            desc.projection[13] *= -1;
        }
        desc.width = 2;
        desc.weight = SIL_WEIGHT_LIGHT;
        desc.heavy = 3;
        d = draw_points(&desc, SIL_SILHOUETTE, 1);
        for (i = 0; i < CIRCLE; ++i) { /* light from 135 degrees; 4 + 2 * how far away from it */
            const double angle = 2 * PI * (i + 0.5) / CIRCLE;
            assert_true(fabs(circle_width(&d, i) - (4 - 2 * cos(angle - 0.75 * PI))) < 0.06);
        }
        free(d.v);
        desc.light[0] = 7; /* from the right */
        d = draw_points(&desc, SIL_BOUNDARY, 1);
        assert_true(fabs(circle_width(&d, 0) - 2) < 0.06 && fabs(circle_width(&d, CIRCLE / 2) - 6) < 0.06);
        free(d.v);
        d = draw_points(&desc, SIL_CREASE, 1); /* creases have no outside */
        assert_true(fabs(circle_width(&d, 0) - 4) < 0.06 && fabs(circle_width(&d, CIRCLE / 2) - 4) < 0.06);
        free(d.v);
    }
}

/* The picture: something below y = 100 everywhere, and above it for x >= 120. */
static void test_outer_lines(void **state) {
    static float depth[SCREEN * SCREEN];
    static uint32_t ids[SCREEN * SCREEN];
    int kind, x, y;
    (void)state;
    for (kind = 0; kind < 4; ++kind) {
        const int size = kind == 3 ? SCREEN / 2 : SCREEN; /* coarser than the viewport */
        sil_image image;
        sil_ribbon_desc desc = screen_desc(level_line, 2);
        drawing d;
        memset(&image, 0, sizeof image);
        memset(ids, 0xff, sizeof ids);
        for (y = 0; y < size; ++y)
            for (x = 0; x < size; ++x) {
                const int thing = y < size / 2 || x >= size * 3 / 5;
                depth[y * SCREEN + x] = thing ? 0.5f : kind == 1 ? 0.0f : 1.0f;
                ids[y * SCREEN + x] = thing ? 3 : 7;
            }
        image.depth = kind == 0 || kind == 1 ? depth : NULL;
        image.ids = ids;
        image.background = 7;
        image.width = image.height = (uint32_t)size;
        image.stride = SCREEN;
        image.flags = kind == 1 ? SIL_IMAGE_REVERSED : 0;
        desc.image = &image;
        desc.width = 2;
        desc.weight = SIL_WEIGHT_OUTER;
        desc.heavy = 3;
        d = draw_points(&desc, SIL_CREASE, 0);
        WIDTH_IS(&d, 30, 100, 1, 0, 6);
        WIDTH_IS(&d, 110, 100, 1, 0, 6);
        WIDTH_IS(&d, 132, 100, 1, 0, 2);
        WIDTH_IS(&d, 170, 100, 1, 0, 2);
        free(d.v);
        image.stride = (size_t)size - 1;
        assert_int_equal(count_of(&desc), 0);
        desc.image = NULL;
        assert_int_equal(count_of(&desc), 0);
    }
}

/* ---- dashes ---- */

/* Diepstraten 2002, figure 2: a long dash and two short ones. */
static const float phantom[6] = {24, 5, 6, 5, 6, 5};

/* Is u within what is drawn of a pattern? -1: too close to a boundary to say. */
static int pattern_at(const float *dashes, size_t count, double u) {
    double period = 0, at = 0;
    size_t i;
    for (i = 0; i < count; ++i)
        period += (double)dashes[i];
    u -= period * floor(u / period);
    for (i = 0; i < count; ++i) {
        at += (double)dashes[i];
        if (fabs(u - at) < 0.01 || u < 0.01)
            return -1;
        if (u < at)
            return i % 2 == 0;
    }
    return -1;
}

static void test_dashes_on_a_line(void **state) {
    const float hidden[2] = {8, 4}, phases[3] = {0, 13.5f, -1000.25f}, back[2] = {1234.5f, 1074.5f};
    int round, x;
    (void)state;
    for (round = 0; round < 8; ++round) {
        const float *dashes = round % 2 ? hidden : phantom;
        sil_ribbon_desc desc = screen_desc(level_line, 2);
        drawing d;
        desc.width = 4;
        desc.cap = SIL_CAP_BUTT;
        desc.dashes = dashes;
        desc.dash_count = round % 2 ? 2 : 6;
        desc.phases = round < 6 ? &phases[round / 2] : NULL;
        desc.along = round < 6 ? NULL : back; /* the pattern may run backward */
        d = draw_points(&desc, SIL_CREASE, 0);
        for (x = 0; x < 1600; ++x) {
            const double px = 20.05 + 0.1 * x, s = px - 20;
            const int wanted =
                pattern_at(dashes, desc.dash_count, round < 6 ? s + (double)phases[round / 2] : (double)back[0] - s);
            if (wanted >= 0)
                assert_int_equal(covered(&d, px, 101.5), wanted);
        }
        free(d.v);
    }
}

/* Caps stand out beyond dashes; a dash of no length is a dot. */
static void test_dashes_have_caps(void **state) {
    const float dashes[2] = {10, 20}, dots[2] = {0, 20}, gaps[2] = {20, 0};
    sil_ribbon_desc desc = screen_desc(level_line, 2);
    drawing d;
    (void)state;
    desc.width = 8;
    desc.dashes = dashes;
    desc.dash_count = 2;
    d = draw_points(&desc, SIL_CREASE, 0);
    assert_true(covered(&d, 33.5, 100) && covered(&d, 46.5, 100) && !covered(&d, 33.5, 103) && !covered(&d, 40, 100));
    free(d.v);
    desc.cap = SIL_CAP_SQUARE;
    d = draw_points(&desc, SIL_CREASE, 0);
    assert_true(covered(&d, 33.5, 103.5) && !covered(&d, 34.5, 100));
    free(d.v);
    desc.dashes = dots;
    d = draw_points(&desc, SIL_CREASE, 0);
    assert_true(covered(&d, 20, 100) && covered(&d, 43.5, 103.5) && covered(&d, 36.5, 103.5) && !covered(&d, 45, 100));
    assert_true(covered(&d, 60, 100) && covered(&d, 160, 100) && !covered(&d, 70, 100));
    free(d.v);
    desc.cap = SIL_CAP_ROUND;
    d = draw_points(&desc, SIL_CREASE, 0);
    assert_true(covered(&d, 43.5, 100) && !covered(&d, 43.5, 103.5) && covered(&d, 20, 103));
    free(d.v);
    desc.cap = SIL_CAP_BUTT;
    assert_int_equal(count_of(&desc), 0);
    desc.dashes = gaps; /* gaps of no length: a whole line */
    d = draw_points(&desc, SIL_CREASE, 0);
    assert_true(fabs(area_of(&d) - 8 * 160) < 0.01);
    free(d.v);
}

enum { BENDS = 24 };

/* A line that turns at random, with some tiny steps and steps of no length, and widths that vary. */
static void make_bends(float *points, float *widths, int round) {
    int i;
    for (i = 0; i < BENDS; ++i) {
        const double reach = round % 3 == 2 ? 150 : 40;
        const int tiny = round % 4 == 1 && i % 3;
        points[3 * i] = (float)(i ? (double)points[3 * i - 3] + random_in(-reach, reach) * (tiny ? 1e-3 : 1) : 100);
        points[3 * i + 1] = (float)(i ? (double)points[3 * i - 2] + random_in(-reach, reach) * (tiny ? 1e-3 : 1) : 100);
        points[3 * i + 2] = 0;
        if (i && round % 5 == 4 && i % 4 == 0)
            memcpy(points + 3 * i, points + 3 * i - 3, 3 * sizeof *points);
        widths[i] = (float)random_in(0.5, 2);
    }
}

/* What a pattern draws and what its opposite draws (the same lengths from the first gap on) are the whole line: by area
   to 0.02 % of it where neither caps nor joins overlap, and by pixels with joins. Float triangles of some 10 pixels'
   area carry 1e-5 each; steps below 1e-4 pixels are left out of a line, which takes as much at its ends. */
static void test_dashes_and_gaps_are_all(void **state) {
    double worst = 0;
    size_t gaps = 0, looks = 0;
    int round, i;
    (void)state;
    for (round = 0; round < 60; ++round) {
        float points[3 * BENDS], widths[BENDS], dashes[7], phase = (float)random_in(-90, 90), other;
        sil_ribbon_desc desc = screen_desc(points, BENDS);
        const size_t count = 2 * (1 + random_bits() % 3);
        drawing whole, on, off;
        make_bends(points, widths, round);
        for (i = 0; i < (int)count; ++i)
            dashes[i] = (float)random_in(0.5, 30);
        dashes[count] = dashes[0];
        other = phase - dashes[0];
        desc.width = 5;
        desc.widths = widths;
        desc.cap = SIL_CAP_BUTT;
        desc.join = round % 2 ? SIL_JOIN_ROUND : SIL_JOIN_NONE;
        desc.taper = round % 3 ? 0 : 70;
        whole = draw_points(&desc, SIL_CREASE, 0);
        desc.dash_count = count;
        desc.dashes = dashes;
        desc.phases = &phase;
        on = draw_points(&desc, SIL_CREASE, 0);
        desc.dashes = dashes + 1;
        desc.phases = &other;
        off = draw_points(&desc, SIL_CREASE, 0);
        if (desc.join == SIL_JOIN_NONE && round % 4 != 1)
            worst = fmax(worst, fabs(area_of(&on) + area_of(&off) - area_of(&whole)) / area_of(&whole));
        for (i = 0; i < 4000; ++i) {
            const double x = random_in(0, SCREEN), y = random_in(0, SCREEN);
            const int all = covered(&whole, x, y), some = covered(&on, x, y) || covered(&off, x, y);
            assert_true(all || !some);
            gaps += (size_t)(all && !some);
            looks += (size_t)all;
        }
        free(whole.v);
        free(on.v);
        free(off.v);
    }
    print_message("dashes and gaps: area off by %.2g of the whole, %zu of %zu points of it uncovered\n", worst, gaps,
                  looks);
    assert_true(worst < 2e-4);
    assert_true(looks > 10000 && gaps * 2000 < looks); /* a boundary in the bend itself leaves the outer wedge open */
}

/* A loop that is drawn where it closes has a join there and no caps. */
static void test_dashes_of_a_loop(void **state) {
    const float points[15] = {40, 40, 0, 160, 40, 0, 160, 160, 0, 40, 160, 0, 40, 40, 0};
    const float dashes[2] = {30, 30}, phase = 15;
    sil_ribbon_desc desc = screen_desc(points, 5);
    drawing d;
    (void)state;
    desc.width = 10;
    desc.dashes = dashes;
    desc.dash_count = 2;
    desc.phases = &phase;
    d = draw_points(&desc, SIL_CREASE, 1); /* 480 pixels: eight periods, the first dash begun half a dash ago */
    assert_true(covered(&d, 37, 37) && !covered(&d, 35.7, 35.7) && covered(&d, 50, 40) && covered(&d, 40, 50));
    assert_true(!covered(&d, 65, 40) && !covered(&d, 40, 65));
    free(d.v);
}

static void test_dashes_that_make_no_sense(void **state) {
    const float bad[][2] = {{1, -1}, {5, -1}, {-1, 5}, {NAN, 1}, {1, INFINITY}, {0, 0}};
    const float tiny[2] = {1e-30f, 1e-30f}, denormal[2] = {1e-45f, 0}, huge[2] = {3e38f, 3e38f};
    const float nan_phase = NAN;
    static float many[66];
    sil_ribbon_desc desc = screen_desc(level_line, 2);
    size_t i, whole;
    (void)state;
    whole = count_of(&desc);
    assert_true(whole > 0);
    desc.dash_count = 2;
    for (i = 0; i < sizeof bad / sizeof *bad; ++i) {
        desc.dashes = bad[i];
        assert_int_equal(count_of(&desc), 0);
    }
    desc.dashes = many;
    for (i = 0; i < 66; ++i)
        many[i] = 1;
    desc.dash_count = 66;
    assert_int_equal(count_of(&desc), 0);
    desc.dash_count = 64;
    assert_true(count_of(&desc) > whole);
    desc.dash_count = 3;
    assert_int_equal(count_of(&desc), 0);
    desc.dash_count = 0;
    assert_int_equal(count_of(&desc), 0);
    desc.dash_count = 2;
    desc.dashes = tiny; /* more periods in a segment than anyone can see: a whole line */
    assert_int_equal(count_of(&desc), whole);
    desc.dashes = denormal;
    assert_int_equal(count_of(&desc), whole);
    desc.dashes = huge;
    assert_int_equal(count_of(&desc), whole);
    desc.phases = &nan_phase; /* taken for 0 */
    assert_int_equal(count_of(&desc), whole);
    desc.viewport_width = 1e30f;
    desc.dashes = phantom;
    desc.dash_count = 6;
    assert_true(count_of(&desc) > 0);
}

/* ---- dashes that stay ---- */

/* Where a dash begins or ends. */
typedef struct boundary {
    double place[3], x, y;
    double length; /* of its strip, pixels */
    int begins;
} boundary;

enum { MOST_BOUNDARIES = 4096 };

static const float even_dashes[2] = {14, 10};

/* All boundaries of dashes, from the places along the lines; as arcs go where `counted`. */
static size_t boundaries_of(const shape *s, const lines *l, int counted, boundary *out) {
    const double period = (double)even_dashes[0] + (double)even_dashes[1];
    size_t count = 0, i, k;
    int n, j;
    for (i = 0; i < l->strip_count; ++i) {
        const size_t first = count;
        double arc = 0;
        for (k = 1; k < l->strips[i].count; ++k) {
            const size_t at = l->strips[i].first + k;
            const double *p = l->screen[at - 1], *q = l->screen[at];
            const float *a = s->positions + 3 * l->vertices[at - 1], *b = s->positions + 3 * l->vertices[at];
            double u, v;
            u = counted ? arc : (double)l->along[at - 1];
            arc += hypot(q[0] - p[0], q[1] - p[1]);
            v = counted ? arc : (double)l->along[at];
            for (n = (int)ceil(2 * fmin(u, v) / period) - 2; n <= (int)(2 * fmax(u, v) / period) + 2; ++n) {
                const double bound = period * floor(n / 2.0) + (n & 1 ? (double)even_dashes[0] : 0);
                const double f = (bound - u) / (v - u), t = f * p[2] / (f * p[2] + (1 - f) * q[2]);
                if (!(f >= 0 && f < 1) || count == MOST_BOUNDARIES)
                    continue;
                for (j = 0; j < 3; ++j)
                    out[count].place[j] = (1 - t) * (double)a[j] + t * (double)b[j];
                out[count].x = p[0] + f * (q[0] - p[0]);
                out[count].y = p[1] + f * (q[1] - p[1]);
                out[count++].begins = (n & 1) == (v < u);
            }
        }
        for (k = first; k < count; ++k)
            out[k].length = arc;
    }
    return count;
}

/* The point of the lines that is nearest to x, y. Returns its distance. */
static double nearest_point(const lines *l, double x, double y, double foot[2]) {
    double best = 1e30;
    size_t i, k;
    for (i = 0; i < l->strip_count; ++i)
        for (k = 1; k < l->strips[i].count; ++k) {
            const double *a = l->screen[l->strips[i].first + k - 1], *b = a + 3;
            const double ex = b[0] - a[0], ey = b[1] - a[1], square = ex * ex + ey * ey;
            double t = square > 0 ? ((x - a[0]) * ex + (y - a[1]) * ey) / square : 0, distance;
            t = t < 0 ? 0 : t > 1 ? 1 : t;
            distance = hypot(x - a[0] - t * ex, y - a[1] - t * ey);
            if (distance < best) {
                best = distance;
                foot[0] = a[0] + t * ex;
                foot[1] = a[1] + t * ey;
            }
        }
    return best;
}

typedef struct slide {
    size_t looked_at, gone,
        slid;               /* boundaries; lines no longer there; dashes that slid further than their line moved */
    double motion, sliding; /* sums of pixels */
} slide;

/* What becomes of a frame's boundaries in the next. A boundary's place in the mesh is seen elsewhere now; the line went
   from where the boundary was to the foot of the perpendicular from there: its motion. From that foot to the nearest
   boundary of the same sort the dash slid along the line. */
static void follow_boundaries(const sil_ribbon_desc *desc, const lines *l, const boundary *old, size_t old_count,
                              const boundary *now, size_t now_count, slide *sum) {
    size_t i, k;
    for (i = 0; i < old_count; ++i) {
        double q[3], foot[2] = {0, 0}, motion, sliding = 1e30;
        project(desc, old[i].place, q);
        if (old[i].length < 48)
            continue;
        ++sum->looked_at;
        if (nearest_point(l, q[0], q[1], foot) > 6) {
            ++sum->gone;
            continue;
        }
        motion = hypot(foot[0] - old[i].x, foot[1] - old[i].y);
        for (k = 0; k < now_count; ++k)
            if (now[k].begins == old[i].begins)
                sliding = fmin(sliding, hypot(now[k].x - foot[0], now[k].y - foot[1]));
        sum->motion += motion;
        sum->sliding += fmin(sliding, 24);
        sum->slid += sliding > motion + 0.5;
    }
}

static slide orbit(const shape *s, double elevation, double step, int frames, int counted,
                   const sil_chain_desc *chain) {
    boundary *found[2];
    size_t count[2] = {0, 0};
    sil_dashes *dashes = sil_dashes_create(NULL, NULL);
    slide sum;
    int frame;
    memset(&sum, 0, sizeof sum);
    found[0] = (boundary *)malloc(MOST_BOUNDARIES * sizeof(boundary));
    found[1] = (boundary *)malloc(MOST_BOUNDARIES * sizeof(boundary));
    assert_true(dashes && found[0] && found[1]);
    for (frame = 0; frame < frames; ++frame) {
        sil_ribbon_desc desc;
        lines l;
        look(&desc, step * frame, elevation, 4, 1.8, 600);
        desc.dashes = even_dashes;
        desc.dash_count = 2;
        l = lines_of(s, &desc, SIL_SILHOUETTE, chain);
        assert_true(l.strip_count > 0);
        assert_int_equal(sil_dashes_follow(dashes, s->mesh, NULL, l.strips, l.strip_count, l.vertices, &desc, l.along),
                         SIL_OK);
        count[frame % 2] = boundaries_of(s, &l, counted, found[frame % 2]);
        assert_true(count[frame % 2] > 8 && count[frame % 2] < MOST_BOUNDARIES);
        if (frame)
            follow_boundaries(&desc, &l, found[1 - frame % 2], count[1 - frame % 2], found[frame % 2], count[frame % 2],
                              &sum);
        lines_free(&l);
    }
    free(found[0]);
    free(found[1]);
    sil_dashes_destroy(dashes);
    return sum;
}

/* Over an orbit of 360 degrees in steps of one: at most 2 % of the dashes' ends slide further along their line than it
   moved, which are those where lines join, part or close; with dashes counted by arc length it is five times as many
   and more. Lines shorter than two periods, the hooks at cusps, are left out. */
static void test_dashes_stay(void **state) {
    static const char *const names[3] = {"torus", "blob", "box"};
    sil_chain_desc chain;
    int k;
    (void)state;
    memset(&chain, 0, sizeof chain);
    chain.flags = SIL_CHAIN_NO_CONCAVE;
    for (k = 0; k < 3; ++k) {
        shape s = k == 2 ? make_box() : make_torus(96, 48, 0.4, k ? 0.3 : 0);
        const slide kept = orbit(&s, 0.5, PI / 180, 361, 0, &chain), plain = orbit(&s, 0.5, PI / 180, 361, 1, &chain);
        print_message("%s: %zu ends of dashes, %zu gone; slid further than the line: %.2f %% (arc length: %.1f %%); "
                      "the line moved %.2f, dashes slid %.2f (%.2f) pixels on average\n",
                      names[k], kept.looked_at, kept.gone, 100.0 * (double)kept.slid / (double)kept.looked_at,
                      100.0 * (double)plain.slid / (double)plain.looked_at, kept.motion / (double)kept.looked_at,
                      kept.sliding / (double)kept.looked_at, plain.sliding / (double)plain.looked_at);
        assert_true(kept.looked_at > 20000 && kept.gone * 1000 < kept.looked_at);
        assert_true(kept.slid * 50 < kept.looked_at && plain.slid * 10 > plain.looked_at);
        assert_true(kept.sliding < 0.5 * kept.motion);
        shape_free(&s);
    }
}

static double strip_length(const lines *l, size_t strip) {
    double length = 0;
    size_t k;
    for (k = l->strips[strip].first + 1; k < l->strips[strip].first + l->strips[strip].count; ++k)
        length += hypot(l->screen[k][0] - l->screen[k - 1][0], l->screen[k][1] - l->screen[k - 1][1]);
    return length;
}

/* The same picture again moves nothing, but in hooks, where lines lie on each other; a forgotten one begins anew, where
   strips begin. */
static void test_dashes_of_a_still_picture(void **state) {
    shape s = make_torus(48, 24, 0.4, 0.3);
    sil_dashes *dashes = sil_dashes_create(NULL, NULL);
    sil_ribbon_desc desc;
    sil_chain_desc chain;
    float *first;
    lines l;
    size_t i, k, moved = 0;
    int frame;
    (void)state;
    memset(&chain, 0, sizeof chain);
    chain.flags = SIL_CHAIN_NO_CONCAVE;
    for (frame = 0; frame < 24; ++frame) {
        look(&desc, 0.02 * (frame < 20 ? frame : 19), 0.5, 4, 1.8, 600);
        desc.dashes = even_dashes;
        desc.dash_count = 2;
        l = lines_of(&s, &desc, SIL_SILHOUETTE, &chain);
        first = (float *)calloc(l.vertex_count, sizeof *first);
        assert_non_null(first);
        assert_int_equal(sil_dashes_follow(dashes, s.mesh, NULL, l.strips, l.strip_count, l.vertices, &desc, l.along),
                         SIL_OK);
        if (frame >= 20) {
            memcpy(first, l.along, l.vertex_count * sizeof *first);
            assert_int_equal(
                sil_dashes_follow(dashes, s.mesh, NULL, l.strips, l.strip_count, l.vertices, &desc, l.along), SIL_OK);
            for (i = 0; i < l.strip_count; ++i)
                for (k = l.strips[i].first; k < l.strips[i].first + l.strips[i].count; ++k) {
                    /* to a hundredth of a pixel: vertices between marks are rounded */
                    const double step = (double)l.along[k] - (double)first[k];
                    if (strip_length(&l, i) > 48)
                        moved += fabs(step - 24 * floor(step / 24 + 0.5)) > 0.01;
                }
        }
        if (frame == 23) {
            sil_dashes_forget(dashes);
            assert_int_equal(
                sil_dashes_follow(dashes, s.mesh, NULL, l.strips, l.strip_count, l.vertices, &desc, l.along), SIL_OK);
            for (i = 0; i < l.strip_count; ++i) {
                double arc = 0;
                for (k = l.strips[i].first; k < l.strips[i].first + l.strips[i].count; ++k) {
                    arc += k > l.strips[i].first
                               ? hypot(l.screen[k][0] - l.screen[k - 1][0], l.screen[k][1] - l.screen[k - 1][1])
                               : 0;
                    assert_true(fabs((double)l.along[k] - arc) < 1e-3);
                }
            }
        }
        free(first);
        lines_free(&l);
    }
    assert_int_equal(moved, 0);
    sil_dashes_destroy(dashes);
    shape_free(&s);
}

/* A whole line seen twice as large: its dashes would be stretched too far, and begin anew. */
static void test_dashes_are_not_stretched_for_ever(void **state) {
    shape s = make_torus(64, 32, 0.4, 0);
    sil_dashes *dashes = sil_dashes_create(NULL, NULL);
    double worst = 0;
    int frame;
    (void)state;
    for (frame = 0; frame < 120; ++frame) {
        sil_ribbon_desc desc;
        lines l;
        size_t i;
        look(&desc, 0.3, 0.5, 9 - 0.06 * frame, 1.8, 600);
        desc.dashes = even_dashes;
        desc.dash_count = 2;
        l = lines_of(&s, &desc, SIL_SILHOUETTE, NULL);
        assert_int_equal(sil_dashes_follow(dashes, s.mesh, NULL, l.strips, l.strip_count, l.vertices, &desc, l.along),
                         SIL_OK);
        for (i = 0; i < l.strip_count; ++i) {
            const size_t a = l.strips[i].first, b = a + l.strips[i].count - 1;
            const double arc = strip_length(&l, i);
            if (arc > 300)
                worst = fmax(worst, arc / fabs((double)l.along[b] - (double)l.along[a]));
        }
        lines_free(&l);
    }
    print_message("dashes of a line that grows: at most %.2f times as long\n", worst);
    assert_true(worst > 1.1 && worst < 2.2);
    sil_dashes_destroy(dashes);
    shape_free(&s);
}

/* ---- memory and misuse ---- */

typedef struct counting {
    size_t calls, live, fail_at;
} counting;

static void *counting_alloc(size_t size, void *user) {
    counting *c = (counting *)user;
    void *memory;
    if (c->calls++ == c->fail_at)
        return NULL;
    memory = malloc(size);
    c->live += memory != NULL;
    return memory;
}

static void counting_free(void *memory, void *user) {
    counting *c = (counting *)user;
    --c->live;
    free(memory);
}

static void test_memory_of_dashes(void **state) {
    shape s = make_torus(24, 12, 0.4, 0);
    size_t fail_at, failures = 0, steady = 0;
    (void)state;
    for (fail_at = 0; fail_at < 40; ++fail_at) {
        counting c = {0, 0, 0};
        sil_allocator allocator = {counting_alloc, counting_free, NULL};
        sil_result result;
        sil_dashes *dashes;
        int frame;
        allocator.user = &c;
        c.fail_at = fail_at;
        dashes = sil_dashes_create(&allocator, &result);
        assert_int_equal(result, dashes ? SIL_OK : SIL_OUT_OF_MEMORY);
        failures += !dashes;
        for (frame = 0; dashes && frame < 12; ++frame) {
            sil_ribbon_desc desc;
            lines l;
            look(&desc, 0.01 * frame, 0.5, 4, 1.8, 300);
            desc.dashes = even_dashes;
            desc.dash_count = 2;
            l = lines_of(&s, &desc, SIL_SILHOUETTE, NULL);
            if (frame == 8)
                steady = c.calls;
            result = sil_dashes_follow(dashes, s.mesh, NULL, l.strips, l.strip_count, l.vertices, &desc, l.along);
            assert_true(result == SIL_OK || result == SIL_OUT_OF_MEMORY);
            failures += result == SIL_OUT_OF_MEMORY;
            lines_free(&l);
        }
        if (dashes)
            assert_int_equal(c.calls, steady);
        sil_dashes_destroy(dashes);
        assert_int_equal(c.live, 0);
    }
    assert_true(failures > 5 && failures < 40);
    shape_free(&s);
}

static void test_misuse_of_dashes(void **state) {
    shape s = make_box();
    const sil_strip strip = {0, 2, 0, SIL_CREASE, 0};
    const uint32_t vertices[2] = {0, 1};
    const sil_allocator half = {counting_alloc, NULL, NULL};
    float along[2];
    sil_ribbon_desc desc;
    sil_result result;
    sil_dashes *dashes = sil_dashes_create(NULL, &result);
    (void)state;
    assert_int_equal(result, SIL_OK);
    look(&desc, 0, 0, 4, 1, 100);
    assert_int_equal(sil_dashes_follow(dashes, s.mesh, NULL, &strip, 1, vertices, &desc, along), SIL_INVALID_ARGUMENT);
    desc.dashes = even_dashes;
    desc.dash_count = 2;
    assert_int_equal(sil_dashes_follow(dashes, s.mesh, NULL, &strip, 1, vertices, &desc, along), SIL_OK);
    assert_int_equal(sil_dashes_follow(NULL, s.mesh, NULL, &strip, 1, vertices, &desc, along), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_dashes_follow(dashes, NULL, NULL, &strip, 1, vertices, &desc, along), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_dashes_follow(dashes, s.mesh, NULL, NULL, 1, vertices, &desc, along), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_dashes_follow(dashes, s.mesh, NULL, &strip, 1, NULL, &desc, along), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_dashes_follow(dashes, s.mesh, NULL, &strip, 1, vertices, NULL, along), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_dashes_follow(dashes, s.mesh, NULL, &strip, 1, vertices, &desc, NULL), SIL_INVALID_ARGUMENT);
    assert_null(sil_dashes_create(&half, &result));
    assert_int_equal(result, SIL_INVALID_ARGUMENT);
    sil_dashes_forget(NULL);
    sil_dashes_destroy(NULL);
    sil_dashes_destroy(dashes);
    shape_free(&s);
}

/* ---- corners ---- */

/* A box's outline turns at every vertex; by how much is worked out here for the mesh, the screen and the world. */
static void test_corners(void **state) {
    shape box = make_box();
    sil_ribbon_desc desc;
    sil_chain_desc chain;
    lines l, whole;
    size_t i, k, ends;
    (void)state;
    look(&desc, 0.6, 0.4, 4, 1.8, 600);
    memset(&chain, 0, sizeof chain);
    whole = lines_of(&box, &desc, SIL_SILHOUETTE, &chain);
    assert_true(whole.strip_count == 1 && whole.strips[0].closed && whole.strips[0].count == 7);
    chain.corner_degrees = 60; /* in the mesh all turns are right angles */
    l = lines_of(&box, &desc, SIL_SILHOUETTE, &chain);
    assert_int_equal(l.strip_count, 6);
    for (i = 0; i < 6; ++i) {
        assert_true(!l.strips[i].closed && l.strips[i].count == 2);
        assert_int_equal(l.strips[i].id, l.edges[i].edge); /* each is its own smallest */
    }
    lines_free(&l);
    chain.corner_degrees = 91;
    l = lines_of(&box, &desc, SIL_SILHOUETTE, &chain);
    assert_int_equal(l.strip_count, 1);
    lines_free(&l);
    /* on the screen: as many as there are turns of more than that there */
    memcpy(chain.matrix, desc.projection, sizeof chain.matrix);
    for (i = 0; i < 16; ++i) {
        double sum = 0;
        for (k = 0; k < 4; ++k)
            sum += (double)desc.projection[4 * k + i % 4] * (double)desc.model_view[i / 4 * 4 + k];
        chain.matrix[i] = (float)sum;
    }
    chain.viewport_width = chain.viewport_height = 600;
    for (chain.corner_degrees = 20; chain.corner_degrees < 130; chain.corner_degrees += 7) {
        for (i = 0, ends = 0; i < 6; ++i) {
            const double *a = whole.screen[i ? i - 1 : 5], *b = whole.screen[i], *c = whole.screen[i + 1];
            double turn = atan2(c[1] - b[1], c[0] - b[0]) - atan2(b[1] - a[1], b[0] - a[0]);
            turn = fabs(turn - 2 * PI * floor(turn / (2 * PI) + 0.5));
            ends += turn * 180 / PI > (double)chain.corner_degrees;
        }
        l = lines_of(&box, &desc, SIL_SILHOUETTE, &chain);
        assert_int_equal(l.strip_count, ends ? ends : 1);
        lines_free(&l);
    }
    /* in the world: sheared, so that some right angles are sharp and some blunt there */
    memset(&chain, 0, sizeof chain);
    chain.matrix[0] = chain.matrix[5] = chain.matrix[10] = chain.matrix[15] = 1;
    chain.matrix[4] = 2; /* x + 2 y */
    for (chain.corner_degrees = 20; chain.corner_degrees < 170; chain.corner_degrees += 7) {
        for (i = 0, ends = 0; i < 6; ++i) {
            double d[2][3], dot = 0, squares[2] = {0, 0};
            for (k = 0; k < 2; ++k) {
                const float *a = box.positions + 3 * whole.vertices[k ? i : i ? i - 1 : 5];
                const float *b = box.positions + 3 * whole.vertices[i + k];
                d[k][0] = (double)b[0] - (double)a[0] + 2 * ((double)b[1] - (double)a[1]);
                d[k][1] = (double)b[1] - (double)a[1];
                d[k][2] = (double)b[2] - (double)a[2];
            }
            for (k = 0; k < 3; ++k) {
                dot += d[0][k] * d[1][k];
                squares[0] += d[0][k] * d[0][k];
                squares[1] += d[1][k] * d[1][k];
            }
            ends += acos(dot / sqrt(squares[0] * squares[1])) * 180 / PI > (double)chain.corner_degrees;
        }
        l = lines_of(&box, &desc, SIL_SILHOUETTE, &chain);
        assert_int_equal(l.strip_count, ends ? ends : 1);
        lines_free(&l);
    }
    chain.corner_degrees = 20;
    chain.matrix[3] = NAN; /* no corners */
    l = lines_of(&box, &desc, SIL_SILHOUETTE, &chain);
    assert_int_equal(l.strip_count, 1);
    lines_free(&l);
    lines_free(&whole);
    shape_free(&box);
}

/* Strips without concave silhouettes are those of the other edges, each once. */
static void test_without_concave(void **state) {
    shape s = make_torus(64, 32, 0.4, 0);
    sil_ribbon_desc desc;
    sil_chain_desc chain;
    lines l;
    size_t i, concave = 0, segments = 0;
    (void)state;
    look(&desc, 0.6, 0.4, 4, 1.8, 600);
    memset(&chain, 0, sizeof chain);
    chain.flags = SIL_CHAIN_NO_CONCAVE;
    l = lines_of(&s, &desc, SIL_SILHOUETTE, &chain);
    for (i = 0; i < l.edge_count; ++i)
        concave += (l.edges[i].kinds & SIL_CONCAVE) != 0;
    for (i = 0; i < l.strip_count; ++i)
        segments += l.strips[i].count - 1;
    assert_true(concave > 3);
    assert_int_equal(segments, l.edge_count - concave);
    lines_free(&l);
    shape_free(&s);
}

/* ---- smooth silhouettes ---- */

/* An icosahedron divided `levels` times, its vertices on the unit sphere; those divided edges have vertices of their own
   in each face, which welding joins: the same rounding both ways. */
static void divide(shape *s, const double *a, const double *b, const double *c, int levels) {
    const double *const corner[3] = {a, b, c};
    double middle[3][3];
    uint32_t v[3];
    int i, k;
    if (levels == 0) {
        for (i = 0; i < 3; ++i)
            v[i] = add_vertex(s, corner[i][0], corner[i][1], corner[i][2]);
        add_face(s, v[0], v[1], v[2]);
        return;
    }
    for (i = 0; i < 3; ++i) {
        double length = 0;
        for (k = 0; k < 3; ++k)
            middle[i][k] = corner[i][k] + corner[(i + 1) % 3][k];
        for (k = 0; k < 3; ++k)
            length += middle[i][k] * middle[i][k];
        for (k = 0; k < 3; ++k)
            middle[i][k] /= sqrt(length);
    }
    divide(s, a, middle[0], middle[2], levels - 1);
    divide(s, middle[0], b, middle[1], levels - 1);
    divide(s, middle[2], middle[1], c, levels - 1);
    divide(s, middle[0], middle[1], middle[2], levels - 1);
}

static shape make_sphere(int levels) {
    static const int faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    const double g = (1 + sqrt(5.0)) / 2, l = sqrt(1 + g * g);
    shape s = shape_new(60u << 2 * levels, 20u << 2 * levels);
    double corner[12][3];
    int i, k;
    for (i = 0; i < 12; ++i)
        for (k = 0; k < 3; ++k)
            corner[i][k] = 0;
    for (i = 0; i < 4; ++i) {
        const double one = i & 1 ? 1 : -1, phi = i & 2 ? -g : g;
        corner[i][0] = one / l;
        corner[i][1] = phi / l;
        corner[4 + i][1] = one / l;
        corner[4 + i][2] = phi / l;
        corner[8 + i][2] = one / l;
        corner[8 + i][0] = phi / l;
    }
    for (i = 0; i < 20; ++i)
        divide(&s, corner[faces[i][0]], corner[faces[i][1]], corner[faces[i][2]], levels);
    shape_finish(&s);
    assert_int_equal(sil_mesh_get_info(s.mesh).closed, 1);
    assert_int_equal(sil_mesh_get_info(s.mesh).flipped_edge_count, 0);
    return s;
}

typedef struct smooth {
    sil_smooth_point *points;
    sil_strip *strips;
    size_t point_count, strip_count;
} smooth;

static smooth smooth_of(const sil_mesh *mesh, sil_pose *pose, const sil_view *view, const float *normals,
                        unsigned flags) {
    smooth l;
    size_t again;
    l.strip_count = sil_smooth(mesh, pose, view, normals, 0, flags, NULL, 0, NULL, 0, &l.point_count);
    l.points = (sil_smooth_point *)malloc((l.point_count + 1) * sizeof *l.points);
    l.strips = (sil_strip *)malloc((l.strip_count + 1) * sizeof *l.strips);
    assert_true(l.points && l.strips);
    assert_int_equal(
        sil_smooth(mesh, pose, view, normals, 0, flags, l.points, l.point_count, l.strips, l.strip_count, &again),
        l.strip_count);
    assert_int_equal(again, l.point_count);
    return l;
}

static void smooth_free(smooth *l) {
    free(l->points);
    free(l->strips);
}

static double dot(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* On a sphere with its own normals, n * (eye - p) is linear in p: all points lie in the plane of the circle of contact,
   p * eye = 1, and below the sphere by no more than the sagitta of the longest edge h, h^2 / 8; with Hermite curves by
   h^4 / 42.6 (the middle of an edge of angle a has radius 1 - 9 / 384 a^4 to that order). */
static void test_smooth_sphere(void **state) {
    double worst_before[2] = {0, 0};
    int levels, curved, made;
    (void)state;
    for (levels = 2; levels < 5; ++levels)
        for (curved = 0; curved < 2; ++curved) {
            double worst = 0, plane = 0;
            for (made = 0; made < 6; ++made) {
                shape s = make_sphere(levels);
                double eye[3] = {1.3 + made, 2.1, -0.7 * made}, longest = 0, h2;
                sil_view view = sil_view_perspective(eye);
                smooth l =
                    smooth_of(s.mesh, NULL, &view, made % 2 ? s.positions : NULL, curved ? SIL_SMOOTH_HERMITE : 0);
                size_t i;
                int k;
                for (i = 0; i < s.index_count; ++i) {
                    double square = 0;
                    for (k = 0; k < 3; ++k)
                        square += pow((double)s.positions[3 * s.indices[i] + (size_t)k] -
                                          (double)s.positions[3 * s.indices[i % 3 == 2 ? i - 2 : i + 1] + (size_t)k],
                                      2);
                    longest = fmax(longest, square);
                }
                h2 = longest;
                assert_int_equal(l.strip_count, 1);
                assert_int_equal(l.strips[0].closed, 1);
                for (i = 0; i < l.point_count; ++i) {
                    const double p[3] = {(double)l.points[i].position[0], (double)l.points[i].position[1],
                                         (double)l.points[i].position[2]};
                    const double below = 1 - sqrt(dot(p, p));
                    assert_true(below > -1e-6 && below < (curved ? h2 * h2 / 42 : h2 / 8) * 1.02 + 1e-6);
                    worst = fmax(worst, below);
                    plane = fmax(plane, fabs(dot(p, eye) - 1) / sqrt(dot(eye, eye)));
                }
                smooth_free(&l);
                shape_free(&s);
            }
            print_message("smooth sphere, %d faces%s: %.2g inside, %.2g off the plane of contact\n", 20 << 2 * levels,
                          curved ? ", Hermite" : "", worst, plane);
            assert_true(plane < (curved ? 2 * worst + 1e-6 : 1e-6));
            if (levels > 2) /* a quarter, a sixteenth */
                assert_true(worst < worst_before[curved] / (curved ? 12 : 3.5));
            worst_before[curved] = worst;
        }
}

/* Closed loops in every view, whatever the normals; each face whose corners differ is passed once. Whole numbers make
   zeros, which are positive; sums of three products of them are exact. */
static void test_smooth_closed_loops(void **state) {
    shape s = make_torus(24, 12, 0.4, 0.2);
    float *normals = (float *)malloc(3 * s.vertex_count * sizeof *normals), *posed = NULL;
    int round;
    size_t zeros = 0, loops = 0;
    (void)state;
    assert_non_null(normals);
    posed = (float *)malloc(3 * s.vertex_count * sizeof *posed);
    assert_non_null(posed);
    for (round = 0; round < 60; ++round) {
        const int whole = round % 2;
        sil_pose *pose = sil_pose_create(s.mesh, NULL);
        sil_view view;
        smooth l;
        double *value = (double *)malloc(s.vertex_count * sizeof *value);
        unsigned char *passed = (unsigned char *)calloc(s.index_count / 3, 1);
        size_t i, j, crossed = 0;
        int k;
        assert_true(value && passed && pose);
        for (k = 0; k < 4; ++k)
            view.eye[k] = whole ? (double)((int)(random_bits() % 5) - 2) : random_in(-2, 2);
        view.eye[3] = round % 3 ? 1 : 0;
        if (!(fabs(view.eye[0]) + fabs(view.eye[1]) > 0))
            view.eye[0] = 1;
        for (i = 0; i < s.vertex_count; ++i) {
            for (k = 0; k < 3; ++k) {
                posed[3 * i + (size_t)k] = whole ? (float)((int)(random_bits() % 5) - 2)
                                                 : s.positions[3 * i + (size_t)k] + (float)random_in(-0.05, 0.05);
                normals[3 * i + (size_t)k] = whole ? 0 : (float)random_in(-1, 1);
            }
            if (whole) /* along an axis: unit as they are */
                normals[3 * i + random_bits() % 3] = random_bits() % 2 ? 1 : -1;
        }
        assert_int_equal(sil_pose_set(pose, posed, 0), SIL_OK);
        l = smooth_of(s.mesh, pose, &view, normals, round % 4 == 3 ? SIL_SMOOTH_HERMITE : 0);
        for (i = 0; i < s.vertex_count; ++i) {
            value[i] = 0;
            for (k = 0; k < 3; ++k)
                value[i] +=
                    (double)normals[3 * i + (size_t)k] * (view.eye[k] - view.eye[3] * (double)posed[3 * i + (size_t)k]);
            zeros += whole && !(fabs(value[i]) > 0);
        }
        for (i = 0; i < s.index_count; i += 3) {
            int positive = 0;
            for (k = 0; k < 3; ++k)
                positive += value[s.indices[i + (size_t)k]] >= 0;
            crossed += positive == 1 || positive == 2;
        }
        loops += l.strip_count;
        assert_int_equal(l.point_count, crossed + l.strip_count);
        for (i = 0; i < l.strip_count; ++i) {
            const sil_strip *strip = &l.strips[i];
            uint32_t least = SIL_NONE;
            assert_int_equal(strip->closed, 1);
            assert_memory_equal(&l.points[strip->first], &l.points[strip->first + strip->count - 1], sizeof *l.points);
            for (j = strip->first; j < strip->first + strip->count; ++j) {
                const sil_smooth_point *p = &l.points[j];
                assert_true((value[p->a] >= 0) != (value[p->b] >= 0) && p->t >= 0 && p->t <= 1);
                least = p->edge < least ? p->edge : least;
                for (k = 0; k < 3; ++k) {
                    const double a = (double)posed[3 * p->a + (size_t)k], b = (double)posed[3 * p->b + (size_t)k];
                    const double t = value[p->a] / (value[p->a] - value[p->b]);
                    assert_true(isfinite(p->position[k]) && isfinite(p->normal[k]));
                    if (round % 4 != 3 && whole)
                        assert_true(fabs((double)p->position[k] - a - t * (b - a)) < 1e-6);
                }
            }
            assert_int_equal(strip->id, least);
        }
        free(value);
        free(passed);
        smooth_free(&l);
        sil_pose_destroy(pose);
    }
    print_message("smooth loops: %zu closed, %zu vertices exactly at right angles\n", loops, zeros);
    assert_true(loops > 100 && zeros > 100);
    free(normals);
    free(posed);
    shape_free(&s);
}

/* On a torus, the true normal at each point is at right angles to the way to the eye but for what the edges' length h
   makes: the angle falls with h^2. What is in front is on the left. */
static void test_smooth_torus(void **state) {
    double before = 0;
    int fine;
    (void)state;
    for (fine = 1; fine <= 4; fine *= 2) {
        shape s = make_torus(32 * fine, 16 * fine, 0.4, 0);
        const double eye[3] = {2.5, 1.5, 2};
        const sil_view view = sil_view_perspective(eye);
        const float *none = NULL;
        smooth l = smooth_of(s.mesh, NULL, &view, none, 0);
        double worst = 0;
        size_t i, j;
        int k;
        assert_true(l.strip_count >= 1);
        for (i = 0; i < l.strip_count; ++i)
            for (j = l.strips[i].first; j < l.strips[i].first + l.strips[i].count; ++j) {
                const sil_smooth_point *p = &l.points[j];
                const double x = (double)p->position[0], y = (double)p->position[1], ring = hypot(x, y);
                const double n[3] = {x - x / ring, y - y / ring, (double)p->position[2]};
                double way[3], ahead[3], left[3];
                for (k = 0; k < 3; ++k)
                    way[k] = eye[k] - (double)p->position[k];
                worst = fmax(worst, fabs(dot(n, way)) / sqrt(dot(n, n) * dot(way, way)));
                if (j + 1 == l.strips[i].first + l.strips[i].count)
                    continue;
                for (k = 0; k < 3; ++k)
                    ahead[k] = (double)l.points[j + 1].position[k] - (double)p->position[k];
                for (k = 0; k < 3; ++k) /* normal x ahead */
                    left[k] = n[(k + 1) % 3] * ahead[(k + 2) % 3] - n[(k + 2) % 3] * ahead[(k + 1) % 3];
                for (k = 0; k < 3; ++k) /* a step to the left, onto what is turned more toward the eye */
                    left[k] *= 1e-3 / sqrt(dot(ahead, ahead) * dot(n, n));
                if (dot(ahead, ahead) > 1e-4 / fine / fine) {
                    const double sx = x + left[0], sy = y + left[1], r = hypot(sx, sy);
                    const double m[3] = {sx - sx / r, sy - sy / r, (double)p->position[2] + left[2]};
                    const double toward[3] = {way[0] - left[0], way[1] - left[1], way[2] - left[2]};
                    assert_true(dot(m, toward) / sqrt(dot(m, m)) > dot(n, way) / sqrt(dot(n, n)));
                }
            }
        print_message("smooth torus of %zu faces: at most %.2g from a right angle\n", s.index_count / 3, worst);
        if (fine > 1)
            assert_true(worst < before / 3);
        before = worst;
        smooth_free(&l);
        shape_free(&s);
    }
}

/* An open sheet's lines end at its border; a sheet of one face has one segment; bad input has none. */
static void test_smooth_borders_and_misuse(void **state) {
    const float positions[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, NAN, 0, 0};
    const float broken[12] = {0, 0, 0, 1, 0, 0, 0, NAN, 0, 0, 0, 0};
    const uint32_t indices[3] = {0, 1, 2};
    const float normals[12] = {1, 0, 1, -1, 0, 1, 1, 0, 1, 0, 0, 0}, nothing[12] = {NAN, 0, 0, 0, INFINITY, 0, 0, 0, 0};
    const double toward[3] = {1, 0, 0}, bad[3] = {(double)NAN, 0, 0}, zero[3] = {0, 0, 0};
    counting c = {0, 0, (size_t)-1};
    sil_mesh_desc desc;
    sil_mesh *mesh;
    sil_pose *pose;
    sil_view view = sil_view_orthographic(toward), none = sil_view_perspective(bad),
             nowhere = sil_view_orthographic(zero);
    sil_smooth_point points[3];
    sil_strip strip[2];
    sil_ribbon_desc ribbon;
    size_t needed, before;
    (void)state;
    memset(&desc, 0, sizeof desc);
    desc.positions = positions;
    desc.vertex_count = 4;
    desc.indices = indices;
    desc.index_count = 3;
    desc.allocator.alloc_fn = counting_alloc;
    desc.allocator.free_fn = counting_free;
    desc.allocator.user = &c;
    mesh = sil_mesh_create(&desc, NULL);
    assert_non_null(mesh);
    memset(points, 0, sizeof points);
    assert_int_equal(sil_smooth(mesh, NULL, &view, normals, 0, 0, points, 1, strip, 2, &needed), 1);
    assert_int_equal(needed, 2);
    assert_true(strip[0].count == 2 && !strip[0].closed && strip[0].kinds == SIL_SILHOUETTE);
    assert_int_equal(points[1].a, 0); /* not written: there was room for one */
    assert_int_equal(sil_smooth(mesh, NULL, &view, normals, 0, 0, points, 3, strip, 2, NULL), 1);
    assert_true(fabs((double)points[0].position[0] - 0.5) < 1e-6 && fabs((double)points[1].position[0] - 0.5) < 1e-6);
    assert_true(fabs((double)points[0].normal[2] - 1) < 1e-6);
    assert_int_equal(sil_smooth(mesh, NULL, &view, nothing, 0, 0, points, 3, strip, 2, NULL),
                     0); /* all zero: positive */
    assert_int_equal(sil_smooth(mesh, NULL, &none, normals, 0, 0, points, 3, strip, 2, NULL), 0);
    assert_int_equal(sil_smooth(mesh, NULL, &nowhere, normals, 0, 0, points, 3, strip, 2, NULL), 0);
    assert_int_equal(sil_smooth(mesh, NULL, NULL, normals, 0, 0, points, 3, strip, 2, NULL), 0);
    assert_int_equal(sil_smooth(NULL, NULL, &view, normals, 0, 0, points, 3, strip, 2, NULL), 0);
    assert_int_equal(sil_smooth(mesh, NULL, &view, normals, 4, 0, points, 3, strip, 2, NULL), 0);
    memset(&ribbon, 0, sizeof ribbon); /* what comes out goes into ribbons */
    ribbon = screen_desc(points[0].position, 2);
    ribbon.point_stride = sizeof *points;
    assert_true(sil_ribbons(NULL, NULL, strip, 1, NULL, &ribbon, NULL, 0) > 0);
    ribbon.point_count = 1; /* a range that goes past the points */
    assert_int_equal(sil_ribbons(NULL, NULL, strip, 1, NULL, &ribbon, NULL, 0), 0);
    c.fail_at = c.calls;
    assert_int_equal(sil_smooth(mesh, NULL, &view, normals, 0, 0, points, 3, strip, 2, &needed), 0);
    assert_true(needed == SIZE_MAX);
    pose = sil_pose_create(mesh, NULL);
    assert_int_equal(sil_smooth(mesh, pose, &view, normals, 0, 0, points, 3, strip, 2, &needed), 1);
    before = c.calls; /* the pose keeps its scratch memory */
    assert_int_equal(sil_smooth(mesh, pose, &view, normals, 0, 0, points, 3, strip, 2, &needed), 1);
    assert_int_equal(c.calls, before);
    assert_int_equal(sil_pose_set(pose, broken, 0), SIL_OK);
    assert_int_equal(sil_smooth(mesh, pose, &view, normals, 0, 0, points, 3, strip, 2, &needed), 0);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    assert_int_equal(c.live, 0);
}

/* ---- rubbish ---- */

/* Any float: often a plain number, sometimes any bits at all. */
static float any_float(double reach) {
    const uint32_t bits = random_bits();
    float value;
    if (random_bits() % 16)
        return (float)random_in(-reach, reach);
    memcpy(&value, &bits, sizeof value);
    return value;
}

static void any_floats(float *out, size_t count, double reach) {
    size_t i;
    for (i = 0; i < count; ++i)
        out[i] = any_float(reach);
}

enum { RUBBISH = 40 };

/* Whatever the arguments: no crash, no hang, no more than was counted, nothing but numbers in a window of usual size. */
static void test_rubbish(void **state) {
    static float points[3 * RUBBISH], widths[RUBBISH], along[RUBBISH], dashes[6], depth[64];
    static sil_ribbon_vertex out[30000];
    static sil_smooth_point smooth_points[64];
    shape s = make_torus(8, 5, 0.4, 0);
    sil_dashes *dashes_state = sil_dashes_create(NULL, NULL);
    size_t drawn = 0;
    int round;
    (void)state;
    for (round = 0; round < 1500; ++round) {
        sil_ribbon_desc desc = screen_desc(points, RUBBISH);
        sil_image image;
        sil_strip strips[4];
        sil_view view;
        uint32_t vertices[RUBBISH];
        float phases[4];
        size_t count, i, k;
        any_floats(points, 3 * RUBBISH, round % 3 ? 250 : 2);
        any_floats(widths, RUBBISH, 2);
        any_floats(along, RUBBISH, 500);
        any_floats(phases, 4, 100);
        any_floats(dashes, 6, 20);
        any_floats(depth, 64, 1);
        if (round % 4)
            for (i = 0; i < 6; ++i)
                dashes[i] = fabsf(dashes[i]);
        if (round % 5 == 0)
            any_floats(desc.model_view, 16, 2);
        if (round % 7 == 0)
            any_floats(desc.projection, 16, 2);
        for (i = 0; i < RUBBISH; ++i)
            vertices[i] = random_bits() % 8 ? random_bits() % 45 : random_bits();
        for (i = 0; i < 4; ++i) {
            strips[i].first = random_bits() % RUBBISH;
            strips[i].count = random_bits() % (RUBBISH + 1 - strips[i].first);
            strips[i].id = random_bits();
            strips[i].kinds = random_bits() % 4 ? 1u << random_bits() % 4 : random_bits();
            strips[i].closed = random_bits() % 2;
        }
        memset(&image, 0, sizeof image);
        image.depth = depth;
        image.width = image.height = random_bits() % 8 + (round % 3 == 0 ? 0 : 1u);
        image.stride = random_bits() % 2 ? 8 : 0;
        image.height = image.height > 7 ? 7 : image.height;
        desc.image = &image;
        desc.weight = (sil_weight)(random_bits() % 5);
        desc.cap = (sil_cap)(random_bits() % 3);
        desc.join = (sil_join)(random_bits() % 3);
        desc.width = any_float(20);
        desc.heavy = any_float(3);
        desc.thin = any_float(3);
        any_floats(desc.light, 2, 1);
        any_floats(desc.reach, 2, 20);
        desc.taper = random_bits() % 2 ? any_float(100) : 0;
        desc.widths = random_bits() % 2 ? widths : NULL;
        desc.along = random_bits() % 3 ? NULL : along;
        desc.phases = random_bits() % 2 ? phases : NULL;
        desc.dashes = random_bits() % 3 ? dashes : NULL;
        desc.dash_count = random_bits() % 8;
        if (round % 2)
            desc.points = NULL;
        if (round % 11 == 0)
            desc.viewport_width = any_float(1000);
        count = sil_ribbons(s.mesh, NULL, strips, 4, vertices, &desc, NULL, 0);
        assert_int_equal(count % 3, 0);
        assert_int_equal(sil_ribbons(s.mesh, NULL, strips, 4, vertices, &desc, out, 30000), count);
        for (i = 0; i < count && i < 30000; ++i)
            if (desc.viewport_width <= 1000) {
                assert_true(isfinite(out[i].x) && isfinite(out[i].y) && isfinite(out[i].center_x) &&
                            isfinite(out[i].arc) && out[i].depth >= 0 && out[i].depth <= 1 && out[i].slack >= 0);
            }
        drawn += count;
        desc.along = NULL;
        (void)sil_dashes_follow(dashes_state, s.mesh, NULL, strips, 4, vertices, &desc, along);
        for (k = 0; k < 4; ++k)
            view.eye[k] = (double)any_float(3);
        count = sil_smooth(s.mesh, NULL, &view, random_bits() % 2 ? points : NULL, 0, random_bits() % 2, smooth_points,
                           64, strips, 4, NULL);
        assert_true(count <= s.index_count / 3);
    }
    print_message("rubbish: %zu vertices drawn\n", drawn);
    assert_true(drawn > 20000);
    sil_dashes_destroy(dashes_state);
    shape_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_widths_of_vertices),
        cmocka_unit_test(test_widths_do_not_depend_on_the_cut),
        cmocka_unit_test(test_taper),
        cmocka_unit_test(test_thick_and_thin),
        cmocka_unit_test(test_weight_by_perspective),
        cmocka_unit_test(test_weight_by_light),
        cmocka_unit_test(test_outer_lines),
        cmocka_unit_test(test_dashes_on_a_line),
        cmocka_unit_test(test_dashes_have_caps),
        cmocka_unit_test(test_dashes_and_gaps_are_all),
        cmocka_unit_test(test_dashes_of_a_loop),
        cmocka_unit_test(test_dashes_that_make_no_sense),
        cmocka_unit_test(test_dashes_stay),
        cmocka_unit_test(test_dashes_of_a_still_picture),
        cmocka_unit_test(test_dashes_are_not_stretched_for_ever),
        cmocka_unit_test(test_memory_of_dashes),
        cmocka_unit_test(test_misuse_of_dashes),
        cmocka_unit_test(test_corners),
        cmocka_unit_test(test_without_concave),
        cmocka_unit_test(test_smooth_sphere),
        cmocka_unit_test(test_smooth_closed_loops),
        cmocka_unit_test(test_smooth_torus),
        cmocka_unit_test(test_smooth_borders_and_misuse),
        cmocka_unit_test(test_rubbish),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

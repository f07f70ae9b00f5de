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
    const float bad[][2] = {{1, -1}, {-1, 1}, {NAN, 1}, {1, INFINITY}, {0, 0}};
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
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

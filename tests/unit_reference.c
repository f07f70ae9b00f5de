/* The reference itself, held to cases whose answer was worked out by hand: counts, depths, colours and which object
 * shows through which. Most scenes look down -z through a square window of 64 x 64 pixels over [-2,2] x [-2,2] with the
 * near plane at z = 4 and the far plane at z = -4, so that the window depth of height z is (4 - z) / 8. */
#include "probes.h"
#include "reference.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <time.h>
#include <cmocka.h>

enum { SIZE = 64, MAX_OBJECTS = 16 };

typedef struct mesh {
    float *positions;
    uint32_t *indices;
    size_t vertex_count, triangle_count;
} mesh;

typedef struct stage {
    mesh meshes[MAX_OBJECTS];
    ref_object objects[MAX_OBJECTS];
    ref_scene scene;
    ref_pixel *pixels;
} stage;

static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/* ---- building scenes ---- */

static void *grown(void *old, size_t bytes) {
    void *memory = realloc(old, bytes);
    if (!memory)
        abort();
    return memory;
}

static uint32_t add_vertex(mesh *m, double x, double y, double z) {
    m->positions = grown(m->positions, (m->vertex_count + 1) * 3 * sizeof(float));
    float *v = m->positions + 3 * m->vertex_count;
    v[0] = (float)x;
    v[1] = (float)y;
    v[2] = (float)z;
    return (uint32_t)m->vertex_count++;
}

static void add_triangle(mesh *m, uint32_t a, uint32_t b, uint32_t c) {
    m->indices = grown(m->indices, (m->triangle_count + 1) * 3 * sizeof(uint32_t));
    uint32_t *t = m->indices + 3 * m->triangle_count++;
    t[0] = a;
    t[1] = b;
    t[2] = c;
}

/* Four corners counter-clockwise seen from outside; turned: cut along the other diagonal. */
static void add_quad(mesh *m, const double corners[4][3], bool turned) {
    uint32_t v[4];
    for (int i = 0; i < 4; ++i)
        v[i] = add_vertex(m, corners[i][0], corners[i][1], corners[i][2]);
    int first = turned ? 1 : 0;
    add_triangle(m, v[first], v[first + 1], v[first + 2]);
    add_triangle(m, v[first], v[first + 2], v[(first + 3) % 4]);
}

static void add_box(mesh *m, double x0, double y0, double z0, double x1, double y1, double z1, bool turned) {
    double p[2][3] = {{x0, y0, z0}, {x1, y1, z1}};
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            int u = (axis + 1) % 3, v = (axis + 2) % 3;
            double corners[4][3];
            for (int i = 0; i < 4; ++i) {
                bool at_u = i == 1 || i == 2, at_v = i >= 2;
                corners[i][axis] = p[side][axis];
                corners[i][u] = p[side ? at_u : at_v][u];
                corners[i][v] = p[side ? at_v : at_u][v];
            }
            add_quad(m, (const double(*)[3])corners, turned);
        }
}

/* A square that faces the viewer at height z. */
static void add_sheet(mesh *m, double x0, double y0, double x1, double y1, double z) {
    double corners[4][3] = {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
    add_quad(m, (const double(*)[3])corners, false);
}

static void add_sphere(mesh *m, double radius, int rings, int sectors) {
    double pi = acos(-1.0);
    uint32_t base = (uint32_t)m->vertex_count;
    for (int r = 0; r <= rings; ++r)
        for (int s = 0; s < sectors; ++s) {
            double polar = pi * r / rings, turn = 2 * pi * s / sectors;
            bool pole = r == 0 || r == rings;
            double ring = pole ? 0 : radius * sin(polar);
            add_vertex(m, ring * cos(turn), ring * sin(turn), radius * (r == rings ? -1 : cos(polar)));
        }
    for (int r = 0; r < rings; ++r)
        for (int s = 0; s < sectors; ++s) {
            uint32_t a = base + (uint32_t)(r * sectors + s), b = base + (uint32_t)(r * sectors + (s + 1) % sectors);
            uint32_t c = a + (uint32_t)sectors, d = b + (uint32_t)sectors;
            if (r > 0)
                add_triangle(m, a, d, b);
            if (r < rings - 1)
                add_triangle(m, a, c, d);
        }
}

static void turn_inside_out(mesh *m) {
    for (size_t t = 0; t < m->triangle_count; ++t) {
        uint32_t kept = m->indices[3 * t];
        m->indices[3 * t] = m->indices[3 * t + 1];
        m->indices[3 * t + 1] = kept;
    }
}

static void set_orthographic(double m[16], double half, double z_near, double z_far) {
    memcpy(m, identity, sizeof identity);
    m[0] = m[5] = 1 / half;
    m[10] = -2 / (z_far - z_near);
    m[14] = -(z_far + z_near) / (z_far - z_near);
}

static void set_perspective(double m[16], double focal, double z_near, double z_far) {
    memset(m, 0, 16 * sizeof *m);
    m[0] = m[5] = focal;
    m[10] = -(z_far + z_near) / (z_far - z_near);
    m[11] = -1;
    m[14] = -2 * z_far * z_near / (z_far - z_near);
}

/* An empty scene: background blue with weight 3/4, opaque weight 1/2, transparent things red with alpha 3/4. */
static stage *new_stage(void) {
    stage *s = calloc(1, sizeof *s);
    if (!s)
        abort();
    ref_scene *scene = &s->scene;
    scene->objects = s->objects;
    memcpy(scene->view, identity, sizeof identity);
    set_orthographic(scene->projection, 2, -4, 4);
    scene->width = scene->height = SIZE;
    scene->background[2] = 1;
    scene->opaque_weight = 0.5;
    scene->background_weight = 0.75;
    scene->interior = REF_INTERIOR_IMPLICIT;
    scene->blending = REF_BLEND_PUBLISHED;
    return s;
}

/* Adds an object: transparent and red, or opaque and green. Its mesh is to be filled by the caller. */
static mesh *add_object(stage *s, uint32_t id, bool transparent) {
    size_t o = s->scene.object_count++;
    assert_true(o < MAX_OBJECTS);
    ref_object *object = &s->objects[o];
    memcpy(object->model, identity, sizeof identity);
    object->id = id;
    object->transparent = transparent;
    object->color[transparent ? 0 : 1] = 1;
    object->alpha = 0.75;
    return &s->meshes[o];
}

static void connect_meshes(stage *s) {
    for (size_t o = 0; o < s->scene.object_count; ++o) {
        s->objects[o].positions = s->meshes[o].positions;
        s->objects[o].indices = s->meshes[o].indices;
        s->objects[o].vertex_count = s->meshes[o].vertex_count;
        s->objects[o].triangle_count = s->meshes[o].triangle_count;
    }
}

static void render(stage *s) {
    connect_meshes(s);
    s->pixels = grown(s->pixels, (size_t)s->scene.width * (size_t)s->scene.height * sizeof *s->pixels);
    assert_true(ref_render(&s->scene, s->pixels));
}

static void free_stage(stage *s) {
    for (size_t o = 0; o < s->scene.object_count; ++o) {
        free(s->meshes[o].positions);
        free(s->meshes[o].indices);
    }
    free(s->pixels);
    free(s);
}

/* ---- looking at pictures ---- */

/* The pixel that holds the point (x, y) of the square [-2,2] x [-2,2]. */
static const ref_pixel *at(const stage *s, double x, double y) {
    int column = (int)((x + 2) / 4 * s->scene.width), row = (int)((y + 2) / 4 * s->scene.height);
    return &s->pixels[row * s->scene.width + column];
}

static void near_to(double found, double expected, double tolerance) {
    if (!(fabs(found - expected) <= tolerance))
        fail_msg("found %.17g, expected %.17g within %g", found, expected, tolerance);
}

static void expect_surfaces(const ref_pixel *pixel, uint32_t front, uint32_t opaque) {
    if (pixel->front_object != front || pixel->opaque_object != opaque)
        fail_msg("found front %u opaque %u, expected front %u opaque %u", (unsigned)pixel->front_object,
                 (unsigned)pixel->opaque_object, (unsigned)front, (unsigned)opaque);
}

static void expect_color(const double color[3], double r, double g, double b) {
    near_to(color[0], r, 1e-12);
    near_to(color[1], g, 1e-12);
    near_to(color[2], b, 1e-12);
}

static size_t count_surfaces(const stage *s, uint32_t front, uint32_t opaque) {
    size_t count = 0;
    for (int i = 0; i < s->scene.width * s->scene.height; ++i)
        count += s->pixels[i].front_object == front && s->pixels[i].opaque_object == opaque;
    return count;
}

static size_t count_left_out(const stage *s) {
    size_t pixels = (size_t)s->scene.width * (size_t)s->scene.height;
    return (size_t)lround(ref_left_out_share(s->pixels, pixels) * (double)pixels);
}

static void expect_same_picture(const ref_pixel *a, const ref_pixel *b, size_t count, bool objects_only) {
    for (size_t i = 0; i < count; ++i) {
        assert_int_equal(a[i].front_object, b[i].front_object);
        assert_int_equal(a[i].opaque_object, b[i].opaque_object);
        assert_int_equal(a[i].left_out, b[i].left_out);
        for (int k = 0; k < 3 && !objects_only; ++k)
            assert_true(a[i].color[k] == b[i].color[k]);
        assert_true(objects_only || (a[i].front_depth == b[i].front_depth && a[i].opaque_depth == b[i].opaque_depth &&
                                     a[i].limit_depth == b[i].limit_depth));
    }
}

/* ---- formulas ---- */

static void blends(void **state) {
    (void)state;
    double front[3] = {1, 0.5, 0}, below[3] = {0, 0.5, 1}, out[3];
    ref_blend(REF_BLEND_PUBLISHED, 0.75, front, 0.5, below, out);
    expect_color(out, 0.75, 0.625, 0.5);
    ref_blend(REF_BLEND_NORMALISED, 0.75, front, 0.5, below, out);
    expect_color(out, 0.6, 0.5, 0.4);
    ref_blend(REF_BLEND_OVER, 0.75, front, 0.5, below, out);
    expect_color(out, 0.75, 0.5, 0.25);
    double white[3] = {1, 1, 1};
    ref_blend(REF_BLEND_PUBLISHED, 0.75, white, 0.5, white, out); /* 5/4, clamped */
    expect_color(out, 1, 1, 1);
    ref_blend(REF_BLEND_NORMALISED, 0.75, white, 0.5, white, out);
    expect_color(out, 1, 1, 1);
}

static void blends_without_weights(void **state) {
    (void)state;
    double front[3] = {1, 0.5, 0}, below[3] = {0, 0.5, 1}, out[3];
    ref_blend(REF_BLEND_PUBLISHED, 0, front, 0, below, out);
    expect_color(out, 0, 0, 0);
    ref_blend(REF_BLEND_NORMALISED, 0, front, 0, below, out);
    expect_color(out, 0, 0.5, 1);
    ref_blend(REF_BLEND_OVER, 0, front, 0, below, out);
    expect_color(out, 0, 0.5, 1);
    ref_blend(REF_BLEND_NORMALISED, 0.25, front, 0, below, out);
    expect_color(out, 1, 0.5, 0);
}

static void alpha_law(void **state) {
    (void)state;
    near_to(ref_alpha(1, 4, 1), 0.75, 0);
    near_to(ref_alpha(1, 4, 0.5), 0.5, 1e-15);
    near_to(ref_alpha(1, 4, 2), 0.9375, 1e-15);
    near_to(ref_alpha(4, 4, 0.5), 0, 0);
    near_to(ref_alpha(5, 4, 0.5), 0, 0); /* below 0: clamped */
    near_to(ref_alpha(1e-300, 1, 0), 0, 0);
}

static void alpha_law_with_bad_inputs(void **state) {
    (void)state;
    const double inf = (double)INFINITY, nan = (double)NAN;
    const double ks[] = {0, 0.5, 1, 3, inf, nan, -1};
    for (size_t i = 0; i < sizeof ks / sizeof ks[0]; ++i) {
        near_to(ref_alpha(0, 1, ks[i]), 1, 0);
        near_to(ref_alpha(-1, 1, ks[i]), 1, 0);
        near_to(ref_alpha(0, 0, ks[i]), 1, 0);
        near_to(ref_alpha(1, 0, ks[i]), 1, 0);
        near_to(ref_alpha(1, -1, ks[i]), 1, 0);
        near_to(ref_alpha(nan, 1, ks[i]), 1, 0);
        near_to(ref_alpha(1, nan, ks[i]), 1, 0);
        near_to(ref_alpha(inf, 0, ks[i]), 1, 0);
        near_to(ref_alpha(inf, 1, ks[i]), 0, 0);
        near_to(ref_alpha(inf, inf, ks[i]), 0, 0);
    }
    near_to(ref_alpha(0.5, 1, inf), 1, 0);
    near_to(ref_alpha(2, 1, inf), 0, 0);
    near_to(ref_alpha(1, inf, 1), 1, 0);
    near_to(ref_alpha(1, inf, 0), 0, 0);
    near_to(ref_alpha(0.5, 1, nan), 0, 0);
    near_to(ref_alpha(0.5, 1, -1), 0, 0);
}

static void distances(void **state) {
    (void)state;
    /* Along x from 0 to 3; a point at (0,5,0) written as a segment. */
    const double segments[] = {0, 0, 0, 3, 0, 0, 0, 5, 0, 0, 5, 0};
    const double above[3] = {1, 2, 0}, beyond[3] = {6, 4, 0}, beside_point[3] = {-1, 5, 2};
    near_to(ref_distance_to_segments(above, segments, 2, false), 2, 0);
    near_to(ref_distance_to_segments(beyond, segments, 1, false), 5, 1e-15);
    near_to(ref_distance_to_segments(beyond, segments, 1, true), 4, 1e-15);
    near_to(ref_distance_to_segments(beside_point, segments, 2, false), sqrt(5), 1e-15);
    near_to(ref_distance_to_segments(beside_point, segments, 2, true), sqrt(5), 1e-15);
    assert_true(isinf(ref_distance_to_segments(above, segments, 0, false)));
}

static void cool_to_warm(void **state) {
    (void)state;
    /* Ends: cool (0,0,.4) + .2 kd = (.1,.05,.6), warm (.4,.4,0) + .6 kd = (.7,.55,.6). */
    const double kd[3] = {0.5, 0.25, 1}, cool[3] = {0, 0, 0.4}, warm[3] = {0.4, 0.4, 0};
    const double l[3] = {0, 0.6, 0.8}, up[3] = {0, 0, 1}, away[3] = {0, -0.6, -0.8}, side[3] = {1, 0, 0};
    double out[3];
    ref_cool_to_warm(kd, up, l, cool, warm, 0.2, 0.6, out); /* t = .9 */
    expect_color(out, 0.64, 0.5, 0.6);
    ref_cool_to_warm(kd, l, l, cool, warm, 0.2, 0.6, out);
    expect_color(out, 0.7, 0.55, 0.6);
    ref_cool_to_warm(kd, away, l, cool, warm, 0.2, 0.6, out);
    expect_color(out, 0.1, 0.05, 0.6);
    ref_cool_to_warm(kd, side, l, cool, warm, 0.2, 0.6, out);
    expect_color(out, 0.4, 0.3, 0.6);
    ref_cool_to_warm(kd, l, l, cool, warm, 0.2, 2, out); /* (1.4, .9, 2) */
    expect_color(out, 1, 0.9, 1);
}

/* ---- the rules ---- */

/* A box with an opaque core in it. */
static void shell_around_box(void **state) {
    (void)state;
    const double expected[3][2][3] = {
        {{0.75, 0.5, 0}, {0.75, 0, 0.75}}, {{0.6, 0.4, 0}, {0.5, 0, 0.5}}, {{0.75, 0.25, 0}, {0.75, 0, 0.25}}};
    for (int blending = REF_BLEND_PUBLISHED; blending <= REF_BLEND_OVER; ++blending)
        for (int interior = REF_INTERIOR_IMPLICIT; interior <= REF_INTERIOR_IMPLICIT_PUBLISHED; ++interior) {
            stage *s = new_stage();
            s->scene.blending = (ref_blending)blending;
            s->scene.interior = (ref_interior)interior;
            add_box(add_object(s, 7, true), -1, -1, -1, 1, 1, 1, false);
            add_box(add_object(s, 9, false), -0.5, -0.5, -0.5, 0.5, 0.5, 0.5, false);
            render(s);
            assert_int_equal(count_surfaces(s, 7, 9), 16 * 16);
            assert_int_equal(count_surfaces(s, 7, 0), 32 * 32 - 16 * 16);
            assert_int_equal(count_surfaces(s, 0, 0), SIZE * SIZE - 32 * 32);
            const ref_pixel *core = at(s, 0.1, 0.1), *shell = at(s, 0.8, 0.1), *outside = at(s, 1.5, 0.1);
            near_to(core->front_depth, 3.0 / 8, 1e-15);
            near_to(core->opaque_depth, 3.5 / 8, 1e-15);
            near_to(core->limit_depth, 5.0 / 8, 1e-15);
            assert_true(isinf(shell->opaque_depth) && isinf(outside->front_depth) && isinf(outside->limit_depth));
            expect_color(core->color, expected[blending][0][0], expected[blending][0][1], expected[blending][0][2]);
            expect_color(shell->color, expected[blending][1][0], expected[blending][1][1], expected[blending][1][2]);
            expect_color(outside->color, 0, 0, 1);
            free_stage(s);
        }
}

static void sphere_around_box(void **state) {
    (void)state;
    stage *s = new_stage();
    add_sphere(add_object(s, 1, true), 1.5, 64, 128);
    add_box(add_object(s, 2, false), -0.5, -0.5, -0.5, 0.5, 0.5, 0.5, false);
    render(s);
    double pi = acos(-1.0), radius = 24, error = 0; /* pixels */
    assert_int_equal(count_surfaces(s, 1, 2), 16 * 16);
    near_to((double)(count_surfaces(s, 1, 0) + 16 * 16), pi * radius * radius, 20);
    for (int i = 0; i < SIZE * SIZE; ++i) {
        double x = (i % SIZE + 0.5) / 16 - 2, y = (i / SIZE + 0.5) / 16 - 2, square = 2.25 - x * x - y * y;
        if (square < 0.2)
            continue;
        error = fmax(error, fabs(s->pixels[i].front_depth - (4 - sqrt(square)) / 8));
        error = fmax(error, fabs(s->pixels[i].limit_depth - (4 + sqrt(square)) / 8));
    }
    /* A chord of 1/64 half turn lies up to 1.5 (1 - cos(pi/128)) = 4.5e-4 below the sphere, more along the slant. */
    assert_true(error > 0 && error < 4.5e-4 / 8 / sqrt(0.2 / 2.25) * 1.5);
    /* Left out: a ring one pixel wide at least, and by its corners 4/pi pixels on average. */
    double ring = 2 * pi * radius;
    size_t left_out = count_left_out(s);
    assert_true((double)left_out > 0.9 * ring && (double)left_out < 1.1 * ring * 4 / pi);
    free_stage(s);
}

static void eye_inside(void **state) {
    (void)state;
    stage *s = new_stage();
    set_perspective(s->scene.projection, 1, 0.1, 10);
    add_box(add_object(s, 1, true), -1, -1, -1, 1, 1, 1, false);
    add_box(add_object(s, 2, false), -0.2, -0.2, -0.8, 0.2, 0.2, -0.5, false);
    add_sheet(add_object(s, 3, false), -9, -9, 9, 9, -3);
    render(s);
    expect_surfaces(at(s, 0.01, 0.01), 0, 2);
    expect_surfaces(at(s, 1.5, 0.01), 0, 3);
    assert_true(isinf(at(s, 1.5, 0.01)->limit_depth));
    expect_color(at(s, 1.5, 0.01)->color, 0, 1, 0);
    near_to(at(s, 1.5, 0.01)->opaque_depth, 10 / 9.9 * (1 - 0.1 / 3), 1e-15);
    s->scene.interior = REF_INTERIOR_IMPLICIT_PUBLISHED; /* the hole */
    render(s);
    expect_surfaces(at(s, 0.01, 0.01), 0, 2);
    expect_surfaces(at(s, 1.5, 0.01), 0, 0);
    near_to(at(s, 1.5, 0.01)->limit_depth, 10 / 9.9 * (1 - 0.1 / 1), 1e-15);
    expect_color(at(s, 1.5, 0.01)->color, 0, 0, 1);
    free_stage(s);
}

/* A around B around an opaque core; another opaque thing between A and B. */
static void nested_shells(void **state) {
    (void)state;
    stage *s = new_stage();
    add_box(add_object(s, 1, true), -1.5, -1.5, -1.5, 1.5, 1.5, 1.5, false);
    add_box(add_object(s, 2, true), -1, -1, -1, 1, 1, 1, false);
    add_box(add_object(s, 3, false), -0.5, -0.5, -0.5, 0.5, 0.5, 0.5, false);
    add_box(add_object(s, 4, false), 0.6, 0.6, 1.1, 0.9, 0.9, 1.3, false);
    render(s);
    expect_surfaces(at(s, 0.01, 0.01), 1, 0); /* two transparent objects before the core: hidden */
    near_to(at(s, 0.01, 0.01)->limit_depth, 3.0 / 8, 1e-15);
    expect_surfaces(at(s, 0.75, 0.75), 1, 4);
    near_to(at(s, 1.2, 0.01)->limit_depth, 5.5 / 8, 1e-15); /* beside B: A's own back face */
    s->scene.interior = REF_INTERIOR_IMPLICIT_PUBLISHED;
    render(s);
    expect_surfaces(at(s, 0.01, 0.01), 1,
                    3); /* the fault: B's back face is all that limits, and the core is before it */
    near_to(at(s, 0.01, 0.01)->limit_depth, 5.0 / 8, 1e-15);
    expect_surfaces(at(s, 0.75, 0.75), 1, 4);
    free_stage(s);
}

/* A: x -1.5 to .5, z -1 to 1. B: x -.5 to 1.5, z -2 to .5. P: a bar at z .6 to .8. Q: a bar at z -.3 to 0. */
static void intersecting_shells(void **state) {
    (void)state;
    stage *s = new_stage();
    add_box(add_object(s, 11, true), -1.5, -1, -1, 0.5, 1, 1, false);
    add_box(add_object(s, 5, true), -0.5, -1, -2, 1.5, 1, 0.5, false);
    add_box(add_object(s, 20, false), -1.4, -0.2, 0.6, 1.4, 0.2, 0.8, false);
    add_box(add_object(s, 21, false), -1.4, 0.4, -0.3, 1.4, 0.8, 0, false);
    render(s);
    expect_surfaces(at(s, -1, 0), 11, 20);
    expect_surfaces(at(s, 0, 0), 11, 20);
    expect_surfaces(at(s, 1, 0), 0, 20); /* before B: alone */
    expect_surfaces(at(s, -1, 0.6), 11, 21);
    expect_surfaces(at(s, 0, 0.6), 11, 0); /* occluded by A and B */
    expect_surfaces(at(s, 1, 0.6), 5, 21);
    expect_color(at(s, 1, 0)->color, 0, 1, 0);
    near_to(at(s, 0, 0.6)->limit_depth, 3.5 / 8, 1e-15);
    near_to(at(s, -1, 0.6)->limit_depth, 5.0 / 8, 1e-15);
    near_to(at(s, 1, 0.6)->limit_depth, 6.0 / 8, 1e-15);
    free_stage(s);
}

static void make_coincident(stage *s, bool swapped, bool turned) {
    for (int i = 0; i < 2; ++i) {
        bool first = (i == 0) != swapped;
        add_box(add_object(s, first ? 8 : 3, true), -1, -1, first ? -1 : -0.5, 1, 1, 0.7, first && turned);
        s->objects[i].color[1] = first ? 0 : 1;
    }
    add_box(add_object(s, 9, false), -0.5, -0.5, -0.3, 0.5, 0.5, 0.3, false);
}

/* Two boxes share their front face. The face of the lowest id is blended and nothing shows through, in whatever order
 * the objects come, however they are triangulated, seen along the axis or from aslant in perspective. */
static void coincident_fronts(void **state) {
    (void)state;
    for (int variant = 0; variant < 8; ++variant) {
        stage *s = new_stage();
        make_coincident(s, variant & 1, variant & 2);
        if (variant & 4) {
            set_perspective(s->scene.projection, 2.5, 1, 20);
            const double tilted[16] = {0.8, 0.36, -0.48, 0, 0, 0.8, 0.6, 0, 0.6, -0.48, 0.64, 0, 0.1, 0.2, -6, 1};
            memcpy(s->scene.view, tilted, sizeof tilted);
        }
        render(s);
        size_t seen = 0;
        for (int i = 0; i < SIZE * SIZE; ++i) {
            const ref_pixel *p = &s->pixels[i];
            if (fabs(p->limit_depth - p->front_depth) < 1e-14) {
                ++seen;
                expect_surfaces(p, 3, 0);
            }
        }
        /* From aslant the sides are next to one another as well, and the longer box shows alone at its end. */
        assert_true(variant & 4 ? seen > 500 : seen == 32 * 32);
        assert_int_equal(count_surfaces(s, 3, 0), seen);
        free_stage(s);
    }
}

/* One unit in the last place of a float apart is not coincident: the nearer wins, not the lower id. */
static void one_ulp_apart(void **state) {
    (void)state;
    stage *s = new_stage();
    add_box(add_object(s, 1, true), -1, -1, -1, 1, 1, 1, false);
    add_box(add_object(s, 2, true), -1, -1, -1, 1, 1, (double)nextafterf(1.0f, 2.0f), true);
    render(s);
    assert_int_equal(count_surfaces(s, 2, 0), 32 * 32);
    free_stage(s);
}

static void two_sided_sheet(void **state) {
    (void)state;
    for (int back = 0; back < 2; ++back)
        for (int interior = REF_INTERIOR_IMPLICIT; interior <= REF_INTERIOR_IMPLICIT_PUBLISHED; ++interior) {
            stage *s = new_stage();
            s->scene.interior = (ref_interior)interior;
            mesh *sheet = add_object(s, 4, true);
            add_sheet(sheet, -1, -1, 1, 1, 1);
            if (back)
                turn_inside_out(sheet);
            s->objects[0].two_sided = true;
            add_box(add_object(s, 6, false), -0.5, -0.5, -0.5, 0.5, 0.5, 0.5, false);
            render(s);
            assert_int_equal(count_surfaces(s, 4, 6), 16 * 16);
            assert_int_equal(count_surfaces(s, 4, 0), 32 * 32 - 16 * 16);
            assert_true(isinf(at(s, 0.1, 0.1)->limit_depth));
            free_stage(s);
        }
}

/* Behind the sheet a closed object with a core: two transparent objects, the core is hidden by default. */
static void sheet_before_shell(void **state) {
    (void)state;
    stage *s = new_stage();
    add_sheet(add_object(s, 4, true), -1.5, -1.5, 0.25, 1.5, 2);
    s->objects[0].two_sided = true;
    add_box(add_object(s, 5, true), -1, -1, -1, 1, 1, 1, false);
    add_box(add_object(s, 6, false), -0.5, -0.5, -0.5, 0.5, 0.5, 0.5, false);
    render(s);
    expect_surfaces(at(s, -0.1, 0.1), 4, 0);
    expect_surfaces(at(s, 0.4, 0.1), 5, 6);
    free_stage(s);
}

/* An open sheet of one side, seen from behind, before an opaque wall. */
static void back_face_without_front(void **state) {
    (void)state;
    stage *s = new_stage();
    mesh *sheet = add_object(s, 4, true);
    add_sheet(sheet, -1, -1, 1, 1, 1);
    turn_inside_out(sheet);
    add_sheet(add_object(s, 6, false), -2, -2, 2, 2, 0);
    render(s);
    assert_int_equal(count_surfaces(s, 0, 6), SIZE * SIZE);
    s->scene.interior = REF_INTERIOR_IMPLICIT_PUBLISHED;
    render(s);
    assert_int_equal(count_surfaces(s, 0, 0), 32 * 32);
    assert_int_equal(count_surfaces(s, 0, 6), SIZE * SIZE - 32 * 32);
    free_stage(s);
}

/* The same sheet before a closed object: published hides its front face as well, the default does not limit by it. */
static void back_face_before_front(void **state) {
    (void)state;
    stage *s = new_stage();
    mesh *sheet = add_object(s, 4, true);
    add_sheet(sheet, -1, -1, 0, 1, 2);
    turn_inside_out(sheet);
    add_box(add_object(s, 5, true), -1, -1, -1, 1, 1, 1, false);
    add_box(add_object(s, 6, false), -0.5, -0.5, -0.5, 0.5, 0.5, 0.5, false);
    render(s);
    assert_int_equal(count_surfaces(s, 5, 6), 16 * 16);
    s->scene.interior = REF_INTERIOR_IMPLICIT_PUBLISHED;
    render(s);
    assert_int_equal(count_surfaces(s, 5, 6), 16 * 8);
    assert_int_equal(count_surfaces(s, 0, 0), SIZE * SIZE - 32 * 16);
    free_stage(s);
}

/* D02 figure 4 (b): a C of two arms, z 0.5 to 1.5 and -1.5 to -0.5, joined at x -1.5 to -1. */
static void add_c_shape(mesh *m) {
    const double profile[8][2] = {{-1.5, 1.5}, {1.5, 1.5},  {1.5, 0.5},  {-1, 0.5},
                                  {-1, -0.5},  {1.5, -0.5}, {1.5, -1.5}, {-1.5, -1.5}};
    for (int i = 0; i < 8; ++i) {
        const double *a = profile[i], *b = profile[(i + 1) % 8];
        double corners[4][3] = {{a[0], -1, a[1]}, {b[0], -1, b[1]}, {b[0], 1, b[1]}, {a[0], 1, a[1]}};
        add_quad(m, (const double(*)[3])corners, false);
    }
    const double caps[3][4] = {{-1.5, 0.5, 1.5, 1.5}, {-1.5, -0.5, -1, 0.5}, {-1.5, -1.5, 1.5, -0.5}};
    for (int i = 0; i < 3; ++i)
        for (int top = 0; top < 2; ++top) {
            const double *c = caps[i], y = top ? 1 : -1, z0 = top ? c[3] : c[1], z1 = top ? c[1] : c[3];
            double corners[4][3] = {{c[0], y, z0}, {c[2], y, z0}, {c[2], y, z1}, {c[0], y, z1}};
            add_quad(m, (const double(*)[3])corners, false);
        }
}

static void concave_object(void **state) {
    (void)state;
    for (int interior = REF_INTERIOR_IMPLICIT; interior <= REF_INTERIOR_IMPLICIT_PUBLISHED; ++interior) {
        stage *s = new_stage();
        s->scene.interior = (ref_interior)interior;
        add_c_shape(add_object(s, 1, true));
        add_box(add_object(s, 2, false), -0.7, -0.5, 0.8, -0.3, 0.5, 1.2, false);   /* in the first arm */
        add_box(add_object(s, 3, false), 0.2, -0.5, -1.2, 0.6, 0.5, -0.8, false);   /* in the second arm */
        add_box(add_object(s, 4, false), 1, -0.5, -0.2, 1.4, 0.5, 0.2, false);      /* in the gap between them */
        add_box(add_object(s, 5, false), -1.4, -0.5, -1.2, -1.1, 0.5, -0.8, false); /* as deep, where they are joined */
        render(s);
        expect_surfaces(at(s, -0.5, 0), 1, 2);
        expect_surfaces(at(s, 0.4, 0), 1, 0);
        expect_surfaces(at(s, 1.2, 0), 1, 0);
        expect_surfaces(at(s, -1.25, 0), 1, 5);
        near_to(at(s, 0.4, 0)->limit_depth, 3.5 / 8, 1e-15);
        near_to(at(s, -1.25, 0)->limit_depth, 5.5 / 8, 1e-15);
        assert_int_equal(count_surfaces(s, 1, 0) + count_surfaces(s, 1, 2) + count_surfaces(s, 1, 5), 48 * 32);
        free_stage(s);
    }
}

/* Opaque things exactly at the depth of the front face, of the limit, and of one another. */
static void opaque_at_equal_depth(void **state) {
    (void)state;
    stage *s = new_stage();
    add_box(add_object(s, 1, true), -1, -1, -1, 1, 1, 1, false);
    add_sheet(add_object(s, 12, false), -1, -1, 0, 0, 1);  /* at the front face: blended */
    add_sheet(add_object(s, 13, false), 0, -1, 1, 0, -1);  /* at the back face: hidden */
    add_sheet(add_object(s, 15, false), -1, 0, 1, 1, 0.5); /* two of them at once: the lower id */
    add_sheet(add_object(s, 14, false), -1, 0, 1, 1, 0.5);
    render(s);
    assert_int_equal(count_surfaces(s, 1, 12), 16 * 16);
    assert_int_equal(count_surfaces(s, 1, 0), 16 * 16);
    assert_int_equal(count_surfaces(s, 1, 14), 32 * 16);
    free_stage(s);
}

static void opaque_faces(void **state) {
    (void)state;
    stage *s = new_stage();
    for (int i = 0; i < 2; ++i) {
        mesh *sheet = add_object(s, (uint32_t)(i + 1), false);
        add_sheet(sheet, -1 + i, -1, i, 1, 0);
        turn_inside_out(sheet);
        s->objects[i].two_sided = i == 1;
    }
    render(s);
    assert_int_equal(count_surfaces(s, 0, 1), 0);
    assert_int_equal(count_surfaces(s, 0, 2), 16 * 32);
    free_stage(s);
}

/* The near plane at z = 4, the far plane at z = -4. */
static void clip_planes(void **state) {
    (void)state;
    stage *s = new_stage();
    add_box(add_object(s, 1, true), -1.5, -1, 3, -1, 1, 5, false);     /* only its back face is left */
    add_box(add_object(s, 2, false), -0.5, -1, 3, 0, 1, 4.001, false); /* nothing is left, and nothing capped */
    add_sheet(add_object(s, 3, false), 0, -1, 0.5, 1, 4);              /* on the near plane */
    add_sheet(add_object(s, 4, false), 0.5, -1, 1, 1, -4);             /* on the far plane */
    add_sheet(add_object(s, 5, false), 1, -1, 1.5, 1, -4.001);         /* beyond */
    render(s);
    near_to(at(s, 0.25, 0)->opaque_depth, 0, 0);
    near_to(at(s, 0.75, 0)->opaque_depth, 1, 0);
    assert_int_equal(count_surfaces(s, 0, 3), 8 * 32);
    assert_int_equal(count_surfaces(s, 0, 4), 8 * 32);
    assert_int_equal(count_surfaces(s, 0, 0), SIZE * SIZE - 16 * 32);
    free_stage(s);
}

/* A sheet from z = 6 at x = -1 down to z = -6 at x = 1: the planes at z = 4 and -4 leave x from -2/3 to 2/3. */
static void clip_planes_through_a_face(void **state) {
    (void)state;
    stage *s = new_stage();
    const double corners[4][3] = {{-1, -1, 6}, {1, -1, -6}, {1, 1, -6}, {-1, 1, 6}};
    add_quad(add_object(s, 1, false), corners, false);
    render(s);
    for (int column = 0; column < SIZE; ++column) {
        double x = (column + 0.5) / 16 - 2;
        expect_surfaces(&s->pixels[30 * SIZE + column], 0, fabs(x) < 2.0 / 3 ? 1 : 0);
    }
    free_stage(s);
}

/* ---- geometry of the rays ---- */

/* A quad in the plane z = -4 + x, whose alpha is (1 + x) / 4 at its vertices: along the ray of slope u the plane is met
 * at z = -4 / (1 + u). */
static void perspective_interpolation(void **state) {
    (void)state;
    stage *s = new_stage();
    s->scene.blending = REF_BLEND_OVER;
    s->scene.background[2] = 0;
    set_perspective(s->scene.projection, 1, 0.5, 50);
    const double corners[4][3] = {{-1, -4, -5}, {3, -4, -1}, {3, 4, -1}, {-1, 4, -5}};
    mesh *m = add_object(s, 1, true);
    add_quad(m, corners, false);
    const float alphas[4] = {0, 1, 1, 0};
    s->objects[0].vertex_alpha = alphas;
    render(s);
    size_t seen = 0;
    for (int i = 0; i < SIZE * SIZE; ++i) {
        if (!s->pixels[i].front_object)
            continue;
        ++seen;
        double u = (i % SIZE + 0.5) / 32 - 1, depth = 4 / (1 + u), x = u * depth;
        near_to(s->pixels[i].color[0], (1 + x) / 4, 1e-13);
        near_to(s->pixels[i].front_depth, 50 / 49.5 * (1 - 0.5 / depth), 1e-14);
    }
    assert_true(seen > 2000);
    free_stage(s);
}

/* Shading in a scene: normals by the inverse transpose, mirrored models, and two-sided sheets seen from behind. */
static void shading_in_a_scene(void **state) {
    (void)state;
    const double light[3] = {5, 0, 0};
    const struct {
        double scale;
        bool inside_out;
        double t;
    } cases[] = {{1, false, 0.5 + 0.5 * sqrt(0.5)},
                 {2, false, 0.5 + 0.5 * 0.5 / sqrt(1.25)},
                 {-2, false, 0.5 - 0.5 * 0.5 / sqrt(1.25)},
                 {2, true, 0.5 - 0.5 * 0.5 / sqrt(1.25)}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        stage *s = new_stage();
        mesh *m = add_object(s, 1, false);
        add_sheet(m, -0.5, -0.5, 0.5, 0.5, 0);
        if (cases[i].inside_out)
            turn_inside_out(m);
        const float h = (float)sqrt(0.5), normals[12] = {h, 0, h, h, 0, h, h, 0, h, h, 0, h};
        s->objects[0].normals = normals;
        s->objects[0].cool_to_warm = true;
        s->objects[0].two_sided = cases[i].inside_out;
        s->objects[0].model[0] = cases[i].scale;
        memcpy(s->scene.light_direction, light, sizeof light);
        s->scene.warm[0] = s->scene.cool[2] = 1;
        s->scene.cool_mix = s->scene.warm_mix = 0.5;
        render(s);
        const ref_pixel *p = at(s, 0.1, 0.1);
        near_to(p->color[0], cases[i].t, 1e-7);
        near_to(p->color[1], 0.5, 1e-7);
        near_to(p->color[2], 1 - cases[i].t, 1e-7);
        free_stage(s);
    }
}

/* Mirrored models, views and projections, and clockwise front faces, change nothing about what is inside. */
static void mirrored(void **state) {
    (void)state;
    for (int variant = 0; variant < 16; ++variant) {
        stage *s = new_stage();
        mesh *shell = add_object(s, 1, true), *core = add_object(s, 2, false);
        add_box(shell, -1, -1, -1, 1, 1, 1, false);
        add_box(core, 0.25, -0.5, -0.5, 0.5, 0.5, 0.5, false);
        for (int o = 0; o < 2 && (variant & 1); ++o)
            s->objects[o].model[0] = -1;
        if (variant & 2)
            s->scene.view[5] = -1;
        if (variant & 4)
            s->scene.projection[0] *= -1;
        if (variant & 8) {
            turn_inside_out(shell);
            turn_inside_out(core);
            s->scene.front_face_cw = true;
        }
        render(s);
        bool turned = ((variant & 1) != 0) != ((variant & 4) != 0);
        assert_int_equal(count_surfaces(s, 1, 2), 4 * 16);
        assert_int_equal(count_surfaces(s, 1, 0), 32 * 32 - 4 * 16);
        expect_surfaces(at(s, turned ? -0.375 : 0.375, 0.1), 1, 2);
        near_to(at(s, 0, 0)->limit_depth, 5.0 / 8, 1e-15);
        free_stage(s);
    }
}

static size_t count_hits(const stage *s, ref_i_kind kind, size_t *most) {
    ref_i_world world = {.scene = &s->scene};
    size_t total = 0;
    assert_true(ref_i_make_world(&world));
    *most = 0;
    for (int i = 0; i < SIZE * SIZE; ++i) {
        size_t here = 0;
        assert_true(ref_i_cast(&world, i % SIZE + 0.5, i / SIZE + 0.5));
        for (size_t h = 0; h < world.hit_count; ++h)
            here += world.hits[h].kind == kind;
        total += here;
        *most = here > *most ? here : *most;
    }
    ref_i_free_world(&world);
    return total;
}

/* Edges and vertices exactly at pixel centres: one of the triangles there is met, never two, never none. */
static void watertight(void **state) {
    (void)state;
    stage *s = new_stage();
    mesh *m = add_object(s, 1, false);
    double first = -2 + 0.5 / 16, step = 1.0 / 16; /* a grid whose vertices are the centres of pixels 0 to 32 */
    for (int i = 0; i < 33 * 33; ++i)
        add_vertex(m, first + (i % 33) * step, first + (double)(i / 33) * step, 0.1 * (i % 7));
    for (uint32_t i = 0; i < 32 * 32; ++i) {
        uint32_t a = i / 32 * 33 + i % 32;
        add_triangle(m, a, a + 1, a + 34);
        add_triangle(m, a, a + 34, a + 33);
    }
    connect_meshes(s);
    size_t most;
    assert_int_equal(count_hits(s, REF_I_SOLID, &most), 32 * 32);
    assert_int_equal(most, 1);
    free_stage(s);

    s = new_stage(); /* a closed surface, its pole and a meridian on pixel centres: in as often as out */
    add_sphere(add_object(s, 1, true), 1.3, 24, 48);
    s->objects[0].model[12] = s->objects[0].model[13] = 0.5 / 16;
    connect_meshes(s);
    size_t in = count_hits(s, REF_I_FRONT, &most), out;
    assert_int_equal(most, 1);
    out = count_hits(s, REF_I_BACK, &most);
    assert_int_equal(most, 1);
    assert_true(in == out && in > 1300);
    free_stage(s);
}

static unsigned next_random(unsigned *seed) {
    *seed = *seed * 1664525u + 1013904223u;
    return *seed >> 8;
}

static double random_between(unsigned *seed, double low, double high) {
    return low + (high - low) * next_random(seed) / 16777215.0;
}

/* Six objects of forty loose triangles around and behind the eye, many across the near plane. */
static stage *random_stage(unsigned seed, bool reversed) {
    stage *s = new_stage();
    for (uint32_t o = 0; o < 6; ++o) {
        mesh *m = add_object(s, o + 1, o % 2 == 0);
        ref_object *object = &s->objects[o];
        for (int t = 0; t < 40; ++t) {
            double centre[3];
            uint32_t v[3];
            for (int k = 0; k < 3; ++k)
                centre[k] = random_between(&seed, -3, 3);
            for (int i = 0; i < 3; ++i) {
                double p[3];
                for (int k = 0; k < 3; ++k)
                    p[k] = centre[k] + random_between(&seed, -1, 1);
                v[i] = add_vertex(m, p[0], p[1], p[2]);
            }
            add_triangle(m, v[0], v[1], v[2]);
        }
        object->two_sided = o / 2 == 1;
        for (int k = 0; k < 3; ++k)
            object->color[k] = random_between(&seed, 0, 1);
        object->model[4] = 0.3 * o;
    }
    set_perspective(s->scene.projection, 1, 0.2, 8);
    s->scene.width = 67;
    s->scene.height = 41;
    for (size_t o = 0; o < 3 && reversed; ++o) {
        mesh kept_mesh = s->meshes[o];
        ref_object kept = s->objects[o];
        s->meshes[o] = s->meshes[5 - o];
        s->objects[o] = s->objects[5 - o];
        s->meshes[5 - o] = kept_mesh;
        s->objects[5 - o] = kept;
    }
    return s;
}

static void same_as_asking_every_triangle(void **state) {
    (void)state;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        stage *s = random_stage(seed, false);
        s->scene.interior = seed % 2 ? REF_INTERIOR_IMPLICIT : REF_INTERIOR_IMPLICIT_PUBLISHED;
        s->scene.blending = (ref_blending)(seed % 3);
        render(s);
        size_t count = (size_t)s->scene.width * (size_t)s->scene.height;
        ref_pixel *brute = grown(NULL, count * sizeof *brute);
        assert_true(ref_render_brute(&s->scene, brute));
        expect_same_picture(s->pixels, brute, count, false);
        assert_true(count_surfaces(s, 0, 0) < count * 3 / 4);
        free(brute);
        free_stage(s);
    }
}

static void order_of_objects_does_not_matter(void **state) {
    (void)state;
    stage *s = random_stage(9, false), *reversed = random_stage(9, true);
    render(s);
    render(reversed);
    expect_same_picture(s->pixels, reversed->pixels, 67 * 41, false);
    free_stage(s);
    free_stage(reversed);
}

/* A kilometre of millimetres: model and view cancel, and the picture is that of the same scene at the origin. */
static void far_from_the_origin(void **state) {
    (void)state;
    stage *scenes[2];
    for (int i = 0; i < 2; ++i) {
        stage *s = scenes[i] = new_stage();
        make_coincident(s, false, true);
        for (size_t o = 0; o < 3; ++o) {
            s->objects[o].model[0] = s->objects[o].model[5] = s->objects[o].model[10] = 1.0 / 1024;
            s->objects[o].model[12] = s->objects[o].model[14] = i ? 1e6 : 0;
        }
        s->scene.view[12] = s->scene.view[14] = i ? -1e6 : 0;
        set_orthographic(s->scene.projection, 2.0 / 1024, -4.0 / 1024, 4.0 / 1024);
        render(s);
    }
    assert_int_equal(count_surfaces(scenes[1], 3, 0), 32 * 32);
    expect_same_picture(scenes[0]->pixels, scenes[1]->pixels, SIZE * SIZE, true);
    free_stage(scenes[0]);
    free_stage(scenes[1]);
}

/* ---- pixels left out ---- */

/* Edges between pixels are half a pixel from the centres on both sides, which is not nearer than half a pixel. Moved by
 * a quarter of a pixel, they pass through one column on each side. */
static void left_out_along_edges(void **state) {
    (void)state;
    for (int moved = 0; moved < 2; ++moved)
        for (int transparent = 0; transparent < 2; ++transparent) {
            stage *s = new_stage();
            add_box(add_object(s, 1, transparent), -1, -1, -1, 1, 1, 1, false);
            s->objects[0].model[12] = moved * 0.25 / 16;
            render(s);
            assert_int_equal(count_left_out(s), moved ? 2 * 32 : 0);
            assert_true(!moved || (s->pixels[30 * SIZE + 16].left_out && s->pixels[30 * SIZE + 48].left_out));
            free_stage(s);
        }
}

/* A sliver a tenth of a pixel wide between the centres of columns 39 and 40, seen by none of the five points of its
 * pixels, is found by its edges: it leaves out columns 39 and 40 unless a wall hides it. */
static void left_out_slivers(void **state) {
    (void)state;
    for (int hidden = 0; hidden < 2; ++hidden) {
        stage *s = new_stage();
        double x = (39.75 - 32) / 16;
        add_sheet(add_object(s, 1, false), x, -1, x + 0.1 / 16, 1, 0.5);
        add_sheet(add_object(s, 2, false), -2, -2, 2, 2, hidden ? 1 : 0);
        render(s);
        assert_int_equal(count_surfaces(s, 0, 2), SIZE * SIZE);
        assert_int_equal(count_left_out(s), hidden ? 0 : 32);
        assert_true(s->pixels[30 * SIZE + 39].left_out == !hidden);
        free_stage(s);
    }
}

/* Two slanted sheets z = +-(x - c) of different objects cross at x = c, a third of a pixel right of a pixel's edge: one
 * column is left out, unless a wall (whose edges lie between pixels) hides
 * the crossing. Within one object a fold does the same. */
static void left_out_intersections(void **state) {
    (void)state;
    double c = (36 + 1.0 / 3 - 32) / 16;
    for (int variant = 0; variant < 3; ++variant) {
        stage *s = new_stage();
        mesh *m = NULL;
        for (int i = 0; i < 2; ++i) {
            double up = i ? 1 : -1;
            bool fold = variant == 2; /* a valley: each sheet only on the side where it rises */
            double x0 = fold && i ? c : -2, x1 = fold && !i ? c : 2;
            double corners[4][3] = {
                {x0, -2, up * (x0 - c)}, {x1, -2, up * (x1 - c)}, {x1, 2, up * (x1 - c)}, {x0, 2, up * (x0 - c)}};
            if (!fold || i == 0)
                m = add_object(s, (uint32_t)(i + 1), false);
            add_quad(m, (const double(*)[3])corners, false);
        }
        if (variant == 1)
            add_sheet(add_object(s, 3, false), -1, -2, 2, 2, 3.5);
        render(s);
        assert_int_equal(count_left_out(s), variant == 1 ? 0 : SIZE);
        assert_true(s->pixels[10 * SIZE + 36].left_out == (variant != 1));
        free_stage(s);
    }
}

/* Edges inside a transparent object's own silhouette: the nearer part of an object over its farther part is outlined,
 * the farther part under the nearer is not. A fine sphere has no creases. */
static void left_out_within_an_object(void **state) {
    (void)state;
    stage *s = new_stage();
    mesh *m = add_object(s, 1, true);
    double q = 0.25 / 16; /* a quarter of a pixel */
    add_box(m, -2.5, -2.5, -1, 2.5, 2.5, -0.5, false);
    add_box(m, -1 + q, -1, 1, 1 + q, 1, 1.5, false);
    add_box(m, -0.5 + q, -0.5, 0.2, 0.5 + q, 0.5, 0.6, false);
    render(s);
    assert_int_equal(count_surfaces(s, 1, 0), SIZE * SIZE);
    assert_int_equal(count_left_out(s), 2 * 32);
    free_stage(s);
}

/* Folds of back faces alone have no colour: a folded sheet of one side, seen from behind, before a wall. */
static void left_out_back_faces(void **state) {
    (void)state;
    stage *s = new_stage();
    mesh *m = add_object(s, 1, true);
    double x = 0.25 / 16;
    const double left[4][3] = {{-1, -1, 0}, {x, -1, 1}, {x, 1, 1}, {-1, 1, 0}};
    const double right[4][3] = {{x, -1, 1}, {1, -1, 0}, {1, 1, 0}, {x, 1, 1}};
    add_quad(m, left, false);
    add_quad(m, right, false);
    turn_inside_out(m);
    add_sheet(add_object(s, 2, false), -2, -2, 2, 2, -1);
    render(s);
    assert_int_equal(count_surfaces(s, 0, 2), SIZE * SIZE);
    assert_int_equal(count_left_out(s), 0);
    s->objects[0].two_sided = true; /* now it is seen */
    render(s);
    assert_int_equal(count_left_out(s), 32);
    free_stage(s);
}

/* The ridge of a roof below the eye, x = -1, y = -1/2, runs from z = -6 to behind the eye, as an edge from either end.
 * In pixels it is the line y = 16 + x / 2, and exactly the pixels nearer than half a pixel to it are left out. */
static void left_out_across_the_near_plane(void **state) {
    (void)state;
    const double right[4][3] = {{-1, -0.5, 3}, {9, -0.5, 3}, {9, -0.5, -6}, {-1, -0.5, -6}};
    const double left[4][3] = {{-9, -3.5, 3}, {-1, -0.5, 3}, {-1, -0.5, -6}, {-9, -3.5, -6}};
    for (int from_afar = 0; from_afar < 2; ++from_afar) {
        stage *s = new_stage();
        mesh *m = add_object(s, 1, false);
        if (from_afar)
            add_vertex(m, -1, -0.5, -6); /* the first vertex of a place stands for all */
        add_quad(m, right, false);
        add_quad(m, left, false);
        set_perspective(s->scene.projection, 1, 0.5, 20);
        render(s);
        for (int x = 0; x < 16; ++x) /* beyond, the roof's far end is near */
            for (int y = 4; y < 17 + x / 2; ++y) {
                double distance = fabs(y + 0.5 - 16 - (x + 0.5) / 2) / sqrt(1.25);
                assert_true(s->pixels[y * SIZE + x].left_out == (distance < 0.5));
            }
        free_stage(s);
    }
}

/* ---- probe pixels worked out by hand ---- */

static stage *new_probe_stage(const probe_scene *scene, const probe_camera *camera) {
    stage *s = new_stage();
    for (int o = 0; o < scene->object_count; ++o) {
        const probe_object *object = &scene->objects[o];
        mesh *m = add_object(s, object->id, object->transparent);
        memcpy(s->objects[o].color, object->color, sizeof object->color);
        s->objects[o].alpha = object->alpha;
        s->objects[o].two_sided = object->two_sided;
        for (int i = 0; i < object->polygon_count; ++i) {
            const probe_polygon *polygon = &object->polygons[i];
            uint32_t first = (uint32_t)m->vertex_count;
            for (int v = 0; v < polygon->count; ++v)
                add_vertex(m, polygon->vertices[v][0], polygon->vertices[v][1], polygon->vertices[v][2]);
            for (uint32_t v = 2; v < (uint32_t)polygon->count; ++v)
                add_triangle(m, first, first + v - 1, first + v);
        }
    }
    const double *axes[3] = {camera->right, camera->up, camera->toward};
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c)
            s->scene.view[4 * c + r] = axes[r][c];
        s->scene.view[12 + r] = -ref_i_dot(axes[r], camera->eye);
    }
    if (camera->perspective)
        set_perspective(s->scene.projection, 1 / camera->half_width, camera->near_distance, camera->far_distance);
    else
        set_orthographic(s->scene.projection, camera->half_width, camera->near_distance, camera->far_distance);
    memcpy(s->scene.background, scene->background, sizeof scene->background);
    s->scene.opaque_weight = scene->opaque_weight;
    s->scene.background_weight = scene->background_weight;
    s->scene.width = s->scene.height = 2 * SIZE;
    return s;
}

static const ref_pixel *at_probe(const stage *s, const probe *place) {
    return at(s, 2 * place->u, 2 * place->v); /* the window stands for [-2,2] squared in at() */
}

/* Counts the probes of a view that the reference disagrees with, and prints them. */
static int wrong_probes(const stage *s, const char *scene, const probe_view *view) {
    static const char *const rules[3] = {"default", "published", "explicit"};
    int wrong = 0;
    for (int i = 0; i < view->probe_count; ++i) {
        const probe *place = &view->probes[i];
        const probe_answer *answers[3] = {&place->rule_default, &place->rule_published, &place->rule_explicit};
        const probe_answer *answer = answers[s->scene.interior];
        const ref_pixel *pixel = at_probe(s, place);
        if (pixel->front_object == answer->front && pixel->opaque_object == answer->behind && !pixel->left_out)
            continue;
        ++wrong;
        printf("%s, %s, probe %d (%g, %g), %s: %u %u%s, by hand %u %u\n", scene, view->name, i, place->u, place->v,
               rules[s->scene.interior], (unsigned)pixel->front_object, (unsigned)pixel->opaque_object,
               pixel->left_out ? " left out" : "", (unsigned)answer->front, (unsigned)answer->behind);
    }
    return wrong;
}

/* Every probe under all rules: the surfaces, and that no probe is among the pixels left out. */
static void probes_surfaces(void **state) {
    (void)state;
    int wrong = 0, total = 0;
    for (int i = 0; i < PROBE_SCENE_COUNT; ++i)
        for (int v = 0; v < probe_scenes[i].view_count; ++v) {
            const probe_view *view = &probe_scenes[i].views[v];
            stage *s = new_probe_stage(&probe_scenes[i], &view->camera);
            for (int interior = REF_INTERIOR_IMPLICIT; interior <= REF_INTERIOR_EXPLICIT; ++interior) {
                s->scene.interior = (ref_interior)interior;
                render(s);
                wrong += wrong_probes(s, probe_scenes[i].name, view);
                total += view->probe_count;
            }
            free_stage(s);
        }
    printf("%d probe pixels of %d scenes under three rules, %d wrong\n", total / 3, PROBE_SCENE_COUNT, wrong);
    assert_true(total >= 3 * 20 * PROBE_SCENE_COUNT);
    assert_int_equal(wrong, 0);
}

static void probes_colors(void **state) {
    (void)state;
    int total = 0;
    for (int i = 0; i < PROBE_SCENE_COUNT; ++i)
        for (int e = 0; e < probe_scenes[i].example_count; ++e) {
            const probe_example *example = &probe_scenes[i].examples[e];
            const probe_view *view = &probe_scenes[i].views[example->view];
            const double *colors[3] = {example->published, example->normalised, example->over};
            stage *s = new_probe_stage(&probe_scenes[i], &view->camera);
            s->scene.interior = example->published_rule ? REF_INTERIOR_IMPLICIT_PUBLISHED : REF_INTERIOR_IMPLICIT;
            for (int blending = REF_BLEND_PUBLISHED; blending <= REF_BLEND_OVER; ++blending) {
                s->scene.blending = (ref_blending)blending;
                render(s);
                const double *expected = colors[blending];
                expect_color(at_probe(s, &view->probes[example->probe])->color, expected[0], expected[1], expected[2]);
                ++total;
            }
            free_stage(s);
        }
    assert_true(total >= 3 * PROBE_SCENE_COUNT);
}

/* ---- scenes that make no sense, and large ones ---- */

static void refuses_nonsense(void **state) {
    (void)state;
    stage *s = new_stage();
    ref_pixel pixel;
    for (uint32_t o = 0; o < 2; ++o)
        add_sheet(add_object(s, o + 1, false), -1, -1, 1, 1, 0);
    connect_meshes(s);
    s->scene.width = s->scene.height = 1;
    assert_true(ref_render(&s->scene, &pixel));
    s->objects[1].id = 1;
    assert_false(ref_render(&s->scene, &pixel));
    s->objects[1].id = 0;
    assert_false(ref_render(&s->scene, &pixel));
    s->objects[1].id = 2;
    s->meshes[1].indices[5] = 4;
    assert_false(ref_render(&s->scene, &pixel));
    s->meshes[1].indices[5] = 3;
    s->scene.width = -1;
    assert_false(ref_render(&s->scene, &pixel));
    s->scene.width = 0;
    assert_true(ref_render(&s->scene, NULL));
    free_stage(s);
}

/* NaN and infinite vertices cost their triangles, nothing else. */
static void bad_vertices(void **state) {
    (void)state;
    const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, 3e38};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        stage *s = new_stage();
        mesh *m = add_object(s, 1, false);
        add_sheet(m, -1, -1, 1, 1, 0);
        add_triangle(m, 0, 1, add_vertex(m, 0, 0, bad[i]));
        add_triangle(m, 0, 0, 1);
        add_triangle(m, 0, 0, 0);
        render(s);
        assert_int_equal(count_surfaces(s, 0, 1), 32 * 32);
        assert_int_equal(count_surfaces(s, 0, 0), SIZE * SIZE - 32 * 32);
        free_stage(s);
    }
}

static void twenty_thousand_triangles(void **state) {
    (void)state;
    stage *s = new_stage();
    s->scene.width = s->scene.height = 512;
    set_perspective(s->scene.projection, 2, 1, 10);
    s->scene.view[14] = -5;
    add_sphere(add_object(s, 1, true), 1.2, 72, 100);
    add_sphere(add_object(s, 2, false), 0.8, 40, 75);
    connect_meshes(s);
    clock_t start = clock();
    render(s);
    double share = ref_left_out_share(s->pixels, 512 * 512);
    printf("%zu triangles at 512 x 512: %.2f s of processor time, %.2f %% left out\n",
           s->meshes[0].triangle_count + s->meshes[1].triangle_count, (double)(clock() - start) / CLOCKS_PER_SEC,
           100 * share);
    assert_true(s->meshes[0].triangle_count + s->meshes[1].triangle_count >= 20000);
    /* The outlines of the spheres: radius r at distance 5 fills a disc of 512 r / sqrt(25 - r^2) pixels. */
    double pi = acos(-1.0), outer = 512 * 1.2 / sqrt(25 - 1.44), inner = 512 * 0.8 / sqrt(25 - 0.64);
    near_to((double)count_surfaces(s, 1, 2), pi * inner * inner, 0.01 * pi * inner * inner);
    near_to((double)count_surfaces(s, 1, 0), pi * (outer * outer - inner * inner),
            0.01 * pi * (outer * outer - inner * inner));
    double rings = 2 * pi * (outer + inner) / (512 * 512);
    assert_true(share > 0.9 * rings && share < 1.1 * rings * 4 / pi);
    free_stage(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blends),
        cmocka_unit_test(blends_without_weights),
        cmocka_unit_test(alpha_law),
        cmocka_unit_test(alpha_law_with_bad_inputs),
        cmocka_unit_test(distances),
        cmocka_unit_test(cool_to_warm),
        cmocka_unit_test(shell_around_box),
        cmocka_unit_test(sphere_around_box),
        cmocka_unit_test(eye_inside),
        cmocka_unit_test(nested_shells),
        cmocka_unit_test(intersecting_shells),
        cmocka_unit_test(coincident_fronts),
        cmocka_unit_test(one_ulp_apart),
        cmocka_unit_test(two_sided_sheet),
        cmocka_unit_test(sheet_before_shell),
        cmocka_unit_test(back_face_without_front),
        cmocka_unit_test(back_face_before_front),
        cmocka_unit_test(concave_object),
        cmocka_unit_test(opaque_at_equal_depth),
        cmocka_unit_test(opaque_faces),
        cmocka_unit_test(clip_planes),
        cmocka_unit_test(clip_planes_through_a_face),
        cmocka_unit_test(perspective_interpolation),
        cmocka_unit_test(shading_in_a_scene),
        cmocka_unit_test(mirrored),
        cmocka_unit_test(watertight),
        cmocka_unit_test(same_as_asking_every_triangle),
        cmocka_unit_test(order_of_objects_does_not_matter),
        cmocka_unit_test(far_from_the_origin),
        cmocka_unit_test(left_out_along_edges),
        cmocka_unit_test(left_out_slivers),
        cmocka_unit_test(left_out_intersections),
        cmocka_unit_test(left_out_within_an_object),
        cmocka_unit_test(left_out_back_faces),
        cmocka_unit_test(left_out_across_the_near_plane),
        cmocka_unit_test(probes_surfaces),
        cmocka_unit_test(probes_colors),
        cmocka_unit_test(refuses_nonsense),
        cmocka_unit_test(bad_vertices),
        cmocka_unit_test(twenty_thousand_triangles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

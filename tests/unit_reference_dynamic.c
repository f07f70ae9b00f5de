/* The reference of dynamic transparency, held to scenes whose answer was worked out by hand and to what must hold in any
 * scene. Most look down -z through a window of 32 x 32 pixels over [-2,2] x [-2,2], 8 pixels a unit: x = 0 is the border
 * between pixels 15 and 16. Walls and targets are squares that face the viewer; higher z is nearer. */
#include "reference_dynamic.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <cmocka.h>

enum { SIZE = 32, MOST = 24 };
enum {
    TARGET = REF_DYN_TARGET,
    IMPENETRABLE = REF_DYN_IMPENETRABLE,
    HOLLOW = REF_DYN_HOLLOW,
    BACKDROP = REF_DYN_BACKDROP,
    ACTIVE = REF_DYN_ACTIVE
};

typedef struct solid {
    float positions[3 * 8 * 4];
    uint32_t indices[6 * 6 * 4];
    size_t points, corners;
} solid;

typedef struct stage {
    solid solids[MOST];
    ref_object meshes[MOST];
    ref_dyn_object objects[MOST];
    ref_scene scene;
    ref_dyn_scene dynamic;
    ref_dyn_pixel pixels[SIZE * SIZE];
    double weights[SIZE * SIZE * MOST];
    ref_dyn_census census[MOST];
} stage;

static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/* ---- building scenes ---- */

/* Defaults, but a gradient of 4 pixels; a black background; z from 4 (near) to -4. */
static stage *new_stage(void) {
    stage *s = calloc(1, sizeof *s);
    if (!s)
        abort();
    ref_dyn_defaults(&s->dynamic);
    s->dynamic.width = 4;
    s->dynamic.scene = &s->scene;
    s->dynamic.objects = s->objects;
    s->scene.objects = s->meshes;
    s->scene.width = s->scene.height = SIZE;
    memcpy(s->scene.view, identity, sizeof identity);
    memcpy(s->scene.projection, identity, sizeof identity);
    s->scene.projection[0] = s->scene.projection[5] = 0.5;
    s->scene.projection[10] = -0.25;
    return s;
}

/* The index of a new object without triangles. Ids count from 1; targets have importance 1. */
static size_t add_object(stage *s, uint32_t flags) {
    size_t o = s->scene.object_count++;
    assert_true(o < MOST);
    ref_object *mesh = &s->meshes[o];
    memcpy(mesh->model, identity, sizeof identity);
    mesh->id = (uint32_t)o + 1;
    mesh->positions = s->solids[o].positions;
    mesh->indices = s->solids[o].indices;
    mesh->color[0] = 0.1 * (double)(o + 1);
    mesh->color[1] = o % 2 ? 0.25 : 0.75;
    s->objects[o].flags = flags;
    s->objects[o].importance = flags & TARGET ? 1 : 0;
    return o;
}

static uint32_t add_point(solid *d, double x, double y, double z) {
    d->positions[3 * d->points] = (float)x;
    d->positions[3 * d->points + 1] = (float)y;
    d->positions[3 * d->points + 2] = (float)z;
    return (uint32_t)d->points++;
}

static void add_quad(solid *d, uint32_t a, uint32_t b, uint32_t c, uint32_t e) {
    const uint32_t corners[6] = {a, b, c, a, c, e};
    memcpy(d->indices + d->corners, corners, sizeof corners);
    d->corners += 6;
}

static void count_mesh(stage *s, size_t o) {
    s->meshes[o].vertex_count = s->solids[o].points;
    s->meshes[o].triangle_count = s->solids[o].corners / 3;
    assert_true(s->solids[o].points <= 32 && s->solids[o].corners <= 144);
}

static void add_sheet(stage *s, size_t o, double x0, double y0, double x1, double y1, double z) {
    solid *d = &s->solids[o];
    uint32_t a = add_point(d, x0, y0, z), b = add_point(d, x1, y0, z);
    add_quad(d, a, b, add_point(d, x1, y1, z), add_point(d, x0, y1, z));
    count_mesh(s, o);
}

static void add_box(stage *s, size_t o, double x0, double y0, double z0, double x1, double y1, double z1) {
    solid *d = &s->solids[o];
    uint32_t v[8];
    for (int i = 0; i < 8; ++i)
        v[i] = add_point(d, i & 1 ? x1 : x0, i & 2 ? y1 : y0, i & 4 ? z1 : z0);
    add_quad(d, v[4], v[5], v[7], v[6]);
    add_quad(d, v[0], v[2], v[3], v[1]);
    add_quad(d, v[0], v[1], v[5], v[4]);
    add_quad(d, v[3], v[2], v[6], v[7]);
    add_quad(d, v[1], v[3], v[7], v[5]);
    add_quad(d, v[2], v[0], v[4], v[6]);
    count_mesh(s, o);
}

/* A sheet over the whole window, and one over the 8 x 8 pixels from 12 to 19. */
static size_t wall(stage *s, uint32_t flags, double z) {
    size_t o = add_object(s, flags);
    add_sheet(s, o, -3, -3, 3, 3, z);
    return o;
}

static size_t square(stage *s, uint32_t flags, double z) {
    size_t o = add_object(s, flags);
    add_sheet(s, o, -0.5, -0.5, 0.5, 0.5, z);
    return o;
}

static void render(stage *s) {
    assert_true(ref_dyn_render(&s->dynamic, s->pixels, s->weights, s->census));
}

/* ---- looking at pictures ---- */

static double weight(const stage *s, int x, int y, size_t object) {
    return s->weights[(size_t)(y * SIZE + x) * s->scene.object_count + object];
}

static void near_to(double found, double expected) {
    if (!(fabs(found - expected) <= 1e-12))
        fail_msg("found %.17g, expected %.17g", found, expected);
}

/* The weights of the first objects at a pixel; a negative one ends the list. */
static void expect(const stage *s, int x, int y, const double *weights) {
    for (size_t o = 0; weights[o] >= 0; ++o)
        if (!(fabs(weight(s, x, y, o) - weights[o]) <= 1e-12))
            fail_msg("pixel %d,%d, object %zu: weight %.17g, expected %.17g", x, y, o + 1, weight(s, x, y, o),
                     weights[o]);
}

#define EXPECT(stage, x, y, ...) expect(stage, x, y, (const double[]){__VA_ARGS__, -1})

/* ---- formulas ---- */

static void importances(void **state) {
    (void)state;
    ref_dyn_object t = {.flags = TARGET, .importance = 1}, o = {.importance = 0};
    near_to(ref_dyn_yield(&t, &o), 1); /* 1 and 0 are the paper */
    o.importance = 0.25;
    near_to(ref_dyn_yield(&t, &o), 0.75);
    t.importance = 0.5;
    near_to(ref_dyn_yield(&t, &o), 0.25);
    o.importance = 0.75;
    near_to(ref_dyn_yield(&t, &o), 0); /* clamped */
    o.flags = TARGET;
    near_to(ref_dyn_yield(&t, &o), 0.75); /* a target in front, more important by 1/4 */
    o.importance = 0.5;
    near_to(ref_dyn_yield(&t, &o), 1); /* equal targets cut each other */
    o.importance = 0.125;
    near_to(ref_dyn_yield(&t, &o), 1);
    t.importance = (double)NAN;
    near_to(ref_dyn_yield(&t, &o), 0);
}

static void sharing(void **state) {
    (void)state;
    near_to(ref_dyn_shared(0.3, 1), 0.3);
    near_to(ref_dyn_shared(0.75, 2), 0.5); /* 1/2 . 1/2 is left */
    near_to(ref_dyn_shared(0.875, 3), 0.5);
    near_to(ref_dyn_shared(1, 5), 1);
    near_to(ref_dyn_shared(0, 5), 0);
    near_to(ref_dyn_shared(0.3, 0), 0.3);
}

static void lights(void **state) {
    (void)state;
    const ref_dyn_light two[2] = {{0, 0, 10, 4}, {20, 0, 5, 0}};
    ref_dyn_scene d = {.lights = two, .light_count = 2};
    near_to(ref_dyn_light_at(&d, 6, 8), 1);
    near_to(ref_dyn_light_at(&d, 0, 11), 0.75);
    near_to(ref_dyn_light_at(&d, 0, 14), 0);
    near_to(ref_dyn_light_at(&d, 15, 0), 1); /* the rim of the hard one, outside of the soft one */
    near_to(ref_dyn_light_at(&d, 14.5, 0), 0);
    const ref_dyn_light crossing[3] = {{0, 0, 10, 4}, {24, 0, 10, 8}, {0, 99, 1, 1}};
    d.lights = crossing; /* 1/2 of one, 3/4 of the other, none of the third: the strongest counts */
    d.light_count = 3;
    near_to(ref_dyn_light_at(&d, 12, 0), 0.75);
    d.light_count = 0;
    near_to(ref_dyn_light_at(&d, 0, 0), 0);
}

/* ---- masks: figure 2 ---- */

/* Along the middle row the target ends with pixel 19. alpha_0 = 0.1 in 20, then 0.225 more a pixel, 1 in 24. */
static void a_wall_before_a_target(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    wall(s, 0, 1);
    wall(s, 0, -1);
    render(s);
    EXPECT(s, 16, 16, 0.7, 0.3, 0);
    EXPECT(s, 19, 16, 0.7, 0.3, 0);
    EXPECT(s, 20, 16, 0, 0.1, 0.9);
    EXPECT(s, 21, 16, 0, 0.325, 0.675);
    EXPECT(s, 22, 16, 0, 0.55, 0.45);
    EXPECT(s, 23, 16, 0, 0.775, 0.225);
    EXPECT(s, 24, 16, 0, 1, 0);
    EXPECT(s, 8, 16, 0, 0.775, 0.225);
    EXPECT(s, 7, 16, 0, 1, 0);
    EXPECT(s, 21, 22, 0, 0.1 + 0.9 * (sqrt(13) - 1) / 4, 0.9 - 0.9 * (sqrt(13) - 1) / 4);
    const ref_dyn_pixel *on = &s->pixels[16 * SIZE + 16], *off = &s->pixels[16 * SIZE + 20];
    assert_int_equal(on->target, 1);
    near_to(on->target_weight, 0.7);
    assert_int_equal(on->see_through, 1);
    near_to(on->color[0], 0.7 * 0.1 + 0.3 * 0.2);
    assert_int_equal(off->target, 0);
    near_to(off->background, 0);
    assert_int_equal(s->census[0].pixels, 64);
    assert_int_equal(s->census[0].hidden, 64);
    assert_int_equal(s->census[0].closed, 0);
    near_to(s->census[0].least, 0.7);
    near_to(s->census[0].weight, 0.7 * 64);
    free(s);
}

static void rings_of_eight_neighbours(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    wall(s, 0, 1);
    s->dynamic.growth = REF_DYN_RINGS;
    render(s);
    EXPECT(s, 20, 20, 0, 0.1);
    EXPECT(s, 21, 22, 0, 0.55); /* the third ring */
    EXPECT(s, 23, 23, 0, 0.775);
    EXPECT(s, 24, 16, 0, 1);
    free(s);
}

static void no_gradient(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    wall(s, 0, 1);
    s->dynamic.width = 0;
    render(s);
    EXPECT(s, 19, 16, 0.7, 0.3);
    EXPECT(s, 20, 16, 0, 1);
    free(s);
}

/* Beside the target its mask has the depth of its nearest pixel: what is behind that stays. */
static void a_mask_leaves_what_is_behind(void **state) {
    (void)state;
    stage *s = new_stage();
    size_t t = add_object(s, TARGET);
    add_sheet(s, t, -0.5, -0.5, 0, 0.5, 0); /* pixels 12 to 15 */
    add_sheet(s, t, 0, -0.5, 0.5, 0.5, 2);  /* and 16 to 19, nearer */
    wall(s, 0, 1);
    render(s);
    EXPECT(s, 12, 16, 0.7, 0.3);
    EXPECT(s, 11, 16, 0, 0.1);
    EXPECT(s, 16, 16, 1, 0);
    EXPECT(s, 20, 16, 0, 1);
    free(s);
}

/* Pixel 16 is as near to 15, behind the wall, as to 17, before it: the mask has the depth nearest to the eye. */
static void the_nearer_of_equally_near_pixels(void **state) {
    (void)state;
    for (int swap = 0; swap < 2; ++swap) {
        stage *s = new_stage();
        size_t t = add_object(s, TARGET);
        add_sheet(s, t, -0.5, -0.5, 0, 0.5, swap ? 2 : 0);
        add_sheet(s, t, 0.125, -0.5, 0.625, 0.5, swap ? 0 : 2);
        wall(s, 0, 1);
        render(s);
        EXPECT(s, 16, 16, 0, 1);
        EXPECT(s, swap ? 17 : 15, 16, 0.7, 0.3);
        free(s);
    }
}

/* An L of pixels 12 to 19 along x and 12 to 15 along y, and 12 to 15 along x up to y = 19. */
static size_t corner_piece(stage *s) {
    size_t t = add_object(s, TARGET);
    add_sheet(s, t, -0.5, -0.5, 0.5, 0, 0);
    add_sheet(s, t, -0.5, 0, 0, 0.5, 0);
    return t;
}

static void convex_hull(void **state) {
    (void)state;
    stage *s = new_stage();
    corner_piece(s);
    wall(s, 0, 1);
    render(s);
    EXPECT(s, 16, 16, 0, 0.1);
    s->dynamic.shape = REF_DYN_HULL;
    render(s);
    /* The hull's slanting side goes through the centres of 19,15 and 15,19: x + y = 34 between pixel indices. */
    EXPECT(s, 16, 16, 0, 0.3);
    EXPECT(s, 17, 17, 0, 0.3);
    EXPECT(s, 18, 18, 0, 0.1 + 0.9 * sqrt(2) / 4);
    EXPECT(s, 20, 13, 0, 0.1 + 0.9 / 4);
    EXPECT(s, 24, 13, 0, 1);
    EXPECT(s, 14, 14, 0.7, 0.3);
    free(s);
}

/* Around the middle of the pixels' centres, 16,16, through the farthest, (3.5, 3.5) away. */
static void circle(void **state) {
    (void)state;
    stage *s = new_stage();
    corner_piece(s);
    wall(s, 0, 1);
    s->dynamic.shape = REF_DYN_CIRCLE;
    render(s);
    double radius = 3.5 * sqrt(2);
    EXPECT(s, 19, 19, 0, 0.3);
    EXPECT(s, 20, 16, 0, 0.3); /* (4.5, 0.5) */
    EXPECT(s, 21, 16, 0, 0.1 + 0.9 * (hypot(5.5, 0.5) - radius) / 4);
    EXPECT(s, 25, 16, 0, 1);
    free(s);
}

/* Pixels 12 to 19 by 14 to 17: half axes 3.5 and 1.5, times sqrt(2) through the corners. */
static void ellipse(void **state) {
    (void)state;
    stage *s = new_stage();
    size_t t = add_object(s, TARGET);
    add_sheet(s, t, -0.5, -0.25, 0.5, 0.25, 0);
    wall(s, 0, 1);
    s->dynamic.shape = REF_DYN_ELLIPSE;
    render(s);
    double ratio = hypot(0.5 / 3.5, 2.5 / 1.5) / sqrt(2); /* of pixel 16,18 */
    EXPECT(s, 20, 16, 0, 0.3);                            /* (4.5, 0.5): 1.29 and 0.33 are below sqrt(2) */
    EXPECT(s, 16, 18, 0, 0.1 + 0.9 * hypot(0.5, 2.5) * (1 - 1 / ratio) / 4);
    EXPECT(s, 16, 23, 0, 1);
    free(s);
}

/* Points given by the caller stand for the pixels: a circle around (0, 0) in the world through (1, 0), 8 pixels. */
static void shapes_around_given_points(void **state) {
    (void)state;
    static const double points[4][3] = {{-1, 0, 0}, {1, 0, 0}, {0, -0.5, 3}, {0, 0.5, 0}};
    stage *s = new_stage();
    size_t t = square(s, TARGET, 0);
    wall(s, 0, 1);
    s->dynamic.shape = REF_DYN_CIRCLE;
    s->objects[t].enclose = points;
    s->objects[t].enclose_count = 4;
    render(s);
    EXPECT(s, 23, 16, 0, 0.3); /* 7.5 away */
    EXPECT(s, 24, 16, 0, 0.1 + 0.9 * (hypot(8.5, 0.5) - 8) / 4);
    EXPECT(s, 16, 23, 0, 0.3);
    s->dynamic.shape = REF_DYN_HULL; /* a rhombus, 8 wide and 4 high of the middle */
    render(s);
    EXPECT(s, 22, 16, 0, 0.3);
    EXPECT(s, 16, 20, 0, 0.1 + 0.9 * ((0.5 * 4 + 4.5 * 8 - 32) / sqrt(80)) / 4);
    free(s);
}

/* ---- several occluders, several targets ---- */

static void occluders_share(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    wall(s, 0, 1);
    wall(s, 0, 2);
    render(s);
    double a = 1 - sqrt(0.7), edge = 1 - sqrt(0.9);
    EXPECT(s, 16, 16, 0.7, (1 - a) * a, a);
    EXPECT(s, 20, 16, 0, (1 - edge) * edge, edge); /* 0.1 together */
    EXPECT(s, 24, 16, 0, 0, 1);
    s->dynamic.occluders = REF_DYN_EACH;
    render(s);
    EXPECT(s, 16, 16, 0.49, 0.7 * 0.3, 0.3);
    EXPECT(s, 20, 16, 0, 0.9 * 0.1, 0.1);
    free(s);
}

/* "Four targets behind one wall leave 0.8 % of it": 0.3^4 = 0.0081. The targets cut each other in turn. */
static void four_targets_behind_one_wall(void **state) {
    (void)state;
    stage *s = new_stage();
    for (int i = 0; i < 4; ++i)
        square(s, TARGET, -i);
    wall(s, 0, 1);
    s->dynamic.combine = REF_DYN_PRODUCT;
    s->dynamic.occluders = REF_DYN_EACH;
    render(s);
    double wall_alpha = 0.3 * 0.3 * 0.3 * 0.3, left = 1 - wall_alpha;
    near_to(wall_alpha, 0.0081);
    EXPECT(s, 16, 16, left * 0.027, left * 0.973 * 0.09, left * 0.973 * 0.91 * 0.3, left * 0.973 * 0.91 * 0.7,
           wall_alpha);
    s->dynamic.combine = REF_DYN_MIN;
    render(s);
    EXPECT(s, 16, 16, 0.7 * 0.3, 0.49 * 0.3, 0.343 * 0.3, 0.2401, 0.3);
    s->dynamic.occluders = REF_DYN_TOGETHER; /* the farthest has four layers before it */
    render(s);
    double a = 1 - pow(0.7, 0.25);
    EXPECT(s, 16, 16, (1 - a) * a, (1 - a) * (1 - a) * a, (1 - a) * (1 - a) * (1 - a) * a, 0.7, a);
    assert_int_equal(s->pixels[16 * SIZE + 16].target, 4);
    near_to(s->pixels[16 * SIZE + 16].targets_weight, 1 - a);
    free(s);
}

/* The gradient of a target beside another does not thin that one out, but the paper's does. */
static void targets_cut_targets(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    size_t half = add_object(s, TARGET);
    add_sheet(s, half, 0, -1, 1, 1, 1); /* pixels 16 to 23 */
    render(s);
    EXPECT(s, 16, 16, 0.7, 0.3);
    EXPECT(s, 20, 16, 0, 1);
    s->dynamic.whole_masks_cut_targets = true;
    render(s);
    EXPECT(s, 20, 16, 0, 0.1);
    free(s);
}

static void importance_in_a_scene(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    size_t near_wall = wall(s, 0, 2), far_wall = wall(s, 0, 1);
    s->objects[near_wall].importance = 0.5; /* 1 + (0.3 - 1) / 2 = 0.65 */
    s->objects[far_wall].importance = 1;    /* stays, and shares nothing */
    render(s);
    EXPECT(s, 16, 16, 0, 0.65, 0.35);
    s->objects[far_wall].importance = 0;
    render(s);
    double a = 1 - sqrt(0.7), half = 1 - sqrt(0.7) / 2;
    EXPECT(s, 16, 16, (1 - half) * (1 - a), half, (1 - half) * a);
    free(s);
}

/* ---- the rules ---- */

static void r3_impenetrable_surfaces_stay_and_close_masks(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    wall(s, 0, 2);
    size_t shield = add_object(s, IMPENETRABLE);
    add_sheet(s, shield, 0, -2, 2, 2, 1); /* pixels 16 to 31, between the two */
    wall(s, 0, -1);
    render(s);
    EXPECT(s, 15, 16, 0.7, 0.3, 0, 0);
    EXPECT(s, 16, 16, 0, 0.1, 0.9, 0); /* the gradient of pixel 15 runs on over the shield */
    EXPECT(s, 19, 16, 0, 0.775, 0.225, 0);
    EXPECT(s, 20, 16, 0, 1, 0, 0);
    EXPECT(s, 10, 16, 0, 0.325, 0, 0.675);
    assert_int_equal(s->census[0].closed, 32);
    assert_int_equal(s->pixels[16 * SIZE + 16].target, 0);
    s->dynamic.open_behind_impenetrable = true;
    render(s);
    EXPECT(s, 16, 16, 0, 0.3, 0.7, 0);
    EXPECT(s, 20, 16, 0, 0.1, 0.9, 0);
    free(s);
}

static void r3_before_everything(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    wall(s, 0, 1);
    wall(s, IMPENETRABLE, 2);
    render(s);
    for (int i = 0; i < SIZE; ++i)
        EXPECT(s, i, 16, 0, 0, 1);
    near_to(s->census[0].least, 1); /* no open pixel */
    assert_int_equal(s->census[0].closed, 64);
    free(s);
}

/* A target that is bent back before itself: its near part hides its far part, and no mask opens in it. */
static void r4_targets_hide_themselves(void **state) {
    (void)state;
    for (int hollow = 0; hollow < 2; ++hollow) {
        stage *s = new_stage();
        size_t t = add_object(s, TARGET | (hollow ? HOLLOW : 0u));
        add_sheet(s, t, -0.5, -0.5, 0.5, 0.5, 0);
        add_sheet(s, t, 0, -0.5, 0.5, 0.5, 2);
        wall(s, 0, 3);
        wall(s, 0, 1); /* between the two parts: before the far one only */
        render(s);
        double a = 1 - sqrt(0.7);
        EXPECT(s, 17, 16, 0.7, 0.3, 0);
        EXPECT(s, 14, 16, 0.7, a, (1 - a) * a);
        assert_int_equal(s->census[0].pixels, 64);
        free(s);
    }
}

static void impenetrable_targets(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    square(s, TARGET | IMPENETRABLE, 1);
    wall(s, 0, 2);
    render(s);
    EXPECT(s, 16, 16, 0, 0.7, 0.3);
    free(s);
}

static void backdrops_are_never_seen_through(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    size_t ground = add_object(s, BACKDROP);
    add_sheet(s, ground, -2, -2, 2, 0, 1); /* up to pixel row 15 */
    wall(s, 0, 2);
    render(s);
    EXPECT(s, 16, 16, 0.7, 0, 0.3);
    EXPECT(s, 16, 12, 0, 0.225, 0.775);
    assert_int_equal(s->census[0].closed, 32);
    free(s);
}

/* ---- solids, hollows: figure 1 ---- */

/* A hangar around a fighter: front and back wall, each a box with four sides of its own. */
static void a_fighter_in_a_hangar(void **state) {
    (void)state;
    for (int hollow = 0; hollow < 2; ++hollow) {
        stage *s = new_stage();
        square(s, TARGET, 0);
        size_t hangar = add_object(s, hollow ? HOLLOW : 0u);
        add_box(s, hangar, -1.5, -1.5, 1, 1.5, 1.5, 1.25);
        add_box(s, hangar, -1.5, -1.5, -1.25, 1.5, 1.5, -1);
        wall(s, BACKDROP, -2);
        render(s);
        EXPECT(s, 16, 16, 0.7, 0.3, 0);
        /* 0.1 of the front wall, and 0.9 of the back wall or of what is behind the hangar. */
        EXPECT(s, 20, 16, 0, hollow ? 1 : 0.1, hollow ? 0 : 0.9);
        assert_int_equal(s->pixels[16 * SIZE + 20].see_through, 1);
        free(s);
    }
}

/* A hollow occluder counts with each of its surfaces, a solid one once. */
static void hollow_occluders_are_several_layers(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    size_t o = add_object(s, HOLLOW);
    add_box(s, o, -1, -1, 1, 1, 1, 1.25);
    add_box(s, o, -1, -1, 2, 1, 1, 2.25);
    s->dynamic.occluders = REF_DYN_EACH;
    render(s);
    EXPECT(s, 16, 16, 0.49, 0.51);
    assert_int_equal(s->pixels[16 * SIZE + 16].see_through, 2);
    s->objects[o].flags = 0;
    render(s);
    EXPECT(s, 16, 16, 0.7, 0.3);
    free(s);
}

/* ---- rooms and trees: figures 5 and 6 ---- */

/* Two walls with doorways that overlap in part: pixels 14 to 17 of the near one, 16 to 19 of the far one. */
static void a_thing_two_rooms_away(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    size_t far_wall = add_object(s, 0), near_wall = add_object(s, 0);
    add_sheet(s, far_wall, -3, -3, 0, 3, 1);
    add_sheet(s, far_wall, 0.5, -3, 3, 3, 1);
    add_sheet(s, near_wall, -3, -3, -0.25, 3, 2);
    add_sheet(s, near_wall, 0.25, -3, 3, 3, 2);
    render(s);
    double a = 1 - sqrt(0.7), edge = 1 - sqrt(0.9), ring = 1 - sqrt(0.675);
    EXPECT(s, 12, 16, 0.7, (1 - a) * a, a); /* both walls */
    EXPECT(s, 13, 13, 0.7, (1 - a) * a, a);
    EXPECT(s, 14, 16, 0.7, 0.3, 0); /* through the near doorway */
    EXPECT(s, 15, 19, 0.7, 0.3, 0);
    EXPECT(s, 16, 16, 1, 0, 0); /* through both */
    EXPECT(s, 17, 12, 1, 0, 0);
    EXPECT(s, 18, 16, 0.7, 0, 0.3); /* the far doorway behind the near wall */
    EXPECT(s, 19, 19, 0.7, 0, 0.3);
    EXPECT(s, 20, 16, 0, (1 - edge) * edge, edge);
    EXPECT(s, 21, 16, 0, (1 - ring) * ring, ring);
    EXPECT(s, 24, 16, 0, 0, 1);
    EXPECT(s, 15, 20, 0, 0.1, 0); /* above it, in the near doorway */
    EXPECT(s, 15, 24, 0, 1, 0);
    EXPECT(s, 16, 20, 0, 0, 0);
    near_to(s->pixels[20 * SIZE + 16].background, 1);
    near_to(s->pixels[20 * SIZE + 15].background, 0.9);
    free(s);
}

/* Crowns over pixels 8 to 15 and, higher, 14 to 23; a boulder over 18 to 23 up to row 13; ground below everything. */
static void a_tank_under_trees(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    size_t low = add_object(s, 0), high = add_object(s, 0), boulder = add_object(s, IMPENETRABLE);
    wall(s, BACKDROP, -1);
    add_sheet(s, low, -1, -1, 0, 1, 1);
    add_sheet(s, high, -0.25, -1, 1, 1, 2);
    add_sheet(s, boulder, 0.25, -1, 1, -0.25, 0.5);
    render(s);
    double a = 1 - sqrt(0.7), edge = 1 - sqrt(0.9);
    EXPECT(s, 13, 16, 0.7, 0.3, 0, 0, 0);
    EXPECT(s, 15, 16, 0.7, (1 - a) * a, a, 0, 0); /* where the crowns overlap */
    EXPECT(s, 17, 16, 0.7, 0, 0.3, 0, 0);
    EXPECT(s, 11, 16, 0, 0.1, 0, 0, 0.9);
    EXPECT(s, 10, 16, 0, 0.325, 0, 0, 0.675);
    EXPECT(s, 7, 16, 0, 0, 0, 0, 1);
    EXPECT(s, 20, 16, 0, 0, 0.1, 0, 0.9);
    EXPECT(s, 15, 20, 0, (1 - edge) * edge, edge, 0, 0.9);
    EXPECT(s, 19, 13, 0, 0, 0.1, 0.9, 0); /* behind the boulder: the gradient of the row above */
    EXPECT(s, 19, 12, 0, 0, 0.325, 0.675, 0);
    EXPECT(s, 23, 9, 0, 0, 1, 0, 0);
    EXPECT(s, 17, 13, 0.7, 0, 0.3, 0, 0); /* beside it */
    assert_int_equal(s->census[0].closed, 4);
    assert_int_equal(s->census[0].hidden, 64);
    free(s);
}

/* ---- layer control ---- */

/* One layer: the nearest wall is cut, the next stays and hides the target. */
static void layer_control(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, -1);
    for (int i = 0; i < 4; ++i)
        wall(s, 0, i);
    s->dynamic.occluders = REF_DYN_EACH;
    s->dynamic.layers = 1;
    render(s);
    EXPECT(s, 16, 16, 0, 0, 0, 0.7, 0.3);
    assert_int_equal(s->pixels[16 * SIZE + 16].see_through, 1);
    EXPECT(s, 20, 16, 0, 0, 0, 0.9, 0.1);
    s->dynamic.layers = 3;
    render(s);
    EXPECT(s, 16, 16, 0, 0.343, 0.49 * 0.3, 0.7 * 0.3, 0.3);
    s->dynamic.layers = 4;
    render(s);
    EXPECT(s, 16, 16, 0.2401);
    s->dynamic.occluders = REF_DYN_TOGETHER; /* two share what four would */
    s->dynamic.layers = 2;
    render(s);
    EXPECT(s, 16, 16, 0, 0, 0.7);
    s->dynamic.layers = 0;
    render(s);
    EXPECT(s, 16, 16, 0.7);
    free(s);
}

/* What cannot become transparent takes no place among the layers. */
static void layer_control_counts_what_yields(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    wall(s, 0, 1);
    size_t important = add_object(s, 0);
    add_sheet(s, important, 0, -2, 2, 2, 2);
    s->objects[important].importance = 0.5;
    s->dynamic.layers = 1;
    render(s);
    EXPECT(s, 14, 16, 0.7, 0.3, 0);
    EXPECT(s, 17, 16, 0, 0.35, 0.65);
    s->objects[important].importance = 1;
    render(s);
    EXPECT(s, 17, 16, 0, 0, 1);
    free(s);
}

/* ---- active mode, fading ---- */

/* The light's middle is the centre of pixel 16,16; radius 2, edge 4: full up to 18, a half in 20, none in 22. */
static void search_light(void **state) {
    (void)state;
    static const ref_dyn_light light = {16.5, 16.5, 2, 4};
    stage *s = new_stage();
    size_t t = add_object(s, TARGET | ACTIVE);
    add_sheet(s, t, -2, -2, 2, 2, 0);
    wall(s, 0, 1);
    render(s);
    EXPECT(s, 16, 16, 0, 1); /* active and no light */
    s->dynamic.lights = &light;
    s->dynamic.light_count = 1;
    render(s);
    EXPECT(s, 16, 16, 0.7, 0.3);
    EXPECT(s, 18, 16, 0.7, 0.3);
    EXPECT(s, 20, 16, 0.35, 0.65);
    EXPECT(s, 22, 16, 0, 1);
    s->objects[t].flags = TARGET; /* passive: lights do nothing */
    render(s);
    EXPECT(s, 22, 16, 0.7, 0.3);
    free(s);
}

/* Under a half light two walls together let half of 0.7 through; each for itself 0.65. */
static void search_light_before_two_walls(void **state) {
    (void)state;
    static const ref_dyn_light light = {16.5, 16.5, 2, 4};
    stage *s = new_stage();
    size_t t = add_object(s, TARGET | ACTIVE);
    add_sheet(s, t, -2, -2, 2, 2, 0);
    wall(s, 0, 1);
    wall(s, 0, 2);
    s->dynamic.lights = &light;
    s->dynamic.light_count = 1;
    render(s);
    EXPECT(s, 20, 16, 0.35);
    s->dynamic.occluders = REF_DYN_EACH;
    render(s);
    EXPECT(s, 20, 16, 0.35 * 0.35);
    free(s);
}

static void fading(void **state) {
    (void)state;
    stage *s = new_stage();
    size_t t = square(s, TARGET, 0);
    wall(s, 0, 1);
    s->objects[t].faded = 0.5;
    render(s);
    EXPECT(s, 16, 16, 0.35, 0.65);
    EXPECT(s, 20, 16, 0, 0.55);
    s->objects[t].faded = 1;
    render(s);
    EXPECT(s, 16, 16, 0, 1);
    free(s);
}

/* ---- order ---- */

/* A wall that leans away: its middle is behind the target's, but before the target it is nearer. */
static void leaning_wall(stage *s) {
    square(s, TARGET, 0);
    size_t o = add_object(s, 0);
    add_sheet(s, o, -2, -2, 2, 2, 1);
    add_sheet(s, o, 2.5, -2, 3, 2, -3.5); /* out of the window; takes the middle of the box to z = -1.25 */
}

static void object_centres_miss_what_depth_sees(void **state) {
    (void)state;
    stage *s = new_stage();
    leaning_wall(s);
    render(s);
    EXPECT(s, 16, 16, 0.7, 0.3);
    s->dynamic.order = REF_DYN_OBJECT_CENTRES;
    render(s);
    EXPECT(s, 16, 16, 0, 1); /* painted first, and the target behind it fails the depth test */
    EXPECT(s, 20, 16, 0, 1);
    free(s);
}

/* Painted after the target, a wall is cut by its gradient though it lies behind; where the target is, it fails. */
static void object_centres_cut_what_is_behind(void **state) {
    (void)state;
    stage *s = new_stage();
    size_t t = add_object(s, TARGET);
    add_sheet(s, t, -0.5, -0.5, 0.5, 0.5, 1);
    add_sheet(s, t, 2.5, -2, 3, 2, -3.5);
    wall(s, 0, 0);
    render(s);
    EXPECT(s, 16, 16, 1, 0);
    EXPECT(s, 20, 16, 0, 1);
    s->dynamic.order = REF_DYN_OBJECT_CENTRES;
    render(s);
    EXPECT(s, 16, 16, 1, 0);
    EXPECT(s, 20, 16, 0, 0.1);
    free(s);
}

/* Backdrops come first even where their middle is nearest: what is cut shows them. */
static void object_centres_paint_backdrops_first(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    wall(s, 0, 1);
    size_t o = wall(s, BACKDROP, -1);
    add_sheet(s, o, 2.5, -2, 3, 2, 3.9); /* out of the window; the middle is at 1.45 */
    s->dynamic.order = REF_DYN_OBJECT_CENTRES;
    render(s);
    EXPECT(s, 16, 16, 0.7, 0.3, 0);
    EXPECT(s, 20, 16, 0, 0.1, 0.9);
    free(s);
}

/* Three dolls with one middle, the innermost a target. Without a group they are painted by id, the highest first. */
static void nested_dolls(void **state) {
    (void)state;
    stage *s = new_stage();
    for (int i = 0; i < 3; ++i) {
        size_t o = add_object(s, i == 0 ? TARGET : 0u);
        double r = 0.5 + 0.5 * i;
        add_box(s, o, -r, -r, -r, r, r, r);
        s->objects[o].rank = i;
    }
    double a = 1 - sqrt(0.7);
    render(s);
    EXPECT(s, 16, 16, 0.7, (1 - a) * a, a);
    s->dynamic.order = REF_DYN_OBJECT_CENTRES;
    render(s);
    EXPECT(s, 16, 16, 0, 0, 1);
    for (int i = 0; i < 3; ++i)
        s->objects[i].group = 7;
    render(s);
    EXPECT(s, 16, 16, 0.7, (1 - a) * a, a);
    free(s);
}

/* A group is painted where the mean of its middles is: its front wall comes before the target that stands in it. */
static void groups_are_painted_as_one(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    size_t back = wall(s, 0, -1), front = wall(s, 0, 0.5);
    s->dynamic.order = REF_DYN_OBJECT_CENTRES;
    s->objects[back].group = s->objects[front].group = 1; /* mean -0.25 */
    s->objects[front].rank = 1;
    render(s);
    EXPECT(s, 16, 16, 0, 0, 1);
    s->objects[front].group = 2;
    render(s);
    EXPECT(s, 16, 16, 0.7, 0, 0.3);
    free(s);
}

/* Nothing at the very depth of a target hides it; otherwise rank decides within a group, and then the lowest id. */
static void coincident_layers(void **state) {
    (void)state;
    stage *s = new_stage();
    wall(s, 0, 0);
    wall(s, 0, 0);
    size_t t = square(s, TARGET, 0);
    render(s);
    EXPECT(s, 16, 16, 0, 0, 1);
    EXPECT(s, 4, 16, 1, 0, 0);
    EXPECT(s, 20, 16, 1, 0, 0); /* beside it, what has its depth is not cut */
    s->objects[0].group = s->objects[1].group = 3;
    s->objects[1].rank = 1;
    s->objects[t].flags = 0;
    render(s);
    EXPECT(s, 4, 16, 0, 1, 0);
    s->objects[0].rank = 1;
    render(s);
    EXPECT(s, 16, 16, 1, 0, 0);
    free(s);
}

/* ---- any scene ---- */

static double uniform(uint32_t *seed) {
    *seed = *seed * 1664525u + 1013904223u;
    return (double)(*seed >> 8) / 16777216.0;
}

/* Boxes and sheets anywhere before a camera that may look in perspective; every fourth is a target. */
static void make_any_scene(stage *s, uint32_t seed, bool shields) {
    size_t count = 6 + seed % 15;
    for (size_t i = 0; i < count; ++i) {
        double kind = uniform(&seed), p[6];
        uint32_t flags = i % 4 == 0 ? TARGET : (shields && kind < 0.15 ? IMPENETRABLE : 0u);
        size_t o = add_object(s, flags | (kind > 0.8 ? HOLLOW : 0u));
        for (int k = 0; k < 3; ++k) {
            double size = (i % 4 == 0 ? 0.2 : 0.5) + uniform(&seed), middle = 4 * uniform(&seed) - 2;
            p[k] = middle - size / 2;
            p[3 + k] = middle + size / 2;
        }
        add_box(s, o, p[0], p[1], p[2], p[3], p[4], p[5]);
        s->objects[o].group = kind < 0.3 ? 1 + (uint32_t)i % 3 : 0;
        s->objects[o].rank = (int)(i % 4);
    }
    if (seed % 2) { /* from z = 8, 28 degrees to either side */
        memset(s->scene.projection, 0, sizeof s->scene.projection);
        s->scene.projection[0] = s->scene.projection[5] = 1.9;
        s->scene.projection[10] = -1.2;
        s->scene.projection[11] = -1;
        s->scene.projection[14] = -2.2;
        s->scene.view[14] = -8;
    }
    double angle = 6.28 * uniform(&seed), c = cos(angle), d = sin(angle);
    s->scene.view[0] = s->scene.view[10] = c;
    s->scene.view[2] = -d;
    s->scene.view[8] = d;
}

enum { SCENES = 300 };

/* R1 with the defaults, however many occluders and targets: what lies behind the farthest target of a pixel and in front
 * of it has at most alpha_T together. And the weights of a pixel are all of it. */
static void r1_holds_in_any_scene(void **state) {
    (void)state;
    double least = 1, least_targets = 1;
    size_t pixels = 0;
    for (uint32_t seed = 1; seed <= SCENES; ++seed) {
        stage *s = new_stage();
        make_any_scene(s, seed, seed % 3 == 0);
        render(s);
        for (size_t i = 0; i < SIZE * SIZE; ++i) {
            double sum = s->pixels[i].background;
            for (size_t o = 0; o < s->scene.object_count; ++o)
                sum += s->weights[i * s->scene.object_count + o];
            near_to(sum, 1);
            if (!s->pixels[i].target)
                continue;
            ++pixels;
            least = fmin(least, s->pixels[i].target_weight);
            least_targets = fmin(least_targets, s->pixels[i].targets_weight);
        }
        free(s);
    }
    print_message("%zu target pixels: least weight of the farthest target %.6f, of all targets %.6f\n", pixels, least,
                  least_targets);
    assert_true(pixels > 10000);
    assert_true(least >= 0.7 - 1e-12 && least_targets >= 0.7 - 1e-12);
    assert_true(least < 0.7 + 1e-12);
}

/* The paper's masks in the same scenes: least weights far below. */
static void the_papers_least_weight(void **state) {
    (void)state;
    double least = 1, least_per_pixel = 1;
    for (uint32_t seed = 1; seed <= SCENES; ++seed) {
        stage *s = new_stage();
        make_any_scene(s, seed, false);
        for (int centres = 0; centres < 2; ++centres) {
            ref_dyn_published(&s->dynamic);
            s->dynamic.order = centres ? REF_DYN_OBJECT_CENTRES : REF_DYN_PER_PIXEL;
            render(s);
            for (size_t i = 0; i < SIZE * SIZE; ++i)
                if (s->pixels[i].target && centres)
                    least = fmin(least, s->pixels[i].target_weight);
                else if (s->pixels[i].target)
                    least_per_pixel = fmin(least_per_pixel, s->pixels[i].target_weight);
        }
        free(s);
    }
    print_message("published: least weight of the farthest target %.6f, ordered per pixel %.6f\n", least,
                  least_per_pixel);
    assert_true(least < 1e-12); /* the wrong object painted first hides it whole */
    assert_true(least_per_pixel > 0 && least_per_pixel < 0.35);
}

/* R3: with an impenetrable surface nearest to the eye nothing else is seen; of layers at most n are seen through. */
static void r3_and_layers_in_any_scene(void **state) {
    (void)state;
    size_t shields = 0, deep = 0;
    for (uint32_t seed = 1; seed <= SCENES / 2; ++seed) {
        stage *s = new_stage();
        make_any_scene(s, seed, true);
        s->dynamic.layers = 1 + seed % 3;
        render(s);
        for (size_t i = 0; i < SIZE * SIZE; ++i) {
            const double *weights = s->weights + i * s->scene.object_count;
            for (size_t o = 0; o < s->scene.object_count; ++o)
                if (s->objects[o].flags & IMPENETRABLE && weights[o] > 0) {
                    near_to(s->pixels[i].background, 0);
                    ++shields;
                }
            deep += s->pixels[i].see_through == s->dynamic.layers;
        }
        free(s);
    }
    assert_true(shields > 1000 && deep > 1000);
}

/* Targets that no other target covers: the nth occluder from the eye is the last that lets anything through. */
static void layers_of_one_target_in_any_scene(void **state) {
    (void)state;
    size_t deep = 0;
    for (uint32_t seed = 1; seed <= SCENES / 2; ++seed) {
        stage *s = new_stage();
        make_any_scene(s, seed, false);
        for (size_t o = 1; o < s->scene.object_count; ++o)
            s->objects[o].flags &= ~(uint32_t)TARGET;
        s->dynamic.layers = 1 + seed % 3;
        render(s);
        for (size_t i = 0; i < SIZE * SIZE; ++i) {
            assert_true(s->pixels[i].see_through <= s->dynamic.layers);
            deep += s->pixels[i].see_through == s->dynamic.layers;
        }
        free(s);
    }
    assert_true(deep > 1000);
}

/* Active targets: what a light does not reach is drawn as if nothing were a target. */
static void lights_in_any_scene(void **state) {
    (void)state;
    static const ref_dyn_light two[2] = {{8, 8, 3, 3}, {22, 20, 5, 0}};
    size_t lit = 0;
    for (uint32_t seed = 1; seed <= SCENES / 3; ++seed) {
        stage *s = new_stage(), *plain = new_stage();
        make_any_scene(s, seed, false);
        make_any_scene(plain, seed, false);
        for (size_t o = 0; o < s->scene.object_count; ++o) {
            s->objects[o].flags |= s->objects[o].flags & TARGET ? ACTIVE : 0u;
            plain->objects[o].flags &= ~(uint32_t)TARGET;
        }
        s->dynamic.lights = two;
        s->dynamic.light_count = 2;
        render(s);
        render(plain);
        for (size_t i = 0; i < SIZE * SIZE; ++i) {
            double light = ref_dyn_light_at(&s->dynamic, (double)(i % SIZE) + 0.5, (double)(i / SIZE) + 0.5);
            if (light <= 0)
                assert_memory_equal(s->pixels[i].color, plain->pixels[i].color, sizeof plain->pixels[i].color);
            if (light >= 1 && s->pixels[i].target) {
                assert_true(s->pixels[i].target_weight >= 0.7 - 1e-12);
                ++lit;
            }
        }
        free(s);
        free(plain);
    }
    assert_true(lit > 500);
}

/* The same objects in another order of the arrays: the same picture. */
static void order_of_arrays_does_not_matter(void **state) {
    (void)state;
    for (uint32_t seed = 1; seed <= 120; ++seed) {
        stage *s = new_stage(), *t = new_stage();
        make_any_scene(s, seed, true);
        make_any_scene(t, seed, true);
        if (seed % 2) {
            ref_dyn_published(&s->dynamic);
            ref_dyn_published(&t->dynamic);
        }
        size_t count = s->scene.object_count;
        for (size_t o = 0; o < count; ++o) { /* reversed and turned */
            size_t from = (count - 1 - o + seed) % count;
            t->meshes[o] = s->meshes[from];
            t->objects[o] = s->objects[from];
        }
        render(s);
        render(t);
        for (size_t i = 0; i < SIZE * SIZE; ++i) {
            assert_int_equal(s->pixels[i].target, t->pixels[i].target);
            assert_int_equal(s->pixels[i].left_out, t->pixels[i].left_out);
            for (int k = 0; k < 3; ++k) /* products of masks are taken in the order of the array */
                near_to(s->pixels[i].color[k], t->pixels[i].color[k]);
        }
        free(s);
        free(t);
    }
}

/* Without targets, or with nothing but impenetrable things, the picture is that of plain opaque drawing, bit for bit. */
static void nothing_called_for_nothing_changed(void **state) {
    (void)state;
    ref_pixel plain[SIZE * SIZE];
    for (uint32_t seed = 1; seed <= 60; ++seed) {
        stage *s = new_stage();
        make_any_scene(s, seed, false);
        assert_true(ref_render(&s->scene, plain));
        for (size_t o = 0; o < s->scene.object_count; ++o)
            s->objects[o].flags = seed % 2 ? s->objects[o].flags & HOLLOW : s->objects[o].flags | IMPENETRABLE;
        render(s);
        for (size_t i = 0; i < SIZE * SIZE; ++i) {
            assert_memory_equal(s->pixels[i].color, plain[i].color, sizeof plain[i].color);
            assert_int_equal(s->pixels[i].see_through, 0);
        }
        free(s);
    }
}

/* ---- comparisons ---- */

/* Left out: where the square's or a wall's border passes nearer than half a pixel, and nowhere else. */
static void left_out(void **state) {
    (void)state;
    stage *s = new_stage();
    size_t t = add_object(s, TARGET);
    add_sheet(s, t, -0.52, -0.52, 0.52, 0.52, 0); /* from 11.84 to 20.16 */
    wall(s, 0, 1);
    render(s);
    size_t count = 0;
    for (size_t i = 0; i < SIZE * SIZE; ++i)
        count += s->pixels[i].left_out;
    assert_int_equal(count, 4 * 9);
    assert_true(s->pixels[16 * SIZE + 20].left_out && s->pixels[16 * SIZE + 11].left_out);
    assert_false(s->pixels[16 * SIZE + 12].left_out);
    s->objects[t].flags = 0; /* behind an opaque wall nobody sees the border */
    render(s);
    for (size_t i = 0; i < SIZE * SIZE; ++i)
        assert_false(s->pixels[i].left_out);
    free(s);
}

/* As many layers on both sides of a seam, but other ones. */
static void left_out_along_seams(void **state) {
    (void)state;
    stage *s = new_stage();
    add_sheet(s, add_object(s, 0), -2, -2, 0.02, 2, 0);
    add_sheet(s, add_object(s, 0), 0.02, -2, 2, 2, 0);
    render(s);
    for (int x = 0; x < SIZE; ++x)
        assert_int_equal(s->pixels[16 * SIZE + x].left_out, x == 16);
    free(s);
}

static void refuses_nonsense(void **state) {
    (void)state;
    stage *s = new_stage();
    square(s, TARGET, 0);
    wall(s, 0, 1);
    render(s);
    const ref_dyn_scene good = s->dynamic;
    for (int i = 0; i < 7; ++i) {
        ref_dyn_scene *bad = &s->dynamic;
        *bad = good;
        bad->alpha_target = i == 0 ? 1.5 : (i == 1 ? (double)NAN : bad->alpha_target);
        bad->alpha_start = i == 2 ? -0.1 : bad->alpha_start;
        bad->width = i == 3 ? -1 : (i == 4 ? (double)INFINITY : bad->width);
        s->objects[0].flags = i == 5 ? TARGET | BACKDROP : TARGET;
        s->meshes[1].transparent = i == 6;
        assert_false(ref_dyn_render(bad, s->pixels, NULL, NULL));
    }
    s->meshes[1].transparent = false;
    s->scene.width = 0;
    s->dynamic = good;
    assert_true(ref_dyn_render(&s->dynamic, s->pixels, NULL, NULL));
    free(s);
}

/* Importances that are no number yield nothing, points behind the eye enclose nothing, NaN vertices are not seen. */
static void bad_numbers(void **state) {
    (void)state;
    static const double behind[1][3] = {{1, 0, 20}};
    stage *s = new_stage();
    square(s, TARGET, 0);
    wall(s, 0, 1);
    s->objects[0].importance = (double)NAN;
    render(s);
    EXPECT(s, 16, 16, 0, 1);
    s->objects[0].importance = (double)INFINITY;
    render(s);
    EXPECT(s, 16, 16, 0.7, 0.3);
    s->objects[0].faded = -1;
    s->dynamic.shape = REF_DYN_CIRCLE;
    s->objects[0].enclose = behind;
    s->objects[0].enclose_count = 1;
    s->scene.projection[11] = -0.125; /* w = 1 - z / 8: z = 20 has w < 0 */
    render(s);
    EXPECT(s, 16, 16, 0.7, 0.3);
    EXPECT(s, 20, 16, 0, 0.3); /* in the circle around the pixels themselves */
    EXPECT(s, 0, 16, 0, 1);
    s->solids[1].positions[2] = NAN;
    render(s);
    assert_true(weight(s, 16, 16, 0) + weight(s, 16, 16, 1) > 0.69);
    free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(importances),
        cmocka_unit_test(sharing),
        cmocka_unit_test(lights),
        cmocka_unit_test(a_wall_before_a_target),
        cmocka_unit_test(rings_of_eight_neighbours),
        cmocka_unit_test(no_gradient),
        cmocka_unit_test(a_mask_leaves_what_is_behind),
        cmocka_unit_test(the_nearer_of_equally_near_pixels),
        cmocka_unit_test(convex_hull),
        cmocka_unit_test(circle),
        cmocka_unit_test(ellipse),
        cmocka_unit_test(shapes_around_given_points),
        cmocka_unit_test(occluders_share),
        cmocka_unit_test(four_targets_behind_one_wall),
        cmocka_unit_test(targets_cut_targets),
        cmocka_unit_test(importance_in_a_scene),
        cmocka_unit_test(r3_impenetrable_surfaces_stay_and_close_masks),
        cmocka_unit_test(r3_before_everything),
        cmocka_unit_test(r4_targets_hide_themselves),
        cmocka_unit_test(impenetrable_targets),
        cmocka_unit_test(backdrops_are_never_seen_through),
        cmocka_unit_test(a_fighter_in_a_hangar),
        cmocka_unit_test(hollow_occluders_are_several_layers),
        cmocka_unit_test(a_thing_two_rooms_away),
        cmocka_unit_test(a_tank_under_trees),
        cmocka_unit_test(layer_control),
        cmocka_unit_test(layer_control_counts_what_yields),
        cmocka_unit_test(search_light),
        cmocka_unit_test(search_light_before_two_walls),
        cmocka_unit_test(fading),
        cmocka_unit_test(object_centres_miss_what_depth_sees),
        cmocka_unit_test(object_centres_cut_what_is_behind),
        cmocka_unit_test(object_centres_paint_backdrops_first),
        cmocka_unit_test(nested_dolls),
        cmocka_unit_test(groups_are_painted_as_one),
        cmocka_unit_test(coincident_layers),
        cmocka_unit_test(r1_holds_in_any_scene),
        cmocka_unit_test(the_papers_least_weight),
        cmocka_unit_test(r3_and_layers_in_any_scene),
        cmocka_unit_test(layers_of_one_target_in_any_scene),
        cmocka_unit_test(lights_in_any_scene),
        cmocka_unit_test(order_of_arrays_does_not_matter),
        cmocka_unit_test(nothing_called_for_nothing_changed),
        cmocka_unit_test(left_out),
        cmocka_unit_test(left_out_along_seams),
        cmocka_unit_test(refuses_nonsense),
        cmocka_unit_test(bad_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

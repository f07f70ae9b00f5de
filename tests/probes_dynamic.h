/* Probe pixels of dynamic transparency worked out by hand: how much of each object is seen at
 * chosen pixels of simple scenes, from Assarsson, Elmqvist and Tsigas 2006 as the project's
 * design amends it.  The layers and their alphas were named by hand from the sentences; the
 * arithmetic (products, powers, the published column) was done by a throw-away script, which
 * also tried every scene by casting the pixel's ray, to catch slips of the hand.
 *
 * Window.  width x height pixels; pixel (x, y) has its centre at (x + 0.5, y + 0.5), y up.
 * Depth z grows away from the eye.  Orthographic: object x and y are window pixels.
 * Perspective: eye at the origin looking along +z, x right, y up; a point is seen at
 * (width/2 + focal x/z, height/2 + focal y/z).  Objects are sorted by z, not by distance.
 *
 * Parts.  Rectangle: corners a and b, one of whose coordinates is the same: the axis it is
 * perpendicular to.  Box: closed, from a to b.  Sphere: centre a, radius b[0].  All parts are
 * seen from both sides; an object's parts are one object.  Rectangles that share an edge with
 * others of their object are no outline there; no probe is nearer than 0.75 to any edge.
 *
 * Weights.  weights[0] is the background's, weights[1 + i] that of object i of the scene; they
 * sum to 1, and the pixel's colour is their sum of colours.
 *
 * The rules, in the order applied, with the sentence each comes from.  DESIGN marks the design.
 *  1 A solid object has one surface at a pixel, its front-most (paper 4, criterion 2); every
 *    surface of a hollow one counts on its own (paper 4, "four walls ... four separate groups").
 *  2 A mask is alpha_t on the target itself, and a = alpha_0 + (1 - alpha_0) d / gradient
 *    around it, d the distance in pixels from the pixel's centre to the target's outline, closed
 *    (1) from d = gradient on (DESIGN: "gradient over n pixels from alpha_0 to 1").
 *  3 It acts on what is nearer than the target (DESIGN: "fragments nearer than the target's
 *    fragment there"), never on the target itself (R4), never on a backdrop.
 *  4 An impenetrable surface before the target keeps alpha 1 (R3) and closes the mask at that
 *    pixel (DESIGN: "also closes the mask of what it hides").
 *  5 layers = n > 0: only the n nearest of the occluders open (DESIGN); 0: all.
 *  6 Occluder o gets mix(1, a, clamp(importance_t - importance_o, 0, 1)) (DESIGN).  A target that
 *    occludes another target gets a, as in the paper ("all parts of objects (target or
 *    distractor) in front of a target"; DESIGN: "targets cut targets").
 *  7 An active target's mask counts inside search lights only (paper 3.4).
 *  8 DYN_PROBE_TOGETHER: of the m occluders that open, each gets 1 - (1 - a)^(1/m), so that
 *    what is behind keeps 1 - a (DESIGN).  DYN_PROBE_EACH: each gets a (paper).
 *  9 Several masks on one surface: DYN_PROBE_MIN the least (DESIGN, R2), DYN_PROBE_PRODUCT the
 *    product (paper 4.3).
 * published: product and each, and an impenetrable surface closes no mask (the paper names no
 * such thing: its alpha channel stays as it is); all else as above.  DIFFERS at the end of a
 * reason: the published weights are not the default ones.  has_published = 0 where the paper
 * does not say: layer control (3.5 gives no algorithm) and corners and round targets (algorithm
 * 3 says neither four nor eight neighbours, so the distance there is not settled).
 *
 * Where a sentence has several readings (unsure = 1: this answer hangs on the reading taken):
 *  - "targets cut targets" against the importance formula.  Two targets of importance 1 have
 *    difference 0, hence alpha 1 by the formula, and the nearer would not be cut; R1 and the two
 *    sentences quoted at 6 say that it is.  Taken: it is, by a.  No probe has a target of
 *    importance under 1 behind a target.
 *  - "a target keeps weight >= 1 - alpha_T": a target that is itself cut for one behind it
 *    cannot keep 0.7.  Taken: the share let through by all that lies before a target is
 *    >= 1 - alpha_T; the target's own alpha is another matter.  In figure 5 a target in plain
 *    sight (C) is cut by the gradient, not only by the body, of one behind it; sparing targets
 *    in the gradient would be the other reading.
 *  - "alpha_T shared over the m occluders": the gradient could go unshared.  Taken: shared, or
 *    the picture would jump at the outline and at every occluder's edge.
 *  - m counts occluders that are opened: not impenetrable ones, not those beyond n layers, not
 *    those whose importance keeps them opaque.  Counting all before the target is the other
 *    reading (layers = 2 of 4: 0.085 instead of 0.163).
 *  - different importances shared: each its own alpha, 1 - (1 - a_o)^(1/m); others could be meant.
 *  - product with together: shared first, then multiplied.
 *  - which depth has a target in its gradient?  Targets whose gradient is probed face the eye at
 *    one depth; for the dolls it is the order of their group.
 *  - gradient steps: alpha_0 + (1 - alpha_0)(k - 1)/n, (k - 1)/(n - 1), k/n and (k - 1/2)/n for
 *    the k-th pixel all fit the sentences; the middle one, d = k - 1/2, is taken and the
 *    tolerance is what half a pixel more or less makes.
 *  - a mask whose target is partly behind an impenetrable surface grows from the whole outline
 *    and is closed where that surface covers it; growing from what is visible is the other reading.
 *  - a soft edge of a search light may lie inside or outside its radius: probes stay clear of
 *    radius +- (soft + 1); several lights open as their maximum.
 *  - "never hides a target" of a backdrop is the host's promise or a deed: no probe has a
 *    backdrop before a target.
 *  - at one depth in one group the later in the order covers the earlier.
 *
 * Tolerance holds for each weight, in a computation without quantisation; pictures in 8 bits
 * add their own.
 */
#ifndef GLASSINE_TESTS_PROBES_DYNAMIC_H
#define GLASSINE_TESTS_PROBES_DYNAMIC_H

#include <stddef.h>
#include <stdint.h>

/* clang-format off */

enum { DYN_PROBE_RECTANGLE, DYN_PROBE_BOX, DYN_PROBE_SPHERE };
enum { DYN_PROBE_MIN, DYN_PROBE_PRODUCT };
enum { DYN_PROBE_TOGETHER, DYN_PROBE_EACH };
enum { DYN_PROBE_TARGET = 1, DYN_PROBE_IMPENETRABLE = 2, DYN_PROBE_HOLLOW = 4, DYN_PROBE_BACKDROP = 8, DYN_PROBE_ACTIVE = 16 };
enum { DYN_PROBE_MAX_WEIGHTS = 14 };

typedef struct dyn_probe_part { int kind; double a[3], b[3]; } dyn_probe_part;

/* group 0: alone; else objects of one group are drawn by rank, lowest (innermost) first */
typedef struct dyn_probe_object {
    const char *name; uint32_t flags; double importance; int group, rank; double color[3];
    int part_count; const dyn_probe_part *parts;
} dyn_probe_object;

/* pixels, y up; soft: width of the soft edge */
typedef struct dyn_probe_light { double x, y, radius, soft; } dyn_probe_light;

/* figure: 1, 2, 5, 6 of the paper; -1 ... -4 R1 to R4, -5 layer control, -6 importance,
 * -7 combine and occluders, -8 search lights, -9 groups, -10 backdrop, -11 hollow */
typedef struct dyn_probe_scene {
    const char *name; int figure, width, height, perspective; double focal;
    double alpha_t, alpha_0, gradient; int combine, occluders, layers; double background[3];
    int object_count; const dyn_probe_object *objects; int light_count; const dyn_probe_light *lights;
} dyn_probe_scene;

typedef struct dyn_probe {
    int scene, x, y; double weights[DYN_PROBE_MAX_WEIGHTS], tolerance;
    int has_published; double published[DYN_PROBE_MAX_WEIGHTS], published_tolerance;
    int unsure; const char *why;
} dyn_probe;

/* scene 0: figure 1, four walls, floor and roof as objects of their own. Front wall on pixels 20..140 x 30..90, back wall on 50..110 x 45..75, jet 60..100 x 50..60. */
static const dyn_probe_part dyn_probe_parts_0_0[] = {
    {DYN_PROBE_RECTANGLE, {-6.0, -3.0, 10.0}, {6.0, 3.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_0_1[] = {
    {DYN_PROBE_RECTANGLE, {-6.0, -3.0, 20.0}, {6.0, 3.0, 20.0}},
};
static const dyn_probe_part dyn_probe_parts_0_2[] = {
    {DYN_PROBE_RECTANGLE, {-6.0, -3.0, 10.0}, {-6.0, 3.0, 20.0}},
};
static const dyn_probe_part dyn_probe_parts_0_3[] = {
    {DYN_PROBE_RECTANGLE, {6.0, -3.0, 10.0}, {6.0, 3.0, 20.0}},
};
static const dyn_probe_part dyn_probe_parts_0_4[] = {
    {DYN_PROBE_RECTANGLE, {-6.0, -3.0, 10.0}, {6.0, -3.0, 20.0}},
};
static const dyn_probe_part dyn_probe_parts_0_5[] = {
    {DYN_PROBE_RECTANGLE, {-6.0, 3.0, 10.0}, {6.0, 3.0, 20.0}},
};
static const dyn_probe_part dyn_probe_parts_0_6[] = {
    {DYN_PROBE_RECTANGLE, {-3.0, -1.5, 15.0}, {3.0, 0.0, 15.0}},
};
static const dyn_probe_part dyn_probe_parts_0_7[] = {
    {DYN_PROBE_RECTANGLE, {3.6, -2.7, 18.0}, {5.4, -0.9, 18.0}},
};
static const dyn_probe_part dyn_probe_parts_0_8[] = {
    {DYN_PROBE_RECTANGLE, {-60.0, -60.0, 60.0}, {60.0, -7.2, 60.0}},
};
static const dyn_probe_object dyn_probe_objects_0[] = {
    {"front", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_0_0},
    {"back", 0, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_0_1},
    {"left", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_0_2},
    {"right", 0, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_0_3},
    {"floor", 0, 0.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_0_4},
    {"roof", 0, 0.0, 0, 0, {0.2, 0.8, 0.8}, 1, dyn_probe_parts_0_5},
    {"jet", DYN_PROBE_TARGET, 1.0, 0, 0, {0.95, 0.55, 0.15}, 1, dyn_probe_parts_0_6},
    {"crate", 0, 0.0, 0, 0, {0.55, 0.35, 0.2}, 1, dyn_probe_parts_0_7},
    {"ground", DYN_PROBE_BACKDROP, 0.0, 0, 0, {0.6, 0.9, 0.5}, 1, dyn_probe_parts_0_8},
};
/* scene 1: figure 1, the building one hollow object. As before; the faces of a hollow object act each on its own. */
static const dyn_probe_part dyn_probe_parts_1_0[] = {
    {DYN_PROBE_RECTANGLE, {-6.0, -3.0, 10.0}, {6.0, 3.0, 10.0}},
    {DYN_PROBE_RECTANGLE, {-6.0, -3.0, 20.0}, {6.0, 3.0, 20.0}},
    {DYN_PROBE_RECTANGLE, {-6.0, -3.0, 10.0}, {-6.0, 3.0, 20.0}},
    {DYN_PROBE_RECTANGLE, {6.0, -3.0, 10.0}, {6.0, 3.0, 20.0}},
    {DYN_PROBE_RECTANGLE, {-6.0, -3.0, 10.0}, {6.0, -3.0, 20.0}},
    {DYN_PROBE_RECTANGLE, {-6.0, 3.0, 10.0}, {6.0, 3.0, 20.0}},
};
static const dyn_probe_part dyn_probe_parts_1_1[] = {
    {DYN_PROBE_RECTANGLE, {-3.0, -1.5, 15.0}, {3.0, 0.0, 15.0}},
};
static const dyn_probe_part dyn_probe_parts_1_2[] = {
    {DYN_PROBE_RECTANGLE, {3.6, -2.7, 18.0}, {5.4, -0.9, 18.0}},
};
static const dyn_probe_part dyn_probe_parts_1_3[] = {
    {DYN_PROBE_RECTANGLE, {-60.0, -60.0, 60.0}, {60.0, -7.2, 60.0}},
};
static const dyn_probe_object dyn_probe_objects_1[] = {
    {"building", DYN_PROBE_HOLLOW, 0.0, 0, 0, {0.9, 0.2, 0.2}, 6, dyn_probe_parts_1_0},
    {"jet", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_1_1},
    {"crate", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_1_2},
    {"ground", DYN_PROBE_BACKDROP, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_1_3},
};
/* scene 2: figure 1, the building one solid object. Solid: only the front-most surface of the object is ever seen. */
static const dyn_probe_part dyn_probe_parts_2_0[] = {
    {DYN_PROBE_RECTANGLE, {-6.0, -3.0, 10.0}, {6.0, 3.0, 10.0}},
    {DYN_PROBE_RECTANGLE, {-6.0, -3.0, 20.0}, {6.0, 3.0, 20.0}},
    {DYN_PROBE_RECTANGLE, {-6.0, -3.0, 10.0}, {-6.0, 3.0, 20.0}},
    {DYN_PROBE_RECTANGLE, {6.0, -3.0, 10.0}, {6.0, 3.0, 20.0}},
    {DYN_PROBE_RECTANGLE, {-6.0, -3.0, 10.0}, {6.0, -3.0, 20.0}},
    {DYN_PROBE_RECTANGLE, {-6.0, 3.0, 10.0}, {6.0, 3.0, 20.0}},
};
static const dyn_probe_part dyn_probe_parts_2_1[] = {
    {DYN_PROBE_RECTANGLE, {-3.0, -1.5, 15.0}, {3.0, 0.0, 15.0}},
};
static const dyn_probe_part dyn_probe_parts_2_2[] = {
    {DYN_PROBE_RECTANGLE, {3.6, -2.7, 18.0}, {5.4, -0.9, 18.0}},
};
static const dyn_probe_part dyn_probe_parts_2_3[] = {
    {DYN_PROBE_RECTANGLE, {-60.0, -60.0, 60.0}, {60.0, -7.2, 60.0}},
};
static const dyn_probe_object dyn_probe_objects_2[] = {
    {"building", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 6, dyn_probe_parts_2_0},
    {"jet", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_2_1},
    {"crate", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_2_2},
    {"ground", DYN_PROBE_BACKDROP, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_2_3},
};
/* scene 3: figure 2, an L-shaped target behind a wall. Sign before the wall, post behind the target. */
static const dyn_probe_part dyn_probe_parts_3_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 5.0}, {120.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_3_1[] = {
    {DYN_PROBE_RECTANGLE, {52.0, 40.0, 10.0}, {76.0, 56.0, 10.0}},
    {DYN_PROBE_RECTANGLE, {52.0, 56.0, 10.0}, {60.0, 72.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_3_2[] = {
    {DYN_PROBE_RECTANGLE, {84.0, 4.0, 20.0}, {92.0, 92.0, 20.0}},
};
static const dyn_probe_part dyn_probe_parts_3_3[] = {
    {DYN_PROBE_RECTANGLE, {30.0, 20.0, 3.0}, {44.0, 60.0, 3.0}},
};
static const dyn_probe_object dyn_probe_objects_3[] = {
    {"wall", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_3_0},
    {"target", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.7, 0.3}, 2, dyn_probe_parts_3_1},
    {"post", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_3_2},
    {"sign", 0, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_3_3},
};
/* scene 4: figure 5, first-person view of rooms. Wall 1 at 8 with a door on pixels 70..90, wall 2 at 20 with a door on 120..125; A 40..60 x 45..65, B 120..130 x 55..65, C 50..60 x 30..45, D 62..68 x 50..60, E 75..85 x 50..58, H 4..18 x 50..64, cabinet 10..26 x 44..60. */
static const dyn_probe_part dyn_probe_parts_4_0[] = {
    {DYN_PROBE_RECTANGLE, {-8.0, -2.0, 8.0}, {-0.8, 2.0, 8.0}},
    {DYN_PROBE_RECTANGLE, {0.8, -2.0, 8.0}, {8.0, 2.0, 8.0}},
};
static const dyn_probe_part dyn_probe_parts_4_1[] = {
    {DYN_PROBE_RECTANGLE, {-20.0, -2.0, 20.0}, {8.0, 2.0, 20.0}},
    {DYN_PROBE_RECTANGLE, {9.0, -2.0, 20.0}, {20.0, 2.0, 20.0}},
};
static const dyn_probe_part dyn_probe_parts_4_2[] = {
    {DYN_PROBE_RECTANGLE, {-40.0, -2.0, 40.0}, {40.0, 2.0, 40.0}},
};
static const dyn_probe_part dyn_probe_parts_4_3[] = {
    {DYN_PROBE_RECTANGLE, {-40.0, -2.0, 1.0}, {40.0, -2.0, 40.0}},
};
static const dyn_probe_part dyn_probe_parts_4_4[] = {
    {DYN_PROBE_RECTANGLE, {-40.0, 2.0, 1.0}, {40.0, 2.0, 40.0}},
};
static const dyn_probe_part dyn_probe_parts_4_5[] = {
    {DYN_PROBE_RECTANGLE, {-4.0, -1.5, 10.0}, {-2.0, 0.5, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_4_6[] = {
    {DYN_PROBE_RECTANGLE, {10.0, -1.25, 25.0}, {12.5, 1.25, 25.0}},
};
static const dyn_probe_part dyn_probe_parts_4_7[] = {
    {DYN_PROBE_RECTANGLE, {-1.5, -1.5, 5.0}, {-1.0, -0.75, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_4_8[] = {
    {DYN_PROBE_RECTANGLE, {-2.16, -1.2, 12.0}, {-1.44, 0.0, 12.0}},
};
static const dyn_probe_part dyn_probe_parts_4_9[] = {
    {DYN_PROBE_RECTANGLE, {-0.75, -1.5, 15.0}, {0.75, -0.3, 15.0}},
};
static const dyn_probe_part dyn_probe_parts_4_10[] = {
    {DYN_PROBE_RECTANGLE, {-10.64, -1.4, 14.0}, {-8.68, 0.56, 14.0}},
};
static const dyn_probe_part dyn_probe_parts_4_11[] = {
    {DYN_PROBE_RECTANGLE, {-6.3, -1.44, 9.0}, {-4.86, 0.0, 9.0}},
};
static const dyn_probe_object dyn_probe_objects_4[] = {
    {"wall 1", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 2, dyn_probe_parts_4_0},
    {"wall 2", 0, 0.0, 0, 0, {0.2, 0.7, 0.3}, 2, dyn_probe_parts_4_1},
    {"far wall", DYN_PROBE_BACKDROP, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_4_2},
    {"floor", DYN_PROBE_BACKDROP, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_4_3},
    {"ceiling", DYN_PROBE_BACKDROP, 0.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_4_4},
    {"A", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.8, 0.8}, 1, dyn_probe_parts_4_5},
    {"B", DYN_PROBE_TARGET, 1.0, 0, 0, {0.95, 0.55, 0.15}, 1, dyn_probe_parts_4_6},
    {"C", DYN_PROBE_TARGET, 1.0, 0, 0, {0.55, 0.35, 0.2}, 1, dyn_probe_parts_4_7},
    {"D", 0, 0.0, 0, 0, {0.6, 0.9, 0.5}, 1, dyn_probe_parts_4_8},
    {"E", DYN_PROBE_TARGET, 1.0, 0, 0, {0.95, 0.6, 0.75}, 1, dyn_probe_parts_4_9},
    {"H", DYN_PROBE_TARGET, 1.0, 0, 0, {0.45, 0.45, 0.75}, 1, dyn_probe_parts_4_10},
    {"cabinet", DYN_PROBE_IMPENETRABLE, 0.0, 0, 0, {0.35, 0.55, 0.45}, 1, dyn_probe_parts_4_11},
};
/* scene 5: figure 6, a tank under the trees, seen from above. The wreck is no target; the gunner stands on the tank. */
static const dyn_probe_part dyn_probe_parts_5_0[] = {
    {DYN_PROBE_RECTANGLE, {0.0, 0.0, 100.0}, {160.0, 120.0, 100.0}},
};
static const dyn_probe_part dyn_probe_parts_5_1[] = {
    {DYN_PROBE_SPHERE, {50.0, 60.0, 40.0}, {20.0, 0.0, 0.0}},
};
static const dyn_probe_part dyn_probe_parts_5_2[] = {
    {DYN_PROBE_RECTANGLE, {60.0, 50.0, 30.0}, {90.0, 80.0, 30.0}},
};
static const dyn_probe_part dyn_probe_parts_5_3[] = {
    {DYN_PROBE_RECTANGLE, {80.0, 40.0, 20.0}, {110.0, 70.0, 20.0}},
};
static const dyn_probe_part dyn_probe_parts_5_4[] = {
    {DYN_PROBE_RECTANGLE, {44.0, 56.0, 60.0}, {84.0, 68.0, 60.0}},
};
static const dyn_probe_part dyn_probe_parts_5_5[] = {
    {DYN_PROBE_RECTANGLE, {70.0, 60.0, 55.0}, {76.0, 66.0, 55.0}},
};
static const dyn_probe_part dyn_probe_parts_5_6[] = {
    {DYN_PROBE_RECTANGLE, {100.0, 58.0, 62.0}, {106.0, 66.0, 62.0}},
};
static const dyn_probe_part dyn_probe_parts_5_7[] = {
    {DYN_PROBE_RECTANGLE, {20.0, 90.0, 60.0}, {40.0, 100.0, 60.0}},
};
static const dyn_probe_part dyn_probe_parts_5_8[] = {
    {DYN_PROBE_RECTANGLE, {14.0, 86.0, 30.0}, {46.0, 104.0, 30.0}},
};
static const dyn_probe_part dyn_probe_parts_5_9[] = {
    {DYN_PROBE_RECTANGLE, {120.0, 90.0, 60.0}, {140.0, 100.0, 60.0}},
};
static const dyn_probe_part dyn_probe_parts_5_10[] = {
    {DYN_PROBE_RECTANGLE, {136.0, 26.0, 60.0}, {156.0, 36.0, 60.0}},
};
static const dyn_probe_part dyn_probe_parts_5_11[] = {
    {DYN_PROBE_RECTANGLE, {130.0, 20.0, 25.0}, {146.0, 32.0, 25.0}},
};
static const dyn_probe_part dyn_probe_parts_5_12[] = {
    {DYN_PROBE_RECTANGLE, {128.0, 12.0, 15.0}, {158.0, 46.0, 15.0}},
};
static const dyn_probe_object dyn_probe_objects_5[] = {
    {"ground", DYN_PROBE_BACKDROP, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_5_0},
    {"tree1", 0, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_5_1},
    {"tree2", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_5_2},
    {"tree3", 0, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_5_3},
    {"tank", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_5_4},
    {"gunner", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.8, 0.8}, 1, dyn_probe_parts_5_5},
    {"soldier", DYN_PROBE_TARGET, 1.0, 0, 0, {0.95, 0.55, 0.15}, 1, dyn_probe_parts_5_6},
    {"wreck", 0, 0.0, 0, 0, {0.55, 0.35, 0.2}, 1, dyn_probe_parts_5_7},
    {"tree4", 0, 0.0, 0, 0, {0.6, 0.9, 0.5}, 1, dyn_probe_parts_5_8},
    {"scout", DYN_PROBE_TARGET, 1.0, 0, 0, {0.95, 0.6, 0.75}, 1, dyn_probe_parts_5_9},
    {"mortar", DYN_PROBE_TARGET, 1.0, 0, 0, {0.45, 0.45, 0.75}, 1, dyn_probe_parts_5_10},
    {"bunker", DYN_PROBE_IMPENETRABLE, 0.0, 0, 0, {0.35, 0.55, 0.45}, 1, dyn_probe_parts_5_11},
    {"tree5", 0, 0.0, 0, 0, {0.8, 0.8, 0.85}, 1, dyn_probe_parts_5_12},
};
/* scene 6: R1, targets behind one, two, three and four walls. */
static const dyn_probe_part dyn_probe_parts_6_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 2.0}, {120.0, 88.0, 2.0}},
};
static const dyn_probe_part dyn_probe_parts_6_1[] = {
    {DYN_PROBE_RECTANGLE, {40.0, 8.0, 3.0}, {120.0, 88.0, 3.0}},
};
static const dyn_probe_part dyn_probe_parts_6_2[] = {
    {DYN_PROBE_RECTANGLE, {72.0, 8.0, 4.0}, {120.0, 88.0, 4.0}},
};
static const dyn_probe_part dyn_probe_parts_6_3[] = {
    {DYN_PROBE_RECTANGLE, {96.0, 8.0, 5.0}, {120.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_6_4[] = {
    {DYN_PROBE_RECTANGLE, {16.0, 40.0, 10.0}, {28.0, 52.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_6_5[] = {
    {DYN_PROBE_RECTANGLE, {50.0, 40.0, 10.0}, {62.0, 52.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_6_6[] = {
    {DYN_PROBE_RECTANGLE, {78.0, 40.0, 10.0}, {88.0, 52.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_6_7[] = {
    {DYN_PROBE_RECTANGLE, {102.0, 40.0, 10.0}, {114.0, 52.0, 10.0}},
};
static const dyn_probe_object dyn_probe_objects_6[] = {
    {"W1", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_6_0},
    {"W2", 0, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_6_1},
    {"W3", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_6_2},
    {"W4", 0, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_6_3},
    {"Ta", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_6_4},
    {"Tb", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.8, 0.8}, 1, dyn_probe_parts_6_5},
    {"Tc", DYN_PROBE_TARGET, 1.0, 0, 0, {0.95, 0.55, 0.15}, 1, dyn_probe_parts_6_6},
    {"Td", DYN_PROBE_TARGET, 1.0, 0, 0, {0.55, 0.35, 0.2}, 1, dyn_probe_parts_6_7},
};
/* scene 7: R2, occluders of a half-hidden target. B lies behind the target. */
static const dyn_probe_part dyn_probe_parts_7_0[] = {
    {DYN_PROBE_RECTANGLE, {40.0, 8.0, 5.0}, {120.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_7_1[] = {
    {DYN_PROBE_RECTANGLE, {48.0, 20.0, 8.0}, {72.0, 52.0, 8.0}},
};
static const dyn_probe_part dyn_probe_parts_7_2[] = {
    {DYN_PROBE_RECTANGLE, {24.0, 40.0, 10.0}, {56.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_7_3[] = {
    {DYN_PROBE_RECTANGLE, {20.0, 36.0, 15.0}, {100.0, 60.0, 15.0}},
};
static const dyn_probe_part dyn_probe_parts_7_4[] = {
    {DYN_PROBE_RECTANGLE, {60.0, 60.0, 3.0}, {80.0, 80.0, 3.0}},
};
static const dyn_probe_object dyn_probe_objects_7[] = {
    {"W", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_7_0},
    {"E", 0, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_7_1},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_7_2},
    {"B", 0, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_7_3},
    {"F", 0, 0.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_7_4},
};
/* scene 8: R3, impenetrable surfaces before, between and behind. */
static const dyn_probe_part dyn_probe_parts_8_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 4.0}, {120.0, 88.0, 4.0}},
};
static const dyn_probe_part dyn_probe_parts_8_1[] = {
    {DYN_PROBE_RECTANGLE, {30.0, 20.0, 6.0}, {60.0, 76.0, 6.0}},
};
static const dyn_probe_part dyn_probe_parts_8_2[] = {
    {DYN_PROBE_RECTANGLE, {90.0, 6.0, 2.0}, {100.0, 90.0, 2.0}},
};
static const dyn_probe_part dyn_probe_parts_8_3[] = {
    {DYN_PROBE_RECTANGLE, {64.0, 30.0, 14.0}, {72.0, 66.0, 14.0}},
};
static const dyn_probe_part dyn_probe_parts_8_4[] = {
    {DYN_PROBE_RECTANGLE, {44.0, 40.0, 10.0}, {80.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_8_5[] = {
    {DYN_PROBE_RECTANGLE, {94.0, 20.0, 10.0}, {112.0, 32.0, 10.0}},
};
static const dyn_probe_object dyn_probe_objects_8[] = {
    {"W", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_8_0},
    {"I1", DYN_PROBE_IMPENETRABLE, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_8_1},
    {"I2", DYN_PROBE_IMPENETRABLE, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_8_2},
    {"I3", DYN_PROBE_IMPENETRABLE, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_8_3},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_8_4},
    {"T2", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.8, 0.8}, 1, dyn_probe_parts_8_5},
};
/* scene 9: R3, an impenetrable target. */
static const dyn_probe_part dyn_probe_parts_9_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 4.0}, {120.0, 88.0, 4.0}},
};
static const dyn_probe_part dyn_probe_parts_9_1[] = {
    {DYN_PROBE_RECTANGLE, {20.0, 30.0, 6.0}, {50.0, 60.0, 6.0}},
};
static const dyn_probe_part dyn_probe_parts_9_2[] = {
    {DYN_PROBE_RECTANGLE, {40.0, 40.0, 10.0}, {80.0, 70.0, 10.0}},
};
static const dyn_probe_object dyn_probe_objects_9[] = {
    {"W", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_9_0},
    {"TI", DYN_PROBE_TARGET | DYN_PROBE_IMPENETRABLE, 1.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_9_1},
    {"T2", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_9_2},
};
/* scene 10: R4, parts of one object before each other. */
static const dyn_probe_part dyn_probe_parts_10_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 3.0}, {120.0, 88.0, 3.0}},
};
static const dyn_probe_part dyn_probe_parts_10_1[] = {
    {DYN_PROBE_RECTANGLE, {20.0, 30.0, 10.0}, {60.0, 60.0, 10.0}},
    {DYN_PROBE_RECTANGLE, {40.0, 40.0, 6.0}, {50.0, 80.0, 6.0}},
};
static const dyn_probe_part dyn_probe_parts_10_2[] = {
    {DYN_PROBE_RECTANGLE, {66.0, 14.0, 5.0}, {76.0, 84.0, 5.0}},
    {DYN_PROBE_RECTANGLE, {66.0, 14.0, 7.0}, {76.0, 84.0, 7.0}},
};
static const dyn_probe_part dyn_probe_parts_10_3[] = {
    {DYN_PROBE_RECTANGLE, {64.0, 44.0, 10.0}, {80.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_10_4[] = {
    {DYN_PROBE_SPHERE, {104.0, 50.0, 24.0}, {10.0, 0.0, 0.0}},
};
static const dyn_probe_object dyn_probe_objects_10[] = {
    {"W", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_10_0},
    {"U", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.7, 0.3}, 2, dyn_probe_parts_10_1},
    {"D", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 2, dyn_probe_parts_10_2},
    {"T3", DYN_PROBE_TARGET, 1.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_10_3},
    {"ball", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_10_4},
};
/* scene 11: R4, a target inside a solid box. */
static const dyn_probe_part dyn_probe_parts_11_0[] = {
    {DYN_PROBE_BOX, {20.0, 20.0, 4.0}, {100.0, 80.0, 16.0}},
};
static const dyn_probe_part dyn_probe_parts_11_1[] = {
    {DYN_PROBE_RECTANGLE, {50.0, 40.0, 10.0}, {70.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_11_2[] = {
    {DYN_PROBE_RECTANGLE, {10.0, 30.0, 20.0}, {110.0, 70.0, 20.0}},
};
static const dyn_probe_object dyn_probe_objects_11[] = {
    {"box", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_11_0},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_11_1},
    {"L", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_11_2},
};
/* scene 12: R4, a distractor between two parts of a target. */
static const dyn_probe_part dyn_probe_parts_12_0[] = {
    {DYN_PROBE_RECTANGLE, {30.0, 30.0, 4.0}, {50.0, 70.0, 4.0}},
    {DYN_PROBE_RECTANGLE, {30.0, 40.0, 10.0}, {90.0, 60.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_12_1[] = {
    {DYN_PROBE_RECTANGLE, {40.0, 20.0, 7.0}, {70.0, 80.0, 7.0}},
};
static const dyn_probe_object dyn_probe_objects_12[] = {
    {"U", DYN_PROBE_TARGET, 1.0, 0, 0, {0.9, 0.2, 0.2}, 2, dyn_probe_parts_12_0},
    {"D", 0, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_12_1},
};
/* scene 13: layers = 1, each. Three walls before x < 40, four from there on; B behind the target is not counted. */
static const dyn_probe_part dyn_probe_parts_13_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 2.0}, {120.0, 88.0, 2.0}},
};
static const dyn_probe_part dyn_probe_parts_13_1[] = {
    {DYN_PROBE_RECTANGLE, {12.0, 12.0, 3.0}, {116.0, 84.0, 3.0}},
};
static const dyn_probe_part dyn_probe_parts_13_2[] = {
    {DYN_PROBE_RECTANGLE, {16.0, 16.0, 4.0}, {112.0, 80.0, 4.0}},
};
static const dyn_probe_part dyn_probe_parts_13_3[] = {
    {DYN_PROBE_RECTANGLE, {40.0, 20.0, 5.0}, {108.0, 76.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_13_4[] = {
    {DYN_PROBE_RECTANGLE, {30.0, 40.0, 10.0}, {60.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_13_5[] = {
    {DYN_PROBE_RECTANGLE, {6.0, 30.0, 12.0}, {70.0, 62.0, 12.0}},
};
static const dyn_probe_object dyn_probe_objects_13[] = {
    {"W1", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_13_0},
    {"W2", 0, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_13_1},
    {"W3", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_13_2},
    {"W4", 0, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_13_3},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_13_4},
    {"B", 0, 0.0, 0, 0, {0.2, 0.8, 0.8}, 1, dyn_probe_parts_13_5},
};
/* scene 14: layers = 2, each. Three walls before x < 40, four from there on; B behind the target is not counted. */
static const dyn_probe_part dyn_probe_parts_14_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 2.0}, {120.0, 88.0, 2.0}},
};
static const dyn_probe_part dyn_probe_parts_14_1[] = {
    {DYN_PROBE_RECTANGLE, {12.0, 12.0, 3.0}, {116.0, 84.0, 3.0}},
};
static const dyn_probe_part dyn_probe_parts_14_2[] = {
    {DYN_PROBE_RECTANGLE, {16.0, 16.0, 4.0}, {112.0, 80.0, 4.0}},
};
static const dyn_probe_part dyn_probe_parts_14_3[] = {
    {DYN_PROBE_RECTANGLE, {40.0, 20.0, 5.0}, {108.0, 76.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_14_4[] = {
    {DYN_PROBE_RECTANGLE, {30.0, 40.0, 10.0}, {60.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_14_5[] = {
    {DYN_PROBE_RECTANGLE, {6.0, 30.0, 12.0}, {70.0, 62.0, 12.0}},
};
static const dyn_probe_object dyn_probe_objects_14[] = {
    {"W1", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_14_0},
    {"W2", 0, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_14_1},
    {"W3", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_14_2},
    {"W4", 0, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_14_3},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_14_4},
    {"B", 0, 0.0, 0, 0, {0.2, 0.8, 0.8}, 1, dyn_probe_parts_14_5},
};
/* scene 15: layers = 3, each. Three walls before x < 40, four from there on; B behind the target is not counted. */
static const dyn_probe_part dyn_probe_parts_15_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 2.0}, {120.0, 88.0, 2.0}},
};
static const dyn_probe_part dyn_probe_parts_15_1[] = {
    {DYN_PROBE_RECTANGLE, {12.0, 12.0, 3.0}, {116.0, 84.0, 3.0}},
};
static const dyn_probe_part dyn_probe_parts_15_2[] = {
    {DYN_PROBE_RECTANGLE, {16.0, 16.0, 4.0}, {112.0, 80.0, 4.0}},
};
static const dyn_probe_part dyn_probe_parts_15_3[] = {
    {DYN_PROBE_RECTANGLE, {40.0, 20.0, 5.0}, {108.0, 76.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_15_4[] = {
    {DYN_PROBE_RECTANGLE, {30.0, 40.0, 10.0}, {60.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_15_5[] = {
    {DYN_PROBE_RECTANGLE, {6.0, 30.0, 12.0}, {70.0, 62.0, 12.0}},
};
static const dyn_probe_object dyn_probe_objects_15[] = {
    {"W1", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_15_0},
    {"W2", 0, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_15_1},
    {"W3", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_15_2},
    {"W4", 0, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_15_3},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_15_4},
    {"B", 0, 0.0, 0, 0, {0.2, 0.8, 0.8}, 1, dyn_probe_parts_15_5},
};
/* scene 16: layers = 2, together. Three walls before x < 40, four from there on; B behind the target is not counted. */
static const dyn_probe_part dyn_probe_parts_16_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 2.0}, {120.0, 88.0, 2.0}},
};
static const dyn_probe_part dyn_probe_parts_16_1[] = {
    {DYN_PROBE_RECTANGLE, {12.0, 12.0, 3.0}, {116.0, 84.0, 3.0}},
};
static const dyn_probe_part dyn_probe_parts_16_2[] = {
    {DYN_PROBE_RECTANGLE, {16.0, 16.0, 4.0}, {112.0, 80.0, 4.0}},
};
static const dyn_probe_part dyn_probe_parts_16_3[] = {
    {DYN_PROBE_RECTANGLE, {40.0, 20.0, 5.0}, {108.0, 76.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_16_4[] = {
    {DYN_PROBE_RECTANGLE, {30.0, 40.0, 10.0}, {60.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_16_5[] = {
    {DYN_PROBE_RECTANGLE, {6.0, 30.0, 12.0}, {70.0, 62.0, 12.0}},
};
static const dyn_probe_object dyn_probe_objects_16[] = {
    {"W1", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_16_0},
    {"W2", 0, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_16_1},
    {"W3", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_16_2},
    {"W4", 0, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_16_3},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_16_4},
    {"B", 0, 0.0, 0, 0, {0.2, 0.8, 0.8}, 1, dyn_probe_parts_16_5},
};
/* scene 17: layers = 3, together. Three walls before x < 40, four from there on; B behind the target is not counted. */
static const dyn_probe_part dyn_probe_parts_17_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 2.0}, {120.0, 88.0, 2.0}},
};
static const dyn_probe_part dyn_probe_parts_17_1[] = {
    {DYN_PROBE_RECTANGLE, {12.0, 12.0, 3.0}, {116.0, 84.0, 3.0}},
};
static const dyn_probe_part dyn_probe_parts_17_2[] = {
    {DYN_PROBE_RECTANGLE, {16.0, 16.0, 4.0}, {112.0, 80.0, 4.0}},
};
static const dyn_probe_part dyn_probe_parts_17_3[] = {
    {DYN_PROBE_RECTANGLE, {40.0, 20.0, 5.0}, {108.0, 76.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_17_4[] = {
    {DYN_PROBE_RECTANGLE, {30.0, 40.0, 10.0}, {60.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_17_5[] = {
    {DYN_PROBE_RECTANGLE, {6.0, 30.0, 12.0}, {70.0, 62.0, 12.0}},
};
static const dyn_probe_object dyn_probe_objects_17[] = {
    {"W1", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_17_0},
    {"W2", 0, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_17_1},
    {"W3", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_17_2},
    {"W4", 0, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_17_3},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_17_4},
    {"B", 0, 0.0, 0, 0, {0.2, 0.8, 0.8}, 1, dyn_probe_parts_17_5},
};
/* scene 18: layers = 4, together. Three walls before x < 40, four from there on; B behind the target is not counted. */
static const dyn_probe_part dyn_probe_parts_18_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 2.0}, {120.0, 88.0, 2.0}},
};
static const dyn_probe_part dyn_probe_parts_18_1[] = {
    {DYN_PROBE_RECTANGLE, {12.0, 12.0, 3.0}, {116.0, 84.0, 3.0}},
};
static const dyn_probe_part dyn_probe_parts_18_2[] = {
    {DYN_PROBE_RECTANGLE, {16.0, 16.0, 4.0}, {112.0, 80.0, 4.0}},
};
static const dyn_probe_part dyn_probe_parts_18_3[] = {
    {DYN_PROBE_RECTANGLE, {40.0, 20.0, 5.0}, {108.0, 76.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_18_4[] = {
    {DYN_PROBE_RECTANGLE, {30.0, 40.0, 10.0}, {60.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_18_5[] = {
    {DYN_PROBE_RECTANGLE, {6.0, 30.0, 12.0}, {70.0, 62.0, 12.0}},
};
static const dyn_probe_object dyn_probe_objects_18[] = {
    {"W1", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_18_0},
    {"W2", 0, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_18_1},
    {"W3", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_18_2},
    {"W4", 0, 0.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_18_3},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_18_4},
    {"B", 0, 0.0, 0, 0, {0.2, 0.8, 0.8}, 1, dyn_probe_parts_18_5},
};
/* scene 19: importance, together. Importances A 0, B 0.25, C 0.5, D 0.8, E 1, F 0.5, H 0, T1 1, T2 0.6. */
static const dyn_probe_part dyn_probe_parts_19_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 5.0}, {26.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_19_1[] = {
    {DYN_PROBE_RECTANGLE, {28.0, 8.0, 5.0}, {46.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_19_2[] = {
    {DYN_PROBE_RECTANGLE, {48.0, 8.0, 5.0}, {66.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_19_3[] = {
    {DYN_PROBE_RECTANGLE, {68.0, 8.0, 5.0}, {86.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_19_4[] = {
    {DYN_PROBE_RECTANGLE, {88.0, 8.0, 5.0}, {106.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_19_5[] = {
    {DYN_PROBE_RECTANGLE, {34.0, 50.0, 3.0}, {64.0, 74.0, 3.0}},
};
static const dyn_probe_part dyn_probe_parts_19_6[] = {
    {DYN_PROBE_RECTANGLE, {70.0, 14.0, 3.0}, {80.0, 38.0, 3.0}},
};
static const dyn_probe_part dyn_probe_parts_19_7[] = {
    {DYN_PROBE_RECTANGLE, {4.0, 56.0, 10.0}, {110.0, 68.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_19_8[] = {
    {DYN_PROBE_RECTANGLE, {4.0, 20.0, 10.0}, {110.0, 32.0, 10.0}},
};
static const dyn_probe_object dyn_probe_objects_19[] = {
    {"A", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_19_0},
    {"B", 0, 0.25, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_19_1},
    {"C", 0, 0.5, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_19_2},
    {"D", 0, 0.8, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_19_3},
    {"E", 0, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_19_4},
    {"F", 0, 0.5, 0, 0, {0.2, 0.8, 0.8}, 1, dyn_probe_parts_19_5},
    {"H", 0, 0.0, 0, 0, {0.95, 0.55, 0.15}, 1, dyn_probe_parts_19_6},
    {"T1", DYN_PROBE_TARGET, 1.0, 0, 0, {0.55, 0.35, 0.2}, 1, dyn_probe_parts_19_7},
    {"T2", DYN_PROBE_TARGET, 0.6, 0, 0, {0.6, 0.9, 0.5}, 1, dyn_probe_parts_19_8},
};
/* scene 20: importance, each. Importances A 0, B 0.25, C 0.5, D 0.8, E 1, F 0.5, H 0, T1 1, T2 0.6. */
static const dyn_probe_part dyn_probe_parts_20_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 5.0}, {26.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_20_1[] = {
    {DYN_PROBE_RECTANGLE, {28.0, 8.0, 5.0}, {46.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_20_2[] = {
    {DYN_PROBE_RECTANGLE, {48.0, 8.0, 5.0}, {66.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_20_3[] = {
    {DYN_PROBE_RECTANGLE, {68.0, 8.0, 5.0}, {86.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_20_4[] = {
    {DYN_PROBE_RECTANGLE, {88.0, 8.0, 5.0}, {106.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_20_5[] = {
    {DYN_PROBE_RECTANGLE, {34.0, 50.0, 3.0}, {64.0, 74.0, 3.0}},
};
static const dyn_probe_part dyn_probe_parts_20_6[] = {
    {DYN_PROBE_RECTANGLE, {70.0, 14.0, 3.0}, {80.0, 38.0, 3.0}},
};
static const dyn_probe_part dyn_probe_parts_20_7[] = {
    {DYN_PROBE_RECTANGLE, {4.0, 56.0, 10.0}, {110.0, 68.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_20_8[] = {
    {DYN_PROBE_RECTANGLE, {4.0, 20.0, 10.0}, {110.0, 32.0, 10.0}},
};
static const dyn_probe_object dyn_probe_objects_20[] = {
    {"A", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_20_0},
    {"B", 0, 0.25, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_20_1},
    {"C", 0, 0.5, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_20_2},
    {"D", 0, 0.8, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_20_3},
    {"E", 0, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_20_4},
    {"F", 0, 0.5, 0, 0, {0.2, 0.8, 0.8}, 1, dyn_probe_parts_20_5},
    {"H", 0, 0.0, 0, 0, {0.95, 0.55, 0.15}, 1, dyn_probe_parts_20_6},
    {"T1", DYN_PROBE_TARGET, 1.0, 0, 0, {0.55, 0.35, 0.2}, 1, dyn_probe_parts_20_7},
    {"T2", DYN_PROBE_TARGET, 0.6, 0, 0, {0.6, 0.9, 0.5}, 1, dyn_probe_parts_20_8},
};
/* scene 21: combine = min, occluders = together. Four targets behind one wall, each larger and farther than the one before. */
static const dyn_probe_part dyn_probe_parts_21_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 2.0}, {120.0, 88.0, 2.0}},
};
static const dyn_probe_part dyn_probe_parts_21_1[] = {
    {DYN_PROBE_RECTANGLE, {50.0, 40.0, 10.0}, {60.0, 50.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_21_2[] = {
    {DYN_PROBE_RECTANGLE, {44.0, 36.0, 12.0}, {66.0, 56.0, 12.0}},
};
static const dyn_probe_part dyn_probe_parts_21_3[] = {
    {DYN_PROBE_RECTANGLE, {38.0, 30.0, 14.0}, {72.0, 62.0, 14.0}},
};
static const dyn_probe_part dyn_probe_parts_21_4[] = {
    {DYN_PROBE_RECTANGLE, {30.0, 24.0, 16.0}, {80.0, 70.0, 16.0}},
};
static const dyn_probe_object dyn_probe_objects_21[] = {
    {"W", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_21_0},
    {"T1", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_21_1},
    {"T2", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_21_2},
    {"T3", DYN_PROBE_TARGET, 1.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_21_3},
    {"T4", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_21_4},
};
/* scene 22: combine = min, occluders = each. Four targets behind one wall, each larger and farther than the one before. */
static const dyn_probe_part dyn_probe_parts_22_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 2.0}, {120.0, 88.0, 2.0}},
};
static const dyn_probe_part dyn_probe_parts_22_1[] = {
    {DYN_PROBE_RECTANGLE, {50.0, 40.0, 10.0}, {60.0, 50.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_22_2[] = {
    {DYN_PROBE_RECTANGLE, {44.0, 36.0, 12.0}, {66.0, 56.0, 12.0}},
};
static const dyn_probe_part dyn_probe_parts_22_3[] = {
    {DYN_PROBE_RECTANGLE, {38.0, 30.0, 14.0}, {72.0, 62.0, 14.0}},
};
static const dyn_probe_part dyn_probe_parts_22_4[] = {
    {DYN_PROBE_RECTANGLE, {30.0, 24.0, 16.0}, {80.0, 70.0, 16.0}},
};
static const dyn_probe_object dyn_probe_objects_22[] = {
    {"W", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_22_0},
    {"T1", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_22_1},
    {"T2", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_22_2},
    {"T3", DYN_PROBE_TARGET, 1.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_22_3},
    {"T4", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_22_4},
};
/* scene 23: combine = product, occluders = each. Four targets behind one wall, each larger and farther than the one before. */
static const dyn_probe_part dyn_probe_parts_23_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 2.0}, {120.0, 88.0, 2.0}},
};
static const dyn_probe_part dyn_probe_parts_23_1[] = {
    {DYN_PROBE_RECTANGLE, {50.0, 40.0, 10.0}, {60.0, 50.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_23_2[] = {
    {DYN_PROBE_RECTANGLE, {44.0, 36.0, 12.0}, {66.0, 56.0, 12.0}},
};
static const dyn_probe_part dyn_probe_parts_23_3[] = {
    {DYN_PROBE_RECTANGLE, {38.0, 30.0, 14.0}, {72.0, 62.0, 14.0}},
};
static const dyn_probe_part dyn_probe_parts_23_4[] = {
    {DYN_PROBE_RECTANGLE, {30.0, 24.0, 16.0}, {80.0, 70.0, 16.0}},
};
static const dyn_probe_object dyn_probe_objects_23[] = {
    {"W", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_23_0},
    {"T1", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_23_1},
    {"T2", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_23_2},
    {"T3", DYN_PROBE_TARGET, 1.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_23_3},
    {"T4", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_23_4},
};
/* scene 24: combine = product, occluders = together. Four targets behind one wall, each larger and farther than the one before. */
static const dyn_probe_part dyn_probe_parts_24_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 2.0}, {120.0, 88.0, 2.0}},
};
static const dyn_probe_part dyn_probe_parts_24_1[] = {
    {DYN_PROBE_RECTANGLE, {50.0, 40.0, 10.0}, {60.0, 50.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_24_2[] = {
    {DYN_PROBE_RECTANGLE, {44.0, 36.0, 12.0}, {66.0, 56.0, 12.0}},
};
static const dyn_probe_part dyn_probe_parts_24_3[] = {
    {DYN_PROBE_RECTANGLE, {38.0, 30.0, 14.0}, {72.0, 62.0, 14.0}},
};
static const dyn_probe_part dyn_probe_parts_24_4[] = {
    {DYN_PROBE_RECTANGLE, {30.0, 24.0, 16.0}, {80.0, 70.0, 16.0}},
};
static const dyn_probe_object dyn_probe_objects_24[] = {
    {"W", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_24_0},
    {"T1", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_24_1},
    {"T2", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_24_2},
    {"T3", DYN_PROBE_TARGET, 1.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_24_3},
    {"T4", DYN_PROBE_TARGET, 1.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_24_4},
};
/* scene 25: active mode: search lights. Lights are x, y, radius, width of the soft edge in pixels; T3 is passive. */
static const dyn_probe_part dyn_probe_parts_25_0[] = {
    {DYN_PROBE_RECTANGLE, {8.0, 8.0, 5.0}, {120.0, 88.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_25_1[] = {
    {DYN_PROBE_RECTANGLE, {20.0, 40.0, 10.0}, {44.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_25_2[] = {
    {DYN_PROBE_RECTANGLE, {80.0, 40.0, 10.0}, {104.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_25_3[] = {
    {DYN_PROBE_RECTANGLE, {50.0, 16.0, 10.0}, {70.0, 28.0, 10.0}},
};
static const dyn_probe_object dyn_probe_objects_25[] = {
    {"W", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_25_0},
    {"T1", DYN_PROBE_TARGET | DYN_PROBE_ACTIVE, 1.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_25_1},
    {"T2", DYN_PROBE_TARGET | DYN_PROBE_ACTIVE, 1.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_25_2},
    {"T3", DYN_PROBE_TARGET, 1.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_25_3},
};
static const dyn_probe_light dyn_probe_lights_25[] = {
    {40.0, 48.0, 12.0, 3.0},
    {96.0, 48.0, 10.0, 2.0},
    {98.0, 50.0, 8.0, 1.0},
    {64.0, 76.0, 8.0, 1.0},
};
/* scene 26: nested dolls, the innermost a target. Concentric, one group, drawn from the innermost to the outermost. */
static const dyn_probe_part dyn_probe_parts_26_0[] = {
    {DYN_PROBE_SPHERE, {40.0, 48.0, 40.0}, {30.0, 0.0, 0.0}},
};
static const dyn_probe_part dyn_probe_parts_26_1[] = {
    {DYN_PROBE_SPHERE, {40.0, 48.0, 40.0}, {20.0, 0.0, 0.0}},
};
static const dyn_probe_part dyn_probe_parts_26_2[] = {
    {DYN_PROBE_SPHERE, {40.0, 48.0, 40.0}, {10.0, 0.0, 0.0}},
};
static const dyn_probe_object dyn_probe_objects_26[] = {
    {"outer", 0, 0.0, 1, 2, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_26_0},
    {"middle", 0, 0.0, 1, 1, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_26_1},
    {"inner", DYN_PROBE_TARGET, 1.0, 1, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_26_2},
};
/* scene 27: nested dolls, the middle one a target. As before. */
static const dyn_probe_part dyn_probe_parts_27_0[] = {
    {DYN_PROBE_SPHERE, {40.0, 48.0, 40.0}, {30.0, 0.0, 0.0}},
};
static const dyn_probe_part dyn_probe_parts_27_1[] = {
    {DYN_PROBE_SPHERE, {40.0, 48.0, 40.0}, {20.0, 0.0, 0.0}},
};
static const dyn_probe_part dyn_probe_parts_27_2[] = {
    {DYN_PROBE_SPHERE, {40.0, 48.0, 40.0}, {10.0, 0.0, 0.0}},
};
static const dyn_probe_object dyn_probe_objects_27[] = {
    {"outer", 0, 0.0, 1, 2, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_27_0},
    {"middle", DYN_PROBE_TARGET, 1.0, 1, 1, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_27_1},
    {"inner", 0, 0.0, 1, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_27_2},
};
/* scene 28: nested dolls, the outermost a target. As before. */
static const dyn_probe_part dyn_probe_parts_28_0[] = {
    {DYN_PROBE_SPHERE, {40.0, 48.0, 40.0}, {30.0, 0.0, 0.0}},
};
static const dyn_probe_part dyn_probe_parts_28_1[] = {
    {DYN_PROBE_SPHERE, {40.0, 48.0, 40.0}, {20.0, 0.0, 0.0}},
};
static const dyn_probe_part dyn_probe_parts_28_2[] = {
    {DYN_PROBE_SPHERE, {40.0, 48.0, 40.0}, {10.0, 0.0, 0.0}},
};
static const dyn_probe_object dyn_probe_objects_28[] = {
    {"outer", DYN_PROBE_TARGET, 1.0, 1, 2, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_28_0},
    {"middle", 0, 0.0, 1, 1, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_28_1},
    {"inner", 0, 0.0, 1, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_28_2},
};
/* scene 29: one depth, order by rank: shell last. Both at depth 20. */
static const dyn_probe_part dyn_probe_parts_29_0[] = {
    {DYN_PROBE_RECTANGLE, {50.0, 40.0, 20.0}, {70.0, 56.0, 20.0}},
};
static const dyn_probe_part dyn_probe_parts_29_1[] = {
    {DYN_PROBE_RECTANGLE, {44.0, 34.0, 20.0}, {76.0, 62.0, 20.0}},
};
static const dyn_probe_object dyn_probe_objects_29[] = {
    {"core", DYN_PROBE_TARGET, 1.0, 1, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_29_0},
    {"shell", 0, 0.0, 1, 1, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_29_1},
};
/* scene 30: one depth, order by rank: core last. Both at depth 20. */
static const dyn_probe_part dyn_probe_parts_30_0[] = {
    {DYN_PROBE_RECTANGLE, {50.0, 40.0, 20.0}, {70.0, 56.0, 20.0}},
};
static const dyn_probe_part dyn_probe_parts_30_1[] = {
    {DYN_PROBE_RECTANGLE, {44.0, 34.0, 20.0}, {76.0, 62.0, 20.0}},
};
static const dyn_probe_object dyn_probe_objects_30[] = {
    {"core", DYN_PROBE_TARGET, 1.0, 1, 1, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_30_0},
    {"shell", 0, 0.0, 1, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_30_1},
};
/* scene 31: backdrop. */
static const dyn_probe_part dyn_probe_parts_31_0[] = {
    {DYN_PROBE_RECTANGLE, {0.0, 0.0, 90.0}, {128.0, 96.0, 90.0}},
};
static const dyn_probe_part dyn_probe_parts_31_1[] = {
    {DYN_PROBE_RECTANGLE, {0.0, 0.0, 80.0}, {128.0, 36.0, 80.0}},
};
static const dyn_probe_part dyn_probe_parts_31_2[] = {
    {DYN_PROBE_RECTANGLE, {20.0, 12.0, 5.0}, {100.0, 80.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_31_3[] = {
    {DYN_PROBE_RECTANGLE, {40.0, 44.0, 10.0}, {64.0, 60.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_31_4[] = {
    {DYN_PROBE_RECTANGLE, {70.0, 20.0, 30.0}, {80.0, 70.0, 30.0}},
};
static const dyn_probe_object dyn_probe_objects_31[] = {
    {"sky", DYN_PROBE_BACKDROP, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_31_0},
    {"hill", DYN_PROBE_BACKDROP, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_31_1},
    {"W", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_31_2},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.9, 0.8, 0.2}, 1, dyn_probe_parts_31_3},
    {"R", 0, 0.0, 0, 0, {0.7, 0.3, 0.8}, 1, dyn_probe_parts_31_4},
};
/* scene 32: backdrop is no occluder count. */
static const dyn_probe_part dyn_probe_parts_32_0[] = {
    {DYN_PROBE_RECTANGLE, {0.0, 0.0, 90.0}, {128.0, 96.0, 90.0}},
};
static const dyn_probe_part dyn_probe_parts_32_1[] = {
    {DYN_PROBE_RECTANGLE, {20.0, 12.0, 5.0}, {60.0, 80.0, 5.0}},
};
static const dyn_probe_part dyn_probe_parts_32_2[] = {
    {DYN_PROBE_RECTANGLE, {40.0, 44.0, 10.0}, {84.0, 60.0, 10.0}},
};
static const dyn_probe_object dyn_probe_objects_32[] = {
    {"sky", DYN_PROBE_BACKDROP, 0.0, 0, 0, {0.9, 0.2, 0.2}, 1, dyn_probe_parts_32_0},
    {"W", 0, 0.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_32_1},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_32_2},
};
/* scene 33: hollow sheets, occluders = together. Three sheets of one object: at 4 and 6 before, at 14 behind the target. */
static const dyn_probe_part dyn_probe_parts_33_0[] = {
    {DYN_PROBE_RECTANGLE, {20.0, 16.0, 4.0}, {100.0, 80.0, 4.0}},
    {DYN_PROBE_RECTANGLE, {24.0, 20.0, 6.0}, {96.0, 76.0, 6.0}},
    {DYN_PROBE_RECTANGLE, {28.0, 24.0, 14.0}, {92.0, 72.0, 14.0}},
};
static const dyn_probe_part dyn_probe_parts_33_1[] = {
    {DYN_PROBE_RECTANGLE, {50.0, 40.0, 10.0}, {70.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_33_2[] = {
    {DYN_PROBE_RECTANGLE, {10.0, 30.0, 20.0}, {110.0, 66.0, 20.0}},
};
static const dyn_probe_object dyn_probe_objects_33[] = {
    {"H", DYN_PROBE_HOLLOW, 0.0, 0, 0, {0.9, 0.2, 0.2}, 3, dyn_probe_parts_33_0},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_33_1},
    {"L", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_33_2},
};
/* scene 34: hollow sheets, occluders = each. Three sheets of one object: at 4 and 6 before, at 14 behind the target. */
static const dyn_probe_part dyn_probe_parts_34_0[] = {
    {DYN_PROBE_RECTANGLE, {20.0, 16.0, 4.0}, {100.0, 80.0, 4.0}},
    {DYN_PROBE_RECTANGLE, {24.0, 20.0, 6.0}, {96.0, 76.0, 6.0}},
    {DYN_PROBE_RECTANGLE, {28.0, 24.0, 14.0}, {92.0, 72.0, 14.0}},
};
static const dyn_probe_part dyn_probe_parts_34_1[] = {
    {DYN_PROBE_RECTANGLE, {50.0, 40.0, 10.0}, {70.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_34_2[] = {
    {DYN_PROBE_RECTANGLE, {10.0, 30.0, 20.0}, {110.0, 66.0, 20.0}},
};
static const dyn_probe_object dyn_probe_objects_34[] = {
    {"H", DYN_PROBE_HOLLOW, 0.0, 0, 0, {0.9, 0.2, 0.2}, 3, dyn_probe_parts_34_0},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_34_1},
    {"L", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_34_2},
};
/* scene 35: solid sheets, occluders = together. Three sheets of one object: at 4 and 6 before, at 14 behind the target. */
static const dyn_probe_part dyn_probe_parts_35_0[] = {
    {DYN_PROBE_RECTANGLE, {20.0, 16.0, 4.0}, {100.0, 80.0, 4.0}},
    {DYN_PROBE_RECTANGLE, {24.0, 20.0, 6.0}, {96.0, 76.0, 6.0}},
    {DYN_PROBE_RECTANGLE, {28.0, 24.0, 14.0}, {92.0, 72.0, 14.0}},
};
static const dyn_probe_part dyn_probe_parts_35_1[] = {
    {DYN_PROBE_RECTANGLE, {50.0, 40.0, 10.0}, {70.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_35_2[] = {
    {DYN_PROBE_RECTANGLE, {10.0, 30.0, 20.0}, {110.0, 66.0, 20.0}},
};
static const dyn_probe_object dyn_probe_objects_35[] = {
    {"H", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 3, dyn_probe_parts_35_0},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_35_1},
    {"L", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_35_2},
};
/* scene 36: solid sheets, occluders = each. Three sheets of one object: at 4 and 6 before, at 14 behind the target. */
static const dyn_probe_part dyn_probe_parts_36_0[] = {
    {DYN_PROBE_RECTANGLE, {20.0, 16.0, 4.0}, {100.0, 80.0, 4.0}},
    {DYN_PROBE_RECTANGLE, {24.0, 20.0, 6.0}, {96.0, 76.0, 6.0}},
    {DYN_PROBE_RECTANGLE, {28.0, 24.0, 14.0}, {92.0, 72.0, 14.0}},
};
static const dyn_probe_part dyn_probe_parts_36_1[] = {
    {DYN_PROBE_RECTANGLE, {50.0, 40.0, 10.0}, {70.0, 56.0, 10.0}},
};
static const dyn_probe_part dyn_probe_parts_36_2[] = {
    {DYN_PROBE_RECTANGLE, {10.0, 30.0, 20.0}, {110.0, 66.0, 20.0}},
};
static const dyn_probe_object dyn_probe_objects_36[] = {
    {"H", 0, 0.0, 0, 0, {0.9, 0.2, 0.2}, 3, dyn_probe_parts_36_0},
    {"T", DYN_PROBE_TARGET, 1.0, 0, 0, {0.2, 0.7, 0.3}, 1, dyn_probe_parts_36_1},
    {"L", 0, 0.0, 0, 0, {0.2, 0.35, 0.9}, 1, dyn_probe_parts_36_2},
};

static const dyn_probe_scene dyn_probe_scenes[] = {
    {"figure 1, four walls, floor and roof as objects of their own", 1, 160, 120, 1, 100.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 9, dyn_probe_objects_0, 0, NULL},
    {"figure 1, the building one hollow object", 1, 160, 120, 1, 100.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 4, dyn_probe_objects_1, 0, NULL},
    {"figure 1, the building one solid object", 1, 160, 120, 1, 100.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 4, dyn_probe_objects_2, 0, NULL},
    {"figure 2, an L-shaped target behind a wall", 2, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 4, dyn_probe_objects_3, 0, NULL},
    {"figure 5, first-person view of rooms", 5, 160, 120, 1, 100.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 12, dyn_probe_objects_4, 0, NULL},
    {"figure 6, a tank under the trees, seen from above", 6, 160, 120, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 13, dyn_probe_objects_5, 0, NULL},
    {"R1, targets behind one, two, three and four walls", -1, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 8, dyn_probe_objects_6, 0, NULL},
    {"R2, occluders of a half-hidden target", -2, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 5, dyn_probe_objects_7, 0, NULL},
    {"R3, impenetrable surfaces before, between and behind", -3, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 6, dyn_probe_objects_8, 0, NULL},
    {"R3, an impenetrable target", -3, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 3, dyn_probe_objects_9, 0, NULL},
    {"R4, parts of one object before each other", -4, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 5, dyn_probe_objects_10, 0, NULL},
    {"R4, a target inside a solid box", -4, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 3, dyn_probe_objects_11, 0, NULL},
    {"R4, a distractor between two parts of a target", -4, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 2, dyn_probe_objects_12, 0, NULL},
    {"layers = 1, each", -5, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_EACH, 1, {0.05, 0.05, 0.1}, 6, dyn_probe_objects_13, 0, NULL},
    {"layers = 2, each", -5, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_EACH, 2, {0.05, 0.05, 0.1}, 6, dyn_probe_objects_14, 0, NULL},
    {"layers = 3, each", -5, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_EACH, 3, {0.05, 0.05, 0.1}, 6, dyn_probe_objects_15, 0, NULL},
    {"layers = 2, together", -5, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 2, {0.05, 0.05, 0.1}, 6, dyn_probe_objects_16, 0, NULL},
    {"layers = 3, together", -5, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 3, {0.05, 0.05, 0.1}, 6, dyn_probe_objects_17, 0, NULL},
    {"layers = 4, together", -5, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 4, {0.05, 0.05, 0.1}, 6, dyn_probe_objects_18, 0, NULL},
    {"importance, together", -6, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 9, dyn_probe_objects_19, 0, NULL},
    {"importance, each", -6, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_EACH, 0, {0.05, 0.05, 0.1}, 9, dyn_probe_objects_20, 0, NULL},
    {"combine = min, occluders = together", -7, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 5, dyn_probe_objects_21, 0, NULL},
    {"combine = min, occluders = each", -7, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_EACH, 0, {0.05, 0.05, 0.1}, 5, dyn_probe_objects_22, 0, NULL},
    {"combine = product, occluders = each", -7, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_PRODUCT, DYN_PROBE_EACH, 0, {0.05, 0.05, 0.1}, 5, dyn_probe_objects_23, 0, NULL},
    {"combine = product, occluders = together", -7, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_PRODUCT, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 5, dyn_probe_objects_24, 0, NULL},
    {"active mode: search lights", -8, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 4, dyn_probe_objects_25, 4, dyn_probe_lights_25},
    {"nested dolls, the innermost a target", -9, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 3, dyn_probe_objects_26, 0, NULL},
    {"nested dolls, the middle one a target", -9, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 3, dyn_probe_objects_27, 0, NULL},
    {"nested dolls, the outermost a target", -9, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 3, dyn_probe_objects_28, 0, NULL},
    {"one depth, order by rank: shell last", -9, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 2, dyn_probe_objects_29, 0, NULL},
    {"one depth, order by rank: core last", -9, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 2, dyn_probe_objects_30, 0, NULL},
    {"backdrop", -10, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 5, dyn_probe_objects_31, 0, NULL},
    {"backdrop is no occluder count", -10, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 3, dyn_probe_objects_32, 0, NULL},
    {"hollow sheets, occluders = together", -11, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 3, dyn_probe_objects_33, 0, NULL},
    {"hollow sheets, occluders = each", -11, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_EACH, 0, {0.05, 0.05, 0.1}, 3, dyn_probe_objects_34, 0, NULL},
    {"solid sheets, occluders = together", -11, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_TOGETHER, 0, {0.05, 0.05, 0.1}, 3, dyn_probe_objects_35, 0, NULL},
    {"solid sheets, occluders = each", -11, 128, 96, 0, 0.0, 0.3, 0.1, 12.0, DYN_PROBE_MIN, DYN_PROBE_EACH, 0, {0.05, 0.05, 0.1}, 3, dyn_probe_objects_36, 0, NULL},
};
enum { DYN_PROBE_SCENE_COUNT = 37 };

static const dyn_probe dyn_probes[] = {
    /* scene 0: figure 1, four walls, floor and roof as objects of their own; weights of the background, front, back, left, right, floor, roof, jet, crate, ground */
    {0, 80, 55, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0}, 0.0005, 0,
     "one wall before the target: alpha_T, the rest is the jet"},
    {0, 62, 57, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0}, 0.0005, 0,
     "the same near the corner of the jet"},
    {0, 80, 61, {0.0, 0.2125, 0.7875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.2125, 0.7875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "gradient at 1.5; the inside, here the back wall, shows around the target"},
    {0, 80, 65, {0.0, 0.5125, 0.4875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.5125, 0.4875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "gradient at 5.5, back wall behind the jet stays opaque"},
    {0, 80, 70, {0.0, 0.8875, 0.1125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.8875, 0.1125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "gradient at 10.5"},
    {0, 80, 73, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "13.5 from the jet: past the 12 pixels, occluder keeps full opacity"},
    {0, 80, 46, {0.0, 0.3625, 0.6375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.3625, 0.6375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "gradient at 3.5 below"},
    {0, 80, 43, {0.0, 0.5875, 0.0, 0.0, 0.0, 0.4125, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.5875, 0.0, 0.0, 0.0, 0.4125, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "gradient at 6.5; floor is hit at depth 300/16.5 = 18.2, behind the jet at 15: untouched"},
    {0, 105, 52, {0.0, 0.5125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.4875, 0.0}, 0.044, 1, {0.0, 0.5125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.4875, 0.0}, 0.044, 0,
     "crate at 18 is behind the jet at 15: seen opaque through the opened wall"},
    {0, 105, 58, {0.0, 0.5125, 0.4875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.5125, 0.4875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "beside the crate the back wall"},
    {0, 55, 55, {0.0, 0.4375, 0.5625, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.4375, 0.5625, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "gradient at 4.5 to the left"},
    {0, 48, 55, {0.0, 0.9625, 0.0, 0.0375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.9625, 0.0, 0.0375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "gradient at 11.5; left wall hit at 600/31.5 = 19.0, behind 15: untouched"},
    {0, 107, 67, {0.0, 0.895495, 0.104505, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0, {0.0}, 0.0, 0,
     "corner: distance sqrt(7.5^2 + 7.5^2) to the corner of the jet"},
    {0, 30, 55, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far from the jet"},
    {0, 125, 76, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far from the jet"},
    {0, 150, 60, {1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "beside the building and above the ground"},
    {0, 150, 20, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, 0.0005, 0,
     "ground beside the building"},
    /* scene 1: figure 1, the building one hollow object; weights of the background, building, jet, crate, ground */
    {1, 80, 55, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 0,
     "front wall opened; the back wall is behind the jet"},
    {1, 80, 61, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "opened front wall, opaque back wall of the same object: weight 1 in all"},
    {1, 80, 43, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "front wall and floor"},
    {1, 48, 55, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "front wall and left wall"},
    {1, 105, 52, {0.0, 0.5125, 0.0, 0.4875, 0.0}, 0.044, 1, {0.0, 0.5125, 0.0, 0.4875, 0.0}, 0.044, 0,
     "the crate stands before the back wall"},
    {1, 30, 55, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    {1, 107, 67, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "corner"},
    /* scene 2: figure 1, the building one solid object; weights of the background, building, jet, crate, ground */
    {2, 80, 55, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 0,
     "front face opened"},
    {2, 80, 61, {0.7875, 0.2125, 0.0, 0.0, 0.0}, 0.044, 1, {0.7875, 0.2125, 0.0, 0.0, 0.0}, 0.044, 0,
     "no further face of a solid shows: straight to the background"},
    {2, 80, 46, {0.0, 0.3625, 0.0, 0.0, 0.6375}, 0.044, 1, {0.0, 0.3625, 0.0, 0.0, 0.6375}, 0.044, 0,
     "straight to the ground"},
    {2, 80, 43, {0.0, 0.5875, 0.0, 0.0, 0.4125}, 0.044, 1, {0.0, 0.5875, 0.0, 0.0, 0.4125}, 0.044, 0,
     "the floor of a solid is not seen: ground"},
    {2, 105, 52, {0.0, 0.5125, 0.0, 0.4875, 0.0}, 0.044, 1, {0.0, 0.5125, 0.0, 0.4875, 0.0}, 0.044, 0,
     "the crate inside"},
    {2, 48, 55, {0.0375, 0.9625, 0.0, 0.0, 0.0}, 0.044, 1, {0.0375, 0.9625, 0.0, 0.0, 0.0}, 0.044, 0,
     "the left wall of a solid is not seen"},
    {2, 107, 67, {0.104505, 0.895495, 0.0, 0.0, 0.0}, 0.044, 0, {0.0}, 0.0, 0,
     "corner"},
    {2, 30, 55, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    /* scene 3: figure 2, an L-shaped target behind a wall; weights of the background, wall, target, post, sign */
    {3, 64, 48, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 0,
     "on the target: alpha_T"},
    {3, 56, 64, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 0,
     "on the upright of the L"},
    {3, 54, 70, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 0,
     "on the upright, 1.5 from its top"},
    {3, 74, 42, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 0,
     "1.5 from two edges inside: no gradient inside"},
    {3, 77, 48, {0.7875, 0.2125, 0.0, 0.0, 0.0}, 0.044, 1, {0.7875, 0.2125, 0.0, 0.0, 0.0}, 0.044, 0,
     "gradient at 1.5: just outside the mask starts near alpha_0, lower than alpha_T"},
    {3, 79, 48, {0.6375, 0.3625, 0.0, 0.0, 0.0}, 0.044, 1, {0.6375, 0.3625, 0.0, 0.0, 0.0}, 0.044, 0,
     "gradient at 3.5"},
    {3, 81, 48, {0.4875, 0.5125, 0.0, 0.0, 0.0}, 0.044, 1, {0.4875, 0.5125, 0.0, 0.0, 0.0}, 0.044, 0,
     "gradient at 5.5"},
    {3, 85, 48, {0.0, 0.8125, 0.0, 0.1875, 0.0}, 0.044, 1, {0.0, 0.8125, 0.0, 0.1875, 0.0}, 0.044, 0,
     "gradient at 9.5, post behind the target: opaque"},
    {3, 86, 48, {0.0, 0.8875, 0.0, 0.1125, 0.0}, 0.044, 1, {0.0, 0.8875, 0.0, 0.1125, 0.0}, 0.044, 0,
     "gradient at 10.5"},
    {3, 90, 48, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "14.5 away: closed"},
    {3, 64, 37, {0.7125, 0.2875, 0.0, 0.0, 0.0}, 0.044, 1, {0.7125, 0.2875, 0.0, 0.0, 0.0}, 0.044, 0,
     "below at 2.5"},
    {3, 64, 33, {0.4125, 0.5875, 0.0, 0.0, 0.0}, 0.044, 1, {0.4125, 0.5875, 0.0, 0.0, 0.0}, 0.044, 0,
     "below at 6.5"},
    {3, 64, 30, {0.1875, 0.8125, 0.0, 0.0, 0.0}, 0.044, 1, {0.1875, 0.8125, 0.0, 0.0, 0.0}, 0.044, 0,
     "below at 9.5"},
    {3, 64, 25, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "below at 14.5"},
    {3, 64, 60, {0.5625, 0.4375, 0.0, 0.0, 0.0}, 0.044, 1, {0.5625, 0.4375, 0.0, 0.0, 0.0}, 0.044, 0,
     "in the notch, 4.5 from both arms"},
    {3, 62, 66, {0.7125, 0.2875, 0.0, 0.0, 0.0}, 0.044, 1, {0.7125, 0.2875, 0.0, 0.0, 0.0}, 0.044, 0,
     "in the notch, 2.5 from the upright"},
    {3, 66, 62, {0.4125, 0.5875, 0.0, 0.0, 0.0}, 0.044, 1, {0.4125, 0.5875, 0.0, 0.0, 0.0}, 0.044, 0,
     "in the notch, 6.5 from both arms"},
    {3, 56, 75, {0.6375, 0.3625, 0.0, 0.0, 0.0}, 0.044, 1, {0.6375, 0.3625, 0.0, 0.0, 0.0}, 0.044, 0,
     "above the upright at 3.5"},
    {3, 56, 82, {0.1125, 0.8875, 0.0, 0.0, 0.0}, 0.044, 1, {0.1125, 0.8875, 0.0, 0.0, 0.0}, 0.044, 0,
     "above the upright at 10.5"},
    {3, 48, 64, {0.6375, 0.3625, 0.0, 0.0, 0.0}, 0.044, 1, {0.6375, 0.3625, 0.0, 0.0, 0.0}, 0.044, 0,
     "left of the upright at 3.5"},
    {3, 46, 50, {0.4875, 0.5125, 0.0, 0.0, 0.0}, 0.044, 1, {0.4875, 0.5125, 0.0, 0.0, 0.0}, 0.044, 0,
     "left at 5.5, beside the sign"},
    {3, 42, 50, {0.1875, 0.245513, 0.0, 0.0, 0.566987}, 0.053, 1, {0.035156, 0.152344, 0.0, 0.0, 0.8125}, 0.044, 1,
     "left at 9.5: two occluders share the mask, so that what is behind keeps 1 - a DIFFERS"},
    {3, 79, 37, {0.577413, 0.422587, 0.0, 0.0, 0.0}, 0.044, 0, {0.0}, 0.0, 0,
     "corner: sqrt(3.5^2 + 2.5^2)"},
    {3, 82, 61, {0.261398, 0.738602, 0.0, 0.0, 0.0}, 0.044, 0, {0.0}, 0.0, 0,
     "corner: sqrt(6.5^2 + 5.5^2)"},
    {3, 35, 30, {0.0, 0.0, 0.0, 0.0, 1.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 1.0}, 0.0005, 0,
     "far from the target"},
    {3, 100, 20, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far from the target"},
    {3, 4, 4, {1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "beside the wall"},
    {3, 88, 5, {0.0, 0.0, 0.0, 1.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 1.0, 0.0}, 0.0005, 0,
     "the post below the wall"},
    /* scene 4: figure 5, first-person view of rooms; weights of the background, wall 1, wall 2, far wall, floor, ceiling, A, B, C, D, E, H, cabinet */
    {4, 50, 57, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "A at 10 behind wall 1 at 8"},
    {4, 42, 48, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "A near its corner"},
    {4, 42, 62, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "A near another corner"},
    {4, 37, 57, {0.0, 0.2875, 0.7125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.2875, 0.7125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "gradient of A at 2.5; wall 2 at 20 is behind A: opaque"},
    {4, 55, 42, {0.0, 0.131597, 0.0, 0.0, 0.7125, 0.0, 0.0, 0.0, 0.155903, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.204844, 0.0, 0.0, 0.507656, 0.0, 0.0, 0.0, 0.2875, 0.0, 0.0, 0.0, 0.0}, 0.063, 1,
     "2.5 below A: C at 5 and wall 1 at 8 are nearer than A; targets cut targets; floor hit at 11.4 DIFFERS"},
    {4, 55, 36, {0.0, 0.249848, 0.0, 0.0, 0.2625, 0.0, 0.0, 0.0, 0.487652, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.193594, 0.0, 0.0, 0.068906, 0.0, 0.0, 0.0, 0.7375, 0.0, 0.0, 0.0, 0.0}, 0.044, 1,
     "8.5 below A; floor hit at 8.5, but a backdrop is no occluder DIFFERS"},
    {4, 55, 33, {0.0, 0.0, 0.0, 0.0, 0.0375, 0.0, 0.0, 0.0, 0.9625, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.0, 0.0, 0.0, 0.0375, 0.0, 0.0, 0.0, 0.9625, 0.0, 0.0, 0.0, 0.0}, 0.044, 1,
     "11.5 below A and below wall 1: C alone is before the mask"},
    {4, 55, 31, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "13.5 below A: C seen whole"},
    {4, 80, 53, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "E seen through the door: nothing before it"},
    {4, 87, 53, {0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "2.5 right of E in the door: wall 2 at 20 is behind E: opaque"},
    {4, 92, 53, {0.0, 0.6625, 0.3375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.6625, 0.3375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "7.5 right of E: wall 1 is nearer than E"},
    {4, 66, 53, {0.0, 0.487652, 0.2625, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.249848, 0.0, 0.0, 0.0}, 0.044, 0, {0.0}, 0.0, 1,
     "6.5 right of A (opens wall 1: 0.5875) and 8.5 left of E (wall 1 and D share: 0.488 each): min"},
    {4, 65, 57, {0.0, 0.5125, 0.211094, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.276406, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.416406, 0.109424, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.47417, 0.0, 0.0, 0.0}, 0.059, 1,
     "5.5 right of A (wall 1: 0.5125), 9.5 left of E (0.567 each): min on wall 1; D at 12 is behind A, cut by E alone DIFFERS"},
    {4, 127, 60, {0.0, 0.16334, 0.13666, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.21, 0.0, 0.0, 0.0, 0.0, 0.49, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "two walls before B share alpha_T: B keeps 0.7 DIFFERS"},
    {4, 122, 60, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "through the door of wall 2 one wall is before B"},
    {4, 133, 60, {0.0, 0.201564, 0.160936, 0.6375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.3625, 0.231094, 0.406406, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.057, 1,
     "3.5 right of B, two walls DIFFERS"},
    {4, 117, 60, {0.0, 0.155903, 0.131597, 0.7125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.2875, 0.204844, 0.507656, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.063, 1,
     "2.5 left of B, two walls DIFFERS"},
    {4, 122, 67, {0.0, 0.2875, 0.0, 0.0, 0.0, 0.7125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.2875, 0.0, 0.0, 0.0, 0.7125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "2.5 above B in the door: one wall, ceiling hit at 26.7"},
    {4, 127, 72, {0.0, 0.6625, 0.0, 0.0, 0.0, 0.3375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.6625, 0.0, 0.0, 0.0, 0.3375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "7.5 above B, over the top of wall 2; ceiling hit at 16 is a backdrop, opaque"},
    {4, 150, 60, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "20 from B"},
    {4, 6, 57, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 0,
     "H left of the cabinet"},
    {4, 14, 57, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7}, 0.0005, 0,
     "cabinet at 9 is before H: impenetrable, and it closes the mask on wall 1 too; the paper opens wall 1 and shows the cabinet DIFFERS"},
    {4, 14, 62, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 0,
     "H above the cabinet"},
    {4, 22, 57, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.4375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5625}, 0.044, 0,
     "gradient of H at 4.5, closed by the cabinet DIFFERS"},
    {4, 22, 62, {0.0, 0.4375, 0.5625, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.4375, 0.5625, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "gradient of H at 4.5 above the cabinet"},
    {4, 14, 47, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.2875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7125}, 0.044, 0,
     "2.5 below H, closed by the cabinet DIFFERS"},
    {4, 6, 47, {0.0, 0.2875, 0.0, 0.0, 0.7125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.2875, 0.0, 0.0, 0.7125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "2.5 below H beside the cabinet; floor hit at 16"},
    {4, 20, 80, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far from all"},
    {4, 80, 20, {0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "floor of the first room"},
    {4, 80, 75, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "ceiling through the door"},
    /* scene 5: figure 6, a tank under the trees, seen from above; weights of the background, ground, tree1, tree2, tree3, tank, gunner, soldier, wreck, tree4, scout, mortar, bunker, tree5 */
    {5, 46, 62, {0.0, 0.0, 0.3, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.3, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "one tree"},
    {5, 64, 58, {0.0, 0.0, 0.16334, 0.13666, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "tree 1 at 40 - sqrt(400 - 212.5) = 26.3 before tree 2 at 30; the gunner is 5.7 away: 0.5275 does not lower them"},
    {5, 68, 62, {0.0, 0.0, 0.099912, 0.112588, 0.0, 0.7875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.0, 0.059686, 0.06375, 0.0, 0.876564, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.026, 1,
     "tree 1 at 32.8 is behind tree 2; 1.5 from the gunner at 55: min(0.3, 0.2125), shared by two DIFFERS"},
    {5, 82, 62, {0.0, 0.0, 0.0, 0.13666, 0.16334, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.145186, 0.17625, 0.678564, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.023, 0,
     "trees 3 and 2; the gunner is 6.5 away: 0.5875 does not lower them DIFFERS"},
    {5, 78, 63, {0.0, 0.0, 0.0, 0.2875, 0.0, 0.7125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.0, 0.0, 0.08625, 0.0, 0.91375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.015, 0,
     "2.5 from the gunner: 0.2875 is less than alpha_T DIFFERS"},
    {5, 73, 63, {0.0, 0.0, 0.0, 0.16334, 0.0, 0.7, 0.13666, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.09, 0.0, 0.637, 0.273, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1,
     "tree 2 and the gunner are before the tank and share its mask; the gunner asks 0.3 of tree 2: min DIFFERS"},
    {5, 73, 71, {0.0, 0.6375, 0.0, 0.3625, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.814219, 0.0, 0.185781, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.04, 0,
     "3.5 from the tank, 5.5 from the gunner: min DIFFERS"},
    {5, 50, 71, {0.0, 0.6375, 0.3625, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.6375, 0.3625, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "3.5 from the tank"},
    {5, 41, 62, {0.0, 0.7125, 0.2875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.7125, 0.2875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "2.5 from the tank"},
    {5, 87, 62, {0.0, 0.6375, 0.0, 0.160936, 0.201564, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.423923, 0.0, 0.227171, 0.348906, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.076, 1,
     "3.5 from the tank, two trees share DIFFERS"},
    {5, 93, 62, {0.0, 0.4125, 0.0, 0.0, 0.5875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.522656, 0.0, 0.0, 0.477344, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.062, 0,
     "9.5 from the tank, 6.5 from the soldier: min DIFFERS"},
    {5, 103, 62, {0.0, 0.0, 0.0, 0.0, 0.3, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.3, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "soldier under one tree"},
    {5, 108, 62, {0.0, 0.7125, 0.0, 0.0, 0.2875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.7125, 0.0, 0.0, 0.2875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "2.5 from the soldier"},
    {5, 112, 62, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "6.5 from the soldier, but nothing before the ground"},
    {5, 104, 50, {0.0, 0.3375, 0.0, 0.0, 0.6625, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.0, 0.3375, 0.0, 0.0, 0.6625, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "7.5 below the soldier"},
    {5, 104, 43, {0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "14.5 below the soldier"},
    {5, 30, 95, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "the wreck is no target: the tree stays"},
    {5, 16, 88, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "the tree beside the wreck"},
    {5, 130, 95, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "in the open: nothing to change"},
    {5, 143, 95, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "its gradient acts on nothing"},
    {5, 152, 34, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.3}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.3}, 0.0005, 0,
     "mortar under a tree"},
    {5, 150, 28, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.3}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.3}, 0.0005, 0,
     "mortar beside the bunker"},
    {5, 140, 29, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.3}, 0.0005, 0,
     "under the bunker: mask closed; the paper shows the bunker through the tree DIFFERS"},
    {5, 140, 34, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.3}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0, 0.3}, 0.0005, 0,
     "above the bunker"},
    {5, 133, 34, {0.0, 0.7125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.2875}, 0.044, 1, {0.0, 0.7125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.2875}, 0.044, 0,
     "2.5 left of the mortar"},
    {5, 133, 29, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7125, 0.2875}, 0.044, 0,
     "2.5 left of the mortar, closed by the bunker DIFFERS"},
    {5, 150, 39, {0.0, 0.6375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3625}, 0.044, 1, {0.0, 0.6375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3625}, 0.044, 0,
     "3.5 above the mortar"},
    {5, 150, 22, {0.0, 0.6375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3625}, 0.044, 1, {0.0, 0.6375, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3625}, 0.044, 0,
     "3.5 below the mortar"},
    {5, 131, 14, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, 0.018, 0, {0.0}, 0.0, 0,
     "12.3 from the mortar"},
    {5, 5, 5, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    /* scene 6: R1, targets behind one, two, three and four walls; weights of the background, W1, W2, W3, W4, Ta, Tb, Tc, Td */
    {6, 20, 45, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0}, 0.0005, 0,
     "one wall: 0.3 and 0.7"},
    {6, 18, 50, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0}, 0.0005, 0,
     "one wall: 0.3 and 0.7"},
    {6, 26, 42, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0}, 0.0005, 0,
     "one wall: 0.3 and 0.7"},
    {6, 55, 45, {0.0, 0.16334, 0.13666, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.21, 0.0, 0.0, 0.0, 0.49, 0.0, 0.0}, 0.0005, 0,
     "two walls share: each 1 - 0.7^(1/2), target 0.7; the paper leaves 0.49 DIFFERS"},
    {6, 60, 50, {0.0, 0.16334, 0.13666, 0.0, 0.0, 0.0, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.21, 0.0, 0.0, 0.0, 0.49, 0.0, 0.0}, 0.0005, 0,
     "two walls share: each 1 - 0.7^(1/2), target 0.7; the paper leaves 0.49 DIFFERS"},
    {6, 82, 45, {0.0, 0.112096, 0.09953, 0.088374, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.21, 0.147, 0.0, 0.0, 0.0, 0.343, 0.0}, 0.0005, 0,
     "three walls share: target 0.7; the paper leaves 0.343 DIFFERS"},
    {6, 86, 42, {0.0, 0.112096, 0.09953, 0.088374, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.21, 0.147, 0.0, 0.0, 0.0, 0.343, 0.0}, 0.0005, 0,
     "three walls share: target 0.7; the paper leaves 0.343 DIFFERS"},
    {6, 108, 45, {0.0, 0.085309, 0.078031, 0.071374, 0.065286, 0.0, 0.0, 0.0, 0.7}, 0.0005, 1, {0.0, 0.3, 0.21, 0.147, 0.1029, 0.0, 0.0, 0.0, 0.2401}, 0.0005, 0,
     "four walls share: target 0.7; the paper leaves 0.2401 DIFFERS"},
    {6, 104, 50, {0.0, 0.085309, 0.078031, 0.071374, 0.065286, 0.0, 0.0, 0.0, 0.7}, 0.0005, 1, {0.0, 0.3, 0.21, 0.147, 0.1029, 0.0, 0.0, 0.0, 0.2401}, 0.0005, 0,
     "four walls share: target 0.7; the paper leaves 0.2401 DIFFERS"},
    {6, 30, 45, {0.7125, 0.2875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.7125, 0.2875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "2.5 right of Ta"},
    {6, 33, 45, {0.4875, 0.5125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.4875, 0.5125, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "5.5 right of Ta"},
    {6, 20, 37, {0.7125, 0.2875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.7125, 0.2875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "2.5 below Ta"},
    {6, 47, 45, {0.7125, 0.155903, 0.131597, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.507656, 0.2875, 0.204844, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.063, 1,
     "2.5 left of Tb, two walls share DIFFERS"},
    {6, 45, 45, {0.5625, 0.25, 0.1875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.316406, 0.4375, 0.246094, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.051, 1,
     "4.5 left of Tb DIFFERS"},
    {6, 66, 45, {0.5625, 0.25, 0.1875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.335132, 0.421094, 0.243774, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.071, 1,
     "4.5 right of Tb, 11.5 left of Tc: min DIFFERS"},
    {6, 75, 45, {0.7125, 0.106842, 0.095427, 0.085231, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.361705, 0.2875, 0.204844, 0.145951, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.069, 1,
     "2.5 left of Tc, three walls DIFFERS"},
    {6, 91, 45, {0.6375, 0.13935, 0.119931, 0.103219, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.312054, 0.321719, 0.218216, 0.148012, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.077, 1,
     "3.5 right of Tc, 10.5 left of Td: min DIFFERS"},
    {6, 99, 45, {0.7125, 0.081252, 0.07465, 0.068585, 0.063012, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.273671, 0.276719, 0.200145, 0.144761, 0.104703, 0.0, 0.0, 0.0, 0.0}, 0.086, 1,
     "2.5 left of Td, four walls DIFFERS"},
    {6, 117, 45, {0.6375, 0.106448, 0.095116, 0.084992, 0.075944, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.165166, 0.3625, 0.231094, 0.147322, 0.093918, 0.0, 0.0, 0.0, 0.0}, 0.05, 1,
     "3.5 right of Td DIFFERS"},
    {6, 108, 57, {0.4875, 0.164409, 0.137379, 0.114792, 0.09592, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.05648, 0.5125, 0.249844, 0.121799, 0.059377, 0.0, 0.0, 0.0, 0.0}, 0.044, 1,
     "5.5 above Td DIFFERS"},
    {6, 20, 70, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    {6, 108, 70, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far: the front wall alone"},
    {6, 4, 45, {1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "beside the walls, within the gradient of Ta: nothing to open"},
    /* scene 7: R2, occluders of a half-hidden target; weights of the background, W, E, T, B, F */
    {7, 28, 45, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "not occluded: nothing changes"},
    {7, 26, 54, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "not occluded"},
    {7, 43, 45, {0.0, 0.3, 0.0, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.7, 0.0, 0.0}, 0.0005, 0,
     "one occluder"},
    {7, 46, 42, {0.0, 0.3, 0.0, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.7, 0.0, 0.0}, 0.0005, 0,
     "one occluder, 1.5 from the second"},
    {7, 52, 45, {0.0, 0.16334, 0.13666, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.21, 0.49, 0.0, 0.0}, 0.0005, 0,
     "two occluders share DIFFERS"},
    {7, 52, 54, {0.0, 0.3, 0.0, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.7, 0.0, 0.0}, 0.0005, 0,
     "above E"},
    {7, 58, 54, {0.0, 0.2875, 0.0, 0.0, 0.7125, 0.0}, 0.044, 1, {0.0, 0.2875, 0.0, 0.0, 0.7125, 0.0}, 0.044, 0,
     "2.5 right; B behind the target keeps alpha 1"},
    {7, 58, 45, {0.0, 0.155903, 0.131597, 0.0, 0.7125, 0.0}, 0.044, 1, {0.0, 0.2875, 0.204844, 0.0, 0.507656, 0.0}, 0.063, 1,
     "2.5 right, W and E are nearer than T DIFFERS"},
    {7, 66, 45, {0.0, 0.66459, 0.22291, 0.0, 0.1125, 0.0}, 0.071, 1, {0.0, 0.8875, 0.099844, 0.0, 0.012656, 0.0}, 0.044, 1,
     "10.5 right DIFFERS"},
    {7, 69, 45, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "13.5 right: closed"},
    {7, 65, 54, {0.0, 0.8125, 0.0, 0.0, 0.1875, 0.0}, 0.044, 1, {0.0, 0.8125, 0.0, 0.0, 0.1875, 0.0}, 0.044, 0,
     "9.5 right, above E"},
    {7, 52, 38, {0.0, 0.112588, 0.099912, 0.0, 0.7875, 0.0}, 0.044, 1, {0.0, 0.2125, 0.167344, 0.0, 0.620156, 0.0}, 0.069, 1,
     "1.5 below DIFFERS"},
    {7, 52, 34, {0.4875, 0.301788, 0.210712, 0.0, 0.0, 0.0}, 0.044, 1, {0.237656, 0.5125, 0.249844, 0.0, 0.0, 0.0}, 0.044, 1,
     "5.5 below, under B DIFFERS"},
    {7, 44, 34, {0.4875, 0.5125, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.4875, 0.5125, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "5.5 below, beside E"},
    {7, 44, 58, {0.0, 0.2875, 0.0, 0.0, 0.7125, 0.0}, 0.044, 1, {0.0, 0.2875, 0.0, 0.0, 0.7125, 0.0}, 0.044, 0,
     "2.5 above"},
    {7, 44, 63, {0.3375, 0.6625, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.3375, 0.6625, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "7.5 above, over B"},
    {7, 22, 45, {0.0, 0.0, 0.0, 0.0, 1.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 1.0, 0.0}, 0.0005, 0,
     "1.5 left of the target: no occluder there, B behind untouched"},
    {7, 30, 58, {0.0, 0.0, 0.0, 0.0, 1.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 1.0, 0.0}, 0.0005, 0,
     "2.5 above, no occluder"},
    {7, 70, 70, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, 0.0005, 0,
     "F hides no target"},
    {7, 90, 45, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    {7, 110, 80, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    {7, 60, 25, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "E behind the closed wall"},
    {7, 10, 10, {1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "background"},
    /* scene 8: R3, impenetrable surfaces before, between and behind; weights of the background, W, I1, I2, I3, T, T2 */
    {8, 50, 48, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "I1 at 6 is before T: never transparent, and it closes the mask on W; the paper opens W and shows I1 DIFFERS"},
    {8, 46, 54, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "I1 at 6 is before T: never transparent, and it closes the mask on W; the paper opens W and shows I1 DIFFERS"},
    {8, 62, 48, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 0,
     "beside I1; I3 lies behind T and does nothing"},
    {8, 76, 50, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 0,
     "beside I1; I3 lies behind T and does nothing"},
    {8, 68, 48, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 0,
     "beside I1; I3 lies behind T and does nothing"},
    {8, 40, 48, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3625, 0.6375, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "3.5 left of T, over I1: closed DIFFERS"},
    {8, 52, 59, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3625, 0.6375, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "3.5 above T, over I1: closed DIFFERS"},
    {8, 83, 48, {0.6375, 0.3625, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.6375, 0.3625, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "3.5 right of T"},
    {8, 88, 48, {0.2625, 0.7375, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.2625, 0.7375, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "8.5 right of T"},
    {8, 91, 48, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "11.5 right of T: impenetrable in front"},
    {8, 97, 60, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "impenetrable in front, far"},
    {8, 68, 59, {0.0, 0.3625, 0.0, 0.0, 0.6375, 0.0, 0.0}, 0.044, 1, {0.0, 0.3625, 0.0, 0.0, 0.6375, 0.0, 0.0}, 0.044, 0,
     "3.5 above, I3 behind shows"},
    {8, 68, 62, {0.0, 0.5875, 0.0, 0.0, 0.4125, 0.0, 0.0}, 0.044, 1, {0.0, 0.5875, 0.0, 0.0, 0.4125, 0.0, 0.0}, 0.044, 0,
     "6.5 above"},
    {8, 68, 36, {0.0, 0.3625, 0.0, 0.0, 0.6375, 0.0, 0.0}, 0.044, 1, {0.0, 0.3625, 0.0, 0.0, 0.6375, 0.0, 0.0}, 0.044, 0,
     "3.5 below"},
    {8, 76, 59, {0.6375, 0.3625, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.6375, 0.3625, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "3.5 above, beside I3"},
    {8, 62, 36, {0.6375, 0.3625, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.6375, 0.3625, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "3.5 below, between I1 and I3"},
    {8, 97, 26, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "T2 behind I2: stays hidden"},
    {8, 106, 26, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.7}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.7}, 0.0005, 0,
     "T2 beside I2"},
    {8, 110, 30, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.7}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.7}, 0.0005, 0,
     "T2 beside I2"},
    {8, 114, 26, {0.7125, 0.2875, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.7125, 0.2875, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "2.5 right of T2"},
    {8, 97, 35, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "3.5 above T2, impenetrable"},
    {8, 106, 36, {0.5625, 0.4375, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.5625, 0.4375, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "4.5 above T2"},
    {8, 88, 26, {0.4875, 0.5125, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.4875, 0.5125, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1,
     "5.5 left of the hidden part of T2: the mask grows from the whole outline and is closed only where I2 covers it"},
    {8, 20, 80, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    /* scene 9: R3, an impenetrable target; weights of the background, W, TI, T2 */
    {9, 30, 50, {0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.24375, 0.75625, 0.0}, 0.015, 0,
     "it is a target: uncovered DIFFERS"},
    {9, 60, 60, {0.0, 0.3, 0.0, 0.7}, 0.0005, 0, {0.0}, 0.0, 0,
     "the other target"},
    {9, 45, 50, {0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.09, 0.91, 0.0}, 0.0005, 0,
     "TI before T2 is never made transparent and closes the mask of T2; its own mask opens W DIFFERS"},
    {9, 45, 62, {0.0, 0.2875, 0.0, 0.7125}, 0.044, 1, {0.0, 0.08625, 0.0, 0.91375}, 0.015, 0,
     "T2 asks 0.3, TI at 2.5 asks 0.2875: min DIFFERS"},
    {9, 52, 35, {0.7125, 0.2875, 0.0, 0.0}, 0.044, 1, {0.874219, 0.125781, 0.0, 0.0}, 0.034, 0,
     "2.5 right of TI DIFFERS"},
    {9, 36, 50, {0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.10875, 0.89125, 0.0}, 0.015, 0,
     "on TI, 3.5 from T2: closed by TI DIFFERS"},
    {9, 30, 63, {0.6375, 0.3625, 0.0, 0.0}, 0.044, 1, {0.705469, 0.294531, 0.0, 0.0}, 0.053, 0,
     "3.5 above TI, 9.5 left of T2: min DIFFERS"},
    {9, 100, 20, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    /* scene 10: R4, parts of one object before each other; weights of the background, W, U, D, T3, ball */
    {10, 30, 45, {0.0, 0.3, 0.7, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0, 0.0}, 0.0005, 0,
     "rear part of U"},
    {10, 45, 50, {0.0, 0.3, 0.7, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0, 0.0}, 0.0005, 0,
     "front part of U hides its rear part: no transparency within U"},
    {10, 45, 35, {0.0, 0.3, 0.7, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0, 0.0}, 0.0005, 0,
     "rear part below the front part"},
    {10, 45, 70, {0.0, 0.3, 0.7, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0, 0.0}, 0.0005, 0,
     "front part alone"},
    {10, 52, 70, {0.7125, 0.2875, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.7125, 0.2875, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "2.5 right of the front part"},
    {10, 30, 70, {0.1875, 0.8125, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.1875, 0.8125, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "9.5 left of the front part, 10.5 above the rear part"},
    {10, 30, 63, {0.6375, 0.3625, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.6375, 0.3625, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "3.5 above the rear part"},
    {10, 71, 50, {0.0, 0.16334, 0.0, 0.13666, 0.7, 0.0}, 0.0005, 1, {0.0, 0.28875, 0.0, 0.205373, 0.505877, 0.0}, 0.02, 0,
     "D counts once: only its front-most sheet is drawn DIFFERS"},
    {10, 68, 58, {0.7125, 0.155903, 0.0, 0.131597, 0.0, 0.0}, 0.044, 1, {0.620895, 0.212031, 0.0, 0.167074, 0.0, 0.0}, 0.07, 1,
     "2.5 above T3; the second sheet of D is not seen behind the first DIFFERS"},
    {10, 78, 50, {0.0, 0.3, 0.0, 0.0, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.7, 0.0}, 0.0005, 0,
     "beside D"},
    {10, 84, 50, {0.5625, 0.4375, 0.0, 0.0, 0.0, 0.0}, 0.044, 0, {0.0}, 0.0, 0,
     "4.5 right of T3, 9.5 from the ball: min"},
    {10, 71, 20, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    {10, 104, 50, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7}, 0.0005, 0,
     "the ball hides its own back"},
    {10, 108, 56, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7}, 0.0005, 0,
     "the ball"},
    {10, 104, 58, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7}, 0.0005, 0,
     "the ball near its rim"},
    {10, 104, 63, {0.636806, 0.363194, 0.0, 0.0, 0.0, 0.0}, 0.044, 0, {0.0}, 0.0, 0,
     "sqrt(0.5^2 + 13.5^2) - 10 from the ball"},
    {10, 104, 70, {0.112043, 0.887957, 0.0, 0.0, 0.0, 0.0}, 0.044, 0, {0.0}, 0.0, 0,
     "sqrt(0.5^2 + 20.5^2) - 10 from the ball"},
    {10, 104, 76, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "16.5 from the ball"},
    /* scene 11: R4, a target inside a solid box; weights of the background, box, T, L */
    {11, 60, 48, {0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0}, 0.0005, 0,
     "front of the box opened"},
    {11, 52, 54, {0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0}, 0.0005, 0,
     "front of the box opened"},
    {11, 74, 48, {0.0, 0.4375, 0.0, 0.5625}, 0.044, 1, {0.0, 0.4375, 0.0, 0.5625}, 0.044, 0,
     "4.5 right: the back of the box is not seen"},
    {11, 60, 60, {0.0, 0.4375, 0.0, 0.5625}, 0.044, 1, {0.0, 0.4375, 0.0, 0.5625}, 0.044, 0,
     "4.5 above"},
    {11, 60, 66, {0.0, 0.8875, 0.0, 0.1125}, 0.044, 1, {0.0, 0.8875, 0.0, 0.1125}, 0.044, 0,
     "10.5 above"},
    {11, 30, 35, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    {11, 15, 50, {0.0, 0.0, 0.0, 1.0}, 0.0005, 1, {0.0, 0.0, 0.0, 1.0}, 0.0005, 0,
     "beside the box"},
    {11, 90, 75, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    /* scene 12: R4, a distractor between two parts of a target; weights of the background, U, D */
    {12, 35, 50, {0.0, 1.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0}, 0.0005, 0,
     "front part"},
    {12, 45, 50, {0.0, 1.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0}, 0.0005, 0,
     "front part hides D and its own rear part: left alone"},
    {12, 60, 50, {0.0, 0.7, 0.3}, 0.0005, 1, {0.0, 0.7, 0.3}, 0.0005, 0,
     "D before the rear part"},
    {12, 80, 50, {0.0, 1.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0}, 0.0005, 0,
     "rear part alone"},
    {12, 45, 65, {0.0, 1.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0}, 0.0005, 0,
     "front part before D"},
    /* scene 13: layers = 1, each; weights of the background, W1, W2, W3, W4, T, B */
    {13, 34, 48, {0.0, 0.3, 0.7, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "the nearest of three opens, the rest stay"},
    {13, 50, 48, {0.0, 0.3, 0.7, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "the nearest of four opens"},
    {13, 64, 48, {0.0, 0.4375, 0.5625, 0.0, 0.0, 0.0, 0.0}, 0.044, 0, {0.0}, 0.0, 0,
     "gradient at 4.5"},
    {13, 24, 48, {0.0, 0.5125, 0.4875, 0.0, 0.0, 0.0, 0.0}, 0.044, 0, {0.0}, 0.0, 0,
     "gradient at 5.5"},
    {13, 80, 48, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "far"},
    /* scene 14: layers = 2, each; weights of the background, W1, W2, W3, W4, T, B */
    {14, 34, 48, {0.0, 0.3, 0.21, 0.49, 0.0, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "two of three"},
    {14, 50, 48, {0.0, 0.3, 0.21, 0.49, 0.0, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "two of four"},
    {14, 64, 48, {0.0, 0.4375, 0.246094, 0.316406, 0.0, 0.0, 0.0}, 0.051, 0, {0.0}, 0.0, 0,
     "gradient at 4.5"},
    {14, 14, 48, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "16 from the target: closed"},
    {14, 100, 48, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "far"},
    /* scene 15: layers = 3, each; weights of the background, W1, W2, W3, W4, T, B */
    {15, 34, 48, {0.0, 0.3, 0.21, 0.147, 0.0, 0.343, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "all three: the target is seen"},
    {15, 50, 48, {0.0, 0.3, 0.21, 0.147, 0.343, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "three of four"},
    {15, 24, 48, {0.0, 0.5125, 0.249844, 0.121799, 0.0, 0.0, 0.115857}, 0.044, 0, {0.0}, 0.0, 0,
     "gradient at 5.5, three walls, B behind"},
    {15, 64, 48, {0.0, 0.4375, 0.246094, 0.138428, 0.177979, 0.0, 0.0}, 0.045, 0, {0.0}, 0.0, 0,
     "gradient at 4.5, three of four"},
    /* scene 16: layers = 2, together; weights of the background, W1, W2, W3, W4, T, B */
    {16, 50, 48, {0.0, 0.16334, 0.13666, 0.7, 0.0, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 1,
     "alpha_T shared over the two that open"},
    {16, 34, 48, {0.0, 0.16334, 0.13666, 0.7, 0.0, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 1,
     "the same"},
    {16, 64, 48, {0.0, 0.25, 0.1875, 0.5625, 0.0, 0.0, 0.0}, 0.044, 0, {0.0}, 0.0, 1,
     "gradient at 4.5"},
    /* scene 17: layers = 3, together; weights of the background, W1, W2, W3, W4, T, B */
    {17, 34, 48, {0.0, 0.112096, 0.09953, 0.088374, 0.0, 0.7, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "three of three"},
    {17, 50, 48, {0.0, 0.112096, 0.09953, 0.088374, 0.7, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 1,
     "three of four"},
    /* scene 18: layers = 4, together; weights of the background, W1, W2, W3, W4, T, B */
    {18, 34, 48, {0.0, 0.112096, 0.09953, 0.088374, 0.0, 0.7, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "three, the limit is not reached"},
    {18, 50, 48, {0.0, 0.085309, 0.078031, 0.071374, 0.065286, 0.7, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "four of four"},
    {18, 24, 48, {0.0, 0.21297, 0.167614, 0.131917, 0.0, 0.0, 0.4875}, 0.044, 0, {0.0}, 0.0, 1,
     "gradient at 5.5"},
    /* scene 19: importance, together; weights of the background, A, B, C, D, E, F, H, T1, T2 */
    {19, 16, 62, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 0,
     "difference 1: alpha_T"},
    {19, 31, 62, {0.0, 0.0, 0.475, 0.0, 0.0, 0.0, 0.0, 0.0, 0.525, 0.0}, 0.0005, 1, {0.0, 0.0, 0.475, 0.0, 0.0, 0.0, 0.0, 0.0, 0.525, 0.0}, 0.0005, 0,
     "difference 0.75: 1 - 0.7 x 0.75"},
    {19, 76, 62, {0.0, 0.0, 0.0, 0.0, 0.86, 0.0, 0.0, 0.0, 0.14, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.86, 0.0, 0.0, 0.0, 0.14, 0.0}, 0.0005, 0,
     "difference 0.2: 1 - 0.7 x 0.2"},
    {19, 96, 62, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "difference 0: opaque"},
    {19, 16, 26, {0.0, 0.58, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.42}, 0.0005, 1, {0.0, 0.58, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.42}, 0.0005, 0,
     "difference 0.6"},
    {19, 37, 26, {0.0, 0.0, 0.755, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.245}, 0.0005, 1, {0.0, 0.0, 0.755, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.245}, 0.0005, 0,
     "difference 0.35"},
    {19, 56, 26, {0.0, 0.0, 0.0, 0.93, 0.0, 0.0, 0.0, 0.0, 0.0, 0.07}, 0.0005, 1, {0.0, 0.0, 0.0, 0.93, 0.0, 0.0, 0.0, 0.0, 0.0, 0.07}, 0.0005, 0,
     "difference 0.1"},
    {19, 83, 26, {0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "difference -0.2 clamps to 0"},
    {19, 96, 26, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "difference -0.4 clamps to 0"},
    {19, 40, 62, {0.0, 0.0, 0.162947, 0.0, 0.0, 0.0, 0.408392, 0.0, 0.428661, 0.0}, 0.0005, 1, {0.0, 0.0, 0.16625, 0.0, 0.0, 0.0, 0.65, 0.0, 0.18375, 0.0}, 0.0005, 1,
     "two occluders of alpha 0.65 and 0.475: each shares its own, 1 - (1 - a)^(1/2) DIFFERS"},
    {19, 56, 62, {0.0, 0.0, 0.0, 0.241608, 0.0, 0.0, 0.408392, 0.0, 0.35, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.2275, 0.0, 0.0, 0.65, 0.0, 0.1225, 0.0}, 0.0005, 1,
     "two occluders of alpha 0.65: the target keeps 0.35 DIFFERS"},
    {19, 75, 26, {0.0, 0.0, 0.0, 0.0, 0.42, 0.0, 0.0, 0.58, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.42, 0.0, 0.0, 0.58, 0.0, 0.0}, 0.0005, 1,
     "D stays opaque and is not counted among those that share"},
    {19, 31, 71, {0.478125, 0.0, 0.521875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.033, 1, {0.478125, 0.0, 0.521875, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.033, 1,
     "3.5 above T1: the difference mixes the gradient as it does alpha_T"},
    {19, 16, 71, {0.6375, 0.3625, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.6375, 0.3625, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.044, 0,
     "3.5 above T1, difference 1"},
    {19, 16, 80, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.006, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.006, 0,
     "12.5 above T1: closed"},
    {19, 115, 62, {1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "beside"},
    /* scene 20: importance, each; weights of the background, A, B, C, D, E, F, H, T1, T2 */
    {20, 40, 62, {0.0, 0.0, 0.16625, 0.0, 0.0, 0.0, 0.65, 0.0, 0.18375, 0.0}, 0.0005, 1, {0.0, 0.0, 0.16625, 0.0, 0.0, 0.0, 0.65, 0.0, 0.18375, 0.0}, 0.0005, 0,
     "each its own alpha"},
    {20, 56, 62, {0.0, 0.0, 0.0, 0.2275, 0.0, 0.0, 0.65, 0.0, 0.1225, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.2275, 0.0, 0.0, 0.65, 0.0, 0.1225, 0.0}, 0.0005, 0,
     "each its own alpha"},
    {20, 75, 26, {0.0, 0.0, 0.0, 0.0, 0.42, 0.0, 0.0, 0.58, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.0, 0.42, 0.0, 0.0, 0.58, 0.0, 0.0}, 0.0005, 0,
     "H opens to 0.58, D stays"},
    {20, 16, 62, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7, 0.0}, 0.0005, 0,
     "one occluder"},
    {20, 37, 26, {0.0, 0.0, 0.755, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.245}, 0.0005, 1, {0.0, 0.0, 0.755, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.245}, 0.0005, 0,
     "one occluder"},
    /* scene 21: combine = min, occluders = together; weights of the background, W, T1, T2, T3, T4 */
    {21, 55, 45, {0.0, 0.085309, 0.078031, 0.071374, 0.065286, 0.7}, 0.0005, 1, {0.0, 0.0081, 0.026781, 0.086861, 0.263477, 0.614781}, 0.0005, 1,
     "before T4 lie W, T1, T2, T3: its share of four is the least; T4 keeps 0.7 DIFFERS"},
    {21, 63, 46, {0.0, 0.112096, 0.0, 0.09953, 0.088374, 0.7}, 0.0005, 1, {0.0, 0.009788, 0.0, 0.089119, 0.270328, 0.630765}, 0.004, 1,
     "before T4 lie W, T2, T3 DIFFERS"},
    {21, 69, 46, {0.0, 0.16334, 0.0, 0.0, 0.13666, 0.7}, 0.0005, 1, {0.0, 0.026508, 0.0, 0.0, 0.292048, 0.681445}, 0.007, 1,
     "before T4 lie W and T3 DIFFERS"},
    {21, 76, 46, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7}, 0.0005, 1, {0.0, 0.116484, 0.0, 0.0, 0.0, 0.883516}, 0.019, 0,
     "T4 asks 0.3; T3 at 4.5 asks 0.4375, T2 at 10.5 0.8875: min DIFFERS"},
    {21, 84, 46, {0.5625, 0.4375, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.5625, 0.4375, 0.0, 0.0, 0.0, 0.0}, 0.045, 0,
     "4.5 right of T4"},
    {21, 100, 46, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    /* scene 22: combine = min, occluders = each; weights of the background, W, T1, T2, T3, T4 */
    {22, 55, 45, {0.0, 0.3, 0.21, 0.147, 0.1029, 0.2401}, 0.0005, 1, {0.0, 0.0081, 0.026781, 0.086861, 0.263477, 0.614781}, 0.0005, 1,
     "each 0.3: T4 keeps 0.7^4 DIFFERS"},
    {22, 63, 46, {0.0, 0.3, 0.0, 0.21, 0.147, 0.343}, 0.0005, 1, {0.0, 0.009788, 0.0, 0.089119, 0.270328, 0.630765}, 0.004, 1,
     "each 0.3 DIFFERS"},
    {22, 69, 46, {0.0, 0.3, 0.0, 0.0, 0.21, 0.49}, 0.0005, 1, {0.0, 0.026508, 0.0, 0.0, 0.292048, 0.681445}, 0.007, 1,
     "each 0.3 DIFFERS"},
    {22, 76, 46, {0.0, 0.3, 0.0, 0.0, 0.0, 0.7}, 0.0005, 1, {0.0, 0.116484, 0.0, 0.0, 0.0, 0.883516}, 0.019, 0,
     "min of 0.3, 0.4375, 0.8875 DIFFERS"},
    {22, 84, 46, {0.5625, 0.4375, 0.0, 0.0, 0.0, 0.0}, 0.044, 1, {0.5625, 0.4375, 0.0, 0.0, 0.0, 0.0}, 0.045, 0,
     "4.5 right of T4"},
    /* scene 23: combine = product, occluders = each; weights of the background, W, T1, T2, T3, T4 */
    {23, 55, 45, {0.0, 0.0081, 0.026781, 0.086861, 0.263477, 0.614781}, 0.0005, 1, {0.0, 0.0081, 0.026781, 0.086861, 0.263477, 0.614781}, 0.0005, 0,
     "the wall is left 0.3^4 = 0.0081, the 0.8 % of the design"},
    {23, 63, 46, {0.0, 0.009788, 0.0, 0.089119, 0.270328, 0.630765}, 0.004, 1, {0.0, 0.009788, 0.0, 0.089119, 0.270328, 0.630765}, 0.004, 0,
     "T2, T3, T4 and T1 at 3.5"},
    {23, 69, 46, {0.0, 0.026508, 0.0, 0.0, 0.292048, 0.681445}, 0.007, 1, {0.0, 0.026508, 0.0, 0.0, 0.292048, 0.681445}, 0.007, 0,
     "T3, T4, T2 at 3.5, T1 at 9.5"},
    {23, 76, 46, {0.0, 0.116484, 0.0, 0.0, 0.0, 0.883516}, 0.019, 1, {0.0, 0.116484, 0.0, 0.0, 0.0, 0.883516}, 0.019, 0,
     "T4, T3 at 4.5, T2 at 10.5"},
    {23, 84, 46, {0.5625, 0.4375, 0.0, 0.0, 0.0, 0.0}, 0.045, 1, {0.5625, 0.4375, 0.0, 0.0, 0.0, 0.0}, 0.045, 0,
     "4.5 right of T4"},
    {23, 100, 46, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    /* scene 24: combine = product, occluders = together; weights of the background, W, T1, T2, T3, T4 */
    {24, 55, 45, {0.0, 0.000469, 0.001561, 0.009543, 0.084321, 0.904105}, 0.0005, 1, {0.0, 0.0081, 0.026781, 0.086861, 0.263477, 0.614781}, 0.0005, 1,
     "each mask shared over the occluders before its own target, then multiplied DIFFERS"},
    {24, 63, 46, {0.0, 0.001991, 0.0, 0.018273, 0.109824, 0.869911}, 0.003, 1, {0.0, 0.009788, 0.0, 0.089119, 0.270328, 0.630765}, 0.004, 1,
     "the same with T1 at 3.5 DIFFERS"},
    {24, 69, 46, {0.0, 0.014433, 0.0, 0.0, 0.160983, 0.824585}, 0.005, 1, {0.0, 0.026508, 0.0, 0.0, 0.292048, 0.681445}, 0.007, 1,
     "T4 shared by two, T3 alone DIFFERS"},
    {24, 76, 46, {0.0, 0.116484, 0.0, 0.0, 0.0, 0.883516}, 0.019, 1, {0.0, 0.116484, 0.0, 0.0, 0.0, 0.883516}, 0.019, 0,
     "one occluder: nothing to share"},
    {24, 84, 46, {0.5625, 0.4375, 0.0, 0.0, 0.0, 0.0}, 0.045, 1, {0.5625, 0.4375, 0.0, 0.0, 0.0, 0.0}, 0.045, 0,
     "4.5 right of T4"},
    /* scene 25: active mode: search lights; weights of the background, W, T1, T2, T3 */
    {25, 40, 48, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 0,
     "well inside the first light"},
    {25, 36, 50, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 0,
     "well inside the first light"},
    {25, 42, 44, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 0,
     "well inside the first light"},
    {25, 22, 48, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "T1 outside the lights: hidden"},
    {25, 21, 53, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "T1 outside the lights"},
    {25, 17, 48, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "2.5 left of T1, outside the lights"},
    {25, 46, 48, {0.7125, 0.2875, 0.0, 0.0, 0.0}, 0.044, 1, {0.7125, 0.2875, 0.0, 0.0, 0.0}, 0.044, 0,
     "2.5 right of T1 inside the light"},
    {25, 96, 48, {0.0, 0.3, 0.0, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.7, 0.0}, 0.0005, 0,
     "inside two lights: open once"},
    {25, 102, 50, {0.0, 0.3, 0.0, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.7, 0.0}, 0.0005, 0,
     "inside one light, in the soft edge of another"},
    {25, 81, 48, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "T2 outside the lights"},
    {25, 81, 41, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "T2 outside the lights"},
    {25, 60, 22, {0.0, 0.3, 0.0, 0.0, 0.7}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.7}, 0.0005, 0,
     "passive: needs no light"},
    {25, 73, 22, {0.6375, 0.3625, 0.0, 0.0, 0.0}, 0.044, 1, {0.6375, 0.3625, 0.0, 0.0, 0.0}, 0.044, 0,
     "passive gradient"},
    {25, 64, 76, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "a light on no target opens nothing"},
    {25, 110, 80, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    {25, 40, 44, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0, 0.0}, 0.0005, 0,
     "inside the first light"},
    {25, 46, 51, {0.7125, 0.2875, 0.0, 0.0, 0.0}, 0.044, 1, {0.7125, 0.2875, 0.0, 0.0, 0.0}, 0.044, 0,
     "7.4 from the first light, 2.5 right of T1"},
    {25, 24, 42, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "16.6 from the first light"},
    {25, 90, 48, {0.0, 0.3, 0.0, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.0, 0.7, 0.0}, 0.0005, 0,
     "5.5 from the second light"},
    {25, 58, 18, {0.0, 0.3, 0.0, 0.0, 0.7}, 0.0005, 1, {0.0, 0.3, 0.0, 0.0, 0.7}, 0.0005, 0,
     "passive"},
    {25, 60, 31, {0.6375, 0.3625, 0.0, 0.0, 0.0}, 0.044, 1, {0.6375, 0.3625, 0.0, 0.0, 0.0}, 0.044, 0,
     "passive, 3.5 above"},
    {25, 60, 14, {0.7875, 0.2125, 0.0, 0.0, 0.0}, 0.044, 1, {0.7875, 0.2125, 0.0, 0.0, 0.0}, 0.044, 0,
     "passive, 1.5 below"},
    /* scene 26: nested dolls, the innermost a target; weights of the background, outer, middle, inner */
    {26, 40, 48, {0.0, 0.16334, 0.13666, 0.7}, 0.0005, 1, {0.0, 0.3, 0.21, 0.49}, 0.0005, 0,
     "two shells share DIFFERS"},
    {26, 45, 52, {0.0, 0.16334, 0.13666, 0.7}, 0.0005, 1, {0.0, 0.3, 0.21, 0.49}, 0.0005, 0,
     "two shells share DIFFERS"},
    {26, 54, 48, {0.561854, 0.250431, 0.187715, 0.0}, 0.044, 0, {0.0}, 0.0, 1,
     "sqrt(14.5^2 + 0.5^2) - 10 from the innermost; no back faces"},
    {26, 64, 48, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "14.5 from the innermost"},
    {26, 73, 48, {1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "outside"},
    {26, 34, 44, {0.0, 0.16334, 0.13666, 0.7}, 0.0005, 1, {0.0, 0.3, 0.21, 0.49}, 0.0005, 0,
     "two shells share DIFFERS"},
    {26, 40, 40, {0.0, 0.16334, 0.13666, 0.7}, 0.0005, 1, {0.0, 0.3, 0.21, 0.49}, 0.0005, 0,
     "two shells share DIFFERS"},
    {26, 40, 60, {0.71175, 0.156347, 0.131903, 0.0}, 0.044, 0, {0.0}, 0.0, 1,
     "sqrt(12.5^2 + 0.5^2) - 10"},
    {26, 28, 48, {0.786685, 0.113047, 0.100268, 0.0}, 0.044, 0, {0.0}, 0.0, 1,
     "sqrt(11.5^2 + 0.5^2) - 10"},
    {26, 40, 64, {0.411932, 0.358181, 0.229887, 0.0}, 0.044, 0, {0.0}, 0.0, 1,
     "sqrt(16.5^2 + 0.5^2) - 10"},
    /* scene 27: nested dolls, the middle one a target; weights of the background, outer, middle, inner */
    {27, 40, 48, {0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0}, 0.0005, 0,
     "the inner doll is behind"},
    {27, 45, 58, {0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0}, 0.0005, 0,
     "the inner doll is behind"},
    {27, 64, 48, {0.562117, 0.437883, 0.0, 0.0}, 0.044, 0, {0.0}, 0.0, 1,
     "sqrt(24.5^2 + 0.5^2) - 20 from the middle doll: the outer one comes after it in the group"},
    /* scene 28: nested dolls, the outermost a target; weights of the background, outer, middle, inner */
    {28, 40, 48, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "nothing is before it"},
    {28, 64, 48, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "nothing is before it"},
    {28, 73, 48, {1.0, 0.0, 0.0, 0.0}, 0.0005, 0, {0.0}, 0.0, 0,
     "outside"},
    /* scene 29: one depth, order by rank: shell last; weights of the background, core, shell */
    {29, 60, 48, {0.0, 0.7, 0.3}, 0.0005, 1, {0.0, 0.7, 0.3}, 0.0005, 1,
     "the shell comes after the core in the fixed order: it covers it, and is opened"},
    {29, 52, 42, {0.0, 0.7, 0.3}, 0.0005, 1, {0.0, 0.7, 0.3}, 0.0005, 1,
     "the same"},
    /* scene 30: one depth, order by rank: core last; weights of the background, core, shell */
    {30, 60, 48, {0.0, 1.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0}, 0.0005, 1,
     "the core comes last: it covers the shell"},
    {30, 54, 44, {0.0, 1.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0}, 0.0005, 1,
     "the same"},
    /* scene 31: backdrop; weights of the background, sky, hill, W, T, R */
    {31, 50, 52, {0.0, 0.0, 0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.3, 0.7, 0.0}, 0.0005, 0,
     "one occluder: backdrops are behind"},
    {31, 66, 52, {0.0, 0.7125, 0.0, 0.2875, 0.0, 0.0}, 0.044, 1, {0.0, 0.7125, 0.0, 0.2875, 0.0, 0.0}, 0.044, 0,
     "2.5 right: the backdrop shows"},
    {31, 73, 52, {0.0, 0.0, 0.0, 0.8125, 0.0, 0.1875}, 0.044, 1, {0.0, 0.0, 0.0, 0.8125, 0.0, 0.1875}, 0.044, 0,
     "9.5 right: R before the backdrop"},
    {31, 50, 33, {0.0, 0.0, 0.1125, 0.8875, 0.0, 0.0}, 0.044, 1, {0.0, 0.0, 0.1125, 0.8875, 0.0, 0.0}, 0.044, 0,
     "10.5 below: the nearer backdrop"},
    {31, 50, 39, {0.0, 0.5625, 0.0, 0.4375, 0.0, 0.0}, 0.044, 1, {0.0, 0.5625, 0.0, 0.4375, 0.0, 0.0}, 0.044, 0,
     "4.5 below"},
    {31, 90, 70, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    {31, 10, 60, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "no occluder"},
    {31, 10, 20, {0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 1.0, 0.0, 0.0, 0.0}, 0.0005, 0,
     "no occluder"},
    {31, 44, 48, {0.0, 0.0, 0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.3, 0.7, 0.0}, 0.0005, 0,
     "one occluder"},
    {31, 60, 56, {0.0, 0.0, 0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 0.3, 0.7, 0.0}, 0.0005, 0,
     "one occluder"},
    {31, 36, 52, {0.0, 0.6375, 0.0, 0.3625, 0.0, 0.0}, 0.044, 1, {0.0, 0.6375, 0.0, 0.3625, 0.0, 0.0}, 0.044, 0,
     "3.5 left"},
    {31, 50, 63, {0.0, 0.6375, 0.0, 0.3625, 0.0, 0.0}, 0.044, 1, {0.0, 0.6375, 0.0, 0.3625, 0.0, 0.0}, 0.044, 0,
     "3.5 above"},
    {31, 50, 66, {0.0, 0.4125, 0.0, 0.5875, 0.0, 0.0}, 0.044, 1, {0.0, 0.4125, 0.0, 0.5875, 0.0, 0.0}, 0.044, 0,
     "6.5 above"},
    {31, 73, 48, {0.0, 0.0, 0.0, 0.8125, 0.0, 0.1875}, 0.044, 1, {0.0, 0.0, 0.0, 0.8125, 0.0, 0.1875}, 0.044, 0,
     "9.5 right"},
    {31, 30, 70, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "14.2 from the corner"},
    /* scene 32: backdrop is no occluder count; weights of the background, sky, W, T */
    {32, 50, 52, {0.0, 0.0, 0.3, 0.7}, 0.0005, 1, {0.0, 0.0, 0.3, 0.7}, 0.0005, 0,
     "m is 1"},
    {32, 70, 52, {0.0, 0.0, 0.0, 1.0}, 0.0005, 1, {0.0, 0.0, 0.0, 1.0}, 0.0005, 0,
     "not occluded"},
    {32, 70, 64, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "4.5 above, nothing nearer than the target"},
    {32, 56, 64, {0.0, 0.5625, 0.4375, 0.0}, 0.044, 1, {0.0, 0.5625, 0.4375, 0.0}, 0.044, 0,
     "4.5 above, m is 1"},
    {32, 35, 52, {0.0, 0.5625, 0.4375, 0.0}, 0.044, 1, {0.0, 0.5625, 0.4375, 0.0}, 0.044, 0,
     "4.5 left, m is 1"},
    /* scene 33: hollow sheets, occluders = together; weights of the background, H, T, L */
    {33, 60, 48, {0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.51, 0.49, 0.0}, 0.0005, 0,
     "two sheets before the target share: 0.3 in all DIFFERS"},
    {33, 74, 48, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "the sheet behind shows, opaque: 1 in all"},
    {33, 60, 60, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "1 in all"},
    {33, 60, 68, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "far"},
    {33, 15, 50, {0.0, 0.0, 0.0, 1.0}, 0.0005, 1, {0.0, 0.0, 0.0, 1.0}, 0.0005, 0,
     "beside"},
    {33, 54, 44, {0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.51, 0.49, 0.0}, 0.0005, 0,
     "0.3 in all DIFFERS"},
    {33, 60, 62, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "6.5 above: the sheet behind, 1 in all"},
    {33, 46, 48, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "3.5 left: 1 in all"},
    /* scene 34: hollow sheets, occluders = each; weights of the background, H, T, L */
    {34, 60, 48, {0.0, 0.51, 0.49, 0.0}, 0.0005, 1, {0.0, 0.51, 0.49, 0.0}, 0.0005, 0,
     "each sheet 0.3: 0.51 in all"},
    {34, 74, 48, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "1 in all"},
    /* scene 35: solid sheets, occluders = together; weights of the background, H, T, L */
    {35, 60, 48, {0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0}, 0.0005, 0,
     "front-most sheet alone"},
    {35, 74, 48, {0.0, 0.4375, 0.0, 0.5625}, 0.044, 1, {0.0, 0.4375, 0.0, 0.5625}, 0.044, 0,
     "no further sheet of a solid: L shows"},
    {35, 60, 59, {0.0, 0.3625, 0.0, 0.6375}, 0.044, 1, {0.0, 0.3625, 0.0, 0.6375}, 0.044, 0,
     "L shows"},
    {35, 60, 69, {0.0, 1.0, 0.0, 0.0}, 0.0005, 1, {0.0, 1.0, 0.0, 0.0}, 0.0005, 0,
     "13.5 away: closed"},
    {35, 46, 48, {0.0, 0.3625, 0.0, 0.6375}, 0.044, 1, {0.0, 0.3625, 0.0, 0.6375}, 0.044, 0,
     "L shows"},
    {35, 54, 44, {0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0}, 0.0005, 0,
     "front-most sheet alone"},
    /* scene 36: solid sheets, occluders = each; weights of the background, H, T, L */
    {36, 60, 48, {0.0, 0.3, 0.7, 0.0}, 0.0005, 1, {0.0, 0.3, 0.7, 0.0}, 0.0005, 0,
     "one surface"},
    {36, 74, 48, {0.0, 0.4375, 0.0, 0.5625}, 0.044, 1, {0.0, 0.4375, 0.0, 0.5625}, 0.044, 0,
     "one surface"},
    {36, 60, 61, {0.0, 0.5125, 0.0, 0.4875}, 0.044, 1, {0.0, 0.5125, 0.0, 0.4875}, 0.044, 0,
     "one surface"},
    {36, 76, 48, {0.0, 0.5875, 0.0, 0.4125}, 0.044, 1, {0.0, 0.5875, 0.0, 0.4125}, 0.044, 0,
     "one surface"},
};
enum { DYN_PROBE_COUNT = 376 };

/* clang-format on */

#endif

/* More probe pixels worked out by hand: layers(n), groups, a method per object, Hodges' first
 * rule, hidden lines.  The rules and the readings chosen are in RULES.md; in short:
 *
 * Layers are transparent front-face points (either side of a two-sided object), of whatever
 * object, in order of depth; those at equal depth are one layer, shown by the lowest id.
 * layers(n): the first n layers are candidates, the limit is the (n+1)-th, O is the nearest
 * opaque front face strictly nearer than the limit (none: no limit); shown are the candidates
 * nearer than O, then O or the background.  Back faces play no part; n = 1 is the explicit rule.
 *
 * Groups: the chain starts with the nearest layer; the next front face joins it if it is of
 * another object of the same group (group 0 never joins) and its depth is less than
 * group_distance behind the last of the chain; else the chain ends.  Explicit: the limit is the
 * first layer strictly behind the chain's last.  Default: the limit is the nearer of the nearest
 * back face of one-sided transparent objects strictly behind the chain's last and the first
 * front face, at or behind the chain's last, that did not join.  O as above.
 *
 * Method per object: the rule (default or explicit of probes.h) is that of the object which owns
 * the front-most transparent front face at the pixel.
 *
 * Hodges: factor = 1 - s max(0, 1 - d / D), d the straight distance in space from the seen
 * opaque point to the nearest point of the curves where that object's own surface crosses the
 * surface of any transparent object; 1 without a curve; the same on both sides of the curve.
 *
 * Lines: HIDDEN if an opaque front face lies strictly before the point, else THROUGH if a
 * transparent front face (either side of a two-sided object) lies strictly before it, else
 * VISIBLE.  by_default and by_explicit put the limit of these rules on points of opaque objects
 * as well: at or behind the limit they are HIDDEN.
 *
 * Comments list depths as in probes.h ("1f 9, 1b 11, 4 at 12"); "=" stands between coincident
 * ones.  Trailing surfaces that change no answer are mostly left out. */
#ifndef GLASSINE_TESTS_PROBES_MORE_H
#define GLASSINE_TESTS_PROBES_MORE_H

#include <stddef.h>

#include "probes.h"

/* clang-format off */

/* blended: ids of the blended layers front to back; behind: id of the opaque object or 0 */
typedef struct probe_list { int count; uint32_t blended[5]; uint32_t behind; } probe_list;

typedef struct probe_layers { double u, v; probe_list n1, n2, n3, n5; } probe_layers;

/* each: the same places by the other reading, in which coincident faces are layers of their own
 * in order of ids (limit: nearest front face strictly deeper than the n-th); NULL: no difference */
typedef struct probe_layers_view {
    const char *name; probe_camera camera; int probe_count; const probe_layers *probes, *each;
} probe_layers_view;

typedef struct probe_layers_scene {
    const char *name; int object_count; const probe_object *objects;
    int view_count; const probe_layers_view *views;
} probe_layers_scene;

#define PROBE_ANY_DISTANCE 1e30

typedef struct probe_member { uint32_t id, group; } probe_member;

typedef struct probe_group { double u, v; probe_list by_default, by_explicit; } probe_group;

typedef struct probe_group_view {
    const char *name; probe_camera camera; double group_distance;
    int probe_count; const probe_group *probes;
} probe_group_view;

/* objects without a member entry have group 0 */
typedef struct probe_group_scene {
    const char *name; int object_count; const probe_object *objects;
    int member_count; const probe_member *members;
    int view_count; const probe_group_view *views;
} probe_group_scene;

typedef struct probe_mixed { double u, v; probe_answer answer; } probe_mixed;

/* explicit_ids: the transparent objects with the explicit method, 0 ends; all others default */
typedef struct probe_mixed_view {
    const char *name; probe_camera camera; uint32_t explicit_ids[4];
    int probe_count; const probe_mixed *probes;
} probe_mixed_view;

typedef struct probe_mixed_scene {
    const char *name; int object_count; const probe_object *objects;
    int view_count; const probe_mixed_view *views;
} probe_mixed_scene;

/* point: the opaque point seen; inside: it lies in the transparent object; the answer holds by
 * the default and the explicit rule alike */
typedef struct probe_hodges {
    double u, v; probe_answer answer; double point[3]; bool inside; double distance, factor;
} probe_hodges;

typedef struct probe_hodges_view {
    const char *name; probe_camera camera; double strength, reach;
    int probe_count; const probe_hodges *probes;
} probe_hodges_view;

typedef struct probe_hodges_scene {
    const char *name; int object_count; const probe_object *objects;
    int view_count; const probe_hodges_view *views;
} probe_hodges_scene;

typedef enum probe_line_class {
    PROBE_LINE_UNSTATED, PROBE_LINE_VISIBLE, PROBE_LINE_THROUGH, PROBE_LINE_HIDDEN
} probe_line_class;

/* a point in world space on an edge of the object */
typedef struct probe_line {
    uint32_t object; double point[3]; probe_line_class line, by_default, by_explicit;
} probe_line;

typedef struct probe_line_scene {
    const char *name; int object_count; const probe_object *objects; probe_camera camera;
    int probe_count; const probe_line *probes;
} probe_line_scene;

/* an object with a plain colour, for rules that speak of ids only */
#define PROBE_GLASS(id, array) { id, true, false, {0.4, 0.6, 0.8}, 0.5, PROBE_COUNT(array), array }
#define PROBE_SHEET(id, array) { id, true, true, {0.4, 0.8, 0.6}, 0.5, PROBE_COUNT(array), array }
#define PROBE_SOLID(id, array) { id, false, false, {0.8, 0.5, 0.2}, 1.0, PROBE_COUNT(array), array }

/* ==== A. layers(n) ====================================================================== */

/* ---- A1: five shells around a core ---------------------------------------------------- */

/* from outside to inside 3, 1, 5, 2, 4, half edges 3.5, 3, 2.5, 2, 1.5 */
static const probe_polygon probe_a1_p3[] = { PROBE_BOX(-3.5, 3.5, -3.5, 3.5, -3.5, 3.5) };
static const probe_polygon probe_a1_p1[] = { PROBE_BOX(-3.0, 3.0, -3.0, 3.0, -3.0, 3.0) };
static const probe_polygon probe_a1_p5[] = { PROBE_BOX(-2.5, 2.5, -2.5, 2.5, -2.5, 2.5) };
static const probe_polygon probe_a1_p2[] = { PROBE_BOX(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0) };
static const probe_polygon probe_a1_p4[] = { PROBE_BOX(-1.5, 1.5, -1.5, 1.5, -1.5, 1.5) };
static const probe_polygon probe_a1_p6[] = { PROBE_BOX(-0.8, 0.8, -0.5, 0.5, -1.0, 1.0) };       /* core */
static const probe_polygon probe_a1_p7[] = { PROBE_BOX(-1.3, -0.5, 0.75, 1.35, 2.55, 2.95) };    /* between 1 and 5, +z side */
static const probe_polygon probe_a1_p8[] = { PROBE_BOX(-0.3, 0.4, -1.35, -0.75, -3.45, -3.05) }; /* between 3 and 1, -z side */
static const probe_polygon probe_a1_p9[] = { PROBE_BOX(0.6, 3.9, -1.35, -0.75, -5.0, -4.5) };    /* beyond all, past their side */
static const probe_polygon probe_a1_p10[] = { PROBE_BOX(-1.3, -0.5, -1.35, -0.75, 3.6, 3.95) };  /* before all */
static const probe_polygon probe_a1_p11[] = { PROBE_BOX(-0.3, 0.4, 0.75, 1.35, 1.55, 1.95) };    /* between 2 and 4, +z side */
static const probe_polygon probe_a1_p12[] = { PROBE_BOX(0.6, 1.3, 0.75, 1.35, 2.1, 2.9) };       /* through z = 2.5 of 5 */

static const probe_object probe_a1_objects[] = {
    PROBE_GLASS(1, probe_a1_p1), PROBE_GLASS(2, probe_a1_p2), PROBE_GLASS(3, probe_a1_p3),
    PROBE_GLASS(4, probe_a1_p4), PROBE_GLASS(5, probe_a1_p5), PROBE_SOLID(6, probe_a1_p6),
    PROBE_SOLID(7, probe_a1_p7), PROBE_SOLID(8, probe_a1_p8), PROBE_SOLID(9, probe_a1_p9),
    PROBE_SOLID(10, probe_a1_p10), PROBE_SOLID(11, probe_a1_p11), PROBE_SOLID(12, probe_a1_p12),
};

/* limits where all five are before: n = 1: 1f 7, 2: 5f 7.5, 3: 2f 8, 5: none */
static const probe_layers probe_a1_front[] = {
    /* x 0, y 0: 3f 6.5, 1f 7, 5f 7.5, 2f 8, 4f 8.5, 6 at 9 */
    { 0.0, 0.0, {1, {3}, 0}, {2, {3, 1}, 0}, {3, {3, 1, 5}, 0}, {5, {3, 1, 5, 2, 4}, 6} },
    /* x -0.9, y 1.05: 3f 6.5, 1f 7, 7 at 7.05, 5f 7.5 */
    { -0.225, 0.2625, {1, {3}, 0}, {2, {3, 1}, 7}, {2, {3, 1}, 7}, {2, {3, 1}, 7} },
    /* x 0.05, y 1.05: 3f 6.5, 1f 7, 5f 7.5, 2f 8, 11 at 8.05, 4f 8.5; for n = 3 the limit 8 lies before 11 */
    { 0.0125, 0.2625, {1, {3}, 0}, {2, {3, 1}, 0}, {3, {3, 1, 5}, 0}, {4, {3, 1, 5, 2}, 11} },
    /* x 0.95, y 1.05: 3f 6.5, 1f 7, 12 at 7.1, 5f 7.5 */
    { 0.2375, 0.2625, {1, {3}, 0}, {2, {3, 1}, 12}, {2, {3, 1}, 12}, {2, {3, 1}, 12} },
    /* x -0.9, y -1.05: 10 at 6.05, 3f 6.5 */
    { -0.225, -0.2625, {0, {0}, 10}, {0, {0}, 10}, {0, {0}, 10}, {0, {0}, 10} },
    /* x 0.05, y -1.05: 3f 6.5, 1f 7, 5f 7.5, 2f 8, 4f 8.5, 4b 11.5, 2b 12, 5b 12.5, 1b 13, 8 at 13.05 */
    { 0.0125, -0.2625, {1, {3}, 0}, {2, {3, 1}, 0}, {3, {3, 1, 5}, 0}, {5, {3, 1, 5, 2, 4}, 8} },
    /* x 0.95, y -1.05: 3f 6.5, 1f 7, 5f 7.5, 2f 8, 4f 8.5, 4b 11.5, 2b 12, 5b 12.5, 1b 13, 3b 13.5, 9 at 14.5 */
    { 0.2375, -0.2625, {1, {3}, 0}, {2, {3, 1}, 0}, {3, {3, 1, 5}, 0}, {5, {3, 1, 5, 2, 4}, 9} },
    /* x 1.75, y -1.05: 3f 6.5, 1f 7, 5f 7.5, 2f 8, 2b 12, 5b 12.5, 1b 13, 3b 13.5, 9 at 14.5 */
    { 0.4375, -0.2625, {1, {3}, 0}, {2, {3, 1}, 0}, {3, {3, 1, 5}, 0}, {4, {3, 1, 5, 2}, 9} },
    /* x 2.25, y -1.05: 3f 6.5, 1f 7, 5f 7.5, 5b 12.5, 1b 13, 3b 13.5, 9 at 14.5; n = 3 has no limit */
    { 0.5625, -0.2625, {1, {3}, 0}, {2, {3, 1}, 0}, {3, {3, 1, 5}, 9}, {3, {3, 1, 5}, 9} },
    /* x 2.75, y -1.05: 3f 6.5, 1f 7, 1b 13, 3b 13.5, 9 at 14.5 */
    { 0.6875, -0.2625, {1, {3}, 0}, {2, {3, 1}, 9}, {2, {3, 1}, 9}, {2, {3, 1}, 9} },
    /* x 3.25, y -1.05: 3f 6.5, 3b 13.5, 9 at 14.5 */
    { 0.8125, -0.2625, {1, {3}, 9}, {1, {3}, 9}, {1, {3}, 9}, {1, {3}, 9} },
    /* x 3.7, y -1.05: 9 at 14.5 */
    { 0.925, -0.2625, {0, {0}, 9}, {0, {0}, 9}, {0, {0}, 9}, {0, {0}, 9} },
    /* x -2.75, y 0: 3f 6.5, 1f 7, 1b 13, 3b 13.5 */
    { -0.6875, 0.0, {1, {3}, 0}, {2, {3, 1}, 0}, {2, {3, 1}, 0}, {2, {3, 1}, 0} },
    /* x -3.25, y 0: 3f 6.5, 3b 13.5 */
    { -0.8125, 0.0, {1, {3}, 0}, {1, {3}, 0}, {1, {3}, 0}, {1, {3}, 0} },
    /* x -1.75, y 1.05: 3f 6.5, 1f 7, 5f 7.5, 2f 8, 2b 12 */
    { -0.4375, 0.2625, {1, {3}, 0}, {2, {3, 1}, 0}, {3, {3, 1, 5}, 0}, {4, {3, 1, 5, 2}, 0} },
    /* x -3.75, y 0: nothing */
    { -0.9375, 0.0, {0, {0}, 0}, {0, {0}, 0}, {0, {0}, 0}, {0, {0}, 0} },
};

/* from +x the same depths of the shells */
static const probe_layers probe_a1_side[] = {
    /* z 0, y 0: 3f 6.5, 1f 7, 5f 7.5, 2f 8, 4f 8.5, 6 at 9.2 */
    { 0.0, 0.0, {1, {3}, 0}, {2, {3, 1}, 0}, {3, {3, 1, 5}, 0}, {5, {3, 1, 5, 2, 4}, 6} },
    /* z 2.3, y 1.05: 3f 6.5, 1f 7, 5f 7.5, 12 at 8.7; beside 2 */
    { -0.575, 0.2625, {1, {3}, 0}, {2, {3, 1}, 0}, {3, {3, 1, 5}, 12}, {3, {3, 1, 5}, 12} },
    /* z 2.7, y 1.05: 3f 6.5, 1f 7, 12 at 8.7; beside 5 */
    { -0.675, 0.2625, {1, {3}, 0}, {2, {3, 1}, 12}, {2, {3, 1}, 12}, {2, {3, 1}, 12} },
    /* z 1.75, y 1.05: 3f 6.5, 1f 7, 5f 7.5, 2f 8, 11 at 9.6; beside 4 */
    { -0.4375, 0.2625, {1, {3}, 0}, {2, {3, 1}, 0}, {3, {3, 1, 5}, 0}, {4, {3, 1, 5, 2}, 11} },
    /* z -3.25, y -1.05: 3f 6.5, 8 at 9.6; beside 1 */
    { 0.8125, -0.2625, {1, {3}, 8}, {1, {3}, 8}, {1, {3}, 8}, {1, {3}, 8} },
    /* z 3.775, y -1.05: 10 at 10.5; beside all */
    { -0.94375, -0.2625, {0, {0}, 10}, {0, {0}, 10}, {0, {0}, 10}, {0, {0}, 10} },
};

static const probe_layers_view probe_a1_views[] = {
    { "front", PROBE_FROM_ZP, PROBE_COUNT(probe_a1_front), probe_a1_front, NULL },
    { "side", PROBE_FROM_XP, PROBE_COUNT(probe_a1_side), probe_a1_side, NULL },
};

/* ---- A2: three boxes that interpenetrate ---------------------------------------------- */

static const probe_polygon probe_a2_p1[] = { PROBE_BOX(-3.0, 1.0, -2.5, 2.5, -1.0, 2.0) };
static const probe_polygon probe_a2_p2[] = { PROBE_BOX(-1.0, 3.0, -2.0, 2.0, -2.0, 1.0) };
static const probe_polygon probe_a2_p3[] = { PROBE_BOX(-2.0, 2.0, -1.5, 1.5, -3.0, 0.0) };
static const probe_polygon probe_a2_p4[] = { PROBE_BOX(-0.7, 0.7, 0.6, 1.2, -0.8, -0.3) };    /* in all three */
static const probe_polygon probe_a2_p5[] = { PROBE_BOX(1.25, 1.8, 0.6, 1.2, -1.8, -1.2) };    /* in 2 and 3 */
static const probe_polygon probe_a2_p6[] = { PROBE_BOX(-1.8, -1.2, 0.6, 1.2, 0.4, 0.8) };     /* in 1 only */
static const probe_polygon probe_a2_p7[] = { PROBE_BOX(-0.7, 0.7, -0.3, 0.3, 0.2, 0.8) };     /* in 1 and 2 */
static const probe_polygon probe_a2_p8[] = { PROBE_BOX(-2.8, 2.8, -1.2, -0.6, -0.5, 0.5) };   /* a bar through all */
static const probe_polygon probe_a2_p9[] = { PROBE_BOX(-0.7, 0.7, 1.55, 1.95, -4.0, -3.5) };  /* beyond all */
static const probe_polygon probe_a2_p10[] = { PROBE_BOX(2.3, 3.7, 0.6, 1.2, -3.0, -2.5) };    /* beyond 2, past its side */

static const probe_object probe_a2_objects[] = {
    PROBE_GLASS(1, probe_a2_p1), PROBE_GLASS(2, probe_a2_p2), PROBE_GLASS(3, probe_a2_p3),
    PROBE_SOLID(4, probe_a2_p4), PROBE_SOLID(5, probe_a2_p5), PROBE_SOLID(6, probe_a2_p6),
    PROBE_SOLID(7, probe_a2_p7), PROBE_SOLID(8, probe_a2_p8), PROBE_SOLID(9, probe_a2_p9),
    PROBE_SOLID(10, probe_a2_p10),
};

static const probe_layers probe_a2_front[] = {
    /* x 0, y 0.9: 1f 8, 2f 9, 3f 10, 4 at 10.3 */
    { 0.0, 0.225, {1, {1}, 0}, {2, {1, 2}, 0}, {3, {1, 2, 3}, 4}, {3, {1, 2, 3}, 4} },
    /* x 1.5, y 0.9: 2f 9, 3f 10, 5 at 11.2 */
    { 0.375, 0.225, {1, {2}, 0}, {2, {2, 3}, 5}, {2, {2, 3}, 5}, {2, {2, 3}, 5} },
    /* x -1.5, y 0.9: 1f 8, 6 at 9.2, 3f 10 */
    { -0.375, 0.225, {1, {1}, 6}, {1, {1}, 6}, {1, {1}, 6}, {1, {1}, 6} },
    /* x 0, y 0: 1f 8, 2f 9, 7 at 9.2, 3f 10 */
    { 0.0, 0.0, {1, {1}, 0}, {2, {1, 2}, 7}, {2, {1, 2}, 7}, {2, {1, 2}, 7} },
    /* x -2.4, y -0.9: 1f 8, 8 at 9.5 */
    { -0.6, -0.225, {1, {1}, 8}, {1, {1}, 8}, {1, {1}, 8}, {1, {1}, 8} },
    /* x -1.5, y -0.9: 1f 8, 8 at 9.5, 3f 10 */
    { -0.375, -0.225, {1, {1}, 8}, {1, {1}, 8}, {1, {1}, 8}, {1, {1}, 8} },
    /* x 0, y -0.9: 1f 8, 2f 9, 8 at 9.5, 3f 10 */
    { 0.0, -0.225, {1, {1}, 0}, {2, {1, 2}, 8}, {2, {1, 2}, 8}, {2, {1, 2}, 8} },
    /* x 1.5, y -0.9: 2f 9, 8 at 9.5, 3f 10 */
    { 0.375, -0.225, {1, {2}, 8}, {1, {2}, 8}, {1, {2}, 8}, {1, {2}, 8} },
    /* x 0, y 1.75: 1f 8, 2f 9, 1b 11, 2b 12, 9 at 13.5; beside 3 */
    { 0.0, 0.4375, {1, {1}, 0}, {2, {1, 2}, 9}, {2, {1, 2}, 9}, {2, {1, 2}, 9} },
    /* x 2.65, y 0.9: 2f 9, 2b 12, 10 at 12.5 */
    { 0.6625, 0.225, {1, {2}, 10}, {1, {2}, 10}, {1, {2}, 10}, {1, {2}, 10} },
    /* x 3.4, y 0.9: 10 at 12.5 */
    { 0.85, 0.225, {0, {0}, 10}, {0, {0}, 10}, {0, {0}, 10}, {0, {0}, 10} },
    /* x 0, y -1.75: 1f 8, 2f 9, 1b 11, 2b 12 */
    { 0.0, -0.4375, {1, {1}, 0}, {2, {1, 2}, 0}, {2, {1, 2}, 0}, {2, {1, 2}, 0} },
    /* x -1.5, y 0: 1f 8, 3f 10, 1b 11, 3b 13 */
    { -0.375, 0.0, {1, {1}, 0}, {2, {1, 3}, 0}, {2, {1, 3}, 0}, {2, {1, 3}, 0} },
    /* x 1.5, y 0: 2f 9, 3f 10, 2b 12, 3b 13 */
    { 0.375, 0.0, {1, {2}, 0}, {2, {2, 3}, 0}, {2, {2, 3}, 0}, {2, {2, 3}, 0} },
};

/* from -x: 1f 7, 1b 11 over z -1..2; 3f 8, 3b 12 over z -3..0; 2f 9, 2b 13 over z -2..1 */
static const probe_layers probe_a2_side[] = {
    /* z -0.55, y 0.9: 1f 7, 3f 8, 2f 9, 4 at 9.3 */
    { -0.1375, 0.225, {1, {1}, 0}, {2, {1, 3}, 0}, {3, {1, 3, 2}, 4}, {3, {1, 3, 2}, 4} },
    /* z -1.5, y 0.9: 3f 8, 2f 9, 5 at 11.25 */
    { -0.375, 0.225, {1, {3}, 0}, {2, {3, 2}, 5}, {2, {3, 2}, 5}, {2, {3, 2}, 5} },
    /* z 0.6, y 0.9: 1f 7, 6 at 8.2, 2f 9 */
    { 0.15, 0.225, {1, {1}, 6}, {1, {1}, 6}, {1, {1}, 6}, {1, {1}, 6} },
    /* z 0.5, y 0: 1f 7, 2f 9, 7 at 9.3 */
    { 0.125, 0.0, {1, {1}, 0}, {2, {1, 2}, 7}, {2, {1, 2}, 7}, {2, {1, 2}, 7} },
    /* z -0.25, y -0.9: 1f 7, 8 at 7.2, 3f 8 */
    { -0.0625, -0.225, {1, {1}, 8}, {1, {1}, 8}, {1, {1}, 8}, {1, {1}, 8} },
    /* z -3.75, y 1.75: 9 at 9.3 */
    { -0.9375, 0.4375, {0, {0}, 9}, {0, {0}, 9}, {0, {0}, 9}, {0, {0}, 9} },
    /* z -2.75, y 0.9: 3f 8, 3b 12, 10 at 12.3 */
    { -0.6875, 0.225, {1, {3}, 10}, {1, {3}, 10}, {1, {3}, 10}, {1, {3}, 10} },
};

static const probe_layers_view probe_a2_views[] = {
    { "front", PROBE_FROM_ZP, PROBE_COUNT(probe_a2_front), probe_a2_front, NULL },
    { "side", PROBE_FROM_XN, PROBE_COUNT(probe_a2_side), probe_a2_side, NULL },
};

/* ---- A3: faces that coincide ----------------------------------------------------------- */

/* 5 and 2 share z = 2 over x -1..1; 6 and 7 share z = -1.5 over x -0.5..2.  The list of
 * objects is not in order of ids. */
static const probe_polygon probe_a3_p5[] = { PROBE_BOX(-3.0, 1.0, -2.0, 2.0, -1.0, 2.0) };
static const probe_polygon probe_a3_p2[] = { PROBE_BOX(-1.0, 3.0, -1.8, 1.8, 0.0, 2.0) };
static const probe_polygon probe_a3_p7[] = { PROBE_BOX(-2.0, 2.0, -1.5, 1.5, -3.0, -1.5) };
static const probe_polygon probe_a3_p6[] = { PROBE_BOX(-0.5, 3.2, -1.7, 1.7, -3.5, -1.5) };
static const probe_polygon probe_a3_p1[] = { PROBE_BOX(-0.3, 0.3, 0.5, 1.1, 0.5, 1.5) };      /* in 5 and 2 */
static const probe_polygon probe_a3_p3[] = { PROBE_BOX(-0.3, 0.3, -1.1, -0.5, -2.5, -2.0) };  /* in 6 and 7 */
static const probe_polygon probe_a3_p4[] = { PROBE_BOX(-0.3, 0.5, -0.3, 0.3, -4.5, -4.0) };   /* beyond all */
static const probe_polygon probe_a3_p9[] = { PROBE_BOX(-1.8, -1.2, 0.5, 1.1, -2.8, -2.2) };   /* in 7 */
static const probe_polygon probe_a3_p10[] = { PROBE_BOX(2.2, 2.8, 0.5, 1.1, -3.0, -2.4) };    /* in 6 */

static const probe_object probe_a3_objects[] = {
    PROBE_GLASS(7, probe_a3_p7), PROBE_GLASS(5, probe_a3_p5), PROBE_GLASS(2, probe_a3_p2),
    PROBE_GLASS(6, probe_a3_p6), PROBE_SOLID(1, probe_a3_p1), PROBE_SOLID(3, probe_a3_p3),
    PROBE_SOLID(4, probe_a3_p4), PROBE_SOLID(9, probe_a3_p9), PROBE_SOLID(10, probe_a3_p10),
};

static const probe_layers probe_a3_front[] = {
    /* x 0, y 0.8: 2f 8 = 5f 8, 1 at 8.5 */
    { 0.0, 0.2, {1, {2}, 1}, {1, {2}, 1}, {1, {2}, 1}, {1, {2}, 1} },
    /* x 0, y -0.8: 2f 8 = 5f 8, 2b 10, 5b 11, 6f 11.5 = 7f 11.5, 3 at 12 */
    { 0.0, -0.2, {1, {2}, 0}, {2, {2, 6}, 3}, {2, {2, 6}, 3}, {2, {2, 6}, 3} },
    /* x 0.1, y 0: 2f 8 = 5f 8, 2b 10, 5b 11, 6f 11.5 = 7f 11.5, 7b 13, 6b 13.5, 4 at 14 */
    { 0.025, 0.0, {1, {2}, 0}, {2, {2, 6}, 4}, {2, {2, 6}, 4}, {2, {2, 6}, 4} },
    /* x -1.5, y 0.8: 5f 8, 5b 11, 7f 11.5, 9 at 12.2 */
    { -0.375, 0.2, {1, {5}, 0}, {2, {5, 7}, 9}, {2, {5, 7}, 9}, {2, {5, 7}, 9} },
    /* x 2.5, y 0.8: 2f 8, 2b 10, 6f 11.5, 10 at 12.4 */
    { 0.625, 0.2, {1, {2}, 0}, {2, {2, 6}, 10}, {2, {2, 6}, 10}, {2, {2, 6}, 10} },
    /* x 1.5, y 0: 2f 8, 2b 10, 6f 11.5 = 7f 11.5 */
    { 0.375, 0.0, {1, {2}, 0}, {2, {2, 6}, 0}, {2, {2, 6}, 0}, {2, {2, 6}, 0} },
    /* x -0.75, y 0: 2f 8 = 5f 8, 2b 10, 5b 11, 7f 11.5 */
    { -0.1875, 0.0, {1, {2}, 0}, {2, {2, 7}, 0}, {2, {2, 7}, 0}, {2, {2, 7}, 0} },
    /* x -2.5, y 0: 5f 8, 5b 11 */
    { -0.625, 0.0, {1, {5}, 0}, {1, {5}, 0}, {1, {5}, 0}, {1, {5}, 0} },
    /* x 0.65, y -0.8: 2f 8 = 5f 8, 2b 10, 5b 11, 6f 11.5 = 7f 11.5 */
    { 0.1625, -0.2, {1, {2}, 0}, {2, {2, 6}, 0}, {2, {2, 6}, 0}, {2, {2, 6}, 0} },
    /* x 2.5, y -0.8: 2f 8, 2b 10, 6f 11.5, 6b 13.5 */
    { 0.625, -0.2, {1, {2}, 0}, {2, {2, 6}, 0}, {2, {2, 6}, 0}, {2, {2, 6}, 0} },
};

/* the other reading: 2, then 5, then 6, then 7, each one layer */
static const probe_layers probe_a3_each[] = {
    /* x 0, y 0.8: 2f 8 = 5f 8, 1 at 8.5 */
    { 0.0, 0.2, {1, {2}, 1}, {2, {2, 5}, 1}, {2, {2, 5}, 1}, {2, {2, 5}, 1} },
    /* x 0, y -0.8: 2f 8 = 5f 8, 2b 10, 5b 11, 6f 11.5 = 7f 11.5, 3 at 12 */
    { 0.0, -0.2, {1, {2}, 0}, {2, {2, 5}, 0}, {3, {2, 5, 6}, 3}, {4, {2, 5, 6, 7}, 3} },
    /* x 0.1, y 0: 2f 8 = 5f 8, 2b 10, 5b 11, 6f 11.5 = 7f 11.5, 7b 13, 6b 13.5, 4 at 14 */
    { 0.025, 0.0, {1, {2}, 0}, {2, {2, 5}, 0}, {3, {2, 5, 6}, 4}, {4, {2, 5, 6, 7}, 4} },
    /* x -1.5, y 0.8: 5f 8, 5b 11, 7f 11.5, 9 at 12.2 */
    { -0.375, 0.2, {1, {5}, 0}, {2, {5, 7}, 9}, {2, {5, 7}, 9}, {2, {5, 7}, 9} },
    /* x 2.5, y 0.8: 2f 8, 2b 10, 6f 11.5, 10 at 12.4 */
    { 0.625, 0.2, {1, {2}, 0}, {2, {2, 6}, 10}, {2, {2, 6}, 10}, {2, {2, 6}, 10} },
    /* x 1.5, y 0: 2f 8, 2b 10, 6f 11.5 = 7f 11.5 */
    { 0.375, 0.0, {1, {2}, 0}, {2, {2, 6}, 0}, {3, {2, 6, 7}, 0}, {3, {2, 6, 7}, 0} },
    /* x -0.75, y 0: 2f 8 = 5f 8, 2b 10, 5b 11, 7f 11.5 */
    { -0.1875, 0.0, {1, {2}, 0}, {2, {2, 5}, 0}, {3, {2, 5, 7}, 0}, {3, {2, 5, 7}, 0} },
    /* x -2.5, y 0: 5f 8, 5b 11 */
    { -0.625, 0.0, {1, {5}, 0}, {1, {5}, 0}, {1, {5}, 0}, {1, {5}, 0} },
    /* x 0.65, y -0.8: 2f 8 = 5f 8, 2b 10, 5b 11, 6f 11.5 = 7f 11.5 */
    { 0.1625, -0.2, {1, {2}, 0}, {2, {2, 5}, 0}, {3, {2, 5, 6}, 0}, {4, {2, 5, 6, 7}, 0} },
    /* x 2.5, y -0.8: 2f 8, 2b 10, 6f 11.5, 6b 13.5 */
    { 0.625, -0.2, {1, {2}, 0}, {2, {2, 6}, 0}, {2, {2, 6}, 0}, {2, {2, 6}, 0} },
};

static const probe_layers_view probe_a3_views[] = {
    { "front", PROBE_FROM_ZP, PROBE_COUNT(probe_a3_front), probe_a3_front, probe_a3_each },
};

/* ---- A4: the eye inside, and open sheets ---------------------------------------------- */

/* 1 around the eye; 3 inside 2 inside 1; beyond 1 the two-sided sheets 4 (seen from behind) and
 * 5 (seen from its outside) */
static const probe_polygon probe_a4_p1[] = { PROBE_BOX(-4.0, 4.0, -4.0, 4.0, -10.0, 2.0) };
static const probe_polygon probe_a4_p2[] = { PROBE_BOX(-2.0, -0.4, -0.8, 1.6, -8.0, -4.0) };
static const probe_polygon probe_a4_p3[] = { PROBE_BOX(-1.8, -0.6, -0.6, 1.0, -7.0, -5.0) };
static const probe_polygon probe_a4_p4[] = { PROBE_FACE_ZN(-12.0, -6.0, 6.0, -9.0, 0.0) };
static const probe_polygon probe_a4_p5[] = { PROBE_FACE_ZP(-14.0, -10.0, 10.0, -12.0, 2.8) };
static const probe_polygon probe_a4_p6[] = { PROBE_BOX(-1.4, -0.8, -0.2, 0.6, -6.5, -5.5) };     /* in 3 */
static const probe_polygon probe_a4_p7[] = { PROBE_BOX(-3.2, -1.4, 2.2, 3.2, -9.2, -9.0) };      /* in 1, beyond 2 */
static const probe_polygon probe_a4_p8[] = { PROBE_BOX(1.1, 3.3, -3.3, -1.1, -11.5, -11.0) };    /* between 1 and 4 */
static const probe_polygon probe_a4_p9[] = { PROBE_BOX(1.3, 3.9, -7.8, -6.2, -13.5, -13.0) };    /* between 4 and 5 */
static const probe_polygon probe_a4_p10[] = { PROBE_BOX(6.4, 14.4, -4.8, -2.4, -17.0, -16.0) };  /* beyond 5 */
static const probe_polygon probe_a4_p12[] = { PROBE_BOX(-10.4, -6.0, 0.3, 2.6, -17.0, -16.0) };  /* beyond 5 */
static const probe_polygon probe_a4_p13[] = { PROBE_BOX(-6.4, -2.4, -3.2, 0.05, -17.0, -16.0) }; /* beyond 5 */

static const probe_object probe_a4_objects[] = {
    PROBE_GLASS(1, probe_a4_p1), PROBE_GLASS(2, probe_a4_p2), PROBE_GLASS(3, probe_a4_p3),
    PROBE_SHEET(4, probe_a4_p4), PROBE_SHEET(5, probe_a4_p5), PROBE_SOLID(6, probe_a4_p6),
    PROBE_SOLID(7, probe_a4_p7), PROBE_SOLID(8, probe_a4_p8), PROBE_SOLID(9, probe_a4_p9),
    PROBE_SOLID(10, probe_a4_p10), PROBE_SOLID(12, probe_a4_p12), PROBE_SOLID(13, probe_a4_p13),
};

/* Eye at the origin, half width 1: at depth d the ray is at x = u d, y = v d.  1 shows back
 * faces only.  2f 4: u -0.5..-0.1, v -0.2..0.4; 3f 5: u -0.36..-0.12, v -0.12..0.2;
 * 4f 12: u -0.5..0.5, v -0.75..0; 5f 14: u -0.714..0.714, v -0.857..0.2. */
static const probe_layers probe_a4_inside[] = {
    /* 2f 4, 3f 5, 6 at 5.5 (u -0.255..-0.145, v -0.036..0.109) */
    { -0.2, 0.036, {1, {2}, 0}, {2, {2, 3}, 6}, {2, {2, 3}, 6}, {2, {2, 3}, 6} },
    /* 2f 4, 2b 5.333, 7 at 9 (u -0.356..-0.156, v 0.244..0.356) */
    { -0.25, 0.3, {1, {2}, 7}, {1, {2}, 7}, {1, {2}, 7}, {1, {2}, 7} },
    /* 1b 10, 8 at 11 (u 0.1..0.3, v -0.3..-0.1), no front face before it */
    { 0.2, -0.2, {0, {0}, 8}, {0, {0}, 8}, {0, {0}, 8}, {0, {0}, 8} },
    /* 1b 7.407, 4f 12, 9 at 13 (u 0.1..0.3, v -0.6..-0.477), 5f 14 */
    { 0.2, -0.54, {1, {4}, 9}, {1, {4}, 9}, {1, {4}, 9}, {1, {4}, 9} },
    /* 1b 8.889, 4f 12, 5f 14, 10 at 16 (u 0.4..0.9, v -0.3..-0.15) */
    { 0.45, -0.22, {1, {4}, 0}, {2, {4, 5}, 10}, {2, {4, 5}, 10}, {2, {4, 5}, 10} },
    /* 1b 6.667, 5f 14, 10 at 16; beside 4 */
    { 0.6, -0.22, {1, {5}, 10}, {1, {5}, 10}, {1, {5}, 10}, {1, {5}, 10} },
    /* 1b 5.128, 10 at 16; beside both sheets */
    { 0.78, -0.22, {0, {0}, 10}, {0, {0}, 10}, {0, {0}, 10}, {0, {0}, 10} },
    /* 1b 10, 4f 12, 5f 14 */
    { -0.2, -0.3, {1, {4}, 0}, {2, {4, 5}, 0}, {2, {4, 5}, 0}, {2, {4, 5}, 0} },
    /* 1b 10, 5f 14; over 4 */
    { 0.2, 0.1, {1, {5}, 0}, {1, {5}, 0}, {1, {5}, 0}, {1, {5}, 0} },
    /* 1b 8 */
    { 0.2, 0.5, {0, {0}, 0}, {0, {0}, 0}, {0, {0}, 0}, {0, {0}, 0} },
    /* 2f 4, 3f 5, 3b 6, 2b 6.667, 1b 10, 5f 14 */
    { -0.3, 0.1, {1, {2}, 0}, {2, {2, 3}, 0}, {3, {2, 3, 5}, 0}, {3, {2, 3, 5}, 0} },
    /* 2f 4, 2b 4.444, 1b 8.889, 5f 14, 12 at 16 (u -0.65..-0.375, v 0.019..0.163) */
    { -0.45, 0.09, {1, {2}, 0}, {2, {2, 5}, 12}, {2, {2, 5}, 12}, {2, {2, 5}, 12} },
    /* 1b 7.143, 5f 14, 12 at 16; beside 2 */
    { -0.56, 0.09, {1, {5}, 12}, {1, {5}, 12}, {1, {5}, 12}, {1, {5}, 12} },
    /* 2f 4, 3f 5, 3b 5.806, 2b 6.452, 1b 10, 4f 12, 5f 14, 13 at 16 (u -0.4..-0.15, v -0.2..0.003) */
    { -0.31, -0.043, {1, {2}, 0}, {2, {2, 3}, 0}, {3, {2, 3, 4}, 0}, {4, {2, 3, 4, 5}, 13} },
};

static const probe_layers_view probe_a4_views[] = {
    { "inside", { true, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1.0, 0.1, 30.0 },
      PROBE_COUNT(probe_a4_inside), probe_a4_inside, NULL },
};

/* ---- A5: the concave object of scene 2: its own second front face is the second layer --- */

/* from +z: over x -2..2: 1f 8, 1b 9, 1f 11, 1b 12; over x -3..-2: 1f 8, 1b 12 */
static const probe_layers probe_a5_front[] = {
    /* x -1, y 1.2: 1f 8, 2 at 8.2 */
    { -0.25, 0.3, {1, {1}, 2}, {1, {1}, 2}, {1, {1}, 2}, {1, {1}, 2} },
    /* x 1, y 1.2: 1f 8, 1b 9, 1f 11, 3 at 11.2 */
    { 0.25, 0.3, {1, {1}, 0}, {2, {1, 1}, 3}, {2, {1, 1}, 3}, {2, {1, 1}, 3} },
    /* x -1, y 0: 1f 8, 1b 9, 4 at 9.5, 1f 11 */
    { -0.25, 0.0, {1, {1}, 4}, {1, {1}, 4}, {1, {1}, 4}, {1, {1}, 4} },
    /* x 1.5, y -1.2: 1f 8, 1b 9, 7 at 9.5, 1f 11 */
    { 0.375, -0.3, {1, {1}, 7}, {1, {1}, 7}, {1, {1}, 7}, {1, {1}, 7} },
    /* x -2.7, y -1.2: 1f 8, 1b 12, 9 at 13 */
    { -0.675, -0.3, {1, {1}, 9}, {1, {1}, 9}, {1, {1}, 9}, {1, {1}, 9} },
    /* x -0.2, y 0.6: 1f 8, 1b 9, 1f 11, 1b 12 */
    { -0.05, 0.15, {1, {1}, 0}, {2, {1, 1}, 0}, {2, {1, 1}, 0}, {2, {1, 1}, 0} },
};

static const probe_layers_view probe_a5_views[] = {
    { "front", PROBE_FROM_ZP, PROBE_COUNT(probe_a5_front), probe_a5_front, NULL },
};

static const probe_layers_scene probe_layers_scenes[] = {
    { "five shells", PROBE_COUNT(probe_a1_objects), probe_a1_objects, PROBE_COUNT(probe_a1_views), probe_a1_views },
    { "three intersecting", PROBE_COUNT(probe_a2_objects), probe_a2_objects, PROBE_COUNT(probe_a2_views), probe_a2_views },
    { "coincident layers", PROBE_COUNT(probe_a3_objects), probe_a3_objects, PROBE_COUNT(probe_a3_views), probe_a3_views },
    { "eye inside, sheets", PROBE_COUNT(probe_a4_objects), probe_a4_objects, PROBE_COUNT(probe_a4_views), probe_a4_views },
    { "concave", PROBE_COUNT(probe_s2_objects), probe_s2_objects, PROBE_COUNT(probe_a5_views), probe_a5_views },
};

/* ==== B. groups ========================================================================== */

/* ---- B1: five shells, all of group 1 ---------------------------------------------------- */

/* From +z the front faces are 0.8, 0.3, 1.2, 0.3 apart: 1f 6.5, 2f 7.3, 3f 7.6, 4f 8.8, 5f 9.1,
 * 5b 10.9, 4b 11.2, 3b 12.4, 2b 12.7, 1b 13.5; from +x 0.5: 1f 6.5, 2f 7, 3f 7.5, 4f 8, 5f 8.5. */
static const probe_polygon probe_b1_p1[] = { PROBE_BOX(-3.5, 3.5, -3.5, 3.5, -3.5, 3.5) };
static const probe_polygon probe_b1_p2[] = { PROBE_BOX(-3.0, 3.0, -3.0, 3.0, -2.7, 2.7) };
static const probe_polygon probe_b1_p3[] = { PROBE_BOX(-2.5, 2.5, -2.5, 2.5, -2.4, 2.4) };
static const probe_polygon probe_b1_p4[] = { PROBE_BOX(-2.0, 2.0, -2.0, 2.0, -1.2, 1.2) };
static const probe_polygon probe_b1_p5[] = { PROBE_BOX(-1.5, 1.5, -1.5, 1.5, -0.9, 0.9) };
static const probe_polygon probe_b1_p6[] = { PROBE_BOX(-0.4, 0.4, -0.4, 0.4, -0.5, 0.5) };       /* core */
static const probe_polygon probe_b1_p7[] = { PROBE_BOX(-1.3, -0.5, 0.75, 1.35, 1.5, 2.0) };      /* between 3 and 4, +z side */
static const probe_polygon probe_b1_p8[] = { PROBE_BOX(0.5, 1.3, 0.75, 1.35, 2.9, 3.3) };        /* between 1 and 2, +z side */
static const probe_polygon probe_b1_p9[] = { PROBE_BOX(-1.3, -0.5, -1.35, -0.75, -2.0, -1.5) };  /* between 4 and 3, -z side */
static const probe_polygon probe_b1_p10[] = { PROBE_BOX(0.5, 3.9, -1.35, -0.75, -4.5, -4.0) };   /* beyond all, past their side */

static const probe_object probe_b1_objects[] = {
    PROBE_GLASS(1, probe_b1_p1), PROBE_GLASS(2, probe_b1_p2), PROBE_GLASS(3, probe_b1_p3),
    PROBE_GLASS(4, probe_b1_p4), PROBE_GLASS(5, probe_b1_p5), PROBE_SOLID(6, probe_b1_p6),
    PROBE_SOLID(7, probe_b1_p7), PROBE_SOLID(8, probe_b1_p8), PROBE_SOLID(9, probe_b1_p9),
    PROBE_SOLID(10, probe_b1_p10),
};

static const probe_member probe_b1_members[] = { {1, 1}, {2, 1}, {3, 1}, {4, 1}, {5, 1} };

/* any distance: all join, no front face limits */
static const probe_group probe_b1_any[] = {
    /* x 0, y 0: 1f 6.5, 2f 7.3, 3f 7.6, 4f 8.8, 5f 9.1, 6 at 9.5, 5b 10.9 */
    { 0.0, 0.0, {5, {1, 2, 3, 4, 5}, 6}, {5, {1, 2, 3, 4, 5}, 6} },
    /* x -0.9, y 1.05: 1f 6.5, 2f 7.3, 3f 7.6, 7 at 8, 4f 8.8 */
    { -0.225, 0.2625, {3, {1, 2, 3}, 7}, {3, {1, 2, 3}, 7} },
    /* x 0.9, y 1.05: 1f 6.5, 8 at 6.7, 2f 7.3 */
    { 0.225, 0.2625, {1, {1}, 8}, {1, {1}, 8} },
    /* x -0.9, y -1.05: 1f 6.5, 2f 7.3, 3f 7.6, 4f 8.8, 5f 9.1, 5b 10.9, 4b 11.2, 9 at 11.5; default limit 10.9 */
    { -0.225, -0.2625, {5, {1, 2, 3, 4, 5}, 0}, {5, {1, 2, 3, 4, 5}, 9} },
    /* x 0.9, y -1.05: 1f 6.5, 2f 7.3, 3f 7.6, 4f 8.8, 5f 9.1, 5b 10.9, 4b 11.2, 3b 12.4, 2b 12.7, 1b 13.5, 10 at 14 */
    { 0.225, -0.2625, {5, {1, 2, 3, 4, 5}, 0}, {5, {1, 2, 3, 4, 5}, 10} },
    /* x 1.75, y -1.05: 1f 6.5, 2f 7.3, 3f 7.6, 4f 8.8, 4b 11.2, 3b 12.4, 2b 12.7, 1b 13.5, 10 at 14 */
    { 0.4375, -0.2625, {4, {1, 2, 3, 4}, 0}, {4, {1, 2, 3, 4}, 10} },
    /* x 3.25, y -1.05: 1f 6.5, 1b 13.5, 10 at 14 */
    { 0.8125, -0.2625, {1, {1}, 0}, {1, {1}, 10} },
    /* x 3.7, y -1.05: 10 at 14 */
    { 0.925, -0.2625, {0, {0}, 10}, {0, {0}, 10} },
    /* x -2.25, y 0: 1f 6.5, 2f 7.3, 3f 7.6, 3b 12.4 */
    { -0.5625, 0.0, {3, {1, 2, 3}, 0}, {3, {1, 2, 3}, 0} },
};

/* distance 1: steps 0.8 and 0.3 join (3f is 1.1 behind 1f, but 0.3 behind 2f), 1.2 does not: 4f 8.8 limits */
static const probe_group probe_b1_one[] = {
    /* x 0, y 0: 1f 6.5, 2f 7.3, 3f 7.6, 4f 8.8, 5f 9.1, 6 at 9.5 */
    { 0.0, 0.0, {3, {1, 2, 3}, 0}, {3, {1, 2, 3}, 0} },
    /* x -0.9, y 1.05: 1f 6.5, 2f 7.3, 3f 7.6, 7 at 8, 4f 8.8 */
    { -0.225, 0.2625, {3, {1, 2, 3}, 7}, {3, {1, 2, 3}, 7} },
    /* x 0.9, y 1.05: 1f 6.5, 8 at 6.7, 2f 7.3 */
    { 0.225, 0.2625, {1, {1}, 8}, {1, {1}, 8} },
    /* x -0.9, y -1.05: 1f 6.5, 2f 7.3, 3f 7.6, 4f 8.8, 5f 9.1, 5b 10.9, 4b 11.2, 9 at 11.5 */
    { -0.225, -0.2625, {3, {1, 2, 3}, 0}, {3, {1, 2, 3}, 0} },
    /* x 2.25, y -1.05: 1f 6.5, 2f 7.3, 3f 7.6, 3b 12.4, 2b 12.7, 1b 13.5, 10 at 14 */
    { 0.5625, -0.2625, {3, {1, 2, 3}, 0}, {3, {1, 2, 3}, 10} },
    /* x 1.75, y -1.05: 1f 6.5, 2f 7.3, 3f 7.6, 4f 8.8, 4b 11.2, 3b 12.4, 2b 12.7, 1b 13.5, 10 at 14 */
    { 0.4375, -0.2625, {3, {1, 2, 3}, 0}, {3, {1, 2, 3}, 0} },
};

/* distance 0.5: the step 0.8 does not join: 2f 7.3 limits */
static const probe_group probe_b1_half[] = {
    /* x 0, y 0: 1f 6.5, 2f 7.3, 3f 7.6, 4f 8.8, 5f 9.1, 6 at 9.5 */
    { 0.0, 0.0, {1, {1}, 0}, {1, {1}, 0} },
    /* x 0.9, y 1.05: 1f 6.5, 8 at 6.7, 2f 7.3 */
    { 0.225, 0.2625, {1, {1}, 8}, {1, {1}, 8} },
    /* x -0.9, y 1.05: 1f 6.5, 2f 7.3, 3f 7.6, 7 at 8 */
    { -0.225, 0.2625, {1, {1}, 0}, {1, {1}, 0} },
    /* x 3.25, y -1.05: 1f 6.5, 1b 13.5, 10 at 14 */
    { 0.8125, -0.2625, {1, {1}, 0}, {1, {1}, 10} },
    /* x 2.75, y -1.05: 1f 6.5, 2f 7.3, 2b 12.7, 1b 13.5, 10 at 14 */
    { 0.6875, -0.2625, {1, {1}, 0}, {1, {1}, 0} },
};

/* from +x, distance 0.7: all steps of 0.5 join */
static const probe_group probe_b1_side[] = {
    /* z 0, y 0: 1f 6.5, 2f 7, 3f 7.5, 4f 8, 5f 8.5, 6 at 9.6, 5b 11.5 */
    { 0.0, 0.0, {5, {1, 2, 3, 4, 5}, 6}, {5, {1, 2, 3, 4, 5}, 6} },
    /* z 1.75, y 1.05: 1f 6.5, 2f 7, 3f 7.5, 7 at 10.5, 3b 12.5; beside 4 */
    { -0.4375, 0.2625, {3, {1, 2, 3}, 7}, {3, {1, 2, 3}, 7} },
    /* z 3.1, y 1.05: 1f 6.5, 8 at 8.7; beside 2 */
    { -0.775, 0.2625, {1, {1}, 8}, {1, {1}, 8} },
    /* z -1.75, y -1.05: 1f 6.5, 2f 7, 3f 7.5, 9 at 10.5, 3b 12.5 */
    { 0.4375, -0.2625, {3, {1, 2, 3}, 9}, {3, {1, 2, 3}, 9} },
};

/* from +x, distance 0.3: none joins */
static const probe_group probe_b1_side_near[] = {
    /* z 0, y 0: 1f 6.5, 2f 7, 3f 7.5, 4f 8, 5f 8.5, 6 at 9.6 */
    { 0.0, 0.0, {1, {1}, 0}, {1, {1}, 0} },
    /* z 1.75, y 1.05: 1f 6.5, 2f 7, 3f 7.5, 7 at 10.5 */
    { -0.4375, 0.2625, {1, {1}, 0}, {1, {1}, 0} },
    /* z 3.1, y 1.05: 1f 6.5, 8 at 8.7 */
    { -0.775, 0.2625, {1, {1}, 8}, {1, {1}, 8} },
};

static const probe_group_view probe_b1_views[] = {
    { "any distance", PROBE_FROM_ZP, PROBE_ANY_DISTANCE, PROBE_COUNT(probe_b1_any), probe_b1_any },
    { "distance 1", PROBE_FROM_ZP, 1.0, PROBE_COUNT(probe_b1_one), probe_b1_one },
    { "distance 0.5", PROBE_FROM_ZP, 0.5, PROBE_COUNT(probe_b1_half), probe_b1_half },
    { "side, distance 0.7", PROBE_FROM_XP, 0.7, PROBE_COUNT(probe_b1_side), probe_b1_side },
    { "side, distance 0.3", PROBE_FROM_XP, 0.3, PROBE_COUNT(probe_b1_side_near), probe_b1_side_near },
};

/* ---- B2: plates one behind the other, of several groups --------------------------------- */

/* groups: 1 and 3 of 1, 2 of 2, 4 and 5 of none */
static const probe_polygon probe_b2_p1[] = { PROBE_BOX(-3.0, 1.0, -2.0, 2.0, 2.0, 3.0) };
static const probe_polygon probe_b2_p2[] = { PROBE_BOX(-1.0, 3.0, -1.8, 1.8, 0.0, 1.0) };
static const probe_polygon probe_b2_p3[] = { PROBE_BOX(-2.0, 2.0, -1.5, 1.5, -2.0, -1.0) };
static const probe_polygon probe_b2_p4[] = { PROBE_BOX(-2.5, 2.5, -1.1, 1.1, -4.0, -3.0) };
static const probe_polygon probe_b2_p5[] = { PROBE_BOX(-3.0, 3.0, -1.0, 1.0, -5.5, -4.5) };
static const probe_polygon probe_b2_p6[] = { PROBE_BOX(-0.7, -0.1, 0.3, 0.9, 1.3, 1.7) };      /* between 1 and 2 */
static const probe_polygon probe_b2_p7[] = { PROBE_BOX(-1.8, -1.2, 0.3, 0.9, -0.7, -0.3) };    /* between 1 and 3 */
static const probe_polygon probe_b2_p8[] = { PROBE_BOX(-1.8, -1.2, -0.9, -0.3, -1.8, -1.2) };  /* in 3, behind 1 */
static const probe_polygon probe_b2_p9[] = { PROBE_BOX(0.2, 0.8, -0.9, -0.3, -1.8, -1.2) };    /* in 3, behind 1 and 2 */
static const probe_polygon probe_b2_p10[] = { PROBE_BOX(2.75, 3.8, 0.3, 0.9, -7.0, -6.5) };    /* beyond all */

static const probe_object probe_b2_objects[] = {
    PROBE_GLASS(1, probe_b2_p1), PROBE_GLASS(2, probe_b2_p2), PROBE_GLASS(3, probe_b2_p3),
    PROBE_GLASS(4, probe_b2_p4), PROBE_GLASS(5, probe_b2_p5), PROBE_SOLID(6, probe_b2_p6),
    PROBE_SOLID(7, probe_b2_p7), PROBE_SOLID(8, probe_b2_p8), PROBE_SOLID(9, probe_b2_p9),
    PROBE_SOLID(10, probe_b2_p10),
};

static const probe_member probe_b2_members[] = { {1, 1}, {2, 2}, {3, 1} };

static const probe_group probe_b2_any[] = {
    /* x -0.4, y 0.6: 1f 7, 1b 8, 6 at 8.3, 2f 9 (another group: explicit limit 9) */
    { -0.1, 0.15, {1, {1}, 0}, {1, {1}, 6} },
    /* BETWEEN: x -1.5, y 0.6: 1f 7, 1b 8, 7 at 10.3, 3f 11 (joins), 3b 12, 4f 13; limits 12 and 13 */
    { -0.375, 0.15, {1, {1}, 7}, {1, {1}, 7} },
    /* x -1.5, y -0.6: 1f 7, 1b 8, 3f 11 (joins), 8 at 11.2, 3b 12 */
    { -0.375, -0.15, {2, {1, 3}, 8}, {2, {1, 3}, 8} },
    /* x 0.5, y -0.6: 1f 7, 1b 8, 2f 9 (another group), 2b 10, 3f 11, 9 at 11.2 */
    { 0.125, -0.15, {1, {1}, 0}, {1, {1}, 0} },
    /* x 1.5, y 0: 2f 9, 2b 10, 3f 11 (another group), 3b 12, 4f 13, 4b 14, 5f 14.5 */
    { 0.375, 0.0, {1, {2}, 0}, {1, {2}, 0} },
    /* x -1.5, y 0: 1f 7, 1b 8, 3f 11, 3b 12, 4f 13 (of no group), 4b 14, 5f 14.5 */
    { -0.375, 0.0, {2, {1, 3}, 0}, {2, {1, 3}, 0} },
    /* x -2.25, y 0: 1f 7, 1b 8, 4f 13, 4b 14, 5f 14.5 */
    { -0.5625, 0.0, {1, {1}, 0}, {1, {1}, 0} },
    /* x -1.5, y 1.3: 1f 7, 1b 8, 3f 11, 3b 12; over 4 */
    { -0.375, 0.325, {2, {1, 3}, 0}, {2, {1, 3}, 0} },
    /* x 3.4, y 0.6: 10 at 16.5; beside all */
    { 0.85, 0.15, {0, {0}, 10}, {0, {0}, 10} },
};

/* from -z: 5f 4.5, 5b 5.5, 4f 6, 4b 7, 3f 8, 3b 9, 2f 10, 2b 11, 1f 12, 1b 13 */
static const probe_group probe_b2_rear[] = {
    /* x 0, y 0: 5f 4.5, 5b 5.5, 4f 6 (both of no group: does not join), 4b 7, 3f 8, 3b 9, 2f 10, 2b 11, 1f 12 */
    { 0.0, 0.0, {1, {5}, 0}, {1, {5}, 0} },
    /* x -1.5, y 1.3: 3f 8, 3b 9, 1f 12 (joins), 1b 13 */
    { 0.375, 0.325, {2, {3, 1}, 0}, {2, {3, 1}, 0} },
    /* x 0, y 1.3: 3f 8, 3b 9, 2f 10 (another group), 2b 11, 1f 12 */
    { 0.0, 0.325, {1, {3}, 0}, {1, {3}, 0} },
    /* x 3.4, y 0.6: 10 at 3 */
    { -0.85, 0.15, {0, {0}, 10}, {0, {0}, 10} },
};

/* distance 3: 3f is 4 behind 1f and does not join */
static const probe_group probe_b2_three[] = {
    /* x -1.5, y -0.6: 1f 7, 1b 8, 3f 11, 8 at 11.2 */
    { -0.375, -0.15, {1, {1}, 0}, {1, {1}, 0} },
    /* x -1.5, y 0.6: 1f 7, 1b 8, 7 at 10.3, 3f 11; limits 8 and 11 */
    { -0.375, 0.15, {1, {1}, 0}, {1, {1}, 7} },
    /* x -1.5, y 1.3: 1f 7, 1b 8, 3f 11 */
    { -0.375, 0.325, {1, {1}, 0}, {1, {1}, 0} },
};

/* distance 4.5: 3f joins (the gap from 1b to 3f is 3, from front to front 4) */
static const probe_group probe_b2_four[] = {
    /* x -1.5, y -0.6: 1f 7, 1b 8, 3f 11, 8 at 11.2, 3b 12 */
    { -0.375, -0.15, {2, {1, 3}, 8}, {2, {1, 3}, 8} },
    /* x -1.5, y 1.3: 1f 7, 1b 8, 3f 11, 3b 12 */
    { -0.375, 0.325, {2, {1, 3}, 0}, {2, {1, 3}, 0} },
};

/* distance 3.5: front to front 4 counts, not the gap 3 */
static const probe_group probe_b2_gap[] = {
    /* x -1.5, y -0.6: 1f 7, 1b 8, 3f 11, 8 at 11.2 */
    { -0.375, -0.15, {1, {1}, 0}, {1, {1}, 0} },
};

static const probe_group_view probe_b2_views[] = {
    { "any distance", PROBE_FROM_ZP, PROBE_ANY_DISTANCE, PROBE_COUNT(probe_b2_any), probe_b2_any },
    { "rear", PROBE_FROM_ZN, PROBE_ANY_DISTANCE, PROBE_COUNT(probe_b2_rear), probe_b2_rear },
    { "distance 3", PROBE_FROM_ZP, 3.0, PROBE_COUNT(probe_b2_three), probe_b2_three },
    { "distance 4.5", PROBE_FROM_ZP, 4.5, PROBE_COUNT(probe_b2_four), probe_b2_four },
    { "distance 3.5", PROBE_FROM_ZP, 3.5, PROBE_COUNT(probe_b2_gap), probe_b2_gap },
};

/* ---- B3: one group, boxes that interpenetrate and faces that coincide ------------------- */

/* 1 and 2 share z = 2 over x -1..1: one layer, shown by 1 (layers of their own by the other
 * reading: {1, 2, ...} where {1, ...} stands at probes marked SHARED) */
static const probe_polygon probe_b3_p1[] = { PROBE_BOX(-3.0, 1.0, -2.0, 2.0, -1.0, 2.0) };
static const probe_polygon probe_b3_p2[] = { PROBE_BOX(-1.0, 3.0, -1.8, 1.8, -2.0, 2.0) };
static const probe_polygon probe_b3_p3[] = { PROBE_BOX(-2.0, 2.4, -1.5, 1.5, -3.0, 1.0) };
static const probe_polygon probe_b3_p4[] = { PROBE_BOX(-0.5, 0.5, 0.4, 1.0, 0.2, 0.8) };      /* in all three */
static const probe_polygon probe_b3_p5[] = { PROBE_BOX(-0.5, 0.5, -1.0, -0.4, -1.8, -1.2) };  /* in 2 and 3 */
static const probe_polygon probe_b3_p6[] = { PROBE_BOX(-1.8, -1.2, 0.4, 1.0, 1.2, 1.7) };     /* in 1 only */
static const probe_polygon probe_b3_p7[] = { PROBE_BOX(-0.5, 0.5, -0.2, 0.2, 1.2, 1.7) };     /* in 1 and 2 */

static const probe_object probe_b3_objects[] = {
    PROBE_GLASS(2, probe_b3_p2), PROBE_GLASS(1, probe_b3_p1), PROBE_GLASS(3, probe_b3_p3),
    PROBE_SOLID(4, probe_b3_p4), PROBE_SOLID(5, probe_b3_p5), PROBE_SOLID(6, probe_b3_p6),
    PROBE_SOLID(7, probe_b3_p7),
};

static const probe_member probe_b3_members[] = { {1, 7}, {2, 7}, {3, 7} };

static const probe_group probe_b3_any[] = {
    /* SHARED: x 0, y 0.7: 1f 8 = 2f 8, 3f 9, 4 at 9.2, 1b 11 */
    { 0.0, 0.175, {2, {1, 3}, 4}, {2, {1, 3}, 4} },
    /* SHARED: x 0, y -0.7: 1f 8 = 2f 8, 3f 9, 1b 11, 5 at 11.2; default limit 1b 11 */
    { 0.0, -0.175, {2, {1, 3}, 0}, {2, {1, 3}, 5} },
    /* x -1.5, y 0.7: 1f 8, 6 at 8.3, 3f 9 */
    { -0.375, 0.175, {1, {1}, 6}, {1, {1}, 6} },
    /* SHARED: x 0, y 0: 1f 8 = 2f 8 (of the group: does not limit), 7 at 8.3, 3f 9 */
    { 0.0, 0.0, {1, {1}, 7}, {1, {1}, 7} },
    /* x 1.7, y 0: 2f 8, 3f 9, 2b 12 */
    { 0.425, 0.0, {2, {2, 3}, 0}, {2, {2, 3}, 0} },
    /* SHARED: x 0.75, y 0: 1f 8 = 2f 8, 3f 9, 1b 11, 2b 12 */
    { 0.1875, 0.0, {2, {1, 3}, 0}, {2, {1, 3}, 0} },
};

/* distance 0.5: 3f 9 does not join and limits; 2f joins 1f at distance 0 */
static const probe_group probe_b3_half[] = {
    /* SHARED: x 0, y 0.7: 1f 8 = 2f 8, 3f 9, 4 at 9.2 */
    { 0.0, 0.175, {1, {1}, 0}, {1, {1}, 0} },
    /* SHARED: x 0, y 0: 1f 8 = 2f 8, 7 at 8.3, 3f 9 */
    { 0.0, 0.0, {1, {1}, 7}, {1, {1}, 7} },
    /* x -1.5, y 0.7: 1f 8, 6 at 8.3, 3f 9 */
    { -0.375, 0.175, {1, {1}, 6}, {1, {1}, 6} },
};

static const probe_group_view probe_b3_views[] = {
    { "any distance", PROBE_FROM_ZP, PROBE_ANY_DISTANCE, PROBE_COUNT(probe_b3_any), probe_b3_any },
    { "distance 0.5", PROBE_FROM_ZP, 0.5, PROBE_COUNT(probe_b3_half), probe_b3_half },
};

/* ---- B4: the same objects, 2 in a group of its own -------------------------------------- */

/* by default 2f 8, of another group and at F, ends the chain and limits; by the explicit rule the
 * coincident faces are one layer, that of 1, and the chain goes on */
static const probe_member probe_b4_members[] = { {1, 1}, {2, 2}, {3, 1} };

static const probe_group probe_b4_any[] = {
    /* x 0, y 0: 1f 8 = 2f 8 (another group), 7 at 8.3, 3f 9 */
    { 0.0, 0.0, {1, {1}, 0}, {1, {1}, 7} },
    /* x 0, y 0.7: 1f 8 = 2f 8 (another group), 3f 9, 4 at 9.2 */
    { 0.0, 0.175, {1, {1}, 0}, {2, {1, 3}, 4} },
    /* x -1.5, y 0.7: 1f 8, 6 at 8.3, 3f 9 */
    { -0.375, 0.175, {1, {1}, 6}, {1, {1}, 6} },
    /* x 1.7, y 0: 2f 8, 3f 9 (another group), 2b 12 */
    { 0.425, 0.0, {1, {2}, 0}, {1, {2}, 0} },
    /* x -1.5, y 0: 1f 8, 3f 9 (joins), 1b 11, 3b 13 */
    { -0.375, 0.0, {2, {1, 3}, 0}, {2, {1, 3}, 0} },
};

static const probe_group_view probe_b4_views[] = {
    { "any distance", PROBE_FROM_ZP, PROBE_ANY_DISTANCE, PROBE_COUNT(probe_b4_any), probe_b4_any },
};

#define PROBE_GROUP_SCENE(name, o, m, v) \
    { name, PROBE_COUNT(o), o, PROBE_COUNT(m), m, PROBE_COUNT(v), v }

static const probe_group_scene probe_group_scenes[] = {
    PROBE_GROUP_SCENE("shells of one group", probe_b1_objects, probe_b1_members, probe_b1_views),
    PROBE_GROUP_SCENE("plates of several groups", probe_b2_objects, probe_b2_members, probe_b2_views),
    PROBE_GROUP_SCENE("coincident in a group", probe_b3_objects, probe_b3_members, probe_b3_views),
    PROBE_GROUP_SCENE("coincident across groups", probe_b3_objects, probe_b4_members, probe_b4_views),
};

/* ==== C. a method per object =============================================================== */

/* ---- C1: two intersecting boxes ----------------------------------------------------------- */

static const probe_polygon probe_c1_p1[] = { PROBE_BOX(-3.0, 1.0, -2.0, 2.0, -1.0, 2.0) };
static const probe_polygon probe_c1_p2[] = { PROBE_BOX(-1.0, 3.0, -1.8, 1.8, -2.0, 1.0) };
static const probe_polygon probe_c1_p3[] = { PROBE_BOX(-2.6, -1.6, 0.6, 1.4, -3.0, -2.0) };   /* on the -z side of 1 */
static const probe_polygon probe_c1_p4[] = { PROBE_BOX(1.5, 2.5, 0.6, 1.4, -4.0, -3.0) };     /* on the -z side of 2 */
static const probe_polygon probe_c1_p5[] = { PROBE_BOX(-0.5, 0.5, 0.6, 1.4, 1.2, 1.8) };      /* in 1, before 2 */
static const probe_polygon probe_c1_p6[] = { PROBE_BOX(-0.5, 0.5, -1.4, -0.6, -0.8, -0.2) };  /* in both */
static const probe_polygon probe_c1_p7[] = { PROBE_BOX(1.5, 2.5, -1.4, -0.6, -0.8, -0.2) };   /* in 2 */
static const probe_polygon probe_c1_p8[] = { PROBE_BOX(-2.6, -1.6, -1.4, -0.6, 0.0, 0.5) };   /* in 1 */
static const probe_polygon probe_c1_p9[] = { PROBE_BOX(-2.6, -1.6, -0.3, 0.3, 3.0, 3.5) };    /* on the +z side of 1 */
static const probe_polygon probe_c1_p10[] = { PROBE_BOX(1.5, 2.5, -0.3, 0.3, 3.0, 3.5) };     /* on the +z side of 2 */

static const probe_object probe_c1_objects[] = {
    PROBE_GLASS(1, probe_c1_p1), PROBE_GLASS(2, probe_c1_p2), PROBE_SOLID(3, probe_c1_p3),
    PROBE_SOLID(4, probe_c1_p4), PROBE_SOLID(5, probe_c1_p5), PROBE_SOLID(6, probe_c1_p6),
    PROBE_SOLID(7, probe_c1_p7), PROBE_SOLID(8, probe_c1_p8), PROBE_SOLID(9, probe_c1_p9),
    PROBE_SOLID(10, probe_c1_p10),
};

/* 1 default, 2 explicit; from +z: 1f 8, 1b 11 over x -3..1; 2f 9, 2b 12 over x -1..3 */
static const probe_mixed probe_c1_front[] = {
    { -0.525, 0.25, {1, 0} },     /* x -2.1, y 1: 1f 8, 1b 11, 3 at 12; 1 default: limit 1b 11 */
    { 0.5, 0.25, {2, 4} },        /* x 2, y 1: 2f 9, 2b 12, 4 at 13; 2 explicit: no limit */
    { 0.0, 0.25, {1, 5} },        /* x 0, y 1: 1f 8, 5 at 8.2, 2f 9 */
    { 0.0, -0.25, {1, 0} },       /* x 0, y -1: 1f 8, 2f 9, 6 at 10.2; limit 2f 9 */
    { 0.5, -0.25, {2, 7} },       /* x 2, y -1: 2f 9, 7 at 10.2, 2b 12 */
    { -0.525, -0.25, {1, 8} },    /* x -2.1, y -1: 1f 8, 8 at 9.5, 1b 11 */
    { -0.525, 0.0, {0, 9} },      /* x -2.1, y 0: 9 at 6.5, 1f 8 */
    { 0.5, 0.0, {0, 10} },        /* x 2, y 0: 10 at 6.5, 2f 9 */
    { 0.0, 0.0, {1, 0} },         /* x 0, y 0: 1f 8, 2f 9, 1b 11, 2b 12 */
};

/* 1 default, 2 explicit; from -z: 2f 8, 2b 11 over x -1..3; 1f 9, 1b 12 over x -3..1 */
static const probe_mixed probe_c1_rear[] = {
    { 0.525, 0.25, {0, 3} },      /* x -2.1, y 1: 3 at 7, 1f 9 */
    { -0.5, 0.25, {0, 4} },       /* x 2, y 1: 4 at 6, 2f 8 */
    { 0.0, 0.25, {2, 0} },        /* x 0, y 1: 2f 8, 1f 9, 2b 11, 5 at 11.2; limit 1f 9 */
    { 0.0, -0.25, {2, 0} },       /* x 0, y -1: 2f 8, 1f 9, 6 at 9.2 */
    { -0.5, -0.25, {2, 7} },      /* x 2, y -1: 2f 8, 7 at 9.2, 2b 11 */
    { 0.525, -0.25, {1, 8} },     /* x -2.1, y -1: 1f 9, 8 at 10, 1b 12 */
    { 0.525, 0.0, {1, 0} },       /* x -2.1, y 0: 1f 9, 1b 12, 9 at 13; 1 default: limit 12 */
    { -0.5, 0.0, {2, 10} },       /* x 2, y 0: 2f 8, 2b 11, 10 at 13; 2 explicit: no limit */
    { 0.0, 0.0, {2, 0} },         /* x 0, y 0: 2f 8, 1f 9, 2b 11, 1b 12 */
};

/* 1 explicit, 2 default */
static const probe_mixed probe_c1_front_swapped[] = {
    { -0.525, 0.25, {1, 3} },     /* x -2.1, y 1: 1f 8, 1b 11, 3 at 12; 1 explicit */
    { 0.5, 0.25, {2, 0} },        /* x 2, y 1: 2f 9, 2b 12, 4 at 13; 2 default */
    { 0.0, 0.25, {1, 5} },        /* x 0, y 1: 1f 8, 5 at 8.2, 2f 9 */
    { 0.0, -0.25, {1, 0} },       /* x 0, y -1: 1f 8, 2f 9, 6 at 10.2 */
    { 0.5, -0.25, {2, 7} },       /* x 2, y -1: 2f 9, 7 at 10.2, 2b 12 */
};

static const probe_mixed probe_c1_rear_swapped[] = {
    { 0.525, 0.0, {1, 9} },       /* x -2.1, y 0: 1f 9, 1b 12, 9 at 13; 1 explicit */
    { -0.5, 0.0, {2, 0} },        /* x 2, y 0: 2f 8, 2b 11, 10 at 13; 2 default */
    { 0.0, 0.25, {2, 0} },        /* x 0, y 1: 2f 8, 1f 9, 2b 11, 5 at 11.2 */
    { 0.525, -0.25, {1, 8} },     /* x -2.1, y -1: 1f 9, 8 at 10, 1b 12 */
};

static const probe_mixed_view probe_c1_views[] = {
    { "front, 2 explicit", PROBE_FROM_ZP, {2}, PROBE_COUNT(probe_c1_front), probe_c1_front },
    { "rear, 2 explicit", PROBE_FROM_ZN, {2}, PROBE_COUNT(probe_c1_rear), probe_c1_rear },
    { "front, 1 explicit", PROBE_FROM_ZP, {1}, PROBE_COUNT(probe_c1_front_swapped), probe_c1_front_swapped },
    { "rear, 1 explicit", PROBE_FROM_ZN, {1}, PROBE_COUNT(probe_c1_rear_swapped), probe_c1_rear_swapped },
};

/* ---- C2: where the back face of another object makes the difference ----------------------- */

/* 2 pokes out of 1 at its +z side, so that a ray meets 2f, 1f, 1b or 2f, 1f, 2b first; and 4 lies
 * wholly before 1.  From +z: 1f 9, 1b 12; 2f 8, 2b 10 over x -2..0; 4f 6, 4b 7 over x 0.6..2.4 */
static const probe_polygon probe_c2_p1[] = { PROBE_BOX(-3.0, 3.0, -2.0, 2.0, -2.0, 1.0) };
static const probe_polygon probe_c2_p2[] = { PROBE_BOX(-2.0, 0.0, -1.5, 1.5, 0.0, 2.0) };
static const probe_polygon probe_c2_p4[] = { PROBE_BOX(0.6, 2.4, -1.5, 1.5, 3.0, 4.0) };
static const probe_polygon probe_c2_p5[] = { PROBE_BOX(-1.3, -0.7, 0.5, 1.1, 1.2, 1.6) };     /* in 2, before 1 */
static const probe_polygon probe_c2_p6[] = { PROBE_BOX(-1.3, -0.7, -0.3, 0.3, 0.3, 0.7) };    /* in both */
static const probe_polygon probe_c2_p7[] = { PROBE_BOX(1.2, 1.8, 0.5, 1.1, 1.5, 2.0) };       /* between 4 and 1 */
static const probe_polygon probe_c2_p8[] = { PROBE_BOX(1.2, 1.8, -1.1, -0.5, -1.0, 0.0) };    /* in 1, behind 4 */
static const probe_polygon probe_c2_p9[] = { PROBE_BOX(2.6, 3.6, -0.4, 0.4, -4.0, -3.0) };    /* beyond 1, past its side */
static const probe_polygon probe_c2_p10[] = { PROBE_BOX(-2.8, -2.2, 0.5, 1.1, -4.0, -3.0) };  /* beyond 1 */

static const probe_object probe_c2_objects[] = {
    PROBE_GLASS(1, probe_c2_p1), PROBE_GLASS(2, probe_c2_p2), PROBE_GLASS(4, probe_c2_p4),
    PROBE_SOLID(5, probe_c2_p5), PROBE_SOLID(6, probe_c2_p6), PROBE_SOLID(7, probe_c2_p7),
    PROBE_SOLID(8, probe_c2_p8), PROBE_SOLID(9, probe_c2_p9), PROBE_SOLID(10, probe_c2_p10),
};

/* 4 explicit, 1 and 2 default */
static const probe_mixed probe_c2_front[] = {
    { -0.25, 0.2, {2, 5} },       /* x -1, y 0.8: 2f 8, 5 at 8.4, 1f 9 */
    { -0.25, 0.0, {2, 0} },       /* x -1, y 0: 2f 8, 1f 9, 6 at 9.3; limit 1f 9 */
    { 0.375, 0.2, {4, 7} },       /* x 1.5, y 0.8: 4f 6, 4b 7, 7 at 8, 1f 9; 4 explicit: limit 1f 9 */
    { 0.375, -0.2, {4, 0} },      /* x 1.5, y -0.8: 4f 6, 4b 7, 1f 9, 8 at 10; limit 1f 9 */
    { 0.7, 0.0, {1, 0} },         /* x 2.8, y 0: 1f 9, 1b 12, 9 at 13; 1 default */
    { 0.825, 0.0, {0, 9} },       /* x 3.3, y 0: 9 at 13, beside 1 */
    { -0.625, 0.2, {1, 0} },      /* x -2.5, y 0.8: 1f 9, 1b 12, 10 at 13; 1 default */
};

/* 1 explicit, 2 and 4 default */
static const probe_mixed probe_c2_front_other[] = {
    { -0.25, 0.2, {2, 5} },       /* x -1, y 0.8: 2f 8, 5 at 8.4, 1f 9 */
    { 0.375, 0.2, {4, 0} },       /* x 1.5, y 0.8: 4f 6, 4b 7, 7 at 8, 1f 9; 4 default: limit 4b 7 */
    { 0.7, 0.0, {1, 9} },         /* x 2.8, y 0: 1f 9, 1b 12, 9 at 13; 1 explicit: no limit */
    { -0.625, 0.2, {1, 10} },     /* x -2.5, y 0.8: 1f 9, 1b 12, 10 at 13 */
};

static const probe_mixed_view probe_c2_views[] = {
    { "4 explicit", PROBE_FROM_ZP, {4}, PROBE_COUNT(probe_c2_front), probe_c2_front },
    { "1 explicit", PROBE_FROM_ZP, {1}, PROBE_COUNT(probe_c2_front_other), probe_c2_front_other },
};

/* ---- C3: the coincident faces of scene 9 --------------------------------------------------- */

/* 1 default, 2 explicit; where the faces z = 2 coincide the front-most is that of 1 */
static const probe_mixed probe_c3_two[] = {
    { 0.0, 0.25, {1, 0} },        /* x 0, y 1: 1f 8 = 2f 8, 4 at 9, 1b 11; 1 default: limit 2f 8 */
    { 0.5, 0.0, {2, 8} },         /* x 2, y 0: 2f 8, 8 at 11.5, 2b 12 */
    { -0.525, 0.0, {1, 0} },      /* x -2.1, y 0: 1f 8, 1b 11, 9 at 12; 1 default */
    { 0.0875, -0.25, {1, 0} },    /* x 0.35, y -1: 1f 8 = 2f 8, 1b 11, 7 at 11.2, 2b 12 */
};

/* 1 explicit, 2 default */
static const probe_mixed probe_c3_one[] = {
    { 0.0, 0.25, {1, 4} },        /* x 0, y 1: 1f 8 = 2f 8, 4 at 9, 1b 11; 1 explicit: they count as one */
    { 0.5, 0.0, {2, 8} },         /* x 2, y 0: 2f 8, 8 at 11.5, 2b 12 */
    { -0.525, 0.0, {1, 9} },      /* x -2.1, y 0: 1f 8, 1b 11, 9 at 12; 1 explicit */
    { 0.0875, -0.25, {1, 7} },    /* x 0.35, y -1: 1f 8 = 2f 8, 1b 11, 7 at 11.2, 2b 12 */
};

static const probe_mixed_view probe_c3_views[] = {
    { "2 explicit", PROBE_FROM_ZP, {2}, PROBE_COUNT(probe_c3_two), probe_c3_two },
    { "1 explicit", PROBE_FROM_ZP, {1}, PROBE_COUNT(probe_c3_one), probe_c3_one },
};

/* ---- C4: the eye inside, scene 7 ------------------------------------------------------------ */

/* 1, around the eye, is never front-most: its method changes nothing.  2 explicit, 1 and 3 default */
static const probe_mixed probe_c4_two[] = {
    { -0.15, 0.155, {2, 6} },     /* 2f 4, 2b 8, 6 at 9, 1b 10; 2 explicit */
    { -0.2, -0.48, {3, 0} },      /* 1b 8.333, 3f 12, 3b 13.75, 12 at 20; 3 default */
    { 0.2, -0.085, {0, 7} },      /* 1b 10, 7 at 12; no front face, no limit */
    { -0.18, 0.0, {2, 5} },       /* 2f 4, 5 at 5, 2b 8 */
};

/* 3 and 1 explicit, 2 default */
static const probe_mixed probe_c4_three[] = {
    { -0.15, 0.155, {2, 0} },     /* 2f 4, 2b 8, 6 at 9, 1b 10; 2 default */
    { -0.2, -0.48, {3, 12} },     /* 1b 8.333, 3f 12, 3b 13.75, 12 at 20; 3 explicit */
    { 0.2, -0.085, {0, 7} },      /* 1b 10, 7 at 12 */
    { -0.19, -0.325, {3, 8} },    /* 1b 10, 3f 12, 8 at 13, 3b 16 */
};

static const probe_mixed_view probe_c4_views[] = {
    { "2 explicit", { true, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1.0, 0.1, 30.0 }, {2},
      PROBE_COUNT(probe_c4_two), probe_c4_two },
    { "1 and 3 explicit", { true, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1.0, 0.1, 30.0 }, {1, 3},
      PROBE_COUNT(probe_c4_three), probe_c4_three },
};

/* ---- C5: the back face of an object that is not front-most ---------------------------------- */

/* The camera plane lies in 1 (z up to 12), which shows only 1b 11.  From +z: 2f 9, 2b 10;
 * 4f 9, 4b 10; 6f 9.5, a two-sided sheet. */
static const probe_polygon probe_c5_p1[] = { PROBE_BOX(-3.0, 3.0, -3.0, 3.0, -1.0, 12.0) };
static const probe_polygon probe_c5_p2[] = { PROBE_BOX(-2.0, -0.2, -1.0, 1.0, 0.0, 1.0) };
static const probe_polygon probe_c5_p3[] = { PROBE_BOX(-1.5, -0.5, -0.5, 0.5, -3.0, -2.0) };
static const probe_polygon probe_c5_p4[] = { PROBE_BOX(0.6, 2.4, -1.0, 1.0, 0.0, 1.0) };
static const probe_polygon probe_c5_p5[] = { PROBE_BOX(1.0, 2.0, -0.5, 0.5, -3.0, -2.0) };
static const probe_polygon probe_c5_p6[] = { PROBE_FACE_ZP(0.5, -2.0, 2.0, 1.4, 2.4) };
static const probe_polygon probe_c5_p7[] = { PROBE_BOX(-0.5, 0.5, 1.65, 2.15, -3.0, -2.0) };
static const probe_polygon probe_c5_p8[] = { PROBE_BOX(-2.8, -2.3, -0.3, 0.3, -3.0, -2.0) };

static const probe_object probe_c5_objects[] = {
    PROBE_GLASS(1, probe_c5_p1), PROBE_GLASS(2, probe_c5_p2), PROBE_SOLID(3, probe_c5_p3),
    PROBE_GLASS(4, probe_c5_p4), PROBE_SOLID(5, probe_c5_p5), PROBE_SHEET(6, probe_c5_p6),
    PROBE_SOLID(7, probe_c5_p7), PROBE_SOLID(8, probe_c5_p8),
};

/* 2 and 6 explicit, 1 and 4 default: 1b does not limit what is seen through 2 and 6 */
static const probe_mixed probe_c5_front[] = {
    { -0.25, 0.0, {2, 3} },       /* x -1, y 0: 2f 9, 2b 10, 1b 11, 3 at 12 */
    { 0.375, 0.0, {4, 0} },       /* x 1.5, y 0: 4f 9, 4b 10, 1b 11, 5 at 12 */
    { 0.0, 0.475, {6, 7} },       /* x 0, y 1.9: 6f 9.5, 1b 11, 7 at 12 */
    { -0.6375, 0.0, {0, 8} },     /* x -2.55, y 0: 1b 11, 8 at 12; no front face */
};

/* 1 and 4 explicit, 2 and 6 default: 1b limits what is seen through 6, whatever the method of 1 */
static const probe_mixed probe_c5_front_other[] = {
    { -0.25, 0.0, {2, 0} },       /* x -1, y 0: 2f 9, 2b 10, 1b 11, 3 at 12 */
    { 0.375, 0.0, {4, 5} },       /* x 1.5, y 0: 4f 9, 4b 10, 1b 11, 5 at 12 */
    { 0.0, 0.475, {6, 0} },       /* x 0, y 1.9: 6f 9.5, 1b 11, 7 at 12 */
    { -0.6375, 0.0, {0, 8} },     /* x -2.55, y 0: 1b 11, 8 at 12; no front face */
};

static const probe_mixed_view probe_c5_views[] = {
    { "2 and 6 explicit", PROBE_FROM_ZP, {2, 6}, PROBE_COUNT(probe_c5_front), probe_c5_front },
    { "1 and 4 explicit", PROBE_FROM_ZP, {1, 4}, PROBE_COUNT(probe_c5_front_other), probe_c5_front_other },
};

static const probe_mixed_scene probe_mixed_scenes[] = {
    { "two intersecting", PROBE_COUNT(probe_c1_objects), probe_c1_objects, PROBE_COUNT(probe_c1_views), probe_c1_views },
    { "poking out and before", PROBE_COUNT(probe_c2_objects), probe_c2_objects, PROBE_COUNT(probe_c2_views), probe_c2_views },
    { "coincident", PROBE_COUNT(probe_s9_objects), probe_s9_objects, PROBE_COUNT(probe_c3_views), probe_c3_views },
    { "eye inside", PROBE_COUNT(probe_s7_objects), probe_s7_objects, PROBE_COUNT(probe_c4_views), probe_c4_views },
    { "a back face of another", PROBE_COUNT(probe_c5_objects), probe_c5_objects, PROBE_COUNT(probe_c5_views), probe_c5_views },
};

/* ==== D. Hodges' first rule ================================================================= */

/* ---- D1: bars and a block that enter a box ------------------------------------------------- */

/* 1: x, y -2..2, z -1..1.  Curves: of 2 the rectangle x = 2, |y| <= 0.5, |z| <= 0.4; of 3 none (it
 * lies inside); of 4 the rectangle z = 1, x -1.6..-0.4, y 1.1..1.7; of 5 two rectangles x = -2 and
 * x = 2, y -1.8..-1.2, |z| <= 0.3.  The points seen from +z are on z = 0.4 of 2 and 3, z = 1.4 of
 * 4, z = 0.3 of 5; on 2 and 5 the nearest point of the curve has the same y and z. */
static const probe_polygon probe_d1_p1[] = { PROBE_BOX(-2.0, 2.0, -2.0, 2.0, -1.0, 1.0) };
static const probe_polygon probe_d1_p2[] = { PROBE_BOX(0.5, 3.5, -0.5, 0.5, -0.4, 0.4) };
static const probe_polygon probe_d1_p3[] = { PROBE_BOX(-1.5, -0.5, -0.5, 0.5, -0.4, 0.4) };
static const probe_polygon probe_d1_p4[] = { PROBE_BOX(-1.6, -0.4, 1.1, 1.7, 0.0, 1.4) };
static const probe_polygon probe_d1_p5[] = { PROBE_BOX(-3.5, 3.5, -1.8, -1.2, -0.3, 0.3) };

static const probe_object probe_d1_objects[] = {
    PROBE_GLASS(1, probe_d1_p1), PROBE_SOLID(2, probe_d1_p2), PROBE_SOLID(3, probe_d1_p3),
    PROBE_SOLID(4, probe_d1_p4), PROBE_SOLID(5, probe_d1_p5),
};

/* amount 0.5 over distance 1: factor 0.5 + 0.5 d up to 1 */
static const probe_hodges probe_d1_one[] = {
    /* x 2.5, y 0: 2 at 9.6; d 0.5 */
    { 0.625, 0.0, {0, 2}, {2.5, 0.0, 0.4}, false, 0.5, 0.75 },
    /* x 2.25, y 0: 2 at 9.6; d 0.25 */
    { 0.5625, 0.0, {0, 2}, {2.25, 0.0, 0.4}, false, 0.25, 0.625 },
    /* x 2.8, y 0: 2 at 9.6; d 0.8 */
    { 0.7, 0.0, {0, 2}, {2.8, 0.0, 0.4}, false, 0.8, 0.9 },
    /* x 3.2, y 0: 2 at 9.6; d 1.2, out of reach */
    { 0.8, 0.0, {0, 2}, {3.2, 0.0, 0.4}, false, 1.2, 1.0 },
    /* x 2.4, y 0.3: 2 at 9.6; d 0.4 */
    { 0.6, 0.075, {0, 2}, {2.4, 0.3, 0.4}, false, 0.4, 0.7 },
    /* x 1.75, y 0: 1f 9, 2 at 9.6; d 0.25 */
    { 0.4375, 0.0, {1, 2}, {1.75, 0.0, 0.4}, true, 0.25, 0.625 },
    /* x 1.5, y 0: 1f 9, 2 at 9.6; d 0.5 */
    { 0.375, 0.0, {1, 2}, {1.5, 0.0, 0.4}, true, 0.5, 0.75 },
    /* x 1.2, y 0: 1f 9, 2 at 9.6; d 0.8 */
    { 0.3, 0.0, {1, 2}, {1.2, 0.0, 0.4}, true, 0.8, 0.9 },
    /* x 0.8, y 0: 1f 9, 2 at 9.6; d 1.2 */
    { 0.2, 0.0, {1, 2}, {0.8, 0.0, 0.4}, true, 1.2, 1.0 },
    /* x -1, y 0: 1f 9, 3 at 9.6; no curve */
    { -0.25, 0.0, {1, 3}, {-1.0, 0.0, 0.4}, true, PROBE_ANY_DISTANCE, 1.0 },
    /* x -1, y 1.4: 4 at 8.6, 1f 9; 0.4 above the curve, 0.3 from its long sides: d 0.5 (along the surface 0.7) */
    { -0.25, 0.35, {0, 4}, {-1.0, 1.4, 1.4}, false, 0.5, 0.75 },
    /* x -0.65, y 1.4: 4 at 8.6, 1f 9; 0.4 above, 0.25 from the side x = -0.4: d = sqrt(0.2225) */
    { -0.1625, 0.35, {0, 4}, {-0.65, 1.4, 1.4}, false, 0.4716990566, 0.7358495283 },
    /* x 0, y -1.5: 1f 9, 5 at 9.7; d 2 */
    { 0.0, -0.375, {1, 5}, {0.0, -1.5, 0.3}, true, 2.0, 1.0 },
    /* x 1.6, y -1.5: 1f 9, 5 at 9.7; d 0.4 */
    { 0.4, -0.375, {1, 5}, {1.6, -1.5, 0.3}, true, 0.4, 0.7 },
    /* x 2.6, y -1.5: 5 at 9.7; d 0.6 */
    { 0.65, -0.375, {0, 5}, {2.6, -1.5, 0.3}, false, 0.6, 0.8 },
    /* x -2.4, y -1.5: 5 at 9.7; d 0.4 */
    { -0.6, -0.375, {0, 5}, {-2.4, -1.5, 0.3}, false, 0.4, 0.7 },
    /* x -1.4, y -1.5: 1f 9, 5 at 9.7; d 0.6 */
    { -0.35, -0.375, {1, 5}, {-1.4, -1.5, 0.3}, true, 0.6, 0.8 },
};

/* amount 0.8 over distance 3: factor 0.2 + 0.8 d / 3 */
static const probe_hodges probe_d1_three[] = {
    /* x 0, y -1.5: 1f 9, 5 at 9.7; d 2 to either curve */
    { 0.0, -0.375, {1, 5}, {0.0, -1.5, 0.3}, true, 2.0, 2.2 / 3.0 },
    /* x 1, y -1.5: 1f 9, 5 at 9.7; d 1 */
    { 0.25, -0.375, {1, 5}, {1.0, -1.5, 0.3}, true, 1.0, 1.4 / 3.0 },
    /* x -1.4, y -1.5: 1f 9, 5 at 9.7; d 0.6 */
    { -0.35, -0.375, {1, 5}, {-1.4, -1.5, 0.3}, true, 0.6, 0.36 },
    /* x -2.6, y -1.5: 5 at 9.7; d 0.6 */
    { -0.65, -0.375, {0, 5}, {-2.6, -1.5, 0.3}, false, 0.6, 0.36 },
    /* x 3.2, y -1.5: 5 at 9.7; d 1.2 */
    { 0.8, -0.375, {0, 5}, {3.2, -1.5, 0.3}, false, 1.2, 0.52 },
    /* OTHER: x -0.7, y 0: 1f 9, 3 at 9.6; 2.7 from the curve of 2, 1.27 from that of 4, but none is its own */
    { -0.175, 0.0, {1, 3}, {-0.7, 0.0, 0.4}, true, PROBE_ANY_DISTANCE, 1.0 },
    /* OTHER: x -1.3, y 0: 1f 9, 3 at 9.6; near the curves of 4 and 5, none is its own */
    { -0.325, 0.0, {1, 3}, {-1.3, 0.0, 0.4}, true, PROBE_ANY_DISTANCE, 1.0 },
    /* x 2.5, y 0: 2 at 9.6; d 0.5 */
    { 0.625, 0.0, {0, 2}, {2.5, 0.0, 0.4}, false, 0.5, 1.0 / 3.0 },
    /* x 1.5, y 0: 1f 9, 2 at 9.6; d 0.5 */
    { 0.375, 0.0, {1, 2}, {1.5, 0.0, 0.4}, true, 0.5, 1.0 / 3.0 },
    /* x -1, y 1.4: 4 at 8.6, 1f 9; d 0.5 (along the surface 0.7) */
    { -0.25, 0.35, {0, 4}, {-1.0, 1.4, 1.4}, false, 0.5, 1.0 / 3.0 },
};

/* amount 1 over distance 0.8: factor d / 0.8 up to 1 */
static const probe_hodges probe_d1_full[] = {
    /* x 2.4, y 0: 2 at 9.6; d 0.4 */
    { 0.6, 0.0, {0, 2}, {2.4, 0.0, 0.4}, false, 0.4, 0.5 },
    /* x 2.2, y 0: 2 at 9.6; d 0.2 */
    { 0.55, 0.0, {0, 2}, {2.2, 0.0, 0.4}, false, 0.2, 0.25 },
    /* x 3, y 0: 2 at 9.6; d 1 */
    { 0.75, 0.0, {0, 2}, {3.0, 0.0, 0.4}, false, 1.0, 1.0 },
};

static const probe_hodges_view probe_d1_views[] = {
    { "0.5 over 1", PROBE_FROM_ZP, 0.5, 1.0, PROBE_COUNT(probe_d1_one), probe_d1_one },
    { "0.8 over 3", PROBE_FROM_ZP, 0.8, 3.0, PROBE_COUNT(probe_d1_three), probe_d1_three },
    { "1 over 0.8", PROBE_FROM_ZP, 1.0, 0.8, PROBE_COUNT(probe_d1_full), probe_d1_full },
};

/* ---- D2: a small box stands in a wide slab -------------------------------------------------- */

/* curve: the square z = 0, |x| and |y| at most 1; the points are on z = 0, amount 0.5 over 2:
 * factor 0.5 + 0.25 d; beside the corners the distance is that to the corner */
static const probe_polygon probe_d2_p1[] = { PROBE_BOX(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0) };
static const probe_polygon probe_d2_p2[] = { PROBE_BOX(-3.0, 3.0, -3.0, 3.0, -2.0, 0.0) };

static const probe_object probe_d2_objects[] = { PROBE_GLASS(1, probe_d2_p1), PROBE_SOLID(2, probe_d2_p2) };

static const probe_hodges probe_d2_front[] = {
    /* x 1.6, y 1.8: 2 at 10; 0.6 and 0.8 off the corner: d 1 */
    { 0.4, 0.45, {0, 2}, {1.6, 1.8, 0.0}, false, 1.0, 0.75 },
    /* x 1.3, y 1.4: 2 at 10; 0.3 and 0.4 off the corner: d 0.5 */
    { 0.325, 0.35, {0, 2}, {1.3, 1.4, 0.0}, false, 0.5, 0.625 },
    /* x -1.5, y -2.2: 2 at 10; 0.5 and 1.2 off the corner: d 1.3 */
    { -0.375, -0.55, {0, 2}, {-1.5, -2.2, 0.0}, false, 1.3, 0.825 },
    /* x 2.5, y 2.5: 2 at 10; 1.5 and 1.5 off the corner: d 2.1213, out of reach */
    { 0.625, 0.625, {0, 2}, {2.5, 2.5, 0.0}, false, 2.1213203436, 1.0 },
    /* x 2.2, y 0: 2 at 10; d 1.2 */
    { 0.55, 0.0, {0, 2}, {2.2, 0.0, 0.0}, false, 1.2, 0.8 },
    /* x -2.5, y 0.5: 2 at 10; d 1.5 */
    { -0.625, 0.125, {0, 2}, {-2.5, 0.5, 0.0}, false, 1.5, 0.875 },
    /* x 0, y -1.25: 2 at 10; d 0.25 */
    { 0.0, -0.3125, {0, 2}, {0.0, -1.25, 0.0}, false, 0.25, 0.5625 },
    /* x 0, y 0: 1f 9, 2 at 10; d 1 to every side */
    { 0.0, 0.0, {1, 2}, {0.0, 0.0, 0.0}, true, 1.0, 0.75 },
    /* x 0.5, y 0: 1f 9, 2 at 10; d 0.5 */
    { 0.125, 0.0, {1, 2}, {0.5, 0.0, 0.0}, true, 0.5, 0.625 },
    /* x 0.2, y 0.6: 1f 9, 2 at 10; d 0.4 to y = 1 */
    { 0.05, 0.15, {1, 2}, {0.2, 0.6, 0.0}, true, 0.4, 0.6 },
    /* x -0.7, y -0.4: 1f 9, 2 at 10; d 0.3 to x = -1 */
    { -0.175, -0.1, {1, 2}, {-0.7, -0.4, 0.0}, true, 0.3, 0.575 },
};

/* aslant as in scene 1: s = 0.8 x - 0.6 z, depth 10 - 0.6 x - 0.8 z, half width 3; the same points
 * have the same factors from everywhere */
static const probe_hodges probe_d2_aslant[] = {
    /* s 1.76, y 0: 2 at 8.68; x 2.2: d 1.2 */
    { 1.76 / 3.0, 0.0, {0, 2}, {2.2, 0.0, 0.0}, false, 1.2, 0.8 },
    /* s -1.76, y 0: 2 at 11.32, seen past the top of 1 (its edge x = -1, z = 1 is at s -1.4); x -2.2: d 1.2 */
    { -1.76 / 3.0, 0.0, {0, 2}, {-2.2, 0.0, 0.0}, false, 1.2, 0.8 },
    /* s 0, y 0: 1f (z=1, x 0.75) 8.75, 2 at 10; d 1 */
    { 0.0, 0.0, {1, 2}, {0.0, 0.0, 0.0}, true, 1.0, 0.75 },
    /* s 0.48, y 0: 1f (x=1, z 0.533) 8.973, 2 at 9.64; x 0.6: d 0.4 */
    { 0.16, 0.0, {1, 2}, {0.6, 0.0, 0.0}, true, 0.4, 0.6 },
    /* s 1.44, y 1.6: 2 at 8.92; x 1.8: 0.8 and 0.6 off the corner: d 1 */
    { 0.48, 1.6 / 3.0, {0, 2}, {1.8, 1.6, 0.0}, false, 1.0, 0.75 },
    /* s -1.6, y 0.5: 2 at 11.2; x -2: d 1 */
    { -1.6 / 3.0, 0.5 / 3.0, {0, 2}, {-2.0, 0.5, 0.0}, false, 1.0, 0.75 },
};

static const probe_hodges_view probe_d2_views[] = {
    { "front", PROBE_FROM_ZP, 0.5, 2.0, PROBE_COUNT(probe_d2_front), probe_d2_front },
    { "aslant", { false, {6, 0, 8}, {0.8, 0, -0.6}, {0, 1, 0}, {0.6, 0, 0.8}, 3.0, 1.0, 20.0 }, 0.5, 2.0,
      PROBE_COUNT(probe_d2_aslant), probe_d2_aslant },
};

/* ---- D3: a bar through a two-sided sheet ------------------------------------------------------ */

/* SHEET reading: a sheet that is crossed is entered as well.  Sheet x = 0, |y|, |z| at most 2; curve:
 * the rectangle x = 0, |y|, |z| at most 0.5.  Amount 0.5 over 2: 0.5 + 0.25 d.  Aslant camera. */
static const probe_polygon probe_d3_p1[] = { PROBE_FACE_XP(0.0, -2.0, 2.0, -2.0, 2.0) };
static const probe_polygon probe_d3_p2[] = { PROBE_BOX(-1.5, 1.5, -0.5, 0.5, -0.5, 0.5) };

static const probe_object probe_d3_objects[] = { PROBE_SHEET(1, probe_d3_p1), PROBE_SOLID(2, probe_d3_p2) };

/* inside: on the side away from the eye */
static const probe_hodges probe_d3_aslant[] = {
    /* s 0.5, y 0: 2 (z=0.5, x 1) at 9; d 1 */
    { 0.5 / 3.0, 0.0, {0, 2}, {1.0, 0.0, 0.5}, false, 1.0, 0.75 },
    /* s 0.1, y 0: 2 (z=0.5, x 0.5) at 9.3; d 0.5 */
    { 0.1 / 3.0, 0.0, {0, 2}, {0.5, 0.0, 0.5}, false, 0.5, 0.625 },
    /* s 0.66, y 0.2: 2 (z=0.5, x 1.2) at 8.88; d 1.2 */
    { 0.22, 0.2 / 3.0, {0, 2}, {1.2, 0.2, 0.5}, false, 1.2, 0.8 },
    /* s -0.94, y 0: 1f (z 1.567) 8.747, 2 (x -0.8) at 10.08; d 0.8 */
    { -0.94 / 3.0, 0.0, {1, 2}, {-0.8, 0.0, 0.5}, true, 0.8, 0.7 },
    /* s -0.62, y 0: 1f 9.173, 2 (x -0.4) at 9.84; d 0.4 */
    { -0.62 / 3.0, 0.0, {1, 2}, {-0.4, 0.0, 0.5}, true, 0.4, 0.6 },
    /* s 1.2, y 0: 2 (x=1.5, z 0) at 9.1; 1.5 from the curve's plane, 0.5 from its sides: d = sqrt(2.5)
     * (along the surface 2, which would be 1.0) */
    { 0.4, 0.0, {0, 2}, {1.5, 0.0, 0.0}, false, 1.5811388301, 0.8952847075 },
};

static const probe_hodges_view probe_d3_views[] = {
    { "aslant", { false, {6, 0, 8}, {0.8, 0, -0.6}, {0, 1, 0}, {0.6, 0, 0.8}, 3.0, 1.0, 20.0 }, 0.5, 2.0,
      PROBE_COUNT(probe_d3_aslant), probe_d3_aslant },
};

/* ---- D4: a bar through two boxes: the nearest curve counts, once ------------------------------ */

/* curves at x = -3, -1, 1, 3; amount 0.6 over 1.5: 0.4 + 0.4 d */
static const probe_polygon probe_d4_p1[] = { PROBE_BOX(-3.0, -1.0, -1.0, 1.0, -1.0, 1.0) };
static const probe_polygon probe_d4_p2[] = { PROBE_BOX(1.0, 3.0, -1.0, 1.0, -1.0, 1.0) };
static const probe_polygon probe_d4_p3[] = { PROBE_BOX(-3.6, 3.6, -0.4, 0.4, -0.4, 0.4) };

static const probe_object probe_d4_objects[] = {
    PROBE_GLASS(1, probe_d4_p1), PROBE_GLASS(2, probe_d4_p2), PROBE_SOLID(3, probe_d4_p3),
};

static const probe_hodges probe_d4_front[] = {
    /* x 0, y 0: 3 at 9.6; d 1 to x = -1 and to x = 1 */
    { 0.0, 0.0, {0, 3}, {0.0, 0.0, 0.4}, false, 1.0, 0.8 },
    /* x 0.5, y 0: 3 at 9.6; d 0.5 */
    { 0.125, 0.0, {0, 3}, {0.5, 0.0, 0.4}, false, 0.5, 0.6 },
    /* x 2, y 0: 2f 9, 3 at 9.6; d 1 to x = 1 and to x = 3 */
    { 0.5, 0.0, {2, 3}, {2.0, 0.0, 0.4}, true, 1.0, 0.8 },
    /* x 2.4, y 0: 2f 9, 3 at 9.6; d 0.6 */
    { 0.6, 0.0, {2, 3}, {2.4, 0.0, 0.4}, true, 0.6, 0.64 },
    /* x -1.3, y 0: 1f 9, 3 at 9.6; d 0.3 */
    { -0.325, 0.0, {1, 3}, {-1.3, 0.0, 0.4}, true, 0.3, 0.52 },
    /* x 3.3, y 0: 3 at 9.6; d 0.3 */
    { 0.825, 0.0, {0, 3}, {3.3, 0.0, 0.4}, false, 0.3, 0.52 },
};

static const probe_hodges_view probe_d4_views[] = {
    { "front", PROBE_FROM_ZP, 0.6, 1.5, PROBE_COUNT(probe_d4_front), probe_d4_front },
};

static const probe_hodges_scene probe_hodges_scenes[] = {
    { "bars into a box", PROBE_COUNT(probe_d1_objects), probe_d1_objects, PROBE_COUNT(probe_d1_views), probe_d1_views },
    { "box in a slab", PROBE_COUNT(probe_d2_objects), probe_d2_objects, PROBE_COUNT(probe_d2_views), probe_d2_views },
    { "bar through a sheet", PROBE_COUNT(probe_d3_objects), probe_d3_objects, PROBE_COUNT(probe_d3_views), probe_d3_views },
    { "bar through two boxes", PROBE_COUNT(probe_d4_objects), probe_d4_objects, PROBE_COUNT(probe_d4_views), probe_d4_views },
};

/* ==== E. lines: visible, through, hidden ===================================================== */

#define PROBE_V PROBE_LINE_VISIBLE
#define PROBE_T PROBE_LINE_THROUGH
#define PROBE_H PROBE_LINE_HIDDEN
#define PROBE_U PROBE_LINE_UNSTATED

/* ---- E1: a bar that enters a box, things before and behind --------------------------------- */

/* Perspective, eye (0, 0, 10), half width 0.5: the ray to a point (x, y, z) is at depth d at
 * (x, y) d / (10 - z).  In the comments P is the depth of the point itself; faces that meet in the
 * point are not listed.  1: 1f 8 (z = 2) over x -1..3, y -2..2, 1b 10. */
static const probe_polygon probe_e1_p1[] = { PROBE_BOX(-1.0, 3.0, -2.0, 2.0, 0.0, 2.0) };
static const probe_polygon probe_e1_p2[] = { PROBE_BOX(-3.0, 2.5, -0.5, 0.5, 0.5, 1.0) };      /* a bar, enters 1 at x = -1 */
static const probe_polygon probe_e1_p3[] = { PROBE_BOX(0.5, 1.5, -1.1, 1.1, 3.0, 3.5) };       /* before 1 */
static const probe_polygon probe_e1_p4[] = { PROBE_BOX(-4.0, 0.6, -1.6, -1.0, -3.0, -2.0) };   /* behind 1, past its side */
static const probe_polygon probe_e1_p5[] = { PROBE_BOX(-2.8, -1.8, 1.4, 2.4, 0.0, 3.0) };      /* beside 1 */
static const probe_polygon probe_e1_p7[] = { PROBE_BOX(-1.0, 0.3, 1.0, 2.1, -3.0, -2.0) };     /* transparent, behind 1 */
static const probe_polygon probe_e1_p8[] = { PROBE_BOX(-0.6, -0.1, 1.3, 1.8, -2.8, -2.4) };    /* in 7 */

static const probe_object probe_e1_objects[] = {
    PROBE_GLASS(1, probe_e1_p1), PROBE_SOLID(2, probe_e1_p2), PROBE_SOLID(3, probe_e1_p3),
    PROBE_SOLID(4, probe_e1_p4), PROBE_SOLID(5, probe_e1_p5), PROBE_GLASS(7, probe_e1_p7),
    PROBE_SOLID(8, probe_e1_p8),
};

static const probe_line probe_e1_points[] = {
    /* upper front edge of 2; before it 1f for x > -1.125, 3 for x 0.643..2.077 */
    { 2, {-2.5, 0.5, 1.0}, PROBE_V, PROBE_V, PROBE_V },      /* P 9 */
    { 2, {-2.0, 0.5, 1.0}, PROBE_V, PROBE_V, PROBE_V },      /* P 9 */
    { 2, {-1.6, 0.5, 1.0}, PROBE_V, PROBE_V, PROBE_V },      /* P 9 */
    { 2, {-0.5, 0.5, 1.0}, PROBE_T, PROBE_T, PROBE_T },      /* 1f 8, P 9, 1b 10 */
    { 2, {0.0, 0.5, 1.0}, PROBE_T, PROBE_T, PROBE_T },       /* 1f 8, P 9, 1b 10 */
    { 2, {0.3, 0.5, 1.0}, PROBE_T, PROBE_T, PROBE_T },       /* 1f 8, P 9, 1b 10 */
    { 2, {1.0, 0.5, 1.0}, PROBE_H, PROBE_H, PROBE_H },       /* 3 at 6.5 (x 0.722), P 9 */
    { 2, {1.5, 0.5, 1.0}, PROBE_H, PROBE_H, PROBE_H },       /* 3 at 6.5 (x 1.083), P 9 */
    { 2, {1.8, 0.5, 1.0}, PROBE_H, PROBE_H, PROBE_H },       /* 3 at 6.5 (x 1.3), P 9 */
    { 2, {2.3, 0.5, 1.0}, PROBE_T, PROBE_T, PROBE_T },       /* 1f 8, P 9, 1b 10; beside 3 (x 1.661) */
    /* lower front edge, and the front edge of the end x = 2.5 and of the end x = -3 */
    { 2, {-2.0, -0.5, 1.0}, PROBE_V, PROBE_V, PROBE_V },     /* P 9 */
    { 2, {0.0, -0.5, 1.0}, PROBE_T, PROBE_T, PROBE_T },      /* 1f 8, P 9, 1b 10 */
    { 2, {1.2, -0.5, 1.0}, PROBE_H, PROBE_H, PROBE_H },      /* 3 at 6.5, P 9 */
    { 2, {2.5, 0.0, 1.0}, PROBE_T, PROBE_T, PROBE_T },       /* 1f 8, P 9, 1b 10 */
    { 2, {-3.0, 0.0, 1.0}, PROBE_V, PROBE_V, PROBE_V },      /* P 9 */
    /* edges of 3, all before 1 */
    { 3, {0.5, 0.0, 3.5}, PROBE_V, PROBE_V, PROBE_V },       /* P 6.5 */
    { 3, {1.5, 0.0, 3.5}, PROBE_V, PROBE_V, PROBE_V },       /* P 6.5 */
    { 3, {1.0, 1.1, 3.5}, PROBE_V, PROBE_V, PROBE_V },       /* P 6.5 */
    /* 4, behind 1: limits 1b 10 by default, none by the explicit rule */
    { 4, {-3.0, -1.0, -2.0}, PROBE_V, PROBE_V, PROBE_V },    /* P 12 */
    { 4, {-0.5, -1.0, -2.0}, PROBE_T, PROBE_H, PROBE_T },    /* 1f 8, 1b 10, P 12 */
    { 4, {0.0, -1.0, -2.0}, PROBE_T, PROBE_H, PROBE_T },     /* 1f 8, 1b 10, P 12 */
    { 4, {0.0, -1.6, -2.0}, PROBE_T, PROBE_H, PROBE_T },     /* 1f 8, 1b 10, P 12 */
    { 4, {-3.0, -1.6, -2.0}, PROBE_V, PROBE_V, PROBE_V },    /* P 12 */
    { 4, {0.6, -1.3, -2.0}, PROBE_T, PROBE_H, PROBE_T },     /* 1f 8, 1b 10, P 12 */
    { 4, {-4.0, -1.3, -2.0}, PROBE_V, PROBE_V, PROBE_V },    /* P 12 */
    /* 5: its own faces hide the edges at its back that are no outline */
    { 5, {-2.3, 2.4, 3.0}, PROBE_V, PROBE_V, PROBE_V },      /* P 7 */
    { 5, {-2.8, 1.9, 3.0}, PROBE_V, PROBE_V, PROBE_V },      /* P 7 */
    { 5, {-1.8, 1.9, 3.0}, PROBE_V, PROBE_V, PROBE_V },      /* P 7, between two front-facing faces */
    { 5, {-2.3, 1.4, 3.0}, PROBE_V, PROBE_V, PROBE_V },      /* P 7, between two front-facing faces */
    { 5, {-1.8, 1.9, 0.0}, PROBE_V, PROBE_V, PROBE_V },      /* P 10, outline: the face x = -1.8 looks to the eye */
    { 5, {-2.8, 2.2, 0.0}, PROBE_H, PROBE_H, PROBE_H },      /* 5 at 7, P 10 */
    { 5, {-2.3, 2.4, 0.0}, PROBE_H, PROBE_H, PROBE_H },      /* 5 (x=-1.8) at 7.826, P 10 */
    /* 8 in 7 behind 1: limits 1b 10 by default, 7f 12 by the explicit rule */
    { 8, {-0.35, 1.8, -2.4}, PROBE_T, PROBE_H, PROBE_H },    /* 1f 8, 1b 10, 7f 12, P 12.4, 7b 13 */
    { 8, {-0.35, 1.3, -2.4}, PROBE_T, PROBE_H, PROBE_H },    /* 1f 8, 1b 10, 7f 12, P 12.4, 7b 13 */
    /* edges of the transparent objects themselves; the limits say nothing of them */
    { 1, {-0.5, 2.0, 2.0}, PROBE_V, PROBE_U, PROBE_U },      /* P 8 */
    { 1, {1.0, 2.0, 2.0}, PROBE_V, PROBE_U, PROBE_U },       /* P 8 */
    { 1, {2.5, 2.0, 2.0}, PROBE_V, PROBE_U, PROBE_U },       /* P 8 */
    { 1, {-1.0, 0.0, 2.0}, PROBE_V, PROBE_U, PROBE_U },      /* P 8, the bar lies behind */
    { 1, {-1.0, 1.5, 2.0}, PROBE_V, PROBE_U, PROBE_U },      /* P 8 */
    { 1, {3.0, 0.0, 2.0}, PROBE_V, PROBE_U, PROBE_U },       /* P 8 */
    { 1, {-0.5, 2.0, 0.0}, PROBE_T, PROBE_U, PROBE_U },      /* 1f 8, P 10 */
    { 1, {1.0, 2.0, 0.0}, PROBE_T, PROBE_U, PROBE_U },       /* 1f 8, P 10; over 3 (y 1.3 at 6.5) */
    { 1, {2.0, 2.0, 0.0}, PROBE_T, PROBE_U, PROBE_U },       /* 1f 8, P 10 */
    { 1, {-1.0, 1.5, 0.0}, PROBE_T, PROBE_U, PROBE_U },      /* 1f 8, P 10 */
    { 1, {-1.0, 0.0, 0.0}, PROBE_H, PROBE_U, PROBE_U },      /* 1f 8, 2 at 9 (x -0.9), P 10 */
    { 1, {-1.0, -1.2, 0.0}, PROBE_T, PROBE_U, PROBE_U },     /* 1f 8, P 10 */
    { 1, {3.0, 0.0, 0.0}, PROBE_T, PROBE_U, PROBE_U },       /* 1f 8, P 10; past the end of the bar (x 2.7 at 9) */
    { 1, {3.0, 1.5, 0.0}, PROBE_T, PROBE_U, PROBE_U },       /* 1f 8, P 10 */
    { 1, {1.0, -2.0, 0.0}, PROBE_T, PROBE_U, PROBE_U },      /* 1f 8, P 10 */
    { 7, {-0.35, 2.1, -2.0}, PROBE_T, PROBE_U, PROBE_U },    /* 1f 8, 1b 10, P 12 */
};

/* ---- E2: the eye inside, a sheet from behind ------------------------------------------------- */

/* Eye at the origin, half width 1.  BACK ONLY: nothing but the back face of 1 lies before: visible. */
static const probe_polygon probe_e2_p1[] = { PROBE_BOX(-4.0, 4.0, -4.0, 4.0, -10.0, 2.0) };
static const probe_polygon probe_e2_p2[] = { PROBE_FACE_ZN(-5.0, 0.0, 3.0, -2.0, 2.0) };       /* two-sided */
static const probe_polygon probe_e2_p3[] = { PROBE_BOX(-6.0, 6.0, -1.0, 1.0, -14.0, -12.0) };  /* beyond 1 */
static const probe_polygon probe_e2_p4[] = { PROBE_BOX(-1.5, -0.5, -0.5, 1.0, -4.0, -3.0) };   /* inside 1 */

static const probe_object probe_e2_objects[] = {
    PROBE_GLASS(1, probe_e2_p1), PROBE_SHEET(2, probe_e2_p2), PROBE_SOLID(3, probe_e2_p3),
    PROBE_SOLID(4, probe_e2_p4),
};

static const probe_line probe_e2_points[] = {
    { 3, {-0.7, 1.0, -12.0}, PROBE_V, PROBE_V, PROBE_V },    /* BACK ONLY: 1b 10, P 12 */
    { 3, {-0.7, -1.0, -12.0}, PROBE_V, PROBE_V, PROBE_V },   /* BACK ONLY: 1b 10, P 12 */
    { 3, {2.0, 1.0, -12.0}, PROBE_T, PROBE_H, PROBE_T },     /* 2f 5, 1b 10, P 12 */
    { 3, {4.0, 1.0, -12.0}, PROBE_T, PROBE_H, PROBE_T },     /* 2f 5, 1b 10, P 12 */
    { 3, {2.0, -1.0, -12.0}, PROBE_T, PROBE_H, PROBE_T },    /* 2f 5, 1b 10, P 12 */
    { 3, {-4.0, 1.0, -12.0}, PROBE_H, PROBE_H, PROBE_H },    /* 4 at 3, P 12 */
    { 3, {-4.0, -1.0, -12.0}, PROBE_H, PROBE_H, PROBE_H },   /* 4 at 3, P 12 */
    { 4, {-1.0, 1.0, -3.0}, PROBE_V, PROBE_V, PROBE_V },     /* P 3 */
    { 4, {-1.5, 0.2, -3.0}, PROBE_V, PROBE_V, PROBE_V },     /* P 3 */
    { 2, {0.0, 1.0, -5.0}, PROBE_V, PROBE_U, PROBE_U },      /* P 5 */
    { 2, {1.5, 2.0, -5.0}, PROBE_V, PROBE_U, PROBE_U },      /* P 5 */
    { 1, {4.0, 0.0, -10.0}, PROBE_T, PROBE_U, PROBE_U },     /* 2f 5, P 10 */
    { 1, {-4.0, -3.0, -10.0}, PROBE_V, PROBE_U, PROBE_U },   /* P 10 */
    { 1, {-4.0, 0.0, -10.0}, PROBE_H, PROBE_U, PROBE_U },    /* 4 at 3, P 10 */
    { 1, {-1.0, 4.0, -10.0}, PROBE_V, PROBE_U, PROBE_U },    /* P 10 */
};

static const probe_line_scene probe_line_scenes[] = {
    { "bar into a box", PROBE_COUNT(probe_e1_objects), probe_e1_objects,
      { true, {0, 0, 10}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.5, 1.0, 20.0 },
      PROBE_COUNT(probe_e1_points), probe_e1_points },
    { "eye inside, sheet", PROBE_COUNT(probe_e2_objects), probe_e2_objects,
      { true, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1.0, 0.1, 30.0 },
      PROBE_COUNT(probe_e2_points), probe_e2_points },
};

#undef PROBE_V
#undef PROBE_T
#undef PROBE_H
#undef PROBE_U

/* clang-format on */
#endif

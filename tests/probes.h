/* Probe pixels worked out by hand: what is seen at chosen places of simple scenes.
 *
 * Every scene has a few boxes and prisms, one or more cameras, and places on the picture
 * plane with the expected answer: the transparent object that is blended there (0: none)
 * and the opaque object seen behind it or alone (0: the background).
 *
 * Default rule.  F is the nearest front-face point of transparent objects (either side of a
 * two-sided object counts as front; at equal depth the lowest id wins) and A is its object.
 * The limit L is the nearer of the nearest back face of one-sided transparent objects
 * strictly behind F and the nearest front face of a transparent object other than A at or
 * behind F; without F there is no limit.  O is the nearest opaque front face strictly nearer
 * than L.  If O is nearer than F it is seen alone, otherwise F is blended with O, or with the
 * background where there is no O.
 *
 * Published rule (section 6.1 and figure 5 of the paper).  B is the nearest back face of all
 * transparent objects, whether or not a front face lies before it (two-sided objects have
 * none).  O is the nearest opaque front face if it is nearer than B.  F is the nearest
 * transparent front face, blended only if it is nearer than both O and B.
 *
 * Explicit rule (section 6.2 of the paper).  F is as in the default rule.  The limit L is the
 * nearest transparent front-face point strictly behind F, of whatever object, F's own included
 * (coincident faces count as one, either side of a two-sided object counts as front); back
 * faces play no part; without F, or with nothing behind it, there is no limit.  O is the
 * nearest opaque front face strictly nearer than L (either side of a two-sided opaque object).
 * If O is nearer than F it is seen alone, otherwise F is blended with O, or with the background
 * where there is no O; without F, O or the background is seen alone.
 *
 * In the comments a number such as "1f 9" is the front face of object 1 at depth 9, "1b 11"
 * a back face of object 1 at depth 11; opaque objects are named by their front face only.
 * DIFFERS marks a published answer, EXPLICIT an explicit one that is not the default one.
 * A surface is left out where a nearer opaque surface makes it irrelevant.  Depths are
 * distances from the camera plane along the viewing axis.  All probes stay away from
 * projected edges and intersection curves by more than 0.02 of the picture's width (0.04 in
 * u and v).  The picture is square; u and v times half_width give the place on the plane.
 */
#ifndef GLASSINE_TESTS_PROBES_H
#define GLASSINE_TESTS_PROBES_H

#include <stdbool.h>
#include <stdint.h>

/* clang-format off */

/* convex, counter-clockwise seen from outside, world space */
typedef struct probe_polygon { int count; double vertices[8][3]; } probe_polygon;

typedef struct probe_object {
    uint32_t id; bool transparent, two_sided; double color[3], alpha;
    int polygon_count; const probe_polygon *polygons;
} probe_object;

/* toward: unit axis from the scene to the eye.  Orthographic: eye is the point of the camera
 * plane at the picture's centre, half_width in world units.  Perspective: half_width at
 * distance 1.  right x up = toward. */
typedef struct probe_camera {
    bool perspective; double eye[3]; double right[3], up[3], toward[3];
    double half_width; double near_distance, far_distance;
} probe_camera;

/* front: id of the blended transparent object or 0; behind: id of the opaque object seen
 * (alone when front is 0) or 0 = background */
typedef struct probe_answer { uint32_t front, behind; } probe_answer;

typedef struct probe {
    double u, v; probe_answer rule_default, rule_published, rule_explicit;
} probe;

typedef struct probe_view {
    const char *name; probe_camera camera; int probe_count; const probe *probes;
} probe_view;

/* view and probe are indices; the colours are those of the default rule's answer, or of the
 * published rule's where published_rule is set, under the three blendings */
typedef struct probe_example {
    int view, probe; bool published_rule; double published[3], normalised[3], over[3];
} probe_example;

typedef struct probe_scene {
    const char *name; double background[3], opaque_weight, background_weight;
    int object_count; const probe_object *objects;
    int view_count; const probe_view *views;
    int example_count; const probe_example *examples;
} probe_scene;

#define PROBE_COUNT(array) ((int)(sizeof(array) / sizeof((array)[0])))

/* one axis-aligned rectangle, named by the direction its outside looks to */
#define PROBE_FACE_XP(x, y0, y1, z0, z1) \
    { 4, { {x, y0, z0}, {x, y1, z0}, {x, y1, z1}, {x, y0, z1} } }
#define PROBE_FACE_XN(x, y0, y1, z0, z1) \
    { 4, { {x, y0, z0}, {x, y0, z1}, {x, y1, z1}, {x, y1, z0} } }
#define PROBE_FACE_YP(y, x0, x1, z0, z1) \
    { 4, { {x0, y, z0}, {x0, y, z1}, {x1, y, z1}, {x1, y, z0} } }
#define PROBE_FACE_YN(y, x0, x1, z0, z1) \
    { 4, { {x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1} } }
#define PROBE_FACE_ZP(z, x0, x1, y0, y1) \
    { 4, { {x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z} } }
#define PROBE_FACE_ZN(z, x0, x1, y0, y1) \
    { 4, { {x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z} } }

/* the six polygons of a box, seen from outside */
#define PROBE_BOX(x0, x1, y0, y1, z0, z1) \
    PROBE_FACE_XN(x0, y0, y1, z0, z1), PROBE_FACE_XP(x1, y0, y1, z0, z1), \
    PROBE_FACE_YN(y0, x0, x1, z0, z1), PROBE_FACE_YP(y1, x0, x1, z0, z1), \
    PROBE_FACE_ZN(z0, x0, x1, y0, y1), PROBE_FACE_ZP(z1, x0, x1, y0, y1)

/* cameras used more than once: orthographic, half width 4, depth 10 at the origin */
/* picture x = x, y = y, depth = 10 - z */
#define PROBE_FROM_ZP { false, {0, 0, 10}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 4.0, 1.0, 20.0 }
/* picture x = -x, y = y, depth = 10 + z */
#define PROBE_FROM_ZN { false, {0, 0, -10}, {-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, 4.0, 1.0, 20.0 }
/* picture x = -z, y = y, depth = 10 - x */
#define PROBE_FROM_XP { false, {10, 0, 0}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}, 4.0, 1.0, 20.0 }
/* picture x = z, y = y, depth = 10 + x */
#define PROBE_FROM_XN { false, {-10, 0, 0}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, 4.0, 1.0, 20.0 }
/* picture x = x, y = -z, depth = 10 - y */
#define PROBE_FROM_YP { false, {0, 10, 0}, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}, 4.0, 1.0, 20.0 }

/* ---- Scene 1: figure 4a, a convex transparent object --------------------------------- */

static const probe_polygon probe_s1_p1[] = { PROBE_BOX(-2.0, 2.0, -2.0, 2.0, -1.0, 1.0) };
static const probe_polygon probe_s1_p2[] = { PROBE_BOX(-1.5, -0.5, 1.0, 1.8, -0.5, 0.5) };   /* inside */
static const probe_polygon probe_s1_p3[] = { PROBE_BOX(0.5, 1.5, 0.0, 0.8, 2.0, 3.0) };      /* in front */
static const probe_polygon probe_s1_p4[] = { PROBE_BOX(-1.5, -0.5, 0.0, 0.8, -3.0, -2.0) };  /* behind */
static const probe_polygon probe_s1_p5[] = { PROBE_BOX(0.8, 3.0, -1.0, -0.2, -0.5, 0.5) };   /* pokes out sideways */
static const probe_polygon probe_s1_p6[] = { PROBE_BOX(-1.5, -0.5, -1.8, -1.2, 0.5, 1.5) };  /* pokes out in front */
static const probe_polygon probe_s1_p7[] = { PROBE_BOX(0.0, 1.2, -1.8, -1.2, -2.0, -0.5) };  /* pokes out behind */
static const probe_polygon probe_s1_p8[] = { PROBE_BOX(-3.0, -1.0, -1.0, -0.2, -3.0, -2.0) };/* behind, reaching past the side */

static const probe_object probe_s1_objects[] = {
    { 1, true, false, {0.2, 0.4, 0.8}, 0.6, PROBE_COUNT(probe_s1_p1), probe_s1_p1 },
    { 2, false, false, {0.8, 0.2, 0.0}, 1.0, PROBE_COUNT(probe_s1_p2), probe_s1_p2 },
    { 3, false, false, {0.1, 0.7, 0.1}, 1.0, PROBE_COUNT(probe_s1_p3), probe_s1_p3 },
    { 4, false, false, {0.5, 0.5, 0.0}, 1.0, PROBE_COUNT(probe_s1_p4), probe_s1_p4 },
    { 5, false, false, {0.6, 0.0, 0.6}, 1.0, PROBE_COUNT(probe_s1_p5), probe_s1_p5 },
    { 6, false, false, {0.0, 0.5, 0.5}, 1.0, PROBE_COUNT(probe_s1_p6), probe_s1_p6 },
    { 7, false, false, {0.9, 0.6, 0.3}, 1.0, PROBE_COUNT(probe_s1_p7), probe_s1_p7 },
    { 8, false, false, {0.3, 0.1, 0.2}, 1.0, PROBE_COUNT(probe_s1_p8), probe_s1_p8 },
};

/* from +z: 1f 9, 1b 11 over x -2..2, y -2..2 */
static const probe probe_s1_front[] = {
    { -0.25, 0.35, {1, 2}, {1, 2}, {1, 2} },      /* x -1, y 1.4: 1f 9, 2 at 9.5, 1b 11 */
    { -0.25, 0.1, {1, 0}, {1, 0}, {1, 4} },       /* EXPLICIT: x -1, y 0.4: 1f 9, 1b 11, 4 at 12 */
    { 0.25, 0.1, {0, 3}, {0, 3}, {0, 3} },        /* x 1, y 0.4: 3 at 7, 1f 9, 1b 11 */
    { 0.25, 0.35, {1, 0}, {1, 0}, {1, 0} },       /* x 1, y 1.4: 1f 9, 1b 11 */
    { 0.35, -0.15, {1, 5}, {1, 5}, {1, 5} },      /* x 1.4, y -0.6: 1f 9, 5 at 9.5, 1b 11 */
    { 0.62, -0.15, {0, 5}, {0, 5}, {0, 5} },      /* x 2.48, y -0.6: 5 at 9.5, outside 1 */
    { -0.25, -0.375, {0, 6}, {0, 6}, {0, 6} },    /* x -1, y -1.5: 6 at 8.5, 1f 9, 1b 11 */
    { 0.15, -0.375, {1, 7}, {1, 7}, {1, 7} },     /* x 0.6, y -1.5: 1f 9, 7 at 10.5, 1b 11 */
    { 0.85, 0.85, {0, 0}, {0, 0}, {0, 0} },       /* x 3.4, y 3.4: nothing */
    { -0.4375, 0.35, {1, 0}, {1, 0}, {1, 0} },    /* x -1.75, y 1.4: 1f 9, 1b 11, beside 2 */
    { 0.6, 0.6, {0, 0}, {0, 0}, {0, 0} },         /* x 2.4, y 2.4: nothing */
    { 0.0, -0.15, {1, 0}, {1, 0}, {1, 0} },       /* x 0, y -0.6: 1f 9, 1b 11 */
    { -0.625, -0.15, {0, 8}, {0, 8}, {0, 8} },    /* x -2.5, y -0.6: 8 at 12, outside 1 */
    { -0.375, -0.15, {1, 0}, {1, 0}, {1, 8} },    /* EXPLICIT: x -1.5, y -0.6: 1f 9, 1b 11, 8 at 12 */
};

/* aslant: picture x is s = 0.8 x - 0.6 z, depth = 10 - t with t = 0.6 x + 0.8 z, half width 3;
 * on a ray x = 0.8 s + 0.6 t, z = -0.6 s + 0.8 t.  Object 1: front face z = 1 for s < 1, x = 2
 * for s > 1; back face x = -2 for s < -1, z = -1 for s > -1; outline s -2.2..2.2. */
static const probe probe_s1_aslant[] = {
    { -0.4, 0.45, {1, 2}, {1, 2}, {1, 2} },       /* s -1.2, y 1.35: 1f (z=1) 9.65, 2 (z=0.5) 10.275, 1b (x=-2) 11.733 */
    { -0.15, 0.45, {1, 2}, {1, 2}, {1, 2} },      /* s -0.45, y 1.35: 1f 9.0875, 2 (x=-0.5) 10.233, 1b (z=-1) 11.5875 */
    { -0.12, 0.13, {0, 3}, {0, 3}, {0, 3} },      /* s -0.36, y 0.39: 3 (x=1.5) 7.02, 1f 9.02, 1b 11.52 */
    { -0.4, 0.13, {0, 3}, {0, 3}, {0, 3} },       /* s -1.2, y 0.39: 3 (z=3) 7.15, 1f 9.65, 1b 11.733 */
    { 0.1, 0.13, {1, 0}, {1, 0}, {1, 4} },        /* EXPLICIT: s 0.3, y 0.39: 1f 8.525, 1b 11.025, 4 (z=-2) 12.275 */
    { 0.22, -0.2, {1, 5}, {1, 5}, {1, 5} },       /* s 0.66, y -0.6: 1f 8.255, 5 (z=0.5) 8.88, 1b 10.755 */
    { 0.385, -0.2, {1, 5}, {1, 5}, {1, 5} },      /* s 1.155, y -0.6: 1f (x=2) 8.2067, 5 (z=0.5) 8.50875, 1b 10.384 */
    { 0.55, -0.2, {0, 5}, {0, 5}, {0, 5} },       /* s 1.65, y -0.6: 5 (z=0.5, x 2.4375) 8.1375, 1f (x=2) 8.867, 1b 10.0125 */
    { 0.8, -0.2, {0, 5}, {0, 5}, {0, 5} },        /* s 2.4, y -0.6: 5 (x=3) 8.2, outside 1 */
    { -0.6, -0.5, {0, 6}, {0, 6}, {0, 6} },       /* s -1.8, y -1.5: 6 (z=1.5) 9.475, 1f 10.1, 1b 10.933 */
    { -0.385, -0.5, {0, 6}, {0, 6}, {0, 6} },     /* s -1.155, y -1.5: 6 (x=-0.5, z 1.258) 9.293, 1f 9.616, 1b 11.793 */
    { -0.285, -0.5, {1, 6}, {1, 6}, {1, 6} },     /* s -0.855, y -1.5: 1f 9.391, 6 (x=-0.5, z 0.758) 9.693, 1b 11.891 */
    { 0.25, -0.5, {1, 7}, {1, 7}, {1, 7} },       /* s 0.75, y -1.5: 1f 8.1875, 7 (z=-0.5) 10.0625, 1b 10.6875 */
    { 0.47, -0.5, {1, 7}, {1, 7}, {1, 7} },       /* s 1.41, y -1.5: 1f (x=2) 8.547, 7 (x=1.2, z -0.75) 9.88, 1b 10.1925 */
    { 0.62, -0.5, {1, 0}, {1, 0}, {1, 7} },       /* EXPLICIT: s 1.86, y -1.5: 1f (x=2) 9.147, 1b 9.855, 7 (x=1.2, z -1.5) 10.48 */
    { 0.9, 0.5, {0, 0}, {0, 0}, {0, 0} },         /* s 2.7, y 1.5: nothing */
};

static const probe_view probe_s1_views[] = {
    { "front", PROBE_FROM_ZP, PROBE_COUNT(probe_s1_front), probe_s1_front },
    { "aslant", { false, {6, 0, 8}, {0.8, 0, -0.6}, {0, 1, 0}, {0.6, 0, 0.8}, 3.0, 1.0, 20.0 },
      PROBE_COUNT(probe_s1_aslant), probe_s1_aslant },
};

static const probe_example probe_s1_examples[] = {
    /* 1 over 2, a 0.6, w_o 0.8: a C_t = (0.12, 0.24, 0.48); published adds 0.8 (0.8, 0.2, 0) =
     * (0.64, 0.16, 0); normalised divides by 1.4; over adds 0.4 (0.8, 0.2, 0) = (0.32, 0.08, 0) */
    { 0, 0, false, {0.76, 0.4, 0.48}, {0.76 / 1.4, 0.4 / 1.4, 0.48 / 1.4}, {0.44, 0.32, 0.48} },
    /* 1 over the background, w_b 0.2: published adds 0.2 (0.8, 0.8, 0.9) = (0.16, 0.16, 0.18);
     * normalised divides by 0.8; over adds 0.4 (0.8, 0.8, 0.9) = (0.32, 0.32, 0.36) */
    { 0, 1, false, {0.28, 0.4, 0.66}, {0.35, 0.5, 0.825}, {0.44, 0.56, 0.84} },
    /* 3 alone: its own colour */
    { 0, 2, false, {0.1, 0.7, 0.1}, {0.1, 0.7, 0.1}, {0.1, 0.7, 0.1} },
};

#define PROBE_SCENE_1 { "figure 4a, convex", {0.8, 0.8, 0.9}, 0.8, 0.2, \
    PROBE_COUNT(probe_s1_objects), probe_s1_objects, PROBE_COUNT(probe_s1_views), probe_s1_views, \
    PROBE_COUNT(probe_s1_examples), probe_s1_examples }

/* ---- Scene 2: figure 4b, a concave transparent object -------------------------------- */

/* A U lying on its side, open towards +x, the same for all y in -2..2.  In the plane of x and
 * z: first arm z 1..2 and second arm z -2..-1 over x -2..2, joined by the part x -3..-2.  Top
 * and bottom are cut at the corners so that all edges of neighbouring polygons agree. */
static const probe_polygon probe_s2_p1[] = {
    PROBE_FACE_ZP(2.0, -3.0, 2.0, -2.0, 2.0),   /* first arm, outer side */
    PROBE_FACE_XP(2.0, -2.0, 2.0, 1.0, 2.0),    /* first arm, end */
    PROBE_FACE_ZN(1.0, -2.0, 2.0, -2.0, 2.0),   /* first arm, side to the gap */
    PROBE_FACE_XP(-2.0, -2.0, 2.0, -1.0, 1.0),  /* bottom of the gap */
    PROBE_FACE_ZP(-1.0, -2.0, 2.0, -2.0, 2.0),  /* second arm, side to the gap */
    PROBE_FACE_XP(2.0, -2.0, 2.0, -2.0, -1.0),  /* second arm, end */
    PROBE_FACE_ZN(-2.0, -3.0, 2.0, -2.0, 2.0),  /* second arm, outer side */
    PROBE_FACE_XN(-3.0, -2.0, 2.0, -2.0, 2.0),  /* outer side of the joining part */
    { 4, { {-3, 2, 2}, {2, 2, 2}, {2, 2, 1}, {-2, 2, 1} } },          /* tops, outside to +y */
    { 4, { {-3, 2, -2}, {-3, 2, 2}, {-2, 2, 1}, {-2, 2, -1} } },
    { 4, { {2, 2, -2}, {-3, 2, -2}, {-2, 2, -1}, {2, 2, -1} } },
    { 4, { {-3, -2, 2}, {-2, -2, 1}, {2, -2, 1}, {2, -2, 2} } },      /* bottoms, outside to -y */
    { 4, { {-3, -2, -2}, {-2, -2, -1}, {-2, -2, 1}, {-3, -2, 2} } },
    { 4, { {2, -2, -2}, {2, -2, -1}, {-2, -2, -1}, {-3, -2, -2} } },
};
static const probe_polygon probe_s2_p2[] = { PROBE_BOX(-1.5, -0.5, 0.8, 1.6, 1.2, 1.8) };    /* in the first arm */
static const probe_polygon probe_s2_p3[] = { PROBE_BOX(0.5, 1.5, 0.8, 1.6, -1.8, -1.2) };    /* in the second arm */
static const probe_polygon probe_s2_p4[] = { PROBE_BOX(-1.5, -0.5, -0.4, 0.4, -0.5, 0.5) };  /* in the gap */
static const probe_polygon probe_s2_p5[] = { PROBE_BOX(0.4, 1.4, -0.4, 0.4, 0.0, 1.5) };     /* from the gap into the first arm */
static const probe_polygon probe_s2_p6[] = { PROBE_BOX(-2.8, -2.2, -0.4, 0.4, -1.8, -1.2) }; /* in the joining part */
static const probe_polygon probe_s2_p7[] = { PROBE_BOX(1.0, 3.0, -1.6, -0.8, -0.5, 0.5) };   /* in the gap and out at its open side */
static const probe_polygon probe_s2_p8[] = { PROBE_BOX(-1.5, -0.5, -1.6, -0.8, 2.5, 3.0) };  /* on the +z side */
static const probe_polygon probe_s2_p9[] = { PROBE_BOX(-3.6, -2.4, -1.6, -0.8, -3.5, -3.0) };/* on the -z side */

static const probe_object probe_s2_objects[] = {
    { 1, true, false, {0.9, 0.6, 0.3}, 0.8, PROBE_COUNT(probe_s2_p1), probe_s2_p1 },
    { 2, false, false, {0.4, 0.2, 0.8}, 1.0, PROBE_COUNT(probe_s2_p2), probe_s2_p2 },
    { 3, false, false, {0.8, 0.1, 0.1}, 1.0, PROBE_COUNT(probe_s2_p3), probe_s2_p3 },
    { 4, false, false, {0.1, 0.6, 0.2}, 1.0, PROBE_COUNT(probe_s2_p4), probe_s2_p4 },
    { 5, false, false, {0.2, 0.3, 0.7}, 1.0, PROBE_COUNT(probe_s2_p5), probe_s2_p5 },
    { 6, false, false, {0.7, 0.7, 0.1}, 1.0, PROBE_COUNT(probe_s2_p6), probe_s2_p6 },
    { 7, false, false, {0.0, 0.5, 0.6}, 1.0, PROBE_COUNT(probe_s2_p7), probe_s2_p7 },
    { 8, false, false, {0.5, 0.0, 0.5}, 1.0, PROBE_COUNT(probe_s2_p8), probe_s2_p8 },
    { 9, false, false, {0.3, 0.2, 0.1}, 1.0, PROBE_COUNT(probe_s2_p9), probe_s2_p9 },
};

/* from +z: over x -2..2: 1f 8, 1b 9, 1f 11, 1b 12; over x -3..-2: 1f 8, 1b 12 */
static const probe probe_s2_front[] = {
    { -0.25, 0.3, {1, 2}, {1, 2}, {1, 2} },     /* x -1, y 1.2: 1f 8, 2 at 8.2, 1b 9 */
    { 0.25, 0.3, {1, 0}, {1, 0}, {1, 0} },      /* x 1, y 1.2: 1f 8, 1b 9, 1f 11, 3 at 11.2, 1b 12 */
    { -0.25, 0.0, {1, 0}, {1, 0}, {1, 4} },     /* EXPLICIT: x -1, y 0: 1f 8, 1b 9, 4 at 9.5 */
    { 0.225, 0.0, {1, 5}, {1, 5}, {1, 5} },     /* x 0.9, y 0: 1f 8, 5 at 8.5, 1b 9 */
    { -0.625, 0.0, {1, 6}, {1, 6}, {1, 6} },    /* x -2.5, y 0: 1f 8, 6 at 11.2, 1b 12 */
    { 0.375, -0.3, {1, 0}, {1, 0}, {1, 7} },    /* EXPLICIT: x 1.5, y -1.2: 1f 8, 1b 9, 7 at 9.5 */
    { 0.625, -0.3, {0, 7}, {0, 7}, {0, 7} },    /* x 2.5, y -1.2: 7 at 9.5, outside 1 */
    { -0.25, -0.3, {0, 8}, {0, 8}, {0, 8} },    /* x -1, y -1.2: 8 at 7, 1f 8 */
    { -0.825, -0.3, {0, 9}, {0, 9}, {0, 9} },   /* x -3.3, y -1.2: 9 at 13, outside 1 */
    { -0.675, -0.3, {1, 0}, {1, 0}, {1, 9} },   /* EXPLICIT: x -2.7, y -1.2: 1f 8, 1b 12, 9 at 13 */
    { 0.6, 0.3, {0, 0}, {0, 0}, {0, 0} },       /* x 2.4, y 1.2: nothing */
    { -0.05, 0.15, {1, 0}, {1, 0}, {1, 0} },    /* x -0.2, y 0.6: 1f 8, 1b 9, 1f 11, 1b 12 */
};

/* from -z: over x -2..2: 1f 8, 1b 9, 1f 11, 1b 12; over x -3..-2: 1f 8, 1b 12 */
static const probe probe_s2_rear[] = {
    { -0.25, 0.3, {1, 3}, {1, 3}, {1, 3} },     /* x 1, y 1.2: 1f 8, 3 at 8.2, 1b 9 */
    { 0.25, 0.3, {1, 0}, {1, 0}, {1, 0} },      /* x -1, y 1.2: 1f 8, 1b 9, 1f 11, 2 at 11.2 */
    { 0.25, 0.0, {1, 0}, {1, 0}, {1, 4} },      /* EXPLICIT: x -1, y 0: 1f 8, 1b 9, 4 at 9.5 */
    { -0.225, 0.0, {1, 0}, {1, 0}, {1, 5} },    /* EXPLICIT: x 0.9, y 0: 1f 8, 1b 9, 5 at 10 */
    { 0.625, 0.0, {1, 6}, {1, 6}, {1, 6} },     /* x -2.5, y 0: 1f 8, 6 at 8.2, 1b 12 */
    { 0.25, -0.3, {1, 0}, {1, 0}, {1, 0} },     /* x -1, y -1.2: 1f 8, 1b 9, 1f 11, 1b 12, 8 at 12.5 */
    { 0.825, -0.3, {0, 9}, {0, 9}, {0, 9} },    /* x -3.3, y -1.2: 9 at 6.5 */
    { 0.675, -0.3, {0, 9}, {0, 9}, {0, 9} },    /* x -2.7, y -1.2: 9 at 6.5, 1f 8 */
    { -0.625, -0.3, {0, 7}, {0, 7}, {0, 7} },   /* x 2.5, y -1.2: 7 at 9.5, outside 1 */
    { -0.375, -0.3, {1, 0}, {1, 0}, {1, 7} },   /* EXPLICIT: x 1.5, y -1.2: 1f 8, 1b 9, 7 at 9.5 */
};

/* from +x, into the gap: over z -1..1: 1f 12, 1b 13; over the arms: 1f 8, 1b 13 */
static const probe probe_s2_side[] = {
    { 0.0625, 0.0, {0, 4}, {0, 4}, {0, 4} },    /* z -0.25, y 0: 4 at 10.5 in the open gap, 1f 12, 1b 13 */
    { -0.1875, 0.0, {0, 5}, {0, 5}, {0, 5} },   /* z 0.75, y 0: 5 at 8.6 in the open gap, 1f 12 */
    { -0.3125, 0.0, {1, 5}, {1, 5}, {1, 5} },   /* z 1.25, y 0: 1f 8, 5 at 8.6, 1b 13 */
    { 0.375, 0.0, {1, 6}, {1, 6}, {1, 6} },     /* z -1.5, y 0: 1f 8, 6 at 12.2, 1b 13 */
    { 0.0, 0.3, {1, 0}, {1, 0}, {1, 0} },       /* z 0, y 1.2: 1f 12, 1b 13 */
};

static const probe_view probe_s2_views[] = {
    { "front", PROBE_FROM_ZP, PROBE_COUNT(probe_s2_front), probe_s2_front },
    { "rear", PROBE_FROM_ZN, PROBE_COUNT(probe_s2_rear), probe_s2_rear },
    { "into the gap", PROBE_FROM_XP, PROBE_COUNT(probe_s2_side), probe_s2_side },
};

static const probe_example probe_s2_examples[] = {
    /* 1 over 2, a 0.8, w_o 0.9: a C_t = (0.72, 0.48, 0.24); published adds 0.9 (0.4, 0.2, 0.8) =
     * (0.36, 0.18, 0.72): (1.08, 0.66, 0.96), red clamped to 1; normalised divides the unclamped
     * sum by 1.7; over adds 0.2 (0.4, 0.2, 0.8) = (0.08, 0.04, 0.16) */
    { 0, 0, false, {1.0, 0.66, 0.96}, {1.08 / 1.7, 0.66 / 1.7, 0.96 / 1.7}, {0.8, 0.52, 0.4} },
    /* 1 over the background, w_b 0.2: published adds 0.2 (0.6, 0.7, 0.8) = (0.12, 0.14, 0.16);
     * normalised divides by 1.0; over adds 0.2 (0.6, 0.7, 0.8), the same */
    { 0, 1, false, {0.84, 0.62, 0.4}, {0.84, 0.62, 0.4}, {0.84, 0.62, 0.4} },
    /* 1 over 6: published adds 0.9 (0.7, 0.7, 0.1) = (0.63, 0.63, 0.09): (1.35, 1.11, 0.33), red and
     * green clamped; normalised divides by 1.7; over adds 0.2 (0.7, 0.7, 0.1) = (0.14, 0.14, 0.02) */
    { 0, 4, false, {1.0, 1.0, 0.33}, {1.35 / 1.7, 1.11 / 1.7, 0.33 / 1.7}, {0.86, 0.62, 0.26} },
};

#define PROBE_SCENE_2 { "figure 4b, concave", {0.6, 0.7, 0.8}, 0.9, 0.2, \
    PROBE_COUNT(probe_s2_objects), probe_s2_objects, PROBE_COUNT(probe_s2_views), probe_s2_views, \
    PROBE_COUNT(probe_s2_examples), probe_s2_examples }

/* ---- Scene 3: figure 9a, a mug around an opaque box ----------------------------------- */

/* outside x, y, z -2..2; cavity x, z -1.4..1.4 from the floor y = -1.4 up to the open top y = 2 */
static const probe_polygon probe_s3_p1[] = {
    PROBE_FACE_XN(-2.0, -2.0, 2.0, -2.0, 2.0), PROBE_FACE_XP(2.0, -2.0, 2.0, -2.0, 2.0),
    PROBE_FACE_ZN(-2.0, -2.0, 2.0, -2.0, 2.0), PROBE_FACE_ZP(2.0, -2.0, 2.0, -2.0, 2.0),
    PROBE_FACE_YN(-2.0, -2.0, 2.0, -2.0, 2.0),
    /* walls of the cavity, outside towards its middle */
    PROBE_FACE_XP(-1.4, -1.4, 2.0, -1.4, 1.4), PROBE_FACE_XN(1.4, -1.4, 2.0, -1.4, 1.4),
    PROBE_FACE_ZP(-1.4, -1.4, 1.4, -1.4, 2.0), PROBE_FACE_ZN(1.4, -1.4, 1.4, -1.4, 2.0),
    PROBE_FACE_YP(-1.4, -1.4, 1.4, -1.4, 1.4),
    /* rim, outside to +y: at +z, -z, -x, +x */
    { 4, { {-2, 2, 2}, {2, 2, 2}, {1.4, 2, 1.4}, {-1.4, 2, 1.4} } },
    { 4, { {2, 2, -2}, {-2, 2, -2}, {-1.4, 2, -1.4}, {1.4, 2, -1.4} } },
    { 4, { {-2, 2, -2}, {-2, 2, 2}, {-1.4, 2, 1.4}, {-1.4, 2, -1.4} } },
    { 4, { {2, 2, 2}, {2, 2, -2}, {1.4, 2, -1.4}, {1.4, 2, 1.4} } },
};
static const probe_polygon probe_s3_p2[] = { PROBE_BOX(-1.0, 0.2, -1.0, 1.0, -0.8, 0.8) };   /* the box in the cavity */
static const probe_polygon probe_s3_p3[] = { PROBE_BOX(0.5, 1.1, -1.0, 3.0, -0.3, 0.3) };    /* a spoon, out at the top */
static const probe_polygon probe_s3_p4[] = { PROBE_BOX(-0.6, 0.0, 1.0, 1.8, 1.5, 1.9) };     /* in the wall at +z */
static const probe_polygon probe_s3_p5[] = { PROBE_BOX(-0.5, 0.5, -1.9, -1.5, -1.3, 1.3) };  /* in the floor */
static const probe_polygon probe_s3_p6[] = { PROBE_BOX(-1.9, -1.5, -0.5, 0.5, -0.5, 0.5) };  /* in the wall at -x */
static const probe_polygon probe_s3_p7[] = { PROBE_BOX(1.2, 2.8, -1.2, -0.2, 3.0, 3.5) };    /* outside, on the +z side */
static const probe_polygon probe_s3_p8[] = { PROBE_BOX(-3.2, -1.4, 1.0, 1.8, -3.5, -3.0) };  /* outside, on the -z side */

static const probe_object probe_s3_objects[] = {
    { 1, true, false, {0.5, 0.8, 0.9}, 0.5, PROBE_COUNT(probe_s3_p1), probe_s3_p1 },
    { 2, false, false, {0.8, 0.3, 0.1}, 1.0, PROBE_COUNT(probe_s3_p2), probe_s3_p2 },
    { 3, false, false, {0.6, 0.6, 0.6}, 1.0, PROBE_COUNT(probe_s3_p3), probe_s3_p3 },
    { 4, false, false, {0.9, 0.1, 0.5}, 1.0, PROBE_COUNT(probe_s3_p4), probe_s3_p4 },
    { 5, false, false, {0.1, 0.4, 0.1}, 1.0, PROBE_COUNT(probe_s3_p5), probe_s3_p5 },
    { 6, false, false, {0.3, 0.2, 0.7}, 1.0, PROBE_COUNT(probe_s3_p6), probe_s3_p6 },
    { 7, false, false, {0.9, 0.8, 0.1}, 1.0, PROBE_COUNT(probe_s3_p7), probe_s3_p7 },
    { 8, false, false, {0.0, 0.3, 0.4}, 1.0, PROBE_COUNT(probe_s3_p8), probe_s3_p8 },
};

/* from +z: before the cavity (x -1.4..1.4, y over -1.4): 1f 8, 1b 8.6, 1f 11.4, 1b 12; else 1f 8, 1b 12 */
static const probe probe_s3_side[] = {
    { -0.1, 0.0, {1, 0}, {1, 0}, {1, 2} },        /* EXPLICIT: x -0.4, y 0: 1f 8, 1b 8.6, 2 at 9.2 */
    { -0.2, -0.2, {1, 0}, {1, 0}, {1, 2} },       /* EXPLICIT: x -0.8, y -0.8: 1f 8, 1b 8.6, 2 at 9.2 */
    { 0.2, 0.1, {1, 0}, {1, 0}, {1, 3} },         /* EXPLICIT: x 0.8, y 0.4: 1f 8, 1b 8.6, 3 at 9.7 */
    { 0.2, 0.65, {0, 3}, {0, 3}, {0, 3} },        /* x 0.8, y 2.6: 3 at 9.7 above the mug */
    { -0.075, 0.375, {1, 4}, {1, 4}, {1, 4} },    /* x -0.3, y 1.5: 1f 8, 4 at 8.1, 1b 8.6 */
    { 0.0, -0.425, {1, 5}, {1, 5}, {1, 5} },      /* x 0, y -1.7: 1f 8, 5 at 8.7, 1b 12 */
    { -0.425, 0.0, {1, 6}, {1, 6}, {1, 6} },      /* x -1.7, y 0: 1f 8, 6 at 9.5, 1b 12 */
    { 0.6, -0.175, {0, 7}, {0, 7}, {0, 7} },      /* x 2.4, y -0.7: 7 at 6.5 */
    { 0.4, -0.175, {0, 7}, {0, 7}, {0, 7} },      /* x 1.6, y -0.7: 7 at 6.5, 1f 8, 1b 12 */
    { -0.65, 0.35, {0, 8}, {0, 8}, {0, 8} },      /* x -2.6, y 1.4: 8 at 13, outside 1 */
    { -0.425, 0.35, {1, 0}, {1, 0}, {1, 8} },     /* EXPLICIT: x -1.7, y 1.4: 1f 8, 1b 12, 8 at 13 */
    { 0.425, 0.35, {1, 0}, {1, 0}, {1, 0} },      /* x 1.7, y 1.4: 1f 8, 1b 12 */
    { 0.0, 0.85, {0, 0}, {0, 0}, {0, 0} },        /* x 0, y 3.4: nothing */
    { 0.8, 0.8, {0, 0}, {0, 0}, {0, 0} },         /* x 3.2, y 3.2: nothing */
};

/* from +y: in the cavity 1f 11.4 (floor), 1b 12; on the rim 1f 8, 1b 12 */
static const probe probe_s3_top[] = {
    { -0.1875, 0.0, {0, 2}, {0, 2}, {0, 2} },     /* x -0.75, z 0: 2 at 9 through the open top, 1f 11.4 */
    { 0.2, 0.0, {0, 3}, {0, 3}, {0, 3} },         /* x 0.8, z 0: 3 at 7, 1f 11.4 */
    { 0.0, -0.2625, {1, 5}, {1, 5}, {1, 5} },     /* x 0, z 1.05: 1f 11.4, 5 at 11.5, 1b 12 */
    { 0.0, 0.2625, {1, 5}, {1, 5}, {1, 5} },      /* x 0, z -1.05: 1f 11.4, 5 at 11.5, 1b 12 */
    { 0.225, -0.25, {1, 0}, {1, 0}, {1, 0} },     /* x 0.9, z 1: 1f 11.4, 1b 12 */
    { -0.075, -0.425, {1, 4}, {1, 4}, {1, 4} },   /* x -0.3, z 1.7: 1f 8, 4 at 8.2, 1b 12 */
    { -0.425, 0.0, {1, 6}, {1, 6}, {1, 6} },      /* x -1.7, z 0: 1f 8, 6 at 9.5, 1b 12 */
    { 0.5, -0.8125, {0, 7}, {0, 7}, {0, 7} },     /* x 2, z 3.25: 7 at 10.2, outside 1 */
    { -0.65, 0.8125, {0, 8}, {0, 8}, {0, 8} },    /* x -2.6, z -3.25: 8 at 8.2, outside 1 */
    { 0.425, -0.25, {1, 0}, {1, 0}, {1, 0} },     /* x 1.7, z 1: 1f 8, 1b 12 */
    { 0.8, 0.3, {0, 0}, {0, 0}, {0, 0} },         /* x 3.2, z -1.2: nothing */
};

/* from above and the front: picture y is w = 0.8 y - 0.6 z, depth = 10 - t with t = 0.6 y + 0.8 z;
 * on a ray y = 0.8 w + 0.6 t, z = -0.6 w + 0.8 t.  Rays with w 0.76..2.44 pass the open mouth
 * and meet the far cavity wall z = -1.4; with w 0.4..0.76 the near rim; lower ones the face z = 2. */
static const probe probe_s3_slanted[] = {
    { -0.1, 0.25, {0, 2}, {0, 2}, {0, 2} },       /* x -0.4, w 1: 2 (top y=1, z -0.333) 9.667, 1f (z=-1.4) 11, 1b (z=-2) 11.75 */
    { 0.2, 0.325, {0, 3}, {0, 3}, {0, 3} },       /* x 0.8, w 1.3: 3 (z=0.3, y 1.85) 8.65, 1f (z=-1.4) 10.775 */
    { 0.2, 0.0, {1, 0}, {1, 0}, {1, 3} },         /* EXPLICIT: x 0.8, w 0: 1f (z=2) 7.5, 1b (z=1.4) 8.25, 3 (z=0.3) 9.625 */
    { -0.2, 0.45, {1, 0}, {1, 0}, {1, 0} },       /* x -0.8, w 1.8: 1f (z=-1.4, y 1.2) 10.4, 1b (z=-2) 11.15 */
    { -0.075, 0.025, {1, 4}, {1, 4}, {1, 4} },    /* x -0.3, w 0.1: 1f (z=2) 7.425, 4 (z=1.9, y 1.55) 7.55, 1b (z=1.4) 8.175 */
};

static const probe_view probe_s3_views[] = {
    { "side", PROBE_FROM_ZP, PROBE_COUNT(probe_s3_side), probe_s3_side },
    { "straight down", PROBE_FROM_YP, PROBE_COUNT(probe_s3_top), probe_s3_top },
    { "slanted", { false, {0, 6, 8}, {1, 0, 0}, {0, 0.8, -0.6}, {0, 0.6, 0.8}, 4.0, 1.0, 20.0 },
      PROBE_COUNT(probe_s3_slanted), probe_s3_slanted },
};

static const probe_example probe_s3_examples[] = {
    /* 1 over the background, a 0.5, w_b 0.3: a C_t = (0.25, 0.4, 0.45); published adds
     * 0.3 (0.9, 0.9, 0.7) = (0.27, 0.27, 0.21); normalised divides by 0.8; over adds
     * 0.5 (0.9, 0.9, 0.7) = (0.45, 0.45, 0.35) */
    { 0, 0, false, {0.52, 0.67, 0.66}, {0.65, 0.8375, 0.825}, {0.7, 0.85, 0.8} },
    /* 1 over 4, w_o 0.75: published adds 0.75 (0.9, 0.1, 0.5) = (0.675, 0.075, 0.375); normalised
     * divides by 1.25; over adds 0.5 (0.9, 0.1, 0.5) = (0.45, 0.05, 0.25) */
    { 0, 4, false, {0.925, 0.475, 0.825}, {0.74, 0.38, 0.66}, {0.7, 0.45, 0.7} },
    /* from above, 2 alone: its own colour */
    { 1, 0, false, {0.8, 0.3, 0.1}, {0.8, 0.3, 0.1}, {0.8, 0.3, 0.1} },
};

#define PROBE_SCENE_3 { "figure 9a, mug", {0.9, 0.9, 0.7}, 0.75, 0.3, \
    PROBE_COUNT(probe_s3_objects), probe_s3_objects, PROBE_COUNT(probe_s3_views), probe_s3_views, \
    PROBE_COUNT(probe_s3_examples), probe_s3_examples }

/* ---- Scene 4: figure 9f, a crank in an eight-sided prism ------------------------------ */

/* prism along x, -2.4..2.4; in the plane of y and z an octagon (+-2, +-1), (+-1, +-2): the sides
 * are y = +-2, z = +-2 and |y| + |z| = 3 */
#define PROBE_S4_SIDE(ya, za, yb, zb) \
    { 4, { {-2.4, ya, za}, {-2.4, yb, zb}, {2.4, yb, zb}, {2.4, ya, za} } }
static const probe_polygon probe_s4_p1[] = {
    { 8, { {2.4, 2, -1}, {2.4, 2, 1}, {2.4, 1, 2}, {2.4, -1, 2},
           {2.4, -2, 1}, {2.4, -2, -1}, {2.4, -1, -2}, {2.4, 1, -2} } },
    { 8, { {-2.4, 1, -2}, {-2.4, -1, -2}, {-2.4, -2, -1}, {-2.4, -2, 1},
           {-2.4, -1, 2}, {-2.4, 1, 2}, {-2.4, 2, 1}, {-2.4, 2, -1} } },
    PROBE_S4_SIDE(2, -1, 2, 1), PROBE_S4_SIDE(2, 1, 1, 2),
    PROBE_S4_SIDE(1, 2, -1, 2), PROBE_S4_SIDE(-1, 2, -2, 1),
    PROBE_S4_SIDE(-2, 1, -2, -1), PROBE_S4_SIDE(-2, -1, -1, -2),
    PROBE_S4_SIDE(-1, -2, 1, -2), PROBE_S4_SIDE(1, -2, 2, -1),
};
static const probe_polygon probe_s4_p2[] = { PROBE_BOX(-3.4, -1.2, -0.4, 0.4, -0.4, 0.4) };  /* shaft at -x */
static const probe_polygon probe_s4_p3[] = { PROBE_BOX(-1.2, -0.6, -0.6, 1.7, -0.5, 0.5) };  /* web at -x */
static const probe_polygon probe_s4_p4[] = { PROBE_BOX(-0.6, 0.6, 0.5, 1.5, -0.3, 0.3) };    /* pin */
static const probe_polygon probe_s4_p5[] = { PROBE_BOX(0.6, 1.2, -0.6, 1.7, -0.5, 0.5) };    /* web at +x */
static const probe_polygon probe_s4_p6[] = { PROBE_BOX(1.2, 3.4, -0.4, 0.4, -0.4, 0.4) };    /* shaft at +x */
static const probe_polygon probe_s4_p7[] = { PROBE_BOX(-0.4, 0.4, -1.6, -0.9, 2.5, 3.0) };   /* outside, on the +z side */
static const probe_polygon probe_s4_p8[] = { PROBE_BOX(-2.9, -1.9, -1.7, -0.9, -4.0, -3.0) };/* outside, on the -z side */
static const probe_polygon probe_s4_p9[] = { PROBE_BOX(1.4, 2.2, 0.8, 2.0, 0.8, 1.6) };      /* through the side y + z = 3 */

static const probe_object probe_s4_objects[] = {
    { 1, true, false, {0.6, 0.9, 0.3}, 0.4, PROBE_COUNT(probe_s4_p1), probe_s4_p1 },
    { 2, false, false, {0.7, 0.1, 0.1}, 1.0, PROBE_COUNT(probe_s4_p2), probe_s4_p2 },
    { 3, false, false, {0.1, 0.1, 0.7}, 1.0, PROBE_COUNT(probe_s4_p3), probe_s4_p3 },
    { 4, false, false, {0.8, 0.5, 0.2}, 1.0, PROBE_COUNT(probe_s4_p4), probe_s4_p4 },
    { 5, false, false, {0.2, 0.6, 0.6}, 1.0, PROBE_COUNT(probe_s4_p5), probe_s4_p5 },
    { 6, false, false, {0.9, 0.3, 0.6}, 1.0, PROBE_COUNT(probe_s4_p6), probe_s4_p6 },
    { 7, false, false, {0.4, 0.4, 0.0}, 1.0, PROBE_COUNT(probe_s4_p7), probe_s4_p7 },
    { 8, false, false, {0.0, 0.2, 0.1}, 1.0, PROBE_COUNT(probe_s4_p8), probe_s4_p8 },
    { 9, false, false, {0.5, 0.0, 0.9}, 1.0, PROBE_COUNT(probe_s4_p9), probe_s4_p9 },
};

/* from +z: for |y| < 1: 1f 8, 1b 12; for |y| 1..2: 1f 7 + |y|, 1b 13 - |y| */
static const probe probe_s4_front[] = {
    { -0.75, 0.0, {0, 2}, {0, 2}, {0, 2} },           /* x -3, y 0: 2 at 9.6, outside 1 */
    { -0.45, 0.0, {1, 2}, {1, 2}, {1, 2} },           /* x -1.8, y 0: 1f 8, 2 at 9.6, 1b 12 */
    { -0.225, 0.15, {1, 3}, {1, 3}, {1, 3} },         /* x -0.9, y 0.6: 1f 8, 3 at 9.5, 1b 12 */
    { 0.0, 0.3125, {1, 4}, {1, 4}, {1, 4} },          /* x 0, y 1.25: 1f 8.25, 4 at 9.7, 1b 11.75 */
    { 0.0, 0.1875, {1, 4}, {1, 4}, {1, 4} },          /* x 0, y 0.75: 1f 8, 4 at 9.7, 1b 12 */
    { 0.225, 0.15, {1, 5}, {1, 5}, {1, 5} },          /* x 0.9, y 0.6: 1f 8, 5 at 9.5, 1b 12 */
    { 0.225, -0.075, {1, 5}, {1, 5}, {1, 5} },        /* x 0.9, y -0.3: 1f 8, 5 at 9.5, 1b 12 */
    { 0.45, 0.0, {1, 6}, {1, 6}, {1, 6} },            /* x 1.8, y 0: 1f 8, 6 at 9.6, 1b 12 */
    { 0.75, 0.0, {0, 6}, {0, 6}, {0, 6} },            /* x 3, y 0: 6 at 9.6, outside 1 */
    { 0.0, -0.3125, {0, 7}, {0, 7}, {0, 7} },         /* x 0, y -1.25: 7 at 7, 1f 8.25 */
    { -0.6625, -0.3125, {0, 8}, {0, 8}, {0, 8} },     /* x -2.65, y -1.25: 8 at 13, outside 1 */
    { -0.5375, -0.3125, {1, 0}, {1, 0}, {1, 8} },     /* EXPLICIT: x -2.15, y -1.25: 1f 8.25, 1b 11.75, 8 at 13 */
    { 0.45, 0.3, {1, 9}, {1, 9}, {1, 9} },            /* x 1.8, y 1.2: 1f 8.2, 9 at 8.4, 1b 11.8 */
    { 0.45, 0.425, {0, 9}, {0, 9}, {0, 9} },          /* x 1.8, y 1.7: 9 at 8.4, 1f 8.7, 1b 11.3 */
    { 0.0, 0.0, {1, 0}, {1, 0}, {1, 0} },             /* x 0, y 0: between the webs, under the pin: 1f 8, 1b 12 */
    { 0.45, -0.3, {1, 0}, {1, 0}, {1, 0} },           /* x 1.8, y -1.2: 1f 8.2, 1b 11.8 */
    { -0.45, 0.3, {1, 0}, {1, 0}, {1, 0} },           /* x -1.8, y 1.2: 1f 8.2, 1b 11.8 */
    { 0.75, 0.3, {0, 0}, {0, 0}, {0, 0} },            /* x 3, y 1.2: nothing */
};

/* from +x: in the octagon 1f 7.6, 1b 12.4 */
static const probe probe_s4_end[] = {
    { 0.0, 0.0, {0, 6}, {0, 6}, {0, 6} },             /* z 0, y 0: 6 at 6.6, 1f 7.6 */
    { 0.0, 0.25, {1, 5}, {1, 5}, {1, 5} },            /* z 0, y 1: 1f 7.6, 5 at 8.8, 1b 12.4 */
    { -0.3, 0.3, {1, 9}, {1, 9}, {1, 9} },            /* z 1.2, y 1.2: 1f 7.6, 9 at 7.8, 1b 12.4 */
    { -0.6875, -0.3125, {0, 7}, {0, 7}, {0, 7} },     /* z 2.75, y -1.25: 7 at 9.6, outside 1 */
    { 0.875, -0.325, {0, 8}, {0, 8}, {0, 8} },        /* z -3.5, y -1.3: 8 at 11.9, outside 1 */
    { 0.0, -0.3, {1, 0}, {1, 0}, {1, 0} },            /* z 0, y -1.2: 1f 7.6, 1b 12.4 */
    { 0.7, 0.7, {0, 0}, {0, 0}, {0, 0} },             /* z -2.8, y 2.8: nothing */
};

static const probe_view probe_s4_views[] = {
    { "front", PROBE_FROM_ZP, PROBE_COUNT(probe_s4_front), probe_s4_front },
    { "end", PROBE_FROM_XP, PROBE_COUNT(probe_s4_end), probe_s4_end },
};

static const probe_example probe_s4_examples[] = {
    /* 1 over 2, a 0.4, w_o 0.6: a C_t = (0.24, 0.36, 0.12); published adds 0.6 (0.7, 0.1, 0.1) =
     * (0.42, 0.06, 0.06); normalised divides by 1.0; over adds 0.6 (0.7, 0.1, 0.1), the same */
    { 0, 1, false, {0.66, 0.42, 0.18}, {0.66, 0.42, 0.18}, {0.66, 0.42, 0.18} },
    /* 1 over the background, w_b 0.4: published adds 0.4 (0.9, 0.8, 1) = (0.36, 0.32, 0.4);
     * normalised divides by 0.8; over adds 0.6 (0.9, 0.8, 1) = (0.54, 0.48, 0.6) */
    { 0, 11, false, {0.6, 0.68, 0.52}, {0.75, 0.85, 0.65}, {0.78, 0.84, 0.72} },
    /* 1 over 5, end view: published adds 0.6 (0.2, 0.6, 0.6) = (0.12, 0.36, 0.36); the others the same */
    { 1, 1, false, {0.36, 0.72, 0.48}, {0.36, 0.72, 0.48}, {0.36, 0.72, 0.48} },
};

#define PROBE_SCENE_4 { "figure 9f, crank", {0.9, 0.8, 1.0}, 0.6, 0.4, \
    PROBE_COUNT(probe_s4_objects), probe_s4_objects, PROBE_COUNT(probe_s4_views), probe_s4_views, \
    PROBE_COUNT(probe_s4_examples), probe_s4_examples }

/* ---- Scene 5: nested shells ----------------------------------------------------------- */

static const probe_polygon probe_s5_p1[] = { PROBE_BOX(-3.0, 3.0, -3.0, 3.0, -3.0, 3.0) };   /* outer shell */
static const probe_polygon probe_s5_p2[] = { PROBE_BOX(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0) };   /* inner shell */
static const probe_polygon probe_s5_p3[] = { PROBE_BOX(-1.0, 1.0, -0.8, 0.8, -1.0, 1.0) };   /* core */
static const probe_polygon probe_s5_p4[] = { PROBE_BOX(-1.8, -0.8, 1.0, 1.8, 2.2, 2.8) };    /* between, on the +z side */
static const probe_polygon probe_s5_p5[] = { PROBE_BOX(0.8, 1.8, 1.0, 1.8, -2.8, -2.2) };    /* between, on the -z side */
static const probe_polygon probe_s5_p6[] = { PROBE_BOX(2.2, 2.8, -0.5, 0.5, -0.5, 0.5) };    /* between, on the +x side */
static const probe_polygon probe_s5_p7[] = { PROBE_BOX(-1.8, -0.8, -1.8, -1.0, 3.5, 4.0) };  /* outside, on the +z side */
static const probe_polygon probe_s5_p8[] = { PROBE_BOX(0.8, 1.8, -1.8, -1.0, 1.5, 2.5) };    /* through the face z = 2 of 2 */
static const probe_polygon probe_s5_p9[] = { PROBE_BOX(-2.6, -1.4, -0.5, 0.5, -0.5, 0.5) };  /* through the face x = -2 of 2 */
static const probe_polygon probe_s5_p10[] = { PROBE_BOX(2.2, 3.8, 1.0, 1.8, -4.5, -4.0) };   /* outside, on the -z side */

static const probe_object probe_s5_objects[] = {
    { 1, true, false, {0.2, 0.8, 0.6}, 0.3, PROBE_COUNT(probe_s5_p1), probe_s5_p1 },
    { 2, true, false, {0.9, 0.5, 0.1}, 0.5, PROBE_COUNT(probe_s5_p2), probe_s5_p2 },
    { 3, false, false, {0.8, 0.0, 0.2}, 1.0, PROBE_COUNT(probe_s5_p3), probe_s5_p3 },
    { 4, false, false, {0.4, 0.6, 1.0}, 1.0, PROBE_COUNT(probe_s5_p4), probe_s5_p4 },
    { 5, false, false, {0.1, 0.5, 0.2}, 1.0, PROBE_COUNT(probe_s5_p5), probe_s5_p5 },
    { 6, false, false, {0.6, 0.1, 0.7}, 1.0, PROBE_COUNT(probe_s5_p6), probe_s5_p6 },
    { 7, false, false, {0.7, 0.7, 0.2}, 1.0, PROBE_COUNT(probe_s5_p7), probe_s5_p7 },
    { 8, false, false, {0.3, 0.3, 0.5}, 1.0, PROBE_COUNT(probe_s5_p8), probe_s5_p8 },
    { 9, false, false, {0.0, 0.7, 0.8}, 1.0, PROBE_COUNT(probe_s5_p9), probe_s5_p9 },
    { 10, false, false, {0.5, 0.3, 0.1}, 1.0, PROBE_COUNT(probe_s5_p10), probe_s5_p10 },
};

/* from +z: 1f 7, 1b 13 over x, y -3..3; 2f 8, 2b 12 over x, y -2..2 */
static const probe probe_s5_front[] = {
    { 0.0, 0.0, {1, 0}, {1, 3}, {1, 0} },         /* DIFFERS: x 0, y 0: 1f 7, 2f 8, 3 at 9, 2b 12, 1b 13 */
    { 0.15, 0.1, {1, 0}, {1, 3}, {1, 0} },        /* DIFFERS: x 0.6, y 0.4: 1f 7, 2f 8, 3 at 9, 2b 12 */
    { -0.325, 0.35, {1, 4}, {1, 4}, {1, 4} },     /* x -1.3, y 1.4: 1f 7, 4 at 7.2, 2f 8 */
    { 0.325, 0.35, {1, 0}, {1, 0}, {1, 0} },      /* x 1.3, y 1.4: 1f 7, 2f 8, 2b 12, 5 at 12.2 */
    { 0.625, 0.0, {1, 6}, {1, 6}, {1, 6} },       /* x 2.5, y 0: 1f 7, 6 at 9.5, 1b 13, beside 2 */
    { -0.325, -0.35, {0, 7}, {0, 7}, {0, 7} },    /* x -1.3, y -1.4: 7 at 6, 1f 7 */
    { 0.325, -0.35, {1, 8}, {1, 8}, {1, 8} },     /* x 1.3, y -1.4: 1f 7, 8 at 7.5, 2f 8 */
    { -0.575, 0.0, {1, 9}, {1, 9}, {1, 9} },      /* x -2.3, y 0: 1f 7, 9 at 9.5, 1b 13, beside 2 */
    { -0.425, 0.0, {1, 0}, {1, 9}, {1, 0} },      /* DIFFERS: x -1.7, y 0: 1f 7, 2f 8, 9 at 9.5, 2b 12 */
    { 0.0, 0.35, {1, 0}, {1, 0}, {1, 0} },        /* x 0, y 1.4: 1f 7, 2f 8, 2b 12, 1b 13 */
    { 0.0, 0.625, {1, 0}, {1, 0}, {1, 0} },       /* x 0, y 2.5: 1f 7, 1b 13 */
    { 0.9, 0.9, {0, 0}, {0, 0}, {0, 0} },         /* x 3.6, y 3.6: nothing */
    { 0.65, 0.35, {1, 0}, {1, 0}, {1, 10} },      /* EXPLICIT: x 2.6, y 1.4: 1f 7, 1b 13, 10 at 14 */
    { 0.85, 0.35, {0, 10}, {0, 10}, {0, 10} },    /* x 3.4, y 1.4: 10 at 14, outside 1 */
};

/* from +x: 1f 7, 1b 13 over z, y -3..3; 2f 8, 2b 12 over z, y -2..2 */
static const probe probe_s5_side[] = {
    { 0.0, 0.0, {1, 6}, {1, 6}, {1, 6} },         /* z 0, y 0: 1f 7, 6 at 7.2, 2f 8 */
    { -0.1875, 0.0, {1, 0}, {1, 3}, {1, 0} },     /* DIFFERS: z 0.75, y 0: 1f 7, 2f 8, 3 at 9, 2b 12 */
    { -0.625, 0.35, {1, 4}, {1, 4}, {1, 4} },     /* z 2.5, y 1.4: 1f 7, 4 at 10.8, 1b 13, beside 2 */
    { 0.625, 0.35, {1, 5}, {1, 5}, {1, 5} },      /* z -2.5, y 1.4: 1f 7, 5 at 8.2, 1b 13, beside 2 */
    { -0.4375, -0.35, {1, 0}, {1, 8}, {1, 0} },   /* DIFFERS: z 1.75, y -1.4: 1f 7, 2f 8, 8 at 8.2, 2b 12 */
    { -0.5625, -0.35, {1, 8}, {1, 8}, {1, 8} },   /* z 2.25, y -1.4: 1f 7, 8 at 8.2, 1b 13, beside 2 */
    { -0.9375, -0.35, {0, 7}, {0, 7}, {0, 7} },   /* z 3.75, y -1.4: 7 at 10.8, outside 1 */
    { 0.0, 0.35, {1, 0}, {1, 0}, {1, 0} },        /* z 0, y 1.4: 1f 7, 2f 8, 2b 12, 1b 13 */
};

static const probe_view probe_s5_views[] = {
    { "front", PROBE_FROM_ZP, PROBE_COUNT(probe_s5_front), probe_s5_front },
    { "side", PROBE_FROM_XP, PROBE_COUNT(probe_s5_side), probe_s5_side },
};

static const probe_example probe_s5_examples[] = {
    /* 1 over the background, a 0.3, w_b 0.2: a C_t = (0.06, 0.24, 0.18); published adds
     * 0.2 (1, 0.9, 0.8) = (0.2, 0.18, 0.16); normalised divides by 0.5; over adds
     * 0.7 (1, 0.9, 0.8) = (0.7, 0.63, 0.56) */
    { 0, 0, false, {0.26, 0.42, 0.34}, {0.52, 0.84, 0.68}, {0.76, 0.87, 0.74} },
    /* the same place by the published rule, 1 over 3, w_o 0.9: published adds 0.9 (0.8, 0, 0.2) =
     * (0.72, 0, 0.18); normalised divides by 1.2; over adds 0.7 (0.8, 0, 0.2) = (0.56, 0, 0.14) */
    { 0, 0, true, {0.78, 0.24, 0.36}, {0.65, 0.2, 0.3}, {0.62, 0.24, 0.32} },
    /* 1 over 4: published adds 0.9 (0.4, 0.6, 1) = (0.36, 0.54, 0.9): (0.42, 0.78, 1.08), blue clamped;
     * normalised divides by 1.2; over adds 0.7 (0.4, 0.6, 1) = (0.28, 0.42, 0.7) */
    { 0, 2, false, {0.42, 0.78, 1.0}, {0.35, 0.65, 0.9}, {0.34, 0.66, 0.88} },
};

#define PROBE_SCENE_5 { "nested shells", {1.0, 0.9, 0.8}, 0.9, 0.2, \
    PROBE_COUNT(probe_s5_objects), probe_s5_objects, PROBE_COUNT(probe_s5_views), probe_s5_views, \
    PROBE_COUNT(probe_s5_examples), probe_s5_examples }

/* ---- Scene 6: intersecting shells ----------------------------------------------------- */

static const probe_polygon probe_s6_p1[] = { PROBE_BOX(-3.0, 1.0, -2.0, 2.0, -1.0, 2.0) };
static const probe_polygon probe_s6_p2[] = { PROBE_BOX(-1.0, 3.0, -1.8, 1.8, -2.0, 1.0) };
static const probe_polygon probe_s6_p3[] = { PROBE_BOX(-2.6, -1.6, 0.6, 1.4, 0.0, 1.0) };    /* in 1 only */
static const probe_polygon probe_s6_p4[] = { PROBE_BOX(-0.7, -0.1, 0.6, 1.4, -0.5, 0.5) };   /* in the common part */
static const probe_polygon probe_s6_p5[] = { PROBE_BOX(1.5, 2.5, 0.6, 1.4, -0.5, 0.5) };     /* in 2 only */
static const probe_polygon probe_s6_p6[] = { PROBE_BOX(-0.6, 0.6, -0.4, 0.4, 1.2, 1.8) };    /* in 1 only, on the +z side of 2 */
static const probe_polygon probe_s6_p7[] = { PROBE_BOX(0.1, 0.7, 0.6, 1.4, -1.8, -1.2) };    /* in 2 only, on the -z side of 1 */
static const probe_polygon probe_s6_p8[] = { PROBE_BOX(-2.5, 2.5, -1.4, -0.6, -0.4, 0.4) };  /* a bar through all three parts */
static const probe_polygon probe_s6_p9[] = { PROBE_BOX(1.5, 2.5, -0.4, 0.4, 2.5, 3.0) };     /* outside, on the +z side */
static const probe_polygon probe_s6_p10[] = { PROBE_BOX(-2.6, -1.6, -0.4, 0.4, -2.5, -0.5) };/* through the face z = -1 of 1 */

static const probe_object probe_s6_objects[] = {
    { 1, true, false, {0.9, 0.7, 0.2}, 0.5, PROBE_COUNT(probe_s6_p1), probe_s6_p1 },
    { 2, true, false, {0.2, 0.6, 1.0}, 0.25, PROBE_COUNT(probe_s6_p2), probe_s6_p2 },
    { 3, false, false, {0.1, 0.1, 0.9}, 1.0, PROBE_COUNT(probe_s6_p3), probe_s6_p3 },
    { 4, false, false, {0.8, 0.0, 0.4}, 1.0, PROBE_COUNT(probe_s6_p4), probe_s6_p4 },
    { 5, false, false, {0.4, 0.8, 0.0}, 1.0, PROBE_COUNT(probe_s6_p5), probe_s6_p5 },
    { 6, false, false, {0.5, 0.2, 0.2}, 1.0, PROBE_COUNT(probe_s6_p6), probe_s6_p6 },
    { 7, false, false, {0.0, 0.3, 0.1}, 1.0, PROBE_COUNT(probe_s6_p7), probe_s6_p7 },
    { 8, false, false, {0.6, 0.4, 0.8}, 1.0, PROBE_COUNT(probe_s6_p8), probe_s6_p8 },
    { 9, false, false, {0.9, 0.9, 0.1}, 1.0, PROBE_COUNT(probe_s6_p9), probe_s6_p9 },
    { 10, false, false, {0.3, 0.7, 0.7}, 1.0, PROBE_COUNT(probe_s6_p10), probe_s6_p10 },
};

/* from +z: 1f 8, 1b 11 over x -3..1; 2f 9, 2b 12 over x -1..3 */
static const probe probe_s6_front[] = {
    { -0.525, 0.25, {1, 3}, {1, 3}, {1, 3} },      /* x -2.1, y 1: 1f 8, 3 at 9, 1b 11 */
    { -0.1, 0.25, {1, 0}, {1, 4}, {1, 0} },        /* DIFFERS: x -0.4, y 1: 1f 8, 2f 9, 4 at 9.5, 1b 11 */
    { 0.1, 0.25, {1, 0}, {1, 0}, {1, 0} },         /* x 0.4, y 1: 1f 8, 2f 9, 1b 11, 7 at 11.2, 2b 12 */
    { 0.5, 0.25, {2, 5}, {2, 5}, {2, 5} },         /* x 2, y 1: 2f 9, 5 at 9.5, 2b 12 */
    { 0.0, 0.0, {1, 6}, {1, 6}, {1, 6} },          /* x 0, y 0: 1f 8, 6 at 8.2, 2f 9 */
    { -0.525, 0.0, {1, 10}, {1, 10}, {1, 10} },    /* x -2.1, y 0: 1f 8, 10 at 10.5, 1b 11 */
    { 0.5, 0.0, {0, 9}, {0, 9}, {0, 9} },          /* x 2, y 0: 9 at 7, 2f 9 */
    { -0.45, -0.25, {1, 8}, {1, 8}, {1, 8} },      /* x -1.8, y -1: 1f 8, 8 at 9.6, 1b 11 */
    { 0.0, -0.25, {1, 0}, {1, 8}, {1, 0} },        /* DIFFERS: x 0, y -1: 1f 8, 2f 9, 8 at 9.6, 1b 11 */
    { 0.45, -0.25, {2, 8}, {2, 8}, {2, 8} },       /* x 1.8, y -1: 2f 9, 8 at 9.6, 2b 12 */
    { 0.2, 0.0, {1, 0}, {1, 0}, {1, 0} },          /* x 0.8, y 0: 1f 8, 2f 9, 1b 11, 2b 12 */
    { 0.875, 0.25, {0, 0}, {0, 0}, {0, 0} },       /* x 3.5, y 1: nothing */
    { -0.32, 0.0, {1, 0}, {1, 0}, {1, 0} },        /* x -1.28, y 0: 1f 8, 1b 11 */
    { 0.31, 0.0, {2, 0}, {2, 0}, {2, 0} },         /* x 1.24, y 0: 2f 9, 2b 12 */
};

/* from +x: 1f 9, 1b 13 over z -1..2; 2f 7, 2b 11 over z -2..1 */
static const probe probe_s6_side[] = {
    { 0.0625, 0.25, {2, 5}, {2, 5}, {2, 5} },      /* z -0.25, y 1: 2f 7, 5 at 7.5, 1f 9 */
    { -0.1875, 0.25, {2, 0}, {2, 0}, {2, 0} },     /* z 0.75, y 1: 2f 7, 1f 9, 2b 11, 3 at 11.6, 1b 13 */
    { 0.375, 0.25, {2, 7}, {2, 7}, {2, 7} },       /* z -1.5, y 1: 2f 7, 7 at 9.3, 2b 11 */
    { -0.375, 0.0, {1, 6}, {1, 6}, {1, 6} },       /* z 1.5, y 0: 1f 9, 6 at 9.4, 1b 13 */
    { 0.0, -0.25, {2, 8}, {2, 8}, {2, 8} },        /* z 0, y -1: 2f 7, 8 at 7.5, 1f 9 */
    { -0.6875, 0.0, {0, 9}, {0, 9}, {0, 9} },      /* z 2.75, y 0: 9 at 7.5, outside both */
    { 0.375, 0.0, {2, 0}, {2, 0}, {2, 10} },       /* EXPLICIT: z -1.5, y 0: 2f 7, 2b 11, 10 at 11.6 */
    { 0.5625, 0.0, {0, 10}, {0, 10}, {0, 10} },    /* z -2.25, y 0: 10 at 11.6, outside both */
    { 0.1875, 0.0, {2, 0}, {2, 0}, {2, 0} },       /* z -0.75, y 0: 2f 7, 1f 9, 2b 11, 10 at 11.6, 1b 13 */
    { -0.375, -0.25, {1, 0}, {1, 0}, {1, 0} },     /* z 1.5, y -1: 1f 9, 1b 13 */
};

static const probe_view probe_s6_views[] = {
    { "front", PROBE_FROM_ZP, PROBE_COUNT(probe_s6_front), probe_s6_front },
    { "side", PROBE_FROM_XP, PROBE_COUNT(probe_s6_side), probe_s6_side },
};

static const probe_example probe_s6_examples[] = {
    /* 1 over 3, a 0.5, w_o 0.75: a C_t = (0.45, 0.35, 0.1); published adds 0.75 (0.1, 0.1, 0.9) =
     * (0.075, 0.075, 0.675); normalised divides by 1.25; over adds 0.5 (0.1, 0.1, 0.9) */
    { 0, 0, false, {0.525, 0.425, 0.775}, {0.42, 0.34, 0.62}, {0.5, 0.4, 0.55} },
    /* by the published rule, 1 over 4: published adds 0.75 (0.8, 0, 0.4) = (0.6, 0, 0.3): red 1.05
     * clamped; normalised divides by 1.25; over adds 0.5 (0.8, 0, 0.4) = (0.4, 0, 0.2) */
    { 0, 1, true, {1.0, 0.35, 0.4}, {0.84, 0.28, 0.32}, {0.85, 0.35, 0.3} },
    /* 2 over the background, a 0.25, w_b 0.25: a C_t = (0.05, 0.15, 0.25); published adds
     * 0.25 (0.4, 0.8, 0.6) = (0.1, 0.2, 0.15); normalised divides by 0.5; over adds
     * 0.75 (0.4, 0.8, 0.6) = (0.3, 0.6, 0.45) */
    { 0, 13, false, {0.15, 0.35, 0.4}, {0.3, 0.7, 0.8}, {0.35, 0.75, 0.7} },
};

#define PROBE_SCENE_6 { "intersecting shells", {0.4, 0.8, 0.6}, 0.75, 0.25, \
    PROBE_COUNT(probe_s6_objects), probe_s6_objects, PROBE_COUNT(probe_s6_views), probe_s6_views, \
    PROBE_COUNT(probe_s6_examples), probe_s6_examples }

/* ---- Scene 7: the eye inside a transparent box ---------------------------------------- */

static const probe_polygon probe_s7_p1[] = { PROBE_BOX(-4.0, 4.0, -4.0, 4.0, -10.0, 2.0) };  /* around the eye */
static const probe_polygon probe_s7_p2[] = { PROBE_BOX(-2.0, -0.4, -0.8, 1.6, -8.0, -4.0) }; /* transparent, inside 1 */
static const probe_polygon probe_s7_p3[] = { PROBE_BOX(-4.8, -1.2, -6.6, -3.2, -16.0, -12.0) };/* transparent, beyond 1 */
static const probe_polygon probe_s7_p4[] = { PROBE_BOX(0.8, 1.6, 0.6, 1.4, -6.0, -4.0) };    /* inside 1 */
static const probe_polygon probe_s7_p5[] = { PROBE_BOX(-1.6, -0.6, -0.5, 0.5, -6.0, -5.0) }; /* inside 2 */
static const probe_polygon probe_s7_p6[] = { PROBE_BOX(-1.8, -0.45, 0.9, 1.9, -9.2, -9.0) }; /* inside 1, beyond 2 */
static const probe_polygon probe_s7_p7[] = { PROBE_BOX(1.2, 3.6, -1.8, -0.2, -13.0, -12.0) };/* beyond 1 */
static const probe_polygon probe_s7_p8[] = { PROBE_BOX(-3.6, -1.6, -5.4, -3.6, -14.5, -13.0) };/* inside 3 */
static const probe_polygon probe_s7_p9[] = { PROBE_BOX(0.9, 2.7, -3.4, -2.4, -12.0, -9.0) }; /* through the face z = -10 of 1 */
static const probe_polygon probe_s7_p10[] = { PROBE_BOX(5.0, 7.0, -1.0, 1.0, -8.0, -7.0) };  /* beside 1 */
static const probe_polygon probe_s7_p11[] = { PROBE_BOX(-1.3, -0.6, 0.4, 1.2, -3.0, -2.5) }; /* inside 1, before 2 */
static const probe_polygon probe_s7_p12[] = { PROBE_BOX(-8.0, 0.8, -12.0, -8.0, -21.0, -20.0) };/* beyond 3 */

static const probe_object probe_s7_objects[] = {
    { 1, true, false, {0.5, 0.5, 0.9}, 0.7, PROBE_COUNT(probe_s7_p1), probe_s7_p1 },
    { 2, true, false, {0.9, 0.4, 0.2}, 0.5, PROBE_COUNT(probe_s7_p2), probe_s7_p2 },
    { 3, true, false, {0.3, 0.9, 0.3}, 0.4, PROBE_COUNT(probe_s7_p3), probe_s7_p3 },
    { 4, false, false, {0.8, 0.1, 0.1}, 1.0, PROBE_COUNT(probe_s7_p4), probe_s7_p4 },
    { 5, false, false, {0.2, 0.2, 0.8}, 1.0, PROBE_COUNT(probe_s7_p5), probe_s7_p5 },
    { 6, false, false, {0.1, 0.5, 0.5}, 1.0, PROBE_COUNT(probe_s7_p6), probe_s7_p6 },
    { 7, false, false, {0.6, 0.6, 0.0}, 1.0, PROBE_COUNT(probe_s7_p7), probe_s7_p7 },
    { 8, false, false, {0.7, 0.2, 0.6}, 1.0, PROBE_COUNT(probe_s7_p8), probe_s7_p8 },
    { 9, false, false, {0.0, 0.4, 0.2}, 1.0, PROBE_COUNT(probe_s7_p9), probe_s7_p9 },
    { 10, false, false, {0.9, 0.6, 0.5}, 1.0, PROBE_COUNT(probe_s7_p10), probe_s7_p10 },
    { 11, false, false, {0.4, 0.2, 0.0}, 1.0, PROBE_COUNT(probe_s7_p11), probe_s7_p11 },
    { 12, false, false, {0.1, 0.1, 0.3}, 1.0, PROBE_COUNT(probe_s7_p12), probe_s7_p12 },
};

/* Perspective, eye at the origin looking to -z, half width 1: at depth d the ray through
 * (u, v) is at x = u d, y = v d.  Object 1 shows only back faces: z = -10 at depth 10 for
 * |u|, |v| < 0.4, else a side at 4 / |u| or 4 / |v|.  Face z = -4 of 2 covers u -0.5..-0.1,
 * v -0.2..0.4; face z = -12 of 3 covers u -0.4..-0.1, v -0.55..-0.267. */
static const probe probe_s7_inside[] = {
    { 0.25, 0.29, {0, 4}, {0, 4}, {0, 4} },         /* 4 at 4 (u 0.2..0.4, v 0.15..0.35), 1b 10 */
    { -0.18, 0.0, {2, 5}, {2, 5}, {2, 5} },         /* 2f 4, 5 at 5 (u -0.32..-0.12), 2b 8, 1b 10 */
    { -0.19, 0.03, {2, 5}, {2, 5}, {2, 5} },        /* 2f 4, 5 at 5, 2b 8, 1b 10 */
    { -0.15, 0.155, {2, 0}, {2, 0}, {2, 6} },       /* EXPLICIT: 2f 4, 2b 8, 6 at 9 (u -0.2..-0.05, v 0.1..0.211), 1b 10 */
    { -0.45, -0.1, {2, 0}, {2, 0}, {2, 0} },        /* 2f 4, 2b (x=-2) 4.444, 1b (x=-4) 8.889 */
    { -0.15, -0.15, {2, 0}, {2, 0}, {2, 0} },       /* 2f 4, 2b (y=-0.8) 5.333, 1b 10; below 5 at depth 5 */
    { -0.3, 0.3, {0, 11}, {0, 11}, {0, 11} },       /* 11 at 2.5 (u -0.52..-0.24, v 0.16..0.48), 2f 4 */
    { 0.2, -0.085, {0, 7}, {0, 0}, {0, 7} },        /* DIFFERS: 1b 10, 7 at 12 (u 0.1..0.3, v -0.15..-0.017); no front face */
    { 0.17, -0.08, {0, 7}, {0, 0}, {0, 7} },        /* DIFFERS: 1b 10, 7 at 12 */
    { -0.35, -0.32, {3, 0}, {0, 0}, {3, 0} },       /* DIFFERS: 1b 10, 3f 12, 3b (x=-4.8) 13.71 */
    { -0.19, -0.325, {3, 8}, {0, 0}, {3, 8} },      /* DIFFERS: 1b 10, 3f 12, 8 at 13 (u -0.277..-0.123, v -0.415..-0.277), 3b 16 */
    { -0.2, -0.325, {3, 8}, {0, 0}, {3, 8} },       /* DIFFERS: 1b 10, 3f 12, 8 at 13, 3b 16 */
    { 0.2, -0.325, {0, 9}, {0, 9}, {0, 9} },        /* 9 at 9 (u 0.1..0.3, v -0.378..-0.267), 1b 10 */
    { 0.16, -0.325, {0, 9}, {0, 9}, {0, 9} },       /* 9 at 9, 1b 10 */
    { 0.8, 0.0, {0, 10}, {0, 0}, {0, 10} },         /* DIFFERS: 1b (x=4) 5, 10 at 7 (u 0.714..1, v -0.143..0.143) */
    { 0.78, 0.05, {0, 10}, {0, 0}, {0, 10} },       /* DIFFERS: 1b (x=4) 5.128, 10 at 7 */
    { -0.03, -0.5, {0, 12}, {0, 0}, {0, 12} },      /* DIFFERS: 1b (y=-4) 8, 12 at 20 (u -0.4..0.04, v -0.6..-0.4), beside 3 */
    { -0.2, -0.48, {3, 0}, {0, 0}, {3, 12} },       /* DIFFERS, EXPLICIT: 1b (y=-4) 8.333, 3f 12, 3b (y=-6.6) 13.75, 12 at 20 */
    { 0.05, 0.08, {0, 0}, {0, 0}, {0, 0} },         /* 1b 10 */
    { 0.3, 0.7, {0, 0}, {0, 0}, {0, 0} },           /* 1b (y=4) 5.714 */
    { -0.8, -0.6, {0, 0}, {0, 0}, {0, 0} },         /* 1b (x=-4) 5 */
};

static const probe_view probe_s7_views[] = {
    { "inside", { true, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1.0, 0.1, 30.0 },
      PROBE_COUNT(probe_s7_inside), probe_s7_inside },
};

static const probe_example probe_s7_examples[] = {
    /* 2 over 5, a 0.5, w_o 0.5: a C_t = (0.45, 0.2, 0.1); published adds 0.5 (0.2, 0.2, 0.8) =
     * (0.1, 0.1, 0.4); normalised divides by 1.0; over adds 0.5 (0.2, 0.2, 0.8), the same */
    { 0, 1, false, {0.55, 0.3, 0.5}, {0.55, 0.3, 0.5}, {0.55, 0.3, 0.5} },
    /* 3 over the background, a 0.4, w_b 0.1: a C_t = (0.12, 0.36, 0.12); published adds
     * 0.1 (0.7, 0.8, 0.9) = (0.07, 0.08, 0.09); normalised divides by 0.5; over adds
     * 0.6 (0.7, 0.8, 0.9) = (0.42, 0.48, 0.54) */
    { 0, 9, false, {0.19, 0.44, 0.21}, {0.38, 0.88, 0.42}, {0.54, 0.84, 0.66} },
    /* the same place by the published rule: the background as it is */
    { 0, 9, true, {0.7, 0.8, 0.9}, {0.7, 0.8, 0.9}, {0.7, 0.8, 0.9} },
};

#define PROBE_SCENE_7 { "eye inside", {0.7, 0.8, 0.9}, 0.5, 0.1, \
    PROBE_COUNT(probe_s7_objects), probe_s7_objects, PROBE_COUNT(probe_s7_views), probe_s7_views, \
    PROBE_COUNT(probe_s7_examples), probe_s7_examples }

/* ---- Scene 8: open sheets ------------------------------------------------------------- */

/* 1: a two-sided transparent rectangle in z = 1, its outside to -z; 2: a one-sided transparent
 * box x 0.5..3, y -3..2, z -1..1 without its wall z = 1; 12: a closed transparent box; 14: a
 * second two-sided transparent rectangle, in z = -1, its outside to +z. */
static const probe_polygon probe_s8_p1[] = { PROBE_FACE_ZN(1.0, -3.0, -0.5, -3.0, 2.0) };
static const probe_polygon probe_s8_p2[] = {
    PROBE_FACE_XN(0.5, -3.0, 2.0, -1.0, 1.0), PROBE_FACE_XP(3.0, -3.0, 2.0, -1.0, 1.0),
    PROBE_FACE_YN(-3.0, 0.5, 3.0, -1.0, 1.0), PROBE_FACE_YP(2.0, 0.5, 3.0, -1.0, 1.0),
    PROBE_FACE_ZN(-1.0, 0.5, 3.0, -3.0, 2.0),
};
static const probe_polygon probe_s8_p3[] = { PROBE_BOX(-2.4, -1.2, 0.6, 1.4, -0.5, 0.5) };   /* on the -z side of 1 */
static const probe_polygon probe_s8_p4[] = { PROBE_BOX(-2.4, -1.2, -0.4, 0.4, 2.0, 2.5) };   /* on the +z side of 1 */
static const probe_polygon probe_s8_p5[] = { PROBE_BOX(-2.4, -1.2, -1.4, -0.6, 0.0, 1.6) };  /* through 1 */
static const probe_polygon probe_s8_p6[] = { PROBE_BOX(-3.6, -2.6, 0.6, 1.4, -4.0, -3.5) };  /* far on the -z side of 1 */
static const probe_polygon probe_s8_p7[] = { PROBE_BOX(1.0, 1.8, 0.6, 1.4, -0.5, 0.5) };     /* inside 2 */
static const probe_polygon probe_s8_p8[] = { PROBE_BOX(2.0, 2.7, 0.6, 1.4, -3.0, -2.0) };    /* on the -z side of 2 */
static const probe_polygon probe_s8_p9[] = { PROBE_BOX(2.2, 3.6, -0.4, 0.4, -3.0, -2.0) };   /* the same, reaching past its side */
static const probe_polygon probe_s8_p10[] = { PROBE_BOX(1.0, 1.8, -0.4, 0.4, 2.0, 3.0) };    /* on the +z side of 2 */
static const probe_polygon probe_s8_p11[] = { PROBE_BOX(1.0, 2.4, -1.4, -0.6, -2.0, 0.0) };  /* through the wall z = -1 of 2 */
static const probe_polygon probe_s8_p12[] = { PROBE_BOX(1.0, 2.6, -2.7, -1.7, -3.0, -2.0) }; /* transparent, on the -z side of 2 */
static const probe_polygon probe_s8_p13[] = { PROBE_BOX(1.9, 2.5, -2.5, -1.9, -2.8, -2.2) }; /* inside 12 */
static const probe_polygon probe_s8_p14[] = { PROBE_FACE_ZP(-1.0, -2.9, -0.7, -2.7, -1.7) };
static const probe_polygon probe_s8_p15[] = { PROBE_BOX(-2.8, -2.1, -2.6, -1.8, -0.3, 0.3) };/* between 1 and 14 */
static const probe_polygon probe_s8_p16[] = { PROBE_BOX(-1.7, -0.9, -2.6, -1.8, -2.6, -2.0) };/* on the -z side of 14 */

static const probe_object probe_s8_objects[] = {
    { 1, true, true, {0.8, 0.2, 0.6}, 0.5, PROBE_COUNT(probe_s8_p1), probe_s8_p1 },
    { 2, true, false, {0.2, 0.8, 0.8}, 0.6, PROBE_COUNT(probe_s8_p2), probe_s8_p2 },
    { 3, false, false, {0.2, 0.6, 0.0}, 1.0, PROBE_COUNT(probe_s8_p3), probe_s8_p3 },
    { 4, false, false, {0.7, 0.3, 0.0}, 1.0, PROBE_COUNT(probe_s8_p4), probe_s8_p4 },
    { 5, false, false, {0.0, 0.2, 0.7}, 1.0, PROBE_COUNT(probe_s8_p5), probe_s8_p5 },
    { 6, false, false, {0.9, 0.8, 0.4}, 1.0, PROBE_COUNT(probe_s8_p6), probe_s8_p6 },
    { 7, false, false, {0.5, 0.0, 0.1}, 1.0, PROBE_COUNT(probe_s8_p7), probe_s8_p7 },
    { 8, false, false, {0.1, 0.3, 0.3}, 1.0, PROBE_COUNT(probe_s8_p8), probe_s8_p8 },
    { 9, false, false, {0.6, 0.5, 0.9}, 1.0, PROBE_COUNT(probe_s8_p9), probe_s8_p9 },
    { 10, false, false, {0.4, 0.9, 0.2}, 1.0, PROBE_COUNT(probe_s8_p10), probe_s8_p10 },
    { 11, false, false, {0.9, 0.1, 0.3}, 1.0, PROBE_COUNT(probe_s8_p11), probe_s8_p11 },
    { 12, true, false, {1.0, 0.5, 0.0}, 0.4, PROBE_COUNT(probe_s8_p12), probe_s8_p12 },
    { 13, false, false, {0.0, 0.0, 0.4}, 1.0, PROBE_COUNT(probe_s8_p13), probe_s8_p13 },
    { 14, true, true, {0.3, 0.3, 1.0}, 0.8, PROBE_COUNT(probe_s8_p14), probe_s8_p14 },
    { 15, false, false, {0.7, 0.7, 0.7}, 1.0, PROBE_COUNT(probe_s8_p15), probe_s8_p15 },
    { 16, false, false, {0.3, 0.6, 0.5}, 1.0, PROBE_COUNT(probe_s8_p16), probe_s8_p16 },
};

/* from +z: 1f 9 over x -3..-0.5 (its back, counted as front; no back face); 2b 11 over x 0.5..3
 * with no front face of 2 before it */
static const probe probe_s8_front[] = {
    { -0.45, 0.25, {1, 3}, {1, 3}, {1, 3} },         /* x -1.8, y 1: 1f 9, 3 at 9.5 */
    { -0.45, 0.0, {0, 4}, {0, 4}, {0, 4} },          /* x -1.8, y 0: 4 at 7.5, 1f 9 */
    { -0.45, -0.25, {0, 5}, {0, 5}, {0, 5} },        /* x -1.8, y -1: 5 at 8.4, 1f 9 */
    { -0.825, 0.25, {0, 6}, {0, 6}, {0, 6} },        /* x -3.3, y 1: 6 at 13.5, beside 1 */
    { -0.7, 0.25, {1, 6}, {1, 6}, {1, 6} },          /* x -2.8, y 1: 1f 9, 6 at 13.5 */
    { -0.2, 0.25, {1, 0}, {1, 0}, {1, 0} },          /* x -0.8, y 1: 1f 9 */
    { 0.35, 0.25, {0, 7}, {0, 7}, {0, 7} },          /* x 1.4, y 1: 7 at 9.5, 2b 11 */
    { 0.5875, 0.25, {0, 8}, {0, 0}, {0, 8} },        /* DIFFERS: x 2.35, y 1: 2b 11, 8 at 12 */
    { 0.65, 0.0, {0, 9}, {0, 0}, {0, 9} },           /* DIFFERS: x 2.6, y 0: 2b 11, 9 at 12 */
    { 0.825, 0.0, {0, 9}, {0, 9}, {0, 9} },          /* x 3.3, y 0: 9 at 12, beside 2 */
    { 0.35, 0.0, {0, 10}, {0, 10}, {0, 10} },        /* x 1.4, y 0: 10 at 7, 2b 11 */
    { 0.425, -0.25, {0, 11}, {0, 11}, {0, 11} },     /* x 1.7, y -1: 11 at 10, 2b 11 */
    { 0.3625, -0.55, {12, 0}, {0, 0}, {12, 0} },     /* DIFFERS: x 1.45, y -2.2: 2b 11, 12f 12, 12b 13 */
    { 0.55, -0.55, {12, 13}, {0, 0}, {12, 13} },     /* DIFFERS: x 2.2, y -2.2: 2b 11, 12f 12, 13 at 12.2, 12b 13 */
    { -0.6125, -0.55, {1, 15}, {1, 15}, {1, 15} },   /* x -2.45, y -2.2: 1f 9, 15 at 9.7, 14f 11 */
    { -0.325, -0.55, {1, 0}, {1, 16}, {1, 0} },      /* DIFFERS: x -1.3, y -2.2: 1f 9, 14f 11, 16 at 12; no back face */
    { 0.0, 0.0, {0, 0}, {0, 0}, {0, 0} },            /* x 0, y 0: nothing, between 1 and 2 */
    { 0.2, 0.25, {0, 0}, {0, 0}, {0, 0} },           /* x 0.8, y 1: 2b 11 */
};

/* from -z: 1f 11; 2f 9 (the wall z = -1) with no back face of 2 behind it; 12f 7, 12b 8; 14f 9 */
static const probe probe_s8_rear[] = {
    { -0.5875, 0.25, {0, 8}, {0, 8}, {0, 8} },        /* x 2.35, y 1: 8 at 7, 2f 9 */
    { -0.35, 0.25, {2, 7}, {2, 7}, {2, 7} },          /* x 1.4, y 1: 2f 9, 7 at 9.5 */
    { -0.35, 0.0, {2, 10}, {2, 10}, {2, 10} },        /* x 1.4, y 0: 2f 9, 10 at 12, out at the missing wall */
    { -0.425, -0.25, {0, 11}, {0, 11}, {0, 11} },     /* x 1.7, y -1: 11 at 8, 2f 9 */
    { -0.3625, -0.55, {12, 0}, {12, 0}, {12, 0} },    /* x 1.45, y -2.2: 12f 7, 12b 8, 2f 9 */
    { -0.55, -0.55, {12, 13}, {12, 13}, {12, 13} },   /* x 2.2, y -2.2: 12f 7, 13 at 7.2, 12b 8 */
    { 0.45, 0.0, {1, 4}, {1, 4}, {1, 4} },            /* x -1.8, y 0: 1f 11, 4 at 12 */
    { 0.45, 0.25, {0, 3}, {0, 3}, {0, 3} },           /* x -1.8, y 1: 3 at 9.5, 1f 11 */
    { 0.45, -0.25, {0, 5}, {0, 5}, {0, 5} },          /* x -1.8, y -1: 5 at 10, 1f 11 */
    { 0.6125, -0.55, {14, 15}, {14, 15}, {14, 15} },  /* x -2.45, y -2.2: 14f 9, 15 at 9.7, 1f 11 */
    { 0.325, -0.55, {0, 16}, {0, 16}, {0, 16} },      /* x -1.3, y -2.2: 16 at 7.4, 14f 9 */
    { -0.65, 0.0, {0, 9}, {0, 9}, {0, 9} },           /* x 2.6, y 0: 9 at 7, 2f 9 */
};

static const probe_view probe_s8_views[] = {
    { "front", PROBE_FROM_ZP, PROBE_COUNT(probe_s8_front), probe_s8_front },
    { "rear", PROBE_FROM_ZN, PROBE_COUNT(probe_s8_rear), probe_s8_rear },
};

static const probe_example probe_s8_examples[] = {
    /* 1 over 3, a 0.5, w_o 1: a C_t = (0.4, 0.1, 0.3); published adds (0.2, 0.6, 0); normalised
     * divides by 1.5; over adds 0.5 (0.2, 0.6, 0) = (0.1, 0.3, 0) */
    { 0, 0, false, {0.6, 0.7, 0.3}, {0.4, 0.7 / 1.5, 0.2}, {0.5, 0.4, 0.3} },
    /* 12 over the background, a 0.4, w_b 0.4: a C_t = (0.4, 0.2, 0); published adds
     * 0.4 (0.5, 0.6, 0.5) = (0.2, 0.24, 0.2); normalised divides by 0.8; over adds
     * 0.6 (0.5, 0.6, 0.5) = (0.3, 0.36, 0.3) */
    { 0, 12, false, {0.6, 0.44, 0.2}, {0.75, 0.55, 0.25}, {0.7, 0.56, 0.3} },
    /* by the published rule, 1 over 16: published adds (0.3, 0.6, 0.5) to (0.4, 0.1, 0.3); normalised
     * divides by 1.5; over adds 0.5 (0.3, 0.6, 0.5) = (0.15, 0.3, 0.25) */
    { 0, 15, true, {0.7, 0.7, 0.8}, {0.7 / 1.5, 0.7 / 1.5, 0.8 / 1.5}, {0.55, 0.4, 0.55} },
};

#define PROBE_SCENE_8 { "open sheets", {0.5, 0.6, 0.5}, 1.0, 0.4, \
    PROBE_COUNT(probe_s8_objects), probe_s8_objects, PROBE_COUNT(probe_s8_views), probe_s8_views, \
    PROBE_COUNT(probe_s8_examples), probe_s8_examples }

/* ---- Scene 9: front faces that coincide ------------------------------------------------ */

/* The faces z = 2 of 1 and 2 coincide over x -1..1, y -1.8..1.8.  The object list has 2 first,
 * so that the lowest id is not the one drawn first. */
static const probe_polygon probe_s9_p1[] = { PROBE_BOX(-3.0, 1.0, -2.0, 2.0, -1.0, 2.0) };
static const probe_polygon probe_s9_p2[] = { PROBE_BOX(-1.0, 3.0, -1.8, 1.8, -2.0, 2.0) };
static const probe_polygon probe_s9_p3[] = { PROBE_BOX(-2.6, -1.6, 0.6, 1.4, 0.0, 1.0) };    /* in 1 only */
static const probe_polygon probe_s9_p4[] = { PROBE_BOX(-0.6, 0.6, 0.6, 1.4, 0.0, 1.0) };     /* in both */
static const probe_polygon probe_s9_p5[] = { PROBE_BOX(1.5, 2.5, 0.6, 1.4, -0.8, -0.2) };    /* in 2 only */
static const probe_polygon probe_s9_p6[] = { PROBE_BOX(-0.7, -0.1, -0.4, 0.4, 3.0, 3.5) };   /* outside, on the +z side of both */
static const probe_polygon probe_s9_p7[] = { PROBE_BOX(0.0, 0.7, -1.4, -0.6, -1.8, -1.2) };  /* in 2 only, on the -z side of 1 */
static const probe_polygon probe_s9_p8[] = { PROBE_BOX(1.5, 2.5, -0.4, 0.4, -3.0, -1.5) };   /* through the face z = -2 of 2 */
static const probe_polygon probe_s9_p9[] = { PROBE_BOX(-2.6, -1.6, -0.4, 0.4, -3.0, -2.0) }; /* outside, on the -z side of 1 */
static const probe_polygon probe_s9_p10[] = { PROBE_BOX(-2.4, -0.3, -1.4, -0.6, 0.0, 1.0) }; /* in 1, through the face x = -1 of 2 */
static const probe_polygon probe_s9_p11[] = { PROBE_BOX(0.1, 0.7, -0.4, 0.4, 1.0, 2.5) };    /* through both faces z = 2 */
static const probe_polygon probe_s9_p12[] = { PROBE_BOX(1.5, 2.5, -1.4, -0.6, 2.5, 3.0) };   /* outside, on the +z side of 2 */

static const probe_object probe_s9_objects[] = {
    { 2, true, false, {0.1, 0.9, 0.5}, 0.6, PROBE_COUNT(probe_s9_p2), probe_s9_p2 },
    { 1, true, false, {0.8, 0.4, 0.6}, 0.5, PROBE_COUNT(probe_s9_p1), probe_s9_p1 },
    { 3, false, false, {0.0, 0.4, 0.8}, 1.0, PROBE_COUNT(probe_s9_p3), probe_s9_p3 },
    { 4, false, false, {0.4, 0.6, 0.2}, 1.0, PROBE_COUNT(probe_s9_p4), probe_s9_p4 },
    { 5, false, false, {0.9, 0.2, 0.0}, 1.0, PROBE_COUNT(probe_s9_p5), probe_s9_p5 },
    { 6, false, false, {0.3, 0.3, 0.3}, 1.0, PROBE_COUNT(probe_s9_p6), probe_s9_p6 },
    { 7, false, false, {0.6, 0.0, 0.9}, 1.0, PROBE_COUNT(probe_s9_p7), probe_s9_p7 },
    { 8, false, false, {0.5, 0.7, 0.1}, 1.0, PROBE_COUNT(probe_s9_p8), probe_s9_p8 },
    { 9, false, false, {0.1, 0.2, 0.4}, 1.0, PROBE_COUNT(probe_s9_p9), probe_s9_p9 },
    { 10, false, false, {0.2, 0.8, 0.9}, 1.0, PROBE_COUNT(probe_s9_p10), probe_s9_p10 },
    { 11, false, false, {0.7, 0.1, 0.3}, 1.0, PROBE_COUNT(probe_s9_p11), probe_s9_p11 },
    { 12, false, false, {0.9, 0.7, 0.8}, 1.0, PROBE_COUNT(probe_s9_p12), probe_s9_p12 },
};

/* from +z: 1f 8, 1b 11 over x -3..1; 2f 8, 2b 12 over x -1..3 */
static const probe probe_s9_front[] = {
    { -0.525, 0.25, {1, 3}, {1, 3}, {1, 3} },        /* x -2.1, y 1: 1f 8, 3 at 9, 1b 11 */
    { 0.0, 0.25, {1, 0}, {1, 4}, {1, 4} },           /* DIFFERS, EXPLICIT: x 0, y 1: 1f 8 = 2f 8, 4 at 9, 1b 11, 2b 12 */
    { 0.1, 0.2, {1, 0}, {1, 4}, {1, 4} },            /* DIFFERS, EXPLICIT: x 0.4, y 0.8: 1f 8 = 2f 8, 4 at 9, 1b 11 */
    { 0.5, 0.25, {2, 5}, {2, 5}, {2, 5} },           /* x 2, y 1: 2f 8, 5 at 10.2, 2b 12 */
    { -0.1, 0.0, {0, 6}, {0, 6}, {0, 6} },           /* x -0.4, y 0: 6 at 6.5, 1f 8 = 2f 8 */
    { 0.1, 0.0, {0, 11}, {0, 11}, {0, 11} },         /* x 0.4, y 0: 11 at 7.5, 1f 8 = 2f 8 */
    { 0.0875, -0.25, {1, 0}, {1, 0}, {1, 7} },       /* EXPLICIT: x 0.35, y -1: 1f 8 = 2f 8, 1b 11, 7 at 11.2, 2b 12 */
    { 0.5, 0.0, {2, 8}, {2, 8}, {2, 8} },            /* x 2, y 0: 2f 8, 8 at 11.5, 2b 12 */
    { -0.525, 0.0, {1, 0}, {1, 0}, {1, 9} },         /* EXPLICIT: x -2.1, y 0: 1f 8, 1b 11, 9 at 12 */
    { -0.425, -0.25, {1, 10}, {1, 10}, {1, 10} },    /* x -1.7, y -1: 1f 8, 10 at 9, 1b 11 */
    { -0.1625, -0.25, {1, 0}, {1, 10}, {1, 10} },    /* DIFFERS, EXPLICIT: x -0.65, y -1: 1f 8 = 2f 8, 10 at 9, 1b 11 */
    { 0.5, -0.25, {0, 12}, {0, 12}, {0, 12} },       /* x 2, y -1: 12 at 7, 2f 8 */
    { -0.325, 0.0, {1, 0}, {1, 0}, {1, 0} },         /* x -1.3, y 0: 1f 8, 1b 11 */
    { 0.31, 0.0, {2, 0}, {2, 0}, {2, 0} },           /* x 1.24, y 0: 2f 8, 2b 12 */
    { 0.875, 0.25, {0, 0}, {0, 0}, {0, 0} },         /* x 3.5, y 1: nothing */
};

/* from -x: 1f 7, 1b 11 over z -1..2; 2f 9, 2b 13 over z -2..2; nothing coincides */
static const probe probe_s9_side[] = {
    { 0.125, 0.25, {1, 3}, {1, 3}, {1, 3} },         /* z 0.5, y 1: 1f 7, 3 at 7.4, 2f 9 */
    { 0.125, -0.25, {1, 10}, {1, 10}, {1, 10} },     /* z 0.5, y -1: 1f 7, 10 at 7.6, 2f 9 */
    { -0.625, 0.0, {0, 9}, {0, 9}, {0, 9} },         /* z -2.5, y 0: 9 at 7.4, outside both */
    { -0.4375, 0.0, {2, 8}, {2, 8}, {2, 8} },        /* z -1.75, y 0: 2f 9, 8 at 11.5, 2b 13, beside 1 */
    { -0.125, 0.25, {1, 0}, {1, 0}, {1, 0} },        /* z -0.5, y 1: 1f 7, 2f 9, 1b 11, 5 at 11.5, 2b 13 */
    { -0.375, -0.25, {2, 7}, {2, 7}, {2, 7} },       /* z -1.5, y -1: 2f 9, 7 at 10, 2b 13, beside 1 */
    { 0.375, 0.0, {1, 0}, {1, 11}, {1, 0} },         /* DIFFERS: z 1.5, y 0: 1f 7, 2f 9, 11 at 10.1, 1b 11 */
    { 0.5625, 0.0, {0, 11}, {0, 11}, {0, 11} },      /* z 2.25, y 0: 11 at 10.1, outside both */
    { 0.6875, -0.25, {0, 12}, {0, 12}, {0, 12} },    /* z 2.75, y -1: 12 at 11.5, outside both */
};

static const probe_view probe_s9_views[] = {
    { "front", PROBE_FROM_ZP, PROBE_COUNT(probe_s9_front), probe_s9_front },
    { "side", PROBE_FROM_XN, PROBE_COUNT(probe_s9_side), probe_s9_side },
};

static const probe_example probe_s9_examples[] = {
    /* 1 over the background, a 0.5, w_b 0.5: a C_t = (0.4, 0.2, 0.3); published adds
     * 0.5 (0.8, 0.6, 0.4) = (0.4, 0.3, 0.2); normalised divides by 1.0; over adds
     * 0.5 (0.8, 0.6, 0.4), the same */
    { 0, 1, false, {0.8, 0.5, 0.5}, {0.8, 0.5, 0.5}, {0.8, 0.5, 0.5} },
    /* by the published rule, 1 over 4, w_o 0.75: published adds 0.75 (0.4, 0.6, 0.2) =
     * (0.3, 0.45, 0.15); normalised divides by 1.25; over adds 0.5 (0.4, 0.6, 0.2) = (0.2, 0.3, 0.1) */
    { 0, 1, true, {0.7, 0.65, 0.45}, {0.56, 0.52, 0.36}, {0.6, 0.5, 0.4} },
    /* 2 over 5, a 0.6: a C_t = (0.06, 0.54, 0.3); published adds 0.75 (0.9, 0.2, 0) = (0.675, 0.15, 0);
     * normalised divides by 1.35; over adds 0.4 (0.9, 0.2, 0) = (0.36, 0.08, 0) */
    { 0, 3, false, {0.735, 0.69, 0.3}, {0.735 / 1.35, 0.69 / 1.35, 0.3 / 1.35}, {0.42, 0.62, 0.3} },
};

#define PROBE_SCENE_9 { "coincident", {0.8, 0.6, 0.4}, 0.75, 0.5, \
    PROBE_COUNT(probe_s9_objects), probe_s9_objects, PROBE_COUNT(probe_s9_views), probe_s9_views, \
    PROBE_COUNT(probe_s9_examples), probe_s9_examples }

/* ---- All scenes ------------------------------------------------------------------------ */

static const probe_scene probe_scenes[] = {
    PROBE_SCENE_1, PROBE_SCENE_2, PROBE_SCENE_3, PROBE_SCENE_4, PROBE_SCENE_5,
    PROBE_SCENE_6, PROBE_SCENE_7, PROBE_SCENE_8, PROBE_SCENE_9,
};

enum { PROBE_SCENE_COUNT = 9 };

/* clang-format on */
#endif

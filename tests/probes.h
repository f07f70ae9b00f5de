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
 * In the comments a number such as "1f 9" is the front face of object 1 at depth 9, "1b 11"
 * a back face of object 1 at depth 11; opaque objects are named by their front face only.
 * A surface is left out where a nearer opaque surface makes it irrelevant.  Depths are
 * distances from the camera plane along the viewing axis.  All probes stay away from
 * projected edges and intersection curves by more than 0.02 of the picture's width (0.04 in
 * u and v).  The picture is square; u and v times half_width give the place on the plane.
 */
#ifndef GLASSINE_TESTS_PROBES_H
#define GLASSINE_TESTS_PROBES_H

#include <stdbool.h>
#include <stdint.h>

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

typedef struct probe { double u, v; probe_answer rule_default, rule_published; } probe;

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
    { -0.25, 0.35, {1, 2}, {1, 2} },      /* x -1, y 1.4: 1f 9, 2 at 9.5, 1b 11 */
    { -0.25, 0.1, {1, 0}, {1, 0} },       /* x -1, y 0.4: 1f 9, 1b 11, 4 at 12 */
    { 0.25, 0.1, {0, 3}, {0, 3} },        /* x 1, y 0.4: 3 at 7, 1f 9, 1b 11 */
    { 0.25, 0.35, {1, 0}, {1, 0} },       /* x 1, y 1.4: 1f 9, 1b 11 */
    { 0.35, -0.15, {1, 5}, {1, 5} },      /* x 1.4, y -0.6: 1f 9, 5 at 9.5, 1b 11 */
    { 0.62, -0.15, {0, 5}, {0, 5} },      /* x 2.48, y -0.6: 5 at 9.5, outside 1 */
    { -0.25, -0.375, {0, 6}, {0, 6} },    /* x -1, y -1.5: 6 at 8.5, 1f 9, 1b 11 */
    { 0.15, -0.375, {1, 7}, {1, 7} },     /* x 0.6, y -1.5: 1f 9, 7 at 10.5, 1b 11 */
    { 0.85, 0.85, {0, 0}, {0, 0} },       /* x 3.4, y 3.4: nothing */
    { -0.4375, 0.35, {1, 0}, {1, 0} },    /* x -1.75, y 1.4: 1f 9, 1b 11, beside 2 */
    { 0.6, 0.6, {0, 0}, {0, 0} },         /* x 2.4, y 2.4: nothing */
    { 0.0, -0.15, {1, 0}, {1, 0} },       /* x 0, y -0.6: 1f 9, 1b 11 */
    { -0.625, -0.15, {0, 8}, {0, 8} },    /* x -2.5, y -0.6: 8 at 12, outside 1 */
    { -0.375, -0.15, {1, 0}, {1, 0} },    /* x -1.5, y -0.6: 1f 9, 1b 11, 8 at 12 */
};

/* aslant: picture x is s = 0.8 x - 0.6 z, depth = 10 - t with t = 0.6 x + 0.8 z, half width 3;
 * on a ray x = 0.8 s + 0.6 t, z = -0.6 s + 0.8 t.  Object 1: front face z = 1 for s < 1, x = 2
 * for s > 1; back face x = -2 for s < -1, z = -1 for s > -1; outline s -2.2..2.2. */
static const probe probe_s1_aslant[] = {
    { -0.4, 0.45, {1, 2}, {1, 2} },       /* s -1.2, y 1.35: 1f (z=1) 9.65, 2 (z=0.5) 10.275, 1b (x=-2) 11.733 */
    { -0.15, 0.45, {1, 2}, {1, 2} },      /* s -0.45, y 1.35: 1f 9.0875, 2 (x=-0.5) 10.233, 1b (z=-1) 11.5875 */
    { -0.12, 0.13, {0, 3}, {0, 3} },      /* s -0.36, y 0.39: 3 (x=1.5) 7.02, 1f 9.02, 1b 11.52 */
    { -0.4, 0.13, {0, 3}, {0, 3} },       /* s -1.2, y 0.39: 3 (z=3) 7.15, 1f 9.65, 1b 11.733 */
    { 0.1, 0.13, {1, 0}, {1, 0} },        /* s 0.3, y 0.39: 1f 8.525, 1b 11.025, 4 (z=-2) 12.275 */
    { 0.22, -0.2, {1, 5}, {1, 5} },       /* s 0.66, y -0.6: 1f 8.255, 5 (z=0.5) 8.88, 1b 10.755 */
    { 0.385, -0.2, {1, 5}, {1, 5} },      /* s 1.155, y -0.6: 1f (x=2) 8.2067, 5 (z=0.5) 8.50875, 1b 10.384 */
    { 0.55, -0.2, {0, 5}, {0, 5} },       /* s 1.65, y -0.6: 5 (z=0.5, x 2.4375) 8.1375, 1f (x=2) 8.867, 1b 10.0125 */
    { 0.8, -0.2, {0, 5}, {0, 5} },        /* s 2.4, y -0.6: 5 (x=3) 8.2, outside 1 */
    { -0.6, -0.5, {0, 6}, {0, 6} },       /* s -1.8, y -1.5: 6 (z=1.5) 9.475, 1f 10.1, 1b 10.933 */
    { -0.385, -0.5, {0, 6}, {0, 6} },     /* s -1.155, y -1.5: 6 (x=-0.5, z 1.258) 9.293, 1f 9.616, 1b 11.793 */
    { -0.285, -0.5, {1, 6}, {1, 6} },     /* s -0.855, y -1.5: 1f 9.391, 6 (x=-0.5, z 0.758) 9.693, 1b 11.891 */
    { 0.25, -0.5, {1, 7}, {1, 7} },       /* s 0.75, y -1.5: 1f 8.1875, 7 (z=-0.5) 10.0625, 1b 10.6875 */
    { 0.47, -0.5, {1, 7}, {1, 7} },       /* s 1.41, y -1.5: 1f (x=2) 8.547, 7 (x=1.2, z -0.75) 9.88, 1b 10.1925 */
    { 0.62, -0.5, {1, 0}, {1, 0} },       /* s 1.86, y -1.5: 1f (x=2) 9.147, 1b 9.855, 7 (x=1.2, z -1.5) 10.48 */
    { 0.9, 0.5, {0, 0}, {0, 0} },         /* s 2.7, y 1.5: nothing */
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
    { -0.25, 0.3, {1, 2}, {1, 2} },     /* x -1, y 1.2: 1f 8, 2 at 8.2, 1b 9 */
    { 0.25, 0.3, {1, 0}, {1, 0} },      /* x 1, y 1.2: 1f 8, 1b 9, 1f 11, 3 at 11.2, 1b 12 */
    { -0.25, 0.0, {1, 0}, {1, 0} },     /* x -1, y 0: 1f 8, 1b 9, 4 at 9.5 */
    { 0.225, 0.0, {1, 5}, {1, 5} },     /* x 0.9, y 0: 1f 8, 5 at 8.5, 1b 9 */
    { -0.625, 0.0, {1, 6}, {1, 6} },    /* x -2.5, y 0: 1f 8, 6 at 11.2, 1b 12 */
    { 0.375, -0.3, {1, 0}, {1, 0} },    /* x 1.5, y -1.2: 1f 8, 1b 9, 7 at 9.5 */
    { 0.625, -0.3, {0, 7}, {0, 7} },    /* x 2.5, y -1.2: 7 at 9.5, outside 1 */
    { -0.25, -0.3, {0, 8}, {0, 8} },    /* x -1, y -1.2: 8 at 7, 1f 8 */
    { -0.825, -0.3, {0, 9}, {0, 9} },   /* x -3.3, y -1.2: 9 at 13, outside 1 */
    { -0.675, -0.3, {1, 0}, {1, 0} },   /* x -2.7, y -1.2: 1f 8, 1b 12, 9 at 13 */
    { 0.6, 0.3, {0, 0}, {0, 0} },       /* x 2.4, y 1.2: nothing */
    { -0.05, 0.15, {1, 0}, {1, 0} },    /* x -0.2, y 0.6: 1f 8, 1b 9, 1f 11, 1b 12 */
};

/* from -z: over x -2..2: 1f 8, 1b 9, 1f 11, 1b 12; over x -3..-2: 1f 8, 1b 12 */
static const probe probe_s2_rear[] = {
    { -0.25, 0.3, {1, 3}, {1, 3} },     /* x 1, y 1.2: 1f 8, 3 at 8.2, 1b 9 */
    { 0.25, 0.3, {1, 0}, {1, 0} },      /* x -1, y 1.2: 1f 8, 1b 9, 1f 11, 2 at 11.2 */
    { 0.25, 0.0, {1, 0}, {1, 0} },      /* x -1, y 0: 1f 8, 1b 9, 4 at 9.5 */
    { -0.225, 0.0, {1, 0}, {1, 0} },    /* x 0.9, y 0: 1f 8, 1b 9, 5 at 10 */
    { 0.625, 0.0, {1, 6}, {1, 6} },     /* x -2.5, y 0: 1f 8, 6 at 8.2, 1b 12 */
    { 0.25, -0.3, {1, 0}, {1, 0} },     /* x -1, y -1.2: 1f 8, 1b 9, 1f 11, 1b 12, 8 at 12.5 */
    { 0.825, -0.3, {0, 9}, {0, 9} },    /* x -3.3, y -1.2: 9 at 6.5 */
    { 0.675, -0.3, {0, 9}, {0, 9} },    /* x -2.7, y -1.2: 9 at 6.5, 1f 8 */
    { -0.625, -0.3, {0, 7}, {0, 7} },   /* x 2.5, y -1.2: 7 at 9.5, outside 1 */
    { -0.375, -0.3, {1, 0}, {1, 0} },   /* x 1.5, y -1.2: 1f 8, 1b 9, 7 at 9.5 */
};

/* from +x, into the gap: over z -1..1: 1f 12, 1b 13; over the arms: 1f 8, 1b 13 */
static const probe probe_s2_side[] = {
    { 0.0625, 0.0, {0, 4}, {0, 4} },    /* z -0.25, y 0: 4 at 10.5 in the open gap, 1f 12, 1b 13 */
    { -0.1875, 0.0, {0, 5}, {0, 5} },   /* z 0.75, y 0: 5 at 8.6 in the open gap, 1f 12 */
    { -0.3125, 0.0, {1, 5}, {1, 5} },   /* z 1.25, y 0: 1f 8, 5 at 8.6, 1b 13 */
    { 0.375, 0.0, {1, 6}, {1, 6} },     /* z -1.5, y 0: 1f 8, 6 at 12.2, 1b 13 */
    { 0.0, 0.3, {1, 0}, {1, 0} },       /* z 0, y 1.2: 1f 12, 1b 13 */
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
static const probe_polygon probe_s3_p4[] = { PROBE_BOX(-0.6, 0.0, 1.2, 1.8, 1.5, 1.9) };     /* in the wall at +z */
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
    { -0.1, 0.0, {1, 0}, {1, 0} },        /* x -0.4, y 0: 1f 8, 1b 8.6, 2 at 9.2 */
    { -0.2, -0.2, {1, 0}, {1, 0} },       /* x -0.8, y -0.8: 1f 8, 1b 8.6, 2 at 9.2 */
    { 0.2, 0.1, {1, 0}, {1, 0} },         /* x 0.8, y 0.4: 1f 8, 1b 8.6, 3 at 9.7 */
    { 0.2, 0.65, {0, 3}, {0, 3} },        /* x 0.8, y 2.6: 3 at 9.7 above the mug */
    { -0.075, 0.375, {1, 4}, {1, 4} },    /* x -0.3, y 1.5: 1f 8, 4 at 8.1, 1b 8.6 */
    { 0.0, -0.425, {1, 5}, {1, 5} },      /* x 0, y -1.7: 1f 8, 5 at 8.7, 1b 12 */
    { -0.425, 0.0, {1, 6}, {1, 6} },      /* x -1.7, y 0: 1f 8, 6 at 9.5, 1b 12 */
    { 0.6, -0.175, {0, 7}, {0, 7} },      /* x 2.4, y -0.7: 7 at 6.5 */
    { 0.4, -0.175, {0, 7}, {0, 7} },      /* x 1.6, y -0.7: 7 at 6.5, 1f 8, 1b 12 */
    { -0.65, 0.35, {0, 8}, {0, 8} },      /* x -2.6, y 1.4: 8 at 13, outside 1 */
    { -0.425, 0.35, {1, 0}, {1, 0} },     /* x -1.7, y 1.4: 1f 8, 1b 12, 8 at 13 */
    { 0.425, 0.35, {1, 0}, {1, 0} },      /* x 1.7, y 1.4: 1f 8, 1b 12 */
    { 0.0, 0.85, {0, 0}, {0, 0} },        /* x 0, y 3.4: nothing */
    { 0.8, 0.8, {0, 0}, {0, 0} },         /* x 3.2, y 3.2: nothing */
};

/* from +y: in the cavity 1f 11.4 (floor), 1b 12; on the rim 1f 8, 1b 12 */
static const probe probe_s3_top[] = {
    { -0.1875, 0.0, {0, 2}, {0, 2} },     /* x -0.75, z 0: 2 at 9 through the open top, 1f 11.4 */
    { 0.2, 0.0, {0, 3}, {0, 3} },         /* x 0.8, z 0: 3 at 7, 1f 11.4 */
    { 0.0, -0.2625, {1, 5}, {1, 5} },     /* x 0, z 1.05: 1f 11.4, 5 at 11.5, 1b 12 */
    { 0.0, 0.2625, {1, 5}, {1, 5} },      /* x 0, z -1.05: 1f 11.4, 5 at 11.5, 1b 12 */
    { 0.225, -0.25, {1, 0}, {1, 0} },     /* x 0.9, z 1: 1f 11.4, 1b 12 */
    { -0.075, -0.425, {1, 4}, {1, 4} },   /* x -0.3, z 1.7: 1f 8, 4 at 8.2, 1b 12 */
    { -0.425, 0.0, {1, 6}, {1, 6} },      /* x -1.7, z 0: 1f 8, 6 at 9.5, 1b 12 */
    { 0.5, -0.8125, {0, 7}, {0, 7} },     /* x 2, z 3.25: 7 at 10.2, outside 1 */
    { -0.65, 0.8125, {0, 8}, {0, 8} },    /* x -2.6, z -3.25: 8 at 8.2, outside 1 */
    { 0.425, -0.25, {1, 0}, {1, 0} },     /* x 1.7, z 1: 1f 8, 1b 12 */
    { 0.8, 0.3, {0, 0}, {0, 0} },         /* x 3.2, z -1.2: nothing */
};

/* from above and the front: picture y is w = 0.8 y - 0.6 z, depth = 10 - t with t = 0.6 y + 0.8 z;
 * on a ray y = 0.8 w + 0.6 t, z = -0.6 w + 0.8 t.  Rays with w 0.76..2.44 pass the open mouth
 * and meet the far cavity wall z = -1.4; with w 0.4..0.76 the near rim; lower ones the face z = 2. */
static const probe probe_s3_slanted[] = {
    { -0.1, 0.25, {0, 2}, {0, 2} },       /* x -0.4, w 1: 2 (top y=1, z -0.333) 9.667, 1f (z=-1.4) 11, 1b (z=-2) 11.75 */
    { 0.2, 0.325, {0, 3}, {0, 3} },       /* x 0.8, w 1.3: 3 (z=0.3, y 1.85) 8.65, 1f (z=-1.4) 10.775 */
    { 0.2, 0.0, {1, 0}, {1, 0} },         /* x 0.8, w 0: 1f (z=2) 7.5, 1b (z=1.4) 8.25, 3 (z=0.3) 9.625 */
    { -0.2, 0.45, {1, 0}, {1, 0} },       /* x -0.8, w 1.8: 1f (z=-1.4, y 1.2) 10.4, 1b (z=-2) 11.15 */
    { -0.075, 0.025, {1, 4}, {1, 4} },    /* x -0.3, w 0.1: 1f (z=2) 7.425, 4 (z=1.9, y 1.55) 7.55, 1b (z=1.4) 8.175 */
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
    { -0.75, 0.0, {0, 2}, {0, 2} },           /* x -3, y 0: 2 at 9.6, outside 1 */
    { -0.45, 0.0, {1, 2}, {1, 2} },           /* x -1.8, y 0: 1f 8, 2 at 9.6, 1b 12 */
    { -0.225, 0.15, {1, 3}, {1, 3} },         /* x -0.9, y 0.6: 1f 8, 3 at 9.5, 1b 12 */
    { 0.0, 0.3125, {1, 4}, {1, 4} },          /* x 0, y 1.25: 1f 8.25, 4 at 9.7, 1b 11.75 */
    { 0.0, 0.1875, {1, 4}, {1, 4} },          /* x 0, y 0.75: 1f 8, 4 at 9.7, 1b 12 */
    { 0.225, 0.15, {1, 5}, {1, 5} },          /* x 0.9, y 0.6: 1f 8, 5 at 9.5, 1b 12 */
    { 0.225, -0.075, {1, 5}, {1, 5} },        /* x 0.9, y -0.3: 1f 8, 5 at 9.5, 1b 12 */
    { 0.45, 0.0, {1, 6}, {1, 6} },            /* x 1.8, y 0: 1f 8, 6 at 9.6, 1b 12 */
    { 0.75, 0.0, {0, 6}, {0, 6} },            /* x 3, y 0: 6 at 9.6, outside 1 */
    { 0.0, -0.3125, {0, 7}, {0, 7} },         /* x 0, y -1.25: 7 at 7, 1f 8.25 */
    { -0.6625, -0.3125, {0, 8}, {0, 8} },     /* x -2.65, y -1.25: 8 at 13, outside 1 */
    { -0.5375, -0.3125, {1, 0}, {1, 0} },     /* x -2.15, y -1.25: 1f 8.25, 1b 11.75, 8 at 13 */
    { 0.45, 0.3, {1, 9}, {1, 9} },            /* x 1.8, y 1.2: 1f 8.2, 9 at 8.4, 1b 11.8 */
    { 0.45, 0.425, {0, 9}, {0, 9} },          /* x 1.8, y 1.7: 9 at 8.4, 1f 8.7, 1b 11.3 */
    { 0.0, 0.0, {1, 0}, {1, 0} },             /* x 0, y 0: between the webs, under the pin: 1f 8, 1b 12 */
    { 0.45, -0.3, {1, 0}, {1, 0} },           /* x 1.8, y -1.2: 1f 8.2, 1b 11.8 */
    { -0.45, 0.3, {1, 0}, {1, 0} },           /* x -1.8, y 1.2: 1f 8.2, 1b 11.8 */
    { 0.75, 0.3, {0, 0}, {0, 0} },            /* x 3, y 1.2: nothing */
};

/* from +x: in the octagon 1f 7.6, 1b 12.4 */
static const probe probe_s4_end[] = {
    { 0.0, 0.0, {0, 6}, {0, 6} },             /* z 0, y 0: 6 at 6.6, 1f 7.6 */
    { 0.0, 0.25, {1, 5}, {1, 5} },            /* z 0, y 1: 1f 7.6, 5 at 8.8, 1b 12.4 */
    { -0.3, 0.3, {1, 9}, {1, 9} },            /* z 1.2, y 1.2: 1f 7.6, 9 at 7.8, 1b 12.4 */
    { -0.6875, -0.3125, {0, 7}, {0, 7} },     /* z 2.75, y -1.25: 7 at 9.6, outside 1 */
    { 0.875, -0.325, {0, 8}, {0, 8} },        /* z -3.5, y -1.3: 8 at 11.9, outside 1 */
    { 0.0, -0.3, {1, 0}, {1, 0} },            /* z 0, y -1.2: 1f 7.6, 1b 12.4 */
    { 0.7, 0.7, {0, 0}, {0, 0} },             /* z -2.8, y 2.8: nothing */
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
    { 0.0, 0.0, {1, 0}, {1, 3} },         /* DIFFERS: x 0, y 0: 1f 7, 2f 8, 3 at 9, 2b 12, 1b 13 */
    { 0.15, 0.1, {1, 0}, {1, 3} },        /* DIFFERS: x 0.6, y 0.4: 1f 7, 2f 8, 3 at 9, 2b 12 */
    { -0.325, 0.35, {1, 4}, {1, 4} },     /* x -1.3, y 1.4: 1f 7, 4 at 7.2, 2f 8 */
    { 0.325, 0.35, {1, 0}, {1, 0} },      /* x 1.3, y 1.4: 1f 7, 2f 8, 2b 12, 5 at 12.2 */
    { 0.625, 0.0, {1, 6}, {1, 6} },       /* x 2.5, y 0: 1f 7, 6 at 9.5, 1b 13, beside 2 */
    { -0.325, -0.35, {0, 7}, {0, 7} },    /* x -1.3, y -1.4: 7 at 6, 1f 7 */
    { 0.325, -0.35, {1, 8}, {1, 8} },     /* x 1.3, y -1.4: 1f 7, 8 at 7.5, 2f 8 */
    { -0.575, 0.0, {1, 9}, {1, 9} },      /* x -2.3, y 0: 1f 7, 9 at 9.5, 1b 13, beside 2 */
    { -0.425, 0.0, {1, 0}, {1, 9} },      /* DIFFERS: x -1.7, y 0: 1f 7, 2f 8, 9 at 9.5, 2b 12 */
    { 0.0, 0.35, {1, 0}, {1, 0} },        /* x 0, y 1.4: 1f 7, 2f 8, 2b 12, 1b 13 */
    { 0.0, 0.625, {1, 0}, {1, 0} },       /* x 0, y 2.5: 1f 7, 1b 13 */
    { 0.9, 0.9, {0, 0}, {0, 0} },         /* x 3.6, y 3.6: nothing */
    { 0.65, 0.35, {1, 0}, {1, 0} },       /* x 2.6, y 1.4: 1f 7, 1b 13, 10 at 14 */
    { 0.85, 0.35, {0, 10}, {0, 10} },     /* x 3.4, y 1.4: 10 at 14, outside 1 */
};

/* from +x: 1f 7, 1b 13 over z, y -3..3; 2f 8, 2b 12 over z, y -2..2 */
static const probe probe_s5_side[] = {
    { 0.0, 0.0, {1, 6}, {1, 6} },         /* z 0, y 0: 1f 7, 6 at 7.2, 2f 8 */
    { -0.1875, 0.0, {1, 0}, {1, 3} },     /* DIFFERS: z 0.75, y 0: 1f 7, 2f 8, 3 at 9, 2b 12 */
    { -0.625, 0.35, {1, 4}, {1, 4} },     /* z 2.5, y 1.4: 1f 7, 4 at 10.8, 1b 13, beside 2 */
    { 0.625, 0.35, {1, 5}, {1, 5} },      /* z -2.5, y 1.4: 1f 7, 5 at 8.2, 1b 13, beside 2 */
    { -0.4375, -0.35, {1, 0}, {1, 8} },   /* DIFFERS: z 1.75, y -1.4: 1f 7, 2f 8, 8 at 8.2, 2b 12 */
    { -0.5625, -0.35, {1, 8}, {1, 8} },   /* z 2.25, y -1.4: 1f 7, 8 at 8.2, 1b 13, beside 2 */
    { -0.9375, -0.35, {0, 7}, {0, 7} },   /* z 3.75, y -1.4: 7 at 10.8, outside 1 */
    { 0.0, 0.35, {1, 0}, {1, 0} },        /* z 0, y 1.4: 1f 7, 2f 8, 2b 12, 1b 13 */
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


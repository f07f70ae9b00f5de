/* Probes of smart transparency, neighbours, fields, curvature and buckets worked out by hand:
 * Carnecky et al. 2013, figures 3, 7 and 8, equations 1 to 5 and 8 to 11, algorithms 2 and 3,
 * and Murray, Baril and Granier 2016, sections 4 and 5, as the project's design amends them.
 * Expected values were written down from the sentences; a throw-away script did roots,
 * exponentials and products, and repeated links, boundary conditions and steps to catch slips
 * of the hand (it found none that are left here).
 *
 * Scenes.  Pixels are whole numbers, x to the right, y up.  A patch is a planar sheet of one
 * fragment in each pixel x0 <= x <= x1, y0 <= y <= y1, at depth z + slope_x (x - x0) +
 * slope_y (y - y0); depth grows away from the eye; slopes are per pixel; the normal is given,
 * unit, eye space with z towards the eye, and need not follow from the slopes.  A fragment is
 * named by its patch and pixel.  Fragments of a pixel are in order of depth, index 0 nearest.
 * radius is r_obj of equation 1, with equal weights w_z = w_n (0.5 in the comments); by_uv: the
 * measure is the distance in (u, v).  Fragments of two parts are never linked.  line: the
 * fragment of a feature line, not a surface.  alpha is used under SMART_PROBE_GIVEN alone.
 * Probes of fields and weights take the links and boundary conditions of their own scene.
 *
 * published is the paper's answer where it differs or agrees; -2 (links), -1 (fields),
 * has_published = 0 (boundaries) where the paper does not say.  DIFFERS marks a difference.
 *
 * Readings taken, and the others (unsure = 1: the answer hangs on it):
 *  - equation 1 as printed has no absolute value, so that the farthest candidate would always
 *    win; DESIGN: absolute value.  published is given with it.
 *  - mutual best.  Algorithm 2 judges both ways with the slope of the fragment that asks, so
 *    that A may link to B and B to another; DESIGN: mutual best.  Taken: each judges its
 *    candidates with its own slope, and both must choose each other.  Judging both ways by the
 *    sum of both measures gives the same answers here.
 *  - the continuity limit has no number in the design: what is expected to be linked is under
 *    0.05 of the weighted measure, what the limit alone must part is at 0.5 (a radius, 40 pixels).
 *  - a layer index is of surface fragments (DESIGN).  "Merely swap order": surfaces that are
 *    above the fragment at one pixel and below it at the next, by links on both sides, are not
 *    counted in the comparison of indices; what remains is marked.  The paper compares plain
 *    indices.
 *  - "fewer than four neighbours" holds at the window's edge too: the paper's special value for
 *    a missing neighbour says no more than that there is none.
 *  - the four rules of 5.3 apply one by one, not as else-if: a fragment may be beta 1 and
 *    gamma 1, or beta 0 and gamma 1 (DESIGN: gamma is set independently, a missing link beats
 *    underneath).  published is not given where two rules meet.
 *  - equation 9 has no b, 8 has one; DESIGN: b masks beta and gamma, nothing masks alpha.
 *    published of beta: unmasked.  published of alpha: the mean of four, for fragments with
 *    four links; the paper leaves the stencil at a missing link open.
 *  - DESIGN: delta alpha = 1/8 sum over the links that exist, also at missing ones.
 *  - beta of figure 3 by equation 9 without a profile; 20 steps reach all.
 *  - algorithm 3, line 6 as printed: alpha <- alpha (1 - alpha_i), without the hat, so that the
 *    weights do not sum to 1 (published_*); DESIGN: with the hat.
 *  - equation 10 as printed is hard to read; DESIGN: (exp(-p (1-u)^2) - exp(-p)) / (1 - exp(-p)).
 *  - curvature from normals: the sum of principal curvatures is the divergence of the unit
 *    normal, which in the picture plane is d n_x/dx + d n_y/dy exactly; convex is negative, so
 *    kappa = -tanh of it.  By central differences; slopes n_x/n_z instead of normals differ
 *    where the surface is tilted (unsure).  The design's "known in closed form" is 2/R and 1/R.
 *  - Murray's measure (murray in links): 1 - n.n + (difference of depth)^2, in the depths of
 *    the scene, reverse check on.
 *  - buckets enter the hash table in order of part, as the reordered Z lists them.
 */
#ifndef GLASSINE_TESTS_PROBES_SMART_H
#define GLASSINE_TESTS_PROBES_SMART_H

#include <stddef.h>
#include <stdint.h>

/* clang-format off */

enum { SMART_PROBE_LEFT, SMART_PROBE_RIGHT, SMART_PROBE_DOWN, SMART_PROBE_UP };
enum { SMART_PROBE_ALPHA, SMART_PROBE_BETA, SMART_PROBE_GAMMA };
/* initial alpha: s everywhere, equation 5, the patch's own; SMART: constant with beta and gamma
 * (weights); OPAQUE: 1 */
enum { SMART_PROBE_CONSTANT, SMART_PROBE_ADAPTIVE, SMART_PROBE_GIVEN, SMART_PROBE_SMART, SMART_PROBE_OPAQUE };

typedef struct smart_probe_patch {
    const char *name; int x0, y0, x1, y1; double z, slope_x, slope_y, normal[3];
    int part, line; double alpha, uv[2], color[3];
} smart_probe_patch;

typedef struct smart_probe_scene {
    const char *name; int figure, width, height; double radius; int by_uv;
    int patch_count; const smart_probe_patch *patches;
} smart_probe_scene;

/* expected, published, murray: patch of the neighbour, -1 none, -2 not given */
typedef struct smart_probe_link {
    int scene, patch, x, y, direction, expected, published, murray, unsure; const char *why;
} smart_probe_link;

/* fixed: 1 where the paper's b is 0, the value never changes */
typedef struct smart_probe_marks { double beta; int beta_fixed; double gamma; int gamma_fixed; } smart_probe_marks;
typedef struct smart_probe_boundary {
    int scene, patch, x, y; smart_probe_marks expected; int has_published; smart_probe_marks published;
    int unsure; const char *why;
} smart_probe_boundary;

/* value of a field after so many steps; published < 0: not given */
typedef struct smart_probe_field {
    int scene, patch, x, y, field, alpha_law; double s, lambda; int steps;
    double expected, published, tolerance; int unsure; const char *why;
} smart_probe_field;

/* weights[0] background, weights[1 + i] patch i; they sum to 1 */
typedef struct smart_probe_weight {
    int scene, x, y, law; double s, lambda_beta, lambda_gamma; int steps; double weights[4], tolerance;
    int unsure; const char *why;
} smart_probe_weight;

/* |weight of patch 1 at (x0, y) - at (x1, y)| on scene 0 under the three laws, s = 0.3, lambda
 * 0.1 and 0.2, 20 steps: contrast of the contour of B where it passes under A */
typedef struct smart_probe_contrast { int scene, x0, x1, y; double smart, constant, opaque; const char *why; } smart_probe_contrast;

typedef struct smart_probe_profile { int equation; double p, u, expected, tolerance; const char *why; } smart_probe_profile;

/* equation 5: alpha of each of n fragments, so that sum (1 - alpha)^(i-1) alpha = s */
typedef struct smart_probe_adaptive { int n; double s, expected; const char *why; } smart_probe_adaptive;

/* near to far; hat = (1 - gamma)(alpha + (1 - alpha) beta); published as printed, see above */
typedef struct smart_probe_composite {
    int count; double alpha[4], beta[4], gamma[4], hat[4], weights[4], background;
    double published_weights[4], published_background; const char *why;
} smart_probe_composite;

/* normals: own, left, right, down, up; missing: bits 1 left, 2 right, 4 down, 8 up, whose
 * normals are to be ignored; pixel: world units a pixel, 1 for curvature per pixel */
typedef struct smart_probe_curvature {
    double normals[5][3]; int missing; double pixel, expected, tolerance; int unsure; const char *why;
} smart_probe_curvature;

/* fragments in order of arrival.  kept: their indices in Z after the first pass, by depth;
 * ordered: after reordering by part, then depth; slots: part, first, last (inclusive) position
 * in ordered, -1 where free; only the first k slots and count entries are meant */
typedef struct smart_probe_slot { int part, first, last; } smart_probe_slot;
typedef struct smart_probe_bucket {
    int k, count; int depth[8], part[8]; int kept_count; int kept[8], ordered[8]; smart_probe_slot slots[8];
    const char *why;
} smart_probe_bucket;

/* scene 0, figure 3: two overlapping squares */
static const smart_probe_patch smart_probe_patches_0[] = {
    {"A", 8, 8, 31, 31, 10.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"B", 2, 2, 19, 37, 20.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 2, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
};
/* scene 1, figure 7: two parallel sheets of one part */
static const smart_probe_patch smart_probe_patches_1[] = {
    {"P", 0, 0, 5, 2, 10.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"Q", 0, 0, 5, 2, 12.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
};
/* scene 2, figure 7: two sheets that cross */
static const smart_probe_patch smart_probe_patches_2[] = {
    {"P", 0, 0, 7, 2, 1.0, 0.3, 0.0, {0.287347886, 0.0, 0.957826285}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"Q", 0, 0, 7, 2, 2.65, -0.3, 0.0, {-0.287347886, 0.0, 0.957826285}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
};
/* scene 3, figure 7: two sheets that cross, all normals the same */
static const smart_probe_patch smart_probe_patches_3[] = {
    {"P", 0, 0, 7, 2, 1.0, 0.3, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"Q", 0, 0, 7, 2, 2.65, -0.3, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
};
/* scene 4, figure 7: sheets crossing along y */
static const smart_probe_patch smart_probe_patches_4[] = {
    {"P", 0, 0, 2, 7, 1.0, 0.0, 0.3, {0.0, 0.287347886, 0.957826285}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"Q", 0, 0, 2, 7, 2.65, 0.0, -0.3, {0.0, -0.287347886, 0.957826285}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
};
/* scene 5, figure 7: the front of two near sheets ends */
static const smart_probe_patch smart_probe_patches_5[] = {
    {"A", 0, 0, 3, 2, 10.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"B", 0, 0, 7, 2, 10.4, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
};
/* scene 6, figure 7: one sheet ends where another begins far behind */
static const smart_probe_patch smart_probe_patches_6[] = {
    {"A", 0, 0, 3, 2, 1.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"B", 4, 0, 7, 2, 41.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
};
/* scene 7, figure 7: coplanar sheets of two parts */
static const smart_probe_patch smart_probe_patches_7[] = {
    {"A", 0, 0, 3, 2, 1.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"B", 4, 0, 7, 2, 1.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 2, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
};
/* scene 8, figure 7: coplanar sheets of one part */
static const smart_probe_patch smart_probe_patches_8[] = {
    {"A", 0, 0, 3, 2, 1.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"B", 4, 0, 7, 2, 1.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
};
/* scene 9, figure 7: normals decide between near depths */
static const smart_probe_patch smart_probe_patches_9[] = {
    {"F1", 0, 0, 0, 0, 1.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"F2", 0, 0, 0, 0, 1.02, 0.0, 0.0, {0.6, 0.0, 0.8}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
    {"G1", 1, 0, 1, 0, 1.0, 0.0, 0.0, {0.6, 0.0, 0.8}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.7, 0.3}},
    {"G2", 1, 0, 1, 0, 1.02, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.8, 0.2}},
};
/* scene 10, figure 7: depth decides between near normals */
static const smart_probe_patch smart_probe_patches_10[] = {
    {"F1", 0, 0, 0, 0, 1.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"F2", 0, 0, 0, 0, 1.8, 0.0, 0.0, {0.28, 0.0, 0.96}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
    {"G1", 1, 0, 1, 0, 1.0, 0.0, 0.0, {0.28, 0.0, 0.96}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.7, 0.3}},
    {"G2", 1, 0, 1, 0, 1.8, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.8, 0.2}},
};
/* scene 11, figure 7: a slope on one side only */
static const smart_probe_patch smart_probe_patches_11[] = {
    {"A", 0, 0, 0, 0, 1.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"A2", 0, 0, 0, 0, 1.3, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
    {"B", 1, 0, 1, 0, 1.1, -0.2, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.7, 0.3}},
};
/* scene 12, figure 7: parameters instead of depth and normal */
static const smart_probe_patch smart_probe_patches_12[] = {
    {"P", 0, 0, 0, 0, 1.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"Q", 0, 0, 0, 0, 2.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.5, 0.0}, {0.2, 0.35, 0.9}},
    {"R", 1, 0, 1, 0, 1.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.51, 0.0}, {0.2, 0.7, 0.3}},
    {"T", 1, 0, 1, 0, 2.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.01, 0.0}, {0.9, 0.8, 0.2}},
};
/* scene 13, figure 7: five sheets, one missing beyond */
static const smart_probe_patch smart_probe_patches_13[] = {
    {"S1", 0, 0, 3, 2, 10.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"S2", 0, 0, 3, 2, 11.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
    {"S3", 0, 0, 1, 2, 12.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.7, 0.3}},
    {"S4", 0, 0, 3, 2, 13.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.8, 0.2}},
    {"S5", 0, 0, 3, 2, 14.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.7, 0.3, 0.8}},
};
/* scene 14, figure 8: a front sheet over part of a rear sheet */
static const smart_probe_patch smart_probe_patches_14[] = {
    {"F", 4, 0, 8, 6, 12.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"R", 0, 0, 11, 6, 15.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 2, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
};
/* scene 15, figure 8: two sheets that cross */
static const smart_probe_patch smart_probe_patches_15[] = {
    {"P", 0, 0, 7, 6, 1.0, 0.3, 0.0, {0.287347886, 0.0, 0.957826285}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"Q", 0, 0, 7, 6, 2.65, -0.3, 0.0, {-0.287347886, 0.0, 0.957826285}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
};
/* scene 16, figure 8: three sheets, edges one pixel apart */
static const smart_probe_patch smart_probe_patches_16[] = {
    {"F", 4, 0, 9, 6, 12.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"M", 5, 0, 9, 6, 14.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 2, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
    {"R", 0, 0, 9, 6, 18.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 3, 0, -1.0, {0.0, 0.0}, {0.2, 0.7, 0.3}},
};
/* scene 17, figure 8: a fold of one part before a sheet of the same part */
static const smart_probe_patch smart_probe_patches_17[] = {
    {"T", 0, 0, 5, 6, 10.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"U", 0, 0, 5, 6, 10.6, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
    {"R", 0, 0, 9, 6, 18.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.7, 0.3}},
};
/* scene 18, figure 8: a line before a sheet */
static const smart_probe_patch smart_probe_patches_18[] = {
    {"line", 3, 0, 3, 6, 8.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 9, 1, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"R", 0, 0, 6, 6, 10.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
};
/* scene 19, figure 8: sheets swap order where a third begins */
static const smart_probe_patch smart_probe_patches_19[] = {
    {"C", 3, 0, 7, 6, 0.2, 0.0, 0.0, {0.0, 0.0, 1.0}, 3, 0, -1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"P", 0, 0, 7, 6, 1.0, 0.3, 0.0, {0.287347886, 0.0, 0.957826285}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
    {"Q", 0, 0, 7, 6, 2.65, -0.3, 0.0, {-0.287347886, 0.0, 0.957826285}, 1, 0, -1.0, {0.0, 0.0}, {0.2, 0.7, 0.3}},
};
/* scene 20, figure 8: one bright fragment in a dark sheet */
static const smart_probe_patch smart_probe_patches_20[] = {
    {"dot", 3, 3, 3, 3, 10.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, 1.0, {0.0, 0.0}, {0.9, 0.2, 0.2}},
    {"a", 0, 0, 6, 2, 10.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, 0.0, {0.0, 0.0}, {0.2, 0.35, 0.9}},
    {"b", 0, 4, 6, 6, 10.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, 0.0, {0.0, 0.0}, {0.2, 0.7, 0.3}},
    {"c", 0, 3, 2, 3, 10.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, 0.0, {0.0, 0.0}, {0.9, 0.8, 0.2}},
    {"d", 4, 3, 6, 3, 10.0, 0.0, 0.0, {0.0, 0.0, 1.0}, 1, 0, 0.0, {0.0, 0.0}, {0.7, 0.3, 0.8}},
};

static const smart_probe_scene smart_probe_scenes[] = {
    {"two overlapping squares", 3, 40, 40, 20.0, 0, 2, smart_probe_patches_0},
    {"two parallel sheets of one part", 7, 6, 3, 10.0, 0, 2, smart_probe_patches_1},
    {"two sheets that cross", 7, 8, 3, 10.0, 0, 2, smart_probe_patches_2},
    {"two sheets that cross, all normals the same", 7, 8, 3, 10.0, 0, 2, smart_probe_patches_3},
    {"sheets crossing along y", 7, 3, 8, 10.0, 0, 2, smart_probe_patches_4},
    {"the front of two near sheets ends", 7, 8, 3, 10.0, 0, 2, smart_probe_patches_5},
    {"one sheet ends where another begins far behind", 7, 8, 3, 40.0, 0, 2, smart_probe_patches_6},
    {"coplanar sheets of two parts", 7, 8, 3, 4.0, 0, 2, smart_probe_patches_7},
    {"coplanar sheets of one part", 7, 8, 3, 4.0, 0, 2, smart_probe_patches_8},
    {"normals decide between near depths", 7, 2, 1, 1.0, 0, 4, smart_probe_patches_9},
    {"depth decides between near normals", 7, 2, 1, 1.0, 0, 4, smart_probe_patches_10},
    {"a slope on one side only", 7, 2, 1, 10.0, 0, 3, smart_probe_patches_11},
    {"parameters instead of depth and normal", 7, 2, 1, 1.0, 1, 4, smart_probe_patches_12},
    {"five sheets, one missing beyond", 7, 4, 3, 10.0, 0, 5, smart_probe_patches_13},
    {"a front sheet over part of a rear sheet", 8, 12, 7, 10.0, 0, 2, smart_probe_patches_14},
    {"two sheets that cross", 8, 8, 7, 10.0, 0, 2, smart_probe_patches_15},
    {"three sheets, edges one pixel apart", 8, 10, 7, 10.0, 0, 3, smart_probe_patches_16},
    {"a fold of one part before a sheet of the same part", 8, 10, 7, 10.0, 0, 3, smart_probe_patches_17},
    {"a line before a sheet", 8, 7, 7, 10.0, 0, 2, smart_probe_patches_18},
    {"sheets swap order where a third begins", 8, 8, 7, 10.0, 0, 3, smart_probe_patches_19},
    {"one bright fragment in a dark sheet", 8, 7, 7, 10.0, 0, 5, smart_probe_patches_20},
};
enum { SMART_PROBE_SCENE_COUNT = 21 };

static const smart_probe_link smart_probe_links[] = {
    /* scene 1: two parallel sheets of one part; patches 0 P, 1 Q */
    {1, 0, 2, 1, SMART_PROBE_RIGHT, 0, 0, 0, 0, "depth 10 predicts 10: measure 0 against 0.1; the paper prints no absolute value, with which the farther sheet would win; taken with it"},
    {1, 1, 2, 1, SMART_PROBE_RIGHT, 1, 1, 1, 0, "Q to Q"},
    {1, 0, 2, 1, SMART_PROBE_LEFT, 0, 0, 0, 0, "P to P"},
    {1, 1, 2, 1, SMART_PROBE_UP, 1, 1, 1, 0, "Q to Q"},
    {1, 0, 2, 1, SMART_PROBE_DOWN, 0, 0, 0, 0, "P to P"},
    {1, 0, 0, 1, SMART_PROBE_LEFT, -1, -1, -1, 0, "outside the picture: none"},
    {1, 1, 5, 1, SMART_PROBE_RIGHT, -1, -1, -1, 0, "outside the picture: none"},
    {1, 0, 2, 2, SMART_PROBE_UP, -1, -1, -1, 0, "outside the picture: none"},
    /* scene 2: two sheets that cross; patches 0 P, 1 Q */
    {2, 0, 1, 1, SMART_PROBE_RIGHT, 0, 0, -2, 0, "slope predicts 1.6: exact"},
    {2, 0, 2, 1, SMART_PROBE_RIGHT, 0, 0, 0, 0, "at 1.6, predicts 1.9: P at 1.9, Q at 1.75 before it"},
    {2, 1, 2, 1, SMART_PROBE_RIGHT, 1, 1, 1, 0, "at 2.05, predicts 1.75: Q exactly"},
    {2, 0, 3, 1, SMART_PROBE_LEFT, 0, 0, 0, 0, "the same from the right"},
    {2, 1, 3, 1, SMART_PROBE_LEFT, 1, 1, 1, 0, "the same from the right"},
    {2, 0, 4, 1, SMART_PROBE_UP, 0, 0, -2, 0, "no slope along y"},
    {2, 1, 6, 1, SMART_PROBE_LEFT, 1, 1, -2, 0, "past the crossing"},
    /* scene 3: two sheets that cross, all normals the same; patches 0 P, 1 Q */
    {3, 0, 2, 1, SMART_PROBE_RIGHT, 0, 0, 1, 0, "the slope alone decides: 0 against 0.0075; by depth alone (Murray) Q at 1.75 is nearer to 1.6 than P at 1.9"},
    {3, 1, 3, 1, SMART_PROBE_LEFT, 1, 1, 0, 0, "predicts 2.05: exact; by depth alone P at 1.6 is nearer to 1.75"},
    {3, 1, 2, 1, SMART_PROBE_RIGHT, 1, 1, 0, 0, "predicts 1.75; by depth alone P at 1.9"},
    {3, 0, 3, 1, SMART_PROBE_LEFT, 0, 0, 1, 0, "predicts 1.6; by depth alone Q at 2.05"},
    {3, 0, 5, 1, SMART_PROBE_RIGHT, 0, 0, 0, 0, "far from the crossing both ways agree"},
    /* scene 4: sheets crossing along y; patches 0 P, 1 Q */
    {4, 0, 1, 2, SMART_PROBE_UP, 0, 0, -2, 0, "slope along y predicts 1.9"},
    {4, 1, 1, 2, SMART_PROBE_UP, 1, 1, -2, 0, "slope along y predicts 1.75"},
    {4, 0, 1, 3, SMART_PROBE_DOWN, 0, 0, -2, 0, "backwards 1.6"},
    {4, 1, 1, 3, SMART_PROBE_DOWN, 1, 1, -2, 0, "backwards 2.05"},
    {4, 0, 1, 3, SMART_PROBE_LEFT, 0, 0, -2, 0, "no slope along x"},
    /* scene 5: the front of two near sheets ends; patches 0 A, 1 B */
    {5, 0, 3, 1, SMART_PROBE_RIGHT, -1, -1, -1, 0, "B(4) is the only candidate of A(3), but B(3) suits it better: not mutual"},
    {5, 1, 3, 1, SMART_PROBE_RIGHT, 1, 1, 1, 0, "mutual"},
    {5, 1, 4, 1, SMART_PROBE_LEFT, 1, 1, 1, 0, "A(3) is 0.02 off, B(3) 0"},
    {5, 0, 2, 1, SMART_PROBE_RIGHT, 0, 0, 0, 0, "within A"},
    /* scene 6: one sheet ends where another begins far behind; patches 0 A, 1 B */
    {6, 0, 3, 1, SMART_PROBE_RIGHT, -1, 1, 1, 0, "mutual best but a whole radius behind: the continuity limit; the paper links them DIFFERS"},
    {6, 1, 4, 1, SMART_PROBE_LEFT, -1, 0, 0, 0, "the same from the right DIFFERS"},
    {6, 0, 2, 1, SMART_PROBE_RIGHT, 0, 0, -2, 0, "within A"},
    /* scene 7: coplanar sheets of two parts; patches 0 A, 1 B */
    {7, 0, 3, 1, SMART_PROBE_RIGHT, -1, -1, -1, 0, "another part: infinite measure"},
    {7, 1, 4, 1, SMART_PROBE_LEFT, -1, -1, -1, 0, "another part"},
    /* scene 8: coplanar sheets of one part; patches 0 A, 1 B */
    {8, 0, 3, 1, SMART_PROBE_RIGHT, 1, 1, 1, 0, "nothing tells them apart: one surface"},
    {8, 1, 4, 1, SMART_PROBE_LEFT, 0, 0, 0, 0, "one surface"},
    /* scene 9: normals decide between near depths; patches 0 F1, 1 F2, 2 G1, 3 G2 */
    {9, 0, 0, 0, SMART_PROBE_RIGHT, 3, 3, 3, 0, "0.5 x 0.02 = 0.01 against 0.5 x 0.2 = 0.1"},
    {9, 1, 0, 0, SMART_PROBE_RIGHT, 2, 2, 2, 0, "the same normals"},
    {9, 2, 1, 0, SMART_PROBE_LEFT, 1, 1, 1, 0, "from the right"},
    {9, 3, 1, 0, SMART_PROBE_LEFT, 0, 0, 0, 0, "from the right"},
    /* scene 10: depth decides between near normals; patches 0 F1, 1 F2, 2 G1, 3 G2 */
    {10, 0, 0, 0, SMART_PROBE_RIGHT, 2, 2, 2, 0, "0.5 x 0.04 = 0.02 against 0.5 x 0.8 = 0.4"},
    {10, 1, 0, 0, SMART_PROBE_RIGHT, 3, 3, 3, 0, "the same"},
    /* scene 11: a slope on one side only; patches 0 A, 1 A2, 2 B */
    {11, 1, 0, 0, SMART_PROBE_RIGHT, 2, -1, -2, 1, "B is the only candidate; B with its own slope predicts 1.3, A2 exactly: mutual by each one's own slope. Algorithm 2 uses the slopes of the left pixel both ways: A, 0.1 off, beats A2, 0.2 off DIFFERS"},
    {11, 0, 0, 0, SMART_PROBE_RIGHT, -1, 2, -2, 1, "B prefers A2; algorithm 2 as printed links A to B DIFFERS"},
    {11, 2, 1, 0, SMART_PROBE_LEFT, 1, 1, -2, 1, "predicts 1.3"},
    /* scene 12: parameters instead of depth and normal; patches 0 P, 1 Q, 2 R, 3 T */
    {12, 0, 0, 0, SMART_PROBE_RIGHT, 3, 3, -2, 0, "0.01 in (u, v) against 0.51, whatever the depth"},
    {12, 1, 0, 0, SMART_PROBE_RIGHT, 2, 2, -2, 0, "0.01 in (u, v)"},
    {12, 2, 1, 0, SMART_PROBE_LEFT, 1, 1, -2, 0, "from the right"},
    {12, 3, 1, 0, SMART_PROBE_LEFT, 0, 0, -2, 0, "from the right"},
    /* scene 13: five sheets, one missing beyond; patches 0 S1, 1 S2, 2 S3, 3 S4, 4 S5 */
    {13, 2, 1, 1, SMART_PROBE_RIGHT, -1, -1, -1, 0, "S2 and S4 beyond are nearer to their own: none"},
    {13, 3, 1, 1, SMART_PROBE_RIGHT, 3, 3, 3, 0, "index 3 to index 2"},
    {13, 4, 2, 1, SMART_PROBE_LEFT, 4, 4, 4, 0, "index 3 to index 4"},
    {13, 1, 1, 1, SMART_PROBE_RIGHT, 1, 1, 1, 0, "index 1 to 1"},
};
enum { SMART_PROBE_LINK_COUNT = 53 };

static const smart_probe_boundary smart_probe_boundaries[] = {
    /* scene 14: a front sheet over part of a rear sheet; patches 0 F, 1 R */
    {14, 1, 3, 3, {0.0, 0, 1.0, 1}, 1, {0.0, 0, 1.0, 1}, 0, "index 0, right neighbour has index 1: beside a silhouette (blue)"},
    {14, 1, 4, 3, {0.0, 1, 0.0, 0}, 1, {0.0, 1, 0.0, 0}, 0, "index 1, left neighbour has index 0: underneath (green)"},
    {14, 1, 5, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 0.0, 0}, 0, "ordinary"},
    {14, 1, 8, 3, {0.0, 1, 0.0, 0}, 1, {0.0, 1, 0.0, 0}, 0, "underneath"},
    {14, 1, 9, 3, {0.0, 0, 1.0, 1}, 1, {0.0, 0, 1.0, 1}, 0, "beside"},
    {14, 1, 10, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 0.0, 0}, 0, "ordinary"},
    {14, 0, 4, 3, {1.0, 1, 0.0, 0}, 1, {1.0, 1, 0.0, 0}, 0, "no left neighbour (red)"},
    {14, 0, 8, 3, {1.0, 1, 0.0, 0}, 1, {1.0, 1, 0.0, 0}, 0, "no right neighbour"},
    {14, 0, 5, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 0.0, 0}, 0, "ordinary: index 0 all around"},
    {14, 0, 6, 0, {1.0, 1, 0.0, 0}, 1, {1.0, 1, 0.0, 0}, 0, "no lower neighbour"},
    {14, 0, 6, 6, {1.0, 1, 0.0, 0}, 1, {1.0, 1, 0.0, 0}, 0, "no upper neighbour"},
    {14, 1, 0, 3, {1.0, 1, 0.0, 0}, 1, {1.0, 1, 0.0, 0}, 0, "no left neighbour"},
    {14, 1, 11, 3, {1.0, 1, 0.0, 0}, 1, {1.0, 1, 0.0, 0}, 0, "no right neighbour"},
    {14, 1, 6, 0, {1.0, 1, 0.0, 0}, 1, {1.0, 1, 0.0, 0}, 0, "no lower neighbour, under F"},
    {14, 1, 3, 0, {1.0, 1, 1.0, 1}, 0, {0.0, 0, 0.0, 0}, 0, "no lower neighbour and beside a silhouette: beta and gamma are set independently"},
    {14, 1, 4, 0, {1.0, 1, 0.0, 0}, 0, {0.0, 0, 0.0, 0}, 0, "no lower neighbour and underneath: the missing link wins"},
    {14, 1, 9, 6, {1.0, 1, 1.0, 1}, 0, {0.0, 0, 0.0, 0}, 0, "no upper neighbour and beside"},
    {14, 1, 4, 1, {0.0, 1, 0.0, 0}, 1, {0.0, 1, 0.0, 0}, 0, "underneath"},
    {14, 1, 2, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 0.0, 0}, 0, "ordinary"},
    {14, 1, 1, 1, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 0.0, 0}, 0, "ordinary"},
    /* scene 15: two sheets that cross; patches 0 P, 1 Q */
    {15, 0, 2, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 1.0, 1}, 0, "P and Q, both linked, swap order to the right: nothing is marked; by the index alone: gamma DIFFERS"},
    {15, 0, 3, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 1, 0.0, 0}, 0, "swapped; by the index alone: underneath DIFFERS"},
    {15, 1, 2, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 1, 0.0, 0}, 0, "swapped; by the index alone: underneath DIFFERS"},
    {15, 1, 3, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 1.0, 1}, 0, "swapped; by the index alone: gamma DIFFERS"},
    {15, 0, 1, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 0.0, 0}, 0, "before the crossing"},
    {15, 1, 4, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 0.0, 0}, 0, "after the crossing"},
    /* scene 16: three sheets, edges one pixel apart; patches 0 F, 1 M, 2 R */
    {16, 2, 3, 3, {0.0, 0, 1.0, 1}, 1, {0.0, 0, 1.0, 1}, 0, "index 0, right neighbour 1"},
    {16, 2, 4, 3, {0.0, 1, 1.0, 1}, 1, {0.0, 1, 1.0, 1}, 0, "index 1: left neighbour 0, right neighbour 2: underneath and beside at once"},
    {16, 2, 5, 3, {0.0, 1, 0.0, 0}, 1, {0.0, 1, 0.0, 0}, 0, "index 2, left neighbour 1"},
    {16, 2, 6, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 0.0, 0}, 0, "ordinary"},
    {16, 1, 5, 3, {1.0, 1, 0.0, 0}, 1, {1.0, 1, 0.0, 0}, 0, "no left neighbour, index 1"},
    {16, 1, 6, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 0.0, 0}, 0, "ordinary"},
    {16, 0, 4, 3, {1.0, 1, 0.0, 0}, 1, {1.0, 1, 0.0, 0}, 0, "no left neighbour"},
    {16, 0, 5, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 0.0, 0}, 0, "M begins behind F: nothing for F"},
    /* scene 17: a fold of one part before a sheet of the same part; patches 0 T, 1 U, 2 R */
    {17, 0, 5, 3, {1.0, 1, 0.0, 0}, 1, {1.0, 1, 0.0, 0}, 0, "the fold: R(6) suits R(5) better: no right neighbour"},
    {17, 1, 5, 3, {1.0, 1, 0.0, 0}, 1, {1.0, 1, 0.0, 0}, 0, "the fold"},
    {17, 2, 5, 3, {0.0, 1, 0.0, 0}, 1, {0.0, 1, 0.0, 0}, 0, "index 2, right neighbour 0: underneath"},
    {17, 2, 6, 3, {0.0, 0, 1.0, 1}, 1, {0.0, 0, 1.0, 1}, 0, "index 0, left neighbour 2: beside"},
    {17, 1, 3, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 0.0, 0}, 0, "ordinary, index 1 all around"},
    {17, 2, 7, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 0.0, 0}, 0, "ordinary"},
    /* scene 18: a line before a sheet; patches 0 line, 1 R */
    {18, 1, 2, 3, {0.0, 0, 0.0, 0}, 0, {0.0, 0, 0.0, 0}, 0, "the layer index counts surfaces only: nothing is marked beside a line"},
    {18, 1, 3, 3, {0.0, 0, 0.0, 0}, 0, {0.0, 0, 0.0, 0}, 0, "nor under it"},
    {18, 1, 4, 3, {0.0, 0, 0.0, 0}, 0, {0.0, 0, 0.0, 0}, 0, "nor on its other side"},
    {18, 1, 3, 0, {1.0, 1, 0.0, 0}, 0, {0.0, 0, 0.0, 0}, 0, "no lower neighbour"},
    /* scene 19: sheets swap order where a third begins; patches 0 C, 1 P, 2 Q */
    {19, 1, 2, 3, {0.0, 0, 1.0, 1}, 1, {0.0, 0, 1.0, 1}, 0, "index 0 to 2: one for the swap with Q, one for the silhouette of C: beside"},
    {19, 0, 3, 3, {1.0, 1, 0.0, 0}, 1, {1.0, 1, 0.0, 0}, 0, "no left neighbour"},
    {19, 1, 4, 3, {0.0, 0, 0.0, 0}, 1, {0.0, 0, 0.0, 0}, 0, "ordinary"},
};
enum { SMART_PROBE_BOUNDARY_COUNT = 47 };

static const smart_probe_field smart_probe_fields[] = {
    /* scene 14: a front sheet over part of a rear sheet; patches 0 F, 1 R */
    {14, 1, 3, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 0, 0.51, -1.0, 0.000001, 0, "one layer: s"},
    {14, 1, 4, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 0, 0.3, -1.0, 0.000001, 0, "two layers: 1 - sqrt(0.49)"},
    {14, 0, 6, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 0, 0.3, -1.0, 0.000001, 0, "two layers, front"},
    {14, 1, 3, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 1, 0.48375, 0.4575, 0.000001, 0, "0.51 + (0.3 - 0.51)/8; paper: mean of four 0.4575 DIFFERS"},
    {14, 1, 4, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 1, 0.32625, 0.3525, 0.000001, 0, "0.3 + (0.51 - 0.3)/8; paper 0.3525 DIFFERS"},
    {14, 1, 2, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 1, 0.51, 0.51, 0.000001, 0, "all neighbours equal"},
    {14, 1, 5, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 1, 0.3, 0.3, 0.000001, 0, "all neighbours equal"},
    {14, 1, 3, 0, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 1, 0.48375, -1.0, 0.000001, 0, "the missing link takes no part"},
    {14, 1, 4, 6, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 1, 0.32625, -1.0, 0.000001, 0, "the missing link takes no part"},
    {14, 0, 4, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 1, 0.3, -1.0, 0.000001, 0, "F has one missing link, the others are equal"},
    {14, 1, 3, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 0.5, 1, 0.496875, -1.0, 0.000001, 0, "half a step: 0.51 - 0.02625/2"},
    {14, 1, 4, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 0.5, 1, 0.313125, -1.0, 0.000001, 0, "half a step"},
    {14, 1, 3, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 0.0, 1, 0.51, -1.0, 0.000001, 0, "no step"},
    {14, 1, 2, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 2, 0.50671875, -1.0, 0.000001, 0, "0.51 + (0.48375 - 0.51)/8"},
    {14, 1, 3, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 2, 0.46734375, -1.0, 0.000001, 0, "0.48375 + (0.02625 - 0.1575)/8: also a gamma fragment diffuses"},
    {14, 1, 4, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 2, 0.34265625, -1.0, 0.000001, 0, "0.32625 + (0.1575 - 0.02625)/8: also an underneath fragment diffuses"},
    {14, 1, 5, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 2, 0.30328125, -1.0, 0.000001, 0, "0.3 + 0.02625/8"},
    {14, 1, 1, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 2, 0.51, -1.0, 0.000001, 0, "not reached yet"},
    {14, 1, 8, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 1, 0.32625, -1.0, 0.000001, 0, "the right side is alike"},
    {14, 1, 9, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 2, 0.46734375, -1.0, 0.000001, 0, "the right side is alike"},
    {14, 1, 0, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 2, 0.51, -1.0, 0.000001, 0, "boundary fragment, equal neighbours"},
    {14, 0, 6, 3, SMART_PROBE_ALPHA, SMART_PROBE_ADAPTIVE, 0.51, 1.0, 2, 0.3, -1.0, 0.000001, 0, "front sheet stays"},
    {14, 1, 3, 3, SMART_PROBE_ALPHA, SMART_PROBE_CONSTANT, 0.7, 1.0, 5, 0.7, -1.0, 0.000001, 0, "a constant stays"},
    /* scene 20: one bright fragment in a dark sheet; patches 0 dot, 1 a, 2 b, 3 c, 4 d */
    {20, 0, 3, 3, SMART_PROBE_ALPHA, SMART_PROBE_GIVEN, 0.0, 1.0, 1, 0.5, 0.0, 0.000001, 0, "1 - 4/8; paper: mean of four 0 DIFFERS"},
    {20, 4, 4, 3, SMART_PROBE_ALPHA, SMART_PROBE_GIVEN, 0.0, 1.0, 1, 0.125, 0.25, 0.000001, 0, "1/8; paper 1/4 DIFFERS"},
    {20, 1, 3, 2, SMART_PROBE_ALPHA, SMART_PROBE_GIVEN, 0.0, 1.0, 1, 0.125, 0.25, 0.000001, 0, "1/8 DIFFERS"},
    {20, 0, 3, 3, SMART_PROBE_ALPHA, SMART_PROBE_GIVEN, 0.0, 1.0, 2, 0.3125, 0.25, 0.000001, 0, "0.5 + 4 (0.125 - 0.5)/8; paper 1/4 DIFFERS"},
    {20, 4, 4, 3, SMART_PROBE_ALPHA, SMART_PROBE_GIVEN, 0.0, 1.0, 2, 0.125, 0.0, 0.000001, 0, "0.125 + (0.375 - 3 x 0.125)/8; paper 0: the checkerboard DIFFERS"},
    {20, 2, 4, 4, SMART_PROBE_ALPHA, SMART_PROBE_GIVEN, 0.0, 1.0, 2, 0.03125, 0.125, 0.000001, 0, "2 x 0.125/8; paper 1/8 DIFFERS"},
    {20, 4, 5, 3, SMART_PROBE_ALPHA, SMART_PROBE_GIVEN, 0.0, 1.0, 2, 0.015625, 0.0625, 0.000001, 0, "0.125/8; paper 1/16 DIFFERS"},
    {20, 3, 2, 3, SMART_PROBE_ALPHA, SMART_PROBE_GIVEN, 0.0, 1.0, 1, 0.125, 0.25, 0.000001, 0, "1/8 DIFFERS"},
    {20, 1, 2, 2, SMART_PROBE_ALPHA, SMART_PROBE_GIVEN, 0.0, 1.0, 1, 0.0, 0.0, 0.000001, 0, "not reached"},
    /* scene 14: a front sheet over part of a rear sheet; patches 0 F, 1 R */
    {14, 0, 5, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 0, 0.0, 0.0, 0.000001, 0, "nothing yet"},
    {14, 0, 5, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 1, 0.75, 0.75, 0.000001, 0, "one step from the boundary"},
    {14, 0, 6, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 1, 0.0, 0.0, 0.000001, 0, "not reached"},
    {14, 0, 6, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 2, 0.5, 0.5, 0.000001, 0, "two steps"},
    {14, 0, 6, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 9, 0.5, 0.5, 0.000001, 0, "stays"},
    {14, 0, 4, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 9, 1.0, 1.0, 0.000001, 0, "boundary keeps 1"},
    {14, 1, 1, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 1, 0.75, 0.75, 0.000001, 0, "one step"},
    {14, 1, 2, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 2, 0.5, 0.5, 0.000001, 0, "two steps"},
    {14, 1, 3, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 3, 0.25, 0.25, 0.000001, 0, "three steps: gamma is no obstacle to beta"},
    {14, 1, 4, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 9, 0.0, 0.25, 0.000001, 0, "underneath keeps 0; the paper's equation 9 has no b DIFFERS"},
    {14, 1, 4, 1, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 1, 0.0, 0.75, 0.000001, 0, "underneath keeps 0 beside a boundary fragment DIFFERS"},
    {14, 1, 4, 1, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 9, 0.0, 0.75, 0.000001, 0, "underneath keeps 0 DIFFERS"},
    {14, 1, 5, 1, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 1, 0.75, 0.75, 0.000001, 0, "one step from the lower boundary"},
    {14, 1, 5, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 2, 0.0, 0.0, 0.000001, 0, "three steps are needed"},
    {14, 1, 5, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.25, 3, 0.25, 0.25, 0.000001, 0, "three steps from the lower boundary"},
    {14, 1, 1, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 1.0, 1, 0.0, 0.0, 0.000001, 0, "lambda 1: no spreading"},
    {14, 1, 1, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.0, 1, 1.0, 1.0, 0.000001, 0, "lambda 0: undiminished"},
    {14, 0, 6, 3, SMART_PROBE_BETA, SMART_PROBE_CONSTANT, 0.3, 0.6, 2, 0.0, 0.0, 0.000001, 0, "1 - 1.2 is below 0: stays 0"},
    {14, 1, 3, 3, SMART_PROBE_GAMMA, SMART_PROBE_CONSTANT, 0.3, 0.25, 9, 1.0, 1.0, 0.000001, 0, "source keeps 1"},
    {14, 1, 2, 3, SMART_PROBE_GAMMA, SMART_PROBE_CONSTANT, 0.3, 0.25, 1, 0.75, 0.75, 0.000001, 0, "one step outwards"},
    {14, 1, 4, 3, SMART_PROBE_GAMMA, SMART_PROBE_CONSTANT, 0.3, 0.25, 1, 0.75, 0.75, 0.000001, 0, "one step under the occluder: only beta is held there"},
    {14, 1, 5, 3, SMART_PROBE_GAMMA, SMART_PROBE_CONSTANT, 0.3, 0.25, 1, 0.0, 0.0, 0.000001, 0, "not reached"},
    {14, 1, 5, 3, SMART_PROBE_GAMMA, SMART_PROBE_CONSTANT, 0.3, 0.25, 2, 0.5, 0.5, 0.000001, 0, "two steps"},
    {14, 1, 1, 3, SMART_PROBE_GAMMA, SMART_PROBE_CONSTANT, 0.3, 0.25, 2, 0.5, 0.5, 0.000001, 0, "two steps"},
    {14, 1, 0, 3, SMART_PROBE_GAMMA, SMART_PROBE_CONSTANT, 0.3, 0.25, 3, 0.25, 0.25, 0.000001, 0, "three steps, boundary fragment"},
    {14, 1, 0, 3, SMART_PROBE_GAMMA, SMART_PROBE_CONSTANT, 0.3, 0.25, 2, 0.0, 0.0, 0.000001, 0, "not reached"},
    {14, 1, 6, 3, SMART_PROBE_GAMMA, SMART_PROBE_CONSTANT, 0.3, 0.25, 3, 0.25, 0.25, 0.000001, 0, "three steps from both sides"},
    {14, 1, 10, 3, SMART_PROBE_GAMMA, SMART_PROBE_CONSTANT, 0.3, 0.5, 1, 0.5, 0.5, 0.000001, 0, "lambda 0.5"},
    {14, 1, 11, 3, SMART_PROBE_GAMMA, SMART_PROBE_CONSTANT, 0.3, 0.5, 4, 0.0, 0.0, 0.000001, 0, "1 - 2 x 0.5"},
    {14, 0, 4, 3, SMART_PROBE_GAMMA, SMART_PROBE_CONSTANT, 0.3, 0.25, 9, 0.0, 0.0, 0.000001, 0, "no gamma on the occluder"},
    {14, 1, 7, 3, SMART_PROBE_GAMMA, SMART_PROBE_CONSTANT, 0.3, 0.25, 2, 0.5, 0.5, 0.000001, 0, "two steps from column 9"},
};
enum { SMART_PROBE_FIELD_COUNT = 63 };

static const smart_probe_weight smart_probe_weights[] = {
    {0, 19, 8, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.0, 1.0, 0.0}, 0.000001, 0, "crossing: A is boundary, beta 1, opaque: contrast of the hidden contour 0 (a T)"},
    {0, 20, 8, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.0, 1.0, 0.0}, 0.000001, 0, "the other side of the contour at the crossing: the same colour"},
    {0, 19, 9, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.042, 0.93, 0.028}, 0.000001, 0, "A: beta 0.9, alpha-hat 0.93; B: own boundary, beta 1, gamma 0.6; contrast 0.028"},
    {0, 20, 9, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.07, 0.93, 0.0}, 0.000001, 0, "across the contour: A before the background"},
    {0, 19, 10, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.056, 0.86, 0.084}, 0.000001, 0, "A: beta 0.8, alpha-hat 0.86; B: own boundary, beta 1, gamma 0.4; contrast 0.084"},
    {0, 20, 10, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.14, 0.86, 0.0}, 0.000001, 0, "across the contour: A before the background"},
    {0, 19, 11, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.042, 0.79, 0.168}, 0.000001, 0, "A: beta 0.7, alpha-hat 0.79; B: own boundary, beta 1, gamma 0.2; contrast 0.168"},
    {0, 19, 12, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.0, 0.72, 0.28}, 0.000001, 0, "A: beta 0.6, alpha-hat 0.72; B: own boundary, beta 1, gamma 0.0; contrast 0.280"},
    {0, 20, 12, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.28, 0.72, 0.0}, 0.000001, 0, "across the contour: A before the background"},
    {0, 19, 13, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.0, 0.65, 0.35}, 0.000001, 0, "A: beta 0.5, alpha-hat 0.65; B: own boundary, beta 1, gamma 0.0; contrast 0.350"},
    {0, 19, 15, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.0, 0.51, 0.49}, 0.000001, 0, "A: beta 0.3, alpha-hat 0.51; B: own boundary, beta 1, gamma 0.0; contrast 0.490"},
    {0, 19, 17, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.0, 0.37, 0.63}, 0.000001, 0, "A: beta 0.1, alpha-hat 0.37; B: own boundary, beta 1, gamma 0.0; contrast 0.630"},
    {0, 19, 18, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.0, 0.3, 0.7}, 0.000001, 0, "A: beta 0.0, alpha-hat 0.30; B: own boundary, beta 1, gamma 0.0; contrast 0.700"},
    {0, 20, 18, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.7, 0.3, 0.0}, 0.000001, 0, "across the contour: A before the background"},
    {0, 19, 19, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.0, 0.3, 0.7}, 0.000001, 0, "A: beta 0.0, alpha-hat 0.30; B: own boundary, beta 1, gamma 0.0; contrast 0.700"},
    {0, 19, 31, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.0, 1.0, 0.0}, 0.000001, 0, "the upper crossing"},
    {0, 19, 28, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.042, 0.79, 0.168}, 0.000001, 0, "3 steps under the upper crossing: contrast 0.21 x 0.8"},
    {0, 19, 7, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {1.0, 0.0, 0.0}, 0.000001, 0, "halo: B beside the occluding edge, gamma 1, not seen at all"},
    {0, 19, 6, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.8, 0.0, 0.2}, 0.000001, 0, "halo one step on: gamma 0.8"},
    {0, 19, 5, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.6, 0.0, 0.4}, 0.000001, 0, "gamma 0.6"},
    {0, 19, 4, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.4, 0.0, 0.6}, 0.000001, 0, "gamma 0.4"},
    {0, 19, 3, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.2, 0.0, 0.8}, 0.000001, 0, "gamma 0.2"},
    {0, 12, 20, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.1372, 0.72, 0.1428}, 0.000001, 0, "A 4 from its left edge; B 7 from its right edge (beta 0.3), 5 from the halo (gamma 0)"},
    {0, 10, 20, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.10892, 0.86, 0.03108}, 0.000001, 0, "A 2 from its edge; B 9 from its right edge (beta 0.1), 3 from the halo column 7 (gamma 0.4)"},
    {0, 5, 20, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.684, 0.0, 0.316}, 0.000001, 0, "B alone, 3 from its left edge (beta 0.7), 2 from the halo column 7 (gamma 0.6)"},
    {0, 8, 20, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.0, 1.0, 0.0}, 0.000001, 0, "under the silhouette of A: beta of B held at 0, gamma 0.8"},
    {0, 25, 20, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.42, 0.58, 0.0}, 0.000001, 0, "A alone, 6 from its right edge"},
    {0, 31, 20, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {0.0, 1.0, 0.0}, 0.000001, 0, "edge of A"},
    {0, 35, 35, SMART_PROBE_SMART, 0.3, 0.1, 0.2, 20, {1.0, 0.0, 0.0}, 0.000001, 0, "background"},
    {0, 19, 8, SMART_PROBE_CONSTANT, 0.3, 0.1, 0.2, 20, {0.49, 0.3, 0.21}, 0.000001, 0, "constant alpha: contrast 0.7 x 0.3 = 0.21 all along, crossing included (an X)"},
    {0, 19, 9, SMART_PROBE_CONSTANT, 0.3, 0.1, 0.2, 20, {0.49, 0.3, 0.21}, 0.000001, 0, "constant alpha: contrast 0.7 x 0.3 = 0.21 all along, crossing included (an X)"},
    {0, 19, 12, SMART_PROBE_CONSTANT, 0.3, 0.1, 0.2, 20, {0.49, 0.3, 0.21}, 0.000001, 0, "constant alpha: contrast 0.7 x 0.3 = 0.21 all along, crossing included (an X)"},
    {0, 19, 18, SMART_PROBE_CONSTANT, 0.3, 0.1, 0.2, 20, {0.49, 0.3, 0.21}, 0.000001, 0, "constant alpha: contrast 0.7 x 0.3 = 0.21 all along, crossing included (an X)"},
    {0, 20, 12, SMART_PROBE_CONSTANT, 0.3, 0.1, 0.2, 20, {0.7, 0.3, 0.0}, 0.000001, 0, "constant alpha: across the contour"},
    {0, 19, 5, SMART_PROBE_CONSTANT, 0.3, 0.1, 0.2, 20, {0.7, 0.0, 0.3}, 0.000001, 0, "constant alpha: contrast 0.3 outside A"},
    {0, 19, 8, SMART_PROBE_OPAQUE, 0.3, 0.1, 0.2, 20, {0.0, 1.0, 0.0}, 0.000001, 0, "opaque: contrast 0 under A (a T)"},
    {0, 19, 12, SMART_PROBE_OPAQUE, 0.3, 0.1, 0.2, 20, {0.0, 1.0, 0.0}, 0.000001, 0, "opaque: contrast 0 under A (a T)"},
    {0, 19, 18, SMART_PROBE_OPAQUE, 0.3, 0.1, 0.2, 20, {0.0, 1.0, 0.0}, 0.000001, 0, "opaque: contrast 0 under A (a T)"},
    {0, 19, 5, SMART_PROBE_OPAQUE, 0.3, 0.1, 0.2, 20, {0.0, 0.0, 1.0}, 0.000001, 0, "opaque: contrast 1 outside A"},
};
enum { SMART_PROBE_WEIGHT_COUNT = 39 };

static const smart_probe_contrast smart_probe_contrasts[] = {
    {0, 19, 20, 3, 0.8, 0.3, 1.0, "outside A: gamma 0.2"},
    {0, 19, 20, 4, 0.6, 0.3, 1.0, "outside A: gamma 0.4"},
    {0, 19, 20, 5, 0.4, 0.3, 1.0, "outside A: gamma 0.6"},
    {0, 19, 20, 6, 0.2, 0.3, 1.0, "outside A: gamma 0.8"},
    {0, 19, 20, 7, 0.0, 0.3, 1.0, "outside A: gamma 1.0"},
    {0, 19, 20, 8, 0.0, 0.21, 0.0, "under A: beta 1.0, gamma of B 0.8: 0.7 x 0.0 x 0.2"},
    {0, 19, 20, 9, 0.028, 0.21, 0.0, "under A: beta 0.9, gamma of B 0.6: 0.7 x 0.1 x 0.4"},
    {0, 19, 20, 10, 0.084, 0.21, 0.0, "under A: beta 0.8, gamma of B 0.4: 0.7 x 0.2 x 0.6"},
    {0, 19, 20, 11, 0.168, 0.21, 0.0, "under A: beta 0.7, gamma of B 0.2: 0.7 x 0.3 x 0.8"},
    {0, 19, 20, 12, 0.28, 0.21, 0.0, "under A: beta 0.6, gamma of B 0.0: 0.7 x 0.4 x 1.0"},
    {0, 19, 20, 13, 0.35, 0.21, 0.0, "under A: beta 0.5, gamma of B 0.0: 0.7 x 0.5 x 1.0"},
    {0, 19, 20, 14, 0.42, 0.21, 0.0, "under A: beta 0.4, gamma of B 0.0: 0.7 x 0.6 x 1.0"},
    {0, 19, 20, 15, 0.49, 0.21, 0.0, "under A: beta 0.3, gamma of B 0.0: 0.7 x 0.7 x 1.0"},
    {0, 19, 20, 16, 0.56, 0.21, 0.0, "under A: beta 0.2, gamma of B 0.0: 0.7 x 0.8 x 1.0"},
    {0, 19, 20, 17, 0.63, 0.21, 0.0, "under A: beta 0.1, gamma of B 0.0: 0.7 x 0.9 x 1.0"},
    {0, 19, 20, 18, 0.7, 0.21, 0.0, "under A: beta 0.0, gamma of B 0.0: 0.7 x 1.0 x 1.0"},
    {0, 19, 20, 19, 0.7, 0.21, 0.0, "under A: beta 0.0, gamma of B 0.0: 0.7 x 1.0 x 1.0"},
};
enum { SMART_PROBE_CONTRAST_COUNT = 17 };

static const smart_probe_profile smart_probe_profiles[] = {
    {10, 3.0, 0.0, 0.0, 0.000001, "0 at 0"},
    {10, 3.0, 1.0, 1.0, 0.000001, "1 at 1"},
    {10, 3.0, 0.5, 0.444720831, 0.000001, "exp(-0.75) and exp(-3)"},
    {10, 3.0, 0.25, 0.142277933, 0.000001, "exp(-1.6875)"},
    {10, 3.0, 0.75, 0.82007098, 0.000001, "exp(-0.1875)"},
    {10, 1.0, 0.5, 0.650067991, 0.000001, "exp(-0.25) and exp(-1)"},
    {10, 10.0, 0.5, 0.082043323, 0.000001, "exp(-2.5)"},
    {10, 10.0, 0.9, 0.904833097, 0.000001, "exp(-0.1)"},
    {10, 0.5, 0.2, 0.304009398, 0.000001, "exp(-0.32)"},
    {10, 1.0e-09, 0.5, 0.75, 0.000001, "p towards 0: 1 - (1 - u)^2"},
    {10, 1.0e-09, 0.2, 0.36, 0.000001, "p towards 0: 1 - (1 - u)^2"},
    {10, 1.0e-12, 0.9, 0.99, 0.000001, "p towards 0: 1 - (1 - u)^2"},
    {11, 0.3, 0.5, 0.812252396, 0.000001, "0.5^0.3"},
    {11, 0.3, 1.0, 1.0, 0.000001, "1"},
    {11, 0.3, 0.0, 0.0, 0.000001, "0"},
    {11, 1.0, 0.37, 0.37, 0.000001, "itself"},
    {11, 2.0, 0.5, 0.25, 0.000001, "0.25"},
    {11, 0.5, 0.81, 0.9, 0.000001, "0.9"},
    {11, 3.0, 0.2, 0.008, 0.000001, "0.008"},
};
enum { SMART_PROBE_PROFILE_COUNT = 19 };

static const smart_probe_adaptive smart_probe_adaptives[] = {
    {1, 0.3, 0.3, "one layer: s"},
    {2, 0.51, 0.3, "1 - 0.49^(1/2)"},
    {3, 0.657, 0.3, "1 - 0.343^(1/3)"},
    {4, 0.7599, 0.3, "1 - 0.2401^(1/4)"},
    {2, 0.75, 0.5, "0.5 + 0.25 = 0.75"},
    {3, 0.875, 0.5, "0.5 + 0.25 + 0.125"},
    {2, 0.3, 0.163339973, "1 - 0.7^(1/2)"},
    {5, 0.0, 0.0, "nothing"},
    {5, 1.0, 1.0, "opaque"},
    {64, 0.5, 0.010771987, "1 - 0.5^(1/64)"},
    {8, 0.99, 0.437658675, "1 - 0.01^(1/8)"},
};
enum { SMART_PROBE_ADAPTIVE_COUNT = 11 };

static const smart_probe_composite smart_probe_composites[] = {
    {1, {0.3}, {0.0}, {0.0}, {0.3}, {0.3}, 0.7, {0.3}, 0.7, "alpha alone"},
    {1, {0.3}, {1.0}, {0.0}, {1.0}, {1.0}, 0.0, {1.0}, 0.7, "silhouette: opaque"},
    {1, {0.3}, {0.0}, {1.0}, {0.0}, {0.0}, 1.0, {0.0}, 0.7, "halo: not seen"},
    {1, {0.3}, {1.0}, {1.0}, {0.0}, {0.0}, 1.0, {0.0}, 0.7, "halo wins over silhouette"},
    {1, {0.3}, {0.5}, {0.0}, {0.65}, {0.65}, 0.35, {0.65}, 0.7, "0.3 + 0.7 x 0.5 = 0.65"},
    {1, {0.3}, {0.5}, {0.5}, {0.325}, {0.325}, 0.675, {0.325}, 0.7, "half of 0.65"},
    {2, {0.2, 0.4}, {0.0, 0.0}, {0.0, 0.0}, {0.2, 0.4}, {0.2, 0.32}, 0.48, {0.2, 0.32}, 0.48, "plain over: 0.2, 0.32"},
    {2, {0.2, 0.4}, {0.5, 0.0}, {0.0, 0.5}, {0.6, 0.2}, {0.6, 0.08}, 0.32, {0.6, 0.16}, 0.48, "0.6; half of 0.4 seen through 0.4"},
    {3, {0.3, 0.3, 0.3}, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {1.0, 0.3, 0.3}, {1.0, 0.0, 0.0}, 0.0, {1.0, 0.21, 0.147}, 0.343, "the first hides the rest"},
    {3, {0.3, 0.3, 0.3}, {0.0, 1.0, 0.0}, {0.0, 0.0, 0.0}, {0.3, 1.0, 0.3}, {0.3, 0.7, 0.0}, 0.0, {0.3, 0.7, 0.147}, 0.343, "the second hides the third"},
    {3, {0.3, 0.3, 0.3}, {0.0, 0.4, 0.0}, {0.2, 0.0, 1.0}, {0.24, 0.58, 0.0}, {0.24, 0.4408, 0.0}, 0.3192, {0.24, 0.406, 0.0}, 0.343, "0.24, 0.58, 0"},
    {2, {0.0, 1.0}, {0.0, 0.0}, {0.0, 0.25}, {0.0, 0.75}, {0.0, 0.75}, 0.25, {0.0, 0.75}, 0.0, "0, then 0.75"},
    {4, {0.1, 0.1, 0.1, 0.1}, {0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0}, {0.1, 0.1, 0.1, 0.1}, {0.1, 0.09, 0.081, 0.0729}, 0.6561, {0.1, 0.09, 0.081, 0.0729}, 0.6561, "0.9^4 to the background"},
    {4, {0.5, 0.5, 0.5, 0.5}, {0.2, 0.2, 0.2, 0.2}, {0.1, 0.1, 0.1, 0.1}, {0.54, 0.54, 0.54, 0.54}, {0.54, 0.2484, 0.114264, 0.05256144}, 0.04477456, {0.54, 0.27, 0.135, 0.0675}, 0.0625, "0.9 x 0.6 = 0.54 each"},
};
enum { SMART_PROBE_COMPOSITE_COUNT = 14 };

static const smart_probe_curvature smart_probe_curvatures[] = {
    {{{0.0, 0.0, 1.0}, {-0.1, 0.0, 0.994987437}, {0.1, 0.0, 0.994987437}, {0.0, -0.1, 0.994987437}, {0.0, 0.1, 0.994987437}}, 0, 1.0, -0.19737532, 0.003, 0, "sphere of 10 pixels, middle: -tanh(2/10)"},
    {{{0.6, 0.0, 0.8}, {0.5, 0.0, 0.866025404}, {0.7, 0.0, 0.714142843}, {0.6, -0.1, 0.793725393}, {0.6, 0.1, 0.793725393}}, 0, 1.0, -0.19737532, 0.003, 1, "the same sphere, 6 from the middle: still 2/R"},
    {{{0.3, -0.4, 0.866025404}, {0.2, -0.4, 0.894427191}, {0.4, -0.4, 0.824621125}, {0.3, -0.5, 0.81240384}, {0.3, -0.3, 0.905538514}}, 0, 1.0, -0.19737532, 0.003, 1, "the same sphere, 5 from the middle"},
    {{{0.0, 0.0, 1.0}, {-0.01, 0.0, 0.999949999}, {0.01, 0.0, 0.999949999}, {0.0, -0.01, 0.999949999}, {0.0, 0.01, 0.999949999}}, 0, 1.0, -0.019997334, 0.001, 0, "sphere of 100 pixels"},
    {{{0.0, 0.0, 1.0}, {-0.25, 0.0, 0.968245837}, {0.25, 0.0, 0.968245837}, {0.0, -0.25, 0.968245837}, {0.0, 0.25, 0.968245837}}, 0, 1.0, -0.462117157, 0.02, 0, "sphere of 4 pixels"},
    {{{0.0, 0.0, 1.0}, {0.1, 0.0, 0.994987437}, {-0.1, 0.0, 0.994987437}, {0.0, 0.1, 0.994987437}, {0.0, -0.1, 0.994987437}}, 0, 1.0, 0.19737532, 0.003, 0, "hollow sphere from inside: concave, +"},
    {{{0.0, 0.0, 1.0}, {-0.1, 0.0, 0.994987437}, {0.1, 0.0, 0.994987437}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}, 0, 1.0, -0.099667995, 0.003, 0, "cylinder of 10 pixels: -tanh(1/10)"},
    {{{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, {0.0, -0.1, 0.994987437}, {0.0, 0.1, 0.994987437}}, 0, 1.0, -0.099667995, 0.003, 0, "lying cylinder"},
    {{{0.0, 0.0, 1.0}, {0.1, 0.0, 0.994987437}, {-0.1, 0.0, 0.994987437}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}, 0, 1.0, 0.099667995, 0.003, 0, "gutter: +"},
    {{{0.0, 0.0, 1.0}, {-0.1, 0.0, 0.994987437}, {0.1, 0.0, 0.994987437}, {0.0, 0.1, 0.994987437}, {0.0, -0.1, 0.994987437}}, 0, 1.0, 0.0, 0.001, 0, "saddle: the two cancel"},
    {{{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}, 0, 1.0, 0.0, 0.000001, 0, "facing plane"},
    {{{0.6, 0.0, 0.8}, {0.6, 0.0, 0.8}, {0.6, 0.0, 0.8}, {0.6, 0.0, 0.8}, {0.6, 0.0, 0.8}}, 0, 1.0, 0.0, 0.000001, 0, "tilted plane"},
    {{{0.0, 0.0, 1.0}, {-0.1, 0.0, 0.994987437}, {0.1, 0.0, 0.994987437}, {0.0, -0.1, 0.994987437}, {0.0, 0.1, 0.994987437}}, 0, 0.05, -0.9993293, 0.003, 0, "per world unit, pixel 0.05: radius 0.5"},
    {{{0.0, 0.0, 1.0}, {-0.1, 0.0, 0.994987437}, {0.1, 0.0, 0.994987437}, {0.0, -0.1, 0.994987437}, {0.0, 0.1, 0.994987437}}, 0, 0.5, -0.379948962, 0.005, 0, "per world unit, pixel 0.5: radius 5"},
    {{{0.0, 0.0, 1.0}, {-0.1, 0.0, 0.994987437}, {0.1, 0.0, 0.994987437}, {0.0, -0.1, 0.994987437}, {0.0, 0.1, 0.994987437}}, 0, 10.0, -0.019997334, 0.001, 0, "per world unit, pixel 10: radius 100"},
    {{{0.0, 0.0, 1.0}, {-0.05, 0.0, 0.998749218}, {0.05, 0.0, 0.998749218}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}, 0, 0.1, -0.462117157, 0.005, 0, "per world unit, cylinder of radius 2"},
    {{{0.0, 0.0, 1.0}, {-0.6, 0.0, 0.8}, {0.6, 0.0, 0.8}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}, 0, 1.0, -0.537049567, 0.000001, 1, "ridge: (0.6 + 0.6)/2; by slopes instead of normals it would be 0.75"},
    {{{0.0, 0.0, 1.0}, {0.6, 0.0, 0.8}, {-0.6, 0.0, 0.8}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}}, 0, 1.0, 0.537049567, 0.000001, 1, "groove"},
    {{{0.0, 0.0, 1.0}, {-0.1, 0.0, 0.994987437}, {0.1, 0.0, 0.994987437}, {0.0, -0.1, 0.994987437}, {0.0, 0.1, 0.994987437}}, 1, 1.0, -1.0, 0.000001, 0, "no left neighbour: -1"},
    {{{0.0, 0.0, 1.0}, {-0.1, 0.0, 0.994987437}, {0.1, 0.0, 0.994987437}, {0.0, -0.1, 0.994987437}, {0.0, 0.1, 0.994987437}}, 2, 1.0, -1.0, 0.000001, 0, "no right neighbour: -1"},
    {{{0.0, 0.0, 1.0}, {-0.1, 0.0, 0.994987437}, {0.1, 0.0, 0.994987437}, {0.0, -0.1, 0.994987437}, {0.0, 0.1, 0.994987437}}, 4, 1.0, -1.0, 0.000001, 0, "no lower neighbour: -1"},
    {{{0.0, 0.0, 1.0}, {-0.1, 0.0, 0.994987437}, {0.1, 0.0, 0.994987437}, {0.0, -0.1, 0.994987437}, {0.0, 0.1, 0.994987437}}, 8, 1.0, -1.0, 0.000001, 0, "no upper neighbour: -1"},
    {{{0.0, 0.0, 1.0}, {0.1, 0.0, 0.994987437}, {-0.1, 0.0, 0.994987437}, {0.0, 0.1, 0.994987437}, {0.0, -0.1, 0.994987437}}, 15, 1.0, -1.0, 0.000001, 0, "no neighbour at all: -1, concave or not"},
};
enum { SMART_PROBE_CURVATURE_COUNT = 23 };

static const smart_probe_bucket smart_probe_buckets[] = {
    {4, 4, {5, 1, 3, 9}, {2, 7, 2, 7}, 4, {1, 2, 0, 3}, {2, 0, 1, 3}, {{-1, -1, -1}, {-1, -1, -1}, {2, 0, 1}, {7, 2, 3}}, "7 mod 4 = 3, 2 mod 4 = 2; each part two fragments"},
    {4, 3, {4, 2, 3}, {6, 2, 6}, 3, {1, 2, 0}, {1, 2, 0}, {{-1, -1, -1}, {-1, -1, -1}, {2, 0, 0}, {6, 1, 2}}, "2 and 6 both ask for slot 2: 2 comes first, 6 moves to 3"},
    {4, 3, {1, 2, 3}, {3, 7, 11}, 3, {0, 1, 2}, {0, 1, 2}, {{7, 1, 1}, {11, 2, 2}, {-1, -1, -1}, {3, 0, 0}}, "3, 7 and 11 ask for slot 3: 7 wraps to 0, 11 to 1"},
    {4, 6, {8, 6, 7, 1, 2, 3}, {1, 1, 2, 3, 3, 1}, 4, {3, 4, 5, 1}, {5, 1, 3, 4}, {{-1, -1, -1}, {1, 0, 1}, {-1, -1, -1}, {3, 2, 3}}, "the two farthest, both at 7 and 8, are dropped: part 2 has no bucket"},
    {8, 5, {5, 4, 3, 2, 1}, {0, 8, 16, 1, 9}, 5, {4, 3, 2, 1, 0}, {0, 3, 1, 4, 2}, {{0, 0, 0}, {1, 1, 1}, {8, 2, 2}, {9, 3, 3}, {16, 4, 4}, {-1, -1, -1}, {-1, -1, -1}, {-1, -1, -1}}, "0, 8, 16 ask for slot 0, 1 and 9 for slot 1; in order of part: 0 to 0, 1 to 1, 8 to 2, 9 to 3, 16 to 4"},
    {8, 1, {3}, {5}, 1, {0}, {0}, {{-1, -1, -1}, {-1, -1, -1}, {-1, -1, -1}, {-1, -1, -1}, {-1, -1, -1}, {5, 0, 0}, {-1, -1, -1}, {-1, -1, -1}}, "one fragment"},
    {4, 0, {0}, {0}, 0, {0}, {0}, {{-1, -1, -1}, {-1, -1, -1}, {-1, -1, -1}, {-1, -1, -1}}, "none"},
    {2, 3, {1, 2, 3}, {4, 4, 4}, 2, {0, 1}, {0, 1}, {{4, 0, 1}, {-1, -1, -1}}, "one part, the two nearest"},
    {4, 4, {40, 10, 30, 20}, {12, 12, 12, 12}, 4, {1, 3, 2, 0}, {1, 3, 2, 0}, {{12, 0, 3}, {-1, -1, -1}, {-1, -1, -1}, {-1, -1, -1}}, "one bucket of four, by depth"},
};
enum { SMART_PROBE_BUCKET_COUNT = 9 };

/* clang-format on */

#endif

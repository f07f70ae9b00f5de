/* reference_smart.h: the ground truth of smart transparency and curvature, in double, on lists of fragments. Slow and
 * plain; shares no code with the headers it judges.
 *
 * Sources: Carnecky et al. 2013, "Smart transparency for illustrative visualization of complex flow surfaces", sections
 * 4.4 and 5 (C13 below); Murray et al. 2016, "Bucketed k-buffer", section 5 (M16); the design, which wins over both.
 *
 * How ambiguous sentences are read here:
 *  - Links join surface fragments of one part in pixels side by side. "Both fragments think of each other as the best
 *    candidates" (C13 4.4, figure 7b): each predicts the other's depth from its own slope, and each has to be the other's
 *    best. Algorithm 2 of the paper judges both ways by the measure of one side; that is `published`, and its links need
 *    not be mutual. Of candidates that measure the same the one nearer to the eye is taken.
 *  - Equation 1 predicts a depth that is linear in the window: that is exact for planes in window depth, also under
 *    perspective. Predicted and found depth are compared as distances along the view, in units of the radius.
 *  - The continuity limit is one of depth (or of parameters): a pair farther apart than that is no candidate at all.
 *    Except for what lies between the predictions of both slopes: see ref_smart_is_continuous.
 *  - A direction that leaves the image has no link, and nothing is missing there: the frame of a picture is no silhouette.
 *  - Layer indices count surface fragments. A neighbour's index is greater for one of three reasons: a surface begins
 *    between the two pixels, one ends, or two that are linked swap order. The last is left out of the difference.
 *  - The four rules of C13 5.3 in the design's order: fewer links than there are neighbouring pixels (red) wins over
 *    underneath (green); gamma (blue) is set by itself. A fragment whose index rises toward one neighbour and falls toward
 *    another is both blue and green.
 *  - b masks beta and gamma in equations 8 and 9: boundary fragments keep their value. Alpha is masked nowhere.
 *  - Equation 8 with Laplacian 1/8 of the sum of differences over the links that are there; `published` is 1/4 of it, and
 *    bare_sum 1, which is the plain five-point sum.
 *  - Only surface fragments have fields. Lines and fragments that add or multiply are composed as they are.
 *  - Curvature is per pixel or per unit of the world. The trace of the shape operator that turns steps along the surface
 *    into differences of the unit normal is kappa1 + kappa2 up to its sign: it needs no division by the normal's z, so
 *    that grazing normals are bounded. Per pixel the steps are those in the window. One-sided differences are not taken:
 *    a missing neighbour gives -1 (M16 5.1), the frame of the picture as well. */
#ifndef GLASSINE_TESTS_REFERENCE_SMART_H
#define GLASSINE_TESTS_REFERENCE_SMART_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define REF_SMART_NEVER ((double)INFINITY)

enum { REF_SMART_SURFACE, REF_SMART_LINE, REF_SMART_ADD, REF_SMART_MULTIPLY };
enum { REF_SMART_LEFT, REF_SMART_RIGHT, REF_SMART_DOWN, REF_SMART_UP }; /* to x - 1, x + 1, y - 1, y + 1 */

typedef struct ref_smart_fragment {
    double depth, slope[2]; /* window depth, and what it gains a pixel to the right and a pixel up */
    double normal[3];       /* unit, in the space of the eye: z toward it */
    double uv[2];
    double color[3], alpha; /* as the host gave it */
    uint32_t part;
    int kind;
    /* Found by the functions below. */
    int link[4];                /* which of the neighbouring pixel's fragments, -1: none */
    bool no_neighbour[4];       /* the image ends there */
    double base, beta, gamma;   /* the fields; base is the paper's alpha */
    bool keep_beta, keep_gamma; /* the paper's b = 0 */
    double opacity;             /* the paper's alpha with a hat */
    double kappa;
    double radial, contour; /* curvature toward the eye, convex positive; how much a contour covers */
} ref_smart_fragment;

typedef struct ref_smart_image {
    int width, height;
    size_t *start; /* width * height + 1: pixel y * width + x, y from the bottom, has [start[p], start[p + 1]) */
    ref_smart_fragment *fragments; /* sorted from the eye on, pixel by pixel */
} ref_smart_image;

typedef enum { REF_SMART_BY_DEPTH, REF_SMART_BY_UV, REF_SMART_PUBLISHED, REF_SMART_MURRAY } ref_smart_criterion;

typedef struct ref_smart_links {
    ref_smart_criterion criterion;
    double depth_weight, normal_weight; /* the paper's w_z and w_n */
    double radius;                      /* of the bounding sphere, world units */
    double limit;                       /* of depth in radii, or of uv; not used by published and Murray */
    double projection[16];              /* column-major */
    bool no_reverse_check;              /* Murray figure 5 (a) */
} ref_smart_links;

static inline size_t ref_smart_count(const ref_smart_image *image, int x, int y) {
    size_t p = (size_t)y * (size_t)image->width + (size_t)x;
    return image->start[p + 1] - image->start[p];
}

static inline ref_smart_fragment *ref_smart_at(const ref_smart_image *image, int x, int y, size_t i) {
    return &image->fragments[image->start[(size_t)y * (size_t)image->width + (size_t)x] + i];
}

/* The pixel next to x, y; false where the image ends. */
static inline bool ref_smart_next(const ref_smart_image *image, int *x, int *y, int direction) {
    static const int step[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    *x += step[direction][0];
    *y += step[direction][1];
    return *x >= 0 && *y >= 0 && *x < image->width && *y < image->height;
}

/* The fragment linked to in that direction, or NULL. */
static inline ref_smart_fragment *ref_smart_linked(const ref_smart_image *image, int x, int y,
                                                   const ref_smart_fragment *f, int direction) {
    if (f->link[direction] < 0 || !ref_smart_next(image, &x, &y, direction))
        return NULL;
    return ref_smart_at(image, x, y, (size_t)f->link[direction]);
}

/* ---- links (C13 4.4, M16 5.1) ---- */

/* Distance along the view of a window depth. Clip z and w are p[10] z + p[14] and p[11] z + p[15] of the eye's z. */
static inline double ref_smart_distance(const double p[16], double depth) {
    double ndc = 2 * depth - 1;
    return -(p[14] - ndc * p[15]) / (ndc * p[11] - p[10]);
}

static inline double ref_smart_dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double ref_smart_ahead(const ref_smart_fragment *f, int direction) {
    return f->slope[direction / 2] * (direction % 2 ? 1 : -1);
}

/* Distance in radii between what a fragment predicts for the pixel in that direction, and what was found there. */
static inline double ref_smart_error(const ref_smart_links *links, const ref_smart_fragment *f,
                                     const ref_smart_fragment *found, int direction) {
    return fabs(ref_smart_distance(links->projection, f->depth + ref_smart_ahead(f, direction)) -
                ref_smart_distance(links->projection, found->depth)) /
           links->radius;
}

/* Within the limit of what i predicts. Or, by the mean value theorem, where a surface may be whose slope goes steadily
 * from that of i to that of j: its depth rises by no less than the one says and by no more than the other. */
static inline bool ref_smart_is_continuous(const ref_smart_links *links, const ref_smart_fragment *i,
                                           const ref_smart_fragment *j, int direction) {
    double rise = j->depth - i->depth, own = ref_smart_ahead(i, direction), other = ref_smart_ahead(j, direction);
    return ref_smart_error(links, i, j, direction) <= links->limit ||
           (fmin(own, other) <= rise && rise <= fmax(own, other));
}

/* Equations 1 to 3, or what stands in for them; infinite for what cannot be joined. */
static inline double ref_smart_measure(const ref_smart_links *links, const ref_smart_fragment *i,
                                       const ref_smart_fragment *j, int direction) {
    if (i->kind != REF_SMART_SURFACE || j->kind != REF_SMART_SURFACE || i->part != j->part)
        return REF_SMART_NEVER;
    double bend = 1 - ref_smart_dot(i->normal, j->normal);
    if (links->criterion == REF_SMART_BY_UV) {
        double apart = hypot(i->uv[0] - j->uv[0], i->uv[1] - j->uv[1]);
        return apart <= links->limit ? apart : REF_SMART_NEVER;
    }
    if (links->criterion == REF_SMART_MURRAY)
        return bend + (i->depth - j->depth) * (i->depth - j->depth);
    if (links->criterion == REF_SMART_BY_DEPTH && !ref_smart_is_continuous(links, i, j, direction))
        return REF_SMART_NEVER;
    return links->depth_weight * ref_smart_error(links, i, j, direction) + links->normal_weight * bend;
}

/* The one of the `count` from `list` on that i likes best; -1: none. */
static inline int ref_smart_best(const ref_smart_links *links, const ref_smart_fragment *i,
                                 const ref_smart_fragment *list, size_t count, int direction) {
    int best = -1;
    double least = REF_SMART_NEVER;
    for (size_t j = 0; j < count; j++) {
        double measure = ref_smart_measure(links, i, &list[j], direction);
        if (measure < least) {
            least = measure;
            best = (int)j;
        }
    }
    return best;
}

/* Whether the candidate j, too, wants i and none of i's own list. */
static inline bool ref_smart_is_mutual(const ref_smart_links *links, const ref_smart_fragment *own, size_t own_count,
                                       size_t i, const ref_smart_fragment *j, int direction) {
    if (links->no_reverse_check)
        return true;
    if (links->criterion != REF_SMART_PUBLISHED)
        return ref_smart_best(links, j, own, own_count, direction ^ 1) == (int)i;
    for (size_t other = 0; other < own_count; other++) /* algorithm 2, lines 12 to 17 */
        if (ref_smart_measure(links, &own[other], j, direction) < ref_smart_measure(links, &own[i], j, direction))
            return false;
    return true;
}

static inline void ref_smart_link(ref_smart_image *image, const ref_smart_links *links) {
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            for (int direction = 0; direction < 4; direction++) {
                int to_x = x, to_y = y;
                bool inside = ref_smart_next(image, &to_x, &to_y, direction);
                size_t count = ref_smart_count(image, x, y);
                ref_smart_fragment *own = count ? ref_smart_at(image, x, y, 0) : NULL;
                for (size_t i = 0; i < count; i++) {
                    own[i].no_neighbour[direction] = !inside;
                    own[i].link[direction] = -1;
                    if (!inside || ref_smart_count(image, to_x, to_y) == 0)
                        continue;
                    const ref_smart_fragment *list = ref_smart_at(image, to_x, to_y, 0);
                    int best = ref_smart_best(links, &own[i], list, ref_smart_count(image, to_x, to_y), direction);
                    if (best >= 0 && ref_smart_is_mutual(links, own, count, i, &list[best], direction))
                        own[i].link[direction] = best;
                }
            }
}

/* ---- initial and boundary conditions (C13 5.2, 5.3) ---- */

static inline double ref_smart_adaptive(double s, size_t layers) {
    return 1 - pow(1 - s, 1 / (double)layers); /* equation 5; the paper's s is the opacity of the whole pixel */
}

static inline size_t ref_smart_layers(const ref_smart_image *image, int x, int y) {
    size_t surfaces = 0;
    for (size_t i = 0; i < ref_smart_count(image, x, y); i++)
        surfaces += ref_smart_at(image, x, y, i)->kind == REF_SMART_SURFACE;
    return surfaces;
}

/* How many of the `count` from list on are surfaces that have no link that way. */
static inline int ref_smart_ends(const ref_smart_fragment *list, int count, int direction) {
    int ends = 0;
    for (int i = 0; i < count; i++)
        ends += list[i].kind == REF_SMART_SURFACE && list[i].link[direction] < 0;
    return ends;
}

/* How much greater the index of the fragment is to which fragment i is linked, swaps left out: surfaces before that one
 * that begin on the way there, less surfaces before this one that end on it. */
static inline int ref_smart_rise(const ref_smart_image *image, int x, int y, int i, int direction) {
    const ref_smart_fragment *own = ref_smart_at(image, x, y, 0);
    int to = own[i].link[direction], to_x = x, to_y = y;
    if (to < 0 || !ref_smart_next(image, &to_x, &to_y, direction))
        return 0;
    return ref_smart_ends(ref_smart_at(image, to_x, to_y, 0), to, direction ^ 1) - ref_smart_ends(own, i, direction);
}

static inline void ref_smart_bound_one(const ref_smart_image *image, int x, int y, int i) {
    ref_smart_fragment *f = ref_smart_at(image, x, y, (size_t)i);
    bool missing = false, rises = false, falls = false;
    for (int d = 0; d < 4; d++) {
        int rise = ref_smart_rise(image, x, y, i, d);
        missing = missing || (f->link[d] < 0 && !f->no_neighbour[d]);
        rises = rises || rise > 0;
        falls = falls || rise < 0;
    }
    f->beta = missing ? 1 : 0;
    f->keep_beta = missing || falls;
    f->gamma = rises ? 1 : 0;
    f->keep_gamma = rises;
}

/* Initial values and boundaries of all fields: base = alpha of the host, or of equation 5 with s = adaptive where that is
 * not below 0. */
static inline void ref_smart_begin(ref_smart_image *image, double adaptive) {
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++) {
            size_t layers = ref_smart_layers(image, x, y);
            for (size_t i = 0; i < ref_smart_count(image, x, y); i++) {
                ref_smart_fragment *f = ref_smart_at(image, x, y, i);
                f->base = f->alpha;
                f->beta = f->gamma = 0;
                f->keep_beta = f->keep_gamma = false;
                if (f->kind != REF_SMART_SURFACE)
                    continue;
                if (adaptive >= 0)
                    f->base = ref_smart_adaptive(adaptive, layers);
                ref_smart_bound_one(image, x, y, (int)i);
            }
        }
}

/* The same as published: plain indices of layers, and nothing is kept at 0 for equation 9, which has no b; with `masked`,
 * equation 8, it is. */
static inline void ref_smart_bound_published(ref_smart_image *image, bool masked) {
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            for (size_t i = 0; i < ref_smart_count(image, x, y); i++) {
                ref_smart_fragment *f = ref_smart_at(image, x, y, i);
                bool rises = false, falls = false;
                for (int d = 0; d < 4 && f->kind == REF_SMART_SURFACE; d++) {
                    int to_x = x, to_y = y, rise = 0;
                    if (f->link[d] < 0 || !ref_smart_next(image, &to_x, &to_y, d))
                        continue;
                    for (int k = 0; k < f->link[d]; k++)
                        rise += ref_smart_at(image, to_x, to_y, (size_t)k)->kind == REF_SMART_SURFACE;
                    for (size_t k = 0; k < i; k++)
                        rise -= ref_smart_at(image, x, y, k)->kind == REF_SMART_SURFACE;
                    rises = rises || rise > 0;
                    falls = falls || rise < 0;
                }
                f->keep_beta = f->beta > 0 || (falls && masked);
                f->gamma = rises ? 1 : 0;
                f->keep_gamma = rises;
            }
}

/* ---- diffusion (C13 5.4) ---- */

enum { REF_SMART_BASE, REF_SMART_BETA, REF_SMART_GAMMA };
typedef enum { REF_SMART_EIGHTH, REF_SMART_MEAN_OF_FOUR, REF_SMART_BARE_SUM } ref_smart_laplacian;

static inline double *ref_smart_field(ref_smart_fragment *f, int field) {
    return field == REF_SMART_BASE ? &f->base : field == REF_SMART_BETA ? &f->beta : &f->gamma;
}

static inline bool ref_smart_keeps(const ref_smart_fragment *f, int field) {
    return (field == REF_SMART_BETA && f->keep_beta) || (field == REF_SMART_GAMMA && f->keep_gamma);
}

/* One step for one fragment: equation 8, or with `greatest` equation 9. */
static inline double ref_smart_step_one(const ref_smart_image *image, int x, int y, ref_smart_fragment *f, int field,
                                        bool greatest, double lambda, ref_smart_laplacian laplacian) {
    double value = *ref_smart_field(f, field), sum = 0, most = -REF_SMART_NEVER;
    for (int d = 0; d < 4; d++) {
        ref_smart_fragment *other = ref_smart_linked(image, x, y, f, d);
        if (!other)
            continue;
        sum += *ref_smart_field(other, field) - value;
        most = fmax(most, *ref_smart_field(other, field));
    }
    if (greatest)
        return fmax(value, most - lambda);
    return value + lambda * sum / (laplacian == REF_SMART_EIGHTH ? 8 : laplacian == REF_SMART_MEAN_OF_FOUR ? 4 : 1);
}

/* `steps` steps of one field, each from the values of the one before. False: out of memory. */
static inline bool ref_smart_spread(ref_smart_image *image, int field, bool greatest, double lambda,
                                    ref_smart_laplacian laplacian, size_t steps) {
    size_t count = image->start[(size_t)image->width * (size_t)image->height];
    double *after = malloc((count ? count : 1) * sizeof *after);
    for (size_t step = 0; after && step < steps; step++) {
        for (int y = 0; y < image->height; y++)
            for (int x = 0; x < image->width; x++)
                for (size_t i = 0; i < ref_smart_count(image, x, y); i++) {
                    ref_smart_fragment *f = ref_smart_at(image, x, y, i);
                    bool stays = f->kind != REF_SMART_SURFACE || ref_smart_keeps(f, field);
                    after[f - image->fragments] =
                        stays ? *ref_smart_field(f, field)
                              : ref_smart_step_one(image, x, y, f, field, greatest, lambda, laplacian);
                }
        for (size_t i = 0; i < count; i++)
            *ref_smart_field(&image->fragments[i], field) = after[i];
    }
    free(after);
    return after != NULL;
}

/* Equation 10: 0 to 0 and 1 to 1 for every p > 0; for p = 0 the limit. */
static inline double ref_smart_profile_10(double u, double p) {
    if (!(p > 0))
        return 1 - (1 - u) * (1 - u);
    return exp(-p) * expm1(p * u * (2 - u)) / -expm1(-p); /* 1 - (1 - u)^2 = u (2 - u): nothing cancels */
}

static inline double ref_smart_profile_11(double u, double p) {
    return pow(u, p);
}

/* ---- compositing (C13 5.5, algorithm 3) ---- */

/* Into color, over what it holds as the background; weights (may be NULL; red's, where something multiplies) get the share
 * of each fragment, and the last that of the background. Light that is added hides nothing. printed: line 6 as it stands,
 * whose alpha has no hat. */
static inline void ref_smart_compose_as(const ref_smart_image *image, int x, int y, bool printed, double color[3],
                                        double *weights) {
    double sum[3] = {0, 0, 0}, through[3] = {1, 1, 1};
    size_t count = ref_smart_count(image, x, y);
    for (size_t i = 0; i < count; i++) {
        ref_smart_fragment *f = ref_smart_at(image, x, y, i);
        bool surface = f->kind == REF_SMART_SURFACE, filter = f->kind == REF_SMART_MULTIPLY;
        f->opacity = surface ? (1 - f->gamma) * (f->base + (1 - f->base) * f->beta) : f->alpha;
        double hides = f->kind == REF_SMART_ADD ? 0 : surface && printed ? f->base : f->opacity;
        if (weights)
            weights[i] = filter ? 0 : through[0] * f->opacity;
        for (size_t c = 0; c < 3; c++) {
            sum[c] += filter ? 0 : through[c] * f->opacity * f->color[c];
            through[c] *= filter ? 1 - hides + hides * f->color[c] : 1 - hides;
        }
    }
    for (size_t c = 0; c < 3; c++)
        color[c] = sum[c] + through[c] * color[c];
    if (weights)
        weights[count] = through[0];
}

static inline void ref_smart_compose(const ref_smart_image *image, int x, int y, double color[3], double *weights) {
    ref_smart_compose_as(image, x, y, false, color, weights);
}

/* ---- curvature (M16 5.1) ---- */

typedef struct ref_smart_view {
    double projection[16]; /* column-major */
    double unit;           /* 0: per pixel; else the length of the world whose reciprocal is a curvature of 1 */
} ref_smart_view;

/* Where a fragment is in the space of the eye. */
static inline void ref_smart_place(const ref_smart_image *image, const double p[16], double x, double y, double depth,
                                   double out[3]) {
    double z = -ref_smart_distance(p, depth), w = p[11] * z + p[15];
    double ndc[2] = {2 * (x + 0.5) / image->width - 1, 2 * (y + 0.5) / image->height - 1};
    out[0] = (ndc[0] * w - p[8] * z - p[12]) / p[0];
    out[1] = (ndc[1] * w - p[9] * z - p[13]) / p[5];
    out[2] = z;
}

/* kappa1 + kappa2: minus the trace of the map from steps t to differences of normals dn, both along two directions. */
static inline double ref_smart_trace(double t[2][3], double dn[2][3]) {
    double a = ref_smart_dot(t[0], t[0]), b = ref_smart_dot(t[0], t[1]), c = ref_smart_dot(t[1], t[1]);
    double square = a * c - b * b;
    if (!(square > 1e-12 * a * c))
        return 0;
    return -(c * ref_smart_dot(dn[0], t[0]) - b * (ref_smart_dot(dn[0], t[1]) + ref_smart_dot(dn[1], t[0])) +
             a * ref_smart_dot(dn[1], t[1])) /
           square;
}

static inline double ref_smart_kappa(const ref_smart_image *image, int x, int y, const ref_smart_fragment *f,
                                     const ref_smart_view *view) {
    double t[2][3] = {{2, 0, 0}, {0, 2, 0}}, dn[2][3], ends[2][3];
    for (int axis = 0; axis < 2; axis++) {
        const ref_smart_fragment *side[2] = {ref_smart_linked(image, x, y, f, 2 * axis),
                                             ref_smart_linked(image, x, y, f, 2 * axis + 1)};
        if (!side[0] || !side[1])
            return -1;
        for (int s = 0; s < 2; s++)
            ref_smart_place(image, view->projection, x + (axis == 0 ? 2 * s - 1 : 0), y + (axis == 1 ? 2 * s - 1 : 0),
                            side[s]->depth, ends[s]);
        for (size_t k = 0; k < 3; k++) {
            dn[axis][k] = side[1]->normal[k] - side[0]->normal[k];
            if (view->unit > 0)
                t[axis][k] = (ends[1][k] - ends[0][k]) / view->unit;
        }
    }
    return tanh(ref_smart_trace(t, dn));
}

static inline void ref_smart_curve(ref_smart_image *image, const ref_smart_view *view) {
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            for (size_t i = 0; i < ref_smart_count(image, x, y); i++) {
                ref_smart_fragment *f = ref_smart_at(image, x, y, i);
                f->kappa = f->kind == REF_SMART_SURFACE ? ref_smart_kappa(image, x, y, f, view) : 0;
            }
}

/* ---- suggestive contours (DeCarlo et al. 2003, section 2) ----
 *
 * Where the radial curvature (in the direction w of the eye, laid into the tangent plane) is 0 and rises along w, as seen
 * from the side that faces the eye. How the sentence is read on fragments:
 *  - Differences are across two pixels each way along the surface, or as far as links lead. The gradient of a quantity
 *    that changes by d0 and d1 between the ends of two crossing lines is what gives those changes: the vector g of the
 *    plane that they span with g.t0 = d0 and g.t1 = d1.
 *  - A line is as dark as it covers a pixel, its middle being |radial| / |change of it a pixel| away.
 *  - Curvature k is taken as k / (1 + |k| radius / 10), which is bounded beside silhouettes, before it is smoothed.
 *  - It fades in from `least` to twice that in the derivative along w, and from |w| of 1/4 to 1/2. */
typedef struct ref_smart_around {
    const ref_smart_fragment *ends[4];
    double across[2][3], pixels[2];
} ref_smart_around;

static inline bool ref_smart_look_around(const ref_smart_image *image, const double projection[16], int x, int y,
                                         const ref_smart_fragment *f, ref_smart_around *a) {
    double at[4][3];
    for (int d = 0; d < 4; d++) {
        int to_x = x, to_y = y;
        a->ends[d] = f;
        for (int k = 0; k < 2; k++) {
            const ref_smart_fragment *next = ref_smart_linked(image, to_x, to_y, a->ends[d], d);
            if (!next)
                break;
            a->ends[d] = next;
            ref_smart_next(image, &to_x, &to_y, d);
        }
        ref_smart_place(image, projection, to_x, to_y, a->ends[d]->depth, at[d]);
        double steps = abs(to_x - x) + abs(to_y - y);
        a->pixels[d / 2] = d % 2 ? a->pixels[d / 2] + steps : steps;
    }
    for (int axis = 0; axis < 2; axis++)
        for (size_t k = 0; k < 3; k++)
            a->across[axis][k] = at[2 * axis + 1][k] - at[2 * axis][k];
    return a->pixels[0] > 0 && a->pixels[1] > 0;
}

/* Toward the eye from the middle of a pixel; unit. The ray there is where clip x and y are ndc times clip w. */
static inline void ref_smart_to_eye(const ref_smart_image *image, const double p[16], int x, int y, double out[3]) {
    double ends[2][3], length = 0;
    for (int k = 0; k < 2; k++) { /* two places of the ray */
        double z = k ? -1 : -2, w = p[11] * z + p[15];
        ends[k][0] = ((2 * (x + 0.5) / image->width - 1) * w - p[8] * z - p[12]) / p[0];
        ends[k][1] = ((2 * (y + 0.5) / image->height - 1) * w - p[9] * z - p[13]) / p[5];
        ends[k][2] = z;
    }
    for (int k = 0; k < 3; k++) {
        out[k] = ends[1][k] - ends[0][k];
        length += out[k] * out[k];
    }
    for (int k = 0; k < 3; k++)
        out[k] /= sqrt(length);
}

/* w, and its product with the gradient of something that changes by d across the ends: by Cramer's rule. */
static inline bool ref_smart_slope_along(const ref_smart_around *a, const double w[3], const double d[2], double *out) {
    double xx = ref_smart_dot(a->across[0], a->across[0]), yy = ref_smart_dot(a->across[1], a->across[1]);
    double xy = ref_smart_dot(a->across[0], a->across[1]), square = xx * yy - xy * xy;
    double g[3];
    for (int k = 0; k < 3; k++)
        g[k] = ((d[0] * yy - d[1] * xy) * a->across[0][k] + (d[1] * xx - d[0] * xy) * a->across[1][k]) / square;
    *out = ref_smart_dot(g, w);
    return square > 1e-6 * xx * yy && ref_smart_dot(w, w) > 1e-6;
}

static inline void ref_smart_toward(const ref_smart_image *image, const double projection[16], int x, int y,
                                    const ref_smart_fragment *f, double w[3], double *facing) {
    ref_smart_to_eye(image, projection, x, y, w);
    *facing = ref_smart_dot(w, f->normal);
    for (int k = 0; k < 3; k++)
        w[k] -= *facing * f->normal[k];
}

static inline double ref_smart_radial(const ref_smart_image *image, const double projection[16], double radius, int x,
                                      int y, const ref_smart_fragment *f) {
    ref_smart_around a;
    double w[3], facing, bend = 0;
    if (f->kind != REF_SMART_SURFACE || !ref_smart_look_around(image, projection, x, y, f, &a))
        return 0;
    ref_smart_toward(image, projection, x, y, f, w, &facing);
    for (int k = 0; k < 3; k++) { /* of each coordinate of the normal */
        double d[2] = {a.ends[1]->normal[k] - a.ends[0]->normal[k], a.ends[3]->normal[k] - a.ends[2]->normal[k]}, along;
        if (!ref_smart_slope_along(&a, w, d, &along))
            return 0;
        bend += along * w[k];
    }
    bend /= ref_smart_dot(w, w);
    return (facing < 0 ? -1 : 1) * bend / (1 + fabs(bend) * radius / 10);
}

static inline double ref_smart_contour(const ref_smart_image *image, const double projection[16], int x, int y,
                                       const ref_smart_fragment *f, double width, double least) {
    ref_smart_around a;
    double w[3], facing, rise;
    if (f->kind != REF_SMART_SURFACE || !ref_smart_look_around(image, projection, x, y, f, &a))
        return 0;
    ref_smart_toward(image, projection, x, y, f, w, &facing);
    double d[2] = {a.ends[1]->radial - a.ends[0]->radial, a.ends[3]->radial - a.ends[2]->radial};
    double each = hypot(d[0] / a.pixels[0], d[1] / a.pixels[1]), steep = sqrt(ref_smart_dot(w, w));
    if (!ref_smart_slope_along(&a, w, d, &rise) || !(each > 0))
        return 0;
    double covered = fmin(fmax(0.5 * width + 0.5 - fabs(f->radial) / each, 0), 1);
    double strong = fmin(fmax(rise / steep / least - 1, 0), 1), aside = fmin(fmax(4 * steep - 1, 0), 1);
    return covered * strong * aside;
}

/* radius: of the links; width in pixels, least in radii to the power -2; iterations of equation 8 that smooth the
 * curvature. False: out of memory. */
static inline bool ref_smart_contours(ref_smart_image *image, const double projection[16], double radius, double width,
                                      double least, size_t iterations) {
    size_t count = image->start[(size_t)image->width * (size_t)image->height];
    double *kept = malloc((count ? count : 1) * sizeof *kept);
    if (!kept)
        return false;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            for (size_t i = 0; i < ref_smart_count(image, x, y); i++) {
                ref_smart_fragment *f = ref_smart_at(image, x, y, i);
                kept[f - image->fragments] = f->base;
                f->radial = ref_smart_radial(image, projection, radius, x, y, f);
                f->base = f->radial; /* is what equation 8 is masked nowhere for */
            }
    bool done = ref_smart_spread(image, REF_SMART_BASE, false, 1, REF_SMART_EIGHTH, iterations);
    for (size_t i = 0; i < count; i++) {
        image->fragments[i].radial = image->fragments[i].base;
        image->fragments[i].base = kept[i];
    }
    free(kept);
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            for (size_t i = 0; i < ref_smart_count(image, x, y); i++) {
                ref_smart_fragment *f = ref_smart_at(image, x, y, i);
                f->contour = ref_smart_contour(image, projection, x, y, f, width, least / (radius * radius));
            }
    return done;
}

#endif

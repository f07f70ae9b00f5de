/* reference.h: the ground truth in double precision. One ray a pixel centre, every hit with every triangle, the papers'
 * rules applied to the hits one sentence at a time. Slow and plain; shares no code with the headers it judges.
 *
 * Sources: Diepstraten, Weiskopf, Ertl 2002, "Transparency in Interactive Technical Illustrations", sections 4, 5, 6.1
 * (called D02 below); Gooch et al. 1998 and 1999 for the shading.
 *
 * How ambiguous sentences are read here:
 *  - Which side faces the eye is a matter of geometry: a face is a front face when its outward side, from which its
 *    vertices run counter-clockwise in object space (clockwise with front_face_cw), looks toward the eye. A mirrored
 *    model, view or projection therefore does not turn an object inside out. A model matrix that flattens (determinant
 *    0) has no outside; the winding seen in the window decides then.
 *  - two_sided belongs to the object and is honoured in both interiors: such an object has no back faces at all.
 *  - "Closer", "behind" and "in front" are strict. An opaque thing at the very depth of the limit is hidden; one at the
 *    very depth of the front face is not before it, so that the front face is blended over it. A back face at the very
 *    depth of the front face does not limit (default) and hides the front face (published).
 *  - "At the same depth" means that double arithmetic cannot tell the depths apart: every hit carries a bound of its
 *    rounding error, a few units in the last place of a double. Float positions one unit in the last place apart are
 *    apart unless the depth range squeezes the difference below that bound. Among opaque things at the same depth the
 *    lowest object id is taken as well, and within one object the triangle that comes first.
 *  - Several front faces of the front-most object between the front-most one and the limit neither limit nor show.
 *  - The background shows behind the front-most face with background_weight wherever no opaque thing lies before the
 *    limit, also where one lies beyond it.
 *  - layers(n): D02 6.2 with n in the place of one. The n closest front faces of whatever object are blended over what
 *    lies before the next one; faces at the same depth are one layer, of the lowest id; back faces play no part.
 *  - Groups ("Two transparent objects are only blended with each other if ... they are very close to each other and
 *    belong to the same semantic group", D02 3): a chain from the front-most face on. The next front face joins if it is
 *    of another object of the same group and less than group_distance behind the last one, measured along the view;
 *    else the chain ends. All of the chain is blended, and the chain's last stands where the front-most face stands in
 *    the rules of interiors. A coincident face of the same group is part of the surface; one of another group ends the
 *    chain of implicit interiors. Further faces of objects in the chain end an explicit chain, and are not there for an
 *    implicit one. Of faces that coincide behind the first those of the group count.
 *  - "Strengthen the shade where an opaque object enters a non-opaque object" (D02 3): the opaque colour is multiplied by
 *    1 - strength * max(0, 1 - d / reach), d the straight distance in the world to the nearest of the curves where that
 *    object's own surface crosses that of any transparent one, seen or not; alike on both sides of the curve.
 *  - A method per object: that of the front-most face's object decides for the pixel.
 *  - Clipping at the near and far plane is that of GL: a point on a plane is inside, nothing is capped.
 *  - A pixel centre exactly on an edge belongs to one of the triangles that share it: the one that also covers the
 *    centre moved by an infinitely small step to the right, and by a still smaller one upward.
 *  - Only `published` clamps its sum; the other two stay in range by themselves where alpha and w are in [0,1]. */
#ifndef GLASSINE_TESTS_REFERENCE_H
#define GLASSINE_TESTS_REFERENCE_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct ref_object {
    const float *positions;  /* x y z, object space */
    const uint32_t *indices; /* three a triangle */
    size_t triangle_count, vertex_count;
    double model[16];          /* column-major, object to world, affine */
    uint32_t id;               /* not 0, unique */
    bool transparent;          /* else opaque */
    bool two_sided;            /* front from both sides */
    double color[3];           /* diffuse colour when shaded, the colour itself when not */
    double alpha;              /* of a transparent object; not used where vertex_alpha is given */
    const float *vertex_alpha; /* NULL, or one a vertex, linear over the triangle in object space */
    const float *normals;      /* NULL: flat colour */
    bool cool_to_warm;         /* shade by normals */
    uint32_t group;            /* semantic group; 0: none */
    int method;                /* 0: the scene's; 1: implicit, 2: explicit interiors */
} ref_object;

#define REF_MAX_LAYERS 8
typedef enum {
    REF_INTERIOR_IMPLICIT,
    REF_INTERIOR_IMPLICIT_PUBLISHED,
    REF_INTERIOR_EXPLICIT,
    REF_INTERIOR_LAYERS
} ref_interior;
typedef enum { REF_BLEND_PUBLISHED, REF_BLEND_NORMALISED, REF_BLEND_OVER } ref_blending;

typedef struct ref_scene {
    const ref_object *objects;
    size_t object_count;
    double view[16], projection[16]; /* column-major; GL clip space, -1..1; nearer is smaller */
    int width, height;
    double background[3];
    double opaque_weight, background_weight;
    ref_interior interior;
    ref_blending blending;
    bool front_face_cw;
    double light_direction[3]; /* world, toward the light, any length */
    double cool[3], warm[3];
    double cool_mix, warm_mix; /* how much of the object's colour goes into the cool and the warm end */
    int layers;                /* REF_INTERIOR_LAYERS: how many; else the longest chain of a group, 0: REF_MAX_LAYERS */
    double group_distance;     /* between two of a group along the view, world units; 0: any */
    double enter_strength, enter_reach; /* Hodges' first rule; reach in world units, 0: off */
    bool use_blend_color;               /* in place of the background behind glass */
    bool srgb;                          /* blend light, not display values */
    double blend_color[3];
} ref_scene;

/* Depths are window depths in [0,1], REF_NONE where there is no such surface. front_object is the object whose face is
 * blended into the pixel, opaque_object the one whose colour is seen alone or behind it; 0 is none. */
#define REF_NONE ((double)INFINITY)
typedef struct ref_pixel {
    double color[3];
    bool left_out; /* too near to an edge or an intersection for a comparison */
    uint32_t front_object, opaque_object;
    int layer_count; /* transparent surfaces blended; front to back: */
    uint32_t layer_objects[REF_MAX_LAYERS];
    double front_depth, opaque_depth;
    double limit_depth; /* opaque things here or farther are hidden */
} ref_pixel;

/* ---- the formulas ---- */

static inline double ref_i_clamp01(double x) {
    return x > 0 ? (x < 1 ? x : 1) : 0;
}

/* D02 equation 2. Where the formula is silent: an object without extent (d_max <= 0 or NaN) and a point on the edge
 * itself (d <= 0) or of unknown distance (NaN) are opaque, so that nothing vanishes by bad input; infinitely far from
 * every edge (there is none) is as transparent as it gets; k below 0 or NaN counts as 0. */
static inline double ref_alpha(double d, double d_max, double k) {
    if (!(d_max > 0) || !(d > 0))
        return 1;
    if (isinf(d) || !(k > 0)) /* k = 0 makes the power 1 at every distance but 0 */
        return 0;
    return ref_i_clamp01(1 - pow(d / d_max, k));
}

/* What lies behind, `below` with its weight, under the transparent colour `front` with alpha (design, Blending). */
static inline void ref_blend(ref_blending blending, double alpha, const double front[3], double weight,
                             const double below[3], double out[3]) {
    for (int i = 0; i < 3; ++i) {
        double sum = alpha * front[i] + weight * below[i];
        if (blending == REF_BLEND_PUBLISHED)
            out[i] = ref_i_clamp01(sum);
        else if (blending == REF_BLEND_NORMALISED)
            out[i] = alpha + weight > 0 ? sum / (alpha + weight) : below[i];
        else
            out[i] = alpha * front[i] + (1 - alpha) * below[i];
    }
}

static inline double ref_i_dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void ref_i_normalise(double v[3]) {
    double length = sqrt(ref_i_dot(v, v));
    for (int i = 0; i < 3; ++i)
        v[i] = length > 0 ? v[i] / length : 0;
}

/* Gooch 1998: t = (1 + n.l)/2 runs from the cool to the warm end, each end tinted by the diffuse colour. (The printed
 * formula has the two ends the other way round for a light vector that points away from the light; here it points
 * toward it, and what faces the light is warm.) n and l have unit length. */
static inline void ref_cool_to_warm(const double diffuse[3], const double n[3], const double l[3], const double cool[3],
                                    const double warm[3], double cool_mix, double warm_mix, double out[3]) {
    double t = (1 + ref_i_dot(n, l)) / 2;
    for (int i = 0; i < 3; ++i) {
        double k_cool = cool[i] + cool_mix * diffuse[i], k_warm = warm[i] + warm_mix * diffuse[i];
        out[i] = ref_i_clamp01(t * k_warm + (1 - t) * k_cool);
    }
}

/* The least distance to any of `count` segments of six numbers each; infinity when there are none. With infinite_lines
 * every segment stands for the whole line through it, as printed in D02 section 5. A segment of length 0 is a point. */
static inline double ref_distance_to_segments(const double p[3], const double *segments, size_t count,
                                              bool infinite_lines) {
    double least = REF_NONE;
    for (size_t s = 0; s < count; ++s) {
        const double *a = segments + 6 * s;
        double e[3] = {a[3] - a[0], a[4] - a[1], a[5] - a[2]};
        double v[3] = {p[0] - a[0], p[1] - a[1], p[2] - a[2]};
        double square = ref_i_dot(e, e), t = square > 0 ? ref_i_dot(v, e) / square : 0;
        if (!infinite_lines)
            t = ref_i_clamp01(t);
        double away[3] = {v[0] - t * e[0], v[1] - t * e[1], v[2] - t * e[2]};
        least = fmin(least, sqrt(ref_i_dot(away, away)));
    }
    return least;
}

/* ---- matrices ---- */

/* The products are summed in long double: an object at 10^6 seen by an eye at 10^6 must not lose what they share. */
static inline void ref_i_multiply(const long double a[16], const double b[16], bool absolute, long double out[16]) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) {
            long double sum = 0;
            for (int k = 0; k < 4; ++k) {
                long double term = a[4 * k + r] * (long double)b[4 * c + k];
                sum += absolute ? fabsl(term) : term;
            }
            out[4 * c + r] = sum;
        }
}

static inline double ref_i_det3(const double a[3], const double b[3], const double c[3]) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

static inline double ref_i_det4(const double m[16]) {
    double sum = 0;
    for (int column = 0; column < 4; ++column) { /* along the last row */
        double minor[9];
        for (int c = 0, k = 0; c < 4; ++c)
            for (int r = 0; c != column && r < 3; ++r)
                minor[k++] = m[4 * c + r];
        double det = ref_i_det3(minor, minor + 3, minor + 6);
        sum += (column % 2 == 0 ? -1 : 1) * m[4 * column + 3] * det;
    }
    return sum;
}

/* Columns 0 to 2 of the 3x3 part. */
static inline double ref_i_linear_det(const double m[16]) {
    return ref_i_det3(m, m + 4, m + 8);
}

/* ---- triangles as seen by the rays ---- */

/* A vertex in homogeneous pixel coordinates: (x, y, w) with x/w, y/w in pixels, and the clip z and w. noise bounds the
 * rounding error of each. */
typedef struct ref_i_vertex {
    double pixel[3], z;
    double noise[3], z_noise;
} ref_i_vertex;

/* With the vertices as columns of a matrix, (x, y, 1) = sum of weight_i * vertex_i has the weights edge_i(x, y) / det.
 * A ray through (x, y) meets the triangle before the eye exactly when no weight is negative. */
typedef struct ref_i_triangle {
    double edge[3][3]; /* signed so that inside is positive */
    double plane[3];   /* window depth = plane . (x, y, 1) */
    uint32_t object, index;
    bool front;      /* the outward side faces the eye */
    float bounds[4]; /* pixels: left, bottom, right, top; empty when out of view */
} ref_i_triangle;

typedef enum { REF_I_FRONT, REF_I_BACK, REF_I_SOLID } ref_i_kind;

typedef struct ref_i_hit {
    double depth, slack; /* window depth and a bound of its rounding error */
    double weight[3];    /* barycentric in object space */
    size_t triangle;
    ref_i_kind kind;
} ref_i_hit;

typedef struct ref_i_world {
    const ref_scene *scene;
    ref_i_vertex **vertices; /* an array an object */
    ref_i_triangle *triangles;
    size_t triangle_count;
    /* Bin b is a square of REF_I_BIN pixels and holds bin_items[bin_first[b]] up to bin_items[bin_first[b + 1]]. */
    size_t *bin_first;
    uint32_t *bin_items;
    int bins_x, bins_y;
    bool brute;      /* ask every triangle instead of those in the bin */
    double **curves; /* by object, six numbers a segment: where it crosses transparent ones */
    size_t *curve_counts;
    ref_i_hit *hits;
    size_t hit_count, hit_capacity;
} ref_i_world;

#define REF_I_BIN 8

static inline const ref_object *ref_i_object_of(const ref_i_world *world, const ref_i_triangle *triangle) {
    return &world->scene->objects[triangle->object];
}

static inline const ref_i_vertex *ref_i_corner(const ref_i_world *world, const ref_i_triangle *triangle, int corner) {
    const ref_object *object = ref_i_object_of(world, triangle);
    return &world->vertices[triangle->object][object->indices[3 * (size_t)triangle->index + (size_t)corner]];
}

static inline void ref_i_transform_object(const ref_scene *scene, const ref_object *object, ref_i_vertex *out) {
    long double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    long double p[16], pv[16], m[16], sizes[16];
    ref_i_multiply(identity, scene->projection, false, p);
    ref_i_multiply(p, scene->view, false, pv);
    ref_i_multiply(pv, object->model, false, m);
    ref_i_multiply(p, scene->view, true, pv);
    ref_i_multiply(pv, object->model, true, sizes);
    for (size_t v = 0; v < object->vertex_count; ++v) {
        double clip[4], noise[4];
        for (int r = 0; r < 4; ++r) {
            long double sum = m[12 + r], size = fabsl(sum), total = sizes[12 + r];
            for (int c = 0; c < 3; ++c) {
                long double x = (long double)object->positions[3 * v + (size_t)c];
                sum += m[4 * c + r] * x;
                size += fabsl(m[4 * c + r] * x);
                total += fabsl(sizes[4 * c + r] * x);
            }
            clip[r] = (double)sum;
            noise[r] = (double)(fabsl(sum) * (long double)DBL_EPSILON + 8 * (size + total) * LDBL_EPSILON);
        }
        double half[2] = {scene->width / 2.0, scene->height / 2.0};
        for (int i = 0; i < 2; ++i) {
            out[v].pixel[i] = (clip[i] + clip[3]) * half[i];
            out[v].noise[i] = (noise[i] + noise[3]) * half[i] + 2 * DBL_EPSILON * fabs(out[v].pixel[i]);
        }
        out[v].pixel[2] = clip[3];
        out[v].noise[2] = noise[3];
        out[v].z = clip[2];
        out[v].z_noise = noise[2];
    }
}

/* a x b, computed from the same end whatever the order, so that two triangles on an edge find exact opposites. */
static inline void ref_i_edge(const double a[3], const double b[3], double out[3]) {
    bool swap = a[0] != b[0] ? a[0] > b[0] : (a[1] != b[1] ? a[1] > b[1] : a[2] > b[2]);
    const double *p = swap ? b : a, *q = swap ? a : b;
    double sign = swap ? -1 : 1;
    out[0] = sign * (p[1] * q[2] - p[2] * q[1]);
    out[1] = sign * (p[2] * q[0] - p[0] * q[2]);
    out[2] = sign * (p[0] * q[1] - p[1] * q[0]);
}

/* Clips a polygon of (x, y, z, w) to z * side + w >= 0. Returns the new count. */
static inline int ref_i_clip(double polygon[][4], int count, double side) {
    double out[8][4];
    int n = 0;
    for (int i = 0; i < count; ++i) {
        const double *a = polygon[i], *b = polygon[(i + 1) % count];
        double da = a[2] * side + a[3], db = b[2] * side + b[3];
        if (da >= 0)
            memcpy(out[n++], a, sizeof out[0]);
        if ((da >= 0) != (db >= 0)) {
            double t = da / (da - db);
            for (int k = 0; k < 4; ++k)
                out[n][k] = a[k] + t * (b[k] - a[k]);
            ++n;
        }
    }
    memcpy(polygon, out, (size_t)n * sizeof out[0]);
    return n;
}

static inline void ref_i_bound(const ref_i_world *world, ref_i_triangle *triangle) {
    double polygon[8][4], low[2] = {REF_NONE, REF_NONE}, high[2] = {-REF_NONE, -REF_NONE};
    double size[2] = {world->scene->width, world->scene->height};
    for (int i = 0; i < 3; ++i) {
        const ref_i_vertex *v = ref_i_corner(world, triangle, i);
        memcpy(polygon[i], v->pixel, 2 * sizeof(double));
        polygon[i][2] = v->z;
        polygon[i][3] = v->pixel[2];
    }
    int count = ref_i_clip(polygon, ref_i_clip(polygon, 3, 1), -1);
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 2; ++k) {
            bool before = polygon[i][3] > 0;
            low[k] = fmin(low[k], before ? polygon[i][k] / polygon[i][3] : 0);
            high[k] = fmax(high[k], before ? polygon[i][k] / polygon[i][3] : size[k]);
        }
    /* A hundredth of a pixel more than needed, and corner samples half a pixel outside the window are still asked. */
    for (int k = 0; k < 2; ++k) {
        triangle->bounds[k] = (float)fmin(fmax(low[k] - 0.01, -1), size[k] + 2);
        triangle->bounds[k + 2] = (float)fmax(fmin(high[k] + 0.01, size[k] + 1), -2);
    }
}

/* +1 when a counter-clockwise triangle in the window is one whose outward side faces the eye. The eye is where clip x,
 * y and w vanish and z < 0; the sign of the volume that it spans with the triangle changes with each mirroring. */
static inline double ref_i_orientation(const ref_scene *scene, const ref_object *object) {
    double camera = ref_i_det4(scene->projection) * ref_i_linear_det(scene->view);
    double model = ref_i_linear_det(object->model);
    double sign = (camera > 0 ? -1 : 1) * (model < 0 ? -1 : 1);
    return scene->front_face_cw ? -sign : sign;
}

static inline bool ref_i_make_triangle(const ref_i_world *world, double orientation, ref_i_triangle *t) {
    const ref_i_vertex *v[3];
    for (int i = 0; i < 3; ++i)
        v[i] = ref_i_corner(world, t, i);
    double det = ref_i_det3(v[0]->pixel, v[1]->pixel, v[2]->pixel), sign = det < 0 ? -1 : 1;
    if (det == 0) /* seen edge-on or of no area: no ray meets it */
        return false;
    t->front = det * orientation > 0;
    memset(t->plane, 0, sizeof t->plane);
    for (int i = 0; i < 3; ++i) {
        ref_i_edge(v[(i + 1) % 3]->pixel, v[(i + 2) % 3]->pixel, t->edge[i]);
        for (int k = 0; k < 3; ++k) {
            t->edge[i][k] *= sign;
            t->plane[k] += t->edge[i][k] * v[i]->z / fabs(det) / 2;
        }
    }
    t->plane[2] += 0.5;
    if (!isfinite(t->plane[0] + t->plane[1] + t->plane[2])) /* NaN or infinite vertices */
        return false;
    ref_i_bound(world, t);
    return true;
}

/* ---- bins ---- */

static inline int ref_i_bin_of(double x, int bins) {
    int bin = (int)floor(x / REF_I_BIN);
    return bin < 0 ? 0 : (bin >= bins ? bins - 1 : bin);
}

/* Two rounds over the triangles: the first counts, the second fills. */
static inline void ref_i_bin_round(ref_i_world *world, size_t *cursor, bool fill) {
    for (size_t i = 0; i < world->triangle_count; ++i) {
        const float *bounds = world->triangles[i].bounds;
        if (bounds[0] > bounds[2] || bounds[1] > bounds[3])
            continue;
        int x1 = ref_i_bin_of((double)bounds[2], world->bins_x), y1 = ref_i_bin_of((double)bounds[3], world->bins_y);
        for (int y = ref_i_bin_of((double)bounds[1], world->bins_y); y <= y1; ++y)
            for (int x = ref_i_bin_of((double)bounds[0], world->bins_x); x <= x1; ++x) {
                size_t bin = (size_t)y * (size_t)world->bins_x + (size_t)x;
                if (fill)
                    world->bin_items[cursor[bin]] = (uint32_t)i;
                ++cursor[bin];
            }
    }
}

static inline bool ref_i_fill_bins(ref_i_world *world) {
    world->bins_x = (world->scene->width + REF_I_BIN - 1) / REF_I_BIN;
    world->bins_y = (world->scene->height + REF_I_BIN - 1) / REF_I_BIN;
    size_t bins = (size_t)world->bins_x * (size_t)world->bins_y, total = 0;
    size_t *cursor = calloc(bins, sizeof *cursor);
    world->bin_first = calloc(bins + 1, sizeof *world->bin_first);
    if (cursor && world->bin_first) {
        ref_i_bin_round(world, cursor, false);
        for (size_t b = 0; b < bins; ++b) {
            world->bin_first[b] = total;
            total += cursor[b];
            cursor[b] = world->bin_first[b];
        }
        world->bin_first[bins] = total;
        world->bin_items = calloc(total + 1, sizeof *world->bin_items);
        if (world->bin_items)
            ref_i_bin_round(world, cursor, true);
    }
    free(cursor);
    return world->bin_items != NULL;
}

/* ---- hits ---- */

/* The sign of an edge function at (x, y), where 0 is settled by the step that the header of this file names. */
static inline bool ref_i_inside(const double edge[3], double value) {
    return value != 0 ? value > 0 : (edge[0] != 0 ? edge[0] > 0 : edge[1] > 0);
}

/* First-order bound of the rounding error of the depth of a hit, from that of the vertices and of the edge functions:
 * each weight is a determinant of (x, y, 1) and two vertices. */
static inline double ref_i_slack(const ref_i_vertex *const v[3], const double value[3], double x, double y, double ndc,
                                 double sum_w) {
    double at[3] = {fabs(x), fabs(y), 1}, error = 0;
    for (int i = 0; i < 3; ++i) {
        const ref_i_vertex *a = v[(i + 1) % 3], *b = v[(i + 2) % 3];
        double weight_error = 0;
        for (int k = 0; k < 3; ++k) {
            int m = (k + 1) % 3, n = (k + 2) % 3;
            weight_error += at[k] * (fabs(a->pixel[m]) * b->noise[n] + a->noise[m] * fabs(b->pixel[n]) +
                                     fabs(a->pixel[n]) * b->noise[m] + a->noise[n] * fabs(b->pixel[m]));
        }
        error += weight_error * fabs(v[i]->z - ndc * v[i]->pixel[2]);
        error += value[i] * (v[i]->z_noise + fabs(ndc) * v[i]->noise[2]);
    }
    return 2 * error / sum_w + 4 * DBL_EPSILON;
}

static inline bool ref_i_try(ref_i_world *world, size_t index, double x, double y) {
    const ref_i_triangle *t = &world->triangles[index];
    double value[3];
    for (int i = 0; i < 3; ++i) {
        value[i] = t->edge[i][0] * x + t->edge[i][1] * y + t->edge[i][2];
        if (!ref_i_inside(t->edge[i], value[i]))
            return true;
    }
    const ref_object *object = ref_i_object_of(world, t);
    if (!object->transparent && !object->two_sided && !t->front)
        return true; /* of opaque objects only front faces are seen */
    const ref_i_vertex *v[3];
    double sum = 0, sum_z = 0, sum_w = 0;
    for (int i = 0; i < 3; ++i) {
        v[i] = ref_i_corner(world, t, i);
        sum += value[i];
        sum_z += value[i] * v[i]->z;
        sum_w += value[i] * v[i]->pixel[2];
    }
    double ndc = sum_z / sum_w;
    if (!(sum_w > 0) || !(ndc >= -1 && ndc <= 1))
        return true;
    if (world->hit_count == world->hit_capacity) {
        size_t capacity = 2 * world->hit_capacity + 64;
        ref_i_hit *hits = realloc(world->hits, capacity * sizeof *hits);
        if (!hits)
            return false;
        world->hits = hits;
        world->hit_capacity = capacity;
    }
    ref_i_hit *hit = &world->hits[world->hit_count++];
    hit->depth = ndc / 2 + 0.5;
    hit->slack = ref_i_slack(v, value, x, y, ndc, sum_w);
    for (int i = 0; i < 3; ++i)
        hit->weight[i] = value[i] / sum;
    hit->triangle = index;
    hit->kind = !object->transparent ? REF_I_SOLID : (object->two_sided || t->front ? REF_I_FRONT : REF_I_BACK);
    return true;
}

/* Fills world->hits with everything that the ray through (x, y) meets, in no order. */
static inline bool ref_i_cast(ref_i_world *world, double x, double y) {
    world->hit_count = 0;
    if (world->brute) {
        for (size_t i = 0; i < world->triangle_count; ++i)
            if (!ref_i_try(world, i, x, y))
                return false;
        return true;
    }
    size_t bin =
        (size_t)ref_i_bin_of(y, world->bins_y) * (size_t)world->bins_x + (size_t)ref_i_bin_of(x, world->bins_x);
    for (size_t i = world->bin_first[bin]; i < world->bin_first[bin + 1]; ++i)
        if (!ref_i_try(world, world->bin_items[i], x, y))
            return false;
    return true;
}

/* ---- the rules ---- */

static inline bool ref_i_nearer(const ref_i_hit *a, const ref_i_hit *b) {
    return a->depth < b->depth - (a->slack + b->slack);
}

static inline uint32_t ref_i_id(const ref_i_world *world, const ref_i_hit *hit) {
    return ref_i_object_of(world, &world->triangles[hit->triangle])->id;
}

/* The nearest hit of a kind; only those strictly behind `behind` and not of object `except` where these are given. Of
 * several at the same depth that of the lowest id, then of the first triangle. */
static inline const ref_i_hit *ref_i_nearest(const ref_i_world *world, ref_i_kind kind, const ref_i_hit *behind,
                                             uint32_t except) {
    const ref_i_hit *least = NULL, *best = NULL;
    for (int round = 0; round < 2; ++round)
        for (size_t i = 0; i < world->hit_count; ++i) {
            const ref_i_hit *hit = &world->hits[i];
            if (hit->kind != kind || (behind && !ref_i_nearer(behind, hit)) || ref_i_id(world, hit) == except)
                continue;
            if (round == 0 && (!least || hit->depth < least->depth))
                least = hit;
            if (round == 1 && !ref_i_nearer(least, hit)) {
                uint32_t a = ref_i_id(world, hit), b = best ? ref_i_id(world, best) : 0;
                if (!best || a < b || (a == b && hit->triangle < best->triangle))
                    best = hit;
            }
        }
    return best;
}

/* What decides the colour of a pixel. */
typedef struct ref_i_decision {
    const ref_i_hit *front;                  /* the first of the blended layers */
    const ref_i_hit *layers[REF_MAX_LAYERS]; /* front to back */
    int layer_count;
    const ref_i_hit *opaque; /* seen behind them, between them, or alone */
    const ref_i_hit *limit;
} ref_i_decision;

static inline bool ref_i_in_chain(const ref_i_world *world, const ref_i_decision *d, const ref_i_hit *hit) {
    for (int i = 0; i < d->layer_count; ++i)
        if (ref_i_id(world, d->layers[i]) == ref_i_id(world, hit))
            return true;
    return false;
}

static inline bool ref_i_same_group(const ref_i_world *world, const ref_i_hit *a, const ref_i_hit *b) {
    uint32_t group = ref_i_object_of(world, &world->triangles[a->triangle])->group;
    return group != 0 && group == ref_i_object_of(world, &world->triangles[b->triangle])->group;
}

/* The nearest front face at the chain's last or behind it that does not belong to the chain. Of implicit interiors: no
 * further face of an object in the chain, and none of the group at the very depth of the last. */
static inline const ref_i_hit *ref_i_next(const ref_i_world *world, const ref_i_decision *d, bool is_explicit) {
    const ref_i_hit *last = d->layers[d->layer_count - 1], *best = NULL;
    for (size_t i = 0; i < world->hit_count; ++i) {
        const ref_i_hit *hit = &world->hits[i];
        bool strictly = is_explicit || ref_i_same_group(world, last, hit);
        if (hit->kind != REF_I_FRONT || (strictly ? !ref_i_nearer(last, hit) : ref_i_nearer(hit, last)) ||
            (!is_explicit && ref_i_in_chain(world, d, hit)))
            continue;
        if (!best || hit->depth < best->depth)
            best = hit;
    }
    return best;
}

/* How far a window depth is from the eye along the view: clip z and w are linear in that. */
static inline double ref_i_view_depth(const ref_scene *scene, double depth) {
    const double *p = scene->projection;
    double ndc = 2 * depth - 1;
    return -(ndc * p[15] - p[14]) / (p[10] - ndc * p[11]);
}

/* Of the faces at the depth of `next` the one that joins the chain: of its group, the lowest id; NULL where none does. */
static inline const ref_i_hit *ref_i_joining(const ref_i_world *world, const ref_i_decision *d, const ref_i_hit *next) {
    const ref_i_hit *last = d->layers[d->layer_count - 1], *best = NULL;
    double reach = world->scene->group_distance;
    double gap = ref_i_view_depth(world->scene, next->depth) - ref_i_view_depth(world->scene, last->depth);
    if (reach > 0 && !(gap < reach))
        return NULL;
    for (size_t i = 0; i < world->hit_count; ++i) {
        const ref_i_hit *hit = &world->hits[i];
        if (hit->kind == REF_I_FRONT && !ref_i_nearer(hit, next) && !ref_i_nearer(next, hit) &&
            ref_i_nearer(last, hit) && ref_i_same_group(world, last, hit) &&
            (!best || ref_i_id(world, hit) < ref_i_id(world, best)))
            best = hit;
    }
    return best && !ref_i_in_chain(world, d, best) ? best : NULL;
}

static inline void ref_i_decide_chain(const ref_i_world *world, ref_i_decision *d) {
    const ref_object *object = ref_i_object_of(world, &world->triangles[d->front->triangle]);
    bool is_explicit = object->method ? object->method == 2 : world->scene->interior == REF_INTERIOR_EXPLICIT;
    int most = world->scene->layers > 0 ? world->scene->layers : REF_MAX_LAYERS;
    const ref_i_hit *next;
    for (;;) {
        next = ref_i_next(world, d, is_explicit);
        const ref_i_hit *joins = next && d->layer_count < most ? ref_i_joining(world, d, next) : NULL;
        if (!joins)
            break;
        d->layers[d->layer_count++] = joins;
    }
    d->limit = next;
    if (!is_explicit) {
        const ref_i_hit *back = ref_i_nearest(world, REF_I_BACK, d->layers[d->layer_count - 1], 0);
        if (back && (!next || back->depth < next->depth))
            d->limit = back;
    }
}

static inline void ref_i_decide_layers(const ref_i_world *world, ref_i_decision *d) {
    while ((d->limit = ref_i_nearest(world, REF_I_FRONT, d->layers[d->layer_count - 1], 0)) != NULL &&
           d->layer_count < world->scene->layers)
        d->layers[d->layer_count++] = d->limit;
}

static inline ref_i_decision ref_i_decide(const ref_i_world *world) {
    ref_i_decision d;
    memset(&d, 0, sizeof d);
    d.front = d.layers[0] = ref_i_nearest(world, REF_I_FRONT, NULL, 0);
    d.layer_count = d.front != NULL;
    if (world->scene->interior == REF_INTERIOR_IMPLICIT_PUBLISHED) {
        /* D02 6.1: "only those opaque objects are visible which are closer than the nearest back face"; the depth
         * buffer that starts with the back faces hides front faces behind them as well. */
        d.limit = ref_i_nearest(world, REF_I_BACK, NULL, 0);
        if (d.front && d.limit && !ref_i_nearer(d.front, d.limit))
            d.layer_count = 0;
    } else if (d.front && world->scene->interior == REF_INTERIOR_LAYERS) {
        ref_i_decide_layers(world, &d);
    } else if (d.front) {
        ref_i_decide_chain(world, &d);
    }
    d.opaque = ref_i_nearest(world, REF_I_SOLID, NULL, 0);
    if (d.opaque && d.limit && !ref_i_nearer(d.opaque, d.limit))
        d.opaque = NULL;
    /* "opaque objects in the foreground are drawn on top of all other objects" */
    while (d.opaque && d.layer_count && ref_i_nearer(d.opaque, d.layers[d.layer_count - 1]))
        --d.layer_count;
    d.front = d.layer_count ? d.layers[0] : NULL;
    return d;
}

/* ---- where opaque objects enter transparent ones ---- */

static inline void ref_i_world_triangle(const ref_object *object, size_t triangle, double out[3][3]) {
    for (size_t i = 0; i < 3; ++i) {
        const float *p = object->positions + 3 * (size_t)object->indices[3 * triangle + i];
        const double *m = object->model;
        for (int r = 0; r < 3; ++r)
            out[i][r] = m[r] * (double)p[0] + m[4 + r] * (double)p[1] + m[8 + r] * (double)p[2] + m[12 + r];
    }
}

/* Six times the volume that d spans with the triangle abc. */
static inline double ref_i_volume(const double a[3], const double b[3], const double c[3], const double d[3]) {
    double e[3][3];
    const double *corners[3] = {a, b, c};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            e[i][k] = corners[i][k] - d[k];
    return ref_i_det3(e[0], e[1], e[2]);
}

/* Adds the point where the segment pq passes through the triangle t. */
static inline int ref_i_pierce(const double p[3], const double q[3], double t[3][3], double points[][3], int count) {
    double before = ref_i_volume(t[0], t[1], t[2], p), after = ref_i_volume(t[0], t[1], t[2], q);
    int positive = 0, negative = 0;
    if ((before > 0) == (after > 0))
        return count;
    for (int i = 0; i < 3; ++i) {
        double v = ref_i_volume(p, q, t[i], t[(i + 1) % 3]);
        positive += v > 0;
        negative += v < 0;
    }
    if (positive && negative)
        return count;
    for (int k = 0; k < 3; ++k)
        points[count][k] = p[k] + before / (before - after) * (q[k] - p[k]);
    return count + 1;
}

/* The segment in which two triangles cross: the farthest two of the points where an edge of one pierces the other. */
static inline bool ref_i_cross(double a[3][3], double b[3][3], double out[6]) {
    double points[6][3], longest = 0;
    int count = 0;
    for (int i = 0; i < 3; ++i) {
        count = ref_i_pierce(a[i], a[(i + 1) % 3], b, points, count);
        count = ref_i_pierce(b[i], b[(i + 1) % 3], a, points, count);
    }
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < i; ++j) {
            double square = 0;
            for (int k = 0; k < 3; ++k)
                square += (points[i][k] - points[j][k]) * (points[i][k] - points[j][k]);
            if (square <= longest)
                continue;
            longest = square;
            memcpy(out, points[i], sizeof points[i]);
            memcpy(out + 3, points[j], sizeof points[j]);
        }
    return longest > 0;
}

static inline bool ref_i_apart(double a[3][3], double b[3][3]) {
    for (int k = 0; k < 3; ++k)
        if (fmax(fmax(a[0][k], a[1][k]), a[2][k]) < fmin(fmin(b[0][k], b[1][k]), b[2][k]) ||
            fmax(fmax(b[0][k], b[1][k]), b[2][k]) < fmin(fmin(a[0][k], a[1][k]), a[2][k]))
            return true;
    return false;
}

static inline bool ref_i_find_curve(ref_i_world *world, size_t o, const ref_object *other) {
    const ref_object *object = &world->scene->objects[o];
    for (size_t i = 0; i < object->triangle_count; ++i)
        for (size_t j = 0; j < other->triangle_count; ++j) {
            double a[3][3], b[3][3], segment[6];
            ref_i_world_triangle(object, i, a);
            ref_i_world_triangle(other, j, b);
            if (ref_i_apart(a, b) || !ref_i_cross(a, b, segment))
                continue;
            double *grown = realloc(world->curves[o], (world->curve_counts[o] + 1) * sizeof segment);
            if (!grown)
                return false;
            world->curves[o] = grown;
            memcpy(grown + 6 * world->curve_counts[o]++, segment, sizeof segment);
        }
    return true;
}

static inline bool ref_i_find_curves(ref_i_world *world) {
    const ref_scene *scene = world->scene;
    bool ok = true;
    world->curves = calloc(scene->object_count + 1, sizeof *world->curves);
    world->curve_counts = calloc(scene->object_count + 1, sizeof *world->curve_counts);
    if (!world->curves || !world->curve_counts)
        return false;
    for (size_t o = 0; o < scene->object_count && scene->enter_reach > 0; ++o)
        for (size_t other = 0; ok && other < scene->object_count; ++other)
            if (!scene->objects[o].transparent && scene->objects[other].transparent)
                ok = ref_i_find_curve(world, o, &scene->objects[other]);
    return ok;
}

/* The factor of an opaque point's colour. */
static inline double ref_i_entering(const ref_i_world *world, const ref_i_hit *hit) {
    const ref_i_triangle *t = &world->triangles[hit->triangle];
    double corners[3][3], point[3] = {0, 0, 0};
    if (!(world->scene->enter_reach > 0))
        return 1;
    ref_i_world_triangle(ref_i_object_of(world, t), t->index, corners);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            point[k] += hit->weight[i] * corners[i][k];
    double d = ref_distance_to_segments(point, world->curves[t->object], world->curve_counts[t->object], false);
    return 1 - world->scene->enter_strength * fmax(0, 1 - d / world->scene->enter_reach);
}

/* ---- colours ---- */

/* The interpolated normal in the world by the inverse transpose of the model matrix: its cofactors over its
 * determinant. Zero where there is none. */
static inline void ref_i_world_normal(const ref_object *object, const double n[3], double out[3]) {
    const double *m = object->model;
    double sign = ref_i_linear_det(m) < 0 ? -1 : 1;
    for (int r = 0; r < 3; ++r) {
        int a = (r + 1) % 3, b = (r + 2) % 3;
        out[r] = 0;
        for (int c = 0; c < 3; ++c) {
            const double *p = m + 4 * ((c + 1) % 3), *q = m + 4 * ((c + 2) % 3);
            out[r] += sign * (p[a] * q[b] - p[b] * q[a]) * n[c];
        }
    }
    ref_i_normalise(out);
}

static inline void ref_i_color(const ref_i_world *world, const ref_i_hit *hit, double out[3]) {
    const ref_i_triangle *t = &world->triangles[hit->triangle];
    const ref_object *object = ref_i_object_of(world, t);
    const ref_scene *scene = world->scene;
    memcpy(out, object->color, 3 * sizeof *out);
    if (!object->cool_to_warm || !object->normals)
        return;
    double n[3] = {0, 0, 0}, normal[3], light[3];
    for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k)
            n[k] += hit->weight[i] * (double)object->normals[3 * (size_t)object->indices[3 * t->index + i] + k];
    ref_i_world_normal(object, n, normal);
    for (int k = 0; k < 3 && !t->front; ++k)
        normal[k] = -normal[k]; /* a two-sided object seen from behind */
    memcpy(light, scene->light_direction, sizeof light);
    ref_i_normalise(light);
    ref_cool_to_warm(object->color, normal, light, scene->cool, scene->warm, scene->cool_mix, scene->warm_mix, out);
}

static inline double ref_i_alpha_of(const ref_i_world *world, const ref_i_hit *hit) {
    const ref_i_triangle *t = &world->triangles[hit->triangle];
    const ref_object *object = ref_i_object_of(world, t);
    double alpha = 0;
    for (size_t i = 0; i < 3 && object->vertex_alpha; ++i)
        alpha += hit->weight[i] * (double)object->vertex_alpha[object->indices[3 * (size_t)t->index + i]];
    return object->vertex_alpha ? alpha : object->alpha;
}

/* IEC 61966-2-1, both ways. */
static inline void ref_i_to_light(const ref_scene *scene, double color[3]) {
    for (int i = 0; i < 3 && scene->srgb; ++i)
        color[i] = color[i] <= 0.04045 ? color[i] / 12.92 : pow((color[i] + 0.055) / 1.055, 2.4);
}

static inline void ref_i_from_light(const ref_scene *scene, double color[3]) {
    for (int i = 0; i < 3 && scene->srgb; ++i)
        color[i] = color[i] <= 0.0031308 ? color[i] * 12.92 : 1.055 * pow(color[i], 1 / 2.4) - 0.055;
}

static inline void ref_i_compose(const ref_i_world *world, const ref_i_decision *d, ref_pixel *out) {
    const ref_scene *scene = world->scene;
    double below[3], weight = d->opaque ? scene->opaque_weight : scene->background_weight;
    memset(out, 0, sizeof *out);
    out->front_depth = d->front ? d->front->depth : REF_NONE;
    out->opaque_depth = d->opaque ? d->opaque->depth : REF_NONE;
    out->limit_depth = d->limit ? d->limit->depth : REF_NONE;
    memcpy(below, scene->background, sizeof below);
    if (d->opaque) {
        out->opaque_object = ref_i_id(world, d->opaque);
        ref_i_color(world, d->opaque, below);
        for (int k = 0; k < 3; ++k)
            below[k] *= ref_i_entering(world, d->opaque);
    }
    out->front_object = d->front ? ref_i_id(world, d->front) : 0;
    out->layer_count = d->layer_count;
    if (d->layer_count && !d->opaque && scene->use_blend_color)
        memcpy(below, scene->blend_color, sizeof below);
    ref_i_to_light(scene, below);
    for (int i = d->layer_count - 1; i >= 0; --i) {
        double front[3];
        out->layer_objects[i] = ref_i_id(world, d->layers[i]);
        ref_i_color(world, d->layers[i], front);
        ref_i_to_light(scene, front);
        ref_blend(scene->blending, ref_i_alpha_of(world, d->layers[i]), front, weight, below, below);
    }
    ref_i_from_light(scene, below);
    memcpy(out->color, below, sizeof below);
}

/* ---- pixels left out of comparisons ----
 *
 * 1. Four points just inside the corners of the pixel (half a pixel away along each axis) that find another front-most
 *    object, opaque object or side of either than the centre: every boundary and every intersection that changes the
 *    colour and passes nearer than half a pixel is among them, unless it is thinner than the gaps between the points.
 * 2. Silhouettes, creases and open edges whose projection passes nearer than half a pixel and which the surfaces seen
 *    at the five points do not all hide. They catch slivers, and edges where the object on both sides is the same.
 * Where one object pierces itself, nothing is left out. */

#define REF_I_CORNER 0.499999
#define REF_I_CREASE_DEGREES 10.0

/* The triangles at one point that hide edges of transparent ([0]) and of opaque ([1]) objects behind them; -1: none. */
typedef struct ref_i_cover {
    int64_t triangle[2];
} ref_i_cover;

static inline ref_i_cover ref_i_cover_of(const ref_i_decision *d) {
    const ref_i_hit *solid = d->opaque ? d->opaque : d->limit;
    const ref_i_hit *front = d->layer_count ? d->layers[d->layer_count - 1] : solid;
    ref_i_cover cover = {{front ? (int64_t)front->triangle : -1, solid ? (int64_t)solid->triangle : -1}};
    return cover;
}

/* Which objects are seen, and which side of them. */
static inline uint64_t ref_i_signature(const ref_i_world *world, const ref_i_decision *d) {
    uint64_t signature = (uint64_t)d->layer_count;
    for (int i = -1; i < d->layer_count; ++i) {
        const ref_i_hit *hit = i < 0 ? d->opaque : d->layers[i];
        const ref_i_triangle *t = hit ? &world->triangles[hit->triangle] : NULL;
        signature = signature * 1000003 + (t ? 2 * (uint64_t)(t->object + 1) + t->front : 0);
    }
    return signature;
}

typedef struct ref_i_edge_key {
    uint32_t a, b;     /* welded vertices, a < b */
    uint32_t triangle; /* of the object */
    uint32_t forward;  /* the triangle runs from a to b */
} ref_i_edge_key;

static inline int ref_i_compare_edges(const void *left, const void *right) {
    const ref_i_edge_key *p = left, *q = right;
    if (p->a != q->a)
        return p->a < q->a ? -1 : 1;
    if (p->b != q->b)
        return p->b < q->b ? -1 : 1;
    return p->triangle < q->triangle ? -1 : p->triangle > q->triangle;
}

typedef struct ref_i_place {
    float at[3];
    uint32_t vertex;
} ref_i_place;

static inline int ref_i_compare_places(const void *left, const void *right) {
    const ref_i_place *p = left, *q = right;
    for (int k = 0; k < 3; ++k)
        if (p->at[k] < q->at[k] || p->at[k] > q->at[k])
            return p->at[k] < q->at[k] ? -1 : 1;
    return p->vertex < q->vertex ? -1 : p->vertex > q->vertex;
}

static inline bool ref_i_same_place(const ref_i_place *p, const ref_i_place *q) {
    return p->at[0] == q->at[0] && p->at[1] == q->at[1] && p->at[2] == q->at[2];
}

/* Vertices of equal position become the first of them, so that seams of normals do not look like open edges. NaN counts
 * as 0 for sorting; triangles with it are not seen anyway. */
static inline bool ref_i_weld(const ref_object *object, uint32_t *welded) {
    ref_i_place *places = calloc(object->vertex_count + 1, sizeof *places);
    if (!places)
        return false;
    for (size_t v = 0; v < object->vertex_count; ++v) {
        for (size_t k = 0; k < 3; ++k) {
            float x = object->positions[3 * v + k];
            places[v].at[k] = isnan(x) ? 0.0f : x;
        }
        places[v].vertex = (uint32_t)v;
    }
    qsort(places, object->vertex_count, sizeof *places, ref_i_compare_places);
    for (size_t i = 0, first = 0; i < object->vertex_count; ++i) {
        if (!ref_i_same_place(&places[first], &places[i]))
            first = i;
        welded[places[i].vertex] = places[first].vertex;
    }
    free(places);
    return true;
}

static inline void ref_i_face_normal(const ref_object *object, uint32_t triangle, double out[3]) {
    double p[3][3];
    for (size_t i = 0; i < 3; ++i)
        for (int r = 0; r < 3; ++r) {
            const float *v = object->positions + 3 * (size_t)object->indices[3 * (size_t)triangle + i];
            p[i][r] = 0; /* translation moves no normal */
            for (int c = 0; c < 3; ++c)
                p[i][r] += object->model[4 * c + r] * (double)v[c];
        }
    for (int k = 0; k < 3; ++k) {
        int m = (k + 1) % 3, n = (k + 2) % 3;
        out[k] = (p[1][m] - p[0][m]) * (p[2][n] - p[0][n]) - (p[1][n] - p[0][n]) * (p[2][m] - p[0][m]);
    }
    ref_i_normalise(out);
}

/* Whether an edge with these `count` triangles may be a line in the picture. seen[t] tells how triangle t is seen: 0
 * not at all (of no area), 1 from behind, 2 from the front. */
static inline bool ref_i_is_feature(const ref_object *object, const ref_i_edge_key *edges, size_t count,
                                    const unsigned char *seen) {
    unsigned sides = 0;
    for (size_t i = 0; i < count; ++i)
        sides |= seen[edges[i].triangle];
    if (sides == 0 || (sides == 1 && !object->two_sided))
        return false; /* back faces alone have no colour; where they limit, the four points tell */
    if (count != 2 || sides == 3 || edges[0].forward == edges[1].forward || !seen[edges[0].triangle] ||
        !seen[edges[1].triangle])
        return true;
    double a[3], b[3];
    ref_i_face_normal(object, edges[0].triangle, a);
    ref_i_face_normal(object, edges[1].triangle, b);
    return ref_i_dot(a, b) < cos(REF_I_CREASE_DEGREES * acos(-1.0) / 180);
}

/* Whether the surface seen at some point lies before an edge of window depth `depth` at (x, y). Depth is linear in the
 * window, so the surface's plane tells its depth there; half a pixel's slope is granted to surfaces that bend. */
static inline bool ref_i_hidden(const ref_i_world *world, const ref_i_cover covers[5], bool transparent, double x,
                                double y, double depth) {
    for (int s = 0; s < 5; ++s) {
        int64_t triangle = covers[s].triangle[transparent ? 0 : 1];
        if (triangle < 0)
            return false;
        const double *plane = world->triangles[triangle].plane;
        double tolerance = (fabs(plane[0]) + fabs(plane[1])) / 2 + 1e-9;
        if (depth <= plane[0] * x + plane[1] * y + plane[2] + tolerance)
            return false;
    }
    return true;
}

/* Marks the pixels along a segment a-b of the window (x, y, depth). */
static inline void ref_i_mark_segment(const ref_i_world *world, const ref_i_cover *covers, bool transparent,
                                      const double a[3], const double b[3], ref_pixel *out) {
    int width = world->scene->width, height = world->scene->height;
    double e[2] = {b[0] - a[0], b[1] - a[1]}, square = e[0] * e[0] + e[1] * e[1];
    double y0 = floor(fmax(fmin(a[1], b[1]) - 1, 0)), y1 = fmin(fmax(a[1], b[1]) + 1, height);
    for (int y = (int)fmin(y0, height); y < y1; ++y) {
        double t[2] = {0, 1}; /* the part of the segment that is nearer than a pixel to this row */
        for (int side = 0; side < 2 && e[1] != 0; ++side) {
            double at = ((e[1] > 0) == (side == 0) ? y - 0.5 : y + 1.5) - a[1];
            t[side] = ref_i_clamp01(at / e[1]);
        }
        double xa = a[0] + t[0] * e[0], xb = a[0] + t[1] * e[0];
        double x0 = floor(fmax(fmin(xa, xb) - 1, 0)), x1 = fmin(fmax(xa, xb) + 1, width);
        for (int x = (int)fmin(x0, width); x < x1; ++x) {
            double v[2] = {x + 0.5 - a[0], y + 0.5 - a[1]};
            double s = square > 0 ? ref_i_clamp01((v[0] * e[0] + v[1] * e[1]) / square) : 0;
            double dx = v[0] - s * e[0], dy = v[1] - s * e[1];
            size_t pixel = (size_t)y * (size_t)width + (size_t)x;
            if (dx * dx + dy * dy < 0.25 && !out[pixel].left_out)
                out[pixel].left_out = !ref_i_hidden(world, covers + 5 * pixel, transparent, a[0] + s * e[0],
                                                    a[1] + s * e[1], a[2] + s * (b[2] - a[2]));
        }
    }
}

static inline void ref_i_mark_edge(const ref_i_world *world, const ref_i_cover *covers, const ref_object *object,
                                   const ref_i_vertex *a, const ref_i_vertex *b, ref_pixel *out) {
    double p[2][4] = {{a->pixel[0], a->pixel[1], a->z, a->pixel[2]}, {b->pixel[0], b->pixel[1], b->z, b->pixel[2]}};
    double ends[2][3], t[2] = {0, 1};
    for (int side = -1; side <= 1; side += 2) { /* the near and the far plane */
        double da = side * p[0][2] + p[0][3], db = side * p[1][2] + p[1][3];
        if (da < 0)
            t[0] = fmax(t[0], db > 0 ? da / (da - db) : 2);
        if (db < 0)
            t[1] = fmin(t[1], da > 0 ? da / (da - db) : -1);
    }
    for (int i = 0; i < 2; ++i) {
        double q[4];
        for (int k = 0; k < 4; ++k)
            q[k] = p[0][k] + t[i] * (p[1][k] - p[0][k]);
        if (!(t[0] <= t[1]) || !(q[3] > 0))
            return;
        ends[i][0] = q[0] / q[3];
        ends[i][1] = q[1] / q[3];
        ends[i][2] = q[2] / q[3] / 2 + 0.5;
        if (!isfinite(ends[i][0] + ends[i][1] + ends[i][2]))
            return;
    }
    ref_i_mark_segment(world, covers, object->transparent, ends[0], ends[1], out);
}

static inline bool ref_i_mark_object(const ref_i_world *world, const ref_i_cover *covers, size_t o,
                                     const unsigned char *seen, ref_pixel *out) {
    const ref_object *object = &world->scene->objects[o];
    size_t count = 3 * object->triangle_count;
    uint32_t *welded = calloc(object->vertex_count + 1, sizeof *welded);
    ref_i_edge_key *edges = calloc(count + 1, sizeof *edges);
    bool ok = welded && edges && ref_i_weld(object, welded);
    for (size_t i = 0; ok && i < count; ++i) {
        uint32_t a = welded[object->indices[i]], b = welded[object->indices[i % 3 == 2 ? i - 2 : i + 1]];
        edges[i].a = a < b ? a : b;
        edges[i].b = a < b ? b : a;
        edges[i].triangle = (uint32_t)(i / 3);
        edges[i].forward = a < b;
    }
    if (ok)
        qsort(edges, count, sizeof *edges, ref_i_compare_edges);
    for (size_t i = 0, n; ok && i < count; i += n) {
        for (n = 1; i + n < count && edges[i + n].a == edges[i].a && edges[i + n].b == edges[i].b;)
            ++n;
        if (edges[i].a != edges[i].b && ref_i_is_feature(object, edges + i, n, seen))
            ref_i_mark_edge(world, covers, object, &world->vertices[o][edges[i].a], &world->vertices[o][edges[i].b],
                            out);
    }
    free(welded);
    free(edges);
    return ok;
}

static inline bool ref_i_mark_edges(const ref_i_world *world, const ref_i_cover *covers, ref_pixel *out) {
    bool ok = true;
    for (size_t o = 0; ok && o < world->scene->object_count; ++o) {
        unsigned char *seen = calloc(world->scene->objects[o].triangle_count + 1, 1);
        for (size_t i = 0; seen && i < world->triangle_count; ++i)
            if (world->triangles[i].object == o)
                seen[world->triangles[i].index] = world->triangles[i].front ? 2 : 1;
        ok = seen && ref_i_mark_object(world, covers, o, seen, out);
        free(seen);
    }
    return ok;
}

/* ---- rendering ---- */

static inline bool ref_i_is_valid(const ref_scene *scene) {
    if (scene->width < 0 || scene->height < 0 || (scene->object_count && !scene->objects))
        return false;
    for (size_t o = 0; o < scene->object_count; ++o) {
        const ref_object *object = &scene->objects[o];
        if (object->id == 0 || object->triangle_count > UINT32_MAX / 3 || object->vertex_count > UINT32_MAX)
            return false;
        for (size_t i = 0; i < 3 * object->triangle_count; ++i)
            if (object->indices[i] >= object->vertex_count)
                return false;
        for (size_t other = 0; other < o; ++other)
            if (scene->objects[other].id == object->id)
                return false;
    }
    return true;
}

static inline bool ref_i_make_world(ref_i_world *world) {
    const ref_scene *scene = world->scene;
    size_t total = 0;
    for (size_t o = 0; o < scene->object_count; ++o)
        total += scene->objects[o].triangle_count;
    world->vertices = calloc(scene->object_count + 1, sizeof *world->vertices);
    world->triangles = calloc(total + 1, sizeof *world->triangles);
    if (!world->vertices || !world->triangles || total > UINT32_MAX)
        return false;
    for (size_t o = 0; o < scene->object_count; ++o) {
        const ref_object *object = &scene->objects[o];
        double orientation = ref_i_orientation(scene, object);
        world->vertices[o] = calloc(object->vertex_count + 1, sizeof **world->vertices);
        if (!world->vertices[o])
            return false;
        ref_i_transform_object(scene, object, world->vertices[o]);
        for (size_t i = 0; i < object->triangle_count; ++i) {
            ref_i_triangle *t = &world->triangles[world->triangle_count];
            t->object = (uint32_t)o;
            t->index = (uint32_t)i;
            if (ref_i_make_triangle(world, orientation, t))
                ++world->triangle_count;
        }
    }
    return ref_i_fill_bins(world) && ref_i_find_curves(world);
}

static inline void ref_i_free_world(ref_i_world *world) {
    for (size_t o = 0; world->vertices && o < world->scene->object_count; ++o)
        free(world->vertices[o]);
    for (size_t o = 0; world->curves && o < world->scene->object_count; ++o)
        free(world->curves[o]);
    free(world->curves);
    free(world->curve_counts);
    free(world->vertices);
    free(world->triangles);
    free(world->bin_first);
    free(world->bin_items);
    free(world->hits);
}

/* One pixel: its centre for the colour, then four points near its corners for what is left out. */
static inline bool ref_i_render_pixel(ref_i_world *world, int x, int y, ref_pixel *out, ref_i_cover covers[5]) {
    uint64_t centre = 0;
    for (int s = 0; s < 5; ++s) {
        double dx = s == 0 ? 0 : (s % 2 ? -REF_I_CORNER : REF_I_CORNER);
        double dy = s == 0 ? 0 : (s < 3 ? -REF_I_CORNER : REF_I_CORNER);
        if (!ref_i_cast(world, x + 0.5 + dx, y + 0.5 + dy))
            return false;
        ref_i_decision decision = ref_i_decide(world);
        uint64_t signature = ref_i_signature(world, &decision);
        covers[s] = ref_i_cover_of(&decision);
        if (s == 0) {
            ref_i_compose(world, &decision, out);
            centre = signature;
        }
        out->left_out = out->left_out || signature != centre;
    }
    return true;
}

static inline bool ref_i_render(const ref_scene *scene, ref_pixel *out, bool brute) {
    if (!ref_i_is_valid(scene))
        return false;
    if (scene->width == 0 || scene->height == 0)
        return true;
    ref_i_world world = {.scene = scene, .brute = brute};
    size_t pixels = (size_t)scene->width * (size_t)scene->height;
    ref_i_cover *covers = calloc(5 * pixels, sizeof *covers);
    bool ok = covers && ref_i_make_world(&world);
    for (size_t i = 0; ok && i < pixels; ++i)
        ok = ref_i_render_pixel(&world, (int)(i % (size_t)scene->width), (int)(i / (size_t)scene->width), &out[i],
                                covers + 5 * i);
    ok = ok && ref_i_mark_edges(&world, covers, out);
    free(covers);
    ref_i_free_world(&world);
    return ok;
}

/* Fills width * height pixels, the bottom row first as GL has it. False: out of memory, or a scene that makes no sense
 * (an id of 0 or used twice, an index out of range, a negative size). */
static inline bool ref_render(const ref_scene *scene, ref_pixel *out) {
    return ref_i_render(scene, out, false);
}

/* The same picture by asking every triangle at every point. */
static inline bool ref_render_brute(const ref_scene *scene, ref_pixel *out) {
    return ref_i_render(scene, out, true);
}

/* The share of pixels left out, 0 to 1. */
static inline double ref_left_out_share(const ref_pixel *pixels, size_t count) {
    size_t left_out = 0;
    for (size_t i = 0; i < count; ++i)
        left_out += pixels[i].left_out;
    return count ? (double)left_out / (double)count : 0;
}

#endif

/* reference_dynamic.h: the ground truth of dynamic transparency, in double, by casting a ray a pixel centre (the caster is
 * that of reference.h). Slow and plain; shares no code with the headers it judges.
 *
 * Source: Assarsson, Elmqvist, Tsigas 2006, "Image-Space Dynamic Transparency for Improved Object Discovery in 3D
 * Environments" (A06 below), and the paragraph "Dynamic transparency" of the design, which wins over it.
 *
 * How ambiguous sentences are read here:
 *  - What a pixel consists of are layers: of a solid object its front-most surface there, of a hollow one every surface
 *    that looks toward the eye. "Each object as a solid, i.e., only the front-most surfaces should be visible" (A06 4)
 *    holds whether or not a target lies behind that surface: the far wall of a solid object is never seen.
 *  - Truth is per pixel: layers are ordered by depth and a mask acts on those strictly nearer than the target there. Of
 *    layers at the same depth (reference.h says what that is) a target lies nearest to the eye, so that nothing
 *    coincident hides it; then, within a group, the one of higher rank; then the one of the lowest id.
 *  - Object-centre order (A06 4) paints whole objects from the farthest to the nearest middle, with a depth buffer that
 *    is not cleared in between: what lies behind anything painted before is lost. There a mask acts on all that is
 *    painted after its target, at whatever depth.
 *  - A group has the mean of its members' middles and paints them by rank, the lowest first (innermost). Where depth
 *    decides, the rank settles ties only. Members of a group are objects of their own all the same: an inner doll that
 *    is a target is seen through the outer ones; rule R4 speaks of one object.
 *  - "1 and 0 give the paper" of importances, "targets cut targets": a target of importance 1 that occludes another has
 *    to yield as a distractor of importance 0 does. So a target counts 1 less as an occluder than as a target. Among
 *    targets the more important one in front then keeps the difference, and equal ones cut each other as in the paper.
 *    A target is cut where another lies behind it, not by the rest of that one's mask: where the gradient of one ran over
 *    the other, targets would fade with nothing behind them, and "weight >= 1 - alpha_T" could not hold. In the paper all
 *    of the mask cuts.
 *  - Gradient: the first ring of pixels around the target has alpha_start, and each further pixel adds 1/n of the way to
 *    1 (A06 algorithm 2, line 8: n layers "starting from alpha_0 to 1.0"; the n + 1st would be 1). Distances are those
 *    between pixel centres, or counted in rings of eight neighbours (A06 algorithm 3).
 *  - Circle, ellipse and hull: alpha_target in the whole shape ("points p in P [...] to alpha_T", R2), the gradient
 *    around it. They enclose the centres of the target's open pixels, or points in the world that the caller gives.
 *    Circle: around the middle of their rectangle, through the farthest. Ellipse: the same with the proportions of the
 *    rectangle, axes along the window's.
 *  - Beside the target the mask has no fragment of its own to compare with: it has the depth of the nearest open pixel of
 *    the target, of equally near ones that nearest to the eye.
 *  - One mask for all targets (not the truth, but what docs/dynamic.md says of TR_SEE_ONE_MASK; each departure is a line of
 *    ref_dyn_i_compose_one): at a pixel the nearest target's, beside targets that of the nearest pixel of any. The picture
 *    is the scene and, in the share that the mask takes away, the front-most of what does not yield. Only importances that
 *    are 0 or 1 are the same for all that is before the target; of others the front-most layer's counts.
 *  - "Low resolution, finished by the target at full resolution": with cells of so many pixels a side the nearest pixel of
 *    the target is, beside the target, the nearest of the four that are nearest to the middles of the cells around.
 *  - "An impenetrable surface also closes the mask of what it hides": pixels of the target behind such a surface are not
 *    open: they are no part of the shape and nothing grows from them. The gradient of open pixels runs on over the
 *    impenetrable surface, so that what lies before both has no hard edge there. In the paper such pixels are open.
 *  - A backdrop is what the host knows to have no target behind it (A06 4: "can safely be rendered [...] first"). Where
 *    it has one after all, it acts as an impenetrable surface.
 *  - occluders = together: the opacity g that the mask asks for is shared by the m layers that it makes transparent at
 *    that pixel, each 1 - (1 - g)^(1/m), so that what is behind them keeps 1 - g. Importances act after that.
 *  - Layer control: those n layers nearest to the eye which the mask would make transparent become so; m counts these.
 *  - Lights and fading scale what a mask takes away: g becomes 1 - s (1 - g). A light has s = 1 within its radius and
 *    falls to 0 over its edge, linearly, outside; of several the strongest counts. */
#ifndef GLASSINE_TESTS_REFERENCE_DYNAMIC_H
#define GLASSINE_TESTS_REFERENCE_DYNAMIC_H

#include "reference.h"

enum {
    REF_DYN_TARGET = 1,       /* without it: a distractor */
    REF_DYN_IMPENETRABLE = 2, /* R3: never transparent, and nothing is seen through to what it hides */
    REF_DYN_HOLLOW = 4,       /* without it: solid */
    REF_DYN_BACKDROP = 8,     /* not together with REF_DYN_TARGET */
    REF_DYN_ACTIVE = 16       /* a target that opens its mask inside lights only; without it: passive */
};

typedef struct ref_dyn_object {
    uint32_t flags;
    double importance;          /* 0 to 1 */
    uint32_t group;             /* 0: a group of its own */
    int rank;                   /* within the group: the innermost has the lowest */
    double faded;               /* how far its mask has faded out: 0 not, 1 gone */
    const double (*enclose)[3]; /* NULL, or points in the world that circle, ellipse and hull enclose */
    size_t enclose_count;
} ref_dyn_object;

typedef struct ref_dyn_light {
    double x, y, radius, edge; /* pixels, y from the bottom */
} ref_dyn_light;

typedef enum { REF_DYN_OUTLINE, REF_DYN_CIRCLE, REF_DYN_ELLIPSE, REF_DYN_HULL } ref_dyn_shape;
typedef enum { REF_DYN_MIN, REF_DYN_PRODUCT } ref_dyn_combine;
typedef enum { REF_DYN_TOGETHER, REF_DYN_EACH } ref_dyn_occluders;
typedef enum { REF_DYN_PER_PIXEL, REF_DYN_OBJECT_CENTRES } ref_dyn_order;
typedef enum { REF_DYN_ROUND, REF_DYN_RINGS } ref_dyn_growth;

/* Zeros are the design's defaults but for the numbers, which ref_dyn_defaults fills in. */
typedef struct ref_dyn_scene {
    const ref_scene *scene;        /* its objects opaque, its blending not used */
    const ref_dyn_object *objects; /* as many, in the same order */
    double alpha_target;           /* alpha_T */
    double alpha_start, width;     /* alpha_0 and n: the gradient, in pixels */
    ref_dyn_shape shape;
    ref_dyn_combine combine;
    ref_dyn_occluders occluders;
    ref_dyn_order order;
    ref_dyn_growth growth;
    bool open_behind_impenetrable, whole_masks_cut_targets; /* as in the paper */
    uint32_t layers;                                        /* layer control; 0: no limit */
    bool one_mask;                                          /* see above */
    int cell;                                               /* 2 and more: the cheaper nearest pixel, see below */
    const ref_dyn_light *lights;
    size_t light_count;
} ref_dyn_scene;

typedef struct ref_dyn_pixel {
    double color[3];
    double background;     /* weight of the background */
    uint32_t target;       /* id of the farthest target that no impenetrable surface hides; 0: none */
    double target_weight;  /* its weight */
    double targets_weight; /* that of all targets */
    uint32_t see_through;  /* layers with alpha below 1 */
    bool left_out;         /* too near to an edge for a comparison */
} ref_dyn_pixel;

/* What a query about one object should tell. */
typedef struct ref_dyn_census {
    size_t pixels; /* covered by it, hidden or not */
    size_t hidden; /* of these, those with anything nearer */
    size_t closed; /* of these, those with an impenetrable surface or a backdrop nearer */
    size_t clear;  /* those in which its weight is 0.3 or more */
    double weight; /* sum of its weights */
    double least;  /* its least weight on a pixel of its own that is not closed; 1 where there is none */
} ref_dyn_census;

/* alpha_T is the design's: four masks leave 0.8 % of a wall, 0.3^4. */
static inline void ref_dyn_defaults(ref_dyn_scene *dynamic) {
    memset(dynamic, 0, sizeof *dynamic);
    dynamic->alpha_target = 0.3;
    dynamic->alpha_start = 0.1;
    dynamic->width = 12;
}

/* The paper's algorithm, all of it. `published` of the design is the first two; the rest are its companions. */
static inline void ref_dyn_published(ref_dyn_scene *dynamic) {
    dynamic->combine = REF_DYN_PRODUCT;
    dynamic->occluders = REF_DYN_EACH;
    dynamic->order = REF_DYN_OBJECT_CENTRES;
    dynamic->growth = REF_DYN_RINGS;
    dynamic->open_behind_impenetrable = dynamic->whole_masks_cut_targets = true;
}

/* ---- the formulas ---- */

static inline double ref_dyn_mix(double a, double b, double t) {
    return a + (b - a) * t;
}

/* How much of its opacity an occluder gives up for a target, 0 to 1: the clamp of the design's formula. */
static inline double ref_dyn_yield(const ref_dyn_object *target, const ref_dyn_object *occluder) {
    double as_occluder = occluder->importance - (occluder->flags & REF_DYN_TARGET ? 1 : 0);
    return ref_i_clamp01(target->importance - as_occluder);
}

/* The mask's value `beyond` pixels outside of the shape. */
static inline double ref_dyn_gradient(const ref_dyn_scene *dynamic, double beyond) {
    return dynamic->width > 0 ? ref_dyn_mix(dynamic->alpha_start, 1, ref_i_clamp01(beyond / dynamic->width)) : 1;
}

/* What each of m layers has so that together they have opacity g (Carnecky 2013, equation 5). */
static inline double ref_dyn_shared(double g, size_t m) {
    return m > 0 ? 1 - pow(1 - g, 1.0 / (double)m) : g;
}

static inline double ref_dyn_light_at(const ref_dyn_scene *dynamic, double x, double y) {
    double most = 0;
    for (size_t i = 0; i < dynamic->light_count; ++i) {
        const ref_dyn_light *l = &dynamic->lights[i];
        double outside = hypot(x - l->x, y - l->y) - l->radius;
        double strength = !(outside > 0) ? 1 : (l->edge > 0 ? ref_i_clamp01(1 - outside / l->edge) : 0);
        most = fmax(most, strength);
    }
    return most;
}

/* ---- the scene in memory ---- */

typedef struct ref_dyn_i_layer {
    uint32_t object;
    double depth, slack;
    double color[3];
} ref_dyn_i_layer;

/* A pixel of a target, hidden or not. */
typedef struct ref_dyn_i_cover {
    uint32_t object;
    int x, y;
    double depth, slack;
    bool open, hidden;
} ref_dyn_i_cover;

typedef struct ref_dyn_i_list { /* of structs of one size */
    void *items;
    size_t count, capacity;
} ref_dyn_i_list;

typedef struct ref_dyn_i_mask_pixel {
    double value; /* 1: no mask here */
    double depth, slack;
    bool own;        /* the target is there, open */
    uint32_t object; /* whose it is */
} ref_dyn_i_mask_pixel;

typedef struct ref_dyn_i_mask {
    uint32_t object;
    int x0, y0, x1, y1; /* x1 and y1 are outside */
    ref_dyn_i_mask_pixel *pixels;
} ref_dyn_i_mask;

typedef struct ref_dyn_i_world {
    const ref_dyn_scene *dynamic;
    ref_i_world rays;
    uint32_t *position;    /* of each object in object-centre order: the last painted has the highest */
    ref_dyn_i_list layers; /* front to back, pixel after pixel */
    size_t *first;         /* pixel i has the layers first[i] up to first[i + 1] */
    ref_dyn_i_list covers;
    ref_dyn_i_mask *masks;
    size_t mask_count;
} ref_dyn_i_world;

static inline void *ref_dyn_i_push(ref_dyn_i_list *list, size_t size) {
    if (list->count == list->capacity) {
        size_t capacity = 2 * list->capacity + 64;
        void *items = realloc(list->items, capacity * size);
        if (!items)
            return NULL;
        list->items = items;
        list->capacity = capacity;
    }
    return (char *)list->items + size * list->count++;
}

static inline bool ref_dyn_i_is(const ref_dyn_i_world *world, uint32_t object, uint32_t flags) {
    return (world->dynamic->objects[object].flags & flags) != 0;
}

/* ---- order ---- */

/* The distance of an object's middle, that of the box of its vertices, along the look vector. */
static inline double ref_dyn_i_middle(const ref_scene *scene, const ref_object *object) {
    double low[3] = {REF_NONE, REF_NONE, REF_NONE}, high[3] = {-REF_NONE, -REF_NONE, -REF_NONE}, depth = 0;
    for (size_t v = 0; v < object->vertex_count; ++v)
        for (int r = 0; r < 3; ++r) {
            double x = object->model[12 + r];
            for (int c = 0; c < 3; ++c)
                x += object->model[4 * c + r] * (double)object->positions[3 * v + (size_t)c];
            low[r] = fmin(low[r], x);
            high[r] = fmax(high[r], x);
        }
    for (int r = 0; r < 3 && low[r] <= high[r]; ++r)
        depth -= scene->view[4 * r + 2] * (low[r] + high[r]) / 2;
    return depth - scene->view[14];
}

typedef struct ref_dyn_i_place {
    bool backdrop;
    double depth;      /* of its group */
    uint32_t group_id; /* the lowest id in the group */
    int rank;
    uint32_t id, object;
} ref_dyn_i_place;

/* In the order of painting. */
static inline int ref_dyn_i_compare_places(const void *left, const void *right) {
    const ref_dyn_i_place *p = left, *q = right;
    if (p->backdrop != q->backdrop)
        return p->backdrop ? -1 : 1;
    if (p->depth < q->depth || p->depth > q->depth)
        return p->depth > q->depth ? -1 : 1;
    if (p->group_id != q->group_id)
        return p->group_id > q->group_id ? -1 : 1;
    if (p->rank != q->rank)
        return p->rank < q->rank ? -1 : 1;
    return p->id > q->id ? -1 : p->id < q->id;
}

static inline bool ref_dyn_i_sort_objects(ref_dyn_i_world *world) {
    const ref_scene *scene = world->dynamic->scene;
    size_t count = scene->object_count;
    world->position = calloc(count + 1, sizeof *world->position);
    ref_dyn_i_place *places = calloc(count + 1, sizeof *places);
    double *middles = calloc(count + 1, sizeof *middles);
    bool ok = world->position && places && middles;
    for (size_t o = 0; ok && o < count; ++o)
        middles[o] = ref_dyn_i_middle(scene, &scene->objects[o]);
    for (size_t o = 0; ok && o < count; ++o) {
        const ref_dyn_object *own = &world->dynamic->objects[o];
        ref_dyn_i_place place = {ref_dyn_i_is(world, (uint32_t)o, REF_DYN_BACKDROP),
                                 0,
                                 UINT32_MAX,
                                 own->rank,
                                 scene->objects[o].id,
                                 (uint32_t)o};
        size_t members = 0;
        for (size_t i = 0; i < count; ++i)
            if (i == o || (own->group != 0 && world->dynamic->objects[i].group == own->group)) {
                place.depth += middles[i];
                place.group_id = scene->objects[i].id < place.group_id ? scene->objects[i].id : place.group_id;
                ++members;
            }
        place.depth /= (double)members;
        places[o] = place;
    }
    if (ok)
        qsort(places, count, sizeof *places, ref_dyn_i_compare_places);
    for (size_t i = 0; ok && i < count; ++i)
        world->position[places[i].object] = (uint32_t)i;
    free(places);
    free(middles);
    return ok;
}

/* ---- layers of a pixel ---- */

static inline uint32_t ref_dyn_i_object(const ref_dyn_i_world *world, const ref_i_hit *hit) {
    return world->rays.triangles[hit->triangle].object;
}

/* Which of two hits at the same depth lies nearer to the eye. */
static inline bool ref_dyn_i_over(const ref_dyn_i_world *world, const ref_i_hit *a, const ref_i_hit *b) {
    uint32_t p = ref_dyn_i_object(world, a), q = ref_dyn_i_object(world, b);
    const ref_dyn_object *first = &world->dynamic->objects[p], *second = &world->dynamic->objects[q];
    if (p == q)
        return a->triangle < b->triangle;
    if ((first->flags ^ second->flags) & REF_DYN_TARGET)
        return first->flags & REF_DYN_TARGET;
    if (first->group != 0 && first->group == second->group && first->rank != second->rank)
        return first->rank > second->rank;
    return world->dynamic->scene->objects[p].id < world->dynamic->scene->objects[q].id;
}

/* Moves the hit that is in front of all from `at` on to `at`: the last painted object's nearest, or the nearest. */
static inline void ref_dyn_i_pick(ref_dyn_i_world *world, size_t at) {
    ref_i_hit *hits = world->rays.hits;
    bool centres = world->dynamic->order == REF_DYN_OBJECT_CENTRES;
    size_t least = at, best = SIZE_MAX;
    for (size_t i = at + 1; i < world->rays.hit_count; ++i) {
        uint32_t p = world->position[ref_dyn_i_object(world, &hits[i])];
        uint32_t q = world->position[ref_dyn_i_object(world, &hits[least])];
        if (centres && p != q ? p > q : hits[i].depth < hits[least].depth)
            least = i;
    }
    for (size_t i = at; i < world->rays.hit_count; ++i) {
        bool same_object = ref_dyn_i_object(world, &hits[i]) == ref_dyn_i_object(world, &hits[least]);
        if ((centres && !same_object) || ref_i_nearer(&hits[least], &hits[i]))
            continue;
        if (best == SIZE_MAX || ref_dyn_i_over(world, &hits[i], &hits[best]))
            best = i;
    }
    ref_i_hit kept = hits[at];
    hits[at] = hits[best];
    hits[best] = kept;
}

/* Puts the layers of the ray just cast first, front to back, and returns how many they are. */
static inline size_t ref_dyn_i_arrange(ref_dyn_i_world *world) {
    ref_i_hit *hits = world->rays.hits;
    size_t count = 0;
    for (size_t i = 0; i < world->rays.hit_count; ++i) {
        ref_dyn_i_pick(world, i);
        uint32_t object = ref_dyn_i_object(world, &hits[i]);
        bool seen = false;
        bool each = world->dynamic->one_mask || ref_dyn_i_is(world, object, REF_DYN_HOLLOW);
        for (size_t j = 0; !seen && j < count && !each; ++j)
            seen = ref_dyn_i_object(world, &hits[j]) == object;
        if (!seen) {
            ref_i_hit kept = hits[count];
            hits[count++] = hits[i];
            hits[i] = kept;
        }
    }
    return count;
}

/* Object-centre order paints back to front with a depth test: drops what fails it. */
static inline size_t ref_dyn_i_depth_test(ref_dyn_i_world *world, size_t count) {
    ref_i_hit *hits = world->rays.hits;
    size_t kept = count;
    const ref_i_hit *nearest = NULL;
    for (size_t i = count; i-- > 0;)
        if (!nearest || ref_i_nearer(&hits[i], nearest)) {
            hits[--kept] = hits[i];
            nearest = &hits[kept];
        }
    for (size_t i = kept; i < count; ++i)
        hits[i - kept] = hits[i];
    return count - kept;
}

static inline bool ref_dyn_i_closes(const ref_dyn_i_world *world, uint32_t object) {
    return ref_dyn_i_is(world, object, REF_DYN_IMPENETRABLE | REF_DYN_BACKDROP);
}

/* Notes where targets are, hidden or not: `count` layers, before any depth test. */
static inline bool ref_dyn_i_note_covers(ref_dyn_i_world *world, size_t count, int x, int y) {
    const ref_i_hit *hits = world->rays.hits;
    for (size_t i = 0; i < count; ++i) {
        uint32_t object = ref_dyn_i_object(world, &hits[i]);
        bool first = ref_dyn_i_is(world, object, REF_DYN_TARGET);
        for (size_t j = 0; first && j < i; ++j)
            first = ref_dyn_i_object(world, &hits[j]) != object; /* a hollow target's nearest surface stands for it */
        if (!first)
            continue;
        ref_dyn_i_cover *cover = ref_dyn_i_push(&world->covers, sizeof *cover);
        if (!cover)
            return false;
        ref_dyn_i_cover made = {object, x, y, hits[i].depth, hits[i].slack, true, false};
        for (size_t j = 0; j < count; ++j) {
            uint32_t other = ref_dyn_i_object(world, &hits[j]);
            if (!ref_i_nearer(&hits[j], &hits[i])) /* so nothing is hidden by itself */
                continue;
            made.hidden = true;
            if (ref_dyn_i_closes(world, other))
                made.open = false;
        }
        *cover = made;
    }
    return true;
}

static inline bool ref_dyn_i_gather(ref_dyn_i_world *world, int x, int y) {
    if (!ref_i_cast(&world->rays, x + 0.5, y + 0.5))
        return false;
    size_t count = ref_dyn_i_arrange(world);
    if (!ref_dyn_i_note_covers(world, count, x, y))
        return false;
    if (world->dynamic->order == REF_DYN_OBJECT_CENTRES)
        count = ref_dyn_i_depth_test(world, count);
    for (size_t i = 0; i < count; ++i) {
        ref_dyn_i_layer *layer = ref_dyn_i_push(&world->layers, sizeof *layer);
        if (!layer)
            return false;
        const ref_i_hit *hit = &world->rays.hits[i];
        layer->object = ref_dyn_i_object(world, hit);
        layer->depth = hit->depth;
        layer->slack = hit->slack;
        ref_i_color(&world->rays, hit, layer->color);
    }
    return true;
}

/* ---- masks ---- */

typedef struct ref_dyn_i_form { /* a circle, an ellipse or a convex hull in the window, pixels */
    double middle[2], radius[2];
    double (*corners)[2]; /* of the hull, counter-clockwise */
    size_t count;
} ref_dyn_i_form;

static inline int ref_dyn_i_compare_points(const void *left, const void *right) {
    const double *p = left, *q = right;
    for (int k = 0; k < 2; ++k)
        if (p[k] < q[k] || p[k] > q[k])
            return p[k] < q[k] ? -1 : 1;
    return 0;
}

static inline double ref_dyn_i_turn(const double a[2], const double b[2], const double c[2]) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Andrew's monotone chain; hull has room for 2 * count. */
static inline size_t ref_dyn_i_hull(double (*points)[2], size_t count, double (*hull)[2]) {
    size_t n = 0;
    qsort(points, count, sizeof *points, ref_dyn_i_compare_points);
    for (size_t round = 0; round < 2; ++round) {
        size_t start = n;
        for (size_t i = 0; i < count; ++i) {
            const double *p = points[round ? count - 1 - i : i];
            while (n >= start + 2 && ref_dyn_i_turn(hull[n - 2], hull[n - 1], p) <= 0)
                --n;
            memcpy(hull[n++], p, sizeof hull[0]);
        }
        --n; /* the last is the first of the other half */
    }
    return n > 0 ? n : 1;
}

static inline double ref_dyn_i_to_segment(const double p[2], const double a[2], const double b[2]) {
    double e[2] = {b[0] - a[0], b[1] - a[1]}, v[2] = {p[0] - a[0], p[1] - a[1]}, square = e[0] * e[0] + e[1] * e[1];
    double t = square > 0 ? ref_i_clamp01((v[0] * e[0] + v[1] * e[1]) / square) : 0;
    return hypot(v[0] - t * e[0], v[1] - t * e[1]);
}

/* How many pixels outside of the form a point lies; 0 within. */
static inline double ref_dyn_i_beyond(const ref_dyn_i_form *form, ref_dyn_shape shape, const double p[2]) {
    double v[2] = {p[0] - form->middle[0], p[1] - form->middle[1]}, least = REF_NONE;
    bool inside = form->count > 2;
    if (shape == REF_DYN_CIRCLE)
        return fmax(hypot(v[0], v[1]) - form->radius[0], 0);
    if (shape == REF_DYN_ELLIPSE) { /* along the ray from the middle: no closed form gives the true distance */
        double far[2] = {form->radius[0] > 0 ? v[0] / form->radius[0] : 0,
                         form->radius[1] > 0 ? v[1] / form->radius[1] : 0};
        double size = hypot(far[0], far[1]);
        return size > 1 ? hypot(v[0], v[1]) * (1 - 1 / size) : 0;
    }
    for (size_t i = 0; i < form->count; ++i) {
        const double *a = form->corners[i], *b = form->corners[(i + 1) % form->count];
        inside = inside && ref_dyn_i_turn(a, b, p) >= 0;
        least = fmin(least, ref_dyn_i_to_segment(p, a, b));
    }
    return inside ? 0 : least;
}

/* The points that the form of a target encloses: those given, projected, without those behind the eye; where none is
 * left, the centres of its open pixels. */
static inline size_t ref_dyn_i_points(const ref_dyn_i_world *world, const ref_dyn_i_cover *open, size_t count,
                                      double (*points)[2]) {
    const ref_scene *scene = world->dynamic->scene;
    const ref_dyn_object *object = &world->dynamic->objects[open[0].object];
    size_t n = 0;
    for (size_t i = 0; object->enclose && i < object->enclose_count; ++i) {
        const double *p = object->enclose[i], *v = scene->view, *m = scene->projection;
        double eye[4] = {0, 0, 0, 1}, clip[4];
        for (int r = 0; r < 3; ++r)
            eye[r] = v[r] * p[0] + v[4 + r] * p[1] + v[8 + r] * p[2] + v[12 + r];
        for (int r = 0; r < 4; ++r)
            clip[r] = m[r] * eye[0] + m[4 + r] * eye[1] + m[8 + r] * eye[2] + m[12 + r] * eye[3];
        if (!(clip[3] > 0))
            continue;
        points[n][0] = (clip[0] / clip[3] + 1) * scene->width / 2;
        points[n++][1] = (clip[1] / clip[3] + 1) * scene->height / 2;
    }
    if (n > 0)
        return n;
    for (; n < count; ++n) {
        points[n][0] = open[n].x + 0.5;
        points[n][1] = open[n].y + 0.5;
    }
    return n;
}

static inline void ref_dyn_i_make_form(ref_dyn_i_form *form, ref_dyn_shape shape, double (*points)[2], size_t count) {
    double low[2] = {REF_NONE, REF_NONE}, high[2] = {-REF_NONE, -REF_NONE}, scale = 0;
    for (size_t i = 0; i < count; ++i)
        for (int k = 0; k < 2; ++k) {
            low[k] = fmin(low[k], points[i][k]);
            high[k] = fmax(high[k], points[i][k]);
        }
    for (int k = 0; k < 2; ++k) {
        form->middle[k] = (low[k] + high[k]) / 2;
        form->radius[k] = shape == REF_DYN_CIRCLE ? 1 : (high[k] - low[k]) / 2;
    }
    for (size_t i = 0; i < count; ++i) {
        double v[2];
        for (int k = 0; k < 2; ++k)
            v[k] = form->radius[k] > 0 ? (points[i][k] - form->middle[k]) / form->radius[k] : 0;
        scale = fmax(scale, hypot(v[0], v[1]));
    }
    for (int k = 0; k < 2; ++k)
        form->radius[k] *= scale;
    if (shape == REF_DYN_HULL)
        form->count = ref_dyn_i_hull(points, count, form->corners);
}

/* The nearest of the open pixels. */
static inline const ref_dyn_i_cover *ref_dyn_i_nearest_open(const ref_dyn_scene *dynamic, const ref_dyn_i_cover *open,
                                                            size_t count, int x, int y, double *distance) {
    const ref_dyn_i_cover *best = NULL;
    long least = 0;
    for (size_t i = 0; i < count; ++i) {
        long dx = labs((long)x - open[i].x), dy = labs((long)y - open[i].y), far = dx > dy ? dx : dy;
        long size = dynamic->growth == REF_DYN_RINGS ? far : dx * dx + dy * dy;
        if (!best || size < least || (size == least && open[i].depth < best->depth)) {
            best = &open[i];
            least = size;
        }
    }
    *distance = dynamic->growth == REF_DYN_RINGS ? (double)least : sqrt((double)least);
    return best;
}

/* Of each cell from `first` on, `across` by `up` of them, the open pixel that is nearest to the cell's middle; of a row's
 * the nearest along it, which matters where distances are counted in rings. The pixels come row by row. */
static inline void ref_dyn_i_look_from_cells(const ref_dyn_scene *dynamic, const int first[2], int across, int up,
                                             const ref_dyn_i_cover *open, size_t count, const ref_dyn_i_cover **seeds) {
    for (int i = 0; i < across * up; ++i) {
        long cell = dynamic->cell,
             middle[2] = {2 * cell * (first[0] + i % across) + cell, 2 * cell * (first[1] + i / across) + cell};
        long least = 0, least_across = 0; /* twice the places are integers */
        const ref_dyn_i_cover *of_row = NULL;
        seeds[i] = NULL;
        for (size_t k = 0; k < count; ++k) {
            long dx = labs(2L * open[k].x + 1 - middle[0]), dy = labs(2L * open[k].y + 1 - middle[1]);
            if (!of_row || dx < least_across || (dx == least_across && open[k].depth < of_row->depth)) {
                of_row = &open[k];
                least_across = dx;
            }
            if (k + 1 < count && open[k + 1].y == open[k].y)
                continue;
            long far = least_across > dy ? least_across : dy;
            long size = dynamic->growth == REF_DYN_RINGS ? far : least_across * least_across + dy * dy;
            if (!seeds[i] || size < least || (size == least && of_row->depth < seeds[i]->depth)) {
                seeds[i] = of_row;
                least = size;
            }
            of_row = NULL;
        }
    }
}

/* The nearest open pixel to each of the mask's, or NULL: out of memory. */
static inline const ref_dyn_i_cover **ref_dyn_i_find_nearest(const ref_dyn_scene *dynamic, const ref_dyn_i_mask *mask,
                                                             const ref_dyn_i_cover *open, size_t count) {
    int width = mask->x1 - mask->x0, height = mask->y1 - mask->y0, cell = dynamic->cell > 1 ? dynamic->cell : 1;
    int first[2] = {mask->x0 / cell - 1, mask->y0 / cell - 1}, across = width / cell + 4, up = height / cell + 4;
    const ref_dyn_i_cover **nearest = calloc((size_t)width * (size_t)height + 1, sizeof *nearest);
    const ref_dyn_i_cover **seeds = calloc((size_t)across * (size_t)up, sizeof *seeds), *four[4];
    if (nearest && seeds && cell > 1)
        ref_dyn_i_look_from_cells(dynamic, first, across, up, open, count, seeds);
    for (int i = 0; nearest && seeds && i < width * height; ++i) {
        int x = mask->x0 + i % width, y = mask->y0 + i / width;
        double distance;
        nearest[i] = ref_dyn_i_nearest_open(dynamic, open, count, x, y, &distance);
        if (cell == 1 || distance <= 0)
            continue;
        nearest[i] = NULL;
        for (int k = 0; k < 4; ++k) { /* the cells whose middles are around: half a cell to each side */
            int column = (int)floor((x + 0.5) / cell - 0.5) + k % 2, row = (int)floor((y + 0.5) / cell - 0.5) + k / 2;
            int last[2] = {(dynamic->scene->width - 1) / cell, (dynamic->scene->height - 1) / cell};
            column = column < 0 ? 0 : column > last[0] ? last[0] : column;
            row = row < 0 ? 0 : row > last[1] ? last[1] : row;
            four[k] = seeds[(row - first[1]) * across + column - first[0]];
        }
        for (int k = 0; k < 4; ++k) {
            double other, own = 0;
            if (nearest[i])
                ref_dyn_i_nearest_open(dynamic, nearest[i], 1, x, y, &own);
            ref_dyn_i_nearest_open(dynamic, four[k], 1, x, y, &other);
            if (!nearest[i] || other < own || (other <= own && four[k]->depth < nearest[i]->depth))
                nearest[i] = four[k];
        }
    }
    free(seeds);
    if (!seeds) {
        free(nearest);
        return NULL;
    }
    return nearest;
}

static inline bool ref_dyn_i_fill_mask(const ref_dyn_scene *dynamic, ref_dyn_i_mask *mask, const ref_dyn_i_form *form,
                                       const ref_dyn_i_cover *open, size_t count) {
    const ref_dyn_i_cover **nearest = ref_dyn_i_find_nearest(dynamic, mask, open, count);
    for (int y = mask->y0; nearest && y < mask->y1; ++y)
        for (int x = mask->x0; x < mask->x1; ++x) {
            size_t i = (size_t)(y - mask->y0) * (size_t)(mask->x1 - mask->x0) + (size_t)(x - mask->x0);
            double distance, beyond, centre[2] = {x + 0.5, y + 0.5};
            const ref_dyn_i_cover *seed = ref_dyn_i_nearest_open(dynamic, nearest[i], 1, x, y, &distance);
            bool inside = distance <= 0;
            if (dynamic->shape == REF_DYN_OUTLINE) {
                beyond = fmax(distance - 1, 0);
            } else {
                beyond = ref_dyn_i_beyond(form, dynamic->shape, centre);
                inside = inside || beyond <= 0;
            }
            ref_dyn_i_mask_pixel made = {inside ? dynamic->alpha_target : ref_dyn_gradient(dynamic, beyond),
                                         seed->depth, seed->slack, distance <= 0, seed->object};
            mask->pixels[i] = made;
        }
    free(nearest);
    return nearest != NULL;
}

/* The rectangle that the mask may cover. */
static inline void ref_dyn_i_bound_mask(const ref_dyn_scene *dynamic, ref_dyn_i_mask *mask, const ref_dyn_i_form *form,
                                        const ref_dyn_i_cover *open, size_t count) {
    double low[2] = {REF_NONE, REF_NONE}, high[2] = {-REF_NONE, -REF_NONE}, margin = dynamic->width + 2;
    double size[2] = {dynamic->scene->width, dynamic->scene->height};
    int bounds[4];
    for (size_t i = 0; i < count; ++i) {
        low[0] = fmin(low[0], open[i].x);
        low[1] = fmin(low[1], open[i].y);
        high[0] = fmax(high[0], open[i].x);
        high[1] = fmax(high[1], open[i].y);
    }
    for (int k = 0; k < 2; ++k) {
        if (dynamic->shape != REF_DYN_OUTLINE) { /* a hull lies in the ellipse as well */
            low[k] = fmin(low[k], form->middle[k] - form->radius[k]);
            high[k] = fmax(high[k], form->middle[k] + form->radius[k]);
        }
        bounds[k] = (int)fmin(fmax(floor(low[k] - margin), 0), size[k]);
        bounds[k + 2] = (int)fmin(fmax(ceil(high[k] + margin), 0), size[k]);
    }
    mask->x0 = bounds[0];
    mask->y0 = bounds[1];
    mask->x1 = bounds[2] > bounds[0] ? bounds[2] : bounds[0];
    mask->y1 = bounds[3] > bounds[1] ? bounds[3] : bounds[1];
}

/* open: the target's open pixels, at least one. */
static inline bool ref_dyn_i_make_mask(const ref_dyn_i_world *world, ref_dyn_i_mask *mask, const ref_dyn_i_cover *open,
                                       size_t count) {
    const ref_dyn_scene *dynamic = world->dynamic;
    size_t room = count + dynamic->objects[open[0].object].enclose_count;
    ref_dyn_i_form form = {{0, 0}, {0, 0}, calloc(2 * room + 2, sizeof *form.corners), 0};
    double(*points)[2] = calloc(room, sizeof *points);
    bool ok = form.corners && points;
    if (ok && dynamic->shape != REF_DYN_OUTLINE)
        ref_dyn_i_make_form(&form, dynamic->shape, points, ref_dyn_i_points(world, open, count, points));
    if (ok) {
        ref_dyn_i_bound_mask(dynamic, mask, &form, open, count);
        mask->object = open[0].object;
        mask->pixels = calloc((size_t)(mask->x1 - mask->x0) * (size_t)(mask->y1 - mask->y0) + 1, sizeof *mask->pixels);
        ok = mask->pixels != NULL;
    }
    ok = ok && ref_dyn_i_fill_mask(dynamic, mask, &form, open, count);
    free(form.corners);
    free(points);
    return ok;
}

static inline int ref_dyn_i_compare_covers(const void *left, const void *right) {
    const ref_dyn_i_cover *p = left, *q = right;
    if (p->object != q->object)
        return p->object < q->object ? -1 : 1;
    if (p->open != q->open)
        return p->open ? -1 : 1;
    if (p->y != q->y)
        return p->y < q->y ? -1 : 1;
    return p->x < q->x ? -1 : p->x > q->x;
}

static inline double ref_dyn_i_strength(const ref_dyn_object *target) {
    return ref_i_clamp01(target->importance) * (1 - ref_i_clamp01(target->faded));
}

/* One mask of all targets: of each pixel's open ones the nearest. */
static inline bool ref_dyn_i_make_one_mask(ref_dyn_i_world *world) {
    const ref_dyn_i_cover *covers = world->covers.items;
    size_t pixels = (size_t)world->dynamic->scene->width * (size_t)world->dynamic->scene->height, count = 0;
    ref_dyn_i_cover *pool = calloc(pixels, sizeof *pool);
    bool ok = pool != NULL;
    for (size_t i = 0; ok && i < world->covers.count; ++i) { /* as they were noted: pixel by pixel */
        const ref_dyn_i_cover *cover = &covers[i];
        bool same = count && pool[count - 1].x == cover->x && pool[count - 1].y == cover->y;
        if (!cover->open || ref_dyn_i_strength(&world->dynamic->objects[cover->object]) <= 0)
            continue;
        if (!same)
            pool[count++] = *cover;
        else if (cover->depth < pool[count - 1].depth)
            pool[count - 1] = *cover;
    }
    ok = ok && (!count || ref_dyn_i_make_mask(world, &world->masks[world->mask_count++], pool, count));
    free(pool);
    return ok;
}

static inline bool ref_dyn_i_make_masks(ref_dyn_i_world *world) {
    ref_dyn_i_cover *covers = world->covers.items;
    size_t count = world->covers.count;
    world->masks = calloc(world->dynamic->scene->object_count + 1, sizeof *world->masks);
    if (!world->masks)
        return false;
    for (size_t i = 0; world->dynamic->open_behind_impenetrable && i < count; ++i)
        covers[i].open = true;
    if (world->dynamic->one_mask)
        return ref_dyn_i_make_one_mask(world);
    if (count)
        qsort(covers, count, sizeof *covers, ref_dyn_i_compare_covers);
    for (size_t i = 0, n; i < count; i += n) {
        for (n = 1; i + n < count && covers[i + n].object == covers[i].object && covers[i + n].open == covers[i].open;)
            ++n;
        if (covers[i].open && !ref_dyn_i_make_mask(world, &world->masks[world->mask_count++], covers + i, n))
            return false;
    }
    return true;
}

static inline const ref_dyn_i_mask_pixel *ref_dyn_i_mask_at(const ref_dyn_i_mask *mask, int x, int y) {
    if (x < mask->x0 || x >= mask->x1 || y < mask->y0 || y >= mask->y1)
        return NULL;
    return &mask->pixels[(size_t)(y - mask->y0) * (size_t)(mask->x1 - mask->x0) + (size_t)(x - mask->x0)];
}

/* ---- a pixel's picture ---- */

/* Whether a mask acts on a layer at all. Never on its own target's, R4: none of these is before the nearest of them. */
static inline bool ref_dyn_i_acts(const ref_dyn_i_world *world, uint32_t target, const ref_dyn_i_mask_pixel *mask,
                                  const ref_dyn_i_layer *layer) {
    if (ref_dyn_i_closes(world, layer->object)) /* R3 */
        return false;
    if (ref_dyn_i_is(world, layer->object, REF_DYN_TARGET) && !mask->own && !world->dynamic->whole_masks_cut_targets)
        return false;
    if (world->dynamic->order == REF_DYN_OBJECT_CENTRES)
        return world->position[layer->object] > world->position[target];
    return layer->depth < mask->depth - (layer->slack + mask->slack);
}

/* What the mask of a target asks for at a pixel. */
static inline double ref_dyn_i_opacity(const ref_dyn_scene *dynamic, const ref_dyn_object *target,
                                       const ref_dyn_i_mask_pixel *at, int x, int y) {
    double strength = 1 - ref_i_clamp01(target->faded);
    if (target->flags & REF_DYN_ACTIVE)
        strength *= ref_dyn_light_at(dynamic, x + 0.5, y + 0.5);
    return ref_dyn_mix(1, at->value, strength);
}

/* R2: lowers alphas[i], of `count` layers front to back, by the mask of one target. */
static inline void ref_dyn_i_apply_mask(const ref_dyn_i_world *world, const ref_dyn_i_mask *mask, int x, int y,
                                        const ref_dyn_i_layer *layers, size_t count, double *alphas, double *yields) {
    const ref_dyn_scene *dynamic = world->dynamic;
    const ref_dyn_object *target = &dynamic->objects[mask->object];
    const ref_dyn_i_mask_pixel *at = ref_dyn_i_mask_at(mask, x, y);
    if (!at)
        return;
    size_t m = 0;
    for (size_t i = 0; i < count; ++i) {
        bool acts = !(dynamic->layers && m >= dynamic->layers) && ref_dyn_i_acts(world, mask->object, at, &layers[i]);
        yields[i] = acts ? ref_dyn_yield(target, &dynamic->objects[layers[i].object]) : 0;
        m += yields[i] > 0;
    }
    double g = ref_dyn_i_opacity(dynamic, target, at, x, y);
    double alpha = dynamic->occluders == REF_DYN_TOGETHER ? ref_dyn_shared(g, m) : g;
    for (size_t i = 0; i < count; ++i) {
        double own = ref_dyn_mix(1, alpha, yields[i]);
        alphas[i] = dynamic->combine == REF_DYN_MIN ? fmin(alphas[i], own) : alphas[i] * own;
    }
}

/* weights: NULL, or one an object, added to. Returns how many layers can be seen. */
static inline size_t ref_dyn_i_compose(const ref_dyn_i_world *world, const ref_dyn_i_layer *layers, size_t count,
                                       const double *alphas, double *weights, ref_dyn_pixel *out) {
    double left = 1;
    size_t seen = 0;
    memset(out, 0, sizeof *out);
    for (; seen < count && left > 0; ++seen) {
        double weight = left * alphas[seen];
        for (int k = 0; k < 3; ++k)
            out->color[k] += weight * layers[seen].color[k];
        if (weights)
            weights[layers[seen].object] += weight;
        if (ref_dyn_i_is(world, layers[seen].object, REF_DYN_TARGET))
            out->targets_weight += weight;
        out->see_through += alphas[seen] < 1;
        left *= 1 - alphas[seen];
    }
    out->background = left;
    for (int k = 0; k < 3; ++k)
        out->color[k] += left * world->dynamic->scene->background[k];
    return seen;
}

static inline void ref_dyn_i_add_layer(const ref_dyn_i_world *world, const ref_dyn_i_layer *layer, double weight,
                                       double *weights, ref_dyn_pixel *out) {
    for (int k = 0; k < 3; ++k)
        out->color[k] += weight * (layer ? layer->color[k] : world->dynamic->scene->background[k]);
    if (!layer)
        out->background += weight;
    if (layer && weights)
        weights[layer->object] += weight;
    if (layer && ref_dyn_i_is(world, layer->object, REF_DYN_TARGET))
        out->targets_weight += weight;
}

/* Whether a layer yields to the one mask: before its depth, of a distractor, which matters less than the target. */
static inline bool ref_dyn_i_yields_to_one(const ref_dyn_i_world *world, const ref_dyn_i_mask_pixel *at,
                                           const ref_dyn_i_layer *layer) {
    return !ref_dyn_i_closes(world, layer->object) && !ref_dyn_i_is(world, layer->object, REF_DYN_TARGET) &&
           layer->depth < at->depth - (layer->slack + at->slack) &&
           world->dynamic->objects[layer->object].importance < ref_dyn_i_strength(&world->dynamic->objects[at->object]);
}

/* The same under one mask for all targets: the front-most layer, over the front-most that does not yield. */
static inline size_t ref_dyn_i_compose_one(const ref_dyn_i_world *world, int x, int y, const ref_dyn_i_layer *layers,
                                           size_t count, double *weights, ref_dyn_pixel *out) {
    const ref_dyn_i_mask_pixel *at = world->mask_count ? ref_dyn_i_mask_at(&world->masks[0], x, y) : NULL;
    double through = 0;
    size_t behind = 0;
    memset(out, 0, sizeof *out);
    while (at && behind < count && ref_dyn_i_yields_to_one(world, at, &layers[behind]))
        ++behind;
    if (behind > 0) {
        const ref_dyn_object *target = &world->dynamic->objects[at->object];
        double yields = ref_dyn_i_strength(target) - world->dynamic->objects[layers[0].object].importance;
        through = (1 - at->value) * ref_i_clamp01(yields);
        if (target->flags & REF_DYN_ACTIVE)
            through *= ref_dyn_light_at(world->dynamic, x + 0.5, y + 0.5);
    }
    ref_dyn_i_add_layer(world, count ? &layers[0] : NULL, 1 - through, weights, out);
    ref_dyn_i_add_layer(world, behind < count ? &layers[behind] : NULL, through, weights, out);
    out->see_through = through > 0;
    return through > 0 && behind < count ? behind + 1 : through > 0 ? count : count > 0;
}

static inline double ref_dyn_i_weight_of(const ref_dyn_i_layer *layers, size_t count, const double *alphas,
                                         uint32_t object) {
    double left = 1, weight = 0;
    for (size_t i = 0; i < count; ++i) {
        weight += layers[i].object == object ? left * alphas[i] : 0;
        left *= 1 - alphas[i];
    }
    return weight;
}

/* Fills in which target is meant and what the census of objects wants to know; the covers of a pixel are `covers`. */
static inline void ref_dyn_i_count(const ref_dyn_i_world *world, const ref_dyn_i_cover *covers, size_t cover_count,
                                   const ref_dyn_i_layer *layers, size_t count, const double *alphas,
                                   ref_dyn_census *census, ref_dyn_pixel *out) {
    const ref_dyn_i_cover *farthest = NULL;
    for (size_t i = 0; i < cover_count; ++i) {
        double weight = ref_dyn_i_weight_of(layers, count, alphas, covers[i].object);
        if (covers[i].open && (!farthest || covers[i].depth > farthest->depth)) {
            farthest = &covers[i];
            out->target = world->dynamic->scene->objects[covers[i].object].id;
            out->target_weight = weight;
        }
        if (!census)
            continue;
        ref_dyn_census *own = &census[covers[i].object];
        ++own->pixels;
        own->hidden += covers[i].hidden;
        own->closed += !covers[i].open;
        own->weight += weight;
        own->clear += weight >= 0.3;
        own->least = covers[i].open ? fmin(own->least, weight) : own->least;
    }
}

/* Whether a ray near a corner of the pixel meets other things than its centre does: of all layers where the background
 * shows through them, else of the `seen` first. */
static inline bool ref_dyn_i_differs(ref_dyn_i_world *world, double x, double y, const ref_dyn_i_layer *layers,
                                     size_t seen, bool background, bool *failed) {
    if (!ref_i_cast(&world->rays, x, y)) {
        *failed = true;
        return true;
    }
    size_t other = ref_dyn_i_arrange(world);
    if (world->dynamic->order == REF_DYN_OBJECT_CENTRES)
        other = ref_dyn_i_depth_test(world, other);
    if (other < seen || (background && other > seen))
        return true;
    for (size_t i = 0; i < seen; ++i)
        if (ref_dyn_i_object(world, &world->rays.hits[i]) != layers[i].object)
            return true;
    return false;
}

/* ---- rendering ---- */

static inline bool ref_dyn_i_is_valid(const ref_dyn_scene *dynamic) {
    const ref_scene *scene = dynamic->scene;
    if (!ref_i_is_valid(scene) || (scene->object_count && !dynamic->objects) || !(dynamic->width >= 0) ||
        !(dynamic->width < 1e6) || !(dynamic->alpha_target >= 0 && dynamic->alpha_target <= 1) ||
        !(dynamic->alpha_start >= 0 && dynamic->alpha_start <= 1) || (dynamic->light_count && !dynamic->lights))
        return false;
    for (size_t o = 0; o < scene->object_count; ++o) {
        uint32_t flags = dynamic->objects[o].flags;
        if (scene->objects[o].transparent || ((flags & REF_DYN_TARGET) && (flags & REF_DYN_BACKDROP)))
            return false;
    }
    return true;
}

static inline bool ref_dyn_i_gather_all(ref_dyn_i_world *world) {
    const ref_scene *scene = world->dynamic->scene;
    size_t pixel = 0;
    for (int y = 0; y < scene->height; ++y)
        for (int x = 0; x < scene->width; ++x) {
            if (!ref_dyn_i_gather(world, x, y))
                return false;
            world->first[++pixel] = world->layers.count;
        }
    return true;
}

/* The covers in the order of pixels, so that each pixel finds its own. */
static inline int ref_dyn_i_compare_pixels(const void *left, const void *right) {
    const ref_dyn_i_cover *p = left, *q = right;
    if (p->y != q->y)
        return p->y < q->y ? -1 : 1;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    return p->object < q->object ? -1 : p->object > q->object;
}

static inline bool ref_dyn_i_render_pixel(ref_dyn_i_world *world, int x, int y, size_t *next_cover, double *scratch,
                                          ref_dyn_pixel *out, double *weights, ref_dyn_census *census) {
    const ref_dyn_i_cover *covers = world->covers.items;
    size_t pixel = (size_t)y * (size_t)world->dynamic->scene->width + (size_t)x, covered = *next_cover;
    size_t count = world->first[pixel + 1] - world->first[pixel];
    const ref_dyn_i_layer *layers = (const ref_dyn_i_layer *)world->layers.items + world->first[pixel];
    double *alphas = scratch, *yields = scratch + count;
    bool failed = false;
    for (size_t i = 0; i < count; ++i)
        alphas[i] = 1;
    for (size_t i = 0; i < world->mask_count && !world->dynamic->one_mask; ++i)
        ref_dyn_i_apply_mask(world, &world->masks[i], x, y, layers, count, alphas, yields);
    size_t seen = world->dynamic->one_mask ? ref_dyn_i_compose_one(world, x, y, layers, count, weights, out)
                                           : ref_dyn_i_compose(world, layers, count, alphas, weights, out);
    while (*next_cover < world->covers.count && covers[*next_cover].y == y && covers[*next_cover].x == x)
        ++*next_cover;
    ref_dyn_i_count(world, covers + covered, *next_cover - covered, layers, count, alphas, census, out);
    for (int corner = 0; corner < 4 && !out->left_out; ++corner)
        out->left_out = ref_dyn_i_differs(world, x + 0.5 + (corner % 2 ? REF_I_CORNER : -REF_I_CORNER),
                                          y + 0.5 + (corner < 2 ? -REF_I_CORNER : REF_I_CORNER), layers, seen,
                                          out->background > 0, &failed);
    return !failed;
}

static inline bool ref_dyn_i_render_all(ref_dyn_i_world *world, ref_dyn_pixel *out, double *weights,
                                        ref_dyn_census *census) {
    const ref_scene *scene = world->dynamic->scene;
    size_t pixels = (size_t)scene->width * (size_t)scene->height, most = 0, next_cover = 0;
    for (size_t i = 0; i < pixels; ++i)
        most = world->first[i + 1] - world->first[i] > most ? world->first[i + 1] - world->first[i] : most;
    double *scratch = calloc(2 * most + 2, sizeof *scratch);
    bool ok = scratch != NULL;
    if (world->covers.count)
        qsort(world->covers.items, world->covers.count, sizeof(ref_dyn_i_cover), ref_dyn_i_compare_pixels);
    for (size_t i = 0; ok && i < pixels; ++i)
        ok =
            ref_dyn_i_render_pixel(world, (int)(i % (size_t)scene->width), (int)(i / (size_t)scene->width), &next_cover,
                                   scratch, &out[i], weights ? weights + i * scene->object_count : NULL, census);
    free(scratch);
    return ok;
}

/* Fills width * height pixels, the bottom row first. weights: NULL, or object_count a pixel, what each object adds to
 * it; the background has the rest. census: NULL, or one an object; of distractors only `least` is set, to 1. False: out
 * of memory, or a scene that makes no sense. */
static inline bool ref_dyn_render(const ref_dyn_scene *dynamic, ref_dyn_pixel *out, double *weights,
                                  ref_dyn_census *census) {
    if (!ref_dyn_i_is_valid(dynamic))
        return false;
    const ref_scene *scene = dynamic->scene;
    size_t pixels = (size_t)scene->width * (size_t)scene->height;
    for (size_t i = 0; weights && i < pixels * scene->object_count; ++i)
        weights[i] = 0;
    for (size_t o = 0; census && o < scene->object_count; ++o) {
        memset(&census[o], 0, sizeof census[o]);
        census[o].least = 1;
    }
    if (pixels == 0)
        return true;
    ref_dyn_i_world world = {.dynamic = dynamic, .rays = {.scene = scene}};
    world.first = calloc(pixels + 1, sizeof *world.first);
    /* Room for one, so that a picture of nothing has arrays too. */
    bool ok = world.first && ref_dyn_i_push(&world.layers, sizeof(ref_dyn_i_layer)) &&
              ref_dyn_i_push(&world.covers, sizeof(ref_dyn_i_cover));
    world.layers.count = world.covers.count = 0;
    ok = ok && ref_i_make_world(&world.rays) && ref_dyn_i_sort_objects(&world) && ref_dyn_i_gather_all(&world) &&
         ref_dyn_i_make_masks(&world) && ref_dyn_i_render_all(&world, out, weights, census);
    for (size_t i = 0; i < world.mask_count; ++i)
        free(world.masks[i].pixels);
    free(world.masks);
    free(world.layers.items);
    free(world.covers.items);
    free(world.position);
    free(world.first);
    ref_i_free_world(&world.rays);
    return ok;
}

#endif

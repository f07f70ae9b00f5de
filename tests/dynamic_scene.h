/* dynamic_scene.h: a battlefield, or any scene made as one, as the reference of dynamic transparency sees it and as GL
 * draws it, side by side. For tests and benchmarks. */
#ifndef GLASSINE_TESTS_DYNAMIC_SCENE_H
#define GLASSINE_TESTS_DYNAMIC_SCENE_H

#include "gl_harness.h"
#include "reference_dynamic.h"

#include "battlefield.h"
#include "battlefield_gl.h"
#include "battlefield_see.h"
#include "props.h"

typedef struct dynamic_scene {
    battlefield *field;
    battlefield_gl gl;
    battlefield_see see;
    battlefield_look look;
    tr_dynamic wish; /* what the truth does not say: the rung, the mask's divisor, the frame */
    tr_light lights[TR_MAX_LIGHTS];
    ref_scene scene;
    ref_dyn_scene truth;
    ref_object *objects; /* of the parts that are not hidden, in their order */
    ref_dyn_object *marks;
    uint32_t *parts;
    size_t count;
    int x, y;      /* the viewport's corner in the target */
    bool reversed; /* depth in GL */
} dynamic_scene;

static inline void *dynamic_need(size_t bytes) {
    void *memory = calloc(1, bytes ? bytes : 1);
    assert_non_null(memory);
    return memory;
}

/* What battlefield_object says, as the reference says it. */
static inline ref_dyn_object dynamic_mark(const battlefield_object *o) {
    ref_dyn_object mark;
    memset(&mark, 0, sizeof mark);
    mark.flags = (o->flags & BATTLEFIELD_TARGET ? REF_DYN_TARGET : 0u) |
                 (o->flags & BATTLEFIELD_IMPENETRABLE ? REF_DYN_IMPENETRABLE : 0u) |
                 (o->flags & BATTLEFIELD_HOLLOW ? REF_DYN_HOLLOW : 0u) |
                 (o->flags & BATTLEFIELD_BACKDROP ? REF_DYN_BACKDROP : 0u);
    mark.importance = (double)o->importance;
    mark.group = o->group;
    mark.rank = o->rank;
    return mark;
}

/* Where parts are now, to both. Flags that a test changed in marks stay. */
static inline void dynamic_follow(dynamic_scene *d) {
    const scene *s = d->field->scene;
    for (size_t i = 0; i < d->count; ++i) {
        const scene_part *part = &s->parts[d->parts[i]];
        const scene_mesh *mesh = &s->meshes[part->mesh];
        ref_object *o = &d->objects[i];
        o->positions = mesh->positions;
        o->normals = mesh->normals;
        o->indices = mesh->indices;
        o->vertex_count = mesh->vertex_count;
        o->triangle_count = mesh->index_count / 3;
        /* As the instances have it: the reference is to judge the method, not the precision of positions. */
        for (int k = 0; k < 16; ++k)
            o->model[k] = (double)(float)part->transform[k];
        for (int k = 0; k < 3; ++k)
            o->color[k] = (double)part->color[k];
        o->id = d->parts[i] + 1;
        o->cool_to_warm = true;
    }
    battlefield_gl_move(&d->gl);
    battlefield_see_move(&d->see);
}

/* The middle by which whole objects are sorted, as the reference has it: of the box of its vertices in the world. Spheres
 * grow to hold what they held. */
static inline void dynamic_center(dynamic_scene *d) {
    for (size_t i = 0; i < d->see.unit_count; ++i) {
        tr_unit *unit = &d->see.units[i];
        const ref_object *o = NULL;
        double low[3] = {REF_NONE, REF_NONE, REF_NONE}, high[3] = {-REF_NONE, -REF_NONE, -REF_NONE}, moved = 0;
        for (size_t k = 0; k < d->count && !o; ++k)
            o = d->objects[k].id == unit->id ? &d->objects[k] : NULL;
        for (size_t v = 0; o && v < o->vertex_count; ++v)
            for (size_t r = 0; r < 3; ++r) {
                double x = o->model[12 + r];
                for (size_t c = 0; c < 3; ++c)
                    x += o->model[4 * c + r] * (double)o->positions[3 * v + c];
                low[r] = fmin(low[r], x);
                high[r] = fmax(high[r], x);
            }
        for (int k = 0; k < 3; ++k) {
            double middle = 0.5 * (low[k] + high[k]), by = middle - (double)unit->center[k];
            unit->center[k] = (float)middle;
            moved += by * by;
        }
        unit->radius += (float)sqrt(moved) + 1e-4f;
    }
}

/* What battlefield_object says now. */
static inline void dynamic_remark(dynamic_scene *d) {
    for (size_t i = 0; i < d->count; ++i)
        d->marks[i] = dynamic_mark(&d->field->objects[d->parts[i]]);
}

/* Zero is a number here, and the default there. */
static inline float dynamic_given(double value) {
    return value > 0 ? (float)value : -1.0f;
}

/* Units may have been shuffled. */
static inline const ref_dyn_object *dynamic_mark_of(const dynamic_scene *d, uint32_t part) {
    for (size_t i = 0; i < d->count; ++i)
        if (d->parts[(part + i) % d->count] == part)
            return &d->marks[(part + i) % d->count];
    fail_msg("no part %u", part);
    return NULL;
}

/* Tells the header what the truth is told. */
static inline void dynamic_agree(dynamic_scene *d) {
    const ref_dyn_scene *t = &d->truth;
    for (size_t i = 0; i < d->see.unit_count; ++i) {
        tr_unit *unit = &d->see.units[i];
        const ref_dyn_object *mark = dynamic_mark_of(d, unit->id - 1);
        unit->flags = (mark->flags & REF_DYN_TARGET ? TR_UNIT_TARGET : 0u) |
                      (mark->flags & REF_DYN_IMPENETRABLE ? TR_UNIT_IMPENETRABLE : 0u) |
                      (mark->flags & REF_DYN_HOLLOW ? TR_UNIT_HOLLOW : 0u) |
                      (mark->flags & REF_DYN_BACKDROP ? TR_UNIT_BACKDROP : 0u) |
                      (mark->flags & REF_DYN_ACTIVE ? TR_UNIT_ACTIVE : 0u);
        unit->importance = dynamic_given(mark->importance);
        unit->group = mark->group;
        unit->rank = mark->rank;
        unit->fade = (float)mark->faded;
    }
    battlefield_see_code(&d->see);
    d->wish.shape = (tr_mask_shape)t->shape;
    d->wish.combine = (tr_mask_combine)t->combine;
    d->wish.occluders = (tr_occluders)t->occluders;
    d->wish.alpha_target = dynamic_given(t->alpha_target);
    d->wish.alpha_start = dynamic_given(t->alpha_start);
    d->wish.width = dynamic_given(t->width);
    d->wish.layers = (int)t->layers;
    assert_true(t->light_count <= TR_MAX_LIGHTS);
    for (size_t i = 0; i < t->light_count; ++i) {
        d->lights[i].x = (float)t->lights[i].x;
        d->lights[i].y = (float)t->lights[i].y;
        d->lights[i].radius = (float)t->lights[i].radius;
        d->lights[i].edge = (float)t->lights[i].edge;
    }
    d->wish.lights = d->lights;
    d->wish.light_count = t->light_count;
    for (int k = 0; k < 3; ++k)
        d->wish.background[k] = d->look.background[k];
}

/* The eye, and with it everything that depends on the picture's size. */
static inline void dynamic_look(dynamic_scene *d, const double eye[3], const double at[3], double fov, int width,
                                int height) {
    double nearest = 0.3, farthest = 600;
    battlefield_look_at(&d->look, eye, at);
    battlefield_lens(&d->look, fov, width, height, nearest, farthest);
    memcpy(d->scene.view, d->look.view, sizeof d->scene.view);
    memcpy(d->scene.projection, d->look.projection, sizeof d->scene.projection);
    d->scene.width = width;
    d->scene.height = height;
}

/* Nearest is 1, farthest 0, in clip space too; the truth's depths stay as they are. */
static inline void dynamic_reverse(dynamic_scene *d) {
    double *m = d->look.projection;
    m[10] = -0.5 * (m[10] + 1);
    m[14] = -0.5 * m[14];
    d->reversed = true;
}

/* Flat: each part has its colour, unshaded. */
static inline void dynamic_shade(dynamic_scene *d, bool flat) {
    static const float none[4] = {0, 0, 0, 1};
    battlefield_look standard;
    battlefield_default_look(&standard);
    memcpy(d->look.cool, flat ? none : standard.cool, sizeof none);
    memcpy(d->look.warm, flat ? none : standard.warm, sizeof none);
    for (int k = 0; k < 3; ++k) {
        d->scene.light_direction[k] = d->look.sun[k];
        d->scene.cool[k] = (double)d->look.cool[k];
        d->scene.warm[k] = (double)d->look.warm[k];
        d->scene.background[k] = (double)d->look.background[k];
    }
    d->scene.cool_mix = (double)d->look.cool[3];
    d->scene.warm_mix = (double)d->look.warm[3];
}

/* Takes the battlefield over. */
static inline void dynamic_open(dynamic_scene *d, harness *h, battlefield *taken) {
    assert_non_null(taken);
    memset(d, 0, sizeof *d);
    d->field = taken;
    assert_true(battlefield_gl_create(&d->gl, taken, true));
    assert_true(battlefield_see_create(&d->see, h->tr, &d->gl, h->context.es, ""));
    size_t parts = taken->scene->part_count;
    d->objects = dynamic_need(parts * sizeof *d->objects);
    d->marks = dynamic_need(parts * sizeof *d->marks);
    d->parts = dynamic_need(parts * sizeof *d->parts);
    for (size_t i = 0; i < parts; ++i)
        if (!taken->scene->parts[i].hidden) {
            d->marks[d->count] = dynamic_mark(&taken->objects[i]);
            d->parts[d->count++] = (uint32_t)i;
        }
    d->scene.objects = d->objects;
    d->scene.object_count = d->count;
    ref_dyn_defaults(&d->truth);
    d->truth.scene = &d->scene;
    d->truth.objects = d->marks;
    battlefield_default_look(&d->look);
    dynamic_shade(d, false);
    dynamic_follow(d);
}

static inline void dynamic_close(dynamic_scene *d) {
    battlefield_see_destroy(&d->see);
    battlefield_gl_destroy(&d->gl);
    battlefield_destroy(d->field);
    free(d->objects);
    free(d->marks);
    free(d->parts);
    memset(d, 0, sizeof *d);
}

/* ---- small scenes ---- */

static inline battlefield *dynamic_empty_field(void) {
    battlefield *b = dynamic_need(sizeof *b);
    b->scene = scene_create();
    assert_non_null(b->scene);
    return b;
}

/* Adds a part; `transform` may be NULL. Returns its index. */
static inline size_t dynamic_add(battlefield *b, size_t mesh, const double transform[16], const float color[3],
                                 uint32_t flags) {
    char name[32];
    size_t at = b->scene->part_count;
    battlefield_object *objects = realloc(b->objects, (at + 1) * sizeof *objects);
    assert_non_null(objects);
    b->objects = objects;
    memset(&objects[at], 0, sizeof objects[at]);
    objects[at].flags = flags;
    objects[at].importance = flags & BATTLEFIELD_TARGET ? 1.0f : 0.0f;
    snprintf(name, sizeof name, "part_%zu", at);
    assert_int_equal(scene_add_part(b->scene, name, mesh, transform, color), at);
    return at;
}

/* Balls, cones, boxes and toruses, `targets` of them targets, turned at will in a box of 10 around the origin; sizes 1 to
 * 3; every fifth of the others is impenetrable where asked for. */
static inline battlefield *dynamic_random_field(uint32_t seed, size_t count, size_t targets, bool impenetrables) {
    battlefield *b = dynamic_empty_field();
    dice d = {seed};
    size_t meshes[4] = {prop_ball(b->scene, "ball", 1), prop_cone(b->scene, "cone", 1), prop_cube(b->scene, "cube", 1),
                        prop_torus(b->scene, "torus", 1)};
    for (size_t i = 0; i < count; ++i) {
        double m[16] = {0}, size = dice_between(&d, 1, 3), turn = dice_between(&d, 0, 6.28),
               lean = dice_between(&d, 0, 3);
        const double a[3] = {cos(turn), sin(turn), 0},
                     up[3] = {-sin(turn) * sin(lean), cos(turn) * sin(lean), cos(lean)};
        for (int k = 0; k < 3; ++k) {
            int p = (k + 1) % 3, q = (k + 2) % 3;
            m[k] = size * a[k];
            m[4 + k] = size * (up[p] * a[q] - up[q] * a[p]);
            m[8 + k] = size * up[k];
            m[12 + k] = dice_between(&d, -5, 5);
        }
        m[15] = 1;
        float color[3];
        for (int k = 0; k < 3; ++k)
            color[k] = (float)dice_between(&d, 0.1, 0.9);
        uint32_t flags = i < targets                               ? (uint32_t)BATTLEFIELD_TARGET
                         : impenetrables && (i - targets) % 5 == 4 ? (uint32_t)BATTLEFIELD_IMPENETRABLE
                                                                   : 0u;
        dynamic_add(b, meshes[dice_throw(&d) % 4], m, color, flags);
    }
    return b;
}

/* ---- both pictures ---- */

static inline ref_dyn_pixel *dynamic_truth(const dynamic_scene *d, ref_dyn_census *census) {
    size_t pixels = (size_t)d->scene.width * (size_t)d->scene.height;
    ref_dyn_pixel *truth = dynamic_need(pixels * sizeof *truth);
    assert_true(ref_dyn_render(&d->truth, truth, NULL, census));
    return truth;
}

/* The state in which a host draws its scene. */
static inline void dynamic_set_state(const harness *h, const dynamic_scene *d, float far_depth) {
    harness_clear(h, d->scene.background, far_depth);
    glViewport(d->x, d->y, d->scene.width, d->scene.height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(far_depth > 0 ? GL_LESS : GL_GREATER);
    glDepthMask(GL_TRUE);
    glEnable(GL_CULL_FACE);
}

static inline bool dynamic_try(harness *h, dynamic_scene *d, char *message, size_t size) {
    tr_frame frame;
    memset(&frame, 0, sizeof frame);
    frame.framebuffer = h->framebuffer;
    frame.x = d->x;
    frame.y = d->y;
    frame.width = d->scene.width;
    frame.height = d->scene.height;
    dynamic_agree(d);
    dynamic_set_state(h, d, d->reversed ? 0.0f : 1.0f);
    return battlefield_see_draw(&d->see, &d->look, &frame, &d->wish, message, size);
}

static inline void dynamic_draw(harness *h, dynamic_scene *d) {
    char message[2048] = "";
    if (!dynamic_try(h, d, message, sizeof message))
        fail_msg("%s", message);
}

/* Whether there is such a rung, for what else is wished. */
static inline bool dynamic_can(harness *h, dynamic_scene *d) {
    char message[2048] = "";
    bool quiet = h->quiet, ok;
    h->quiet = true;
    ok = dynamic_try(h, d, message, sizeof message);
    h->quiet = quiet;
    return ok && tr_get_info(h->tr).see_plan->see == d->wish.see;
}

static inline unsigned char *dynamic_read(const harness *h, const dynamic_scene *d) {
    unsigned char *pixels = dynamic_need(4 * (size_t)d->scene.width * (size_t)d->scene.height);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, d->scene.width, d->scene.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    return pixels;
}

/* ---- comparison ---- */

/* Which pixels to compare. */
typedef enum dynamic_where {
    DYNAMIC_ALL,
    DYNAMIC_NO_MASK,      /* nothing is see-through there */
    DYNAMIC_ONE_OCCLUDER, /* one layer is, before a target, and that layer is no target */
    DYNAMIC_ONE_OF_EACH   /* the same, and no other target's mask reaches there */
} dynamic_where;

typedef struct dynamic_error {
    double largest, mean,
        left_out;                 /* in 1/255, of the largest of a pixel's channels; left_out: a share of the pixels */
    size_t worst, compared, over; /* over: pixels off by more than 2/255 */
} dynamic_error;

/* Of one mask and one occluder the target keeps what it is to keep; of two masks the least counts, which is more, for
 * a mask is lowest beside its target. */
static inline bool dynamic_is_compared(const dynamic_scene *d, const ref_dyn_pixel *p, dynamic_where where) {
    bool alone = fabs(p->target_weight - (1 - d->truth.alpha_target)) < 1e-9;
    bool one_target = p->target != 0 && p->targets_weight - p->target_weight < 1e-9;
    return !p->left_out && (where != DYNAMIC_NO_MASK || p->see_through == 0) &&
           (where < DYNAMIC_ONE_OCCLUDER || (p->see_through == 1 && one_target)) &&
           (where != DYNAMIC_ONE_OF_EACH || alone);
}

/* means: four a pixel, in 1/255. */
static inline dynamic_error dynamic_compare_mean(const dynamic_scene *d, const ref_dyn_pixel *truth,
                                                 const double *means, dynamic_where where) {
    dynamic_error e = {0, 0, 0, 0, 0, 0};
    size_t count = (size_t)d->scene.width * (size_t)d->scene.height, left = 0;
    for (size_t i = 0; i < count; ++i) {
        double most = 0;
        left += truth[i].left_out;
        if (!dynamic_is_compared(d, &truth[i], where))
            continue;
        for (size_t c = 0; c < 3; ++c)
            most = fmax(most, fabs(truth[i].color[c] * 255 - means[4 * i + c]));
        ++e.compared;
        e.mean += most;
        e.over += most > 2;
        if (most > e.largest) {
            e.largest = most;
            e.worst = i;
        }
    }
    e.mean /= e.compared ? (double)e.compared : 1;
    e.left_out = count ? (double)left / (double)count : 0;
    return e;
}

static inline dynamic_error dynamic_compare(const dynamic_scene *d, const ref_dyn_pixel *truth,
                                            const unsigned char *pixels, dynamic_where where) {
    size_t count = 4 * (size_t)d->scene.width * (size_t)d->scene.height;
    double *means = dynamic_need(count * sizeof *means);
    for (size_t i = 0; i < count; ++i)
        means[i] = pixels[i];
    dynamic_error e = dynamic_compare_mean(d, truth, means, where);
    free(means);
    return e;
}

static inline void dynamic_print(const dynamic_scene *d, const char *name, const char *path, const dynamic_error *e) {
    printf("    %-30s max %6.2f mean %.3f /255 at %zu,%zu; %zu of %zu over 2; %.1f %% left out; %s\n", name, e->largest,
           e->mean, e->worst % (size_t)d->scene.width, e->worst / (size_t)d->scene.width, e->over, e->compared,
           100 * e->left_out, path);
}

/* Targets that a person may find: those of which at least 20 pixels have a weight of 0.3 or more. A proxy for the paper's
 * user study, not a study. */
typedef struct dynamic_found {
    size_t targets, without,
        with; /* of 20 pixels and more, hidden or not; found without and with dynamic transparency */
} dynamic_found;

static inline dynamic_found dynamic_find_targets(const dynamic_scene *d, const ref_dyn_census *census) {
    dynamic_found found = {0, 0, 0};
    for (size_t i = 0; i < d->count; ++i)
        if (census[i].pixels >= 20 && d->marks[i].flags & REF_DYN_TARGET) {
            ++found.targets;
            found.without += census[i].pixels - census[i].hidden >= 20;
            found.with += census[i].clear >= 20;
        }
    return found;
}

#endif

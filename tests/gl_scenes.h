/* gl_scenes.h: the scenes of the GL tests: from formulas, from the built-in models, from probes. */
#ifndef GLASSINE_TESTS_GL_SCENES_H
#define GLASSINE_TESTS_GL_SCENES_H

#include "gl_harness.h"

#include "models.h"
#include "probes.h"
#include "scene.h"

/* ---- scenes from formulas ---- */

enum { MAX_OBJECTS = 256 };

typedef struct test_scene {
    ref_scene scene;
    ref_object truths[MAX_OBJECTS];
    harness_object objects[MAX_OBJECTS];
    float *owned[MAX_OBJECTS];
    uint32_t *owned_indices[MAX_OBJECTS];
    size_t count;
} test_scene;

static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

static inline ref_object *add_object(test_scene *s, bool transparent, double r, double g, double b, double alpha) {
    assert_true(s->count < MAX_OBJECTS);
    ref_object *o = &s->truths[s->count++];
    memset(o, 0, sizeof *o);
    memcpy(o->model, identity, sizeof identity);
    o->id = (uint32_t)s->count;
    o->transparent = transparent;
    o->color[0] = r, o->color[1] = g, o->color[2] = b;
    o->alpha = alpha;
    return o;
}

/* A ball of rings by 2 rings quads; from ring 0 to the last one below `until` (1: all of it), unit radius. */
static inline void make_ball(test_scene *s, ref_object *o, double x, double y, double z, double radius, double until) {
    enum { RINGS = 24, SECTORS = 48 };
    size_t slot = (size_t)(o - s->truths);
    int rings = (int)(RINGS * until + 0.5);
    float *v = malloc((size_t)(rings + 1) * SECTORS * 6 * sizeof *v), *n = v + (rings + 1) * SECTORS * 3;
    uint32_t *t = malloc((size_t)rings * SECTORS * 6 * sizeof *t);
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < SECTORS; ++j) {
            double polar = 3.14159265358979 * i / RINGS, turn = 6.28318530717959 * j / SECTORS;
            double d[3] = {sin(polar) * cos(turn), cos(polar), -sin(polar) * sin(turn)};
            const double c[3] = {x, y, z};
            for (int k = 0; k < 3; ++k) {
                v[3 * (i * SECTORS + j) + k] = (float)(c[k] + radius * d[k]);
                n[3 * (i * SECTORS + j) + k] = (float)d[k];
            }
        }
    size_t count = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < SECTORS; ++j) {
            uint32_t a = (uint32_t)(i * SECTORS + j), b = (uint32_t)(i * SECTORS + (j + 1) % SECTORS);
            const uint32_t quad[6] = {a, a + SECTORS, b + SECTORS, a, b + SECTORS, b};
            memcpy(t + count, quad, sizeof quad);
            count += 6;
        }
    o->positions = s->owned[slot] = v;
    o->normals = n;
    o->indices = s->owned_indices[slot] = t;
    o->vertex_count = (size_t)(rings + 1) * SECTORS;
    o->triangle_count = count / 3;
}

static inline void frustum(double half, double first, double last, double out[16]) {
    const double m[16] = {1 / half,
                          0,
                          0,
                          0,
                          0,
                          1 / half,
                          0,
                          0,
                          0,
                          0,
                          -(last + first) / (last - first),
                          -1,
                          0,
                          0,
                          -2 * last * first / (last - first),
                          0};
    memcpy(out, m, sizeof m);
}

/* The eye at a distance from the origin, azimuth about y from +z, elevation above. */
static inline void look(double distance, double azimuth, double elevation, double out[16]) {
    double a = azimuth * 0.0174532925199433, e = elevation * 0.0174532925199433;
    double ca = cos(a), sa = sin(a), ce = cos(e), se = sin(e);
    const double m[16] = {ca, -se * sa, ce * sa, 0, 0, ce, se, 0, -sa, -se * ca, ce * ca, 0, 0, 0, -distance, 1};
    memcpy(out, m, sizeof m);
}

static inline void init_scene(test_scene *s, int size) {
    memset(s, 0, sizeof *s);
    s->scene.width = s->scene.height = size;
    s->scene.background[0] = s->scene.background[1] = s->scene.background[2] = 1.0;
    s->scene.opaque_weight = 0.7;
    s->scene.background_weight = 0.4;
    look(4, 25, 20, s->scene.view);
    frustum(0.5, 1, 10, s->scene.projection);
}

static inline void finish_scene(test_scene *s) {
    s->scene.objects = s->truths;
    s->scene.object_count = s->count;
    for (size_t i = 0; i < s->count; ++i) {
        s->objects[i].truth = s->truths[i];
        harness_upload(&s->objects[i], NULL);
    }
}

static inline void drop_scene(test_scene *s) {
    for (size_t i = 0; i < s->count; ++i) {
        harness_drop_object(&s->objects[i]);
        free(s->owned[i]);
        free(s->owned_indices[i]);
    }
}

/* The parts of a built-in model. */
static inline void add_model(test_scene *s, const scene *model) {
    for (size_t i = 0; i < model->part_count; ++i) {
        const scene_part *part = &model->parts[i];
        const scene_mesh *mesh = &model->meshes[part->mesh];
        bool glass = part->opacity < 1.0f;
        ref_object *o =
            add_object(s, glass, (double)part->color[0], (double)part->color[1], (double)part->color[2], 0.4);
        memcpy(o->model, part->transform, sizeof o->model);
        o->positions = mesh->positions;
        o->normals = mesh->normals;
        o->indices = mesh->indices;
        o->vertex_count = mesh->vertex_count;
        o->triangle_count = mesh->index_count / 3;
    }
}

/* Looks at the middle of a model so that it fills most of the picture. */
static inline void frame_model(test_scene *s, const scene *model) {
    double low[3], high[3], radius = 0, turn[16], shift[16];
    assert_true(scene_bounds(model, low, high));
    memcpy(shift, identity, sizeof shift);
    for (int i = 0; i < 3; ++i) {
        radius += (high[i] - low[i]) * (high[i] - low[i]) / 4;
        shift[12 + i] = -(low[i] + high[i]) / 2;
    }
    radius = sqrt(radius);
    look(3 * radius, 25, 20, turn);
    harness_multiply(turn, shift, s->scene.view);
    frustum(0.36, radius, 6 * radius, s->scene.projection);
}

/* ---- the scenes by name ---- */

static inline void shells(test_scene *s) {
    make_ball(s, add_object(s, true, 0.3, 0.5, 0.9, 0.5), 0, 0, 0, 1.5, 1);
    make_ball(s, add_object(s, true, 0.9, 0.5, 0.3, 0.4), 0, 0, 0, 1.0, 1);
    make_ball(s, add_object(s, false, 0.1, 0.6, 0.1, 1), 0, 0, 0, 0.5, 1);
    make_ball(s, add_object(s, false, 0.7, 0.1, 0.6, 1), 0.3, 0.3, 1.2, 0.15, 1);
    make_ball(s, add_object(s, false, 0.1, 0.1, 0.1, 1), 1.0, 0.8, 0.9, 0.3, 1);
}

static inline void intersecting(test_scene *s) {
    make_ball(s, add_object(s, true, 0.3, 0.5, 0.9, 0.5), -0.5, 0, 0, 1.0, 1);
    make_ball(s, add_object(s, true, 0.9, 0.5, 0.3, 0.4), 0.5, 0, 0.2, 1.0, 1);
    make_ball(s, add_object(s, false, 0.1, 0.6, 0.1, 1), 0, 0, 0.2, 0.25, 1);
    make_ball(s, add_object(s, false, 0.7, 0.1, 0.6, 1), -0.9, 0.2, 0, 0.3, 1);
    make_ball(s, add_object(s, false, 0.1, 0.1, 0.1, 1), 0.9, -0.2, 0.2, 0.3, 1);
}

static inline void eye_inside(test_scene *s) {
    make_ball(s, add_object(s, true, 0.3, 0.5, 0.9, 0.5), 0, 0, 4, 2.5, 1);
    make_ball(s, add_object(s, true, 0.9, 0.5, 0.3, 0.4), 0.4, 0, 0, 1.0, 1);
    make_ball(s, add_object(s, false, 0.1, 0.6, 0.1, 1), 0.4, 0, 0, 0.4, 1);
    make_ball(s, add_object(s, false, 0.7, 0.1, 0.6, 1), -0.5, 0.4, 2, 0.2, 1);
    look(4, 0, 0, s->scene.view);
    frustum(0.5, 0.1, 10, s->scene.projection);
}

static inline void open_sheet(test_scene *s) {
    ref_object *bowl = add_object(s, true, 0.3, 0.5, 0.9, 0.5);
    make_ball(s, bowl, 0, 0, 0, 1.4, 0.6);
    bowl->two_sided = true;
    make_ball(s, add_object(s, true, 0.9, 0.5, 0.3, 0.4), 0, -0.3, 0, 0.8, 1);
    make_ball(s, add_object(s, false, 0.1, 0.6, 0.1, 1), 0, 0.9, 0, 0.3, 1);
    make_ball(s, add_object(s, false, 0.6, 0.6, 0.1, 1), 0, -1, -1, 0.5, 1);
    look(4, 10, -35, s->scene.view);
}

static inline void lone_sheet(test_scene *s) {
    ref_object *bowl = add_object(s, true, 0.3, 0.5, 0.9, 0.5);
    make_ball(s, bowl, 0, 0, 0, 1.4, 0.6);
    bowl->two_sided = true;
    ref_object *lid = add_object(s, false, 0.6, 0.6, 0.1, 1);
    make_ball(s, lid, 0, 0, 0, 0.9, 0.5);
    lid->two_sided = true;
    look(4, 10, -35, s->scene.view);
}

static inline void coincident(test_scene *s) {
    make_ball(s, add_object(s, true, 0.3, 0.5, 0.9, 0.5), 0, 0, 0, 1.3, 1);
    make_ball(s, add_object(s, true, 0.9, 0.5, 0.3, 0.4), 0, 0, 0, 1.3, 1);
    make_ball(s, add_object(s, false, 0.1, 0.6, 0.1, 1), 0, 0, 0, 0.6, 1);
}

static inline void mirrored(test_scene *s) {
    shells(s);
    for (size_t i = 0; i < s->count; i += 2) {
        s->truths[i].model[0] = -1.0;
        s->truths[i].model[5] = 0.8;
        s->truths[i].model[12] = 0.2;
    }
}

static inline void only_glass(test_scene *s) {
    make_ball(s, add_object(s, true, 0.3, 0.5, 0.9, 0.5), -0.5, 0, 0, 1.0, 1);
    make_ball(s, add_object(s, true, 0.9, 0.5, 0.3, 0.0), 0.5, 0, 0.2, 1.0, 1);
}

static inline void only_opaque(test_scene *s) {
    make_ball(s, add_object(s, false, 0.3, 0.5, 0.9, 1), -0.5, 0, 0, 1.0, 1);
}

typedef struct named_scene {
    const char *name;
    void (*make)(test_scene *);
    int passes; /* of the plan in the default interior; that which the test is about has run */
} named_scene;

static const named_scene named_scenes[] = {
    {"nested shells", shells, 5},     {"intersecting shells", intersecting, 5},
    {"eye inside", eye_inside, 5},    {"open sheet", open_sheet, 8},
    {"a sheet alone", lone_sheet, 3}, {"coincident shells", coincident, 5},
    {"mirrored models", mirrored, 5}, {"only glass", only_glass, 3},
    {"only opaque", only_opaque, 2},
};
enum { NAMED_SCENES = sizeof named_scenes / sizeof named_scenes[0] };

/* ---- probe scenes ---- */

static inline void add_probe_object(test_scene *s, const probe_object *p) {
    ref_object *o = add_object(s, p->transparent, p->color[0], p->color[1], p->color[2], p->alpha);
    size_t slot = s->count - 1, vertices = 0, triangles = 0;
    float *v = malloc((size_t)p->polygon_count * 24 * sizeof *v);
    uint32_t *t = malloc((size_t)p->polygon_count * 18 * sizeof *t);
    o->id = p->id;
    o->two_sided = p->two_sided;
    for (int i = 0; i < p->polygon_count; ++i) {
        const probe_polygon *polygon = &p->polygons[i];
        for (int c = 2; c < polygon->count; ++c) {
            t[3 * triangles] = (uint32_t)vertices;
            t[3 * triangles + 1] = (uint32_t)vertices + (uint32_t)c - 1;
            t[3 * triangles++ + 2] = (uint32_t)vertices + (uint32_t)c;
        }
        for (int c = 0; c < polygon->count; ++c, ++vertices)
            for (int k = 0; k < 3; ++k)
                v[3 * vertices + (size_t)k] = (float)polygon->vertices[c][k];
    }
    o->positions = s->owned[slot] = v;
    o->indices = s->owned_indices[slot] = t;
    o->vertex_count = vertices;
    o->triangle_count = triangles;
}

static inline void set_probe_camera(test_scene *s, const probe_camera *camera) {
    const double *rows[3] = {camera->right, camera->up, camera->toward};
    double n = camera->near_distance, f = camera->far_distance;
    memset(s->scene.view, 0, sizeof s->scene.view);
    s->scene.view[15] = 1;
    for (int row = 0; row < 3; ++row)
        for (int k = 0; k < 3; ++k) {
            s->scene.view[4 * k + row] = rows[row][k];
            s->scene.view[12 + row] -= rows[row][k] * camera->eye[k];
        }
    if (camera->perspective) {
        frustum(camera->half_width, n, f, s->scene.projection);
    } else {
        const double h = camera->half_width;
        const double m[16] = {1 / h, 0, 0, 0, 0, 1 / h, 0, 0, 0, 0, -2 / (f - n), 0, 0, 0, -(f + n) / (f - n), 1};
        memcpy(s->scene.projection, m, sizeof m);
    }
}

#endif

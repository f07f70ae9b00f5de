/* stage.h: a model of the examples as objects of transparency.h and of the reference, for benchmarks. */
#ifndef GLASSINE_BENCH_STAGE_H
#define GLASSINE_BENCH_STAGE_H

#include "../tests/gl_harness.h"

#include "scene.h"

enum { MAX_PARTS = 256 };

typedef struct stage {
    ref_scene scene;
    ref_object truths[MAX_PARTS];
    harness_object objects[MAX_PARTS];
    size_t count, triangles;
} stage;

/* Seen from the front, a little from above, so that the model fills the picture. */
static inline void stage_look_at(stage *s, const scene *model) {
    double low[3], high[3], radius = 0, center[3];
    scene_bounds(model, low, high);
    for (int k = 0; k < 3; ++k) {
        center[k] = 0.5 * (low[k] + high[k]);
        radius += 0.25 * (high[k] - low[k]) * (high[k] - low[k]);
    }
    radius = sqrt(radius);
    const double c = 0.906, r = 0.423; /* 25 degrees about x, after 25 about y */
    const double rows[3][3] = {{c, 0, -r}, {-r * r, c, -c * r}, {c * r, r, c * c}};
    memset(s->scene.view, 0, sizeof s->scene.view);
    for (int row = 0; row < 3; ++row) {
        s->scene.view[12 + row] = row == 2 ? -3 * radius : 0;
        for (int k = 0; k < 3; ++k) {
            s->scene.view[4 * k + row] = rows[row][k];
            s->scene.view[12 + row] -= rows[row][k] * center[k];
        }
    }
    s->scene.view[15] = 1;
    const double n = radius, f = 6 * radius, half = 0.36;
    const double projection[16] = {
        1 / half, 0, 0, 0, 0, 1 / half, 0, 0, 0, 0, -(f + n) / (f - n), -1, 0, 0, -2 * f * n / (f - n), 0};
    memcpy(s->scene.projection, projection, sizeof projection);
}

static inline void stage_set(stage *s, const scene *model) {
    memset(s, 0, sizeof *s);
    for (size_t i = 0; i < model->part_count && s->count < MAX_PARTS; ++i) {
        const scene_part *part = &model->parts[i];
        const scene_mesh *mesh = &model->meshes[part->mesh];
        ref_object *o = &s->truths[s->count++];
        memcpy(o->model, part->transform, sizeof o->model);
        for (int k = 0; k < 3; ++k)
            o->color[k] = (double)part->color[k];
        o->id = (uint32_t)s->count;
        o->transparent = part->opacity < 1.0f;
        o->alpha = 0.5;
        o->positions = mesh->positions;
        o->normals = mesh->normals;
        o->indices = mesh->indices;
        o->vertex_count = mesh->vertex_count;
        o->triangle_count = mesh->index_count / 3;
        s->triangles += o->triangle_count;
    }
    for (size_t i = 0; i < s->count; ++i) {
        s->objects[i].truth = s->truths[i];
        harness_upload(&s->objects[i], NULL);
    }
    for (int k = 0; k < 3; ++k)
        s->scene.background[k] = 1;
    s->scene.blending = REF_BLEND_OVER;
    s->scene.objects = s->truths;
    s->scene.object_count = s->count;
    stage_look_at(s, model);
}

static inline void stage_make_opaque(stage *s, bool opaque) {
    for (size_t i = 0; i < s->count; ++i) {
        s->truths[i].transparent = !opaque && s->objects[i].truth.alpha < 0.75;
        s->objects[i].object.flags = s->truths[i].transparent ? (uint32_t)TR_TRANSPARENT : 0u;
    }
}

static inline void stage_clear(stage *s) {
    for (size_t i = 0; i < s->count; ++i)
        harness_drop_object(&s->objects[i]);
}

#endif

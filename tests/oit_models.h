/* oit_models.h: models of the examples as scenes of oit_scene.h, all of glass. */
#ifndef GLASSINE_TESTS_OIT_MODELS_H
#define GLASSINE_TESTS_OIT_MODELS_H

#include "oit_scene.h"

#include "scene.h"

static inline void *oit_scene_copy(const void *from, size_t bytes) {
    void *to = malloc(bytes + 1);
    if (from)
        memcpy(to, from, bytes);
    return to;
}

/* Seen from the front, a little aside and above, so that the model fills most of the picture. */
static inline void oit_scene_look_at(oit_scene *s, const scene *model) {
    double low[3], high[3], radius = 0, center[3], turn[16];
    assert_true(scene_bounds(model, low, high));
    for (int k = 0; k < 3; ++k) {
        center[k] = 0.5 * (low[k] + high[k]);
        radius += 0.25 * (high[k] - low[k]) * (high[k] - low[k]);
    }
    radius = sqrt(radius);
    const double a = 0.4363, c = cos(a), r = sin(a);
    const double rows[3][3] = {{c, 0, -r}, {-r * r, c, -c * r}, {c * r, r, c * c}};
    oit_scene_camera(s, 3 * radius, radius, 6 * radius, 0.36);
    memcpy(turn, s->scene.view, sizeof turn);
    for (int row = 0; row < 3; ++row)
        for (int k = 0; k < 3; ++k) {
            s->scene.view[4 * k + row] = rows[row][k];
            s->scene.view[12 + row] -= rows[row][k] * center[k];
        }
}

/* All parts as glass of their own colours. */
static inline void oit_scene_of_model(oit_scene *s, const scene *model, int size) {
    oit_scene_init(s, size, size);
    oit_scene_look_at(s, model);
    for (size_t i = 0; i < model->part_count && s->count < 64; ++i) {
        const scene_part *part = &model->parts[i];
        const scene_mesh *mesh = &model->meshes[part->mesh];
        const double color[4] = {(double)part->color[0], 0.2 + 0.6 * (double)(i % 5) / 5, (double)part->color[2], 0.35};
        size_t at = oit_scene_add(s, oit_scene_copy(mesh->positions, 12 * mesh->vertex_count), NULL, mesh->vertex_count,
                                  oit_scene_copy(mesh->indices, 4 * mesh->index_count), mesh->index_count / 3, color);
        memcpy(s->truths[at].model, part->transform, sizeof part->transform);
    }
}

#endif

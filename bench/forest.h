/* forest.h: the battlefield with 500 targets of ours behind its trees, of which any number are chosen. */
#ifndef GLASSINE_BENCH_FOREST_H
#define GLASSINE_BENCH_FOREST_H

#include "../tests/dynamic_scene.h"

enum { FOREST_TARGETS = 500 };

static const double FOREST_EYE[3] = {40, -60, 22}, FOREST_AT[3] = {0, 0, 1};
static const double FOREST_FOV = 61;

static inline size_t forest_mesh_of(const battlefield *b, const char *part) {
    size_t found = scene_find_part(b->scene, part);
    assert_true(found != SIZE_MAX);
    return b->scene->parts[found].mesh;
}

/* Where the forest's eye sees a place, in units of half the picture. */
static inline bool forest_in_view(const battlefield_look *look, const double *place) {
    double eye[3];
    for (int r = 0; r < 3; ++r)
        eye[r] =
            look->view[r] * place[0] + look->view[4 + r] * place[1] + look->view[8 + r] * place[2] + look->view[12 + r];
    return eye[2] < -15 && fabs(eye[0] * look->projection[0] / eye[2]) < 0.97 &&
           fabs(eye[1] * look->projection[5] / eye[2]) < 0.97;
}

/* The battlefield, where no unit of its own is a target; 500 of ours stand behind trees, every tenth a tank. Their
 * parts come last. */
static inline battlefield *forest_make(void) {
    battlefield *b = battlefield_create(NULL);
    battlefield_look look;
    assert_non_null(b);
    battlefield_default_look(&look);
    battlefield_look_at(&look, FOREST_EYE, FOREST_AT);
    battlefield_lens(&look, FOREST_FOV, 1280, 1024, 1, 600);
    size_t own = b->scene->part_count, added = 0;
    size_t tank = forest_mesh_of(b, "battlefield/ours/tank_10"),
           soldier = forest_mesh_of(b, "battlefield/ours/soldier_10");
    for (size_t i = 0; i < own; ++i)
        b->objects[i].flags &= ~(uint32_t)BATTLEFIELD_TARGET;
    for (size_t round = 0; added < FOREST_TARGETS && round < 4; ++round)
        for (size_t i = 0; i < own && added < FOREST_TARGETS; ++i) {
            const scene_part *tree = &b->scene->parts[i];
            if (!strstr(tree->name, "forest/") || strstr(tree->name, "bush") ||
                !forest_in_view(&look, tree->transform + 12))
                continue;
            double m[16], dx = tree->transform[12] - FOREST_EYE[0], dy = tree->transform[13] - FOREST_EYE[1];
            double away = (added % 10 ? 1.2 : 4.0) + 1.3 * (double)round, length = hypot(dx, dy);
            const float sand[3] = {0.82f, 0.68f, 0.42f};
            memcpy(m, tree->transform, sizeof m);
            m[12] += away * dx / length;
            m[13] += away * dy / length;
            dynamic_add(b, added % 10 ? soldier : tank, m, sand, BATTLEFIELD_TARGET);
            ++added;
        }
    assert_int_equal(added, FOREST_TARGETS);
    return b;
}

/* The first n of the forest's targets; the others are distractors. Evenly spread over them. */
static inline void forest_choose_targets(dynamic_scene *d, size_t n) {
    size_t first = d->field->scene->part_count - FOREST_TARGETS;
    for (size_t i = 0; i < FOREST_TARGETS; ++i) {
        bool target = (i * n) / FOREST_TARGETS != ((i + 1) * n) / FOREST_TARGETS;
        d->field->objects[first + i].flags = target ? (uint32_t)BATTLEFIELD_TARGET : 0u;
        d->field->objects[first + i].importance = target ? 1.0f : 0.0f;
    }
    dynamic_remark(d);
}

#endif

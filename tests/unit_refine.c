/* unit_refine.c: dividing the triangles of a mesh. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models.h"
#include "refine.h"

static double longest_edge(const scene_mesh *m) {
    double longest = 0;
    for (size_t i = 0; i < m->index_count; ++i) {
        size_t next = i % 3 == 2 ? i - 2 : i + 1;
        double sum = 0;
        for (size_t k = 0; k < 3; ++k) {
            double d = (double)m->positions[3 * m->indices[i] + k] - (double)m->positions[3 * m->indices[next] + k];
            sum += d * d;
        }
        longest = fmax(longest, sqrt(sum));
    }
    return longest;
}

static void drop(scene_mesh *m) {
    free(m->positions);
    free(m->normals);
    free(m->colors);
    free(m->indices);
}

/* Closed meshes stay closed and keep their volume; no edge is longer than wanted; the old vertices come first. */
static void test_models_stay_closed(void **state) {
    static const char *const names[] = {"mug", "crank", "gearbox"};
    (void)state;
    for (size_t n = 0; n < 3; ++n) {
        scene *s = models_make(names[n]);
        assert_non_null(s);
        for (size_t i = 0; i < s->mesh_count && i < 12; ++i) {
            const scene_mesh *in = &s->meshes[i];
            double limit = longest_edge(in) / 5, before, after;
            scene_mesh out;
            assert_true(refine_mesh(in, limit, 4000000, &out));
            assert_true(longest_edge(&out) <= limit);
            assert_true(out.vertex_count > in->vertex_count);
            assert_memory_equal(out.positions, in->positions, in->vertex_count * 3 * sizeof(float));
            assert_true(scene_mesh_closed(in, &before));
            assert_true(scene_mesh_closed(&out, &after));
            assert_true(fabs(after - before) <= 1e-5 * before);
            drop(&out);
        }
        scene_destroy(s);
    }
}

/* The limit on triangles holds, and what is there then is still a closed mesh. */
static void test_limit_on_triangles(void **state) {
    scene *s = models_make("crank");
    scene_mesh out;
    (void)state;
    assert_true(refine_mesh(&s->meshes[0], 1e-9, 20000, &out));
    assert_true(out.index_count / 3 <= 20000);
    assert_true(scene_mesh_closed(&out, NULL));
    drop(&out);
    assert_true(refine_mesh(&s->meshes[0], 0, 20000, &out)); /* no limit on edges: nothing to do */
    assert_int_equal(out.index_count, s->meshes[0].index_count);
    drop(&out);
    scene_destroy(s);
}

/* Whether some triangle lies where triangle t does, wound the other way. */
static bool has_reverse(const scene_mesh *m, const uint32_t *places, size_t t) {
    uint32_t v[3] = {places[m->indices[t]], places[m->indices[t + 1]], places[m->indices[t + 2]]};
    for (size_t u = 0; u < m->index_count; u += 3)
        for (size_t turn = 0; turn < 3; ++turn)
            if (places[m->indices[u + turn]] == v[2] && places[m->indices[u + (turn + 1) % 3]] == v[1] &&
                places[m->indices[u + (turn + 2) % 3]] == v[0])
                return true;
    return false;
}

/* Triangles that are there twice, wound both ways, with vertices of their own and begun at another corner, are divided
 * at the same places. */
static void test_both_sides_are_divided_alike(void **state) {
    enum { TRIANGLES = 40, VERTICES = 6 * TRIANGLES };
    static float positions[3 * VERTICES], normals[3 * VERTICES];
    static uint32_t indices[VERTICES];
    uint32_t random = 1;
    scene_mesh in, out;
    (void)state;
    for (uint32_t t = 0; t < TRIANGLES; ++t)
        for (uint32_t c = 0; c < 3; ++c) {
            uint32_t front = 6 * t + c, back = 6 * t + 3 + (t + 5 - c) % 3;
            for (uint32_t k = 0; k < 3; ++k) {
                random = random * 1664525u + 1013904223u;
                positions[3 * front + k] = (float)(random >> 20) / 1024.0f + 8.0f * (float)t;
                positions[3 * back + k] = positions[3 * front + k];
            }
            indices[front] = front;
            indices[back] = back;
        }
    memset(&in, 0, sizeof in);
    in.positions = positions;
    in.normals = normals;
    in.colors = positions; /* interpolated like positions */
    in.indices = indices;
    in.vertex_count = in.index_count = VERTICES;
    assert_true(refine_mesh(&in, 1.1, 100000, &out));
    assert_memory_equal(out.positions, out.colors, out.vertex_count * 3 * sizeof(float));
    uint32_t *places = malloc(out.vertex_count * sizeof *places);
    assert_true(scene_weld(out.positions, out.vertex_count, places) < out.vertex_count);
    for (size_t t = 0; t < out.index_count; t += 3)
        assert_true(has_reverse(&out, places, t));
    free(places);
    drop(&out);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_models_stay_closed),
        cmocka_unit_test(test_limit_on_triangles),
        cmocka_unit_test(test_both_sides_are_divided_alike),
    };
    return cmocka_run_group_tests_name("unit_refine", tests, NULL, NULL);
}

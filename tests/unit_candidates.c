/* Unit tests of sil_candidates, against all edges in double: wherever a point of a triangle lies, the nearest edge of all
 * is among those that the triangle carries. */
#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "models.h"

static uint64_t random_state = 88172645463325252u;

static double random_unit(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (double)(random_state >> 11) / 9007199254740992.0;
}

/* ---- the truth ---- */

static void to_world(const float *model, const float p[3], double out[3]) {
    for (int i = 0; i < 3; ++i)
        out[i] = model ? (double)model[i] * (double)p[0] + (double)model[3 + i] * (double)p[1] +
                             (double)model[6 + i] * (double)p[2]
                       : (double)p[i];
}

static double segment_distance(const double p[3], const double a[3], const double b[3]) {
    double along = 0, square = 0, sum = 0;
    for (int i = 0; i < 3; ++i) {
        along += (p[i] - a[i]) * (b[i] - a[i]);
        square += (b[i] - a[i]) * (b[i] - a[i]);
    }
    double t = square > 0 ? along / square : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    for (int i = 0; i < 3; ++i) {
        double d = p[i] - a[i] - t * (b[i] - a[i]);
        sum += d * d;
    }
    return sqrt(sum);
}

/* ---- one mesh, one view ---- */

typedef struct bench {
    const scene_mesh *shape;
    const float *model; /* 3x3 or NULL */
    sil_mesh *mesh;
    sil_edge_tree *tree;
    sil_edge *edges;
    size_t edge_count, triangle_count, listed;
    double (*ends)[2][3]; /* of the edges, in the world */
    double size;
    uint32_t *offsets, *candidates;
} bench;

static double (*ends_of(const bench *b))[2][3] {
    double(*ends)[2][3] = malloc((b->edge_count + 1) * sizeof *ends);
    assert_non_null(ends);
    for (size_t i = 0; i < b->edge_count; ++i) {
        to_world(b->model, b->shape->positions + 3 * (size_t)b->edges[i].a, ends[i][0]);
        to_world(b->model, b->shape->positions + 3 * (size_t)b->edges[i].b, ends[i][1]);
    }
    return ends;
}

static double size_of(const bench *b) {
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, size = 0;
    for (size_t i = 0; i < b->shape->vertex_count; ++i) {
        double p[3];
        to_world(b->model, b->shape->positions + 3 * i, p);
        for (int k = 0; k < 3; ++k) {
            low[k] = p[k] < low[k] ? p[k] : low[k];
            high[k] = p[k] > high[k] ? p[k] : high[k];
        }
    }
    for (int k = 0; k < 3; ++k)
        size = high[k] - low[k] > size ? high[k] - low[k] : size;
    return size;
}

static sil_result ask(bench *b) {
    size_t needed = 0, again = 0;
    sil_result result = sil_candidates(b->tree, b->shape->positions, 0, b->shape->vertex_count, b->shape->indices,
                                       b->triangle_count, b->offsets, NULL, 0, &needed);
    if (result != SIL_OK)
        return result;
    b->candidates = malloc((needed + 1) * sizeof *b->candidates);
    assert_non_null(b->candidates);
    b->candidates[needed] = 0xabcdefu;
    assert_int_equal(sil_candidates(b->tree, b->shape->positions, 0, b->shape->vertex_count, b->shape->indices,
                                    b->triangle_count, b->offsets, b->candidates, needed, &again),
                     SIL_OK);
    assert_int_equal(again, needed);
    assert_int_equal(b->offsets[b->triangle_count], needed);
    assert_int_equal(b->candidates[needed], 0xabcdefu);
    b->listed = needed;
    return SIL_OK;
}

static void bench_open(bench *b, const scene_mesh *shape, const float *model, const sil_view *view) {
    sil_mesh_desc desc;
    sil_distance_desc distance;
    memset(b, 0, sizeof *b);
    memset(&desc, 0, sizeof desc);
    memset(&distance, 0, sizeof distance);
    b->shape = shape;
    b->model = model;
    desc.positions = shape->positions;
    desc.vertex_count = shape->vertex_count;
    desc.indices = shape->indices;
    desc.index_count = shape->index_count - shape->index_count % 3;
    if (model)
        memcpy(distance.model, model, sizeof distance.model);
    b->mesh = sil_mesh_create(&desc, NULL);
    assert_non_null(b->mesh);
    b->tree = sil_edge_tree_create(b->mesh, NULL);
    assert_non_null(b->tree);
    b->edge_count = sil_extract(b->mesh, NULL, view, SIL_SILHOUETTE | SIL_BOUNDARY, NULL, 0);
    b->edges = malloc((b->edge_count + 1) * sizeof *b->edges);
    b->triangle_count = shape->index_count / 3;
    b->offsets = malloc((b->triangle_count + 1) * sizeof *b->offsets);
    assert_true(b->edges && b->offsets);
    sil_extract(b->mesh, NULL, view, SIL_SILHOUETTE | SIL_BOUNDARY, b->edges, b->edge_count);
    assert_int_equal(sil_edge_tree_build(b->tree, NULL, b->edges, b->edge_count, &distance), SIL_OK);
    b->ends = ends_of(b);
    b->size = size_of(b);
    assert_int_equal(ask(b), SIL_OK);
}

static void bench_close(bench *b) {
    sil_edge_tree_destroy(b->tree);
    sil_mesh_destroy(b->mesh);
    free(b->edges);
    free(b->ends);
    free(b->offsets);
    free(b->candidates);
}

/* A point of the triangle; corners and edges as well as its inside. */
static void point_of(const bench *b, size_t triangle, double out[3]) {
    double corner[3][3], w[3] = {random_unit(), random_unit(), random_unit()};
    for (int i = 0; i < 3; ++i) {
        to_world(b->model, b->shape->positions + 3 * (size_t)b->shape->indices[3 * triangle + (size_t)i], corner[i]);
        if (random_unit() < 0.25)
            w[i] = 0;
    }
    double sum = w[0] + w[1] + w[2];
    for (int k = 0; k < 3; ++k)
        out[k] = sum > 0 ? (w[0] * corner[0][k] + w[1] * corner[1][k] + w[2] * corner[2][k]) / sum : corner[0][k];
}

/* The least distance to the candidates is that to all edges. Returns how far it is off, in sizes of the mesh. */
static double try_point(const bench *b, size_t triangle) {
    double p[3], least = HUGE_VAL, listed = HUGE_VAL;
    point_of(b, triangle, p);
    for (size_t i = 0; i < b->edge_count; ++i) {
        double d = segment_distance(p, b->ends[i][0], b->ends[i][1]);
        least = d < least ? d : least;
    }
    for (size_t i = b->offsets[triangle]; i < b->offsets[triangle + 1]; ++i) {
        double d = segment_distance(p, b->ends[b->candidates[i]][0], b->ends[b->candidates[i]][1]);
        listed = d < listed ? d : listed;
    }
    assert_true(b->edge_count == 0 || listed < HUGE_VAL);
    return b->edge_count ? (listed - least) / b->size : 0;
}

static bool usable(const bench *b, size_t triangle) {
    for (int c = 0; c < 3; ++c) {
        uint32_t v = b->shape->indices[3 * triangle + (size_t)c];
        if (v >= b->shape->vertex_count)
            return false;
        for (int k = 0; k < 3; ++k)
            if (!isfinite(b->shape->positions[3 * (size_t)v + (size_t)k]))
                return false;
    }
    return true;
}

static double try_points(const bench *b, size_t count) {
    double worst = 0;
    for (size_t i = 0; i < count; ++i) {
        size_t triangle = (size_t)(random_unit() * (double)b->triangle_count);
        if (!usable(b, triangle))
            continue;
        double off = try_point(b, triangle);
        worst = off > worst ? off : worst;
    }
    return worst;
}

/* What the rule "within the centre's distance plus twice the radius" would list, over some triangles; and what is. */
static void compare_with_balls(const bench *b, size_t count, double *balls, double *ours) {
    *balls = *ours = 0;
    for (size_t n = 0; n < count; ++n) {
        size_t t = (size_t)(random_unit() * (double)b->triangle_count);
        double corner[3][3], center[3], radius = 0, least = HUGE_VAL;
        if (!usable(b, t))
            continue;
        for (int i = 0; i < 3; ++i)
            to_world(b->model, b->shape->positions + 3 * (size_t)b->shape->indices[3 * t + (size_t)i], corner[i]);
        for (int k = 0; k < 3; ++k)
            center[k] = (corner[0][k] + corner[1][k] + corner[2][k]) / 3;
        for (int i = 0; i < 3; ++i) {
            double d = segment_distance(corner[i], center, center);
            radius = d > radius ? d : radius;
        }
        for (size_t i = 0; i < b->edge_count; ++i) {
            double d = segment_distance(center, b->ends[i][0], b->ends[i][1]);
            least = d < least ? d : least;
        }
        for (size_t i = 0; i < b->edge_count; ++i)
            *balls += segment_distance(center, b->ends[i][0], b->ends[i][1]) <= least + 2 * radius;
        *ours += b->offsets[t + 1] - b->offsets[t];
    }
}

static sil_view random_view(void) {
    double toward[3];
    for (int k = 0; k < 3; ++k)
        toward[k] = 2 * random_unit() - 1;
    return sil_view_orthographic(toward);
}

/* ---- tests ---- */

static void test_nearest_is_a_candidate(void **state) {
    static const float stretched[9] = {1, 0.5f, 0, 0, 3, 0, 0.25f, 0, -0.2f};
    (void)state;
    for (int n = 0; models_names[n]; ++n) {
        scene *model = models_make(models_names[n]);
        assert_non_null(model);
        double worst = 0, balls = 0, ours = 0, triangles = 0, listed = 0;
        for (size_t m = 0; m < model->mesh_count; ++m) {
            const scene_mesh *shape = &model->meshes[m];
            if (shape->index_count < 3)
                continue;
            for (int i = 0; i < 2; ++i) {
                bench b;
                double all, found;
                sil_view view = random_view();
                bench_open(&b, shape, i ? stretched : NULL, &view);
                double off = try_points(&b, 200);
                worst = off > worst ? off : worst;
                compare_with_balls(&b, 100, &all, &found);
                balls += all;
                ours += found;
                triangles += (double)b.triangle_count;
                listed += (double)b.listed;
                bench_close(&b);
            }
        }
        printf("    %-24s off by %.1e sizes, %.1f a triangle; of a sample %.3f of those by centre and radius\n",
               models_names[n], worst, triangles > 0 ? listed / triangles : 0, balls > 0 ? ours / balls : 0);
        /* Float rounding of the coordinates: the square root of a square that is off by 2e-6 of a size. */
        assert_true(worst < 1e-6);
        assert_true(ours <= balls);
        scene_destroy(model);
    }
}

/* Any range, any part of the array, indices or not, any stride: the same lists. */
static void test_ranges_and_layouts(void **state) {
    (void)state;
    scene *model = models_make("torus_knot");
    sil_view view = random_view();
    bench b;
    bench_open(&b, &model->meshes[0], NULL, &view);
    const size_t triangles = b.triangle_count, first = triangles / 3, count = triangles / 5;
    uint32_t *offsets = malloc((triangles + 1) * sizeof *offsets), *list = malloc((b.listed + 1) * sizeof *list);
    float *apart = malloc(triangles * 3 * 5 * sizeof *apart);
    size_t needed = 0;
    assert_true(offsets && list && apart);
    assert_int_equal(sil_candidates(b.tree, b.shape->positions, 0, b.shape->vertex_count, b.shape->indices + 3 * first,
                                    count, offsets, list, b.listed, &needed),
                     SIL_OK);
    assert_int_equal(needed, b.offsets[first + count] - b.offsets[first]);
    for (size_t i = 0; i <= count; ++i)
        assert_int_equal(offsets[i], b.offsets[first + i] - b.offsets[first]);
    assert_memory_equal(list, b.candidates + b.offsets[first], needed * sizeof *list);
    for (size_t i = 0; i < 3 * triangles; ++i)
        memcpy(apart + 5 * i, b.shape->positions + 3 * (size_t)b.shape->indices[i], 3 * sizeof *apart);
    assert_int_equal(sil_candidates(b.tree, apart, 5 * sizeof *apart, 3 * triangles, NULL, triangles, offsets, list,
                                    b.listed, &needed),
                     SIL_OK);
    assert_int_equal(needed, b.listed);
    assert_memory_equal(offsets, b.offsets, (triangles + 1) * sizeof *offsets);
    assert_memory_equal(list, b.candidates, needed * sizeof *list);
    list[10] = 0xabcdefu; /* too short: what fits is written, nothing else */
    assert_int_equal(
        sil_candidates(b.tree, apart, 5 * sizeof *apart, 3 * triangles, NULL, triangles, offsets, list, 10, &needed),
        SIL_OK);
    assert_int_equal(needed, b.listed);
    assert_int_equal(list[10], 0xabcdefu);
    assert_memory_equal(list, b.candidates, 10 * sizeof *list);
    free(offsets);
    free(list);
    free(apart);
    bench_close(&b);
    scene_destroy(model);
}

static void test_bad_input(void **state) {
    static const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, NAN, 0, 0, 3e38f, 3e38f, -3e38f, INFINITY, 0, 0};
    static const uint32_t indices[] = {0, 1, 2, 0, 1, 3, 0, 1, 9, 0, 1, 4, 0, 5, 1, 0, 0, 0};
    uint32_t offsets[8], list[128];
    size_t needed = 77;
    (void)state;
    scene *model = models_make("mug");
    sil_view view = random_view();
    bench b;
    bench_open(&b, &model->meshes[0], NULL, &view);
    assert_int_equal(sil_candidates(NULL, corners, 0, 6, indices, 1, offsets, list, 128, &needed),
                     SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_candidates(b.tree, NULL, 0, 6, indices, 1, offsets, list, 128, &needed), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_candidates(b.tree, corners, 0, 6, indices, 1, NULL, list, 128, &needed), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_candidates(b.tree, corners, 0, 6, indices, 1, offsets, NULL, 128, &needed),
                     SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_candidates(b.tree, corners, 0, 6, indices, 1, offsets, list, 128, NULL), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_candidates(b.tree, corners, 11, 6, indices, 1, offsets, list, 128, &needed),
                     SIL_INVALID_ARGUMENT);
    assert_int_equal(needed, 77);
    sil_edge_tree *fresh = sil_edge_tree_create(b.mesh, NULL);
    assert_int_equal(sil_candidates(fresh, corners, 0, 6, indices, 1, offsets, list, 128, &needed),
                     SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_candidates(b.tree, corners, 0, 6, indices, 6, offsets, list, 128, &needed), SIL_OK);
    assert_true(offsets[1] > 0);
    assert_int_equal(offsets[2], offsets[1]);                /* NaN */
    assert_int_equal(offsets[3], offsets[1]);                /* no such vertex */
    assert_int_equal(offsets[4] - offsets[3], b.edge_count); /* too far away to say */
    assert_int_equal(offsets[5], offsets[4]);                /* infinite */
    assert_true(offsets[6] > offsets[5]);                    /* a point */
    assert_int_equal(sil_candidates(b.tree, NULL, 0, 0, NULL, 0, offsets, NULL, 0, &needed), SIL_OK);
    assert_int_equal(needed, 0);
    /* No edges: no candidates. One edge: it is everybody's. */
    assert_int_equal(sil_edge_tree_build(fresh, NULL, NULL, 0, NULL), SIL_OK);
    assert_int_equal(sil_candidates(fresh, corners, 0, 6, indices, 1, offsets, list, 128, &needed), SIL_OK);
    assert_int_equal(needed, 0);
    assert_int_equal(sil_edge_tree_build(fresh, NULL, b.edges, 1, NULL), SIL_OK);
    assert_int_equal(sil_candidates(fresh, corners, 0, 6, indices, 1, offsets, list, 128, &needed), SIL_OK);
    assert_int_equal(needed, 1);
    assert_int_equal(list[0], 0);
    sil_edge_tree_destroy(fresh);
    bench_close(&b);
    scene_destroy(model);
}

/* Far from the origin, and with an edge of no length among the others. */
static void test_offset_and_point_edges(void **state) {
    enum { SIDE = 40 };
    scene_mesh shape;
    (void)state;
    memset(&shape, 0, sizeof shape);
    shape.vertex_count = SIDE * SIDE;
    shape.positions = malloc(shape.vertex_count * 3 * sizeof(float));
    shape.indices = malloc((size_t)(SIDE - 1) * (SIDE - 1) * 6 * sizeof(uint32_t));
    for (int y = 0; y < SIDE; ++y)
        for (int x = 0; x < SIDE; ++x) {
            float *p = shape.positions + 3 * (y * SIDE + x);
            p[0] = 1e5f + 0.25f * (float)(x == 1 ? 0 : x); /* the first two columns are at one place */
            p[1] = -1e5f + 0.25f * (float)y;
            p[2] = 7e4f + 0.0625f * (float)(x * x % 7 + y * y % 5);
        }
    for (uint32_t y = 0; y + 1 < SIDE; ++y)
        for (uint32_t x = 0; x + 1 < SIDE; ++x) {
            const uint32_t at = y * SIDE + x;
            const uint32_t quad[6] = {at, at + 1, at + SIDE, at + 1, at + SIDE + 1, at + SIDE};
            memcpy(shape.indices + shape.index_count, quad, sizeof quad);
            shape.index_count += 6;
        }
    for (int i = 0; i < 4; ++i) {
        bench b;
        sil_view view = random_view();
        bench_open(&b, &shape, NULL, &view);
        assert_true(b.edge_count > 100);
        assert_true(try_points(&b, 2000) < 1e-6);
        bench_close(&b);
    }
    free(shape.positions);
    free(shape.indices);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nearest_is_a_candidate),
        cmocka_unit_test(test_ranges_and_layouts),
        cmocka_unit_test(test_bad_input),
        cmocka_unit_test(test_offset_and_point_edges),
    };
    return cmocka_run_group_tests_name("unit_candidates", tests, NULL, NULL);
}

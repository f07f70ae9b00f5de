/* One mesh, one tree over edges, many threads: each with its own pose, or none, in every query, gives what one thread
   gives. To be run under ThreadSanitizer as well:
   clang -std=c11 -g -O1 -fsanitize=thread -I. tests/unit_threads.c -lcmocka -lm -lpthread */
#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>
#include <pthread.h>

#include "shapes.h"

enum { THREADS = 8, VIEWS = 24, ROOM = 12000, TRIANGLES = 100 };

/* What is shared, and only read. */
typedef struct shared {
    const sil_mesh *mesh;
    const shape *shape;
    const float *posed;
    sil_edge_tree *tree; /* built before the threads begin */
} shared;

/* Sums over all that the queries of one view give. */
typedef struct results {
    uint64_t sum[VIEWS];
} results;

static uint64_t mix(uint64_t sum, const void *bytes, size_t size) {
    const unsigned char *b = (const unsigned char *)bytes;
    size_t i;
    for (i = 0; i < size; ++i)
        sum = (sum ^ b[i]) * 1099511628211u;
    return sum;
}

typedef struct workspace {
    sil_edge edges[ROOM];
    sil_strip strips[ROOM];
    uint32_t vertices[2 * ROOM], nearest[ROOM], parents[3], offsets[TRIANGLES + 1], candidates[8 * ROOM];
    float distances[ROOM], along[2 * ROOM];
    sil_smooth_point points[ROOM];
    sil_ribbon_vertex ribbons[ROOM];
} workspace;

static sil_view view_of(int v) {
    return view_at(3 * cos(v), 3 * sin(v), 1.3 * cos(2 * v), (double)(v % 4 != 3));
}

static void set_matrices(sil_ribbon_desc *desc) {
    int k;
    memset(desc, 0, sizeof *desc);
    for (k = 0; k < 4; ++k)
        desc->model_view[5 * k] = desc->projection[5 * k] = 1;
    desc->projection[0] = desc->projection[5] = 0.4f;
    desc->projection[10] = -0.1f;
    desc->viewport_width = 640;
    desc->viewport_height = 480;
}

/* Smooth silhouettes and dashes along them, which remember the view before; 0 where one fails. */
static uint64_t run_lines(const shared *s, sil_pose *pose, sil_dashes *dashes, workspace *w, int v) {
    static const float pattern[2] = {6, 4};
    const sil_view view = view_of(v);
    const unsigned flags = v % 2 ? SIL_SMOOTH_HERMITE : 0;
    uint64_t sum = 14695981039346656037u;
    size_t strips, needed;
    sil_ribbon_desc ribbons;
    strips = sil_smooth(s->mesh, pose, &view, NULL, 0, flags, w->points, ROOM, w->strips, ROOM, &needed);
    if (!strips || strips > ROOM || needed > ROOM)
        return 0;
    sum = mix(mix(sum, w->strips, strips * sizeof *w->strips), w->points, needed * sizeof *w->points);
    set_matrices(&ribbons);
    ribbons.points = w->points[0].position;
    ribbons.point_stride = sizeof *w->points;
    ribbons.point_count = needed;
    ribbons.dashes = pattern;
    ribbons.dash_count = 2;
    if (sil_dashes_follow(dashes, s->mesh, pose, w->strips, strips, NULL, &ribbons, w->along) != SIL_OK)
        return 0;
    return mix(sum, w->along, needed * sizeof *w->along);
}

/* Candidates of triangles from the tree that all threads share, each view with triangles of its own. */
static uint64_t run_candidates(const shared *s, workspace *w, int v) {
    size_t needed;
    if (sil_candidates(s->tree, s->shape->positions, 0, s->shape->vertex_count,
                       s->shape->indices + 3 * (size_t)(v % 16) * TRIANGLES, TRIANGLES, w->offsets, w->candidates,
                       8 * ROOM, &needed) != SIL_OK ||
        needed < TRIANGLES || needed > 8 * ROOM)
        return 0;
    return mix(mix(14695981039346656037u, w->offsets, sizeof w->offsets), w->candidates, needed * sizeof(uint32_t));
}

/* Everything that one thread may do with the mesh, for one view. pose may be NULL. */
static uint64_t run_view(const shared *s, sil_pose *pose, sil_dashes *dashes, workspace *w, int v) {
    const sil_view view = view_of(v);
    const size_t vertices = s->shape->vertex_count, half = vertices / 2;
    sil_ribbon_desc ribbons;
    sil_part parts[3];
    uint64_t sum = 14695981039346656037u, more[2];
    size_t count, strips, needed, made;
    if (pose) {
        if (sil_pose_set(pose, v % 3 ? NULL : s->posed, 0) != SIL_OK ||
            sil_pose_set_dead_zone(pose, v % 5 ? 0 : 0.1, v % 2 ? SIL_ZONE_REMEMBER : 0) != SIL_OK)
            return 0;
    }
    count = sil_extract(s->mesh, pose, v % 7 ? &view : NULL, 79, w->edges, ROOM);
    sum = mix(sum, w->edges, count * sizeof *w->edges);
    strips = sil_chain(s->mesh, pose, w->edges, count, w->strips, ROOM, w->vertices, 2 * ROOM, &needed);
    sum = mix(sum, w->strips, strips * sizeof *w->strips);
    sum = mix(sum, w->vertices, needed * sizeof *w->vertices);
    set_matrices(&ribbons);
    made = sil_ribbons(s->mesh, pose, w->strips, strips, w->vertices, &ribbons, w->ribbons, ROOM);
    sum = mix(sum, w->ribbons, (made < ROOM ? made : ROOM) / 3 * 3 * sizeof *w->ribbons);
    count = count < 300 ? count : 300;
    if (sil_distances(s->mesh, pose, w->edges, count, NULL, 0, half, w->distances, w->nearest) != SIL_OK ||
        sil_distances_by_tree(s->tree, half, vertices - half, w->distances + half, w->nearest + half) != SIL_OK)
        return 0;
    sum = mix(sum, w->distances, vertices * sizeof *w->distances);
    sum = mix(sum, w->nearest, vertices * sizeof *w->nearest);
    if (sil_distances_at(s->tree, s->shape->positions, 0, half, w->distances, w->nearest) != SIL_OK)
        return 0;
    sum = mix(sum, w->distances, half * sizeof *w->distances);
    if (v % 8 == 0) {
        memset(parts, 0, sizeof parts);
        parts[0].mesh = parts[1].mesh = parts[2].mesh = s->mesh;
        parts[1].transform[0] = parts[1].transform[5] = parts[1].transform[10] = 4;
        parts[2].component = 1;
        if (sil_containment(parts, 3, 0, w->parents, NULL) != SIL_OK ||
            sil_mesh_components(s->mesh, w->nearest, ROOM) != SIL_OK)
            return 0;
        sum = mix(sum, w->parents, sizeof w->parents);
        sum = mix(sum, w->nearest, sizeof w->nearest);
    }
    more[0] = run_lines(s, pose, dashes, w, v);
    more[1] = run_candidates(s, w, v);
    if (!more[0] || !more[1])
        return 0;
    return mix(mix(sum, more, sizeof more), &needed, sizeof needed);
}

typedef struct thread_work {
    const shared *s;
    results out;
    int has_pose, ok;
} thread_work;

static void *run_thread(void *user) {
    thread_work *t = (thread_work *)user;
    workspace *w = (workspace *)calloc(1, sizeof *w);
    sil_pose *pose = t->has_pose ? sil_pose_create(t->s->mesh, NULL) : NULL;
    sil_dashes *dashes = sil_dashes_create(NULL, NULL);
    int v;
    t->ok = w && dashes && (pose || !t->has_pose);
    for (v = 0; v < VIEWS && t->ok; ++v) {
        t->out.sum[v] = run_view(t->s, pose, dashes, w, v);
        t->ok = t->out.sum[v] != 0;
    }
    sil_dashes_destroy(dashes);
    sil_pose_destroy(pose);
    free(w);
    return NULL;
}

static void test_threads(void **state) {
    shape torus = make_torus(40, 24, 0.03, 0), posed = make_torus(40, 24, 0.06, 0);
    sil_mesh_desc desc = desc_of(&torus);
    thread_work alone[2], work[THREADS];
    pthread_t threads[THREADS];
    shared s;
    sil_edge *edges;
    size_t count;
    int i, v;
    const sil_view view = view_of(1);
    (void)state;
    desc.flags = SIL_MESH_HIERARCHY | SIL_MESH_ORIENT;
    memset(&s, 0, sizeof s);
    s.mesh = mesh_from(&desc);
    s.shape = &torus;
    s.posed = posed.positions;
    s.tree = sil_edge_tree_create(s.mesh, NULL);
    edges = extract_all(s.mesh, NULL, &view, SIL_SILHOUETTE, &count);
    assert_int_equal(sil_edge_tree_build(s.tree, NULL, edges, count, NULL), SIL_OK);
    for (i = 0; i < 2; ++i) {
        alone[i].s = &s;
        alone[i].has_pose = i;
        (void)run_thread(&alone[i]);
        assert_int_equal(alone[i].ok, 1);
    }
    for (i = 0; i < THREADS; ++i) {
        work[i].s = &s;
        work[i].has_pose = i % 4 != 3;
        assert_int_equal(pthread_create(&threads[i], NULL, run_thread, &work[i]), 0);
    }
    for (i = 0; i < THREADS; ++i)
        assert_int_equal(pthread_join(threads[i], NULL), 0);
    for (i = 0; i < THREADS; ++i) {
        assert_int_equal(work[i].ok, 1);
        for (v = 0; v < VIEWS; ++v)
            assert_true(work[i].out.sum[v] == alone[work[i].has_pose].out.sum[v]);
    }
    for (v = 1; v < VIEWS; ++v) /* the sums tell views apart */
        assert_true(alone[0].out.sum[v] != alone[0].out.sum[0]);
    free(edges);
    sil_edge_tree_destroy(s.tree);
    sil_mesh_destroy((sil_mesh *)(uintptr_t)s.mesh);
    shape_free(&torus);
    shape_free(&posed);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_threads)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

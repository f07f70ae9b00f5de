/* Unit tests of how silhouette.h tells front faces from back ones in hard views: the dead zone, and the cases that the
   product rules of the papers and of other tools fail. Build: cc -std=c11 -I. tests/unit_faces.c -lcmocka -lm */
#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

#include "shapes.h"

/* n . w / (|n| |w|) in long double, w from the middle of the corners to the eye. */
static double slope_of(const shape *s, size_t face, const double eye[4]) {
    long double p[3][3], n[3], w[3], nw = 0, nn = 0, ww = 0;
    int i, k;
    for (i = 0; i < 3; ++i)
        for (k = 0; k < 3; ++k)
            p[i][k] = (long double)s->positions[3 * (size_t)s->indices[3 * face + (size_t)i] + (size_t)k];
    for (k = 0; k < 3; ++k) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        n[k] = (p[1][a] - p[0][a]) * (p[2][b] - p[0][b]) - (p[1][b] - p[0][b]) * (p[2][a] - p[0][a]);
        w[k] = (long double)eye[k] - (long double)eye[3] * (p[0][k] + p[1][k] + p[2][k]) / 3;
    }
    for (k = 0; k < 3; ++k) {
        nw += n[k] * w[k];
        nn += n[k] * n[k];
        ww += w[k] * w[k];
    }
    return (double)(nw / sqrtl(nn * ww));
}

static sil_view turning_view(int frame, int frames, double w) {
    const double angle = 2 * SHAPES_PI * frame / frames;
    return view_at(3 * cos(angle), 3 * sin(angle), 0.7 * sin(2 * angle), w);
}

/* Signs in and outside of the zone, with memory and without, against the rule applied face by face. */
static void check_zone(const shape *s, double sine, unsigned flags, double w) {
    sil_mesh *mesh = mesh_of(s);
    sil_pose *pose = pose_of(mesh), *plain = pose_of(mesh);
    const size_t faces = s->index_count / 3;
    char *last = (char *)calloc(faces + 1, 1); /* 1: in front */
    size_t f, inside = 0, held = 0;
    int frame;
    assert_non_null(last);
    assert_int_equal(mesh->face_count, faces);
    assert_int_equal(sil_pose_set_dead_zone(pose, sine, flags), SIL_OK);
    for (frame = 0; frame < 90; ++frame) {
        const sil_view view = turning_view(frame, 90, w);
        size_t count;
        sil_edge *edges = extract_all(mesh, pose, &view, SIL_SILHOUETTE, &count);
        (void)sil_extract(mesh, plain, &view, 15, NULL, 0);
        for (f = 0; f < faces; ++f) {
            const double slope = slope_of(s, mesh->source[f], view.eye);
            int expected = slope > 0;
            if (fabs(fabs(slope) - sine) < 1e-12)
                expected = pose->front[f]; /* on the border of the zone it may be either */
            else if (fabs(slope) < sine) {
                expected = flags & SIL_ZONE_REMEMBER ? last[f] : 0;
                held += expected != plain->front[f];
                ++inside;
            } else
                assert_int_equal(expected, plain->front[f]);
            assert_int_equal(pose->front[f], expected);
            last[f] = (char)expected;
        }
        assert_int_equal(odd_vertices(edges, count, s->vertex_count), 0);
        free(edges);
    }
    assert_true(inside > 90 && held > 0);
    free(last);
    sil_pose_destroy(pose);
    sil_pose_destroy(plain);
    sil_mesh_destroy(mesh);
}

static void test_dead_zone(void **state) {
    shape torus = make_torus(24, 16, 0.02, 0), big = empty_shape();
    (void)state;
    add_shape(&big, &torus, 1e15, 3e15, 0, 0); /* squares of normals leave the range of floats */
    check_zone(&torus, 0.1, 0, 1);
    check_zone(&torus, 0.1, SIL_ZONE_REMEMBER, 1);
    check_zone(&torus, 0.01, SIL_ZONE_REMEMBER, 0);
    check_zone(&torus, 0.4, 0, 0);
    check_zone(&big, 0.2, 0, 0);
    shape_free(&torus);
    shape_free(&big);
}

/* Needles, whose float planes decide nothing, and faces at 1e-30. */
static void test_dead_zone_of_needles(void **state) {
    const float tiny = 1e-30f;
    const float positions[18] = {0, 0, 0, 1, 1e-7f, 0, 2, 1e-7f * 2.5f, 0, 5 * tiny, 0, 0, tiny, tiny, 0, 0, 0, tiny};
    const uint32_t indices[6] = {0, 2, 1, 3, 4, 5};
    shape s = empty_shape();
    size_t i;
    int round;
    (void)state;
    for (i = 0; i < 6; ++i)
        add_vertex(&s, (double)positions[3 * i], (double)positions[3 * i + 1], (double)positions[3 * i + 2]);
    for (i = 0; i < 6; i += 3)
        add_face(&s, indices[i], indices[i + 1], indices[i + 2]);
    {
        sil_mesh *mesh = mesh_of(&s);
        sil_pose *pose = pose_of(mesh);
        size_t f, front = 0;
        assert_int_equal(mesh->flat_count, 0);
        assert_int_equal(sil_pose_set_dead_zone(pose, 0.5, 0), SIL_OK);
        for (round = 0; round < 200; ++round) {
            const sil_view view = view_at(random_in(-1, 1), random_in(-1, 1), random_in(-1, 1), (double)(round % 2));
            (void)sil_extract(mesh, pose, &view, SIL_SILHOUETTE, NULL, 0);
            for (f = 0; f < 2; ++f) {
                const double slope = slope_of(&s, mesh->source[f], view.eye);
                if (fabs(slope - 0.5) > 1e-6)
                    assert_int_equal(pose->front[f], slope > 0.5);
                front += pose->front[f];
            }
        }
        assert_true(front > 40);
        sil_pose_destroy(pose);
        sil_mesh_destroy(mesh);
    }
    shape_free(&s);
}

static void *no_memory(size_t size, void *user) {
    const int *allowed = (const int *)user;
    return *allowed ? malloc(size) : NULL;
}

static void give_back_memory(void *memory, void *user) {
    (void)user;
    free(memory);
}

/* The setting itself: bad values, switching off, forgetting, meshes with a hierarchy, poses, memory that runs out. */
static void test_dead_zone_setting(void **state) {
    shape torus = make_torus(30, 20, 0.02, 0);
    sil_mesh_desc desc = desc_of(&torus);
    sil_mesh *mesh, *flat;
    sil_pose *pose, *other;
    int allowed = 1, frame;
    const sil_view nowhere = view_at(0, (double)NAN, 0, 1);
    (void)state;
    desc.allocator.alloc_fn = no_memory;
    desc.allocator.free_fn = give_back_memory;
    desc.allocator.user = &allowed;
    desc.flags = SIL_MESH_HIERARCHY;
    mesh = mesh_from(&desc);
    desc.flags = SIL_MESH_NO_HIERARCHY;
    flat = mesh_from(&desc);
    pose = pose_of(mesh);
    other = pose_of(flat);
    assert_int_equal(sil_pose_set_dead_zone(NULL, 0.1, 0), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_pose_set_dead_zone(pose, -0.1, 0), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_pose_set_dead_zone(pose, 1, 0), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_pose_set_dead_zone(pose, (double)NAN, 0), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_pose_set_dead_zone(pose, 0.1, 2), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_pose_set_dead_zone(other, 0.2, 0), SIL_OK);
    allowed = 0;
    assert_int_equal(sil_pose_set_dead_zone(other, 0.3, SIL_ZONE_REMEMBER), SIL_OUT_OF_MEMORY);
    allowed = 1;
    assert_int_equal(sil_pose_set_dead_zone(pose, 0.2, 0), SIL_OK); /* `other` still has 0.2 */
    for (frame = 0; frame < 60; ++frame) {
        const sil_view view = turning_view(frame, 60, 1);
        size_t a, b, c;
        sil_edge *first = extract_all(mesh, pose, &view, 15, &a), *second = extract_all(flat, other, &view, 15, &b);
        sil_edge *exact = extract_all(mesh, NULL, &view, 15, &c);
        assert_int_equal(a, b);
        check_same_edges(first, second, a);
        assert_true(a != c || memcmp(first, exact, a * sizeof *exact) != 0);
        free(first);
        free(second);
        free(exact);
    }
    /* A pose that was set, and one that has forgotten, see what a new one sees. */
    for (frame = 0; frame < 20; ++frame) {
        const sil_view view = turning_view(frame, 60, 1);
        sil_pose *fresh = pose_of(flat);
        size_t a, b;
        sil_edge *first, *second;
        assert_int_equal(sil_pose_set(other, torus.positions, 0), SIL_OK);
        assert_int_equal(sil_pose_set_dead_zone(fresh, 0.1, SIL_ZONE_REMEMBER), SIL_OK);
        assert_int_equal(sil_pose_set_dead_zone(other, 0.1, SIL_ZONE_REMEMBER), SIL_OK);
        assert_int_equal(sil_extract(flat, other, &nowhere, 15, NULL, 0), 0);
        first = extract_all(flat, other, &view, 15, &a);
        second = extract_all(flat, fresh, &view, 15, &b);
        assert_int_equal(a, b);
        check_same_edges(first, second, a);
        free(first);
        free(second);
        sil_pose_destroy(fresh);
    }
    assert_int_equal(sil_pose_set_dead_zone(pose, 0, 0), SIL_OK);
    for (frame = 0; frame < 20; ++frame) {
        const sil_view view = turning_view(frame, 60, 1);
        size_t a, b;
        sil_edge *first = extract_all(mesh, pose, &view, 15, &a), *exact = extract_all(flat, NULL, &view, 15, &b);
        assert_int_equal(a, b);
        check_same_edges(first, exact, a);
        free(first);
        free(exact);
    }
    sil_pose_destroy(pose);
    sil_pose_destroy(other);
    sil_mesh_destroy(mesh);
    sil_mesh_destroy(flat);
    shape_free(&torus);
}

/* Faces without area follow the face whose sign they take into the zone. */
static void test_dead_zone_of_flat_faces(void **state) {
    shape s = empty_shape();
    sil_mesh *mesh;
    sil_pose *pose;
    const sil_view low = view_at(-1, 0, 0.05, 0), high = view_at(-1, 0, 1, 0);
    (void)state;
    add_vertex(&s, 0, 0, 0);
    add_vertex(&s, 2, 0, 0);
    add_vertex(&s, 2, 2, 0);
    add_vertex(&s, 0, 2, 0);
    add_vertex(&s, 0, 1, 0);
    add_vertex(&s, -2, 1, -1);
    add_face(&s, 0, 1, 3);
    add_face(&s, 1, 2, 3);
    add_face(&s, 0, 3, 4);
    add_face(&s, 0, 4, 5);
    add_face(&s, 4, 3, 5);
    mesh = mesh_of(&s);
    pose = pose_of(mesh);
    assert_int_equal(mesh->flat_count, 1);
    assert_int_equal(sil_extract(mesh, pose, &low, SIL_SILHOUETTE, NULL, 0), 0);
    assert_int_equal(sil_pose_set_dead_zone(pose, 0.1, 0), SIL_OK);
    assert_int_equal(sil_extract(mesh, pose, &low, SIL_SILHOUETTE, NULL, 0),
                     2); /* the sheet is edge-on, the fan is not */
    assert_int_equal(sil_extract(mesh, pose, &high, SIL_SILHOUETTE, NULL, 0), 0);
    assert_int_equal(sil_pose_set_dead_zone(pose, 0.1, SIL_ZONE_REMEMBER), SIL_OK);
    assert_int_equal(sil_extract(mesh, pose, &low, SIL_SILHOUETTE, NULL, 0), 2); /* it never was outside */
    assert_int_equal(sil_extract(mesh, pose, &high, SIL_SILHOUETTE, NULL, 0), 0);
    assert_int_equal(sil_extract(mesh, pose, &low, SIL_SILHOUETTE, NULL, 0), 0); /* all remain in front */
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    shape_free(&s);
}

/* ---- the table of rules ---- */

/* Exact for small integers over 64. */
static int64_t grid_sign(const shape *s, size_t face, const double eye[4]) {
    int64_t p[3][3], det = 0;
    int i, k;
    for (i = 0; i < 3; ++i)
        for (k = 0; k < 3; ++k)
            p[i][k] = (int64_t)(64 * (double)s->positions[3 * (size_t)s->indices[3 * face + (size_t)i] + (size_t)k]);
    for (k = 0; k < 3; ++k) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        const int64_t n = (p[1][a] - p[0][a]) * (p[2][b] - p[0][b]) - (p[1][b] - p[0][b]) * (p[2][a] - p[0][a]);
        det += n * ((int64_t)(64 * eye[k]) - (int64_t)eye[3] * p[0][k]);
    }
    return (det > 0) - (det < 0);
}

typedef struct side {
    uint32_t low, high, face;
} side;

static int compare_sides(const void *a, const void *b) {
    const side *x = (const side *)a, *y = (const side *)b;
    if (x->low != y->low)
        return x->low < y->low ? -1 : 1;
    return x->high < y->high ? -1 : x->high > y->high;
}

static uint32_t first_alike(const shape *s, uint32_t v) {
    uint32_t i = 0;
    while (memcmp(s->positions + 3 * (size_t)i, s->positions + 3 * (size_t)v, 12) != 0)
        ++i;
    return i;
}

/* Edges by a rule on the product of the faces' signs; those between two edge-on faces are counted by neither. */
static size_t by_product(const shape *s, const double eye[4], int or_zero, size_t *odd) {
    side *sides = (side *)calloc(s->index_count, sizeof *sides);
    unsigned char *degree = (unsigned char *)calloc(s->vertex_count, 1);
    size_t i, found = 0;
    assert_non_null(sides);
    assert_non_null(degree);
    for (i = 0; i < s->index_count; ++i) {
        const uint32_t a = first_alike(s, s->indices[i]);
        const uint32_t b = first_alike(s, s->indices[i / 3 * 3 + (i + 1) % 3]);
        sides[i].low = a < b ? a : b;
        sides[i].high = a < b ? b : a;
        sides[i].face = (uint32_t)(i / 3);
    }
    qsort(sides, s->index_count, sizeof *sides, compare_sides);
    for (i = 0; i + 1 < s->index_count; i += 2) {
        const int64_t s0 = grid_sign(s, sides[i].face, eye), s1 = grid_sign(s, sides[i + 1].face, eye);
        assert_int_equal(compare_sides(&sides[i], &sides[i + 1]), 0);
        if (s0 * s1 < 0 || (or_zero && s0 * s1 == 0 && (s0 || s1))) {
            ++found;
            degree[sides[i].low] ^= 1;
            degree[sides[i].high] ^= 1;
        }
    }
    for (i = 0, *odd = 0; i < s->vertex_count; ++i)
        *odd += degree[i];
    free(degree);
    free(sides);
    return found;
}

static void check_rules(const char *name, const shape *s, const double eye[4], size_t published, size_t or_zero,
                        size_t ours) {
    sil_mesh *mesh = mesh_of(s);
    const sil_view view = view_at(eye[0], eye[1], eye[2], eye[3]);
    size_t odd[3], found[3];
    sil_edge *edges = extract_all(mesh, NULL, &view, SIL_SILHOUETTE, &found[2]);
    found[0] = by_product(s, eye, 0, &odd[0]);
    found[1] = by_product(s, eye, 1, &odd[1]);
    odd[2] = odd_vertices(edges, found[2], s->vertex_count);
    print_message("%s: product < 0 %zu edges (%zu vertices of odd degree), <= 0 %zu (%zu), ours %zu (%zu)\n", name,
                  found[0], odd[0], found[1], odd[1], found[2], odd[2]);
    assert_int_equal(odd[2], 0);
    if (ours) {
        assert_int_equal(found[0], published);
        assert_int_equal(found[1], or_zero);
        assert_int_equal(found[2], ours);
    } else /* no figures: a part with edge-on faces among others, where both rules leave ends */
        assert_true(odd[0] > 0 && odd[1] > 0);
    free(edges);
    sil_mesh_destroy(mesh);
}

/* The cylinder's corners on the grid, so that signs are exact integers; its sides are upright all the same. */
static void test_rules_compared(void **state) {
    const double along_z[4] = {0, 0, 1, 0}, along_x[4] = {1, 0, 0, 0};
    shape box = make_box(10, 10, 10), cylinder = make_cylinder(64, 1000, 64), part = make_torus(16, 12, 0, 8);
    size_t i;
    (void)state;
    for (i = 0; i < 3 * cylinder.vertex_count; ++i)
        cylinder.positions[i] = floorf(cylinder.positions[i] + 0.5f);
    check_rules("box along z", &box, along_z, 0, 80, 40);
    check_rules("cylinder along its axis", &cylinder, along_z, 0, 128, 64);
    check_rules("part on a coarse grid along x", &part, along_x, 0, 0, 0);
    shape_free(&box);
    shape_free(&cylinder);
    shape_free(&part);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_dead_zone),         cmocka_unit_test(test_dead_zone_of_needles),
        cmocka_unit_test(test_dead_zone_setting), cmocka_unit_test(test_dead_zone_of_flat_faces),
        cmocka_unit_test(test_rules_compared),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

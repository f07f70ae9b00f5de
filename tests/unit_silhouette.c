/* Unit tests of silhouette.h, against truths of their own: signs by big integers over differences (the header expands
   the determinant instead), edges by sorting, ribbons by the distance of every pixel, distances in long double.
   Build: cc -std=c11 -I. tests/unit_silhouette.c -lcmocka -lm */
#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "shapes.h"

static size_t count_of(const sil_mesh *mesh, double x, double y, double z, double w, unsigned kinds) {
    const sil_view view = view_at(x, y, z, w);
    return sil_extract(mesh, NULL, &view, kinds, NULL, 0);
}

/* ---- the truth about signs: big integers over differences ---- */

#define DIGITS 40 /* of 32 bits, two's complement */
typedef struct big {
    uint32_t d[DIGITS];
} big;

static big big_add(const big *a, const big *b, int subtract) {
    big sum;
    uint64_t carry = subtract ? 1 : 0;
    int i;
    for (i = 0; i < DIGITS; ++i) {
        carry += (uint64_t)a->d[i] + (subtract ? ~b->d[i] & 0xffffffffu : b->d[i]);
        sum.d[i] = (uint32_t)carry;
        carry >>= 32;
    }
    return sum;
}

static big big_multiply(const big *a, const big *b) {
    big product;
    int i, j;
    memset(&product, 0, sizeof product);
    for (i = 0; i < DIGITS; ++i) {
        uint64_t carry = 0;
        for (j = 0; i + j < DIGITS; ++j) {
            carry += (uint64_t)a->d[i] * b->d[j] + product.d[i + j];
            product.d[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
    }
    return product;
}

static int big_sign(const big *a) {
    int i;
    if (a->d[DIGITS - 1] >> 31)
        return -1;
    for (i = 0; i < DIGITS; ++i)
        if (a->d[i])
            return 1;
    return 0;
}

/* value * 2^power as an integer; power must make it one. */
static big big_from(double value, int power) {
    big result, zero;
    int exponent, at;
    uint64_t mantissa;
    memset(&result, 0, sizeof result);
    memset(&zero, 0, sizeof zero);
    if (value == 0)
        return result;
    mantissa = (uint64_t)ldexp(frexp(fabs(value), &exponent), 53);
    exponent += power - 53;
    while (exponent < 0) {
        assert_true((mantissa & 1) == 0);
        mantissa >>= 1;
        ++exponent;
    }
    at = exponent / 32;
    result.d[at] = (uint32_t)(mantissa << exponent % 32);
    result.d[at + 1] = (uint32_t)(mantissa << exponent % 32 >> 32);
    if (exponent % 32)
        result.d[at + 2] = (uint32_t)(mantissa >> (64 - exponent % 32));
    return value < 0 ? big_add(&zero, &result, 1) : result;
}

static big big_product3(const big *a, const big *b, const big *c) {
    const big ab = big_multiply(a, b);
    return big_multiply(&ab, c);
}

/* det[b-a, c-a, e-w*a]. Floats times 2^149 are integers, and so are eyes times 2^180 for the eyes used here. */
static int true_sign(const float *a, const float *b, const float *c, const double eye[4]) {
    big m[3][3], sum;
    int k;
    const big w = big_from(eye[3], 180);
    for (k = 0; k < 3; ++k) {
        const big ak = big_from((double)a[k], 149), bk = big_from((double)b[k], 149), ck = big_from((double)c[k], 149);
        const big e = big_from(eye[k], 180 + 149), wa = big_multiply(&w, &ak);
        m[0][k] = big_add(&bk, &ak, 1);
        m[1][k] = big_add(&ck, &ak, 1);
        m[2][k] = big_add(&e, &wa, 1);
    }
    memset(&sum, 0, sizeof sum);
    for (k = 0; k < 3; ++k) {
        const big up = big_product3(&m[0][k], &m[1][(k + 1) % 3], &m[2][(k + 2) % 3]);
        const big down = big_product3(&m[0][k], &m[1][(k + 2) % 3], &m[2][(k + 1) % 3]);
        sum = big_add(&sum, &up, 0);
        sum = big_add(&sum, &down, 1);
    }
    return big_sign(&sum);
}

/* ---- signs ---- */

/* A soup of unwelded triangles: pose->front of each against the truth, and against its rotations and its reverse. */
static void check_soup(const float *positions, size_t triangles, const sil_view *view, size_t *zeros) {
    const size_t count = 3 * triangles;
    uint32_t *indices = (uint32_t *)malloc(count * 4 * sizeof(uint32_t));
    sil_mesh_desc desc;
    sil_mesh *mesh;
    sil_pose *pose;
    size_t f, i;
    assert_non_null(indices);
    for (f = 0; f < triangles; ++f)
        for (i = 0; i < 12; ++i) { /* as it is, rotated, rotated, reversed */
            static const uint32_t order[12] = {0, 1, 2, 1, 2, 0, 2, 0, 1, 2, 1, 0};
            indices[12 * f + i] = (uint32_t)(3 * f) + order[i];
        }
    for (i = 0; i < 4; ++i) { /* one variant at a time: variants of a face are duplicates of it */
        uint32_t *some = (uint32_t *)malloc(count * sizeof(uint32_t));
        assert_non_null(some);
        for (f = 0; f < triangles; ++f)
            memcpy(some + 3 * f, indices + 12 * f + 3 * i, 3 * sizeof(uint32_t));
        memset(&desc, 0, sizeof desc);
        desc.positions = positions;
        desc.vertex_count = count;
        desc.indices = some;
        desc.index_count = count;
        desc.weld_distance = -1;
        mesh = sil_mesh_create(&desc, NULL);
        assert_non_null(mesh);
        pose = sil_pose_create(mesh, NULL);
        assert_non_null(pose);
        (void)sil_extract(mesh, pose, view, 15, NULL, 0);
        assert_int_equal(mesh->face_count, triangles);
        for (f = 0; f < triangles; ++f) {
            const float *p = positions + 9 * mesh->source[f];
            int truth = true_sign(p, p + 3, p + 6, view->eye);
            *zeros += truth == 0;
            if (i == 3)
                truth = -truth;
            assert_int_equal(pose->front[f], truth > 0);
        }
        sil_pose_destroy(pose);
        sil_mesh_destroy(mesh);
        free(some);
    }
    free(indices);
}

static float random_float(int mode) {
    switch (mode) {
    case 0: /* small integers: many exact zeros */
        return (float)((int)random_below(7) - 3);
    case 1: /* an ordinary model */
        return (float)random_in(-1, 1);
    case 2: /* far from the origin, small detail */
        return (float)(1048576 + random_in(0, 1));
    case 3: /* any exponent that the truth can hold */
        return (float)ldexp(random_in(-1, 1), (int)random_below(250) - 145);
    case 4: /* subnormals */
        return (float)ldexp((double)((int)random_below(9) - 4), -149);
    default: /* nearly the same */
        return (float)(1 + (double)random_below(3) * ldexp(1, -23));
    }
}

static void test_signs_random(void **state) {
    float positions[9 * 40];
    int mode, round, i;
    size_t zeros = 0, all = 0;
    (void)state;
    for (mode = 0; mode < 6; ++mode)
        for (round = 0; round < 12; ++round) {
            sil_view view;
            for (i = 0; i < 9 * 40; ++i)
                positions[i] = random_float(mode == 3 && i % 9 > 4 ? (int)random_below(6) : mode);
            for (i = 0; i < 3; ++i)
                view.eye[i] = round % 3 ? (double)random_float(mode) : random_in(-3, 3);
            view.eye[3] = mode == 3 || round % 2; /* a direction of such a range would be rounded */
            if (view.eye[3] == 0 && mode == 4)
                view.eye[round % 3] = 1;
            if (view.eye[0] == 0 && view.eye[1] == 0 && view.eye[2] == 0)
                view.eye[2] = 1;
            check_soup(positions, 40, &view, &zeros);
            all += 160;
        }
    print_message("signs: %zu checked, %zu of them exactly zero\n", all, zeros);
    assert_true(zeros > 400);
}

/* Triangles whose plane passes exactly or one ulp beside the eye. */
static void test_signs_adversarial(void **state) {
    float positions[9 * 40];
    int round, f, i, k;
    size_t zeros = 0;
    (void)state;
    for (round = 0; round < 60; ++round) {
        sil_view view = view_at(random_in(-2, 2), random_in(-2, 2), random_in(-2, 2), 1);
        for (k = 0; k < 3; ++k)
            view.eye[k] = floor(view.eye[k] * 4096) / 4096;
        for (f = 0; f < 40; ++f) {
            float *p = positions + 9 * f;
            for (i = 0; i < 6; ++i) { /* every second one so short that c is exact */
                p[i] = (float)random_in(-1, 1);
                if (f % 2)
                    p[i] = floorf(p[i] * 4096) / 4096;
            }
            for (k = 0; k < 3; ++k) /* c on the line from the eye through a: edge-on but for rounding */
                p[6 + k] = (float)(view.eye[k] + ((double)p[k] - view.eye[k]) * (f % 4 ? 0.5 : 2.0));
            if (f % 5 == 0) /* one corner on the eye itself */
                for (k = 0; k < 3; ++k)
                    p[k] = (float)view.eye[k];
            if (f % 7 == 0)
                p[6] = nextafterf(p[6], 10.0f);
            if (f % 8 == 0) /* a needle whose sides, as differences in double, are all rounding */
                for (k = 0; k < 3; ++k) {
                    p[k] = (float)ldexp(random_in(-1, 1), -54);
                    p[6 + k] = 2 * p[3 + k];
                }
        }
        check_soup(positions, 40, &view, &zeros);
    }
    print_message("adversarial: %zu of %d exactly zero\n", zeros, 60 * 160);
    assert_true(zeros > 3000);
}

/* The filters must not be all there is, nor the exact sum: each decides, and agrees with the others where both do. */
static void test_signs_stages(void **state) {
    size_t by_filter = 0, by_sum = 0, by_sight = 0, i;
    (void)state;
    for (i = 0; i < 4000; ++i) {
        sil_view view = view_at(random_in(-3, 3), random_in(-3, 3), random_in(-3, 3), (double)(i / 2 % 2));
        sil_i_shape unit;
        sil_i_eye eye;
        float p[9];
        int k, filtered, plain, exact;
        memset(&unit, 0, sizeof unit);
        unit.scale = 1;
        for (k = 0; k < 9; ++k)
            p[k] = random_float(i % 8 < 5 ? 1 : 0);
        for (k = 0; k < 3 && i % 8 >= 5; ++k)
            view.eye[k] = (double)random_float(0);
        if (i % 8 >= 6)
            view = view_at(i / 8 % 3 == 0, i / 8 % 3 == 1, i / 8 % 3 == 2, (double)(i / 2 % 2));
        view.eye[2] = view.eye[0] == 0 && view.eye[1] == 0 && view.eye[2] == 0 ? 1 : view.eye[2];
        sil_i_eye_make(&eye, &view, &unit);
        if (i % 8 == 7) /* on the eye's level, or upright: zero by comparison */
            p[6 + i / 8 % 3] = p[i / 8 % 3];
        filtered = sil_i_filtered_sign(p, p + 3, p + 6, &eye);
        plain = sil_i_plainly_zero(p, p + 3, p + 6, &eye);
        exact = sil_i_exact_sign(p, p + 3, p + 6, &eye);
        assert_int_equal(exact, true_sign(p, p + 3, p + 6, view.eye));
        assert_true(filtered == 0 || filtered == exact);
        assert_true(!plain || exact == 0);
        by_filter += filtered != 0;
        by_sum += filtered == 0 && !plain;
        by_sight += (size_t)plain;
    }
    print_message("stages: filter %zu, comparison %zu, exact sum %zu\n", by_filter, by_sight, by_sum);
    assert_true(by_filter > 2500 && by_sum > 30 && by_sight > 30);
}

static void test_eye_rounding(void **state) {
    const shape s = make_box(2, 2, 2);
    sil_mesh *mesh = mesh_of(&s);
    const size_t seen = count_of(mesh, 0, 0, 1, 0, SIL_SILHOUETTE);
    const double small = ldexp(1, -400), nan_value = (double)NAN, infinite = (double)INFINITY;
    (void)state;
    assert_int_equal(seen, 8);
    assert_int_equal(count_of(mesh, 0, 0, 1e300, 0, SIL_SILHOUETTE), seen);
    assert_int_equal(count_of(mesh, 0, 0, 4e-320, 0, SIL_SILHOUETTE), seen);
    assert_int_equal(count_of(mesh, 1, 1, 1e300, 1, SIL_SILHOUETTE), seen);
    assert_int_equal(count_of(mesh, -1, -1, -9, -1, SIL_SILHOUETTE), count_of(mesh, 1, 1, 9, 1, SIL_SILHOUETTE));
    assert_int_equal(count_of(mesh, 2, 2, 18, 2, SIL_SILHOUETTE), count_of(mesh, 1, 1, 9, 1, SIL_SILHOUETTE));
    assert_int_equal(count_of(mesh, small, small, 9 * small, small, SIL_SILHOUETTE),
                     count_of(mesh, 1, 1, 9, 1, SIL_SILHOUETTE));
    assert_int_equal(count_of(mesh, nan_value, 0, 1, 0, SIL_SILHOUETTE), 0);
    assert_int_equal(count_of(mesh, 0, infinite, 1, 1, SIL_SILHOUETTE), 0);
    assert_int_equal(count_of(mesh, 0, 0, 0, 0, SIL_SILHOUETTE), 0);
    sil_mesh_destroy(mesh);
    shape_free((shape *)(uintptr_t)&s);
}

/* ---- edges ---- */

/* Sign of a face with corners on the grid of 1/64 in 64-bit integers. */
static int grid_sign(const float *a, const float *b, const float *c, const double eye[4]) {
    int64_t u[3], v[3], g[3];
    int k;
    int64_t det = 0;
    for (k = 0; k < 3; ++k) {
        u[k] = (int64_t)(64 * (double)b[k]) - (int64_t)(64 * (double)a[k]);
        v[k] = (int64_t)(64 * (double)c[k]) - (int64_t)(64 * (double)a[k]);
        g[k] = (int64_t)(64 * eye[k]) - (int64_t)eye[3] * (int64_t)(64 * (double)a[k]);
    }
    for (k = 0; k < 3; ++k)
        det += (u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]) * g[k];
    return det > 0 ? 1 : det < 0 ? -1 : 0;
}

typedef struct side {
    uint32_t low, high;
    int sign;
} side;

static int compare_sides(const void *a, const void *b) {
    const side *x = (const side *)a, *y = (const side *)b;
    if (x->low != y->low)
        return x->low < y->low ? -1 : 1;
    return x->high < y->high ? -1 : x->high > y->high;
}

/* Silhouettes of a mesh of two faces an edge and no split vertices, by sorting its sides; rule 0: ours, -1: product of
   the signs below zero, 1: not above. Returns the number; fills pairs where given. */
static size_t brute_silhouettes(const shape *s, const double eye[4], int rule, side *out) {
    const size_t count = s->index_count;
    side *sides = (side *)malloc((count + 1) * sizeof *sides);
    size_t i, found = 0;
    assert_non_null(sides);
    for (i = 0; i < count; ++i) {
        const uint32_t *face = s->indices + i / 3 * 3, a = s->indices[i], b = face[(i + 1) % 3];
        const float *p = s->positions;
        sides[i].low = a < b ? a : b;
        sides[i].high = a < b ? b : a;
        sides[i].sign = grid_sign(p + 3 * face[0], p + 3 * face[1], p + 3 * face[2], eye);
    }
    qsort(sides, count, sizeof *sides, compare_sides);
    for (i = 0; i + 1 < count; i += 2) {
        const int s0 = sides[i].sign, s1 = sides[i + 1].sign;
        assert_int_equal(compare_sides(&sides[i], &sides[i + 1]), 0);
        if (rule == 0 ? (s0 > 0) != (s1 > 0) : rule < 0 ? s0 * s1 < 0 : s0 * s1 <= 0) {
            if (out)
                out[found] = sides[i];
            ++found;
        }
    }
    free(sides);
    return found;
}

static sil_view grid_view(int round) {
    sil_view view;
    int k;
    for (k = 0; k < 3; ++k)
        view.eye[k] = ((double)random_below(385) - 192) / 64;
    view.eye[3] = round % 2;
    if (round % 5 == 0) { /* along an axis, or from a point on one */
        view.eye[0] = view.eye[1] = view.eye[2] = 0;
        view.eye[round / 5 % 3] = round % 4 < 2 ? 2 : -2;
    }
    if (round % 7 == 0)
        view.eye[2] = 0; /* in a plane that many faces and vertices lie in */
    if (view.eye[0] == 0 && view.eye[1] == 0 && view.eye[2] == 0)
        view.eye[1] = 1;
    return view;
}

static void check_even_degrees(const sil_edge *edges, size_t count, size_t vertices) {
    unsigned char *odd = (unsigned char *)calloc(vertices + 1, 1);
    size_t i;
    assert_non_null(odd);
    for (i = 0; i < count; ++i) {
        odd[edges[i].a] ^= 1;
        odd[edges[i].b] ^= 1;
    }
    for (i = 0; i < vertices; ++i)
        assert_int_equal(odd[i], 0);
    free(odd);
}

static int compare_ends(const void *a, const void *b) {
    const sil_edge *x = (const sil_edge *)a, *y = (const sil_edge *)b;
    side p, q;
    p.low = x->a < x->b ? x->a : x->b;
    p.high = x->a < x->b ? x->b : x->a;
    q.low = y->a < y->b ? y->a : y->b;
    q.high = y->a < y->b ? y->b : y->a;
    return compare_sides(&p, &q);
}

/* Does the triangle pass from a to b? */
static int passes(const shape *s, uint32_t face, uint32_t a, uint32_t b) {
    const uint32_t *f = s->indices + 3 * (size_t)face;
    return (f[0] == a && f[1] == b) || (f[1] == a && f[2] == b) || (f[2] == a && f[0] == b);
}

static void check_views(const shape *s, int views, int posed) {
    sil_mesh *mesh = mesh_of(s);
    sil_pose *pose = sil_pose_create(mesh, NULL);
    side *truth = (side *)malloc((s->index_count + 1) * sizeof *truth);
    size_t total = 0;
    int round;
    assert_non_null(pose);
    assert_non_null(truth);
    assert_int_equal(sil_mesh_get_info(mesh).unique_vertex_count, s->vertex_count);
    assert_int_equal(sil_mesh_get_info(mesh).degenerate_face_count, 0);
    if (posed)
        assert_int_equal(sil_pose_set(pose, s->positions, 0), SIL_OK);
    for (round = 0; round < views; ++round) {
        const sil_view view = grid_view(round);
        size_t count, count_free, i;
        sil_edge *edges = extract_all(mesh, pose, &view, SIL_SILHOUETTE, &count);
        sil_edge *edges_free = extract_all(mesh, NULL, &view, SIL_SILHOUETTE, &count_free);
        assert_int_equal(count, count_free);
        check_same_edges(edges, edges_free, count);
        assert_int_equal(count, brute_silhouettes(s, view.eye, 0, truth));
        qsort(edges, count, sizeof *edges, compare_ends); /* edges are numbered by their faces */
        for (i = 0; i < count; ++i) {
            const uint32_t *f = s->indices + 3 * (size_t)edges[i].face[0];
            assert_int_equal(truth[i].low, edges[i].a < edges[i].b ? edges[i].a : edges[i].b);
            assert_int_equal(truth[i].high, edges[i].a < edges[i].b ? edges[i].b : edges[i].a);
            assert_true(passes(s, edges[i].face[0], edges[i].a, edges[i].b));
            assert_true(passes(s, edges[i].face[1], edges[i].b, edges[i].a));
            assert_true(grid_sign(s->positions + 3 * f[0], s->positions + 3 * f[1], s->positions + 3 * f[2], view.eye) >
                        0);
        }
        check_even_degrees(edges, count, s->vertex_count);
        total += count;
        free(edges);
        free(edges_free);
    }
    {
        const sil_view nowhere = view_at(1, (double)NAN, 1, 1);
        assert_int_equal(sil_extract(mesh, pose, &nowhere, SIL_SILHOUETTE, NULL, 0), 0);
    }
    assert_true(total > (size_t)views);
    free(truth);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
}

static void test_edges_against_brute_force(void **state) {
    shape torus = make_torus(14, 9, 0.05, 64), coarse = make_torus(12, 8, 0.1, 16), cylinder;
    (void)state;
    check_views(&torus, 700, 0);
    check_views(&coarse, 700, 1); /* on a coarse grid many faces are edge-on */
    cylinder = make_torus(8, 4, 0, 4);
    check_views(&cylinder, 300, 0);
    shape_free(&torus);
    shape_free(&coarse);
    shape_free(&cylinder);
}

/* Loops of meshes with random float vertices, from random eyes, some of them on the mesh's own vertices. */
static void test_loops_closed(void **state) {
    shape shapes[3];
    int m, round;
    (void)state;
    shapes[0] = make_torus(20, 12, 0.1, 0);
    shapes[1] = make_box(6, 6, 6);
    shapes[2] = make_cylinder(33, 1, 1);
    for (m = 0; m < 3; ++m) {
        sil_mesh *mesh = mesh_of(&shapes[m]);
        sil_pose *pose = sil_pose_create(mesh, NULL);
        assert_int_equal(sil_mesh_get_info(mesh).closed, 1);
        for (round = 0; round < 400; ++round) {
            sil_view view = view_at(random_in(-4, 4), random_in(-4, 4), random_in(-4, 4), (double)(round % 2));
            size_t count;
            sil_edge *edges;
            if (round % 4 == 3) {
                const float *p = shapes[m].positions + 3 * (size_t)random_below(shapes[m].vertex_count);
                view = view_at((double)p[0], (double)p[1], (double)p[2], 1);
            }
            if (round % 10 == 0)
                view = view_at(round % 3 == 0, round % 3 == 1, round % 3 == 2, 0);
            edges = extract_all(mesh, pose, &view, SIL_SILHOUETTE, &count);
            check_even_degrees(edges, count, shapes[m].vertex_count);
            free(edges);
        }
        sil_pose_destroy(pose);
        sil_mesh_destroy(mesh);
        shape_free(&shapes[m]);
    }
}

/* Box and cylinder seen along their axes: 40 and 64 edges, where the papers' rules give 0 or 80 and 128. */
static void test_published_figures(void **state) {
    const double along_z[4] = {0, 0, 1, 0};
    shape box = make_box(10, 10, 10), cylinder = make_cylinder(64, 1, 1), welded;
    sil_mesh *mesh;
    size_t i, j;
    (void)state;
    mesh = mesh_of(&box);
    assert_int_equal(sil_mesh_get_info(mesh).unique_vertex_count, 602);
    assert_int_equal(count_of(mesh, 0, 0, 1, 0, SIL_SILHOUETTE), 40);
    sil_mesh_destroy(mesh);
    /* The rules on the same box, its vertices joined here by comparing all with all. */
    welded = shape_with_room(box.vertex_count, box.index_count / 3);
    for (i = 0; i < box.index_count; ++i) {
        for (j = 0; memcmp(box.positions + 3 * j, box.positions + 3 * box.indices[i], 12) != 0; ++j)
            ;
        welded.indices[welded.index_count++] = (uint32_t)j;
    }
    memcpy(welded.positions, box.positions, 12 * box.vertex_count);
    welded.vertex_count = box.vertex_count;
    assert_int_equal(brute_silhouettes(&welded, along_z, -1, NULL), 0);
    assert_true(brute_silhouettes(&welded, along_z, 1, NULL) > 40);
    mesh = mesh_of(&cylinder);
    assert_int_equal(count_of(mesh, 0, 0, 1, 0, SIL_SILHOUETTE), 64);
    assert_int_equal(count_of(mesh, 0, 0, -1, 0, SIL_SILHOUETTE), 64);
    sil_mesh_destroy(mesh);
    shape_free(&box);
    shape_free(&welded);
    shape_free(&cylinder);
}

/* Shuffled faces with rotated corners: the same edges, the faces renamed. */
static void test_order_does_not_matter(void **state) {
    shape plain = make_torus(12, 7, 0.1, 16), shuffled = shape_with_room(plain.vertex_count, plain.index_count / 3 + 2);
    const size_t faces = plain.index_count / 3;
    uint32_t *order = (uint32_t *)malloc((faces + 2) * sizeof *order);
    sil_mesh *first, *second;
    size_t i, round;
    (void)state;
    assert_non_null(order);
    plain.indices = (uint32_t *)realloc(plain.indices, (plain.index_count + 6) * sizeof(uint32_t));
    assert_non_null(plain.indices);
    add_face(&plain, plain.indices[0], plain.indices[1], 40); /* make some edges have three faces */
    add_face(&plain, plain.indices[3], plain.indices[4], 50);
    memcpy(shuffled.positions, plain.positions, 12 * plain.vertex_count);
    shuffled.vertex_count = plain.vertex_count;
    for (i = 0; i < faces + 2; ++i)
        order[i] = (uint32_t)i;
    for (i = faces + 2; i-- > 1;) {
        const uint32_t j = random_below(i + 1), t = order[i];
        order[i] = order[j];
        order[j] = t;
    }
    for (i = 0; i < faces + 2; ++i) {
        const uint32_t *f = plain.indices + 3 * order[i], turn = random_below(3);
        add_face(&shuffled, f[turn], f[(turn + 1) % 3], f[(turn + 2) % 3]);
    }
    first = mesh_of(&plain);
    second = mesh_of(&shuffled);
    assert_true(sil_mesh_get_info(first).nonmanifold_edge_count >= 2);
    for (round = 0; round < 60; ++round) {
        const sil_view view = grid_view((int)round);
        size_t count, again;
        sil_edge *a = extract_all(first, NULL, &view, 15, &count), *b = extract_all(second, NULL, &view, 15, &again);
        assert_int_equal(count, again);
        for (i = 0; i < count; ++i) {
            b[i].face[0] = order[b[i].face[0]];
            b[i].face[1] = b[i].face[1] == SIL_NONE ? SIL_NONE : order[b[i].face[1]];
        }
        check_same_edges(a, b, count);
        free(a);
        free(b);
    }
    sil_mesh_destroy(first);
    sil_mesh_destroy(second);
    free(order);
    shape_free(&plain);
    shape_free(&shuffled);
}

/* ---- dirty meshes ---- */

static void test_welding(void **state) {
    shape box = make_box(1, 1, 1), sheet;
    sil_mesh_desc desc = desc_of(&box);
    sil_mesh *mesh = mesh_of(&box);
    sil_mesh_info info = sil_mesh_get_info(mesh);
    float unindexed[18] = {0, 0, 0, 1, 0, 0, 0, 1, 0, /**/ 1, 0, 0, 1, 1, 0, -0.0f, 1, -0.0f};
    (void)state;
    assert_int_equal(info.vertex_count, 24);
    assert_int_equal(info.unique_vertex_count, 8);
    assert_int_equal(info.edge_count, 18);
    assert_int_equal(info.face_count, 12);
    assert_int_equal(info.crease_edge_count, 12);
    assert_int_equal(info.component_count, 1);
    assert_int_equal(info.closed, 1);
    assert_int_equal(info.flipped_edge_count, 0);
    assert_true(info.bytes > 500);
    sil_mesh_destroy(mesh);
    desc.weld_distance = -1;
    mesh = sil_mesh_create(&desc, NULL);
    info = sil_mesh_get_info(mesh);
    assert_int_equal(info.unique_vertex_count, 24);
    assert_int_equal(info.boundary_edge_count, 24);
    assert_int_equal(info.component_count, 6);
    assert_int_equal(info.closed, 0);
    sil_mesh_destroy(mesh);
    desc.positions = unindexed; /* triangles without indices; -0 is 0 */
    desc.vertex_count = 6;
    desc.indices = NULL;
    desc.index_count = 0;
    desc.weld_distance = 0;
    mesh = sil_mesh_create(&desc, NULL);
    info = sil_mesh_get_info(mesh);
    assert_int_equal(info.unique_vertex_count, 4);
    assert_int_equal(info.edge_count, 5);
    sil_mesh_destroy(mesh);
    unindexed[9] = 1.0009f;
    unindexed[16] = 0.9995f;
    mesh = sil_mesh_create(&desc, NULL);
    assert_int_equal(sil_mesh_get_info(mesh).unique_vertex_count, 6);
    sil_mesh_destroy(mesh);
    desc.weld_distance = 0.001f;
    mesh = sil_mesh_create(&desc, NULL);
    assert_int_equal(sil_mesh_get_info(mesh).unique_vertex_count, 4);
    sil_mesh_destroy(mesh);
    sheet = make_sheet(4, 4); /* all within the distance of the first: every face collapses */
    desc = desc_of(&sheet);
    desc.weld_distance = 10;
    mesh = sil_mesh_create(&desc, NULL);
    info = sil_mesh_get_info(mesh);
    assert_int_equal(info.unique_vertex_count, 1);
    assert_int_equal(info.degenerate_face_count, 32);
    assert_int_equal(info.face_count + info.edge_count + info.component_count, 0);
    sil_mesh_destroy(mesh);
    shape_free(&box);
    shape_free(&sheet);
}

/* Welding by distance against trying all kept vertices, at grid cells' edges as well. */
static void test_welding_by_distance(void **state) {
    enum { COUNT = 600 };
    float positions[3 * COUNT];
    int round, i, j, k;
    (void)state;
    for (round = 0; round < 6; ++round) {
        const float distance = round % 2 ? 0.125f : 0.09f;
        uint32_t kept[COUNT], unique = 0;
        sil_mesh_desc desc;
        sil_mesh *mesh;
        for (i = 0; i < 3 * COUNT; ++i)
            positions[i] = round % 2 ? (float)((int)random_below(33) - 16) / 16 : (float)random_in(-1, 1);
        memset(&desc, 0, sizeof desc);
        desc.positions = positions;
        desc.vertex_count = COUNT;
        desc.weld_distance = distance;
        mesh = sil_mesh_create(&desc, NULL);
        assert_non_null(mesh);
        for (i = 0; i < COUNT; ++i) {
            uint32_t found = (uint32_t)i;
            for (j = 0; j < (int)unique && found == (uint32_t)i; ++j) {
                double square = 0;
                for (k = 0; k < 3; ++k) {
                    const double d = (double)positions[3 * i + k] - (double)positions[3 * kept[j] + (size_t)k];
                    square += d * d;
                }
                if (square <= (double)distance * (double)distance)
                    found = kept[j];
            }
            if (found == (uint32_t)i)
                kept[unique++] = (uint32_t)i;
            assert_int_equal(mesh->origin[mesh->welded[i]], found);
        }
        assert_true(unique < COUNT);
        sil_mesh_destroy(mesh);
    }
}

typedef struct message_count {
    int errors, warnings, last;
} message_count;

static void count_message(int level, int code, const char *text, void *user) {
    message_count *count = (message_count *)user;
    assert_non_null(text);
    assert_string_equal(text, sil_result_string((sil_result)code));
    count->errors += level == SIL_LOG_ERROR;
    count->warnings += level == SIL_LOG_WARNING;
    count->last = code;
}

static void test_bad_vertices_and_indices(void **state) {
    shape sheet = make_sheet(3, 3);
    message_count messages = {0, 0, 0};
    sil_mesh_desc desc = desc_of(&sheet);
    sil_result result;
    sil_mesh *mesh;
    float infinite = INFINITY;
    (void)state;
    desc.log_fn = count_message;
    desc.log_user = &messages;
    sheet.positions[0] = NAN;               /* a corner with two faces */
    sheet.positions[3 * 15 + 1] = infinite; /* the opposite one */
    sheet.indices[3 * 8] = 16;              /* out of range */
    mesh = sil_mesh_create(&desc, &result);
    assert_int_equal(result, SIL_OK);
    assert_int_equal(sil_mesh_get_info(mesh).dropped_face_count, 5);
    assert_int_equal(sil_mesh_get_info(mesh).face_count, 13);
    assert_int_equal(messages.warnings, 1);
    assert_int_equal(messages.last, SIL_DROPPED_FACES);
    sil_mesh_destroy(mesh);
    desc.weld_distance = 0.01f;
    mesh = sil_mesh_create(&desc, &result);
    assert_int_equal(sil_mesh_get_info(mesh).dropped_face_count, 5);
    assert_int_equal(sil_mesh_get_info(mesh).unique_vertex_count, 16);
    sil_mesh_destroy(mesh);
    desc.weld_distance = 0;
    messages.warnings = 0;
    desc.index_count -= 1;
    assert_null(sil_mesh_create(&desc, &result));
    assert_int_equal(result, SIL_INCOMPLETE_TRIANGLE);
    desc.index_count += 1;
    desc.position_stride = 8;
    assert_null(sil_mesh_create(&desc, &result));
    assert_int_equal(result, SIL_INVALID_ARGUMENT);
    desc.position_stride = 0;
    desc.weld_distance = NAN;
    assert_null(sil_mesh_create(&desc, &result));
    assert_int_equal(result, SIL_INVALID_ARGUMENT);
    desc.weld_distance = 0;
    desc.vertex_count = (size_t)SIL_NONE;
    assert_null(sil_mesh_create(&desc, &result));
    assert_int_equal(result, SIL_TOO_LARGE);
    desc.indices = NULL;
    assert_null(sil_mesh_create(&desc, &result));
    assert_int_equal(result, SIL_INVALID_ARGUMENT);
    assert_null(sil_mesh_create(NULL, &result));
    assert_int_equal(result, SIL_INVALID_ARGUMENT);
    assert_int_equal(messages.errors, 5);
    shape_free(&sheet);
}

static void test_empty_mesh(void **state) {
    sil_mesh_desc desc;
    sil_mesh *mesh;
    sil_pose *pose;
    sil_result result;
    const sil_view view = view_at(0, 0, 1, 0);
    size_t needed = 7;
    (void)state;
    memset(&desc, 0, sizeof desc);
    mesh = sil_mesh_create(&desc, &result);
    assert_non_null(mesh);
    assert_int_equal(result, SIL_OK);
    pose = sil_pose_create(mesh, &result);
    assert_non_null(pose);
    assert_int_equal(sil_extract(mesh, pose, &view, 15, NULL, 0), 0);
    assert_int_equal(sil_extract(mesh, NULL, &view, 15, NULL, 0), 0);
    assert_int_equal(sil_chain(mesh, pose, NULL, 0, NULL, 0, NULL, 0, &needed), 0);
    assert_int_equal(needed, 0);
    assert_int_equal(sil_distances(mesh, pose, NULL, 0, NULL, 0, 0, NULL, NULL), SIL_OK);
    assert_true(sil_max_distance(mesh, NULL, NULL) <= 0);
    assert_int_equal(sil_mesh_get_info(mesh).closed, 0);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
}

/* Every face twice with both windings: as one two-sided sheet. */
static void test_duplicates(void **state) {
    shape sheet = make_sheet(4, 4), twice = shape_with_room(sheet.vertex_count, 3 * sheet.index_count / 3),
          box = make_box(2, 2, 2);
    shape box_twice = shape_with_room(box.vertex_count, 2 * box.index_count / 3);
    sil_mesh *mesh;
    sil_mesh_info info;
    sil_edge edges[64];
    sil_view view = view_at(2, 2, 9, 1);
    size_t i, count;
    (void)state;
    for (i = 0; i < sheet.index_count; i += 3) { /* which winding comes first changes from face to face */
        const uint32_t *f = sheet.indices + i;
        add_face(&twice, f[0], f[i % 2 ? 1 : 2], f[i % 2 ? 2 : 1]);
        add_face(&twice, f[1], f[i % 2 ? 0 : 2], f[i % 2 ? 2 : 0]);
        if (i % 4 == 0)
            add_face(&twice, f[2], f[0], f[1]);
    }
    for (i = 0; i < sheet.vertex_count; ++i) /* a roof with its ridge in the middle */
        sheet.positions[3 * i + 2] = sheet.positions[3 * i] < 2 ? sheet.positions[3 * i] : 4 - sheet.positions[3 * i];
    memcpy(twice.positions, sheet.positions, 12 * sheet.vertex_count);
    twice.vertex_count = sheet.vertex_count;
    mesh = mesh_of(&twice);
    info = sil_mesh_get_info(mesh);
    assert_int_equal(info.face_count, 32);
    assert_int_equal(info.two_sided_face_count, 32);
    assert_int_equal(info.duplicate_face_count, twice.index_count / 3 - 32);
    assert_int_equal(info.boundary_edge_count, 16);
    assert_int_equal(info.flipped_edge_count, 0);
    /* From above both slopes are seen: the border and the ridge, as a crease. From below as well. */
    assert_int_equal(sil_extract(mesh, NULL, &view, 15, NULL, 0), 20);
    assert_int_equal(sil_extract(mesh, NULL, &view, SIL_CREASE, NULL, 0), 4);
    view.eye[2] = -9;
    assert_int_equal(sil_extract(mesh, NULL, &view, SIL_CREASE, NULL, 0), 4);
    view = view_at(9, 2, 1, 1); /* from a side: the ridge is a silhouette */
    count = sil_extract(mesh, NULL, &view, SIL_SILHOUETTE | SIL_CREASE, edges, 64);
    assert_int_equal(count, 4);
    for (i = 0; i < count; ++i)
        assert_int_equal(edges[i].kinds & 15u, SIL_SILHOUETTE);
    sil_mesh_destroy(mesh);
    for (i = 0; i < box.index_count; i += 3) {
        const uint32_t *f = box.indices + i;
        add_face(&box_twice, f[0], f[1], f[2]);
        add_face(&box_twice, f[0], f[2], f[1]);
    }
    memcpy(box_twice.positions, box.positions, 12 * box.vertex_count);
    box_twice.vertex_count = box.vertex_count;
    mesh = mesh_of(&box_twice);
    assert_int_equal(sil_mesh_get_info(mesh).closed, 1);
    assert_int_equal(sil_mesh_get_info(mesh).flipped_edge_count, 0);
    assert_int_equal(count_of(mesh, 5, 6, 7, 1, SIL_SILHOUETTE), 12);
    sil_mesh_destroy(mesh);
    shape_free(&sheet);
    shape_free(&twice);
    shape_free(&box);
    shape_free(&box_twice);
}

/* A fan of five half planes around the z axis. */
static void test_nonmanifold(void **state) {
    shape fan = shape_with_room(7, 5);
    sil_mesh *mesh;
    sil_edge edge;
    sil_view view = view_at(0, 0, 1, 0);
    uint32_t i, j;
    int round;
    (void)state;
    add_vertex(&fan, 0, 0, 0);
    add_vertex(&fan, 0, 0, 1);
    for (i = 0; i < 5; ++i)
        add_vertex(&fan, cos(1.2566 * i), sin(1.2566 * i), 0.5);
    for (i = 0; i < 5; ++i)
        add_face(&fan, 0, i == 2 ? 2 + i : 1, i == 2 ? 1 : 2 + i);
    mesh = mesh_of(&fan);
    assert_int_equal(sil_mesh_get_info(mesh).nonmanifold_edge_count, 1);
    assert_int_equal(sil_mesh_get_info(mesh).boundary_edge_count, 10);
    assert_int_equal(sil_mesh_get_info(mesh).component_count, 1);
    for (round = 0; round < 200; ++round) {
        int front = 0, back = 0;
        view = view_at(random_in(-1, 1), random_in(-1, 1), random_in(-1, 1), 0);
        for (j = 0; j < 5; ++j) {
            const uint32_t *f = fan.indices + 3 * j;
            const int sign =
                true_sign(fan.positions + 3 * f[0], fan.positions + 3 * f[1], fan.positions + 3 * f[2], view.eye);
            front |= sign > 0;
            back |= sign <= 0;
        }
        assert_int_equal(sil_extract(mesh, NULL, &view, SIL_NONMANIFOLD, &edge, 1), 1);
        assert_int_equal(edge.kinds, SIL_NONMANIFOLD | (front && back ? SIL_SILHOUETTE : 0));
        assert_int_equal(sil_extract(mesh, NULL, &view, SIL_SILHOUETTE, NULL, 0), front && back);
        assert_int_equal(edge.a + edge.b, 1);
    }
    assert_int_equal(sil_extract(mesh, NULL, NULL, SIL_NONMANIFOLD | SIL_SILHOUETTE, &edge, 1), 1);
    sil_mesh_destroy(mesh);
    shape_free(&fan);
}

/* A quad whose left side has a vertex in its middle, stitched by a face without area, as CAD tessellators do. */
static void test_faces_without_area(void **state) {
    /* 0 (0,0) 1 (2,0) 2 (2,2) 3 (0,2) and 4 (0,1) on the side; 5, 6 to the left, lower: a ridge along x = 0 */
    const float positions[7 * 3] = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 0, 1, 0, -2, 0, -1, -2, 2, -1};
    const uint32_t indices[6 * 3] = {0, 1, 3, 1, 2, 3, 0, 3, 4, /**/ 0, 4, 5, 4, 6, 5, 4, 3, 6};
    sil_mesh_desc desc;
    sil_mesh *mesh;
    sil_mesh_info info;
    sil_edge edges[16];
    size_t count, i;
    sil_view view = view_at(0, 0, 1, 0);
    (void)state;
    memset(&desc, 0, sizeof desc);
    desc.positions = positions;
    desc.vertex_count = 7;
    desc.indices = indices;
    desc.index_count = 18;
    desc.crease_degrees = 10;
    mesh = sil_mesh_create(&desc, NULL);
    info = sil_mesh_get_info(mesh);
    assert_int_equal(info.degenerate_face_count, 1);
    assert_int_equal(info.face_count, 6);
    assert_int_equal(info.boundary_edge_count, 6);
    /* The ridge is two edges, 0-4 and 4-3; the face without area adds no line along 0-3. */
    count = sil_extract(mesh, NULL, &view, SIL_CREASE, edges, 16);
    assert_int_equal(count, 2);
    for (i = 0; i < count; ++i)
        assert_true(edges[i].a == 4 || edges[i].b == 4);
    view = view_at(-9, 0, 1, 0); /* both sides are seen */
    assert_int_equal(sil_extract(mesh, NULL, &view, SIL_SILHOUETTE, NULL, 0), 0);
    view = view_at(9, 0, 1, 0); /* the left side faces away */
    count = sil_extract(mesh, NULL, &view, SIL_SILHOUETTE, edges, 16);
    assert_int_equal(count, 2);
    for (i = 0; i < count; ++i)
        assert_true(edges[i].a == 4 || edges[i].b == 4);
    sil_mesh_destroy(mesh);
}

static sil_mesh *mesh_of_arrays(const float *positions, size_t vertices, const uint32_t *indices, size_t count) {
    shape s;
    s.positions = (float *)(uintptr_t)positions;
    s.indices = (uint32_t *)(uintptr_t)indices;
    s.vertex_count = vertices;
    s.index_count = count;
    return mesh_of(&s);
}

/* Chains of faces without area, two that share their longest edge, and one all alone. */
static void test_chains_of_faces_without_area(void **state) {
    /* x = 0 .. 4 on a line (0..4), a vertex above (5) and one below (6) */
    const float positions[8 * 3] = {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0, 2, 2, 0, 2, -2, 0, 2.5f, 0, 0};
    /* above: 0-4-5. The line is triangulated as 0-4-3, 0-3-2, 0-2-1 downward, then three faces below. */
    const uint32_t chain[7 * 3] = {0, 4, 5, 0, 3, 4, 0, 2, 3, 0, 1, 2, /**/ 1, 0, 6, 2, 1, 6, 4, 2, 6};
    const uint32_t alone[3] = {0, 1, 2};
    /* two slivers back to back on 0-4: above a face on 0-1 and on 1-4, below on 0-3 and 3-4 */
    const uint32_t pair[6 * 3] = {0, 1, 4, 4, 3, 0, /**/ 0, 5, 1, 1, 5, 4, /**/ 4, 6, 3, 3, 6, 0};
    /* a sliver on an edge that two good faces have: it is no third face of it */
    const uint32_t third[3 * 3] = {0, 4, 5, 4, 0, 6, 0, 7, 4};
    sil_mesh *mesh = mesh_of_arrays(positions, 7, chain, 21);
    const sil_view above = view_at(0, 0, 1, 0);
    sil_edge edges[32];
    size_t i, count;
    (void)state;
    /* 2-3-4 is left out: 4-2-6 meets 0-2-3 and 0-3-4 at 2-4's parts only; so 2-4 is a border, and 2-3, 3-4 too. */
    assert_int_equal(sil_mesh_get_info(mesh).degenerate_face_count, 3);
    for (i = 0; i < 3; ++i)
        assert_int_equal(mesh->source[mesh->flat_root[i]], 0); /* all follow to the face above */
    assert_int_equal(sil_extract(mesh, NULL, &above, SIL_SILHOUETTE | SIL_CREASE, edges, 32), 0);
    sil_mesh_destroy(mesh);
    mesh = mesh_of_arrays(positions, 7, alone, 3);
    assert_int_equal(sil_mesh_get_info(mesh).face_count, 1);
    assert_int_equal(sil_extract(mesh, NULL, &above, 15, edges, 32), 0);
    assert_int_equal(sil_mesh_get_info(mesh).boundary_edge_count, 0);
    sil_mesh_destroy(mesh);
    mesh = mesh_of_arrays(positions, 7, pair, 18);
    assert_int_equal(sil_mesh_get_info(mesh).degenerate_face_count, 2);
    assert_int_equal(mesh->flat_root[0] != SIL_NONE && mesh->flat_root[1] != SIL_NONE, 1);
    count = sil_extract(mesh, NULL, &above, SIL_SILHOUETTE, edges, 32);
    assert_int_equal(count, 0); /* all face down: the slivers as well */
    assert_int_equal(sil_extract(mesh, NULL, &above, SIL_BOUNDARY, edges, 32), 4);
    sil_mesh_destroy(mesh);
    mesh = mesh_of_arrays(positions, 8, third, 9);
    assert_int_equal(sil_mesh_get_info(mesh).nonmanifold_edge_count, 0);
    assert_int_equal(sil_mesh_get_info(mesh).boundary_edge_count, 4);
    assert_int_equal(sil_extract(mesh, NULL, &above, SIL_SILHOUETTE | SIL_NONMANIFOLD | SIL_CREASE, edges, 32), 0);
    sil_mesh_destroy(mesh);
    mesh = mesh_of_arrays(positions, 7, pair, 6); /* only the slivers: a ring of no use */
    assert_int_equal(sil_extract(mesh, NULL, &above, 15, edges, 32), 0);
    sil_mesh_destroy(mesh);
}

/* Slivers behind slivers, and slivers on a border. */
static void test_slivers(void **state) {
    /* 0 .. 4 on a line, 5 above, 6 below, 7 between 0 and 1 */
    const float positions[8 * 3] = {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0, 2, 2, 0, 2, -2, 0, 0.5f, 0, 0};
    /* two that share their longest edge, a third behind the first, and one face behind the second */
    const uint32_t behind[4 * 3] = {0, 1, 4, 4, 3, 0, 0, 7, 1, 4, 6, 3};
    /* a face whose border has two slivers on it, and nothing beyond */
    const uint32_t border[3 * 3] = {0, 4, 5, 0, 1, 4, 4, 3, 0};
    const sil_view above = view_at(1, 2, 9, 1);
    sil_mesh *mesh = mesh_of_arrays(positions, 8, behind, 12);
    sil_edge edges[16];
    size_t count, i;
    int in_view;
    (void)state;
    assert_int_equal(mesh->flat_count, 3);
    for (i = 0; i < 3; ++i)
        assert_int_equal(mesh->source[mesh->flat_root[i]], 3);
    sil_mesh_destroy(mesh);
    mesh = mesh_of_arrays(positions, 8, border, 9);
    assert_int_equal(sil_mesh_get_info(mesh).nonmanifold_edge_count, 0);
    assert_int_equal(sil_mesh_get_info(mesh).boundary_edge_count, 3);
    for (in_view = 0; in_view < 2; ++in_view) {
        count = sil_extract(mesh, NULL, in_view ? &above : NULL, 15, edges, 16);
        assert_int_equal(count, 3);
        for (i = 0; i < count; ++i) {
            assert_int_equal(edges[i].kinds, SIL_BOUNDARY);
            assert_int_equal(edges[i].face[0], 0);
            assert_int_equal(edges[i].face[1], SIL_NONE);
        }
    }
    sil_mesh_destroy(mesh);
}

/* A face in both windings among faces in one is wound as they are. */
static void test_partly_two_sided(void **state) {
    shape sheet = make_sheet(3, 3), more = shape_with_room(sheet.vertex_count, sheet.index_count / 3 + 1);
    const double toward[3] = {0.1, 0.2, 1}, eye[3] = {1, 1, 4};
    sil_view view = sil_view_orthographic(toward);
    sil_mesh *mesh;
    (void)state;
    memcpy(more.positions, sheet.positions, 12 * sheet.vertex_count);
    more.vertex_count = sheet.vertex_count;
    add_face(&more, sheet.indices[24], sheet.indices[26], sheet.indices[25]);
    memcpy(more.indices + 3, sheet.indices, sheet.index_count * sizeof(uint32_t));
    more.index_count += sheet.index_count;
    mesh = mesh_of(&more);
    assert_int_equal(sil_mesh_get_info(mesh).two_sided_face_count, 1);
    assert_int_equal(sil_mesh_get_info(mesh).flipped_edge_count, 0);
    assert_int_equal(sil_extract(mesh, NULL, &view, SIL_SILHOUETTE, NULL, 0), 0);
    view = sil_view_perspective(eye);
    assert_int_equal(sil_extract(mesh, NULL, &view, SIL_SILHOUETTE, NULL, 0), 0);
    sil_mesh_destroy(mesh);
    shape_free(&sheet);
    shape_free(&more);
}

static void test_flipped_neighbours(void **state) {
    shape sheet = make_sheet(2, 2);
    message_count messages = {0, 0, 0};
    sil_mesh_desc desc = desc_of(&sheet);
    sil_mesh *mesh;
    const sil_view above = view_at(1, 1, 5, 1);
    (void)state;
    desc.log_fn = count_message;
    desc.log_user = &messages;
    sheet.indices[1] ^= sheet.indices[2];
    sheet.indices[2] ^= sheet.indices[1];
    sheet.indices[1] ^= sheet.indices[2];
    mesh = sil_mesh_create(&desc, NULL);
    assert_int_equal(messages.last, SIL_FLIPPED_EDGES);
    assert_int_equal(sil_mesh_get_info(mesh).flipped_edge_count, 2);
    assert_int_equal(sil_mesh_get_info(mesh).crease_edge_count, 0); /* it is flat all the same */
    assert_int_equal(sil_extract(mesh, NULL, &above, SIL_SILHOUETTE, NULL, 0), 2);
    sil_mesh_destroy(mesh);
    shape_free(&sheet);
}

/* Creases at a given angle: two faces bent by it. In a view only where both are in front. */
static void test_crease_angle(void **state) {
    int degrees;
    (void)state;
    for (degrees = 1; degrees < 180; degrees += 13) {
        const double bend = degrees * 3.14159265358979323846 / 180;
        const float positions[12] = {0, 0, 0, 0, 1, 0, -1, 0, 0, (float)cos(bend), 0, (float)-sin(bend)};
        const uint32_t indices[6] = {0, 1, 2, 1, 0, 3};
        sil_mesh_desc desc;
        int step;
        memset(&desc, 0, sizeof desc);
        desc.positions = positions;
        desc.vertex_count = 4;
        desc.indices = indices;
        desc.index_count = 6;
        for (step = -1; step <= 1; step += 2) {
            sil_mesh *mesh;
            const double half = bend / 2;
            desc.crease_degrees = (float)(degrees + 0.001 * step);
            mesh = sil_mesh_create(&desc, NULL);
            assert_int_equal(sil_mesh_get_info(mesh).crease_edge_count, step < 0);
            assert_int_equal(sil_extract(mesh, NULL, NULL, SIL_CREASE, NULL, 0), step < 0);
            if (degrees < 170) {
                assert_int_equal(count_of(mesh, sin(half), 0, cos(half), 0, SIL_CREASE), step < 0);
                assert_int_equal(count_of(mesh, -sin(half), 0, -cos(half), 0, SIL_CREASE), 0);
            }
            assert_int_equal(count_of(mesh, 1, 0, -0.001, 0, SIL_CREASE), 0);
            sil_mesh_destroy(mesh);
        }
    }
}

/* ---- chains ---- */

typedef struct chain_result {
    sil_strip *strips;
    uint32_t *vertices;
    size_t strip_count, vertex_count;
} chain_result;

static chain_result chain_all(const sil_mesh *mesh, sil_pose *pose, const sil_edge *edges, size_t count) {
    chain_result r;
    r.strip_count = sil_chain(mesh, pose, edges, count, NULL, 0, NULL, 0, &r.vertex_count);
    r.strips = (sil_strip *)malloc((r.strip_count + 1) * sizeof(sil_strip));
    r.vertices = (uint32_t *)malloc((r.vertex_count + 1) * sizeof(uint32_t));
    assert_non_null(r.strips);
    assert_non_null(r.vertices);
    assert_int_equal(
        sil_chain(mesh, pose, edges, count, r.strips, r.strip_count, r.vertices, r.vertex_count, &r.vertex_count),
        r.strip_count);
    return r;
}

static void chain_free(chain_result *r) {
    free(r->strips);
    free(r->vertices);
}

/* Every edge in exactly one strip, ids rising and right, ends and loops as marked. Returns the number of loops. */
static size_t check_chains(const sil_edge *edges, size_t count, const chain_result *r) {
    unsigned char *used = (unsigned char *)calloc(count + 1, 1);
    size_t s, i, k, loops = 0, steps = 0;
    assert_non_null(used);
    for (s = 0; s < r->strip_count; ++s) {
        const sil_strip *strip = &r->strips[s];
        const uint32_t *v = r->vertices + strip->first;
        uint32_t least = SIL_NONE;
        assert_true(strip->count >= 2);
        assert_true(s == 0 || strip->id > r->strips[s - 1].id);
        for (i = 0; i + 1 < strip->count; ++i, ++steps) {
            for (k = 0; k < count; ++k)
                if (!used[k] && (edges[k].kinds & 15u) == strip->kinds &&
                    ((edges[k].a == v[i] && edges[k].b == v[i + 1]) || (edges[k].b == v[i] && edges[k].a == v[i + 1])))
                    break;
            assert_true(k < count);
            if (strip->kinds == SIL_SILHOUETTE)
                assert_int_equal(edges[k].a, v[i]); /* front faces on the left all along */
            used[k] = 1;
            least = edges[k].edge < least ? edges[k].edge : least;
        }
        assert_int_equal(least, strip->id);
        if (strip->closed)
            assert_int_equal(v[0], v[strip->count - 1]);
        loops += strip->closed;
    }
    assert_int_equal(steps, count);
    free(used);
    return loops;
}

static void test_chains_of_closed_mesh(void **state) {
    shape torus = make_torus(18, 10, 0.12, 64);
    sil_mesh *mesh = mesh_of(&torus);
    sil_pose *pose = sil_pose_create(mesh, NULL);
    int round;
    size_t total = 0;
    (void)state;
    for (round = 0; round < 150; ++round) {
        const sil_view view = grid_view(round);
        size_t count, i;
        sil_edge *edges = extract_all(mesh, pose, &view, SIL_SILHOUETTE, &count);
        chain_result r = chain_all(mesh, pose, edges, count), again;
        assert_int_equal(check_chains(edges, count, &r), r.strip_count); /* all are loops */
        total += r.strip_count;
        for (i = count; i-- > 1;) { /* any order of the edges, some twice, without a pose: the same strips */
            const uint32_t j = random_below(i + 1);
            const sil_edge t = edges[i];
            edges[i] = edges[j];
            edges[j] = t;
        }
        edges = (sil_edge *)realloc(edges, (count + 3) * sizeof *edges);
        assert_non_null(edges);
        for (i = 0; i < 2 && count > 1; ++i)
            edges[count + i] = edges[i];
        again = chain_all(mesh, NULL, edges, count > 1 ? count + 2 : count);
        assert_int_equal(again.strip_count, r.strip_count);
        assert_int_equal(again.vertex_count, r.vertex_count);
        assert_memory_equal(again.strips, r.strips, r.strip_count * sizeof(sil_strip));
        assert_memory_equal(again.vertices, r.vertices, r.vertex_count * sizeof(uint32_t));
        chain_free(&again);
        chain_free(&r);
        free(edges);
    }
    assert_true(total > 150);
    { /* a part of a set: what is left is in open strips, none of which passes over what is missing */
        const sil_view view = grid_view(1);
        size_t count, i, kept = 0;
        sil_edge *edges = extract_all(mesh, pose, &view, SIL_SILHOUETTE, &count);
        chain_result r;
        for (i = 0; i < count; ++i)
            if (i % 3)
                edges[kept++] = edges[i];
        r = chain_all(mesh, pose, edges, kept);
        assert_true(check_chains(edges, kept, &r) < r.strip_count);
        chain_free(&r);
        free(edges);
    }
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    shape_free(&torus);
}

/* Two tetrahedra that share a vertex only, seen so that both outlines pass through it: two loops that do not cross. */
static void test_loops_do_not_cross(void **state) {
    const float positions[7 * 3] = {0, 0, 0, 2, -1, 0, 2, 1, 0, 2, 0, 1, -2, -1, 0, -2, 1, 0, -2, 0, 1};
    const uint32_t indices[24] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3, 0, 4, 5, 0, 6, 4, 0, 5, 6, 4, 6, 5};
    sil_mesh *mesh = mesh_of_arrays(positions, 7, indices, 24);
    const sil_view view = view_at(0, 0.01, 5, 0);
    sil_edge edges[12];
    const size_t count = sil_extract(mesh, NULL, &view, SIL_SILHOUETTE, edges, 12);
    chain_result r = chain_all(mesh, NULL, edges, count);
    size_t i, s;
    (void)state;
    assert_int_equal(r.strip_count, 2);
    assert_int_equal(check_chains(edges, count, &r), 2);
    for (s = 0; s < 2; ++s) { /* each stays on its own tetrahedron and passes through the vertex once */
        size_t left = 0, right = 0, shared = 0;
        for (i = 1; i < r.strips[s].count; ++i) {
            const uint32_t v = r.vertices[r.strips[s].first + i];
            left += v > 3;
            right += v > 0 && v <= 3;
            shared += v == 0;
        }
        assert_int_equal(shared, 1);
        assert_true(left == 0 || right == 0);
    }
    chain_free(&r);
    sil_mesh_destroy(mesh);
}

static void test_chains_of_borders(void **state) {
    shape sheet = make_sheet(5, 5), box = make_box(3, 3, 3);
    sil_mesh *mesh = mesh_of(&sheet);
    const sil_view view = view_at(8, 9, 10, 1);
    size_t count, needed, s;
    sil_edge *edges = extract_all(mesh, NULL, NULL, 15, &count);
    chain_result r = chain_all(mesh, NULL, edges, count);
    sil_strip one;
    uint32_t few[4] = {SIL_NONE, SIL_NONE, SIL_NONE, SIL_NONE};
    (void)state;
    assert_int_equal(r.strip_count, 1); /* the border, once around */
    assert_int_equal(check_chains(edges, count, &r), 1);
    assert_int_equal(r.strips[0].count, 21);
    assert_int_equal(r.strips[0].kinds, SIL_BOUNDARY);
    assert_int_equal(sil_chain(mesh, NULL, edges, count, &one, 1, few, 3, &needed), 1); /* short arrays */
    assert_int_equal(needed, 21);
    assert_memory_equal(few, r.vertices, 3 * sizeof(uint32_t));
    assert_int_equal(few[3], SIL_NONE);
    edges[0].edge = SIL_NONE; /* not of this mesh: left out, and the loop is open */
    chain_free(&r);
    r = chain_all(mesh, NULL, edges, count);
    assert_int_equal(r.strip_count, 1);
    assert_int_equal(r.strips[0].count, 20);
    assert_int_equal(r.strips[0].closed, 0);
    chain_free(&r);
    free(edges);
    sil_mesh_destroy(mesh);
    for (s = 0; s < sheet.vertex_count; ++s) /* a gable: the ridge, a crease, ends on the border, which goes on */
        sheet.positions[3 * s + 2] = 2 - fabsf(sheet.positions[3 * s] - 2);
    mesh = mesh_of(&sheet);
    edges = extract_all(mesh, NULL, NULL, 15, &count);
    r = chain_all(mesh, NULL, edges, count);
    assert_int_equal(count, 25);
    assert_int_equal(r.strip_count, 2);
    assert_int_equal(check_chains(edges, count, &r), 1);
    chain_free(&r);
    free(edges);
    sil_mesh_destroy(mesh);
    mesh = mesh_of(&box); /* creases meet in threes: at the near corner of a box strips end */
    edges = extract_all(mesh, NULL, &view, SIL_CREASE, &count);
    r = chain_all(mesh, NULL, edges, count);
    assert_int_equal(count, 9);
    assert_int_equal(r.strip_count, 3);
    assert_int_equal(check_chains(edges, count, &r), 0);
    for (s = 0; s < 3; ++s)
        assert_int_equal(r.strips[s].count, 4);
    chain_free(&r);
    free(edges);
    edges = extract_all(mesh, NULL, &view, 15, &count); /* several kinds together */
    r = chain_all(mesh, NULL, edges, count);
    assert_int_equal(r.strip_count, 4);
    assert_int_equal(check_chains(edges, count, &r), 1);
    chain_free(&r);
    free(edges);
    sil_mesh_destroy(mesh);
    shape_free(&sheet);
    shape_free(&box);
}

/* ---- poses and views ---- */

/* The border of a sheet whose corner is not finite in the pose: without the two edges there. */
static void check_bad_corner(void) {
    shape sheet = make_sheet(5, 5);
    sil_mesh *mesh = mesh_of(&sheet);
    sil_pose *pose = sil_pose_create(mesh, NULL);
    const sil_view view = view_at(2, 2, 5, 1);
    assert_int_equal(sil_extract(mesh, pose, &view, SIL_BOUNDARY, NULL, 0), 20);
    sheet.positions[1] = NAN;
    assert_int_equal(sil_pose_set(pose, sheet.positions, 0), SIL_OK);
    assert_int_equal(sil_extract(mesh, pose, &view, SIL_BOUNDARY, NULL, 0), 18);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    shape_free(&sheet);
}

static void test_pose(void **state) {
    shape torus = make_torus(10, 6, 0.1, 64);
    float *moved = (float *)malloc(16 * torus.vertex_count);
    shape other;
    sil_mesh *mesh = mesh_of(&torus), *rebuilt;
    sil_pose *pose = sil_pose_create(mesh, NULL);
    const sil_view view = view_at(2, 1, 0.5, 1);
    size_t i, rest_count, count, again, round;
    sil_edge *rest = extract_all(mesh, pose, &view, SIL_SILHOUETTE, &rest_count), *edges, *truth;
    (void)state;
    assert_non_null(moved);
    for (round = 0; round < 20; ++round) {
        other = make_torus(10, 6, 0.3, 64);
        for (i = 0; i < torus.vertex_count; ++i)
            memcpy((char *)moved + 16 * i, other.positions + 3 * i, 12);
        assert_int_equal(sil_pose_set(pose, moved, 16), SIL_OK);
        edges = extract_all(mesh, pose, &view, SIL_SILHOUETTE, &count);
        rebuilt = mesh_of(&other);
        truth = extract_all(rebuilt, NULL, &view, SIL_SILHOUETTE, &again);
        assert_int_equal(count, again);
        qsort(edges, count, sizeof *edges, compare_ends); /* faces at other places have other numbers */
        qsort(truth, count, sizeof *truth, compare_ends);
        for (i = 0; i < count; ++i) {
            truth[i].edge = edges[i].edge;
            truth[i].kinds = (truth[i].kinds & 15u) | (edges[i].kinds & 48u); /* convex or not at rest */
        }
        check_same_edges(edges, truth, count);
        sil_mesh_destroy(rebuilt);
        shape_free(&other);
        free(truth);
        free(edges);
    }
    assert_int_equal(sil_pose_set(pose, NULL, 0), SIL_OK); /* back to rest */
    edges = extract_all(mesh, pose, &view, SIL_SILHOUETTE, &count);
    assert_int_equal(count, rest_count);
    check_same_edges(edges, rest, count);
    free(edges);
    moved[0] = NAN; /* a vertex that is not finite: no edge ends there, and the rest is as ever */
    assert_int_equal(sil_pose_set(pose, moved, 16), SIL_OK);
    for (round = 0; round < 40; ++round) {
        const sil_view around = grid_view((int)round);
        edges = extract_all(mesh, pose, &around, 15, &count);
        assert_true(count > 0);
        for (i = 0; i < count; ++i)
            assert_true(edges[i].a != 0 && edges[i].b != 0);
        free(edges);
    }
    free(rest);
    check_bad_corner();
    assert_int_equal(sil_pose_set(pose, moved, 4), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_pose_set(NULL, moved, 0), SIL_INVALID_ARGUMENT);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    shape_free(&torus);
    free(moved);
}

/* out = a * b, column-major */
static void multiply(const double *a, const double *b, double *out) {
    int i, j, k;
    for (i = 0; i < 4; ++i)
        for (j = 0; j < 4; ++j) {
            out[4 * j + i] = 0;
            for (k = 0; k < 4; ++k)
                out[4 * j + i] += a[4 * k + i] * b[4 * j + k];
        }
}

static void identity(double *m) {
    int i;
    for (i = 0; i < 16; ++i)
        m[i] = i % 5 == 0;
}

static void rotate(double *m, int axis, double angle) {
    double r[16], copy[16];
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    identity(r);
    r[5 * a] = r[5 * b] = cos(angle);
    r[4 * a + b] = sin(angle);
    r[4 * b + a] = -sin(angle);
    memcpy(copy, m, sizeof copy);
    multiply(copy, r, m);
}

static void narrow(const double *m, float *out) {
    int i;
    for (i = 0; i < 16; ++i)
        out[i] = (float)m[i];
}

/* Perspective with the near plane at `front`; reversed: depth 1 there, 0 at infinity, for clip z in [0, w]. */
static void perspective(double *m, double focal, double aspect, double front, double back, int reversed) {
    memset(m, 0, 16 * sizeof(double));
    m[0] = focal / aspect;
    m[5] = focal;
    m[11] = -1;
    m[10] = reversed ? 0 : -(back + front) / (back - front);
    m[14] = reversed ? front : -2 * back * front / (back - front);
}

static void orthographic(double *m, double half_width, double half_height, double front, double back) {
    identity(m);
    m[0] = 1 / half_width;
    m[5] = 1 / half_height;
    m[10] = -2 / (back - front);
    m[14] = -(back + front) / (back - front);
}

static void test_view_from_matrices(void **state) {
    int round;
    (void)state;
    for (round = 0; round < 300; ++round) {
        double mv[16], p[16], eye[3], expected[3], linear[9], scale[3], length = 0, det;
        float mvf[16], pf[16];
        sil_view view;
        int i, k;
        identity(mv);
        for (k = 0; k < 3; ++k) {
            rotate(mv, k, random_in(-3, 3));
            scale[k] = random_in(0.3, 2) * (round % 4 == k ? -1 : 1); /* mirrored ones too */
        }
        for (i = 0; i < 12; ++i)
            mv[i] *= scale[i / 4];
        for (k = 0; k < 3; ++k)
            mv[12 + k] = random_in(-5, 5);
        if (round % 2)
            perspective(p, random_in(0.5, 3), 1.5, 0.1, 100, round % 6 == 1);
        else
            orthographic(p, 3, 2, 0.1, 100);
        narrow(mv, mvf);
        narrow(p, pf);
        assert_int_equal(sil_view_from_matrices(mvf, pf, &view), SIL_OK);
        for (i = 0; i < 9; ++i)
            linear[i] = (double)mvf[i / 3 * 4 + i % 3];
        det = linear[0] * (linear[4] * linear[8] - linear[7] * linear[5]) -
              linear[3] * (linear[1] * linear[8] - linear[7] * linear[2]) +
              linear[6] * (linear[1] * linear[5] - linear[4] * linear[2]);
        for (k = 0; k < 3; ++k) /* what the matrix takes to the eye at 0, or to the direction +z */
            eye[k] = round % 2 ? -(double)mvf[12 + k] : (double)(k == 2);
        for (k = 0; k < 3; ++k) { /* Cramer's rule */
            double m[9];
            memcpy(m, linear, sizeof m);
            memcpy(m + 3 * k, eye, sizeof eye);
            expected[k] = (m[0] * (m[4] * m[8] - m[7] * m[5]) - m[3] * (m[1] * m[8] - m[7] * m[2]) +
                           m[6] * (m[1] * m[5] - m[4] * m[2])) /
                          det;
            length += expected[k] * expected[k];
        }
        if (round % 2) {
            assert_true(view.eye[3] > 0);
            for (k = 0; k < 3; ++k)
                assert_true(fabs(view.eye[k] / view.eye[3] - expected[k]) < 1e-9 * (1 + sqrt(length)));
        } else {
            double dot = 0, own = 0;
            assert_true(view.eye[3] == 0);
            for (k = 0; k < 3; ++k) {
                dot += view.eye[k] * expected[k];
                own += view.eye[k] * view.eye[k];
            }
            assert_true(dot > (1 - 1e-12) * sqrt(own * length));
        }
        mvf[0] = mvf[1] = mvf[2] = 0; /* singular */
        assert_int_equal(sil_view_from_matrices(mvf, pf, &view), SIL_INVALID_ARGUMENT);
        mvf[0] = NAN;
        assert_int_equal(sil_view_from_matrices(mvf, pf, &view), SIL_INVALID_ARGUMENT);
    }
    assert_int_equal(sil_view_from_matrices(NULL, NULL, NULL), SIL_INVALID_ARGUMENT);
}

/* ---- convex and concave ---- */

/* Every edge of two faces against the sign of big integers, the same from both sides, whatever else the edge is. */
static void check_folds(const shape *s, const sil_view *view, size_t counts[3]) {
    sil_mesh_desc desc = desc_of(s);
    sil_mesh *mesh;
    size_t count, i;
    sil_edge *edges;
    desc.crease_degrees = -1; /* every edge that is not flat is a line */
    mesh = sil_mesh_create(&desc, NULL);
    edges = extract_all(mesh, NULL, view, 15, &count);
    assert_int_equal(sil_extract(mesh, NULL, view, SIL_CONVEX | SIL_CONCAVE, NULL, 0), 0); /* cannot be asked for */
    assert_int_equal(sil_extract(mesh, NULL, view, SIL_CREASE | 48, NULL, 0),
                     sil_extract(mesh, NULL, view, SIL_CREASE, NULL, 0));
    for (i = 0; i < count; ++i) {
        int sign = 0, which, k;
        for (which = 0; which < 2; ++which) {
            const uint32_t *f = s->indices + 3 * edges[i].face[which], *g = s->indices + 3 * edges[i].face[1 - which];
            for (k = 0; k < 3; ++k)
                if (memcmp(s->positions + 3 * g[k], s->positions + 3 * edges[i].a, 12) != 0 &&
                    memcmp(s->positions + 3 * g[k], s->positions + 3 * edges[i].b, 12) != 0) {
                    const float *p = s->positions + 3 * g[k];
                    const double eye[4] = {(double)p[0], (double)p[1], (double)p[2], 1};
                    const int found =
                        true_sign(s->positions + 3 * f[0], s->positions + 3 * f[1], s->positions + 3 * f[2], eye);
                    assert_true(which == 0 || sign == found);
                    sign = found;
                }
        }
        assert_int_equal(edges[i].kinds & 48u, sign < 0 ? SIL_CONVEX : sign > 0 ? SIL_CONCAVE : 0);
        ++counts[sign + 1];
    }
    free(edges);
    sil_mesh_destroy(mesh);
}

static void test_convex_and_concave(void **state) {
    const float sheet[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, -1}; /* two triangles at the diagonal, folded */
    const uint32_t folded[6] = {0, 1, 2, 0, 2, 3}, flipped[6] = {0, 1, 2, 0, 3, 2}, turned[6] = {0, 2, 1, 0, 3, 2};
    size_t counts[3] = {0, 0, 0}, round, slight_folds = 0;
    (void)state;
    for (round = 0; round < 12; ++round) {
        const sil_view view = view_at(random_in(-3, 3), random_in(-3, 3), random_in(-3, 3), 1);
        shape s = round % 3 == 2 ? make_box(4, 4, 4) : make_torus(20, 12, 0.05, round % 3 ? 8 : 0);
        size_t i;
        for (i = 0; i < 3 * s.vertex_count && round == 3; ++i) /* nearly flat: double does not tell */
            s.positions[i] = i % 3 == 2 ? s.positions[i] * 1e-12f : s.positions[i] + 1000;
        check_folds(&s, round % 2 ? &view : NULL, counts);
        shape_free(&s);
    }
    print_message("folds: %zu convex, %zu flat, %zu concave\n", counts[0], counts[1], counts[2]);
    assert_true(counts[0] > 1000 && counts[2] > 500);
    for (round = 0; round < 3; ++round) {
        sil_mesh *mesh = mesh_of_arrays(sheet, 4, round == 0 ? folded : round == 1 ? flipped : turned, 6);
        sil_edge edge;
        assert_int_equal(sil_extract(mesh, NULL, NULL, SIL_CREASE, &edge, 1), 1);
        assert_int_equal(edge.kinds, SIL_CREASE | (round == 0 ? SIL_CONVEX : round == 1 ? 0 : SIL_CONCAVE));
        sil_mesh_destroy(mesh);
    }
    for (round = 0; round < 4; ++round) { /* a fold too small for double: seen as a silhouette from the first's plane */
        const float z = round / 2 ? 1e-37f : -1e-37f;
        const float slight[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, z};
        sil_mesh *mesh = mesh_of_arrays(slight, 4, folded, 6);
        const sil_view view = view_at(round % 2 ? -5 : 5, round % 2 ? 5 : -5, 0, 1);
        sil_edge edge;
        if (sil_extract(mesh, NULL, &view, SIL_SILHOUETTE, &edge, 1)) {
            assert_int_equal(edge.kinds, SIL_SILHOUETTE | (round / 2 ? SIL_CONCAVE : SIL_CONVEX));
            ++slight_folds;
        }
        sil_mesh_destroy(mesh);
    }
    assert_int_equal(slight_folds, 2);
}

/* ---- the hierarchy ---- */

/* Smooth, noisy, on a grid (edge-on faces), flat-sided, dirty. */
static shape hierarchy_shape(int number) {
    shape s = number == 3 ? make_box(60, 60, 60) : make_torus(300, 120, number == 1 ? 0.001 : 0, number == 2 ? 64 : 0);
    size_t i;
    if (number == 4)
        for (i = 0; i + 30 < s.index_count; i += 1 + random_below(300)) {
            const size_t at = i - i % 3;
            switch (random_below(4)) {
            case 0: /* a hole */
                s.indices[at] = s.indices[at + 1];
                break;
            case 1: /* another face at an edge */
                s.indices[at] = random_below(s.vertex_count);
                break;
            case 2: /* turned over */
                s.indices[at] ^= s.indices[at + 1];
                s.indices[at + 1] ^= s.indices[at];
                s.indices[at] ^= s.indices[at + 1];
                break;
            default: /* no area */
                memcpy(s.positions + 3 * s.indices[at], s.positions + 3 * s.indices[at + 1], 12);
            }
        }
    return s;
}

/* Anywhere inside, near and far, on vertices, on the planes of faces, parallel along axes and any way. */
static sil_view hierarchy_view(const shape *s, size_t number) {
    sil_view v = view_at(random_in(-2, 2), random_in(-2, 2), random_in(-2, 2), number % 3 != 0);
    const uint32_t *face = s->indices + 3 * random_below(s->index_count / 3);
    const double far_off = random_in(0, 1) < 0.5 ? 1e3 : 1e9, t[2] = {random_in(-3, 3), floor(random_in(-8, 9))};
    int k;
    for (k = 0; k < 3; ++k) {
        const double a = (double)s->positions[3 * face[0] + (uint32_t)k];
        const double b = (double)s->positions[3 * face[1] + (uint32_t)k];
        const double c = (double)s->positions[3 * face[2] + (uint32_t)k];
        switch (number % 8) {
        case 1:
            v.eye[k] *= far_off;
            break;
        case 2: /* close to the surface */
            v.eye[k] = a + 1e-3 * v.eye[k];
            break;
        case 3: /* along an axis */
            v.eye[k] = k == (int)(number / 8 % 3);
            break;
        case 4: /* a vertex; as a direction when w is 0 */
            v.eye[k] = a;
            break;
        case 5: /* on a face's plane, as near as double comes */
            v.eye[k] = a + t[0] * (b - a) + (1 - t[0]) * (c - a);
            break;
        case 6: /* exactly on it where coordinates are short */
            v.eye[k] = a + t[1] * (b - a);
            break;
        default:
            break;
        }
    }
    return v;
}

static void test_hierarchy(void **state) {
    size_t taken = 0, number, lines = 0;
    int which;
    (void)state;
    for (which = 0; which < 5; ++which) {
        shape s = hierarchy_shape(which);
        sil_mesh_desc desc = desc_of(&s);
        sil_mesh *flat, *tree;
        sil_pose *flat_pose, *tree_pose;
        desc.flags = SIL_MESH_NO_HIERARCHY;
        flat = sil_mesh_create(&desc, NULL);
        flat_pose = sil_pose_create(flat, NULL);
        desc.flags = SIL_MESH_HIERARCHY;
        tree = sil_mesh_create(&desc, NULL);
        tree_pose = sil_pose_create(tree, NULL);
        assert_non_null(flat_pose);
        assert_non_null(tree_pose);
        assert_int_equal(sil_mesh_get_info(flat).hierarchy_bytes, 0);
        assert_true(sil_mesh_get_info(tree).hierarchy_bytes > 8 * sil_mesh_get_info(tree).face_count);
        for (number = 0; number < 120; ++number) {
            const sil_view view = hierarchy_view(&s, number);
            const unsigned kinds = number % 2 ? SIL_SILHOUETTE : 1 | random_below(16);
            sil_edge *expected, *edges;
            size_t expected_count, count;
            expected = extract_all(flat, flat_pose, &view, kinds, &expected_count);
            count = sil_extract(tree, tree_pose, &view, kinds, NULL, 0);
            assert_int_equal(count, expected_count);
            taken += tree_pose->looked > 0;
            assert_int_equal(flat_pose->looked, 0);
            lines += count;
            edges = (sil_edge *)malloc((count + 1) * sizeof *edges);
            assert_int_equal(sil_extract(tree, tree_pose, &view, kinds, edges, count), count);
            assert_memory_equal(edges, expected, count * sizeof *edges);
            free(edges);
            free(expected);
        }
        sil_pose_destroy(flat_pose);
        sil_pose_destroy(tree_pose);
        sil_mesh_destroy(flat);
        sil_mesh_destroy(tree);
        shape_free(&s);
    }
    print_message("hierarchy: taken in %zu of 600 views, %zu lines\n", taken, lines);
    assert_true(taken > 200);
}

/* Dense silhouettes need no other way: every patch is looked at, once. A pose that was set has no hierarchy. */
static void test_hierarchy_when_dense(void **state) {
    shape s = make_torus(300, 120, 0.1, 0), smooth = make_torus(300, 120, 0, 0);
    sil_mesh_desc desc = desc_of(&s);
    const sil_view view = view_at(3, 2, 1, 1);
    sil_mesh *mesh;
    sil_pose *pose;
    size_t patches;
    (void)state;
    mesh = sil_mesh_create(&desc, NULL); /* 108,000 edges: it has one by itself */
    pose = sil_pose_create(mesh, NULL);
    patches = mesh->patches->count;
    assert_true(sil_mesh_get_info(mesh).hierarchy_bytes > 0);
    assert_true(sil_extract(mesh, pose, &view, SIL_SILHOUETTE, NULL, 0) > 1000);
    assert_in_range(pose->looked, patches / 2, patches);
    assert_int_equal(sil_pose_set(pose, smooth.positions, 0), SIL_OK);
    assert_true(sil_extract(mesh, pose, &view, SIL_SILHOUETTE, NULL, 0) > 100);
    assert_int_equal(pose->looked, 0);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    desc = desc_of(&smooth);
    mesh = sil_mesh_create(&desc, NULL);
    pose = sil_pose_create(mesh, NULL);
    assert_true(sil_extract(mesh, pose, &view, SIL_SILHOUETTE, NULL, 0) > 100);
    assert_in_range(pose->looked, 1, patches / 4);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    shape_free(&s);
    shape_free(&smooth);
}

/* ---- distances ---- */

static long double true_distance(const float *v, const float *p, const float *q, const float *model, int endless) {
    long double w[3] = {0, 0, 0}, e[3] = {0, 0, 0}, dot = 0, square = 0, t, sum = 0;
    int i, k;
    for (i = 0; i < 3; ++i) {
        for (k = 0; k < 3; ++k) {
            w[i] += (long double)model[3 * k + i] * ((long double)v[k] - (long double)p[k]);
            e[i] += (long double)model[3 * k + i] * ((long double)q[k] - (long double)p[k]);
        }
        dot += w[i] * e[i];
        square += e[i] * e[i];
    }
    t = square > 0 ? dot / square : 0;
    if (!endless)
        t = t < 0 ? 0 : t > 1 ? 1 : t;
    for (i = 0; i < 3; ++i)
        sum += (w[i] - t * e[i]) * (w[i] - t * e[i]);
    return sqrtl(sum);
}

static void check_distances(const shape *s, const float *model, int flags, double offset, double *worst) {
    sil_mesh *mesh = mesh_of(s);
    const sil_view view = view_at(offset + 3, offset + 2, offset + 1.5, 1);
    const sil_view *which = flags & 2 ? NULL : &view;
    size_t count, i, k;
    sil_edge *edges = extract_all(mesh, NULL, which, 15, &count);
    float *distances = (float *)malloc(s->vertex_count * sizeof(float));
    uint32_t *nearest = (uint32_t *)malloc(s->vertex_count * sizeof(uint32_t));
    const double size = 2 * (double)sil_max_distance(mesh, NULL, model);
    sil_distance_desc desc;
    assert_non_null(distances);
    assert_non_null(nearest);
    assert_true(count > 5);
    memset(&desc, 0, sizeof desc);
    memcpy(desc.model, model, sizeof desc.model);
    desc.flags = flags & 1 ? SIL_DISTANCE_INFINITE_LINE : 0;
    for (i = 0; i < s->vertex_count; i += 17) /* in ranges */
        assert_int_equal(sil_distances(mesh, NULL, edges, count, &desc, i,
                                       s->vertex_count - i < 17 ? s->vertex_count - i : 17, distances + i, nearest + i),
                         SIL_OK);
    for (i = 0; i < s->vertex_count; ++i) {
        const float *v = s->positions + 3 * i, *p = s->positions;
        long double best = 1e30L, at;
        for (k = 0; k < count; ++k) {
            const long double d = true_distance(v, p + 3 * edges[k].a, p + 3 * edges[k].b, model, flags & 1);
            best = d < best ? d : best;
        }
        at = true_distance(v, p + 3 * edges[nearest[i]].a, p + 3 * edges[nearest[i]].b, model, flags & 1);
        *worst = fmax(*worst, (double)fabsl((long double)distances[i] - best) / size);
        *worst = fmax(*worst, (double)fabsl(at - best) / size);
    }
    free(distances);
    free(nearest);
    free(edges);
    sil_mesh_destroy(mesh);
}

/* Exactly 0 at both ends of an edge, though the foot of the perpendicular is rounded. */
static void check_ends(const shape *s) {
    sil_mesh *mesh = mesh_of(s);
    size_t count, i;
    sil_edge *edges = extract_all(mesh, NULL, NULL, 15, &count);
    for (i = 0; i < count; ++i) {
        float d;
        assert_int_equal(sil_distances(mesh, NULL, &edges[i], 1, NULL, edges[i].a, 1, &d, NULL), SIL_OK);
        assert_true(d <= 0);
        assert_int_equal(sil_distances(mesh, NULL, &edges[i], 1, NULL, edges[i].b, 1, &d, NULL), SIL_OK);
        assert_true(d <= 0);
    }
    free(edges);
    sil_mesh_destroy(mesh);
}

static void test_distances(void **state) {
    static const float models[4][9] = {{1, 0, 0, 0, 1, 0, 0, 0, 1},         /* identity */
                                       {3, 0.5f, 0, -1, 0.2f, 0, 0, 1, -2}, /* stretched, sheared, mirrored */
                                       {1, 2, 0, 2, 4, 0, 0, 0, 1},         /* singular: flattens */
                                       {1e-9f, 0, 0, 0, 1e-9f, 0, 0, 0, 1e-9f}};
    shape torus = make_torus(16, 9, 0.05, 0);
    double worst = 0;
    size_t i;
    int m, flags;
    (void)state;
    for (m = 0; m < 4; ++m)
        for (flags = 0; flags < 4; ++flags)
            check_distances(&torus, models[m], flags, 0, &worst);
    check_ends(&torus);
    for (i = 0; i < 3 * torus.vertex_count; ++i)
        torus.positions[i] = (float)((double)torus.positions[i] + 1000); /* far from the origin: as precise */
    check_distances(&torus, models[0], 0, 1000, &worst);
    for (i = 0; i < 3 * torus.vertex_count; ++i)
        torus.positions[i] = (float)(((double)torus.positions[i] - 1000) * 1e30);
    check_distances(&torus, models[0], 0, 0, &worst);
    print_message("distances: worst error %.3g of the mesh's size\n", worst);
    assert_true(worst < 1e-6);
    shape_free(&torus);
}

static void test_distance_rules(void **state) {
    /* a strip of two quads in the plane, then a vertex no face has, and one that is not finite */
    const float positions[8 * 3] = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 1, 3, 4, NAN, 0, 0};
    const uint32_t indices[12] = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
    sil_mesh *mesh = mesh_of_arrays(positions, 8, indices, 12);
    sil_edge edges[16], swapped[16];
    const size_t count = sil_extract(mesh, NULL, NULL, SIL_BOUNDARY, edges, 16);
    float d[8];
    uint32_t nearest[8];
    sil_distance_desc desc;
    size_t i;
    (void)state;
    assert_int_equal(count, 6);
    assert_int_equal(sil_distances(mesh, NULL, edges, count, NULL, 0, 8, d, nearest), SIL_OK);
    for (i = 0; i < 6; ++i) {
        assert_true(d[i] <= 0);
        for (size_t k = 0; k < nearest[i]; ++k) /* of the edges that meet there, the first */
            assert_true(edges[k].a != i && edges[k].b != i);
    }
    assert_true(fabs((double)d[6] - sqrt(20)) < 1e-6);
    assert_true(isinf(d[7]) && nearest[7] == SIL_NONE);
    for (i = 0; i < count; ++i)
        swapped[i] = edges[count - 1 - i];
    {
        float d2[8];
        uint32_t nearest2[8];
        assert_int_equal(sil_distances(mesh, NULL, swapped, count, NULL, 0, 8, d2, nearest2), SIL_OK);
        for (i = 0; i < 7; ++i)
            assert_int_equal(swapped[nearest2[i]].edge, edges[nearest[i]].edge);
    }
    assert_int_equal(sil_distances(mesh, NULL, NULL, 0, NULL, 0, 8, d, nearest), SIL_OK);
    assert_true(isinf(d[0]) && nearest[0] == SIL_NONE);
    memset(&desc, 0, sizeof desc);
    desc.model[0] = 1; /* flattens to the x axis: edges along y are points */
    assert_int_equal(sil_distances(mesh, NULL, edges, count, &desc, 0, 8, d, NULL), SIL_OK);
    for (i = 0; i < 7; ++i)
        assert_true(d[i] <= 0);
    desc.model[0] = INFINITY;
    assert_int_equal(sil_distances(mesh, NULL, edges, count, &desc, 0, 8, d, NULL), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_distances(mesh, NULL, edges, count, NULL, 7, 2, d, NULL), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_distances(mesh, NULL, edges, count, NULL, 9, 0, d, NULL), SIL_INVALID_ARGUMENT);
    assert_true(fabs((double)sil_max_distance(mesh, NULL, NULL) - sqrt(1.25)) < 1e-6); /* not the stray vertex */
    sil_mesh_destroy(mesh);
}

/* The tree against all pairs, bit by bit: distances and the nearest edge, in ranges and at the same places given as
   points. Returns how many different edges were the nearest somewhere. */
static size_t check_tree(const sil_mesh *mesh, const sil_pose *pose, const sil_edge *edges, size_t count,
                         const float *positions, const float *model) {
    const size_t vertices = sil_mesh_get_info(mesh).vertex_count, range = 1 + random_below(2 * vertices);
    float *d = (float *)malloc(3 * (vertices + 1) * sizeof(float));
    uint32_t *n = (uint32_t *)malloc(3 * (vertices + 1) * sizeof(uint32_t));
    unsigned char *seen = (unsigned char *)calloc(count + 1, 1);
    sil_edge_tree *tree = sil_edge_tree_create(mesh, NULL);
    sil_distance_desc desc;
    size_t i, different = 0;
    assert_non_null(tree);
    assert_non_null(d);
    assert_non_null(n);
    assert_non_null(seen);
    memset(&desc, 0, sizeof desc);
    memcpy(desc.model, model, sizeof desc.model);
    assert_int_equal(sil_edge_tree_build(tree, pose, edges, count, &desc), SIL_OK);
    assert_int_equal(sil_distances(mesh, pose, edges, count, &desc, 0, vertices, d, n), SIL_OK);
    for (i = 0; i < vertices; i += range) {
        const size_t some = vertices - i < range ? vertices - i : range;
        assert_int_equal(sil_distances_by_tree(tree, i, some, d + vertices + i, n + vertices + i), SIL_OK);
    }
    assert_int_equal(sil_distances_at(tree, positions, 0, vertices, d + 2 * vertices, n + 2 * vertices), SIL_OK);
    assert_memory_equal(d, d + vertices, vertices * sizeof(float));
    assert_memory_equal(n, n + vertices, vertices * sizeof(uint32_t));
    assert_memory_equal(d, d + 2 * vertices, vertices * sizeof(float));
    assert_memory_equal(n, n + 2 * vertices, vertices * sizeof(uint32_t));
    assert_int_equal(sil_distances_by_tree(tree, 0, vertices, d + vertices, NULL), SIL_OK);
    assert_memory_equal(d, d + vertices, vertices * sizeof(float));
    for (i = 0; i < vertices; ++i)
        if (n[i] != SIL_NONE && !seen[n[i]]) {
            seen[n[i]] = 1;
            ++different;
        }
    sil_edge_tree_destroy(tree);
    free(d);
    free(n);
    free(seen);
    return different;
}

/* Vertices in a random order: neighbours in the array are far from each other. */
static void shuffle_vertices(shape *s) {
    uint32_t *to = (uint32_t *)malloc(s->vertex_count * sizeof(uint32_t));
    float *moved = (float *)malloc(3 * s->vertex_count * sizeof(float));
    size_t i;
    assert_non_null(to);
    assert_non_null(moved);
    for (i = 0; i < s->vertex_count; ++i) {
        const size_t other = random_below(i + 1);
        to[i] = to[other];
        to[other] = (uint32_t)i;
    }
    for (i = 0; i < s->vertex_count; ++i)
        memcpy(moved + 3 * (size_t)to[i], s->positions + 3 * i, 3 * sizeof(float));
    for (i = 0; i < s->index_count; ++i)
        s->indices[i] = to[s->indices[i]];
    free(s->positions);
    s->positions = moved;
    free(to);
}

static void test_distance_tree(void **state) {
    static const float models[4][9] = {{1, 0, 0, 0, 1, 0, 0, 0, 1},
                                       {3, 0.5f, 0, -1, 0.2f, 0, 0, 1, -2},
                                       {1, 2, 0, 2, 4, 0, 0, 0, 1},
                                       {1e-9f, 0, 0, 0, 1e-9f, 0, 0, 0, 1e-9f}};
    size_t different = 0, round;
    (void)state;
    for (round = 0; round < 40; ++round) { /* noise, coarse grids (many ties), shuffled, huge, far from the origin */
        shape s = round % 4 == 3 ? make_box(7, 7, 7)
                                 : make_torus(20 + (int)random_below(40), 9 + (int)random_below(20),
                                              round % 2 ? 0.1 : 0, round % 3 == 1 ? 8 : 0);
        const sil_view view = view_at(random_in(-3, 3), random_in(-3, 3), random_in(-3, 3), 1);
        sil_edge *edges;
        sil_mesh *mesh;
        sil_pose *pose;
        size_t count, i;
        if (round % 5 == 4)
            shuffle_vertices(&s);
        mesh = mesh_of(&s);
        pose = sil_pose_create(mesh, NULL);
        for (i = 0; i < 3 * s.vertex_count && round % 3 == 2; ++i)
            s.positions[i] = (float)((double)s.positions[i] * (round % 2 ? 1e20 : 0.01) + (round % 2 ? 0 : 100));
        assert_int_equal(sil_pose_set(pose, s.positions, 0), SIL_OK);
        edges = extract_all(mesh, pose, round % 7 == 6 ? NULL : &view, round % 7 == 6 ? 15 : 1, &count);
        different += check_tree(mesh, pose, edges, count, s.positions, models[round % 4]);
        for (i = 0; i < count; ++i) { /* in any order, some twice, some not of this mesh */
            const size_t other = random_below(i + 1);
            const sil_edge edge = edges[i];
            edges[i] = edges[other];
            edges[other] = edge;
            if (i % 50 == 49)
                edges[i].edge = i % 100 == 99 ? SIL_NONE : edges[0].edge;
        }
        different += check_tree(mesh, pose, edges, count, s.positions, models[round % 3]);
        free(edges);
        sil_pose_destroy(pose);
        sil_mesh_destroy(mesh);
        shape_free(&s);
    }
    print_message("tree: %zu edges were the nearest of some vertex\n", different);
    assert_true(different > 3000);
}

/* Points that are no vertices: anywhere, unaligned, not finite, and so far that squares overflow. */
/* Points that lie in a plane but for a denormal: their box has places to sort them by in no more than two directions. */
static void test_distances_at_flat_points(void **state) {
    static const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const float points[12] = {0.25f, 0, 0, 0.25f, 1e-42f, 0, 0.75f, 0, 1e-44f, 0.5f, 0.5f, 0};
    const sil_distance_desc *as_it_is = NULL;
    sil_mesh_desc desc;
    sil_edge edges[3];
    float distances[4];
    (void)state;
    memset(&desc, 0, sizeof desc);
    desc.positions = corners;
    desc.vertex_count = 3;
    sil_mesh *mesh = sil_mesh_create(&desc, NULL);
    sil_edge_tree *tree = sil_edge_tree_create(mesh, NULL);
    assert_int_equal(sil_extract(mesh, NULL, NULL, SIL_BOUNDARY, edges, 3), 3);
    assert_int_equal(sil_edge_tree_build(tree, NULL, edges, 3, as_it_is), SIL_OK);
    assert_int_equal(sil_distances_at(tree, points, 0, 4, distances, NULL), SIL_OK);
    for (int i = 0; i < 4; ++i)
        assert_true(distances[i] < 1e-6f);
    sil_edge_tree_destroy(tree);
    sil_mesh_destroy(mesh);
}

static void test_distances_at(void **state) {
    shape torus = make_torus(30, 12, 0.02, 0);
    sil_mesh *mesh = mesh_of(&torus);
    sil_edge_tree *tree = sil_edge_tree_create(mesh, NULL);
    const float identity9[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    enum { POINT_COUNT = 3000, STRIDE = 13 };
    char *bytes = (char *)malloc(POINT_COUNT * STRIDE);
    float d[POINT_COUNT], before;
    uint32_t n[POINT_COUNT];
    size_t count, i, k;
    sil_edge *edges = extract_all(mesh, NULL, NULL, SIL_CREASE, &count);
    sil_distance_desc desc;
    double worst = 0;
    (void)state;
    assert_non_null(bytes);
    assert_true(count > 20);
    assert_int_equal(sil_distances_at(tree, torus.positions, 0, 1, d, n), SIL_INVALID_ARGUMENT); /* not built */
    assert_int_equal(sil_edge_tree_build(tree, NULL, edges, count, NULL), SIL_OK);
    for (i = 0; i < POINT_COUNT; ++i) {
        const double reach = i % 3 == 0 ? 1.5 : i % 3 == 1 ? 1e4 : 3e38;
        float p[3];
        for (k = 0; k < 3; ++k)
            p[k] = (float)random_in(-reach, reach);
        if (i == 77)
            p[1] = NAN;
        if (i == 78)
            p[2] = -INFINITY;
        memcpy(bytes + STRIDE * i, p, sizeof p);
    }
    assert_int_equal(sil_distances_at(tree, (const float *)(const void *)bytes, STRIDE, POINT_COUNT, d, n), SIL_OK);
    for (i = 0; i < POINT_COUNT; ++i) {
        long double best = 1e60L, size = 0;
        float p[3];
        memcpy(p, bytes + STRIDE * i, sizeof p);
        if (i == 77 || i == 78) {
            assert_true(isinf(d[i]) && d[i] > 0 && n[i] == SIL_NONE);
            continue;
        }
        for (k = 0; k < count; ++k) {
            const long double at =
                true_distance(p, torus.positions + 3 * edges[k].a, torus.positions + 3 * edges[k].b, identity9, 0);
            best = at < best ? at : best;
        }
        size = best > 2 ? best : 2;
        if (best < 3.4e38L) /* a diagonal may be longer than a float holds: infinite then */
            worst = fmax(worst, (double)(fabsl((long double)d[i] - best) / size));
    }
    print_message("distances at points: worst error %.3g\n", worst);
    assert_true(worst < 1e-6);
    before = d[0];
    memset(&desc, 0, sizeof desc);
    desc.flags = SIL_DISTANCE_INFINITE_LINE;
    assert_int_equal(sil_edge_tree_build(tree, NULL, edges, count, &desc), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_distances_at(tree, torus.positions, 0, 1, d, n), SIL_INVALID_ARGUMENT); /* nothing old stays */
    assert_true(d[0] <= before && d[0] >= before);
    assert_int_equal(sil_edge_tree_build(tree, NULL, NULL, 0, NULL), SIL_OK);
    assert_int_equal(sil_distances_at(tree, torus.positions, 0, 1, d, n), SIL_OK);
    assert_true(isinf(d[0]) && n[0] == SIL_NONE);
    assert_int_equal(sil_distances_at(tree, torus.positions, 4, 1, d, n), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_distances_by_tree(tree, 0, torus.vertex_count + 1, d, n), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_distances_by_tree(NULL, 0, 0, d, n), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_edge_tree_build(NULL, NULL, NULL, 0, NULL), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_edge_tree_reserve(NULL, 1), SIL_INVALID_ARGUMENT);
    assert_null(sil_edge_tree_create(NULL, NULL));
    assert_int_equal(sil_edge_tree_bytes(NULL), 0);
    sil_edge_tree_destroy(tree);
    sil_edge_tree_destroy(NULL);
    free(bytes);
    free(edges);
    sil_mesh_destroy(mesh);
    shape_free(&torus);
}

/* ---- ribbons ---- */

enum { SCREEN = 96, POINTS = 12 };

/* A mesh of bare vertices: strips may name any of them. */
static sil_mesh *points_mesh(const float *positions, size_t count) {
    sil_mesh_desc desc;
    sil_mesh *mesh;
    memset(&desc, 0, sizeof desc);
    desc.positions = positions;
    desc.vertex_count = count;
    desc.indices = (const uint32_t *)(const void *)positions; /* none are read */
    desc.weld_distance = -1;
    mesh = sil_mesh_create(&desc, NULL);
    assert_non_null(mesh);
    return mesh;
}

static sil_ribbon_desc screen_desc(void) {
    sil_ribbon_desc desc;
    double p[16], m[16];
    memset(&desc, 0, sizeof desc);
    identity(m);
    orthographic(p, SCREEN / 2.0, SCREEN / 2.0, -10, 10);
    m[12] = m[13] = -SCREEN / 2.0;
    narrow(m, desc.model_view);
    narrow(p, desc.projection);
    desc.viewport_width = desc.viewport_height = SCREEN;
    return desc;
}

static sil_ribbon_vertex *ribbons_all(const sil_mesh *mesh, const sil_strip *strip, const uint32_t *vertices,
                                      const sil_ribbon_desc *desc, size_t *count) {
    sil_ribbon_vertex *out;
    *count = sil_ribbons(mesh, NULL, strip, 1, vertices, desc, NULL, 0);
    assert_int_equal(*count % 3, 0);
    out = (sil_ribbon_vertex *)malloc((*count + 1) * sizeof *out);
    assert_non_null(out);
    assert_int_equal(sil_ribbons(mesh, NULL, strip, 1, vertices, desc, out, *count), *count);
    return out;
}

static int inside(const sil_ribbon_vertex *t, double x, double y) {
    double edge[3];
    int k;
    for (k = 0; k < 3; ++k) {
        const sil_ribbon_vertex *a = &t[k], *b = &t[(k + 1) % 3];
        edge[k] =
            ((double)b->x - (double)a->x) * (y - (double)a->y) - ((double)b->y - (double)a->y) * (x - (double)a->x);
    }
    return (edge[0] >= -1e-4 && edge[1] >= -1e-4 && edge[2] >= -1e-4) ||
           (edge[0] <= 1e-4 && edge[1] <= 1e-4 && edge[2] <= 1e-4);
}

static int covered(const sil_ribbon_vertex *triangles, size_t count, double x, double y) {
    size_t i;
    for (i = 0; i < count; i += 3)
        if (inside(triangles + i, x, y))
            return 1;
    return 0;
}

static double segment_distance(const double *p, const double *q, double x, double y) {
    const double ex = q[0] - p[0], ey = q[1] - p[1], square = ex * ex + ey * ey;
    double t = square > 0 ? ((x - p[0]) * ex + (y - p[1]) * ey) / square : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return hypot(x - p[0] - t * ex, y - p[1] - t * ey);
}

/* Covered pixels against the distance of their centres to the polyline; out of account are those within the stated
   tolerance of the ribbon's border. Returns how many. */
static size_t check_pixels(const sil_ribbon_vertex *triangles, size_t count, double (*line)[4], int segments,
                           double half, double tolerance) {
    size_t left_out = 0;
    int x, y, i;
    for (y = 0; y < SCREEN; ++y)
        for (x = 0; x < SCREEN; ++x) {
            double d = 1e9;
            for (i = 0; i < segments; ++i)
                d = fmin(d, segment_distance(line[i], line[i] + 2, x + 0.5, y + 0.5));
            if (d > half - tolerance && d < half + 0.01) {
                ++left_out;
                continue;
            }
            assert_int_equal(covered(triangles, count, x + 0.5, y + 0.5), d < half);
        }
    return left_out;
}

static void test_ribbon_pixels(void **state) {
    size_t left_out = 0;
    int round, i;
    (void)state;
    for (round = 0; round < 60; ++round) {
        float positions[3 * POINTS];
        uint32_t vertices[POINTS + 1];
        double line[POINTS][4];
        sil_strip strip = {0, POINTS, 0, SIL_CREASE, 0};
        sil_ribbon_desc desc = screen_desc();
        const double half = round % 3 == 0 ? 0.75 : random_in(0.6, 12);
        sil_mesh *mesh;
        sil_ribbon_vertex *triangles;
        size_t count;
        for (i = 0; i < POINTS; ++i) {
            /* some far outside, some in small steps, some repeated, some going back */
            const double reach = round % 4 == 0 ? 4 * SCREEN : SCREEN;
            positions[3 * i] = (float)random_in(-reach / 4, reach);
            positions[3 * i + 1] = (float)random_in(-reach / 4, reach);
            positions[3 * i + 2] = (float)random_in(-5, 5);
            if (i > 1 && round % 5 == 1)
                memcpy(positions + 3 * i, positions + 3 * (i - (int)random_below(2) - 1), 8);
            if (i > 0 && round % 5 == 2) {
                positions[3 * i] = (float)((double)positions[3 * i - 3] + random_in(-2, 2));
                positions[3 * i + 1] = (float)((double)positions[3 * i - 2] + random_in(0, 3));
            }
            vertices[i] = (uint32_t)i;
        }
        vertices[POINTS] = 0;
        strip.closed = (uint32_t)(round % 2);
        strip.count += strip.closed;
        for (i = 0; i + 1 < (int)strip.count; ++i) {
            line[i][0] = (double)positions[3 * i];
            line[i][1] = (double)positions[3 * i + 1];
            line[i][2] = (double)positions[3 * vertices[i + 1]];
            line[i][3] = (double)positions[3 * vertices[i + 1] + 1];
        }
        desc.width = (float)(half / 2);
        desc.width_scale[2] = 4; /* of creases */
        mesh = points_mesh(positions, POINTS);
        triangles = ribbons_all(mesh, &strip, vertices, &desc, &count);
        left_out += check_pixels(triangles, count, line, (int)strip.count - 1, half, 0.101);
        for (i = 0; i < (int)count; ++i) { /* nothing far away, and the centre line where it should be */
            const sil_ribbon_vertex *v = &triangles[i];
            const double limit = 3 * half + 4;
            assert_true((double)v->x > -limit && (double)v->x < SCREEN + limit);
            assert_true((double)v->y > -limit && (double)v->y < SCREEN + limit);
            assert_true(hypot((double)v->x - (double)v->center_x, (double)v->y - (double)v->center_y) < half + 1e-3);
            assert_int_equal(v->kinds, SIL_CREASE);
        }
        free(triangles);
        sil_mesh_destroy(mesh);
    }
    print_message("ribbons: %.2f %% of the pixels left out\n", 100.0 * (double)left_out / (60.0 * SCREEN * SCREEN));
    assert_true(left_out < 60 * SCREEN * SCREEN / 10);
}

/* In perspective, with points behind the eye: against the lines clipped and projected here, in eye space. */
static void test_ribbon_clipping(void **state) {
    int round, i, k;
    size_t drawn = 0;
    (void)state;
    for (round = 0; round < 60; ++round) {
        float positions[3 * POINTS];
        uint32_t vertices[POINTS];
        double line[POINTS][4], p[16], m[16];
        sil_strip strip = {0, POINTS, 0, SIL_SILHOUETTE, 0};
        sil_ribbon_desc desc = screen_desc();
        sil_mesh *mesh;
        sil_ribbon_vertex *triangles;
        size_t count;
        int segments = 0;
        for (i = 0; i < POINTS; ++i) {
            for (k = 0; k < 3; ++k)
                positions[3 * i + k] = (float)random_in(-3, 3);
            vertices[i] = (uint32_t)i;
        }
        identity(m);
        narrow(m, desc.model_view);
        perspective(p, 1, 1, 0.25, 50, round % 2);
        narrow(p, desc.projection);
        desc.flags = round % 2 ? SIL_RIBBON_ZERO_TO_ONE : 0;
        desc.width = 3;
        for (i = 0; i + 1 < POINTS; ++i) {
            double end[2][3], a = -(double)positions[3 * i + 2] - 0.25, b = -(double)positions[3 * i + 5] - 0.25,
                              t[2] = {0, 1};
            if (a < 0 && b < 0)
                continue;
            if (a < 0)
                t[0] = a / (a - b);
            if (b < 0)
                t[1] = a / (a - b);
            for (k = 0; k < 3; ++k) {
                const double from = (double)positions[3 * i + k], to = (double)positions[3 * i + 3 + k];
                end[0][k] = from + t[0] * (to - from);
                end[1][k] = from + t[1] * (to - from);
            }
            for (k = 0; k < 4; ++k)
                line[segments][k] = SCREEN / 2.0 * (end[k / 2][k % 2] / -end[k / 2][2] + 1);
            ++segments;
        }
        mesh = points_mesh(positions, POINTS);
        triangles = ribbons_all(mesh, &strip, vertices, &desc, &count);
        (void)check_pixels(triangles, count, line, segments, 1.5, 0.101);
        for (i = 0; i < (int)count; ++i) {
            assert_true(fabs((double)triangles[i].x - SCREEN / 2.0) < SCREEN / 2.0 + 12);
            assert_true(fabs((double)triangles[i].y - SCREEN / 2.0) < SCREEN / 2.0 + 12);
            assert_true(triangles[i].depth >= 0 && triangles[i].depth <= 1);
        }
        drawn += count;
        free(triangles);
        sil_mesh_destroy(mesh);
    }
    assert_true(drawn > 1000);
}

/* Depth, slack and arc of one line along the view, against steps toward the eye. */
static void test_ribbon_values(void **state) {
    int round, i;
    (void)state;
    for (round = 0; round < 120; ++round) {
        const int ortho = round % 3 == 0, reversed = round % 3 == 1;
        const double z0 = -random_in(1, 20), x0 = random_in(-0.3, 0.3) * -z0, y0 = random_in(-0.3, 0.3) * -z0,
                     focal = 1.7;
        const float positions[6] = {(float)x0,         (float)y0,         (float)z0,
                                    (float)(x0 * 0.5), (float)(y0 * 0.5), (float)(z0 * 1.1)};
        const uint32_t vertices[2] = {0, 1};
        const sil_strip strip = {0, 2, 0, SIL_BOUNDARY, 0};
        const double r = sqrt(x0 * x0 + y0 * y0 + z0 * z0), step = 1e-5 * r;
        double p[16], mv[16], depth[2], pixel, toward[3], expected;
        sil_ribbon_desc desc = screen_desc();
        sil_mesh *mesh = points_mesh(positions, 2);
        sil_ribbon_vertex *triangles;
        size_t count;
        identity(mv);
        if (ortho)
            orthographic(p, 20, 20, 0.5, 60);
        else
            perspective(p, focal, 1, 0.5, 60, reversed);
        narrow(mv, desc.model_view);
        narrow(p, desc.projection);
        desc.flags = reversed ? SIL_RIBBON_ZERO_TO_ONE : 0;
        desc.cap = SIL_CAP_BUTT;
        toward[0] = ortho ? 0 : -x0 / r;
        toward[1] = ortho ? 0 : -y0 / r;
        toward[2] = ortho ? 1 : -z0 / r;
        /* One pixel's size across the way to the eye: in perspective a pixel is 2 / (SCREEN * focal) of the depth on
           the plane z = -1, which is slanted to that way by the cosine c = -z0 / r, so that its area there is c of
           that. */
        pixel = ortho ? 40.0 / SCREEN : -z0 * 2 / (SCREEN * focal) * sqrt(-z0 / r);
        for (i = 0; i < 2; ++i) {
            const double z = z0 + (i ? step * toward[2] : 0), w = ortho ? 1 : -z;
            depth[i] = (p[10] * z + p[14]) / w;
            depth[i] = reversed ? depth[i] : 0.5 * depth[i] + 0.5;
        }
        expected = fabs(depth[1] - depth[0]) / step * pixel;
        triangles = ribbons_all(mesh, &strip, vertices, &desc, &count);
        assert_int_equal(count, 6);
        for (i = 0; i < 6; ++i) {
            const sil_ribbon_vertex *v = &triangles[i];
            if (v->arc > 0) {
                assert_true(fabs((double)v->arc - hypot((double)(v->center_x - triangles[0].center_x),
                                                        (double)(v->center_y - triangles[0].center_y))) < 1e-4);
                continue;
            }
            assert_true(fabs((double)v->depth - depth[0]) < 1e-6);
            assert_true(fabs((double)v->slack - expected) < 1e-3 * expected);
        }
        free(triangles);
        sil_mesh_destroy(mesh);
    }
}

/* Each setting against its neighbour, by points that one covers and the other does not. */
static void test_ribbon_settings(void **state) {
    const float positions[12] = {20, 20, 0, 60, 20, 0, 60, 60, 0, 60, 60, 1};
    const uint32_t vertices[5] = {0, 1, 2, 3, 2}, around[4] = {0, 1, 2, 0};
    sil_strip strip = {0, 3, 0, SIL_SILHOUETTE, 0};
    sil_ribbon_desc desc = screen_desc();
    sil_mesh *mesh = points_mesh(positions, 4);
    sil_ribbon_vertex *t, few[7];
    size_t count, fine;
    (void)state;
    desc.width = 10;
    t = ribbons_all(mesh, &strip, vertices, &desc, &count);
    assert_true(covered(t, count, 16, 20) && !covered(t, count, 15.5, 15.5)); /* round cap */
    assert_true(covered(t, count, 63, 17) && !covered(t, count, 64.5, 15.5)); /* round join */
    free(t);
    desc.tolerance = 0.02f;
    t = ribbons_all(mesh, &strip, vertices, &desc, &fine);
    assert_true(fine > count);
    free(t);
    desc.tolerance = 0;
    desc.cap = SIL_CAP_SQUARE;
    desc.join = SIL_JOIN_BEVEL;
    t = ribbons_all(mesh, &strip, vertices, &desc, &count);
    assert_true(covered(t, count, 15.5, 15.5) && !covered(t, count, 14.5, 20));
    assert_true(covered(t, count, 62, 18) && !covered(t, count, 63.4, 16.6));
    free(t);
    desc.cap = SIL_CAP_BUTT;
    desc.join = SIL_JOIN_NONE;
    t = ribbons_all(mesh, &strip, vertices, &desc, &count);
    assert_int_equal(count, 12);
    assert_true(!covered(t, count, 19, 20) && !covered(t, count, 62, 18));
    free(t);
    desc.join = SIL_JOIN_ROUND; /* a loop has a join where it closes, and no cap */
    strip.closed = 1;
    strip.count = 4;
    t = ribbons_all(mesh, &strip, around, &desc, &count);
    assert_true(covered(t, count, 18, 17) && !covered(t, count, 15.5, 15.5));
    free(t);
    desc.join = SIL_JOIN_NONE;
    strip.closed = 0;
    strip.count = 3;
    memset(few, 0, sizeof few);
    assert_int_equal(sil_ribbons(mesh, NULL, &strip, 1, vertices, &desc, few, 7), 12); /* whole triangles only */
    assert_true(few[5].x > 0 && few[6].x <= 0);
    strip.first = 2; /* a line along the view is a dot */
    strip.count = 3;
    desc.cap = SIL_CAP_ROUND;
    t = ribbons_all(mesh, &strip, vertices, &desc, &count);
    assert_true(covered(t, count, 56, 60) && covered(t, count, 64, 60) && covered(t, count, 60, 56));
    assert_true(!covered(t, count, 64, 64));
    free(t);
    desc.cap = SIL_CAP_SQUARE;
    t = ribbons_all(mesh, &strip, vertices, &desc, &count);
    assert_true(covered(t, count, 64, 64));
    free(t);
    desc.cap = SIL_CAP_BUTT;
    assert_int_equal(sil_ribbons(mesh, NULL, &strip, 1, vertices, &desc, NULL, 0), 0);
    desc.model_view[3] = NAN;
    assert_int_equal(sil_ribbons(mesh, NULL, &strip, 1, vertices, &desc, NULL, 0), 0);
    sil_mesh_destroy(mesh);
}

/* Arc starts again every 2^20 pixels, so that it keeps its precision on lines that are mostly outside. */
static void test_ribbon_arc(void **state) {
    const float positions[12] = {10, 10, 0, 3000000, 10, 0, 3000000, 20, 0, 10, 20, 0};
    const uint32_t vertices[4] = {0, 1, 2, 3};
    const sil_strip strip = {0, 4, 0, SIL_SILHOUETTE, 0};
    const sil_ribbon_desc desc = screen_desc();
    sil_mesh *mesh = points_mesh(positions, 4);
    size_t count, i;
    sil_ribbon_vertex *t = ribbons_all(mesh, &strip, vertices, &desc, &count);
    double longest = 0;
    (void)state;
    for (i = 0; i < count; ++i) {
        const double arc = (double)t[i].arc, x = (double)t[i].center_x;
        const double whole = (double)t[i].center_y < 15 ? x - 10 : 2999990 + 10 + (3000000 - x);
        assert_true(x > -10 && x < SCREEN + 10);
        assert_true(fabs(fmod(whole, 1048576) - arc) < 0.2);
        longest = fmax(longest, arc);
    }
    assert_true(longest > 1000); /* the way back was counted */
    free(t);
    sil_mesh_destroy(mesh);
}

/* ---- memory ---- */

typedef struct counting {
    size_t calls, live, fail_at;
} counting;

static void *counting_alloc(size_t size, void *user) {
    counting *c = (counting *)user;
    void *memory;
    if (c->calls++ == c->fail_at)
        return NULL;
    memory = malloc(size);
    c->live += memory != NULL;
    return memory;
}

static void counting_free(void *memory, void *user) {
    ((counting *)user)->live -= memory != NULL;
    free(memory);
}

static void test_every_allocation_may_fail(void **state) {
    shape torus = make_torus(8, 5, 0, 2), twice = shape_with_room(torus.vertex_count, 2 * torus.index_count / 3 + 1);
    size_t i, fail, failures = 0;
    int weld;
    (void)state;
    for (i = 0; i < torus.index_count; i += 3) {
        add_face(&twice, torus.indices[i], torus.indices[i + 1], torus.indices[i + 2]);
        add_face(&twice, torus.indices[i], torus.indices[i + 2], torus.indices[i + 1]);
    }
    memcpy(twice.positions, torus.positions, 12 * torus.vertex_count);
    twice.vertex_count = torus.vertex_count;
    for (weld = -1; weld <= 1; ++weld)
        for (fail = 0;; ++fail) {
            counting c = {0, 0, 0};
            sil_mesh_desc desc = desc_of(&twice);
            sil_result result;
            sil_mesh *mesh;
            sil_pose *pose;
            sil_edge_tree *tree;
            int failed = 0;
            c.fail_at = fail;
            desc.weld_distance = (float)weld * 0.01f;
            desc.flags = SIL_MESH_HIERARCHY;
            desc.allocator.alloc_fn = counting_alloc;
            desc.allocator.free_fn = counting_free;
            desc.allocator.user = &c;
            mesh = sil_mesh_create(&desc, &result);
            assert_int_equal(result, mesh ? SIL_OK : SIL_OUT_OF_MEMORY);
            failed = !mesh;
            if (mesh) {
                const sil_view view = view_at(2, 2, 2, 1);
                sil_edge edges[200];
                size_t needed, count;
                pose = sil_pose_create(mesh, &result);
                assert_int_equal(result, pose ? SIL_OK : SIL_OUT_OF_MEMORY);
                failed |= !pose;
                if (pose) {
                    result = sil_pose_set(pose, twice.positions, 0);
                    failed |= result != SIL_OK;
                    assert_true(result == SIL_OK || result == SIL_OUT_OF_MEMORY);
                    count = sil_extract(mesh, pose, &view, 15, edges, 200);
                    assert_true(count > 0 && count <= 200); /* works in the pose before */
                    (void)sil_chain(mesh, pose, edges, count, NULL, 0, NULL, 0, &needed);
                    failed |= needed == SIZE_MAX;
                    result = sil_pose_reserve(pose, 400);
                    failed |= result != SIL_OK;
                    (void)sil_chain(mesh, NULL, edges, count, NULL, 0, NULL, 0, &needed);
                    failed |= needed == SIZE_MAX;
                    tree = sil_edge_tree_create(mesh, &result);
                    assert_int_equal(result, tree ? SIL_OK : SIL_OUT_OF_MEMORY);
                    failed |= !tree;
                    if (tree) {
                        result = sil_edge_tree_build(tree, pose, edges, count, NULL);
                        assert_true(result == SIL_OK || result == SIL_OUT_OF_MEMORY);
                        failed |= result != SIL_OK;
                    }
                    sil_edge_tree_destroy(tree);
                }
                sil_pose_destroy(pose);
            }
            sil_mesh_destroy(mesh);
            assert_int_equal(c.live, 0);
            assert_int_equal(failed, c.calls > fail);
            failures += (size_t)failed;
            if (!failed)
                break;
        }
    print_message("memory: %zu failures, none leaked\n", failures);
    assert_true(failures > 90);
    shape_free(&torus);
    shape_free(&twice);
}

static void test_steady_frames_allocate_nothing(void **state) {
    shape torus = make_torus(20, 12, 0.1, 0);
    counting c = {0, 0, SIZE_MAX};
    sil_mesh_desc desc = desc_of(&torus);
    sil_mesh *mesh;
    sil_pose *pose;
    static sil_edge edges[2000];
    static sil_strip strips[2000];
    static uint32_t vertices[4000];
    static float distances[240];
    sil_ribbon_desc ribbon = screen_desc();
    sil_edge_tree *tree;
    size_t before, frame;
    (void)state;
    desc.allocator.alloc_fn = counting_alloc;
    desc.allocator.free_fn = counting_free;
    desc.allocator.user = &c;
    mesh = sil_mesh_create(&desc, NULL);
    pose = sil_pose_create(mesh, NULL);
    assert_int_equal(sil_pose_set(pose, torus.positions, 0), SIL_OK);
    assert_int_equal(sil_pose_reserve(pose, SIZE_MAX), SIL_OK);
    tree = sil_edge_tree_create(mesh, NULL);
    assert_int_equal(sil_edge_tree_reserve(tree, SIZE_MAX), SIL_OK);
    before = c.calls;
    for (frame = 0; frame < 50; ++frame) {
        const sil_view view = grid_view((int)frame);
        size_t count, strip_count, needed;
        assert_int_equal(sil_pose_set(pose, torus.positions, 0), SIL_OK);
        count = sil_extract(mesh, pose, &view, 15, edges, 2000);
        strip_count = sil_chain(mesh, pose, edges, count, strips, 2000, vertices, 4000, &needed);
        assert_true(count <= 2000 && strip_count <= 2000 && needed <= 4000);
        assert_int_equal(sil_distances(mesh, pose, edges, count, NULL, 0, torus.vertex_count, distances, NULL), SIL_OK);
        assert_int_equal(sil_edge_tree_build(tree, pose, edges, count, NULL), SIL_OK);
        assert_int_equal(sil_distances_by_tree(tree, 0, torus.vertex_count, distances, NULL), SIL_OK);
        assert_true(sil_ribbons(mesh, pose, strips, strip_count, vertices, &ribbon, NULL, 0) % 3 == 0);
    }
    assert_int_equal(c.calls, before);
    sil_edge_tree_destroy(tree);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    assert_int_equal(c.live, 0);
    desc.allocator.free_fn = NULL; /* both or neither */
    assert_null(sil_mesh_create(&desc, NULL));
    shape_free(&torus);
}

static void test_misuse_is_harmless(void **state) {
    shape box = make_box(1, 1, 1);
    sil_mesh *mesh = mesh_of(&box), *other = mesh_of(&box);
    sil_pose *pose = sil_pose_create(other, NULL);
    const sil_view view = view_at(3, 4, 5, 1);
    sil_edge edges[32];
    size_t needed;
    sil_ribbon_desc ribbon = screen_desc();
    const sil_strip wild = {0, 2, 0, 99, 1};
    const uint32_t nowhere[2] = {1000, SIL_NONE};
    (void)state;
    assert_int_equal(sil_extract(mesh, pose, &view, 15, edges, 32), 0); /* a pose of another mesh */
    assert_int_equal(sil_extract(NULL, NULL, &view, 15, edges, 32), 0);
    assert_int_equal(sil_extract(mesh, NULL, &view, 0, edges, 32), 0);
    assert_int_equal(sil_chain(mesh, pose, edges, 3, NULL, 0, NULL, 0, &needed), 0);
    assert_int_equal(sil_distances(mesh, pose, edges, 0, NULL, 0, 0, NULL, NULL), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_ribbons(mesh, NULL, &wild, 1, nowhere, &ribbon, NULL, 0), 0);
    assert_int_equal(sil_ribbons(mesh, NULL, &wild, 1, nowhere, NULL, NULL, 0), 0);
    assert_null(sil_pose_create(NULL, NULL));
    assert_int_equal(sil_mesh_get_info(NULL).face_count, 0);
    assert_int_equal(sil_pose_reserve(NULL, 1), SIL_INVALID_ARGUMENT);
    assert_string_equal(sil_result_string((sil_result)99), "not a sil_result");
    sil_mesh_destroy(NULL);
    sil_pose_destroy(NULL);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    sil_mesh_destroy(other);
    shape_free(&box);
}

/* A real model with nearly every face twice: `v` and `f` lines of an OBJ file, faces as fans. */
static void read_obj(FILE *file, shape *s) {
    char line[512];
    while (fgets(line, sizeof line, file)) {
        char *at = line + 2;
        uint32_t corner[3] = {0, 0, 0};
        int n = 0;
        if (line[0] == 'v' && line[1] == ' ') {
            double p[3];
            int k;
            for (k = 0; k < 3; ++k)
                p[k] = strtod(at, &at);
            add_vertex(s, p[0], p[1], p[2]);
        }
        while (line[0] == 'f' && line[1] == ' ' && strpbrk(at, "0123456789")) {
            corner[n < 2 ? n : 2] = (uint32_t)strtol(at, &at, 10) - 1;
            at += strcspn(at, " \n");
            if (++n >= 3) {
                add_face(s, corner[0], corner[1], corner[2]);
                corner[1] = corner[2];
            }
        }
    }
}

static void test_chair(void **state) {
    const char *folder = getenv("GLASSINE_MODELS");
    char path[1024];
    FILE *file;
    shape s;
    sil_mesh *mesh;
    sil_mesh_info info;
    size_t count;
    (void)state;
    snprintf(path, sizeof path, "%s/chair_model.obj", folder ? folder : "../shared/models");
    file = fopen(path, "r");
    if (!file) {
        print_message("skipped: no %s\n", path);
        skip();
    }
    s = shape_with_room(40000, 40000);
    read_obj(file, &s);
    fclose(file);
    mesh = mesh_of(&s);
    info = sil_mesh_get_info(mesh);
    count = count_of(mesh, 2, 1.5, 3, 1, SIL_SILHOUETTE | SIL_BOUNDARY);
    print_message("chair: %zu triangles, %zu faces, %zu two-sided, %zu edges, %zu of them outlines, %zu flipped\n",
                  s.index_count / 3, info.face_count, info.two_sided_face_count, info.edge_count, count,
                  info.flipped_edge_count);
    assert_true(info.two_sided_face_count > info.face_count / 2);
    assert_true(count > 100 && count < info.edge_count / 4);
    sil_mesh_destroy(mesh);
    shape_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_signs_random),
        cmocka_unit_test(test_signs_adversarial),
        cmocka_unit_test(test_signs_stages),
        cmocka_unit_test(test_eye_rounding),
        cmocka_unit_test(test_edges_against_brute_force),
        cmocka_unit_test(test_loops_closed),
        cmocka_unit_test(test_published_figures),
        cmocka_unit_test(test_order_does_not_matter),
        cmocka_unit_test(test_welding),
        cmocka_unit_test(test_welding_by_distance),
        cmocka_unit_test(test_bad_vertices_and_indices),
        cmocka_unit_test(test_empty_mesh),
        cmocka_unit_test(test_duplicates),
        cmocka_unit_test(test_nonmanifold),
        cmocka_unit_test(test_faces_without_area),
        cmocka_unit_test(test_chains_of_faces_without_area),
        cmocka_unit_test(test_slivers),
        cmocka_unit_test(test_partly_two_sided),
        cmocka_unit_test(test_flipped_neighbours),
        cmocka_unit_test(test_crease_angle),
        cmocka_unit_test(test_chains_of_closed_mesh),
        cmocka_unit_test(test_loops_do_not_cross),
        cmocka_unit_test(test_chains_of_borders),
        cmocka_unit_test(test_pose),
        cmocka_unit_test(test_view_from_matrices),
        cmocka_unit_test(test_convex_and_concave),
        cmocka_unit_test(test_hierarchy),
        cmocka_unit_test(test_hierarchy_when_dense),
        cmocka_unit_test(test_distances),
        cmocka_unit_test(test_distance_rules),
        cmocka_unit_test(test_distance_tree),
        cmocka_unit_test(test_distances_at),
        cmocka_unit_test(test_distances_at_flat_points),
        cmocka_unit_test(test_ribbon_pixels),
        cmocka_unit_test(test_ribbon_clipping),
        cmocka_unit_test(test_ribbon_values),
        cmocka_unit_test(test_ribbon_settings),
        cmocka_unit_test(test_ribbon_arc),
        cmocka_unit_test(test_every_allocation_may_fail),
        cmocka_unit_test(test_steady_frames_allocate_nothing),
        cmocka_unit_test(test_misuse_is_harmless),
        cmocka_unit_test(test_chair),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Unit tests of sil_containment and sil_mesh_components: random scenes whose nesting is known from closed forms (balls,
   boxes and tori at random places), brute force over solid angles, and cases by hand.
   Build: cc -std=c11 -I. tests/unit_containment.c -lcmocka -lm */
#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

#include "shapes.h"

/* Column-major: a random rotation with a scale, mirrored now and then, and a translation. */
static void random_transform(float m[16], double scale, const double at[3], int mirrored) {
    double q[4], n = 0;
    int i, k;
    for (i = 0; i < 4; ++i) {
        q[i] = random_in(-1, 1);
        n += q[i] * q[i];
    }
    n = sqrt(n);
    for (i = 0; i < 4; ++i)
        q[i] /= n;
    {
        const double w = q[0], x = q[1], y = q[2], z = q[3];
        const double r[9] = {1 - 2 * (y * y + z * z), 2 * (x * y + w * z),     2 * (x * z - w * y),
                             2 * (x * y - w * z),     1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
                             2 * (x * z + w * y),     2 * (y * z - w * x),     1 - 2 * (x * x + y * y)};
        memset(m, 0, 16 * sizeof *m);
        for (i = 0; i < 3; ++i)
            for (k = 0; k < 3; ++k)
                m[4 * i + k] = (float)(scale * r[3 * i + k] * (mirrored && i == 0 ? -1 : 1));
    }
    for (k = 0; k < 3; ++k)
        m[12 + k] = (float)at[k];
    m[15] = 1;
}

static void move(float m[16], double scale, double x, double y, double z) {
    memset(m, 0, 16 * sizeof *m);
    m[0] = m[5] = m[10] = (float)scale;
    m[12] = (float)x;
    m[13] = (float)y;
    m[14] = (float)z;
    m[15] = 1;
}

/* The winding number of a closed shape about a point, by solid angles (Van Oosterom and Strackee) in double. */
static double winding(const shape *s, const float m[16], const double point[3]) {
    double sum = 0;
    size_t f;
    int i, k;
    for (f = 0; f < s->index_count / 3; ++f) {
        double v[3][3], l[3], det, den;
        for (i = 0; i < 3; ++i) {
            const float *p = s->positions + 3 * (size_t)s->indices[3 * f + (size_t)i];
            l[i] = 0;
            for (k = 0; k < 3; ++k) {
                v[i][k] = (double)m[k] * (double)p[0] + (double)m[4 + k] * (double)p[1] +
                          (double)m[8 + k] * (double)p[2] + (double)m[12 + k] - point[k];
                l[i] += v[i][k] * v[i][k];
            }
            l[i] = sqrt(l[i]);
        }
        det = v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) - v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
              v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
        den = l[0] * l[1] * l[2];
        for (i = 0; i < 3; ++i) {
            const int a = (i + 1) % 3, b = (i + 2) % 3;
            den += (v[a][0] * v[b][0] + v[a][1] * v[b][1] + v[a][2] * v[b][2]) * l[i];
        }
        sum += 2 * atan2(det, den);
    }
    return sum / (4 * SHAPES_PI);
}

enum { PARTS = 24, KINDS = 3 };

typedef struct world {
    shape shapes[KINDS];
    sil_mesh *meshes[KINDS];
    const shape *of[PARTS];
    sil_part parts[PARTS];
    size_t count;
} world;

/* Shapes at random, of sizes over two powers of ten, at places that often fall into each other. */
static void random_world(world *w, int round) {
    size_t i;
    w->count = 2 + random_below(PARTS - 1);
    for (i = 0; i < w->count; ++i) {
        const size_t kind = random_below(KINDS);
        const double scale = pow(10, random_in(-1.5, 0.5)), spread = round % 3 ? 1 : 0.2;
        const double at[3] = {random_in(-spread, spread), random_in(-spread, spread), random_in(-spread, spread)};
        w->of[i] = &w->shapes[kind];
        w->parts[i].mesh = w->meshes[kind];
        w->parts[i].component = random_below(2); /* each has one: that and all are the same */
        random_transform(w->parts[i].transform, scale, at, round % 2);
    }
}

/* 1: every vertex and every middle of a face of b is within a; 0: none is; -1: some. Never nearer than rounding. */
static int brute_within(const world *w, size_t b, size_t a) {
    const shape *s = w->of[b];
    const float *m = w->parts[b].transform;
    size_t i, f, in = 0, all = 0;
    int k;
    for (i = 0; i < s->index_count / 3; ++i)
        for (f = 0; f < 4; ++f) {
            double p[3] = {0, 0, 0}, out[3];
            for (k = 0; k < 3; ++k) {
                const float *v[3];
                int c;
                for (c = 0; c < 3; ++c)
                    v[c] = s->positions + 3 * (size_t)s->indices[3 * i + (size_t)c];
                p[k] = f < 3 ? (double)v[f][k] : ((double)v[0][k] + (double)v[1][k] + (double)v[2][k]) / 3;
            }
            for (k = 0; k < 3; ++k)
                out[k] = (double)m[k] * p[0] + (double)m[4 + k] * p[1] + (double)m[8 + k] * p[2] + (double)m[12 + k];
            in += fabs(winding(w->of[a], w->parts[a].transform, out)) > 0.5;
            ++all;
        }
    return in == all ? 1 : in ? -1 : 0;
}

static void check_world(const world *w) {
    signed char within[PARTS][PARTS];
    uint32_t parents[PARTS], facts[PARTS], again[PARTS];
    size_t a, b, c;
    assert_int_equal(sil_containment(w->parts, w->count, (size_t)-1, parents, facts), SIL_OK);
    for (a = 0; a < w->count; ++a)
        for (b = 0; b < w->count; ++b)
            within[b][a] = (signed char)(a == b ? 0 : brute_within(w, b, a));
    for (b = 0; b < w->count; ++b) {
        size_t around = 0, innermost = SIL_NONE, most = 0;
        int crosses = 0, encloses = 0;
        for (a = 0; a < w->count; ++a) {
            size_t its = 0;
            crosses |= within[b][a] < 0 || within[a][b] < 0;
            encloses |= within[a][b] == 1;
            around += within[b][a] == 1;
            for (c = 0; c < w->count && within[b][a] == 1; ++c)
                its += within[a][c] == 1;
            if (within[b][a] == 1 && (innermost == SIL_NONE || its > most)) {
                innermost = a;
                most = its;
            }
        }
        assert_int_equal(parents[b], innermost);
        assert_int_equal(facts[b],
                         SIL_PART_CLOSED | (encloses ? SIL_PART_ENCLOSES : 0) | (crosses ? SIL_PART_CROSSES : 0));
        (void)around;
    }
    /* A few points give the same where nothing crosses. */
    assert_int_equal(sil_containment(w->parts, w->count, 0, again, NULL), SIL_OK);
    for (b = 0; b < w->count; ++b)
        if (!(facts[b] & SIL_PART_CROSSES))
            assert_int_equal(again[b], parents[b]);
}

static void test_random_worlds(void **state) {
    world w;
    int round;
    size_t i, nested = 0;
    (void)state;
    memset(&w, 0, sizeof w);
    w.shapes[0] = make_ball(2);
    w.shapes[1] = make_box(1, 1, 1);
    w.shapes[2] = make_torus(10, 6, 0, 0);
    for (i = 0; i < KINDS; ++i)
        w.meshes[i] = mesh_of(&w.shapes[i]);
    for (round = 0; round < 16; ++round) {
        uint32_t parents[PARTS];
        random_world(&w, round);
        check_world(&w);
        assert_int_equal(sil_containment(w.parts, w.count, 0, parents, NULL), SIL_OK);
        for (i = 0; i < w.count; ++i)
            nested += parents[i] != SIL_NONE;
    }
    print_message("containment: %zu nested parts in 16 random worlds\n", nested);
    assert_true(nested > 60);
    for (i = 0; i < KINDS; ++i) {
        sil_mesh_destroy(w.meshes[i]);
        shape_free(&w.shapes[i]);
    }
}

/* Balls in balls, in random order: each in the next larger one. */
static void test_nested_balls(void **state) {
    enum { COUNT = 200 };
    shape ball = make_ball(2);
    sil_mesh *mesh = mesh_of(&ball);
    static sil_part parts[COUNT];
    static uint32_t parents[COUNT], facts[COUNT], rank[COUNT];
    size_t i, k;
    (void)state;
    memset(parts, 0, sizeof parts);
    for (i = 0; i < COUNT; ++i)
        rank[i] = (uint32_t)i;
    for (i = COUNT; i-- > 1;) {
        const uint32_t j = random_below(i + 1), t = rank[i];
        rank[i] = rank[j];
        rank[j] = t;
    }
    for (i = 0; i < COUNT; ++i) {
        parts[i].mesh = mesh;
        move(parts[i].transform, pow(1.08, rank[i]), 1000, 0, -5000);
    }
    assert_int_equal(sil_containment(parts, COUNT, 0, parents, facts), SIL_OK);
    for (i = 0; i < COUNT; ++i) {
        for (k = 0; k < COUNT && rank[k] != rank[i] + 1; ++k)
            ;
        assert_int_equal(parents[i], k < COUNT ? k : SIL_NONE);
        assert_int_equal(facts[i], SIL_PART_CLOSED | (rank[i] ? SIL_PART_ENCLOSES : 0));
    }
    sil_mesh_destroy(mesh);
    shape_free(&ball);
}

/* By hand: a cavity, an open shell, crossing, touching, coincident, flattened and empty parts, two jars as one part. */
static void test_cases_by_hand(void **state) {
    shape ball = make_ball(2), shell = empty_shape(), open = make_ball(2), jars = empty_shape(), none = empty_shape();
    shape box = make_box(2, 2, 2);
    sil_mesh *balls, *shells, *opens, *jar, *nothing, *boxes;
    sil_part parts[8];
    uint32_t parents[8], facts[8];
    size_t i;
    (void)state;
    add_shape(&shell, &ball, 1, 0, 0, 0);
    i = shell.index_count / 3;
    add_shape(&shell, &ball, 0.9, 0, 0, 0);
    for (; i < shell.index_count / 3; ++i)
        turn_face(&shell, i);
    open.index_count -= 3;
    add_shape(&jars, &ball, 1, 5, 0, 0);
    add_shape(&jars, &ball, 1, -5, 0, 0);
    balls = mesh_of(&ball);
    shells = mesh_of(&shell);
    opens = mesh_of(&open);
    jar = mesh_of(&jars);
    nothing = mesh_of(&none);
    boxes = mesh_of(&box);
    memset(parts, 0, sizeof parts);
    parts[0].mesh = shells; /* the identity by default */
    parts[1].mesh = balls;  /* in its cavity */
    move(parts[1].transform, 0.5, 0, 0, 0);
    parts[2].mesh = opens; /* in the cavity, around nothing that is sure */
    move(parts[2].transform, 0.6, 0, 0, 0);
    parts[3].mesh = balls; /* across the shell */
    move(parts[3].transform, 0.2, 0.95, 0, 0);
    parts[4].mesh = balls; /* within the shell's wall: inside too */
    move(parts[4].transform, 0.01, 0, 0, 0.95);
    parts[5].mesh = nothing;
    parts[6].mesh = balls; /* flattened: encloses nothing, is within */
    move(parts[6].transform, 0.5, 0, 0, 0);
    parts[6].transform[10] = 0;
    assert_int_equal(sil_containment(parts, 7, 0, parents, facts), SIL_OK);
    assert_int_equal(parents[0], SIL_NONE);
    assert_int_equal(facts[0], SIL_PART_CLOSED | SIL_PART_ENCLOSES | SIL_PART_CROSSES);
    assert_int_equal(parents[1], 0);
    assert_int_equal(facts[1] & SIL_PART_CLOSED, SIL_PART_CLOSED);
    assert_int_equal(parents[2], 0);
    assert_int_equal(facts[2], 0);
    assert_int_equal(parents[3], SIL_NONE);
    assert_int_equal(facts[3], SIL_PART_CLOSED | SIL_PART_CROSSES);
    assert_int_equal(parents[4], 0);
    assert_int_equal(parents[5], SIL_NONE);
    assert_int_equal(facts[5], 0);
    assert_int_equal(facts[6] & SIL_PART_CLOSED, 0);
    /* two jars as one part, each with a ball of another */
    memset(parts, 0, sizeof parts);
    parts[0].mesh = jar;
    parts[1].mesh = jar;
    move(parts[1].transform, 0.95, 0, 0, 0); /* at -4.75 and 4.75, radius 0.95: within 1 of -5 and 5? no: 1.2 away */
    assert_int_equal(sil_containment(parts, 2, 0, parents, facts), SIL_OK);
    assert_int_equal(parents[1], SIL_NONE);
    assert_int_equal(facts[1], SIL_PART_CLOSED | SIL_PART_CROSSES);
    parts[1].component = 1; /* ... a component by itself; and one that is not there */
    parts[0].component = 1;
    assert_int_equal(sil_containment(parts, 2, 0, parents, facts), SIL_OK);
    parts[0].component = 3;
    assert_int_equal(sil_containment(parts, 2, 0, parents, facts), SIL_INVALID_ARGUMENT);
    parts[0].component = 0;
    for (i = 0; i < 2; ++i) {
        parts[1].mesh = balls;
        parts[1].component = 0;
        move(parts[1].transform, 0.5, i ? 5 : 0, 0, 0);
        assert_int_equal(sil_containment(parts, 2, 0, parents, facts), SIL_OK);
        assert_int_equal(parents[1], i ? 0 : SIL_NONE);
    }
    { /* both jars full: the balls as one part of two components, each in another jar */
        shape two = empty_shape();
        sil_mesh *twins;
        add_shape(&two, &ball, 0.5, 5, 0, 0);
        add_shape(&two, &ball, 0.5, -5, 0, 0);
        twins = mesh_of(&two);
        parts[1].mesh = twins;
        memset(parts[1].transform, 0, sizeof parts[1].transform);
        assert_int_equal(sil_containment(parts, 2, 0, parents, facts), SIL_OK);
        assert_int_equal(parents[1], 0);
        sil_mesh_destroy(twins);
        shape_free(&two);
    }
    /* A box standing on the floor of a larger one, flush with two walls; coincident ones are in neither. */
    memset(parts, 0, sizeof parts);
    parts[0].mesh = parts[1].mesh = parts[2].mesh = boxes;
    move(parts[0].transform, 2, 0, 0, 0);
    move(parts[1].transform, 1, 0, 0, 0);
    move(parts[2].transform, 2, 0, 0, 0);
    assert_int_equal(sil_containment(parts, 3, 0, parents, facts), SIL_OK);
    assert_int_equal(parents[1], 0);
    assert_int_equal(parents[0], SIL_NONE);
    assert_int_equal(parents[2], SIL_NONE);
    assert_int_equal(facts[0], SIL_PART_CLOSED | SIL_PART_ENCLOSES);
    assert_int_equal(facts[1], SIL_PART_CLOSED);
    sil_mesh_destroy(balls);
    sil_mesh_destroy(shells);
    sil_mesh_destroy(opens);
    sil_mesh_destroy(jar);
    sil_mesh_destroy(nothing);
    sil_mesh_destroy(boxes);
    shape_free(&ball);
    shape_free(&shell);
    shape_free(&open);
    shape_free(&jars);
    shape_free(&none);
    shape_free(&box);
}

/* Components by number, whatever the order of the faces; triangles left out have none. As parts they nest. */
static void test_components(void **state) {
    shape ball = make_ball(1), s = empty_shape(), other;
    uint32_t order[200], numbers[200], again[200], parents[4], facts[4];
    sil_part parts[4];
    sil_mesh *mesh, *second;
    size_t i, faces;
    (void)state;
    for (i = 0; i < 4; ++i)
        add_shape(&s, &ball, (double)(1 << i), 0, 0, 0);
    add_face(&s, 0, 0, 1);
    add_face(&s, s.indices[0], s.indices[1], s.indices[2]);
    faces = s.index_count / 3;
    mesh = mesh_of(&s);
    other = shuffled(&s, order);
    second = mesh_of(&other);
    assert_int_equal(sil_mesh_get_info(mesh).component_count, 4);
    assert_int_equal(sil_mesh_components(mesh, numbers, faces), SIL_OK);
    assert_int_equal(sil_mesh_components(second, again, faces), SIL_OK);
    assert_int_equal(numbers[faces - 2], SIL_NONE);
    assert_int_equal(numbers[faces - 1], SIL_NONE);
    for (i = 0; i < faces; ++i) {
        if (i < faces - 2)
            assert_int_equal(numbers[i], numbers[i / 32 * 32]);
        if (again[i] != SIL_NONE && order[i] < faces - 2)
            assert_int_equal(again[i], numbers[order[i]]);
    }
    memset(parts, 0, sizeof parts);
    for (i = 0; i < 4; ++i) {
        parts[i].mesh = mesh;
        parts[i].component = numbers[32 * i] + 1;
    }
    assert_int_equal(sil_containment(parts, 4, 0, parents, facts), SIL_OK);
    for (i = 0; i < 4; ++i)
        assert_int_equal(parents[i], i < 3 ? i + 1 : SIL_NONE);
    assert_int_equal(sil_mesh_components(mesh, numbers, 3), SIL_OK); /* only as many as there is room for */
    assert_int_equal(sil_mesh_components(NULL, numbers, 3), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_mesh_components(mesh, NULL, 3), SIL_INVALID_ARGUMENT);
    sil_mesh_destroy(mesh);
    sil_mesh_destroy(second);
    shape_free(&ball);
    shape_free(&s);
    shape_free(&other);
}

/* Rays exactly through vertices and along edges: points of a grid against a box of unit quads, whole and halves. */
static void test_points_on_the_grid(void **state) {
    shape box = make_box(3, 3, 3), dot = empty_shape();
    sil_mesh *boxes = mesh_of(&box), *dots;
    int x, y, z;
    (void)state;
    add_vertex(&dot, 0, 0, 0);
    add_vertex(&dot, 1, 0, 0);
    add_vertex(&dot, 0, 1, 0);
    add_face(&dot, 0, 1, 2);
    dots = mesh_of(&dot);
    for (x = -2; x <= 8; ++x)
        for (y = -2; y <= 8; ++y)
            for (z = -2; z <= 8; ++z) {
                sil_part parts[2];
                uint32_t parents[2], facts[2];
                const int inside = x > 0 && y > 0 && z > 0 && x < 6 && y < 6 && z < 6;
                const int outside = x < 0 || y < 0 || z < 0 || x > 6 || y > 6 || z > 6;
                memset(parts, 0, sizeof parts);
                parts[0].mesh = boxes;
                parts[1].mesh = dots;
                move(parts[1].transform, 1e-6, 0.5 * x, 0.5 * y, 0.5 * z); /* next to nothing: a point */
                assert_int_equal(sil_containment(parts, 2, 0, parents, facts), SIL_OK);
                if (inside || outside) {
                    assert_int_equal(parents[1], inside ? 0 : SIL_NONE);
                    assert_int_equal(facts[1], 0);
                }
            }
    sil_mesh_destroy(boxes);
    sil_mesh_destroy(dots);
    shape_free(&box);
    shape_free(&dot);
}

typedef struct budget {
    size_t left, live;
} budget;

static void *budget_alloc(size_t size, void *user) {
    budget *b = (budget *)user;
    if (!b->left)
        return NULL;
    --b->left;
    ++b->live;
    return malloc(size);
}

static void budget_free(void *memory, void *user) {
    --((budget *)user)->live;
    free(memory);
}

static void test_misuse_and_memory(void **state) {
    shape ball = make_ball(1);
    budget b = {(size_t)-1, 0};
    sil_mesh_desc desc = desc_of(&ball);
    sil_part parts[70];
    uint32_t parents[70], facts[70], keep[2];
    sil_mesh *mesh;
    size_t limit, live;
    sil_result result = SIL_OUT_OF_MEMORY;
    int i;
    (void)state;
    desc.allocator.alloc_fn = budget_alloc;
    desc.allocator.free_fn = budget_free;
    desc.allocator.user = &b;
    mesh = mesh_from(&desc);
    live = b.live;
    memset(parts, 0, sizeof parts);
    for (i = 0; i < 70; ++i) { /* enough pairs for the list of them to grow */
        parts[i].mesh = mesh;
        move(parts[i].transform, 1 + i, 0, 0, 0);
    }
    for (limit = 0; result == SIL_OUT_OF_MEMORY; ++limit) {
        b.left = limit;
        result = sil_containment(parts, 70, 0, parents, facts);
        assert_int_equal(b.live, live);
        assert_true(limit < 200);
    }
    assert_int_equal(result, SIL_OK);
    assert_int_equal(parents[0], 1);
    assert_true(limit > 15);
    b.left = 0;
    assert_int_equal(sil_mesh_components(mesh, keep, 2), SIL_OUT_OF_MEMORY);
    b.left = (size_t)-1;
    assert_int_equal(sil_containment(NULL, 0, 0, NULL, NULL), SIL_OK);
    assert_int_equal(sil_containment(NULL, 1, 0, parents, facts), SIL_INVALID_ARGUMENT);
    assert_int_equal(sil_containment(parts, 1, 0, NULL, facts), SIL_INVALID_ARGUMENT);
    parts[1].transform[13] = NAN;
    assert_int_equal(sil_containment(parts, 2, 0, parents, facts), SIL_INVALID_ARGUMENT);
    parts[1].transform[13] = 0;
    parts[1].mesh = NULL;
    assert_int_equal(sil_containment(parts, 2, 0, parents, facts), SIL_INVALID_ARGUMENT);
    assert_int_equal(b.live, live);
    sil_mesh_destroy(mesh);
    shape_free(&ball);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_worlds),      cmocka_unit_test(test_nested_balls),
        cmocka_unit_test(test_cases_by_hand),      cmocka_unit_test(test_components),
        cmocka_unit_test(test_points_on_the_grid), cmocka_unit_test(test_misuse_and_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

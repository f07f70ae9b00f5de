/* The battlefield and the paper's two scenes: the same every time, everything where it says, nothing in another's way. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "battlefield.h"

/* The default one, made once; who moves it says to when. */
static battlefield *field;

static int make_field(void **state) {
    (void)state;
    field = battlefield_create(NULL);
    return field ? 0 : -1;
}

static int destroy_field(void **state) {
    (void)state;
    battlefield_destroy(field);
    return 0;
}

/* Parts whose names have `text` in them and, of those, how many have all of `flags`. */
static size_t count_parts(const battlefield *b, const char *text, uint32_t flags) {
    size_t count = 0;
    for (size_t i = 0; i < b->scene->part_count; i++)
        count += strstr(b->scene->parts[i].name, text) && (b->objects[i].flags & flags) == flags;
    return count;
}

static const double *place_of(const battlefield *b, size_t part) {
    return b->scene->parts[part].transform + 12;
}

static bool is_named(const battlefield *b, size_t part, const char *text) {
    return strstr(b->scene->parts[part].name, text) != NULL;
}

/* ---- the same everywhere --------------------------------------------------------------------------------- */

static bool same_scenes(const battlefield *a, const battlefield *b) {
    if (a->scene->part_count != b->scene->part_count || a->scene->mesh_count != b->scene->mesh_count)
        return false;
    for (size_t i = 0; i < a->scene->mesh_count; i++) {
        const scene_mesh *m = &a->scene->meshes[i], *n = &b->scene->meshes[i];
        if (m->vertex_count != n->vertex_count || memcmp(m->positions, n->positions, 12 * m->vertex_count) != 0)
            return false;
    }
    for (size_t i = 0; i < a->scene->part_count; i++) {
        const scene_part *p = &a->scene->parts[i], *q = &b->scene->parts[i];
        if (strcmp(p->name, q->name) != 0 || p->mesh != q->mesh ||
            memcmp(p->transform, q->transform, sizeof p->transform) != 0)
            return false;
    }
    return memcmp(a->objects, b->objects, a->scene->part_count * sizeof *a->objects) == 0;
}

static void a_seed_makes_the_same_scene(void **state) {
    (void)state;
    const battlefield_desc small = {.seed = 3, .trees = 50, .tanks = 6, .soldiers = 8, .houses = 3};
    const battlefield_desc other = {.seed = 4, .trees = 50, .tanks = 6, .soldiers = 8, .houses = 3};
    battlefield *made[6] = {battlefield_create(&small),        battlefield_create(&small),
                            battlefield_create_abstract(5),    battlefield_create_abstract(5),
                            battlefield_create_walkthrough(5), battlefield_create_walkthrough(5)};
    battlefield *different[3] = {battlefield_create(&other), battlefield_create_abstract(6),
                                 battlefield_create_walkthrough(6)};
    for (size_t i = 0; i < 3; i++) {
        assert_true(same_scenes(made[2 * i], made[2 * i + 1]));
        assert_false(same_scenes(made[2 * i], different[i]));
        battlefield_destroy(made[2 * i]);
        battlefield_destroy(made[2 * i + 1]);
        battlefield_destroy(different[i]);
    }
    battlefield_destroy(NULL);
}

/* ---- the battlefield ------------------------------------------------------------------------------------- */

static void everything_is_there(void **state) {
    (void)state;
    battlefield *b = field;
    assert_int_equal(count_parts(b, "/conifer_", 0) + count_parts(b, "/broadleaf_", 0), 1000);
    assert_int_equal(count_parts(b, "ours/tank", BATTLEFIELD_TARGET), 24 + 2); /* two more in barns */
    assert_int_equal(count_parts(b, "theirs/tank", 0), 24);
    assert_int_equal(count_parts(b, "ours/soldier", BATTLEFIELD_TARGET), 48 + 7); /* and in houses */
    assert_int_equal(count_parts(b, "theirs/soldier", 0), 48);
    assert_int_equal(count_parts(b, "", BATTLEFIELD_TARGET), 26 + 55);
    assert_int_equal(count_parts(b, "bunker", BATTLEFIELD_IMPENETRABLE), 4);
    assert_int_equal(count_parts(b, "", BATTLEFIELD_IMPENETRABLE), 4);
    assert_int_equal(count_parts(b, "", BATTLEFIELD_BACKDROP), 1 + 9);
    assert_int_equal(count_parts(b, "/bush_", 0), 120);
    assert_int_equal(count_parts(b, "/rock_", 0), 60);
    assert_true(b->scene->mesh_count < 64); /* a thousand trees of few kinds */
    for (size_t i = 0; i < b->scene->part_count; i++)
        assert_true(b->objects[i].importance == (b->objects[i].flags & BATTLEFIELD_TARGET ? 1.0f : 0.0f));
}

static void a_desc_is_followed(void **state) {
    (void)state;
    const battlefield_desc desc = {
        .trees = 33, .tanks = 4, .soldiers = 6, .houses = 3, .bunkers = 1, .bushes = 2, .rocks = 5};
    battlefield *b = battlefield_create(&desc);
    assert_non_null(b);
    assert_int_equal(count_parts(b, "/forest/", 0), 33 + 2);
    assert_int_equal(count_parts(b, "/tank", 0), 4 + 2);
    assert_int_equal(count_parts(b, "/soldier", 0), 6 + 1);
    assert_int_equal(count_parts(b, "/rock_", 0), 5);
    assert_int_equal(count_parts(b, "/bunker", 0), 1);
    assert_int_equal(count_parts(b, "_roof", 0) + count_parts(b, "/roof", 0), 3);
    battlefield_destroy(b);
}

static void check_rigid(const double *m) {
    for (size_t k = 0; k < 3; k++) {
        const double *u = m + 4 * k, *v = m + 4 * ((k + 1) % 3), *w = m + 4 * ((k + 2) % 3);
        assert_true(fabs(u[0] * u[0] + u[1] * u[1] + u[2] * u[2] - 1) < 1e-12);
        for (size_t r = 0; r < 3; r++)
            assert_true(fabs(u[(r + 1) % 3] * v[(r + 2) % 3] - u[(r + 2) % 3] * v[(r + 1) % 3] - w[r]) < 1e-12);
    }
}

static bool is_unit(const battlefield *b, size_t part) {
    return is_named(b, part, "/tank_") || is_named(b, part, "/soldier_");
}

/* Back after a period, never faster than a tank drives, upright, and never mirrored or scaled. */
static void units_move_smoothly(void **state) {
    enum { STEPS = 40, MOST = 2000 };
    static double before[MOST][16];
    static size_t stride[MOST];
    (void)state;
    battlefield *b = field;
    size_t strides = 0;
    double fastest = 0;
    assert_true(b->scene->part_count < MOST);
    for (size_t step = 0; step < STEPS; step++) {
        double t = 1.37 * (double)step;
        battlefield_move(b, t);
        for (size_t i = 0; i < b->scene->part_count; i++) {
            memcpy(before[i], b->scene->parts[i].transform, sizeof before[i]);
            stride[i] = b->scene->parts[i].mesh;
        }
        battlefield_move(b, t + 0.25);
        for (size_t i = 0; i < b->scene->part_count; i++) {
            double dx = place_of(b, i)[0] - before[i][12], dy = place_of(b, i)[1] - before[i][13],
                   moved = hypot(dx, dy);
            fastest = fmax(fastest, moved / 0.25);
            strides += b->scene->parts[i].mesh != stride[i];
            assert_true(is_unit(b, i) || moved <= 0);
            assert_true(before[i][0] * dx + before[i][1] * dy >= 0.9 * moved); /* looks where it goes */
        }
        battlefield_move(b, t + BATTLEFIELD_PERIOD);
        for (size_t i = 0; i < b->scene->part_count; i++) {
            const double *m = b->scene->parts[i].transform;
            for (size_t k = 0; k < 16; k++)
                assert_true(fabs(m[k] - before[i][k]) < 1e-9);
            assert_true(m[10] > 0.8 || !is_unit(b, i));
            check_rigid(m);
        }
    }
    assert_true(fastest > 1 && fastest < 4);
    assert_true(strides > STEPS * 90); /* nearly every soldier takes a step in a quarter of a second */
}

/* Of two kinds of parts, the least distance on the ground between any two, over a whole period. */
static double least_distance(battlefield *b, const char *kind, const char *other) {
    enum { TIMES = 60 };
    double least = HUGE_VAL;
    for (size_t i = 0; i < TIMES; i++) {
        battlefield_move(b, BATTLEFIELD_PERIOD * ((double)i + 0.5) / TIMES);
        for (size_t p = 0; p < b->scene->part_count; p++)
            for (size_t q = 0; is_named(b, p, kind) && q < b->scene->part_count; q++)
                if (p != q && is_named(b, q, other))
                    least = fmin(least,
                                 hypot(place_of(b, p)[0] - place_of(b, q)[0], place_of(b, p)[1] - place_of(b, q)[1]));
    }
    return least;
}

static void nothing_is_in_the_way(void **state) {
    (void)state;
    battlefield *b = field;
    double tanks = least_distance(b, "/tank_", "/tank_"), trees = least_distance(b, "/tank_", "/forest/"),
           rocks = least_distance(b, "/tank_", "/rock_"), soldiers = least_distance(b, "/soldier_", "/tank_"),
           trunks = least_distance(b, "/soldier_", "/forest/"), bunkers = least_distance(b, "/tank_", "/bunker_");
    print_message(
        "least metres between tanks %.2f, tank and tree %.2f, rock %.2f, soldier %.2f, bunker %.2f; soldier and "
        "tree %.2f\n",
        tanks, trees, rocks, soldiers, bunkers, trunks);
    assert_true(tanks > 8 && trees > 2.7 && rocks > 2.7 && soldiers > 3.8 && bunkers > 7 && trunks > 0.9);
}

/* The highest that the land's meshes are at a place. */
static double land_at(const battlefield *b, double x, double y) {
    double highest = -HUGE_VAL;
    for (size_t i = 0; i < b->scene->part_count; i++) {
        const scene_mesh *m = &b->scene->meshes[b->scene->parts[i].mesh];
        const double *at = place_of(b, i);
        for (size_t c = 0; (is_named(b, i, "/ground") || is_named(b, i, "/hill_")) && c < m->index_count; c += 3) {
            double p[3][3], w[3], sum = 0, z = 0;
            for (size_t k = 0; k < 9; k++)
                p[k / 3][k % 3] = (double)m->positions[3 * (size_t)m->indices[c + k / 3] + k % 3] + at[k % 3];
            for (size_t k = 0; k < 3; k++) {
                const double *u = p[(k + 1) % 3], *v = p[(k + 2) % 3];
                w[k] = (u[0] - x) * (v[1] - y) - (u[1] - y) * (v[0] - x);
                sum += w[k];
                z += w[k] * p[k][2];
            }
            if (w[0] >= 0 && w[1] >= 0 && w[2] >= 0 && sum > 0)
                highest = fmax(highest, z / sum);
        }
    }
    return highest;
}

static void units_and_trees_stand_on_the_land(void **state) {
    (void)state;
    battlefield *b = field;
    battlefield_move(b, 17);
    for (size_t i = 0; i < b->scene->part_count; i++) {
        bool moves = is_named(b, i, "/tank_") || is_named(b, i, "/soldier_");
        if (!moves && !(is_named(b, i, "/forest/") && i % 10 == 0))
            continue;
        const double *p = place_of(b, i);
        double above = p[2] - land_at(b, p[0], p[1]);
        if (!(fabs(above) < 0.3))
            fail_msg("%s is %.2f above the land", b->scene->parts[i].name, above);
    }
}

/* Each building is one group: floor, four walls, roof, from the inside out; and something of ours is in it. */
static void buildings_are_groups(void **state) {
    (void)state;
    battlefield *b = field;
    for (uint32_t group = 1; group <= 9; group++) {
        size_t members = 0, inside = 0;
        double x = 0, y = 0;
        for (size_t i = 0; i < b->scene->part_count; i++)
            if (b->objects[i].group == group) {
                assert_int_equal(b->objects[i].rank, (int)members++);
                x = place_of(b, i)[0]; /* the last is the roof, its middle */
                y = place_of(b, i)[1];
                assert_true(members < 6 || is_named(b, i, "/roof"));
            }
        assert_int_equal(members, 6);
        for (size_t i = 0; i < b->scene->part_count; i++)
            inside +=
                b->objects[i].flags & BATTLEFIELD_TARGET && hypot(place_of(b, i)[0] - x, place_of(b, i)[1] - y) < 1;
        assert_int_equal(inside, 1);
    }
}

/* ---- the paper's scenes ---------------------------------------------------------------------------------- */

static void abstract_is_the_papers(void **state) {
    (void)state;
    battlefield *b = battlefield_create_abstract(0);
    assert_non_null(b);
    assert_int_equal(b->scene->part_count, 200);
    assert_int_equal(b->scene->mesh_count, 4);
    assert_int_equal(count_parts(b, "", BATTLEFIELD_TARGET), 30);
    assert_int_equal(count_parts(b, "abstract/target/", BATTLEFIELD_TARGET), 30);
    double farthest = 0, eye = sqrt(b->eye[0] * b->eye[0] + b->eye[1] * b->eye[1] + b->eye[2] * b->eye[2]);
    for (size_t i = 0; i < 200; i++) {
        const scene_part *part = &b->scene->parts[i];
        const scene_mesh *mesh = &b->scene->meshes[part->mesh];
        bool red = part->color[0] > 0.5f && part->color[1] < 0.4f && part->color[2] < 0.4f;
        assert_true(red == ((b->objects[i].flags & BATTLEFIELD_TARGET) != 0));
        for (size_t v = 0; v < mesh->vertex_count; v++) {
            double square = 0;
            for (size_t k = 0; k < 3; k++) {
                double x = part->transform[12 + k];
                for (size_t c = 0; c < 3; c++)
                    x += part->transform[4 * c + k] * (double)mesh->positions[3 * v + c];
                assert_true(fabs(x) < 50 + 3);
                square += x * x;
            }
            farthest = fmax(farthest, sqrt(square));
        }
    }
    assert_true(asin(farthest / eye) < 22.5 * acos(-1.0) / 180); /* in view from anywhere on the orbit */
    battlefield_destroy(b);
}

/* The plan: lines in which walls, posts and panes are cut a metre above the floor. */
typedef struct plan {
    double lines[2048][2][2];
    size_t count;
} plan;

static void cut_part(const battlefield *b, size_t part, plan *out) {
    const scene_part *p = &b->scene->parts[part];
    const scene_mesh *m = &b->scene->meshes[p->mesh];
    for (size_t c = 0; c < m->index_count; c += 3) {
        double q[3][3];
        size_t n = 0;
        for (size_t k = 0; k < 9; k++) {
            const float *v = m->positions + 3 * (size_t)m->indices[c + k / 3];
            q[k / 3][k % 3] = p->transform[12 + k % 3];
            for (size_t i = 0; i < 3; i++)
                q[k / 3][k % 3] += p->transform[4 * i + k % 3] * (double)v[i];
        }
        assert_true(out->count < 2048);
        for (size_t k = 0; k < 3; k++) {
            const double *u = q[k], *v = q[(k + 1) % 3];
            if ((u[2] > 1) == (v[2] > 1))
                continue;
            double t = (1 - u[2]) / (v[2] - u[2]);
            out->lines[out->count][n][0] = u[0] + t * (v[0] - u[0]);
            out->lines[out->count][n++][1] = u[1] + t * (v[1] - u[1]);
        }
        out->count += n == 2;
    }
}

static bool step_is_free(const plan *p, const double a[2], const double b[2]) {
    for (size_t i = 0; i < p->count; i++) {
        const double *u = p->lines[i][0], *v = p->lines[i][1];
        double dx = b[0] - a[0], dy = b[1] - a[1], ex = v[0] - u[0], ey = v[1] - u[1];
        double s0 = (u[0] - a[0]) * dy - (u[1] - a[1]) * dx, s1 = (v[0] - a[0]) * dy - (v[1] - a[1]) * dx;
        double t0 = (a[0] - u[0]) * ey - (a[1] - u[1]) * ex, t1 = (b[0] - u[0]) * ey - (b[1] - u[1]) * ex;
        if (s0 * s1 < 0 && t0 * t1 < 0)
            return false;
    }
    return true;
}

enum { GRID = 121 }; /* points 0.41 apart, over 49.2 metres */
static const double STEP = 0.41;

/* Marks where one can walk from (1.64, 1.64). The border of the grid, out of the house, is not to be reached. */
static void walk(const plan *p, bool *reached) {
    static size_t queue[GRID * GRID];
    size_t first = 0, last = 0;
    reached[queue[last++] = (GRID / 2 + 4) * GRID + GRID / 2 + 4] = true;
    while (first < last) {
        size_t at = queue[first++];
        long x = (long)(at % GRID), y = (long)(at / GRID);
        assert_true(x > 0 && y > 0 && x < GRID - 1 && y < GRID - 1);
        for (int k = 0; k < 4; k++) {
            long u = x + (k == 0) - (k == 1), v = y + (k == 2) - (k == 3);
            const double from[2] = {STEP * (double)(x - GRID / 2), STEP * (double)(y - GRID / 2)};
            const double to[2] = {STEP * (double)(u - GRID / 2), STEP * (double)(v - GRID / 2)};
            size_t next = (size_t)v * GRID + (size_t)u;
            if (!reached[next] && step_is_free(p, from, to))
                reached[queue[last++] = next] = true;
        }
    }
}

/* From where the walker stands every object can be walked to, and outside there is no way. */
static void every_room_can_be_walked_to(void **state) {
    (void)state;
    static bool reached[GRID * GRID];
    static plan cut;
    battlefield *b = battlefield_create_walkthrough(0);
    assert_non_null(b);
    assert_int_equal(count_parts(b, "/things/", BATTLEFIELD_TARGET), 100);
    assert_int_equal(count_parts(b, "", BATTLEFIELD_BACKDROP), 6);
    assert_true(count_parts(b, "/walls/", 0) > 20);
    assert_true(fabs(b->eye[0] - 1.5) < 0.2 && fabs(b->eye[1] - 1.5) < 0.2);
    for (size_t i = 0; i < b->scene->part_count; i++)
        if (is_named(b, i, "/walls/") || is_named(b, i, "/posts/") || is_named(b, i, "/outside/"))
            cut_part(b, i, &cut);
    walk(&cut, reached);
    for (size_t i = 0; i < b->scene->part_count; i++)
        if (is_named(b, i, "/things/")) {
            long x = lround(place_of(b, i)[0] / STEP) + GRID / 2, y = lround(place_of(b, i)[1] / STEP) + GRID / 2;
            if (!reached[(size_t)y * GRID + (size_t)x])
                fail_msg("%s cannot be reached", b->scene->parts[i].name);
        }
    battlefield_destroy(b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_seed_makes_the_same_scene), cmocka_unit_test(everything_is_there),
        cmocka_unit_test(a_desc_is_followed),          cmocka_unit_test(units_move_smoothly),
        cmocka_unit_test(nothing_is_in_the_way),       cmocka_unit_test(units_and_trees_stand_on_the_land),
        cmocka_unit_test(buildings_are_groups),        cmocka_unit_test(abstract_is_the_papers),
        cmocka_unit_test(every_room_can_be_walked_to),
    };
    return cmocka_run_group_tests(tests, make_field, destroy_field);
}

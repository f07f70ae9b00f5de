/* unit_dynamic.c: transparency.h, what of dynamic transparency needs no GL: rectangles of spheres against points on them in
 * double, fading, the numbers that shaders know units by, and what of a screen is found to have masks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TRANSPARENCY_IMPLEMENTATION
#include "transparency.h"

static const double PI = 3.14159265358979323846;

/* A generator that any machine runs alike. */
static uint32_t state_of_dice = 1;

static double between(double low, double high) {
    state_of_dice = state_of_dice * 1664525u + 1013904223u;
    return low + (high - low) * (state_of_dice >> 8) / 16777216.0;
}

static void identity(float m[16]) {
    memset(m, 0, 16 * sizeof m[0]);
    m[0] = m[5] = m[10] = m[15] = 1;
}

static void perspective(float m[16], double focal, double aspect, double first, double last) {
    memset(m, 0, 16 * sizeof m[0]);
    m[0] = (float)(focal / aspect);
    m[5] = (float)focal;
    m[10] = (float)(-(last + first) / (last - first));
    m[11] = -1;
    m[14] = (float)(-2 * last * first / (last - first));
}

static void orthographic(float m[16], double half) {
    identity(m);
    m[0] = m[5] = (float)(1 / half);
    m[10] = -0.01f;
}

/* A rotation about an axis through the origin, then a shift. */
static void place_eye(float m[16], double turn, double tilt, const double shift[3]) {
    double c = cos(turn), s = sin(turn), d = cos(tilt), t = sin(tilt);
    const double r[3][3] = {{c, 0, s}, {s * t, d, -c * t}, {-s * d, t, c * d}};
    identity(m);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            m[4 * j + i] = (float)r[i][j];
        m[12 + i] = (float)shift[i];
    }
}

static void to_clip(const float view[16], const float projection[16], const double p[3], double clip[4]) {
    double eye[4];
    for (int i = 0; i < 4; ++i)
        eye[i] =
            (double)view[i] * p[0] + (double)view[4 + i] * p[1] + (double)view[8 + i] * p[2] + (double)view[12 + i];
    for (int i = 0; i < 4; ++i) {
        clip[i] = 0;
        for (int k = 0; k < 4; ++k)
            clip[i] += (double)projection[4 * k + i] * eye[k];
    }
}

typedef struct extent {
    double low[2], high[2]; /* pixels, of the points before the eye */
    int before, behind;
} extent;

/* Of many points on a sphere. */
static extent brute_force(const tr_unit *unit, const float view[16], const float projection[16], const int size[2]) {
    enum { STEPS = 160 };
    extent e = {{1e300, 1e300}, {-1e300, -1e300}, 0, 0};
    for (int i = 0; i <= STEPS; ++i)
        for (int j = 0; j < 2 * STEPS; ++j) {
            double polar = PI * i / STEPS, around = PI * j / STEPS, clip[4];
            const double n[3] = {sin(polar) * cos(around), sin(polar) * sin(around), cos(polar)};
            double p[3];
            for (int k = 0; k < 3; ++k)
                p[k] = (double)unit->center[k] + (double)unit->radius * n[k];
            to_clip(view, projection, p, clip);
            e.behind += !(clip[3] > 0);
            if (!(clip[3] > 0))
                continue;
            ++e.before;
            for (int k = 0; k < 2; ++k) {
                double at = (clip[k] / clip[3] + 1) * 0.5 * size[k];
                e.low[k] = fmin(e.low[k], at);
                e.high[k] = fmax(e.high[k], at);
            }
        }
    return e;
}

static tr_unit unit_at(double x, double y, double z, double radius) {
    tr_unit unit;
    memset(&unit, 0, sizeof unit);
    unit.center[0] = (float)x;
    unit.center[1] = (float)y;
    unit.center[2] = (float)z;
    unit.radius = (float)radius;
    return unit;
}

/* The rectangle holds all points of the sphere, and is no larger than needed: the brute force's points stand at most a
 * 1600th of the sphere's silhouette apart from the extreme one (1 - cos(half a step)), and a pixel is for rounding outward. */
static void check_sphere(const tr_unit *unit, const float view[16], const float projection[16], const int size[2],
                         int counts[3]) {
    extent e = brute_force(unit, view, projection, size);
    int r[4], any = tr_unit_rectangle(unit, view, projection, size[0], size[1], r);
    if (e.behind == 0) {
        bool outside = false;
        for (int k = 0; k < 2; ++k)
            outside = outside || e.high[k] < 0 || e.low[k] > size[k];
        if (outside) /* by the brute force, which is a little smaller than the sphere */
            return;
        ++counts[0];
        assert_true(any);
        for (int k = 0; k < 2; ++k) {
            double low = fmax(e.low[k], 0), high = fmin(e.high[k], size[k]), slack = 1 + 1e-3 * (e.high[k] - e.low[k]);
            assert_true(r[k] <= low + 1e-6 && r[k] + r[k + 2] >= high - 1e-6);
            assert_true(r[k] >= low - slack - 1e-6 && r[k] + r[k + 2] <= high + slack + 1e-6);
        }
    } else if (e.before == 0) {
        ++counts[1];
        assert_false(any);
    } else if (any) {
        ++counts[2];
        assert_int_equal(r[0], 0);
        assert_int_equal(r[1], 0);
        assert_int_equal(r[2], size[0]);
        assert_int_equal(r[3], size[1]);
    } else { /* beside the view: no point of it can be in the picture */
        for (int k = 0; k < 200; ++k) {
            double n[3] = {between(-1, 1), between(-1, 1), between(-1, 1)}, clip[4];
            double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) + 1e-9;
            for (int i = 0; i < 3; ++i)
                n[i] = (double)unit->center[i] + (double)unit->radius * n[i] / length;
            to_clip(view, projection, n, clip);
            assert_true(!(clip[3] > 0) || fabs(clip[0]) > clip[3] || fabs(clip[1]) > clip[3]);
        }
    }
}

static void rectangles_hold_spheres_tightly(void **state) {
    int counts[3] = {0, 0, 0};
    (void)state;
    for (int i = 0; i < 400; ++i) {
        const int size[2] = {(int)between(1, 2000), (int)between(1, 1200)};
        const double shift[3] = {between(-1, 1), between(-1, 1), between(-7, 3)};
        float view[16], projection[16];
        tr_unit unit = unit_at(between(-9, 9), between(-9, 9), between(-9, 9), pow(10, between(-2, 0.7)));
        place_eye(view, between(0, 6.3), between(-1.5, 1.5), shift);
        if (i % 4)
            perspective(projection, between(0.5, 3), between(0.5, 2), 0.1, 100);
        else
            orthographic(projection, between(2, 20));
        projection[8] = (float)between(-0.3, 0.3); /* off the middle, as with stereo and jitter */
        projection[9] = (float)between(-0.3, 0.3);
        check_sphere(&unit, view, projection, size, counts);
    }
    print_message("    %d spheres before the eye, %d behind it, %d across it\n", counts[0], counts[1], counts[2]);
    assert_true(counts[0] > 80 && counts[1] > 60 && counts[2] > 4);
}

static void rectangles_of_odd_units(void **state) {
    float view[16], projection[16];
    int r[4] = {-1, -1, -1, -1};
    tr_unit unit = unit_at(0, 0, -10, 0);
    (void)state;
    identity(view);
    perspective(projection, 1, 1, 0.1, 100);
    /* A point in the middle of pixel 50, 50 of 101 by 101. */
    assert_int_equal(tr_unit_rectangle(&unit, view, projection, 101, 101, r), 1);
    assert_true(r[0] == 50 && r[1] == 50 && r[2] == 1 && r[3] == 1);
    /* On the border of two pixels it has one all the same. */
    assert_int_equal(tr_unit_rectangle(&unit, view, projection, 100, 100, r), 1);
    assert_true(r[2] >= 1 && r[3] >= 1 && r[0] <= 50 && r[0] + r[2] >= 50);
    unit = unit_at(0, 0, 10, 1);
    assert_int_equal(tr_unit_rectangle(&unit, view, projection, 100, 100, r), 0);
    unit = unit_at(0, 0, 0, 1); /* the eye is inside */
    assert_int_equal(tr_unit_rectangle(&unit, view, projection, 100, 60, r), 1);
    assert_true(r[0] == 0 && r[1] == 0 && r[2] == 100 && r[3] == 60);
    unit = unit_at(9, 0, -0.5, 1); /* across the plane of the eye, but beside the view */
    assert_int_equal(tr_unit_rectangle(&unit, view, projection, 100, 60, r), 0);
    const float odd[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 4; ++k) {
            unit = unit_at(0, 0, 10, 1); /* behind the eye, were it not for what is odd */
            *(k < 3 ? &unit.center[k] : &unit.radius) = odd[i];
            assert_int_equal(tr_unit_rectangle(&unit, view, projection, 100, 60, r), 1);
            assert_true(r[0] == 0 && r[1] == 0 && r[2] == 100 && r[3] == 60);
        }
    unit = unit_at(0, 0, 10, -1);
    assert_int_equal(tr_unit_rectangle(&unit, view, projection, 100, 60, r), 1);
    unit = unit_at(0, 0, -1e38, 1e38); /* as large as floats go */
    assert_int_equal(tr_unit_rectangle(&unit, view, projection, 100, 60, r), 1);
    assert_int_equal(tr_unit_rectangle(NULL, view, projection, 100, 60, r), 0);
    assert_int_equal(tr_unit_rectangle(&unit, view, projection, 0, 60, r), 0);
    view[3] = NAN;
    assert_int_equal(tr_unit_rectangle(&unit, view, projection, 100, 60, r), 0);
}

static void codes(void **state) {
    tr_unit unit = unit_at(0, 0, 0, 1);
    (void)state;
    unit.id = 0xabcd;
    unit.flags = TR_UNIT_TARGET | TR_UNIT_ACTIVE;
    assert_int_equal(tr_unit_code(&unit), 0xff11abcdu); /* importance 0 is 1 for targets */
    unit.fade = 0.5f;
    assert_int_equal(tr_unit_code(&unit) >> 24, 128);
    unit.importance = 0.5f;
    assert_int_equal(tr_unit_code(&unit) >> 24, 64);
    unit.fade = NAN;
    assert_int_equal(tr_unit_code(&unit) >> 24, 128);
    unit.importance = -1;
    assert_int_equal(tr_unit_code(&unit) >> 24, 0);
    unit.importance = 7;
    assert_int_equal(tr_unit_code(&unit) >> 24, 255);
    unit.flags = TR_UNIT_BACKDROP;
    unit.importance = 0;
    unit.fade = 1; /* of targets alone */
    assert_int_equal(tr_unit_code(&unit), 0x0008abcdu);
    unit.importance = 1;
    assert_int_equal(tr_unit_code(&unit) >> 24, 255);
    assert_int_equal(tr_unit_code(NULL), 0);
}

/* Structs that begin with a unit, as hosts have them. */
typedef struct soldier {
    tr_unit unit;
    double more[3];
} soldier;

static void fading_does_not_depend_on_the_frame_rate(void **state) {
    (void)state;
    for (int i = 0; i < 300; ++i) {
        soldier once[4], twice[4];
        float wanted[4];
        memset(once, 0, sizeof once);
        for (int k = 0; k < 4; ++k) {
            once[k].unit.fade = (float)between(0, 1);
            once[k].more[1] = k;
            wanted[k] = k == 0 ? 0 : k == 1 ? 1 : (float)between(0, 1);
        }
        memcpy(twice, once, sizeof once);
        float step = (float)between(0, 0.5), time = (float)between(0.1, 2);
        tr_advance(once, 4, sizeof once[0], wanted, step, time);
        tr_advance(twice, 4, sizeof twice[0], wanted, step / 2, time);
        tr_advance(twice, 4, sizeof twice[0], wanted, step / 2, time);
        for (int k = 0; k < 4; ++k) {
            /* Two roundings to float, of numbers up to 1. */
            assert_true(fabsf(once[k].unit.fade - twice[k].unit.fade) <= 2.4e-7f);
            assert_true(once[k].unit.fade >= 0 && once[k].unit.fade <= 1);
            assert_true(once[k].more[1] >= k && once[k].more[1] <= k);
        }
    }
}

static void fading_arrives_and_stays(void **state) {
    tr_unit unit = unit_at(0, 0, 0, 1);
    const float gone = 1, odd = NAN;
    (void)state;
    for (int i = 0; i < 9; ++i)
        tr_advance(&unit, 1, 0, &gone, 0.1f, 1);
    assert_true(fabsf(unit.fade - 0.9f) < 1e-6f); /* a tenth of the time is a tenth of the way */
    tr_advance(&unit, 1, 0, &gone, 5, 1);
    assert_true(unit.fade >= 1 && unit.fade <= 1);
    tr_advance(&unit, 1, 0, NULL, 0.25f, 1);
    assert_true(fabsf(unit.fade - 0.75f) < 1e-6f);
    tr_advance(&unit, 1, 0, &gone, -1, 1);
    tr_advance(&unit, 1, 0, &gone, NAN, 1);
    tr_advance(&unit, 1, 0, &gone, INFINITY, 1);
    tr_advance(NULL, 1, 0, &gone, 1, 1);
    assert_true(fabsf(unit.fade - 0.75f) < 1e-6f);
    tr_advance(&unit, 1, 0, &odd, 0.25f, 1); /* as 0 */
    assert_true(fabsf(unit.fade - 0.5f) < 1e-6f);
    tr_advance(&unit, 1, 0, &gone, 1e-6f, 0); /* at once */
    assert_true(unit.fade >= 1);
    unit.fade = NAN;
    tr_advance(&unit, 1, 0, NULL, 0.1f, 1);
    assert_true(unit.fade >= 0 && unit.fade <= 0);
}

/* ---- tiles ---- */

/* Whatever cells are open: tiles cover each once and no other. */
static void tiles_cover_cells_once(void **state) {
    static tr_i_grid grid;
    (void)state;
    for (int round = 0; round < 200; ++round) {
        static int covered[TR_I_CELLS][TR_I_CELLS];
        double density = between(0, 1);
        tr_i_size_grid(&grid, (int)between(1, 4000), (int)between(1, 4000), 16);
        assert_true(grid.columns <= TR_I_CELLS && grid.rows <= TR_I_CELLS && grid.side % 8 == 0);
        tr_i_clear_grid(&grid);
        for (int y = 0; y < grid.rows; ++y)
            for (int x = 0; x < grid.columns; ++x)
                if (between(0, 1) < density * (1 + sin(x * 0.3) * cos(y * 0.2)) / 2)
                    grid.farthest_target[y * TR_I_CELLS + x] = 1;
        memset(covered, 0, sizeof covered);
        if (!tr_i_make_tiles(&grid)) {
            assert_int_equal(grid.tile_count, TR_I_MAX_TILES);
            continue;
        }
        for (int i = 0; i < grid.tile_count; ++i)
            for (int y = grid.tiles[i][1]; y < grid.tiles[i][3]; ++y)
                for (int x = grid.tiles[i][0]; x < grid.tiles[i][2]; ++x)
                    ++covered[y][x];
        for (int y = 0; y < TR_I_CELLS; ++y)
            for (int x = 0; x < TR_I_CELLS; ++x)
                assert_int_equal(covered[y][x], grid.farthest_target[y * TR_I_CELLS + x] > 0);
    }
}

/* Regions hold each cell with masks once, overlap nowhere, and leave out what is worth it. */
static void regions_hold_all_masks(void **state) {
    static tr_i_grid grid;
    uint32_t seed = 3;
    int most = 0;
    (void)state;
    for (int round = 0; round < 200; ++round) {
        int open = 0, area = 0, low[2] = {TR_I_CELLS, TR_I_CELLS}, high[2] = {0, 0};
        tr_i_size_grid(&grid, 640 + 8 * round, 480, 16);
        tr_i_clear_grid(&grid);
        for (int blob = 0; blob <= round % 12; ++blob) {
            int at[2];
            for (int k = 0; k < 2; ++k) {
                seed = seed * 1664525u + 1013904223u;
                at[k] = (int)(seed >> 16) % ((k ? grid.rows : grid.columns) - 3);
            }
            for (int k = 0; k < 9; ++k)
                grid.farthest_target[(at[1] + k / 3) * TR_I_CELLS + at[0] + k % 3] = 1;
        }
        tr_i_make_regions(&grid);
        assert_true(grid.region_count >= 1 && grid.region_count <= TR_I_MAX_REGIONS);
        most = grid.region_count > most ? grid.region_count : most;
        for (int y = 0; y < grid.rows; ++y)
            for (int x = 0; x < grid.columns; ++x) {
                int in = 0, is_open = grid.farthest_target[y * TR_I_CELLS + x] > 0;
                for (int r = 0; r < grid.region_count; ++r)
                    in += x >= grid.regions[r][0] && x < grid.regions[r][2] && y >= grid.regions[r][1] &&
                          y < grid.regions[r][3];
                assert_true(is_open ? in == 1 : in <= 1);
                area += in;
                open += is_open;
                for (int k = 0; is_open && k < 2; ++k) {
                    low[k] = (k ? y : x) < low[k] ? (k ? y : x) : low[k];
                    high[k] = (k ? y : x) + 1 > high[k] ? (k ? y : x) + 1 : high[k];
                }
            }
        int bound = (high[0] - low[0]) * (high[1] - low[1]), worth = grid.columns * grid.rows / TR_I_REGION_SAVES;
        assert_true(area >= open && area <= bound - (grid.region_count - 1) * worth);
        if (round % 12 == 1 && bound > open + 2 * worth) /* two blobs: two regions are those */
            assert_true(area == open || grid.region_count == 1);
    }
    assert_int_equal(most, TR_I_MAX_REGIONS);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rectangles_hold_spheres_tightly),
        cmocka_unit_test(rectangles_of_odd_units),
        cmocka_unit_test(codes),
        cmocka_unit_test(fading_does_not_depend_on_the_frame_rate),
        cmocka_unit_test(fading_arrives_and_stays),
        cmocka_unit_test(tiles_cover_cells_once),
        cmocka_unit_test(regions_hold_all_masks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

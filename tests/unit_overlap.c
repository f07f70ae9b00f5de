/* unit_overlap.c: what a surface shows of its sides and of itself, where that is known. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "models.h"
#include "overlap.h"

/* A mesh of these corners; every three indices a triangle. */
static scene_mesh mesh_of(float *positions, size_t vertices, uint32_t *indices, size_t count) {
    scene_mesh mesh;
    memset(&mesh, 0, sizeof mesh);
    mesh.positions = positions;
    mesh.vertex_count = vertices;
    mesh.indices = indices;
    mesh.index_count = count;
    return mesh;
}

static void expect(const overlap *view, double layered, double back) {
    assert_true(fabs(view->layered - layered) < 0.02 &&
                fabs(view->back - back) < 0.02); /* a row of 96 pixels is 0.01 */
}

/* In the plane of x and y, wound as seen from +z: all of it from there, its back from -z, nothing from its edges. */
static void test_square(void **state) {
    (void)state;
    float positions[12] = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0};
    uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
    scene_mesh mesh = mesh_of(positions, 4, indices, 6);
    overlap views[OVERLAP_VIEWS];
    assert_true(overlap_measure(&mesh, views));
    for (int i = 0; i < OVERLAP_VIEWS; i++)
        expect(&views[i], 0, i == 5 ? 1 : 0);
    assert_false(overlap_is_rolled(views));
}

/* Two squares, the one at z = 1 over a quarter of the one at z = 0 and wound the other way: from +z two layers over 1/7 of
 * what is covered, and a back over 4/7; from -z the fronts and backs change. */
static void test_two_squares(void **state) {
    (void)state;
    float positions[24] = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 1, 1, 1, 1, 3, 1, 3, 3, 1, 3, 1, 1};
    uint32_t indices[12] = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    scene_mesh mesh = mesh_of(positions, 8, indices, 12);
    overlap views[OVERLAP_VIEWS];
    assert_true(overlap_measure(&mesh, views));
    expect(&views[4], 1.0 / 7, 4.0 / 7);
    expect(&views[5], 1.0 / 7, 4.0 / 7);
}

static void test_nothing(void **state) {
    (void)state;
    float positions[9] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
    uint32_t indices[3] = {0, 1, 2};
    scene_mesh mesh = mesh_of(positions, 3, indices, 3), empty = mesh_of(positions, 0, indices, 0);
    overlap views[OVERLAP_VIEWS];
    assert_true(overlap_measure(&mesh, views));
    assert_false(overlap_is_rolled(views));
    assert_true(overlap_measure(&empty, views));
    assert_false(overlap_is_rolled(views));
}

/* Things with an outside, open or not, are not taken for rolled surfaces, and those are. */
static void test_models(void **state) {
    static const struct {
        const char *name;
        bool rolled;
    } cases[] = {{"stream_surface", true}, {"klein_bottle", true}, {"torus_knot", false},
                 {"cylinders", false},     {"dirty_open", false},  {"squares", false}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        scene *s = models_make(cases[i].name);
        overlap views[OVERLAP_VIEWS];
        assert_non_null(s);
        assert_true(overlap_measure(&s->meshes[0], views));
        assert_int_equal(overlap_is_rolled(views), cases[i].rolled);
        scene_destroy(s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_square), cmocka_unit_test(test_two_squares),
                                       cmocka_unit_test(test_nothing), cmocka_unit_test(test_models)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

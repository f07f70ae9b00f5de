/* The promises of silhouette.h against truths that share nothing with it: signs by exact expansions of doubles (after
   Shewchuk; unit_silhouette.c has big integers), over views and meshes of all ranges and for all orders of the corners;
   and the pictures of the ray caster of reference.h, in which crossing a silhouette changes how many front and back
   faces a ray meets, by one each, and nothing else does.
   Build: cc -std=c11 -I. tests/unit_truth.c -lcmocka -lm */
#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

#include "exact.h"
#include "reference.h"
#include "shapes.h"

static void test_expansions(void **state) {
    const expansion one = difference(1, 0), tiny = difference(1, 1 - 1.1102230246251565e-16);
    expansion x;
    (void)state;
    x.count = 0;
    add_product(&x, &one, &tiny, 1);
    assert_int_equal(sign_of(&x), 1);
    add_term(&x, -1.1102230246251565e-16);
    assert_int_equal(sign_of(&x), 0);
    x.count = 0;
    add_term(&x, 1e300);
    add_term(&x, 1e-300);
    add_term(&x, -1e300);
    assert_int_equal(sign_of(&x), 1);
}

/* ---- signs ---- */

/* Coordinates of many kinds: all finite floats among them. */
static float coordinate(int kind) {
    switch (kind) {
    case 0:
        return (float)random_in(-1, 1);
    case 1: { /* any finite float at all */
        uint32_t bits = random_bits();
        float f;
        if ((bits >> 23 & 255) == 255)
            bits ^= 1u << 30;
        memcpy(&f, &bits, sizeof f);
        return f;
    }
    case 2:
        return (float)(1e6 + 1e-3 * random_in(0, 1000));
    case 3:
        return (float)((int)random_below(5) - 2);
    case 4:
        return (float)ldexp((double)((int)random_below(7) - 3), -149);
    default:
        return (float)ldexp((double)((int)random_below(9) - 4), 124);
    }
}

enum { ORDERS = 6, SOUP = 60 };

/* Faces of a soup in all six orders of their corners: one mesh an order. */
static void check_soup(const float *positions, const sil_view *view, size_t *zeros, size_t *exact) {
    static const uint32_t orders[ORDERS][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    int truth[SOUP], o;
    size_t f;
    for (f = 0; f < SOUP; ++f) {
        const float *p = positions + 9 * f;
        truth[f] = true_sign(p, p + 3, p + 6, view->eye, exact);
        *zeros += truth[f] == 0;
    }
    for (o = 0; o < ORDERS; ++o) {
        uint32_t indices[3 * SOUP];
        sil_mesh_desc desc;
        sil_mesh *mesh;
        sil_i_eye eye;
        for (f = 0; f < 3 * SOUP; ++f)
            indices[f] = (uint32_t)(f / 3 * 3) + orders[o][f % 3];
        memset(&desc, 0, sizeof desc);
        desc.positions = positions;
        desc.vertex_count = desc.index_count = 3 * SOUP;
        desc.indices = indices;
        desc.weld_distance = -1;
        mesh = mesh_from(&desc);
        assert_int_equal(mesh->face_count, SOUP);
        sil_i_eye_make(&eye, view, &mesh->rest);
        for (f = 0; f < SOUP; ++f) {
            const int sign = o < 3 ? truth[mesh->source[f]] : -truth[mesh->source[f]];
            if (!(mesh->face_flags[f] & SIL_I_NO_AREA))
                assert_int_equal(sil_i_front(mesh, &mesh->rest, &eye, (uint32_t)f), sign > 0);
            else
                assert_int_equal(sign, 0);
        }
        sil_mesh_destroy(mesh);
    }
}

static void test_signs_of_soups(void **state) {
    static float positions[9 * SOUP];
    size_t zeros = 0, exact = 0, all = 0, i;
    int kind, round, k;
    (void)state;
    for (kind = 0; kind < 6; ++kind)
        for (round = 0; round < 60; ++round) {
            sil_view view = view_at(0, 0, 0, (double)(round % 3 != 0));
            for (i = 0; i < 9 * SOUP; ++i)
                positions[i] = coordinate(kind);
            do /* of a float's range, so that nothing of it is cut off as THE EYE in the manual tells */
                for (k = 0; k < 3; ++k)
                    view.eye[k] = (double)coordinate(round % 3 ? kind : kind == 1 ? 0 : kind);
            while (view.eye[0] == 0 && view.eye[1] == 0 && view.eye[2] == 0);
            for (i = 0; i < SOUP; ++i) {
                float *p = positions + 9 * i;
                if (i % 4 == 1) /* a corner, or a middle of a side, on the way to the eye */
                    for (k = 0; k < 3; ++k)
                        p[6 + k] = view.eye[3] > 0 ? (float)view.eye[k] : p[k] + (float)view.eye[k];
                if (i % 8 == 2 && view.eye[3] > 0) /* edge-on but for the rounding of one coordinate */
                    for (k = 0; k < 3; ++k)
                        p[3 + k] = (float)(0.5 * ((double)p[k] + view.eye[k]));
                for (k = 0; k < 9; ++k) /* sums may have left the range */
                    if (!(fabsf(p[k]) < 3.3e38f))
                        p[k] = 1;
            }
            check_soup(positions, &view, &zeros, &exact);
            all += SOUP;
        }
    print_message("signs: %zu faces, each in six orders; %zu needed exact arithmetic, %zu are zero\n", all, exact,
                  zeros);
    assert_true(zeros > 1000 && exact > 3000);
}

/* Closed meshes in thousands of views: the edges, as anyone sees them, against signs and sorting. */
typedef struct side {
    uint32_t low, high;
    int front;
} side;

static int compare_sides(const void *a, const void *b) {
    const side *x = (const side *)a, *y = (const side *)b;
    if (x->low != y->low)
        return x->low < y->low ? -1 : 1;
    return x->high < y->high ? -1 : x->high > y->high;
}

static void check_mesh_view(const shape *s, const sil_mesh *mesh, sil_pose *pose, const sil_view *view, size_t *found,
                            size_t *exact) {
    side *sides = (side *)calloc(s->index_count, sizeof *sides);
    size_t i, count, at = 0;
    sil_edge *edges = extract_all(mesh, pose, view, SIL_SILHOUETTE, &count);
    unsigned char *is = (unsigned char *)calloc(s->index_count, 1);
    assert_non_null(sides);
    assert_non_null(is);
    for (i = 0; i < s->index_count; ++i) {
        const uint32_t *f = s->indices + i / 3 * 3, a = s->indices[i], b = f[(i + 1) % 3];
        const float *p = s->positions;
        sides[i].low = a < b ? a : b;
        sides[i].high = a < b ? b : a;
        sides[i].front =
            i % 3 ? sides[i / 3 * 3].front
                  : true_sign(p + 3 * (size_t)f[0], p + 3 * (size_t)f[1], p + 3 * (size_t)f[2], view->eye, exact) > 0;
    }
    qsort(sides, s->index_count, sizeof *sides, compare_sides);
    for (i = 0; i < count; ++i) {
        side key, *hit;
        key.low = edges[i].a < edges[i].b ? edges[i].a : edges[i].b;
        key.high = edges[i].a < edges[i].b ? edges[i].b : edges[i].a;
        hit = (side *)bsearch(&key, sides, s->index_count, sizeof *sides, compare_sides);
        assert_non_null(hit);
        is[(hit - sides) / 2] ^= 1;
    }
    for (i = 0; i < s->index_count; i += 2) {
        assert_int_equal(compare_sides(&sides[i], &sides[i + 1]), 0);
        assert_int_equal(is[i / 2], sides[i].front != sides[i + 1].front);
        at += is[i / 2];
    }
    assert_int_equal(at, count);
    *found += count;
    free(is);
    free(edges);
    free(sides);
}

static void test_meshes_in_views(void **state) {
    size_t found = 0, exact = 0, views = 0;
    int m, k;
    (void)state;
    for (m = 0; m < 5; ++m) {
        shape plain = make_torus(12, 8, m % 2 ? 0.05 : 0, m == 2 ? 8 : 0), s = empty_shape();
        static const double scales[5] = {1, 1e-3, 1, 1e37, 1e-37}, offsets[5] = {0, 1e6, 0, 0, 0};
        int round;
        sil_mesh_desc desc;
        sil_mesh *mesh;
        sil_pose *pose;
        add_shape(&s, &plain, scales[m] * (m == 1 ? 1000 : 1), offsets[m], -offsets[m], 0);
        desc = desc_of(&s);
        desc.flags = SIL_MESH_HIERARCHY;
        mesh = mesh_from(&desc);
        pose = pose_of(mesh);
        assert_int_equal(sil_mesh_get_info(mesh).face_count, s.index_count / 3);
        assert_int_equal(sil_mesh_get_info(mesh).closed, 1);
        for (round = 0; round < 500; ++round, ++views) {
            sil_view view = view_at(0, 0, 0, (double)(round % 2));
            const float *p = s.positions + 3 * (size_t)random_below(s.vertex_count);
            const float *q = s.positions + 3 * (size_t)random_below(s.vertex_count);
            for (k = 0; k < 3; ++k) {
                view.eye[k] = (round % 2) * ((double)p[k] + (double)q[k]) / 2 + random_in(-3, 3) * scales[m];
                if (round % 3 == 0) /* on a vertex, or in line with two */
                    view.eye[k] = round % 2 ? (double)p[k] : (double)p[k] - (double)q[k];
                if (round % 3 == 1 && k == round / 3 % 3) /* level with a vertex */
                    view.eye[k] = round % 2 ? (double)p[k] : 0;
                if (scales[m] < 1e-30) /* where bits below 2^-200 would be cut off */
                    view.eye[k] = ldexp(rint(ldexp(view.eye[k], 199)), -199);
            }
            if (view.eye[0] == 0 && view.eye[1] == 0 && view.eye[2] == 0)
                view.eye[3] = view.eye[2] = 1;
            check_mesh_view(&s, mesh, round % 4 < 2 ? pose : NULL, &view, &found, &exact);
        }
        sil_pose_destroy(pose);
        sil_mesh_destroy(mesh);
        shape_free(&s);
        shape_free(&plain);
    }
    print_message("views: %zu, with %zu silhouette edges; %zu signs needed exact arithmetic\n", views, found, exact);
    assert_true(found > 10000 && exact > 2000);
}

/* ---- the ray caster's picture ---- */

enum { WIDTH = 160, HEIGHT = 120 };

typedef struct picture {
    int fronts[HEIGHT][WIDTH], backs[HEIGHT][WIDTH];
    int across[HEIGHT][WIDTH], up[HEIGHT][WIDTH]; /* what silhouettes change to the next pixel */
    unsigned char skip_across[HEIGHT][WIDTH], skip_up[HEIGHT][WIDTH];
    int first_back; /* pixels whose first hit is a back face */
} picture;

static void multiply_point(const double m[16], const double p[3], double out[4]) {
    int k;
    for (k = 0; k < 4; ++k)
        out[k] = m[k] * p[0] + m[4 + k] * p[1] + m[8 + k] * p[2] + m[12 + k];
}

/* Looks from the eye along a direction; half_size 0: perspective of 60 degrees, else parallel. */
static void look(ref_scene *scene, const double eye[3], const double at[3], double half_size) {
    double f[3], s[3], u[3], n = 0, m = 0, r = (double)WIDTH / HEIGHT, t = tan(SHAPES_PI / 6), z0 = 1e-3, z1 = 50;
    int k;
    for (k = 0; k < 3; ++k) {
        f[k] = at[k] - eye[k];
        n += f[k] * f[k];
    }
    for (k = 0; k < 3; ++k)
        f[k] /= sqrt(n);
    s[0] = f[1];
    s[1] = -f[0];
    s[2] = 0;
    m = hypot(s[0], s[1]);
    for (k = 0; k < 3; ++k)
        s[k] /= m;
    for (k = 0; k < 3; ++k)
        u[k] = s[(k + 1) % 3] * f[(k + 2) % 3] - s[(k + 2) % 3] * f[(k + 1) % 3];
    memset(scene->view, 0, sizeof scene->view);
    memset(scene->projection, 0, sizeof scene->projection);
    scene->view[15] = 1;
    for (k = 0; k < 3; ++k) {
        scene->view[4 * k] = s[k];
        scene->view[4 * k + 1] = u[k];
        scene->view[4 * k + 2] = -f[k];
        scene->view[12] -= s[k] * eye[k];
        scene->view[13] -= u[k] * eye[k];
        scene->view[14] += f[k] * eye[k];
    }
    if (half_size > 0) {
        scene->projection[0] = 1 / (r * half_size);
        scene->projection[5] = 1 / half_size;
        scene->projection[10] = -2 / (z1 - z0);
        scene->projection[14] = -(z1 + z0) / (z1 - z0);
        scene->projection[15] = 1;
    } else {
        scene->projection[0] = 1 / (r * t);
        scene->projection[5] = 1 / t;
        scene->projection[10] = -(z1 + z0) / (z1 - z0);
        scene->projection[14] = -2 * z1 * z0 / (z1 - z0);
        scene->projection[11] = -1;
    }
}

static void cast_all(const ref_scene *scene, picture *out) {
    ref_i_world world;
    int x, y;
    size_t i;
    memset(&world, 0, sizeof world);
    world.scene = scene;
    assert_true(ref_i_make_world(&world));
    for (y = 0; y < HEIGHT; ++y)
        for (x = 0; x < WIDTH; ++x) {
            const ref_i_hit *first = NULL;
            assert_true(ref_i_cast(&world, x + 0.5, y + 0.5));
            for (i = 0; i < world.hit_count; ++i) {
                out->fronts[y][x] += world.hits[i].kind == REF_I_FRONT;
                out->backs[y][x] += world.hits[i].kind == REF_I_BACK;
                if (!first || world.hits[i].depth < first->depth)
                    first = &world.hits[i];
            }
            out->first_back += first && first->kind == REF_I_BACK;
        }
    ref_i_free_world(&world);
}

/* Adds what the line p q does to steps along `axis` (0: from x to x + 1 at the middle of each row). Left of the line
   there are one front and one back face more. Crossings within 1e-6 of a pixel's middle are not judged. */
static void add_crossings(picture *out, int axis, const double p[2], const double q[2]) {
    const int other = 1 - axis, rows = axis ? WIDTH : HEIGHT, columns = axis ? HEIGHT : WIDTH;
    double from = p[other] < q[other] ? p[other] : q[other], to = p[other] < q[other] ? q[other] : p[other];
    int row = (int)ceil((from < -1 ? -1 : from > 1e6 ? 1e6 : from) - 0.5 - 1e-6);
    for (row = row < 0 ? 0 : row; row < rows && row + 0.5 <= to + 1e-6; ++row) {
        const double at = row + 0.5, near_end = fmin(fabs(at - p[other]), fabs(at - q[other]));
        const double t = to > from ? (at - p[other]) / (q[other] - p[other]) : 0;
        const double where = p[axis] + (t < 0 ? 0 : t > 1 ? 1 : t) * (q[axis] - p[axis]) - 0.5;
        const double low = floor(where);
        int column, rises = q[other] > p[other];
        if (!(where > -2 && where < columns + 2))
            continue;
        column = (int)low;
        if (near_end < 1e-6 || where - low < 1e-6 || where - low > 1 - 1e-6) {
            int c; /* ends meet other edges' ends: both sides of the middle are left out */
            for (c = column - 1; c <= column + 1; ++c)
                if (c >= 0 && c < columns)
                    (axis ? out->skip_up : out->skip_across)[axis ? c : row][axis ? row : c] = 1;
            if (near_end < 1e-6)
                continue;
        }
        if (column < 0 || column >= columns)
            continue;
        /* going up in y, the left is at smaller x; going up in x, it is at larger y */
        if (axis)
            out->up[column][row] += rises ? 1 : -1;
        else
            out->across[row][column] += rises ? -1 : 1;
    }
}

static void project_silhouettes(const ref_scene *scene, const shape *s, const sil_mesh *mesh, const sil_view *view,
                                picture *out) {
    double both[16];
    size_t i, count;
    sil_edge *edges = extract_all(mesh, NULL, view, SIL_SILHOUETTE, &count);
    int c, r, k;
    for (c = 0; c < 4; ++c)
        for (r = 0; r < 4; ++r)
            for (k = 0, both[4 * c + r] = 0; k < 4; ++k)
                both[4 * c + r] += scene->projection[4 * k + r] * scene->view[4 * c + k];
    for (i = 0; i < count; ++i) {
        double clip[2][4], window[2][2];
        const uint32_t v[2] = {edges[i].a, edges[i].b};
        for (k = 0; k < 2; ++k) {
            double p[3];
            for (c = 0; c < 3; ++c)
                p[c] = (double)s->positions[3 * (size_t)v[k] + (size_t)c];
            multiply_point(both, p, clip[k]);
        }
        for (k = 0; k < 2; ++k) { /* before the near plane there are no hits */
            const double a = clip[k][2] + clip[k][3], b = clip[1 - k][2] + clip[1 - k][3];
            if (a < 0 && b > 0)
                for (c = 0; c < 4; ++c)
                    clip[k][c] += (clip[1 - k][c] - clip[k][c]) * (a / (a - b));
        }
        if (clip[0][2] + clip[0][3] < -1e-9 || clip[1][2] + clip[1][3] < -1e-9)
            continue;
        for (k = 0; k < 2; ++k) {
            window[k][0] = (clip[k][0] / clip[k][3] + 1) * 0.5 * WIDTH;
            window[k][1] = (clip[k][1] / clip[k][3] + 1) * 0.5 * HEIGHT;
        }
        add_crossings(out, 0, window[0], window[1]);
        add_crossings(out, 1, window[0], window[1]);
    }
    free(edges);
}

typedef struct tally {
    size_t pairs, left_out, changes, first_back;
} tally;

static void check_picture(const shape *s, const sil_mesh *mesh, const double eye[3], const double at[3],
                          double half_size, tally *t) {
    static picture p;
    static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    ref_object object;
    ref_scene scene;
    sil_view view = sil_view_perspective(eye);
    int x, y, k;
    memset(&p, 0, sizeof p);
    memset(&object, 0, sizeof object);
    memset(&scene, 0, sizeof scene);
    object.positions = s->positions;
    object.indices = s->indices;
    object.vertex_count = s->vertex_count;
    object.triangle_count = s->index_count / 3;
    memcpy(object.model, identity, sizeof identity);
    object.id = 1;
    object.transparent = true;
    scene.objects = &object;
    scene.object_count = 1;
    scene.width = WIDTH;
    scene.height = HEIGHT;
    look(&scene, eye, at, half_size);
    if (half_size > 0) {
        double toward[3];
        for (k = 0; k < 3; ++k)
            toward[k] = eye[k] - at[k];
        view = sil_view_orthographic(toward);
    }
    cast_all(&scene, &p);
    project_silhouettes(&scene, s, mesh, &view, &p);
    t->first_back += (size_t)p.first_back;
    for (y = 0; y < HEIGHT; ++y)
        for (x = 0; x < WIDTH; ++x)
            for (k = 0; k < 2; ++k) {
                const int x1 = x + !k, y1 = y + k, change = k ? p.up[y][x] : p.across[y][x];
                if (x1 >= WIDTH || y1 >= HEIGHT)
                    continue;
                ++t->pairs;
                if (k ? p.skip_up[y][x] : p.skip_across[y][x]) {
                    ++t->left_out;
                    continue;
                }
                assert_int_equal(p.fronts[y1][x1] - p.fronts[y][x], change);
                assert_int_equal(p.backs[y1][x1] - p.backs[y][x], change);
                t->changes += change != 0;
            }
}

static void test_pictures(void **state) {
    tally t = {0, 0, 0, 0};
    int m, round, k;
    (void)state;
    for (m = 0; m < 4; ++m) {
        shape s = m == 0   ? make_torus(24, 14, 0, 0)
                  : m == 1 ? make_torus(16, 10, 0.08, 0)
                  : m == 2 ? make_ball(3)
                           : make_box(2, 2, 2);
        sil_mesh *mesh = mesh_of(&s);
        for (round = 0; round < 30; ++round) {
            const double middle[3] = {m == 3 ? 1 : 0, m == 3 ? 1 : 0, m == 3 ? 1 : 0};
            double eye[3], at[3];
            for (k = 0; k < 3; ++k) {
                eye[k] = random_in(-3, 3);
                at[k] = middle[k] + random_in(-0.3, 0.3);
            }
            if (round % 3 == 2) { /* inside: in the torus' tube, in the ball, in the box */
                const double inside[3][3] = {{1, 0.03, 0.02}, {0.1, 0.2, 0}, {0.7, 0.8, 0.9}};
                memcpy(eye, inside[m < 2 ? 0 : m - 1], sizeof eye);
                at[0] += random_in(-2, 2);
                at[1] += random_in(0.5, 2);
            } else if (hypot(hypot(eye[0] - middle[0], eye[1] - middle[1]), eye[2] - middle[2]) < 2.2)
                eye[round % 2] += 5;
            check_picture(&s, mesh, eye, at, round % 3 == 1 ? 1.8 : 0, &t);
        }
        sil_mesh_destroy(mesh);
        shape_free(&s);
    }
    print_message(
        "pictures: %zu pairs of pixels, %zu separated by silhouettes, %.5f %% left out; %zu back faces first\n",
        t.pairs, t.changes, 100.0 * (double)t.left_out / (double)t.pairs, t.first_back);
    assert_true(t.changes > 20000 && t.first_back > 10000 && (double)t.left_out < 1e-3 * (double)t.pairs);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_expansions),
        cmocka_unit_test(test_signs_of_soups),
        cmocka_unit_test(test_meshes_in_views),
        cmocka_unit_test(test_pictures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

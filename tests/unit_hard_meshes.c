/* The hard cases that concern meshes, by name: what silhouette.h promises for each, and the worst error that is measured.
   An error is a number of edges that differ from the truth, or of promises broken, unless the case names another unit.
   Build: cc -std=c11 -I. tests/unit_hard_meshes.c -lcmocka -lm */
#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

#include "exact.h"
#include "shapes.h"

/* ---- the truth ---- */

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

/* Edges that are silhouettes and are not found, or the other way round, and vertices of odd degree, of a closed mesh
   without split vertices. */
static double wrong_edges(const shape *s, const sil_mesh *mesh, sil_pose *pose, const sil_view *view) {
    side *sides = (side *)calloc(s->index_count + 1, sizeof *sides);
    unsigned char *is = (unsigned char *)calloc(s->index_count + 1, 1);
    size_t i, count, exact = 0, wrong;
    sil_edge *edges = extract_all(mesh, pose, view, SIL_SILHOUETTE, &count);
    assert_non_null(sides);
    assert_non_null(is);
    for (i = 0; i < s->index_count; ++i) {
        const uint32_t *f = s->indices + i / 3 * 3, a = s->indices[i], b = f[(i + 1) % 3];
        const float *p = s->positions;
        sides[i].low = a < b ? a : b;
        sides[i].high = a < b ? b : a;
        sides[i].front =
            i % 3 ? sides[i / 3 * 3].front
                  : true_sign(p + 3 * (size_t)f[0], p + 3 * (size_t)f[1], p + 3 * (size_t)f[2], view->eye, &exact) > 0;
    }
    qsort(sides, s->index_count, sizeof *sides, compare_sides);
    wrong = odd_vertices(edges, count, s->vertex_count);
    for (i = 0; i < count; ++i) {
        side key, *hit;
        key.low = edges[i].a < edges[i].b ? edges[i].a : edges[i].b;
        key.high = edges[i].a < edges[i].b ? edges[i].b : edges[i].a;
        hit = (side *)bsearch(&key, sides, s->index_count, sizeof *sides, compare_sides);
        assert_non_null(hit);
        is[(hit - sides) / 2] ^= 1;
    }
    for (i = 0; i + 1 < s->index_count; i += 2)
        wrong += is[i / 2] != (sides[i].front != sides[i + 1].front);
    free(edges);
    free(sides);
    free(is);
    return (double)wrong;
}

/* The worst of many views: around it, along axes, from its vertices, on planes of its faces, from within. */
static double worst_view(const shape *s, double size, const double middle[3]) {
    sil_mesh_desc desc = desc_of(s);
    sil_mesh *mesh;
    sil_pose *pose;
    double worst = 0;
    int round, k;
    desc.flags = SIL_MESH_HIERARCHY;
    desc.weld_distance = -1;
    mesh = mesh_from(&desc);
    pose = pose_of(mesh);
    for (round = 0; round < 200; ++round) {
        sil_view view = view_at(0, 0, 0, (double)(round % 2));
        const uint32_t *f = s->indices + 3 * (size_t)random_below(s->index_count / 3);
        const float *a = s->positions + 3 * (size_t)f[0], *b = s->positions + 3 * (size_t)f[1];
        for (k = 0; k < 3; ++k)
            switch (round / 2 % 4) {
            case 0:
                view.eye[k] = view.eye[3] * middle[k] + random_in(-3, 3) * size;
                break;
            case 1: /* on a vertex; along an edge */
                view.eye[k] = round % 2 ? (double)a[k] : (double)b[k] - (double)a[k];
                break;
            case 2: /* in a face's plane: further along its edge; along an axis */
                view.eye[k] = round % 2 ? 3 * (double)b[k] - 2 * (double)a[k] : (double)(k == round / 8 % 3);
                break;
            default: /* within, or near */
                view.eye[k] = view.eye[3] * middle[k] + random_in(-1, 1) * size;
            }
        if (view.eye[0] == 0 && view.eye[1] == 0 && view.eye[2] == 0 && view.eye[3] == 0)
            view.eye[2] = 1;
        worst = fmax(worst, wrong_edges(s, mesh, round % 3 ? pose : NULL, &view));
    }
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    return worst;
}

static int compare_ends(const void *a, const void *b) {
    const sil_edge *x = (const sil_edge *)a, *y = (const sil_edge *)b;
    if (x->a != y->a)
        return x->a < y->a ? -1 : 1;
    return x->b < y->b ? -1 : x->b > y->b;
}

/* Edges of all kinds that are in one mesh's lines and not in the other's, by their ends. */
static double other_lines(const sil_mesh *a, const sil_mesh *b, const sil_view *view) {
    size_t m, n, i = 0, j = 0, wrong = 0;
    sil_edge *one = extract_all(a, NULL, view, 15, &m), *two = extract_all(b, NULL, view, 15, &n);
    qsort(one, m, sizeof *one, compare_ends);
    qsort(two, n, sizeof *two, compare_ends);
    while (i < m || j < n) {
        const int order = i == m ? 1 : j == n ? -1 : compare_ends(&one[i], &two[j]);
        wrong += order != 0 || one[i].kinds != two[j].kinds;
        i += order <= 0;
        j += order >= 0;
    }
    free(one);
    free(two);
    return (double)wrong;
}

/* ---- cases: each returns its worst error ---- */

static const double origin[3] = {0, 0, 0};

static double ordinary(void) {
    shape s = make_torus(20, 12, 0.05, 0);
    const double worst = worst_view(&s, 1, origin);
    shape_free(&s);
    return worst;
}

/* A drum whose mantle is slivers a millionth as wide as long. */
static double slivers(void) {
    shape s = make_cylinder(400, 1e-4, 100);
    const double worst = worst_view(&s, 50, origin);
    shape_free(&s);
    return worst;
}

/* Faces with two vertices a few ulps apart. */
static double needles(void) {
    shape s = make_torus(16, 10, 0.05, 0), more = empty_shape();
    size_t i, faces = s.index_count / 3;
    double worst;
    add_shape(&more, &s, 1, 0, 0, 0);
    for (i = 0; i < faces; i += 3) { /* an edge is split next to its end; both of its faces become two */
        uint32_t *f = more.indices + 3 * i, a = f[0], b = f[1], c = f[2], middle, *other = NULL;
        const float *p = more.positions + 3 * (size_t)a, *q = more.positions + 3 * (size_t)b;
        size_t j, k;
        float m[3];
        for (k = 0; k < 3; ++k)
            m[k] = nextafterf(nextafterf(p[k], q[k]), q[k]);
        for (j = 0; j < more.index_count && !other; ++j)
            if (more.indices[j] == b && more.indices[j / 3 * 3 + (j + 1) % 3] == a)
                other = more.indices + j;
        assert_non_null(other);
        j = (size_t)(other - more.indices);
        middle = add_vertex(&more, (double)m[0], (double)m[1], (double)m[2]);
        f = more.indices + 3 * i;
        {
            const uint32_t d = more.indices[j / 3 * 3 + (j + 2) % 3];
            f[1] = middle;
            more.indices[j / 3 * 3 + (j + 1) % 3] = middle;
            add_face(&more, middle, b, c);
            add_face(&more, middle, a, d);
        }
    }
    worst = worst_view(&more, 1, origin);
    shape_free(&s);
    shape_free(&more);
    return worst;
}

/* A torus with a face without area on every third edge: its lines are as if those were not there. */
static double zero_areas(void) {
    shape s = make_torus(16, 10, 0.05, 64), dirty = empty_shape();
    sil_mesh *clean = mesh_of(&s), *mesh;
    double worst = 0;
    size_t i;
    int round;
    add_shape(&dirty, &s, 1, 0, 0, 0);
    for (i = 0; i + 2 < s.index_count; i += 9) {
        const uint32_t a = s.indices[i], b = s.indices[i + 1];
        const float *p = s.positions + 3 * (size_t)a, *q = s.positions + 3 * (size_t)b;
        const uint32_t m = add_vertex(&dirty, 0.5 * ((double)p[0] + (double)q[0]), 0.5 * ((double)p[1] + (double)q[1]),
                                      0.5 * ((double)p[2] + (double)q[2]));
        add_face(&dirty, a, b, i % 2 ? m : a);
    }
    mesh = mesh_of(&dirty);
    for (round = 0; round < 200; ++round) {
        const sil_view view = view_at(random_in(-3, 3), random_in(-3, 3), random_in(-3, 3), (double)(round % 2));
        worst = fmax(worst, other_lines(clean, mesh, &view));
    }
    sil_mesh_destroy(clean);
    sil_mesh_destroy(mesh);
    shape_free(&s);
    shape_free(&dirty);
    return worst;
}

static double far_away(void) {
    static const double middle[3] = {1e6, -1e6, 1e6};
    shape s = make_torus(24, 14, 0.05, 0), far = empty_shape();
    double worst;
    add_shape(&far, &s, 1, middle[0], middle[1], middle[2]);
    worst = worst_view(&far, 1, middle);
    shape_free(&s);
    shape_free(&far);
    return worst;
}

static double scaled(int power) {
    shape s = make_torus(20, 12, 0.05, 0), big = empty_shape();
    double worst;
    add_shape(&big, &s, ldexp(1, power), 0, 0, 0);
    worst = worst_view(&big, ldexp(1, power), origin);
    shape_free(&s);
    shape_free(&big);
    return worst;
}

static double huge(void) {
    return scaled(126);
}

static double small(void) {
    return scaled(-100); /* of the eye nothing is cut off yet: that begins at 2^-200 */
}

/* Coordinates that are small multiples of the least float there is, and lines that are those at the scale of 1. */
static double denormals(void) {
    shape s = make_torus(12, 8, 0, 16), least = empty_shape();
    sil_mesh *a, *b;
    double worst = 0;
    int round;
    add_shape(&least, &s, ldexp(16, -149), 0, 0, 0);
    a = mesh_of(&s);
    b = mesh_of(&least);
    worst += fabs((double)sil_mesh_get_info(a).edge_count - (double)sil_mesh_get_info(b).edge_count);
    worst += fabs((double)sil_mesh_get_info(a).crease_edge_count - (double)sil_mesh_get_info(b).crease_edge_count);
    for (round = 0; round < 200; ++round) { /* directions: an eye at that scale would lose its bits */
        const sil_view view = view_at(random_in(-3, 3), random_in(-3, 3), round % 5 ? random_in(-3, 3) : 0, 0);
        worst = fmax(worst, other_lines(a, b, &view));
    }
    sil_mesh_destroy(a);
    sil_mesh_destroy(b);
    shape_free(&s);
    shape_free(&least);
    return worst;
}

/* Faces with a vertex that is none: the other lines are those of the mesh without these faces. */
static double bad_vertices(void) {
    shape s = make_torus(16, 10, 0.05, 0), rest = empty_shape();
    const float bad[3] = {NAN, INFINITY, -INFINITY};
    sil_mesh *a, *b;
    double worst = 0;
    size_t i;
    int round, k;
    for (k = 0; k < 3; ++k)
        s.positions[3 * (20 + 30 * k) + k] = bad[k];
    add_shape(&rest, &s, 1, 0, 0, 0);
    rest.index_count = 0;
    for (i = 0; i + 2 < s.index_count; i += 3)
        if (isfinite(s.positions[3 * s.indices[i] + 0]) && isfinite(s.positions[3 * s.indices[i] + 1]) &&
            isfinite(s.positions[3 * s.indices[i] + 2]) && isfinite(s.positions[3 * s.indices[i + 1] + 0]) &&
            isfinite(s.positions[3 * s.indices[i + 1] + 1]) && isfinite(s.positions[3 * s.indices[i + 1] + 2]) &&
            isfinite(s.positions[3 * s.indices[i + 2] + 0]) && isfinite(s.positions[3 * s.indices[i + 2] + 1]) &&
            isfinite(s.positions[3 * s.indices[i + 2] + 2]))
            add_face(&rest, s.indices[i], s.indices[i + 1], s.indices[i + 2]);
    a = mesh_of(&s);
    b = mesh_of(&rest);
    worst += (double)(sil_mesh_get_info(a).dropped_face_count != 18);
    for (round = 0; round < 200; ++round) {
        const sil_view view = view_at(random_in(-3, 3), random_in(-3, 3), random_in(-3, 3), (double)(round % 2));
        worst = fmax(worst, other_lines(a, b, &view));
    }
    sil_mesh_destroy(a);
    sil_mesh_destroy(b);
    shape_free(&s);
    shape_free(&rest);
    return worst;
}

/* Numbers that are none in everything but the mesh: an error, or no lines; nothing changed, nothing read. */
static double bad_numbers(void) {
    const float bad[3] = {NAN, INFINITY, -INFINITY};
    shape s = make_torus(8, 6, 0, 0);
    sil_mesh *mesh = mesh_of(&s);
    sil_pose *pose = pose_of(mesh);
    sil_edge edges[200];
    double broken = 0;
    size_t i, count;
    int k;
    const sil_view good = view_at(1, 2, 3, 1);
    count = sil_extract(mesh, NULL, &good, SIL_SILHOUETTE, edges, 200);
    for (i = 0; i < 3; ++i) {
        const double d = (double)bad[i], point[3] = {d, 0, 0};
        float m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, distance, positions[3 * 48];
        uint32_t parent, facts;
        sil_mesh_desc desc = desc_of(&s);
        sil_distance_desc far_desc;
        sil_part part;
        sil_result result = SIL_OK;
        sil_view view = sil_view_perspective(point);
        for (k = 0; k < 4; ++k) {
            view = good;
            view.eye[k] = d;
            broken += sil_extract(mesh, k % 2 ? pose : NULL, &view, SIL_SILHOUETTE, NULL, 0) != 0;
        }
        m[5] = bad[i];
        broken += sil_view_from_matrices(m, m, &view) != SIL_INVALID_ARGUMENT;
        broken += sil_extract(mesh, NULL, &view, SIL_SILHOUETTE, NULL, 0) != 0;
        memset(&part, 0, sizeof part);
        part.mesh = mesh;
        memcpy(part.transform, m, sizeof m);
        broken += sil_containment(&part, 1, 0, &parent, &facts) != SIL_INVALID_ARGUMENT;
        broken += sil_pose_set_dead_zone(pose, d, 0) != SIL_INVALID_ARGUMENT;
        memset(&far_desc, 0, sizeof far_desc);
        far_desc.model[0] = bad[i];
        broken += sil_distances(mesh, NULL, edges, count, &far_desc, 0, 1, &distance, NULL) != SIL_INVALID_ARGUMENT;
        for (k = 0; k < 3; ++k) {
            desc = desc_of(&s);
            *(k == 0 ? &desc.weld_distance : k == 1 ? &desc.crease_degrees : &desc.t_junction_distance) = bad[i];
            broken += sil_mesh_create(&desc, &result) != NULL || result != SIL_INVALID_ARGUMENT;
        }
        memcpy(positions, s.positions, sizeof positions); /* a pose that is none: no line ends there */
        positions[21] = bad[i];
        broken += sil_pose_set(pose, positions, 0) != SIL_OK;
        {
            size_t n, e;
            sil_edge *found = extract_all(mesh, pose, &good, 15, &n);
            for (e = 0; e < n; ++e)
                broken += found[e].a == 7 || found[e].b == 7;
            broken += n == 0;
            free(found);
        }
        broken += sil_pose_set(pose, NULL, 0) != SIL_OK;
    }
    broken += sil_extract(mesh, pose, &good, SIL_SILHOUETTE, NULL, 0) != count;
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    shape_free(&s);
    return broken;
}

static double one_triangle(void) {
    const float positions[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    sil_mesh_desc desc;
    sil_mesh *mesh;
    sil_edge edges[3];
    sil_strip strips[3];
    uint32_t vertices[6], component = 9, parent = 9, facts = 9;
    size_t needed;
    float distances[3];
    double broken = 0;
    sil_part part;
    int round;
    memset(&desc, 0, sizeof desc);
    desc.positions = positions;
    desc.vertex_count = 3;
    for (round = 0; round < 8; ++round) {
        const sil_view view = view_at(1, 1, round % 3 - 1.0, 0);
        desc.flags = round % 2 ? SIL_MESH_HIERARCHY | SIL_MESH_ORIENT : 0;
        desc.t_junction_distance = round / 2 % 2 ? 0.01f : 0;
        mesh = mesh_from(&desc);
        broken += sil_extract(mesh, NULL, &view, 79, edges, 3) != 3;
        broken += (edges[0].kinds | edges[1].kinds | edges[2].kinds) != SIL_BOUNDARY;
        broken += sil_chain(mesh, NULL, edges, 3, strips, 3, vertices, 6, &needed) != 1 || needed != 4 ||
                  strips[0].closed != 1;
        broken += sil_distances(mesh, NULL, edges, 3, NULL, 0, 3, distances, NULL) != SIL_OK ||
                  distances[0] + distances[1] + distances[2] > 0;
        memset(&part, 0, sizeof part);
        part.mesh = mesh;
        broken += sil_containment(&part, 1, 0, &parent, &facts) != SIL_OK || parent != SIL_NONE || facts != 0;
        broken += sil_mesh_components(mesh, &component, 1) != SIL_OK || component != 0;
        sil_mesh_destroy(mesh);
    }
    return broken;
}

static double empty_mesh(void) {
    sil_mesh_desc desc;
    sil_mesh *mesh;
    sil_pose *pose;
    const sil_view view = view_at(1, 1, 1, 1);
    uint32_t parent = 9, facts = 9;
    sil_part part;
    double broken = 0;
    int round;
    memset(&desc, 0, sizeof desc);
    for (round = 0; round < 4; ++round) {
        desc.flags = round % 2 ? SIL_MESH_HIERARCHY | SIL_MESH_ORIENT : 0;
        desc.t_junction_distance = round / 2 ? 0.01f : 0;
        mesh = mesh_from(&desc);
        pose = pose_of(mesh);
        broken += sil_pose_set_dead_zone(pose, 0.1, SIL_ZONE_REMEMBER) != SIL_OK;
        broken += sil_extract(mesh, pose, &view, 79, NULL, 0) != 0 || sil_extract(mesh, NULL, NULL, 79, NULL, 0) != 0;
        memset(&part, 0, sizeof part);
        part.mesh = mesh;
        broken += sil_containment(&part, 1, 0, &parent, &facts) != SIL_OK || parent != SIL_NONE || facts != 0;
        broken += sil_mesh_components(mesh, NULL, 0) != SIL_OK;
        sil_pose_destroy(pose);
        sil_mesh_destroy(mesh);
    }
    return broken;
}

/* Distances against all pairs in long double, as a share of the mesh's size. */
static double distances_at(double scale, double offset) {
    shape plain = make_torus(20, 12, 0.05, 0), s = empty_shape();
    sil_mesh *mesh;
    double worst = 0;
    int round;
    size_t i, e;
    add_shape(&s, &plain, scale, offset, -offset, offset);
    mesh = mesh_of(&s);
    for (round = 0; round < 20; ++round) {
        const sil_view view = view_at(random_in(-3, 3), random_in(-3, 3), random_in(-3, 3), 0);
        size_t count;
        sil_edge *edges = extract_all(mesh, NULL, &view, SIL_SILHOUETTE, &count);
        float *found = (float *)calloc(s.vertex_count, sizeof *found);
        assert_non_null(found);
        assert_int_equal(sil_distances(mesh, NULL, edges, count, NULL, 0, s.vertex_count, found, NULL), SIL_OK);
        for (i = 0; i < s.vertex_count; ++i) {
            long double best = HUGE_VALL;
            for (e = 0; e < count; ++e) {
                long double dd = 0, dv = 0, square = 0, t;
                const float *a = s.positions + 3 * (size_t)edges[e].a, *b = s.positions + 3 * (size_t)edges[e].b;
                const float *p = s.positions + 3 * i;
                int k;
                for (k = 0; k < 3; ++k) {
                    const long double d = (long double)b[k] - (long double)a[k];
                    dd += d * d;
                    dv += d * ((long double)p[k] - (long double)a[k]);
                }
                t = dd > 0 ? dv / dd : 0;
                t = t < 0 ? 0 : t > 1 ? 1 : t;
                for (k = 0; k < 3; ++k) {
                    const long double d =
                        (long double)p[k] - (long double)a[k] - t * ((long double)b[k] - (long double)a[k]);
                    square += d * d;
                }
                best = square < best ? square : best;
            }
            worst = fmax(worst, fabs((double)(sqrtl(best) - (long double)found[i])) / (2.8 * scale));
        }
        free(edges);
        free(found);
    }
    sil_mesh_destroy(mesh);
    shape_free(&plain);
    shape_free(&s);
    return worst;
}

static double distances_far_away(void) {
    return distances_at(100, 1e6);
}

static double distances_huge(void) {
    return distances_at(1e37, 0);
}

static double distances_small(void) {
    return distances_at(1e-37, 0);
}

/* T-junctions and a dead zone far from the origin: as at it, since coordinates there are exact. */
static double options_far_away(void) {
    shape s = make_sheet(4, 4), t = make_sheet(2, 2), both = empty_shape();
    double broken = 0;
    int far;
    for (far = 0; far < 2; ++far) {
        sil_mesh_desc desc;
        sil_mesh *mesh;
        const double at = far ? 1048576 : 0;
        shape_free(&both);
        add_shape(&both, &s, 0.5, at, at, at);
        add_shape(&both, &t, 1, at + 2, at, at);
        desc = desc_of(&both);
        desc.t_junction_distance = 0.01f;
        mesh = mesh_from(&desc);
        broken += sil_mesh_get_info(mesh).t_junction_count != 2;
        broken += sil_mesh_get_info(mesh).boundary_edge_count != 12 + 6;
        sil_mesh_destroy(mesh);
    }
    shape_free(&s);
    shape_free(&t);
    shape_free(&both);
    return broken;
}

/* ---- the table ---- */

typedef struct hard_case {
    const char *name, *promise;
    double limit;
    double (*measure)(void);
} hard_case;

static const hard_case cases[] = {
    {"an ordinary torus", "exact from any eye, on planes, vertices, inside", 0, ordinary},
    {"slivers 10^6 times as long as wide", "exact", 0, slivers},
    {"needles two ulps wide", "exact", 0, needles},
    {"faces without area", "the lines of the mesh without them", 0, zero_areas},
    {"size 1 at 10^6, where floats are 1/16 apart", "exact", 0, far_away},
    {"coordinates up to 2^127", "exact", 0, huge},
    {"coordinates of 2^-100", "exact", 0, small},
    {"denormal coordinates", "the lines at the scale of 1", 0, denormals},
    {"NaN and infinities in vertices", "faces left out, the others as without", 0, bad_vertices},
    {"NaN and infinities elsewhere", "an error, or no lines", 0, bad_numbers},
    {"one triangle", "three borders, one loop", 0, one_triangle},
    {"no triangle", "no line, no error", 0, empty_mesh},
    {"distances, size 100 at 10^6", "10^-6 of the size", 1e-6, distances_far_away},
    {"distances at 10^37", "10^-6 of the size", 1e-6, distances_huge},
    {"distances at 10^-37", "10^-6 of the size", 1e-6, distances_small},
    {"T-junctions at 2^20", "as at the origin", 0, options_far_away},
};

static void test_hard_cases(void **state) {
    size_t i, failed = 0;
    (void)state;
    print_message("%-44s %-50s %s\n", "case", "promise", "worst error");
    for (i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const double worst = cases[i].measure();
        const int bad = !(worst <= cases[i].limit);
        print_message("%-44s %-50s %g%s\n", cases[i].name, cases[i].promise, worst, bad ? "  FAILS" : "");
        failed += (size_t)bad;
    }
    assert_int_equal(failed, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_hard_cases)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

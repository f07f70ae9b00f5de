/* Unit tests of what silhouette.h does to dirty meshes when asked: T-junctions and slivers, windings, borders of parts,
   edges of many faces. The truth is the clean mesh that each was made from, or is counted by hand.
   Build: cc -std=c11 -I. tests/unit_dirty.c -lcmocka -lm */
#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

#include "shapes.h"

static sil_view random_view(int round) {
    sil_view view = view_at(random_in(-4, 4), random_in(-4, 4), random_in(-4, 4), (double)(round % 2));
    if (round % 5 == 0)
        view = view_at(round % 3 == 0, round % 3 == 1, round % 3 == 2, 0);
    return view;
}

/* ---- T-junctions ---- */

/* A torus on a grid of even numbers / 128: middles of its edges are exact. Every third triangle is cut in two at the
   middle of a side, of which the other side's triangle knows nothing. cut[edge of the clean mesh]: cut there. */
static shape cut_torus(const shape *clean, int every) {
    shape s = empty_shape();
    size_t i;
    int k;
    add_shape(&s, clean, 1, 0, 0, 0);
    for (i = 0; i < clean->index_count / 3; ++i) {
        const uint32_t *f = clean->indices + 3 * i, p = f[i % 3], q = f[(i + 1) % 3], r = f[(i + 2) % 3];
        double m[3];
        uint32_t middle;
        if (i % (size_t)every)
            continue;
        for (k = 0; k < 3; ++k)
            m[k] = 0.5 * ((double)clean->positions[3 * (size_t)p + (size_t)k] +
                          (double)clean->positions[3 * (size_t)q + (size_t)k]);
        middle = add_vertex(&s, m[0], m[1], m[2]);
        s.indices[3 * i] = p;
        s.indices[3 * i + 1] = middle;
        s.indices[3 * i + 2] = r;
        add_face(&s, middle, q, r);
    }
    return s;
}

static double total_length(const shape *s, const sil_edge *edges, size_t count) {
    double sum = 0;
    size_t i;
    for (i = 0; i < count; ++i) {
        const float *p = s->positions + 3 * (size_t)edges[i].a, *q = s->positions + 3 * (size_t)edges[i].b;
        sum += hypot(hypot((double)p[0] - (double)q[0], (double)p[1] - (double)q[1]), (double)p[2] - (double)q[2]);
    }
    return sum;
}

/* With the cracks closed the lines are those of the clean torus, in pieces: closed loops of the same length, each piece
   on a clean silhouette, the faces' numbers included. */
static void test_cracks_of_a_torus(void **state) {
    shape clean = make_torus(14, 9, 0.05, 64), dirty = cut_torus(&clean, 3);
    sil_mesh_desc desc = desc_of(&dirty);
    sil_mesh *whole = mesh_of(&clean), *cracked = mesh_of(&dirty), *closed;
    sil_pose *pose;
    sil_mesh_info info;
    size_t i;
    int round;
    (void)state;
    assert_int_equal(sil_mesh_get_info(whole).unique_vertex_count, clean.vertex_count);
    assert_int_equal(sil_mesh_get_info(cracked).closed, 0);
    assert_int_equal(sil_mesh_get_info(cracked).boundary_edge_count, 3 * 84);
    desc.t_junction_distance = 1e-6f;
    desc.flags = SIL_MESH_HIERARCHY;
    closed = mesh_from(&desc);
    pose = pose_of(closed);
    info = sil_mesh_get_info(closed);
    assert_int_equal(info.closed, 1);
    assert_int_equal(info.boundary_edge_count, 0);
    assert_int_equal(info.nonmanifold_edge_count, 0);
    assert_int_equal(info.t_junction_count, 84);
    assert_int_equal(info.face_count, dirty.index_count / 3);
    assert_int_equal(info.degenerate_face_count, 0);
    assert_int_equal(info.component_count, 1);
    for (round = 0; round < 400; ++round) {
        sil_view view = random_view(round);
        size_t count, all, again;
        sil_edge *truth, *edges, *flat;
        for (i = 0; i < 3; ++i)
            view.eye[i] = floor(64 * view.eye[i]) / 64;
        truth = extract_all(whole, NULL, &view, SIL_SILHOUETTE, &count);
        edges = extract_all(closed, pose, &view, SIL_SILHOUETTE | SIL_BOUNDARY, &all);
        flat = extract_all(closed, NULL, &view, SIL_SILHOUETTE | SIL_BOUNDARY, &again);
        assert_int_equal(all, again);
        check_same_edges(edges, flat, all);
        assert_int_equal(odd_vertices(edges, all, dirty.vertex_count), 0);
        assert_true(fabs(total_length(&clean, truth, count) - total_length(&dirty, edges, all)) < 1e-9);
        for (i = 0; i < all; ++i)
            assert_true(edges[i].face[0] < dirty.index_count / 3 && edges[i].face[1] < dirty.index_count / 3 &&
                        edges[i].face[0] != edges[i].face[1]);
        free(truth);
        free(edges);
        free(flat);
    }
    sil_pose_destroy(pose);
    sil_mesh_destroy(whole);
    sil_mesh_destroy(cracked);
    sil_mesh_destroy(closed);
    shape_free(&clean);
    shape_free(&dirty);
}

/* Two sheets that share the line x = 0, one of 3 quads along it and one of 5, folded by 90 degrees: 7 pieces of one
   crease, of which each has one triangle of either sheet. */
static shape two_sheets(double gap) {
    shape s = empty_shape();
    const int n[2] = {3, 5};
    int side, i;
    for (side = 0; side < 2; ++side) {
        const uint32_t first = (uint32_t)s.vertex_count;
        for (i = 0; i <= n[side]; ++i) {
            const double y = (double)i / n[side], inner = i % n[side] ? gap : 0;
            add_vertex(&s, side ? inner : 0, y, 0);
            add_vertex(&s, side ? 1 : 0, y, side ? 0 : -1);
        }
        for (i = 0; i < n[side]; ++i) {
            const uint32_t a = first + 2 * (uint32_t)i;
            add_face(&s, a, side ? a + 1 : a + 2, side ? a + 3 : a + 3);
            add_face(&s, a, a + 3, side ? a + 2 : a + 1);
        }
    }
    return s;
}

static void test_two_sheets(void **state) {
    shape s = two_sheets(0);
    const sil_view above = view_at(-1, 0.1, 1, 0), aside = view_at(1, 0.1, 0.5, 0);
    sil_mesh_desc desc = desc_of(&s);
    sil_mesh *mesh = mesh_of(&s);
    sil_edge *edges;
    size_t count, i;
    int round;
    (void)state;
    assert_int_equal(sil_extract(mesh, NULL, &above, SIL_CREASE, NULL, 0), 0);
    assert_int_equal(sil_mesh_get_info(mesh).boundary_edge_count, 20);
    sil_mesh_destroy(mesh);
    desc.t_junction_distance = 1e-3f;
    mesh = mesh_from(&desc);
    assert_int_equal(sil_mesh_get_info(mesh).boundary_edge_count, 12);
    assert_int_equal(sil_mesh_get_info(mesh).t_junction_count, 6);
    assert_int_equal(sil_mesh_get_info(mesh).flipped_edge_count, 0);
    for (round = 0; round < 2; ++round) {
        edges = extract_all(mesh, NULL, round ? &aside : &above, round ? SIL_SILHOUETTE : SIL_CREASE, &count);
        assert_int_equal(count, 7);
        for (i = 0; i < count; ++i) {
            assert_int_equal((int)s.positions[3 * edges[i].a], 0);
            assert_int_equal((int)s.positions[3 * edges[i].b], 0);
            assert_int_equal(edges[i].face[0] < 6, edges[i].face[1] >= 6);
        }
        free(edges);
    }
    sil_mesh_destroy(mesh);
    shape_free(&s);
}

/* The distance is what it says: inner vertices off the line by a little less, and a little more. */
static void test_crack_distance(void **state) {
    double gap;
    (void)state;
    for (gap = 0.0009; gap < 0.0012; gap += 0.0002) {
        shape s = two_sheets(gap);
        sil_mesh_desc desc = desc_of(&s);
        sil_mesh *mesh;
        desc.t_junction_distance = 0.001f;
        mesh = mesh_from(&desc);
        /* The inner vertices of the side of 3 lie on the sides of 5 tilted towards the corners, nearer than the gap. */
        assert_int_equal(sil_mesh_get_info(mesh).boundary_edge_count == 12, gap < 0.001);
        sil_mesh_destroy(mesh);
        shape_free(&s);
    }
}

/* One side and one vertex of another face near it: cut if it is near the side's inside, and not near its ends. */
static void test_where_cuts_are(void **state) {
    static const struct {
        double x, y;
        size_t cuts;
    } places[] = {{5, 0.9, 1},  {5, -0.9, 1},    {5, 1.1, 0},    {5, -1.1, 0},    {0.5, 0.5, 0},
                  {9.5, 0, 0},  {-0.5, 0, 0},    {10.5, 0, 0},   {0.8, 0.8, 4},   {9.2, -0.8, 1},
                  {1.01, 0, 1}, {0.99, 0.01, 0}, {-1.5, 0.5, 0}, {11.5, -0.5, 0}, {5, 0, 1}};
    size_t i, turn;
    (void)state;
    for (i = 0; i < sizeof places / sizeof *places; ++i)
        for (turn = 0; turn < 3; ++turn) {
            shape s = empty_shape();
            sil_mesh_desc desc;
            sil_mesh *mesh;
            const uint32_t a = add_vertex(&s, 0, 0, 0), b = add_vertex(&s, 10, 0, 0), c = add_vertex(&s, 5, 50, 0);
            const uint32_t v[3] = {a, b, c};
            add_face(&s, v[turn], v[(turn + 1) % 3], v[(turn + 2) % 3]);
            add_face(&s, add_vertex(&s, places[i].x, places[i].y, 0), add_vertex(&s, 4, -30, 0),
                     add_vertex(&s, 6, -30, 0));
            desc = desc_of(&s);
            desc.t_junction_distance = 1;
            mesh = mesh_from(&desc);
            assert_int_equal(sil_mesh_get_info(mesh).t_junction_count, places[i].cuts);
            sil_mesh_destroy(mesh);
            shape_free(&s);
        }
}

/* A face with cuts on all its sides, and how many lines remain. */
static void test_cuts_on_all_sides(void **state) {
    const float low[9] = {0, 0, 0, 8, 0, 0, 0, 8, 0};
    int cuts[3], round, side, i;
    (void)state;
    for (round = 1; round < 64; ++round) {
        shape s = empty_shape();
        sil_mesh_desc desc;
        sil_mesh *mesh;
        sil_mesh_info info;
        size_t pieces = 0;
        cuts[0] = round % 4;
        cuts[1] = round / 4 % 4;
        cuts[2] = round / 16;
        for (i = 0; i < 3; ++i)
            add_vertex(&s, (double)low[3 * i], (double)low[3 * i + 1], 0);
        add_face(&s, 0, 1, 2);
        for (side = 0; side < 3; ++side) { /* beyond each side a fan of one face more than there are cuts */
            const float *p = low + 3 * side, *q = low + 3 * ((side + 1) % 3);
            const double x = 0.5 * (double)(p[0] + q[0]), y = 0.5 * (double)(p[1] + q[1]);
            const uint32_t tip = add_vertex(&s,
                                            x + (side == 1   ? 4
                                                 : side == 2 ? -4
                                                             : 0),
                                            y + (side == 1   ? 4
                                                 : side == 0 ? -4
                                                             : 0),
                                            -1);
            uint32_t from = (uint32_t)side, to;
            for (i = 1; i <= cuts[side] + 1; ++i, from = to) {
                const double t = (double)i / (cuts[side] + 1);
                to = i > cuts[side] ? (uint32_t)(side + 1) % 3
                                    : add_vertex(&s, (double)p[0] + t * (double)(q[0] - p[0]),
                                                 (double)p[1] + t * (double)(q[1] - p[1]), 0);
                add_face(&s, to, from, tip);
                ++pieces;
            }
        }
        desc = desc_of(&s);
        desc.crease_degrees = 5;
        desc.t_junction_distance = 1e-4f;
        mesh = mesh_from(&desc);
        info = sil_mesh_get_info(mesh);
        assert_int_equal(info.boundary_edge_count, 6);
        assert_int_equal(info.t_junction_count, cuts[0] + cuts[1] + cuts[2]);
        assert_int_equal(info.nonmanifold_edge_count + info.flipped_edge_count, 0);
        assert_int_equal(info.face_count, 1 + pieces);
        assert_int_equal(sil_extract(mesh, NULL, NULL, SIL_CREASE, NULL, 0), pieces);
        sil_mesh_destroy(mesh);
        shape_free(&s);
    }
}

/* ---- slivers ---- */

/* Companions of faces that are flat but for rounding draw no line within the distance, and their own without one. */
static void test_thin_companions(void **state) {
    shape s = make_sheet(3, 3);
    const sil_view below = view_at(0.1, 0.2, -1, 0);
    sil_mesh_desc desc;
    sil_mesh *mesh;
    int step;
    const uint32_t *f = s.indices + 3 * 8, p = f[0], q = f[1];
    const float *a = s.positions + 3 * (size_t)p, *b = s.positions + 3 * (size_t)q;
    const double x = 0.5 * (double)(a[0] + b[0]), y = 0.5 * (double)(a[1] + b[1]);
    (void)state;
    add_face(&s, p, add_vertex(&s, x, y, 0.001), q);
    desc = desc_of(&s);
    for (step = 0; step < 3; ++step) {
        static const float distances[3] = {0, 0.0009f, 0.0011f};
        desc.t_junction_distance = distances[step];
        mesh = mesh_from(&desc);
        assert_int_equal(sil_mesh_get_info(mesh).degenerate_face_count, step == 2);
        assert_int_equal(sil_mesh_get_info(mesh).nonmanifold_edge_count, step < 2);
        assert_int_equal(sil_mesh_get_info(mesh).boundary_edge_count, step < 2 ? 14 : 12);
        assert_int_equal(sil_extract(mesh, NULL, &below, SIL_SILHOUETTE, NULL, 0), step < 2);
        sil_mesh_destroy(mesh);
    }
    shape_free(&s);
}

/* A crack filled by a sliver that is not quite flat: the sliver takes the sign of the face across its longest side. */
static void test_slivers_that_fill(void **state) {
    const float positions[18] = {0, 0, 0, 2, 0, 0, 1, 2, 0, 1, -1e-5f, 1e-5f, 0, -2, -1, 2, -2, -1};
    const uint32_t indices[15] = {0, 1, 2, /* the sliver: */ 0, 3, 1, /* below: */ 0, 4, 3, 3, 4, 5, 3, 5, 1};
    const sil_view along = view_at(0, 1e-9, 1, 0), beyond = view_at(0, -1, 0.1, 0);
    sil_mesh_desc desc;
    sil_mesh *mesh;
    (void)state;
    memset(&desc, 0, sizeof desc);
    desc.positions = positions;
    desc.vertex_count = 6;
    desc.indices = indices;
    desc.index_count = 15;
    desc.crease_degrees = 10;
    mesh = mesh_from(&desc);
    assert_int_equal(sil_extract(mesh, NULL, NULL, SIL_CREASE, NULL, 0), 3); /* all around the sliver */
    sil_mesh_destroy(mesh);
    desc.t_junction_distance = 1e-4f;
    mesh = mesh_from(&desc);
    assert_int_equal(sil_mesh_get_info(mesh).degenerate_face_count, 1);
    assert_int_equal(sil_extract(mesh, NULL, &along, SIL_CREASE, NULL, 0), 2); /* only where it meets those below */
    assert_int_equal(sil_extract(mesh, NULL, &beyond, SIL_SILHOUETTE, NULL, 0), 0);
    sil_mesh_destroy(mesh);
}

/* ---- windings ---- */

static int compare_ends(const void *a, const void *b) {
    const sil_edge *x = (const sil_edge *)a, *y = (const sil_edge *)b;
    if (x->a != y->a)
        return x->a < y->a ? -1 : 1;
    return x->b < y->b ? -1 : x->b > y->b;
}

/* Random faces turned: with SIL_MESH_ORIENT the lines are those of the clean mesh, directions included. */
static void check_oriented(const shape *clean, unsigned seed) {
    shape dirty = empty_shape();
    sil_mesh_desc desc;
    sil_mesh *truth = mesh_of(clean), *mesh;
    size_t i, turned = 0;
    int round;
    add_shape(&dirty, clean, 1, 0, 0, 0);
    for (i = 0; i < dirty.index_count / 3; ++i)
        if (seed > 9 || random_below(10) < seed) {
            turn_face(&dirty, i);
            ++turned;
        }
    desc = desc_of(&dirty);
    desc.flags = SIL_MESH_ORIENT;
    mesh = mesh_from(&desc);
    assert_int_equal(sil_mesh_get_info(mesh).flipped_edge_count, 0);
    assert_int_equal(sil_mesh_get_info(mesh).reversed_face_count, turned);
    for (round = 0; round < 60; ++round) {
        const sil_view view = random_view(round);
        size_t count, again;
        sil_edge *a = extract_all(truth, NULL, &view, 79, &count), *b = extract_all(mesh, NULL, &view, 79, &again);
        assert_int_equal(count, again);
        qsort(a, count, sizeof *a, compare_ends); /* edges are numbered by the faces as they came */
        qsort(b, count, sizeof *b, compare_ends);
        for (i = 0; i < count; ++i) {
            assert_int_equal(compare_ends(&a[i], &b[i]), 0);
            assert_int_equal(a[i].kinds, b[i].kinds);
            assert_int_equal(a[i].face[0], b[i].face[0]);
            assert_int_equal(a[i].face[1], b[i].face[1]);
        }
        free(a);
        free(b);
    }
    sil_mesh_destroy(truth);
    sil_mesh_destroy(mesh);
    shape_free(&dirty);
}

static void test_orient(void **state) {
    shape torus = make_torus(12, 8, 0.05, 0), box = make_box(3, 3, 3), sheet = make_sheet(4, 4), nest = empty_shape();
    unsigned seed;
    (void)state;
    for (seed = 1; seed <= 10; seed += 3) { /* 10: all of them */
        check_oriented(&torus, seed);
        check_oriented(&box, seed);
    }
    for (seed = 0; seed < 12; ++seed)
        check_oriented(&sheet, 3); /* of an open one what most of it was */
    /* Two shells with a solid in the middle: out, in, out, in, out. */
    for (seed = 0; seed < 5; ++seed) {
        const size_t first = nest.index_count / 3;
        size_t i;
        add_shape(&nest, &box, 10 - 2 * seed, seed * 3.0, seed * 3.0, seed * 3.0);
        for (i = first; i < nest.index_count / 3 && seed % 2; ++i)
            turn_face(&nest, i);
    }
    add_shape(&nest, &torus, 1, -50, 0, 0);
    for (seed = 1; seed <= 10; seed += 3)
        check_oriented(&nest, seed);
    shape_free(&torus);
    shape_free(&box);
    shape_free(&sheet);
    shape_free(&nest);
}

/* A Moebius strip has no consistent winding: one seam is left, the same for every order of the faces. */
static void test_orient_moebius(void **state) {
    shape strip = empty_shape(), other;
    uint32_t order[128];
    sil_mesh_desc desc;
    sil_mesh *mesh, *again;
    uint32_t i;
    int round;
    (void)state;
    for (i = 0; i < 24; ++i) {
        const double angle = 2 * SHAPES_PI * i / 24, x = cos(angle), y = sin(angle);
        const double out = 0.3 * cos(angle / 2), up = 0.3 * sin(angle / 2);
        add_vertex(&strip, x * (1 + out), y * (1 + out), up);
        add_vertex(&strip, x * (1 - out), y * (1 - out), -up);
    }
    for (i = 0; i < 24; ++i) {
        const uint32_t a = 2 * i, b = 2 * i + 1, c = i < 23 ? a + 2 : 1, d = i < 23 ? a + 3 : 0;
        add_face(&strip, a, b, c);
        add_face(&strip, b, d, c);
    }
    desc = desc_of(&strip);
    desc.flags = SIL_MESH_ORIENT;
    mesh = mesh_from(&desc);
    assert_int_equal(sil_mesh_get_info(mesh).boundary_edge_count, 48);
    assert_int_equal(sil_mesh_get_info(mesh).flipped_edge_count, 1);
    for (round = 0; round < 20; ++round) {
        const sil_view view = random_view(round);
        size_t count, same, k;
        sil_edge *a, *b;
        other = shuffled(&strip, order);
        desc.indices = other.indices;
        again = mesh_from(&desc);
        a = extract_all(mesh, NULL, &view, 79, &count);
        b = extract_all(again, NULL, &view, 79, &same);
        assert_int_equal(count, same);
        for (k = 0; k < count; ++k) {
            b[k].face[0] = order[b[k].face[0]];
            b[k].face[1] = b[k].face[1] == SIL_NONE ? SIL_NONE : order[b[k].face[1]];
        }
        check_same_edges(a, b, count);
        free(a);
        free(b);
        sil_mesh_destroy(again);
        shape_free(&other);
    }
    sil_mesh_destroy(mesh);
    shape_free(&strip);
}

/* ---- parts ---- */

/* A box whose upper half is another part, and its top a third. */
static void test_part_borders(void **state) {
    shape box = make_box(4, 4, 4);
    const size_t faces = box.index_count / 3;
    uint32_t *parts = (uint32_t *)grown(NULL, faces, sizeof *parts);
    sil_mesh_desc desc = desc_of(&box);
    sil_mesh *mesh;
    sil_pose *pose;
    sil_view view;
    size_t i, k, count;
    sil_edge *edges;
    (void)state;
    for (i = 0; i < faces; ++i) {
        double z = 0;
        for (k = 0; k < 3; ++k)
            z += (double)box.positions[3 * (size_t)box.indices[3 * i + k] + 2] / 3;
        parts[i] = z > 3.99 ? 0xffffffffu : z > 2 ? 7 : 0;
    }
    mesh = mesh_from(&desc);
    assert_int_equal(sil_extract(mesh, NULL, NULL, SIL_PART_BORDER, NULL, 0), 0);
    sil_mesh_destroy(mesh);
    desc.face_parts = parts;
    desc.flags = SIL_MESH_HIERARCHY;
    mesh = mesh_from(&desc);
    pose = pose_of(mesh);
    assert_int_equal(sil_mesh_get_info(mesh).part_border_edge_count, 32);
    edges = extract_all(mesh, NULL, NULL, SIL_PART_BORDER, &count);
    assert_int_equal(count, 32);
    for (i = 0; i < count; ++i) {
        const double z = (double)box.positions[3 * (size_t)edges[i].a + 2];
        assert_true((z > 3.5 && edges[i].kinds == (SIL_PART_BORDER | SIL_CREASE | SIL_CONVEX)) ||
                    (fabs(z - 2) < 0.1 && (edges[i].kinds & ~48u) == SIL_PART_BORDER));
        assert_true(parts[edges[i].face[0]] != parts[edges[i].face[1]]);
    }
    free(edges);
    /* Two sides and the top are in front: 8 edges around the middle, 8 of the top; its other 8 are silhouettes. */
    view = view_at(1, 1.1, 1.2, 0);
    for (k = 0; k < 2; ++k) {
        edges = extract_all(mesh, k ? pose : NULL, &view, SIL_PART_BORDER, &count);
        assert_int_equal(count, 16);
        free(edges);
    }
    edges = extract_all(mesh, pose, &view, SIL_PART_BORDER | SIL_SILHOUETTE, &count);
    assert_int_equal(count, 16 + 24);
    { /* both make strips, each kind its own */
        sil_strip strips[64];
        uint32_t vertices[256];
        size_t needed, n = sil_chain(mesh, pose, edges, count, strips, 64, vertices, 256, &needed), loops = 0;
        for (i = 0; i < n; ++i)
            loops += strips[i].closed && strips[i].kinds == SIL_SILHOUETTE && strips[i].count == 25;
        assert_int_equal(loops, 1);
        assert_int_equal(n, 3);
    }
    free(edges);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    free(parts);
    shape_free(&box);
}

/* Where three parts meet at a wall the edge has many faces, and is a border of parts in every view. */
static void test_part_borders_of_many(void **state) {
    const float positions[15] = {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, -1, 0, 0};
    const uint32_t indices[9] = {0, 1, 2, 0, 1, 3, 0, 1, 4}, same[3] = {5, 5, 5}, one_other[3] = {5, 5, 6};
    const sil_view view = view_at(1, -1, 0, 0);
    sil_mesh_desc desc;
    int round;
    (void)state;
    memset(&desc, 0, sizeof desc);
    desc.positions = positions;
    desc.vertex_count = 5;
    desc.indices = indices;
    desc.index_count = 9;
    for (round = 0; round < 2; ++round) {
        sil_mesh *mesh;
        sil_edge edge;
        desc.face_parts = round ? one_other : same;
        mesh = mesh_from(&desc);
        assert_int_equal(sil_extract(mesh, NULL, NULL, SIL_PART_BORDER, NULL, 0), round);
        assert_int_equal(sil_extract(mesh, NULL, &view, SIL_PART_BORDER, NULL, 0), round);
        assert_int_equal(sil_extract(mesh, NULL, &view, SIL_NONMANIFOLD, &edge, 1), 1);
        assert_int_equal((edge.kinds & SIL_PART_BORDER) != 0, round);
        sil_mesh_destroy(mesh);
    }
}

/* ---- every kind alone ---- */

/* What is found for a mask is what is found for all kinds and has one of the mask; in a view a crease is in front. */
static void test_kinds_alone(void **state) {
    shape s = make_torus(9, 6, 0.1, 0);
    uint32_t parts[200];
    unsigned kinds;
    size_t i;
    int round;
    sil_mesh_desc desc;
    sil_mesh *mesh;
    sil_pose *pose;
    (void)state;
    add_face(&s, s.indices[0], s.indices[1], 30);
    add_face(&s, s.indices[60], s.indices[61], 12);
    for (i = 0; i < 200; ++i)
        parts[i] = (uint32_t)i / 30;
    desc = desc_of(&s);
    desc.face_parts = parts;
    desc.flags = SIL_MESH_HIERARCHY;
    mesh = mesh_from(&desc);
    pose = pose_of(mesh);
    for (round = 0; round < 40; ++round) {
        const sil_view view = random_view(round);
        size_t all, count, k;
        sil_edge *every = extract_all(mesh, NULL, round ? &view : NULL, 79, &all), *edges;
        unsigned seen = 0;
        for (kinds = 0; kinds < 80; ++kinds) {
            if (kinds & 48)
                continue;
            edges = extract_all(mesh, round % 2 ? pose : NULL, round ? &view : NULL, kinds, &count);
            for (i = 0, k = 0; i < all; ++i)
                if (every[i].kinds & kinds) {
                    assert_true(k < count);
                    check_same_edges(&every[i], &edges[k++], 1);
                }
            assert_int_equal(k, count);
            free(edges);
        }
        for (i = 0; i < all; ++i) {
            seen |= every[i].kinds;
            if (round && every[i].kinds & (SIL_CREASE | SIL_PART_BORDER) && !(every[i].kinds & SIL_NONMANIFOLD))
                for (k = 0; k < 2; ++k) {
                    const uint32_t *f = s.indices + 3 * (size_t)every[i].face[k];
                    const float *p = s.positions;
                    double u[3], v[3], e[3], det = 0;
                    int c;
                    for (c = 0; c < 3; ++c) {
                        u[c] = (double)p[3 * f[1] + (uint32_t)c] - (double)p[3 * f[0] + (uint32_t)c];
                        v[c] = (double)p[3 * f[2] + (uint32_t)c] - (double)p[3 * f[0] + (uint32_t)c];
                        e[c] = view.eye[c] - view.eye[3] * (double)p[3 * f[0] + (uint32_t)c];
                    }
                    for (c = 0; c < 3; ++c)
                        det += (u[(c + 1) % 3] * v[(c + 2) % 3] - u[(c + 2) % 3] * v[(c + 1) % 3]) * e[c];
                    assert_true(det > -1e-9);
                }
        }
        assert_int_equal(seen & 79, round ? 79 : 78);
        free(every);
    }
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    shape_free(&s);
}

/* ---- nothing depends on the order ---- */

/* Soups in which nearly every edge has many faces, coincident and thin ones among them, with all options: faces in
   another order, each from another corner, give the same lines. The sign of an edge of many is by its faces here. */
static void test_soup_in_any_order(void **state) {
    int round, i;
    size_t many = 0;
    (void)state;
    for (round = 0; round < 300; ++round) {
        shape s = empty_shape(), other;
        uint32_t order[64], parts[64], parts_again[64];
        sil_mesh_desc desc;
        sil_mesh *a, *b;
        const sil_view view = random_view(round);
        size_t count, same, k;
        sil_edge *first, *second;
        for (i = 0; i < 9; ++i)
            add_vertex(&s, random_below(4), random_below(4), random_below(3) + (i % 4 ? 0 : random_in(0, 1e-3)));
        for (i = 0; i < 30; ++i) {
            const uint32_t p = random_below(9);
            add_face(&s, p, (p + 1 + random_below(8)) % 9, random_below(9));
            parts[i] = random_below(3);
        }
        other = shuffled(&s, order);
        desc = desc_of(&s);
        desc.flags = round % 3 ? SIL_MESH_ORIENT : 0;
        desc.t_junction_distance = round % 4 ? 2e-3f : 0;
        desc.face_parts = round % 2 ? parts : NULL;
        a = mesh_from(&desc);
        for (i = 0; i < 30; ++i)
            parts_again[i] = parts[order[i]];
        desc.indices = other.indices;
        desc.face_parts = round % 2 ? parts_again : NULL;
        b = mesh_from(&desc);
        many += sil_mesh_get_info(a).nonmanifold_edge_count;
        first = extract_all(a, NULL, &view, 79, &count);
        second = extract_all(b, NULL, &view, 79, &same);
        if (!sil_mesh_get_info(a).duplicate_face_count) { /* of duplicates the first in the caller's order is kept */
            assert_int_equal(count, same);
            for (k = 0; k < count; ++k) {
                second[k].face[0] = order[second[k].face[0]];
                second[k].face[1] = second[k].face[1] == SIL_NONE ? SIL_NONE : order[second[k].face[1]];
            }
            check_same_edges(first, second, count);
        } else if (!(round % 2)) {
            assert_int_equal(count, same);
            for (k = 0; k < count; ++k) {
                assert_int_equal(first[k].edge, second[k].edge);
                assert_int_equal(first[k].kinds, second[k].kinds);
            }
        }
        free(first);
        free(second);
        sil_mesh_destroy(a);
        sil_mesh_destroy(b);
        shape_free(&s);
        shape_free(&other);
    }
    assert_true(many > 1000);
}

static void test_bad_options(void **state) {
    shape s = make_sheet(1, 1);
    sil_mesh_desc desc = desc_of(&s);
    sil_result result;
    const float bad[3] = {-1, NAN, INFINITY};
    int i;
    (void)state;
    for (i = 0; i < 3; ++i) {
        desc.t_junction_distance = bad[i];
        assert_null(sil_mesh_create(&desc, &result));
        assert_int_equal(result, SIL_INVALID_ARGUMENT);
    }
    shape_free(&s);
}

/* Memory that runs out at any point, with all options: an error, and nothing lost (the sanitizers look). */
typedef struct budget {
    size_t left, live, bytes;
} budget;

static void *budget_alloc(size_t size, void *user) {
    budget *b = (budget *)user;
    size_t *memory;
    if (!b->left)
        return NULL;
    --b->left;
    memory = (size_t *)malloc(size + 16);
    assert_non_null(memory);
    memory[0] = size;
    ++b->live;
    b->bytes += size;
    return memory + 2;
}

static void budget_free(void *memory, void *user) {
    budget *b = (budget *)user;
    --b->live;
    b->bytes -= ((size_t *)memory - 2)[0];
    free((size_t *)memory - 2);
}

static void test_memory_runs_out(void **state) {
    shape clean = make_torus(6, 4, 0.05, 64), ball = make_ball(1), s = cut_torus(&clean, 3);
    sil_mesh_desc desc;
    sil_mesh *mesh = NULL;
    size_t limit;
    (void)state;
    add_shape(&s, &ball, 0.1, 9, 9, 9);
    desc = desc_of(&s);
    desc.t_junction_distance = 1e-6f;
    desc.flags = SIL_MESH_ORIENT;
    desc.allocator.alloc_fn = budget_alloc;
    desc.allocator.free_fn = budget_free;
    for (limit = 0; !mesh; ++limit) {
        budget b = {0, 0, 0};
        sil_result result;
        b.left = limit;
        desc.allocator.user = &b;
        mesh = sil_mesh_create(&desc, &result);
        assert_true(limit < 1000);
        if (mesh) {
            assert_int_equal(sil_mesh_get_info(mesh).bytes, b.bytes);
            sil_mesh_destroy(mesh);
        } else
            assert_int_equal(result, SIL_OUT_OF_MEMORY);
        assert_int_equal(b.live, 0);
    }
    assert_true(limit > 50);
    shape_free(&s);
    shape_free(&clean);
    shape_free(&ball);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cracks_of_a_torus),    cmocka_unit_test(test_two_sheets),
        cmocka_unit_test(test_crack_distance),       cmocka_unit_test(test_where_cuts_are),
        cmocka_unit_test(test_cuts_on_all_sides),    cmocka_unit_test(test_thin_companions),
        cmocka_unit_test(test_slivers_that_fill),    cmocka_unit_test(test_orient),
        cmocka_unit_test(test_orient_moebius),       cmocka_unit_test(test_part_borders),
        cmocka_unit_test(test_part_borders_of_many), cmocka_unit_test(test_kinds_alone),
        cmocka_unit_test(test_soup_in_any_order),    cmocka_unit_test(test_bad_options),
        cmocka_unit_test(test_memory_runs_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

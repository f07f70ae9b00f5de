/* Every way in which sil_extract finds silhouettes (the hierarchy and the flat scan, by vectors and one by one, with a
   pose and without) against edges told one at a time by exact signs; the vector code against the plain; the tracker
   against differences of sets. unit_extraction_fast.c is the same under -ffast-math. */
#include <fenv.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Counted, since the exact sum has one for each product: that is how tests see when it is used. */
static size_t assertions;
#define SIL_ASSERT(condition) (++assertions, assert_true(condition))
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include "shapes.h"

/* ---- every edge, one at a time ---- */

/* Signs of all faces by nothing but the exact sum. */
static unsigned char *exact_fronts(const sil_mesh *mesh, const sil_view *view) {
    unsigned char *front = (unsigned char *)calloc(mesh->face_count + 1, 1);
    sil_i_eye eye;
    uint32_t f;
    assert_non_null(front);
    sil_i_eye_make(&eye, view, &mesh->rest);
    for (f = 0; f < mesh->face_count && eye.valid; ++f) {
        const uint32_t root = sil_i_sign_face(mesh, f);
        const uint32_t *corner = mesh->corner + 3 * (size_t)root;
        const float *p = mesh->rest.position;
        if (root != SIL_NONE)
            front[f] = sil_i_exact_sign(p + 3 * (size_t)corner[0], p + 3 * (size_t)corner[1], p + 3 * (size_t)corner[2],
                                        &eye) > 0;
    }
    return front;
}

/* Silhouettes are edges with a front and a back face; faces that take no sign are neither where there are three. */
static uint32_t *exact_silhouettes(const sil_mesh *mesh, const sil_view *view, size_t *count) {
    unsigned char *front = exact_fronts(mesh, view);
    uint32_t *found = (uint32_t *)malloc((mesh->edge_count + 1) * sizeof(uint32_t)), e;
    size_t many = 0;
    assert_non_null(found);
    *count = 0;
    for (e = 0; e < mesh->edge_count; ++e) {
        int fronts = front[mesh->edge_face[0][e]], backs = !fronts;
        if (mesh->edge_kinds[e] & SIL_I_MANY) {
            uint32_t i;
            fronts = backs = 0;
            assert_int_equal(mesh->many_edge[many], e);
            for (i = mesh->many_first[many]; i < mesh->many_first[many + 1]; ++i)
                if (sil_i_sign_face(mesh, mesh->many_face[i]) != SIL_NONE) {
                    fronts |= front[mesh->many_face[i]];
                    backs |= !front[mesh->many_face[i]];
                }
            ++many;
        } else {
            fronts |= front[mesh->edge_face[1][e]];
            backs |= !front[mesh->edge_face[1][e]];
        }
        if (fronts && backs)
            found[(*count)++] = e;
    }
    free(front);
    return found;
}

/* Holes, third faces, turned faces and faces without area, here and there. */
static void spoil(shape *s) {
    size_t at;
    for (at = 0; at + 3 <= s->index_count; at += 3 * (1 + (size_t)random_below(30))) {
        uint32_t *face = s->indices + at;
        const uint32_t swap = face[0];
        switch (random_below(4)) {
        case 0:
            face[0] = face[1];
            break;
        case 1:
            face[0] = random_below(s->vertex_count);
            break;
        case 2:
            face[0] = face[1];
            face[1] = swap;
            break;
        default: /* a corner in the middle of the opposite side: on it if that can be represented */
            s->positions[3 * face[2]] = 0.5f * (s->positions[3 * face[0]] + s->positions[3 * face[1]]);
            s->positions[3 * face[2] + 1] = 0.5f * (s->positions[3 * face[0] + 1] + s->positions[3 * face[1] + 1]);
            s->positions[3 * face[2] + 2] = 0.5f * (s->positions[3 * face[0] + 2] + s->positions[3 * face[1] + 2]);
        }
    }
}

/* Hills of triangles, with a face without area along each diagonal: edges of two faces that are numbered by neither. */
static shape hills_with_slivers(void) {
    shape s = make_sheet(16, 16);
    const size_t count = s.index_count;
    size_t i;
    for (i = 0; i < s.vertex_count; ++i)
        s.positions[3 * i + 2] = (float)random_below(6);
    for (i = 0; i < count; i += 6) {
        const uint32_t a = s.indices[i], c = s.indices[i + 2];
        const float *p = s.positions + 3 * (size_t)a, *q = s.positions + 3 * (size_t)c;
        add_face(&s, a,
                 add_vertex(&s, 0.5 * ((double)p[0] + (double)q[0]), 0.5 * ((double)p[1] + (double)q[1]),
                            0.5 * ((double)p[2] + (double)q[2])),
                 c);
    }
    return s;
}

enum { SHAPES = 10 };

static shape shape_number(int number) {
    shape s = number == 3   ? make_box(12, 9, 7)
              : number == 9 ? hills_with_slivers()
              : number == 7 ? make_cylinder(200, 1, 3)
              : number == 8 ? make_ball(5)
                            : make_torus(40, 20, number == 1 || number == 2 ? 0.1 : 0,
                                         number == 2   ? 8
                                         : number == 4 ? 64
                                                       : 0);
    size_t i;
    if (number == 1 || number == 4)
        spoil(&s);
    for (i = 0; i < 3 * s.vertex_count && number == 6; ++i)
        s.positions[i] = (float)((double)s.positions[i] * 1e-3 + 100);
    return s;
}

/* Anywhere inside, near and far, on vertices, on the planes of faces, along axes and in the planes of two of them. */
static sil_view view_number(const shape *s, size_t number) {
    const uint32_t *face = s->indices + 3 * (size_t)random_below(s->index_count / 3);
    sil_view v = view_at(0, 0, 0, number % 3 != 0);
    const double scale = random_in(0, 1) < 0.5 ? 1e3 : 1e9, t[2] = {random_in(-3, 3), floor(random_in(-8, 9))};
    int k;
    for (k = 0; k < 3; ++k) {
        const double a = (double)s->positions[3 * face[0] + (uint32_t)k];
        const double b = (double)s->positions[3 * face[1] + (uint32_t)k];
        const double c = (double)s->positions[3 * face[2] + (uint32_t)k], any = random_in(-2, 2);
        const double eyes[8] = {any,
                                any * scale,
                                a + 1e-3 * any,
                                k == (int)(number / 8 % 3),
                                a,
                                a + t[0] * (b - a) + (1 - t[0]) * (c - a),
                                a + t[1] * (b - a),
                                k == (int)(number / 8 % 3) ? 0 : any};
        v.eye[k] = eyes[number % 8];
    }
    return v;
}

enum { PATHS = 6 };

typedef struct path {
    const char *name;
    int hierarchy, wide, has_pose;
} path;

static const path paths[PATHS] = {{"hierarchy, vectors", 1, 1, 1}, {"hierarchy, plain", 1, 0, 1},
                                  {"flat scan, vectors", 0, 1, 1}, {"flat scan, plain", 0, 0, 1},
                                  {"hierarchy, no pose", 1, 1, 0}, {"flat scan, no pose", 0, 1, 0}};

/* One view by one path: the edges, as sil_extract writes them and only counts them. */
static sil_edge *by_path(const path *p, sil_mesh *const meshes[2], sil_pose *const poses[2], const sil_view *view,
                         unsigned kinds, size_t *count, size_t *looked) {
    sil_mesh *mesh = meshes[p->hierarchy];
    sil_pose *pose = p->has_pose ? poses[p->hierarchy] : NULL;
    const int wide = mesh->wide;
    sil_edge *edges;
    mesh->wide = wide && p->wide;
    edges = extract_all(mesh, pose, view, kinds, count);
    assert_int_equal(sil_extract(mesh, pose, view, kinds, NULL, 0), *count);
    mesh->wide = wide;
    if (pose && !p->hierarchy)
        assert_int_equal(pose->looked, 0);
    if (pose && p->hierarchy)
        *looked += pose->looked;
    return edges;
}

static void check_view(sil_mesh *const meshes[2], sil_pose *const poses[2], const sil_view *view, size_t *lines,
                       size_t *looked) {
    const unsigned all = SIL_SILHOUETTE | SIL_BOUNDARY | SIL_CREASE | SIL_NONMANIFOLD;
    size_t truth_count, mixed_count = 0, i;
    uint32_t *truth = exact_silhouettes(meshes[0], view, &truth_count);
    sil_edge *mixed = NULL, *first = NULL;
    int p;
    for (p = 0; p < PATHS; ++p) {
        size_t count, also_count;
        sil_edge *edges = by_path(&paths[p], meshes, poses, view, SIL_SILHOUETTE, &count, looked);
        sil_edge *also = by_path(&paths[p], meshes, poses, view, all, &also_count, looked);
        if (count != truth_count)
            fail_msg("%s: %zu silhouettes, %zu by exact signs", paths[p].name, count, truth_count);
        for (i = 0; i < count; ++i)
            if (edges[i].edge != truth[i] || !(edges[i].kinds & SIL_SILHOUETTE))
                fail_msg("%s: edge %u in place of %u", paths[p].name, (unsigned)edges[i].edge, (unsigned)truth[i]);
        if (first) { /* ends, faces and kinds, and other kinds of lines, are those of the first path */
            assert_memory_equal(edges, first, count * sizeof *edges);
            assert_int_equal(also_count, mixed_count);
            assert_memory_equal(also, mixed, also_count * sizeof *also);
            free(edges);
            free(also);
        } else {
            first = edges;
            mixed = also;
            mixed_count = also_count;
        }
    }
    *lines += truth_count;
    free(truth);
    free(first);
    free(mixed);
}

static void test_every_path_finds_the_exact_edges(void **state) {
    size_t lines = 0, looked = 0, lone = 0, loose = 0, views = 0;
    int which;
    (void)state;
    for (which = 0; which < SHAPES; ++which) {
        shape s = shape_number(which);
        sil_mesh_desc desc = desc_of(&s);
        sil_mesh *meshes[2];
        sil_pose *poses[2];
        size_t number, i;
        desc.weld_distance = which == 5 ? -1.0f : 0;
        for (i = 0; i < 2; ++i) {
            desc.flags = i ? SIL_MESH_HIERARCHY : SIL_MESH_NO_HIERARCHY;
            meshes[i] = mesh_from(&desc);
            poses[i] = pose_of(meshes[i]);
        }
        lone += meshes[1]->patches->lone_count - meshes[1]->many_count;
        for (i = 0; i < meshes[1]->face_count; ++i)
            loose += !(fabsf(meshes[1]->rest.plane[0][i]) + fabsf(meshes[1]->rest.plane[1][i]) +
                           fabsf(meshes[1]->rest.plane[2][i]) >
                       0);
        for (number = 0; number < (which == 8 ? 24 : 120); ++number, ++views) {
            const sil_view view = view_number(&s, number);
            check_view(meshes, poses, &view, &lines, &looked);
        }
        for (i = 0; i < 2; ++i) {
            sil_pose_destroy(poses[i]);
            sil_mesh_destroy(meshes[i]);
        }
        shape_free(&s);
    }
    print_message(
        "%zu views, %zu silhouettes by each of %d ways, %zu patches looked at; %zu edges numbered by slivers, "
        "%zu faces without plane\n",
        views, lines, PATHS, looked, lone, loose);
    assert_true(lines > 50000 && looked > 10000 && lone > 0 && loose > 0);
}

/* Silhouettes are few among many edges: the hierarchy must look at few patches, and at none where all is flat. */
static void test_the_hierarchy_leaves_out(void **state) {
    shape ball = make_ball(5), box = make_box(24, 24, 24);
    sil_mesh_desc desc = desc_of(&ball);
    const sil_view near_by = view_at(2, 1, 0.5, 1), along = view_at(1, 0, 0, 0);
    sil_mesh *mesh;
    sil_pose *pose;
    (void)state;
    desc.flags = SIL_MESH_HIERARCHY;
    mesh = mesh_from(&desc);
    pose = pose_of(mesh);
    assert_true(sil_extract(mesh, pose, &near_by, SIL_SILHOUETTE, NULL, 0) > 100);
    assert_in_range(pose->looked, 1, mesh->patches->count / 3);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    desc = desc_of(&box);
    desc.flags = SIL_MESH_HIERARCHY;
    mesh = mesh_from(&desc);
    pose = pose_of(mesh);
    assert_int_equal(sil_extract(mesh, pose, &along, SIL_SILHOUETTE, NULL, 0), 96); /* two thirds are edge-on */
    assert_in_range(pose->looked, 1, mesh->patches->count / 2);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    shape_free(&ball);
    shape_free(&box);
}

/* Nine by nine quads with corners at multiples of `step`: patches, but not eight. Flat, or with bumps. */
static sil_mesh *small_sheet(double step, double z, double bump) {
    shape s = make_sheet(9, 9);
    sil_mesh_desc desc;
    sil_mesh *mesh;
    size_t i;
    for (i = 0; i < s.vertex_count; ++i) {
        s.positions[3 * i] = (float)((double)(i % 10) * step);
        s.positions[3 * i + 1] = (float)((double)(i / 10) * step);
        s.positions[3 * i + 2] = (float)(z + bump * (double)(i * i % 7));
    }
    desc = desc_of(&s);
    desc.flags = SIL_MESH_HIERARCHY;
    mesh = mesh_from(&desc);
    assert_in_range(mesh->patches->count % SIL_I_LANES, 1, SIL_I_LANES - 1);
    shape_free(&s);
    return mesh;
}

/* In the coordinates of planes an eye at 1e38 beside a mesh of 1e-29 has nothing left but rounding: all is undecided,
   and boxes of nothing, which fill groups of eight up, must not be taken for patches (memory checkers notice). */
static void test_an_eye_that_planes_cannot_tell(void **state) {
    sil_mesh *mesh = small_sheet(1e-30, (double)1e38f, 0);
    sil_pose *pose = pose_of(mesh);
    const sil_view view = view_at(0, 0, (double)1e38f, 1), before = view_at(0, 0, 2 * (double)1e38f, 1);
    (void)state;
    for (mesh->wide = sil_i_has_wide(); mesh->wide >= 0; --mesh->wide) {
        assert_int_equal(sil_extract(mesh, pose, &view, SIL_SILHOUETTE, NULL, 0), 0);
        assert_in_range(pose->looked, 1, mesh->patches->count);
        assert_int_equal(sil_extract(mesh, pose, &before, SIL_SILHOUETTE, NULL, 0), 0);
    }
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
}

/* Programs may trap floating-point exceptions. Compilers other than gcc, and -ffast-math, make no promise. */
static void test_no_exceptions_are_raised(void **state) {
#if defined(__GNUC__) && !defined(__clang__) && !defined(__FAST_MATH__) && defined(FE_INVALID)
    sil_mesh *mesh = small_sheet(1, 0, 0.1);
    const sil_view view = view_at(3, 20, 0.5, 1);
    (void)state;
    feclearexcept(FE_ALL_EXCEPT);
    for (mesh->wide = sil_i_has_wide(); mesh->wide >= 0; --mesh->wide)
        assert_true(sil_extract(mesh, NULL, &view, SIL_SILHOUETTE, NULL, 0) > 0);
    assert_int_equal(fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW), 0);
    sil_mesh_destroy(mesh);
#else
    (void)state;
#endif
}

/* ---- faces that are plainly edge-on ---- */

static size_t exact_products(const sil_mesh *mesh, const sil_view *view) {
    const size_t before = assertions;
    (void)sil_extract(mesh, NULL, view, SIL_SILHOUETTE, NULL, 0);
    return assertions - before;
}

/* Views along the sides of a box: its faces are told by comparing coordinates, not by the exact sum. */
static void test_edge_on_faces_need_no_exact_sum(void **state) {
    const double corner[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    shape box = make_box(6, 6, 6), tip = empty_shape();
    sil_mesh_desc desc = desc_of(&box);
    sil_mesh *mesh;
    const sil_view views[5] = {view_at(0, 0, 1, 0), view_at(0, -1, 0, 0), view_at(6, 2.5, 9, 1), view_at(0, 0, 20, 1),
                               view_at(2.25, 6, 6, 1)};
    const sil_view oblique = view_at(2, 0, -1, 1); /* in the plane x + y + z = 1 */
    size_t i;
    (void)state;
    desc.flags = SIL_MESH_NO_HIERARCHY;
    mesh = mesh_from(&desc);
    for (i = 0; i < 5; ++i)
        assert_int_equal(exact_products(mesh, &views[i]), 0);
    sil_mesh_destroy(mesh);
    for (i = 0; i < 4; ++i)
        add_vertex(&tip, corner[3 * i], corner[3 * i + 1], corner[3 * i + 2]);
    add_face(&tip, 1, 2, 3);
    mesh = mesh_of(&tip);
    assert_true(exact_products(mesh, &oblique) > 0); /* they would be noticed */
    sil_mesh_destroy(mesh);
    shape_free(&box);
    shape_free(&tip);
}

/* For directions along axes the flags of a face are enough: neither corners nor planes are fetched. So they are changed
   behind its back, to ones that would be in front. */
static void test_flags_tell_edge_on_faces(void **state) {
    shape box = make_box(4, 4, 4);
    sil_mesh *mesh = mesh_of(&box);
    const sil_view along = view_at(0, 0, 1, 0);
    sil_i_signs signs;
    size_t f, edge_on = 0;
    int k;
    (void)state;
    memset(&signs, 0, sizeof signs);
    signs.mesh = mesh;
    signs.shape = &mesh->rest;
    sil_i_eye_make(&signs.eye, &along, &mesh->rest);
    for (f = 0; f < mesh->unique_count; ++f)
        for (k = 0; k < 2; ++k) {
            float *x = &mesh->rest.position[3 * f + (size_t)k];
            *x = 2 + (*x - 2) * (1 - 0.1f * mesh->rest.position[3 * f + 2]);
        }
    for (f = 0; f < mesh->face_count; ++f) {
        const unsigned char flags = mesh->face_flags[f];
        const sil_i_mask which = {(uint64_t)1 << f % SIL_I_PATCH, 0};
        sil_i_mask front = {0, 0};
        (void)sil_i_face_plane(mesh, &mesh->rest, f);
        if (mesh->rest.plane[2][f] < 0.01f || mesh->rest.plane[2][f] > 0.99f)
            continue;
        assert_int_equal(sil_i_front_unsure(mesh, &mesh->rest, &signs.eye, (uint32_t)f), 0);
        sil_i_gather_signs(&signs, f / SIL_I_PATCH, which, front);
        assert_true(front[0] == 0);
        mesh->face_flags[f] = 0;
        assert_int_equal(sil_i_front_unsure(mesh, &mesh->rest, &signs.eye, (uint32_t)f), 1);
        mesh->face_flags[f] = flags;
        ++edge_on;
    }
    assert_int_equal(edge_on, 4 * 32);
    sil_mesh_destroy(mesh);
    shape_free(&box);
}

/* ---- vectors ---- */

static int16_t random_step(void) {
    return (int16_t)((int)random_below(65535) - 32767);
}

/* The same bits from the same numbers, extremes included. */
static void test_vectors_give_the_bits_of_plain_code(void **state) {
#ifdef SIL_I_WIDE
    size_t round, i, doubts = 0;
    (void)state;
    if (!sil_i_has_wide())
        skip();
    for (round = 0; round < 3000; ++round) {
        const size_t places = 32 + 8 * (size_t)random_below(13), edges = 1 + random_below(64);
        int16_t plane[4 * 160];
        unsigned char side[128];
        int32_t eye[4];
        sil_i_mask front[2], unsure[2];
        uint64_t differ[2], second[2], all = edges < 64 ? ((uint64_t)1 << edges) - 1 : ~(uint64_t)0;
        for (i = 0; i < 4 * 160; ++i)
            plane[i] = round % 5 == 0 ? (int16_t)(random_below(2) ? 32767 : -32767) : random_step();
        for (i = 0; i < 128; ++i)
            side[i] = (unsigned char)random_below(places);
        for (i = 0; i < 2; ++i)
            eye[i] = (int32_t)((uint32_t)((int)random_below(32767) - 16383) << 16 |
                               ((uint32_t)((int)random_below(32767) - 16383) & 0xffffu));
        eye[3] = (int32_t)random_bits() / (round % 2 ? 1 : 64);
        eye[2] = (int32_t)(eye[3] < 0 ? eye[3] + (int32_t)random_below(1 << 28) : eye[3]);
        if (round % 7 == 0)
            eye[2] = 2147483520;
        sil_i_patch_signs_plain(plane, places, eye, front[0], unsure[0]);
        sil_i_patch_signs_wide(plane, places, eye, front[1], unsure[1]);
        assert_memory_equal(front[0], front[1], sizeof front[0]);
        assert_memory_equal(unsure[0], unsure[1], sizeof unsure[0]);
        doubts += (unsure[0][0] | unsure[0][1]) != 0;
        differ[0] = sil_i_patch_edges_plain(side, edges, front[0], &second[0]);
        differ[1] = sil_i_patch_edges_wide(side, edges, front[0], &second[1]);
        assert_true(differ[0] == differ[1] && (second[0] & all) == (second[1] & all));
    }
    assert_in_range(doubts, 100, 2900);
#else
    (void)state;
    skip();
#endif
}

/* ---- the tracker ---- */

static void track_and_compare(const sil_mesh *mesh, sil_pose *pose, sil_pose *other, const sil_view *view,
                              unsigned kinds, unsigned char *in, size_t *moved) {
    const size_t room = mesh->edge_count;
    sil_edge *edges = (sil_edge *)malloc((room + 1) * sizeof *edges), *expected;
    uint32_t *memory = (uint32_t *)malloc((2 * room + 1) * sizeof *memory);
    sil_changes changes;
    size_t count, expected_count, i, entered = 0, left = 0, e;
    assert_non_null(edges);
    assert_non_null(memory);
    memset(&changes, 0, sizeof changes);
    changes.entered = memory;
    changes.left = memory + room;
    changes.capacity = room;
    expected = extract_all(mesh, other, view, kinds, &expected_count);
    if (expected_count) { /* too little room: counts only, and the next call tells the changes */
        assert_int_equal(sil_track(mesh, pose, view, kinds, edges, expected_count - 1, &changes), expected_count);
        assert_int_equal(changes.entered_count + changes.left_count, 0);
    }
    count = sil_track(mesh, pose, view, kinds, edges, room, &changes);
    assert_int_equal(count, expected_count);
    assert_memory_equal(edges, expected, count * sizeof *edges);
    for (e = 0, i = 0; e < room; ++e) {
        const int now = i < count && edges[i].edge == e;
        if (now && !in[e])
            assert_int_equal(changes.entered[entered++], e);
        if (!now && in[e])
            assert_int_equal(changes.left[left++], e);
        in[e] = (unsigned char)now;
        i += (size_t)now;
    }
    assert_int_equal(changes.entered_count, entered);
    assert_int_equal(changes.left_count, left);
    *moved += entered + left;
    free(edges);
    free(expected);
    free(memory);
}

static void test_tracker(void **state) {
    static const double steps[4] = {0.05, 0.3, 1, 3};
    size_t moved = 0, frame;
    int which;
    (void)state;
    for (which = 0; which < 3; ++which) {
        shape s = shape_number(which == 2 ? 4 : which);
        sil_mesh_desc desc = desc_of(&s);
        sil_mesh *mesh;
        sil_pose *pose, *other;
        unsigned char *in;
        desc.flags = which ? SIL_MESH_NO_HIERARCHY : SIL_MESH_HIERARCHY;
        mesh = mesh_from(&desc);
        pose = pose_of(mesh);
        other = pose_of(mesh);
        in = (unsigned char *)calloc(mesh->edge_count, 1);
        assert_non_null(in);
        for (frame = 0; frame < 80; ++frame) {
            const double turn = steps[frame / 20] * SHAPES_PI / 180 * (double)(frame % 20);
            const sil_view view = view_at(3 * cos(turn), 3 * sin(turn), 1, frame % 7 != 3);
            if (frame == 50) {
                assert_int_equal(sil_pose_set(pose, s.positions, 0), SIL_OK);
                assert_int_equal(sil_pose_set(other, s.positions, 0), SIL_OK);
            }
            track_and_compare(mesh, pose, other, frame % 11 == 10 ? NULL : &view, frame % 5 == 4 ? 15 : 1, in, &moved);
        }
        free(in);
        sil_pose_destroy(pose);
        sil_pose_destroy(other);
        sil_mesh_destroy(mesh);
        shape_free(&s);
    }
    assert_true(moved > 1000);
}

typedef struct pool {
    size_t left, live, taken;
} pool;

static void *pool_alloc(size_t size, void *user) {
    pool *p = (pool *)user;
    if (!p->left)
        return NULL;
    --p->left;
    ++p->live;
    ++p->taken;
    return malloc(size);
}

static void pool_free(void *memory, void *user) {
    --((pool *)user)->live;
    free(memory);
}

static void test_tracker_memory_and_misuse(void **state) {
    shape s = shape_number(0);
    sil_mesh_desc desc = desc_of(&s);
    const sil_view near_by = view_at(1.5, 1, 0.5, 1), far_off = view_at(30, 20, 10, 1);
    pool p = {1000, 0, 0};
    sil_mesh *mesh;
    sil_pose *pose;
    sil_changes changes;
    sil_edge *edges = (sil_edge *)calloc(5000, sizeof *edges);
    size_t count, taken, i;
    (void)state;
    assert_non_null(edges);
    memset(&changes, 0, sizeof changes);
    desc.allocator.alloc_fn = pool_alloc;
    desc.allocator.free_fn = pool_free;
    desc.allocator.user = &p;
    mesh = mesh_from(&desc);
    pose = pose_of(mesh);
    p.left = 0; /* no memory: nothing changed, said */
    assert_int_equal(sil_track(mesh, pose, &near_by, 1, edges, 5000, &changes), 0);
    assert_true(changes.entered_count == SIZE_MAX && changes.left_count == SIZE_MAX);
    p.left = 1000;
    count = sil_track(mesh, pose, &near_by, 1, edges, 5000, &changes); /* without arrays: only counted */
    assert_true(count > 50 && changes.entered_count == count && changes.left_count == 0);
    assert_int_equal(sil_pose_reserve(pose, SIZE_MAX), SIL_OK);
    taken = p.taken;
    for (i = 0; i < 20; ++i)
        (void)sil_track(mesh, pose, i % 2 ? &near_by : &far_off, i % 3 ? 15 : 1, edges, 5000, &changes);
    assert_int_equal(p.taken, taken);
    assert_int_equal(sil_track(mesh, pose, &near_by, 1, edges, 5000, NULL), 0);
    assert_int_equal(sil_track(mesh, NULL, &near_by, 1, edges, 5000, &changes), 0);
    assert_int_equal(sil_track(NULL, pose, &near_by, 1, edges, 5000, &changes), 0);
    assert_int_equal(changes.entered_count + changes.left_count, 0);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    assert_int_equal(p.live, 0);
    free(edges);
    shape_free(&s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_path_finds_the_exact_edges),
        cmocka_unit_test(test_the_hierarchy_leaves_out),
        cmocka_unit_test(test_vectors_give_the_bits_of_plain_code),
        cmocka_unit_test(test_tracker),
        cmocka_unit_test(test_tracker_memory_and_misuse),
        cmocka_unit_test(test_an_eye_that_planes_cannot_tell),
        cmocka_unit_test(test_no_exceptions_are_raised),
        cmocka_unit_test(test_edge_on_faces_need_no_exact_sum),
        cmocka_unit_test(test_flags_tell_edge_on_faces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

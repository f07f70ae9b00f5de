/* shapes.h: meshes from formulas, random numbers that are the same everywhere, and the truth about edges by sorting, for
   the tests of silhouette.h. Include it after silhouette.h and cmocka.h. */
#ifndef GLASSINE_TESTS_SHAPES_H
#define GLASSINE_TESTS_SHAPES_H

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define SHAPES_PI 3.14159265358979323846

static uint64_t random_state = 88172645463325252u;

static inline uint32_t random_bits(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (uint32_t)(random_state >> 32);
}

static inline double random_in(double low, double high) {
    return low + (high - low) * ((double)random_bits() / 4294967296.0);
}

static inline uint32_t random_below(size_t limit) {
    return (uint32_t)(random_bits() % limit);
}

typedef struct shape {
    float *positions;
    uint32_t *indices;
    size_t vertex_count, index_count, vertex_room, index_room;
} shape;

static inline void *grown(void *old, size_t count, size_t size) {
    void *memory = realloc(old, count * size);
    assert_non_null(memory);
    return memory;
}

static inline uint32_t add_vertex(shape *s, double x, double y, double z) {
    float *p;
    if (s->vertex_count == s->vertex_room) {
        s->vertex_room = 2 * s->vertex_room + 64;
        s->positions = (float *)grown(s->positions, 3 * s->vertex_room, sizeof(float));
    }
    p = s->positions + 3 * s->vertex_count;
    p[0] = (float)x;
    p[1] = (float)y;
    p[2] = (float)z;
    return (uint32_t)s->vertex_count++;
}

static inline void add_face(shape *s, uint32_t a, uint32_t b, uint32_t c) {
    if (s->index_count + 3 > s->index_room) {
        s->index_room = 2 * s->index_room + 192;
        s->indices = (uint32_t *)grown(s->indices, s->index_room, sizeof(uint32_t));
    }
    s->indices[s->index_count++] = a;
    s->indices[s->index_count++] = b;
    s->indices[s->index_count++] = c;
}

static inline shape empty_shape(void) {
    shape s;
    memset(&s, 0, sizeof s);
    return s;
}

/* For tests that write into the arrays themselves. */
static inline shape shape_with_room(size_t vertices, size_t triangles) {
    shape s = empty_shape();
    s.vertex_room = vertices + 1;
    s.index_room = 3 * triangles + 3;
    s.positions = (float *)grown(NULL, 3 * s.vertex_room, sizeof(float));
    s.indices = (uint32_t *)grown(NULL, s.index_room, sizeof(uint32_t));
    return s;
}

static inline void shape_free(shape *s) {
    free(s->positions);
    free(s->indices);
    *s = empty_shape();
}

static inline void add_shape(shape *to, const shape *from, double scale, double x, double y, double z) {
    const uint32_t first = (uint32_t)to->vertex_count;
    size_t i;
    for (i = 0; i < from->vertex_count; ++i) {
        const float *p = from->positions + 3 * i;
        add_vertex(to, scale * (double)p[0] + x, scale * (double)p[1] + y, scale * (double)p[2] + z);
    }
    for (i = 0; i + 2 < from->index_count; i += 3)
        add_face(to, first + from->indices[i], first + from->indices[i + 1], first + from->indices[i + 2]);
}

static inline void turn_face(shape *s, size_t face) {
    const uint32_t t = s->indices[3 * face + 1];
    s->indices[3 * face + 1] = s->indices[3 * face + 2];
    s->indices[3 * face + 2] = t;
}

/* A box [0, nx] x [0, ny] x [0, nz] of unit quads, each side with vertices of its own: welding has to join them. */
static inline shape make_box(int nx, int ny, int nz) {
    const int n[3] = {nx, ny, nz};
    shape s = empty_shape();
    int side, i, j;
    for (side = 0; side < 6; ++side) {
        const uint32_t first = (uint32_t)s.vertex_count;
        const int axis = side / 2, up = side % 2, a1 = (axis + 1) % 3, a2 = (axis + 2) % 3;
        const uint32_t row = (uint32_t)n[a2] + 1;
        for (i = 0; i <= n[a1]; ++i)
            for (j = 0; j <= n[a2]; ++j) {
                double p[3];
                p[axis] = up ? n[axis] : 0;
                p[a1] = i;
                p[a2] = j;
                add_vertex(&s, p[0], p[1], p[2]);
            }
        for (i = 0; i < n[a1]; ++i)
            for (j = 0; j < n[a2]; ++j) {
                const uint32_t a = first + (uint32_t)i * row + (uint32_t)j, b = a + row, c = b + 1, d = a + 1;
                add_face(&s, a, up ? b : c, up ? c : b);
                add_face(&s, a, up ? c : d, up ? d : c);
            }
    }
    return s;
}

static inline shape make_cylinder(int n, double radius, double height) {
    shape s = empty_shape();
    uint32_t i, low, high;
    for (i = 0; i < (uint32_t)n; ++i) {
        const double angle = 2 * SHAPES_PI * i / n;
        add_vertex(&s, radius * cos(angle), radius * sin(angle), 0);
        add_vertex(&s, radius * cos(angle), radius * sin(angle), height);
    }
    low = add_vertex(&s, 0, 0, 0);
    high = add_vertex(&s, 0, 0, height);
    for (i = 0; i < (uint32_t)n; ++i) {
        const uint32_t a = 2 * i, b = 2 * ((i + 1) % (uint32_t)n);
        add_face(&s, a, b, b + 1);
        add_face(&s, a, b + 1, a + 1);
        add_face(&s, low, b, a);
        add_face(&s, high, a + 1, b + 1);
    }
    return s;
}

/* A torus around the z axis; `noise` moves vertices, `grid` > 0 rounds them to multiples of 1 / grid. */
static inline shape make_torus(int rings, int sides, double noise, double grid) {
    shape s = empty_shape();
    int i, j, k;
    for (i = 0; i < rings; ++i)
        for (j = 0; j < sides; ++j) {
            const double u = 2 * SHAPES_PI * i / rings, v = 2 * SHAPES_PI * j / sides;
            double p[3];
            p[0] = (1 + 0.4 * cos(v)) * cos(u) + random_in(-noise, noise);
            p[1] = (1 + 0.4 * cos(v)) * sin(u) + random_in(-noise, noise);
            p[2] = 0.4 * sin(v) + random_in(-noise, noise);
            for (k = 0; k < 3 && grid > 0; ++k)
                p[k] = floor(p[k] * grid + 0.5) / grid;
            add_vertex(&s, p[0], p[1], p[2]);
        }
    for (i = 0; i < rings; ++i)
        for (j = 0; j < sides; ++j) {
            const uint32_t a = (uint32_t)(i * sides + j), b = (uint32_t)((i + 1) % rings * sides + j);
            const uint32_t c = (uint32_t)((i + 1) % rings * sides + (j + 1) % sides);
            const uint32_t d = (uint32_t)(i * sides + (j + 1) % sides);
            add_face(&s, a, b, c);
            add_face(&s, a, c, d);
        }
    return s;
}

/* An octahedron divided `depth` times and blown up to a ball of radius 1. */
static inline shape make_ball(int depth) {
    static const uint32_t octahedron[24] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    shape s = empty_shape();
    int level, k;
    size_t i;
    for (i = 0; i < 6; ++i)
        add_vertex(&s, i < 2 ? (i ? -1 : 1) : 0, i / 2 == 1 ? (i % 2 ? -1 : 1) : 0, i / 2 == 2 ? (i % 2 ? -1 : 1) : 0);
    for (i = 0; i < 24; i += 3)
        add_face(&s, octahedron[i], octahedron[i + 1], octahedron[i + 2]);
    for (level = 0; level < depth; ++level) {
        shape finer = empty_shape();
        for (i = 0; i < s.index_count; i += 3) {
            uint32_t v[6];
            for (k = 0; k < 6; ++k) { /* corners, then middles; welding joins them with those of the neighbours */
                const float *p = s.positions + 3 * (size_t)s.indices[i + (size_t)k % 3];
                const float *q = s.positions + 3 * (size_t)s.indices[i + (size_t)(k < 3 ? k : k + 1) % 3];
                const double x = (double)p[0] + (double)q[0], y = (double)p[1] + (double)q[1];
                const double z = (double)p[2] + (double)q[2], length = sqrt(x * x + y * y + z * z);
                v[k] = add_vertex(&finer, x / length, y / length, z / length);
            }
            add_face(&finer, v[0], v[3], v[5]);
            add_face(&finer, v[3], v[1], v[4]);
            add_face(&finer, v[5], v[4], v[2]);
            add_face(&finer, v[3], v[4], v[5]);
        }
        shape_free(&s);
        s = finer;
    }
    return s;
}

/* An open nx * ny grid of unit quads in the plane z = 0, facing up. */
static inline shape make_sheet(int nx, int ny) {
    shape s = empty_shape();
    int i, j;
    for (i = 0; i <= nx; ++i)
        for (j = 0; j <= ny; ++j)
            add_vertex(&s, i, j, 0);
    for (i = 0; i < nx; ++i)
        for (j = 0; j < ny; ++j) {
            const uint32_t a = (uint32_t)(i * (ny + 1) + j), b = a + (uint32_t)ny + 1, c = b + 1, d = a + 1;
            add_face(&s, a, b, c);
            add_face(&s, a, c, d);
        }
    return s;
}

/* The same faces in another order, each beginning with another corner; order[i] is what face i was. */
static inline shape shuffled(const shape *s, uint32_t *order) {
    const size_t faces = s->index_count / 3;
    shape out = empty_shape();
    size_t i;
    for (i = 0; i < s->vertex_count; ++i)
        add_vertex(&out, (double)s->positions[3 * i], (double)s->positions[3 * i + 1], (double)s->positions[3 * i + 2]);
    for (i = 0; i < faces; ++i)
        order[i] = (uint32_t)i;
    for (i = faces; i-- > 1;) {
        const uint32_t j = random_below(i + 1), t = order[i];
        order[i] = order[j];
        order[j] = t;
    }
    for (i = 0; i < faces; ++i) {
        const uint32_t *f = s->indices + 3 * (size_t)order[i], turn = random_below(3);
        add_face(&out, f[turn], f[(turn + 1) % 3], f[(turn + 2) % 3]);
    }
    return out;
}

static inline sil_mesh_desc desc_of(const shape *s) {
    sil_mesh_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.positions = s->positions;
    desc.vertex_count = s->vertex_count;
    desc.indices = s->indices;
    desc.index_count = s->index_count;
    return desc;
}

static inline sil_mesh *mesh_from(const sil_mesh_desc *desc) {
    sil_result result = SIL_RESULT_COUNT;
    sil_mesh *mesh = sil_mesh_create(desc, &result);
    assert_int_equal(result, SIL_OK);
    assert_non_null(mesh);
    return mesh;
}

static inline sil_mesh *mesh_of(const shape *s) {
    const sil_mesh_desc desc = desc_of(s);
    return mesh_from(&desc);
}

static inline sil_pose *pose_of(const sil_mesh *mesh) {
    sil_pose *pose = sil_pose_create(mesh, NULL);
    assert_non_null(pose);
    return pose;
}

static inline sil_view view_at(double x, double y, double z, double w) {
    sil_view view;
    memset(&view, 0, sizeof view);
    view.eye[0] = x;
    view.eye[1] = y;
    view.eye[2] = z;
    view.eye[3] = w;
    return view;
}

/* All edges of the kinds, in memory the caller frees. */
static inline sil_edge *extract_all(const sil_mesh *mesh, sil_pose *pose, const sil_view *view, unsigned kinds,
                                    size_t *count) {
    sil_edge *edges;
    *count = sil_extract(mesh, pose, view, kinds, NULL, 0);
    edges = (sil_edge *)calloc(*count + 1, sizeof *edges);
    assert_non_null(edges);
    assert_int_equal(sil_extract(mesh, pose, view, kinds, edges, *count), *count);
    return edges;
}

/* Vertices that an odd number of the edges end at. */
static inline size_t odd_vertices(const sil_edge *edges, size_t count, size_t vertices) {
    unsigned char *odd = (unsigned char *)calloc(vertices + 1, 1);
    size_t i, total = 0;
    assert_non_null(odd);
    for (i = 0; i < count; ++i) {
        odd[edges[i].a] ^= 1;
        odd[edges[i].b] ^= 1;
    }
    for (i = 0; i < vertices; ++i)
        total += odd[i];
    free(odd);
    return total;
}

static inline void check_same_edges(const sil_edge *a, const sil_edge *b, size_t count) {
    size_t i;
    for (i = 0; i < count; ++i) {
        assert_int_equal(a[i].edge, b[i].edge);
        assert_int_equal(a[i].kinds, b[i].kinds);
        assert_int_equal(a[i].a, b[i].a);
        assert_int_equal(a[i].b, b[i].b);
        assert_int_equal(a[i].face[0], b[i].face[0]);
        assert_int_equal(a[i].face[1], b[i].face[1]);
    }
}

#endif

/* meshes.h: the meshes of the benchmarks of silhouette.h, and the published test of every edge. Include it after the
   implementation of silhouette.h. */
#ifndef GLASSINE_BENCH_MESHES_H
#define GLASSINE_BENCH_MESHES_H

#include "bench.h"

typedef struct model {
    const char *name;
    float *positions;
    uint32_t *indices;
    size_t vertex_count, index_count;
} model;

/* What the published test reads of an edge. */
typedef struct plain_edge {
    uint32_t a, b, face[2];
} plain_edge;

typedef struct published {
    plain_edge *edges;
    float *normals;
    size_t edge_count, bytes;
} published;

static inline model model_new(const char *name, size_t vertices, size_t triangles) {
    model m;
    m.name = name;
    m.positions = (float *)need(3 * vertices * sizeof(float));
    m.indices = (uint32_t *)need(3 * triangles * sizeof(uint32_t));
    m.vertex_count = vertices;
    m.index_count = 0;
    return m;
}

static inline void add_quad(model *m, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    const uint32_t corners[6] = {a, b, c, a, c, d};
    memcpy(m->indices + m->index_count, corners, sizeof corners);
    m->index_count += 6;
}

static inline model make_torus(size_t rings, size_t sides) {
    model m = model_new("torus", rings * sides, 2 * rings * sides);
    size_t i, j;
    for (i = 0; i < rings; ++i)
        for (j = 0; j < sides; ++j) {
            const double u = 2 * SIL_I_PI * (double)i / (double)rings, v = 2 * SIL_I_PI * (double)j / (double)sides;
            float *p = m.positions + 3 * (i * sides + j);
            const size_t right = (i + 1) % rings * sides, up = (j + 1) % sides;
            p[0] = (float)((1 + 0.4 * cos(v)) * cos(u));
            p[1] = (float)((1 + 0.4 * cos(v)) * sin(u));
            p[2] = (float)(0.4 * sin(v));
            add_quad(&m, (uint32_t)(i * sides + j), (uint32_t)(right + j), (uint32_t)(right + up),
                     (uint32_t)(i * sides + up));
        }
    return m;
}

/* A ball with gentle bumps, smooth at the size of a face; `bumps` of 0.3 makes a rough one, with bumps of a few faces. */
static inline model make_blob(const char *name, size_t rings, size_t sides, double bumps) {
    model m = model_new(name, rings * sides, 2 * (rings - 1) * sides);
    size_t i, j;
    for (i = 0; i < rings; ++i)
        for (j = 0; j < sides; ++j) {
            const double u = SIL_I_PI * ((double)i + 0.5) / (double)rings;
            const double v = 2 * SIL_I_PI * (double)j / (double)sides;
            const double wave = bumps > 0.2 ? (double)(rings / 6) : 5;
            const double r = 1 + bumps * sin(wave * u) * cos(wave * v);
            float *p = m.positions + 3 * (i * sides + j);
            const size_t next = (j + 1) % sides, low = i * sides, high = low + sides;
            p[0] = (float)(r * sin(u) * cos(v));
            p[1] = (float)(r * sin(u) * sin(v));
            p[2] = (float)(r * cos(u));
            if (i + 1 < rings)
                add_quad(&m, (uint32_t)(low + j), (uint32_t)(high + j), (uint32_t)(high + next),
                         (uint32_t)(low + next));
        }
    return m;
}

/* The surface of a box of n * n * n cells: flat sides, as CAD has them. Vertices are numbered by place. */
static inline model make_box(size_t n) {
    model m = model_new("box", (n + 1) * (n + 1) * 6, 12 * n * n);
    size_t side, i, j;
    m.vertex_count = 0;
    for (side = 0; side < 6; ++side) {
        const uint32_t first = (uint32_t)m.vertex_count, row = (uint32_t)n + 1;
        for (i = 0; i <= n; ++i)
            for (j = 0; j <= n; ++j) {
                float *p = m.positions + 3 * m.vertex_count++;
                p[side / 2] = side % 2 ? 1 : -1;
                p[(side / 2 + 1) % 3] = (float)(2 * (double)i / (double)n - 1);
                p[(side / 2 + 2) % 3] = (float)(2 * (double)j / (double)n - 1);
            }
        for (i = 0; i < n; ++i)
            for (j = 0; j < n; ++j) {
                const uint32_t a = first + (uint32_t)i * row + (uint32_t)j, b = a + row, c = b + 1, d = a + 1;
                if (side % 2)
                    add_quad(&m, a, b, c, d);
                else
                    add_quad(&m, a, d, c, b);
            }
    }
    return m;
}

/* A turned part: steps, cones, grooves and long cylinders, as CAD has them; open at its ends. */
static inline model make_shaft(size_t rings, size_t sides) {
    static const double profile[12][2] = {{-2, 0.3},    {-1.5, 0.3},  {-1.5, 0.5}, {-0.9, 0.5},
                                          {-0.9, 0.35}, {-0.7, 0.35}, {-0.7, 0.9}, {-0.3, 0.9},
                                          {-0.1, 0.6},  {0.8, 0.6},   {0.8, 0.3},  {2, 0.3}};
    model m = model_new("shaft", rings * sides, 2 * (rings - 1) * sides);
    double at[12] = {0};
    size_t i, j, k = 0;
    for (i = 1; i < 12; ++i)
        at[i] = at[i - 1] + hypot(profile[i][0] - profile[i - 1][0], profile[i][1] - profile[i - 1][1]);
    for (i = 0; i < rings; ++i) {
        const double want = at[11] * (double)i / (double)(rings - 1);
        double t, z, r;
        while (k < 10 && at[k + 1] < want)
            ++k;
        t = fmin((want - at[k]) / (at[k + 1] - at[k]), 1);
        z = profile[k][0] + t * (profile[k + 1][0] - profile[k][0]);
        r = profile[k][1] + t * (profile[k + 1][1] - profile[k][1]);
        for (j = 0; j < sides; ++j) {
            const double v = 2 * SIL_I_PI * (double)j / (double)sides;
            float *p = m.positions + 3 * (i * sides + j);
            const size_t next = (j + 1) % sides, low = i * sides, high = low + sides;
            p[0] = (float)(r * cos(v));
            p[1] = (float)(r * sin(v));
            p[2] = (float)z;
            if (i + 1 < rings)
                add_quad(&m, (uint32_t)(low + j), (uint32_t)(low + next), (uint32_t)(high + next),
                         (uint32_t)(high + j));
        }
    }
    return m;
}

/* The same faces and edges as the mesh has. */
static inline published publish(const sil_mesh *mesh) {
    published p;
    size_t i;
    int k;
    p.edge_count = mesh->edge_count;
    p.bytes = mesh->edge_count * sizeof(plain_edge) + mesh->face_count * 3 * sizeof(float);
    p.edges = (plain_edge *)need(mesh->edge_count * sizeof(plain_edge));
    p.normals = (float *)need(mesh->face_count * 3 * sizeof(float));
    for (i = 0; i < mesh->edge_count; ++i) {
        p.edges[i].a = mesh->edge_vertex[2 * i];
        p.edges[i].b = mesh->edge_vertex[2 * i + 1];
        p.edges[i].face[0] = mesh->edge_face[0][i];
        p.edges[i].face[1] = mesh->edge_face[1][i];
    }
    for (i = 0; i < mesh->face_count; ++i) {
        double normal[3], error, length;
        sil_i_normal(&mesh->rest, mesh->corner + 3 * i, normal, &error);
        length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        for (k = 0; k < 3; ++k)
            p.normals[3 * i + (size_t)k] = (float)(normal[k] / length);
    }
    return p;
}

/* Diepstraten 2002, equation 1; a direction for parallel views. */
static inline size_t run_published(const published *p, const float *positions, const sil_view *view, uint32_t *out) {
    const float ex = (float)view->eye[0], ey = (float)view->eye[1], ez = (float)view->eye[2], w = (float)view->eye[3];
    size_t i, count = 0;
    for (i = 0; i < p->edge_count; ++i) {
        const plain_edge *e = &p->edges[i];
        const float *v = positions + 3 * (size_t)e->a;
        const float *n0 = p->normals + 3 * (size_t)e->face[0], *n1 = p->normals + 3 * (size_t)e->face[1];
        const float x = ex - w * v[0], y = ey - w * v[1], z = ez - w * v[2];
        const float d0 = n0[0] * x + n0[1] * y + n0[2] * z, d1 = n1[0] * x + n1[1] * y + n1[2] * z;
        if (d0 * d1 < 0)
            out[count++] = (uint32_t)i;
    }
    return count;
}

#endif

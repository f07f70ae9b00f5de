/* cc -std=c11 -O2 -I. bench/silhouette.c -o bench_silhouette -lm && ./bench_silhouette [FILE.csv]

   Time to find the silhouettes of one view, median over many views, and of what comes after. Subjects:
     published  the papers' way: for each edge the product of its faces' signs, float normals, scalar code
     brute      silhouette.h with a pose, made with SIL_MESH_NO_HIERARCHY: exact signs of all faces, then all edges
     hierarchy  the same by the hierarchy, which gives way to the flat scan by itself; bytes are those it adds
   error_max is the largest number of edges, in every seventh view, that differ from those by exact signs asked for one at a time.
   BENCH=quick takes fewer views. The file is build/bench/silhouette.csv unless given; its folder must exist. */
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

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

static model model_new(const char *name, size_t vertices, size_t triangles) {
    model m;
    m.name = name;
    m.positions = (float *)need(3 * vertices * sizeof(float));
    m.indices = (uint32_t *)need(3 * triangles * sizeof(uint32_t));
    m.vertex_count = vertices;
    m.index_count = 0;
    return m;
}

static void add_quad(model *m, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    const uint32_t corners[6] = {a, b, c, a, c, d};
    memcpy(m->indices + m->index_count, corners, sizeof corners);
    m->index_count += 6;
}

static model make_torus(size_t rings, size_t sides) {
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

/* A sphere with gentle bumps, smooth at the size of a face; `bumps` of 0.3 makes a rough one, with many silhouettes. */
static model make_blob(const char *name, size_t rings, size_t sides, double bumps) {
    model m = model_new(name, rings * sides, 2 * (rings - 1) * sides);
    size_t i, j;
    for (i = 0; i < rings; ++i)
        for (j = 0; j < sides; ++j) {
            const double u = SIL_I_PI * ((double)i + 0.5) / (double)rings;
            const double v = 2 * SIL_I_PI * (double)j / (double)sides;
            const double wave = bumps > 0.2 ? 31 : 5, r = 1 + bumps * sin(wave * u) * cos(wave * v);
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
static model make_box(size_t n) {
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

/* The same faces and edges as the mesh has. */
static published publish(const sil_mesh *mesh) {
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
static size_t run_published(const published *p, const float *positions, const sil_view *view, uint32_t *out) {
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

/* How many indices are in one of two rising lists only. */
static size_t differing(const uint32_t *a, size_t a_count, const sil_edge *b, size_t b_count) {
    size_t i = 0, j = 0, both = 0;
    while (i < a_count && j < b_count) {
        both += a[i] == b[j].edge;
        if (a[i] < b[j].edge)
            ++i;
        else if (a[i] > b[j].edge)
            ++j;
        else {
            ++i;
            ++j;
        }
    }
    return a_count + b_count - 2 * both;
}

/* View number i: an eye moving in small steps, now on one radius, now on another; or along the axes and diagonals, in parallel. */
static sil_view view_number(size_t i, int axes) {
    sil_view view;
    const double angle = 0.37 + 0.05 * (double)i, radius = i % 10 < 5 ? 2.2 : 6;
    view.eye[0] = axes ? (double)(i % 3 == 0) : radius * cos(angle);
    view.eye[1] = axes ? (double)(i % 3 == 1) : radius * sin(angle);
    view.eye[2] = axes ? (double)(i % 3 == 2) : radius * 0.5 * sin(0.3 * angle);
    view.eye[3] = !axes;
    return view;
}

static void report(FILE *csv, const char *scene, size_t size, const char *subject, double ms, size_t bytes,
                   size_t errors) {
    printf("%-12s %-12s %9lu  %-10s %9.3f ms %7.2f ns/edge %11lu bytes  %lu edges differ\n", "extract", scene,
           (unsigned long)size, subject, ms, 1e6 * ms / (double)size, (unsigned long)bytes, (unsigned long)errors);
    fprintf(csv, "extract,%s,%lu,%s,%.6f,%lu,%lu\n", scene, (unsigned long)size, subject, ms, (unsigned long)bytes,
            (unsigned long)errors);
}

/* poses: of the mesh without and of that with a hierarchy. */
static void run_views(FILE *csv, const char *scene, const published *p, sil_pose *const poses[2], int axes,
                      size_t views) {
    const sil_mesh *mesh = poses[0]->mesh, *other = poses[1]->mesh;
    uint32_t *found = (uint32_t *)need(mesh->edge_count * sizeof(uint32_t));
    sil_edge *edges = (sil_edge *)need(mesh->edge_count * sizeof(sil_edge));
    sil_edge *truth = (sil_edge *)need(mesh->edge_count * sizeof(sil_edge));
    double *times[3];
    size_t i, j, lines = 0, errors[3] = {0, 0, 0};
    times[0] = (double *)need(3 * views * sizeof(double));
    times[1] = times[0] + views;
    times[2] = times[1] + views;
    for (j = 0; j < 3; ++j) /* one subject after the other: each finds in the caches what it left there */
        for (i = 0; i < views; ++i) {
            const sil_view view = view_number(i, axes);
            const double start = now_ms();
            size_t count, k, wrong, true_count;
            if (j == 0)
                count = run_published(p, mesh->rest.position, &view, found);
            else
                count =
                    sil_extract(j == 2 ? other : mesh, poses[j - 1], &view, SIL_SILHOUETTE, edges, mesh->edge_count);
            times[j][i] = now_ms() - start;
            if (i % 7) /* the truth takes long, and would empty the caches every time */
                continue;
            for (k = 0; k < count && j; ++k)
                found[k] = edges[k].edge;
            true_count = sil_extract(mesh, NULL, &view, SIL_SILHOUETTE, truth, mesh->edge_count);
            wrong = differing(found, count, truth, true_count);
            errors[j] = wrong > errors[j] ? wrong : errors[j];
            lines += true_count;
        }
    for (i = 0; i < 3; ++i)
        qsort(times[i], views, sizeof(double), compare_doubles);
    report(csv, scene, mesh->edge_count, "published", times[0][views / 2], p->bytes, errors[0]);
    report(csv, scene, mesh->edge_count, "brute", times[1][views / 2], sil_mesh_get_info(mesh).bytes + mesh->face_count,
           errors[1]);
    report(csv, scene, mesh->edge_count, "hierarchy", times[2][views / 2], sil_mesh_get_info(other).hierarchy_bytes,
           errors[2]);
    printf("  %.2f %% of the edges are silhouettes; published / hierarchy %.1f, brute / hierarchy %.2f\n",
           100.0 * (double)lines / (double)(3 * ((views + 6) / 7) * mesh->edge_count),
           times[0][views / 2] / times[2][views / 2], times[1][views / 2] / times[2][views / 2]);
    free(found);
    free(edges);
    free(truth);
    free(times[0]);
}

static sil_ribbon_desc screen(void) {
    sil_ribbon_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.model_view[0] = desc.model_view[5] = desc.model_view[10] = desc.model_view[15] = 1;
    desc.model_view[14] = -4;
    desc.projection[0] = 1;
    desc.projection[5] = 1.5f;
    desc.projection[10] = -1.02f;
    desc.projection[11] = -1;
    desc.projection[14] = -0.2f;
    desc.viewport_width = 1280;
    desc.viewport_height = 853;
    return desc;
}

/* What comes after extraction, for one view; the median of nine runs each. Sizes: faces, edges, edges, and pairs of
   vertices and edges. */
static void run_rest(FILE *csv, const model *m, const sil_mesh *mesh, sil_pose *pose) {
    const sil_view view = view_number(1, 0);
    const sil_ribbon_desc desc = screen();
    sil_edge *edges = (sil_edge *)need(mesh->edge_count * sizeof *edges);
    const size_t count = sil_extract(mesh, pose, &view, SIL_SILHOUETTE, edges, mesh->edge_count);
    sil_strip *strips = (sil_strip *)need(count * sizeof *strips);
    uint32_t *vertices = (uint32_t *)need(2 * count * sizeof *vertices);
    float *distances = (float *)need(m->vertex_count * sizeof *distances);
    static const char *const work[4] = {"pose", "chain", "ribbons", "distances"};
    const size_t size[4] = {mesh->face_count, count, count, count * m->vertex_count};
    sil_ribbon_vertex *ribbons;
    double times[4][9];
    size_t i, strip_count, needed, room;
    int k;
    (void)sil_pose_reserve(pose, count);
    strip_count = sil_chain(mesh, pose, edges, count, strips, count, vertices, 2 * count, &needed);
    room = sil_ribbons(mesh, pose, strips, strip_count, vertices, &desc, NULL, 0);
    ribbons = (sil_ribbon_vertex *)need(room * sizeof *ribbons);
    for (i = 0; i < 9; ++i) {
        double at[5];
        at[0] = now_ms();
        (void)sil_pose_set(pose, m->positions, 0);
        at[1] = now_ms();
        (void)sil_chain(mesh, pose, edges, count, strips, count, vertices, 2 * count, &needed);
        at[2] = now_ms();
        (void)sil_ribbons(mesh, pose, strips, strip_count, vertices, &desc, ribbons, room);
        at[3] = now_ms();
        (void)sil_distances(mesh, pose, edges, count, NULL, 0, m->vertex_count, distances, NULL);
        at[4] = now_ms();
        for (k = 0; k < 4; ++k)
            times[k][i] = at[k + 1] - at[k];
    }
    (void)sil_pose_set(pose, NULL, 0);
    for (k = 0; k < 4; ++k) {
        qsort(times[k], 9, sizeof(double), compare_doubles);
        printf("%-12s %-12s %9lu  %-10s %9.3f ms\n", work[k], m->name, (unsigned long)size[k], "brute", times[k][4]);
        fprintf(csv, "%s,%s,%lu,brute,%.6f,0,0\n", work[k], m->name, (unsigned long)size[k], times[k][4]);
    }
    free(edges);
    free(strips);
    free(vertices);
    free(distances);
    free(ribbons);
}

static void run_model(FILE *csv, model m, size_t views) {
    static const char *const subjects[2] = {"brute", "hierarchy"};
    sil_mesh_desc desc;
    sil_mesh *meshes[2];
    sil_pose *poses[2];
    published p;
    char axis_name[64];
    size_t i;
    memset(&desc, 0, sizeof desc);
    desc.positions = m.positions;
    desc.vertex_count = m.vertex_count;
    desc.indices = m.indices;
    desc.index_count = m.index_count;
    for (i = 0; i < 2; ++i) {
        const double start = now_ms();
        double ms;
        desc.flags = i ? SIL_MESH_HIERARCHY : SIL_MESH_NO_HIERARCHY;
        meshes[i] = sil_mesh_create(&desc, NULL);
        poses[i] = sil_pose_create(meshes[i], NULL);
        if (!meshes[i] || !poses[i]) {
            fputs("bench silhouette: out of memory\n", stderr);
            exit(1);
        }
        ms = now_ms() - start;
        printf("%-12s %-12s %9lu  %-10s %9.3f ms %11lu bytes\n", "create", m.name, (unsigned long)meshes[i]->edge_count,
               subjects[i], ms, (unsigned long)sil_mesh_get_info(meshes[i]).bytes);
        fprintf(csv, "create,%s,%lu,%s,%.6f,%lu,0\n", m.name, (unsigned long)meshes[i]->edge_count, subjects[i], ms,
                (unsigned long)sil_mesh_get_info(meshes[i]).bytes);
    }
    p = publish(meshes[0]);
    run_views(csv, m.name, &p, poses, 0, views);
    snprintf(axis_name, sizeof axis_name, "%s_axes", m.name);
    run_views(csv, axis_name, &p, poses, 1, views);
    if (m.vertex_count < 100000) /* all pairs of a larger one take too long */
        run_rest(csv, &m, meshes[0], poses[0]);
    free(p.edges);
    free(p.normals);
    for (i = 0; i < 2; ++i) {
        sil_pose_destroy(poses[i]);
        sil_mesh_destroy(meshes[i]);
    }
    free(m.positions);
    free(m.indices);
}

int main(int argc, char **argv) {
    const size_t views = is_quick() ? 15 : 101;
    FILE *csv = open_table(argc, argv, "build/bench/silhouette.csv");
    run_model(csv, make_torus(250, 134), views);
    run_model(csv, make_box(76), views);
    run_model(csv, make_blob("rough_blob", 183, 183, 0.3), views);
    run_model(csv, make_torus(800, 420), views);
    run_model(csv, make_blob("blob", 578, 578, 0.1), views);
    run_model(csv, make_box(240), views);
    return close_table(csv);
}

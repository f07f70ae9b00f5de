/* cc -std=c11 -O2 -I. bench/distance.c -o bench_distance -lm && ./bench_distance [FILE.csv]

   Time to find, for every vertex, the distance to the nearest silhouette of one view, median over several views.
   Subjects:
     published  the paper's way: all pairs of vertices and silhouettes, to the endless line, scalar code in double
     pairs      sil_distances: all pairs, to the edge, blocks out of reach passed over
     tree       sil_edge_tree_build and sil_distances_by_tree, both in the time
     tree_at    sil_distances_at for the same points in another order: shuffled, so that neighbours tell nothing
   error_max is the largest difference from the distance to the nearest edge, all pairs in double, as a share of the
   largest distance of the view; `differ` counts vertices whose distance or nearest edge is not that of pairs.
   BENCH=quick takes fewer views. The file is build/bench/distance.csv unless given; its folder must exist. */
#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include "bench.h"

enum { PUBLISHED, PAIRS, TREE, TREE_AT, SUBJECTS };
static const char *const subject_names[SUBJECTS] = {"published", "pairs", "tree", "tree_at"};

typedef struct model {
    const char *name;
    float *positions;
    uint32_t *indices;
    size_t vertex_count, index_count;
} model;

/* What one view is computed into. */
typedef struct results {
    float *distances[SUBJECTS];
    uint32_t *nearest[SUBJECTS];
    double *truth;
    uint32_t *order; /* shuffled vertices, and their positions */
    float *shuffled;
    double times[SUBJECTS][101], errors[SUBJECTS];
    size_t differ[SUBJECTS], pairs, bytes;
} results;

/* A torus whose tube has bumps; none: smooth, with few silhouettes. */
static model make_torus(const char *name, size_t rings, size_t sides, double bumps) {
    model m;
    size_t i, j;
    m.name = name;
    m.vertex_count = rings * sides;
    m.index_count = 0;
    m.positions = (float *)need(3 * m.vertex_count * sizeof(float));
    m.indices = (uint32_t *)need(6 * m.vertex_count * sizeof(uint32_t));
    for (i = 0; i < rings; ++i)
        for (j = 0; j < sides; ++j) {
            const double u = 2 * SIL_I_PI * (double)i / (double)rings, v = 2 * SIL_I_PI * (double)j / (double)sides;
            const double tube = 0.4 + bumps * sin(23 * u) * sin(11 * v);
            const uint32_t right = (uint32_t)((i + 1) % rings * sides), up = (uint32_t)((j + 1) % sides);
            const uint32_t here = (uint32_t)(i * sides), side = (uint32_t)j;
            const uint32_t quad[6] = {here + side, right + side, right + up, here + side, right + up, here + up};
            float *p = m.positions + 3 * (i * sides + j);
            p[0] = (float)((1 + tube * cos(v)) * cos(u));
            p[1] = (float)((1 + tube * cos(v)) * sin(u));
            p[2] = (float)(tube * sin(v));
            memcpy(m.indices + m.index_count, quad, sizeof quad);
            m.index_count += 6;
        }
    return m;
}

static double distance_to(const float *v, const float *p, const float *q, int endless) {
    const double ex = (double)q[0] - (double)p[0], ey = (double)q[1] - (double)p[1], ez = (double)q[2] - (double)p[2];
    const double wx = (double)v[0] - (double)p[0], wy = (double)v[1] - (double)p[1], wz = (double)v[2] - (double)p[2];
    double t = (wx * ex + wy * ey + wz * ez) / (ex * ex + ey * ey + ez * ez), x, y, z;
    if (!endless)
        t = t < 0 ? 0 : t > 1 ? 1 : t;
    x = wx - t * ex;
    y = wy - t * ey;
    z = wz - t * ez;
    return x * x + y * y + z * z;
}

static void all_pairs(const model *m, const sil_edge *edges, size_t count, int endless, float *distances, double *out) {
    size_t i, k;
    for (i = 0; i < m->vertex_count; ++i) {
        double best = 1e300;
        for (k = 0; k < count; ++k) {
            const double square = distance_to(m->positions + 3 * i, m->positions + 3 * (size_t)edges[k].a,
                                              m->positions + 3 * (size_t)edges[k].b, endless);
            best = square < best ? square : best;
        }
        if (distances)
            distances[i] = (float)sqrt(best);
        if (out)
            out[i] = sqrt(best);
    }
}

static void compare(const model *m, results *r) {
    double largest = 0;
    size_t i;
    int k;
    for (i = 0; i < m->vertex_count; ++i)
        largest = r->truth[i] > largest ? r->truth[i] : largest;
    for (i = 0; i < m->vertex_count; ++i)
        for (k = 0; k < SUBJECTS; ++k) {
            const size_t at = k == TREE_AT ? r->order[i] : i;
            const double error = fabs((double)r->distances[k][i] - r->truth[at]) / largest;
            r->errors[k] = error > r->errors[k] ? error : r->errors[k];
            r->differ[k] += memcmp(&r->distances[k][i], &r->distances[PAIRS][at], sizeof(float)) != 0 ||
                            r->nearest[k][i] != r->nearest[PAIRS][at];
        }
}

static void run_view(const model *m, const sil_mesh *mesh, sil_pose *pose, sil_edge_tree *tree, size_t view_number,
                     sil_edge *edges, results *r) {
    const double angle = 0.37 + 0.31 * (double)view_number, radius = view_number % 2 ? 2.2 : 6;
    double eye[3], at[SUBJECTS + 1];
    sil_view view;
    size_t count, i;
    int k;
    eye[0] = radius * cos(angle);
    eye[1] = radius * sin(angle);
    eye[2] = radius * 0.5 * sin(0.3 * angle);
    view = sil_view_perspective(eye);
    count = sil_extract(mesh, pose, &view, SIL_SILHOUETTE, edges, mesh->edge_count);
    for (i = 0; i < m->vertex_count; ++i)
        memcpy(r->shuffled + 3 * i, m->positions + 3 * (size_t)r->order[i], 3 * sizeof(float));
    at[0] = now_ms();
    all_pairs(m, edges, count, 1, r->distances[PUBLISHED], NULL);
    at[1] = now_ms();
    (void)sil_distances(mesh, pose, edges, count, NULL, 0, m->vertex_count, r->distances[PAIRS], r->nearest[PAIRS]);
    at[2] = now_ms();
    (void)sil_edge_tree_build(tree, pose, edges, count, NULL);
    (void)sil_distances_by_tree(tree, 0, m->vertex_count, r->distances[TREE], r->nearest[TREE]);
    at[3] = now_ms();
    (void)sil_distances_at(tree, r->shuffled, 0, m->vertex_count, r->distances[TREE_AT], r->nearest[TREE_AT]);
    at[4] = now_ms();
    for (k = 0; k < SUBJECTS; ++k)
        r->times[k][view_number] = at[k + 1] - at[k];
    all_pairs(m, edges, count, 0, NULL, r->truth);
    compare(m, r);
    r->pairs += count * m->vertex_count;
}

static void report(FILE *csv, const model *m, results *r, size_t views) {
    int k;
    for (k = 0; k < SUBJECTS; ++k)
        qsort(r->times[k], views, sizeof(double), compare_doubles);
    printf("%s: %lu vertices, %lu silhouettes a view\n", m->name, (unsigned long)m->vertex_count,
           (unsigned long)(r->pairs / views / m->vertex_count));
    for (k = 0; k < SUBJECTS; ++k) {
        const double ms = r->times[k][views / 2];
        const size_t bytes = k == TREE || k == TREE_AT ? r->bytes : 0;
        printf("  %-10s %9.3f ms  1/%-7.1f %9lu bytes  error %.3g", subject_names[k], ms,
               r->times[PUBLISHED][views / 2] / ms, (unsigned long)bytes, r->errors[k]);
        if (k == PUBLISHED)
            printf("\n");
        else
            printf("  %lu differ\n", (unsigned long)r->differ[k]);
        fprintf(csv, "distance,%s,%lu,%s,%.6f,%lu,%.6g\n", m->name, (unsigned long)m->vertex_count, subject_names[k],
                ms, (unsigned long)bytes, r->errors[k]);
    }
}

static void run_model(FILE *csv, model m, size_t views) {
    sil_mesh_desc desc;
    sil_mesh *mesh;
    sil_pose *pose;
    sil_edge_tree *tree;
    sil_edge *edges;
    results r;
    uint32_t state = 12345;
    size_t i;
    int k;
    memset(&desc, 0, sizeof desc);
    desc.positions = m.positions;
    desc.vertex_count = m.vertex_count;
    desc.indices = m.indices;
    desc.index_count = m.index_count;
    mesh = sil_mesh_create(&desc, NULL);
    pose = sil_pose_create(mesh, NULL);
    tree = mesh ? sil_edge_tree_create(mesh, NULL) : NULL;
    if (!mesh || !pose || !tree) {
        fputs("bench distance: out of memory\n", stderr);
        exit(1);
    }
    edges = (sil_edge *)need(mesh->edge_count * sizeof *edges);
    memset(&r, 0, sizeof r);
    for (k = 0; k < SUBJECTS; ++k) {
        r.distances[k] = (float *)need(m.vertex_count * sizeof(float));
        r.nearest[k] = (uint32_t *)need(m.vertex_count * sizeof(uint32_t));
        memset(r.nearest[k], 0, m.vertex_count * sizeof(uint32_t));
    }
    r.truth = (double *)need(m.vertex_count * sizeof(double));
    r.order = (uint32_t *)need(m.vertex_count * sizeof(uint32_t));
    r.shuffled = (float *)need(3 * m.vertex_count * sizeof(float));
    for (i = 0; i < m.vertex_count; ++i) {
        size_t other;
        state = state * 1664525u + 1013904223u;
        other = (state >> 8) % (i + 1);
        r.order[i] = r.order[other];
        r.order[other] = (uint32_t)i;
    }
    for (i = 0; i < views; ++i)
        run_view(&m, mesh, pose, tree, i, edges, &r);
    r.bytes = sil_edge_tree_bytes(tree);
    report(csv, &m, &r, views);
    for (k = 0; k < SUBJECTS; ++k) {
        free(r.distances[k]);
        free(r.nearest[k]);
    }
    free(r.truth);
    free(r.order);
    free(r.shuffled);
    free(edges);
    sil_edge_tree_destroy(tree);
    sil_pose_destroy(pose);
    sil_mesh_destroy(mesh);
    free(m.positions);
    free(m.indices);
}

int main(int argc, char **argv) {
    const size_t views = is_quick() ? 3 : 15;
    FILE *csv = open_table(argc, argv, "build/bench/distance.csv");
    run_model(csv, make_torus("torus", 250, 144, 0), views);
    run_model(csv, make_torus("bumpy_torus", 250, 144, 0.06), views);
    return close_table(csv);
}

/* What lines cost: chains, corners, ribbons by weight, dashes, dashes that stay, smooth silhouettes; on the silhouettes
   of a torus and of a bumpy one, in nanoseconds of the processor for each vertex of the strips. Writes a table; medians over views.
   Build: cc -std=c11 -O2 -I. bench/lines.c -o bench_lines -lm */
#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include "bench.h"

#include <math.h>

#define PI 3.14159265358979323846

enum { VIEWS = 31, SIZE = 1024 };

typedef struct subject {
    sil_mesh *mesh;
    sil_pose *pose;
    sil_edge *edges;
    sil_strip *strips;
    uint32_t *vertices;
    float *along;
    sil_smooth_point *points;
    sil_ribbon_vertex *ribbons;
    float *depth, *normals;
    sil_dashes *dashes;
    size_t edge_count, strip_count, vertex_count, most;
} subject;

static subject make_torus(int rings, int sides, double bumps) {
    float *positions = need(3 * (size_t)(rings * sides) * sizeof *positions);
    uint32_t *indices = need(6 * (size_t)(rings * sides) * sizeof *indices);
    sil_mesh_desc desc;
    subject s;
    for (int i = 0; i < rings; i++)
        for (int j = 0; j < sides; j++) {
            const double u = 2 * PI * i / rings, v = 2 * PI * j / sides;
            const double r = 0.4 * (1 + bumps * sin(37 * u) * cos(11 * v)), x = 1 + r * cos(v);
            float *p = positions + 3 * (size_t)(i * sides + j);
            const uint32_t a = (uint32_t)(i * sides + j), b = (uint32_t)((i + 1) % rings * sides + j);
            const uint32_t c = (uint32_t)((i + 1) % rings * sides + (j + 1) % sides);
            const uint32_t d = (uint32_t)(i * sides + (j + 1) % sides);
            const uint32_t face[6] = {a, b, c, a, c, d};
            p[0] = (float)(x * cos(u));
            p[1] = (float)(x * sin(u));
            p[2] = (float)(r * sin(v));
            memcpy(indices + 6 * (size_t)a, face, sizeof face);
        }
    memset(&desc, 0, sizeof desc);
    desc.positions = positions;
    desc.vertex_count = (size_t)(rings * sides);
    desc.indices = indices;
    desc.index_count = 6 * (size_t)(rings * sides);
    memset(&s, 0, sizeof s);
    s.mesh = sil_mesh_create(&desc, NULL);
    s.pose = sil_pose_create(s.mesh, NULL);
    s.dashes = sil_dashes_create(NULL, NULL);
    s.most = sil_mesh_get_info(s.mesh).edge_count;
    s.edges = need(s.most * sizeof *s.edges);
    s.strips = need(s.most * sizeof *s.strips);
    s.vertices = need(2 * s.most * sizeof *s.vertices);
    s.along = need(2 * s.most * sizeof *s.along);
    s.points = need(2 * s.most * sizeof *s.points);
    s.ribbons = need(120 * s.most * sizeof *s.ribbons);
    s.depth = need(SIZE * SIZE * sizeof *s.depth);
    for (size_t i = 0; i < SIZE * SIZE; i++)
        s.depth[i] = (i / 64 + i / SIZE / 64) % 2 ? 1.0f : 0.5f;
    s.normals = need(desc.vertex_count * 3 * sizeof *s.normals);
    for (size_t i = 0; i < desc.vertex_count; i++) { /* of a torus without bumps */
        const double x = (double)positions[3 * i], y = (double)positions[3 * i + 1], ring = hypot(x, y);
        s.normals[3 * i] = (float)(x - x / ring);
        s.normals[3 * i + 1] = (float)(y - y / ring);
        s.normals[3 * i + 2] = positions[3 * i + 2];
    }
    free(positions);
    free(indices);
    return s;
}

static void give_back(subject *s) {
    free(s->edges);
    free(s->strips);
    free(s->vertices);
    free(s->along);
    free(s->points);
    free(s->ribbons);
    free(s->depth);
    free(s->normals);
    sil_dashes_destroy(s->dashes);
    sil_pose_destroy(s->pose);
    sil_mesh_destroy(s->mesh);
}

/* Of the processor, not by the clock on the wall: what takes microseconds is lost in what else a machine does. */
static double cpu_ms(void) {
    return 1000.0 * (double)clock() / CLOCKS_PER_SEC;
}

static void look(sil_ribbon_desc *desc, double azimuth) {
    const double ca = cos(azimuth), sa = sin(azimuth), ce = cos(0.5), se = sin(0.5);
    const double m[12] = {-sa, -se * ca, ce * ca, ca, -se * sa, ce * sa, 0, ce, se, 0, 0, -4};
    memset(desc, 0, sizeof *desc);
    for (int i = 0; i < 12; i++)
        desc->model_view[i / 3 * 4 + i % 3] = (float)m[i];
    desc->model_view[15] = 1;
    desc->projection[0] = desc->projection[5] = 1.8f;
    desc->projection[10] = -1.002f;
    desc->projection[14] = -0.2f;
    desc->projection[11] = -1;
    desc->viewport_width = desc->viewport_height = SIZE;
}

enum {
    CHAINS,
    CORNERS,
    ONE,
    THICK_THIN,
    PERSPECTIVE,
    LIGHT,
    OUTER,
    TAPERED,
    DASHED,
    STAY,
    SMOOTH,
    HERMITE,
    GIVEN,
    SUBJECTS
};

static const char *const NAMES[SUBJECTS] = {"chains",
                                            "chains with corners on the screen",
                                            "ribbons, one weight",
                                            "ribbons, thick and thin",
                                            "ribbons, perspective",
                                            "ribbons, light",
                                            "ribbons, outer by depth",
                                            "ribbons, tapered",
                                            "ribbons, phantom dashes",
                                            "dashes that stay, each frame",
                                            "smooth silhouettes",
                                            "smooth silhouettes, Hermite",
                                            "smooth silhouettes, normals given"};

static size_t chain(subject *s, const sil_ribbon_desc *view, int corners) {
    sil_chain_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.corner_degrees = 60;
    for (int i = 0; i < 16; i++)
        for (int k = 0; k < 4; k++)
            desc.matrix[i] += view->projection[4 * k + i % 4] * view->model_view[i / 4 * 4 + k];
    desc.viewport_width = desc.viewport_height = SIZE;
    return sil_chain_corners(s->mesh, s->pose, corners ? &desc : NULL, s->edges, s->edge_count, s->strips, s->most,
                             s->vertices, 2 * s->most, &s->vertex_count);
}

/* Does it once; returns how many strip vertices it was done for. */
static size_t work(subject *s, int what, const sil_ribbon_desc *view) {
    static const float phantom[6] = {24, 5, 6, 5, 6, 5};
    static const sil_weight weights[] = {SIL_WEIGHT_ONE, SIL_WEIGHT_THICK_THIN, SIL_WEIGHT_PERSPECTIVE,
                                         SIL_WEIGHT_LIGHT, SIL_WEIGHT_OUTER};
    sil_ribbon_desc desc = *view;
    sil_image image;
    sil_view eye;
    size_t count = 0;
    memset(&image, 0, sizeof image);
    image.depth = s->depth;
    image.width = image.height = SIZE;
    desc.image = &image;
    desc.taper = what == TAPERED ? 50 : 0;
    if (what <= CORNERS)
        s->strip_count = chain(s, view, what == CORNERS);
    if (what >= ONE && what <= OUTER)
        desc.weight = weights[what - ONE];
    if (what == DASHED || what == STAY) {
        desc.dashes = phantom;
        desc.dash_count = 6;
    }
    if (what >= ONE && what <= DASHED)
        (void)sil_ribbons(s->mesh, s->pose, s->strips, s->strip_count, s->vertices, &desc, s->ribbons, 120 * s->most);
    if (what == STAY)
        (void)sil_dashes_follow(s->dashes, s->mesh, s->pose, s->strips, s->strip_count, s->vertices, &desc, s->along);
    if (what >= SMOOTH) {
        (void)sil_view_from_matrices(view->model_view, view->projection, &eye);
        (void)sil_smooth(s->mesh, s->pose, &eye, what == GIVEN ? s->normals : NULL, 0, what == HERMITE, s->points,
                         2 * s->most, s->strips, s->most, &count);
        return count;
    }
    return s->vertex_count;
}

static void run(const char *name, subject s, FILE *csv) {
    double each[SUBJECTS][VIEWS], whole[SUBJECTS][VIEWS];
    size_t vertices = 0;
    for (int view = 0; view < VIEWS; view++) {
        sil_ribbon_desc desc;
        sil_view eye;
        look(&desc, 0.017 * view);
        (void)sil_view_from_matrices(desc.model_view, desc.projection, &eye);
        s.edge_count = sil_extract(s.mesh, s.pose, &eye, SIL_SILHOUETTE, s.edges, s.most);
        for (int what = SUBJECTS - 1; what >= 0; what--) { /* chains last: they leave strips for the next view's rest */
            const int now = what == CORNERS ? CORNERS : what;
            double start, time;
            size_t count;
            if (now >= ONE && now <= STAY)
                (void)work(&s, CHAINS, &desc);
            start = cpu_ms();
            count = work(&s, now, &desc);
            time = cpu_ms() - start;
            whole[now][view] = time;
            each[now][view] = 1e6 * time / (double)(count ? count : 1);
            vertices = now == CHAINS ? count : vertices;
        }
    }
    printf("%s: %zu edges, some %zu strip vertices\n", name, s.most, vertices);
    for (int what = 0; what < SUBJECTS; what++) {
        const double ms = median(whole[what], VIEWS);
        printf("  %-36s %8.4f ms %8.0f ns a strip vertex\n", NAMES[what], ms, median(each[what], VIEWS));
        fprintf(csv, "lines,%s,%zu,%s,%.6f,,\n", name, s.most, NAMES[what], ms);
    }
    give_back(&s);
}

int main(int argc, char **argv) {
    FILE *csv = open_table(argc, argv, "build/bench/lines.csv");
    const int size = is_quick() ? 1 : 2;
    run("torus", make_torus(128 * size, 64 * size, 0), csv);
    run("bumpy torus", make_torus(192 * size, 96 * size, 0.1), csv);
    return close_table(csv);
}

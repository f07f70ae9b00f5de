/* Flicker of silhouettes: edges that enter and leave from frame to frame, over a turn of 360 frames, with exact signs,
   with a dead zone, and with one that remembers. The meshes have noise of a thousandth of their radius, as scans have,
   and are compared with the same meshes without.
   cc -std=c11 -O2 -I. bench/flicker.c -o flicker -lm && ./flicker [FILE.csv]
   In the table error_max is the number of edges that enter or leave, a frame, on average. */
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include <math.h>

#include "bench.h"

enum { FRAMES = 360 };

typedef struct subject {
    const char *name;
    double degrees;
    unsigned flags;
} subject;

typedef struct scene {
    const char *name;
    size_t around, along; /* quads */
    bool ring;            /* a torus, else a pipe along z, open at both ends */
    double noise;
} scene;

static double noise_at(size_t i) {
    uint32_t h = (uint32_t)i * 2654435769u;
    h ^= h >> 15;
    h *= 2246822519u;
    h ^= h >> 13;
    h *= 3266489917u;
    return (double)(h ^ h >> 16) / 2147483648.0 - 1;
}

static sil_mesh *make(const scene *s) {
    const double pi = 3.14159265358979323846;
    const size_t rows = s->ring ? s->along : s->along + 1;
    float *positions = need(rows * s->around * 3 * sizeof *positions);
    uint32_t *indices = need(s->along * s->around * 6 * sizeof *indices), *at = indices;
    for (size_t i = 0; i < rows * s->around; ++i) {
        const double u = 2 * pi * (double)(i / s->around) / (double)s->along;
        const double v = 2 * pi * (double)(i % s->around) / (double)s->around;
        const double r = 1 + s->noise * noise_at(i);
        const double p[2][3] = {{r * cos(v), r * sin(v), -20 * u / (2 * pi)},
                                {(3 + r * cos(v)) * cos(u), (3 + r * cos(v)) * sin(u), r * sin(v)}};
        for (size_t k = 0; k < 3; ++k)
            positions[3 * i + k] = (float)p[s->ring][k];
    }
    for (size_t i = 0; i < s->along; ++i)
        for (size_t j = 0; j < s->around; ++j) {
            const uint32_t w = (uint32_t)s->around, row = (uint32_t)i * w, next = (uint32_t)((i + 1) % rows) * w;
            const uint32_t a = row + (uint32_t)j, b = row + (uint32_t)(j + 1) % w, c = next + (uint32_t)(j + 1) % w;
            const uint32_t d = next + (uint32_t)j, six[6] = {a, c, b, a, d, c};
            memcpy(at, six, sizeof six);
            at += 6;
        }
    sil_mesh_desc desc;
    memset(&desc, 0, sizeof desc);
    desc.positions = positions;
    desc.vertex_count = rows * s->around;
    desc.indices = indices;
    desc.index_count = s->along * s->around * 6;
    sil_mesh *mesh = sil_mesh_create(&desc, NULL);
    free(positions);
    free(indices);
    if (!mesh)
        exit(1);
    return mesh;
}

/* The pipe is looked down from about its axis, 200 radii away, the eye going round it; the ring turns before the eye. */
static sil_view view_of(const scene *s, int frame) {
    const double angle = 2 * 3.14159265358979323846 * frame / FRAMES;
    const double pipe[3] = {1.5 * cos(angle), 1.5 * sin(angle), 200};
    const double ring[3] = {20 * cos(angle), 20 * sin(angle), 6};
    return sil_view_perspective(s->ring ? ring : pipe);
}

static size_t changes(const sil_edge *a, size_t m, const sil_edge *b, size_t n) {
    size_t i = 0, j = 0, count = 0;
    while (i < m || j < n) {
        const uint32_t x = i < m ? a[i].edge : SIL_NONE, y = j < n ? b[j].edge : SIL_NONE;
        count += x != y;
        i += x <= y;
        j += y <= x;
    }
    return count;
}

static void measure(const scene *s, const sil_mesh *mesh, const subject *what, FILE *csv) {
    const size_t room = sil_mesh_get_info(mesh).edge_count;
    sil_edge *now = need(room * sizeof *now), *before = need(room * sizeof *before);
    double times[FRAMES + 1], sum = 0, found = 0;
    size_t count = 0, last = 0;
    sil_pose *pose = sil_pose_create(mesh, NULL);
    if (!pose || sil_pose_set_dead_zone(pose, sin(what->degrees * 3.14159265358979323846 / 180), what->flags) != SIL_OK)
        exit(1);
    for (int frame = 0; frame <= FRAMES; ++frame) { /* the first frame again at the end */
        const sil_view view = view_of(s, frame % FRAMES);
        const double start = now_ms();
        count = sil_extract(mesh, pose, &view, SIL_SILHOUETTE, now, room);
        times[frame] = now_ms() - start;
        found += (double)count / (FRAMES + 1);
        if (frame)
            sum += (double)changes(before, last, now, count) / FRAMES;
        sil_edge *t = before;
        before = now;
        now = t;
        last = count;
    }
    const double ms = median(times, FRAMES + 1);
    printf("  %-26s %9.1f %12.2f %10.3f\n", what->name, found, sum, ms);
    fprintf(csv, "flicker,%s,%zu,%s,%.4f,%zu,%.3f\n", s->name, room, what->name, ms, sil_mesh_get_info(mesh).bytes,
            sum);
    sil_pose_destroy(pose);
    free(now);
    free(before);
}

int main(int argc, char **argv) {
    static const scene scenes[] = {{"pipe", 96, 200, false, 1e-3}, {"ring", 96, 200, true, 1e-3}};
    static const subject subjects[] = {{"exact", 0, 0},
                                       {"zone of 0.5 degrees", 0.5, 0},
                                       {"zone of 0.5, remembers", 0.5, SIL_ZONE_REMEMBER},
                                       {"zone of 1 degree", 1, 0},
                                       {"zone of 1, remembers", 1, SIL_ZONE_REMEMBER},
                                       {"zone of 2 degrees", 2, 0},
                                       {"zone of 2, remembers", 2, SIL_ZONE_REMEMBER}};
    FILE *csv = open_table(argc, argv, "build/bench/flicker.csv");
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; ++i) {
        scene smooth = scenes[i];
        sil_mesh *mesh = make(&scenes[i]), *clean;
        smooth.noise = 0;
        clean = make(&smooth);
        printf("%s, %zu edges                 edges   in and out  ms a frame\n", scenes[i].name,
               sil_mesh_get_info(mesh).edge_count);
        const subject still = {"exact, without noise", 0, 0};
        measure(&scenes[i], clean, &still, csv);
        for (size_t k = 0; k < sizeof subjects / sizeof *subjects; ++k)
            measure(&scenes[i], mesh, &subjects[k], csv);
        sil_mesh_destroy(mesh);
        sil_mesh_destroy(clean);
    }
    return close_table(csv);
}

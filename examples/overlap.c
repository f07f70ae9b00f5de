#include "overlap.h"

#include <math.h>
#include <stdlib.h>

enum { SIDE = 96 }; /* pixels a side of a view */

typedef struct grid {
    unsigned layers[SIDE][SIDE];
    double nearest[SIDE][SIDE];
    bool back[SIDE][SIDE];
} grid;

/* Pixels whose middle the triangle covers; points are across, up, toward the eye, in pixels. Middles lie where no vertex of
 * a regular mesh does, so that edges count for one triangle. */
static void cover(grid *g, const double p[3][3]) {
    double area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
    double low[2], high[2];
    if (!(fabs(area) > 1e-12))
        return;
    for (int k = 0; k < 2; k++) {
        low[k] = fmax(fmin(p[0][k], fmin(p[1][k], p[2][k])) - 1, 0);
        high[k] = fmin(fmax(p[0][k], fmax(p[1][k], p[2][k])), SIDE - 1);
    }
    for (int y = (int)low[1]; y <= (int)high[1]; y++)
        for (int x = (int)low[0]; x <= (int)high[0]; x++) {
            double at[2] = {x + 0.5137, y + 0.4871}, weight[3], z = 0;
            bool inside = true;
            for (int c = 0; c < 3; c++) {
                const double *a = p[(c + 1) % 3], *b = p[(c + 2) % 3];
                weight[c] = ((a[0] - at[0]) * (b[1] - at[1]) - (b[0] - at[0]) * (a[1] - at[1])) / area;
                inside = inside && weight[c] >= 0;
                z += weight[c] * p[c][2];
            }
            if (!inside)
                continue;
            if (g->layers[y][x]++ == 0 || z > g->nearest[y][x]) {
                g->nearest[y][x] = z;
                g->back[y][x] = area < 0;
            }
        }
}

static overlap look(grid *g, const scene_mesh *mesh, int view, const double low[3], double size) {
    int axis = view / 2, across = (axis + 1) % 3, up = (axis + 2) % 3;
    double toward = view % 2 ? -1 : 1;
    double covered = 0, layered = 0, back = 0;
    *g = (grid){{{0}}, {{0}}, {{false}}};
    for (size_t t = 0; t + 2 < mesh->index_count; t += 3) {
        double p[3][3];
        for (size_t c = 0; c < 3; c++) {
            const float *v = mesh->positions + 3 * (size_t)mesh->indices[t + c];
            double right = ((double)v[across] - low[across]) / size;
            p[c][0] = SIDE * (toward > 0 ? right : 1 - right);
            p[c][1] = SIDE * ((double)v[up] - low[up]) / size;
            p[c][2] = toward * ((double)v[axis] - low[axis]) / size;
        }
        cover(g, (const double(*)[3])p);
    }
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            covered += g->layers[y][x] > 0;
            layered += g->layers[y][x] > 1;
            back += g->back[y][x];
        }
    return (overlap){covered > 0 ? layered / covered : 0, covered > 0 ? back / covered : 0};
}

bool overlap_measure(const scene_mesh *mesh, overlap views[OVERLAP_VIEWS]) {
    grid *g = malloc(sizeof *g);
    double low[3], size = 0;
    for (int k = 0; k < 3; k++) {
        double high = -HUGE_VAL;
        low[k] = HUGE_VAL;
        for (size_t i = 0; i < mesh->vertex_count; i++) {
            low[k] = fmin(low[k], (double)mesh->positions[3 * i + (size_t)k]);
            high = fmax(high, (double)mesh->positions[3 * i + (size_t)k]);
        }
        size = fmax(size, high - low[k]);
    }
    for (int view = 0; g && view < OVERLAP_VIEWS; view++)
        views[view] = size > 0 && isfinite(size) ? look(g, mesh, view, low, size) : (overlap){0, 0};
    free(g);
    return g != NULL;
}

bool overlap_is_rolled(const overlap views[OVERLAP_VIEWS]) {
    double layered = 0;
    int both = 0;
    for (int i = 0; i < OVERLAP_VIEWS; i++) {
        layered += views[i].layered / OVERLAP_VIEWS;
        both += views[i].back >= 0.05 && views[i].back <= 0.95;
    }
    return both >= 4 && layered >= 0.5;
}

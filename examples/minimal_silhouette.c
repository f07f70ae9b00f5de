/* cc minimal_silhouette.c -o minimal_silhouette -lm     (needs silhouette.h beside it or -I)

   The smallest use of silhouette.h: a mesh from a formula, its lines for one eye, and an SVG of them. No window, no GL.
   The mesh is a nut, a torus whose tube has six flat sides: it has silhouettes, creases and hidden lines. */
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RINGS = 72, SIDES = 6, VERTICES = RINGS * SIDES, FACES = 2 * VERTICES, EDGES = 3 * VERTICES };

static const double pi = 3.14159265358979323846;

static void make_ring(float *positions, uint32_t *indices) {
    uint32_t i, j, n = 0;
    for (i = 0; i < RINGS; ++i)
        for (j = 0; j < SIDES; ++j) {
            const double u = 2 * pi * i / RINGS, v = 2 * pi * (j + 0.5) / SIDES, r = 1 + 0.45 * cos(v);
            const uint32_t a = i * SIDES + j, b = (i + 1) % RINGS * SIDES + j, up = (j + 1) % SIDES;
            const uint32_t c = (i + 1) % RINGS * SIDES + up, d = i * SIDES + up;
            positions[3 * a] = (float)(r * cos(u));
            positions[3 * a + 1] = (float)(r * sin(u));
            positions[3 * a + 2] = (float)(0.6 * sin(v));
            indices[n++] = a;
            indices[n++] = b;
            indices[n++] = c;
            indices[n++] = a;
            indices[n++] = c;
            indices[n++] = d;
        }
}

static double coordinate(const float *positions, uint32_t vertex, int axis) {
    return (double)positions[3 * vertex + (uint32_t)axis];
}

/* The camera: at `eye`, looking at the origin, z up. screen[2] is the distance along the view. */
static void project(const double eye[3], const double p[3], double screen[3]) {
    const double length = sqrt(eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2]);
    const double flat = sqrt(eye[0] * eye[0] + eye[1] * eye[1]);
    const double right[3] = {-eye[1] / flat, eye[0] / flat, 0};
    const double back[3] = {eye[0] / length, eye[1] / length, eye[2] / length};
    const double up[3] = {-back[2] * right[1], back[2] * right[0], back[0] * right[1] - back[1] * right[0]};
    double x = 0, y = 0, z = length;
    int k;
    for (k = 0; k < 3; ++k) {
        x += right[k] * p[k];
        y += up[k] * p[k];
        z -= back[k] * p[k];
    }
    screen[0] = 400 + 960 * x / z;
    screen[1] = 295 - 960 * y / z;
    screen[2] = z;
}

/* Does the way from p to the eye pass through a face? Faces that p lies on are excused by a small margin. */
static int is_hidden(const float *positions, const uint32_t *indices, const double eye[3], const double p[3]) {
    int f, k;
    for (f = 0; f < FACES; ++f) {
        double e1[3], e2[3], d[3], h[3], s[3], q[3], det, u, v, t;
        for (k = 0; k < 3; ++k) {
            const double a = coordinate(positions, indices[3 * f], k);
            e1[k] = coordinate(positions, indices[3 * f + 1], k) - a;
            e2[k] = coordinate(positions, indices[3 * f + 2], k) - a;
            d[k] = eye[k] - p[k];
            s[k] = p[k] - a;
        }
        for (k = 0; k < 3; ++k) {
            h[k] = d[(k + 1) % 3] * e2[(k + 2) % 3] - d[(k + 2) % 3] * e2[(k + 1) % 3];
            q[k] = s[(k + 1) % 3] * e1[(k + 2) % 3] - s[(k + 2) % 3] * e1[(k + 1) % 3];
        }
        det = e1[0] * h[0] + e1[1] * h[1] + e1[2] * h[2];
        if (fabs(det) < 1e-12)
            continue;
        u = (s[0] * h[0] + s[1] * h[1] + s[2] * h[2]) / det;
        v = (d[0] * q[0] + d[1] * q[1] + d[2] * q[2]) / det;
        t = (e2[0] * q[0] + e2[1] * q[1] + e2[2] * q[2]) / det;
        if (u > 1e-6 && v > 1e-6 && u + v < 1 - 1e-6 && t > 2e-3)
            return 1;
    }
    return 0;
}

/* One strip as polylines: each segment in short steps, a new polyline where hidden and visible change. */
static void draw_strip(FILE *file, const sil_strip *strip, const uint32_t *vertices, const float *positions,
                       const uint32_t *indices, const double eye[3], int hidden_ones) {
    int drawing = 0;
    uint32_t i, step;
    for (i = 0; i + 1 < strip->count; ++i)
        for (step = 0; step < 8; ++step) {
            double ends[2][3], middle[3], screen[2][3];
            int k;
            for (k = 0; k < 3; ++k) {
                const double a = coordinate(positions, vertices[strip->first + i], k);
                const double b = coordinate(positions, vertices[strip->first + i + 1], k);
                ends[0][k] = a + (b - a) * step / 8;
                ends[1][k] = a + (b - a) * (step + 1) / 8;
                middle[k] = 0.5 * (ends[0][k] + ends[1][k]);
            }
            if (is_hidden(positions, indices, eye, middle) != hidden_ones) {
                if (drawing)
                    fputs("\"/>\n", file);
                drawing = 0;
                continue;
            }
            project(eye, ends[0], screen[0]);
            project(eye, ends[1], screen[1]);
            if (!drawing)
                fprintf(file, "<polyline points=\"%.2f,%.2f", screen[0][0], screen[0][1]);
            fprintf(file, " %.2f,%.2f", screen[1][0], screen[1][1]);
            drawing = 1;
        }
    if (drawing)
        fputs("\"/>\n", file);
}

/* Hidden silhouettes thin and dashed, below; creases thin; silhouettes heavy, on top: an illustrator's weights. */
static int write_svg(const char *path, const sil_strip *strips, size_t count, const uint32_t *vertices,
                     const float *positions, const uint32_t *indices, const double eye[3]) {
    static const char *const style[3] = {"stroke=\"#9aa7b5\" stroke-width=\"1\" stroke-dasharray=\"5 4\"",
                                         "stroke=\"#333\" stroke-width=\"1.3\"",
                                         "stroke=\"#000\" stroke-width=\"3.2\""};
    FILE *file = fopen(path, "w");
    int layer, failed;
    size_t i;
    if (!file)
        return 0;
    fputs("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"800\" height=\"600\" viewBox=\"0 0 800 600\">\n"
          "<rect width=\"800\" height=\"600\" fill=\"#fff\"/>\n",
          file);
    for (layer = 0; layer < 3; ++layer) {
        fprintf(file, "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" %s>\n", style[layer]);
        for (i = 0; i < count; ++i) {
            const int silhouette = (strips[i].kinds & SIL_SILHOUETTE) != 0;
            if (silhouette != (layer == 1))
                draw_strip(file, &strips[i], vertices, positions, indices, eye, layer == 0);
        }
        fputs("</g>\n", file);
    }
    fputs("</svg>\n", file);
    failed = ferror(file);
    return fclose(file) == 0 && !failed;
}

int main(int argc, char **argv) {
    static float positions[3 * VERTICES];
    static uint32_t indices[3 * FACES], vertices[2 * EDGES];
    static sil_edge edges[EDGES];
    static sil_strip strips[EDGES];
    const double eye[3] = {3.2, -2.1, 3};
    const char *path = argc > 1 ? argv[1] : "minimal_silhouette.svg";
    sil_mesh_desc desc;
    sil_mesh_info info;
    sil_result result;
    sil_mesh *mesh;
    sil_view view = sil_view_perspective(eye);
    size_t edge_count, strip_count, vertex_count;

    make_ring(positions, indices);
    memset(&desc, 0, sizeof desc);
    desc.positions = positions;
    desc.vertex_count = VERTICES;
    desc.indices = indices;
    desc.index_count = 3 * FACES;
    desc.crease_degrees = 25;
    mesh = sil_mesh_create(&desc, &result);
    if (!mesh) {
        fprintf(stderr, "minimal_silhouette: %s\n", sil_result_string(result));
        return 1;
    }
    info = sil_mesh_get_info(mesh);
    edge_count = sil_extract(mesh, NULL, &view, SIL_SILHOUETTE | SIL_CREASE | SIL_BOUNDARY, edges, EDGES);
    strip_count = sil_chain(mesh, NULL, edges, edge_count, strips, EDGES, vertices, 2 * EDGES, &vertex_count);
    printf("%u faces, %u edges, %s; seen from here %u lines in %u strips\n", (unsigned)info.face_count,
           (unsigned)info.edge_count, info.closed ? "closed" : "open", (unsigned)edge_count, (unsigned)strip_count);
    sil_mesh_destroy(mesh);
    if (!write_svg(path, strips, strip_count, vertices, positions, indices, eye)) {
        fprintf(stderr, "minimal_silhouette: cannot write %s\n", path);
        return 1;
    }
    printf("wrote %s\n", path);
    return 0;
}

/* depth_image.c: the depths of a scene without a GPU. */
#include "depth_image.h"

#include <math.h>
#include <stdlib.h>

bool depth_image_create(depth_image *image, int width, int height) {
    size_t count = (size_t)width * (size_t)height;
    image->width = width;
    image->height = height;
    image->depth = malloc((count + 1) * sizeof *image->depth);
    for (size_t i = 0; image->depth && i < count; i++)
        image->depth[i] = 1.0f;
    return image->depth != NULL;
}

void depth_image_destroy(depth_image *image) {
    free(image->depth);
    image->depth = NULL;
}

/* Pixels and depth; false behind the eye. */
static bool place(const depth_image *image, const double m[16], const float *p, double out[3]) {
    double clip[4];
    for (int k = 0; k < 4; k++)
        clip[k] = m[k] * (double)p[0] + m[4 + k] * (double)p[1] + m[8 + k] * (double)p[2] + m[12 + k];
    out[0] = 0.5 * image->width * (clip[0] / clip[3] + 1);
    out[1] = 0.5 * image->height * (clip[1] / clip[3] + 1);
    out[2] = 0.5 * (clip[2] / clip[3] + 1);
    return clip[3] > 0 && isfinite(out[0]) && isfinite(out[1]) && isfinite(out[2]);
}

static int clamp_to(double value, int most) {
    return value < 0 ? 0 : value > most ? most : (int)value;
}

static double edge(const double a[3], const double b[3], double x, double y) {
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

static void fill(depth_image *image, const double *a, const double *b, const double *c) {
    double area = edge(a, b, c[0], c[1]);
    int left = clamp_to(floor(fmin(a[0], fmin(b[0], c[0])) - 0.5), image->width);
    int right = clamp_to(ceil(fmax(a[0], fmax(b[0], c[0])) + 0.5), image->width);
    int low = clamp_to(floor(fmin(a[1], fmin(b[1], c[1])) - 0.5), image->height);
    int high = clamp_to(ceil(fmax(a[1], fmax(b[1], c[1])) + 0.5), image->height);
    for (int y = low; area != 0 && y < high; y++)
        for (int x = left; x < right; x++) {
            double u = edge(b, c, x + 0.5, y + 0.5) / area, v = edge(c, a, x + 0.5, y + 0.5) / area, w = 1 - u - v;
            float *depth = &image->depth[(size_t)y * (size_t)image->width + (size_t)x];
            double z = u * a[2] + v * b[2] + w * c[2];
            if (u >= 0 && v >= 0 && w >= 0 && z >= 0 && z < (double)*depth)
                *depth = (float)z;
        }
}

void depth_image_draw(depth_image *image, const float *positions, size_t vertex_count, const uint32_t *indices,
                      size_t index_count, const double to_clip[16]) {
    for (size_t i = 0; i + 2 < index_count; i += 3) {
        double corner[3][3];
        bool whole = true;
        for (size_t k = 0; k < 3 && whole; k++)
            whole = indices[i + k] < vertex_count &&
                    place(image, to_clip, positions + 3 * (size_t)indices[i + k], corner[k]);
        if (whole)
            fill(image, corner[0], corner[1], corner[2]);
    }
}

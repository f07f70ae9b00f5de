/* depth_image.h: the depths of a scene without a GPU, for what asks which places can be seen and where nothing is. */
#ifndef DEPTH_IMAGE_H
#define DEPTH_IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct depth_image {
    float *depth; /* width * height of them, rows upward; window depth, 1 where nothing is */
    int width, height;
} depth_image;

/* False: out of memory. */
bool depth_image_create(depth_image *image, int width, int height);
void depth_image_destroy(depth_image *image);

/* Draws both sides of the triangles. to_clip is column-major, -w <= z <= w. A pixel belongs to a triangle if its centre
 * does; triangles that reach behind the eye or have an index out of range are left out. */
void depth_image_draw(depth_image *image, const float *positions, size_t vertex_count, const uint32_t *indices,
                      size_t index_count, const double to_clip[16]);

#endif

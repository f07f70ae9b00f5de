/* transfer_image.h: a transfer function for curvature from a picture. */
#ifndef TRANSFER_IMAGE_H
#define TRANSFER_IMAGE_H

#include <stdbool.h>
#include <stddef.h>

enum { TRANSFER_SHADES = 32, TRANSFER_CURVATURES = 32, TRANSFER_DEPTHS = 16 };

typedef struct transfer_image {
    bool is_shade;                                          /* the picture has one row */
    float shades[3 * TRANSFER_SHADES];                      /* rgb factors for kappa from -1 to 1, grey of 128 is 1 */
    float opacities[TRANSFER_DEPTHS * TRANSFER_CURVATURES]; /* top row near; |kappa| from 0 to 1 to the right */
} transfer_image;

/* A PNG of any size, sampled between its pixels. Opacity is its alpha where it has some, else its brightness. False:
 * message says why. */
bool transfer_image_read(const char *path, transfer_image *out, char *message, size_t message_size);

#endif

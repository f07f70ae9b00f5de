#include "transfer_image.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define STBI_NO_STDIO
#include <stb/stb_image.h> /* implemented in load_model.c */

enum { LARGEST = 1 << 24, WIDEST = 4096 }; /* bytes of a file; pixels along a side */

/* NULL: why is in the message. */
static unsigned char *read_all(const char *path, size_t *size, char *message, size_t message_size) {
    struct stat there;
    if (stat(path, &there) == 0 && !S_ISREG(there.st_mode)) { /* a pipe would be waited for */
        snprintf(message, message_size, "is not a regular file");
        return NULL;
    }
    FILE *file = fopen(path, "rb");
    if (!file) {
        snprintf(message, message_size, "cannot be read: %s", strerror(errno));
        return NULL;
    }
    unsigned char *bytes = malloc(LARGEST);
    *size = bytes ? fread(bytes, 1, LARGEST, file) : 0;
    if (!bytes)
        snprintf(message, message_size, "out of memory");
    fclose(file);
    return bytes;
}

/* At x, y in [0,1], of `channels` a pixel; the outermost pixels' middles are 0 and 1. */
static float sample(const unsigned char *pixels, int width, int height, double x, double y, int channel) {
    double at[2] = {x * (width - 1), y * (height - 1)};
    int x0 = (int)at[0], y0 = (int)at[1], x1 = x0 + 1 < width ? x0 + 1 : x0, y1 = y0 + 1 < height ? y0 + 1 : y0;
    double u = at[0] - x0, v = at[1] - y0;
    double top = (1 - u) * pixels[4 * (y0 * width + x0) + channel] + u * pixels[4 * (y0 * width + x1) + channel];
    double low = (1 - u) * pixels[4 * (y1 * width + x0) + channel] + u * pixels[4 * (y1 * width + x1) + channel];
    return (float)((1 - v) * top + v * low);
}

static void fill(const unsigned char *pixels, int width, int height, bool has_alpha, transfer_image *out) {
    out->is_shade = height == 1;
    for (int i = 0; i < TRANSFER_SHADES; i++)
        for (int k = 0; k < 3; k++)
            out->shades[3 * i + k] = sample(pixels, width, height, (double)i / (TRANSFER_SHADES - 1), 0, k) / 128.0f;
    for (int row = 0; row < TRANSFER_DEPTHS; row++)
        for (int i = 0; i < TRANSFER_CURVATURES; i++) {
            double x = (double)i / (TRANSFER_CURVATURES - 1), y = (double)row / (TRANSFER_DEPTHS - 1);
            float grey = 0.299f * sample(pixels, width, height, x, y, 0) +
                         0.587f * sample(pixels, width, height, x, y, 1) +
                         0.114f * sample(pixels, width, height, x, y, 2);
            float opacity = (has_alpha ? sample(pixels, width, height, x, y, 3) : grey) / 255.0f;
            out->opacities[row * TRANSFER_CURVATURES + i] = opacity < 1.0f ? opacity : 1.0f;
        }
}

bool transfer_image_read(const char *path, transfer_image *out, char *message, size_t message_size) {
    size_t size;
    int width = 0, height = 0, channels = 0;
    unsigned char *bytes = read_all(path, &size, message, message_size), *pixels = NULL;
    if (!bytes)
        return false;
    if (!stbi_info_from_memory(bytes, (int)size, &width, &height, &channels))
        snprintf(message, message_size, "not an image that can be read");
    else if (width > WIDEST || height > WIDEST)
        snprintf(message, message_size, "%d x %d pixels, and %d a side are the most", width, height, WIDEST);
    else if (!(pixels = stbi_load_from_memory(bytes, (int)size, &width, &height, &channels, 4)))
        snprintf(message, message_size, "cut short or broken");
    else
        fill(pixels, width, height, channels == 2 || channels == 4, out);
    free(pixels);
    free(bytes);
    return pixels != NULL;
}

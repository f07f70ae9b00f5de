/* write_png.h: an image into a PNG file, whole or not at all. */
#ifndef WRITE_PNG_H
#define WRITE_PNG_H

#include <stdbool.h>
#include <stddef.h>

/* Whether a file could be written at that path, before the work is done: false and a message where the folder is
 * missing or closed, or the path is a folder. */
bool write_png_possible(const char *path, char *message, size_t message_size);

/* Any bytes. They go to a file of its own beside the target first, which then takes the target's name. */
bool write_file(const char *path, const unsigned char *bytes, size_t count, char *message, size_t message_size);

/* The same for rgba: width*height*4 bytes, top row first, not premultiplied. Where no pixel is see-through the file has
 * no alpha. */
bool write_png(const char *path, const unsigned char *rgba, int width, int height, char *message, size_t message_size);

#endif

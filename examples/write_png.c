#define _POSIX_C_SOURCE 200809L
#define _XOPEN_SOURCE 700 /* realpath */

#include "write_png.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The implementation is not held to our warnings. */
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#pragma GCC diagnostic ignored "-Wundef"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

static bool refuse(char *message, size_t size, const char *what) {
    snprintf(message, size, "%s", what);
    return false;
}

/* The folder of a path, malloc'd; "." where it has none. */
static char *folder_of(const char *path) {
    const char *slash = strrchr(path, '/');
    size_t length = slash ? (size_t)(slash - path) : 1;
    if (slash == path)
        length = 1;
    char *folder = malloc(length + 1);
    if (folder) {
        memcpy(folder, slash ? path : ".", length);
        folder[length] = '\0';
    }
    return folder;
}

bool write_png_possible(const char *path, char *message, size_t message_size) {
    struct stat there;
    if (stat(path, &there) == 0 && S_ISDIR(there.st_mode))
        return refuse(message, message_size, "is a folder, not a file");
    if (stat(path, &there) == 0 && !S_ISREG(there.st_mode)) /* a pipe or a device is written to, never replaced */
        return access(path, W_OK) == 0 || refuse(message, message_size, strerror(errno));
    char *folder = folder_of(path);
    if (!folder)
        return refuse(message, message_size, "out of memory");
    bool ok = stat(folder, &there) == 0;
    if (!ok)
        snprintf(message, message_size, "folder %.150s: %s", folder, strerror(errno));
    else if (!S_ISDIR(there.st_mode) || access(folder, W_OK | X_OK) != 0) {
        snprintf(message, message_size, "folder %.150s: %s", folder,
                 S_ISDIR(there.st_mode) ? strerror(errno) : "is not a folder");
        ok = false;
    }
    free(folder);
    return ok;
}

static bool write_all(int file, const unsigned char *bytes, size_t count) {
    while (count > 0) {
        ssize_t written = write(file, bytes, count);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        bytes += written;
        count -= (size_t)written;
    }
    return true;
}

/* mkstemp gives a file to its owner alone; the result is to be as readable as any other new file. */
static void usual_permissions(int file) {
    mode_t mask = umask(0);
    umask(mask);
    (void)fchmod(file, 0666 & ~mask);
}

static bool write_beside(const char *target, const unsigned char *bytes, size_t count, char *message, size_t size) {
    size_t length = strlen(target) + 8;
    char *temporary = malloc(length);
    if (!temporary)
        return refuse(message, size, "out of memory");
    snprintf(temporary, length, "%s.XXXXXX", target);
    int file = mkstemp(temporary);
    if (file < 0) {
        refuse(message, size, strerror(errno));
        free(temporary);
        return false;
    }
    usual_permissions(file);
    bool ok = write_all(file, bytes, count);
    int error = errno;
    if (close(file) != 0 && ok) {
        ok = false;
        error = errno;
    }
    if (ok && rename(temporary, target) != 0) {
        ok = false;
        error = errno;
    }
    if (!ok) {
        unlink(temporary);
        refuse(message, size, strerror(error));
    }
    free(temporary);
    return ok;
}

bool write_file(const char *path, const unsigned char *bytes, size_t count, char *message, size_t size) {
    struct stat there;
    if (stat(path, &there) == 0 && !S_ISREG(there.st_mode)) {
        FILE *file = fopen(path, "wb");
        bool ok = file && fwrite(bytes, 1, count, file) == count;
        ok = (!file || fclose(file) == 0) && ok;
        return ok || refuse(message, size, strerror(errno));
    }
    char *real = realpath(path, NULL); /* a link stays a link: what it points to is replaced */
    bool ok = write_beside(real ? real : path, bytes, count, message, size);
    free(real);
    return ok;
}

/* Without alpha where it says nothing: many programs draw a chequered ground behind images that have it. */
static size_t drop_alpha(const unsigned char *rgba, size_t pixels, unsigned char *rgb) {
    for (size_t i = 0; i < pixels; i++)
        if (rgba[4 * i + 3] != 255)
            return 4;
    for (size_t i = 0; i < pixels; i++)
        memcpy(&rgb[3 * i], &rgba[4 * i], 3);
    return 3;
}

bool write_png(const char *path, const unsigned char *rgba, int width, int height, char *message, size_t message_size) {
    if (width < 1 || height < 1 || (size_t)width * (size_t)height > (size_t)1 << 28)
        return refuse(message, message_size, "no image of that size can be written");
    size_t pixels = (size_t)width * (size_t)height;
    unsigned char *rgb = malloc(3 * pixels);
    if (!rgb)
        return refuse(message, message_size, "out of memory");
    int channels = (int)drop_alpha(rgba, pixels, rgb), count = 0;
    unsigned char *png =
        stbi_write_png_to_mem(channels == 3 ? rgb : rgba, width * channels, width, height, channels, &count);
    free(rgb);
    if (!png)
        return refuse(message, message_size, "out of memory");
    bool ok = write_file(path, png, (size_t)count, message, message_size);
    STBIW_FREE(png);
    return ok;
}

/* headless.h: an OpenGL context without a window, by EGL. A GPU is preferred to a software driver. */
#ifndef HEADLESS_H
#define HEADLESS_H

#include <stdbool.h>
#include <stddef.h>

typedef struct headless {
    void *display, *context, *surface; /* EGL's; surface is NULL where the driver needs none */
    const char *platform;              /* "surfaceless", "device" or "default": the one that worked */
    bool software;                     /* the driver draws on the CPU */
    int major, minor;                  /* the version found */
    bool es;
    char vendor[128], renderer[128], version[128];
} headless;

/* Creates the context and makes it current in this thread. Desktop GL is core profile. major 0: the highest version
 * there is, from 4.6 down to 3.3, or ES 3.2 down to 3.0; else that version at least. LIBGL_ALWAYS_SOFTWARE keeps it
 * from GPUs, as it does Mesa. False: nothing is left open, and message says what was tried. */
bool headless_create(headless *h, int major, int minor, bool es, char *message, size_t message_size);

/* Releases everything; a context is current no more. Twice, or after a failure, is fine. */
void headless_destroy(headless *h);

/* A GL function by name, NULL where the driver does not have it. For the get_proc of whoever asks. */
void (*headless_get_proc(const char *name))(void);

#endif

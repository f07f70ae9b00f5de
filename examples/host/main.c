/* host: a small engine of its own, without a window. It draws a battlefield into a PNG file.
 *
 *     host [--size WxH] [--time SECONDS] [--frames N] [--quiet-place] [--dump PREFIX] [--check] [--bench N] OUT.png
 *
 * --frames N    N frames, a thirtieth of a second apart; the picture is the last one
 * --quiet-place the scene without machines and soldiers
 * --dump        PREFIX.normal, .id, .depth, .picture: the last frame's targets, as their bytes are
 * --check       asks GL after every frame for what the state cache believes; differences end in exit status 2
 * --bench N     N more frames; prints the medians of their milliseconds and of the processor's, all threads together
 *
 * Needs OpenGL 4.5. The same options give the same bytes on the same driver. */
#define _POSIX_C_SOURCE 199309L
#include "headless.h"
#include "renderer.h"
#include "write_png.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

typedef struct options {
    int width, height, frames, bench;
    float seconds;
    bool quiet, check;
    const char *dump, *out;
} options;

static const char usage[] = "usage: host [--size WxH] [--time SECONDS] [--frames N] [--quiet-place] [--dump PREFIX] "
                            "[--check] [--bench N] OUT.png\n";

static bool parse(options *o, int count, char **words) {
    for (int k = 1; k < count; k++) {
        const char *word = words[k], *value = k + 1 < count ? words[k + 1] : "";
        int taken = 1;
        if (!strcmp(word, "--size") && sscanf(value, "%dx%d", &o->width, &o->height) == 2) {
        } else if (!strcmp(word, "--time") && sscanf(value, "%f", &o->seconds) == 1) {
        } else if (!strcmp(word, "--frames") && sscanf(value, "%d", &o->frames) == 1) {
        } else if (!strcmp(word, "--bench") && sscanf(value, "%d", &o->bench) == 1) {
        } else if (!strcmp(word, "--dump") && *value) {
            o->dump = value;
        } else {
            taken = 0;
            if (!strcmp(word, "--quiet-place"))
                o->quiet = true;
            else if (!strcmp(word, "--check"))
                o->check = true;
            else if (word[0] != '-' && !o->out)
                o->out = word;
            else
                return false;
        }
        k += taken;
    }
    return o->out && o->width > 0 && o->height > 0 && o->width <= 4096 && o->height <= 4096 && o->frames > 0 &&
           o->bench >= 0;
}

static camera camera_of(void) {
    float around = -0.34f, up = 0.50f, away = 51;
    camera c = {{0, 0, 0}, {1.2f, 0, 1.9f}, 0.44f, 1};
    c.eye = v3_add(c.target, v3_scale(v3(sinf(around) * cosf(up), sinf(up), cosf(around) * cosf(up)), away));
    return c;
}

/* ---- what comes out ------------------------------------------------------------------------------------------ */

static unsigned char *read_texture(GLuint texture, GLenum format, GLenum type, size_t size) {
    unsigned char *bytes = malloc(size);
    if (bytes)
        glGetTextureImage(texture, 0, format, type, (GLsizei)size, bytes);
    return bytes;
}

static bool save_picture(const renderer *r, const char *path) {
    size_t row = (size_t)r->picture.width * 4, size = row * (size_t)r->picture.height;
    unsigned char *up = read_texture(r->picture.colours[0], GL_RGBA, GL_UNSIGNED_BYTE, size), *down = malloc(size);
    char message[256] = "no memory";
    bool ok = up && down;
    for (size_t y = 0; ok && y < (size_t)r->picture.height; y++)
        memcpy(down + y * row, up + size - (y + 1) * row, row);
    ok = ok && write_png(path, down, r->picture.width, r->picture.height, message, sizeof message);
    if (!ok)
        fprintf(stderr, "host: %s: %s\n", path, message);
    free(up);
    free(down);
    return ok;
}

static bool dump_texture(const char *prefix, const char *what, GLuint texture, GLenum format, GLenum type,
                         size_t size) {
    char path[1024];
    unsigned char *bytes = read_texture(texture, format, type, size);
    snprintf(path, sizeof path, "%s.%s", prefix, what);
    FILE *file = bytes ? fopen(path, "wb") : NULL;
    bool ok = file && fwrite(bytes, 1, size, file) == size;
    if (file)
        ok = fclose(file) == 0 && ok;
    if (!ok)
        fprintf(stderr, "host: %s cannot be written\n", path);
    free(bytes);
    return ok;
}

static bool dump_targets(const renderer *r, const char *prefix) {
    const gpu_target *t = &r->world_target;
    size_t pixels = (size_t)t->width * (size_t)t->height;
    return dump_texture(prefix, "normal", t->colours[1], GL_RG, GL_HALF_FLOAT, 4 * pixels) &&
           dump_texture(prefix, "id", t->colours[2], GL_RED_INTEGER, GL_UNSIGNED_SHORT, 2 * pixels) &&
           dump_texture(prefix, "depth", t->depth, GL_DEPTH_COMPONENT, GL_FLOAT, 4 * pixels) &&
           dump_texture(prefix, "picture", r->picture.colours[0], GL_RGBA, GL_UNSIGNED_BYTE,
                        (size_t)r->picture.width * (size_t)r->picture.height * 4);
}

/* ---- frames -------------------------------------------------------------------------------------------------- */

static int draw_frames(renderer *r, world *w, const options *o, const camera *c) {
    int wrong = 0;
    for (int k = 0; k < o->frames; k++) {
        world_update(w, o->seconds + (float)k / 30);
        renderer_draw(r, w, c);
        if (o->check)
            wrong += gpu_verify(&r->cache, "after a frame");
    }
    return wrong;
}

static int by_size(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double milliseconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static double median(double *values, int count) {
    qsort(values, (size_t)count, sizeof *values, by_size);
    return values[count / 2];
}

static void measure(renderer *r, const world *w, int frames, const camera *c) {
    double *times = calloc(2 * (size_t)frames, sizeof *times), *busy = times + frames;
    glFinish();
    for (int k = 0; times && k < frames; k++) {
        double start = milliseconds();
        clock_t processor = clock();
        renderer_draw(r, w, c);
        glFinish();
        times[k] = milliseconds() - start;
        busy[k] = 1e3 * (double)(clock() - processor) / CLOCKS_PER_SEC;
    }
    if (times)
        printf("host: %dx%d, medians of %d frames: %.1f ms, %.1f ms of processors\n", r->picture.width,
               r->picture.height, frames, median(times, frames), median(busy, frames));
    free(times);
}

static int run(const options *o) {
    static renderer r;
    static world w;
    camera c = camera_of();
    if (!renderer_create(&r, o->width, o->height)) {
        fprintf(stderr, "host: OpenGL 4.5 is needed\n");
        return 1;
    }
    world_create(&w, !o->quiet, r.instance_buffer);
    int wrong = draw_frames(&r, &w, o, &c);
    if (o->check)
        printf("host: %u changes of state asked for, %u sent to GL, %d behind the cache's back\n", r.cache.asked,
               r.cache.sent, wrong);
    bool ok = save_picture(&r, o->out) && (!o->dump || dump_targets(&r, o->dump));
    if (o->bench)
        measure(&r, &w, o->bench, &c);
    world_destroy(&w);
    renderer_destroy(&r);
    return !ok ? 1 : wrong ? 2 : 0;
}

int main(int argc, char **argv) {
    options o = {.width = 1280, .height = 800, .frames = 1, .seconds = 0.4f};
    headless h;
    char message[512];
    if (!parse(&o, argc, argv)) {
        fputs(usage, stderr);
        return 1;
    }
    if (!headless_create(&h, 4, 5, false, message, sizeof message)) {
        fprintf(stderr, "host: no context: %s\n", message);
        return 1;
    }
    int status = run(&o);
    headless_destroy(&h);
    return status;
}

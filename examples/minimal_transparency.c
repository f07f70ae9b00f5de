/* cc minimal_transparency.c -o minimal_transparency -lEGL -lGLESv2 -lm     (needs transparency.h beside it or -I)
 *
 * An opaque box within a transparent ball, without a window, into minimal_transparency.ppm. The ball turns opaque
 * toward its silhouette, which a formula gives here; silhouette.h finds that of any mesh. */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#define TRANSPARENCY_IMPLEMENTATION
#define TR_GL_STATIC
#include "transparency.h"

enum { SIZE = 512, RINGS = 64, SECTORS = 128, BALL = RINGS * SECTORS * 6, BOX = 36 };
typedef struct vertex {
    float position[3], normal[3], distance;
} vertex;
static vertex vertices[BALL + BOX];
static unsigned char pixels[SIZE * SIZE * 4];

static bool make_context(void) {
    static const EGLint config[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT,
                                    EGL_NONE};
    static const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE};
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    EGLConfig chosen;
    EGLint count = 0;
    if (!eglInitialize(display, NULL, NULL) && !eglInitialize(display = eglGetDisplay(EGL_DEFAULT_DISPLAY), NULL, NULL))
        return false;
    if (!eglChooseConfig(display, config, &chosen, 1, &count) || count == 0 || !eglBindAPI(EGL_OPENGL_ES_API))
        return false;
    EGLContext context = eglCreateContext(display, chosen, EGL_NO_CONTEXT, version);
    return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

/* A point of the unit ball seen along z: its silhouette is the circle z = 0. */
static vertex ball_vertex(int ring, int sector) {
    const double pi = 3.14159265358979323846;
    double polar = pi * ring / RINGS, turn = 2.0 * pi * sector / SECTORS;
    double x = sin(polar) * cos(turn), y = sin(polar) * sin(turn), z = cos(polar);
    double away = 1.0 - sqrt(x * x + y * y);
    vertex v = {{(float)x, (float)y, (float)z}, {(float)x, (float)y, (float)z}, (float)sqrt(away * away + z * z)};
    return v;
}

/* Turned about two axes, so that three sides of the box show. */
static void turn(float v[3]) {
    float x = 0.82f * v[0] + 0.57f * v[2], z = 0.82f * v[2] - 0.57f * v[0];
    float y = 0.90f * v[1] - 0.44f * z;
    v[2] = 0.90f * z + 0.44f * v[1];
    v[0] = x;
    v[1] = y;
}

static void make_vertices(void) {
    static const int corner[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    vertex *out = vertices;
    for (int ring = 0; ring < RINGS; ++ring)
        for (int sector = 0; sector < SECTORS; ++sector)
            for (int c = 0; c < 6; ++c)
                *out++ = ball_vertex(ring + corner[c][0], sector + corner[c][1]);
    for (int side = 0; side < 6; ++side) { /* the box: each side is a square about its normal */
        int axis = side / 2;
        float sign = side % 2 ? -1.0f : 1.0f;
        for (int c = 0; c < 6; ++c) {
            vertex v = {{0}, {0}, 0};
            v.normal[axis] = sign;
            v.position[axis] = 0.4f * sign;
            v.position[(axis + 1) % 3] = corner[c][0] ? 0.4f * sign : -0.4f * sign;
            v.position[(axis + 2) % 3] = corner[c][1] ? 0.4f : -0.4f;
            turn(v.position);
            turn(v.normal);
            *out++ = v;
        }
    }
}

static void make_target(void) {
    GLuint names[2], framebuffer, array, buffer;
    glGenRenderbuffers(2, names);
    glBindRenderbuffer(GL_RENDERBUFFER, names[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, SIZE, SIZE);
    glBindRenderbuffer(GL_RENDERBUFFER, names[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, SIZE, SIZE);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[0]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, names[1]);
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
    for (GLuint i = 0; i < 3; ++i)
        glEnableVertexAttribArray(i);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(vertex), (void *)offsetof(vertex, position));
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(vertex), (void *)offsetof(vertex, normal));
    glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, sizeof(vertex), (void *)offsetof(vertex, distance));
}

int main(void) {
    static const tr_object objects[2] = {{1, TR_TRANSPARENT}, {2, TR_OPAQUE}};
#define VIEW                                                                                                           \
    {0.8f, 0, 0, 0, 0, 0.8f, 0, 0, 0, 0, -0.5f, 0, 0, 0, 0, 1}, {                                                      \
        1, 0, 0, 0, 1, 0, 0, 0, 1                                                                                      \
    } /* along -z */
    static const tr_material materials[2] = {{VIEW, {0.45f, 0.60f, 0.80f, 1}, 1.0f, 0.8f, {0}, 0, 0, 1},
                                             {VIEW, {0.90f, 0.45f, 0.15f, 1}, 0, 0, {0}, 0, 0, 2}};
    static const int first[2] = {0, BALL}, count[2] = {BALL, BOX};
    tr_desc desc = {0};
    tr_frame frame = {0};
    tr_pass pass;
    if (!make_context())
        return fprintf(stderr, "minimal_transparency: no OpenGL ES 3 context\n"), 1;
    make_vertices();
    make_target();
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    tr_result result;
    tr_context *tr = tr_create(&desc, &result);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, (GLint *)&frame.framebuffer);
    frame.width = frame.height = SIZE;
    frame.scene = tr_scene_count(objects, 2, sizeof objects[0]);
    if (!tr || (result = tr_begin(tr, &frame)) != TR_OK)
        return fprintf(stderr, "minimal_transparency: %s\n", tr_result_string(result)), 1;
    while (tr_next_pass(tr, &pass)) {
        for (int i = 0; i < 2; ++i) {
            if (tr_pass_draws(&pass, &objects[i])) {
                tr_set_material(tr, &pass, &materials[i]);
                glDrawArrays(GL_TRIANGLES, first[i], count[i]);
            }
        }
    }
    tr_end(tr);
    tr_destroy(tr);
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    FILE *file = fopen("minimal_transparency.ppm", "wb");
    if (!file)
        return perror("minimal_transparency.ppm"), 1;
    fprintf(file, "P6 %d %d 255\n", SIZE, SIZE);
    for (int y = SIZE - 1; y >= 0; --y)
        for (int x = 0; x < SIZE; ++x)
            fwrite(&pixels[(y * SIZE + x) * 4], 1, 3, file);
    return fclose(file) != 0;
}

/* cc minimal_oit.c -o minimal_oit -lEGL -lGLESv2 -lm     (needs oit_buffers.h beside it or -I)
 *
 * Three glass balls, one in another and one through both, around an opaque rod, without a window, into minimal_oit.ppm.
 * They are drawn in no order; the program at the end tells what the picture needed. */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl31.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#define OIT_BUFFERS_IMPLEMENTATION
#define OIT_GL_STATIC
#include "oit_buffers.h"

enum { SIZE = 512, RINGS = 64, SECTORS = 128, BALL = RINGS * SECTORS * 6 };
static float vertices[BALL][3]; /* of the unit ball, whose normals are its points */
static unsigned char pixels[SIZE * SIZE * 4];

static bool make_context(void) {
    static const EGLint config[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT,
                                    EGL_NONE};
    static const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 1, EGL_NONE};
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

static void make_ball(void) {
    static const int corner[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    GLuint array, buffer;
    for (int i = 0; i < BALL; ++i) {
        const int *c = corner[i % 6];
        double polar = 3.14159265358979 * (i / 6 / SECTORS + c[0]) / RINGS;
        double turn = 6.28318530717959 * (i / 6 % SECTORS + c[1]) / SECTORS;
        vertices[i][0] = (float)(sin(polar) * cos(turn));
        vertices[i][1] = (float)(sin(polar) * sin(turn));
        vertices[i][2] = (float)cos(polar);
    }
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
    for (GLuint i = 0; i < 2; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 0, NULL);
    }
}

static GLuint make_target(void) {
    GLuint names[2], framebuffer;
    glGenRenderbuffers(2, names);
    glBindRenderbuffer(GL_RENDERBUFFER, names[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, SIZE, SIZE);
    glBindRenderbuffer(GL_RENDERBUFFER, names[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, SIZE, SIZE);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[0]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, names[1]);
    return framebuffer;
}

/* The host's own opaque thing: a scissored clear is a grey rod, with the depth of the middle. */
static void draw_opaque(void) {
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, SIZE / 2 - 20, SIZE, 40);
    glClearColor(0.35f, 0.35f, 0.4f, 1);
    glClearDepthf(0.5f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

int main(void) {
    static const float balls[3][4] = {{0, 0, 0, 0.85f}, {-0.2f, 0.1f, 0.1f, 0.4f}, {0.35f, -0.1f, -0.3f, 0.45f}};
    static const float colors[3][4] = {{0.3f, 0.6f, 0.9f, 0.3f}, {0.9f, 0.5f, 0.2f, 0.5f}, {0.3f, 0.8f, 0.3f, 0.4f}};
    oit_desc desc = {0};
    oit_frame frame = {0};
    oit_report report;
    oit_pass pass;
    oit_result result;
    if (!make_context())
        return fprintf(stderr, "minimal_oit: no OpenGL ES 3.1 context\n"), 1;
    oit_context *oit = oit_create(&desc, &result);
    if (!oit)
        return fprintf(stderr, "minimal_oit: %s\n", oit_result_string(result)), 1;
    frame.framebuffer = make_target();
    frame.width = frame.height = SIZE;
    frame.light[0] = -0.4f;
    frame.light[1] = frame.light[2] = 0.7f;
    draw_opaque();
    make_ball();
    result = oit_begin(oit, &frame);
    while (oit_next_pass(oit, &pass)) {
        for (int i = 0; i < 3; ++i) {
            const float *b = balls[i], r = b[3];
            oit_material material = {{r, 0, 0, 0, 0, r, 0, 0, 0, 0, -r, 0, b[0], b[1], -b[2], 1}, /* along -z */
                                     {1, 0, 0, 0, 1, 0, 0, 0, 1},
                                     {colors[i][0], colors[i][1], colors[i][2], colors[i][3]},
                                     0,
                                     0,
                                     OIT_BLEND_OVER,
                                     0};
            oit_set_material(oit, &pass, &material);
            glDrawArrays(GL_TRIANGLES, 0, BALL);
        }
    }
    if (result == OIT_OK) {
        oit_compose(oit);
        result = oit_end(oit);
    }
    if (result != OIT_OK)
        return fprintf(stderr, "minimal_oit: %s\n", oit_result_string(result)), 1;
    oit_get_report(oit, &report);
    printf("%u fragments, up to %u in a pixel\n", (unsigned)report.needed, (unsigned)report.deepest);
    oit_destroy(oit);
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    FILE *file = fopen("minimal_oit.ppm", "wb");
    if (!file)
        return perror("minimal_oit.ppm"), 1;
    fprintf(file, "P6 %d %d 255\n", SIZE, SIZE);
    for (int y = SIZE - 1; y >= 0; --y)
        for (int x = 0; x < SIZE; ++x)
            fwrite(&pixels[(y * SIZE + x) * 4], 1, 3, file);
    return fclose(file) != 0;
}

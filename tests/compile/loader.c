/* loader.c: one frame of transparency.h, its GL functions from where LOADER_* says; loaders runs it for each.
 *
 *     loader FILE     writes the picture's bytes: glass before an opaque box's side, which it tints */
#if defined(LOADER_PROTOTYPES)
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
#elif defined(LOADER_GLEW)
#include <GL/glew.h>
#elif defined(LOADER_EPOXY)
#include <epoxy/gl.h>
#elif defined(LOADER_GLES)
#include <GLES3/gl32.h>
#else /* glad, and LOADER_GET_PROC, where the test's own calls are glad's and the header's are not */
#include <EGL/egl.h>
#define GLAD_GL_IMPLEMENTATION
#include <glad/gl.h>
#endif

#ifndef LOADER_GET_PROC
#define TR_GL_STATIC
#endif
#define TRANSPARENCY_IMPLEMENTATION
#include "transparency.h"
#include "headless.h"

#include <stdio.h>

enum { SIZE = 64 };

/* What the loader wants before its names can be used. */
static bool load(void) {
#if defined(LOADER_GLEW)
    glewExperimental = GL_TRUE;
    GLenum result = glewInit();
    return result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY; /* the latter once all of GL is there */
#elif defined(LOADER_GLAD) || defined(LOADER_GET_PROC)
    return gladLoadGL((GLADloadfunc)headless_get_proc) != 0;
#else
    return true;
#endif
}

static void make_target(void) {
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
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/* Two squares, seen from the front: the glass one from -0.8 to 0.4, the opaque one, behind, from -0.2 to 0.8. */
static void make_squares(void) {
    static const float corners[2][2] = {{-0.8f, 0.4f}, {-0.2f, 0.8f}};
    static const int corner[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    float vertices[12][3];
    GLuint array, buffer;
    for (int i = 0; i < 12; ++i) {
        for (int k = 0; k < 2; ++k)
            vertices[i][k] = corners[i / 6][corner[i % 6][k]];
        vertices[i][2] = i < 6 ? -0.5f : 0.5f;
    }
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, NULL);
}

static tr_result draw(tr_context *tr) {
    static const tr_object objects[2] = {{1, TR_TRANSPARENT | TR_TWO_SIDED}, {2, TR_OPAQUE | TR_TWO_SIDED}};
    static const float colors[2][4] = {{0.2f, 0.4f, 0.9f, 0.5f}, {0.9f, 0.5f, 0.1f, 1}};
    tr_frame frame = {0};
    tr_pass pass;
    GLint framebuffer = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    frame.framebuffer = (uint32_t)framebuffer;
    frame.width = frame.height = SIZE;
    frame.scene = tr_scene_count(objects, 2, sizeof objects[0]);
    frame.flat_shading = 1;
    tr_result result = tr_begin(tr, &frame);
    while (tr_next_pass(tr, &pass))
        for (int i = 0; i < 2; ++i)
            if (tr_pass_draws(&pass, &objects[i])) {
                tr_material material;
                memset(&material, 0, sizeof material);
                for (int k = 0; k < 4; ++k)
                    material.model_view_projection[5 * k] = 1;
                for (int k = 0; k < 3; ++k)
                    material.normal_matrix[4 * k] = 1;
                memcpy(material.color, colors[i], sizeof colors[i]);
                material.object = objects[i].id;
                tr_set_material(tr, &pass, &material);
                glDrawArrays(GL_TRIANGLES, 6 * i, 6);
            }
    return result == TR_OK ? tr_end(tr) : result;
}

/* Outside white; glass over white, 0.5 c + 0.5; glass over the opaque square; and that square alone. */
static bool check(unsigned char pixels[SIZE][SIZE][4]) {
    static const int wanted[4][2] = {{2, 255}, {10, 153}, {30, 140}, {50, 230}}; /* place on the diagonal, its red */
    bool fine = true;
    for (int i = 0; i < 4; ++i) {
        int found = pixels[wanted[i][0]][wanted[i][0]][0];
        if (found < wanted[i][1] - 1 || found > wanted[i][1] + 1) {
            fprintf(stderr, "loader: pixel %d is %d, should be %d\n", wanted[i][0], found, wanted[i][1]);
            fine = false;
        }
    }
    return fine;
}

int main(int argc, char **argv) {
    static unsigned char pixels[SIZE][SIZE][4];
    char message[256];
    headless h;
    tr_desc desc = {0};
    tr_result result = TR_OK;
#ifdef LOADER_GET_PROC
    desc.get_proc = headless_get_proc;
#endif
#ifdef LOADER_GLES
    bool es = true;
#else
    bool es = false;
#endif
    if (argc != 2 || !headless_create(&h, 0, 0, es, message, sizeof message))
        return fprintf(stderr, "loader: %s\n", argc == 2 ? message : "which file?"), 1;
    if (!load())
        return fprintf(stderr, "loader: no GL functions\n"), 1;
    make_target();
    make_squares();
    tr_context *tr = tr_create(&desc, &result);
    if (tr)
        result = draw(tr);
    if (result != TR_OK)
        return fprintf(stderr, "loader: %s\n", tr_result_string(result)), 1;
    printf("%d, GL error %d\n", tr_get_info(tr).version, (int)glGetError());
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    tr_destroy(tr);
    headless_destroy(&h);
    FILE *file = fopen(argv[1], "wb");
    bool written = file && fwrite(pixels, 1, sizeof pixels, file) == sizeof pixels;
    return file && fclose(file) == 0 && written && check(pixels) ? 0 : 1;
}

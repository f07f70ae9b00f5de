/* oit_setting.h: a context, an oit_context and a target of floats or bytes, single or multisampled, for the tests of what
 * oit_buffers.h gives beside the picture. */
#ifndef GLASSINE_TESTS_OIT_SETTING_H
#define GLASSINE_TESTS_OIT_SETTING_H

#include "oit_scene.h"

typedef struct oit_setting {
    harness h; /* context; its own target is not used */
    oit_context *oit;
    GLuint framebuffer, color, depth;
    int width, height, samples; /* samples 0: textures of one sample */
    int logged;
    bool quiet; /* errors are provoked now */
} oit_setting;

static inline void oit_setting_log(oit_log_level level, oit_result code, const char *text, void *user) {
    oit_setting *t = user;
    if (t->quiet)
        return;
    t->logged += level != OIT_LOG_INFO;
    printf("    log %d: %s\n", (int)code, text);
}

static inline GLuint oit_setting_texture(int width, int height, int samples, GLenum format) {
    GLenum target = samples ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    GLuint name;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    if (samples)
        glTexStorage2DMultisample(target, samples, format, width, height, GL_TRUE);
    else
        glTexStorage2D(target, 1, format, width, height);
    glBindTexture(target, 0);
    return name;
}

/* color or depth 0: none. */
static inline GLuint oit_setting_framebuffer(GLuint color, GLuint depth, int samples) {
    GLenum target = samples ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    static const GLenum none = GL_NONE;
    GLuint name;
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    if (color)
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, color, 0);
    else
        glDrawBuffers(1, &none);
    if (depth)
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, target, depth, 0);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    return name;
}

static inline void oit_setting_open(oit_setting *t, bool es, int width, int height, int samples, GLenum format,
                                    oit_desc desc) {
    oit_result result;
    memset(t, 0, sizeof *t);
    harness_open(&t->h, es ? 310 : 430, es, NULL);
    t->width = width;
    t->height = height;
    t->samples = samples;
    t->color = oit_setting_texture(width, height, samples, format);
    t->depth = oit_setting_texture(width, height, samples, GL_DEPTH_COMPONENT32F);
    t->framebuffer = oit_setting_framebuffer(t->color, t->depth, samples);
    desc.get_proc = oit_scene_get_proc;
    desc.log_fn = oit_setting_log;
    desc.log_user = t;
    desc.max_gl_version = es ? 310 : 430;
    t->oit = oit_create(&desc, &result);
    if (!t->oit)
        fail_msg("oit_create: %s", oit_result_string(result));
}

static inline void oit_setting_close(oit_setting *t) {
    oit_destroy(t->oit);
    glDeleteFramebuffers(1, &t->framebuffer);
    glDeleteTextures(1, &t->color);
    glDeleteTextures(1, &t->depth);
    assert_int_equal(t->logged, 0);
    harness_close(&t->h);
}

/* Background, and opaque objects with depth. */
static inline void oit_setting_clear(oit_setting *t, oit_scene *s) {
    float depth = s->reversed ? 0 : 1;
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glViewport(0, 0, t->width, t->height);
    glClearColor((float)s->scene.background[0], (float)s->scene.background[1], (float)s->scene.background[2], 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_DEPTH, 0, &depth);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(s->reversed ? GL_GREATER : GL_LESS);
    oit_scene_draw_plain(s, t->h.context.es, false);
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
}

/* Four floats a pixel, bottom row first; of a framebuffer of one sample. */
static inline float *oit_setting_read(const oit_setting *t, GLuint framebuffer) {
    float *picture = malloc(4 * (size_t)t->width * (size_t)t->height * sizeof *picture);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glReadPixels(0, 0, t->width, t->height, GL_RGBA, GL_FLOAT, picture);
    return picture;
}

#endif

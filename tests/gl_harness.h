/* gl_harness.h: what the GL tests share: a context without a window, a target, objects from plain arrays, and pictures
 * compared with the reference. */
#ifndef GLASSINE_TESTS_GL_HARNESS_H
#define GLASSINE_TESTS_GL_HARNESS_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <EGL/egl.h>

#define GLAD_GL_IMPLEMENTATION
#define GLAD_GLES2_IMPLEMENTATION
#include <glad/gl.h>

#include "headless.h"
#include "reference.h"
#define TRANSPARENCY_IMPLEMENTATION
#include "transparency.h"

/* ---- context and target ---- */

typedef struct harness {
    headless context;
    GLuint framebuffer, color, depth;
    int width, height;
    tr_context *tr;
    int debug_messages; /* of KHR_debug, notifications left out */
    int logged;         /* errors and warnings that transparency.h logged */
    bool quiet;         /* errors are provoked now: KHR_debug's are not counted, nothing is printed */
} harness;

static inline tr_proc harness_get_proc(const char *name) {
    return (tr_proc)eglGetProcAddress(name);
}

static inline void harness_log(tr_log_level level, tr_result code, const char *text, void *user) {
    harness *h = user;
    h->logged += level != TR_LOG_INFO;
    if (!h->quiet)
        printf("    log %d: %s\n", (int)code, text);
}

static inline void GLAD_API_PTR harness_debug(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                              const GLchar *text, const void *user) {
    (void)source, (void)type, (void)id, (void)length;
    /* The harness outlives the context; GL hands user back as const. */
    harness *h = (harness *)(uintptr_t)user;
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION || h->quiet)
        return;
    ++h->debug_messages;
    printf("    KHR_debug: %s\n", text);
}

/* GLASSINE_MAX_GL=330 and GLASSINE_MAX_ES=300 run the tests on drivers that have no more than GL 3.3 and ES 3.0. With the
 * former alone ES 3.1 is the most: softpipe's. */
static inline int harness_version(int version, bool es) {
    const char *most_gl = getenv("GLASSINE_MAX_GL"), *most_es = getenv("GLASSINE_MAX_ES");
    int most = es ? (most_es ? atoi(most_es) : most_gl ? 310 : 0) : most_gl ? atoi(most_gl) : 0;
    return most && version > most ? most : version;
}

/* A context of exactly what is asked for where the driver allows it, and a transparency.h capped to that version. */
static inline void harness_open(harness *h, int version, bool es, const tr_desc *options) {
    char message[256];
    tr_result result;
    tr_desc desc = {0};
    if (options)
        desc = *options;
    version = harness_version(version, es);
    memset(h, 0, sizeof *h);
    if (!headless_create(&h->context, version / 100, version / 10 % 10, es, message, sizeof message))
        fail_msg("no GL context: %s", message);
    if (!(es ? gladLoadGLES2 : gladLoadGL)((GLADloadfunc)eglGetProcAddress))
        fail_msg("glad found no GL");
    if (glDebugMessageCallback) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(harness_debug, h);
    }
    desc.get_proc = harness_get_proc;
    desc.log_fn = harness_log;
    desc.log_user = h;
    desc.max_gl_version = version;
    h->tr = tr_create(&desc, &result);
    if (!h->tr)
        fail_msg("tr_create: %s", tr_result_string(result));
}

static inline void harness_drop_target(harness *h) {
    glDeleteFramebuffers(1, &h->framebuffer);
    glDeleteTextures(1, &h->color);
    glDeleteTextures(1, &h->depth);
    h->framebuffer = h->color = h->depth = 0;
}

static inline void harness_close(harness *h) {
    tr_destroy(h->tr);
    harness_drop_target(h);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    assert_int_equal(h->debug_messages, 0);
    headless_destroy(&h->context);
}

static inline void harness_target(harness *h, int width, int height) {
    harness_drop_target(h);
    h->width = width;
    h->height = height;
    glGenTextures(1, &h->color);
    glBindTexture(GL_TEXTURE_2D, h->color);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glGenTextures(1, &h->depth);
    glBindTexture(GL_TEXTURE_2D, h->depth);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, width, height, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    glGenFramebuffers(1, &h->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, h->color, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, h->depth, 0);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
}

/* ---- objects ---- */

typedef struct harness_object {
    tr_object object; /* first: tr_scene_count reads it */
    ref_object truth;
    GLuint array, buffers[3];
    bool mirrored;
} harness_object;

/* distances: attribute 2 of each vertex, or NULL. The arrays of truth stay the caller's. */
static inline void harness_upload(harness_object *o, const float *distances) {
    const ref_object *t = &o->truth;
    const double *m = t->model;
    o->object.id = t->id;
    o->object.flags = (t->transparent ? TR_TRANSPARENT : 0u) | (t->two_sided ? TR_TWO_SIDED : 0u) | TR_GROUP(t->group) |
                      (t->method == 1   ? TR_IMPLICIT
                       : t->method == 2 ? TR_EXPLICIT
                                        : 0u);
    o->mirrored =
        m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) + m[8] * (m[1] * m[6] - m[2] * m[5]) <
        0;
    glGenVertexArrays(1, &o->array);
    glBindVertexArray(o->array);
    glGenBuffers(3, o->buffers);
    glBindBuffer(GL_ARRAY_BUFFER, o->buffers[0]);
    size_t bytes = t->vertex_count * 3 * sizeof(float);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(2 * bytes + t->vertex_count * sizeof(float)), NULL, GL_STATIC_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)bytes, t->positions);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, NULL);
    if (t->normals) {
        glBufferSubData(GL_ARRAY_BUFFER, (GLintptr)bytes, (GLsizeiptr)bytes, t->normals);
        glEnableVertexAttribArray(1);
        glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 0, (const void *)bytes);
    }
    if (distances) {
        glBufferSubData(GL_ARRAY_BUFFER, (GLintptr)(2 * bytes), (GLsizeiptr)(t->vertex_count * sizeof(float)),
                        distances);
        glEnableVertexAttribArray(2);
        glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, 0, (const void *)(2 * bytes));
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, o->buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(t->triangle_count * 3 * sizeof(uint32_t)), t->indices,
                 GL_STATIC_DRAW);
    glBindVertexArray(0);
}

static inline void harness_drop_object(harness_object *o) {
    glDeleteVertexArrays(1, &o->array);
    glDeleteBuffers(3, o->buffers);
}

static inline void harness_multiply(const double a[16], const double b[16], double out[16]) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) {
            double sum = 0;
            for (int k = 0; k < 4; ++k)
                sum += a[4 * k + r] * b[4 * c + k];
            out[4 * c + r] = sum;
        }
}

/* Cofactors: the inverse transpose up to a positive factor. */
static inline void harness_normal_matrix(const double m[16], float out[9]) {
    double det =
        m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) + m[8] * (m[1] * m[6] - m[2] * m[5]);
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) {
            int a = (r + 1) % 3, b = (r + 2) % 3;
            const double *p = m + 4 * ((c + 1) % 3), *q = m + 4 * ((c + 2) % 3);
            out[3 * c + r] = (float)((det < 0 ? -1 : 1) * (p[a] * q[b] - p[b] * q[a]));
        }
}

static inline void harness_material(const ref_scene *scene, const ref_object *t, tr_material *material) {
    double view_projection[16], mvp[16];
    memset(material, 0, sizeof *material);
    harness_multiply(scene->projection, scene->view, view_projection);
    harness_multiply(view_projection, t->model, mvp);
    for (int i = 0; i < 16; ++i)
        material->model_view_projection[i] = (float)mvp[i];
    harness_normal_matrix(t->model, material->normal_matrix);
    for (int i = 0; i < 3; ++i)
        material->color[i] = (float)t->color[i];
    material->color[3] = (float)t->alpha;
    material->object = t->id;
}

typedef struct harness_options {
    int x, y;           /* viewport's corner in the target */
    const float *d_max; /* per object, or NULL */
    const float *k;
    const GLuint *programs; /* the host's own, by rule, or NULL; then draw_own sets its uniforms */
    void (*set_own)(GLuint program, const tr_material *material);
    int passes;                      /* out: how many passes asked for surfaces */
    void (*change)(tr_frame *frame); /* what the scene does not say, or NULL */
} harness_options;

static inline tr_frame harness_frame(const harness *h, const ref_scene *scene, const harness_object *objects,
                                     size_t count) {
    tr_frame frame = {0};
    static const tr_interior interiors[4] = {TR_INTERIOR_IMPLICIT, TR_INTERIOR_IMPLICIT_PUBLISHED, TR_INTERIOR_EXPLICIT,
                                             TR_INTERIOR_LAYERS};
    static const tr_blending blendings[3] = {TR_BLENDING_PUBLISHED, TR_BLENDING_NORMALISED, TR_BLENDING_OVER};
    bool shaded = false;
    for (size_t i = 0; i < count; ++i)
        shaded = shaded || objects[i].truth.cool_to_warm;
    frame.framebuffer = h->framebuffer;
    frame.width = scene->width;
    frame.height = scene->height;
    frame.scene = tr_scene_count(objects, count, sizeof objects[0]);
    frame.wishes.blending = blendings[scene->blending];
    frame.wishes.interior = interiors[scene->interior];
    frame.wishes.alpha = TR_ALPHA_PUBLISHED; /* the reference has alpha at vertices */
    frame.wishes.layers = (uint32_t)scene->layers;
    frame.wishes.options =
        (scene->use_blend_color ? TR_WISH_BLEND_COLOR : 0u) | (scene->srgb ? (uint32_t)TR_WISH_SRGB : 0u);
    frame.group_distance = (float)scene->group_distance;
    if (scene->enter_reach > 0)
        frame.wishes.options |= TR_WISH_ENTERING;
    frame.enter_strength = scene->enter_strength > 0 ? (float)scene->enter_strength : -1.0f;
    frame.enter_distance = (float)scene->enter_reach;
    for (int i = 0; i < 16; ++i)
        frame.projection[i] = (float)scene->projection[i];
    frame.opaque_weight = scene->opaque_weight > 0 ? (float)scene->opaque_weight : -1.0f;
    frame.background_weight = scene->background_weight > 0 ? (float)scene->background_weight : -1.0f;
    frame.flat_shading = !shaded;
    for (int i = 0; i < 3; ++i) {
        frame.light[i] = (float)scene->light_direction[i];
        frame.blend_color[i] = (float)scene->blend_color[i];
        frame.cool[i] = (float)scene->cool[i];
        frame.warm[i] = (float)scene->warm[i];
    }
    frame.cool[3] = (float)scene->cool_mix;
    frame.warm[3] = (float)scene->warm_mix;
    return frame;
}

static inline void harness_clear(const harness *h, const double background[3], float depth) {
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glClearColor((float)background[0], (float)background[1], (float)background[2], 1.0f);
    if (h->context.es)
        glClearDepthf(depth);
    else
        glClearDepth((double)depth);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

/* Where opaque objects enter transparent ones, for all objects; which segments are whose. */
static inline void harness_enter(harness *h, const harness_object *objects, size_t count, size_t firsts[],
                                 size_t counts[]) {
    static tr_mesh meshes[256], others[256];
    size_t other_count = 0, total = 0;
    float *segments = NULL;
    assert_true(count <= 256);
    for (size_t i = 0; i < count; ++i) {
        const ref_object *t = &objects[i].truth;
        meshes[i].positions = t->positions;
        meshes[i].indices = t->indices;
        meshes[i].vertex_count = t->vertex_count;
        meshes[i].index_count = 3 * t->triangle_count;
        for (int k = 0; k < 16; ++k)
            meshes[i].model[k] = (float)t->model[k];
        if (t->transparent)
            others[other_count++] = meshes[i];
    }
    for (size_t i = 0; i < count; ++i) {
        bool solid = !objects[i].truth.transparent;
        firsts[i] = total;
        counts[i] = solid ? tr_crossings(&meshes[i], others, other_count, NULL, 0) : 0;
        segments = realloc(segments, (total + counts[i] + 1) * 6 * sizeof *segments);
        if (solid)
            assert_int_equal(tr_crossings(&meshes[i], others, other_count, segments + 6 * total, counts[i]), counts[i]);
        total += counts[i];
    }
    assert_int_equal(tr_set_crossings(h->tr, segments, total), TR_OK);
    free(segments);
}

/* Draws the objects in the order given and reads the picture back, four bytes a pixel, bottom row first. */
static inline void harness_draw(harness *h, const ref_scene *scene, const harness_object *objects, size_t count,
                                harness_options *options, unsigned char *pixels) {
    tr_frame frame = harness_frame(h, scene, objects, count);
    tr_pass pass;
    size_t firsts[256], counts[256];
    if (scene->enter_reach > 0)
        harness_enter(h, objects, count, firsts, counts);
    frame.x = options ? options->x : 0;
    frame.y = options ? options->y : 0;
    if (options && options->change)
        options->change(&frame);
    tr_result result = tr_begin(h->tr, &frame);
    if (result != TR_OK)
        fail_msg("tr_begin: %s", tr_result_string(result));
    while (tr_next_pass(h->tr, &pass)) {
        GLuint own = options && options->programs ? options->programs[pass.rule] : 0;
        if (options)
            ++options->passes;
        if (own)
            glUseProgram(own);
        for (size_t i = 0; i < count; ++i) {
            const harness_object *o = &objects[i];
            tr_material material;
            if (!tr_pass_draws(&pass, &o->object))
                continue;
            harness_material(scene, &o->truth, &material);
            material.object = tr_object_code(&o->object, &frame.wishes);
            for (int k = 0; k < 16; ++k)
                material.model[k] = (float)o->truth.model[k];
            material.crossing_first = scene->enter_reach > 0 ? (int)firsts[i] : 0;
            material.crossing_count = scene->enter_reach > 0 ? (int)counts[i] : 0;
            if (options && options->d_max) {
                material.d_max = options->d_max[i];
                material.k = options->k[i];
            }
            if (own)
                options->set_own(own, &material);
            else
                tr_set_material(h->tr, &pass, &material);
            glFrontFace(o->mirrored ? (pass.state.front_face == GL_CW ? GL_CCW : GL_CW) : pass.state.front_face);
            glBindVertexArray(o->array);
            glDrawElements(GL_TRIANGLES, (GLsizei)(3 * o->truth.triangle_count), GL_UNSIGNED_INT, NULL);
        }
    }
    glBindVertexArray(0);
    assert_int_equal(tr_end(h->tr), TR_OK);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    if (pixels)
        glReadPixels(frame.x, frame.y, scene->width, scene->height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

/* ---- comparison ---- */

typedef struct harness_error {
    double max, left_out;         /* max in 1/255; left_out: share of the pixels */
    size_t worst;                 /* pixel */
    size_t blended, seen_through; /* compared pixels with a blended surface; with an opaque thing behind it */
} harness_error;

static inline harness_error harness_compare(const ref_scene *scene, const ref_pixel *truth,
                                            const unsigned char *pixels) {
    harness_error error = {0, 0, 0, 0, 0};
    size_t count = (size_t)scene->width * (size_t)scene->height, left = 0;
    for (size_t i = 0; i < count; ++i) {
        if (truth[i].left_out) {
            ++left;
            continue;
        }
        error.blended += truth[i].front_object != 0;
        error.seen_through += truth[i].front_object != 0 && truth[i].opaque_object != 0;
        for (int c = 0; c < 3; ++c) {
            double difference = fabs(truth[i].color[c] * 255.0 - pixels[4 * i + (size_t)c]);
            if (difference > error.max) {
                error.max = difference;
                error.worst = i;
            }
        }
    }
    error.left_out = count ? (double)left / (double)count : 0;
    return error;
}

/* Prints the share left out and the passes that ran; error at most 2/255, share at most 10 %. */
static inline void harness_check(harness *h, const char *name, const ref_scene *scene, const ref_pixel *truth,
                                 const unsigned char *pixels) {
    harness_error error = harness_compare(scene, truth, pixels);
    const tr_plan *plan = tr_get_info(h->tr).plan;
    printf("    %-36s max %.2f/255, %4.1f %% left out, %zu blended, %zu seen through; passes:", name, error.max,
           100 * error.left_out, error.blended, error.seen_through);
    for (int i = 0; i < plan->pass_count; ++i)
        printf(" %s", tr_pass_kind_name(plan->passes[i].kind));
    printf("\n");
    if (error.max > 2.0) {
        const ref_pixel *p = &truth[error.worst];
        const unsigned char *q = &pixels[4 * error.worst];
        fail_msg("%s: pixel %zu, %zu is %d %d %d, should be %.1f %.1f %.1f (front %u, opaque %u)", name,
                 error.worst % (size_t)scene->width, error.worst / (size_t)scene->width, q[0], q[1], q[2],
                 p->color[0] * 255, p->color[1] * 255, p->color[2] * 255, p->front_object, p->opaque_object);
    }
    assert_true(error.left_out <= 0.10);
}

#endif

/* oit_scene.h: scenes of many layers for the tests and the benchmark of oit_buffers.h, drawn by its built-in program, and
 * what they should look like: all hits of a ray through each pixel (reference.h), sorted and blended back to front in
 * double. Shares no code with the header. */
#ifndef GLASSINE_TESTS_OIT_SCENE_H
#define GLASSINE_TESTS_OIT_SCENE_H

#include "gl_harness.h"

#define OIT_BUFFERS_IMPLEMENTATION
#include "oit_buffers.h"

enum { OIT_SCENE_MAX = 1024 };

typedef struct oit_scene_object {
    uint32_t part, key, blend;
    float *positions, *normals;
    uint32_t *indices;
    GLuint array, buffers[2];
} oit_scene_object;

typedef struct oit_scene {
    ref_scene scene;
    ref_object truths[OIT_SCENE_MAX];
    oit_scene_object objects[OIT_SCENE_MAX];
    size_t count, triangles;
    bool reversed; /* near is 1, far is 0, by glClipControl */
    GLuint plain;  /* program for opaque things and for blending without a buffer */
    GLint plain_matrix, plain_color;
} oit_scene;

/* ---- objects ---- */

static const double oit_scene_identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

static inline void oit_scene_init(oit_scene *s, int width, int height) {
    memset(s, 0, sizeof *s);
    s->scene.width = width;
    s->scene.height = height;
    for (int k = 0; k < 3; ++k)
        s->scene.background[k] = 1.0;
    s->scene.background_weight = 1.0;
    s->scene.objects = s->truths;
    memcpy(s->scene.view, oit_scene_identity, sizeof oit_scene_identity);
    memcpy(s->scene.projection, oit_scene_identity, sizeof oit_scene_identity);
}

/* The arrays are malloc'd and become the scene's. */
static inline size_t oit_scene_add(oit_scene *s, float *positions, float *normals, size_t vertices, uint32_t *indices,
                                   size_t triangles, const double color[4]) {
    assert_true(s->count < OIT_SCENE_MAX);
    size_t at = s->count++;
    oit_scene_object *o = &s->objects[at];
    ref_object *t = &s->truths[at];
    memset(o, 0, sizeof *o);
    memset(t, 0, sizeof *t);
    o->part = t->id = (uint32_t)at + 1;
    o->positions = positions;
    o->normals = normals;
    o->indices = indices;
    memcpy(t->model, oit_scene_identity, sizeof t->model);
    t->positions = positions;
    t->indices = indices;
    t->vertex_count = vertices;
    t->triangle_count = triangles;
    t->transparent = true;
    memcpy(t->color, color, 3 * sizeof(double));
    t->alpha = color[3];
    s->triangles += triangles;
    s->scene.object_count = s->count;
    glGenVertexArrays(1, &o->array);
    glBindVertexArray(o->array);
    glGenBuffers(2, o->buffers);
    glBindBuffer(GL_ARRAY_BUFFER, o->buffers[0]);
    GLsizeiptr bytes = (GLsizeiptr)(3 * vertices * sizeof(float));
    glBufferData(GL_ARRAY_BUFFER, 2 * bytes, NULL, GL_STATIC_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, positions);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, NULL);
    if (normals) {
        glBufferSubData(GL_ARRAY_BUFFER, bytes, bytes, normals);
        glEnableVertexAttribArray(1);
        glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 0, (const void *)bytes);
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, o->buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(3 * triangles * sizeof(uint32_t)), indices, GL_STATIC_DRAW);
    glBindVertexArray(0);
    return at;
}

static inline void oit_scene_drop(oit_scene *s) {
    for (size_t i = 0; i < s->count; ++i) {
        glDeleteVertexArrays(1, &s->objects[i].array);
        glDeleteBuffers(2, s->objects[i].buffers);
        free(s->objects[i].positions);
        free(s->objects[i].normals);
        free(s->objects[i].indices);
    }
    if (s->plain)
        glDeleteProgram(s->plain);
    memset(s, 0, sizeof *s);
}

/* A sheet through four corners at depths z (in normalised device coordinates under the identity), two triangles. */
static inline size_t oit_scene_quad(oit_scene *s, double left, double bottom, double right, double top,
                                    const double z[4], const double color[4]) {
    const double corners[4][2] = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
    static const uint32_t order[6] = {0, 1, 2, 0, 2, 3};
    float *positions = malloc(12 * sizeof *positions);
    uint32_t *indices = malloc(sizeof order);
    memcpy(indices, order, sizeof order);
    for (int i = 0; i < 4; ++i) {
        positions[3 * i] = (float)corners[i][0];
        positions[3 * i + 1] = (float)corners[i][1];
        positions[3 * i + 2] = (float)z[i];
    }
    return oit_scene_add(s, positions, NULL, 4, indices, 2, color);
}

static inline size_t oit_scene_ball(oit_scene *s, const double center[3], double radius, int rings, int sectors,
                                    const double color[4]) {
    size_t vertices = (size_t)(rings + 1) * (size_t)sectors, count = 0;
    float *positions = malloc(3 * vertices * sizeof(float)), *normals = malloc(3 * vertices * sizeof(float));
    uint32_t *indices = malloc(6 * vertices * sizeof *indices);
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            double polar = 3.14159265358979324 * i / rings, turn = 6.28318530717958648 * j / sectors;
            const double d[3] = {sin(polar) * cos(turn), cos(polar), -sin(polar) * sin(turn)};
            for (int k = 0; k < 3; ++k) {
                positions[3 * (i * sectors + j) + k] = (float)(center[k] + radius * d[k]);
                normals[3 * (i * sectors + j) + k] = (float)d[k];
            }
        }
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            uint32_t a = (uint32_t)(i * sectors + j), b = (uint32_t)(i * sectors + (j + 1) % sectors);
            uint32_t c = a + (uint32_t)sectors, d = b + (uint32_t)sectors;
            const uint32_t first[3] = {a, c, d}, second[3] = {a, d, b};
            if (i + 1 < rings) /* at the poles one of the two has no area */
                memcpy(indices + 3 * count++, first, sizeof first);
            if (i > 0)
                memcpy(indices + 3 * count++, second, sizeof second);
        }
    return oit_scene_add(s, positions, normals, vertices, indices, count, color);
}

/* The same numbers on every machine. */
static inline double oit_scene_random(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return (double)(*state >> 8) / 16777216.0;
}

static inline void oit_scene_camera(oit_scene *s, double distance, double first, double last, double half) {
    double *v = s->scene.view, *p = s->scene.projection;
    memcpy(v, oit_scene_identity, sizeof oit_scene_identity);
    v[14] = -distance;
    memset(p, 0, sizeof s->scene.projection);
    p[0] = p[5] = 1 / half;
    p[10] = -(last + first) / (last - first);
    p[11] = -1;
    p[14] = -2 * last * first / (last - first);
}

/* `layers` sheets over the whole picture, from back to front in no order. */
static inline void oit_scene_sheets(oit_scene *s, int layers, double alpha, bool tilted) {
    uint32_t state = 7;
    for (int i = 0; i < layers; ++i) {
        int at = (int)((unsigned)i * 7919u % (unsigned)layers); /* a prime: each once */
        double z = -0.9 + 1.8 * (at + 0.5) / layers, tilt = tilted ? 3.0 / layers : 0;
        double zs[4], color[4] = {0, 0, 0, alpha};
        for (int k = 0; k < 4; ++k)
            zs[k] = z + tilt * (oit_scene_random(&state) - 0.5);
        for (int k = 0; k < 3; ++k)
            color[k] = oit_scene_random(&state);
        oit_scene_quad(s, -1, -1, 1, 1, zs, color);
    }
}

static inline void oit_scene_concentric(oit_scene *s, int balls, int rings, double alpha) {
    uint32_t state = 7;
    const double center[3] = {0, 0, 0};
    oit_scene_camera(s, 4, 0.5, 8, 0.268);
    for (int i = 0; i < balls; ++i) {
        double color[4] = {0, 0, 0, alpha};
        for (int k = 0; k < 3; ++k)
            color[k] = oit_scene_random(&state);
        oit_scene_ball(s, center, 0.1 + 0.9 * (i + 1) / balls, rings, rings, color);
    }
}

static inline void oit_scene_random_balls(oit_scene *s, int balls, int rings, double alpha) {
    uint32_t state = 7;
    oit_scene_camera(s, 4, 0.5, 8, 0.268);
    for (int i = 0; i < balls; ++i) {
        double center[3], color[4] = {0, 0, 0, alpha};
        for (int k = 0; k < 3; ++k)
            center[k] = 2 * oit_scene_random(&state) - 1;
        for (int k = 0; k < 3; ++k)
            color[k] = oit_scene_random(&state);
        oit_scene_ball(s, center, 0.4 + 0.4 * oit_scene_random(&state), rings, rings, color);
    }
}

/* ---- drawing ---- */

static inline oit_proc oit_scene_get_proc(const char *name) {
    return (oit_proc)eglGetProcAddress(name);
}

static inline GLuint oit_scene_program(bool es, const char *vertex, const char *fragment) {
    const char *version = es ? "#version 310 es\nprecision highp float;\n" : "#version 430 core\n";
    const char *const texts[2] = {vertex, fragment};
    static const GLenum types[2] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
    GLuint program = glCreateProgram();
    GLint ok = 0;
    for (int i = 0; i < 2; ++i) {
        const char *strings[2] = {version, texts[i]};
        char log[1024] = "";
        GLuint shader = glCreateShader(types[i]);
        glShaderSource(shader, 2, strings, NULL);
        glCompileShader(shader);
        glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        if (!ok)
            fail_msg("%s", log);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    assert_true(ok);
    return program;
}

static inline void oit_scene_matrix(const oit_scene *s, size_t i, float out[16]) {
    double view_projection[16], all[16];
    harness_multiply(s->scene.projection, s->scene.view, view_projection);
    harness_multiply(view_projection, s->truths[i].model, all);
    for (int c = 0; c < 4 && s->reversed; ++c) /* from -w ... w to w ... 0 */
        all[4 * c + 2] = 0.5 * (all[4 * c + 3] - all[4 * c + 2]);
    for (int k = 0; k < 16; ++k)
        out[k] = (float)all[k];
}

static inline void oit_scene_elements(const oit_scene *s, size_t i) {
    glBindVertexArray(s->objects[i].array);
    glDrawElements(GL_TRIANGLES, (GLsizei)(3 * s->truths[i].triangle_count), GL_UNSIGNED_INT, NULL);
}

/* Opaque or transparent objects in their order, by the plain program and whatever blending is set. */
static inline void oit_scene_draw_plain(oit_scene *s, bool es, bool transparent) {
    if (!s->plain) {
        s->plain = oit_scene_program(es,
                                     "layout(location = 0) in vec3 position;\nuniform mat4 matrix;\n"
                                     "invariant gl_Position;\n"
                                     "void main() { gl_Position = matrix * vec4(position, 1.0); }\n",
                                     "uniform vec4 color;\nlayout(location = 0) out vec4 result;\n"
                                     "void main() { result = color; }\n");
        s->plain_matrix = glGetUniformLocation(s->plain, "matrix");
        s->plain_color = glGetUniformLocation(s->plain, "color");
    }
    glUseProgram(s->plain);
    for (size_t i = 0; i < s->count; ++i) {
        const ref_object *t = &s->truths[i];
        float matrix[16];
        if (t->transparent != transparent)
            continue;
        oit_scene_matrix(s, i, matrix);
        glUniformMatrix4fv(s->plain_matrix, 1, GL_FALSE, matrix);
        glUniform4f(s->plain_color, (float)t->color[0], (float)t->color[1], (float)t->color[2], (float)t->alpha);
        oit_scene_elements(s, i);
    }
    glBindVertexArray(0);
    glUseProgram(0);
}

/* order: of the objects, or NULL. */
static inline void oit_scene_draw(const oit_scene *s, oit_context *oit, const oit_pass *pass, const size_t *order) {
    for (size_t n = 0; n < s->count; ++n) {
        size_t i = order ? order[n] : n;
        const ref_object *t = &s->truths[i];
        oit_material material;
        if (!t->transparent)
            continue;
        memset(&material, 0, sizeof material);
        oit_scene_matrix(s, i, material.model_view_projection);
        material.normal_matrix[0] = material.normal_matrix[4] = material.normal_matrix[8] = 1;
        for (int k = 0; k < 3; ++k)
            material.color[k] = (float)t->color[k];
        material.color[3] = (float)t->alpha;
        material.part = s->objects[i].part;
        material.key = s->objects[i].key;
        material.blend = s->objects[i].blend;
        oit_set_material(oit, pass, &material);
        oit_scene_elements(s, i);
    }
    glBindVertexArray(0);
}

static inline void oit_scene_expect(oit_result result, const char *what) {
    if (result != OIT_OK)
        fail_msg("%s: %s", what, oit_result_string(result));
}

static inline oit_frame oit_scene_frame(const oit_scene *s, GLuint framebuffer) {
    oit_frame frame = {0};
    frame.framebuffer = framebuffer;
    frame.width = s->scene.width;
    frame.height = s->scene.height;
    frame.background_weight = s->scene.background_weight > 0 ? (float)s->scene.background_weight : -1.0f;
    return frame;
}

/* A whole frame into a target that holds background and opaque things already. */
static inline void oit_scene_render(const oit_scene *s, oit_context *oit, const oit_frame *frame, const size_t *order) {
    oit_pass pass;
    oit_scene_expect(oit_begin(oit, frame), "oit_begin");
    while (oit_next_pass(oit, &pass))
        oit_scene_draw(s, oit, &pass, order);
    oit_scene_expect(oit_compose(oit), "oit_compose");
    oit_scene_expect(oit_end(oit), "oit_end");
}

/* What a host does under OIT_STATE_NONE: all that a pass says, and nothing that it does not say. */
static inline void oit_scene_apply(const oit_pass *pass) {
    const oit_state *state = &pass->state;
    glUseProgram(state->program);
    for (int i = 0; i < 3; ++i)
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, (GLuint)(state->first_storage_binding + i),
                         state->storage_buffers[i]);
    glBindBufferBase(GL_UNIFORM_BUFFER, (GLuint)state->uniform_binding, state->uniform_buffer);
    if (state->groups[0]) {
        glDispatchCompute(state->groups[0], state->groups[1], state->groups[2]);
        return;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, state->framebuffer);
    glViewport(state->viewport[0], state->viewport[1], state->viewport[2], state->viewport[3]);
    glEnable(GL_SCISSOR_TEST);
    glScissor(state->scissor[0], state->scissor[1], state->scissor[2], state->scissor[3]);
    (state->depth_test ? glEnable : glDisable)(GL_DEPTH_TEST);
    glDepthFunc(state->depth_func);
    glDepthMask((GLboolean)state->depth_write);
    GLboolean write = (GLboolean)state->color_write;
    glColorMask(write, write, write, GL_FALSE);
    (state->blend ? glEnable : glDisable)(GL_BLEND);
    glBlendFuncSeparate(state->blend_source, state->blend_destination, GL_ZERO, GL_ONE);
    if (state->vertex_count) {
        glBindVertexArray(state->vertex_array);
        glDrawArrays(GL_TRIANGLES, 0, state->vertex_count);
        glBindVertexArray(0);
    }
}

/* The state that a fresh context has, as far as the passes touch it. */
static inline void oit_scene_reset_state(void) {
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glUseProgram(0);
}

/* A frame under OIT_STATE_NONE. after (may be NULL) is called after each pass. */
static inline void oit_scene_render_raw(const oit_scene *s, oit_context *oit, const oit_frame *frame,
                                        void (*after)(const oit_pass *pass, void *user), void *user) {
    oit_pass pass;
    oit_scene_expect(oit_begin(oit, frame), "oit_begin");
    for (int part = 0; part < 2; ++part) {
        while (oit_next_pass(oit, &pass)) {
            oit_scene_apply(&pass);
            if (!pass.state.groups[0] && !pass.state.vertex_count)
                oit_scene_draw(s, oit, &pass, NULL);
            if (after)
                after(&pass, user);
        }
        if (part == 0)
            oit_scene_expect(oit_compose(oit), "oit_compose");
    }
    oit_scene_expect(oit_end(oit), "oit_end");
    oit_scene_reset_state();
}

/* ---- the truth ---- */

typedef struct oit_truth_layer {
    double depth, slack;
    uint32_t part, key, blend;
    double color[4];
} oit_truth_layer;

typedef struct oit_truth {
    double color[3];
    bool left_out; /* nearer than half a pixel to where the layers or their order change */
    uint32_t layers;
} oit_truth;

static inline int oit_truth_compare(const void *left, const void *right) {
    const oit_truth_layer *a = left, *b = right;
    if (fabs(a->depth - b->depth) > a->slack + b->slack)
        return a->depth < b->depth ? -1 : 1;
    if (a->part != b->part)
        return a->part < b->part ? -1 : 1;
    if (a->key != b->key)
        return a->key < b->key ? -1 : 1;
    return 0;
}

/* The transparent layers before the nearest opaque one, nearest first; returns that one's hit, or NULL. */
static inline const ref_i_hit *oit_truth_cast(ref_i_world *world, const oit_scene *s, double x, double y,
                                              oit_truth_layer *layers, size_t *count) {
    const ref_i_hit *solid = NULL;
    assert_true(ref_i_cast(world, x, y));
    for (size_t i = 0; i < world->hit_count; ++i)
        if (world->hits[i].kind == REF_I_SOLID && (!solid || world->hits[i].depth < solid->depth))
            solid = &world->hits[i];
    *count = 0;
    for (size_t i = 0; i < world->hit_count; ++i) {
        const ref_i_hit *hit = &world->hits[i];
        size_t object = world->triangles[hit->triangle].object;
        if (hit->kind == REF_I_SOLID || (solid && !(hit->depth < solid->depth)))
            continue;
        oit_truth_layer *layer = &layers[(*count)++];
        assert_true(*count <= 4096);
        layer->depth = hit->depth;
        layer->slack = hit->slack;
        layer->part = s->objects[object].part;
        layer->key = s->objects[object].key;
        layer->blend = s->objects[object].blend;
        memcpy(layer->color, s->truths[object].color, 3 * sizeof(double));
        layer->color[3] = s->truths[object].alpha;
    }
    qsort(layers, *count, sizeof *layers, oit_truth_compare);
    return solid;
}

/* Back to front: what is behind, then each layer over, added to or multiplied with it. */
static inline void oit_truth_blend(const oit_truth_layer *layers, size_t count, double color[3]) {
    while (count--) {
        const double *c = layers[count].color;
        const double alpha = c[3];
        for (int k = 0; k < 3; ++k) {
            const double light = alpha * c[k];
            if (layers[count].blend == OIT_BLEND_ADD)
                color[k] += light;
            else if (layers[count].blend == OIT_BLEND_MULTIPLY)
                color[k] *= 1 - alpha + light;
            else
                color[k] = light + (1 - alpha) * color[k];
        }
    }
}

/* What must not change within half a pixel: which parts are met, in which order. */
static inline uint64_t oit_truth_signature(const oit_truth_layer *layers, size_t count, uint32_t solid) {
    uint64_t sum = solid;
    for (size_t i = 0; i < count; ++i)
        sum = sum * 1099511628211u + layers[i].part;
    return sum * 31 + count;
}

static inline double oit_truth_render(const oit_scene *s, oit_truth *out) {
    ref_i_world world = {0};
    static oit_truth_layer layers[4096];
    size_t pixels = (size_t)s->scene.width * (size_t)s->scene.height, left = 0;
    world.scene = &s->scene;
    assert_true(ref_i_is_valid(&s->scene) && ref_i_make_world(&world));
    for (size_t i = 0; i < pixels; ++i) {
        double x = (double)(i % (size_t)s->scene.width), y = (double)(i / (size_t)s->scene.width);
        uint64_t signature = 0;
        out[i].left_out = false;
        for (int corner = 4; corner >= 0; --corner) {
            static const double dx[5] = {0.5, 0.001, 0.999, 0.001, 0.999}, dy[5] = {0.5, 0.001, 0.001, 0.999, 0.999};
            size_t count;
            const ref_i_hit *solid = oit_truth_cast(&world, s, x + dx[corner], y + dy[corner], layers, &count);
            uint64_t here = oit_truth_signature(layers, count, solid ? ref_i_id(&world, solid) : 0);
            if (corner < 4 && here != signature)
                out[i].left_out = true;
            signature = here;
            if (corner)
                continue;
            for (int k = 0; k < 3; ++k)
                out[i].color[k] =
                    (solid ? s->truths[world.triangles[solid->triangle].object].color[k] : s->scene.background[k]) *
                    s->scene.background_weight;
            oit_truth_blend(layers, count, out[i].color);
            out[i].layers = (uint32_t)count;
        }
        left += out[i].left_out;
    }
    ref_i_free_world(&world);
    return pixels ? (double)left / (double)pixels : 0;
}

#endif

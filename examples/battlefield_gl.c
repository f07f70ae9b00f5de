#include "battlefield_gl.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <glad/gl.h>

/* ---- shaders --------------------------------------------------------------------------------------------- */

static const char *const VERTEX =
    "layout(location = 0) in vec3 position;\n"
    "layout(location = 1) in vec3 normal;\n"
    "layout(location = 2) in vec3 color;\n"
    "layout(location = 3) in vec4 row_0;\n" /* these and what follows are of the instance */
    "layout(location = 4) in vec4 row_1;\n"
    "layout(location = 5) in vec4 row_2;\n"
    "layout(location = 6) in vec3 tint;\n"
    "layout(location = 7) in uint code;\n"
    "uniform mat4 clip_from_world;\n"
    "out vec3 v_world, v_normal, v_color;\n"
    "flat out uint v_code;\n"
    "void main() {\n"
    "    vec4 p = vec4(position, 1.0);\n"
    "    v_world = vec3(dot(row_0, p), dot(row_1, p), dot(row_2, p));\n"
    "    v_normal = vec3(dot(row_0.xyz, normal), dot(row_1.xyz, normal), dot(row_2.xyz, normal));\n"
    "    v_color = color * tint;\n"
    "    v_code = code;\n"
    "    gl_Position = clip_from_world * vec4(v_world, 1.0);\n"
    "}\n";

static const char *const FRAGMENT =
    "in vec3 v_world, v_normal, v_color;\n"
    "flat in uint v_code;\n"
    "uniform vec3 sun, eye;\n"
    "uniform vec4 cool, warm, haze;\n"
    "#ifdef SHADOWS\n"
    "uniform mat4 shadow_from_world;\n"
    "uniform mediump sampler2DShadow shadow;\n"
    "float sunlight(vec3 normal) {\n"
    "    vec4 p = shadow_from_world * vec4(v_world + 0.12 * normal, 1.0);\n"
    "    if (any(lessThan(p.xyz, vec3(0.0))) || any(greaterThan(p.xyz, vec3(1.0))))\n"
    "        return 1.0;\n"
    "    vec2 texel = 0.75 / vec2(textureSize(shadow, 0));\n"
    "    float sum = 0.0;\n"
    "    for (int y = -1; y <= 1; y += 2)\n"
    "        for (int x = -1; x <= 1; x += 2)\n"
    "            sum += texture(shadow, vec3(p.xy + vec2(x, y) * texel, p.z));\n"
    "    return 0.25 * sum;\n"
    "}\n"
    "#else\n"
    "float sunlight(vec3 normal) { return 1.0; }\n"
    "#endif\n"
    "vec4 surface_color() {\n"
    "    vec3 normal = normalize(v_normal);\n"
    "    float warmth = 0.5 + 0.5 * dot(normal, sun);\n"
    "    warmth *= mix(0.45, 1.0, sunlight(normal));\n"
    "    vec3 c = clamp(mix(cool.rgb + cool.a * v_color, warm.rgb + warm.a * v_color, warmth), 0.0, 1.0);\n"
    "    c = mix(haze.rgb, c, exp(-haze.a * distance(v_world, eye)));\n"
    "    return vec4(c, 1.0);\n"
    "}\n"
    "layout(location = 0) out vec4 out_color;\n"
    "#if defined(SECOND_TARGET) && !defined(ONE_OUTPUT)\n"
    "layout(location = 1) out vec4 out_normal;\n"
    "#endif\n"
    "void main() {\n"
    "    vec4 c = surface_color();\n"
    "#ifdef SEE_THROUGH\n"
    "    tr_see_through(c, v_code);\n"
    "#endif\n"
    "    out_color = c;\n"
    "#if defined(SECOND_TARGET) && !defined(ONE_OUTPUT)\n"
    "    out_normal = vec4(0.5 + 0.5 * normalize(v_normal), float(v_code & 255u) / 255.0);\n"
    "#endif\n"
    "}\n";

static uint32_t compile(GLenum stage, const char *const *strings, int count, const char *defines, const char *body,
                        char *message, size_t message_size) {
    const char *all[32];
    GLint ok = 0;
    int n = 0;
    for (; n < count && n < 28; n++)
        all[n] = strings[n];
    all[n++] = defines;
    all[n++] = body;
    GLuint shader = glCreateShader(stage);
    glShaderSource(shader, n, all, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) {
        glGetShaderInfoLog(shader, (GLsizei)message_size, NULL, message);
        glDeleteShader(shader);
        return 0;
    }
    return shader;
}

uint32_t battlefield_gl_program(const battlefield_strings *strings, bool es, const char *defines, char *message,
                                size_t message_size) {
    const char *vertex_own[2] = {es ? "#version 300 es\n" : "#version 330\n", "invariant gl_Position;\n"};
    const char *fragment_own[2] = {vertex_own[0], "precision highp float;\nprecision highp int;\n"};
    battlefield_strings own = {vertex_own, fragment_own, 2, 2};
    const battlefield_strings *s = strings ? strings : &own;
    GLuint stages[2] = {compile(GL_VERTEX_SHADER, s->vertex, s->vertex_count, defines, VERTEX, message, message_size),
                        0};
    if (stages[0])
        stages[1] =
            compile(GL_FRAGMENT_SHADER, s->fragment, s->fragment_count, defines, FRAGMENT, message, message_size);
    GLuint program = stages[1] ? glCreateProgram() : 0;
    GLint linked = 0;
    for (int i = 0; program && i < 2; i++)
        glAttachShader(program, stages[i]);
    if (program) {
        glLinkProgram(program);
        glGetProgramiv(program, GL_LINK_STATUS, &linked);
    }
    if (program && !linked) {
        glGetProgramInfoLog(program, (GLsizei)message_size, NULL, message);
        glDeleteProgram(program);
        program = 0;
    }
    glDeleteShader(stages[0]);
    glDeleteShader(stages[1]);
    return program;
}

/* The units above the header's, so that a shadow stays where it is. */
enum { SHADOW_UNIT = 0 };

static void set_matrix(uint32_t program, const char *name, const float m[16]) {
    glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, m);
}

void battlefield_gl_use(const battlefield_look *look, uint32_t program) {
    double product[16];
    float clip[16];
    scene_multiply(look->projection, look->view, product);
    for (int i = 0; i < 16; i++)
        clip[i] = (float)product[i];
    glUseProgram(program);
    set_matrix(program, "clip_from_world", clip);
    set_matrix(program, "shadow_from_world", look->sun_matrix);
    glUniform3f(glGetUniformLocation(program, "sun"), (float)look->sun[0], (float)look->sun[1], (float)look->sun[2]);
    glUniform3f(glGetUniformLocation(program, "eye"), (float)look->eye[0], (float)look->eye[1], (float)look->eye[2]);
    glUniform4fv(glGetUniformLocation(program, "cool"), 1, look->cool);
    glUniform4fv(glGetUniformLocation(program, "warm"), 1, look->warm);
    glUniform4f(glGetUniformLocation(program, "haze"), look->background[0], look->background[1], look->background[2],
                look->haze);
    if (look->shadow) {
        glActiveTexture(GL_TEXTURE0 + SHADOW_UNIT);
        glBindTexture(GL_TEXTURE_2D, look->shadow);
        glUniform1i(glGetUniformLocation(program, "shadow"), SHADOW_UNIT);
    }
}

/* ---- meshes ---------------------------------------------------------------------------------------------- */

static void find_sphere(battlefield_mesh *m, const scene_mesh *mesh) {
    double low[3], high[3], most = 0;
    for (size_t k = 0; k < 3; k++)
        low[k] = high[k] = mesh->vertex_count ? (double)mesh->positions[k] : 0;
    for (size_t i = 0; i < 3 * mesh->vertex_count; i++) {
        low[i % 3] = fmin(low[i % 3], (double)mesh->positions[i]);
        high[i % 3] = fmax(high[i % 3], (double)mesh->positions[i]);
    }
    for (int k = 0; k < 3; k++)
        m->middle[k] = (float)(0.5 * (low[k] + high[k]));
    for (size_t v = 0; v < mesh->vertex_count; v++) {
        double square = 0;
        for (size_t k = 0; k < 3; k++) {
            double d = (double)mesh->positions[3 * v + k] - (double)m->middle[k];
            square += d * d;
        }
        most = fmax(most, square);
    }
    m->radius = (float)(1.0001 * sqrt(most));
}

static void upload_mesh(battlefield_mesh *m, const scene_mesh *mesh, bool plain) {
    GLsizeiptr bytes = (GLsizeiptr)(3 * mesh->vertex_count * sizeof(float));
    const float *colors = plain ? NULL : mesh->colors;
    glGenVertexArrays(1, &m->array);
    glGenBuffers(1, &m->buffer);
    glGenBuffers(1, &m->indices);
    glBindVertexArray(m->array);
    glBindBuffer(GL_ARRAY_BUFFER, m->buffer);
    glBufferData(GL_ARRAY_BUFFER, (colors ? 3 : 2) * bytes, NULL, GL_STATIC_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, mesh->positions);
    glBufferSubData(GL_ARRAY_BUFFER, bytes, bytes, mesh->normals);
    if (colors)
        glBufferSubData(GL_ARRAY_BUFFER, 2 * bytes, bytes, colors);
    for (GLuint i = 0; i < (colors ? 3u : 2u); i++) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 0, (const void *)((uintptr_t)i * (uintptr_t)bytes));
    }
    for (GLuint i = 3; i < 8; i++) {
        glEnableVertexAttribArray(i);
        glVertexAttribDivisor(i, 1);
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m->indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(mesh->index_count * sizeof *mesh->indices), mesh->indices,
                 GL_STATIC_DRAW);
    m->index_count = (int)mesh->index_count;
    find_sphere(m, mesh);
}

bool battlefield_gl_create(battlefield_gl *g, const battlefield *b, bool plain) {
    memset(g, 0, sizeof *g);
    g->source = b;
    g->plain = plain;
    g->part_count = b->scene->part_count;
    g->mesh_count = b->scene->mesh_count;
    g->meshes = calloc(g->mesh_count + 1, sizeof *g->meshes);
    g->instances = calloc(g->part_count + 1, sizeof *g->instances);
    g->staged = calloc(g->part_count + 1, sizeof *g->staged);
    g->order = calloc(g->part_count + 1, sizeof *g->order);
    g->all = calloc(g->part_count + 1, sizeof *g->all);
    g->starts = calloc(g->mesh_count + 2, sizeof *g->starts);
    if (!g->meshes || !g->instances || !g->staged || !g->order || !g->all || !g->starts) {
        battlefield_gl_destroy(g);
        return false;
    }
    for (size_t i = 0; i < g->mesh_count; i++)
        upload_mesh(&g->meshes[i], &b->scene->meshes[i], plain);
    glBindVertexArray(0);
    glGenBuffers(1, &g->stream);
    battlefield_gl_move(g);
    return true;
}

void battlefield_gl_destroy(battlefield_gl *g) {
    for (size_t i = 0; g->meshes && i < g->mesh_count; i++) {
        glDeleteVertexArrays(1, &g->meshes[i].array);
        glDeleteBuffers(1, &g->meshes[i].buffer);
        glDeleteBuffers(1, &g->meshes[i].indices);
    }
    if (g->stream)
        glDeleteBuffers(1, &g->stream);
    free(g->meshes);
    free(g->instances);
    free(g->staged);
    free(g->order);
    free(g->all);
    free(g->starts);
    memset(g, 0, sizeof *g);
}

/* ---- instances ------------------------------------------------------------------------------------------- */

void battlefield_gl_move(battlefield_gl *g) {
    g->shown = 0;
    for (size_t i = 0; i < g->part_count; i++) {
        const scene_part *part = &g->source->scene->parts[i];
        battlefield_instance *made = &g->instances[i];
        bool own_colors = g->source->scene->meshes[part->mesh].colors && !g->plain;
        for (int row = 0; row < 3; row++)
            for (int column = 0; column < 4; column++)
                made->rows[4 * row + column] = (float)part->transform[4 * column + row];
        for (int k = 0; k < 3; k++)
            made->tint[k] = own_colors ? 1.0f : part->color[k];
        if (!part->hidden)
            g->all[g->shown++] = (uint32_t)i;
    }
}

void battlefield_gl_sphere(const battlefield_gl *g, size_t part, float center[3], float *radius) {
    const battlefield_instance *at = &g->instances[part];
    const battlefield_mesh *mesh = &g->meshes[g->source->scene->parts[part].mesh];
    double most = 0;
    for (int row = 0; row < 3; row++) {
        const float *r = &at->rows[4 * row];
        center[row] = r[0] * mesh->middle[0] + r[1] * mesh->middle[1] + r[2] * mesh->middle[2] + r[3];
    }
    for (int column = 0; column < 3; column++)
        most = fmax(most,
                    hypot(hypot((double)at->rows[column], (double)at->rows[4 + column]), (double)at->rows[8 + column]));
    *radius = (float)most * mesh->radius;
}

/* Stages the parts in the order of their meshes, which is that of counting; else as they come. */
static void stage(battlefield_gl *g, const uint32_t *parts, size_t count, bool in_order) {
    const scene_part *all = g->source->scene->parts;
    memset(g->starts, 0, (g->mesh_count + 1) * sizeof *g->starts);
    for (size_t i = 0; i < count; i++)
        g->starts[all[parts[i]].mesh + 1]++;
    for (size_t m = 0; m < g->mesh_count; m++)
        g->starts[m + 1] += g->starts[m];
    for (size_t i = 0; i < count; i++) {
        size_t at = in_order ? i : g->starts[all[parts[i]].mesh]++;
        g->order[at] = parts[i];
        g->staged[at] = g->instances[parts[i]];
    }
}

static const void *at_byte(size_t offset) {
    return (const void *)(uintptr_t)offset;
}

static void point_at_instances(size_t first) {
    const GLsizei stride = sizeof(battlefield_instance);
    size_t start = first * sizeof(battlefield_instance);
    for (GLuint row = 0; row < 3; row++)
        glVertexAttribPointer(3 + row, 4, GL_FLOAT, GL_FALSE, stride, at_byte(start + 4 * row * sizeof(float)));
    glVertexAttribPointer(6, 3, GL_FLOAT, GL_FALSE, stride, at_byte(start + offsetof(battlefield_instance, tint)));
    glVertexAttribIPointer(7, 1, GL_UNSIGNED_INT, stride, at_byte(start + offsetof(battlefield_instance, code)));
}

void battlefield_gl_draw(battlefield_gl *g, const uint32_t *parts, size_t count, bool in_order) {
    const scene_part *all = g->source->scene->parts;
    if (!parts) {
        parts = g->all;
        count = g->shown;
    }
    stage(g, parts, count, in_order);
    glVertexAttrib3f(2, 1.0f, 1.0f, 1.0f); /* of meshes without colours */
    glBindBuffer(GL_ARRAY_BUFFER, g->stream);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(count * sizeof *g->staged), g->staged, GL_STREAM_DRAW);
    for (size_t first = 0, n; first < count; first += n) {
        const battlefield_mesh *mesh = &g->meshes[all[g->order[first]].mesh];
        for (n = 1; first + n < count && all[g->order[first + n]].mesh == all[g->order[first]].mesh;)
            n++;
        glBindVertexArray(mesh->array);
        point_at_instances(first);
        glDrawElementsInstanced(GL_TRIANGLES, mesh->index_count, GL_UNSIGNED_INT, NULL, (GLsizei)n);
        g->draw_calls++;
    }
    glBindVertexArray(0);
}

/* ---- the sun --------------------------------------------------------------------------------------------- */

static void make_shadow_texture(uint32_t *texture, int size) {
    glGenTextures(1, texture);
    glBindTexture(GL_TEXTURE_2D, *texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, size, size, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

/* Along the sun's rays, around all parts. */
static bool sun_view(const battlefield_gl *g, battlefield_look *look) {
    double low[3], high[3], middle[3], radius = 0;
    if (!scene_bounds(g->source->scene, low, high))
        return false;
    for (int k = 0; k < 3; k++) {
        middle[k] = 0.5 * (low[k] + high[k]);
        radius += 0.25 * (high[k] - low[k]) * (high[k] - low[k]);
    }
    radius = sqrt(radius) + 1;
    for (int k = 0; k < 3; k++)
        look->eye[k] = middle[k] + 2 * radius * look->sun[k];
    const double eye[3] = {look->eye[0], look->eye[1], look->eye[2]};
    battlefield_look_at(look, eye, middle);
    memset(look->projection, 0, sizeof look->projection);
    look->projection[0] = look->projection[5] = 1 / radius;
    look->projection[10] = -1 / radius;
    look->projection[14] = -2; /* depths from radius to 3 radius */
    look->projection[15] = 1;
    return true;
}

bool battlefield_gl_shadow(battlefield_gl *g, battlefield_look *look, uint32_t program, int size) {
    static const double to_texture[16] = {0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0.5, 0.5, 0.5, 1};
    battlefield_look from_sun = *look;
    GLint before = 0;
    GLuint framebuffer;
    double product[16], texture[16];
    if (!sun_view(g, &from_sun))
        return false;
    if (!look->shadow)
        make_shadow_texture(&look->shadow, size);
    from_sun.shadow = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, look->shadow, 0);
    glViewport(0, 0, size, size);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5f, 2.0f);
    glClear(GL_DEPTH_BUFFER_BIT);
    battlefield_gl_use(&from_sun, program);
    battlefield_gl_draw(g, NULL, 0, false);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glBindFramebuffer(GL_FRAMEBUFFER, (GLuint)before);
    glDeleteFramebuffers(1, &framebuffer);
    scene_multiply(from_sun.projection, from_sun.view, product);
    scene_multiply(to_texture, product, texture);
    for (int i = 0; i < 16; i++)
        look->sun_matrix[i] = (float)texture[i];
    return true;
}

/* ---- cameras --------------------------------------------------------------------------------------------- */

void battlefield_default_look(battlefield_look *look) {
    static const double sun[3] = {-0.45, -0.5, 0.75};
    static const float cool[4] = {0.0f, 0.05f, 0.25f, 0.55f}, warm[4] = {0.25f, 0.18f, 0.02f, 0.75f};
    static const float background[3] = {0.9f, 0.93f, 0.96f};
    double length = sqrt(sun[0] * sun[0] + sun[1] * sun[1] + sun[2] * sun[2]);
    memset(look, 0, sizeof *look);
    for (int k = 0; k < 3; k++)
        look->sun[k] = sun[k] / length;
    memcpy(look->cool, cool, sizeof cool);
    memcpy(look->warm, warm, sizeof warm);
    memcpy(look->background, background, sizeof background);
}

static void normalise(double v[3]) {
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int k = 0; k < 3 && length > 0; k++)
        v[k] /= length;
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        out[k] = a[i] * b[j] - a[j] * b[i];
    }
}

void battlefield_look_at(battlefield_look *look, const double eye[3], const double at[3]) {
    double axes[3][3], up[3] = {0, 0, 1}, *m = look->view;
    for (int k = 0; k < 3; k++)
        axes[2][k] = eye[k] - at[k];
    normalise(axes[2]);
    if (fabs(axes[2][2]) > 0.9999) { /* straight down */
        up[2] = 0;
        up[1] = 1;
    }
    cross(up, axes[2], axes[0]);
    normalise(axes[0]);
    cross(axes[2], axes[0], axes[1]);
    memset(m, 0, sizeof look->view);
    for (int r = 0; r < 3; r++)
        for (int k = 0; k < 3; k++) {
            m[4 * k + r] = axes[r][k];
            m[12 + r] -= axes[r][k] * eye[k];
        }
    m[15] = 1;
    memmove(look->eye, eye, sizeof look->eye);
}

void battlefield_lens(battlefield_look *look, double fov, int width, int height, double nearest, double farthest) {
    double shorter = width < height ? width : height, scale = 1 / tan(fov * 3.14159265358979323846 / 360);
    double *m = look->projection;
    memset(m, 0, sizeof look->projection);
    m[0] = scale * shorter / width;
    m[5] = scale * shorter / height;
    m[10] = -(farthest + nearest) / (farthest - nearest);
    m[11] = -1;
    m[14] = -2 * farthest * nearest / (farthest - nearest);
}

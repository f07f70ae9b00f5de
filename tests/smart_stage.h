/* smart_stage.h: scenes for the operators of oit_buffers.h, and what they make of each fragment, read back through an
 * operator of the host's into the lists of reference_smart.h: the same fragments for the header and for its truth. */
#ifndef GLASSINE_TESTS_SMART_STAGE_H
#define GLASSINE_TESTS_SMART_STAGE_H

#include "oit_setting.h"
#include "reference_smart.h"

#include "models.h"
#include "oit_models.h"

enum { SMART_STAGE_WORDS = 24, SMART_STAGE_BINDING = 6, SMART_STAGE_OPERATORS = 6 };

typedef struct smart_stage {
    oit_setting set;
    oit_scene scene;
    double radius; /* of the scene, for links */
    GLuint reader, out;
    size_t room; /* fragments that can be read */
} smart_stage;

/* What the buffer holds of a fragment: depth, slope, normal, part, kind, colour, links, values, steps. */
typedef struct smart_stage_row {
    float depth, slope[2], normal[3];
    uint32_t part, surface;
    float color[4];
    int32_t link[4];
    float base, beta, gamma, kappa;
    uint32_t steps[2], pixel, pad;
} smart_stage_row;

/* ---- reading back ---- */

static const char *const smart_stage_reader =
    "layout(std430, binding = 6) writeonly buffer out_rows { uint rows[]; };\n"
    "void oit_operate(uint p) {\n"
    "    uint first, n = oit_list(p, first);\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uint slot = first + i, at = 24u * slot, q, other;\n"
    "        if (at + 24u > uint(rows.length()))\n"
    "            return;\n"
    "        rows[at] = floatBitsToUint(oit_depth(slot));\n"
    "        rows[at + 1u] = floatBitsToUint(oit_slope(slot).x);\n"
    "        rows[at + 2u] = floatBitsToUint(oit_slope(slot).y);\n"
    "        for (int k = 0; k < 3; ++k)\n"
    "            rows[at + 3u + uint(k)] = floatBitsToUint(oit_normal(slot)[k]);\n"
    "        rows[at + 6u] = oit_part_of(slot);\n"
    "        rows[at + 7u] = oit_is_surface(slot) ? 1u : 0u;\n"
    "        for (int k = 0; k < 4; ++k)\n"
    "            rows[at + 8u + uint(k)] = floatBitsToUint(oit_color(slot)[k]);\n"
    "        for (uint d = 0u; d < 4u; ++d) {\n"
    "            uint to = oit_neighbour(p, slot, d);\n"
    "            if (to != OIT_NONE && oit_beside(p, d, q)) {\n"
    "                oit_list(q, other);\n"
    "                to -= other;\n"
    "            }\n"
    "            rows[at + 12u + d] = to;\n"
    "        }\n"
    "        rows[at + 16u] = floatBitsToUint(oit_value(OIT_BASE, slot));\n"
    "        rows[at + 17u] = floatBitsToUint(oit_value(OIT_BETA, slot));\n"
    "        rows[at + 18u] = floatBitsToUint(oit_value(OIT_GAMMA, slot));\n"
    "        rows[at + 19u] = OIT_IN_KAPPA != 0u ? floatBitsToUint(oit_value(OIT_KAPPA, slot)) : 0u;\n"
    "        rows[at + 20u] = oit_steps(slot, false);\n"
    "        rows[at + 21u] = oit_steps(slot, true);\n"
    "        rows[at + 22u] = p;\n"
    "    }\n"
    "}\n";

static inline GLuint smart_stage_program(const oit_context *oit, const char *text) {
    const char *strings[OIT_I_MAX_STRINGS + 1];
    int count = 0;
    GLint ok = 0;
    char log[2048] = "";
    const char *const *first = oit_operator_glsl(oit, &count);
    GLuint program = glCreateProgram(), shader = glCreateShader(GL_COMPUTE_SHADER);
    assert_true(first && count <= OIT_I_MAX_STRINGS);
    memcpy(strings, first, (size_t)count * sizeof *strings);
    strings[count] = text;
    glShaderSource(shader, count + 1, strings, NULL);
    glCompileShader(shader);
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    glAttachShader(program, shader);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (!ok)
        fail_msg("the host's operator: %s", log);
    glDeleteShader(shader);
    return program;
}

static inline void smart_stage_open(smart_stage *t, bool es, int size, oit_desc desc, size_t room) {
    memset(t, 0, sizeof *t);
    oit_setting_open(&t->set, es, size, size, 0, GL_RGBA32F, desc);
    oit_scene_init(&t->scene, size, size);
    t->radius = 1;
    t->room = room;
    t->reader = smart_stage_program(t->set.oit, smart_stage_reader);
    glGenBuffers(1, &t->out);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, t->out);
    glBufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)(room * 4 * SMART_STAGE_WORDS), NULL, GL_DYNAMIC_READ);
}

/* An empty scene in the place of the one before. */
static inline oit_scene *smart_stage_clear(smart_stage *t) {
    oit_scene_drop(&t->scene);
    oit_scene_init(&t->scene, t->set.width, t->set.height);
    t->radius = 1;
    return &t->scene;
}

static inline void smart_stage_close(smart_stage *t) {
    oit_scene_drop(&t->scene);
    glDeleteProgram(t->reader);
    glDeleteBuffers(1, &t->out);
    oit_setting_close(&t->set);
}

/* ---- scenes ---- */

typedef void (*smart_stage_shape)(double u, double v, const double *numbers, double out[3]);

/* A surface over u, v in [0,1] as steps x steps cells, with the normals of its formula. */
static inline size_t smart_stage_sheet(oit_scene *s, smart_stage_shape shape, const double *numbers, int steps,
                                       const double color[4]) {
    size_t row = (size_t)steps + 1, vertices = row * row, count = 0;
    float *positions = malloc(3 * vertices * sizeof *positions), *normals = malloc(3 * vertices * sizeof *normals);
    uint32_t *indices = malloc(6 * vertices * sizeof *indices);
    for (size_t i = 0; i < vertices; ++i) {
        double u = (double)(i % row) / steps, v = (double)(i / row) / steps, at[3], ends[4][3], n[3];
        shape(u, v, numbers, at);
        shape(u - 1e-4, v, numbers, ends[0]);
        shape(u + 1e-4, v, numbers, ends[1]);
        shape(u, v - 1e-4, numbers, ends[2]);
        shape(u, v + 1e-4, numbers, ends[3]);
        for (int k = 0; k < 3; ++k) {
            int a = (k + 1) % 3, b = (k + 2) % 3;
            n[k] = (ends[1][a] - ends[0][a]) * (ends[3][b] - ends[2][b]) -
                   (ends[1][b] - ends[0][b]) * (ends[3][a] - ends[2][a]);
        }
        double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int k = 0; k < 3; ++k) {
            positions[3 * i + (size_t)k] = (float)at[k];
            normals[3 * i + (size_t)k] = length > 0 ? (float)(n[k] / length) : 0.0f;
        }
    }
    for (size_t j = 0; j < (size_t)steps; ++j)
        for (size_t i = 0; i < (size_t)steps; ++i) {
            uint32_t a = (uint32_t)(j * row + i), b = a + 1, c = a + (uint32_t)row, d = c + 1;
            const uint32_t two[6] = {a, b, d, a, d, c};
            memcpy(indices + 3 * count, two, sizeof two);
            count += 2;
        }
    return oit_scene_add(s, positions, normals, vertices, indices, count, color);
}

/* numbers: distance along the view, tilt along x and y, height of the waves, waves, shift. */
static inline void smart_stage_wavy(double u, double v, const double *n, double out[3]) {
    out[0] = 3 * (u - 0.5);
    out[1] = 3 * (v - 0.5);
    out[2] = n[0] + n[1] * out[0] + n[2] * out[1] + n[3] * sin(n[4] * (u + 0.6 * v) + n[5]);
}

/* numbers: radius, height, from and to in turns. */
static inline void smart_stage_pipe(double u, double v, const double *n, double out[3]) {
    double turn = 6.28318530717958648 * (n[2] + (n[3] - n[2]) * u);
    out[0] = n[0] * cos(turn);
    out[1] = n[1] * (v - 0.5);
    out[2] = n[0] * sin(turn);
}

/* numbers: centre, radius. Poles up and down. */
static inline void smart_stage_ball(double u, double v, const double *n, double out[3]) {
    double turn = 6.28318530717958648 * u, polar = 3.14159265358979324 * fmin(fmax(v, 1e-6), 1 - 1e-6);
    out[0] = n[0] + n[3] * sin(polar) * cos(turn);
    out[1] = n[1] + n[3] * cos(polar);
    out[2] = n[2] + n[3] * sin(polar) * sin(turn);
}

static inline void smart_stage_color(uint32_t *state, double alpha, double out[4]) {
    for (int k = 0; k < 3; ++k)
        out[k] = oit_scene_random(state);
    out[3] = alpha;
}

/* numbers: radius of the ring, and of its tube; its axis is z. Ends meet beginnings to the bit. */
static inline void smart_stage_ring(double u, double v, const double *n, double out[3]) {
    double turn = 6.28318530717958648 * (u >= 1 ? u - 1 : u), tilt = 6.28318530717958648 * (v >= 1 ? v - 1 : v);
    out[0] = (n[0] + n[1] * cos(tilt)) * cos(turn);
    out[1] = (n[0] + n[1] * cos(tilt)) * sin(turn);
    out[2] = n[1] * sin(tilt);
}

/* A model with its normals. */
static inline void smart_stage_scene(smart_stage *t, const scene *model, double alpha) {
    oit_scene *s = smart_stage_clear(t);
    oit_scene_look_at(s, model);
    double low[3], high[3], square = 0;
    scene_bounds(model, low, high);
    for (int k = 0; k < 3; ++k)
        square += 0.25 * (high[k] - low[k]) * (high[k] - low[k]);
    t->radius = sqrt(square);
    for (size_t i = 0; i < model->part_count; ++i) {
        const scene_part *part = &model->parts[i];
        const scene_mesh *mesh = &model->meshes[part->mesh];
        const double color[4] = {(double)part->color[0], (double)part->color[1], (double)part->color[2], alpha};
        size_t at = oit_scene_add(s, oit_scene_copy(mesh->positions, 12 * mesh->vertex_count),
                                  oit_scene_copy(mesh->normals, 12 * mesh->vertex_count), mesh->vertex_count,
                                  oit_scene_copy(mesh->indices, 4 * mesh->index_count), mesh->index_count / 3, color);
        memcpy(s->truths[at].model, part->transform, sizeof part->transform);
    }
}

/* A built-in one. */
static inline void smart_stage_model(smart_stage *t, const char *name, double alpha) {
    scene *model = models_make(name);
    assert_non_null(model);
    smart_stage_scene(t, model, alpha);
    scene_destroy(model);
}

/* ---- a frame ---- */

static inline void smart_stage_draw(const oit_scene *s, oit_context *oit, const oit_pass *pass, const size_t *order) {
    for (size_t n = 0; n < s->count; ++n) {
        size_t i = order ? order[n] : n;
        double turn[16];
        oit_material material;
        memset(&material, 0, sizeof material);
        oit_scene_matrix(s, i, material.model_view_projection);
        harness_multiply(s->scene.view, s->truths[i].model, turn); /* rotations and even scales: no inverse is needed */
        for (int k = 0; k < 9; ++k)
            material.normal_matrix[k] = (float)turn[4 * (k / 3) + k % 3];
        for (int k = 0; k < 3; ++k)
            material.color[k] = (float)s->truths[i].color[k];
        material.color[3] = (float)s->truths[i].alpha;
        material.part = s->objects[i].part;
        material.blend = s->objects[i].blend;
        oit_set_material(oit, pass, &material);
        oit_scene_elements(s, i);
    }
    glBindVertexArray(0);
}

static inline int smart_stage_nearer(const void *a, const void *b) {
    const uint32_t p = ((const smart_stage_row *)a)->pixel, q = ((const smart_stage_row *)b)->pixel;
    return p < q ? -1 : p > q;
}

/* The image that reference_smart.h works on, with the header's links, values and kappa in the fields of the same name. */
static inline ref_smart_image smart_stage_image(const smart_stage *t, const smart_stage_row *rows, size_t count) {
    ref_smart_image image = {t->set.width, t->set.height, NULL, NULL};
    size_t pixels = (size_t)image.width * (size_t)image.height;
    image.start = calloc(pixels + 1, sizeof *image.start);
    image.fragments = calloc(count + 1, sizeof *image.fragments);
    for (size_t i = 0; i < count; ++i) {
        const smart_stage_row *row = &rows[i];
        ref_smart_fragment *f = &image.fragments[i];
        assert_true(row->pixel < pixels && (i == 0 || row->pixel >= rows[i - 1].pixel));
        ++image.start[row->pixel + 1];
        f->depth = (double)row->depth;
        f->part = row->part;
        f->kind = row->surface ? REF_SMART_SURFACE : REF_SMART_LINE;
        for (int k = 0; k < 3; ++k) {
            f->normal[k] = (double)row->normal[k];
            f->color[k] = (double)row->color[k];
        }
        f->alpha = (double)row->color[3];
        for (int k = 0; k < 2; ++k)
            f->slope[k] = (double)row->slope[k];
        memcpy(f->link, row->link, sizeof f->link);
        f->base = (double)row->base;
        f->beta = (double)row->beta;
        f->gamma = (double)row->gamma;
        f->kappa = (double)row->kappa;
    }
    for (size_t p = 0; p < pixels; ++p)
        image.start[p + 1] += image.start[p];
    return image;
}

static inline void smart_stage_drop(ref_smart_image *image) {
    free(image->start);
    free(image->fragments);
}

/* A frame with these operators. image (may be NULL): what they left of each fragment. Returns the picture. */
static inline float *smart_stage_frame(smart_stage *t, const oit_operator *ops, size_t op_count, const size_t *order,
                                       ref_smart_image *image) {
    oit_pass pass;
    oit_frame frame = oit_scene_frame(&t->scene, t->set.framebuffer);
    oit_report report;
    for (int k = 0; k < 16; ++k)
        frame.projection[k] = (float)t->scene.scene.projection[k];
    oit_setting_clear(&t->set, &t->scene);
    oit_scene_expect(oit_begin(t->set.oit, &frame), "oit_begin");
    while (oit_next_pass(t->set.oit, &pass))
        smart_stage_draw(&t->scene, t->set.oit, &pass, order);
    for (size_t i = 0; i < op_count; ++i)
        oit_scene_expect(oit_run(t->set.oit, &ops[i]), "oit_run");
    if (image) {
        oit_operator read;
        memset(&read, 0, sizeof read);
        read.kind = OIT_RUN_HOST;
        read.host.program = t->reader;
        read.host.value = OIT_VALUE_HOST;
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SMART_STAGE_BINDING, t->out);
        oit_scene_expect(oit_run(t->set.oit, &read), "oit_run of the reader");
    }
    oit_scene_expect(oit_compose(t->set.oit), "oit_compose");
    oit_scene_expect(oit_end(t->set.oit), "oit_end");
    if (image) {
        oit_scene_expect(oit_get_report(t->set.oit, &report), "oit_get_report");
        assert_true(report.needed <= t->room && report.bands <= 1);
        smart_stage_row *rows = malloc((report.needed + 1) * sizeof *rows);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, t->out);
        if (report.needed)
            glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, (GLsizeiptr)(report.needed * sizeof *rows), rows);
        *image = smart_stage_image(t, rows, report.needed);
        free(rows);
    }
    return oit_setting_read(&t->set, t->set.framebuffer);
}

static inline ref_smart_links smart_stage_links(const smart_stage *t, const oit_link *link) {
    static const ref_smart_criterion criteria[4] = {REF_SMART_BY_DEPTH, REF_SMART_BY_UV, REF_SMART_PUBLISHED,
                                                    REF_SMART_MURRAY};
    ref_smart_links links;
    memset(&links, 0, sizeof links);
    links.criterion = criteria[link->criterion];
    links.depth_weight = links.normal_weight = 0.5;
    links.radius = link->radius > 0 ? (double)link->radius : 1;
    links.limit = link->limit > 0 ? (double)link->limit : link->limit < 0 ? (double)INFINITY : (double)0.04f;
    links.no_reverse_check = link->no_reverse_check != 0;
    for (int k = 0; k < 16; ++k)
        links.projection[k] = (double)(float)t->scene.scene.projection[k];
    return links;
}

#endif

/* smart_stage.h: scenes for the operators of oit_buffers.h, and what they make of each fragment, read back through an
 * operator of the host's into the lists of reference_smart.h: the same fragments for the header and for its truth. Nothing
 * of the header's own layout is known here, so every store is read alike. */
#ifndef GLASSINE_TESTS_SMART_STAGE_H
#define GLASSINE_TESTS_SMART_STAGE_H

#include "oit_setting.h"
#include "reference_smart.h"

#include "models.h"
#include "oit_models.h"

enum { SMART_STAGE_WORDS = 28, SMART_STAGE_BINDING = 6, SMART_STAGE_OPERATORS = 6 };

/* What the buffer holds of a fragment. */
typedef struct smart_stage_row {
    float depth, slope[2], normal[3];
    uint32_t part, kind;
    float color[4];
    int32_t link[4];
    float base, beta, gamma, kappa;
    uint32_t steps[2]; /* of beta and gamma, to the nearest source */
    float uv[2], host[2];
    uint32_t pad[2];
} smart_stage_row;

typedef struct smart_stage {
    oit_setting set;
    oit_scene scene;
    double radius;  /* of the scene, for links */
    float light[3]; /* as of oit_frame; zero: not shaded */
    GLuint reader, out;
    size_t room;                  /* fragments that can be read */
    smart_stage_row *rows;        /* of the last look, in the image's order */
    GLuint programs[2];           /* the host's own surfaces, which store (u, v); 0: the built-in ones */
    double uv_scale[2], uv_shift; /* u = scale x, v = scale y of the object's space, and so much more for each object */
    double uv_at[16][2];          /* and what is the object's own, of the first few */
} smart_stage;

/* ---- reading back ---- */

/* First of every pixel its first slot and how many there are, then the fragments by slot. */
static const char *const smart_stage_reader =
    "layout(std430, binding = 6) writeonly buffer out_rows { uint rows[]; };\n"
    "void put(uint at, float x) { rows[at] = floatBitsToUint(x); }\n"
    "void oit_operate(uint p) {\n"
    "    uint first, n = oit_list(p, first), head = 2u * uint(oit_area.z * oit_area.w);\n"
    "    rows[2u * p] = first;\n"
    "    rows[2u * p + 1u] = n;\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        uint slot = first + i, at = head + 28u * slot, q, other;\n"
    "        if (at + 28u > uint(rows.length()))\n"
    "            return;\n"
    "        put(at, oit_depth(slot));\n"
    "#if OIT_HAS_SLOPE\n"
    "        put(at + 1u, oit_slope(slot).x);\n"
    "        put(at + 2u, oit_slope(slot).y);\n"
    "#endif\n"
    "#if OIT_HAS_NORMAL\n"
    "        for (int k = 0; k < 3; ++k)\n"
    "            put(at + 3u + uint(k), oit_normal(slot)[k]);\n"
    "#endif\n"
    "#if OIT_HAS_PART\n"
    "        rows[at + 6u] = oit_part_of(slot);\n"
    "#endif\n"
    "        rows[at + 7u] = oit_record_blend(oit_record(slot));\n"
    "        for (int k = 0; k < 4; ++k)\n"
    "            put(at + 8u + uint(k), oit_color(slot)[k]);\n"
    "        for (uint d = 0u; d < 4u; ++d) {\n"
    "            uint to = OIT_IN_LINKS != 0u ? oit_neighbour(p, slot, d) : OIT_NONE;\n"
    "            if (to != OIT_NONE && oit_beside(p, d, q)) {\n"
    "                oit_list(q, other);\n"
    "                to -= other;\n"
    "            }\n"
    "            rows[at + 12u + d] = to;\n"
    "        }\n"
    "        put(at + 16u, OIT_IN_BASE != 0u ? oit_value(OIT_BASE, slot) : 0.0);\n"
    "        put(at + 17u, OIT_IN_REACH != 0u ? oit_value(OIT_BETA, slot) : 0.0);\n"
    "        put(at + 18u, OIT_IN_REACH != 0u ? oit_value(OIT_GAMMA, slot) : 0.0);\n"
    "        put(at + 19u, OIT_IN_KAPPA != 0u ? oit_value(OIT_KAPPA, slot) : 0.0);\n"
    "        rows[at + 20u] = OIT_IN_REACH != 0u ? oit_steps(slot, false) : 0u;\n"
    "        rows[at + 21u] = OIT_IN_REACH != 0u ? oit_steps(slot, true) : 0u;\n"
    "#if OIT_HAS_UV\n"
    "        put(at + 22u, oit_uv(slot).x);\n"
    "        put(at + 23u, oit_uv(slot).y);\n"
    "#endif\n"
    "        for (uint k = 0u; k < 2u; ++k)\n"
    "            put(at + 24u + k, OIT_IN_HOST[k] != 0u ? oit_value(OIT_HOST + k, slot) : 0.0);\n"
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

/* Surfaces by the host's own shaders: normals and (u, v) reach oit_store as they are. */
static inline GLuint smart_stage_surfaces(const oit_context *oit, oit_pass_kind kind) {
    static const char *const texts[2] = {
        "layout(location = 0) in vec3 position;\nlayout(location = 1) in vec3 normal;\n"
        "uniform mat4 matrix;\nuniform mat3 turn;\nuniform vec4 uv_map;\nout vec3 v_normal;\nout vec2 v_uv;\n"
        "void main() {\n    v_normal = turn * normal;\n    v_uv = position.xy * uv_map.xy + uv_map.zw;\n"
        "    gl_Position = matrix * vec4(position, 1.0);\n}\n",
        "in vec3 v_normal;\nin vec2 v_uv;\nuniform vec4 color;\nuniform uvec4 object;\nvoid main() {\n"
        "    oit_fragment f;\n    f.color = color;\n    f.part = object.x;\n    f.normal = v_normal;\n    f.uv = v_uv;\n"
        "#if OIT_HAS_BLEND\n    f.blend = object.z;\n#endif\n    oit_store(f);\n}\n"};
    static const GLenum types[2] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
    GLuint program = glCreateProgram();
    GLint ok = 0;
    char log[2048] = "";
    for (int i = 0; i < 2; ++i) {
        const char *strings[OIT_I_MAX_STRINGS + 1];
        int count = 0;
        const char *const *first = oit_glsl(oit, (oit_stage)i, kind, &count);
        GLuint shader = glCreateShader(types[i]);
        assert_true(first && count <= OIT_I_MAX_STRINGS);
        memcpy(strings, first, (size_t)count * sizeof *strings);
        strings[count] = texts[i];
        glShaderSource(shader, count + 1, strings, NULL);
        glCompileShader(shader);
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (!ok)
        fail_msg("the host's surfaces: %s", log);
    return program;
}

/* With OIT_FIELD_UV, OIT_FIELD_NORMAL and OIT_FIELD_PART surfaces are drawn by the host's own shaders. */
static inline void smart_stage_open_wide(smart_stage *t, bool es, int width, int height, oit_desc desc, size_t room) {
    const uint32_t own = OIT_FIELD_UV | OIT_FIELD_NORMAL | OIT_FIELD_PART;
    memset(t, 0, sizeof *t);
    oit_setting_open(&t->set, es, width, height, 0, GL_RGBA32F, desc);
    oit_scene_init(&t->scene, width, height);
    t->radius = 1;
    t->room = room;
    t->reader = smart_stage_program(t->set.oit, smart_stage_reader);
    for (int i = 0; i < 2 && (desc.fields & own) == own; ++i)
        t->programs[i] = smart_stage_surfaces(t->set.oit, i ? OIT_PASS_FILL : OIT_PASS_COUNT);
    glGenBuffers(1, &t->out);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, t->out);
    glBufferData(GL_SHADER_STORAGE_BUFFER,
                 (GLsizeiptr)(8 * (size_t)width * (size_t)height + room * 4 * SMART_STAGE_WORDS), NULL,
                 GL_DYNAMIC_READ);
}

static inline void smart_stage_open(smart_stage *t, bool es, int size, oit_desc desc, size_t room) {
    smart_stage_open_wide(t, es, size, size, desc, room);
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
    free(t->rows);
    glDeleteProgram(t->reader);
    for (int i = 0; i < 2; ++i)
        glDeleteProgram(t->programs[i]);
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

/* Everything turned about the upright axis through `center`, of the space of the world. */
static inline void smart_stage_turn(smart_stage *t, const double center[3], double turn) {
    const double c = cos(turn), r = sin(turn);
    const double about[16] = {c,
                              0,
                              -r,
                              0,
                              0,
                              1,
                              0,
                              0,
                              r,
                              0,
                              c,
                              0,
                              center[0] - c * center[0] - r * center[2],
                              0,
                              center[2] + r * center[0] - c * center[2],
                              1};
    for (size_t i = 0; i < t->scene.count; ++i) {
        double turned[16];
        harness_multiply(about, t->scene.truths[i].model, turned);
        memcpy(t->scene.truths[i].model, turned, sizeof turned);
    }
}

/* ---- a frame ---- */

/* normal_matrix: of rotations and even scales, which need no inverse. */
static inline oit_material smart_stage_material(const oit_scene *s, size_t i) {
    double turn[16];
    oit_material material;
    memset(&material, 0, sizeof material);
    oit_scene_matrix(s, i, material.model_view_projection);
    harness_multiply(s->scene.view, s->truths[i].model, turn);
    for (int k = 0; k < 9; ++k)
        material.normal_matrix[k] = (float)turn[4 * (k / 3) + k % 3];
    for (int k = 0; k < 3; ++k)
        material.color[k] = (float)s->truths[i].color[k];
    material.color[3] = (float)s->truths[i].alpha;
    material.part = s->objects[i].part;
    material.blend = s->objects[i].blend;
    return material;
}

static inline void smart_stage_draw(const oit_scene *s, oit_context *oit, const oit_pass *pass, const size_t *order) {
    for (size_t n = 0; n < s->count; ++n) {
        size_t i = order ? order[n] : n;
        oit_material material = smart_stage_material(s, i);
        oit_set_material(oit, pass, &material);
        oit_scene_elements(s, i);
    }
    glBindVertexArray(0);
}

/* By the host's own shaders. */
static inline void smart_stage_draw_own(const smart_stage *t, const oit_pass *pass, const size_t *order) {
    GLuint program = t->programs[pass->kind == OIT_PASS_FILL];
    glUseProgram(program);
    for (size_t n = 0; n < t->scene.count; ++n) {
        size_t i = order ? order[n] : n;
        oit_material material = smart_stage_material(&t->scene, i);
        glUniformMatrix4fv(glGetUniformLocation(program, "matrix"), 1, GL_FALSE, material.model_view_projection);
        glUniformMatrix3fv(glGetUniformLocation(program, "turn"), 1, GL_FALSE, material.normal_matrix);
        glUniform4fv(glGetUniformLocation(program, "color"), 1, material.color);
        glUniform4ui(glGetUniformLocation(program, "object"), material.part, 0, material.blend, 0);
        double shift[2];
        for (int k = 0; k < 2; ++k)
            shift[k] = t->uv_shift * (double)i + (i < 16 ? t->uv_at[i][k] : 0);
        glUniform4f(glGetUniformLocation(program, "uv_map"), (float)t->uv_scale[0], (float)t->uv_scale[1],
                    (float)shift[0], (float)shift[1]);
        oit_scene_elements(&t->scene, i);
    }
    glBindVertexArray(0);
}

/* The projection as the header gets it, and as reference_smart.h wants it: for window depths of [-1,1] clip depth. */
static inline void smart_stage_projection(const smart_stage *t, float projection[16], double truth[16]) {
    const double *p = t->scene.scene.projection;
    for (int k = 0; k < 16; ++k) {
        bool z = k % 4 == 2 && t->scene.reversed;
        projection[k] = (float)(z ? 0.5 * (p[k + 1] - p[k]) : p[k]);
        truth[k] = z ? -(double)(float)p[k] : (double)(float)p[k];
    }
}

/* The host's part of a frame: oit_run may follow. */
static inline void smart_stage_begin(smart_stage *t, const size_t *order) {
    oit_pass pass;
    oit_frame frame = oit_scene_frame(&t->scene, t->set.framebuffer);
    double truth[16];
    smart_stage_projection(t, frame.projection, truth);
    frame.zero_to_one = t->scene.reversed;
    memcpy(frame.light, t->light, sizeof frame.light);
    oit_setting_clear(&t->set, &t->scene);
    oit_scene_expect(oit_begin(t->set.oit, &frame), "oit_begin");
    while (oit_next_pass(t->set.oit, &pass))
        if (t->programs[0])
            smart_stage_draw_own(t, &pass, order);
        else
            smart_stage_draw(&t->scene, t->set.oit, &pass, order);
}

static inline void smart_stage_run(smart_stage *t, const oit_operator *op) {
    oit_scene_expect(oit_run(t->set.oit, op), "oit_run");
}

static inline void smart_stage_take(const smart_stage_row *row, ref_smart_fragment *f) {
    static const int kinds[4] = {REF_SMART_SURFACE, REF_SMART_ADD, REF_SMART_MULTIPLY, REF_SMART_LINE};
    memset(f, 0, sizeof *f);
    f->depth = (double)row->depth;
    f->part = row->part;
    f->kind = kinds[row->kind & 3u];
    for (int k = 0; k < 3; ++k) {
        f->normal[k] = (double)row->normal[k];
        f->color[k] = (double)row->color[k];
    }
    f->alpha = (double)row->color[3];
    for (int k = 0; k < 2; ++k) {
        f->slope[k] = (double)row->slope[k];
        f->uv[k] = (double)row->uv[k];
    }
    memcpy(f->link, row->link, sizeof f->link);
    f->base = (double)row->base;
    f->beta = (double)row->beta;
    f->gamma = (double)row->gamma;
    f->kappa = (double)row->kappa;
}

/* The image that reference_smart.h works on, with the header's links, values and kappa in the fields of the same name. */
static inline ref_smart_image smart_stage_image(smart_stage *t, const uint32_t *words) {
    ref_smart_image image = {t->set.width, t->set.height, NULL, NULL};
    size_t pixels = (size_t)image.width * (size_t)image.height, count = 0;
    const smart_stage_row *rows = (const smart_stage_row *)(const void *)(words + 2 * pixels);
    image.start = calloc(pixels + 1, sizeof *image.start);
    for (size_t p = 0; p < pixels; ++p)
        image.start[p + 1] = image.start[p] + words[2 * p + 1];
    image.fragments = calloc(image.start[pixels] + 1, sizeof *image.fragments);
    free(t->rows);
    t->rows = calloc(image.start[pixels] + 1, sizeof *t->rows);
    for (size_t p = 0; p < pixels; ++p)
        for (size_t i = 0; i < words[2 * p + 1]; ++i, ++count) {
            ref_smart_fragment *f = &image.fragments[count];
            assert_true(words[2 * p] + i < t->room);
            t->rows[count] = rows[words[2 * p] + i];
            smart_stage_take(&t->rows[count], f);
            for (int d = 0; d < 4; ++d) {
                int x = (int)(p % (size_t)image.width), y = (int)(p / (size_t)image.width);
                f->no_neighbour[d] = !ref_smart_next(&image, &x, &y, d);
            }
        }
    return image;
}

static inline void smart_stage_drop(ref_smart_image *image) {
    free(image->start);
    free(image->fragments);
}

/* What is there of each fragment now, between two operators. */
static inline ref_smart_image smart_stage_look(smart_stage *t) {
    oit_operator read;
    memset(&read, 0, sizeof read);
    read.kind = OIT_RUN_HOST;
    read.host.program = t->reader;
    read.host.value = OIT_VALUE_HOST;
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SMART_STAGE_BINDING, t->out);
    oit_scene_expect(oit_run(t->set.oit, &read), "oit_run of the reader");
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, t->out);
    size_t bytes = 8 * (size_t)t->set.width * (size_t)t->set.height + t->room * sizeof(smart_stage_row);
    const uint32_t *words = glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, (GLsizeiptr)bytes, GL_MAP_READ_BIT);
    assert_non_null(words);
    ref_smart_image image = smart_stage_image(t, words);
    glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
    return image;
}

/* Returns the picture. */
static inline float *smart_stage_end(smart_stage *t) {
    oit_scene_expect(oit_compose(t->set.oit), "oit_compose");
    oit_scene_expect(oit_end(t->set.oit), "oit_end");
    return oit_setting_read(&t->set, t->set.framebuffer);
}

/* A frame with these operators. image (may be NULL): what they left of each fragment. Returns the picture. */
static inline float *smart_stage_frame(smart_stage *t, const oit_operator *ops, size_t op_count, const size_t *order,
                                       ref_smart_image *image) {
    smart_stage_begin(t, order);
    for (size_t i = 0; i < op_count; ++i)
        smart_stage_run(t, &ops[i]);
    if (image)
        *image = smart_stage_look(t);
    return smart_stage_end(t);
}

static inline ref_smart_links smart_stage_links(const smart_stage *t, const oit_link *link) {
    static const ref_smart_criterion criteria[4] = {REF_SMART_BY_DEPTH, REF_SMART_BY_UV, REF_SMART_PUBLISHED,
                                                    REF_SMART_MURRAY};
    ref_smart_links links;
    memset(&links, 0, sizeof links);
    links.criterion = criteria[link->criterion];
    links.depth_weight = links.normal_weight = 0.5;
    if (link->depth_weight > 0 || link->normal_weight > 0) {
        links.depth_weight = (double)link->depth_weight;
        links.normal_weight = (double)link->normal_weight;
    }
    links.radius = link->radius > 0 ? (double)link->radius : 1;
    links.limit = link->limit > 0 ? (double)link->limit : link->limit < 0 ? (double)INFINITY : (double)0.04f;
    links.no_reverse_check = link->no_reverse_check != 0;
    float ignored[16];
    smart_stage_projection(t, ignored, links.projection);
    return links;
}

#endif

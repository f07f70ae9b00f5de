/* alpha_field.h: one transparent object and the field of alpha on it in double, pixel by pixel, for tests of the alpha
 * ladder and for what its rungs cost. The rungs' input is silhouette.h's; the truth is nearest segments tried one by one. */
#ifndef GLASSINE_TESTS_ALPHA_FIELD_H
#define GLASSINE_TESTS_ALPHA_FIELD_H

#include "gl_harness.h"

#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#include "scene.h"

#ifndef FIELD_SIZE
#define FIELD_SIZE 192
#endif
#ifndef FIELD_STEP
#define FIELD_STEP 1 /* the truth is found at every so many pixels across and down */
#endif
#define FIELD_PIXELS (FIELD_SIZE * FIELD_SIZE)

/* ---- one object: its triangles, its silhouettes, and what the pixels see of it in double ---- */

typedef struct field_sight {
    bool seen, left_out; /* left out: next to the background, or to a surface far behind */
    uint32_t triangle;
    double place[3], weight[3], alpha; /* in the world; of the triangle's corners; of equation 2 */
} field_sight;

typedef struct field {
    const float *positions;
    const uint32_t *indices;
    uint32_t *welded;
    size_t vertex_count, triangle_count;
    double model[16], projection[16], view_projection[16], eye[4]; /* eye in object space */
    float linear[9];
    sil_mesh *mesh;
    sil_edge *edges;
    size_t edge_count, candidate_count;
    uint32_t *offsets, *candidates, *order;
    float *distances; /* at vertices */
    float d_max, k;
    GLuint array, flat_array, buffers[4]; /* flat_array: without indices, three vertices a triangle */
    field_sight *sights;
} field;

static inline void field_apply(const double m[16], const double p[3], double out[4]) {
    for (int i = 0; i < 4; ++i)
        out[i] = m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i];
}

static inline void field_corner_of(const field *f, uint32_t vertex, double out[3]) {
    for (int k = 0; k < 3; ++k)
        out[k] = (double)f->positions[3 * (size_t)vertex + (size_t)k];
}

/* Equation 2 with the paper's distance, to the nearest point of the nearest silhouette edge. */
static inline double field_truth_at(const field *f, const double place[3]) {
    double least = HUGE_VAL;
    for (size_t i = 0; i < f->edge_count; ++i) {
        double ends[2][3], world[2][4];
        field_corner_of(f, f->edges[i].a, ends[0]);
        field_corner_of(f, f->edges[i].b, ends[1]);
        for (int e = 0; e < 2; ++e)
            field_apply(f->model, ends[e], world[e]);
        double along = 0, square = 0, distance = 0;
        for (int k = 0; k < 3; ++k) {
            along += (place[k] - world[0][k]) * (world[1][k] - world[0][k]);
            square += (world[1][k] - world[0][k]) * (world[1][k] - world[0][k]);
        }
        double t = square > 0 ? fmin(fmax(along / square, 0), 1) : 0;
        for (int k = 0; k < 3; ++k) {
            double d = place[k] - world[0][k] - t * (world[1][k] - world[0][k]);
            distance += d * d;
        }
        least = fmin(least, sqrt(distance));
    }
    return ref_alpha(least, (double)f->d_max, (double)f->k);
}

/* The pixels of one front face, in double; the nearest wins. */
static inline void field_rasterise(field *f, uint32_t triangle, double *depths) {
    double clip[3][4], world[3][4], x[3], y[3], low[2] = {FIELD_SIZE, FIELD_SIZE}, high[2] = {0, 0};
    for (int c = 0; c < 3; ++c) {
        double corner[3];
        field_corner_of(f, f->indices[3 * (size_t)triangle + (size_t)c], corner);
        field_apply(f->model, corner, world[c]);
        field_apply(f->view_projection, world[c], clip[c]);
        if (!(clip[c][3] > 0))
            return;
        x[c] = (clip[c][0] / clip[c][3] * 0.5 + 0.5) * FIELD_SIZE;
        y[c] = (clip[c][1] / clip[c][3] * 0.5 + 0.5) * FIELD_SIZE;
        low[0] = fmin(low[0], x[c]), high[0] = fmax(high[0], x[c]);
        low[1] = fmin(low[1], y[c]), high[1] = fmax(high[1], y[c]);
    }
    double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    if (!(area > 0))
        return;
    for (int py = (int)fmax(low[1], 0); py < FIELD_SIZE && py <= high[1]; ++py)
        for (int px = (int)fmax(low[0], 0); px < FIELD_SIZE && px <= high[0]; ++px) {
            double w[3], sum = 0, depth = 0;
            for (int c = 0; c < 3; ++c) {
                int a = (c + 1) % 3, b = (c + 2) % 3;
                w[c] = ((x[a] - px - 0.5) * (y[b] - py - 0.5) - (x[b] - px - 0.5) * (y[a] - py - 0.5)) / area;
                depth += w[c] * clip[c][2] / clip[c][3];
            }
            if (w[0] < 0 || w[1] < 0 || w[2] < 0 || depth >= depths[py * FIELD_SIZE + px])
                continue;
            field_sight *s = &f->sights[py * FIELD_SIZE + px];
            depths[py * FIELD_SIZE + px] = depth;
            s->seen = true;
            s->triangle = triangle;
            for (int c = 0; c < 3; ++c)
                sum += w[c] / clip[c][3];
            for (int c = 0; c < 3; ++c)
                s->weight[c] = w[c] / clip[c][3] / sum;
            for (int k = 0; k < 3; ++k)
                s->place[k] = (w[0] / clip[0][3] * world[0][k] + w[1] / clip[1][3] * world[1][k] +
                               w[2] / clip[2][3] * world[2][k]) /
                              sum;
        }
}

/* How many corners two triangles share, by place. */
static inline int field_shared_corners(const field *f, uint32_t a, uint32_t b) {
    int shared = 0;
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j)
            shared += f->welded[f->indices[3 * (size_t)a + i]] == f->welded[f->indices[3 * (size_t)b + j]];
    return shared;
}

static inline bool field_is_sampled(int pixel) {
    return pixel % FIELD_SIZE % FIELD_STEP == 0 && pixel / FIELD_SIZE % FIELD_STEP == 0;
}

static inline void field_find_truth(field *f) {
    for (int i = 0; i < FIELD_PIXELS; ++i)
        if (f->sights[i].seen && field_is_sampled(i))
            f->sights[i].alpha = field_truth_at(f, f->sights[i].place);
}

static inline void field_look(field *f) {
    double *depths = malloc(FIELD_PIXELS * sizeof *depths);
    f->sights = calloc(FIELD_PIXELS, sizeof *f->sights);
    assert_true(depths && f->sights);
    for (int i = 0; i < FIELD_PIXELS; ++i)
        depths[i] = HUGE_VAL;
    for (uint32_t t = 0; t < f->triangle_count; ++t)
        field_rasterise(f, t, depths);
    for (int i = 0; i < FIELD_PIXELS; ++i) {
        field_sight *s = &f->sights[i];
        int x = i % FIELD_SIZE, y = i / FIELD_SIZE;
        if (!s->seen)
            continue;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                bool within = x + dx >= 0 && x + dx < FIELD_SIZE && y + dy >= 0 && y + dy < FIELD_SIZE;
                const field_sight *n = within ? &f->sights[(y + dy) * FIELD_SIZE + x + dx] : s;
                double apart = 0;
                for (int k = 0; k < 3; ++k)
                    apart = fmax(apart, fabs(s->place[k] - n->place[k]));
                s->left_out = s->left_out || !n->seen || apart > 0.1 * (double)f->d_max;
            }
    }
    free(depths);
    field_find_truth(f);
}

/* ---- making one ---- */

static inline void field_place_camera(field *f, const double center[3], double radius, const double turn[2]) {
    double c = cos(turn[0]), s = sin(turn[0]), c2 = cos(turn[1]), s2 = sin(turn[1]);
    const double rows[3][3] = {{c, 0, -s}, {-s * s2, c2, -c * s2}, {s * c2, s2, c * c2}};
    double view[16] = {0}, distance = 3.2 * radius, n = radius, far_plane = 6 * radius, half = 0.36;
    for (int r = 0; r < 3; ++r) {
        view[12 + r] = r == 2 ? -distance : 0;
        for (int k = 0; k < 3; ++k) {
            view[4 * k + r] = rows[r][k];
            view[12 + r] -= rows[r][k] * center[k];
        }
    }
    view[15] = 1;
    const double projection[16] = {1 / half,
                                   0,
                                   0,
                                   0,
                                   0,
                                   1 / half,
                                   0,
                                   0,
                                   0,
                                   0,
                                   -(far_plane + n) / (far_plane - n),
                                   -1,
                                   0,
                                   0,
                                   -2 * far_plane * n / (far_plane - n),
                                   0};
    memcpy(f->projection, projection, sizeof f->projection);
    harness_multiply(projection, view, f->view_projection);
    double world[3];
    for (int k = 0; k < 3; ++k)
        world[k] = center[k] + rows[2][k] * distance;
    /* Back into object space by Cramer's rule; the model is affine. */
    const double *m = f->model;
    double d[3], det = m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) +
                       m[8] * (m[1] * m[6] - m[2] * m[5]);
    for (int k = 0; k < 3; ++k)
        d[k] = world[k] - m[12 + k];
    f->eye[0] = (d[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (d[1] * m[10] - d[2] * m[9]) +
                 m[8] * (d[1] * m[6] - d[2] * m[5])) /
                det;
    f->eye[1] = (m[0] * (d[1] * m[10] - d[2] * m[9]) - d[0] * (m[1] * m[10] - m[2] * m[9]) +
                 m[8] * (m[1] * d[2] - m[2] * d[1])) /
                det;
    f->eye[2] =
        (m[0] * (m[5] * d[2] - m[6] * d[1]) - m[4] * (m[1] * d[2] - m[2] * d[1]) + d[0] * (m[1] * m[6] - m[2] * m[5])) /
        det;
    f->eye[3] = 1;
}

/* What the rungs and the truth are given for a set of edges, which becomes the field's. */
static inline void field_take_edges(field *f, sil_edge *edges, size_t count) {
    sil_distance_desc distance;
    size_t needed = 0;
    memset(&distance, 0, sizeof distance);
    memcpy(distance.model, f->linear, sizeof distance.model);
    free(f->edges);
    free(f->candidates);
    free(f->order);
    f->edges = edges;
    f->edge_count = count;
    f->order = malloc((count + 1) * sizeof *f->order);
    sil_edge_tree *tree = sil_edge_tree_create(f->mesh, NULL);
    assert_true(f->order && tree);
    assert_int_equal(sil_edge_tree_build(tree, NULL, edges, count, &distance), SIL_OK);
    assert_int_equal(sil_distances_by_tree(tree, 0, f->vertex_count, f->distances, NULL), SIL_OK);
    assert_int_equal(sil_edge_tree_order(tree, f->order, count), count);
    assert_int_equal(sil_candidates(tree, f->positions, 0, f->vertex_count, f->indices, f->triangle_count, f->offsets,
                                    NULL, 0, &needed),
                     SIL_OK);
    f->candidates = malloc((needed + 1) * sizeof *f->candidates);
    assert_int_equal(sil_candidates(tree, f->positions, 0, f->vertex_count, f->indices, f->triangle_count, f->offsets,
                                    f->candidates, needed, &f->candidate_count),
                     SIL_OK);
    sil_edge_tree_destroy(tree);
}

static inline void field_find_edges(field *f) {
    sil_mesh_desc desc;
    sil_view view = sil_view_perspective(f->eye);
    memset(&desc, 0, sizeof desc);
    desc.positions = f->positions;
    desc.vertex_count = f->vertex_count;
    desc.indices = f->indices;
    desc.index_count = 3 * f->triangle_count;
    f->mesh = sil_mesh_create(&desc, NULL);
    f->distances = malloc(f->vertex_count * sizeof *f->distances);
    f->offsets = malloc((f->triangle_count + 1) * sizeof *f->offsets);
    size_t count = sil_extract(f->mesh, NULL, &view, SIL_SILHOUETTE | SIL_BOUNDARY, NULL, 0);
    sil_edge *edges = calloc(count + 1, sizeof *edges);
    assert_true(f->mesh && f->distances && f->offsets && edges);
    sil_extract(f->mesh, NULL, &view, SIL_SILHOUETTE | SIL_BOUNDARY, edges, count);
    field_take_edges(f, edges, count);
    f->d_max = sil_max_distance(f->mesh, NULL, f->linear);
}

/* The arrays stay the caller's. model: column-major 4x4. */
static inline void field_open(field *f, const scene_mesh *mesh, const double model[16], const double turn[2]) {
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, center[3], radius = 0;
    memset(f, 0, sizeof *f);
    f->positions = mesh->positions;
    f->indices = mesh->indices;
    f->vertex_count = mesh->vertex_count;
    f->triangle_count = mesh->index_count / 3;
    f->k = 0.45f;
    memcpy(f->model, model, sizeof f->model);
    for (int i = 0; i < 9; ++i)
        f->linear[i] = (float)model[i / 3 * 4 + i % 3];
    for (uint32_t i = 0; i < f->vertex_count; ++i) {
        double p[3], world[4];
        field_corner_of(f, i, p);
        field_apply(f->model, p, world);
        for (int k = 0; k < 3; ++k) {
            low[k] = fmin(low[k], world[k]);
            high[k] = fmax(high[k], world[k]);
        }
    }
    for (int k = 0; k < 3; ++k) {
        center[k] = 0.5 * (low[k] + high[k]);
        radius += 0.25 * (high[k] - low[k]) * (high[k] - low[k]);
    }
    field_place_camera(f, center, sqrt(radius), turn);
    field_find_edges(f);
    f->welded = malloc(f->vertex_count * sizeof *f->welded);
    scene_weld(f->positions, f->vertex_count, f->welded);
    field_look(f);
}

static inline void field_upload(field *f) {
    size_t corners = 3 * f->triangle_count;
    uint32_t *flat = malloc(corners * 4 * sizeof *flat); /* positions, then numbers: only the last corner's counts */
    for (size_t i = 0; i < corners; ++i) {
        memcpy(flat + 3 * i, f->positions + 3 * (size_t)f->indices[i], 3 * sizeof(float));
        flat[3 * corners + i] = i % 3 == 2 ? (uint32_t)(i / 3) : 123456u;
    }
    glGenVertexArrays(1, &f->array);
    glGenVertexArrays(1, &f->flat_array);
    glGenBuffers(4, f->buffers);
    glBindVertexArray(f->array);
    glBindBuffer(GL_ARRAY_BUFFER, f->buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(f->vertex_count * 3 * sizeof(float)), f->positions, GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, NULL);
    glEnableVertexAttribArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, f->buffers[1]);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(f->vertex_count * sizeof(float)), f->distances, GL_DYNAMIC_DRAW);
    glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, 0, NULL);
    glEnableVertexAttribArray(2);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, f->buffers[2]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(corners * sizeof(uint32_t)), f->indices, GL_STATIC_DRAW);
    glBindVertexArray(f->flat_array);
    glBindBuffer(GL_ARRAY_BUFFER, f->buffers[3]);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(corners * 4 * sizeof *flat), flat, GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, NULL);
    glEnableVertexAttribArray(0);
    glVertexAttribIPointer(4, 1, GL_UNSIGNED_INT, 0, (const void *)(3 * corners * sizeof *flat));
    glEnableVertexAttribArray(4);
    glBindVertexArray(0);
    free(flat);
}

static inline void field_close(field *f) {
    if (f->array) {
        glDeleteVertexArrays(1, &f->array);
        glDeleteVertexArrays(1, &f->flat_array);
        glDeleteBuffers(4, f->buffers);
    }
    sil_mesh_destroy(f->mesh);
    free(f->edges);
    free(f->distances);
    free(f->offsets);
    free(f->candidates);
    free(f->order);
    free(f->welded);
    free(f->sights);
}

/* ---- drawing ---- */

static inline tr_edges field_edges_of(const field *f, tr_alpha alpha) {
    tr_edges edges;
    memset(&edges, 0, sizeof edges);
    edges.positions = f->positions;
    edges.position_count = f->vertex_count;
    edges.ends = &f->edges[0].a;
    edges.end_stride = sizeof *f->edges;
    edges.edge_count = f->edge_count;
    edges.order = alpha == TR_ALPHA_EXACT ? f->order : NULL;
    edges.offsets = alpha == TR_ALPHA_CANDIDATES ? f->offsets : NULL;
    edges.candidates = alpha == TR_ALPHA_CANDIDATES ? f->candidates : NULL;
    edges.triangle_count = f->triangle_count;
    memcpy(edges.model, f->linear, sizeof edges.model);
    return edges;
}

static inline tr_frame field_frame_of(const harness *h, tr_alpha alpha) {
    tr_frame frame;
    memset(&frame, 0, sizeof frame);
    frame.framebuffer = h->framebuffer;
    frame.width = h->width;
    frame.height = h->height;
    frame.scene.transparent = 1;
    frame.wishes.alpha = alpha;
    frame.flat_shading = 1;
    return frame;
}

static inline tr_material field_material_of(const field *f, const tr_edge_set *set) {
    tr_material material;
    double mvp[16];
    memset(&material, 0, sizeof material);
    harness_multiply(f->view_projection, f->model, mvp);
    for (int i = 0; i < 16; ++i)
        material.model_view_projection[i] = (float)mvp[i];
    material.normal_matrix[0] = material.normal_matrix[4] = material.normal_matrix[8] = 1;
    material.color[3] = 1;
    material.d_max = f->d_max;
    material.k = f->k;
    material.object = 1;
    material.edges = set;
    return material;
}

static inline void field_draw(const field *f, tr_alpha alpha) {
    if (alpha == TR_ALPHA_CANDIDATES) {
        glBindVertexArray(f->flat_array);
        glDrawArrays(GL_TRIANGLES, 0, (GLsizei)(3 * f->triangle_count));
    } else {
        glBindVertexArray(f->array);
        glDrawElements(GL_TRIANGLES, (GLsizei)(3 * f->triangle_count), GL_UNSIGNED_INT, NULL);
    }
    glBindVertexArray(0);
}

static inline GLuint field_compile(harness *h, tr_stage stage, tr_alpha alpha, const char *own) {
    const char *strings[128];
    int count = 0, more = 0, ok = 0;
    const char *const *rules = tr_glsl(h->tr, stage, TR_RULE_FRONT_ALONE, &count);
    memcpy(strings, rules, (size_t)count * sizeof *strings);
    const char *const *ladder = tr_alpha_glsl(h->tr, stage, alpha, &more);
    memcpy(strings + count, ladder, (size_t)more * sizeof *strings);
    strings[count + more] = own;
    GLuint shader = glCreateShader(stage == TR_VERTEX ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
    glShaderSource(shader, count + more + 1, strings, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok) {
        char log[1024];
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        fail_msg("%s", log);
    }
    return shader;
}

/* A host's own program, that writes alpha as it is. */
static inline GLuint field_link_own(harness *h, tr_alpha alpha) {
    GLuint vertex = field_compile(h, TR_VERTEX, alpha,
                                  "layout(location = 0) in highp vec3 corner;\n"
                                  "layout(location = 2) in highp float outline;\n"
                                  "layout(location = 4) in highp uint number;\n"
                                  "uniform highp mat4 to_clip;\n"
                                  "void main() {\n"
                                  "    tr_alpha_vertex(corner, outline, number);\n"
                                  "    gl_Position = to_clip * vec4(corner, 1.0);\n"
                                  "}\n");
    GLuint fragment = field_compile(h, TR_FRAGMENT, alpha, "void main() { tr_color = vec4(tr_alpha()); }\n");
    GLuint program = glCreateProgram();
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    assert_int_equal(tr_prepare_program(h->tr, program), TR_OK);
    return program;
}

/* Alpha in float, by a program of the host's in a target of the host's: what a pass binds for it is there. */
static inline void field_draw_own(harness *h, const field *f, tr_alpha alpha, const tr_edge_set *set, float *out) {
    tr_frame frame = field_frame_of(h, alpha);
    tr_material material = field_material_of(f, set);
    GLuint program = field_link_own(h, alpha), names[2], target;
    tr_pass pass;
    glGenFramebuffers(1, &target);
    glGenRenderbuffers(2, names);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    for (int i = 0; i < 2; ++i) {
        glBindRenderbuffer(GL_RENDERBUFFER, names[i]);
        glRenderbufferStorage(GL_RENDERBUFFER, i ? GL_DEPTH_COMPONENT24 : GL_RGBA32F, FIELD_SIZE, FIELD_SIZE);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, i ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  names[i]);
    }
    assert_int_equal(tr_begin(h->tr, &frame), TR_OK);
    while (tr_next_pass(h->tr, &pass)) {
        if (pass.rule != TR_RULE_FRONT_ALONE)
            continue;
        glBindFramebuffer(GL_FRAMEBUFFER, target);
        glClearColor(-1, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glUseProgram(program);
        glUniformMatrix4fv(glGetUniformLocation(program, "to_clip"), 1, GL_FALSE, material.model_view_projection);
        glUniform2f(glGetUniformLocation(program, "tr_falloff"), material.d_max, material.k);
        if (alpha == TR_ALPHA_IMAGE) {
            float outline[3];
            tr_outline_uniform(h->tr, outline);
            glUniform3fv(glGetUniformLocation(program, "tr_outline"), 1, outline);
        }
        if (set) {
            glUniform4fv(glGetUniformLocation(program, "tr_edge_frame"), 4, set->frame);
            glUniform4uiv(glGetUniformLocation(program, "tr_edge_ranges"), 1, set->ranges);
        }
        field_draw(f, alpha);
        glReadPixels(0, 0, FIELD_SIZE, FIELD_SIZE, GL_RED, GL_FLOAT, out);
    }
    assert_int_equal(tr_end(h->tr), TR_OK);
    glDeleteFramebuffers(1, &target);
    glDeleteRenderbuffers(2, names);
    glDeleteProgram(program);
}

/* ---- comparing ---- */

typedef struct field_verdict {
    double max, rms, left_out, crossings, smooth; /* smooth: share of crossings without a seam */
} field_verdict;

/* Four pixels in a row, or column: two of one triangle, then two of the next, across one edge. */
static inline bool field_crosses(const field *f, const field_sight *s[4]) {
    for (int i = 0; i < 4; ++i)
        if (!s[i]->seen || s[i]->left_out)
            return false;
    return s[0]->triangle == s[1]->triangle && s[2]->triangle == s[3]->triangle && s[1]->triangle != s[2]->triangle &&
           field_shared_corners(f, s[1]->triangle, s[2]->triangle) == 2;
}

static inline field_verdict field_judge(const field *f, const float *alpha) {
    field_verdict v = {0, 0, 0, 0, 0};
    double seen = 0, compared = 0;
    for (int i = 0; i < FIELD_PIXELS; ++i) {
        const field_sight *s = &f->sights[i];
        if (!field_is_sampled(i))
            continue;
        seen += s->seen;
        if (!s->seen || s->left_out)
            continue;
        double error = fabs((double)alpha[i] - s->alpha);
        v.max = fmax(v.max, error);
        v.rms += error * error;
        ++compared;
        for (int down = 0; down < 2 && FIELD_STEP == 1; ++down) {
            int step = down ? FIELD_SIZE : 1;
            if ((down ? i / FIELD_SIZE : i % FIELD_SIZE) + 3 >= FIELD_SIZE)
                continue;
            const field_sight *four[4] = {s, s + step, s + 2 * step, s + 3 * step};
            if (!field_crosses(f, four))
                continue;
            double e[4]; /* the jump and the slope's jump of alpha less those of the truth are those of the error */
            for (int j = 0; j < 4; ++j)
                e[j] = (double)alpha[i + j * step] - four[j]->alpha;
            ++v.crossings;
            v.smooth += fabs(e[2] - e[1]) <= 1 / 255.0 && fabs((e[3] - e[2]) - (e[1] - e[0])) <= 1 / 255.0;
        }
    }
    v.rms = compared > 0 ? sqrt(v.rms / compared) : 0;
    v.left_out = seen > 0 ? (seen - compared) / seen : 0;
    v.smooth = v.crossings > 0 ? v.smooth / v.crossings : 1;
    return v;
}

/* ---- the image-space rung ---- */

static inline GLuint field_texture(GLint internal, GLenum format, GLenum type, int width, int height,
                                   const void *texels) {
    GLuint name;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    return name;
}

/* The object's depth, as a host would draw it before the frame. */
static inline GLuint field_draw_depth(harness *h, const field *f) {
    GLuint target,
        texture = field_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, FIELD_SIZE, FIELD_SIZE, NULL);
    GLuint program = field_link_own(h, TR_ALPHA_DISTANCE);
    tr_material material = field_material_of(f, NULL);
    glGenFramebuffers(1, &target);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
    const GLenum none = GL_NONE;
    glDrawBuffers(1, &none);
    glViewport(0, 0, FIELD_SIZE, FIELD_SIZE);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT);
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "to_clip"), 1, GL_FALSE, material.model_view_projection);
    field_draw(f, TR_ALPHA_DISTANCE);
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &target);
    glDeleteProgram(program);
    return texture;
}

/* The image of it that outlines are found in; the texture is the caller's to delete. */
static inline GLuint field_draw_image(harness *h, const field *f, tr_outlines *image) {
    memset(image, 0, sizeof *image);
    image->depth_texture = field_draw_depth(h, f);
    image->width = image->height = FIELD_SIZE;
    for (int i = 0; i < 16; ++i)
        image->projection[i] = (float)f->projection[i];
    return image->depth_texture;
}

static inline field_verdict field_measure_image(harness *h, const field *f, float *out) {
    tr_outlines image;
    GLuint depth = field_draw_image(h, f, &image);
    assert_int_equal(tr_find_outlines(h->tr, &image), TR_OK);
    field_draw_own(h, f, TR_ALPHA_IMAGE, NULL, out);
    glDeleteTextures(1, &depth);
    return field_judge(f, out);
}

#endif

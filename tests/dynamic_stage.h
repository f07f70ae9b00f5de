/* dynamic_stage.h: small scenes of units for the tests of dynamic transparency: the reference and GL draw the same arrays,
 * object by object, in flat colours. */
#ifndef GLASSINE_TESTS_DYNAMIC_STAGE_H
#define GLASSINE_TESTS_DYNAMIC_STAGE_H

#include "gl_harness.h"
#include "reference_dynamic.h"

enum { STAGE_MOST = 64 };

typedef struct stage_unit {
    tr_unit unit; /* first: the header strides over these */
    float *positions;
    uint32_t *indices;
    size_t points, corners;
    GLuint array, buffers[2];
} stage_unit;

typedef struct stage stage;
struct stage {
    stage_unit units[STAGE_MOST];
    ref_object meshes[STAGE_MOST];
    ref_dyn_object marks[STAGE_MOST];
    ref_dyn_light lights[TR_MAX_LIGHTS];
    tr_light tr_lights[TR_MAX_LIGHTS];
    ref_scene scene;
    ref_dyn_scene truth;
    tr_dynamic wish; /* what the truth does not say */
    tr_frame frame;
    GLuint programs[TR_RULE_SEE_END];
    size_t count;
    int passes[TR_PASS_KIND_COUNT]; /* of the last picture, passes that the host drew; and draws in them */
    int draws[TR_PASS_KIND_COUNT];
    ref_dyn_pixel *pixels;
    double *weights;
    unsigned char *picture;
    void (*spoil)(stage *s); /* NULL, or what is done to what the header is told */
    bool srgb;               /* the target encodes what is drawn: colours are light */
};

/* ---- numbers ---- */

typedef struct stage_dice {
    uint64_t state;
} stage_dice;

static inline double stage_throw(stage_dice *dice, double low, double high) {
    dice->state = dice->state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(dice->state >> 11) / 9007199254740992.0;
}

static inline size_t stage_pick(stage_dice *dice, size_t count) {
    return (size_t)stage_throw(dice, 0, (double)count);
}

/* ---- scenes ---- */

static inline void stage_look(stage *s, double distance, double azimuth, double elevation) {
    double ca = cos(azimuth), sa = sin(azimuth), ce = cos(elevation), se = sin(elevation);
    const double view[16] = {ca, -se * sa, ce * sa, 0, 0, ce, se, 0, -sa, -se * ca, ce * ca, 0, 0, 0, -distance, 1};
    memcpy(s->scene.view, view, sizeof view);
}

static inline void stage_lens(stage *s, double half, double first, double last) {
    double *m = s->scene.projection;
    memset(m, 0, sizeof s->scene.projection);
    m[0] = 1 / half * (double)s->scene.height / (double)s->scene.width;
    m[5] = 1 / half;
    m[10] = -(last + first) / (last - first);
    m[11] = -1;
    m[14] = -2 * last * first / (last - first);
}

static inline stage *stage_new(int width, int height) {
    stage *s = calloc(1, sizeof *s);
    assert_non_null(s);
    ref_dyn_defaults(&s->truth);
    s->truth.scene = &s->scene;
    s->truth.objects = s->marks;
    s->truth.lights = s->lights;
    s->scene.objects = s->meshes;
    s->scene.width = width;
    s->scene.height = height;
    for (int k = 0; k < 3; ++k)
        s->scene.background[k] = 0.9 - 0.1 * k;
    stage_look(s, 12, 0.4, 0.5);
    stage_lens(s, 0.5, 2, 40);
    s->frame.width = width;
    s->frame.height = height;
    return s;
}

static inline size_t stage_add(stage *s, uint32_t flags, size_t points, size_t corners) {
    size_t i = s->count++;
    assert_true(i < STAGE_MOST);
    ref_object *mesh = &s->meshes[i];
    stage_unit *u = &s->units[i];
    memset(mesh, 0, sizeof *mesh);
    for (int k = 0; k < 4; ++k)
        mesh->model[5 * k] = 1;
    mesh->id = (uint32_t)i + 1;
    mesh->color[0] = fmod(0.37 * (double)(i + 1), 1);
    mesh->color[1] = fmod(0.61 * (double)(i + 1), 1);
    mesh->color[2] = fmod(0.83 * (double)(i + 1), 1);
    mesh->positions = u->positions = calloc(3 * points, sizeof *u->positions);
    mesh->indices = u->indices = calloc(corners, sizeof *u->indices);
    s->marks[i].flags = flags;
    s->marks[i].importance = flags & REF_DYN_TARGET ? 1 : 0;
    s->scene.object_count = s->count;
    return i;
}

static inline void stage_point(stage *s, size_t at, double x, double y, double z) {
    float *p = s->units[at].positions + 3 * s->units[at].points++;
    p[0] = (float)x;
    p[1] = (float)y;
    p[2] = (float)z;
    s->meshes[at].vertex_count = s->units[at].points;
}

static inline void stage_quad(stage *s, size_t at, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    const uint32_t corners[6] = {a, b, c, a, c, d};
    memcpy(s->units[at].indices + s->units[at].corners, corners, sizeof corners);
    s->units[at].corners += 6;
    s->meshes[at].triangle_count = s->units[at].corners / 3;
}

/* A box about a middle, turned about the y axis. */
static inline size_t stage_box(stage *s, uint32_t flags, const double middle[3], const double half[3], double turn) {
    size_t at = stage_add(s, flags, 8, 36);
    for (int i = 0; i < 8; ++i) {
        double x = i & 1 ? half[0] : -half[0], y = i & 2 ? half[1] : -half[1], z = i & 4 ? half[2] : -half[2];
        stage_point(s, at, middle[0] + cos(turn) * x + sin(turn) * z, middle[1] + y,
                    middle[2] - sin(turn) * x + cos(turn) * z);
    }
    stage_quad(s, at, 4, 5, 7, 6);
    stage_quad(s, at, 0, 2, 3, 1);
    stage_quad(s, at, 0, 1, 5, 4);
    stage_quad(s, at, 3, 2, 6, 7);
    stage_quad(s, at, 1, 3, 7, 5);
    stage_quad(s, at, 2, 0, 4, 6);
    return at;
}

/* A torus that lies flat; from most sides the eye sees two front faces of it, one behind the other. */
static inline size_t stage_ring(stage *s, uint32_t flags, const double middle[3], double large, double small_) {
    enum { AROUND = 24, ACROSS = 10 };
    size_t at = stage_add(s, flags, AROUND * ACROSS, 6 * AROUND * ACROSS);
    for (int i = 0; i < AROUND; ++i)
        for (int j = 0; j < ACROSS; ++j) {
            double a = 6.28318530717959 * i / AROUND, b = 6.28318530717959 * j / ACROSS, r = large + small_ * cos(b);
            stage_point(s, at, middle[0] + r * cos(a), middle[1] + small_ * sin(b), middle[2] - r * sin(a));
        }
    for (uint32_t i = 0; i < AROUND; ++i)
        for (uint32_t j = 0; j < ACROSS; ++j) {
            uint32_t k = (i + 1) % AROUND, l = (j + 1) % ACROSS;
            stage_quad(s, at, i * ACROSS + j, k * ACROSS + j, k * ACROSS + l, i * ACROSS + l);
        }
    return at;
}

/* A sheet that faces +z. */
static inline size_t stage_sheet(stage *s, uint32_t flags, double x0, double y0, double x1, double y1, double z) {
    size_t at = stage_add(s, flags, 4, 6);
    stage_point(s, at, x0, y0, z);
    stage_point(s, at, x1, y0, z);
    stage_point(s, at, x1, y1, z);
    stage_point(s, at, x0, y1, z);
    stage_quad(s, at, 0, 1, 2, 3);
    return at;
}

/* What the header is told is what the truth is told. */
static inline void stage_tell(stage *s) {
    const ref_dyn_scene *t = &s->truth;
    tr_dynamic *wish = &s->wish;
    for (size_t i = 0; i < s->count; ++i) {
        tr_unit *unit = &s->units[i].unit;
        const ref_dyn_object *mark = &s->marks[i];
        double low[3] = {REF_NONE, REF_NONE, REF_NONE}, high[3] = {-REF_NONE, -REF_NONE, -REF_NONE}, square = 0;
        for (size_t v = 0; v < 3 * s->units[i].points; ++v) {
            low[v % 3] = fmin(low[v % 3], (double)s->units[i].positions[v]);
            high[v % 3] = fmax(high[v % 3], (double)s->units[i].positions[v]);
        }
        for (int k = 0; k < 3; ++k) {
            unit->center[k] = (float)((low[k] + high[k]) / 2);
            square += (high[k] - low[k]) * (high[k] - low[k]) / 4;
        }
        unit->radius = (float)(sqrt(square) * 1.00001);
        unit->id = s->meshes[i].id;
        unit->flags = mark->flags; /* the bits are the same */
        unit->importance = mark->importance > 0 ? (float)mark->importance : -1.0f;
        unit->group = mark->group;
        unit->rank = mark->rank;
        unit->fade = (float)mark->faded;
    }
    for (size_t i = 0; i < t->light_count; ++i) {
        const ref_dyn_light *l = &s->lights[i];
        s->tr_lights[i].x = (float)l->x;
        s->tr_lights[i].y = (float)l->y;
        s->tr_lights[i].radius = (float)l->radius;
        s->tr_lights[i].edge = (float)l->edge;
    }
    wish->shape = (tr_mask_shape)t->shape;
    wish->combine = (tr_mask_combine)t->combine;
    wish->occluders = (tr_occluders)t->occluders;
    wish->alpha_target = t->alpha_target > 0 ? (float)t->alpha_target : -1.0f;
    wish->alpha_start = t->alpha_start > 0 ? (float)t->alpha_start : -1.0f;
    wish->width = t->width > 0 ? (float)t->width : -1.0f;
    wish->layers = (int)t->layers;
    wish->lights = s->tr_lights;
    wish->light_count = t->light_count;
    wish->units = s->units;
    wish->unit_count = s->count;
    wish->unit_stride = sizeof s->units[0];
    for (int k = 0; k < 3; ++k)
        wish->background[k] = (float)s->scene.background[k];
    for (int k = 0; k < 16; ++k) {
        wish->view[k] = (float)s->scene.view[k];
        wish->projection[k] = (float)s->scene.projection[k];
    }
    if (s->spoil)
        s->spoil(s);
}

/* ---- drawing ---- */

static inline GLuint stage_shader(GLenum type, const char *const *strings, int count, const char *text) {
    const char *all[64];
    char log[2048] = "";
    GLint ok = 0;
    assert_true(count < 63);
    memcpy(all, strings, (size_t)count * sizeof *all);
    all[count] = text;
    GLuint shader = glCreateShader(type);
    glShaderSource(shader, count + 1, all, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    if (!ok)
        fail_msg("%s", log);
    return shader;
}

/* A host's own program, with the header's strings before it. */
static inline GLuint stage_program(harness *h, tr_rule rule) {
    static const char vertex[] = "uniform highp mat4 u_matrix;\n"
                                 "layout(location = 0) in highp vec3 a_position;\n"
                                 "void main() { gl_Position = u_matrix * vec4(a_position, 1.0); }\n";
    static const char plain[] = "uniform highp vec4 u_color;\n"
                                "layout(location = 0) out highp vec4 o_color;\n"
                                "void main() { o_color = u_color; }\n";
    static const char fragment[] = "uniform highp vec4 u_color;\n"
                                   "uniform highp uint u_code;\n"
                                   "layout(location = 0) out highp vec4 o_color;\n"
                                   "void main() {\n"
                                   "    highp vec4 color = u_color;\n"
                                   "    tr_see_through(color, u_code);\n"
                                   "    o_color = color;\n"
                                   "}\n";
    int counts[2] = {0, 0};
    const char *const *strings[2] = {tr_glsl(h->tr, TR_VERTEX, rule, &counts[0]),
                                     tr_glsl(h->tr, TR_FRAGMENT, rule, &counts[1])};
    GLint ok = 0;
    if (rule == TR_RULE_SEE_PLAIN)
        counts[1] = h->context.es ? 2 : 1; /* the version, and precision */
    GLuint program = glCreateProgram();
    GLuint parts[2] = {
        stage_shader(GL_VERTEX_SHADER, strings[0], counts[0], vertex),
        stage_shader(GL_FRAGMENT_SHADER, strings[1], counts[1], rule == TR_RULE_SEE_PLAIN ? plain : fragment)};
    for (int i = 0; i < 2; ++i) {
        glAttachShader(program, parts[i]);
        glDeleteShader(parts[i]);
    }
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    assert_true(ok);
    if (rule != TR_RULE_SEE_PLAIN)
        assert_int_equal(tr_prepare_program(h->tr, program), TR_OK);
    return program;
}

static inline void stage_upload(stage *s) {
    for (size_t i = 0; i < s->count; ++i) {
        stage_unit *u = &s->units[i];
        if (!u->array) {
            glGenVertexArrays(1, &u->array);
            glGenBuffers(2, u->buffers);
        }
        glBindVertexArray(u->array);
        glBindBuffer(GL_ARRAY_BUFFER, u->buffers[0]);
        glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(3 * u->points * sizeof(float)), u->positions, GL_STATIC_DRAW);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, u->buffers[1]);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(u->corners * sizeof(uint32_t)), u->indices, GL_STATIC_DRAW);
        glEnableVertexAttribArray(0);
        glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, NULL);
        glBindVertexArray(0);
    }
}

/* The way of a triangle's middle along the view. */
static inline double stage_distance(const stage *s, const stage_unit *u, const uint32_t *corners) {
    double depth = 0;
    for (int c = 0; c < 3; ++c)
        for (int k = 0; k < 3; ++k)
            depth -= s->scene.view[4 * k + 2] * (double)u->positions[3 * corners[c] + (uint32_t)k];
    return depth;
}

/* Triangles of hollow units back to front, as TR_PASS_PAINT wants them. */
static inline void stage_sort_hollow(stage *s) {
    for (size_t i = 0; i < s->count; ++i) {
        stage_unit *u = &s->units[i];
        if (!(s->marks[i].flags & REF_DYN_HOLLOW))
            continue;
        for (size_t a = 3; a < u->corners; a += 3)
            for (size_t b = a; b > 0 && stage_distance(s, u, u->indices + b) > stage_distance(s, u, u->indices + b - 3);
                 b -= 3)
                for (int k = 0; k < 3; ++k) {
                    uint32_t kept = u->indices[b + (size_t)k];
                    u->indices[b + (size_t)k] = u->indices[b + (size_t)k - 3];
                    u->indices[b + (size_t)k - 3] = kept;
                }
    }
}

static inline void stage_draw_unit(const stage *s, size_t i, GLuint program, bool reversed) {
    float matrix[16];
    const double *v = s->scene.view;
    double projection[16];
    memcpy(projection, s->scene.projection, sizeof projection);
    for (int c = 0; reversed && c < 4; ++c)
        projection[4 * c + 2] = -projection[4 * c + 2];
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) {
            double sum = 0;
            for (int k = 0; k < 4; ++k)
                sum += projection[4 * k + r] * v[4 * c + k];
            matrix[4 * c + r] = (float)sum;
        }
    glUniformMatrix4fv(glGetUniformLocation(program, "u_matrix"), 1, GL_FALSE, matrix);
    glUniform4f(glGetUniformLocation(program, "u_color"), (float)s->meshes[i].color[0], (float)s->meshes[i].color[1],
                (float)s->meshes[i].color[2], 1);
    glUniform1ui(glGetUniformLocation(program, "u_code"), tr_unit_code(&s->units[i].unit));
    glBindVertexArray(s->units[i].array);
    glDrawElements(GL_TRIANGLES, (GLsizei)s->units[i].corners, GL_UNSIGNED_INT, NULL);
    glBindVertexArray(0);
}

static inline void stage_clear(harness *h, const stage *s, bool reversed) {
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glViewport(s->frame.x, s->frame.y, s->frame.width, s->frame.height);
    glClearColor((float)s->scene.background[0], (float)s->scene.background[1], (float)s->scene.background[2], 1);
    if (h->context.es)
        glClearDepthf(reversed ? 0 : 1);
    else
        glClearDepth(reversed ? 0 : 1);
    if (!h->context.es && s->srgb)
        glEnable(GL_FRAMEBUFFER_SRGB);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(reversed ? GL_GREATER : GL_LESS);
    glEnable(GL_CULL_FACE);
}

static inline tr_result stage_draw(harness *h, stage *s, bool reversed) {
    tr_pass pass;
    stage_tell(s);
    for (int k = 0; k < 4; ++k) /* clip z the other way round is window depth the other way round */
        s->wish.projection[4 * k + 2] *= reversed ? -1.0f : 1.0f;
    stage_sort_hollow(s);
    stage_upload(s);
    stage_clear(h, s, reversed);
    s->frame.framebuffer = h->framebuffer;
    s->frame.wishes.options = s->srgb ? (uint32_t)TR_WISH_SRGB : 0;
    memset(s->passes, 0, sizeof s->passes);
    memset(s->draws, 0, sizeof s->draws);
    tr_result result = tr_begin_dynamic(h->tr, &s->frame, &s->wish);
    if (result != TR_OK)
        return result;
    while (tr_next_pass(h->tr, &pass)) {
        if (!s->programs[pass.rule])
            s->programs[pass.rule] = stage_program(h, pass.rule);
        glUseProgram(s->programs[pass.rule]);
        ++s->passes[pass.kind];
        for (size_t i = 0; i < pass.unit_count; ++i) {
            stage_draw_unit(s, pass.units[i], s->programs[pass.rule], reversed);
            ++s->draws[pass.kind];
        }
    }
    return tr_end(h->tr);
}

/* What a pixel of a colour holds, in 255ths; and back. */
static inline double stage_encode(const stage *s, double light) {
    double encoded = light > 0.0031308 ? 1.055 * pow(light, 1 / 2.4) - 0.055 : 12.92 * light;
    return 255 * (s->srgb ? encoded : light);
}

static inline double stage_decode(const stage *s, double held) {
    double encoded = held / 255, light = encoded > 0.04045 ? pow((encoded + 0.055) / 1.055, 2.4) : encoded / 12.92;
    return s->srgb ? light : encoded;
}

static inline void stage_read(harness *h, stage *s) {
    free(s->picture);
    s->picture = malloc(4 * (size_t)s->scene.width * (size_t)s->scene.height);
    assert_non_null(s->picture);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(s->frame.x, s->frame.y, s->scene.width, s->scene.height, GL_RGBA, GL_UNSIGNED_BYTE, s->picture);
}

/* The mean of so many frames, of dithering. */
static inline tr_result stage_draw_mean(harness *h, stage *s, bool reversed, int frames) {
    size_t values = 4 * (size_t)s->scene.width * (size_t)s->scene.height;
    double *sum = calloc(values, sizeof *sum);
    tr_result result = TR_OK;
    assert_non_null(sum);
    for (int f = 0; f < frames && result == TR_OK; ++f) {
        s->wish.frame_index = (uint32_t)f;
        result = stage_draw(h, s, reversed);
        if (result == TR_OK)
            stage_read(h, s);
        for (size_t i = 0; i < values && result == TR_OK; ++i)
            sum[i] += stage_decode(s, s->picture[i]) / frames;
    }
    for (size_t i = 0; i < values && result == TR_OK; ++i)
        s->picture[i] = (unsigned char)(stage_encode(s, sum[i]) + 0.5);
    free(sum);
    return result;
}

static inline void stage_truth(stage *s) {
    size_t pixels = (size_t)s->scene.width * (size_t)s->scene.height;
    free(s->pixels);
    free(s->weights);
    s->pixels = calloc(pixels, sizeof *s->pixels);
    s->weights = calloc(pixels * s->count + 1, sizeof *s->weights);
    assert_true(s->pixels && s->weights && ref_dyn_render(&s->truth, s->pixels, s->weights, NULL));
}

/* New meshes, the same programs. */
static inline void stage_clean(stage *s) {
    for (size_t i = 0; i < s->count; ++i) {
        stage_unit *u = &s->units[i];
        free(u->positions);
        free(u->indices);
        if (u->array) {
            glDeleteVertexArrays(1, &u->array);
            glDeleteBuffers(2, u->buffers);
        }
        memset(u, 0, sizeof *u);
    }
    s->count = s->scene.object_count = 0;
    memset(s->marks, 0, sizeof s->marks);
}

static inline void stage_free(stage *s) {
    stage_clean(s);
    for (int i = 0; i < TR_RULE_SEE_END; ++i)
        if (s->programs[i])
            glDeleteProgram(s->programs[i]);
    free(s->pixels);
    free(s->weights);
    free(s->picture);
    free(s);
}

/* ---- comparison ---- */

typedef struct stage_error {
    double largest, mean, left_out; /* in 255ths; a share of the pixels */
    size_t worst, see_through, over;
} stage_error;

/* over: pixels off by more than `allowed`. */
static inline stage_error stage_compare(const stage *s, double allowed) {
    stage_error e = {0, 0, 0, 0, 0, 0};
    size_t count = (size_t)s->scene.width * (size_t)s->scene.height, compared = 0;
    for (size_t i = 0; i < count; ++i) {
        double most = 0;
        e.left_out += s->pixels[i].left_out;
        if (s->pixels[i].left_out)
            continue;
        for (size_t c = 0; c < 3; ++c)
            most = fmax(most, fabs(stage_encode(s, s->pixels[i].color[c]) - s->picture[4 * i + c]));
        ++compared;
        e.mean += most;
        e.over += most > allowed;
        e.see_through += s->pixels[i].see_through > 0;
        if (most > e.largest) {
            e.largest = most;
            e.worst = i;
        }
    }
    e.mean /= compared ? (double)compared : 1;
    e.left_out /= count ? (double)count : 1;
    return e;
}

#endif

/* gl_host_depth.c: opaque things from the host's textures: the same pictures as by drawing them again, in all modes and on
 * all contexts; what coarser depth formats mean, worked out for single texels; and textures that cannot be meant. */
#include "gl_scenes.h"

enum { SIZE = 96, BYTES = SIZE * SIZE * 4, MARGIN = 24 };
static unsigned char again[BYTES], taken[BYTES], without[BYTES];

/* ---- a host that has drawn its opaque things ---- */

typedef struct host {
    GLuint program, framebuffer, color, depth;
    int width, height;
} host;

static GLuint compile(GLenum stage, bool es, const char *text) {
    const char *strings[2] = {es ? "#version 300 es\nprecision highp float;\n" : "#version 330 core\n", text};
    GLuint shader = glCreateShader(stage);
    GLint ok = 0;
    glShaderSource(shader, 2, strings, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    assert_true(ok);
    return shader;
}

static GLuint make_program(bool es) {
    GLuint program = glCreateProgram();
    GLuint stages[2] = {
        compile(GL_VERTEX_SHADER, es,
                "layout(location = 0) in vec3 position;\nuniform mat4 to_clip;\n"
                "void main() { gl_Position = to_clip * vec4(position, 1.0); }\n"),
        compile(GL_FRAGMENT_SHADER, es, "uniform vec4 color;\nout vec4 result;\nvoid main() { result = color; }\n")};
    for (int i = 0; i < 2; ++i) {
        glAttachShader(program, stages[i]);
        glDeleteShader(stages[i]);
    }
    glLinkProgram(program);
    return program;
}

static GLuint make_texture(GLenum internal, int width, int height, GLenum format, GLenum type, const void *texels) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)internal, width, height, 0, format, type, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    return name;
}

static void open_host(host *o, bool es, GLenum depth_format, int width, int height) {
    bool floats = depth_format == GL_DEPTH_COMPONENT32F;
    o->program = make_program(es);
    o->width = width;
    o->height = height;
    o->color = make_texture(GL_RGBA8, width, height, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    o->depth = make_texture(depth_format, width, height, GL_DEPTH_COMPONENT, floats ? GL_FLOAT : GL_UNSIGNED_INT, NULL);
    glGenFramebuffers(1, &o->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, o->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, o->color, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, o->depth, 0);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
}

static void close_host(host *o) {
    glDeleteFramebuffers(1, &o->framebuffer);
    glDeleteTextures(1, &o->color);
    glDeleteTextures(1, &o->depth);
    glDeleteProgram(o->program);
}

/* Plain z-buffering of the opaque objects, with a colour for what is nothing that must not be seen. */
static void draw_host(const host *o, const test_scene *s, bool reversed, int x, int y) {
    static const float garbage[4] = {1, 0, 1, 1};
    const float far_depth = reversed ? 0.0f : 1.0f;
    glBindFramebuffer(GL_FRAMEBUFFER, o->framebuffer);
    glViewport(x, y, s->scene.width, s->scene.height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(reversed ? GL_GREATER : GL_LESS);
    glClearBufferfv(GL_COLOR, 0, garbage);
    glClearBufferfv(GL_DEPTH, 0, &far_depth);
    glUseProgram(o->program);
    for (size_t i = 0; i < s->count; ++i) {
        tr_material material;
        if (s->truths[i].transparent)
            continue;
        harness_material(&s->scene, &s->truths[i], &material);
        glUniformMatrix4fv(glGetUniformLocation(o->program, "to_clip"), 1, GL_FALSE, material.model_view_projection);
        glUniform4fv(glGetUniformLocation(o->program, "color"), 1, material.color);
        (s->truths[i].two_sided ? glDisable : glEnable)(GL_CULL_FACE);
        glFrontFace(s->objects[i].mirrored ? GL_CW : GL_CCW);
        glBindVertexArray(s->objects[i].array);
        glDrawElements(GL_TRIANGLES, (GLsizei)(3 * s->truths[i].triangle_count), GL_UNSIGNED_INT, NULL);
    }
    glBindVertexArray(0);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glFrontFace(GL_CCW);
    glUseProgram(0);
}

/* ---- frames ---- */

/* A band across the middle, in the depth of the scene's, as the lines of all objects. */
static void draw_band(int width, int height, bool reversed) {
    float v[4][6], middle = (float)height / 2;
    GLuint array, buffer;
    for (int i = 0; i < 4; ++i) {
        const float corner[6] = {i & 1 ? (float)width : 0, middle + (i & 2 ? 3.0f : -3.0f),
                                 reversed ? 0.17f : 0.83f, 1e-4f,
                                 i & 1 ? (float)width : 0, middle};
        memcpy(v[i], corner, sizeof corner);
    }
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof v, v, GL_STREAM_DRAW);
    for (GLuint k = 0; k < 2; ++k) {
        glEnableVertexAttribArray(k);
        glVertexAttribPointer(k, k ? 2 : 4, GL_FLOAT, GL_FALSE, sizeof v[0], (const void *)(uintptr_t)(16 * k));
    }
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &array);
    glDeleteBuffers(1, &buffer);
}

static void draw_objects(harness *h, const test_scene *s, const tr_frame *frame, const tr_pass *pass) {
    for (size_t i = 0; i < s->count; ++i) {
        const harness_object *o = &s->objects[i];
        tr_material material;
        if (!tr_pass_draws(pass, &o->object))
            continue;
        harness_material(&s->scene, &o->truth, &material);
        material.object = tr_object_code(&o->object, &frame->wishes);
        tr_set_material(h->tr, pass, &material);
        glFrontFace(o->mirrored ? GL_CW : GL_CCW);
        glBindVertexArray(o->array);
        glDrawElements(GL_TRIANGLES, (GLsizei)(3 * o->truth.triangle_count), GL_UNSIGNED_INT, NULL);
    }
    glBindVertexArray(0);
}

static int count_passes(const harness *h, tr_pass_kind kind) {
    const tr_plan *plan = tr_get_info(h->tr).plan;
    int count = 0;
    for (int i = 0; i < plan->pass_count; ++i)
        count += plan->passes[i].kind == kind;
    return count;
}

static void draw(harness *h, const test_scene *s, const tr_frame *frame, unsigned char *pixels) {
    bool reversed = h->tr->desc.reversed_z;
    tr_pass pass;
    harness_clear(h, s->scene.background, reversed ? 0.0f : 1.0f);
    assert_int_equal(tr_begin(h->tr, frame), TR_OK);
    while (tr_next_pass(h->tr, &pass))
        if (pass.lines)
            draw_band(frame->width, frame->height, reversed);
        else
            draw_objects(h, s, frame, &pass);
    assert_int_equal(tr_end(h->tr), TR_OK);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(frame->x, frame->y, s->scene.width, s->scene.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

static size_t differing(const unsigned char *a, const unsigned char *b, int most) {
    size_t count = 0;
    for (size_t i = 0; i < SIZE * SIZE; ++i) {
        bool differs = false;
        for (size_t k = 0; k < 4; ++k)
            differs = differs || abs(a[4 * i + k] - b[4 * i + k]) > most;
        count += differs;
    }
    return count;
}

/* Opaque objects whose place in the array is a multiple of `step` are drawn again all the same; 0: none. */
static void mark_drawn(test_scene *s, bool drawn, size_t step) {
    for (size_t i = 0; i < s->count; ++i)
        if (!s->truths[i].transparent && (!drawn || !step || i % step))
            s->objects[i].object.flags =
                (s->objects[i].object.flags & ~(uint32_t)TR_DRAWN) | (drawn ? (uint32_t)TR_DRAWN : 0u);
}

typedef struct mode {
    const char *name;
    ref_interior interior;
    int layers, group, supersample;
    uint32_t lines;
} mode;

static const mode modes[] = {
    {"implicit", REF_INTERIOR_IMPLICIT, 0, 0, 0, 0},         {"published", REF_INTERIOR_IMPLICIT_PUBLISHED, 0, 0, 0, 0},
    {"explicit", REF_INTERIOR_EXPLICIT, 0, 0, 0, 0},         {"layers 2", REF_INTERIOR_LAYERS, 2, 0, 0, 0},
    {"groups", REF_INTERIOR_IMPLICIT, 0, 3, 0, 0},           {"groups, explicit", REF_INTERIOR_EXPLICIT, 0, 3, 0, 0},
    {"implicit, lines", REF_INTERIOR_IMPLICIT, 0, 0, 0, 15},
};
enum { MODES = sizeof modes / sizeof modes[0] };

typedef struct setting {
    const char *name;
    int version;
    bool es, reversed;
    int x, y;   /* the viewport in the target, and in the textures */
    bool whole; /* textures as large as the target */
    GLenum depth;
    size_t most; /* pixels that may differ */
} setting;

/* The picture drawn both ways; returns in how many pixels an opaque thing shows. */
static size_t compare(harness *h, const host *o, const setting *at, const named_scene *named, const mode *m) {
    test_scene s;
    init_scene(&s, SIZE);
    named->make(&s);
    for (size_t i = 0; i < s.count; ++i)
        s.truths[i].group = s.truths[i].transparent ? (uint32_t)m->group : 0;
    for (int c = 0; c < 4 && at->reversed; ++c)
        s.scene.projection[4 * c + 2] *= -1;
    s.scene.interior = m->interior;
    s.scene.layers = m->layers;
    finish_scene(&s);
    draw_host(o, &s, at->reversed, at->whole ? at->x : 0, at->whole ? at->y : 0);
    tr_frame frame = harness_frame(h, &s.scene, s.objects, s.count);
    frame.x = at->x;
    frame.y = at->y;
    frame.wishes.lines = m->lines;
    draw(h, &s, &frame, again);
    assert_int_equal(count_passes(h, TR_PASS_TAKE_OPAQUE), 0);
    mark_drawn(&s, true, 0);
    frame.scene = tr_scene_count(s.objects, s.count, sizeof s.objects[0]);
    frame.opaque_color = o->color;
    frame.opaque_depth = o->depth;
    frame.opaque_x = at->whole ? at->x : 0;
    frame.opaque_y = at->whole ? at->y : 0;
    draw(h, &s, &frame, taken);
    bool any = frame.scene.opaque_drawn > 0;
    assert_int_equal(count_passes(h, TR_PASS_TAKE_OPAQUE), 1);
    assert_int_equal(count_passes(h, TR_PASS_OPAQUE), 0);
    assert_int_equal(count_passes(h, TR_PASS_OPAQUE_LINES), m->lines ? 2 : 0);
    size_t wrong = differing(again, taken, 1);
    if (any || !m->lines) { /* a host that gives textures has opaque objects' lines, which may be drawn */
        if (wrong > at->most)
            fail_msg("%s, %s, %s: %zu pixels differ", at->name, named->name, m->name, wrong);
    }
    frame.opaque_color = frame.opaque_depth = 0;
    frame.scene.opaque_drawn = 0;
    draw(h, &s, &frame, without);
    drop_scene(&s);
    return differing(without, taken, 1);
}

static void check_setting(const setting *at) {
    harness h;
    host o;
    size_t seen = 0;
    tr_desc desc = {0};
    desc.reversed_z = at->reversed;
    harness_open(&h, at->version, at->es, &desc);
    harness_target(&h, SIZE + 2 * MARGIN, SIZE + 2 * MARGIN);
    open_host(&o, at->es, at->depth, at->whole ? SIZE + 2 * MARGIN : SIZE, at->whole ? SIZE + 2 * MARGIN : SIZE);
    for (size_t i = 0; i < NAMED_SCENES; ++i)
        for (size_t k = 0; k < MODES; ++k)
            seen += compare(&h, &o, at, &named_scenes[i], &modes[k]);
    printf("    %-20s opaque things in %zu pixels of %d pictures\n", at->name, seen, (int)NAMED_SCENES * MODES);
    assert_true(seen > 1000 * MODES);
    assert_int_equal(h.logged, 0);
    close_host(&o);
    harness_close(&h);
}

static void test_pictures_are_as_if_drawn_again(void **state) {
    static const setting settings[] = {
        {"GL 4.5", 450, false, false, 0, 0, false, GL_DEPTH_COMPONENT32F, 0},
        {"GL 3.3", 330, false, false, 0, 0, false, GL_DEPTH_COMPONENT32F, 0},
        {"ES 3.0", 300, true, false, 0, 0, false, GL_DEPTH_COMPONENT32F, 0},
        {"reversed", 450, false, true, 0, 0, false, GL_DEPTH_COMPONENT32F, 0},
        {"offset target", 450, false, false, MARGIN, MARGIN / 2, false, GL_DEPTH_COMPONENT32F, 0},
        {"offset textures", 330, false, true, MARGIN, MARGIN / 2, true, GL_DEPTH_COMPONENT32F, 0},
        /* Half a step is 3e-8 of the depth range: the share of a surface's pixels that are as near to the limit is about
           that over its depth, none in these scenes. */
        {"24 bits", 450, false, false, 0, 0, false, GL_DEPTH_COMPONENT24, 0},
        /* 8e-6 of it: of all pixels at most one in a thousand is as near to a crossing with the limit. */
        {"16 bits", 450, false, false, 0, 0, false, GL_DEPTH_COMPONENT16, SIZE * SIZE / 1000},
    };
    (void)state;
    for (size_t i = 0; i < sizeof settings / sizeof settings[0]; ++i)
        check_setting(&settings[i]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pictures_are_as_if_drawn_again),
    };
    return cmocka_run_group_tests_name("gl_host_depth", tests, NULL, NULL);
}

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

/* Plain z-buffering of the objects that are TR_DRAWN, with a colour for what is nothing that must not be seen. */
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
        if (!(s->objects[i].object.flags & TR_DRAWN))
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

/* All opaque objects, or, with `every` 2, those at odd places of the array. */
static void mark_drawn(test_scene *s, size_t every) {
    for (size_t i = 0; i < s->count; ++i)
        if (!s->truths[i].transparent && i % every == every - 1)
            s->objects[i].object.flags |= TR_DRAWN;
}

typedef struct mode {
    const char *name;
    ref_interior interior;
    int layers, group;
    size_t every; /* opaque object that is in the textures; the others are drawn again */
    uint32_t lines;
} mode;

static const mode modes[] = {
    {"implicit", REF_INTERIOR_IMPLICIT, 0, 0, 1, 0},         {"published", REF_INTERIOR_IMPLICIT_PUBLISHED, 0, 0, 1, 0},
    {"explicit", REF_INTERIOR_EXPLICIT, 0, 0, 1, 0},         {"layers 2", REF_INTERIOR_LAYERS, 2, 0, 1, 0},
    {"groups", REF_INTERIOR_IMPLICIT, 0, 3, 1, 0},           {"groups, explicit", REF_INTERIOR_EXPLICIT, 0, 3, 1, 0},
    {"implicit, lines", REF_INTERIOR_IMPLICIT, 0, 0, 1, 15}, {"some drawn again", REF_INTERIOR_IMPLICIT, 0, 0, 2, 0},
    {"some, explicit", REF_INTERIOR_EXPLICIT, 0, 0, 2, 0},
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
    tr_frame frame = harness_frame(h, &s.scene, s.objects, s.count);
    frame.x = at->x;
    frame.y = at->y;
    frame.wishes.lines = m->lines;
    draw(h, &s, &frame, again);
    assert_int_equal(count_passes(h, TR_PASS_TAKE_OPAQUE), 0);
    int opaque_passes = count_passes(h, TR_PASS_OPAQUE);
    mark_drawn(&s, m->every);
    draw_host(o, &s, at->reversed, at->whole ? at->x : 0, at->whole ? at->y : 0);
    frame.scene = tr_scene_count(s.objects, s.count, sizeof s.objects[0]);
    frame.opaque_color = o->color;
    frame.opaque_depth = o->depth;
    frame.opaque_x = at->whole ? at->x : 0;
    frame.opaque_y = at->whole ? at->y : 0;
    draw(h, &s, &frame, taken);
    assert_int_equal(count_passes(h, TR_PASS_TAKE_OPAQUE), 1);
    if (m->every == 1)
        assert_int_equal(count_passes(h, TR_PASS_OPAQUE), 0);
    assert_int_equal(count_passes(h, TR_PASS_OPAQUE_LINES), m->lines ? 2 : 0);
    size_t wrong = differing(again, taken, 1);
    /* Without an opaque object the first picture has no lines of any; the textures are empty, but may have lines. */
    if (wrong > at->most && (opaque_passes || !m->lines))
        fail_msg("%s, %s, %s: %zu pixels differ", at->name, named->name, m->name, wrong);
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

/* ---- single texels, worked out by hand ---- */

/* A glass box over the whole picture, its front at window depth 0.25, its back, the limit, at 0.75. */
static void make_box(test_scene *s, bool reversed) {
    static const float corners[24] = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1,
                                      -1, -1, 1,  1, -1, 1,  -1, 1, 1,  1, 1, 1};
    static const uint32_t outward[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                         2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    init_scene(s, SIZE);
    ref_object *box = add_object(s, true, 0.2, 0.4, 0.8, 0.5);
    box->positions = corners;
    box->indices = outward;
    box->vertex_count = 8;
    box->triangle_count = 12;
    box->model[0] = box->model[5] = 1.5;
    box->model[10] = 0.5;
    memcpy(s->scene.view, identity, sizeof identity);
    memcpy(s->scene.projection, identity, sizeof identity);
    s->scene.projection[10] = reversed ? 1 : -1;
    s->scene.blending = REF_BLEND_OVER;
    finish_scene(s);
}

typedef struct texel {
    double depth, steps; /* steps of the format beyond that */
    int shown;           /* 0: glass over the white background; 1: glass over the green thing; 2: the green thing */
    bool floats;         /* of R32F textures alone */
} texel;

static const texel texels[] = {{1, 0, 0, false},     {0.1, 0, 2, false},       {0.5, 0, 1, false},
                               {0.75, -2, 1, false}, {0.75, 2, 0, false},      {0.25, -2, 2, false},
                               {0.25, 2, 1, false},  {0.9, 0, 0, false},       {0, 0, 2, false},
                               {1.5, 0, 0, true},    {(double)NAN, 0, 0, true}};
enum { TEXELS = sizeof texels / sizeof texels[0] };

static GLuint probe_depths(GLenum format, double step, bool reversed, int width) {
    bool floats = format == GL_R32F || format == GL_DEPTH_COMPONENT32F;
    float *depths = malloc(sizeof(float) * (size_t)width * SIZE);
    uint32_t *whole = malloc(sizeof(uint32_t) * (size_t)width * SIZE);
    for (int i = 0; i < width * SIZE; ++i) {
        const texel *p = &texels[i % width % TEXELS];
        double depth = p->floats && format != GL_R32F ? 1 : p->depth + p->steps * step;
        depth = reversed ? 1 - depth : depth;
        depths[i] = (float)depth;
        whole[i] = depth >= 0 && depth <= 1 ? (uint32_t)(depth * 4294967295.0 + 0.5) : 0;
    }
    GLuint name = make_texture(format, width, SIZE, format == GL_R32F ? GL_RED : GL_DEPTH_COMPONENT,
                               floats ? GL_FLOAT : GL_UNSIGNED_INT, floats ? (void *)depths : (void *)whole);
    free(depths);
    free(whole);
    return name;
}

/* Textures `width` texels wide; what lies beyond them is background. */
static void check_texels(int version, bool es, bool reversed, GLenum format, double step, int width) {
    static const double shown[3][3] = {{0.6, 0.7, 0.9}, {0.1, 0.6, 0.4}, {0, 0.8, 0}};
    static unsigned char green[SIZE * SIZE * 4];
    harness h;
    test_scene s;
    tr_desc desc = {0};
    desc.reversed_z = reversed;
    harness_open(&h, version, es, &desc);
    harness_target(&h, SIZE, SIZE);
    make_box(&s, reversed);
    for (int i = 0; i < SIZE * SIZE; ++i)
        green[4 * i + 1] = 204;
    tr_frame frame = harness_frame(&h, &s.scene, s.objects, s.count);
    frame.opaque_color = make_texture(GL_RGBA8, width, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, green);
    frame.opaque_depth = probe_depths(format, step, reversed, width);
    draw(&h, &s, &frame, taken);
    for (int i = 0; i < SIZE * SIZE; ++i)
        for (int c = 0; c < 3; ++c) {
            int x = i % SIZE, at = x % width % (int)TEXELS;
            const double *expected = shown[x < width ? texels[at].shown : 0];
            if (fabs(taken[4 * i + c] - expected[c] * 255) > 2)
                fail_msg("format %x, texel %d, channel %d: %d, should be %.1f", (unsigned)format, x, c,
                         taken[4 * i + c], expected[c] * 255);
        }
    glDeleteTextures(1, &frame.opaque_color);
    glDeleteTextures(1, &frame.opaque_depth);
    s.owned[0] = NULL;
    drop_scene(&s);
    harness_close(&h);
}

/* Each format decides within two of its own steps. */
static void test_single_texels(void **state) {
    static const struct {
        GLenum format;
        double step;
    } formats[] = {{GL_DEPTH_COMPONENT32F, 1.0 / (1 << 22)},
                   {GL_R32F, 1.0 / (1 << 22)},
                   {GL_DEPTH_COMPONENT24, 1.0 / 16777215},
                   {GL_DEPTH_COMPONENT16, 1.0 / 65535}};
    (void)state;
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; ++i)
        for (int reversed = 0; reversed < 2; ++reversed) {
            check_texels(450, false, reversed, formats[i].format, formats[i].step, SIZE);
            check_texels(300, true, reversed, formats[i].format, formats[i].step, SIZE);
        }
    /* ES cannot be asked how large a texture is: nothing is outside of one. */
    check_texels(300, true, false, GL_DEPTH_COMPONENT32F, 1.0 / (1 << 22), SIZE / 2);
}

/* ---- other targets ---- */

/* Four texels of ours have the host's one: what it drew is not touched by the average. */
static void test_texels_are_repeated_in_larger_textures(void **state) {
    harness h;
    host o;
    test_scene s;
    size_t seen = 0;
    (void)state;
    harness_open(&h, 330, false, NULL);
    harness_target(&h, SIZE, SIZE);
    open_host(&o, false, GL_DEPTH_COMPONENT32F, SIZE, SIZE);
    init_scene(&s, SIZE);
    shells(&s);
    s.truths[0].transparent = s.truths[1].transparent = false;
    finish_scene(&s);
    mark_drawn(&s, 1);
    draw_host(&o, &s, false, 0, 0);
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, again);
    tr_frame frame = harness_frame(&h, &s.scene, s.objects, s.count);
    frame.opaque_color = o.color;
    frame.opaque_depth = o.depth;
    frame.wishes.supersample = 2;
    draw(&h, &s, &frame, taken);
    for (size_t i = 0; i < SIZE * SIZE; ++i) {
        bool nothing = again[4 * i] == 255 && again[4 * i + 1] == 0; /* draw_host's colour for that */
        for (size_t c = 0; c < 3; ++c)
            assert_int_equal(taken[4 * i + c], nothing ? 255 : again[4 * i + c]);
        seen += !nothing;
    }
    assert_true(seen > 1000 && seen < SIZE * SIZE);
    close_host(&o);
    drop_scene(&s);
    harness_close(&h);
}

/* Light in, light out: a texture in the sRGB format of what was drawn gives the picture of drawing it. */
static void check_light(int version, bool es) {
    harness h;
    host o;
    test_scene s;
    harness_open(&h, version, es, NULL);
    harness_target(&h, SIZE, SIZE);
    glBindTexture(GL_TEXTURE_2D, h.color);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, SIZE, SIZE, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    open_host(&o, es, GL_DEPTH_COMPONENT32F, SIZE, SIZE);
    init_scene(&s, SIZE);
    shells(&s);
    s.scene.srgb = true;
    finish_scene(&s);
    tr_frame frame = harness_frame(&h, &s.scene, s.objects, s.count);
    draw(&h, &s, &frame, again);
    mark_drawn(&s, 1);
    draw_host(&o, &s, false, 0, 0);
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, without);
    frame.scene = tr_scene_count(s.objects, s.count, sizeof s.objects[0]);
    frame.opaque_color = make_texture(GL_SRGB8_ALPHA8, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, without);
    frame.opaque_depth = o.depth;
    draw(&h, &s, &frame, taken);
    assert_int_equal(differing(again, taken, 1), 0);
    glDeleteTextures(1, &frame.opaque_color);
    close_host(&o);
    drop_scene(&s);
    harness_close(&h);
}

static void test_srgb_textures_hold_light(void **state) {
    (void)state;
    check_light(450, false);
    check_light(300, true);
}

/* ---- what cannot be meant ---- */

static void refuse(harness *h, const tr_frame *frame) {
    int logged = h->logged;
    h->quiet = true;
    assert_int_equal(tr_begin(h->tr, frame), TR_INVALID_ARGUMENT);
    assert_int_equal(h->logged, logged + 1);
    assert_int_equal(tr_end(h->tr), TR_WRONG_ORDER);
    while (glGetError() != GL_NO_ERROR) /* of a texture of another kind */
        ;
    h->quiet = false;
}

static void test_wrong_textures_are_refused(void **state) {
    harness h;
    host o;
    test_scene s;
    GLuint array = 0;
    (void)state;
    harness_open(&h, 450, false, NULL);
    harness_target(&h, SIZE, SIZE);
    open_host(&o, false, GL_DEPTH_COMPONENT32F, SIZE + 1, SIZE + 1);
    init_scene(&s, SIZE);
    shells(&s);
    finish_scene(&s);
    mark_drawn(&s, 1);
    draw_host(&o, &s, false, 0, 0);
    glGenTextures(1, &array);
    glBindTexture(GL_TEXTURE_2D_ARRAY, array);
    tr_frame good = harness_frame(&h, &s.scene, s.objects, s.count);
    good.opaque_color = o.color;
    good.opaque_depth = o.depth;
    draw(&h, &s, &good, again);
    for (int i = 0; i < 8; ++i) {
        tr_frame bad = good;
        GLuint small = make_texture(GL_RGBA8, SIZE - (i == 0), SIZE - (i == 1), GL_RGBA, GL_UNSIGNED_BYTE, NULL);
        bad.opaque_color = i < 2 ? small : i == 2 ? 999999 : i == 3 ? array : i == 4 ? 0 : o.color;
        bad.opaque_depth = i == 5 ? array : o.depth;
        bad.opaque_x = i == 6 ? 2 : 0;
        bad.opaque_y = i == 7 ? -1 : 0;
        refuse(&h, &bad);
        glDeleteTextures(1, &small);
        draw(&h, &s, &good, taken); /* nothing is left changed */
        assert_memory_equal(again, taken, BYTES);
    }
    good.opaque_color = good.opaque_depth = 0; /* objects that are nowhere */
    refuse(&h, &good);
    glDeleteTextures(1, &array);
    close_host(&o);
    drop_scene(&s);
    harness_close(&h);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pictures_are_as_if_drawn_again),
        cmocka_unit_test(test_single_texels),
        cmocka_unit_test(test_texels_are_repeated_in_larger_textures),
        cmocka_unit_test(test_srgb_textures_hold_light),
        cmocka_unit_test(test_wrong_textures_are_refused),
    };
    return cmocka_run_group_tests_name("gl_host_depth", tests, NULL, NULL);
}

/* gl_oit_pick.c: fragments picked through layers, and the depth of the composite, held to all hits of a ray through the
 * pixel in double. */
#include "oit_setting.h"

static oit_truth_layer layers[4096];

static void open_world(ref_i_world *world, const oit_scene *s) {
    memset(world, 0, sizeof *world);
    world->scene = &s->scene;
    assert_true(ref_i_is_valid(&s->scene) && ref_i_make_world(world));
}

static double window_depth(const oit_scene *s, double depth) {
    return s->reversed ? 1 - depth : depth;
}

/* Balls that intersect, one of them opaque, and sheets behind and before them. */
static void make_scene(oit_scene *s, int size) {
    oit_scene_init(s, size, size);
    oit_scene_random_balls(s, 6, 16, 0.4);
    for (size_t i = 0; i < s->count; ++i)
        s->truths[i].alpha = 0.1 + 0.12 * (double)i;
    s->truths[2].transparent = false;
}

/* ---- picking ---- */

static oit_pick pick_one(oit_setting *t, oit_scene *s, const oit_frame *frame, int x, int y, int layer) {
    oit_pick pick;
    memset(&pick, 0xff, sizeof pick);
    oit_setting_clear(t, s);
    oit_scene_expect(oit_pick_begin(t->oit, x, y, layer), "oit_pick_begin");
    assert_int_equal(oit_pick_result(t->oit, 0, &pick), OIT_NOT_READY);
    oit_scene_render(s, t->oit, frame, NULL);
    oit_scene_expect(oit_pick_result(t->oit, 1, &pick), "oit_pick_result");
    assert_int_equal(pick.x, x);
    assert_int_equal(pick.y, y);
    assert_int_equal(pick.layer, layer);
    return pick;
}

static void check_pick(const oit_scene *s, const oit_pick *pick, const oit_truth_layer *truth, size_t count,
                       double color_tolerance) {
    assert_int_equal(pick->layers, count);
    assert_int_equal(pick->found, (size_t)pick->layer < count);
    if (!pick->found) {
        static const oit_pick nothing;
        assert_memory_equal(pick->color, nothing.color, sizeof pick->color);
        assert_int_equal(pick->part, 0);
        return;
    }
    assert_int_equal(pick->part, truth[pick->layer].part);
    assert_true(fabs((double)pick->depth - window_depth(s, truth[pick->layer].depth)) < 2e-6);
    for (int c = 0; c < 4; ++c)
        assert_true(fabs((double)pick->color[c] - truth[pick->layer].color[c]) < color_tolerance);
}

/* Every layer of some pixels, and one more than there are. */
static void check_picks(bool es, oit_desc desc, bool reversed, int expected_bands, double color_tolerance) {
    enum { SIZE = 48 };
    oit_scene *s = malloc(sizeof *s);
    oit_truth *truth = malloc(SIZE * SIZE * sizeof *truth);
    oit_setting t;
    ref_i_world world;
    oit_report report = {0};
    int picks = 0;
    desc.fields |= OIT_FIELD_PART;
    desc.reversed_z = reversed;
    oit_setting_open(&t, es, SIZE, SIZE, 0, GL_RGBA8, desc);
    if (reversed)
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    make_scene(s, SIZE);
    s->reversed = reversed;
    oit_truth_render(s, truth);
    open_world(&world, s);
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    oit_setting_clear(&t, s);
    oit_scene_render(s, t.oit, &frame, NULL); /* OIT_FIT_ASYNC learns what it needs */
    glFinish();
    for (int i = 3; i < SIZE * SIZE; i += 211) {
        size_t count;
        if (truth[i].left_out)
            continue;
        oit_truth_cast(&world, s, i % SIZE + 0.5, i / SIZE + 0.5, layers, &count);
        for (int layer = 0; layer <= (int)count; ++layer) {
            oit_pick pick = pick_one(&t, s, &frame, i % SIZE, i / SIZE, layer);
            check_pick(s, &pick, layers, count, color_tolerance);
            picks += pick.found;
        }
    }
    assert_int_equal(oit_get_report(t.oit, &report), OIT_OK);
    printf("    %d fragments picked, %u bands\n", picks, report.bands);
    assert_true(picks > 20);
    assert_true(expected_bands == 1 ? report.bands == 1 : (int)report.bands >= expected_bands);
    ref_i_free_world(&world);
    oit_scene_drop(s);
    if (reversed)
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    oit_setting_close(&t);
    free(truth);
    free(s);
}

static void test_picks_match_the_rays(void **state) {
    (void)state;
    oit_desc bytes = {0}, halves = {.color = OIT_COLOR_HALF, .fit = OIT_FIT_ASYNC}, floats = {.color = OIT_COLOR_FLOAT};
    check_picks(false, bytes, false, 1, 0.5 / 1023 + 1e-6);
    check_picks(true, halves, false, 1, 1.0 / 2048);
    check_picks(false, floats, true, 1, 1e-6);
}

static void test_picks_in_bands_and_slabs(void **state) {
    (void)state;
    oit_desc bands = {.ceiling_bytes = 24 * 700}, columns = {.ceiling_bytes = 24 * 20},
             slabs = {.max_block_bytes = 4000};
    check_picks(false, bands, false, 3, 0.5 / 1023 + 1e-6);
    check_picks(false, columns, false, 100, 0.5 / 1023 + 1e-6);
    check_picks(false, slabs, false, 5, 0.5 / 1023 + 1e-6);
}

static GLuint host_program(const oit_context *oit, oit_pass_kind kind) {
    static const char *const own[2] = {
        "layout(location = 0) in vec3 position;\nuniform mat4 matrix;\n"
        "void main() { gl_Position = matrix * vec4(position, 1.0); }\n",
        "uniform uint number;\nuniform vec3 normal;\n"
        "void main() {\n"
        "    oit_fragment f;\n    f.color = vec4(0.25, 0.5, 0.75, 0.125);\n    f.part = number;\n    f.key = number + 1u;\n"
        "    f.blend = 2u;\n    f.normal = normal;\n    f.uv = vec2(-2.5, 1.0e20);\n"
        "    for (int i = 0; i < 8; ++i)\n        f.words[i] = number * 100u + uint(i);\n    oit_store(f);\n}\n"};
    static const GLenum types[2] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
    GLuint program = glCreateProgram();
    GLint ok = 0;
    for (int stage = 0; stage < 2; ++stage) {
        const char *strings[32];
        char log[2048] = "";
        int count = 0;
        const char *const *ours = oit_glsl(oit, (oit_stage)stage, kind, &count);
        memcpy(strings, ours, (size_t)count * sizeof *strings);
        strings[count] = own[stage];
        GLuint shader = glCreateShader(types[stage]);
        glShaderSource(shader, count + 1, strings, NULL);
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

/* All that a host's shader can store comes back, in each way to keep a colour. */
static void test_all_fields_come_back(void **state) {
    static const float normals[][3] = {
        {0, 0.6f, -0.8f}, {0.8f, 0, 0.6f}, {-0.48f, -0.6f, -0.64f}, {0, 0, 0}, {0, 0, -1}};
    (void)state;
    for (int color = 0; color < 3; ++color) {
        oit_desc desc = {.color = (oit_color)color, .fields = OIT_FIELD_ALL, .host_words = 8};
        oit_scene *s = malloc(sizeof *s);
        oit_setting t;
        GLuint programs[2];
        const double depth[4] = {0, 0, 0, 0}, white[4] = {1, 1, 1, 1};
        oit_setting_open(&t, false, 4, 4, 0, GL_RGBA8, desc);
        oit_scene_init(s, 4, 4);
        oit_scene_quad(s, -1, -1, 1, 1, depth, white);
        programs[0] = host_program(t.oit, OIT_PASS_COUNT);
        programs[1] = host_program(t.oit, OIT_PASS_FILL);
        for (int k = 0; k < 5; ++k) {
            oit_frame frame = oit_scene_frame(s, t.framebuffer);
            oit_pass pass;
            oit_pick pick;
            float matrix[16];
            oit_setting_clear(&t, s);
            oit_scene_matrix(s, 0, matrix);
            oit_scene_expect(oit_begin(t.oit, &frame), "oit_begin");
            oit_scene_expect(oit_pick_begin(t.oit, 1, 2, 0), "oit_pick_begin"); /* within the frame */
            while (oit_next_pass(t.oit, &pass)) {
                GLuint program = programs[pass.kind == OIT_PASS_FILL];
                glUseProgram(program);
                glUniformMatrix4fv(glGetUniformLocation(program, "matrix"), 1, GL_FALSE, matrix);
                glUniform3fv(glGetUniformLocation(program, "normal"), 1, normals[k]);
                glUniform1ui(glGetUniformLocation(program, "number"), (GLuint)(7 + k));
                oit_scene_elements(s, 0);
            }
            oit_scene_expect(oit_compose(t.oit), "oit_compose");
            oit_scene_expect(oit_end(t.oit), "oit_end");
            oit_scene_expect(oit_pick_result(t.oit, 1, &pick), "oit_pick_result");
            assert_int_equal(pick.found, 1);
            assert_int_equal(pick.layers, 1);
            assert_int_equal(pick.part, 7 + k);
            assert_int_equal(pick.key, 8 + k);
            assert_int_equal(pick.blend, OIT_BLEND_MULTIPLY);
            assert_true(pick.depth == 0.5f);
            for (int c = 0; c < 4; ++c) /* powers of two: exact in halves and floats */
                assert_true(fabs((double)pick.color[c] - (c < 3 ? 0.25 * (c + 1) : 0.125)) <
                            (color ? 1e-9 : 0.5 / 1023));
            for (int c = 0; c < 3; ++c)
                assert_true(fabs((double)pick.normal[c] - (k == 3 ? c == 2 : (double)normals[k][c])) < 1e-4);
            assert_true(pick.uv[0] == -2.5f && pick.uv[1] == 1.0e20f);
            for (int i = 0; i < 8; ++i)
                assert_int_equal(pick.words[i], (7 + k) * 100 + i);
        }
        glDeleteProgram(programs[0]);
        glDeleteProgram(programs[1]);
        oit_scene_drop(s);
        oit_setting_close(&t);
        free(s);
    }
}

/* Several at once, in the order in which they were asked for; pixels outside of the viewport; a viewport that is not at the
 * origin; one too many; a frame that was ended early answers none of them. */
static void test_many_and_bad_picks(void **state) {
    (void)state;
    oit_desc desc = {.fields = OIT_FIELD_PART};
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    oit_pick pick;
    oit_setting_open(&t, false, 40, 40, 0, GL_RGBA8, desc);
    oit_scene_init(s, 16, 16);
    for (int i = 0; i < 2; ++i) { /* the second lies behind the first, on the right half alone */
        const double depth[4] = {0.2 * i, 0.2 * i, 0.2 * i, 0.2 * i}, color[4] = {1, 1, 1, 0.5};
        oit_scene_quad(s, i ? 0 : -1, -1, 1, 1, depth, color);
    }
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    frame.x = 10;
    frame.y = 20;
    t.quiet = true;
    assert_int_equal(oit_pick_result(t.oit, 1, &pick), OIT_WRONG_ORDER);
    assert_int_equal(oit_pick_begin(t.oit, 1, 1, -1), OIT_INVALID_ARGUMENT);
    assert_int_equal(oit_pick_begin(NULL, 1, 1, 0), OIT_INVALID_ARGUMENT);
    assert_int_equal(oit_pick_result(t.oit, 1, NULL), OIT_INVALID_ARGUMENT);
    oit_scene_expect(oit_pick_begin(t.oit, 10, 20, 0), "first");  /* the viewport's corner, the left half */
    oit_scene_expect(oit_pick_begin(t.oit, 25, 35, 1), "second"); /* the corner opposite */
    oit_scene_expect(oit_pick_begin(t.oit, 9, 20, 0), "third");   /* outside by one */
    oit_scene_expect(oit_pick_begin(t.oit, 26, 20, 0), "fourth");
    assert_int_equal(oit_pick_begin(t.oit, 11, 21, 0), OIT_WRONG_ORDER);
    assert_int_equal(oit_pick_result(t.oit, 1, &pick), OIT_WRONG_ORDER);
    oit_scene_expect(oit_begin(t.oit, &frame), "oit_begin");
    oit_scene_expect(oit_end(t.oit), "oit_end");
    assert_int_equal(oit_pick_result(t.oit, 0, &pick), OIT_NOT_READY);
    t.quiet = false;
    oit_setting_clear(&t, s);
    oit_scene_render(s, t.oit, &frame, NULL);
    static const int expected[4][4] = {{10, 1, 1, 1}, {25, 2, 1, 2}, {9, 0, 0, 0}, {26, 0, 0, 0}};
    for (int i = 0; i < 4; ++i) {
        oit_scene_expect(oit_pick_result(t.oit, 1, &pick), "oit_pick_result");
        assert_int_equal(pick.x, expected[i][0]);
        assert_int_equal(pick.layers, expected[i][1]);
        assert_int_equal(pick.found, expected[i][2]);
        assert_int_equal(pick.part, expected[i][3]);
        assert_int_equal(pick.frame, 2);
    }
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* ---- the depth of the composite ---- */

/* NAN where the background's depth is to stay. near_limit: rounding decides. */
static double true_depth(const oit_scene *s, const oit_truth_layer *at, size_t count, double limit, bool *near_limit) {
    double through[3] = {1, 1, 1};
    *near_limit = false;
    for (size_t i = 0; i < count; ++i) {
        double most = 0;
        for (int c = 0; c < 3; ++c) {
            if (at[i].blend == OIT_BLEND_MULTIPLY)
                through[c] *= 1 - at[i].color[3] + at[i].color[3] * at[i].color[c];
            else if (at[i].blend == OIT_BLEND_OVER)
                through[c] *= 1 - at[i].color[3];
            most = fmax(most, through[c]);
        }
        if (fabs(most - limit) < 1e-5)
            *near_limit = true;
        if (most < limit)
            return window_depth(s, at[i].depth);
    }
    return (double)NAN;
}

typedef struct depth_case {
    const char *name;
    oit_desc desc;
    oit_depth depth;
    float threshold;
    bool es, to_color, into_target, reversed;
} depth_case;

static void mix_blends(oit_scene *s) {
    for (size_t i = 0; i < s->count; ++i)
        s->objects[i].blend = (uint32_t)(i % 3);
}

/* What the host has put there: 0.125, or the target's own depth. */
static void check_depth(const depth_case *c) {
    enum { SIZE = 64 };
    oit_scene *s = malloc(sizeof *s);
    oit_truth *truth = malloc(SIZE * SIZE * sizeof *truth);
    oit_setting t;
    ref_i_world world;
    const float before[4] = {0.125f, 0.125f, 0.125f, 0.125f};
    oit_desc desc = c->desc;
    double limit = c->depth == OIT_DEPTH_FIRST    ? 2
                   : c->depth == OIT_DEPTH_MEDIAN ? 0.5
                                                  : (double)c->threshold,
           worst = 0;
    size_t written = 0, kept = 0;
    desc.reversed_z = c->reversed;
    oit_setting_open(&t, c->es, SIZE, SIZE, 0, GL_RGBA16F, desc);
    if (c->reversed)
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    make_scene(s, SIZE);
    s->reversed = c->reversed;
    if (desc.fields & OIT_FIELD_BLEND)
        mix_blends(s);
    oit_truth_render(s, truth);
    open_world(&world, s);
    GLuint color = oit_setting_texture(SIZE, SIZE, 0, GL_R32F);
    GLuint depth = oit_setting_texture(SIZE, SIZE, 0, GL_DEPTH_COMPONENT32F);
    GLuint out = oit_setting_framebuffer(c->to_color ? color : 0, c->to_color ? 0 : depth, 0);
    glClearBufferfv(c->to_color ? GL_COLOR : GL_DEPTH, 0, before);
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    frame.depth = c->depth;
    frame.depth_threshold = c->threshold;
    frame.depth_framebuffer = c->into_target ? t.framebuffer : out;
    frame.depth_to_color = c->to_color;
    oit_setting_clear(&t, s);
    float *background = malloc(SIZE * SIZE * sizeof *background), *picture = malloc(SIZE * SIZE * sizeof *picture);
    if (c->into_target)
        glReadPixels(0, 0, SIZE, SIZE, GL_DEPTH_COMPONENT, GL_FLOAT, background);
    oit_scene_render(s, t.oit, &frame, NULL);
    if (desc.fit == OIT_FIT_ASYNC) {
        glFinish();
        oit_setting_clear(&t, s);
        oit_scene_render(s, t.oit, &frame, NULL);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, frame.depth_framebuffer);
    if (c->es) { /* which reads no depths, and of colours all four */
        float *all = oit_setting_read(&t, out);
        for (int i = 0; i < SIZE * SIZE; ++i)
            picture[i] = all[4 * i];
        free(all);
    } else {
        glReadPixels(0, 0, SIZE, SIZE, c->to_color ? GL_RED : GL_DEPTH_COMPONENT, GL_FLOAT, picture);
    }
    for (int i = 0; i < SIZE * SIZE; ++i) {
        bool near_limit;
        size_t count;
        if (truth[i].left_out)
            continue;
        oit_truth_cast(&world, s, i % SIZE + 0.5, i / SIZE + 0.5, layers, &count);
        double expected = true_depth(s, layers, count, limit, &near_limit);
        if (near_limit)
            continue;
        if (isnan(expected)) {
            assert_true(picture[i] == (c->into_target ? background[i] : 0.125f));
            ++kept;
        } else {
            worst = fmax(worst, fabs((double)picture[i] - expected));
            ++written;
        }
    }
    printf("    %-34s max %.2g, %zu written, %zu kept\n", c->name, worst, written, kept);
    assert_true(worst < 2e-6);
    assert_true(written > 100 && kept > 100);
    free(background);
    free(picture);
    glDeleteTextures(1, &color);
    glDeleteTextures(1, &depth);
    glDeleteFramebuffers(1, &out);
    ref_i_free_world(&world);
    oit_scene_drop(s);
    if (c->reversed)
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    oit_setting_close(&t);
    free(truth);
    free(s);
}

static void test_depth_of_the_composite(void **state) {
    static const depth_case cases[] = {
        {.name = "first", .depth = OIT_DEPTH_FIRST},
        {.name = "median", .depth = OIT_DEPTH_MEDIAN},
        {.name = "threshold 0.7, as a colour", .depth = OIT_DEPTH_THRESHOLD, .threshold = 0.7f, .to_color = true},
        {.name = "threshold 0.3, into the target",
         .depth = OIT_DEPTH_THRESHOLD,
         .threshold = 0.3f,
         .into_target = true},
        {.name = "first, into the target, reversed", .depth = OIT_DEPTH_FIRST, .into_target = true, .reversed = true},
        {.name = "median, reversed, as a colour", .depth = OIT_DEPTH_MEDIAN, .to_color = true, .reversed = true},
        {.name = "median, bands", .desc = {.ceiling_bytes = 16 * 100}, .depth = OIT_DEPTH_MEDIAN},
        {.name = "median, slabs", .desc = {.max_block_bytes = 4000}, .depth = OIT_DEPTH_MEDIAN},
        {.name = "median, never waiting", .desc = {.fit = OIT_FIT_ASYNC}, .depth = OIT_DEPTH_MEDIAN},
        {.name = "median, blends", .desc = {.fields = OIT_FIELD_BLEND}, .depth = OIT_DEPTH_MEDIAN},
        {.name = "first, ES, as a colour", .depth = OIT_DEPTH_FIRST, .es = true, .to_color = true},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
        check_depth(&cases[i]);
}

/* 200 sheets of alpha 0.01: the median is the 69th (0.99^69 < 1/2 <= 0.99^68). */
static void test_median_of_many(void **state) {
    (void)state;
    oit_desc desc = {0};
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    float got[16];
    oit_setting_open(&t, false, 4, 4, 0, GL_RGBA8, desc);
    oit_scene_init(s, 4, 4);
    oit_scene_sheets(s, 200, 0.01, false);
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    frame.depth = OIT_DEPTH_MEDIAN;
    frame.depth_framebuffer = t.framebuffer;
    oit_setting_clear(&t, s);
    oit_scene_render(s, t.oit, &frame, NULL);
    glBindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
    glReadPixels(0, 0, 4, 4, GL_DEPTH_COMPONENT, GL_FLOAT, got);
    for (int i = 0; i < 16; ++i)
        assert_true(fabs((double)got[i] - (0.5 + 0.5 * (-0.9 + 1.8 * 68.5 / 200))) < 1e-6);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* Three sheets at one depth and one behind: all three count, and are picked by part, then by key. */
static void test_coincident_layers(void **state) {
    static const uint32_t parts[4] = {9, 3, 3, 1}, keys[4] = {0, 8, 2, 0}, expected[4] = {2, 1, 0, 3};
    (void)state;
    oit_desc desc = {.fields = OIT_FIELD_PART | OIT_FIELD_KEY};
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    float got[16];
    oit_setting_open(&t, false, 4, 4, 0, GL_RGBA8, desc);
    oit_scene_init(s, 4, 4);
    for (int i = 0; i < 4; ++i) {
        const double z = i < 3 ? 0.25 : 0.5, depth[4] = {z, z, z, z}, color[4] = {1, 1, 1, 0.25};
        size_t at = oit_scene_quad(s, -1, -1, 1, 1, depth, color);
        s->objects[at].part = parts[i];
        s->objects[at].key = keys[i];
    }
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    for (int layer = 0; layer < 4; ++layer) {
        oit_pick pick = pick_one(&t, s, &frame, 2, 1, layer);
        assert_int_equal(pick.layers, 4);
        assert_int_equal(pick.part, parts[expected[layer]]);
        assert_int_equal(pick.key, keys[expected[layer]]);
    }
    frame.depth = OIT_DEPTH_MEDIAN; /* 0.75^3 < 1/2 < 0.75^2 */
    frame.depth_framebuffer = t.framebuffer;
    oit_setting_clear(&t, s);
    oit_scene_render(s, t.oit, &frame, NULL);
    glBindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
    glReadPixels(0, 0, 4, 4, GL_DEPTH_COMPONENT, GL_FLOAT, got);
    for (int i = 0; i < 16; ++i)
        assert_true(got[i] == 0.625f);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* Pixels whose runs did not fit: picking says how many layers there are and finds none, and their depth stays. */
static void test_pixels_that_do_not_fit(void **state) {
    (void)state;
    oit_desc desc = {.fit = OIT_FIT_ASYNC, .ceiling_bytes = 16};
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    float got[64];
    oit_setting_open(&t, false, 8, 8, 0, GL_RGBA8, desc);
    oit_scene_init(s, 8, 8);
    oit_scene_sheets(s, 5, 0.5, false);
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    frame.depth = OIT_DEPTH_FIRST;
    frame.depth_framebuffer = t.framebuffer;
    oit_pick pick = pick_one(&t, s, &frame, 3, 4, 1);
    assert_int_equal(pick.layers, 5);
    assert_int_equal(pick.found, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
    glReadPixels(0, 0, 8, 8, GL_DEPTH_COMPONENT, GL_FLOAT, got);
    for (int i = 0; i < 64; ++i)
        assert_true(got[i] == 1.0f);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

static void test_bad_depths(void **state) {
    (void)state;
    oit_desc desc = {0};
    static const float bad[] = {0, -1, 1.5f, NAN, INFINITY};
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    oit_setting_open(&t, false, 8, 8, 0, GL_RGBA8, desc);
    oit_scene_init(s, 8, 8);
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    t.quiet = t.h.quiet = true;
    frame.depth = OIT_DEPTH_THRESHOLD;
    frame.depth_framebuffer = t.framebuffer;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        frame.depth_threshold = bad[i];
        assert_int_equal(oit_begin(t.oit, &frame), OIT_INVALID_ARGUMENT);
    }
    frame.depth = (oit_depth)17;
    assert_int_equal(oit_begin(t.oit, &frame), OIT_INVALID_ARGUMENT);
    frame.depth = OIT_DEPTH_MEDIAN;
    glGenFramebuffers(1, &frame.depth_framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, frame.depth_framebuffer); /* nothing is attached */
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    assert_int_equal(oit_begin(t.oit, &frame), OIT_TARGET_INCOMPLETE);
    glDeleteFramebuffers(1, &frame.depth_framebuffer);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* ---- state ---- */

typedef struct state_seen {
    GLint numbers[12], storage[4], viewport[4], scissor[4];
    GLboolean depth_mask, depth_test, blend, mask[4];
} state_seen;

static state_seen look_at_state(void) {
    static const GLenum names[] = {
        GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING, GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING,
        GL_DEPTH_FUNC,      GL_COPY_WRITE_BUFFER,    GL_UNIFORM_BUFFER_BINDING,   GL_SHADER_STORAGE_BUFFER_BINDING,
        GL_BLEND_SRC_RGB,   GL_BLEND_DST_RGB};
    state_seen seen;
    memset(&seen, 0, sizeof seen);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i)
        glGetIntegerv(names[i], &seen.numbers[i]);
    for (GLuint i = 0; i < 3; ++i)
        glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, i, &seen.storage[i]);
    glGetIntegerv(GL_VIEWPORT, seen.viewport);
    glGetIntegerv(GL_SCISSOR_BOX, seen.scissor);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &seen.depth_mask);
    glGetBooleanv(GL_COLOR_WRITEMASK, seen.mask);
    seen.depth_test = glIsEnabled(GL_DEPTH_TEST);
    seen.blend = glIsEnabled(GL_BLEND);
    return seen;
}

/* With picks and a depth all is put back, and oit_pick_* leave it alone at any time; by the passes as data the host gets
 * the same picks and depths. */
static void test_state_and_passes_as_data(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    float got[2][32 * 32];
    oit_pick picks[2];
    for (int raw = 0; raw < 2; ++raw) {
        oit_desc desc = {
            .fit = OIT_FIT_ASYNC, .state = raw ? OIT_STATE_NONE : OIT_STATE_RESTORE, .fields = OIT_FIELD_PART};
        oit_setting t;
        GLuint buffer;
        oit_setting_open(&t, false, 32, 32, 0, GL_RGBA8, desc);
        make_scene(s, 32);
        GLuint color = oit_setting_texture(32, 32, 0, GL_R32F), out = oit_setting_framebuffer(color, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT);
        oit_frame frame = oit_scene_frame(s, t.framebuffer);
        oit_truth truth[32 * 32];
        int at = 0;
        oit_truth_render(s, truth);
        while (truth[at].left_out || truth[at].layers < 2)
            ++at;
        frame.depth = OIT_DEPTH_FIRST;
        frame.depth_framebuffer = out;
        frame.depth_to_color = 1;
        oit_setting_clear(&t, s);
        glGenBuffers(1, &buffer);
        for (GLuint i = 0; i < 3; ++i)
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, buffer);
        glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
        glDepthMask(GL_FALSE);
        glDepthFunc(GL_GEQUAL);
        glEnable(GL_BLEND);
        glBlendFunc(GL_DST_COLOR, GL_SRC_ALPHA);
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
        glViewport(1, 2, 3, 4);
        glScissor(4, 3, 2, 1);
        state_seen before = look_at_state(), after;
        oit_scene_expect(oit_pick_begin(t.oit, at % 32, at / 32, 1), "oit_pick_begin");
        after = look_at_state();
        assert_memory_equal(&before, &after, sizeof before);
        if (raw) {
            oit_scene_render_raw(s, t.oit, &frame, NULL, NULL);
        } else {
            oit_scene_render(s, t.oit, &frame, NULL);
            after = look_at_state();
            assert_memory_equal(&before, &after, sizeof before);
        }
        before = look_at_state();
        oit_scene_expect(oit_pick_result(t.oit, 1, &picks[raw]), "oit_pick_result");
        after = look_at_state();
        assert_memory_equal(&before, &after, sizeof before);
        assert_int_equal(picks[raw].found, 1);
        glBindFramebuffer(GL_FRAMEBUFFER, out);
        glReadPixels(0, 0, 32, 32, GL_RED, GL_FLOAT, got[raw]);
        glDeleteBuffers(1, &buffer);
        glDeleteFramebuffers(1, &out);
        glDeleteTextures(1, &color);
        oit_scene_drop(s);
        oit_setting_close(&t);
    }
    assert_memory_equal(got[0], got[1], sizeof got[0]);
    assert_memory_equal(&picks[0], &picks[1], sizeof picks[0]);
    free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_picks_match_the_rays),
        cmocka_unit_test(test_picks_in_bands_and_slabs),
        cmocka_unit_test(test_all_fields_come_back),
        cmocka_unit_test(test_many_and_bad_picks),
        cmocka_unit_test(test_depth_of_the_composite),
        cmocka_unit_test(test_median_of_many),
        cmocka_unit_test(test_coincident_layers),
        cmocka_unit_test(test_pixels_that_do_not_fit),
        cmocka_unit_test(test_bad_depths),
        cmocka_unit_test(test_state_and_passes_as_data),
    };
    setvbuf(stdout, NULL, _IOLBF, 0);
    return cmocka_run_group_tests(tests, NULL, NULL);
}

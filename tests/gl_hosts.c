/* gl_hosts.c: what hosts do to transparency.h: shaders and conventions of their own, a target that holds other things,
 * lines from plain arrays. */
#include "gl_harness.h"

/* ---- a scene of boxes: an opaque one in glass, glass behind, and an opaque one that the limit hides ---- */

static const float corners[24] = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1};
static const uint32_t outward[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                     2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
static uint32_t turned_around[36];

enum { SIZE = 96, BOXES = 4 };
static ref_scene scene_of_boxes;
static ref_object truths[BOXES];
static harness_object boxes[BOXES];

static void make_boxes(const uint32_t *indices) {
    static const double sizes[BOXES] = {0.9, 0.4, 0.6, 0.4};
    static const double shifts[BOXES][3] = {{0, 0, 0}, {0.1, 0, 0.2}, {0.6, 0.3, -2}, {-0.2, -0.3, -3}};
    memset(&scene_of_boxes, 0, sizeof scene_of_boxes);
    memset(truths, 0, sizeof truths);
    memset(boxes, 0, sizeof boxes);
    for (int i = 0; i < BOXES; ++i) {
        for (int k = 0; k < 3; ++k) {
            truths[i].model[5 * k] = sizes[i];
            truths[i].model[12 + k] = shifts[i][k];
        }
        truths[i].model[15] = 1;
        truths[i].positions = corners;
        truths[i].indices = indices;
        truths[i].vertex_count = 8;
        truths[i].triangle_count = 12;
        truths[i].id = (uint32_t)(i + 1);
        truths[i].transparent = i % 2 == 0;
        truths[i].color[i % 3] = 0.8;
        truths[i].alpha = 0.5;
        boxes[i].truth = truths[i];
        harness_upload(&boxes[i], NULL);
    }
    /* Turned a little; orthographic, looking down -z from z = 5 to z = -5. */
    const double view[16] = {0.96, 0.1, -0.25, 0, 0, 0.93, 0.36, 0, 0.27, -0.34, 0.9, 0, 0, 0, 0, 1};
    const double projection[16] = {0.7, 0, 0, 0, 0, 0.7, 0, 0, 0, 0, -0.2, 0, 0, 0, 0, 1};
    memcpy(scene_of_boxes.view, view, sizeof view);
    memcpy(scene_of_boxes.projection, projection, sizeof projection);
    scene_of_boxes.width = scene_of_boxes.height = SIZE;
    scene_of_boxes.opaque_weight = 0.7;
    scene_of_boxes.background_weight = 0.4;
    scene_of_boxes.blending = REF_BLEND_NORMALISED;
    scene_of_boxes.objects = truths;
    scene_of_boxes.object_count = BOXES;
}

static void drop_boxes(void) {
    for (int i = 0; i < BOXES; ++i)
        harness_drop_object(&boxes[i]);
}

static const double grey[3] = {0.5, 0.5, 0.5};
static unsigned char plain[SIZE * SIZE * 4], picture[SIZE * SIZE * 4];

/* The picture that every variant below is to repeat, checked against the reference first. */
static void draw_plain(void) {
    static ref_pixel truth[SIZE * SIZE];
    harness h;
    harness_open(&h, 450, false, NULL);
    make_boxes(outward);
    memcpy(scene_of_boxes.background, grey, sizeof grey);
    harness_target(&h, SIZE, SIZE);
    harness_clear(&h, grey, 1.0f);
    harness_draw(&h, &scene_of_boxes, boxes, BOXES, NULL, plain);
    assert_true(ref_render(&scene_of_boxes, truth));
    harness_check(&h, "boxes", &scene_of_boxes, truth, plain);
    drop_boxes();
    harness_close(&h);
}

static int draw_plain_once(void **state) {
    (void)state;
    for (int i = 0; i < 36; i += 3) {
        turned_around[i] = outward[i];
        turned_around[i + 1] = outward[i + 2];
        turned_around[i + 2] = outward[i + 1];
    }
    draw_plain();
    return 0;
}

static int differing_pixels(const unsigned char *a, const unsigned char *b, int most) {
    int count = 0;
    for (size_t i = 0; i < SIZE * SIZE; ++i)
        for (size_t k = 0; k < 4; ++k)
            if (abs(a[4 * i + k] - b[4 * i + k]) > most) {
                ++count;
                break;
            }
    return count;
}

/* ---- the host's own shaders ---- */

static const char host_vertex[] = "layout(location = 0) in vec3 place;\n"
                                  "uniform mat4 to_clip;\n"
                                  "void main() { gl_Position = to_clip * vec4(place, 1.0); }\n";
static const char host_fragment[] = "uniform vec4 paint;\n"
                                    "uniform highp uint number;\n"
                                    "void main() { tr_surface(paint, number); }\n";

static GLuint link_host_program(const harness *h, tr_rule rule) {
    GLuint program = glCreateProgram();
    char log[1024] = "";
    GLint ok = 0;
    for (int stage = 0; stage < 2; ++stage) {
        int count = 0;
        const char *const *strings = tr_glsl(h->tr, stage ? TR_FRAGMENT : TR_VERTEX, rule, &count);
        const char *all[64];
        memcpy(all, strings, (size_t)count * sizeof *all);
        all[count++] = stage ? host_fragment : host_vertex;
        GLuint shader = glCreateShader(stage ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER);
        glShaderSource(shader, count, all, NULL);
        glCompileShader(shader);
        glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        if (!ok)
            fail_msg("host shader: %s", log);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    assert_true(ok);
    return program;
}

static void set_host_uniforms(GLuint program, const tr_material *material) {
    glUniformMatrix4fv(glGetUniformLocation(program, "to_clip"), 1, GL_FALSE, material->model_view_projection);
    glUniform4fv(glGetUniformLocation(program, "paint"), 1, material->color);
    glUniform1ui(glGetUniformLocation(program, "number"), material->object);
}

static void check_host_shaders(int version, bool es) {
    harness h;
    GLuint programs[TR_RULE_COUNT];
    harness_options options = {0, 0, NULL, NULL, programs, set_host_uniforms, 0, NULL};
    harness_open(&h, version, es, NULL);
    make_boxes(outward);
    harness_target(&h, SIZE, SIZE);
    harness_clear(&h, grey, 1.0f);
    for (int rule = 0; rule < TR_RULE_COUNT; ++rule) {
        programs[rule] = link_host_program(&h, (tr_rule)rule);
        assert_int_equal(tr_prepare_program(h.tr, programs[rule]), TR_OK);
    }
    harness_draw(&h, &scene_of_boxes, boxes, BOXES, &options, picture);
    assert_int_equal(options.passes, 4);
    assert_int_equal(differing_pixels(plain, picture, es ? 1 : 0), 0);
    for (int rule = 0; rule < TR_RULE_COUNT; ++rule)
        glDeleteProgram(programs[rule]);
    drop_boxes();
    harness_close(&h);
}

static void test_host_shaders_draw_the_same(void **state) {
    (void)state;
    check_host_shaders(450, false);
    check_host_shaders(330, false);
    check_host_shaders(300, true);
}

/* ---- conventions ---- */

/* The same picture, bit for bit, by a host of other habits. */
static void check_convention(const tr_desc *desc, const uint32_t *indices) {
    harness h;
    harness_open(&h, 450, false, desc);
    make_boxes(indices);
    for (int c = 0; c < 4 && desc->reversed_z; ++c)
        scene_of_boxes.projection[4 * c + 2] *= -1; /* near is 1 */
    harness_target(&h, SIZE, SIZE);
    harness_clear(&h, grey, desc->reversed_z ? 0.0f : 1.0f);
    harness_draw(&h, &scene_of_boxes, boxes, BOXES, NULL, picture);
    assert_int_equal(differing_pixels(plain, picture, 0), 0);
    drop_boxes();
    harness_close(&h);
}

static void test_reversed_depth_draws_the_same(void **state) {
    tr_desc desc = {0};
    (void)state;
    desc.reversed_z = 1;
    check_convention(&desc, outward);
}

static void test_clockwise_fronts_draw_the_same(void **state) {
    tr_desc desc = {0};
    (void)state;
    desc.front_face_cw = 1;
    check_convention(&desc, turned_around);
}

/* Other texture units and binding points: nothing may be wired to fixed numbers. */
static void test_other_units_draw_the_same(void **state) {
    tr_desc desc = {0};
    (void)state;
    desc.first_texture_unit = 1;
    desc.uniform_binding = 3;
    check_convention(&desc, outward);
}

static void test_viewport_in_a_larger_target(void **state) {
    static unsigned char all[(SIZE + 40) * (SIZE + 30) * 4];
    harness h;
    harness_options options = {23, 11, NULL, NULL, NULL, NULL, 0, NULL};
    (void)state;
    harness_open(&h, 450, false, NULL);
    make_boxes(outward);
    harness_target(&h, SIZE + 40, SIZE + 30);
    harness_clear(&h, grey, 1.0f);
    harness_draw(&h, &scene_of_boxes, boxes, BOXES, &options, picture);
    assert_int_equal(differing_pixels(plain, picture, 0), 0);
    glReadPixels(0, 0, SIZE + 40, SIZE + 30, GL_RGBA, GL_UNSIGNED_BYTE, all);
    for (int y = 0; y < SIZE + 30; ++y)
        for (int x = 0; x < SIZE + 40; ++x)
            if (x < 23 || x >= 23 + SIZE || y < 11 || y >= 11 + SIZE)
                assert_int_equal(all[4 * (y * (SIZE + 40) + x)], 128);
    drop_boxes();
    harness_close(&h);
}

/* What the host drew nearer hides the picture; the picture's depth hides what comes after; alpha stays. */
static void test_target_depth_and_alpha(void **state) {
    harness h;
    (void)state;
    harness_open(&h, 450, false, NULL);
    make_boxes(outward);
    harness_target(&h, SIZE, SIZE);
    harness_clear(&h, grey, 1.0f);
    glClearColor(0.5f, 0.5f, 0.5f, 0.25f);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, SIZE / 2, SIZE);
    glClearDepth(0.1); /* nearer than all boxes, in the left half */
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
    harness_draw(&h, &scene_of_boxes, boxes, BOXES, NULL, picture);
    for (size_t i = 0; i < SIZE * SIZE; ++i) {
        bool hidden = i % SIZE < SIZE / 2;
        assert_int_equal(picture[4 * i + 3], 64);
        for (size_t k = 0; k < 3; ++k)
            assert_int_equal(picture[4 * i + k], hidden ? 128 : plain[4 * i + k]);
    }
    float middle = 0;
    glReadPixels(SIZE * 3 / 5, SIZE / 2, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &middle);
    assert_true(middle > 0.1f && middle < 0.5f); /* the glass in front, not the opaque box behind it */
    drop_boxes();
    harness_close(&h);
}

static void test_other_attachments_are_not_written(void **state) {
    static unsigned char other[SIZE * SIZE * 4];
    static const GLenum both[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    static const float red[4] = {1, 0, 0, 1};
    harness h;
    GLuint texture;
    (void)state;
    harness_open(&h, 450, false, NULL);
    make_boxes(outward);
    harness_target(&h, SIZE, SIZE);
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, SIZE, SIZE, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, h.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, texture, 0);
    harness_clear(&h, grey, 1.0f);
    glDrawBuffers(2, both);
    glClearBufferfv(GL_COLOR, 1, red);
    harness_draw(&h, &scene_of_boxes, boxes, BOXES, NULL, picture);
    assert_int_equal(differing_pixels(plain, picture, 0), 0);
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, other);
    for (size_t i = 0; i < SIZE * SIZE; ++i) {
        assert_int_equal(other[4 * i], 255);
        assert_int_equal(other[4 * i + 1], 0);
    }
    glDeleteTextures(1, &texture);
    drop_boxes();
    harness_close(&h);
}

/* ---- lines: a glass box, an opaque one in it, and horizontal bars at chosen depths ---- */

typedef struct line_vertex {
    float x, y, depth, slack, center_x, center_y, arc;
    uint32_t kinds;
} line_vertex;

static GLuint line_array, line_buffer;
static bool reversed;
static int corner_x, corner_y; /* of the viewport */

/* A bar from left to right, eight pixels thick about `y`. */
static void upload_bar(float y, float depth) {
    line_vertex v[6];
    for (int i = 0; i < 6; ++i) {
        bool right = i == 1 || i == 2 || i == 4, top = i == 2 || i == 4 || i == 5;
        memset(&v[i], 0, sizeof v[i]);
        v[i].x = v[i].center_x = right ? (float)SIZE : 0.0f;
        v[i].y = y + (top ? 4.0f : -4.0f);
        v[i].center_y = y;
        v[i].depth = reversed ? 1.0f - depth : depth;
        v[i].slack = 1e-4f;
    }
    glBindVertexArray(line_array);
    glBindBuffer(GL_ARRAY_BUFFER, line_buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof v, v, GL_STREAM_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof v[0], NULL);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof v[0], (const void *)offsetof(line_vertex, center_x));
    glBindVertexArray(0);
}

/* Draws boxes 0 (glass) and 1 (opaque) seen square on, and the bar as a line of one of them. */
static void draw_with_bar(harness *h, uint32_t owner, uint32_t kind) {
    tr_frame frame = harness_frame(h, &scene_of_boxes, boxes, 2);
    tr_pass pass;
    frame.wishes.blending = TR_BLENDING_OVER;
    frame.wishes.lines = kind;
    frame.outline_color[0] = 1.0f; /* red; creases white by default */
    frame.x = corner_x;
    frame.y = corner_y;
    harness_clear(h, grey, reversed ? 0.0f : 1.0f);
    glClearColor(0.5f, 0.5f, 0.5f, 0.25f);
    glClear(GL_COLOR_BUFFER_BIT);
    assert_int_equal(tr_begin(h->tr, &frame), TR_OK);
    while (tr_next_pass(h->tr, &pass))
        for (int i = 0; i < 2; ++i) {
            tr_material material;
            if (!tr_pass_draws(&pass, &boxes[i].object) || (pass.lines && boxes[i].object.id != owner))
                continue;
            if (pass.lines) {
                assert_int_equal(pass.lines, kind);
                glBindVertexArray(line_array);
                glDrawArrays(GL_TRIANGLES, 0, 6);
                continue;
            }
            harness_material(&scene_of_boxes, &truths[i], &material);
            tr_set_material(h->tr, &pass, &material);
            glBindVertexArray(boxes[i].array);
            glDrawElements(GL_TRIANGLES, 36, GL_UNSIGNED_INT, NULL);
        }
    glBindVertexArray(0);
    assert_int_equal(tr_end(h->tr), TR_OK);
    glReadPixels(corner_x, corner_y, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, picture);
    for (int i = 0; i < SIZE * SIZE; ++i)
        assert_int_equal(picture[4 * i + 3], 64); /* the target's alpha is nobody's */
}

static void expect(int x, int y, double r, double g, double b) {
    const double color[3] = {r, g, b};
    for (int k = 0; k < 3; ++k) {
        int found = picture[4 * (y * SIZE + x) + k];
        if (fabs(found - 255 * color[k]) > 2)
            fail_msg("pixel %d, %d channel %d is %d, should be %.0f", x, y, k, found, 255 * color[k]);
    }
}

/* Seen square on: the glass (alpha 0.5, colour 0.8 0 0) spans pixels 18 to 78 at window depths 0.41 to 0.59, the opaque
 * box (0 0.8 0) pixels 37 to 67 by its size 0.4 and shift 0.1, at 0.44 to 0.52; the background is 0.5 grey. */
enum { OUTSIDE = 8, GLASS = 26, CORE = 50, NEAR_EDGE = 72, LINE_Y = 48 };

/* Lines of the opaque box. */
static void check_opaque_lines(harness *h) {
    upload_bar(LINE_Y, 0.43f); /* in the glass and before the core: tinted by the glass */
    draw_with_bar(h, 2, TR_LINES_OUTLINES);
    expect(OUTSIDE, LINE_Y, 1, 0, 0);
    expect(GLASS, LINE_Y, 0.9, 0, 0);
    expect(CORE, LINE_Y, 0.9, 0, 0);
    expect(CORE, LINE_Y + 8, 0.4, 0.4, 0); /* beside the line the core behind glass */

    upload_bar(LINE_Y, 0.55f); /* behind the core, before the back of the glass */
    draw_with_bar(h, 2, TR_LINES_OUTLINES);
    expect(GLASS, LINE_Y, 0.9, 0, 0);
    expect(CORE, LINE_Y, 0.4, 0.4, 0);

    upload_bar(LINE_Y, 0.7f); /* behind the glass: hidden by the limit, seen beside it */
    draw_with_bar(h, 2, TR_LINES_OUTLINES);
    expect(OUTSIDE, LINE_Y, 1, 0, 0);
    expect(GLASS, LINE_Y, 0.65, 0.25, 0.25);
    expect(CORE, LINE_Y, 0.4, 0.4, 0);

    upload_bar(LINE_Y, 0.3f); /* before everything: the glass does not tint it */
    draw_with_bar(h, 2, TR_LINES_OUTLINES);
    expect(GLASS, LINE_Y, 1, 0, 0);
    expect(CORE, LINE_Y, 1, 0, 0);

    upload_bar(LINE_Y,
               0.43f); /* a crease is white, and leaves no depth: glass before it covers it as it does the core */
    draw_with_bar(h, 2, TR_LINES_CREASES);
    expect(CORE, LINE_Y, 0.9, 0.5, 0.5);
    upload_bar(LINE_Y, 0.3f);
    draw_with_bar(h, 2, TR_LINES_CREASES);
    expect(GLASS, LINE_Y, 0.9, 0.5, 0.5);
}

/* Lines of the glass. */
static void check_transparent_lines(harness *h) {
    upload_bar(LINE_Y, 0.41f); /* on its front: ink over all */
    draw_with_bar(h, 1, TR_LINES_OUTLINES);
    expect(GLASS, LINE_Y, 1, 0, 0);
    expect(CORE, LINE_Y, 1, 0, 0);

    upload_bar(LINE_Y, 0.4101f); /* a little behind its front: within the tolerance of two pixels, 2e-4 here */
    draw_with_bar(h, 1, TR_LINES_OUTLINES);
    expect(GLASS, LINE_Y, 1, 0, 0);
    expect(NEAR_EDGE, LINE_Y, 1, 0, 0);

    upload_bar(LINE_Y, 0.5f); /* behind its front: faces of transparent objects never shine through */
    draw_with_bar(h, 1, TR_LINES_OUTLINES);
    expect(OUTSIDE, LINE_Y, 1, 0, 0);
    expect(GLASS, LINE_Y, 0.65, 0.25, 0.25);
}

static void check_lines(bool reversed_z, int x, int y) {
    harness h;
    tr_desc desc = {0};
    reversed = reversed_z;
    corner_x = x;
    corner_y = y;
    desc.reversed_z = reversed_z;
    harness_open(&h, 450, false, &desc);
    make_boxes(outward);
    memset(scene_of_boxes.view, 0, sizeof scene_of_boxes.view);
    for (int i = 0; i < 4; ++i)
        scene_of_boxes.view[5 * i] = 1;
    scene_of_boxes.projection[10] *= reversed_z ? -1 : 1;
    harness_target(&h, SIZE + x, SIZE + y);
    glGenVertexArrays(1, &line_array);
    glGenBuffers(1, &line_buffer);
    check_opaque_lines(&h);
    check_transparent_lines(&h);
    glDeleteVertexArrays(1, &line_array);
    glDeleteBuffers(1, &line_buffer);
    drop_boxes();
    harness_close(&h);
}

static void test_lines_lie_between_the_surfaces(void **state) {
    (void)state;
    check_lines(false, 0, 0);
    check_lines(false, 23, 11);
    check_lines(true, 23, 11);
}

/* ---- what is no number ---- */

/* Alpha of the front glass by the built-in program, from its colour over grey at a pixel beside the core. */
static double drawn_alpha(harness *h, float distance, float d_max, float k) {
    float distances[8], d_maxes[BOXES] = {d_max, 0, 0, 0}, ks[BOXES] = {k, 0, 0, 0};
    harness_options options = {0, 0, d_maxes, ks, NULL, NULL, 0, NULL};
    for (int i = 0; i < 8; ++i)
        distances[i] = distance;
    make_boxes(outward);
    memset(scene_of_boxes.view, 0, sizeof scene_of_boxes.view);
    for (int i = 0; i < 4; ++i)
        scene_of_boxes.view[5 * i] = 1;
    scene_of_boxes.blending = REF_BLEND_OVER;
    harness_drop_object(&boxes[0]);
    boxes[0].truth.alpha = 1.0;
    harness_upload(&boxes[0], distances);
    harness_clear(h, grey, 1.0f);
    harness_draw(h, &scene_of_boxes, boxes, 1, &options, picture);
    drop_boxes();
    return (picture[4 * (LINE_Y * SIZE + GLASS)] / 255.0 - 0.5) / 0.3;
}

static void test_alpha_law_on_the_gpu(void **state) {
    static const float values[] = {0.0f, -1.0f, 1e-30f, 0.25f, 1.0f, 1e30f, INFINITY, NAN};
    enum { COUNT = sizeof values / sizeof values[0] };
    harness h;
    (void)state;
    harness_open(&h, 450, false, NULL);
    harness_target(&h, SIZE, SIZE);
    for (int d = 0; d < COUNT; ++d)
        for (int d_max = 0; d_max < COUNT; ++d_max)
            for (int k = 0; k < COUNT; ++k) {
                double expected = (double)tr_view_alpha(values[d], values[d_max], values[k]);
                double found = drawn_alpha(&h, values[d], values[d_max], values[k]);
                if (fabs(found - expected) > 0.01) /* two steps of 8 bits over 0.3 of contrast */
                    fail_msg("alpha(%g, %g, %g) is %g, should be %g", (double)values[d], (double)values[d_max],
                             (double)values[k], found, expected);
            }
    harness_close(&h);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_host_shaders_draw_the_same),
        cmocka_unit_test(test_reversed_depth_draws_the_same),
        cmocka_unit_test(test_clockwise_fronts_draw_the_same),
        cmocka_unit_test(test_other_units_draw_the_same),
        cmocka_unit_test(test_viewport_in_a_larger_target),
        cmocka_unit_test(test_target_depth_and_alpha),
        cmocka_unit_test(test_other_attachments_are_not_written),
        cmocka_unit_test(test_lines_lie_between_the_surfaces),
        cmocka_unit_test(test_alpha_law_on_the_gpu),
    };
    return cmocka_run_group_tests_name("gl_hosts", tests, draw_plain_once, NULL);
}

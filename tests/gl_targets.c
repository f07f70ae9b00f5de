/* gl_targets.c: what is drawn into, and what stands behind: multisampled and sRGB targets, blend colours, jitter, clip
 * depth from 0 to 1; layers and groups on older contexts and with reversed depth; lines that are hidden or outside. */
#include "gl_scenes.h"

#include "probes_more.h"

enum { SIZE = 96 };
static unsigned char picture[4 * SIZE * SIZE * 4], other[4 * SIZE * SIZE * 4];
static ref_pixel truth[4 * SIZE * SIZE];

static void grouped_shells(test_scene *s) {
    shells(s);
    s->truths[0].group = s->truths[1].group = 2;
    ref_object *third = add_object(s, true, 0.2, 0.8, 0.3, 0.6);
    make_ball(s, third, -0.4, 0, 0, 0.7, 1);
    third->group = 2;
}

static void open_scene(test_scene *s, void (*make)(test_scene *), int size) {
    init_scene(s, size);
    make(s);
    s->scene.blending = REF_BLEND_OVER;
    finish_scene(s);
}

/* ---- older contexts, other depths ---- */

static const struct {
    int version;
    bool es;
} contexts[] = {{450, false}, {330, false}, {320, true}, {310, true}, {300, true}};
enum { CONTEXTS = sizeof contexts / sizeof contexts[0] };

static void draw_mode(harness *h, int mode, int size, unsigned char *pixels, ref_pixel *expected) {
    test_scene s;
    open_scene(&s, grouped_shells, size);
    s.scene.interior = mode == 0 ? REF_INTERIOR_IMPLICIT : REF_INTERIOR_LAYERS;
    s.scene.layers = mode == 0 ? 0 : 3;
    s.scene.group_distance = mode == 0 ? 0.6 : 0;
    if (expected)
        assert_true(ref_render(&s.scene, expected));
    for (int c = 0; c < 4 && h->tr->desc.reversed_z; ++c)
        s.scene.projection[4 * c + 2] *= -1;
    for (int c = 0; c < 4 && h->tr->desc.zero_to_one; ++c)
        s.scene.projection[4 * c + 2] = (s.scene.projection[4 * c + 2] + s.scene.projection[4 * c + 3]) / 2;
    harness_clear(h, s.scene.background, h->tr->desc.reversed_z ? 0.0f : 1.0f);
    harness_draw(h, &s.scene, s.objects, s.count, NULL, pixels);
    if (expected)
        harness_check(h, mode ? "layers" : "group", &s.scene, expected, pixels);
    drop_scene(&s);
}

static int largest_difference(const unsigned char *a, const unsigned char *b, size_t count) {
    int largest = 0;
    for (size_t i = 0; i < count; ++i)
        largest = abs(a[i] - b[i]) > largest ? abs(a[i] - b[i]) : largest;
    return largest;
}

static void test_layers_on_older_contexts(void **state) {
    (void)state;
    for (int mode = 0; mode < 2; ++mode)
        for (int i = 0; i < CONTEXTS; ++i) {
            harness h;
            harness_open(&h, contexts[i].version, contexts[i].es, NULL);
            harness_target(&h, SIZE, SIZE);
            draw_mode(&h, mode, SIZE, i ? other : picture, i ? NULL : truth);
            if (i)
                assert_true(largest_difference(picture, other, SIZE * SIZE * 4) <= 1);
            harness_close(&h);
        }
}

static void test_layers_with_reversed_depth(void **state) {
    (void)state;
    for (int mode = 0; mode < 2; ++mode) {
        tr_desc desc = {0};
        harness h;
        desc.reversed_z = 1;
        harness_open(&h, 450, false, &desc);
        harness_target(&h, SIZE, SIZE);
        draw_mode(&h, mode, SIZE, picture, truth);
        harness_close(&h);
    }
}

/* glClipControl: the same picture; with the option left out distances are wrong, and so is what joins a group. */
static void test_clip_depth_from_zero(void **state) {
    tr_desc desc = {0};
    harness h;
    (void)state;
    desc.zero_to_one = 1;
    harness_open(&h, 450, false, &desc);
    harness_target(&h, SIZE, SIZE);
    if (!glClipControl) { /* a driver of GL 3.3 */
        harness_close(&h);
        printf("    no glClipControl: not tested\n");
        return;
    }
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    draw_mode(&h, 0, SIZE, picture, truth);
    harness_close(&h);
}

/* ---- blend colours and light ---- */

static void check_blending(harness *h, void (*make)(test_scene *), const char *name, bool blend_color, bool srgb) {
    static const double sky[3] = {0.2, 0.7, 0.95};
    test_scene s;
    open_scene(&s, make, SIZE);
    s.scene.use_blend_color = blend_color;
    s.scene.srgb = srgb;
    memcpy(s.scene.blend_color, sky, sizeof sky);
    for (int blending = 0; blending < 3; ++blending) {
        char label[80];
        double background[3];
        s.scene.blending = (ref_blending)blending;
        assert_true(ref_render(&s.scene, truth));
        memcpy(background, s.scene.background, sizeof background);
        ref_i_to_light(&s.scene, background);
        if (srgb && !h->context.es)
            glEnable(GL_FRAMEBUFFER_SRGB);
        harness_clear(h, background, 1.0f);
        if (srgb && !h->context.es)
            glDisable(GL_FRAMEBUFFER_SRGB); /* switched on where it is needed, and off again */
        harness_draw(h, &s.scene, s.objects, s.count, NULL, picture);
        assert_true(h->context.es || !glIsEnabled(GL_FRAMEBUFFER_SRGB));
        snprintf(label, sizeof label, "%s, %d", name, blending);
        harness_check(h, label, &s.scene, truth, picture);
    }
    drop_scene(&s);
}

static void test_blend_colour_stands_for_the_background(void **state) {
    harness h;
    (void)state;
    harness_open(&h, 450, false, NULL);
    harness_target(&h, SIZE, SIZE);
    check_blending(&h, shells, "blend colour", true, false);
    check_blending(&h, only_glass, "blend colour, only glass", true, false);
    check_blending(&h, lone_sheet, "blend colour, sheet", true, false);
    harness_close(&h);
}

static void grey_room(test_scene *s) {
    shells(s);
    for (int k = 0; k < 3; ++k)
        s->scene.background[k] = 0.2;
}

static void test_light_is_blended(void **state) {
    (void)state;
    for (int i = 0; i < CONTEXTS; i += 2) {
        harness h;
        harness_open(&h, contexts[i].version, contexts[i].es, NULL);
        harness_target(&h, SIZE, SIZE);
        glBindTexture(GL_TEXTURE_2D, h.color);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, SIZE, SIZE, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
        glBindTexture(GL_TEXTURE_2D, 0);
        check_blending(&h, grey_room, "light", false, true);
        check_blending(&h, grey_room, "light, blend colour", true, true);
        harness_close(&h);
    }
}

/* ---- multisampled targets ---- */

/* A pixel of the resolved target is the average of the two by two of a picture twice as large. */
static void check_multisampled(int version, bool es) {
    harness h;
    GLuint framebuffer, buffers[2];
    test_scene s;
    GLint samples = 0;
    harness_open(&h, version, es, NULL);
    glGetIntegerv(GL_MAX_SAMPLES, &samples);
    if (samples < 4) { /* softpipe */
        harness_close(&h);
        printf("    no four samples: not tested\n");
        return;
    }
    open_scene(&s, intersecting, 2 * SIZE);
    harness_target(&h, 2 * SIZE, 2 * SIZE);
    harness_clear(&h, s.scene.background, 1.0f);
    harness_draw(&h, &s.scene, s.objects, s.count, NULL, other);
    harness_target(&h, SIZE, SIZE);
    s.scene.width = s.scene.height = SIZE;
    GLuint resolved = h.framebuffer;
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(2, buffers);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    for (int i = 0; i < 2; ++i) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, i ? GL_DEPTH_COMPONENT24 : GL_RGBA8, SIZE, SIZE);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, i ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  buffers[i]);
    }
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    h.framebuffer = framebuffer;
    harness_clear(&h, s.scene.background, 1.0f);
    harness_draw(&h, &s.scene, s.objects, s.count, NULL, NULL);
    assert_int_equal(tr_get_info(h.tr).plan->supersample, 2);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved);
    glBlitFramebuffer(0, 0, SIZE, SIZE, 0, 0, SIZE, SIZE, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, resolved);
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, picture);
    for (int y = 0; y < SIZE; ++y)
        for (int x = 0; x < SIZE; ++x)
            for (int k = 0; k < 3; ++k) {
                const unsigned char *q = other + 4 * (2 * y * 2 * SIZE + 2 * x) + k;
                int sum = q[0] + q[4] + q[8 * SIZE] + q[8 * SIZE + 4];
                assert_true(abs(4 * picture[4 * (y * SIZE + x) + k] - sum) <= 8);
            }
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(2, buffers);
    h.framebuffer = resolved;
    drop_scene(&s);
    harness_close(&h);
}

static void test_multisampled_targets(void **state) {
    (void)state;
    for (int i = 0; i < CONTEXTS; ++i)
        check_multisampled(contexts[i].version, contexts[i].es);
}

static int texels;
static void ask_for_texels(tr_frame *frame) {
    frame->wishes.supersample = (uint32_t)texels;
}

/* Single-sampled targets, any number of texels: the average of a picture as many times larger. */
static void test_supersampling(void **state) {
    harness_options options = {0, 0, NULL, NULL, NULL, NULL, 0, ask_for_texels};
    harness h;
    (void)state;
    harness_open(&h, 450, false, NULL);
    for (texels = 1; texels <= TR_MAX_SUPERSAMPLE; ++texels) {
        test_scene s;
        int small = 40, wide = small * texels;
        open_scene(&s, intersecting, wide);
        harness_target(&h, wide, wide);
        harness_clear(&h, s.scene.background, 1.0f);
        harness_draw(&h, &s.scene, s.objects, s.count, NULL, other);
        harness_target(&h, small, small);
        s.scene.width = s.scene.height = small;
        harness_clear(&h, s.scene.background, 1.0f);
        harness_draw(&h, &s.scene, s.objects, s.count, &options, picture);
        for (int i = 0; i < small * small * 4; ++i) {
            int x = i / 4 % small, y = i / 4 / small, sum = 0;
            for (int k = 0; k < texels * texels; ++k)
                sum += other[4 * ((y * texels + k / texels) * wide + x * texels + k % texels) + i % 4];
            assert_true(i % 4 == 3 || abs(texels * texels * picture[i] - sum) <= 2 * texels * texels);
        }
        drop_scene(&s);
    }
    harness_close(&h);
}

/* ---- lines ---- */

typedef struct line_vertex {
    float x, y, depth, slack, center_x, center_y;
} line_vertex;

static GLuint line_array, line_buffer;

/* A square patch of a line about a point of the window. */
static void upload_patch(const double window[3], float half) {
    line_vertex v[6];
    for (int i = 0; i < 6; ++i) {
        bool right = i == 1 || i == 2 || i == 4, top = i == 2 || i == 4 || i == 5;
        v[i].center_x = (float)window[0];
        v[i].center_y = (float)window[1];
        v[i].x = v[i].center_x + (right ? half : -half);
        v[i].y = v[i].center_y + (top ? half : -half);
        v[i].depth = (float)window[2];
        v[i].slack = 0.0005f; /* 0.01 of the scenes' units */
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

static float shift;
static tr_frame inks; /* colours and tolerance of lines */

/* Draws the scene with the patch as a line of one object, for the lines asked for; picture holds it. */
static void draw_with_patch(harness *h, const test_scene *s, uint32_t owner, uint32_t lines) {
    tr_frame frame = harness_frame(h, &s->scene, s->objects, s->count);
    tr_pass pass;
    frame.wishes.lines = lines;
    frame.outline_color[0] = frame.outline_color[2] = 1.0f;
    frame.jitter[1] = shift;
    memcpy(frame.crease_color, inks.crease_color, sizeof frame.crease_color);
    frame.black_creases = inks.black_creases;
    frame.line_tolerance = inks.line_tolerance;
    harness_clear(h, s->scene.background, 1.0f);
    assert_int_equal(tr_begin(h->tr, &frame), TR_OK);
    while (tr_next_pass(h->tr, &pass))
        for (size_t i = 0; i < s->count; ++i) {
            tr_material material;
            if (!tr_pass_draws(&pass, &s->objects[i].object) || (pass.lines && s->truths[i].id != owner))
                continue;
            if (pass.lines) {
                glBindVertexArray(line_array);
                glDrawArrays(GL_TRIANGLES, 0, 6);
                continue;
            }
            harness_material(&s->scene, &s->truths[i], &material);
            material.object = tr_object_code(&s->objects[i].object, &frame.wishes);
            tr_set_material(h->tr, &pass, &material);
            glBindVertexArray(s->objects[i].array);
            glDrawElements(GL_TRIANGLES, (GLsizei)(3 * s->truths[i].triangle_count), GL_UNSIGNED_INT, NULL);
        }
    glBindVertexArray(0);
    assert_int_equal(tr_end(h->tr), TR_OK);
    glReadPixels(0, 0, s->scene.width, s->scene.height, GL_RGBA, GL_UNSIGNED_BYTE, picture);
}

static void open_lines(harness *h, int size) {
    harness_open(h, 450, false, NULL);
    harness_target(h, size, size);
    glGenVertexArrays(1, &line_array);
    glGenBuffers(1, &line_buffer);
}

static void close_lines(harness *h) {
    glDeleteVertexArrays(1, &line_array);
    glDeleteBuffers(1, &line_buffer);
    harness_close(h);
}

static void to_window(const ref_scene *view, const double p[3], double out[3]) {
    double m[16], clip[4];
    harness_multiply(view->projection, view->view, m);
    for (int r = 0; r < 4; ++r)
        clip[r] = m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r];
    for (int k = 0; k < 3; ++k)
        out[k] = (clip[k] / clip[3] * 0.5 + 0.5) * (k < 2 ? view->width : 1);
}

/* 2: ink, 1: ink behind glass, 0: none; all colours of the scenes are without the ink's red and blue. */
static int ink_at(const ref_scene *view, const double window[3]) {
    const unsigned char *p = picture + 4 * ((int)window[1] * view->width + (int)window[0]);
    return p[0] > 250 ? 2 : p[0] > 60 ? 1 : 0;
}

/* Where a point of an edge is drawn as an outline, behind glass or not, and where as a phantom line: exactly one. */
static int check_line(harness *h, test_scene *s, const probe_line *line, int method, const char *name, int index) {
    const probe_line_class given = method ? line->by_explicit : line->by_default;
    const probe_line_class expected = given != PROBE_LINE_UNSTATED ? given : line->line;
    bool transparent = false;
    double window[3];
    for (size_t i = 0; i < s->count; ++i)
        transparent = transparent || (s->truths[i].id == line->object && s->truths[i].transparent);
    s->scene.interior = method ? REF_INTERIOR_EXPLICIT : REF_INTERIOR_IMPLICIT;
    to_window(&s->scene, line->point, window);
    upload_patch(window, 3);
    draw_with_patch(h, s, line->object, TR_LINES_OUTLINES);
    int outline = ink_at(&s->scene, window);
    draw_with_patch(h, s, line->object, TR_LINES_HIDDEN);
    int phantom = ink_at(&s->scene, window);
    /* Of glass nothing shines through: what lies behind a front is hidden, and a phantom line. */
    int wanted = expected == PROBE_LINE_VISIBLE ? 2 : expected == PROBE_LINE_THROUGH && !transparent ? 1 : 0;
    if (outline != wanted || phantom != (wanted ? 0 : 2))
        fail_msg("%s, line %d of object %u, method %d: outline %d, phantom %d, should be %d", name, index, line->object,
                 method, outline, phantom, wanted);
    return 1;
}

static void test_probes_of_lines(void **state) {
    harness h;
    int checked = 0;
    (void)state;
    open_lines(&h, 2 * SIZE);
    for (size_t i = 0; i < PROBE_COUNT(probe_line_scenes); ++i) {
        const probe_line_scene *p = &probe_line_scenes[i];
        test_scene s;
        init_scene(&s, 2 * SIZE);
        s.scene.blending = REF_BLEND_OVER;
        memset(s.scene.background, 0, sizeof s.scene.background);
        for (int o = 0; o < p->object_count; ++o)
            add_probe_object(&s, &p->objects[o]);
        for (size_t o = 0; o < s.count; ++o)
            s.truths[o].color[0] = s.truths[o].color[2] = 0;
        set_probe_camera(&s, &p->camera);
        finish_scene(&s);
        for (int q = 0; q < p->probe_count; ++q)
            for (int method = 0; method < 2; ++method)
                checked += check_line(&h, &s, &p->probes[q], method, p->name, q);
        drop_scene(&s);
    }
    printf("    %d probes\n", checked);
    assert_true(checked >= 20);
    close_lines(&h);
}

/* Wide outlines: only outside of all surfaces, Gooch's stencil bit without a stencil. */
static void test_outer_lines_lie_outside(void **state) {
    harness h;
    test_scene s;
    const double middle[3] = {SIZE, SIZE, 0.1};
    size_t inside = 0, outside = 0;
    (void)state;
    open_lines(&h, 2 * SIZE);
    open_scene(&s, shells, 2 * SIZE);
    memset(s.scene.background, 0, sizeof s.scene.background);
    for (size_t o = 0; o < s.count; ++o)
        s.truths[o].color[0] = 0, s.truths[o].color[1] = 0.5, s.truths[o].alpha = 0.5;
    assert_true(ref_render(&s.scene, truth));
    upload_patch(middle, SIZE);
    draw_with_patch(&h, &s, 1, TR_LINES_OUTER);
    for (size_t i = 0; i < 4 * SIZE * SIZE; ++i) {
        bool surface = truth[i].front_object || truth[i].opaque_object, ink = picture[4 * i] > 250;
        if (truth[i].left_out)
            continue;
        assert_int_equal(ink, !surface);
        ++*(surface ? &inside : &outside);
    }
    assert_true(inside > 5000 && outside > 5000);
    drop_scene(&s);
    close_lines(&h);
}

/* Sub-pixel jitter: lines go with the surfaces, which the host's own projection has shifted. */
static void test_jitter_shifts_lines(void **state) {
    harness h;
    test_scene s;
    const double low[3] = {SIZE, 20.5, 0.1}, high[3] = {SIZE, 23.5, 0.1};
    (void)state;
    open_lines(&h, 2 * SIZE);
    open_scene(&s, shells, 2 * SIZE);
    upload_patch(high, 6);
    draw_with_patch(&h, &s, 1, TR_LINES_OUTLINES);
    memcpy(other, picture, sizeof other);
    upload_patch(low, 6);
    draw_with_patch(&h, &s, 1, TR_LINES_OUTLINES);
    assert_int_not_equal(memcmp(picture, other, sizeof other), 0);
    shift = 3.0f;
    draw_with_patch(&h, &s, 1, TR_LINES_OUTLINES);
    assert_memory_equal(picture, other, sizeof other);
    shift = 0.0f;
    drop_scene(&s);
    close_lines(&h);
}

static void expect_ink(int red, int green, int blue) {
    const unsigned char *p = picture + 4 * (2 * SIZE * 20 + SIZE);
    if (p[0] != red || p[1] != green || p[2] != blue)
        fail_msg("ink is %d %d %d, should be %d %d %d", p[0], p[1], p[2], red, green, blue);
}

/* White, as Gooch's creases are, unless a colour is given, or black asked for by name. */
static void test_creases_have_their_colour(void **state) {
    harness h;
    test_scene s;
    const double place[3] = {SIZE, 20.5, 0.1};
    (void)state;
    open_lines(&h, 2 * SIZE);
    open_scene(&s, shells, 2 * SIZE);
    upload_patch(place, 6);
    draw_with_patch(&h, &s, 1, TR_LINES_CREASES);
    expect_ink(255, 255, 255);
    inks.black_creases = 1;
    draw_with_patch(&h, &s, 1, TR_LINES_CREASES);
    expect_ink(0, 0, 0);
    inks.black_creases = 0;
    inks.crease_color[1] = 1.0f;
    draw_with_patch(&h, &s, 1, TR_LINES_CREASES);
    expect_ink(0, 255, 0);
    memset(&inks, 0, sizeof inks);
    drop_scene(&s);
    close_lines(&h);
}

/* A line that lies behind a surface by three times its slack: hidden by the default tolerance of two, shown by four. */
static void test_tolerance_of_lines(void **state) {
    harness h;
    test_scene s;
    double place[3] = {SIZE, SIZE, 0};
    GLfloat depth;
    (void)state;
    open_lines(&h, 2 * SIZE);
    open_scene(&s, shells, 2 * SIZE);
    memset(s.scene.background, 0, sizeof s.scene.background);
    for (size_t o = 0; o < s.count; ++o)
        s.truths[o].color[0] = s.truths[o].color[2] = 0;
    draw_with_patch(&h, &s, 0, 0);
    glReadPixels(SIZE, SIZE, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    assert_true(depth < 1);
    place[2] = (double)depth + 3 * 0.0005;
    upload_patch(place, 1);
    draw_with_patch(&h, &s, 1, TR_LINES_OUTLINES);
    assert_int_equal(ink_at(&s.scene, place), 0);
    inks.line_tolerance = 4;
    draw_with_patch(&h, &s, 1, TR_LINES_OUTLINES);
    assert_int_equal(ink_at(&s.scene, place), 2);
    memset(&inks, 0, sizeof inks);
    drop_scene(&s);
    close_lines(&h);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_layers_on_older_contexts),
        cmocka_unit_test(test_layers_with_reversed_depth),
        cmocka_unit_test(test_clip_depth_from_zero),
        cmocka_unit_test(test_blend_colour_stands_for_the_background),
        cmocka_unit_test(test_light_is_blended),
        cmocka_unit_test(test_multisampled_targets),
        cmocka_unit_test(test_supersampling),
        cmocka_unit_test(test_probes_of_lines),
        cmocka_unit_test(test_outer_lines_lie_outside),
        cmocka_unit_test(test_jitter_shifts_lines),
        cmocka_unit_test(test_creases_have_their_colour),
        cmocka_unit_test(test_tolerance_of_lines),
    };
    return cmocka_run_group_tests_name("gl_targets", tests, NULL, NULL);
}

/* gl_integration.c: transparency.h in the habits of engines: sRGB targets, jitter, clip control, pictures upside down, a
 * chosen draw buffer, the middle of a frame, several contexts at once, changing sizes; and on drivers that have no more
 * than GL 3.3 or ES 3.0, which are run as programs of their own:
 *
 *     gl_integration --picture FILE VERSION ES     the scene's bytes on a context of that version (330; ES is 0 or 1) */
#include "gl_harness.h"

#include <sys/wait.h>

/* ---- the scene: an opaque box in glass, glass behind, and an opaque box behind both ---- */

static const float corners[24] = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1};
static const uint32_t outward[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                     2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

enum { SIZE = 96, BOXES = 4, BYTES = SIZE * SIZE * 4 };
static ref_object truths[BOXES];
static harness_object boxes[BOXES];
static const double grey[3] = {0.5, 0.5, 0.5};
static unsigned char plain[BYTES], picture[BYTES];

static ref_scene make_scene(int width, int height) {
    static const double sizes[BOXES] = {0.9, 0.4, 0.6, 0.4};
    static const double shifts[BOXES][3] = {{0, 0, 0}, {0.1, 0, 0.2}, {0.6, 0.3, -2}, {-0.2, -0.3, -3}};
    /* Turned a little; orthographic, looking down -z from z = 5 to z = -5. */
    static const double view[16] = {0.96, 0.1, -0.25, 0, 0, 0.93, 0.36, 0, 0.27, -0.34, 0.9, 0, 0, 0, 0, 1};
    static const double projection[16] = {0.7, 0, 0, 0, 0, 0.7, 0, 0, 0, 0, -0.2, 0, 0, 0, 0, 1};
    ref_scene scene;
    memset(&scene, 0, sizeof scene);
    memset(truths, 0, sizeof truths);
    for (int i = 0; i < BOXES; ++i) {
        for (int k = 0; k < 3; ++k) {
            truths[i].model[5 * k] = sizes[i];
            truths[i].model[12 + k] = shifts[i][k];
            truths[i].color[k] = k == i % 3 ? 0.8 : 0.1;
        }
        truths[i].model[15] = 1;
        truths[i].positions = corners;
        truths[i].indices = outward;
        truths[i].vertex_count = 8;
        truths[i].triangle_count = 12;
        truths[i].id = (uint32_t)(i + 1);
        truths[i].transparent = i % 2 == 0;
        truths[i].alpha = 0.5;
    }
    memcpy(scene.view, view, sizeof view);
    memcpy(scene.projection, projection, sizeof projection);
    memcpy(scene.background, grey, sizeof grey);
    scene.width = width;
    scene.height = height;
    scene.opaque_weight = 0.7;
    scene.background_weight = 0.4;
    scene.blending = REF_BLEND_NORMALISED;
    scene.objects = truths;
    scene.object_count = BOXES;
    return scene;
}

/* Objects belong to a context, so that each context has its own. */
static void upload(harness_object *objects) {
    memset(objects, 0, BOXES * sizeof *objects);
    for (int i = 0; i < BOXES; ++i) {
        objects[i].truth = truths[i];
        harness_upload(&objects[i], NULL);
    }
}

static void drop(harness_object *objects) {
    for (int i = 0; i < BOXES; ++i)
        harness_drop_object(&objects[i]);
}

/* A context, the scene in it and a target of that size. */
static ref_scene open_scene(harness *h, int version, bool es, const tr_desc *desc, int width, int height) {
    ref_scene scene = make_scene(width, height);
    harness_open(h, version, es, desc);
    upload(boxes);
    harness_target(h, width, height);
    harness_clear(h, grey, desc && desc->reversed_z ? 0.0f : 1.0f);
    return scene;
}

static void close_scene(harness *h) {
    drop(boxes);
    harness_close(h);
}

static int differing_pixels(const unsigned char *a, const unsigned char *b, size_t pixels, int most) {
    int count = 0;
    for (size_t i = 0; i < pixels; ++i) {
        bool differs = false;
        for (size_t k = 0; k < 4; ++k)
            differs = differs || abs(a[4 * i + k] - b[4 * i + k]) > most;
        count += differs;
    }
    return count;
}

/* The picture that what follows is to repeat, itself held to the reference. */
static int draw_plain(void **state) {
    static ref_pixel truth[SIZE * SIZE];
    harness h;
    (void)state;
    ref_scene scene = open_scene(&h, 450, false, NULL, SIZE, SIZE);
    harness_draw(&h, &scene, boxes, BOXES, NULL, plain);
    assert_true(ref_render(&scene, truth));
    harness_check(&h, "boxes", &scene, truth, plain);
    close_scene(&h);
    return 0;
}

/* ---- sRGB targets ---- */

static double srgb_encode(double x) {
    return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055;
}

static double srgb_decode(double x) {
    return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

static void srgb_target(harness *h) {
    glBindTexture(GL_TEXTURE_2D, h->color);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, h->width, h->height, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glBindTexture(GL_TEXTURE_2D, 0);
}

/* With GL_FRAMEBUFFER_SRGB, and always in ES, colours are linear, blending too, and are encoded as they are stored. The
 * layers in between have 8 linear bits: half a step each of opaque and transparent colour and of alpha, which weighs a
 * contrast of at most 0.7; 1.5/255 of linear light in all, and half a step of the target's own rounding. */
static void check_linear_light(int version, bool es) {
    static ref_pixel truth[SIZE * SIZE];
    harness h;
    double worst = 0;
    ref_scene scene = open_scene(&h, version, es, NULL, SIZE, SIZE);
    srgb_target(&h);
    if (!es)
        glEnable(GL_FRAMEBUFFER_SRGB);
    harness_clear(&h, grey, 1.0f);
    harness_draw(&h, &scene, boxes, BOXES, NULL, picture);
    if (!es)
        assert_true(glIsEnabled(GL_FRAMEBUFFER_SRGB));
    for (int k = 0; k < 3; ++k) /* what the clear stored, and blending reads back */
        scene.background[k] = srgb_decode(188 / 255.0);
    assert_true(ref_render(&scene, truth));
    for (size_t i = 0; i < SIZE * SIZE; ++i)
        for (size_t c = 0; c < 3 && !truth[i].left_out; ++c) {
            double linear = truth[i].color[c], step = 1.5 / 255;
            double low = srgb_encode(fmax(linear - step, 0)) * 255 - 0.51,
                   high = srgb_encode(linear + step) * 255 + 0.51;
            double off = fabs(picture[4 * i + c] - srgb_encode(linear) * 255);
            if (picture[4 * i + c] < low || picture[4 * i + c] > high)
                fail_msg("pixel %zu channel %zu is %d, should lie in %.1f to %.1f", i, c, picture[4 * i + c], low,
                         high);
            worst = fmax(worst, off);
        }
    printf("    sRGB target, %s %d: %.2f/255 at most\n", es ? "ES" : "GL", version, worst);
    close_scene(&h);
}

static void test_srgb_targets_are_blended_in_linear_light(void **state) {
    (void)state;
    check_linear_light(450, false);
    check_linear_light(330, false);
    check_linear_light(300, true);
}

/* Without the switch the bytes are stored as they come: the same as into a target that is not sRGB. */
static void test_srgb_targets_without_the_switch(void **state) {
    harness h;
    (void)state;
    ref_scene scene = open_scene(&h, 450, false, NULL, SIZE, SIZE);
    srgb_target(&h);
    harness_clear(&h, grey, 1.0f);
    harness_draw(&h, &scene, boxes, BOXES, NULL, picture);
    assert_int_equal(differing_pixels(plain, picture, SIZE * SIZE, 0), 0);
    close_scene(&h);
}

/* ---- jitter ---- */

/* In clip space, by parts of a pixel to the right and up. */
static void jitter(ref_scene *scene, double x, double y) {
    for (int column = 0; column < 4; ++column) {
        scene->projection[4 * column] += 2 * x / scene->width * scene->projection[4 * column + 3];
        scene->projection[4 * column + 1] += 2 * y / scene->height * scene->projection[4 * column + 3];
    }
}

static size_t plan_text(const harness *h, char text[4096]) {
    return tr_plan_print(tr_get_info(h->tr).plan, text, 4096);
}

/* Each jittered picture is the reference's, of the same jitter; plan and bytes are those without. */
static void test_jitter_moves_the_picture_alone(void **state) {
    static const double offsets[5][2] = {{0, 0}, {0.25, -0.375}, {-0.4375, 0.125}, {0.5, 0.5}, {-1.0 / 3, 0.45}};
    static ref_pixel truth[SIZE * SIZE];
    char first[4096], text[4096];
    harness h;
    (void)state;
    ref_scene still = open_scene(&h, 450, false, NULL, SIZE, SIZE);
    for (int i = 0; i < 5; ++i) {
        ref_scene scene = still;
        jitter(&scene, offsets[i][0], offsets[i][1]);
        harness_clear(&h, grey, 1.0f);
        harness_draw(&h, &scene, boxes, BOXES, NULL, picture);
        assert_true(ref_render(&scene, truth));
        harness_check(&h, i ? "jittered" : "still", &scene, truth, picture);
        plan_text(&h, i ? text : first);
        if (i)
            assert_string_equal(text, first);
        assert_int_equal(differing_pixels(plain, picture, SIZE * SIZE, 0) > 0, i > 0);
    }
    close_scene(&h);
}

/* The four pictures whose samples lie at a quarter of a pixel are the four samples of a picture twice as fine. */
static void test_jittered_pictures_interleave(void **state) {
    static unsigned char fine[4 * BYTES], woven[4 * BYTES];
    harness h;
    (void)state;
    ref_scene scene = open_scene(&h, 450, false, NULL, 2 * SIZE, 2 * SIZE);
    harness_draw(&h, &scene, boxes, BOXES, NULL, fine);
    harness_target(&h, SIZE, SIZE);
    for (size_t sample = 0; sample < 4; ++sample) {
        size_t right = sample % 2, up = sample / 2;
        scene = make_scene(SIZE, SIZE);
        jitter(&scene, right ? -0.25 : 0.25, up ? -0.25 : 0.25); /* the scene goes left, so the sample lies right */
        harness_clear(&h, grey, 1.0f);
        harness_draw(&h, &scene, boxes, BOXES, NULL, picture);
        for (size_t y = 0; y < SIZE; ++y)
            for (size_t x = 0; x < SIZE; ++x)
                memcpy(woven + 4 * ((2 * y + up) * 2 * SIZE + 2 * x + right), picture + 4 * (y * SIZE + x), 4);
    }
    int differing = differing_pixels(fine, woven, 4 * SIZE * SIZE, 1);
    printf("    woven of four jittered pictures: %d of %d pixels differ by more than 1/255\n", differing,
           4 * SIZE * SIZE);
    assert_true(differing <= 8); /* edges on the very centre of a sample: positions are rounded to parts of a pixel */
    close_scene(&h);
}

/* ---- clip control, pictures upside down ---- */

/* Depths to [0,1] in clip space, near at 0 or, reversed, at 1. */
static void halve_depths(ref_scene *scene, bool reversed) {
    for (int column = 0; column < 4; ++column) {
        double *z = &scene->projection[4 * column + 2], w = scene->projection[4 * column + 3];
        *z = 0.5 * (w + (reversed ? -*z : *z));
    }
}

static void check_zero_to_one(bool reversed) {
    tr_desc desc = {0};
    harness h;
    desc.reversed_z = reversed;
    ref_scene scene = open_scene(&h, 450, false, &desc, SIZE, SIZE);
    if (!glClipControl) {
        printf("    no clip control here: skipped\n");
        close_scene(&h);
        return;
    }
    halve_depths(&scene, reversed);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    harness_draw(&h, &scene, boxes, BOXES, NULL, picture);
    GLint mode = 0;
    glGetIntegerv(GL_CLIP_DEPTH_MODE, &mode);
    assert_int_equal(mode, GL_ZERO_TO_ONE);
    assert_int_equal(differing_pixels(plain, picture, SIZE * SIZE, 0), 0);
    close_scene(&h);
}

static void test_clip_depths_from_zero_to_one(void **state) {
    (void)state;
    check_zero_to_one(false);
    check_zero_to_one(true);
}

static int differing_from_flipped(void) {
    int count = 0;
    for (size_t y = 0; y < SIZE; ++y)
        count += differing_pixels(plain + 4 * SIZE * y, picture + 4 * SIZE * (SIZE - 1 - y), SIZE, 0);
    return count;
}

/* By the projection, which turns windings round, as hosts do that draw into textures for another API. */
static void test_upside_down_by_projection(void **state) {
    tr_desc desc = {0};
    harness h;
    (void)state;
    desc.front_face_cw = 1;
    ref_scene scene = open_scene(&h, 450, false, &desc, SIZE, SIZE);
    for (int column = 0; column < 4; ++column)
        scene.projection[4 * column + 1] *= -1;
    harness_draw(&h, &scene, boxes, BOXES, NULL, picture);
    assert_int_equal(differing_from_flipped(), 0);
    close_scene(&h);
}

/* By clip control, which keeps windings. */
static void test_upside_down_by_clip_control(void **state) {
    harness h;
    (void)state;
    ref_scene scene = open_scene(&h, 450, false, NULL, SIZE, SIZE);
    if (glClipControl) {
        glClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
        harness_draw(&h, &scene, boxes, BOXES, NULL, picture);
        assert_int_equal(differing_from_flipped(), 0);
    }
    close_scene(&h);
}

/* ---- in the middle of a host's frame ---- */

static GLuint link_host_program(void) {
    static const char *const texts[2] = {"#version 330 core\n"
                                         "void main() {\n"
                                         "    vec2 at = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;\n"
                                         "    gl_Position = vec4(at, 0, 1);\n"
                                         "}\n",
                                         "#version 330 core\n"
                                         "layout(location = 0) out vec4 color;\n"
                                         "void main() { color = vec4(0, 0.2, 0, 0); }\n"};
    GLuint program = glCreateProgram();
    GLint ok = 0;
    for (int i = 0; i < 2; ++i) {
        GLuint shader = glCreateShader(i ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER);
        glShaderSource(shader, 1, &texts[i], NULL);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    assert_true(ok);
    return program;
}

/* The host has set what it wants once, draws, lets the header draw, and draws again without setting anything: a fifth
 * more green in a part of its own framebuffer, both times. */
static void check_middle_of_a_frame(int version) {
    static unsigned char before[BYTES], between[BYTES], after[BYTES];
    harness h;
    GLuint array;
    ref_scene scene = open_scene(&h, version, false, NULL, SIZE, SIZE);
    GLuint program = link_host_program();
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glUseProgram(program);
    glViewport(3, 5, 30, 70); /* which the scissor reaches beyond */
    glEnable(GL_SCISSOR_TEST);
    glScissor(10, 20, 30, 40);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDepthMask(GL_FALSE);
    for (int k = 0; k < 2; ++k) {
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, k ? after : before);
        if (k == 0) {
            harness_draw(&h, &scene, boxes, BOXES, NULL, between);
            glBindVertexArray(array); /* harness_draw ends its own drawing with none bound before it calls tr_end */
        }
    }
    for (int i = 0; i < SIZE * SIZE; ++i) {
        int x = i % SIZE, y = i / SIZE;
        bool inside = x >= 10 && x < 33 && y >= 20 && y < 60;
        int green = between[4 * i + 1] + (inside ? 51 : 0), most = inside; /* drivers round sums either way */
        green = green < 255 ? green : 255;
        assert_in_range(before[4 * i + 1], inside ? 178 : 128, inside ? 179 : 128);
        assert_true(inside || memcmp(between + 4 * i, plain + 4 * i, 4) == 0);
        assert_int_equal(after[4 * i], between[4 * i]);
        assert_true(abs(after[4 * i + 1] - green) <= most);
        assert_int_equal(after[4 * i + 2], between[4 * i + 2]);
    }
    assert_true(differing_pixels(before, between, SIZE * SIZE, 0) > 500);
    glDeleteProgram(program);
    glDeleteVertexArrays(1, &array);
    close_scene(&h);
}

static void test_middle_of_a_frame(void **state) {
    (void)state;
    check_middle_of_a_frame(450);
    check_middle_of_a_frame(330);
}

/* The second attachment is the first draw buffer; the first attachment, another draw buffer, keeps its red. */
static void test_first_draw_buffer_is_drawn_into(void **state) {
    static const GLenum swapped[2] = {GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT0};
    static const float red[4] = {1, 0, 0, 1}, middle[4] = {0.5f, 0.5f, 0.5f, 1};
    harness h;
    GLuint other;
    (void)state;
    ref_scene scene = open_scene(&h, 450, false, NULL, SIZE, SIZE);
    glGenTextures(1, &other);
    glBindTexture(GL_TEXTURE_2D, other);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, SIZE, SIZE, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glBindTexture(GL_TEXTURE_2D, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, other, 0);
    glDrawBuffers(2, swapped);
    glClearBufferfv(GL_COLOR, 0, middle);
    glClearBufferfv(GL_COLOR, 1, red);
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    harness_draw(&h, &scene, boxes, BOXES, NULL, picture);
    assert_int_equal(differing_pixels(plain, picture, SIZE * SIZE, 0), 0);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, picture);
    for (int i = 0; i < SIZE * SIZE; ++i)
        assert_true(picture[4 * i] == 255 && picture[4 * i + 1] == 0 && picture[4 * i + 2] == 0);
    glDeleteTextures(1, &other);
    close_scene(&h);
}

/* ---- several contexts ---- */

enum { CONTEXTS = 3 };

static void make_current(const harness *h) {
    EGLSurface surface = h->context.surface ? h->context.surface : EGL_NO_SURFACE;
    eglBindAPI(h->context.es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
    assert_true(eglMakeCurrent(h->context.display, surface, surface, h->context.context));
}

static void draw_pass(harness *h, const tr_pass *pass, const ref_scene *scene, const harness_object *objects) {
    for (int i = 0; i < BOXES; ++i) {
        tr_material material;
        if (!tr_pass_draws(pass, &objects[i].object))
            continue;
        harness_material(scene, &truths[i], &material);
        tr_set_material(h->tr, pass, &material);
        glBindVertexArray(objects[i].array);
        glDrawElements(GL_TRIANGLES, 36, GL_UNSIGNED_INT, NULL);
    }
}

/* Every context is in the middle of a sequence while the others go on with theirs, pass by pass. */
static void interleave(harness *all, harness_object objects[CONTEXTS][BOXES], const ref_scene *scene) {
    bool busy[CONTEXTS] = {true, true, true};
    for (int c = 0; c < CONTEXTS; ++c) {
        tr_frame frame = harness_frame(&all[c], scene, objects[c], BOXES);
        make_current(&all[c]);
        harness_clear(&all[c], grey, 1.0f);
        assert_int_equal(tr_begin(all[c].tr, &frame), TR_OK);
    }
    while (busy[0] || busy[1] || busy[2])
        for (int c = 0; c < CONTEXTS; ++c) {
            tr_pass pass;
            make_current(&all[c]);
            if (busy[c] && tr_next_pass(all[c].tr, &pass)) {
                draw_pass(&all[c], &pass, scene, objects[c]);
            } else if (busy[c]) {
                assert_int_equal(tr_end(all[c].tr), TR_OK);
                busy[c] = false;
            }
        }
}

static void test_contexts_interleaved(void **state) {
    static const int versions[CONTEXTS] = {450, 330, 300};
    harness all[CONTEXTS];
    harness_object objects[CONTEXTS][BOXES];
    ref_scene scene = make_scene(SIZE, SIZE);
    (void)state;
    for (int c = 0; c < CONTEXTS; ++c) {
        harness_open(&all[c], versions[c], versions[c] == 300, NULL);
        harness_target(&all[c], SIZE, SIZE);
        upload(objects[c]);
    }
    for (int frame = 0; frame < 2; ++frame)
        interleave(all, objects, &scene);
    for (int c = 0; c < CONTEXTS; ++c) {
        make_current(&all[c]);
        glBindFramebuffer(GL_FRAMEBUFFER, all[c].framebuffer);
        glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, picture);
        assert_int_equal(differing_pixels(plain, picture, SIZE * SIZE, versions[c] == 300 ? 1 : 0), 0);
        assert_int_equal(tr_get_info(all[c].tr).version, harness_version(versions[c], versions[c] == 300));
        drop(objects[c]);
        tr_destroy(all[c].tr);
        harness_drop_target(&all[c]);
        assert_int_equal(glGetError(), GL_NO_ERROR);
        assert_int_equal(all[c].debug_messages, 0);
    }
    /* They share a display, which goes with the first that is closed. */
    for (int c = 0; c < CONTEXTS; ++c)
        headless_destroy(&all[c].context);
}

/* ---- sizes ---- */

/* How many of the first names are textures, framebuffers and buffers. */
static int live_objects(void) {
    int count = 0;
    for (GLuint name = 1; name < 4096; ++name)
        count += glIsTexture(name) + glIsFramebuffer(name) + glIsBuffer(name);
    return count;
}

static void test_resize_storm(void **state) {
    static ref_pixel truth[64 * 64];
    static unsigned char small[64 * 64 * 4];
    uint32_t seed = 1;
    int sides[2] = {0, 0};
    harness h;
    (void)state;
    ref_scene scene = open_scene(&h, 450, false, NULL, SIZE, SIZE);
    harness_draw(&h, &scene, boxes, BOXES, NULL, picture);
    int before = live_objects();
    double worst = 0;
    for (int i = 0; i < 60; ++i) {
        for (int k = 0; k < 2; ++k) {
            seed = seed * 1664525u + 1013904223u;
            if (i % 3 == 0 || i % 3 == k + 1) /* both sides change, or one of them */
                sides[k] = i % 10 == 9 ? 0 : (int)((seed >> 16) % 64u);
        }
        scene = make_scene(sides[0], sides[1]);
        harness_clear(&h, grey, 1.0f);
        harness_draw(&h, &scene, boxes, BOXES, NULL, small);
        tr_info info = tr_get_info(h.tr);
        if (sides[0] == 0 || sides[1] == 0) {
            assert_int_equal(info.plan->pass_count, 0);
            continue;
        }
        assert_int_equal(info.bytes, (uint64_t)(sides[0] * sides[1]) * info.plan->bytes_per_pixel);
        assert_true(ref_render(&scene, truth));
        harness_error error = harness_compare(&scene, truth, small);
        worst = fmax(worst, error.max);
    }
    printf("    sixty sizes: %.2f/255 at most\n", worst);
    assert_true(worst <= 2);
    harness_clear(&h, grey, 1.0f);
    scene = make_scene(SIZE, SIZE);
    harness_draw(&h, &scene, boxes, BOXES, NULL, picture);
    assert_int_equal(differing_pixels(plain, picture, SIZE * SIZE, 0), 0);
    assert_int_equal(live_objects(), before);
    close_scene(&h);
}

/* A viewport of no area: no pass, no object is made, no pixel and no state is touched. */
static void test_no_size(void **state) {
    static const int sides[3][2] = {{0, 0}, {0, SIZE}, {SIZE, 0}};
    harness h;
    (void)state;
    open_scene(&h, 450, false, NULL, SIZE, SIZE);
    int before = live_objects();
    for (int i = 0; i < 3; ++i) {
        ref_scene scene = make_scene(sides[i][0], sides[i][1]);
        harness_options options = {0};
        glViewport(1, 2, 3, 4);
        harness_draw(&h, &scene, boxes, BOXES, &options, NULL);
        GLint viewport[4];
        glGetIntegerv(GL_VIEWPORT, viewport);
        assert_int_equal(viewport[3], 4);
        assert_int_equal(options.passes, 0);
        assert_int_equal(live_objects(), before);
    }
    glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, picture);
    for (int i = 0; i < SIZE * SIZE; ++i)
        assert_int_equal(picture[4 * i], 128);
    close_scene(&h);
}

/* ---- older drivers ---- */

static int write_picture(const char *path, int version, bool es) {
    harness h;
    ref_scene scene = open_scene(&h, version, es, NULL, SIZE, SIZE);
    harness_draw(&h, &scene, boxes, BOXES, NULL, picture);
    printf("    %s: %s, header sees %d\n", h.context.renderer, h.context.version, tr_get_info(h.tr).version);
    close_scene(&h);
    FILE *file = fopen(path, "wb");
    bool ok = file && fwrite(picture, 1, sizeof picture, file) == sizeof picture;
    return file && fclose(file) == 0 && ok ? 0 : 1;
}

static const char *self; /* this program */

/* Mesa reads its environment once, so that each of these drivers is a program of its own. The first has no more than
 * GL 3.3, the second no more than ES 3.0, in what they offer and in the shaders that they take; the others are a second
 * implementation. */
static void test_older_drivers_draw_the_same(void **state) {
    static const char *const drivers[][3] = {
        {"MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330", "330", "0"},
        {"MESA_GLES_VERSION_OVERRIDE=3.0", "300", "1"},
        {"GALLIUM_DRIVER=softpipe", "330", "0"},
        {"GALLIUM_DRIVER=softpipe MESA_GLES_VERSION_OVERRIDE=3.0", "300", "1"},
    };
    char path[1024], command[4096];
    (void)state;
    snprintf(path, sizeof path, "%s.picture", self);
    for (size_t i = 0; i < sizeof drivers / sizeof drivers[0]; ++i) {
        snprintf(command, sizeof command, "env LIBGL_ALWAYS_SOFTWARE=1 %s '%s' --picture %s %s %s", drivers[i][0], self,
                 path, drivers[i][1], drivers[i][2]);
        fflush(stdout);
        int status = system(command);
        assert_true(status != -1 && WIFEXITED(status));
        assert_int_equal(WEXITSTATUS(status), 0);
        FILE *file = fopen(path, "rb");
        assert_non_null(file);
        size_t read = fread(picture, 1, sizeof picture, file);
        fclose(file);
        remove(path);
        assert_int_equal(read, sizeof picture);
        assert_int_equal(differing_pixels(plain, picture, SIZE * SIZE, 1), 0);
    }
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_srgb_targets_are_blended_in_linear_light),
        cmocka_unit_test(test_srgb_targets_without_the_switch),
        cmocka_unit_test(test_jitter_moves_the_picture_alone),
        cmocka_unit_test(test_jittered_pictures_interleave),
        cmocka_unit_test(test_clip_depths_from_zero_to_one),
        cmocka_unit_test(test_upside_down_by_projection),
        cmocka_unit_test(test_upside_down_by_clip_control),
        cmocka_unit_test(test_middle_of_a_frame),
        cmocka_unit_test(test_first_draw_buffer_is_drawn_into),
        cmocka_unit_test(test_contexts_interleaved),
        cmocka_unit_test(test_resize_storm),
        cmocka_unit_test(test_no_size),
        cmocka_unit_test(test_older_drivers_draw_the_same),
    };
    self = argv[0];
    if (argc == 5 && strcmp(argv[1], "--picture") == 0)
        return write_picture(argv[2], atoi(argv[3]), atoi(argv[4]) != 0);
    return cmocka_run_group_tests_name("gl_integration", tests, draw_plain, NULL);
}

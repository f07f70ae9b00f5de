/* gl_oit_target.c: what oit_buffers.h composes with (alpha laws, colours) and into (sRGB, several draw buffers, pictures
 * upside down), held to formulas and rays in double. */
#include "oit_setting.h"

/* ---- alpha laws ---- */

static float *draw(oit_setting *t, oit_scene *s) {
    oit_frame frame = oit_scene_frame(s, t->framebuffer);
    oit_setting_clear(t, s);
    oit_scene_render(s, t->oit, &frame, NULL);
    return oit_setting_read(t, t->framebuffer);
}

/* Front to back by the paper's text: layers are those that are laid over, not opaque, and before what is. */
static void compose_adaptively(const oit_scene *s, size_t count, double color[3]) {
    static size_t order[OIT_SCENE_MAX];
    size_t layers = 0, seen = 0;
    double through[3] = {1, 1, 1};
    for (size_t i = 0; i < count; ++i) { /* sheets: by their depth */
        size_t at = i;
        for (; at > 0 && s->objects[i].positions[2] < s->objects[order[at - 1]].positions[2]; --at)
            order[at] = order[at - 1];
        order[at] = i;
    }
    for (; seen < count; ++seen) {
        const size_t i = order[seen];
        if (s->objects[i].blend != OIT_BLEND_OVER)
            continue;
        if (s->truths[i].alpha >= 1)
            break;
        layers += s->truths[i].alpha > 0;
    }
    for (int c = 0; c < 3; ++c)
        color[c] = 0;
    for (size_t k = 0; k < count; ++k) {
        const ref_object *o = &s->truths[order[k]];
        uint32_t blend = s->objects[order[k]].blend;
        double alpha = o->alpha;
        if (blend == OIT_BLEND_OVER && alpha < 1)
            alpha = 1 - pow(1 - alpha, 1.0 / (double)(layers ? layers : 1));
        for (int c = 0; c < 3; ++c) {
            if (blend != OIT_BLEND_MULTIPLY)
                color[c] += through[c] * alpha * o->color[c];
            if (blend != OIT_BLEND_ADD)
                through[c] *= 1 - alpha + (blend == OIT_BLEND_MULTIPLY ? alpha * o->color[c] : 0);
        }
    }
    for (int c = 0; c < 3; ++c)
        color[c] += through[c] * s->scene.background[c];
}

static double check_adaptive(oit_setting *t, oit_scene *s, const char *name, double tolerance) {
    double expected[3], worst = 0;
    float *got = draw(t, s);
    compose_adaptively(s, s->count, expected);
    for (int i = 0; i < t->width * t->height; ++i)
        for (int c = 0; c < 3; ++c)
            worst = fmax(worst, fabs((double)got[4 * i + c] - expected[c]));
    printf("    %-44s max %.2g (allowed %.2g)\n", name, worst, tolerance);
    if (!(worst <= tolerance))
        fail_msg("%s: %g %g %g, should be %g %g %g", name, (double)got[0], (double)got[1], (double)got[2], expected[0],
                 expected[1], expected[2]);
    free(got);
    return worst;
}

/* n layers of s hide as much as one: in each class of runs, up to 500 layers; among them such as are no layers. The bound:
 * each of n factors is rounded to 2^-24 in the same direction, 3e-5 for 500. */
static void test_adaptive_alpha(void **state) {
    static const int counts[] = {0, 1, 2, 3, 7, 8, 9, 20, 40, 64, 65, 130, 500};
    static const double opacities[] = {1e-4, 0.3, 0.8, 0.999};
    (void)state;
    for (int variant = 0; variant < 4; ++variant) {
        oit_desc desc = {.color = variant == 2 ? OIT_COLOR_8 : OIT_COLOR_FLOAT,
                         .premultiplied = variant == 1,
                         .alpha_law = OIT_ALPHA_ADAPTIVE,
                         .fields = variant >= 2 ? (uint32_t)OIT_FIELD_BLEND : 0u};
        double tolerance = variant == 2 ? 1e-3 : variant == 3 ? 1e-3 : 3e-5;
        oit_scene *s = malloc(sizeof *s);
        oit_setting t;
        oit_setting_open(&t, variant == 3, 4, 4, 0, variant == 3 ? GL_RGBA16F : GL_RGBA32F, desc);
        for (size_t i = 0; i < sizeof counts / sizeof counts[0]; ++i)
            for (size_t k = 0; k < 4; ++k) {
                char name[64];
                oit_scene_init(s, 4, 4);
                snprintf(name, sizeof name, "%d layers that hide %g", counts[i], opacities[k]);
                if (counts[i])
                    oit_scene_sheets(s, counts[i], opacities[k], false);
                check_adaptive(&t, s, name, tolerance);
                if (counts[i] > 2) {
                    for (int m = 0; m < counts[i]; ++m)
                        s->truths[m].alpha = m % 7 == 3 ? 0 : opacities[k] * (0.5 + 0.5 * m / counts[i]);
                    if (variant >= 2) /* not layers: light, filters */
                        for (int m = 0; m < counts[i]; ++m) {
                            s->objects[m].blend = m % 5 == 1 ? OIT_BLEND_ADD : m % 5 == 2 ? OIT_BLEND_MULTIPLY : 0u;
                            if (m % 5 == 1)
                                s->truths[m].alpha = 0.2 / counts[i];
                        }
                    s->objects[counts[i] / 2].blend = OIT_BLEND_OVER; /* and a wall */
                    s->truths[counts[i] / 2].alpha = 1;
                    check_adaptive(&t, s, "mixed, with a wall", tolerance);
                }
                oit_scene_drop(s);
            }
        oit_setting_close(&t);
        free(s);
    }
}

/* In the tail, of one colour, it is the same law; and of a multisampled pixel's samples each has its own count. */
static void test_adaptive_tail_and_samples(void **state) {
    (void)state;
    oit_desc tail = {.fit = OIT_FIT_ASYNC, .ceiling_bytes = 16, .alpha_law = OIT_ALPHA_ADAPTIVE};
    oit_desc samples = {.color = OIT_COLOR_FLOAT, .fields = OIT_FIELD_COVERAGE, .alpha_law = OIT_ALPHA_ADAPTIVE};
    const double color[4] = {0.25, 0.5, 0.75, 0.6};
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    oit_setting_open(&t, false, 4, 4, 0, GL_RGBA32F, tail);
    oit_scene_init(s, 4, 4);
    oit_scene_sheets(s, 9, 0.6, false);
    for (size_t i = 0; i < s->count; ++i)
        memcpy(s->truths[i].color, color, 3 * sizeof(double));
    check_adaptive(&t, s, "the tail", 1e-4);
    oit_scene_drop(s);
    oit_setting_close(&t);
    /* Two sheets on the left, one on the right, of the same colour: with an edge within a column no sample can tell. */
    oit_setting_open(&t, false, 16, 16, 4, GL_RGBA32F, samples);
    oit_scene_init(s, 16, 16);
    for (int i = 0; i < 2; ++i) {
        const double depth[4] = {0.2 * i, 0.2 * i, 0.2 * i, 0.2 * i};
        oit_scene_quad(s, -1, -1, i ? 0.07 : 1, 1, depth, color);
    }
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    oit_setting_clear(&t, s);
    oit_scene_render(s, t.oit, &frame, NULL);
    GLuint resolved = oit_setting_texture(16, 16, 0, GL_RGBA32F), out = oit_setting_framebuffer(resolved, 0, 0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, t.framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, out);
    glBlitFramebuffer(0, 0, 16, 16, 0, 0, 16, 16, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    float *got = oit_setting_read(&t, out);
    for (int i = 0; i < 256; ++i)
        for (int c = 0; c < 3; ++c)
            assert_true(fabs((double)got[4 * i + c] - (0.6 * color[c] + 0.4)) < 1e-5);
    free(got);
    glDeleteFramebuffers(1, &out);
    glDeleteTextures(1, &resolved);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* ---- targets ---- */

static double encode(double x) { /* sRGB */
    return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055;
}

static double decode(double x) {
    return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

/* An sRGB target: with GL_FRAMEBUFFER_SRGB (always so in ES) what is composed is light, as the blending is; without it the
 * numbers are taken as they are. The header leaves that to the host. */
static void test_srgb_targets(void **state) {
    (void)state;
    for (int variant = 0; variant < 3; ++variant) {
        bool es = variant == 2, linear = variant >= 1;
        oit_desc desc = {.color = OIT_COLOR_FLOAT, .fields = variant == 1 ? (uint32_t)OIT_FIELD_BLEND : 0u};
        oit_scene *s = malloc(sizeof *s);
        oit_setting t;
        oit_truth truth[16];
        unsigned char got[64];
        oit_setting_open(&t, es, 4, 4, 0, GL_SRGB8_ALPHA8, desc);
        oit_scene_init(s, 4, 4);
        oit_scene_sheets(s, 6, 0.3, false);
        for (int c = 0; c < 3; ++c)
            s->scene.background[c] = linear ? decode(204 / 255.0) : 204 / 255.0; /* as the target holds it */
        oit_truth_render(s, truth);
        if (!es && linear)
            glEnable(GL_FRAMEBUFFER_SRGB);
        oit_frame frame = oit_scene_frame(s, t.framebuffer);
        oit_setting_clear(&t, s);
        oit_scene_render(s, t.oit, &frame, NULL);
        if (!es) {
            assert_int_equal(glIsEnabled(GL_FRAMEBUFFER_SRGB), linear);
            glDisable(GL_FRAMEBUFFER_SRGB);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
        glReadPixels(0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, got);
        for (int i = 0; i < 16; ++i)
            for (int c = 0; c < 3; ++c) {
                double light = truth[i].color[c];
                assert_true(fabs(got[4 * i + c] - 255 * (linear ? encode(light) : light)) <= 1.0);
            }
        oit_scene_drop(s);
        oit_setting_close(&t);
        free(s);
    }
}

/* Of several draw buffers the first is drawn into, be it whichever attachment; others, of integers too, stay. ES before 3.2
 * cannot mask by buffer and is left out. */
static void test_several_draw_buffers(void **state) {
    static const GLenum drawn[3] = {GL_COLOR_ATTACHMENT2, GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    static const float blue[4] = {0, 0, 1, 0.5f};
    static const GLuint number[4] = {77, 78, 79, 80};
    (void)state;
    for (int blend = 0; blend < 2; ++blend) {
        oit_desc desc = {.color = OIT_COLOR_FLOAT, .fields = blend ? (uint32_t)OIT_FIELD_BLEND : 0u};
        oit_scene *s = malloc(sizeof *s);
        oit_setting t;
        oit_truth truth[16];
        GLuint ids[16 * 4];
        float other[16 * 4], first[16 * 4];
        oit_setting_open(&t, false, 4, 4, 0, GL_RGBA32F, desc);
        oit_scene_init(s, 4, 4);
        oit_scene_sheets(s, 6, 0.3, false);
        oit_truth_render(s, truth);
        GLuint integers = oit_setting_texture(4, 4, 0, GL_RGBA32UI), third = oit_setting_texture(4, 4, 0, GL_RGBA32F);
        glBindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, integers, 0);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT2, GL_TEXTURE_2D, third, 0);
        glDrawBuffers(3, drawn);
        oit_setting_clear(&t, s);
        glClearBufferfv(GL_COLOR, 1, blue);
        glClearBufferuiv(GL_COLOR, 2, number);
        oit_frame frame = oit_scene_frame(s, t.framebuffer);
        oit_scene_render(s, t.oit, &frame, NULL);
        glReadBuffer(GL_COLOR_ATTACHMENT0);
        glReadPixels(0, 0, 4, 4, GL_RGBA, GL_FLOAT, other);
        glReadBuffer(GL_COLOR_ATTACHMENT1);
        glReadPixels(0, 0, 4, 4, GL_RGBA_INTEGER, GL_UNSIGNED_INT, ids);
        glReadBuffer(GL_COLOR_ATTACHMENT2);
        glReadPixels(0, 0, 4, 4, GL_RGBA, GL_FLOAT, first);
        for (int i = 0; i < 16; ++i) {
            assert_memory_equal(other + 4 * i, blue, sizeof blue);
            assert_memory_equal(ids + 4 * i, number, sizeof number);
            for (int c = 0; c < 3; ++c)
                assert_true(fabs((double)first[4 * i + c] - truth[i].color[c]) < 1e-5);
        }
        glDeleteTextures(1, &integers);
        glDeleteTextures(1, &third);
        oit_scene_drop(s);
        oit_setting_close(&t);
        free(s);
    }
}

/* Upside down by glClipControl's origin, and by the projection: the same picture, turned, with opaque things in it. */
static void test_pictures_upside_down(void **state) {
    enum { SIZE = 32 };
    (void)state;
    oit_desc desc = {.color = OIT_COLOR_FLOAT};
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    float *pictures[3];
    oit_setting_open(&t, false, SIZE, SIZE, 0, GL_RGBA32F, desc);
    for (int how = 0; how < 3; ++how) {
        oit_scene_init(s, SIZE, SIZE);
        oit_scene_random_balls(s, 6, 16, 0.4);
        s->truths[2].transparent = false;
        if (how == 1)
            glClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
        if (how == 2)
            s->scene.projection[5] *= -1;
        pictures[how] = draw(&t, s);
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
        oit_scene_drop(s);
    }
    size_t same = 0;
    for (int i = 0; i < SIZE * SIZE; ++i) {
        int turned = (SIZE - 1 - i / SIZE) * SIZE + i % SIZE;
        double by_origin = 0, by_projection = 0;
        for (int c = 0; c < 3; ++c) {
            by_origin = fmax(by_origin, fabs((double)(pictures[1][4 * i + c] - pictures[0][4 * turned + c])));
            by_projection = fmax(by_projection, fabs((double)(pictures[2][4 * i + c] - pictures[0][4 * turned + c])));
        }
        same += by_origin < 1e-5 && by_projection < 1e-5;
    }
    printf("    %zu of %d pixels are the same\n", same, SIZE * SIZE);
    assert_true(same >= SIZE * SIZE - 8); /* edges through the middle of a pixel */
    for (int how = 0; how < 3; ++how)
        free(pictures[how]);
    oit_setting_close(&t);
    free(s);
}

/* Weights of the background between nothing and all, with each way to blend; half floats keep brightness above 1. */
static void test_weights_and_bright_colors(void **state) {
    static const float weights[] = {1, 0.25f, -1};
    (void)state;
    for (int variant = 0; variant < 6; ++variant) {
        bool es = variant >= 3;
        oit_desc desc = {.color = OIT_COLOR_HALF,
                         .fields = variant % 3 ? (uint32_t)OIT_FIELD_BLEND : 0u,
                         .premultiplied = variant % 3 == 2};
        oit_scene *s = malloc(sizeof *s);
        oit_setting t;
        oit_truth truth[16];
        oit_setting_open(&t, es, 4, 4, 0, GL_RGBA16F, desc);
        for (int w = 0; w < 3; ++w) {
            oit_scene_init(s, 4, 4);
            oit_scene_sheets(s, 5, 0.3, false);
            s->truths[2].color[1] = 40;
            s->truths[4].color[0] = 1000;
            s->scene.background_weight = weights[w] > 0 ? (double)weights[w] : 0;
            oit_truth_render(s, truth);
            float *got = draw(&t, s);
            for (int i = 0; i < 16; ++i)
                for (int c = 0; c < 3; ++c)
                    assert_true(fabs((double)got[4 * i + c] - truth[i].color[c]) <= 2e-3 * fmax(1, truth[i].color[c]));
            free(got);
            oit_scene_drop(s);
        }
        oit_setting_close(&t);
        free(s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_adaptive_alpha),       cmocka_unit_test(test_adaptive_tail_and_samples),
        cmocka_unit_test(test_srgb_targets),         cmocka_unit_test(test_several_draw_buffers),
        cmocka_unit_test(test_pictures_upside_down), cmocka_unit_test(test_weights_and_bright_colors),
    };
    setvbuf(stdout, NULL, _IOLBF, 0);
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* gl_oit_hard.c: sizes, ranges and numbers that are hard on oit_buffers.h: nothing lost, nothing out of bounds. */
#include "oit_scene.h"

typedef struct setting {
    harness h;
    oit_context *oit;
    GLuint framebuffer, color;
    int width, height;
} setting;

static void drop_target(setting *t) {
    glDeleteFramebuffers(1, &t->framebuffer);
    glDeleteTextures(1, &t->color);
}

static void make_target(setting *t, int width, int height) {
    drop_target(t);
    t->width = width;
    t->height = height;
    glGenTextures(1, &t->color);
    glBindTexture(GL_TEXTURE_2D, t->color);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, width, height);
    glBindTexture(GL_TEXTURE_2D, 0);
    glGenFramebuffers(1, &t->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, t->color, 0);
}

static void open_setting(setting *t, int width, int height, oit_desc desc) {
    oit_result result;
    memset(t, 0, sizeof *t);
    harness_open(&t->h, 430, false, NULL);
    make_target(t, width, height);
    desc.get_proc = oit_scene_get_proc;
    desc.max_gl_version = 430;
    desc.color = OIT_COLOR_FLOAT;
    t->oit = oit_create(&desc, &result);
    oit_scene_expect(result, "oit_create");
}

static void close_setting(setting *t) {
    oit_destroy(t->oit);
    drop_target(t);
    harness_close(&t->h);
}

static float *draw(setting *t, oit_scene *s) {
    const float background[4] = {(float)s->scene.background[0], (float)s->scene.background[1],
                                 (float)s->scene.background[2], 1};
    float *picture = malloc(4 * (size_t)t->width * (size_t)t->height * sizeof *picture);
    oit_frame frame = oit_scene_frame(s, t->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glClearBufferfv(GL_COLOR, 0, background);
    oit_scene_render(s, t->oit, &frame, NULL);
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glReadPixels(0, 0, t->width, t->height, GL_RGBA, GL_FLOAT, picture);
    return picture;
}

static double worst_error(const oit_scene *s, const float *picture) {
    size_t pixels = (size_t)s->scene.width * (size_t)s->scene.height;
    oit_truth *truth = malloc(pixels * sizeof *truth);
    double worst = 0, left_out = oit_truth_render(s, truth);
    for (size_t i = 0; i < pixels; ++i)
        for (size_t c = 0; c < 3 && !truth[i].left_out; ++c)
            worst = fmax(worst, fabs((double)picture[4 * i + c] - truth[i].color[c]));
    printf("    %d x %d: max %.3g, %.1f %% left out\n", s->scene.width, s->scene.height, worst, 100 * left_out);
    assert_true(left_out <= 0.10);
    free(truth);
    return worst;
}

/* One frame after the other in sizes that come and go, with buffers that grow, are kept and shrink; none at all; one pixel;
 * and as wide as images get. */
static void test_sizes(void **state) {
    static const int sizes[][2] = {{1, 1},  {64, 3}, {3, 64}, {0, 0},   {1, 1},     {200, 90}, {0, 7},
                                   {17, 1}, {1, 31}, {90, 9}, {33, 65}, {16384, 1}, {1, 4096}, {5, 5}};
    (void)state;
    for (int fit = 0; fit < 2; ++fit) {
        oit_desc desc = {.fit = fit ? OIT_FIT_ASYNC : OIT_FIT_WAIT};
        oit_scene *s = malloc(sizeof *s);
        setting t;
        open_setting(&t, 16384, 1, desc);
        for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; ++i) {
            int width = sizes[i][0], height = sizes[i][1];
            oit_scene_init(s, width, height);
            oit_scene_sheets(s, 5, 0.4, false);
            if (width > 0 && height > 0)
                make_target(&t, width, height);
            for (int frame = 0; frame < 3; ++frame) /* OIT_FIT_ASYNC learns what it needs */
                free(draw(&t, s));
            float *picture = draw(&t, s);
            if (width > 0 && height > 0)
                assert_true(worst_error(s, picture) < 1e-5);
            else
                assert_true(fabs((double)picture[0] - s->scene.background[0]) < 1e-6);
            free(picture);
            oit_scene_drop(s);
        }
        close_setting(&t);
        free(s);
    }
}

/* Near and far 10^-4 and 10^6: what can still be told apart is in order, and what cannot is the same in any order. */
static void test_wide_depth_range(void **state) {
    (void)state;
    oit_desc desc = {.fields = OIT_FIELD_PART};
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, 32, 32, desc);
    oit_scene_init(s, 32, 32);
    oit_scene_camera(s, 0, 1e-4, 1e6, 0.5);
    for (int i = 0; i < 12; ++i) { /* at 10^-4 * 4^i: up to 419 */
        double z = -1.5e-4 * pow(4, i), half = 2 * -z, zs[4] = {z, z, z, z};
        const double color[4] = {i % 2, i % 3 / 2.0, i % 5 / 4.0, 0.3};
        oit_scene_quad(s, -half, -half, half, half, zs, color);
    }
    float *picture = draw(&t, s);
    assert_true(worst_error(s, picture) < 1e-5);
    free(picture);
    oit_scene_drop(s);
    close_setting(&t);
    free(s);
}

/* NaN and infinities in a colour count as 0, an alpha beyond [0,1] as its nearest end; nothing of it spreads. */
static void test_numbers_that_are_none(void **state) {
    static const uint32_t bits[] = {0x7fc00000u, 0xffc00000u, 0x7f800000u, 0xff800000u, 0x7f800001u};
    (void)state;
    for (int fit = 0; fit < 2; ++fit) {
        /* with OIT_FIT_ASYNC and no room all goes to the tail */
        oit_desc desc = {.fit = fit ? OIT_FIT_ASYNC : OIT_FIT_WAIT, .ceiling_bytes = fit ? 24 : 0};
        oit_scene *s = malloc(sizeof *s);
        setting t;
        open_setting(&t, 4, 4, desc);
        for (size_t i = 0; i < sizeof bits / sizeof bits[0]; ++i) {
            float bad;
            memcpy(&bad, &bits[i], sizeof bad);
            oit_scene_init(s, 4, 4);
            oit_scene_sheets(s, 3, 0.5, false);
            for (int k = 0; k < 3; ++k)
                for (size_t o = 0; o < 3; ++o)
                    s->truths[o].color[k] = o == 1 ? (double)bad : 0;
            s->truths[2].alpha = (double)bad; /* 0: not there */
            float *picture = draw(&t, s);
            for (int p = 0; p < 16; ++p)
                for (int k = 0; k < 3; ++k) /* two black layers of one half over white */
                    assert_true(fabs((double)picture[4 * p + k] - 0.25) < (fit ? 1e-4 : 1e-6));
            free(picture);
            s->truths[2].alpha = 7; /* 1 */
            s->truths[0].alpha = s->truths[1].alpha = -3;
            picture = draw(&t, s);
            assert_true(fabs((double)picture[0]) < (fit ? 1e-4 : 1e-6));
            free(picture);
            oit_scene_drop(s);
        }
        close_setting(&t);
        free(s);
    }
}

/* Weights of the layers and of the background sum to one: all of one colour stays that colour, for runs of every program
 * and up to 500 layers. */
static void test_weights_sum_to_one(void **state) {
    static const int layers[] = {1, 7, 8, 9, 16, 17, 31, 32, 33, 64, 65, 500};
    (void)state;
    oit_desc desc = {.color = OIT_COLOR_FLOAT};
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, 4, 4, desc);
    for (size_t i = 0; i < sizeof layers / sizeof layers[0]; ++i) {
        double worst = 0;
        oit_scene_init(s, 4, 4);
        oit_scene_sheets(s, layers[i], 0.07, false);
        for (size_t o = 0; o < s->count; ++o) {
            s->truths[o].alpha = 0.01 + 0.9 * (double)(o * 37 % 11) / 11;
            for (int k = 0; k < 3; ++k)
                s->truths[o].color[k] = 1;
        }
        float *picture = draw(&t, s);
        for (int p = 0; p < 64; ++p)
            worst = p % 4 < 3 ? fmax(worst, fabs((double)picture[p] - 1)) : worst;
        printf("    %3d layers: %.2g\n", layers[i], worst);
        assert_true(worst <= 1e-6); /* 500 sums of at most 2^-24 each, most of them far smaller */
        free(picture);
        oit_scene_drop(s);
    }
    close_setting(&t);
    free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_sizes), cmocka_unit_test(test_wide_depth_range),
                                       cmocka_unit_test(test_numbers_that_are_none),
                                       cmocka_unit_test(test_weights_sum_to_one)};
    setvbuf(stdout, NULL, _IOLBF, 0);
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* gl_oit.c: pictures of oit_buffers.h on a real driver, held to a reference in double. */
#include "oit_scene.h"

/* ---- the setting ---- */

typedef struct setting {
    harness h; /* context; its own target is not used */
    oit_context *oit;
    GLuint framebuffer, color, depth;
    GLenum format;
    int width, height;
} setting;

static int logged;

static void on_log(oit_log_level level, oit_result code, const char *text, void *user) {
    (void)user;
    logged += level != OIT_LOG_INFO;
    printf("    log %d: %s\n", (int)code, text);
}

static oit_context *make_oit(const harness *h, oit_desc desc) {
    oit_result result;
    desc.get_proc = oit_scene_get_proc;
    desc.log_fn = on_log;
    desc.max_gl_version = h->context.es ? 310 : 430;
    oit_context *oit = oit_create(&desc, &result);
    if (!oit)
        fail_msg("oit_create: %s", oit_result_string(result));
    return oit;
}

static void drop_target(setting *t) {
    glDeleteFramebuffers(1, &t->framebuffer);
    glDeleteTextures(1, &t->color);
    glDeleteTextures(1, &t->depth);
}

static void make_target(setting *t, int width, int height, GLenum format, GLenum depth) {
    drop_target(t);
    t->width = width;
    t->height = height;
    t->format = format;
    glGenTextures(1, &t->color);
    glBindTexture(GL_TEXTURE_2D, t->color);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
    glGenTextures(1, &t->depth);
    glBindTexture(GL_TEXTURE_2D, t->depth);
    glTexStorage2D(GL_TEXTURE_2D, 1, depth, width, height);
    glBindTexture(GL_TEXTURE_2D, 0);
    glGenFramebuffers(1, &t->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, t->color, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, t->depth, 0);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
}

static void open_setting(setting *t, bool es, int width, int height, GLenum format, oit_desc desc) {
    memset(t, 0, sizeof *t);
    harness_open(&t->h, es ? 310 : 430, es, NULL);
    make_target(t, width, height, format, GL_DEPTH_COMPONENT32F);
    t->oit = make_oit(&t->h, desc);
    logged = 0;
}

static void close_setting(setting *t) {
    oit_destroy(t->oit);
    drop_target(t);
    assert_int_equal(logged, 0);
    harness_close(&t->h);
}

/* Background, and opaque objects with depth. */
static void clear_target(setting *t, oit_scene *s) {
    float depth = 1;
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glViewport(0, 0, t->width, t->height);
    glClearColor((float)s->scene.background[0], (float)s->scene.background[1], (float)s->scene.background[2], 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_DEPTH, 0, &depth);
    glEnable(GL_DEPTH_TEST);
    oit_scene_draw_plain(s, t->h.context.es, false);
    glDisable(GL_DEPTH_TEST);
}

/* Four floats a pixel, bottom row first. */
static float *read_picture(const setting *t) {
    size_t count = 4 * (size_t)t->width * (size_t)t->height;
    float *picture = malloc(count * sizeof *picture);
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    if (t->format == GL_RGBA8) {
        unsigned char *bytes = malloc(count);
        glReadPixels(0, 0, t->width, t->height, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
        for (size_t i = 0; i < count; ++i)
            picture[i] = (float)bytes[i] / 255.0f;
        free(bytes);
    } else {
        glReadPixels(0, 0, t->width, t->height, GL_RGBA, GL_FLOAT, picture);
    }
    return picture;
}

static float *draw(setting *t, oit_scene *s, const size_t *order) {
    oit_frame frame = oit_scene_frame(s, t->framebuffer);
    clear_target(t, s);
    oit_scene_render(s, t->oit, &frame, order);
    return read_picture(t);
}

/* ---- comparison ---- */

static double worst_error(const oit_scene *s, const oit_truth *truth, const float *picture, size_t *where) {
    double worst = 0;
    for (size_t i = 0; i < (size_t)s->scene.width * (size_t)s->scene.height; ++i)
        for (size_t c = 0; c < 3 && !truth[i].left_out; ++c) {
            double error = fabs((double)picture[4 * i + c] - truth[i].color[c]);
            if (error > worst) {
                worst = error;
                *where = i;
            }
        }
    return worst;
}

static void check(setting *t, oit_scene *s, const char *name, double tolerance) {
    size_t pixels = (size_t)s->scene.width * (size_t)s->scene.height, where = 0;
    oit_truth *truth = malloc(pixels * sizeof *truth);
    double left_out = oit_truth_render(s, truth);
    float *picture = draw(t, s, NULL);
    oit_report report;
    assert_int_equal(oit_get_report(t->oit, &report), OIT_OK);
    double worst = worst_error(s, truth, picture, &where);
    printf("    %-28s max %.3g (allowed %.3g), %4.1f %% left out, %u fragments, deepest %u, bands %u\n", name, worst,
           tolerance, 100 * left_out, report.needed, report.deepest, report.bands);
    if (!(worst <= tolerance))
        fail_msg("%s: pixel %zu, %zu of %u layers is %g %g %g, should be %g %g %g", name,
                 where % (size_t)s->scene.width, where / (size_t)s->scene.width, truth[where].layers,
                 (double)picture[4 * where], (double)picture[4 * where + 1], (double)picture[4 * where + 2],
                 truth[where].color[0], truth[where].color[1], truth[where].color[2]);
    assert_true(left_out <= 0.10);
    assert_int_equal(report.extra, 0);
    free(picture);
    free(truth);
}

/* ---- pictures ---- */

/* A target of floats holds what is composed; the tolerances are those of the contract, 1/255 and 10^-5. */
static const double tolerance_8 = 1.0 / 255 + 1e-6, tolerance_float = 1e-5;

static void check_scenes(bool es, oit_desc desc, GLenum format, double tolerance) {
    static const int layers[] = {1, 2, 3, 4, 5, 8, 9, 16, 17, 32, 33, 64, 65, 100, 200, 500};
    setting t;
    oit_scene *s = malloc(sizeof *s);
    open_setting(&t, es, 24, 16, format, desc);
    for (size_t i = 0; i < sizeof layers / sizeof layers[0]; ++i) {
        char name[32];
        oit_scene_init(s, 24, 16);
        snprintf(name, sizeof name, "%d sheets", layers[i]);
        oit_scene_sheets(s, layers[i], layers[i] > 50 ? 0.02 : 0.2, false);
        check(&t, s, name, tolerance);
        oit_scene_drop(s);
    }
    make_target(&t, 96, 96, format, GL_DEPTH_COMPONENT32F);
    oit_scene_init(s, 96, 96);
    oit_scene_random_balls(s, 6, 16, 0.4);
    s->truths[2].transparent = false;
    check(&t, s, "balls, one opaque", tolerance);
    oit_scene_drop(s);
    oit_scene_init(s, 96, 96);
    oit_scene_sheets(s, 12, 0.3, true);
    check(&t, s, "sheets that intersect", tolerance);
    oit_scene_drop(s);
    close_setting(&t);
    free(s);
}

static void test_scenes_match_reference(void **state) {
    (void)state;
    oit_desc desc = {0};
    check_scenes(false, desc, GL_RGBA8, tolerance_8);
}

static void test_float_scenes_match_reference(void **state) {
    (void)state;
    oit_desc desc = {.color = OIT_COLOR_FLOAT, .fields = OIT_FIELD_PART};
    check_scenes(false, desc, GL_RGBA32F, tolerance_float);
}

static void test_es_scenes_match_reference(void **state) {
    (void)state;
    oit_desc desc = {.color = OIT_COLOR_HALF};
    check_scenes(true, desc, GL_RGBA8, tolerance_8);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scenes_match_reference),
        cmocka_unit_test(test_float_scenes_match_reference),
        cmocka_unit_test(test_es_scenes_match_reference),
    };
    setvbuf(stdout, NULL, _IOLBF, 0);
    return cmocka_run_group_tests(tests, NULL, NULL);
}

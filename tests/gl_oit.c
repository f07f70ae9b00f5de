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
    float depth = s->reversed ? 0 : 1;
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glViewport(0, 0, t->width, t->height);
    glClearColor((float)s->scene.background[0], (float)s->scene.background[1], (float)s->scene.background[2], 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_DEPTH, 0, &depth);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(s->reversed ? GL_GREATER : GL_LESS);
    oit_scene_draw_plain(s, t->h.context.es, false);
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
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

static uint32_t float_bits(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
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
    oit_report report = {0};
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
    make_target(&t, 128, 128, format, GL_DEPTH_COMPONENT32F);
    oit_scene_init(s, 128, 128);
    oit_scene_random_balls(s, 6, 16, 0.4);
    s->truths[2].transparent = false;
    check(&t, s, "balls, one opaque", tolerance);
    oit_scene_drop(s);
    oit_scene_init(s, 128, 128);
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

/* ---- the same bits ---- */

static void expect_same(const setting *t, const float *a, const float *b, const char *what) {
    size_t bytes = 4 * (size_t)t->width * (size_t)t->height * sizeof *a;
    if (memcmp(a, b, bytes) != 0)
        fail_msg("%s: the pictures differ", what);
}

/* Coincident sheets and sheets that intersect, in eight orders and again; with ties in depth that parts, keys or nothing
 * but the colours tell apart. */
static void check_orders(oit_desc desc) {
    setting t;
    oit_scene *s = malloc(sizeof *s);
    size_t order[OIT_SCENE_MAX];
    uint32_t state = 3;
    const double depth[4] = {0.25, 0.25, 0.25, 0.25};
    open_setting(&t, false, 64, 64, GL_RGBA32F, desc);
    oit_scene_init(s, 64, 64);
    oit_scene_sheets(s, 40, 0.1, true);
    for (int i = 0; i < 40; ++i) {
        const double color[4] = {oit_scene_random(&state), oit_scene_random(&state), 0.5, 0.3};
        size_t at = oit_scene_quad(s, -1, -1, i % 3 ? 1 : 0.1, 1, depth, color);
        s->objects[at].part = i % 2 ? 7 : (uint32_t)i;
        s->objects[at].key = (uint32_t)(i * 37 % 11);
    }
    for (int warm = 0; warm < 3; ++warm) /* OIT_FIT_ASYNC learns what it needs */
        free(draw(&t, s, NULL));
    float *first = draw(&t, s, NULL);
    for (int run = 0; run < 9; ++run) {
        for (size_t i = 0; i < s->count; ++i)
            order[i] = i;
        for (size_t i = s->count - 1; run > 0 && i > 0; --i) {
            size_t other = (size_t)(oit_scene_random(&state) * (double)(i + 1)), kept = order[i];
            order[i] = order[other];
            order[other] = kept;
        }
        float *next = draw(&t, s, order);
        expect_same(&t, first, next, run ? "another order" : "the same again");
        free(next);
    }
    free(first);
    oit_scene_drop(s);
    close_setting(&t);
    free(s);
}

static void test_draw_order_changes_nothing(void **state) {
    (void)state;
    oit_desc plain = {.color = OIT_COLOR_FLOAT}, all = {.fields = OIT_FIELD_ALL, .host_words = 3, .fit = OIT_FIT_ASYNC};
    check_orders(plain);
    check_orders(all);
}

/* Over the ceiling the picture comes in bands, down to parts of a row, and is the same. */
static void test_bands_equal_the_whole(void **state) {
    static const int64_t ceilings[] = {0, 64 * 1024, 16 * 1024, 4 * 1024};
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    float *whole = NULL;
    uint32_t bands = 0;
    for (size_t i = 0; i < sizeof ceilings / sizeof ceilings[0]; ++i) {
        oit_desc desc = {.color = OIT_COLOR_FLOAT, .ceiling_bytes = ceilings[i]};
        oit_report report = {0};
        setting t;
        open_setting(&t, false, 48, 40, GL_RGBA32F, desc);
        oit_scene_init(s, 48, 40);
        oit_scene_random_balls(s, 8, 16, 0.3);
        oit_scene_sheets(s, 5, 0.2, false);
        float *picture = draw(&t, s, NULL);
        assert_int_equal(oit_get_report(t.oit, &report), OIT_OK);
        printf("    ceiling %lld: %u fragments, %u bands\n", (long long)ceilings[i], report.needed, report.bands);
        assert_true(i == 0 ? report.bands == 1 : report.bands > bands);
        assert_int_equal(report.lost_pixels + report.extra, 0);
        assert_true(ceilings[i] == 0 || report.capacity * 24 <= ceilings[i]);
        bands = report.bands;
        if (whole)
            expect_same(&t, whole, picture, "bands");
        else
            whole = picture;
        if (whole != picture)
            free(picture);
        oit_scene_drop(s);
        close_setting(&t);
    }
    free(whole);
    free(s);
}

/* Where a storage block holds only some rows, the picture is counted in slabs. */
static void test_slabs_equal_the_whole(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    float *pictures[2];
    setting t;
    for (int i = 0; i < 2; ++i) {
        oit_desc desc = {.color = OIT_COLOR_FLOAT, .max_block_bytes = i ? 4000 : 0};
        open_setting(&t, false, 40, 36, GL_RGBA32F, desc);
        oit_scene_init(s, 40, 36);
        oit_scene_random_balls(s, 6, 16, 0.3);
        pictures[i] = draw(&t, s, NULL);
        assert_int_equal(t.oit->rows, i ? 12 : 36);
        if (i)
            expect_same(&t, pictures[0], pictures[1], "slabs");
        oit_scene_drop(s);
        close_setting(&t);
    }
    free(pictures[0]);
    free(pictures[1]);
    free(s);
}

/* ---- never waiting ---- */

/* A pool that is too small at first: what does not fit is counted as the CPU counts it, comes from the tail as a picture
 * that does not depend on the order, and fits a few frames later. */
static void test_async_grows_and_reports(void **state) {
    (void)state;
    oit_desc desc = {.color = OIT_COLOR_FLOAT, .fit = OIT_FIT_ASYNC};
    oit_scene *s = malloc(sizeof *s);
    oit_report report = {0};
    setting t;
    open_setting(&t, false, 32, 32, GL_RGBA32F, desc);
    oit_scene_init(s, 32, 32);
    oit_scene_sheets(s, 20, 0.2, false);
    free(draw(&t, s, NULL)); /* reading the picture has finished the frame; the next begin takes its report */
    float *second = draw(&t, s, NULL);
    assert_int_equal(oit_get_report(t.oit, &report), OIT_OK);
    assert_int_equal(report.frame, 1);
    assert_int_equal(report.capacity, 4 * 32 * 32);
    assert_int_equal(report.needed, 20 * 32 * 32);
    assert_int_equal(report.deepest, 20);
    /* Runs of 20: of 4,096 places 204 hold a whole run. */
    assert_int_equal(report.lost_pixels, 32 * 32 - 4096 / 20);
    assert_int_equal(report.lost, 20 * (32 * 32 - 4096 / 20));
    oit_truth *truth = malloc(32 * 32 * sizeof *truth);
    size_t where;
    oit_truth_render(s, truth);
    assert_true(worst_error(s, truth, second, &where) < 1e-5);
    free(draw(&t, s, NULL));
    assert_int_equal(oit_get_report(t.oit, &report), OIT_OK);
    assert_int_equal(report.frame, 2);
    assert_int_equal(report.lost_pixels, 0);
    assert_int_equal(report.capacity, 20 * 32 * 32 + 20 * 32 * 32 / 4 + 1);
    free(second);
    free(truth);
    oit_scene_drop(s);
    close_setting(&t);
    free(s);
}

/* The tail itself: exact for layers of one colour, and for one layer; the same bits in any order. */
static void test_tail(void **state) {
    (void)state;
    oit_desc desc = {.fit = OIT_FIT_ASYNC, .ceiling_bytes = 16};
    oit_scene *s = malloc(sizeof *s);
    size_t order[16];
    oit_report report = {0};
    setting t;
    open_setting(&t, false, 16, 16, GL_RGBA32F, desc);
    for (int layers = 1; layers <= 16; layers += 5) {
        oit_scene_init(s, 16, 16);
        oit_scene_sheets(s, layers, 0.2, false);
        for (int i = 0; i < layers; ++i) {
            order[i] = (size_t)(layers - 1 - i);
            s->truths[i].alpha = 0.1 + 0.05 * i;
        }
        float *one = draw(&t, s, NULL), *two = draw(&t, s, order);
        expect_same(&t, one, two, "the tail in another order");
        free(one);
        free(two);
        for (int i = 0; i < layers; ++i)
            for (int k = 0; k < 3; ++k)
                s->truths[i].color[k] = 0.25 * (k + 1);
        check(&t, s, "tail of one colour", 1e-4);
        oit_scene_drop(s);
    }
    assert_int_equal(oit_get_report(t.oit, &report), OIT_OK);
    assert_int_equal(report.lost_pixels, 256);
    close_setting(&t);
    free(s);
}

/* The host draws more in the fill pass than it did in the count pass: nothing is written outside, and it is reported; less:
 * what came is composed. */
static void test_fill_differs_from_count(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    for (int fit = 0; fit < 2; ++fit) {
        oit_desc desc = {.color = OIT_COLOR_FLOAT, .fit = (oit_fit)fit};
        setting t;
        open_setting(&t, false, 16, 16, GL_RGBA32F, desc);
        oit_scene_init(s, 16, 16);
        oit_scene_sheets(s, 6, 0.25, false);
        for (int more = 0; more < 2; ++more) {
            oit_frame frame = oit_scene_frame(s, t.framebuffer);
            oit_report report = {0};
            oit_pass pass;
            for (int run = 0; run < 2; ++run) {
                clear_target(&t, s);
                oit_scene_expect(oit_begin(t.oit, &frame), "oit_begin");
                while (oit_next_pass(t.oit, &pass)) {
                    size_t all = s->count;
                    s->count = (pass.kind == OIT_PASS_FILL) == (more == 1) ? 6 : 3;
                    oit_scene_draw(s, t.oit, &pass, NULL);
                    s->count = all;
                }
                oit_scene_expect(oit_compose(t.oit), "oit_compose");
                oit_scene_expect(oit_end(t.oit), "oit_end");
                glFinish();
            }
            float *picture = read_picture(&t);
            oit_scene_expect(oit_begin(t.oit, &frame), "oit_begin"); /* takes the report */
            oit_scene_expect(oit_end(t.oit), "oit_end");
            assert_int_equal(oit_get_report(t.oit, &report), OIT_OK);
            assert_int_equal(report.extra, more ? 3 * 256 : 0);
            if (!more) { /* the first three only */
                oit_truth *truth = malloc(256 * sizeof *truth);
                size_t where, all = s->scene.object_count;
                s->scene.object_count = 3;
                oit_truth_render(s, truth);
                assert_true(worst_error(s, truth, picture, &where) < 1e-5);
                s->scene.object_count = all;
                free(truth);
            }
            free(picture);
        }
        oit_scene_drop(s);
        close_setting(&t);
    }
    free(s);
}

/* The passes as data, run by the host, give the picture that the header's own run gives. */
static void test_host_sets_the_state(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    float *pictures[2];
    setting t;
    for (int i = 0; i < 2; ++i) {
        oit_desc desc = {
            .color = OIT_COLOR_FLOAT, .fit = OIT_FIT_ASYNC, .state = i ? OIT_STATE_NONE : OIT_STATE_RESTORE};
        oit_frame frame;
        open_setting(&t, false, 64, 64, GL_RGBA32F, desc);
        oit_scene_init(s, 64, 64);
        oit_scene_random_balls(s, 6, 16, 0.4);
        s->truths[1].transparent = false;
        frame = oit_scene_frame(s, t.framebuffer);
        clear_target(&t, s);
        if (i)
            oit_scene_render_raw(s, t.oit, &frame, NULL, NULL);
        else
            oit_scene_render(s, t.oit, &frame, NULL);
        pictures[i] = read_picture(&t);
        oit_scene_drop(s);
        close_setting(&t);
    }
    assert_memory_equal(pictures[0], pictures[1], 4 * 64 * 64 * sizeof(float));
    free(pictures[0]);
    free(pictures[1]);
    free(s);
}

/* ---- blend operations, weights, conventions ---- */

static void mixed_blends(oit_scene *s, int size) {
    oit_scene_init(s, size, size);
    oit_scene_sheets(s, 24, 0.25, true);
    for (size_t i = 0; i < s->count; ++i) {
        s->objects[i].blend = (uint32_t)(i % 3);
        if (i % 3 == OIT_BLEND_ADD)
            s->truths[i].alpha = 0.05;
    }
    s->scene.background[1] = 0.5;
}

static void test_blend_operations(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    for (int variant = 0; variant < 6; ++variant) {
        oit_desc desc = {.color = (oit_color)(variant % 3), .fields = OIT_FIELD_BLEND, .premultiplied = variant & 1};
        bool es = variant >= 3;
        setting t;
        open_setting(&t, es, 64, 64, es ? GL_RGBA16F : GL_RGBA32F, desc);
        mixed_blends(s, 64);
        check(&t, s, es ? "blends, two draws" : "blends, dual source", es ? 2e-3 : variant % 3 == 2 ? 1e-5 : 2e-3);
        oit_scene_drop(s);
        close_setting(&t);
    }
    free(s);
}

static void test_background_weight(void **state) {
    static const double weights[] = {1, 0.5, 0};
    (void)state;
    oit_desc desc = {.color = OIT_COLOR_FLOAT};
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, false, 32, 32, GL_RGBA32F, desc);
    for (int i = 0; i < 3; ++i) {
        oit_scene_init(s, 32, 32);
        oit_scene_sheets(s, 3, 0.3, false);
        s->scene.background_weight = weights[i];
        check(&t, s, "background weight", 1e-5);
        oit_scene_drop(s);
    }
    close_setting(&t);
    free(s);
}

static void test_reversed_depth(void **state) {
    (void)state;
    oit_desc desc = {.color = OIT_COLOR_FLOAT, .reversed_z = 1};
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, false, 128, 128, GL_RGBA32F, desc);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    oit_scene_init(s, 128, 128);
    oit_scene_random_balls(s, 6, 16, 0.4);
    s->truths[2].transparent = false;
    s->reversed = true;
    check(&t, s, "reversed depth", 1e-5);
    oit_scene_drop(s);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    close_setting(&t);
    free(s);
}

/* A viewport that is not at the origin; what is outside of it stays, and so does the target's alpha. */
static void test_viewport_with_an_offset(void **state) {
    (void)state;
    oit_desc desc = {.color = OIT_COLOR_FLOAT};
    oit_scene *s = malloc(sizeof *s);
    oit_truth *truth = malloc(24 * 16 * sizeof *truth);
    setting t;
    open_setting(&t, false, 40, 40, GL_RGBA32F, desc);
    oit_scene_init(s, 24, 16);
    oit_scene_sheets(s, 9, 0.2, false);
    oit_truth_render(s, truth);
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    frame.x = 7;
    frame.y = 11;
    clear_target(&t, s);
    oit_scene_render(s, t.oit, &frame, NULL);
    float *picture = read_picture(&t);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            const float *pixel = picture + 4 * (40 * y + x);
            bool inside = x >= 7 && x < 31 && y >= 11 && y < 27;
            const double white[3] = {1, 1, 1}, *expected = inside ? truth[24 * (y - 11) + x - 7].color : white;
            for (int c = 0; c < 3; ++c)
                assert_true(fabs((double)pixel[c] - expected[c]) < 1e-5);
            assert_true(pixel[3] == 1.0f);
        }
    free(picture);
    free(truth);
    oit_scene_drop(s);
    close_setting(&t);
    free(s);
}

/* ---- the host's own shaders ---- */

static GLuint host_program(const oit_context *oit, oit_pass_kind kind) {
    static const char *const own[2] = {
        "layout(location = 0) in vec2 corner;\nuniform float z;\n"
        "void main() { gl_Position = vec4(corner, z, 1.0); }\n",
        "uniform vec4 color;\nuniform uint number;\n"
        "void main() {\n"
        "    if ((int(gl_FragCoord.x) + int(gl_FragCoord.y)) % 2 == 1)\n        discard;\n"
        "    oit_fragment f;\n    f.color = color;\n    f.part = number;\n    f.normal = vec3(0.0, 0.6, -0.8);\n"
        "    f.uv = vec2(0.5, 3.0);\n    f.words[0] = number * 7u;\n    f.words[1] = 9u;\n    oit_store(f);\n}\n"};
    static const GLenum types[2] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
    GLuint program = glCreateProgram();
    GLint ok = 0;
    for (int stage = 0; stage < 2; ++stage) {
        const char *strings[32];
        char log[2048] = "";
        int count = 0;
        const char *const *ours = oit_glsl(oit, (oit_stage)stage, kind, &count);
        assert_non_null(ours);
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

/* Two sheets with holes, drawn by the host's programs; every word of the records as it was given. */
static void check_host_shaders(bool es) {
    static const float corners[6] = {-1, -1, 3, -1, -1, 3};
    oit_desc desc = {
        .color = OIT_COLOR_FLOAT, .fields = OIT_FIELD_PART | OIT_FIELD_NORMAL | OIT_FIELD_UV, .host_words = 2};
    GLuint array, buffer, programs[2];
    setting t;
    oit_pass pass;
    open_setting(&t, es, 8, 8, GL_RGBA16F, desc);
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, NULL);
    programs[0] = host_program(t.oit, OIT_PASS_COUNT);
    programs[1] = host_program(t.oit, OIT_PASS_FILL);
    oit_frame frame = {.framebuffer = t.framebuffer, .width = 8, .height = 8};
    glBindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    oit_scene_expect(oit_begin(t.oit, &frame), "oit_begin");
    while (oit_next_pass(t.oit, &pass)) {
        GLuint program = programs[pass.kind == OIT_PASS_FILL];
        glUseProgram(program);
        for (int i = 0; i < 2; ++i) {
            glUniform1f(glGetUniformLocation(program, "z"), i ? -0.5f : 0.5f);
            glUniform4f(glGetUniformLocation(program, "color"), i ? 1.0f : 0, i ? 0 : 1.0f, 0, 0.5f);
            glUniform1ui(glGetUniformLocation(program, "number"), (GLuint)(5 + i));
            glDrawArrays(GL_TRIANGLES, 0, 3);
        }
    }
    oit_scene_expect(oit_compose(t.oit), "oit_compose");
    oit_scene_expect(oit_end(t.oit), "oit_end");
    float *picture = read_picture(&t);
    for (int i = 0; i < 64; ++i) { /* 0.5 red over 0.25 green, or a hole */
        bool hole = (i % 8 + i / 8) % 2 == 1;
        assert_true(fabs((double)picture[4 * i] - (hole ? 0 : 0.5)) < 1e-3);
        assert_true(fabs((double)picture[4 * i + 1] - (hole ? 0 : 0.25)) < 1e-3);
    }
    free(picture);
    assert_int_equal(oit_get_info(t.oit).fragment_bytes, 48);
    glBindBuffer(GL_COPY_READ_BUFFER, t.oit->buffers[OIT_I_FRAGMENTS]);
    const uint32_t *record = glMapBufferRange(GL_COPY_READ_BUFFER, 0, 64 * 48, GL_MAP_READ_BIT);
    for (int i = 0; i < 64; ++i, record += 12) { /* 32 pixels of two */
        uint32_t part = record[1];
        assert_true(part == 5 || part == 6);
        assert_int_equal(record[0], float_bits(part == 5 ? 0.75f : 0.25f));
        assert_int_equal(record[2], float_bits(part == 6 ? 1.0f : 0));
        assert_int_equal(record[5], float_bits(0.5f));
        /* (0, 0.6, -0.8) folds to (1 - 0.6 / 1.4, 1 - 0) */
        assert_true(abs((int)(record[6] & 0xffffu) - (int)(32767.0 * (1 - 0.6 / 1.4))) <= 1);
        assert_int_equal(record[6] >> 16, 32767);
        assert_int_equal(record[7], float_bits(0.5f));
        assert_int_equal(record[8], float_bits(3.0f));
        assert_int_equal(record[9], part * 7);
        assert_int_equal(record[10], 9);
    }
    glUnmapBuffer(GL_COPY_READ_BUFFER);
    glDeleteProgram(programs[0]);
    glDeleteProgram(programs[1]);
    glBindVertexArray(0);
    glDeleteVertexArrays(1, &array);
    glDeleteBuffers(1, &buffer);
    close_setting(&t);
}

static void test_host_shaders(void **state) {
    (void)state;
    check_host_shaders(false);
    check_host_shaders(true);
}

/* ---- state ---- */

typedef struct gl_state {
    GLint numbers[40], bindings[16];
    GLint64 ranges[8];
    GLboolean switches[24], masks[8][4];
    GLfloat floats[8];
} gl_state;

static gl_state take_state(void) {
    static const GLenum numbers[] = {GL_CURRENT_PROGRAM,
                                     GL_VERTEX_ARRAY_BINDING,
                                     GL_DRAW_FRAMEBUFFER_BINDING,
                                     GL_READ_FRAMEBUFFER_BINDING,
                                     GL_DEPTH_FUNC,
                                     GL_COPY_WRITE_BUFFER,
                                     GL_COPY_READ_BUFFER_BINDING,
                                     GL_UNIFORM_BUFFER_BINDING,
                                     GL_BLEND_SRC_RGB,
                                     GL_BLEND_DST_RGB,
                                     GL_BLEND_SRC_ALPHA,
                                     GL_BLEND_DST_ALPHA,
                                     GL_BLEND_EQUATION_RGB,
                                     GL_BLEND_EQUATION_ALPHA,
                                     GL_SHADER_STORAGE_BUFFER_BINDING,
                                     GL_ACTIVE_TEXTURE,
                                     GL_CULL_FACE_MODE,
                                     GL_FRONT_FACE};
    static const GLenum switches[] = {GL_DEPTH_TEST,
                                      GL_STENCIL_TEST,
                                      GL_SCISSOR_TEST,
                                      GL_CULL_FACE,
                                      GL_DITHER,
                                      GL_POLYGON_OFFSET_FILL,
                                      GL_POLYGON_OFFSET_LINE,
                                      GL_SAMPLE_ALPHA_TO_COVERAGE,
                                      GL_SAMPLE_COVERAGE,
                                      GL_SAMPLE_MASK,
                                      GL_COLOR_LOGIC_OP,
                                      GL_DEPTH_CLAMP,
                                      GL_CLIP_DISTANCE0,
                                      GL_CLIP_DISTANCE0 + 3,
                                      GL_BLEND};
    gl_state out;
    memset(&out, 0, sizeof out);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; ++i)
        glGetIntegerv(numbers[i], &out.numbers[i]);
    glGetIntegerv(GL_VIEWPORT, out.numbers + 20);
    glGetIntegerv(GL_SCISSOR_BOX, out.numbers + 24);
    glGetIntegerv(GL_POLYGON_MODE, out.numbers + 28);
    for (size_t i = 0; i < sizeof switches / sizeof switches[0]; ++i)
        out.switches[i] = glIsEnabled(switches[i]);
    out.switches[20] = glIsEnabledi(GL_BLEND, 1);
    out.switches[21] = glIsEnabledi(GL_SCISSOR_TEST, 2);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &out.switches[22]);
    for (GLuint i = 0; i < 8; ++i)
        glGetBooleani_v(GL_COLOR_WRITEMASK, i, out.masks[i]);
    for (GLuint i = 0; i < 4; ++i) {
        glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, i, &out.bindings[i]);
        glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, i, &out.ranges[i]);
    }
    glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, 14, &out.bindings[4]);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_START, 14, &out.ranges[4]);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, 14, &out.ranges[5]);
    glGetIntegeri_v(GL_BLEND_SRC_RGB, 1, &out.bindings[5]);
    glGetFloatv(GL_DEPTH_RANGE, out.floats);
    glGetFloati_v(GL_VIEWPORT, 2, out.floats + 2);
    return out;
}

/* Nothing as a fresh context has it. */
static void disturb_state(GLuint buffer, GLuint framebuffer, GLuint array, GLuint program) {
    static const GLenum on[] = {GL_DEPTH_TEST,          GL_STENCIL_TEST,        GL_CULL_FACE,
                                GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_SAMPLE_ALPHA_TO_COVERAGE,
                                GL_SAMPLE_COVERAGE,     GL_SAMPLE_MASK,         GL_DEPTH_CLAMP,
                                GL_CLIP_DISTANCE0,      GL_CLIP_DISTANCE0 + 3};
    for (size_t i = 0; i < sizeof on / sizeof on[0]; ++i)
        glEnable(on[i]);
    glDisable(GL_DITHER);
    glUseProgram(program);
    glBindVertexArray(array);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
    glDepthRange(0.25, 0.75);
    glEnablei(GL_BLEND, 1);
    glEnablei(GL_SCISSOR_TEST, 2);
    glBlendFuncSeparate(GL_DST_COLOR, GL_ONE, GL_SRC_ALPHA, GL_DST_ALPHA);
    glBlendFunci(1, GL_ZERO, GL_ONE);
    glBlendEquationSeparate(GL_MAX, GL_FUNC_SUBTRACT);
    glColorMaski(0, GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    glColorMaski(3, GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    glViewport(1, 2, 3, 4);
    glViewportIndexedf(2, 5, 6, 7, 8);
    glScissor(5, 6, 7, 8);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    for (GLuint i = 0; i < 3; ++i)
        glBindBufferRange(GL_SHADER_STORAGE_BUFFER, i, buffer, 256 * (GLintptr)i, 256);
    glBindBufferRange(GL_UNIFORM_BUFFER, 14, buffer, 256, 512);
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
}

static void test_state_is_restored(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    for (int variant = 0; variant < 6; ++variant) {
        oit_desc desc = {.color = OIT_COLOR_FLOAT,
                         .fields = variant & 1 ? (uint32_t)OIT_FIELD_BLEND : 0u,
                         .fit = variant >= 4 ? OIT_FIT_ASYNC : OIT_FIT_WAIT,
                         .ceiling_bytes = variant >= 2 && variant < 4 ? 3000 : 0};
        GLuint buffer, array;
        setting t;
        size_t where = 0;
        oit_truth *truth = malloc(32 * 32 * sizeof *truth);
        open_setting(&t, false, 32, 32, GL_RGBA32F, desc);
        oit_scene_init(s, 32, 32);
        oit_scene_sheets(s, 4, 0.3, false);
        oit_truth_render(s, truth);
        oit_frame frame = oit_scene_frame(s, t.framebuffer);
        clear_target(&t, s);
        glGenBuffers(1, &buffer);
        glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
        glBufferData(GL_COPY_WRITE_BUFFER, 4096, NULL, GL_STATIC_DRAW);
        glGenVertexArrays(1, &array);
        disturb_state(buffer, t.h.framebuffer, array, s->plain);
        gl_state before = take_state();
        for (int run = 0; run < 2; ++run) {
            if (run == 1) {
                glBindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
                glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
                const float white[4] = {1, 1, 1, 1};
                glClearBufferfv(GL_COLOR, 0, white);
                disturb_state(buffer, t.h.framebuffer, array, s->plain);
            }
            oit_pass pass; /* the test's own draws bind vertex arrays, which is the host's to do */
            oit_scene_expect(oit_begin(t.oit, &frame), "oit_begin");
            while (oit_next_pass(t.oit, &pass))
                oit_scene_draw(s, t.oit, &pass, NULL);
            oit_scene_expect(oit_compose(t.oit), "oit_compose");
            oit_scene_expect(oit_end(t.oit), "oit_end");
            gl_state after = take_state();
            assert_memory_equal(&before, &after, sizeof before);
        }
        /* And none of it was in the way. */
        float *picture = read_picture(&t);
        assert_true(worst_error(s, truth, picture, &where) < 1e-5);
        free(picture);
        free(truth);
        glUseProgram(0);
        glBindVertexArray(0);
        glDeleteVertexArrays(1, &array);
        glDeleteBuffers(1, &buffer);
        oit_scene_drop(s);
        close_setting(&t);
    }
    free(s);
}

static void test_state_defaults(void **state) {
    (void)state;
    oit_desc desc = {.state = OIT_STATE_LEAVE_DEFAULTS};
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, false, 32, 32, GL_RGBA8, desc);
    oit_scene_init(s, 32, 32);
    oit_scene_sheets(s, 4, 0.3, false);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    gl_state fresh = take_state();
    clear_target(&t, s);
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    glEnable(GL_CULL_FACE);
    glEnablei(GL_BLEND, 0);
    glDepthMask(GL_FALSE);
    oit_scene_render(s, t.oit, &frame, NULL);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    gl_state after = take_state();
    memcpy(after.numbers + 20, fresh.numbers + 20, 8 * sizeof(GLint)); /* viewport and scissor box stay */
    memcpy(after.floats + 2, fresh.floats + 2, 4 * sizeof(GLfloat));
    assert_memory_equal(&fresh, &after, sizeof fresh);
    oit_scene_drop(s);
    close_setting(&t);
    free(s);
}

/* ---- hard cases ---- */

/* Two sheets one unit in the last place of the depth apart, drawn in either order: the nearer one is laid first. The
 * depths are what the fill pass saw, read back from the buffer. */
static void test_one_ulp_apart(void **state) {
    static const size_t orders[2][2] = {{0, 1}, {1, 0}};
    (void)state;
    oit_desc desc = {.color = OIT_COLOR_FLOAT};
    oit_scene *s = malloc(sizeof *s);
    float *pictures[2];
    setting t;
    open_setting(&t, false, 4, 4, GL_RGBA32F, desc);
    oit_scene_init(s, 4, 4);
    float nearer = 0.25f, farther = nextafterf(nearer, 1.0f);
    const double colors[2][4] = {{1, 0, 0, 0.5}, {0, 1, 0, 0.5}};
    for (int i = 0; i < 2; ++i) {
        /* window depth d from normalised device depth 2 d - 1, which is exact here */
        double z = 2.0 * (double)(i ? farther : nearer) - 1.0, zs[4] = {z, z, z, z};
        oit_scene_quad(s, -1, -1, 1, 1, zs, colors[i]);
    }
    for (int i = 0; i < 2; ++i) {
        uint32_t record[12];
        pictures[i] = draw(&t, s, orders[i]);
        glBindBuffer(GL_COPY_READ_BUFFER, t.oit->buffers[OIT_I_FRAGMENTS]);
        glGetBufferSubData(GL_COPY_READ_BUFFER, 0, sizeof record, record);
        uint32_t low = record[0] < record[6] ? record[0] : record[6], high = record[0] ^ record[6] ^ low;
        assert_int_equal(low, float_bits(nearer));
        assert_int_equal(high, float_bits(farther));
        /* 0.5 red over 0.25 green over 0.25 white */
        assert_true(fabs((double)pictures[i][0] - 0.75) < 1e-6 && fabs((double)pictures[i][1] - 0.5) < 1e-6);
    }
    expect_same(&t, pictures[0], pictures[1], "order of two sheets");
    free(pictures[0]);
    free(pictures[1]);
    oit_scene_drop(s);
    close_setting(&t);
    free(s);
}

/* 1,000 layers of alpha 10^-4; alpha 0 and 1 among others; the sum of weights with the background is one. */
static void test_alpha_extremes(void **state) {
    static const oit_color colors[] = {OIT_COLOR_8, OIT_COLOR_HALF, OIT_COLOR_FLOAT};
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    for (int i = 0; i < 3; ++i) {
        oit_desc desc = {.color = colors[i]};
        setting t;
        open_setting(&t, false, 8, 8, GL_RGBA32F, desc);
        oit_scene_init(s, 8, 8);
        oit_scene_sheets(s, 1000, 1e-4, false);
        for (int k = 0; k < 3; ++k)
            s->scene.background[k] = 0;
        check(&t, s, "1000 layers of 1e-4", i == 2 ? 1e-5 : 1e-4);
        oit_scene_drop(s);
        oit_scene_init(s, 8, 8);
        oit_scene_sheets(s, 12, 0.3, false);
        for (size_t k = 0; k < s->count; ++k)
            s->truths[k].alpha = k % 4 == 1 ? 0 : k == 7 ? 1 : 0.3;
        check(&t, s, "alpha 0 and 1", i == 2 ? 1e-5 : 1e-3);
        for (size_t k = 0; k < s->count; ++k) { /* white on white stays white */
            s->truths[k].alpha = 0.3;
            for (int c = 0; c < 3; ++c)
                s->truths[k].color[c] = 1;
        }
        check(&t, s, "weights sum to one", 1e-6);
        oit_scene_drop(s);
        close_setting(&t);
    }
    free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scenes_match_reference),
        cmocka_unit_test(test_float_scenes_match_reference),
        cmocka_unit_test(test_es_scenes_match_reference),
        cmocka_unit_test(test_draw_order_changes_nothing),
        cmocka_unit_test(test_bands_equal_the_whole),
        cmocka_unit_test(test_slabs_equal_the_whole),
        cmocka_unit_test(test_async_grows_and_reports),
        cmocka_unit_test(test_tail),
        cmocka_unit_test(test_fill_differs_from_count),
        cmocka_unit_test(test_host_sets_the_state),
        cmocka_unit_test(test_blend_operations),
        cmocka_unit_test(test_background_weight),
        cmocka_unit_test(test_reversed_depth),
        cmocka_unit_test(test_viewport_with_an_offset),
        cmocka_unit_test(test_host_shaders),
        cmocka_unit_test(test_state_is_restored),
        cmocka_unit_test(test_state_defaults),
        cmocka_unit_test(test_one_ulp_apart),
        cmocka_unit_test(test_alpha_extremes),
    };
    setvbuf(stdout, NULL, _IOLBF, 0);
    return cmocka_run_group_tests(tests, NULL, NULL);
}

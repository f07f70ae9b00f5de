/* gl_oit_stores.c: the stores of oit_buffers.h that are filled before they are counted, on a real driver: against the
 * reference in double, against OIT_STORE_EXACT bit for bit, and what they lose against a count on the CPU. */
#include "oit_scene.h"

/* ---- the setting ---- */

typedef struct setting {
    harness h;
    GLuint framebuffer, color, depth;
    int width, height;
} setting;

static int logged;

static void on_log(oit_log_level level, oit_result code, const char *text, void *user) {
    (void)user;
    logged += level != OIT_LOG_INFO;
    printf("    log %d: %s\n", (int)code, text);
}

static void open_setting(setting *t, bool es, int width, int height) {
    memset(t, 0, sizeof *t);
    harness_open(&t->h, es ? 310 : 430, es, NULL);
    t->width = width;
    t->height = height;
    glGenTextures(1, &t->color);
    glBindTexture(GL_TEXTURE_2D, t->color);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, width, height);
    glGenTextures(1, &t->depth);
    glBindTexture(GL_TEXTURE_2D, t->depth);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT32F, width, height);
    glBindTexture(GL_TEXTURE_2D, 0);
    glGenFramebuffers(1, &t->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, t->color, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, t->depth, 0);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    logged = 0;
}

static void close_setting(setting *t) {
    glDeleteFramebuffers(1, &t->framebuffer);
    glDeleteTextures(1, &t->color);
    glDeleteTextures(1, &t->depth);
    assert_int_equal(logged, 0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    harness_close(&t->h);
}

static oit_context *make_oit(const setting *t, oit_desc desc) {
    oit_result result;
    desc.get_proc = oit_scene_get_proc;
    desc.log_fn = on_log;
    desc.max_gl_version = t->h.context.es ? 310 : 430;
    oit_context *oit = oit_create(&desc, &result);
    if (!oit)
        fail_msg("oit_create: %s", oit_result_string(result));
    return oit;
}

/* Four floats a pixel, bottom row first. order and cut as in oit_scene_render and oit_frame. */
static float *draw(setting *t, oit_context *oit, oit_scene *s, const size_t *order, int cut) {
    float *picture = malloc(4 * sizeof *picture * (size_t)t->width * (size_t)t->height), far = 1;
    oit_frame frame = oit_scene_frame(s, t->framebuffer);
    frame.cut = cut;
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glViewport(0, 0, t->width, t->height);
    glClearColor((float)s->scene.background[0], (float)s->scene.background[1], (float)s->scene.background[2], 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDepthMask(GL_TRUE);
    glClearBufferfv(GL_DEPTH, 0, &far);
    glEnable(GL_DEPTH_TEST);
    oit_scene_draw_plain(s, t->h.context.es, false);
    glDisable(GL_DEPTH_TEST);
    oit_scene_render(s, oit, &frame, order);
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    glReadPixels(0, 0, t->width, t->height, GL_RGBA, GL_FLOAT, picture);
    return picture;
}

/* A frame of no pixels takes the report of the one before, which reading the picture has finished. */
static oit_report last_report(oit_context *oit) {
    oit_report report = {0};
    int32_t bound = oit_i_borrow_target(oit);
    oit_i_take_reports(oit, 0);
    oit_i_return_target(oit, bound);
    assert_int_equal(oit_get_report(oit, &report), OIT_OK);
    return report;
}

static bool same(const setting *t, const float *a, const float *b) {
    return memcmp(a, b, 4 * sizeof *a * (size_t)t->width * (size_t)t->height) == 0;
}

/* What OIT_STORE_EXACT makes of the scene. */
static float *exact_picture(setting *t, oit_scene *s, oit_desc desc) {
    oit_desc plain = {.color = desc.color, .fields = desc.fields, .host_words = desc.host_words};
    oit_context *oit = make_oit(t, plain);
    float *picture = draw(t, oit, s, NULL, 0);
    oit_destroy(oit);
    return picture;
}

static void shuffle(size_t *order, size_t count, uint32_t *state) {
    for (size_t i = 0; i < count; ++i)
        order[i] = i;
    for (size_t i = count - 1; i > 0; --i) {
        size_t other = (size_t)(oit_scene_random(state) * (double)(i + 1)), kept = order[i];
        order[i] = order[other];
        order[other] = kept;
    }
}

static const oit_store_kind stores[] = {OIT_STORE_PREDICT, OIT_STORE_LINKED, OIT_STORE_FETCH};
/* All; those with a pool. */
enum { ALL_STORES = sizeof stores / sizeof stores[0], STORES = ALL_STORES - 1 };

/* ---- nothing lost ---- */

/* Three frames: the first is counted where the store does that, the others are steady. */
static void check_scene(setting *t, oit_scene *s, oit_desc desc, const char *name, double tolerance) {
    size_t pixels = (size_t)s->scene.width * (size_t)s->scene.height;
    oit_truth *truth = malloc(pixels * sizeof *truth);
    double left_out = oit_truth_render(s, truth);
    float *expected = exact_picture(t, s, desc);
    oit_context *oit = make_oit(t, desc);
    for (int frame = 0; frame < 5; ++frame) {
        float *picture = draw(t, oit, s, NULL, 0);
        oit_report report = last_report(oit);
        double worst = 0;
        assert_true(report.frame == (uint64_t)frame + 1);
        assert_int_equal(report.extra, 0);
        if (report.lost_pixels > 0) { /* while the pool grows */
            assert_true(desc.fit == OIT_FIT_ASYNC && frame < 4);
        } else {
            if (!same(t, expected, picture))
                fail_msg("%s: store %d, frame %d is not the picture of OIT_STORE_EXACT", name, (int)desc.store, frame);
            for (size_t i = 0; i < pixels; ++i)
                for (size_t c = 0; c < 3 && !truth[i].left_out; ++c)
                    worst = fmax(worst, fabs((double)picture[4 * i + c] - truth[i].color[c]));
            assert_true(worst <= tolerance);
        }
        if (frame == 4)
            printf("    %-22s store %d fit %d: max %.2g, %4.1f %% left out, needed %u of %u, deepest %u, bands %u\n",
                   name, (int)desc.store, (int)desc.fit, worst, 100 * left_out, report.needed, report.capacity,
                   report.deepest, report.bands);
        free(picture);
    }
    assert_true(left_out <= 0.10);
    oit_destroy(oit);
    free(expected);
    free(truth);
}

static void check_scenes(bool es, oit_desc desc, double tolerance) {
    static const int layers[] = {1, 2, 8, 9, 33, 65, 200, 500};
    setting t;
    oit_scene *s = malloc(sizeof *s);
    open_setting(&t, es, 24, 16);
    for (size_t i = 0; i < sizeof layers / sizeof layers[0]; ++i) {
        char name[32];
        snprintf(name, sizeof name, "%d sheets", layers[i]);
        oit_scene_init(s, 24, 16);
        oit_scene_sheets(s, layers[i], layers[i] > 50 ? 0.02 : 0.2, false);
        check_scene(&t, s, desc, name, tolerance);
        oit_scene_drop(s);
    }
    close_setting(&t);
    open_setting(&t, es, 128, 128);
    oit_scene_init(s, 128, 128);
    oit_scene_random_balls(s, 6, 16, 0.4);
    s->truths[2].transparent = false;
    check_scene(&t, s, desc, "balls, one opaque", tolerance);
    oit_scene_drop(s);
    oit_scene_init(s, 128, 128);
    oit_scene_sheets(s, 12, 0.3, true);
    check_scene(&t, s, desc, "sheets that intersect", tolerance);
    oit_scene_drop(s);
    close_setting(&t);
    free(s);
}

static void test_scenes_match_reference_and_exact(void **state) {
    (void)state;
    for (int i = 0; i < 2 * ALL_STORES; ++i) {
        oit_desc desc = {.store = stores[i / 2], .fit = (oit_fit)(i % 2)};
        check_scenes(false, desc, 1.0 / 255);
    }
}

static void test_es_scenes_match_reference_and_exact(void **state) {
    (void)state;
    for (int i = 0; i < ALL_STORES; ++i) {
        oit_desc desc = {.store = stores[i], .color = OIT_COLOR_HALF, .fit = (oit_fit)(i % 2)};
        check_scenes(true, desc, 2.0 / 255);
    }
}

/* Coincident sheets and sheets that intersect, in other orders. */
static void test_draw_order_changes_nothing(void **state) {
    (void)state;
    const double depth[4] = {0.25, 0.25, 0.25, 0.25};
    oit_scene *s = malloc(sizeof *s);
    size_t order[OIT_SCENE_MAX];
    uint32_t random = 3;
    setting t;
    open_setting(&t, false, 64, 64);
    oit_scene_init(s, 64, 64);
    oit_scene_sheets(s, 40, 0.1, true);
    for (int i = 0; i < 40; ++i) {
        const double color[4] = {oit_scene_random(&random), oit_scene_random(&random), 0.5, 0.3};
        size_t at = oit_scene_quad(s, -1, -1, i % 3 ? 1 : 0.1, 1, depth, color);
        s->objects[at].part = i % 2 ? 7 : (uint32_t)i;
    }
    for (int i = 0; i < 2 * ALL_STORES; ++i) {
        oit_desc desc = {.store = stores[i / 2], .fit = (oit_fit)(i % 2), .fields = OIT_FIELD_PART};
        oit_context *oit = make_oit(&t, desc);
        float *expected = exact_picture(&t, s, desc);
        for (int run = 0; run < 8; ++run) {
            shuffle(order, s->count, &random);
            float *picture = draw(&t, oit, s, order, 0);
            if (run > 3 && !same(&t, expected, picture))
                fail_msg("store %d: another order, another picture", (int)desc.store);
            free(picture);
        }
        assert_int_equal(last_report(oit).lost, 0);
        free(expected);
        oit_destroy(oit);
    }
    oit_scene_drop(s);
    close_setting(&t);
    free(s);
}

/* ---- more than was expected ---- */

/* Few sheets, then many over half of the picture: OIT_FIT_WAIT shows them all, and fills twice for it. */
static void test_wait_fills_again(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, false, 32, 32);
    for (int i = 0; i < STORES; ++i) {
        oit_desc desc = {.store = stores[i]};
        oit_context *oit = make_oit(&t, desc);
        oit_scene_init(s, 32, 32);
        oit_scene_sheets(s, 3, 0.2, false);
        for (int run = 0; run < 3; ++run)
            free(draw(&t, oit, s, NULL, 0));
        assert_int_equal(last_report(oit).bands, 1);
        for (int k = 0; k < 40; ++k) {
            const double z[4] = {-0.5 + 0.01 * k, -0.5 + 0.01 * k, -0.5 + 0.02 * k, -0.5},
                         color[4] = {0.02 * k, 1, 0, 0.1};
            oit_scene_quad(s, -1, -1, 0, 1, z, color);
        }
        float *expected = exact_picture(&t, s, desc), *picture = draw(&t, oit, s, NULL, 0);
        oit_report report = last_report(oit);
        assert_true(same(&t, expected, picture));
        assert_int_equal(report.bands, 2);
        assert_int_equal(report.needed, 3 * 1024 + 40 * 512);
        assert_int_equal(report.deepest, 43);
        assert_int_equal(report.lost + report.lost_pixels + report.extra, 0);
        free(picture);
        picture = draw(&t, oit, s, NULL, 0); /* and now it is known */
        assert_true(same(&t, expected, picture));
        assert_int_equal(last_report(oit).bands, 1);
        free(picture);
        free(expected);
        oit_scene_drop(s);
        oit_destroy(oit);
    }
    close_setting(&t);
    free(s);
}

/* The tail as docs/oit_buffers.md has it, in double: optical depths add, colours are weighted by them. */
static void tail_truth(const oit_scene *s, size_t first, size_t count, double color[3]) {
    double thickness = 0, light[3] = {0, 0, 0};
    for (size_t i = first; i < first + count; ++i) {
        double depth = fmin(-log(1 - fmin(s->truths[i].alpha, 0.999999)), 11);
        thickness += depth;
        for (int k = 0; k < 3; ++k)
            light[k] += depth * s->truths[i].color[k];
    }
    for (int k = 0; k < 3; ++k)
        color[k] = light[k] * (1 - exp(-thickness)) / thickness + exp(-thickness) * s->scene.background[k];
}

/* OIT_STORE_PREDICT without waiting: two sheets, then eight more over the left half. Runs of three: there all ten are lost,
 * whichever three were first; the sums do not tell. At the border of the halves neighbours see more in the next frame. */
static void test_predict_async_loses_alike(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    float *first = NULL;
    size_t order[16];
    uint32_t random = 5;
    setting t;
    open_setting(&t, false, 32, 16);
    for (int run = 0; run < 6; ++run) {
        oit_desc desc = {.store = OIT_STORE_PREDICT, .fit = OIT_FIT_ASYNC, .color = OIT_COLOR_FLOAT};
        oit_context *oit = make_oit(&t, desc);
        double expected[3];
        oit_scene_init(s, 32, 16);
        oit_scene_sheets(s, 2, 0.2, false);
        for (int k = 0; k < 3; ++k)
            free(draw(&t, oit, s, NULL, 0));
        assert_int_equal(last_report(oit).lost, 0);
        for (int k = 0; k < 8; ++k) {
            const double z = 0.1 * k - 0.55, zs[4] = {z, z, z, z},
                         color[4] = {0.1 * k, 0.9 - 0.1 * k, 0.5, 0.05 + 0.03 * k};
            oit_scene_quad(s, -1, -1, 0, 1, zs, color);
        }
        shuffle(order, s->count, &random);
        float *picture = draw(&t, oit, s, run ? order : NULL, 0);
        oit_report report = last_report(oit);
        assert_int_equal(report.lost_pixels, 256);
        assert_int_equal(report.lost, 10 * 256);
        assert_int_equal(report.needed, 10 * 256 + 2 * 256);
        assert_int_equal(report.deepest, 10);
        tail_truth(s, 0, 10, expected);
        for (int k = 0; k < 3; ++k)
            assert_true(fabs((double)picture[k] - expected[k]) < 1e-5);
        if (first)
            assert_true(same(&t, first, picture));
        else
            first = picture;
        if (first != picture)
            free(picture);
        /* It is known in the next frame, on the GPU; the pool follows when the report has come back. */
        for (int k = 0; k < 2; ++k)
            free(draw(&t, oit, s, NULL, 0));
        picture = draw(&t, oit, s, NULL, 0);
        assert_int_equal(last_report(oit).lost, 0);
        float *whole = exact_picture(&t, s, desc);
        assert_true(same(&t, whole, picture));
        free(whole);
        free(picture);
        oit_scene_drop(s);
        oit_destroy(oit);
    }
    free(first);
    close_setting(&t);
    free(s);
}

/* The pool is too small for the runs: the pixels that the scan leaves out are lost, as with OIT_STORE_EXACT, in any order.
 * OIT_STORE_LINKED counts first as long as it knows that it cannot hold all. */
static void test_async_at_the_ceiling(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, false, 16, 16);
    for (int i = 0; i < STORES; ++i) {
        uint32_t random = 9, places = stores[i] == OIT_STORE_LINKED ? 500 : 1000; /* two records for a fragment */
        oit_desc desc = {.store = stores[i], .fit = OIT_FIT_ASYNC, .ceiling_bytes = 16 * 1000};
        oit_context *oit = make_oit(&t, desc);
        size_t order[16];
        float *first = NULL;
        oit_scene_init(s, 16, 16);
        oit_scene_sheets(s, 8, 0.2, false); /* runs of 8 when counted, of 9 when guessed */
        for (int run = 0; run < 8; ++run) {
            uint32_t lost = 256 - places / (run && stores[i] == OIT_STORE_PREDICT ? 9u : 8u);
            shuffle(order, s->count, &random);
            float *picture = draw(&t, oit, s, order, 0);
            oit_report report = last_report(oit);
            assert_int_equal(report.capacity, places);
            assert_int_equal(report.lost_pixels, lost);
            assert_int_equal(report.lost, 8 * lost);
            assert_int_equal(report.needed, 8 * 256);
            if (run == 1)
                first = picture;
            if (run > 1)
                assert_true(same(&t, first, picture));
            if (run != 1)
                free(picture);
        }
        free(first);
        oit_scene_drop(s);
        oit_destroy(oit);
    }
    close_setting(&t);
    free(s);
}

/* OIT_STORE_LINKED without waiting: two sheets, then eight more over the left half, which is more than the list holds. Which
 * records found place depends on the order of draws: so all pixels are lost, and none shows it. */
static void test_linked_async_loses_all_alike(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    float *first = NULL;
    size_t order[16];
    uint32_t random = 5;
    setting t;
    open_setting(&t, false, 32, 16);
    for (int run = 0; run < 6; ++run) {
        oit_desc desc = {
            .store = OIT_STORE_LINKED, .fit = OIT_FIT_ASYNC, .color = run % 2 ? OIT_COLOR_8 : OIT_COLOR_HALF};
        oit_context *oit = make_oit(&t, desc);
        double left[3], right[3];
        oit_scene_init(s, 32, 16);
        oit_scene_sheets(s, 2, 0.2, false);
        for (int k = 0; k < 3; ++k)
            free(draw(&t, oit, s, NULL, 0));
        assert_int_equal(last_report(oit).lost, 0);
        for (int k = 0; k < 8; ++k) {
            const double z = 0.1 * k - 0.55, zs[4] = {z, z, z, z},
                         color[4] = {0.1 * k, 0.9 - 0.1 * k, 0.5, 0.05 + 0.03 * k};
            oit_scene_quad(s, -1, -1, 0, 1, zs, color);
        }
        shuffle(order, s->count, &random);
        float *picture = draw(&t, oit, s, run > 1 ? order : NULL, 0);
        oit_report report = last_report(oit);
        assert_int_equal(report.needed, 10 * 256 + 2 * 256);
        assert_true(report.needed > report.capacity);
        assert_int_equal(report.lost_pixels, 512);
        assert_int_equal(report.lost, report.needed);
        tail_truth(s, 0, 10, left);
        tail_truth(s, 0, 2, right);
        for (int k = 0; k < 3; ++k) {
            assert_true(fabs((double)picture[k] - left[k]) < 1e-3);
            assert_true(fabs((double)picture[4 * 31 + k] - right[k]) < 1e-3);
        }
        if (run > 1 && run % 2 == 0)
            assert_true(same(&t, first, picture));
        if (run == 0)
            first = picture;
        else
            free(picture);
        picture = draw(&t, oit, s, NULL, 0);
        assert_int_equal(last_report(oit).lost, 0);
        float *whole = exact_picture(&t, s, desc);
        assert_true(same(&t, whole, picture));
        free(whole);
        free(picture);
        oit_scene_drop(s);
        oit_destroy(oit);
    }
    free(first);
    close_setting(&t);
    free(s);
}

/* Sums beyond 32 bits: 400 opaque layers of one pixel have an optical depth of 4,400, which is 7.4 * 10^10 units. Their
 * colour is the mean of all. */
static void test_tail_does_not_overflow(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, false, 4, 4);
    for (int i = 0; i < STORES; ++i) {
        oit_desc desc = {.store = stores[i], .fit = OIT_FIT_ASYNC, .ceiling_bytes = 32};
        oit_context *oit = make_oit(&t, desc);
        double expected[3];
        oit_scene_init(s, 4, 4);
        oit_scene_sheets(s, 400, 1.0, false);
        tail_truth(s, 0, 400, expected);
        for (int run = 0; run < 3; ++run) { /* the sums are cleared in between */
            float *picture = draw(&t, oit, s, NULL, 0);
            for (int p = 0; p < 16; ++p)
                for (int k = 0; k < 3; ++k) /* colours in 10 bits */
                    assert_true(fabs((double)picture[4 * p + k] - expected[k]) < 1e-3);
            assert_int_equal(last_report(oit).lost, 400 * 16);
            free(picture);
        }
        oit_scene_drop(s);
        oit_destroy(oit);
    }
    close_setting(&t);
    free(s);
}

/* A surface that moves by a pixel a frame stays within what its neighbours had: nothing is lost, one geometry pass a frame. */
static void test_predict_follows_motion(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, false, 64, 64);
    for (int fit = 0; fit < 2; ++fit) {
        oit_desc desc = {.store = OIT_STORE_PREDICT, .fit = (oit_fit)fit};
        oit_context *oit = make_oit(&t, desc);
        for (int frame = 0; frame < 12; ++frame) {
            int shift = frame < 3 ? 0 : frame - 3;
            double left = -0.5 + shift / 32.0;
            oit_scene_init(s, 64, 64);
            for (int k = 0; k < 9; ++k) {
                const double z = 0.1 * k - 0.5, zs[4] = {z, z, z, z}, color[4] = {0.1 * k, 0.5, 0.5, 0.2};
                oit_scene_quad(s, left, left, left + 0.5, left + 0.5, zs, color);
            }
            float *picture = draw(&t, oit, s, NULL, 0);
            oit_report report = last_report(oit);
            if (frame >= 3) {
                assert_int_equal(report.needed, 9 * 256);
                assert_int_equal(report.lost, 0);
                assert_int_equal(report.bands, 1);
            }
            free(picture);
            oit_scene_drop(s);
        }
        oit_destroy(oit);
    }
    close_setting(&t);
    free(s);
}

/* headroom: six sheets become nine. With sixteen sixteenths they fit; with the default, two, one more would. */
static void test_headroom(void **state) {
    static const int rooms[] = {-1, 0, 2, 7, 8, 16};
    static const uint32_t places[] = {6, 7, 7, 9, 9, 12};
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, false, 16, 16);
    for (int i = 0; i < 6; ++i) {
        oit_desc desc = {.store = OIT_STORE_PREDICT, .fit = OIT_FIT_ASYNC, .headroom = rooms[i]};
        oit_context *oit = make_oit(&t, desc);
        oit_scene_init(s, 16, 16);
        oit_scene_sheets(s, 6, 0.2, false);
        for (int run = 0; run < 4; ++run)
            free(draw(&t, oit, s, NULL, 0));
        last_report(oit);
        assert_int_equal(oit->places, 256 * places[i]);
        for (int k = 0; k < 3; ++k) {
            const double z[4] = {0.8, 0.8, 0.8, 0.8}, color[4] = {0.3 * k, 0.5, 0.5, 0.2};
            oit_scene_quad(s, -1, -1, 1, 1, z, color);
        }
        free(draw(&t, oit, s, NULL, 0));
        assert_int_equal(last_report(oit).lost_pixels, places[i] < 9 ? 256 : 0);
        oit_scene_drop(s);
        oit_destroy(oit);
    }
    close_setting(&t);
    free(s);
}

/* ---- layers by framebuffer fetch ---- */

/* Ties at the border of a pass: 20 sheets alike in all, among others of the same depth and of others, in any order. */
static void test_fetched_ties(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    size_t order[64];
    uint32_t random = 11;
    setting t;
    open_setting(&t, false, 16, 16);
    for (int blend = 0; blend < 2; ++blend) {
        oit_desc desc = {.store = OIT_STORE_FETCH, .fields = blend ? OIT_FIELD_BLEND : OIT_FIELD_PART};
        oit_context *oit = make_oit(&t, desc);
        oit_scene_init(s, 16, 16);
        oit_scene_sheets(s, 9, 0.2, true);
        for (int k = 0; k < 32; ++k) {
            const double z[4] = {0.1, 0.1, 0.1, 0.1};
            const double color[4] = {k < 20 ? 0.5 : oit_scene_random(&random), 0.3, 0.7, 0.05};
            size_t at = oit_scene_quad(s, -1, -1, 1, 1, z, color);
            s->objects[at].part = k < 20 ? 3 : (uint32_t)k % 3;
            s->objects[at].blend = k < 20 ? OIT_BLEND_OVER : (uint32_t)k % 3;
        }
        float *expected = exact_picture(&t, s, desc);
        for (int run = 0; run < 5; ++run) {
            shuffle(order, s->count, &random);
            float *picture = draw(&t, oit, s, run ? order : NULL, 0);
            assert_true(same(&t, expected, picture));
            assert_int_equal(last_report(oit).bands, 6);
            free(picture);
        }
        free(expected);
        oit_scene_drop(s);
        oit_destroy(oit);
    }
    close_setting(&t);
    free(s);
}

/* Without waiting, and more layers than in the frame before: the seven nearest are there, the others are counted. */
static void test_fetch_async_loses_the_farthest(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    size_t order[16];
    uint32_t random = 5;
    setting t;
    oit_desc desc = {.store = OIT_STORE_FETCH, .fit = OIT_FIT_ASYNC};
    open_setting(&t, false, 32, 16);
    for (int run = 0; run < 4; ++run) {
        oit_context *oit = make_oit(&t, desc);
        oit_scene_init(s, 32, 16);
        for (int k = 0; k < 7; ++k) {
            const double z = -0.9 + 0.1 * k, zs[4] = {z, z, z, z}, color[4] = {0.1 * k, 0.5, 0.9 - 0.1 * k, 0.2};
            oit_scene_quad(s, -1, -1, 1, 1, zs, color);
        }
        float *seven = exact_picture(&t, s, desc);
        for (int k = 0; k < 3; ++k) {
            const double z = 0.1 * k, zs[4] = {z, z, z, z}, color[4] = {1, 0.1 * k, 0, 0.4};
            oit_scene_quad(s, -1, -1, 0, 1, zs, color);
        }
        shuffle(order, s->count, &random);
        float *picture = draw(&t, oit, s, order, 0);
        oit_report report = last_report(oit);
        assert_int_equal(report.lost_pixels, 256);
        assert_int_equal(report.lost, 3 * 256);
        assert_int_equal(report.deepest, 10);
        assert_true(same(&t, seven, picture));
        free(picture);
        free(seven);
        float *expected = exact_picture(&t, s, desc);
        picture = draw(&t, oit, s, order, 0);
        assert_int_equal(last_report(oit).lost, 0);
        assert_true(same(&t, expected, picture));
        free(picture);
        free(expected);
        oit_scene_drop(s);
        oit_destroy(oit);
    }
    close_setting(&t);
    free(s);
}

/* ---- when there is nothing to go by ---- */

/* oit_frame.cut: the frame is counted first, and nothing is lost however much it differs. Without it this one loses. */
static void test_cut_counts_first(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, false, 16, 16);
    for (int cut = 0; cut < 2; ++cut) {
        oit_desc desc = {.store = OIT_STORE_PREDICT, .fit = OIT_FIT_ASYNC};
        oit_context *oit = make_oit(&t, desc);
        oit_scene_init(s, 16, 16);
        oit_scene_sheets(s, 40, 0.1, false);
        for (int run = 0; run < 3; ++run)
            free(draw(&t, oit, s, NULL, 0));
        s->scene.object_count = 2; /* a while of little */
        for (size_t k = 2; k < s->count; ++k)
            s->truths[k].transparent = false;
        size_t all = s->count;
        s->count = 2;
        for (int run = 0; run < 3; ++run)
            free(draw(&t, oit, s, NULL, 0));
        s->count = s->scene.object_count = all;
        for (size_t k = 2; k < s->count; ++k)
            s->truths[k].transparent = true;
        float *expected = exact_picture(&t, s, desc), *picture = draw(&t, oit, s, NULL, cut);
        oit_report report = last_report(oit);
        assert_int_equal(report.lost_pixels, cut ? 0 : 256);
        assert_int_equal(same(&t, expected, picture), cut);
        free(expected);
        free(picture);
        oit_scene_drop(s);
        oit_destroy(oit);
    }
    close_setting(&t);
    free(s);
}

/* Frames of changing size, a frame ended early, and buffers given back: no counts of another picture are taken for ours. */
static void test_resizes_and_broken_frames(void **state) {
    static const int sizes[][2] = {{32, 16}, {16, 32}, {32, 16}, {32, 16}, {7, 31}, {32, 32}, {32, 32}, {32, 32}};
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, false, 32, 32);
    for (int i = 0; i < 2 * ALL_STORES; ++i) {
        oit_desc desc = {.store = stores[i / 2], .fit = (oit_fit)(i % 2)};
        oit_context *oit = make_oit(&t, desc);
        for (int frame = 0; frame < 8; ++frame) {
            oit_pass pass;
            oit_scene_init(s, sizes[frame][0], sizes[frame][1]);
            oit_scene_random_balls(s, 5, 12, 0.4);
            float *expected = exact_picture(&t, s, desc), *picture = draw(&t, oit, s, NULL, 0);
            uint32_t lost = last_report(oit).lost;
            if (desc.fit == OIT_FIT_WAIT || frame == 7) /* without waiting, the pool follows */
                assert_int_equal(lost, 0);
            if (lost == 0)
                assert_true(same(&t, expected, picture));
            free(expected);
            free(picture);
            if (frame % 3 == 1) { /* not drawn to the end */
                oit_frame f = oit_scene_frame(s, t.framebuffer);
                oit_scene_expect(oit_begin(oit, &f), "oit_begin");
                while (oit_next_pass(oit, &pass) && frame != 4)
                    oit_scene_draw(s, oit, &pass, NULL);
                oit_scene_expect(oit_end(oit), "oit_end");
            }
            if (frame == 6)
                assert_int_equal(oit_release(oit), OIT_OK);
            oit_scene_drop(s);
        }
        oit_destroy(oit);
    }
    close_setting(&t);
    free(s);
}

/* Over the ceiling in bands, and over a storage block in slabs. */
static void test_bands_and_slabs(void **state) {
    static const int64_t ceilings[] = {64 * 1024, 16 * 1024, 4 * 1024, 0};
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    setting t;
    open_setting(&t, false, 48, 40);
    for (int i = 0; i < 4 * STORES; ++i) {
        oit_desc desc = {.store = stores[i / 4], .ceiling_bytes = ceilings[i % 4]};
        desc.max_block_bytes = ceilings[i % 4] ? 0 : 9000;
        oit_context *oit = make_oit(&t, desc);
        oit_scene_init(s, 48, 40);
        oit_scene_random_balls(s, 8, 16, 0.3);
        oit_scene_sheets(s, 5, 0.2, false);
        float *expected = exact_picture(&t, s, desc);
        for (int run = 0; run < 3; ++run) {
            float *picture = draw(&t, oit, s, NULL, 0);
            oit_report report = last_report(oit);
            if (!same(&t, expected, picture))
                fail_msg("store %d, ceiling %lld, run %d", (int)desc.store, (long long)ceilings[i % 4], run);
            assert_true(report.bands > 1);
            assert_int_equal(report.lost + report.extra, 0);
            free(picture);
        }
        free(expected);
        oit_scene_drop(s);
        oit_destroy(oit);
    }
    close_setting(&t);
    free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_scenes_match_reference_and_exact),
        cmocka_unit_test(test_es_scenes_match_reference_and_exact),
        cmocka_unit_test(test_draw_order_changes_nothing),
        cmocka_unit_test(test_wait_fills_again),
        cmocka_unit_test(test_predict_async_loses_alike),
        cmocka_unit_test(test_async_at_the_ceiling),
        cmocka_unit_test(test_linked_async_loses_all_alike),
        cmocka_unit_test(test_tail_does_not_overflow),
        cmocka_unit_test(test_predict_follows_motion),
        cmocka_unit_test(test_headroom),
        cmocka_unit_test(test_fetched_ties),
        cmocka_unit_test(test_fetch_async_loses_the_farthest),
        cmocka_unit_test(test_cut_counts_first),
        cmocka_unit_test(test_resizes_and_broken_frames),
        cmocka_unit_test(test_bands_and_slabs),
    };
    setvbuf(stdout, NULL, _IOLBF, 0);
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* gl_oit_cross.c: what is tested with one store elsewhere, with each of the others: coverage, adaptive alpha, picks, depth of
 * the composite, blends, host words, reversed depth, offsets, slabs; and edges that a review found. OIT_STORE_EXACT, which
 * other tests hold to the rays, is the truth, bit for bit. */
#include "oit_setting.h"

enum { SIZE = 24 };

/* A frame of ours: where, and what is asked for beside the picture. */
typedef struct ask {
    int x, y, samples;
    bool es, reversed;
    oit_depth depth;
    GLenum format;
} ask;

static const oit_store_kind others[] = {OIT_STORE_PREDICT, OIT_STORE_LINKED, OIT_STORE_BUDGET, OIT_STORE_BUCKETED,
                                        OIT_STORE_FETCH};
enum { OTHERS = sizeof others / sizeof others[0], POOLED = OTHERS - 1 };

static void make_balls(oit_scene *s) {
    oit_scene_init(s, SIZE, SIZE);
    oit_scene_random_balls(s, 6, 12, 0.35);
    s->truths[2].transparent = false;
}

static void make_blends(oit_scene *s) {
    make_balls(s);
    for (size_t i = 0; i < s->count; ++i)
        s->objects[i].blend = (uint32_t)(i % 3);
}

static oit_report report_of(oit_context *oit) {
    oit_report report = {0};
    glFinish();
    int32_t bound = oit_i_borrow_target(oit);
    oit_i_take_reports(oit, 0);
    oit_i_return_target(oit, bound);
    assert_int_equal(oit_get_report(oit, &report), OIT_OK);
    return report;
}

/* The last of some frames, resolved where it is multisampled; with depths, the depth of the composite behind it. NULL where
 * pixels were still lost. */
static float *picture_of(oit_desc desc, const ask *a, void (*make)(oit_scene *s), int frames) {
    int size = SIZE + (a->x > a->y ? a->x : a->y);
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    float *picture = NULL;
    uint32_t lost = 0;
    desc.reversed_z = a->reversed;
    oit_setting_open(&t, a->es, size, size, a->samples, a->format ? a->format : GL_RGBA32F, desc);
    GLuint plain = oit_setting_texture(size, size, 0, a->format ? a->format : GL_RGBA32F);
    GLuint resolved = oit_setting_framebuffer(plain, 0, 0);
    if (a->reversed)
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    make(s);
    s->reversed = a->reversed;
    for (int i = 0; i < frames; ++i) {
        oit_frame frame = oit_scene_frame(s, t.framebuffer);
        frame.x = a->x;
        frame.y = a->y;
        frame.depth = a->depth;
        frame.depth_framebuffer = t.framebuffer;
        free(picture);
        oit_setting_clear(&t, s);
        oit_scene_render(s, t.oit, &frame, NULL);
        lost = report_of(t.oit).lost_pixels;
        glBindFramebuffer(GL_READ_FRAMEBUFFER, t.framebuffer);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved);
        glBlitFramebuffer(0, 0, size, size, 0, 0, size, size, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        picture = malloc(5 * (size_t)size * (size_t)size * sizeof *picture);
        memset(picture, 0, 5 * (size_t)size * (size_t)size * sizeof *picture);
        glBindFramebuffer(GL_FRAMEBUFFER, resolved);
        glReadPixels(0, 0, size, size, GL_RGBA, GL_FLOAT, picture);
        glBindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
        if (a->depth)
            glReadPixels(0, 0, size, size, GL_DEPTH_COMPONENT, GL_FLOAT, picture + 4 * size * size);
    }
    if (a->reversed)
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glDeleteFramebuffers(1, &resolved);
    glDeleteTextures(1, &plain);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
    if (lost)
        fail_msg("store %d fit %d: %u pixels are lost in frame %d", (int)desc.store, (int)desc.fit, lost, frames);
    return picture;
}

/* The same bits from that store as from OIT_STORE_EXACT. */
static void check_like_exact(oit_desc desc, const ask *a, void (*make)(oit_scene *s), const char *name) {
    oit_desc exact = desc;
    int size = SIZE + (a->x > a->y ? a->x : a->y);
    exact.store = OIT_STORE_EXACT;
    exact.fit = OIT_FIT_WAIT;
    exact.max_block_bytes = 0;
    float *expected = picture_of(exact, a, make, 1), *picture = picture_of(desc, a, make, 4);
    int differing = 0;
    for (int i = 0; i < size * size; ++i)
        differing += memcmp(expected + 4 * i, picture + 4 * i, 4 * sizeof *picture) != 0;
    if (memcmp(expected, picture, 5 * sizeof *picture * (size_t)size * (size_t)size))
        fail_msg("%s: store %d fit %d: %d colours differ from OIT_STORE_EXACT's", name, (int)desc.store, (int)desc.fit,
                 differing);
    free(expected);
    free(picture);
}

/* ---- what goes with each store ---- */

static void test_coverage_with_each_store(void **state) {
    (void)state;
    for (int i = 0; i < POOLED; ++i) {
        oit_desc desc = {.store = others[i], .fields = OIT_FIELD_COVERAGE | OIT_FIELD_PART};
        const ask a = {.samples = i % 2 ? 2 : 4};
        desc.sample_order = i == 1;
        desc.fit = i == 0 ? OIT_FIT_ASYNC : OIT_FIT_WAIT;
        check_like_exact(desc, &a, make_balls, "coverage");
    }
}

static void test_adaptive_alpha_where_it_waits(void **state) {
    (void)state;
    for (int i = 0; i < 2; ++i)
        for (int bands = 0; bands < 2; ++bands) {
            oit_desc desc = {.store = others[i], .alpha_law = OIT_ALPHA_ADAPTIVE};
            const ask a = {0};
            desc.ceiling_bytes = bands ? 16 * 400 : 0;
            check_like_exact(desc, &a, make_balls, "adaptive alpha");
        }
}

static void test_blends_with_each_store(void **state) {
    (void)state;
    for (int i = 0; i < OTHERS; ++i)
        for (int es = 0; es < 1 + (i % 2 == 0); ++es) {
            oit_desc desc = {.store = others[i], .fields = OIT_FIELD_BLEND};
            ask a = {.es = es != 0, .format = es ? GL_RGBA16F : GL_RGBA32F};
            desc.fit = i % 2 ? OIT_FIT_ASYNC : OIT_FIT_WAIT;
            if (desc.store == OIT_STORE_BUCKETED)
                desc.fields |= OIT_FIELD_PART;
            check_like_exact(desc, &a, make_blends, "blends");
        }
}

/* In a corner of a larger target, with near at 1; in slabs too, and with all that a depth of the composite needs. */
static void test_places_with_each_store(void **state) {
    (void)state;
    for (int i = 0; i < OTHERS; ++i)
        for (int slabs = 0; slabs < 2; ++slabs) {
            oit_desc desc = {.store = others[i], .fields = OIT_FIELD_PART};
            ask a = {.x = 5, .y = 9, .reversed = true, .depth = OIT_DEPTH_MEDIAN};
            if (desc.store == OIT_STORE_FETCH)
                a.depth = OIT_DEPTH_NONE;
            if (desc.store == OIT_STORE_BUDGET || desc.store == OIT_STORE_BUCKETED)
                desc.budget_bytes = 1 << 20; /* five balls are ten layers; k is 90 and more */
            else
                desc.fit = slabs ? OIT_FIT_WAIT : OIT_FIT_ASYNC;
            desc.max_block_bytes = !slabs                          ? 0
                                   : desc.budget_bytes             ? 400000
                                   : desc.store == OIT_STORE_FETCH ? 20000
                                                                   : 8000;
            check_like_exact(desc, &a, make_balls, slabs ? "offset, in slabs" : "offset");
        }
}

/* ---- picks ---- */

static oit_pick pick_of(oit_setting *t, oit_scene *s, const oit_frame *frame, int x, int y, int layer) {
    oit_pick pick;
    memset(&pick, 0, sizeof pick);
    oit_setting_clear(t, s);
    oit_scene_expect(oit_pick_begin(t->oit, x, y, layer), "oit_pick_begin");
    oit_scene_render(s, t->oit, frame, NULL);
    oit_scene_expect(oit_pick_result(t->oit, 1, &pick), "oit_pick_result");
    pick.frame = 0;
    return pick;
}

static void test_picks_with_each_store(void **state) {
    (void)state;
    oit_pick truth[40];
    for (int i = -1; i < POOLED; ++i) {
        oit_desc desc = {.store = i < 0 ? OIT_STORE_EXACT : others[i], .fields = OIT_FIELD_ALL & ~32u, .host_words = 3};
        oit_scene *s = malloc(sizeof *s);
        oit_setting t;
        int n = 0, found = 0;
        desc.fit = i >= 0 && i < 2 ? OIT_FIT_ASYNC : OIT_FIT_WAIT;
        oit_setting_open(&t, false, SIZE, SIZE, 0, GL_RGBA32F, desc);
        make_blends(s);
        oit_frame frame = oit_scene_frame(s, t.framebuffer);
        for (int k = 0; k < 3; ++k) /* those that never wait learn what they need */
            pick_of(&t, s, &frame, 0, 0, 0);
        for (int at = 0; at < 8; ++at)
            for (int layer = 0; layer < 5; ++layer, ++n) {
                oit_pick pick = pick_of(&t, s, &frame, 6 + at, 8 + at, layer);
                found += pick.found;
                if (i < 0)
                    truth[n] = pick;
                else
                    assert_memory_equal(&truth[n], &pick, sizeof pick);
            }
        printf("    store %d: %d fragments picked\n", (int)desc.store, found);
        assert_true(found > 12);
        oit_scene_drop(s);
        oit_setting_close(&t);
        free(s);
    }
}

/* Where the run did not fit there is no fragment, but how many there are is known. */
static void test_picks_of_lost_pixels(void **state) {
    (void)state;
    for (int i = -1; i < 2; ++i) {
        oit_desc desc = {.store = i < 0 ? OIT_STORE_EXACT : others[i], .fit = OIT_FIT_ASYNC, .ceiling_bytes = 64};
        oit_scene *s = malloc(sizeof *s);
        oit_setting t;
        oit_setting_open(&t, false, 8, 8, 0, GL_RGBA32F, desc);
        oit_scene_init(s, 8, 8);
        oit_scene_sheets(s, 5, 0.2, false);
        oit_frame frame = oit_scene_frame(s, t.framebuffer);
        for (int run = 0; run < 3; ++run) { /* PREDICT: counted, then guessed */
            oit_pick pick = pick_of(&t, s, &frame, 7, 7, 0);
            assert_int_equal(pick.found, 0);
            assert_int_equal(pick.layers, 5);
        }
        oit_scene_drop(s);
        oit_setting_close(&t);
        free(s);
    }
}

/* ---- what OIT_STORE_FETCH refuses ---- */

static void test_fetch_refuses_what_it_has_not(void **state) {
    (void)state;
    oit_desc desc = {.store = OIT_STORE_FETCH};
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    oit_result result;
    oit_setting_open(&t, false, SIZE, SIZE, 0, GL_RGBA32F, desc);
    make_balls(s);
    t.quiet = true;
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    assert_int_equal(oit_pick_begin(t.oit, 1, 1, 0), OIT_INVALID_ARGUMENT);
    frame.depth = OIT_DEPTH_FIRST;
    assert_int_equal(oit_begin(t.oit, &frame), OIT_INVALID_ARGUMENT);
    frame.depth = OIT_DEPTH_NONE;
    for (int i = 0; i < 3; ++i) {
        oit_desc bad = {.store = OIT_STORE_FETCH, .get_proc = oit_scene_get_proc};
        bad.fields = i == 0 ? OIT_FIELD_COVERAGE : 0;
        bad.color = i == 1 ? OIT_COLOR_FLOAT : OIT_COLOR_8;
        bad.alpha_law = i == 2 ? OIT_ALPHA_ADAPTIVE : OIT_ALPHA_CONSTANT;
        assert_null(oit_create(&bad, &result));
        assert_int_equal(result, OIT_INVALID_ARGUMENT);
    }
    /* A depth that is a layer of an array cannot be shared; the frame would not see what hides it. */
    GLuint array, target;
    glGenTextures(1, &array);
    glBindTexture(GL_TEXTURE_2D_ARRAY, array);
    glTexStorage3D(GL_TEXTURE_2D_ARRAY, 1, GL_DEPTH_COMPONENT32F, SIZE, SIZE, 2);
    target = oit_setting_framebuffer(t.color, 0, 0);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, array, 0, 1);
    frame.framebuffer = target;
    assert_int_equal(oit_begin(t.oit, &frame), OIT_NO_FETCH);
    assert_int_equal(glGetError(), GL_INVALID_OPERATION); /* which is how GL refuses it */
    t.h.debug_messages = 0;
    /* The next frame works, and so does one whose viewport lies outside of the target. */
    frame.framebuffer = t.framebuffer;
    for (int i = 0; i < 2; ++i) {
        frame.x = frame.y = i ? -3 * SIZE : 0;
        oit_setting_clear(&t, s);
        oit_scene_render(s, t.oit, &frame, NULL);
        assert_int_equal(glGetError(), GL_NO_ERROR);
    }
    frame.x = 32768;
    assert_int_equal(oit_begin(t.oit, &frame), OIT_INVALID_ARGUMENT);
    glDeleteFramebuffers(1, &target);
    glDeleteTextures(1, &array);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* Totals begin from zero in each frame, of images smaller than the totals too. */
static void test_totals_of_tiny_images(void **state) {
    (void)state;
    for (int i = -1; i < OTHERS; ++i)
        for (int size = 1; size < 4; ++size) {
            oit_desc desc = {.store = i < 0 ? OIT_STORE_EXACT : others[i], .fields = OIT_FIELD_PART};
            oit_scene *s = malloc(sizeof *s);
            oit_setting t;
            oit_setting_open(&t, false, size, size, 0, GL_RGBA32F, desc);
            for (int run = 0; run < 3; ++run) {
                uint32_t layers = run == 1 ? 20 : 3;
                oit_scene_init(s, size, size);
                oit_scene_sheets(s, (int)layers, 0.1, false);
                oit_frame frame = oit_scene_frame(s, t.framebuffer);
                oit_setting_clear(&t, s);
                oit_scene_render(s, t.oit, &frame, NULL);
                oit_report report = report_of(t.oit);
                assert_int_equal(report.needed, layers * (uint32_t)(size * size));
                assert_int_equal(report.deepest, layers);
                assert_int_equal(report.lost + report.extra, 0);
                if (desc.store == OIT_STORE_FETCH)
                    assert_int_equal(report.bands, run == 1 ? 3 : 1);
                oit_scene_drop(s);
            }
            oit_setting_close(&t);
            free(s);
        }
}

/* ---- what is lost ---- */

/* In slabs what each of them loses is counted, and what is lost comes from the tail. */
static void test_losses_of_all_slabs(void **state) {
    (void)state;
    for (int i = -1; i < 2; ++i) {
        oit_desc desc = {.store = i < 0 ? OIT_STORE_EXACT : others[i], .fit = OIT_FIT_ASYNC};
        oit_scene *s = malloc(sizeof *s);
        oit_setting t;
        uint32_t records = desc.store == OIT_STORE_LINKED ? 2 : 1;
        desc.max_block_bytes = 4000;
        desc.ceiling_bytes = 16 * 50 * records;
        oit_setting_open(&t, false, SIZE, SIZE, 0, GL_RGBA32F, desc);
        oit_scene_init(s, SIZE, SIZE);
        oit_scene_sheets(s, 4, 0.2, false);
        oit_frame frame = oit_scene_frame(s, t.framebuffer);
        for (int run = 0; run < 2; ++run) {
            oit_setting_clear(&t, s);
            oit_scene_render(s, t.oit, &frame, NULL);
            oit_report report = report_of(t.oit);
            uint32_t slabs = ((uint32_t)SIZE + (uint32_t)t.oit->rows - 1) / (uint32_t)t.oit->rows;
            assert_true(slabs > 3);
            assert_int_equal(report.lost_pixels, SIZE * SIZE - slabs * (50 / 4));
            assert_int_equal(report.lost, 4 * report.lost_pixels);
        }
        oit_scene_drop(s);
        oit_setting_close(&t);
        free(s);
    }
}

/* Premultiplied light without alpha, as particles give it, is as bright in the tail as in the run. */
static void test_light_without_alpha_in_the_tail(void **state) {
    (void)state;
    for (int i = -1; i < 3; ++i) {
        oit_desc desc = {.store = i < 0 ? OIT_STORE_EXACT : others[i], .fields = OIT_FIELD_BLEND, .premultiplied = 1};
        oit_scene *s = malloc(sizeof *s);
        oit_setting t;
        const double z[4] = {0, 0, 0, 0}, thin[4] = {0.5, 1, 0.25, 0.0625};
        desc.color = OIT_COLOR_FLOAT;
        desc.fit = i < 2 ? OIT_FIT_ASYNC : OIT_FIT_WAIT;
        desc.ceiling_bytes = i < 2 ? 64 : 0;
        desc.budget_bytes = i < 2 ? 0 : 1; /* no room for one */
        oit_setting_open(&t, false, 8, 8, 0, GL_RGBA32F, desc);
        oit_scene_init(s, 8, 8);
        for (int k = 0; k < 3; ++k)
            s->objects[oit_scene_quad(s, -1, -1, 1, 1, z, thin)].blend = OIT_BLEND_ADD;
        for (int k = 0; k < 3; ++k)
            s->scene.background[k] = 0.1;
        oit_frame frame = oit_scene_frame(s, t.framebuffer);
        oit_setting_clear(&t, s);
        oit_scene_render(s, t.oit, &frame, NULL);
        assert_int_equal(report_of(t.oit).lost > 0, 1);
        float *picture = oit_setting_read(&t, t.framebuffer);
        for (int k = 0; k < 3; ++k) /* the last pixel is a lost one */
            assert_true(fabs((double)picture[4 * 63 + k] - (0.1 + 3 * 0.0625 * thin[k])) < 1e-5);
        free(picture);
        oit_scene_drop(s);
        oit_setting_close(&t);
        free(s);
    }
}

/* ---- what only a deep run, or a used one, shows ---- */

/* Layers of one depth by their parts, each with its own colour, among so many that the run is deep: against the formula. */
static void test_coincident_layers_of_deep_runs(void **state) {
    (void)state;
    const oit_desc desc = {.color = OIT_COLOR_FLOAT, .fields = OIT_FIELD_PART};
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    double expected[3] = {1, 1, 1};
    oit_setting_open(&t, false, 4, 4, 0, GL_RGBA32F, desc);
    oit_scene_init(s, 4, 4);
    for (int i = 59; i >= 0; --i) { /* back to front: depths in steps of five, parts ascend */
        const double d = -0.9 + 0.03 * (i / 5 * 5), z[4] = {d, d, d, d};
        const double color[4] = {i % 3 * 0.5, i % 7 / 7.0, i % 5 * 0.25, 0.04 + 0.002 * i};
        s->objects[oit_scene_quad(s, -1, -1, 1, 1, z, color)].part = (uint32_t)i;
        for (int k = 0; k < 3; ++k)
            expected[k] = color[3] * color[k] + (1 - color[3]) * expected[k];
    }
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    oit_setting_clear(&t, s);
    oit_scene_render(s, t.oit, &frame, NULL);
    float *picture = oit_setting_read(&t, t.framebuffer);
    for (int i = 0; i < 16; ++i)
        for (int k = 0; k < 3; ++k)
            assert_true(fabs((double)picture[4 * i + k] - expected[k]) < 1e-5);
    free(picture);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* What was counted and does not come: the records of the frame before, which lie there still, are not composed. */
static void test_fewer_than_counted(void **state) {
    (void)state;
    for (int depth = 4; depth < 50; depth += 40) {
        const oit_desc desc = {.color = OIT_COLOR_FLOAT};
        oit_scene *s = malloc(sizeof *s);
        oit_setting t;
        oit_pass pass;
        float *pictures[2];
        oit_setting_open(&t, false, 4, 4, 0, GL_RGBA32F, desc);
        oit_scene_init(s, 4, 4);
        oit_scene_sheets(s, depth, 0.1, false);
        oit_frame frame = oit_scene_frame(s, t.framebuffer);
        for (int run = 0; run < 3; ++run) {  /* all; all but one in the fill; all but one */
            s->truths[1].transparent = true; /* or it would be drawn with what is opaque */
            oit_setting_clear(&t, s);
            oit_scene_expect(oit_begin(t.oit, &frame), "oit_begin");
            while (oit_next_pass(t.oit, &pass)) {
                s->truths[1].transparent = run == 0 || (run == 1 && pass.kind == OIT_PASS_COUNT);
                oit_scene_draw(s, t.oit, &pass, NULL);
            }
            oit_scene_expect(oit_compose(t.oit), "oit_compose");
            oit_scene_expect(oit_end(t.oit), "oit_end");
            if (run)
                pictures[run - 1] = oit_setting_read(&t, t.framebuffer);
        }
        assert_memory_equal(pictures[0], pictures[1], 4 * 16 * sizeof(float));
        free(pictures[0]);
        free(pictures[1]);
        oit_scene_drop(s);
        oit_setting_close(&t);
        free(s);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_coverage_with_each_store),
        cmocka_unit_test(test_adaptive_alpha_where_it_waits),
        cmocka_unit_test(test_blends_with_each_store),
        cmocka_unit_test(test_places_with_each_store),
        cmocka_unit_test(test_picks_with_each_store),
        cmocka_unit_test(test_picks_of_lost_pixels),
        cmocka_unit_test(test_fetch_refuses_what_it_has_not),
        cmocka_unit_test(test_totals_of_tiny_images),
        cmocka_unit_test(test_losses_of_all_slabs),
        cmocka_unit_test(test_light_without_alpha_in_the_tail),
        cmocka_unit_test(test_coincident_layers_of_deep_runs),
        cmocka_unit_test(test_fewer_than_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* gl_transparency.c: pictures of transparency.h on a real driver, held to the reference and to probe pixels. */
#include "gl_scenes.h"

/* ---- tests ---- */

static harness desktop;

static int open_desktop(void **state) {
    (void)state;
    harness_open(&desktop, 450, false, NULL);
    return 0;
}

static int close_desktop(void **state) {
    (void)state;
    harness_close(&desktop);
    return 0;
}

/* All interiors and blendings of one scene against the reference. */
static void check_all(harness *h, test_scene *s, const char *name, int passes) {
    static const char *const interiors[3] = {"", ", published", ", explicit"};
    static const char *const blendings[3] = {"published", "normalised", "over"};
    size_t pixels = (size_t)s->scene.width * (size_t)s->scene.height;
    ref_pixel *truth = malloc(pixels * sizeof *truth);
    unsigned char *picture = malloc(4 * pixels);
    harness_target(h, s->scene.width, s->scene.height);
    for (int interior = 0; interior < 3; ++interior)
        for (int blending = 0; blending < 3; ++blending) {
            char label[80];
            s->scene.interior = (ref_interior)interior;
            s->scene.blending = (ref_blending)blending;
            assert_true(ref_render(&s->scene, truth));
            harness_clear(h, s->scene.background, 1.0f);
            harness_draw(h, &s->scene, s->objects, s->count, NULL, picture);
            snprintf(label, sizeof label, "%s, %s%s", name, blendings[blending], interiors[interior]);
            harness_check(h, label, &s->scene, truth, picture);
            if (interior == 0)
                assert_int_equal(tr_get_info(h->tr).plan->pass_count, passes);
        }
    free(truth);
    free(picture);
}

static void test_scenes_match_reference(void **state) {
    (void)state;
    for (size_t i = 0; i < NAMED_SCENES; ++i) {
        test_scene s;
        init_scene(&s, 160);
        named_scenes[i].make(&s);
        finish_scene(&s);
        check_all(&desktop, &s, named_scenes[i].name, named_scenes[i].passes);
        drop_scene(&s);
    }
}

static void test_models_match_reference(void **state) {
    static const char *const names[] = {"mug", "crank", "shells", "gearbox"};
    static const int sizes[] = {256, 256, 256, 480}; /* small parts need more pixels between their edges */
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
        scene *model = models_make(names[i]);
        test_scene s;
        assert_non_null(model);
        init_scene(&s, sizes[i]);
        add_model(&s, model);
        frame_model(&s, model);
        finish_scene(&s);
        bool several = tr_scene_count(s.objects, s.count, sizeof s.objects[0]).transparent > 1;
        bool opaque = tr_scene_count(s.objects, s.count, sizeof s.objects[0]).opaque > 0;
        assert_true(opaque);
        check_all(&desktop, &s, names[i], several ? 5 : 4);
        drop_scene(&s);
        scene_destroy(model);
    }
}

/* Alpha by vertex, interpolated, and cool-to-warm shading, on a ball under perspective. */
static void test_vertex_alpha_and_shading_match_reference(void **state) {
    static const float d_max[2] = {1.5f, 0.0f}, k[2] = {0.7f, 0.0f};
    test_scene s;
    (void)state;
    init_scene(&s, 200);
    make_ball(&s, add_object(&s, true, 0.3, 0.5, 0.9, 1.0), 0, 0, 0, 1.5, 1);
    make_ball(&s, add_object(&s, false, 0.8, 0.5, 0.2, 1), 0.2, 0, 0, 0.9, 1);
    s.truths[1].model[0] = 0.5; /* normals by the inverse transpose */
    s.truths[1].model[4] = 0.3;
    float *distances = malloc(s.truths[0].vertex_count * sizeof *distances);
    float *alphas = malloc(s.truths[0].vertex_count * sizeof *alphas);
    for (size_t i = 0; i < s.truths[0].vertex_count; ++i) {
        distances[i] = fabsf(s.truths[0].positions[3 * i + 2]);
        alphas[i] = (float)ref_alpha((double)distances[i], 1.5, (double)k[0]);
    }
    s.truths[0].vertex_alpha = alphas;
    s.truths[0].cool_to_warm = s.truths[1].cool_to_warm = true;
    s.scene.light_direction[0] = -1, s.scene.light_direction[1] = 2, s.scene.light_direction[2] = 1.5;
    const double cool[3] = {0, 0, 0.4}, warm[3] = {0.4, 0.4, 0};
    memcpy(s.scene.cool, cool, sizeof cool);
    memcpy(s.scene.warm, warm, sizeof warm);
    s.scene.cool_mix = 0.2;
    s.scene.warm_mix = 0.6;
    s.scene.blending = REF_BLEND_OVER;
    s.scene.objects = s.truths;
    s.scene.object_count = s.count;
    for (size_t i = 0; i < s.count; ++i) {
        s.objects[i].truth = s.truths[i];
        s.objects[i].truth.alpha = 1.0;
        harness_upload(&s.objects[i], i == 0 ? distances : NULL);
    }
    ref_pixel *truth = malloc(200 * 200 * sizeof *truth);
    unsigned char *picture = malloc(200 * 200 * 4);
    harness_options options = {0, 0, d_max, k, NULL, NULL, 0, NULL};
    assert_true(ref_render(&s.scene, truth));
    harness_target(&desktop, 200, 200);
    harness_clear(&desktop, s.scene.background, 1.0f);
    harness_draw(&desktop, &s.scene, s.objects, s.count, &options, picture);
    harness_check(&desktop, "alpha and shade", &s.scene, truth, picture);
    free(distances);
    free(alphas);
    free(truth);
    free(picture);
    drop_scene(&s);
}

/* Both sides of an open bowl are shaded toward the eye: the back side's normal is turned around. */
static void test_back_sides_are_shaded_toward_the_eye(void **state) {
    const double cool[3] = {0, 0, 0.4}, warm[3] = {0.4, 0.4, 0};
    test_scene s;
    (void)state;
    init_scene(&s, 200);
    lone_sheet(&s);
    for (size_t i = 0; i < s.count; ++i)
        s.truths[i].cool_to_warm = true;
    s.scene.light_direction[1] = 1, s.scene.light_direction[2] = 0.5;
    memcpy(s.scene.cool, cool, sizeof cool);
    memcpy(s.scene.warm, warm, sizeof warm);
    s.scene.cool_mix = 0.2;
    s.scene.warm_mix = 0.6;
    finish_scene(&s);
    check_all(&desktop, &s, "shaded bowl", 3);
    drop_scene(&s);
}

/* The order of the host's array changes no bit. */
static void test_draw_order_changes_nothing(void **state) {
    (void)state;
    for (size_t i = 0; i < NAMED_SCENES; ++i) {
        static unsigned char first[128 * 128 * 4], other[128 * 128 * 4];
        test_scene s;
        init_scene(&s, 128);
        named_scenes[i].make(&s);
        finish_scene(&s);
        harness_target(&desktop, 128, 128);
        harness_clear(&desktop, s.scene.background, 1.0f);
        harness_draw(&desktop, &s.scene, s.objects, s.count, NULL, first);
        for (uint32_t turn = 0, random = 12345; turn < 12; ++turn) {
            for (size_t j = s.count; j > 1; --j) {
                random = random * 1664525u + 1013904223u;
                size_t at = (random >> 8) % j;
                harness_object swap = s.objects[j - 1];
                s.objects[j - 1] = s.objects[at];
                s.objects[at] = swap;
            }
            harness_clear(&desktop, s.scene.background, 1.0f);
            harness_draw(&desktop, &s.scene, s.objects, s.count, NULL, other);
            assert_memory_equal(first, other, sizeof first);
        }
        drop_scene(&s);
    }
}

static void draw_shells(harness *h, unsigned char *pixels, harness_options *options) {
    test_scene s;
    init_scene(&s, 128);
    shells(&s);
    finish_scene(&s);
    harness_draw(h, &s.scene, s.objects, s.count, options, pixels);
    drop_scene(&s);
}

static int largest_difference(const unsigned char *a, const unsigned char *b, size_t count) {
    int largest = 0;
    for (size_t i = 0; i < count; ++i)
        largest = abs(a[i] - b[i]) > largest ? abs(a[i] - b[i]) : largest;
    return largest;
}

/* Older contexts give the picture of the newest one. */
static void test_older_contexts_draw_the_same(void **state) {
    static const struct {
        int version;
        bool es;
    } contexts[] = {{330, false}, {300, true}, {310, true}, {320, true}};
    static unsigned char newest[128 * 128 * 4], picture[128 * 128 * 4];
    static const double white[3] = {1, 1, 1};
    (void)state;
    harness_target(&desktop, 128, 128);
    harness_clear(&desktop, white, 1.0f);
    draw_shells(&desktop, newest, NULL);
    for (size_t i = 0; i < sizeof contexts / sizeof contexts[0]; ++i) {
        /* One context at a time: they share a display, which goes with the first that is closed. */
        harness_close(&desktop);
        harness h;
        harness_open(&h, contexts[i].version, contexts[i].es, NULL);
        harness_target(&h, 128, 128);
        harness_clear(&h, white, 1.0f);
        draw_shells(&h, picture, NULL);
        tr_info info = tr_get_info(h.tr);
        printf("    %s %d: differs by %d/255 at most\n", info.es ? "ES" : "GL", info.version,
               largest_difference(newest, picture, sizeof picture));
        assert_int_equal(info.version, harness_version(contexts[i].version, contexts[i].es));
        assert_int_equal(info.es, contexts[i].es);
        assert_true(largest_difference(newest, picture, sizeof picture) <= 1);
        harness_close(&h);
        harness_open(&desktop, 450, false, NULL);
    }
}

/* ---- probe pixels, worked out by hand ---- */

static const probe_object *probe_object_of(const probe_scene *p, uint32_t id) {
    for (int i = 0; i < p->object_count; ++i)
        if (p->objects[i].id == id)
            return &p->objects[i];
    return NULL;
}

static void probe_color(const probe_scene *p, probe_answer answer, ref_blending blending, double out[3]) {
    const probe_object *behind = probe_object_of(p, answer.behind), *front = probe_object_of(p, answer.front);
    const double *below = behind ? behind->color : p->background;
    memcpy(out, below, 3 * sizeof *out);
    if (front)
        ref_blend(blending, front->alpha, front->color, behind ? p->opaque_weight : p->background_weight, below, out);
}

enum { PROBE_SIZE = 201 };

/* Draws one view by all rules and blendings; counts the probes that were looked at. */
static int check_probe_view(test_scene *s, const probe_scene *p, const probe_view *view) {
    static unsigned char picture[PROBE_SIZE * PROBE_SIZE * 4];
    int checked = 0;
    set_probe_camera(s, &view->camera);
    for (int variant = 0; variant < 9; ++variant) {
        s->scene.interior = (ref_interior)(variant / 3);
        s->scene.blending = (ref_blending)(variant % 3);
        harness_clear(&desktop, p->background, 1.0f);
        harness_draw(&desktop, &s->scene, s->objects, s->count, NULL, picture);
        for (int i = 0; i < view->probe_count; ++i, ++checked) {
            const probe *q = &view->probes[i];
            const probe_answer answers[3] = {q->rule_default, q->rule_published, q->rule_explicit};
            size_t x = (size_t)((q->u + 1) * 0.5 * PROBE_SIZE), y = (size_t)((q->v + 1) * 0.5 * PROBE_SIZE);
            double expected[3];
            probe_color(p, answers[variant / 3], s->scene.blending, expected);
            for (size_t k = 0; k < 3; ++k)
                if (fabs(expected[k] * 255 - picture[4 * (y * PROBE_SIZE + x) + k]) > 2)
                    fail_msg("%s, %s, probe %d (%g, %g), variant %d: channel %zu is %d, should be %.1f", p->name,
                             view->name, i, q->u, q->v, variant, k, picture[4 * (y * PROBE_SIZE + x) + k],
                             expected[k] * 255);
        }
    }
    return checked;
}

static void test_probe_pixels(void **state) {
    int checked = 0;
    (void)state;
    harness_target(&desktop, PROBE_SIZE, PROBE_SIZE);
    for (int i = 0; i < PROBE_SCENE_COUNT; ++i) {
        const probe_scene *p = &probe_scenes[i];
        test_scene s;
        init_scene(&s, PROBE_SIZE);
        for (int o = 0; o < p->object_count; ++o)
            add_probe_object(&s, &p->objects[o]);
        s.scene.opaque_weight = p->opaque_weight;
        s.scene.background_weight = p->background_weight;
        finish_scene(&s);
        for (int v = 0; v < p->view_count; ++v)
            checked += check_probe_view(&s, p, &p->views[v]);
        drop_scene(&s);
    }
    printf("    %d probes in %d scenes, by rule and blending\n", checked, (int)PROBE_SCENE_COUNT);
    assert_true(checked >= 20 * 9 * PROBE_SCENE_COUNT);
}

/* The colours worked out in full, arithmetic and all. */
static void test_probe_examples(void **state) {
    (void)state;
    for (int i = 0; i < PROBE_SCENE_COUNT; ++i)
        for (int e = 0; e < probe_scenes[i].example_count; ++e) {
            const probe_example *example = &probe_scenes[i].examples[e];
            const probe *q = &probe_scenes[i].views[example->view].probes[example->probe];
            probe_answer answer = example->published_rule ? q->rule_published : q->rule_default;
            const double *expected[3] = {example->published, example->normalised, example->over};
            for (int blending = 0; blending < 3; ++blending) {
                double color[3];
                probe_color(&probe_scenes[i], answer, (ref_blending)blending, color);
                for (int k = 0; k < 3; ++k)
                    assert_true(fabs(color[k] - expected[blending][k]) < 1e-5);
            }
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_probe_pixels),
        cmocka_unit_test(test_probe_examples),
        cmocka_unit_test(test_scenes_match_reference),
        cmocka_unit_test(test_models_match_reference),
        cmocka_unit_test(test_vertex_alpha_and_shading_match_reference),
        cmocka_unit_test(test_back_sides_are_shaded_toward_the_eye),
        cmocka_unit_test(test_draw_order_changes_nothing),
        cmocka_unit_test(test_older_contexts_draw_the_same),
    };
    return cmocka_run_group_tests_name("gl_transparency", tests, open_desktop, close_desktop);
}

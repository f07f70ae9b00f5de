/* TR_SEE_SEQUENCE, TR_SEE_PUBLISHED and TR_SEE_EXACT against the truth per pixel of reference_dynamic.h. */
#include "dynamic_trials.h"

/* Draws and compares; few pixels may be off by more than `allowed` 255ths: those where the two disagree on what a pixel
 * centre exactly on an edge belongs to, and what a mask makes of that around it. */
static stage_error check_picture(harness *h, stage *s, const char *name, double allowed, bool reversed) {
    tr_result result = stage_draw(h, s, reversed);
    if (result != TR_OK)
        fail_msg("%s: %s", name, tr_result_string(result));
    stage_read(h, s);
    stage_truth(s);
    stage_error e = stage_compare(s, allowed);
    printf("    %-34s max %6.2f mean %.3f /255, %zu over %.1f, %zu see-through, %.1f %% left out\n", name, e.largest,
           e.mean, e.over, allowed, e.see_through, 100 * e.left_out);
    return e;
}

/* ---- scenes ---- */

/* A target behind two walls, one before the other. */
static void two_walls(stage *s) {
    const double ball[3] = {0.6, 0.6, 0.6}, target[3] = {0, 0, -2};
    stage_look(s, 12, 0, 0);
    stage_box(s, REF_DYN_TARGET, target, ball, 0.5);
    stage_sheet(s, 0, -2.1, -2.3, 1.3, 2.2, 0);
    stage_sheet(s, 0, -1.2, -1.1, 2.3, 2.4, 2);
}

/* ---- tests ---- */

static void sequence_of_two_walls(void **state) {
    harness h;
    (void)state;
    harness_open(&h, 330, false, NULL);
    harness_target(&h, 96, 80);
    for (int rung = 0; rung < 3; ++rung) {
        static const char *const names[] = {"two walls, together", "two walls, each", "two walls, published"};
        stage *s = stage_new(96, 80);
        two_walls(s);
        s->wish.mask_divisor = 1;
        s->truth.occluders = rung == 1 ? REF_DYN_EACH : REF_DYN_TOGETHER;
        set_truth(s, rung == 2 ? TR_SEE_PUBLISHED : TR_SEE_SEQUENCE);
        stage_error e = check_picture(&h, s, names[rung], 2, false);
        write_pictures(s, names[rung]);
        assert_true(e.see_through > 100);
        assert_true(e.over == 0);
        stage_free(s);
    }
    harness_close(&h);
}

/* 8 bits round each layer by half a step, and once more where it is put over the host's; products of masks by more. A
 * gradient steps by 0.9 / 12 of 255, 19, a pixel; with a divisor its distances are those to the nearest of a few candidates. */
static void sequences_are_the_truth_by_centres(void **state) {
    static const trial trials[] = {
        {"each", TR_SEE_SEQUENCE, SOLIDS, MIN_, EACH, 0, 1, GL33, 2, FEW, OUTLINE},
        {"product, each", TR_SEE_SEQUENCE, SOLIDS, PRODUCT, EACH, 0, 1, GL33, 2, FEW, OUTLINE},
        {"together", TR_SEE_SEQUENCE, SOLIDS, MIN_, TOGETHER, 0, 1, GL33, 2, FEW, OUTLINE},
        {"impenetrable", TR_SEE_SEQUENCE, IMPENETRABLES | BACKDROPS, MIN_, TOGETHER, 0, 1, GL33, 2, FEW, OUTLINE},
        {"groups", TR_SEE_SEQUENCE, GROUPS, MIN_, TOGETHER, 0, 1, GL33, 2, FEW, OUTLINE},
        {"hollow, each", TR_SEE_SEQUENCE, HOLLOWS, MIN_, EACH, 0, 1, GL33, 2, FEW, OUTLINE},
        {"hollow, together", TR_SEE_SEQUENCE, HOLLOWS, MIN_, TOGETHER, 0, 1, GL33, 2, FEW, OUTLINE},
        {"importances", TR_SEE_SEQUENCE, IMPORTANCES, MIN_, TOGETHER, 0, 1, GL33, 2, FEW, OUTLINE},
        {"lights", TR_SEE_SEQUENCE, LIGHTS, MIN_, TOGETHER, 0, 1, GL33, 2, FEW, OUTLINE},
        {"fades, each", TR_SEE_SEQUENCE, FADES, MIN_, EACH, 0, 1, GL33, 2, FEW, OUTLINE},
        {"one layer", TR_SEE_SEQUENCE, SOLIDS, MIN_, TOGETHER, 1, 1, GL33, 2, FEW, OUTLINE},
        {"two layers, each", TR_SEE_SEQUENCE, IMPENETRABLES, MIN_, EACH, 2, 1, GL33, 2, FEW, OUTLINE},
        {"divisor 2", TR_SEE_SEQUENCE, SOLIDS, MIN_, TOGETHER, 0, 2, GL33, 2, 0.005, OUTLINE},
        {"divisor 4", TR_SEE_SEQUENCE, SOLIDS, MIN_, EACH, 0, 4, GL33, 2, 0.005, OUTLINE},
        {"divisor 8", TR_SEE_SEQUENCE, SOLIDS, MIN_, EACH, 0, 8, GL33, 2, 0.012, OUTLINE},
        {"8 bits, each", TR_SEE_SEQUENCE, SOLIDS, MIN_, EACH, 0, 1, EIGHT_BITS, 2.5, FEW, OUTLINE},
        {"8 bits, together", TR_SEE_SEQUENCE, SOLIDS, MIN_, TOGETHER, 0, 1, EIGHT_BITS, 3, FEW, OUTLINE},
        {"reversed z", TR_SEE_SEQUENCE, IMPENETRABLES, MIN_, TOGETHER, 0, 1, REVERSED, 2, FEW, OUTLINE},
        {"ES 3.0", TR_SEE_SEQUENCE, IMPENETRABLES, MIN_, TOGETHER, 0, 1, ES, 2, FEW, OUTLINE},
        {"ES 3.0, 8 bits", TR_SEE_SEQUENCE, IMPENETRABLES, MIN_, TOGETHER, 2, 2, ES | EIGHT_BITS, 3, 0.005, OUTLINE},
    };
    (void)state;
    for (size_t i = 0; i < sizeof trials / sizeof trials[0]; ++i)
        run_trial(&trials[i], 10);
}

static void published_is_the_paper(void **state) {
    static const trial trials[] = {
        {"published", TR_SEE_PUBLISHED, SOLIDS, PRODUCT, EACH, 0, 1, GL33, 2, FEW, OUTLINE},
        {"published, impenetrable", TR_SEE_PUBLISHED, IMPENETRABLES | BACKDROPS, PRODUCT, EACH, 0, 1, GL33, 2, FEW,
         OUTLINE},
        {"published, groups, 8 bits", TR_SEE_PUBLISHED, GROUPS, PRODUCT, EACH, 0, 1, EIGHT_BITS, 3, FEW, OUTLINE},
        {"published, layers", TR_SEE_PUBLISHED, SOLIDS, PRODUCT, EACH, 2, 1, GL33, 2, FEW, OUTLINE},
        {"published, divisor 4", TR_SEE_PUBLISHED, SOLIDS, PRODUCT, EACH, 0, 4, GL33, 2, 0.005, OUTLINE},
    };
    (void)state;
    for (size_t i = 0; i < sizeof trials / sizeof trials[0]; ++i)
        run_trial(&trials[i], 10);
}

static void exact_is_the_truth_per_pixel(void **state) {
    static const trial trials[] = {
        {"exact", TR_SEE_EXACT, SOLIDS, MIN_, TOGETHER, 0, 0, GL33, 2, FEW, OUTLINE},
        {"exact, each", TR_SEE_EXACT, SOLIDS, MIN_, EACH, 0, 1, GL33, 2, FEW, OUTLINE},
        {"exact, product", TR_SEE_EXACT, SOLIDS, PRODUCT, TOGETHER, 0, 1, GL33, 2, FEW, OUTLINE},
        {"exact, impenetrable", TR_SEE_EXACT, IMPENETRABLES | BACKDROPS, MIN_, TOGETHER, 0, 1, GL33, 2, FEW, OUTLINE},
        {"exact, importances", TR_SEE_EXACT, IMPORTANCES | IMPENETRABLES, MIN_, TOGETHER, 0, 1, GL33, 2, FEW, OUTLINE},
        {"exact, hollow", TR_SEE_EXACT, HOLLOWS, MIN_, TOGETHER, 0, 1, GL33, 2, FEW, OUTLINE},
        {"exact, lights", TR_SEE_EXACT, LIGHTS, MIN_, TOGETHER, 0, 1, GL33, 2, FEW, OUTLINE},
        {"exact, fades", TR_SEE_EXACT, FADES, MIN_, TOGETHER, 0, 1, GL33, 2, FEW, OUTLINE},
        {"exact, one layer", TR_SEE_EXACT, SOLIDS, MIN_, TOGETHER, 1, 1, GL33, 2, FEW, OUTLINE},
        {"exact, three layers", TR_SEE_EXACT, IMPENETRABLES, MIN_, EACH, 3, 1, GL33, 2, FEW, OUTLINE},
        {"exact, two layers, together", TR_SEE_EXACT, IMPENETRABLES, MIN_, TOGETHER, 2, 1, GL33, 2, FEW, OUTLINE},
        {"exact, divisor 2", TR_SEE_EXACT, SOLIDS, MIN_, TOGETHER, 0, 2, GL33, 2, 0.005, OUTLINE},
        {"exact, divisor 8", TR_SEE_EXACT, IMPENETRABLES, MIN_, EACH, 0, 8, GL33, 2, 0.012, OUTLINE},
        {"exact, 8 bits", TR_SEE_EXACT, SOLIDS, MIN_, TOGETHER, 0, 1, EIGHT_BITS, 2.5, FEW, OUTLINE},
        {"exact, reversed z", TR_SEE_EXACT, IMPENETRABLES, MIN_, TOGETHER, 0, 1, REVERSED, 2, FEW, OUTLINE},
        {"exact, ES 3.0, 8 bits", TR_SEE_EXACT, HOLLOWS, PRODUCT, TOGETHER, 0, 1, ES | EIGHT_BITS, 3, FEW, OUTLINE},
        {"exact, ES 3.0", TR_SEE_EXACT, IMPENETRABLES, MIN_, EACH, 0, 1, ES, 2, FEW, OUTLINE},
    };
    (void)state;
    for (size_t i = 0; i < sizeof trials / sizeof trials[0]; ++i)
        run_trial(&trials[i], 10);
}

/* One mask for all targets is the truth but where the reference's other reading of it says that it is not. */
static void one_mask_is_what_is_said_of_it(void **state) {
    static const trial trials[] = {
        {"one mask", TR_SEE_ONE_MASK, SOLIDS, MIN_, TOGETHER, 0, 1, GL33, 2.5, FEW, OUTLINE},
        {"one mask, impenetrable", TR_SEE_ONE_MASK, IMPENETRABLES | BACKDROPS, MIN_, TOGETHER, 0, 1, GL33, 2.5, FEW,
         OUTLINE},
        {"one mask, importances", TR_SEE_ONE_MASK, IMPORTANCES | IMPENETRABLES, MIN_, TOGETHER, 0, 1, GL33, 2.5, FEW,
         OUTLINE},
        {"one mask, hollow", TR_SEE_ONE_MASK, HOLLOWS, MIN_, TOGETHER, 0, 1, GL33, 2.5, FEW, OUTLINE},
        {"one mask, lights", TR_SEE_ONE_MASK, LIGHTS, MIN_, TOGETHER, 0, 1, GL33, 2.5, FEW, OUTLINE},
        {"one mask, fades", TR_SEE_ONE_MASK, FADES, MIN_, TOGETHER, 0, 1, GL33, 2.5, FEW, OUTLINE},
        {"one mask, 8 bits", TR_SEE_ONE_MASK, SOLIDS, MIN_, TOGETHER, 0, 1, EIGHT_BITS, 2.5, FEW, OUTLINE},
        {"one mask, reversed z", TR_SEE_ONE_MASK, IMPENETRABLES, MIN_, TOGETHER, 0, 1, REVERSED, 2.5, FEW, OUTLINE},
        {"one mask, ES 3.0", TR_SEE_ONE_MASK, IMPENETRABLES | FADES, MIN_, TOGETHER, 0, 1, ES, 2.5, FEW, OUTLINE},
    };
    (void)state;
    for (size_t i = 0; i < sizeof trials / sizeof trials[0]; ++i)
        run_trial(&trials[i], 10);
}

/* A pixel of the outline on which rasteriser and ray disagree moves all of its circle. */
static void shapes_are_the_truth(void **state) {
    static const trial trials[] = {
        {"sequence, circle", TR_SEE_SEQUENCE, SOLIDS, MIN_, TOGETHER, 0, 1, GL33, 2, 0.005, REF_DYN_CIRCLE},
        {"sequence, ellipse", TR_SEE_SEQUENCE, IMPENETRABLES, MIN_, EACH, 0, 2, ES, 2, 0.005, REF_DYN_ELLIPSE},
        {"sequence, hull", TR_SEE_SEQUENCE, SOLIDS, MIN_, EACH, 0, 1, EIGHT_BITS, 2.5, 0.01, REF_DYN_HULL},
        {"published, circle", TR_SEE_PUBLISHED, IMPENETRABLES, PRODUCT, EACH, 0, 1, GL33, 2, 0.005, REF_DYN_CIRCLE},
        {"exact, circle", TR_SEE_EXACT, IMPENETRABLES, MIN_, TOGETHER, 0, 1, GL33, 2, 0.005, REF_DYN_CIRCLE},
        {"exact, ellipse", TR_SEE_EXACT, SOLIDS, MIN_, TOGETHER, 0, 1, REVERSED, 2, 0.005, REF_DYN_ELLIPSE},
        {"exact, hull", TR_SEE_EXACT, SOLIDS, MIN_, TOGETHER, 0, 1, ES, 2, 0.01, REF_DYN_HULL},
    };
    (void)state;
    for (size_t i = 0; i < sizeof trials / sizeof trials[0]; ++i)
        run_trial(&trials[i], 6);
}

/* ---- what is promised ---- */

/* With targets white and all else black a pixel is the weight of its targets. 8 bits: 2 / 255 for rounding; see FEW. */
static void farthest_targets_keep_their_weight(void **state) {
    static const tr_see sees[] = {TR_SEE_EXACT, TR_SEE_SEQUENCE, TR_SEE_PUBLISHED};
    static const char *const names[] = {"exact", "sequence", "published"};
    harness h;
    (void)state;
    harness_open(&h, 330, false, NULL);
    harness_target(&h, 64, 56);
    stage *s = stage_new(64, 56);
    for (int k = 0; k < 3; ++k)
        s->scene.background[k] = 0;
    for (int rung = 0; rung < 3; ++rung) {
        size_t pixels = 0, below = 0;
        double least = 1;
        for (uint64_t seed = 100; seed < 200; ++seed) {
            stage_clean(s);
            scatter(s, seed, 14, 1 + seed % 6, seed % 2 ? IMPENETRABLES : SOLIDS);
            for (size_t i = 0; i < s->count; ++i)
                for (int k = 0; k < 3; ++k)
                    s->meshes[i].color[k] = s->marks[i].flags & REF_DYN_TARGET ? 1 : 0;
            set_truth(s, sees[rung]);
            assert_int_equal(stage_draw(&h, s, false), TR_OK);
            stage_read(&h, s);
            s->truth.order = REF_DYN_PER_PIXEL; /* which pixels have an open target is no matter of the order */
            stage_truth(s);
            for (size_t i = 0; i < 64 * 56; ++i)
                if (s->pixels[i].target && !s->pixels[i].left_out) {
                    double weight = s->picture[4 * i] / 255.0;
                    ++pixels;
                    below += weight < 0.7 - 2 / 255.0;
                    least = fmin(least, weight);
                }
        }
        printf("    %-10s least weight of targets %.3f, %zu of %zu pixels below 0.7\n", names[rung], least, below,
               pixels);
        assert_true(pixels > 10000);
        if (rung == 0)
            assert_true((double)below <= FEW * (double)pixels);
    }
    stage_free(s);
    harness_close(&h);
}

/* More walls than there are layers: the target keeps its weight, and the plan says that there may be more. */
static void layers_too_many_lose_no_target(void **state) {
    harness h;
    const double ball[3] = {0.6, 0.6, 0.6}, target[3] = {0, 0, -6};
    (void)state;
    harness_open(&h, 330, false, NULL);
    harness_target(&h, 64, 56);
    stage *s = stage_new(64, 56);
    stage_look(s, 12, 0, 0);
    size_t white = stage_box(s, REF_DYN_TARGET, target, ball, 0.5);
    for (int i = 0; i < 40; ++i)
        stage_sheet(s, 0, -3, -3, 3, 3, -5 + 0.25 * i);
    for (size_t i = 0; i < s->count; ++i)
        for (int k = 0; k < 3; ++k)
            s->meshes[i].color[k] = i == white;
    for (int k = 0; k < 3; ++k)
        s->scene.background[k] = 0;
    set_truth(s, TR_SEE_EXACT);
    assert_int_equal(stage_draw(&h, s, false), TR_OK);
    const tr_see_plan *plan = tr_get_info(h.tr).see_plan;
    assert_true(plan->layers == 16 && plan->layer_bound > plan->layers);
    stage_read(&h, s);
    const unsigned char *middle = s->picture + 4 * (28 * 64 + 32);
    printf("    behind 40 walls: %d / 255\n", middle[0]);
    assert_true(abs(middle[0] - 179) <= 2); /* 0.7 */
    stage_free(s);
    harness_close(&h);
}

/* Targets side by side behind one wall take one run of masks; what is not called for is not done. */
static void only_what_is_called_for(void **state) {
    harness h;
    (void)state;
    harness_open(&h, 330, false, NULL);
    harness_target(&h, 160, 60);
    for (int rung = 0; rung < 2; ++rung) {
        tr_see see = rung ? TR_SEE_EXACT : TR_SEE_SEQUENCE;
        stage *s = stage_new(160, 60);
        stage_look(s, 12, 0, 0);
        s->truth.width = 4;
        s->truth.occluders = REF_DYN_EACH;
        s->wish.mask_divisor = 1;
        set_truth(s, see);
        for (int i = 0; i < 4; ++i) {
            const double ball[3] = {0.3, 0.3, 0.3}, middle[3] = {8.0 * i - 12, 0, -2};
            stage_box(s, REF_DYN_TARGET, middle, ball, 0.3);
        }
        assert_int_equal(stage_draw(&h, s, false), TR_OK); /* nothing before them */
        assert_int_equal(tr_get_info(h.tr).see_plan->see, TR_SEE_OFF);
        assert_true(s->passes[TR_PASS_SCENE] == 1 && s->draws[TR_PASS_SCENE] == 4);
        stage_sheet(s, 0, -20, -3, 20, 3, 1);
        assert_int_equal(stage_draw(&h, s, false), TR_OK);
        assert_int_equal(tr_get_info(h.tr).see_plan->runs, 1);
        assert_true(s->passes[TR_PASS_SEEDS] == 1 && s->draws[TR_PASS_SEEDS] == 4);
        assert_int_equal(s->passes[TR_PASS_BLOCK], 0);
        assert_int_equal(s->passes[TR_PASS_COUNT], 0);
        s->marks[4].flags = REF_DYN_IMPENETRABLE;
        assert_int_equal(stage_draw(&h, s, false), TR_OK); /* nothing yields */
        assert_int_equal(tr_get_info(h.tr).see_plan->see, TR_SEE_OFF);
        s->marks[4].flags = 0;
        s->units[3].unit.id = 0;
        s->meshes[3].id = s->meshes[4].id; /* a target and a wall */
        h.quiet = true;
        assert_int_equal(stage_draw(&h, s, false), see == TR_SEE_EXACT ? TR_INVALID_ARGUMENT : TR_OK);
        h.quiet = false;
        stage_free(s);
    }
    harness_close(&h);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sequence_of_two_walls),
        cmocka_unit_test(sequences_are_the_truth_by_centres),
        cmocka_unit_test(published_is_the_paper),
        cmocka_unit_test(exact_is_the_truth_per_pixel),
        cmocka_unit_test(one_mask_is_what_is_said_of_it),
        cmocka_unit_test(shapes_are_the_truth),
        cmocka_unit_test(farthest_targets_keep_their_weight),
        cmocka_unit_test(layers_too_many_lose_no_target),
        cmocka_unit_test(only_what_is_called_for),
    };
    if (getenv("GLASSINE_TEST"))
        cmocka_set_test_filter(getenv("GLASSINE_TEST"));
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* TR_SEE_SEQUENCE, TR_SEE_PUBLISHED and TR_SEE_EXACT against the truth per pixel of reference_dynamic.h. */
#include "dynamic_stage.h"

/* ---- comparison ---- */

static void set_truth(stage *s, tr_see see) {
    s->wish.see = see;
    s->truth.order = see == TR_SEE_EXACT ? REF_DYN_PER_PIXEL : REF_DYN_OBJECT_CENTRES;
    if (see == TR_SEE_PUBLISHED)
        ref_dyn_published(&s->truth);
}

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

static void write_pictures(const stage *s, const char *name) {
    const char *folder = getenv("GLASSINE_PICTURES");
    char path[512];
    for (int which = 0; folder && which < 2; ++which) {
        snprintf(path, sizeof path, "%s/%s_%s.ppm", folder, name, which ? "truth" : "gl");
        FILE *file = fopen(path, "wb");
        if (!file)
            return;
        fprintf(file, "P6 %d %d 255\n", s->scene.width, s->scene.height);
        for (int y = s->scene.height - 1; y >= 0; --y)
            for (int x = 0; x < s->scene.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    size_t i = (size_t)(y * s->scene.width + x);
                    fputc(which ? (int)(s->pixels[i].color[c] * 255 + 0.5) : s->picture[4 * i + (size_t)c], file);
                }
        fclose(file);
    }
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

enum { SOLIDS = 1, IMPENETRABLES = 2, HOLLOWS = 4, BACKDROPS = 8, IMPORTANCES = 16, GROUPS = 32 };

/* Boxes and rings at random; `wanted` of them targets. */
static void scatter(stage *s, uint64_t seed, size_t count, size_t wanted, unsigned kinds) {
    stage_dice dice = {seed * 7919 + 17};
    stage_look(s, 13, stage_throw(&dice, 0, 6.28), stage_throw(&dice, -0.6, 0.9));
    for (size_t i = 0; i < count; ++i) {
        uint32_t flags = i < wanted ? (uint32_t)REF_DYN_TARGET : 0u;
        double middle[3], half[3];
        for (int k = 0; k < 3; ++k) {
            middle[k] = stage_throw(&dice, -3.5, 3.5);
            half[k] = stage_throw(&dice, 0.3, 1.2);
        }
        if (!flags && (kinds & IMPENETRABLES) && stage_pick(&dice, 5) == 0)
            flags |= REF_DYN_IMPENETRABLE;
        size_t ring = stage_pick(&dice, 3);
        if (ring == 0 && (kinds & HOLLOWS))
            flags |= REF_DYN_HOLLOW;
        size_t at = ring == 0 ? stage_ring(s, flags, middle, 1.1, 0.4)
                              : stage_box(s, flags, middle, half, stage_throw(&dice, 0, 3));
        if (kinds & GROUPS) {
            s->marks[at].group = (uint32_t)stage_pick(&dice, 4);
            s->marks[at].rank = (int)stage_pick(&dice, 3);
        }
        if (!(flags & REF_DYN_TARGET) && (kinds & IMPORTANCES))
            s->marks[at].importance = stage_throw(&dice, 0, 1);
    }
    if (kinds & BACKDROPS) {
        const double middle[3] = {0, -6, 0}, half[3] = {9, 0.1, 9};
        stage_box(s, REF_DYN_BACKDROP, middle, half, 0);
    }
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

typedef struct trial {
    const char *name;
    tr_see see;
    unsigned kinds;
    ref_dyn_combine combine;
    ref_dyn_occluders occluders;
    uint32_t layers;
    int divisor;
    bool es, reversed, eight_bits;
    double allowed;
} trial;

static void run_trial(const trial *t, uint64_t seeds) {
    harness h;
    tr_desc desc;
    size_t over = 0, compared = 0, see_through = 0;
    double most = 0, left_out = 0;
    memset(&desc, 0, sizeof desc);
    desc.reversed_z = t->reversed;
    desc.eight_bits = t->eight_bits;
    harness_open(&h, t->es ? 300 : 330, t->es, &desc);
    harness_target(&h, 128, 112);
    stage *s = stage_new(120, 100);
    s->frame.x = 5;
    s->frame.y = 7;
    for (uint64_t seed = 0; seed < seeds; ++seed) {
        stage_clean(s);
        scatter(s, seed, 16, 1 + seed % 5, t->kinds);
        s->wish.mask_divisor = t->divisor;
        s->truth.combine = t->combine;
        s->truth.occluders = t->occluders;
        s->truth.layers = t->layers;
        set_truth(s, t->see);
        tr_result result = stage_draw(&h, s, t->reversed);
        if (result != TR_OK)
            fail_msg("%s: %s", t->name, tr_result_string(result));
        stage_read(&h, s);
        stage_truth(s);
        stage_error e = stage_compare(s, t->allowed);
        if (getenv("GLASSINE_PICTURES") && e.over > 5) {
            char name[64];
            snprintf(name, sizeof name, "%s_%d", t->name, (int)seed);
            write_pictures(s, name);
            printf("      seed %d: %zu over, max %.1f at %zu,%zu\n", (int)seed, e.over, e.largest, e.worst % 120,
                   e.worst / 120);
        }
        over += e.over;
        see_through += e.see_through;
        compared += (size_t)((1 - e.left_out) * 12000);
        most = fmax(most, e.largest);
        left_out += e.left_out / (double)seeds;
    }
    printf("    %-28s %zu of %zu over %.1f/255, max %.1f; %zu see-through, %.1f %% left out\n", t->name, over, compared,
           t->allowed, most, see_through, 100 * left_out);
    stage_free(s);
    harness_close(&h);
}

static void random_scenes(void **state) {
    static const trial trials[] = {
        {"each", TR_SEE_SEQUENCE, SOLIDS, REF_DYN_MIN, REF_DYN_EACH, 0, 1, false, false, false, 2},
        {"product, each", TR_SEE_SEQUENCE, SOLIDS, REF_DYN_PRODUCT, REF_DYN_EACH, 0, 1, false, false, false, 2},
        {"together", TR_SEE_SEQUENCE, SOLIDS, REF_DYN_MIN, REF_DYN_TOGETHER, 0, 1, false, false, false, 2},
        {"published", TR_SEE_PUBLISHED, SOLIDS, REF_DYN_PRODUCT, REF_DYN_EACH, 0, 1, false, false, false, 2},
        {"impenetrable", TR_SEE_SEQUENCE, IMPENETRABLES | BACKDROPS, REF_DYN_MIN, REF_DYN_TOGETHER, 0, 1, false, false,
         false, 2},
        {"impenetrable published", TR_SEE_PUBLISHED, IMPENETRABLES | BACKDROPS, REF_DYN_PRODUCT, REF_DYN_EACH, 0, 1,
         false, false, false, 2},
        {"groups", TR_SEE_SEQUENCE, GROUPS, REF_DYN_MIN, REF_DYN_TOGETHER, 0, 1, false, false, false, 2},
        {"hollow each", TR_SEE_SEQUENCE, HOLLOWS, REF_DYN_MIN, REF_DYN_EACH, 0, 1, false, false, false, 2},
        {"hollow together", TR_SEE_SEQUENCE, HOLLOWS, REF_DYN_MIN, REF_DYN_TOGETHER, 0, 1, false, false, false, 2},
        {"importances", TR_SEE_SEQUENCE, IMPORTANCES, REF_DYN_MIN, REF_DYN_TOGETHER, 0, 1, false, false, false, 2},
        {"one layer", TR_SEE_SEQUENCE, SOLIDS, REF_DYN_MIN, REF_DYN_TOGETHER, 1, 1, false, false, false, 2},
        {"exact together", TR_SEE_EXACT, SOLIDS, REF_DYN_MIN, REF_DYN_TOGETHER, 0, 1, false, false, false, 2},
        {"exact each", TR_SEE_EXACT, SOLIDS, REF_DYN_MIN, REF_DYN_EACH, 0, 1, false, false, false, 2},
        {"exact product", TR_SEE_EXACT, SOLIDS, REF_DYN_PRODUCT, REF_DYN_TOGETHER, 0, 1, false, false, false, 2},
        {"exact impenetrable", TR_SEE_EXACT, IMPENETRABLES | BACKDROPS, REF_DYN_MIN, REF_DYN_TOGETHER, 0, 1, false,
         false, false, 2},
        {"exact importances", TR_SEE_EXACT, IMPORTANCES, REF_DYN_MIN, REF_DYN_TOGETHER, 0, 1, false, false, false, 2},
        {"exact hollow", TR_SEE_EXACT, HOLLOWS, REF_DYN_MIN, REF_DYN_TOGETHER, 0, 1, false, false, false, 2},
        {"exact one layer", TR_SEE_EXACT, SOLIDS, REF_DYN_MIN, REF_DYN_TOGETHER, 1, 1, false, false, false, 2},
        {"exact three layers", TR_SEE_EXACT, IMPENETRABLES, REF_DYN_MIN, REF_DYN_EACH, 3, 1, false, false, false, 2},
        {"two layers each", TR_SEE_SEQUENCE, IMPENETRABLES, REF_DYN_MIN, REF_DYN_EACH, 2, 1, false, false, false, 2},
    };
    (void)state;
    for (size_t i = 0; i < sizeof trials / sizeof trials[0]; ++i)
        run_trial(&trials[i], 10);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sequence_of_two_walls),
        cmocka_unit_test(random_scenes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* What the rules of dynamic transparency promise of every picture, over hundreds of random scenes and views: rungs against
 * plain drawing and against weights, with no truth but for where targets are and how many layers lie before them. */
#include "dynamic_trials.h"

/* Under AddressSanitizer fewer of everything: it is memory that is looked at there, not pixels. */
#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define SCENES 8
#endif
#endif
#ifndef SCENES
#define SCENES 200
#endif

enum { WIDTH = 64, HEIGHT = 56, PIXELS = WIDTH * HEIGHT };

static const char *const see_names[] = {"one mask", "dither", "exact", "sequence", "published"};

/* ---- pictures ---- */

typedef struct gallery {
    harness h;
    stage *s;
    unsigned char *plain, *seen; /* without and with dynamic transparency */
} gallery;

static void open_gallery(gallery *g) {
    harness_open(&g->h, 330, false, NULL);
    harness_target(&g->h, WIDTH, HEIGHT);
    g->s = stage_new(WIDTH, HEIGHT);
    g->plain = malloc(4 * PIXELS);
    g->seen = malloc(4 * PIXELS);
    assert_true(g->plain && g->seen);
}

static void close_gallery(gallery *g) {
    free(g->plain);
    free(g->seen);
    stage_free(g->s);
    harness_close(&g->h);
}

static void draw_into(gallery *g, tr_see see, unsigned char *pixels) {
    g->s->wish.see = see;
    assert_int_equal(stage_draw(&g->h, g->s, false), TR_OK);
    stage_read(&g->h, g->s);
    memcpy(pixels, g->s->picture, 4 * PIXELS);
}

/* Which unit plain drawing shows at a pixel; count: the background. Colours of units differ. */
static size_t unit_at(const gallery *g, size_t pixel) {
    for (size_t i = 0; i < g->s->count; ++i) {
        bool same = true;
        for (size_t c = 0; c < 3; ++c)
            same = same && fabs(255 * g->s->meshes[i].color[c] - g->plain[4 * pixel + c]) <= 0.75;
        if (same)
            return i;
    }
    return g->s->count;
}

/* Two roundings to 8 bits may leave a step of difference. */
static bool is_as_plain(const gallery *g, size_t pixel) {
    for (size_t c = 0; c < 3; ++c)
        if (abs(g->plain[4 * pixel + c] - g->seen[4 * pixel + c]) > 1)
            return false;
    return true;
}

static void paint_weights(stage *s) {
    for (size_t i = 0; i < s->count; ++i)
        for (int k = 0; k < 3; ++k)
            s->meshes[i].color[k] = s->marks[i].flags & REF_DYN_TARGET ? 1 : 0;
    for (int k = 0; k < 3; ++k)
        s->scene.background[k] = 0;
}

/* ---- what must stay ---- */

/* Units with these flags, where plain drawing shows them, must be shown as they are; others must not always be. */
static void check_that_stays(uint32_t flags, size_t targets, unsigned kinds, tr_see first, tr_see last) {
    gallery g;
    open_gallery(&g);
    for (int see = (int)first; see <= (int)last; ++see) {
        size_t kept = 0, changed = 0;
        for (uint64_t seed = 300; seed < 300 + SCENES; ++seed) {
            stage_clean(g.s);
            scatter(g.s, seed, 14, targets ? targets : 1 + seed % 5, kinds);
            draw_into(&g, TR_SEE_OFF, g.plain);
            draw_into(&g, (tr_see)see, g.seen);
            for (size_t i = 0; i < PIXELS; ++i) {
                size_t unit = unit_at(&g, i);
                bool stays = unit < g.s->count && g.s->marks[unit].flags & flags;
                kept += stays;
                changed += !stays && !is_as_plain(&g, i);
                if (stays && !is_as_plain(&g, i))
                    fail_msg("%s, scene %d, pixel %zu: unit %zu is seen through", see_names[see], (int)seed, i, unit);
            }
        }
        printf("    %-10s %zu pixels stay, %zu others change\n", see_names[see], kept, changed);
        assert_true(kept > 20 * SCENES && changed > 20 * SCENES);
    }
    close_gallery(&g);
}

/* R3 and backdrops: whatever lies behind them. */
static void impenetrable_things_stay(void **state) {
    (void)state;
    check_that_stays(REF_DYN_IMPENETRABLE | REF_DYN_BACKDROP, 0, IMPENETRABLES | BACKDROPS, TR_SEE_ONE_MASK,
                     TR_SEE_PUBLISHED);
}

/* R4: what hides a part of a target is the target itself, hollow ones too. */
static void targets_do_not_open_themselves(void **state) {
    (void)state;
    check_that_stays(REF_DYN_TARGET, 1, HOLLOWS, TR_SEE_ONE_MASK, TR_SEE_PUBLISHED);
}

/* With one mask targets are not cut for others either: that of the nearest is the only one. */
static void one_mask_cuts_no_target(void **state) {
    (void)state;
    check_that_stays(REF_DYN_TARGET, 0, HOLLOWS, TR_SEE_ONE_MASK, TR_SEE_DITHER);
}

/* ---- weights ---- */

/* The weight of all targets where the farthest is open: 1 - alpha_target, in the least, by the defaults. The truth is asked
 * where that is. Two roundings to 8 bits. */
static void targets_are_seen(void **state) {
    gallery g;
    (void)state;
    open_gallery(&g);
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_PUBLISHED; ++see) {
        double least = 1;
        size_t pixels = 0, below = 0;
        for (uint64_t seed = 600; seed < 600 + SCENES && see != TR_SEE_DITHER; ++seed) {
            stage_clean(g.s);
            scatter(g.s, seed, 14, 1 + seed % 6, seed % 2 ? IMPENETRABLES : HOLLOWS);
            paint_weights(g.s);
            draw_into(&g, (tr_see)see, g.seen);
            stage_truth(g.s);
            for (size_t i = 0; i < PIXELS; ++i)
                if (g.s->pixels[i].target && !g.s->pixels[i].left_out) {
                    double weight = g.seen[4 * i] / 255.0;
                    ++pixels;
                    below += weight < 0.7 - 2 / 255.0;
                    least = fmin(least, weight);
                }
        }
        if (pixels)
            printf("    %-10s least weight of targets %.3f, %zu of %zu pixels below 0.7\n", see_names[see], least,
                   below, pixels);
        assert_true(see == TR_SEE_DITHER || pixels > 100);
        if (see == TR_SEE_ONE_MASK || see == TR_SEE_EXACT)
            assert_int_equal(below, 0);
    }
    close_gallery(&g);
}

/* Layer control: a target behind as many layers as may yield, or fewer, keeps its weight; behind more it has none. How many
 * there are is asked of the truth without layer control. */
static void layers_are_those_asked_for(void **state) {
    gallery g;
    (void)state;
    open_gallery(&g);
    for (uint32_t layers = 1; layers <= 3; ++layers) {
        size_t within = 0, beyond = 0, below = 0, above = 0;
        for (uint64_t seed = 900; seed < 900 + SCENES / 2; ++seed) {
            stage_clean(g.s);
            scatter(g.s, seed, 50, 1, seed % 2 ? HOLLOWS : SOLIDS);
            paint_weights(g.s);
            g.s->truth.layers = layers;
            draw_into(&g, TR_SEE_EXACT, g.seen);
            g.s->truth.layers = 0;
            stage_truth(g.s);
            for (size_t i = 0; i < PIXELS; ++i) {
                const ref_dyn_pixel *truth = &g.s->pixels[i];
                double weight = g.seen[4 * i] / 255.0;
                if (!truth->target || truth->left_out)
                    continue;
                within += truth->see_through <= layers;
                beyond += truth->see_through > layers;
                below += truth->see_through <= layers && weight < 0.7 - 2 / 255.0;
                above += truth->see_through > layers && weight > 1 / 255.0;
            }
        }
        printf("    %u layers: %zu pixels of targets behind no more, %zu behind more\n", layers, within, beyond);
        assert_true(SCENES < 100 || (within > 5 * SCENES && beyond > SCENES / 10));
        assert_int_equal(below, 0);
        assert_int_equal(above, 0);
    }
    close_gallery(&g);
}

/* Search lights, all targets active: where none shines nothing is seen through, whatever the rung; where one does, targets
 * keep its share of 1 - alpha_target in the least. */
static void lights_are_where_things_are_seen(void **state) {
    gallery g;
    (void)state;
    open_gallery(&g);
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_PUBLISHED; ++see) {
        size_t dark = 0, lit = 0;
        for (uint64_t seed = 1200; seed < 1200 + SCENES; ++seed) {
            stage_clean(g.s);
            scatter(g.s, seed, 14, 1 + seed % 4, LIGHTS);
            for (size_t i = 0; i < g.s->truth.light_count; ++i) { /* made for a larger picture */
                g.s->lights[i].x *= 0.5;
                g.s->lights[i].y *= 0.5;
            }
            paint_weights(g.s);
            draw_into(&g, TR_SEE_OFF, g.plain);
            draw_into(&g, (tr_see)see, g.seen);
            stage_truth(g.s);
            for (size_t i = 0; i < PIXELS; ++i) {
                double light = ref_dyn_light_at(&g.s->truth, (double)(i % WIDTH) + 0.5, (double)(i / WIDTH) + 0.5);
                dark += light <= 0;
                if (light <= 0 && !is_as_plain(&g, i))
                    fail_msg("%s, scene %d, pixel %zu: seen through in the dark", see_names[see], (int)seed, i);
                if (!g.s->pixels[i].target || g.s->pixels[i].left_out || see == TR_SEE_DITHER || see >= TR_SEE_SEQUENCE)
                    continue;
                lit += light > 0;
                if (g.seen[4 * i] / 255.0 < 0.7 * light - 3 / 255.0)
                    fail_msg("%s, scene %d, pixel %zu: %.3f of a target by a light of %.3f", see_names[see], (int)seed,
                             i, g.seen[4 * i] / 255.0, light);
            }
        }
        printf("    %-10s %zu pixels in the dark, %zu of targets in the light\n", see_names[see], dark, lit);
        assert_true(dark > 1000 * SCENES);
        assert_true(lit > 20 * SCENES || see == TR_SEE_DITHER || see >= TR_SEE_SEQUENCE);
    }
    close_gallery(&g);
}

/* ---- bad input ---- */

/* Of the scene below: unit 0 is a target, unit 1 a wall before it. */
static void no_center(stage *s) {
    s->units[0].unit.center[1] = (float)NAN;
}
static void no_radius(stage *s) {
    s->units[0].unit.radius = (float)NAN;
}
static void endless_wall(stage *s) {
    s->units[1].unit.radius = (float)INFINITY;
}
static void wall_nowhere(stage *s) {
    s->units[1].unit.center[0] = -(float)INFINITY;
}
static void matters_too_much(stage *s) {
    s->units[0].unit.importance = 7;
}
static void matters_less_than_nothing(stage *s) {
    s->units[1].unit.importance = -7;
}
static void does_not_know(stage *s) {
    s->units[1].unit.importance = s->units[0].unit.fade = (float)NAN;
}
static void fades_backwards(stage *s) {
    s->units[0].unit.fade = -3;
}

/* What has no bounds may be anywhere, importance and fade are held to [0,1] and what is no number counts as 0: the target is
 * seen through the wall as it should be. Another one is behind the eye. Sequences paint first what has no middle. */
static void odd_units_are_seen(void **state) {
    static void (*const spoils[])(stage *) = {NULL,          no_center,       no_radius,
                                              endless_wall,  wall_nowhere,    matters_too_much,
                                              does_not_know, fades_backwards, matters_less_than_nothing};
    gallery g;
    (void)state;
    open_gallery(&g);
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_PUBLISHED; ++see)
        for (size_t i = 0; i < sizeof spoils / sizeof spoils[0]; ++i) {
            const double half[3] = {0.6, 0.6, 0.6}, middle[3] = {0, 0, -2}, behind[3] = {0, 0, 30};
            stage_clean(g.s);
            stage_look(g.s, 12, 0, 0);
            stage_box(g.s, REF_DYN_TARGET, middle, half, 0.5);
            stage_sheet(g.s, 0, -2, -2, 2, 2, 1);
            stage_box(g.s, REF_DYN_TARGET, behind, half, 0.5);
            paint_weights(g.s);
            g.s->spoil = spoils[i];
            g.s->wish.see = (tr_see)see;
            assert_int_equal(stage_draw_mean(&g.h, g.s, false, see == TR_SEE_DITHER ? DITHER_FRAMES : 1), TR_OK);
            double weight = g.s->picture[4 * (WIDTH * (HEIGHT / 2) + WIDTH / 2)] / 255.0;
            double should = see >= TR_SEE_SEQUENCE && spoils[i] == wall_nowhere ? 0 : 0.7;
            if (!(fabs(weight - should) <= (see == TR_SEE_DITHER ? 0.03 : 2.0 / 255)))
                fail_msg("%s, input %zu: weight %.3f, should be %.1f", see_names[see], i, weight, should);
        }
    close_gallery(&g);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(impenetrable_things_stay),   cmocka_unit_test(targets_do_not_open_themselves),
        cmocka_unit_test(one_mask_cuts_no_target),    cmocka_unit_test(targets_are_seen),
        cmocka_unit_test(layers_are_those_asked_for), cmocka_unit_test(lights_are_where_things_are_seen),
        cmocka_unit_test(odd_units_are_seen),
    };
    if (getenv("GLASSINE_TEST"))
        cmocka_set_test_filter(getenv("GLASSINE_TEST"));
    return cmocka_run_group_tests(tests, NULL, NULL);
}

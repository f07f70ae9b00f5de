/* gl_dynamic_frames.c: what a frame of dynamic transparency shows is its own alone, nothing of the frames before it; and from
 * frame to frame it changes as the truth does. */
#include "dynamic_scene.h"

/* Under AddressSanitizer fewer of everything: it is memory that is looked at there, not pixels. */
#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define FEW 1
#endif
#endif
#ifndef FEW
#define FEW 0
#endif

/* Places the targets of a field, which come first, around a point, so that what else there is lies before them. */
static void gather_targets(dynamic_scene *d, const double around[3], double spread) {
    dice thrown = {17};
    for (size_t i = 0; i < d->count && d->marks[i].flags & REF_DYN_TARGET; ++i)
        for (int k = 0; k < 3; ++k)
            d->field->scene->parts[d->parts[i]].transform[12 + k] = around[k] + dice_between(&thrown, -spread, spread);
    dynamic_follow(d);
}

/* ---- frames that leave as much behind as they can ---- */

enum { WIDTH = 120, HEIGHT = 90, KINDS = 8 };

/* Wishes and scenes that differ in all that textures, lists and uniforms are made for. */
static void open_kind(dynamic_scene *d, harness *h, int kind) {
    static const double eyes[KINDS][3] = {{9, -14, 6},  {-12, 9, 8}, {14, 4, 3}, {0, -16, 2},
                                          {-9, -12, 9}, {6, 15, 5},  {15, 0, 9}, {3, -13, 12}};
    static const double middle[3] = {0, 0, 0};
    static ref_dyn_light light;
    const double *eye = eyes[kind], behind[3] = {-0.3 * eye[0], -0.3 * eye[1], -0.3 * eye[2]};
    size_t targets = kind == 5 ? 0 : 1 + (size_t)kind % 4; /* one kind has none */
    dynamic_open(d, h, dynamic_random_field(60 + (uint32_t)kind, 12 + 3 * (size_t)kind, targets, kind % 2 == 0));
    gather_targets(d, behind, 1.5);
    dynamic_shade(d, true);
    dynamic_look(d, eye, middle, kind == 3 ? 20 : 45, WIDTH, HEIGHT);
    if (kind == 1 || kind == 6)
        for (size_t i = targets; i < d->count; ++i)
            d->marks[i].importance = (double)(i % 3) / 4;
    if (kind == 2) {
        light = (ref_dyn_light){60, 45, 20, 10};
        d->truth.lights = &light;
        d->truth.light_count = 1;
        d->marks[0].flags |= REF_DYN_ACTIVE;
    }
    d->truth.width = kind == 4 ? 0 : kind == 6 ? 30 : 8;
    d->wish.mask_divisor = kind == 6 ? 4 : kind == 7 ? 1 : 2;
    d->wish.query = kind == 7;
}

static void wish_rung(dynamic_scene *d, tr_see see, int kind) {
    static const ref_dyn_shape shapes[] = {REF_DYN_OUTLINE, REF_DYN_CIRCLE, REF_DYN_HULL, REF_DYN_ELLIPSE};
    bool sequence = see >= TR_SEE_EXACT && see <= TR_SEE_PUBLISHED;
    d->wish.see = see;
    d->truth.layers = sequence && kind == 3 ? 2 : 0;
    d->truth.shape = sequence ? shapes[kind % 4] : REF_DYN_OUTLINE;
    d->truth.occluders = sequence && kind % 3 == 0 ? REF_DYN_EACH : REF_DYN_TOGETHER;
    if (sequence)
        d->wish.query = 0;
}

static unsigned char *draw_kind(harness *h, tr_see see, int kind) {
    dynamic_scene d;
    open_kind(&d, h, kind);
    wish_rung(&d, see, kind);
    dynamic_draw(h, &d);
    unsigned char *pixels = dynamic_read(h, &d);
    dynamic_close(&d);
    return pixels;
}

/* Frame after frame of all kinds and rungs in one context, each against the same frame in a context of its own. */
static void frames_forget_the_ones_before(void **state) {
    unsigned char *fresh[TR_SEE_COUNT][KINDS];
    harness h;
    (void)state;
    for (int see = 0; see < TR_SEE_COUNT; ++see)
        for (int kind = 0; kind < KINDS; ++kind) {
            harness_open(&h, 330, false, NULL);
            harness_target(&h, WIDTH, HEIGHT);
            fresh[see][kind] = draw_kind(&h, (tr_see)see, kind);
            harness_close(&h);
        }
    harness_open(&h, 330, false, NULL);
    harness_target(&h, WIDTH, HEIGHT);
    dice thrown = {5};
    size_t shown = 0;
    for (int i = 0; i < 160; ++i) {
        tr_see see = (tr_see)(dice_throw(&thrown) % TR_SEE_COUNT);
        int kind = (int)(dice_throw(&thrown) % KINDS);
        unsigned char *pixels = draw_kind(&h, see, kind);
        if (memcmp(pixels, fresh[see][kind], 4 * WIDTH * HEIGHT) != 0)
            fail_msg("frame %d, rung %d, kind %d: not as in a context of its own", i, (int)see, kind);
        shown += memcmp(pixels, fresh[TR_SEE_OFF][kind], 4 * WIDTH * HEIGHT) != 0;
        free(pixels);
    }
    /* One rung of six shows nothing through, and one kind of eight has nothing to show: 117 of 160 are left. */
    printf("    %zu of 160 frames show something through\n", shown);
    assert_true(shown > 100);
    for (int see = 0; see < TR_SEE_COUNT; ++see)
        for (int kind = 0; kind < KINDS; ++kind)
            free(fresh[see][kind]);
    harness_close(&h);
}

/* ---- along a path ---- */

static double change_between(const double *a, const double *b, size_t count) {
    double sum = 0;
    for (size_t i = 0; i < count; ++i)
        sum += fabs(a[i] - b[i]);
    return sum;
}

enum { PATH_WIDTH = 96, PATH_HEIGHT = 72, PATH_PIXELS = PATH_WIDTH * PATH_HEIGHT, PATH_VALUES = 3 * PATH_PIXELS };

/* One of the pictures that are compared along the path, and how much it has changed. */
typedef struct path_walker {
    const char *name;
    tr_see see;
    int frames;   /* of dithering, of which the mean is taken; 0: the truth */
    bool still;   /* whether their noise is the same at each step of the path */
    double bound; /* how much more than its truth it may change in all; 0: only said */
    ref_dyn_order order;
    double *before, *now, change, last, worst;
} path_walker;

/* Returns how many pixels of the truth show something through. */
static size_t walk_truth(dynamic_scene *d, path_walker *w) {
    size_t through = 0;
    d->truth.order = w->order;
    ref_dyn_pixel *truth = dynamic_truth(d, NULL);
    for (size_t i = 0; i < PATH_VALUES; ++i)
        w->now[i] = 255 * truth[i / 3].color[i % 3];
    for (size_t i = 0; i < PATH_PIXELS; ++i)
        through += truth[i].see_through > 0;
    free(truth);
    return through;
}

static void walk_rung(harness *h, dynamic_scene *d, path_walker *w, int step) {
    memset(w->now, 0, PATH_VALUES * sizeof *w->now);
    d->wish.see = w->see;
    for (int f = 0; f < w->frames; ++f) {
        d->wish.frame_index = (uint32_t)(w->still ? f : step * w->frames + f);
        dynamic_draw(h, d);
        unsigned char *pixels = dynamic_read(h, d);
        for (size_t i = 0; i < PATH_VALUES; ++i)
            w->now[i] += (double)pixels[4 * (i / 3) + i % 3] / w->frames;
        free(pixels);
    }
}

static void walk_on(path_walker *w, bool first) {
    double *kept = w->before;
    w->last = first ? 0 : change_between(w->before, w->now, PATH_VALUES);
    w->change += w->last;
    w->before = w->now;
    w->now = kept;
}

/* The change from frame to frame, summed over pixels, against that of the truth of the same order. Dithering's noise is meant
 * to be averaged, as temporal anti-aliasing does: where it is another from frame to frame it is only said how much that
 * changes, of single frames and of the means of 16, in which some of it is left. */
static void frames_change_as_the_truth_does(void **state) {
    enum { FRAMES = FEW ? 10 : 200 };
    path_walker walkers[] = {
        {"truth", TR_SEE_OFF, 0, true, 0, REF_DYN_PER_PIXEL, NULL, NULL, 0, 0, 0},
        {"truth by middles", TR_SEE_OFF, 0, true, 0, REF_DYN_OBJECT_CENTRES, NULL, NULL, 0, 0, 0},
        {"one mask", TR_SEE_ONE_MASK, 1, true, 1.2, REF_DYN_PER_PIXEL, NULL, NULL, 0, 0, 0},
        {"exact", TR_SEE_EXACT, 1, true, 1.2, REF_DYN_PER_PIXEL, NULL, NULL, 0, 0, 0},
        {"sequence", TR_SEE_SEQUENCE, 1, true, 1.2, REF_DYN_OBJECT_CENTRES, NULL, NULL, 0, 0, 0},
        {"dither, still", TR_SEE_DITHER, 1, true, 1.2, REF_DYN_PER_PIXEL, NULL, NULL, 0, 0, 0},
        {"dither", TR_SEE_DITHER, 1, false, 0, REF_DYN_PER_PIXEL, NULL, NULL, 0, 0, 0},
        {"dither, of 16, still", TR_SEE_DITHER, 16, true, 1.2, REF_DYN_PER_PIXEL, NULL, NULL, 0, 0, 0},
        {"dither, of 16", TR_SEE_DITHER, 16, false, 0, REF_DYN_PER_PIXEL, NULL, NULL, 0, 0, 0},
    };
    enum { WALKERS = sizeof walkers / sizeof walkers[0] };
    static const double middle[3] = {0, 0, 0};
    harness h;
    dynamic_scene d;
    size_t showing = 0, through = 0;
    (void)state;
    harness_open(&h, 330, false, NULL);
    harness_target(&h, PATH_WIDTH, PATH_HEIGHT);
    dynamic_open(&d, &h, dynamic_random_field(11, 24, 3, false));
    gather_targets(&d, middle, 1.5);
    dynamic_shade(&d, true);
    dynamic_center(&d);
    for (int i = 0; i < WALKERS; ++i) {
        walkers[i].before = dynamic_need(PATH_VALUES * sizeof(double));
        walkers[i].now = dynamic_need(PATH_VALUES * sizeof(double));
    }
    for (int f = 0; f < FRAMES; ++f) {
        double turn = 0.01 * f;
        const double eye[3] = {16 * cos(turn), 16 * sin(turn), 6 + sin(3 * turn)};
        dynamic_look(&d, eye, middle, 45, PATH_WIDTH, PATH_HEIGHT);
        for (int i = 0; i < WALKERS; ++i) {
            path_walker *w = &walkers[i];
            if (w->frames) {
                walk_rung(&h, &d, w, f);
            } else {
                size_t pixels = walk_truth(&d, w);
                showing += i == 0 && pixels >= 50;
                through += i == 0 ? pixels : 0;
            }
            walk_on(w, f == 0);
            w->worst = f && w->frames ? fmax(w->worst, w->last / walkers[w->order == REF_DYN_OBJECT_CENTRES].last) : 0;
        }
    }
    printf("    %zu of %d frames show 50 pixels and more through, %.0f of %d on average\n", showing, FRAMES,
           (double)through / FRAMES, PATH_PIXELS);
    assert_true(10 * showing >= 9 * FRAMES);
    for (int i = 0; i < WALKERS; ++i) {
        const path_walker *w = &walkers[i];
        double ratio = w->change / walkers[w->order == REF_DYN_OBJECT_CENTRES].change;
        if (w->frames)
            printf("    %-20s changes %.3f times as much as the truth over %d frames, %.3f in the worst\n", w->name,
                   ratio, FRAMES, w->worst);
        assert_true(!(w->bound > 0) || ratio <= w->bound);
        free(w->before);
        free(w->now);
    }
    dynamic_close(&d);
    harness_close(&h);
}

/* ---- where the target is ---- */

/* The same picture with the viewport elsewhere in a larger target, and not a pixel around it touched. */
static void viewports_may_be_anywhere(void **state) {
    enum { X = 13, Y = 7, W = WIDTH + 40, H = HEIGHT + 30 };
    harness h;
    (void)state;
    harness_open(&h, 330, false, NULL);
    for (int see = 0; see < TR_SEE_COUNT; ++see) {
        dynamic_scene d;
        harness_target(&h, WIDTH, HEIGHT);
        unsigned char *should = draw_kind(&h, (tr_see)see, 0), *is = dynamic_need(4 * W * H);
        harness_target(&h, W, H);
        open_kind(&d, &h, 0);
        wish_rung(&d, (tr_see)see, 0);
        d.x = X;
        d.y = Y;
        dynamic_draw(&h, &d);
        glBindFramebuffer(GL_FRAMEBUFFER, h.framebuffer);
        glReadPixels(0, 0, W, H, GL_RGBA, GL_UNSIGNED_BYTE, is);
        size_t outside = 0, differs = 0;
        for (int y = 0; y < H; ++y)
            for (int x = 0; x < W; ++x) {
                bool in = x >= X && x < X + WIDTH && y >= Y && y < Y + HEIGHT;
                const unsigned char *pixel = is + 4 * (W * y + x);
                for (int c = 0; c < 3; ++c) {
                    double around = 255 * d.scene.background[c];
                    outside += !in && fabs(pixel[c] - around) > 0.75;
                    differs += in && pixel[c] != should[4 * (WIDTH * (y - Y) + x - X) + c];
                }
            }
        assert_int_equal(outside, 0);
        /* The noise of dithering is the viewport's; edges fall where they did. */
        assert_int_equal(differs, 0);
        free(should);
        free(is);
        dynamic_close(&d);
    }
    harness_close(&h);
}

/* ---- what is hidden ---- */

/* One pixel in sixteen is looked at: of n that lay at random the count would be off by some sqrt(16 n); and texels at the edge. */
static void queries_count_what_is_hidden(void **state) {
    static const double eye[3] = {9, -14, 6}, middle[3] = {0, 0, 0};
    harness h;
    size_t found = 0;
    (void)state;
    harness_open(&h, 330, false, NULL);
    harness_target(&h, 320, 256);
    for (uint32_t seed = 1; seed <= 8; ++seed) {
        dynamic_scene d;
        tr_hidden hidden[4];
        size_t count = 0;
        dynamic_open(&d, &h, dynamic_random_field(seed, 14, 1, seed % 2 == 0));
        dynamic_look(&d, eye, middle, 45, 320, 256);
        d.wish.see = seed % 3 ? TR_SEE_ONE_MASK : TR_SEE_DITHER;
        d.wish.query = 1;
        dynamic_draw(&h, &d);
        glFinish();
        assert_int_equal(tr_query_hidden(h.tr, hidden, 4, &count), TR_OK);
        ref_dyn_census *census = dynamic_need(d.count * sizeof *census);
        free(dynamic_truth(&d, census));
        double open = (double)(census[0].pixels - census[0].closed),
               behind = (double)(census[0].hidden - census[0].closed);
        if (tr_get_info(h.tr).see_plan->see != TR_SEE_OFF && count) {
            printf("    seed %u: %u of %u pixels hidden, by the truth %.0f of %.0f\n", seed, hidden[0].hidden,
                   hidden[0].pixels, behind, open);
            assert_true(count == 1 && hidden[0].id == d.parts[0] + 1);
            assert_true(fabs(hidden[0].pixels - open) <= 64 + 4 * sqrt(open));
            assert_true(fabs(hidden[0].hidden - behind) <= 64 + 4 * sqrt(behind));
            ++found;
        }
        free(census);
        dynamic_close(&d);
    }
    assert_true(found >= 4);
    harness_close(&h);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_forget_the_ones_before), cmocka_unit_test(viewports_may_be_anywhere),
        cmocka_unit_test(queries_count_what_is_hidden), cmocka_unit_test(frames_change_as_the_truth_does)};
    if (getenv("GLASSINE_TEST"))
        cmocka_set_test_filter(getenv("GLASSINE_TEST"));
    return cmocka_run_group_tests(tests, NULL, NULL);
}

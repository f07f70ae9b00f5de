/* gl_dynamic_frames.c: what a frame of dynamic transparency shows is its own alone: nothing of the frames before it. */
#include "dynamic_scene.h"

/* ---- frames that leave as much behind as they can ---- */

enum { WIDTH = 120, HEIGHT = 90, KINDS = 8 };

/* Wishes and scenes that differ in all that textures, lists and uniforms are made for. */
static void open_kind(dynamic_scene *d, harness *h, int kind) {
    static const double eyes[KINDS][3] = {{9, -14, 6},  {-12, 9, 8}, {14, 4, 3}, {0, -16, 2},
                                          {-9, -12, 9}, {6, 15, 5},  {15, 0, 9}, {3, -13, 12}};
    static const double middle[3] = {0, 0, 0};
    static ref_dyn_light light;
    size_t targets = kind == 5 ? 0 : 1 + (size_t)kind % 4;
    dynamic_open(d, h, dynamic_random_field(60 + (uint32_t)kind, 10 + 3 * (size_t)kind, targets, kind % 2 == 0));
    dynamic_shade(d, true);
    dynamic_look(d, eyes[kind], middle, kind == 3 ? 20 : 45, WIDTH, HEIGHT);
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
    printf("    %zu of 160 frames show something through\n", shown);
    assert_true(shown > 40);
    for (int see = 0; see < TR_SEE_COUNT; ++see)
        for (int kind = 0; kind < KINDS; ++kind)
            free(fresh[see][kind]);
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

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(frames_forget_the_ones_before),
                                       cmocka_unit_test(viewports_may_be_anywhere)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

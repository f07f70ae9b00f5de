/* gl_dynamic_parts.c: a scene that the host draws in parts is the same picture, and leaves the same depth, as one that it
 * draws whole; whatever the target's formats, whatever targets are besides where they are. And TR_WISH_SRGB against the
 * truth: light is blended, not what encodes it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "dynamic_scene.h"

enum { WIDTH = 200, HEIGHT = 160, LEFT = 24, LOW = 16 };

static const double EYE[3] = {9, -14, 6}, ORIGIN[3] = {0, 0, 0};

typedef struct formats {
    const char *name;
    GLenum color, depth, depth_format, depth_type;
    double over; /* share of pixels that may differ: depths are rounded to the target's where these are no floats, which
                    decides of what nearly coincides; three pixels in 24 bits, sixteen in 16 */
} formats;

static const formats targets[] = {
    {"rgba8, depth 24, stencil 8", GL_RGBA8, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 0.0001},
    {"rgba8, depth 24", GL_RGBA8, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 0.0001},
    {"rgba16f, depth 32f", GL_RGBA16F, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 0},
    {"rgb10a2, depth 32f, stencil 8", GL_RGB10_A2, GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL,
     GL_FLOAT_32_UNSIGNED_INT_24_8_REV, 0},
    {"srgb8 that does not encode", GL_SRGB8_ALPHA8, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 0},
    {"rgba8, depth 16", GL_RGBA8, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, 0.0005}};
enum { TARGETS = sizeof targets / sizeof targets[0] };

/* Stands in for the harness's target; larger than what is drawn. */
static void make_target(harness *h, const formats *f) {
    bool stencil = f->depth_format == GL_DEPTH_STENCIL;
    harness_drop_target(h);
    glGenTextures(1, &h->color);
    glBindTexture(GL_TEXTURE_2D, h->color);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)f->color, WIDTH + LEFT, HEIGHT + LOW, 0, GL_RGBA,
                 f->color == GL_RGB10_A2  ? GL_UNSIGNED_INT_2_10_10_10_REV
                 : f->color == GL_RGBA16F ? GL_FLOAT
                                          : GL_UNSIGNED_BYTE,
                 NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glGenTextures(1, &h->depth);
    glBindTexture(GL_TEXTURE_2D, h->depth);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)f->depth, WIDTH + LEFT, HEIGHT + LOW, 0, f->depth_format, f->depth_type,
                 NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    glGenFramebuffers(1, &h->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, h->color, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                           h->depth, 0);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
}

typedef struct picture {
    unsigned char color[4 * WIDTH * HEIGHT];
    float depth[WIDTH * HEIGHT];
} picture;

static void draw(harness *h, dynamic_scene *d, bool in_parts, picture *out) {
    d->wish.in_parts = in_parts;
    dynamic_draw(h, d);
    const tr_see_plan *plan = tr_get_info(h->tr).see_plan;
    assert_int_equal(plan->see, d->wish.see);
    if (plan->parts_why)
        fail_msg("not in parts: %s", plan->parts_why);
    assert_int_equal(plan->in_parts, in_parts);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(d->x, d->y, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, out->color);
    glReadPixels(d->x, d->y, WIDTH, HEIGHT, GL_DEPTH_COMPONENT, GL_FLOAT, out->depth);
}

/* What targets are besides where they are. */
enum { JUST_THERE, SOME_YIELD_IN_PART, ONE_FADES, LIGHTS, QUERIES, NO_GRADIENT, KINDS };

/* Whether targets are drawn once more for it: then the viewport has to begin at the target's corner. */
static bool is_marked(int kind) {
    return kind == SOME_YIELD_IN_PART || kind == ONE_FADES || kind == LIGHTS || kind == QUERIES;
}

static void make_kind(dynamic_scene *d, int kind, ref_dyn_light *light) {
    d->truth.width = kind == NO_GRADIENT ? 0 : 8;
    if (kind == SOME_YIELD_IN_PART)
        for (size_t i = 3; i < d->count; i += 3)
            d->marks[i].importance = 0.4;
    if (kind == ONE_FADES)
        d->marks[0].faded = 0.5;
    if (kind == LIGHTS) {
        light->x = WIDTH / 2;
        light->y = HEIGHT / 2;
        light->radius = 30;
        light->edge = 20;
        d->truth.lights = light;
        d->truth.light_count = 1;
        d->marks[1].flags |= REF_DYN_ACTIVE;
    }
    d->wish.query = kind == QUERIES;
}

static void parts_are_the_whole(void **state) {
    static picture whole, parts;
    harness h;
    (void)state;
    harness_open(&h, 330, false, NULL);
    for (int t = 0; t < TARGETS; ++t)
        for (int kind = 0; kind < KINDS; ++kind)
            for (uint32_t seed = 1; seed <= 3; ++seed) {
                ref_dyn_light light = {0};
                dynamic_scene d;
                size_t over[2] = {0, 0}, deeper = 0, open = 0;
                make_target(&h, &targets[t]);
                dynamic_open(&d, &h, dynamic_random_field(seed, 60, 8, seed != 2)); /* seed 2: nothing closes masks */
                dynamic_look(&d, EYE, ORIGIN, 45, WIDTH, HEIGHT);
                d.x = seed == 3 && !is_marked(kind) ? LEFT : 0;
                d.y = seed == 3 && !is_marked(kind) ? LOW : 0;
                if (seed == 1)
                    d.marks[4].flags = REF_DYN_BACKDROP;
                make_kind(&d, kind, &light);
                for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_DITHER; ++see) {
                    d.wish.see = (tr_see)see;
                    d.wish.frame_index = seed;
                    draw(&h, &d, false, &whole);
                    draw(&h, &d, true, &parts);
                    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
                        bool differs = false;
                        for (int c = 0; c < 3; ++c)
                            differs |= abs(whole.color[4 * i + c] - parts.color[4 * i + c]) > 1;
                        over[see] += differs;
                        deeper += fabsf(whole.depth[i] - parts.depth[i]) > 0; /* the same triangles were drawn there */
                    }
                }
                d.wish.see = TR_SEE_OFF;
                dynamic_draw(&h, &d);
                glReadPixels(d.x, d.y, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, parts.color);
                d.wish.see = TR_SEE_ONE_MASK;
                draw(&h, &d, false, &whole);
                for (int i = 0; i < WIDTH * HEIGHT; ++i)
                    open += memcmp(&whole.color[4 * i], &parts.color[4 * i], 3) != 0;
                if (over[0] + over[1] + deeper)
                    printf(
                        "    %-30s kind %d seed %u: %zu, %zu pixels differ of %zu that are see-through, %zu in depth\n",
                        targets[t].name, kind, seed, over[0], over[1], open, deeper);
                assert_true(open > 200);
                for (int see = 0; see < 2; ++see)
                    assert_true((double)over[see] <= targets[t].over * WIDTH * HEIGHT);
                assert_true((double)deeper <= targets[t].over * WIDTH * HEIGHT);
                dynamic_close(&d);
            }
    harness_close(&h);
}

/* ---- contexts ---- */

typedef struct drawn {
    unsigned char color[2][4 * WIDTH * HEIGHT];
} drawn;

/* Renderbuffers, two of them of colour; and the framebuffer is read from the second. Depths are floats, as ours are: of
 * others a pixel may differ where rounding decides. */
static void make_buffers(harness *h, GLuint buffers[3]) {
    static const GLenum both[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1},
                        points[3] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_DEPTH_ATTACHMENT};
    harness_drop_target(h);
    glGenFramebuffers(1, &h->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glGenRenderbuffers(3, buffers);
    for (int i = 0; i < 3; ++i) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
        glRenderbufferStorage(GL_RENDERBUFFER, i < 2 ? GL_RGBA8 : GL_DEPTH32F_STENCIL8, WIDTH, HEIGHT);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, points[i], GL_RENDERBUFFER, buffers[i]); /* the depth alone */
    }
    glDrawBuffers(2, both);
    glReadBuffer(both[1]);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
}

static void draw_both(harness *h, dynamic_scene *d, bool in_parts, drawn *out) {
    GLint read = 0;
    d->wish.in_parts = in_parts;
    dynamic_draw(h, d);
    const tr_see_plan *plan = tr_get_info(h->tr).see_plan;
    assert_int_equal(plan->see, d->wish.see);
    assert_true(plan->in_parts == (int)in_parts && !plan->parts_why);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glGetIntegerv(GL_READ_BUFFER, &read);
    assert_int_equal(read, GL_COLOR_ATTACHMENT1);
    for (int k = 1; k >= 0; --k) {
        glReadBuffer((GLenum)(GL_COLOR_ATTACHMENT0 + k));
        glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, out->color[k]);
    }
    glReadBuffer(GL_COLOR_ATTACHMENT1);
}

/* The picture is that of the first draw buffer, whichever one is read from; the others are as the host draws them. */
static void try_context(int version, bool es, bool reversed) {
    static drawn whole, parts;
    harness h;
    dynamic_scene d;
    ref_dyn_light light = {0};
    GLuint buffers[3];
    tr_desc desc = {0};
    desc.reversed_z = desc.zero_to_one = reversed;
    harness_open(&h, version, es, &desc);
    make_buffers(&h, buffers);
    dynamic_open(&d, &h, dynamic_random_field(1, 60, 8, true));
    dynamic_look(&d, EYE, ORIGIN, 45, WIDTH, HEIGHT);
    if (reversed) {
        dynamic_reverse(&d);
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    }
    d.see.defines = "#define SECOND_TARGET\n";
    for (int kind = JUST_THERE; kind <= LIGHTS; kind += LIGHTS)
        for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_DITHER; ++see) {
            make_kind(&d, kind, &light);
            d.wish.see = (tr_see)see;
            draw_both(&h, &d, false, &whole);
            draw_both(&h, &d, true, &parts);
            for (size_t i = 0; i < sizeof whole.color[0]; ++i)
                assert_true(i % 4 == 3 || abs(whole.color[0][i] - parts.color[0][i]) <= 1);
            if (!es || version >= 320) /* before there is no mask a draw buffer */
                assert_memory_equal(whole.color[1], parts.color[1], sizeof whole.color[1]);
        }
    dynamic_close(&d);
    glDeleteRenderbuffers(3, buffers);
    harness_close(&h);
}

static void parts_in_every_context(void **state) {
    (void)state;
    try_context(330, false, false);
    try_context(450, false, false);
    try_context(450, false, true);
    try_context(300, true, false);
    try_context(320, true, false);
}

/* ---- light ---- */

static double encoded(double light) {
    double e = light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1 / 2.4) - 0.055;
    return 255 * fmin(fmax(e, 0), 1);
}

/* The largest of a pixel's differences, in 255ths. */
static double pixel_off(const ref_dyn_pixel *truth, const unsigned char *pixel, bool srgb) {
    double off = 0;
    for (size_t c = 0; c < 3; ++c)
        off = fmax(off, fabs((srgb ? encoded(truth->color[c]) : 255 * truth->color[c]) - pixel[c]));
    return off;
}

/* The truth's colours are light; the target encodes them, and so do the textures that what shows through passes. Of one
 * target one mask is the truth but for outline pixels: what is not right without encoding is not asked for with it. */
static void light_is_blended(void **state) {
    static const formats encodings[2] = {{"linear", GL_RGBA8, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, 0, 0},
                                         {"srgb8", GL_SRGB8_ALPHA8, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, 0, 0}};
    harness h;
    size_t compared[2] = {0, 0}, over[2] = {0, 0};
    (void)state;
    harness_open(&h, 330, false, NULL);
    for (uint32_t seed = 1; seed <= 12; ++seed) {
        static unsigned char pixels[2][4 * WIDTH * HEIGHT];
        dynamic_scene d;
        dynamic_open(&d, &h, dynamic_random_field(seed, 16, 1, false));
        dynamic_shade(&d, true);
        dynamic_look(&d, EYE, ORIGIN, 45, WIDTH, HEIGHT);
        d.truth.width = 8;
        ref_dyn_pixel *truth = dynamic_truth(&d, NULL);
        for (int k = 0; k < 4; ++k) {
            const int srgb = k & 1, in_parts = k / 2;
            formats made = encodings[srgb];
            char message[2048] = "";
            tr_frame frame;
            made.depth_type = GL_UNSIGNED_INT_24_8;
            make_target(&h, &made);
            memset(&frame, 0, sizeof frame);
            frame.framebuffer = h.framebuffer;
            frame.width = WIDTH;
            frame.height = HEIGHT;
            frame.wishes.options = srgb ? TR_WISH_SRGB : 0;
            d.wish.see = TR_SEE_ONE_MASK;
            d.wish.mask_divisor = 1;
            d.wish.in_parts = in_parts;
            dynamic_agree(&d);
            if (srgb)
                glEnable(GL_FRAMEBUFFER_SRGB);
            dynamic_set_state(&h, &d, 1.0f);
            assert_true(battlefield_see_draw(&d.see, &d.look, &frame, &d.wish, message, sizeof message));
            glDisable(GL_FRAMEBUFFER_SRGB);
            assert_int_equal(tr_get_info(h.tr).see_plan->in_parts, in_parts && tr_get_info(h.tr).see_plan->masks > 0);
            glBindFramebuffer(GL_FRAMEBUFFER, h.framebuffer);
            glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, pixels[srgb]);
            for (size_t i = 0; srgb && i < WIDTH * HEIGHT; ++i)
                if (!truth[i].left_out && truth[i].see_through && pixel_off(&truth[i], &pixels[0][4 * i], false) <= 1) {
                    ++compared[in_parts];
                    over[in_parts] += pixel_off(&truth[i], &pixels[1][4 * i], true) > 3;
                }
        }
        free(truth);
        dynamic_close(&d);
    }
    for (int in_parts = 0; in_parts < 2; ++in_parts) {
        printf("    light, %s: %zu of %zu pixels are off by more than 3/255\n", in_parts ? "in parts" : "whole",
               over[in_parts], compared[in_parts]);
        assert_true(compared[in_parts] > 1000 && over[in_parts] == 0);
    }
    harness_close(&h);
}

/* Where the target encodes and TR_WISH_SRGB does not say so the scene comes whole: ours would not hold what it shows. */
static void unsaid_encoding_comes_whole(void **state) {
    static const formats srgb = {"srgb8",          GL_SRGB8_ALPHA8,      GL_DEPTH24_STENCIL8,
                                 GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 0};
    (void)state;
    for (int es = 0; es < 2; ++es) {
        harness h;
        dynamic_scene d;
        harness_open(&h, es ? 300 : 330, es, NULL);
        make_target(&h, &srgb);
        dynamic_open(&d, &h, dynamic_random_field(1, 60, 8, true));
        dynamic_look(&d, EYE, ORIGIN, 45, WIDTH, HEIGHT);
        if (!es)
            glEnable(GL_FRAMEBUFFER_SRGB);
        d.wish.in_parts = 1;
        dynamic_draw(&h, &d);
        assert_int_equal(tr_get_info(h.tr).see_plan->see, TR_SEE_ONE_MASK);
        assert_true(!tr_get_info(h.tr).see_plan->in_parts && tr_get_info(h.tr).see_plan->parts_why);
        dynamic_close(&d);
        harness_close(&h);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(parts_are_the_whole), cmocka_unit_test(parts_in_every_context),
                                       cmocka_unit_test(light_is_blended),
                                       cmocka_unit_test(unsaid_encoding_comes_whole)};
    if (getenv("GLASSINE_TEST"))
        cmocka_set_test_filter(getenv("GLASSINE_TEST"));
    return cmocka_run_group_tests(tests, NULL, NULL);
}

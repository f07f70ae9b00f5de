/* mock_transparency.c: transparency.h on a driver that is not there: plans, call order, missing functions, failing
 * shaders and framebuffers, what a steady frame may not call, and that nothing is left behind. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TRANSPARENCY_IMPLEMENTATION
#include "transparency.h"

#include "mock_driver.h"

static const char *const required_names[] = {
#define NAME(type, function, parameters) "gl" #function,
    TR_I_GL_REQUIRED(NAME)
#undef NAME
};

static tr_frame make_frame(uint32_t opaque, uint32_t transparent) {
    tr_frame frame = {0};
    frame.width = 64;
    frame.height = 32;
    frame.scene.opaque = opaque;
    frame.scene.transparent = transparent;
    frame.wishes.lines = TR_LINES_CREASES | TR_LINES_OUTLINES;
    return frame;
}

static int run_frame(tr_context *tr, const tr_frame *frame) {
    tr_pass pass;
    int passes = 0;
    assert_int_equal(tr_begin(tr, frame), TR_OK);
    uint32_t array = driver.vertex_array;
    while (tr_next_pass(tr, &pass)) {
        check_units();
        assert_int_equal(driver.vertex_array, array); /* full-screen passes put the host's back */
        ++passes;
    }
    assert_int_equal(tr_end(tr), TR_OK);
    return passes;
}

/* ---- creation ---- */

static void test_each_missing_function_is_named(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof required_names / sizeof required_names[0]; ++i) {
        tr_result result;
        tr_desc desc = make_desc(TR_STATE_RESTORE);
        reset_driver();
        driver.missing = required_names[i];
        assert_null(tr_create(&desc, &result));
        assert_int_equal(result, TR_GL_FUNCTION_MISSING);
        assert_non_null(strstr(driver.text, required_names[i]));
        assert_nothing_left();
    }
}

static void test_versions(void **state) {
    static const struct {
        const char *version;
        int max, expected, es; /* expected 0: too old */
    } cases[] = {
        {"3.3.0 NVIDIA 470", 0, 330, 0},
        {"4.6 (Core Profile) Mesa", 0, 460, 0},
        {"OpenGL ES 3.0 Mesa", 0, 300, 1},
        {"OpenGL ES 3.2 v1.r1", 0, 320, 1},
        {"4.6", 330, 330, 0},
        {"3.2.0", 0, 0, 0},
        {"OpenGL ES 2.0", 0, 0, 1},
        {"OpenGL ES-CM 1.1", 0, 0, 0},
        {"", 0, 0, 0},
        {NULL, 0, 0, 0},
        {"4", 0, 0, 0},
        {"4.", 0, 0, 0},
        {"four.five", 0, 0, 0},
        {"4.5", 320, 0, 0},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        tr_result result;
        tr_desc desc = make_desc(TR_STATE_RESTORE);
        reset_driver();
        driver.version = cases[i].version;
        desc.max_gl_version = cases[i].max;
        tr_context *tr = tr_create(&desc, &result);
        if (cases[i].expected) {
            assert_non_null(tr);
            assert_int_equal(tr_get_info(tr).version, cases[i].expected);
            assert_int_equal(tr_get_info(tr).es, cases[i].es);
        } else {
            assert_null(tr);
            assert_int_equal(result, TR_GL_TOO_OLD);
        }
        tr_destroy(tr);
        assert_nothing_left();
    }
}

static void test_bad_descs(void **state) {
    tr_result result;
    tr_desc desc = make_desc(TR_STATE_RESTORE);
    (void)state;
    reset_driver();
    assert_null(tr_create(NULL, &result));
    assert_int_equal(result, TR_INVALID_ARGUMENT);
    desc.free_fn = NULL;
    assert_null(tr_create(&desc, &result));
    assert_int_equal(result, TR_INVALID_ARGUMENT);
    desc = make_desc(TR_STATE_RESTORE);
    desc.get_proc = NULL;
    assert_null(tr_create(&desc, NULL));
    desc = make_desc((tr_state_policy)7);
    assert_null(tr_create(&desc, &result));
    desc = make_desc(TR_STATE_RESTORE);
    desc.first_texture_unit = 28; /* five of 32 do not fit */
    assert_null(tr_create(&desc, &result));
    assert_int_equal(result, TR_INVALID_ARGUMENT);
    assert_non_null(strstr(driver.text, "first_texture_unit"));
    desc = make_desc(TR_STATE_RESTORE);
    desc.uniform_binding = 36;
    assert_null(tr_create(&desc, &result));
    assert_non_null(strstr(driver.text, "uniform_binding"));
    desc = make_desc(TR_STATE_RESTORE);
    blocks_left = 0;
    assert_null(tr_create(&desc, &result));
    assert_int_equal(result, TR_OUT_OF_MEMORY);
    assert_nothing_left();
}

/* ---- frames ---- */

static void test_failing_shaders_are_reported(void **state) {
    (void)state;
    for (int how = 1; how <= 2; ++how) {
        tr_desc desc = make_desc(TR_STATE_RESTORE);
        tr_frame frame = make_frame(1, 2);
        reset_driver();
        tr_context *tr = tr_create(&desc, NULL);
        driver.fail_compile = how;
        assert_int_equal(tr_begin(tr, &frame), TR_SHADER_FAILED);
        assert_non_null(strstr(driver.text, how == 1 ? "compile trouble" : "link trouble"));
        assert_int_equal(tr_prepare_program(tr, 5), how == 1 ? TR_OK : TR_INVALID_ARGUMENT); /* not linked */
        assert_int_equal(driver.live[SHADERS], 0);
        assert_int_equal(driver.live[PROGRAMS], 0);
        driver.fail_compile = 0;
        assert_true(run_frame(tr, &frame) > 0); /* the next frame works */
        tr_destroy(tr);
        assert_nothing_left();
    }
}

static void test_failing_framebuffers_leave_nothing(void **state) {
    (void)state;
    for (int n = 1; n <= 8; ++n) { /* the target's check, then seven of our own */
        tr_desc desc = make_desc(TR_STATE_RESTORE);
        tr_frame frame = make_frame(1, 2);
        frame.scene.group_size = 2;
        reset_driver();
        tr_context *tr = tr_create(&desc, NULL);
        driver.fail_framebuffer = n;
        assert_int_equal(tr_begin(tr, &frame), TR_TARGET_INCOMPLETE);
        assert_int_equal(driver.live[TEXTURES], 0);
        assert_int_equal(driver.live[FRAMEBUFFERS], 0);
        assert_true(run_frame(tr, &frame) > 0);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

static void test_bad_frames(void **state) {
    tr_desc desc = make_desc(TR_STATE_RESTORE);
    tr_pass pass;
    (void)state;
    reset_driver();
    tr_context *tr = tr_create(&desc, NULL);
    tr_frame frame = make_frame(1, 1);
    assert_int_equal(tr_begin(tr, NULL), TR_INVALID_ARGUMENT);
    assert_int_equal(tr_begin(NULL, &frame), TR_INVALID_ARGUMENT);
    assert_int_equal(tr_end(tr), TR_WRONG_ORDER);
    assert_false(tr_next_pass(tr, &pass));
    frame.width = -1;
    assert_int_equal(tr_begin(tr, &frame), TR_INVALID_ARGUMENT);
    frame.width = 16385;
    assert_int_equal(tr_begin(tr, &frame), TR_TOO_LARGE);
    frame = make_frame(1, 1);
    frame.light[0] = frame.light[1] = 3e38f; /* any length */
    assert_int_equal(tr_begin(tr, &frame), TR_OK);
    assert_int_equal(tr_end(tr), TR_OK);
    frame.framebuffer = 77; /* the driver knows no such name */
    driver.refused_framebuffer = 77;
    assert_int_equal(tr_begin(tr, &frame), TR_TARGET_INCOMPLETE);
    frame = make_frame(1, 1);
    frame.light[1] = NAN;
    assert_int_equal(tr_begin(tr, &frame), TR_INVALID_ARGUMENT);
    frame = make_frame(1, 1);
    frame.warm[2] = INFINITY;
    assert_int_equal(tr_begin(tr, &frame), TR_INVALID_ARGUMENT);
    frame = make_frame(1, 1);
    frame.wishes.blending = (tr_blending)3;
    assert_int_equal(tr_begin(tr, &frame), TR_INVALID_ARGUMENT);
    frame = make_frame(1, 1);
    frame.group_distance = 1; /* distances of what projection? */
    assert_int_equal(tr_begin(tr, &frame), TR_INVALID_ARGUMENT);
    frame.group_distance = NAN;
    assert_int_equal(tr_begin(tr, &frame), TR_INVALID_ARGUMENT);
    frame = make_frame(1, 1);
    frame.projection[5] = INFINITY;
    assert_int_equal(tr_begin(tr, &frame), TR_INVALID_ARGUMENT);
    frame = make_frame(1, 1);
    frame.jitter[1] = NAN;
    assert_int_equal(tr_begin(tr, &frame), TR_INVALID_ARGUMENT);
    frame = make_frame(1, 1);
    frame.blend_color[2] = NAN;
    assert_int_equal(tr_begin(tr, &frame), TR_INVALID_ARGUMENT);
    frame = make_frame(1, 1);
    frame.width = 8192;
    frame.wishes.supersample = 3; /* 24576 texels */
    assert_int_equal(tr_begin(tr, &frame), TR_TOO_LARGE);
    frame = make_frame(1, 1);
    driver.samples = 4; /* served by textures twice as large, if they may be */
    assert_int_equal(tr_begin(tr, &frame), TR_OK);
    assert_int_equal(tr_get_info(tr).plan->supersample, 2);
    assert_int_equal(tr_end(tr), TR_OK);
    frame.width = 16000;
    assert_int_equal(tr_begin(tr, &frame), TR_OK);
    assert_int_equal(tr_get_info(tr).plan->supersample, 1);
    assert_int_equal(tr_end(tr), TR_OK);
    frame = make_frame(1, 1);
    driver.samples = 0;
    frame.width = 0; /* no area: no pass, no error, no call into GL */
    int before = driver.call_count;
    assert_int_equal(tr_begin(tr, &frame), TR_OK);
    assert_false(tr_next_pass(tr, &pass));
    assert_int_equal(tr_end(tr), TR_OK);
    assert_int_equal(driver.call_count, before);
    frame = make_frame(1, 1);
    assert_int_equal(tr_begin(tr, &frame), TR_OK);
    assert_int_equal(tr_begin(tr, &frame), TR_WRONG_ORDER);
    assert_int_equal(tr_end(tr), TR_OK); /* early: passes left out */
    tr_destroy(tr);
    assert_nothing_left();
}

/* From the second frame on: nothing created, deleted, compiled, uploaded, allocated, read back or waited for. */
static void test_steady_frames_create_nothing(void **state) {
    static const char *const never[] = {
        "GenTextures",   "GenFramebuffers", "GenBuffers",     "GenVertexArrays",     "CreateShader",
        "CreateProgram", "TexImage2D",      "BufferData",     "BufferSubData",       "CompileShader",
        "LinkProgram",   "ShaderSource",    "DeleteTextures", "DeleteFramebuffers",  "GetUniformLocation",
        "Finish",        "ReadPixels",      "GetError",       "FramebufferTexture2D"};
    (void)state;
    for (int policy = 0; policy < 4; ++policy) {
        tr_desc desc = make_desc((tr_state_policy)policy);
        tr_frame frame = make_frame(3, 4);
        reset_driver();
        tr_context *tr = tr_create(&desc, NULL);
        run_frame(tr, &frame);
        int first = driver.call_count, allocated = blocks_left;
        for (int i = 0; i < 5; ++i)
            run_frame(tr, &frame);
        for (size_t i = 0; i < sizeof never / sizeof never[0]; ++i)
            assert_int_equal(called_since(first, never[i]), 0);
        assert_int_equal(blocks_left, allocated);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

/* STATE_NONE: in a steady frame not one GL call is made between tr_begin and tr_end. */
static void test_state_none_makes_no_call(void **state) {
    tr_desc desc = make_desc(TR_STATE_NONE);
    tr_frame frame = make_frame(3, 4);
    tr_pass pass;
    int full_screen = 0;
    (void)state;
    reset_driver();
    tr_context *tr = tr_create(&desc, NULL);
    run_frame(tr, &frame);
    int before = driver.call_count;
    assert_int_equal(tr_begin(tr, &frame), TR_OK);
    while (tr_next_pass(tr, &pass)) {
        assert_true(pass.state.program != 0);
        full_screen += pass.state.vertex_count == 3 && pass.state.vertex_array != 0;
    }
    assert_int_equal(tr_end(tr), TR_OK);
    assert_int_equal(driver.call_count, before);
    assert_int_equal(full_screen, 2); /* the copy of depth and the composition are the host's to draw */
    tr_destroy(tr);
    assert_nothing_left();
}

/* Each pass switches off what would change its picture, whatever the host had on. */
static void test_passes_switch_off(void **state) {
    static const uint32_t names[] = {
        0x0B90,                 /* stencil test */
        0x0C11,                 /* scissor test */
        0x8037,                 /* polygon offset: fill, line, point */
        0x2A02, 0x2A01, 0x809E, /* sample alpha to coverage, sample coverage, sample mask */
        0x80A0, 0x8E51, 0x8C89, /* rasterizer discard */
        0x0BF2,                 /* colour logic op */
        0x864F,                 /* depth clamp */
        0x0BD0,                 /* dither */
        0x3000, 0x3001, 0x3007  /* clip distances */
    };
    tr_desc desc = make_desc(TR_STATE_RESTORE);
    tr_frame frame = make_frame(1, 2);
    tr_pass pass;
    (void)state;
    reset_driver();
    tr_context *tr = tr_create(&desc, NULL);
    assert_int_equal(tr_begin(tr, &frame), TR_OK);
    for (;;) {
        memset(driver.switched_off, 0, sizeof driver.switched_off);
        if (!tr_next_pass(tr, &pass))
            break;
        for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i)
            if (!driver.switched_off[names[i]])
                fail_msg("%s leaves switch %x on", pass.name, (unsigned)names[i]);
    }
    assert_int_equal(tr_end(tr), TR_OK);
    tr_destroy(tr);
    assert_nothing_left();
}

/* No pass reads a texture that it draws into. */
static void test_no_pass_reads_what_it_draws(void **state) {
    (void)state;
    for (int variant = 0; variant < 240; ++variant) {
        tr_desc desc = make_desc(variant < 120 ? TR_STATE_NONE : TR_STATE_RESTORE);
        tr_frame frame = make_frame((uint32_t)variant % 2, (uint32_t)variant / 2 % 3);
        tr_pass pass;
        frame.scene.transparent_two_sided = (uint32_t)variant / 6 % 2;
        frame.wishes.interior = (tr_interior)(variant / 12 % 5);
        frame.wishes.layers = frame.wishes.interior == TR_INTERIOR_LAYERS ? 5 : 0;
        frame.wishes.lines = 15;
        if (variant / 60 % 2)
            frame.scene.group_size = frame.scene.transparent + frame.scene.transparent_two_sided;
        reset_driver();
        tr_context *tr = tr_create(&desc, NULL);
        assert_int_equal(tr_begin(tr, &frame), TR_OK);
        driver.vertex_array = 0;
        while (tr_next_pass(tr, &pass)) {
            if (desc.state == TR_STATE_RESTORE)
                check_units();
            tr_i_attachment drawn[3];
            int fbo = tr_i_fbo_of(&tr->plan.passes[tr->next_pass - 1]);
            if (fbo < 0)
                continue;
            tr_i_attachments_of(fbo, drawn);
            for (int unit = 0; unit < TR_TEXTURE_UNITS; ++unit)
                for (int a = 0; a < 3; ++a)
                    if (drawn[a].texture >= 0 && pass.state.textures[unit])
                        assert_int_not_equal(pass.state.textures[unit], tr->textures[drawn[a].texture]);
        }
        assert_int_equal(tr_end(tr), TR_OK);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

static void test_resizing_leaks_nothing(void **state) {
    tr_desc desc = make_desc(TR_STATE_RESTORE);
    (void)state;
    reset_driver();
    tr_context *tr = tr_create(&desc, NULL);
    for (int i = 0; i < 20; ++i) {
        tr_frame frame = make_frame((uint32_t)i % 2, (uint32_t)i % 3);
        frame.width = 1 + i % 7;
        driver.call_count = 0;
        run_frame(tr, &frame);
        assert_true(driver.live[TEXTURES] <= 7);
    }
    tr_frame frame = make_frame(1, 1);
    assert_int_equal(tr_begin(tr, &frame), TR_OK);
    assert_int_equal(tr_release(tr), TR_WRONG_ORDER); /* the frame's passes need them */
    assert_int_equal(tr_end(tr), TR_OK);
    assert_int_equal(tr_release(tr), TR_OK);
    assert_int_equal(tr_release(NULL), TR_INVALID_ARGUMENT);
    assert_int_equal(driver.live[TEXTURES], 0);
    assert_int_equal(tr_get_info(tr).bytes, 0);
    tr_destroy(tr);
    assert_nothing_left();
}

/* ---- lost contexts ---- */

/* One frame, whatever becomes of it; the sequence ends. */
static tr_result try_frame(tr_context *tr, const tr_frame *frame) {
    tr_pass pass;
    tr_material material = {0};
    int passes = 0;
    tr_result result = tr_begin(tr, frame);
    while (tr_next_pass(tr, &pass)) {
        assert_true(++passes <= TR_MAX_PASSES);
        tr_set_material(tr, &pass, &material);
    }
    tr_result ended = tr_end(tr);
    assert_int_equal(ended, result == TR_OK ? TR_OK : TR_WRONG_ORDER);
    return result;
}

/* A program's life: two steady frames, another size, all given back, once more, the end. */
static void live_with_losses(tr_state_policy policy) {
    tr_desc desc = make_desc(policy);
    tr_result result = TR_OK;
    tr_frame frame = make_frame(1, 2);
    tr_context *tr = tr_create(&desc, &result);
    assert_true(tr ? result == TR_OK : result == TR_GL_TOO_OLD || result == TR_INVALID_ARGUMENT);
    for (int i = 0; tr && i < 4; ++i) {
        bool before = lost();
        if (i == 2)
            frame.width = 65;
        if (i == 3)
            tr_release(tr);
        result = try_frame(tr, &frame);
        assert_true(result == TR_OK || lost());
        if (before && policy != TR_STATE_NONE) /* with that policy a steady frame asks GL for nothing */
            assert_int_not_equal(result, TR_OK);
    }
    if (tr)
        tr_prepare_program(tr, 1);
    tr_destroy(tr);
    assert_int_equal(blocks, 0);
    if (!lost())
        assert_nothing_left();
}

/* The context is lost at the first call, the second, and so on through a program's life: nothing hangs, crashes or reads
 * what was never answered (valgrind and the sanitizers watch), frames fail and say so, and the heap block is given back. */
static void test_contexts_are_lost_at_every_call(void **state) {
    static const tr_state_policy policies[] = {TR_STATE_RESTORE, TR_STATE_LEAVE_DEFAULTS, TR_STATE_LEAVE_DIRTY,
                                               TR_STATE_NONE};
    (void)state;
    for (int p = 0; p < 4; ++p) {
        int losses = 0;
        do {
            reset_driver();
            driver.lost_at = ++losses;
            live_with_losses(policies[p]);
        } while (lost());
        printf("    policy %d: lost at each of %d calls\n", p, losses - 1);
        assert_true(losses > 500);
    }
}

/* ---- plans ---- */

static int count_kind(const tr_plan *plan, tr_pass_kind kind) {
    int count = 0;
    for (int i = 0; i < plan->pass_count; ++i)
        count += plan->passes[i].kind == kind;
    return count;
}

/* What is not in the scene or not wished costs no pass and no byte. */
static void test_plans_hold_only_what_is_needed(void **state) {
    tr_scene scene = {0};
    tr_wishes wishes = {0};
    tr_plan plan;
    (void)state;
    assert_int_equal(tr_plan_make(&scene, &wishes, &plan), TR_OK);
    assert_int_equal(plan.pass_count, 0);
    assert_int_equal(plan.bytes_per_pixel, 0);
    scene.opaque = 5;
    tr_plan_make(&scene, &wishes, &plan);
    assert_int_equal(plan.pass_count, 2); /* opaque, compose */
    assert_int_equal(plan.bytes_per_pixel, 8);
    scene.transparent = 1;
    tr_plan_make(&scene, &wishes, &plan);
    assert_int_equal(count_kind(&plan, TR_PASS_LAYER), 0); /* alone: nobody to tie with */
    assert_int_equal(count_kind(&plan, TR_PASS_LIMIT), 1);
    assert_int_equal(plan.bytes_per_pixel, 16);
    scene.transparent = 2;
    tr_plan_make(&scene, &wishes, &plan);
    assert_int_equal(count_kind(&plan, TR_PASS_LAYER), 1);
    assert_int_equal(plan.bytes_per_pixel, 20);
    wishes.lines = TR_LINES_OUTLINES;
    tr_plan_make(&scene, &wishes, &plan);
    assert_int_equal(count_kind(&plan, TR_PASS_OPAQUE_LINES), 1);
    assert_int_equal(count_kind(&plan, TR_PASS_TRANSPARENT_LINES), 1);
    assert_int_equal(plan.bytes_per_pixel, 24);
    scene.opaque = 0;
    tr_plan_make(&scene, &wishes, &plan);
    assert_int_equal(count_kind(&plan, TR_PASS_LIMIT), 0); /* nothing to limit */
    assert_int_equal(count_kind(&plan, TR_PASS_COPY_DEPTH), 0);
    wishes.interior = TR_INTERIOR_IMPLICIT_PUBLISHED;
    tr_plan_make(&scene, &wishes, &plan);
    assert_int_equal(count_kind(&plan, TR_PASS_LIMIT), 1); /* there it hides front faces as well */
}

static void test_largest_plan_fits(void **state) {
    tr_scene scene = {0};
    scene.opaque = scene.opaque_two_sided = scene.transparent = scene.transparent_two_sided = UINT32_MAX;
    tr_plan plan;
    (void)state;
    for (int interior = 0; interior < 5; ++interior) {
        tr_wishes wishes = {0};
        wishes.interior = (tr_interior)interior;
        wishes.lines = 15;
        wishes.layers = TR_MAX_LAYERS;
        scene.group_size = interior % 2 ? 0 : UINT32_MAX;
        assert_int_equal(tr_plan_make(&scene, &wishes, &plan), TR_OK);
        assert_true(plan.pass_count <= TR_MAX_PASSES);
        assert_int_equal(plan.layers, interior == TR_INTERIOR_LAYERS || scene.group_size > 1 ? TR_MAX_LAYERS : 1);
        if (interior == TR_INTERIOR_IMPLICIT_PUBLISHED)
            assert_int_equal(count_kind(&plan, TR_PASS_LAYER), 2);
        else
            assert_int_equal(count_kind(&plan, TR_PASS_LAYER), 2 * plan.layers);
        uint32_t bytes = 0;
        for (int i = 0; i < plan.pass_count; ++i) {
            assert_non_null(plan.passes[i].why);
            bytes += plan.passes[i].bytes_per_pixel;
        }
        assert_int_equal(bytes, plan.bytes_per_pixel);
    }
    assert_int_equal(tr_plan_make(NULL, NULL, &plan), TR_INVALID_ARGUMENT);
}

/* ---- modes: passes, GL calls of a steady frame, bytes a pixel; as in docs/transparency.md ---- */

typedef struct mode {
    const char *name;
    uint32_t opaque, transparent, sheets, group, explicit_asked;
    tr_interior interior;
    uint32_t layers, lines, supersample;
    int passes, calls;
    uint32_t bytes;
} mode;

static const mode modes[] = {
    {"opaque alone", 3, 0, 0, 0, 0, TR_INTERIOR_IMPLICIT, 0, 0, 0, 2, 303, 8},
    {"one object, implicit", 3, 1, 0, 0, 0, TR_INTERIOR_IMPLICIT, 0, 0, 0, 4, 442, 16},
    {"one object, explicit", 3, 1, 0, 0, 0, TR_INTERIOR_EXPLICIT, 0, 0, 0, 4, 442, 16},
    {"implicit", 3, 4, 0, 0, 0, TR_INTERIOR_IMPLICIT, 0, 0, 0, 5, 512, 20},
    {"as published", 3, 4, 0, 0, 0, TR_INTERIOR_IMPLICIT_PUBLISHED, 0, 0, 0, 5, 512, 20},
    {"explicit", 3, 4, 0, 0, 0, TR_INTERIOR_EXPLICIT, 0, 0, 0, 5, 512, 20},
    {"mixed", 3, 4, 0, 0, 2, TR_INTERIOR_IMPLICIT, 0, 0, 0, 5, 512, 21},
    {"with sheets", 3, 4, 2, 0, 0, TR_INTERIOR_IMPLICIT, 0, 0, 0, 8, 719, 20},
    {"nothing opaque", 0, 4, 0, 0, 0, TR_INTERIOR_IMPLICIT, 0, 0, 0, 3, 372, 12},
    {"one object, layers(4)", 3, 1, 0, 0, 0, TR_INTERIOR_LAYERS, 4, 0, 0, 7, 652, 40},
    {"layers(1)", 3, 4, 0, 0, 0, TR_INTERIOR_LAYERS, 1, 0, 0, 5, 512, 20},
    {"layers(2)", 3, 4, 0, 0, 0, TR_INTERIOR_LAYERS, 2, 0, 0, 7, 652, 28},
    {"layers(4)", 3, 4, 0, 0, 0, TR_INTERIOR_LAYERS, 4, 0, 0, 11, 932, 44},
    {"layers(8)", 3, 9, 0, 0, 0, TR_INTERIOR_LAYERS, 8, 0, 0, 19, 1492, 76},
    {"groups of 2", 3, 4, 0, 2, 0, TR_INTERIOR_IMPLICIT, 0, 0, 0, 7, 652, 33},
    {"groups of 4", 3, 4, 0, 4, 0, TR_INTERIOR_IMPLICIT, 0, 0, 0, 11, 932, 57},
    {"groups of 4, mixed", 3, 4, 0, 4, 2, TR_INTERIOR_IMPLICIT, 0, 0, 0, 11, 932, 57},
    {"groups of 9, 3 shown", 3, 9, 0, 9, 0, TR_INTERIOR_IMPLICIT, 3, 0, 0, 9, 792, 45},
    {"creases and outlines", 3, 4, 0, 0, 0, TR_INTERIOR_IMPLICIT, 0, 3, 0, 10, 861, 24},
    {"all lines", 3, 4, 0, 0, 0, TR_INTERIOR_IMPLICIT, 0, 15, 0, 13, 1068, 24},
    {"phantom lines alone", 3, 4, 0, 0, 0, TR_INTERIOR_IMPLICIT, 0, 4, 0, 7, 650, 20},
    {"2 by 2 texels", 3, 4, 0, 0, 0, TR_INTERIOR_IMPLICIT, 0, 0, 2, 5, 512, 80},
};

static void test_modes(void **state) {
    (void)state;
    printf("    mode                       passes  calls  bytes a pixel\n");
    for (size_t i = 0; i < sizeof modes / sizeof modes[0]; ++i) {
        const mode *m = &modes[i];
        tr_desc desc = make_desc(TR_STATE_RESTORE);
        tr_frame frame = make_frame(m->opaque, m->transparent);
        frame.scene.transparent_two_sided = m->sheets;
        frame.scene.group_size = m->group;
        frame.scene.explicit_asked = m->explicit_asked;
        frame.wishes.interior = m->interior;
        frame.wishes.layers = m->layers;
        frame.wishes.lines = m->lines;
        frame.wishes.supersample = m->supersample;
        reset_driver();
        tr_context *tr = tr_create(&desc, NULL);
        run_frame(tr, &frame);
        int before = driver.call_count;
        run_frame(tr, &frame);
        int calls = driver.call_count - before;
        const tr_plan *plan = tr_get_info(tr).plan;
        printf("    %-26s %6d %6d %6u\n", m->name, plan->pass_count, calls, (unsigned)plan->bytes_per_pixel);
        assert_int_equal(plan->pass_count, m->passes);
        assert_int_equal(plan->bytes_per_pixel, m->bytes);
        assert_int_equal(tr_get_info(tr).bytes, 64 * 32 * plan->bytes_per_pixel);
        assert_int_equal(calls, m->calls);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

/* What is decided from facts, object by object, and what overrules it. */
static void test_methods_by_object(void **state) {
    static const struct {
        uint32_t flags;
        tr_interior interior;
        int is_explicit;
    } cases[] = {
        {TR_TRANSPARENT, TR_INTERIOR_IMPLICIT, 0},
        {TR_TRANSPARENT, TR_INTERIOR_EXPLICIT, 1},
        {TR_TRANSPARENT | TR_EXPLICIT, TR_INTERIOR_IMPLICIT, 1},
        {TR_TRANSPARENT | TR_IMPLICIT, TR_INTERIOR_EXPLICIT, 0},
        {TR_TRANSPARENT, TR_INTERIOR_AUTO, 1},
        {TR_TRANSPARENT | TR_CLOSED, TR_INTERIOR_AUTO, 1},
        {TR_TRANSPARENT | TR_HOLDING, TR_INTERIOR_AUTO, 1},
        {TR_TRANSPARENT | TR_CLOSED | TR_HOLDING, TR_INTERIOR_AUTO, 0},
        {TR_TRANSPARENT | TR_CLOSED | TR_HOLDING | TR_EXPLICIT, TR_INTERIOR_AUTO, 1},
        {TR_TRANSPARENT | TR_CLOSED | TR_HOLDING, TR_INTERIOR_EXPLICIT, 1},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        tr_object objects[3] = {{7, 0}, {1, TR_OPAQUE}, {9, TR_TRANSPARENT | TR_IMPLICIT}};
        tr_wishes wishes = {0};
        tr_plan plan;
        char text[2048];
        objects[0].flags = cases[i].flags | TR_GROUP(5);
        wishes.interior = cases[i].interior;
        assert_int_equal(tr_object_code(&objects[0], &wishes),
                         7u | 5u << 24 | (cases[i].is_explicit ? 0x80000000u : 0u));
        tr_scene alone = tr_scene_count(objects, 2, sizeof objects[0]);
        assert_int_equal(tr_plan_make(&alone, &wishes, &plan), TR_OK);
        assert_int_equal(plan.interior, cases[i].is_explicit ? TR_INTERIOR_EXPLICIT : TR_INTERIOR_IMPLICIT);
        assert_false(plan.mixed);
        tr_plan_print(&plan, text, sizeof text);
        assert_non_null(strstr(text, cases[i].is_explicit ? "explicit interiors" : "implicit interiors"));
        if (cases[i].interior == TR_INTERIOR_AUTO && !(cases[i].flags & TR_EXPLICIT))
            assert_non_null(strstr(text, "chosen: "));
        tr_scene both = tr_scene_count(objects, 3, sizeof objects[0]);
        assert_int_equal(tr_plan_make(&both, &wishes, &plan), TR_OK);
        assert_int_equal(plan.mixed, cases[i].is_explicit);
    }
    assert_int_equal(tr_object_code(NULL, NULL), 0);
}

static void test_groups_are_counted(void **state) {
    tr_object objects[] = {{1, TR_TRANSPARENT | TR_GROUP(1)},
                           {2, TR_TRANSPARENT | TR_GROUP(127)},
                           {3, TR_TRANSPARENT | TR_GROUP(127)},
                           {4, TR_OPAQUE | TR_GROUP(127)},
                           {5, TR_TRANSPARENT},
                           {6, TR_TRANSPARENT}};
    (void)state;
    assert_int_equal(tr_scene_count(objects, 6, sizeof objects[0]).group_size, 2); /* neither opaque ones nor group 0 */
    assert_int_equal(tr_scene_count(objects, 1, sizeof objects[0]).group_size, 1);
    tr_wishes wishes = {0};
    tr_plan plan;
    tr_scene counts = tr_scene_count(objects, 6, sizeof objects[0]);
    assert_int_equal(tr_plan_make(&counts, &wishes, &plan), TR_OK);
    assert_true(plan.grouped && plan.layers == 2);
    wishes.layers = 1; /* one shown: no group */
    assert_int_equal(tr_plan_make(&counts, &wishes, &plan), TR_OK);
    assert_true(!plan.grouped && plan.layers == 1);
    wishes.interior = TR_INTERIOR_IMPLICIT_PUBLISHED;
    wishes.layers = 0;
    assert_int_equal(tr_plan_make(&counts, &wishes, &plan), TR_OK);
    assert_true(!plan.grouped && plan.layers == 1);
}

static void test_bad_scenes_and_wishes(void **state) {
    static const tr_object bad_objects[] = {
        {0xffffffu, TR_TRANSPARENT},         {0xffffffffu, TR_TRANSPARENT},
        {1, TR_TRANSPARENT | TR_GROUP(128)}, {1, TR_TRANSPARENT | TR_GROUP(300)},
        {1, TR_TRANSPARENT | 64u},           {1, TR_TRANSPARENT | TR_IMPLICIT | TR_EXPLICIT}};
    static const tr_wishes bad_wishes[] = {{TR_INTERIOR_LAYERS, TR_BLENDING_OVER, 0, 0, 0, 0, TR_ALPHA_DISTANCE},
                                           {TR_INTERIOR_LAYERS, TR_BLENDING_OVER, 0, 9, 0, 0, TR_ALPHA_DISTANCE},
                                           {TR_INTERIOR_IMPLICIT, TR_BLENDING_OVER, 0, 9, 0, 0, TR_ALPHA_DISTANCE},
                                           {(tr_interior)5, TR_BLENDING_OVER, 0, 0, 0, 0, TR_ALPHA_DISTANCE},
                                           {TR_INTERIOR_IMPLICIT, (tr_blending)3, 0, 0, 0, 0, TR_ALPHA_DISTANCE},
                                           {TR_INTERIOR_IMPLICIT, TR_BLENDING_OVER, 16, 0, 0, 0, TR_ALPHA_DISTANCE},
                                           {TR_INTERIOR_IMPLICIT, TR_BLENDING_OVER, 0, 0, 8, 0, TR_ALPHA_DISTANCE},
                                           {TR_INTERIOR_IMPLICIT, TR_BLENDING_OVER, 0, 0, 0, 5, TR_ALPHA_DISTANCE},
                                           {TR_INTERIOR_IMPLICIT, TR_BLENDING_OVER, 0, 0, 0, 0, TR_ALPHA_COUNT}};
    static const tr_object good[] = {{0xfffffeu, TR_TRANSPARENT | TR_GROUP(127)}, {0xffffffffu, TR_OPAQUE}};
    tr_wishes wishes = {0};
    tr_plan plan;
    (void)state;
    tr_scene counts = tr_scene_count(good, 2, sizeof good[0]);
    assert_int_equal(tr_plan_make(&counts, &wishes, &plan), TR_OK);
    for (size_t i = 0; i < sizeof bad_wishes / sizeof bad_wishes[0]; ++i)
        assert_int_equal(tr_plan_make(&counts, &bad_wishes[i], &plan), TR_INVALID_ARGUMENT);
    for (size_t i = 0; i < sizeof bad_objects / sizeof bad_objects[0]; ++i) {
        counts = tr_scene_count(&bad_objects[i], 1, sizeof bad_objects[0]);
        assert_int_equal(counts.invalid, 1);
        assert_int_equal(tr_plan_make(&counts, &wishes, &plan), TR_INVALID_ARGUMENT);
    }
    tr_scene absurd = {0}; /* more of a kind than there are */
    absurd.transparent = 1;
    absurd.implicit_asked = 2;
    assert_int_equal(tr_plan_make(&absurd, &wishes, &plan), TR_INVALID_ARGUMENT);
    absurd.implicit_asked = 0;
    absurd.group_size = 2;
    assert_int_equal(tr_plan_make(&absurd, &wishes, &plan), TR_INVALID_ARGUMENT);
}

/* More variants than are kept: the oldest go, none leaks, and what is in use stays. */
static void test_many_modes_on_one_context(void **state) {
    tr_desc desc = make_desc(TR_STATE_RESTORE);
    (void)state;
    reset_driver();
    tr_context *tr = tr_create(&desc, NULL);
    for (uint32_t i = 0; i < 200; ++i) {
        tr_frame frame = make_frame(i % 2, 1 + i % 3);
        driver.call_count = 0;
        frame.wishes.interior = i % 5 == 4 ? TR_INTERIOR_LAYERS : (tr_interior)(i % 4);
        frame.wishes.layers = i % 5 == 4 ? 1 + i % TR_MAX_LAYERS : 0;
        frame.wishes.blending = (tr_blending)(i / 3 % 3);
        frame.wishes.options = i / 7 % 8;
        frame.enter_distance = 1;
        frame.wishes.supersample = i / 11 % 5;
        frame.wishes.lines = i % 16;
        run_frame(tr, &frame);
        assert_true(driver.live[PROGRAMS] <= TR_I_PROGRAM_COUNT);
    }
    tr_destroy(tr);
    assert_nothing_left();
}

/* Lines are drawn by the same variants while compositions come and go: those that make room are never this plan's. */
static void test_variants_in_use_stay(void **state) {
    tr_desc desc = make_desc(TR_STATE_RESTORE);
    (void)state;
    reset_driver();
    tr_context *tr = tr_create(&desc, NULL);
    for (uint32_t i = 0; i < 3 * TR_I_VARIANT_COUNT; ++i) {
        tr_frame frame = make_frame(1, 2);
        tr_pass pass;
        driver.call_count = 0;
        frame.wishes.interior = TR_INTERIOR_LAYERS;
        frame.wishes.layers = 1 + i % TR_MAX_LAYERS;
        frame.wishes.blending = (tr_blending)(i / TR_MAX_LAYERS % 3);
        frame.wishes.options = i / (3 * TR_MAX_LAYERS) % 2 ? TR_WISH_BLEND_COLOR : 0;
        frame.wishes.lines = TR_LINES_OUTLINES;
        assert_int_equal(tr_begin(tr, &frame), TR_OK);
        for (int p = 0; p < tr->plan.pass_count; ++p)
            assert_true(tr_i_program_of(tr, &tr->plan.passes[p]) >= 0);
        while (tr_next_pass(tr, &pass)) {
        }
        assert_int_equal(tr_end(tr), TR_OK);
    }
    tr_destroy(tr);
    assert_nothing_left();
}

static void test_plan_prints_like_snprintf(void **state) {
    tr_scene scene = {0};
    scene.opaque = 1;
    scene.transparent = 2;
    tr_wishes wishes = {0};
    wishes.lines = TR_LINES_OUTLINES;
    tr_plan plan;
    char whole[2048], part[40];
    (void)state;
    tr_plan_make(&scene, &wishes, &plan);
    size_t needed = tr_plan_print(&plan, NULL, 0);
    assert_int_equal(tr_plan_print(&plan, whole, sizeof whole), needed);
    assert_int_equal(strlen(whole), needed);
    assert_non_null(strstr(whole, "layer"));
    memset(part, 'x', sizeof part);
    assert_int_equal(tr_plan_print(&plan, part, 10), needed);
    assert_memory_equal(part, whole, 9);
    assert_int_equal(part[9], 0);
    assert_int_equal(part[10], 'x');
}

/* ---- where surfaces cross ---- */

/* Two triangles that cross in a known segment, and what gives none. */
static void test_crossings(void **state) {
    static const float flat[] = {-1, -1, 0, 1, -1, 0, 0, 1, 0}; /* in z = 0 */
    static const float upright[] = {0, -0.5f, -1, 0, -0.5f, 1, 0, 3, 0};
    static const float above[] = {0, 0, 0.1f, 0, 1, 0.1f, 1, 0, 1};
    static const float touching[] = {0, 0, 0, 1, 0, 1, 0, 1, 1}; /* a corner on the plane: before it */
    static const uint32_t index[] = {0, 1, 2};
    static const uint32_t bad[] = {0, 1, 3};
    float segment[6], nan_point[9];
    tr_mesh a = {flat, index, 3, 3, {0}}, b = {upright, index, 3, 3, {0}};
    (void)state;
    assert_int_equal(tr_crossings(&a, &b, 1, NULL, 0), 1);
    memset(segment, 0x55, sizeof segment);
    assert_int_equal(tr_crossings(&a, &b, 1, segment, 1), 1);
    double low = fmin((double)segment[1], (double)segment[4]), high = fmax((double)segment[1], (double)segment[4]);
    assert_true(fabs(low + 0.5) < 1e-6 &&
                fabs(high - 1) < 1e-6); /* from the lower side of one to the tip of the other */
    assert_true(segment[0] == 0 && segment[3] == 0 && segment[2] == 0 && segment[5] == 0);
    float moved[16] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 5, 0, 0, 1};
    memcpy(a.model, moved, sizeof moved);
    assert_int_equal(tr_crossings(&a, &b, 1, NULL, 0), 0);
    memcpy(b.model, moved, sizeof moved);
    assert_int_equal(tr_crossings(&a, &b, 1, segment, 1), 1);
    assert_true(fabsf(segment[0] - 5) < 1e-5f);
    memset(a.model, 0, sizeof a.model);
    memset(b.model, 0, sizeof b.model);
    const float *none[] = {above, touching, flat};
    for (int i = 0; i < 3; ++i) {
        b.positions = none[i];
        assert_int_equal(tr_crossings(&a, &b, 1, NULL, 0), 0);
    }
    b.positions = upright;
    b.indices = bad;
    assert_int_equal(tr_crossings(&a, &b, 1, NULL, 0), 0);
    b.indices = index;
    for (int i = 0; i < 9; ++i) {
        memcpy(nan_point, upright, sizeof upright);
        nan_point[i] = i % 2 ? NAN : INFINITY;
        b.positions = nan_point;
        assert_int_equal(tr_crossings(&a, &b, 1, NULL, 0), 0);
        assert_int_equal(tr_crossings(&b, &a, 1, NULL, 0), 0);
    }
    assert_int_equal(tr_crossings(&a, NULL, 0, NULL, 0), 0);
    assert_int_equal(tr_crossings(NULL, &b, 1, NULL, 0), SIZE_MAX);
    assert_int_equal(tr_crossings(&a, NULL, 1, NULL, 0), SIZE_MAX);
    b.model[5] = NAN;
    assert_int_equal(tr_crossings(&a, &b, 1, NULL, 0), SIZE_MAX);
    assert_int_equal(tr_crossings(&b, &a, 1, NULL, 0), SIZE_MAX);
    b.model[5] = 0;
    b.positions = NULL;
    assert_int_equal(tr_crossings(&a, &b, 1, NULL, 0), SIZE_MAX);
}

/* Many triangles in any place: the same pairs as trying all by a mesh of one triangle at a time. */
static void test_crossings_by_extent(void **state) {
    enum { COUNT = 60 };
    static float places[2][COUNT * 9];
    static uint32_t indices[COUNT * 3];
    uint32_t random = 99;
    size_t alone = 0;
    (void)state;
    for (int i = 0; i < COUNT * 3; ++i)
        indices[i] = (uint32_t)i;
    for (int m = 0; m < 2; ++m)
        for (int t = 0; t < COUNT; ++t)
            for (int k = 0; k < 9; ++k) {
                random = random * 1664525u + 1013904223u;
                places[m][9 * t + k] =
                    (float)(random >> 8) / 16777216.0f * (t % 7 == 0 ? 2.0f : 0.5f) + (float)(t % 5) * 0.3f;
            }
    tr_mesh a = {places[0], indices, COUNT * 3, COUNT * 3, {0}}, b = {places[1], indices, COUNT * 3, COUNT * 3, {0}};
    size_t all = tr_crossings(&a, &b, 1, NULL, 0);
    for (int i = 0; i < COUNT; ++i)
        for (int j = 0; j < COUNT; ++j) {
            tr_mesh one = {places[0] + 9 * i, indices, 3, 3, {0}}, other = {places[1] + 9 * j, indices, 3, 3, {0}};
            alone += tr_crossings(&one, &other, 1, NULL, 0);
        }
    assert_true(all > 50);
    assert_int_equal(all, alone);
}

static void test_crossings_are_kept(void **state) {
    static float segments[6 * 3];
    tr_desc desc = make_desc(TR_STATE_RESTORE);
    tr_frame frame = make_frame(1, 1);
    (void)state;
    reset_driver();
    tr_context *tr = tr_create(&desc, NULL);
    assert_int_equal(tr_set_crossings(NULL, segments, 1), TR_INVALID_ARGUMENT);
    assert_int_equal(tr_set_crossings(tr, NULL, 1), TR_INVALID_ARGUMENT);
    assert_int_equal(tr_set_crossings(tr, segments, 10000000), TR_TOO_LARGE);
    assert_int_equal(tr_set_crossings(tr, segments, 3), TR_OK);
    assert_int_equal(tr_get_info(tr).bytes, 1024 * 16);
    frame.wishes.options = TR_WISH_ENTERING;
    assert_int_equal(tr_begin(tr, &frame), TR_INVALID_ARGUMENT); /* over which distance? */
    frame.enter_distance = NAN;
    assert_int_equal(tr_begin(tr, &frame), TR_INVALID_ARGUMENT);
    frame.enter_distance = 1;
    assert_int_equal(tr_begin(tr, &frame), TR_OK);
    assert_int_equal(tr_set_crossings(tr, segments, 3), TR_WRONG_ORDER);
    assert_int_equal(tr_end(tr), TR_OK);
    run_frame(tr, &frame);
    assert_int_equal(tr_release(tr), TR_OK);
    assert_int_equal(tr_get_info(tr).bytes, 1024 * 16); /* the host's data outlive a pause */
    blocks_left = 0; /* every frame may give others: no heap, and no new texture while they are about as many */
    int textures = driver.live[TEXTURES];
    assert_int_equal(tr_set_crossings(tr, segments, 1), TR_OK);
    assert_int_equal(tr_set_crossings(tr, segments, 2), TR_OK);
    assert_int_equal(driver.live[TEXTURES], textures);
    blocks_left = 1000;
    static float many[6 * 5000];
    assert_int_equal(tr_set_crossings(tr, many, 5000), TR_OK); /* ten rows, and a quarter */
    assert_int_equal(tr_get_info(tr).bytes, 12 * 1024 * 16);
    assert_int_equal(tr_set_crossings(tr, many, 4000), TR_OK);
    assert_int_equal(tr_get_info(tr).bytes, 12 * 1024 * 16);
    assert_int_equal(tr_set_crossings(tr, NULL, 0), TR_OK);
    assert_int_equal(tr_get_info(tr).bytes, 1024 * 16);
    tr_destroy(tr);
    assert_nothing_left();
}

static void test_objects_and_passes(void **state) {
    static const tr_object objects[4] = {
        {1, TR_OPAQUE}, {2, TR_TWO_SIDED}, {3, TR_TRANSPARENT}, {4, TR_TRANSPARENT | TR_TWO_SIDED}};
    tr_pass pass;
    (void)state;
    tr_scene scene = tr_scene_count(objects, 4, sizeof objects[0]);
    assert_true(scene.opaque == 1 && scene.opaque_two_sided == 1 && scene.transparent == 1 &&
                scene.transparent_two_sided == 1);
    memset(&pass, 0, sizeof pass);
    for (uint32_t classes = 0; classes < 16; ++classes)
        for (uint32_t i = 0; i < 4; ++i) {
            pass.classes = classes;
            assert_int_equal(tr_pass_draws(&pass, &objects[i]), (int)((classes >> objects[i].flags) & 1u));
        }
    assert_false(tr_pass_draws(NULL, &objects[0]));
    assert_false(tr_pass_draws(&pass, NULL));
}

/* ---- the alpha law: equation 2 and its bad inputs ---- */

static void test_view_alpha(void **state) {
    (void)state;
    for (float k = 0.0f; k <= 4.0f; k += 0.125f) {
        assert_true(tr_view_alpha(0.0f, 2.0f, k) == 1.0f); /* the silhouette is opaque for every k */
        assert_true(tr_view_alpha(2.0f, 2.0f, k) == 0.0f);
        assert_true(tr_view_alpha(9.0f, 2.0f, k) == 0.0f);
        for (float d = 0.01f; d < 2.0f; d += 0.01f) {
            double expected = 1.0 - pow((double)d / 2.0, (double)k);
            assert_true(fabs((double)tr_view_alpha(d, 2.0f, k) - expected) < 1e-6);
        }
    }
    assert_true(tr_view_alpha(1.0f, 0.0f, 1.0f) == 1.0f);
    assert_true(tr_view_alpha(1.0f, -1.0f, 1.0f) == 1.0f);
    assert_true(tr_view_alpha(-1.0f, 1.0f, 1.0f) == 1.0f);
    assert_true(tr_view_alpha(NAN, 1.0f, 1.0f) == 1.0f);
    assert_true(tr_view_alpha(1.0f, NAN, 1.0f) == 1.0f);
    assert_true(tr_view_alpha(INFINITY, 1.0f, 1.0f) == 0.0f); /* no silhouette: the eye is inside */
    assert_true(tr_view_alpha(INFINITY, INFINITY, 1.0f) == 0.0f);
    assert_true(tr_view_alpha(1.0f, INFINITY, 0.5f) >= 0.99f);
    assert_true(tr_view_alpha(0.5f, 1.0f, -3.0f) == tr_view_alpha(0.5f, 1.0f, 0.0f));
    assert_true(tr_view_alpha(0.5f, 1.0f, NAN) == 0.0f); /* counts as 0 */
    assert_true(tr_view_alpha(0.5f, 1.0f, -INFINITY) == 0.0f);
    assert_true(tr_view_alpha(0.5f, 1.0f, INFINITY) == 1.0f);
    assert_true(tr_view_alpha(1e-45f, 1e-38f, 0.5f) <= 1.0f);
    assert_true(tr_view_alpha(1e-45f, 1e38f, 0.0f) == 0.0f);
}

static void test_strings(void **state) {
    tr_desc desc = make_desc(TR_STATE_RESTORE);
    int count = 0;
    (void)state;
    reset_driver();
    tr_context *tr = tr_create(&desc, NULL);
    for (int stage = 0; stage < TR_STAGE_COUNT; ++stage)
        for (int rule = 0; rule < TR_RULE_SEE_END; ++rule) {
            const char *const *strings = tr_glsl(tr, (tr_stage)stage, (tr_rule)rule, &count);
            assert_non_null(strings);
            assert_true(count > 2 && count < TR_I_MAX_STRINGS);
            assert_non_null(strstr(strings[0], "#version 330 core"));
        }
    assert_null(tr_glsl(tr, TR_STAGE_COUNT, TR_RULE_FRONT, &count));
    assert_null(tr_glsl(tr, TR_VERTEX, TR_RULE_SEE_END, &count));
    assert_null(tr_glsl(NULL, TR_VERTEX, TR_RULE_FRONT, &count));
    for (int i = 0; i < TR_RESULT_COUNT; ++i)
        assert_true(strlen(tr_result_string((tr_result)i)) > 5);
    assert_string_equal(tr_result_string((tr_result)99), "unknown result");
    tr_destroy(tr);
    tr_destroy(NULL);
    assert_nothing_left();
}

/* A rung of alpha costs a frame nothing but the textures it reads, in the passes that blend. */
static void test_alpha_in_frames(void **state) {
    static const float points[2][3] = {{0, 0, 0}, {1, 0, 0}};
    static const uint32_t ends[2] = {0, 1}, offsets[2] = {0, 1}, candidates[1] = {0};
    tr_desc desc = make_desc(TR_STATE_RESTORE);
    tr_frame frame = make_frame(3, 4);
    tr_edge_set set;
    tr_edges edges;
    tr_outlines image = {9, 10, 64, 32, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.5f, -1, 0, 0, -2, 0}};
    int calls[TR_ALPHA_COUNT];
    (void)state;
    reset_driver();
    tr_context *tr = tr_create(&desc, NULL);
    memset(&edges, 0, sizeof edges);
    edges.positions = points[0];
    edges.position_count = 2;
    edges.ends = ends;
    edges.edge_count = 1;
    edges.offsets = offsets;
    edges.candidates = candidates;
    edges.triangle_count = 1;
    for (int alpha = TR_ALPHA_CANDIDATES; alpha < TR_ALPHA_COUNT; ++alpha) {
        frame.wishes.alpha = (tr_alpha)alpha;
        assert_int_equal(tr_begin(tr, &frame), TR_INVALID_ARGUMENT);
        assert_non_null(strstr(driver.text, alpha == TR_ALPHA_IMAGE ? "tr_find_outlines" : "tr_set_edges"));
    }
    assert_int_equal(tr_set_edges(tr, &edges, 1, &set), TR_OK);
    assert_int_equal(tr_find_outlines(tr, &image), TR_OK);
    for (int alpha = 0; alpha < TR_ALPHA_COUNT; ++alpha) {
        frame.wishes.alpha = (tr_alpha)alpha;
        run_frame(tr, &frame);
        int first = driver.call_count;
        run_frame(tr, &frame);
        calls[alpha] = driver.call_count - first;
        assert_int_equal(called_since(first, "TexSubImage2D") + called_since(first, "TexImage2D"), 0);
    }
    /* An array: three calls in the one pass that blends, three to save its unit and three to restore it. */
    assert_int_equal(calls[TR_ALPHA_PUBLISHED], calls[TR_ALPHA_DISTANCE]);
    assert_int_equal(calls[TR_ALPHA_EXACT], calls[TR_ALPHA_DISTANCE] + 9);
    assert_int_equal(calls[TR_ALPHA_IMAGE], calls[TR_ALPHA_DISTANCE] + 9);
    assert_int_equal(calls[TR_ALPHA_CANDIDATES], calls[TR_ALPHA_DISTANCE] + 18);
    assert_int_equal(tr_begin(tr, &frame), TR_OK);
    assert_int_equal(tr_set_edges(tr, &edges, 1, &set), TR_WRONG_ORDER);
    assert_int_equal(tr_find_outlines(tr, &image), TR_WRONG_ORDER);
    assert_int_equal(tr_end(tr), TR_OK);
    tr_destroy(tr);
    assert_nothing_left();
}

/* ---- opaque things from the host's textures ---- */

static tr_frame make_taken_frame(uint32_t opaque, uint32_t transparent) {
    tr_frame frame = make_frame(opaque, transparent);
    frame.scene.opaque_drawn = 3;
    frame.opaque_color = 201;
    frame.opaque_depth = 202;
    driver.width = 64;
    driver.height = 32;
    return frame;
}

/* As many passes and bytes as by drawing again; the checks of two textures, and a triangle. */
static void test_taking_opaque_things(void **state) {
    static const char *const never[] = {"GenTextures",   "GenFramebuffers", "GenBuffers",    "TexImage2D",
                                        "BufferSubData", "CompileShader",   "DeleteTextures"};
    (void)state;
    for (int policy = 0; policy < 4; ++policy) {
        tr_desc desc = make_desc((tr_state_policy)policy);
        reset_driver();
        tr_frame drawn = make_frame(3, 4), taken = make_taken_frame(0, 4);
        tr_context *tr = tr_create(&desc, NULL);
        run_frame(tr, &drawn);
        int first = driver.call_count;
        run_frame(tr, &drawn);
        int calls = driver.call_count - first;
        uint32_t bytes = tr_get_info(tr).plan->bytes_per_pixel;
        run_frame(tr, &taken);
        first = driver.call_count;
        run_frame(tr, &taken);
        int none = policy == TR_STATE_NONE;
        assert_int_equal(driver.call_count - first, none ? 0 : calls + 12 + 4);
        assert_int_equal(called_since(first, "GetTexLevelParameteriv"), none ? 0 : 4);
        assert_int_equal(tr_get_info(tr).plan->bytes_per_pixel, bytes);
        for (size_t i = 0; i < sizeof never / sizeof never[0]; ++i)
            assert_int_equal(called_since(first, never[i]), 0);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

/* The pass as data: what it reads and draws; it comes before opaque objects, which clear nothing, and no later pass has
 * the host's textures. */
static void test_state_of_taking(void **state) {
    tr_pass pass;
    (void)state;
    for (int both = 0; both < 2; ++both) {
        tr_desc desc = make_desc(TR_STATE_NONE);
        int kinds[TR_PASS_KIND_COUNT] = {0};
        reset_driver();
        tr_frame frame = make_taken_frame(both ? 2 : 0, 0);
        tr_context *tr = tr_create(&desc, NULL);
        assert_int_equal(tr_begin(tr, &frame), TR_OK);
        while (tr_next_pass(tr, &pass)) {
            bool takes = pass.kind == TR_PASS_TAKE_OPAQUE;
            ++kinds[pass.kind];
            assert_int_equal(pass.state.textures[TR_I_SCENE_DEPTH] == 202, takes);
            assert_int_equal(pass.state.textures[TR_I_OPAQUE_COLOR] == 201, takes);
            if (takes) {
                assert_int_equal(kinds[TR_PASS_OPAQUE], 0);
                assert_int_equal(pass.state.vertex_count, 3);
                assert_int_equal(pass.state.framebuffer, tr->fbos[TR_I_FBO_OPAQUE]);
                assert_int_equal(pass.state.depth_func, TR_I_GL_LESS);
                assert_true(pass.state.depth_test && pass.state.depth_write && pass.state.color_write);
            }
            if (takes || pass.kind == TR_PASS_OPAQUE)
                assert_true(pass.state.clear_color == takes && pass.state.clear_depth == takes);
        }
        assert_int_equal(tr_end(tr), TR_OK);
        assert_int_equal(kinds[TR_PASS_TAKE_OPAQUE], 1);
        assert_int_equal(kinds[TR_PASS_OPAQUE], both);
        assert_int_equal(kinds[TR_PASS_OPAQUE_LINES], 2);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

static void test_plans_that_take(void **state) {
    tr_object objects[] = {{1, TR_DRAWN}, {2, TR_DRAWN | TR_TWO_SIDED}, {3, TR_OPAQUE}};
    tr_wishes wishes = {0};
    tr_plan plan;
    tr_pass pass;
    char text[2048];
    (void)state;
    tr_scene counts = tr_scene_count(objects, 3, sizeof objects[0]);
    assert_true(counts.opaque_drawn == 2 && counts.opaque == 1 && counts.opaque_two_sided == 0 && !counts.invalid);
    counts.transparent = 2;
    assert_int_equal(tr_plan_make(&counts, &wishes, &plan), TR_OK);
    assert_int_equal(count_kind(&plan, TR_PASS_LIMIT), 1);
    tr_plan_print(&plan, text, sizeof text);
    assert_non_null(strstr(text, "take opaque: from the host's textures"));
    memset(&pass, 0, sizeof pass);
    pass.classes = TR_I_ALL_OPAQUE;
    pass.kind = TR_PASS_OPAQUE;
    assert_true(!tr_pass_draws(&pass, &objects[0]) && !tr_pass_draws(&pass, &objects[1]));
    assert_true(tr_pass_draws(&pass, &objects[2]));
    pass.kind = TR_PASS_OPAQUE_LINES; /* textures have none */
    assert_true(tr_pass_draws(&pass, &objects[0]) && tr_pass_draws(&pass, &objects[1]));
}

/* Textures alone are enough: a host need not know its opaque objects one by one. */
static void test_textures_count_as_something(void **state) {
    tr_desc desc = make_desc(TR_STATE_RESTORE);
    (void)state;
    reset_driver();
    tr_frame frame = make_taken_frame(0, 1);
    frame.scene.opaque_drawn = 0;
    tr_context *tr = tr_create(&desc, NULL);
    run_frame(tr, &frame);
    assert_int_equal(count_kind(tr_get_info(tr).plan, TR_PASS_TAKE_OPAQUE), 1);
    driver.samples = 4; /* planned anew */
    run_frame(tr, &frame);
    assert_int_equal(tr_get_info(tr).plan->supersample, 2);
    assert_int_equal(count_kind(tr_get_info(tr).plan, TR_PASS_TAKE_OPAQUE), 1);
    tr_destroy(tr);
    assert_nothing_left();
}

static void test_wrong_opaque_textures_are_named(void **state) {
    static const struct {
        uint32_t color, depth, refused, other;
        int x, y, width, height;
        const char *text;
    } cases[] = {
        {0, 202, 0, 0, 0, 0, 64, 32, "both or neither"},
        {201, 0, 0, 0, 0, 0, 64, 32, "both or neither"},
        {0, 0, 0, 0, 0, 0, 64, 32, "TR_DRAWN"},
        {201, 202, 0, 0, -1, 0, 64, 32, "opaque_x or frame.opaque_y is in no texture"},
        {201, 202, 0, 0, 0, -1, 64, 32, "opaque_x or frame.opaque_y is in no texture"},
        {201, 202, 0, 0, 2147483647, 0, 64, 32, "opaque_x or frame.opaque_y is in no texture"},
        {201, 202, 0, 0, 0, 2147483647, 64, 32, "opaque_x or frame.opaque_y is in no texture"},
        {201, 202, 201, 0, 0, 0, 64, 32, "opaque_color is no GL_TEXTURE_2D"},
        {201, 202, 202, 0, 0, 0, 64, 32, "opaque_depth is no GL_TEXTURE_2D"},
        {201, 202, 0, 201, 0, 0, 64, 32, "opaque_color is no GL_TEXTURE_2D"},
        {201, 202, 0, 202, 0, 0, 64, 32, "opaque_depth is no GL_TEXTURE_2D"},
        {201, 202, 0, 0, 0, 0, 63, 32, "opaque_color is too small"},
        {201, 202, 0, 0, 0, 0, 64, 31, "opaque_color is too small"},
        {201, 202, 0, 0, 1, 3, 65, 34, "opaque_color is too small"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        tr_desc desc = make_desc(TR_STATE_RESTORE);
        reset_driver();
        tr_frame frame = make_taken_frame(0, 2), good = frame;
        tr_context *tr = tr_create(&desc, NULL);
        run_frame(tr, &good);
        frame.opaque_color = cases[i].color;
        frame.opaque_depth = cases[i].depth;
        frame.opaque_x = cases[i].x;
        frame.opaque_y = cases[i].y;
        driver.refused_texture = cases[i].refused;
        driver.other_texture = cases[i].other;
        driver.width = cases[i].width;
        driver.height = cases[i].height;
        assert_int_equal(tr_begin(tr, &frame), TR_INVALID_ARGUMENT);
        if (!strstr(driver.text, cases[i].text))
            fail_msg("case %d: no \"%s\" in: %s", (int)i, cases[i].text, driver.text);
        for (int unit = 0; unit < 32; ++unit) /* as before */
            assert_int_equal(driver.unit_textures[unit], 0);
        driver.refused_texture = driver.other_texture = 0;
        driver.width = 64;
        driver.height = 32;
        run_frame(tr, &good);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_each_missing_function_is_named),
        cmocka_unit_test(test_versions),
        cmocka_unit_test(test_bad_descs),
        cmocka_unit_test(test_failing_shaders_are_reported),
        cmocka_unit_test(test_failing_framebuffers_leave_nothing),
        cmocka_unit_test(test_bad_frames),
        cmocka_unit_test(test_steady_frames_create_nothing),
        cmocka_unit_test(test_state_none_makes_no_call),
        cmocka_unit_test(test_passes_switch_off),
        cmocka_unit_test(test_no_pass_reads_what_it_draws),
        cmocka_unit_test(test_resizing_leaks_nothing),
        cmocka_unit_test(test_contexts_are_lost_at_every_call),
        cmocka_unit_test(test_plans_hold_only_what_is_needed),
        cmocka_unit_test(test_largest_plan_fits),
        cmocka_unit_test(test_modes),
        cmocka_unit_test(test_methods_by_object),
        cmocka_unit_test(test_groups_are_counted),
        cmocka_unit_test(test_bad_scenes_and_wishes),
        cmocka_unit_test(test_many_modes_on_one_context),
        cmocka_unit_test(test_crossings),
        cmocka_unit_test(test_crossings_by_extent),
        cmocka_unit_test(test_crossings_are_kept),
        cmocka_unit_test(test_variants_in_use_stay),
        cmocka_unit_test(test_plan_prints_like_snprintf),
        cmocka_unit_test(test_objects_and_passes),
        cmocka_unit_test(test_alpha_in_frames),
        cmocka_unit_test(test_taking_opaque_things),
        cmocka_unit_test(test_state_of_taking),
        cmocka_unit_test(test_plans_that_take),
        cmocka_unit_test(test_textures_count_as_something),
        cmocka_unit_test(test_wrong_opaque_textures_are_named),
        cmocka_unit_test(test_view_alpha),
        cmocka_unit_test(test_strings),
    };
    return cmocka_run_group_tests_name("mock_transparency", tests, NULL, NULL);
}

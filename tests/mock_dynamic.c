/* mock_dynamic.c: dynamic transparency on a driver that is not there: that nothing is done which is not called for, what a
 * steady frame may not call, bytes, bad input, failures, state policies, and that nothing is left behind. */
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

/* ---- a target behind a tree, before the ground ---- */

enum { TREE, TARGET, GROUND, UNITS };

typedef struct setting {
    tr_unit units[UNITS];
    tr_frame frame;
    tr_dynamic dynamic;
} setting;

static setting make_setting(void) {
    setting s;
    memset(&s, 0, sizeof s);
    for (int i = 0; i < UNITS; ++i) {
        s.units[i].id = (uint32_t)i + 1;
        s.units[i].radius = 1;
    }
    s.units[TREE].center[2] = -10;
    s.units[TARGET].center[2] = -20;
    s.units[TARGET].flags = TR_UNIT_TARGET;
    s.units[GROUND].center[2] = -30;
    s.units[GROUND].radius = 20;
    s.units[GROUND].flags = TR_UNIT_BACKDROP;
    s.frame.width = 640;
    s.frame.height = 480;
    s.dynamic.unit_count = UNITS;
    s.dynamic.view[0] = s.dynamic.view[5] = s.dynamic.view[10] = s.dynamic.view[15] = 1;
    s.dynamic.projection[0] = 1.5f;
    s.dynamic.projection[5] = 2;
    s.dynamic.projection[10] = -1;
    s.dynamic.projection[11] = -1;
    s.dynamic.projection[14] = -0.2f;
    return s;
}

typedef struct drawn {
    int passes, kinds[TR_PASS_KIND_COUNT], calls;
    size_t units[TR_PASS_KIND_COUNT];
} drawn;

/* A frame as a host with its own programs draws it; the calls are the header's alone. */
static drawn run_dynamic(tr_context *tr, setting *s) {
    drawn d;
    tr_pass pass;
    int first = driver.call_count;
    memset(&d, 0, sizeof d);
    s->dynamic.units = s->units;
    assert_int_equal(tr_begin_dynamic(tr, &s->frame, &s->dynamic), TR_OK);
    while (tr_next_pass(tr, &pass)) {
        check_units();
        ++d.passes;
        ++d.kinds[pass.kind];
        d.units[pass.kind] += pass.unit_count;
        assert_true(pass.unit_count == 0 || pass.units != NULL);
        for (size_t i = 0; i < pass.unit_count; ++i)
            assert_true(pass.units[i] < s->dynamic.unit_count);
    }
    assert_int_equal(tr_end(tr), TR_OK);
    d.calls = driver.call_count - first;
    return d;
}

static tr_context *open_context(tr_state_policy policy, const char *version) {
    tr_desc desc = make_desc(policy);
    reset_driver();
    if (version)
        driver.version = version;
    tr_context *tr = tr_create(&desc, NULL);
    assert_non_null(tr);
    return tr;
}

static const char *const versions[] = {"4.5.0 Mock", "3.3.0 Mock", "OpenGL ES 3.0 Mock", "OpenGL ES 3.2 Mock"};
enum { VERSIONS = 4 };

/* ---- only what is called for ---- */

static tr_see seen(const tr_context *tr) {
    return tr_get_info(tr).see_plan->see;
}

/* Changes of the setting after which it is plain drawing. */
static void ask_for_nothing(setting *s) {
    s->dynamic.see = TR_SEE_OFF;
}
static void look_away(setting *s) {
    s->units[TARGET].center[2] = 20;
}
static void have_no_target(setting *s) {
    s->units[TARGET].flags = 0;
}
static void harden_the_tree(setting *s) {
    s->units[TREE].flags = TR_UNIT_IMPENETRABLE;
}
static void make_the_tree_matter(setting *s) {
    s->units[TREE].importance = 1;
}
static void fade_the_target(setting *s) {
    s->units[TARGET].fade = 1;
}
static void darken_the_target(setting *s) {
    s->units[TARGET].flags |= TR_UNIT_ACTIVE;
}
static void put_the_tree_behind(setting *s) {
    s->units[TREE].center[2] = -40;
}
static void put_the_tree_beside(setting *s) {
    s->units[TREE].center[0] = 5;
}
static void have_no_units(setting *s) {
    s->dynamic.unit_count = 0;
}

static void (*const plain_changes[])(setting *) = {
    ask_for_nothing, look_away,         have_no_target,      harden_the_tree,     make_the_tree_matter,
    fade_the_target, darken_the_target, put_the_tree_behind, put_the_tree_beside, have_no_units};

static void plain_drawing_calls_nothing(void **state) {
    (void)state;
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_PUBLISHED; ++see)
        for (size_t i = 0; i < sizeof plain_changes / sizeof plain_changes[0]; ++i)
            for (int policy = TR_STATE_RESTORE; policy <= TR_STATE_LEAVE_DIRTY; ++policy) {
                tr_context *tr = open_context((tr_state_policy)policy, NULL);
                setting s = make_setting();
                s.dynamic.see = (tr_see)see;
                drawn d = run_dynamic(tr, &s);
                assert_int_equal(seen(tr), see);
                assert_true(d.kinds[see <= TR_SEE_DITHER ? TR_PASS_TARGETS : TR_PASS_SEEDS] >= 1 && d.calls > 0);
                plain_changes[i](&s);
                d = run_dynamic(tr, &s);
                assert_int_equal(seen(tr), TR_SEE_OFF);
                assert_int_equal(d.calls, 0);
                assert_int_equal(d.passes, 1);
                assert_int_equal(d.kinds[TR_PASS_SCENE], 1);
                assert_int_equal(d.units[TR_PASS_SCENE], s.dynamic.unit_count);
                tr_destroy(tr);
                assert_nothing_left();
            }
}

/* The first frame of all, too: nothing is created for what is not drawn. */
static void plain_drawing_creates_nothing(void **state) {
    (void)state;
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_PUBLISHED; ++see)
        for (size_t i = 0; i < sizeof plain_changes / sizeof plain_changes[0]; ++i) {
            tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
            setting s = make_setting();
            s.dynamic.see = (tr_see)see;
            plain_changes[i](&s);
            assert_int_equal(run_dynamic(tr, &s).calls, 0);
            assert_int_equal(tr_get_info(tr).bytes, 0);
            for (int kind = 0; kind < FENCES; ++kind)
                assert_int_equal(driver.live[kind], 0);
            tr_destroy(tr);
            assert_nothing_left();
        }
}

static void an_empty_viewport_draws_nothing(void **state) {
    (void)state;
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_OFF; ++see)
        for (int side = 0; side < 2; ++side) {
            tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
            setting s = make_setting();
            s.dynamic.see = (tr_see)see;
            if (side)
                s.frame.width = 0;
            else
                s.frame.height = 0;
            drawn d = run_dynamic(tr, &s);
            assert_int_equal(d.passes, 0);
            assert_int_equal(d.calls, 0);
            s = make_setting();
            s.dynamic.see = (tr_see)see;
            assert_true(run_dynamic(tr, &s).passes > 0);
            tr_destroy(tr);
        }
}

/* Each pass is there for a reason that the setting can take away. */
static void passes_are_those_called_for(void **state) {
    tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
    setting s = make_setting();
    (void)state;
    drawn d = run_dynamic(tr, &s);
    assert_int_equal(d.passes, 4); /* scene, block, targets, behind; the others are drawn by the header */
    assert_int_equal(d.units[TR_PASS_BLOCK], 1);
    assert_int_equal(d.units[TR_PASS_TARGETS], 1);
    assert_int_equal(d.units[TR_PASS_BEHIND], 1); /* the ground; the tree lies wholly before it */
    assert_int_equal(tr_get_info(tr).see_plan->pass_count, 10);
    s.dynamic.query = 1; /* ids take the place of colours: the target too */
    d = run_dynamic(tr, &s);
    assert_int_equal(d.units[TR_PASS_BEHIND], 2);
    s.dynamic.query = 0;
    s.units[GROUND].flags = 0;
    d = run_dynamic(tr, &s);
    assert_int_equal(d.kinds[TR_PASS_BLOCK], 0);
    assert_int_equal(d.units[TR_PASS_BEHIND], 1);
    s.dynamic.width = -1; /* no gradient: nothing to spread */
    run_dynamic(tr, &s);
    assert_int_equal(tr_get_info(tr).see_plan->pass_count, 6);
    s.units[TREE].importance = 0.5f;
    d = run_dynamic(tr, &s);
    assert_int_equal(d.kinds[TR_PASS_YIELD], 1);
    assert_int_equal(tr_get_info(tr).see_plan->pass_count, 8);
    s.dynamic.see = TR_SEE_DITHER; /* knows importances by itself */
    d = run_dynamic(tr, &s);
    assert_int_equal(d.passes, 2);
    assert_int_equal(tr_get_info(tr).see_plan->pass_count, 3);
    s.dynamic.query = 1;
    d = run_dynamic(tr, &s);
    assert_int_equal(d.units[TR_PASS_HIDES], 2); /* tree and ground, which is a distractor by now */
    tr_destroy(tr);
    assert_nothing_left();
}

/* How often a kind of pass comes in a frame, those of ours among them. */
static uint32_t times_of(const tr_context *tr, tr_pass_kind kind) {
    const tr_see_plan *plan = tr_get_info(tr).see_plan;
    for (int i = 0; i < plan->pass_count; ++i)
        if (plan->passes[i].kind == kind)
            return plan->passes[i].times;
    return 0;
}

/* Of sequences as well: occluders are counted, in a target of our own, where they share a mask or layers are told; what
 * closes masks is drawn where there is any; and targets that do not overlap are one run. */
static void sequences_are_those_called_for(void **state) {
    tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
    setting s = make_setting();
    (void)state;
    s.dynamic.see = TR_SEE_SEQUENCE;
    drawn d = run_dynamic(tr, &s);
    assert_true(d.kinds[TR_PASS_COUNT] == 2 && d.kinds[TR_PASS_BLOCK] == 1 && times_of(tr, TR_PASS_PAINT_OVER) == 1);
    assert_true(d.units[TR_PASS_SCENE] == 2 && d.units[TR_PASS_PAINT] == 1); /* the tree alone is painted */
    s.units[GROUND].flags = 0;
    s.dynamic.occluders = TR_OCCLUDERS_EACH;
    d = run_dynamic(tr, &s);
    assert_int_equal(d.kinds[TR_PASS_COUNT] + d.kinds[TR_PASS_BLOCK] + (int)times_of(tr, TR_PASS_PAINT_OVER), 0);
    assert_int_equal(d.passes, 4); /* scene, seeds, depth and colour of the tree */
    assert_int_equal(times_of(tr, TR_PASS_EXTENTS) + times_of(tr, TR_PASS_FORMS), 0);
    s.dynamic.shape = TR_MASK_HULL;
    assert_int_equal(run_dynamic(tr, &s).passes, 4);
    assert_true(times_of(tr, TR_PASS_EXTENTS) == 1 && times_of(tr, TR_PASS_FORMS) == 1);
    s.dynamic.shape = TR_MASK_OUTLINE;
    s.dynamic.layers = 1;
    assert_int_equal(run_dynamic(tr, &s).kinds[TR_PASS_COUNT], 2);
    s.dynamic.layers = 0;
    s.dynamic.see = TR_SEE_PUBLISHED; /* each occluder on its own */
    assert_int_equal(run_dynamic(tr, &s).kinds[TR_PASS_COUNT], 0);
    s.dynamic.see = TR_SEE_EXACT;
    s.dynamic.occluders = TR_OCCLUDERS_TOGETHER;
    d = run_dynamic(tr, &s);
    assert_int_equal(tr_get_info(tr).see_plan->runs, 1);
    assert_int_equal(tr_get_info(tr).see_plan->layers, 3); /* tree and ground, by its sphere, and what is behind them */
    assert_true(d.kinds[TR_PASS_PEEL_UNITS] == 3 && times_of(tr, TR_PASS_KEEP) == 3 &&
                times_of(tr, TR_PASS_SHARE) == 1);
    assert_int_equal(d.kinds[TR_PASS_SEEDS], 1);
    s.units[GROUND].flags = TR_UNIT_TARGET; /* another target, which reaches all around the first: a run of its own */
    d = run_dynamic(tr, &s);
    assert_int_equal(tr_get_info(tr).see_plan->runs, 2);
    assert_int_equal(d.kinds[TR_PASS_SEEDS], 4);
    tr_destroy(tr);
    assert_nothing_left();
}

/* Ten targets that stand apart behind one wall: as many passes as for one of them. */
static void targets_apart_are_one_batch(void **state) {
    enum { APART = 10 };
    static const tr_see sees[] = {TR_SEE_SEQUENCE, TR_SEE_PUBLISHED, TR_SEE_EXACT};
    (void)state;
    for (size_t m = 0; m < sizeof sees / sizeof sees[0]; ++m) {
        tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
        setting s = make_setting();
        tr_unit many[APART + 1];
        int passes[2] = {0, 0};
        for (int i = 0; i <= APART; ++i) {
            many[i] = s.units[i ? TARGET : TREE];
            many[i].id = (uint32_t)i + 1;
            many[i].center[0] = i ? 2.2f * (float)i - 12.1f : 0;
            many[i].radius = i ? 0.3f : 9;
        }
        for (int i = 0; i < 2; ++i) {
            tr_pass pass;
            s.dynamic.see = sees[m];
            s.dynamic.units = many;
            s.dynamic.unit_count = i ? APART + 1 : 2;
            assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_OK);
            while (tr_next_pass(tr, &pass))
                ++passes[i];
            assert_int_equal(tr_end(tr), TR_OK);
            assert_int_equal(tr_get_info(tr).see_plan->runs, 1);
            assert_int_equal(tr_get_info(tr).see_plan->masks, i ? APART : 1);
        }
        assert_int_equal(passes[0], passes[1]);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

/* ---- a scene in parts ---- */

/* A frame of it: each unit is drawn in one part and no other. The number of parts. */
static int run_parts(tr_context *tr, setting *s, drawn *all) {
    tr_pass pass;
    int times[UNITS] = {0}, parts = 0;
    memset(all, 0, sizeof *all);
    s->dynamic.units = s->units;
    assert_int_equal(tr_begin_dynamic(tr, &s->frame, &s->dynamic), TR_OK);
    while (tr_next_pass(tr, &pass)) {
        check_units();
        ++all->kinds[pass.kind];
        all->units[pass.kind] += pass.unit_count;
        parts += pass.kind == TR_PASS_SCENE;
        for (size_t i = 0; pass.kind == TR_PASS_SCENE && i < pass.unit_count; ++i)
            ++times[pass.units[i]];
        if (pass.kind == TR_PASS_SCENE && pass.rule == TR_RULE_SEE_DITHER)
            assert_true(pass.unit_count == 1 && pass.units[0] == TREE);
    }
    assert_int_equal(tr_end(tr), TR_OK);
    for (int i = 0; i < UNITS; ++i)
        assert_int_equal(times[i], 1);
    return parts;
}

/* Targets, what closes masks, all else; a copy where something is to be known of what is there; and nothing twice. */
static void parts_are_those_called_for(void **state) {
    (void)state;
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_DITHER; ++see) {
        tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
        setting s = make_setting();
        drawn d;
        int color = see == TR_SEE_ONE_MASK, first = driver.call_count;
        s.dynamic.see = (tr_see)see;
        s.dynamic.in_parts = 1;
        assert_int_equal(run_parts(tr, &s, &d), 3);
        assert_int_equal(called_since(first, "BlitFramebuffer"), 2 + color);
        assert_int_equal(d.kinds[TR_PASS_TARGETS] + d.kinds[TR_PASS_BLOCK] + d.kinds[TR_PASS_BEHIND], 0);
        assert_true(tr_get_info(tr).see_plan->in_parts && !tr_get_info(tr).see_plan->parts_why);
        s.units[GROUND].flags = 0;
        s.units[GROUND].radius = 5; /* wholly behind the target */
        first = driver.call_count;
        assert_int_equal(run_parts(tr, &s, &d), color ? 2 : 3); /* dither: the tree's holes, and the ground without */
        assert_int_equal(called_since(first, "BlitFramebuffer"), 1 + color);
        assert_int_equal(d.units[TR_PASS_BEHIND], color);
        s.units[GROUND].flags = TR_UNIT_BACKDROP;
        s.units[TARGET].fade = 0.5f; /* depth does not tell that */
        first = driver.call_count;
        assert_int_equal(run_parts(tr, &s, &d), 3);
        assert_int_equal(called_since(first, "BlitFramebuffer"), 1 + color);
        assert_int_equal(d.units[TR_PASS_TARGETS], 1);
        s.units[TARGET].fade = 0;
        s.units[TARGET].flags |= TR_UNIT_IMPENETRABLE; /* closes masks of others, but is drawn as a target */
        assert_int_equal(run_parts(tr, &s, &d), 3);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

/* Two targets far apart, each between a tree and a rock: what shows through is drawn in two regions, each with its own. */
static void regions_draw_what_they_meet(void **state) {
    (void)state;
    for (int in_parts = 0; in_parts < 2; ++in_parts) {
        tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
        setting s = make_setting();
        tr_unit many[6];
        tr_pass pass;
        int regions = 0, right = 0;
        for (int i = 0; i < 6; ++i) {
            many[i] = s.units[i % 3];
            many[i].id = (uint32_t)i + 1;
            many[i].flags = i % 3 == TARGET ? TR_UNIT_TARGET : 0;
            many[i].radius = 0.5f;
            many[i].center[0] = -0.5f * many[i].center[2] * (i < 3 ? -1.0f : 1.0f);
            many[i].center[1] = 0.3f * many[i].center[2] * (i < 3 ? -1.0f : 1.0f);
        }
        s.dynamic.units = many;
        s.dynamic.unit_count = 6;
        s.dynamic.in_parts = in_parts;
        assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_OK);
        while (tr_next_pass(tr, &pass)) {
            if (pass.kind != TR_PASS_BEHIND)
                continue;
            ++regions;
            assert_true(pass.unit_count == 1 && pass.units[0] % 3 == GROUND);
            right += pass.units[0] == 5;
            /* The right one is on the right, and neither covers what lies between. */
            assert_true(pass.units[0] == 5 ? pass.state.scissor[0] > 320
                                           : pass.state.scissor[0] + pass.state.scissor[2] < 320);
        }
        assert_int_equal(tr_end(tr), TR_OK);
        assert_int_equal(regions, 2);
        assert_int_equal(right, 1);
        assert_int_equal(times_of(tr, TR_PASS_BEHIND), 2);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

static void sample_the_target(setting *s) {
    (void)s;
    driver.samples = 4;
}
static void have_no_depth(setting *s) {
    (void)s;
    driver.depth_bits = 0;
}
static void have_odd_depth(setting *s) {
    (void)s;
    driver.depth_bits = 20;
}
static void draw_integers(setting *s) {
    (void)s;
    driver.component_type = 0x1405u;
}
static void draw_nothing(setting *s) {
    (void)s;
    driver.color_buffer = 0;
}
static void encode(setting *s) {
    s->frame.wishes.options = TR_WISH_SRGB;
}
static void paint_in_order(setting *s) {
    s->dynamic.see = TR_SEE_SEQUENCE;
}

/* What cannot be copied: the scene comes whole, and the plan says why. */
static void what_cannot_be_copied_comes_whole(void **state) {
    static void (*const changes[])(setting *) = {sample_the_target, have_no_depth, have_odd_depth, draw_integers,
                                                 draw_nothing,      encode,        paint_in_order, NULL};
    (void)state;
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; ++i) {
        tr_context *tr = open_context(changes[i] ? TR_STATE_RESTORE : TR_STATE_NONE, NULL);
        setting s = make_setting();
        char text[2048];
        s.dynamic.in_parts = 1;
        if (changes[i])
            changes[i](&s);
        drawn d = run_dynamic(tr, &s);
        const tr_see_plan *plan = tr_get_info(tr).see_plan;
        assert_true(!plan->in_parts && plan->parts_why);
        assert_int_equal(d.kinds[TR_PASS_SCENE], 1);
        assert_int_equal(called_since(0, "BlitFramebuffer"), 0);
        tr_see_plan_print(plan, text, sizeof text);
        assert_non_null(strstr(text, plan->parts_why));
        tr_destroy(tr);
        assert_nothing_left();
    }
}

static void parts_of_plain_drawing_call_nothing(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof plain_changes / sizeof plain_changes[0]; ++i) {
        tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
        setting s = make_setting();
        s.dynamic.in_parts = 1;
        plain_changes[i](&s);
        drawn d = run_dynamic(tr, &s);
        assert_int_equal(d.calls, 0);
        assert_int_equal(d.units[TR_PASS_SCENE], s.dynamic.unit_count);
        assert_null(tr_get_info(tr).see_plan->parts_why);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

/* Copies are of the target's format: another one makes new textures, the same one none. */
static void bytes_of_parts(void **state) {
    (void)state;
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_DITHER; ++see) {
        tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
        setting s = make_setting();
        s.dynamic.see = (tr_see)see;
        s.dynamic.in_parts = 1;
        s.units[TREE].importance = -1;
        for (int bits = 24; bits >= 0; bits -= 24) { /* without depth to copy: as ever */
            uint64_t w = 640, h = 480, low = 4 * (w / 4) * (h / 4) + 8 * (w / 4) * (h / 4), bytes = w * h / 8 + low;
            driver.depth_bits = bits;
            run_dynamic(tr, &s);
            int first = driver.call_count;
            run_dynamic(tr, &s);
            assert_int_equal(called_since(first, "TexImage2D"), 0);
            /* Of depth two copies, or one of ours and the mark; of the mask 6; in parts the colour is one more. */
            bytes += (bits > 0 && see == TR_SEE_ONE_MASK ? 18u : 14u) * w * h;
            assert_int_equal(tr_get_info(tr).see_plan->bytes, bytes);
        }
        driver.depth_bits = 24;
        run_dynamic(tr, &s);
        uint64_t before = tr_get_info(tr).see_plan->bytes;
        driver.depth_bits = 32; /* of floats, with stencil: 8 bytes */
        driver.component_type = 0x1406u;
        int first = driver.call_count;
        run_dynamic(tr, &s);
        assert_true(tr_get_info(tr).see_plan->in_parts && called_since(first, "TexImage2D") > 0);
        assert_int_equal(tr_get_info(tr).see_plan->bytes, tr_get_info(tr).bytes);
        assert_int_equal(tr_get_info(tr).see_plan->bytes, before + 8 * 640 * 480); /* two copies */
        tr_destroy(tr);
        assert_nothing_left();
    }
}

/* A format that is packed with a stencil is copied as that, also where it is attached for its depth alone; and one snapshot
 * of the host's state is enough for all copies. */
static void copies_are_of_the_format_and_cheap(void **state) {
    (void)state;
    for (int alone = 0; alone < 2; ++alone) {
        tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
        setting s = make_setting();
        uint64_t w = 640, h = 480;
        s.dynamic.in_parts = 1;
        s.frame.framebuffer = 7;
        driver.depth_bits = 32;
        driver.depth_alone = alone;
        run_dynamic(tr, &s);
        /* Two copies of 8 bytes, another depth of 4, colour of 4, mask of 6; then what is smaller. */
        assert_int_equal(tr_get_info(tr).see_plan->bytes, (26 * w * h) + w * h / 8 + 12 * (w / 4) * (h / 4));
        int first = driver.call_count;
        run_dynamic(tr, &s);
        assert_int_equal(called_since(first, "BlitFramebuffer"), 3);
        assert_int_equal(called_since(first, "GetBooleanv"), 1);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

/* ---- bytes ---- */

static void bytes_are_those_of_the_plan(void **state) {
    (void)state;
    for (int divisor = 1; divisor <= 8; divisor *= 2)
        for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_DITHER; ++see) {
            tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
            setting s = make_setting();
            s.dynamic.see = (tr_see)see;
            s.dynamic.mask_divisor = divisor;
            s.dynamic.query = 1;
            s.frame.width = 645;
            s.frame.height = 483;
            run_dynamic(tr, &s);
            /* Depth and mark, bits, rows, texels of masks and their depth, mask and its depth; what is behind; query. */
            uint64_t w = 645, h = 483, d = (uint64_t)divisor, x = (w + d - 1) / d, y = (h + d - 1) / d;
            uint64_t bytes = 8 * w * h + (w + 7) / 8 * h + 4 * x * ((h + 3) / 4) + 8 * x * y + 6 * w * h +
                             (see == TR_SEE_ONE_MASK ? 4 * w * h : 0) + 4 * ((w + 3) / 4) * ((h + 3) / 4);
            assert_int_equal(tr_get_info(tr).see_plan->bytes, bytes);
            assert_int_equal(tr_get_info(tr).bytes, bytes);
            assert_int_equal(tr_release(tr), TR_OK);
            assert_int_equal(tr_get_info(tr).bytes, 0);
            assert_int_equal(driver.live[TEXTURES], 0);
            assert_int_equal(driver.live[FENCES], 0);
            run_dynamic(tr, &s);
            assert_int_equal(tr_get_info(tr).bytes, bytes);
            tr_destroy(tr);
            assert_nothing_left();
        }
}

/* Of sequences: the targets' depth, rows and cells; depth of the backdrop; then masks, and a target of our own with
 * counters, or depth to where masks look and the layers. */
static void bytes_of_sequences(void **state) {
    (void)state;
    for (int see = TR_SEE_EXACT; see <= TR_SEE_PUBLISHED; ++see)
        for (int divisor = 1; divisor <= 8; divisor *= 2) {
            tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
            setting s = make_setting();
            s.dynamic.see = (tr_see)see;
            s.dynamic.mask_divisor = divisor;
            s.frame.width = 645;
            s.frame.height = 483;
            run_dynamic(tr, &s);
            uint64_t w = 645, h = 483, d = (uint64_t)divisor, x = (w + d - 1) / d, y = (h + d - 1) / d;
            uint64_t layers = tr_get_info(tr).see_plan->layers, bytes = 4 * w * h + 2 * x * h + 4 * x * y;
            bytes += see == TR_SEE_PUBLISHED ? 0 : 4 * w * h;
            bytes += see == TR_SEE_EXACT ? (8 + ((layers + 1) / 2 * 2) * 4 + layers * 8 + (layers + 3) / 4 * 8) * w * h
                                         : 4 * w * h;
            bytes += see == TR_SEE_SEQUENCE ? (8 + 4 + 2) * w * h : 0;
            assert_int_equal(tr_get_info(tr).see_plan->bytes, bytes);
            assert_int_equal(tr_get_info(tr).bytes, bytes);
            assert_int_equal(tr_release(tr), TR_OK);
            assert_int_equal(tr_get_info(tr).bytes, 0);
            assert_int_equal(driver.live[TEXTURES], 0);
            run_dynamic(tr, &s);
            assert_int_equal(tr_get_info(tr).bytes, bytes);
            tr_destroy(tr);
            assert_nothing_left();
        }
}

/* ---- steady frames ---- */

static void steady_frames_create_nothing(void **state) {
    static const char *const never[] = {"GenTextures",  "GenBuffers",    "GenFramebuffers", "GenVertexArrays",
                                        "CreateShader", "CreateProgram", "TexImage2D",      "TexImage3D",
                                        "BufferData",   "LinkProgram",   "CompileShader"};
    (void)state;
    for (int version = 0; version < VERSIONS; ++version)
        for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_PUBLISHED; ++see)
            for (int policy = TR_STATE_RESTORE; policy <= TR_STATE_NONE; ++policy) {
                unsigned char texels[4 * 160 * 120] = {0};
                tr_context *tr = open_context((tr_state_policy)policy, versions[version]);
                bool in_parts = (version + policy) % 2 == 1;
                setting s = make_setting();
                tr_hidden hidden[4];
                size_t count;
                driver.mapped = texels;
                s.dynamic.see = (tr_see)see;
                s.dynamic.query = see <= TR_SEE_DITHER && !(in_parts && version < 2);
                s.dynamic.in_parts = in_parts;
                run_dynamic(tr, &s);
                int first = driver.call_count, heap = blocks_left;
                for (int i = 0; i < 6; ++i) {
                    driver.signalled = i % 2 == 1;
                    s.units[TREE].center[0] = 0.1f * (float)i; /* the camera or what it sees moves */
                    s.dynamic.frame_index = (uint32_t)i;
                    assert_int_equal(tr_query_hidden(tr, hidden, 4, &count), TR_OK);
                    run_dynamic(tr, &s);
                }
                for (size_t i = 0; i < sizeof never / sizeof never[0]; ++i)
                    assert_int_equal(called_since(first, never[i]), 0);
                assert_int_equal(heap, blocks_left);
                assert_true(driver.live[FENCES] <= TR_I_QUERY_RING);
                tr_destroy(tr);
                assert_nothing_left();
            }
}

/* Units that come and go by a quarter allocate nothing; then lists grow. */
static void lists_grow_with_room_to_spare(void **state) {
    static tr_unit many[3000];
    tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
    setting s = make_setting();
    tr_pass pass;
    (void)state;
    for (int i = 0; i < 3000; ++i) {
        many[i] = s.units[i % 10 ? TREE : GROUND];
        many[i].center[0] = (float)(i % 50) - 25;
    }
    many[7] = s.units[TARGET];
    s.dynamic.units = many;
    static const size_t counts[] = {1000, 1100, 1250, 900, 3000};
    int heap = blocks_left;
    for (size_t i = 0; i < 5; ++i) {
        s.dynamic.unit_count = counts[i];
        assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_OK);
        while (tr_next_pass(tr, &pass)) {
        }
        assert_int_equal(tr_end(tr), TR_OK);
        assert_int_equal(heap - blocks_left, i < 4 ? 1 : 2);
    }
    tr_destroy(tr);
    assert_nothing_left();
}

/* ---- queries ---- */

/* What is counted is what the texels say, by rising id; a frame without masks hides nothing. */
static void queries_count_texels(void **state) {
    static unsigned char texels[4 * 160 * 120];
    tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
    setting s = make_setting();
    tr_hidden hidden[2];
    size_t count = 9;
    (void)state;
    for (int i = 0; i < 100; ++i) {
        unsigned char *texel = texels + 4 * (i * 37 % (160 * 120));
        texel[0] = i < 60 ? 2 : 0x34; /* id 2, and 0x1234 */
        texel[1] = i < 60 ? 0 : 0x12;
        texel[2] = i % 3 == 0 ? 255 : 0;
    }
    driver.mapped = texels;
    assert_int_equal(tr_query_hidden(tr, hidden, 2, &count), TR_OK);
    assert_int_equal(count, 0);
    s.dynamic.query = 1;
    run_dynamic(tr, &s);
    assert_int_equal(tr_query_hidden(tr, hidden, 2, &count), TR_OK); /* not there yet */
    assert_int_equal(count, 0);
    driver.signalled = true;
    assert_int_equal(tr_query_hidden(tr, hidden, 2, &count), TR_OK);
    assert_int_equal(count, 2);
    assert_true(hidden[0].id == 2 && hidden[0].pixels == 60 * 16 && hidden[0].hidden == 20 * 16);
    assert_true(hidden[1].id == 0x1234 && hidden[1].pixels == 40 * 16 && hidden[1].hidden == 14 * 16);
    assert_int_equal(tr_query_hidden(tr, hidden, 1, &count), TR_OK); /* the same again, cut short */
    assert_int_equal(count, 2);
    assert_int_equal(tr_query_hidden(tr, NULL, 0, &count), TR_OK);
    assert_int_equal(count, 2);
    assert_int_equal(tr_query_hidden(tr, NULL, 1, &count), TR_INVALID_ARGUMENT);
    assert_int_equal(tr_query_hidden(tr, hidden, 1, NULL), TR_INVALID_ARGUMENT);
    run_dynamic(tr, &s);
    look_away(&s);
    run_dynamic(tr, &s); /* the answer under way is of a frame before this one */
    assert_int_equal(tr_query_hidden(tr, hidden, 2, &count), TR_OK);
    assert_int_equal(count, 0);
    tr_destroy(tr);
    assert_nothing_left();
}

static void queries_without_functions(void **state) {
    tr_desc desc = make_desc(TR_STATE_RESTORE);
    (void)state;
    reset_driver();
    driver.missing = "glMapBufferRange"; /* WebGL 2 */
    tr_context *tr = tr_create(&desc, NULL);
    assert_non_null(tr);
    setting s = make_setting();
    run_dynamic(tr, &s);
    s.dynamic.query = 1;
    s.dynamic.units = s.units;
    assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_GL_FUNCTION_MISSING);
    assert_non_null(strstr(driver.text, "dynamic.query"));
    tr_destroy(tr);
    assert_nothing_left();
}

/* ---- bad input ---- */

static float one_nan(void) {
    return NAN;
}

static void set_see(setting *s) {
    s->dynamic.see = (tr_see)99;
}
static void set_shape(setting *s) {
    s->dynamic.shape = (tr_mask_shape)9;
}
static void set_combine(setting *s) {
    s->dynamic.combine = (tr_mask_combine)-1;
}
static void set_occluders(setting *s) {
    s->dynamic.occluders = (tr_occluders)2;
}
static void set_alpha(setting *s) {
    s->dynamic.alpha_target = 1.01f;
}
static void set_start(setting *s) {
    s->dynamic.alpha_start = one_nan();
}
static void set_width(setting *s) {
    s->dynamic.width = (float)TR_MAX_MASK_WIDTH + 1;
}
static void set_divisor(setting *s) {
    s->dynamic.mask_divisor = 3;
}
static void set_layers(setting *s) {
    s->dynamic.layers = -1;
}
static void set_view(setting *s) {
    s->dynamic.view[7] = one_nan();
}
static void set_projection(setting *s) {
    s->dynamic.projection[0] = (float)INFINITY;
}
static void set_background(setting *s) {
    s->dynamic.background[2] = one_nan();
}
static void set_light_count(setting *s) {
    s->dynamic.light_count = 1;
}
static void set_stride(setting *s) {
    s->dynamic.unit_stride = sizeof(tr_unit) - 4;
}
static void set_count(setting *s) {
    s->dynamic.unit_count = SIZE_MAX;
}
static void set_id(setting *s) {
    s->units[TREE].id = 65536;
}
static void set_flags(setting *s) {
    s->units[TREE].flags = 32;
}
static void set_backdrop(setting *s) {
    s->units[TARGET].flags |= TR_UNIT_BACKDROP;
}
static void set_no_id(setting *s) {
    s->units[TARGET].id = 0;
}
static void set_same_id(setting *s) {
    s->units[TREE].flags = TR_UNIT_TARGET;
    s->units[TREE].id = s->units[TARGET].id;
}
static void set_size(setting *s) {
    s->frame.width = -1;
}

static void bad_input_is_refused(void **state) {
    static const struct {
        void (*change)(setting *);
        const char *says;
    } cases[] = {{set_see, "dynamic.see"},       {set_shape, "shape"},
                 {set_combine, "combine"},       {set_occluders, "occluders"},
                 {set_alpha, "alpha_target"},    {set_start, "alpha_start"},
                 {set_width, "width"},           {set_divisor, "mask_divisor"},
                 {set_layers, "layers"},         {set_view, "view"},
                 {set_projection, "projection"}, {set_background, "background"},
                 {set_light_count, "lights"},    {set_stride, "unit_stride"},
                 {set_count, "unit_count"},      {set_id, "id"},
                 {set_flags, "flags"},           {set_backdrop, "backdrop"},
                 {set_no_id, "id of a target"},  {set_same_id, "another one's"},
                 {set_size, "frame.width"}};
    tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
    tr_pass pass;
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        setting s = make_setting();
        int first = driver.call_count;
        driver.text[0] = 0;
        s.dynamic.units = s.units;
        cases[i].change(&s);
        assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_INVALID_ARGUMENT);
        assert_non_null(strstr(driver.text, cases[i].says));
        assert_int_equal(driver.call_count, first);
        assert_int_equal(tr_next_pass(tr, &pass), 0);
        assert_int_equal(tr_end(tr), TR_WRONG_ORDER);
    }
    setting s = make_setting();
    assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_INVALID_ARGUMENT); /* units is NULL */
    s.dynamic.units = s.units;
    assert_int_equal(tr_begin_dynamic(NULL, &s.frame, &s.dynamic), TR_INVALID_ARGUMENT);
    assert_int_equal(tr_begin_dynamic(tr, NULL, &s.dynamic), TR_INVALID_ARGUMENT);
    assert_int_equal(tr_begin_dynamic(tr, &s.frame, NULL), TR_INVALID_ARGUMENT);
    assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_OK);
    assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_WRONG_ORDER);
    assert_int_equal(tr_end(tr), TR_OK);
    tr_destroy(tr);
    assert_nothing_left();
}

/* Units that are odd but no mistake: NaN bounds, radius 0, importance out of range. */
static void odd_units_are_drawn(void **state) {
    (void)state;
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_PUBLISHED; ++see)
        for (int i = 0; i < 7; ++i) {
            tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
            setting s = make_setting();
            tr_unit *target = &s.units[TARGET];
            s.dynamic.see = (tr_see)see;
            if (i < 2)
                s.units[i].center[1] = one_nan();
            else if (i == 2)
                target->radius = 0;
            else if (i == 3)
                target->importance = 8;
            else if (i == 4)
                s.units[TREE].importance = -3;
            else if (i == 5)
                target->radius = one_nan();
            else
                target->importance = s.units[TREE].importance = target->fade = one_nan();
            drawn d = run_dynamic(tr, &s);
            /* Where the order is that of middles, what has none is the farthest, and painted first. */
            if (i == 0 && see >= TR_SEE_SEQUENCE) {
                assert_int_equal(seen(tr), TR_SEE_OFF);
                tr_destroy(tr);
                continue;
            }
            assert_int_equal(seen(tr), see);
            assert_int_equal(d.units[see <= TR_SEE_DITHER ? TR_PASS_TARGETS : TR_PASS_SEEDS], 1);
            assert_true(tr_get_info(tr).see_plan->covered > 0);
            if (i == 1 || i == 5)
                assert_true(tr_get_info(tr).see_plan->covered > 0.999f);
            tr_destroy(tr);
            assert_nothing_left();
        }
}

/* Targets that passes ask for, of many units. */
static size_t count_targets(tr_context *tr, setting *s, tr_see see) {
    tr_pass pass;
    size_t targets = 0;
    s->dynamic.see = see;
    assert_int_equal(tr_begin_dynamic(tr, &s->frame, &s->dynamic), TR_OK);
    while (driver.call_count = 0, tr_next_pass(tr, &pass)) /* there are more calls than the driver keeps */
        targets += pass.kind == TR_PASS_TARGETS || pass.kind == TR_PASS_SEEDS ? pass.unit_count : 0;
    assert_int_equal(tr_end(tr), TR_OK);
    return targets;
}

/* A thousand of them targets; in sequences, which have passes for each run of masks and each batch before them, twenty, and
 * most of the others are behind all. The exact rung tells units apart by ids of 16 bits and refuses so many. */
static void hundred_thousand_units(void **state) {
    enum { COUNT = 100000 };
    tr_unit *many = calloc(COUNT, sizeof *many);
    (void)state;
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_PUBLISHED; ++see) {
        tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
        setting s = make_setting();
        int step = see <= TR_SEE_DITHER ? 100 : 5000;
        for (int i = 0; i < COUNT; ++i) {
            many[i] = s.units[i % step == 0 ? TARGET : TREE];
            many[i].id = i % step == 0 ? (uint32_t)(i / step) + 1 : 0;
            many[i].center[0] = (float)(i % 251) * 0.1f - 12.5f;
            many[i].center[1] = (float)(i % 173) * 0.1f - 8.6f;
            many[i].center[2] -= (float)(i % 7) + (step > 100 && i % step > 20 ? 200.0f : 0.0f);
            if (i % (10 * step) == 1) /* everywhere */
                many[i].radius = one_nan();
        }
        s.dynamic.units = many;
        s.dynamic.unit_count = COUNT;
        s.dynamic.see = (tr_see)see;
        if (see == TR_SEE_EXACT) {
            assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_INVALID_ARGUMENT);
            assert_non_null(strstr(driver.text, "id"));
        } else {
            size_t targets = count_targets(tr, &s, (tr_see)see);
            assert_true(targets > (size_t)(COUNT / step / 10) && targets <= (size_t)(COUNT / step));
        }
        tr_destroy(tr);
        assert_nothing_left();
    }
    free(many);
}

/* What a rung cannot do it refuses by name. */
static void rungs_say_what_they_cannot(void **state) {
    tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
    (void)state;
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_DITHER; ++see) {
        setting s = make_setting();
        s.dynamic.units = s.units;
        s.dynamic.see = (tr_see)see;
        s.dynamic.combine = TR_MASK_PRODUCT;
        assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_INVALID_ARGUMENT);
        s.dynamic.combine = TR_MASK_MIN;
        s.dynamic.layers = 1;
        assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_INVALID_ARGUMENT);
        s.dynamic.layers = 0;
        s.dynamic.occluders = TR_OCCLUDERS_EACH;
        assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic),
                         see == TR_SEE_DITHER ? TR_OK : TR_INVALID_ARGUMENT);
        tr_end(tr);
    }
    tr_destroy(tr);
}

/* ---- failures ---- */

/* Each framebuffer, the compiler, the linker, each allocation: an error, state as found, and the next frame may go well. */
static void failures_leave_nothing(void **state) {
    (void)state;
    for (int what = 0; what < 15; ++what) {
        tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
        setting s = make_setting();
        tr_pass pass;
        s.dynamic.units = s.units;
        s.dynamic.query = 1;
        if (what < 9)
            driver.fail_framebuffer = what + 1; /* the host's, then our seven */
        else if (what < 11)
            driver.fail_compile = what - 8;
        else
            blocks_left = what - 11; /* the lists; the answers */
        tr_result result = tr_begin_dynamic(tr, &s.frame, &s.dynamic);
        assert_int_equal(result, what < 8                   ? TR_TARGET_INCOMPLETE
                                 : what == 9 || what == 10  ? TR_SHADER_FAILED
                                 : what == 11 || what == 12 ? TR_OUT_OF_MEMORY
                                                            : TR_OK);
        if (result != TR_OK) {
            assert_true(strlen(driver.text) > 10);
            assert_int_equal(tr_next_pass(tr, &pass), 0);
        } else {
            tr_end(tr);
        }
        assert_int_equal(driver.bound_framebuffer, 0);
        assert_int_equal(driver.program, 0);
        driver.fail_framebuffer = driver.fail_compile = 0;
        blocks_left = 1000;
        run_dynamic(tr, &s);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

/* The same of sequences and of scenes in parts, one by one until there is no more that can fail. */
static void failures_of_sequences_and_parts_leave_nothing(void **state) {
    (void)state;
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_PUBLISHED; ++see)
        for (int what = 0; what < 3; ++what) {
            int failed = 0, first = 1;
            for (int n = 1; first || failed; ++n) {
                tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
                setting s = make_setting();
                tr_pass pass;
                bool again = see >= TR_SEE_EXACT; /* framebuffers of ours are tried again with 8 bits */
                s.dynamic.units = s.units;
                s.dynamic.see = (tr_see)see;
                s.dynamic.in_parts = 1;
                if (what == 0)
                    blocks_left = n - 1;
                else if (what == 1)
                    driver.fail_compile = n;
                else
                    driver.fail_framebuffer = n == 1 || !again ? n : 0;
                tr_result result = tr_begin_dynamic(tr, &s.frame, &s.dynamic);
                first = 0;
                failed = result != TR_OK && (what == 0 || n < 2 || (what == 2 && !again));
                assert_int_equal(result, result == TR_OK ? TR_OK
                                         : what == 0     ? TR_OUT_OF_MEMORY
                                         : what == 1     ? TR_SHADER_FAILED
                                                         : TR_TARGET_INCOMPLETE);
                assert_true(result != TR_OK || n > 1);
                if (result != TR_OK) {
                    assert_true(strlen(driver.text) > 10);
                    assert_int_equal(tr_next_pass(tr, &pass), 0);
                    assert_int_equal(tr_end(tr), TR_WRONG_ORDER);
                } else {
                    while (tr_next_pass(tr, &pass)) {
                    }
                    assert_int_equal(tr_end(tr), TR_OK);
                }
                assert_int_equal(driver.bound_framebuffer, 0);
                assert_int_equal(driver.program, 0);
                driver.fail_framebuffer = driver.fail_compile = 0;
                blocks_left = 1000;
                run_dynamic(tr, &s);
                tr_destroy(tr);
                assert_nothing_left();
            }
        }
}

/* Masks of bytes where the driver refuses floats or the host wants none: in the first frame already the plan says so, and
 * counts them. */
static void bytes_where_floats_are_not_had(void **state) {
    (void)state;
    for (int see = TR_SEE_EXACT; see <= TR_SEE_PUBLISHED; ++see) {
        uint64_t bytes[3];
        for (int how = 0; how < 3; ++how) {
            tr_desc desc = make_desc(TR_STATE_RESTORE);
            setting s = make_setting();
            s.dynamic.see = (tr_see)see;
            desc.eight_bits = how == 2;
            reset_driver();
            tr_context *tr = tr_create(&desc, NULL);
            assert_non_null(tr);
            driver.fail_framebuffer = how == 1 ? 2 : 0; /* the first of ours */
            run_dynamic(tr, &s);
            driver.fail_framebuffer = 0;
            assert_int_equal(seen(tr), see);
            assert_true((strstr(tr_get_info(tr).see_plan->why, "8 bits") != NULL) == (how > 0));
            bytes[how] = tr_get_info(tr).see_plan->bytes;
            tr_destroy(tr);
            assert_nothing_left();
        }
        assert_true(bytes[1] < bytes[0] && bytes[2] == bytes[1]);
    }
}

/* The context is lost at each call in turn: no crash, no endless loop, nothing of ours on the heap afterwards. */
static void contexts_may_be_lost_anywhere(void **state) {
    (void)state;
    for (int which = 0; which <= TR_SEE_PUBLISHED + 2; ++which)
        for (int at = 1, done = 0; !done; at += 7) {
            bool in_parts = which > TR_SEE_PUBLISHED;
            tr_see see = (tr_see)(which % (TR_SEE_PUBLISHED + 1));
            tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
            setting s = make_setting();
            tr_hidden hidden[2];
            tr_pass pass;
            size_t count;
            static unsigned char texels[4 * 160 * 120];
            driver.mapped = texels;
            driver.signalled = true;
            s.dynamic.units = s.units;
            s.dynamic.see = see;
            s.dynamic.in_parts = in_parts;
            s.dynamic.query = see <= TR_SEE_DITHER && !in_parts;
            driver.lost_at = driver.call_count + at;
            if (tr_begin_dynamic(tr, &s.frame, &s.dynamic) == TR_OK) {
                while (tr_next_pass(tr, &pass)) {
                }
                assert_int_equal(tr_end(tr), TR_OK);
                tr_query_hidden(tr, hidden, 2, &count);
            }
            done = driver.call_count < driver.lost_at;
            tr_destroy(tr);
            assert_int_equal(blocks, 0);
        }
}

/* ---- state ---- */

/* With the host applying state itself only what is created or changed is bound; each pass says all it needs. */
static void no_state_calls_where_the_host_makes_them(void **state) {
    static const char *const never[] = {"Enable",          "Disable",  "Enablei",          "Disablei",     "UseProgram",
                                        "BindFramebuffer", "Viewport", "ViewportIndexedf", "DrawArrays",   "DepthMask",
                                        "BindTexture",     "Scissor",  "ScissorIndexed",   "ClearBufferfv"};
    (void)state;
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_OFF; ++see) {
        tr_context *tr = open_context(TR_STATE_NONE, NULL);
        setting s = make_setting();
        tr_pass pass;
        s.dynamic.see = (tr_see)see;
        run_dynamic(tr, &s);
        int first = driver.call_count, full_screen = 0;
        s.dynamic.units = s.units;
        assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_OK);
        while (tr_next_pass(tr, &pass)) {
            const tr_state *st = &pass.state;
            bool drawn_by_host = pass.unit_count > 0;
            assert_true(drawn_by_host == (st->vertex_count == 0));
            assert_true(st->program != 0);
            assert_true(st->viewport[2] > 0 && st->viewport[3] > 0);
            if (see <= TR_SEE_DITHER)
                assert_true((st->framebuffer == 0) ==
                            (pass.kind == TR_PASS_SCENE || pass.kind == TR_PASS_COMPOSE_MASK));
            if (pass.kind == TR_PASS_SCENE)
                assert_true(st->framebuffer == 0 && st->depth_test && st->depth_write && st->color_write && !st->blend);
            if (st->scissor[2])
                assert_true(st->scissor[0] >= 0 && st->scissor[0] + st->scissor[2] <= st->viewport[2] &&
                            st->scissor[1] >= 0 && st->scissor[1] + st->scissor[3] <= st->viewport[3]);
            full_screen += !drawn_by_host;
            if (!drawn_by_host && see <= TR_SEE_DITHER)
                assert_int_equal(st->vertex_count % 6, 0);
            for (int i = 0; i < TR_TEXTURE_UNITS; ++i) /* what is read is not what is drawn into */
                assert_true(st->textures[i] == 0 || st->texture_targets[i] != 0);
        }
        assert_int_equal(tr_end(tr), TR_OK);
        if (see == TR_SEE_ONE_MASK)
            assert_int_equal(full_screen, 6);
        for (size_t i = 0; i < sizeof never / sizeof never[0]; ++i)
            assert_int_equal(called_since(first, never[i]), 0);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

/* The scene is drawn in the host's state: before it the header has changed nothing, or put all back. */
static void the_scene_is_the_hosts(void **state) {
    (void)state;
    for (int see = TR_SEE_ONE_MASK; see <= TR_SEE_PUBLISHED; ++see) {
        tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
        setting s = make_setting();
        tr_pass pass;
        s.dynamic.see = (tr_see)see;
        run_dynamic(tr, &s);
        s.dynamic.units = s.units;
        driver.program = 77;
        driver.bound_framebuffer = 55;
        driver.unit_textures[3] = 33;
        driver.unit_textures[8 + TR_I_SCENE_DEPTH] = 44;
        int first = driver.call_count;
        assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_OK);
        do
            assert_int_equal(tr_next_pass(tr, &pass), 1);
        while (pass.kind != TR_PASS_SCENE);
        assert_int_equal(driver.program, 77);
        assert_int_equal(driver.bound_framebuffer, 55);
        if (see != TR_SEE_DITHER) /* the first pass */
            assert_int_equal(called_since(first, "UseProgram") + called_since(first, "Enable"), 0);
        else
            assert_true(driver.unit_textures[8 + TR_I_SCENE_DEPTH] == pass.state.textures[TR_I_SCENE_DEPTH]);
        driver.program = 78; /* as the host's own drawing leaves it */
        while (tr_next_pass(tr, &pass)) {
        }
        assert_int_equal(tr_end(tr), TR_OK);
        assert_int_equal(driver.program, 78);
        assert_int_equal(driver.bound_framebuffer, 55);
        assert_int_equal(driver.unit_textures[3], 33);
        assert_int_equal(driver.unit_textures[8 + TR_I_SCENE_DEPTH], 44);
        tr_destroy(tr);
        assert_nothing_left();
    }
}

/* The built-in program for the scene: made when it is first used, in use then. */
static void built_in_scenes(void **state) {
    tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
    setting s = make_setting();
    tr_material material;
    tr_pass pass;
    (void)state;
    memset(&material, 0, sizeof material);
    s.dynamic.units = s.units;
    s.dynamic.see = TR_SEE_OFF;
    for (int i = 0; i < 2; ++i) {
        int first = driver.call_count;
        assert_int_equal(tr_begin_dynamic(tr, &s.frame, &s.dynamic), TR_OK);
        assert_int_equal(tr_next_pass(tr, &pass), 1);
        driver.program = 5; /* the host's */
        tr_set_material(tr, &pass, &material);
        tr_set_material(tr, &pass, &material);
        assert_true(driver.program != 5);
        assert_int_equal(called_since(first, "LinkProgram"), i == 0);
        assert_int_equal(called_since(first, "BindBufferBase"), 1);
        assert_int_equal(tr_end(tr), TR_OK);
    }
    tr_destroy(tr);
    assert_nothing_left();
}

static void plans_are_printed(void **state) {
    tr_context *tr = open_context(TR_STATE_RESTORE, NULL);
    setting s = make_setting();
    char text[2000], small[10];
    (void)state;
    run_dynamic(tr, &s);
    size_t length = tr_see_plan_print(tr_get_info(tr).see_plan, text, sizeof text);
    assert_int_equal(length, strlen(text));
    assert_non_null(strstr(text, "one mask: "));
    assert_non_null(strstr(text, "1 targets, 1 in view, 1 with masks"));
    assert_non_null(strstr(text, "behind [1 units]"));
    assert_non_null(strstr(text, "compose mask"));
    assert_int_equal(tr_see_plan_print(tr_get_info(tr).see_plan, small, sizeof small), length);
    assert_int_equal(strlen(small), sizeof small - 1);
    assert_int_equal(tr_see_plan_print(tr_get_info(tr).see_plan, NULL, 0), length);
    assert_int_equal(tr_see_plan_print(NULL, text, sizeof text), 0);
    tr_destroy(tr);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plain_drawing_calls_nothing),
        cmocka_unit_test(parts_are_those_called_for),
        cmocka_unit_test(regions_draw_what_they_meet),
        cmocka_unit_test(what_cannot_be_copied_comes_whole),
        cmocka_unit_test(parts_of_plain_drawing_call_nothing),
        cmocka_unit_test(bytes_of_parts),
        cmocka_unit_test(copies_are_of_the_format_and_cheap),
        cmocka_unit_test(plain_drawing_creates_nothing),
        cmocka_unit_test(an_empty_viewport_draws_nothing),
        cmocka_unit_test(passes_are_those_called_for),
        cmocka_unit_test(sequences_are_those_called_for),
        cmocka_unit_test(targets_apart_are_one_batch),
        cmocka_unit_test(bytes_are_those_of_the_plan),
        cmocka_unit_test(bytes_of_sequences),
        cmocka_unit_test(steady_frames_create_nothing),
        cmocka_unit_test(lists_grow_with_room_to_spare),
        cmocka_unit_test(queries_count_texels),
        cmocka_unit_test(queries_without_functions),
        cmocka_unit_test(bad_input_is_refused),
        cmocka_unit_test(odd_units_are_drawn),
        cmocka_unit_test(hundred_thousand_units),
        cmocka_unit_test(rungs_say_what_they_cannot),
        cmocka_unit_test(failures_leave_nothing),
        cmocka_unit_test(failures_of_sequences_and_parts_leave_nothing),
        cmocka_unit_test(bytes_where_floats_are_not_had),
        cmocka_unit_test(contexts_may_be_lost_anywhere),
        cmocka_unit_test(no_state_calls_where_the_host_makes_them),
        cmocka_unit_test(the_scene_is_the_hosts),
        cmocka_unit_test(built_in_scenes),
        cmocka_unit_test(plans_are_printed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

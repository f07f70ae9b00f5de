/* mock_alpha.c: tr_set_edges on a driver that is not there: what is uploaded where, what a change costs in calls and
 * bytes, bad arrays, limits, and that nothing is left behind. A GL function that it has no need of is not to be called. */
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

/* ---- the driver that is not there: two textures, a unit, how pixels are unpacked ---- */

enum { MAX_TEXTURES = 64, ROW = 1024 };

typedef struct fake_texture {
    int32_t width, height;
    size_t texel; /* bytes */
    unsigned char *texels;
} fake_texture;

static struct {
    int32_t max_texture_size, unit, unpack[8], unpack_buffer;
    uint32_t bound[32], next;
    fake_texture textures[MAX_TEXTURES];
    int live, made, calls, uploads;
    size_t bytes; /* uploaded */
    const char *version;
    char text[4096];
} driver;

static void fake_ActiveTexture(uint32_t unit) {
    ++driver.calls;
    driver.unit = (int32_t)unit;
}

static void fake_BindTexture(uint32_t target, uint32_t name) {
    ++driver.calls;
    assert_int_equal(target, 0x0DE1);
    driver.bound[driver.unit - 0x84C0] = name;
}

static void fake_BindBuffer(uint32_t target, uint32_t name) {
    ++driver.calls;
    assert_int_equal(target, 0x88EC); /* pixel unpack */
    driver.unpack_buffer = (int32_t)name;
}

static void fake_PixelStorei(uint32_t name, int32_t value) {
    ++driver.calls;
    assert_true(name >= 0x0CF0 && name <= 0x0CF5);
    driver.unpack[name - 0x0CF0] = value;
}

static void fake_GenTextures(int32_t count, uint32_t *names) {
    ++driver.calls;
    for (int32_t i = 0; i < count; ++i) {
        assert_true(driver.next + 1 < MAX_TEXTURES);
        names[i] = ++driver.next;
        ++driver.live;
        ++driver.made;
    }
}

static void fake_DeleteTextures(int32_t count, const uint32_t *names) {
    ++driver.calls;
    for (int32_t i = 0; i < count; ++i)
        if (names[i]) {
            free(driver.textures[names[i]].texels);
            memset(&driver.textures[names[i]], 0, sizeof driver.textures[0]);
            --driver.live;
        }
}

static void fake_DeleteFramebuffers(int32_t count, const uint32_t *names) {
    (void)count, (void)names;
}

static fake_texture *bound(void) {
    uint32_t name = driver.bound[driver.unit - 0x84C0];
    assert_true(name != 0 && name < MAX_TEXTURES);
    return &driver.textures[name];
}

static void fake_TexImage2D(uint32_t target, int32_t level, int32_t internal, int32_t width, int32_t height,
                            int32_t border, uint32_t format, uint32_t type, const void *pixels) {
    fake_texture *t = bound();
    ++driver.calls;
    assert_true(target == 0x0DE1 && level == 0 && border == 0 && pixels == NULL);
    /* RGBA32F from floats, R32UI from unsigned integers, as ES 3.0 has them. */
    assert_true((internal == 0x8814 && format == 0x1908 && type == 0x1406) ||
                (internal == 0x8236 && format == 0x8D94 && type == 0x1405));
    assert_true(width > 0 && height > 0 && width <= driver.max_texture_size && height <= driver.max_texture_size);
    t->width = width;
    t->height = height;
    t->texel = internal == 0x8814 ? 16 : 4;
    t->texels = malloc((size_t)width * (size_t)height * t->texel);
    assert_non_null(t->texels);
    memset(t->texels, 0xcd, (size_t)width * (size_t)height * t->texel);
}

static void fake_TexParameteri(uint32_t target, uint32_t name, int32_t value) {
    ++driver.calls;
    (void)target, (void)name, (void)value;
}

static void fake_TexSubImage2D(uint32_t target, int32_t level, int32_t x, int32_t y, int32_t width, int32_t height,
                               uint32_t format, uint32_t type, const void *pixels) {
    fake_texture *t = bound();
    ++driver.calls;
    ++driver.uploads;
    assert_true(target == 0x0DE1 && level == 0 && format == (t->texel == 16 ? 0x1908u : 0x8D94u) &&
                type == (t->texel == 16 ? 0x1406u : 0x1405u));
    assert_true(x >= 0 && y >= 0 && width > 0 && height > 0 && x + width <= t->width && y + height <= t->height);
    assert_int_equal(driver.unpack_buffer, 0);
    for (int i = 0; i < 5; ++i)
        assert_int_equal(driver.unpack[i], 0);
    assert_int_equal(driver.unpack[5], 4);
    for (int32_t row = 0; row < height; ++row)
        memcpy(t->texels + ((size_t)(y + row) * (size_t)t->width + (size_t)x) * t->texel,
               (const char *)pixels + (size_t)(row * width) * t->texel, (size_t)width * t->texel);
    driver.bytes += (size_t)width * (size_t)height * t->texel;
}

static void fake_GetIntegerv(uint32_t name, int32_t *out) {
    *out = 0;
    ++driver.calls;
    if (name == 0x0D33)
        *out = driver.max_texture_size;
    else if (name == 0x0D3A)
        out[0] = out[1] = 16384;
    else if (name == 0x8B4D || name == 0x8A2F)
        *out = 32;
    else if (name == 0x84E0)
        *out = driver.unit;
    else if (name == 0x8069)
        *out = (int32_t)driver.bound[driver.unit - 0x84C0];
    else if (name == 0x88EF)
        *out = driver.unpack_buffer;
    else if (name >= 0x0CF0 && name <= 0x0CF5)
        *out = driver.unpack[name - 0x0CF0];
}

static const unsigned char *fake_GetString(uint32_t name) {
    (void)name;
    return (const unsigned char *)driver.version;
}

/* Known to get_proc, for a context that asks; to call it is a mistake. */
static void fake_unexpected(void) {
    fail_msg("a GL function that has nothing to do with edges was called");
}

static tr_proc get_proc(const char *name) {
#define GIVE(function)                                                                                                 \
    if (strcmp(name, "gl" #function) == 0)                                                                             \
        return (tr_proc)fake_##function;
    GIVE(ActiveTexture)
    GIVE(BindBuffer)
    GIVE(BindTexture)
    GIVE(DeleteFramebuffers)
    GIVE(DeleteTextures)
    GIVE(GenTextures)
    GIVE(GetIntegerv)
    GIVE(GetString)
    GIVE(PixelStorei)
    GIVE(TexImage2D)
    GIVE(TexParameteri)
    GIVE(TexSubImage2D)
#undef GIVE
    return fake_unexpected;
}

static void keep_text(tr_log_level level, tr_result code, const char *text, void *user) {
    (void)level, (void)code, (void)user;
    snprintf(driver.text, sizeof driver.text, "%s", text);
}

static int blocks;

static void *count_alloc(size_t size, void *user) {
    (void)user;
    ++blocks;
    return malloc(size);
}

static void count_free(void *block, void *user) {
    (void)user;
    --blocks;
    free(block);
}

static tr_context *open_context(const char *version, int32_t max_texture_size) {
    tr_desc desc;
    tr_result result;
    memset(&desc, 0, sizeof desc);
    memset(&driver, 0, sizeof driver);
    driver.version = version;
    driver.max_texture_size = max_texture_size;
    driver.unit = 0x84C0 + 3;
    driver.unpack[5] = 1; /* what a host has set: alignment, a row length, a buffer */
    driver.unpack[2] = 77;
    driver.unpack_buffer = 55;
    driver.bound[8 + TR_I_CROSSINGS] = 44; /* the unit that uploads go through */
    desc.get_proc = get_proc;
    desc.log_fn = keep_text;
    desc.alloc_fn = count_alloc;
    desc.free_fn = count_free;
    blocks = 0;
    tr_context *tr = tr_create(&desc, &result);
    assert_non_null(tr);
    return tr;
}

static void close_context(tr_context *tr) {
    tr_destroy(tr);
    assert_int_equal(driver.live, 0);
    assert_int_equal(blocks, 0);
}

/* ---- edges ---- */

enum { EDGES = 20000, TRIANGLES = 700 };

static float points[EDGES + 1][3];
static uint32_t ends[EDGES][2], offsets[TRIANGLES + 1], candidates[TRIANGLES * 5], order[EDGES];

static tr_edges some_edges(size_t count, bool listed) {
    tr_edges edges;
    memset(&edges, 0, sizeof edges);
    for (uint32_t i = 0; i <= EDGES; ++i) {
        points[i][0] = 1000 + (float)i / 16;
        points[i][1] = (float)(i * i % 97) / 8;
        points[i][2] = -3;
    }
    for (uint32_t i = 0; i < EDGES; ++i) {
        ends[i][0] = i;
        ends[i][1] = i + 1;
        order[i] = (uint32_t)count - 1 - (i < count ? i : 0);
    }
    offsets[0] = 0;
    for (uint32_t i = 0; i < TRIANGLES; ++i) {
        offsets[i + 1] = offsets[i] + i % 6;
        for (uint32_t k = offsets[i]; k < offsets[i + 1]; ++k)
            candidates[k] = (i * 7 + k) % (uint32_t)(count ? count : 1);
    }
    edges.positions = points[0];
    edges.position_count = EDGES + 1;
    edges.ends = ends[0];
    edges.edge_count = count;
    if (listed) {
        edges.offsets = offsets;
        edges.candidates = candidates;
        edges.triangle_count = TRIANGLES;
    }
    return edges;
}

static const float *texel(uint32_t name, size_t at) {
    return (const float *)(const void *)(driver.textures[name].texels + at * 16);
}

static uint32_t entry(uint32_t name, size_t at) {
    uint32_t value;
    memcpy(&value, driver.textures[name].texels + at * 4, 4);
    return value;
}

/* The set's segment, back in the world. */
static void segment(const tr_context *tr, const tr_edge_set *set, uint32_t i, double p[3], double q[3]) {
    const float *at = texel(tr->edge_textures[0], set->ranges[0] + 2 * i);
    for (int k = 0; k < 3; ++k) {
        p[k] = (double)at[k] * (double)set->frame[15] + (double)set->frame[12 + k];
        q[k] = p[k] + (double)at[4 + k] * (double)set->frame[15];
    }
    double square = 0;
    for (int k = 0; k < 3; ++k)
        square += (double)at[4 + k] * (double)at[4 + k];
    assert_true(fabs((double)at[3] * square - 1) < 1e-5);
}

static void expect_host_state(void) {
    assert_int_equal(driver.unit, 0x84C0 + 3);
    assert_int_equal(driver.unpack[5], 1);
    assert_int_equal(driver.unpack[2], 77);
    assert_int_equal(driver.unpack_buffer, 55);
    assert_int_equal(driver.bound[8 + TR_I_CROSSINGS], 44);
}

/* Several objects in two textures, over the ends of rows: each one's segments and lists are where its set says. */
static void test_arrays_hold_what_was_given(void **state) {
    tr_edge_set sets[3];
    (void)state;
    tr_context *tr = open_context("OpenGL ES 3.0 Mock", 2048);
    tr_edges edges[3] = {some_edges(EDGES, true), some_edges(EDGES, true), some_edges(EDGES, true)};
    edges[1].edge_count = 1;
    edges[1].offsets = edges[1].candidates = NULL;
    edges[2].edge_count = 1500;
    edges[2].offsets = edges[2].candidates = NULL;
    edges[2].order = order;
    (void)some_edges(1500, true); /* the order, reversed, and candidates below 1500 */
    assert_int_equal(tr_set_edges(tr, edges, 3, sets), TR_OK);
    expect_host_state();
    for (int s = 0; s < 3; ++s)
        for (uint32_t i = 0; i < edges[s].edge_count; ++i) {
            double p[3], q[3];
            uint32_t edge = s == 2 ? 1499 - i : i;
            segment(tr, &sets[s], i, p, q);
            for (int k = 0; k < 3; ++k) {
                assert_true(fabs(p[k] - (double)points[edge][k]) < 1e-4);
                assert_true(fabs(q[k] - (double)points[edge + 1][k]) < 1e-4);
            }
        }
    for (uint32_t i = 0; i <= TRIANGLES; ++i)
        assert_int_equal(entry(tr->edge_textures[1], sets[0].ranges[2] + i), offsets[i]);
    for (uint32_t i = 0; i < offsets[TRIANGLES]; ++i)
        assert_int_equal(entry(tr->edge_textures[1], sets[0].ranges[3] + i), candidates[i]);
    assert_int_equal(sets[1].ranges[3], 0xffffffffu);
    close_context(tr);
}

/* Every box holds its segments and its children, and the way past a box leads to the next that is not in it. */
static uint32_t check_box(const tr_context *tr, const tr_edge_set *set, uint32_t box, const float *parent,
                          uint32_t *next_segment) {
    const float *at = texel(tr->edge_textures[0], set->ranges[0] + 2 * (set->ranges[1] + box));
    const float *size = at + 4;
    uint32_t end = (uint32_t)at[3];
    assert_true(end > box && end <= set->ranges[2]);
    for (int k = 0; k < 3 && parent; ++k)
        assert_true(fabsf(at[k] - parent[k]) + size[k] <= parent[4 + k] * 1.001f + 1e-5f);
    if (size[3] >= 0) {
        assert_int_equal(end, box + 1);
        assert_int_equal((uint32_t)size[3], *next_segment);
        for (int n = 0; n < 8 && *next_segment < set->ranges[1]; ++n, ++*next_segment) {
            const float *s = texel(tr->edge_textures[0], set->ranges[0] + 2 * *next_segment);
            for (int k = 0; k < 3; ++k) {
                assert_true(fabsf(s[k] - at[k]) <= size[k]);
                assert_true(fabsf(s[k] + s[4 + k] - at[k]) <= size[k]);
            }
        }
        return end;
    }
    uint32_t child = box + 1, children = 0;
    for (; child < end; ++children)
        child = check_box(tr, set, child, at, next_segment);
    assert_int_equal(child, end);
    assert_true(children >= 2 && children <= 8);
    return end;
}

static void test_boxes(void **state) {
    static const size_t counts[] = {1, 7, 8, 9, 64, 65, 511, 512, 513, 600, 2999, 19999};
    (void)state;
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; ++i) {
        tr_edge_set set;
        uint32_t segments = 0;
        tr_context *tr = open_context("3.3 Mock", 16384);
        tr_edges edges = some_edges(counts[i], false);
        assert_int_equal(tr_set_edges(tr, &edges, 1, &set), TR_OK);
        assert_int_equal(check_box(tr, &set, 0, NULL, &segments), set.ranges[2]);
        assert_int_equal(segments, counts[i]);
        close_context(tr);
    }
}

/* A change: no allocation, no texture made, a fixed number of calls, and the bytes of the arrays alone. */
static void test_steady_changes(void **state) {
    tr_edge_set set;
    (void)state;
    tr_context *tr = open_context("3.3 Mock", 16384);
    tr_edges edges = some_edges(15000, true);
    assert_int_equal(tr_set_edges(tr, &edges, 1, &set), TR_OK);
    assert_int_equal(driver.made, 2);
    for (size_t count = 15000; count < 15400; count += 40) {
        int calls = driver.calls, held = blocks;
        size_t bytes = driver.bytes;
        edges = some_edges(count, true);
        assert_int_equal(tr_set_edges(tr, &edges, 1, &set), TR_OK);
        assert_int_equal(driver.made, 2);
        assert_int_equal(blocks, held);
        assert_int_equal(driver.bytes - bytes, 32 * count + 4 * (TRIANGLES + 1 + (size_t)offsets[TRIANGLES]));
        /* 22 for the state around, 3 to bind; uploads: 1024 texels of segments at a time, 3 or fewer a list. */
        assert_true(driver.calls - calls <= 25 + (int)(2 * count / 1024 + 1) + 6);
        expect_host_state();
    }
    uint64_t most = tr_get_info(tr).bytes;
    edges = some_edges(10, false);
    assert_int_equal(tr_set_edges(tr, &edges, 1, &set), TR_OK); /* far fewer: the room is given back */
    assert_true(tr_get_info(tr).bytes < most / 2);
    assert_int_equal(driver.live, 1); /* no lists, no texture of lists */
    assert_int_equal(tr_set_edges(tr, NULL, 0, NULL), TR_OK);
    assert_int_equal(driver.live, 0);
    assert_int_equal(tr_get_info(tr).bytes, 0);
    close_context(tr);
}

static void expect_refused(tr_context *tr, const tr_edges *edges, tr_result result, const char *said) {
    tr_edge_set set;
    int calls = driver.calls, live = driver.live;
    driver.text[0] = 0;
    assert_int_equal(tr_set_edges(tr, edges, 1, &set), result);
    assert_int_equal(driver.calls, calls);
    assert_int_equal(driver.live, live);
    if (!strstr(driver.text, said))
        fail_msg("said \"%s\", not of \"%s\"", driver.text, said);
}

static void test_bad_arrays(void **state) {
    tr_edge_set set;
    (void)state;
    tr_context *tr = open_context("3.3 Mock", 16384);
    const tr_edges good = some_edges(100, true);
    tr_edges edges = good;
    assert_int_equal(tr_set_edges(NULL, &edges, 1, &set), TR_INVALID_ARGUMENT);
    assert_int_equal(tr_set_edges(tr, NULL, 1, &set), TR_INVALID_ARGUMENT);
    assert_int_equal(tr_set_edges(tr, &edges, 1, NULL), TR_INVALID_ARGUMENT);
    edges.positions = NULL;
    expect_refused(tr, &edges, TR_INVALID_ARGUMENT, "array is missing");
    edges = good;
    edges.candidates = NULL;
    expect_refused(tr, &edges, TR_INVALID_ARGUMENT, "array is missing");
    edges = good;
    edges.order = order;
    expect_refused(tr, &edges, TR_INVALID_ARGUMENT, "both order and offsets");
    edges = good;
    edges.position_stride = 10;
    expect_refused(tr, &edges, TR_INVALID_ARGUMENT, "stride");
    edges.position_stride = 14;
    expect_refused(tr, &edges, TR_INVALID_ARGUMENT, "stride");
    edges = good;
    edges.end_stride = 4;
    expect_refused(tr, &edges, TR_INVALID_ARGUMENT, "stride");
    edges = good;
    edges.position_count = 100; /* the last edge ends at 100 */
    expect_refused(tr, &edges, TR_INVALID_ARGUMENT, "position_count");
    edges = good;
    edges.model[4] = NAN;
    expect_refused(tr, &edges, TR_INVALID_ARGUMENT, "model");
    edges = good;
    candidates[3] = 100;
    expect_refused(tr, &edges, TR_INVALID_ARGUMENT, "candidates");
    edges = some_edges(100, true);
    offsets[5] = 2;
    expect_refused(tr, &edges, TR_INVALID_ARGUMENT, "offsets");
    edges = some_edges(100, true);
    assert_int_equal(tr_set_edges(tr, &edges, 1, &set), TR_OK);
    /* No edges at all, and points that are not finite, are no errors. */
    edges = some_edges(0, true);
    offsets[TRIANGLES] = 0;
    for (int i = 0; i < TRIANGLES; ++i)
        offsets[i] = 0;
    assert_int_equal(tr_set_edges(tr, &edges, 1, &set), TR_OK);
    assert_int_equal(set.ranges[1], 0);
    edges = some_edges(20, false);
    points[3][1] = NAN;
    points[7][0] = INFINITY;
    assert_int_equal(tr_set_edges(tr, &edges, 1, &set), TR_OK);
    for (size_t i = 0; i < 4 * (2 * (size_t)(set.ranges[1] + set.ranges[2])); ++i)
        assert_true(isfinite(texel(tr->edge_textures[0], set.ranges[0])[i]));
    close_context(tr);
}

/* More than the context's textures hold is refused, and what was there stays. */
static void test_limits(void **state) {
    enum { MANY = 1100000 };
    tr_edge_set set;
    (void)state;
    tr_context *tr = open_context("OpenGL ES 3.0 Mock", 2048); /* the least that ES 3.0 has: 2^21 texels */
    tr_edges edges = some_edges(100, true);
    assert_int_equal(tr_set_edges(tr, &edges, 1, &set), TR_OK);
    uint32_t *many = calloc(2 * MANY, sizeof *many);
    assert_non_null(many);
    edges.ends = many;
    edges.edge_count = MANY;
    expect_refused(tr, &edges, TR_TOO_LARGE, "edges");
    edges = some_edges(100, true);
    edges.offsets = many;
    edges.triangle_count = 2 * MANY - 1;
    expect_refused(tr, &edges, TR_TOO_LARGE, "candidates");
    edges.offsets = NULL;
    edges.candidates = NULL;
    edges.ends = many;
    edges.edge_count = 1024 * 1024 * 7 / 8 - 8; /* with its boxes just below */
    assert_int_equal(tr_set_edges(tr, &edges, 1, &set), TR_OK);
    assert_true(driver.textures[tr->edge_textures[0]].height <= 2048);
    free(many);
    close_context(tr);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_arrays_hold_what_was_given),
        cmocka_unit_test(test_boxes),
        cmocka_unit_test(test_steady_changes),
        cmocka_unit_test(test_bad_arrays),
        cmocka_unit_test(test_limits),
    };
    return cmocka_run_group_tests_name("mock_alpha", tests, NULL, NULL);
}

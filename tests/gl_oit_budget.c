/* gl_oit_budget.c: the stores of oit_buffers.h that keep the k nearest fragments of a pixel, on a real driver: what is
 * kept against a brute-force choice from all fragments, what is lost against counts and sums of the CPU, pictures against
 * a reference in double. */
#include "oit_setting.h"

/* ---- what the buffers hold ---- */

/* All records of each pixel, sorted by their words. */
typedef struct runs {
    size_t pixels, words;
    uint32_t *starts, *counts, *data; /* records: words each */
    uint32_t *pixel_words;            /* the pixel buffer as it is */
} runs;

static size_t sorted_words;

static int compare_records(const void *a, const void *b) {
    const uint32_t *x = a, *y = b;
    for (size_t i = 0; i < sorted_words; ++i)
        if (x[i] != y[i])
            return x[i] < y[i] ? -1 : 1;
    return 0;
}

static uint32_t *read_buffer(GLuint name, size_t bytes) {
    uint32_t *words = calloc(1, bytes + 4);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_COPY_READ_BUFFER, name);
    const void *mapped = glMapBufferRange(GL_COPY_READ_BUFFER, 0, (GLsizeiptr)bytes, GL_MAP_READ_BIT);
    assert_non_null(mapped);
    memcpy(words, mapped, bytes);
    glUnmapBuffer(GL_COPY_READ_BUFFER);
    return words;
}

static runs read_runs(const oit_setting *t) {
    runs r = {.pixels = (size_t)t->width * (size_t)t->height, .words = (size_t)oit_get_info(t->oit).fragment_bytes / 4};
    r.pixel_words = read_buffer(t->oit->buffers[OIT_I_PIXELS], (size_t)t->oit->sizes[OIT_I_PIXELS]);
    uint32_t *all = read_buffer(t->oit->buffers[OIT_I_FRAGMENTS], (size_t)t->oit->sizes[OIT_I_FRAGMENTS]);
    r.starts = calloc(r.pixels + 1, sizeof *r.starts);
    r.counts = calloc(r.pixels, sizeof *r.counts);
    for (size_t p = 0; p < r.pixels; ++p) {
        const uint32_t *at = r.pixel_words + 16 + 2 * p;
        r.starts[p] = at[0] + (uint32_t)((int32_t)at[1] > 0 ? (int32_t)at[1] : 0);
        r.counts[p] = at[2] - r.starts[p];
    }
    r.data = all;
    sorted_words = r.words;
    for (size_t p = 0; p < r.pixels; ++p)
        qsort(all + r.starts[p] * r.words, r.counts[p], r.words * sizeof *all, compare_records);
    return r;
}

static void free_runs(runs *r) {
    free(r->pixel_words);
    free(r->starts);
    free(r->counts);
    free(r->data);
}

static const uint32_t *record(const runs *r, size_t p, size_t i) {
    return r->data + (r->starts[p] + i) * r->words;
}

static float as_float(uint32_t bits) {
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* ---- brute force ---- */

/* Where fragments stand that are to be chosen: by all of the depth, or by 16 bits of it and the part. */
static uint32_t key_of(const uint32_t *record, int bits) {
    if (bits == 32)
        return record[0];
    return (uint32_t)(as_float(record[0]) * 65534.0f) << 16 | (record[1] & 0xffffu);
}

typedef struct choice {
    uint32_t kept;
    double tail[4];
    unsigned char is_kept[4096]; /* of the sorted records */
} choice;

/* The k nearest of n; of those that tie for the last places, none. The rest adds up: colour by optical depth, and that. */
static void choose(const runs *all, size_t p, uint32_t k, int bits, bool has_part, choice *out) {
    static uint32_t keys[4096], sorted[4096];
    uint32_t n = all->counts[p];
    size_t color = has_part ? 2 : 1; /* floats */
    memset(out, 0, sizeof *out);
    assert_true(n <= 4096);
    for (uint32_t i = 0; i < n; ++i)
        keys[i] = sorted[i] = key_of(record(all, p, i), bits);
    sorted_words = 1;
    qsort(sorted, n, sizeof *sorted, compare_records);
    for (uint32_t i = 0; i < n; ++i) {
        const uint32_t *at = record(all, p, i) + color;
        double alpha = (double)as_float(at[3]), depth = fmin(-log(1 - fmin(alpha, 0.999999)), 11);
        out->is_kept[i] = n <= k || keys[i] < sorted[k];
        out->kept += out->is_kept[i];
        for (int c = 0; c < 4 && !out->is_kept[i]; ++c)
            out->tail[c] += depth * (c < 3 ? (double)as_float(at[c]) : 1);
    }
}

/* shaders/oit_frame_block.glsl: where the words of the stores that keep the k nearest lie: six words for the tail,
 * limits, k + 1 keys, k buckets. */
static size_t first_word(const runs *r) {
    return OIT_I_HEADER_WORDS + 2 + 2 * r->pixels + oit_i_blocks((int64_t)r->pixels);
}

static double tail_of(const runs *r, size_t p, int c) {
    const uint32_t *at = r->pixel_words + first_word(r) + 6 * p; /* in units of 2^-26 */
    double low = at[c], carries = at[4 + c / 2] >> 16 * (c % 2) & 0xffffu;
    return (low + 4294967296.0 * carries) / 67108864.0;
}

/* ---- drawing ---- */

static const oit_desc exact = {.color = OIT_COLOR_FLOAT};
static const oit_desc budget = {.store = OIT_STORE_BUDGET, .color = OIT_COLOR_FLOAT};
static const oit_desc budget_part = {.store = OIT_STORE_BUDGET, .color = OIT_COLOR_FLOAT, .fields = OIT_FIELD_PART};
static const oit_desc bucketed = {.store = OIT_STORE_BUCKETED, .color = OIT_COLOR_FLOAT, .fields = OIT_FIELD_PART};
static const oit_desc bucketed_16 = {
    .store = OIT_STORE_BUCKETED, .color = OIT_COLOR_FLOAT, .fields = OIT_FIELD_PART, .bucket_depth_bits = 16};

static void open_setting(oit_setting *t, bool es, int width, int height) {
    oit_setting_open(t, es, width, height, 0, es ? GL_RGBA16F : GL_RGBA32F, exact);
}

/* Another store on the same target. */
static void use(oit_setting *t, oit_desc desc) {
    oit_result result;
    oit_destroy(t->oit);
    desc.get_proc = oit_scene_get_proc;
    desc.log_fn = oit_setting_log;
    desc.log_user = t;
    desc.max_gl_version = t->h.context.es ? 310 : 430;
    t->oit = oit_create(&desc, &result);
    if (!t->oit)
        fail_msg("oit_create: %s", oit_result_string(result));
}

static bool is_in_use(const oit_setting *t, const oit_desc *desc) {
    const oit_desc *d = &t->oit->desc;
    return d->store == desc->store && d->fields == desc->fields && d->color == desc->color && d->fit == desc->fit &&
           d->host_words == desc->host_words && d->reversed_z == desc->reversed_z &&
           d->bucket_depth_bits == desc->bucket_depth_bits;
}

/* The store with k layers, by its budget; which may change from frame to frame, as the size of the target may. */
static void use_layers(oit_setting *t, oit_desc desc, int k) {
    int64_t each = 24 + (desc.store == OIT_STORE_BUCKETED ? 12 : 4); /* with a part or without */
    if (!is_in_use(t, &desc))
        use(t, desc);
    each = desc.host_words ? oit_get_info(t->oit).fragment_bytes + 4 : each;
    t->oit->desc.budget_bytes = (int64_t)k * t->width * t->height * each + 1;
}

static float *draw(oit_setting *t, oit_scene *s, const size_t *order) {
    oit_frame frame = oit_scene_frame(s, t->framebuffer);
    oit_setting_clear(t, s);
    oit_scene_render(s, t->oit, &frame, order);
    return oit_setting_read(t, t->framebuffer);
}

static oit_report report_of(oit_setting *t) {
    oit_report report = {0};
    assert_int_equal(oit_get_report(t->oit, &report), OIT_OK);
    return report;
}

/* Sheets that intersect; that coincide in depth, in part, in all; each of five parts again and again. */
static void mixed_sheets(oit_scene *s, int width, int height, int layers) {
    uint32_t state = 3;
    const double depth[4] = {0.25, 0.25, 0.25, 0.25};
    oit_scene_init(s, width, height);
    oit_scene_sheets(s, layers, 0.1, true);
    for (size_t i = 0; i < (size_t)layers; ++i)
        s->objects[i].part = (uint32_t)(i % 5) * 65537u;
    for (int i = 0; i < layers; ++i) {
        const double color[4] = {oit_scene_random(&state), oit_scene_random(&state), 0.5, 0.3};
        size_t at = oit_scene_quad(s, i * 0.05 - 1, -1, i % 3 ? 1 : 0.1, 1, depth, color);
        s->objects[at].part = i % 2 ? 7 : (uint32_t)i;
        if (i % 5 == 4) /* the one before once more */
            memcpy(s->truths[at].color, s->truths[at - 1].color, sizeof s->truths[at].color);
    }
}

static void shuffle(size_t *order, size_t count, uint32_t *state) {
    for (size_t i = 0; i < count; ++i)
        order[i] = i;
    for (size_t i = count - 1; i > 0; --i) {
        size_t other = (size_t)(oit_scene_random(state) * (double)(i + 1)), kept = order[i];
        order[i] = order[other];
        order[other] = kept;
    }
}

/* ---- what is kept ---- */

typedef struct totals {
    uint32_t needed, deepest, lost, lost_pixels;
} totals;

/* One pixel of what a store holds against what the CPU chooses of all. */
static void check_pixel(const runs *all, const runs *held, size_t p, uint32_t k, const oit_desc *desc, totals *sum) {
    static choice c;
    uint32_t n = all->counts[p], at = 0;
    int bits = desc->bucket_depth_bits == 16 ? 16 : 32;
    choose(all, p, k, bits, (desc->fields & OIT_FIELD_PART) != 0, &c);
    if (held->counts[p] != c.kept)
        fail_msg("pixel %zu: %u of %u kept, should be %u", p, held->counts[p], n, c.kept);
    for (uint32_t i = 0; i < n; ++i)
        if (c.is_kept[i] && memcmp(record(all, p, i), record(held, p, at++), all->words * 4) != 0)
            fail_msg("pixel %zu: fragment %u of those kept is another one", p, at - 1);
    /* The logarithm of GLSL is good to a few ulp, and each fragment is rounded to 2^-26. */
    for (int i = 0; i < 4; ++i)
        if (!(fabs(tail_of(held, p, i) - c.tail[i]) <= 4e-6 * c.tail[i] + 1e-7 * n))
            fail_msg("pixel %zu: tail %d is %.9g, should be %.9g", p, i, tail_of(held, p, i), c.tail[i]);
    sum->needed += n;
    sum->deepest = n > sum->deepest ? n : sum->deepest;
    sum->lost += n - c.kept;
    sum->lost_pixels += n > c.kept;
}

/* all, whole: what OIT_STORE_EXACT has, and its picture. */
static void check_layers(oit_setting *t, oit_scene *s, oit_desc desc, int k, const runs *all, const float *whole) {
    totals sum = {0};
    use_layers(t, desc, k);
    float *picture = draw(t, s, NULL);
    oit_report report = report_of(t);
    runs held = read_runs(t);
    assert_int_equal(report.layers, k);
    assert_int_equal(report.capacity, (size_t)k * all->pixels);
    for (size_t p = 0; p < all->pixels; ++p) {
        check_pixel(all, &held, p, (uint32_t)k, &desc, &sum);
        if (all->counts[p] <= (uint32_t)k && memcmp(whole + 4 * p, picture + 4 * p, 16) != 0)
            fail_msg("pixel %zu of %u layers is not that of the exact store", p, all->counts[p]);
    }
    assert_int_equal(report.needed, sum.needed);
    assert_int_equal(report.deepest, sum.deepest);
    assert_int_equal(report.lost, sum.lost);
    assert_int_equal(report.lost_pixels, sum.lost_pixels);
    assert_int_equal(report.extra, 0);
    printf("    k %3d of %3u: %6u of %6u lost, in %5u of %5zu pixels\n", k, sum.deepest, sum.lost, sum.needed,
           sum.lost_pixels, all->pixels);
    free(picture);
    free_runs(&held);
}

/* Capacities from none to 200 % of what the deepest pixel needs. */
static void check_capacities(oit_setting *t, oit_scene *s, oit_desc desc) {
    static const int percents[] = {0, 10, 25, 50, 75, 90, 100, 150, 200};
    oit_desc exact_desc = desc;
    exact_desc.store = OIT_STORE_EXACT;
    use(t, exact_desc);
    float *whole = draw(t, s, NULL);
    int deepest = (int)report_of(t).deepest;
    runs all = read_runs(t);
    for (size_t i = 0; i < sizeof percents / sizeof percents[0]; ++i)
        check_layers(t, s, desc, deepest * percents[i] / 100, &all, whole);
    free(whole);
    free_runs(&all);
}

static void check_scenes(bool es, oit_desc desc) {
    oit_setting t;
    oit_scene *s = malloc(sizeof *s);
    open_setting(&t, es, 40, 24);
    mixed_sheets(s, 40, 24, 20);
    check_capacities(&t, s, desc);
    oit_scene_drop(s);
    oit_scene_init(s, 40, 24);
    oit_scene_random_balls(s, 8, 16, 0.3);
    s->truths[2].transparent = false;
    check_capacities(&t, s, desc);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

static void test_budget_keeps_the_nearest(void **state) {
    (void)state;
    check_scenes(false, budget);
    check_scenes(true, budget_part);
}

static void test_bucketed_keeps_the_nearest(void **state) {
    (void)state;
    check_scenes(false, bucketed);
    check_scenes(true, bucketed);
}

static void test_bucketed_keeps_the_nearest_by_16_bits(void **state) {
    (void)state;
    check_scenes(false, bucketed_16);
    check_scenes(true, bucketed_16);
}

static void test_500_layers(void **state) {
    static const int ks[] = {1, 7, 33, 64, 65, 200, 499, 500, 600};
    (void)state;
    oit_setting t;
    oit_scene *s = malloc(sizeof *s);
    open_setting(&t, false, 8, 6);
    oit_scene_init(s, 8, 6);
    oit_scene_sheets(s, 500, 0.02, false);
    float *whole = draw(&t, s, NULL);
    runs all = read_runs(&t);
    for (size_t i = 0; i < sizeof ks / sizeof ks[0]; ++i)
        check_layers(&t, s, budget, ks[i], &all, whole);
    free(whole);
    free_runs(&all);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* ---- the same bits ---- */

/* Six orders and the same again, at every capacity: picture, report and kept records. */
static void check_orders(oit_desc desc) {
    static const int ks[] = {0, 3, 10, 20, 36, 80};
    oit_setting t;
    oit_scene *s = malloc(sizeof *s);
    size_t order[OIT_SCENE_MAX];
    uint32_t state = 3;
    open_setting(&t, false, 40, 24);
    mixed_sheets(s, 40, 24, 20);
    for (size_t i = 0; i < sizeof ks / sizeof ks[0]; ++i) {
        use_layers(&t, desc, ks[i]);
        float *first = draw(&t, s, NULL);
        oit_report report = report_of(&t);
        for (int run = 0; run < 7; ++run) {
            shuffle(order, s->count, &state);
            float *next = draw(&t, s, run ? order : NULL);
            oit_report again = report_of(&t);
            assert_int_equal(again.frame, report.frame + (uint64_t)run + 1);
            again.frame = report.frame;
            assert_memory_equal(&again, &report, sizeof report);
            if (memcmp(first, next, 16 * 40 * 24) != 0)
                fail_msg("k %d: %s is another picture", ks[i], run ? "another order" : "the same order");
            free(next);
        }
        free(first);
    }
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

static void test_draw_order_changes_nothing(void **state) {
    oit_desc all = budget;
    (void)state;
    all.fields = OIT_FIELD_ALL;
    all.host_words = 3;
    all.fit = OIT_FIT_WAIT;
    check_orders(budget);
    check_orders(all);
    check_orders(bucketed);
    check_orders(bucketed_16);
}

/* ---- the double reference ---- */

/* What a pixel of these layers, nearest first, should be: the k nearest over the others as one layer of their mean colour
 * and all of their optical depth, over what is behind. Layers that tie across the k-th place are not kept. */
static void expect_color(const oit_truth_layer *layers, size_t count, size_t k, double color[3]) {
    double sum[3] = {0}, depth = 0;
    size_t kept = count <= k ? count : k;
    while (kept < count && kept > 0 && fabs(layers[kept - 1].depth - layers[k].depth) <= layers[k].slack)
        --kept;
    for (size_t i = kept; i < count; ++i) {
        double thick = fmin(-log(1 - fmin(layers[i].color[3], 0.999999)), 11);
        depth += thick;
        for (int c = 0; c < 3; ++c)
            sum[c] += thick * layers[i].color[c];
    }
    for (int c = 0; c < 3 && depth > 0; ++c)
        color[c] = sum[c] / depth * (1 - exp(-depth)) + exp(-depth) * color[c];
    oit_truth_blend(layers, kept, color);
}

/* By a ray through each pixel's centre. truth says which pixels lie too near to an edge. */
static double worst_error(const oit_scene *s, size_t k, const oit_truth *truth, const float *picture) {
    static oit_truth_layer layers[4096];
    ref_i_world world = {0};
    double worst = 0;
    world.scene = &s->scene;
    assert_true(ref_i_make_world(&world));
    for (int i = 0; i < s->scene.width * s->scene.height; ++i) {
        double color[3];
        size_t count;
        if (truth[i].left_out)
            continue;
        const ref_i_hit *solid =
            oit_truth_cast(&world, s, i % s->scene.width + 0.5, i / s->scene.width + 0.5, layers, &count);
        for (int c = 0; c < 3; ++c)
            color[c] = solid ? s->truths[world.triangles[solid->triangle].object].color[c] : s->scene.background[c];
        expect_color(layers, count, k, color);
        for (int c = 0; c < 3; ++c)
            worst = fmax(worst, fabs(color[c] - (double)picture[4 * i + c]));
    }
    ref_i_free_world(&world);
    return worst;
}

/* k 0 comes first: the store without a run. */
static void check_reference(oit_setting *t, oit_scene *s, oit_desc desc, const char *name, double tolerance) {
    static const int ks[] = {0, 1, 2, 5, 8, 12, 40};
    oit_truth *truth = malloc((size_t)t->width * (size_t)t->height * sizeof *truth);
    double left_out = oit_truth_render(s, truth);
    assert_true(left_out <= 0.1);
    for (size_t i = 0; i < sizeof ks / sizeof ks[0]; ++i) {
        use_layers(t, desc, ks[i]);
        float *picture = draw(t, s, NULL);
        double worst = worst_error(s, (size_t)ks[i], truth, picture);
        printf("    %-24s k %2d: max %.3g (allowed %.3g), %.1f %% left out\n", name, ks[i], worst, tolerance,
               100 * left_out);
        assert_true(worst <= tolerance);
        free(picture);
    }
    free(truth);
}

static void test_pictures_match_the_reference(void **state) {
    (void)state;
    oit_setting t;
    oit_scene *s = malloc(sizeof *s);
    open_setting(&t, false, 128, 128);
    oit_scene_init(s, 128, 128);
    oit_scene_sheets(s, 30, 0.15, false);
    check_reference(&t, s, budget, "sheets", 1e-5);
    check_reference(&t, s, bucketed, "sheets, bucketed", 1e-5);
    check_reference(&t, s, bucketed_16, "sheets, by 16 bits", 1e-5);
    oit_scene_drop(s);
    oit_scene_init(s, 128, 128);
    oit_scene_random_balls(s, 6, 16, 0.4);
    s->truths[2].transparent = false;
    check_reference(&t, s, budget, "balls, one opaque", 1e-5);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* Near is 1, far is 0: all bits of the depth the other way round, and 16 of them. */
static void test_reversed_depth(void **state) {
    (void)state;
    oit_desc descs[2] = {budget, bucketed_16};
    oit_setting t;
    oit_scene *s = malloc(sizeof *s);
    open_setting(&t, false, 128, 128);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    oit_scene_init(s, 128, 128);
    oit_scene_random_balls(s, 6, 16, 0.4);
    s->truths[2].transparent = false;
    s->reversed = true;
    for (int i = 0; i < 2; ++i) {
        descs[i].reversed_z = 1;
        /* 16 bits tie where spheres of these depths lie nearer than 1/65534: not at the pixels that count here. */
        check_reference(&t, s, descs[i], i ? "reversed, by 16 bits" : "reversed", 1e-5);
    }
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* ---- hard cases ---- */

/* Layers one unit in the last place apart: the limit falls between two of them. 16 bits cannot tell them apart, so none
 * is kept there. */
static void test_one_ulp_apart(void **state) {
    enum { LAYERS = 12 };
    (void)state;
    oit_setting t;
    oit_scene *s = malloc(sizeof *s);
    double depth[LAYERS];
    open_setting(&t, false, 4, 4);
    oit_scene_init(s, 4, 4);
    float at = 0.75f;
    for (int i = 0; i < LAYERS; ++i, at = nextafterf(at, 1)) { /* window depth d from 2 d - 1, exact here */
        const double z = 2 * (double)at - 1, zs[4] = {z, z, z, z}, color[4] = {i / 12.0, 1 - i / 12.0, 0.5, 0.4};
        depth[i] = (double)at;
        oit_scene_quad(s, -1, -1, 1, 1, zs, color);
    }
    for (int k = 0; k <= LAYERS; ++k)
        for (int bits = 16; bits <= 32; bits += 16) {
            static const size_t backward[LAYERS] = {11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0};
            oit_truth_layer layers[LAYERS];
            double color[3] = {1, 1, 1};
            oit_desc desc = bits == 16 ? bucketed_16 : budget;
            desc.fields = OIT_FIELD_PART;
            for (int i = 0; i < LAYERS; ++i) {
                s->objects[i].part = 9;
                memset(&layers[i], 0, sizeof layers[i]);
                layers[i].depth = bits == 16 && k < LAYERS ? 0.75 : depth[i];
                memcpy(layers[i].color, s->truths[i].color, 3 * sizeof(double));
                layers[i].color[3] = s->truths[i].alpha;
            }
            expect_color(layers, LAYERS, (size_t)k, color);
            use_layers(&t, desc, k);
            for (int run = 0; run < 2; ++run) {
                float *picture = draw(&t, s, run ? backward : NULL);
                oit_report report = report_of(&t);
                assert_int_equal(report.lost, 16 * (bits == 16 && k < LAYERS ? LAYERS : LAYERS - k));
                for (int c = 0; c < 3; ++c)
                    assert_true(fabs((double)picture[c] - color[c]) <= 1e-5);
                free(picture);
            }
        }
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* What it costs to choose by 16 bits of the depth (Murray 2016, section 4.2): nothing where no more than the k nearest share
 * a step of 1/65534; else the part chooses among them, and of one part none is kept. Against the picture of 32 bits. */
static void test_what_16_bits_cost(void **state) {
    enum { LAYERS = 64, K = 8 };
    (void)state;
    oit_setting t;
    oit_scene *s = malloc(sizeof *s);
    open_setting(&t, false, 4, 4);
    for (int power = 15; power <= 21; ++power)
        for (int parts = 0; parts < 2; ++parts) {
            uint32_t seed = 5;
            float *pictures[2];
            oit_report reports[2];
            double error = 0;
            oit_scene_init(s, 4, 4);
            for (int i = 0; i < LAYERS; ++i) {
                const double z = ldexp(i, 1 - power), zs[4] = {z, z, z, z}; /* window depth 0.5 + i 2^-power */
                double color[4] = {0, 0, 0, 0.3};
                for (int c = 0; c < 3; ++c)
                    color[c] = oit_scene_random(&seed);
                oit_scene_quad(s, -1, -1, 1, 1, zs, color);
                s->objects[i].part = parts ? (uint32_t)(i * 37 % LAYERS) : 1;
            }
            for (int i = 0; i < 2; ++i) {
                use_layers(&t, i ? bucketed_16 : bucketed, K);
                pictures[i] = draw(&t, s, NULL);
                reports[i] = report_of(&t);
            }
            for (int i = 0; i < 4 * 16; ++i)
                error = fmax(error, fabs((double)pictures[0][i] - (double)pictures[1][i]));
            printf("    2^-%d apart, %s: %2u and %2u of %d kept, error %.3g\n", power,
                   parts ? "of 64 parts" : "of one part", LAYERS - reports[0].lost / 16, LAYERS - reports[1].lost / 16,
                   LAYERS, error);
            assert_int_equal(reports[0].lost, 16 * (LAYERS - K));
            assert_true(power <= 19 ? error == 0 && reports[1].lost == reports[0].lost : true); /* 8 a step */
            assert_true(power == 21 ? error > 0.01 : true);
            assert_true(power == 21 && !parts ? reports[1].lost == 16 * LAYERS : true);
            free(pictures[0]);
            free(pictures[1]);
            oit_scene_drop(s);
        }
    oit_setting_close(&t);
    free(s);
}

/* Sheets alike in every word before and behind others: all are kept, or none. */
static void test_identical_layers(void **state) {
    (void)state;
    oit_setting t;
    oit_scene *s = malloc(sizeof *s);
    open_setting(&t, false, 4, 4);
    oit_scene_init(s, 4, 4);
    for (int i = 0; i < 9; ++i) {
        const double z = i == 0 ? -0.5 : i == 8 ? 0.5 : 0, zs[4] = {z, z, z, z};
        const double color[4] = {i == 0, i == 8, 0.25, 0.3};
        oit_scene_quad(s, -1, -1, 1, 1, zs, color);
        s->objects[i].part = 3;
    }
    for (int store = 0; store < 3; ++store)
        for (int k = 0; k <= 10; ++k) {
            uint32_t kept = k >= 9 ? 9 : k >= 8 ? 8 : k >= 1 ? 1 : 0;
            use_layers(&t, store == 0 ? budget : store == 1 ? bucketed : bucketed_16, k);
            free(draw(&t, s, NULL));
            assert_int_equal(report_of(&t).lost, 16 * (9 - kept));
            assert_int_equal(report_of(&t).lost_pixels, kept < 9 ? 16 : 0);
        }
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* 1,000 layers of alpha 10^-4 of which nearly all are in the tail; alpha 0 and 1 kept and not; white on white. */
static void test_alpha_extremes(void **state) {
    (void)state;
    oit_setting t;
    oit_scene *s = malloc(sizeof *s);
    open_setting(&t, false, 8, 8);
    oit_scene_init(s, 8, 8);
    oit_scene_sheets(s, 1000, 1e-4, false);
    memset(s->scene.background, 0, sizeof s->scene.background);
    /* 1 - 1e-4 in a float is off by up to 3e-8, and each layer of the tail is cut off at 2^-26. */
    check_reference(&t, s, budget, "1000 layers of 1e-4", 2e-5);
    oit_scene_drop(s);
    oit_scene_init(s, 8, 8);
    oit_scene_sheets(s, 24, 0.3, false);
    for (size_t i = 0; i < s->count; ++i)
        s->truths[i].alpha = i % 4 == 1 ? 0 : i % 9 == 7 ? 1 : 0.3;
    check_reference(&t, s, budget, "alpha 0 and 1", 1e-5);
    for (size_t i = 0; i < s->count; ++i)
        for (int c = 0; c < 3; ++c)
            s->truths[i].color[c] = s->scene.background[c] = 1;
    check_reference(&t, s, budget, "weights sum to one", 2e-6);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* Sums of the tail beyond 32 bits: opaque layers, each an optical depth of 11. */
static void test_tail_carries(void **state) {
    (void)state;
    oit_setting t;
    oit_scene *s = malloc(sizeof *s);
    open_setting(&t, false, 4, 4);
    oit_scene_init(s, 4, 4);
    oit_scene_sheets(s, 300, 1, false);
    float *whole = draw(&t, s, NULL);
    runs all = read_runs(&t);
    check_layers(&t, s, budget, 0, &all, whole);
    runs held = read_runs(&t);
    for (size_t p = 0; p < held.pixels; ++p)
        assert_true(fabs(tail_of(&held, p, 3) - 3300) < 1e-3);
    free_runs(&held);
    check_layers(&t, s, budget, 7, &all, whole);
    free(whole);
    free_runs(&all);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* A viewport of nothing, of one pixel, and sizes that change: what k is follows. */
static void test_sizes(void **state) {
    static const int sizes[][2] = {{0, 0}, {1, 1}, {0, 9}, {40, 24}, {3, 5}, {40, 1}, {1, 1}};
    (void)state;
    oit_setting t;
    oit_scene *s = malloc(sizeof *s);
    oit_desc desc = budget;
    open_setting(&t, false, 40, 24);
    desc.budget_bytes = 40 * 24 * 28 * 3;
    use(&t, desc);
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; ++i) {
        int pixels = sizes[i][0] * sizes[i][1];
        oit_scene_init(s, sizes[i][0], sizes[i][1]);
        oit_scene_sheets(s, 12, 0.2, false);
        free(draw(&t, s, NULL));
        oit_report report = report_of(&t);
        uint32_t k = pixels ? 40 * 24 * 3 / (uint32_t)pixels : 0;
        if (pixels) {
            assert_int_equal(report.layers, k > 1024 ? 1024 : k);
            assert_int_equal(report.needed, 12 * pixels);
            assert_int_equal(report.lost, k < 12 ? (12 - k) * (uint32_t)pixels : 0);
        }
        oit_scene_drop(s);
    }
    desc.layers = 5; /* no more than that */
    use(&t, desc);
    oit_scene_init(s, 3, 5);
    oit_scene_sheets(s, 12, 0.2, false);
    free(draw(&t, s, NULL));
    assert_int_equal(report_of(&t).layers, 5);
    assert_int_equal(report_of(&t).lost, 7 * 15);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* Where a storage block holds only some rows, the picture comes in slabs and is the same. */
static void test_slabs_equal_the_whole(void **state) {
    (void)state;
    oit_desc descs[2] = {budget, bucketed};
    for (int store = 0; store < 2; ++store) {
        oit_scene *s = malloc(sizeof *s);
        oit_setting t;
        float *pictures[2];
        oit_report reports[2];
        open_setting(&t, false, 40, 36);
        oit_scene_init(s, 40, 36);
        oit_scene_random_balls(s, 8, 16, 0.3);
        for (int i = 0; i < 2; ++i) {
            descs[store].budget_bytes = 40 * 36 * 36 * 3;
            descs[store].max_block_bytes = i ? 16000 : 0;
            use(&t, descs[store]);
            pictures[i] = draw(&t, s, NULL);
            reports[i] = report_of(&t);
            assert_true(i ? reports[i].bands > 2 : reports[i].bands == 1);
        }
        assert_memory_equal(pictures[0], pictures[1], 16 * 40 * 36);
        assert_int_equal(reports[0].lost, reports[1].lost);
        assert_int_equal(reports[0].lost_pixels, reports[1].lost_pixels);
        assert_int_equal(reports[0].needed, reports[1].needed);
        assert_true(reports[0].lost > 0);
        free(pictures[0]);
        free(pictures[1]);
        oit_scene_drop(s);
        oit_setting_close(&t);
        free(s);
    }
}

/* The host draws more in the second geometry pass, or less: nothing is written outside of a run, and what has no place is
 * reported. */
static void test_passes_that_differ(void **state) {
    (void)state;
    oit_desc descs[2] = {budget, bucketed};
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    open_setting(&t, false, 16, 16);
    oit_scene_init(s, 16, 16);
    oit_scene_sheets(s, 6, 0.25, false);
    for (int store = 0; store < 2; ++store)
        for (int more = 0; more < 2; ++more) {
            oit_frame frame = oit_scene_frame(s, t.framebuffer);
            oit_pass pass;
            use_layers(&t, descs[store], 4);
            oit_setting_clear(&t, s);
            oit_scene_expect(oit_begin(t.oit, &frame), "oit_begin");
            while (oit_next_pass(t.oit, &pass)) {
                s->count = (pass.kind == OIT_PASS_FILL) == (more == 1) ? 6 : 3;
                oit_scene_draw(s, t.oit, &pass, NULL);
                s->count = 6;
            }
            oit_scene_expect(oit_compose(t.oit), "oit_compose");
            oit_scene_expect(oit_end(t.oit), "oit_end");
            runs held = read_runs(&t);
            /* Three known: whatever comes is kept, while there are places. Six known: of those that come, at depths 0, 5 and 4
             * of 0 ... 5, one is among the four nearest. */
            assert_int_equal(report_of(&t).extra, more ? 2 * 256 : 0);
            for (size_t p = 0; p < held.pixels; ++p)
                assert_int_equal(held.counts[p], more ? 4 : 1);
            free_runs(&held);
        }
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* ---- buckets ---- */

/* Murray 2016, section 4.1, on the CPU: parts in ascending order, each into slot part mod k or the next that is free. */
static void expect_table(const runs *held, size_t p, uint32_t k, uint32_t *parts, uint32_t *counts) {
    uint32_t n = held->counts[p], done = 0;
    memset(counts, 0, k * sizeof *counts);
    for (uint32_t least = 0; done < n; ++least) {
        uint32_t part = 0xffffffffu, count = 0;
        for (uint32_t i = 0; i < n; ++i) /* the next part */
            if (record(held, p, i)[1] >= least && record(held, p, i)[1] < part)
                part = record(held, p, i)[1];
        for (uint32_t i = 0; i < n; ++i)
            count += record(held, p, i)[1] == part;
        uint32_t slot = part % k;
        while (counts[slot] > 0)
            slot = (slot + 1) % k;
        parts[slot] = part;
        counts[slot] = count;
        done += count;
        least = part;
    }
}

/* The table, and the records of each bucket: those of its part, by all their words. */
static void check_buckets(const runs *held, const uint32_t *data, size_t p, uint32_t k) {
    const uint32_t *order = held->pixel_words + first_word(held) + 7 * held->pixels + p * (k + 1);
    const uint32_t *slots = held->pixel_words + first_word(held) + (8 + (size_t)k) * held->pixels + 2 * p * k;
    uint32_t parts[64], counts[64], next = 0;
    expect_table(held, p, k, parts, counts);
    sorted_words = held->words;
    for (uint32_t slot = 0; slot < k; ++slot) {
        if (counts[slot] == 0) {
            assert_int_equal(slots[2 * slot + 1], 0);
            continue;
        }
        assert_int_equal(slots[2 * slot], parts[slot]);
        assert_int_equal(slots[2 * slot + 1], 0x80000000u | counts[slot] << 16 | next);
        for (uint32_t i = 0, from = 0; i < counts[slot]; ++i, ++from) {
            while (record(held, p, from)[1] != parts[slot])
                ++from;
            assert_memory_equal(record(held, p, from), data + order[next + i] * held->words, held->words * 4);
        }
        next += counts[slot];
    }
    assert_int_equal(next, held->counts[p]);
}

static const char *const asker =
    "layout(local_size_x = 1) in;\n"
    "layout(std430, binding = 5) writeonly buffer answers { uvec4 answer[]; };\n"
    "void main() {\n"
    "    uint p = gl_WorkGroupID.x, part = gl_WorkGroupID.y * (gl_WorkGroupID.y < 5u ? 65537u : 1u), first, count;\n"
    "    bool found = oit_find_bucket(p, part, first, count) != 0u;\n"
    "    uint sum = 0u;\n"
    "    for (uint i = first; i < first + count; ++i) {\n"
    "        uint at = oit_bucket_record(p, i) * uint(OIT_VECTORS);\n"
    "        sum += OIT_WORD(at, OIT_AT_PART) == part ? oit_record_depth(at) : 1u;\n"
    "    }\n"
    "    answer[p * gl_NumWorkGroups.y + gl_WorkGroupID.y] = uvec4(found ? 1u : 0u, count, sum, part);\n"
    "}\n";

/* A shader that asks each pixel for each part, as operators do. */
static uint32_t *ask(oit_setting *t, uint32_t pixels, uint32_t parts) {
    oit_i_source source;
    GLuint program = glCreateProgram(), shader = glCreateShader(GL_COMPUTE_SHADER), answers;
    GLint ok = 0;
    oit_i_add_preamble(&source, t->oit->info.es, t->oit->preamble);
    oit_i_add_chunks(&source, oit_i_shader_oit_frame_block_glsl);
    oit_i_add_chunks(&source, oit_i_shader_oit_record_glsl);
    oit_i_add_chunks(&source, oit_i_shader_oit_buckets_glsl);
    oit_i_add(&source, asker);
    glShaderSource(shader, source.count, source.strings, NULL);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    assert_true(ok);
    glGenBuffers(1, &answers);
    glBindBuffer(GL_COPY_WRITE_BUFFER, answers);
    glBufferData(GL_COPY_WRITE_BUFFER, (GLsizeiptr)(16 * pixels * parts), NULL, GL_DYNAMIC_READ);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, t->oit->buffers[OIT_I_PIXELS]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, t->oit->buffers[OIT_I_FRAGMENTS]);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 5, answers);
    glBindBufferBase(GL_UNIFORM_BUFFER, 14, t->oit->buffers[OIT_I_UNIFORMS]);
    glUseProgram(program);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glDispatchCompute(pixels, parts, 1);
    uint32_t *out = read_buffer(answers, 16 * pixels * parts);
    glUseProgram(0);
    glDeleteBuffers(1, &answers);
    glDeleteShader(shader);
    glDeleteProgram(program);
    return out;
}

static void check_answers(const runs *held, const uint32_t *answers, uint32_t parts) {
    for (size_t p = 0; p < held->pixels; ++p)
        for (uint32_t j = 0; j < parts; ++j) {
            const uint32_t *answer = answers + 4 * (p * parts + j);
            uint32_t part = j < 5 ? j * 65537u : j, count = 0, sum = 0;
            for (uint32_t i = 0; i < held->counts[p]; ++i)
                if (record(held, p, i)[1] == part) {
                    ++count;
                    sum += record(held, p, i)[0];
                }
            assert_int_equal(answer[0], count > 0);
            assert_int_equal(answer[1], count);
            assert_int_equal(answer[2], sum);
            assert_int_equal(answer[3], part);
        }
}

/* Fewer slots than parts, as many, more: all that is kept is found by its part, and nothing else is. */
static void test_buckets(void **state) {
    static const int ks[] = {1, 3, 8, 20, 45};
    (void)state;
    oit_setting t;
    oit_scene *s = malloc(sizeof *s);
    for (int es = 0; es < 2; ++es) {
        open_setting(&t, es, 20, 12);
        mixed_sheets(s, 20, 12, 20);
        for (size_t i = 0; i < 2 * sizeof ks / sizeof ks[0]; ++i) {
            use_layers(&t, i % 2 ? bucketed_16 : bucketed, ks[i / 2]);
            free(draw(&t, s, NULL));
            runs held = read_runs(&t);
            uint32_t *data = read_buffer(t.oit->buffers[OIT_I_FRAGMENTS], (size_t)t.oit->sizes[OIT_I_FRAGMENTS]);
            uint32_t *answers = ask(&t, (uint32_t)held.pixels, 20);
            for (size_t p = 0; p < held.pixels; ++p)
                check_buckets(&held, data, p, (uint32_t)ks[i / 2]);
            check_answers(&held, answers, 20);
            free(answers);
            free(data);
            free_runs(&held);
        }
        oit_scene_drop(s);
        oit_setting_close(&t);
    }
    free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_budget_keeps_the_nearest),
        cmocka_unit_test(test_bucketed_keeps_the_nearest),
        cmocka_unit_test(test_bucketed_keeps_the_nearest_by_16_bits),
        cmocka_unit_test(test_500_layers),
        cmocka_unit_test(test_draw_order_changes_nothing),
        cmocka_unit_test(test_pictures_match_the_reference),
        cmocka_unit_test(test_reversed_depth),
        cmocka_unit_test(test_one_ulp_apart),
        cmocka_unit_test(test_what_16_bits_cost),
        cmocka_unit_test(test_identical_layers),
        cmocka_unit_test(test_alpha_extremes),
        cmocka_unit_test(test_tail_carries),
        cmocka_unit_test(test_sizes),
        cmocka_unit_test(test_slabs_equal_the_whole),
        cmocka_unit_test(test_passes_that_differ),
        cmocka_unit_test(test_buckets),
    };
    setvbuf(stdout, NULL, _IOLBF, 0);
    return cmocka_run_group_tests(tests, NULL, NULL);
}

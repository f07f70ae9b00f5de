/* accuracy_smart.h: rows of `make accuracy` for oit_buffers.h: its stores, and the operators of smart transparency.
 *
 * oit_*: whole frames; the error is against all hits of each pixel's ray, sorted and blended in double (oit_scene.h), pixels
 * nearer than half a pixel to an edge left out. The target is of floats, so that what packing costs is seen.
 * oit_depth_bits: the same, with a near plane so near that neighbouring layers have the same 16 bits of depth.
 *
 * smart_*: milliseconds are those of the operator that the setting is of: LINK for smart_links and smart_limit, SMART for
 * the others; sorting, the law and composition are left out. The error is of the picture, all pixels, against
 * reference_smart.h in double on the same fragments, read back. What it is asked for:
 *  - smart_iterations: 200 iterations, whatever the row has. Lambdas are the defaults.
 *  - smart_jumps: the 50 iterations that rows do, one by one.
 *  - smart_lambda: 200 iterations; "base": of lambda 1, "reach": of the row's own lambda for beta and gamma. Rows have 20: so
 *    it is what these leave undone.
 *  - smart_packing: what the rows do, of colours and alpha in 32 bits. Links take 16 bits once a pixel has more than 254
 *    layers: that row's scene has such a pixel, in a corner, and its truth as well.
 *  - smart_links, smart_limit: of the tiles, which the header is told are one part, links by what tile each fragment is of,
 *    without limit: that is right wherever one is. Of the stream surface, which is one, links by default; so these rows
 *    tell how others differ from that.
 * Beside these two it prints the share of fragments that have other links than the truth. */
#ifndef GLASSINE_BENCH_ACCURACY_SMART_H
#define GLASSINE_BENCH_ACCURACY_SMART_H

#include "../tests/smart_truth.h"
#include "bench.h"

typedef void (*operator_row_fn)(const char *effect, const char *scene_name, const char *setting, double ms,
                                double error_max, double error_rms, unsigned long long bytes);

enum {
    OPERATOR_SIZE = 160,
    OPERATOR_STORE_SIZE = 160,
    OPERATOR_ROOM = 400000,
    OPERATOR_FRAMES = 64,
    OPERATOR_SETTLE = 64
};

/* ---- errors ---- */

typedef struct operator_error {
    double max, squares, count;
} operator_error;

static void operator_add_error(operator_error *e, double difference) {
    e->max = fmax(e->max, 255 * fabs(difference));
    e->squares += 255 * difference * 255 * difference;
    e->count += 1;
}

static double operator_rms(const operator_error *e) {
    return e->count > 0 ? sqrt(e->squares / e->count) : 0;
}

/* ---- stores ---- */

typedef struct store_setting {
    const char *effect, *name;
    oit_desc desc;
} store_setting;

#define OPERATOR_BUDGET(n)                                                                                             \
    {                                                                                                                  \
        "oit_budget", #n " MiB", {                                                                                     \
            .store = OIT_STORE_BUDGET, .budget_bytes = (int64_t)(n) << 20                                              \
        }                                                                                                              \
    }
#define OPERATOR_BUCKETED(effect, k, bits)                                                                             \
    {                                                                                                                  \
        effect, #k " layers, " #bits " bits", {                                                                        \
            .store = OIT_STORE_BUCKETED, .fields = OIT_FIELD_PART, .layers = k, .bucket_depth_bits = bits              \
        }                                                                                                              \
    }

static const store_setting operator_stores[] = {{"oit", "exact", {.store = OIT_STORE_EXACT}},
                                                {"oit", "exact, half", {.color = OIT_COLOR_HALF}},
                                                {"oit", "exact, float", {.color = OIT_COLOR_FLOAT}},
                                                {"oit", "predict", {.store = OIT_STORE_PREDICT}},
                                                {"oit", "linked", {.store = OIT_STORE_LINKED}},
                                                {"oit", "fetch", {.store = OIT_STORE_FETCH}},
                                                OPERATOR_BUDGET(1),
                                                OPERATOR_BUDGET(2),
                                                OPERATOR_BUDGET(4),
                                                OPERATOR_BUDGET(8),
                                                OPERATOR_BUDGET(16),
                                                OPERATOR_BUDGET(64),
                                                OPERATOR_BUCKETED("oit_bucketed", 2, 32),
                                                OPERATOR_BUCKETED("oit_bucketed", 4, 32),
                                                OPERATOR_BUCKETED("oit_bucketed", 8, 32),
                                                OPERATOR_BUCKETED("oit_bucketed", 16, 32),
                                                OPERATOR_BUCKETED("oit_bucketed", 64, 32)},
                           operator_depths[] = {OPERATOR_BUCKETED("oit_depth_bits", 4, 32),
                                                OPERATOR_BUCKETED("oit_depth_bits", 4, 16),
                                                OPERATOR_BUCKETED("oit_depth_bits", 8, 32),
                                                OPERATOR_BUCKETED("oit_depth_bits", 8, 16),
                                                OPERATOR_BUCKETED("oit_depth_bits", 64, 32),
                                                OPERATOR_BUCKETED("oit_depth_bits", 64, 16)};

static void run_store(oit_setting *t, oit_scene *s, const char *name, const store_setting *setting,
                      const oit_truth *truth, int frame_count, operator_row_fn add) {
    oit_desc desc = setting->desc;
    oit_frame frame = oit_scene_frame(s, t->framebuffer);
    oit_result result;
    operator_error e = {0, 0, 0};
    double times[OPERATOR_FRAMES];
    int taken = 0;
    desc.get_proc = oit_scene_get_proc;
    oit_context *oit = oit_create(&desc, &result);
    if (!oit) {
        printf("%s left out: %s\n", setting->name, oit_result_string(result));
        return;
    }
    for (int i = -2; i < frame_count && (taken < 1 || times[0] < 500 || taken < 3);
         ++i) { /* seconds are noisy by less */
        oit_setting_clear(t, s);
        glFinish();
        double start = now_ms();
        oit_scene_render(s, oit, &frame, NULL);
        glFinish();
        if (i >= 0)
            times[taken++] = now_ms() - start;
    }
    float *picture = oit_setting_read(t, t->framebuffer);
    for (size_t p = 0; p < (size_t)t->width * (size_t)t->height; ++p)
        for (size_t k = 0; k < 3 && !truth[p].left_out; ++k)
            operator_add_error(&e, (double)picture[4 * p + k] - truth[p].color[k]);
    add(setting->effect, name, setting->name, median(times, (size_t)taken), e.max, operator_rms(&e),
        oit_get_info(oit).bytes);
    free(picture);
    oit_destroy(oit);
}

static void compare_stores(oit_setting *t, oit_scene *s, const char *name, const store_setting *settings, size_t count,
                           int frame_count, operator_row_fn add) {
    oit_truth *truth = need(OPERATOR_STORE_SIZE * OPERATOR_STORE_SIZE * sizeof *truth);
    printf("%s: %.1f %% of pixels left out\n", name, 100 * oit_truth_render(s, truth));
    for (size_t i = 0; i < count; ++i)
        run_store(t, s, name, &settings[i], truth, frame_count, add);
    oit_scene_drop(s);
    free(truth);
}

static void run_stores(int frame_count, operator_row_fn add) {
    const size_t stores = sizeof operator_stores / sizeof operator_stores[0];
    const size_t depths = sizeof operator_depths / sizeof operator_depths[0];
    static oit_scene s;
    oit_setting t;
    oit_setting_open(&t, false, OPERATOR_STORE_SIZE, OPERATOR_STORE_SIZE, 0, GL_RGBA32F, (oit_desc){0});
    oit_scene_init(&s, OPERATOR_STORE_SIZE, OPERATOR_STORE_SIZE);
    oit_scene_concentric(&s, 32, 48, 0.1);
    compare_stores(&t, &s, "concentric", operator_stores, stores, frame_count, add);
    oit_scene_init(&s, OPERATOR_STORE_SIZE, OPERATOR_STORE_SIZE);
    oit_scene_random_balls(&s, 16, 63, 0.4);
    compare_stores(&t, &s, "balls", operator_stores, stores, frame_count, add);
    oit_scene_init(&s, OPERATOR_STORE_SIZE, OPERATOR_STORE_SIZE);
    oit_scene_concentric(&s, 32, 48, 0.1);
    oit_scene_camera(&s, 4, 0.005, 8, 0.268);
    compare_stores(&t, &s, "concentric", operator_depths, depths, frame_count, add);
    oit_setting_close(&t);
}

/* ---- operators: scenes ---- */

/* numbers: middle, edge, height of the waves, waves, where they begin. */
static void operator_tile(double u, double v, const double *n, double out[3]) {
    out[0] = n[0] + n[3] * (u - 0.5);
    out[1] = n[1] + n[3] * (v - 0.5);
    out[2] = n[2] + n[4] * sin(n[5] * (u + 0.6 * v) + n[6]);
}

/* Four walls of wavy tiles, one behind the other. Where a tile ends another begins, somewhat nearer or farther; there is at
 * most one fragment of each in a pixel. */
static void operator_tiles(smart_stage *t) {
    oit_scene *s = smart_stage_clear(t);
    uint32_t state = 5;
    oit_scene_camera(s, 4, 1, 8, 0.33);
    t->radius = 1.5;
    for (int i = 0; i < 64; ++i) {
        double r[3], color[4];
        for (int k = 0; k < 3; ++k)
            r[k] = oit_scene_random(&state) - 0.5;
        const double numbers[7] = {0.66 * (i % 4) - 0.99,
                                   0.66 * (i / 4 % 4) - 0.99,
                                   0.4 * (i / 16) - 0.6 + 0.3 * r[0],
                                   0.66,
                                   0.04 + 0.04 * r[1],
                                   8,
                                   6 * r[2]};
        smart_stage_color(&state, 0.3, color);
        smart_stage_sheet(s, operator_tile, numbers, 24, color);
    }
}

/* The stream surface, and 255 layers in the pixel of a corner: squares in the space of the eye. */
static void operator_deep(smart_stage *t) {
    oit_scene *s = &t->scene;
    smart_truth_stream(t);
    const double *view = s->scene.view, color[4] = {0.5, 0.5, 0.5, 0.1};
    double back[16] = {0}; /* the view is a motion: its turn transposed, and what that makes of its shift */
    for (int row = 0; row < 3; ++row)
        for (int k = 0; k < 3; ++k) {
            back[4 * k + row] = view[4 * row + k];
            back[12 + row] -= view[4 * row + k] * view[12 + k];
        }
    back[15] = 1;
    for (int i = 0; i < 255; ++i) {
        const double away = t->radius * (2 + 0.005 * i), half = away / s->scene.projection[0];
        const double z[4] = {-away, -away, -away, -away};
        const double end = half * (2.0 / OPERATOR_SIZE - 1);
        memcpy(s->truths[oit_scene_quad(s, -half, -half, end, end, z, color)].model, back, sizeof back);
    }
}

typedef struct operator_scene {
    const char *name;
    smart_truth_maker make;
    bool parts; /* the truth knows of parts that the header is not told */
} operator_scene;

static const operator_scene operator_stream = {"stream surface", smart_truth_stream, false},
                            operator_klein = {"Klein bottle", smart_truth_klein, false},
                            operator_wall = {"tiles", operator_tiles, true},
                            operator_deep_stream = {"stream surface", operator_deep, false};

/* ---- operators: a frame, its truth, a row ---- */

typedef struct operator_bench {
    smart_stage t;
    const operator_scene *scene;
    double *truth;         /* rgb of each pixel */
    ref_smart_image links; /* of the truth */
    int frame_count;
    operator_row_fn add;
} operator_bench;

/* What a row is of. `times` is which operator is timed. */
typedef struct operator_setting {
    const char *effect;
    oit_link link;
    oit_smart smart;
    oit_run_kind times;
} operator_setting;

static const oit_law operator_law = {.kind = OIT_LAW_ADAPTIVE, .s = 0.6f};

static void operator_open(operator_bench *b, const operator_scene *made, oit_desc desc) {
    const float light[3] = {0.3f, 0.5f, 1};
    desc.operators |= OIT_OPERATE_SMART;
    smart_stage_open(&b->t, false, OPERATOR_SIZE, desc, OPERATOR_ROOM);
    memcpy(b->t.light, light, sizeof light);
    b->scene = made;
    made->make(&b->t);
}

/* The buffer begins with room for more, and gives that back after 60 frames: then its bytes are what is needed. */
static void operator_settle(operator_bench *b) {
    for (int i = 0; i < OPERATOR_SETTLE; ++i) {
        smart_stage_begin(&b->t, NULL);
        free(smart_stage_end(&b->t));
    }
}

static void operator_close(operator_bench *b) {
    smart_stage_close(&b->t);
}

static void operator_drop_truth(operator_bench *b) {
    free(b->truth);
    smart_stage_drop(&b->links);
    b->truth = NULL;
}

/* The law is run first: it sorts. Returns the picture; ms (may be NULL) of the operator that is timed. */
static float *operator_frame(operator_bench *b, const operator_setting *set, double *ms, ref_smart_image *image) {
    const oit_operator ops[3] = {{.kind = OIT_RUN_LAW, .law = operator_law},
                                 {.kind = OIT_RUN_LINK, .link = set->link},
                                 {.kind = OIT_RUN_SMART, .smart = set->smart}};
    smart_stage_begin(&b->t, NULL);
    for (int i = 0; i < 3; ++i) {
        glFinish();
        double start = now_ms();
        smart_stage_run(&b->t, &ops[i]);
        glFinish();
        if (ms && ops[i].kind == set->times)
            *ms = now_ms() - start;
    }
    if (image)
        *image = smart_stage_look(&b->t);
    return smart_stage_end(&b->t);
}

/* Makes the setting the truth of the rows that follow. */
static void operator_make_truth(operator_bench *b, operator_setting set) {
    set.link.radius = (float)b->t.radius;
    if (b->scene->parts)
        set.link.limit = -1;
    for (size_t i = 0; b->scene->parts && i < b->t.scene.count; ++i)
        b->t.scene.objects[i].part = 1 + (uint32_t)i;
    free(operator_frame(b, &set, NULL, &b->links));
    const ref_smart_links links = smart_stage_links(&b->t, &set.link);
    ref_smart_link(&b->links, &links);
    smart_truth_solve(&b->links, links.projection, &operator_law, &set.smart);
    b->truth = need(3 * OPERATOR_SIZE * OPERATOR_SIZE * sizeof *b->truth);
    for (int p = 0; p < OPERATOR_SIZE * OPERATOR_SIZE; ++p) {
        double *color = b->truth + 3 * p;
        color[0] = color[1] = color[2] = 1;
        ref_smart_compose(&b->links, p % OPERATOR_SIZE, p / OPERATOR_SIZE, color, NULL);
    }
    for (size_t i = 0; b->scene->parts && i < b->t.scene.count; ++i)
        b->t.scene.objects[i].part = 1;
}

static double operator_other_links(const ref_smart_image *a, const ref_smart_image *b) {
    size_t count = smart_truth_count(a), off = 0;
    for (size_t i = 0; i < count; ++i)
        off += memcmp(a->fragments[i].link, b->fragments[i].link, sizeof a->fragments[i].link) != 0;
    return count ? (double)off / (double)count : 0;
}

static void operator_row(operator_bench *b, operator_setting set, const char *name) {
    double times[OPERATOR_FRAMES];
    operator_error e = {0, 0, 0};
    ref_smart_image image;
    set.link.radius = (float)b->t.radius;
    for (int i = -1; i < b->frame_count; ++i)
        free(operator_frame(b, &set, &times[i < 0 ? 0 : i], NULL));
    float *picture = operator_frame(b, &set, NULL, &image);
    for (size_t p = 0; p < OPERATOR_SIZE * OPERATOR_SIZE; ++p)
        for (size_t k = 0; k < 3; ++k)
            operator_add_error(&e, (double)picture[4 * p + k] - b->truth[3 * p + k]);
    b->add(set.effect, b->scene->name, name, median(times, (size_t)b->frame_count), e.max, operator_rms(&e),
           oit_get_info(b->t.set.oit).bytes);
    if (set.times == OIT_RUN_LINK)
        printf("    %.3f %% of fragments have other links\n", 100 * operator_other_links(&image, &b->links));
    smart_stage_drop(&image);
    free(picture);
}

/* ---- operators: what is compared ---- */

/* So many iterations of all fields; 0: the default. The rest is by default. */
static operator_setting operator_of(const char *effect, int iterations) {
    operator_setting set;
    memset(&set, 0, sizeof set);
    set.effect = effect;
    set.times = OIT_RUN_SMART;
    set.smart.base.iterations = set.smart.beta.iterations = set.smart.gamma.iterations = iterations;
    return set;
}

static void compare_iterations(operator_bench *b) {
    static const int counts[5] = {5, 10, 20, 50, 100};
    operator_make_truth(b, operator_of("smart_iterations", 200));
    for (int jumps = 0; jumps < 2; ++jumps)
        for (int i = 0; i < 5; ++i) {
            char name[32];
            operator_setting set = operator_of("smart_iterations", counts[i]);
            set.smart.jumps = jumps;
            snprintf(name, sizeof name, jumps ? "%d by jumps" : "%d", counts[i]);
            operator_row(b, set, name);
        }
    operator_drop_truth(b);
}

static void compare_jumps(operator_bench *b) {
    operator_setting set = operator_of("smart_jumps", 50);
    set.smart.beta.lambda = set.smart.gamma.lambda = 1.0f / 50;
    operator_make_truth(b, set);
    operator_row(b, set, "iterated");
    set.smart.jumps = 1;
    for (int rounds = 0; rounds <= 4; ++rounds) {
        char name[32];
        snprintf(name, sizeof name, rounds ? "rounds %d" : "by default", rounds);
        set.smart.rounds = rounds;
        operator_row(b, set, name);
    }
    set.smart.rounds = 0;
    set.smart.until_stable = 1;
    operator_row(b, set, "until stable");
    operator_drop_truth(b);
}

static void compare_lambdas(operator_bench *b) {
    static const float bases[4] = {0.1f, 0.25f, 0.5f, 1}, reaches[4] = {0.01f, 0.02f, 0.03f, 0.05f};
    operator_make_truth(b, operator_of("smart_lambda", 200));
    for (int i = 0; i < 4; ++i) {
        char name[32];
        operator_setting set = operator_of("smart_lambda", 20);
        set.smart.base.lambda = bases[i];
        snprintf(name, sizeof name, "base %.2f", (double)bases[i]);
        operator_row(b, set, name);
    }
    operator_drop_truth(b);
    for (int i = 0; i < 4; ++i) {
        char name[32];
        operator_setting truth = operator_of("smart_lambda", 200), set = operator_of("smart_lambda", 20);
        truth.smart.base.iterations = 20; /* base is not in question */
        truth.smart.beta.lambda = truth.smart.gamma.lambda = reaches[i];
        set.smart.beta.lambda = set.smart.gamma.lambda = reaches[i];
        snprintf(name, sizeof name, "reach %.2f", (double)reaches[i]);
        operator_make_truth(b, truth);
        operator_row(b, set, name);
        operator_drop_truth(b);
    }
}

static void compare_limits(operator_bench *b) {
    static const float limits[8] = {0.0025f, 0.005f, 0.01f, 0.02f, 0.04f, 0.08f, 0.16f, -1};
    operator_setting set = operator_of("smart_limit", 0);
    set.times = OIT_RUN_LINK;
    operator_make_truth(b, set);
    for (int i = 0; i < 8; ++i) {
        char name[32] = "none";
        if (limits[i] > 0)
            snprintf(name, sizeof name, "%g", (double)limits[i]);
        set.link.limit = limits[i];
        operator_row(b, set, name);
    }
    operator_drop_truth(b);
}

static void compare_links(operator_bench *b) {
    static const struct {
        const char *name;
        oit_criterion criterion;
        oit_search search;
        int one_sided;
    } ways[] = {{"windowed", OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED, 0},
                {"brute", OIT_LINK_DEPTH, OIT_SEARCH_BRUTE, 0},
                {"buckets", OIT_LINK_DEPTH, OIT_SEARCH_BUCKETS, 0},
                {"windowed, one-sided", OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED, 1},
                {"published", OIT_LINK_PUBLISHED, OIT_SEARCH_BRUTE, 0},
                {"Murray", OIT_LINK_MURRAY, OIT_SEARCH_BRUTE, 0},
                {"Murray, one-sided", OIT_LINK_MURRAY, OIT_SEARCH_BRUTE, 1}};
    operator_setting set = operator_of("smart_links", 0);
    set.times = OIT_RUN_LINK;
    operator_make_truth(b, set);
    for (size_t i = 0; i < sizeof ways / sizeof ways[0]; ++i) {
        set.link.criterion = ways[i].criterion;
        set.link.search = ways[i].search;
        set.link.no_reverse_check = ways[i].one_sided;
        operator_row(b, set, ways[i].name);
    }
    operator_drop_truth(b);
}

/* Each in a context of its own: packing is chosen at creation. The truth is of colours in 32 bits. */
static void compare_packing(operator_bench *b) {
    static const char *const names[4] = {"colours of 10 bits", "colours of 16 bits", "colours of 32 bits",
                                         "links of 16 bits"};
    static const oit_color colors[4] = {OIT_COLOR_8, OIT_COLOR_HALF, OIT_COLOR_FLOAT, OIT_COLOR_FLOAT};
    const operator_setting set = operator_of("smart_packing", 0);
    for (int i = 0; i < 4; ++i) {
        const operator_scene *made = i == 3 ? &operator_deep_stream : &operator_stream;
        if (i == 0 || i == 3) {
            operator_open(b, made, (oit_desc){.color = OIT_COLOR_FLOAT});
            operator_make_truth(b, set);
            operator_close(b);
        }
        operator_open(b, made, (oit_desc){.color = colors[i]});
        operator_settle(b);
        operator_row(b, set, names[i]);
        operator_close(b);
        if (i >= 2)
            operator_drop_truth(b);
    }
}

/* All rows of oit_buffers.h, in contexts of its own: none is current after it. frame_count: odd. */
static void run_operators(int frame_count, operator_row_fn add) {
    static operator_bench b;
    static const operator_scene *const fields[2] = {&operator_stream, &operator_klein};
    static const operator_scene *const surfaces[2] = {&operator_stream, &operator_wall};
    b.frame_count = frame_count;
    b.add = add;
    run_stores(frame_count, add);
    for (int k = 0; k < 2; ++k) {
        operator_open(&b, fields[k], (oit_desc){.color = OIT_COLOR_FLOAT});
        operator_settle(&b);
        compare_iterations(&b);
        compare_jumps(&b);
        compare_lambdas(&b);
        operator_close(&b);
        operator_open(&b, surfaces[k], (oit_desc){.color = OIT_COLOR_FLOAT, .operators = OIT_OPERATE_BUCKETS});
        operator_settle(&b);
        compare_links(&b);
        compare_limits(&b);
        operator_close(&b);
    }
    compare_packing(&b);
}

#endif

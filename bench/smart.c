/* smart: what operators on fragments cost. Searches for links beside each other, as Murray 2016, figure 10, on facing,
 * tilted and wavy sheets; fields by iterations and by jumps, and what each round of jumps leaves wrong; the stages of a frame
 * against pixels and against triangles, as Carnecky 2013, figures 14 and 15.
 *
 * usage: smart [FILE.csv]       BENCH=quick: fewer frames, small sizes
 *
 * Milliseconds are medians by the wall clock around glFinish; what is compared runs in turn within each frame. error_max: of
 * searches the share of fragments whose links are not those of all pairs; of jumps, and of rounds of them, the share of which
 * base, beta or gamma is off by more than 0.01 from the iterated. Sheets are of one part, which buckets have nothing to divide,
 * but for work "parts", where size is the number of parts that 32 sheets are divided into. What does not fit into the
 * driver's storage blocks is left out and named. */
#include "../tests/smart_stage.h"
#include "bench.h"

enum { MAX_FRAMES = 5, MAX_OPS = 5, MAX_TIMES = MAX_OPS + 2, STEPS = 50, MAX_ROUNDS = 5, SHEETS = 32 };

static int frame_count(void) {
    return is_quick() ? 1 : MAX_FRAMES;
}

static double finished(double *since) {
    glFinish();
    double now = now_ms(), took = now - *since;
    *since = now;
    return took;
}

/* ---- scenes: sheets of `steps` x `steps` cells one behind the other, divided evenly into parts ---- */

typedef struct sheets {
    const char *name;
    double tilt, height; /* of the waves */
} sheets;

static const sheets kinds[] = {{"facing", 0, 0}, {"tilted", 0.8, 0}, {"wavy", 0.1, 1.5}};
enum { FACING, TILTED, WAVY, KINDS };

static void make_sheets(smart_stage *t, int kind, int count, int parts, int steps) {
    oit_scene *s = smart_stage_clear(t);
    uint32_t state = 11;
    oit_scene_camera(s, 4, 1, 8, 0.33);
    t->radius = 1.5;
    for (int i = 0; i < count; ++i) {
        const double share = (i + 0.5) / count, r = oit_scene_random(&state) - 0.5;
        const double numbers[6] = {1.4 * share - 0.7,
                                   kinds[kind].tilt * r,
                                   kinds[kind].tilt * (share - 0.5),
                                   kinds[kind].height / count,
                                   7 + 5 * r,
                                   9 * r};
        const double color[4] = {share, 0.5, 1 - share, 0.1};
        s->objects[smart_stage_sheet(s, smart_stage_wavy, numbers, steps, color)].part =
            1 + (uint32_t)(i * parts / count);
    }
}

/* ---- operators ---- */

static oit_operator law_operator(void) {
    oit_operator op = {.kind = OIT_RUN_LAW, .law = {.kind = OIT_LAW_ADAPTIVE, .s = 0.9f}};
    return op;
}

static oit_operator link_operator(oit_search search) {
    oit_operator op = {.kind = OIT_RUN_LINK, .link = {.radius = 1.5f, .search = search}};
    return op;
}

static oit_operator smart_operator(int jumps, int rounds) {
    oit_operator op = {.kind = OIT_RUN_SMART,
                       .smart = {.base = {.iterations = STEPS},
                                 .beta = {.iterations = STEPS, .lambda = 1.0f / STEPS},
                                 .gamma = {.iterations = STEPS, .lambda = 1.0f / STEPS},
                                 .jumps = jumps,
                                 .rounds = rounds}};
    return op;
}

/* ---- measuring ---- */

/* One frame: fill, each operator, composition; the first operator sorts, too. False: the driver cannot hold it. */
static bool time_frame(smart_stage *t, const oit_operator *ops, int count, double took[MAX_TIMES]) {
    oit_pass pass;
    oit_frame frame = oit_scene_frame(&t->scene, t->set.framebuffer);
    double since = now_ms();
    bool fits = true;
    for (int k = 0; k < 16; ++k)
        frame.projection[k] = (float)t->scene.scene.projection[k];
    oit_setting_clear(&t->set, &t->scene);
    finished(&since);
    oit_scene_expect(oit_begin(t->set.oit, &frame), "oit_begin");
    while (oit_next_pass(t->set.oit, &pass))
        smart_stage_draw(&t->scene, t->set.oit, &pass, NULL);
    took[0] = finished(&since);
    for (int i = 0; fits && i < count; ++i) {
        fits = oit_run(t->set.oit, &ops[i]) == OIT_OK;
        took[1 + i] = finished(&since);
    }
    oit_scene_expect(oit_compose(t->set.oit), "oit_compose");
    oit_scene_expect(oit_end(t->set.oit), "oit_end");
    took[1 + count] = finished(&since);
    return fits;
}

/* Medians of so many frames, after one to warm up. */
static bool measure(smart_stage *t, const oit_operator *ops, int count, double out[MAX_TIMES]) {
    double times[MAX_TIMES][MAX_FRAMES], took[MAX_TIMES];
    for (int f = -1; f < frame_count(); ++f) {
        if (!time_frame(t, ops, count, took))
            return false;
        for (int k = 0; f >= 0 && k < count + 2; ++k)
            times[k][f] = took[k];
    }
    for (int k = 0; k < count + 2; ++k)
        out[k] = median(times[k], (size_t)frame_count());
    return true;
}

static ref_smart_image look(smart_stage *t, const oit_operator *link, const oit_operator *smart) {
    oit_operator ops[3] = {*link, law_operator(), *smart};
    ref_smart_image image;
    free(smart_stage_frame(t, ops, 3, NULL, &image));
    return image;
}

static double share_that_differs(const ref_smart_image *a, const ref_smart_image *b, bool links) {
    size_t count = a->start[(size_t)a->width * (size_t)a->height], off = 0;
    for (size_t i = 0; i < count; ++i) {
        const ref_smart_fragment *f = &a->fragments[i], *g = &b->fragments[i];
        off += links ? memcmp(f->link, g->link, sizeof f->link) != 0
                     : !(fabs(f->base - g->base) <= 0.01 && fabs(f->beta - g->beta) <= 0.01 &&
                         fabs(f->gamma - g->gamma) <= 0.01);
    }
    return count ? (double)off / (double)count : 0;
}

static void tell(FILE *csv, const char *work, const char *scene_name, int size, const char *subject, double ms,
                 const smart_stage *t, double error) {
    uint64_t bytes = oit_get_info(t->set.oit).bytes;
    printf("%-9s %-7s %8d %-9s %9.2f ms %11llu bytes  %.5f\n", work, scene_name, size, subject, ms,
           (unsigned long long)bytes, error);
    fprintf(csv, "%s,%s,%d,%s,%.4f,%llu,%.6f\n", work, scene_name, size, subject, ms, (unsigned long long)bytes, error);
}

/* ---- what is compared ---- */

static void compare_searches(FILE *csv, smart_stage *t, const char *work, const char *name, int size) {
    static const char *const subjects[3] = {"windowed", "brute", "buckets"};
    const oit_operator ops[4] = {law_operator(), link_operator(OIT_SEARCH_WINDOWED), link_operator(OIT_SEARCH_BRUTE),
                                 link_operator(OIT_SEARCH_BUCKETS)};
    const oit_operator smart = smart_operator(1, 0);
    double times[MAX_TIMES];
    if (!measure(t, ops, 4, times))
        return;
    ref_smart_image truth = look(t, &ops[2], &smart);
    for (int k = 0; k < 3; ++k) {
        ref_smart_image image = look(t, &ops[1 + k], &smart);
        tell(csv, work, name, size, subjects[k], times[2 + k], t, share_that_differs(&truth, &image, true));
        smart_stage_drop(&image);
    }
    smart_stage_drop(&truth);
    printf("    windowed is %.1f times as fast as all pairs\n", times[3] / times[2]);
}

static void compare_fields(FILE *csv, smart_stage *t, const char *name, int size) {
    const oit_operator ops[5] = {law_operator(), link_operator(OIT_SEARCH_WINDOWED), smart_operator(0, 0),
                                 law_operator(), smart_operator(1, 0)};
    double times[MAX_TIMES];
    if (!measure(t, ops, 5, times))
        return;
    ref_smart_image truth = look(t, &ops[1], &ops[2]);
    tell(csv, "fields", name, size, "iterated", times[3], t, 0);
    for (int rounds = 0; rounds <= MAX_ROUNDS; ++rounds) { /* 0: as many as by default */
        const oit_operator jump = smart_operator(1, rounds), part[3] = {ops[0], ops[1], jump};
        double own[MAX_TIMES];
        char subject[16];
        ref_smart_image image = look(t, &ops[1], &jump);
        snprintf(subject, sizeof subject, rounds ? "round %d" : "jump", rounds);
        if (rounds ? measure(t, part, 3, own) : true)
            tell(csv, rounds ? "rounds" : "fields", name, size, subject, rounds ? own[3] : times[5], t,
                 share_that_differs(&truth, &image, false));
        smart_stage_drop(&image);
    }
    smart_stage_drop(&truth);
    printf("    jumps are %.1f times as fast as iterations\n", times[3] / times[5]);
}

static void measure_stages(FILE *csv, smart_stage *t, const char *work, const char *name, int size) {
    static const char *const names[5] = {"fill", "sort", "connect", "solve", "compose"};
    const oit_operator ops[3] = {law_operator(), link_operator(OIT_SEARCH_WINDOWED), smart_operator(1, 0)};
    double times[MAX_TIMES];
    if (!measure(t, ops, 3, times)) {
        printf("%-9s %-7s %8d left out: more than storage blocks hold\n", work, name, size);
        t->set.logged = 0; /* that it does not fit */
        return;
    }
    for (int k = 0; k < 5; ++k)
        tell(csv, work, name, size, names[k], times[k], t, 0);
}

static void compare_on_sheets(FILE *csv, int size) {
    const oit_desc desc = {.operators = OIT_OPERATE_SMART | OIT_OPERATE_BUCKETS};
    smart_stage t;
    smart_stage_open(&t, false, size, desc, (size_t)size * (size_t)size * (SHEETS + 2));
    for (int kind = 0; kind < KINDS; ++kind) {
        make_sheets(&t, kind, SHEETS, 1, 48);
        compare_searches(csv, &t, "links", kinds[kind].name, size);
        compare_fields(csv, &t, kinds[kind].name, size);
        for (int parts = 1; parts <= SHEETS; parts *= is_quick() ? 32 : 2) {
            make_sheets(&t, kind, SHEETS, parts, 48);
            compare_searches(csv, &t, "parts", kinds[kind].name, parts);
        }
    }
    smart_stage_close(&t);
}

static void measure_by_pixels(FILE *csv, const oit_desc *desc) {
    for (int layers = 2; layers <= 8; layers *= 4)
        for (int size = 128; size <= (is_quick() ? 256 : 2048); size *= 2) {
            char name[16];
            smart_stage t;
            smart_stage_open(&t, false, size, *desc, 1); /* nothing is read back */
            make_sheets(&t, WAVY, layers, 1, 48);
            snprintf(name, sizeof name, "wavy %d", layers);
            measure_stages(csv, &t, "pixels", name, size);
            smart_stage_close(&t);
        }
}

static void measure_by_triangles(FILE *csv, const oit_desc *desc) {
    for (int steps = 8; steps <= (is_quick() ? 32 : 128); steps *= 4) { /* 2 steps^2 triangles a sheet */
        smart_stage t;
        smart_stage_open(&t, false, 128, *desc, 1);
        make_sheets(&t, WAVY, SHEETS, 1, steps);
        measure_stages(csv, &t, "triangles", "wavy", 2 * SHEETS * steps * steps);
        smart_stage_close(&t);
    }
}

int main(int argc, char **argv) {
    const oit_desc desc = {.operators = OIT_OPERATE_SMART};
    FILE *csv = open_table(argc, argv, "build/bench/smart.csv");
    measure_by_pixels(csv, &desc);
    measure_by_triangles(csv, &desc);
    compare_on_sheets(csv, is_quick() ? 64 : 128);
    return close_table(csv);
}

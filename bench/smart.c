/* smart: what operators on fragments cost: the searches for links beside each other, fields by iterations and by jumps, and
 * the stages of a frame against pixels and against triangles (Carnecky 2013, figures 14 and 15).
 *
 * usage: smart [FILE.csv]       BENCH=quick: fewer frames, small sizes
 *
 * Milliseconds are medians by the wall clock around glFinish. error_max: of searches the share of fragments whose links are
 * not those of all pairs; of jumps the share whose beta or gamma is off by more than 0.01. Sheets are all of one part for
 * windowed and brute, which buckets have nothing to divide; "parts" gives each its own. */
#include "../tests/smart_stage.h"
#include "bench.h"

enum { FILL, SORT, CONNECT, SOLVE, COMPOSE, STAGES, FRAMES = 9 };
static const char *const stage_names[STAGES] = {"fill", "sort", "connect", "solve", "compose"};

static double finished(double *since) {
    glFinish();
    double now = now_ms(), took = now - *since;
    *since = now;
    return took;
}

static void make_sheets(smart_stage *t, double tilt, double height, int steps, bool parts) {
    oit_scene *s = smart_stage_clear(t);
    uint32_t state = 11;
    oit_scene_camera(s, 4, 1, 8, 0.33);
    t->radius = 1.5;
    for (int i = 0; i < 32; ++i) {
        const double share = (i + 0.5) / 32, r = oit_scene_random(&state) - 0.5;
        const double numbers[6] = {1.4 * share - 0.7, tilt * r, tilt * (share - 0.5), height / 32, 7 + 5 * r, 9 * r};
        const double color[4] = {share, 0.5, 1 - share, 0.1};
        s->objects[smart_stage_sheet(s, smart_stage_wavy, numbers, steps, color)].part = parts ? (uint32_t)i + 1 : 1;
    }
}

/* Medians of the stages of a frame. */
static void measure(smart_stage *t, const oit_link *link, const oit_smart *smart, double out[STAGES]) {
    double times[STAGES][FRAMES];
    int frames = is_quick() ? 1 : FRAMES;
    for (int f = -1; f < frames; ++f) { /* one to warm up */
        oit_operator op;
        oit_pass pass;
        oit_frame frame = oit_scene_frame(&t->scene, t->set.framebuffer);
        double took[STAGES], since = now_ms();
        for (int k = 0; k < 16; ++k)
            frame.projection[k] = (float)t->scene.scene.projection[k];
        memset(&op, 0, sizeof op);
        oit_setting_clear(&t->set, &t->scene);
        finished(&since);
        oit_scene_expect(oit_begin(t->set.oit, &frame), "oit_begin");
        while (oit_next_pass(t->set.oit, &pass))
            smart_stage_draw(&t->scene, t->set.oit, &pass, NULL);
        took[FILL] = finished(&since);
        op.kind = OIT_RUN_LAW; /* the first operator sorts */
        oit_scene_expect(oit_run(t->set.oit, &op), "oit_run");
        took[SORT] = finished(&since);
        op.kind = OIT_RUN_LINK;
        op.link = *link;
        oit_scene_expect(oit_run(t->set.oit, &op), "oit_run");
        took[CONNECT] = finished(&since);
        op.kind = OIT_RUN_SMART;
        op.smart = *smart;
        oit_scene_expect(oit_run(t->set.oit, &op), "oit_run");
        took[SOLVE] = finished(&since);
        oit_scene_expect(oit_compose(t->set.oit), "oit_compose");
        oit_scene_expect(oit_end(t->set.oit), "oit_end");
        took[COMPOSE] = finished(&since);
        for (int k = 0; f >= 0 && k < STAGES; ++k)
            times[k][f] = took[k];
    }
    for (int k = 0; k < STAGES; ++k)
        out[k] = median(times[k], (size_t)frames);
}

static ref_smart_image look(smart_stage *t, const oit_link *link, const oit_smart *smart) {
    oit_operator ops[2];
    ref_smart_image image;
    memset(ops, 0, sizeof ops);
    ops[0].kind = OIT_RUN_LINK;
    ops[0].link = *link;
    ops[1].kind = OIT_RUN_SMART;
    ops[1].smart = *smart;
    free(smart_stage_frame(t, ops, 2, NULL, &image));
    return image;
}

static double share_that_differs(const ref_smart_image *a, const ref_smart_image *b, bool links) {
    size_t count = a->start[(size_t)a->width * (size_t)a->height], off = 0;
    for (size_t i = 0; i < count; ++i) {
        const ref_smart_fragment *f = &a->fragments[i], *g = &b->fragments[i];
        off += links ? memcmp(f->link, g->link, sizeof f->link) != 0
                     : fabs(f->beta - g->beta) > 0.01 || fabs(f->gamma - g->gamma) > 0.01;
    }
    return count ? (double)off / (double)count : 0;
}

static void tell(FILE *csv, const char *work, const char *scene_name, int size, const char *subject, double ms,
                 const smart_stage *t, double error) {
    uint64_t bytes = oit_get_info(t->set.oit).bytes;
    printf("%-10s %-8s %5d %-10s %9.2f ms %12llu bytes  %.5f\n", work, scene_name, size, subject, ms,
           (unsigned long long)bytes, error);
    fprintf(csv, "%s,%s,%d,%s,%.4f,%llu,%.6f\n", work, scene_name, size, subject, ms, (unsigned long long)bytes, error);
}

static void compare(FILE *csv, smart_stage *t, const char *name, int size) {
    static const char *const searches[3] = {"windowed", "brute", "buckets"};
    oit_link link = {.radius = 1.5f, .search = OIT_SEARCH_BRUTE};
    oit_smart smart = {.base = {.iterations = 50},
                       .beta = {.iterations = 50, .lambda = 0.02f},
                       .gamma = {.iterations = 50, .lambda = 0.02f}};
    double times[STAGES];
    ref_smart_image truth = look(t, &link, &smart);
    for (int k = 0; k < 3; ++k) {
        link.search = (oit_search)k;
        measure(t, &link, &smart, times);
        ref_smart_image image = look(t, &link, &smart);
        tell(csv, "links", name, size, searches[k], times[CONNECT], t, share_that_differs(&truth, &image, true));
        smart_stage_drop(&image);
    }
    link.search = OIT_SEARCH_WINDOWED;
    for (int jump = 0; jump < 2; ++jump) {
        smart.jumps = jump;
        measure(t, &link, &smart, times);
        ref_smart_image image = look(t, &link, &smart);
        tell(csv, "fields", name, size, jump ? "jump" : "iterated", times[SOLVE], t,
             share_that_differs(&truth, &image, false));
        smart_stage_drop(&image);
    }
    smart_stage_drop(&truth);
}

static void stages(FILE *csv, smart_stage *t, const char *work, const char *name, int size) {
    oit_link link = {.radius = 1.5f};
    oit_smart smart = {.jumps = 1};
    double times[STAGES];
    measure(t, &link, &smart, times);
    for (int k = 0; k < STAGES; ++k)
        tell(csv, work, name, size, stage_names[k], times[k], t, 0);
}

int main(int argc, char **argv) {
    static const struct {
        const char *name;
        double tilt, height;
        bool parts;
    } kinds[] = {
        {"facing", 0, 0, false}, {"tilted", 0.8, 0, false}, {"wavy", 0.1, 1.5, false}, {"parts", 0.1, 1.5, true}};
    const oit_desc desc = {.operators = OIT_OPERATE_SMART | OIT_OPERATE_BUCKETS};
    FILE *csv = open_table(argc, argv, "build/bench/smart.csv");
    for (int size = is_quick() ? 64 : 128; size <= (is_quick() ? 64 : 512); size *= 2) {
        smart_stage t;
        smart_stage_open(&t, false, size, desc, (size_t)size * (size_t)size * 34);
        for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; ++k) {
            make_sheets(&t, kinds[k].tilt, kinds[k].height, 48, kinds[k].parts);
            compare(csv, &t, kinds[k].name, size);
        }
        stages(csv, &t, "pixels", "wavy", size);
        smart_stage_close(&t);
    }
    for (int steps = 8; steps <= (is_quick() ? 32 : 128); steps *= 4) { /* 32 sheets of 2 steps^2 triangles */
        smart_stage t;
        smart_stage_open(&t, false, 128, desc, (size_t)128 * 128 * 34);
        make_sheets(&t, 0.1, 1.5, steps, false);
        stages(csv, &t, "triangles", "wavy", 64 * steps * steps);
        smart_stage_close(&t);
    }
    return close_table(csv);
}

/* dynamic: what it costs never to lose a unit, and how far each way is from the truth per pixel.
 *
 * usage: dynamic [FILE.csv]       BENCH=quick: fewer frames, no paper's table at the larger size, 50 and 500 targets only
 *
 * - a forest of 1,000 trees with 1, 10, 50, 200 and 500 targets behind them, 1280 x 1024: opaque and every rung
 * - the paper's table 1: its scenes without and with dynamic transparency, in frames a second, at both of its sizes
 * - of how many targets 20 pixels have a weight of 0.3 with and without: a proxy for the paper's user study
 *
 * Milliseconds are medians of whole frames by the wall clock around glFinish, the opaque one drawn in turn with each.
 * onemask and dither draw the scene in parts (tr_dynamic.in_parts), the same with _whole do not. error_max is in 1/255
 * against the reference in double precision where one occluder lies before a target, pixels near edges left out; so is
 * the mean. */
#include "../tests/dynamic_scene.h"

#include "bench.h"
#include "forest.h"

typedef struct subject {
    const char *name;
    tr_see see;
    int in_parts;
} subject;

static const subject subjects[] = {{"opaque", TR_SEE_OFF, 0},          {"onemask", TR_SEE_ONE_MASK, 1},
                                   {"dither", TR_SEE_DITHER, 1},       {"onemask_whole", TR_SEE_ONE_MASK, 0},
                                   {"dither_whole", TR_SEE_DITHER, 0}, {"exact", TR_SEE_EXACT, 0},
                                   {"sequence", TR_SEE_SEQUENCE, 0},   {"published", TR_SEE_PUBLISHED, 0}};
enum { SUBJECTS = sizeof subjects / sizeof subjects[0], MOST_FRAMES = 31 };

/* ---- what the truth tells ---- */

/* The share of the picture that masks cover: all that is within the gradient of a target's open pixel. */
static double mask_share(const dynamic_scene *d, const ref_dyn_pixel *truth) {
    int w = d->scene.width, h = d->scene.height, n = (int)ceil(d->truth.width) - 1;
    size_t covered = 0;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            bool in = false;
            for (int v = y - n > 0 ? y - n : 0; !in && v <= y + n && v < h; ++v)
                for (int u = x - n > 0 ? x - n : 0; !in && u <= x + n && u < w; ++u)
                    in = truth[v * w + u].target != 0 && (u - x) * (u - x) + (v - y) * (v - y) <= n * n;
            covered += in;
        }
    return (double)covered / ((double)w * h);
}

static void print_found(const dynamic_scene *d, const char *name, const ref_dyn_census *census) {
    dynamic_found found = dynamic_find_targets(d, census);
    printf(
        "%-12s targets with 20 pixels of weight 0.3: %zu of %zu without, %zu with (a proxy for the paper's user study)\n",
        name, found.without, found.targets, found.with);
}

/* ---- measuring ---- */

/* Medians of the subject and of the opaque scene, frame by frame in turn. */
static void time_subject(harness *h, dynamic_scene *d, tr_see see, int frames, double *ms, double *opaque) {
    double times[2][MOST_FRAMES];
    for (int i = -2; i < frames; ++i)
        for (int k = 0; k < 2; ++k) {
            d->wish.see = k ? TR_SEE_OFF : see;
            d->wish.frame_index = (uint32_t)(i + 2);
            glFinish();
            double start = now_ms();
            dynamic_draw(h, d);
            glFinish();
            if (i >= 0)
                times[k][i] = now_ms() - start;
        }
    *ms = median(times[0], (size_t)frames);
    *opaque = median(times[1], (size_t)frames);
    d->wish.see = see;
}

/* Dithering is right on average: of that many frames. */
enum { DITHER_FRAMES = 64 };

static double *mean_picture(harness *h, dynamic_scene *d, int frames) {
    size_t count = 4 * (size_t)d->scene.width * (size_t)d->scene.height;
    double *sum = need(count * sizeof *sum);
    for (size_t i = 0; i < count; ++i)
        sum[i] = 0;
    for (int f = 0; f < frames; ++f) {
        d->wish.frame_index = (uint32_t)f;
        dynamic_draw(h, d);
        unsigned char *pixels = dynamic_read(h, d);
        for (size_t i = 0; i < count; ++i)
            sum[i] += (double)pixels[i] / frames;
        free(pixels);
    }
    return sum;
}

static void run_subject(harness *h, dynamic_scene *d, const char *scene_name, const subject *s,
                        const ref_dyn_pixel *truth, bool quick, FILE *csv) {
    double ms, opaque;
    bool slow = s->see == TR_SEE_SEQUENCE || s->see == TR_SEE_PUBLISHED || s->see == TR_SEE_EXACT;
    d->wish.see = s->see;
    d->wish.in_parts = s->in_parts;
    if (!dynamic_can(h, d)) {
        printf("%-12s %-13s not there\n", scene_name, s->name);
        return;
    }
    time_subject(h, d, s->see, quick ? 3 : slow ? 5 : 15, &ms, &opaque);
    double *mean = mean_picture(h, d, s->see == TR_SEE_DITHER ? (quick ? 16 : DITHER_FRAMES) : 1);
    dynamic_error one = dynamic_compare_mean(d, truth, mean, DYNAMIC_ONE_OCCLUDER);
    dynamic_error each = dynamic_compare_mean(d, truth, mean, DYNAMIC_ONE_OF_EACH);
    dynamic_error all = dynamic_compare_mean(d, truth, mean, DYNAMIC_ALL);
    const tr_see_plan *plan = tr_get_info(h->tr).see_plan;
    printf("%-12s %-13s %9.2f ms %6.2fx opaque  masks %4.1f %%  one occluder: mean %5.2f max %6.1f  and one mask: mean "
           "%5.2f max %6.1f  all: mean %5.2f  "
           "%2d passes %9llu bytes\n",
           scene_name, s->name, ms, ms / opaque, 100 * (double)plan->covered, one.mean, one.largest, each.mean,
           each.largest, all.mean, plan->pass_count, (unsigned long long)plan->bytes);
    fprintf(csv, "dynamic,%s,%dx%d,%s,%.3f,%llu,%.3f\n", scene_name, d->scene.width, d->scene.height, s->name, ms,
            (unsigned long long)plan->bytes, one.largest);
    fflush(stdout);
    free(mean);
}

static void run_forest(harness *h, FILE *csv, bool quick) {
    static const size_t numbers[] = {500, 200, 50, 10, 1};
    dynamic_scene d;
    dynamic_open(&d, h, forest_make());
    dynamic_look(&d, FOREST_EYE, FOREST_AT, FOREST_FOV, 1280, 1024);
    harness_target(h, 1280, 1024);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i += quick ? 2 : 1) {
        char name[32];
        forest_choose_targets(&d, numbers[i]);
        ref_dyn_census *census = dynamic_need(d.count * sizeof *census);
        ref_dyn_pixel *truth = dynamic_truth(&d, census);
        snprintf(name, sizeof name, "forest_%zu", numbers[i]);
        printf("\n%-12s masks cover %.1f %% of the picture\n", name, 100 * mask_share(&d, truth));
        print_found(&d, name, census);
        for (int s = 0; s < SUBJECTS; ++s)
            run_subject(h, &d, name, &subjects[s], truth, quick, csv);
        free(truth);
        free(census);
    }
    dynamic_close(&d);
}

/* ---- the paper's table ---- */

static void run_table(harness *h, FILE *csv, bool quick) {
    static const char *const names[2] = {"abstract", "walkthrough"};
    static const int sizes[2][2] = {{800, 600}, {1280, 1024}};
    printf("\nTable 1 of the paper, frames a second\n%-12s %-10s %10s %10s %10s %10s\n", "scene", "size", "no",
           "published", "onemask", "dither");
    for (int k = 0; k < 2; ++k) {
        battlefield *b = k ? battlefield_create_walkthrough(1) : battlefield_create_abstract(1);
        dynamic_scene d;
        for (size_t i = 0; i < b->scene->part_count; ++i)
            b->scene->parts[i].hidden = false;
        dynamic_open(&d, h, b);
        d.wish.in_parts = 1; /* of those that can */
        for (int size = 0; size < (quick ? 1 : 2); ++size) {
            static const tr_see sees[4] = {TR_SEE_OFF, TR_SEE_PUBLISHED, TR_SEE_ONE_MASK, TR_SEE_DITHER};
            dynamic_look(&d, b->eye, b->look_at, k ? 65 : 45, sizes[size][0], sizes[size][1]);
            harness_target(h, sizes[size][0], sizes[size][1]);
            printf("%-12s %4dx%-5d", names[k], sizes[size][0], sizes[size][1]);
            for (int i = 0; i < 4; ++i) {
                double ms = 0, opaque;
                d.wish.see = sees[i];
                if (dynamic_can(h, &d))
                    time_subject(h, &d, sees[i], quick ? 5 : 9, &ms, &opaque);
                printf(" %10.1f", ms > 0 ? 1000 / ms : 0);
                fprintf(csv, "table1,%s,%dx%d,%s,%.3f,0,0\n", names[k], sizes[size][0], sizes[size][1],
                        (const char *[]){"opaque", "published", "onemask", "dither"}[i], ms);
            }
            printf("\n");
        }
        ref_dyn_census *census = dynamic_need(d.count * sizeof *census);
        ref_dyn_pixel *truth = dynamic_truth(&d, census);
        print_found(&d, names[k], census);
        free(truth);
        free(census);
        dynamic_close(&d);
    }
}

int main(int argc, char **argv) {
    FILE *csv = open_table(argc, argv, "build/bench/dynamic.csv");
    harness h;
    harness_open(&h, 450, false, NULL);
    printf("driver: %s\n", h.context.renderer);
    run_forest(&h, csv, is_quick());
    run_table(&h, csv, is_quick());
    harness_close(&h);
    return close_table(csv);
}

/* view_dependent: what view-dependent transparency costs: a gearbox and a crank drawn opaque, with implicit interiors
 * (mended and as published) and with explicit ones, by the built-in programs, without lines.
 *
 * usage: view_dependent [FILE.csv]       BENCH=quick: fewer frames and one size
 *
 * Milliseconds are medians of whole frames by the wall clock around glFinish. error_max is in 1/255 against the
 * reference in double precision, pixels near edges left out. */
#include "bench.h"
#include "stage.h"

#include "models.h"

static double measure(harness *h, stage *s, int frames, double *error) {
    size_t pixels = (size_t)s->scene.width * (size_t)s->scene.height;
    double times[64];
    unsigned char *picture = malloc(4 * pixels);
    ref_pixel *truth = malloc(pixels * sizeof *truth);
    for (int i = -2; i < frames; ++i) { /* two to warm up */
        harness_clear(h, s->scene.background, 1.0f);
        glFinish();
        double start = now_ms();
        harness_draw(h, &s->scene, s->objects, s->count, NULL, NULL);
        glFinish();
        if (i >= 0)
            times[i] = now_ms() - start;
    }
    harness_clear(h, s->scene.background, 1.0f);
    harness_draw(h, &s->scene, s->objects, s->count, NULL, picture);
    *error = ref_render(&s->scene, truth) ? harness_compare(&s->scene, truth, picture).max : -1;
    free(picture);
    free(truth);
    return median(times, (size_t)frames);
}

static void run_scene(harness *h, const char *name, FILE *csv, bool quick) {
    static const char *const subjects[] = {"opaque", "implicit", "implicit_published", "explicit"};
    static const int sizes[] = {512, 1024};
    static stage s;
    scene *model = models_make(name);
    if (!model)
        return;
    stage_set(&s, model);
    for (size_t i = 0; i < s.count; ++i)
        s.objects[i].truth.alpha = s.truths[i].transparent ? 0.5 : 1.0;
    for (int size = 0; size < (quick ? 1 : 2); ++size) {
        double opaque_ms = 0;
        s.scene.width = s.scene.height = sizes[size];
        harness_target(h, sizes[size], sizes[size]);
        for (int subject = 0; subject < 4; ++subject) {
            double error;
            stage_make_opaque(&s, subject == 0);
            s.scene.interior = (ref_interior)(subject ? subject - 1 : 0);
            double ms = measure(h, &s, quick ? 9 : 31, &error);
            if (subject == 0)
                opaque_ms = ms;
            unsigned long long bytes = (unsigned long long)tr_get_info(h->tr).plan->bytes_per_pixel *
                                       (unsigned long long)sizes[size] * (unsigned long long)sizes[size];
            printf("%-10s %5d  %-20s %9.2f ms  %5.2fx  %9llu bytes  error %.2f/255\n", name, sizes[size],
                   subjects[subject], ms, ms / opaque_ms, bytes, error);
            fprintf(csv, "view_dependent,%s,%d,%s,%.3f,%llu,%.3f\n", name, sizes[size], subjects[subject], ms, bytes,
                    error);
        }
    }
    stage_clear(&s);
    scene_destroy(model);
}

int main(int argc, char **argv) {
    FILE *csv = open_table(argc, argv, "build/bench/view_dependent.csv");
    harness h;
    harness_open(&h, 450, false, NULL);
    printf("driver: %s\n", h.context.renderer);
    run_scene(&h, "crank", csv, is_quick());
    run_scene(&h, "gearbox", csv, is_quick());
    harness_close(&h);
    return close_table(csv);
}

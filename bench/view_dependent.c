/* view_dependent: what view-dependent transparency costs: models, and scenes of the sizes in table 1 of the paper, drawn
 * opaque, with implicit interiors (mended and as published), explicit ones, several layers and a group, by the built-in
 * programs, without lines.
 *
 * usage: view_dependent [FILE.csv]       BENCH=quick: fewer frames and one size
 *
 * Milliseconds are medians of whole frames by the wall clock around glFinish. error_max is in 1/255 against the
 * reference in double precision, pixels near edges left out. */
#include "bench.h"
#include "stage.h"

#include "models.h"

static void upload_stage(stage *s) {
    for (size_t i = 0; i < s->count; ++i) {
        s->objects[i].truth = s->truths[i];
        harness_upload(&s->objects[i], NULL);
    }
    for (int k = 0; k < 3; ++k)
        s->scene.background[k] = 1;
    s->scene.blending = REF_BLEND_OVER;
    s->scene.objects = s->truths;
    s->scene.object_count = s->count;
}

/* A ball of rings by sectors quads, arrays of its own. */
static void make_ball(ref_object *o, int rings, int sectors, const double center[3], double radius) {
    size_t vertices = (size_t)(rings + 1) * (size_t)sectors, count = 0;
    float *v = malloc(vertices * 6 * sizeof *v), *n = v + 3 * vertices;
    uint32_t *t = malloc((size_t)rings * (size_t)sectors * 6 * sizeof *t);
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            double polar = 3.14159265358979 * i / rings, turn = 6.28318530717959 * j / sectors;
            const double d[3] = {sin(polar) * cos(turn), cos(polar), -sin(polar) * sin(turn)};
            for (int k = 0; k < 3; ++k) {
                v[3 * (i * sectors + j) + k] = (float)(center[k] + radius * d[k]);
                n[3 * (i * sectors + j) + k] = (float)d[k];
            }
        }
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            uint32_t a = (uint32_t)(i * sectors + j), b = (uint32_t)(i * sectors + (j + 1) % sectors);
            const uint32_t row = (uint32_t)sectors, quad[6] = {a, a + row, b + row, a, b + row, b};
            memcpy(t + count, quad, sizeof quad);
            count += 6;
        }
    o->positions = v;
    o->normals = n;
    o->indices = t;
    o->vertex_count = vertices;
    o->triangle_count = count / 3;
}

typedef struct table_row {
    const char *name;
    int glass[2], solid[2], solids; /* rings and sectors of the transparent ball, of each opaque one */
} table_row;

/* Table 1: 25,192 polygons of which 192 are transparent, 40,000 of which 835, 70,955 of which 3,112; as near as balls
 * come: the transparent ones are four balls one in the other. */
static const table_row table[] = {
    {"table1_25k", {8, 12}, {50, 50}, 5}, {"table1_40k", {19, 22}, {70, 70}, 4}, {"table1_71k", {28, 56}, {65, 65}, 8}};
enum { ROWS = sizeof table / sizeof table[0] };

static void set_row(stage *s, const table_row *row) {
    memset(s, 0, sizeof *s);
    for (int i = 0; i < 4 + row->solids; ++i) {
        ref_object *o = &s->truths[s->count++];
        double turn = i * 2.4, spread = i < 4 ? 0.15 * i : 0.55;
        const double center[3] = {spread * cos(turn), 0.12 * (i % 5 - 2), spread * sin(turn)};
        for (int k = 0; k < 4; ++k)
            o->model[5 * k] = 1;
        o->id = (uint32_t)s->count;
        o->transparent = i < 4;
        o->group = i < 4;
        o->alpha = i < 4 ? 0.5 : 1;
        o->color[i % 3] = 0.8;
        o->color[(i + 1) % 3] = 0.4;
        if (i < 4)
            make_ball(o, row->glass[0] / 2, row->glass[1] / 2, center, 1.5 - 0.15 * i);
        else
            make_ball(o, row->solid[0], row->solid[1], center, 0.28);
        s->triangles += o->triangle_count;
    }
    const double view[16] = {1, 0, 0, 0, 0, 0.94, 0.34, 0, 0, -0.34, 0.94, 0, 0, 0, -4.5, 1};
    const double n = 1, f = 10, half = 0.42;
    const double projection[16] = {
        1 / half, 0, 0, 0, 0, 1 / half, 0, 0, 0, 0, -(f + n) / (f - n), -1, 0, 0, -2 * f * n / (f - n), 0};
    memcpy(s->scene.view, view, sizeof view);
    memcpy(s->scene.projection, projection, sizeof projection);
    upload_stage(s);
}

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

typedef struct subject {
    const char *name;
    ref_interior interior;
    int layers;
    bool grouped;
} subject;

static const subject subjects[] = {{"opaque", REF_INTERIOR_IMPLICIT, 0, false},
                                   {"implicit", REF_INTERIOR_IMPLICIT, 0, false},
                                   {"implicit_published", REF_INTERIOR_IMPLICIT_PUBLISHED, 0, false},
                                   {"explicit", REF_INTERIOR_EXPLICIT, 0, false},
                                   {"layers_2", REF_INTERIOR_LAYERS, 2, false},
                                   {"layers_4", REF_INTERIOR_LAYERS, 4, false},
                                   {"group", REF_INTERIOR_IMPLICIT, 4, true}};
enum { SUBJECTS = sizeof subjects / sizeof subjects[0] };

static void set_subject(stage *s, int index) {
    stage_make_opaque(s, index == 0);
    s->scene.interior = subjects[index].interior;
    s->scene.layers = subjects[index].layers;
    for (size_t i = 0; i < s->count; ++i) {
        s->truths[i].group = subjects[index].grouped;
        if (s->truths[i].transparent)
            s->objects[i].object.flags |= TR_GROUP(subjects[index].grouped);
    }
}

static void run_stage(harness *h, const char *name, stage *s, FILE *csv, bool quick) {
    static const int sizes[] = {512, 1024};
    for (int size = 0; size < (quick ? 1 : 2); ++size) {
        double opaque_ms = 0;
        s->scene.width = s->scene.height = sizes[size];
        harness_target(h, sizes[size], sizes[size]);
        for (int i = 0; i < SUBJECTS; ++i) {
            double error;
            set_subject(s, i);
            double ms = measure(h, s, quick ? 9 : 31, &error);
            if (i == 0)
                opaque_ms = ms;
            const tr_plan *plan = tr_get_info(h->tr).plan;
            unsigned long long bytes = (unsigned long long)plan->bytes_per_pixel * (unsigned long long)sizes[size] *
                                       (unsigned long long)sizes[size];
            printf("%-10s %5d  %-18s %9.2f ms %6.0f/s  %5.2fx  %2d passes %9llu bytes  error %.2f/255\n", name,
                   sizes[size], subjects[i].name, ms, 1000 / ms, ms / opaque_ms, plan->pass_count, bytes, error);
            fprintf(csv, "view_dependent,%s,%d,%s,%.3f,%llu,%.3f\n", name, sizes[size], subjects[i].name, ms, bytes,
                    error);
        }
    }
    stage_clear(s);
}

static void run_scene(harness *h, const char *name, FILE *csv, bool quick) {
    static stage s;
    scene *model = models_make(name);
    if (!model)
        return;
    stage_set(&s, model);
    for (size_t i = 0; i < s.count; ++i)
        s.objects[i].truth.alpha = s.truths[i].transparent ? 0.5 : 1.0;
    run_stage(h, name, &s, csv, quick);
    scene_destroy(model);
}

static void run_row(harness *h, const table_row *row, FILE *csv, bool quick) {
    static stage s;
    set_row(&s, row);
    run_stage(h, row->name, &s, csv, quick);
    for (size_t i = 0; i < s.count; ++i) {
        free((void *)(uintptr_t)s.truths[i].positions);
        free((void *)(uintptr_t)s.truths[i].indices);
    }
}

int main(int argc, char **argv) {
    FILE *csv = open_table(argc, argv, "build/bench/view_dependent.csv");
    harness h;
    harness_open(&h, 450, false, NULL);
    printf("driver: %s\n", h.context.renderer);
    run_scene(&h, "crank", csv, is_quick());
    run_scene(&h, "gearbox", csv, is_quick());
    for (int i = 0; i < ROWS; ++i)
        run_row(&h, &table[i], csv, is_quick());
    harness_close(&h);
    return close_table(csv);
}

/* view_dependent: what view-dependent transparency costs: a gearbox and a crank drawn opaque, with implicit interiors
 * (mended and as published) and with explicit ones, by the built-in programs, without lines.
 *
 * usage: view_dependent [FILE.csv]       BENCH=quick: fewer frames and one size
 *
 * Milliseconds are medians of whole frames by the wall clock around glFinish. error_max is in 1/255 against the
 * reference in double precision, pixels near edges left out. */
#include "../tests/gl_harness.h"
#include "bench.h"

#include "models.h"
#include "scene.h"

enum { MAX_PARTS = 256 };

typedef struct stage {
    ref_scene scene;
    ref_object truths[MAX_PARTS];
    harness_object objects[MAX_PARTS];
    size_t count, triangles;
} stage;

/* Seen from the front, a little from above, so that the model fills the picture. */
static void look_at(stage *s, const scene *model) {
    double low[3], high[3], radius = 0, center[3];
    scene_bounds(model, low, high);
    for (int k = 0; k < 3; ++k) {
        center[k] = 0.5 * (low[k] + high[k]);
        radius += 0.25 * (high[k] - low[k]) * (high[k] - low[k]);
    }
    radius = sqrt(radius);
    const double c = 0.906, r = 0.423; /* 25 degrees about x, after 25 about y */
    const double rows[3][3] = {{c, 0, -r}, {-r * r, c, -c * r}, {c * r, r, c * c}};
    memset(s->scene.view, 0, sizeof s->scene.view);
    for (int row = 0; row < 3; ++row) {
        s->scene.view[12 + row] = row == 2 ? -3 * radius : 0;
        for (int k = 0; k < 3; ++k) {
            s->scene.view[4 * k + row] = rows[row][k];
            s->scene.view[12 + row] -= rows[row][k] * center[k];
        }
    }
    s->scene.view[15] = 1;
    const double n = radius, f = 6 * radius, half = 0.36;
    const double projection[16] = {
        1 / half, 0, 0, 0, 0, 1 / half, 0, 0, 0, 0, -(f + n) / (f - n), -1, 0, 0, -2 * f * n / (f - n), 0};
    memcpy(s->scene.projection, projection, sizeof projection);
}

static void set_stage(stage *s, const scene *model) {
    memset(s, 0, sizeof *s);
    for (size_t i = 0; i < model->part_count && s->count < MAX_PARTS; ++i) {
        const scene_part *part = &model->parts[i];
        const scene_mesh *mesh = &model->meshes[part->mesh];
        ref_object *o = &s->truths[s->count++];
        memcpy(o->model, part->transform, sizeof o->model);
        for (int k = 0; k < 3; ++k)
            o->color[k] = (double)part->color[k];
        o->id = (uint32_t)s->count;
        o->transparent = part->opacity < 1.0f;
        o->alpha = 0.5;
        o->positions = mesh->positions;
        o->normals = mesh->normals;
        o->indices = mesh->indices;
        o->vertex_count = mesh->vertex_count;
        o->triangle_count = mesh->index_count / 3;
        s->triangles += o->triangle_count;
    }
    for (size_t i = 0; i < s->count; ++i) {
        s->objects[i].truth = s->truths[i];
        harness_upload(&s->objects[i], NULL);
    }
    for (int k = 0; k < 3; ++k)
        s->scene.background[k] = 1;
    s->scene.blending = REF_BLEND_OVER;
    s->scene.objects = s->truths;
    s->scene.object_count = s->count;
    look_at(s, model);
}

static void make_opaque(stage *s, bool opaque) {
    for (size_t i = 0; i < s->count; ++i) {
        s->truths[i].transparent = !opaque && s->objects[i].truth.alpha < 0.75;
        s->objects[i].object.flags = s->truths[i].transparent ? (uint32_t)TR_TRANSPARENT : 0u;
    }
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

static void run_scene(harness *h, const char *name, FILE *csv, bool quick) {
    static const char *const subjects[] = {"opaque", "implicit", "implicit_published", "explicit"};
    static const int sizes[] = {512, 1024};
    static stage s;
    scene *model = models_make(name);
    if (!model)
        return;
    set_stage(&s, model);
    for (size_t i = 0; i < s.count; ++i)
        s.objects[i].truth.alpha = s.truths[i].transparent ? 0.5 : 1.0;
    for (int size = 0; size < (quick ? 1 : 2); ++size) {
        double opaque_ms = 0;
        s.scene.width = s.scene.height = sizes[size];
        harness_target(h, sizes[size], sizes[size]);
        for (int subject = 0; subject < 4; ++subject) {
            double error;
            make_opaque(&s, subject == 0);
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
    for (size_t i = 0; i < s.count; ++i)
        harness_drop_object(&s.objects[i]);
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

/* accuracy: what accuracy costs in time. Every knob over procedural and, when ../shared/models is there, real scenes.
 *
 * usage: accuracy [FOLDER]       writes FOLDER/accuracy.csv (default build/accuracy) and, where there is gnuplot, a picture
 * an effect: error against time, the points that no other beats in both joined by a line; and FOLDER/found.csv: how many
 * targets of dynamic transparency are found. ACCURACY=quick: fewer frames. ACCURACY_ONLY=alpha, pictures, dynamic or smart:
 * that part alone.
 *
 * error_max and error_rms are in 1/255 against double precision: alpha against the distance to the nearest of all
 * silhouettes at each pixel, pictures against tests/reference.h; stores of fragments and smart transparency: see
 * accuracy_smart.h. Milliseconds are medians by the wall clock around
 * glFinish; bytes are what the setting needs on the GPU beyond the mesh and the target. */
#define _POSIX_C_SOURCE 200809L
#define FIELD_SIZE 512
#define FIELD_STEP 3
/* Before scene.h and alpha_field.h, whose names are those of their variables. */
#include "../tests/reference_dynamic.h"

#include "accuracy_smart.h"

#include "../tests/alpha_field.h"

#include "bench.h"
#include "forest.h"
#include "stage.h"

#include "load_model.h"
#include "models.h"
#include "refine.h"

#include <sys/stat.h>

/* ---- the table ---- */

typedef struct row {
    char effect[24], scene[32], setting[32];
    double ms, error_max, error_rms;
    unsigned long long bytes;
} row;

enum { MAX_ROWS = 1024 };

static row rows[MAX_ROWS];
static size_t row_count;

static void add_row(const char *effect, const char *scene_name, const char *setting, double ms, double error_max,
                    double error_rms, unsigned long long bytes) {
    if (row_count == MAX_ROWS)
        return;
    row *r = &rows[row_count++];
    snprintf(r->effect, sizeof r->effect, "%s", effect);
    snprintf(r->scene, sizeof r->scene, "%s", scene_name);
    snprintf(r->setting, sizeof r->setting, "%s", setting);
    r->ms = ms;
    r->error_max = error_max;
    r->error_rms = error_rms;
    r->bytes = bytes;
    printf("%-16s %-14s %-24s %9.2f ms  max %8.3f  rms %8.4f  %10llu bytes\n", effect, scene_name, setting, ms,
           error_max, error_rms, bytes);
    fflush(stdout);
}

static bool write_table(const char *folder) {
    char path[512];
    snprintf(path, sizeof path, "%s/accuracy.csv", folder);
    FILE *csv = fopen(path, "w");
    if (!csv) {
        fprintf(stderr, "accuracy: cannot write %s\n", path);
        return false;
    }
    fputs("effect,scene,setting,milliseconds,error_max,error_rms,bytes\n", csv);
    for (size_t i = 0; i < row_count; ++i)
        fprintf(csv, "%s,\"%s\",\"%s\",%.4f,%.4f,%.5f,%llu\n", rows[i].effect, rows[i].scene, rows[i].setting,
                rows[i].ms, rows[i].error_max, rows[i].error_rms, rows[i].bytes);
    return fclose(csv) == 0;
}

/* ---- pictures ---- */

static bool is_first(size_t at, bool of_scene) {
    for (size_t i = 0; i < at; ++i)
        if (strcmp(rows[i].effect, rows[at].effect) == 0 && (!of_scene || strcmp(rows[i].scene, rows[at].scene) == 0))
            return false;
    return true;
}

static bool is_beaten(size_t at) {
    for (size_t i = 0; i < row_count; ++i)
        if (strcmp(rows[i].effect, rows[at].effect) == 0 && strcmp(rows[i].scene, rows[at].scene) == 0 && i != at &&
            rows[i].ms <= rows[at].ms && rows[i].error_rms <= rows[at].error_rms &&
            (rows[i].ms < rows[at].ms || rows[i].error_rms < rows[at].error_rms))
            return true;
    return false;
}

static int by_time(const void *a, const void *b) {
    const row *p = &rows[*(const size_t *)a], *q = &rows[*(const size_t *)b];
    return p->ms < q->ms ? -1 : p->ms > q->ms;
}

/* The points of one scene, or those that no other beats, as a block of gnuplot's data; the quickest first. */
static void put_block(FILE *to, size_t like, bool frontier) {
    size_t found[MAX_ROWS], count = 0;
    for (size_t i = 0; i < row_count; ++i)
        if (strcmp(rows[i].effect, rows[like].effect) == 0 && strcmp(rows[i].scene, rows[like].scene) == 0 &&
            (!frontier || !is_beaten(i)))
            found[count++] = i;
    qsort(found, count, sizeof *found, by_time);
    for (size_t i = 0; i < count; ++i) {
        const row *r = &rows[found[i]];
        fprintf(to, "%g %g \"%s\"\n", r->ms, fmax(r->error_rms, 1e-4), r->setting);
    }
    fputs("e\n", to);
}

/* With more scenes than two the names of all points would lie on each other: then of those that nothing beats. */
static void plot_effect(const char *folder, size_t like) {
    FILE *gnuplot = popen("gnuplot", "w");
    if (!gnuplot)
        return;
    fprintf(
        gnuplot,
        "set terminal pngcairo noenhanced size 1100,760 font 'sans,11'\nset output '%s/%s.png'\nset logscale xy\n"
        "set title '%s: error against time; lines join what nothing beats in both'\n"
        "set xlabel 'milliseconds'\nset ylabel 'error, root mean square, in 1/255 (1e-4: none)'\n"
        "set format y '%%g'\nset offsets graph 0.12, graph 0.2, graph 0.1, graph 0.1\nset key outside right\nset grid\nplot ",
        folder, rows[like].effect, rows[like].effect);
    int color = 0;
    for (size_t i = 0; i < row_count; ++i)
        if (strcmp(rows[i].effect, rows[like].effect) == 0 && is_first(i, true)) {
            fprintf(gnuplot,
                    "%s'-' using 1:2 with lines linewidth 2 linecolor %d title '%s', "
                    "'-' using 1:2 with points pointtype 7 linecolor %d notitle, "
                    "'-' using 1:2:3 with labels left offset 0.7,0.4 font ',8' textcolor linestyle %d notitle",
                    color ? ", " : "", color + 1, rows[i].scene, color + 1, color + 1);
            ++color;
        }
    fputs("\n", gnuplot);
    for (size_t i = 0; i < row_count; ++i)
        if (strcmp(rows[i].effect, rows[like].effect) == 0 && is_first(i, true)) {
            put_block(gnuplot, i, true);
            put_block(gnuplot, i, false);
            put_block(gnuplot, i, color > 2);
        }
    if (pclose(gnuplot) != 0)
        fprintf(stderr, "accuracy: gnuplot failed on %s\n", rows[like].effect);
}

static void plot(const char *folder) {
    if (system("command -v gnuplot >/dev/null 2>&1") != 0) {
        puts("accuracy: no gnuplot, no pictures");
        return;
    }
    for (size_t i = 0; i < row_count; ++i)
        if (is_first(i, false))
            plot_effect(folder, i);
}

/* ---- alpha: the ladder ---- */

static int frames(void) {
    const char *mode = getenv("ACCURACY");
    return mode && strcmp(mode, "quick") == 0 ? 5 : 15;
}

static bool wants(const char *part) {
    const char *only = getenv("ACCURACY_ONLY");
    return !only || strcmp(only, part) == 0;
}

static const char *const rung_names[TR_ALPHA_COUNT] = {"distance at vertices", "published", "candidates", "exact",
                                                       "image"};

static void draw_once(harness *h, const field *f, tr_alpha alpha, const tr_edge_set *set) {
    tr_frame frame = field_frame_of(h, alpha);
    tr_material material = field_material_of(f, set);
    const double white[3] = {1, 1, 1};
    tr_pass pass;
    harness_clear(h, white, 1.0f);
    if (tr_begin(h->tr, &frame) != TR_OK)
        return;
    while (tr_next_pass(h->tr, &pass)) {
        tr_set_material(h->tr, &pass, &material);
        field_draw(f, alpha);
    }
    tr_end(h->tr);
    glFinish();
}

/* What the CPU does for a rung when the eye has moved: silhouettes, then distances or lists, then the upload. */
static void follow_eye(harness *h, field *f, tr_alpha alpha, sil_edge_tree *tree, size_t capacity, tr_edge_set *set) {
    sil_view view = sil_view_perspective(f->eye);
    sil_distance_desc desc;
    size_t needed = 0;
    memset(&desc, 0, sizeof desc);
    memcpy(desc.model, f->linear, sizeof desc.model);
    f->edge_count = sil_extract(f->mesh, NULL, &view, SIL_SILHOUETTE | SIL_BOUNDARY, f->edges, f->edge_count);
    sil_edge_tree_build(tree, NULL, f->edges, f->edge_count, &desc);
    if (alpha == TR_ALPHA_CANDIDATES)
        sil_candidates(tree, f->positions, 0, f->vertex_count, f->indices, f->triangle_count, f->offsets, f->candidates,
                       capacity, &needed);
    if (alpha == TR_ALPHA_EXACT)
        sil_edge_tree_order(tree, f->order, f->edge_count);
    if (alpha >= TR_ALPHA_CANDIDATES) {
        tr_edges edges = field_edges_of(f, alpha);
        tr_set_edges(h->tr, &edges, 1, set);
        return;
    }
    sil_distances_by_tree(tree, 0, f->vertex_count, f->distances, NULL);
    glBindBuffer(GL_ARRAY_BUFFER, f->buffers[1]);
    glBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)(f->vertex_count * sizeof *f->distances), f->distances);
}

static void time_rung(harness *h, field *f, tr_alpha alpha, double *still, double *moving) {
    double times[2][64];
    tr_edge_set set;
    tr_edges edges = field_edges_of(f, alpha);
    sil_edge_tree *tree = sil_edge_tree_create(f->mesh, NULL);
    int count = frames();
    tr_set_edges(h->tr, &edges, 1, &set);
    for (int i = -2; i < 2 * count; ++i) { /* two to warm up */
        double start = now_ms();
        if (i >= count)
            follow_eye(h, f, alpha, tree, f->candidate_count, &set);
        draw_once(h, f, alpha, &set);
        if (i >= 0)
            times[i >= count][i % count] = now_ms() - start;
    }
    *still = median(times[0], (size_t)count);
    *moving = median(times[1], (size_t)count);
    sil_edge_tree_destroy(tree);
}

static field_verdict judge_rung(harness *h, const field *f, tr_alpha alpha) {
    static float out[FIELD_PIXELS];
    tr_edge_set set;
    tr_edges edges = field_edges_of(f, alpha);
    tr_set_edges(h->tr, &edges, 1, &set);
    field_draw_own(h, f, alpha, &set, out);
    return field_judge(f, out);
}

/* Of the arrays that a rung needs beyond the mesh: an attribute, or textures; without indices there is more to a mesh. */
static unsigned long long rung_bytes(harness *h, const field *f, tr_alpha alpha) {
    unsigned long long before, corners = 3 * f->triangle_count;
    tr_edge_set set;
    tr_edges edges = field_edges_of(f, alpha);
    if (alpha < TR_ALPHA_CANDIDATES)
        return 4 * f->vertex_count;
    tr_set_edges(h->tr, NULL, 0, NULL);
    before = tr_get_info(h->tr).bytes;
    tr_set_edges(h->tr, &edges, 1, &set);
    return tr_get_info(h->tr).bytes - before + (alpha == TR_ALPHA_CANDIDATES ? 16 * corners : 0);
}

static void run_rung(harness *h, const char *name, field *f, tr_alpha alpha, const char *setting) {
    double still, moving;
    time_rung(h, f, alpha, &still, &moving);
    field_verdict v = judge_rung(h, f, alpha);
    unsigned long long bytes = rung_bytes(h, f, alpha);
    add_row("alpha", name, setting, still, 255 * v.max, 255 * v.rms, bytes);
    add_row("alpha_moving", name, setting, moving, 255 * v.max, 255 * v.rms, bytes);
}

/* The image-space rung: what the eye sees, and its outlines, are found anew when it moves. */
static void run_image(harness *h, const char *name, const field *f) {
    static float out[FIELD_PIXELS];
    double times[2][64];
    field_verdict v = field_measure_image(h, f, out);
    int count = frames();
    for (int i = -2; i < count; ++i) {
        double start = now_ms(), drawn;
        tr_outlines image;
        GLuint depth = field_draw_image(h, f, &image);
        tr_find_outlines(h->tr, &image);
        glFinish();
        drawn = now_ms();
        draw_once(h, f, TR_ALPHA_IMAGE, NULL);
        if (i >= 0) {
            times[0][i] = now_ms() - drawn;
            times[1][i] = now_ms() - start;
        }
        glDeleteTextures(1, &depth);
    }
    add_row("alpha", name, rung_names[TR_ALPHA_IMAGE], median(times[0], (size_t)count), 255 * v.max, 255 * v.rms,
            8ull * FIELD_PIXELS);
    add_row("alpha_moving", name, rung_names[TR_ALPHA_IMAGE], median(times[1], (size_t)count), 255 * v.max, 255 * v.rms,
            8ull * FIELD_PIXELS);
}

static size_t largest_mesh(const scene *model) {
    size_t largest = 0;
    for (size_t i = 1; i < model->mesh_count; ++i)
        if (model->meshes[i].index_count > model->meshes[largest].index_count)
            largest = i;
    return largest;
}

static double diagonal_of(const scene_mesh *mesh) {
    double square = 0;
    for (size_t k = 0; k < 3; ++k) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t i = 0; i < mesh->vertex_count; ++i) {
            low = fmin(low, (double)mesh->positions[3 * i + k]);
            high = fmax(high, (double)mesh->positions[3 * i + k]);
        }
        square += (high - low) * (high - low);
    }
    return sqrt(square);
}

static void run_alpha(harness *h, const char *name, const scene_mesh *mesh) {
    static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    static const double turn[2] = {0.6, 0.5};
    scene_mesh fine;
    field f;
    field_open(&f, mesh, identity, turn);
    field_upload(&f);
    printf("%s: %zu triangles, %zu silhouettes, %.1f candidates a triangle\n", name, f.triangle_count, f.edge_count,
           (double)f.candidate_count / (double)f.triangle_count);
    for (int alpha = 0; alpha < TR_ALPHA_IMAGE; ++alpha)
        run_rung(h, name, &f, (tr_alpha)alpha, rung_names[alpha]);
    run_image(h, name, &f);
    for (int k = 1; k <= 5; ++k) { /* the steeper the law at the outline, the more a coarse distance shows */
        char setting[32];
        double still, moving;
        f.k = 0.2f * (float)k;
        field_find_truth(&f);
        time_rung(h, &f, TR_ALPHA_DISTANCE, &still, &moving);
        field_verdict v = judge_rung(h, &f, TR_ALPHA_DISTANCE);
        snprintf(setting, sizeof setting, "k %.1f", (double)f.k);
        add_row("alpha_k", name, setting, still, 255 * v.max, 255 * v.rms, 4 * f.vertex_count);
    }
    field_close(&f);
    /* What illustrate once did for the sake of the first rungs: no edge longer than a fortieth of the object. */
    if (!refine_mesh(mesh, diagonal_of(mesh) / 40, 400000, &fine))
        return;
    field_open(&f, &fine, identity, turn);
    field_upload(&f);
    run_rung(h, name, &f, TR_ALPHA_DISTANCE, "distance, refined");
    field_close(&f);
    free(fine.positions);
    free(fine.normals);
    free(fine.colors);
    free(fine.indices);
}

/* ---- pictures: interior methods, layers and blendings ---- */

static double rms_of(const ref_scene *seen, const ref_pixel *truth, const unsigned char *pixels) {
    double sum = 0, count = 0;
    for (size_t i = 0; i < (size_t)seen->width * (size_t)seen->height; ++i)
        for (size_t c = 0; c < 3 && !truth[i].left_out; ++c, ++count) {
            double difference = truth[i].color[c] * 255.0 - pixels[4 * i + c];
            sum += difference * difference;
        }
    return count > 0 ? sqrt(sum / count) : 0;
}

/* The error is against the same rule, but that of few layers against as many as there can be. */
static void run_picture(harness *h, stage *s, const char *effect, const char *name, const char *setting) {
    size_t pixels = (size_t)s->scene.width * (size_t)s->scene.height;
    double times[64];
    unsigned char *picture = need(4 * pixels);
    ref_pixel *truth = need(pixels * sizeof *truth);
    int count = frames();
    for (int i = -2; i < count; ++i) {
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
    s->scene.layers = s->scene.layers ? REF_MAX_LAYERS : 0;
    if (ref_render(&s->scene, truth))
        add_row(effect, name, setting, median(times, (size_t)count), harness_compare(&s->scene, truth, picture).max,
                rms_of(&s->scene, truth, picture),
                (unsigned long long)tr_get_info(h->tr).plan->bytes_per_pixel * (unsigned long long)pixels);
    free(picture);
    free(truth);
}

static void run_pictures(harness *h, const char *name, const scene *model) {
    static const char *const interiors[] = {"implicit", "implicit published", "explicit"};
    static const char *const blendings[] = {"published", "normalised", "over"};
    static stage s;
    stage_set(&s, model);
    for (size_t i = 0; i < s.count; ++i)
        s.objects[i].truth.alpha = s.truths[i].transparent ? 0.5 : 1.0;
    stage_make_opaque(&s, false);
    s.scene.width = s.scene.height = FIELD_SIZE;
    s.scene.opaque_weight = 1;
    s.scene.background_weight = 0.5;
    for (int i = 0; i < 3; ++i) {
        s.scene.interior = (ref_interior)i;
        run_picture(h, &s, "interior", name, interiors[i]);
    }
    s.scene.interior = REF_INTERIOR_IMPLICIT;
    for (int i = 0; i < 3; ++i) {
        s.scene.blending = (ref_blending)i;
        run_picture(h, &s, "blending", name, blendings[i]);
    }
    s.scene.interior = REF_INTERIOR_LAYERS;
    for (int n = 1; n <= REF_MAX_LAYERS; ++n) {
        char setting[16];
        snprintf(setting, sizeof setting, "layers %d", n);
        s.scene.layers = n;
        run_picture(h, &s, "layers", name, setting);
    }
    stage_clear(&s);
}

/* ---- dynamic transparency: its rungs ---- */

typedef struct seeing {
    const char *name;
    tr_see see;
    int divisor;
} seeing;

static const seeing seeings[] = {{"off", TR_SEE_OFF, 2},
                                 {"one mask /1", TR_SEE_ONE_MASK, 1},
                                 {"one mask /2", TR_SEE_ONE_MASK, 2},
                                 {"one mask /4", TR_SEE_ONE_MASK, 4},
                                 {"one mask /8", TR_SEE_ONE_MASK, 8},
                                 {"dither", TR_SEE_DITHER, 2},
                                 {"exact /1", TR_SEE_EXACT, 1},
                                 {"exact /2", TR_SEE_EXACT, 2},
                                 {"sequence", TR_SEE_SEQUENCE, 2},
                                 {"published", TR_SEE_PUBLISHED, 2}};

/* The mean of as many frames as dithering needs; of other rungs one. */
static double *seen_picture(harness *h, dynamic_scene *d, double *ms) {
    size_t count = 4 * (size_t)d->scene.width * (size_t)d->scene.height;
    double *sum = need(count * sizeof *sum), times[64];
    int shots = d->wish.see == TR_SEE_DITHER ? 33 : d->wish.see == TR_SEE_EXACT || frames() < 15 ? 3 : 7;
    memset(sum, 0, count * sizeof *sum);
    dynamic_draw(h, d); /* warms up */
    for (int i = 0; i < shots; ++i) {
        d->wish.frame_index = (uint32_t)i;
        glFinish();
        double start = now_ms();
        dynamic_draw(h, d);
        glFinish();
        times[i] = now_ms() - start;
        unsigned char *pixels = dynamic_read(h, d);
        for (size_t k = 0; k < count; ++k)
            sum[k] += (double)pixels[k] / shots;
        free(pixels);
    }
    *ms = median(times, (size_t)shots);
    return sum;
}

/* The error is against the truth per pixel with the defaults, whatever the rung paints. */
static void run_seeing(harness *h, dynamic_scene *d, const char *name, const ref_dyn_pixel *truth, const seeing *s) {
    double ms, max = 0, squares = 0, count = 0;
    d->wish.see = s->see;
    d->wish.mask_divisor = s->divisor;
    if (!dynamic_can(h, d))
        return;
    double *picture = seen_picture(h, d, &ms);
    for (size_t i = 0; i < (size_t)d->scene.width * (size_t)d->scene.height; ++i)
        for (size_t c = 0; c < 3 && !truth[i].left_out; ++c, ++count) {
            double difference = fabs(truth[i].color[c] * 255 - picture[4 * i + c]);
            max = fmax(max, difference);
            squares += difference * difference;
        }
    add_row("dynamic", name, s->name, ms, max, count > 0 ? sqrt(squares / count) : 0,
            (unsigned long long)tr_get_info(h->tr).see_plan->bytes);
    free(picture);
}

static void run_seeings(harness *h, dynamic_scene *d, const char *name, FILE *table) {
    ref_dyn_census *census = dynamic_need(d->count * sizeof *census);
    ref_dyn_pixel *truth = dynamic_truth(d, census);
    dynamic_found found = dynamic_find_targets(d, census);
    printf(
        "%s: of %zu targets of 20 pixels and more 20 have a weight of 0.3 in %zu without, in %zu with (a proxy for the "
        "paper's user study)\n",
        name, found.targets, found.without, found.with);
    fprintf(table, "\"%s\",%zu,%zu,%zu\n", name, found.targets, found.without, found.with);
    for (size_t i = 0; i < sizeof seeings / sizeof seeings[0]; ++i)
        run_seeing(h, d, name, truth, &seeings[i]);
    free(truth);
    free(census);
}

/* Half of the size that bench/dynamic.c times, for the reference's sake. */
static void run_forest(harness *h, FILE *table) {
    static const size_t numbers[] = {1, 10, 50, 200, 500};
    dynamic_scene d;
    dynamic_open(&d, h, forest_make());
    dynamic_shade(&d, true);
    dynamic_look(&d, FOREST_EYE, FOREST_AT, FOREST_FOV, 640, 512);
    harness_target(h, 640, 512);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; ++i) {
        char name[32];
        snprintf(name, sizeof name, "forest, %zu", numbers[i]);
        forest_choose_targets(&d, numbers[i]);
        run_seeings(h, &d, name, table);
    }
    dynamic_close(&d);
}

static bool run_dynamic(harness *h, const char *folder) {
    char path[512];
    snprintf(path, sizeof path, "%s/found.csv", folder);
    FILE *table = fopen(path, "w");
    if (!table) {
        fprintf(stderr, "accuracy: cannot write %s\n", path);
        return false;
    }
    fputs("scene,targets,without,with\n", table);
    run_forest(h, table);
    for (int k = 0; k < 2; ++k) {
        battlefield *b = k ? battlefield_create_walkthrough(1) : battlefield_create_abstract(1);
        dynamic_scene d;
        for (size_t i = 0; i < b->scene->part_count; ++i)
            b->scene->parts[i].hidden = false;
        dynamic_open(&d, h, b);
        dynamic_shade(&d, true);
        dynamic_look(&d, b->eye, b->look_at, k ? 65 : 45, 800, 600);
        harness_target(h, 800, 600);
        run_seeings(h, &d, k ? "walkthrough" : "abstract", table);
        dynamic_close(&d);
    }
    harness_target(h, FIELD_SIZE, FIELD_SIZE);
    return fclose(table) == 0;
}

/* ---- scenes ---- */

static void run_files(harness *h) {
    static const char *const files[][2] = {{"skull", "../shared/models/skull.obj"},
                                           {"featuretype", "../shared/models/featuretype.STL"},
                                           {"spot", "../shared/models/spot.obj"}};
    for (size_t i = 0; i < sizeof files / sizeof files[0]; ++i) {
        load_report report;
        char message[256];
        struct stat found;
        scene *model =
            stat(files[i][1], &found) == 0 ? load_model(files[i][1], &report, message, sizeof message) : NULL;
        if (!model) {
            printf("%s is not there: left out\n", files[i][1]);
            continue;
        }
        run_alpha(h, files[i][0], &model->meshes[largest_mesh(model)]);
        scene_destroy(model);
    }
}

int main(int argc, char **argv) {
    static const char *const names[] = {"mug", "crank", "gearbox"};
    const char *folder = argc > 1 ? argv[1] : "build/accuracy";
    harness h;
    if (!wants("alpha") && !wants("pictures") && !wants("dynamic") && !wants("smart")) {
        fprintf(stderr, "accuracy: ACCURACY_ONLY=%s: it is alpha, pictures, dynamic or smart\n",
                getenv("ACCURACY_ONLY"));
        return 2;
    }
    mkdir("build", 0777);
    mkdir(folder, 0777);
    harness_open(&h, 450, false, NULL);
    harness_target(&h, FIELD_SIZE, FIELD_SIZE);
    printf("driver: %s\n", h.context.renderer);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
        scene *model = models_make(names[i]);
        if (!model)
            return 1;
        if (wants("alpha"))
            run_alpha(&h, names[i], &model->meshes[largest_mesh(model)]);
        if (wants("pictures"))
            run_pictures(&h, names[i], model);
        scene_destroy(model);
    }
    bool written = !wants("dynamic") || run_dynamic(&h, folder);
    if (wants("alpha"))
        run_files(&h);
    harness_close(&h);
    if (wants("smart"))
        run_operators(frames(), add_row);
    written = write_table(folder) && written;
    plot(folder);
    return written ? 0 : 1;
}

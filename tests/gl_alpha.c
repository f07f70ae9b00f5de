/* gl_alpha.c: the ladder of view-dependent alpha, each rung against the distance to the nearest silhouette in double at
 * each pixel: errors, and what shows at triangle edges; bad input; the same picture on GL 3.3 and ES 3.0. */
#define _POSIX_C_SOURCE 200809L
#include "alpha_field.h"

#include "models.h"

static const char *const rung_names[TR_ALPHA_COUNT] = {"distance at vertices", "published", "candidates", "exact",
                                                       "image"};

static uint32_t first_triangle;

/* Black on white, by the built-in programs, as seen: what is not red is alpha, in 8 bits. */
static void draw_built_in(harness *h, const field *f, tr_alpha alpha, const tr_edge_set *set, unsigned char *pixels) {
    tr_frame frame = field_frame_of(h, alpha);
    tr_material material = field_material_of(f, set);
    material.first_triangle = first_triangle;
    const double white[3] = {1, 1, 1};
    tr_pass pass;
    harness_clear(h, white, 1.0f);
    assert_int_equal(tr_begin(h->tr, &frame), TR_OK);
    while (tr_next_pass(h->tr, &pass)) {
        tr_set_material(h->tr, &pass, &material);
        field_draw(f, alpha);
    }
    assert_int_equal(tr_end(h->tr), TR_OK);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, FIELD_SIZE, FIELD_SIZE, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
}

/* ---- tests ---- */

static const double identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
/* Scaled unevenly, turned and moved. */
static const double uneven[16] = {0.9, 0.5, 0, 0, -1.1, 2.0, 0, 0, 0, 0, 0.7, 0, 40, -30, 20, 1};

static field_verdict measure(harness *h, const field *f, tr_alpha alpha, float *out) {
    tr_edge_set set;
    tr_edges edges = field_edges_of(f, alpha);
    assert_int_equal(tr_set_edges(h->tr, &edges, 1, &set), TR_OK);
    field_draw_own(h, f, alpha, &set, out);
    return field_judge(f, out);
}

/* The first two rungs, as they are meant: what is interpolated between the corners, and what is made of it there. */
static double worst_interpolated(const field *f, tr_alpha alpha, const float *out) {
    double worst = 0;
    for (int i = 0; i < FIELD_PIXELS; ++i) {
        const field_sight *s = &f->sights[i];
        double sum = 0;
        if (!s->seen || s->left_out)
            continue;
        for (int c = 0; c < 3; ++c) {
            double d = (double)f->distances[f->indices[3 * (size_t)s->triangle + (size_t)c]];
            sum += s->weight[c] * (alpha == TR_ALPHA_PUBLISHED ? ref_alpha(d, (double)f->d_max, (double)f->k) : d);
        }
        if (alpha == TR_ALPHA_DISTANCE)
            sum = ref_alpha(sum, (double)f->d_max, (double)f->k);
        worst = fmax(worst, fabs(sum - (double)out[i]));
    }
    return worst;
}

/* The first two rungs are as good as the mesh is fine; the last two are the field itself, without a seam. */
static void test_rungs_against_the_field(void **state) {
    static const char *const models[] = {"mug", "crank", "gearbox", "shells"};
    static float out[FIELD_PIXELS];
    (void)state;
    harness h;
    harness_open(&h, 330, false, NULL);
    harness_target(&h, FIELD_SIZE, FIELD_SIZE);
    for (size_t m = 0; m < sizeof models / sizeof models[0]; ++m) {
        scene *model = models_make(models[m]);
        const double turn[2] = {0.6 + (double)m, 0.5};
        field f;
        field_open(&f, &model->meshes[0], m % 2 ? uneven : identity, turn);
        field_upload(&f);
        printf("    %s: %zu triangles, %zu edges, %.1f candidates a triangle\n", models[m], f.triangle_count,
               f.edge_count, (double)f.candidate_count / (double)f.triangle_count);
        for (int alpha = 0; alpha < TR_ALPHA_IMAGE; ++alpha) {
            field_verdict v = measure(&h, &f, (tr_alpha)alpha, out);
            printf(
                "        %-20s max %7.3f/255, rms %6.3f/255, %5.1f %% left out, no seam at %7.3f %% of %.0f crossings\n",
                rung_names[alpha], 255 * v.max, 255 * v.rms, 100 * v.left_out, 100 * v.smooth, v.crossings);
            assert_true(v.left_out <= 0.10);
            if (alpha < TR_ALPHA_CANDIDATES) {
                assert_true(worst_interpolated(&f, (tr_alpha)alpha, out) <= 1 / 255.0);
                continue;
            }
            assert_true(v.smooth >= 0.999);
            assert_true(v.max <= 1 / 255.0);
        }
        field_close(&f);
        scene_destroy(model);
    }
    harness_close(&h);
}

/* Edges of any kind and number, by both rungs and by the one that they were not made for. */
static void try_edges(harness *h, field *f, const char *name) {
    static float out[FIELD_PIXELS];
    field_find_truth(f);
    for (int given = TR_ALPHA_CANDIDATES; given <= TR_ALPHA_EXACT; ++given)
        for (int alpha = TR_ALPHA_CANDIDATES; alpha <= TR_ALPHA_EXACT; ++alpha) {
            tr_edge_set set;
            tr_edges edges = field_edges_of(f, (tr_alpha)given);
            if (given != alpha && f->edge_count > 1000)
                continue; /* all segments, pixel by pixel */
            assert_int_equal(tr_set_edges(h->tr, &edges, 1, &set), TR_OK);
            field_draw_own(h, f, (tr_alpha)alpha, &set, out);
            field_verdict v = field_judge(f, out);
            if (v.max > 1 / 255.0)
                fail_msg("%s, as %s by %s: off by %.2f/255", name, rung_names[given], rung_names[alpha], 255 * v.max);
        }
    printf("    %s: %zu edges\n", name, f->edge_count);
}

static void test_any_edges(void **state) {
    const double turn[2] = {0.6, 0.5};
    (void)state;
    harness h;
    harness_open(&h, 330, false, NULL);
    harness_target(&h, FIELD_SIZE, FIELD_SIZE);
    scene *model = models_make("shells");
    field f;
    field_open(&f, &model->meshes[0], uneven, turn);
    field_upload(&f);
    sil_edge *one = malloc(sizeof *one);
    *one = f.edges[5];
    field_take_edges(&f, one, 1);
    try_edges(&h, &f, "one edge");
    field_take_edges(&f, calloc(1, sizeof *one), 0);
    try_edges(&h, &f, "none: the eye is inside");
    const float k = f.k, d_max = f.d_max;
    size_t all = sil_mesh_get_info(f.mesh).edge_count, count = sil_extract(f.mesh, NULL, NULL, 15, NULL, 0);
    assert_int_equal(count, 0); /* no creases: all edges are had by their numbers */
    sil_edge *many = calloc(all, sizeof *many);
    sil_view view;
    for (double turned = 0; count < 4800; turned += 0.1) { /* more than four rows of the texture */
        view = sil_view_orthographic((const double[3]){cos(turned), 0.3 * sin(9 * turned), sin(turned)});
        count += sil_extract(f.mesh, NULL, &view, SIL_SILHOUETTE, many + count, all - count);
    }
    field_take_edges(&f, many, count);
    try_edges(&h, &f, "silhouettes of many views");
    f.k = 0;
    try_edges(&h, &f, "k = 0");
    f.k = 3;
    try_edges(&h, &f, "k = 3");
    f.k = k;
    f.d_max = 0;
    try_edges(&h, &f, "d_max = 0");
    f.d_max = d_max;
    field_close(&f);
    scene_destroy(model);
    harness_close(&h);
}

/* An edge between two vertices at one place is a point. */
static void test_edges_of_no_length(void **state) {
    static float positions[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 0.25f, 0.5f, 0, 0.25f, 0.5f, 0};
    static uint32_t indices[] = {0, 1, 2, 0, 2, 3};
    const uint32_t ends[2] = {4, 5};
    static float out[FIELD_PIXELS];
    const double turn[2] = {0, 0};
    scene_mesh square;
    tr_edges edges;
    tr_edge_set set;
    field f;
    (void)state;
    harness h;
    harness_open(&h, 330, false, NULL);
    harness_target(&h, FIELD_SIZE, FIELD_SIZE);
    memset(&square, 0, sizeof square);
    square.positions = positions;
    square.vertex_count = 6;
    square.indices = indices;
    square.index_count = 6;
    field_open(&f, &square, identity, turn);
    field_upload(&f);
    memset(&edges, 0, sizeof edges);
    edges.positions = positions;
    edges.position_count = 6;
    edges.ends = ends;
    edges.edge_count = 1;
    assert_int_equal(tr_set_edges(h.tr, &edges, 1, &set), TR_OK);
    field_draw_own(&h, &f, TR_ALPHA_EXACT, &set, out);
    for (int i = 0; i < FIELD_PIXELS; ++i) {
        const double *p = f.sights[i].place;
        double d = hypot(hypot(p[0] - 0.25, p[1] - 0.5), p[2]);
        if (f.sights[i].seen && !f.sights[i].left_out)
            assert_true(fabs((double)out[i] - ref_alpha(d, (double)f.d_max, (double)f.k)) <= 1 / 255.0);
    }
    field_close(&f);
    harness_close(&h);
}

/* ---- outlines in an image ---- */

enum { WIDE = 97, TALL = 61 };

/* Two discs, the smaller one before the larger, and a step in the larger one's depth that is no slope. */
static void draw_discs(float depths[WIDE * TALL], uint32_t ids[WIDE * TALL]) {
    for (int i = 0; i < WIDE * TALL; ++i) {
        int x = i % WIDE, y = i / WIDE;
        depths[i] = 1;
        ids[i] = 0;
        if (hypot(x - 40, y - 30) < 27) {
            ids[i] = 7;
            depths[i] = x < 30 ? 0.30f : 0.60f;
        }
        if (hypot(x - 70, y - 33) < 19.5) {
            ids[i] = 9;
            depths[i] = 0.40f;
        }
    }
}

static bool is_outline(const float *depths, const uint32_t *ids, int x, int y) {
    static const int steps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    int here = y * WIDE + x;
    for (int s = 0; s < 4 && depths[here] < 1; ++s) {
        int nx = x + steps[s][0], ny = y + steps[s][1], next = ny * WIDE + nx;
        if (nx >= 0 && nx < WIDE && ny >= 0 && ny < TALL &&
            (depths[next] >= 1 || (depths[next] > depths[here] && (ids[next] != ids[here] || depths[next] > 0.55f))))
            return true;
    }
    return false;
}

/* Against all pairs: which pixels are outlines, and how far each pixel's nearest one of its own object is. */
static void test_outlines_are_found(void **state) {
    static float depths[WIDE * TALL];
    static uint32_t ids[WIDE * TALL];
    static GLuint out[WIDE * TALL * 4];
    static const float orthographic[16] = {0.1f, 0, 0, 0, 0, 0.1f, 0, 0, 0, 0, -0.01f, 0, 0, 0, 0, 1};
    (void)state;
    draw_discs(depths, ids);
    for (int es = 0; es < 2; ++es) {
        harness h;
        tr_outlines image;
        int wrong = 0;
        harness_open(&h, es ? 300 : 330, es, NULL);
        memset(&image, 0, sizeof image);
        image.depth_texture = field_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, WIDE, TALL, depths);
        image.id_texture = field_texture(GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, WIDE, TALL, ids);
        image.width = WIDE;
        image.height = TALL;
        memcpy(image.projection, orthographic, sizeof image.projection);
        assert_int_equal(tr_find_outlines(h.tr, &image), TR_OK);
        glBindFramebuffer(GL_FRAMEBUFFER, h.tr->outline_fbos[h.tr->outline_at]);
        glReadPixels(0, 0, WIDE, TALL, GL_RGBA_INTEGER, GL_UNSIGNED_INT, out);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        for (int i = 0; i < WIDE * TALL; ++i) {
            double least = HUGE_VAL, found = HUGE_VAL;
            for (int j = 0; j < WIDE * TALL && depths[i] < 1; ++j)
                if (ids[j] == ids[i] && is_outline(depths, ids, j % WIDE, j / WIDE))
                    least = fmin(least, hypot(j % WIDE - i % WIDE, j / WIDE - i / WIDE));
            if (out[4 * i] != 65535)
                found = hypot((double)out[4 * i] - i % WIDE, (double)out[4 * i + 1] - i / WIDE);
            if (depths[i] < 1) {
                assert_true(found < HUGE_VAL);
                assert_true((least == 0) == (found == 0)); /* the very same outlines */
                wrong += found > least + 1e-9;
                assert_true(found >= least - 1e-9); /* not another object's */
                assert_true(found <= least + 1);
            }
        }
        printf("    %s: %d of %d pixels have the second nearest\n", es ? "ES 3.0" : "GL 3.3", wrong, WIDE * TALL);
        assert_true(wrong <= WIDE * TALL / 500);
        image.width = 0;
        assert_int_equal(tr_find_outlines(h.tr, &image), TR_INVALID_ARGUMENT);
        image.width = 1 << 20;
        assert_int_equal(tr_find_outlines(h.tr, &image), TR_TOO_LARGE);
        image.width = WIDE;
        image.projection[5] = 0;
        assert_int_equal(tr_find_outlines(h.tr, &image), TR_INVALID_ARGUMENT);
        glDeleteTextures(1, &image.depth_texture);
        glDeleteTextures(1, &image.id_texture);
        harness_close(&h);
    }
}

/* A plate that faces the eye is as flat as the picture: its distances are right to a pixel. */
static void test_image_rung(void **state) {
    static float positions[] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    static uint32_t indices[] = {0, 1, 2, 0, 2, 3};
    static float out[FIELD_PIXELS];
    static unsigned char picture[4 * FIELD_PIXELS];
    const double turn[2] = {0, 0};
    scene_mesh plate;
    field f;
    (void)state;
    harness h;
    harness_open(&h, 330, false, NULL);
    harness_target(&h, FIELD_SIZE, FIELD_SIZE);
    memset(&plate, 0, sizeof plate);
    plate.positions = positions;
    plate.vertex_count = 4;
    plate.indices = indices;
    plate.index_count = 6;
    field_open(&f, &plate, identity, turn);
    field_upload(&f);
    f.k = 1; /* then 1 - alpha is the distance in units of d_max */
    field_find_truth(&f);
    field_verdict v = field_measure_image(&h, &f, out);
    double pixel = 2 * 0.36 / FIELD_SIZE * 3.2 * sqrt(2.0) / (double)f.d_max; /* in that unit */
    printf("    max %.2f/255, a pixel %.2f/255\n", 255 * v.max, 255 * pixel);
    assert_true(v.max <= pixel);
    draw_built_in(&h, &f, TR_ALPHA_IMAGE, NULL, picture);
    for (int i = 0; i < FIELD_PIXELS; ++i)
        if (f.sights[i].seen)
            assert_true(fabs(1 - picture[4 * i] / 255.0 - (double)out[i]) <= 1.5 / 255.0);
    field_close(&f);
    harness_close(&h);
}

/* The pictures of the built-in programs: on GL 3.3 and ES 3.0, by indices and without, the same to 1/255, and alpha. */
static void test_same_picture_everywhere(void **state) {
    static unsigned char pictures[2][TR_ALPHA_IMAGE][4 * FIELD_PIXELS];
    const double turn[2] = {0.6, 0.5};
    (void)state;
    scene *model = models_make("mug");
    field f;
    field_open(&f, &model->meshes[0], identity, turn);
    for (int es = 0; es < 2; ++es) {
        harness h;
        harness_open(&h, es ? 300 : 330, es, NULL);
        harness_target(&h, FIELD_SIZE, FIELD_SIZE);
        field_upload(&f);
        for (int alpha = 0; alpha < TR_ALPHA_IMAGE; ++alpha) {
            tr_edge_set set;
            tr_edges edges = field_edges_of(&f, (tr_alpha)alpha);
            assert_int_equal(tr_set_edges(h.tr, &edges, 1, &set), TR_OK);
            draw_built_in(&h, &f, (tr_alpha)alpha, &set, pictures[es][alpha]);
        }
        glDeleteVertexArrays(1, &f.array);
        glDeleteVertexArrays(1, &f.flat_array);
        glDeleteBuffers(4, f.buffers);
        f.array = 0;
        harness_close(&h);
    }
    for (int alpha = 0; alpha < TR_ALPHA_IMAGE; ++alpha) {
        double worst = 0;
        for (int i = 0; i < 4 * FIELD_PIXELS; ++i)
            assert_true(abs(pictures[0][alpha][i] - pictures[1][alpha][i]) <= 1);
        for (int i = 0; i < FIELD_PIXELS; ++i)
            if (f.sights[i].seen && !f.sights[i].left_out)
                worst = fmax(worst, fabs(1 - pictures[0][alpha][4 * i] / 255.0 - f.sights[i].alpha));
        printf("    %-20s max %.2f/255\n", rung_names[alpha], 255 * worst);
        assert_true(alpha < TR_ALPHA_CANDIDATES ||
                    worst <= 2 / 255.0); /* alpha and the picture are rounded to 8 bits */
    }
    field_close(&f);
    scene_destroy(model);
}

/* Where the triangles of several meshes share one array, tr_material.first_triangle says where this one's begin. */
static void test_first_triangle(void **state) {
    enum { BEFORE = 1500 };
    static unsigned char alone[4 * FIELD_PIXELS], shared[4 * FIELD_PIXELS];
    const double turn[2] = {0.6, 0.5};
    harness h;
    tr_edge_set set;
    (void)state;
    scene *model = models_make("mug");
    field f;
    field_open(&f, &model->meshes[0], identity, turn);
    harness_open(&h, 330, false, NULL);
    harness_target(&h, FIELD_SIZE, FIELD_SIZE);
    field_upload(&f);
    tr_edges edges = field_edges_of(&f, TR_ALPHA_CANDIDATES);
    assert_int_equal(tr_set_edges(h.tr, &edges, 1, &set), TR_OK);
    draw_built_in(&h, &f, TR_ALPHA_CANDIDATES, &set, alone);
    uint32_t *offsets = calloc(BEFORE + f.triangle_count + 1, sizeof *offsets);
    assert_non_null(offsets);
    memcpy(offsets + BEFORE, f.offsets, (f.triangle_count + 1) * sizeof *offsets);
    edges.offsets = offsets;
    edges.triangle_count += BEFORE;
    assert_int_equal(tr_set_edges(h.tr, &edges, 1, &set), TR_OK);
    draw_built_in(&h, &f, TR_ALPHA_CANDIDATES, &set, shared);
    assert_int_not_equal(memcmp(alone, shared, sizeof alone), 0);
    first_triangle = BEFORE;
    draw_built_in(&h, &f, TR_ALPHA_CANDIDATES, &set, shared);
    first_triangle = 0;
    assert_memory_equal(alone, shared, sizeof alone);
    free(offsets);
    field_close(&f);
    harness_close(&h);
    scene_destroy(model);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rungs_against_the_field), cmocka_unit_test(test_any_edges),
        cmocka_unit_test(test_edges_of_no_length),      cmocka_unit_test(test_first_triangle),
        cmocka_unit_test(test_outlines_are_found),      cmocka_unit_test(test_image_rung),
        cmocka_unit_test(test_same_picture_everywhere),
    };
    return cmocka_run_group_tests_name("gl_alpha", tests, NULL, NULL);
}

/* gl_oit_msaa.c: oit_buffers.h into multisampled targets: each sample is held to the ray through it in double. */
#include "oit_setting.h"

enum { MOST = OIT_MAX_SAMPLES };

/* ---- samples read and known ---- */

/* samples x pixels x 4 floats, bottom row first. */
static float *read_samples(const oit_setting *t) {
    size_t pixels = (size_t)t->width * (size_t)t->height;
    float *all = malloc((size_t)t->samples * pixels * 4 * sizeof *all);
    GLuint program = oit_scene_program(t->h.context.es,
                                       "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, "
                                       "gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }\n",
                                       "uniform highp sampler2DMS image;\nuniform int number;\n"
                                       "layout(location = 0) out highp vec4 result;\n"
                                       "void main() { result = texelFetch(image, ivec2(gl_FragCoord.xy), number); }\n");
    GLuint array, color = oit_setting_texture(t->width, t->height, 0, GL_RGBA32F);
    GLuint framebuffer = oit_setting_framebuffer(color, 0, 0);
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glUseProgram(program);
    glViewport(0, 0, t->width, t->height);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, t->color);
    for (int i = 0; i < t->samples; ++i) {
        glUniform1i(glGetUniformLocation(program, "number"), i);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glReadPixels(0, 0, t->width, t->height, GL_RGBA, GL_FLOAT, all + (size_t)i * pixels * 4);
    }
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    glUseProgram(0);
    glBindVertexArray(0);
    glDeleteProgram(program);
    glDeleteVertexArrays(1, &array);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &color);
    return all;
}

static void find_positions(const oit_setting *t, double positions[MOST][2]) {
    glBindFramebuffer(GL_FRAMEBUFFER, t->framebuffer);
    for (int i = 0; i < t->samples; ++i) {
        float at[2];
        glGetMultisamplefv(GL_SAMPLE_POSITION, (GLuint)i, at);
        positions[i][0] = (double)at[0];
        positions[i][1] = (double)at[1];
    }
}

/* The ray through one sample; left out where the layers or their order change within 1/50 of a pixel, for rasterizers snap
 * corners to 1/256 and edges move along. */
static bool cast_sample(ref_i_world *world, const oit_scene *s, double x, double y, oit_truth *out) {
    static oit_truth_layer layers[4096];
    static const double dx[5] = {0, -0.02, 0.02, -0.02, 0.02}, dy[5] = {0, -0.02, -0.02, 0.02, 0.02};
    uint64_t signature = 0;
    out->left_out = false;
    for (int corner = 4; corner >= 0; --corner) {
        size_t count;
        const ref_i_hit *solid = oit_truth_cast(world, s, x + dx[corner], y + dy[corner], layers, &count);
        uint64_t here = oit_truth_signature(layers, count, solid ? ref_i_id(world, solid) : 0);
        if (corner < 4 && here != signature)
            out->left_out = true;
        signature = here;
        if (corner)
            continue;
        for (int k = 0; k < 3; ++k)
            out->color[k] =
                (solid ? s->truths[world->triangles[solid->triangle].object].color[k] : s->scene.background[k]);
        oit_truth_blend(layers, count, out->color);
        out->layers = (uint32_t)count;
    }
    return !out->left_out;
}

static float *draw_samples(oit_setting *t, oit_scene *s, const size_t *order) {
    oit_frame frame = oit_scene_frame(s, t->framebuffer);
    oit_setting_clear(t, s);
    oit_scene_render(s, t->oit, &frame, order);
    return read_samples(t);
}

static void check(oit_setting *t, oit_scene *s, const char *name, double tolerance) {
    size_t pixels = (size_t)t->width * (size_t)t->height, left_out = 0, differing = 0;
    double positions[MOST][2], worst = 0;
    ref_i_world world = {.scene = &s->scene};
    float *got = draw_samples(t, s, NULL);
    find_positions(t, positions);
    assert_true(ref_i_is_valid(&s->scene) && ref_i_make_world(&world));
    for (size_t i = 0; i < pixels; ++i) {
        bool differs = false;
        for (int k = 0; k < t->samples; ++k) {
            const float *pixel = got + 4 * ((size_t)k * pixels + i);
            double x = (double)(i % (size_t)t->width), y = (double)(i / (size_t)t->width);
            oit_truth truth;
            differs = differs || memcmp(pixel, got + 4 * i, 3 * sizeof *pixel) != 0;
            if (!cast_sample(&world, s, x + positions[k][0], y + positions[k][1], &truth)) {
                ++left_out;
                continue;
            }
            for (int c = 0; c < 3; ++c) {
                double error = fabs((double)pixel[c] - truth.color[c]);
                if (error > tolerance)
                    fail_msg("%s: pixel %g, %g, sample %d of %u layers is %g %g %g, should be %g %g %g", name, x, y, k,
                             truth.layers, (double)pixel[0], (double)pixel[1], (double)pixel[2], truth.color[0],
                             truth.color[1], truth.color[2]);
                worst = fmax(worst, error);
            }
        }
        differing += differs;
    }
    printf("    %-30s max %.2g, %4.1f %% left out, samples differ in %zu of %zu pixels\n", name, worst,
           100 * (double)left_out / (double)(pixels * (size_t)t->samples), differing, pixels);
    assert_true(left_out * 10 <= pixels * (size_t)t->samples);
    assert_true(differing > 50);
    ref_i_free_world(&world);
    free(got);
}

/* ---- scenes ---- */

/* Triangles in all directions, each at a depth of its own; every sixth is opaque. */
static void add_triangles(oit_scene *s, int count, double alpha) {
    uint32_t state = 11;
    for (int i = 0; i < count; ++i) {
        float *positions = malloc(9 * sizeof *positions);
        uint32_t *indices = malloc(3 * sizeof *indices);
        double color[4] = {0, 0, 0, alpha};
        for (int k = 0; k < 3; ++k) {
            positions[3 * k] = (float)(2.4 * oit_scene_random(&state) - 1.2);
            positions[3 * k + 1] = (float)(2.4 * oit_scene_random(&state) - 1.2);
            positions[3 * k + 2] = (float)(-0.9 + 1.8 * (i * 7 % count) / count);
            indices[k] = (uint32_t)k;
            color[k] = oit_scene_random(&state);
        }
        size_t at = oit_scene_add(s, positions, NULL, 3, indices, 1, color);
        s->truths[at].transparent = i % 6 != 3;
        s->truths[at].two_sided = true;
    }
}

static void make_triangles(oit_scene *s, int size) {
    oit_scene_init(s, size, size);
    add_triangles(s, 30, 0.4);
}

/* A roof seen along its ridge: two sheets that meet in a slanting edge and go away from it steeply, in colours of their own.
 * Beyond the edge their planes cross. */
static void make_roofs(oit_scene *s, int size) {
    oit_scene_init(s, size, size);
    for (int i = 0; i < 2; ++i) {
        const double color[4] = {i ? 0 : 1, i ? 1 : 0, 0, 0.6};
        const double z = i ? 0.9 : -0.9;
        const float corners[4][3] = {
            {0.9f, -0.95f, 0}, {0.3f, 0.97f, 0}, {-0.9f, 0.9f, (float)z}, {-0.8f, -0.9f, (float)z}};
        static const uint32_t order[6] = {0, 1, 2, 0, 2, 3};
        float *positions = malloc(sizeof corners);
        uint32_t *indices = malloc(sizeof order);
        memcpy(positions, corners, sizeof corners);
        memcpy(indices, order, sizeof order);
        oit_scene_add(s, positions, NULL, 4, indices, 2, color);
    }
}

/* ---- tests ---- */

static const oit_desc by_pixel = {.color = OIT_COLOR_FLOAT, .fields = OIT_FIELD_COVERAGE | OIT_FIELD_PART};
static const oit_desc by_sample = {
    .color = OIT_COLOR_FLOAT, .fields = OIT_FIELD_COVERAGE | OIT_FIELD_PART, .sample_order = 1};

static void check_scene(bool es, int samples, oit_desc desc, void (*make)(oit_scene *s, int size), const char *name) {
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    oit_setting_open(&t, es, 48, 48, samples, es ? GL_RGBA16F : GL_RGBA32F, desc);
    make(s, 48);
    check(&t, s, name, es ? 2e-3 : 1e-5);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

static void make_balls(oit_scene *s, int size) {
    oit_scene_init(s, size, size);
    oit_scene_concentric(s, 8, 24, 0.2);
    s->truths[3].transparent = false;
}

static void make_crossing_balls(oit_scene *s, int size) {
    oit_scene_init(s, size, size);
    oit_scene_random_balls(s, 6, 16, 0.4);
    s->truths[2].transparent = false;
}

static void test_samples_match_the_rays(void **state) {
    (void)state;
    for (int es = 0; es < 2; ++es)
        for (int samples = 2; samples <= 4; samples += 2) {
            check_scene(es, samples, by_pixel, make_triangles, "triangles, by pixel");
            check_scene(es, samples, by_pixel, make_balls, "concentric balls, by pixel");
            check_scene(es, samples, by_pixel, make_roofs, "a roof, by pixel");
            check_scene(es, samples, by_sample, make_triangles, "triangles, by sample");
            check_scene(es, samples, by_sample, make_crossing_balls, "balls that cross, by sample");
            check_scene(es, samples, by_sample, make_roofs, "a roof, by sample");
        }
}

/* Through bands, slabs and without waiting; with blends, which ES draws twice. */
static void test_ways_to_the_picture(void **state) {
    (void)state;
    oit_desc bands = by_pixel, columns = by_pixel, slabs = by_pixel, async = by_pixel;
    bands.ceiling_bytes = 32 * 900;
    columns.ceiling_bytes = 32 * 40;
    slabs.max_block_bytes = 6000;
    async.fit = OIT_FIT_ASYNC;
    check_scene(false, 4, bands, make_triangles, "in bands");
    check_scene(false, 4, columns, make_triangles, "in parts of rows");
    check_scene(false, 4, slabs, make_triangles, "in slabs");
    check_scene(false, 4, async, make_triangles, "never waiting"); /* 4 a pixel are there at first */
}

static void make_blends(oit_scene *s, int size) {
    make_triangles(s, size);
    for (size_t i = 0; i < s->count; ++i) {
        s->objects[i].blend = (uint32_t)(i % 3);
        if (i % 3 == OIT_BLEND_ADD)
            s->truths[i].alpha = 0.05;
    }
}

static void test_blends(void **state) {
    (void)state;
    for (int es = 0; es < 2; ++es) {
        oit_desc desc = by_pixel;
        desc.fields |= OIT_FIELD_BLEND;
        check_scene(es, 4, desc, make_blends, es ? "blends, two draws" : "blends, dual source");
        desc.premultiplied = 1;
        check_scene(es, 2, desc, make_blends, "blends, premultiplied");
    }
}

static void test_draw_order_changes_nothing(void **state) {
    (void)state;
    for (int fit = 0; fit < 2; ++fit) {
        oit_desc desc = by_pixel;
        oit_scene *s = malloc(sizeof *s);
        size_t order[30];
        oit_setting t;
        desc.fit = (oit_fit)fit;
        if (fit)
            desc.ceiling_bytes = 32 * 3000; /* the upper part comes from the tail */
        oit_setting_open(&t, false, 48, 48, 4, GL_RGBA32F, desc);
        make_triangles(s, 48);
        free(draw_samples(&t, s, NULL));
        float *first = draw_samples(&t, s, NULL);
        for (size_t step = 1; step < 30; step += 6) { /* 1, 7, 13, 19: no divisor of 30 */
            for (size_t i = 0; i < 30; ++i)
                order[i] = (29 - i) * (step == 25 ? 11 : step) % 30;
            float *next = draw_samples(&t, s, order);
            assert_memory_equal(first, next, 4 * 48 * 48 * 4 * sizeof *first);
            free(next);
        }
        free(first);
        oit_scene_drop(s);
        oit_setting_close(&t);
        free(s);
    }
}

/* One triangle within the clip volume (what is clipped has edges inside), to the right of an edge. */
static void add_half(oit_scene *s, float edge) {
    static const double color[4] = {1, 0, 0, 0.5};
    const float corners[9] = {edge, -1, 0.1f * edge, 1, -1, 0.1f * edge, edge, 1, 0.1f * edge};
    float *positions = malloc(sizeof corners);
    uint32_t *indices = malloc(3 * sizeof *indices);
    memcpy(positions, corners, sizeof corners);
    for (uint32_t k = 0; k < 3; ++k)
        indices[k] = k;
    oit_scene_add(s, positions, NULL, 3, indices, 1, color);
}

/* Pixels that all fragments cover as a whole are composed once; those with an edge are known by their flags. */
static void test_whole_pixels_are_composed_once(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    uint32_t edges[16 * 16];
    oit_setting_open(&t, false, 16, 16, 4, GL_RGBA32F, by_pixel);
    for (int i = 0; i < 2; ++i) {
        oit_scene_init(s, 16, 16);
        add_half(s, -1);
        add_half(s, i ? -0.5f : -0.55f); /* from column 4 on, or from within column 3 */
        free(draw_samples(&t, s, NULL));
        glBindBuffer(GL_COPY_READ_BUFFER, t.oit->buffers[OIT_I_PIXELS]);
        glGetBufferSubData(GL_COPY_READ_BUFFER, 4 * (16 + 2 * 256 + 2 + 1), sizeof edges, edges);
        for (int y = 0; y < 4; ++y) /* far from the slanting edges */
            for (int x = 0; x < 10; ++x)
                assert_int_equal(edges[16 * y + x], i == 0 && x == 3);
        oit_scene_drop(s);
    }
    oit_setting_close(&t);
    free(s);
}

/* In the tail a fragment is as much thinner as it covers less of the pixel: exact for the mean of the samples where one
 * fragment of one colour is there. */
static void test_tail(void **state) {
    (void)state;
    for (int premultiplied = 0; premultiplied < 2; ++premultiplied) {
        oit_desc desc = {.fields = OIT_FIELD_COVERAGE, .fit = OIT_FIT_ASYNC, .ceiling_bytes = 16};
        oit_scene *s = malloc(sizeof *s);
        oit_setting t;
        const double depth[4] = {0, 0, 0, 0}, color[4] = {0.25, 0.5, 1, 0.5};
        double positions[MOST][2];
        desc.premultiplied = premultiplied;
        oit_setting_open(&t, false, 16, 16, 4, GL_RGBA32F, desc);
        oit_scene_init(s, 16, 16);
        oit_scene_quad(s, -0.55, -1, 1, 1, depth, color); /* from x = 3.6 on */
        float *got = draw_samples(&t, s, NULL);
        find_positions(&t, positions);
        double share = 0;
        for (int k = 0; k < 4; ++k)
            share += positions[k][0] > 0.6 ? 0.25 : 0;
        assert_true(share > 0 && share < 1);
        for (int k = 0; k < 4; ++k)
            for (int x = 2; x < 5; ++x)
                for (int c = 0; c < 3; ++c) {
                    double alpha = x == 2 ? 0 : x == 3 ? 0.5 * share : 0.5;
                    double value = (double)got[4 * (k * 256 + 16 * 5 + x) + c];
                    assert_true(fabs(value - (alpha * color[c] + 1 - alpha)) < 1e-4);
                }
        free(got);
        oit_scene_drop(s);
        oit_setting_close(&t);
        free(s);
    }
}

/* Of a pixel with an edge: the samples that a pick's fragment covers, the depth at their middle; a fragment hides by the
 * share that it covers. */
static void test_picks_and_depths(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    const double steep[4] = {-0.8, 0.8, 0.8, -0.8}, back[4] = {0.9, 0.9, 0.9, 0.9};
    const double color[4] = {1, 0, 0, 0.8};
    double positions[MOST][2], middle = 0;
    uint32_t covered = 0;
    oit_pick pick = {0};
    float depths[256];
    oit_setting_open(&t, false, 16, 16, 4, GL_RGBA32F, by_pixel);
    oit_scene_init(s, 16, 16);
    oit_scene_quad(s, -0.55, -1, 1, 1, steep, color); /* from x = 3.6 on, away from the eye to the right */
    oit_scene_quad(s, -1, -1, 1, 1, back, color);
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    GLuint depth = oit_setting_texture(16, 16, 0, GL_DEPTH_COMPONENT32F);
    frame.depth = OIT_DEPTH_MEDIAN;
    frame.depth_framebuffer = oit_setting_framebuffer(0, depth, 0);
    find_positions(&t, positions);
    for (uint32_t k = 0; k < 4; ++k)
        if (positions[k][0] > 0.6) {
            covered |= 1u << k;
            middle += positions[k][0];
        }
    int count = (covered & 1u ? 1 : 0) + (covered & 2u ? 1 : 0) + (covered & 4u ? 1 : 0) + (covered & 8u ? 1 : 0);
    assert_in_range(count, 1, 3);
    middle /= count;
    oit_setting_clear(&t, s);
    oit_scene_expect(oit_pick_begin(t.oit, 3, 7, 0), "oit_pick_begin");
    oit_scene_render(s, t.oit, &frame, NULL);
    oit_scene_expect(oit_pick_result(t.oit, 1, &pick), "oit_pick_result");
    assert_int_equal(pick.layers, 2);
    assert_int_equal(pick.coverage, covered);
    double ndc = -0.8 + 1.6 * ((3 + middle) / 8 - 1 + 0.55) / 1.55;
    assert_true(fabs((double)pick.depth - (0.5 + 0.5 * ndc)) < 1e-6);
    glBindFramebuffer(GL_FRAMEBUFFER, frame.depth_framebuffer);
    glReadPixels(0, 0, 16, 16, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    assert_true(fabs((double)depths[16 * 7 + 2] - 0.95) < 1e-6); /* 0.2 is left behind the sheet at the back */
    /* 1 - 0.8 * share is left behind the steep sheet: below one half for three samples of four. */
    assert_true(fabs((double)depths[16 * 7 + 3] - (count == 3 ? (double)pick.depth : 0.95)) < 1e-6);
    assert_true(fabs((double)depths[16 * 7 + 4] - (0.5 + 0.5 * (-0.8 + 1.6 * (4.5 / 8 - 0.45) / 1.55))) < 1e-6);
    glDeleteFramebuffers(1, &frame.depth_framebuffer);
    glDeleteTextures(1, &depth);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* Switches that would spoil it, put back as they were; and the same context into targets of 0, 2 and 4 samples in turn. */
static void test_switches_and_changing_targets(void **state) {
    (void)state;
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    oit_setting_open(&t, false, 48, 48, 4, GL_RGBA32F, by_pixel);
    make_triangles(s, 48);
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    float *first = draw_samples(&t, s, NULL);
    oit_setting_clear(&t, s);
    glDisable(GL_MULTISAMPLE);
    glEnable(GL_SAMPLE_SHADING);
    glEnable(GL_SAMPLE_MASK);
    glSampleMaski(0, 5);
    glMinSampleShading(1.0f);
    oit_scene_render(s, t.oit, &frame, NULL);
    assert_true(!glIsEnabled(GL_MULTISAMPLE) && glIsEnabled(GL_SAMPLE_SHADING) && glIsEnabled(GL_SAMPLE_MASK));
    glEnable(GL_MULTISAMPLE);
    glDisable(GL_SAMPLE_SHADING);
    glDisable(GL_SAMPLE_MASK);
    float *second = read_samples(&t);
    assert_memory_equal(first, second, 4 * 48 * 48 * 4 * sizeof *first);
    free(second);
    oit_setting plain = t;
    plain.samples = 0;
    plain.color = oit_setting_texture(48, 48, 0, GL_RGBA32F);
    plain.depth = oit_setting_texture(48, 48, 0, GL_DEPTH_COMPONENT32F);
    plain.framebuffer = oit_setting_framebuffer(plain.color, plain.depth, 0);
    oit_truth *truth = malloc(48 * 48 * sizeof *truth);
    oit_truth_render(s, truth);
    frame.framebuffer = plain.framebuffer;
    oit_setting_clear(&plain, s);
    oit_scene_render(s, t.oit, &frame, NULL);
    float *picture = oit_setting_read(&plain, plain.framebuffer);
    size_t compared = 0;
    for (size_t i = 0; i < 48 * 48; ++i)
        for (size_t c = 0; c < 3 && !truth[i].left_out; ++c, ++compared)
            assert_true(fabs((double)picture[4 * i + c] - truth[i].color[c]) < 1e-5);
    assert_true(compared > 1000);
    second = draw_samples(&t, s, NULL);
    assert_memory_equal(first, second, 4 * 48 * 48 * 4 * sizeof *first);
    free(first);
    free(second);
    free(picture);
    free(truth);
    glDeleteFramebuffers(1, &plain.framebuffer);
    glDeleteTextures(1, &plain.color);
    glDeleteTextures(1, &plain.depth);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

/* A viewport that is not at the origin, in bands: what is outside of it stays, and nothing is composed twice. */
static void test_viewport_with_an_offset(void **state) {
    (void)state;
    for (int fit = 0; fit < 2; ++fit) {
        oit_desc desc = by_pixel;
        oit_scene *s = malloc(sizeof *s);
        oit_setting t;
        const double depth[4] = {0, 0, 0, 0}, color[4] = {0.25, 0.5, 0.75, 0.5};
        oit_report report = {0};
        desc.fit = (oit_fit)fit;
        if (fit == 0)
            desc.ceiling_bytes = 32 * 50;
        oit_setting_open(&t, false, 40, 40, 4, GL_RGBA32F, desc);
        oit_scene_init(s, 24, 16);
        oit_scene_quad(s, -3, -3, 3, 3, depth, color);
        oit_frame frame = oit_scene_frame(s, t.framebuffer);
        frame.x = 7;
        frame.y = 11;
        oit_setting_clear(&t, s);
        oit_scene_render(s, t.oit, &frame, NULL);
        float *got = read_samples(&t);
        for (int i = 0; i < 4 * 40 * 40; ++i) {
            int x = i % 40, y = i / 40 % 40;
            bool inside = x >= 7 && x < 31 && y >= 11 && y < 27;
            for (int c = 0; c < 3; ++c)
                assert_true(fabs((double)got[4 * i + c] - (inside ? 0.5 * color[c] + 0.5 : 1)) < 1e-5);
        }
        if (fit == 0) {
            assert_int_equal(oit_get_report(t.oit, &report), OIT_OK);
            printf("    %u bands, %u extra\n", report.bands, report.extra);
            assert_true(report.bands > 5 && report.extra == 0);
        }
        free(got);
        oit_scene_drop(s);
        oit_setting_close(&t);
        free(s);
    }
}

/* Without the field a multisampled target is refused, and nothing is left changed. */
static void test_coverage_has_to_be_chosen(void **state) {
    (void)state;
    oit_desc desc = {0};
    oit_scene *s = malloc(sizeof *s);
    oit_setting t;
    GLint bound = 0;
    oit_setting_open(&t, false, 8, 8, 2, GL_RGBA8, desc);
    oit_scene_init(s, 8, 8);
    oit_frame frame = oit_scene_frame(s, t.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    t.quiet = true;
    assert_int_equal(oit_begin(t.oit, &frame), OIT_TARGET_MULTISAMPLED);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    assert_int_equal(bound, 0);
    assert_int_equal(oit_get_info(t.oit).fragment_bytes, 16);
    oit_scene_drop(s);
    oit_setting_close(&t);
    free(s);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_samples_match_the_rays),
        cmocka_unit_test(test_ways_to_the_picture),
        cmocka_unit_test(test_blends),
        cmocka_unit_test(test_draw_order_changes_nothing),
        cmocka_unit_test(test_whole_pixels_are_composed_once),
        cmocka_unit_test(test_tail),
        cmocka_unit_test(test_picks_and_depths),
        cmocka_unit_test(test_switches_and_changing_targets),
        cmocka_unit_test(test_viewport_with_an_offset),
        cmocka_unit_test(test_coverage_has_to_be_chosen),
    };
    setvbuf(stdout, NULL, _IOLBF, 0);
    return cmocka_run_group_tests(tests, NULL, NULL);
}

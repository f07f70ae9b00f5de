/* Operators of oit_buffers.h against tests/reference_smart.h on the very fragments that the GPU has stored: links as
 * identical sets, fields, curvature, and the picture; every store, criterion and search; the host's own operators. */
#include "oit_setting.h"
#include "reference_smart.h"

enum { WIDTH = 70, HEIGHT = 53, PIXELS = WIDTH * HEIGHT };

/* ---- scenes ---- */

/* `layers` sheets one behind the other, level, tilted, or wavy so that they cross; of parts 1 to `parts` in turn.
 * rough: normals that are noise, so that depth and normals want different neighbours. */
static void add_sheets(oit_scene *s, int layers, int parts, double tilt, double wave, bool rough) {
    enum { N = 40 };
    for (int l = 0; l < layers; ++l) {
        float *positions = malloc(3 * (N + 1) * (N + 1) * sizeof(float));
        float *normals = malloc(3 * (N + 1) * (N + 1) * sizeof(float));
        uint32_t *indices = malloc(6 * N * N * sizeof *indices);
        double color[4] = {0.2 + 0.6 * l / layers, 0.5, 0.9 - 0.6 * l / layers, 0.4};
        double reach = l % 3 == 1 ? 0.6 : 1.2; /* some end within the picture */
        for (int k = 0; k < (N + 1) * (N + 1); ++k) {
            double x = -reach + 2 * reach * (k % (N + 1)) / N, y = -reach + 2 * reach * (k / (N + 1)) / N;
            double z = -0.5 + (l + 0.5) / layers + tilt * x + wave * sin(6 * x + l) * cos(5 * y);
            double dx = tilt + 6 * wave * cos(6 * x + l) * cos(5 * y), dy = -5 * wave * sin(6 * x + l) * sin(5 * y);
            if (rough) {
                dx = 2 * sin(971.0 * k + 31.0 * l);
                dy = 2 * cos(577.0 * k + 17.0 * l);
            }
            double at[3] = {x, y, z}, n[3] = {-dx, -dy, 1}, length = sqrt(dx * dx + dy * dy + 1);
            for (int c = 0; c < 3; ++c) {
                positions[3 * k + c] = (float)at[c];
                normals[3 * k + c] = (float)(n[c] / length);
            }
        }
        for (int k = 0; k < N * N; ++k) {
            uint32_t a = (uint32_t)(k / N * (N + 1) + k % N);
            const uint32_t quad[6] = {a, a + 1, a + N + 2, a, a + N + 2, a + N + 1};
            memcpy(indices + 6 * k, quad, sizeof quad);
        }
        size_t at = oit_scene_add(s, positions, normals, (N + 1) * (N + 1), indices, 2 * N * N, color);
        s->objects[at].part = 1 + (uint32_t)(l % parts);
    }
}

static void make_scene(oit_scene *s, int kind) {
    oit_scene_init(s, WIDTH, HEIGHT);
    if (kind == 3) {
        oit_scene_random_balls(s, 5, 24, 0.4);
        s->objects[2].blend = OIT_BLEND_LINE;
        s->objects[3].blend = OIT_BLEND_ADD;
        return;
    }
    oit_scene_camera(s, 4, 2, 8, 0.268);
    add_sheets(s, kind == 4 ? 12 : 5, kind == 2 ? 2 : 1, kind == 1 ? 0.8 : 0, kind == 2 ? 0.15 : 0, kind == 4);
}
enum { SCENES = 4, ROUGH = 4 };

static oit_desc every_operator(void) {
    oit_desc desc = {
        .operators = OIT_OPERATE_ALL, .operator_fields = 2, .fields = OIT_FIELD_BLEND, .color = OIT_COLOR_FLOAT};
    desc.fields |= OIT_FIELD_PART;
    return desc;
}

static oit_frame frame_of(const oit_scene *s, const oit_setting *t) {
    oit_frame frame = oit_scene_frame(s, t->framebuffer);
    for (int k = 0; k < 16; ++k)
        frame.projection[k] = (float)s->scene.projection[k];
    return frame;
}

static void begin(oit_setting *t, oit_scene *s, const oit_frame *frame) {
    oit_pass pass;
    oit_setting_clear(t, s);
    oit_scene_expect(oit_begin(t->oit, frame), "oit_begin");
    while (oit_next_pass(t->oit, &pass))
        oit_scene_draw(s, t->oit, &pass, NULL);
}

static void run(oit_setting *t, oit_operator op) {
    oit_scene_expect(oit_run(t->oit, &op), "oit_run");
}

static void finish(oit_setting *t) {
    oit_scene_expect(oit_compose(t->oit), "oit_compose");
    oit_scene_expect(oit_end(t->oit), "oit_end");
}

static oit_operator link_operator(void) {
    oit_operator op = {.kind = OIT_RUN_LINK};
    op.link.radius = 2;
    return op;
}

/* ---- what the GPU holds ---- */

typedef struct seen {
    const oit_context *oit;
    uint32_t *pixels, *records, *surfaces;
    size_t slots[PIXELS + 1];
    ref_smart_image image;
} seen;

static uint32_t *read_buffer(const oit_context *oit, int index) {
    uint32_t *words = malloc((size_t)oit->sizes[index]);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_COPY_READ_BUFFER, oit->buffers[index]);
    const void *mapped = glMapBufferRange(GL_COPY_READ_BUFFER, 0, (GLsizeiptr)oit->sizes[index], GL_MAP_READ_BIT);
    assert_non_null(mapped);
    memcpy(words, mapped, (size_t)oit->sizes[index]);
    glUnmapBuffer(GL_COPY_READ_BUFFER);
    return words;
}

static void take_fragment(const seen *g, uint32_t record, ref_smart_fragment *f) {
    static const int kinds[4] = {REF_SMART_SURFACE, REF_SMART_ADD, REF_SMART_MULTIPLY, REF_SMART_LINE};
    oit_i_record at = oit_i_layout(&g->oit->desc);
    const uint32_t *words = g->records + (size_t)record * (size_t)at.words;
    oit_pick pick = {0};
    oit_i_read_record(&g->oit->desc, words, &pick);
    memset(f, 0, sizeof *f);
    f->depth = (double)pick.depth;
    for (int k = 0; k < 2; ++k)
        f->slope[k] = (double)oit_i_half(words[at.slope] >> (16 * k) & 0xffffu) / 4096;
    for (int k = 0; k < 3; ++k) {
        f->normal[k] = (double)pick.normal[k];
        f->color[k] = (double)pick.color[k];
    }
    f->alpha = (double)pick.color[3];
    f->part = pick.part;
    f->kind = kinds[pick.blend & 3];
}

static seen look(const oit_context *oit) {
    seen g = {.oit = oit};
    g.pixels = read_buffer(oit, OIT_I_PIXELS);
    g.records = read_buffer(oit, OIT_I_FRAGMENTS);
    g.surfaces = read_buffer(oit, OIT_I_SURFACE);
    g.image.width = oit->frame.width;
    g.image.height = oit->frame.height;
    size_t pixels = (size_t)g.image.width * (size_t)g.image.height;
    g.image.start = calloc(pixels + 1, sizeof *g.image.start);
    for (size_t p = 0; p < pixels; ++p) {
        int32_t left = (int32_t)g.pixels[17 + 2 * p];
        g.slots[p] = g.pixels[16 + 2 * p] + (left > 0 ? (uint32_t)left : 0);
        g.image.start[p + 1] = g.image.start[p] + g.pixels[18 + 2 * p] - g.slots[p];
    }
    g.image.fragments = calloc(g.image.start[pixels] + 1, sizeof *g.image.fragments);
    for (size_t p = 0; p < pixels; ++p)
        for (size_t i = 0; i < g.image.start[p + 1] - g.image.start[p]; ++i)
            take_fragment(&g, g.surfaces[oit->sections[OIT_I_AT_ORDER] + g.slots[p] + i],
                          &g.image.fragments[g.image.start[p] + i]);
    return g;
}

static void forget(seen *g) {
    free(g->pixels);
    free(g->records);
    free(g->surfaces);
    free(g->image.start);
    free(g->image.fragments);
}

static uint32_t word_at(const seen *g, int section, size_t slot) {
    assert_true(g->oit->sections[section] != 0);
    return g->surfaces[g->oit->sections[section] + slot];
}

static double number_at(const seen *g, int section, size_t slot) {
    uint32_t bits = word_at(g, section, slot);
    float x;
    memcpy(&x, &bits, sizeof x);
    return (double)x;
}

static int link_at(const seen *g, size_t slot, int direction) {
    if (!g->oit->wide) {
        uint32_t layer = word_at(g, OIT_I_AT_LINKS, slot) >> (8 * direction) & 255u;
        return layer == 255 ? -1 : (int)layer;
    }
    uint32_t word = word_at(g, direction < 2 ? OIT_I_AT_LINKS : OIT_I_AT_LINKS_HIGH, slot);
    uint32_t layer = word >> (16 * (direction & 1)) & 65535u;
    return layer == 65535 ? -1 : (int)layer;
}

/* In the image's order: pixel, layer. */
#define EACH_FRAGMENT(g, p, i, f)                                                                                      \
    for (size_t p = 0; p < (size_t)(g)->image.width * (size_t)(g)->image.height; ++p)                                  \
        for (size_t i = 0; i < (g)->image.start[p + 1] - (g)->image.start[p]; ++i)                                     \
            for (ref_smart_fragment *f = &(g)->image.fragments[(g)->image.start[p] + i]; f; f = NULL)

/* The GPU's links, for what is built on them. */
static void take_links(seen *g) {
    EACH_FRAGMENT(g, p, i, f) {
        int x = (int)(p % (size_t)g->image.width), y = (int)(p / (size_t)g->image.width);
        for (int d = 0; d < 4; ++d) {
            int to_x = x, to_y = y;
            f->link[d] = link_at(g, g->slots[p] + i, d);
            f->no_neighbour[d] = !ref_smart_next(&g->image, &to_x, &to_y, d);
        }
    }
}

/* ---- links ---- */

static ref_smart_links truth_of(const oit_scene *s, oit_criterion criterion) {
    static const ref_smart_criterion same[4] = {REF_SMART_BY_DEPTH, REF_SMART_BY_UV, REF_SMART_PUBLISHED,
                                                REF_SMART_MURRAY};
    ref_smart_links links = {
        .criterion = same[criterion], .depth_weight = 0.5, .normal_weight = 0.5, .radius = 2, .limit = 0.05};
    memcpy(links.projection, s->scene.projection, sizeof links.projection);
    return links;
}

static void compare_links(seen *g, const ref_smart_links *links, size_t *compared) {
    size_t wrong = 0, there = 0;
    ref_smart_link(&g->image, links);
    EACH_FRAGMENT(g, p, i, f)
    for (int d = 0; d < 4; ++d) {
        wrong += f->link[d] != link_at(g, g->slots[p] + i, d);
        there += f->link[d] >= 0;
    }
    /* Published has no limit: where a surface ends, two others may be as far but for a float's rounding. */
    assert_true(links->criterion == REF_SMART_PUBLISHED ? 1000 * wrong <= there : wrong == 0);
    *compared += there;
}

static void test_links(void **state) {
    static const oit_criterion criteria[] = {OIT_LINK_DEPTH, OIT_LINK_DEPTH, OIT_LINK_DEPTH, OIT_LINK_PUBLISHED,
                                             OIT_LINK_MURRAY};
    static const oit_search searches[] = {OIT_SEARCH_WINDOWED, OIT_SEARCH_BRUTE, OIT_SEARCH_BUCKETS,
                                          OIT_SEARCH_WINDOWED, OIT_SEARCH_BUCKETS};
    (void)state;
    for (int es = 0; es < 2; ++es) {
        oit_setting t;
        oit_setting_open(&t, es, WIDTH, HEIGHT, 0, GL_RGBA32F, every_operator());
        for (int kind = 0; kind <= ROUGH; ++kind) {
            oit_scene s;
            size_t compared = 0;
            make_scene(&s, kind);
            oit_frame frame = frame_of(&s, &t);
            begin(&t, &s, &frame);
            for (int i = 0; i < 10; ++i) {
                oit_operator op = link_operator();
                op.link.criterion = criteria[i % 5];
                op.link.search = searches[i % 5];
                op.link.no_reverse_check = i >= 5;
                if (kind == ROUGH) {
                    op.link.depth_weight = 0.3f;
                    op.link.normal_weight = 0.1f;
                    op.link.limit = -1; /* none */
                }
                run(&t, op);
                seen g = look(t.oit);
                ref_smart_links links = truth_of(&s, criteria[i % 5]);
                links.no_reverse_check = i >= 5;
                if (kind == ROUGH) {
                    links.depth_weight = (double)op.link.depth_weight;
                    links.normal_weight = (double)op.link.normal_weight;
                    links.limit = (double)INFINITY;
                }
                compare_links(&g, &links, &compared);
                forget(&g);
            }
            finish(&t);
            print_message("    scene %d: %zu links\n", kind, compared);
            assert_true(compared > 10000);
            oit_scene_drop(&s);
        }
        oit_setting_close(&t);
    }
}

/* The window looks at fewer pairs than all. */
static void test_pairs_looked_at(void **state) {
    oit_setting t;
    oit_scene s;
    uint32_t pairs[2];
    (void)state;
    oit_setting_open(&t, false, WIDTH, HEIGHT, 0, GL_RGBA32F, every_operator());
    oit_scene_init(&s, WIDTH, HEIGHT);
    oit_scene_camera(&s, 4, 2, 8, 0.268);
    add_sheets(&s, 24, 1, 0.8, 0, false);
    oit_frame frame = frame_of(&s, &t);
    for (int brute = 0; brute < 2; ++brute) {
        oit_operator op = link_operator();
        begin(&t, &s, &frame);
        op.link.search = brute ? OIT_SEARCH_BRUTE : OIT_SEARCH_WINDOWED;
        op.link.count_pairs = 1;
        run(&t, op);
        uint32_t *words = read_buffer(t.oit, OIT_I_SURFACE);
        pairs[brute] = words[0];
        free(words);
        finish(&t);
    }
    print_message("    pairs: window %u, all %u\n", pairs[0], pairs[1]);
    assert_true(pairs[0] > 0 && 5 * (uint64_t)pairs[0] < pairs[1]);
    oit_scene_drop(&s);
    oit_setting_close(&t);
}

/* Where a sheet ends midway between two that begin, both are as far as can be told: the nearer to the eye is taken. */
static void test_ties(void **state) {
    static const double color[4] = {1, 1, 1, 0.5}, middle[4] = {0, 0, 0, 0}, nearer[4] = {0.25, 0.25, 0.25, 0.25},
                        farther[4] = {-0.25, -0.25, -0.25, -0.25};
    oit_setting t;
    oit_scene s;
    size_t compared = 0;
    (void)state;
    oit_setting_open(&t, false, 8, 8, 0, GL_RGBA32F, every_operator());
    oit_scene_init(&s, 8, 8);
    s.scene.projection[10] = -1; /* the eye looks along -z */
    oit_scene_quad(&s, -1, -1, 0, 1, middle, color);
    oit_scene_quad(&s, 0, -1, 1, 1, nearer, color);
    oit_scene_quad(&s, 0, -1, 1, 1, farther, color);
    for (size_t i = 0; i < 3; ++i)
        s.objects[i].part = 1;
    oit_frame frame = frame_of(&s, &t);
    for (int search = 0; search < 3; ++search) {
        oit_operator op = link_operator();
        op.link.search = (oit_search)search;
        op.link.limit = 1;
        begin(&t, &s, &frame);
        run(&t, op);
        seen g = look(t.oit);
        ref_smart_links links = truth_of(&s, OIT_LINK_DEPTH);
        links.limit = 1;
        compare_links(&g, &links, &compared);
        size_t slot = g.slots[4 * 8 + 3];
        assert_int_equal(link_at(&g, slot, REF_SMART_RIGHT), 0);
        forget(&g);
        finish(&t);
    }
    oit_scene_drop(&s);
    oit_setting_close(&t);
}

/* Layers beyond 254, whose links take 16 bits. */
static void test_wide_links(void **state) {
    oit_setting t;
    oit_scene s;
    size_t compared = 0;
    (void)state;
    oit_setting_open(&t, false, 6, 5, 0, GL_RGBA32F, every_operator());
    oit_scene_init(&s, 6, 5);
    oit_scene_camera(&s, 4, 2, 8, 0.268);
    add_sheets(&s, 300, 1, 0.4, 0, false);
    oit_frame frame = frame_of(&s, &t);
    begin(&t, &s, &frame);
    run(&t, link_operator());
    seen g = look(t.oit);
    ref_smart_links links = truth_of(&s, OIT_LINK_DEPTH);
    assert_true(t.oit->wide);
    compare_links(&g, &links, &compared);
    assert_true(compared > 10000);
    forget(&g);
    finish(&t);
    oit_scene_drop(&s);
    oit_setting_close(&t);
}

/* ---- fields ---- */

static oit_operator law_operator(oit_law_kind kind, float s) {
    oit_operator op = {.kind = OIT_RUN_LAW};
    op.law.kind = kind;
    op.law.s = s;
    return op;
}

static double spread_value(uint32_t distance, int steps, double lambda) {
    return (int)distance <= steps ? fmax(1 - lambda * distance, 0) : 0;
}

typedef struct field_errors {
    double base, beta, gamma;
    size_t fragments, off[3], above; /* off by more than 0.01; above the truth */
} field_errors;

/* Against the reference run on the GPU's links. beta and gamma by their distances where `diffused` is 0. */
static field_errors compare_fields(seen *g, const oit_smart *smart, ref_smart_laplacian laplacian, bool diffused) {
    field_errors e = {0};
    ref_smart_image *image = &g->image;
    take_links(g);
    ref_smart_begin(image, 0.3);
    assert_true(ref_smart_spread(image, REF_SMART_BASE, false, (double)smart->base.lambda, laplacian,
                                 (size_t)smart->base.iterations));
    assert_true(ref_smart_spread(image, REF_SMART_BETA, !diffused, (double)smart->beta.lambda, laplacian,
                                 (size_t)smart->beta.iterations));
    assert_true(ref_smart_spread(image, REF_SMART_GAMMA, !diffused, (double)smart->gamma.lambda, laplacian,
                                 (size_t)smart->gamma.iterations));
    EACH_FRAGMENT(g, p, i, f) {
        size_t slot = g->slots[p] + i;
        uint32_t reach = word_at(g, OIT_I_AT_REACH, slot);
        double beta = diffused ? number_at(g, OIT_I_AT_BETA, slot)
                               : spread_value(reach & 65535u, smart->beta.iterations, (double)smart->beta.lambda);
        double gamma = diffused ? number_at(g, OIT_I_AT_GAMMA, slot)
                                : spread_value(reach >> 16, smart->gamma.iterations, (double)smart->gamma.lambda);
        double base = number_at(g, OIT_I_AT_BASE, slot);
        if (f->kind != REF_SMART_SURFACE)
            continue;
        e.base = fmax(e.base, fabs(base - f->base));
        e.beta = fmax(e.beta, fabs(beta - f->beta));
        e.gamma = fmax(e.gamma, fabs(gamma - f->gamma));
        e.off[0] += !(fabs(base - f->base) <= 0.01);
        e.off[1] += !(fabs(beta - f->beta) <= 0.01);
        e.off[2] += !(fabs(gamma - f->gamma) <= 0.01);
        e.above += beta > f->beta + 1e-6 || gamma > f->gamma + 1e-6;
        ++e.fragments;
    }
    return e;
}

static oit_operator smart_operator(int steps, float lambda) {
    oit_operator op = {.kind = OIT_RUN_SMART};
    op.smart.base.iterations = op.smart.beta.iterations = op.smart.gamma.iterations = steps;
    op.smart.base.lambda = 1;
    op.smart.beta.lambda = op.smart.gamma.lambda = lambda;
    return op;
}

/* Iterated: to float's rounding. 4: jumps; 5: jumps until stable; 6: diffusion of all three; 7: odd numbers of steps. */
static void test_fields(void **state) {
    oit_setting t;
    (void)state;
    oit_setting_open(&t, false, WIDTH, HEIGHT, 0, GL_RGBA32F, every_operator());
    for (int kind = 0; kind < SCENES; ++kind) {
        oit_scene s;
        make_scene(&s, kind);
        oit_frame frame = frame_of(&s, &t);
        begin(&t, &s, &frame);
        run(&t, link_operator());
        for (int way = 3; way < 8; ++way) {
            oit_operator op = smart_operator(way == 7 ? 7 : 50, way == 7 ? 0.1f : 0.02f);
            bool jumps = way == 4 || way == 5, diffused = way == 6;
            op.smart.jumps = jumps;
            op.smart.until_stable = way == 5;
            if (diffused) {
                op.smart.beta.process = op.smart.gamma.process = OIT_PROCESS_DIFFUSION;
                op.smart.beta.lambda = op.smart.gamma.lambda = 1;
            }
            run(&t, law_operator(OIT_LAW_ADAPTIVE, 0.3f));
            run(&t, op);
            seen g = look(t.oit);
            field_errors e = compare_fields(&g, &op.smart, REF_SMART_EIGHTH, diffused);
            print_message("    scene %d way %d: base %.2g beta %.2g gamma %.2g; off %zu %zu %zu of %zu\n", kind, way,
                          e.base, e.beta, e.gamma, e.off[0], e.off[1], e.off[2], e.fragments);
            assert_true(e.fragments > 3000);
            if (!jumps)
                assert_true(e.base <= 1e-4);
            if (way != 4) /* a float's rounding of lambda times the distance */
                assert_true(e.beta <= 1e-6 + (diffused ? 1e-4 : 0) && e.gamma <= 1e-6 + (diffused ? 1e-4 : 0));
            for (int k = 0; k < 3; ++k) /* a thousandth of them */
                assert_true(1000 * e.off[k] <= e.fragments);
            assert_int_equal(e.above, 0);
            forget(&g);
        }
        finish(&t);
        oit_scene_drop(&s);
    }
    oit_setting_close(&t);
}

/* An edge along the rows: the first pass, along rows, changes nothing, and the columns still have to come. */
static void test_stable_after_columns(void **state) {
    static const double color[4] = {1, 1, 1, 0.5}, depths[4] = {0, 0, 0, 0};
    oit_setting t;
    oit_scene s;
    (void)state;
    oit_setting_open(&t, false, 8, 40, 0, GL_RGBA32F, every_operator());
    oit_scene_init(&s, 8, 40);
    s.scene.projection[10] = -1;
    oit_scene_quad(&s, -2, -2, 2, 0.5, depths, color); /* up to row 29 */
    oit_frame frame = frame_of(&s, &t);
    oit_operator op = smart_operator(25, 0.02f);
    op.smart.jumps = op.smart.until_stable = 1;
    begin(&t, &s, &frame);
    run(&t, link_operator());
    run(&t, op);
    seen g = look(t.oit);
    for (size_t y = 5; y < 30; ++y)
        assert_int_equal(word_at(&g, OIT_I_AT_REACH, g.slots[8 * y + 3]) & 65535u, 29 - y);
    forget(&g);
    finish(&t);
    oit_scene_drop(&s);
    oit_setting_close(&t);
}

/* lambda from 0 to 1, many steps: in [0,1], and nothing that alternates from pixel to pixel grows. */
static void test_fields_stay_in_range(void **state) {
    static const float lambdas[] = {-1, 0.1f, 0.25f, 0.5f, 1}; /* negative: 0 */
    oit_setting t;
    oit_scene s;
    (void)state;
    oit_setting_open(&t, false, WIDTH, HEIGHT, 0, GL_RGBA32F, every_operator());
    make_scene(&s, 2);
    oit_frame frame = frame_of(&s, &t);
    begin(&t, &s, &frame);
    run(&t, link_operator());
    for (int i = 0; i < 10; ++i) {
        oit_operator op = smart_operator(i < 5 ? 1000 : 1, lambdas[i % 5]);
        op.smart.base.lambda = lambdas[i % 5];
        run(&t, law_operator(OIT_LAW_ADAPTIVE, 0.9f));
        run(&t, op);
        seen g = look(t.oit);
        EACH_FRAGMENT(&g, p, k, f) {
            double base = number_at(&g, OIT_I_AT_BASE, g.slots[p] + k);
            assert_true(base >= 0 && base <= 0.9 + 1e-6 && f->kind == REF_SMART_SURFACE);
        }
        forget(&g);
    }
    finish(&t);
    oit_scene_drop(&s);
    oit_setting_close(&t);
}

/* ---- curvature ---- */

static void test_curvature(void **state) {
    oit_setting t;
    (void)state;
    oit_setting_open(&t, false, WIDTH, HEIGHT, 0, GL_RGBA32F, every_operator());
    for (int i = 0; i < 2 * SCENES; ++i) {
        oit_scene s;
        double worst = 0;
        make_scene(&s, i / 2);
        oit_frame frame = frame_of(&s, &t);
        oit_operator op = {.kind = OIT_RUN_CURVATURE};
        op.curvature.unit = i & 1 ? 0.3f : 0;
        begin(&t, &s, &frame);
        run(&t, link_operator());
        run(&t, op);
        seen g = look(t.oit);
        ref_smart_view view = {.unit = (double)op.curvature.unit};
        memcpy(view.projection, s.scene.projection, sizeof view.projection);
        take_links(&g);
        ref_smart_curve(&g.image, &view);
        EACH_FRAGMENT(&g, p, k, f)
        worst = fmax(worst, fabs(number_at(&g, OIT_I_AT_KAPPA, g.slots[p] + k) - f->kappa));
        print_message("    scene %d, unit %.1f: %.2g\n", i / 2, (double)op.curvature.unit, worst);
        assert_true(worst <= 1e-3); /* positions in floats, a thousandth of a pixel's step */
        forget(&g);
        finish(&t);
        oit_scene_drop(&s);
    }
    oit_setting_close(&t);
}

/* A sphere of radius R has kappa1 + kappa2 = -2/R in units of the world, near and far. */
static void test_curvature_of_a_sphere(void **state) {
    static const double distances[] = {3, 12}, center[3] = {0, 0, 0}, color[4] = {1, 1, 1, 0.5};
    oit_setting t;
    (void)state;
    oit_setting_open(&t, false, WIDTH, HEIGHT, 0, GL_RGBA32F, every_operator());
    for (int i = 0; i < 2; ++i) {
        oit_scene s;
        double sum = 0;
        size_t count = 0;
        oit_scene_init(&s, WIDTH, HEIGHT);
        oit_scene_camera(&s, distances[i], 1, 20, 1.5 / distances[i]);
        oit_scene_ball(&s, center, 0.8, 96, 96, color);
        oit_frame frame = frame_of(&s, &t);
        oit_operator op = {.kind = OIT_RUN_CURVATURE};
        op.curvature.unit = 0.5f;
        begin(&t, &s, &frame);
        run(&t, link_operator());
        run(&t, op);
        seen g = look(t.oit);
        EACH_FRAGMENT(&g, p, k, f) {
            if (f->normal[2] < 0.5) /* steep: chords are longer */
                continue;
            sum += number_at(&g, OIT_I_AT_KAPPA, g.slots[p] + k);
            ++count;
        }
        print_message("    distance %g: %.4f, expected %.4f\n", distances[i], sum / (double)count, -tanh(1 / 0.8));
        assert_true(count > 100 && fabs(sum / (double)count + tanh(1 / 0.8)) < 0.02);
        forget(&g);
        finish(&t);
        oit_scene_drop(&s);
    }
    oit_setting_close(&t);
}

/* ---- laws and the picture ---- */

static double law_truth(const seen *g, size_t p, const ref_smart_fragment *f, oit_law_kind kind,
                        const double *projection) {
    int x = (int)(p % (size_t)g->image.width), y = (int)(p / (size_t)g->image.width);
    double place[3], through[3], facing = 0, length = 0, v = 0;
    if (kind == OIT_LAW_GIVEN)
        return f->alpha;
    if (kind == OIT_LAW_CONSTANT)
        return 0.3;
    if (kind == OIT_LAW_ADAPTIVE)
        return ref_smart_adaptive(0.3, ref_smart_layers(&g->image, x, y));
    if (kind == OIT_LAW_ANGLE) { /* the eye is where all rays meet, at the origin */
        ref_smart_place(&g->image, projection, x, y, f->depth, place);
        for (int k = 0; k < 3; ++k) {
            facing -= place[k] * f->normal[k];
            length += place[k] * place[k];
        }
        return 1 - 0.7 * fabs(facing) / sqrt(length);
    }
    for (int axis = 0; axis < 2; ++axis) {
        const ref_smart_fragment *low = ref_smart_linked(&g->image, x, y, f, 2 * axis);
        const ref_smart_fragment *high = ref_smart_linked(&g->image, x, y, f, 2 * axis + 1);
        for (int k = 0; k < 3; ++k)
            through[k] = (high ? high : f)->normal[k] - (low ? low : f)->normal[k];
        v += ref_smart_dot(through, through) * (low && high ? 0.25 : 1);
    }
    return 1 - 0.7 * exp(-4 * sqrt(v));
}

static void test_laws(void **state) {
    oit_setting t;
    (void)state;
    oit_setting_open(&t, false, WIDTH, HEIGHT, 0, GL_RGBA32F, every_operator());
    for (int kind = 2; kind < SCENES; ++kind) {
        oit_scene s;
        make_scene(&s, kind);
        oit_frame frame = frame_of(&s, &t);
        begin(&t, &s, &frame);
        run(&t, link_operator());
        for (int law = 0; law < (int)OIT_LAW_DISTANCE; ++law) {
            double worst = 0;
            run(&t, law_operator((oit_law_kind)law, 0.3f));
            seen g = look(t.oit);
            take_links(&g);
            EACH_FRAGMENT(&g, p, i, f)
            if (f->kind == REF_SMART_SURFACE)
                worst = fmax(worst, fabs(number_at(&g, OIT_I_AT_BASE, g.slots[p] + i) -
                                         law_truth(&g, p, f, (oit_law_kind)law, s.scene.projection)));
            print_message("    scene %d, law %d: %.2g\n", kind, law, worst);
            assert_true(worst <= 1e-4);
            forget(&g);
        }
        run(&t, smart_operator(20, 0.05f));
        run(&t, law_operator(OIT_LAW_DISTANCE, 0.3f));
        seen g = look(t.oit);
        EACH_FRAGMENT(&g, p, i, f) {
            uint32_t steps = word_at(&g, OIT_I_AT_REACH, g.slots[p] + i) & 65535u;
            if (f->kind == REF_SMART_SURFACE)
                assert_true(fabs(number_at(&g, OIT_I_AT_BASE, g.slots[p] + i) - (1 - 0.7 * fmin(steps / 20.0, 1))) <
                            1e-5);
        }
        forget(&g);
        finish(&t);
        oit_scene_drop(&s);
    }
    oit_setting_close(&t);
}

static double profiled(double u, oit_profile profile, double p) {
    return profile == OIT_PROFILE_10   ? ref_smart_profile_10(u, p)
           : profile == OIT_PROFILE_11 ? ref_smart_profile_11(u, p)
                                       : u;
}

/* Front to back from the image's fields, what adds as light that hides nothing. */
static void compose_truth(const ref_smart_image *image, int x, int y, double color[3]) {
    double sum[3] = {0, 0, 0}, through = 1;
    for (size_t i = 0; i < ref_smart_count(image, x, y); ++i) {
        const ref_smart_fragment *f = ref_smart_at(image, x, y, i);
        double opacity = f->kind == REF_SMART_SURFACE ? (1 - f->gamma) * (f->base + (1 - f->base) * f->beta) : f->alpha;
        for (int k = 0; k < 3; ++k)
            sum[k] += through * opacity * f->color[k];
        if (f->kind != REF_SMART_ADD)
            through *= 1 - opacity;
    }
    for (int k = 0; k < 3; ++k)
        color[k] = sum[k] + through * color[k];
}

static double picture_error(const float *picture, const ref_smart_image *image, const double background[3]) {
    double worst = 0;
    for (int y = 0; y < image->height; ++y)
        for (int x = 0; x < image->width; ++x) {
            double color[3] = {background[0], background[1], background[2]};
            compose_truth(image, x, y, color);
            for (int k = 0; k < 3; ++k)
                worst = fmax(worst, fabs((double)picture[4 * (y * image->width + x) + k] - color[k]));
        }
    return worst;
}

/* Every store, ways of OIT_STATE_NONE and profiles; lines and lights as they are. */
static void test_pictures(void **state) {
    static const oit_store_kind stores[] = {OIT_STORE_EXACT, OIT_STORE_PREDICT, OIT_STORE_LINKED, OIT_STORE_BUDGET,
                                            OIT_STORE_BUCKETED};
    (void)state;
    for (int i = 0; i < 10; ++i) {
        oit_setting t;
        oit_scene s;
        oit_desc desc = every_operator();
        desc.store = stores[i % 5];
        desc.layers = 16;
        desc.fit = i >= 5 ? OIT_FIT_ASYNC : OIT_FIT_WAIT;
        oit_setting_open(&t, i == 5, WIDTH, HEIGHT, 0, GL_RGBA32F, desc);
        make_scene(&s, 3);
        oit_frame frame = frame_of(&s, &t);
        oit_operator op = smart_operator(20, 0.05f);
        op.smart.beta.profile = i & 1 ? OIT_PROFILE_10 : OIT_PROFILE_11;
        op.smart.gamma.profile = i % 3 ? OIT_PROFILE_10 : OIT_PROFILE_NONE;
        op.smart.gamma.p = i % 3 == 1 ? -1.0f : 2.0f; /* the limit p = 0 */
        for (int frames = 0; frames < 3; ++frames) {
            begin(&t, &s, &frame);
            run(&t, link_operator());
            run(&t, law_operator(OIT_LAW_ADAPTIVE, 0.3f));
            run(&t, op);
            if (frames < 2)
                finish(&t);
        }
        seen g = look(t.oit);
        finish(&t);
        compare_fields(&g, &op.smart, REF_SMART_EIGHTH, false);
        EACH_FRAGMENT(&g, p, k, f) {
            f->beta = profiled(f->beta, op.smart.beta.profile, i & 1 ? 3 : 0.3);
            f->gamma = profiled(f->gamma, op.smart.gamma.profile, i % 3 == 1 ? 0 : 2);
        }
        float *picture = oit_setting_read(&t, t.framebuffer);
        double worst = picture_error(picture, &g.image, s.scene.background);
        print_message("    store %d, fit %d: %.2g\n", (int)desc.store, (int)desc.fit, worst);
        assert_true(worst <= 1.0 / 2550);
        free(picture);
        forget(&g);
        oit_scene_drop(&s);
        oit_setting_close(&t);
    }
}

/* Two contexts that differ in nothing but who sets the state make the same bits. */
static void test_state_none(void **state) {
    float *pictures[2];
    (void)state;
    for (int raw = 0; raw < 2; ++raw) {
        oit_setting t;
        oit_scene s;
        oit_desc desc = every_operator();
        oit_pass pass;
        desc.fit = OIT_FIT_ASYNC;
        desc.state = raw ? OIT_STATE_NONE : OIT_STATE_RESTORE;
        oit_setting_open(&t, false, WIDTH, HEIGHT, 0, GL_RGBA32F, desc);
        make_scene(&s, 2);
        oit_frame frame = frame_of(&s, &t);
        const oit_operator ops[] = {link_operator(),
                                    smart_operator(20, 0.05f),
                                    {.kind = OIT_RUN_CURVATURE, .curvature = {.shade = OIT_SHADE_CONVEX}}};
        for (int frames = 0; frames < 3; ++frames) {
            oit_setting_clear(&t, &s);
            oit_scene_expect(oit_begin(t.oit, &frame), "oit_begin");
            for (int step = 0; step < 5; ++step) {
                while (oit_next_pass(t.oit, &pass)) {
                    if (raw)
                        oit_scene_apply(&pass);
                    if (!pass.state.groups[0] && !pass.state.vertex_count)
                        oit_scene_draw(&s, t.oit, &pass, NULL);
                }
                if (step < 3)
                    run(&t, ops[step]);
                else if (step == 3)
                    oit_scene_expect(oit_compose(t.oit), "oit_compose");
            }
            oit_scene_expect(oit_end(t.oit), "oit_end");
            oit_scene_reset_state();
        }
        pictures[raw] = oit_setting_read(&t, t.framebuffer);
        oit_scene_drop(&s);
        oit_setting_close(&t);
    }
    assert_memory_equal(pictures[0], pictures[1], 4 * PIXELS * sizeof(float));
    free(pictures[0]);
    free(pictures[1]);
}

/* ---- the host's own ---- */

static GLuint host_program(const oit_context *oit, const char *text) {
    const char *strings[OIT_I_MAX_STRINGS + 1];
    int count = 0;
    const char *const *before = oit_operator_glsl(oit, &count);
    GLuint shader = glCreateShader(GL_COMPUTE_SHADER), program = glCreateProgram();
    GLint ok = 0;
    char log[1024] = "";
    memcpy(strings, before, (size_t)count * sizeof strings[0]);
    strings[count] = text;
    glShaderSource(shader, count + 1, strings, NULL);
    glCompileShader(shader);
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    glAttachShader(program, shader);
    glDeleteShader(shader);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    if (!ok)
        fail_msg("%s", log);
    return program;
}

/* Equation 8 written by a host makes what ours makes; a purely local operator writes what it is told. */
static void test_host_operators(void **state) {
    static const char diffusion[] = "void oit_operate(uint p)\n{\n    uint first, n = oit_list(p, first);\n"
                                    "    for (uint i = 0u; i < n; ++i) {\n"
                                    "        float value = oit_before(first + i), sum = 0.0;\n"
                                    "        for (uint d = 0u; d < 4u; ++d) {\n"
                                    "            uint other = oit_neighbour(p, first + i, d);\n"
                                    "            if (other != OIT_NONE)\n"
                                    "                sum += oit_before(other) - value;\n        }\n"
                                    "        oit_set_after(first + i, value + 0.125 * sum);\n    }\n}\n";
    static const char copy[] =
        "void oit_operate(uint p)\n{\n    uint first, n = oit_list(p, first);\n"
        "    for (uint i = 0u; i < n; ++i)\n"
        "        oit_set_value(OIT_HOST + 1u, first + i, 2.0 * oit_value(OIT_BASE, first + i));\n}\n";
    (void)state;
    for (int es = 0; es < 2; ++es) {
        oit_setting t;
        oit_scene s;
        oit_setting_open(&t, es, WIDTH, HEIGHT, 0, GL_RGBA32F, every_operator());
        make_scene(&s, 2);
        oit_frame frame = frame_of(&s, &t);
        oit_operator op = {.kind = OIT_RUN_HOST};
        GLuint programs[2] = {host_program(t.oit, diffusion), host_program(t.oit, copy)};
        begin(&t, &s, &frame);
        run(&t, link_operator());
        run(&t, law_operator(OIT_LAW_ADAPTIVE, 0.3f));
        op.host.program = programs[0];
        op.host.iterations = 7;
        run(&t, op);
        op.host.program = programs[1];
        op.host.iterations = 0;
        op.host.value = OIT_VALUE_HOST + 1;
        run(&t, op);
        seen g = look(t.oit);
        take_links(&g);
        ref_smart_begin(&g.image, 0.3);
        assert_true(ref_smart_spread(&g.image, REF_SMART_BASE, false, 1, REF_SMART_EIGHTH, 7));
        EACH_FRAGMENT(&g, p, i, f) {
            size_t slot = g.slots[p] + i;
            assert_true(fabs(number_at(&g, OIT_I_AT_BASE, slot) - f->base) < 1e-5);
            assert_true(fabs(number_at(&g, OIT_I_AT_HOST + 1, slot) - 2 * f->base) < 1e-5);
        }
        forget(&g);
        finish(&t);
        for (int k = 0; k < 2; ++k)
            glDeleteProgram(programs[k]);
        oit_scene_drop(&s);
        oit_setting_close(&t);
    }
}

/* Fields end within their share of the width: two slits apart, the halo between them is narrower. */
static void test_thin(void **state) {
    double sums[2] = {0, 0};
    (void)state;
    for (int thin = 0; thin < 2; ++thin) {
        oit_setting t;
        oit_scene s;
        oit_setting_open(&t, false, WIDTH, HEIGHT, 0, GL_RGBA32F, every_operator());
        make_scene(&s, 0);
        oit_frame frame = frame_of(&s, &t);
        oit_operator op = smart_operator(30, 0.02f);
        op.smart.thin = thin ? 0.1f : 0;
        begin(&t, &s, &frame);
        run(&t, link_operator());
        run(&t, law_operator(OIT_LAW_CONSTANT, 0.2f));
        run(&t, op);
        finish(&t);
        float *picture = oit_setting_read(&t, t.framebuffer);
        for (size_t i = 0; i < PIXELS; ++i)
            sums[thin] += (double)picture[4 * i + 1];
        free(picture);
        oit_scene_drop(&s);
        oit_setting_close(&t);
    }
    print_message("    green in all: %.0f, with thin %.0f\n", sums[0], sums[1]);
    assert_true(sums[1] > 1.02 * sums[0]); /* less of the surfaces before the white background */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_links),
        cmocka_unit_test(test_pairs_looked_at),
        cmocka_unit_test(test_ties),
        cmocka_unit_test(test_wide_links),
        cmocka_unit_test(test_fields),
        cmocka_unit_test(test_stable_after_columns),
        cmocka_unit_test(test_fields_stay_in_range),
        cmocka_unit_test(test_curvature),
        cmocka_unit_test(test_curvature_of_a_sphere),
        cmocka_unit_test(test_laws),
        cmocka_unit_test(test_pictures),
        cmocka_unit_test(test_state_none),
        cmocka_unit_test(test_host_operators),
        cmocka_unit_test(test_thin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* gl_smart.c: smart transparency of oit_buffers.h on a real driver: fields and pictures held to reference_smart.h on the
 * same fragments; that they are stable, in range and free of patterns for every lambda and number of steps; jumps; reach
 * limited by feature size; hard cases; the XT-junction. */
#include "smart_truth.h"

enum { WIDTH = 36, HEIGHT = 27, ROOM = 1 << 15 };

/* ---- fields and pictures ---- */

static void fields_and_pictures_are_those_of_the_truth(void **state) {
    (void)state;
    for (int es = 0; es < 2; ++es) {
        smart_stage t;
        smart_stage_open_wide(&t, es, WIDTH, HEIGHT, smart_truth_desc, ROOM);
        for (size_t i = es ? SMART_TRUTH_SCENES - 2 : 0; i < SMART_TRUTH_SCENES; ++i) {
            oit_operator law = smart_truth_law(i & 1 ? OIT_LAW_ADAPTIVE : OIT_LAW_ANGLE, 0),
                         smart = smart_truth_smart(0, 0);
            smart_truth_scenes[i].make(&t);
            smart_truth_expect(&t, smart_truth_scenes[i].name, &law.law, &smart.smart);
        }
        smart_stage_close(&t);
    }
}

/* A field each with numbers of its own; all else as by default. */
static void every_setting_is_that_of_the_truth(void **state) {
    static const struct {
        const char *name;
        oit_smart smart;
    } settings[] = {
        {"profile 10", {.beta = {.profile = OIT_PROFILE_10}, .gamma = {.profile = OIT_PROFILE_10, .p = 8}}},
        {"profile 10, p -> 0",
         {.beta = {.profile = OIT_PROFILE_10, .p = -1}, .gamma = {.profile = OIT_PROFILE_10, .p = 1e-4f}}},
        {"profile 11", {.beta = {.profile = OIT_PROFILE_11}, .gamma = {.profile = OIT_PROFILE_11, .p = 2}}},
        {"profile 11, p -> 0", {.beta = {.profile = OIT_PROFILE_11, .p = 1e-6f}, .gamma = {.profile = OIT_PROFILE_10}}},
        {"lambda 0 and 1", {.beta = {.lambda = -1}, .gamma = {.lambda = 1}, .base = {.lambda = 0.3f}}},
        {"no steps", {.beta = {.iterations = -1}, .gamma = {.iterations = -1}, .base = {.iterations = -1}}},
        {"other steps each", {.beta = {.iterations = 3}, .gamma = {.iterations = 17}, .base = {.iterations = 8}}},
        {"base longest", {.beta = {.iterations = 5}, .gamma = {.iterations = -1}, .base = {.iterations = 11}}},
        {"beta, gamma diffused",
         {.beta = {.process = OIT_PROCESS_DIFFUSION, .lambda = 0.7f},
          .gamma = {.process = OIT_PROCESS_DIFFUSION, .iterations = 13}}},
        {"beta diffused, gamma not",
         {.beta = {.process = OIT_PROCESS_DIFFUSION, .lambda = 1}, .gamma = {.lambda = 0.2f}}},
        {"gamma diffused, beta not", {.gamma = {.process = OIT_PROCESS_DIFFUSION, .lambda = 1}}},
        {"published", {.published = 1}},
        {"published, diffused",
         {.published = 1,
          .base = {.iterations = 7},
          .beta = {.process = OIT_PROCESS_DIFFUSION, .iterations = 7, .lambda = 0.5f},
          .gamma = {.process = OIT_PROCESS_DIFFUSION, .iterations = 6, .lambda = 1}}},
        {"published, profile 10", {.published = 1, .jumps = 1, .beta = {.profile = OIT_PROFILE_10}}},
    };
    static const size_t which[] = {1, 3, 9};
    smart_stage t;
    (void)state;
    smart_stage_open_wide(&t, false, WIDTH, HEIGHT, smart_truth_desc, ROOM);
    for (size_t i = 0; i < sizeof settings / sizeof settings[0]; ++i)
        for (int k = 0; k < 3; ++k) {
            char name[64];
            oit_operator law = smart_truth_law(OIT_LAW_ADAPTIVE, 0.8f);
            smart_truth_scenes[which[k]].make(&t);
            snprintf(name, sizeof name, "%s, %s", settings[i].name, smart_truth_scenes[which[k]].name);
            smart_truth_expect(&t, name, &law.law, &settings[i].smart);
        }
    smart_stage_close(&t);
}

/* ---- stability ---- */

/* Base of a pattern: the frequency that a step of equation 8 damps least, or of a wave. */
static const char checkers[] =
    "void oit_operate(uint p)\n{\n    uint first, n = oit_list(p, first), w = uint(oit_area.z);\n"
    "    for (uint i = 0u; i < n; ++i)\n"
    "        oit_set_value(OIT_BASE, first + i, float((p % w + p / w) & 1u));\n}\n";
static const char waves[] =
    "void oit_operate(uint p)\n{\n    uint first, n = oit_list(p, first), w = uint(oit_area.z);\n"
    "    for (uint i = 0u; i < n; ++i)\n"
    "        oit_set_value(OIT_BASE, first + i,\n"
    "            0.5 + 0.3 * sin(0.7 * float(p % w) + float(i)) + 0.2 * cos(0.5 * float(p / w)));\n"
    "}\n";

static oit_operator pattern_operator(smart_stage *t, const char *text) {
    oit_operator op;
    memset(&op, 0, sizeof op);
    op.kind = OIT_RUN_HOST;
    op.host.program = smart_stage_program(t->set.oit, text);
    op.host.value = OIT_VALUE_BASE;
    return op;
}

static const float lambdas[5] = {-1, 0.1f, 0.25f, 0.5f, 1}; /* negative: 0 */

/* 1 to 10,000 steps: in [0,1], and the truth's. */
static void fields_are_stable_for_every_lambda_and_many_steps(void **state) {
    static const int steps[5] = {1, 10, 100, 1000, 10000};
    smart_stage t;
    (void)state;
    smart_stage_open_wide(&t, false, 18, 14, smart_truth_desc, 1 << 12);
    smart_truth_sheets(&t, 3, 0.5, 1.2);
    oit_operator link = smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED),
                 pattern = pattern_operator(&t, waves);
    smart_stage_begin(&t, NULL);
    smart_stage_run(&t, &link);
    for (int l = 0; l < 5; ++l) {
        double worst[3] = {0, 0, 0};
        ref_smart_image truth = {0, 0, NULL, NULL};
        for (int s = 0; s < 5; ++s) {
            oit_operator op = smart_truth_smart(steps[s], lambdas[l]);
            op.smart.base.lambda = lambdas[l];
            op.smart.beta.process = l & 1 ? OIT_PROCESS_DIFFUSION : OIT_PROCESS_DEFAULT;
            smart_stage_run(&t, &pattern);
            if (s == 0) {
                truth = smart_stage_look(&t);
                double *base = malloc(smart_truth_count(&truth) * sizeof *base);
                for (size_t i = 0; i < smart_truth_count(&truth); ++i)
                    base[i] = truth.fragments[i].base;
                ref_smart_begin(&truth, -1);
                for (size_t i = 0; i < smart_truth_count(&truth); ++i)
                    truth.fragments[i].base = base[i];
                free(base);
            }
            for (int field = 0; field < 3; ++field) /* on from the steps before */
                assert_true(ref_smart_spread(
                    &truth, field, field == REF_SMART_GAMMA || (field == REF_SMART_BETA && !(l & 1)),
                    fmax((double)lambdas[l], 0), REF_SMART_EIGHTH, (size_t)(steps[s] - (s ? steps[s - 1] : 0))));
            smart_stage_run(&t, &op);
            ref_smart_image image = smart_stage_look(&t);
            for (size_t i = 0; i < smart_truth_count(&image); ++i) {
                const ref_smart_fragment *f = &image.fragments[i], *g = &truth.fragments[i];
                assert_true(smart_truth_in_range(f->base) && smart_truth_in_range(f->beta) &&
                            smart_truth_in_range(f->gamma));
                worst[0] = fmax(worst[0], fabs(f->base - g->base));
                worst[1] = fmax(worst[1], fabs(f->beta - g->beta));
                worst[2] = fmax(worst[2], fabs(f->gamma - g->gamma));
            }
            smart_stage_drop(&image);
        }
        printf("    lambda %4g, 1 to 10,000 steps: base %.1e  beta %.1e  gamma %.1e\n", fmax((double)lambdas[l], 0),
               worst[0], worst[1], worst[2]);
        assert_true(worst[0] <= 1e-4 && worst[1] <= 1e-4 && worst[2] <= 1e-4);
        smart_stage_drop(&truth);
    }
    free(smart_stage_end(&t));
    glDeleteProgram(pattern.host.program);
    smart_stage_close(&t);
}

/* How much of the pattern is left of one sheet, by sign, away from the frame. */
static double checkers_of(const ref_smart_image *image, int margin) {
    double sum = 0;
    int count = 0;
    for (int y = margin; y < image->height - margin; ++y)
        for (int x = margin; x < image->width - margin; ++x, ++count)
            sum += (2 * ref_smart_at(image, x, y, 0)->base - 1) * ((x + y) & 1 ? 1 : -1);
    return sum / count;
}

/* Ours damps a checkerboard by 1 - lambda each step; the mean of four turns it over, for ever at lambda 1, here as in the
 * reference, and the plain five-point sum leaves [0,1] at once. */
static void only_the_published_step_leaves_checkers(void **state) {
    enum { MARGIN = 6 };
    static const double color[4] = {1, 0, 0, 0.5}, flat[4] = {0, 0, 0, 0};
    smart_stage t;
    (void)state;
    smart_stage_open_wide(&t, false, 24, 20, smart_truth_desc, 1 << 10);
    oit_scene *s = smart_stage_clear(&t);
    oit_scene_quad(s, -1, -1, 1, 1, flat, color);
    oit_operator link = smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED),
                 pattern = pattern_operator(&t, checkers);
    smart_stage_begin(&t, NULL);
    smart_stage_run(&t, &link);
    for (int published = 0; published < 2; ++published)
        for (int l = 0; l < 5; ++l)
            for (int steps = 1; steps <= 5; steps += 2) {
                double lambda = fmax((double)lambdas[l], 0), expected = pow(1 - (published ? 2 : 1) * lambda, steps);
                oit_operator op = smart_truth_smart(steps, 0);
                op.smart.base.lambda = lambdas[l];
                op.smart.published = published;
                smart_stage_run(&t, &pattern);
                ref_smart_image before = smart_stage_look(&t);
                smart_stage_run(&t, &op);
                ref_smart_image after = smart_stage_look(&t);
                assert_true(fabs(checkers_of(&after, MARGIN) - expected) < 1e-5);
                assert_true(published || checkers_of(&after, MARGIN) > -1e-5);
                assert_true(ref_smart_spread(&before, REF_SMART_BASE, false, lambda,
                                             published ? REF_SMART_MEAN_OF_FOUR : REF_SMART_EIGHTH, (size_t)steps));
                assert_true(fabs(checkers_of(&before, MARGIN) - expected) < 1e-12);
                smart_stage_drop(&before);
                smart_stage_drop(&after);
            }
    smart_stage_run(&t, &pattern);
    ref_smart_image bare = smart_stage_look(&t);
    assert_true(ref_smart_spread(&bare, REF_SMART_BASE, false, 1, REF_SMART_BARE_SUM, 3));
    assert_true(fabs(ref_smart_at(&bare, 12, 10, 0)->base) > 100);
    smart_stage_drop(&bare);
    free(smart_stage_end(&t));
    glDeleteProgram(pattern.host.program);
    smart_stage_close(&t);
}

/* ---- jumps ---- */

typedef struct jump_counts {
    size_t fragments, off, base_off; /* by more than 0.01 */
    double base;
} jump_counts;

/* Values and steps of jumps against iterated ones. */
static void compare_jumps(const ref_smart_image *a, const smart_stage_row *steps, const ref_smart_image *b,
                          const smart_stage_row *jumped, jump_counts *counts) {
    for (size_t k = 0; k < smart_truth_count(a); ++k) {
        const ref_smart_fragment *f = &a->fragments[k], *g = &b->fragments[k];
        assert_true(g->beta <= f->beta && g->gamma <= f->gamma); /* never above */
        for (int c = 0; c < 2; ++c)
            assert_true(jumped[k].steps[c] >= steps[k].steps[c] || steps[k].steps[c] > 50);
        counts->off += f->beta - g->beta > 0.01 || f->gamma - g->gamma > 0.01;
        counts->base_off += fabs(f->base - g->base) > 0.01;
        counts->base = fmax(counts->base, fabs(f->base - g->base));
        ++counts->fragments;
    }
}

/* A base that varies, by the adaptive law and by waves across the surfaces. */
static void jumps_never_exceed_the_iterated_fields(void **state) {
    static const char *const names[4] = {"until stable", "1 round", "2 rounds", "default"};
    smart_stage t;
    (void)state;
    smart_stage_open_wide(&t, false, 80, 60, smart_truth_desc, 1 << 17);
    oit_operator pattern = pattern_operator(&t, waves);
    jump_counts all[2][4] = {{{0, 0, 0, 0}}};
    for (size_t i = 0; i < SMART_TRUTH_SCENES; ++i) {
        smart_truth_scenes[i].make(&t);
        oit_operator link = smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
        oit_operator law = smart_truth_law(OIT_LAW_ADAPTIVE, 0.6f);
        smart_stage_begin(&t, NULL);
        smart_stage_run(&t, &link);
        for (int varied = 0; varied < 2; ++varied) {
            oit_operator op = smart_truth_smart(50, 0.02f);
            smart_stage_run(&t, varied ? &pattern : &law);
            smart_stage_run(&t, &op);
            ref_smart_image iterated = smart_stage_look(&t);
            smart_stage_row *steps = t.rows;
            t.rows = NULL;
            for (int rounds = 0; rounds < 4; ++rounds) {
                op.smart.jumps = 1;
                op.smart.until_stable = rounds == 0;
                op.smart.rounds = rounds % 3;
                smart_stage_run(&t, varied ? &pattern : &law);
                smart_stage_run(&t, &op);
                ref_smart_image jumped = smart_stage_look(&t);
                jump_counts counts = {0, 0, 0, 0};
                compare_jumps(&iterated, steps, &jumped, t.rows, &counts);
                if (rounds == 0)
                    assert_int_equal(counts.off, 0);
                if (rounds == 3 && counts.off * 1000 > counts.fragments)
                    fail_msg("%s: %zu of %zu off", smart_truth_scenes[i].name, counts.off, counts.fragments);
                all[varied][rounds].fragments += counts.fragments;
                all[varied][rounds].off += counts.off;
                all[varied][rounds].base_off += counts.base_off;
                all[varied][rounds].base = fmax(all[varied][rounds].base, counts.base);
                smart_stage_drop(&jumped);
            }
            free(steps);
            smart_stage_drop(&iterated);
        }
        free(smart_stage_end(&t));
    }
    for (int k = 0; k < 8; ++k) {
        const jump_counts *c = &all[k / 4][k % 4];
        printf("    %-8s base, %-12s: beta, gamma off by more than 0.01: %.4f %%; base %.4f %%, at most by %.4f\n",
               k / 4 ? "waves as" : "adaptive", names[k % 4], 100.0 * (double)c->off / (double)c->fragments,
               100.0 * (double)c->base_off / (double)c->fragments, c->base);
        /* Rows and columns do not commute: see docs/smart.md. The share is that of the project's aims; the largest is 0.023
           * and 0.029 as measured, and a third more is left to other drivers. */
        assert_true(c->base_off * 1000 <= c->fragments && c->base <= 0.04);
    }
    glDeleteProgram(pattern.host.program);
    smart_stage_close(&t);
}

/* A corridor that winds inward, three pixels wide with one between: each pixel's row of its quads. */
static void make_spiral(smart_stage *t, int size) {
    static const double color[4] = {0.2, 0.5, 0.9, 0.3}, back[4] = {0.2, 0.2, 0.2, 0.2},
                        front[4] = {-0.2, -0.2, -0.2, -0.2};
    oit_scene *s = smart_stage_clear(t);
    unsigned char *inside = calloc((size_t)(size * size), 1);
    int low = 1, high = size - 2, x = 1, y = 1;
    for (int leg = 0; high - low >= 4; ++leg) { /* along the walls of a square that shrinks every second leg */
        static const int steps[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        int length = high - low - 2;
        for (int k = 0; k <= length; ++k) {
            for (int d = 0; d < 9; ++d)
                inside[(y + d / 3) * size + x + d % 3] = 1;
            if (k < length) {
                x += steps[leg % 4][0];
                y += steps[leg % 4][1];
            }
        }
        if (leg % 4 == 2)
            low += 4;
        if (leg % 4 == 3)
            high -= 4;
    }
    for (int row = 0; row < size; ++row)
        for (int from = 0; from < size; ++from) {
            int to = from;
            while (to < size && inside[row * size + to])
                ++to;
            if (to > from) {
                const double p = 2.0 / size;
                s->objects[oit_scene_quad(s, from * p - 1, row * p - 1, to * p - 1, (row + 1) * p - 1, back, color)]
                    .part = 1;
                from = to;
            }
        }
    const double p = 2.0 / size; /* over the outer end: where the halo begins */
    s->objects[oit_scene_quad(s, p - 1, p - 1, 4 * p - 1, 4 * p - 1, front, color)].part = 2;
    free(inside);
}

/* Distances along links to what keeps gamma at 1, in breadth. */
static int *distances_along(const ref_smart_image *image) {
    size_t count = smart_truth_count(image);
    int *steps = malloc((count + 1) * sizeof *steps);
    for (size_t i = 0; i < count; ++i)
        steps[i] = image->fragments[i].keep_gamma ? 0 : -1;
    for (int n = 0, more = 1; more; ++n) {
        more = 0;
        SMART_TRUTH_EACH(image, x, y, i, f)
        for (int d = 0; d < 4 && steps[f - image->fragments] == n; ++d) {
            const ref_smart_fragment *to = ref_smart_linked(image, x, y, f, d);
            if (to && steps[to - image->fragments] < 0) {
                steps[to - image->fragments] = n + 1;
                more = 1;
            }
        }
    }
    return steps;
}

/* Many bends: as exact as so many iterations, and found by fewer rounds the fewer bends there are. */
static void until_stable_is_exact_around_bends(void **state) {
    enum { SIZE = 66 };
    smart_stage t;
    (void)state;
    smart_stage_open(&t, false, SIZE, smart_truth_desc, 1 << 13);
    make_spiral(&t, SIZE);
    for (int way = 0; way < 3; ++way) { /* iterated, until stable, with the rounds that a few bends take */
        oit_operator ops[2] = {smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED),
                               smart_truth_smart(600, 1.0f / 700)};
        ref_smart_image image;
        size_t off = 0;
        int farthest = 0;
        ops[1].smart.base.iterations = -1;
        ops[1].smart.jumps = way > 0;
        ops[1].smart.until_stable = way == 1;
        ops[1].smart.rounds = way == 2 ? 4 : 0;
        free(smart_stage_frame(&t, ops, 2, NULL, &image));
        ref_smart_begin(&image, -1);
        int *steps = distances_along(&image);
        for (size_t i = 0; i < smart_truth_count(&image); ++i) {
            int found = (int)t.rows[i].steps[1];
            assert_true(steps[i] < 0 || found >= steps[i]);
            off += steps[i] >= 0 ? found != steps[i] : found < 65534;
            farthest = steps[i] > farthest ? steps[i] : farthest;
        }
        printf("    %s: longest path %d, %zu of %zu fragments off\n",
               way == 0   ? "iterated"
               : way == 1 ? "until stable"
                          : "4 rounds",
               farthest, off, smart_truth_count(&image));
        assert_true(farthest > 250 && (off > 0) == (way == 2));
        free(steps);
        smart_stage_drop(&image);
    }
    smart_stage_close(&t);
}

/* An edge along the rows: the first pass, along rows, changes nothing, and the columns still have to come. */
static void until_stable_waits_for_columns(void **state) {
    static const double color[4] = {1, 1, 1, 0.5}, flat[4] = {0, 0, 0, 0};
    smart_stage t;
    (void)state;
    smart_stage_open_wide(&t, false, 8, 40, smart_truth_desc, 1 << 10);
    oit_scene *s = smart_stage_clear(&t);
    oit_scene_quad(s, -2, -2, 2, 0.5, flat, color); /* up to row 29 */
    oit_operator ops[2] = {smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED), smart_truth_smart(25, 0.02f)};
    ref_smart_image image;
    ops[1].smart.jumps = ops[1].smart.until_stable = 1;
    free(smart_stage_frame(&t, ops, 2, NULL, &image));
    for (size_t y = 5; y < 30; ++y)
        assert_int_equal(t.rows[image.start[8 * y + 3]].steps[0], 29 - y);
    smart_stage_drop(&image);
    smart_stage_close(&t);
}

/* Sheets whose normals are noise, and balls between them, whose edges are where halos begin. */
static void make_noise(smart_stage *t, int balls) {
    static const double color[4] = {0.2, 0.5, 0.9, 0.3};
    smart_truth_rough(t);
    for (int i = 0; i < balls; ++i) {
        const double ball[4] = {2.0 * (i + 0.5) / balls - 1, 0, 0.6 * i - 0.6, 0.06};
        t->scene.objects[smart_stage_sheet(&t->scene, smart_stage_ball, ball, 12, color)].part = 2;
    }
}

/* Links that are not mutual make no chains: a stretch that was gone along to and fro may have more to do the next time.
 * Single rows, where nothing else changes around a stretch meanwhile. */
static void until_stable_is_exact_where_links_are_one_sided(void **state) {
    size_t off = 0, between = 0;
    smart_stage t;
    (void)state;
    for (int i = 0; i < 12; ++i) {
        oit_operator law = smart_truth_law(OIT_LAW_ADAPTIVE, 0.6f), op = smart_truth_smart(50, 0.02f);
        smart_stage_open_wide(&t, false, 21 + i, 1, smart_truth_desc, 1 << 12);
        make_noise(&t, 1 + i % 3);
        oit_operator link = smart_truth_link(&t, i & 1 ? OIT_LINK_MURRAY : OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
        ref_smart_image images[2];
        link.link.no_reverse_check = 1;
        link.link.limit = -1;
        smart_stage_begin(&t, NULL);
        smart_stage_run(&t, &link);
        for (int jumps = 0; jumps < 2; ++jumps) {
            op.smart.jumps = op.smart.until_stable = jumps;
            smart_stage_run(&t, &law);
            smart_stage_run(&t, &op);
            images[jumps] = smart_stage_look(&t);
        }
        free(smart_stage_end(&t));
        for (size_t k = 0; k < smart_truth_count(&images[0]); ++k) { /* base is iterated there */
            const ref_smart_fragment *f = &images[0].fragments[k], *g = &images[1].fragments[k];
            off += f->base != g->base || f->beta != g->beta || f->gamma != g->gamma;
            between += f->gamma > 0 && f->gamma < 1;
        }
        smart_stage_drop(&images[0]);
        smart_stage_drop(&images[1]);
        smart_stage_close(&t);
    }
    printf("    %zu off, %zu between 0 and 1\n", off, between);
    assert_int_equal(off, 0);
    assert_true(between > 1000);
}

/* ---- reach limited by feature size ---- */

/* Along links in a direction: how many to the next fragment with a boundary condition; -1: the picture or surface ends. */
static int to_wall(const ref_smart_image *image, int x, int y, const ref_smart_fragment *f, int direction) {
    for (int n = 0;; ++n) {
        if (f->keep_beta || f->keep_gamma)
            return n;
        f = ref_smart_linked(image, x, y, f, direction);
        if (!f)
            return -1;
        assert_true(ref_smart_next(image, &x, &y, direction));
    }
}

/* The field of equation 9 at so many steps, no farther than the share of the width there. */
static double thin_value(const ref_smart_image *image, int x, int y, const ref_smart_fragment *f, double share,
                         double u, double lambda, int most) {
    double width = 1e9, steps = u > 0 ? round(1024 * (1 - u)) : 1e9;
    for (int axis = 0; axis < 2; ++axis) {
        int low = to_wall(image, x, y, f, 2 * axis), high = to_wall(image, x, y, f, 2 * axis + 1);
        if (low >= 0 && high >= 0)
            width = fmin(width, low + high);
    }
    return steps <= most ? fmax(1 - steps * fmax(lambda, 1 / fmax(share * width, 1)), 0) : 0;
}

static void reach_is_limited_by_the_width(void **state) {
    static const size_t which[] = {0, 1, 6, 8, 9};
    smart_stage t;
    (void)state;
    smart_stage_open(&t, false, 40, smart_truth_desc, ROOM);
    for (int i = 0; i < 10; ++i) {
        oit_operator ops[3] = {{0}, smart_truth_law(OIT_LAW_CONSTANT, 0.2f), smart_truth_smart(15, 0.04f)};
        ref_smart_image image;
        double share = i & 1 ? 0.25 : 0.45, worst = 0, limited = 0;
        smart_truth_scenes[which[i / 2]].make(&t);
        ops[0] = smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
        ops[2].smart.thin = (float)share;
        ops[2].smart.jumps = i & 1;
        ops[2].smart.until_stable = i & 1;
        ops[2].smart.base.iterations = -1;
        float *picture = smart_stage_frame(&t, ops, 3, NULL, &image);
        ref_smart_fragment *found = smart_truth_copy(&image);
        ref_smart_begin(&image, -1);
        assert_true(ref_smart_spread(&image, REF_SMART_BETA, true, 1.0 / 1024, REF_SMART_EIGHTH, 15) &&
                    ref_smart_spread(&image, REF_SMART_GAMMA, true, 1.0 / 1024, REF_SMART_EIGHTH, 15));
        SMART_TRUTH_EACH(&image, x, y, n, f) { /* into other places: walls are read meanwhile, fields are not */
            ref_smart_fragment *out = &found[f - image.fragments];
            if (f->kind != REF_SMART_SURFACE)
                continue;
            double beta = thin_value(&image, x, y, f, (double)(float)share, f->beta, (double)0.04f, 15);
            double gamma = thin_value(&image, x, y, f, (double)(float)share, f->gamma, (double)0.04f, 15);
            worst = fmax(worst, fmax(fabs(out->beta - beta), fabs(out->gamma - gamma)));
            limited += f->beta > 0 && beta < 1 - 40.96 * (1 - f->beta) - 1e-6;
            out->beta = beta;
            out->gamma = gamma;
            out->base = (double)0.2f;
        }
        memcpy(image.fragments, found, smart_truth_count(&image) * sizeof *found);
        double error = smart_truth_picture_error(picture, &image, false);
        printf("    %-22s share %.2f: fields %.1e, picture %.1e; %.0f %% of the fragments are limited\n",
               smart_truth_scenes[which[i / 2]].name, share, worst, error,
               100 * limited / (double)smart_truth_count(&image));
        assert_true(worst <= 1e-4 && error <= 1.0 / 255 && limited > 20);
        free(found);
        free(picture);
        smart_stage_drop(&image);
    }
    smart_stage_close(&t);
}

/* Strips of nine pixels with one between, before a sheet: the share of them that is as transparent as the law says. */
static double left_clear(smart_stage *t, float thin) {
    static const double color[4] = {0.2, 0.2, 0.2, 0.3}, near[4] = {-0.5, -0.5, -0.5, -0.5},
                        far[4] = {0.5, 0.5, 0.5, 0.5};
    oit_scene *s = smart_stage_clear(t);
    ref_smart_image image;
    size_t clear = 0;
    for (int i = 0; i < 4; ++i)
        s->objects[oit_scene_quad(s, i * 0.5 - 0.95, -1, i * 0.5 - 0.5, 1, near, color)].part = 1;
    oit_scene_quad(s, -1, -1, 1, 1, far, color);
    oit_operator ops[3] = {smart_truth_link(t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED),
                           smart_truth_law(OIT_LAW_CONSTANT, 0.3f), smart_truth_smart(20, 0.05f)};
    ops[2].smart.thin = thin;
    free(smart_stage_frame(t, ops, 3, NULL, &image));
    for (size_t i = 0; i < smart_truth_count(&image); ++i)
        clear += image.fragments[i].beta == 0 && image.fragments[i].gamma == 0;
    double share = (double)clear / (double)smart_truth_count(&image);
    smart_stage_drop(&image);
    return share;
}

static void dense_silhouettes_do_not_clog(void **state) {
    smart_stage t;
    (void)state;
    smart_stage_open(&t, false, 40, smart_truth_desc, ROOM);
    double clogged = left_clear(&t, 0), clear = left_clear(&t, 0.25f);
    printf("    of strips nine pixels wide %.0f %% stays as it was, with thin %.0f %%\n", 100 * clogged, 100 * clear);
    assert_true(clogged == 0 && clear > 0.5); /* 1 - 2 x 0.25 of what lies between */
    smart_stage_close(&t);
}

/* ---- hard cases ---- */

static void set_normals(smart_stage *t, size_t object, const float normal[3]) {
    size_t vertices = t->scene.truths[object].vertex_count;
    float *normals = malloc(12 * vertices);
    for (size_t k = 0; k < 3 * vertices; ++k)
        normals[k] = normal[k % 3];
    glBindBuffer(GL_ARRAY_BUFFER, t->scene.objects[object].buffers[0]);
    glBufferSubData(GL_ARRAY_BUFFER, (GLintptr)(12 * vertices), (GLsizeiptr)(12 * vertices), normals);
    free(normals);
}

/* Surfaces, and in the place of the n-th of its normals one that is none. */
static void make_hard(smart_stage *t, int kind) {
    static const float normals[6][3] = {{0, 0, 0},           {NAN, 0, 1},           {INFINITY, 1, 0},
                                        {1e-42f, 0, 1e-42f}, {3e38f, 3e38f, 3e38f}, {0, 0, -1}};
    const double color[4] = {0.2, 0.5, 0.9, 0.3}, pixel = 2.0 / t->set.width;
    oit_scene *s = smart_stage_clear(t);
    for (int i = 0; kind < 6 && i < 2; ++i) { /* degenerate normals, on one of two sheets */
        s->objects[smart_stage_sheet(s, smart_stage_wavy, (const double[6]){0.3 * i, 0.1, 0.1, 0.1, 3, 0}, 8, color)]
            .part = 1;
        if (i == 0)
            set_normals(t, 0, normals[kind]);
    }
    for (int i = 0; kind == 6 && i < 30; ++i) { /* surfaces of one pixel */
        const double z[4] = {0.1, 0.2, 0.3, 0.2}, x = (i % 6) * 5 * pixel - 1, y = (i / 6) * 4 * pixel - 1;
        oit_scene_quad(s, x, y, x + pixel, y + pixel, z, color);
    }
    for (int i = 0; kind == 7 && i < 12; ++i) { /* of one depth, half of them of one part */
        const double z[4] = {0.1, 0.1, 0.1, 0.1};
        s->objects[oit_scene_quad(s, -0.8, -0.8, 0.8, 0.8, z, color)].part = i & 1 ? 1 : (uint32_t)i + 2;
    }
    for (int i = 0; kind == 8 && i < 6; ++i) { /* all but edge-on: all of the depths within few pixels */
        const double z[4] = {-1, 1, 1, -1}, x = 0.3 * i - 0.9;
        s->objects[oit_scene_quad(s, x, -0.9, x + (i % 3 ? 0.02 : 1.4) * pixel, 0.9, z, color)].part = 1;
    }
    for (int i = 0; kind == 9 && i < 2; ++i) { /* depth 0 and depth just below 1, alphas that are next to nothing */
        const double end = i ? 0.99999994 : -1, z[4] = {end, end, end, end};
        double faint[4] = {1, 1, 1, i ? 1e-40 : 1e-30};
        oit_scene_quad(s, -0.9, -0.9, 0.7, 0.7, z, faint);
    }
    if (kind == 10) { /* a body seen from a thousand miles: 10^6 away, with a thousandth's detail */
        const double ball[4] = {0, 0, 0, 0.8};
        oit_scene_camera(s, 1e6, 1e5, 1e7, 1.1e-6);
        smart_stage_sheet(s, smart_stage_ball, ball, 32, color);
    }
    for (int i = 0; kind == 11 && i < 2; ++i) { /* colours that are none */
        const double bad[4] = {i ? (double)NAN : (double)INFINITY, 1, 1e30, i ? 0.5 : 2};
        const double z[4] = {0.1 * i, 0.1 * i, 0.1 * i, 0.1 * i};
        oit_scene_quad(s, -0.9, -0.9, 0.9 - 0.4 * i, 0.9, z, bad);
    } /* 12: nothing at all */
}

static void expect_numbers(const ref_smart_image *image, const float *picture) {
    for (size_t i = 0; i < smart_truth_count(image); ++i) {
        const ref_smart_fragment *f = &image->fragments[i];
        assert_true(smart_truth_in_range(f->base) && smart_truth_in_range(f->beta) && smart_truth_in_range(f->gamma));
        assert_true(f->kappa >= -1 && f->kappa <= 1);
        assert_true(fabs(sqrt(ref_smart_dot(f->normal, f->normal)) - 1) < 1e-5);
        assert_true(fabs(f->slope[0]) <= 16 && fabs(f->slope[1]) <= 16);
    }
    for (int k = 0; k < 4 * image->width * image->height; ++k)
        assert_true(isfinite(picture[k]));
}

/* All operators on each, by every law, link and process: numbers in their ranges, the truth's on what was stored. */
static void hard_cases_stay_in_range(void **state) {
    static const oit_criterion criteria[3] = {OIT_LINK_DEPTH, OIT_LINK_PUBLISHED, OIT_LINK_MURRAY};
    static const float scales[3] = {0.3f, NAN, INFINITY}; /* of u */
    (void)state;
    for (int own = 0; own < 2; ++own) { /* by our shaders and by the host's, whose normals come as they are */
        smart_stage t;
        oit_desc desc = smart_truth_desc;
        desc.fields |= own ? OIT_FIELD_UV | OIT_FIELD_NORMAL | OIT_FIELD_PART : 0;
        smart_stage_open(&t, own, 30, desc, ROOM);
        for (int kind = 0; kind < 13; ++kind) {
            char name[32];
            make_hard(&t, kind);
            for (int way = 0; way < 3; ++way) {
                oit_operator ops[4] = {smart_truth_link(&t, own ? OIT_LINK_UV : criteria[way], OIT_SEARCH_WINDOWED),
                                       smart_truth_law((oit_law_kind)(2 + way), 0.5f),
                                       smart_truth_smart(9, 0.1f),
                                       {.kind = OIT_RUN_CURVATURE}};
                ref_smart_image image;
                t.uv_scale[0] = (double)scales[way];
                ops[2].smart.jumps = way == 1;
                ops[2].smart.thin = way == 2 ? 0.3f : 0;
                ops[2].smart.beta.process = way == 2 ? OIT_PROCESS_DIFFUSION : OIT_PROCESS_DEFAULT;
                ops[3].curvature.unit = way ? 0.5f : 0;
                ops[3].curvature.opacity = way == 2 ? OIT_OPACITY_FRONT : OIT_OPACITY_NONE;
                ops[3].curvature.shade = OIT_SHADE_CURVED;
                float *picture = smart_stage_frame(&t, ops, 4, NULL, &image);
                expect_numbers(&image, picture);
                assert_true(kind == 12 || smart_truth_count(&image) > 0);
                free(picture);
                smart_stage_drop(&image);
            }
            oit_operator law = smart_truth_law(OIT_LAW_ADAPTIVE, 0.9f), smart = smart_truth_smart(0, 0);
            snprintf(name, sizeof name, "hard case %d%s", kind, own ? ", host's shaders" : "");
            if (kind != 11) /* of 10^30 nothing is left but seven digits */
                smart_truth_expect(&t, name, &law.law, &smart.smart);
        }
        smart_stage_close(&t);
    }
}

/* A viewport of no area, and of one pixel. */
static void the_smallest_pictures(void **state) {
    static const double color[4] = {0.2, 0.4, 0.6, 0.5}, flat[4] = {0, 0, 0, 0};
    smart_stage t;
    double ignored[16];
    oit_pass pass;
    (void)state;
    smart_stage_open(&t, false, 1, smart_truth_desc, 16);
    oit_scene *s = smart_stage_clear(&t);
    oit_scene_quad(s, -1, -1, 1, 1, flat, color);
    const oit_operator ops[4] = {smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED),
                                 smart_truth_law(OIT_LAW_CONSTANT, 0.25f),
                                 smart_truth_smart(20, 0),
                                 {.kind = OIT_RUN_CURVATURE}};
    ref_smart_image image;
    float *picture = smart_stage_frame(&t, ops, 4, NULL, &image);
    const ref_smart_fragment *f = ref_smart_at(&image, 0, 0, 0);
    assert_true(f->beta == 0 && f->gamma == 0 && f->base == 0.25 && f->kappa == -1); /* the frame is no silhouette */
    for (int k = 0; k < 3; ++k)
        assert_true(fabs((double)picture[k] - (0.75 + 0.25 * color[k])) < 1e-6);
    free(picture);
    smart_stage_drop(&image);
    for (int size = 0; size < 3; ++size) { /* 0 x 0, 1 x 0, 0 x 1 */
        oit_frame frame = oit_scene_frame(&t.scene, t.set.framebuffer);
        smart_stage_projection(&t, frame.projection, ignored);
        frame.width = size == 1;
        frame.height = size == 2;
        oit_scene_expect(oit_begin(t.set.oit, &frame), "oit_begin");
        while (oit_next_pass(t.set.oit, &pass))
            smart_stage_draw(&t.scene, t.set.oit, &pass, NULL);
        for (int i = 0; i < 4; ++i)
            smart_stage_run(&t, &ops[i]);
        free(smart_stage_end(&t));
    }
    smart_stage_close(&t);
}

/* 500 layers: links of 16 bits. */
static void deep_pixels_are_those_of_the_truth(void **state) {
    (void)state;
    smart_stage t;
    oit_operator law = smart_truth_law(OIT_LAW_ADAPTIVE, 0.9f), smart = smart_truth_smart(0, 0);
    smart_stage_open_wide(&t, false, 5, 4, smart_truth_desc, 1 << 14);
    smart_truth_sheets(&t, 500, 0.05, 0);
    smart_truth_expect(&t, "500 layers", &law.law, &smart.smart);
    smart.smart.published = 1;
    smart_truth_expect(&t, "500 layers, published", &law.law, &smart.smart);
    smart_stage_close(&t);
}

/* ---- the XT-junction ---- */

/* Contrast across the hidden contour (column 19 against 20), in units of what is behind against the background. */
static void contrast_along_the_contour(smart_stage *t, int kind, double out[40]) {
    oit_operator ops[3] = {smart_truth_link(t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED),
                           smart_truth_law(OIT_LAW_CONSTANT, kind == 2 ? 1.0f : 0.3f), smart_truth_smart(20, 0.1f)};
    ops[2].smart.gamma.lambda = 0.2f;
    float *picture = smart_stage_frame(t, ops, kind == 0 ? 3 : 2, NULL, NULL);
    for (int y = 0; y < 40; ++y) {
        const float *left = &picture[4 * (40 * y + 19)], *right = left + 4;
        out[y] = fabs((double)left[0] - (double)right[0]) / (1 - 0.2); /* red of what is behind: 0.2 */
    }
    free(picture);
}

/* The thesis of Carnecky 2013: along the contour of what is behind, from outside to where it passes under the edge of what
 * is before and on. The numbers are in tests/gl_probes_smart.c. */
static void hidden_contours_make_an_xt_junction(void **state) {
    enum { EDGE = 8, END = 20 }; /* rows: the first under what is before, and the middle of the picture */
    double smart[40], constant[40], opaque[40];
    smart_stage t;
    (void)state;
    smart_stage_open(&t, false, 40, smart_truth_desc, 1 << 14);
    smart_truth_squares(&t);
    contrast_along_the_contour(&t, 0, smart);
    contrast_along_the_contour(&t, 1, constant);
    contrast_along_the_contour(&t, 2, opaque);
    printf("    row   smart  constant  opaque\n");
    for (int y = 3; y < END; ++y)
        printf("    %3d   %.3f   %.3f     %.3f\n", y, smart[y], constant[y], opaque[y]);
    assert_true(smart[EDGE] < 1e-6); /* nothing at the crossing */
    for (int y = EDGE + 1; y < END; ++y)
        assert_true(smart[y] > smart[y - 1] || (smart[y] > 0.7 - 1e-5 && smart[y] > smart[y - 1] - 1e-6)); /* rises */
    assert_true(fabs(smart[END - 1] - 0.7) < 1e-5); /* to its base value: all of the edge through 1 - 0.3 */
    for (int y = EDGE; y < 32; ++y) {               /* and the same at the other end */
        assert_true(fabs(smart[y] - smart[39 - y]) < 1e-6);
        assert_true(fabs(constant[y] - 0.7 * 0.3) < 1e-5); /* an X: the same all along, crossing included */
        assert_true(opaque[y] < 1e-6);                     /* a T: it ends there */
    }
    assert_true(smart[EDGE - 1] < 1e-6); /* the halo beside: from nothing back to the contour's full strength */
    for (int y = EDGE - 2; y >= 3; --y)
        assert_true(smart[y] > smart[y + 1] + 0.1);
    for (int y = 3; y < EDGE; ++y)
        assert_true(fabs(constant[y] - 0.3) < 1e-5 && fabs(opaque[y] - 1) < 1e-5);
    smart_stage_close(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fields_and_pictures_are_those_of_the_truth),
        cmocka_unit_test(every_setting_is_that_of_the_truth),
        cmocka_unit_test(fields_are_stable_for_every_lambda_and_many_steps),
        cmocka_unit_test(only_the_published_step_leaves_checkers),
        cmocka_unit_test(jumps_never_exceed_the_iterated_fields),
        cmocka_unit_test(until_stable_is_exact_around_bends),
        cmocka_unit_test(until_stable_waits_for_columns),
        cmocka_unit_test(until_stable_is_exact_where_links_are_one_sided),
        cmocka_unit_test(reach_is_limited_by_the_width),
        cmocka_unit_test(dense_silhouettes_do_not_clog),
        cmocka_unit_test(hard_cases_stay_in_range),
        cmocka_unit_test(the_smallest_pictures),
        cmocka_unit_test(deep_pixels_are_those_of_the_truth),
        cmocka_unit_test(hidden_contours_make_an_xt_junction),
    };
    if (getenv("GLASSINE_TEST")) /* one of them */
        cmocka_set_test_filter(getenv("GLASSINE_TEST"));
    return cmocka_run_group_tests(tests, NULL, NULL);
}

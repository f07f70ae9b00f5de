/* gl_operators.c: links, laws, curvature with transfer functions and the host's own operators of oit_buffers.h on a real
 * driver, each held to its counterpart in double on the same fragments; every store and both APIs. */
#include "smart_truth.h"

enum { WIDTH = 36, HEIGHT = 27, ROOM = 1 << 15 };

/* ---- links ---- */

typedef struct way {
    const char *name;
    oit_criterion criterion;
    oit_search search;
    float limit, depth_weight, normal_weight;
    bool no_reverse_check;
} way;

static oit_operator link_of(const smart_stage *t, const way *w) {
    oit_operator op = smart_truth_link(t, w->criterion, w->search);
    op.link.limit = w->limit;
    op.link.depth_weight = w->depth_weight;
    op.link.normal_weight = w->normal_weight;
    op.link.no_reverse_check = w->no_reverse_check;
    return op;
}

/* Links of the frame under way by each of the ways, against the truth's. */
static void expect_links(smart_stage *t, const char *name, const way *ways, size_t count) {
    size_t links = 0, close = 0;
    smart_stage_begin(t, NULL);
    for (size_t i = 0; i < count; ++i) {
        oit_operator op = link_of(t, &ways[i]);
        smart_stage_run(t, &op);
        ref_smart_image image = smart_stage_look(t);
        ref_smart_links truth = smart_stage_links(t, &op.link);
        smart_truth_counts found = smart_truth_compare_links(&image, &truth);
        if (found.wrong || found.close * 500 > found.links)
            fail_msg("%s, %s: %zu of %zu links are wrong, %zu turn on rounding", name, ways[i].name, found.wrong,
                     found.links, found.close);
        links += found.links;
        close += found.close;
        smart_stage_drop(&image);
    }
    free(smart_stage_end(t));
    printf("    %-22s %zu links, %zu turn on rounding\n", name, links, close);
    assert_true(links > 200 * count);
}

static const way ways[] = {
    {"depth", OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED, 0, 0, 0, false},
    {"depth, one-sided", OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED, 0, 0, 0, true},
    {"depth, no limit", OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED, -1, 0, 0, false},
    {"depth, mostly by depth", OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED, -1, 0.3f, 0.05f, false},
    {"depth, by normals alone", OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED, 0.1f, 0, 1, false},
    {"depth, all pairs", OIT_LINK_DEPTH, OIT_SEARCH_BRUTE, 0, 0, 0, false},
    {"depth, buckets", OIT_LINK_DEPTH, OIT_SEARCH_BUCKETS, 0, 0, 0, false},
    {"published", OIT_LINK_PUBLISHED, OIT_SEARCH_BRUTE, 0, 0, 0, false},
    {"published, one-sided", OIT_LINK_PUBLISHED, OIT_SEARCH_BRUTE, 0, 0, 0, true},
    {"Murray", OIT_LINK_MURRAY, OIT_SEARCH_BRUTE, 0, 0, 0, false},
    {"Murray, buckets, one-sided", OIT_LINK_MURRAY, OIT_SEARCH_BUCKETS, 0, 0, 0, true},
};
enum { WAYS = sizeof ways / sizeof ways[0] };

static void links_are_those_of_the_truth(void **state) {
    (void)state;
    for (int es = 0; es < 2; ++es) { /* ES: what differs is the shading language; two scenes tell */
        smart_stage t;
        smart_stage_open_wide(&t, es, WIDTH, HEIGHT, smart_truth_desc, ROOM);
        for (size_t i = es ? SMART_TRUTH_SCENES - 2 : 0; i < SMART_TRUTH_SCENES; ++i) {
            smart_truth_scenes[i].make(&t);
            expect_links(&t, smart_truth_scenes[i].name, ways, WAYS);
        }
        smart_stage_close(&t);
    }
}

/* Windowed and by buckets: the very links of all pairs, fragment by fragment, on many more of them. */
static void searches_find_the_same_links(void **state) {
    (void)state;
    smart_stage t;
    smart_stage_open_wide(&t, false, 90, 64, smart_truth_desc, 1 << 18);
    for (size_t i = 0; i < SMART_TRUTH_SCENES; ++i) {
        ref_smart_image images[3];
        smart_truth_scenes[i].make(&t);
        for (int limit = 0; limit < 2; ++limit) {
            size_t differ = 0;
            smart_stage_begin(&t, NULL);
            for (int search = 0; search < 3; ++search) {
                oit_operator op = smart_truth_link(&t, OIT_LINK_DEPTH, (oit_search)search);
                op.link.limit = limit ? -1.0f : 0.0f;
                smart_stage_run(&t, &op);
                images[search] = smart_stage_look(&t);
            }
            free(smart_stage_end(&t));
            size_t count = smart_truth_count(&images[0]);
            for (size_t k = 0; k < count; ++k)
                for (int other = 0; other < 3; ++other)
                    differ += memcmp(images[other].fragments[k].link, images[OIT_SEARCH_BRUTE].fragments[k].link,
                                     sizeof images[0].fragments[k].link) != 0;
            if (differ)
                fail_msg("%s: %zu of %zu fragments have other links", smart_truth_scenes[i].name, differ, count);
            for (int search = 0; search < 3; ++search)
                smart_stage_drop(&images[search]);
        }
    }
    smart_stage_close(&t);
}

/* By the host's own (u, v). */
static void links_by_parameters_are_those_of_the_truth(void **state) {
    static const way by_uv[] = {{"uv", OIT_LINK_UV, OIT_SEARCH_WINDOWED, 0, 0, 0, false},
                                {"uv, one-sided", OIT_LINK_UV, OIT_SEARCH_BRUTE, 0, 0, 0, true},
                                {"uv, no limit", OIT_LINK_UV, OIT_SEARCH_BRUTE, -1, 0, 0, false},
                                {"uv, buckets", OIT_LINK_UV, OIT_SEARCH_BUCKETS, 0.02f, 0, 0, false}};
    static const size_t which[] = {2, 3, 5, 6, 9};
    (void)state;
    for (int es = 0; es < 2; ++es) {
        smart_stage t;
        oit_desc desc = smart_truth_desc;
        desc.fields |= OIT_FIELD_UV | OIT_FIELD_NORMAL | OIT_FIELD_PART;
        smart_stage_open_wide(&t, es, WIDTH, HEIGHT, desc, ROOM);
        for (size_t i = es ? 3 : 0; i < sizeof which / sizeof which[0]; ++i) {
            smart_truth_scenes[which[i]].make(&t);
            t.uv_scale[0] = 0.4;
            t.uv_scale[1] = 0.7;
            t.uv_shift = 0.013; /* sheets have almost the same parameters: the pixel beside holds many that are near */
            expect_links(&t, smart_truth_scenes[which[i]].name, by_uv, 4);
        }
        smart_stage_close(&t);
    }
}

/* Half of the picture nearer than the other by a gap: one surface up to the limit, two beyond it. */
static void the_limit_of_continuity_parts_surfaces(void **state) {
    static const double color[4] = {1, 1, 1, 0.5}, gaps[2] = {0.99, 1.01};
    static const float limits[3] = {0.05f, 0.2f, 0.4f};
    oit_desc desc = smart_truth_desc;
    smart_stage t;
    (void)state;
    desc.fields |= OIT_FIELD_UV | OIT_FIELD_NORMAL | OIT_FIELD_PART;
    smart_stage_open_wide(&t, false, 8, 8, desc, 1 << 10);
    for (int i = 0; i < 12; ++i) {
        bool by_uv = i >= 6;
        double limit = (double)limits[i / 2 % 3], gap = gaps[i % 2] * limit;
        const double near[4] = {0.5 * gap, 0.5 * gap, 0.5 * gap, 0.5 * gap},
                     far[4] = {-0.5 * gap, -0.5 * gap, -0.5 * gap, -0.5 * gap};
        oit_scene *s = smart_stage_clear(&t);
        s->scene.projection[10] = -1;
        oit_scene_quad(s, -1, -1, 0, 1, near, color);
        oit_scene_quad(s, 0, -1, 1, 1, far, color);
        s->objects[0].part = s->objects[1].part = 7;
        t.radius = by_uv ? 1 : 0.5; /* limits of depth are in radii */
        t.uv_scale[0] = t.uv_scale[1] = 0;
        t.uv_shift = by_uv ? gap * sqrt(0.5) : 0;
        oit_operator op = smart_truth_link(&t, by_uv ? OIT_LINK_UV : OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
        op.link.limit = (float)(by_uv ? limit : 2 * limit);
        ref_smart_image image;
        free(smart_stage_frame(&t, &op, 1, NULL, &image));
        for (int y = 0; y < 8; ++y) {
            assert_int_equal(ref_smart_at(&image, 3, y, 0)->link[REF_SMART_RIGHT], i % 2 ? -1 : 0);
            assert_int_equal(ref_smart_at(&image, 4, y, 0)->link[REF_SMART_LEFT], i % 2 ? -1 : 0);
            assert_int_equal(ref_smart_at(&image, 2, y, 0)->link[REF_SMART_RIGHT], 0);
        }
        smart_stage_drop(&image);
    }
    smart_stage_close(&t);
}

/* The window looks at fewer pairs than all. */
static void the_window_looks_at_few_pairs(void **state) {
    static const char probe[] = "layout(std430, binding = 6) buffer out_pairs { uint pairs[]; };\n"
                                "void oit_operate(uint p) {\n    if (p == 0u)\n        pairs[0] = oit_surface[0];\n}\n";
    smart_stage t;
    uint32_t pairs[2];
    (void)state;
    smart_stage_open_wide(&t, false, WIDTH, HEIGHT, smart_truth_desc, ROOM);
    smart_truth_sheets(&t, 24, 0.8, 0);
    oit_operator read;
    memset(&read, 0, sizeof read);
    read.kind = OIT_RUN_HOST;
    read.host.program = smart_stage_program(t.set.oit, probe);
    read.host.value = OIT_VALUE_HOST;
    for (int brute = 0; brute < 2; ++brute) {
        oit_operator op = smart_truth_link(&t, OIT_LINK_DEPTH, brute ? OIT_SEARCH_BRUTE : OIT_SEARCH_WINDOWED);
        op.link.count_pairs = 1;
        smart_stage_begin(&t, NULL);
        smart_stage_run(&t, &op);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SMART_STAGE_BINDING, t.out);
        smart_stage_run(&t, &read);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, t.out);
        const uint32_t *words = glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, 4, GL_MAP_READ_BIT);
        assert_non_null(words);
        pairs[brute] = words[0];
        glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
        free(smart_stage_end(&t));
    }
    glDeleteProgram(read.host.program);
    printf("    pairs: window %u, all %u\n", pairs[0], pairs[1]);
    assert_true(pairs[0] > 0 && 5 * (uint64_t)pairs[0] < pairs[1]);
    smart_stage_close(&t);
}

/* Where a sheet ends midway between two that begin, both are as far as can be told: the nearer to the eye is taken. */
static void of_ties_the_nearer_to_the_eye_is_taken(void **state) {
    static const double color[4] = {1, 1, 1, 0.5}, middle[4] = {0, 0, 0, 0}, nearer[4] = {0.25, 0.25, 0.25, 0.25},
                        farther[4] = {-0.25, -0.25, -0.25, -0.25};
    smart_stage t;
    (void)state;
    smart_stage_open(&t, false, 8, smart_truth_desc, 1 << 10);
    oit_scene *s = smart_stage_clear(&t);
    s->scene.projection[10] = -1; /* the eye looks along -z */
    oit_scene_quad(s, -1, -1, 0, 1, middle, color);
    oit_scene_quad(s, 0, -1, 1, 1, nearer, color);
    oit_scene_quad(s, 0, -1, 1, 1, farther, color);
    for (size_t i = 0; i < 3; ++i)
        s->objects[i].part = 1;
    smart_stage_begin(&t, NULL);
    for (int search = 0; search < 3; ++search) {
        oit_operator op = smart_truth_link(&t, OIT_LINK_DEPTH, (oit_search)search);
        op.link.limit = 1;
        smart_stage_run(&t, &op);
        ref_smart_image image = smart_stage_look(&t);
        for (int y = 0; y < 8; ++y)
            assert_int_equal(ref_smart_at(&image, 3, y, 0)->link[REF_SMART_RIGHT], 0);
        smart_stage_drop(&image);
    }
    free(smart_stage_end(&t));
    smart_stage_close(&t);
}

/* Layers beyond 254, whose links take 16 bits; the first frames have less, so that links become wide on the way. */
static void layers_beyond_254_have_links(void **state) {
    (void)state;
    for (int es = 0; es < 2; ++es) {
        smart_stage t;
        smart_stage_open_wide(&t, es, 4, 3, smart_truth_desc, 1 << 13);
        for (int layers = 250; layers <= (es ? 300 : 500); layers += es ? 50 : 125) {
            int deepest = 0;
            smart_truth_sheets(&t, layers, 0.05, 0);
            expect_links(&t, "many sheets", ways, 1);
            oit_operator op = smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
            ref_smart_image image;
            free(smart_stage_frame(&t, &op, 1, NULL, &image));
            SMART_TRUTH_EACH(&image, x, y, i, f)
            for (int d = 0; d < 4; ++d)
                deepest = f->link[d] > deepest ? f->link[d] : deepest;
            assert_int_equal(deepest, layers - 1);
            assert_int_equal(t.set.oit->wide != 0, layers > 254);
            smart_stage_drop(&image);
        }
        smart_stage_close(&t);
    }
}

/* ---- laws ---- */

/* Steps along links from the fragments that miss one, by equation 9 with the smallest of lambdas; 0 stays what is kept. */
static void distances(ref_smart_image *image, int most) {
    ref_smart_begin(image, -1);
    assert_true(ref_smart_spread(image, REF_SMART_BETA, true, 1.0 / 1024, REF_SMART_EIGHTH, (size_t)most));
}

static void laws_are_those_of_the_truth(void **state) {
    static const char *const names[] = {"given", "constant", "adaptive", "angle", "variation", "distance"};
    static const size_t which[] = {1, 3, 6, 8};
    (void)state;
    for (int es = 0; es < 2; ++es) {
        smart_stage t;
        smart_stage_open_wide(&t, es, WIDTH, HEIGHT, smart_truth_desc, ROOM);
        for (size_t i = 0; i < sizeof which / sizeof which[0]; ++i) {
            double worst[6] = {0};
            smart_truth_scenes[which[i]].make(&t);
            oit_operator link = smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED),
                         smart = smart_truth_smart(25, 0);
            ref_smart_links links = smart_stage_links(&t, &link.link);
            smart_stage_begin(&t, NULL);
            smart_stage_run(&t, &link);
            for (int k = 0; k < 12; ++k) {
                oit_operator op = smart_truth_law((oit_law_kind)(k / 2), k & 1 ? 0.6f : 0);
                op.law.exponent = k & 1 ? 2.5f : 0;
                op.law.scale = k & 1 ? 1.5f : 0;
                op.law.reach = k & 1 ? 7.0f : 0;
                if (k == 10)
                    smart_stage_run(&t, &smart);
                smart_stage_run(&t, &op);
                ref_smart_image image = smart_stage_look(&t);
                ref_smart_fragment *found = smart_truth_copy(&image);
                if (k >= 10)
                    distances(&image, 25);
                SMART_TRUTH_EACH(&image, x, y, n, f) {
                    double steps = f->beta > 0 ? 1024 * (1 - f->beta) : 1e9, base = found[f - image.fragments].base;
                    double truth = smart_truth_law_of(&image, links.projection, x, y, f, &op.law, steps);
                    if (f->kind == REF_SMART_SURFACE)
                        worst[k / 2] = fmax(worst[k / 2], fabs(base - truth));
                }
                free(found);
                smart_stage_drop(&image);
            }
            free(smart_stage_end(&t));
            printf("    %-22s", smart_truth_scenes[which[i]].name);
            for (int law = 0; law < 6; ++law)
                printf(" %s %.1e", names[law], worst[law]);
            printf("\n");
            for (int law = 0; law < 6; ++law)
                assert_true(worst[law] <= 1e-4);
        }
        smart_stage_close(&t);
    }
}

/* Distances that are greater than there were iterations are not known, whatever a pass has carried on by chance; jumps know
 * them, and tell no more. */
static void distances_end_with_the_iterations(void **state) {
    enum { STEPS = 5 };
    smart_stage t;
    (void)state;
    smart_stage_open_wide(&t, false, WIDTH, HEIGHT, smart_truth_desc, ROOM);
    for (int jumps = 0; jumps < 2; ++jumps) {
        oit_operator ops[3] = {{0}, smart_truth_smart(STEPS, 0), smart_truth_law(OIT_LAW_DISTANCE, 0)};
        ref_smart_image image;
        double worst = 0;
        size_t far = 0;
        smart_truth_balls(&t);
        ops[0] = smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
        ops[1].smart.jumps = jumps;
        free(smart_stage_frame(&t, ops, 3, NULL, &image)); /* the law's reach is 20 */
        ref_smart_fragment *found = smart_truth_copy(&image);
        distances(&image, STEPS);
        SMART_TRUTH_EACH(&image, x, y, i, f) {
            double steps = f->beta > 0 ? 1024 * (1 - f->beta) : 1e9;
            double truth = smart_truth_law_of(&image, NULL, x, y, f, &ops[2].law, steps);
            if (f->kind != REF_SMART_SURFACE)
                continue;
            worst = fmax(worst, fabs(found[f - image.fragments].base - truth));
            far += steps > STEPS;
        }
        printf("    %s: %.1e, %zu of %zu are farther\n", jumps ? "jumps" : "iterated", worst, far,
               smart_truth_count(&image));
        assert_true(worst <= 1e-4 && far > 100);
        free(found);
        smart_stage_drop(&image);
    }
    smart_stage_close(&t);
}

/* Law of opacity or none, and of s: the bounds of [0,1] are meant as they are. */
static void laws_keep_0_and_1(void **state) {
    static const float s[3] = {-1, 1, 1e-7f};
    static const double expected[3] = {0, 1, (double)1e-7f};
    smart_stage t;
    (void)state;
    smart_stage_open_wide(&t, false, WIDTH, HEIGHT, smart_truth_desc, ROOM);
    smart_truth_pipes(&t);
    smart_stage_begin(&t, NULL);
    for (int i = 0; i < 6; ++i) {
        oit_operator op = smart_truth_law(i < 3 ? OIT_LAW_CONSTANT : OIT_LAW_ADAPTIVE, s[i % 3]);
        smart_stage_run(&t, &op);
        ref_smart_image image = smart_stage_look(&t);
        SMART_TRUTH_EACH(&image, x, y, n, f) {
            double layers = i < 3 ? 1 : (double)ref_smart_layers(&image, x, y);
            double truth = expected[i % 3] == 1 ? 1 : expected[i % 3] / layers; /* of what is small: its share */
            assert_true(fabs(f->base - truth) <= 1e-6 * truth);
        }
        smart_stage_drop(&image);
    }
    free(smart_stage_end(&t));
    smart_stage_close(&t);
}

/* ---- the host's own ---- */

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
static const char host_law[] =
    "void oit_operate(uint p)\n{\n    uint first, n = oit_list(p, first);\n"
    "    for (uint i = 0u; i < n; ++i) {\n"
    "        vec3 at = oit_position(oit_device(p), oit_depth(first + i));\n"
    "        oit_set_value(OIT_BASE, first + i, 0.5 + 0.4 * sin(7.0 * at.x) * cos(5.0 * at.y));\n"
    "    }\n}\n";
static const char total[] = "layout(std430, binding = 6) buffer out_total { uint total[]; };\n"
                            "void oit_operate(uint p)\n{\n    uint first, n = oit_list(p, first);\n"
                            "    atomicAdd(total[0], n);\n    for (uint i = 0u; i < n; ++i)\n"
                            "        atomicMax(total[1], floatBitsToUint(oit_value(OIT_HOST + 1u, first + i)));\n}\n";

static oit_operator host_of(GLuint program, int iterations, int value) {
    oit_operator op;
    memset(&op, 0, sizeof op);
    op.kind = OIT_RUN_HOST;
    op.host.program = program;
    op.host.iterations = iterations;
    op.host.value = value;
    return op;
}

/* A law of the host's, its equation 8 (local, 7 times) on base and on a field of its own, what is purely local, and what
 * is of all fragments (global). */
static void the_hosts_operators_do_as_they_say(void **state) {
    (void)state;
    for (int es = 0; es < 2; ++es) {
        smart_stage t;
        smart_stage_open_wide(&t, es, WIDTH, HEIGHT, smart_truth_desc, ROOM);
        smart_truth_wavy(&t);
        GLuint programs[4] = {smart_stage_program(t.set.oit, host_law), smart_stage_program(t.set.oit, diffusion),
                              smart_stage_program(t.set.oit, copy), smart_stage_program(t.set.oit, total)};
        const oit_operator ops[] = {
            smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED), host_of(programs[0], 0, OIT_VALUE_BASE),
            host_of(programs[2], 0, OIT_VALUE_HOST + 1), host_of(programs[1], 7, OIT_VALUE_BASE),
            host_of(programs[1], 3, OIT_VALUE_HOST + 1)};
        ref_smart_links links = smart_stage_links(&t, &ops[0].link);
        uint32_t zeros[2] = {0, 0};
        smart_stage_begin(&t, NULL);
        for (size_t i = 0; i < sizeof ops / sizeof ops[0]; ++i)
            smart_stage_run(&t, &ops[i]);
        ref_smart_image image = smart_stage_look(&t);
        ref_smart_fragment *found = smart_truth_copy(&image);
        double most = 0;
        SMART_TRUTH_EACH(&image, x, y, i, f) {
            double at[3];
            ref_smart_place(&image, links.projection, x, y, f->depth, at);
            f->base = f->gamma = 0.5 + 0.4 * sin(7 * at[0]) * cos(5 * at[1]);
        }
        assert_true(ref_smart_spread(&image, REF_SMART_BASE, false, 1, REF_SMART_EIGHTH, 7));
        assert_true(ref_smart_spread(&image, REF_SMART_GAMMA, false, 1, REF_SMART_EIGHTH, 3));
        for (size_t i = 0; i < smart_truth_count(&image); ++i) {
            const ref_smart_fragment *f = &image.fragments[i];
            assert_true(fabs(found[i].base - f->base) < 1e-5);
            assert_true(fabs((double)t.rows[i].host[1] - 2 * f->gamma) < 2e-5);
            most = fmax(most, (double)t.rows[i].host[1]);
        }
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, t.out);
        glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof zeros, zeros);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SMART_STAGE_BINDING, t.out);
        oit_operator global = host_of(programs[3], 0, OIT_VALUE_HOST);
        smart_stage_run(&t, &global);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, t.out);
        const uint32_t *words = glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, 8, GL_MAP_READ_BIT);
        assert_non_null(words);
        float greatest;
        memcpy(&greatest, words + 1, sizeof greatest);
        assert_int_equal(words[0], smart_truth_count(&image));
        assert_true((double)greatest == most);
        glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
        free(smart_stage_end(&t));
        free(found);
        smart_stage_drop(&image);
        for (int i = 0; i < 4; ++i)
            glDeleteProgram(programs[i]);
        smart_stage_close(&t);
    }
}

/* What is no number, or no opacity, does not get into the fields: 0, or the nearer end of [0,1]. */
static void what_is_no_number_becomes_0(void **state) {
    static const char once[] =
        "void oit_operate(uint p)\n{\n    uint first, n = oit_list(p, first);\n"
        "    float bad = uintBitsToFloat(p % 4u == 0u ? 0x7fc00000u : p % 4u == 1u ? 0xff800000u :\n"
        "                                p % 4u == 2u ? 0xbf800000u : 0x7f000000u);\n"
        "    for (uint i = 0u; i < n; ++i) {\n        oit_set_value(OIT_BASE, first + i, bad);\n"
        "        oit_set_value(OIT_HOST, first + i, bad);\n    }\n}\n";
    static const char again[] = "void oit_operate(uint p)\n{\n    uint first, n = oit_list(p, first);\n"
                                "    for (uint i = 0u; i < n; ++i)\n        oit_set_after(first + i,\n"
                                "            uintBitsToFloat(p % 2u == 0u ? 0x7fc00000u : 0x7f800000u));\n}\n";
    static const double expected[4] = {0, 0, -1, 1.7014118346046923e38};
    smart_stage t;
    (void)state;
    smart_stage_open_wide(&t, false, WIDTH, HEIGHT, smart_truth_desc, ROOM);
    smart_truth_pipes(&t);
    const oit_operator ops[2] = {host_of(smart_stage_program(t.set.oit, once), 0, OIT_VALUE_BASE),
                                 host_of(smart_stage_program(t.set.oit, again), 2, OIT_VALUE_HOST + 1)};
    ref_smart_image image;
    float *picture = smart_stage_frame(&t, ops, 2, NULL, &image);
    SMART_TRUTH_EACH(&image, x, y, i, f) {
        const smart_stage_row *row = &t.rows[f - image.fragments];
        int which = (y * WIDTH + x) % 4;
        assert_true(f->base == (which == 3 ? 1 : 0));
        assert_true((double)row->host[0] == expected[which] && row->host[1] == 0);
    }
    for (int k = 0; k < 4 * WIDTH * HEIGHT; ++k)
        assert_true(picture[k] >= 0 && picture[k] <= 1);
    free(picture);
    smart_stage_drop(&image);
    for (int i = 0; i < 2; ++i)
        glDeleteProgram(ops[i].host.program);
    smart_stage_close(&t);
}

/* ---- curvature ---- */

static void curvature_is_that_of_the_truth(void **state) {
    (void)state;
    for (int es = 0; es < 2; ++es) {
        smart_stage t;
        smart_stage_open_wide(&t, es, WIDTH, HEIGHT, smart_truth_desc, ROOM);
        for (size_t i = es ? SMART_TRUTH_SCENES - 2 : 0; i < SMART_TRUTH_SCENES; ++i) {
            double worst[2] = {0, 0};
            smart_truth_scenes[i].make(&t);
            oit_operator ops[2] = {smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED),
                                   {.kind = OIT_RUN_CURVATURE}};
            ref_smart_links links = smart_stage_links(&t, &ops[0].link);
            smart_stage_begin(&t, NULL);
            smart_stage_run(&t, &ops[0]);
            for (int per_world = 0; per_world < 2; ++per_world) {
                ref_smart_view view = {{0}, per_world ? 0.5 : 0};
                memcpy(view.projection, links.projection, sizeof view.projection);
                ops[1].curvature.unit = per_world ? 0.5f : 0.0f;
                smart_stage_run(&t, &ops[1]);
                ref_smart_image image = smart_stage_look(&t);
                SMART_TRUTH_EACH(&image, x, y, k, f) {
                    double truth = f->kind == REF_SMART_SURFACE ? ref_smart_kappa(&image, x, y, f, &view) : 0;
                    assert_true(f->kappa >= -1 && f->kappa <= 1);
                    worst[per_world] = fmax(worst[per_world], fabs(truth - f->kappa));
                }
                smart_stage_drop(&image);
            }
            free(smart_stage_end(&t));
            printf("    %-22s kappa off by %.1e per pixel, %.1e per unit\n", smart_truth_scenes[i].name, worst[0],
                   worst[1]);
            assert_true(worst[0] <= 1e-4 && worst[1] <= 2e-3); /* steps are differences of depths of 24 bits */
        }
        smart_stage_close(&t);
    }
}

/* c cosh(v/c) turned about an axis: a minimal surface, whose principal curvatures cancel everywhere. */
static void catenoid(double u, double v, const double *n, double out[3]) {
    double turn = 6.28318530717958648 * u, along = n[1] * (v - 0.5), r = n[0] * cosh(along / n[0]);
    out[0] = r * cos(turn);
    out[1] = along;
    out[2] = r * sin(turn);
}

typedef struct closed_form {
    const char *name;
    smart_stage_shape shape;
    double numbers[4], sum; /* of the principal curvatures, as seen from outside */
    double facing;          /* least cosine: per pixel what is known is known of surfaces that face the eye */
} closed_form;

/* Mean of kappa over the nearest fragments that face the eye, and of what it should be there. */
static void mean_curvature(smart_stage *t, const closed_form *form, double unit, double half, double out[2]) {
    oit_operator ops[2] = {smart_truth_link(t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED), {.kind = OIT_RUN_CURVATURE}};
    ref_smart_image image;
    size_t count = 0;
    ops[1].curvature.unit = (float)unit;
    free(smart_stage_frame(t, ops, 2, NULL, &image));
    ref_smart_links links = smart_stage_links(t, &ops[0].link);
    out[0] = out[1] = 0;
    for (int y = 1; y < image.height - 1; ++y)
        for (int x = 1; x < image.width - 1; ++x) {
            const ref_smart_fragment *f = ref_smart_count(&image, x, y) ? ref_smart_at(&image, x, y, 0) : NULL;
            if (!f || fabs(f->normal[2]) < form->facing)
                continue;
            double pixel = 2 * half * ref_smart_distance(links.projection, f->depth) / image.width;
            double scale = unit > 0 ? unit : pixel;
            out[0] += f->kappa * (f->normal[2] > 0 ? 1 : -1); /* of a normal that points inward the sign is the other */
            out[1] += tanh(form->sum * scale);
            ++count;
        }
    assert_true(count > 50);
    out[0] /= (double)count;
    out[1] /= (double)count;
    smart_stage_drop(&image);
}

/* Per pixel and per unit of the world, near and far. */
static void curvature_is_that_of_closed_forms(void **state) {
    static const closed_form forms[] = {{"sphere", smart_stage_ball, {0, 0, 0, 0.8}, -2 / 0.8, 0.97},
                                        {"cylinder", smart_stage_pipe, {0.7, 3, 0, 1}, -1 / 0.7, 0.97},
                                        {"catenoid", catenoid, {0.5, 1.2}, 0, 0.8}};
    static const double distances[] = {3, 12}, color[4] = {1, 1, 1, 0.5};
    smart_stage t;
    (void)state;
    smart_stage_open(&t, false, 64, smart_truth_desc, ROOM);
    for (int i = 0; i < 12; ++i) {
        const closed_form *form = &forms[i / 4];
        double distance = distances[i & 1], half = 1.5 / distance, unit = i & 2 ? 0.4 : 0, found[2];
        oit_scene *s = smart_stage_clear(&t);
        oit_scene_camera(s, distance, 1, 20, half);
        smart_stage_sheet(s, form->shape, form->numbers, 160, color);
        mean_curvature(&t, form, unit, half, found);
        printf("    %-10s distance %2g, per %s: %.4f, expected %.4f\n", form->name, distance, i & 2 ? "unit " : "pixel",
               found[0], found[1]);
        assert_true(fabs(found[0] - found[1]) <= 0.02 * fabs(found[1]) + 0.005);
    }
    smart_stage_close(&t);
}

/* ---- transfer functions ---- */

static double between(double a, double b, double t) {
    return a + t * (b - a);
}

/* Of a table of rows x columns, at places in [0,1] across and along. */
static double looked_up(const float *table, int columns, int rows, int stride, double across, double along) {
    double x = fmin(fmax(across, 0), 1) * (columns - 1), y = fmin(fmax(along, 0), 1) * (rows - 1);
    int i = (int)fmin(floor(x), columns - 2), j = rows > 1 ? (int)fmin(floor(y), rows - 2) : 0, up = rows > 1;
    const float *at = table + stride * (j * columns + i);
    return between(between((double)at[0], (double)at[stride], x - i),
                   between((double)at[up * stride * columns], (double)at[up * stride * columns + stride], x - i),
                   y - j);
}

static float shades[3 * OIT_TRANSFER_SHADES], opacities[OIT_TRANSFER_CURVATURES * OIT_TRANSFER_DEPTHS];

/* smooth: an interpolated table shows what is between its entries; rough: each entry counts. */
static void fill_tables(bool rough) {
    uint32_t state = 5;
    for (int i = 0; i < 3 * OIT_TRANSFER_SHADES; ++i)
        shades[i] = (float)(rough ? 1.5 * oit_scene_random(&state) : (double)(i / 3) / OIT_TRANSFER_SHADES);
    for (int i = 0; i < OIT_TRANSFER_CURVATURES * OIT_TRANSFER_DEPTHS; ++i)
        opacities[i] = (float)(rough ? 1.2 * oit_scene_random(&state) - 0.1 /* what is out of range is cut */
                                     : 0.02 * (i % OIT_TRANSFER_CURVATURES) + 0.02 * (i / OIT_TRANSFER_CURVATURES));
}

/* The host's tables: opacity of every fragment and the picture, by its kappa and distance. */
static void transfer_functions_are_looked_up(void **state) {
    (void)state;
    for (int es = 0; es < 2; ++es) {
        smart_stage t;
        smart_stage_open_wide(&t, es, WIDTH, HEIGHT, smart_truth_desc, ROOM);
        for (int i = 0; i < 4; ++i) {
            double worst = 0, first = i & 1 ? 3 : 0.5, last = i & 1 ? 4.2 : 8; /* those of the balls' projection */
            oit_operator ops[2] = {{0}, {.kind = OIT_RUN_CURVATURE}};
            ref_smart_image image;
            smart_truth_balls(&t);
            ops[0] = smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
            fill_tables(i < 2);
            ops[1].curvature.unit = i & 1 ? 0.2f : 0;
            ops[1].curvature.shades = shades;
            ops[1].curvature.opacities = opacities;
            ops[1].curvature.first = i & 1 ? 3 : 0;
            ops[1].curvature.last = i & 1 ? 4.2f : 0;
            float *picture = smart_stage_frame(&t, ops, 2, NULL, &image);
            ref_smart_links links = smart_stage_links(&t, &ops[0].link);
            for (int k = 0; k < OIT_TRANSFER_CURVATURES * OIT_TRANSFER_DEPTHS; ++k)
                opacities[k] = fminf(fmaxf(opacities[k], 0), 1);
            SMART_TRUTH_EACH(&image, x, y, n, f) {
                double depth = (ref_smart_distance(links.projection, f->depth) - first) / (last - first);
                double truth =
                    looked_up(opacities, OIT_TRANSFER_CURVATURES, OIT_TRANSFER_DEPTHS, 1, fabs(f->kappa), depth);
                if (f->kind != REF_SMART_SURFACE)
                    continue;
                worst = fmax(worst, fabs(f->base - truth));
                f->base = truth;
                f->beta = f->gamma = 0;
                for (int c = 0; c < 3; ++c)
                    f->color[c] *= looked_up(shades + c, OIT_TRANSFER_SHADES, 1, 3, 0.5 * f->kappa + 0.5, 0);
            }
            double error = smart_truth_picture_error(picture, &image, false);
            printf("    %s table, depths %g to %g: opacity %.1e, picture %.1e\n", i < 2 ? "rough" : "smooth", first,
                   last, worst, error);
            assert_true(worst <= 1e-4 && error <= 1.0 / 2550);
            free(picture);
            smart_stage_drop(&image);
        }
        smart_stage_close(&t);
    }
}

typedef struct sample {
    double curvature, depth, value;
} sample;

static int rises(const sample *s, size_t count) { /* where both rise, the value does not fall */
    for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < count; ++k)
            if (s[i].curvature <= s[k].curvature && s[i].depth <= s[k].depth && s[i].value > s[k].value + 2e-4)
                return 0;
    return 1;
}

/* Murray's figures 6 and 7 in words. Shades are seen of one opaque layer. */
static void presets_are_as_they_are_described(void **state) {
    static const double white[4] = {0.5, 0.5, 0.5, 1};
    enum { MOST = 400 };
    static sample samples[4][MOST];
    size_t count = 0, convex = 0;
    smart_stage t;
    (void)state;
    smart_stage_open(&t, false, 40, smart_truth_desc, ROOM);
    oit_scene *s = smart_stage_clear(&t);
    oit_scene_camera(s, 4, 2, 6, 0.33);
    t.radius = 1.5;
    smart_stage_sheet(s, smart_stage_wavy, (const double[6]){0, 0.5, 0.2, 0.15, 6, 0.4}, 64, white);
    for (int i = 0; i < 4; ++i) {
        oit_operator ops[2] = {smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED), {.kind = OIT_RUN_CURVATURE}};
        ref_smart_image image;
        ops[1].curvature.unit = 0.3f;
        ops[1].curvature.shade = i < 2 ? (oit_shade)(i + 1) : OIT_SHADE_NONE;
        ops[1].curvature.opacity = i < 2 ? OIT_OPACITY_NONE : (oit_opacity)(i - 1);
        float *picture = smart_stage_frame(&t, ops, 2, NULL, &image);
        count = 0;
        for (int p = 0; p < 40 * 40 && count < MOST; p += 3) {
            const ref_smart_fragment *f = &image.fragments[image.start[p]];
            if (image.start[p + 1] == image.start[p])
                continue;
            sample *out = &samples[i][count++];
            out->curvature = i == 0 ? -f->kappa : fabs(f->kappa);
            out->depth = i < 2 ? 0 : f->depth;
            out->value = i < 2 ? (double)picture[4 * p] / 0.5 : f->base;
            convex += i == 0 && f->kappa < -0.1 ? 1 : 0;
        }
        assert_true(rises(samples[i], count));
        free(picture);
        smart_stage_drop(&image);
    }
    assert_true(count > 300 && convex > 50);
    for (size_t i = 0; i < count; ++i) {
        const sample *brighter = &samples[0][i], *bent = &samples[1][i], *front = &samples[2][i],
                     *deep = &samples[3][i];
        if (fabs(brighter->curvature) > 0.02)
            assert_true((brighter->value > 1) == (brighter->curvature > 0)); /* convex: brighter; concave: darker */
        assert_true(bent->curvature > 0.1 || bent->value < 0.7);
        assert_true(bent->curvature < 0.9 || bent->value > 1.3);
        assert_true(front->value >= deep->value - 1e-4);
        assert_true(deep->value >= 0 && front->value <= 1);
    }
    smart_stage_close(&t);
}

/* ---- stores, states, conventions ---- */

static const oit_store_kind stores[] = {OIT_STORE_EXACT, OIT_STORE_PREDICT, OIT_STORE_LINKED, OIT_STORE_BUDGET,
                                        OIT_STORE_BUCKETED};

/* Three frames, so that what is predicted or grown has been. */
static void expect_picture(smart_stage *t, const char *name, int which) {
    oit_operator ops[3] = {smart_truth_link(t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED),
                           smart_truth_law(OIT_LAW_ADAPTIVE, 0.4f), smart_truth_smart(9, 0.08f)};
    smart_truth_scenes[which].make(t);
    ops[0].link.radius = (float)t->radius;
    for (int frame = 0; frame < 2; ++frame)
        free(smart_stage_frame(t, ops, 3, NULL, NULL));
    smart_truth_expect(t, name, &ops[1].law, &ops[2].smart);
}

static void every_store_makes_the_picture_of_the_truth(void **state) {
    (void)state;
    for (int i = 0; i < 20; ++i) {
        char name[64];
        smart_stage t;
        oit_desc desc = smart_truth_desc;
        desc.store = stores[i % 5];
        desc.layers = 16;
        desc.fit = i / 5 & 1 ? OIT_FIT_ASYNC : OIT_FIT_WAIT;
        desc.color = i & 1 ? OIT_COLOR_HALF : OIT_COLOR_FLOAT;
        smart_stage_open_wide(&t, i >= 10, WIDTH, HEIGHT, desc, ROOM);
        snprintf(name, sizeof name, "%s, store %d, fit %d", i >= 10 ? "ES 3.1" : "GL 4.3", (int)desc.store,
                 (int)desc.fit);
        expect_picture(&t, name, 1);
        smart_stage_close(&t);
    }
}

/* The three nearest of each pixel, the others in the tail: fields are those of what is kept. */
static void a_budget_has_the_fields_of_what_it_keeps(void **state) {
    (void)state;
    for (int i = 0; i < 2; ++i) {
        smart_stage t;
        oit_desc desc = smart_truth_desc;
        oit_operator law = smart_truth_law(OIT_LAW_ADAPTIVE, 0.4f), smart = smart_truth_smart(9, 0.08f);
        oit_report report = {0};
        desc.store = i ? OIT_STORE_BUCKETED : OIT_STORE_BUDGET;
        desc.layers = 3;
        smart_stage_open_wide(&t, false, WIDTH, HEIGHT, desc, ROOM);
        smart_truth_wavy(&t);
        smart_truth_errors e = smart_truth_frame(&t, &law.law, &smart.smart);
        oit_scene_expect(oit_get_report(t.set.oit, &report), "oit_get_report");
        assert_true(e.base <= 1e-4 && e.beta <= 1e-4 && e.gamma <= 1e-4 && e.fragments <= 3 * WIDTH * HEIGHT);
        assert_true(report.lost > 1000 && isfinite(e.picture) &&
                    e.picture > 1e-3); /* there is a tail, and it is seen */
        smart_stage_close(&t);
    }
}

/* Reversed depth with [0,1] clip depth; premultiplied colours and 10 bits of them. */
static void conventions_make_the_picture_of_the_truth(void **state) {
    (void)state;
    for (int i = 0; i < 3; ++i) {
        static const char *const names[3] = {"reversed depth", "reversed depth, wavy sheets", "10 bits of colour"};
        static const int which[3] = {1, 3, 8};
        smart_stage t;
        oit_desc desc = smart_truth_desc;
        desc.reversed_z = i < 2;
        desc.color = i == 2 ? OIT_COLOR_8 : OIT_COLOR_FLOAT;
        smart_stage_open_wide(&t, false, WIDTH, HEIGHT, desc, ROOM);
        oit_operator ops[3] = {{0}, smart_truth_law(OIT_LAW_ANGLE, 0.4f), smart_truth_smart(9, 0.08f)};
        if (i < 2)
            glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        smart_truth_scenes[which[i]].make(&t);
        t.scene.reversed = i < 2;
        ops[0] = smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
        ref_smart_image image;
        free(smart_stage_frame(&t, ops, 1, NULL, &image));
        ref_smart_links links = smart_stage_links(&t, &ops[0].link);
        smart_truth_counts found = smart_truth_compare_links(&image, &links);
        assert_true(found.wrong == 0 && found.close * 500 <= found.links && found.links > 1000);
        smart_stage_drop(&image);
        smart_truth_expect(&t, names[i], &ops[1].law, &ops[2].smart);
        smart_stage_close(&t);
    }
}

/* Two contexts that differ in nothing but who sets the state make the same bits. */
static void who_sets_the_state_changes_no_bit(void **state) {
    float *pictures[2];
    (void)state;
    for (int raw = 0; raw < 2; ++raw) {
        smart_stage t;
        oit_desc desc = smart_truth_desc;
        oit_pass pass;
        double ignored[16];
        desc.fit = OIT_FIT_ASYNC;
        desc.state = raw ? OIT_STATE_NONE : OIT_STATE_RESTORE;
        smart_stage_open_wide(&t, false, WIDTH, HEIGHT, desc, ROOM);
        smart_truth_wavy(&t);
        oit_frame frame = oit_scene_frame(&t.scene, t.set.framebuffer);
        smart_stage_projection(&t, frame.projection, ignored);
        const oit_operator ops[] = {smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED),
                                    smart_truth_smart(20, 0.05f),
                                    {.kind = OIT_RUN_CURVATURE, .curvature = {.shade = OIT_SHADE_CONVEX}}};
        for (int frames = 0; frames < 3; ++frames) {
            oit_setting_clear(&t.set, &t.scene);
            oit_scene_expect(oit_begin(t.set.oit, &frame), "oit_begin");
            for (int step = 0; step < 5; ++step) {
                while (oit_next_pass(t.set.oit, &pass)) {
                    if (raw)
                        oit_scene_apply(&pass);
                    if (!pass.state.groups[0] && !pass.state.vertex_count)
                        smart_stage_draw(&t.scene, t.set.oit, &pass, NULL);
                }
                if (step < 3)
                    smart_stage_run(&t, &ops[step]);
                else if (step == 3)
                    oit_scene_expect(oit_compose(t.set.oit), "oit_compose");
            }
            oit_scene_expect(oit_end(t.set.oit), "oit_end");
            oit_scene_reset_state();
        }
        pictures[raw] = oit_setting_read(&t.set, t.set.framebuffer);
        smart_stage_close(&t);
    }
    assert_memory_equal(pictures[0], pictures[1], 4 * WIDTH * HEIGHT * sizeof(float));
    free(pictures[0]);
    free(pictures[1]);
}

static void draw_order_changes_no_bit(void **state) {
    (void)state;
    smart_stage t;
    smart_stage_open_wide(&t, false, WIDTH, HEIGHT, smart_truth_desc, ROOM);
    for (size_t i = 0; i < SMART_TRUTH_SCENES; ++i) {
        float *pictures[2];
        size_t order[16];
        smart_truth_scenes[i].make(&t);
        assert_true(t.scene.count <= 16);
        const oit_operator ops[4] = {smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED),
                                     smart_truth_law(OIT_LAW_ADAPTIVE, 0),
                                     smart_truth_smart(20, 0),
                                     {.kind = OIT_RUN_CURVATURE, .curvature = {.shade = OIT_SHADE_CONVEX}}};
        for (int run = 0; run < 2; ++run) {
            for (size_t k = 0; k < t.scene.count; ++k)
                order[k] = run ? t.scene.count - 1 - k : k;
            pictures[run] = smart_stage_frame(&t, ops, 4, order, NULL);
        }
        assert_memory_equal(pictures[0], pictures[1], WIDTH * HEIGHT * 4 * sizeof(float));
        free(pictures[0]);
        free(pictures[1]);
    }
    smart_stage_close(&t);
}

/* ---- what is refused ---- */

static char last_message[512];

static void remember(oit_log_level level, oit_result code, const char *text, void *user) {
    (void)level, (void)code, (void)user;
    snprintf(last_message, sizeof last_message, "%s", text);
}

/* A store without fragments in memory, and an image in bands: an error that says so, and the picture all the same. */
static void what_cannot_be_is_refused(void **state) {
    smart_stage t;
    oit_desc desc = smart_truth_desc;
    oit_result result;
    (void)state;
    smart_stage_open_wide(&t, false, WIDTH, HEIGHT, desc, ROOM);
    memset(&desc, 0, sizeof desc);
    desc.store = OIT_STORE_FETCH;
    desc.operators = OIT_OPERATE_LAW;
    desc.get_proc = oit_scene_get_proc;
    desc.log_fn = remember;
    assert_null(oit_create(&desc, &result));
    assert_true(result == OIT_INVALID_ARGUMENT || result == OIT_NO_FETCH);
    printf("    %s\n", last_message);
    assert_non_null(strstr(last_message, "operators"));
    smart_stage_close(&t);

    desc = smart_truth_desc;
    desc.ceiling_bytes = 60000;
    smart_stage_open_wide(&t, false, WIDTH, HEIGHT, desc, ROOM);
    smart_truth_wavy(&t);
    oit_operator op = smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
    t.set.quiet = true;
    for (int run = 0; run < 2; ++run) {
        smart_stage_begin(&t, NULL);
        assert_int_equal(oit_run(t.set.oit, &op), OIT_TOO_LARGE);
        float *picture = smart_stage_end(&t);
        oit_report report;
        oit_scene_expect(oit_get_report(t.set.oit, &report), "oit_get_report");
        assert_true(report.bands > 1 && report.lost_pixels == 0);
        assert_true(picture[4 * (WIDTH * (HEIGHT / 2) + WIDTH / 2)] < 0.9f); /* not the background's */
        free(picture);
    }
    smart_stage_close(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(links_are_those_of_the_truth),
        cmocka_unit_test(searches_find_the_same_links),
        cmocka_unit_test(links_by_parameters_are_those_of_the_truth),
        cmocka_unit_test(the_limit_of_continuity_parts_surfaces),
        cmocka_unit_test(the_window_looks_at_few_pairs),
        cmocka_unit_test(of_ties_the_nearer_to_the_eye_is_taken),
        cmocka_unit_test(layers_beyond_254_have_links),
        cmocka_unit_test(laws_are_those_of_the_truth),
        cmocka_unit_test(distances_end_with_the_iterations),
        cmocka_unit_test(laws_keep_0_and_1),
        cmocka_unit_test(the_hosts_operators_do_as_they_say),
        cmocka_unit_test(what_is_no_number_becomes_0),
        cmocka_unit_test(curvature_is_that_of_the_truth),
        cmocka_unit_test(curvature_is_that_of_closed_forms),
        cmocka_unit_test(transfer_functions_are_looked_up),
        cmocka_unit_test(presets_are_as_they_are_described),
        cmocka_unit_test(every_store_makes_the_picture_of_the_truth),
        cmocka_unit_test(a_budget_has_the_fields_of_what_it_keeps),
        cmocka_unit_test(conventions_make_the_picture_of_the_truth),
        cmocka_unit_test(who_sets_the_state_changes_no_bit),
        cmocka_unit_test(draw_order_changes_no_bit),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    if (getenv("GLASSINE_TEST")) /* one of them */
        cmocka_set_test_filter(getenv("GLASSINE_TEST"));
    return cmocka_run_group_tests(tests, NULL, NULL);
}

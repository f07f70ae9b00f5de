/* gl_smart.c: the operators of oit_buffers.h on a real driver, each held to its counterpart in double (reference_smart.h)
 * on the same fragments, read back. */
#include "smart_stage.h"

static const oit_desc all_operators = {
    .color = OIT_COLOR_FLOAT, .fields = OIT_FIELD_BLEND, .operators = OIT_OPERATE_ALL, .operator_fields = 1};

/* ---- scenes ---- */

typedef void (*make_scene)(smart_stage *t);

/* Carnecky 2013, figure 3: pixels 8 to 31 of 40 before 2 to 19 by 2 to 37, as tests/probes_smart.h has them. */
static void make_squares(smart_stage *t) {
    oit_scene *s = smart_stage_clear(t);
    const double pixel = 2.0 / t->set.width, z[2][4] = {{-0.2, -0.2, -0.2, -0.2}, {0.3, 0.3, 0.3, 0.3}};
    const double colors[2][4] = {{0.9, 0.2, 0.2, 0.3}, {0.2, 0.35, 0.9, 0.3}};
    oit_scene_quad(s, 8 * pixel - 1, 8 * pixel - 1, 32 * pixel - 1, 32 * pixel - 1, z[0], colors[0]);
    oit_scene_quad(s, 2 * pixel - 1, 2 * pixel - 1, 20 * pixel - 1, 38 * pixel - 1, z[1], colors[1]);
}

static void make_balls(smart_stage *t) {
    oit_scene *s = smart_stage_clear(t);
    uint32_t state = 7;
    oit_scene_camera(s, 4, 0.5, 8, 0.35);
    t->radius = 1.7;
    for (int i = 0; i < 6; ++i) {
        double numbers[4], color[4];
        for (int k = 0; k < 3; ++k)
            numbers[k] = 1.6 * oit_scene_random(&state) - 0.8;
        numbers[3] = 0.3 + 0.4 * oit_scene_random(&state);
        smart_stage_color(&state, 0.3, color);
        s->objects[smart_stage_sheet(s, smart_stage_ball, numbers, 40, color)].part = i < 4 ? 1 : 2;
    }
}

/* All of one part, so that nothing but depth and normals tells them apart. */
static void make_sheets(smart_stage *t, int count, double tilt, double height) {
    oit_scene *s = smart_stage_clear(t);
    uint32_t state = 11;
    oit_scene_camera(s, 4, 1, 8, 0.33);
    t->radius = 1.5;
    for (int i = 0; i < count; ++i) {
        const double share = (i + 0.5) / count, r = oit_scene_random(&state) - 0.5;
        const double numbers[6] = {1.4 * share - 0.7, tilt * r, tilt * (share - 0.5), height / count, 7 + 5 * r, 9 * r};
        double color[4];
        smart_stage_color(&state, 0.2, color);
        s->objects[smart_stage_sheet(s, smart_stage_wavy, numbers, 48, color)].part = 1;
    }
}

static void make_tilted(smart_stage *t) {
    make_sheets(t, 12, 0.8, 0);
}

static void make_wavy(smart_stage *t) {
    make_sheets(t, 12, 0.1, 1.5);
}

/* Two planes through each other, of one part. */
static void make_crossing(smart_stage *t) {
    make_sheets(t, 1, 0, 0);
    oit_scene *s = smart_stage_clear(t);
    oit_scene_camera(s, 4, 1, 8, 0.33);
    t->radius = 1.5;
    for (int i = 0; i < 2; ++i) {
        const double numbers[6] = {0, i ? 0.7 : -0.7, i ? 0.1 : 0, 0, 0, 0}, color[4] = {i, 0.5, 1 - i, 0.4};
        s->objects[smart_stage_sheet(s, smart_stage_wavy, numbers, 4, color)].part = 1;
    }
}

/* Figure 2: open cylinders, one in the other. */
static void make_pipes(smart_stage *t) {
    oit_scene *s = smart_stage_clear(t);
    oit_scene_camera(s, 4, 1, 8, 0.33);
    t->radius = 1.3;
    for (int i = 0; i < 3; ++i) {
        const double numbers[4] = {0.9 - 0.25 * i, 1.6, 0.1, i ? 1.1 : 0.8},
                     color[4] = {0.3 * i, 0.5, 1 - 0.3 * i, 0.3};
        smart_stage_sheet(s, smart_stage_pipe, numbers, 48, color);
    }
}

static void make_model_squares(smart_stage *t) {
    smart_stage_model(t, "squares", 0.3);
}
static void make_model_cylinders(smart_stage *t) {
    smart_stage_model(t, "cylinders", 0.3);
}
static void make_model_cube(smart_stage *t) {
    smart_stage_model(t, "cube_and_sphere", 0.3);
}
static void make_model_klein(smart_stage *t) {
    smart_stage_model(t, "klein_bottle", 0.3);
}
static void make_model_stream(smart_stage *t) {
    smart_stage_model(t, "stream_surface", 0.3);
}

static const struct {
    const char *name;
    make_scene make;
} scenes[] = {{"two squares", make_squares},
              {"balls", make_balls},
              {"tilted sheets", make_tilted},
              {"wavy sheets", make_wavy},
              {"crossing planes", make_crossing},
              {"concentric pipes", make_pipes},
              {"model squares", make_model_squares},
              {"model cylinders", make_model_cylinders},
              {"model cube_and_sphere", make_model_cube},
              {"model klein_bottle", make_model_klein},
              {"model stream_surface", make_model_stream}};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

/* ---- comparison ---- */

static oit_operator link_op(const smart_stage *t, oit_criterion criterion, oit_search search) {
    oit_operator op;
    memset(&op, 0, sizeof op);
    op.kind = OIT_RUN_LINK;
    op.link.criterion = criterion;
    op.link.search = search;
    op.link.radius = (float)t->radius;
    return op;
}

/* Whether the choice between two candidates (-1: none) hangs on rounding: their measures, or one and the limit. */
static bool is_close(const ref_smart_image *image, const ref_smart_links *links, int x, int y,
                     const ref_smart_fragment *f, int direction, double slack) {
    int to_x = x, to_y = y;
    if (!ref_smart_next(image, &to_x, &to_y, direction))
        return false;
    ref_smart_links wider = *links, narrower = *links;
    size_t own = (size_t)(f - ref_smart_at(image, x, y, 0)), count = ref_smart_count(image, to_x, to_y);
    wider.limit += slack;
    narrower.limit -= slack;
    for (size_t j = 0; j < count; ++j) { /* each pair's measure against the best of either side */
        const ref_smart_fragment *g = ref_smart_at(image, to_x, to_y, j);
        double wide = ref_smart_measure(&wider, f, g, direction), tight = ref_smart_measure(&narrower, f, g, direction);
        double back = ref_smart_measure(&wider, g, f, direction ^ 1),
               hard = ref_smart_measure(&narrower, g, f, direction ^ 1);
        if (wide != tight || back != hard)
            return true;
        for (size_t k = 0; k < count; ++k)
            if (k != j && isfinite(wide) &&
                fabs(ref_smart_measure(links, f, ref_smart_at(image, to_x, to_y, k), direction) - wide) < slack)
                return true;
        for (size_t k = 0; k < ref_smart_count(image, x, y); ++k)
            if (k != own && isfinite(back) &&
                fabs(ref_smart_measure(links, g, ref_smart_at(image, x, y, k), direction ^ 1) - back) < slack)
                return true;
    }
    return false;
}

typedef struct link_counts {
    size_t links, close, wrong;
} link_counts;

/* The header's links against the truth's. The image keeps the header's: what builds on them is compared by itself. */
static link_counts compare_links(ref_smart_image *image, const ref_smart_links *links) {
    size_t count = image->start[(size_t)image->width * (size_t)image->height];
    link_counts counts = {0, 0, 0};
    int(*found)[4] = malloc((count + 1) * sizeof *found);
    for (size_t i = 0; i < count; ++i)
        memcpy(found[i], image->fragments[i].link, sizeof found[i]);
    ref_smart_link(image, links);
    for (int y = 0; y < image->height; ++y)
        for (int x = 0; x < image->width; ++x)
            for (size_t i = 0; i < ref_smart_count(image, x, y); ++i) {
                ref_smart_fragment *f = ref_smart_at(image, x, y, i);
                for (int d = 0; d < 4; ++d) {
                    int here = found[f - image->fragments][d];
                    counts.links += here >= 0;
                    if (here == f->link[d])
                        continue;
                    bool close = is_close(image, links, x, y, f, d, 4e-6); /* of floats: distances of 8 in units of the
                                                                              radius, from depths of 24 bits */
                    counts.close += close;
                    counts.wrong += !close;
                }
            }
    for (size_t i = 0; i < count; ++i)
        memcpy(image->fragments[i].link, found[i], sizeof found[i]);
    free(found);
    return counts;
}

typedef struct field_errors {
    double base, beta, gamma, picture;
} field_errors;

static double law_of(const ref_smart_image *image, const ref_smart_links *links, int x, int y,
                     const ref_smart_fragment *f, const oit_law *law, double steps) {
    const double s = law->s > 0 ? (double)law->s : law->s < 0 ? 0 : (double)0.3f;
    const double exponent = law->exponent > 0 ? (double)law->exponent : 1;
    double own[3], sum = 0, length;
    switch (law->kind) {
    case OIT_LAW_GIVEN:
        return f->alpha;
    case OIT_LAW_CONSTANT:
        return s;
    case OIT_LAW_ADAPTIVE:
        return ref_smart_adaptive(s, ref_smart_layers(image, x, y));
    case OIT_LAW_ANGLE: /* toward the eye: between two places on the pixel's ray */
        ref_smart_place(image, links->projection, x, y, 0.25, own);
        double other[3];
        ref_smart_place(image, links->projection, x, y, 0.75, other);
        for (int k = 0; k < 3; ++k)
            own[k] -= other[k];
        length = sqrt(ref_smart_dot(own, own));
        return 1 - (1 - s) * pow(fmin(fabs(ref_smart_dot(f->normal, own)) / length, 1), exponent);
    case OIT_LAW_VARIATION:
        for (int axis = 0; axis < 2; ++axis) {
            const ref_smart_fragment *low = ref_smart_linked(image, x, y, f, 2 * axis);
            const ref_smart_fragment *high = ref_smart_linked(image, x, y, f, 2 * axis + 1);
            const double weight = low && high ? 0.25 : 1;
            for (int k = 0; k < 3; ++k) {
                double d = (high ? high : f)->normal[k] - (low ? low : f)->normal[k];
                sum += weight * d * d;
            }
        }
        return 1 - (1 - s) * exp(-(law->scale > 0 ? (double)law->scale : 4) * sqrt(sum));
    default:
        return 1 - (1 - s) * pow(fmin(steps / (law->reach > 0 ? (double)law->reach : 20), 1), exponent);
    }
}

static double profiled(const oit_spread *spread, double u) {
    const double p = spread->p > 0                       ? (double)spread->p
                     : spread->p < 0                     ? 0
                     : spread->profile == OIT_PROFILE_11 ? (double)0.3f
                                                         : 3;
    return spread->profile == OIT_PROFILE_10   ? ref_smart_profile_10(u, p)
           : spread->profile == OIT_PROFILE_11 ? ref_smart_profile_11(u, p)
                                               : u;
}

static double lambda_of(const oit_spread *spread, float standard) {
    return spread->lambda > 0 ? (double)spread->lambda : spread->lambda < 0 ? 0 : (double)standard;
}

static size_t steps_of(const oit_spread *spread) {
    return spread->iterations > 0 ? (size_t)spread->iterations : spread->iterations < 0 ? 0 : 20;
}

/* The truth's fields from the image's links. */
static void solve(ref_smart_image *image, const ref_smart_links *links, const oit_law *law, const oit_smart *smart) {
    const oit_spread *spreads[3] = {&smart->base, &smart->beta, &smart->gamma};
    static const float lambdas[3] = {1, 0.05f, 0.1f};
    ref_smart_begin(image, -1);
    for (int y = 0; y < image->height; ++y)
        for (int x = 0; x < image->width; ++x)
            for (size_t i = 0; i < ref_smart_count(image, x, y); ++i) {
                ref_smart_fragment *f = ref_smart_at(image, x, y, i);
                if (f->kind == REF_SMART_SURFACE)
                    f->base = law_of(image, links, x, y, f, law, 0);
            }
    for (int field = 0; field < 3; ++field)
        assert_true(ref_smart_spread(image, field, field > 0 && spreads[field]->process != OIT_PROCESS_DIFFUSION,
                                     lambda_of(spreads[field], lambdas[field]), REF_SMART_EIGHTH,
                                     steps_of(spreads[field])));
}

/* Fields and picture of one frame against the truth's; links are those that the header found. */
static field_errors compare_fields(smart_stage *t, const oit_law *law, const oit_smart *smart) {
    oit_operator ops[3];
    ref_smart_image image;
    field_errors errors = {0, 0, 0, 0};
    memset(ops, 0, sizeof ops);
    ops[0] = link_op(t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
    ops[1].kind = OIT_RUN_LAW;
    ops[1].law = *law;
    ops[2].kind = OIT_RUN_SMART;
    ops[2].smart = *smart;
    float *picture = smart_stage_frame(t, ops, 3, NULL, &image);
    ref_smart_links links = smart_stage_links(t, &ops[0].link);
    size_t count = image.start[(size_t)image.width * (size_t)image.height];
    ref_smart_fragment *found = malloc((count + 1) * sizeof *found);
    memcpy(found, image.fragments, count * sizeof *found);
    compare_links(&image, &links); /* which directions leave the image */
    solve(&image, &links, law, smart);
    for (size_t i = 0; i < count; ++i) {
        ref_smart_fragment *f = &image.fragments[i];
        if (f->kind != REF_SMART_SURFACE)
            continue;
        assert_true(found[i].base >= 0 && found[i].base <= 1 && found[i].beta >= 0 && found[i].beta <= 1 &&
                    found[i].gamma >= 0 && found[i].gamma <= 1);
        errors.base = fmax(errors.base, fabs(f->base - found[i].base));
        errors.beta = fmax(errors.beta, fabs(f->beta - found[i].beta));
        errors.gamma = fmax(errors.gamma, fabs(f->gamma - found[i].gamma));
        f->beta = profiled(&smart->beta, f->beta);
        f->gamma = profiled(&smart->gamma, f->gamma);
    }
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            double color[3] = {1, 1, 1};
            ref_smart_compose(&image, x, y, color, NULL);
            for (int k = 0; k < 3; ++k)
                errors.picture = fmax(errors.picture, fabs(color[k] - (double)picture[4 * (y * image.width + x) + k]));
        }
    free(found);
    free(picture);
    smart_stage_drop(&image);
    return errors;
}

static void expect_fields(smart_stage *t, const char *name, const oit_law *law, const oit_smart *smart, double slack) {
    field_errors e = compare_fields(t, law, smart);
    printf("    %-34s base %.1e  beta %.1e  gamma %.1e  picture %.1e\n", name, e.base, e.beta, e.gamma, e.picture);
    if (!(e.base <= slack && e.beta <= 1e-4 && e.gamma <= 1e-4 && e.picture <= 1.0 / 255))
        fail_msg("%s: off by more than is allowed", name);
}

/* ---- links ---- */

static void links_are_those_of_the_truth(void **state) {
    (void)state;
    smart_stage t;
    smart_stage_open(&t, false, 40, all_operators, 1 << 18);
    for (size_t i = 0; i < SCENES; ++i)
        for (int kind = 0; kind < 4; ++kind) {
            static const char *const names[4] = {"depth", "depth, no limit", "published", "Murray"};
            static const oit_criterion criteria[4] = {OIT_LINK_DEPTH, OIT_LINK_DEPTH, OIT_LINK_PUBLISHED,
                                                      OIT_LINK_MURRAY};
            ref_smart_image image;
            scenes[i].make(&t);
            oit_operator op = link_op(&t, criteria[kind], OIT_SEARCH_BRUTE);
            op.link.limit = kind == 1 ? -1.0f : 0.0f;
            free(smart_stage_frame(&t, &op, 1, NULL, &image));
            ref_smart_links links = smart_stage_links(&t, &op.link);
            link_counts counts = compare_links(&image, &links);
            printf("    %-22s %-16s %zu fragments, %zu links, %zu turn on rounding, %zu wrong\n", scenes[i].name,
                   names[kind], image.start[(size_t)image.width * (size_t)image.height], counts.links, counts.close,
                   counts.wrong);
            assert_int_equal(counts.wrong, 0);
            assert_true(counts.links > 500 && counts.close * 1000 <= counts.links);
            smart_stage_drop(&image);
        }
    smart_stage_close(&t);
}

/* Windowed and by buckets: the very links of all pairs, fragment by fragment. */
static void searches_find_the_same_links(void **state) {
    (void)state;
    smart_stage t;
    smart_stage_open(&t, false, 64, all_operators, 1 << 18);
    for (size_t i = 0; i < SCENES; ++i)
        for (int limit = 0; limit < 2; ++limit) {
            ref_smart_image images[3];
            scenes[i].make(&t);
            for (int search = 0; search < 3; ++search) {
                oit_operator op = link_op(&t, OIT_LINK_DEPTH, (oit_search)search);
                op.link.limit = limit ? -1.0f : 0.0f;
                free(smart_stage_frame(&t, &op, 1, NULL, &images[search]));
            }
            size_t count = images[0].start[64 * 64], differ[2] = {0, 0};
            for (size_t k = 0; k < count; ++k)
                for (int other = 0; other < 2; ++other)
                    differ[other] += memcmp(images[2 * other].fragments[k].link, images[1].fragments[k].link,
                                            sizeof images[1].fragments[k].link) != 0;
            printf("    %-22s limit %s: windowed differs at %zu, buckets at %zu of %zu\n", scenes[i].name,
                   limit ? "none" : "0.05", differ[0], differ[1], count);
            assert_int_equal(differ[0] + differ[1], 0);
            for (int search = 0; search < 3; ++search)
                smart_stage_drop(&images[search]);
        }
    smart_stage_close(&t);
}

/* ---- fields and pictures ---- */

static void fields_and_pictures_are_those_of_the_truth(void **state) {
    (void)state;
    smart_stage t;
    smart_stage_open(&t, false, 40, all_operators, 1 << 18);
    for (size_t i = 0; i < SCENES; ++i) {
        oit_law law = {.kind = OIT_LAW_CONSTANT};
        oit_smart smart;
        memset(&smart, 0, sizeof smart);
        scenes[i].make(&t);
        expect_fields(&t, scenes[i].name, &law, &smart, 1e-4);
    }
    smart_stage_close(&t);
}

static void laws_are_those_of_the_truth(void **state) {
    (void)state;
    static const char *const names[5] = {"given", "constant", "adaptive", "angle", "variation"};
    smart_stage t;
    smart_stage_open(&t, false, 40, all_operators, 1 << 18);
    for (int kind = 0; kind < 5; ++kind)
        for (int which = 0; which < 2; ++which) {
            char name[64];
            oit_law law = {.kind = (oit_law_kind)kind, .s = which ? 0.6f : 0.0f, .exponent = which ? 2.5f : 0.0f};
            oit_smart smart;
            memset(&smart, 0, sizeof smart);
            smart.base.iterations = which ? -1 : 7;
            (which ? make_model_klein : make_pipes)(&t);
            snprintf(name, sizeof name, "%s, %s", names[kind], which ? "klein_bottle" : "pipes, 7 steps");
            expect_fields(&t, name, &law, &smart, 1e-4);
        }
    smart_stage_close(&t);
}

static void profiles_processes_and_steps_are_those_of_the_truth(void **state) {
    (void)state;
    smart_stage t;
    smart_stage_open(&t, false, 40, all_operators, 1 << 18);
    make_model_stream(&t);
    for (int k = 0; k < 6; ++k) {
        static const char *const names[6] = {"profile 10",           "profile 10, p -> 0", "profile 11",
                                             "beta, gamma diffused", "lambda 0 and 1",     "no steps"};
        oit_law law = {.kind = OIT_LAW_ADAPTIVE, .s = 0.8f};
        oit_smart smart;
        memset(&smart, 0, sizeof smart);
        smart.beta.profile = smart.gamma.profile = k < 2 ? OIT_PROFILE_10 : k == 2 ? OIT_PROFILE_11 : OIT_PROFILE_NONE;
        smart.beta.p = k == 1 ? -1.0f : 0.0f;
        smart.beta.process = smart.gamma.process = k == 3 ? OIT_PROCESS_DIFFUSION : OIT_PROCESS_DEFAULT;
        smart.beta.lambda = k == 4 ? -1.0f : k == 3 ? 0.7f : 0.0f;
        smart.gamma.lambda = k == 4 ? 1.0f : 0.0f;
        smart.beta.iterations = smart.base.iterations = smart.gamma.iterations = k == 5 ? -1 : 13;
        expect_fields(&t, names[k], &law, &smart, 1e-4);
    }
    smart_stage_close(&t);
}

/* Lambda of all sizes and many steps; normals that are none, one pixel, no fragment, 500 layers. */
static void hard_cases_stay_in_range(void **state) {
    (void)state;
    static const float lambdas[5] = {-1, 0.1f, 0.25f, 0.5f, 1};
    smart_stage t;
    smart_stage_open(&t, false, 40, all_operators, 1 << 16);
    for (int k = 0; k < 5; ++k) {
        char name[64];
        oit_law law = {.kind = OIT_LAW_ADAPTIVE, .s = 0.9f};
        oit_smart smart;
        memset(&smart, 0, sizeof smart);
        smart.base.lambda = smart.beta.lambda = smart.gamma.lambda = lambdas[k];
        smart.base.iterations = smart.beta.iterations = smart.gamma.iterations = 300;
        make_pipes(&t);
        snprintf(name, sizeof name, "lambda %g, 300 steps", fmax((double)lambdas[k], 0));
        expect_fields(&t, name, &law, &smart, 1e-4);
    }
    for (int k = 0; k < 3; ++k) {
        static const char *const names[3] = {"no normals", "surfaces of one pixel", "nothing"};
        oit_law law = {.kind = OIT_LAW_ADAPTIVE, .s = 0.9f};
        oit_smart smart;
        memset(&smart, 0, sizeof smart);
        oit_scene *s = smart_stage_clear(&t);
        const double color[4] = {0.2, 0.5, 0.9, 0.3}, pixel = 2.0 / 40, z[4] = {0.1, 0.2, 0.3, 0.2};
        if (k == 0) {
            smart_stage_sheet(s, smart_stage_wavy, (const double[6]){0, 0.1, 0.1, 0, 0, 0}, 8, color);
            memset(s->objects[0].normals, 0, 3 * s->truths[0].vertex_count * sizeof(float));
            glBindBuffer(GL_ARRAY_BUFFER, s->objects[0].buffers[0]);
            glBufferSubData(GL_ARRAY_BUFFER, (GLintptr)(12 * s->truths[0].vertex_count),
                            (GLsizeiptr)(12 * s->truths[0].vertex_count), s->objects[0].normals);
        }
        for (int i = 0; k == 1 && i < 30; ++i) {
            double x = (i % 6) * 6 * pixel - 1, y = (i / 6) * 7 * pixel - 1;
            oit_scene_quad(s, x, y, x + pixel, y + pixel, z, color);
        }
        expect_fields(&t, names[k], &law, &smart, 1e-4);
    }
    smart_stage_close(&t);
}

/* 500 layers: links of 16 bits. */
static void deep_pixels_are_those_of_the_truth(void **state) {
    (void)state;
    smart_stage t;
    oit_law law = {.kind = OIT_LAW_ADAPTIVE, .s = 0.9f};
    oit_smart smart;
    memset(&smart, 0, sizeof smart);
    smart_stage_open(&t, false, 8, all_operators, 1 << 15);
    make_sheets(&t, 500, 0.05, 0);
    expect_fields(&t, "500 layers", &law, &smart, 1e-4);
    smart_stage_close(&t);
}

/* ---- jumps ---- */

static void jumps_never_exceed_the_iterated_fields(void **state) {
    (void)state;
    smart_stage t;
    smart_stage_open(&t, false, 96, all_operators, 1 << 19);
    for (size_t i = 0; i < SCENES; ++i)
        for (int rounds = 0; rounds < 4; ++rounds) { /* 0: until stable, which is exact */
            oit_operator ops[2];
            ref_smart_image iterated, jumped;
            size_t off = 0;
            double base = 0;
            scenes[i].make(&t);
            memset(ops, 0, sizeof ops);
            ops[0] = link_op(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
            ops[1].kind = OIT_RUN_SMART;
            ops[1].smart.base.iterations = 50;
            ops[1].smart.beta.iterations = ops[1].smart.gamma.iterations = 50;
            ops[1].smart.beta.lambda = ops[1].smart.gamma.lambda = 0.02f;
            free(smart_stage_frame(&t, ops, 2, NULL, &iterated));
            ops[1].smart.jumps = 1;
            ops[1].smart.until_stable = rounds == 0;
            ops[1].smart.rounds = rounds == 3 ? 0 : rounds;
            free(smart_stage_frame(&t, ops, 2, NULL, &jumped));
            size_t count = iterated.start[96 * 96];
            for (size_t k = 0; k < count; ++k) {
                const ref_smart_fragment *a = &iterated.fragments[k], *b = &jumped.fragments[k];
                assert_true(b->beta <= a->beta && b->gamma <= a->gamma);
                off += a->beta - b->beta > 0.01 || a->gamma - b->gamma > 0.01;
                base = fmax(base, fabs(a->base - b->base));
            }
            printf("    %-22s %s: %.3f %% off by more than 0.01; base by %.4f\n", scenes[i].name,
                   rounds == 0   ? "until stable"
                   : rounds == 1 ? "1 round      "
                   : rounds == 2 ? "2 rounds     "
                                 : "default      ",
                   100.0 * (double)off / (double)count, base);
            if (rounds == 0)
                assert_int_equal(off, 0);
            if (rounds == 3)
                assert_true((double)off <= 0.001 * (double)count);
            smart_stage_drop(&iterated);
            smart_stage_drop(&jumped);
        }
    smart_stage_close(&t);
}

/* ---- curvature ---- */

static void curvature_is_that_of_the_truth(void **state) {
    (void)state;
    smart_stage t;
    smart_stage_open(&t, false, 64, all_operators, 1 << 18);
    for (size_t i = 0; i < SCENES; ++i)
        for (int per_world = 0; per_world < 2; ++per_world) {
            oit_operator ops[2];
            ref_smart_image image;
            double worst = 0;
            scenes[i].make(&t);
            memset(ops, 0, sizeof ops);
            ops[0] = link_op(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
            ops[1].kind = OIT_RUN_CURVATURE;
            ops[1].curvature.unit = per_world ? 0.5f : 0.0f;
            free(smart_stage_frame(&t, ops, 2, NULL, &image));
            ref_smart_links links = smart_stage_links(&t, &ops[0].link);
            ref_smart_view view = {{0}, per_world ? 0.5 : 0};
            memcpy(view.projection, links.projection, sizeof view.projection);
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < 64; ++x)
                    for (size_t k = 0; k < ref_smart_count(&image, x, y); ++k) {
                        const ref_smart_fragment *f = ref_smart_at(&image, x, y, k);
                        double truth = ref_smart_kappa(&image, x, y, f, &view);
                        assert_true(f->kappa >= -1 && f->kappa <= 1);
                        worst = fmax(worst, fabs(truth - f->kappa));
                    }
            printf("    %-22s %s: kappa off by %.1e\n", scenes[i].name, per_world ? "per unit " : "per pixel", worst);
            assert_true(worst <= 1e-4 || (per_world && worst <= 2e-3)); /* steps are differences of depths of 24 bits */
            smart_stage_drop(&image);
        }
    smart_stage_close(&t);
}

/* ---- order ---- */

static void draw_order_changes_no_bit(void **state) {
    (void)state;
    smart_stage t;
    smart_stage_open(&t, false, 64, all_operators, 1 << 18);
    for (size_t i = 0; i < SCENES; ++i) {
        oit_operator ops[4];
        float *pictures[2];
        size_t order[16];
        scenes[i].make(&t);
        assert_true(t.scene.count <= 16);
        memset(ops, 0, sizeof ops);
        ops[0] = link_op(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
        ops[1].kind = OIT_RUN_LAW;
        ops[1].law.kind = OIT_LAW_ADAPTIVE;
        ops[2].kind = OIT_RUN_SMART;
        ops[3].kind = OIT_RUN_CURVATURE;
        ops[3].curvature.shade = OIT_SHADE_CONVEX;
        for (int run = 0; run < 2; ++run) {
            for (size_t k = 0; k < t.scene.count; ++k)
                order[k] = run ? t.scene.count - 1 - k : k;
            pictures[run] = smart_stage_frame(&t, ops, 4, order, NULL);
        }
        assert_memory_equal(pictures[0], pictures[1], 64 * 64 * 4 * sizeof(float));
        free(pictures[0]);
        free(pictures[1]);
    }
    smart_stage_close(&t);
}

/* ---- the XT-junction ---- */

/* Weights of the squares along the hidden contour (column 19 against 20), for smart, constant and opaque. */
static void contrast_along_the_contour(smart_stage *t, int law, double out[40]) {
    oit_operator ops[3];
    size_t count = law == 0 ? 3 : 2;
    memset(ops, 0, sizeof ops);
    ops[0] = link_op(t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
    ops[1].kind = OIT_RUN_LAW;
    ops[1].law.kind = OIT_LAW_CONSTANT;
    ops[1].law.s = law == 2 ? 1.0f : 0.3f;
    ops[2].kind = OIT_RUN_SMART;
    ops[2].smart.beta.lambda = 0.1f;
    ops[2].smart.gamma.lambda = 0.2f;
    float *picture = smart_stage_frame(t, ops, count, NULL, NULL);
    for (int y = 0; y < 40; ++y) { /* green: 0.2 before, 0.35 behind, 1 of the background */
        const float *left = &picture[4 * (40 * y + 19)], *right = left + 4;
        out[y] = fabs((double)left[0] - (double)right[0]) / (1 - 0.2); /* red: what is behind against the background */
    }
    free(picture);
}

static void hidden_contours_make_an_xt_junction(void **state) {
    (void)state;
    static const double probes[12] = {0, 0.028, 0.084, 0.168, 0.28, 0.35, 0.42, 0.49, 0.56, 0.63, 0.7, 0.7};
    double smart[40], constant[40], opaque[40];
    smart_stage t;
    smart_stage_open(&t, false, 40, all_operators, 1 << 14);
    make_squares(&t);
    contrast_along_the_contour(&t, 0, smart);
    contrast_along_the_contour(&t, 1, constant);
    contrast_along_the_contour(&t, 2, opaque);
    printf("    row   smart  constant  opaque\n");
    for (int y = 3; y <= 19; ++y)
        printf("    %3d   %.3f   %.3f     %.3f\n", y, smart[y], constant[y], opaque[y]);
    for (int y = 8; y <= 19; ++y) {
        assert_true(fabs(smart[y] - probes[y - 8]) < 1e-5); /* worked out by hand: probes_smart.h */
        assert_true(y == 8 || y == 19 || smart[y] > smart[y - 1]);
        assert_true(fabs(constant[y] - 0.21) < 1e-5); /* an X: the same all along, crossing included */
        assert_true(fabs(opaque[y]) < 1e-5);          /* a T: it ends there */
    }
    for (int y = 3; y <= 7; ++y) { /* the halo beside */
        assert_true(fabs(smart[y] - 0.2 * (7 - y)) < 1e-5);
        assert_true(fabs(constant[y] - 0.3) < 1e-5 && fabs(opaque[y] - 1) < 1e-5);
    }
    smart_stage_close(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(links_are_those_of_the_truth),
        cmocka_unit_test(searches_find_the_same_links),
        cmocka_unit_test(fields_and_pictures_are_those_of_the_truth),
        cmocka_unit_test(laws_are_those_of_the_truth),
        cmocka_unit_test(profiles_processes_and_steps_are_those_of_the_truth),
        cmocka_unit_test(hard_cases_stay_in_range),
        cmocka_unit_test(deep_pixels_are_those_of_the_truth),
        cmocka_unit_test(jumps_never_exceed_the_iterated_fields),
        cmocka_unit_test(curvature_is_that_of_the_truth),
        cmocka_unit_test(draw_order_changes_no_bit),
        cmocka_unit_test(hidden_contours_make_an_xt_junction),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* smart_truth.h: what the operators of oit_buffers.h should make of the fragments that smart_stage.h has read back, by
 * reference_smart.h; the scenes on which that is asked; and the same scenes as fragments in double. */
#ifndef GLASSINE_TESTS_SMART_TRUTH_H
#define GLASSINE_TESTS_SMART_TRUTH_H

#include "smart_stage.h"

static const oit_desc smart_truth_desc = {
    .color = OIT_COLOR_FLOAT, .fields = OIT_FIELD_BLEND, .operators = OIT_OPERATE_ALL, .operator_fields = 2};

/* ---- scenes ---- */

typedef void (*smart_truth_maker)(smart_stage *t);

/* Carnecky 2013, figure 3: pixels 8 to 31 of 40 before 2 to 19 by 2 to 37, as tests/probes_smart.h has them. The eye looks
 * along +z: distances along the view fall from it on. */
static void smart_truth_squares(smart_stage *t) {
    oit_scene *s = smart_stage_clear(t);
    const double x = 2.0 / t->set.width, y = 2.0 / t->set.height;
    const double z[2][4] = {{-0.2, -0.2, -0.2, -0.2}, {0.3, 0.3, 0.3, 0.3}};
    const double colors[2][4] = {{0.9, 0.2, 0.2, 0.3}, {0.2, 0.35, 0.9, 0.3}};
    oit_scene_quad(s, 8 * x - 1, 8 * y - 1, 32 * x - 1, 32 * y - 1, z[0], colors[0]);
    oit_scene_quad(s, 2 * x - 1, 2 * y - 1, 20 * x - 1, 38 * y - 1, z[1], colors[1]);
}

/* Some of one part; lines, light and filters between them. */
static void smart_truth_balls(smart_stage *t) {
    static const uint32_t blends[8] = {OIT_BLEND_OVER, OIT_BLEND_OVER, OIT_BLEND_LINE, OIT_BLEND_ADD,
                                       OIT_BLEND_OVER, OIT_BLEND_OVER, OIT_BLEND_OVER, OIT_BLEND_MULTIPLY};
    oit_scene *s = smart_stage_clear(t);
    uint32_t state = 7;
    oit_scene_camera(s, 4, 0.5, 8, 0.35);
    t->radius = 1.7;
    for (int i = 0; i < 8; ++i) {
        double numbers[4], color[4];
        for (int k = 0; k < 3; ++k)
            numbers[k] = 1.6 * oit_scene_random(&state) - 0.8;
        numbers[3] = 0.3 + 0.4 * oit_scene_random(&state);
        smart_stage_color(&state, 0.3, color);
        size_t at = smart_stage_sheet(s, smart_stage_ball, numbers, 40, color);
        s->objects[at].part = i < 5 ? 1 : 2;
        s->objects[at].blend = blends[i];
    }
}

/* All of one part, so that nothing but depth and normals tells them apart. */
static void smart_truth_sheets(smart_stage *t, int count, double tilt, double height) {
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

static void smart_truth_tilted(smart_stage *t) {
    smart_truth_sheets(t, 8, 0.8, 0);
}

static void smart_truth_wavy(smart_stage *t) {
    smart_truth_sheets(t, 8, 0.1, 1.2);
}

/* Normals that are noise, so that depth and normals want different neighbours. */
static void smart_truth_rough(smart_stage *t) {
    smart_truth_sheets(t, 8, 0, 0);
    for (size_t i = 0; i < t->scene.count; ++i) {
        float *normals = t->scene.objects[i].normals;
        size_t vertices = t->scene.truths[i].vertex_count;
        for (size_t k = 0; k < vertices; ++k) {
            double at = (double)k,
                   n[3] = {2 * sin(971 * at + 31.0 * (double)i), 2 * cos(577 * at + 17.0 * (double)i), 1};
            double length = sqrt(ref_smart_dot(n, n));
            for (size_t c = 0; c < 3; ++c)
                normals[3 * k + c] = (float)(n[c] / length);
        }
        glBindBuffer(GL_ARRAY_BUFFER, t->scene.objects[i].buffers[0]);
        glBufferSubData(GL_ARRAY_BUFFER, (GLintptr)(12 * vertices), (GLsizeiptr)(12 * vertices), normals);
    }
}

/* Two planes through each other, of one part. */
static void smart_truth_crossing(smart_stage *t) {
    oit_scene *s = smart_stage_clear(t);
    oit_scene_camera(s, 4, 1, 8, 0.33);
    t->radius = 1.5;
    for (int i = 0; i < 2; ++i) {
        const double numbers[6] = {0, i ? 0.7 : -0.7, i ? 0.1 : 0, 0, 0, 0}, color[4] = {i, 0.5, 1 - i, 0.4};
        s->objects[smart_stage_sheet(s, smart_stage_wavy, numbers, 4, color)].part = 1;
    }
}

/* Figure 2: open cylinders, one in the other. */
static void smart_truth_pipes(smart_stage *t) {
    oit_scene *s = smart_stage_clear(t);
    oit_scene_camera(s, 4, 1, 8, 0.33);
    t->radius = 1.3;
    for (int i = 0; i < 3; ++i) {
        const double numbers[4] = {0.9 - 0.25 * i, 1.6, 0.1, i ? 1.1 : 0.8},
                     color[4] = {0.3 * i, 0.5, 1 - 0.3 * i, 0.3};
        smart_stage_sheet(s, smart_stage_pipe, numbers, 48, color);
    }
}

static void smart_truth_cube(smart_stage *t) {
    smart_stage_model(t, "cube_and_sphere", 0.3);
}
static void smart_truth_klein(smart_stage *t) {
    smart_stage_model(t, "klein_bottle", 0.3);
}
static void smart_truth_stream(smart_stage *t) {
    smart_stage_model(t, "stream_surface", 0.3);
}

static const struct {
    const char *name;
    smart_truth_maker make;
} smart_truth_scenes[] = {{"two squares", smart_truth_squares},    {"balls, lines, light", smart_truth_balls},
                          {"tilted sheets", smart_truth_tilted},   {"wavy sheets", smart_truth_wavy},
                          {"noisy normals", smart_truth_rough},    {"crossing planes", smart_truth_crossing},
                          {"concentric pipes", smart_truth_pipes}, {"cube and sphere", smart_truth_cube},
                          {"Klein bottle", smart_truth_klein},     {"stream surface", smart_truth_stream}};
enum { SMART_TRUTH_SCENES = sizeof smart_truth_scenes / sizeof smart_truth_scenes[0] };

/* ---- operators ---- */

static inline oit_operator smart_truth_link(const smart_stage *t, oit_criterion criterion, oit_search search) {
    oit_operator op;
    memset(&op, 0, sizeof op);
    op.kind = OIT_RUN_LINK;
    op.link.criterion = criterion;
    op.link.search = search;
    op.link.radius = (float)t->radius;
    return op;
}

static inline oit_operator smart_truth_law(oit_law_kind kind, float s) {
    oit_operator op;
    memset(&op, 0, sizeof op);
    op.kind = OIT_RUN_LAW;
    op.law.kind = kind;
    op.law.s = s;
    return op;
}

static inline oit_operator smart_truth_smart(int steps, float lambda) {
    oit_operator op;
    memset(&op, 0, sizeof op);
    op.kind = OIT_RUN_SMART;
    op.smart.base.iterations = op.smart.beta.iterations = op.smart.gamma.iterations = steps;
    op.smart.beta.lambda = op.smart.gamma.lambda = lambda;
    return op;
}

/* x, y, index, fragment: in the image's order. */
#define SMART_TRUTH_EACH(image, x, y, i, f)                                                                            \
    for (int y = 0; y < (image)->height; ++y)                                                                          \
        for (int x = 0; x < (image)->width; ++x)                                                                       \
            for (size_t i = 0; i < ref_smart_count(image, x, y); ++i)                                                  \
                for (ref_smart_fragment *f = ref_smart_at(image, x, y, i); f; f = NULL)

static inline size_t smart_truth_count(const ref_smart_image *image) {
    return image->start[(size_t)image->width * (size_t)image->height];
}

/* ---- links ---- */

/* Whether the choice between two candidates (-1: none) hangs on rounding: their measures, or one and the limit. */
static inline bool smart_truth_is_close(const ref_smart_image *image, const ref_smart_links *links, int x, int y,
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

typedef struct smart_truth_counts {
    size_t links, close, wrong; /* close: other than the truth's, where that turns on a float's rounding */
} smart_truth_counts;

/* The header's links against the truth's. The image keeps the header's: what builds on them is compared by itself. */
static inline smart_truth_counts smart_truth_compare_links(ref_smart_image *image, const ref_smart_links *links) {
    size_t count = smart_truth_count(image);
    smart_truth_counts counts = {0, 0, 0};
    int(*found)[4] = malloc((count + 1) * sizeof *found);
    for (size_t i = 0; i < count; ++i)
        memcpy(found[i], image->fragments[i].link, sizeof found[i]);
    ref_smart_link(image, links);
    SMART_TRUTH_EACH(image, x, y, i, f)
    for (int d = 0; d < 4; ++d) {
        int here = found[f - image->fragments][d];
        counts.links += here >= 0;
        if (here == f->link[d])
            continue;
        /* Floats: distances of 8 in units of the radius, from depths of 24 bits. */
        bool close = smart_truth_is_close(image, links, x, y, f, d, 4e-6);
        counts.close += close;
        counts.wrong += !close;
    }
    for (size_t i = 0; i < count; ++i)
        memcpy(image->fragments[i].link, found[i], sizeof found[i]);
    free(found);
    return counts;
}

/* ---- laws ---- */

/* Of the cosine between the normal and the pixel's ray, which two places on it give. */
static inline double smart_truth_facing(const ref_smart_image *image, const double projection[16], int x, int y,
                                        const ref_smart_fragment *f) {
    double own[3], other[3];
    ref_smart_place(image, projection, x, y, 0.25, own);
    ref_smart_place(image, projection, x, y, 0.75, other);
    for (int k = 0; k < 3; ++k)
        own[k] -= other[k];
    return fmin(fabs(ref_smart_dot(f->normal, own)) / sqrt(ref_smart_dot(own, own)), 1);
}

static inline double smart_truth_variation(const ref_smart_image *image, int x, int y, const ref_smart_fragment *f) {
    double sum = 0;
    for (int axis = 0; axis < 2; ++axis) {
        const ref_smart_fragment *low = ref_smart_linked(image, x, y, f, 2 * axis);
        const ref_smart_fragment *high = ref_smart_linked(image, x, y, f, 2 * axis + 1);
        for (int k = 0; k < 3; ++k) {
            double d = (high ? high : f)->normal[k] - (low ? low : f)->normal[k];
            sum += (low && high ? 0.25 : 1) * d * d;
        }
    }
    return sqrt(sum);
}

/* steps: to the nearest silhouette, for OIT_LAW_DISTANCE. */
static inline double smart_truth_law_of(const ref_smart_image *image, const double projection[16], int x, int y,
                                        const ref_smart_fragment *f, const oit_law *law, double steps) {
    const double s = law->s > 0 ? (double)law->s : law->s < 0 ? 0 : (double)0.3f;
    const double exponent = law->exponent > 0 ? (double)law->exponent : 1;
    switch (law->kind) {
    case OIT_LAW_GIVEN:
        return f->alpha;
    case OIT_LAW_CONSTANT:
        return s;
    case OIT_LAW_ADAPTIVE:
        return ref_smart_adaptive(s, ref_smart_layers(image, x, y));
    case OIT_LAW_ANGLE:
        return 1 - (1 - s) * pow(smart_truth_facing(image, projection, x, y, f), exponent);
    case OIT_LAW_VARIATION:
        return 1 - (1 - s) * exp(-(law->scale > 0 ? (double)law->scale : 4) * smart_truth_variation(image, x, y, f));
    default:
        return 1 - (1 - s) * pow(fmin(steps / (law->reach > 0 ? (double)law->reach : 20), 1), exponent);
    }
}

/* ---- fields ---- */

static inline double smart_truth_profiled(const oit_spread *spread, double u) {
    const double p = spread->p > 0                       ? (double)spread->p
                     : spread->p < 0                     ? 0
                     : spread->profile == OIT_PROFILE_11 ? (double)0.3f
                                                         : 3;
    return spread->profile == OIT_PROFILE_10   ? ref_smart_profile_10(u, p)
           : spread->profile == OIT_PROFILE_11 ? ref_smart_profile_11(u, p)
                                               : u;
}

static inline double smart_truth_lambda(const oit_spread *spread, float standard) {
    return spread->lambda > 0 ? (double)spread->lambda : spread->lambda < 0 ? 0 : (double)standard;
}

static inline size_t smart_truth_steps(const oit_spread *spread) {
    return spread->iterations > 0 ? (size_t)spread->iterations : spread->iterations < 0 ? 0 : 20;
}

/* The truth's fields from the image's links, and from what its fragments have as their base. */
static inline void smart_truth_spread(ref_smart_image *image, const oit_smart *smart) {
    const oit_spread *spreads[3] = {&smart->base, &smart->beta, &smart->gamma};
    static const float lambdas[3] = {1, 0.05f, 0.1f};
    size_t count = smart_truth_count(image);
    double *base = malloc((count + 1) * sizeof *base);
    for (size_t i = 0; i < count; ++i)
        base[i] = image->fragments[i].base;
    ref_smart_begin(image, -1);
    if (smart->published)
        ref_smart_bound_published(image, smart->beta.process == OIT_PROCESS_DIFFUSION);
    for (size_t i = 0; i < count; ++i)
        image->fragments[i].base = base[i];
    free(base);
    for (int field = 0; field < 3; ++field) {
        bool greatest = field > 0 && spreads[field]->process != OIT_PROCESS_DIFFUSION;
        assert_true(ref_smart_spread(image, field, greatest, smart_truth_lambda(spreads[field], lambdas[field]),
                                     smart->published ? REF_SMART_MEAN_OF_FOUR : REF_SMART_EIGHTH,
                                     smart_truth_steps(spreads[field])));
    }
}

/* From the law's values on. */
static inline void smart_truth_solve(ref_smart_image *image, const double projection[16], const oit_law *law,
                                     const oit_smart *smart) {
    SMART_TRUTH_EACH(image, x, y, i, f)
    f->base = f->kind == REF_SMART_SURFACE ? smart_truth_law_of(image, projection, x, y, f, law, 0) : f->alpha;
    smart_truth_spread(image, smart);
}

typedef struct smart_truth_errors {
    double base, beta, gamma, picture;
    size_t off, fragments; /* surfaces whose base is off by more than 0.01 */
} smart_truth_errors;

static inline bool smart_truth_in_range(double x) {
    return x >= 0 && x <= 1; /* and no NaN */
}

/* The header's values of `found` against the image's, which get the truth's profiles after that. */
static inline smart_truth_errors smart_truth_compare_fields(ref_smart_image *image, const ref_smart_fragment *found,
                                                            const oit_smart *smart) {
    smart_truth_errors e = {0, 0, 0, 0, 0, 0};
    for (size_t i = 0; i < smart_truth_count(image); ++i) {
        ref_smart_fragment *f = &image->fragments[i];
        if (f->kind != REF_SMART_SURFACE)
            continue;
        assert_true(smart_truth_in_range(found[i].base) && smart_truth_in_range(found[i].beta) &&
                    smart_truth_in_range(found[i].gamma));
        e.base = fmax(e.base, fabs(f->base - found[i].base));
        e.beta = fmax(e.beta, fabs(f->beta - found[i].beta));
        e.gamma = fmax(e.gamma, fabs(f->gamma - found[i].gamma));
        e.off += fabs(f->base - found[i].base) > 0.01;
        ++e.fragments;
        f->beta = smart_truth_profiled(&smart->beta, f->beta);
        f->gamma = smart_truth_profiled(&smart->gamma, f->gamma);
    }
    return e;
}

/* Of the composite of the image's fields, over a white background. */
static inline double smart_truth_picture_error(const float *picture, const ref_smart_image *image, bool printed) {
    double worst = 0;
    for (int y = 0; y < image->height; ++y)
        for (int x = 0; x < image->width; ++x) {
            double color[3] = {1, 1, 1};
            ref_smart_compose_as(image, x, y, printed, color, NULL);
            for (int k = 0; k < 3; ++k)
                worst = fmax(worst, fabs(color[k] - (double)picture[4 * (y * image->width + x) + k]));
        }
    return worst;
}

static inline ref_smart_fragment *smart_truth_copy(const ref_smart_image *image) {
    size_t count = smart_truth_count(image);
    ref_smart_fragment *found = malloc((count + 1) * sizeof *found);
    memcpy(found, image->fragments, count * sizeof *found);
    return found;
}

/* Fields and picture of one frame against the truth's; links are those that the header found. */
static inline smart_truth_errors smart_truth_frame(smart_stage *t, const oit_law *law, const oit_smart *smart) {
    oit_operator ops[3];
    ref_smart_image image;
    memset(ops, 0, sizeof ops);
    ops[0] = smart_truth_link(t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
    ops[1].kind = OIT_RUN_LAW;
    ops[1].law = *law;
    ops[2].kind = OIT_RUN_SMART;
    ops[2].smart = *smart;
    float *picture = smart_stage_frame(t, ops, 3, NULL, &image);
    ref_smart_links links = smart_stage_links(t, &ops[0].link);
    ref_smart_fragment *found = smart_truth_copy(&image);
    smart_truth_solve(&image, links.projection, law, smart);
    smart_truth_errors errors = smart_truth_compare_fields(&image, found, smart);
    errors.picture = smart_truth_picture_error(picture, &image, smart->published);
    free(found);
    free(picture);
    smart_stage_drop(&image);
    return errors;
}

static inline void smart_truth_expect(smart_stage *t, const char *name, const oit_law *law, const oit_smart *smart) {
    smart_truth_errors e = smart_truth_frame(t, law, smart);
    printf("    %-36s base %.1e  beta %.1e  gamma %.1e  picture %.1e\n", name, e.base, e.beta, e.gamma, e.picture);
    if (!(e.base <= 1e-4 && e.beta <= 1e-4 && e.gamma <= 1e-4 && e.picture <= 1.0 / 255))
        fail_msg("%s: off by more than is allowed", name);
}

#endif

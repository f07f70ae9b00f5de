/* gl_probes_smart.c: the operators of oit_buffers.h held to the pixels worked out by hand (probes_smart.h), as
 * unit_probes_smart.c holds the reference to them: each patch is a quad of the host's, drawn into a larger picture, since at
 * the frame of the picture the two read a sentence differently (unit_probes_smart.c counts what that changes). */
#include "probes_smart.h"
#include "smart_truth.h"

enum { SIZE = 42, AROUND = 1 };

/* ---- a scene of patches ---- */

/* With the depths of the probes as distances along the view; window depths are the same but for an offset where they
 * differ by less than 1. first, last: all depths. */
static void set_depths(smart_stage *t, double first, double last, double pixel) {
    double *p = t->scene.scene.projection, span = fmax(last - first, 1);
    memset(p, 0, sizeof t->scene.scene.projection);
    p[0] = p[5] = 2 / (SIZE * pixel);
    p[10] = -2 / span;
    p[14] = -2 * first / span - 1;
    p[15] = 1;
}

/* Pixels x0 to x1, y0 to y1 of the probes. */
static size_t add_patch(smart_stage *t, const smart_probe_patch *p, const double color[3]) {
    static const uint32_t order[6] = {0, 1, 2, 0, 2, 3};
    const double corners[4][2] = {{p->x0, p->y0}, {p->x1 + 1, p->y0}, {p->x1 + 1, p->y1 + 1}, {p->x0, p->y1 + 1}};
    const double all[4] = {color[0], color[1], color[2], fmax(p->alpha, 0)};
    const double *m = t->scene.scene.projection;
    float *positions = malloc(12 * sizeof *positions), *normals = malloc(12 * sizeof *normals);
    uint32_t *indices = malloc(sizeof order);
    memcpy(indices, order, sizeof order);
    for (int i = 0; i < 4; ++i) {
        double x = corners[i][0], y = corners[i][1];
        positions[3 * i] = (float)((2 * (x + AROUND) / SIZE - 1) / m[0]);
        positions[3 * i + 1] = (float)((2 * (y + AROUND) / SIZE - 1) / m[5]);
        positions[3 * i + 2] = -(float)(p->z + p->slope_x * (x - 0.5 - p->x0) + p->slope_y * (y - 0.5 - p->y0));
        for (int k = 0; k < 3; ++k)
            normals[3 * i + k] = (float)p->normal[k];
    }
    size_t at = oit_scene_add(&t->scene, positions, normals, 4, indices, 2, all);
    t->scene.objects[at].part = (uint32_t)p->part;
    t->scene.objects[at].blend = p->line ? OIT_BLEND_LINE : OIT_BLEND_OVER;
    return at;
}

static const double patch_colors[5][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}};

/* Of a fragment, by its colour. */
static int patch_of(const ref_smart_fragment *f) {
    for (int i = 0; i < 5; ++i)
        if (memcmp(f->color, patch_colors[i], sizeof f->color) == 0)
            return i;
    fail_msg("a colour that no patch has");
    return -1;
}

static void make_patches(smart_stage *t, int which) {
    const smart_probe_scene *s = &smart_probe_scenes[which];
    double first = 1e9, last = -1e9;
    smart_stage_clear(t);
    for (int i = 0; i < s->patch_count; ++i)
        for (int corner = 0; corner < 4; ++corner) {
            const smart_probe_patch *p = &s->patches[i];
            double z = p->z + p->slope_x * (corner & 1 ? p->x1 - p->x0 + 0.5 : -0.5) +
                       p->slope_y * (corner & 2 ? p->y1 - p->y0 + 0.5 : -0.5);
            first = fmin(first, z - 0.01);
            last = fmax(last, z + 0.01);
        }
    set_depths(t, first, last, 1);
    for (int i = 0; i < s->patch_count; ++i) {
        size_t at = add_patch(t, &s->patches[i], patch_colors[i]);
        memcpy(t->uv_at[at], s->patches[i].uv, sizeof t->uv_at[at]);
    }
    t->radius = s->radius;
}

static oit_operator link_of(const smart_stage *t, int which, oit_criterion criterion) {
    if (criterion == OIT_LINK_DEPTH && smart_probe_scenes[which].by_uv)
        criterion = OIT_LINK_UV;
    oit_operator op = smart_truth_link(t, criterion, OIT_SEARCH_WINDOWED);
    op.link.limit = 0.1f;
    return op;
}

static const ref_smart_fragment *find(const ref_smart_image *image, int patch, int x, int y) {
    for (size_t i = 0; i < ref_smart_count(image, x + AROUND, y + AROUND); ++i) {
        const ref_smart_fragment *f = ref_smart_at(image, x + AROUND, y + AROUND, i);
        if (patch_of(f) == patch)
            return f;
    }
    fail_msg("patch %d has no fragment at %d, %d", patch, x, y);
    return NULL;
}

typedef struct tally {
    const char *name;
    int held, unsure, wrong;
} tally;

static void count(tally *t, bool holds, int unsure, const char *why) {
    t->held += holds;
    t->unsure += !holds && unsure;
    t->wrong += !holds && !unsure;
    if (!holds)
        printf("    %s: %s%s\n", t->name, unsure ? "another reading: " : "WRONG: ", why);
}

static void end(const tally *t) {
    printf("    %s: %d hold, %d rest on another reading of a sentence, %d wrong\n", t->name, t->held, t->unsure,
           t->wrong);
    assert_true(t->held > 10 && t->wrong == 0);
}

static bool is_near(double a, double b, double tolerance) {
    return fabs(a - b) <= tolerance;
}

static void open_stage(smart_stage *t) {
    oit_desc desc = smart_truth_desc;
    desc.fields |= OIT_FIELD_UV | OIT_FIELD_NORMAL | OIT_FIELD_PART;
    smart_stage_open(t, false, SIZE, desc, 1 << 14);
}

/* ---- links, boundary conditions, fields ---- */

static void links(void **state) {
    static const oit_criterion criteria[3] = {OIT_LINK_DEPTH, OIT_LINK_PUBLISHED, OIT_LINK_MURRAY};
    static const char *const names[3] = {"links", "links, published", "links, Murray"};
    smart_stage t;
    (void)state;
    open_stage(&t);
    for (int c = 0; c < 3; ++c) {
        tally sum = {names[c], 0, 0, 0};
        for (int i = 0; i < SMART_PROBE_LINK_COUNT; ++i) {
            const smart_probe_link *p = &smart_probe_links[i];
            int expected = c == 0 ? p->expected : c == 1 ? p->published : p->murray;
            if (expected == -2 || (c > 0 && smart_probe_scenes[p->scene].by_uv))
                continue;
            ref_smart_image image;
            make_patches(&t, p->scene);
            oit_operator op = link_of(&t, p->scene, criteria[c]);
            free(smart_stage_frame(&t, &op, 1, NULL, &image));
            const ref_smart_fragment *f = find(&image, p->patch, p->x, p->y);
            const ref_smart_fragment *to = ref_smart_linked(&image, p->x + AROUND, p->y + AROUND, f, p->direction);
            count(&sum, (to ? patch_of(to) : -1) == expected, p->unsure, p->why);
            smart_stage_drop(&image);
        }
        end(&sum);
    }
    smart_stage_close(&t);
}

static void boundaries(void **state) {
    tally sums[2] = {{"boundaries", 0, 0, 0}, {"boundaries, published", 0, 0, 0}};
    smart_stage t;
    (void)state;
    open_stage(&t);
    for (int i = 0; i < 2 * SMART_PROBE_BOUNDARY_COUNT; ++i) {
        const smart_probe_boundary *p = &smart_probe_boundaries[i / 2];
        const smart_probe_marks *m = i & 1 ? &p->published : &p->expected;
        if ((i & 1) && !p->has_published)
            continue;
        ref_smart_image image;
        make_patches(&t, p->scene);
        oit_operator ops[2] = {link_of(&t, p->scene, OIT_LINK_DEPTH), smart_truth_smart(-1, 0)};
        ops[1].smart.published = i & 1;
        ops[1].smart.beta.process = OIT_PROCESS_DIFFUSION; /* equation 8, which has b in the paper as well */
        free(smart_stage_frame(&t, ops, 2, NULL, &image));
        const ref_smart_fragment *f = find(&image, p->patch, p->x, p->y);
        const smart_stage_row *row = &t.rows[f - image.fragments];
        bool beta_kept = row->steps[0] == 0 || row->steps[0] == 65534, gamma_kept = row->steps[1] == 0;
        count(&sums[i & 1],
              f->beta == m->beta && f->gamma == m->gamma && beta_kept == (m->beta_fixed != 0) &&
                  gamma_kept == (m->gamma_fixed != 0),
              p->unsure, p->why);
        smart_stage_drop(&image);
    }
    end(&sums[0]);
    end(&sums[1]);
    smart_stage_close(&t);
}

static oit_operator law_of(int law, double s) {
    static const oit_law_kind kinds[] = {OIT_LAW_CONSTANT, OIT_LAW_ADAPTIVE, OIT_LAW_GIVEN, OIT_LAW_CONSTANT,
                                         OIT_LAW_CONSTANT};
    return smart_truth_law(kinds[law], law == SMART_PROBE_OPAQUE ? 1 : s > 0 ? (float)s : -1.0f);
}

static void set_spread(oit_spread *spread, double lambda, int steps) {
    spread->lambda = lambda > 0 ? (float)lambda : -1.0f;
    spread->iterations = steps > 0 ? steps : -1;
}

static void fields(void **state) {
    tally sums[2] = {{"fields", 0, 0, 0}, {"fields, published", 0, 0, 0}};
    smart_stage t;
    (void)state;
    open_stage(&t);
    for (int i = 0; i < 2 * SMART_PROBE_FIELD_COUNT; ++i) {
        const smart_probe_field *p = &smart_probe_fields[i / 2];
        if ((i & 1) && p->published < 0)
            continue;
        ref_smart_image image;
        make_patches(&t, p->scene);
        oit_operator ops[3] = {link_of(&t, p->scene, OIT_LINK_DEPTH), law_of(p->alpha_law, p->s),
                               smart_truth_smart(-1, 0)};
        oit_spread *spreads[3] = {&ops[2].smart.base, &ops[2].smart.beta, &ops[2].smart.gamma};
        set_spread(spreads[p->field], p->lambda, p->steps);
        ops[2].smart.published = i & 1;
        free(smart_stage_frame(&t, ops, 3, NULL, &image));
        const ref_smart_fragment *f = find(&image, p->patch, p->x, p->y);
        double value = p->field == SMART_PROBE_ALPHA ? f->base : p->field == SMART_PROBE_BETA ? f->beta : f->gamma;
        count(&sums[i & 1], is_near(value, i & 1 ? p->published : p->expected, p->tolerance), p->unsure, p->why);
        smart_stage_drop(&image);
    }
    end(&sums[0]);
    end(&sums[1]);
    smart_stage_close(&t);
}

/* ---- weights of the picture ---- */

/* Patches are red, green and blue before white: what is in all channels is the background's. */
static void weights_of(const float *picture, int x, int y, double out[4]) {
    const float *at = &picture[4 * (SIZE * (y + AROUND) + x + AROUND)];
    double sum = (double)at[0] + (double)at[1] + (double)at[2];
    out[0] = (sum - 1) / 2; /* weights sum to 1 */
    for (int k = 0; k < 3; ++k)
        out[1 + k] = (double)at[k] - out[0];
}

static float *picture_of(smart_stage *t, int which, int law, double s, double lambda_beta, double lambda_gamma,
                         int steps) {
    make_patches(t, which);
    oit_operator ops[3] = {link_of(t, which, OIT_LINK_DEPTH), law_of(law, s), smart_truth_smart(-1, 0)};
    set_spread(&ops[2].smart.beta, lambda_beta, steps);
    set_spread(&ops[2].smart.gamma, lambda_gamma, steps);
    return smart_stage_frame(t, ops, law == SMART_PROBE_SMART ? 3 : 2, NULL, NULL);
}

static void weights(void **state) {
    tally sum = {"weights", 0, 0, 0};
    smart_stage t;
    (void)state;
    open_stage(&t);
    for (int i = 0; i < SMART_PROBE_WEIGHT_COUNT; ++i) {
        const smart_probe_weight *p = &smart_probe_weights[i];
        double found[4];
        float *picture = picture_of(&t, p->scene, p->law, p->s, p->lambda_beta, p->lambda_gamma, p->steps);
        bool holds = true;
        weights_of(picture, p->x, p->y, found);
        for (int k = 0; k < 1 + smart_probe_scenes[p->scene].patch_count && k < 4; ++k)
            holds = holds && is_near(found[k], p->weights[k], p->tolerance);
        count(&sum, holds, p->unsure, p->why);
        free(picture);
    }
    end(&sum);
    smart_stage_close(&t);
}

static void contrasts(void **state) {
    static const int laws[3] = {SMART_PROBE_SMART, SMART_PROBE_CONSTANT, SMART_PROBE_OPAQUE};
    tally sum = {"contrasts", 0, 0, 0};
    float *pictures[3];
    smart_stage t;
    (void)state;
    open_stage(&t);
    for (int law = 0; law < 3; ++law)
        pictures[law] = picture_of(&t, 0, laws[law], 0.3, 0.1, 0.2, 20);
    for (int i = 0; i < SMART_PROBE_CONTRAST_COUNT; ++i) {
        const smart_probe_contrast *p = &smart_probe_contrasts[i];
        const double expected[3] = {p->smart, p->constant, p->opaque};
        bool holds = true;
        assert_int_equal(p->scene, 0);
        for (int law = 0; law < 3; ++law) {
            double left[4], right[4];
            weights_of(pictures[law], p->x0, p->y, left);
            weights_of(pictures[law], p->x1, p->y, right);
            holds = holds && is_near(fabs(left[2] - right[2]), expected[law], 1e-6);
        }
        count(&sum, holds, 0, p->why);
    }
    end(&sum);
    for (int law = 0; law < 3; ++law)
        free(pictures[law]);
    smart_stage_close(&t);
}

/* ---- single numbers ---- */

/* A square of five pixels: those beside its edge have beta = 1 - lambda. */
static void profiles(void **state) {
    static const smart_probe_patch square = {"square", 0, 0, 4, 4, 10, 0, 0, {0, 0, 1}, 1, 0, 0, {0, 0}, {0, 0, 0}};
    tally sum = {"profiles", 0, 0, 0};
    smart_stage t;
    (void)state;
    open_stage(&t);
    smart_stage_clear(&t);
    set_depths(&t, 9, 11, 1);
    add_patch(&t, &square, patch_colors[0]);
    for (int i = 0; i < SMART_PROBE_PROFILE_COUNT; ++i) {
        const smart_probe_profile *p = &smart_probe_profiles[i];
        oit_operator ops[2] = {smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED), smart_truth_smart(3, 0)};
        set_spread(&ops[1].smart.beta, 1 - p->u, 3);
        ops[1].smart.beta.profile = p->equation == 10 ? OIT_PROFILE_10 : OIT_PROFILE_11;
        ops[1].smart.beta.p = (float)p->p;
        float *picture = smart_stage_frame(&t, ops, 2, NULL, NULL);
        double found[4];
        weights_of(picture, 1, 2, found);
        count(&sum, is_near(found[1], p->expected, p->tolerance), 0, p->why);
        free(picture);
    }
    end(&sum);
    smart_stage_close(&t);
}

static void adaptive_alpha(void **state) {
    tally sum = {"adaptive alpha", 0, 0, 0};
    smart_stage t;
    (void)state;
    open_stage(&t);
    for (int i = 0; i < SMART_PROBE_ADAPTIVE_COUNT; ++i) {
        const smart_probe_adaptive *p = &smart_probe_adaptives[i];
        oit_operator op = smart_truth_law(OIT_LAW_ADAPTIVE, p->s > 0 ? (float)p->s : -1.0f);
        ref_smart_image image;
        smart_stage_clear(&t);
        set_depths(&t, 0, 100, 1);
        for (int n = 0; n < p->n; ++n) {
            const smart_probe_patch layer = {"layer", 0, 0, 0, 0, 1.0 + n, 0, 0, {0, 0, 1}, 1, 0, 0, {0, 0}, {0, 0, 0}};
            add_patch(&t, &layer, patch_colors[0]);
        }
        free(smart_stage_frame(&t, &op, 1, NULL, &image));
        bool holds = smart_truth_count(&image) == (size_t)p->n;
        for (size_t k = 0; k < smart_truth_count(&image); ++k)
            holds = holds && is_near(image.fragments[k].base, p->expected, 1e-6);
        count(&sum, holds, 0, p->why);
        smart_stage_drop(&image);
    }
    assert_true(sum.held == SMART_PROBE_ADAPTIVE_COUNT);
    end(&sum);
    smart_stage_close(&t);
}

/* The fragment and its four neighbours, of one depth. Normals are kept in 16 bits: to 3e-5. */
static void curvatures(void **state) {
    static const int places[5][2] = {{1, 1}, {0, 1}, {2, 1}, {1, 0}, {1, 2}};
    tally sum = {"curvatures", 0, 0, 0};
    smart_stage t;
    (void)state;
    open_stage(&t);
    for (int i = 0; i < SMART_PROBE_CURVATURE_COUNT; ++i) {
        const smart_probe_curvature *p = &smart_probe_curvatures[i];
        ref_smart_image image;
        smart_stage_clear(&t);
        set_depths(&t, 9, 11, p->pixel);
        for (int k = 0; k < 5; ++k) {
            smart_probe_patch one = {
                "one", places[k][0], places[k][1], places[k][0], places[k][1], 10, 0, 0, {0, 0, 0}, 1,
                0,     0.5,          {0, 0},       {0, 0, 0}};
            memcpy(one.normal, p->normals[k], sizeof one.normal);
            if (k == 0 || !(p->missing >> (k - 1) & 1))
                add_patch(&t, &one, patch_colors[k]);
        }
        oit_operator ops[2] = {smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED), {.kind = OIT_RUN_CURVATURE}};
        ops[1].curvature.unit = p->pixel == 1 ? 0 : 1;
        free(smart_stage_frame(&t, ops, 2, NULL, &image));
        count(&sum, is_near(find(&image, 0, 1, 1)->kappa, p->expected, p->tolerance + 1e-4), p->unsure, p->why);
        smart_stage_drop(&image);
    }
    end(&sum);
    smart_stage_close(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(links),          cmocka_unit_test(boundaries), cmocka_unit_test(fields),
        cmocka_unit_test(weights),        cmocka_unit_test(contrasts),  cmocka_unit_test(profiles),
        cmocka_unit_test(adaptive_alpha), cmocka_unit_test(curvatures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* The truth of smart transparency (reference_smart.h) is held to the pixels worked out by hand (probes_smart.h). The two
 * were written apart from each other and read one thing differently: to the probes a fragment at the frame of the picture
 * has a neighbour missing there, to the reference it has not. So scenes are set into a picture that is a pixel wider on
 * every side, where both mean the same; what the frame itself changes is counted. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

#include "probes_smart.h"
#include "reference_smart.h"

typedef struct board {
    ref_smart_image image;
    int *patch; /* of each fragment */
    int around; /* empty pixels on every side */
    ref_smart_links links;
} board;

/* Orthographic, with window depths that are distances. */
static const double DEPTHS[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, 0, 0, 0, -1, 1};

static double depth_at(const smart_probe_patch *p, int x, int y) {
    return p->z + p->slope_x * (x - p->x0) + p->slope_y * (y - p->y0);
}

static void put(board *b, const smart_probe_patch *p, int which, int x, int y, size_t first, size_t *count) {
    size_t at = *count;
    ref_smart_fragment *f = b->image.fragments;
    double depth = depth_at(p, x, y);
    for (; at > first && f[at - 1].depth > depth; --at) { /* nearer ones come first */
        f[at] = f[at - 1];
        b->patch[at] = b->patch[at - 1];
    }
    memset(&f[at], 0, sizeof f[at]);
    f[at].depth = depth;
    f[at].slope[0] = p->slope_x;
    f[at].slope[1] = p->slope_y;
    memcpy(f[at].normal, p->normal, sizeof f[at].normal);
    memcpy(f[at].uv, p->uv, sizeof f[at].uv);
    memcpy(f[at].color, p->color, sizeof f[at].color);
    f[at].part = (uint32_t)p->part;
    f[at].alpha = p->alpha;
    f[at].kind = p->line ? REF_SMART_LINE : REF_SMART_SURFACE;
    b->patch[at] = which;
    ++*count;
}

static board set_up(int which, int around, ref_smart_criterion criterion) {
    const smart_probe_scene *s = &smart_probe_scenes[which];
    board b = {{s->width + 2 * around, s->height + 2 * around, NULL, NULL}, NULL, around, {0}};
    size_t pixels = (size_t)b.image.width * (size_t)b.image.height, count = 0, most = pixels * (size_t)s->patch_count;
    b.image.start = calloc(pixels + 1, sizeof *b.image.start);
    b.image.fragments = calloc(most, sizeof *b.image.fragments);
    b.patch = calloc(most, sizeof *b.patch);
    assert_true(b.image.start && b.image.fragments && b.patch);
    for (int y = -around, p = 0; y < s->height + around; ++y)
        for (int x = -around; x < s->width + around; ++x, ++p) {
            for (int i = 0; i < s->patch_count; ++i) {
                const smart_probe_patch *patch = &s->patches[i];
                if (x >= patch->x0 && x <= patch->x1 && y >= patch->y0 && y <= patch->y1)
                    put(&b, patch, i, x, y, b.image.start[p], &count);
            }
            b.image.start[p + 1] = count;
        }
    b.links.criterion = criterion == REF_SMART_BY_DEPTH && s->by_uv ? REF_SMART_BY_UV : criterion;
    b.links.depth_weight = b.links.normal_weight = 0.5;
    b.links.radius = s->radius;
    b.links.limit = 0.1;
    memcpy(b.links.projection, DEPTHS, sizeof DEPTHS);
    ref_smart_link(&b.image, &b.links);
    return b;
}

static void take_down(board *b) {
    free(b->image.start);
    free(b->image.fragments);
    free(b->patch);
}

/* The fragment of a patch in a pixel of the scene. */
static ref_smart_fragment *find(const board *b, int patch, int x, int y) {
    for (size_t i = 0; i < ref_smart_count(&b->image, x + b->around, y + b->around); ++i) {
        ref_smart_fragment *f = ref_smart_at(&b->image, x + b->around, y + b->around, i);
        if (b->patch[f - b->image.fragments] == patch)
            return f;
    }
    fail_msg("patch %d has no fragment at %d, %d", patch, x, y);
    return NULL;
}

static int linked_patch(const board *b, int patch, int x, int y, int direction) {
    const ref_smart_fragment *to =
        ref_smart_linked(&b->image, x + b->around, y + b->around, find(b, patch, x, y), direction);
    return to ? b->patch[to - b->image.fragments] : -1;
}

/* What came of a set of probes. */
typedef struct tally {
    const char *name;
    int held, unsure, wrong, frame;
} tally;

static void count(tally *t, bool holds, bool holds_at_frame, int unsure, const char *why) {
    t->held += holds;
    t->unsure += !holds && unsure;
    t->wrong += !holds && !unsure;
    t->frame += holds && !holds_at_frame;
    if (!holds)
        printf("    %s: %s%s\n", t->name, unsure ? "another reading: " : "WRONG: ", why);
}

static void end(const tally *t) {
    printf("    %s: %d hold, %d rest on another reading of a sentence, %d on the frame being a silhouette, %d wrong\n",
           t->name, t->held, t->unsure, t->frame, t->wrong);
    assert_true(t->held > 10);
    assert_int_equal(t->wrong, 0);
}

static bool is_near(double a, double b, double tolerance) {
    return fabs(a - b) <= tolerance;
}

/* ---- links ---- */

static void links(void **state) {
    static const ref_smart_criterion criteria[3] = {REF_SMART_BY_DEPTH, REF_SMART_PUBLISHED, REF_SMART_MURRAY};
    static const char *const names[3] = {"links", "links, published", "links, Murray"};
    (void)state;
    for (int c = 0; c < 3; ++c) {
        tally t = {names[c], 0, 0, 0, 0};
        for (int i = 0; i < SMART_PROBE_LINK_COUNT; ++i) {
            const smart_probe_link *p = &smart_probe_links[i];
            int expected = c == 0 ? p->expected : c == 1 ? p->published : p->murray;
            if (expected == -2 || (c > 0 && smart_probe_scenes[p->scene].by_uv))
                continue;
            board b = set_up(p->scene, 1, criteria[c]);
            bool holds = linked_patch(&b, p->patch, p->x, p->y, p->direction) == expected;
            count(&t, holds, true, p->unsure, p->why);
            take_down(&b);
        }
        end(&t);
    }
}

/* ---- boundary conditions ---- */

static bool has_marks(const ref_smart_fragment *f, const smart_probe_marks *m) {
    return f->beta == m->beta && f->gamma == m->gamma && f->keep_beta == (m->beta_fixed != 0) &&
           f->keep_gamma == (m->gamma_fixed != 0);
}

static void boundaries(void **state) {
    (void)state;
    tally t = {"boundaries", 0, 0, 0, 0};
    for (int i = 0; i < SMART_PROBE_BOUNDARY_COUNT; ++i) {
        const smart_probe_boundary *p = &smart_probe_boundaries[i];
        bool holds[2];
        for (int around = 0; around < 2; ++around) {
            board b = set_up(p->scene, around, REF_SMART_BY_DEPTH);
            ref_smart_begin(&b.image, -1);
            holds[around] = has_marks(find(&b, p->patch, p->x, p->y), &p->expected);
            take_down(&b);
        }
        count(&t, holds[1], holds[0], p->unsure, p->why);
    }
    end(&t);
}

/* ---- fields ---- */

static void start(board *b, int law, double s) {
    ref_smart_begin(&b->image, law == SMART_PROBE_ADAPTIVE ? s : -1);
    size_t all = b->image.start[b->image.width * b->image.height];
    for (size_t i = 0; i < all; ++i) {
        ref_smart_fragment *f = &b->image.fragments[i];
        if (f->kind == REF_SMART_SURFACE && (law == SMART_PROBE_CONSTANT || law == SMART_PROBE_SMART))
            f->base = s;
        if (f->kind == REF_SMART_SURFACE && law == SMART_PROBE_OPAQUE)
            f->base = 1;
    }
}

static double field_of(const smart_probe_field *p, int around, bool published) {
    board b = set_up(p->scene, around, REF_SMART_BY_DEPTH);
    start(&b, p->alpha_law, p->s);
    bool greatest = p->field != SMART_PROBE_ALPHA;
    assert_true(ref_smart_spread(&b.image, p->field, greatest, p->lambda,
                                 published ? REF_SMART_MEAN_OF_FOUR : REF_SMART_EIGHTH, (size_t)p->steps));
    double value = *ref_smart_field(find(&b, p->patch, p->x, p->y), p->field);
    take_down(&b);
    return value;
}

static void fields(void **state) {
    (void)state;
    tally t = {"fields", 0, 0, 0, 0}, published = {"alpha by the mean of four", 0, 0, 0, 0};
    for (int i = 0; i < SMART_PROBE_FIELD_COUNT; ++i) {
        const smart_probe_field *p = &smart_probe_fields[i];
        count(&t, is_near(field_of(p, 1, false), p->expected, p->tolerance),
              is_near(field_of(p, 0, false), p->expected, p->tolerance), p->unsure, p->why);
        if (p->published >= 0 && p->field == SMART_PROBE_ALPHA)
            count(&published, is_near(field_of(p, 1, true), p->published, p->tolerance), true, p->unsure, p->why);
    }
    end(&t);
    end(&published);
}

/* ---- weights of the composite ---- */

/* weights[0]: of the background; weights[1 + i]: of patch i. */
static void weights_of(int scene, int around, int x, int y, int law, double s, double lambda_beta, double lambda_gamma,
                       int steps, double out[6]) {
    board b = set_up(scene, around, REF_SMART_BY_DEPTH);
    double color[3] = {0, 0, 0}, weights[8];
    start(&b, law, s);
    if (law == SMART_PROBE_SMART) {
        ref_smart_spread(&b.image, REF_SMART_BETA, true, lambda_beta, REF_SMART_EIGHTH, (size_t)steps);
        ref_smart_spread(&b.image, REF_SMART_GAMMA, true, lambda_gamma, REF_SMART_EIGHTH, (size_t)steps);
    } else { /* alpha alone */
        for (size_t i = 0; i < b.image.start[b.image.width * b.image.height]; ++i)
            b.image.fragments[i].beta = b.image.fragments[i].gamma = 0;
    }
    memset(out, 0, 6 * sizeof *out);
    ref_smart_compose(&b.image, x + around, y + around, color, weights);
    size_t n = ref_smart_count(&b.image, x + around, y + around);
    for (size_t i = 0; i < n; ++i)
        out[1 + b.patch[ref_smart_at(&b.image, x + around, y + around, i) - b.image.fragments]] += weights[i];
    out[0] = weights[n];
    take_down(&b);
}

static void weights(void **state) {
    (void)state;
    tally t = {"weights", 0, 0, 0, 0};
    for (int i = 0; i < SMART_PROBE_WEIGHT_COUNT; ++i) {
        const smart_probe_weight *p = &smart_probe_weights[i];
        bool holds[2] = {true, true};
        for (int around = 0; around < 2; ++around) {
            double found[6];
            weights_of(p->scene, around, p->x, p->y, p->law, p->s, p->lambda_beta, p->lambda_gamma, p->steps, found);
            for (int k = 0; k < 1 + smart_probe_scenes[p->scene].patch_count && k < 4; ++k)
                holds[around] = holds[around] && is_near(found[k], p->weights[k], p->tolerance);
        }
        count(&t, holds[1], holds[0], p->unsure, p->why);
    }
    end(&t);
}

static void contrasts(void **state) {
    static const int laws[3] = {SMART_PROBE_SMART, SMART_PROBE_CONSTANT, SMART_PROBE_OPAQUE};
    (void)state;
    tally t = {"contrasts", 0, 0, 0, 0};
    for (int i = 0; i < SMART_PROBE_CONTRAST_COUNT; ++i) {
        const smart_probe_contrast *p = &smart_probe_contrasts[i];
        const double expected[3] = {p->smart, p->constant, p->opaque};
        bool holds = true;
        for (int law = 0; law < 3; ++law) {
            double left[6], right[6];
            weights_of(p->scene, 1, p->x0, p->y, laws[law], 0.3, 0.1, 0.2, 20, left);
            weights_of(p->scene, 1, p->x1, p->y, laws[law], 0.3, 0.1, 0.2, 20, right);
            holds = holds && is_near(fabs(left[2] - right[2]), expected[law], 1e-6);
        }
        count(&t, holds, true, 0, p->why);
    }
    end(&t);
}

/* ---- single numbers ---- */

static void profiles_and_adaptive_alpha(void **state) {
    (void)state;
    tally t = {"profiles", 0, 0, 0, 0}, a = {"adaptive alpha", 0, 0, 0, 0};
    for (int i = 0; i < SMART_PROBE_PROFILE_COUNT; ++i) {
        const smart_probe_profile *p = &smart_probe_profiles[i];
        double found = p->equation == 10 ? ref_smart_profile_10(p->u, p->p) : ref_smart_profile_11(p->u, p->p);
        count(&t, is_near(found, p->expected, p->tolerance), true, 0, p->why);
    }
    for (int i = 0; i < SMART_PROBE_ADAPTIVE_COUNT; ++i) {
        const smart_probe_adaptive *p = &smart_probe_adaptives[i];
        count(&a, is_near(ref_smart_adaptive(p->s, (size_t)p->n), p->expected, 1e-6), true, 0, p->why);
    }
    end(&t);
    end(&a);
}

static void composites(void **state) {
    (void)state;
    tally t = {"composites", 0, 0, 0, 0};
    for (int i = 0; i < SMART_PROBE_COMPOSITE_COUNT; ++i) {
        const smart_probe_composite *p = &smart_probe_composites[i];
        ref_smart_fragment list[4];
        size_t runs[2] = {0, (size_t)p->count};
        ref_smart_image image = {1, 1, runs, list};
        double color[3] = {0, 0, 0}, found[5];
        memset(list, 0, sizeof list);
        for (int k = 0; k < p->count; ++k) {
            list[k].base = p->alpha[k];
            list[k].beta = p->beta[k];
            list[k].gamma = p->gamma[k];
        }
        ref_smart_compose(&image, 0, 0, color, found);
        bool holds = is_near(found[p->count], p->background, 1e-9);
        for (int k = 0; k < p->count; ++k)
            holds = holds && is_near(found[k], p->weights[k], 1e-9) && is_near(list[k].opacity, p->hat[k], 1e-9);
        count(&t, holds, true, 0, p->why);
    }
    end(&t);
}

/* The fragment and its four neighbours, of one depth, in a picture of 3 x 3. */
static void curvatures(void **state) {
    static const int places[5] = {4, 3, 5, 1, 7};
    (void)state;
    tally t = {"curvatures", 0, 0, 0, 0};
    for (int i = 0; i < SMART_PROBE_CURVATURE_COUNT; ++i) {
        const smart_probe_curvature *p = &smart_probe_curvatures[i];
        ref_smart_fragment list[9];
        size_t runs[10];
        ref_smart_image image = {3, 3, runs, list};
        ref_smart_view view = {{0}, p->pixel == 1 ? 0.0 : 1.0};
        memcpy(view.projection, DEPTHS, sizeof DEPTHS);
        view.projection[0] = view.projection[5] = 2 / (3 * p->pixel);
        memset(list, 0, sizeof list);
        for (size_t k = 0; k < 10; ++k)
            runs[k] = k;
        for (int k = 0; k < 5; ++k)
            memcpy(list[places[k]].normal, p->normals[k], sizeof p->normals[k]);
        for (int d = 0; d < 4; ++d)
            list[4].link[d] = p->missing >> d & 1 ? -1 : 0;
        count(&t, is_near(ref_smart_kappa(&image, 1, 1, &list[4], &view), p->expected, p->tolerance), true, p->unsure,
              p->why);
    }
    end(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(links),      cmocka_unit_test(boundaries), cmocka_unit_test(fields),
        cmocka_unit_test(weights),    cmocka_unit_test(contrasts),  cmocka_unit_test(profiles_and_adaptive_alpha),
        cmocka_unit_test(composites), cmocka_unit_test(curvatures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

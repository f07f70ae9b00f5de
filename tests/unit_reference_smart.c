/* The double-precision truth of smart transparency and curvature (reference_smart.h) is itself held to what is known
 * without it: closed forms, conservation, ranges, and what the papers' sentences say of planes and spheres. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>

#include <cmocka.h>

#include "reference_smart.h"

/* ---- scenes of planes and spheres, cast without triangles ------------------------------------------------- */

/* A plane z = offset + slope . (x, y) within a rectangle; or a sphere, both of its sides. Eye space, z toward the eye. */
typedef struct shape {
    bool round;
    double center[3], radius; /* or of the plane: middle, half width */
    double slope[2], half_height;
    uint32_t part;
    double color[3], alpha;
} shape;

typedef struct stage {
    int width, height;
    double pixel; /* orthographic: eye units a pixel; perspective: of the plane at distance 1 */
    bool perspective;
    double first, last; /* near and far, distances along the view */
} stage;

static void projection_of(const stage *s, double p[16]) {
    double right = s->pixel * s->width / 2, top = s->pixel * s->height / 2, n = s->first, f = s->last;
    memset(p, 0, 16 * sizeof *p);
    p[0] = 1 / right;
    p[5] = 1 / top;
    if (s->perspective) {
        p[10] = -(f + n) / (f - n);
        p[14] = -2 * f * n / (f - n);
        p[11] = -1;
    } else {
        p[10] = -2 / (f - n);
        p[14] = -(f + n) / (f - n);
        p[15] = 1;
    }
}

static double depth_of(const double p[16], double z) {
    return 0.5 + 0.5 * (p[10] * z + p[14]) / (p[11] * z + p[15]);
}

/* Hits of the ray through a point of the window (in pixels), at most two: where, and the normal toward the eye. */
static int hit_shape(const stage *s, const shape *o, double x, double y, double at[2][3], double normal[2][3]) {
    double sx = (x - s->width / 2.0) * s->pixel, sy = (y - s->height / 2.0) * s->pixel;
    double from[3] = {s->perspective ? 0 : sx, s->perspective ? 0 : sy, 0};
    double way[3] = {s->perspective ? sx : 0, s->perspective ? sy : 0, -1};
    double t[2];
    int hits = 0;
    if (o->round) {
        double off[3] = {from[0] - o->center[0], from[1] - o->center[1], from[2] - o->center[2]};
        double a = ref_smart_dot(way, way), b = ref_smart_dot(off, way),
               c = ref_smart_dot(off, off) - o->radius * o->radius;
        double root = b * b - a * c;
        if (root <= 0)
            return 0;
        t[hits++] = (-b - sqrt(root)) / a;
        t[hits++] = (-b + sqrt(root)) / a;
    } else { /* z - center z - slope . (xy - center xy) = 0 */
        double along = way[2] - o->slope[0] * way[0] - o->slope[1] * way[1];
        double value =
            from[2] - o->center[2] - o->slope[0] * (from[0] - o->center[0]) - o->slope[1] * (from[1] - o->center[1]);
        t[hits++] = -value / along;
    }
    int kept = 0;
    for (int i = 0; i < hits; i++) {
        double *p = at[kept], *n = normal[kept];
        for (int k = 0; k < 3; k++)
            p[k] = from[k] + t[i] * way[k];
        if (!o->round && (fabs(p[0] - o->center[0]) > o->radius || fabs(p[1] - o->center[1]) > o->half_height))
            continue;
        for (int k = 0; k < 3; k++)
            n[k] = o->round ? (p[k] - o->center[k]) / o->radius : k == 2 ? 1 : -o->slope[k];
        double facing = -ref_smart_dot(n, way), length = sqrt(ref_smart_dot(n, n)) * (facing < 0 ? -1 : 1);
        for (int k = 0; k < 3; k++)
            n[k] /= length;
        kept++;
    }
    return kept;
}

/* Slope of the window depth at a hit, of the plane that touches the surface there. */
static double slope_of(const stage *s, const double p[16], const double at[3], const double n[3], int axis) {
    double away = -at[2], w = s->perspective ? away : 1, ends[2];
    for (int side = 0; side < 2; side++) {
        double sx = at[0] / w + (axis == 0 ? (side - 0.5) * s->pixel : 0);
        double sy = at[1] / w + (axis == 1 ? (side - 0.5) * s->pixel : 0);
        double against = ref_smart_dot(n, at), z; /* n . q = n . at on the plane */
        if (s->perspective)
            z = -against / (n[2] - n[0] * sx - n[1] * sy) * -1;
        else
            z = (against - n[0] * sx - n[1] * sy) / n[2];
        ends[side] = depth_of(p, s->perspective ? -fabs(z) : z);
    }
    return ends[1] - ends[0];
}

static int nearer(const void *a, const void *b) {
    const ref_smart_fragment *f = a, *g = b;
    return f->depth < g->depth ? -1 : f->depth > g->depth;
}

static ref_smart_image cast(const stage *s, const shape *shapes, size_t count) {
    ref_smart_image image = {s->width, s->height, NULL, NULL};
    size_t pixels = (size_t)s->width * (size_t)s->height;
    image.start = calloc(pixels + 1, sizeof *image.start);
    image.fragments = calloc(2 * count * pixels, sizeof *image.fragments);
    assert_true(image.start && image.fragments);
    double p[16];
    projection_of(s, p);
    for (int y = 0, pixel = 0; y < s->height; y++)
        for (int x = 0; x < s->width; x++, pixel++) {
            ref_smart_fragment *first = &image.fragments[image.start[pixel]], *f = first;
            for (size_t o = 0; o < count; o++) {
                double at[2][3], normal[2][3];
                int hits = hit_shape(s, &shapes[o], x + 0.5, y + 0.5, at, normal);
                for (int h = 0; h < hits; h++, f++) {
                    f->depth = depth_of(p, at[h][2]);
                    memcpy(f->normal, normal[h], sizeof f->normal);
                    for (int axis = 0; axis < 2; axis++)
                        f->slope[axis] = slope_of(s, p, at[h], normal[h], axis);
                    f->part = shapes[o].part;
                    f->alpha = shapes[o].alpha;
                    memcpy(f->color, shapes[o].color, sizeof f->color);
                }
            }
            qsort(first, (size_t)(f - first), sizeof *first, nearer);
            image.start[pixel + 1] = image.start[pixel] + (size_t)(f - first);
        }
    return image;
}

static void drop(ref_smart_image *image) {
    free(image->start);
    free(image->fragments);
}

static ref_smart_links links_of(const stage *s, double radius) {
    ref_smart_links links = {REF_SMART_BY_DEPTH, 1, 1, radius, 0.05, {0}, false};
    projection_of(s, links.projection);
    return links;
}

static const stage ORTHO = {64, 64, 1.0 / 16, false, 0.5, 20};

static shape square(double x, double y, double z, double half, uint32_t part) {
    shape s = {false, {x, y, z}, half, {0, 0}, half, part, {0.2, 0.4, 0.8}, 0.4};
    return s;
}

/* ---- links ------------------------------------------------------------------------------------------------ */

/* One tilted plane: every fragment has all neighbours, and the link is the only fragment there is. */
static void a_plane_is_linked_everywhere(void **state) {
    (void)state;
    for (int perspective = 0; perspective < 2; perspective++) {
        stage s = ORTHO;
        s.perspective = perspective;
        s.pixel = perspective ? 0.01 : s.pixel;
        shape plane = square(0, 0, -6, 100, 1);
        plane.slope[0] = 0.8;
        plane.slope[1] = -1.1;
        ref_smart_image image = cast(&s, &plane, 1);
        ref_smart_links links = links_of(&s, 1);
        links.limit = 1e-9; /* the prediction is exact */
        ref_smart_link(&image, &links);
        for (size_t i = 0; i < image.start[64 * 64]; i++)
            for (int d = 0; d < 4; d++)
                assert_true(image.fragments[i].no_neighbour[d] || image.fragments[i].link[d] == 0);
        drop(&image);
    }
}

static void links_are_mutual(void **state) {
    (void)state;
    shape shapes[3] = {{true, {0.1, 0, -8}, 1.3, {0, 0}, 0, 1, {1, 0, 0}, 0.4},
                       {true, {-0.4, 0.5, -8.5}, 1.1, {0, 0}, 0, 1, {0, 1, 0}, 0.4},
                       {false, {0, 0, -8.2}, 5, {0.3, 0.2}, 5, 1, {0, 0, 1}, 0.4}};
    ref_smart_image image = cast(&ORTHO, shapes, 3);
    ref_smart_links links = links_of(&ORTHO, 2);
    ref_smart_link(&image, &links);
    size_t joined = 0;
    for (int y = 0; y < 64; y++)
        for (int x = 0; x < 64; x++)
            for (size_t i = 0; i < ref_smart_count(&image, x, y); i++)
                for (int d = 0; d < 4; d++) {
                    const ref_smart_fragment *f = ref_smart_at(&image, x, y, i);
                    const ref_smart_fragment *g = ref_smart_linked(&image, x, y, f, d);
                    if (!g)
                        continue;
                    joined++;
                    assert_int_equal(g->link[d ^ 1], i);
                }
    assert_true(joined > 10000);
    drop(&image);
}

/* One sheet ends where another, far behind it, begins: nothing but the limit keeps them apart. */
static void sheets_behind_one_another_are_not_glued(void **state) {
    (void)state;
    shape shapes[2] = {square(-1, 0, -5, 1, 1), square(1, 0, -9, 1, 1)};
    ref_smart_image image = cast(&ORTHO, shapes, 2);
    ref_smart_links links = links_of(&ORTHO, 3);
    ref_smart_link(&image, &links);
    assert_int_equal(ref_smart_at(&image, 31, 32, 0)->link[REF_SMART_RIGHT], -1);
    assert_int_equal(ref_smart_at(&image, 32, 32, 0)->link[REF_SMART_LEFT], -1);
    links.criterion = REF_SMART_PUBLISHED;
    ref_smart_link(&image, &links);
    assert_int_equal(ref_smart_at(&image, 31, 32, 0)->link[REF_SMART_RIGHT], 0); /* the paper glues them */
    drop(&image);
}

/* ---- boundaries ------------------------------------------------------------------------------------------- */

/* Figure 8: a small square before a large one. */
static void red_blue_and_green_lie_where_figure_8_has_them(void **state) {
    (void)state;
    shape shapes[2] = {square(0, 0, -5, 1, 1), square(0, 0, -9, 50, 2)};
    ref_smart_image image = cast(&ORTHO, shapes, 2);
    ref_smart_links links = links_of(&ORTHO, 10);
    ref_smart_link(&image, &links);
    ref_smart_begin(&image, -1);
    /* The small one covers pixels 16 to 47 in both directions. */
    for (int x = 0; x < 64; x++) {
        bool under = x >= 16 && x < 48, edge = x == 16 || x == 47;
        const ref_smart_fragment *large = ref_smart_at(&image, x, 32, under ? 1 : 0);
        assert_true(large->beta == 0 && large->keep_beta == edge); /* green */
        assert_true(large->gamma == (x == 15 || x == 48 ? 1 : 0)); /* blue */
        assert_true(large->keep_gamma == (x == 15 || x == 48));
        if (under) {
            const ref_smart_fragment *small = ref_smart_at(&image, x, 32, 0);
            assert_true(small->beta == (edge ? 1 : 0) && small->keep_beta == edge && small->gamma == 0); /* red */
        }
    }
    drop(&image);
}

/* Two planes that go through each other swap order; nothing ends there. */
static void surfaces_that_cross_are_not_marked(void **state) {
    (void)state;
    shape shapes[2] = {square(0, 0, -8, 50, 1), square(0, 0, -8, 50, 1)};
    shapes[0].slope[0] = 0.7;
    shapes[1].slope[0] = -0.7;
    ref_smart_image image = cast(&ORTHO, shapes, 2);
    ref_smart_links links = links_of(&ORTHO, 4);
    ref_smart_link(&image, &links);
    ref_smart_begin(&image, -1);
    assert_int_equal(ref_smart_at(&image, 31, 5, 0)->link[REF_SMART_RIGHT], 1); /* they do swap */
    for (size_t i = 0; i < image.start[64 * 64]; i++) {
        const ref_smart_fragment *f = &image.fragments[i];
        assert_true(f->beta == 0 && f->gamma == 0 && !f->keep_beta && !f->keep_gamma);
    }
    drop(&image);
}

static void lines_do_not_count_as_layers(void **state) {
    (void)state;
    shape shapes[2] = {square(0, 0, -5, 1, 1), square(0, 0, -9, 50, 2)};
    ref_smart_image image = cast(&ORTHO, shapes, 2);
    for (size_t i = 0; i < image.start[64 * 64]; i++)
        if (image.fragments[i].part == 1)
            image.fragments[i].kind = REF_SMART_LINE;
    ref_smart_links links = links_of(&ORTHO, 10);
    ref_smart_link(&image, &links);
    ref_smart_begin(&image, 0.7);
    for (size_t i = 0; i < image.start[64 * 64]; i++) {
        const ref_smart_fragment *f = &image.fragments[i];
        assert_true(f->gamma == 0 && f->beta == 0 && !f->keep_beta);
        assert_true(fabs(f->base - (f->kind == REF_SMART_LINE ? f->alpha : 0.7)) < 1e-15);
    }
    drop(&image);
}

/* ---- fields ----------------------------------------------------------------------------------------------- */

/* Equation 6: n layers of equation 5's alpha make s. */
static void adaptive_alpha_makes_one_opacity_of_any_number_of_layers(void **state) {
    (void)state;
    for (size_t n = 1; n <= 500; n++)
        for (double s = 0; s <= 1; s += 0.125) {
            double alpha = ref_smart_adaptive(s, n), sum = 0;
            for (size_t i = 0; i < n; i++)
                sum += pow(1 - alpha, (double)i) * alpha;
            assert_true(fabs(sum - s) < 1e-12);
        }
}

/* A checkerboard of 0 and 1: the worst there is for a diffusion. */
static ref_smart_image checkerboard(ref_smart_links *links) {
    shape plane = square(0, 0, -6, 100, 1);
    ref_smart_image image = cast(&ORTHO, &plane, 1);
    *links = links_of(&ORTHO, 1);
    ref_smart_link(&image, links);
    ref_smart_begin(&image, -1);
    for (int y = 0; y < 64; y++)
        for (int x = 0; x < 64; x++)
            ref_smart_at(&image, x, y, 0)->base = (x + y) % 2;
    return image;
}

static void diffusion_stays_in_range_for_every_lambda(void **state) {
    static const double lambdas[] = {0, 0.1, 0.25, 0.5, 1};
    (void)state;
    for (size_t l = 0; l < 5; l++) {
        ref_smart_links links;
        ref_smart_image image = checkerboard(&links);
        assert_true(ref_smart_spread(&image, REF_SMART_BASE, false, lambdas[l], REF_SMART_EIGHTH, 200));
        double low = 1, high = 0, sum = 0;
        for (size_t i = 0; i < 64 * 64; i++) {
            low = fmin(low, image.fragments[i].base);
            high = fmax(high, image.fragments[i].base);
            sum += image.fragments[i].base;
        }
        assert_true(low >= 0 && high <= 1);
        assert_true(fabs(sum - 64 * 64 / 2) < 1e-6); /* mutual links: what one gives the other gets */
        double step = 0;
        for (size_t i = 1; i < 64; i++)
            step = fmax(step, fabs(image.fragments[i].base - image.fragments[i - 1].base));
        assert_true(l == 0 ? step == 1 : step < 0.02); /* no checkerboard is left, not even along the frame */
        drop(&image);
    }
}

static void the_papers_laplacians_oscillate_and_explode(void **state) {
    (void)state;
    for (int bare = 0; bare < 2; bare++) {
        ref_smart_links links;
        ref_smart_image image = checkerboard(&links);
        assert_true(
            ref_smart_spread(&image, REF_SMART_BASE, false, 1, bare ? REF_SMART_BARE_SUM : REF_SMART_MEAN_OF_FOUR, 20));
        double inside = fabs(ref_smart_at(&image, 32, 32, 0)->base - ref_smart_at(&image, 33, 32, 0)->base);
        assert_true(bare ? inside > 1e6
                         : fabs(inside - 1) < 1e-9); /* the checkerboard for ever, turned over each step */
        drop(&image);
    }
}

/* Equation 9 from one fragment: 1 - lambda times the steps along rows and columns, whatever the number of iterations
 * beyond. */
static void the_greatest_spreads_by_distance(void **state) {
    (void)state;
    ref_smart_links links;
    ref_smart_image image = checkerboard(&links);
    ref_smart_at(&image, 20, 30, 0)->beta = 1;
    ref_smart_at(&image, 20, 30, 0)->keep_beta = true;
    assert_true(ref_smart_spread(&image, REF_SMART_BETA, true, 0.05, REF_SMART_EIGHTH, 30));
    for (int y = 0; y < 64; y++)
        for (int x = 0; x < 64; x++) {
            double expected = fmax(0, 1 - 0.05 * (abs(x - 20) + abs(y - 30)));
            assert_true(fabs(ref_smart_at(&image, x, y, 0)->beta - expected) < 1e-12);
        }
    drop(&image);
}

static void profiles_keep_0_and_1_and_rise(void **state) {
    (void)state;
    for (double p = 0; p < 40; p = p * 2 + 1e-9) {
        assert_true(fabs(ref_smart_profile_10(0, p)) < 1e-12 && fabs(ref_smart_profile_10(1, p) - 1) < 1e-12);
        for (double u = 0; u < 1; u += 1.0 / 64)
            assert_true(ref_smart_profile_10(u, p) < ref_smart_profile_10(u + 1.0 / 64, p));
    }
    assert_true(fabs(ref_smart_profile_10(0.5, 1e-6) - 0.75) < 1e-6); /* the limit, 1 - (1 - u)^2 */
    assert_true(fabs(ref_smart_profile_11(0.25, 0.5) - 0.5) < 1e-15);
}

/* ---- compositing ------------------------------------------------------------------------------------------ */

static void weights_sum_to_one_with_the_background(void **state) {
    (void)state;
    shape shapes[3] = {square(0, 0, -5, 1, 1), square(0.3, 0.3, -6, 1, 2), square(0, 0, -9, 50, 3)};
    ref_smart_image image = cast(&ORTHO, shapes, 3);
    ref_smart_links links = links_of(&ORTHO, 10);
    ref_smart_link(&image, &links);
    ref_smart_begin(&image, 0.6);
    assert_true(ref_smart_spread(&image, REF_SMART_BETA, true, 0.05, REF_SMART_EIGHTH, 20));
    assert_true(ref_smart_spread(&image, REF_SMART_GAMMA, true, 0.2, REF_SMART_EIGHTH, 20));
    for (int y = 0; y < 64; y++)
        for (int x = 0; x < 64; x++) {
            double color[3] = {1, 1, 1}, weights[8], sum = 0;
            ref_smart_compose(&image, x, y, color, weights);
            for (size_t i = 0; i <= ref_smart_count(&image, x, y); i++) {
                assert_true(weights[i] >= 0);
                sum += weights[i];
            }
            assert_true(fabs(sum - 1) < 1e-14);
        }
    drop(&image);
}

/* The thesis of C13 (figure 3): the hidden contour is as weak as behind something opaque where it goes under the other
 * square (T), and as strong as through plain glass inside (X); and beside the crossing there is a halo. */
static void hidden_contours_make_an_xt_junction(void **state) {
    (void)state;
    shape shapes[2] = {square(-0.5, 0.5, -5, 1, 1), square(0.5, -0.5, -9, 1, 2)};
    ref_smart_image image = cast(&ORTHO, shapes, 2);
    ref_smart_links links = links_of(&ORTHO, 10);
    ref_smart_link(&image, &links);
    ref_smart_begin(&image, -1);
    assert_true(ref_smart_spread(&image, REF_SMART_BETA, true, 0.1, REF_SMART_EIGHTH, 20));
    assert_true(ref_smart_spread(&image, REF_SMART_GAMMA, true, 0.2, REF_SMART_EIGHTH, 20));
    /* The one before covers x 8 to 39, y 24 to 55; the one behind x 24 to 55, y 8 to 39: its upper edge, y = 39 against 40,
     * goes in at x = 39 and is hidden from there down to x = 24. */
    double before = 0;
    for (int x = 39; x >= 28; x--) {
        double inside[3] = {1, 1, 1}, outside[3] = {1, 1, 1};
        ref_smart_compose(&image, x, 39, inside, NULL);
        ref_smart_compose(&image, x, 40, outside, NULL);
        double contrast = fabs(inside[0] - outside[0]);
        if (x == 39)
            assert_true(contrast < 1e-12);
        else
            assert_true(contrast > before || 39 - x >= 10); /* rises until beta has run out */
        before = contrast;
    }
    double at_base = 0.6 * 1 * 0.8; /* what comes through, times the edge's full opacity, times 1 - 0.2 */
    assert_true(fabs(before - at_base) < 1e-12);
    double halo[3] = {1, 1, 1}, weights[2]; /* just outside of the one before, the one behind is not there at all */
    ref_smart_compose(&image, 40, 30, halo, weights);
    assert_true(weights[0] == 0 && weights[1] == 1 && halo[0] == 1);
    drop(&image);
}

/* ---- curvature -------------------------------------------------------------------------------------------- */

static void spheres_have_the_curvature_of_spheres(void **state) {
    (void)state;
    for (int setting = 0; setting < 6; setting++) {
        stage s = {96, 96, 1.0 / 24, false, 0.5, 60};
        double away = setting % 3 == 0 ? 4 : setting % 3 == 1 ? 12 : 40;
        s.perspective = setting >= 3;
        s.pixel = s.perspective ? 1.0 / 24 / away : s.pixel;
        shape ball = {true, {0, 0, -away}, 1.5, {0, 0}, 0, 1, {1, 0, 0}, 0.4};
        ref_smart_image image = cast(&s, &ball, 1);
        ref_smart_links links = links_of(&s, 1.5);
        links.limit = 0.5;
        ref_smart_link(&image, &links);
        ref_smart_view view = {{0}, setting % 2 ? 1 : 0.6};
        projection_of(&s, view.projection);
        ref_smart_curve(&image, &view);
        double worst = 0;
        size_t looked_at = 0, missing = 0;
        for (int y = 0; y < 96; y++)
            for (int x = 0; x < 96; x++)
                for (size_t i = 0; i < ref_smart_count(&image, x, y); i++) {
                    const ref_smart_fragment *f = ref_smart_at(&image, x, y, i);
                    bool all = true;
                    for (int d = 0; d < 4; d++)
                        all = all && f->link[d] >= 0;
                    missing += !all;
                    if (!all)
                        assert_true(f->kappa == -1);
                    if (!all || f->normal[2] < 0.3)
                        continue;
                    worst = fmax(worst, fabs(f->kappa - tanh((i == 0 ? -2 : 2) / 1.5 * view.unit)));
                    looked_at++;
                }
        printf("%s, %2g away: kappa off by %.1e over %zu fragments, %zu at edges\n",
               s.perspective ? "perspective" : "parallel", away, worst, looked_at, missing);
        assert_true(looked_at > 5000 && missing > 100);
        assert_true(worst < 0.02); /* differences over two pixels of 1/36 of the radius */
        drop(&image);
    }
}

/* Of a plane nothing bends, however it is tilted; per pixel, a sphere twice as large in the picture bends half as much. */
static void curvature_per_pixel_and_of_planes(void **state) {
    (void)state;
    shape plane = square(0, 0, -9, 50, 1);
    plane.slope[0] = 1.5;
    ref_smart_image image = cast(&ORTHO, &plane, 1);
    ref_smart_links links = links_of(&ORTHO, 10);
    ref_smart_link(&image, &links);
    ref_smart_view view = {{0}, 0};
    projection_of(&ORTHO, view.projection);
    ref_smart_curve(&image, &view);
    assert_true(ref_smart_at(&image, 30, 30, 0)->kappa == 0);
    assert_true(ref_smart_at(&image, 0, 30, 0)->kappa == -1); /* the picture ends there */
    drop(&image);
    for (int size = 1; size <= 2; size++) {
        shape ball = {true, {0, 0, -9}, 0.8 * size, {0, 0}, 0, 1, {1, 0, 0}, 0.4};
        image = cast(&ORTHO, &ball, 1);
        links.limit = 0.5;
        ref_smart_link(&image, &links);
        ref_smart_curve(&image, &view);
        assert_true(fabs(ref_smart_at(&image, 32, 32, 0)->kappa - tanh(-2 / (0.8 * 16 * size))) < 1e-3);
        drop(&image);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plane_is_linked_everywhere),
        cmocka_unit_test(links_are_mutual),
        cmocka_unit_test(sheets_behind_one_another_are_not_glued),
        cmocka_unit_test(red_blue_and_green_lie_where_figure_8_has_them),
        cmocka_unit_test(surfaces_that_cross_are_not_marked),
        cmocka_unit_test(lines_do_not_count_as_layers),
        cmocka_unit_test(adaptive_alpha_makes_one_opacity_of_any_number_of_layers),
        cmocka_unit_test(diffusion_stays_in_range_for_every_lambda),
        cmocka_unit_test(the_papers_laplacians_oscillate_and_explode),
        cmocka_unit_test(the_greatest_spreads_by_distance),
        cmocka_unit_test(profiles_keep_0_and_1_and_rise),
        cmocka_unit_test(weights_sum_to_one_with_the_background),
        cmocka_unit_test(hidden_contours_make_an_xt_junction),
        cmocka_unit_test(spheres_have_the_curvature_of_spheres),
        cmocka_unit_test(curvature_per_pixel_and_of_planes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

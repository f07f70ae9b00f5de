/* gl_contours.c: suggestive contours. The header's picture against reference_smart.h's, and that against a torus, whose
 * curvature toward an eye is known everywhere; none on what is convex. */
#include "smart_stage.h"

enum { SIZE = 192, MOST = 1 << 18 };

static const double RING[2] = {1, 0.4};
static const float WIDTH = 2, LEAST = 1;

static const oit_desc desc = {.color = OIT_COLOR_FLOAT, .operators = OIT_OPERATE_CONTOURS};

static oit_operator contours_of(int iterations) {
    oit_operator op;
    memset(&op, 0, sizeof op);
    op.kind = OIT_RUN_CURVATURE;
    op.curvature.contours = OIT_CONTOURS_SUGGESTIVE;
    op.curvature.contour_width = WIDTH;
    op.curvature.contour_least = LEAST;
    op.curvature.contour_iterations = iterations;
    op.curvature.contour_color[0] = 0.5f;
    return op;
}

/* A frame with contours (NULL: without), and what the reference makes of its fragments. */
static float *draw(smart_stage *t, const oit_operator *contours, ref_smart_image *image) {
    oit_operator ops[2];
    memset(ops, 0, sizeof ops);
    ops[0].kind = OIT_RUN_LINK;
    ops[0].link.radius = (float)t->radius;
    if (contours)
        ops[1] = *contours;
    float *picture = smart_stage_frame(t, ops, contours ? 2 : 1, NULL, image);
    if (image && contours) {
        ref_smart_links links = smart_stage_links(t, &ops[0].link);
        int iterations = contours->curvature.contour_iterations;
        assert_true(ref_smart_contours(image, links.projection, links.radius, (double)WIDTH, (double)LEAST,
                                       iterations < 0 ? 0 : (size_t)iterations));
    }
    return picture;
}

static void add_ring(smart_stage *t, double tilt) {
    const double color[4] = {0.2, 0.6, 0.8, 0.4}, c = cos(tilt), s = sin(tilt);
    const double turn[16] = {1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1};
    oit_scene_camera(smart_stage_clear(t), 4.5, 1.5, 9, 0.36);
    size_t at = smart_stage_sheet(&t->scene, smart_stage_ring, RING, 400, color);
    memcpy(t->scene.truths[at].model, turn, sizeof turn);
    t->radius = 1.4;
}

/* Greatest difference of the picture from algorithm 3 with the reference's contours, and the share above 1/255. */
static double compare(const ref_smart_image *image, const float *picture, double *share) {
    double worst = 0;
    size_t off = 0, pixels = 0;
    for (int y = 0; y < image->height; ++y)
        for (int x = 0; x < image->width; ++x) {
            double color[3] = {1, 1, 1}, apart = 0;
            for (size_t i = 0; i < ref_smart_count(image, x, y); ++i) {
                ref_smart_fragment *f = ref_smart_at(image, x, y, i);
                f->base = f->alpha + (1 - f->alpha) * f->contour;
                f->beta = f->gamma = 0;
                for (int k = 0; k < 3; ++k)
                    f->color[k] += f->contour * ((k == 0 ? 0.5 : 0) - f->color[k]);
            }
            ref_smart_compose(image, x, y, color, NULL);
            for (int k = 0; k < 3; ++k)
                apart = fmax(apart, fabs(color[k] - (double)picture[4 * (y * image->width + x) + k]));
            worst = fmax(worst, apart);
            pixels += ref_smart_count(image, x, y) > 0;
            off += apart > 1.0 / 255;
        }
    *share = (double)off / (double)pixels;
    return worst;
}

/* Smoothed by rows and columns in turn, which is not quite what iterations do: see docs/smart.md. */
static void pictures_are_the_references(void **state) {
    (void)state;
    smart_stage t;
    smart_stage_open(&t, false, SIZE, desc, MOST);
    for (int model = 0; model < 3; ++model)
        for (int iterations = -1; iterations < 64; iterations += 61) {
            ref_smart_image image;
            oit_operator op = contours_of(iterations);
            double share;
            if (model == 0)
                add_ring(&t, -1);
            else
                smart_stage_model(&t, model == 1 ? "klein_bottle" : "torus_knot", 0.3);
            float *picture = draw(&t, &op, &image);
            double worst = compare(&image, picture, &share);
            printf("    model %d, %d iterations: off by %.2g, %.3f %% by more than 1/255\n", model, iterations, worst,
                   100 * share);
            assert_true(share <= (iterations < 0 ? 0 : 0.015));
            free(picture);
            smart_stage_drop(&image);
        }
    smart_stage_close(&t);
}

/* ---- a torus, in closed form ---- */

typedef struct ring_place {
    double turn, tilt;
} ring_place;

/* Where it is, its normal, and the directions around the tube and around the ring. */
static void ring_frame(ring_place p, double at[3], double normal[3], double around[2][3]) {
    const double c = cos(p.turn), s = sin(p.turn), k = cos(p.tilt), l = sin(p.tilt);
    const double frame[4][3] = {{(RING[0] + RING[1] * k) * c, (RING[0] + RING[1] * k) * s, RING[1] * l},
                                {k * c, k * s, l},
                                {-l * c, -l * s, k},
                                {-s, c, 0}};
    memcpy(at, frame[0], sizeof frame[0]);
    memcpy(normal, frame[1], sizeof frame[1]);
    memcpy(around, frame[2], 2 * sizeof frame[2]);
}

/* Euler's formula: principal curvatures are 1/r around the tube and cos(tilt)/(R + r cos(tilt)) around the ring. along:
 * where a small step toward the eye leads; steep: |w| for a unit direction to the eye. */
static double ring_radial(ring_place p, const double eye[3], ring_place *along, double *steep) {
    const double step = 1e-5, bends[2] = {1 / RING[1], cos(p.tilt) / (RING[0] + RING[1] * cos(p.tilt))};
    double at[3], normal[3], around[2][3], v[3], parts[2], length = 0;
    ring_frame(p, at, normal, around);
    for (int k = 0; k < 3; ++k) {
        v[k] = eye[k] - at[k];
        length += v[k] * v[k];
    }
    for (int k = 0; k < 2; ++k)
        parts[k] = ref_smart_dot(v, around[k]);
    double square = parts[0] * parts[0] + parts[1] * parts[1];
    *steep = sqrt(square / length);
    along->tilt = p.tilt + step * parts[0] / sqrt(square) / RING[1];
    along->turn = p.turn + step * parts[1] / sqrt(square) / (RING[0] + RING[1] * cos(p.tilt));
    double radial = (bends[0] * parts[0] * parts[0] + bends[1] * parts[1] * parts[1]) / square;
    return ref_smart_dot(v, normal) < 0 ? -radial : radial;
}

/* By how much it rises along w, per unit of length. */
static double ring_rise(ring_place p, const double eye[3], double *radial, double *steep) {
    ring_place along, further;
    double ignored;
    *radial = ring_radial(p, eye, &along, steep);
    return (ring_radial(along, eye, &further, &ignored) - *radial) / 1e-5;
}

typedef struct ring_fragment {
    double radial, rise, steep;
} ring_fragment;

static ring_fragment on_ring(const smart_stage *t, const ref_smart_image *image, const ref_smart_links *links, int x,
                             int y, const ref_smart_fragment *f) {
    const double *model = t->scene.truths[0].model, *view = t->scene.scene.view;
    double at[3], eye[3], place[3];
    ring_fragment out;
    ref_smart_place(image, links->projection, x, y, f->depth, at);
    for (int k = 0; k < 3; ++k) /* the camera only moves, and the model only turns */
        at[k] -= view[12 + k];
    for (int k = 0; k < 3; ++k) {
        place[k] = at[0] * model[4 * k] + at[1] * model[4 * k + 1] + at[2] * model[4 * k + 2];
        eye[k] = -(view[12] * model[4 * k] + view[13] * model[4 * k + 1] + view[14] * model[4 * k + 2]);
    }
    ring_place p = {atan2(place[1], place[0]), atan2(place[2], hypot(place[0], place[1]) - RING[0])};
    out.rise = ring_rise(p, eye, &out.radial, &out.steep);
    return out;
}

/* Fragments on a dark line have the formula's zero within a pixel and a half; where the formula goes through zero and rises
 * by more than twice the least, between two linked fragments of which neither faces the eye, one of them is on a line. */
static void contours_of_a_torus(void **state) {
    (void)state;
    smart_stage t;
    size_t dark = 0, right = 0, wanted = 0, found = 0;
    smart_stage_open(&t, false, SIZE, desc, MOST);
    for (int view = 0; view < 6; ++view) {
        ref_smart_image image;
        const double tilt = 0.6 + 0.15 * view;
        oit_operator op = contours_of(-1);
        add_ring(&t, tilt);
        free(draw(&t, &op, &image));
        ref_smart_links links = smart_stage_links(&t, &op.link);
        for (int y = 0; y < SIZE; ++y)
            for (int x = 0; x < SIZE; ++x)
                for (size_t i = 0; i < ref_smart_count(&image, x, y); ++i) {
                    const ref_smart_fragment *f = ref_smart_at(&image, x, y, i);
                    ring_fragment own = on_ring(&t, &image, &links, x, y, f);
                    double nearest = HUGE_VAL;
                    for (int d = 0; d < 4; ++d) {
                        const ref_smart_fragment *other = ref_smart_linked(&image, x, y, f, d);
                        int to_x = x, to_y = y;
                        if (!other || !ref_smart_next(&image, &to_x, &to_y, d))
                            continue;
                        ring_fragment next = on_ring(&t, &image, &links, to_x, to_y, other);
                        nearest = fmin(nearest, fabs(own.radial / (own.radial - next.radial)));
                        if (d % 2 == 0 || (own.radial > 0) == (next.radial > 0) || own.steep < 0.5 ||
                            next.steep < 0.5 || fmin(own.rise, next.rise) < 2.2 * (double)LEAST / (t.radius * t.radius))
                            continue;
                        ++wanted;
                        found += fmax(f->contour, other->contour) > 0.25;
                    }
                    if (f->contour > 0.5) {
                        ++dark;
                        right += nearest <= 1.5 && own.rise > 0;
                    }
                }
        smart_stage_drop(&image);
    }
    smart_stage_close(&t);
    printf("    %zu of %zu dark fragments on a contour, %zu of %zu crossings dark\n", right, dark, found, wanted);
    assert_true((double)right >= 0.99 * (double)dark && (double)found >= 0.98 * (double)wanted && dark > 700 &&
                wanted > 400);
}

static double darkest(smart_stage *t, int iterations) {
    ref_smart_image image;
    oit_operator op = contours_of(iterations);
    double most = 0;
    free(draw(t, &op, &image));
    for (size_t i = 0; i < image.start[SIZE * SIZE]; ++i)
        most = fmax(most, image.fragments[i].contour);
    smart_stage_drop(&image);
    return most;
}

/* A ball and a cylinder: the curvature is never below 0, and on the cylinder 0 without rising. */
static void convex_things_have_none(void **state) {
    (void)state;
    const double color[4] = {0.5, 0.5, 0.5, 0.3}, middle[3] = {0, 0, 0}, pipe[4] = {0.5, 1.5, 0, 1};
    smart_stage t;
    smart_stage_open(&t, false, SIZE, desc, MOST);
    for (int iterations = -1; iterations < 64; iterations += 61) {
        oit_scene_camera(smart_stage_clear(&t), 3.2, 1, 6, 0.36);
        oit_scene_ball(&t.scene, middle, 1, 96, 192, color);
        double ball = darkest(&t, iterations);
        oit_scene_camera(smart_stage_clear(&t), 3.2, 1, 6, 0.36);
        smart_stage_sheet(&t.scene, smart_stage_pipe, pipe, 200, color);
        double cylinder = darkest(&t, iterations);
        printf("    darkest of a ball %.3f, of a cylinder %.3f\n", ball, cylinder);
        assert_true(ball == 0 && cylinder == 0);
    }
    smart_stage_close(&t);
}

/* ---- settings ---- */

static double darkness(smart_stage *t, const oit_operator *op) {
    float *picture = draw(t, op, NULL);
    double sum = 0;
    for (int i = 0; i < 4 * SIZE * SIZE; ++i)
        sum += i % 4 < 3 ? 1 - (double)picture[i] : 0;
    free(picture);
    return sum;
}

/* Each in the direction that is written; off, or above all that there is: to the bit as without. */
static void settings_do_what_they_say(void **state) {
    (void)state;
    smart_stage t;
    smart_stage_open(&t, false, SIZE, desc, MOST);
    add_ring(&t, -1);
    oit_operator op = contours_of(20), off = op, none = op, wide = op, faint = op, red = op;
    off.curvature.contours = OIT_CONTOURS_NONE;
    none.curvature.contour_least = 1e6f;
    wide.curvature.contour_width = 3;
    faint.curvature.contour_least = 4;
    red.curvature.contour_color[0] = 1;
    double plain = darkness(&t, NULL), usual = darkness(&t, &op);
    assert_true(darkness(&t, &off) == plain && darkness(&t, &none) == plain);
    assert_true(usual > plain && darkness(&t, &wide) > usual);
    assert_true(darkness(&t, &faint) < usual && darkness(&t, &faint) > plain && darkness(&t, &red) < usual);
    smart_stage_close(&t);
}

/* Molecules in metres, and galaxies: nothing but the unit of length differs, by a power of two. */
static void units_of_length_change_nothing(void **state) {
    static const double scales[2] = {0x1p-34, 0x1p60};
    (void)state;
    smart_stage t;
    smart_stage_open(&t, false, SIZE, desc, MOST);
    for (int i = 0; i < 2; ++i) {
        const double scale = scales[i];
        const oit_operator op = contours_of(20);
        double worst = 0;
        add_ring(&t, -1);
        float *plain = draw(&t, NULL, NULL), *one = draw(&t, &op, NULL);
        assert_memory_not_equal(plain, one, 4 * SIZE * SIZE * sizeof(float));
        t.radius *= scale;
        t.scene.scene.projection[14] *= scale;
        for (int k = 0; k < 3; ++k)
            t.scene.scene.view[12 + k] *= scale;
        for (int k = 0; k < 12; ++k)
            t.scene.truths[0].model[k] *= scale;
        float *other = draw(&t, &op, NULL);
        for (int k = 0; k < 4 * SIZE * SIZE; ++k)
            worst = fmax(worst, fabs((double)one[k] - (double)other[k]));
        printf("    %g: %.2g\n", scale, worst);
        assert_true(worst <= 1.0 / 255);
        free(plain), free(one), free(other);
    }
    smart_stage_close(&t);
}

/* Run twice in a frame: as asked for last. Before contours opaque shades, which may not stay either. */
static void the_last_run_counts(void **state) {
    (void)state;
    smart_stage t;
    smart_stage_open(&t, false, SIZE, desc, MOST);
    add_ring(&t, -1);
    oit_operator ops[4] = {
        {.kind = OIT_RUN_LINK}, {.kind = OIT_RUN_CURVATURE}, contours_of(20), {.kind = OIT_RUN_CURVATURE}};
    ops[0].link.radius = (float)t.radius;
    ops[1].curvature.shade = OIT_SHADE_CONVEX;
    float *plain = draw(&t, NULL, NULL), *lines = draw(&t, &ops[2], NULL);
    float *both = smart_stage_frame(&t, ops, 3, NULL, NULL), *neither = smart_stage_frame(&t, ops, 4, NULL, NULL);
    assert_memory_not_equal(plain, lines, 4 * SIZE * SIZE * sizeof(float));
    assert_memory_equal(both, lines, 4 * SIZE * SIZE * sizeof(float));
    assert_memory_equal(neither, plain, 4 * SIZE * SIZE * sizeof(float));
    free(plain), free(lines), free(both), free(neither);
    smart_stage_close(&t);
}

static void bad_settings_are_refused(void **state) {
    (void)state;
    smart_stage t;
    const oit_desc without = {.operators = OIT_OPERATE_CURVATURE};
    for (int chosen = 0; chosen < 2; ++chosen) {
        smart_stage_open(&t, false, SIZE, chosen ? desc : without, MOST);
        add_ring(&t, -1);
        oit_frame frame = oit_scene_frame(&t.scene, t.set.framebuffer);
        oit_operator link = {.kind = OIT_RUN_LINK}, ops[5];
        oit_pass pass;
        for (int k = 0; k < 16; ++k)
            frame.projection[k] = (float)t.scene.scene.projection[k];
        for (int i = 0; i < 5; ++i)
            ops[i] = contours_of(i == 0 ? 65534 : 1);
        ops[1].curvature.contour_width = -1;
        ops[2].curvature.contour_least = NAN;
        ops[3].curvature.contour_color[2] = INFINITY;
        ops[4].curvature.contours = (oit_contours)7;
        oit_scene_expect(oit_begin(t.set.oit, &frame), "oit_begin");
        while (oit_next_pass(t.set.oit, &pass))
            smart_stage_draw(&t.scene, t.set.oit, &pass, NULL);
        oit_scene_expect(oit_run(t.set.oit, &link), "oit_run");
        t.set.quiet = true;
        for (int i = 0; i < 5; ++i)
            assert_int_equal(oit_run(t.set.oit, &ops[i]), OIT_INVALID_ARGUMENT);
        oit_operator good = contours_of(1);
        assert_int_equal(oit_run(t.set.oit, &good), chosen ? OIT_OK : OIT_INVALID_ARGUMENT);
        oit_scene_expect(oit_compose(t.set.oit), "oit_compose");
        oit_scene_expect(oit_end(t.set.oit), "oit_end");
        smart_stage_close(&t);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_the_references),    cmocka_unit_test(contours_of_a_torus),
        cmocka_unit_test(convex_things_have_none),        cmocka_unit_test(settings_do_what_they_say),
        cmocka_unit_test(units_of_length_change_nothing), cmocka_unit_test(the_last_run_counts),
        cmocka_unit_test(bad_settings_are_refused),
    };
    if (getenv("GLASSINE_TEST")) /* one of them */
        cmocka_set_test_filter(getenv("GLASSINE_TEST"));
    return cmocka_run_group_tests(tests, NULL, NULL);
}

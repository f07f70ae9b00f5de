/* gl_smart_frames.c: whole pictures of smart transparency. How much contrast each law leaves to the silhouettes of each
 * layer, a proxy for what people were asked in the papers; and how much a picture changes from frame to frame of an orbit,
 * against the same frames by reference_smart.h on fragments in double, which share nothing with the header. */
#include "smart_truth.h"

/* ---- fragments in double ---- */

typedef struct corner {
    double x, y, depth, w, normal[3]; /* of the window; w of the clip space */
} corner;

typedef struct cast {
    ref_smart_fragment *fragments;
    size_t *pixel; /* of each */
    size_t count, room;
    int width, height;
} cast;

static void transform(const double m[16], const double v[4], double out[4]) {
    for (int row = 0; row < 4; ++row)
        out[row] = m[row] * v[0] + m[4 + row] * v[1] + m[8 + row] * v[2] + m[12 + row] * v[3];
}

static corner corner_of(const oit_scene *s, size_t object, uint32_t vertex) {
    const float *p = s->truths[object].positions + 3 * (size_t)vertex,
                *n = s->objects[object].normals + 3 * (size_t)vertex;
    const double place[4] = {(double)p[0], (double)p[1], (double)p[2], 1};
    const double direction[4] = {(double)n[0], (double)n[1], (double)n[2], 0};
    double model_view[16], eye[4], clip[4], turned[4];
    harness_multiply(s->scene.view, s->truths[object].model, model_view);
    transform(model_view, place, eye);
    transform(model_view, direction, turned);
    transform(s->scene.projection, eye, clip);
    corner c = {(0.5 + 0.5 * clip[0] / clip[3]) * s->scene.width,
                (0.5 + 0.5 * clip[1] / clip[3]) * s->scene.height,
                0.5 + 0.5 * clip[2] / clip[3],
                clip[3],
                {turned[0], turned[1], turned[2]}};
    return c;
}

/* Twice the area to the left of an edge, the same but for its sign from both of its ends. */
static double side(const corner *a, const corner *b, double x, double y) {
    bool turn = a->x > b->x || (a->x == b->x && a->y > b->y);
    const corner *p = turn ? b : a, *q = turn ? a : b;
    double area = (q->x - p->x) * (y - p->y) - (q->y - p->y) * (x - p->x);
    return turn ? -area : area;
}

static void add_fragment(cast *c, const oit_scene *s, size_t object, const corner t[3], const double area[3], int x,
                         int y) {
    if (c->count == c->room) {
        c->room = c->room ? 2 * c->room : 4096;
        c->fragments = realloc(c->fragments, c->room * sizeof *c->fragments);
        c->pixel = realloc(c->pixel, c->room * sizeof *c->pixel);
    }
    ref_smart_fragment *f = &c->fragments[c->count];
    double all = area[0] + area[1] + area[2], size = 0;
    memset(f, 0, sizeof *f);
    for (int k = 0; k < 3; ++k) {
        const corner *a = &t[(k + 1) % 3], *b = &t[(k + 2) % 3];
        f->depth += area[k] / all * t[k].depth;
        f->slope[0] -= (b->y - a->y) / all * t[k].depth;
        f->slope[1] += (b->x - a->x) / all * t[k].depth;
        for (int i = 0; i < 3; ++i) /* in perspective */
            f->normal[i] += area[k] / t[k].w * t[k].normal[i];
    }
    size = sqrt(ref_smart_dot(f->normal, f->normal));
    for (int i = 0; i < 3; ++i)
        f->normal[i] /= size > 0 ? size : 1;
    memcpy(f->color, s->truths[object].color, sizeof f->color);
    f->alpha = s->truths[object].alpha;
    f->part = s->objects[object].part;
    c->pixel[c->count++] = (size_t)(y * c->width + x);
}

static void add_triangle(cast *c, const oit_scene *s, size_t object, const corner t[3]) {
    double left = fmin(t[0].x, fmin(t[1].x, t[2].x)), right = fmax(t[0].x, fmax(t[1].x, t[2].x));
    double bottom = fmin(t[0].y, fmin(t[1].y, t[2].y)), top = fmax(t[0].y, fmax(t[1].y, t[2].y));
    for (int y = (int)fmax(floor(bottom), 0); y < c->height && y <= top; ++y)
        for (int x = (int)fmax(floor(left), 0); x < c->width && x <= right; ++x) {
            double area[3];
            int inside = 0;
            for (int k = 0; k < 3; ++k) {
                area[k] = side(&t[(k + 1) % 3], &t[(k + 2) % 3], x + 0.5, y + 0.5);
                inside += area[k] > 0 ? 1 : -1;
            }
            if (inside == 3 || inside == -3)
                add_fragment(c, s, object, t, area, x, y);
        }
}

/* All fragments of the scene, sorted from the eye on. */
static ref_smart_image cast_scene(const oit_scene *s) {
    cast c = {NULL, NULL, 0, 0, s->scene.width, s->scene.height};
    for (size_t i = 0; i < s->count; ++i)
        for (size_t k = 0; k < s->truths[i].triangle_count; ++k) {
            corner t[3];
            for (size_t n = 0; n < 3; ++n)
                t[n] = corner_of(s, i, s->objects[i].indices[3 * k + n]);
            add_triangle(&c, s, i, t);
        }
    size_t pixels = (size_t)c.width * (size_t)c.height;
    ref_smart_image image = {c.width, c.height, calloc(pixels + 1, sizeof(size_t)),
                             calloc(c.count + 1, sizeof *image.fragments)};
    size_t *ends = calloc(pixels + 1, sizeof *ends);
    for (size_t i = 0; i < c.count; ++i)
        ++image.start[c.pixel[i] + 1];
    for (size_t p = 0; p < pixels; ++p)
        image.start[p + 1] += image.start[p];
    memcpy(ends, image.start, (pixels + 1) * sizeof *ends);
    for (size_t i = 0; i < c.count; ++i) {
        size_t at = ends[c.pixel[i]]++;
        for (; at > image.start[c.pixel[i]] && image.fragments[at - 1].depth > c.fragments[i].depth; --at)
            image.fragments[at] = image.fragments[at - 1];
        image.fragments[at] = c.fragments[i];
    }
    free(ends);
    free(c.fragments);
    free(c.pixel);
    return image;
}

/* ---- an orbit ---- */

enum { WIDTH = 60, HEIGHT = 45, FRAMES = 120 };

/* The picture of the same operators in double, four numbers a pixel. */
static float *picture_in_double(const smart_stage *t, const oit_operator ops[3]) {
    ref_smart_image image = cast_scene(&t->scene);
    ref_smart_links links = smart_stage_links(t, &ops[0].link);
    float *picture = calloc(4 * WIDTH * HEIGHT, sizeof *picture);
    ref_smart_link(&image, &links);
    smart_truth_solve(&image, links.projection, &ops[1].law, &ops[2].smart);
    for (int y = 0; y < HEIGHT; ++y)
        for (int x = 0; x < WIDTH; ++x) {
            double color[3] = {1, 1, 1};
            ref_smart_compose(&image, x, y, color, NULL);
            for (int k = 0; k < 3; ++k)
                picture[4 * (y * WIDTH + x) + k] = (float)color[k];
        }
    smart_stage_drop(&image);
    return picture;
}

/* Root of the mean square over pixels and channels. */
static double difference(const float *a, const float *b) {
    double sum = 0;
    for (int p = 0; p < WIDTH * HEIGHT; ++p)
        for (int k = 0; k < 3; ++k)
            sum += ((double)a[4 * p + k] - (double)b[4 * p + k]) * ((double)a[4 * p + k] - (double)b[4 * p + k]);
    return sqrt(sum / (3 * WIDTH * HEIGHT));
}

static void orbits_are_as_steady_as_the_truth(void **state) {
    static const char *const names[3] = {"stream_surface", "klein_bottle", "cube_and_sphere"};
    static const double center[3] = {0, 0, 0};
    smart_stage t;
    (void)state;
    smart_stage_open_wide(&t, false, WIDTH, HEIGHT, smart_truth_desc, 1 << 15);
    for (int m = 0; m < 3; ++m) {
        float *pictures[2][2] = {{NULL, NULL}, {NULL, NULL}}; /* the header's and the truth's, of two frames */
        double change[2] = {0, 0}, worst[2] = {0, 0}, apart = 0, highest = 0;
        smart_stage_model(&t, names[m], 0.3);
        const oit_operator ops[3] = {smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED),
                                     smart_truth_law(OIT_LAW_ADAPTIVE, 0.5f), smart_truth_smart(0, 0)};
        for (int frame = 0; frame <= FRAMES; ++frame) {
            float **now = pictures[frame & 1], **before = pictures[!(frame & 1)];
            now[0] = smart_stage_frame(&t, ops, 3, NULL, NULL);
            now[1] = picture_in_double(&t, ops);
            apart += difference(now[0], now[1]) / (FRAMES + 1);
            double steps[2] = {0, 0};
            for (int k = 0; k < 2 && frame > 0; ++k) {
                steps[k] = difference(now[k], before[k]);
                change[k] += steps[k] / FRAMES;
                worst[k] = fmax(worst[k], steps[k]);
                free(before[k]);
            }
            highest = frame ? fmax(highest, steps[0] / steps[1]) : 0;
            smart_stage_turn(&t, center, 6.28318530717958648 / FRAMES);
        }
        printf(
            "    %-16s change a frame %.4f, of the truth %.4f; at most %.4f and %.4f; ratio at most %.3f; apart %.4f\n",
            names[m], change[0], change[1], worst[0], worst[1], highest, apart);
        assert_true(change[0] <= 1.2 * change[1] && worst[0] <= 1.2 * worst[1] && highest <= 1.2);
        assert_true(change[1] > 0.01 && apart < 0.05); /* it does turn, and they see the same */
        for (int k = 0; k < 2; ++k)
            free(pictures[FRAMES & 1][k]);
    }
    smart_stage_close(&t);
}

/* ---- contrast of silhouettes ---- */

enum { LAWS = 5, LAYERS = 4, VIEWS = 4, SIDE = 120 };

typedef struct contrast {
    double sum[LAWS][LAYERS];
    size_t count[LAYERS];
} contrast;

static double step_between(const float *picture, int x, int y, int to_x, int to_y) {
    const float *a = &picture[4 * (y * SIDE + x)], *b = &picture[4 * (to_y * SIDE + to_x)];
    double sum = 0;
    for (int k = 0; k < 3; ++k)
        sum += fabs((double)a[k] - (double)b[k]) / 3;
    return sum;
}

/* Between each fragment with a missing neighbour and the pixel where it is missing: how far the picture's colours are
 * apart, by the layer that ends there. */
static void measure(const ref_smart_image *image, float *const pictures[LAWS], contrast *c) {
    SMART_TRUTH_EACH(image, x, y, i, f)
    for (int d = 0; d < 4; ++d) {
        int to_x = x, to_y = y, layer = i < LAYERS ? (int)i : LAYERS - 1;
        if (f->link[d] >= 0 || !ref_smart_next(image, &to_x, &to_y, d))
            continue;
        for (int law = 0; law < LAWS; ++law)
            c->sum[law][layer] += step_between(pictures[law], x, y, to_x, to_y);
        ++c->count[layer];
    }
}

/* The paper had people judge which surface is before which, and follow contours. What is measured here is but how strong
 * contours are in the picture; with halos that includes what the halo takes away beside them. */
static void hidden_silhouettes_have_most_contrast_by_smart(void **state) {
    static const char *const names[] = {"stream_surface", "klein_bottle", "cube_and_sphere", "cylinders"};
    static const char *const laws[LAWS] = {"opaque", "constant", "adaptive", "angle", "smart"};
    static const double center[3] = {0, 0, 0};
    smart_stage t;
    (void)state;
    smart_stage_open(&t, false, SIDE, smart_truth_desc, 1 << 17);
    t.light[0] = t.light[2] =
        1; /* without, all of a surface has one colour, and adaptive shows of it what opaque does */
    for (int m = 0; m < 4; ++m) {
        contrast c;
        memset(&c, 0, sizeof c);
        smart_stage_model(&t, names[m], 0.3);
        const oit_operator link = smart_truth_link(&t, OIT_LINK_DEPTH, OIT_SEARCH_WINDOWED);
        for (int view = 0; view < VIEWS; ++view) {
            float *pictures[LAWS];
            ref_smart_image image;
            for (int law = 0; law < LAWS; ++law) {
                static const oit_law_kind kinds[LAWS] = {OIT_LAW_CONSTANT, OIT_LAW_CONSTANT, OIT_LAW_ADAPTIVE,
                                                         OIT_LAW_ANGLE, OIT_LAW_ADAPTIVE};
                const oit_operator ops[3] = {link, smart_truth_law(kinds[law], law ? 0.4f : 1),
                                             smart_truth_smart(0, 0)};
                pictures[law] = smart_stage_frame(&t, ops, law == 4 ? 3 : 2, NULL, law ? NULL : &image);
            }
            measure(&image, pictures, &c);
            for (int law = 0; law < LAWS; ++law)
                free(pictures[law]);
            smart_stage_drop(&image);
            smart_stage_turn(&t, center, 6.28318530717958648 / VIEWS);
        }
        printf("    %s: contrast of silhouettes of layer 1, 2, 3, beyond (a proxy)\n", names[m]);
        double hidden[LAWS] = {0};
        size_t count = c.count[1] + c.count[2] + c.count[3];
        for (int law = 0; law < LAWS; ++law) {
            printf("        %-9s", laws[law]);
            for (int layer = 0; layer < LAYERS; ++layer)
                printf(" %.4f", c.sum[law][layer] / (double)(c.count[layer] ? c.count[layer] : 1));
            hidden[law] = (c.sum[law][1] + c.sum[law][2] + c.sum[law][3]) / (double)count;
            printf("   hidden %.4f\n", hidden[law]);
        }
        assert_true(count > 500);
        for (int law = 1; law < 4; ++law)
            assert_true(hidden[4] > hidden[law]);
    }
    smart_stage_close(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orbits_are_as_steady_as_the_truth),
        cmocka_unit_test(hidden_silhouettes_have_most_contrast_by_smart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

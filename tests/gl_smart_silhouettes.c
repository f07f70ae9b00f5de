/* gl_smart_silhouettes.c: what two headers make of one thing. Fragments that oit_buffers.h marks as silhouettes (a link is
 * missing) against the silhouettes and borders that silhouette.h finds on the same mesh from the same eye, hidden ones as
 * well: each within a pixel of one of the others. */
#include "smart_stage.h"

#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

enum { SIZE = 160, MOST = 1 << 17 };

typedef struct place { /* on a silhouette: pixels, distance along the view */
    double x, y, away;
    uint32_t part;
    bool is_steep; /* a fragment beside or on a face whose depth changes within a pixel by more than links' limit */
} place;

typedef struct score {
    size_t marked, justified, steep, places, found, left_out;
} score;

/* ---- silhouettes of the mesh ---- */

static bool to_window(const double model_view[16], const double projection[16], const float *p, place *out) {
    double eye[4], clip[4];
    for (int row = 0; row < 4; ++row)
        eye[row] = model_view[row] * (double)p[0] + model_view[4 + row] * (double)p[1] +
                   model_view[8 + row] * (double)p[2] + model_view[12 + row];
    for (int row = 0; row < 4; ++row)
        clip[row] = projection[row] * eye[0] + projection[4 + row] * eye[1] + projection[8 + row] * eye[2] +
                    projection[12 + row] * eye[3];
    out->x = (0.5 + 0.5 * clip[0] / clip[3]) * SIZE;
    out->y = (0.5 + 0.5 * clip[1] / clip[3]) * SIZE;
    out->away = -eye[2];
    return clip[3] > 0;
}

/* Places along an edge, four to a pixel. */
static size_t walk(const place *from, const place *to, place *out, size_t room) {
    size_t steps = 1 + (size_t)(4 * hypot(to->x - from->x, to->y - from->y));
    for (size_t i = 0; i < steps && i < room; ++i) {
        double t = (double)i / (double)steps;
        out[i] = *from;
        out[i].x += t * (to->x - from->x);
        out[i].y += t * (to->y - from->y);
        out[i].away += t * (to->away - from->away);
    }
    assert_true(steps <= room);
    return steps;
}

static size_t silhouettes_of(const smart_stage *t, size_t object, place *out, size_t room) {
    const ref_object *o = &t->scene.truths[object];
    sil_mesh_desc desc;
    sil_view view;
    double model_view[16];
    float turn[16], projection[16];
    size_t count = 0;
    memset(&desc, 0, sizeof desc);
    desc.positions = o->positions;
    desc.vertex_count = o->vertex_count;
    desc.indices = o->indices;
    desc.index_count = 3 * o->triangle_count;
    sil_mesh *mesh = sil_mesh_create(&desc, NULL);
    assert_non_null(mesh);
    harness_multiply(t->scene.scene.view, o->model, model_view);
    for (int k = 0; k < 16; ++k) {
        turn[k] = (float)model_view[k];
        projection[k] = (float)t->scene.scene.projection[k];
    }
    assert_int_equal(sil_view_from_matrices(turn, projection, &view), SIL_OK);
    size_t all = sil_mesh_get_info(mesh).edge_count;
    sil_edge *edges = malloc((all + 1) * sizeof *edges);
    size_t found = sil_extract(mesh, NULL, &view, SIL_SILHOUETTE | SIL_BOUNDARY, edges, all);
    for (size_t i = 0; i < found; ++i) {
        place ends[2];
        if (!to_window(model_view, t->scene.scene.projection, o->positions + 3 * edges[i].a, &ends[0]) ||
            !to_window(model_view, t->scene.scene.projection, o->positions + 3 * edges[i].b, &ends[1]))
            continue;
        ends[0].part = t->scene.objects[object].part;
        count += walk(&ends[0], &ends[1], out + count, room - count);
    }
    free(edges);
    sil_mesh_destroy(mesh);
    return count;
}

/* ---- comparison ---- */

/* In one pixel or in two side by side, also at a corner. */
static bool is_same(const place *p, const place *q, double deep) {
    return p->part == q->part && fabs(floor(p->x) - floor(q->x)) <= 1 && fabs(floor(p->y) - floor(q->y)) <= 1 &&
           fabs(p->away - q->away) <= deep;
}

static bool near_any(const place *p, const place *list, size_t count, double deep) {
    for (size_t i = 0; i < count; ++i)
        if (is_same(p, &list[i], deep))
            return true;
    return false;
}

static bool is_steep(const ref_smart_links *links, const ref_smart_fragment *f) {
    double away = ref_smart_distance(links->projection, f->depth);
    for (int axis = 0; axis < 2; ++axis)
        if (fabs(ref_smart_distance(links->projection, f->depth + f->slope[axis]) - away) >
            links->limit * links->radius)
            return true;
    return false;
}

/* Itself, or one of its part where its link is missing. */
static bool meets_steep(const ref_smart_image *image, const ref_smart_links *links, int x, int y,
                        const ref_smart_fragment *f) {
    for (int d = 0; d < 4; ++d) {
        int to_x = x, to_y = y;
        if (f->link[d] >= 0 || !ref_smart_next(image, &to_x, &to_y, d))
            continue;
        for (size_t i = 0; i < ref_smart_count(image, to_x, to_y); ++i) {
            const ref_smart_fragment *g = ref_smart_at(image, to_x, to_y, i);
            if (g->part == f->part && is_steep(links, g))
                return true;
        }
    }
    return is_steep(links, f);
}

/* Fragments as places: those marked first; the number of those. */
static size_t places_of(const ref_smart_image *image, const ref_smart_links *links, place *out, size_t *all) {
    size_t marked = 0;
    *all = 0;
    for (int pass = 0; pass < 2; ++pass)
        for (int y = 0; y < image->height; ++y)
            for (int x = 0; x < image->width; ++x)
                for (size_t i = 0; i < ref_smart_count(image, x, y); ++i) {
                    const ref_smart_fragment *f = ref_smart_at(image, x, y, i);
                    if ((f->beta < 1) != (pass == 1))
                        continue;
                    assert_true(*all < MOST);
                    place p = {x + 0.5, y + 0.5, ref_smart_distance(links->projection, f->depth), f->part, false};
                    p.is_steep = meets_steep(image, links, x, y, f);
                    out[(*all)++] = p;
                    marked += pass == 0;
                }
    return marked;
}

/* Left out: faces so steep that their depth changes within a pixel by more than the limit, whose creases look to depth
 * like silhouettes; and silhouettes of what is so thin, or so near to the frame, that no middle of a pixel beside them is covered. */
static void add_score(smart_stage *t, score *sum) {
    static place lines[MOST], fragments[MOST];
    oit_operator ops[2];
    ref_smart_image image;
    size_t count = 0, all;
    memset(ops, 0, sizeof ops);
    ops[0].kind = OIT_RUN_LINK;
    ops[0].link.radius = (float)t->radius;
    ops[1].kind = OIT_RUN_SMART;
    ops[1].smart.beta.iterations = ops[1].smart.gamma.iterations = ops[1].smart.base.iterations = -1;
    free(smart_stage_frame(t, ops, 2, NULL, &image));
    ref_smart_links links = smart_stage_links(t, &ops[0].link);
    for (size_t i = 0; i < t->scene.count; ++i)
        count += silhouettes_of(t, i, lines + count, MOST - count);
    size_t marked = places_of(&image, &links, fragments, &all);
    const double deep = 0.5 * t->radius; /* along the view a surface is steep beside its silhouette */
    for (size_t i = 0; i < marked; ++i) {
        if (near_any(&fragments[i], lines, count, deep))
            ++sum->justified;
        else
            sum->steep += fragments[i].is_steep;
    }
    sum->marked += marked;
    for (size_t i = 0; i < count; ++i) {
        bool found = near_any(&lines[i], fragments, marked, deep);
        bool drawn = found || near_any(&lines[i], fragments, all, deep);
        sum->found += found;
        sum->left_out += !drawn;
    }
    sum->places += count;
    smart_stage_drop(&image);
}

/* About the upright axis through the middle of what is looked at. */
static void turn_about(smart_stage *t, double degrees) {
    const double a = degrees * 3.14159265358979324 / 180, c = cos(a), s = sin(a);
    const double turn[16] = {c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1};
    double kept[16];
    for (size_t i = 0; i < t->scene.count; ++i) {
        memcpy(kept, t->scene.truths[i].model, sizeof kept);
        harness_multiply(turn, kept, t->scene.truths[i].model);
    }
}

static void marks_lie_on_silhouettes(void **state) {
    (void)state;
    static const char *const names[] = {"squares",      "cylinders",      "cube_and_sphere",
                                        "klein_bottle", "stream_surface", "shells"};
    const oit_desc desc = {.operators = OIT_OPERATE_SMART};
    smart_stage t;
    smart_stage_open(&t, false, SIZE, desc, MOST);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
        score s = {0, 0, 0, 0, 0, 0};
        for (int view = 0; view < 4; ++view) {
            smart_stage_model(&t, names[i], 0.3);
            turn_about(&t, 37.0 * view);
            add_score(&t, &s);
        }
        double precision = (double)s.justified / (double)(s.marked - s.steep);
        double recall = (double)s.found / (double)(s.places - s.left_out), out = (double)s.left_out / (double)s.places;
        double steep = (double)s.steep / (double)s.marked;
        printf(
            "    %-16s precision %.4f of %zu marked (%.2f %% too steep), recall %.4f of %zu places (%.2f %% too thin)\n",
            names[i], precision, s.marked, 100 * steep, recall, s.places, 100 * out);
        /* The bottle runs through itself: near its cusps two of its sheets are nearer to each other than the limit. */
        double least = strcmp(names[i], "klein_bottle") == 0 ? 0.96 : 0.98;
        assert_true(precision >= 0.98 && recall >= least && out <= 0.1 && steep <= 0.1);
    }
    smart_stage_close(&t);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(marks_lie_on_silhouettes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

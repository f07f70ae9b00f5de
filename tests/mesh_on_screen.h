/* mesh_on_screen.h: a mesh as it lies on the screen, walked along its surface: what is near a place of the window without
 * leaving the surface, and which edges are lines there by silhouette.h. For tests of what fragments know of surfaces. */
#ifndef GLASSINE_TESTS_MESH_ON_SCREEN_H
#define GLASSINE_TESTS_MESH_ON_SCREEN_H

#include "smart_stage.h"

#define SIL_STATIC
#define SILHOUETTE_IMPLEMENTATION
#include "silhouette.h"

#define MESH_FAR 2.0 /* pixels that are walked from a place */

typedef struct mesh_spot { /* pixels, and distance along the view */
    double x, y, away;
} mesh_spot;

typedef struct mesh_side { /* of a triangle; those between the same two places stand together */
    uint32_t low, high, triangle;
    bool rises;
} mesh_side;

typedef struct mesh_fragment {
    mesh_spot at;
    const ref_smart_fragment *from;
    int x, y;
    uint32_t triangle, next; /* that it lies on, UINT32_MAX: none was found; the next fragment there, or UINT32_MAX */
    bool marked;
} mesh_fragment;

typedef struct mesh_on_screen {
    const ref_object *object;
    uint32_t *places; /* of each vertex */
    mesh_spot *spots; /* of each vertex */
    mesh_side *sides;
    size_t side_count;
    uint32_t (*side_of)[3]; /* first of the sides between the same two places, by triangle and corner */
    bool *is_line;          /* by first side */
    /* While walking: */
    double *cost; /* by triangle */
    uint32_t *seen, *reached, walk;
    size_t reached_count;
    uint32_t *first_fragment; /* of those that lie on the triangle; UINT32_MAX: none */
} mesh_on_screen;

/* ---- topology ---- */

static inline int mesh_compare_sides(const void *left, const void *right) {
    const mesh_side *a = left, *b = right;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return a->triangle < b->triangle ? -1 : a->triangle > b->triangle;
}

static inline uint32_t mesh_corner(const mesh_on_screen *m, uint32_t triangle, uint32_t corner) {
    return m->object->indices[3 * (size_t)triangle + corner % 3];
}

static inline mesh_side mesh_side_at(const mesh_on_screen *m, uint32_t triangle, uint32_t corner) {
    uint32_t a = m->places[mesh_corner(m, triangle, corner)], b = m->places[mesh_corner(m, triangle, corner + 1)];
    mesh_side side = {a < b ? a : b, a < b ? b : a, triangle, a < b};
    return side;
}

/* The first of the sides between the same places as this one; SIZE_MAX: there is none. */
static inline size_t mesh_first_side(const mesh_on_screen *m, mesh_side wanted) {
    size_t low = 0, high = m->side_count;
    wanted.triangle = 0;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (mesh_compare_sides(&m->sides[middle], &wanted) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    bool is = low < m->side_count && m->sides[low].low == wanted.low && m->sides[low].high == wanted.high;
    return is ? low : SIZE_MAX;
}

static inline size_t mesh_after_side(const mesh_on_screen *m, size_t first) {
    size_t end = first;
    while (end < m->side_count && m->sides[end].low == m->sides[first].low &&
           m->sides[end].high == m->sides[first].high)
        ++end;
    return end;
}

static inline void mesh_open(mesh_on_screen *m, const ref_object *object) {
    memset(m, 0, sizeof *m);
    m->object = object;
    size_t triangles = object->triangle_count;
    m->places = malloc((object->vertex_count + 1) * sizeof *m->places);
    m->spots = malloc((object->vertex_count + 1) * sizeof *m->spots);
    m->sides = malloc((3 * triangles + 1) * sizeof *m->sides);
    m->side_of = malloc((triangles + 1) * sizeof *m->side_of);
    m->is_line = calloc(3 * triangles + 1, sizeof *m->is_line);
    m->cost = malloc((triangles + 1) * sizeof *m->cost);
    m->seen = calloc(triangles + 1, sizeof *m->seen);
    m->reached = malloc((triangles + 1) * sizeof *m->reached);
    m->first_fragment = malloc((triangles + 1) * sizeof *m->first_fragment);
    assert_true(scene_weld(object->positions, object->vertex_count, m->places) != SIZE_MAX);
    for (uint32_t t = 0; t < triangles; ++t)
        for (uint32_t k = 0; k < 3; ++k)
            m->sides[m->side_count++] = mesh_side_at(m, t, k);
    qsort(m->sides, m->side_count, sizeof *m->sides, mesh_compare_sides);
    for (uint32_t t = 0; t < triangles; ++t)
        for (uint32_t k = 0; k < 3; ++k)
            m->side_of[t][k] = (uint32_t)mesh_first_side(m, mesh_side_at(m, t, k));
}

static inline void mesh_close(mesh_on_screen *m) {
    free(m->places);
    free(m->spots);
    free(m->sides);
    free(m->side_of);
    free(m->is_line);
    free(m->cost);
    free(m->seen);
    free(m->reached);
    free(m->first_fragment);
}

/* ---- the window ---- */

static inline mesh_spot mesh_window(const smart_stage *t, const double model_view[16], const float *p) {
    const double *projection = t->scene.scene.projection;
    double eye[4], clip[4];
    for (int row = 0; row < 4; ++row)
        eye[row] = model_view[row] * (double)p[0] + model_view[4 + row] * (double)p[1] +
                   model_view[8 + row] * (double)p[2] + model_view[12 + row];
    for (int row = 0; row < 4; ++row)
        clip[row] = projection[row] * eye[0] + projection[4 + row] * eye[1] + projection[8 + row] * eye[2] +
                    projection[12 + row] * eye[3];
    assert_true(clip[3] > 0);
    mesh_spot spot = {(0.5 + 0.5 * clip[0] / clip[3]) * t->set.width, (0.5 + 0.5 * clip[1] / clip[3]) * t->set.height,
                      -eye[2]};
    return spot;
}

static inline mesh_spot mesh_spot_of(const mesh_on_screen *m, uint32_t triangle, uint32_t corner) {
    return m->spots[mesh_corner(m, triangle, corner)];
}

/* Distance in the window of two segments; a segment may be a point. */
static inline double mesh_to_segment(mesh_spot p, mesh_spot a, mesh_spot b) {
    double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    double s = square > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0;
    s = fmin(fmax(s, 0), 1);
    return hypot(p.x - a.x - s * dx, p.y - a.y - s * dy);
}

static inline double mesh_turn(mesh_spot a, mesh_spot b, mesh_spot c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static inline double mesh_apart(mesh_spot a, mesh_spot b, mesh_spot c, mesh_spot d) {
    if (mesh_turn(a, b, c) * mesh_turn(a, b, d) < 0 && mesh_turn(c, d, a) * mesh_turn(c, d, b) < 0)
        return 0;
    return fmin(fmin(mesh_to_segment(c, a, b), mesh_to_segment(d, a, b)),
                fmin(mesh_to_segment(a, c, d), mesh_to_segment(b, c, d)));
}

/* Within the triangle, or so far from it in pixels. */
static inline double mesh_to_triangle(const mesh_on_screen *m, uint32_t triangle, mesh_spot p) {
    mesh_spot a = mesh_spot_of(m, triangle, 0), b = mesh_spot_of(m, triangle, 1), c = mesh_spot_of(m, triangle, 2);
    double u = mesh_turn(a, b, p), v = mesh_turn(b, c, p), w = mesh_turn(c, a, p);
    if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))
        return 0;
    return fmin(mesh_to_segment(p, a, b), fmin(mesh_to_segment(p, b, c), mesh_to_segment(p, c, a)));
}

/* Distance along the view of the triangle's plane at a place of the window: its reciprocal is linear there under
 * perspective, itself under a parallel projection. */
static inline double mesh_away(const smart_stage *t, const mesh_on_screen *m, uint32_t triangle, mesh_spot p) {
    mesh_spot a = mesh_spot_of(m, triangle, 0), b = mesh_spot_of(m, triangle, 1), c = mesh_spot_of(m, triangle, 2);
    double u = mesh_turn(b, c, p), v = mesh_turn(c, a, p), w = mesh_turn(a, b, p), sum = mesh_turn(a, b, c);
    if (sum == 0)
        return a.away;
    if (t->scene.scene.projection[11] == 0)
        return (u * a.away + v * b.away + w * c.away) / sum;
    return sum / (u / a.away + v / b.away + w / c.away);
}

/* ---- lines ---- */

/* The silhouettes and borders of this view. Where two faces are wound in opposite senses (the seam of a surface that has
 * no two sides) silhouette.h's rule takes windings as they stand: there both are seen from one side where it says
 * silhouette, and the surface turns away where it says none. */
static inline void mesh_view(mesh_on_screen *m, const smart_stage *t) {
    const ref_object *o = m->object;
    sil_mesh_desc desc;
    sil_view view;
    double model_view[16];
    float turn[16], projection[16];
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
    for (size_t i = 0; i < o->vertex_count; ++i)
        m->spots[i] = mesh_window(t, model_view, o->positions + 3 * i);
    assert_int_equal(sil_view_from_matrices(turn, projection, &view), SIL_OK);
    size_t all = sil_mesh_get_info(mesh).edge_count;
    sil_edge *edges = malloc((all + 1) * sizeof *edges);
    size_t found = sil_extract(mesh, NULL, &view, SIL_SILHOUETTE | SIL_BOUNDARY, edges, all);
    memset(m->is_line, 0, m->side_count * sizeof *m->is_line);
    for (size_t i = 0; i < found; ++i) {
        uint32_t a = m->places[edges[i].a], b = m->places[edges[i].b];
        mesh_side wanted = {a < b ? a : b, a < b ? b : a, 0, false};
        size_t first = mesh_first_side(m, wanted);
        assert_true(first != SIZE_MAX);
        m->is_line[first] = true;
    }
    for (size_t i = 0, end; i < m->side_count; i = end) {
        end = mesh_after_side(m, i);
        if (end == i + 2 && m->sides[i].rises == m->sides[i + 1].rises)
            m->is_line[i] = !m->is_line[i];
    }
    free(edges);
    sil_mesh_destroy(mesh);
}

/* ---- walking ---- */

static inline void mesh_reach(mesh_on_screen *m, uint32_t triangle, double cost) {
    if (m->seen[triangle] != m->walk) {
        m->seen[triangle] = m->walk;
        m->reached[m->reached_count++] = triangle;
        m->cost[triangle] = cost;
    } else if (cost < m->cost[triangle]) {
        m->cost[triangle] = cost;
    }
}

static inline void mesh_begin_walk(mesh_on_screen *m) {
    ++m->walk;
    m->reached_count = 0;
}

/* From the triangles that were reached on to all others, along the surface: the cost of each is how far from the segment
 * from a to b (pixels) a path to it has to go, up to `most`. over_lines: also where the surface turns away. Returns the
 * same for the nearest line. */
static inline double mesh_walk(mesh_on_screen *m, mesh_spot a, mesh_spot b, double most, bool over_lines) {
    double line = HUGE_VAL;
    for (size_t done = 0; done < m->reached_count; ++done) {
        size_t least = done;
        for (size_t i = done + 1; i < m->reached_count; ++i)
            if (m->cost[m->reached[i]] < m->cost[m->reached[least]])
                least = i;
        uint32_t triangle = m->reached[least];
        m->reached[least] = m->reached[done];
        m->reached[done] = triangle;
        for (uint32_t k = 0; k < 3; ++k) {
            double apart = mesh_apart(a, b, mesh_spot_of(m, triangle, k), mesh_spot_of(m, triangle, k + 1));
            double cost = fmax(m->cost[triangle], apart);
            size_t first = m->side_of[triangle][k], end = mesh_after_side(m, first);
            if (cost > most)
                continue;
            if (m->is_line[first])
                line = fmin(line, cost);
            for (size_t i = first; i < end && (over_lines || !m->is_line[first]); ++i)
                mesh_reach(m, m->sides[i].triangle, cost);
        }
    }
    return line;
}

#endif

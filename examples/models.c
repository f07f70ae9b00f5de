#include "models.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "battlefield.h"

#define PI 3.14159265358979323846

/* Colours as printed technical illustrations have them: clear, but never at full strength. */
static const float STEEL[3] = {0.74f, 0.77f, 0.80f};
static const float DARK_STEEL[3] = {0.42f, 0.45f, 0.49f};
static const float GLASS_BLUE[3] = {0.62f, 0.74f, 0.84f};
static const float PALE_GREEN[3] = {0.68f, 0.80f, 0.72f};
static const float BRASS[3] = {0.82f, 0.68f, 0.38f};
static const float TEAL[3] = {0.36f, 0.60f, 0.60f};
static const float BRICK[3] = {0.74f, 0.38f, 0.30f};
static const float OCHRE[3] = {0.80f, 0.56f, 0.26f};
static const float SLATE[3] = {0.46f, 0.52f, 0.66f};
static const float SAND[3] = {0.86f, 0.80f, 0.68f};

/* ---- a mesh being built ---------------------------------------------------------------------------------- */

/* Solids are put together from loops of points: walls between two loops, and flat caps with holes between loops of the
 * same height. Surfaces that meet use the same points, so nothing has to be welded and no crack can open. */
typedef struct builder {
    float *positions;
    uint32_t *indices;
    size_t points, point_room, corners, corner_room;
    bool failed; /* out of memory, or a cap that could not be filled: checked once, at the end */
} builder;

enum { LOOP_MAX = 1024 };
typedef struct loop {
    size_t n;
    uint32_t v[LOOP_MAX];
} loop;
typedef struct outline { /* counter-clockwise */
    size_t n;
    double x[LOOP_MAX], y[LOOP_MAX];
} outline;

static bool make_room(builder *b, void **array, size_t *room, size_t need, size_t element) {
    if (b->failed || need <= *room)
        return !b->failed;
    size_t more = need > 2 * *room ? need + 256 : 2 * *room;
    void *bigger = realloc(*array, more * element);
    if (bigger) {
        *array = bigger;
        *room = more;
    }
    b->failed = bigger == NULL;
    return bigger != NULL;
}

static uint32_t point(builder *b, double x, double y, double z) {
    void *array = b->positions;
    if (!make_room(b, &array, &b->point_room, b->points + 1, 3 * sizeof(float)))
        return 0;
    b->positions = array;
    float *p = &b->positions[3 * b->points];
    p[0] = (float)x;
    p[1] = (float)y;
    p[2] = (float)z;
    return (uint32_t)b->points++;
}

static void triangle(builder *b, uint32_t p, uint32_t q, uint32_t r) {
    void *array = b->indices;
    if (!make_room(b, &array, &b->corner_room, b->corners + 3, sizeof(uint32_t)))
        return;
    b->indices = array;
    b->indices[b->corners++] = p;
    b->indices[b->corners++] = q;
    b->indices[b->corners++] = r;
}

static void quad(builder *b, uint32_t p, uint32_t q, uint32_t r, uint32_t s) {
    triangle(b, p, q, r);
    triangle(b, p, r, s);
}

/* Faces away from the axis where the upper loop has the larger z; exchanged, the wall of a hole. */
static void wall(builder *b, const loop *lower, const loop *upper) {
    for (size_t i = 0, n = lower->n; i < n; i++)
        quad(b, lower->v[i], lower->v[(i + 1) % n], upper->v[(i + 1) % n], upper->v[i]);
}

static void place(builder *b, loop *l, const outline *o, double z) {
    l->n = o->n;
    for (size_t i = 0; i < o->n; i++)
        l->v[i] = point(b, o->x[i], o->y[i], z);
}

/* ---- caps: polygons with holes into triangles ------------------------------------------------------------ */

/* One polygon without holes: each hole is joined to the outside by a bridge that is walked twice. */
typedef struct polygon {
    size_t n;
    uint32_t v[4 * LOOP_MAX];
} polygon;

static double coordinate(const builder *b, uint32_t v, size_t axis) {
    return (double)b->positions[3 * (size_t)v + axis];
}

/* Twice the area of p q r in the plane, positive counter-clockwise. */
static double turn(const builder *b, uint32_t p, uint32_t q, uint32_t r) {
    double ux = coordinate(b, q, 0) - coordinate(b, p, 0), uy = coordinate(b, q, 1) - coordinate(b, p, 1);
    double vx = coordinate(b, r, 0) - coordinate(b, p, 0), vy = coordinate(b, r, 1) - coordinate(b, p, 1);
    return ux * vy - uy * vx;
}

static bool crosses(const builder *b, uint32_t p, uint32_t q, uint32_t r, uint32_t s) {
    if (p == r || p == s || q == r || q == s)
        return false;
    return turn(b, p, q, r) * turn(b, p, q, s) <= 0 && turn(b, r, s, p) * turn(b, r, s, q) <= 0; /* touching counts */
}

static bool crosses_loop(const builder *b, uint32_t p, uint32_t q, const uint32_t *v, size_t n) {
    for (size_t i = 0; i < n; i++)
        if (crosses(b, p, q, v[i], v[(i + 1) % n]))
            return true;
    return false;
}

/* Whether the direction from corner i toward q lies inside the polygon. */
static bool opens_toward(const builder *b, const polygon *p, size_t i, uint32_t q) {
    uint32_t before = p->v[(i + p->n - 1) % p->n], here = p->v[i], after = p->v[(i + 1) % p->n];
    if (turn(b, before, here, after) > 0)
        return turn(b, here, q, before) > 0 && turn(b, here, after, q) > 0;
    return !(turn(b, here, q, after) >= 0 && turn(b, here, before, q) >= 0);
}

/* The polygon's corner that hole h's point is joined to: the nearest that sees it. */
static size_t find_bridge(const builder *b, const polygon *p, const loop *const *holes, size_t hole_count, uint32_t q) {
    size_t best = p->n;
    double best_distance = HUGE_VAL;
    for (size_t i = 0; i < p->n; i++) {
        double dx = coordinate(b, p->v[i], 0) - coordinate(b, q, 0),
               dy = coordinate(b, p->v[i], 1) - coordinate(b, q, 1);
        bool free_way =
            dx * dx + dy * dy < best_distance && opens_toward(b, p, i, q) && !crosses_loop(b, p->v[i], q, p->v, p->n);
        for (size_t h = 0; free_way && h < hole_count; h++)
            free_way = !crosses_loop(b, p->v[i], q, holes[h]->v, holes[h]->n);
        if (free_way) {
            best = i;
            best_distance = dx * dx + dy * dy;
        }
    }
    return best;
}

static size_t rightmost(const builder *b, const loop *l) {
    size_t best = 0;
    for (size_t i = 1; i < l->n; i++)
        if (coordinate(b, l->v[i], 0) > coordinate(b, l->v[best], 0))
            best = i;
    return best;
}

/* Holes run clockwise in the joined polygon, their outlines are counter-clockwise: they are walked backward. */
static void join_hole(builder *b, polygon *p, const loop *const *holes, size_t hole_count, size_t h) {
    const loop *hole = holes[h];
    size_t start = rightmost(b, hole), at = find_bridge(b, p, holes, hole_count, hole->v[start]);
    if (at == p->n || p->n + hole->n + 2 > sizeof p->v / sizeof p->v[0]) {
        b->failed = true;
        return;
    }
    memmove(&p->v[at + hole->n + 2], &p->v[at], (p->n - at) * sizeof p->v[0]);
    for (size_t i = 0; i <= hole->n; i++)
        p->v[at + 1 + i] = hole->v[(start + hole->n - i) % hole->n];
    p->n += hole->n + 2;
}

/* From right to left: so nothing but the joined polygon lies to the right of a hole, and each finds a way. */
static void join_holes(builder *b, polygon *p, const loop *const *holes, size_t hole_count) {
    bool joined[64] = {false};
    if (hole_count > 64)
        b->failed = true;
    for (size_t round = 0; round < hole_count && !b->failed; round++) {
        size_t best = hole_count;
        double best_x = -HUGE_VAL;
        for (size_t h = 0; h < hole_count; h++) {
            double x = coordinate(b, holes[h]->v[rightmost(b, holes[h])], 0);
            if (!joined[h] && x > best_x) {
                best = h;
                best_x = x;
            }
        }
        joined[best] = true;
        join_hole(b, p, holes, hole_count, best);
    }
}

static bool is_ear(const builder *b, const polygon *p, size_t i) {
    size_t before = (i + p->n - 1) % p->n, after = (i + 1) % p->n;
    uint32_t q[3] = {p->v[before], p->v[i], p->v[after]};
    if (turn(b, q[0], q[1], q[2]) <= 1e-9)
        return false;
    /* A bridge's ends occur twice; only from the right one of the two does the cut stay inside. */
    if (p->n > 3 && (!opens_toward(b, p, before, q[2]) || !opens_toward(b, p, after, q[0])))
        return false;
    for (size_t j = 0; j < p->n; j++) {
        uint32_t v = p->v[j];
        if (v == q[0] || v == q[1] || v == q[2])
            continue;
        /* A point on the cut, as far as floats can tell, would be left over in a triangle without area. */
        if (turn(b, q[0], q[1], v) > -1e-6 && turn(b, q[1], q[2], v) > -1e-6 && turn(b, q[2], q[0], v) > -1e-6)
            return false;
    }
    return true;
}

static void clip_ears(builder *b, polygon *p, bool up) {
    size_t i = 0, misses = 0;
    while (p->n >= 3 && misses < p->n) {
        i %= p->n;
        if (!is_ear(b, p, i)) {
            i++;
            misses++;
            continue;
        }
        uint32_t before = p->v[(i + p->n - 1) % p->n], here = p->v[i], after = p->v[(i + 1) % p->n];
        triangle(b, before, up ? here : after, up ? after : here);
        memmove(&p->v[i], &p->v[i + 1], (p->n - i - 1) * sizeof p->v[0]);
        p->n--;
        i++; /* not the neighbour next: a fan of slivers would come of it */
        misses = 0;
    }
    if (p->n > 2)
        b->failed = true;
}

/* A flat face between an outer loop and holes in it, facing up (larger z) or down. */
static void cap(builder *b, const loop *outer, const loop *const *holes, size_t hole_count, bool up) {
    polygon *p = malloc(sizeof *p);
    if (!p || b->failed) {
        b->failed = true;
        free(p);
        return;
    }
    p->n = outer->n;
    memcpy(p->v, outer->v, outer->n * sizeof p->v[0]);
    join_holes(b, p, holes, hole_count);
    if (!b->failed)
        clip_ears(b, p, up);
    free(p);
}

static void ring_cap(builder *b, const loop *outer, const loop *hole, bool up) {
    cap(b, outer, &hole, 1, up);
}

/* ---- outlines and simple solids -------------------------------------------------------------------------- */

static void add_xy(outline *o, double x, double y) {
    if (o->n < LOOP_MAX) {
        o->x[o->n] = x;
        o->y[o->n++] = y;
    }
}

/* From angle `from` to `to` in steps + 1 points. */
static void arc(outline *o, double cx, double cy, double radius, double from, double to, size_t steps) {
    for (size_t i = 0; i <= steps; i++) {
        double angle = from + (to - from) * (double)i / (double)steps;
        add_xy(o, cx + radius * cos(angle), cy + radius * sin(angle));
    }
}

static void circle(outline *o, double cx, double cy, double radius, size_t n, double phase) {
    o->n = 0;
    for (size_t i = 0; i < n; i++)
        add_xy(o, cx + radius * cos(phase + 2 * PI * (double)i / (double)n),
               cy + radius * sin(phase + 2 * PI * (double)i / (double)n));
}

static void rounded_rectangle(outline *o, double x0, double y0, double x1, double y1, double radius) {
    o->n = 0;
    arc(o, x1 - radius, y1 - radius, radius, 0, PI / 2, 8);
    arc(o, x0 + radius, y1 - radius, radius, PI / 2, PI, 8);
    arc(o, x0 + radius, y0 + radius, radius, PI, 1.5 * PI, 8);
    arc(o, x1 - radius, y0 + radius, radius, 1.5 * PI, 2 * PI, 8);
}

static void rotate_outline(outline *o, double angle, double dx, double dy) {
    for (size_t i = 0; i < o->n; i++) {
        double x = o->x[i], y = o->y[i];
        o->x[i] = x * cos(angle) - y * sin(angle) + dx;
        o->y[i] = x * sin(angle) + y * cos(angle) + dy;
    }
}

/* A disc or plate with round holes through it. */
static void plate(builder *b, const outline *outside, const outline *holes, size_t hole_count, double z0, double z1) {
    enum { MOST = 40 };
    loop *loops = malloc((2 * MOST + 2) * sizeof *loops);
    const loop *low[MOST], *high[MOST];
    if (!loops || hole_count > MOST) {
        b->failed = true;
        free(loops);
        return;
    }
    place(b, &loops[0], outside, z0);
    place(b, &loops[1], outside, z1);
    wall(b, &loops[0], &loops[1]);
    for (size_t h = 0; h < hole_count; h++) {
        place(b, &loops[2 * h + 2], &holes[h], z0);
        place(b, &loops[2 * h + 3], &holes[h], z1);
        wall(b, &loops[2 * h + 3], &loops[2 * h + 2]);
        low[h] = &loops[2 * h + 2];
        high[h] = &loops[2 * h + 3];
    }
    cap(b, &loops[0], low, hole_count, false);
    cap(b, &loops[1], high, hole_count, true);
    free(loops);
}

typedef struct profile {
    size_t n;
    double r[256], z[256];
} profile;

static void add_rz(profile *p, double r, double z) {
    if (p->n < sizeof p->r / sizeof p->r[0]) {
        p->r[p->n] = r;
        p->z[p->n++] = z;
    }
}

static void add_arc(profile *p, double r, double z, double radius, double from, double to, size_t steps) {
    for (size_t i = 0; i <= steps; i++) {
        double angle = from + (to - from) * (double)i / (double)steps;
        add_rz(p, r + radius * cos(angle), z + radius * sin(angle));
    }
}

static void profile_ring(builder *b, loop *l, double r, double z, size_t segments) {
    outline o;
    circle(&o, 0, 0, r, segments, 0);
    if (r > 0) {
        place(b, l, &o, z);
        return;
    }
    l->n = segments; /* on the axis all points are one */
    l->v[0] = point(b, 0, 0, z);
    for (size_t i = 1; i < segments; i++)
        l->v[i] = l->v[0];
}

/* Between two rings; where one of them is a single point, a fan. */
static void ring_wall(builder *b, const loop *lower, const loop *upper) {
    for (size_t i = 0, n = lower->n; i < n; i++) {
        size_t j = (i + 1) % n;
        if (lower->v[i] != lower->v[j])
            triangle(b, lower->v[i], lower->v[j], upper->v[j]);
        if (upper->v[i] != upper->v[j])
            triangle(b, lower->v[i], upper->v[j], upper->v[i]);
    }
}

/* Turns a profile around the z axis. It runs with the outside on its right hand, r to the right and z up; a closed one
 * goes back to its first point, an open one begins and ends on the axis. */
static void revolve(builder *b, const profile *p, size_t segments, bool closed) {
    loop first, previous, next;
    profile_ring(b, &first, p->r[0], p->z[0], segments);
    previous = first;
    for (size_t i = 1; i < p->n; i++) {
        profile_ring(b, &next, p->r[i], p->z[i], segments);
        ring_wall(b, &previous, &next);
        previous = next;
    }
    if (closed)
        ring_wall(b, &previous, &first);
}

static void rod_z(builder *b, double radius, double z0, double z1, size_t segments) {
    profile p = {0};
    add_rz(&p, 0, z0);
    add_rz(&p, radius, z0);
    add_rz(&p, radius, z1);
    add_rz(&p, 0, z1);
    revolve(b, &p, segments, false);
}

static void tube_z(builder *b, double inner, double outer, double z0, double z1, size_t segments) {
    profile p = {0};
    add_rz(&p, inner, z0);
    add_rz(&p, outer, z0);
    add_rz(&p, outer, z1);
    add_rz(&p, inner, z1);
    revolve(b, &p, segments, true);
}

static void sphere(builder *b, double cx, double cy, double cz, double radius, size_t segments, size_t rings) {
    size_t first = b->points;
    profile p = {0};
    for (size_t i = 0; i <= rings; i++) {
        double angle = PI * ((double)i / (double)rings - 0.5);
        add_rz(&p, i == 0 || i == rings ? 0 : radius * cos(angle), radius * sin(angle));
    }
    revolve(b, &p, segments, false);
    for (size_t i = first; i < b->points; i++) {
        b->positions[3 * i] += (float)cx;
        b->positions[3 * i + 1] += (float)cy;
        b->positions[3 * i + 2] += (float)cz;
    }
}

static void box(builder *b, const double low[3], const double high[3]) {
    loop bottom = {.n = 4}, top = {.n = 4};
    for (size_t i = 0; i < 4; i++) {
        double x = i == 1 || i == 2 ? high[0] : low[0], y = i >= 2 ? high[1] : low[1];
        bottom.v[i] = point(b, x, y, low[2]);
        top.v[i] = point(b, x, y, high[2]);
    }
    wall(b, &bottom, &top);
    quad(b, top.v[0], top.v[1], top.v[2], top.v[3]);
    quad(b, bottom.v[3], bottom.v[2], bottom.v[1], bottom.v[0]);
}

/* Hands what was built to the scene as a mesh. */
static size_t finish(builder *b, scene *s, const char *name) {
    scene_mesh mesh = {.positions = b->positions, .indices = b->indices, .vertex_count = b->points};
    mesh.index_count = b->corners;
    bool ok = !b->failed && b->corners > 0 && scene_mesh_make_normals(&mesh, 35);
    *b = (builder){0};
    if (ok)
        return scene_add_mesh(s, name, &mesh);
    free(mesh.positions);
    free(mesh.normals);
    free(mesh.indices);
    return SIZE_MAX;
}

static bool add(scene *s, const char *name, size_t mesh, const double transform[16], const float color[3],
                float opacity) {
    if (mesh == SIZE_MAX)
        return false;
    size_t part = scene_add_part(s, name, mesh, transform, color);
    if (part != SIZE_MAX)
        s->parts[part].opacity = opacity;
    return part != SIZE_MAX;
}

/* Builds the mesh and places it once. */
static bool add_built(builder *b, scene *s, const char *name, const float color[3], float opacity) {
    return add(s, name, finish(b, s, name), NULL, color, opacity);
}

static void turn_z(double m[16], double angle, double x, double y, double z) {
    memset(m, 0, 16 * sizeof *m);
    m[0] = m[5] = cos(angle);
    m[1] = sin(angle);
    m[4] = -sin(angle);
    m[10] = m[15] = 1;
    m[12] = x;
    m[13] = y;
    m[14] = z;
}

/* Long machines are built along z and lie along x. */
static void lay_down(scene *s) {
    static const double lying[16] = {0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1};
    for (size_t i = 0; i < s->part_count; i++)
        scene_multiply(lying, s->parts[i].transform, s->parts[i].transform);
}

/* ---- mug: two boundaries around a box -------------------------------------------------------------------- */

enum { MUG_SEGMENTS = 96, MUG_ROWS = 40, HANDLE_COLUMNS = 4, HANDLE_ROWS = 4, HANDLE_STEPS = 28 };

static const double MUG_RADIUS = 40, MUG_WALL = 3.5, MUG_FLOOR = 6;

/* The rows of the outer wall come first after the foot: row k of it is ring MUG_FOOT + k. */
enum { MUG_FOOT = 6, MUG_TOP_PATCH = 31, MUG_BOTTOM_PATCH = 6 };

static void mug_profile(profile *p) {
    p->n = 0;
    add_rz(p, 0, 2);
    add_rz(p, 27, 2);
    add_rz(p, 29, 0);
    add_rz(p, 34, 0);
    add_rz(p, 37.2, 1.2);
    add_rz(p, 39.2, 3.6);
    for (size_t i = 0; i <= MUG_ROWS; i++)
        add_rz(p, MUG_RADIUS, 7 + 84 * (double)i / MUG_ROWS);
    add_arc(p, MUG_RADIUS - MUG_WALL / 2, 91, MUG_WALL / 2, PI / 8, PI, 7);
    for (size_t i = 1; i < 10; i++)
        add_rz(p, MUG_RADIUS - MUG_WALL, 91 - (91 - MUG_FLOOR - 8) * (double)i / 10);
    add_arc(p, MUG_RADIUS - MUG_WALL - 8, MUG_FLOOR + 8, 8, 0, -PI / 2, 8);
    add_rz(p, 0, MUG_FLOOR);
}

/* Columns are counted from the one at angle 0 so that the patch lies around the x axis. */
static uint32_t mug_point(const loop *rings, size_t row, int column) {
    return rings[MUG_FOOT + row].v[(size_t)(column + MUG_SEGMENTS) % MUG_SEGMENTS];
}

/* The border of a hole in the wall, along the columns first, from its lower side (or upper, for the handle's far end,
 * which arrives upside down). */
static void patch_border(loop *border, const loop *rings, size_t row, bool upside_down) {
    int left = -HANDLE_COLUMNS / 2, right = HANDLE_COLUMNS / 2;
    size_t from = upside_down ? row + HANDLE_ROWS : row, to = upside_down ? row : row + HANDLE_ROWS;
    border->n = 0;
    for (int c = left; c < right; c++)
        border->v[border->n++] = mug_point(rings, from, c);
    for (size_t r = 0; r < HANDLE_ROWS; r++)
        border->v[border->n++] = mug_point(rings, upside_down ? from - r : from + r, right);
    for (int c = right; c > left; c--)
        border->v[border->n++] = mug_point(rings, to, c);
    for (size_t r = 0; r < HANDLE_ROWS; r++)
        border->v[border->n++] = mug_point(rings, upside_down ? to + r : to - r, left);
}

/* The i-th of the points around a rectangle of the handle's columns and rows, in the order of patch_border, from -1
 * to 1 and moved from the square onto the circle in it. */
static void around_patch(size_t i, double *u, double *v) {
    static const double corners[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    size_t side = 0, steps = HANDLE_COLUMNS;
    while (i >= steps) {
        i -= steps;
        steps = ++side % 2 ? HANDLE_ROWS : HANDLE_COLUMNS;
    }
    double along = (double)i / (double)steps;
    double x = corners[side][0] + along * (corners[side + 1][0] - corners[side][0]);
    double y = corners[side][1] + along * (corners[side + 1][1] - corners[side][1]);
    *u = x * sqrt(1 - y * y / 2);
    *v = y * sqrt(1 - x * x / 2);
}

/* Makes the hole in the wall round: its border moves, within the wall. */
static void round_patch(builder *b, const loop *rings, size_t row) {
    loop border;
    patch_border(&border, rings, row, false);
    double middle = (coordinate(b, border.v[0], 2) + coordinate(b, border.v[HANDLE_COLUMNS + HANDLE_ROWS], 2)) / 2;
    for (size_t i = 0; i < border.n && !b->failed; i++) {
        double u, v;
        around_patch(i, &u, &v);
        double angle = 1.2 * u * PI * HANDLE_COLUMNS / MUG_SEGMENTS;
        float *p = &b->positions[3 * (size_t)border.v[i]];
        p[0] = (float)(MUG_RADIUS * cos(angle));
        p[1] = (float)(MUG_RADIUS * sin(angle));
        p[2] = (float)(middle + 5 * v);
    }
}

static void handle_ring(builder *b, loop *ring, double angle) {
    double x = MUG_RADIUS + 4 + 25 * cos(angle), z = 51.1 + 26.25 * sin(angle);
    ring->n = 2 * (HANDLE_COLUMNS + HANDLE_ROWS);
    for (size_t i = 0; i < ring->n; i++) {
        double u, v;
        around_patch(i, &u, &v);
        ring->v[i] = point(b, x + 3.3 * v * cos(angle), 4.6 * u, z + 3.3 * v * sin(angle));
    }
}

static void mug_handle(builder *b, const loop *rings) {
    loop previous, next;
    round_patch(b, rings, MUG_TOP_PATCH);
    round_patch(b, rings, MUG_BOTTOM_PATCH);
    patch_border(&previous, rings, MUG_TOP_PATCH, false);
    for (size_t i = 0; i <= HANDLE_STEPS; i++) {
        handle_ring(b, &next, PI / 2 - PI * (double)i / HANDLE_STEPS);
        wall(b, &previous, &next);
        previous = next;
    }
    patch_border(&next, rings, MUG_BOTTOM_PATCH, true);
    wall(b, &previous, &next);
}

static bool in_patch(size_t ring, size_t column) {
    bool beside = column < HANDLE_COLUMNS / 2 || column >= MUG_SEGMENTS - HANDLE_COLUMNS / 2;
    size_t row = ring - MUG_FOOT;
    return beside && ring >= MUG_FOOT &&
           ((row >= MUG_TOP_PATCH && row < MUG_TOP_PATCH + HANDLE_ROWS) ||
            (row >= MUG_BOTTOM_PATCH && row < MUG_BOTTOM_PATCH + HANDLE_ROWS));
}

static void mug_body(builder *b) {
    profile p;
    mug_profile(&p);
    loop *rings = malloc(p.n * sizeof *rings);
    if (!rings) {
        b->failed = true;
        return;
    }
    for (size_t i = 0; i < p.n; i++)
        profile_ring(b, &rings[i], p.r[i], p.z[i], MUG_SEGMENTS);
    for (size_t i = 0; i + 1 < p.n; i++) {
        if (i < MUG_FOOT || i >= MUG_FOOT + MUG_ROWS) {
            ring_wall(b, &rings[i], &rings[i + 1]);
            continue;
        }
        for (size_t c = 0, n = MUG_SEGMENTS; c < n; c++)
            if (!in_patch(i, c))
                quad(b, rings[i].v[c], rings[i].v[(c + 1) % n], rings[i + 1].v[(c + 1) % n], rings[i + 1].v[c]);
    }
    mug_handle(b, rings);
    free(rings);
}

static bool make_mug(scene *s) {
    builder b = {0};
    mug_body(&b);
    bool ok = add_built(&b, s, "mug/body", GLASS_BLUE, 0.4f);
    box(&b, (double[3]){-15, -13, 0}, (double[3]){15, 13, 42});
    double standing[16];
    turn_z(standing, 0.42, -2, 0, MUG_FLOOR + 0.2);
    return add(s, "mug/box", finish(&b, s, "mug/box"), standing, BRICK, 1) && ok;
}

/* ---- crank in a cylinder --------------------------------------------------------------------------------- */

enum { THROWS = 4, CRANK_SEGMENTS = 48 };
static const double THROW = 14, JOURNAL = 9, PIN = 7, JOURNAL_LENGTH = 12, PIN_LENGTH = 14, WEB = 6, ROD = 30;
static const double THROW_ANGLE[THROWS] = {0.5, 0.5 + PI, 0.5 + PI / 2, 0.5 + 1.5 * PI};

static double throw_start(size_t i) {
    return JOURNAL_LENGTH + (double)i * (2 * WEB + PIN_LENGTH + JOURNAL_LENGTH);
}

/* The hull of a round end around the pin and a heavier one on the other side. */
static void web_outline(outline *o, double angle) {
    double pin_end = 11, weight_end = 20, apart = THROW + 4;
    double tangent = acos((weight_end - pin_end) / apart); /* where the hull leaves both circles */
    o->n = 0;
    arc(o, THROW, 0, pin_end, -tangent, tangent, 16);
    arc(o, -4, 0, weight_end, tangent, 2 * PI - tangent, 40);
    rotate_outline(o, angle, 0, 0);
}

/* From one journal over web, pin and web to the next journal. */
static void crank_throw(builder *b, loop *journal, double z, double angle) {
    outline web, round;
    loop near_web[2], far_web[2], pin[2];
    web_outline(&web, angle);
    double zs[4] = {z, z + WEB, z + WEB + PIN_LENGTH, z + 2 * WEB + PIN_LENGTH};
    place(b, &near_web[0], &web, zs[0]);
    place(b, &near_web[1], &web, zs[1]);
    place(b, &far_web[0], &web, zs[2]);
    place(b, &far_web[1], &web, zs[3]);
    circle(&round, THROW * cos(angle), THROW * sin(angle), PIN, CRANK_SEGMENTS, angle);
    place(b, &pin[0], &round, zs[1]);
    place(b, &pin[1], &round, zs[2]);
    ring_cap(b, &near_web[0], journal, false);
    wall(b, &near_web[0], &near_web[1]);
    ring_cap(b, &near_web[1], &pin[0], true);
    wall(b, &pin[0], &pin[1]);
    ring_cap(b, &far_web[0], &pin[1], false);
    wall(b, &far_web[0], &far_web[1]);
    circle(&round, 0, 0, JOURNAL, CRANK_SEGMENTS, 0);
    place(b, journal, &round, zs[3]);
    ring_cap(b, &far_web[1], journal, true);
}

static void crankshaft(builder *b) {
    loop end, step, journal, next;
    double last = throw_start(THROWS - 1) + 2 * WEB + PIN_LENGTH + JOURNAL_LENGTH;
    profile_ring(b, &end, 6, -34, CRANK_SEGMENTS);
    cap(b, &end, NULL, 0, false);
    profile_ring(b, &step, 6, -18, CRANK_SEGMENTS);
    wall(b, &end, &step);
    profile_ring(b, &journal, JOURNAL, -18, CRANK_SEGMENTS);
    ring_cap(b, &journal, &step, false);
    for (size_t i = 0; i < THROWS; i++) {
        profile_ring(b, &next, JOURNAL, throw_start(i), CRANK_SEGMENTS);
        wall(b, &journal, &next);
        journal = next;
        crank_throw(b, &journal, throw_start(i), THROW_ANGLE[i]);
    }
    profile_ring(b, &next, JOURNAL, last + 18, CRANK_SEGMENTS); /* the flange that a flywheel would sit on */
    wall(b, &journal, &next);
    profile_ring(b, &step, 17, last + 18, CRANK_SEGMENTS);
    ring_cap(b, &step, &next, false);
    profile_ring(b, &end, 17, last + 25, CRANK_SEGMENTS);
    wall(b, &step, &end);
    cap(b, &end, NULL, 0, true);
}

/* Big end around the origin, small end on the x axis. */
static void connecting_rod(builder *b) {
    double big = 11, little = 6.5, half_shank = 3.6;
    outline outside = {0}, holes[2];
    double leave = asin(half_shank / big), arrive = PI - asin(half_shank / little);
    arc(&outside, 0, 0, big, leave, 2 * PI - leave, 36);
    arc(&outside, ROD, 0, little, -arrive, arrive, 24);
    circle(&holes[0], 0, 0, PIN + 0.25, CRANK_SEGMENTS, 0);
    circle(&holes[1], ROD, 0, 4.1, 32, 0);
    plate(b, &outside, holes, 2, -4.5, 4.5);
}

/* Rods point up and down in turns, as in a boxer engine; the small ends stay on the cylinder's middle plane. */
static bool add_rods(scene *s) {
    builder b = {0};
    connecting_rod(&b);
    size_t rod = finish(&b, s, "crank/rod");
    rod_z(&b, 3.95, -6, 6, 32);
    size_t pin = finish(&b, s, "crank/wrist_pin");
    bool ok = rod != SIZE_MAX && pin != SIZE_MAX;
    for (size_t i = 0; ok && i < THROWS; i++) {
        double x = THROW * cos(THROW_ANGLE[i]), y = THROW * sin(THROW_ANGLE[i]), side = i % 2 ? -1 : 1;
        double reach = y + side * sqrt(ROD * ROD - x * x), z = throw_start(i) + WEB + PIN_LENGTH / 2, m[16];
        char name[32];
        snprintf(name, sizeof name, "crank/rod_%zu", i + 1);
        turn_z(m, atan2(reach - y, -x), x, y, z);
        ok = add(s, name, rod, m, OCHRE, 1);
        snprintf(name, sizeof name, "crank/wrist_pin_%zu", i + 1);
        turn_z(m, 0, 0, reach, z);
        ok = ok && add(s, name, pin, m, SLATE, 1);
    }
    return ok;
}

/* The cylinder is one boundary, its inside is not modelled, and the shaft goes through its ends. */
static bool make_crank(scene *s) {
    builder b = {0};
    double last = throw_start(THROWS - 1) + 2 * WEB + PIN_LENGTH + JOURNAL_LENGTH;
    rod_z(&b, 54, -6, last + 6, 96);
    bool ok = add_built(&b, s, "crank/cylinder", GLASS_BLUE, 0.4f);
    crankshaft(&b);
    ok = add_built(&b, s, "crank/shaft", STEEL, 1) && ok && add_rods(s);
    lay_down(s);
    return ok;
}

/* ---- gearbox --------------------------------------------------------------------------------------------- */

/* Lengths in millimetres. Everything that would touch is kept a tenth of a millimetre or more apart, as surfaces that
 * coincide would flicker. */
static const double MODULE = 2, SHAFT = 11, SEAT = 9, BORE = 22, INSIDE = 150, COVER = 14, GAP = 0.2, FLANGE = 10;
enum { GEAR_SEGMENTS = 48, FLANGE_BOLTS = 14, CAP_BOLTS = 4, BALLS = 9 };

typedef struct shaft_plan {
    const char *name;
    double x, y;
    double front, back; /* where the shaft ends; past the covers it pokes out */
    const float *color;
} shaft_plan;

static const shaft_plan SHAFTS[3] = {
    {"shaft_in", -48.497422611928565, 28, -58, 162, BRASS}, /* 56 from the layshaft, at 150 degrees */
    {"layshaft", 0, 0, -12, 162, TEAL},
    {"shaft_out", 49.14912265733951, 34.41458618106277, -12, 212, BRICK}, /* 60 from it, at 35 degrees */
};

typedef struct gear_plan {
    const char *name;
    size_t shaft;
    size_t teeth;
    double z0, z1;
    size_t mate; /* which gear it meshes with */
} gear_plan;

enum { GEARS = 8 };
static const gear_plan GEAR[GEARS] = {
    {"gear_1", 0, 20, 14, 30, 3},   {"gear_2", 0, 24, 40, 56, 4},   {"gear_3", 0, 28, 66, 82, 5},
    {"gear_1", 1, 36, 15, 29, 0},   {"gear_2", 1, 32, 41, 55, 1},   {"gear_3", 1, 28, 67, 81, 2},
    {"gear_4", 1, 18, 104, 130, 7}, {"gear_4", 2, 42, 106, 128, 6},
};

static double involute(double angle) {
    return tan(angle) - angle;
}

/* Half the angle that a tooth takes up at a radius: involute flanks of 20 degrees, thinned for a little backlash. */
static double half_tooth(size_t teeth, double radius) {
    double pitch = MODULE * (double)teeth / 2, base = pitch * cos(PI / 9), backlash = 0.06;
    double half = (PI / 2 * MODULE / 2 - backlash) / pitch + involute(PI / 9);
    return half - (radius > base ? involute(acos(base / radius)) : 0);
}

/* A tooth points along the x axis. */
static void gear_outline(outline *o, size_t teeth) {
    enum { FLANK = 5 };
    double pitch = MODULE * (double)teeth / 2, root = pitch - 1.25 * MODULE, tip = pitch + MODULE;
    double foot = half_tooth(teeth, root) + 0.12 / pitch; /* the fillet at the root */
    o->n = 0;
    for (size_t t = 0; t < teeth; t++) {
        double middle = 2 * PI * (double)t / (double)teeth, start = fmax(root + 0.4, pitch * cos(PI / 9));
        add_xy(o, root * cos(middle - foot), root * sin(middle - foot));
        for (size_t i = 0; i < 2 * FLANK; i++) {
            size_t up = i < FLANK ? i : 2 * FLANK - 1 - i;
            double radius = start + (tip - start) * (double)up / (FLANK - 1);
            double angle = middle + (i < FLANK ? -1 : 1) * half_tooth(teeth, radius);
            add_xy(o, radius * cos(angle), radius * sin(angle));
        }
        add_xy(o, root * cos(middle + foot), root * sin(middle + foot));
        double gap = middle + PI / (double)teeth;
        add_xy(o, root * cos(gap), root * sin(gap));
    }
}

/* A side of a gear: on large ones the web is set back and has holes. `rim` and `hub` come back for the other side. */
typedef struct gear_side {
    loop outline_, bore, rim[2], hub[2], holes[6];
} gear_side;

static void gear_face(builder *b, gear_side *g, const outline *teeth, size_t count, double z, double recess, bool up) {
    outline o;
    place(b, &g->outline_, teeth, z);
    circle(&o, 0, 0, SHAFT + 0.15, GEAR_SEGMENTS, 0);
    place(b, &g->bore, &o, z);
    double root = MODULE * (double)count / 2 - 1.25 * MODULE;
    if (root < 24) {
        ring_cap(b, &g->outline_, &g->bore, up);
        return;
    }
    double deep = up ? z - recess : z + recess;
    const loop *inner[7] = {&g->hub[1]};
    for (size_t i = 0; i < 2; i++) {
        circle(&o, 0, 0, root - 3, GEAR_SEGMENTS, 0);
        place(b, &g->rim[i], &o, i ? deep : z);
        circle(&o, 0, 0, SHAFT + 4, GEAR_SEGMENTS, 0);
        place(b, &g->hub[i], &o, i ? deep : z);
    }
    double room = (root - 3 - SHAFT - 4) / 2;
    size_t holes = room > 6 ? 6 : 0;
    for (size_t i = 0; i < holes; i++) {
        double angle = PI / 3 * (double)i, radius = SHAFT + 4 + room;
        circle(&o, radius * cos(angle), radius * sin(angle), room - 2, 24, angle);
        place(b, &g->holes[i], &o, deep);
        inner[i + 1] = &g->holes[i];
    }
    ring_cap(b, &g->outline_, &g->rim[0], up);
    wall(b, up ? &g->rim[0] : &g->rim[1], up ? &g->rim[1] : &g->rim[0]);
    cap(b, &g->rim[1], inner, holes + 1, up);
    wall(b, up ? &g->hub[1] : &g->hub[0], up ? &g->hub[0] : &g->hub[1]);
    ring_cap(b, &g->hub[0], &g->bore, up);
}

static void gear(builder *b, const gear_plan *plan) {
    gear_side *sides = calloc(2, sizeof *sides);
    outline teeth;
    if (!sides) {
        b->failed = true;
        return;
    }
    gear_outline(&teeth, plan->teeth);
    double recess = (plan->z1 - plan->z0) / 4;
    gear_face(b, &sides[0], &teeth, plan->teeth, plan->z0, recess, false);
    gear_face(b, &sides[1], &teeth, plan->teeth, plan->z1, recess, true);
    wall(b, &sides[0].outline_, &sides[1].outline_);
    wall(b, &sides[1].bore, &sides[0].bore);
    for (size_t i = 0; i < 6 && sides[0].holes[i].n > 0; i++)
        wall(b, &sides[1].holes[i], &sides[0].holes[i]);
    free(sides);
}

/* The driver has a tooth on the line to its mate, the mate a gap there. */
static double gear_phase(size_t i) {
    const shaft_plan *own = &SHAFTS[GEAR[i].shaft], *other = &SHAFTS[GEAR[GEAR[i].mate].shaft];
    double toward = atan2(other->y - own->y, other->x - own->x);
    return GEAR[i].mate > i ? toward : toward + PI / (double)GEAR[i].teeth;
}

static bool add_gears(scene *s) {
    bool ok = true;
    for (size_t i = 0; ok && i < GEARS; i++) {
        builder b = {0};
        char name[64];
        double m[16];
        const shaft_plan *shaft = &SHAFTS[GEAR[i].shaft];
        snprintf(name, sizeof name, "gearbox/%s/%s", shaft->name, GEAR[i].name);
        gear(&b, &GEAR[i]);
        turn_z(m, gear_phase(i), shaft->x, shaft->y, 0);
        ok = add(s, name, finish(&b, s, name), m, shaft->color, 1);
    }
    return ok;
}

/* Rings that keep the gears of a shaft apart. */
static bool add_spacers(scene *s) {
    static const double ranges[][3] = {{0, 6, 14},    {0, 30, 40}, {0, 56, 66},  {0, 82, 144},
                                       {1, 6, 15},    {1, 29, 41}, {1, 55, 67},  {1, 81, 104},
                                       {1, 130, 144}, {2, 6, 106}, {2, 128, 144}};
    bool ok = true;
    for (size_t i = 0, number = 1; ok && i < sizeof ranges / sizeof ranges[0]; i++, number++) {
        builder b = {0};
        char name[64];
        double m[16];
        const shaft_plan *shaft = &SHAFTS[(size_t)ranges[i][0]];
        if (i > 0 && ranges[i][0] > ranges[i - 1][0])
            number = 1;
        snprintf(name, sizeof name, "gearbox/%s/spacer_%zu", shaft->name, number);
        tube_z(&b, SHAFT + 0.15, SHAFT + 2.6, ranges[i][1] + GAP, ranges[i][2] - GAP, GEAR_SEGMENTS);
        turn_z(m, 0, shaft->x, shaft->y, 0);
        ok = add(s, name, finish(&b, s, name), m, SAND, 1);
    }
    return ok;
}

/* Thick between the bearings, thinner in them and thinner still where it pokes out; ends are chamfered. */
static bool add_shaft(scene *s, const shaft_plan *plan) {
    builder b = {0};
    profile p = {0};
    double front = plan->front < -20 ? 7 : SEAT, back = plan->back > 180 ? 7 : SEAT, m[16];
    add_rz(&p, 0, plan->front);
    add_rz(&p, front - 1, plan->front);
    add_rz(&p, front, plan->front + 1);
    if (front < SEAT) {
        add_rz(&p, front, -13);
        add_rz(&p, SEAT, -13);
    }
    add_rz(&p, SEAT, 3);
    add_rz(&p, SHAFT, 3);
    add_rz(&p, SHAFT, INSIDE - 3);
    add_rz(&p, SEAT, INSIDE - 3);
    if (back < SEAT) {
        add_rz(&p, SEAT, INSIDE + 13);
        add_rz(&p, back, INSIDE + 13);
    }
    add_rz(&p, back, plan->back - 1);
    add_rz(&p, back - 1, plan->back);
    add_rz(&p, 0, plan->back);
    revolve(&b, &p, GEAR_SEGMENTS, false);
    char name[64];
    snprintf(name, sizeof name, "gearbox/%s/shaft", plan->name);
    turn_z(m, 0, plan->x, plan->y, 0);
    return add(s, name, finish(&b, s, name), m, STEEL, 1);
}

/* Rings with grooves that the balls run in, centred on z = 0. */
static const double BALL = 3, BALL_PITCH = 15, BEARING = 10;

static size_t bearing_ring(scene *s, bool outer) {
    builder b = {0};
    profile p = {0};
    double groove = BALL + 0.2, edge = outer ? BALL_PITCH + 1.8 : BALL_PITCH - 1.8;
    double half = acos(1.8 / groove), middle = outer ? 0 : PI;
    add_rz(&p, outer ? edge : SEAT + 0.15, -BEARING / 2);
    add_rz(&p, outer ? BORE - 0.2 : edge, -BEARING / 2);
    if (!outer)
        add_arc(&p, BALL_PITCH, 0, groove, middle + half, middle - half, 10);
    add_rz(&p, outer ? BORE - 0.2 : edge, BEARING / 2);
    add_rz(&p, outer ? edge : SEAT + 0.15, BEARING / 2);
    if (outer)
        add_arc(&p, BALL_PITCH, 0, groove, middle + half, middle - half, 10);
    revolve(&b, &p, 64, true);
    return finish(&b, s, outer ? "gearbox/outer_ring" : "gearbox/inner_ring");
}

static size_t bearing_balls(scene *s) {
    builder b = {0};
    for (size_t i = 0; i < BALLS; i++) {
        double angle = 2 * PI * (double)i / BALLS;
        sphere(&b, BALL_PITCH * cos(angle), BALL_PITCH * sin(angle), 0, BALL, 20, 12);
    }
    return finish(&b, s, "gearbox/balls");
}

static bool add_bearings(scene *s) {
    static const char *const names[3] = {"outer_ring", "inner_ring", "balls"};
    const float *const colors[3] = {STEEL, STEEL, SLATE};
    size_t meshes[3] = {bearing_ring(s, true), bearing_ring(s, false), bearing_balls(s)};
    bool ok = true;
    for (size_t i = 0; ok && i < 18; i++) {
        const shaft_plan *shaft = &SHAFTS[i / 6];
        bool back = i % 2 == 1;
        size_t piece = i / 2 % 3;
        char name[80];
        double m[16];
        snprintf(name, sizeof name, "gearbox/%s/bearing_%s/%s", shaft->name, back ? "back" : "front", names[piece]);
        turn_z(m, 0.3, shaft->x, shaft->y, back ? INSIDE + GAP + COVER / 2 : -GAP - COVER / 2);
        ok = add(s, name, meshes[piece], m, colors[piece], 1);
    }
    return ok;
}

/* Middle lines of the flange's bolts. */
static void flange_bolt(size_t i, double *x, double *y) {
    static const double at[FLANGE_BOLTS][2] = {{-99, -52}, {-50, -59}, {7, -59},  {64, -59}, {113, -52},
                                               {113, -3},  {113, 43},  {113, 92}, {64, 99},  {7, 99},
                                               {-50, 99},  {-99, 92},  {-99, 43}, {-99, -3}};
    *x = at[i][0];
    *y = at[i][1];
}

static void cap_bolt(const shaft_plan *shaft, size_t i, double *x, double *y) {
    double angle = PI / 4 + PI / 2 * (double)i;
    *x = shaft->x + 24.6 * cos(angle);
    *y = shaft->y + 24.6 * sin(angle);
}

static void flange_outline(outline *o) {
    rounded_rectangle(o, -106, -66, 120, 106, 20);
}

/* The body: a wall all around, open at both ends, each with a flange that the covers are bolted to. */
static void housing_body(builder *b) {
    outline flange, outside, inside, hole;
    loop *l = malloc((8 + 4 * FLANGE_BOLTS) * sizeof *l);
    if (!l) {
        b->failed = true;
        return;
    }
    flange_outline(&flange);
    rounded_rectangle(&outside, -92, -52, 106, 92, 16);
    rounded_rectangle(&inside, -86, -46, 100, 86, 10);
    const double zs[4] = {0, FLANGE, INSIDE - FLANGE, INSIDE};
    loop *holes = l + 8;
    const loop *inner[4][FLANGE_BOLTS + 1];
    for (size_t k = 0; k < 4; k++) {
        place(b, &l[k], &flange, zs[k]);
        place(b, &l[4 + k], k == 0 || k == 3 ? &inside : &outside, zs[k]);
        inner[k][0] = &l[4 + k];
        for (size_t i = 0; i < FLANGE_BOLTS; i++) {
            double x, y;
            flange_bolt(i, &x, &y);
            circle(&hole, x, y, 3.4, 20, 0);
            place(b, &holes[k * FLANGE_BOLTS + i], &hole, zs[k]);
            inner[k][i + 1] = &holes[k * FLANGE_BOLTS + i];
        }
        cap(b, &l[k], inner[k], FLANGE_BOLTS + 1, k % 2 == 1);
    }
    wall(b, &l[0], &l[1]);
    wall(b, &l[2], &l[3]);
    wall(b, &l[5], &l[6]);
    wall(b, &l[7], &l[4]);
    for (size_t i = 0; i < FLANGE_BOLTS; i++) {
        wall(b, &holes[FLANGE_BOLTS + i], &holes[i]);
        wall(b, &holes[3 * FLANGE_BOLTS + i], &holes[2 * FLANGE_BOLTS + i]);
    }
    free(l);
}

static void housing_cover(builder *b, double z0, double z1) {
    enum { HOLES = FLANGE_BOLTS + 3 * (CAP_BOLTS + 1) };
    outline outside, *holes = malloc(HOLES * sizeof *holes);
    if (!holes) {
        b->failed = true;
        return;
    }
    size_t count = 0;
    double x, y;
    flange_outline(&outside);
    for (size_t i = 0; i < FLANGE_BOLTS; i++) {
        flange_bolt(i, &x, &y);
        circle(&holes[count++], x, y, 3.4, 20, 0);
    }
    for (size_t shaft = 0; shaft < 3; shaft++) {
        circle(&holes[count++], SHAFTS[shaft].x, SHAFTS[shaft].y, BORE, 64, 0.3);
        for (size_t i = 0; i < CAP_BOLTS; i++) {
            cap_bolt(&SHAFTS[shaft], i, &x, &y);
            circle(&holes[count++], x, y, 1.5, 12, 0);
        }
    }
    plate(b, &outside, holes, count, z0, z1);
    free(holes);
}

static bool add_housing(scene *s) {
    builder b = {0};
    housing_body(&b);
    bool ok = add_built(&b, s, "gearbox/housing/body", PALE_GREEN, 0.4f);
    housing_cover(&b, -GAP - COVER, -GAP);
    ok = add_built(&b, s, "gearbox/housing/cover_front", PALE_GREEN, 0.4f) && ok;
    housing_cover(&b, INSIDE + GAP, INSIDE + GAP + COVER);
    return add_built(&b, s, "gearbox/housing/cover_back", PALE_GREEN, 0.4f) && ok;
}

/* The head stands on z = 0 with a chamfered top, the shank goes down. */
static size_t bolt(scene *s, const char *name, double head, double height, double shank, double length) {
    builder b = {0};
    outline o;
    loop hexagon[2], top, under, end;
    circle(&o, 0, 0, head, 6, 0);
    place(&b, &hexagon[0], &o, 0);
    place(&b, &hexagon[1], &o, height);
    circle(&o, 0, 0, head * 0.8, 6, 0);
    place(&b, &top, &o, height * 1.12);
    circle(&o, 0, 0, shank, 24, 0);
    place(&b, &under, &o, 0);
    place(&b, &end, &o, -length);
    wall(&b, &hexagon[0], &hexagon[1]);
    wall(&b, &hexagon[1], &top);
    cap(&b, &top, NULL, 0, true);
    ring_cap(&b, &hexagon[0], &under, false);
    wall(&b, &end, &under);
    cap(&b, &end, NULL, 0, false);
    return finish(&b, s, name);
}

/* Bolts point inward: at the front the head looks toward smaller z. */
static void bolt_place(double m[16], double x, double y, double z, bool back) {
    turn_z(m, 0, x, y, z);
    if (!back)
        m[5] = m[10] = -1; /* half a turn about the x axis */
}

static bool add_flange_bolts(scene *s) {
    size_t mesh = bolt(s, "gearbox/bolt", 6, 5, 3, COVER + FLANGE - 2);
    bool ok = mesh != SIZE_MAX;
    for (size_t i = 0; ok && i < 2 * FLANGE_BOLTS; i++) {
        bool back = i >= FLANGE_BOLTS;
        double x, y, m[16];
        char name[64];
        flange_bolt(i % FLANGE_BOLTS, &x, &y);
        bolt_place(m, x, y, back ? INSIDE + 2 * GAP + COVER : -2 * GAP - COVER, back);
        snprintf(name, sizeof name, "gearbox/housing/bolt_%s_%zu", back ? "back" : "front", i % FLANGE_BOLTS + 1);
        ok = add(s, name, mesh, m, DARK_STEEL, 1);
    }
    return ok;
}

/* Discs that hold the bearings in; where the shaft pokes out they have a hole. */
static size_t bearing_cap(scene *s, bool open) {
    builder b = {0};
    outline outside, holes[CAP_BOLTS + 1];
    static const shaft_plan middle = {0};
    circle(&outside, 0, 0, 27, 64, 0);
    for (size_t i = 0; i < CAP_BOLTS; i++) {
        double x, y;
        cap_bolt(&middle, i, &x, &y);
        circle(&holes[i], x, y, 1.5, 12, 0);
    }
    circle(&holes[CAP_BOLTS], 0, 0, 7.6, GEAR_SEGMENTS, 0);
    plate(&b, &outside, holes, open ? CAP_BOLTS + 1 : CAP_BOLTS, -2, 2);
    return finish(&b, s, open ? "gearbox/cap_open" : "gearbox/cap_closed");
}

static bool add_cap_bolts(scene *s, const shaft_plan *shaft, bool back, size_t mesh) {
    bool ok = true;
    for (size_t i = 0; ok && i < CAP_BOLTS; i++) {
        double x, y, m[16];
        char name[80];
        cap_bolt(shaft, i, &x, &y);
        bolt_place(m, x, y, back ? INSIDE + 3 * GAP + COVER + 4 : -3 * GAP - COVER - 4, back);
        snprintf(name, sizeof name, "gearbox/%s/cap_%s_bolt_%zu", shaft->name, back ? "back" : "front", i + 1);
        ok = add(s, name, mesh, m, DARK_STEEL, 1);
    }
    return ok;
}

static bool add_bearing_caps(scene *s) {
    size_t meshes[2] = {bearing_cap(s, false), bearing_cap(s, true)};
    size_t small = bolt(s, "gearbox/cap_bolt", 2.2, 2, 1.2, 14);
    bool ok = true;
    for (size_t i = 0; ok && i < 6; i++) {
        const shaft_plan *shaft = &SHAFTS[i / 2];
        bool back = i % 2 == 1, open = back ? shaft->back > 180 : shaft->front < -20;
        double m[16];
        char name[64];
        snprintf(name, sizeof name, "gearbox/%s/cap_%s", shaft->name, back ? "back" : "front");
        turn_z(m, 0, shaft->x, shaft->y, back ? INSIDE + 2 * GAP + COVER + 2 : -2 * GAP - COVER - 2);
        ok = add(s, name, meshes[open], m, SLATE, 1) && small != SIZE_MAX && add_cap_bolts(s, shaft, back, small);
    }
    return ok;
}

static bool make_gearbox(scene *s) {
    bool ok = add_housing(s) && add_gears(s) && add_spacers(s);
    for (size_t i = 0; ok && i < 3; i++)
        ok = add_shaft(s, &SHAFTS[i]);
    ok = ok && add_bearings(s) && add_flange_bolts(s) && add_bearing_caps(s);
    lay_down(s);
    return ok;
}

/* ---- smaller ones ---------------------------------------------------------------------------------------- */

/* The middle line goes three times around the axis while it winds twice around the torus. */
static void knot_point(double t, double p[3]) {
    double around = 3 * t, wind = 2 * t, r = 30 + 12 * cos(around);
    p[0] = r * cos(wind);
    p[1] = r * sin(wind);
    p[2] = 12 * sin(around);
}

static void unit(double v[3]) {
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (size_t i = 0; i < 3; i++)
        v[i] /= length;
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (size_t i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* The frame comes from the curve's place on the torus, so the last ring meets the first without a twist left over. */
static void knot_ring(builder *b, loop *ring, double t, double radius, size_t n) {
    double p[3], ahead[3], out[3], side[3], along[3];
    knot_point(t, p);
    knot_point(t + 1e-4, ahead);
    for (size_t i = 0; i < 3; i++)
        along[i] = ahead[i] - p[i];
    unit(along);
    out[0] = cos(3 * t) * cos(2 * t);
    out[1] = cos(3 * t) * sin(2 * t);
    out[2] = sin(3 * t);
    cross(along, out, side);
    unit(side);
    cross(side, along, out);
    ring->n = n;
    for (size_t i = 0; i < n; i++) {
        double angle = 2 * PI * (double)i / (double)n, u = radius * cos(angle), v = radius * sin(angle);
        ring->v[i] =
            point(b, p[0] + u * out[0] + v * side[0], p[1] + u * out[1] + v * side[1], p[2] + u * out[2] + v * side[2]);
    }
}

static bool make_torus_knot(scene *s) {
    enum { STEPS = 400, AROUND = 32 };
    builder b = {0};
    loop first, previous, next;
    knot_ring(&b, &first, 0, 6, AROUND);
    previous = first;
    for (size_t i = 1; i < STEPS; i++) {
        knot_ring(&b, &next, 2 * PI * (double)i / STEPS, 6, AROUND);
        wall(&b, &previous, &next);
        previous = next;
    }
    wall(&b, &previous, &first);
    return add_built(&b, s, "torus_knot", TEAL, 1);
}

static bool make_shells(scene *s) {
    builder b = {0};
    sphere(&b, 0, 0, 0, 50, 96, 64);
    bool ok = add_built(&b, s, "shells/outer", GLASS_BLUE, 0.4f);
    sphere(&b, 0, 0, 0, 37, 80, 48);
    ok = add_built(&b, s, "shells/middle", PALE_GREEN, 0.4f) && ok;
    sphere(&b, 0, 0, 0, 24, 64, 40);
    ok = add_built(&b, s, "shells/inner", SAND, 0.4f) && ok;
    box(&b, (double[3]){-8, -8, -8}, (double[3]){8, 8, 8});
    double turned[16];
    turn_z(turned, 0.5, 0, 0, 0);
    return add(s, "shells/core", finish(&b, s, "shells/core"), turned, BRICK, 1) && ok;
}

/* ---- sheets: surfaces without an inside ------------------------------------------------------------------- */

static bool add_sheet(builder *b, scene *s, const char *name, const float color[3]) {
    bool ok = add_built(b, s, name, color, 0.4f);
    if (ok)
        s->meshes[s->mesh_count - 1].two_sided = true;
    return ok;
}

/* A grid of points as a sheet; i runs fastest. */
static void weave(builder *b, uint32_t first, size_t columns, size_t rows) {
    for (size_t j = 0; j + 1 < rows; j++)
        for (size_t i = 0; i + 1 < columns; i++) {
            uint32_t p = first + (uint32_t)(j * columns + i), q = p + (uint32_t)columns;
            quad(b, p, p + 1, q + 1, q);
        }
}

/* Figure 3 of Carnecky 2013: one square before another, upright, a quarter of each on top of the other. */
static bool make_squares(scene *s) {
    static const double corner[2][3] = {{-40, 10, -10}, {-10, -10, -40}};
    static const char *const names[2] = {"squares/behind", "squares/before"};
    bool ok = true;
    for (size_t i = 0; i < 2; i++) {
        builder b = {0};
        uint32_t first = (uint32_t)b.points;
        for (size_t k = 0; k < 4; k++)
            point(&b, corner[i][0] + (k % 2 ? 50 : 0), corner[i][1], corner[i][2] + (k / 2 ? 50 : 0));
        weave(&b, first, 2, 2);
        ok = add_sheet(&b, s, names[i], i ? TEAL : BRICK) && ok;
    }
    return ok;
}

/* Figure 2 of Carnecky 2013: their silhouettes are lines along the walls and the rims at both ends. */
static bool make_cylinders(scene *s) {
    static const double radius[2] = {40, 22}, height[2] = {36, 50};
    static const char *const names[2] = {"cylinders/outer", "cylinders/inner"};
    bool ok = true;
    for (size_t i = 0; i < 2; i++) {
        builder b = {0};
        loop lower, upper;
        profile_ring(&b, &lower, radius[i], -height[i], 128);
        profile_ring(&b, &upper, radius[i], height[i], 128);
        ring_wall(&b, &lower, &upper);
        ok = add_sheet(&b, s, names[i], i ? BRICK : GLASS_BLUE) && ok;
    }
    return ok;
}

/* Figure 11 of Carnecky 2013: flat and curved, one in the other. */
static bool make_cube_and_sphere(scene *s) {
    builder b = {0};
    box(&b, (double[3]){-40, -40, -40}, (double[3]){40, 40, 40});
    bool ok = add_built(&b, s, "cube_and_sphere/cube", GLASS_BLUE, 0.4f);
    sphere(&b, 0, 0, 0, 30, 96, 64);
    return add_built(&b, s, "cube_and_sphere/sphere", BRICK, 0.4f) && ok;
}

/* The bottle whose neck goes through its own side (the usual immersion; its tube has radius 4 (1 - cos(u) / 2)). */
static void bottle_point(builder *b, double u, double v) {
    double r = 4 * (1 - cos(u) / 2), x = 6 * cos(u) * (1 + sin(u)), z = 16 * sin(u);
    if (u < PI) {
        x += r * cos(u) * cos(v);
        z += r * sin(u) * cos(v);
    } else {
        x -= r * cos(v);
    }
    point(b, 2.4 * x, 2.4 * r * sin(v), 2.4 * z);
}

static bool make_klein_bottle(scene *s) {
    enum { STEPS = 240, AROUND = 96 };
    builder b = {0};
    for (size_t j = 0; j < STEPS; j++)
        for (size_t i = 0; i < AROUND; i++)
            bottle_point(&b, 2 * PI * (double)j / STEPS, 2 * PI * (double)i / AROUND);
    for (size_t j = 0; j < STEPS; j++)
        for (size_t i = 0; i < AROUND; i++) {
            size_t across = (i + 1) % AROUND, next = j + 1, to = i, to_across = across;
            if (next == STEPS) { /* the end meets the start turned over */
                next = 0;
                to = (AROUND + AROUND / 2 - i) % AROUND;
                to_across = (AROUND + AROUND / 2 - across) % AROUND;
            }
            quad(&b, (uint32_t)(j * AROUND + i), (uint32_t)(j * AROUND + across), (uint32_t)(next * AROUND + to_across),
                 (uint32_t)(next * AROUND + to));
        }
    return add_sheet(&b, s, "klein_bottle", TEAL);
}

/* Three eddies side by side, one above the other in phase, and a stream that carries everything along x: what is let go
 * along an upright line is rolled up into scrolls that grow downstream. */
static void flow(const double p[3], double v[3]) {
    static const double eddy[3][4] = {{12, 15, 9, 1}, {-14, -11, 11, -1}, {6, -34, 8, 0.7}}; /* y, z, size, turn */
    v[0] = 12;
    v[1] = 1.5 * sin(0.05 * p[0]);
    v[2] = 1.5 * cos(0.04 * p[0] + 0.03 * p[1]);
    for (size_t i = 0; i < 3; i++) {
        double y = p[1] - eddy[i][0] - 4 * sin(0.03 * p[0] + (double)i), z = p[2] - eddy[i][1];
        double size = eddy[i][2] * (1 + 0.004 * p[0]), square = (y * y + z * z) / (size * size);
        double spin = 0.75 * eddy[i][3] * exp(-square / 2);
        v[1] += -spin * z;
        v[2] += spin * y;
    }
}

static void follow(double p[3], double time) {
    double k[4][3], at[3];
    static const double ahead[4] = {0, 0.5, 0.5, 1};
    for (size_t n = 0; n < 4; n++) { /* Runge and Kutta's fourth order */
        for (size_t i = 0; i < 3; i++)
            at[i] = p[i] + (n ? ahead[n] * time * k[n - 1][i] : 0);
        flow(at, k[n]);
    }
    for (size_t i = 0; i < 3; i++)
        p[i] += time / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
}

/* Figure 12 of Carnecky 2013: the surface that all particles sweep that pass one line. */
static bool make_stream_surface(scene *s) {
    enum { SEEDS = 480, STEPS = 160 };
    builder b = {0};
    double(*p)[3] = malloc(SEEDS * sizeof *p);
    if (!p)
        return false;
    for (size_t i = 0; i < SEEDS; i++) {
        double along = (double)i / (SEEDS - 1) - 0.5;
        p[i][0] = -75;
        p[i][1] = 6 * sin(5 * along);
        p[i][2] = 84 * along;
    }
    for (size_t j = 0; j < STEPS; j++)
        for (size_t i = 0; i < SEEDS; i++) {
            point(&b, p[i][0], p[i][1], p[i][2]);
            follow(p[i], 12.5 / (STEPS - 1));
        }
    free(p);
    weave(&b, 0, SEEDS, STEPS);
    return add_sheet(&b, s, "stream_surface", OCHRE);
}

/* ---- dirty ones ------------------------------------------------------------------------------------------ */

/* The half of a sphere above its middle, with nothing to close it. */
static void half_sphere(builder *b, double radius, size_t segments, size_t rings) {
    profile p = {0};
    for (size_t i = 0; i <= rings; i++)
        add_rz(&p, i == rings ? 0 : radius * cos(PI / 2 * (double)i / (double)rings),
               radius * sin(PI / 2 * (double)i / (double)rings));
    revolve(b, &p, segments, false);
}

static bool make_dirty_open(scene *s) {
    builder b = {0};
    half_sphere(&b, 40, 64, 20);
    bool ok = add_built(&b, s, "dirty_open/outer_half", GLASS_BLUE, 0.4f);
    half_sphere(&b, 30, 48, 16);
    ok = add_built(&b, s, "dirty_open/inner_half", PALE_GREEN, 0.4f) && ok;
    loop low, high;
    profile_ring(&b, &low, 12, -20, 48);
    profile_ring(&b, &high, 12, 14, 48);
    wall(&b, &low, &high);
    ok = add_built(&b, s, "dirty_open/sleeve", OCHRE, 1) && ok;
    box(&b, (double[3]){-5, -5, -12}, (double[3]){5, 5, 20});
    return add_built(&b, s, "dirty_open/box", BRICK, 1) && ok;
}

static void double_faces(builder *b) {
    for (size_t i = 0, n = b->corners; i + 2 < n; i += 3)
        triangle(b, b->indices[i], b->indices[i + 2], b->indices[i + 1]);
}

static bool make_dirty_doubled(scene *s) {
    builder b = {0};
    sphere(&b, 0, 0, 0, 30, 48, 32);
    double_faces(&b);
    bool ok = add_built(&b, s, "dirty_doubled/sphere", GLASS_BLUE, 0.4f);
    box(&b, (double[3]){-12, -10, -14}, (double[3]){12, 10, 14});
    double_faces(&b);
    ok = add_built(&b, s, "dirty_doubled/box", BRICK, 1) && ok;
    gear(&b, &GEAR[5]);
    double_faces(&b);
    double aside[16];
    turn_z(aside, 0, 70, 0, -74);
    return add(s, "dirty_doubled/gear", finish(&b, s, "dirty_doubled/gear"), aside, BRASS, 1) && ok;
}

static void middle_of(const builder *b, uint32_t p, uint32_t q, double out[3]) {
    for (size_t i = 0; i < 3; i++)
        out[i] = (coordinate(b, p, i) + coordinate(b, q, i)) / 2;
}

/* Every other triangle gets a companion without area, and every fifth is cut in two at the middle of an edge, which the
 * triangle on the other side of that edge knows nothing of. */
static void degenerate_faces(builder *b) {
    for (size_t i = 0, n = b->corners; i + 2 < n; i += 3) {
        uint32_t p = b->indices[i], q = b->indices[i + 1], r = b->indices[i + 2];
        double m[3];
        middle_of(b, p, q, m);
        if (i % 2 == 0)
            triangle(b, p, q, i % 4 == 0 ? q : p);
        if (i / 3 % 5 == 0) {
            uint32_t middle = point(b, m[0], m[1], m[2]);
            b->indices[i + 1] = middle;
            triangle(b, middle, q, r);
        } else if (i / 3 % 7 == 0) {
            triangle(b, p, point(b, m[0], m[1], m[2]), q);
        }
    }
}

static bool make_dirty_degenerate(scene *s) {
    builder b = {0};
    sphere(&b, 0, 0, 0, 30, 48, 32);
    degenerate_faces(&b);
    bool ok = add_built(&b, s, "dirty_degenerate/sphere", GLASS_BLUE, 0.4f);
    box(&b, (double[3]){-12, -10, -14}, (double[3]){12, 10, 14});
    degenerate_faces(&b);
    return add_built(&b, s, "dirty_degenerate/box", BRICK, 1) && ok;
}

/* Three sheets on one edge, two boxes that share an edge, and a box with a wall across its inside. */
static bool make_dirty_nonmanifold(scene *s) {
    builder b = {0};
    uint32_t low = point(&b, 0, 0, -20), high = point(&b, 0, 0, 20);
    for (size_t i = 0; i < 3; i++) {
        double angle = 2 * PI * (double)i / 3, x = 25 * cos(angle), y = 25 * sin(angle);
        quad(&b, low, point(&b, x, y, -20), point(&b, x, y, 20), high);
    }
    bool ok = add_built(&b, s, "dirty_nonmanifold/fins", GLASS_BLUE, 0.4f);
    box(&b, (double[3]){40, 0, -20}, (double[3]){60, 20, 20});
    box(&b, (double[3]){60, -20, -20}, (double[3]){80, 0, 20});
    ok = add_built(&b, s, "dirty_nonmanifold/touching_boxes", BRICK, 1) && ok;
    box(&b, (double[3]){-80, -15, -20}, (double[3]){-40, 15, 20});
    uint32_t v[4];
    for (size_t i = 0; i < 4; i++) /* its edges lie on those of the box, so each of these has three triangles */
        v[i] = point(&b, i == 0 || i == 3 ? -80 : -40, i < 2 ? -15 : 15, i < 2 ? -20 : 20);
    quad(&b, v[0], v[1], v[2], v[3]);
    return add_built(&b, s, "dirty_nonmanifold/walled_box", PALE_GREEN, 0.4f) && ok;
}

/* Runs of triangles turned inside out, as modellers and converters leave them. */
static void flip_faces(builder *b, size_t run, size_t period) {
    for (size_t i = 0; i + 2 < b->corners; i += 3) {
        uint32_t second = b->indices[i + 1];
        if (i / 3 % period < run) {
            b->indices[i + 1] = b->indices[i + 2];
            b->indices[i + 2] = second;
        }
    }
}

static bool make_dirty_flipped(scene *s) {
    builder b = {0};
    sphere(&b, 0, 0, 0, 30, 48, 32);
    flip_faces(&b, 40, 330);
    bool ok = add_built(&b, s, "dirty_flipped/sphere", GLASS_BLUE, 0.4f);
    box(&b, (double[3]){-12, -10, -14}, (double[3]){12, 10, 14});
    flip_faces(&b, 2, 6);
    return add_built(&b, s, "dirty_flipped/box", BRICK, 1) && ok;
}

/* ---- scenes ---------------------------------------------------------------------------------------------- */

/* Moves what a battlefield consists of to a scene; its flags and units are for programs that make it themselves. */
static bool take_scene(scene *s, battlefield *b) {
    if (!b)
        return false;
    scene empty = *s;
    *s = *b->scene;
    *b->scene = empty;
    battlefield_destroy(b);
    return true;
}

static bool make_battlefield(scene *s) {
    return take_scene(s, battlefield_create(NULL));
}

static bool make_abstract(scene *s) {
    return take_scene(s, battlefield_create_abstract(1));
}

static bool make_walkthrough(scene *s) {
    return take_scene(s, battlefield_create_walkthrough(1));
}

/* ---- by name --------------------------------------------------------------------------------------------- */

const char *const models_names[] = {"mug",
                                    "crank",
                                    "gearbox",
                                    "torus_knot",
                                    "shells",
                                    "squares",
                                    "cylinders",
                                    "cube_and_sphere",
                                    "klein_bottle",
                                    "stream_surface",
                                    "dirty_open",
                                    "dirty_doubled",
                                    "dirty_degenerate",
                                    "dirty_nonmanifold",
                                    "dirty_flipped",
                                    "battlefield",
                                    "abstract",
                                    "walkthrough",
                                    NULL};

scene *models_make(const char *name) {
    static bool (*const makers[])(scene *) = {
        make_mug,         make_crank,         make_gearbox,          make_torus_knot,        make_shells,
        make_squares,     make_cylinders,     make_cube_and_sphere,  make_klein_bottle,      make_stream_surface,
        make_dirty_open,  make_dirty_doubled, make_dirty_degenerate, make_dirty_nonmanifold, make_dirty_flipped,
        make_battlefield, make_abstract,      make_walkthrough};
    for (size_t i = 0; models_names[i]; i++) {
        if (strcmp(models_names[i], name) != 0)
            continue;
        scene *s = scene_create();
        if (s && makers[i](s))
            return s;
        scene_destroy(s);
    }
    return NULL;
}

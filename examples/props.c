#include "props.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

/* Colours are clear, but never at full strength. */
static const float BARK[3] = {0.46f, 0.36f, 0.28f};
static const float NEEDLES[3] = {0.28f, 0.46f, 0.36f};
static const float NEEDLE_TIPS[3] = {0.46f, 0.64f, 0.44f};
static const float LEAVES[3] = {0.36f, 0.52f, 0.28f};
static const float LEAF_TIPS[3] = {0.62f, 0.72f, 0.36f};
static const float MEADOW[3] = {0.58f, 0.66f, 0.40f};
static const float STONE[3] = {0.60f, 0.60f, 0.58f};
static const float STONE_TOP[3] = {0.74f, 0.73f, 0.68f};
static const float RUBBER[3] = {0.30f, 0.30f, 0.32f};
static const float METAL[3] = {0.46f, 0.47f, 0.50f};
static const float SKIN[3] = {0.84f, 0.66f, 0.54f};
static const float LEATHER[3] = {0.36f, 0.29f, 0.24f};
static const float CONCRETE[3] = {0.66f, 0.66f, 0.63f};
static const float CONCRETE_SIDE[3] = {0.56f, 0.56f, 0.55f};
static const float SLIT[3] = {0.24f, 0.25f, 0.28f};
static const float PANE[3] = {0.40f, 0.52f, 0.62f};
static const float FRAME[3] = {0.86f, 0.84f, 0.78f};
static const float WOOD[3] = {0.70f, 0.54f, 0.36f};
static const float DARK_WOOD[3] = {0.50f, 0.37f, 0.26f};
static const float CLOTH[3] = {0.42f, 0.52f, 0.66f};
static const float SHADE[3] = {0.88f, 0.80f, 0.58f};
static const float CLAY[3] = {0.76f, 0.46f, 0.34f};
static const float FUR[3] = {0.78f, 0.58f, 0.36f};
static const float CAR_RED[3] = {0.74f, 0.34f, 0.30f};

/* ---- chance ---------------------------------------------------------------------------------------------- */

/* Xorshift after a multiplication that spreads small seeds: any seed but a multiple of 2^32 will do. */
uint32_t dice_throw(dice *d) {
    uint32_t x = d->state ? d->state : 0x9e3779b9u;
    x ^= x << 13;
    x ^= x >> 17;
    x ^= x << 5;
    d->state = x;
    return x * 0x9e3779b1u;
}

double dice_between(dice *d, double low, double high) {
    return low + (high - low) * (double)(dice_throw(d) >> 8) / 16777216.0;
}

static dice new_dice(uint32_t seed) {
    dice d = {seed * 2654435761u + 12345u};
    dice_throw(&d);
    return d;
}

/* ---- a mesh being built ---------------------------------------------------------------------------------- */

/* Triangles with three points and colours each; equal ones are shared at the end. Shells go into one another freely, but
 * never with faces in one plane: these would flicker. */
typedef struct builder {
    float *positions, *colors;
    size_t corners, room;
    float color[3], upper[3]; /* the colour at heights `from` and `to`, mixed between */
    double from, to;
    bool failed;
} builder;

static void paint(builder *b, const float color[3]) {
    memcpy(b->color, color, sizeof b->color);
    memcpy(b->upper, color, sizeof b->upper);
    b->from = 0;
    b->to = 1;
}

static void paint_fade(builder *b, const float color[3], const float upper[3], double from, double to) {
    memcpy(b->color, color, sizeof b->color);
    memcpy(b->upper, upper, sizeof b->upper);
    b->from = from;
    b->to = to;
}

static void paint_shade(builder *b, const float color[3], double factor) {
    float shaded[3];
    for (size_t k = 0; k < 3; k++)
        shaded[k] = (float)fmin(fmax((double)color[k] * factor, 0.21), 0.89);
    paint(b, shaded);
}

static bool make_room(builder *b) {
    if (b->failed || b->corners + 3 <= b->room)
        return !b->failed;
    size_t room = 2 * b->room + 768;
    float *positions = realloc(b->positions, 3 * room * sizeof *positions);
    b->positions = positions ? positions : b->positions;
    float *colors = realloc(b->colors, 3 * room * sizeof *colors);
    b->colors = colors ? colors : b->colors;
    b->failed = !positions || !colors;
    b->room = b->failed ? b->room : room;
    return !b->failed;
}

static bool same(const double a[3], const double b[3]) {
    return (float)a[0] == (float)b[0] && (float)a[1] == (float)b[1] && (float)a[2] == (float)b[2];
}

/* Without those that have no area because two corners are one. */
static void triangle(builder *b, const double p[3], const double q[3], const double r[3]) {
    const double *v[3] = {p, q, r};
    if (same(p, q) || same(q, r) || same(r, p) || !make_room(b))
        return;
    for (size_t i = 0; i < 3; i++, b->corners++) {
        double t = fmin(fmax((v[i][2] - b->from) / (b->to - b->from), 0), 1);
        for (size_t k = 0; k < 3; k++) {
            b->positions[3 * b->corners + k] = (float)v[i][k];
            b->colors[3 * b->corners + k] = b->color[k] + (b->upper[k] - b->color[k]) * (float)t;
        }
    }
}

static void quad(builder *b, const double p[3], const double q[3], const double r[3], const double s[3]) {
    triangle(b, p, q, r);
    triangle(b, p, r, s);
}

static size_t finish(builder *b, scene *s, const char *name) {
    scene_mesh mesh = {.positions = b->positions, .colors = b->colors, .vertex_count = b->corners};
    mesh.index_count = b->corners;
    mesh.indices = malloc((b->corners + 1) * sizeof *mesh.indices);
    for (size_t i = 0; mesh.indices && i < b->corners; i++)
        mesh.indices[i] = (uint32_t)i;
    bool ok = !b->failed && mesh.indices && scene_mesh_make_normals(&mesh, SCENE_CREASE_DEGREES);
    if (ok)
        return scene_add_mesh(s, name, &mesh);
    free(mesh.positions);
    free(mesh.normals);
    free(mesh.colors);
    free(mesh.indices);
    return SIZE_MAX;
}

/* ---- solids ---------------------------------------------------------------------------------------------- */

enum { RING = 32, RINGS = 24 };

/* Rings of n points, counter-clockwise seen from where they lead to, with flat ends. */
typedef struct loft {
    size_t n, rings;
    double p[RINGS][RING][3];
} loft;

static void add_ring(loft *l, double (*points)[3], size_t n) {
    l->n = n;
    memcpy(l->p[l->rings++], points, n * sizeof *points);
}

static void build_loft(builder *b, const loft *l) {
    size_t last = l->rings - 1;
    for (size_t k = 0; k < last; k++)
        for (size_t i = 0; i < l->n; i++) {
            size_t j = (i + 1) % l->n;
            quad(b, l->p[k][i], l->p[k][j], l->p[k + 1][j], l->p[k + 1][i]);
        }
    for (size_t i = 1; i + 1 < l->n; i++) {
        triangle(b, l->p[0][0], l->p[0][i + 1], l->p[0][i]);
        triangle(b, l->p[last][0], l->p[last][i], l->p[last][i + 1]);
    }
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (size_t i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double normalise(double v[3]) {
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (size_t i = 0; i < 3; i++)
        v[i] /= length;
    return length;
}

/* Turned on a lathe along the line from a to b: radius and the share of the way, pair by pair. The ends may be points. */
static void lathe(builder *b, const double from[3], const double to[3], const double (*profile)[2], size_t count,
                  size_t sides) {
    double along[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]}, u[3] = {0, 0, 0}, v[3];
    double axis[3] = {along[0], along[1], along[2]};
    normalise(axis);
    u[fabs(axis[2]) > 0.9 ? 0 : 2] = 1;
    cross(axis, u, v);
    normalise(v);
    cross(v, axis, u);
    loft l = {.n = sides};
    for (size_t k = 0; k < count; k++) {
        double ring[RING][3];
        for (size_t i = 0; i < sides; i++) {
            double angle = 2 * PI * (double)i / (double)sides, c = profile[k][0] * cos(angle),
                   d = profile[k][0] * sin(angle);
            for (size_t x = 0; x < 3; x++)
                ring[i][x] = from[x] + profile[k][1] * along[x] + c * u[x] + d * v[x];
        }
        add_ring(&l, ring, sides);
    }
    build_loft(b, &l);
}

static void rod(builder *b, double x0, double y0, double z0, double x1, double y1, double z1, double r0, double r1,
                size_t sides) {
    const double from[3] = {x0, y0, z0}, to[3] = {x1, y1, z1}, profile[2][2] = {{r0, 0}, {r1, 1}};
    lathe(b, from, to, profile, 2, sides);
}

/* A rod with a chamfer at both ends. */
static void wheel(builder *b, double x, double y0, double y1, double z, double radius, size_t sides) {
    const double from[3] = {x, y0, z}, to[3] = {x, y1, z}, c = 0.12;
    const double profile[4][2] = {{radius * 0.86, 0}, {radius, c}, {radius, 1 - c}, {radius * 0.86, 1}};
    lathe(b, from, to, profile, 4, sides);
}

/* A limb with round ends, from joint to joint. */
static void limb(builder *b, const double from[3], const double to[3], double r0, double r1, size_t sides) {
    double d[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]}, length = normalise(d);
    double a = r0 / length, c = r1 / length, h = sqrt(0.5);
    const double profile[6][2] = {{0, -a * 0.9}, {r0 * h, -a * 0.6},    {r0, 0},
                                  {r1, 1},       {r1 * h, 1 + c * 0.6}, {0, 1 + c * 0.9}};
    lathe(b, from, to, profile, 6, sides);
}

/* A box with chamfered upright and upper edges; c = 0: sharp ones, else c is below a quarter of its width. */
static void block(builder *b, double x0, double y0, double z0, double x1, double y1, double z1, double c) {
    loft l = {.n = 8};
    for (size_t k = 0; k < (c > 0 ? 3u : 2u); k++) {
        double in = k == 2 ? c : 0, z = k == 0 ? z0 : (k == 2 ? z1 : z1 - c);
        double a = x0 + in, d = x1 - in, e = y0 + in, f = y1 - in;
        double ring[8][3] = {{a + c, e, z}, {d - c, e, z}, {d, e + c, z}, {d, f - c, z},
                             {d - c, f, z}, {a + c, f, z}, {a, f - c, z}, {a, e + c, z}};
        double sharp[4][3] = {{a, e, z}, {d, e, z}, {d, f, z}, {a, f, z}};
        add_ring(&l, c > 0 ? ring : sharp, c > 0 ? 8 : 4);
    }
    build_loft(b, &l);
}

/* A side view, convex and counter-clockwise in x and z, from y0 to y1, its rims chamfered by c. */
static void slice(builder *b, const double (*side)[2], size_t n, double y0, double y1, double c) {
    loft l = {.n = n};
    double middle[2] = {0, 0};
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < 2; k++)
            middle[k] += side[i][k] / (double)n;
    for (size_t k = 0; k < (c > 0 ? 4u : 2u); k++) {
        bool rim = c > 0 && (k == 0 || k == 3);
        double y = c > 0 ? (k == 0 ? y1 : k == 1 ? y1 - c : k == 2 ? y0 + c : y0) : (k == 0 ? y1 : y0), ring[RING][3];
        for (size_t i = 0; i < n; i++) {
            double d[2] = {side[i][0] - middle[0], side[i][1] - middle[1]}, away = hypot(d[0], d[1]);
            double shrink = rim ? 1 - c / away : 1;
            ring[i][0] = middle[0] + d[0] * shrink;
            ring[i][1] = y;
            ring[i][2] = middle[1] + d[1] * shrink;
        }
        add_ring(&l, ring, n);
    }
    build_loft(b, &l);
}

/* ---- round things ---------------------------------------------------------------------------------------- */

/* Smooth bumps: the sum of a few waves in directions of their own. */
typedef struct bumps {
    double direction[5][3], phase[5], size;
} bumps;

static bumps make_bumps(dice *d, double waves, double size) {
    bumps made = {.size = size};
    for (size_t i = 0; i < 5; i++) {
        for (size_t k = 0; k < 3; k++)
            made.direction[i][k] = dice_between(d, -waves, waves);
        made.phase[i] = dice_between(d, 0, 2 * PI);
    }
    return made;
}

static double bump_at(const bumps *b, const double p[3]) {
    double sum = 0;
    for (size_t i = 0; i < 5; i++)
        sum += sin(b->direction[i][0] * p[0] + b->direction[i][1] * p[1] + b->direction[i][2] * p[2] + b->phase[i]);
    return 1 + b->size * sum / 5;
}

/* A corner of an icosahedron's face cut into steps x steps triangles, on the sphere, out to the bumpy surface. */
static void geodesic_point(const double corners[3][3], size_t i, size_t j, size_t steps, const double middle[3],
                           const double radius[3], const bumps *shape, double out[3]) {
    double a = (double)(steps - i - j), c = (double)i, e = (double)j, p[3];
    for (size_t k = 0; k < 3; k++)
        p[k] = a * corners[0][k] + c * corners[1][k] + e * corners[2][k];
    normalise(p);
    for (size_t k = 0; k < 3; k++)
        p[k] = round(p[k] * 1e9) / 1e9; /* the same point from either side of an edge */
    double size = shape ? bump_at(shape, p) : 1;
    for (size_t k = 0; k < 3; k++)
        out[k] = middle[k] + radius[k] * size * p[k];
}

static void blob(builder *b, const double middle[3], const double radius[3], size_t steps, const bumps *shape) {
    static const unsigned char faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                               {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                               {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                               {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    const double g = (1 + sqrt(5)) / 2;
    const double v[12][3] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                             {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (size_t f = 0; f < 20; f++) {
        double corners[3][3], p[4][3];
        for (size_t k = 0; k < 3; k++)
            memcpy(corners[k], v[faces[f][k]], sizeof corners[k]);
        for (size_t i = 0; i < steps; i++)
            for (size_t j = 0; i + j < steps; j++) {
                geodesic_point((const double(*)[3])corners, i, j, steps, middle, radius, shape, p[0]);
                geodesic_point((const double(*)[3])corners, i + 1, j, steps, middle, radius, shape, p[1]);
                geodesic_point((const double(*)[3])corners, i, j + 1, steps, middle, radius, shape, p[2]);
                triangle(b, p[0], p[1], p[2]);
                if (i + j + 1 < steps) {
                    geodesic_point((const double(*)[3])corners, i + 1, j + 1, steps, middle, radius, shape, p[3]);
                    triangle(b, p[1], p[3], p[2]);
                }
            }
    }
}

static void ball(builder *b, double x, double y, double z, double rx, double ry, double rz, size_t steps) {
    const double middle[3] = {x, y, z}, radius[3] = {rx, ry, rz};
    blob(b, middle, radius, steps, NULL);
}

/* ---- plants and rocks ------------------------------------------------------------------------------------ */

static void trunk(builder *b, double height, double radius) {
    const double from[3] = {0, 0, -0.6}, to[3] = {0, 0, height};
    const double profile[4][2] = {{radius * 1.7, 0}, {radius * 1.15, 0.25}, {radius, 0.5}, {radius * 0.6, 1}};
    paint_fade(b, BARK, STONE, 0, 3 * height);
    lathe(b, from, to, profile, 4, 11); /* eleven sides are round, ten have creases */
}

/* One skirt of branches: a tip above, a ragged rim, hollow below. */
static void skirt(builder *b, dice *d, double z, double radius, double rise) {
    enum { POINTS = 16 };
    double rim[POINTS][3], tip[3] = {0, 0, z + rise}, below[3] = {0, 0, z + 0.3 * rise};
    double turn = dice_between(d, 0, PI);
    for (size_t i = 0; i < POINTS; i++) {
        double angle = turn + 2 * PI * (double)i / POINTS, r = radius * (i % 2 ? 0.74 : 1) * dice_between(d, 0.9, 1.08);
        rim[i][0] = r * cos(angle);
        rim[i][1] = r * sin(angle);
        rim[i][2] = z + (i % 2 ? 0.13 : 0) * rise + dice_between(d, -0.03, 0.03) * rise;
    }
    paint_fade(b, NEEDLES, NEEDLE_TIPS, z, z + 1.3 * rise);
    for (size_t i = 0; i < POINTS; i++)
        triangle(b, tip, rim[i], rim[(i + 1) % POINTS]);
    paint_shade(b, NEEDLES, 0.8);
    for (size_t i = 0; i < POINTS; i++)
        triangle(b, below, rim[(i + 1) % POINTS], rim[i]);
}

size_t prop_conifer(scene *s, const char *name, double height, uint32_t seed) {
    enum { SKIRTS = 5 };
    builder b = {0};
    dice d = new_dice(seed);
    trunk(&b, 0.4 * height, 0.024 * height);
    for (size_t i = 0; i < SKIRTS; i++) {
        double t = (double)i / (SKIRTS - 1), radius = height * (0.25 - 0.155 * t) * dice_between(&d, 0.94, 1.06);
        skirt(&b, &d, height * (0.14 + 0.62 * t), radius, height * (0.30 - 0.06 * t));
    }
    return finish(&b, s, name);
}

/* A trunk that forks, and a crown of five bumpy masses, the lower ones darker. */
size_t prop_broadleaf(scene *s, const char *name, double height, uint32_t seed) {
    enum { MASSES = 5 };
    builder b = {0};
    dice d = new_dice(seed);
    trunk(&b, 0.5 * height, 0.03 * height);
    double turn = dice_between(&d, 0, 2 * PI);
    for (size_t i = 0; i < MASSES; i++) {
        double angle = turn + 2 * PI * (double)i / (MASSES - 1), out = i + 1 < MASSES ? 0.17 * height : 0;
        double size = height * (i + 1 < MASSES ? dice_between(&d, 0.17, 0.22) : 0.26);
        double middle[3] = {out * cos(angle), out * sin(angle),
                            height * (i + 1 < MASSES ? dice_between(&d, 0.5, 0.66) : 0.74)};
        double radius[3] = {size * dice_between(&d, 0.95, 1.1), size * dice_between(&d, 0.95, 1.1),
                            size * dice_between(&d, 0.84, 0.96)};
        bumps shape = make_bumps(&d, 5, 0.16);
        if (i + 1 < MASSES) {
            paint_shade(&b, BARK, 0.95);
            rod(&b, 0.01, 0.01 * (double)i, 0.34 * height, 0.8 * middle[0], 0.8 * middle[1], middle[2], 0.017 * height,
                0.008 * height, 5);
        }
        paint_fade(&b, LEAVES, LEAF_TIPS, 0.42 * height, 1.02 * height);
        blob(&b, middle, radius, 3, &shape);
    }
    return finish(&b, s, name);
}

size_t prop_bush(scene *s, const char *name, double height, uint32_t seed) {
    builder b = {0};
    dice d = new_dice(seed);
    for (size_t i = 0; i < 3; i++) {
        double angle = 2.2 * (double)i, size = height * dice_between(&d, 0.45, 0.6);
        double middle[3] = {0.5 * height * cos(angle), 0.5 * height * sin(angle), 0.4 * height};
        double radius[3] = {size, size, size * 0.9};
        bumps shape = make_bumps(&d, 5, 0.18);
        paint_fade(&b, LEAVES, LEAF_TIPS, 0, 1.1 * height);
        blob(&b, middle, radius, 3, &shape);
    }
    return finish(&b, s, name);
}

size_t prop_rock(scene *s, const char *name, double size, uint32_t seed) {
    builder b = {0};
    dice d = new_dice(seed);
    const double middle[3] = {0, 0, 0.2 * size};
    double radius[3] = {size * dice_between(&d, 0.8, 1.2), size * dice_between(&d, 0.6, 0.9), 0.6 * size};
    bumps shape = make_bumps(&d, 5, 0.6);
    paint_fade(&b, STONE, STONE_TOP, 0, size);
    blob(&b, middle, radius, 4, &shape);
    return finish(&b, s, name);
}

/* ---- tank ------------------------------------------------------------------------------------------------ */

/* Turns what was built since `first` about the upright line through (x, 0). Equal points stay equal. */
static void turn_since(builder *b, size_t first, double x, double angle) {
    for (size_t i = first; i < b->corners && !b->failed; i++) {
        float *p = &b->positions[3 * i];
        double px = (double)p[0] - x, py = (double)p[1];
        p[0] = (float)(x + px * cos(angle) - py * sin(angle));
        p[1] = (float)(px * sin(angle) + py * cos(angle));
    }
}

static void tank_track(builder *b, double side) {
    static const double belt[8][2] = {{-3.32, 0.52}, {-3.2, 0.3}, {-2.7, 0.02}, {2.5, 0.02},
                                      {3.15, 0.36},  {3.3, 0.62}, {3.1, 0.86},  {-3.12, 0.86}};
    double y0 = side * 1.42 - 0.32, y1 = side * 1.42 + 0.32, face = side * 1.75;
    paint(b, RUBBER);
    slice(b, belt, 8, y0, y1, 0.05);
    for (int i = 0; i < 7; i++) { /* sprocket, five road wheels, idler */
        bool end = i == 0 || i == 6;
        double x = -2.78 + 0.93 * i, radius = end ? 0.27 : 0.38, z = end ? 0.52 : 0.41;
        paint(b, METAL);
        wheel(b, x, side > 0 ? face - 0.2 : face - 0.06, side > 0 ? face + 0.06 : face + 0.2, z, radius, 14);
        paint_shade(b, METAL, 0.7);
        wheel(b, x, side > 0 ? face - 0.1 : face - 0.11, side > 0 ? face + 0.11 : face + 0.1, z, radius * 0.4, 8);
    }
}

static void tank_hull(builder *b, const float color[3]) {
    static const double tub[8][2] = {{-3.0, 0.42}, {2.3, 0.42},  {3.0, 0.78},  {3.12, 0.98},
                                     {1.75, 1.5},  {-2.7, 1.52}, {-3.15, 1.3}, {-3.18, 0.7}};
    static const double fender[6][2] = {{-3.42, 0.92}, {3.1, 0.91}, {3.48, 0.74},
                                        {3.52, 0.8},   {3.14, 1.0}, {-3.42, 1.01}};
    paint(b, color);
    slice(b, tub, 8, -1.13, 1.13, 0.07);
    for (int side = -1; side <= 1; side += 2) {
        paint_shade(b, color, 0.92);
        slice(b, fender, 6, side * 1.45 - 0.37, side * 1.45 + 0.37, 0);
        paint_shade(b, color, 0.84); /* stowage on the fenders, a grille behind, lamps before */
        block(b, -2.9, side * 1.46 - 0.26, 0.97, -1.5, side * 1.46 + 0.26, 1.36, 0.05);
        block(b, -1.2, side * 1.48 - 0.22, 0.97, 0.1, side * 1.48 + 0.22, 1.24, 0.04);
        rod(b, 2.2, side * 1.2, 1.12, 2.55, side * 1.2, 1.12, 0.11, 0.13, 10);
    }
    for (int i = 0; i < 5; i++) {
        paint_shade(b, color, 0.7);
        block(b, -2.62 + 0.24 * i, -0.8, 1.45, -2.5 + 0.24 * i, 0.8, 1.57, 0.02);
    }
    paint_shade(b, color, 0.86);
    rod(b, 1.2, 0.55, 1.4, 1.2, 0.55, 1.6, 0.3, 0.27, 12); /* the driver's hatch */
}

/* Sections of the turret, each a ring of ten points: broad behind, a wedge before. */
static void tank_turret_body(builder *b) {
    static const double outline[10][2] = {{1.5, -0.42}, {1.5, 0.42},  {0.9, 1.0},    {-0.2, 1.22},  {-1.5, 1.02},
                                          {-2.0, 0.7},  {-2.0, -0.7}, {-1.5, -1.02}, {-0.2, -1.22}, {0.9, -1.0}};
    static const double levels[4][3] = {{1.42, 0.84, 0}, {1.62, 1, 0}, {2.02, 0.94, -0.06}, {2.2, 0.72, -0.16}};
    loft l = {.n = 10};
    for (size_t k = 0; k < 4; k++) {
        double ring[10][3];
        for (size_t i = 0; i < 10; i++) {
            ring[i][0] = 0.1 + outline[i][0] * levels[k][1] + levels[k][2];
            ring[i][1] = outline[i][1] * levels[k][1];
            ring[i][2] = levels[k][0];
        }
        add_ring(&l, ring, 10);
    }
    build_loft(b, &l);
}

static void tank_gun(builder *b, const float color[3]) {
    static const double barrel[10][2] = {{0.13, 0},    {0.13, 0.34}, {0.17, 0.36}, {0.17, 0.5}, {0.11, 0.52},
                                         {0.09, 0.88}, {0.13, 0.89}, {0.13, 0.99}, {0.10, 1.0}, {0, 0.985}};
    const double from[3] = {1.2, 0, 1.86}, to[3] = {5.3, 0, 1.98};
    static const double mantlet[6][2] = {{1.3, 1.6},   {1.66, 1.62}, {1.86, 1.78},
                                         {1.84, 1.98}, {1.6, 2.12},  {1.25, 2.1}};
    paint_shade(b, color, 0.88);
    slice(b, mantlet, 6, -0.38, 0.38, 0.05);
    paint_shade(b, color, 0.78);
    lathe(b, from, to, barrel, 10, 12);
}

size_t prop_tank(scene *s, const char *name, const float color[3], double turret_angle) {
    builder b = {0};
    tank_track(&b, -1);
    tank_track(&b, 1);
    tank_hull(&b, color);
    size_t first = b.corners;
    paint_shade(&b, color, 0.8);
    rod(&b, 0.1, 0, 1.3, 0.1, 0, 1.47, 1.0, 1.0, 20);
    paint_shade(&b, color, 1.06);
    tank_turret_body(&b);
    tank_gun(&b, color);
    paint_shade(&b, color, 0.9); /* cupola, loader's hatch, bustle rack, aerial */
    rod(&b, -0.35, -0.42, 2.1, -0.35, -0.42, 2.42, 0.36, 0.33, 14);
    paint_shade(&b, color, 0.72);
    rod(&b, -0.35, -0.42, 2.3, -0.35, -0.42, 2.5, 0.24, 0.2, 12);
    rod(&b, -0.3, 0.5, 2.1, -0.3, 0.5, 2.29, 0.3, 0.28, 14);
    block(&b, -2.35, -0.78, 1.66, -1.85, 0.78, 2.0, 0.05);
    rod(&b, -1.6, 0.75, 1.9, -1.75, 0.8, 4.0, 0.03, 0.012, 5);
    turn_since(&b, first, 0.1, turret_angle);
    return finish(&b, s, name);
}

/* ---- soldier --------------------------------------------------------------------------------------------- */

static void soldier_leg(builder *b, double side, double stride, const float color[3]) {
    double y = 0.11 * side, swing = 0.34 * stride * side, lift = swing < 0 ? -0.35 * swing : 0;
    double hip[3] = {0, y, 0.92}, knee[3] = {0.5 * swing + 0.06, y * 1.1, 0.5 + 0.3 * lift},
           ankle[3] = {swing - 0.02, y * 1.1, 0.13 + lift};
    paint_shade(b, color, 0.82);
    limb(b, hip, knee, 0.115, 0.085, 11);
    limb(b, knee, ankle, 0.087, 0.065, 11);
    paint(b, LEATHER);
    ball(b, ankle[0] + 0.06, ankle[1], ankle[2] - 0.06, 0.15, 0.065, 0.07, 2);
}

static void soldier_arms(builder *b, const float color[3]) {
    static const double right[3][3] = {{0, -0.24, 1.4}, {0.02, -0.3, 1.14}, {0.26, -0.13, 1.16}};
    static const double left[3][3] = {{0, 0.24, 1.4}, {0.2, 0.26, 1.17}, {0.46, 0.02, 1.26}};
    const double(*arms[2])[3] = {right, left};
    for (size_t i = 0; i < 2; i++) {
        paint_shade(b, color, 0.94);
        limb(b, arms[i][0], arms[i][1], 0.075, 0.06, 11);
        limb(b, arms[i][1], arms[i][2], 0.061, 0.05, 11);
        paint(b, SKIN);
        ball(b, arms[i][2][0] + 0.03, arms[i][2][1], arms[i][2][2], 0.055, 0.05, 0.05, 2);
    }
    paint(b, RUBBER); /* a rifle from the right hip to the left hand and on */
    rod(b, -0.02, -0.19, 1.13, 0.5, 0.0, 1.28, 0.035, 0.03, 6);
    rod(b, 0.44, -0.02, 1.27, 0.86, 0.13, 1.37, 0.016, 0.014, 6);
    rod(b, 0.26, -0.09, 1.21, 0.29, -0.08, 1.05, 0.022, 0.02, 6);
}

size_t prop_soldier(scene *s, const char *name, const float color[3], double stride) {
    static const double chest[6][2] = {{0.1, 0}, {0.16, 0.12}, {0.165, 0.45}, {0.2, 0.8}, {0.15, 0.95}, {0.07, 1.02}};
    static const double helmet[6][2] = {{0.1, 0}, {0.185, 0}, {0.17, 0.2}, {0.14, 0.6}, {0.08, 0.88}, {0, 1}};
    builder b = {0};
    const double waist[3] = {0, 0, 0.88}, neck[3] = {0.03, 0, 1.5}, brow[3] = {0.02, 0, 1.68},
                 crown[3] = {0.01, 0, 1.86};
    soldier_leg(&b, -1, stride, color);
    soldier_leg(&b, 1, stride, color);
    paint(&b, color);
    lathe(&b, waist, neck, chest, 6, 12);
    paint_shade(&b, color, 0.72); /* belt, vest, pack */
    rod(&b, 0, 0, 0.93, 0, 0, 1.0, 0.175, 0.18, 12);
    block(&b, -0.34, -0.17, 1.08, -0.12, 0.17, 1.5, 0.05);
    block(&b, 0.1, -0.15, 1.12, 0.23, 0.15, 1.34, 0.03);
    soldier_arms(&b, color);
    paint(&b, SKIN);
    rod(&b, 0.02, 0, 1.44, 0.03, 0, 1.6, 0.06, 0.06, 8);
    ball(&b, 0.03, 0, 1.66, 0.105, 0.09, 0.125, 3);
    paint_shade(&b, color, 0.88);
    lathe(&b, brow, crown, helmet, 6, 12);
    return finish(&b, s, name);
}

/* ---- buildings ------------------------------------------------------------------------------------------- */

/* Concrete, eight-sided, with a slit all around below an overhanging lid. */
size_t prop_bunker(scene *s, const char *name) {
    static const double body[4][2] = {{4.4, 0}, {3.9, 0.62}, {3.1, 0.62}, {3.1, 1}};
    static const double lid[5][2] = {{3.0, 0}, {4.15, 0.02}, {4.2, 0.3}, {3.5, 0.72}, {1.6, 1}};
    builder b = {0};
    const double low[3] = {0, 0, -0.8}, middle[3] = {0, 0, 2.02}, under[3] = {0, 0, 1.88}, top[3] = {0, 0, 2.9};
    paint_fade(&b, CONCRETE_SIDE, CONCRETE, 0, 2);
    lathe(&b, low, middle, body, 4, 8);
    paint(&b, SLIT);
    rod(&b, 0, 0, 1.0, 0, 0, 1.95, 3.25, 3.25, 8);
    paint_fade(&b, CONCRETE_SIDE, CONCRETE, 1.9, 2.7);
    lathe(&b, under, top, lid, 5, 8);
    paint(&b, METAL);
    rod(&b, 0.8, 0.6, 2.7, 0.8, 0.6, 3.15, 0.5, 0.45, 12);
    return finish(&b, s, name);
}

/* Where the cuts of a wall are along one axis. */
static size_t add_cut(double *cuts, size_t count, double at) {
    size_t i = count;
    for (size_t k = 0; k < count; k++)
        if (fabs(cuts[k] - at) < 1e-9)
            return count;
    for (; i > 0 && cuts[i - 1] > at; i--)
        cuts[i] = cuts[i - 1];
    cuts[i] = at;
    return count + 1;
}

enum { CUTS = 24 };

static bool is_open(double x, double z, const prop_opening *openings, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (fabs(x - openings[i].x) < openings[i].width / 2 && z > openings[i].z &&
            z < openings[i].z + openings[i].height)
            return true;
    return false;
}

/* One side of a cell of the wall, facing along (dx, dy, dz). */
static void wall_face(builder *b, const double low[3], const double high[3], int axis, bool upper) {
    double p[4][3];
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int i = 0; i < 4; i++) {
        bool at_u = i == 1 || i == 2, at_v = i >= 2;
        p[i][axis] = upper ? high[axis] : low[axis];
        p[i][u] = at_u ? high[u] : low[u];
        p[i][v] = at_v ? high[v] : low[v];
    }
    if (upper)
        quad(b, p[0], p[1], p[2], p[3]);
    else
        quad(b, p[0], p[3], p[2], p[1]);
}

/* The wall as a grid of cells, cut where openings begin and end; faces only toward open cells and the outside. */
static void wall_cells(builder *b, double length, double height, double thickness, const prop_opening *openings,
                       size_t count) {
    double xs[CUTS] = {0, length}, zs[CUTS] = {0, height};
    size_t nx = 2, nz = 2;
    for (size_t i = 0; i < count; i++) {
        nx = add_cut(xs, nx, openings[i].x - openings[i].width / 2);
        nx = add_cut(xs, nx, openings[i].x + openings[i].width / 2);
        nz = add_cut(zs, nz, fmax(openings[i].z, 0));
        nz = add_cut(zs, nz, openings[i].z + openings[i].height);
    }
    for (size_t i = 0; i + 1 < nx; i++)
        for (size_t k = 0; k + 1 < nz; k++) {
            double low[3] = {xs[i], 0, zs[k]}, high[3] = {xs[i + 1], thickness, zs[k + 1]};
            double x = (low[0] + high[0]) / 2, z = (low[2] + high[2]) / 2;
            if (is_open(x, z, openings, count))
                continue;
            for (int side = 0; side < 2; side++) {
                size_t beside = side ? i + 1 : i - 1, above = side ? k + 1 : k - 1;
                bool end_x = side ? i + 2 == nx : i == 0, end_z = side ? k + 2 == nz : k == 0;
                wall_face(b, low, high, 1, side != 0);
                if (end_x || is_open((xs[beside] + xs[beside + 1]) / 2, z, openings, count))
                    wall_face(b, low, high, 0, side != 0);
                if (end_z || is_open(x, (zs[above] + zs[above + 1]) / 2, openings, count))
                    wall_face(b, low, high, 2, side != 0);
            }
        }
}

/* Pane, frame and sill go into the wall on all sides, so that no face lies in another's plane. */
static void wall_window(builder *b, const prop_opening *o, double thickness) {
    double x0 = o->x - o->width / 2, x1 = o->x + o->width / 2, z0 = o->z, z1 = o->z + o->height, y = 0.5 * thickness;
    paint(b, PANE);
    block(b, x0 - 0.04, y - 0.02, z0 - 0.04, x1 + 0.04, y + 0.02, z1 + 0.04, 0);
    paint(b, FRAME);
    block(b, o->x - 0.035, y - 0.05, z0 - 0.03, o->x + 0.035, y + 0.05, z1 + 0.03, 0);
    block(b, x0 - 0.03, y - 0.045, z0 + 0.55 * o->height, x1 + 0.03, y + 0.045, z0 + 0.55 * o->height + 0.06, 0);
    block(b, x0 - 0.12, -0.09, z0 - 0.12, x1 + 0.12, y, z0 + 0.015, 0);
    block(b, x0 - 0.1, -0.05, z1 - 0.015, x1 + 0.1, 0.6 * y, z1 + 0.13, 0);
}

size_t prop_wall(scene *s, const char *name, const float color[3], double length, double height, double thickness,
                 double gable, const prop_opening *openings, size_t opening_count) {
    builder b = {0};
    if (2 * opening_count + 2 > CUTS)
        return SIZE_MAX;
    paint_shade(&b, color, 1);
    wall_cells(&b, length, height, thickness, openings, opening_count);
    if (gable > 0) {
        double g = 0.012, slope = 2 * gable / length, side = g + 0.02;
        const double outline[5][2] = {{side, height - 0.15},
                                      {length - side, height - 0.15},
                                      {length - side, height + slope * side},
                                      {length / 2, height + gable},
                                      {side, height + slope * side}};
        slice(&b, outline, 5, g, thickness - g, 0);
        paint(&b, DARK_WOOD);
        rod(&b, length / 2, -0.03, height + 0.42 * gable, length / 2, 0.5 * thickness, height + 0.42 * gable,
            0.13 * gable, 0.13 * gable, 12);
    }
    for (size_t i = 0; i < opening_count; i++)
        if (!openings[i].door)
            wall_window(&b, &openings[i], thickness);
    return finish(&b, s, name);
}

/* Courses of tiles: each a board that lies a little steeper than the roof on the end of the one below. */
size_t prop_roof(scene *s, const char *name, const float color[3], double length, double width, double rise) {
    enum { COURSES = 7 };
    builder b = {0};
    double half = width / 2, slope = hypot(half, rise), ux = half / slope, uz = rise / slope;
    for (int side = -1; side <= 1; side += 2)
        for (int i = 0; i < COURSES; i++) {
            double low = (double)i / COURSES - 0.02, high = (double)(i + 1) / COURSES + 0.03;
            double t0 = low * slope, t1 = fmin(high, 0.995) * slope, thick = 0.13;
            /* y and z of the board's section, from the eave up; the lower end stands proud by 6 cm */
            double y0 = half - t0 * ux, z0 = t0 * uz, y1 = half - t1 * ux, z1 = t1 * uz;
            double section[4][2] = {{y0 + uz * 0.06, z0 + ux * 0.06},
                                    {y0 + uz * (0.06 + thick), z0 + ux * (0.06 + thick)},
                                    {y1 + uz * thick, z1 + ux * thick},
                                    {y1, z1}};
            loft l = {.n = 4};
            double end = length / 2 - 0.012 * (i % 2);
            for (int k = 0; k < 2; k++) {
                double ring[4][3];
                for (int c = 0; c < 4; c++) {
                    int from = side > 0 ? c : 3 - c;
                    ring[c][0] = k ? end : -end;
                    ring[c][1] = side * section[from][0];
                    ring[c][2] = section[from][1];
                }
                add_ring(&l, ring, 4);
            }
            paint_shade(&b, color, 0.93 + 0.14 * (i * 5 % 7) / 6);
            build_loft(&b, &l);
        }
    paint_shade(&b, color, 0.8);
    rod(&b, -length / 2 - 0.05, 0, rise + 0.09, length / 2 + 0.05, 0, rise + 0.09, 0.17, 0.17, 10);
    paint(&b, CLAY);
    block(&b, 0.22 * length - 0.4, 0.16 * width - 0.35, 0.4 * rise, 0.22 * length + 0.4, 0.16 * width + 0.35,
          rise + 0.75, 0.03);
    paint(&b, STONE);
    block(&b, 0.22 * length - 0.5, 0.16 * width - 0.45, rise + 0.62, 0.22 * length + 0.5, 0.16 * width + 0.45,
          rise + 0.86, 0.04);
    return finish(&b, s, name);
}

/* ---- the paper's shapes ---------------------------------------------------------------------------------- */

static const float PLAIN[3] = {0.7f, 0.7f, 0.7f};

/* Without colours of its own: the parts have them. */
static size_t finish_plain(builder *b, scene *s, const char *name) {
    size_t mesh = finish(b, s, name);
    if (mesh != SIZE_MAX) {
        free(s->meshes[mesh].colors);
        s->meshes[mesh].colors = NULL;
    }
    return mesh;
}

size_t prop_ball(scene *s, const char *name, double size) {
    builder b = {0};
    paint(&b, PLAIN);
    ball(&b, 0, 0, 0, size / 2, size / 2, size / 2, 6);
    return finish_plain(&b, s, name);
}

size_t prop_cone(scene *s, const char *name, double size) {
    builder b = {0};
    paint(&b, PLAIN);
    rod(&b, 0, 0, -size / 2, 0, 0, size / 2, size / 2, 0.01 * size, 28); /* a point has no normal */
    return finish_plain(&b, s, name);
}

size_t prop_cube(scene *s, const char *name, double size) {
    builder b = {0};
    double h = 0.43 * size;
    paint(&b, PLAIN);
    block(&b, -h, -h, -h, h, h, h, 0);
    return finish_plain(&b, s, name);
}

size_t prop_torus(scene *s, const char *name, double size) {
    enum { AROUND = 32, TUBE = 16 };
    builder b = {0};
    paint(&b, PLAIN);
    for (size_t i = 0; i < AROUND; i++)
        for (size_t j = 0; j < TUBE; j++) {
            double p[4][3];
            for (size_t k = 0; k < 4; k++) {
                double u = 2 * PI * (double)((i + (k == 1 || k == 2)) % AROUND) / AROUND;
                double v = 2 * PI * (double)((j + (k >= 2)) % TUBE) / TUBE, r = size * (0.38 + 0.15 * cos(v));
                p[k][0] = r * cos(u);
                p[k][1] = r * sin(u);
                p[k][2] = size * 0.15 * sin(v);
            }
            quad(&b, p[0], p[1], p[2], p[3]);
        }
    return finish_plain(&b, s, name);
}

/* ---- what stands in rooms -------------------------------------------------------------------------------- */

static void four_legs(builder *b, double x, double y, double top, double radius) {
    for (int i = 0; i < 4; i++) {
        double at[2] = {i % 2 ? x : -x, i / 2 ? y : -y};
        rod(b, at[0] * 1.06, at[1] * 1.06, 0, at[0], at[1], top, radius * 0.75, radius, 11);
    }
}

size_t prop_table(scene *s, const char *name) {
    static const double bowl[6][2] = {{0.06, 0}, {0.14, 0.3}, {0.17, 1}, {0.155, 1}, {0.12, 0.4}, {0, 0.25}};
    builder b = {0};
    const double low[3] = {0.2, 0.1, 0.74}, high[3] = {0.2, 0.1, 0.85};
    paint(&b, DARK_WOOD);
    four_legs(&b, 0.62, 0.34, 0.71, 0.04);
    block(&b, -0.62, -0.34, 0.6, 0.62, 0.34, 0.705, 0);
    paint(&b, WOOD);
    block(&b, -0.75, -0.45, 0.7, 0.75, 0.45, 0.75, 0.02);
    paint(&b, CLAY);
    lathe(&b, low, high, bowl, 6, 16);
    return finish(&b, s, name);
}

size_t prop_chair(scene *s, const char *name) {
    builder b = {0};
    paint(&b, DARK_WOOD);
    four_legs(&b, 0.2, 0.2, 0.44, 0.025);
    rod(&b, -0.2, -0.19, 0.4, -0.3, -0.19, 0.98, 0.022, 0.02, 11);
    rod(&b, -0.2, 0.19, 0.4, -0.3, 0.19, 0.98, 0.022, 0.02, 11);
    paint(&b, WOOD);
    block(&b, -0.24, -0.24, 0.42, 0.24, 0.24, 0.465, 0.015);
    block(&b, -0.31, -0.23, 0.68, -0.25, 0.23, 0.96, 0.012);
    paint(&b, CLOTH);
    block(&b, -0.2, -0.2, 0.455, 0.21, 0.2, 0.51, 0.025);
    return finish(&b, s, name);
}

size_t prop_shelf(scene *s, const char *name) {
    static const float covers[3][3] = {{0.68f, 0.36f, 0.30f}, {0.36f, 0.50f, 0.60f}, {0.78f, 0.66f, 0.40f}};
    builder b = {0};
    dice d = new_dice(7);
    paint(&b, WOOD);
    block(&b, -0.2, -0.5, 0, 0.2, -0.46, 1.9, 0);
    block(&b, -0.2, 0.46, 0, 0.2, 0.5, 1.9, 0);
    paint_shade(&b, WOOD, 0.85);
    block(&b, -0.195, -0.48, 0.05, -0.17, 0.48, 1.88, 0);
    for (int i = 0; i < 5; i++)
        block(&b, -0.19, -0.47, 0.06 + 0.45 * i, 0.19, 0.47, 0.09 + 0.45 * i, 0);
    for (int i = 0; i < 4; i++)
        for (double y = -0.43; y < 0.36;) {
            double wide = dice_between(&d, 0.04, 0.09), high = dice_between(&d, 0.24, 0.34);
            paint(&b, covers[dice_throw(&d) % 3]);
            block(&b, -0.15, y, 0.08 + 0.45 * i, dice_between(&d, 0.1, 0.15), y + wide - 0.006, 0.09 + high + 0.45 * i,
                  0);
            y += wide;
        }
    return finish(&b, s, name);
}

size_t prop_lamp(scene *s, const char *name) {
    static const double foot[4][2] = {{0.2, 0}, {0.2, 0.3}, {0.05, 0.8}, {0.02, 1}};
    static const double shade[4][2] = {{0.27, 0}, {0.15, 1}, {0.14, 0.99}, {0.25, 0.03}};
    builder b = {0};
    const double low[3] = {0, 0, 0}, high[3] = {0, 0, 0.1}, from[3] = {0, 0, 1.35}, to[3] = {0, 0, 1.72};
    paint(&b, METAL);
    lathe(&b, low, high, foot, 4, 20);
    rod(&b, 0, 0, 0.05, 0, 0, 1.62, 0.018, 0.018, 8);
    paint(&b, SHADE);
    lathe(&b, from, to, shade, 4, 20); /* a skirt with a thin floor */
    return finish(&b, s, name);
}

size_t prop_plant(scene *s, const char *name) {
    static const double pot[5][2] = {{0.13, 0}, {0.19, 0.85}, {0.21, 0.86}, {0.21, 1}, {0.17, 1}};
    builder b = {0};
    const double low[3] = {0, 0, 0}, high[3] = {0, 0, 0.36};
    paint(&b, CLAY);
    lathe(&b, low, high, pot, 5, 18);
    for (int i = 0; i < 11; i++) { /* leaves like blades, in two rounds */
        double angle = 2.4 * i, out = i % 2 ? 0.42 : 0.26, top = i % 2 ? 0.8 : 1.12;
        double c = cos(angle), d = sin(angle);
        const double root[3] = {0.03 * c, 0.03 * d, 0.33}, bend[3] = {0.6 * out * c, 0.6 * out * d, top};
        const double tip[3] = {1.15 * out * c, 1.15 * out * d, top - 0.12};
        paint_fade(&b, LEAVES, LEAF_TIPS, 0.3, 1.2);
        limb(&b, root, bend, 0.02, 0.045, 6);
        limb(&b, bend, tip, 0.046, 0.012, 6);
    }
    return finish(&b, s, name);
}

size_t prop_cat(scene *s, const char *name) {
    static const double joints[5][2][3] = {{{-0.16, 0, 0.25}, {0.14, 0, 0.27}},
                                           {{0.15, 0.05, 0.24}, {0.17, 0.055, 0.03}},
                                           {{0.13, -0.05, 0.24}, {0.2, -0.055, 0.03}},
                                           {{-0.15, 0.06, 0.22}, {-0.2, 0.065, 0.03}},
                                           {{-0.15, -0.06, 0.22}, {-0.14, -0.065, 0.03}}};
    builder b = {0};
    for (size_t i = 0; i < 5; i++) {
        paint_shade(&b, FUR, i == 0 ? 1 : 0.92);
        limb(&b, joints[i][0], joints[i][1], i == 0 ? 0.1 : 0.042, i == 0 ? 0.09 : 0.03, 11);
    }
    paint_shade(&b, FUR, 1.05);
    ball(&b, 0.26, 0, 0.38, 0.085, 0.075, 0.075, 3);
    rod(&b, 0.25, 0.045, 0.41, 0.245, 0.06, 0.5, 0.032, 0, 6);
    rod(&b, 0.25, -0.045, 0.41, 0.245, -0.06, 0.5, 0.032, 0, 6);
    const double tail[4][3] = {{-0.2, 0, 0.28}, {-0.34, 0.02, 0.3}, {-0.42, 0.03, 0.42}, {-0.4, 0.03, 0.56}};
    for (size_t i = 0; i < 3; i++)
        limb(&b, tail[i], tail[i + 1], 0.028 - 0.004 * (double)i, 0.024 - 0.004 * (double)i, 11);
    return finish(&b, s, name);
}

/* A toy car, 1.3 m long. */
size_t prop_car(scene *s, const char *name) {
    static const double body[8][2] = {{-0.64, 0.16}, {0.62, 0.16}, {0.68, 0.24}, {0.66, 0.36},
                                      {0.3, 0.42},   {-0.5, 0.44}, {-0.66, 0.4}, {-0.69, 0.24}};
    static const double cabin[4][2] = {{-0.48, 0.4}, {0.34, 0.38}, {0.1, 0.64}, {-0.38, 0.65}};
    builder b = {0};
    paint(&b, CAR_RED);
    slice(&b, body, 8, -0.28, 0.28, 0.05);
    paint(&b, PANE);
    slice(&b, cabin, 4, -0.24, 0.24, 0.06);
    paint_shade(&b, CAR_RED, 1.08);
    block(&b, -0.36, -0.19, 0.6, 0.08, 0.19, 0.68, 0.02);
    for (int i = 0; i < 4; i++) {
        double x = i % 2 ? 0.4 : -0.42, y = i / 2 ? 0.28 : -0.28;
        paint(&b, RUBBER);
        wheel(&b, x, y - 0.055, y + 0.055, 0.14, 0.14, 16);
        paint(&b, FRAME);
        wheel(&b, x, y - 0.065, y + 0.065, 0.14, 0.07, 10);
    }
    paint(&b, SHADE);
    ball(&b, 0.66, 0.18, 0.31, 0.04, 0.05, 0.05, 2);
    ball(&b, 0.66, -0.18, 0.31, 0.04, 0.05, 0.05, 2);
    return finish(&b, s, name);
}

/* ---- ground ---------------------------------------------------------------------------------------------- */

static void ground_cell(builder *b, const double (*p)[3], void (*color_at)(double, double, float[3])) {
    static const int corners[2][3] = {{0, 1, 2}, {0, 2, 3}};
    for (size_t t = 0; t < 2; t++) {
        double middle[2] = {0, 0};
        float color[3];
        for (size_t i = 0; i < 3; i++)
            for (size_t k = 0; k < 2; k++)
                middle[k] += p[corners[t][i]][k] / 3;
        color_at(middle[0], middle[1], color);
        paint(b, color);
        triangle(b, p[corners[t][0]], p[corners[t][1]], p[corners[t][2]]);
    }
}

size_t prop_ground(scene *s, const char *name, double size, size_t steps, double (*height)(double x, double y),
                   void (*color_at)(double x, double y, float color[3])) {
    builder b = {0};
    double cell = size / (double)steps, floor_z = -2.5, rim[4][3];
    for (size_t i = 0; i < steps; i++)
        for (size_t j = 0; j < steps; j++) {
            double p[4][3];
            for (size_t k = 0; k < 4; k++) {
                p[k][0] = ((double)(i + (k == 1 || k == 2)) - 0.5 * (double)steps) * cell;
                p[k][1] = ((double)(j + (k >= 2)) - 0.5 * (double)steps) * cell;
                p[k][2] = height(p[k][0], p[k][1]);
            }
            ground_cell(&b, (const double(*)[3])p, color_at);
        }
    paint_fade(&b, BARK, WOOD, floor_z, 0.5);
    for (size_t side = 0; side < 4; side++)
        for (size_t i = 0; i < steps; i++) { /* counter-clockwise around the square, floor below */
            double t[2] = {((double)i - 0.5 * (double)steps) * cell, ((double)(i + 1) - 0.5 * (double)steps) * cell};
            double half = 0.5 * (double)steps * cell;
            for (size_t k = 0; k < 4; k++) {
                double along = t[k == 1 || k == 2], sign = side < 2 ? 1 : -1;
                rim[k][side % 2] = sign * along;
                rim[k][1 - side % 2] = (side % 2 ? 1 : -1) * sign * half;
                rim[k][2] = k < 2 ? floor_z : height(rim[k][0], rim[k][1]);
            }
            quad(&b, rim[0], rim[1], rim[2], rim[3]);
            const double middle[3] = {0, 0, floor_z};
            triangle(&b, middle, rim[1], rim[0]);
        }
    return finish(&b, s, name);
}

double prop_hill_height(double share, double peak) {
    double t = share * share;
    return t < 1 ? peak * (1 - t) * (1 - t) - 1.5 * t * t : -1.5;
}

size_t prop_hill(scene *s, const char *name, double radius, double peak) {
    enum { AROUND = 40, STEPS = 10 };
    builder b = {0};
    double p[4][3];
    paint_fade(&b, MEADOW, LEAF_TIPS, 0, 1.4 * peak);
    for (size_t i = 0; i < AROUND; i++)
        for (size_t j = 0; j < STEPS; j++) {
            for (size_t k = 0; k < 4; k++) {
                double angle = 2 * PI * (double)((i + (k >= 2)) % AROUND) / AROUND;
                double share = (double)(j + (k == 1 || k == 2)) / STEPS;
                p[k][0] = radius * share * cos(angle);
                p[k][1] = radius * share * sin(angle);
                p[k][2] = prop_hill_height(share, peak);
            }
            quad(&b, p[0], p[1], p[2], p[3]);
            const double below[3] = {0, 0, -2};
            if (j + 1 == STEPS)
                triangle(&b, below, p[2], p[1]);
        }
    return finish(&b, s, name);
}

size_t prop_slab(scene *s, const char *name, const float color[3], const double low[3], const double high[3]) {
    builder b = {0};
    paint(&b, color);
    block(&b, low[0], low[1], low[2], high[0], high[1], high[2], 0);
    return finish(&b, s, name);
}

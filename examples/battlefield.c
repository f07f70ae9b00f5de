#include "battlefield.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "props.h"

#define PI 3.14159265358979323846

static const float SAND[3] = {0.82f, 0.68f, 0.42f};  /* our side: the targets */
static const float SLATE[3] = {0.50f, 0.55f, 0.61f}; /* the other */
static const float PLASTER[2][3] = {{0.86f, 0.81f, 0.71f}, {0.80f, 0.70f, 0.60f}};
static const float TILES[2][3] = {{0.74f, 0.44f, 0.34f}, {0.58f, 0.42f, 0.38f}};
static const float BOARDS[3] = {0.62f, 0.50f, 0.38f};

/* ---- parts ----------------------------------------------------------------------------------------------- */

static battlefield *new_battlefield(void) {
    battlefield *b = calloc(1, sizeof *b);
    if (b)
        b->scene = scene_create();
    if (!b || !b->scene) {
        battlefield_destroy(b);
        return NULL;
    }
    return b;
}

void battlefield_destroy(battlefield *b) {
    if (!b)
        return;
    scene_destroy(b->scene);
    free(b->objects);
    free(b->units);
    free(b);
}

static void average_color(const scene_mesh *mesh, float out[3]) {
    double sum[3] = {0, 0, 0};
    for (size_t i = 0; i < 3 * mesh->vertex_count; i++)
        sum[i % 3] += (double)mesh->colors[i];
    for (size_t k = 0; k < 3; k++)
        out[k] = (float)(sum[k] / (double)mesh->vertex_count);
}

typedef struct placing {
    size_t mesh;
    double x, y, z, turn; /* turn: about the upright axis */
    uint32_t flags, group;
    int rank;
    const float *color; /* of meshes without colours */
} placing;

static void upright(double m[16], double turn, double x, double y, double z) {
    const double made[16] = {cos(turn), sin(turn), 0, 0, -sin(turn), cos(turn), 0, 0, 0, 0, 1, 0, x, y, z, 1};
    memcpy(m, made, sizeof made);
}

/* The new part's index, SIZE_MAX when out of memory. */
static size_t put(battlefield *b, const char *name, const placing *p) {
    float color[3] = {0.7f, 0.7f, 0.7f};
    double m[16];
    if (p->mesh >= b->scene->mesh_count)
        return SIZE_MAX;
    if (b->scene->meshes[p->mesh].colors)
        average_color(&b->scene->meshes[p->mesh], color);
    else if (p->color)
        memcpy(color, p->color, sizeof color);
    upright(m, p->turn, p->x, p->y, p->z);
    battlefield_object *objects = realloc(b->objects, (b->scene->part_count + 1) * sizeof *objects);
    if (!objects)
        return SIZE_MAX;
    b->objects = objects;
    const battlefield_object made = {p->flags, p->group, p->rank, p->flags & BATTLEFIELD_TARGET ? 1.0f : 0.0f};
    objects[b->scene->part_count] = made;
    return scene_add_part(b->scene, name, p->mesh, m, color);
}

#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
static bool
put_named(battlefield *b, const placing *p, const char *format, ...) {
    char name[96];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(name, sizeof name, format, arguments);
    va_end(arguments);
    return put(b, name, p) != SIZE_MAX;
}

/* ---- the land -------------------------------------------------------------------------------------------- */

enum { HILLS = 6, BARNS = 2 };
static const double LAND = 220;
static const double HILL[HILLS][4] = {{-62, 48, 34, 8.5},  {58, 62, 30, 7},   {74, -30, 32, 9},
                                      {-20, -74, 33, 7.5}, {-84, -38, 24, 6}, {10, 84, 22, 5}}; /* x, y, radius, peak */

static double ground_height(double x, double y) {
    return 0.7 * sin(0.045 * x + 0.3) * cos(0.05 * y) + 0.35 * sin(0.11 * x - 0.07 * y);
}

static double land_height(double x, double y) {
    double most = ground_height(x, y);
    for (size_t i = 0; i < HILLS; i++) {
        double share = hypot(x - HILL[i][0], y - HILL[i][1]) / HILL[i][2];
        most = fmax(most, ground_height(HILL[i][0], HILL[i][1]) + prop_hill_height(share, HILL[i][3]));
    }
    return most;
}

static double road_distance(double x, double y) {
    return fmin(fabs(y - 16 * sin(x / 31) - 4), fabs(x + 12 - 9 * sin(y / 27)));
}

/* Meadows in patches, a road and its verge. */
static void ground_color(double x, double y, float color[3]) {
    static const float meadow[3] = {0.60f, 0.68f, 0.42f}, dry[3] = {0.70f, 0.70f, 0.46f},
                       road[3] = {0.76f, 0.68f, 0.54f};
    double patch = 0.5 + 0.5 * sin(0.07 * x + 1.3 * sin(0.05 * y)) * cos(0.06 * y + sin(0.04 * x));
    double way = fmin(fmax((4.6 - road_distance(x, y)) / 1.6, 0), 1);
    for (size_t k = 0; k < 3; k++) {
        double grass = (double)meadow[k] + patch * (double)(dry[k] - meadow[k]);
        color[k] = (float)(grass + way * ((double)road[k] - grass));
    }
}

static bool add_land(battlefield *b) {
    placing p = {.flags = BATTLEFIELD_BACKDROP};
    p.mesh = prop_ground(b->scene, "battlefield/ground", LAND, 100, ground_height, ground_color);
    bool ok = put_named(b, &p, "battlefield/ground");
    for (size_t i = 0; ok && i < HILLS; i++) {
        char name[64];
        snprintf(name, sizeof name, "battlefield/hill_%zu", i + 1);
        placing hill = {.x = HILL[i][0], .y = HILL[i][1], .z = ground_height(HILL[i][0], HILL[i][1])};
        hill.mesh = prop_hill(b->scene, name, HILL[i][2], HILL[i][3]);
        ok = put_named(b, &hill, "%s", name);
    }
    return ok;
}

/* ---- places that are taken ------------------------------------------------------------------------------- */

typedef struct claim {
    double x, y, radius;
} claim;

typedef struct claims {
    claim *items;
    size_t count, room;
} claims;

static bool claim_place(claims *c, double x, double y, double radius) {
    if (c->count == c->room) {
        size_t room = 2 * c->room + 256;
        claim *items = realloc(c->items, room * sizeof *items);
        if (!items)
            return false;
        c->items = items;
        c->room = room;
    }
    c->items[c->count++] = (claim){x, y, radius};
    return true;
}

static bool is_clear(const claims *c, double x, double y, double radius) {
    for (size_t i = 0; i < c->count; i++) {
        double dx = x - c->items[i].x, dy = y - c->items[i].y, least = radius + c->items[i].radius;
        if (dx * dx + dy * dy < least * least)
            return false;
    }
    return true;
}

/* ---- buildings ------------------------------------------------------------------------------------------- */

enum { FLOOR, FRONT, BACK, LEFT, RIGHT, ROOF, BUILDING_PARTS };

typedef struct house_plan {
    double length, width, height;
    size_t meshes[BUILDING_PARTS];
} house_plan;

static const double WALL = 0.3, SLOPE = 0.68;

static bool plan_house(scene *s, house_plan *plan, const char *name, const float *wall, const float *tiles, bool barn) {
    const prop_opening front[3] = {{0.2 * plan->length, 0.95, 1.15, 1.3, false},
                                   {0.5 * plan->length, 0, 1.25, 2.2, true},
                                   {0.8 * plan->length, 0.95, 1.15, 1.3, false}};
    double across = plan->width - 2 * WALL - 0.004, rise = SLOPE * (plan->width / 2 + 0.6), lift = 0.04 - 0.6 * SLOPE;
    const prop_opening gate = {across / 2, 0, 4.4, 3.3, true};
    const prop_opening side[2] = {{0.3 * across, 0.95, 1.1, 1.3, false}, {0.7 * across, 0.95, 1.1, 1.3, false}};
    double gable = lift + rise + 0.05, half[2] = {plan->length / 2 - 0.02, plan->width / 2 - 0.02};
    const double low[3] = {-half[0], -half[1], -0.6}, high[3] = {half[0], half[1], 0.12};
    const prop_opening back[2] = {front[0], front[2]};
    char names[BUILDING_PARTS][64];
    static const char *const kinds[BUILDING_PARTS] = {"floor", "front", "back", "left", "right", "roof"};
    for (size_t i = 0; i < BUILDING_PARTS; i++)
        snprintf(names[i], sizeof names[i], "battlefield/%s_%s", name, kinds[i]);
    size_t *m = plan->meshes;
    m[FLOOR] = prop_slab(s, names[FLOOR], BOARDS, low, high);
    m[FRONT] = prop_wall(s, names[FRONT], wall, plan->length, plan->height, WALL, 0, barn ? back : front, barn ? 2 : 3);
    m[BACK] = prop_wall(s, names[BACK], wall, plan->length, plan->height, WALL, 0, back, 2);
    m[LEFT] = prop_wall(s, names[LEFT], wall, across, plan->height, WALL, gable, side, 2);
    m[RIGHT] = prop_wall(s, names[RIGHT], wall, across, plan->height, WALL, gable, barn ? &gate : side, barn ? 1 : 2);
    m[ROOF] = prop_roof(s, names[ROOF], tiles, plan->length + 1, plan->width + 1.2, rise);
    for (size_t i = 0; i < BUILDING_PARTS; i++)
        if (m[i] == SIZE_MAX)
            return false;
    return true;
}

/* Where a part of a house of that plan stands in it. */
static void part_place(const house_plan *plan, size_t part, placing *p) {
    double x = plan->length / 2, y = plan->width / 2, end = y - WALL - 0.002;
    const double at[BUILDING_PARTS][4] = {{0, 0, 0, 0},
                                          {-x, -y, 0, 0},
                                          {x, y, 0, PI},
                                          {-x + 0.01, end, 0, -PI / 2},
                                          {x - 0.01, -end, 0, PI / 2},
                                          {0, 0, plan->height + 0.04 - 0.6 * SLOPE, 0}};
    p->x = at[part][0];
    p->y = at[part][1];
    p->z = at[part][2];
    p->turn = at[part][3];
}

static bool add_house(battlefield *b, const house_plan *plan, const char *name, uint32_t group, double x, double y,
                      double turn) {
    static const char *const kinds[BUILDING_PARTS] = {"floor", "front", "back", "left", "right", "roof"};
    double c = cos(turn), d = sin(turn), z = (double)INFINITY;
    for (int i = 0; i < 4; i++) {
        double u = (i % 2 ? 0.5 : -0.5) * plan->length, v = (i / 2 ? 0.5 : -0.5) * plan->width;
        z = fmin(z, land_height(x + c * u - d * v, y + d * u + c * v));
    }
    bool ok = true;
    for (size_t i = 0; ok && i < BUILDING_PARTS; i++) {
        placing p = {.mesh = plan->meshes[i], .group = group, .rank = (int)i};
        part_place(plan, i, &p);
        double u = p.x, v = p.y;
        p.x = x + c * u - d * v;
        p.y = y + d * u + c * v;
        p.z += z - 0.06;
        p.turn += turn;
        p.flags = i == FLOOR ? BATTLEFIELD_BACKDROP : 0;
        ok = put_named(b, &p, "%s/%s", name, kinds[i]);
    }
    return ok;
}

/* A clear place on even ground. */
static bool find_site(dice *d, const claims *taken, double radius, double *x, double *y) {
    for (int tries = 0; tries < 4000; tries++) {
        *x = dice_between(d, -0.42 * LAND, 0.42 * LAND);
        *y = dice_between(d, -0.42 * LAND, 0.42 * LAND);
        bool even = road_distance(*x, *y) > radius + 3;
        for (size_t i = 0; even && i < HILLS; i++)
            even = hypot(*x - HILL[i][0], *y - HILL[i][1]) > HILL[i][2] + 0.5 * radius;
        if (even && is_clear(taken, *x, *y, radius + 2))
            return true;
    }
    return false;
}

static bool add_bunkers(battlefield *b, dice *d, claims *taken, size_t count) {
    placing p = {.flags = BATTLEFIELD_IMPENETRABLE};
    p.mesh = prop_bunker(b->scene, "battlefield/bunker");
    bool ok = p.mesh != SIZE_MAX;
    for (size_t i = 0; ok && i < count && find_site(d, taken, 6, &p.x, &p.y); i++) {
        p.z = land_height(p.x, p.y);
        p.turn = dice_between(d, 0, 2 * PI);
        ok = claim_place(taken, p.x, p.y, 5) && put_named(b, &p, "battlefield/bunker_%zu", i + 1);
    }
    return ok;
}

/* In every barn a tank of ours is parked, and in every house a soldier stands. */
typedef struct shelter {
    double x, y, turn;
    bool barn;
} shelter;

static bool add_buildings(battlefield *b, dice *d, claims *taken, size_t count, shelter *shelters, size_t *found) {
    house_plan plans[3] = {{10.5, 7.2, 3, {0}}, {8.6, 6.6, 2.8, {0}}, {15, 8.6, 4.2, {0}}};
    bool ok = plan_house(b->scene, &plans[0], "house", PLASTER[0], TILES[0], false) &&
              plan_house(b->scene, &plans[1], "cottage", PLASTER[1], TILES[1], false) &&
              plan_house(b->scene, &plans[2], "barn", BOARDS, TILES[1], true);
    for (size_t i = 0; ok && i < count; i++) {
        const house_plan *plan = &plans[i < BARNS ? 2 : i % 2];
        shelter *at = &shelters[i];
        char name[64];
        double radius = 0.5 * hypot(plan->length, plan->width) + 0.5;
        if (!find_site(d, taken, radius, &at->x, &at->y))
            break;
        at->turn = 0.5 * PI * (double)(dice_throw(d) % 4) + dice_between(d, -0.3, 0.3);
        at->barn = i < BARNS;
        snprintf(name, sizeof name, "battlefield/%s_%zu", i < BARNS ? "barn" : "house", i + 1);
        ok = claim_place(taken, at->x, at->y, radius) &&
             add_house(b, plan, name, (uint32_t)i + 1, at->x, at->y, at->turn);
        *found = i + 1;
    }
    return ok;
}

/* ---- units ----------------------------------------------------------------------------------------------- */

/* A unit goes around an ellipse, once a period; one without extent stands still. */
struct battlefield_unit {
    size_t part, first_mesh; /* first_mesh: of three strides; SIZE_MAX: a tank */
    double x, y, a, b, tilt, phase, direction, turn;
};

enum { TURRETS = 3, STRIDES = 3, SAMPLES = 48 };

static void unit_place(const battlefield_unit *u, double time, double *x, double *y, double *heading) {
    double angle = u->phase + u->direction * 2 * PI * time / BATTLEFIELD_PERIOD;
    double px = u->a * cos(angle), py = u->b * sin(angle), c = cos(u->tilt), d = sin(u->tilt);
    double vx = -u->direction * u->a * sin(angle), vy = u->direction * u->b * cos(angle);
    *x = u->x + c * px - d * py;
    *y = u->y + d * px + c * py;
    *heading = u->a > 0 ? atan2(d * vx + c * vy, c * vx - d * vy) : u->turn;
}

/* Tanks lean with the land, soldiers stand upright. */
static void unit_transform(const battlefield_unit *u, double time, double m[16]) {
    double x, y, heading, reach = u->first_mesh == SIZE_MAX ? 2 : 0.3;
    unit_place(u, time, &x, &y, &heading);
    upright(m, heading, x, y, land_height(x, y));
    if (u->first_mesh != SIZE_MAX)
        return;
    double c = cos(heading), d = sin(heading), rise[2];
    for (int k = 0; k < 2; k++) {
        double dx = reach * (k ? -d : c), dy = reach * (k ? c : d);
        rise[k] = (land_height(x + dx, y + dy) - land_height(x - dx, y - dy)) / (2 * reach);
    }
    double along = sqrt(1 + rise[0] * rise[0]), up[3], *ahead = m, *left = m + 4;
    const double forward[3] = {c / along, d / along, rise[0] / along}, side[3] = {-d, c, rise[1]};
    double length = 0;
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        up[k] = forward[i] * side[j] - forward[j] * side[i];
        length += up[k] * up[k];
    }
    for (int k = 0; k < 3; k++) {
        ahead[k] = forward[k];
        m[8 + k] = up[k] / sqrt(length);
    }
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        left[k] = m[8 + i] * ahead[j] - m[8 + j] * ahead[i];
    }
}

void battlefield_move(battlefield *b, double time) {
    for (size_t i = 0; i < b->unit_count; i++) {
        const battlefield_unit *u = &b->units[i];
        scene_part *part = &b->scene->parts[u->part];
        unit_transform(u, time, part->transform);
        if (u->first_mesh != SIZE_MAX && u->a > 0) { /* two steps a second: left, together, right, together */
            static const size_t order[4] = {0, 1, 2, 1};
            double steps = 4 * time + 7 * u->phase;
            part->mesh = u->first_mesh + order[(size_t)(fmod(floor(steps), 4) + 4) % 4];
        }
    }
}

/* Whether two units never come nearer than `least`. */
static bool keep_apart(const battlefield_unit *u, const battlefield_unit *v, double least) {
    if (hypot(u->x - v->x, u->y - v->y) > u->a + v->a + least)
        return true;
    for (int i = 0; i < SAMPLES; i++) {
        double p[3], q[3], time = BATTLEFIELD_PERIOD * i / SAMPLES;
        unit_place(u, time, &p[0], &p[1], &p[2]);
        unit_place(v, time, &q[0], &q[1], &q[2]);
        if (hypot(p[0] - q[0], p[1] - q[1]) < least)
            return false;
    }
    return true;
}

static bool way_is_clear(const battlefield_unit *u, const claims *taken, double radius) {
    for (int i = 0; i < SAMPLES; i++) {
        double x, y, heading;
        unit_place(u, BATTLEFIELD_PERIOD * i / SAMPLES, &x, &y, &heading);
        if (fabs(x) > 0.46 * LAND || fabs(y) > 0.46 * LAND || !is_clear(taken, x, y, radius))
            return false;
    }
    return true;
}

/* How dense the forest is, 0 to 1: woods with glades, and none on the road. */
static double forest_density(double x, double y) {
    double woods = 0.55 + 0.5 * sin(0.041 * x + 0.9) * cos(0.047 * y - 0.4) + 0.25 * sin(0.09 * x + 0.06 * y);
    return fmin(fmax((road_distance(x, y) - 3.6) / 2, 0), 1) * fmin(fmax(woods, 0.03), 1);
}

/* A way for one more unit; tanks drive larger rounds and keep farther apart. False: there is no room left. */
static bool find_way(const battlefield *b, dice *d, const claims *taken, battlefield_unit *u, bool tank) {
    for (int tries = 0; tries < 4000; tries++) {
        u->x = dice_between(d, -0.44 * LAND, 0.44 * LAND);
        u->y = dice_between(d, -0.44 * LAND, 0.44 * LAND);
        if (dice_between(d, 0, 1) > 0.2 + forest_density(u->x, u->y)) /* woods are for hiding in */
            continue;
        u->a = tank ? dice_between(d, 9, 24) : dice_between(d, 4, 11);
        u->b = u->a * dice_between(d, 0.45, 0.9);
        u->tilt = dice_between(d, 0, 2 * PI);
        u->phase = dice_between(d, 0, 2 * PI);
        u->direction = dice_throw(d) & 1024 ? 1 : -1;
        bool clear = way_is_clear(u, taken, tank ? 2.5 : 0.6);
        for (size_t i = 0; clear && i < b->unit_count; i++) {
            bool both = tank && b->units[i].first_mesh == SIZE_MAX;
            clear = keep_apart(u, &b->units[i], both ? 9.5 : b->units[i].first_mesh == SIZE_MAX ? 5 : 1.4);
        }
        if (clear)
            return true;
    }
    return false;
}

/* Adds a unit with a way of its own, or standing at a place (`at` not NULL). */
static bool add_unit(battlefield *b, const size_t *meshes, const battlefield_unit *u, bool ours, size_t number) {
    bool tank = u->first_mesh == SIZE_MAX;
    placing p = {.mesh = meshes[tank ? number % TURRETS : 1], .flags = ours ? BATTLEFIELD_TARGET : 0u};
    battlefield_unit *units = realloc(b->units, (b->unit_count + 1) * sizeof *units);
    if (!units)
        return false;
    b->units = units;
    units[b->unit_count] = *u;
    units[b->unit_count++].part = b->scene->part_count;
    return put_named(b, &p, "battlefield/%s/%s_%zu", ours ? "ours" : "theirs", tank ? "tank" : "soldier", number + 1);
}

typedef struct army {
    size_t tanks[TURRETS], soldiers[STRIDES];
} army;

static bool raise_army(scene *s, army *a, const char *side, const float color[3]) {
    bool ok = true;
    for (size_t i = 0; i < TURRETS; i++) {
        char name[64];
        snprintf(name, sizeof name, "battlefield/%s_tank_%zu", side, i + 1);
        a->tanks[i] = prop_tank(s, name, color, 0.7 * ((double)i - 1));
        ok = ok && a->tanks[i] != SIZE_MAX;
    }
    for (size_t i = 0; i < STRIDES; i++) {
        char name[64];
        snprintf(name, sizeof name, "battlefield/%s_soldier_%zu", side, i + 1);
        a->soldiers[i] = prop_soldier(s, name, color, 0.95 * ((double)i - 1));
        ok = ok && a->soldiers[i] != SIZE_MAX;
    }
    return ok;
}

static bool add_sheltered(battlefield *b, const army *ours, const shelter *shelters, size_t count) {
    bool ok = true;
    for (size_t i = 0; ok && i < count; i++) {
        const shelter *at = &shelters[i];
        battlefield_unit u = {.x = at->x, .y = at->y, .turn = at->turn, .direction = 1};
        u.first_mesh = at->barn ? SIZE_MAX : ours->soldiers[0];
        ok = add_unit(b, at->barn ? ours->tanks : ours->soldiers, &u, true, at->barn ? 3 * i + 1 : i);
    }
    return ok;
}

static bool add_moving(battlefield *b, dice *d, const claims *taken, const army armies[2], size_t count, bool tanks,
                       size_t number) {
    bool ok = true;
    for (size_t i = 0; ok && i < count; i++) {
        const army *side = &armies[i % 2];
        battlefield_unit u = {.first_mesh = tanks ? SIZE_MAX : side->soldiers[0]};
        if (!find_way(b, d, taken, &u, tanks))
            break;
        ok = add_unit(b, tanks ? side->tanks : side->soldiers, &u, i % 2 == 0, number + i / 2);
    }
    return ok;
}

/* What grows keeps off the ways of units. */
static bool claim_ways(const battlefield *b, claims *taken) {
    bool ok = true;
    for (size_t i = 0; i < b->unit_count; i++)
        for (int k = 0; ok && k < 2 * SAMPLES; k++) {
            double x, y, heading;
            unit_place(&b->units[i], BATTLEFIELD_PERIOD * k / (2 * SAMPLES), &x, &y, &heading);
            ok = claim_place(taken, x, y, b->units[i].first_mesh == SIZE_MAX ? 2.3 : 0.5);
        }
    return ok;
}

/* ---- what grows ------------------------------------------------------------------------------------------ */

typedef struct species {
    const char *name;
    size_t meshes[4], kinds, count;
    double spacing, share; /* metres to the next; how far density decides */
} species;

static bool add_growth(battlefield *b, dice *d, claims *taken, const species *kind) {
    bool ok = true;
    size_t placed = 0;
    for (size_t tries = 0; ok && placed < kind->count && tries < 60 * kind->count; tries++) {
        placing p = {.x = dice_between(d, -0.48 * LAND, 0.48 * LAND), .y = dice_between(d, -0.48 * LAND, 0.48 * LAND)};
        double chance = dice_between(d, 0, 1), turn = dice_between(d, 0, 2 * PI);
        if (chance > 1 - kind->share + kind->share * forest_density(p.x, p.y) || road_distance(p.x, p.y) < 3.4 ||
            !is_clear(taken, p.x, p.y, kind->spacing))
            continue;
        p.z = land_height(p.x, p.y) - 0.05;
        p.turn = turn;
        p.mesh = kind->meshes[dice_throw(d) % kind->kinds];
        ok =
            claim_place(taken, p.x, p.y, kind->spacing) && put_named(b, &p, "battlefield/%s_%zu", kind->name, ++placed);
    }
    return ok;
}

static bool add_forest(battlefield *b, dice *d, claims *taken, const battlefield_desc *desc) {
    species kinds[4] = {{"forest/conifer", {0}, 4, desc->trees * 11 / 20, 1.05, 1},
                        {"forest/broadleaf", {0}, 4, desc->trees - desc->trees * 11 / 20, 1.3, 1},
                        {"forest/bush", {0}, 3, desc->bushes, 0.7, 0.5},
                        {"rocks/rock", {0}, 3, desc->rocks, 0.8, 0}};
    bool ok = true;
    for (size_t k = 0; k < 4; k++)
        for (size_t i = 0; ok && i < kinds[k].kinds; i++) {
            char name[64];
            snprintf(name, sizeof name, "battlefield/%s_%c", strchr(kinds[k].name, '/') + 1, (char)('a' + i));
            uint32_t seed = 10 * (uint32_t)k + (uint32_t)i + 1;
            double more = (double)i;
            kinds[k].meshes[i] = k == 0   ? prop_conifer(b->scene, name, 7 + 1.3 * more, seed)
                                 : k == 1 ? prop_broadleaf(b->scene, name, 5.6 + more, seed)
                                 : k == 2 ? prop_bush(b->scene, name, 0.9 + 0.3 * more, seed)
                                          : prop_rock(b->scene, name, 0.7 + 0.5 * more, seed);
            ok = kinds[k].meshes[i] != SIZE_MAX;
        }
    for (size_t k = 0; ok && k < 4; k++)
        ok = add_growth(b, d, taken, &kinds[k]);
    return ok;
}

static size_t given(size_t value, size_t standard) {
    return value ? value : standard;
}

battlefield *battlefield_create(const battlefield_desc *desc) {
    static const battlefield_desc none = {0};
    const battlefield_desc *wished = desc ? desc : &none;
    battlefield_desc full = {wished->seed ? wished->seed : 1, given(wished->trees, 1000), given(wished->tanks, 48),
                             given(wished->soldiers, 96),     given(wished->houses, 9),   given(wished->bunkers, 4),
                             given(wished->bushes, 120),      given(wished->rocks, 60)};
    battlefield *b = new_battlefield();
    shelter *shelters = calloc(full.houses, sizeof *shelters);
    claims taken = {0};
    army armies[2];
    dice d = {full.seed};
    size_t sheltered = 0;
    bool ok = b && shelters && add_land(b) && add_buildings(b, &d, &taken, full.houses, shelters, &sheltered) &&
              add_bunkers(b, &d, &taken, full.bunkers) && raise_army(b->scene, &armies[0], "our", SAND) &&
              raise_army(b->scene, &armies[1], "their", SLATE) &&
              add_moving(b, &d, &taken, armies, full.tanks, true, full.houses) &&
              add_moving(b, &d, &taken, armies, full.soldiers, false, full.houses) &&
              add_sheltered(b, &armies[0], shelters, sheltered) && claim_ways(b, &taken) &&
              add_forest(b, &d, &taken, &full);
    free(shelters);
    free(taken.items);
    if (!ok) {
        battlefield_destroy(b);
        return NULL;
    }
    const double eye[3] = {70, -95, 62}, look_at[3] = {0, -5, 0};
    memcpy(b->eye, eye, sizeof eye);
    memcpy(b->look_at, look_at, sizeof look_at);
    battlefield_move(b, 0);
    return b;
}

/* ---- the paper's ABSTRACT scene -------------------------------------------------------------------------- */

/* A random turn, evenly spread: by a random unit quaternion. */
static void random_turn(dice *d, double m[16]) {
    double q[4], length = 0;
    while (!(length > 0.01 && length < 1)) {
        length = 0;
        for (size_t i = 0; i < 4; i++) {
            q[i] = dice_between(d, -1, 1);
            length += q[i] * q[i];
        }
    }
    for (size_t i = 0; i < 4; i++)
        q[i] /= sqrt(length);
    for (size_t i = 0; i < 3; i++) {
        size_t j = (i + 1) % 3, k = (i + 2) % 3;
        m[5 * i] = 1 - 2 * (q[j] * q[j] + q[k] * q[k]);
        m[4 * i + j] = 2 * (q[i] * q[j] + q[k] * q[3]);
        m[4 * j + i] = 2 * (q[i] * q[j] - q[k] * q[3]);
    }
}

battlefield *battlefield_create_abstract(uint32_t seed) {
    enum { OBJECTS = 200, TARGETS = 30 };
    static const char *const kinds[4] = {"sphere", "cone", "box", "torus"};
    static const float red[3] = {0.84f, 0.28f, 0.24f};
    const double size = 9, eye[3] = {137, -155, 101};
    battlefield *b = new_battlefield();
    dice d = {seed ? seed : 1};
    if (!b)
        return NULL;
    size_t meshes[4] = {prop_ball(b->scene, "abstract/sphere", size), prop_cone(b->scene, "abstract/cone", size),
                        prop_cube(b->scene, "abstract/box", size), prop_torus(b->scene, "abstract/torus", size)};
    bool ok = true;
    for (size_t i = 0; ok && i < OBJECTS; i++) {
        bool target = i < TARGETS;
        const float color[3] = {0.26f, (float)dice_between(&d, 0.4, 0.8), (float)dice_between(&d, 0.4, 0.8)};
        placing p = {.mesh = meshes[dice_throw(&d) % 4], .color = target ? red : color};
        p.flags = target ? BATTLEFIELD_TARGET : 0u;
        size_t kind = 0;
        while (meshes[kind] != p.mesh)
            kind++;
        ok = put_named(b, &p, "abstract/%s/%s_%zu", target ? "target" : "distractor", kinds[kind], i + 1);
        if (!ok)
            break;
        double *m = b->scene->parts[i].transform;
        random_turn(&d, m);
        for (size_t k = 0; k < 3; k++) /* the middles keep half a size from the faces of the cube */
            m[12 + k] = dice_between(&d, -50 + size / 2, 50 - size / 2);
    }
    memcpy(b->eye, eye, sizeof eye);
    if (!ok) {
        battlefield_destroy(b);
        return NULL;
    }
    return b;
}

/* ---- the paper's WALKTHROUGH scene ----------------------------------------------------------------------- */

enum { PLAN = 16, MOST_ROOMS = 64, THINGS = 100, THING_KINDS = 7 };
static const double CELL = 3, ROOM_HEIGHT = 2.7, ROOM_WALL = 0.2;

typedef struct room {
    int x0, y0, x1, y1; /* cells; the upper ends are outside */
} room;

/* Cuts rooms in two across their longer side until all are small. */
static size_t cut_rooms(dice *d, room *rooms) {
    size_t count = 1;
    rooms[0] = (room){0, 0, PLAN, PLAN};
    for (size_t i = 0; i < count;) {
        room *r = &rooms[i];
        int w = r->x1 - r->x0, h = r->y1 - r->y0, longer = w > h ? w : h;
        if (longer < 4 || w * h <= 15 || count == MOST_ROOMS) {
            i++;
            continue;
        }
        room other = *r;
        int cut = 2 + (int)(dice_throw(d) >> 8) % (longer - 3);
        if (w > h)
            r->x1 = other.x0 = r->x0 + cut;
        else
            r->y1 = other.y0 = r->y0 + cut;
        rooms[count++] = other;
    }
    return count;
}

/* Meshes of inner walls by their length in cells, made when first needed. */
typedef struct wall_meshes {
    size_t of[PLAN + 1], post;
} wall_meshes;

static size_t inner_wall(scene *s, wall_meshes *walls, int cells) {
    if (walls->of[cells] == SIZE_MAX) {
        char name[64];
        double length = CELL * cells - ROOM_WALL;
        const prop_opening door = {length / 2, 0, 1.1, 2.1, true};
        snprintf(name, sizeof name, "walkthrough/wall_%d", cells);
        walls->of[cells] = prop_wall(s, name, PLASTER[0], length, ROOM_HEIGHT, ROOM_WALL, 0, &door, 1);
    }
    return walls->of[cells];
}

static double plan_x(double cells) {
    return CELL * (cells - PLAN / 2.0);
}

/* A post where a wall ends, unless one stands there. */
static bool add_post(battlefield *b, const wall_meshes *walls, bool *posts, int x, int y) {
    placing p = {.mesh = walls->post, .x = plan_x(x), .y = plan_x(y)};
    if (posts[y * (PLAN + 1) + x])
        return true;
    posts[y * (PLAN + 1) + x] = true;
    return put_named(b, &p, "walkthrough/posts/post_%d_%d", x, y);
}

/* The wall with a door between two rooms that lie side by side along x (or y), if they do. */
static bool add_wall_between(battlefield *b, wall_meshes *walls, bool *posts, const room *r, const room *s) {
    for (int along = 0; along < 2; along++) {
        bool x = along == 0;
        int end = x ? r->x1 : r->y1, start = x ? s->x0 : s->y0;
        int r0 = x ? r->y0 : r->x0, r1 = x ? r->y1 : r->x1, s0 = x ? s->y0 : s->x0, s1 = x ? s->y1 : s->x1;
        int from = r0 > s0 ? r0 : s0, to = r1 < s1 ? r1 : s1;
        if (end != start || from >= to)
            continue;
        placing p = {.mesh = inner_wall(b->scene, walls, to - from)};
        double begin = plan_x(from) + ROOM_WALL / 2, middle = plan_x(end);
        p.x = x ? middle + ROOM_WALL / 2 : begin;
        p.y = x ? begin : middle - ROOM_WALL / 2;
        p.turn = x ? PI / 2 : 0;
        if (!put_named(b, &p, "walkthrough/walls/wall_%c_%d_%d", x ? 'y' : 'x', end, from))
            return false;
        for (int k = 0; k < 2; k++)
            if (!add_post(b, walls, posts, x ? end : (k ? to : from), x ? (k ? to : from) : end))
                return false;
    }
    return true;
}

static bool add_shell(battlefield *b) {
    static const char *const names[4] = {"south", "east", "north", "west"};
    const double half = CELL * PLAN / 2, out = half + 0.3, over = ROOM_HEIGHT;
    const double low[3] = {-out, -out, -0.3}, high[3] = {out, out, 0}, low2[3] = {-out, -out, over + 0.02},
                 high2[3] = {out, out, over + 0.2};
    prop_opening windows[8];
    for (size_t i = 0; i < 8; i++)
        windows[i] = (prop_opening){half / 8 * (2 * (double)i + 1), 0.9, 1.5, 1.2, false};
    placing p = {.flags = BATTLEFIELD_BACKDROP};
    p.mesh = prop_slab(b->scene, "walkthrough/floor", BOARDS, low, high);
    bool ok = put_named(b, &p, "walkthrough/floor");
    p.mesh = prop_slab(b->scene, "walkthrough/ceiling", PLASTER[0], low2, high2);
    ok = ok && put_named(b, &p, "walkthrough/ceiling");
    if (ok)
        b->scene->parts[b->scene->part_count - 1].hidden = true;
    p.mesh = prop_wall(b->scene, "walkthrough/outside", PLASTER[1], 2 * half, over, 0.25, 0, windows, 8);
    for (int i = 0; ok && i < 4; i++) {
        double c = cos(0.5 * PI * i), d = sin(0.5 * PI * i), y = -half - 0.25;
        p.turn = 0.5 * PI * i;
        p.x = -half * c - y * d;
        p.y = -half * d + y * c;
        ok = put_named(b, &p, "walkthrough/outside/%s", names[i]);
    }
    return ok;
}

static bool add_things(battlefield *b, dice *d) {
    static size_t (*const makers[THING_KINDS])(scene *, const char *) = {prop_table, prop_chair, prop_shelf, prop_lamp,
                                                                         prop_plant, prop_cat,   prop_car};
    static const char *const kinds[THING_KINDS] = {"table", "chair", "shelf", "lamp", "plant", "cat", "car"};
    size_t meshes[THING_KINDS];
    bool taken[PLAN * PLAN] = {false}, ok = true;
    for (size_t i = 0; i < THING_KINDS; i++) {
        char name[64];
        snprintf(name, sizeof name, "walkthrough/%s", kinds[i]);
        meshes[i] = makers[i](b->scene, name);
    }
    taken[PLAN * PLAN / 2 + PLAN / 2] = true; /* where the walker stands */
    for (size_t i = 0; ok && i < THINGS; i++) {
        size_t cell = (dice_throw(d) >> 8) % (PLAN * PLAN), kind = (dice_throw(d) >> 8) % THING_KINDS;
        while (taken[cell])
            cell = (cell + 89) % (PLAN * PLAN);
        taken[cell] = true;
        placing p = {.mesh = meshes[kind], .flags = BATTLEFIELD_TARGET};
        p.x = plan_x((double)(cell % PLAN) + 0.5) + dice_between(d, -0.4, 0.4);
        p.y = plan_x((double)(cell / PLAN) + 0.5) + dice_between(d, -0.4, 0.4);
        p.turn = dice_between(d, 0, 2 * PI);
        ok = put_named(b, &p, "walkthrough/things/%s_%zu", kinds[kind], i + 1);
    }
    return ok;
}

battlefield *battlefield_create_walkthrough(uint32_t seed) {
    const double low[3] = {-0.15, -0.15, -0.1}, high[3] = {0.15, 0.15, ROOM_HEIGHT + 0.01};
    battlefield *b = new_battlefield();
    dice d = {seed ? seed : 1};
    room rooms[MOST_ROOMS];
    bool posts[(PLAN + 1) * (PLAN + 1)] = {false};
    wall_meshes walls;
    size_t count = cut_rooms(&d, rooms);
    if (!b)
        return NULL;
    for (size_t i = 0; i <= PLAN; i++)
        walls.of[i] = SIZE_MAX;
    bool ok = add_shell(b);
    walls.post = ok ? prop_slab(b->scene, "walkthrough/post", PLASTER[1], low, high) : SIZE_MAX;
    for (size_t i = 0; i < count; i++)
        for (size_t j = 0; ok && j < count; j++)
            ok = add_wall_between(b, &walls, posts, &rooms[i], &rooms[j]);
    ok = ok && add_things(b, &d);
    b->eye[0] = b->eye[1] = b->look_at[1] = CELL / 2;
    b->eye[2] = b->look_at[2] = 1.65; /* at floor level: a walker's eyes */
    b->look_at[0] = b->eye[0] + 10;
    if (!ok) {
        battlefield_destroy(b);
        return NULL;
    }
    return b;
}

#include "world.h"

#include <stdio.h>
#include <stdlib.h>

const material_block world_materials[MATERIAL_COUNT] = {
    [MATERIAL_GROUND] = {{1, 1, 1, 1}, {1, 0, 0, 0}},
    [MATERIAL_STONE] = {{0.62f, 0.56f, 0.48f, 1}, {2, 0.06f, 0, 0}},
    [MATERIAL_BARK] = {{0.27f, 0.18f, 0.11f, 1}, {2, 0, 0, 0}},
    [MATERIAL_LEAVES] = {{0.16f, 0.25f, 0.11f, 1}, {2, 0.08f, 0, 0}},
    [MATERIAL_HULL] = {{0.72f, 0.72f, 0.72f, 1}, {3, 0.30f, 0, 0}},
    [MATERIAL_DARK] = {{0.13f, 0.14f, 0.16f, 1}, {0, 0.35f, 0.2f, 0}},
    [MATERIAL_BRASS] = {{0.78f, 0.52f, 0.18f, 1}, {0, 0.9f, 0.8f, 0.05f}},
    [MATERIAL_STEEL] = {{0.46f, 0.49f, 0.53f, 1}, {0, 0.8f, 0.6f, 0.05f}},
    [MATERIAL_RED] = {{0.70f, 0.13f, 0.07f, 1}, {0, 0.4f, 0, 0.1f}},
    [MATERIAL_GLOW] = {{0.15f, 0.70f, 0.75f, 1}, {0, 0.5f, 0, 1.6f}},
    [MATERIAL_CLOTH] = {{0.14f, 0.28f, 0.42f, 1}, {0, 0.25f, 0, 0}},
};

/* Numbers in [0,1) that are the same everywhere. */
static float chance(uint32_t *seed) {
    *seed = *seed * 1664525u + 1013904223u;
    return (float)(*seed >> 8) / 16777216.0f;
}

/* ---- meshes: scenery ----------------------------------------------------------------------------------------- */

static void at(mesh *m, float x, float y, float z) {
    m->place = m4_move(x, y, z);
}

/* Lying: the axis of a lathe along x. */
static void lying(mesh *m, float x, float y, float z) {
    m->place = m4_mul(m4_move(x, y, z), m4_turn(2, -PI / 2));
}

static void add_cylinder(mesh *m, float radius, float half_height, float edge, int segments) {
    const float profile[][2] = {{0, half_height},
                                {radius - edge, half_height},
                                {radius, half_height - edge},
                                {radius, edge - half_height},
                                {radius - edge, -half_height},
                                {0, -half_height}};
    mesh_lathe(m, profile, 6, segments);
}

static void make_scenery(mesh *meshes) {
    static const float trunk[][2] = {{0, 1.3f}, {0.10f, 1.3f}, {0.14f, 0.5f}, {0.24f, 0}, {0, 0}};
    static const float tiers[3][4][2] = {{{0, 2.1f}, {1.05f, 0.75f}, {0.92f, 0.62f}, {0, 0.9f}},
                                         {{0, 2.9f}, {0.85f, 1.6f}, {0.74f, 1.48f}, {0, 1.75f}},
                                         {{0, 3.7f}, {0.62f, 2.45f}, {0.52f, 2.35f}, {0, 2.6f}}};
    static const float blade[][2] = {{0, 0.34f}, {0.05f, 0}, {0, 0}};
    uint32_t seed = 7;
    at(&meshes[MESH_SLAB], 0, -0.9f, 0);
    mesh_box(&meshes[MESH_SLAB], 15, 0.9f, 10.5f, 0.12f, 2);
    mesh_box(&meshes[MESH_BRICK], 0.58f, 0.26f, 0.42f, 0.05f, 2);
    mesh_lathe(&meshes[MESH_TRUNK], trunk, 5, 9);
    for (int tier = 0; tier < 3; tier++)
        mesh_lathe(&meshes[MESH_CROWN], tiers[tier], 4, 9);
    for (int i = 0; i < 5; i++) {
        meshes[MESH_TUFT].place = m4_mul(m4_move(0.2f * chance(&seed) - 0.1f, 0, 0.2f * chance(&seed) - 0.1f),
                                         m4_mul(m4_turn(0, chance(&seed) - 0.5f), m4_turn(2, chance(&seed) - 0.5f)));
        mesh_lathe(&meshes[MESH_TUFT], blade, 3, 4);
    }
    meshes[MESH_ROCK].place = m4_turn(2, 0.4f);
    mesh_box(&meshes[MESH_ROCK], 0.5f, 0.36f, 0.42f, 0.2f, 1);
}

/* ---- meshes: machines with something inside ------------------------------------------------------------------ */

static void make_crawler(mesh *meshes) {
    static const float turret[][2] = {{0, 0.86f},     {0.30f, 0.84f}, {0.58f, 0.74f}, {0.78f, 0.55f},
                                      {0.90f, 0.28f}, {0.92f, 0.06f}, {0.80f, 0},     {0, 0}};
    static const float barrel[][2] = {{0, 2.3f},     {0.13f, 2.3f}, {0.16f, 2.25f}, {0.16f, 1.95f},
                                      {0.11f, 1.9f}, {0.11f, 0},    {0, 0}};
    mesh *track = &meshes[MESH_CRAWLER_TRACK];
    at(&meshes[MESH_CRAWLER_HULL], 0, 1.35f, 0);
    mesh_box(&meshes[MESH_CRAWLER_HULL], 2.3f, 0.85f, 1.25f, 0.42f, 6);
    mesh_lathe(&meshes[MESH_CRAWLER_TURRET], turret, 8, 40);
    meshes[MESH_CRAWLER_TURRET].place = m4_mul(m4_move(0.5f, 0.42f, 0), m4_turn(2, -PI / 2 + 0.12f));
    mesh_lathe(&meshes[MESH_CRAWLER_TURRET], barrel, 7, 24);
    for (int side = -1; side <= 1; side += 2) {
        at(track, 0, 0.62f, 1.42f * (float)side);
        mesh_box(track, 2.5f, 0.60f, 0.30f, 0.28f, 5);
        for (int wheel = 0; wheel < 5; wheel++) {
            track->place =
                m4_mul(m4_move(1.85f * ((float)wheel - 2) / 2, 0.55f, 1.66f * (float)side), m4_turn(0, PI / 2));
            add_cylinder(track, 0.36f, 0.12f, 0.05f, 24);
        }
        for (int link = 0; link < 17; link++) {
            at(track, 4.4f * ((float)link / 16 - 0.5f), 1.22f, 1.42f * (float)side);
            mesh_box(track, 0.10f, 0.05f, 0.32f, 0.02f, 1);
        }
    }
}

/* An engine with four cylinders; what turns in it, a crank and a gear, are meshes of their own. */
static void make_engine(mesh *meshes) {
    mesh *engine = &meshes[MESH_ENGINE], *crank = &meshes[MESH_CRANK];
    at(engine, -0.55f, 0.82f, 0);
    mesh_box(engine, 1.15f, 0.16f, 0.52f, 0.05f, 2);
    for (int i = 0; i < 4; i++) {
        float x = -1.36f + 0.52f * (float)i;
        at(engine, x, 1.45f, 0.28f);
        add_cylinder(engine, 0.20f, 0.38f, 0.05f, 28);
        at(engine, x, 1.45f, -0.28f);
        add_cylinder(engine, 0.20f, 0.38f, 0.05f, 28);
        lying(crank, 0.52f * ((float)i - 1.5f), 0.14f * (i % 2 ? 1.0f : -1.0f), 0);
        add_cylinder(crank, 0.20f, 0.10f, 0.03f, 24);
    }
    lying(crank, 0.3f, 0, 0);
    add_cylinder(crank, 0.09f, 1.5f, 0.02f, 24);
    mesh_gear(&meshes[MESH_GEAR], 16, 0.33f, 0.42f, 0.08f);
    at(&meshes[MESH_GEAR], 0, 0, 0);
    add_cylinder(&meshes[MESH_GEAR], 0.16f, 0.15f, 0.02f, 20);
    at(&meshes[MESH_PILOT], 0, 0.62f, 0);
    mesh_ball(&meshes[MESH_PILOT], 0.19f, 0.21f, 0.19f, 24);
    at(&meshes[MESH_PILOT], 0, 0.12f, 0);
    mesh_box(&meshes[MESH_PILOT], 0.22f, 0.30f, 0.24f, 0.12f, 3);
}

static void make_vessel(mesh *meshes) {
    static const float vessel[][2] = {{0, 5.0f},      {0.55f, 4.94f}, {1.02f, 4.74f}, {1.36f, 4.40f},
                                      {1.55f, 3.95f}, {1.6f, 3.5f},   {1.6f, 1.9f},   {1.5f, 1.5f},
                                      {1.2f, 1.15f},  {0.7f, 0.95f},  {0, 0.9f}};
    mesh *frame = &meshes[MESH_VESSEL_FRAME], *rotor = &meshes[MESH_ROTOR];
    mesh_lathe(&meshes[MESH_VESSEL], vessel, 11, 56);
    for (int leg = 0; leg < 4; leg++) {
        frame->place = m4_mul(m4_turn(1, PI / 4 + PI / 2 * (float)leg), m4_move(1.58f, 1.25f, 0));
        mesh_box(frame, 0.16f, 1.25f, 0.16f, 0.05f, 2);
    }
    for (int ring = 0; ring < 2; ring++) {
        const float y = ring ? 3.6f : 1.95f;
        const float band[][2] = {
            {1.55f, y + 0.1f}, {1.68f, y + 0.1f}, {1.68f, y - 0.1f}, {1.55f, y - 0.1f}, {1.55f, y + 0.1f}};
        frame->place = m4_identity();
        mesh_lathe(frame, band, 5, 56);
    }
    at(rotor, 0, 2.95f, 0);
    add_cylinder(rotor, 0.12f, 1.7f, 0.03f, 20);
    for (int stage = 0; stage < 4; stage++)
        for (int blade = 0; blade < 9; blade++) {
            float turn = 2 * PI * ((float)blade + 0.25f * (float)stage) / 9;
            mat4 tilt = m4_mul(m4_move(0.62f, 1.8f + 0.72f * (float)stage, 0), m4_turn(0, 0.7f));
            rotor->place = m4_mul(m4_turn(1, turn), tilt);
            mesh_box(rotor, 0.52f, 0.025f, 0.15f, 0.02f, 1);
        }
    mesh_ball(&meshes[MESH_CELL], 0.28f, 0.28f, 0.28f, 24);
}

/* ---- meshes: what walks -------------------------------------------------------------------------------------- */

enum { BODY, CHEST, HEAD, THIGH, SHIN, ARM = 7 }; /* the right thigh and shin are 5 and 6, the right arm is 8 */

static void make_walker(mesh *meshes) {
    mesh *legs = &meshes[MESH_WALKER_LEGS], *core = &meshes[MESH_WALKER_CORE];
    float bellows[24][2] = {{0, 2.75f}};
    for (int i = 1; i < 23; i++) {
        float y = 2.75f - 2.5f * (float)(i - 1) / 21;
        bellows[i][0] = 0.23f + (y > 0.95f && y < 1.95f ? 0.05f * (float)(i % 2) : 0.04f) - 0.03f * (2.75f - y) / 2.5f;
        bellows[i][1] = y;
    }
    bellows[23][1] = 0.25f;
    mesh_bone(&meshes[MESH_WALKER_SHELL], BODY);
    at(&meshes[MESH_WALKER_SHELL], 0, 3.1f, 0.1f);
    mesh_box(&meshes[MESH_WALKER_SHELL], 0.92f, 0.85f, 1.25f, 0.62f, 8);
    for (int side = 0; side < 2; side++) {
        float x = side ? 1.12f : -1.12f;
        int thigh = THIGH + 2 * side, shin = SHIN + 2 * side;
        mesh_joint(legs, shin, thigh, 1.2f, 1.7f);
        at(legs, x, 0, 0);
        mesh_lathe(legs, (const float(*)[2])bellows, 24, 24);
        mesh_bone(legs, thigh);
        lying(legs, x, 2.7f, 0);
        add_cylinder(legs, 0.42f, 0.26f, 0.08f, 28);
        mesh_bone(legs, shin);
        at(legs, x, 0.16f, 0.18f);
        mesh_box(legs, 0.34f, 0.16f, 0.58f, 0.10f, 3);
    }
    mesh_bone(core, BODY);
    at(core, 0, 3.15f, -0.30f);
    mesh_ball(core, 0.42f, 0.42f, 0.42f, 32);
    for (int ring = 0; ring < 3; ring++) {
        static const float hoop[][2] = {
            {0.50f, 0.05f}, {0.58f, 0.05f}, {0.58f, -0.05f}, {0.50f, -0.05f}, {0.50f, 0.05f}};
        core->place = m4_mul(m4_move(0, 3.15f, -0.30f), m4_turn(ring % 2 * 2, 1.05f * (float)ring));
        mesh_lathe(core, hoop, 5, 36);
    }
    lying(core, 0, 2.7f, 0);
    add_cylinder(core, 0.10f, 1.1f, 0.02f, 20);
}

static void make_soldier(mesh *meshes) {
    static const float leg[][2] = {{0, 0.9f},      {0.10f, 0.88f}, {0.12f, 0.75f}, {0.095f, 0.56f}, {0.09f, 0.50f},
                                   {0.09f, 0.44f}, {0.10f, 0.32f}, {0.075f, 0.1f}, {0, 0.06f}};
    static const float arm[][2] = {{0, 0.02f}, {0.075f, 0}, {0.08f, -0.2f}, {0.06f, -0.5f}, {0, -0.56f}};
    mesh *body = &meshes[MESH_SOLDIER_BODY], *joints = &meshes[MESH_SOLDIER_JOINTS];
    mesh_joint(body, BODY, CHEST, -0.25f, 0);
    at(body, 0, 1.2f, 0);
    mesh_box(body, 0.22f, 0.28f, 0.15f, 0.10f, 4);
    mesh_bone(body, HEAD);
    at(body, 0, 1.68f, 0.01f);
    mesh_ball(body, 0.145f, 0.16f, 0.155f, 20);
    mesh_bone(joints, CHEST);
    at(joints, 0, 1.25f, -0.20f);
    mesh_box(joints, 0.15f, 0.2f, 0.08f, 0.04f, 2);
    for (int side = 0; side < 2; side++) {
        float sign = side ? 1 : -1;
        mesh_joint(joints, SHIN + 2 * side, THIGH + 2 * side, 0.42f, 0.54f);
        at(joints, 0.12f * sign, 0, 0);
        mesh_lathe(joints, leg, 9, 14);
        mesh_bone(joints, SHIN + 2 * side);
        at(joints, 0.12f * sign, 0.06f, 0.06f);
        mesh_box(joints, 0.08f, 0.06f, 0.15f, 0.04f, 2);
        mesh_bone(body, ARM + side);
        body->place = m4_mul(m4_move(0.30f * sign, 1.40f, 0), m4_turn(2, 0.12f * sign));
        mesh_lathe(body, arm, 5, 14);
    }
}

/* ---- placing ------------------------------------------------------------------------------------------------- */

static uint32_t add_instance(world *w, mat4 place, float r, float g, float b, uint32_t id) {
    if (w->instance_count == WORLD_MOST_INSTANCES) {
        fprintf(stderr, "host: more than %d instances\n", WORLD_MOST_INSTANCES);
        exit(1);
    }
    instance *i = &w->instances[w->instance_count];
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 4; column++)
            i->rows[row][column] = place.m[4 * column + row];
    i->tint[0] = r;
    i->tint[1] = g;
    i->tint[2] = b;
    i->id = id;
    return w->instance_count++;
}

/* All instances since `first` are of this mesh. */
static void add_draw(world *w, mesh_name name, material_name material, uint32_t first, int palette) {
    draw d = {name, material, first, w->instance_count - first, palette};
    if (w->draw_count == WORLD_MOST_DRAWS) {
        fprintf(stderr, "host: more than %d draws\n", WORLD_MOST_DRAWS);
        exit(1);
    }
    if (d.instance_count)
        w->draws[w->draw_count++] = d;
}

static void add_tinted(world *w, mesh_name name, material_name material, mat4 place, const float tint[3], uint32_t id,
                       int palette) {
    uint32_t first = add_instance(w, place, tint[0], tint[1], tint[2], id);
    add_draw(w, name, material, first, palette);
}

static void add_one(world *w, mesh_name name, material_name material, mat4 place, uint32_t id, int palette) {
    static const float white[3] = {1, 1, 1};
    add_tinted(w, name, material, place, white, id, palette);
}

/* Paint. */
static const float cream[3] = {0.95f, 0.78f, 0.48f}, copper_green[3] = {0.36f, 0.66f, 0.58f};
static const float orange[3] = {1.05f, 0.48f, 0.16f};

/* Where trees may stand: at the back and the sides, not on path, wall or yard. */
static bool wooded(float x, float z) {
    float path = fabsf(z - 3.6f - 1.3f * sinf(x * 0.33f)), yard = hypotf(x + 9, z + 6);
    bool hidden = z < -5.2f || (x > 9.5f && z < 1) || (x < -12.2f && z < 8) || (z > 8.2f && x > -4);
    return hidden && path > 2.4f && yard > 3.6f;
}

static void add_trees(world *w) {
    uint32_t seed = 3, first = w->instance_count, trees = 0;
    mat4 places[64];
    while (trees < 46) {
        float x = 28 * chance(&seed) - 14, z = 19 * chance(&seed) - 9.5f, size = 0.75f + 0.55f * chance(&seed);
        bool apart = wooded(x, z);
        for (uint32_t k = 0; apart && k < trees; k++)
            apart = hypotf(places[k].m[12] - x, places[k].m[14] - z) > 1.25f;
        if (apart)
            places[trees++] = m4_mul(m4_move(x, 0, z), m4_mul(m4_turn(1, 6 * size), m4_scale(size, size, size)));
        else
            chance(&seed);
    }
    for (uint32_t k = 0; k < trees; k++)
        add_instance(w, places[k], 1, 1, 1, w->next_id + k);
    add_draw(w, MESH_TRUNK, MATERIAL_BARK, first, -1);
    first = w->instance_count;
    for (uint32_t k = 0; k < trees; k++) {
        float dry = chance(&seed) * chance(&seed);
        add_instance(w, places[k], 0.8f + 1.5f * dry, 0.85f + 0.4f * dry, 0.8f, w->next_id + k);
    }
    add_draw(w, MESH_CROWN, MATERIAL_LEAVES, first, -1);
    w->next_id += trees;
}

static void add_litter(world *w) {
    uint32_t seed = 11, first = w->instance_count;
    for (int k = 0; k < 520; k++) {
        float x = 29 * chance(&seed) - 14.5f, z = 20 * chance(&seed) - 10, size = 0.6f + chance(&seed);
        if (fabsf(z - 3.6f - 1.3f * sinf(x * 0.33f)) > 1.7f && hypotf(x + 9, z + 6) > 3)
            add_instance(w, m4_mul(m4_move(x, 0, z), m4_mul(m4_turn(1, 9 * size), m4_scale(size, size, size))), 1.7f,
                         1.3f + 0.5f * chance(&seed), 0.8f, 1);
    }
    add_draw(w, MESH_TUFT, MATERIAL_LEAVES, first, -1);
    first = w->instance_count;
    for (int k = 0; k < 70; k++) {
        float x = 28 * chance(&seed) - 14, z = 19 * chance(&seed) - 9.5f, size = 0.15f + 0.6f * powf(chance(&seed), 3);
        add_instance(w, m4_mul(m4_move(x, 0.1f * size, z), m4_mul(m4_turn(1, 40 * size), m4_scale(size, size, size))),
                     0.9f, 0.95f, 1, w->next_id++);
    }
    add_draw(w, MESH_ROCK, MATERIAL_STONE, first, -1);
}

/* How high the wall still stands. */
static float ruin(float x) {
    float gap = fabsf(x - 3.6f);
    return fminf(2.9f + 0.7f * sinf(1.3f * x) + 0.4f * sinf(3.1f * x + 1), 1.9f * (gap - 1.6f) + 0.4f);
}

static void add_walls(world *w) {
    uint32_t seed = 5, first = w->instance_count;
    for (int course = 0; course < 7; course++)
        for (int k = -9; k <= 9; k++) {
            float x = 1.2f * ((float)k + 0.5f * (float)(course % 2)), y = 0.27f + 0.54f * (float)course;
            float shade = 0.8f + 0.3f * chance(&seed), turn = 0.06f * (chance(&seed) - 0.5f);
            if (y < ruin(x))
                add_instance(w, m4_mul(m4_move(x, y, -1.2f + 0.06f * chance(&seed)), m4_turn(1, turn)), shade,
                             shade * 0.97f, shade * 0.93f, w->next_id);
        }
    w->next_id++;
    for (int course = 0; course < 10; course++)
        for (int k = 0; k < 11; k++) {
            float angle = 2 * PI * ((float)k + 0.5f * (float)(course % 2)) / 11, radius = 1.95f;
            float shade = 0.82f + 0.3f * chance(&seed), y = 0.27f + 0.54f * (float)course;
            if (course == 9 && k % 2)
                continue;
            mat4 out = m4_mul(m4_turn(1, angle), m4_move(0, 0, radius));
            add_instance(w, m4_mul(m4_move(11.6f, y, -2.4f), out), shade, shade * 0.97f, shade * 0.93f, w->next_id);
        }
    w->next_id++;
    for (int k = 0; k < 14; k++) {
        float x = 3.6f + 5 * (chance(&seed) - 0.5f), z = -1.2f + 3.4f * (chance(&seed) - 0.5f);
        mat4 turn = m4_mul(m4_turn(1, 6 * chance(&seed)), m4_turn(0, chance(&seed) - 0.5f));
        add_instance(w, m4_mul(m4_move(x, 0.12f, z), turn), 0.9f, 0.88f, 0.85f, w->next_id++);
    }
    add_draw(w, MESH_BRICK, MATERIAL_STONE, first, -1);
}

static void add_crawler(world *w, mat4 place, float seconds) {
    uint32_t id = w->next_id, gear_first;
    float turn = 2.2f * seconds;
    add_one(w, MESH_CRAWLER_TRACK, MATERIAL_DARK, place, id, -1);
    add_tinted(w, MESH_CRAWLER_HULL, MATERIAL_HULL, place, cream, id + 1, -1);
    mat4 turret = m4_mul(place, m4_mul(m4_move(0.35f, 2.16f, 0), m4_turn(1, 0.5f + 0.2f * sinf(seconds))));
    add_tinted(w, MESH_CRAWLER_TURRET, MATERIAL_HULL, turret, cream, id + 2, -1);
    add_one(w, MESH_ENGINE, MATERIAL_STEEL, place, id + 3, -1);
    add_one(w, MESH_CRANK, MATERIAL_RED, m4_mul(place, m4_mul(m4_move(-0.55f, 1.12f, 0), m4_turn(0, turn))), id + 4,
            -1);
    gear_first = w->instance_count;
    for (int k = 0; k < 2; k++) {
        mat4 axle = m4_move(1.12f, k ? 1.12f : 1.64f, k ? 0.0f : 0.54f);
        mat4 spin = m4_mul(m4_turn(0, k ? turn : -turn + PI / 16), m4_turn(2, PI / 2));
        add_instance(w, m4_mul(place, m4_mul(axle, spin)), 1, 1, 1, id + 5 + (uint32_t)k);
    }
    add_draw(w, MESH_GEAR, MATERIAL_BRASS, gear_first, -1);
    add_one(w, MESH_PILOT, MATERIAL_CLOTH, m4_mul(place, m4_move(1.72f, 1.25f, -0.4f)), id + 7, -1);
    w->next_id += 8;
}

static void add_vessel(world *w, mat4 place, float seconds) {
    uint32_t id = w->next_id, first;
    add_one(w, MESH_VESSEL_FRAME, MATERIAL_DARK, place, id, -1);
    add_tinted(w, MESH_VESSEL, MATERIAL_HULL, place, copper_green, id + 1, -1);
    add_one(w, MESH_ROTOR, MATERIAL_BRASS, m4_mul(place, m4_turn(1, 1.7f * seconds)), id + 2, -1);
    first = w->instance_count;
    for (int k = 0; k < 6; k++) {
        float angle = PI / 3 * (float)k + 0.4f * seconds;
        mat4 around = m4_move(1.05f * cosf(angle), 2.15f + 0.3f * (float)(k % 2), 1.05f * sinf(angle));
        add_instance(w, m4_mul(place, around), 1, 1, 1, id + 3);
    }
    add_draw(w, MESH_CELL, MATERIAL_GLOW, first, -1);
    w->next_id += 4;
}

/* ---- bones --------------------------------------------------------------------------------------------------- */

/* A bone turns about its joint's place in the mesh, and with it all that hangs on it. */
static mat4 bone(mat4 parent, vec3 joint, int axis, float angle) {
    mat4 there = m4_move(joint.x, joint.y, joint.z), back = m4_move(-joint.x, -joint.y, -joint.z);
    return m4_mul(parent, m4_mul(there, m4_mul(m4_turn(axis, angle), back)));
}

static int new_palette(world *w) {
    for (int k = 0; k < WORLD_BONES; k++)
        w->palettes[w->palette_count][k] = m4_identity();
    return (int)w->palette_count++;
}

static void add_walker(world *w, mat4 place, float phase) {
    int palette = new_palette(w);
    mat4 *bones = w->palettes[palette];
    bones[BODY] = m4_mul(m4_move(0, -0.18f + 0.05f * cosf(2 * phase), 0), m4_turn(2, 0.04f * sinf(phase)));
    for (int side = 0; side < 2; side++) {
        float swing = sinf(phase + PI * (float)side), lift = fmaxf(0, cosf(phase + PI * (float)side));
        float x = side ? 1.12f : -1.12f;
        bones[THIGH + 2 * side] = bone(bones[BODY], v3(x, 2.7f, 0), 0, -0.42f * swing - 0.35f * lift);
        bones[SHIN + 2 * side] = bone(bones[THIGH + 2 * side], v3(x, 1.45f, 0), 0, 0.15f + 0.7f * lift);
    }
    add_one(w, MESH_WALKER_LEGS, MATERIAL_DARK, place, w->next_id, palette);
    add_tinted(w, MESH_WALKER_SHELL, MATERIAL_HULL, place, orange, w->next_id + 1, palette);
    add_one(w, MESH_WALKER_CORE, MATERIAL_BRASS, place, w->next_id + 2, palette);
    add_one(w, MESH_PILOT, MATERIAL_RED, m4_mul(place, m4_mul(m4_move(0, 2.6f, 0.62f), bones[BODY])), w->next_id + 3,
            -1);
    w->next_id += 4;
}

static void add_soldier(world *w, mat4 place, float phase) {
    int palette = new_palette(w);
    mat4 *bones = w->palettes[palette];
    bones[BODY] = m4_move(0, 0.03f * cosf(2 * phase) - 0.02f, 0);
    bones[CHEST] = bone(bones[BODY], v3(0, 1, 0), 1, 0.2f * sinf(phase));
    bones[HEAD] = bone(bones[CHEST], v3(0, 1.5f, 0), 1, -0.3f * sinf(phase));
    for (int side = 0; side < 2; side++) {
        float swing = sinf(phase + PI * (float)side), lift = fmaxf(0, cosf(phase + PI * (float)side));
        float x = side ? 0.12f : -0.12f;
        bones[THIGH + 2 * side] = bone(bones[BODY], v3(x, 0.88f, 0), 0, -0.55f * swing);
        bones[SHIN + 2 * side] = bone(bones[THIGH + 2 * side], v3(x, 0.48f, 0), 0, 0.15f + 0.9f * lift);
        bones[ARM + side] = bone(bones[CHEST], v3(2.5f * x, 1.4f, 0), 0, 0.6f * swing - 0.1f);
    }
    add_one(w, MESH_SOLDIER_BODY, MATERIAL_CLOTH, place, w->next_id, palette);
    add_one(w, MESH_SOLDIER_JOINTS, MATERIAL_STEEL, place, w->next_id++, palette);
}

/* ---- the world ----------------------------------------------------------------------------------------------- */

static mat4 standing(float x, float z, float turn) {
    return m4_mul(m4_move(x, 0, z), m4_turn(1, turn));
}

static void add_units(world *w, float seconds) {
    static const float soldiers[8][3] = {{-7.4f, -3.4f, 1.5f}, {-5.9f, -3.2f, 1.7f}, {-4.3f, -3.5f, 1.4f},
                                         {-2.7f, -3.2f, 1.6f}, {-0.9f, -3.5f, 1.5f}, {5.8f, 6.1f, -1.9f},
                                         {6.9f, 7.0f, -1.8f},  {0.8f, 1.2f, 2.6f}};
    add_crawler(w, standing(-4.6f, 4.1f, 0.38f), seconds);
    add_vessel(w, standing(-9, -6, 0.2f), seconds);
    add_walker(w, standing(3.5f, -0.6f, 0.25f), 0.9f + 2.4f * seconds);
    add_walker(w, standing(9.2f, 4.6f, -0.9f), 2.6f + 2.4f * seconds);
    for (int k = 0; k < 8; k++)
        add_soldier(w, standing(soldiers[k][0], soldiers[k][1], soldiers[k][2]), 1.3f * (float)k + 5 * seconds);
}

void world_create(world *w, bool machines, GLuint instance_buffer) {
    memset(w, 0, sizeof *w);
    w->machines = machines;
    for (int k = 0; k < MESH_COUNT; k++)
        w->meshes[k] = mesh_begin();
    make_scenery(w->meshes);
    make_crawler(w->meshes);
    make_engine(w->meshes);
    make_vessel(w->meshes);
    make_walker(w->meshes);
    make_soldier(w->meshes);
    for (int k = 0; k < MESH_COUNT; k++)
        mesh_upload(&w->meshes[k], instance_buffer);
}

void world_update(world *w, float seconds) {
    w->instance_count = w->draw_count = w->palette_count = 0;
    w->next_id = 2;
    add_one(w, MESH_SLAB, MATERIAL_GROUND, m4_identity(), 1, -1);
    add_walls(w);
    add_trees(w);
    add_litter(w);
    if (w->machines)
        add_units(w, seconds);
}

void world_destroy(world *w) {
    for (int k = 0; k < MESH_COUNT; k++)
        mesh_destroy(&w->meshes[k]);
}

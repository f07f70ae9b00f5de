/* world.h: what is on the battlefield and how it moves. */
#ifndef HOST_WORLD_H
#define HOST_WORLD_H

#include "mesh.h"

enum { WORLD_MOST_INSTANCES = 2048, WORLD_MOST_DRAWS = 128, WORLD_MOST_PALETTES = 16, WORLD_BONES = 16 };

typedef enum mesh_name {
    MESH_SLAB,
    MESH_BRICK,
    MESH_TRUNK,
    MESH_CROWN,
    MESH_TUFT,
    MESH_ROCK,
    MESH_CRAWLER_HULL,
    MESH_CRAWLER_TURRET,
    MESH_CRAWLER_TRACK,
    MESH_ENGINE,
    MESH_CRANK,
    MESH_GEAR,
    MESH_PILOT,
    MESH_VESSEL,
    MESH_VESSEL_FRAME,
    MESH_ROTOR,
    MESH_CELL,
    MESH_WALKER_SHELL,
    MESH_WALKER_LEGS,
    MESH_WALKER_CORE,
    MESH_SOLDIER_BODY,
    MESH_SOLDIER_JOINTS,
    MESH_COUNT
} mesh_name;

typedef enum material_name {
    MATERIAL_GROUND,
    MATERIAL_STONE,
    MATERIAL_BARK,
    MATERIAL_LEAVES,
    MATERIAL_HULL,
    MATERIAL_DARK,
    MATERIAL_BRASS,
    MATERIAL_STEEL,
    MATERIAL_RED,
    MATERIAL_GLOW,
    MATERIAL_CLOTH,
    MATERIAL_COUNT
} material_name;

/* As the shader's block has it. */
typedef struct material_block {
    float base[4], surface[4];
} material_block;

/* A mesh, so often, of one material. palette: which bones; -1 for a mesh without. */
typedef struct draw {
    mesh_name mesh;
    material_name material;
    uint32_t first_instance, instance_count;
    int palette;
} draw;

typedef struct world {
    mesh meshes[MESH_COUNT];
    instance instances[WORLD_MOST_INSTANCES];
    draw draws[WORLD_MOST_DRAWS];
    mat4 palettes[WORLD_MOST_PALETTES][WORLD_BONES];
    uint32_t instance_count, draw_count, palette_count, next_id;
    bool machines; /* false: a quiet place, without machines and soldiers */
} world;

extern const material_block world_materials[MATERIAL_COUNT];

/* Makes the meshes and sends them to GL; every instance is to be in that buffer. */
void world_create(world *w, bool machines, GLuint instance_buffer);

/* Everything where it is after so many seconds: draws, instances and palettes are made anew. */
void world_update(world *w, float seconds);

void world_destroy(world *w);

#endif

/* mesh.h: solids out of formulas, each closed, and their copies in GL. */
#ifndef HOST_MESH_H
#define HOST_MESH_H

#include "gpu.h"
#include "maths.h"

#include <stdint.h>

typedef struct vertex {
    float position[3], normal[3];
    uint8_t bones[2], weights[2]; /* weights sum to 255 */
} vertex;

/* What one instance of a mesh differs in. */
typedef struct instance {
    float rows[3][4]; /* of the matrix from the mesh to the world */
    float tint[3];
    uint32_t id; /* what the pixel says it belongs to; not 0, which is the backdrop */
} instance;

typedef struct mesh {
    vertex *vertices;
    uint32_t *indices;
    uint32_t vertex_count, index_count, vertex_room, index_room;
    GLuint vertex_array, vertex_buffer, index_buffer;
    /* While it is built: what is added is placed by `place`; the joint from bone 0 to bone 1 lies between two heights. */
    mat4 place;
    uint8_t bones[2];
    float joint[2];
} mesh;

mesh mesh_begin(void);

/* What follows hangs on one bone. */
void mesh_bone(mesh *m, int bone);

/* What follows is bent between two bones: the lower one below y = from, the upper one above y = to, before it is placed. */
void mesh_joint(mesh *m, int lower, int upper, float from, float to);

/* Radii and heights, from top to bottom where it is to face outwards, turned about y. A profile that begins and ends
 * with radius 0 or is a ring gives a closed solid. Corners sharper than some 35 degrees stay sharp. */
void mesh_lathe(mesh *m, const float (*profile)[2], int count, int segments);

/* A box of these half sizes whose edges are round. */
void mesh_box(mesh *m, float x, float y, float z, float radius, int steps);

void mesh_ball(mesh *m, float x, float y, float z, int segments);

/* About y, with teeth: half its thickness is h. */
void mesh_gear(mesh *m, int teeth, float inner, float outer, float h);

/* Sends it to GL. The vertices and indices stay, for the world asks them how large things are. */
void mesh_upload(mesh *m, GLuint instance_buffer);
void mesh_destroy(mesh *m);

#endif

/* load_model.h: model files as scenes, by assimp: glTF, OBJ, STL, PLY, 3DS, FBX, COLLADA and what else it knows.
 *
 * The file is read in a process of its own with limits on memory and time, so that a damaged or hostile file costs an
 * error message and nothing else. POSIX only. */
#ifndef LOAD_MODEL_H
#define LOAD_MODEL_H

#include "scene.h"

typedef struct load_report {
    size_t faces_dropped;   /* triangles with a NaN or infinite vertex, in the file's meshes */
    size_t parts_dropped;   /* parts whose transform is not finite */
    size_t others_dropped;  /* points, lines, and faces of vertices that are not there */
    size_t textures_missed; /* base colour textures that are neither embedded nor beside the file, or cannot be read */
} load_report;

/* One part a mesh and node, named by the path of its nodes; units and axes as in the file. Meshes without normals, and
 * all of STL, get ones that are smooth up to a crease. Colours come from materials, vertex colours and base colour
 * textures, which are sampled at the vertices; meshes without any get colours that tell them apart.
 * NULL: message says what is wrong with the file, in one line that does not name it. */
scene *load_model(const char *path, load_report *report, char *message, size_t message_size);

#endif

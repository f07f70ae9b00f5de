/* scene.h: what the examples draw: triangle meshes, and parts that place them in the world. Plain arrays, no GL.
 *
 * Colours are display values from 0 to 1, as in an image file. Triangles are counter-clockwise seen from outside. */
#ifndef SCENE_H
#define SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct scene_mesh {
    char *name;
    float *positions, *normals; /* tightly packed xyz, vertex_count of each */
    float *colors;     /* tightly packed rgb, or NULL; where present it is used in place of the part's colour */
    uint32_t *indices; /* index_count of them, three a triangle */
    size_t vertex_count, index_count;
    bool two_sided; /* the file says that back faces are to be seen */
} scene_mesh;

typedef struct scene_part {
    char *name;           /* path, such as "robot/arm/hand"; unique within the scene */
    size_t mesh;          /* which of the scene's meshes; several parts may share one */
    double transform[16]; /* column-major, to world */
    float color[3];       /* the mesh's average colour where the mesh has colours of its own */
    float opacity;        /* 1: opaque */
    bool hidden;
} scene_part;

typedef struct scene {
    scene_mesh *meshes;
    size_t mesh_count;
    scene_part *parts;
    size_t part_count;
    int up_axis;          /* 1 = y, 2 = z */
    uint32_t *name_slots; /* finds parts by name; scene.c's own */
    size_t name_slot_count;
} scene;

/* Below this angle two faces are shaded as one smooth surface, and no crease is drawn between them. */
#define SCENE_CREASE_DEGREES 35

scene *scene_create(void);    /* NULL: out of memory */
void scene_destroy(scene *s); /* NULL is fine */

/* Both copy the name and return the index, SIZE_MAX when out of memory. A mesh takes over its arrays (malloc'd) even
 * then; a part's name is made unique by "#2", "#3", ... and its transform may be NULL for the identity. */
size_t scene_add_mesh(scene *s, const char *name, const scene_mesh *arrays);
size_t scene_add_part(scene *s, const char *name, size_t mesh, const double transform[16], const float color[3]);

/* The part of that name, SIZE_MAX where there is none. */
size_t scene_find_part(const scene *s, const char *name);

/* Moves everything of `from` into `into` and destroys `from`. Part names get "prefix/" in front where prefix is not
 * NULL; a scene of another up axis is turned to the axis of `into`. False: out of memory; `from` is gone even so. */
bool scene_merge(scene *into, scene *from, const char *prefix);

/* Replaces the normals by ones that are smooth across edges whose faces meet at less than crease_degrees and sharp
 * across the others, splitting vertices where needed and sharing those that are equal. False: out of memory. */
bool scene_mesh_make_normals(scene_mesh *mesh, double crease_degrees);

/* Gives vertices that are equal in position, normal and colour one index. False: out of memory (mesh as it was). */
bool scene_mesh_share_vertices(scene_mesh *mesh);

/* One number for all vertices at the same place, counted from 0; -0 and 0 are the same place. Returns how many places
 * there are, SIZE_MAX when out of memory. */
size_t scene_weld(const float *positions, size_t vertex_count, uint32_t *places);

/* Whether each edge has two triangles that run along it in opposite directions, after welding equal positions.
 * signed_volume (may be NULL) is positive where the triangles face outward. */
bool scene_mesh_closed(const scene_mesh *mesh, double *signed_volume);

/* Moves the origin of each mesh to the middle of its box, and the parts back by their transforms, which are in double:
 * a scene far from its origin is then drawn like one at it. False: out of memory, nothing moved. */
bool scene_center_meshes(scene *s);

/* The box around all parts that are not hidden, in world coordinates; false where there are none. */
bool scene_bounds(const scene *s, double low[3], double high[3]);

void scene_multiply(const double a[16], const double b[16], double product[16]); /* column-major a * b */

#endif

/* battlefield.h: scenes for dynamic transparency: a battlefield with a forest, hills, houses, moving tanks and soldiers, and
 * the two test scenes of Assarsson, Elmqvist and Tsigas 2006. Made from formulas and a seed, the same everywhere; few
 * meshes, many parts, so that hosts can draw them instanced. Metres, z up. */
#ifndef BATTLEFIELD_H
#define BATTLEFIELD_H

#include "scene.h"

enum {
    BATTLEFIELD_TARGET = 1,       /* never to be lost from sight; without it a distractor */
    BATTLEFIELD_IMPENETRABLE = 2, /* never seen through */
    BATTLEFIELD_HOLLOW = 4,       /* its inside is to be seen; without it a solid */
    BATTLEFIELD_BACKDROP = 8      /* nothing that matters is ever behind it */
};

/* One a part of the scene. */
typedef struct battlefield_object {
    uint32_t flags;
    uint32_t group;   /* parts of one building have one number; 0: alone */
    int rank;         /* within the group from the inside out: floor, walls, roof */
    float importance; /* 0 to 1 */
} battlefield_object;

typedef struct battlefield_desc {
    uint32_t seed;                         /* 0: 1 */
    size_t trees, tanks, soldiers;         /* 0: 1000, 48, 96; half of the tanks and soldiers are targets */
    size_t houses, bunkers, bushes, rocks; /* 0: 9, 4, 120, 60 */
} battlefield_desc;

typedef struct battlefield_unit battlefield_unit;

typedef struct battlefield {
    scene *scene;
    battlefield_object *objects;
    battlefield_unit *units; /* what moves */
    size_t unit_count;
    double eye[3], look_at[3]; /* where to stand at first */
} battlefield;

/* Seconds after which every unit is back where it was. */
#define BATTLEFIELD_PERIOD 48.0

/* Each returns NULL when out of memory. A desc may be NULL. As many of everything as find room are placed. */
battlefield *battlefield_create(const battlefield_desc *desc);
/* 6.1 of the paper: a cube of 100 with 200 spheres, cones, boxes and toruses, of which 30 are targets, in red. To be seen
 * from `eye` or anywhere as far from the middle: all of it is then in a view 45 degrees high and wide. */
battlefield *battlefield_create_abstract(uint32_t seed);
/* 6.2: rooms on a plan of 16 x 16 cells, each joined to all its neighbours by doors, with 100 objects, all targets. The
 * ceiling is hidden, so that plans can be drawn; walkers show it. */
battlefield *battlefield_create_walkthrough(uint32_t seed);
void battlefield_destroy(battlefield *b); /* NULL is fine */

/* Puts every unit where it is at a time in seconds: transforms, and the strides of soldiers. */
void battlefield_move(battlefield *b, double time);

#endif

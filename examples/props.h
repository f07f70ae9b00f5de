/* props.h: what stands and drives on the example battlefield, and in the example rooms: trees, vehicles, people, houses,
 * furniture. Each is one mesh of closed shells with colours of its own, in metres, z up, looking along +x, its origin on the
 * ground below its middle. Nothing is random but by the seed that is given. */
#ifndef PROPS_H
#define PROPS_H

#include "scene.h"

/* A small generator of our own: the same numbers on every machine. */
typedef struct dice {
    uint32_t state;
} dice;

uint32_t dice_throw(dice *d); /* 32 bits */
double dice_between(dice *d, double low, double high);

/* Each adds a mesh to the scene and returns its index, SIZE_MAX when out of memory. `name` is the mesh's. */
size_t prop_conifer(scene *s, const char *name, double height, uint32_t seed);
size_t prop_broadleaf(scene *s, const char *name, double height, uint32_t seed);
size_t prop_bush(scene *s, const char *name, double height, uint32_t seed);
size_t prop_rock(scene *s, const char *name, double size, uint32_t seed);
size_t prop_tank(scene *s, const char *name, const float color[3], double turret_angle);
size_t prop_soldier(scene *s, const char *name, const float color[3], double stride); /* stride: -1 to 1 */
size_t prop_bunker(scene *s, const char *name);

/* A wall of length x height along x from 0, its outside toward -y, with windows and a door (-1: no door) at a place. */
typedef struct prop_opening {
    double x, z, width, height;
    bool door; /* open; else a window with a pane */
} prop_opening;
size_t prop_wall(scene *s, const char *name, const float color[3], double length, double height, double thickness,
                 double gable, const prop_opening *openings, size_t opening_count);
/* A roof over length x width, its middle at the origin, eaves at z = 0, ridge along x. */
size_t prop_roof(scene *s, const char *name, const float color[3], double length, double width, double rise);

/* The paper's shapes: about 1 across, the middle at the origin. */
size_t prop_ball(scene *s, const char *name, double size);
size_t prop_cone(scene *s, const char *name, double size);
size_t prop_cube(scene *s, const char *name, double size);
size_t prop_torus(scene *s, const char *name, double size);

size_t prop_table(scene *s, const char *name);
size_t prop_chair(scene *s, const char *name);
size_t prop_shelf(scene *s, const char *name);
size_t prop_lamp(scene *s, const char *name);
size_t prop_plant(scene *s, const char *name);
size_t prop_cat(scene *s, const char *name);
size_t prop_car(scene *s, const char *name);

/* Ground: a slab over a square of `size` around the origin with its upper side at height(x, y), colour from paint. */
size_t prop_ground(scene *s, const char *name, double size, size_t steps, double (*height)(double x, double y),
                   void (*paint)(double x, double y, float color[3]));
/* A mound; how high it is at a share of its radius: below 0 at 1. */
size_t prop_hill(scene *s, const char *name, double radius, double peak);
double prop_hill_height(double share, double peak);
/* A slab from corner to corner. */
size_t prop_slab(scene *s, const char *name, const float color[3], const double low[3], const double high[3]);

#endif

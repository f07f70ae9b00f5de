/* overlap.h: which sides a surface shows, and how much of it lies before other parts of it, in six small pictures along the
 * axes. Whether a single surface wants to be seen through. */
#ifndef OVERLAP_H
#define OVERLAP_H

#include <stdbool.h>

#include "scene.h"

/* Shares of the covered pixels, 0 to 1; 0 where none is covered. */
typedef struct overlap {
    double layered, back; /* two layers or more; the nearest one is seen from behind */
} overlap;

enum { OVERLAP_VIEWS = 6 }; /* from +x, -x, +y, -y, +z, -z of the mesh */

/* False: no memory. */
bool overlap_measure(const scene_mesh *mesh, overlap views[OVERLAP_VIEWS]);

/* A surface that rolls up: both sides are seen (5 to 95 % each) in four of the views at least, and half of what is covered
 * is so twice. Nothing that has an outside is that, even if its bottom is missing. */
bool overlap_is_rolled(const overlap views[OVERLAP_VIEWS]);

#endif

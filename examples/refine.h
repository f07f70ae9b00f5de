/* refine.h: divides the triangles of a mesh until no edge is longer than wanted, without a crack between neighbours.
 *
 * Values that are computed at vertices and interpolated, such as alpha by the distance to a silhouette, need vertices
 * close enough together: a box has corners only, all of them on its silhouette. */
#ifndef REFINE_H
#define REFINE_H

#include "scene.h"

/* Fills `out` (arrays malloc'd, name NULL) with `in` divided; the vertices of `in` come first, in order. Stops early
 * when there would be more than most_triangles. False: out of memory. */
bool refine_mesh(const scene_mesh *in, double longest_edge, size_t most_triangles, scene_mesh *out);

#endif

/* models.h: models made from formulas, for the examples and the tests: no file is needed and nothing is random.
 *
 * The clean ones consist of closed parts whose triangles face outward, but for four of sheets: squares, cylinders,
 * klein_bottle and stream_surface. Those whose names begin with "dirty_" have the faults of files seen in the wild, one
 * kind each. */
#ifndef MODELS_H
#define MODELS_H

#include "scene.h"

/* The names, ending with NULL. */
extern const char *const models_names[];

/* NULL: no such name, or out of memory. */
scene *models_make(const char *name);

#endif

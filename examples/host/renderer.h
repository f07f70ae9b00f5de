/* renderer.h: the passes of a frame.
 *
 *     sun        depth of the world as the sun sees it
 *     prepass    depth of the world, reversed
 *     world      lit colour, normal and id, where the depth is equal
 *     occlusion  how open each pixel lies, from depth and normals
 *     resolve    the picture */
#ifndef HOST_RENDERER_H
#define HOST_RENDERER_H

#include "gpu.h"
#include "world.h"

enum { RENDERER_SCALE = 2 }; /* samples in each direction for a pixel */

typedef struct camera {
    vec3 eye, target;
    float fov_y, nearest;
} camera;

/* As the shaders' block has it. */
typedef struct frame_block {
    mat4 clip_from_world, view_from_world, sun_from_world;
    float eye[4], sun[4], lens[4];
} frame_block;

/* What a program for the world exists in: with and without bones. */
typedef GLuint world_programs[2];

typedef struct renderer {
    gpu_cache cache;
    world_programs sun, prepass, lit;
    GLuint occlusion, resolve, empty_array;
    GLuint frame_buffer, material_buffer, palette_buffer, instance_buffer;
    GLintptr material_stride, palette_stride;
    gpu_target sun_target, world_target, occlusion_target, picture;
    frame_block frame;
} renderer;

bool renderer_create(renderer *r, int width, int height);

/* The picture is in r->picture afterwards. */
void renderer_draw(renderer *r, const world *w, const camera *c);

void renderer_destroy(renderer *r);

#endif

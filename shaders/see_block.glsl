// For: transparency.h
// What is the same for all passes of a frame of dynamic transparency (std140, written by tr_begin_dynamic).
layout(std140) uniform tr_frame
{
    highp vec4 tr_light;          // xyz: toward the light, unit length, in the space of the normals
    highp vec4 tr_cool;           // rgb, and how much diffuse colour is mixed in
    highp vec4 tr_warm;
    highp vec4 tr_viewport;       // x, y, width, height of the target's viewport
    highp vec4 tr_see_law;        // opacity before a target, and beside it; width of the gradient; how many lights,
                                  // or -1: none, and targets are drawn in colour
    highp vec4 tr_see_background; // rgb: where nothing is drawn; a: 1 where each occluder counts on its own
    highp ivec4 tr_see_grid;      // pixels a texel of masks; a cell; frame index; pixels that masks reach
    highp vec4 tr_see_lights[8];  // x, y, radius, edge, pixels of the viewport
    highp uvec4 tr_see_tiles[500]; // four each: x0, y0, x1, y1 in cells, a byte each, x0 the lowest
};

#ifdef TR_REVERSED_Z
#define TR_BEHIND(a, b) ((a) < (b))
#else
#define TR_BEHIND(a, b) ((a) > (b))
#endif

// For: transparency.h
// What is the same for all passes of one frame (std140, written by tr_begin).
layout(std140) uniform tr_frame
{
    highp vec4 tr_light;    // xyz: toward the light, unit length, in the space of the normals
    highp vec4 tr_cool;     // rgb, and how much diffuse colour is mixed in
    highp vec4 tr_warm;
    highp vec4 tr_weights;  // x: of opaque things, y: of the background, z: tolerance of lines in pixels
    highp vec4 tr_viewport; // x, y, width, height of the target's viewport
    highp vec4 tr_ink[2];   // rgb: creases; outlines
};

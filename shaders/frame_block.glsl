// For: transparency.h
// What is the same for all passes of one frame (std140, written by tr_begin), but for its last member.
layout(std140) uniform tr_frame
{
    highp vec4 tr_light;    // xyz: toward the light, unit length, in the space of the normals
    highp vec4 tr_cool;     // rgb, and how much diffuse colour is mixed in
    highp vec4 tr_warm;
    highp vec4 tr_weights;  // x: of opaque things, y: of the background, z: tolerance of lines in pixels
    highp vec4 tr_viewport; // x, y, width, height of the target's viewport
    highp vec4 tr_ink[2];   // rgb: creases; outlines
    highp vec4 tr_eye;      // distance along the view of window depth d: (x + y d) / (z + w d)
    highp vec4 tr_blend;    // rgb: stands for the background behind transparent surfaces; a: group distance
    highp vec4 tr_enter;    // x: strength of the shade, y: its width, z: width of the curve, in pixels
    highp vec4 tr_shift;    // xy: sub-pixel jitter in pixels
    highp ivec4 tr_step;    // x: the layer that this pass reads; yz: where the viewport is in the host's opaque textures
};

// How far a window depth is from the eye, along the view direction.
highp float tr_distance_of(highp float depth)
{
    return (tr_eye.x + tr_eye.y * depth) / (tr_eye.z + tr_eye.w * depth);
}

// For: transparency.h
// What is the same for all passes of a frame of TR_SEE_EXACT, TR_SEE_SEQUENCE and TR_SEE_PUBLISHED, and the masks of one
// run of passes (std140, written by tr_begin_dynamic).
struct tr_mask {
    highp vec4 box; // x0, y0, x1, y1 in pixels of the viewport, x1 and y1 outside; the mask lies well within
    highp vec4 law; // x: strength, 1 less what has faded, y: 1: opens in lights only, z: importance, w: the target's id
};
layout(std140) uniform tr_frame
{
    highp vec4 tr_light; // of built-in shading, as in frame_block.glsl
    highp vec4 tr_cool;
    highp vec4 tr_warm;
    highp vec4 tr_seq_law;       // x: alpha_target, y: alpha_start, z: width of the gradient in pixels, w: tr_mask_shape
    highp vec4 tr_seq_background;
    highp ivec4 tr_seq_view;     // the viewport: x, y, width, height
    highp ivec4 tr_seq_numbers;  // x: divisor, y: how far a mask reaches, in pixels, z: layer control, 0: none, w: lights
    highp ivec4 tr_seq_step;     // x: which layer a pass peels or keeps; y: 1: masks multiply,
                                 // z: 1: whole masks cut targets, w: 1: units are painted into a target of our own
    highp ivec4 tr_seq_more;     // x: layers peeled in all, y: 1: the last of them is the end, z: 1: something closes masks,
                                 // w: 1: occluders share a mask
    highp vec4 tr_seq_lights[8]; // x, y, radius, edge in pixels of the viewport
    tr_mask tr_masks[64];
};

#ifdef TR_REVERSED_Z
#define TR_NEARER(a, b) ((a) > (b))
#define TR_NO_REACH 1.0
#else
#define TR_NEARER(a, b) ((a) < (b))
#define TR_NO_REACH 0.0
#endif

// For: transparency.h
// After a layer is peeled: whose it is goes where later layers look it up, with whether it ends the pixel.
uniform highp sampler2D tr_reach;
uniform highp usampler2D tr_code;             // of the layer
uniform highp sampler2DArray tr_layer_now;    // its depth
uniform highp sampler2DArray tr_layer_before; // that of the one before
layout(location = 0) out highp uvec4 tr_kept;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int layer = tr_seq_step.x;
    highp float reach = texelFetch(tr_reach, pixel, 0).r, depth = texelFetch(tr_layer_now, ivec3(pixel, layer >> 1), 0).r;
    highp uint code = texelFetch(tr_code, pixel, 0).r;
    if (reach == TR_NO_REACH)
        discard;
    if (depth == TR_CLEAR_DEPTH)
        code = TR_LAYER_LAST | TR_LAYER_NONE;
    else if (!TR_NEARER(depth, reach))
        code |= TR_LAYER_LAST;
    if (layer > 0 && depth == texelFetch(tr_layer_before, ivec3(pixel, (layer - 1) >> 1), 0).r)
        code |= TR_LAYER_COINCIDENT;
    tr_kept = uvec4(code, 0u, 0u, 0u);
}

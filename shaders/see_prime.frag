// For: transparency.h
// Opens the depth buffer where a mask is, and nowhere else: the depth test then stops all else before it is shaded. What
// is there in colour already, the target or all that never yields, only what is before it may cover.
uniform highp sampler2D tr_see_mask;
#if TR_IN_PARTS
uniform highp sampler2D tr_see_depth;  // of all that never yields
#elif TR_HAS_COLOR
uniform highp sampler2D tr_see_depth;  // of the mask
uniform highp sampler2D tr_see_behind; // in alpha the strength, 0 where there is no target
#endif
layout(location = 0) out highp vec4 tr_color;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    highp vec2 mask = texelFetch(tr_see_mask, pixel, 0).rg;
    if (mask.r == 1.0 || mask.g == 0.0)
        discard;
    tr_color = vec4(tr_see_background.rgb, 1.0);
    gl_FragDepth = TR_CLEAR_DEPTH;
#if TR_IN_PARTS
    gl_FragDepth = texelFetch(tr_see_depth, pixel, 0).r;
#elif TR_HAS_COLOR
    if (texelFetch(tr_see_behind, pixel, 0).a > 0.0)
        gl_FragDepth = texelFetch(tr_see_depth, pixel, 0).r;
#endif
}

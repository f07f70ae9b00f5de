// For: transparency.h
// What shows through masks, over the scene: alpha of it is what the mask takes away. At the mask's depth, so that where
// the target has depth this is done behind what was drawn there, and nothing where the scene lies behind anyway.
uniform highp sampler2D tr_see_depth;
uniform highp sampler2D tr_see_mask;
uniform highp sampler2D tr_see_behind;
#if TR_HAS_YIELD
uniform highp sampler2D tr_see_yield; // importance of the front-most unit
#endif
layout(location = 0) out highp vec4 tr_color;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy) - ivec2(tr_viewport.xy);
    highp vec2 mask = texelFetch(tr_see_mask, pixel, 0).rg;
#if TR_HAS_YIELD
    mask.g = clamp(mask.g - texelFetch(tr_see_yield, pixel, 0).r, 0.0, 1.0);
#endif
    if (mask.r == 1.0 || mask.g == 0.0)
        discard;
    tr_color = vec4(texelFetch(tr_see_behind, pixel, 0).rgb, (1.0 - mask.r) * mask.g);
    gl_FragDepth = texelFetch(tr_see_depth, pixel, 0).r;
}

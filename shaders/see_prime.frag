// For: transparency.h
// Opens the depth buffer where a mask is, and nowhere else: the depth test then stops all else before it is shaded.
uniform highp sampler2D tr_see_mask;
layout(location = 0) out highp vec4 tr_color;

void main()
{
    highp vec2 mask = texelFetch(tr_see_mask, ivec2(gl_FragCoord.xy), 0).rg;
    if (mask.r == 1.0 || mask.g == 0.0)
        discard;
    tr_color = vec4(tr_see_background.rgb, 1.0);
    gl_FragDepth = TR_CLEAR_DEPTH;
}

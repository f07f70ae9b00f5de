// For: transparency.h
// For tr_query_hidden: a texel for 4 by 4 pixels, the id of the target at its middle in two bytes.
uniform highp sampler2D tr_see_mark;
layout(location = 0) out highp vec4 tr_color;

void main()
{
    ivec2 size = ivec2(tr_viewport.zw);
    ivec2 pixel = min(ivec2(gl_FragCoord.xy * tr_viewport.zw / vec2((size + 3) >> 2)), size - 1);
    tr_color = vec4(texelFetch(tr_see_mark, pixel, 0).rg, 0.0, 0.0);
}

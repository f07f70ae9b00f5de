// For: transparency.h
// What was painted into a target of our own, over the host's: colour is premultiplied.
uniform highp sampler2D tr_own_color;
uniform highp sampler2D tr_own_depth;
layout(location = 0) out highp vec4 tr_color;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy) - tr_seq_view.xy;
    tr_color = texelFetch(tr_own_color, pixel, 0);
    if (tr_color.a <= 0.0)
        discard;
    gl_FragDepth = texelFetch(tr_own_depth, pixel, 0).r;
}

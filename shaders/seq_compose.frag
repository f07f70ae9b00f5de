// For: transparency.h
// The layers of a pixel, front to back, over the background.
uniform highp sampler2D tr_reach;
uniform highp usampler2DArray tr_chain;
uniform highp sampler2DArray tr_layer_color;
uniform highp sampler2DArray tr_layer_alphas; // of four a slice
layout(location = 0) out highp vec4 tr_color;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy) - tr_seq_view.xy;
    highp float left = 1.0;
    highp vec3 sum = vec3(0.0);
    if (texelFetch(tr_reach, pixel, 0).r == TR_NO_REACH)
        discard;
    for (int i = 0; i < tr_seq_more.x; ++i) {
        highp uint code = texelFetch(tr_chain, ivec3(pixel, i), 0).r;
        if ((code & TR_LAYER_NONE) != 0u)
            break;
        highp float alpha = texelFetch(tr_layer_alphas, ivec3(pixel, i >> 2), 0)[i & 3];
        sum += left * alpha * texelFetch(tr_layer_color, ivec3(pixel, i), 0).rgb;
        left *= 1.0 - alpha;
        if ((code & TR_LAYER_LAST) != 0u || left <= 0.0)
            break;
    }
    tr_color = vec4(sum + left * tr_seq_background.rgb, 1.0);
}

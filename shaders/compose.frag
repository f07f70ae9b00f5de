// For: transparency.h
// The transparent layer over opaque things, into the host's target; Diepstraten 2002, sections 5 and 7.
//
// alpha_t, C_t: the transparent surface; w, C_d: what is behind it, an opaque thing or the background, which is what
// the host's target holds. All three blendings have the form rgb + a * target, drawn with the blend function
// (ONE, SRC_ALPHA), so that the target's own alpha is neither needed nor touched.
#define TR_BLENDING_OVER 0
#define TR_BLENDING_NORMALISED 1
#define TR_BLENDING_PUBLISHED 2

uniform highp sampler2D tr_scene_depth;
#if TR_HAS_OPAQUE
uniform highp sampler2D tr_opaque_color; // a = 1 where an opaque thing is
#endif
#if TR_HAS_LAYER
uniform highp sampler2D tr_front_depth;
uniform highp sampler2D tr_layer_color;
#endif
layout(location = 0) out highp vec4 tr_color;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy) - ivec2(tr_viewport.xy);
    highp float depth = texelFetch(tr_scene_depth, pixel, 0).r;
    gl_FragDepth = depth;
#if TR_HAS_OPAQUE
    highp vec4 behind = texelFetch(tr_opaque_color, pixel, 0);
#else
    highp vec4 behind = vec4(0.0);
#endif
    bool opaque = behind.a > 0.5;
    // What is behind, as rgb + keep * target.
    highp float keep = opaque ? 0.0 : 1.0;
    highp vec3 color = opaque ? behind.rgb : vec3(0.0);
#if TR_HAS_LAYER
    // The scene's depth is the front-most transparent surface's where that was drawn, and only there.
    if (depth != TR_CLEAR_DEPTH && depth == texelFetch(tr_front_depth, pixel, 0).r) {
        highp vec4 front = texelFetch(tr_layer_color, pixel, 0);
        highp float weight = opaque ? tr_weights.x : tr_weights.y;
#if TR_BLENDING == TR_BLENDING_OVER
        weight = 1.0 - front.a;
#elif TR_BLENDING == TR_BLENDING_NORMALISED
        highp float total = front.a + weight;
        front.a = total > 0.0 ? front.a / total : 0.0;
        weight = 1.0 - front.a;
#endif
        // The published sum may be above one; where the target adds its own part, its format clamps.
        tr_color = vec4(min(front.a * front.rgb + weight * color, 1.0), weight * keep);
        return;
    }
#endif
    if (!opaque)
        discard;
    tr_color = vec4(color, keep);
}

// For: transparency.h
// Opaque things from the host's textures. Of those the nearest alone can show, whatever the rule: where the limit hides it,
// it hides all behind it. The depth test against the limit decides; the far value, which is nearer than nothing, is
// background. What is outside of the textures, and NaN, too.
//
// TR_SUPERSAMPLE: the host's texel stands for that many of ours along each side.
// TR_SRGB: what is read is light; our textures hold display values, IEC 61966-2-1.
uniform highp sampler2D tr_scene_depth;  // the host's
uniform highp sampler2D tr_opaque_color; // the host's
layout(location = 0) out highp vec4 tr_color;

#ifdef TR_REVERSED_Z
#define TR_IS_SOMETHING(depth) ((depth) > 0.0)
#else
#define TR_IS_SOMETHING(depth) ((depth) < 1.0)
#endif

highp vec3 tr_display_of(highp vec3 light)
{
#if TR_SRGB
    light = clamp(light, 0.0, 1.0);
    return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));
#else
    return light;
#endif
}

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy) / TR_SUPERSAMPLE + tr_step.yz;
    if (any(greaterThanEqual(texel, min(textureSize(tr_scene_depth, 0), textureSize(tr_opaque_color, 0)))))
        discard;
    highp float depth = texelFetch(tr_scene_depth, texel, 0).r;
    if (!TR_IS_SOMETHING(depth))
        discard;
    tr_color = vec4(tr_display_of(texelFetch(tr_opaque_color, texel, 0).rgb), 1.0);
    gl_FragDepth = depth;
}

// For: transparency.h
// Transparent layers over opaque things, into the host's target; Diepstraten 2002, sections 5 and 7.
//
// alpha_t, C_t: a transparent surface; w, C_d: what is behind it, an opaque thing or the background, which is what the
// host's target holds. All three blendings have the form rgb + a * target, drawn with the blend function
// (ONE, SRC_ALPHA), so that the target's own alpha is neither needed nor touched.
//
// TR_SUPERSAMPLE: our textures have that many texels along each side of a target's pixel, averaged here.
#define TR_BLENDING_OVER 0
#define TR_BLENDING_NORMALISED 1
#define TR_BLENDING_PUBLISHED 2

#if TR_HAS_SCENE
uniform highp sampler2D tr_scene_depth;
#endif
#if TR_HAS_OPAQUE
uniform highp sampler2D tr_opaque_color; // a = 1 where an opaque thing is
#endif
#if TR_LAYERS > 0
uniform highp sampler2DArray tr_front_depth; // of layers 0, 2, 4, ...
uniform highp sampler2DArray tr_layer_color;
#endif
#if TR_LAYERS > 1
uniform highp sampler2DArray tr_odd_depth; // of layers 1, 3, 5, ...
#endif
layout(location = 0) out highp vec4 tr_color;

#ifdef TR_REVERSED_Z
#define TR_BEHIND(a, b) ((a) < (b))
#else
#define TR_BEHIND(a, b) ((a) > (b))
#endif

// Display values to light, IEC 61966-2-1, where light is what is blended.
highp vec3 tr_light_of(highp vec3 color)
{
#if TR_SRGB
    return mix(color * (1.0 / 12.92), pow((color + 0.055) * (1.0 / 1.055), vec3(2.4)), step(0.04045, color));
#else
    return color;
#endif
}

#if TR_LAYERS > 0
highp float tr_depth_of_layer(ivec2 pixel, int layer)
{
#if TR_LAYERS > 1
    if ((layer & 1) != 0)
        return texelFetch(tr_odd_depth, ivec3(pixel, layer >> 1), 0).r;
#endif
    return texelFetch(tr_front_depth, ivec3(pixel, layer >> 1), 0).r;
}

// A layer's surface over rgb + a * target.
highp vec4 tr_over(highp vec4 surface, highp vec4 behind, highp float weight)
{
#if TR_BLENDING == TR_BLENDING_OVER
    weight = 1.0 - surface.a;
#elif TR_BLENDING == TR_BLENDING_NORMALISED
    highp float total = surface.a + weight;
    surface.a = total > 0.0 ? surface.a / total : 0.0;
    weight = 1.0 - surface.a;
#endif
    // The published sum may be above one; where the target adds its own part, its format clamps.
    return vec4(min(surface.a * tr_light_of(surface.rgb) + weight * behind.rgb, 1.0), weight * behind.a);
}
#endif

// One texel: rgb + a * target; depth of what is seen there, TR_CLEAR_DEPTH where nothing is.
highp vec4 tr_compose(ivec2 pixel, out highp float depth)
{
    highp vec4 result = vec4(0.0, 0.0, 0.0, 1.0);
    highp float weight = tr_weights.y;
    bool hides = TR_PUBLISHED != 0; // published: the limit hides transparent surfaces too
    depth = TR_CLEAR_DEPTH;
#if TR_HAS_SCENE
    highp float scene = texelFetch(tr_scene_depth, pixel, 0).r;
#else
    highp float scene = TR_CLEAR_DEPTH;
#endif
#if TR_HAS_OPAQUE
    highp vec4 opaque = texelFetch(tr_opaque_color, pixel, 0);
    if (opaque.a > 0.5) {
        result = vec4(tr_light_of(opaque.rgb), 0.0);
        weight = tr_weights.x;
        hides = true;
        depth = scene;
    }
#endif
#if TR_LAYERS > 0
    bool first = true;
#if TR_CHAIN
    int layers = tr_chain(pixel, TR_LAYERS);
#else
    const int layers = TR_LAYERS;
#endif
    for (int layer = layers - 1; layer >= 0; --layer) {
        highp float at = tr_depth_of_layer(pixel, layer);
        if (at == TR_CLEAR_DEPTH || (hides && TR_BEHIND(at, scene)))
            continue;
#if TR_BLEND_COLOR
        if (first && result.a > 0.0)
            result = vec4(tr_light_of(tr_blend.rgb), 0.0);
#endif
        first = false;
        result = tr_over(texelFetch(tr_layer_color, ivec3(pixel, layer), 0), result, weight);
        depth = at;
    }
#endif
    return result;
}

void main()
{
    ivec2 corner = (ivec2(gl_FragCoord.xy) - ivec2(tr_viewport.xy)) * TR_SUPERSAMPLE;
    highp vec4 sum = vec4(0.0);
    highp float nearest = TR_CLEAR_DEPTH;
    for (int y = 0; y < TR_SUPERSAMPLE; ++y) {
        for (int x = 0; x < TR_SUPERSAMPLE; ++x) {
            highp float depth;
            sum += tr_compose(corner + ivec2(x, y), depth);
            nearest = TR_BEHIND(nearest, depth) ? depth : nearest;
        }
    }
    tr_color = sum * (1.0 / float(TR_SUPERSAMPLE * TR_SUPERSAMPLE));
    if (nearest == TR_CLEAR_DEPTH && tr_color.a == 1.0)
        discard;
    gl_FragDepth = nearest;
}

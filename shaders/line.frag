// For: transparency.h
// Feature lines: fragment stage.
//
// A line lies on the rim of its own surface: tested pixel by pixel, the surface would eat its inner half. So a line's
// visibility is that of its centre, against the farthest depth around it: on a silhouette one side always lies
// farther, and where something covers the line all sides are nearer.
#define TR_LINE_VISIBLE 0
#define TR_LINE_HIDDEN 1 // what the others leave out
#define TR_LINE_OUTER 2  // only where no surface is: the outer half of wide outlines, Gooch 1999, section 5.1.3

#ifdef TR_REVERSED_Z
#define TR_BEHIND(a, b) ((a) < (b))
#else
#define TR_BEHIND(a, b) ((a) > (b))
#endif
#if TR_ON_TARGET
#define TR_ORIGIN ivec2(tr_viewport.xy)
#define TR_TEXELS TR_SUPERSAMPLE // of our textures, along each side of a pixel that is drawn
#else
#define TR_ORIGIN ivec2(0)
#define TR_TEXELS 1
#endif
#if TR_HAS_SCENE
uniform highp sampler2D tr_scene_depth;
#endif
#if TR_HAS_FRONT // 2: seen through by this line, which is an opaque object's
uniform highp sampler2DArray tr_front_depth;
#endif
in highp vec4 tr_v_line;
layout(location = 0) out highp vec4 tr_color;

// The nearest of what is seen at a texel, with transparent surfaces or without.
highp float tr_depth_at(ivec2 texel, bool transparent)
{
    highp float depth = TR_CLEAR_DEPTH;
#if TR_HAS_SCENE
    texel = clamp(texel, ivec2(0), textureSize(tr_scene_depth, 0) - 1);
    depth = texelFetch(tr_scene_depth, texel, 0).r;
#endif
#if TR_HAS_FRONT
    texel = clamp(texel, ivec2(0), textureSize(tr_front_depth, 0).xy - 1);
    highp float front = texelFetch(tr_front_depth, ivec3(texel, 0), 0).r;
    depth = transparent && TR_BEHIND(depth, front) ? front : depth;
#endif
    return depth;
}

highp vec3 tr_light_of(highp vec3 color)
{
#if TR_SRGB && TR_ON_TARGET
    return mix(color * (1.0 / 12.92), pow((color + 0.055) * (1.0 / 1.055), vec3(2.4)), step(0.04045, color));
#else
    return color;
#endif
}

void main()
{
    ivec2 center = ivec2(floor(tr_v_line.xy * float(TR_SUPERSAMPLE)));
    highp float tolerance = tr_v_line.w * tr_weights.z;
#ifdef TR_REVERSED_Z
    highp float nearer = tr_v_line.z + tolerance;
    highp float farthest = 1.0;
#else
    highp float nearer = tr_v_line.z - tolerance;
    highp float farthest = 0.0;
#endif
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            highp float depth = tr_depth_at(center + ivec2(x, y) * TR_SUPERSAMPLE, TR_HAS_FRONT == 1);
            farthest = TR_BEHIND(depth, farthest) ? depth : farthest;
        }
    }
#if TR_LINE == TR_LINE_HIDDEN
    if (!TR_BEHIND(nearer, farthest))
        discard;
#else
    if (TR_BEHIND(nearer, farthest))
        discard;
#endif
    // The nearer of line and surface: passes the depth test wherever the centre is visible, and hides what comes later.
    ivec2 pixel = (ivec2(gl_FragCoord.xy) - TR_ORIGIN) * TR_TEXELS;
    highp float surface = TR_CLEAR_DEPTH;
    for (int i = 0; i < TR_TEXELS * TR_TEXELS; ++i) {
        highp float depth = tr_depth_at(pixel + ivec2(i % TR_TEXELS, i / TR_TEXELS), true);
        surface = TR_BEHIND(surface, depth) ? depth : surface;
    }
#if TR_LINE == TR_LINE_OUTER
    if (surface != TR_CLEAR_DEPTH)
        discard;
#endif
    gl_FragDepth = TR_BEHIND(tr_v_line.z, surface) ? surface : tr_v_line.z;
    tr_color = vec4(tr_light_of(tr_ink[TR_INK].rgb), 1.0);
}

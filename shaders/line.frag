// For: transparency.h
// Feature lines: fragment stage.
//
// A line lies on the rim of its own surface: tested pixel by pixel, the surface would eat its inner half. So a line's
// visibility is that of its centre, against the farthest depth around it: on a silhouette one side always lies
// farther, and where something covers the line all sides are nearer.
#if TR_ON_TARGET
#define TR_ORIGIN ivec2(tr_viewport.xy)
#else
#define TR_ORIGIN ivec2(0)
#endif
uniform highp sampler2D tr_scene_depth;
in highp vec4 tr_v_line;
layout(location = 0) out highp vec4 tr_color;

void main()
{
    ivec2 last = textureSize(tr_scene_depth, 0) - 1;
    ivec2 center = ivec2(floor(tr_v_line.xy));
    highp float tolerance = tr_v_line.w * tr_weights.z;
#ifdef TR_REVERSED_Z
    highp float farthest = 1.0;
#else
    highp float farthest = 0.0;
#endif
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            highp float depth = texelFetch(tr_scene_depth, clamp(center + ivec2(x, y), ivec2(0), last), 0).r;
#ifdef TR_REVERSED_Z
            farthest = min(farthest, depth);
#else
            farthest = max(farthest, depth);
#endif
        }
    }
#ifdef TR_REVERSED_Z
    if (tr_v_line.z + tolerance < farthest)
        discard;
#else
    if (tr_v_line.z - tolerance > farthest)
        discard;
#endif
    // The nearer of line and surface: passes the depth test wherever the centre is visible, and hides what comes later.
    ivec2 pixel = ivec2(gl_FragCoord.xy) - TR_ORIGIN;
    highp float surface = texelFetch(tr_scene_depth, clamp(pixel, ivec2(0), last), 0).r;
#ifdef TR_REVERSED_Z
    gl_FragDepth = max(tr_v_line.z, surface);
#else
    gl_FragDepth = min(tr_v_line.z, surface);
#endif
    tr_color = vec4(tr_ink[TR_INK].rgb, 1.0);
}

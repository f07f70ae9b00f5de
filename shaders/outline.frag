// For: transparency.h
// Outlines in the image, and the nearest one of each pixel, for hosts without meshes on the CPU.
//
// TR_JUMP 0: a pixel of the surface is an outline where a neighbour is none of it, is another object's and farther, or
// is farther by more than the surface's own slope explains. TR_JUMP 1: one round of jump flooding (Rong and Tan 2006):
// the nearest outline that is known to one of the nine pixels tr_jump apart. Where there are ids, an object's pixels
// take outlines of that object alone.
uniform highp sampler2D tr_scene_depth;
#if TR_HAS_IDS
uniform highp usampler2D tr_ids;
#endif
#if TR_JUMP
uniform highp usampler2D tr_nearest; // x, y of a pixel; TR_NOWHERE: none is known
uniform highp int tr_jump;
#else
uniform highp vec4 tr_depth_law; // distance along the view of window depth d: (x + y d) / (z + w d)
uniform highp vec2 tr_pixel;     // size of a pixel in the world: x, or y at distance 1
#endif
layout(location = 0) out highp uvec2 tr_outline_here;

#define TR_NOWHERE 65535u

bool tr_same_object(ivec2 a, ivec2 b)
{
#if TR_HAS_IDS
    return texelFetch(tr_ids, a, 0).r == texelFetch(tr_ids, b, 0).r;
#else
    return true;
#endif
}

#if TR_JUMP
void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(tr_nearest, 0) - 1;
    highp float least = 3.0e38;
    tr_outline_here = uvec2(TR_NOWHERE);
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            ivec2 at = here + ivec2(x, y) * tr_jump;
            if (at != clamp(at, ivec2(0), last))
                continue;
            highp uvec2 found = texelFetch(tr_nearest, at, 0).rg;
            if (found.x == TR_NOWHERE || !tr_same_object(ivec2(found), here))
                continue;
            highp vec2 way = vec2(found) - vec2(here);
            if (dot(way, way) < least) {
                least = dot(way, way);
                tr_outline_here = found;
            }
        }
    }
}
#else
highp float tr_distance_at(ivec2 pixel)
{
    highp float depth = texelFetch(tr_scene_depth, pixel, 0).r;
    return (tr_depth_law.x + tr_depth_law.y * depth) / (tr_depth_law.z + tr_depth_law.w * depth);
}

bool tr_ends(ivec2 here, ivec2 step, highp float distance)
{
    ivec2 last = textureSize(tr_scene_depth, 0) - 1, next = here + step, before = here - step;
    if (next != clamp(next, ivec2(0), last))
        return false; // the image ends here, the object need not
    if (texelFetch(tr_scene_depth, next, 0).r == TR_CLEAR_DEPTH)
        return true;
    highp float gap = tr_distance_at(next) - distance;
    if (!tr_same_object(here, next))
        return gap > 0.0;
    highp float slope = 0.0;
    if (before == clamp(before, ivec2(0), last) && texelFetch(tr_scene_depth, before, 0).r != TR_CLEAR_DEPTH)
        slope = abs(distance - tr_distance_at(before));
    return gap > 3.0 * slope + 4.0 * (tr_pixel.x + tr_pixel.y * distance);
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    tr_outline_here = uvec2(TR_NOWHERE);
    if (texelFetch(tr_scene_depth, here, 0).r == TR_CLEAR_DEPTH)
        return;
    highp float distance = tr_distance_at(here);
    if (tr_ends(here, ivec2(1, 0), distance) || tr_ends(here, ivec2(-1, 0), distance) ||
        tr_ends(here, ivec2(0, 1), distance) || tr_ends(here, ivec2(0, -1), distance))
        tr_outline_here = uvec2(here);
}
#endif

// For: transparency.h
// View-dependent alpha, fragment stage: tr_alpha() is equation 2 of Diepstraten 2002 at this pixel, by the rung TR_ALPHA.
#define TR_ALPHA_DISTANCE 0
#define TR_ALPHA_PUBLISHED 1
#define TR_ALPHA_CANDIDATES 2
#define TR_ALPHA_EXACT 3
#define TR_ALPHA_IMAGE 4

uniform highp vec2 tr_falloff;
#if TR_ALPHA == TR_ALPHA_DISTANCE || TR_ALPHA == TR_ALPHA_PUBLISHED
in highp float tr_v_falloff;
#elif TR_ALPHA == TR_ALPHA_IMAGE
uniform highp usampler2D tr_outlines; // the nearest outline's pixel
uniform highp vec3 tr_outline;        // size of its pixels in the world where w is 1, its pixels a fragment
#define TR_NOWHERE 65535u
#else
uniform highp vec4 tr_edge_frame[4]; // [3].w: the unit of the frame, in the world
uniform highp uvec4 tr_edge_ranges;  // tr_edge_set.ranges
uniform highp sampler2D tr_edge_segments;
in highp vec3 tr_v_place;
#if TR_ALPHA == TR_ALPHA_CANDIDATES
uniform highp usampler2D tr_edge_lists;
#ifndef TR_TRIANGLE
flat in highp uint tr_v_triangle;
#define TR_TRIANGLE tr_v_triangle
#endif
#endif

#define TR_NO_LIST 0xffffffffu
#define TR_FAR 3.0e38

// Both textures are arrays in rows of 1024.
highp vec4 tr_edge_texel(highp uint at)
{
    return texelFetch(tr_edge_segments, ivec2(at & 1023u, at >> 10u), 0);
}

// The square of the distance to one segment: start and 1 / length^2 (0: a point), then the way to its end.
highp float tr_edge_square(highp uint segment)
{
    highp uint at = tr_edge_ranges.x + 2u * segment;
    highp vec4 start = tr_edge_texel(at);
    highp vec3 way = tr_edge_texel(at + 1u).xyz;
    highp vec3 from = tr_v_place - start.xyz;
    from -= clamp(dot(from, way) * start.w, 0.0, 1.0) * way;
    return dot(from, from);
}

highp float tr_edge_square_of_range(highp uint first, highp uint end, highp float least)
{
    for (highp uint i = first; i < end; ++i)
        least = min(least, tr_edge_square(i));
    return least;
}

#if TR_ALPHA == TR_ALPHA_CANDIDATES
highp uint tr_edge_entry(highp uint at)
{
    return texelFetch(tr_edge_lists, ivec2(at & 1023u, at >> 10u), 0).r;
}

highp float tr_edge_least()
{
    if (tr_edge_ranges.w == TR_NO_LIST)
        return tr_edge_square_of_range(0u, tr_edge_ranges.y, TR_FAR);
    highp uint offset = tr_edge_ranges.z + TR_TRIANGLE;
    highp uint first = tr_edge_entry(offset);
    // No list is longer than there are edges: a triangle that has none, drawn by mistake, is no endless loop.
    highp uint count = min(tr_edge_entry(offset + 1u) - first, tr_edge_ranges.y);
    highp float least = TR_FAR;
    for (highp uint i = 0u; i < count; ++i)
        least = min(least, tr_edge_square(tr_edge_entry(tr_edge_ranges.w + first + i)));
    return least;
}
#else
// Boxes of eight segments, of eight boxes and so on, each before its children, from texel x + 2 y on: middle and the
// number of the box after its last descendant; half size and the first of its segments, or -1.
highp float tr_edge_box_square(highp uint box, out highp uint next, out highp float leaf)
{
    highp uint at = tr_edge_ranges.x + 2u * (tr_edge_ranges.y + box);
    highp vec4 middle = tr_edge_texel(at), extent = tr_edge_texel(at + 1u);
    highp vec3 outside = max(abs(tr_v_place - middle.xyz) - extent.xyz, 0.0);
    next = max(uint(middle.w), box + 1u);
    leaf = extent.w;
    return dot(outside, outside);
}

highp float tr_edge_square_of_leaf(highp float leaf, highp float least)
{
    highp uint first = uint(leaf);
    return tr_edge_square_of_range(first, min(first + 8u, tr_edge_ranges.y), least);
}

// Down to the box that is nearest each time: a first guess, so that the search after it passes most boxes by.
highp float tr_edge_guess()
{
    highp uint box = 0u, end = 0u, next = 0u;
    highp float leaf = 0.0;
    tr_edge_box_square(0u, end, leaf);
    while (leaf < 0.0) {
        highp float least = TR_FAR, leaf_here = 0.0;
        highp uint best_end = end, best = box + 1u;
        for (highp uint child = box + 1u; child < end; child = next) {
            highp float square = tr_edge_box_square(child, next, leaf_here);
            if (square < least) {
                least = square;
                best = child;
                best_end = next;
                leaf = leaf_here;
            }
        }
        if (best >= tr_edge_ranges.z)
            return TR_FAR;
        box = best;
        end = best_end;
    }
    return tr_edge_square_of_leaf(leaf, TR_FAR);
}

highp float tr_edge_least()
{
    if (tr_edge_ranges.w != TR_NO_LIST)
        return tr_edge_square_of_range(0u, tr_edge_ranges.y, TR_FAR);
    highp float least = tr_edge_guess(), leaf = 0.0;
    highp uint next = 0u;
    for (highp uint box = 0u; box < tr_edge_ranges.z; box = next) {
        bool skip = tr_edge_box_square(box, next, leaf) >= least;
        if (!skip && leaf >= 0.0)
            least = tr_edge_square_of_leaf(leaf, least);
        if (!skip)
            next = box + 1u;
    }
    return least;
}
#endif
#endif

float tr_alpha()
{
#if TR_ALPHA == TR_ALPHA_PUBLISHED
    return tr_v_falloff;
#elif TR_ALPHA == TR_ALPHA_DISTANCE
    return tr_view_alpha(tr_v_falloff, tr_falloff.x, tr_falloff.y);
#elif TR_ALPHA == TR_ALPHA_IMAGE
    highp vec2 place = gl_FragCoord.xy * tr_outline.yz;
    highp uvec2 nearest = texelFetch(tr_outlines, ivec2(place), 0).rg;
    // gl_FragCoord.w is 1 / w: the distance along the view, or 1 where parallel lines stay parallel.
    highp float distance = length(vec2(nearest) + 0.5 - place) * tr_outline.x / gl_FragCoord.w;
    return tr_view_alpha(nearest.x == TR_NOWHERE ? 3.0e38 : distance, tr_falloff.x, tr_falloff.y);
#else
    if (!tr_positive(tr_falloff.x))
        return 1.0;
    highp float distance = TR_FAR; // without an edge, as with the eye inside: no silhouette anywhere
    if (tr_edge_ranges.y > 0u)
        distance = sqrt(tr_edge_least()) * tr_edge_frame[3].w;
    return tr_view_alpha(distance, tr_falloff.x, tr_falloff.y);
#endif
}

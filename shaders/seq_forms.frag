// For: transparency.h
// What circle, ellipse and convex hull of a target's pixels are found by, a column of texels a mask: how far the pixels' middles
// reach in each of 64 directions, then how much the rectangle of all has to be scaled for circle or ellipse to hold them.
// Bits of floats; 0: the target has no pixel.
uniform highp usampler2D tr_extents; // of seq_extents.frag
layout(location = 0) out highp uvec4 tr_form;

// Calls nothing for rows without the target; x: first, y: last, both middles of pixels.
bool tr_row(int mask, int row, out highp vec2 ends)
{
    highp uvec2 extent = texelFetch(tr_extents, ivec2(mask, row), 0).rg;
    ends = vec2(extent) - 0.5;
    return extent.x != 0u;
}

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    highp ivec4 box = ivec4(tr_masks[at.x].box);
    highp vec2 ends, low = vec2(1.0e6), high = vec2(-1.0e6);
    highp float angle = float(at.y) * (6.283185307179586 / 64.0), reach = -1.0e6, scale = 0.0;
    highp vec2 way = vec2(cos(angle), sin(angle));
    for (int y = box.y; y < box.w; ++y) {
        highp float middle = float(y) + 0.5;
        if (!tr_row(at.x, y, ends))
            continue;
        reach = max(reach, max(ends.x * way.x, ends.y * way.x) + middle * way.y);
        low = min(low, vec2(ends.x, middle));
        high = max(high, vec2(ends.y, middle));
    }
    tr_form = uvec4(0u);
    if (high.x < 0.0)
        return;
    tr_form.r = floatBitsToUint(reach);
    if (at.y < 64)
        return;
    highp vec2 radius = tr_seq_law.w == 1.0 ? vec2(1.0) : (high - low) * 0.5, centre = (low + high) * 0.5;
    for (int y = box.y; y < box.w; ++y) {
        highp float up = float(y) + 0.5 - centre.y, across;
        if (!tr_row(at.x, y, ends))
            continue;
        across = max(abs(ends.x - centre.x), abs(ends.y - centre.x));
        scale = max(scale, length(vec2(radius.x > 0.0 ? across / radius.x : 0.0, radius.y > 0.0 ? up / radius.y : 0.0)));
    }
    // A single pixel has none; 0 would say that there is not even that.
    tr_form.r = floatBitsToUint(max(scale, 1.0e-6));
}

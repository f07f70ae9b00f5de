// For: transparency.h
// The first and last pixel of a target in each row of its box: a column of texels a mask, a texel a row. Stored + 1; 0: none.
uniform highp sampler2D tr_seed;
layout(location = 0) out highp uvec4 tr_extent;

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    highp ivec4 box = ivec4(tr_masks[at.x].box);
    int first = -1, last = -1;
    tr_extent = uvec4(0u);
    if (at.y < box.y || at.y >= box.w)
        return;
    for (int x = box.x; x < box.z && first < 0; ++x)
        if (texelFetch(tr_seed, ivec2(x, at.y), 0).r != TR_CLEAR_DEPTH)
            first = x;
    for (int x = box.z - 1; x >= box.x && first >= 0 && last < 0; --x)
        if (texelFetch(tr_seed, ivec2(x, at.y), 0).r != TR_CLEAR_DEPTH)
            last = x;
    tr_extent = uvec4(uint(first + 1), uint(last + 1), 0u, 0u);
}

// For: transparency.h
// How far the nearest pixel of a target is: exact, by rows and then across them.
//
// TR_SPREAD 0: eight pixels of a row as bits, so that the next steps over empty space are long ones. TR_SPREAD 1: in its
// row, for each texel of masks, as the pixels from the texel's first one to it, plus 128, in 255ths; 0: none; of four rows
// at once, so that the next step reads them at once. TR_SPREAD 2: of the rows' the nearest, of equally near ones that
// nearest to the eye. A texel stands for the middle of its pixels; twice the positions are integers. Steps go outward.
uniform highp sampler2D tr_see_depth; // of targets
#if TR_IN_PARTS
uniform highp sampler2D tr_see_base;  // of all that never yields: the same where a target is open
#else
uniform highp sampler2D tr_see_mark;  // of targets: in alpha the strength, 0 where there is none; in blue 1 where active
#endif
#if TR_SPREAD != 0
uniform highp sampler2D tr_see_rows; // the step before this one's
#endif
layout(location = 0) out highp vec4 tr_color;

#if TR_SPREAD == 0
bool tr_is_target(ivec2 pixel)
{
#if TR_IN_PARTS
    highp float depth = texelFetch(tr_see_depth, pixel, 0).r;
    return depth != TR_CLEAR_DEPTH && depth == texelFetch(tr_see_base, pixel, 0).r;
#else
    return texelFetch(tr_see_mark, pixel, 0).a > 0.0;
#endif
}

void main()
{
    ivec2 first = ivec2(int(gl_FragCoord.x) * 8, int(gl_FragCoord.y));
    int bits = 0, count = min(8, int(tr_viewport.z) - first.x);
    for (int i = 0; i < count; ++i)
        bits |= tr_is_target(first + ivec2(i, 0)) ? 1 << i : 0;
    tr_color = vec4(float(bits) * (1.0 / 255.0));
}
#elif TR_SPREAD == 1
// The highest bit of a number above 0, by the exponent of a float.
int tr_highest(int bits)
{
    return (floatBitsToInt(float(bits)) >> 23) - 127;
}

int tr_bits(int block, int y)
{
    return int(texelFetch(tr_see_rows, ivec2(block, y), 0).r * 255.0 + 0.5);
}

highp float tr_nearest_in(int y)
{
    int divisor = tr_see_grid.x, reach = tr_see_grid.w + 2 * divisor, first = int(gl_FragCoord.x) * divisor;
    int from_left = first + (divisor - 1) / 2, from_right = first + divisor / 2;
    int left = -0x10000, right = 0x10000;
    int lowest = max(from_left - reach, 0), highest = min(from_right + reach, int(tr_viewport.z) - 1);
    for (int block = from_left >> 3, mask = (2 << (from_left & 7)) - 1; block * 8 + 7 >= lowest; --block, mask = 255) {
        int bits = tr_bits(block, y) & mask;
        if (bits != 0) {
            left = block * 8 + tr_highest(bits);
            break;
        }
    }
    for (int block = from_right >> 3, mask = 255 << (from_right & 7); block * 8 <= highest; ++block, mask = 255) {
        int bits = tr_bits(block, y) & mask;
        if (bits != 0) {
            right = block * 8 + tr_highest(bits & -bits);
            break;
        }
    }
    int to_left = from_left - left, to_right = right - from_right;
    bool at_left = to_left < to_right;
    if (to_left == to_right && to_left <= reach)
        at_left = TR_BEHIND(texelFetch(tr_see_depth, ivec2(right, y), 0).r, texelFetch(tr_see_depth, ivec2(left, y), 0).r);
    int found = min(to_left, to_right) <= reach ? (at_left ? left : right) - first + 128 : 0;
    return float(found) * (1.0 / 255.0);
}

void main()
{
    vec4 rows = vec4(0.0); // ES has outputs indexed by constants only
    for (int i = 0, y = 4 * int(gl_FragCoord.y); i < 4 && y + i < int(tr_viewport.w); ++i)
        rows[i] = tr_nearest_in(y + i);
    tr_color = rows;
}
#else
void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy), first = texel * tr_see_grid.x, nearest = ivec2(-1);
    int divisor = tr_see_grid.x, steps = tr_see_grid.w + 2 * divisor, least = 4 * steps * steps;
    int middle = first.y >> 2, last = (int(tr_viewport.w) - 1) >> 2;
    // Four rows at a time, outward: those i texels away are 4 * i - 3 and more pixels away, less the texel's own.
    for (int i = 0; i == 0 || 4 * i - 3 - divisor <= 0 || (4 * i - 3 - divisor) * (4 * i - 3 - divisor) * 4 <= least; ++i) {
        for (int side = 0; side < (i == 0 ? 1 : 2); ++side) {
            int four = side == 0 ? middle - i : middle + i;
            if (four < 0 || four > last)
                continue;
            ivec4 found = ivec4(texelFetch(tr_see_rows, ivec2(texel.x, four), 0) * 255.0 + 0.5);
            if (found == ivec4(0))
                continue;
            for (int k = 0; k < 4; ++k) {
                if (found[k] == 0)
                    continue;
                ivec2 pixel = ivec2(first.x + found[k] - 128, 4 * four + k), offset = 2 * (pixel - first) - divisor + 1;
                int square = offset.x * offset.x + offset.y * offset.y;
                if (square < least ||
                    (square == least && nearest.x >= 0 &&
                     TR_BEHIND(texelFetch(tr_see_depth, nearest, 0).r, texelFetch(tr_see_depth, pixel, 0).r))) {
                    least = square;
                    nearest = pixel;
                }
            }
        }
    }
    tr_color = vec4(1.0, 0.0, 0.0, 0.0);
    gl_FragDepth = TR_CLEAR_DEPTH;
    if (nearest.x < 0)
        return;
#if TR_IN_PARTS
    tr_color = vec4(0.5 * sqrt(float(least)) / float(steps), 1.0, 0.0, 0.0);
#else
    tr_color = vec4(0.5 * sqrt(float(least)) / float(steps), texelFetch(tr_see_mark, nearest, 0).ab, 0.0);
#endif
    gl_FragDepth = texelFetch(tr_see_depth, nearest, 0).r;
}
#endif

// For: transparency.h
// How far the nearest pixel of a target is: exact, by rows and then across them.
//
// TR_SPREAD 0: in its row, for each texel of masks, as the pixels from the texel's first one to it, plus 128, in 255ths; 0:
// none. TR_SPREAD 1: of the rows' the nearest, of equally near ones that nearest to the eye. A texel stands for the middle
// of its pixels; twice the positions are integers. Steps go outward from there: left and right, up and down, are one step.
uniform highp sampler2D tr_see_depth; // of targets
uniform highp sampler2D tr_see_mark;  // of targets: strength, 0 where there is none; active
#if TR_SPREAD == 1
uniform highp sampler2D tr_see_rows;
#endif
layout(location = 0) out highp vec4 tr_color;

#if TR_SPREAD == 0
bool tr_is_target(ivec2 pixel)
{
    return pixel.x >= 0 && pixel.x < int(tr_viewport.z) && texelFetch(tr_see_mark, pixel, 0).r > 0.0;
}

void main()
{
    int divisor = tr_see_grid.x, steps = tr_see_grid.w + 2 * divisor, first = int(gl_FragCoord.x) * divisor, found = 0;
    ivec2 left = ivec2(first + (divisor - 1) / 2, int(gl_FragCoord.y)), right = ivec2(first + divisor / 2, left.y);
    for (int i = 0; i <= steps; ++i) {
        bool at_left = tr_is_target(left), at_right = tr_is_target(right);
        if (at_left && at_right)
            at_left = TR_BEHIND(texelFetch(tr_see_depth, right, 0).r, texelFetch(tr_see_depth, left, 0).r);
        if (at_left || at_right) {
            found = (at_left ? left.x : right.x) - first + 128;
            break;
        }
        --left.x;
        ++right.x;
    }
    tr_color = vec4(float(found) * (1.0 / 255.0));
}
#else
void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy), first = texel * tr_see_grid.x, nearest = ivec2(-1);
    int divisor = tr_see_grid.x, steps = tr_see_grid.w + 2 * divisor, none = 4 * steps * steps, least = none;
    for (int i = 0; i <= steps && 4 * i * i <= least; ++i) {
        for (int side = 0; side < 2; ++side) {
            int y = side == 0 ? first.y + (divisor - 1) / 2 - i : first.y + divisor / 2 + i;
            if (y < 0 || y >= int(tr_viewport.w))
                continue;
            int found = int(texelFetch(tr_see_rows, ivec2(texel.x, y), 0).r * 255.0 + 0.5) - 128;
            if (found == -128)
                continue;
            ivec2 pixel = ivec2(first.x + found, y), offset = 2 * (pixel - first) - divisor + 1;
            int square = offset.x * offset.x + offset.y * offset.y;
            if (square < least ||
                (square == least && nearest.x >= 0 &&
                 TR_BEHIND(texelFetch(tr_see_depth, nearest, 0).r, texelFetch(tr_see_depth, pixel, 0).r))) {
                least = square;
                nearest = pixel;
            }
        }
    }
    tr_color = vec4(1.0, 0.0, 0.0, 0.0);
    gl_FragDepth = TR_CLEAR_DEPTH;
    if (nearest.x < 0)
        return;
    tr_color = vec4(0.5 * sqrt(float(least)) / float(steps), texelFetch(tr_see_mark, nearest, 0).rg, 0.0);
    gl_FragDepth = texelFetch(tr_see_depth, nearest, 0).r;
}
#endif

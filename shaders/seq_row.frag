// For: transparency.h
// The nearest pixel of a target to the left or right, first half of an exact distance: along the row, for the middle of
// each cell. Of two equally near the one nearer to the eye. Stored: its column, from the cell's first, + 32768; 0: none.
uniform highp sampler2D tr_seed; // depth where a target is
flat in highp int tr_v_mask;
layout(location = 0) out highp uvec4 tr_nearest;

void main()
{
    highp ivec2 at = ivec2(gl_FragCoord.xy);
    highp ivec4 box = ivec4(tr_masks[tr_v_mask].box);
    int cell = tr_seq_numbers.x, first = at.x * cell, low = first + (cell - 1) / 2, high = first + cell / 2;
    tr_nearest = uvec4(0u);
    for (int i = 0; i <= tr_seq_numbers.y + cell; ++i) {
        int left = low - i, right = high + i;
        highp float to_left = left >= box.x && left < box.z ? texelFetch(tr_seed, ivec2(left, at.y), 0).r : TR_CLEAR_DEPTH;
        highp float to_right =
            right >= box.x && right < box.z ? texelFetch(tr_seed, ivec2(right, at.y), 0).r : TR_CLEAR_DEPTH;
        if (to_left == TR_CLEAR_DEPTH && to_right == TR_CLEAR_DEPTH)
            continue;
        tr_nearest.r = uint((TR_NEARER(to_right, to_left) ? right : left) - first + 32768);
        break;
    }
}

// For: transparency.h
// The nearest pixel of a target, second half: over the rows above and below, for the middle of each cell. Distances are
// those between centres of pixels, or counted in rings of eight neighbours (TR_RINGS). Of several equally near that
// nearest to the eye. Stored: its column and row, from the cell's first, + 32768; 0: none.
uniform highp usampler2D tr_rows; // of seq_row.frag
uniform highp sampler2D tr_seed;
flat in highp int tr_v_mask;
layout(location = 0) out highp uvec4 tr_nearest;

int tr_size(ivec2 way)
{
#if TR_RINGS
    return max(abs(way.x), abs(way.y));
#else
    return way.x * way.x + way.y * way.y;
#endif
}

void main()
{
    highp ivec2 at = ivec2(gl_FragCoord.xy);
    highp ivec4 box = ivec4(tr_masks[tr_v_mask].box);
    int cell = tr_seq_numbers.x, least = 0x7fffffff;
    ivec2 first = at * cell, best = ivec2(0);
    for (int i = 0; i <= 2 * (tr_seq_numbers.y + cell) + 1; ++i) {
        int row = first.y + (i % 2 == 0 ? (cell - 1) / 2 - i / 2 : cell / 2 + i / 2);
        // In halves of pixels, since the middle of a cell may lie between two.
        int dy = 2 * (row - first.y) - (cell - 1);
        if (tr_size(ivec2(0, dy)) > least)
            break;
        if (row < box.y || row >= box.w || (cell % 2 == 1 && i == 1))
            continue;
        int column = int(texelFetch(tr_rows, ivec2(at.x, row), 0).r) - 32768;
        if (column == -32768)
            continue;
        int size = tr_size(ivec2(2 * column - (cell - 1), dy));
        if (size > least)
            continue;
        ivec2 seed = ivec2(first.x + column, row);
        if (size == least && !TR_NEARER(texelFetch(tr_seed, seed, 0).r, texelFetch(tr_seed, best, 0).r))
            continue;
        least = size;
        best = seed;
    }
    tr_nearest = least == 0x7fffffff ? uvec4(0u) : uvec4(uvec2(best - first + 32768), 0u, 0u);
}

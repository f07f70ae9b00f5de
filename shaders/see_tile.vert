// For: transparency.h
// Six vertices a tile: passes of dynamic transparency cover the cells that have masks, and no more.
//
// TR_COARSE_X, TR_COARSE_Y: 1 where the texture has a texel for tr_see_grid.x pixels; 2: for eight across, four
// up.
void main()
{
    int tile = gl_VertexID / 6, corner = gl_VertexID - 6 * tile, divisor = tr_see_grid.x;
    highp uvec4 four = tr_see_tiles[tile >> 2];
    int which = tile & 3;
    highp uint box = which == 0 ? four.x : which == 1 ? four.y : which == 2 ? four.z : four.w;
    bool right = corner == 1 || corner == 2 || corner == 4, high = corner == 2 || corner == 4 || corner == 5;
    highp uint x = (box >> (right ? 16 : 0)) & 255u, y = (box >> (high ? 24 : 8)) & 255u;
    ivec2 size = ivec2(tr_viewport.zw);
#if TR_COARSE_X == 2
    size.x = (size.x + 7) / 8 * 8;
#elif TR_COARSE_X == 1
    size.x = (size.x + divisor - 1) / divisor * divisor;
#endif
#if TR_COARSE_Y == 2
    size.y = (size.y + 3) / 4 * 4;
#elif TR_COARSE_Y == 1
    size.y = (size.y + divisor - 1) / divisor * divisor;
#endif
    gl_Position = vec4(vec2(ivec2(x, y) * tr_see_grid.y) / vec2(size) * 2.0 - 1.0, 0.0, 1.0);
}

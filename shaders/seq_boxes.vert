// For: transparency.h
// The boxes of the masks of a run, two triangles each and no vertex buffer. TR_BOXES says whose texels they are counted
// in: 0: pixels, 1: columns of cells by rows of pixels, 2: cells of tr_seq_numbers.x pixels a side. Cells reach one
// further on each side, for those who read the nearest four.
flat out highp int tr_v_mask;

void main()
{
    int corner = gl_VertexID % 6;
    tr_v_mask = gl_VertexID / 6;
    highp vec4 box = tr_masks[tr_v_mask].box;
    highp vec2 size = vec2(tr_seq_view.zw), cell = vec2(1.0);
#if TR_BOXES >= 1
    cell.x = float(tr_seq_numbers.x);
#endif
#if TR_BOXES == 2
    cell.y = cell.x;
#endif
#if TR_BOXES >= 1
    size = ceil(size / cell);
    box = vec4(floor(box.xy / cell) - step(1.5, cell), ceil(box.zw / cell) + step(1.5, cell));
    box = clamp(box, vec4(0.0), size.xyxy);
#endif
    bvec2 far = bvec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);
    highp vec2 at = vec2(far.x ? box.z : box.x, far.y ? box.w : box.y);
    gl_Position = vec4(at / size * 2.0 - 1.0, 0.0, 1.0);
}

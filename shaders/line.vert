// For: transparency.h
// Feature lines as triangles in screen space: vertex stage. The layout is that of a sil_ribbon_vertex.
layout(location = 0) in highp vec4 tr_line_corner; // x, y in pixels, window depth, slack: depth per pixel toward the eye
layout(location = 1) in highp vec2 tr_line_center; // the point of the centre line, pixels
out highp vec4 tr_v_line;                          // centre x, y, depth, slack

void main()
{
    // Lines are found without the host's jitter, and shifted by as much as its surfaces are.
    tr_v_line = vec4(tr_line_center + tr_shift.xy, tr_line_corner.zw);
    // Depth is written by the fragment stage, so the clip convention in force does not matter here.
    gl_Position = vec4(2.0 * (tr_line_corner.xy + tr_shift.xy) / tr_viewport.zw - 1.0, 0.0, 1.0);
}

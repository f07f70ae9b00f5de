// For: transparency.h
// View-dependent alpha, vertex stage: what the rung TR_ALPHA of the ladder needs from the vertices.
//
// A vertex shader calls tr_alpha_vertex(position, distance, triangle) once: the vertex in object space; its distance to
// the nearest silhouette, which the first two rungs read; and the number of its triangle, for the third, which reads that
// of the triangle's last vertex. An attribute, for gl_PrimitiveID is not in ES 3.0, and Mesa's softpipe draws nothing
// with it and counts gl_VertexID anew every few thousand vertices. A host that trusts its drivers defines TR_TRIANGLE as
// uint(gl_PrimitiveID) before these strings in both stages, passes 0, and draws by indices.
#define TR_ALPHA_DISTANCE 0   // distance at vertices, alpha a pixel
#define TR_ALPHA_PUBLISHED 1  // alpha at vertices: Diepstraten 2002
#define TR_ALPHA_CANDIDATES 2 // distance a pixel, to the edges that the triangle carries
#define TR_ALPHA_EXACT 3      // distance a pixel, to all edges of the object
#define TR_ALPHA_IMAGE 4      // distance a pixel, to outlines found in an image

uniform highp vec2 tr_falloff; // d_max, k of equation 2; d_max = 0 for a constant alpha
#if TR_ALPHA == TR_ALPHA_DISTANCE || TR_ALPHA == TR_ALPHA_PUBLISHED
out highp float tr_v_falloff; // the distance, or alpha
#elif TR_ALPHA != TR_ALPHA_IMAGE
uniform highp vec4 tr_edge_frame[4]; // tr_edge_set.frame: columns, then the middle
out highp vec3 tr_v_place;           // in the frame of the edges
#if TR_ALPHA == TR_ALPHA_CANDIDATES && !defined(TR_TRIANGLE)
flat out highp uint tr_v_triangle;
#endif
#endif

void tr_alpha_vertex(highp vec3 position, highp float distance, highp uint triangle)
{
#if TR_ALPHA == TR_ALPHA_DISTANCE
    // No two points are further apart than 2 d_max; what is infinite could not be interpolated.
    tr_v_falloff = min(distance, min(2.0 * tr_falloff.x, 1.0e30));
#elif TR_ALPHA == TR_ALPHA_PUBLISHED
    tr_v_falloff = tr_view_alpha(distance, tr_falloff.x, tr_falloff.y);
#elif TR_ALPHA != TR_ALPHA_IMAGE
    highp vec3 from = position - tr_edge_frame[3].xyz;
    tr_v_place = from.x * tr_edge_frame[0].xyz + from.y * tr_edge_frame[1].xyz + from.z * tr_edge_frame[2].xyz;
#if TR_ALPHA == TR_ALPHA_CANDIDATES && !defined(TR_TRIANGLE)
    tr_v_triangle = triangle;
#endif
#endif
}

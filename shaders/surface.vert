// For: transparency.h
// Built-in surface program for hosts without shaders of their own: vertex stage.
layout(location = 0) in highp vec3 tr_position;
layout(location = 1) in highp vec3 tr_normal;
layout(location = 2) in highp float tr_distance; // to the nearest silhouette, for the rungs of alpha that want it
layout(location = 3) in highp vec3 tr_tint;      // added to the object's colour; by default 0
#if TR_WANTS_ALPHA && TR_ALPHA == TR_ALPHA_CANDIDATES
layout(location = 4) in highp uint tr_triangle; // its number, at the last vertex of each
#else
#define tr_triangle 0u
#endif

uniform highp mat4 tr_model_view_projection;
#if TR_STRENGTHENS
uniform highp mat4 tr_model;
out highp vec3 tr_v_position;
#endif
#if TR_WANTS_COLOR
uniform highp mat3 tr_normal_matrix;
uniform highp vec4 tr_object_color; // a: alpha on the silhouette
out highp vec3 tr_v_normal;
out highp vec4 tr_v_color;
#endif

void main()
{
#if TR_WANTS_COLOR
    tr_v_normal = tr_normal_matrix * tr_normal;
    tr_v_color = vec4(tr_object_color.rgb + tr_tint, tr_object_color.a);
#endif
#if TR_WANTS_ALPHA
    tr_alpha_vertex(tr_position, tr_distance, tr_triangle);
#endif
#if TR_STRENGTHENS
    tr_v_position = (tr_model * vec4(tr_position, 1.0)).xyz;
#endif
    gl_Position = tr_model_view_projection * vec4(tr_position, 1.0);
}

// For: transparency.h
// Built-in surface program for hosts without shaders of their own: vertex stage.
layout(location = 0) in highp vec3 tr_position;
layout(location = 1) in highp vec3 tr_normal;
layout(location = 2) in highp float tr_distance; // to the nearest silhouette, see alpha_law.glsl
layout(location = 3) in highp vec3 tr_tint;      // added to the object's colour; by default 0

uniform highp mat4 tr_model_view_projection;
#if TR_STRENGTHENS
uniform highp mat4 tr_model;
out highp vec3 tr_v_position;
#endif
#if TR_WANTS_COLOR
uniform highp mat3 tr_normal_matrix;
uniform highp vec4 tr_object_color; // a: alpha on the silhouette
uniform highp vec2 tr_falloff;      // d_max, k of equation 2; d_max = 0 for a constant alpha
out highp vec3 tr_v_normal;
out highp vec4 tr_v_color;
#endif

void main()
{
#if TR_WANTS_COLOR
    tr_v_normal = tr_normal_matrix * tr_normal;
    tr_v_color = vec4(tr_object_color.rgb + tr_tint,
                      tr_object_color.a * tr_view_alpha(tr_distance, tr_falloff.x, tr_falloff.y));
#endif
#if TR_STRENGTHENS
    tr_v_position = (tr_model * vec4(tr_position, 1.0)).xyz;
#endif
    gl_Position = tr_model_view_projection * vec4(tr_position, 1.0);
}

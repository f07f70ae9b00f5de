// For: oit_buffers.h
// Built-in surfaces, for hosts without shaders: position, normal, colour to be added. The count pass needs no more than
// the position.
layout(location = 0) in vec3 oit_position;
uniform mat4 oit_model_view_projection;
#if OIT_PASS == OIT_FILL
layout(location = 3) in vec3 oit_vertex_color;
out vec3 oit_v_color;
#endif
#if OIT_WANTS_NORMAL
layout(location = 1) in vec3 oit_normal;
uniform mat3 oit_normal_matrix;
out vec3 oit_v_normal;
#endif

void main()
{
    gl_Position = oit_model_view_projection * vec4(oit_position, 1.0);
#if OIT_PASS == OIT_FILL
    oit_v_color = oit_vertex_color;
#endif
#if OIT_WANTS_NORMAL
    oit_v_normal = oit_normal_matrix * oit_normal;
#endif
}

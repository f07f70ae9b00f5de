// For: oit_buffers.h
// Built-in surfaces, for hosts without shaders: position, normal, colour to be added.
layout(location = 0) in vec3 oit_position;
layout(location = 1) in vec3 oit_normal;
layout(location = 3) in vec4 oit_vertex_color;
uniform mat4 oit_model_view_projection;
uniform mat3 oit_normal_matrix;
out vec3 oit_v_normal;
out vec4 oit_v_color;

void main()
{
    gl_Position = oit_model_view_projection * vec4(oit_position, 1.0);
    oit_v_normal = oit_normal_matrix * oit_normal;
    oit_v_color = oit_vertex_color;
}

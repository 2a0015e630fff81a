// The vertex shader of vulkan.frag: an engine's own. Positions are relative to the camera.
#version 450

layout(set = 0, binding = 0) uniform Camera { mat4 clip_from_relative; } camera;
layout(set = 2, binding = 0) uniform Object {
    mat4 relative_from_object;
    mat4 normal_from_object;  // inverse transpose of the first; [3][3]: the sign of its determinant
} object;

layout(location = 0) in vec3 vertex_position;
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec4 vertex_tangent;
layout(location = 4) in vec2 vertex_uv0;
layout(location = 5) in vec2 vertex_uv1;

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec4 tangent;
layout(location = 3) out vec2 uv0;
layout(location = 4) out vec2 uv1;

void main() {
    position = (object.relative_from_object * vec4(vertex_position, 1.0)).xyz;
    normal = normalize(mat3(object.normal_from_object) * vertex_normal);
    tangent.xyz = normalize(mat3(object.relative_from_object) * vertex_tangent.xyz);
    tangent.w = vertex_tangent.w * object.normal_from_object[3][3];  // a mirrored object turns its bitangents
    uv0 = vertex_uv0;
    uv1 = vertex_uv1;
    gl_Position = camera.clip_from_relative * vec4(position, 1.0);
}

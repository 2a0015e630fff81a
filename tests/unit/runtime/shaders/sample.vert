#version 450
#extension GL_GOOGLE_include_directive : require
#include "sample_blocks.glsl"
layout(set = 2, binding = 0, std140) uniform SgObjectBlock {
    mat4 relative_from_object;
    mat4 normal_from_object;
} object;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 4) in vec2 uv0;
layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_tangent;
layout(location = 3) out vec2 out_uv0;

void main() {
    vec4 relative = object.relative_from_object * vec4(position, 1.0);
    out_position = relative.xyz;
    out_normal = mat3(object.normal_from_object) * normal;
    out_tangent = vec4(mat3(object.relative_from_object) * tangent.xyz, tangent.w * object.normal_from_object[3][3]);
    out_uv0 = uv0;
    gl_Position = frame.clip_from_relative * relative;
}

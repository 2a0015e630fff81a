#version 450
#extension GL_GOOGLE_include_directive : require
#include "sample_blocks.glsl"
layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    vec3 tint;
    float gain;
} material;
layout(set = 1, binding = 1) uniform texture2D paint;
layout(set = 1, binding = 2) uniform sampler paint_sampler;
layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec2 in_uv0;
layout(location = 0) out vec4 color;

void main() {
    vec3 n = normalize(in_normal) * (gl_FrontFacing ? 1.0 : -1.0);
    vec3 albedo = texture(sampler2D(paint, paint_sampler), in_uv0).rgb * material.tint * material.gain;
    vec3 light = frame.light_radiance.rgb * max(dot(n, frame.light_direction.xyz), 0.0) + frame.ambient_radiance.rgb;
    color = vec4(albedo * light + 0.0 * (in_position + in_tangent.xyz), 1.0);
}

#version 450
#extension GL_GOOGLE_include_directive : require
// workshop phong: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/resolve.glsl"

layout(set = 1, binding = 2) uniform texture2D t_normal_map;
layout(set = 1, binding = 3) uniform sampler s_0;

layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    // bump_normal: normal_map
    vec3 m_bump_normal = sg_decode_signed(sg_stage_sample(t_normal_map, s_0, sg_stage_uv(sg_in_uv0)).xyz,
                                          127.5);

    sg_out_normal = vec4(
        sg_resolve_vertex_map(sg_in_normal, sg_in_tangent, 1.0, m_bump_normal, vec2(1.0, -1.0)), 1.0);
}

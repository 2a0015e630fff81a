#version 450
#extension GL_GOOGLE_include_directive : require
// one map, all parameters: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    vec3 p_tint;
    vec2 p_tiling;
    float p_strength;
    float p_roughness;
    float p_metallic;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_weave;
layout(set = 1, binding = 3) uniform sampler s_0;

layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    // weave: normal_map
    vec3 m_weave = sg_decode_signed(
        sg_stage_sample(t_weave, s_0, sg_uv_scale(sg_stage_uv(sg_in_uv0), sg_material.p_tiling)).xyz, 127.5);

    sg_out_normal = vec4(
        sg_resolve_vertex_map(sg_in_normal, sg_in_tangent, sg_stage_facing(), m_weave,
                              vec2(sg_material.p_strength)),
        1.0);
}

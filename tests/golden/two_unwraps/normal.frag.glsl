#version 450
#extension GL_GOOGLE_include_directive : require
// two unwraps: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    float p_scratch_depth;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_weave;
layout(set = 1, binding = 2) uniform texture2D t_scratch;
layout(set = 1, binding = 3) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 5) in vec2 sg_in_uv1;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgUv m_uv1 = sg_stage_uv(sg_in_uv1);

    // weave: normal_map
    vec3 m_weave = sg_surfgrad_from_tbn(
        sg_deriv_from_normal_xyz(sg_decode_signed(
            sg_stage_sample(t_weave, s_0, sg_uv_scale(sg_stage_uv(sg_in_uv0), vec2(10.0, 4.0))).xyz, 128.0)),
        sg_basis_vertex(sg_in_normal, sg_in_tangent));

    // scratches: normal_map
    vec3 m_scratches = sg_surfgrad_from_tbn(
        sg_material.p_scratch_depth * sg_deriv_from_normal_xy(
            sg_decode_signed(sg_stage_sample(t_scratch, s_0, sg_uv_scale(m_uv1, vec2(2.0, 5.0))).xy, 127.5)),
        sg_basis_uv(sg_stage_frame(sg_in_position, m_base_normal), m_uv1));

    sg_out_normal = vec4(sg_resolve(m_base_normal, m_weave + m_scratches), 1.0);
}

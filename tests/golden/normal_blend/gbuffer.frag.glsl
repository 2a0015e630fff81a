#version 450
#extension GL_GOOGLE_include_directive : require
// blended maps: fragment shader of the entry point 'gbuffer', made by surfgradc.

#include "stage/fragment.glsl"
#include "surfgrad/combine.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 1) uniform texture2D t_brick;
layout(set = 1, binding = 2) uniform texture2D t_scratch;
layout(set = 1, binding = 3) uniform texture2D t_weave;
layout(set = 1, binding = 4) uniform texture2D t_moss;
layout(set = 1, binding = 5) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 5) in vec2 sg_in_uv1;
layout(location = 0) out vec4 sg_out_base_color;
layout(location = 1) out vec4 sg_out_normal;
layout(location = 2) out vec4 sg_out_surface;
layout(location = 3) out vec4 sg_out_emission;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    SgUv m_uv1 = sg_stage_uv(sg_in_uv1);

    // scratched: normal_blend
    vec3 m_scratched_m = sg_normal_from_deriv(sg_deriv_green_up(sg_deriv_from_normal_xyz(
        sg_decode_signed(sg_stage_sample(t_brick, s_0, sg_uv_scale(m_uv0, vec2(4.0, 2.0))).xyz, 127.5))));
    SgDerivPair m_scratched_derivs = sg_combine_whiteout(
        m_scratched_m,
        sg_normal_from_deriv(sg_deriv_from_normal_xy(sg_decode_signed(
            sg_stage_sample(t_scratch, s_0, sg_uv_scale(m_uv1, vec2(2.0, 5.0))).xy, 127.5))));
    vec3 m_scratched =
        sg_surfgrad_from_tbn(m_scratched_derivs.first, sg_basis_vertex(sg_in_normal, sg_in_tangent)) +
        sg_surfgrad_from_tbn(m_scratched_derivs.second, sg_basis_uv(m_frame, m_uv1));

    // covered: normal_blend
    vec3 m_covered = sg_surfgrad_from_tbn(
        sg_deriv_from_normal_xyz(sg_combine_rnm(
            m_scratched_m,
            sg_normal_from_deriv(sg_deriv_from_normal_xyz(sg_decode_signed(
                sg_stage_sample(t_weave, s_0, sg_uv_scale(m_uv0, vec2(12.0, 5.0))).xyz, 128.0))))),
        sg_basis_uv(m_frame, m_uv0));

    float m_patch = sg_stage_sample(t_moss, s_0, sg_uv_scale(m_uv0, vec2(6.0, 2.0))).x;

    sg_out_base_color = vec4(mix(vec3(0.45, 0.2, 0.12), vec3(0.5, 0.42, 0.3), m_patch), 1.0);
    sg_out_normal = vec4(sg_resolve(m_base_normal, sg_combine_mix(m_scratched, m_covered, m_patch)), 0.6);
    sg_out_surface = vec4(0.0, 1.0, 0.0, 1.0);
    sg_out_emission = vec4(vec3(0.0), 1.0);
}

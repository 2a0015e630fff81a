#version 450
#extension GL_GOOGLE_include_directive : require
// blend methods: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "surfgrad/combine.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/number.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    float p_second;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_weave;
layout(set = 1, binding = 2) uniform texture2D t_scratch;
layout(set = 1, binding = 3) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 5) in vec2 sg_in_uv1;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_value;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    SgUv m_uv1 = sg_stage_uv(sg_in_uv1);
    SgVolume m_object = sg_stage_volume(sg_in_object_position);

    // pd: normal_blend
    vec2 m_pd_deriv = sg_deriv_from_normal_xyz(
        sg_decode_signed(sg_stage_sample(t_weave, s_0, sg_uv_scale(m_uv0, vec2(10.0, 4.0))).xyz, 128.0));
    vec2 m_pd_deriv_2 = sg_deriv_from_normal_xy(
        sg_decode_signed(sg_stage_sample(t_scratch, s_0, sg_uv_scale(m_uv1, vec2(2.0, 5.0))).xy, 127.5));
    SgBasis m_pd_basis = sg_basis_uv(m_frame, m_uv0);
    vec3 m_pd_gradient = sg_surfgrad_from_tbn(m_pd_deriv, m_pd_basis);
    SgBasis m_pd_basis_2 = sg_basis_uv(m_frame, m_uv1);
    vec3 m_pd_gradient_2 = sg_surfgrad_from_tbn(m_pd_deriv_2, m_pd_basis_2);
    vec3 m_pd = m_pd_gradient + m_pd_gradient_2;

    // whiteout: normal_blend
    vec3 m_whiteout_m = sg_normal_from_deriv(m_pd_deriv);
    vec3 m_whiteout_second_m = sg_normal_from_deriv(m_pd_deriv_2);
    SgDerivPair m_whiteout_derivs = sg_combine_whiteout(m_whiteout_m, m_whiteout_second_m);
    vec3 m_whiteout = sg_surfgrad_from_tbn(m_whiteout_derivs.first, m_pd_basis) +
        sg_surfgrad_from_tbn(m_whiteout_derivs.second, m_pd_basis_2);

    // udn: normal_blend
    SgDerivPair m_udn_derivs = sg_combine_udn(m_whiteout_m, m_whiteout_second_m);
    vec3 m_udn = sg_surfgrad_from_tbn(m_udn_derivs.first, m_pd_basis) +
        sg_surfgrad_from_tbn(m_udn_derivs.second, m_pd_basis_2);

    // weighted: normal_blend
    vec3 m_weighted = sg_surfgrad_from_tbn(0.5 * m_pd_deriv, m_pd_basis) +
        sg_surfgrad_from_tbn(sg_material.p_second * m_pd_deriv_2, m_pd_basis_2);

    // rnm: normal_blend
    vec3 m_rnm = sg_combine_reoriented(m_base_normal, m_pd_gradient, m_pd_gradient_2);

    float m_smoothstep = sg_smoothstep(-0.27, -0.25, m_object.p.y);
    float m_smoothstep_2 = sg_smoothstep(-0.11, -0.09, m_object.p.y);
    float m_smoothstep_3 = sg_smoothstep(0.07, 0.09, m_object.p.y);
    float m_smoothstep_4 = sg_smoothstep(0.25, 0.27, m_object.p.y);
    vec3 m_gradient = sg_combine_mix(
        sg_combine_mix(sg_combine_mix(sg_combine_mix(m_pd, m_whiteout, m_smoothstep), m_udn, m_smoothstep_2),
                       m_weighted, m_smoothstep_3),
        m_rnm, m_smoothstep_4);

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_gradient);  // gradient
    sg_shown = sg_stage_select(sg_shown, 5.0, sg_resolve(m_base_normal, m_gradient));  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_pd);  // layer:pd
    sg_shown = sg_stage_select(sg_shown, 7.0, m_smoothstep * m_whiteout);  // layer:whiteout
    sg_shown = sg_stage_select(sg_shown, 8.0, m_smoothstep_2 * m_udn);  // layer:udn
    sg_shown = sg_stage_select(sg_shown, 9.0, m_smoothstep_3 * m_weighted);  // layer:weighted
    sg_shown = sg_stage_select(sg_shown, 10.0, m_smoothstep_4 * m_rnm);  // layer:rnm
    sg_shown = sg_stage_select(sg_shown, 11.0, vec3(m_uv0.st, 0.0));  // uv0
    sg_shown = sg_stage_select(sg_shown, 12.0, vec4(m_uv0.dx, m_uv0.dy));  // uv0-derivatives
    sg_shown = sg_stage_select(sg_shown, 13.0, vec3(m_uv1.st, 0.0));  // uv1
    sg_shown = sg_stage_select(sg_shown, 14.0, vec4(m_uv1.dx, m_uv1.dy));  // uv1-derivatives
    sg_shown = sg_stage_select(sg_shown, 15.0, m_object.p);  // object-position
    sg_shown = sg_stage_select(sg_shown, 16.0, m_object.dx);  // object-position-dx
    sg_shown = sg_stage_select(sg_shown, 17.0, m_object.dy);  // object-position-dy
    sg_out_value = sg_shown;
}

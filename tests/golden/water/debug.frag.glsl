#version 450
#extension GL_GOOGLE_include_directive : require
// water: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    float p_wind;
    vec3 p_depth;
    float d_multiply;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_ripples;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_value;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    float m_time = sg_stage_time();

    // swell: normal_map
    SgUv m_swell_uv = sg_uv_transform(m_uv0, vec2(3.0, 2.0), 0.20943952, m_time * vec2(0.03, 0.01));
    vec3 m_swell = sg_surfgrad_from_tbn(
        sg_material.p_wind * sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_ripples, s_0, m_swell_uv).xyz, 127.5))),
        sg_basis_uv(m_frame, m_swell_uv));

    // chop: normal_map
    SgUv m_chop_uv = sg_uv_transform(m_uv0, vec2(8.0, 5.0), -1.134464, m_time * vec2(-0.05, 0.07));
    vec3 m_chop = sg_surfgrad_from_tbn(
        sg_material.d_multiply * sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_ripples, s_0, m_chop_uv).xyz, 127.5))),
        sg_basis_uv(m_frame, m_chop_uv));

    vec3 m_gradient = m_swell + m_chop;

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_gradient);  // gradient
    sg_shown = sg_stage_select(sg_shown, 5.0, sg_resolve(m_base_normal, m_gradient));  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_swell);  // layer:swell
    sg_shown = sg_stage_select(sg_shown, 7.0, m_chop);  // layer:chop
    sg_shown = sg_stage_select(sg_shown, 8.0, vec3(m_uv0.st, 0.0));  // uv0
    sg_shown = sg_stage_select(sg_shown, 9.0, vec4(m_uv0.dx, m_uv0.dy));  // uv0-derivatives
    sg_out_value = sg_shown;
}

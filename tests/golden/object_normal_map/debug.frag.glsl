#version 450
#extension GL_GOOGLE_include_directive : require
// baked sphere: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_normal.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 1) uniform texture2D t_baked;
layout(set = 1, binding = 2) uniform texture2D t_weave;
layout(set = 1, binding = 3) uniform sampler s_0;
layout(set = 1, binding = 4) uniform sampler s_1;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_value;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);

    // baked: object_normal_map
    vec3 m_baked = sg_surfgrad_from_normal(
        m_base_normal,
        sg_stage_normal_from_object(sg_decode_signed(sg_stage_sample(t_baked, s_0, m_uv0).xyz, 127.5)));

    // weave: normal_map
    vec3 m_weave = sg_surfgrad_from_tbn(
        0.2 * sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_weave, s_1, sg_uv_scale(m_uv0, vec2(16.0, 8.0))).xyz, 128.0)),
        sg_basis_uv(m_frame, m_uv0));

    vec3 m_gradient = m_baked + m_weave;

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_gradient);  // gradient
    sg_shown = sg_stage_select(sg_shown, 5.0, sg_resolve(m_base_normal, m_gradient));  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_baked);  // layer:baked
    sg_shown = sg_stage_select(sg_shown, 7.0, m_weave);  // layer:weave
    sg_shown = sg_stage_select(sg_shown, 8.0, vec3(m_uv0.st, 0.0));  // uv0
    sg_shown = sg_stage_select(sg_shown, 9.0, vec4(m_uv0.dx, m_uv0.dy));  // uv0-derivatives
    sg_out_value = sg_shown;
}

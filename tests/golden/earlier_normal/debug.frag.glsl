#version 450
#extension GL_GOOGLE_include_directive : require
// puddles: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_normal.glsl"
#include "surfgrad/number.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 1) uniform texture2D t_pebble;
layout(set = 1, binding = 2) uniform texture2D t_scratch;
layout(set = 1, binding = 3) uniform texture2D t_moss;
layout(set = 1, binding = 4) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 5) in vec2 sg_in_uv1;
layout(location = 0) out vec4 sg_out_value;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    SgUv m_uv1 = sg_stage_uv(sg_in_uv1);

    // layer 1: normal_map
    vec3 m_layer_1 = sg_surfgrad_from_tbn(
        sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_pebble, s_0, sg_uv_scale(m_uv0, vec2(5.0, 2.0))).xyz, 127.0))),
        sg_basis_uv(m_frame, m_uv0));

    vec3 m_pebbles_normal = sg_resolve(m_base_normal, m_layer_1);

    // layer 2: normal_map
    vec3 m_layer_2 = sg_surfgrad_from_tbn(
        sg_deriv_from_normal_xy(
            sg_decode_signed(sg_stage_sample(t_scratch, s_0, sg_uv_scale(m_uv1, vec2(2.0, 5.0))).xy, 127.5)),
        sg_basis_uv(sg_frame_resolved(m_frame, m_pebbles_normal), m_uv1));

    vec3 m_scratches_normal = sg_resolve(m_pebbles_normal, m_layer_2);
    float m_water = sg_stage_sample(t_moss, s_0, sg_uv_scale(m_uv0, vec2(3.0, 1.0))).x;

    // layer 3: earlier_normal
    vec3 m_layer_3 = sg_resolve_towards(m_scratches_normal, m_pebbles_normal, m_water);

    float m_deep = sg_smoothstep(0.6, 0.9, m_water);

    // layer 4: earlier_normal
    vec3 m_layer_4 = sg_resolve_towards(m_layer_3, m_base_normal, m_deep);

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_layer_1);  // gradient
    sg_shown = sg_stage_select(sg_shown, 5.0, m_layer_4);  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_layer_1);  // layer:layer 1
    sg_shown = sg_stage_select(sg_shown, 7.0, m_layer_2);  // layer:layer 2
    // layer:layer 3
    sg_shown = sg_stage_select(sg_shown, 8.0,
                               m_water * sg_surfgrad_from_normal(m_scratches_normal, m_pebbles_normal));
    // layer:layer 4
    sg_shown = sg_stage_select(sg_shown, 9.0, m_deep * sg_surfgrad_from_normal(m_layer_3, m_base_normal));
    sg_shown = sg_stage_select(sg_shown, 10.0, vec3(m_uv0.st, 0.0));  // uv0
    sg_shown = sg_stage_select(sg_shown, 11.0, vec4(m_uv0.dx, m_uv0.dy));  // uv0-derivatives
    sg_shown = sg_stage_select(sg_shown, 12.0, vec3(m_uv1.st, 0.0));  // uv1
    sg_shown = sg_stage_select(sg_shown, 13.0, vec4(m_uv1.dx, m_uv1.dy));  // uv1-derivatives
    sg_out_value = sg_shown;
}

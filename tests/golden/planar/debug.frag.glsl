#version 450
#extension GL_GOOGLE_include_directive : require
// rain on stone: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/world.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/number.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/triplanar.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 1) uniform texture2D t_pebble;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 0) out vec4 sg_out_value;

void main() {
    SgVolume m_world = sg_stage_volume_in_world(sg_in_position);
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    float m_top = sg_smoothstep(0.2, 0.8, dot(m_base_normal, vec3(0.0, 1.0, 0.0)));

    // rain: planar
    vec2 m_rain_deriv = sg_deriv_green_up(sg_deriv_from_normal_xyz(sg_decode_signed(
        sg_stage_sample(
            t_pebble, s_0,
            sg_volume_triplanar_uv(sg_volume_scale(m_world, 1.5), SG_RIGHT_HAND, SG_UPPER_LEFT).y).xyz,
        127.0)));
    vec3 m_rain_gradient = m_top * sg_triplanar_gradient(sg_axis_y(), m_rain_deriv, m_rain_deriv,
                                                         m_rain_deriv, SG_RIGHT_HAND, SG_UPPER_LEFT);
    vec3 m_rain = sg_surfgrad_from_volume(m_base_normal, m_rain_gradient);

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_rain);  // gradient
    sg_shown = sg_stage_select(sg_shown, 5.0, sg_resolve_volume(m_base_normal, m_rain_gradient));  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_rain);  // layer:rain
    sg_shown = sg_stage_select(sg_shown, 7.0, m_world.p);  // world-position
    sg_shown = sg_stage_select(sg_shown, 8.0, m_world.dx);  // world-position-dx
    sg_shown = sg_stage_select(sg_shown, 9.0, m_world.dy);  // world-position-dy
    sg_out_value = sg_shown;
}

#version 450
#extension GL_GOOGLE_include_directive : require
// the same bumps without parallax: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/height_map.glsl"
#include "surfgrad/noise.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 1) uniform texture2D t_pebble;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_value;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    SgVolume m_object = sg_stage_volume(sg_in_object_position);

    // stones: height_map
    vec3 m_stones = sg_surfgrad_from_height(m_frame, m_uv0, sg_texture_size(t_pebble, s_0),
                                            0.1 * sg_deriv_from_height_hq(t_pebble, s_0, m_uv0));

    vec3 m_normal = sg_resolve(m_base_normal, m_stones);

    // dents: noise
    vec3 m_dents_gradient = sg_stage_gradient_from_object(
        -0.24 * sg_noise_power(sg_volume_turbulence(sg_volume_scale(m_object, 3.0), 3), 2.0).gradient);
    vec3 m_dents = sg_surfgrad_from_volume(m_normal, m_dents_gradient);

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_stones);  // gradient
    sg_shown = sg_stage_select(sg_shown, 5.0, sg_resolve_volume(m_normal, m_dents_gradient));  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_stones);  // layer:stones
    sg_shown = sg_stage_select(sg_shown, 7.0, m_dents);  // layer:dents
    sg_shown = sg_stage_select(sg_shown, 8.0, vec3(m_uv0.st, 0.0));  // uv0
    sg_shown = sg_stage_select(sg_shown, 9.0, vec4(m_uv0.dx, m_uv0.dy));  // uv0-derivatives
    sg_shown = sg_stage_select(sg_shown, 10.0, m_object.p);  // object-position
    sg_shown = sg_stage_select(sg_shown, 11.0, m_object.dx);  // object-position-dx
    sg_shown = sg_stage_select(sg_shown, 12.0, m_object.dy);  // object-position-dy
    sg_out_value = sg_shown;
}

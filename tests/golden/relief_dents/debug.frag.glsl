#version 450
#extension GL_GOOGLE_include_directive : require
// carved pebbles, eroded: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/moved.glsl"
#include "stage/object.glsl"
#include "stage/view.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/height_map.glsl"
#include "surfgrad/noise.glsl"
#include "surfgrad/parallax.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 1) uniform texture2D t_pebble;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_value;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    SgNormalDerivatives m_normal_derivatives = sg_stage_normal_derivatives(sg_in_normal);

    // parallax: occlusion
    vec3 m_parallax_view = sg_parallax_direction(m_frame, m_uv0, sg_stage_view(sg_in_position));
    SgParallax m_parallax_hit = sg_parallax_occlusion(
        t_pebble, s_0, vec2(0.1, -0.1), m_uv0.st, m_parallax_view,
        sg_uv_level(m_uv0, sg_texture_size(t_pebble, s_0)),
        int(mix(128.0, 48.0, clamp(m_parallax_view.z, 0.0, 1.0))));
    vec2 m_parallax_pixels = sg_parallax_pixels(m_uv0, m_parallax_hit.offset);
    vec3 m_parallax_position = sg_parallax_position(m_frame, m_parallax_pixels, m_parallax_hit.height);
    vec3 m_parallax_moved_normal = sg_parallax_normal(m_base_normal, m_normal_derivatives.dndx,
                                                      m_normal_derivatives.dndy, m_parallax_pixels);

    SgUv m_moved_uv0 = sg_parallax_uv(m_uv0, m_parallax_hit.offset);

    // stones: height_map
    vec3 m_stones = sg_surfgrad_from_height(sg_frame_resolved(m_frame, m_parallax_moved_normal), m_moved_uv0,
                                            sg_texture_size(t_pebble, s_0),
                                            0.1 * sg_deriv_from_height_hq(t_pebble, s_0, m_moved_uv0));

    vec3 m_normal = sg_resolve(m_parallax_moved_normal, m_stones);

    // dents: noise
    vec3 m_dents_gradient = sg_stage_gradient_from_object(-0.24 * sg_noise_power(
        sg_volume_turbulence(
            sg_volume_scale(
                sg_stage_object_volume(sg_stage_frame_rebuilt(m_parallax_position, m_normal, 1.0)), 3.0),
            3),
        2.0).gradient);
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
    sg_shown = sg_stage_select(sg_shown, 10.0, m_normal_derivatives.dndx);  // base-normal-dx
    sg_shown = sg_stage_select(sg_shown, 11.0, m_normal_derivatives.dndy);  // base-normal-dy
    sg_shown = sg_stage_select(sg_shown, 12.0, m_parallax_position);  // moved-position
    sg_shown = sg_stage_select(sg_shown, 13.0, vec3(m_moved_uv0.st, 0.0));  // moved-uv0
    sg_out_value = sg_shown;
}

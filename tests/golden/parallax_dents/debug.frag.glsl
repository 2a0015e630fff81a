#version 450
#extension GL_GOOGLE_include_directive : require
// carved pebbles, eroded: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/moved.glsl"
#include "stage/object.glsl"
#include "stage/view.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/height_map.glsl"
#include "surfgrad/noise.glsl"
#include "surfgrad/parallax.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/sample.glsl"
#include "surfgrad/triplanar.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 1) uniform texture2D t_height;
layout(set = 1, binding = 2) uniform texture2D t_weave;
layout(set = 1, binding = 4) uniform sampler s_0;

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
    SgUv m_parallax_uv = sg_uv_scale(m_uv0, vec2(5.0, 2.0));
    vec3 m_parallax_view = sg_parallax_direction(m_frame, m_parallax_uv, sg_stage_view(sg_in_position));
    SgParallax m_parallax_hit = sg_parallax_occlusion(
        t_height, s_0, vec2(0.08, -0.08), m_parallax_uv.st, m_parallax_view,
        sg_uv_level(m_parallax_uv, sg_texture_size(t_height, s_0)),
        int(mix(48.0, 12.0, clamp(m_parallax_view.z, 0.0, 1.0))));
    vec2 m_parallax_pixels = sg_parallax_pixels(m_parallax_uv, m_parallax_hit.offset);
    vec3 m_parallax_position = sg_parallax_position(m_frame, m_parallax_pixels, m_parallax_hit.height);
    vec3 m_parallax_moved_normal = sg_parallax_normal(m_base_normal, m_normal_derivatives.dndx,
                                                      m_normal_derivatives.dndy, m_parallax_pixels);

    SgUv m_seen_uv = sg_parallax_uv(m_parallax_uv, m_parallax_hit.offset);

    // stones: height_map
    vec3 m_stones = sg_surfgrad_from_height(sg_frame_resolved(m_frame, m_parallax_moved_normal), m_seen_uv,
                                            sg_texture_size(t_height, s_0),
                                            0.08 * sg_deriv_from_height_hq(t_height, s_0, m_seen_uv));

    vec3 m_relief_normal = sg_resolve(m_parallax_moved_normal, m_stones);
    SgFrame m_moved_frame = sg_stage_frame_rebuilt(m_parallax_position, m_relief_normal, 1.0);

    // dents: noise
    vec3 m_dents_gradient = sg_stage_gradient_from_object(-0.4 * sg_noise_power(
        sg_volume_turbulence(sg_volume_scale(sg_stage_object_volume(m_moved_frame), 4.0), 4), 2.5).gradient);
    vec3 m_dents = sg_surfgrad_from_volume(m_relief_normal, m_dents_gradient);

    // grain: triplanar
    SgTriplanarUv m_grain_planes = sg_volume_triplanar_uv(
        sg_volume_scale(sg_stage_world_volume(m_moved_frame), 4.0), SG_RIGHT_HAND, SG_UPPER_LEFT);
    vec3 m_grain_gradient = 0.25 * sg_triplanar_gradient(
        sg_triplanar_weights(m_relief_normal, 3.0),
        sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_weave, s_0, m_grain_planes.x).xyz, 128.0)),
        sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_weave, s_0, m_grain_planes.y).xyz, 128.0)),
        sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_weave, s_0, m_grain_planes.z).xyz, 128.0)),
        SG_RIGHT_HAND, SG_UPPER_LEFT);
    vec3 m_grain = sg_surfgrad_from_volume(m_relief_normal, m_grain_gradient);

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_stones);  // gradient
    // normal
    sg_shown = sg_stage_select(sg_shown, 5.0,
                               sg_resolve_volume(m_relief_normal, m_dents_gradient + m_grain_gradient));
    sg_shown = sg_stage_select(sg_shown, 6.0, m_stones);  // layer:stones
    sg_shown = sg_stage_select(sg_shown, 7.0, m_dents);  // layer:dents
    sg_shown = sg_stage_select(sg_shown, 8.0, m_grain);  // layer:grain
    sg_shown = sg_stage_select(sg_shown, 9.0, vec3(m_uv0.st, 0.0));  // uv0
    sg_shown = sg_stage_select(sg_shown, 10.0, vec4(m_uv0.dx, m_uv0.dy));  // uv0-derivatives
    sg_shown = sg_stage_select(sg_shown, 11.0, m_normal_derivatives.dndx);  // base-normal-dx
    sg_shown = sg_stage_select(sg_shown, 12.0, m_normal_derivatives.dndy);  // base-normal-dy
    sg_shown = sg_stage_select(sg_shown, 13.0, m_parallax_position);  // moved-position
    sg_out_value = sg_shown;
}

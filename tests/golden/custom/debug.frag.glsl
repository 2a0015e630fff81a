#version 450
#extension GL_GOOGLE_include_directive : require
// bumps of one's own: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"

// shaders/custom.glsl
// Functions that materials/custom.json calls as layers. A function sees what it is handed and nothing else.
#include "surfgrad/deriv.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/height_map.glsl"
#include "surfgrad/sample.glsl"
#include "surfgrad/volume.glsl"

#ifndef c_OCTAVES
#define c_OCTAVES 4
#endif

const float c_kZero = 128.0;  // the code of the woven map that means 0

// A volume gradient: dents where a turbulence is low. The chain rule brings the frequency.
vec3 c_dents(SgVolume object, float frequency, float power) {
    SgNoise noise = sg_volume_turbulence(sg_volume_scale(object, frequency), c_OCTAVES);
    return frequency * sg_noise_power(noise, power).gradient;
}

// A derivative along +s and +t: the slopes of a map that was painted with green down.
vec2 c_slopes(texture2D map, sampler map_sampler, SgUv uv) {
    return sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(map, map_sampler, uv).xyz, c_kZero));
}

// A surface gradient: stones whose height is measured in world units.
vec3 c_stones(SgFrame frame, texture2D heights, sampler heights_sampler, SgUv uv, vec2 tiling) {
    SgUv place = sg_uv_scale(uv, tiling);
    vec2 deriv = sg_deriv_from_height_hq(heights, heights_sampler, place);
    return sg_surfgrad_from_height(frame, place, sg_texture_size(heights, heights_sampler), deriv);
}

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    float p_power;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_weave;
layout(set = 1, binding = 2) uniform texture2D t_pebble;
layout(set = 1, binding = 3) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 5) in vec2 sg_in_uv1;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_value;

void main() {
    SgVolume m_object = sg_stage_volume(sg_in_object_position);
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    SgUv m_uv1 = sg_stage_uv(sg_in_uv1);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);

    // dents: custom
    vec3 m_dents = sg_surfgrad_from_volume(
        m_base_normal, -0.12 * sg_stage_gradient_from_object(c_dents(m_object, 3.0, sg_material.p_power)));

    // weave: custom
    SgUv m_weave_uv = sg_uv_transform(m_uv1, vec2(6.0, 4.0), 0.5235988, vec2(0.0));
    vec3 m_weave = sg_surfgrad_from_tbn(0.3 * c_slopes(t_weave, s_0, m_weave_uv),
                                        sg_basis_uv(m_frame, m_weave_uv));

    // stones: custom
    vec3 m_stones = 0.05 * c_stones(m_frame, t_pebble, s_0, m_uv0, vec2(4.0, 2.0));

    vec3 m_gradient = m_dents + m_weave + m_stones;

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_gradient);  // gradient
    sg_shown = sg_stage_select(sg_shown, 5.0, sg_resolve(m_base_normal, m_gradient));  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_dents);  // layer:dents
    sg_shown = sg_stage_select(sg_shown, 7.0, m_weave);  // layer:weave
    sg_shown = sg_stage_select(sg_shown, 8.0, m_stones);  // layer:stones
    sg_shown = sg_stage_select(sg_shown, 9.0, vec3(m_uv0.st, 0.0));  // uv0
    sg_shown = sg_stage_select(sg_shown, 10.0, vec4(m_uv0.dx, m_uv0.dy));  // uv0-derivatives
    sg_shown = sg_stage_select(sg_shown, 11.0, vec3(m_uv1.st, 0.0));  // uv1
    sg_shown = sg_stage_select(sg_shown, 12.0, vec4(m_uv1.dx, m_uv1.dy));  // uv1-derivatives
    sg_shown = sg_stage_select(sg_shown, 13.0, m_object.p);  // object-position
    sg_shown = sg_stage_select(sg_shown, 14.0, m_object.dx);  // object-position-dx
    sg_shown = sg_stage_select(sg_shown, 15.0, m_object.dy);  // object-position-dy
    sg_out_value = sg_shown;
}

#version 450
#extension GL_GOOGLE_include_directive : require
// eroded plaster: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "stage/world.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/noise.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    float p_dents;
    float d_dents_multiply;
} sg_material;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_value;

void main() {
    SgVolume m_object = sg_stage_volume(sg_in_object_position);
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgVolume m_world = sg_stage_volume_in_world(sg_in_position);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);

    // forms: noise
    vec3 m_forms_gradient = sg_stage_gradient_from_object(
        0.125 * sg_volume_fractal_sum(sg_volume_scale(m_object, 2.5), 5).gradient);
    vec3 m_forms = sg_surfgrad_from_volume(m_base_normal, m_forms_gradient);

    // dents: noise
    vec3 m_dents_gradient = sg_stage_gradient_from_object(sg_material.d_dents_multiply *
        sg_noise_power(sg_volume_turbulence(sg_volume_scale(m_object, 3.0), 4), 2.5).gradient);
    vec3 m_dents = sg_surfgrad_from_volume(m_base_normal, m_dents_gradient);

    // grain: noise
    vec3 m_grain_gradient = 0.1125 * sg_volume_perlin(sg_volume_scale(m_world, 45.0)).gradient;
    vec3 m_grain = sg_surfgrad_from_volume(m_base_normal, m_grain_gradient);

    vec3 m_gradient = m_forms_gradient + m_dents_gradient + m_grain_gradient;

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    // gradient
    sg_shown = sg_stage_select(sg_shown, 4.0, sg_surfgrad_from_volume(m_base_normal, m_gradient));
    sg_shown = sg_stage_select(sg_shown, 5.0, sg_resolve_volume(m_base_normal, m_gradient));  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_forms);  // layer:forms
    sg_shown = sg_stage_select(sg_shown, 7.0, m_dents);  // layer:dents
    sg_shown = sg_stage_select(sg_shown, 8.0, m_grain);  // layer:grain
    sg_shown = sg_stage_select(sg_shown, 9.0, m_object.p);  // object-position
    sg_shown = sg_stage_select(sg_shown, 10.0, m_object.dx);  // object-position-dx
    sg_shown = sg_stage_select(sg_shown, 11.0, m_object.dy);  // object-position-dy
    sg_shown = sg_stage_select(sg_shown, 12.0, m_world.p);  // world-position
    sg_shown = sg_stage_select(sg_shown, 13.0, m_world.dx);  // world-position-dx
    sg_shown = sg_stage_select(sg_shown, 14.0, m_world.dy);  // world-position-dy
    sg_out_value = sg_shown;
}

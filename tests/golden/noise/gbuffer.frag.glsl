#version 450
#extension GL_GOOGLE_include_directive : require
// eroded plaster: fragment shader of the entry point 'gbuffer', made by surfgradc.

#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "stage/world.glsl"
#include "surfgrad/frame.glsl"
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
layout(location = 0) out vec4 sg_out_base_color;
layout(location = 1) out vec4 sg_out_normal;
layout(location = 2) out vec4 sg_out_surface;
layout(location = 3) out vec4 sg_out_emission;

void main() {
    SgVolume m_object = sg_stage_volume(sg_in_object_position);

    // forms: noise
    vec3 m_forms = sg_stage_gradient_from_object(
        0.125 * sg_volume_fractal_sum(sg_volume_scale(m_object, 2.5), 5).gradient);

    // dents: noise
    vec3 m_dents = sg_stage_gradient_from_object(sg_material.d_dents_multiply *
        sg_noise_power(sg_volume_turbulence(sg_volume_scale(m_object, 3.0), 4), 2.5).gradient);

    // grain: noise
    vec3 m_grain = 0.1125 *
        sg_volume_perlin(sg_volume_scale(sg_stage_volume_in_world(sg_in_position), 45.0)).gradient;

    sg_out_base_color = vec4(vec3(0.62, 0.57, 0.48), 1.0);
    sg_out_normal = vec4(sg_resolve_volume(sg_base_normal(sg_in_normal), m_forms + m_dents + m_grain), 0.9);
    sg_out_surface = vec4(0.0, 1.0, 0.0, 1.0);
    sg_out_emission = vec4(vec3(0.0), 1.0);
}

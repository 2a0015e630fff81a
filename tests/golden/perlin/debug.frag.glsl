#version 450
#extension GL_GOOGLE_include_directive : require
// noise on a sphere: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/volume.glsl"

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_value;

void main() {
    SgVolume m_object = sg_stage_volume(sg_in_object_position);
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);

    // noise: noise
    vec3 m_noise_gradient = sg_stage_gradient_from_object(
        0.3 * sg_volume_fractal_sum(sg_volume_scale(m_object, 6.0), 4).gradient);
    vec3 m_noise = sg_surfgrad_from_volume(m_base_normal, m_noise_gradient);

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_noise);  // gradient
    sg_shown = sg_stage_select(sg_shown, 5.0, sg_resolve_volume(m_base_normal, m_noise_gradient));  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_noise);  // layer:noise
    sg_shown = sg_stage_select(sg_shown, 7.0, m_object.p);  // object-position
    sg_shown = sg_stage_select(sg_shown, 8.0, m_object.dx);  // object-position-dx
    sg_shown = sg_stage_select(sg_shown, 9.0, m_object.dy);  // object-position-dy
    sg_out_value = sg_shown;
}

#version 450
#extension GL_GOOGLE_include_directive : require
// a decal on a plane: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/decal.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/resolve.glsl"

layout(set = 1, binding = 1) uniform texture2D t_dome;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_value;

void main() {
    SgVolume m_object = sg_stage_volume(sg_in_object_position);
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);

    // decal: decal
    SgDecal m_decal_decal = sg_decal_box(
        mat4(mat4x3(vec3(0.95755553, 0.0, -0.7142085), vec3(0.0, -1.25, 0.0),
                    vec3(-0.8034845, 0.0, -0.85116047), vec3(0.0))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_decal_gradient =
        sg_decal_falloff_box(m_decal_decal.local, 0.15) *
        sg_stage_gradient_from_object(sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_stage_sample(t_dome, s_0, m_decal_decal.uv).xyz, 127.5))),
            m_decal_decal));
    vec3 m_decal = sg_surfgrad_from_volume(m_base_normal, m_decal_gradient);

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_decal);  // gradient
    sg_shown = sg_stage_select(sg_shown, 5.0, sg_resolve_volume(m_base_normal, m_decal_gradient));  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_decal);  // layer:decal
    sg_shown = sg_stage_select(sg_shown, 7.0, m_object.p);  // object-position
    sg_shown = sg_stage_select(sg_shown, 8.0, m_object.dx);  // object-position-dx
    sg_shown = sg_stage_select(sg_shown, 9.0, m_object.dy);  // object-position-dy
    sg_out_value = sg_shown;
}

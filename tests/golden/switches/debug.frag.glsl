#version 450
#extension GL_GOOGLE_include_directive : require
// painted bricks: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    float p_painted;
    float p_repeats;
    float p_depth;
    vec3 p_paint;
    float d_cracks_multiply;
    float d_roughness;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_bumps;
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

    // bumps: normal_map
    vec3 m_bumps = sg_surfgrad_from_tbn(
        sg_material.p_depth * sg_deriv_green_up(sg_deriv_from_normal_xyz(sg_decode_signed(
            sg_stage_sample(t_bumps, s_0, sg_uv_scale(m_uv0, vec2(sg_material.p_repeats))).xyz, 127.5))),
        sg_basis_uv(m_frame, m_uv0));

    // cracks: noise
    vec3 m_cracks = sg_surfgrad_from_volume(
        m_base_normal,
        sg_stage_gradient_from_object(sg_material.d_cracks_multiply *
            sg_volume_turbulence(sg_volume_scale(m_object, 6.0), 4).gradient));

    vec3 m_gradient = m_bumps + m_cracks;

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_gradient);  // gradient
    sg_shown = sg_stage_select(sg_shown, 5.0, sg_resolve(m_base_normal, m_gradient));  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_bumps);  // layer:bumps
    sg_shown = sg_stage_select(sg_shown, 7.0, m_cracks);  // layer:cracks
    sg_shown = sg_stage_select(sg_shown, 8.0, vec3(m_uv0.st, 0.0));  // uv0
    sg_shown = sg_stage_select(sg_shown, 9.0, vec4(m_uv0.dx, m_uv0.dy));  // uv0-derivatives
    sg_shown = sg_stage_select(sg_shown, 10.0, m_object.p);  // object-position
    sg_shown = sg_stage_select(sg_shown, 11.0, m_object.dx);  // object-position-dx
    sg_shown = sg_stage_select(sg_shown, 12.0, m_object.dy);  // object-position-dy
    sg_out_value = sg_shown;
}

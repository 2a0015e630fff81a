#version 450
#extension GL_GOOGLE_include_directive : require
// five layers, all parameters: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "stage/world.glsl"
#include "surfgrad/decal.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/noise.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/triplanar.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    vec3 p_tint;
    float p_opacity;
    vec2 p_tiling;
    vec2 p_detail_tiling;
    float p_pebble_tiling;
    float p_frequency;
    float p_power;
    mat4 p_projector;
    float p_weave_strength;
    float p_detail_strength;
    float p_pebble_strength;
    float p_dent_strength;
    float p_decal_strength;
    float p_roughness;
    float p_metallic;
    float d_dents_multiply;
    vec3 d_sign_axis_s;
    vec3 d_sign_axis_t;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_weave;
layout(set = 1, binding = 2) uniform texture2D t_scratch;
layout(set = 1, binding = 3) uniform texture2D t_pebble;
layout(set = 1, binding = 4) uniform texture2D t_ramp;
layout(set = 1, binding = 5) uniform texture2D t_moss;
layout(set = 1, binding = 7) uniform texture2D t_sign;
layout(set = 1, binding = 8) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 5) in vec2 sg_in_uv1;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_value;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    vec3 m_base_normal = sg_mirror_normal(sg_base_normal(sg_in_normal), sg_stage_facing());
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    SgUv m_uv1 = sg_stage_uv(sg_in_uv1);
    SgVolume m_world = sg_stage_volume_in_world(sg_in_position);
    SgVolume m_object = sg_stage_volume(sg_in_object_position);
    SgBasis m_basis_vertex = sg_basis_vertex(sg_in_normal, sg_in_tangent);

    // weave: normal_map
    vec3 m_weave = sg_surfgrad_from_tbn(
        sg_material.p_weave_strength * sg_deriv_from_normal_xyz(sg_decode_signed(
            sg_stage_sample(t_weave, s_0, sg_uv_scale(m_uv0, sg_material.p_tiling)).xyz, 127.5)),
        m_basis_vertex);

    // detail: normal_map
    vec3 m_detail = sg_surfgrad_from_tbn(
        sg_stage_sample(t_moss, s_0, m_uv0).x *
        sg_material.p_detail_strength *
        sg_deriv_from_normal_xy(sg_decode_signed(
            sg_stage_sample(t_scratch, s_0, sg_uv_scale(m_uv1, sg_material.p_detail_tiling)).xy, 127.5)),
        sg_basis_uv(m_frame, m_uv1));

    // pebbles: triplanar
    SgTriplanarUv m_pebbles_planes = sg_volume_triplanar_uv(
        sg_volume_scale(m_world, sg_material.p_pebble_tiling), SG_LEFT_HAND, SG_LOWER_LEFT);
    vec3 m_pebbles_gradient = sg_material.p_pebble_strength * sg_triplanar_gradient(
        sg_triplanar_weights(m_base_normal, 3.0),
        sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_pebbles_planes.x).xyz, 127.5)),
        sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_pebbles_planes.y).xyz, 127.5)),
        sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_pebbles_planes.z).xyz, 127.5)),
        SG_LEFT_HAND, SG_LOWER_LEFT);
    vec3 m_pebbles = sg_surfgrad_from_volume(m_base_normal, m_pebbles_gradient);

    // dents: noise
    vec3 m_dents_gradient = sg_stage_gradient_from_object(sg_material.d_dents_multiply * sg_noise_power(
        sg_volume_turbulence(sg_volume_scale(m_object, sg_material.p_frequency), 4),
        sg_material.p_power).gradient);
    vec3 m_dents = sg_surfgrad_from_volume(m_base_normal, m_dents_gradient);

    // sign: decal
    SgDecal m_sign_decal = sg_decal_box(sg_material.p_projector, m_world.p, m_world.dx, m_world.dy);
    vec3 m_sign_gradient =
        sg_decal_falloff_box(m_sign_decal.local, 0.25) *
        sg_stage_sample(t_sign, s_0, m_sign_decal.uv).w *
        sg_material.p_decal_strength *
        sg_decal_gradient_along(
            sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_stage_sample(t_ramp, s_0, m_sign_decal.uv).xyz, 127.5)),
            sg_material.d_sign_axis_s, sg_material.d_sign_axis_t);
    vec3 m_sign = sg_surfgrad_from_volume(m_base_normal, m_sign_gradient);

    vec3 m_gradient = m_weave + m_detail +
        sg_surfgrad_from_volume(m_base_normal, m_pebbles_gradient + m_dents_gradient + m_sign_gradient);

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_gradient);  // gradient
    sg_shown = sg_stage_select(sg_shown, 5.0, sg_resolve(m_base_normal, m_gradient));  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_weave);  // layer:weave
    sg_shown = sg_stage_select(sg_shown, 7.0, m_detail);  // layer:detail
    sg_shown = sg_stage_select(sg_shown, 8.0, m_pebbles);  // layer:pebbles
    sg_shown = sg_stage_select(sg_shown, 9.0, m_dents);  // layer:dents
    sg_shown = sg_stage_select(sg_shown, 10.0, m_sign);  // layer:sign
    sg_shown = sg_stage_select(sg_shown, 11.0, m_basis_vertex.tangent);  // tangent
    sg_shown = sg_stage_select(sg_shown, 12.0, m_basis_vertex.bitangent);  // bitangent
    sg_shown = sg_stage_select(sg_shown, 13.0, vec3(m_uv0.st, 0.0));  // uv0
    sg_shown = sg_stage_select(sg_shown, 14.0, vec4(m_uv0.dx, m_uv0.dy));  // uv0-derivatives
    sg_shown = sg_stage_select(sg_shown, 15.0, vec3(m_uv1.st, 0.0));  // uv1
    sg_shown = sg_stage_select(sg_shown, 16.0, vec4(m_uv1.dx, m_uv1.dy));  // uv1-derivatives
    sg_shown = sg_stage_select(sg_shown, 17.0, m_object.p);  // object-position
    sg_shown = sg_stage_select(sg_shown, 18.0, m_object.dx);  // object-position-dx
    sg_shown = sg_stage_select(sg_shown, 19.0, m_object.dy);  // object-position-dy
    sg_shown = sg_stage_select(sg_shown, 20.0, m_world.p);  // world-position
    sg_shown = sg_stage_select(sg_shown, 21.0, m_world.dx);  // world-position-dx
    sg_shown = sg_stage_select(sg_shown, 22.0, m_world.dy);  // world-position-dy
    sg_out_value = sg_shown;
}

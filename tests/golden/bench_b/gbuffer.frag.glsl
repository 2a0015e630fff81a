#version 450
#extension GL_GOOGLE_include_directive : require
// five layers, all parameters: fragment shader of the entry point 'gbuffer', made by surfgradc.

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
layout(set = 1, binding = 6) uniform texture2D t_stone;
layout(set = 1, binding = 7) uniform texture2D t_sign;
layout(set = 1, binding = 8) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 5) in vec2 sg_in_uv1;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_base_color;
layout(location = 1) out vec4 sg_out_normal;
layout(location = 2) out vec4 sg_out_surface;
layout(location = 3) out vec4 sg_out_emission;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    vec3 m_base_normal = sg_mirror_normal(sg_base_normal(sg_in_normal), sg_stage_facing());
    SgUv m_uv1 = sg_stage_uv(sg_in_uv1);
    SgVolume m_world = sg_stage_volume_in_world(sg_in_position);

    // weave: normal_map
    vec3 m_weave = sg_surfgrad_from_tbn(
        sg_material.p_weave_strength * sg_deriv_from_normal_xyz(sg_decode_signed(
            sg_stage_sample(t_weave, s_0, sg_uv_scale(m_uv0, sg_material.p_tiling)).xyz, 127.5)),
        sg_basis_vertex(sg_in_normal, sg_in_tangent));

    // detail: normal_map
    vec3 m_detail = sg_surfgrad_from_tbn(
        sg_stage_sample(t_moss, s_0, m_uv0).x *
        sg_material.p_detail_strength *
        sg_deriv_from_normal_xy(sg_decode_signed(
            sg_stage_sample(t_scratch, s_0, sg_uv_scale(m_uv1, sg_material.p_detail_tiling)).xy, 127.5)),
        sg_basis_uv(sg_stage_frame(sg_in_position, m_base_normal), m_uv1));

    // pebbles: triplanar
    SgTriplanarUv m_pebbles_planes = sg_volume_triplanar_uv(
        sg_volume_scale(m_world, sg_material.p_pebble_tiling), SG_LEFT_HAND, SG_LOWER_LEFT);
    vec3 m_pebbles = sg_material.p_pebble_strength * sg_triplanar_gradient(
        sg_triplanar_weights(m_base_normal, 3.0),
        sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_pebbles_planes.x).xyz, 127.5)),
        sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_pebbles_planes.y).xyz, 127.5)),
        sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_pebbles_planes.z).xyz, 127.5)),
        SG_LEFT_HAND, SG_LOWER_LEFT);

    // dents: noise
    vec3 m_dents = sg_stage_gradient_from_object(sg_material.d_dents_multiply * sg_noise_power(
        sg_volume_turbulence(sg_volume_scale(sg_stage_volume(sg_in_object_position), sg_material.p_frequency),
                             4),
        sg_material.p_power).gradient);

    // sign: decal
    SgDecal m_sign_decal = sg_decal_box(sg_material.p_projector, m_world.p, m_world.dx, m_world.dy);
    vec4 m_sign_cutout = sg_stage_sample(t_sign, s_0, m_sign_decal.uv);
    float m_sign_coverage = sg_decal_falloff_box(m_sign_decal.local, 0.25) * m_sign_cutout.w;
    vec3 m_sign = m_sign_coverage * sg_material.p_decal_strength * sg_decal_gradient_along(
        sg_deriv_from_normal_xyz(sg_decode_signed(sg_stage_sample(t_ramp, s_0, m_sign_decal.uv).xyz, 127.5)),
        sg_material.d_sign_axis_s, sg_material.d_sign_axis_t);

    vec4 m_stone_texel = sg_stage_sample(t_stone, s_0, m_uv0);
    vec3 m_stone = sg_material.p_tint * m_stone_texel.rgb;

    sg_out_base_color = vec4(mix(m_stone, m_sign_cutout.rgb, m_sign_coverage),
                             sg_material.p_opacity * m_stone_texel.w);
    sg_out_normal = vec4(
        sg_resolve(m_base_normal,
                   m_weave + m_detail + sg_surfgrad_from_volume(m_base_normal, m_pebbles + m_dents + m_sign)),
        sg_material.p_roughness);
    sg_out_surface = vec4(sg_material.p_metallic, 1.0, 0.0, 1.0);
    sg_out_emission = vec4(vec3(0.0), 1.0);
}

#version 450
#extension GL_GOOGLE_include_directive : require
// parallax and three resolves, all parameters: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/moved.glsl"
#include "stage/object.glsl"
#include "stage/view.glsl"
#include "surfgrad/decal.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/from_normal.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/height_map.glsl"
#include "surfgrad/noise.glsl"
#include "surfgrad/parallax.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/sample.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/triplanar.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    vec3 p_tint;
    float p_opacity;
    vec2 p_tiling;
    vec2 p_detail_tiling;
    vec2 p_rib_tiling;
    float p_weave_tiling;
    float p_exponent;
    float p_frequency;
    float p_power;
    mat4 p_first_projector;
    mat4 p_second_projector;
    float p_depth;
    float p_stone_strength;
    float p_detail_strength;
    float p_object_strength;
    float p_rib_strength;
    float p_weave_strength;
    float p_dent_strength;
    float p_first_strength;
    float p_second_strength;
    float p_roughness;
    float p_metallic;
    float p_wetness;
    float d_parallax_multiply;
    float d_dents_multiply;
    vec3 d_sign_axis_s;
    vec3 d_sign_axis_t;
    vec3 d_plaster_axis_s;
    vec3 d_plaster_axis_t;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_height;
layout(set = 1, binding = 2) uniform texture2D t_pebble;
layout(set = 1, binding = 3) uniform texture2D t_scratch;
layout(set = 1, binding = 4) uniform texture2D t_moss;
layout(set = 1, binding = 5) uniform texture2D t_sphere;
layout(set = 1, binding = 6) uniform texture2D t_rib;
layout(set = 1, binding = 7) uniform texture2D t_weave;
layout(set = 1, binding = 8) uniform texture2D t_ramp;
layout(set = 1, binding = 9) uniform texture2D t_brick;
layout(set = 1, binding = 11) uniform texture2D t_sign;
layout(set = 1, binding = 12) uniform texture2D t_plaster;
layout(set = 1, binding = 13) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 3) in vec4 sg_in_color;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 5) in vec2 sg_in_uv1;
layout(location = 6) in vec2 sg_in_uv2;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_value;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    vec3 m_base_normal = sg_mirror_normal(sg_base_normal(sg_in_normal), sg_stage_facing());
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    SgUv m_uv1 = sg_stage_uv(sg_in_uv1);
    SgUv m_uv2 = sg_stage_uv(sg_in_uv2);
    SgVolume m_object = sg_stage_volume(sg_in_object_position);

    // parallax: occlusion
    SgUv m_parallax_uv = sg_uv_scale(m_uv0, sg_material.p_tiling);
    vec3 m_parallax_view = sg_parallax_direction(m_frame, m_parallax_uv, sg_stage_view(sg_in_position));
    SgParallax m_parallax_hit = sg_parallax_occlusion(
        t_height, s_0, vec2(sg_material.p_depth, sg_material.d_parallax_multiply), m_parallax_uv.st,
        m_parallax_view, sg_uv_level(m_parallax_uv, sg_texture_size(t_height, s_0)),
        int(mix(48.0, 12.0, clamp(m_parallax_view.z, 0.0, 1.0))));
    vec3 m_parallax_position = sg_parallax_position(m_frame,
                                                    sg_parallax_pixels(m_parallax_uv, m_parallax_hit.offset),
                                                    m_parallax_hit.height);

    SgUv m_seen_uv = sg_parallax_uv(m_parallax_uv, m_parallax_hit.offset);

    // stones: normal_map
    vec3 m_stones = sg_surfgrad_from_height(
        m_frame, m_seen_uv,
        sg_texture_size(t_pebble, s_0),
        sg_material.p_stone_strength *
            sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_pebble, s_0, m_seen_uv).xyz, 127.5)));

    // detail: normal_map
    vec3 m_detail = sg_surfgrad_from_tbn(
        sg_sample(t_moss, s_0, m_seen_uv).x *
        sg_material.p_detail_strength *
        sg_deriv_from_normal_xy(sg_decode_signed(
            sg_sample(t_scratch, s_0, sg_uv_scale(m_uv1, sg_material.p_detail_tiling)).xy, 127.5)),
        sg_basis_uv(m_frame, m_uv1));

    // sphere: object_normal_map
    vec3 m_sphere = sg_material.p_object_strength * sg_surfgrad_from_normal(
        m_base_normal,
        sg_stage_normal_from_object(sg_decode_signed(sg_sample(t_sphere, s_0, m_seen_uv).xyz, 127.5)));

    // ribs: height_map
    vec3 m_ribs = sg_surfgrad_from_tbn(
        clamp(sg_in_color.x, 0.0, 1.0) * sg_material.p_rib_strength *
            sg_deriv_from_height_hq(t_rib, s_0, sg_uv_scale(m_uv2, sg_material.p_rib_tiling)),
        sg_basis_uv(m_frame, m_uv2));

    vec3 m_gradient = m_stones + m_detail + m_sphere + m_ribs;
    vec3 m_relief_normal = sg_resolve(m_base_normal, m_gradient);
    SgVolume m_moved_world = sg_stage_world_volume(
        sg_stage_frame_rebuilt(m_parallax_position, m_relief_normal, 1.0));

    // weave: triplanar
    SgTriplanarUv m_weave_planes = sg_volume_triplanar_uv(
        sg_volume_scale(m_moved_world, sg_material.p_weave_tiling), SG_LEFT_HAND, SG_LOWER_LEFT);
    vec3 m_weave_gradient =
        clamp(sg_in_color.y, 0.0, 1.0) *
        sg_material.p_weave_strength *
        sg_triplanar_gradient(
            sg_triplanar_weights(m_relief_normal, sg_material.p_exponent),
            sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_weave, s_0, m_weave_planes.x).xyz, 127.5)),
            sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_weave, s_0, m_weave_planes.y).xyz, 127.5)),
            sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_weave, s_0, m_weave_planes.z).xyz, 127.5)),
            SG_LEFT_HAND, SG_LOWER_LEFT);
    vec3 m_weave = sg_surfgrad_from_volume(m_relief_normal, m_weave_gradient);

    // dents: noise
    vec3 m_dents_gradient = sg_stage_gradient_from_object(sg_material.d_dents_multiply * sg_noise_power(
        sg_volume_turbulence(sg_volume_scale(m_object, sg_material.p_frequency), 6),
        sg_material.p_power).gradient);
    vec3 m_dents = sg_surfgrad_from_volume(m_relief_normal, m_dents_gradient);

    vec3 m_surface_normal = sg_resolve_volume(m_relief_normal, m_weave_gradient + m_dents_gradient);

    // sign: decal
    SgDecal m_sign_decal = sg_decal_box(sg_material.p_first_projector, m_moved_world.p, m_moved_world.dx,
                                        m_moved_world.dy);
    vec3 m_sign_gradient =
        sg_decal_falloff_box(m_sign_decal.local, 0.25) *
        sg_sample(t_sign, s_0, m_sign_decal.uv).w *
        sg_material.p_first_strength *
        sg_decal_gradient_along(
            sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_ramp, s_0, m_sign_decal.uv).xyz, 127.5)),
            sg_material.d_sign_axis_s, sg_material.d_sign_axis_t);
    vec3 m_sign = sg_surfgrad_from_volume(m_surface_normal, m_sign_gradient);

    // plaster: decal
    SgDecal m_plaster_decal = sg_decal_box(sg_material.p_second_projector, m_moved_world.p, m_moved_world.dx,
                                           m_moved_world.dy);
    vec3 m_plaster_gradient =
        sg_decal_falloff_box(m_plaster_decal.local, 0.25) *
        sg_sample(t_plaster, s_0, m_plaster_decal.uv).w *
        sg_material.p_second_strength *
        sg_decal_gradient_along(
            sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_sample(t_brick, s_0, m_plaster_decal.uv).xyz, 127.5)),
            sg_material.d_plaster_axis_s, sg_material.d_plaster_axis_t);
    vec3 m_plaster = sg_surfgrad_from_volume(m_surface_normal, m_plaster_gradient);

    vec3 m_decals_normal = sg_resolve_volume(m_surface_normal, m_sign_gradient + m_plaster_gradient);
    float m_wet = sg_material.p_wetness * sg_in_color.z;
    float m_clamp = clamp(m_wet, 0.0, 1.0);

    // film: earlier_normal
    vec3 m_film = sg_resolve_towards(m_decals_normal, m_relief_normal, m_clamp);

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_gradient);  // gradient
    sg_shown = sg_stage_select(sg_shown, 5.0, m_film);  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_stones);  // layer:stones
    sg_shown = sg_stage_select(sg_shown, 7.0, m_detail);  // layer:detail
    sg_shown = sg_stage_select(sg_shown, 8.0, m_sphere);  // layer:sphere
    sg_shown = sg_stage_select(sg_shown, 9.0, m_ribs);  // layer:ribs
    sg_shown = sg_stage_select(sg_shown, 10.0, m_weave);  // layer:weave
    sg_shown = sg_stage_select(sg_shown, 11.0, m_dents);  // layer:dents
    sg_shown = sg_stage_select(sg_shown, 12.0, m_sign);  // layer:sign
    sg_shown = sg_stage_select(sg_shown, 13.0, m_plaster);  // layer:plaster
    // layer:film
    sg_shown = sg_stage_select(sg_shown, 14.0,
                               m_clamp * sg_surfgrad_from_normal(m_decals_normal, m_relief_normal));
    sg_shown = sg_stage_select(sg_shown, 15.0, sg_in_color);  // vertex-color
    sg_shown = sg_stage_select(sg_shown, 16.0, vec3(m_uv0.st, 0.0));  // uv0
    sg_shown = sg_stage_select(sg_shown, 17.0, vec4(m_uv0.dx, m_uv0.dy));  // uv0-derivatives
    sg_shown = sg_stage_select(sg_shown, 18.0, vec3(m_uv1.st, 0.0));  // uv1
    sg_shown = sg_stage_select(sg_shown, 19.0, vec4(m_uv1.dx, m_uv1.dy));  // uv1-derivatives
    sg_shown = sg_stage_select(sg_shown, 20.0, vec3(m_uv2.st, 0.0));  // uv2
    sg_shown = sg_stage_select(sg_shown, 21.0, vec4(m_uv2.dx, m_uv2.dy));  // uv2-derivatives
    sg_shown = sg_stage_select(sg_shown, 22.0, m_object.p);  // object-position
    sg_shown = sg_stage_select(sg_shown, 23.0, m_object.dx);  // object-position-dx
    sg_shown = sg_stage_select(sg_shown, 24.0, m_object.dy);  // object-position-dy
    sg_shown = sg_stage_select(sg_shown, 25.0, m_parallax_position);  // moved-position
    sg_out_value = sg_shown;
}

#version 450
#extension GL_GOOGLE_include_directive : require
// mossy rock: fragment shader of the entry point 'forward', made by surfgradc.

#include "lighting/ggx.glsl"
#include "stage/forward.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/combine.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/number.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/triplanar.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    float p_detail;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_scan;
layout(set = 1, binding = 2) uniform texture2D t_pebble;
layout(set = 1, binding = 3) uniform texture2D t_scratch;
layout(set = 1, binding = 4) uniform texture2D t_moss;
layout(set = 1, binding = 5) uniform texture2D t_stone;
layout(set = 1, binding = 6) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 5) in vec2 sg_in_uv1;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_color;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    SgVolume m_object = sg_stage_volume(sg_in_object_position);
    SgUv m_uv1 = sg_stage_uv(sg_in_uv1);

    // scan: normal_map
    vec3 m_scan = sg_decode_signed(sg_stage_sample(t_scan, s_0, sg_uv_scale(m_uv0, vec2(4.0, 2.0))).xyz,
                                   127.5);

    vec3 m_macro_normal = sg_resolve_vertex_map(sg_in_normal, sg_in_tangent, 1.0, m_scan, vec2(1.0, -1.0));

    // gravel: triplanar
    SgTriplanarUv m_gravel_planes = sg_volume_triplanar_uv(sg_volume_scale(m_object, 3.0), SG_RIGHT_HAND,
                                                           SG_UPPER_LEFT);
    vec3 m_gravel = sg_surfgrad_from_volume(
        m_macro_normal,
        sg_material.p_detail * sg_stage_gradient_from_object(sg_triplanar_gradient(
            sg_triplanar_weights(sg_stage_object_normal(m_macro_normal), 3.0),
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_gravel_planes.x).xyz, 127.0))),
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_gravel_planes.y).xyz, 127.0))),
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_gravel_planes.z).xyz, 127.0))),
            SG_RIGHT_HAND, SG_UPPER_LEFT)));

    // fuzz: noise in wet moss
    vec3 m_fuzz = sg_surfgrad_from_volume(
        m_macro_normal,
        sg_stage_gradient_from_object(
            0.16 * sg_volume_fractal_sum(sg_volume_scale(m_object, 40.0), 3).gradient));

    // slime: normal_map in wet moss
    vec3 m_slime = sg_surfgrad_from_tbn(
        0.3 * sg_deriv_from_normal_xy(
            sg_decode_signed(sg_stage_sample(t_scratch, s_0, sg_uv_scale(m_uv1, vec2(4.0))).xy, 127.5)),
        sg_basis_uv(
            sg_frame_resolved(sg_stage_frame(sg_in_position, sg_base_normal(sg_in_normal)), m_macro_normal),
            m_uv1));

    // wet moss: group
    vec3 m_wet_moss = m_fuzz + m_slime;

    float m_facing_up = sg_smoothstep(0.1, 0.6, dot(m_macro_normal, vec3(0.0, 1.0, 0.0)));
    float m_mossy = sg_stage_sample(t_moss, s_0, sg_uv_scale(m_uv0, vec2(6.0, 3.0))).x * m_facing_up;

    SgGgxSurface sg_surface;
    sg_surface.base_color = mix(sg_stage_sample(t_stone, s_0, sg_uv_scale(m_uv0, vec2(8.0, 4.0))).rgb,
                                vec3(0.08, 0.2, 0.03), m_mossy);
    sg_surface.metallic = 0.0;
    sg_surface.roughness = mix(0.75, 0.4, m_mossy);
    sg_surface.occlusion = sg_stage_sample(t_moss, s_0, m_uv0).y * 0.3 + 0.7;
    sg_surface.emission = vec3(0.0);
    sg_out_color = vec4(
        sg_ggx_radiance(
            sg_surface,
            sg_flip(sg_resolve(m_macro_normal, sg_combine_mix(m_gravel, m_wet_moss, m_mossy)),
                    sg_stage_facing()),
            sg_stage_lights(sg_in_position)),
        1.0);
}

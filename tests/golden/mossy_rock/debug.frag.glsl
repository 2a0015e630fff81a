#version 450
#extension GL_GOOGLE_include_directive : require
// mossy rock: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
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
layout(set = 1, binding = 6) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 5) in vec2 sg_in_uv1;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_value;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    SgVolume m_object = sg_stage_volume(sg_in_object_position);
    SgFrame m_frame = sg_stage_frame(sg_in_position, sg_base_normal(sg_in_normal));
    SgUv m_uv1 = sg_stage_uv(sg_in_uv1);
    SgBasis m_basis_vertex = sg_basis_vertex(sg_in_normal, sg_in_tangent);

    // scan: normal_map
    vec3 m_scan_m = sg_decode_signed(sg_stage_sample(t_scan, s_0, sg_uv_scale(m_uv0, vec2(4.0, 2.0))).xyz,
                                     127.5);
    vec3 m_scan = sg_surfgrad_from_tbn(sg_deriv_green_up(sg_deriv_from_normal_xyz(m_scan_m)), m_basis_vertex);

    vec3 m_macro_normal = sg_resolve_vertex_map(sg_in_normal, sg_in_tangent, 1.0, m_scan_m, vec2(1.0, -1.0));

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
        sg_basis_uv(sg_frame_resolved(m_frame, m_macro_normal), m_uv1));

    // wet moss: group
    vec3 m_wet_moss = m_fuzz + m_slime;

    float m_facing_up = sg_smoothstep(0.1, 0.6, dot(m_macro_normal, vec3(0.0, 1.0, 0.0)));
    float m_mossy = sg_stage_sample(t_moss, s_0, sg_uv_scale(m_uv0, vec2(6.0, 3.0))).x * m_facing_up;

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_scan);  // gradient
    // normal
    sg_shown = sg_stage_select(
        sg_shown, 5.0,
        sg_flip(sg_resolve(m_macro_normal, sg_combine_mix(m_gravel, m_wet_moss, m_mossy)),
                sg_stage_facing()));
    sg_shown = sg_stage_select(sg_shown, 6.0, m_scan);  // layer:scan
    sg_shown = sg_stage_select(sg_shown, 7.0, m_gravel);  // layer:gravel
    sg_shown = sg_stage_select(sg_shown, 8.0, m_fuzz);  // layer:fuzz
    sg_shown = sg_stage_select(sg_shown, 9.0, m_slime);  // layer:slime
    sg_shown = sg_stage_select(sg_shown, 10.0, m_mossy * m_wet_moss);  // layer:wet moss
    sg_shown = sg_stage_select(sg_shown, 11.0, m_basis_vertex.tangent);  // tangent
    sg_shown = sg_stage_select(sg_shown, 12.0, m_basis_vertex.bitangent);  // bitangent
    sg_shown = sg_stage_select(sg_shown, 13.0, vec3(m_uv0.st, 0.0));  // uv0
    sg_shown = sg_stage_select(sg_shown, 14.0, vec4(m_uv0.dx, m_uv0.dy));  // uv0-derivatives
    sg_shown = sg_stage_select(sg_shown, 15.0, vec3(m_uv1.st, 0.0));  // uv1
    sg_shown = sg_stage_select(sg_shown, 16.0, vec4(m_uv1.dx, m_uv1.dy));  // uv1-derivatives
    sg_shown = sg_stage_select(sg_shown, 17.0, m_object.p);  // object-position
    sg_shown = sg_stage_select(sg_shown, 18.0, m_object.dx);  // object-position-dx
    sg_shown = sg_stage_select(sg_shown, 19.0, m_object.dy);  // object-position-dy
    sg_out_value = sg_shown;
}

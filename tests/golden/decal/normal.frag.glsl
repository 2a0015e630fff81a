#version 450
#extension GL_GOOGLE_include_directive : require
// marked torus: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "stage/world.glsl"
#include "surfgrad/combine.glsl"
#include "surfgrad/decal.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/sample.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    float p_reach;
    float d_dent_multiply;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_chart;
layout(set = 1, binding = 2) uniform texture2D t_brick;
layout(set = 1, binding = 3) uniform texture2D t_pebble;
layout(set = 1, binding = 5) uniform texture2D t_moss;
layout(set = 1, binding = 6) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    SgVolume m_object = sg_stage_volume(sg_in_object_position);
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgVolume m_world = sg_stage_volume_in_world(sg_in_position);

    // grain: noise
    vec3 m_grain = sg_stage_gradient_from_object(
        0.072 * sg_volume_fractal_sum(sg_volume_scale(m_object, 9.0), 3).gradient);

    // chart: decal
    SgDecal m_chart_decal = sg_decal_box(
        mat4(mat4x3(vec3(2.2222223, 0.0, 0.0), vec3(0.0, -1.5094117, -2.0478802),
                    vec3(0.0, 2.1556633, -1.4339411), vec3(-0.44444445, -1.9184061, 2.1916993))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_chart =
        sg_decal_falloff_box(m_chart_decal.local, 0.1) *
        sg_decal_angle_fade(sg_stage_object_normal(m_base_normal), vec3(0.0, 0.81915206, 0.57357645),
                            0.64278764, 0.087155744) *
        1.2 *
        sg_stage_gradient_from_object(sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_stage_sample(t_chart, s_0, m_chart_decal.uv).xyz, 127.5))),
            m_chart_decal));

    // pebbles: decal
    SgDecal m_pebbles_decal = sg_decal_sphere(
        mat4(mat4x3(vec3(1.6666666, 0.0, 0.0), vec3(0.0, -1.6666666, 0.0), vec3(0.0, 0.0, -1.6666666),
                    vec3(1.5, 0.0, 0.6666667))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_pebbles =
        sg_decal_falloff_sphere(m_pebbles_decal.local, 0.4) *
        sg_stage_gradient_from_object(sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_sample(t_pebble, s_0, m_pebbles_decal.uv).xyz, 127.0))),
            m_pebbles_decal));

    // dent: decal
    SgDecal m_dent_decal = sg_decal_box(
        mat4(mat4x3(vec3(2.8867514, 0.0, -1.6666666), vec3(-1.4433757, -1.6666666, -2.5),
                    vec3(-0.8333333, 2.8867514, -1.4433757), vec3(-2.2617514, -1.9983969, 3.0825317))),
        m_world.p, m_world.dx, m_world.dy);
    vec3 m_dent =
        -sg_decal_falloff_capsule(m_dent_decal.local, sg_material.d_dent_multiply, 0.2) *
        sg_stage_sample(t_moss, s_0, m_dent_decal.uv).x *
        sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_dent_decal.uv).xyz, 127.0))),
            m_dent_decal);

    // wedge: decal
    SgDecal m_wedge_decal = sg_decal_box(
        mat4(
            mat4x3(vec3(0.0, -2.5, 0.0), vec3(0.0, 0.0, -1.25), vec3(2.0, 0.0, 0.0), vec3(0.6, -2.625, 1.0))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_wedge =
        sg_decal_falloff_wedge(m_wedge_decal.local, 0.2) *
        0.8 *
        sg_stage_gradient_from_object(sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_stage_sample(t_chart, s_0, m_wedge_decal.uv).xyz, 127.5))),
            m_wedge_decal));

    // bricks: decal
    SgDecal m_bricks_decal = sg_decal_cone(
        mat4(mat4x3(vec3(1.4285715, 0.0, 0.0), vec3(0.0, 0.0, -0.625), vec3(0.0, 1.4285715, 0.0),
                    vec3(-1.2857143, 0.5714286, 0.875))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_bricks = sg_stage_gradient_from_object(sg_decal_gradient(
        sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_sample(t_brick, s_0, m_bricks_decal.uv).xyz, 127.5))),
        m_bricks_decal));

    sg_out_normal = vec4(
        sg_resolve_volume(
            m_base_normal,
            sg_combine_mix(m_grain + m_chart + m_pebbles + m_dent + m_wedge, m_bricks,
                           sg_decal_falloff_cone(m_bricks_decal.local, 0.15))),
        1.0);
}

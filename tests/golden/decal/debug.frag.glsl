#version 450
#extension GL_GOOGLE_include_directive : require
// marked torus: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "stage/world.glsl"
#include "surfgrad/combine.glsl"
#include "surfgrad/decal.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_volume.glsl"
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
layout(location = 0) out vec4 sg_out_value;

void main() {
    SgVolume m_object = sg_stage_volume(sg_in_object_position);
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgVolume m_world = sg_stage_volume_in_world(sg_in_position);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);

    // grain: noise
    vec3 m_grain_gradient = sg_stage_gradient_from_object(
        0.072 * sg_volume_fractal_sum(sg_volume_scale(m_object, 9.0), 3).gradient);
    vec3 m_grain = sg_surfgrad_from_volume(m_base_normal, m_grain_gradient);

    // chart: decal
    SgDecal m_chart_decal = sg_decal_box(
        mat4(mat4x3(vec3(2.2222223, 0.0, 0.0), vec3(0.0, -1.5094117, -2.0478802),
                    vec3(0.0, 2.1556633, -1.4339411), vec3(-0.44444445, -1.9184061, 2.1916993))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_chart_gradient =
        sg_decal_falloff_box(m_chart_decal.local, 0.1) *
        sg_decal_angle_fade(sg_stage_object_normal(m_base_normal), vec3(0.0, 0.81915206, 0.57357645),
                            0.64278764, 0.087155744) *
        1.2 *
        sg_stage_gradient_from_object(sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_stage_sample(t_chart, s_0, m_chart_decal.uv).xyz, 127.5))),
            m_chart_decal));
    vec3 m_chart = sg_surfgrad_from_volume(m_base_normal, m_chart_gradient);

    // pebbles: decal
    SgDecal m_pebbles_decal = sg_decal_sphere(
        mat4(mat4x3(vec3(1.6666666, 0.0, 0.0), vec3(0.0, -1.6666666, 0.0), vec3(0.0, 0.0, -1.6666666),
                    vec3(1.5, 0.0, 0.6666667))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_pebbles_gradient =
        sg_decal_falloff_sphere(m_pebbles_decal.local, 0.4) *
        sg_stage_gradient_from_object(sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_sample(t_pebble, s_0, m_pebbles_decal.uv).xyz, 127.0))),
            m_pebbles_decal));
    vec3 m_pebbles = sg_surfgrad_from_volume(m_base_normal, m_pebbles_gradient);

    // dent: decal
    SgDecal m_dent_decal = sg_decal_box(
        mat4(mat4x3(vec3(2.8867514, 0.0, -1.6666666), vec3(-1.4433757, -1.6666666, -2.5),
                    vec3(-0.8333333, 2.8867514, -1.4433757), vec3(-2.2617514, -1.9983969, 3.0825317))),
        m_world.p, m_world.dx, m_world.dy);
    vec3 m_dent_gradient =
        -sg_decal_falloff_capsule(m_dent_decal.local, sg_material.d_dent_multiply, 0.2) *
        sg_stage_sample(t_moss, s_0, m_dent_decal.uv).x *
        sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_dent_decal.uv).xyz, 127.0))),
            m_dent_decal);
    vec3 m_dent = sg_surfgrad_from_volume(m_base_normal, m_dent_gradient);

    // wedge: decal
    SgDecal m_wedge_decal = sg_decal_box(
        mat4(
            mat4x3(vec3(0.0, -2.5, 0.0), vec3(0.0, 0.0, -1.25), vec3(2.0, 0.0, 0.0), vec3(0.6, -2.625, 1.0))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_wedge_gradient =
        sg_decal_falloff_wedge(m_wedge_decal.local, 0.2) *
        0.8 *
        sg_stage_gradient_from_object(sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_stage_sample(t_chart, s_0, m_wedge_decal.uv).xyz, 127.5))),
            m_wedge_decal));
    vec3 m_wedge = sg_surfgrad_from_volume(m_base_normal, m_wedge_gradient);

    // bricks: decal
    SgDecal m_bricks_decal = sg_decal_cone(
        mat4(mat4x3(vec3(1.4285715, 0.0, 0.0), vec3(0.0, 0.0, -0.625), vec3(0.0, 1.4285715, 0.0),
                    vec3(-1.2857143, 0.5714286, 0.875))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_bricks_gradient = sg_stage_gradient_from_object(sg_decal_gradient(
        sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_sample(t_brick, s_0, m_bricks_decal.uv).xyz, 127.5))),
        m_bricks_decal));
    float m_bricks_falloff = sg_decal_falloff_cone(m_bricks_decal.local, 0.15);
    vec3 m_bricks = sg_surfgrad_from_volume(m_base_normal, m_bricks_falloff * m_bricks_gradient);

    vec3 m_gradient = sg_combine_mix(
        m_grain_gradient + m_chart_gradient + m_pebbles_gradient + m_dent_gradient + m_wedge_gradient,
        m_bricks_gradient, m_bricks_falloff);

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    // gradient
    sg_shown = sg_stage_select(sg_shown, 4.0, sg_surfgrad_from_volume(m_base_normal, m_gradient));
    sg_shown = sg_stage_select(sg_shown, 5.0, sg_resolve_volume(m_base_normal, m_gradient));  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_grain);  // layer:grain
    sg_shown = sg_stage_select(sg_shown, 7.0, m_chart);  // layer:chart
    sg_shown = sg_stage_select(sg_shown, 8.0, m_pebbles);  // layer:pebbles
    sg_shown = sg_stage_select(sg_shown, 9.0, m_dent);  // layer:dent
    sg_shown = sg_stage_select(sg_shown, 10.0, m_wedge);  // layer:wedge
    sg_shown = sg_stage_select(sg_shown, 11.0, m_bricks);  // layer:bricks
    sg_shown = sg_stage_select(sg_shown, 12.0, m_object.p);  // object-position
    sg_shown = sg_stage_select(sg_shown, 13.0, m_object.dx);  // object-position-dx
    sg_shown = sg_stage_select(sg_shown, 14.0, m_object.dy);  // object-position-dy
    sg_shown = sg_stage_select(sg_shown, 15.0, m_world.p);  // world-position
    sg_shown = sg_stage_select(sg_shown, 16.0, m_world.dx);  // world-position-dx
    sg_shown = sg_stage_select(sg_shown, 17.0, m_world.dy);  // world-position-dy
    sg_out_value = sg_shown;
}

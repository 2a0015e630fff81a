#version 450
#extension GL_GOOGLE_include_directive : require
// brick wall, four steps: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "stage/view.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/parallax.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/sample.glsl"
#include "surfgrad/tbn.glsl"

layout(set = 1, binding = 1) uniform texture2D t_brick;
layout(set = 1, binding = 2) uniform texture2D t_planes;
layout(set = 1, binding = 3) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_value;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    SgNormalDerivatives m_normal_derivatives = sg_stage_normal_derivatives(sg_in_normal);

    // parallax: steps
    vec2 m_parallax_offset = sg_parallax_steps(
        t_planes, s_0, vec2(2.007874, -1.007874), m_uv0,
        0.005 * sg_parallax_direction(m_frame, m_uv0, sg_stage_view(sg_in_position)).xy, 4);
    SgUv m_parallax_seen_uv = sg_parallax_uv(m_uv0, m_parallax_offset);
    vec2 m_parallax_pixels = sg_parallax_pixels(m_uv0, m_parallax_offset);
    vec3 m_parallax_moved_normal = sg_parallax_normal(m_base_normal, m_normal_derivatives.dndx,
                                                      m_normal_derivatives.dndy, m_parallax_pixels);

    // bricks: normal_map
    vec3 m_bricks = sg_surfgrad_from_tbn(
        sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_sample(t_brick, s_0, m_parallax_seen_uv).xyz, 127.5))),
        sg_basis_uv(sg_frame_resolved(m_frame, m_parallax_moved_normal), m_parallax_seen_uv));

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_bricks);  // gradient
    sg_shown = sg_stage_select(sg_shown, 5.0, sg_resolve(m_parallax_moved_normal, m_bricks));  // normal
    sg_shown = sg_stage_select(sg_shown, 6.0, m_bricks);  // layer:bricks
    sg_shown = sg_stage_select(sg_shown, 7.0, vec3(m_uv0.st, 0.0));  // uv0
    sg_shown = sg_stage_select(sg_shown, 8.0, vec4(m_uv0.dx, m_uv0.dy));  // uv0-derivatives
    sg_shown = sg_stage_select(sg_shown, 9.0, m_normal_derivatives.dndx);  // base-normal-dx
    sg_shown = sg_stage_select(sg_shown, 10.0, m_normal_derivatives.dndy);  // base-normal-dy
    // moved-position
    sg_shown = sg_stage_select(
        sg_shown, 11.0,
        sg_parallax_position(
            m_frame, m_parallax_pixels,
            sg_parallax_height(t_planes, s_0, vec2(0.040157482, -0.02015748), m_parallax_seen_uv.st,
                               sg_uv_level(m_parallax_seen_uv, sg_texture_size(t_planes, s_0)))));
    sg_shown = sg_stage_select(sg_shown, 12.0, vec3(m_parallax_seen_uv.st, 0.0));  // moved-uv0
    sg_out_value = sg_shown;
}

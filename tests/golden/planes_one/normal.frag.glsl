#version 450
#extension GL_GOOGLE_include_directive : require
// pebbles, one step: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "stage/view.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/parallax.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/sample.glsl"
#include "surfgrad/tbn.glsl"

layout(set = 1, binding = 1) uniform texture2D t_planes;
layout(set = 1, binding = 2) uniform texture2D t_pebble;
layout(set = 1, binding = 4) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    SgNormalDerivatives m_normal_derivatives = sg_stage_normal_derivatives(sg_in_normal);

    // parallax: steps
    vec2 m_parallax_offset = sg_parallax_steps(
        t_planes, s_0, vec2(2.007874, -1.007874), m_uv0,
        0.04 * sg_parallax_direction(m_frame, m_uv0, sg_stage_view(sg_in_position)).xy, 1);
    SgUv m_parallax_seen_uv = sg_parallax_uv(m_uv0, m_parallax_offset);
    vec3 m_parallax_moved_normal = sg_parallax_normal(m_base_normal, m_normal_derivatives.dndx,
                                                      m_normal_derivatives.dndy,
                                                      sg_parallax_pixels(m_uv0, m_parallax_offset));

    // stones: normal_map
    vec3 m_stones = sg_surfgrad_from_tbn(
        sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_sample(t_pebble, s_0, m_parallax_seen_uv).xyz, 127.0))),
        sg_basis_uv(sg_frame_resolved(m_frame, m_parallax_moved_normal), m_parallax_seen_uv));

    sg_out_normal = vec4(sg_resolve(m_parallax_moved_normal, m_stones), 1.0);
}

#version 450
#extension GL_GOOGLE_include_directive : require
// bricks that wear to cloth: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 1) uniform texture2D t_brick;
layout(set = 1, binding = 2) uniform texture2D t_weave;
layout(set = 1, binding = 3) uniform texture2D t_patches;
layout(set = 1, binding = 4) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    float m_worn = sg_stage_sample(t_patches, s_0, sg_uv_scale(m_uv0, vec2(3.0, 2.0))).x;
    float m_left = 1.0 - m_worn;

    // wall: normal_blend
    vec3 m_wall =
        sg_surfgrad_from_tbn(
            m_left * sg_deriv_green_up(sg_deriv_from_normal_xyz(sg_decode_signed(
                sg_stage_sample(t_brick, s_0, sg_uv_scale(m_uv0, vec2(6.0, 4.0))).xyz, 127.5))),
            sg_basis_vertex(sg_in_normal, sg_in_tangent)) +
        sg_surfgrad_from_tbn(
            m_worn * sg_deriv_from_normal_xyz(sg_decode_signed(
                sg_stage_sample(t_weave, s_0, sg_uv_scale(m_uv0, vec2(12.0, 8.0))).xyz, 128.0)),
            sg_basis_uv(sg_stage_frame(sg_in_position, m_base_normal), m_uv0));

    sg_out_normal = vec4(sg_resolve(m_base_normal, m_wall), 1.0);
}

#version 450
#extension GL_GOOGLE_include_directive : require
// brick wall: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"

layout(set = 1, binding = 1) uniform texture2D t_brick;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);

    // bricks: normal_map
    vec3 m_bricks = sg_surfgrad_from_tbn(
        sg_deriv_green_up(
            sg_deriv_from_normal_xyz(sg_decode_signed(sg_stage_sample(t_brick, s_0, m_uv0).xyz, 127.5))),
        sg_basis_uv(sg_stage_frame(sg_in_position, m_base_normal), m_uv0));

    sg_out_normal = vec4(sg_resolve(m_base_normal, m_bricks), 1.0);
}

#version 450
#extension GL_GOOGLE_include_directive : require
// blob: fragment shader of the entry point 'debug', made by surfgradc.

#include "stage/debug.glsl"
#include "stage/fragment.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 1) uniform texture2D t_pebble;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_value;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    SgFrame m_frame = sg_stage_frame(sg_in_position, sg_base_normal(sg_in_normal));
    SgBasis m_basis_vertex = sg_basis_vertex(sg_in_normal, sg_in_tangent);

    // skin: normal_map
    vec3 m_skin_m = sg_decode_signed(sg_stage_sample(t_pebble, s_0, sg_uv_scale(m_uv0, vec2(4.0, 2.0))).xyz,
                                     127.5);
    vec3 m_skin = sg_surfgrad_from_tbn(sg_deriv_green_up(sg_deriv_from_normal_xyz(m_skin_m)), m_basis_vertex);

    vec4 sg_shown = vec4(0.0, 0.0, 0.0, 1.0);
    sg_shown = sg_stage_select(sg_shown, 0.0, m_frame.position);  // position
    sg_shown = sg_stage_select(sg_shown, 1.0, m_frame.normal);  // base-normal
    sg_shown = sg_stage_select(sg_shown, 2.0, m_frame.dpdx);  // dpdx
    sg_shown = sg_stage_select(sg_shown, 3.0, m_frame.dpdy);  // dpdy
    sg_shown = sg_stage_select(sg_shown, 4.0, m_skin);  // gradient
    // normal
    sg_shown = sg_stage_select(
        sg_shown, 5.0, sg_resolve_vertex_map(sg_in_normal, sg_in_tangent, 1.0, m_skin_m, vec2(1.0, -1.0)));
    sg_shown = sg_stage_select(sg_shown, 6.0, m_skin);  // layer:skin
    sg_shown = sg_stage_select(sg_shown, 7.0, m_basis_vertex.tangent);  // tangent
    sg_shown = sg_stage_select(sg_shown, 8.0, m_basis_vertex.bitangent);  // bitangent
    sg_shown = sg_stage_select(sg_shown, 9.0, vec3(m_uv0.st, 0.0));  // uv0
    sg_shown = sg_stage_select(sg_shown, 10.0, vec4(m_uv0.dx, m_uv0.dy));  // uv0-derivatives
    sg_out_value = sg_shown;
}

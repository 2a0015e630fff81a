#version 450
#extension GL_GOOGLE_include_directive : require
// woven cloth: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 1) uniform texture2D t_weave;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);

    // layer 1: derivative_map
    SgUv m_layer_1_uv = sg_uv_transform(sg_stage_uv(sg_in_uv0), vec2(8.0, 4.0), 0.5235988, vec2(0.0));
    vec3 m_layer_1 = sg_surfgrad_from_tbn(
        sg_deriv_from_map(sg_decode_signed(sg_stage_sample(t_weave, s_0, m_layer_1_uv).xy, 127.5), 4.0),
        sg_basis_uv(sg_stage_frame(sg_in_position, m_base_normal), m_layer_1_uv));

    sg_out_normal = vec4(sg_resolve(m_base_normal, m_layer_1), 1.0);
}

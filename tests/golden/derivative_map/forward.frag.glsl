#version 450
#extension GL_GOOGLE_include_directive : require
// woven cloth: fragment shader of the entry point 'forward', made by surfgradc.

#include "lighting/ggx.glsl"
#include "stage/forward.glsl"
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
layout(location = 0) out vec4 sg_out_color;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);

    // layer 1: derivative_map
    SgUv m_layer_1_uv = sg_uv_transform(sg_stage_uv(sg_in_uv0), vec2(8.0, 4.0), 0.5235988, vec2(0.0));
    vec3 m_layer_1 = sg_surfgrad_from_tbn(
        sg_deriv_from_map(sg_decode_signed(sg_stage_sample(t_weave, s_0, m_layer_1_uv).xy, 127.5), 4.0),
        sg_basis_uv(sg_stage_frame(sg_in_position, m_base_normal), m_layer_1_uv));

    SgGgxSurface sg_surface;
    sg_surface.base_color = vec3(0.2, 0.25, 0.5);
    sg_surface.metallic = 0.0;
    sg_surface.roughness = 0.85;
    sg_surface.occlusion = 1.0;
    sg_surface.emission = vec3(0.0);
    sg_out_color = vec4(
        sg_ggx_radiance(sg_surface, sg_resolve(m_base_normal, m_layer_1), sg_stage_lights(sg_in_position)),
        1.0);
}

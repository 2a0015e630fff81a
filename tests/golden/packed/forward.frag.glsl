#version 450
#extension GL_GOOGLE_include_directive : require
// four things in one texture: fragment shader of the entry point 'forward', made by surfgradc.

#include "lighting/ggx.glsl"
#include "stage/forward.glsl"
#include "stage/fragment.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 1) uniform texture2D t_weave;
layout(set = 1, binding = 2) uniform texture2D t_paint;
layout(set = 1, binding = 3) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_color;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);

    // weave: normal_map
    SgUv m_weave_uv = sg_uv_scale(m_uv0, vec2(6.0, 3.0));
    vec3 m_weave = sg_surfgrad_from_tbn(
        0.7 * sg_deriv_from_normal_xy(sg_decode_signed(sg_stage_sample(t_weave, s_0, m_weave_uv).wy, 127.5)),
        sg_basis_uv(sg_stage_frame(sg_in_position, m_base_normal), m_uv0));

    vec4 m_paint_texel = sg_stage_sample(t_paint, s_0, m_weave_uv);
    vec3 m_thread = mix(vec3(0.1, 0.07, 0.05), vec3(0.55, 0.42, 0.3), m_paint_texel.z);
    float m_painted = m_paint_texel.x;

    SgGgxSurface sg_surface;
    sg_surface.base_color = mix(m_thread, vec3(0.08, 0.2, 0.45), m_painted);
    sg_surface.metallic = 0.0;
    sg_surface.roughness = m_painted * -0.5 + 0.85;
    sg_surface.occlusion = 1.0;
    sg_surface.emission = vec3(0.0);
    sg_out_color = vec4(
        sg_ggx_radiance(sg_surface, sg_resolve(m_base_normal, m_weave), sg_stage_lights(sg_in_position)),
        1.0);
}

#version 450
#extension GL_GOOGLE_include_directive : require
// workshop phong: fragment shader of the entry point 'forward', made by surfgradc.

#include "lighting/phong.glsl"
#include "stage/forward.glsl"
#include "stage/fragment.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/resolve.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    vec3 p_specular_intensity;
    float p_specular_power;
    float d_power;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_color_map;
layout(set = 1, binding = 2) uniform texture2D t_normal_map;
layout(set = 1, binding = 3) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_color;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);

    // bump_normal: normal_map
    vec3 m_bump_normal = sg_decode_signed(sg_stage_sample(t_normal_map, s_0, m_uv0).xyz, 127.5);

    vec3 m_color = sg_stage_sample(t_color_map, s_0, m_uv0).rgb;

    SgPhongSurface sg_surface;
    sg_surface.base_color = m_color;
    sg_surface.specular = m_color * sg_material.p_specular_intensity;
    sg_surface.shininess = sg_material.p_specular_power;
    sg_surface.occlusion = 1.0;
    sg_surface.emission = vec3(0.0);
    sg_out_color = vec4(
        sg_phong_radiance(
            sg_surface,
            sg_resolve_vertex_map(sg_in_normal, sg_in_tangent, 1.0, m_bump_normal, vec2(1.0, -1.0)),
            sg_stage_lights(sg_in_position)),
        1.0);
}

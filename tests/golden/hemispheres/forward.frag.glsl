#version 450
#extension GL_GOOGLE_include_directive : require
// hemispheres: fragment shader of the entry point 'forward', made by surfgradc.

#include "lighting/ggx.glsl"
#include "stage/forward.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/triplanar.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    float p_tiling;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_dome;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_color;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);

    // domes: triplanar
    SgTriplanarUv m_domes_planes = sg_volume_triplanar_uv(
        sg_volume_scale(sg_stage_volume(sg_in_object_position), sg_material.p_tiling), SG_RIGHT_HAND,
        SG_UPPER_LEFT);
    vec3 m_domes = sg_stage_gradient_from_object(sg_triplanar_gradient(
        sg_triplanar_weights(sg_stage_object_normal(m_base_normal), 4.0),
        sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_dome, s_0, m_domes_planes.x).xyz, 127.5))),
        sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_dome, s_0, m_domes_planes.y).xyz, 127.5))),
        sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_dome, s_0, m_domes_planes.z).xyz, 127.5))),
        SG_RIGHT_HAND, SG_UPPER_LEFT));

    SgGgxSurface sg_surface;
    sg_surface.base_color = vec3(0.5, 0.53, 0.58);
    sg_surface.metallic = 0.6;
    sg_surface.roughness = 0.4;
    sg_surface.occlusion = 1.0;
    sg_surface.emission = vec3(0.0);
    sg_out_color = vec4(
        sg_ggx_radiance(sg_surface, sg_resolve_volume(m_base_normal, m_domes),
                        sg_stage_lights(sg_in_position)),
        1.0);
}

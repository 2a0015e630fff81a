#version 450
#extension GL_GOOGLE_include_directive : require
// leaf: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/height_map.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    vec3 p_glow;
    float p_eaten;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_veins;
layout(set = 1, binding = 2) uniform texture2D t_holes;
layout(set = 1, binding = 4) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    SgVolume m_object = sg_stage_volume(sg_in_object_position);

    // veins: height_map
    SgUv m_veins_uv = sg_uv_scale(m_uv0, vec2(3.0, 2.0));
    vec3 m_veins = sg_surfgrad_from_height(m_frame, m_veins_uv, sg_texture_size(t_veins, s_0),
                                           0.12 * sg_deriv_from_height_hq(t_veins, s_0, m_veins_uv));

    float m_vein = sg_stage_sample(t_veins, s_0, m_veins_uv).x;

    // blisters: noise
    vec3 m_blisters = sg_surfgrad_from_volume(
        m_base_normal,
        sg_stage_gradient_from_object(clamp(1.0 - m_vein, 0.0, 1.0) * 0.14 *
            sg_volume_fractal_sum(sg_volume_scale(m_object, 7.0), 3).gradient));

    float m_hole = sg_stage_sample(t_holes, s_0, sg_uv_scale(m_uv0, vec2(4.0, 3.0))).x;

    if (1.0 - m_hole * sg_material.p_eaten < 0.58) discard;

    sg_out_normal = vec4(sg_flip(sg_resolve(m_base_normal, m_veins + m_blisters), sg_stage_facing()), 1.0);
}

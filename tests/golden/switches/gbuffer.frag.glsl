#version 450
#extension GL_GOOGLE_include_directive : require
// painted bricks: fragment shader of the entry point 'gbuffer', made by surfgradc.

#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/number.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    float p_painted;
    float p_repeats;
    float p_depth;
    vec3 p_paint;
    float d_cracks_multiply;
    float d_roughness;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_bumps;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_base_color;
layout(location = 1) out vec4 sg_out_normal;
layout(location = 2) out vec4 sg_out_surface;
layout(location = 3) out vec4 sg_out_emission;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    SgVolume m_object = sg_stage_volume(sg_in_object_position);

    // bumps: normal_map
    vec3 m_bumps = sg_surfgrad_from_tbn(
        sg_material.p_depth * sg_deriv_green_up(sg_deriv_from_normal_xyz(sg_decode_signed(
            sg_stage_sample(t_bumps, s_0, sg_uv_scale(m_uv0, vec2(sg_material.p_repeats))).xyz, 127.5))),
        sg_basis_uv(sg_stage_frame(sg_in_position, m_base_normal), m_uv0));

    // cracks: noise
    vec3 m_cracks = sg_surfgrad_from_volume(
        m_base_normal,
        sg_stage_gradient_from_object(sg_material.d_cracks_multiply *
            sg_volume_turbulence(sg_volume_scale(m_object, 6.0), 4).gradient));

    float m_grain = sg_smoothstep(-0.2, 0.35, sg_volume_fractal_sum(sg_volume_scale(m_object, 9.0), 4).value);
    vec3 m_clay = mix(vec3(0.35, 0.14, 0.08), vec3(0.55, 0.25, 0.15), m_grain);

    sg_out_base_color = vec4(mix(m_clay, sg_material.p_paint, sg_material.p_painted), 1.0);
    sg_out_normal = vec4(sg_resolve(m_base_normal, m_bumps + m_cracks), sg_material.d_roughness);
    sg_out_surface = vec4(0.0, 1.0, 0.0, 1.0);
    sg_out_emission = vec4(vec3(0.0), 1.0);
}

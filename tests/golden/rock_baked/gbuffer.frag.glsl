#version 450
#extension GL_GOOGLE_include_directive : require
// rock, baked map first: fragment shader of the entry point 'gbuffer', made by surfgradc.

#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/triplanar.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 1) uniform texture2D t_pebble;
layout(set = 1, binding = 2) uniform texture2D t_stones;
layout(set = 1, binding = 3) uniform sampler s_0;

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

    // stones: normal_map
    SgUv m_stones_uv = sg_uv_scale(sg_stage_uv(sg_in_uv0), vec2(4.0, 3.0));
    vec3 m_stones = sg_surfgrad_from_height(
        sg_stage_frame(sg_in_position, m_base_normal),
        m_stones_uv,
        sg_texture_size(t_stones, s_0),
        0.006 * sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_stones, s_0, m_stones_uv).xyz, 127.0))));

    vec3 m_normal = sg_resolve(m_base_normal, m_stones);

    // gravel: triplanar
    SgTriplanarUv m_gravel_planes = sg_volume_triplanar_uv(
        sg_volume_scale(sg_stage_volume(sg_in_object_position), 6.0), SG_RIGHT_HAND, SG_UPPER_LEFT);
    vec3 m_gravel = 0.8 * sg_stage_gradient_from_object(sg_triplanar_gradient(
        sg_triplanar_weights(sg_stage_object_normal(m_normal), 3.0),
        sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_gravel_planes.x).xyz, 127.0))),
        sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_gravel_planes.y).xyz, 127.0))),
        sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_pebble, s_0, m_gravel_planes.z).xyz, 127.0))),
        SG_RIGHT_HAND, SG_UPPER_LEFT));

    sg_out_base_color = vec4(vec3(0.45, 0.45, 0.43), 1.0);
    sg_out_normal = vec4(sg_resolve_volume(m_normal, m_gravel), 0.7);
    sg_out_surface = vec4(0.0, 1.0, 0.0, 1.0);
    sg_out_emission = vec4(vec3(0.0), 1.0);
}

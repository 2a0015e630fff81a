#version 450
#extension GL_GOOGLE_include_directive : require
// rain on stone: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "stage/world.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/number.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/triplanar.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 1) uniform texture2D t_pebble;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    float m_top = sg_smoothstep(0.2, 0.8, dot(m_base_normal, vec3(0.0, 1.0, 0.0)));

    // rain: planar
    vec2 m_rain_deriv = sg_deriv_green_up(sg_deriv_from_normal_xyz(sg_decode_signed(
        sg_stage_sample(
            t_pebble, s_0,
            sg_volume_triplanar_uv(sg_volume_scale(sg_stage_volume_in_world(sg_in_position), 1.5),
                                   SG_RIGHT_HAND, SG_UPPER_LEFT).y).xyz,
        127.0)));
    vec3 m_rain = m_top * sg_triplanar_gradient(sg_axis_y(), m_rain_deriv, m_rain_deriv, m_rain_deriv,
                                                SG_RIGHT_HAND, SG_UPPER_LEFT);

    sg_out_normal = vec4(sg_resolve_volume(m_base_normal, m_rain), 1.0);
}

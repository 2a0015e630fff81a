#version 450
#extension GL_GOOGLE_include_directive : require
// weathered globe: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "stage/world.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_normal.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/number.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/triplanar.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"

// shaders/cloth.glsl
// A function that materials/weathered_globe.json calls as a layer: it is handed all that a function may be.
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/sample.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/volume.glsl"

// A surface gradient: the slopes of a map (green down, 128 means 0) along the vertex tangents, where the coordinate
// lies in a window, from window.xy to window.zw, and the places within reach: from the camera, from the middle of
// the object, from the middle of the world. A vertex whose alpha is below 0, or a time before `start`, hides it.
vec3 c_cloth(SgFrame frame, vec3 normal, SgBasis tangents, vec3 position, SgVolume object,
           SgVolume world, vec4 color, float time, float facing, texture2D map, sampler map_sampler,
           SgUv uv, vec4 window, vec3 reach, float start) {
    vec2 slopes = sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(map, map_sampler, uv).xyz, 128.0));
    bool in_window = all(greaterThanEqual(uv.st, window.xy)) && all(lessThanEqual(uv.st, window.zw));
    vec3 far = vec3(length(position), length(object.p), length(world.p));
    bool in_reach = all(lessThanEqual(far, reach));
    bool outside = facing * dot(normal, frame.normal) > 0.0;
    bool shown = in_window && in_reach && outside && color.a >= 0.0 && time >= start;
    return shown ? sg_surfgrad_from_tbn(slopes, tangents) : vec3(0.0);
}

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    vec3 p_tint;
    vec4 p_window;
} sg_material;
layout(set = 1, binding = 1) uniform texture2D t_globe;
layout(set = 1, binding = 2) uniform texture2D t_pebble;
layout(set = 1, binding = 3) uniform texture2D t_scratch;
layout(set = 1, binding = 4) uniform texture2D t_weave;
layout(set = 1, binding = 7) uniform sampler s_0;
layout(set = 1, binding = 8) uniform sampler s_1;
layout(set = 1, binding = 9) uniform sampler s_2;
layout(set = 1, binding = 10) uniform sampler s_3;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 3) in vec4 sg_in_color;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    SgVolume m_object = sg_stage_volume(sg_in_object_position);
    SgVolume m_world = sg_stage_volume_in_world(sg_in_position);

    // relief: object_normal_map
    vec3 m_relief = 0.3 * sg_surfgrad_from_normal(
        m_base_normal, sg_decode_signed(sg_stage_sample(t_globe, s_0, m_uv0).xyz, 127.5));

    float m_top = sg_power(max(0.0, dot(m_base_normal, vec3(0.0, 1.0, 0.0))), 1.5);
    float m_worn = clamp(0.35 + min(m_top, 0.5), 0.2, 0.75);

    // rough: triplanar
    SgTriplanarUv m_rough_planes = sg_volume_triplanar_uv(sg_volume_scale(m_object, 1.5), SG_RIGHT_HAND,
                                                          SG_UPPER_LEFT);
    vec3 m_rough = m_worn * 0.25 * sg_stage_gradient_from_object(sg_triplanar_gradient(
        sg_triplanar_weights(sg_stage_object_normal(m_base_normal), 3.0),
        sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_weave, s_3, m_rough_planes.x).xyz, 128.0)),
        sg_deriv_green_up(sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_stage_sample(t_pebble, s_1, m_rough_planes.y).xyz, 127.0))),
        sg_deriv_from_normal_xy(
            sg_decode_signed(sg_stage_sample(t_scratch, s_2, m_rough_planes.z).xy, 127.5)),
        SG_RIGHT_HAND, SG_UPPER_LEFT));

    // rain: planar
    vec2 m_rain_deriv = sg_deriv_from_normal_xy(sg_decode_signed(
        sg_stage_sample(
            t_scratch, s_2,
            sg_volume_triplanar_uv(sg_volume_scale(m_object, 0.7), SG_RIGHT_HAND, SG_UPPER_LEFT).x).xy,
        127.5));
    vec3 m_rain = 0.3 * sg_stage_gradient_from_object(sg_triplanar_gradient(
        sg_axis_x(), m_rain_deriv, m_rain_deriv, m_rain_deriv, SG_RIGHT_HAND, SG_UPPER_LEFT));

    // wind: planar
    vec2 m_wind_deriv = sg_deriv_from_normal_xy(sg_decode_signed(
        sg_stage_sample(
            t_scratch, s_2,
            sg_volume_triplanar_uv(sg_volume_scale(m_world, 0.9), SG_RIGHT_HAND, SG_UPPER_LEFT).z).xy,
        127.5));
    vec3 m_wind = 0.3 * sg_triplanar_gradient(sg_axis_z(), m_wind_deriv, m_wind_deriv, m_wind_deriv,
                                              SG_RIGHT_HAND, SG_UPPER_LEFT);

    // cloth: custom
    vec3 m_cloth = 0.1 * c_cloth(sg_stage_frame(sg_in_position, m_base_normal), m_base_normal,
                                 sg_basis_vertex(sg_in_normal, sg_in_tangent), sg_in_position, m_object,
                                 m_world, sg_in_color, sg_stage_time(), sg_stage_facing(), t_weave, s_3,
                                 sg_uv_scale(m_uv0, vec2(8.0, 4.0)), sg_material.p_window, vec3(1000.0), 0.0);

    sg_out_normal = vec4(
        sg_resolve(m_base_normal,
                   m_relief + sg_surfgrad_from_volume(m_base_normal, m_rough + m_rain + m_wind) + m_cloth),
        1.0);
}

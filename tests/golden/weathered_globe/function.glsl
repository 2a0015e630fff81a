// weathered globe: the material as a function, made by surfgradc.
// It takes no derivatives and reads nothing but its arguments, so it may be called anywhere.
// Of SgMaterialInputs it reads these; the others need no value:
//   position           relative world space (origin at the camera), world units
//   position_dx        its change per pixel to the right
//   position_dy        its change per pixel downward
//   normal             interpolated vertex normal, world axes, any length
//   tangent            interpolated vertex tangent: xyz world axes; w * cross(normal, tangent) points to +t
//   color              interpolated vertex colour, linear
//   facing             +1 on front faces, -1 on back faces
//   time               seconds
//   object_position    object space, object units
//   object_position_dx its change per pixel to the right
//   object_position_dy its change per pixel downward
//   world_position     absolute world space, world units
//   world_position_dx  its change per pixel to the right
//   world_position_dy  its change per pixel downward
//   object_x           the object's x axis in world axes: a unit of object space, world units
//   object_y           the object's y axis in world axes: a unit of object space, world units
//   object_z           the object's z axis in world axes: a unit of object space, world units
//   uv0                texture coordinate 0, t downward
//   uv0_dx             its change per pixel to the right
//   uv0_dy             its change per pixel downward
#include "function/spaces.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_normal.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/number.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/sample.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/triplanar.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"
#include "surfgrad/volume_space.glsl"

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
vec3 c_cloth_weathered_globe(SgFrame frame, vec3 normal, SgBasis tangents, vec3 position, SgVolume object,
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

#ifndef SG_MATERIAL_TYPES
#define SG_MATERIAL_TYPES

struct SgMaterialInputs {
    vec3 position;            // relative world space (origin at the camera), world units
    vec3 position_dx;         // its change per pixel to the right
    vec3 position_dy;         // its change per pixel downward
    vec3 normal;              // interpolated vertex normal, world axes, any length
    vec4 tangent;             // interpolated vertex tangent: xyz world axes; w * cross(normal, tangent) points to +t
    vec4 color;               // interpolated vertex colour, linear
    float facing;             // +1 on front faces, -1 on back faces
    float time;               // seconds
    vec3 object_position;     // object space, object units
    vec3 object_position_dx;  // its change per pixel to the right
    vec3 object_position_dy;  // its change per pixel downward
    vec3 world_position;      // absolute world space, world units
    vec3 world_position_dx;   // its change per pixel to the right
    vec3 world_position_dy;   // its change per pixel downward
    vec3 object_x;            // the object's x axis in world axes: a unit of object space, world units
    vec3 object_y;            // the object's y axis in world axes: a unit of object space, world units
    vec3 object_z;            // the object's z axis in world axes: a unit of object space, world units
    vec3 object_origin;       // the object's origin, relative world space
    vec3 base_normal_dx;      // change of the unit vertex normal per pixel to the right
    vec3 base_normal_dy;      // its change per pixel downward
    vec3 camera_position;     // absolute world space
    vec4 to_viewer;           // of a perspective 0, 0, 0, 1; else the unit direction to the viewer, world axes, and 0
    vec4 screen_x;            // first column of the matrix (x px, y px, depth, 1) -> homogeneous relative world space
    vec4 screen_y;            // its second column
    vec4 clip_w;              // last row of the matrix from relative world space to clip space
    vec2 uv0;                 // texture coordinate 0, t downward
    vec2 uv0_dx;              // its change per pixel to the right
    vec2 uv0_dy;              // its change per pixel downward
    vec2 uv1;                 // texture coordinate 1, t downward
    vec2 uv1_dx;              // its change per pixel to the right
    vec2 uv1_dy;              // its change per pixel downward
    vec2 uv2;                 // texture coordinate 2, t downward
    vec2 uv2_dx;              // its change per pixel to the right
    vec2 uv2_dy;              // its change per pixel downward
    vec2 uv3;                 // texture coordinate 3, t downward
    vec2 uv3_dx;              // its change per pixel to the right
    vec2 uv3_dy;              // its change per pixel downward
    vec2 uv4;                 // texture coordinate 4, t downward
    vec2 uv4_dx;              // its change per pixel to the right
    vec2 uv4_dy;              // its change per pixel downward
    vec2 uv5;                 // texture coordinate 5, t downward
    vec2 uv5_dx;              // its change per pixel to the right
    vec2 uv5_dy;              // its change per pixel downward
    vec2 uv6;                 // texture coordinate 6, t downward
    vec2 uv6_dx;              // its change per pixel to the right
    vec2 uv6_dy;              // its change per pixel downward
    vec2 uv7;                 // texture coordinate 7, t downward
    vec2 uv7_dx;              // its change per pixel to the right
    vec2 uv7_dy;              // its change per pixel downward
};

struct SgMaterialResult {
    vec3 normal;              // resolved unit normal, world axes
    vec3 base_color;          // linear
    float metallic;           // 0 to 1
    float roughness;          // 0 to 1, perceptual: squared it is GGX's alpha
    float occlusion;          // 1: open
    vec3 emission;            // linear radiance
    float opacity;            // 0 to 1
    float cutoff;             // alpha test: drop the pixel where opacity is less; 0 without one
};

#endif

struct SgMaterialParameters_weathered_globe {
    vec3 p_tint;
    vec4 p_window;
};

SgMaterialResult sg_material_weathered_globe(SgMaterialInputs sg_inputs,
                                             SgMaterialParameters_weathered_globe sg_material,
                                             texture2D t_globe, texture2D t_pebble, texture2D t_scratch,
                                             texture2D t_weave, texture2D t_stone, texture2D t_moss,
                                             sampler s_0, sampler s_1, sampler s_2, sampler s_3, sampler s_4,
                                             sampler s_5) {
    vec3 m_base_normal = sg_base_normal(sg_inputs.normal);
    SgUv m_uv0 = SgUv(sg_inputs.uv0, sg_inputs.uv0_dx, sg_inputs.uv0_dy);
    SgVolume m_object = SgVolume(sg_inputs.object_position, sg_inputs.object_position_dx,
                                 sg_inputs.object_position_dy);
    SgVolume m_world = SgVolume(sg_inputs.world_position, sg_inputs.world_position_dx,
                                sg_inputs.world_position_dy);

    // relief: object_normal_map
    vec3 m_relief = 0.3 *
        sg_surfgrad_from_normal(m_base_normal, sg_decode_signed(sg_sample(t_globe, s_0, m_uv0).xyz, 127.5));

    float m_top = sg_power(max(0.0, dot(m_base_normal, vec3(0.0, 1.0, 0.0))), 1.5);
    float m_worn = clamp(0.35 + min(m_top, 0.5), 0.2, 0.75);

    // rough: triplanar
    SgTriplanarUv m_rough_planes = sg_volume_triplanar_uv(sg_volume_scale(m_object, 1.5), SG_RIGHT_HAND,
                                                          SG_UPPER_LEFT);
    vec3 m_rough = m_worn * 0.25 * sg_gradient_to_world(
        mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z),
        sg_triplanar_gradient(
            sg_triplanar_weights(
                sg_function_object_normal(mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z),
                                          m_base_normal),
                3.0),
            sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_weave, s_3, m_rough_planes.x).xyz, 128.0)),
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_sample(t_pebble, s_1, m_rough_planes.y).xyz, 127.0))),
            sg_deriv_from_normal_xy(sg_decode_signed(sg_sample(t_scratch, s_2, m_rough_planes.z).xy, 127.5)),
            SG_RIGHT_HAND, SG_UPPER_LEFT));

    // rain: planar
    vec2 m_rain_deriv = sg_deriv_from_normal_xy(sg_decode_signed(
        sg_sample(t_scratch, s_2,
                  sg_volume_triplanar_uv(sg_volume_scale(m_object, 0.7), SG_RIGHT_HAND, SG_UPPER_LEFT).x).xy,
        127.5));
    vec3 m_rain = 0.3 * sg_gradient_to_world(
        mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z),
        sg_triplanar_gradient(sg_axis_x(), m_rain_deriv, m_rain_deriv, m_rain_deriv, SG_RIGHT_HAND,
                              SG_UPPER_LEFT));

    // wind: planar
    vec2 m_wind_deriv = sg_deriv_from_normal_xy(sg_decode_signed(
        sg_sample(t_scratch, s_2,
                  sg_volume_triplanar_uv(sg_volume_scale(m_world, 0.9), SG_RIGHT_HAND, SG_UPPER_LEFT).z).xy,
        127.5));
    vec3 m_wind = 0.3 * sg_triplanar_gradient(sg_axis_z(), m_wind_deriv, m_wind_deriv, m_wind_deriv,
                                              SG_RIGHT_HAND, SG_UPPER_LEFT);

    // cloth: custom
    vec3 m_cloth = 0.1 * c_cloth_weathered_globe(
        sg_frame(sg_inputs.position, sg_inputs.position_dx, sg_inputs.position_dy, m_base_normal),
        m_base_normal, sg_basis_vertex(sg_inputs.normal, sg_inputs.tangent), sg_inputs.position, m_object,
        m_world, sg_inputs.color, sg_inputs.time, sg_inputs.facing, t_weave, s_3,
        sg_uv_scale(m_uv0, vec2(8.0, 4.0)), sg_material.p_window, vec3(1000.0), 0.0);

    vec3 m_paint = sg_sample(t_stone, s_4, sg_uv_transform(m_uv0, vec2(0.05), 0.0, vec2(0.23, 0.41))).rgb;
    float m_far = sg_smoothstep(2.0, 12.0, length(sg_inputs.position));
    float m_shade = sg_divide(1.0, 1.0 + m_far);

    return SgMaterialResult(
        sg_resolve(m_base_normal,
                   m_relief + sg_surfgrad_from_volume(m_base_normal, m_rough + m_rain + m_wind) + m_cloth),
        sg_material.p_tint * sg_inputs.color.rgb + mix(m_paint, vec3(0.3, 0.13, 0.05), m_worn),
        0.0, 0.7,
        clamp(max(m_shade, sg_sample(t_moss, s_5, sg_uv_transform(m_uv0, vec2(1.0), 0.0, vec2(0.1))).x), 0.0,
              1.0),
        vec3(0.0),
        1.0, 0.0);
}

// mossy rock: the material as a function, made by surfgradc.
// It takes no derivatives and reads nothing but its arguments, so it may be called anywhere.
// Of SgMaterialInputs it reads these; the others need no value:
//   position           relative world space (origin at the camera), world units
//   position_dx        its change per pixel to the right
//   position_dy        its change per pixel downward
//   normal             interpolated vertex normal, world axes, any length
//   tangent            interpolated vertex tangent: xyz world axes; w * cross(normal, tangent) points to +t
//   facing             +1 on front faces, -1 on back faces
//   object_position    object space, object units
//   object_position_dx its change per pixel to the right
//   object_position_dy its change per pixel downward
//   object_x           the object's x axis in world axes: a unit of object space, world units
//   object_y           the object's y axis in world axes: a unit of object space, world units
//   object_z           the object's z axis in world axes: a unit of object space, world units
//   uv0                texture coordinate 0, t downward
//   uv0_dx             its change per pixel to the right
//   uv0_dy             its change per pixel downward
//   uv1                texture coordinate 1, t downward
//   uv1_dx             its change per pixel to the right
//   uv1_dy             its change per pixel downward
#include "function/spaces.glsl"
#include "surfgrad/combine.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/number.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/sample.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/triplanar.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"
#include "surfgrad/volume_space.glsl"

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

struct SgMaterialParameters_mossy_rock {
    float p_detail;
};

SgMaterialResult sg_material_mossy_rock(SgMaterialInputs sg_inputs,
                                        SgMaterialParameters_mossy_rock sg_material, texture2D t_scan,
                                        texture2D t_pebble, texture2D t_scratch, texture2D t_moss,
                                        texture2D t_stone, sampler s_0) {
    SgUv m_uv0 = SgUv(sg_inputs.uv0, sg_inputs.uv0_dx, sg_inputs.uv0_dy);
    SgVolume m_object = SgVolume(sg_inputs.object_position, sg_inputs.object_position_dx,
                                 sg_inputs.object_position_dy);
    SgUv m_uv1 = SgUv(sg_inputs.uv1, sg_inputs.uv1_dx, sg_inputs.uv1_dy);

    // scan: normal_map
    vec3 m_scan = sg_decode_signed(sg_sample(t_scan, s_0, sg_uv_scale(m_uv0, vec2(4.0, 2.0))).xyz, 127.5);

    vec3 m_macro_normal = sg_resolve_vertex_map(sg_inputs.normal, sg_inputs.tangent, 1.0, m_scan,
                                                vec2(1.0, -1.0));

    // gravel: triplanar
    SgTriplanarUv m_gravel_planes = sg_volume_triplanar_uv(sg_volume_scale(m_object, 3.0), SG_RIGHT_HAND,
                                                           SG_UPPER_LEFT);
    vec3 m_gravel = sg_surfgrad_from_volume(
        m_macro_normal,
        sg_material.p_detail * sg_gradient_to_world(
            mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z),
            sg_triplanar_gradient(
                sg_triplanar_weights(
                    sg_function_object_normal(
                        mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z), m_macro_normal),
                    3.0),
                sg_deriv_green_up(sg_deriv_from_normal_xyz(
                    sg_decode_signed(sg_sample(t_pebble, s_0, m_gravel_planes.x).xyz, 127.0))),
                sg_deriv_green_up(sg_deriv_from_normal_xyz(
                    sg_decode_signed(sg_sample(t_pebble, s_0, m_gravel_planes.y).xyz, 127.0))),
                sg_deriv_green_up(sg_deriv_from_normal_xyz(
                    sg_decode_signed(sg_sample(t_pebble, s_0, m_gravel_planes.z).xyz, 127.0))),
                SG_RIGHT_HAND, SG_UPPER_LEFT)));

    // fuzz: noise in wet moss
    vec3 m_fuzz = sg_surfgrad_from_volume(
        m_macro_normal,
        sg_gradient_to_world(mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z),
                             0.16 * sg_volume_fractal_sum(sg_volume_scale(m_object, 40.0), 3).gradient));

    // slime: normal_map in wet moss
    vec3 m_slime = sg_surfgrad_from_tbn(
        0.3 * sg_deriv_from_normal_xy(
            sg_decode_signed(sg_sample(t_scratch, s_0, sg_uv_scale(m_uv1, vec2(4.0))).xy, 127.5)),
        sg_basis_uv(
            sg_frame_resolved(
                sg_frame(sg_inputs.position, sg_inputs.position_dx, sg_inputs.position_dy,
                         sg_base_normal(sg_inputs.normal)),
                m_macro_normal),
            m_uv1));

    // wet moss: group
    vec3 m_wet_moss = m_fuzz + m_slime;

    float m_facing_up = sg_smoothstep(0.1, 0.6, dot(m_macro_normal, vec3(0.0, 1.0, 0.0)));
    float m_mossy = sg_sample(t_moss, s_0, sg_uv_scale(m_uv0, vec2(6.0, 3.0))).x * m_facing_up;

    return SgMaterialResult(
        sg_flip(sg_resolve(m_macro_normal, sg_combine_mix(m_gravel, m_wet_moss, m_mossy)), sg_inputs.facing),
        mix(sg_sample(t_stone, s_0, sg_uv_scale(m_uv0, vec2(8.0, 4.0))).rgb, vec3(0.08, 0.2, 0.03), m_mossy),
        0.0, mix(0.75, 0.4, m_mossy), sg_sample(t_moss, s_0, m_uv0).y * 0.3 + 0.7, vec3(0.0), 1.0, 0.0);
}

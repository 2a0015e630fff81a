// five layers, all parameters: the material as a function, made by surfgradc.
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
//   world_position     absolute world space, world units
//   world_position_dx  its change per pixel to the right
//   world_position_dy  its change per pixel downward
//   object_x           the object's x axis in world axes: a unit of object space, world units
//   object_y           the object's y axis in world axes: a unit of object space, world units
//   object_z           the object's z axis in world axes: a unit of object space, world units
//   uv0                texture coordinate 0, t downward
//   uv0_dx             its change per pixel to the right
//   uv0_dy             its change per pixel downward
//   uv1                texture coordinate 1, t downward
//   uv1_dx             its change per pixel to the right
//   uv1_dy             its change per pixel downward
#include "surfgrad/decal.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/noise.glsl"
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

struct SgMaterialParameters_bench_b {
    vec3 p_tint;
    float p_opacity;
    vec2 p_tiling;
    vec2 p_detail_tiling;
    float p_pebble_tiling;
    float p_frequency;
    float p_power;
    mat4 p_projector;
    float p_weave_strength;
    float p_detail_strength;
    float p_pebble_strength;
    float p_dent_strength;
    float p_decal_strength;
    float p_roughness;
    float p_metallic;
    float d_dents_multiply;
    vec3 d_sign_axis_s;
    vec3 d_sign_axis_t;
};

SgMaterialResult sg_material_bench_b(SgMaterialInputs sg_inputs, SgMaterialParameters_bench_b sg_material,
                                     texture2D t_weave, texture2D t_scratch, texture2D t_pebble,
                                     texture2D t_ramp, texture2D t_moss, texture2D t_stone, texture2D t_sign,
                                     sampler s_0) {
    SgUv m_uv0 = SgUv(sg_inputs.uv0, sg_inputs.uv0_dx, sg_inputs.uv0_dy);
    vec3 m_base_normal = sg_mirror_normal(sg_base_normal(sg_inputs.normal), sg_inputs.facing);
    SgUv m_uv1 = SgUv(sg_inputs.uv1, sg_inputs.uv1_dx, sg_inputs.uv1_dy);
    SgVolume m_world = SgVolume(sg_inputs.world_position, sg_inputs.world_position_dx,
                                sg_inputs.world_position_dy);

    // weave: normal_map
    vec3 m_weave = sg_surfgrad_from_tbn(
        sg_material.p_weave_strength * sg_deriv_from_normal_xyz(
            sg_decode_signed(sg_sample(t_weave, s_0, sg_uv_scale(m_uv0, sg_material.p_tiling)).xyz, 127.5)),
        sg_basis_vertex(sg_inputs.normal, sg_inputs.tangent));

    // detail: normal_map
    vec3 m_detail = sg_surfgrad_from_tbn(
        sg_sample(t_moss, s_0, m_uv0).x *
        sg_material.p_detail_strength *
        sg_deriv_from_normal_xy(sg_decode_signed(
            sg_sample(t_scratch, s_0, sg_uv_scale(m_uv1, sg_material.p_detail_tiling)).xy, 127.5)),
        sg_basis_uv(sg_frame(sg_inputs.position, sg_inputs.position_dx, sg_inputs.position_dy, m_base_normal),
                    m_uv1));

    // pebbles: triplanar
    SgTriplanarUv m_pebbles_planes = sg_volume_triplanar_uv(
        sg_volume_scale(m_world, sg_material.p_pebble_tiling), SG_LEFT_HAND, SG_LOWER_LEFT);
    vec3 m_pebbles = sg_material.p_pebble_strength * sg_triplanar_gradient(
        sg_triplanar_weights(m_base_normal, 3.0),
        sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_pebble, s_0, m_pebbles_planes.x).xyz, 127.5)),
        sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_pebble, s_0, m_pebbles_planes.y).xyz, 127.5)),
        sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_pebble, s_0, m_pebbles_planes.z).xyz, 127.5)),
        SG_LEFT_HAND, SG_LOWER_LEFT);

    // dents: noise
    vec3 m_dents = sg_gradient_to_world(
        mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z),
        sg_material.d_dents_multiply * sg_noise_power(
            sg_volume_turbulence(
                sg_volume_scale(
                    SgVolume(sg_inputs.object_position, sg_inputs.object_position_dx,
                             sg_inputs.object_position_dy),
                    sg_material.p_frequency),
                4),
            sg_material.p_power).gradient);

    // sign: decal
    SgDecal m_sign_decal = sg_decal_box(sg_material.p_projector, m_world.p, m_world.dx, m_world.dy);
    vec4 m_sign_cutout = sg_sample(t_sign, s_0, m_sign_decal.uv);
    float m_sign_coverage = sg_decal_falloff_box(m_sign_decal.local, 0.25) * m_sign_cutout.w;
    vec3 m_sign = m_sign_coverage * sg_material.p_decal_strength * sg_decal_gradient_along(
        sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_ramp, s_0, m_sign_decal.uv).xyz, 127.5)),
        sg_material.d_sign_axis_s, sg_material.d_sign_axis_t);

    vec4 m_stone_texel = sg_sample(t_stone, s_0, m_uv0);
    vec3 m_stone = sg_material.p_tint * m_stone_texel.rgb;

    return SgMaterialResult(
        sg_resolve(m_base_normal,
                   m_weave + m_detail + sg_surfgrad_from_volume(m_base_normal, m_pebbles + m_dents + m_sign)),
        mix(m_stone, m_sign_cutout.rgb, m_sign_coverage),
        sg_material.p_metallic, sg_material.p_roughness, 1.0,
        vec3(0.0),
        sg_material.p_opacity * m_stone_texel.w, 0.0);
}

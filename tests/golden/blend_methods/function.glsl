// blend methods: the material as a function, made by surfgradc.
// It takes no derivatives and reads nothing but its arguments, so it may be called anywhere.
// Of SgMaterialInputs it reads these; the others need no value:
//   position           relative world space (origin at the camera), world units
//   position_dx        its change per pixel to the right
//   position_dy        its change per pixel downward
//   normal             interpolated vertex normal, world axes, any length
//   object_position    object space, object units
//   object_position_dx its change per pixel to the right
//   object_position_dy its change per pixel downward
//   uv0                texture coordinate 0, t downward
//   uv0_dx             its change per pixel to the right
//   uv0_dy             its change per pixel downward
//   uv1                texture coordinate 1, t downward
//   uv1_dx             its change per pixel to the right
//   uv1_dy             its change per pixel downward
#include "surfgrad/combine.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/number.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/sample.glsl"
#include "surfgrad/tbn.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"

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

struct SgMaterialParameters_blend_methods {
    float p_second;
};

SgMaterialResult sg_material_blend_methods(SgMaterialInputs sg_inputs,
                                           SgMaterialParameters_blend_methods sg_material, texture2D t_weave,
                                           texture2D t_scratch, sampler s_0) {
    vec3 m_base_normal = sg_base_normal(sg_inputs.normal);
    SgFrame m_frame = sg_frame(sg_inputs.position, sg_inputs.position_dx, sg_inputs.position_dy,
                               m_base_normal);
    SgUv m_uv0 = SgUv(sg_inputs.uv0, sg_inputs.uv0_dx, sg_inputs.uv0_dy);
    SgUv m_uv1 = SgUv(sg_inputs.uv1, sg_inputs.uv1_dx, sg_inputs.uv1_dy);

    // pd: normal_blend
    vec2 m_pd_deriv = sg_deriv_from_normal_xyz(
        sg_decode_signed(sg_sample(t_weave, s_0, sg_uv_scale(m_uv0, vec2(10.0, 4.0))).xyz, 128.0));
    vec2 m_pd_deriv_2 = sg_deriv_from_normal_xy(
        sg_decode_signed(sg_sample(t_scratch, s_0, sg_uv_scale(m_uv1, vec2(2.0, 5.0))).xy, 127.5));
    SgBasis m_pd_basis = sg_basis_uv(m_frame, m_uv0);
    vec3 m_pd_gradient = sg_surfgrad_from_tbn(m_pd_deriv, m_pd_basis);
    SgBasis m_pd_basis_2 = sg_basis_uv(m_frame, m_uv1);
    vec3 m_pd_gradient_2 = sg_surfgrad_from_tbn(m_pd_deriv_2, m_pd_basis_2);
    vec3 m_pd = m_pd_gradient + m_pd_gradient_2;

    // whiteout: normal_blend
    vec3 m_whiteout_m = sg_normal_from_deriv(m_pd_deriv);
    vec3 m_whiteout_second_m = sg_normal_from_deriv(m_pd_deriv_2);
    SgDerivPair m_whiteout_derivs = sg_combine_whiteout(m_whiteout_m, m_whiteout_second_m);
    vec3 m_whiteout = sg_surfgrad_from_tbn(m_whiteout_derivs.first, m_pd_basis) +
        sg_surfgrad_from_tbn(m_whiteout_derivs.second, m_pd_basis_2);

    // udn: normal_blend
    SgDerivPair m_udn_derivs = sg_combine_udn(m_whiteout_m, m_whiteout_second_m);
    vec3 m_udn = sg_surfgrad_from_tbn(m_udn_derivs.first, m_pd_basis) +
        sg_surfgrad_from_tbn(m_udn_derivs.second, m_pd_basis_2);

    // weighted: normal_blend
    vec3 m_weighted = sg_surfgrad_from_tbn(0.5 * m_pd_deriv, m_pd_basis) +
        sg_surfgrad_from_tbn(sg_material.p_second * m_pd_deriv_2, m_pd_basis_2);

    // rnm: normal_blend
    vec3 m_rnm = sg_combine_reoriented(m_base_normal, m_pd_gradient, m_pd_gradient_2);

    float m_height = SgVolume(sg_inputs.object_position, sg_inputs.object_position_dx,
                              sg_inputs.object_position_dy).p.y;

    return SgMaterialResult(
        sg_resolve(
            m_base_normal,
            sg_combine_mix(
                sg_combine_mix(
                    sg_combine_mix(sg_combine_mix(m_pd, m_whiteout, sg_smoothstep(-0.27, -0.25, m_height)),
                                   m_udn, sg_smoothstep(-0.11, -0.09, m_height)),
                    m_weighted,
                    sg_smoothstep(0.07, 0.09, m_height)),
                m_rnm,
                sg_smoothstep(0.25, 0.27, m_height))),
        vec3(0.55, 0.5, 0.45),
        0.0, 0.6, 1.0,
        vec3(0.0),
        1.0, 0.0);
}

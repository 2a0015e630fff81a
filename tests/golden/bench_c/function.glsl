// parallax and three resolves, all parameters: the material as a function, made by surfgradc.
// It takes no derivatives and reads nothing but its arguments, so it may be called anywhere.
// Of SgMaterialInputs it reads these; the others need no value:
//   position           relative world space (origin at the camera), world units
//   position_dx        its change per pixel to the right
//   position_dy        its change per pixel downward
//   normal             interpolated vertex normal, world axes, any length
//   color              interpolated vertex colour, linear
//   facing             +1 on front faces, -1 on back faces
//   object_position    object space, object units
//   object_position_dx its change per pixel to the right
//   object_position_dy its change per pixel downward
//   object_x           the object's x axis in world axes: a unit of object space, world units
//   object_y           the object's y axis in world axes: a unit of object space, world units
//   object_z           the object's z axis in world axes: a unit of object space, world units
//   camera_position    absolute world space
//   to_viewer          of a perspective 0, 0, 0, 1; else the unit direction to the viewer, world axes, and 0
//   screen_x           first column of the matrix (x px, y px, depth, 1) -> homogeneous relative world space
//   screen_y           its second column
//   clip_w             last row of the matrix from relative world space to clip space
//   uv0                texture coordinate 0, t downward
//   uv0_dx             its change per pixel to the right
//   uv0_dy             its change per pixel downward
//   uv1                texture coordinate 1, t downward
//   uv1_dx             its change per pixel to the right
//   uv1_dy             its change per pixel downward
//   uv2                texture coordinate 2, t downward
//   uv2_dx             its change per pixel to the right
//   uv2_dy             its change per pixel downward
#include "function/moved.glsl"
#include "function/spaces.glsl"
#include "surfgrad/decal.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/from_normal.glsl"
#include "surfgrad/height_map.glsl"
#include "surfgrad/noise.glsl"
#include "surfgrad/parallax.glsl"
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

struct SgMaterialParameters_bench_c {
    vec3 p_tint;
    float p_opacity;
    vec2 p_tiling;
    vec2 p_detail_tiling;
    vec2 p_rib_tiling;
    float p_weave_tiling;
    float p_exponent;
    float p_frequency;
    float p_power;
    mat4 p_first_projector;
    mat4 p_second_projector;
    float p_depth;
    float p_stone_strength;
    float p_detail_strength;
    float p_object_strength;
    float p_rib_strength;
    float p_weave_strength;
    float p_dent_strength;
    float p_first_strength;
    float p_second_strength;
    float p_roughness;
    float p_metallic;
    float p_wetness;
    float d_parallax_multiply;
    float d_dents_multiply;
    vec3 d_sign_axis_s;
    vec3 d_sign_axis_t;
    vec3 d_plaster_axis_s;
    vec3 d_plaster_axis_t;
};

SgMaterialResult sg_material_bench_c(SgMaterialInputs sg_inputs, SgMaterialParameters_bench_c sg_material,
                                     texture2D t_height, texture2D t_pebble, texture2D t_scratch,
                                     texture2D t_moss, texture2D t_sphere, texture2D t_rib, texture2D t_weave,
                                     texture2D t_ramp, texture2D t_brick, texture2D t_stone, texture2D t_sign,
                                     texture2D t_plaster, sampler s_0) {
    vec3 m_base_normal = sg_mirror_normal(sg_base_normal(sg_inputs.normal), sg_inputs.facing);
    SgFrame m_frame = sg_frame(sg_inputs.position, sg_inputs.position_dx, sg_inputs.position_dy,
                               m_base_normal);
    SgUv m_uv1 = SgUv(sg_inputs.uv1, sg_inputs.uv1_dx, sg_inputs.uv1_dy);
    SgUv m_uv2 = SgUv(sg_inputs.uv2, sg_inputs.uv2_dx, sg_inputs.uv2_dy);

    // parallax: occlusion
    SgUv m_parallax_uv = sg_uv_scale(SgUv(sg_inputs.uv0, sg_inputs.uv0_dx, sg_inputs.uv0_dy),
                                     sg_material.p_tiling);
    vec3 m_parallax_view = sg_parallax_direction(m_frame, m_parallax_uv,
                                                 sg_function_view(sg_inputs.to_viewer, sg_inputs.position));
    SgParallax m_parallax_hit = sg_parallax_occlusion(
        t_height, s_0, vec2(sg_material.p_depth, sg_material.d_parallax_multiply), m_parallax_uv.st,
        m_parallax_view, sg_uv_level(m_parallax_uv, sg_texture_size(t_height, s_0)),
        int(mix(48.0, 12.0, clamp(m_parallax_view.z, 0.0, 1.0))));

    SgUv m_seen_uv = sg_parallax_uv(m_parallax_uv, m_parallax_hit.offset);

    // stones: normal_map
    vec3 m_stones = sg_surfgrad_from_height(
        m_frame, m_seen_uv,
        sg_texture_size(t_pebble, s_0),
        sg_material.p_stone_strength *
            sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_pebble, s_0, m_seen_uv).xyz, 127.5)));

    // detail: normal_map
    vec3 m_detail = sg_surfgrad_from_tbn(
        sg_sample(t_moss, s_0, m_seen_uv).x *
        sg_material.p_detail_strength *
        sg_deriv_from_normal_xy(sg_decode_signed(
            sg_sample(t_scratch, s_0, sg_uv_scale(m_uv1, sg_material.p_detail_tiling)).xy, 127.5)),
        sg_basis_uv(m_frame, m_uv1));

    // sphere: object_normal_map
    vec3 m_sphere = sg_material.p_object_strength * sg_surfgrad_from_normal(
        m_base_normal,
        sg_function_normal_from_object(mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z),
                                       sg_decode_signed(sg_sample(t_sphere, s_0, m_seen_uv).xyz, 127.5)));

    // ribs: height_map
    vec3 m_ribs = sg_surfgrad_from_tbn(
        clamp(sg_inputs.color.x, 0.0, 1.0) * sg_material.p_rib_strength *
            sg_deriv_from_height_hq(t_rib, s_0, sg_uv_scale(m_uv2, sg_material.p_rib_tiling)),
        sg_basis_uv(m_frame, m_uv2));

    vec3 m_relief_normal = sg_resolve(m_base_normal, m_stones + m_detail + m_sphere + m_ribs);
    SgVolume m_moved_world = sg_function_world_volume(
        sg_inputs.camera_position,
        sg_function_frame_rebuilt(
            sg_parallax_position(m_frame, sg_parallax_pixels(m_parallax_uv, m_parallax_hit.offset),
                                 m_parallax_hit.height),
            m_relief_normal, 1.0, sg_inputs.to_viewer, sg_inputs.screen_x, sg_inputs.screen_y,
            sg_inputs.clip_w));

    // weave: triplanar
    SgTriplanarUv m_weave_planes = sg_volume_triplanar_uv(
        sg_volume_scale(m_moved_world, sg_material.p_weave_tiling), SG_LEFT_HAND, SG_LOWER_LEFT);
    vec3 m_weave = clamp(sg_inputs.color.y, 0.0, 1.0) * sg_material.p_weave_strength * sg_triplanar_gradient(
        sg_triplanar_weights(m_relief_normal, sg_material.p_exponent),
        sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_weave, s_0, m_weave_planes.x).xyz, 127.5)),
        sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_weave, s_0, m_weave_planes.y).xyz, 127.5)),
        sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_weave, s_0, m_weave_planes.z).xyz, 127.5)),
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
                6),
            sg_material.p_power).gradient);

    // sign: decal
    SgDecal m_sign_decal = sg_decal_box(sg_material.p_first_projector, m_moved_world.p, m_moved_world.dx,
                                        m_moved_world.dy);
    vec4 m_sign_cutout = sg_sample(t_sign, s_0, m_sign_decal.uv);
    float m_sign_coverage = sg_decal_falloff_box(m_sign_decal.local, 0.25) * m_sign_cutout.w;
    vec3 m_sign = m_sign_coverage * sg_material.p_first_strength * sg_decal_gradient_along(
        sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_ramp, s_0, m_sign_decal.uv).xyz, 127.5)),
        sg_material.d_sign_axis_s, sg_material.d_sign_axis_t);

    // plaster: decal
    SgDecal m_plaster_decal = sg_decal_box(sg_material.p_second_projector, m_moved_world.p, m_moved_world.dx,
                                           m_moved_world.dy);
    vec4 m_plaster_cutout = sg_sample(t_plaster, s_0, m_plaster_decal.uv);
    float m_plaster_coverage = sg_decal_falloff_box(m_plaster_decal.local, 0.25) * m_plaster_cutout.w;
    vec3 m_plaster = m_plaster_coverage * sg_material.p_second_strength * sg_decal_gradient_along(
        sg_deriv_from_normal_xyz(sg_decode_signed(sg_sample(t_brick, s_0, m_plaster_decal.uv).xyz, 127.5)),
        sg_material.d_plaster_axis_s, sg_material.d_plaster_axis_t);

    float m_wet = sg_material.p_wetness * sg_inputs.color.z;

    // film: earlier_normal
    vec3 m_film = sg_resolve_towards(
        sg_resolve_volume(sg_resolve_volume(m_relief_normal, m_weave + m_dents), m_sign + m_plaster),
        m_relief_normal, clamp(m_wet, 0.0, 1.0));

    vec4 m_stone_texel = sg_sample(t_stone, s_0, m_seen_uv);
    vec3 m_stone = sg_material.p_tint * m_stone_texel.rgb;
    vec3 m_marked = mix(mix(m_stone, m_sign_cutout.rgb, m_sign_coverage), m_plaster_cutout.rgb,
                        m_plaster_coverage);
    float m_marked_roughness = mix(mix(sg_material.p_roughness, 0.4, m_sign_coverage), 0.4,
                                   m_plaster_coverage);

    return SgMaterialResult(m_film, m_marked * mix(vec3(1.0), vec3(0.6), m_wet), sg_material.p_metallic,
                            clamp(mix(m_marked_roughness, 0.1, m_wet), 0.0, 1.0), 1.0, vec3(0.0),
                            sg_material.p_opacity * m_stone_texel.w, 0.0);
}

// marked torus: the material as a function, made by surfgradc.
// It takes no derivatives and reads nothing but its arguments, so it may be called anywhere.
// Of SgMaterialInputs it reads these; the others need no value:
//   normal             interpolated vertex normal, world axes, any length
//   object_position    object space, object units
//   object_position_dx its change per pixel to the right
//   object_position_dy its change per pixel downward
//   world_position     absolute world space, world units
//   world_position_dx  its change per pixel to the right
//   world_position_dy  its change per pixel downward
//   object_x           the object's x axis in world axes: a unit of object space, world units
//   object_y           the object's y axis in world axes: a unit of object space, world units
//   object_z           the object's z axis in world axes: a unit of object space, world units
#include "function/spaces.glsl"
#include "surfgrad/combine.glsl"
#include "surfgrad/decal.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/sample.glsl"
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

struct SgMaterialParameters_decal {
    float p_reach;
    float d_dent_multiply;
};

SgMaterialResult sg_material_decal(SgMaterialInputs sg_inputs, SgMaterialParameters_decal sg_material,
                                   texture2D t_chart, texture2D t_brick, texture2D t_pebble,
                                   texture2D t_stone, texture2D t_moss, sampler s_0) {
    SgVolume m_object = SgVolume(sg_inputs.object_position, sg_inputs.object_position_dx,
                                 sg_inputs.object_position_dy);
    vec3 m_base_normal = sg_base_normal(sg_inputs.normal);
    SgVolume m_world = SgVolume(sg_inputs.world_position, sg_inputs.world_position_dx,
                                sg_inputs.world_position_dy);

    // grain: noise
    vec3 m_grain = sg_gradient_to_world(
        mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z),
        0.072 * sg_volume_fractal_sum(sg_volume_scale(m_object, 9.0), 3).gradient);

    // chart: decal
    SgDecal m_chart_decal = sg_decal_box(
        mat4(mat4x3(vec3(2.2222223, 0.0, 0.0), vec3(0.0, -1.5094117, -2.0478802),
                    vec3(0.0, 2.1556633, -1.4339411), vec3(-0.44444445, -1.9184061, 2.1916993))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_chart =
        sg_decal_falloff_box(m_chart_decal.local, 0.1) *
        sg_decal_angle_fade(
            sg_function_object_normal(mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z),
                                      m_base_normal),
            vec3(0.0, 0.81915206, 0.57357645),
            0.64278764, 0.087155744) *
        1.2 *
        sg_gradient_to_world(
            mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z),
            sg_decal_gradient(
                sg_deriv_green_up(sg_deriv_from_normal_xyz(
                    sg_decode_signed(sg_sample(t_chart, s_0, m_chart_decal.uv).xyz, 127.5))),
                m_chart_decal));

    // pebbles: decal
    SgDecal m_pebbles_decal = sg_decal_sphere(
        mat4(mat4x3(vec3(1.6666666, 0.0, 0.0), vec3(0.0, -1.6666666, 0.0), vec3(0.0, 0.0, -1.6666666),
                    vec3(1.5, 0.0, 0.6666667))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_pebbles = sg_decal_falloff_sphere(m_pebbles_decal.local, 0.4) * sg_gradient_to_world(
        mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z),
        sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_sample(t_pebble, s_0, m_pebbles_decal.uv).xyz, 127.0))),
            m_pebbles_decal));

    // dent: decal
    SgDecal m_dent_decal = sg_decal_box(
        mat4(mat4x3(vec3(2.8867514, 0.0, -1.6666666), vec3(-1.4433757, -1.6666666, -2.5),
                    vec3(-0.8333333, 2.8867514, -1.4433757), vec3(-2.2617514, -1.9983969, 3.0825317))),
        m_world.p, m_world.dx, m_world.dy);
    vec3 m_dent =
        -sg_decal_falloff_capsule(m_dent_decal.local, sg_material.d_dent_multiply, 0.2) *
        sg_sample(t_moss, s_0, m_dent_decal.uv).x *
        sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_sample(t_pebble, s_0, m_dent_decal.uv).xyz, 127.0))),
            m_dent_decal);

    // wedge: decal
    SgDecal m_wedge_decal = sg_decal_box(
        mat4(
            mat4x3(vec3(0.0, -2.5, 0.0), vec3(0.0, 0.0, -1.25), vec3(2.0, 0.0, 0.0), vec3(0.6, -2.625, 1.0))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_wedge = sg_decal_falloff_wedge(m_wedge_decal.local, 0.2) * 0.8 * sg_gradient_to_world(
        mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z),
        sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_sample(t_chart, s_0, m_wedge_decal.uv).xyz, 127.5))),
            m_wedge_decal));

    // bricks: decal
    SgDecal m_bricks_decal = sg_decal_cone(
        mat4(mat4x3(vec3(1.4285715, 0.0, 0.0), vec3(0.0, 0.0, -0.625), vec3(0.0, 1.4285715, 0.0),
                    vec3(-1.2857143, 0.5714286, 0.875))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_bricks = sg_gradient_to_world(
        mat3(sg_inputs.object_x, sg_inputs.object_y, sg_inputs.object_z),
        sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_sample(t_brick, s_0, m_bricks_decal.uv).xyz, 127.5))),
            m_bricks_decal));
    float m_bricks_falloff = sg_decal_falloff_cone(m_bricks_decal.local, 0.15);

    vec3 m_fired = sg_sample(t_stone, s_0, m_bricks_decal.uv).rgb * vec3(1.0, 0.4, 0.25);

    return SgMaterialResult(
        sg_resolve_volume(
            m_base_normal,
            sg_combine_mix(m_grain + m_chart + m_pebbles + m_dent + m_wedge, m_bricks, m_bricks_falloff)),
        mix(vec3(0.5, 0.48, 0.44), m_fired, m_bricks_falloff),
        0.0, 0.65, 1.0,
        vec3(0.0),
        1.0, 0.0);
}

#version 450
#extension GL_GOOGLE_include_directive : require
// a decal on a plane: fragment shader of the entry point 'gbuffer', made by surfgradc.

#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/decal.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"

layout(set = 1, binding = 1) uniform texture2D t_dome;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 1) in vec3 sg_in_normal;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_base_color;
layout(location = 1) out vec4 sg_out_normal;
layout(location = 2) out vec4 sg_out_surface;
layout(location = 3) out vec4 sg_out_emission;

void main() {
    SgVolume m_object = sg_stage_volume(sg_in_object_position);

    // decal: decal
    SgDecal m_decal_decal = sg_decal_box(
        mat4(mat4x3(vec3(0.95755553, 0.0, -0.7142085), vec3(0.0, -1.25, 0.0),
                    vec3(-0.8034845, 0.0, -0.85116047), vec3(0.0))),
        m_object.p, m_object.dx, m_object.dy);
    vec3 m_decal =
        sg_decal_falloff_box(m_decal_decal.local, 0.15) *
        sg_stage_gradient_from_object(sg_decal_gradient(
            sg_deriv_green_up(sg_deriv_from_normal_xyz(
                sg_decode_signed(sg_stage_sample(t_dome, s_0, m_decal_decal.uv).xyz, 127.5))),
            m_decal_decal));

    sg_out_base_color = vec4(vec3(0.45, 0.45, 0.43), 1.0);
    sg_out_normal = vec4(sg_resolve_volume(sg_base_normal(sg_in_normal), m_decal), 0.7);
    sg_out_surface = vec4(0.0, 1.0, 0.0, 1.0);
    sg_out_emission = vec4(vec3(0.0), 1.0);
}

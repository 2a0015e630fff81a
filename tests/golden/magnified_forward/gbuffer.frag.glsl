#version 450
#extension GL_GOOGLE_include_directive : require
// magnified heights, forward: fragment shader of the entry point 'gbuffer', made by surfgradc.

#include "stage/fragment.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/height_map.glsl"
#include "surfgrad/resolve.glsl"

layout(set = 1, binding = 1) uniform texture2D t_dome;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_base_color;
layout(location = 1) out vec4 sg_out_normal;
layout(location = 2) out vec4 sg_out_surface;
layout(location = 3) out vec4 sg_out_emission;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);

    // dome: height_map
    vec3 m_dome = sg_surfgrad_from_height(sg_stage_frame(sg_in_position, m_base_normal), m_uv0,
                                          sg_texture_size(t_dome, s_0),
                                          0.3 * sg_deriv_from_height(t_dome, s_0, m_uv0));

    sg_out_base_color = vec4(vec3(0.42, 0.32, 0.25), 1.0);
    sg_out_normal = vec4(sg_resolve(m_base_normal, m_dome), 0.45);
    sg_out_surface = vec4(0.0, 1.0, 0.0, 1.0);
    sg_out_emission = vec4(vec3(0.0), 1.0);
}

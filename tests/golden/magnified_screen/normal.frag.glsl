#version 450
#extension GL_GOOGLE_include_directive : require
// magnified heights, screen: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/resolve.glsl"

layout(set = 1, binding = 1) uniform texture2D t_dome;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);

    // dome: height_map
    vec3 m_dome = 0.3 * sg_surfgrad_from_screen_height(
        sg_stage_frame(sg_in_position, m_base_normal),
        sg_screen_height_three_tap(t_dome, s_0, sg_stage_uv(sg_in_uv0)));

    sg_out_normal = vec4(sg_resolve(m_base_normal, m_dome), 1.0);
}

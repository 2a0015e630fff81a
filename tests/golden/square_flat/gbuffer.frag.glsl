#version 450
#extension GL_GOOGLE_include_directive : require
// square without its map: fragment shader of the entry point 'gbuffer', made by surfgradc.

#include "stage/fragment.glsl"
#include "surfgrad/frame.glsl"

layout(set = 1, binding = 1) uniform texture2D t_color;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_base_color;
layout(location = 1) out vec4 sg_out_normal;
layout(location = 2) out vec4 sg_out_surface;
layout(location = 3) out vec4 sg_out_emission;

void main() {
    sg_out_base_color = vec4(sg_stage_sample(t_color, s_0, sg_stage_uv(sg_in_uv0)).rgb, 1.0);
    sg_out_normal = vec4(sg_base_normal(sg_in_normal), 0.5);
    sg_out_surface = vec4(0.0, 1.0, 0.0, 1.0);
    sg_out_emission = vec4(vec3(0.0), 1.0);
}

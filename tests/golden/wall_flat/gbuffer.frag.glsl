#version 450
#extension GL_GOOGLE_include_directive : require
// flat wall: fragment shader of the entry point 'gbuffer', made by surfgradc.

#include "surfgrad/frame.glsl"

layout(location = 1) in vec3 sg_in_normal;
layout(location = 0) out vec4 sg_out_base_color;
layout(location = 1) out vec4 sg_out_normal;
layout(location = 2) out vec4 sg_out_surface;
layout(location = 3) out vec4 sg_out_emission;

void main() {
    sg_out_base_color = vec4(vec3(0.5, 0.24, 0.16), 1.0);
    sg_out_normal = vec4(sg_base_normal(sg_in_normal), 0.8);
    sg_out_surface = vec4(0.0, 1.0, 0.0, 1.0);
    sg_out_emission = vec4(vec3(0.0), 1.0);
}

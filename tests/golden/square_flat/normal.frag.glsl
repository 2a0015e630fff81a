#version 450
#extension GL_GOOGLE_include_directive : require
// square without its map: fragment shader of the entry point 'normal', made by surfgradc.

#include "surfgrad/frame.glsl"

layout(location = 1) in vec3 sg_in_normal;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    sg_out_normal = vec4(sg_base_normal(sg_in_normal), 1.0);
}

#version 450
#extension GL_GOOGLE_include_directive : require
// flat wall: vertex shader of the entry point 'gbuffer', made by surfgradc.

#include "stage/vertex.glsl"

layout(location = 0) in vec3 sg_vertex_position;
layout(location = 1) in vec3 sg_vertex_normal;
layout(location = 1) out vec3 sg_out_normal;

void main() {
    sg_out_normal = sg_stage_normal(sg_vertex_normal);
    gl_Position = sg_stage_clip(sg_stage_position(sg_vertex_position));
}

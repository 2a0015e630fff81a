#version 450
#extension GL_GOOGLE_include_directive : require
// rock, both in one stage: vertex shader of the entry point 'gbuffer', made by surfgradc.

#include "stage/vertex.glsl"

layout(location = 0) in vec3 sg_vertex_position;
layout(location = 1) in vec3 sg_vertex_normal;
layout(location = 4) in vec2 sg_vertex_uv0;
layout(location = 0) out vec3 sg_out_position;
layout(location = 1) out vec3 sg_out_normal;
layout(location = 4) out vec2 sg_out_uv0;
layout(location = 12) out vec3 sg_out_object_position;

void main() {
    vec3 sg_relative_position = sg_stage_position(sg_vertex_position);
    sg_out_position = sg_relative_position;
    sg_out_normal = sg_stage_normal(sg_vertex_normal);
    sg_out_uv0 = sg_vertex_uv0;
    sg_out_object_position = sg_vertex_position;
    gl_Position = sg_stage_clip(sg_relative_position);
}

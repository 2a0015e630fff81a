#version 450
#extension GL_GOOGLE_include_directive : require
// a decal on a plane: vertex shader of the entry point 'depth', made by surfgradc.

#include "stage/vertex.glsl"

layout(location = 0) in vec3 sg_vertex_position;

void main() {
    gl_Position = sg_stage_clip(sg_stage_position(sg_vertex_position));
}

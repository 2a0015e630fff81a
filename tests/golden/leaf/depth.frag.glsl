#version 450
#extension GL_GOOGLE_include_directive : require
// leaf: fragment shader of the entry point 'depth', made by surfgradc.

#include "stage/fragment.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 0, std140) uniform SgMaterialBlock {
    vec3 p_glow;
    float p_eaten;
} sg_material;
layout(set = 1, binding = 2) uniform texture2D t_holes;
layout(set = 1, binding = 4) uniform sampler s_0;

layout(location = 4) in vec2 sg_in_uv0;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    float m_hole = sg_stage_sample(t_holes, s_0, sg_uv_scale(m_uv0, vec2(4.0, 3.0))).x;

    if (1.0 - m_hole * sg_material.p_eaten < 0.58) discard;
}

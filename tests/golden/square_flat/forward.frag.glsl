#version 450
#extension GL_GOOGLE_include_directive : require
// square without its map: fragment shader of the entry point 'forward', made by surfgradc.

#include "lighting/ggx.glsl"
#include "stage/forward.glsl"
#include "stage/fragment.glsl"
#include "surfgrad/frame.glsl"

layout(set = 1, binding = 1) uniform texture2D t_color;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_color;

void main() {
    SgGgxSurface sg_surface;
    sg_surface.base_color = sg_stage_sample(t_color, s_0, sg_stage_uv(sg_in_uv0)).rgb;
    sg_surface.metallic = 0.0;
    sg_surface.roughness = 0.5;
    sg_surface.occlusion = 1.0;
    sg_surface.emission = vec3(0.0);
    sg_out_color = vec4(
        sg_ggx_radiance(sg_surface, sg_base_normal(sg_in_normal), sg_stage_lights(sg_in_position)), 1.0);
}

#version 450
#extension GL_GOOGLE_include_directive : require
// flat wall: fragment shader of the entry point 'forward', made by surfgradc.

#include "lighting/ggx.glsl"
#include "stage/forward.glsl"
#include "surfgrad/frame.glsl"

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 0) out vec4 sg_out_color;

void main() {
    SgGgxSurface sg_surface;
    sg_surface.base_color = vec3(0.5, 0.24, 0.16);
    sg_surface.metallic = 0.0;
    sg_surface.roughness = 0.8;
    sg_surface.occlusion = 1.0;
    sg_surface.emission = vec3(0.0);
    sg_out_color = vec4(
        sg_ggx_radiance(sg_surface, sg_base_normal(sg_in_normal), sg_stage_lights(sg_in_position)), 1.0);
}

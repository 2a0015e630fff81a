#version 450
#extension GL_GOOGLE_include_directive : require
// noise on a sphere: fragment shader of the entry point 'forward', made by surfgradc.

#include "lighting/ggx.glsl"
#include "stage/forward.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/volume.glsl"

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_color;

void main() {
    // noise: noise
    vec3 m_noise = sg_stage_gradient_from_object(0.3 *
        sg_volume_fractal_sum(sg_volume_scale(sg_stage_volume(sg_in_object_position), 6.0), 4).gradient);

    SgGgxSurface sg_surface;
    sg_surface.base_color = vec3(0.62, 0.5, 0.4);
    sg_surface.metallic = 0.0;
    sg_surface.roughness = 0.6;
    sg_surface.occlusion = 1.0;
    sg_surface.emission = vec3(0.0);
    sg_out_color = vec4(
        sg_ggx_radiance(sg_surface, sg_resolve_volume(sg_base_normal(sg_in_normal), m_noise),
                        sg_stage_lights(sg_in_position)),
        1.0);
}

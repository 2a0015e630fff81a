#version 450
#extension GL_GOOGLE_include_directive : require
// noise on a sphere: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/volume.glsl"

layout(location = 1) in vec3 sg_in_normal;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    // noise: noise
    vec3 m_noise = sg_stage_gradient_from_object(0.3 *
        sg_volume_fractal_sum(sg_volume_scale(sg_stage_volume(sg_in_object_position), 6.0), 4).gradient);

    sg_out_normal = vec4(sg_resolve_volume(sg_base_normal(sg_in_normal), m_noise), 1.0);
}

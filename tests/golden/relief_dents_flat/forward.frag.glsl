#version 450
#extension GL_GOOGLE_include_directive : require
// the same bumps without parallax: fragment shader of the entry point 'forward', made by surfgradc.

#include "lighting/ggx.glsl"
#include "stage/forward.glsl"
#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/height_map.glsl"
#include "surfgrad/noise.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 1) uniform texture2D t_pebble;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_color;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);

    // stones: height_map
    vec3 m_stones = sg_surfgrad_from_height(sg_stage_frame(sg_in_position, m_base_normal), m_uv0,
                                            sg_texture_size(t_pebble, s_0),
                                            0.1 * sg_deriv_from_height_hq(t_pebble, s_0, m_uv0));

    // dents: noise
    vec3 m_dents = sg_stage_gradient_from_object(-0.24 * sg_noise_power(
        sg_volume_turbulence(sg_volume_scale(sg_stage_volume(sg_in_object_position), 3.0), 3), 2.0).gradient);

    SgGgxSurface sg_surface;
    sg_surface.base_color = vec3(0.72, 0.68, 0.6);
    sg_surface.metallic = 0.0;
    sg_surface.roughness = 0.8;
    sg_surface.occlusion = 1.0;
    sg_surface.emission = vec3(0.0);
    sg_out_color = vec4(
        sg_ggx_radiance(sg_surface, sg_resolve_volume(sg_resolve(m_base_normal, m_stones), m_dents),
                        sg_stage_lights(sg_in_position)),
        1.0);
}

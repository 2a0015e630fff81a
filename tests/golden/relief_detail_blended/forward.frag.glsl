#version 450
#extension GL_GOOGLE_include_directive : require
// carved pebbles blended with fine pebbles: fragment shader of the entry point 'forward', made by surfgradc.

#include "lighting/ggx.glsl"
#include "stage/forward.glsl"
#include "stage/fragment.glsl"
#include "stage/view.glsl"
#include "surfgrad/combine.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/height_map.glsl"
#include "surfgrad/parallax.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 1) uniform texture2D t_pebble;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_color;

void main() {
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgFrame m_frame = sg_stage_frame(sg_in_position, m_base_normal);
    SgNormalDerivatives m_normal_derivatives = sg_stage_normal_derivatives(sg_in_normal);

    // parallax: occlusion
    vec3 m_parallax_view = sg_parallax_direction(m_frame, m_uv0, sg_stage_view(sg_in_position));
    SgParallax m_parallax_hit = sg_parallax_occlusion(
        t_pebble, s_0, vec2(0.1, -0.1), m_uv0.st, m_parallax_view,
        sg_uv_level(m_uv0, sg_texture_size(t_pebble, s_0)),
        int(mix(128.0, 48.0, clamp(m_parallax_view.z, 0.0, 1.0))));
    vec3 m_parallax_moved_normal = sg_parallax_normal(m_base_normal, m_normal_derivatives.dndx,
                                                      m_normal_derivatives.dndy,
                                                      sg_parallax_pixels(m_uv0, m_parallax_hit.offset));

    SgFrame m_moved_frame = sg_frame_resolved(m_frame, m_parallax_moved_normal);
    SgUv m_moved_uv0 = sg_parallax_uv(m_uv0, m_parallax_hit.offset);

    // stones: height_map
    vec3 m_stones = sg_surfgrad_from_height(m_moved_frame, m_moved_uv0, sg_texture_size(t_pebble, s_0),
                                            0.1 * sg_deriv_from_height_hq(t_pebble, s_0, m_moved_uv0));

    // grain: height_map
    SgUv m_grain_uv = sg_uv_scale(m_moved_uv0, vec2(6.0));
    vec3 m_grain = sg_surfgrad_from_height(m_moved_frame, m_grain_uv, sg_texture_size(t_pebble, s_0),
                                           0.006 * sg_deriv_from_height_hq(t_pebble, s_0, m_grain_uv));

    SgGgxSurface sg_surface;
    sg_surface.base_color = vec3(0.72, 0.68, 0.6);
    sg_surface.metallic = 0.0;
    sg_surface.roughness = 0.7;
    sg_surface.occlusion = 1.0;
    sg_surface.emission = vec3(0.0);
    sg_out_color = vec4(
        sg_ggx_radiance(sg_surface,
                        sg_resolve(m_parallax_moved_normal, sg_combine_mix(m_stones, m_grain, 0.5)),
                        sg_stage_lights(sg_in_position)),
        1.0);
}

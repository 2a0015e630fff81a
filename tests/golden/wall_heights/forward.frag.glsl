#version 450
#extension GL_GOOGLE_include_directive : require
// brick wall from heights: fragment shader of the entry point 'forward', made by surfgradc.

#include "lighting/ggx.glsl"
#include "stage/forward.glsl"
#include "stage/fragment.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/height_map.glsl"
#include "surfgrad/resolve.glsl"

layout(set = 1, binding = 1) uniform texture2D t_brick;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_color;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);
    SgUv m_uv0 = sg_stage_uv(sg_in_uv0);

    // bricks: height_map
    vec3 m_bricks = sg_surfgrad_from_height(sg_stage_frame(sg_in_position, m_base_normal), m_uv0,
                                            sg_texture_size(t_brick, s_0),
                                            0.04 * sg_deriv_from_height_hq(t_brick, s_0, m_uv0));

    SgGgxSurface sg_surface;
    sg_surface.base_color = vec3(0.5, 0.24, 0.16);
    sg_surface.metallic = 0.0;
    sg_surface.roughness = 0.8;
    sg_surface.occlusion = 1.0;
    sg_surface.emission = vec3(0.0);
    sg_out_color = vec4(
        sg_ggx_radiance(sg_surface, sg_resolve(m_base_normal, m_bricks), sg_stage_lights(sg_in_position)),
        1.0);
}

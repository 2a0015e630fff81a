#version 450
#extension GL_GOOGLE_include_directive : require
// blob: fragment shader of the entry point 'forward', made by surfgradc.

#include "lighting/ggx.glsl"
#include "stage/forward.glsl"
#include "stage/fragment.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 1) uniform texture2D t_pebble;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_color;

void main() {
    // skin: normal_map
    vec3 m_skin = sg_decode_signed(
        sg_stage_sample(t_pebble, s_0, sg_uv_scale(sg_stage_uv(sg_in_uv0), vec2(4.0, 2.0))).xyz, 127.5);

    SgGgxSurface sg_surface;
    sg_surface.base_color = vec3(0.3, 0.42, 0.25);
    sg_surface.metallic = 0.0;
    sg_surface.roughness = 0.35;
    sg_surface.occlusion = 1.0;
    sg_surface.emission = vec3(0.0);
    sg_out_color = vec4(
        sg_ggx_radiance(sg_surface,
                        sg_resolve_vertex_map(sg_in_normal, sg_in_tangent, 1.0, m_skin, vec2(1.0, -1.0)),
                        sg_stage_lights(sg_in_position)),
        1.0);
}

#version 450
#extension GL_GOOGLE_include_directive : require
// blob: fragment shader of the entry point 'gbuffer', made by surfgradc.

#include "stage/fragment.glsl"
#include "surfgrad/deriv.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/uv.glsl"

layout(set = 1, binding = 1) uniform texture2D t_pebble;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 1) in vec3 sg_in_normal;
layout(location = 2) in vec4 sg_in_tangent;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 0) out vec4 sg_out_base_color;
layout(location = 1) out vec4 sg_out_normal;
layout(location = 2) out vec4 sg_out_surface;
layout(location = 3) out vec4 sg_out_emission;

void main() {
    // skin: normal_map
    vec3 m_skin = sg_decode_signed(
        sg_stage_sample(t_pebble, s_0, sg_uv_scale(sg_stage_uv(sg_in_uv0), vec2(4.0, 2.0))).xyz, 127.5);

    sg_out_base_color = vec4(vec3(0.3, 0.42, 0.25), 1.0);
    sg_out_normal = vec4(sg_resolve_vertex_map(sg_in_normal, sg_in_tangent, 1.0, m_skin, vec2(1.0, -1.0)),
                         0.35);
    sg_out_surface = vec4(0.0, 1.0, 0.0, 1.0);
    sg_out_emission = vec4(vec3(0.0), 1.0);
}

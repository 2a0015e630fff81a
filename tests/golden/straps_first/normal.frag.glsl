#version 450
#extension GL_GOOGLE_include_directive : require
// ribs on the first unwrap: fragment shader of the entry point 'normal', made by surfgradc.

#include "stage/fragment.glsl"
#include "stage/object.glsl"
#include "surfgrad/frame.glsl"
#include "surfgrad/from_height.glsl"
#include "surfgrad/from_volume.glsl"
#include "surfgrad/height_map.glsl"
#include "surfgrad/resolve.glsl"
#include "surfgrad/uv.glsl"
#include "surfgrad/volume.glsl"

layout(set = 1, binding = 1) uniform texture2D t_rib;
layout(set = 1, binding = 2) uniform sampler s_0;

layout(location = 0) in vec3 sg_in_position;
layout(location = 1) in vec3 sg_in_normal;
layout(location = 4) in vec2 sg_in_uv0;
layout(location = 12) in vec3 sg_in_object_position;
layout(location = 0) out vec4 sg_out_normal;

void main() {
    vec3 m_base_normal = sg_base_normal(sg_in_normal);

    // ribs: height_map
    SgUv m_ribs_uv = sg_uv_transform(sg_stage_uv(sg_in_uv0), vec2(4.0, 2.0), 0.4886922, vec2(0.0));
    vec3 m_ribs = sg_surfgrad_from_height(sg_stage_frame(sg_in_position, m_base_normal), m_ribs_uv,
                                          sg_texture_size(t_rib, s_0),
                                          0.05 * sg_deriv_from_height_hq(t_rib, s_0, m_ribs_uv));

    // grain: noise
    vec3 m_grain = sg_surfgrad_from_volume(
        m_base_normal,
        sg_stage_gradient_from_object(0.054 *
            sg_volume_fractal_sum(sg_volume_scale(sg_stage_volume(sg_in_object_position), 9.0), 3).gradient));

    sg_out_normal = vec4(sg_resolve(m_base_normal, m_ribs + m_grain), 1.0);
}

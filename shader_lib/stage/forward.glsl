// The lit picture: one directional light and a constant ambient term.
#ifndef SG_STAGE_FORWARD
#define SG_STAGE_FORWARD

#include "lighting/ggx.glsl"
#include "stage/frame_block.glsl"
#include "stage/view.glsl"

// Linear radiance towards the viewer.
vec3 sg_stage_forward(SgSurface surface, vec3 position, vec3 normal) {
    vec3 view = sg_stage_view(position);
    vec3 direct =
        sg_ggx(surface, normal, view, sg_frame_block.light_direction.xyz, sg_frame_block.light_radiance.rgb);
    vec3 f0 = mix(vec3(0.04), surface.base_color, surface.metallic);
    vec3 ambient_albedo = mix(surface.base_color, f0, surface.metallic);
    vec3 ambient = surface.occlusion * ambient_albedo * sg_frame_block.ambient_radiance.rgb;
    return direct + ambient + surface.emission;
}

#endif

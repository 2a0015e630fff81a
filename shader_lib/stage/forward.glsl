// What the frame block says of the light; the generated text hands it to a model of lighting/.
#ifndef SG_STAGE_FORWARD
#define SG_STAGE_FORWARD

#include "lighting/lights.glsl"
#include "stage/frame_block.glsl"
#include "stage/view.glsl"

// position: of the pixel, relative world space.
SgLights sg_stage_lights(vec3 position) {
    return SgLights(sg_stage_view(position), sg_frame_block.light_direction.xyz, sg_frame_block.light_radiance.rgb,
                    sg_frame_block.ambient_radiance.rgb);
}

#endif

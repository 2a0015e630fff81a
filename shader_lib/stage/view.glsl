// Where the viewer is.
#ifndef SG_STAGE_VIEW
#define SG_STAGE_VIEW

#include "stage/frame_block.glsl"

// Unit, towards the viewer. position: relative world space, not the camera's own. Orthographic cameras see along one
// direction; of the two terms one is 0.
vec3 sg_stage_view(vec3 position) {
    vec3 away = sg_frame_block.camera_position.w * position + sg_frame_block.view_direction.xyz;
    return -away * inversesqrt(dot(away, away));
}

#endif

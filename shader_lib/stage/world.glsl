// The pixel in absolute world space.
#ifndef SG_STAGE_WORLD
#define SG_STAGE_WORLD

#include "stage/frame_block.glsl"
#include "stage/fragment.glsl"

// The place in absolute world space; its derivatives are those of the position, which far from the origin is rounded
// less. position: relative world space.
SgVolume sg_stage_volume_in_world(vec3 position) {
    SgVolume relative = sg_stage_volume(position);
    return SgVolume(relative.p + sg_frame_block.camera_position.xyz, relative.dx, relative.dy);
}

#endif

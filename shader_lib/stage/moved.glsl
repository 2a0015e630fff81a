// The surface that parallax found: its frame and its place in other spaces, without derivative instructions.
#ifndef SG_STAGE_MOVED
#define SG_STAGE_MOVED

#include "stage/object_block.glsl"
#include "stage/view.glsl"
#include "surfgrad/analytic_derivatives.glsl"
#include "surfgrad/volume.glsl"

// The frame of the surface through `position`. n: unit; facing: -1 where n points away, the back of a "flip" surface.
SgFrame sg_stage_frame_rebuilt(vec3 position, vec3 n, float facing) {
    return sg_frame_rebuilt(position, n, facing, sg_stage_view(position), sg_frame_block.relative_from_screen,
                            sg_frame_block.clip_from_relative);
}

// The frame's point in absolute world space, with its footprint.
SgVolume sg_stage_world_volume(SgFrame frame) {
    return SgVolume(frame.position + sg_frame_block.camera_position.xyz, frame.dpdx, frame.dpdy);
}

// The frame's point in object space, with its footprint; of a matrix that flattens the host
// hands over cofactors (artefacts.md), so that it is finite and means nothing.
SgVolume sg_stage_object_volume(SgFrame frame) {
    mat3 rows = mat3(sg_object_block.normal_from_object);  // v * rows = M^-1 v
    vec3 from_origin = frame.position - sg_object_block.relative_from_object[3].xyz;
    return SgVolume(from_origin * rows, frame.dpdx * rows, frame.dpdy * rows);
}

#endif

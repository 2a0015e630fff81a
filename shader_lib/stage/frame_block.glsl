// Set 0, binding 0: what is constant over a frame. Field by field in compiler/artefacts.md; a test compares both.
#ifndef SG_STAGE_FRAME_BLOCK
#define SG_STAGE_FRAME_BLOCK

layout(set = 0, binding = 0, std140) uniform SgFrameBlock {
    mat4 clip_from_relative;
    mat4 relative_from_screen;
    vec4 camera_position;
    vec4 view_direction;
    vec4 light_direction;
    vec4 light_radiance;
    vec4 ambient_radiance;
    vec4 time_view;
} sg_frame_block;

#endif

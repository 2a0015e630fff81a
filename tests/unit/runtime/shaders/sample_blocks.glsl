// The blocks of compiler/artefacts.md, for the hand-written sample material.
layout(set = 0, binding = 0, std140) uniform SgFrameBlock {
    mat4 clip_from_relative;
    mat4 relative_from_screen;
    vec4 camera_position;
    vec4 view_direction;
    vec4 light_direction;
    vec4 light_radiance;
    vec4 ambient_radiance;
    vec4 time_view;
} frame;

// The debug entry: a uniform selects what is shown. The generated text calls sg_stage_view_value once per view.
#ifndef SG_STAGE_DEBUG
#define SG_STAGE_DEBUG

#include "stage/frame_block.glsl"

// `value` where the frame block asks for view `number`, else what was there before.
vec4 sg_stage_select(vec4 before, float number, vec3 value) {
    return abs(sg_frame_block.time_view.y - number) < 0.5 ? vec4(value, 1.0) : before;
}
// The same for values of four components; their pictures have no alpha to mark coverage with.
vec4 sg_stage_select(vec4 before, float number, vec4 value) {
    return abs(sg_frame_block.time_view.y - number) < 0.5 ? value : before;
}

#endif

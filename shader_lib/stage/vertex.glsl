// The vertex stage: from object space to relative world space. The generated text declares inputs and outputs.
#ifndef SG_STAGE_VERTEX
#define SG_STAGE_VERTEX

#include "stage/frame_block.glsl"
#include "stage/object_block.glsl"

// A direction of unit length; a zero vector stays zero.
vec3 sg_stage_unit(vec3 v) {
    float square = dot(v, v);
    return square > 0.0 ? v * inversesqrt(square) : v;
}

// Object space to relative world space, world units.
vec3 sg_stage_position(vec3 position) { return (sg_object_block.relative_from_object * vec4(position, 1.0)).xyz; }

// The unit normal in world axes; the inverse transpose keeps it perpendicular under non-uniform scale.
vec3 sg_stage_normal(vec3 normal) { return sg_stage_unit(mat3(sg_object_block.normal_from_object) * normal); }

// The unit tangent in world axes; w keeps B = w * cross(N, T) towards +t in mirrored instances.
vec4 sg_stage_tangent(vec4 tangent) {
    vec3 direction = sg_stage_unit(mat3(sg_object_block.relative_from_object) * tangent.xyz);
    return vec4(direction, tangent.w * sg_object_block.normal_from_object[3][3]);
}

vec4 sg_stage_clip(vec3 relative_position) {
    return sg_frame_block.clip_from_relative * vec4(relative_position, 1.0);
}

#endif

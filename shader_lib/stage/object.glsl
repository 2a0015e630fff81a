// The object's and the frame's block, as the fragment stage reads them: spaces and time.
#ifndef SG_STAGE_OBJECT
#define SG_STAGE_OBJECT

#include "stage/frame_block.glsl"
#include "stage/object_block.glsl"

// Seconds.
float sg_stage_time() { return sg_frame_block.time_view.x; }

// A normal of the surface in object space. n: unit, world axes. Result: unit.
vec3 sg_stage_object_normal(vec3 n) {
    vec3 local = n * mat3(sg_object_block.relative_from_object);  // M^T n: the inverse of the inverse transpose
    return local * inversesqrt(max(dot(local, local), 1e-30));
}

// An object-space normal in world axes. v: any length. Result: any length.
vec3 sg_stage_normal_from_object(vec3 v) { return mat3(sg_object_block.normal_from_object) * v; }

// The gradient of a height on object space, in world axes: M^-T gradient. Of a matrix that flattens it lies along the
// normal and bumps nothing.
vec3 sg_stage_gradient_from_object(vec3 gradient) { return mat3(sg_object_block.normal_from_object) * gradient; }

#endif

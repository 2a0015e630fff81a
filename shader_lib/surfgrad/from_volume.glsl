// Surface gradients from heights that are defined on a volume. Source: Mikkelsen 2020, section 3.6, Eq 6.
#ifndef SG_FROM_VOLUME
#define SG_FROM_VOLUME

#include "surfgrad/frame.glsl"

// Rounding leaves a 4e-7th of a gradient along n, whatever it should be; beyond this length that would reach n itself.
const float SG_MAX_VOLUME_GRADIENT = 16384.0;

// The surface gradient of a volume bump: the gradient's projection onto the tangent plane.
//   n: unit base normal; gradient: of the height, shading space, world units of height per world unit.
// Result: perpendicular to n; linear up to components of 16384 (89.997 degrees), which the largest is cut to; 0 for a
// gradient along n. Cost: 14 instructions. Source: Listing 8.
vec3 sg_surfgrad_from_volume(vec3 n, vec3 gradient) {
    float largest = max(max(abs(gradient.x), abs(gradient.y)), max(abs(gradient.z), SG_MAX_VOLUME_GRADIENT));
    return sg_reject(SG_MAX_VOLUME_GRADIENT / largest * gradient, n);
}

#endif

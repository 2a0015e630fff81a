// Surface gradients from heights that are defined on a volume. Source: Mikkelsen 2020, section 3.6, Eq 6.
#ifndef SG_FROM_VOLUME
#define SG_FROM_VOLUME

#include "surfgrad/frame.glsl"

// Rounding leaves a 4e-7th of a gradient along n, whatever it should be; beyond this length that would reach n itself.
const float SG_MAX_VOLUME_GRADIENT = 16384.0;

// The surface gradient of a volume bump: the gradient's projection onto the tangent plane.
//   n: unit base normal; gradient: of the height, shading space, world units of height per world unit.
// Result: perpendicular to n; linear up to a length of 16384 (89.997 degrees), which longer gradients are cut to; 0 for a
// gradient along n. Cost: 19 instructions. Source: Listing 8.
vec3 sg_surfgrad_from_volume(vec3 n, vec3 gradient) {
    float square = dot(gradient, gradient);
    bool modest = square <= SG_MAX_VOLUME_GRADIENT * SG_MAX_VOLUME_GRADIENT;
    vec3 cut = modest ? gradient : SG_MAX_VOLUME_GRADIENT * inversesqrt(square) * gradient;
    return sg_reject(cut, n);
}

#endif

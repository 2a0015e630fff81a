// Tangent-space normals and derivatives. d = (dH/du, dH/dv) along +s and +t.
#pragma once

#include "ir/reference/checked.hpp"

namespace sg::ref {

inline constexpr double kMaxSlope = 128.0;

// A stored value 0..1 to -1..1; zero: the 8-bit code that means 0.
double decode_signed(double texel, double zero);
dvec2 deriv_from_normal_xyz(dvec3 m);
dvec2 deriv_from_normal_xy(dvec2 m);
dvec2 deriv_green_up(dvec2 d);
dvec3 normal_from_deriv(dvec2 d);
// A derivative map stores d / range as a signed value.
dvec2 deriv_from_map(dvec2 value, double range);
dvec2 map_from_deriv(dvec2 d, double range);
// d with each component within the steepest slope; what is not a number counts as flat.
dvec2 deriv_clamped(dvec2 d);

}  // namespace sg::ref

// Functions that a GPU leaves undefined outside their domain. In double precision they are asserted: a
// reference that steps out of the domain is wrong, whatever a driver makes of it.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "base/ice.hpp"

namespace sg::ref {

using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

inline double power(double base, double exponent) {
    SG_ASSERT(base > 0.0);
    return std::pow(base, exponent);
}

inline double root(double square) {
    SG_ASSERT(square >= 0.0);
    return std::sqrt(square);
}

// The unit vector along v. v: neither zero nor infinite.
inline dvec3 normalized(dvec3 v) {
    double length = std::hypot(v.x, v.y, v.z);
    SG_ASSERT(length > 0.0 && std::isfinite(length));
    return v / length;
}

}  // namespace sg::ref

// The surface gradient of a height that is defined on a volume.
#pragma once

#include "ir/reference/checked.hpp"

namespace sg::ref {

inline constexpr double kMaxVolumeGradient = 16384.0;

dvec3 surfgrad_from_volume(dvec3 n, dvec3 gradient);

}  // namespace sg::ref

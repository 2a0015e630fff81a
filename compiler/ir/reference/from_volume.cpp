#include "ir/reference/from_volume.hpp"

#include <algorithm>

namespace sg::ref {

// The slopes along two perpendicular directions of the tangent plane.
dvec3 surfgrad_from_volume(dvec3 n, dvec3 gradient) {
    const double largest = std::max({std::abs(gradient.x), std::abs(gradient.y), std::abs(gradient.z)});
    const dvec3 cut = largest > kMaxVolumeGradient ? gradient * (kMaxVolumeGradient / largest) : gradient;
    const dvec3 least = std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 along = normalized(glm::cross(n, least));
    const dvec3 across = normalized(glm::cross(n, along));
    return along * glm::dot(along, cut) + across * glm::dot(across, cut);
}

}  // namespace sg::ref

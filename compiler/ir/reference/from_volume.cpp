#include "ir/reference/from_volume.hpp"

namespace sg::ref {

// The slopes along two perpendicular directions of the tangent plane.
dvec3 surfgrad_from_volume(dvec3 n, dvec3 gradient) {
    const double length = std::hypot(gradient.x, gradient.y, gradient.z);
    const dvec3 cut = length > kMaxVolumeGradient ? gradient * (kMaxVolumeGradient / length) : gradient;
    const dvec3 least = std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 along = normalized(glm::cross(n, least));
    const dvec3 across = normalized(glm::cross(n, along));
    return along * glm::dot(along, cut) + across * glm::dot(across, cut);
}

}  // namespace sg::ref

#include "ir/reference/volume_space.hpp"

#include <algorithm>
#include <cmath>

namespace sg::ref {

glm::dvec3 gradient_to_world(const glm::dmat3& world_from_object, glm::dvec3 gradient) {
    const double volume = std::abs(glm::determinant(world_from_object));
    const double box = glm::length(world_from_object[0]) * glm::length(world_from_object[1]) *
                       glm::length(world_from_object[2]);
    if (!(volume > 1e-6 * box)) return glm::dvec3(0.0);
    return glm::transpose(glm::inverse(world_from_object)) * gradient;
}

double footprint(glm::dvec3 dpdx, glm::dvec3 dpdy) {
    return std::max(glm::length(dpdx), glm::length(dpdy));
}

}  // namespace sg::ref

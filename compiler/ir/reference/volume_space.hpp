// Gradients and footprints between the space of a volume bump map and shading space, in double precision.
#pragma once

#include <glm/glm.hpp>

namespace sg::ref {

// The gradient with respect to M v of a function whose gradient with respect to v is given; zero if M
// flattens.
glm::dvec3 gradient_to_world(const glm::dmat3& world_from_object, glm::dvec3 gradient);
// The longer of the two.
double footprint(glm::dvec3 dpdx, glm::dvec3 dpdy);

}  // namespace sg::ref

// Surface gradients from normals that are already perturbed.
#pragma once

#include "ir/reference/frame.hpp"

namespace sg::ref {

inline constexpr double kMaxSurfgrad = 128.0;

dvec3 surfgrad_from_normal(dvec3 n, dvec3 v);
dvec3 normal_from_object(const dmat3& normal_from_object, dvec3 v);

}  // namespace sg::ref

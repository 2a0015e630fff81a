#include "ir/reference/from_normal.hpp"

namespace sg::ref {

// v leans away from the line of n by an angle; the surface rises against the lean with the slope tan(angle).
dvec3 surfgrad_from_normal(dvec3 n, dvec3 v) {
    const dvec3 lean = reject(v, n);
    const double across = glm::length(lean);
    if (across == 0.0) return dvec3(0.0);
    const double angle = std::atan2(across, std::abs(glm::dot(n, v)));
    const double slope = angle < std::atan(kMaxSurfgrad) ? std::tan(angle) : kMaxSurfgrad;
    return -slope * normalized(lean);
}

dvec3 normal_from_object(const dmat3& matrix, dvec3 v) {
    const dmat3 rows = glm::transpose(matrix);
    return {glm::dot(rows[0], v), glm::dot(rows[1], v), glm::dot(rows[2], v)};
}

}  // namespace sg::ref

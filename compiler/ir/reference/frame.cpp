#include "ir/reference/frame.hpp"

#include <algorithm>

namespace sg::ref {
namespace {

bool has_direction(dvec3 v) {
    const double length = std::hypot(v.x, v.y, v.z);
    return length > 1e-15 && length < 1e15;
}

}  // namespace

// Turning v about n by a right angle twice, back and forth, loses its part along n.
dvec3 reject(dvec3 v, dvec3 n) {
    return glm::cross(n, glm::cross(v, n));
}

Frame frame(dvec3 position, dvec3 dpdx, dvec3 dpdy, dvec3 n) {
    const double volume = glm::determinant(dmat3(dpdx, dpdy, n));
    return {position, n, dpdx, dpdy, reject(dpdx, n), reject(dpdy, n), volume < 0.0 ? -1.0 : 1.0};
}

double frame_inverse_area(const Frame& frame) {
    const double area = glm::determinant(dmat3(frame.dpdx, frame.dpdy, frame.normal));
    auto largest = [](dvec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
    const bool spanned = std::abs(area) > 1e-5 * largest(frame.dpdx) * largest(frame.dpdy);
    return spanned ? 1.0 / area : 0.0;
}

Frame frame_resolved(const Frame& before, dvec3 n) {
    Frame after = frame(before.position, before.dpdx, before.dpdy, n);
    after.flip_sign = before.flip_sign;
    return after;
}

dvec3 base_normal(dvec3 vertex_normal) {
    return has_direction(vertex_normal) ? normalized(vertex_normal) : dvec3(0.0, 0.0, 1.0);
}

dvec3 mirror_normal(dvec3 n, double facing) {
    return facing < 0.0 ? -n : n;
}

}  // namespace sg::ref

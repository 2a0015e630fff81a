#include "ir/reference/deriv.hpp"

#include <algorithm>

namespace sg::ref {

double decode_signed(double texel, double zero) {
    // The line through (zero code, 0) whose nearer end of 0..255 is at distance 1.
    const double nearer = std::min(std::abs(zero), std::abs(255.0 - zero));
    return std::clamp((texel * 255.0 - zero) / nearer, -1.0, 1.0);
}

// The normal leans by an angle whose tangent is the slope; leaning inward counts as leaning outward. A lean
// beyond the steepest slope keeps its direction in the texture plane.
dvec2 deriv_from_normal_xyz(dvec3 m) {
    const double across = std::hypot(m.x, m.y);
    if (across == 0.0) return {0.0, 0.0};
    const dvec2 direction = dvec2(m) / across;
    const double largest = std::max(std::abs(direction.x), std::abs(direction.y));
    const double lean = std::atan2(across, std::abs(m.z));
    const double steepest = std::atan(kMaxSlope / largest);
    const double slope = lean < steepest ? std::tan(lean) : kMaxSlope / largest;
    return -direction * slope;
}

// sin(lean) = |m|: slope = sin / cos, with the cosine kept above 1/128.
dvec2 deriv_from_normal_xy(dvec2 m) {
    const double across = std::hypot(m.x, m.y);
    const double cosine = across < 1.0 ? std::cos(std::asin(across)) : 0.0;
    return -m / std::max(cosine, 1.0 / kMaxSlope);
}

dvec2 deriv_green_up(dvec2 d) {
    return {d.x, -d.y};
}

// The normal of the graph (u, v, H): the cross product of its two tangents.
dvec3 normal_from_deriv(dvec2 d) {
    return normalized(glm::cross(dvec3(1, 0, d.x), dvec3(0, 1, d.y)));
}

dvec2 deriv_clamped(dvec2 d) {
    auto one = [](double x) { return std::isnan(x) ? 0.0 : std::clamp(x, -kMaxSlope, kMaxSlope); };
    return {one(d.x), one(d.y)};
}

dvec2 deriv_from_map(dvec2 value, double range) {
    return deriv_clamped(value * range);
}

dvec2 map_from_deriv(dvec2 d, double range) {
    auto one = [&](double x) { return std::clamp(x / range, -1.0, 1.0); };
    return {one(d.x), one(d.y)};
}

}  // namespace sg::ref

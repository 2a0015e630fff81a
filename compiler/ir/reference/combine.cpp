#include "ir/reference/combine.hpp"

#include "ir/reference/deriv.hpp"

namespace sg::ref {

dvec3 combine_add(dvec3 a, dvec3 b) {
    return a + b;
}
dvec3 combine_scale(dvec3 g, double strength) {
    return g * strength;
}
dvec3 combine_mask(dvec3 g, double mask) {
    if (!(mask > 0.0)) return dvec3(0.0);
    return mask < 1.0 ? g * mask : g;
}

dvec3 combine_mix(dvec3 a, dvec3 b, double t) {
    if (!(t > 0.0)) return a;
    return t < 1.0 ? a + (b - a) * t : b;
}

dvec3 combine_pd(dvec3 a, dvec3 b) {
    return combine_weighted(a, b, dvec2(1.0));
}

// normalize(a.xy + b.xy, a.z b.z) is the normal of the slope -(a.xy + b.xy) / (a.z b.z): one share for each
// map.
DerivPair combine_whiteout(dvec3 a, dvec3 b) {
    return {deriv_from_normal_xyz(dvec3(dvec2(a) / b.z, a.z)),
            deriv_from_normal_xyz(dvec3(dvec2(b) / a.z, b.z))};
}

DerivPair combine_udn(dvec3 a, dvec3 b) {
    return {deriv_from_normal_xyz(a), deriv_from_normal_xyz(dvec3(b.x, b.y, a.z))};
}

// The rotation about (0, 0, 1) x a that takes (0, 0, 1) to a, by Rodrigues' formula, applied to b.
dvec3 combine_rnm(dvec3 a, dvec3 b) {
    const dvec3 unit = normalized(dvec3(a.x, a.y, std::abs(a.z)));
    const dvec3 turned_axis = glm::cross(dvec3(0, 0, 1), unit);
    const double sine = glm::length(turned_axis), cosine = unit.z;
    if (sine == 0.0) return b;
    const dvec3 axis = turned_axis / sine;
    return b * cosine + glm::cross(axis, b) * sine + axis * glm::dot(axis, b) * (1.0 - cosine);
}

dvec3 combine_weighted(dvec3 a, dvec3 b, dvec2 weights) {
    return normal_from_deriv(weights.x * deriv_from_normal_xyz(a) + weights.y * deriv_from_normal_xyz(b));
}

// z = 0 makes a slope endless: the steeper map decides alone, and of two such neither.
dvec3 combine_additive(dvec3 a, dvec3 b) {
    if (a.z > 0.0 && b.z > 0.0) return normalized(dvec3(dvec2(a) / a.z + dvec2(b) / b.z, 1.0));
    if (a.z > 0.0) return normalized(dvec3(b.x, b.y, 0.0));
    return b.z > 0.0 ? normalized(dvec3(a.x, a.y, 0.0)) : dvec3(0, 0, 1);
}

}  // namespace sg::ref

#include "ir/reference/combine.hpp"

#include "ir/reference/deriv.hpp"
#include "ir/reference/from_normal.hpp"
#include "ir/reference/resolve.hpp"

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

namespace {

// The rotation about from x to that takes one unit vector to another, by Rodrigues' formula, applied to v.
dvec3 turned(dvec3 from, dvec3 to, dvec3 v) {
    const dvec3 turned_axis = glm::cross(from, to);
    const double sine = glm::length(turned_axis), cosine = glm::dot(from, to);
    if (sine == 0.0) return v;
    const dvec3 axis = turned_axis / sine;
    return v * cosine + glm::cross(axis, v) * sine + axis * glm::dot(axis, v) * (1.0 - cosine);
}

}  // namespace

dvec3 combine_rnm(dvec3 a, dvec3 b) {
    return turned(dvec3(0, 0, 1), normalized(dvec3(a.x, a.y, std::abs(a.z))), b);
}

dvec3 combine_reoriented(dvec3 n, dvec3 a, dvec3 b) {
    return surfgrad_from_normal(n, turned(n, resolve(n, a), resolve(n, b)));
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

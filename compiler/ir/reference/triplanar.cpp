#include "ir/reference/triplanar.hpp"

#include <algorithm>
#include <array>

namespace sg::ref {
namespace {

// The images of the unit vectors along s and t in space: st = (dot(s, p), dot(t, p)).
struct Plane {
    dvec3 s, t;
};

Plane plane_of(int axis, Hand hand, Origin origin) {
    const double z = hand == Hand::left ? 1.0 : -1.0;
    const std::array<Plane, 3> upright = {
        {{{0, 0, z}, {0, 1, 0}}, {{1, 0, 0}, {0, 0, z}}, {{1, 0, 0}, {0, 1, 0}}}};
    Plane plane = upright[static_cast<std::size_t>(axis)];
    if (origin == Origin::upper_left) plane.t = -plane.t;
    return plane;
}

}  // namespace

dvec3 triplanar_weights(dvec3 n, double k) {
    dvec3 shown(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const double above = std::abs(n[axis]) - 0.2;
        if (above > 0.0) shown[axis] = above;
    }
    const double largest = std::max({shown.x, shown.y, shown.z});
    if (!(largest > 0.0)) return {0.0, 0.0, 1.0};
    dvec3 w(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        if (shown[axis] > 0.0) w[axis] = power(shown[axis] / largest, k);
    }
    return w / (w.x + w.y + w.z);
}

Uv planar_uv(dvec3 p, dvec3 dpdx, dvec3 dpdy, int axis, Hand hand, Origin origin) {
    const Plane plane = plane_of(axis, hand, origin);
    auto seen = [&](dvec3 v) { return dvec2(glm::dot(plane.s, v), glm::dot(plane.t, v)); };
    return {seen(p), seen(dpdx), seen(dpdy)};
}

TriplanarUv triplanar_uv(dvec3 p, dvec3 dpdx, dvec3 dpdy, Hand hand, Origin origin) {
    return {planar_uv(p, dpdx, dpdy, 0, hand, origin), planar_uv(p, dpdx, dpdy, 1, hand, origin),
            planar_uv(p, dpdx, dpdy, 2, hand, origin)};
}

dvec3 planar_gradient(dvec2 d, int axis, Hand hand, Origin origin) {
    const Plane plane = plane_of(axis, hand, origin);
    return d.x * plane.s + d.y * plane.t;
}

dvec3 triplanar_gradient(dvec3 weights, dvec2 d_x, dvec2 d_y, dvec2 d_z, Hand hand, Origin origin) {
    return weights.x * planar_gradient(d_x, 0, hand, origin) +
           weights.y * planar_gradient(d_y, 1, hand, origin) +
           weights.z * planar_gradient(d_z, 2, hand, origin);
}

}  // namespace sg::ref

#include "ir/reference/analytic_derivatives.hpp"

namespace sg::ref {
namespace {

dvec3 unproject(const dmat4& relative_from_screen, dvec2 pixel, double depth) {
    const dvec4 q = relative_from_screen * dvec4(pixel, depth, 1.0);
    return dvec3(q) / q.w;
}

}  // namespace

dvec3 facing_normal(dvec3 n, dvec3 view) {
    const double towards = glm::dot(n, view);
    return towards < 0.0 ? reject(n, view) - towards * view : n;
}

dvec3 plane_under_pixel(dvec3 position, dvec3 n, const dmat4& relative_from_screen, dvec2 pixel) {
    // Two points of the pixel's ray; depth 0 and 1 may lie at infinity, these never do.
    const dvec3 a = unproject(relative_from_screen, pixel, 0.25);
    const dvec3 b = unproject(relative_from_screen, pixel, 0.75);
    const dvec3 ray = b - a;
    return a + ray * (glm::dot(n, position - a) / glm::dot(n, ray));
}

// Central differences of the intersection. A pixel changes the footprint by a small part of itself only, so that a
// thousandth of a pixel leaves a relative error near 1e-8.
ScreenDerivatives analytic_derivatives(dvec3 position, dvec3 n, const dmat4& relative_from_screen) {
    const dvec4 screen = glm::inverse(relative_from_screen) * dvec4(position, 1.0);
    const dvec2 pixel = dvec2(screen) / screen.w;
    const double step = 1e-3;
    auto along = [&](dvec2 axis) {
        return (plane_under_pixel(position, n, relative_from_screen, pixel + step * axis) -
                plane_under_pixel(position, n, relative_from_screen, pixel - step * axis)) /
               (2.0 * step);
    };
    return {along({1.0, 0.0}), along({0.0, 1.0})};
}

Frame frame_rebuilt(dvec3 position, dvec3 n, double facing, dvec3 view, const dmat4& relative_from_screen) {
    const dvec3 plane = facing_normal(facing * n, view);
    const ScreenDerivatives d = analytic_derivatives(position, plane, relative_from_screen);
    Frame out = frame(position, d.dpdx, d.dpdy, n);
    out.flip_sign = facing * frame(position, d.dpdx, d.dpdy, plane).flip_sign;
    return out;
}

}  // namespace sg::ref

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

namespace {

// Where the ray of a pixel meets the plane through `position`, as an offset from it. Two points of the ray,
// at the position's own depth and halfway to the middle of the range: neither lies at infinity.
dvec3 plane_offset(dvec3 position, dvec3 n, const dmat4& relative_from_screen, dvec3 screen) {
    const dvec3 at = unproject(relative_from_screen, dvec2(screen), screen.z) - position;
    const dvec3 ray = unproject(relative_from_screen, dvec2(screen), 0.5 * (screen.z + 0.5)) - position - at;
    return at - ray * (glm::dot(n, at) / glm::dot(n, ray));
}

}  // namespace

// Central differences over a tenth and a fifth of a pixel, extrapolated: the error is of fourth order in the
// part by which a pixel changes the footprint, below 1e-8, and rounding is 1e-16 of the distance over a tenth
// of a pixel.
ScreenDerivatives analytic_derivatives(dvec3 position, dvec3 n, const dmat4& relative_from_screen) {
    const dvec4 clip = glm::inverse(relative_from_screen) * dvec4(position, 1.0);
    const dvec3 screen = dvec3(clip) / clip.w;
    auto difference = [&](dvec3 axis, double step) {
        return (plane_offset(position, n, relative_from_screen, screen + step * axis) -
                plane_offset(position, n, relative_from_screen, screen - step * axis)) /
               (2.0 * step);
    };
    auto along = [&](dvec3 axis) { return (4.0 * difference(axis, 0.1) - difference(axis, 0.2)) / 3.0; };
    return {along({1.0, 0.0, 0.0}), along({0.0, 1.0, 0.0})};
}

Frame frame_rebuilt(dvec3 position, dvec3 n, double facing, dvec3 view, const dmat4& relative_from_screen) {
    const dvec3 plane = facing_normal(facing * n, view);
    const ScreenDerivatives d = analytic_derivatives(position, plane, relative_from_screen);
    return frame(position, d.dpdx, d.dpdy, n);
}

}  // namespace sg::ref

#include "ir/reference/from_height.hpp"

namespace sg::ref {

// Three conditions make g: its slopes along the two steps of a pixel, and that it lies in the tangent plane.
dvec3 surfgrad_from_screen_height(const Frame& frame, dvec2 dh) {
    const dmat3 rows = glm::transpose(dmat3(frame.sigma_x, frame.sigma_y, frame.normal));
    const double area = std::abs(glm::determinant(rows));
    if (!(area > 1e-5 * glm::length(frame.dpdx) * glm::length(frame.dpdy))) return dvec3(0.0);
    return glm::inverse(rows) * dvec3(dh, 0.0);
}

dvec2 screen_height_from_deriv(const Uv& uv, dvec2 dim, dvec2 d) {
    const glm::dmat2 texels_per_pixel(dim * uv.dx, dim * uv.dy);
    return d * texels_per_pixel;
}

dvec3 surfgrad_from_height(const Frame& frame, const Uv& uv, dvec2 dim, dvec2 d) {
    return surfgrad_from_screen_height(frame, screen_height_from_deriv(uv, dim, d));
}

dvec2 screen_height_three_tap(const TextureSource& height, const Sampler& sampler, const Uv& uv) {
    auto at = [&](dvec2 st) { return sample_grad(height, sampler, st, uv.dx, uv.dy).x; };
    return {at(uv.st + uv.dx) - at(uv.st), at(uv.st + uv.dy) - at(uv.st)};
}

}  // namespace sg::ref

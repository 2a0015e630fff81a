#include "ir/reference/uv.hpp"

#include <algorithm>
#include <complex>

namespace sg::ref {

Uv uv_scale(const Uv& uv, dvec2 scale) {
    return uv_transform(uv, scale, 0.0, dvec2(0.0));
}

// s + i t: a turn is a product with a unit complex number. The derivative of an affine map is its linear
// part.
Uv uv_transform(const Uv& uv, dvec2 scale, double rotation, dvec2 offset) {
    const std::complex<double> turn = std::polar(1.0, rotation);
    auto linear = [&](dvec2 v) {
        const std::complex<double> z = turn * std::complex<double>(scale.x * v.x, scale.y * v.y);
        return dvec2(z.real(), z.imag());
    };
    return {linear(uv.st) + offset, linear(uv.dx), linear(uv.dy)};
}

bool is_degenerate(const Uv& uv) {
    auto largest = [](dvec2 v) { return std::max(std::abs(v.x), std::abs(v.y)); };
    const double area = std::abs(glm::determinant(glm::dmat2(uv.dx, uv.dy)));
    return !(area > 1e-6 * largest(uv.dx) * largest(uv.dy));
}

double uv_level(const Uv& uv, dvec2 dim) {
    const double texels =
        std::max(std::hypot(dim.x * uv.dx.x, dim.y * uv.dx.y), std::hypot(dim.x * uv.dy.x, dim.y * uv.dy.y));
    return std::log2(std::max(texels, 1e-12));
}

}  // namespace sg::ref

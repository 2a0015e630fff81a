#include "ir/reference/height_map.hpp"

#include <algorithm>

namespace sg::ref {
namespace {

// The Sobel derivative at one inner texel: differences of neighbours, the middle line counted twice.
dvec2 sobel(const Heights4x4& h, std::size_t row, std::size_t column) {
    auto across = [&](std::size_t r) { return (h[r][column + 1] - h[r][column - 1]) / 2.0; };
    auto down = [&](std::size_t c) { return (h[row + 1][c] - h[row - 1][c]) / 2.0; };
    return {(across(row - 1) + 2.0 * across(row) + across(row + 1)) / 4.0,
            (down(column - 1) + 2.0 * down(column) + down(column + 1)) / 4.0};
}

}  // namespace

dvec2 deriv_from_height_level(const TextureSource& height, const Sampler& sampler, dvec2 st, double level) {
    const double lod = level > 0.0 ? level : 0.0;
    const double texels = std::exp2(lod);
    const dvec2 step = texels / dvec2(height.size(0));
    auto at = [&](double s, double t) { return sample_lod(height, sampler, st + dvec2(s, t), lod).x; };
    return dvec2(at(step.x, 0.0) - at(0.0, 0.0), at(0.0, step.y) - at(0.0, 0.0)) / texels;
}

dvec2 deriv_from_height(const TextureSource& height, const Sampler& sampler, const Uv& uv) {
    return deriv_from_height_level(height, sampler, uv.st, uv_level(uv, dvec2(height.size(0))));
}

dvec2 deriv_from_heights_4x4(const Heights4x4& heights, dvec2 t) {
    const dvec2 above = glm::mix(sobel(heights, 1, 1), sobel(heights, 1, 2), t.x);
    const dvec2 below = glm::mix(sobel(heights, 2, 1), sobel(heights, 2, 2), t.x);
    return glm::mix(above, below, t.y);
}

dvec2 deriv_from_height_smooth(const TextureSource& height, const Sampler& sampler, dvec2 st) {
    const dvec2 position = st * dvec2(height.size(0)) - 0.5;
    const dvec2 corner = glm::floor(position);
    Heights4x4 heights{};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            const glm::ivec2 texel = glm::ivec2(corner) + glm::ivec2(column - 1, row - 1);
            heights[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
                texel_at(height, sampler, texel, 0).x;
        }
    }
    return deriv_from_heights_4x4(heights, position - corner);
}

double height_smooth_weight(double level) {
    if (level <= 0.05) return 1.0;
    if (level >= 0.5) return 0.0;
    return 1.0 - (level - 0.05) / 0.45;
}

dvec2 deriv_from_height_hq(const TextureSource& height, const Sampler& sampler, const Uv& uv) {
    const double level = uv_level(uv, dvec2(height.size(0)));
    const double weight = height_smooth_weight(level);
    dvec2 sum(0.0);
    if (weight < 1.0) sum += (1.0 - weight) * deriv_from_height_level(height, sampler, uv.st, level);
    if (weight > 0.0) sum += weight * deriv_from_height_smooth(height, sampler, uv.st);
    return sum;
}

}  // namespace sg::ref

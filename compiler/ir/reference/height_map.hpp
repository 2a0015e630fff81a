// Derivatives straight from a height map, per texel of level 0.
#pragma once

#include <array>

#include "ir/reference/texture.hpp"
#include "ir/reference/uv.hpp"

namespace sg::ref {

dvec2 deriv_from_height_level(const TextureSource& height, const Sampler& sampler, dvec2 st, double level);
dvec2 deriv_from_height(const TextureSource& height, const Sampler& sampler, const Uv& uv);
// heights[row][column]
using Heights4x4 = std::array<std::array<double, 4>, 4>;
dvec2 deriv_from_heights_4x4(const Heights4x4& heights, dvec2 t);
dvec2 deriv_from_height_smooth(const TextureSource& height, const Sampler& sampler, dvec2 st);
double height_smooth_weight(double level);
dvec2 deriv_from_height_hq(const TextureSource& height, const Sampler& sampler, const Uv& uv);

}  // namespace sg::ref

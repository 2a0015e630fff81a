// Textures for the tests that read some.
#pragma once

#include <functional>

#include "harness.hpp"

namespace sg::proof {

// Red is height(u, v) at texel centres (u, v counted in texels of level 0), rounded to float. Further levels,
// if wanted, hold the height at their own texels' centres, so that an affine height is exact on all of them.
// Clamped at the edges.
std::shared_ptr<const CaseTexture> height_texture(glm::ivec2 size, bool levels,
                                                  const std::function<double(double u, double v)>& height);

// Four channels of fresh random numbers in 0..1 on every level.
std::shared_ptr<const CaseTexture> random_texture(glm::ivec2 size, bool levels, ref::Wrap wrap);

}  // namespace sg::proof

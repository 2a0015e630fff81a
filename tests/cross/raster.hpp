// A small rasteriser with the rules of Direct3D, Metal and Vulkan: positions rounded to 1/256 pixel, the
// top-left rule, perspective-correct varyings, quads of four pixels with helpers outside of the triangle.
#pragma once

#include "tests/cross/metal/driver.hpp"
#include "tests/cross/scene.hpp"

namespace sg::cross {

struct RasterVertex {
    float position[4];  // Metal's clip space: y up, depth 0 to 1
    SgNumbers varyings;
};

Pixels rasterise(const std::vector<RasterVertex>& vertices, const std::vector<std::uint32_t>& indices,
                 bool cull_back, const SgBindings& bindings, SgFragmentFunction fragment);

}  // namespace sg::cross

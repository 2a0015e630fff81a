// A small rasteriser with the rules of Direct3D, Metal and Vulkan: positions rounded to 1/256 pixel, the
// top-left rule, perspective-correct varyings, quads of four pixels with helpers outside of the triangle.
#pragma once

#include "tests/cross/metal.hpp"
#include "tests/cross/metal/driver.hpp"
#include "tests/cross/scene.hpp"

namespace sg::cross {

struct RasterVertex {
    float position[4];  // Metal's clip space: y up, depth 0 to 1
    SgNumbers varyings;
};

// Attributes and blocks of `drawing` were read before: of it the indices, the culling and the attachments.
MetalPicture rasterise(const std::vector<RasterVertex>& vertices, const Drawing& drawing,
                       const SgBindings& bindings, SgFragmentFunction fragment);

}  // namespace sg::cross

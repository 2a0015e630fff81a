// What a render gives: the entry point's numbers, pixel by pixel.
#pragma once

#include <vector>

#include "asset/image.hpp"

namespace sg::runtime {

struct Picture {
    asset::Image values;  // float32; exactly what the shader wrote, 0 where nothing was drawn
    std::vector<float>
        coverage;  // per pixel, from the depth buffer: 1 drawn, 0 background; between, after shrinking
};

// Averages factor x factor pixels into one: rgb over the drawn ones (alpha too where it is data), coverage
// over all. The sides must be multiples of the factor.
Picture shrink(const Picture& picture, std::uint32_t factor, bool alpha_is_data);

}  // namespace sg::runtime

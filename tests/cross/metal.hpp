// Metal texts, compiled as C++ against a shim of Metal's standard library and run on the processor.
#pragma once

#include "tests/cross/scene.hpp"

namespace sg::cross {

// "" or why they cannot be compiled here.
std::string metal_missing();

// A rasteriser of our own draws what the texts say, from the bindings that stand in them. The shim filters
// level 0 of a texture alone, so the picture to compare with is that of base_sample().
struct MetalPicture {
    Pixels pixels;
    std::vector<bool> on_edge;  // by pixel: its centre lies within 1/256 pixel of a facet's edge
};
std::vector<MetalPicture> metal_draw(const std::vector<Drawing>& drawings);

// "" or clang's words, by text; all in one run of clang.
std::vector<std::string> metal_refusals(const std::vector<std::string>& texts);

}  // namespace sg::cross

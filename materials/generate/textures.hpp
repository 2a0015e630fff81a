// The project's own sample textures, as bytes of PNG files.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace sg::samples {

// How a texture keeps its normals; the words are those of a material file's "textures".
struct TextureRecipe {
    std::string_view file;  // in materials/textures
    std::uint32_t size;     // texels per side
    double (*height)(double s, double t);
    bool two_channels;  // tangent_normal_xy: blue stays 0
    bool green_up;
    double zero;  // 127, 127.5 or 128
};
std::span<const TextureRecipe> texture_recipes();

// 8-bit RGBA PNG, alpha 255; the same bytes on every machine.
std::string make_texture(const TextureRecipe& recipe);

}  // namespace sg::samples

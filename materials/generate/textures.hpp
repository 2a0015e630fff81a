// The project's own sample textures, as bytes of PNG files.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace sg::samples {

// What the texels hold.
enum class Content {
    normal,      // tangent-space normals of the height
    height,      // the height, from `low` to `high` over 0..1, in all channels
    derivative,  // the derivative of the height, `high` over 1, in red and green
    parallax,    // n_z (2 h - 1) of the height over 0..1, signed, in all channels
    mask,        // 0 or 1 with soft borders, by a smooth noise of its own
    color,       // sRGB: dark where the height is low
    packed,      // a normal's x in alpha and y in green, as DXT5nm keeps them; the mask in red, the height in
                 // blue
    object_normal,  // object-space normals of the built-in sphere, displaced by the height (4 by 2 tiles over
                    // it)
};

// How a texture keeps its content; the words are those of a material file's "textures".
struct TextureRecipe {
    std::string_view file;  // in materials/textures
    std::uint32_t size;     // texels per side
    double (*height)(double s, double t);
    bool two_channels;  // tangent_normal_xy: blue stays 0
    bool green_up;
    double zero;  // 127, 127.5 or 128
    Content content = Content::normal;
    double low = 0.0, high = 1.0;
    bool wide = false;  // 16 bits per channel instead of 8
};
std::span<const TextureRecipe> texture_recipes();

// RGBA PNG, opaque unless packed; the same bytes on every machine.
std::string make_texture(const TextureRecipe& recipe);

}  // namespace sg::samples

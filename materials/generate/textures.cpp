#include "textures.hpp"

#include <array>
#include <cmath>

#include "asset/image.hpp"
#include "heights.hpp"

namespace sg::samples {
namespace {

constexpr std::array<TextureRecipe, 5> kRecipes{{
    {"brick_normal.png", 256, brick_height, false, true, 127.5},
    {"scratch_normal_xy.png", 256, scratch_height, true, false, 127.5},
    {"weave_normal.png", 128, weave_height, false, false, 128.0},
    {"ramp_normal.png", 256, ramp_height, false, true, 127.5},
    {"pebble_normal.png", 256, pebble_height, false, true, 127.0},
}};

constexpr int kSamples = 4;  // across the direction of the difference

struct Slope {
    double s = 0.0;
    double t = 0.0;
};

// The mean slope over one texel: exact along the difference, sampled across it.
Slope mean_slope(double (*height)(double, double), double s, double t, double texel) {
    Slope sum;
    for (int k = 0; k < kSamples; ++k) {
        const double across = ((k + 0.5) / kSamples - 0.5) * texel;
        sum.s += height(s + 0.5 * texel, t + across) - height(s - 0.5 * texel, t + across);
        sum.t += height(s + across, t + 0.5 * texel) - height(s + across, t - 0.5 * texel);
    }
    return {sum.s / (kSamples * texel), sum.t / (kSamples * texel)};
}

// The 8-bit code of `value` in [-1, 1], as a texel.
double encode(double value, double zero) {
    return (zero + value * (zero == 127.5 ? 127.5 : 127.0)) / 255.0;
}

}  // namespace

std::span<const TextureRecipe> texture_recipes() {
    return kRecipes;
}

std::string make_texture(const TextureRecipe& recipe) {
    asset::Image image = asset::make_image(recipe.size, recipe.size, asset::TexelFormat::unorm8);
    const double texel = 1.0 / recipe.size;
    for (std::uint32_t y = 0; y < recipe.size; ++y) {
        for (std::uint32_t x = 0; x < recipe.size; ++x) {
            const Slope slope = mean_slope(recipe.height, (x + 0.5) * texel, (y + 0.5) * texel, texel);
            const double length = std::sqrt(1.0 + slope.s * slope.s + slope.t * slope.t);
            const double green = recipe.green_up ? slope.t : -slope.t;  // up is against t
            image.set(x, y, 0, encode(-slope.s / length, recipe.zero));
            image.set(x, y, 1, encode(green / length, recipe.zero));
            image.set(x, y, 2, recipe.two_channels ? 0.0 : encode(1.0 / length, recipe.zero));
            image.set(x, y, 3, 1.0);
        }
    }
    return asset::png_bytes(image);
}

}  // namespace sg::samples

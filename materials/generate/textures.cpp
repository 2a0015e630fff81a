#include "textures.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "asset/image.hpp"
#include "heights.hpp"
#include "shaping.hpp"

namespace sg::samples {
namespace {

constexpr std::array<TextureRecipe, 21> kRecipes{{
    {"brick_normal.png", 256, brick_height, false, true, 127.5},
    {"scratch_normal_xy.png", 256, scratch_height, true, false, 127.5},
    {"weave_normal.png", 128, weave_height, false, false, 128.0},
    {"ramp_normal.png", 256, ramp_height, false, true, 127.5},
    {"pebble_normal.png", 256, pebble_height, false, true, 127.0},
    {"pebble_height.png", 128, pebble_height, false, true, 127.5, Content::height, 0.0, 0.04},
    {"pebble_parallax.png", 128, pebble_height, false, true, 128.0, Content::parallax, 0.0, 0.04},
    {"weave_derivative.png", 128, weave_height, true, false, 127.5, Content::derivative, 0.0, 4.0},
    {"weave_packed.png", 128, weave_height, true, false, 127.5, Content::packed, 0.0, 0.04},
    {"moss_mask.png", 64, pebble_height, false, true, 127.5, Content::mask},
    {"stone_color.png", 128, pebble_height, false, true, 127.5, Content::color, 0.0, 0.036},
    {"pebble_sphere_object.png", 128, pebble_height, false, true, 127.5, Content::object_normal},
    {"dome_normal.png", 128, dome_height, false, true, 127.5, Content::normal, 0.0, 1.0, true},
    {"dome_height.png", 128, dome_height, false, true, 127.5, Content::height, 0.0, 0.15, true},
    {"dome_normal_coarse.png", 32, dome_height, false, true, 127.5, Content::normal, 0.0, 1.0, true},
    {"dome_height_coarse.png", 32, dome_height, false, true, 127.5, Content::height, 0.0, 0.15, true},
    {"brick_height.png", 128, brick_height, false, true, 127.5, Content::height, 0.0, 0.02, true},
    {"ripple_normal.png", 128, ripple_height, false, true, 127.5},
    {"pebble_height_fine.png", 256, pebble_height, false, true, 127.5, Content::height, 0.0, 0.04, true},
    {"brick_parallax.png", 128, brick_height, false, true, 128.0, Content::parallax, 0.0, 0.02},
    {"rib_height.png", 128, rib_height, false, true, 127.5, Content::height, -0.02, 0.02, true},
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

using Rgb = std::array<double, 3>;

Rgb normal_texel(const TextureRecipe& recipe, double s, double t, double texel) {
    const Slope slope = mean_slope(recipe.height, s, t, texel);
    const double length = std::sqrt(1.0 + slope.s * slope.s + slope.t * slope.t);
    const double green = recipe.green_up ? slope.t : -slope.t;  // up is against t
    return {encode(-slope.s / length, recipe.zero), encode(green / length, recipe.zero),
            recipe.two_channels ? 0.0 : encode(1.0 / length, recipe.zero)};
}

Rgb derivative_texel(const TextureRecipe& recipe, double s, double t, double texel) {
    const Slope slope = mean_slope(recipe.height, s, t, texel);
    return {encode(slope.s / recipe.high, recipe.zero),
            encode((recipe.green_up ? -slope.t : slope.t) / recipe.high, recipe.zero), 0.0};
}

Rgb mask_texel(double s, double t) {
    const double noise = 0.7 * value_noise(s, t, 4, 71) + 0.3 * value_noise(s, t, 11, 72);
    const double covered = smooth(clamp01((noise - 0.42) / 0.16));
    return {covered, covered, covered};
}

Rgb color_texel(const TextureRecipe& recipe, double s, double t) {
    const double rise = clamp01((recipe.height(s, t) - recipe.low) / (recipe.high - recipe.low));
    const double grain = 0.08 * (value_noise(s, t, 40, 73) - 0.5);
    return {mix(0.30, 0.72, rise) + grain, mix(0.27, 0.68, rise) + grain, mix(0.22, 0.62, rise) + grain};
}

// n - grad_S H on the unit sphere of runtime/mesh, whose P_s and P_t are perpendicular.
Rgb sphere_texel(const TextureRecipe& recipe, double s, double t, double texel) {
    constexpr double kAmplitude = 0.5;  // world units per unit of the height
    const double a = 2.0 * std::numbers::pi * (s - 0.5), b = std::numbers::pi * t;
    const double sin_a = std::sin(a), cos_a = std::cos(a), sin_b = std::sin(b), cos_b = std::cos(b);
    const Slope slope = mean_slope(recipe.height, 4.0 * s, 2.0 * t, 4.0 * texel);
    const double along_s = kAmplitude * 4.0 * slope.s / (2.0 * std::numbers::pi * sin_b);
    const double along_t = kAmplitude * 2.0 * slope.t / std::numbers::pi;
    const double x = sin_b * sin_a - along_s * cos_a - along_t * cos_b * sin_a;
    const double y = cos_b + along_t * sin_b;
    const double z = sin_b * cos_a + along_s * sin_a - along_t * cos_b * cos_a;
    const double length = std::sqrt(x * x + y * y + z * z);
    return {encode(x / length, recipe.zero), encode(y / length, recipe.zero),
            encode(z / length, recipe.zero)};
}

Rgb texel_of(const TextureRecipe& recipe, double s, double t, double texel) {
    switch (recipe.content) {
        case Content::normal:
        case Content::packed:
            break;
        case Content::height: {
            const double h = (recipe.height(s, t) - recipe.low) / (recipe.high - recipe.low);
            return {h, h, h};
        }
        case Content::parallax: {
            const double h = (recipe.height(s, t) - recipe.low) / (recipe.high - recipe.low);
            const Slope slope = mean_slope(recipe.height, s, t, texel);
            const double n_z = 1.0 / std::sqrt(1.0 + slope.s * slope.s + slope.t * slope.t);
            const double v = encode(n_z * (2.0 * h - 1.0), recipe.zero);
            return {v, v, v};
        }
        case Content::derivative:
            return derivative_texel(recipe, s, t, texel);
        case Content::mask:
            return mask_texel(s, t);
        case Content::color:
            return color_texel(recipe, s, t);
        case Content::object_normal:
            return sphere_texel(recipe, s, t, texel);
    }
    return normal_texel(recipe, s, t, texel);
}

// Four things in one texture.
std::array<double, 4> packed_texel(const TextureRecipe& recipe, double s, double t, double texel) {
    const Rgb normal = normal_texel(recipe, s, t, texel);
    const double rise = (recipe.height(s, t) - recipe.low) / (recipe.high - recipe.low);
    return {mask_texel(s, t)[0], normal[1], clamp01(rise), normal[0]};
}

}  // namespace

std::span<const TextureRecipe> texture_recipes() {
    return kRecipes;
}

std::string make_texture(const TextureRecipe& recipe) {
    const auto format = recipe.wide ? asset::TexelFormat::unorm16 : asset::TexelFormat::unorm8;
    asset::Image image = asset::make_image(recipe.size, recipe.size, format);
    const double texel = 1.0 / recipe.size;
    for (std::uint32_t y = 0; y < recipe.size; ++y) {
        for (std::uint32_t x = 0; x < recipe.size; ++x) {
            const Rgb rgb = texel_of(recipe, (x + 0.5) * texel, (y + 0.5) * texel, texel);
            for (int c = 0; c < 3; ++c) image.set(x, y, c, rgb[static_cast<std::size_t>(c)]);
            image.set(x, y, 3, 1.0);
            if (recipe.content != Content::packed) continue;
            const auto four = packed_texel(recipe, (x + 0.5) * texel, (y + 0.5) * texel, texel);
            for (int c = 0; c < 4; ++c) image.set(x, y, c, four[static_cast<std::size_t>(c)]);
        }
    }
    return recipe.wide ? asset::png16_bytes(image) : asset::png_bytes(image);
}

}  // namespace sg::samples

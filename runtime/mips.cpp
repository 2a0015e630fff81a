#include "runtime/mips.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sg::runtime {
namespace {

using asset::Image;
using asset::TexelFormat;

constexpr double kSteepest = 128.0;  // slope of a normal that lies in the surface
constexpr double kLeastZSquared = 1.0 / (kSteepest * kSteepest);  // of a two-channel map

// What is averaged: linear rgba, or (slope x, slope y, plain blue or nothing, plain alpha).
using Texel = std::array<double, 4>;

struct Level {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<Texel> texels;
};

// Within [-1, 1]; 0 for what is not a number.
double clamp_unit(double v) {
    return v == v ? std::clamp(v, -1.0, 1.0) : 0.0;
}

// How far a code is from `zero` when it means 1.
double reach(double zero) {
    return zero == 127.5 ? 127.5 : 127.0;
}

double decode(double texel, double zero) {
    return clamp_unit((255.0 * texel - zero) / reach(zero));
}
double encode(double value, double zero) {
    return (value * reach(zero) + zero) / 255.0;
}

double linear_of_srgb(double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}
double srgb_of_linear(double v) {
    return v <= 0.0031308 ? v * 12.92 : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
}

// The slopes -x/z and -y/z, each at most kSteepest in size; (0, 0, 0) is flat.
Texel slopes_of(double x, double y, double z) {
    const double safe_z = std::max(std::abs(z), std::max(std::abs(x), std::abs(y)) / kSteepest);
    if (!(safe_z > 0.0)) return {};
    return {-x / safe_z, -y / safe_z, 0.0, 0.0};
}

Texel decode_texel(const Image& image, std::uint32_t x, std::uint32_t y, const MipRule& rule) {
    Texel raw;
    for (int c = 0; c < 4; ++c) {
        const double v = image.at(x, y, c);
        raw[static_cast<std::size_t>(c)] = v == v ? v : 0.0;
    }
    if (rule.kind == MipRule::Kind::color) {
        for (std::size_t c = 0; c < 3 && rule.srgb; ++c) raw[c] = linear_of_srgb(raw[c]);
        return raw;
    }
    const bool two_channels = rule.kind == MipRule::Kind::slopes_xy;
    const auto& [c_x, c_y, c_z, c_rest] = rule.channels;
    const double nx = decode(image.at(x, y, c_x), rule.zero), ny = decode(image.at(x, y, c_y), rule.zero);
    const double nz = two_channels ? std::sqrt(std::max(1.0 - nx * nx - ny * ny, kLeastZSquared))
                                   : decode(image.at(x, y, c_z), rule.zero);
    Texel texel = slopes_of(nx, ny, nz);
    texel[2] = raw[static_cast<std::size_t>(c_z)];
    texel[3] = raw[static_cast<std::size_t>(c_rest)];
    return texel;
}

Texel encode_texel(Texel texel, const MipRule& rule) {
    if (rule.kind == MipRule::Kind::color) {
        for (std::size_t c = 0; c < 3 && rule.srgb; ++c) texel[c] = srgb_of_linear(texel[c]);
        return texel;
    }
    const double length = std::sqrt(1.0 + texel[0] * texel[0] + texel[1] * texel[1]);
    const double blue = rule.kind == MipRule::Kind::slopes_xy ? texel[2] : encode(1.0 / length, rule.zero);
    return {encode(-texel[0] / length, rule.zero), encode(-texel[1] / length, rule.zero), blue, texel[3]};
}

// The texels under one texel of the next level along one axis: `first` and up to three weights that sum to 1.
struct Taps {
    std::uint32_t first = 0;
    std::uint32_t count = 1;
    std::array<double, 3> weights{1.0, 0.0, 0.0};
};

// Halving n = 2k + 1 texels, each new one covers 2 + 1/k old ones: a part, a whole and a part.
Taps taps_of(std::uint32_t n, std::uint32_t i) {
    if (n == 1) return {};
    if (n % 2 == 0) return {2 * i, 2, {0.5, 0.5, 0.0}};
    const double k = n / 2, size = n;
    return {2 * i, 3, {(k - i) / size, k / size, (i + 1.0) / size}};
}

// source(x, y) gives the texel of a level of width x height texels.
template <class Source>
Level halve(std::uint32_t width, std::uint32_t height, Source source) {
    Level out{std::max(width / 2, 1u), std::max(height / 2, 1u), {}};
    out.texels.reserve(static_cast<std::size_t>(out.width) * out.height);
    for (std::uint32_t y = 0; y < out.height; ++y) {
        const Taps down = taps_of(height, y);
        for (std::uint32_t x = 0; x < out.width; ++x) {
            const Taps across = taps_of(width, x);
            Texel sum{};
            for (std::uint32_t j = 0; j < down.count; ++j) {
                for (std::uint32_t i = 0; i < across.count; ++i) {
                    const Texel texel = source(across.first + i, down.first + j);
                    const double weight = across.weights[i] * down.weights[j];
                    for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * texel[c];
                }
            }
            out.texels.push_back(sum);
        }
    }
    return out;
}

Image image_of(const Level& level, TexelFormat format, const MipRule& rule) {
    Image image = asset::make_image(level.width, level.height, format);
    const std::array<int, 4> to = rule.kind == MipRule::Kind::color ? std::array{0, 1, 2, 3} : rule.channels;
    for (std::uint32_t y = 0; y < level.height; ++y) {
        for (std::uint32_t x = 0; x < level.width; ++x) {
            const Texel texel =
                encode_texel(level.texels[static_cast<std::size_t>(y) * level.width + x], rule);
            for (std::size_t c = 0; c < 4; ++c) image.set(x, y, to[c], texel[c]);
        }
    }
    return image;
}

}  // namespace

std::vector<Image> mip_chain(const Image& base, const MipRule& rule) {
    std::vector<Image> chain{base};
    if (base.width <= 1 && base.height <= 1) return chain;
    Level level = halve(base.width, base.height,
                        [&](std::uint32_t x, std::uint32_t y) { return decode_texel(base, x, y, rule); });
    chain.push_back(image_of(level, base.format, rule));
    while (level.width > 1 || level.height > 1) {
        const Level finer = std::move(level);
        level = halve(finer.width, finer.height, [&](std::uint32_t x, std::uint32_t y) {
            return finer.texels[static_cast<std::size_t>(y) * finer.width + x];
        });
        chain.push_back(image_of(level, base.format, rule));
    }
    return chain;
}

}  // namespace sg::runtime

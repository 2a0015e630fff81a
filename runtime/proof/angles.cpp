#include "runtime/proof/angles.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace sg::proof {
namespace {

constexpr std::uint32_t kBar = 22;  // pixels that the scale adds below the picture

glm::dvec3 rgb(const runtime::Picture& picture, std::uint32_t x, std::uint32_t y) {
    const asset::Image& v = picture.values;
    return {v.at(x, y, 0), v.at(x, y, 1), v.at(x, y, 2)};
}

bool drawn(const runtime::Picture& picture, std::uint32_t x, std::uint32_t y) {
    return picture.coverage[std::size_t{y} * picture.values.width + x] > 0;
}

// Five colours of rising lightness.
glm::dvec3 heat(double t) {
    static constexpr std::array<glm::dvec3, 5> kStops = {
        {{0.02, 0.02, 0.06}, {0.34, 0.07, 0.44}, {0.80, 0.22, 0.27}, {0.98, 0.64, 0.13}, {1.00, 1.00, 0.90}}};
    const double place = std::clamp(t, 0.0, 1.0) * 4;
    const auto below = static_cast<std::size_t>(std::min(place, 3.0));
    return glm::mix(kStops[below], kStops[below + 1], place - static_cast<double>(below));
}

void paint(asset::Image& image, std::uint32_t x, std::uint32_t y, glm::dvec3 color) {
    for (int c = 0; c < 3; ++c) image.set(x, y, c, color[c]);
    image.set(x, y, 3, 1);
}

// Digits, point and the word "deg", 3 x 5 points each, rows from the top, three bits a row.
struct Glyph {
    char character;
    std::array<int, 5> rows;
};
constexpr std::array<Glyph, 14> kGlyphs = {{{'0', {7, 5, 5, 5, 7}},
                                            {'1', {2, 6, 2, 2, 7}},
                                            {'2', {7, 1, 7, 4, 7}},
                                            {'3', {7, 1, 7, 1, 7}},
                                            {'4', {5, 5, 7, 1, 1}},
                                            {'5', {7, 4, 7, 1, 7}},
                                            {'6', {7, 4, 7, 5, 7}},
                                            {'7', {7, 1, 1, 2, 2}},
                                            {'8', {7, 5, 7, 5, 7}},
                                            {'9', {7, 5, 7, 1, 7}},
                                            {'.', {0, 0, 0, 0, 2}},
                                            {'d', {1, 1, 7, 5, 7}},
                                            {'e', {7, 5, 7, 4, 7}},
                                            {'g', {7, 5, 7, 1, 6}}}};

void write(asset::Image& image, std::uint32_t left, std::uint32_t top, std::string_view text) {
    constexpr std::uint32_t kScale = 2;
    for (char character : text) {
        for (const Glyph& glyph : kGlyphs) {
            if (glyph.character != character) continue;
            for (std::uint32_t y = 0; y < 5 * kScale; ++y) {
                for (std::uint32_t x = 0; x < 3 * kScale; ++x) {
                    const int row = glyph.rows[y / kScale];
                    if ((row >> (2 - static_cast<int>(x / kScale))) & 1)
                        paint(image, left + x, top + y, glm::dvec3(0.9));
                }
            }
        }
        left += 4 * kScale;
    }
}

std::uint32_t width_of(std::string_view text) {
    return static_cast<std::uint32_t>(text.size()) * 8;
}

// "0", the scale's middle, and "<scale>deg" over a strip of all colours.
void draw_bar(asset::Image& image, std::uint32_t top, double scale) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
        for (std::uint32_t y = top; y < image.height; ++y) paint(image, x, y, glm::dvec3(0.12));
        for (std::uint32_t y = top + 2; y < top + 8; ++y)
            paint(image, x, y, heat((x + 0.5) / static_cast<double>(image.width)));
    }
    const std::string end = fmt::format("{:g}deg", scale), middle = fmt::format("{:g}", scale / 2);
    write(image, 2, top + 10, "0");
    write(image, image.width / 2 - width_of(middle) / 2, top + 10, middle);
    write(image, image.width - width_of(end) - 1, top + 10, end);
}

}  // namespace

double angle_degrees(glm::dvec3 a, glm::dvec3 b) {
    const bool usable =
        glm::dot(a, a) > 0 && glm::dot(b, b) > 0 && std::isfinite(glm::dot(a, a) + glm::dot(b, b));
    if (!usable) return 180;
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi;
}

Angles angles_between(const runtime::Picture& a, const runtime::Picture& b) {
    Angles out(a.values.width, a.values.height);
    for (std::uint32_t y = 0; y < out.height; ++y) {
        for (std::uint32_t x = 0; x < out.width; ++x) {
            const bool in_a = drawn(a, x, y), in_b = drawn(b, x, y);
            if (in_a || in_b) out.at(x, y) = in_a && in_b ? angle_degrees(rgb(a, x, y), rgb(b, x, y)) : 180;
        }
    }
    return out;
}

Numbers numbers_of(std::vector<double> degrees) {
    std::erase_if(degrees, [](double d) { return std::isnan(d); });
    std::sort(degrees.begin(), degrees.end());
    if (degrees.empty()) return {};
    auto at = [&](double share) {
        return degrees[static_cast<std::size_t>(share * static_cast<double>(degrees.size() - 1))];
    };
    return {at(0.5), at(0.95), at(0.99), degrees.back(), degrees.size()};
}

std::string text_of(const Numbers& n) {
    return fmt::format("median {:.3g}  p95 {:.3g}  p99 {:.3g}  max {:.3g} degrees, {} pixels", n.median,
                       n.p95, n.p99, n.max, n.count);
}

double round_scale(double degrees) {
    for (double decade : {0.01, 0.1, 1.0, 10.0}) {
        for (double step : {1.0, 2.0, 5.0}) {
            if (degrees <= decade * step * (1 + 1e-9)) return decade * step;
        }
    }
    return degrees <= 90 ? 90 : 180;
}

asset::Image angle_map(const Angles& angles, double scale) {
    const bool bar = angles.width >= 96;
    asset::Image out =
        asset::make_image(angles.width, angles.height + (bar ? kBar : 0), asset::TexelFormat::unorm8);
    for (std::uint32_t y = 0; y < angles.height; ++y) {
        for (std::uint32_t x = 0; x < angles.width; ++x) {
            if (!std::isnan(angles.at(x, y))) paint(out, x, y, heat(angles.at(x, y) / scale));
        }
    }
    if (bar) draw_bar(out, angles.height, scale);
    return out;
}

runtime::Picture angle_values(const Angles& angles) {
    runtime::Picture out{asset::make_image(angles.width, angles.height, asset::TexelFormat::float32), {}};
    out.coverage.assign(angles.degrees.size(), 0.0f);
    for (std::uint32_t y = 0; y < angles.height; ++y) {
        for (std::uint32_t x = 0; x < angles.width; ++x) {
            const double degrees = angles.at(x, y);
            if (std::isnan(degrees)) continue;
            for (int c = 0; c < 3; ++c) out.values.set(x, y, c, degrees);
            out.values.set(x, y, 3, 1);
            out.coverage[std::size_t{y} * angles.width + x] = 1;
        }
    }
    return out;
}

}  // namespace sg::proof

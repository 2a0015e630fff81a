#include "runtime/tonemap.hpp"

#include <algorithm>
#include <cmath>

namespace sg::runtime {
namespace {

float coverage_at(const Picture& picture, std::uint32_t x, std::uint32_t y) {
    return picture.coverage[std::size_t{y} * picture.values.width + x];
}

glm::dvec4 value_at(const Picture& picture, std::uint32_t x, std::uint32_t y) {
    const asset::Image& v = picture.values;
    return {v.at(x, y, 0), v.at(x, y, 1), v.at(x, y, 2), v.at(x, y, 3)};
}

// The background of lit pictures, linear: from a middle grey at the upper edge to a darker one at the lower.
double background(std::uint32_t y, std::uint32_t height) {
    constexpr double kUpper = 0.115, kLower = 0.030;
    double t = (y + 0.5) / height;
    return kUpper + (kLower - kUpper) * t;
}

// The greatest magnitude of the shown components over the drawn pixels, or 1 if all are 0.
double greatest(const Picture& picture, std::uint32_t components) {
    double out = 0;
    for (std::uint32_t y = 0; y < picture.values.height; ++y) {
        for (std::uint32_t x = 0; x < picture.values.width; ++x) {
            if (coverage_at(picture, x, y) == 0) continue;
            for (std::uint32_t c = 0; c < std::min(components, 3u); ++c) {
                double magnitude = std::abs(picture.values.at(x, y, static_cast<int>(c)));
                if (std::isfinite(magnitude)) out = std::max(out, magnitude);
            }
        }
    }
    return out > 0 ? out : 1;
}

glm::dvec3 display_color(const glm::dvec4& value, const DebugView& view, const ViewSpace& space,
                         double scale) {
    glm::dvec3 v(value);
    switch (view.kind) {
        case ViewKind::direction:
            return 0.5 * v + 0.5;
        case ViewKind::position:
            return (v + space.camera_position - space.bounds.lower) /
                   glm::max(space.bounds.upper - space.bounds.lower, glm::dvec3(1e-9));
        case ViewKind::uv:
            return {v.x - std::floor(v.x), v.y - std::floor(v.y), 0};
        default:
            break;
    }
    glm::dvec3 out(0.5);
    for (int c = 0; c < static_cast<int>(std::min(view.components, 3u)); ++c) out[c] += 0.5 * v[c] / scale;
    return out;
}

}  // namespace

double tone_curve(double radiance) {
    if (!(radiance > 0)) return 0;
    double x = std::min(radiance, 1e6);
    return std::clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

double srgb_encode(double linear) {
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

asset::Image lit_to_display(const Picture& picture, double exposure) {
    const std::uint32_t width = picture.values.width, height = picture.values.height;
    double gain = std::exp2(exposure);
    asset::Image out = asset::make_image(width, height, asset::TexelFormat::unorm8);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            double covered = coverage_at(picture, x, y);
            for (int c = 0; c < 3; ++c) {
                double seen = covered > 0 ? tone_curve(gain * picture.values.at(x, y, c)) : 0;
                out.set(x, y, c, srgb_encode(covered * seen + (1 - covered) * background(y, height)));
            }
            out.set(x, y, 3, 1);
        }
    }
    return out;
}

asset::Image values_to_display(const Picture& picture, const DebugView& view, const ViewSpace& space) {
    const std::uint32_t width = picture.values.width, height = picture.values.height;
    double scale = view.kind == ViewKind::vector ? greatest(picture, view.components) : 1;
    asset::Image out = asset::make_image(width, height, asset::TexelFormat::unorm8);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            double covered = coverage_at(picture, x, y);
            if (covered == 0) continue;
            glm::dvec3 color = display_color(value_at(picture, x, y), view, space, scale);
            for (int c = 0; c < 3; ++c) out.set(x, y, c, color[c]);
            out.set(x, y, 3, covered);
        }
    }
    return out;
}

}  // namespace sg::runtime

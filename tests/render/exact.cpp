#include "tests/render/exact.hpp"

#include <cmath>
#include <numbers>

namespace sg::truth {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kR = 1, kr = 0.4;  // of the torus

struct Angles {
    double a = 0, b = 0;
};

// da/ds and db/dt, then the angles themselves.
Angles rates(Shape shape) {
    if (shape == Shape::sphere) return {2 * kPi, kPi};
    if (shape == Shape::torus) return {2 * kPi, -2 * kPi};
    return {kPi, 0};
}
Angles angles(Shape shape, glm::dvec2 st) {
    const Angles rate = rates(shape);
    const double start = shape == Shape::torus ? 0.5 : 0.0;
    return {rate.a * (st.x - 0.5), rate.b * (st.y - start)};
}

}  // namespace

glm::dvec3 Surface::position(glm::dvec2 st) const {
    const auto [a, b] = angles(shape, st);
    switch (shape) {
        case Shape::plane:
            return {2 * st.x - 1, 1 - 2 * st.y, 0};
        case Shape::sphere:
            return {std::sin(b) * std::sin(a), std::cos(b), std::sin(b) * std::cos(a)};
        case Shape::torus: {
            const double ring = kR + kr * std::cos(b);
            return {ring * std::sin(a), kr * std::sin(b), ring * std::cos(a)};
        }
        case Shape::cylinder:
            return {std::sin(a), 1 - 2 * st.y, std::cos(a)};
    }
    return {};
}

glm::dvec3 Surface::along_s(glm::dvec2 st) const {
    const auto [a, b] = angles(shape, st);
    const double radius = shape == Shape::sphere  ? std::sin(b)
                          : shape == Shape::torus ? kR + kr * std::cos(b)
                                                  : 1;
    if (shape == Shape::plane) return {2, 0, 0};
    return rates(shape).a * radius * glm::dvec3(std::cos(a), 0, -std::sin(a));
}

glm::dvec3 Surface::along_t(glm::dvec2 st) const {
    const auto [a, b] = angles(shape, st);
    const double rate = rates(shape).b;
    if (shape == Shape::sphere)
        return rate * glm::dvec3(std::cos(b) * std::sin(a), -std::sin(b), std::cos(b) * std::cos(a));
    if (shape == Shape::torus)
        return rate * kr * glm::dvec3(-std::sin(b) * std::sin(a), std::cos(b), -std::sin(b) * std::cos(a));
    return {0, -2, 0};
}

glm::dvec3 Surface::normal(glm::dvec2 st) const {
    const auto [a, b] = angles(shape, st);
    switch (shape) {
        case Shape::plane:
            return {0, 0, 1};
        case Shape::sphere:
            return {std::sin(b) * std::sin(a), std::cos(b), std::sin(b) * std::cos(a)};
        case Shape::torus:
            return {std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a)};
        case Shape::cylinder:
            return {std::sin(a), 0, std::cos(a)};
    }
    return {};
}

glm::dvec2 Surface::inverse(glm::dvec3 p) const {
    const double around = std::atan2(p.x, p.z), ring = std::hypot(p.x, p.z);
    switch (shape) {
        case Shape::plane:
            return {(p.x + 1) / 2, (1 - p.y) / 2};
        case Shape::sphere:
            return {around / (2 * kPi) + 0.5, std::atan2(ring, p.y) / kPi};
        case Shape::torus:
            return {around / (2 * kPi) + 0.5, 0.5 - std::atan2(p.y, ring - kR) / (2 * kPi)};
        case Shape::cylinder:
            return {around / kPi + 0.5, (1 - p.y) / 2};
    }
    return {};
}

double Height::value(glm::dvec2 c) const {
    double sum = 0;
    for (const Wave& w : waves) sum += w.amplitude * std::sin(2 * kPi * (w.i * c.x + w.j * c.y) + w.phase);
    if (taper_axis < 0) return sum;
    const double s = std::sin(kPi * c[taper_axis]);
    return sum * s * s;
}

glm::dvec2 Height::gradient(glm::dvec2 c) const {
    glm::dvec2 out(0);
    for (const Wave& w : waves) {
        const double slope = w.amplitude * 2 * kPi * std::cos(2 * kPi * (w.i * c.x + w.j * c.y) + w.phase);
        out += slope * glm::dvec2(w.i, w.j);
    }
    if (taper_axis < 0) return out;
    const Height untapered{waves, -1};
    const double s = std::sin(kPi * c[taper_axis]);
    out *= s * s;
    out[taper_axis] += untapered.value(c) * kPi * std::sin(2 * kPi * c[taper_axis]);
    return out;
}

glm::dvec2 Chart::from_surface(glm::dvec2 st) const {
    if (uv_set == 1) return {st.y, st.x};
    if (unwrap == Unwrap::folded) return {std::abs(2 * st.x - 1), st.y};
    return {unwrap == Unwrap::mirrored ? 1 - st.x : st.x, st.y};
}

glm::dvec2 Chart::to_surface(glm::dvec2 c) const {
    if (uv_set == 0 && unwrap == Unwrap::folded) return {(1 + c.x) / 2, c.y};
    return from_surface(c);  // the others are their own inverses
}

double Chart::rate(glm::dvec2 st) const {
    if (uv_set == 1 || unwrap == Unwrap::straight) return 1;
    if (unwrap == Unwrap::mirrored) return -1;
    return st.x < 0.5 ? -2 : 2;
}

glm::dvec2 height_gradient(const Bump& bump, glm::dvec2 st) {
    const glm::dvec2 c = bump.chart.from_surface(st);
    const glm::dvec2 by_chart =
        bump.strength / std::abs(bump.tiling.x) * bump.tiling * bump.height.gradient(bump.tiling * c);
    if (bump.chart.uv_set == 1) return {by_chart.y, by_chart.x};
    return {bump.chart.rate(st) * by_chart.x, by_chart.y};
}

glm::dvec2 texture_slope(const Surface& surface, const Bump& bump, glm::dvec2 c) {
    const glm::dvec2 st = bump.chart.to_surface(c);
    glm::dvec2 size(glm::length(surface.along_s(st)) / std::abs(bump.chart.rate(st)),
                    glm::length(surface.along_t(st)));
    if (bump.chart.uv_set == 1) size = {size.y, size.x};
    return bump.height.gradient(c) / size;
}

glm::dvec3 bumped_normal(const Surface& surface, const std::vector<Bump>& bumps, glm::dvec3 point, Side side,
                         const glm::dmat3& world) {
    const glm::dvec2 st = surface.inverse(point);
    glm::dvec2 slope(0);
    for (const Bump& bump : bumps) slope += height_gradient(bump, st);
    const glm::dvec3 n = glm::normalize(glm::transpose(glm::inverse(world)) * surface.normal(st));
    const glm::dvec3 s = world * surface.along_s(st), t = world * surface.along_t(st);
    slope *= glm::dvec2(glm::length(s) / glm::length(surface.along_s(st)),
                        glm::length(t) / glm::length(surface.along_t(st)));
    const glm::dvec3 g = glm::inverse(glm::transpose(glm::dmat3(s, t, n))) * glm::dvec3(slope, 0);
    if (side == Side::mirror) return glm::normalize(-n - g);
    return side == Side::flip ? -glm::normalize(n - g) : glm::normalize(n - g);
}

double angle_degrees(glm::dvec3 a, glm::dvec3 b) {
    const double angle = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    const bool usable =
        glm::dot(a, a) > 0 && glm::dot(b, b) > 0 && std::isfinite(glm::dot(a, a) + glm::dot(b, b));
    return usable ? angle * 180 / kPi : 180;
}

}  // namespace sg::truth

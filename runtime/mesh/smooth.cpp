#include "runtime/mesh/smooth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sg::runtime {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTorusRing = 1, kTorusTube = 0.4;

// The rock: 1 + the sum of amplitude * sin(dot(wave, direction) + phase). Chosen by eye: three dents and
// bumps of a third of the rock, four of a tenth.
struct Wave {
    glm::dvec3 wave;
    double phase, amplitude;
};
constexpr std::array<Wave, 7> kRock = {{{{2.1, 0.7, -1.3}, 0.4, 0.10},
                                        {{-0.9, 2.3, 1.1}, 1.9, 0.09},
                                        {{1.2, -1.1, 2.6}, 3.7, 0.08},
                                        {{4.3, 2.9, -1.7}, 0.8, 0.030},
                                        {{-2.2, 4.6, 3.1}, 5.1, 0.028},
                                        {{3.4, -3.9, 4.2}, 2.6, 0.022},
                                        {{6.7, 1.8, 5.3}, 4.4, 0.010}}};

glm::dvec2 sphere_st(glm::dvec3 direction) {
    const double ring = std::hypot(direction.x, direction.z);
    return {std::atan2(direction.x, direction.z) / (2 * kPi) + 0.5, std::atan2(ring, direction.y) / kPi};
}

Foot torus_foot(glm::dvec3 p) {
    const double ring = std::hypot(p.x, p.z);
    const glm::dvec3 out = ring > 0 ? glm::dvec3(p.x, 0, p.z) / ring : glm::dvec3(0, 0, 1);
    const glm::dvec3 center = kTorusRing * out;
    const double tube = std::atan2(p.y, ring - kTorusRing);
    const glm::dvec3 normal = std::cos(tube) * out + glm::dvec3(0, std::sin(tube), 0);
    return {center + kTorusTube * normal,
            normal,
            {std::atan2(p.x, p.z) / (2 * kPi) + 0.5, 0.5 - tube / (2 * kPi)}};
}

// The coordinate on a face of a point with normal n whose nearest point of the inner box is `inner`.
glm::dvec2 face_st(const CubeFace& face, glm::dvec3 inner, glm::dvec3 n) {
    const glm::dvec3 c = inner + n * (kEdgeRadius / glm::dot(n, face.normal));
    return {(glm::dot(c, face.right) + 1) / 2, (1 - glm::dot(c, face.up)) / 2};
}

glm::dvec3 inner_of(glm::dvec3 p) {
    return glm::clamp(p, glm::dvec3(kEdgeRadius - 1), glm::dvec3(1 - kEdgeRadius));
}

int face_of(glm::dvec3 n) {
    const glm::dvec3 size = glm::abs(n);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * axis + (n[axis] < 0 ? 1 : 0);
}

Foot rounded_cube_foot(glm::dvec3 p, const Foot* near) {
    const glm::dvec3 inner = inner_of(p), away = p - inner;
    const double length = glm::length(away);
    if (!(length > 0)) return {};
    const glm::dvec3 n = away / length;
    const int face = near ? near->chart : face_of(n);
    return {inner + kEdgeRadius * n, n, face_st(cube_face(face), inner, n), face};
}

Foot rock_foot(glm::dvec3 p) {
    const glm::dvec3 d = glm::normalize(p);
    const RockRadius r = rock_radius(d);
    const glm::dvec3 across = r.gradient - glm::dot(r.gradient, d) * d;
    return {r.value * d, glm::normalize(d - across / r.value), sphere_st(d)};
}

Foot foot(SmoothShape shape, glm::dvec3 p, const Foot* near) {
    switch (shape) {
        case SmoothShape::plane:
            return {{p.x, p.y, 0}, {0, 0, 1}, {(p.x + 1) / 2, (1 - p.y) / 2}};
        case SmoothShape::sphere:
            return {glm::normalize(p), glm::normalize(p), sphere_st(p)};
        case SmoothShape::torus:
            return torus_foot(p);
        case SmoothShape::rounded_cube:
            return rounded_cube_foot(p, near);
        case SmoothShape::rock:
            return rock_foot(p);
    }
    return {};
}

}  // namespace

std::optional<SmoothShape> smooth_shape(std::string_view name) {
    if (name == "plane") return SmoothShape::plane;
    if (name == "sphere") return SmoothShape::sphere;
    if (name == "torus") return SmoothShape::torus;
    if (name == "rounded_cube") return SmoothShape::rounded_cube;
    if (name == "rock") return SmoothShape::rock;
    return std::nullopt;
}

Foot foot_of(SmoothShape shape, glm::dvec3 point, const Foot* near) {
    Foot out = foot(shape, point, near);
    const bool round = shape != SmoothShape::plane && shape != SmoothShape::rounded_cube;
    if (near && round) {
        out.st.x -= std::round(out.st.x - near->st.x);
        if (shape == SmoothShape::torus) out.st.y -= std::round(out.st.y - near->st.y);
    }
    return out;
}

const CubeFace& cube_face(int face) {
    static constexpr std::array<CubeFace, 6> kFaces = {{{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                                        {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                                        {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
                                                        {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                                        {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                                        {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}}};
    return kFaces[static_cast<std::size_t>(face)];
}

Foot rounded_cube_point(int face, glm::dvec2 st) {
    const CubeFace& f = cube_face(face);
    const glm::dvec3 c = f.normal + (2 * st.x - 1) * f.right + (1 - 2 * st.y) * f.up;
    const glm::dvec3 inner = inner_of(c), n = glm::normalize(c - inner);
    return {inner + kEdgeRadius * n, n, st, face};
}

RockRadius rock_radius(glm::dvec3 direction) {
    RockRadius out;
    for (const Wave& w : kRock) {
        const double angle = glm::dot(w.wave, direction) + w.phase;
        out.value += w.amplitude * std::sin(angle);
        out.gradient += w.amplitude * std::cos(angle) * w.wave;
    }
    return out;
}

}  // namespace sg::runtime

// Inputs that several concepts share.
#pragma once

#include <glm/glm.hpp>

#include "harness.hpp"
#include "ir/reference/frame.hpp"
#include "ir/reference/tbn.hpp"

namespace sg::proof {

// Any unit vector perpendicular to the unit vector n.
inline glm::dvec3 tangent_of(Random& random, glm::dvec3 n) {
    glm::dvec3 across = glm::cross(n, random.direction());
    return glm::length(across) > 1e-3 ? glm::normalize(across) : tangent_of(random, n);
}

// n, dpdx, dpdy at positions at .. at + 8: a unit normal and a pixel's footprint of 1e-4 to 10 world units.
// The steps lean up to 0.5 out of the tangent plane, as interpolated normals do, and keep at least 12 degrees
// between them.
inline void draw_frame(Random& random, Draw& in, std::size_t at) {
    const glm::dvec3 n = random.direction();
    const glm::dvec3 along = tangent_of(random, n), across = glm::cross(n, along);
    const double angle = random.sign() * random.uniform(0.2, 2.9), size = random.magnitude(1e-4, 10.0);
    const glm::dvec3 other = along * std::cos(angle) + across * std::sin(angle);
    in.put(at, n);
    in.put(at + 3, size * (along + random.uniform(-0.5, 0.5) * n));
    in.put(at + 6, size * random.magnitude(0.2, 5.0) * (other + random.uniform(-0.5, 0.5) * n));
}
inline constexpr const char* kFrame = "sg_frame(vec3(0.0), v3(3), v3(6), v3(0))";  // of draw_frame at 0
inline ref::Frame frame_of(const In& in) {
    return ref::frame(glm::dvec3(0.0), in.v3(3), in.v3(6), in.v3(0));
}

// st, dx, dy at positions at .. at + 5: steps of 1e-5 to 1 texture per pixel with at least 12 degrees between
// them, mirrored as often as not.
inline void draw_uv(Random& random, Draw& in, std::size_t at) {
    const glm::dvec2 along = random.direction2(), across(-along.y, along.x);
    const double angle = random.sign() * random.uniform(0.2, 2.9), size = random.magnitude(1e-5, 0.2);
    in.put(at, glm::dvec2(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)));
    in.put(at + 2, size * along);
    in.put(at + 4, size * random.magnitude(0.2, 5.0) * (along * std::cos(angle) + across * std::sin(angle)));
}
inline constexpr const char* kUv = "SgUv(v2(9), v2(11), v2(13))";  // of draw_uv at 9
inline ref::Uv uv_of(const In& in) {
    return {in.v2(9), in.v2(11), in.v2(13)};
}

inline void draw_frame_and_uv(Random& random, Draw& in) {
    draw_frame(random, in, 0);
    draw_uv(random, in, 9);
}

// A unit normal, and every other input anything that a register can hold.
inline void draw_normal_then_wild(Random& random, Draw& in) {
    in.put(0, random.direction());
    for (std::size_t k = 3; k < in.size(); ++k) in.put(k, random.wild());
}

// The output's first three floats are a unit normal on n's side, n being the first three inputs.
inline std::string unit_and_outward(const In& in, const In& out) {
    if (!is_unit(out.v3(0))) return "n' is not unit";
    // n and n' are rounded, and so is g.n: 1e-6 is 16 roundings.
    return glm::dot(out.v3(0), in.v3(0)) >= -1e-6 ? "" : "n' points inward";
}

inline std::string unit(const In&, const In& out) {
    return is_unit(out.v3(0)) ? "" : "n' is not unit";
}

// One more row: the producer with anything as input, resolved. `glsl` is an expression for g.
inline Case resolved_case(std::string name, std::string include, int inputs, const std::string& glsl,
                          bool outward = true) {
    return {.name = name + "_any_input",
            .include = include + " surfgrad/resolve.glsl",
            .inputs = inputs,
            .outputs = 3,
            .glsl = "put(0, sg_resolve(v3(0), " + glsl + "));",
            .draw = draw_normal_then_wild,
            .property = outward ? unit_and_outward : unit};
}

}  // namespace sg::proof

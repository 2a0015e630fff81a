// How much a problem itself magnifies rounding, for cases of several concepts.
#pragma once

#include <glm/glm.hpp>

#include "draws.hpp"

namespace sg::proof {

// The tangent of a coordinate is a difference of two products over its own length, made of steps that lose
// roundings of what the projection takes from them. Inputs: draw_frame_and_uv.
inline double cancellation(const In& in) {
    const ref::Frame frame = frame_of(in);
    const ref::Uv uv = uv_of(in);
    const glm::dvec3 a = uv.dy.y * frame.sigma_x, b = uv.dx.y * frame.sigma_y;
    return (std::abs(uv.dy.y) * glm::length(frame.dpdx) + std::abs(uv.dx.y) * glm::length(frame.dpdy)) /
           glm::length(a - b);
}

// |dpdx| |dpdy| / area: how much the inversion of a slanted or leaning footprint magnifies rounding, and the
// size of g.
inline double inversion(const ref::Frame& frame, glm::dvec2 dh) {
    const double x = glm::length(frame.dpdx), y = glm::length(frame.dpdy);
    const double area = std::abs(glm::determinant(glm::dmat3(frame.sigma_x, frame.sigma_y, frame.normal)));
    const double slant = x * y / area;
    return slant * slant * (std::abs(dh.x) / x + std::abs(dh.y) / y);
}

}  // namespace sg::proof

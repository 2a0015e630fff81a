// Renders one analytic case and says how far it is from calculus, beside the bound that follows from what is
// known to be inexact. The derivation of every term stands in truth.cpp.
#pragma once

#include "tests/render/cases.hpp"
#include "tests/render/workshop.hpp"

namespace sg::truth {

struct Bound {
    // Degrees, each a worst case over all but a hundredth of the pixels.
    double filter = 0, quantisation = 0, tessellation = 0, basis = 0, arithmetic = 0;
    [[nodiscard]] double p99() const { return filter + quantisation + tessellation + basis + arithmetic; }
    // Each term is a product of factors that are spread between 0 and their worst case over the surface, and
    // reaches it nowhere but at single points: a bilinear cell's error averages 2/3 of its middle's, a sine
    // 2/pi of its peak, a rounding or a place within a facet 1/2 of its worst. Half of the sum bounds the
    // median.
    [[nodiscard]] double median() const { return p99() / 2; }
};

struct Outcome {
    Percentiles error;  // degrees
    Bound bound;
    [[nodiscard]] bool holds() const {
        return error.count > 500 && error.median <= bound.median() && error.p99 <= bound.p99();
    }
};

Outcome run_case(const Case& c, const target::ShaderLibrary& library);

// Parts of run_case that other tests use.
constexpr std::uint32_t kPixels = 96;  // per side of a picture
const Recipe& recipe_of(const Case& c);
Made make_case(const Case& c, const target::ShaderLibrary& library);
runtime::Scene scene_of(const Case& c);
Bound bound_of(const Case& c);

}  // namespace sg::truth

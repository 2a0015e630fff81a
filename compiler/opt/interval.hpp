// What a number may be, whatever the pixel shows.
#pragma once

#include <limits>

#include "opt/optimise.hpp"

namespace sg::opt {

struct Interval {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    [[nodiscard]] bool within(double low, double high) const { return least >= low && most <= high; }
};

// Of a Scalar; all numbers where nothing is known. `depth`: how many operations are looked through.
Interval interval_of(const Rewriter& rewriter, ir::ValueId id, int depth = 4);

}  // namespace sg::opt

// Where a condition is infinite nothing is asserted: those inputs must be rare.
#pragma once

#include "harness.hpp"

namespace sg::proof {

// At most `share` of the case's inputs have an infinite condition.
inline void expect_few_skipped(const Case& item, double share) {
    const std::vector<float> inputs = draw_inputs(item, kMutantCount);
    const auto size = static_cast<std::size_t>(item.inputs);
    std::size_t skipped = 0;
    for (std::size_t at = 0; at < inputs.size(); at += size) {
        skipped += std::isinf(item.condition(In(std::span(inputs).subspan(at, size)))) ? 1u : 0u;
    }
    EXPECT_LE(static_cast<double>(skipped), share * static_cast<double>(kMutantCount))
        << item.name << ", SG_SEED=" << run_seed();
}

}  // namespace sg::proof

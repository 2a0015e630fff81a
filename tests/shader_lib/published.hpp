// The published formulas that the library departs from, in our own words: each must fail where the library
// holds.
#pragma once

#include "harness.hpp"

namespace sg::proof {

// The case holds with the library's function and not with `glsl` (which calls what `declarations` declares).
inline void expect_only_library_holds(const Case& library, std::string declarations, std::string glsl) {
    std::vector<float> inputs = draw_inputs(library, kMutantCount);
    EXPECT_EQ(compare(library, inputs, evaluate(library, inputs)).violation, "") << "SG_SEED=" << run_seed();
    Case published = library;
    published.declarations = std::move(declarations);
    published.glsl = std::move(glsl);
    EXPECT_NE(compare(published, inputs, evaluate(published, inputs)).violation, "")
        << "SG_SEED=" << run_seed();
}

}  // namespace sg::proof

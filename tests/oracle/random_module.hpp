// Random modules: any operation of ops.def on operands of its types, so that new rows take part by
// themselves.
#pragma once

#include <cstdint>
#include <random>

#include "ir/evaluate.hpp"

namespace sg::oracle {

// SG_SEED, or fresh entropy; printed on first use.
std::uint64_t run_seed();

struct RandomModule {
    ir::Module module;                  // verifies; has every output that its values allow
    std::vector<ir::Datum> parameters;  // by ParameterId
};
RandomModule random_module(std::mt19937_64& random);

// A pixel of a surface that is neither flat nor degenerate.
ir::PixelInputs random_pixel(std::mt19937_64& random);

}  // namespace sg::oracle

// The table behind ir/evaluate.hpp, for its loop and for the test that walks it.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "ir/evaluate.hpp"

namespace sg::ir {

// One value about to be evaluated: what an operation may see besides its operands.
struct Call {
    const Value& value;
    const PixelInputs& pixel;
    const Bindings& bindings;
    std::span<const Datum> before;        // the earlier values
    std::span<const Datum> derived = {};  // by Value::index of Op::derived

    [[nodiscard]] const Sampled& texture() const { return bindings.textures[value.index]; }
    [[nodiscard]] double zero() const { return value.number[0]; }  // attribute Zero
};

struct EvaluateRow {
    Op op{};
    std::vector<std::string_view> operands;  // GLSL types, as kDatumGlsl names them
    std::string_view result;                 // "Datum" where the attribute decides
    std::function<Datum(const Call&)> run;
};
std::span<const EvaluateRow> all_evaluate_rows();
// Null if the operation has no row.
const EvaluateRow* evaluate_row(Op op);

}  // namespace sg::ir

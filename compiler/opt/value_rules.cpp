// The rules of numbers, colours, coordinates and frames; their table stands at the end.
#include <algorithm>
#include <cmath>

#include "ir/evaluate_ops.hpp"
#include "opt/interval.hpp"
#include "opt/rules.hpp"

namespace sg::opt {
namespace {

using ir::Op;
using ir::Type;
using ir::Value;
using ir::ValueId;

ValueId channel_by_its_name(Rewriter& rewriter, const Value& value) {
    const Value* swizzled = rewriter.operand(value, 0, Op::swizzle);
    if (!swizzled) return {};
    Value direct = value;
    direct.index = ir::swizzle_channels(swizzled->index)[value.index];
    direct.operands = swizzled->operands;
    return rewriter.add(std::move(direct));
}

// ---- what is known now ----

// The interpreter computes it, so that folding cannot disagree with it.
ValueId fold_numbers(Rewriter& rewriter, const Value& value) {
    std::vector<ir::Datum> known;
    Value call = value;
    for (std::size_t i = 0; i < value.operands.size(); ++i) {
        const Value* number = rewriter.operand(value, i, Op::constant);
        if (!number) return {};
        known.push_back(ir::datum_of(number->type, number->number));
        call.operands[i] = {static_cast<std::uint32_t>(i)};
    }
    const ir::PixelInputs nowhere;
    const ir::Bindings nothing;
    const std::vector<double> result =
        ir::components(ir::evaluate_row(value.op)->run(ir::Call{call, nowhere, nothing, known}));
    Value folded{.op = Op::constant, .type = value.type, .layer = value.layer};
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (!std::isfinite(static_cast<float>(result[i]))) return {};  // the shader shall meet it itself
        folded.number[i] = result[i] + 0.0;                            // no -0
    }
    return rewriter.add(std::move(folded));
}

bool is_all(const Value* value, double number) {
    if (!value) return false;
    const auto end = value->number.begin() + static_cast<std::ptrdiff_t>(ir::component_count(value->type));
    return std::all_of(value->number.begin(), end, [&](double x) { return x == number; });
}

ValueId neutral_number(Rewriter& rewriter, const Value& value) {
    const bool sum = value.op == Op::add || value.op == Op::subtract || value.op == Op::add_color;
    const bool any_order = value.op != Op::subtract && value.op != Op::divide;
    for (std::size_t i = any_order ? 0 : 1; i < 2; ++i) {
        if (is_all(rewriter.operand(value, i, Op::constant), sum ? 0 : 1)) return value.operands[1 - i];
    }
    return {};
}

// Far below the largest number of a shader.
constexpr double kFinite = 1e30;

ValueId times_nothing(Rewriter& rewriter, const Value& value) {
    for (std::size_t i = 0; i < 2; ++i) {
        if (is_constant(rewriter.operand(value, i, Op::constant), 0.0) &&
            interval_of(rewriter, value.operands[1 - i]).within(-kFinite, kFinite))
            return value.operands[i];
    }
    return {};
}

ValueId number_is_within(Rewriter& rewriter, const Value& value) {
    const Value *least = rewriter.operand(value, 1, Op::constant),
                *most = rewriter.operand(value, 2, Op::constant);
    const bool holds =
        least && most && interval_of(rewriter, value.operands[0]).within(least->number[0], most->number[0]);
    return holds ? value.operands[0] : ValueId{};
}

ValueId one_sided_mix(Rewriter& rewriter, const Value& value) {
    if (value.operands[0] == value.operands[1]) return value.operands[0];
    if (value.op != Op::mix && value.op != Op::mix_color) return {};
    const Value* t = rewriter.operand(value, 2, Op::constant);
    if (is_constant(t, 0.0)) return value.operands[0];
    return is_constant(t, 1.0) ? value.operands[1] : ValueId{};
}

// ---- coordinates and frames ----

ValueId drift_from_nowhere(Rewriter& rewriter, const Value& value) {
    if (!is_all(rewriter.operand(value, 0, Op::constant), 0)) return {};
    return rewriter.add(Op::travel, {value.operands[2], value.operands[1]}, value);
}

ValueId lookup_by_one(Rewriter& rewriter, const Value& value) {
    return is_all(rewriter.operand(value, 1, Op::constant), 1) ? value.operands[0] : ValueId{};
}

ValueId frame_of_its_normal(Rewriter& rewriter, const Value& value) {
    const Value& frame = rewriter.at(value.operands[0]);
    const bool has_normal = frame.op == Op::frame || frame.op == Op::frame_resolved;
    return has_normal && frame.operands[1] == value.operands[1] ? value.operands[0] : ValueId{};
}

}  // namespace

std::vector<Rule> rules_of_values() {
    using enum Op;
    return {
        {"channel_by_its_name",
         "a channel of a texel in another order is a channel of the texel",
         {channel},
         channel_by_its_name},
        {"fold_numbers",
         "what is known now need not be computed for every pixel",
         {add,   subtract, multiply,   divide,     minimum,        maximum,   power,
          clamp, mix,      smoothstep, add_color,  multiply_color, mix_color, grey,
          color, splat,    pair,       channel_of, rgb_of,         unit},
         fold_numbers},
        {"number_is_within",
         "what cannot leave its bounds need not be kept within them",
         {clamp},
         number_is_within},
        {"neutral_number",
         "x + 0 = x, x - 0 = x, 1 x = x, x / 1 = x",
         {add, subtract, multiply, divide, add_color, multiply_color},
         neutral_number},
        {"times_nothing",
         "0 x = 0 of a number that has a bound: a decal under a mask of 0 vanishes",
         {multiply},
         times_nothing},
        {"one_sided_mix",
         "a mix of numbers by 0 is its first side, by 1 its second; of two equal sides it is either",
         {mix, mix_color, mix_surfgrad, mix_volgrad},
         one_sided_mix},
        {"lookup_by_one", "a coordinate times 1 is the coordinate", {uv_scale, volume_scale}, lookup_by_one},
        {"drift_from_nowhere", "0 + t v = t v", {drift}, drift_from_nowhere},
        {"frame_of_its_normal",
         "a frame on top of its own normal is the frame",
         {frame_resolved},
         frame_of_its_normal},
    };
}

}  // namespace sg::opt

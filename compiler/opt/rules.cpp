// One named function per rule; the table at the end says where each applies and why it holds.
#include "opt/optimise.hpp"

namespace sg::opt {
namespace {

using ir::Op;
using ir::Value;
using ir::ValueId;

bool is_constant(const Value* value, double number) {
    return value && value->op == Op::constant && value->number[0] == number;
}

bool is_positive_pair(const Value* value) {
    return value && value->op == Op::constant && value->number[0] > 0 && value->number[1] > 0;
}

ValueId scale_by_one(Rewriter& rewriter, const Value& value) {
    return is_constant(rewriter.operand(value, 0, Op::constant), 1.0) ? value.operands[1] : ValueId{};
}

ValueId dead_layer(Rewriter& rewriter, const Value& value) {
    const Value* scaled = rewriter.operand(value, 0, Op::scale_deriv);
    if (!scaled || !is_constant(rewriter.operand(*scaled, 0, Op::constant), 0.0)) return {};
    return rewriter.add(Op::zero_surfgrad, {}, value);
}

ValueId scale_to_nothing(Rewriter& rewriter, const Value& value) {
    if (!is_constant(rewriter.operand(value, 0, Op::constant), 0.0)) return {};
    return rewriter.add(Op::zero_surfgrad, {}, value);
}

ValueId add_nothing(Rewriter& rewriter, const Value& value) {
    if (rewriter.operand(value, 0, Op::zero_surfgrad)) return value.operands[1];
    if (rewriter.operand(value, 1, Op::zero_surfgrad)) return value.operands[0];
    return {};
}

ValueId resolve_nothing(Rewriter& rewriter, const Value& value) {
    return rewriter.operand(value, 1, Op::zero_surfgrad) ? value.operands[0] : ValueId{};
}

ValueId positive_tiling_shares_basis(Rewriter& rewriter, const Value& value) {
    const Value* scaled = rewriter.operand(value, 1, Op::uv_scale);
    if (!scaled || !is_positive_pair(rewriter.operand(*scaled, 1, Op::constant))) return {};
    return rewriter.add(Op::basis_uv, {value.operands[0], scaled->operands[0]}, value);
}

ValueId positive_tiling_turns_nothing(Rewriter& rewriter, const Value& value) {
    return is_positive_pair(rewriter.operand(value, 1, Op::constant)) ? value.operands[0] : ValueId{};
}

// The derivative and basis of a projected bump.
struct Projected {
    ValueId deriv;
    ValueId basis;
};
Projected projected(const Rewriter& rewriter, ValueId id) {
    const Value& value = rewriter.at(id);
    if (value.op != Op::surfgrad_from_tbn) return {};
    return {value.operands[0], value.operands[1]};
}

ValueId one_projection(Rewriter& rewriter, const Value& value) {
    // Copies, not references: adding values moves the list.
    Projected left = projected(rewriter, value.operands[0]);
    Projected right = projected(rewriter, value.operands[1]);
    if (!right.basis.valid()) return {};
    Value like = value;
    like.name = "";
    auto both = [&](const Projected& a) {
        ValueId sum = rewriter.add(Op::add_deriv, {a.deriv, right.deriv}, like);
        return rewriter.add(Op::surfgrad_from_tbn, {sum, right.basis}, like);
    };
    if (left.basis == right.basis) return both(left);
    // (x + project(a, B)) + project(b, B): sums lean to the left, so this walks through all layers.
    const Value* inner = rewriter.operand(value, 0, Op::add_surfgrad);
    if (!inner) return {};
    ValueId rest = inner->operands[0];
    Projected last = projected(rewriter, inner->operands[1]);
    if (last.basis != right.basis) return {};
    return rewriter.add(Op::add_surfgrad, {rest, both(last)}, like);
}

}  // namespace

std::span<const Rule> all_rules() {
    static const Rule kRules[] = {
        {"scale_deriv_by_one", "1 d = d", Op::scale_deriv, scale_by_one},
        {"scale_surfgrad_by_one", "1 g = g", Op::scale_surfgrad, scale_by_one},
        {"dead_layer", "a layer of strength 0 adds nothing: its texture and basis go with it", Op::surfgrad_from_tbn,
         dead_layer},
        {"scale_to_nothing", "0 g = 0", Op::scale_surfgrad, scale_to_nothing},
        {"add_nothing", "g + 0 = g", Op::add_surfgrad, add_nothing},
        {"resolve_nothing", "normalize(n - 0) = n, for n is unit", Op::resolve, resolve_nothing},
        {"positive_tiling_shares_basis", "T and B are unit vectors along +s and +t: positive tiling keeps both",
         Op::basis_uv, positive_tiling_shares_basis},
        {"positive_tiling_turns_nothing", "only negative factors turn +s or +t", Op::basis_mirror,
         positive_tiling_turns_nothing},
        {"one_projection", "projection is linear: project(a, B) + project(b, B) = project(a + b, B)", Op::add_surfgrad,
         one_projection},
    };
    return kRules;
}

}  // namespace sg::opt

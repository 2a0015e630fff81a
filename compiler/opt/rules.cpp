// One named function per rule; the table at the end says where each applies and why it holds.
#include "opt/rules.hpp"

#include <algorithm>

#include "opt/interval.hpp"

namespace sg::opt {
namespace {

using ir::Op;
using ir::Value;
using ir::ValueId;

// Numbers that are written, or that every engine keeps to.
bool is_positive_pair(const Rewriter& rewriter, ValueId id) {
    const Value& value = rewriter.at(id);
    if (value.op == Op::splat) return is_positive_pair(rewriter, value.operands[0]);
    if (value.op == Op::parameter) {
        const auto& range = rewriter.parameter(value).range;
        return range && (*range)[0] > 0;
    }
    if (value.op == Op::derived) return rewriter.derived(value).positive;
    const bool scalar = value.type == ir::Type::Scalar;
    return value.op == Op::constant && value.number[0] > 0 && (scalar || value.number[1] > 0);
}

ValueId scale_by_one(Rewriter& rewriter, const Value& value) {
    return is_constant(rewriter.operand(value, 0, Op::constant), 1.0) ? value.operands[1] : ValueId{};
}

// s (t x): numbers are multiplied before vectors are.
ValueId one_factor(Rewriter& rewriter, const Value& value) {
    const Value inner = rewriter.at(value.operands[1]);
    if (inner.op != value.op) return {};
    const ValueId both = rewriter.add(Op::multiply, {value.operands[0], inner.operands[0]}, unnamed(value));
    return rewriter.add(value.op, {both, inner.operands[1]}, value);
}

ValueId scale_before_turn(Rewriter& rewriter, const Value& value) {
    if (is_constant(rewriter.operand(value, 0, Op::constant), 0.0)) return {};
    const Value turned = rewriter.at(value.operands[1]);
    if (turned.op != Op::gradient_from_object && turned.op != Op::gradient_from_world) return {};
    const Value gradient = rewriter.at(turned.operands[0]);
    if (gradient.op != Op::noise_gradient) return {};
    const ValueId both =
        rewriter.add(Op::multiply, {value.operands[0], gradient.operands[0]}, unnamed(gradient));
    const ValueId scaled = rewriter.add(Op::noise_gradient, {both, gradient.operands[1]}, unnamed(gradient));
    return rewriter.add(turned.op, {scaled}, turned);
}

ValueId scale_to_nothing(Rewriter& rewriter, const Value& value) {
    if (!is_constant(rewriter.operand(value, 0, Op::constant), 0.0) &&
        !rewriter.operand(value, 1, Op::zero_surfgrad))
        return {};
    return rewriter.add(Op::zero_surfgrad, {}, value);
}

bool is_nothing(const Rewriter& rewriter, ValueId id) {
    const Value& value = rewriter.at(id);
    const bool scaled = value.op == Op::scale_deriv || value.op == Op::scale_volgrad;
    return value.op == Op::zero_surfgrad ||
           (scaled && is_constant(rewriter.operand(value, 0, Op::constant), 0.0));
}

ValueId project_nothing(Rewriter& rewriter, const Value& value) {
    if (!is_nothing(rewriter, value.operands[value.op == Op::surfgrad_from_tbn ? 0 : 1])) return {};
    return rewriter.add(Op::zero_surfgrad, {}, value);
}

ValueId add_nothing(Rewriter& rewriter, const Value& value) {
    if (is_nothing(rewriter, value.operands[0])) return value.operands[1];
    return is_nothing(rewriter, value.operands[1]) ? value.operands[0] : ValueId{};
}

ValueId no_way_to_itself(Rewriter& rewriter, const Value& value) {
    const Value* wanted = rewriter.operand(value, 1, Op::direction_of);
    if (!wanted || wanted->operands[0] != value.operands[0]) return {};
    return rewriter.add(Op::zero_surfgrad, {}, value);
}

ValueId resolve_nothing(Rewriter& rewriter, const Value& value) {
    return rewriter.operand(value, 1, Op::zero_surfgrad) ? value.operands[0] : ValueId{};
}

ValueId positive_tiling_shares_basis(Rewriter& rewriter, const Value& value) {
    const Value* scaled = rewriter.operand(value, 1, Op::uv_scale);
    if (!scaled || !is_positive_pair(rewriter, scaled->operands[1])) return {};
    return rewriter.add(Op::basis_uv, {value.operands[0], scaled->operands[0]}, value);
}

ValueId positive_tiling_turns_nothing(Rewriter& rewriter, const Value& value) {
    return is_positive_pair(rewriter, value.operands[1]) ? value.operands[0] : ValueId{};
}

// ---- projections are linear ----

ValueId scale_before_projection(Rewriter& rewriter, const Value& value) {
    const Value projected = rewriter.at(value.operands[1]);
    if (projected.op == Op::surfgrad_from_tbn) {
        ValueId scaled =
            rewriter.add(Op::scale_deriv, {value.operands[0], projected.operands[0]}, unnamed(projected));
        return rewriter.add(Op::surfgrad_from_tbn, {scaled, projected.operands[1]}, projected);
    }
    if (projected.op == Op::surfgrad_from_volume) {
        ValueId scaled =
            rewriter.add(Op::scale_volgrad, {value.operands[0], projected.operands[1]}, unnamed(projected));
        return rewriter.add(Op::surfgrad_from_volume, {projected.operands[0], scaled}, projected);
    }
    if (projected.op == Op::surfgrad_from_height) {
        Value scaled = projected;
        scaled.operands[2] =
            rewriter.add(Op::scale_deriv, {value.operands[0], projected.operands[2]}, unnamed(projected));
        return rewriter.add(std::move(scaled));
    }
    return {};
}

// What a projection takes: the part that is linear, and the basis or normal that two must share to be added
// first.
struct Projected {
    Op op{};
    ValueId linear;
    ValueId onto;
    [[nodiscard]] bool valid() const { return linear.valid(); }
    [[nodiscard]] bool shares(const Projected& other) const {
        return valid() && other.valid() && op == other.op && onto == other.onto;
    }
};
Projected projected(const Rewriter& rewriter, ValueId id) {
    const Value& value = rewriter.at(id);
    if (value.op == Op::surfgrad_from_tbn) return {value.op, value.operands[0], value.operands[1]};
    if (value.op == Op::surfgrad_from_volume) return {value.op, value.operands[1], value.operands[0]};
    return {};
}

ValueId project_sum(Rewriter& rewriter, const Projected& a, const Projected& b, const Value& like) {
    bool tbn = a.op == Op::surfgrad_from_tbn;
    ValueId sum = rewriter.add(tbn ? Op::add_deriv : Op::add_volgrad, {a.linear, b.linear}, like);
    return rewriter.add(a.op, tbn ? std::vector{sum, a.onto} : std::vector{a.onto, sum}, like);
}

// How many sums and their terms a rule looks through: what it costs does not grow with the module.
constexpr int kReach = 16;

// The sum with one of its terms and `more` projected together, the others as they were; invalid where none
// shares the projection. Sums lean to the left, so that the nearest terms stand on the right.
ValueId merged(Rewriter& rewriter, ValueId sum, const Projected& more, const Value& like, int& reach) {
    if (reach-- <= 0) return {};
    const Projected term = projected(rewriter, sum);
    if (term.shares(more)) return project_sum(rewriter, term, more, like);
    const Value terms = rewriter.at(sum);
    if (terms.op != Op::add_surfgrad) return {};
    if (ValueId b = merged(rewriter, terms.operands[1], more, like, reach); b.valid())
        return rewriter.add(Op::add_surfgrad, {terms.operands[0], b}, like);
    if (ValueId a = merged(rewriter, terms.operands[0], more, like, reach); a.valid())
        return rewriter.add(Op::add_surfgrad, {a, terms.operands[1]}, like);
    return {};
}

// A term of `more` moved into a sum that has one of its projection, and what is left of `more` then.
struct Moved {
    ValueId sum, rest;
};
Moved move_term(Rewriter& rewriter, ValueId sum, ValueId more, const Value& like, int& reach) {
    if (reach-- <= 0) return {};
    int within_sum = kReach;
    if (const Projected term = projected(rewriter, more); term.valid())
        return {merged(rewriter, sum, term, like, within_sum), {}};
    const Value terms = rewriter.at(more);
    if (terms.op != Op::add_surfgrad) return {};
    for (std::size_t i : {1u, 0u}) {
        const Moved moved = move_term(rewriter, sum, terms.operands[i], like, reach);
        if (!moved.sum.valid()) continue;
        const ValueId other = terms.operands[1 - i];
        if (!moved.rest.valid()) return {moved.sum, other};
        const std::vector<ValueId> rest =
            i == 1 ? std::vector{other, moved.rest} : std::vector{moved.rest, other};
        return {moved.sum, rewriter.add(Op::add_surfgrad, rest, like)};
    }
    return {};
}

ValueId one_projection(Rewriter& rewriter, const Value& value) {
    const Value like = unnamed(value);
    int reach = kReach;
    const Moved moved = move_term(rewriter, value.operands[0], value.operands[1], like, reach);
    if (!moved.sum.valid() || !moved.rest.valid()) return moved.sum;
    return rewriter.add(Op::add_surfgrad, {moved.sum, moved.rest}, like);
}

// ---- one map on vertex tangents ----

ValueId number(Rewriter& rewriter, ir::Type type, std::array<double, 4> n, const Value& like) {
    return rewriter.add(
        Value{.op = Op::constant, .type = type, .number = {n[0], n[1], n[2], n[3]}, .layer = like.layer});
}

// (s, s), or (s, -s) for green up.
ValueId along_s_and_t(Rewriter& rewriter, ValueId strength, bool green_up, const Value& like) {
    const Value known = rewriter.at(strength);
    if (known.op == Op::constant) {
        const double s = known.number[0];
        return number(rewriter, ir::Type::Vec2, {s, green_up ? -s : s}, like);
    }
    auto add = [&](Op op, ir::Type type, std::vector<ValueId> operands) {
        return rewriter.add(Value{.op = op,
                                  .type = type,
                                  .operands = std::move(operands),
                                  .name = "strength",
                                  .layer = like.layer});
    };
    if (!green_up) return add(Op::splat, ir::Type::Vec2, {strength});
    const ValueId turned = number(rewriter, ir::Type::Scalar, {-1.0}, like);
    return add(Op::pair, ir::Type::Vec2, {strength, add(Op::multiply, ir::Type::Scalar, {turned, strength})});
}

ValueId one_vertex_map(Rewriter& rewriter, const Value& value) {
    const Value* projected = rewriter.operand(value, 1, Op::surfgrad_from_tbn);
    const Value* basis = projected ? rewriter.operand(*projected, 1, Op::basis_vertex) : nullptr;
    if (!basis) return {};
    const Value like = unnamed(*projected);
    const ValueId vertex_normal = basis->operands[0], tangent = basis->operands[1];
    const Value* mirrored = rewriter.operand(value, 0, Op::mirror_normal);
    const Value* base = rewriter.operand(mirrored ? *mirrored : value, 0, Op::base_normal);
    if (!base || base->operands[0] != vertex_normal) return {};
    const Value* deriv = &rewriter.at(projected->operands[0]);
    ValueId strength, facing = mirrored ? mirrored->operands[1] : ValueId{};
    if (deriv->op == Op::scale_deriv) strength = deriv->operands[0], deriv = &rewriter.at(deriv->operands[1]);
    const bool green_up = deriv->op == Op::deriv_green_up;
    if (green_up) deriv = &rewriter.at(deriv->operands[0]);
    if (deriv->op != Op::deriv_from_normal_xyz) return {};
    const ValueId m = deriv->operands[0];
    // Adding values moves those that were looked at.
    if (!strength.valid()) strength = number(rewriter, ir::Type::Scalar, {1.0}, like);
    if (!facing.valid()) facing = number(rewriter, ir::Type::Scalar, {1.0}, value);
    const ValueId both = along_s_and_t(rewriter, strength, green_up, like);
    return rewriter.add(Op::resolve_vertex_map, {vertex_normal, tangent, facing, m, both}, value);
}

// ---- a projection and its resolve ----

// n - (v - dot(n, v) n) = (1 + dot(n, v)) n - v.
ValueId project_and_resolve(Rewriter& rewriter, const Value& value) {
    const Value* projected = rewriter.operand(value, 1, Op::surfgrad_from_volume);
    if (!projected || projected->operands[0] != value.operands[0]) return {};
    return rewriter.add(Op::resolve_volume, {value.operands[0], projected->operands[1]}, value);
}

// The gradient whose resolve is v, taken in part.
ValueId resolve_towards_normal(Rewriter& rewriter, const Value& value) {
    const Value* scaled = rewriter.operand(value, 1, Op::scale_surfgrad);
    const Value* gradient = scaled ? rewriter.operand(*scaled, 1, Op::surfgrad_from_normal) : nullptr;
    if (!gradient || gradient->operands[0] != value.operands[0]) return {};
    const Value* wanted = rewriter.operand(*gradient, 1, Op::direction_of);
    if (!wanted) return {};
    Value like = value;
    like.layer = gradient->layer;  // the normal is all that is left of it
    return rewriter.add(Op::resolve_towards, {value.operands[0], wanted->operands[0], scaled->operands[0]},
                        like);
}

// ---- masks and mixes ----

// Of what is no number a factor of 0 hides nothing.
ValueId mask_is_a_factor(Rewriter& rewriter, const Value& value) {
    if (rewriter.may_be_endless(value.operands[0]) && !rewriter.operand(value, 1, Op::constant)) return {};
    const Value like = unnamed(value);
    ValueId factor = value.operands[1];
    if (!interval_of(rewriter, factor).within(0, 1)) {
        const ValueId none = number(rewriter, ir::Type::Scalar, {0.0}, like),
                      all = number(rewriter, ir::Type::Scalar, {1.0}, like);
        factor = rewriter.add(Op::clamp, {factor, none, all}, like);
    }
    return rewriter.add(Op::scale_surfgrad, {factor, value.operands[0]}, value);
}

// From nothing, a mix is a mask; both take numbers outside 0..1 for the nearer end.
ValueId trivial_mix(Rewriter& rewriter, const Value& value) {
    if (rewriter.operand(value, 0, Op::zero_surfgrad))
        return rewriter.add(Op::mask_surfgrad, {value.operands[1], value.operands[2]}, value);
    const Value* t = rewriter.operand(value, 2, Op::constant);
    if (t && t->number[0] <= 0) return value.operands[0];
    return t && t->number[0] >= 1 ? value.operands[1] : ValueId{};
}

ValueId mix_before_projection(Rewriter& rewriter, const Value& value) {
    Projected from = projected(rewriter, value.operands[0]), to = projected(rewriter, value.operands[1]);
    if (from.op != Op::surfgrad_from_volume || !from.shares(to)) return {};
    Value like = unnamed(value);
    ValueId mixed = rewriter.add(Op::mix_volgrad, {from.linear, to.linear, value.operands[2]}, like);
    return rewriter.add(Op::surfgrad_from_volume, {from.onto, mixed}, like);
}

// ---- decals ----

// Of a matrix that is written out, the shader compiler knows the rows.
ValueId parallel_projection_has_one_gradient(Rewriter& rewriter, const Value& value) {
    const Value* decal = rewriter.operand(value, 1, Op::decal_box);
    if (!decal || !rewriter.operand(*decal, 0, Op::parameter)) return {};
    const ValueId projector = decal->operands[0];
    auto unit_row = [&](std::uint32_t row, const char* name) {
        const ValueId axis = rewriter.add({.op = Op::projector_axis,
                                           .type = ir::Type::Vec3,
                                           .operands = {projector},
                                           .index = row,
                                           .layer = value.layer});
        return rewriter.add(
            {.op = Op::unit, .type = ir::Type::Vec3, .operands = {axis}, .name = name, .layer = value.layer});
    };
    const ValueId axis_s = unit_row(0, "axis_s"), axis_t = unit_row(1, "axis_t");
    return rewriter.add(Op::decal_gradient_along, {value.operands[0], axis_s, axis_t}, value);
}

std::vector<Rule> rules_of_gradients() {
    using enum Op;
    return {
        {"scale_by_one", "1 x = x", {scale_deriv, scale_surfgrad, scale_volgrad}, scale_by_one},
        {"one_factor",
         "s (t x) = (s t) x: numbers are multiplied before vectors are",
         {scale_deriv, scale_surfgrad, scale_volgrad},
         one_factor},
        {"scale_before_turn",
         "the gradient of s times a noise of frequency f is s f times the noise's",
         {scale_volgrad},
         scale_before_turn},
        {"scale_to_nothing",
         "0 g = 0: a layer of strength 0 vanishes, its texture and basis with it",
         {scale_surfgrad},
         scale_to_nothing},
        {"project_nothing",
         "0 v = 0: a bump of strength 0 vanishes, with what it is looked up by",
         {surfgrad_from_volume, surfgrad_from_tbn},
         project_nothing},
        {"scale_before_projection",
         "projection is linear: s project(d) = project(s d), which is shorter and can be added to others",
         {scale_surfgrad},
         scale_before_projection},
        {"add_nothing", "g + 0 = g", {add_surfgrad, add_deriv}, add_nothing},
        {"no_way_to_itself", "from a normal to itself is no bump", {surfgrad_from_normal}, no_way_to_itself},
        {"one_projection",
         "projection is linear: project(a) + project(b) = project(a + b), for one basis, or one normal (the "
         "paper's footnote on decals)",
         {add_surfgrad},
         one_projection},
        {"trivial_mix",
         "a mix by 0 is its first side, a mix by 1 its second, a mix from nothing a mask of it",
         {mix_surfgrad},
         trivial_mix},
        {"mask_is_a_factor",
         "a mask is a factor from 0 to 1: it can be multiplied with the strength",
         {mask_surfgrad},
         mask_is_a_factor},
        {"mix_before_projection",
         "projection is linear: a mix of two volume bumps is projected once",
         {mix_surfgrad},
         mix_before_projection},
    };
}

std::vector<Rule> rules_of_normals_and_bases() {
    using enum Op;
    return {
        {"resolve_nothing", "normalize(n - 0) = n, for n is unit", {resolve}, resolve_nothing},
        {"one_vertex_map",
         "normalize(n - g) of one map on vertex tangents is normalize(m.x T + m.y B + m.z N): lengths need "
         "not be divided out first",
         {resolve},
         one_vertex_map},
        {"project_and_resolve",
         "n - (v - dot(n, v) n) = (1 + dot(n, v)) n - v: what a volume bump is projected for is taken away "
         "again",
         {resolve},
         project_and_resolve},
        {"resolve_towards_normal",
         "n minus a part t of the gradient that leads to v is along (rise - t dot(n, v)) n + t v: no vector "
         "is divided",
         {resolve},
         resolve_towards_normal},
        {"positive_tiling_shares_basis",
         "T and B are unit vectors along +s and +t: positive tiling keeps both",
         {basis_uv},
         positive_tiling_shares_basis},
        {"positive_tiling_turns_nothing",
         "only negative factors turn +s or +t",
         {basis_mirror},
         positive_tiling_turns_nothing},
    };
}

std::vector<Rule> last_rules() {
    using enum Op;
    return {
        {"parallel_projection_has_one_gradient",
         "a parallel projection's gradients are the rows of its matrix, the same for every pixel",
         {decal_gradient},
         parallel_projection_has_one_gradient},
        {"parameters_on_host",
         "what depends on parameters alone is the same for every pixel: the host computes it once",
         {},
         nullptr,
         parameters_on_host},
    };
}

}  // namespace

std::span<const Rule> all_rules() {
    static const std::vector<Rule> kRules = [] {
        std::vector<Rule> all = rules_of_gradients();
        for (const std::vector<Rule>& more : {rules_of_normals_and_bases(), rules_of_values(), last_rules()})
            all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    return kRules;
}

}  // namespace sg::opt

// Operation -> function in double precision: ONE table, one row per operation of ops.def.
//
// To add a row: {Op::name, function}. The function is one of sg::ref, or a lambda without captures around it;
// operands are unpacked by its parameter types. If its first parameter is `const Call&` it also sees the
// pixel's inputs, the attribute (c.texture(), c.zero(), c.value.index, c.value.number) and the bindings. A
// new struct type becomes one more alternative of Datum, one name of kDatumGlsl and one line of components().
// tests/oracle walks ops.def and fails naming an operation without a row, or one whose widths differ from
// types.def.
#include "ir/evaluate_ops.hpp"

#include <type_traits>
#include <utility>

#include "base/ice.hpp"
#include "ir/reference/combine.hpp"
#include "ir/reference/deriv.hpp"
#include "ir/reference/resolve.hpp"

namespace sg::ir {
namespace {

using ref::Basis;
using ref::dvec2;
using ref::dvec3;
using ref::dvec4;
using ref::Frame;
using ref::Uv;

// The GLSL name of an alternative of Datum.
template <class T, std::size_t I = 0>
constexpr std::string_view glsl_of() {
    if constexpr (std::is_same_v<T, Datum>) {
        return "Datum";
    } else if constexpr (std::is_same_v<T, std::variant_alternative_t<I, Datum>>) {
        return kDatumGlsl[I];
    } else {
        return glsl_of<T, I + 1>();
    }
}

template <class T>
const std::remove_cvref_t<T>& operand(const Call& call, std::size_t index) {
    return std::get<std::remove_cvref_t<T>>(call.before[call.value.operands[index].index]);
}

template <class Result, class... Operands, class Invoke, std::size_t... I>
EvaluateRow make_row(Op op, Invoke invoke, std::index_sequence<I...>) {
    return {op,
            {glsl_of<std::remove_cvref_t<Operands>>()...},
            glsl_of<Result>(),
            [invoke](const Call& call) -> Datum { return invoke(call, operand<Operands>(call, I)...); }};
}

struct Row : EvaluateRow {
    template <class R, class... A>
    Row(Op row_op, R (*function)(A...))
        : EvaluateRow(make_row<R, A...>(
              row_op, [function](const Call&, const auto&... args) { return function(args...); },
              std::index_sequence_for<A...>{})) {}
    template <class R, class... A>
    Row(Op row_op, R (*function)(const Call&, A...))
        : EvaluateRow(make_row<R, A...>(row_op, function, std::index_sequence_for<A...>{})) {}
    template <class Lambda>
    Row(Op row_op, Lambda lambda) : Row(row_op, +lambda) {}
};

const std::vector<EvaluateRow>& rows() {
    static const std::vector<EvaluateRow> table = {
        // what the vertex stage hands over
        Row{Op::position, [](const Call& c) { return c.pixel.position; }},
        Row{Op::vertex_normal, [](const Call& c) { return c.pixel.vertex_normal; }},
        Row{Op::vertex_tangent, [](const Call& c) { return c.pixel.vertex_tangent; }},
        Row{Op::uv_set, [](const Call& c) { return c.pixel.uvs[c.value.index]; }},
        Row{Op::facing, [](const Call& c) { return c.pixel.facing; }},
        // numbers
        Row{Op::constant, [](const Call& c) { return datum_of(c.value.type, c.value.number); }},
        Row{Op::parameter, [](const Call& c) { return c.bindings.parameters[c.value.index]; }},
        Row{Op::splat, [](double x) { return dvec2(x, x); }},
        Row{Op::color, [](dvec3 rgb) { return rgb; }},
        // frame
        Row{Op::base_normal, ref::base_normal},
        Row{Op::mirror_normal, ref::mirror_normal},
        Row{Op::frame,
            [](const Call& c, dvec3 p, dvec3 n) { return ref::frame(p, c.pixel.dpdx, c.pixel.dpdy, n); }},
        Row{Op::basis_vertex, ref::basis_vertex},
        Row{Op::basis_uv, ref::basis_uv},
        Row{Op::basis_mirror, ref::basis_mirror},
        // coordinates and textures
        Row{Op::uv_scale, ref::uv_scale},
        Row{Op::sample, [](const Call& c, const Uv& uv) { return c.texture().at(uv); }},
        Row{Op::decode_normal_xyz,
            [](const Call& c, dvec4 t) {
                return dvec3(ref::decode_signed(t.x, c.zero()), ref::decode_signed(t.y, c.zero()),
                             ref::decode_signed(t.z, c.zero()));
            }},
        Row{Op::decode_normal_xy,
            [](const Call& c, dvec4 t) {
                return dvec2(ref::decode_signed(t.x, c.zero()), ref::decode_signed(t.y, c.zero()));
            }},
        // derivatives
        Row{Op::deriv_from_normal_xyz, ref::deriv_from_normal_xyz},
        Row{Op::deriv_from_normal_xy, ref::deriv_from_normal_xy},
        Row{Op::deriv_green_up, ref::deriv_green_up},
        Row{Op::scale_deriv, [](double s, dvec2 d) { return s * d; }},
        Row{Op::add_deriv, [](dvec2 a, dvec2 b) { return a + b; }},
        // surface gradients
        Row{Op::zero_surfgrad, [] { return dvec3(0.0); }},
        Row{Op::surfgrad_from_tbn, ref::surfgrad_from_tbn},
        Row{Op::scale_surfgrad, [](double s, dvec3 g) { return ref::combine_scale(g, s); }},
        Row{Op::add_surfgrad, ref::combine_add},
        // normals
        Row{Op::resolve, ref::resolve},
        Row{Op::flip, ref::flip},
    };
    return table;
}

}  // namespace

std::span<const EvaluateRow> all_evaluate_rows() {
    return rows();
}

const EvaluateRow* evaluate_row(Op op) {
    static const std::vector<const EvaluateRow*> by_op = [] {
        std::vector<const EvaluateRow*> out(all_ops().size(), nullptr);
        for (const EvaluateRow& row : rows()) {
            const EvaluateRow*& slot = out[static_cast<std::size_t>(row.op)];
            SG_ASSERT(slot == nullptr);
            slot = &row;
        }
        return out;
    }();
    return by_op[static_cast<std::size_t>(op)];
}

}  // namespace sg::ir

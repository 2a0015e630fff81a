// normal_blend: two tangent-space maps, each on its own uv set, put together in one of the ways in use.
#include "layers/kind.hpp"
#include "layers/lower_context.hpp"

namespace sg::layers {
namespace {

using ir::Op;
using ir::ValueId;

enum FieldIndex : std::size_t {
    kMethod,
    kTexture,
    kUv,
    kBasis,
    kTiling,
    kWeight,
    kSecondTexture,
    kSecondUv,
    kSecondTiling,
    kSecondWeight
};
enum MethodChoice : std::uint32_t { kPd, kWhiteout, kUdn, kRnm, kWeighted };
enum BasisChoice : std::uint32_t { kBasisUv, kBasisVertex };

// Whether both maps run the same way over the surface, so that one tangent space serves both.
bool aligned(FieldValues values) {
    const Coordinate &a = values[kUv].uv, &b = values[kSecondUv].uv;
    const FieldValue &tiling_a = values[kTiling], &tiling_b = values[kSecondTiling];
    if (a.set != b.set || a.rotation != b.rotation || tiling_a.parameter != tiling_b.parameter) return false;
    for (std::size_t i = 0; i < 2; ++i) {
        if (a.scale[i] * tiling_a.number[i] * b.scale[i] * tiling_b.number[i] < 0) return false;
    }
    return true;
}

Rule weights(std::string_view field) {
    return {.field = field,
            .word = "",
            .other = "method",
            .words = {"weighted"},
            .message = "only 'weighted' has weights, expected \"method\": \"weighted\" beside them"};
}

// The derivatives that the two maps add, each along its own coordinate.
std::array<ValueId, 2> blended(LowerContext& context, FieldValues values, std::array<ValueId, 2> derivs) {
    ir::Builder& builder = context.builder();
    std::uint32_t method = values[kMethod].index;
    if (method == kPd) return derivs;
    if (method == kWeighted) {
        ValueId first = builder.add(Op::scale_deriv, {context.number(values[kWeight]), derivs[0]}, "deriv");
        return {first, builder.add(Op::scale_deriv, {context.number(values[kSecondWeight]), derivs[1]},
                                   "second_deriv")};
    }
    ValueId a = builder.add(Op::normal_from_deriv, {derivs[0]}, "m"),
            b = builder.add(Op::normal_from_deriv, {derivs[1]}, "second_m");
    if (method == kRnm) {
        ValueId turned = builder.add(Op::combine_rnm, {a, b}, "m");
        return {builder.add(Op::deriv_from_map_normal, {turned}, "deriv"), ValueId{}};
    }
    ValueId pair =
        builder.add(method == kWhiteout ? Op::combine_whiteout : Op::combine_udn, {a, b}, "derivs");
    return {builder.add(Op::pair_first, {pair}), builder.add(Op::pair_second, {pair})};
}

ValueId lower(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    MapPlace first = context.place_map(values[kUv].uv, values[kTiling], values[kBasis].index == kBasisVertex);
    MapPlace second = context.place_map(values[kSecondUv].uv, values[kSecondTiling], false);
    std::array<ValueId, 2> derivs{context.map_deriv({values[kTexture].index}, first.uv)};
    derivs[1] = context.map_deriv({values[kSecondTexture].index}, second.uv);
    // Without a common tangent space one map is turned by the other about the base normal.
    bool in_space = values[kMethod].index == kRnm && !aligned(values);
    auto [a, b] = in_space ? derivs : blended(context, values, derivs);
    ValueId gradient = builder.add(Op::surfgrad_from_tbn, {a, context.basis_of(first)});
    if (!b.valid()) return gradient;
    ValueId other = builder.add(Op::surfgrad_from_tbn, {b, context.basis_of(second)});
    return in_space ? builder.add(Op::combine_reoriented, {context.normal(), gradient, other})
                    : builder.add(Op::add_surfgrad, {gradient, other});
}

Field map(std::string_view name, std::string_view doc) {
    using enum ir::TextureEncoding;
    return {.name = name,
            .kind = FieldKind::texture,
            .required = true,
            .encodings = {tangent_normal, tangent_normal_xy, derivative},
            .doc = doc};
}
Field tiling(std::string_view name) {
    return {.name = name,
            .kind = FieldKind::pair,
            .fallback = 1,
            .minimum = -10000,
            .maximum = 10000,
            .unit = "repeats per uv unit",
            .doc = "how often the map repeats along s and t; negative values mirror"};
}
Field weight(std::string_view name) {
    return {.name = name,
            .kind = FieldKind::number,
            .fallback = 1,
            .minimum = -1000,
            .maximum = 1000,
            .doc = "of 'weighted': the factor on the map's slope"};
}

}  // namespace

const LayerKind& normal_blend() {
    static const LayerKind kRow{
        .name = "normal_blend",
        .doc =
            "two tangent-space maps put together in one of the ways in use, across uv sets; strength is a "
            "factor on the slope",
        .fields = {{.name = "method",
                    .kind = FieldKind::choice,
                    .choices = {"pd", "whiteout", "udn", "rnm", "weighted"},
                    .doc = "pd: slopes add, as two layers of kind normal_map do; whiteout: each is steeper "
                           "where the other is; udn: the second is "
                           "flatter where the first is steep; rnm: the second stands on the first "
                           "(cheapest on one uv set, turned and mirrored alike); "
                           "weighted: slopes add with a factor each"},
                   map("texture", "the first map"),
                   {.name = "uv",
                    .kind = FieldKind::uv,
                    .doc = "the uv set that places the first map, or an object that transforms one"},
                   {.name = "basis",
                    .kind = FieldKind::choice,
                    .fallback = kBasisUv,
                    .choices = {"uv", "vertex"},
                    .doc = "of the first map: tangents from the derivatives of the uv set, or "
                           "mikkTSpace-compliant from the vertex (uv 0 only); "
                           "the second takes them from its uv set"},
                   tiling("tiling"),
                   weight("weight"),
                   map("second_texture", "the second map"),
                   {.name = "second_uv",
                    .kind = FieldKind::uv,
                    .doc = "the uv set that places the second map, or an object that transforms one"},
                   tiling("second_tiling"),
                   weight("second_weight"),
                   follow_parallax()},
        .rules = {vertex_basis(), weights("weight"), weights("second_weight")},
        .lower = lower,
    };
    return kRow;
}

}  // namespace sg::layers

// normal_map: a tangent-space normal map on any uv set.
#include "layers/layer_kind.hpp"
#include "layers/lower_context.hpp"

namespace sg::layers {
namespace {

enum FieldIndex : std::size_t { kTexture, kUv, kBasis, kTiling, kStrength };
enum BasisChoice : std::uint32_t { kBasisUv, kBasisVertex };

std::optional<FieldFault> check(std::span<const FieldValue> values) {
    if (values[kBasis].index == kBasisVertex && values[kUv].index != 0) {
        return FieldFault{kBasis, "the vertex tangents belong to uv 0, expected \"basis\": \"uv\" on another uv set"};
    }
    return std::nullopt;
}

ir::ValueId lower(LowerContext& context, std::span<const FieldValue> values) {
    ir::Builder& builder = context.builder();
    const FieldValue& tiling = values[kTiling];
    bool tiled = tiling.parameter.valid() || tiling.number != std::array{1.0, 1.0};
    bool from_vertex = values[kBasis].index == kBasisVertex;

    ir::ValueId uv = context.uv(values[kUv].index);
    ir::ValueId basis = from_vertex ? context.basis_vertex() : ir::ValueId{};
    if (tiled) {
        ir::ValueId scale = context.pair(tiling);
        uv = builder.add(ir::Op::uv_scale, {uv, scale}, "uv");
        // A negative tiling mirrors the picture, so +s and +t turn; tangents from the uv see that by themselves.
        if (from_vertex) basis = builder.add(ir::Op::basis_mirror, {basis, scale}, "basis");
    }
    if (!from_vertex) basis = builder.add(ir::Op::basis_uv, {context.frame(), uv}, "basis");

    ir::ValueId deriv = context.normal_map_deriv({values[kTexture].index}, uv);
    deriv = builder.add(ir::Op::scale_deriv, {context.number(values[kStrength]), deriv}, "deriv");
    return builder.add(ir::Op::surfgrad_from_tbn, {deriv, basis});
}

}  // namespace

const LayerKind& normal_map() {
    static const LayerKind kRow{
        .name = "normal_map",
        .doc = "a tangent-space normal map on a uv set",
        .fields = {{.name = "texture",
                    .kind = FieldKind::texture,
                    .required = true,
                    .doc = "the map, of encoding tangent_normal or tangent_normal_xy"},
                   {.name = "uv", .kind = FieldKind::uv_set, .doc = "the uv set that places the map"},
                   {.name = "basis",
                    .kind = FieldKind::choice,
                    .fallback = kBasisUv,
                    .choices = {"uv", "vertex"},
                    .doc = "tangents from the derivatives of the uv set, or mikkTSpace-compliant from the vertex (uv 0 only)"},
                   {.name = "tiling",
                    .kind = FieldKind::pair,
                    .fallback = 1,
                    .minimum = -10000,
                    .maximum = 10000,
                    .unit = "repeats per uv unit",
                    .doc = "how often the map repeats along s and t; negative values mirror; does not change the slope"},
                   {.name = "strength",
                    .kind = FieldKind::number,
                    .fallback = 1,
                    .minimum = -1000,
                    .maximum = 1000,
                    .doc = "factor on the slope; negative values press the bumps in"}},
        .check = check,
        .lower = lower,
    };
    return kRow;
}

}  // namespace sg::layers

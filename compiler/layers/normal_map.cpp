// normal_map: a tangent-space normal map on any uv set. derivative_map: the same from stored derivatives.
#include "layers/kind.hpp"
#include "layers/lower_context.hpp"

namespace sg::layers {
namespace {

enum FieldIndex : std::size_t { kTexture, kUv, kBasis, kTiling, kScale };
enum BasisChoice : std::uint32_t { kBasisUv, kBasisVertex };
enum ScaleChoice : std::uint32_t { kScaleSlope, kScaleDependent };

ir::ValueId lower(LowerContext& context, FieldValues values) {
    bool scale_dependent = values[kScale].index == kScaleDependent;
    bool from_vertex = values[kBasis].index == kBasisVertex && !scale_dependent;
    MapPlace place = context.place_map(values[kUv].uv, values[kTiling], from_vertex);
    ir::ValueId deriv = context.map_deriv({values[kTexture].index}, place.uv);
    ir::Builder& builder = context.builder();
    if (!scale_dependent) return builder.add(ir::Op::surfgrad_from_tbn, {deriv, context.basis_of(place)});
    return builder.add_indexed(ir::Op::surfgrad_from_height, values[kTexture].index,
                               {context.frame(), place.uv, deriv});
}

std::vector<Rule> rules() {
    return {vertex_basis(),
            {.field = "basis",
             .word = "",
             .other = "scale",
             .words = {"slope"},
             .message = "a scale-dependent map needs no basis, expected \"scale\": \"slope\" beside it"}};
}

std::vector<Field> fields(std::vector<ir::TextureEncoding> encodings, std::string_view texture_doc) {
    return {{.name = "texture",
             .kind = FieldKind::texture,
             .required = true,
             .encodings = std::move(encodings),
             .doc = texture_doc},
            {.name = "uv",
             .kind = FieldKind::uv,
             .doc = "the uv set that places the map, or an object that transforms one"},
            {.name = "basis",
             .kind = FieldKind::choice,
             .fallback = kBasisUv,
             .choices = {"uv", "vertex"},
             .doc = "tangents from the derivatives of the uv set, or mikkTSpace-compliant from the vertex "
                    "(uv 0 only)"},
            {.name = "tiling",
             .kind = FieldKind::pair,
             .fallback = 1,
             .minimum = -10000,
             .maximum = 10000,
             .unit = "repeats per uv unit",
             .doc = "how often the map repeats along s and t; negative values mirror"},
            {.name = "scale",
             .kind = FieldKind::choice,
             .fallback = kScaleSlope,
             .choices = {"slope", "displacement"},
             .doc = "slope: strength is a factor on the slope, whatever the tiling; displacement: strength "
                    "is the world "
                    "length of a height of one texel, and tiling and object size count (Eq 7)"},
            follow_parallax()};
}

}  // namespace

const LayerKind& normal_map() {
    using enum ir::TextureEncoding;
    static const LayerKind kRow{
        .name = "normal_map",
        .doc = "a tangent-space normal map on a uv set",
        .fields = fields({tangent_normal, tangent_normal_xy}, "the map"),
        .rules = rules(),
        .lower = lower,
    };
    return kRow;
}

const LayerKind& derivative_map() {
    static const LayerKind kRow{
        .name = "derivative_map",
        .doc = "a map of stored derivatives on a uv set",
        .fields = fields({ir::TextureEncoding::derivative}, "the map; its range is the slope that 1 means"),
        .rules = rules(),
        .lower = lower,
    };
    return kRow;
}

}  // namespace sg::layers

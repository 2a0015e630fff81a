// custom: a function of the user's own GLSL.
#include "layers/kind.hpp"
#include "layers/lower_context.hpp"

namespace sg::layers {
namespace {

using ir::Op;
using ir::Type;
using ir::ValueId;

enum FieldIndex : std::size_t { kFile, kFunction, kReturns, kArguments, kUv, kBasis, kSpace, kEquivalent };
enum ReturnsChoice : std::uint32_t { kSurfaceGradient, kVolumeGradient, kDerivative };
enum BasisChoice : std::uint32_t { kBasisUv, kBasisVertex };

Rule of_a_derivative(std::string_view field) {
    return {.field = field,
            .word = "",
            .other = "returns",
            .words = {"derivative"},
            .message = "a gradient needs no basis, expected this beside \"returns\": \"derivative\" only"};
}

Type result(FieldValues values) {
    constexpr Type kTypes[] = {Type::SurfGrad, Type::LocalGrad, Type::Deriv};
    return kTypes[values[kReturns].index];
}

ValueId lower(LowerContext& context, FieldValues values) {
    constexpr Op kOps[] = {Op::custom_surfgrad, Op::custom_gradient, Op::custom_deriv};
    MapPlace place;
    bool from_vertex = values[kBasis].index == kBasisVertex;
    if (values[kReturns].index == kDerivative)
        place = context.place_map(values[kUv].uv, FieldValue{.number = {1, 1, 1}}, from_vertex);
    ValueId bump = context.call(kOps[values[kReturns].index], values[kFile].index, values[kFunction].word,
                                values[kArguments].arguments);
    switch (values[kReturns].index) {
        case kVolumeGradient:
            return context.surfgrad_from_local(bump, static_cast<Space>(values[kSpace].index));
        case kDerivative:
            return context.builder().add(Op::surfgrad_from_tbn, {bump, context.basis_of(place)});
        default:
            return bump;
    }
}

}  // namespace

std::span<const SurfaceArgument> surface_arguments() {
    static const SurfaceArgument kRows[] = {
        {"frame", Type::Frame, "the surface under the pixel, at this stage",
         [](LowerContext& c) { return c.frame(); }, true},
        {"normal", Type::Normal, "the unit normal, world axes, at this stage",
         [](LowerContext& c) { return c.normal(); }, true},
        {"position", Type::Position, "relative world space", [](LowerContext& c) { return c.position(); }},
        {"object", Type::Volume, "the pixel in object space",
         [](LowerContext& c) { return c.volume(Space::object); }},
        {"world", Type::Volume, "the pixel in absolute world space",
         [](LowerContext& c) { return c.volume(Space::world); }},
        {"basis_vertex", Type::Basis, "the vertex tangents, at this stage",
         [](LowerContext& c) { return c.basis_vertex(); }, true},
        {"vertex_color", Type::Vec4, "linear", [](LowerContext& c) { return c.vertex_color(); }},
        {"time", Type::Scalar, "seconds", [](LowerContext& c) { return c.time(); }},
        {"facing", Type::Scalar, "+1 on front faces, -1 on back faces",
         [](LowerContext& c) { return c.facing(); }},
    };
    return kRows;
}

const LayerKind& custom() {
    static const LayerKind kRow{
        .name = "custom",
        .doc = "a function of your own GLSL; see [GLSL of your own](README.md#glsl-of-your-own)",
        .fields = {{.name = "file",
                    .kind = FieldKind::file,
                    .required = true,
                    .doc = "the file that defines the function"},
                   {.name = "function", .kind = FieldKind::identifier, .required = true, .doc = "its name"},
                   {.name = "returns",
                    .kind = FieldKind::choice,
                    .required = true,
                    .choices = {"surface_gradient", "volume_gradient", "derivative"},
                    .doc =
                        "vec3, perpendicular to the normal, world axes; vec3, the gradient of a height in a "
                        "space; or vec2, the derivative along +s and +t of a basis"},
                   {.name = "arguments", .kind = FieldKind::arguments, .doc = "what it is handed, in order"},
                   {.name = "uv",
                    .kind = FieldKind::uv,
                    .doc = "of a derivative: the coordinate that it belongs to"},
                   {.name = "basis",
                    .kind = FieldKind::choice,
                    .fallback = kBasisUv,
                    .choices = {"uv", "vertex"},
                    .doc = "of a derivative: tangents from that coordinate, or from the vertex (uv 0 only)"},
                   {.name = "space",
                    .kind = FieldKind::choice,
                    .choices = {"object", "world"},
                    .doc = "of a volume gradient"},
                   {.name = "equivalent",
                    .kind = FieldKind::layer,
                    .doc = "a layer or group of other kinds that gives the same bump: the double-precision "
                           "reference; without one there is none"},
                   follow_parallax()},
        .rules = {of_a_derivative("uv"),
                  of_a_derivative("basis"),
                  {.field = "space",
                   .word = "",
                   .other = "returns",
                   .words = {"volume_gradient"},
                   .message = "only a volume gradient has a space, expected this beside \"returns\": "
                              "\"volume_gradient\" only"},
                  vertex_basis()},
        .result = result,
        .lower = lower,
    };
    return kRow;
}

}  // namespace sg::layers

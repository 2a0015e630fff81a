// triplanar: images projected along the three axes. planar: one of them.
#include "layers/kind.hpp"
#include "layers/lower_context.hpp"

namespace sg::layers {
namespace {

using ir::Op;
using ir::ValueId;

enum FieldIndex : std::size_t {
    kTexture,
    kSpace,
    kTiling,
    kHand,
    kOrigin,
    kExponentOrAxis,
    kTextureX,
    kTextureZ
};

struct Lookup {
    Space space{};
    std::uint32_t corner = 0;
    ValueId uvs;
};

Lookup lookup(LowerContext& context, FieldValues values) {
    Lookup out{.space = static_cast<Space>(values[kSpace].index)};
    out.corner = 2 * values[kHand].index + values[kOrigin].index;
    ir::Builder& builder = context.builder();
    ValueId volume = context.volume(out.space);
    const FieldValue& tiling = values[kTiling];
    bool tiled = tiling.parameter.valid() || tiling.node.valid() || tiling.number[0] != 1;
    if (tiled) volume = builder.add(Op::volume_scale, {volume, context.number(tiling)}, "place");
    out.uvs = builder.add_indexed(Op::triplanar_uv, out.corner, {volume}, "planes");
    return out;
}

ValueId plane(LowerContext& context, const Lookup& from, std::uint32_t axis, std::uint32_t texture) {
    ValueId uv = context.builder().add_indexed(Op::triplanar_axis, axis, {from.uvs});
    return context.map_deriv({texture}, uv);
}

ValueId lower_triplanar(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    ValueId n = context.normal();
    Lookup from = lookup(context, values);
    ValueId local_n = from.space == Space::object ? builder.add(Op::object_normal, {n}, "object_normal") : n;
    ValueId weights =
        builder.add(Op::triplanar_weights, {local_n, context.number(values[kExponentOrAxis])}, "weights");
    std::uint32_t y = values[kTexture].index;
    ValueId d_x = plane(context, from, 0, values[kTextureX].given ? values[kTextureX].index : y);
    ValueId d_y = plane(context, from, 1, y);
    ValueId d_z = plane(context, from, 2, values[kTextureZ].given ? values[kTextureZ].index : y);
    ValueId gradient =
        builder.add_indexed(Op::triplanar_gradient, from.corner, {weights, d_x, d_y, d_z}, "gradient");
    return context.surfgrad_from_local(gradient, from.space);
}

ValueId lower_planar(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    Lookup from = lookup(context, values);
    std::uint32_t axis = values[kExponentOrAxis].index;
    ValueId d = plane(context, from, axis, values[kTexture].index);
    ValueId weights = builder.add_indexed(Op::planar_weights, axis);
    ValueId gradient =
        builder.add_indexed(Op::triplanar_gradient, from.corner, {weights, d, d, d}, "gradient");
    return context.surfgrad_from_local(gradient, from.space);
}

std::vector<Field> common(std::string_view texture_doc) {
    using enum ir::TextureEncoding;
    return {{.name = "texture",
             .kind = FieldKind::texture,
             .required = true,
             .encodings = {tangent_normal, tangent_normal_xy, derivative},
             .doc = texture_doc},
            {.name = "space",
             .kind = FieldKind::choice,
             .fallback = static_cast<double>(Space::object),
             .choices = {"object", "world"},
             .doc = "where the images lie: they move with the object, or stand in the world"},
            {.name = "tiling",
             .kind = FieldKind::number,
             .fallback = 1,
             .minimum = 1e-6,
             .maximum = 1e6,
             .unit = "repeats per unit of the space",
             .doc = "how often the images repeat"},
            {.name = "hand",
             .kind = FieldKind::choice,
             .choices = {"right", "left"},
             .doc = "which way the images of x and y run along z, as texture tools for right- or left-handed "
                    "worlds have it"},
            {.name = "origin",
             .kind = FieldKind::choice,
             .choices = {"upper_left", "lower_left"},
             .doc = "which corner of an image is (0, 0)"}};
}

}  // namespace

const LayerKind& triplanar() {
    using enum ir::TextureEncoding;
    static const LayerKind kRow = [] {
        LayerKind row{.name = "triplanar",
                      .doc =
                          "images projected along x, y and z and weighted by the normal; strength is a "
                          "factor on the slope against the units of the space: in object space an instance "
                          "that is scaled by s has 1/s of the slope",
                      .fields = common("the map; of all planes, or of y where the others are given"),
                      .lower = lower_triplanar};
        row.fields.push_back({.name = "exponent",
                              .kind = FieldKind::number,
                              .fallback = 3,
                              .minimum = 0,
                              .maximum = 64,
                              .doc = "how sharply one plane gives way to the next; 0 shares equally"});
        for (std::string_view name : {"texture_x", "texture_z"}) {
            row.fields.push_back({.name = name,
                                  .kind = FieldKind::texture,
                                  .encodings = {tangent_normal, tangent_normal_xy, derivative},
                                  .doc = "the map of this plane, if it is another one"});
        }
        row.fields.push_back(follow_parallax());
        return row;
    }();
    return kRow;
}

const LayerKind& planar() {
    static const LayerKind kRow = [] {
        LayerKind row{.name = "planar",
                      .doc =
                          "an image projected along one axis; strength is a factor on the slope "
                          "against the units of the space: in object space an instance that is scaled by s "
                          "has 1/s of the slope",
                      .fields = common("the map"),
                      .lower = lower_planar};
        row.fields.push_back({.name = "axis",
                              .kind = FieldKind::choice,
                              .fallback = 1,
                              .choices = {"x", "y", "z"},
                              .doc = "along which the image is projected"});
        row.fields.push_back(follow_parallax());
        return row;
    }();
    return kRow;
}

}  // namespace sg::layers

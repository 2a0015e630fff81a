// object_normal_map: a map of normals that are already perturbed, in object or world space.
#include "layers/kind.hpp"
#include "layers/lower_context.hpp"

namespace sg::layers {
namespace {

enum FieldIndex : std::size_t { kTexture, kUv, kTiling };

ir::ValueId lower(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    ir::TextureId texture{values[kTexture].index};
    bool object = builder.module().textures[texture.index].encoding == ir::TextureEncoding::object_normal;
    ir::ValueId n = context.normal();
    ir::ValueId texel = context.texel(texture, context.uv(values[kUv].uv, values[kTiling]));
    ir::ValueId stored = builder.add_zero(object ? ir::Op::decode_object_normal : ir::Op::decode_world_normal,
                                          context.facts(texture).zero, {texel}, "stored_normal");
    if (object) stored = builder.add(ir::Op::normal_from_object, {stored}, "stored_normal");
    return builder.add(ir::Op::surfgrad_from_normal, {n, stored});
}

}  // namespace

const LayerKind& object_normal_map() {
    using enum ir::TextureEncoding;
    static const LayerKind kRow{
        .name = "object_normal_map",
        .doc =
            "a map of perturbed normals in object or world space; strength is a factor on the slope against "
            "the base normal",
        .fields = {{.name = "texture",
                    .kind = FieldKind::texture,
                    .required = true,
                    .encodings = {object_normal, world_normal},
                    .doc = "the map; its encoding says the space"},
                   {.name = "uv",
                    .kind = FieldKind::uv,
                    .doc = "the uv set that the map was baked on, or an object that transforms one"},
                   {.name = "tiling",
                    .kind = FieldKind::pair,
                    .fallback = 1,
                    .minimum = -10000,
                    .maximum = 10000,
                    .unit = "repeats per uv unit",
                    .doc = "how often the map repeats along s and t; what it stores does not turn with it"},
                   follow_parallax()},
        .lower = lower,
    };
    return kRow;
}

}  // namespace sg::layers

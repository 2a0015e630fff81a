// height_map: bumps straight from heights, as displacement (tiling and object size count) or as slopes.
#include "layers/kind.hpp"
#include "layers/lower_context.hpp"

namespace sg::layers {
namespace {

enum FieldIndex : std::size_t { kTexture, kUv, kTiling, kMethod, kScale };
enum MethodChoice : std::uint32_t { kForward, kHq, kScreen };
enum ScaleChoice : std::uint32_t { kScaleDependent, kScaleSlope };

ir::ValueId lower(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    std::uint32_t texture = values[kTexture].index;
    ir::ValueId frame = context.frame();
    ir::ValueId uv = context.uv(values[kUv].uv, values[kTiling]);
    if (values[kMethod].index == kScreen)
        return builder.add_indexed(ir::Op::surfgrad_from_three_taps, texture, {frame, uv});
    ir::Op method = values[kMethod].index == kHq ? ir::Op::deriv_from_height_hq : ir::Op::deriv_from_height;
    ir::ValueId deriv = builder.add_indexed(method, texture, {uv}, "deriv");
    if (values[kScale].index == kScaleSlope)
        return builder.add(ir::Op::surfgrad_from_tbn,
                           {deriv, builder.add(ir::Op::basis_uv, {frame, uv}, "basis")});
    return builder.add_indexed(ir::Op::surfgrad_from_height, texture, {frame, uv, deriv});
}

}  // namespace

const LayerKind& height_map() {
    static const LayerKind kRow{
        .name = "height_map",
        .doc = "a height map on a uv set (red channel)",
        .fields =
            {{.name = "texture",
              .kind = FieldKind::texture,
              .required = true,
              .encodings = {ir::TextureEncoding::height},
              .doc = "the map"},
             {.name = "uv",
              .kind = FieldKind::uv,
              .doc = "the uv set that places the map, or an object that transforms one"},
             {.name = "tiling",
              .kind = FieldKind::pair,
              .fallback = 1,
              .minimum = -10000,
              .maximum = 10000,
              .unit = "repeats per uv unit",
              .doc = "how often the map repeats along s and t; negative values mirror"},
             {.name = "method",
              .kind = FieldKind::choice,
              .fallback = kHq,
              .choices = {"forward", "hq", "screen"},
              .doc = "forward difference over at least a texel; smooth under magnification (Eq 20 and 21); "
                     "difference to the neighbouring pixels (Listing 7)"},
             {.name = "scale",
              .kind = FieldKind::choice,
              .fallback = kScaleDependent,
              .choices = {"displacement", "slope"},
              .doc = "displacement: strength is the world length of the height 1, and tiling and object size "
                     "count (Eq 7); slope: strength is the height 1 in texels, whatever the tiling"},
             follow_parallax()},
        .rules = {{.field = "scale",
                   .word = "slope",
                   .other = "method",
                   .words = {"forward", "hq"},
                   .message = "'screen' measures heights against positions, expected \"scale\": "
                              "\"displacement\" beside it"}},
        .lower = lower,
    };
    return kRow;
}

}  // namespace sg::layers

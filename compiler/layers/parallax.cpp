// THE table of parallax kinds: how an entry of `bump` finds what the eye sees of a surface that is displaced
// by a texture. A kind is one row here.
#include "layers/kind.hpp"
#include "layers/lower_context.hpp"

namespace sg::layers {
namespace {

using ir::Op;
using ir::Type;
using ir::ValueId;

// The fields of every kind, in this order; behind them those of the kind.
enum FieldIndex : std::size_t { kTexture, kUv, kTiling, kStrength, kMesh, kOwnFields };
enum StepsField : std::size_t { kSteps = kOwnFields };
enum HeightField : std::size_t { kZeroLevel = kOwnFields, kMinSteps, kMaxSteps };
enum MeshChoice : std::uint32_t { kCurved, kFlat };

// What all kinds begin with.
struct Start {
    ValueId uv, view;
    ir::TextureId texture;
};
Start start(LowerContext& context, FieldValues values) {
    ValueId uv = context.uv(values[kUv].uv, values[kTiling]);
    return {uv, context.texture_view(uv), {values[kTexture].index}};
}

// The end of all: the surface that was found takes the place of the mesh.
void finish(LowerContext& context, FieldValues values, const Start& from, ValueId offset, ValueId height) {
    context.move_surface(
        {from.uv, values[kUv].uv, values[kTiling], offset, height, values[kMesh].index == kCurved});
}

// (scale, bias) of a texel: the surface lies at bias + scale texel along the normal that the viewer sees.
ValueId heights(LowerContext& context, const FieldValue& strength, const FieldValue& zero_level) {
    ir::Builder& builder = context.builder();
    ValueId scale = context.height_of_viewed_side(strength);
    ValueId below = builder.add(Op::subtract, {context.constant(0), context.number(zero_level)});
    return builder.add(Op::pair, {scale, builder.add(Op::multiply, {scale, below})}, "heights");
}

void lower_offset(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    Start from = start(context, values);
    ValueId scale = heights(context, values[kStrength], values[kZeroLevel]);
    auto height_at = [&](ValueId uv) {
        return builder.add_indexed(Op::parallax_height, from.texture.index, {uv, scale}, "height");
    };
    ValueId offset = builder.add(Op::parallax_offset, {from.view, height_at(from.uv)}, "offset");
    finish(context, values, from, offset,
           height_at(builder.add(Op::parallax_uv, {from.uv, offset}, "seen_uv")));
}

// A parallax map stores n_z (2 h - 1): half the strength is what its value 1 means.
void lower_steps(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    Start from = start(context, values);
    double zero = context.facts(from.texture).zero, reach = zero == 127.5 ? 127.5 : 127.0;
    double scale = 255 / reach, bias = -zero / reach;
    ValueId strength = context.height_of_viewed_side(values[kStrength]);
    auto times = [&](double factor) {
        return builder.add(Op::multiply, {strength, context.constant(factor)});
    };
    double count = values[kSteps].index;
    ValueId decode = builder.constant(Type::Vec2, {scale, bias});
    ValueId offset = builder.add_indexed(
        Op::parallax_steps, from.texture.index,
        {from.view, from.uv, times(0.5 / count), decode, context.constant(count)}, "offset");
    ValueId of_value = builder.add(Op::pair, {times(0.5 * scale), times(0.5 * bias)}, "heights");
    ValueId seen = builder.add(Op::parallax_uv, {from.uv, offset}, "seen_uv");
    finish(context, values, from, offset,
           builder.add_indexed(Op::parallax_height, from.texture.index, {seen, of_value}, "height"));
}

void lower_occlusion(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    Start from = start(context, values);
    ValueId scale = heights(context, values[kStrength], values[kZeroLevel]);
    double fewest = values[kMinSteps].index, most = values[kMaxSteps].index;
    ValueId steps = context.constant(fewest);
    if (fewest != most)
        steps = builder.add(Op::parallax_step_count, {from.view, steps, context.constant(most)}, "steps");
    ValueId hit = builder.add_indexed(Op::parallax_occlusion, from.texture.index,
                                      {from.uv, from.view, scale, steps}, "hit");
    finish(context, values, from, builder.add(Op::hit_offset, {hit}), builder.add(Op::hit_height, {hit}));
}

std::optional<FieldFault> check_occlusion(FieldValues values) {
    if (values[kMinSteps].index <= values[kMaxSteps].index) return std::nullopt;
    return FieldFault{values[kMinSteps].given ? kMinSteps : kMaxSteps,
                      "'min_steps' is more than 'max_steps', expected at most as many"};
}

std::vector<Field> with_common(ir::TextureEncoding encoding, std::string_view texture_doc,
                               std::vector<Field> own) {
    std::vector<Field> fields = {
        {.name = "texture",
         .kind = FieldKind::texture,
         .required = true,
         .encodings = {encoding},
         .doc = texture_doc},
        {.name = "uv",
         .kind = FieldKind::uv,
         .doc = "the uv set that places the texture, or an object that transforms one"},
        {.name = "tiling",
         .kind = FieldKind::pair,
         .fallback = 1,
         .minimum = -10000,
         .maximum = 10000,
         .unit = "repeats per uv unit",
         .doc = "how often the texture repeats along s and t; negative values mirror"},
        {.name = "strength",
         .kind = FieldKind::number,
         .required = true,
         .minimum = -1000,
         .maximum = 1000,
         .unit = "world units",
         .doc = "how far white lies above black; negative values press the surface in"},
        {.name = "mesh",
         .kind = FieldKind::choice,
         .fallback = kCurved,
         .choices = {"curved", "flat"},
         .doc = "curved: the base normal is that of the mesh where the seen point belongs; flat: it is the "
                "same nearby, which saves the correction"}};
    for (Field& field : own) fields.push_back(std::move(field));
    return fields;
}

Field zero_level(double fallback) {
    return {.name = "zero_level",
            .kind = FieldKind::number,
            .fallback = fallback,
            .minimum = 0,
            .maximum = 1,
            .doc = "the texel value that lies on the mesh"};
}

Field step_count(std::string_view name, double fallback, double most, std::string_view doc) {
    return {.name = name,
            .kind = FieldKind::integer,
            .fallback = fallback,
            .minimum = 1,
            .maximum = most,
            .doc = doc};
}

bool is_level(FieldValues values) {
    const FieldValue& strength = values[kStrength];
    return !strength.node.valid() && !strength.parameter.valid() && strength.number[0] == 0;
}

}  // namespace

bool moves_nothing(FieldValues parallax) {
    return is_level(parallax);
}

std::span<const ParallaxKind> all_parallax_kinds() {
    using enum ir::TextureEncoding;
    static const std::vector<ParallaxKind> kKinds = {
        {.name = "offset",
         .doc = "one step along the view, as long as the surface there is high (Welsh 2004): for low, soft "
                "heights",
         .fields = with_common(height, "the heights (red)", {zero_level(0.5)}),
         .lower = lower_offset},
        {.name = "steps",
         .doc = "steps from tangent plane to tangent plane of a parallax map, which stores n_z (2 h - 1) "
                "(Lengyel 2019, 7.7)",
         .fields =
             with_common(parallax_map, "the map (red), made for this strength",
                         {step_count("steps", 4, 64, "how many; each adds its share of the whole offset")}),
         .lower = lower_steps},
        {.name = "occlusion",
         .doc = "marches along the view to the first point of the surface, so that near heights hide what "
                "lies behind (Brawley and Tatarchuk 2005)",
         .fields = with_common(height, "the heights (red)",
                               {zero_level(1), step_count("min_steps", 16, 256, "looked at straight on"),
                                step_count("max_steps", 64, 256, "looked at along the surface")}),
         .check = check_occlusion,
         .lower = lower_occlusion},
    };
    return kKinds;
}

const ParallaxKind* find_parallax_kind(std::string_view name) {
    for (const ParallaxKind& kind : all_parallax_kinds()) {
        if (kind.name == name) return &kind;
    }
    return nullptr;
}

}  // namespace sg::layers

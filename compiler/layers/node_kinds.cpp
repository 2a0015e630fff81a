// THE table of node kinds: what a mask, a strength or a surface input may be computed from. A kind is one row
// here.
#include "layers/kind.hpp"
#include "layers/lower_context.hpp"

namespace sg::layers {

NodeKind decal_mask();
NodeKind decal_color();

namespace {

using ir::Op;
using ir::Type;
using ir::ValueId;

// ---- arithmetic ----

template <Op op>
ValueId two_numbers(LowerContext& context, FieldValues values) {
    ValueId a = context.number(values[0]);
    return context.builder().add(op, {a, context.number(values[1])});
}

template <Op op>
ValueId three_numbers(LowerContext& context, FieldValues values) {
    ValueId a = context.number(values[0]), b = context.number(values[1]);
    return context.builder().add(op, {a, b, context.number(values[2])});
}

template <Op op>
ValueId two_colors(LowerContext& context, FieldValues values) {
    ValueId a = context.color(values[0]);
    return context.builder().add(op, {a, context.color(values[1])});
}

ValueId mix_color(LowerContext& context, FieldValues values) {
    ValueId a = context.color(values[0]), b = context.color(values[1]);
    return context.builder().add(Op::mix_color, {a, b, context.number(values[2])});
}

ValueId constant(LowerContext& context, FieldValues values) {
    return context.number(values[0]);
}

ValueId constant_color(LowerContext& context, FieldValues values) {
    return context.color(values[0]);
}

ValueId select(LowerContext& context, FieldValues values) {
    ValueId a = context.number(values[1]), b = context.number(values[2]);
    return context.builder().add(Op::mix, {b, a, context.number(values[0])});
}

ValueId select_color(LowerContext& context, FieldValues values) {
    ValueId a = context.color(values[1]), b = context.color(values[2]);
    return context.builder().add(Op::mix_color, {b, a, context.number(values[0])});
}

ValueId one_minus(LowerContext& context, FieldValues values) {
    return context.builder().add(Op::subtract, {context.constant(1), context.number(values[0])});
}

// From one range to another, without a bound: to[0] + (x - from[0]) (to[1] - to[0]) / (from[1] - from[0]).
ValueId remap(LowerContext& context, FieldValues values) {
    const auto& from = values[1].number;
    const auto& to = values[2].number;
    double slope = (to[1] - to[0]) / (from[1] - from[0]);
    ValueId x = context.number(values[0]);
    ValueId scaled =
        context.builder().add(Op::multiply, {x, context.written(slope, "slope", {values.data(), 0})});
    return context.builder().add(
        Op::add, {scaled, context.written(to[0] - slope * from[0], "start", {values.data(), 1})});
}

std::optional<FieldFault> check_remap(FieldValues values) {
    if (values[1].number[0] != values[1].number[1]) return std::nullopt;
    return FieldFault{1, "the range 'from' is empty, expected two different numbers"};
}

// ---- what is there ----

// 0 to 1 over a range, if there is one.
ValueId over_range(LowerContext& context, ValueId value, const FieldValue& range) {
    if (!range.given) return value;
    ValueId low = context.written(range.number[0], "low", {&range, 0});
    ValueId high = context.written(range.number[1], "high", {&range, 1});
    return context.builder().add(Op::smoothstep, {low, high, value});
}

ValueId texel(LowerContext& context, FieldValues values) {
    ValueId uv = context.uv(values[1].uv, values[2]);
    return context.texel({values[0].index}, uv);
}

ValueId texture(LowerContext& context, FieldValues values) {
    return context.builder().add_indexed(Op::channel, values[3].index, {texel(context, values)});
}

ValueId texture_color(LowerContext& context, FieldValues values) {
    return context.builder().add(Op::rgb, {texel(context, values)});
}

ValueId vertex_color(LowerContext& context, FieldValues values) {
    return context.builder().add_indexed(Op::channel_of, values[0].index, {context.vertex_color()});
}

ValueId vertex_rgb(LowerContext& context, FieldValues) {
    return context.builder().add(Op::rgb_of, {context.vertex_color()});
}

ValueId slope(LowerContext& context, FieldValues values) {
    const auto& up = values[0].number;
    ValueId n = context.normal();
    ValueId direction = context.written(Type::Vec3, {up[0], up[1], up[2]}, "up", {values.data()});
    return over_range(context, context.builder().add(Op::slope, {n, direction}), values[1]);
}

ValueId height(LowerContext& context, FieldValues values) {
    ValueId place = context.volume(static_cast<Space>(values[0].index));
    return over_range(context, context.builder().add(Op::height, {place}), values[1]);
}

ValueId view_distance(LowerContext& context, FieldValues values) {
    return over_range(context, context.builder().add(Op::view_distance, {context.position()}), values[0]);
}

ValueId noise(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    ValueId volume = context.volume(static_cast<Space>(values[1].index));
    ValueId place = builder.add(Op::volume_scale, {volume, context.number(values[2])}, "place");
    Op op = values[0].index == 0 ? Op::noise_fractal_sum : Op::noise_turbulence;
    ValueId value = builder.add_indexed(op, values[3].index, {place}, "noise");
    return over_range(context, builder.add(Op::noise_value, {value}), values[4]);
}

// ---- fields that several kinds have ----

Field number(std::string_view name, std::string_view doc) {
    return {.name = name,
            .kind = FieldKind::number,
            .required = true,
            .minimum = -1e6,
            .maximum = 1e6,
            .doc = doc};
}
Field color(std::string_view name, std::string_view doc) {
    return {
        .name = name, .kind = FieldKind::color, .required = true, .minimum = 0, .maximum = 1e4, .doc = doc};
}
Field range(std::string_view name, std::string_view doc, bool required = false) {
    return {.name = name,
            .kind = FieldKind::range,
            .required = required,
            .minimum = -1e6,
            .maximum = 1e6,
            .doc = doc};
}
Field condition() {
    return {.name = "condition",
            .kind = FieldKind::number,
            .required = true,
            .minimum = 0,
            .maximum = 1,
            .doc = "1 or true for a, 0 or false for b; between them a mix"};
}
Field channel(std::string_view doc) {
    return {.name = "channel", .kind = FieldKind::choice, .choices = {"r", "g", "b", "a"}, .doc = doc};
}
Field space() {
    return {.name = "space",
            .kind = FieldKind::choice,
            .choices = {"object", "world"},
            .doc = "where it is measured"};
}
Field uv() {
    return {.name = "uv",
            .kind = FieldKind::uv,
            .doc = "the uv set that places the image, or an object that transforms one"};
}
Field tiling() {
    return {.name = "tiling",
            .kind = FieldKind::pair,
            .fallback = 1,
            .minimum = -10000,
            .maximum = 10000,
            .unit = "repeats per uv unit",
            .doc = "how often the image repeats along s and t"};
}
constexpr std::string_view kRangeDoc =
    "goes smoothly from 0 at the first number to 1 at the second; left out: the value itself";

std::vector<NodeKind> arithmetic() {
    Field a = number("a", "first number"), b = number("b", "second number"), x = number("x", "the number");
    Field t = number("t", "0 gives a, 1 gives b");
    return {
        {.name = "constant",
         .doc = "a number under a name; of the 'nodes', 0.5 or \"$parameter\" is short for it",
         .result = Type::Scalar,
         .fields = {number("value", "the number")},
         .lower = constant},
        {.name = "add",
         .doc = "a + b",
         .result = Type::Scalar,
         .fields = {a, b},
         .lower = two_numbers<Op::add>},
        {.name = "subtract",
         .doc = "a - b",
         .result = Type::Scalar,
         .fields = {a, b},
         .lower = two_numbers<Op::subtract>},
        {.name = "multiply",
         .doc = "a b",
         .result = Type::Scalar,
         .fields = {a, b},
         .lower = two_numbers<Op::multiply>},
        {.name = "divide",
         .doc = "a / b; 0 where b is 0",
         .result = Type::Scalar,
         .fields = {a, b},
         .lower = two_numbers<Op::divide>},
        {.name = "min",
         .doc = "the smaller",
         .result = Type::Scalar,
         .fields = {a, b},
         .lower = two_numbers<Op::minimum>},
        {.name = "max",
         .doc = "the larger",
         .result = Type::Scalar,
         .fields = {a, b},
         .lower = two_numbers<Op::maximum>},
        {.name = "power",
         .doc = "a^b; 0 where a <= 0",
         .result = Type::Scalar,
         .fields = {a, b},
         .lower = two_numbers<Op::power>},
        {.name = "mix",
         .doc = "a (1 - t) + b t",
         .result = Type::Scalar,
         .fields = {a, b, t},
         .lower = three_numbers<Op::mix>},
        {.name = "select",
         .doc = "one of two, by a bool parameter",
         .result = Type::Scalar,
         .fields = {condition(), number("a", "where the condition is 1"), number("b", "where it is 0")},
         .lower = select},
        {.name = "clamp",
         .doc = "x kept within two bounds",
         .result = Type::Scalar,
         .fields = {x, number("low", "the lower bound"), number("high", "the upper bound")},
         .lower = three_numbers<Op::clamp>},
        {.name = "smoothstep",
         .doc = "from 0 at low to 1 at high, smooth at both",
         .result = Type::Scalar,
         .fields = {number("low", "where it is 0"), number("high", "where it is 1"), x},
         .lower = three_numbers<Op::smoothstep>},
        {.name = "one_minus", .doc = "1 - x", .result = Type::Scalar, .fields = {x}, .lower = one_minus},
        {.name = "remap",
         .doc = "from one range to another, not clamped",
         .result = Type::Scalar,
         .fields = {x, range("from", "the range of x", true), range("to", "the range of the result", true)},
         .check = check_remap,
         .lower = remap},
    };
}

std::vector<NodeKind> color_arithmetic() {
    Field t = number("t", "0 gives a, 1 gives b");
    return {
        {.name = "constant_color",
         .doc = "a colour under a name; of the 'nodes', [0.2, 0.3, 0.1] or \"$parameter\" is short for it",
         .result = Type::Color,
         .fields = {color("value", "linear rgb")},
         .lower = constant_color},
        {.name = "add_color",
         .doc = "a + b, per channel",
         .result = Type::Color,
         .fields = {color("a", "first colour"), color("b", "second colour")},
         .lower = two_colors<Op::add_color>},
        {.name = "multiply_color",
         .doc = "a b, per channel",
         .result = Type::Color,
         .fields = {color("a", "first colour"), color("b", "second colour")},
         .lower = two_colors<Op::multiply_color>},
        {.name = "select_color",
         .doc = "one of two colours, by a bool parameter",
         .result = Type::Color,
         .fields = {condition(), color("a", "where the condition is 1"), color("b", "where it is 0")},
         .lower = select_color},
        {.name = "mix_color",
         .doc = "a (1 - t) + b t, per channel",
         .result = Type::Color,
         .fields = {color("a", "first colour"), color("b", "second colour"), t},
         .lower = mix_color},
    };
}

std::vector<NodeKind> sources() {
    using Encoding = ir::TextureEncoding;
    Field image{.name = "texture",
                .kind = FieldKind::texture,
                .required = true,
                .encodings = {Encoding::mask, Encoding::color, Encoding::height},
                .doc = "the image"};
    Field picture{.name = "texture",
                  .kind = FieldKind::texture,
                  .required = true,
                  .encodings = {Encoding::color},
                  .doc = "the image"};
    return {
        {.name = "texture",
         .doc = "one channel of a texture",
         .result = Type::Scalar,
         .fields = {image, uv(), tiling(), channel("which channel"), follow_parallax()},
         .lower = texture},
        {.name = "texture_color",
         .doc = "the colour of a texture",
         .result = Type::Color,
         .fields = {picture, uv(), tiling(), follow_parallax()},
         .lower = texture_color},
        {.name = "vertex_color",
         .doc = "one channel of the vertex colour",
         .result = Type::Scalar,
         .fields = {channel("which channel")},
         .lower = vertex_color},
        {.name = "vertex_rgb", .doc = "the vertex colour", .result = Type::Color, .lower = vertex_rgb},
        {.name = "slope",
         .doc = "the cosine between the stage's normal and a direction in the world",
         .result = Type::Scalar,
         .fields = {{.name = "up",
                     .kind = FieldKind::direction,
                     .required = true,
                     .doc = "the direction, world axes"},
                    range("range", kRangeDoc)},
         .lower = slope},
        {.name = "height",
         .doc = "the y coordinate of the surface",
         .result = Type::Scalar,
         .fields = {space(), range("range", kRangeDoc), follow_parallax()},
         .lower = height},
        {.name = "distance",
         .doc = "how far the surface is from the camera, world units",
         .result = Type::Scalar,
         .fields = {range("range", kRangeDoc), follow_parallax()},
         .lower = view_distance},
        {.name = "noise",
         .doc = "the value of a noise",
         .result = Type::Scalar,
         .fields = {{.name = "function",
                     .kind = FieldKind::choice,
                     .choices = {"fractal_sum", "turbulence"},
                     .doc = "the sum of octaves, or of their magnitudes"},
                    space(),
                    {.name = "frequency",
                     .kind = FieldKind::number,
                     .fallback = 1,
                     .minimum = 1e-6,
                     .maximum = 1e6,
                     .unit = "cells per unit",
                     .doc = "of the first octave"},
                    {.name = "octaves",
                     .kind = FieldKind::integer,
                     .fallback = 4,
                     .minimum = 1,
                     .maximum = 16,
                     .doc = "how many"},
                    range("range", kRangeDoc),
                    follow_parallax()},
         .lower = noise},
    };
}

}  // namespace

std::span<const NodeKind> all_node_kinds() {
    static const std::vector<NodeKind> kKinds = [] {
        std::vector<NodeKind> kinds = sources();
        kinds.push_back(decal_mask());
        kinds.push_back(decal_color());
        for (NodeKind& kind : arithmetic()) kinds.push_back(std::move(kind));
        for (NodeKind& kind : color_arithmetic()) kinds.push_back(std::move(kind));
        return kinds;
    }();
    return kKinds;
}

const NodeKind* find_node_kind(std::string_view name) {
    for (const NodeKind& kind : all_node_kinds()) {
        if (kind.name == name) return &kind;
    }
    return nullptr;
}

}  // namespace sg::layers

// decal: a map thrown into object or world space by a projector. decal_mask, decal_color: what it covers, and
// a picture.
#include <cmath>
#include <numbers>

#include "layers/kind.hpp"
#include "layers/lower_context.hpp"

namespace sg::layers {
namespace {

using ir::Op;
using ir::Type;
using ir::ValueId;
using Vector = std::array<double, 3>;

// What a projector is, and how far it reaches; fields of all kinds here stand in this order.
enum ProjectorField : std::size_t {
    kShape,
    kSpace,
    kPosition,
    kRotation,
    kSize,
    kProjector,
    kHalfLength,
    kEdge,
    kAngleFade,
    kCutout
};
enum ShapeChoice : std::uint32_t { kBox, kCone, kSphere, kCapsule, kWedge };
// The layer and decal_color have an image before the projector.
constexpr std::size_t kImage = 0, kBehindImage = 1;

// ---- the projector ----

// Rounded to 12 digits, where all machines agree.
double rounded(double x) {
    return std::round(x * 1e12) / 1e12 + 0.0;
}

// The axes of the projector in the space of the lookup: to the right and up in the image, and back to the
// projector.
std::array<Vector, 3> axes_of(const Vector& degrees) {
    Vector s{}, c{};
    for (std::size_t i = 0; i < 3; ++i) {
        s[i] = rounded(std::sin(degrees[i] * std::numbers::pi / 180));
        c[i] = rounded(std::cos(degrees[i] * std::numbers::pi / 180));
    }
    // The columns of R_x R_y R_z.
    return {{{c[1] * c[2], c[0] * s[2] + s[0] * s[1] * c[2], s[0] * s[2] - c[0] * s[1] * c[2]},
             {-c[1] * s[2], c[0] * c[2] - s[0] * s[1] * s[2], s[0] * c[2] + c[0] * s[1] * s[2]},
             {s[1], -s[0] * c[1], c[0] * c[1]}}};
}

// All that is made of where a decal lies: decals in one place share a projector. The axis that it looks along
// is part 4.
NumberPlace part_of_place(LowerContext& context, FieldValues values, std::size_t part) {
    std::vector<double> numbers;
    for (std::size_t field : {kPosition, kRotation, kSize})
        numbers.insert(numbers.end(), values[field].number.begin(), values[field].number.end());
    return {context.same_lookup(std::move(numbers)), part};
}

ValueId vector(LowerContext& context, const Vector& v, NumberPlace place) {
    return context.written(Type::Vec3, {v[0], v[1], v[2]}, "projector", place);
}

// The projector's space: s runs along +x, t downward along +y, the image flies along +z (decal.glsl).
ValueId projector(LowerContext& context, FieldValues values) {
    if (values[kProjector].given) return context.builder().parameter(values[kProjector].parameter);
    const Vector &position = values[kPosition].number, &size = values[kSize].number;
    std::array<Vector, 3> axes = axes_of(values[kRotation].number);
    std::array<Vector, 4> columns{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            double along = (row == 0 ? axes[row][column] : -axes[row][column]) / size[row];
            columns[column][row] = along + 0.0;  // no -0
            columns[3][row] -= along * position[column];
        }
    }
    std::vector<ValueId> operands;
    for (std::size_t i = 0; i < columns.size(); ++i)
        operands.push_back(vector(context, columns[i], part_of_place(context, values, i)));
    return context.builder().add(Op::projector, operands, "projector");
}

Op decal_op(std::uint32_t shape) {
    return shape == kCone ? Op::decal_cone : shape == kSphere ? Op::decal_sphere : Op::decal_box;
}

ValueId falloff(LowerContext& context, FieldValues values, ValueId decal) {
    static constexpr Op kOps[] = {Op::decal_falloff_box, Op::decal_falloff_cone, Op::decal_falloff_sphere,
                                  Op::decal_falloff_capsule, Op::decal_falloff_wedge};
    std::vector<ValueId> operands{decal};
    std::uint32_t shape = values[kShape].index;
    if (shape == kCapsule) {
        ValueId per_unit =
            context.written(1 / values[kSize].number[2], "per_unit", part_of_place(context, values, 5));
        operands.push_back(
            context.builder().add(Op::multiply, {context.number(values[kHalfLength]), per_unit}));
    }
    operands.push_back(context.number(values[kEdge]));
    return context.builder().add(kOps[shape], operands, "falloff");
}

ValueId angle_fade(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    ValueId n = context.normal();
    if (values[kSpace].index == static_cast<std::uint32_t>(Space::object))
        n = builder.add(Op::object_normal, {n}, "object_normal");
    const Vector& angles = values[kAngleFade].number;
    auto cosine = [&](std::size_t i) {
        return context.written(rounded(std::cos(angles[i] * std::numbers::pi / 180)), "cosine", {&angles, i});
    };
    ValueId back = vector(context, axes_of(values[kRotation].number)[2], part_of_place(context, values, 4));
    ValueId from = cosine(0);
    return builder.add(Op::decal_angle_fade, {n, back, from, cosine(1)}, "angle_fade");
}

ValueId decal_at(LowerContext& context, FieldValues values) {
    ValueId place = context.volume(static_cast<Space>(values[kSpace].index));
    return context.builder().add(decal_op(values[kShape].index), {projector(context, values), place},
                                 "decal");
}

ValueId coverage(LowerContext& context, FieldValues values, ValueId decal) {
    ir::Builder& builder = context.builder();
    ValueId out = falloff(context, values, decal);
    auto narrow = [&](ValueId factor) { out = builder.add(Op::multiply, {out, factor}, "coverage"); };
    if (values[kAngleFade].given) narrow(angle_fade(context, values));
    if (values[kCutout].given) {
        ValueId uv = builder.add(Op::decal_uv, {decal});
        ir::TextureId cutout{values[kCutout].index};
        bool color = builder.module().textures[cutout.index].encoding == ir::TextureEncoding::color;
        narrow(builder.add_indexed(Op::channel, color ? 3 : 0, {context.texel(cutout, uv, "cutout")}));
    }
    return out;
}

// ---- the layer and the nodes ----

Covered lower_layer(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    FieldValues projector = values.subspan(kBehindImage);
    ValueId decal = decal_at(context, projector);
    ValueId deriv = context.map_deriv({values[kImage].index}, builder.add(Op::decal_uv, {decal}));
    ValueId local = builder.add(Op::decal_gradient, {deriv, decal}, "gradient");
    ValueId gradient = context.surfgrad_from_local(local, static_cast<Space>(projector[kSpace].index));
    return {gradient, coverage(context, projector, decal)};
}

ValueId lower_mask(LowerContext& context, FieldValues values) {
    return coverage(context, values, decal_at(context, values));
}

ValueId lower_color(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    ValueId uv = builder.add(Op::decal_uv, {decal_at(context, values.subspan(kBehindImage))});
    return builder.add(Op::rgb, {context.texel({values[kImage].index}, uv)});
}

// A matrix says where the projector lies: beside it nothing else may.
std::vector<Rule> placement_rules() {
    std::vector<Rule> rules;
    for (std::string_view field : {"position", "rotation", "size"})
        rules.push_back(
            {.asks = Rule::Asks::absence,
             .field = field,
             .word = "",
             .other = "projector",
             .words = {},
             .message = "the matrix says where the projector lies, expected this without 'projector'"});
    return rules;
}

std::vector<Rule> reach_rules() {
    std::vector<Rule> rules = placement_rules();
    rules.push_back({.field = "half_length",
                     .word = "",
                     .other = "shape",
                     .words = {"capsule"},
                     .message = "only a capsule has a length, expected \"shape\": \"capsule\" beside "
                                "'half_length'"});
    rules.push_back({.asks = Rule::Asks::absence,
                     .field = "angle_fade",
                     .word = "",
                     .other = "projector",
                     .words = {},
                     .message = "a matrix may stretch angles, expected 'angle_fade' beside 'rotation'"});
    rules.push_back({.field = "angle_fade",
                     .word = "",
                     .other = "shape",
                     .words = {"box", "cone", "capsule", "wedge"},
                     .message = "a sphere throws its image all ways, expected 'angle_fade' beside another "
                                "shape"});
    return rules;
}

template <std::size_t first>
std::optional<FieldFault> check(FieldValues values) {
    const FieldValue& angles = values[first + kAngleFade];
    if (!angles.given || angles.number[0] <= angles.number[1]) return std::nullopt;
    return FieldFault{first + kAngleFade, "'angle_fade' runs backwards, expected the smaller angle first"};
}

Field image(std::string_view doc, std::vector<ir::TextureEncoding> encodings) {
    return {.name = "texture",
            .kind = FieldKind::texture,
            .required = true,
            .encodings = std::move(encodings),
            .doc = doc};
}

std::vector<Field> placement_fields() {
    return {
        {.name = "shape",
         .kind = FieldKind::choice,
         .choices = {"box", "cone", "sphere", "capsule", "wedge"},
         .doc = "what the projector reaches. box, capsule, wedge: the image flies in parallel; a cone "
                "throws it from its apex, a "
                "sphere from its centre onto the six faces of a cube"},
        {.name = "space",
         .kind = FieldKind::choice,
         .choices = {"object", "world"},
         .doc = "where the projector lies: it moves with the object, or stands in the world"},
        {.name = "position",
         .kind = FieldKind::vector,
         .minimum = -1e6,
         .maximum = 1e6,
         .unit = "units of the space",
         .doc = "the middle of the shape; of a cone its apex, of a wedge the middle of its edge"},
        {.name = "rotation",
         .kind = FieldKind::vector,
         .minimum = -3600,
         .maximum = 3600,
         .unit = "degrees",
         .doc = "about x, then its own y, then its own z; at 0, 0, 0 the image stands upright to +y and "
                "flies along -z"},
        {.name = "size",
         .kind = FieldKind::vector,
         .fallback = 1,
         .minimum = 1e-6,
         .maximum = 1e6,
         .unit = "units of the space",
         .doc = "half the width, height and depth of a box; the radii of a sphere or capsule; of a cone "
                "or wedge half the width and "
                "height where it ends, and its length"},
        {.name = "projector",
         .kind = FieldKind::matrix,
         .minimum = -1e12,
         .maximum = 1e12,
         .doc = "in place of position, rotation and size: the matrix from the space to the projector's, in "
                "which the shape is of size 1, the image's right lies along +x, its lower side along +y, and "
                "it flies along +z; its last row counts as 0, 0, 0, 1"}};
}

std::vector<Field> reach_fields() {
    return {
        {.name = "half_length",
         .kind = FieldKind::number,
         .minimum = 0,
         .maximum = 1e6,
         .unit = "units of the space",
         .doc = "of a capsule: half the length of its axis, along which the image flies; beside "
                "'projector' in units of the projector's space"},
        {.name = "edge",
         .kind = FieldKind::number,
         .fallback = 0.2,
         .minimum = 0,
         .maximum = 1,
         .doc = "the outer share of the shape over which it fades; 0 ends sharply"},
        {.name = "angle_fade",
         .kind = FieldKind::range,
         .minimum = 0,
         .maximum = 180,
         .unit = "degrees",
         .doc = "full where the stage's normal is within the first angle of the way back to the "
                "projector, nothing from the second on; "
                "left out: all angles show"},
        {.name = "cutout",
         .kind = FieldKind::texture,
         .encodings = {ir::TextureEncoding::mask, ir::TextureEncoding::color},
         .doc = "a picture thrown with the image: nothing is covered where it is 0, which is the red of a "
                "mask and the alpha of a colour"}};
}

std::vector<Field> joined(std::initializer_list<std::vector<Field>> parts) {
    std::vector<Field> out;
    for (const std::vector<Field>& part : parts) out.insert(out.end(), part.begin(), part.end());
    return out;
}

}  // namespace

NodeKind decal_mask() {
    return {.name = "decal_mask",
            .doc = "how much a decal of this projector covers, 0 to 1",
            .result = Type::Scalar,
            .fields = joined({placement_fields(), reach_fields(), {follow_parallax()}}),
            .rules = reach_rules(),
            .check = check<0>,
            .lower = lower_mask};
}

NodeKind decal_color() {
    return {
        .name = "decal_color",
        .doc = "a picture thrown by a projector, whatever its reach: mix it in by a decal_mask",
        .result = Type::Color,
        .fields = joined(
            {{image("the picture", {ir::TextureEncoding::color})}, placement_fields(), {follow_parallax()}}),
        .rules = placement_rules(),
        .lower = lower_color};
}

const LayerKind& decal() {
    using enum ir::TextureEncoding;
    static const LayerKind kRow{
        .name = "decal",
        .doc =
            "a map thrown into space by a projector; strength is a factor on the slope against the units of "
            "the space: in object space an instance that is scaled by s has 1/s of the slope. What it covers "
            "(edge, angle_fade, cutout) is a "
            "factor on its mask: \"blend\": \"add\" adds it to what lies below, \"mix\" replaces that",
        .fields = joined({{image("the map", {tangent_normal, tangent_normal_xy, derivative})},
                          placement_fields(),
                          reach_fields(),
                          {follow_parallax()}}),
        .rules = reach_rules(),
        .check = check<kBehindImage>,
        .lower_covered = lower_layer,
    };
    return kRow;
}

}  // namespace sg::layers

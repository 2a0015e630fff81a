// THE table of layer kinds. A new kind is one line in each list and one file beside this one.
#include "layers/kind.hpp"

namespace sg::layers {

const LayerKind& normal_map();
const LayerKind& derivative_map();
const LayerKind& object_normal_map();
const LayerKind& height_map();
const LayerKind& triplanar();
const LayerKind& planar();
const LayerKind& noise();
const LayerKind& decal();
const LayerKind& normal_blend();
const LayerKind& earlier_normal();
const LayerKind& custom();

std::span<const LayerKind* const> all_kinds() {
    static const LayerKind* const kKinds[] = {
        &normal_map(), &derivative_map(), &height_map(),   &object_normal_map(), &triplanar(), &planar(),
        &noise(),      &decal(),          &normal_blend(), &earlier_normal(),    &custom(),
    };
    return kKinds;
}

const LayerKind* find_kind(std::string_view name) {
    for (const LayerKind* kind : all_kinds()) {
        if (kind->name == name) return kind;
    }
    return nullptr;
}

std::span<const Field> common_fields() {
    static const Field kFields[] = {
        {.name = "strength",
         .kind = FieldKind::number,
         .fallback = 1,
         .minimum = -1000,
         .maximum = 1000,
         .doc = "factor on the bump (its unit stands with the kind); negative values press it in"},
        {.name = "mask",
         .kind = FieldKind::number,
         .fallback = 1,
         .minimum = 0,
         .maximum = 1,
         .doc = "how much of the layer shows"},
        {.name = "blend",
         .kind = FieldKind::choice,
         .fallback = kBlendAdd,
         .choices = {"add", "mix"},
         .doc = "add the layer to those before it, or go from those to it by its mask"},
    };
    return kFields;
}

std::span<const CoordinateKey> coordinate_keys() {
    static const CoordinateKey kKeys[] = {
        {.name = "set", .whole = true, .maximum = 7, .doc = "the uv set of the mesh"},
        {.name = "scale",
         .count = 2,
         .minimum = -10000,
         .maximum = 10000,
         .fallback = 1,
         .doc = "factor on the coordinate, before it turns; negative values mirror"},
        {.name = "rotation",
         .minimum = -3600,
         .maximum = 3600,
         .unit = "degrees",
         .doc = "turns +s towards +t"},
        {.name = "offset",
         .count = 2,
         .minimum = -10000,
         .maximum = 10000,
         .unit = "repeats before `tiling` multiplies",
         .doc = "is added to the coordinate"},
        {.name = "speed",
         .count = 2,
         .minimum = -1000,
         .maximum = 1000,
         .unit = "repeats per second before `tiling` multiplies",
         .doc = "is added to the coordinate, times the seconds"},
    };
    return kKeys;
}

Rule vertex_basis() {
    return {.asks = Rule::Asks::plain_uv,
            .field = "basis",
            .word = "vertex",
            .other = "uv",
            .words = {},
            .message =
                "the vertex tangents belong to uv 0 as it is, expected \"basis\": \"uv\" on another uv "
                "set or beside a rotation"};
}

constexpr std::string_view kFollowParallax = "follow_parallax";

Field follow_parallax() {
    return {
        .name = kFollowParallax,
        .kind = FieldKind::flag,
        .fallback = 1,
        .doc = "behind a parallax: true looks up what the eye sees, false the mesh itself, as without it"};
}

bool is_follow_parallax(const Field& field) {
    return field.name == kFollowParallax;
}

bool follows_parallax(FieldValues values) {
    return values.empty() || values.back().field != kFollowParallax || values.back().index == 1;
}

}  // namespace sg::layers

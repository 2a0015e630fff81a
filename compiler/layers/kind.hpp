// The tables of layer kinds, node kinds and parallax kinds: one row per kind, one file per layer kind.
// Reading, checking, defaults, ranges, documentation and lowering all come from the row; nothing else in the
// compiler names a kind.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/ir.hpp"

namespace sg::layers {

enum class FieldKind {
    texture,     // the name of a declared texture
    uv,          // a uv set 0..7, or an object that transforms one
    choice,      // one of `choices`
    flag,        // true or false
    integer,     // a whole number
    number,      // a number, "$parameter", "@node" or a node written in place
    pair,        // a number (for both), two numbers, or "$parameter" of type float or vec2
    color,       // a number (a grey), three numbers, "$parameter" of type color or vec3, "@node" or a node
    vector,      // three numbers
    matrix,      // "$parameter" of type mat4
    entry,       // the id of an earlier entry of bump
    direction,   // three numbers, not all 0; unit when checked
    range,       // two numbers
    file,        // the path of a GLSL file
    identifier,  // the name of a function in it
    arguments,   // what the function is handed: a list
    layer        // a layer, or a group of them
};

struct Field {
    std::string_view name;
    FieldKind kind{};
    bool required = false;
    double fallback = 0;  // number, pair, color, vector (all alike), integer; of a choice: the index of the
                          // default; of a flag: 1 or 0
    double minimum = 0;   // number, pair, color, vector, integer
    double maximum = 0;
    std::vector<std::string_view> choices;
    std::vector<ir::TextureEncoding> encodings;  // texture: what can be read
    std::string_view unit;                       // of numbers; "" for a plain factor
    std::string_view doc;
};

class LowerContext;

// A node instance of the material; see LowerContext::node.
struct NodeTag;
using NodeId = Id<NodeTag>;

// A texture coordinate on a uv set: st' = R(rotation) (scale st) + offset + time speed.
struct Coordinate {
    std::uint32_t set = 0;
    std::array<double, 2> scale{1, 1};
    double rotation = 0;  // degrees, turns +s towards +t
    std::array<double, 2> offset{0, 0};
    std::array<double, 2> speed{0, 0};  // repeats per second, before a tiling multiplies

    [[nodiscard]] bool is_plain() const { return *this == Coordinate{.set = set}; }
    bool operator==(const Coordinate&) const = default;
};

// What a user's function may be handed by a word.
struct SurfaceArgument {
    std::string_view name;
    ir::Type type{};
    std::string_view doc;
    ir::ValueId (*lower)(LowerContext& context) = nullptr;
    bool tells_normal = false;  // a function that is handed it can be perpendicular to the normal
};
std::span<const SurfaceArgument> surface_arguments();

// One argument of a user's function.
struct Argument {
    enum class Kind { surface, uv, texture, numbers, parameter, node } kind = Kind::numbers;
    std::uint32_t index = 0;  // surface: into surface_arguments(); texture: into the module's textures
    Coordinate uv;
    std::array<double, 4> number{};
    std::size_t count = 0;  // of the numbers
    ir::ParameterId parameter;
    NodeId node;
    ir::Type type = ir::Type::Any;  // Any for a texture
};

// The checked value of a field: which member counts follows from the field's kind.
struct FieldValue {
    std::array<double, 3>
        number{};  // number, pair, color, vector, direction, range; valid when neither of the next two is
    ir::ParameterId parameter;
    NodeId node;
    std::uint32_t index =
        0;  // texture: into the module's textures; choice; flag; integer; file: into its shaders; entry
    Coordinate uv;
    std::string word;  // identifier
    std::vector<Argument> arguments;
    bool given = false;      // it stands in the file
    std::string_view field;  // its name
};
using FieldValues = std::span<const FieldValue>;

// What each key of an object that stands for a coordinate may be, in the order of Coordinate's members.
struct CoordinateKey {
    std::string_view name;
    std::size_t count = 1;  // of numbers; of two, one number may stand for both
    bool whole = false;
    double minimum = 0, maximum = 0, fallback = 0;
    std::string_view unit;
    std::string_view doc;
};
enum CoordinateKeyIndex : std::size_t { kSet, kUvScale, kUvRotation, kUvOffset, kUvSpeed };
std::span<const CoordinateKey> coordinate_keys();

// What a field that is given asks of another one. The checker and the JSON Schema both follow it.
struct Rule {
    enum class Asks { choice, absence, plain_uv } asks = Asks::choice;
    std::string_view field;               // where it is given
    std::string_view word;                // where it is this choice, given or by default; "": any
    std::string_view other;               // what it asks something of
    std::vector<std::string_view> words;  // choice: it must be one of these, given or by default
    std::string_view message;
};
// Vertex tangents belong to uv 0 as it is.
Rule vertex_basis();

// A fault that only shows when fields are seen together, beyond what rules say.
struct FieldFault {
    std::size_t field = 0;
    std::string message;
};

// A layer's surface gradient at strength 1, unmasked, and where the layer is: 0..1, a factor on its mask.
struct Covered {
    ir::ValueId gradient;
    ir::ValueId coverage;  // invalid: everywhere
};

struct LayerKind {
    std::string_view name;
    std::string_view doc;
    std::vector<Field> fields;
    std::vector<Rule> rules;
    std::optional<FieldFault> (*check)(FieldValues values) = nullptr;  // what no rule can say; may be null
    // Of kinds that call a user's function: what it must give.
    ir::Type (*result)(FieldValues values) = nullptr;
    // The layer's surface gradient at strength 1, unmasked. Cannot fail.
    ir::ValueId (*lower)(LowerContext& context, FieldValues values) = nullptr;
    // In place of `lower`, for kinds that cover a part of the surface.
    Covered (*lower_covered)(LowerContext& context, FieldValues values) = nullptr;
};

// What every layer has beside the fields of its kind: strength, mask, blend (layer_kinds.cpp).
enum CommonField : std::size_t { kStrength, kMask, kBlend, kCommonFields };
enum Blend : std::uint32_t { kBlendAdd, kBlendMix };
std::span<const Field> common_fields();

// What `surface` says of the surface, apart from its choices (surface_fields.cpp). The lighting model decides
// which of them a material may have (ir/lighting.hpp).
std::span<const Field> surface_fields();
ir::Output surface_output(const Field& field);

// Of every kind that looks something up at the surface, the last of its fields: whether that is at the point
// that parallax shows, or where the mesh is.
Field follow_parallax();
bool is_follow_parallax(const Field& field);
bool follows_parallax(FieldValues values);  // also of kinds without the field

struct NodeKind {
    std::string_view name;
    std::string_view doc;
    ir::Type result{};  // Scalar or Color
    std::vector<Field> fields;
    std::vector<Rule> rules{};
    std::optional<FieldFault> (*check)(FieldValues values) = nullptr;
    ir::ValueId (*lower)(LowerContext& context, FieldValues values) = nullptr;
};

// How an entry of `bump` finds what is seen of a displaced surface; ends in LowerContext::move_surface.
struct ParallaxKind {
    std::string_view name;
    std::string_view doc;
    std::vector<Field> fields;
    std::vector<Rule> rules{};
    std::optional<FieldFault> (*check)(FieldValues values) = nullptr;
    void (*lower)(LowerContext& context, FieldValues values) = nullptr;
};
bool moves_nothing(FieldValues parallax);  // its strength is written as 0

// All kinds. The registries are explicit lists (layer_kinds.cpp, node_kinds.cpp, parallax.cpp).
std::span<const LayerKind* const> all_kinds();
const LayerKind* find_kind(std::string_view name);
std::span<const NodeKind> all_node_kinds();
const NodeKind* find_node_kind(std::string_view name);
std::span<const ParallaxKind> all_parallax_kinds();
const ParallaxKind* find_parallax_kind(std::string_view name);

}  // namespace sg::layers

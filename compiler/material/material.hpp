// A material as written: typed, in range, every value with its place; references are still names.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/diag.hpp"
#include "base/source.hpp"
#include "ir/ir.hpp"
#include "json/json.hpp"
#include "layers/kind.hpp"

namespace sg::material {

// Where a value stands in the file.
struct At {
    Span span;
    std::string pointer;
};

template <class T>
struct Located {
    T value{};
    At at;
};

enum class ParameterType { scalar, vec2, vec3, vec4, color, boolean, integer, matrix, texture };
// As written: "float", "vec2", ...
std::string_view parameter_type_name(ParameterType type);
struct ParameterDecl {
    Located<std::string> name;
    ParameterType type = ParameterType::scalar;
    std::array<double, 16> fallback{};           // a matrix by its columns
    std::optional<std::array<double, 2>> range;  // of each component
    std::string label;
    std::string unit;
    Located<std::string> texture;  // of type texture: the declared texture that it is by default
    Located<std::string>
        replacement;        // the file in its place, seen from the outermost material; "" without one
    SourcePtr replaced_in;  // the text of that
    SourcePtr set_in;       // the text of the instance that sets `fallback`; null without one
    At set_at;              // in that
    bool faulty = false;    // its type was reported; nothing else about it is
};

enum class ColorSpace { linear, srgb };
enum class Wrap { repeat, clamp, mirror };
enum class Filter { nearest, linear };
struct SamplerDecl {
    Wrap wrap_s = Wrap::repeat;
    Wrap wrap_t = Wrap::repeat;
    Filter filter = Filter::linear;
    Filter mip_filter = Filter::linear;
    int anisotropy = 1;  // 1..16
    bool operator==(const SamplerDecl&) const = default;
};

struct TextureDecl {
    Located<std::string> name;
    Located<std::string> file;
    SourcePtr
        file_source;  // where the file is named, if that is another text; then it is seen from the outermost
    std::string parameter;  // that it stands for; "" without one
    std::string label;      // of the parameter
    ir::TextureEncoding encoding = ir::TextureEncoding::tangent_normal;
    Located<bool> green_up{true, {}};
    Located<double> zero{127.5, {}};
    Located<double> range{1, {}};
    Located<std::string> swizzle;  // "" when not given
    std::optional<Located<ColorSpace>> color_space;
    SamplerDecl sampler;
    bool faulty = false;  // its encoding was reported
};

// Numbers, "$parameter", "@node", or a node that is written in place.
struct Expression {
    enum class Kind { numbers, parameter, node_name, node } kind = Kind::numbers;
    std::vector<double> numbers;
    std::string name;      // of the parameter or node
    std::size_t node = 0;  // into Material::nodes
    At at;
};

// An argument of a user's function.
struct ArgumentDecl {
    enum class Kind { surface, uv, texture, expression } kind = Kind::expression;
    At at;
    std::size_t surface = 0;  // into layers::surface_arguments()
    layers::Coordinate uv;
    std::string texture;
    Expression expression;
};

// The value of a field as written; which member counts follows from the field's kind.
struct FieldEntry {
    std::size_t field = 0;  // into the kind's fields
    At at;
    Expression expression;    // number, pair, color, direction, range
    std::string word;         // texture, file, identifier, entry
    std::uint32_t index = 0;  // choice, flag, integer
    layers::Coordinate uv;
    std::vector<ArgumentDecl> arguments;
};

struct NodeDecl {
    Located<std::string> name;               // "" for one written in place
    const layers::NodeKind* kind = nullptr;  // null: its kind was reported
    At at;
    std::vector<FieldEntry> entries;
};

struct LayerDecl;

// Layers that count as one: summed on their own, then blended like a layer.
struct GroupDecl {
    std::vector<LayerDecl> layers;
};

struct LayerDecl {
    Located<std::string> id;                  // empty when not given
    const layers::LayerKind* kind = nullptr;  // null for a group
    At at;
    std::vector<FieldEntry> entries;  // of the kind's fields
    std::vector<FieldEntry> common;   // of layers::common_fields()
    GroupDecl group;
    std::vector<LayerDecl> equivalent;  // at most one: what a user's function must amount to
};

struct ParallaxDecl {
    const layers::ParallaxKind* kind = nullptr;  // null: its kind was reported
    At at;
    std::vector<FieldEntry> entries;
};

struct StageDecl {
    Located<std::string> id;
    At at;
    std::optional<ParallaxDecl> parallax;
    std::vector<LayerDecl> layers;
};

enum class TwoSided { off, mirror, flip };
struct SurfaceDecl {
    std::uint32_t lighting = 0;       // into ir::all_lighting_models()
    bool unlit = false;               // it was reported; what it is told is not
    std::vector<FieldEntry> entries;  // of layers::surface_fields()
    std::optional<double> alpha_test;
    TwoSided two_sided = TwoSided::off;
};

// What the forward entry point's fragment shader may cost at most.
enum class Cost { instructions, texture_reads, interpolants };
inline constexpr std::array<std::string_view, 3> kCostNames = {"instructions", "texture_reads",
                                                               "interpolants"};
using Budget = std::array<std::optional<Located<std::uint32_t>>, kCostNames.size()>;  // by Cost

struct Material {
    SourcePtr source;
    std::string
        folder;  // of the file that is read, seen from the folder of the one that extends it; "" for that one
    std::vector<std::pair<std::string, std::string>> bases;  // that were extended: file and hash
    bool incomplete = false;                                 // the material that it extends could not be read
    std::string name;                                        // "" when not given
    std::string description;
    std::vector<ParameterDecl> parameters;
    std::vector<TextureDecl> textures;
    std::vector<NodeDecl> nodes;  // named ones first, in the order of the file; then those written in place
    std::vector<StageDecl> bump;
    SurfaceDecl surface;
    Budget budget;
};

inline constexpr int kVersion = 1;

// Reports every fault of form: unknown keys, wrong types, numbers out of range, unknown kinds and words, bad
// names. Gives what it could read even then, so that `check` can report its faults in the same run.
Material read(const json::Document& document, Diags& diags);

}  // namespace sg::material

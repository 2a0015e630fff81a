// A material as written: typed, in range, every value with its place; references are still names.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diag.hpp"
#include "base/source.hpp"
#include "ir/ir.hpp"
#include "json/json.hpp"
#include "layers/layer_kind.hpp"

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

enum class ParameterType { scalar, vec2, vec3, vec4, color };
struct ParameterDecl {
    Located<std::string> name;
    ParameterType type = ParameterType::scalar;
    std::array<double, 4> fallback{};
    std::optional<std::array<double, 2>> range;  // of each component
    std::string label;
    std::string unit;
    bool faulty = false;  // its type was reported; nothing else about it is
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
    ir::TextureEncoding encoding = ir::TextureEncoding::tangent_normal;
    bool green_up = true;
    double zero = 127.5;
    Located<ColorSpace> color_space;
    SamplerDecl sampler;
};

// A number or "$parameter" (then `numbers` is empty).
struct NumberOrParameter {
    std::vector<double> numbers;
    std::string parameter;
};

// The value of a layer's field as written; which member counts follows from the field's kind.
struct FieldEntry {
    std::size_t field = 0;  // into LayerKind::fields
    At at;
    NumberOrParameter number;  // number, pair
    std::string word;          // texture
    std::uint32_t index = 0;   // uv_set, choice
};

struct LayerDecl {
    Located<std::string> id;  // empty when not given
    const layers::LayerKind* kind = nullptr;
    At at;
    std::vector<FieldEntry> entries;
};

struct StageDecl {
    Located<std::string> id;
    At at;
    std::vector<LayerDecl> layers;
};

enum class TwoSided { off, mirror, flip };
struct SurfaceDecl {
    Located<NumberOrParameter> base_color;
    Located<NumberOrParameter> metallic;
    Located<NumberOrParameter> roughness;
    TwoSided two_sided = TwoSided::off;
};

struct Material {
    SourcePtr source;
    std::string name;  // "" when not given
    std::string description;
    std::vector<ParameterDecl> parameters;
    std::vector<TextureDecl> textures;
    std::vector<StageDecl> bump;
    SurfaceDecl surface;
};

inline constexpr int kVersion = 1;

// Reports every fault of form: unknown keys, wrong types, numbers out of range, unknown kinds and words, bad names.
// Gives what it could read even then, so that `check` can report its faults in the same run.
Material read(const json::Document& document, Diags& diags);

}  // namespace sg::material

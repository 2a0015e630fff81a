// The intermediate representation of a material.
//
// A Module is a list of values in evaluation order. Each value is the result of one operation (ops.def) on
// earlier values and has one type (types.def). There is no control flow, nothing is written to, and
// evaluating a value has no effect, so equal values may be merged and unused ones dropped. Screen derivatives
// are taken by a few operations alone (takes_screen_derivatives), of values in uniform control flow; behind
// parallax none may stand.
//
// What a type means is what may be done with it:
//   * a Deriv belongs to the basis that it will be projected with; derivatives add only before that
//   projection;
//   * a SurfGrad is perpendicular to the normal of its frame; those of one frame add in any order;
//   * a VolGrad is not perpendicular to anything: it is projected before it is added to a SurfGrad or
//   resolved.
// `verify` refuses every other mix.
//
// Outputs name the values that leave the module; the entry points take what they need of them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/id.hpp"

namespace sg::ir {

enum class Type : std::uint8_t {
#define SG_TYPE(identifier, glsl, meaning) identifier,
#include "ir/types.def"
#undef SG_TYPE
    Any,  // in rows of ops.def only
};

enum class Op : std::uint8_t {
#define SG_OP(identifier, result, operands, attribute, glsl, include, meaning) identifier,
#include "ir/ops.def"
#undef SG_OP
};

enum class Attribute : std::uint8_t {
    None,
    Set,
    Texture,
    Parameter,
    Zero,
    Number,
    Count,
    Channel,
    Axis,
    Corner,
    Swizzle,
    Function,
    Derived
};
// Whether Value::index holds the attribute.
bool is_index(Attribute attribute);

struct TypeInfo {
    std::string_view name;
    std::string_view glsl;
    std::string_view meaning;
};
const TypeInfo& info(Type type);
std::span<const TypeInfo> all_types();

struct OpInfo {
    Op op;
    std::string_view name;
    Type result;
    std::vector<Type> operands;
    Attribute attribute;
    std::string_view glsl;
    std::string_view include;
    std::string_view meaning;
};
const OpInfo& info(Op op);
std::span<const OpInfo> all_ops();

// Whether it takes derivatives over the screen, of what the vertex stage hands over.
bool takes_screen_derivatives(Op op);
// Whether it finds what the pixel shows of a displaced surface: neighbouring pixels see other places.
bool looks_along_ray(Op op);

struct Value;
using ValueId = Id<Value>;

enum class TextureEncoding : std::uint8_t {
    tangent_normal,
    tangent_normal_xy,
    derivative,
    object_normal,
    world_normal,
    height,
    color,
    mask,
    parallax_map
};
std::string_view encoding_name(TextureEncoding encoding);
std::span<const std::string_view> encoding_names();  // in the order of the enumeration

// A texture as the shader sees it. The file and the sampler's settings stay with the material.
struct Texture {
    std::string name;
    TextureEncoding encoding = TextureEncoding::tangent_normal;
};
using TextureId = Id<Texture>;

struct Parameter {
    std::string name;
    Type type = Type::Scalar;  // Scalar, Vec2, Vec3, Vec4, Color or Projector
    std::optional<std::array<double, 2>> range = std::nullopt;  // of each component; the engine keeps to it
};
using ParameterId = Id<Parameter>;

// A file of the user's own GLSL. The text, which is not printed, is safe to be put into a shader: all that it
// declares begins with shader_prefix of its number.
struct Shader {
    std::string file;
    std::string text;
    std::vector<std::string> names;  // all that it declares, with the prefix
};
std::string shader_prefix(std::size_t shader);

// A function of such a file as one layer calls it. A texture is handed over as it is, all else are operands.
struct Argument {
    Type type = Type::Any;
    TextureId texture;  // invalid: an operand of the type
    bool operator==(const Argument&) const = default;
};
struct Function {
    std::string name;
    std::uint32_t shader = 0;  // into Module::shaders
    std::vector<Argument> arguments;
    bool operator==(const Function&) const = default;
};

// The layer that a value was lowered from: its id and kind as written, for names and comments in generated
// text.
struct Layer {
    std::string id;
    std::string kind;
    std::string group = {};  // the ids of the groups that it stands in, "outer/inner"; "" for none
};
using LayerId = Id<Layer>;

struct Value {
    Op op{};
    Type type{};
    std::vector<ValueId> operands;
    std::uint32_t index = 0;         // every attribute but Zero and Number
    std::array<double, 4> number{};  // Zero: [0]; Number: as many as the type has
    std::string name;                // a hint for generated text, may be empty, need not be unique
    bool is_node = false;            // the name is one that the author gave to a node of the material
    LayerId layer;                   // invalid: belongs to no layer
};

// Numbers that the host computes from parameters before it draws, and hands over beside them.
struct Derived {
    std::string name;
    Type type{};   // as of a parameter
    ValueId host;  // into Module::host
    bool positive =
        false;  // a number that was lifted: all of it is above 0, in every material of this structure
};

// What may leave a module, with the type it must have.
enum class Output : std::uint8_t {
    normal,
    base_color,
    metallic,
    roughness,
    specular,   // of models without metallic and roughness
    shininess,  // likewise
    occlusion,
    emission,
    opacity,
    cutoff,  // below this opacity nothing is drawn; absent without alpha test
    frame,
    gradient,
    basis_vertex,
    vertex_color,
    uv,
    volume,
    normal_derivatives,
    moved_position,
    moved_uv,
    layer  // what one layer adds by itself, under its mask
};

struct OutputBinding {
    Output output{};
    std::uint32_t set =
        0;  // of uv and moved_uv: which uv set; of volume: 0 object space, 1 world space; of layer: which
    ValueId value;
    bool operator==(const OutputBinding&) const = default;
};
// Whether the vertex stage hands it over, as it is or moved by parallax.
bool is_interpolated(Output output);
// Whether OutputBinding::set counts.
bool is_numbered(Output output);
std::string_view output_name(Output output);
Type output_type(Output output);
std::span<const Output> all_outputs();

struct Module {
    std::string name;
    std::uint32_t lighting = 0;  // into all_lighting_models()
    std::vector<Texture> textures;
    std::vector<Parameter> parameters;
    std::vector<Value> host;  // on parameters alone; operands are earlier values of this list
    std::vector<Derived> derived;
    std::vector<Shader> shaders;
    std::vector<Function> functions;
    std::vector<Layer> layers;
    std::vector<Value> values;
    std::vector<OutputBinding> outputs;

    [[nodiscard]] const Value& at(ValueId id) const { return values[id.index]; }
    [[nodiscard]] ValueId output(Output which) const;  // invalid if absent
};

// Attribute Swizzle: which channel stands in the place of each.
std::array<std::uint32_t, 4> swizzle_channels(std::uint32_t swizzle);
std::uint32_t swizzle_of(const std::array<std::uint32_t, 4>& channels);

// The textures that a value reads: each by its number.
std::vector<std::uint32_t> textures_of(const Module& module, const Value& value);
// The types of a value's operands, also where a user's function decides them.
std::vector<Type> operand_types(const Module& module, const Value& value);

// How many of Value::number a constant of this type uses; 0 for types that no constant has.
std::size_t component_count(Type type);

// How a std140 block holds a value of a type that a parameter may have.
struct Std140 {
    std::uint32_t size;
    std::uint32_t alignment;
};
Std140 std140(Type type);
constexpr std::uint32_t aligned(std::uint32_t offset, std::uint32_t alignment) {
    return (offset + alignment - 1) / alignment * alignment;
}

// Appends values; every function returns the id of the new one.
class Builder {
public:
    explicit Builder(Module& module) : module_(module) {}
    ValueId add(Op op, std::vector<ValueId> operands = {}, std::string name = "");
    ValueId add_indexed(Op op, std::uint32_t index, std::vector<ValueId> operands = {},
                        std::string name = "");
    ValueId add_zero(Op op, double zero, std::vector<ValueId> operands, std::string name = "");
    ValueId constant(Type type, std::array<double, 4> number);
    ValueId parameter(ParameterId parameter);
    // A constant that the host hands over: the index of a new Module::derived, and its value.
    std::uint32_t lift(Type type, std::array<double, 4> number, std::string name);
    ValueId derived(std::uint32_t index);
    void set_layer(LayerId layer) { layer_ = layer; }
    void output(Output which, ValueId value, std::uint32_t set = 0);
    Module& module() { return module_; }

private:
    ValueId push(Value value);
    Module& module_;
    LayerId layer_;
};

struct ModuleFault {
    struct Where {
        enum class Of : std::uint8_t { value, host, derived, output } of{};  // which list of the module
        std::size_t index = 0;
    } where;
    std::string what;
};
std::vector<ModuleFault> faults_of(const Module& module);
// The same as text: "" or one line per fault, each naming the value.
std::string verify(const Module& module);

// The text form; parse(print(m)) prints the same. Grammar in ir/text.hpp.
std::string print(const Module& module);

}  // namespace sg::ir

#include "ir/ir.hpp"

#include <algorithm>

#include "base/ice.hpp"

namespace sg::ir {
namespace {

const std::vector<TypeInfo>& types() {
    static const std::vector<TypeInfo> table = {
#define SG_TYPE(identifier, glsl, meaning) {#identifier, glsl, meaning},
#include "ir/types.def"
#undef SG_TYPE
        {"Any", "", ""},
    };
    return table;
}

const std::vector<OpInfo>& ops() {
    using enum Type;
    static const std::vector<OpInfo> table = {
#define SG_OP(identifier, result, operands, attribute, glsl, include, meaning) \
    {Op::identifier, #identifier, result, operands, Attribute::attribute, glsl, include, meaning},
#include "ir/ops.def"
#undef SG_OP
    };
    return table;
}

struct OutputRow {
    Output output;
    std::string_view name;
    Type type;
};
constexpr OutputRow kOutputs[] = {
    {Output::normal, "normal", Type::Normal},
    {Output::base_color, "base_color", Type::Color},
    {Output::metallic, "metallic", Type::Scalar},
    {Output::roughness, "roughness", Type::Scalar},
    {Output::specular, "specular", Type::Color},
    {Output::shininess, "shininess", Type::Scalar},
    {Output::occlusion, "occlusion", Type::Scalar},
    {Output::emission, "emission", Type::Color},
    {Output::opacity, "opacity", Type::Scalar},
    {Output::cutoff, "cutoff", Type::Scalar},
    {Output::frame, "frame", Type::Frame},
    {Output::gradient, "gradient", Type::SurfGrad},
    {Output::basis_vertex, "basis_vertex", Type::Basis},
    {Output::vertex_color, "vertex_color", Type::Vec4},
    {Output::uv, "uv", Type::Uv},
    {Output::volume, "volume", Type::Volume},
    {Output::normal_derivatives, "normal_derivatives", Type::NormalDerivatives},
    {Output::moved_position, "moved_position", Type::Position},
    {Output::moved_uv, "moved_uv", Type::Uv},
    {Output::layer, "layer", Type::SurfGrad},
};
constexpr Output kOutputOrder[] = {Output::normal,
                                   Output::base_color,
                                   Output::metallic,
                                   Output::roughness,
                                   Output::specular,
                                   Output::shininess,
                                   Output::occlusion,
                                   Output::emission,
                                   Output::opacity,
                                   Output::cutoff,
                                   Output::frame,
                                   Output::gradient,
                                   Output::basis_vertex,
                                   Output::vertex_color,
                                   Output::uv,
                                   Output::volume,
                                   Output::normal_derivatives,
                                   Output::moved_position,
                                   Output::moved_uv,
                                   Output::layer};
constexpr std::string_view kEncodings[] = {
    "tangent_normal", "tangent_normal_xy", "derivative", "object_normal", "world_normal", "height", "color",
    "mask",           "parallax_map"};

}  // namespace

bool is_index(Attribute attribute) {
    return attribute != Attribute::None && attribute != Attribute::Zero && attribute != Attribute::Number;
}

bool takes_screen_derivatives(Op op) {
    switch (op) {
        case Op::uv_set:
        case Op::volume_object:
        case Op::volume_world:
        case Op::frame:
        case Op::normal_derivatives:
            return true;
        default:
            return false;
    }
}

bool looks_along_ray(Op op) {
    return op == Op::parallax_offset || op == Op::parallax_steps || op == Op::parallax_occlusion;
}

std::string_view encoding_name(TextureEncoding encoding) {
    return kEncodings[static_cast<std::size_t>(encoding)];
}
std::span<const std::string_view> encoding_names() {
    return kEncodings;
}

const TypeInfo& info(Type type) {
    return types()[static_cast<std::size_t>(type)];
}
std::span<const TypeInfo> all_types() {
    return std::span(types()).first(types().size() - 1);
}
const OpInfo& info(Op op) {
    return ops()[static_cast<std::size_t>(op)];
}
std::span<const OpInfo> all_ops() {
    return ops();
}

bool is_interpolated(Output output) {
    return output == Output::uv || output == Output::volume || output == Output::moved_uv;
}
bool is_numbered(Output output) {
    return is_interpolated(output) || output == Output::layer;
}
std::string_view output_name(Output output) {
    return kOutputs[static_cast<std::size_t>(output)].name;
}
Type output_type(Output output) {
    return kOutputs[static_cast<std::size_t>(output)].type;
}
std::span<const Output> all_outputs() {
    return kOutputOrder;
}

std::string shader_prefix(std::size_t shader) {
    return shader == 0 ? "c_" : "c" + std::to_string(shader + 1) + "_";
}

std::array<std::uint32_t, 4> swizzle_channels(std::uint32_t swizzle) {
    return {swizzle & 3u, swizzle >> 2u & 3u, swizzle >> 4u & 3u, swizzle >> 6u & 3u};
}
std::uint32_t swizzle_of(const std::array<std::uint32_t, 4>& channels) {
    return channels[0] | channels[1] << 2u | channels[2] << 4u | channels[3] << 6u;
}

std::vector<std::uint32_t> textures_of(const Module& module, const Value& value) {
    std::vector<std::uint32_t> out;
    Attribute attribute = info(value.op).attribute;
    if (attribute == Attribute::Texture) out.push_back(value.index);
    if (attribute == Attribute::Function) {
        for (const Argument& argument : module.functions[value.index].arguments) {
            if (argument.texture.valid()) out.push_back(argument.texture.index);
        }
    }
    return out;
}

std::vector<Type> operand_types(const Module& module, const Value& value) {
    if (info(value.op).attribute != Attribute::Function) return info(value.op).operands;
    std::vector<Type> out;
    for (const Argument& argument : module.functions[value.index].arguments) {
        if (!argument.texture.valid()) out.push_back(argument.type);
    }
    return out;
}

ValueId Module::output(Output which) const {
    for (const OutputBinding& binding : outputs) {
        if (binding.output == which) return binding.value;
    }
    return {};
}

std::size_t component_count(Type type) {
    switch (type) {
        case Type::Scalar:
            return 1;
        case Type::Vec2:
            return 2;
        case Type::Vec3:
        case Type::Color:
            return 3;
        case Type::Vec4:
            return 4;
        default:
            return 0;
    }
}

Std140 std140(Type type) {
    if (type == Type::Projector) return {64, 16};
    switch (component_count(type)) {
        case 1:
            return {4, 4};
        case 2:
            return {8, 8};
        case 3:
            return {12, 16};
        case 4:
            return {16, 16};
        default:
            SG_UNREACHABLE("a parameter of a type that no block holds");
    }
}

ValueId Builder::push(Value value) {
    value.layer = layer_;
    module_.values.push_back(std::move(value));
    return {static_cast<std::uint32_t>(module_.values.size() - 1)};
}

ValueId Builder::add(Op op, std::vector<ValueId> operands, std::string name) {
    return push(
        {.op = op, .type = info(op).result, .operands = std::move(operands), .name = std::move(name)});
}

ValueId Builder::add_indexed(Op op, std::uint32_t index, std::vector<ValueId> operands, std::string name) {
    return push({.op = op,
                 .type = info(op).result,
                 .operands = std::move(operands),
                 .index = index,
                 .name = std::move(name)});
}

ValueId Builder::add_zero(Op op, double zero, std::vector<ValueId> operands, std::string name) {
    return push({.op = op,
                 .type = info(op).result,
                 .operands = std::move(operands),
                 .number = {zero},
                 .name = std::move(name)});
}

ValueId Builder::constant(Type type, std::array<double, 4> number) {
    SG_ASSERT(component_count(type) > 0);
    for (double& n : number) n += 0.0;  // no -0
    return push({.op = Op::constant, .type = type, .number = number});
}

ValueId Builder::parameter(ParameterId parameter) {
    return push(
        {.op = Op::parameter, .type = module_.parameters[parameter.index].type, .index = parameter.index});
}

std::uint32_t Builder::lift(Type type, std::array<double, 4> number, std::string name) {
    for (double& n : number) n += 0.0;  // no -0
    const auto end = number.begin() + static_cast<std::ptrdiff_t>(component_count(type));
    const bool positive = std::all_of(number.begin(), end, [](double x) { return x > 0; });
    module_.host.push_back({.op = Op::constant, .type = type, .number = number});
    const ValueId host{static_cast<std::uint32_t>(module_.host.size() - 1)};
    module_.derived.push_back({std::move(name), type, host, positive});
    return static_cast<std::uint32_t>(module_.derived.size() - 1);
}

ValueId Builder::derived(std::uint32_t index) {
    return push({.op = Op::derived, .type = module_.derived[index].type, .index = index});
}

void Builder::output(Output which, ValueId value, std::uint32_t set) {
    module_.outputs.push_back({which, set, value});
}

}  // namespace sg::ir

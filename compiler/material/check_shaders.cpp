// Layers that call the user's GLSL: the file, what the function is handed, what it must give.
#include <fmt/core.h>

#include <algorithm>

#include "material/checker.hpp"

namespace sg::material {

using layers::Argument;
using layers::FieldKind;

std::optional<std::size_t> Checker::shader(const std::string& written, const At& at) {
    const std::string file = written.empty() ? written : from_material(written);
    auto known = std::find_if(out.shaders.begin(), out.shaders.end(),
                              [&](const CheckedShader& s) { return s.file == file; });
    if (known != out.shaders.end()) return static_cast<std::size_t>(known - out.shaders.begin());
    auto bytes = file_below_roots(file, at);
    if (!bytes) return std::nullopt;
    if (bytes->size() > kMaxShaderBytes) {
        error(Code::too_many, at,
              fmt::format("'{}' has {} bytes, expected at most {}", printable(file), bytes->size(),
                          kMaxShaderBytes));
        return std::nullopt;
    }
    std::string hash = content_hash(*bytes);
    std::string name = file;  // it stands in front of messages
    std::replace_if(
        name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20u || c == '\x7F'; },
        '?');
    auto source = std::make_shared<Source>(Source{std::move(name), std::move(*bytes)});
    out.shaders.push_back({file, std::move(source), std::move(hash), "", {}});
    return out.shaders.size() - 1;
}

Argument Checker::argument(const ArgumentDecl& decl) {
    Argument value;
    switch (decl.kind) {
        case ArgumentDecl::Kind::surface:
            value.kind = Argument::Kind::surface;
            value.index = static_cast<std::uint32_t>(decl.surface);
            value.type = layers::surface_arguments()[decl.surface].type;
            return value;
        case ArgumentDecl::Kind::uv:
            value.kind = Argument::Kind::uv;
            value.uv = decl.uv;
            value.type = ir::Type::Uv;
            return value;
        case ArgumentDecl::Kind::texture:
            value.kind = Argument::Kind::texture;
            if (auto index = find_texture(decl.texture, decl.at)) value.index = texture_index[*index];
            return value;
        case ArgumentDecl::Kind::expression:
            break;
    }
    constexpr ir::Type kNumbers[] = {ir::Type::Scalar, ir::Type::Vec2, ir::Type::Vec3, ir::Type::Vec4};
    const Expression& written = decl.expression;
    if (written.kind == Expression::Kind::numbers) {
        std::copy(written.numbers.begin(), written.numbers.end(), value.number.begin());
        value.count = written.numbers.size();
        value.type = kNumbers[value.count - 1];
        return value;
    }
    if (written.kind == Expression::Kind::parameter) {
        using enum ParameterType;
        static constexpr ParameterType kAll[] = {scalar, vec2, vec3, vec4, color, boolean, integer};
        value.kind = Argument::Kind::parameter;
        if (const ParameterDecl* found = find_parameter(written.name, written.at, kAll))
            value.parameter = id_of(*found);
        if (value.parameter.valid()) value.type = ir_type(out.parameters[value.parameter.index].type);
        return value;
    }
    layers::FieldValue found;
    expression(written, FieldKind::color, kAnyRange, found);
    value.kind = Argument::Kind::node;
    value.node = found.node;
    if (found.node.valid()) {
        const layers::NodeKind* kind = in.nodes[found.node.index].kind;
        value.type = kind ? kind->result : ir::Type::Scalar;
    }
    return value;
}

// A function gives a vector, and GLSL does not say of which kind. One that is not told the normal cannot make
// it perpendicular to that: it is the gradient of a volume, and nothing would project it.
void Checker::knows_the_normal(const At& layer, const At& returns, std::span<const Argument> arguments) {
    auto tells = [](const Argument& a) {
        return a.kind == Argument::Kind::surface && layers::surface_arguments()[a.index].tells_normal;
    };
    auto of_arguments = [&](const Diagnostic& d) {
        return d.place.pointer.starts_with(layer.pointer + "/arguments");
    };
    if (std::any_of(arguments.begin(), arguments.end(), tells) ||
        std::any_of(diags.all().begin(), diags.all().end(), of_arguments))
        return;
    std::vector<std::string_view> words;
    for (const layers::SurfaceArgument& row : layers::surface_arguments()) {
        if (row.tells_normal) words.push_back(row.name);
    }
    error(Code::mixed_gradients, returns,
          fmt::format("a surface gradient is perpendicular to the normal, of which the function is not told, "
                      "expected {} among 'arguments', or \"returns\": \"volume_gradient\"",
                      one_of(words)));
}

// What the fields of a kind with a file amount to.
void Checker::shader_call(const LayerDecl& decl, CheckedLayer& layer) {
    auto field = [&](FieldKind kind) {
        auto row = std::find_if(decl.kind->fields.begin(), decl.kind->fields.end(),
                                [&](const layers::Field& f) { return f.kind == kind; });
        return static_cast<std::size_t>(row - decl.kind->fields.begin());
    };
    auto entry = [&](FieldKind kind) {
        auto found = std::find_if(decl.entries.begin(), decl.entries.end(),
                                  [&](const FieldEntry& e) { return e.field == field(kind); });
        return found == decl.entries.end() ? nullptr : &*found;
    };
    const FieldEntry* file = entry(FieldKind::file);
    const FieldEntry* function = entry(FieldKind::identifier);
    ShaderCall call{
        .shader = 0, .function = "", .result = "", .arguments = {}, .file_at = {}, .function_at = {}};
    if (const FieldEntry* arguments = entry(FieldKind::arguments)) {
        if (arguments->arguments.size() > kMaxArguments) {
            error(
                Code::too_many, arguments->at,
                fmt::format("{} arguments, expected at most {}", arguments->arguments.size(), kMaxArguments));
        }
        for (const ArgumentDecl& written : arguments->arguments) {
            Argument value = argument(written);
            call.arguments.emplace_back(ir::info(value.type).glsl);
            if (value.kind == Argument::Kind::texture) {
                call.arguments.back() = "texture2D";
                call.arguments.emplace_back("sampler");
            }
            layer.values[field(FieldKind::arguments)].arguments.push_back(std::move(value));
        }
    }
    const FieldEntry* returns = entry(FieldKind::choice);
    if (returns && decl.kind->result(layer.values) == ir::Type::SurfGrad)
        knows_the_normal(decl.at, returns->at, layer.values[field(FieldKind::arguments)].arguments);
    if (!file || !function) return;
    auto index = shader(file->word, file->at);
    if (!index) return;
    layer.values[field(FieldKind::file)].index = static_cast<std::uint32_t>(*index);
    call.shader = *index;
    call.function = function->word;
    call.result = ir::info(decl.kind->result(layer.values)).glsl;
    call.file_at = file->at;
    call.function_at = function->at;
    out.calls.push_back(std::move(call));
}

}  // namespace sg::material

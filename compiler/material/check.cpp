#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "material/checked.hpp"

namespace sg::material {
namespace {

namespace fs = std::filesystem;
using layers::Field;
using layers::FieldKind;
using layers::FieldValue;

struct Checker {
    const Material& in;
    Files& files;
    const Roots& roots;
    Diags& diags;
    CheckedMaterial out{};
    std::map<std::size_t, std::uint32_t> texture_index;  // from Material::textures to CheckedMaterial::textures
    std::vector<bool> texture_used;

    void error(Code code, const At& at, std::string message, std::vector<Note> notes = {}) {
        diags.error(code, {in.source, at.span, at.pointer}, std::move(message), std::move(notes));
    }
    Note note(std::string text, const At& at) { return {std::move(text), {in.source, at.span, at.pointer}}; }

    std::optional<std::size_t> find_texture(const std::string& name, const At& at);
    ir::ParameterId find_parameter(const std::string& name, const At& at, std::initializer_list<ParameterType> types);
    void mark_used();
    void texture(std::size_t index);
    void texture_file(const TextureDecl& decl, CheckedTexture& texture);
    void field_value(const LayerDecl& layer, const FieldEntry& entry, FieldValue& value);
    void layer(const LayerDecl& decl, std::size_t number);
    CheckedNumber number(const Located<NumberOrParameter>& written, std::initializer_list<ParameterType> types);
    void ids();
};

std::optional<std::size_t> Checker::find_texture(const std::string& name, const At& at) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < in.textures.size(); ++i) {
        if (in.textures[i].name.value == name) return i;
        names.push_back(in.textures[i].name.value);
    }
    std::string hint = did_you_mean(name, names);
    if (hint.empty()) {
        hint = names.empty() ? ", the material declares no textures" : fmt::format(", expected {}", one_of(names));
    }
    error(Code::unknown_texture, at, fmt::format("unknown texture '{}'{}", printable(name), hint));
    return std::nullopt;
}

ir::ParameterId Checker::find_parameter(const std::string& name, const At& at,
                                        std::initializer_list<ParameterType> types) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < in.parameters.size(); ++i) {
        const ParameterDecl& decl = in.parameters[i];
        names.push_back(decl.name.value);
        if (decl.name.value != name) continue;
        if (!decl.faulty && std::find(types.begin(), types.end(), decl.type) == types.end()) {
            std::vector<std::string_view> expected;
            for (ParameterType type : types) expected.push_back(parameter_type_name(type));
            error(Code::parameter_type, at,
                  fmt::format("parameter '{}' is of type '{}', expected {}", printable(name),
                              parameter_type_name(decl.type), one_of(expected)),
                  {note("it is declared here", decl.name.at)});
        }
        return {static_cast<std::uint32_t>(i)};
    }
    std::string hint = did_you_mean(name, names);
    if (hint.empty()) {
        hint = names.empty() ? ", the material declares no parameters" : fmt::format(", expected {}", one_of(names));
    }
    error(Code::unknown_parameter, at, fmt::format("unknown parameter '{}'{}", printable(name), hint));
    return {};
}

// Textures that no layer names get no binding.
void Checker::mark_used() {
    texture_used.assign(in.textures.size(), false);
    for (const StageDecl& stage : in.bump) {
        for (const LayerDecl& decl : stage.layers) {
            for (const FieldEntry& entry : decl.entries) {
                for (std::size_t i = 0; i < in.textures.size(); ++i) {
                    if (!entry.word.empty() && in.textures[i].name.value == entry.word) texture_used[i] = true;
                }
            }
        }
    }
}

bool inside(const fs::path& path, const fs::path& root) {
    auto [root_end, path_at] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
    return root_end == root.end();
}

void Checker::texture_file(const TextureDecl& decl, CheckedTexture& texture) {
    fs::path written(decl.file.value);
    bool relative = !written.is_absolute() && decl.file.value.find('\0') == std::string::npos;
    std::vector<fs::path> folders;
    for (const fs::path& folder : roots.folders) folders.push_back(files.canonical(folder.empty() ? fs::path(".") : folder));
    bool escaped = true;  // from all roots, for every folder that it could be relative to
    for (const fs::path& folder : folders) {
        if (!relative) break;
        fs::path path = files.canonical(folder / written);
        if (std::none_of(folders.begin(), folders.end(), [&](const fs::path& root) { return inside(path, root); })) continue;
        escaped = false;
        if (!files.exists(path)) continue;
        Files::ReadResult result = files.read(path);
        if (result.status == Files::Status::ok) {
            texture.hash = content_hash(result.bytes);
        } else {
            error(Code::file_unreadable, decl.file.at,
                  fmt::format("cannot read '{}': {}", printable(decl.file.value), result.reason));
        }
        return;
    }
    if (escaped) {
        error(Code::path_escapes, decl.file.at,
              fmt::format("path '{}' leaves the material's folder, expected a relative path below it or below an -I root",
                          printable(decl.file.value)));
    } else {
        error(Code::file_missing, decl.file.at,
              fmt::format("file '{}' does not exist, looked below the material's folder{}", printable(decl.file.value),
                          roots.folders.size() > 1 ? " and every -I root" : ""));
    }
}

void Checker::texture(std::size_t index) {
    const TextureDecl& decl = in.textures[index];
    if (decl.color_space.value == ColorSpace::srgb) {
        error(Code::srgb_normals, decl.color_space.at,
              fmt::format("texture '{}' holds normals and is declared 'srgb', expected 'linear'",
                          printable(decl.name.value)));
    }
    CheckedTexture texture{.name = decl.name.value,
                           .file = decl.file.value,
                           .hash = {},
                           .encoding = decl.encoding,
                           .green_up = decl.green_up,
                           .zero = decl.zero,
                           .sampler = decl.sampler};
    if (!decl.file.value.empty()) {
        texture_file(decl, texture);
    } else if (!decl.file.at.pointer.empty()) {
        error(Code::file_missing, decl.file.at, "file '' does not exist, expected a path");
    }
    if (!texture_used[index]) return;
    texture_index[index] = static_cast<std::uint32_t>(out.textures.size());
    out.textures.push_back(std::move(texture));
}

void Checker::field_value(const LayerDecl& layer, const FieldEntry& entry, FieldValue& value) {
    const Field& row = layer.kind->fields[entry.field];
    if (row.kind == FieldKind::texture) {
        auto index = find_texture(entry.word, entry.at);
        if (!index) return;
        value.index = texture_index[*index];
    } else if (row.kind == FieldKind::number || row.kind == FieldKind::pair) {
        if (entry.number.numbers.empty()) {
            using enum ParameterType;
            value.parameter = row.kind == FieldKind::number
                                  ? find_parameter(entry.number.parameter, entry.at, {scalar})
                                  : find_parameter(entry.number.parameter, entry.at, {scalar, vec2});
        } else {
            std::copy(entry.number.numbers.begin(), entry.number.numbers.end(), value.number.begin());
        }
    } else {
        value.index = entry.index;
    }
}

void Checker::layer(const LayerDecl& decl, std::size_t number) {
    CheckedLayer layer{.id = decl.id.value.empty() ? fmt::format("layer {}", number) : decl.id.value,
                       .kind = decl.kind,
                       .values = {}};
    for (const Field& row : decl.kind->fields) {
        FieldValue value{.number = {row.fallback, row.fallback}, .parameter = {}};
        if (row.kind == FieldKind::choice || row.kind == FieldKind::uv_set) value.index = static_cast<std::uint32_t>(row.fallback);
        layer.values.push_back(value);
    }
    for (const FieldEntry& entry : decl.entries) field_value(decl, entry, layer.values[entry.field]);
    if (auto fault = decl.kind->check(layer.values)) {
        At at = decl.at;
        for (const FieldEntry& entry : decl.entries) {
            if (entry.field == fault->field) at = entry.at;
        }
        error(Code::unused_setting, at, fault->message);
    }
    out.layers.push_back(std::move(layer));
}

CheckedNumber Checker::number(const Located<NumberOrParameter>& written, std::initializer_list<ParameterType> types) {
    CheckedNumber result;
    if (written.value.numbers.empty()) {
        result.parameter = find_parameter(written.value.parameter, written.at, types);
    } else {
        std::copy(written.value.numbers.begin(), written.value.numbers.end(), result.numbers.begin());
    }
    return result;
}

// Stages and layers share one space of names: messages, generated text and views use them.
void Checker::ids() {
    std::map<std::string_view, At> seen;
    auto claim = [&](const Located<std::string>& id) {
        if (id.value.empty()) return;
        auto [first, fresh] = seen.try_emplace(id.value, id.at);
        if (!fresh) {
            error(Code::duplicate_id, id.at, fmt::format("id '{}' is taken", printable(id.value)),
                  {note("the first is here", first->second)});
        }
    };
    for (const StageDecl& stage : in.bump) {
        claim(stage.id);
        for (const LayerDecl& decl : stage.layers) claim(decl.id);
    }
}

std::string default_name(const Source& source) { return fs::path(source.name).stem().string(); }

}  // namespace

std::string_view parameter_type_name(ParameterType type) {
    constexpr std::string_view kNames[] = {"float", "vec2", "vec3", "vec4", "color"};
    return kNames[static_cast<std::size_t>(type)];
}

ir::Type ir_type(ParameterType type) {
    constexpr ir::Type kTypes[] = {ir::Type::Scalar, ir::Type::Vec2, ir::Type::Vec3, ir::Type::Vec4, ir::Type::Color};
    return kTypes[static_cast<std::size_t>(type)];
}

std::optional<CheckedMaterial> check(const Material& material, Files& files, const Roots& roots, Diags& diags) {
    std::size_t before = diags.error_count();
    Checker checker{material, files, roots, diags};
    checker.out.name = material.name.empty() ? default_name(*material.source) : material.name;
    checker.out.two_sided = material.surface.two_sided;
    for (const ParameterDecl& p : material.parameters) {
        checker.out.parameters.push_back({p.name.value, p.type, p.fallback, p.range, p.label, p.unit});
    }
    checker.ids();
    checker.mark_used();
    for (std::size_t i = 0; i < material.textures.size(); ++i) checker.texture(i);
    if (material.bump.size() > 1) {
        checker.error(Code::too_many, material.bump[1].at,
                      fmt::format("'bump' has {} entries, expected at most 1: this version resolves once", material.bump.size()));
    }
    std::size_t number = 0;
    for (const StageDecl& stage : material.bump) {
        for (const LayerDecl& decl : stage.layers) checker.layer(decl, ++number);
    }
    using enum ParameterType;
    checker.out.base_color = checker.number(material.surface.base_color, {color, vec3});
    checker.out.metallic = checker.number(material.surface.metallic, {scalar});
    checker.out.roughness = checker.number(material.surface.roughness, {scalar});
    At top{{0, 1}, ""};
    if (number > kMaxLayers) checker.error(Code::too_many, top, fmt::format("{} layers, expected at most {}", number, kMaxLayers));
    if (checker.out.textures.size() > kMaxTextures) {
        checker.error(Code::too_many, top, fmt::format("{} textures are used, expected at most {}", checker.out.textures.size(), kMaxTextures));
    }
    if (diags.error_count() > before) return std::nullopt;
    return std::move(checker.out);
}

}  // namespace sg::material

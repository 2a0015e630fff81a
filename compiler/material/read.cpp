#include <fmt/core.h>

#include <algorithm>

#include "material/material.hpp"
#include "material/object_reader.hpp"

namespace sg::material {
namespace {

using json::Value;
using layers::Field;
using layers::FieldKind;
using layers::LayerKind;

constexpr Range kAnyNumber{-3.0e38, 3.0e38};  // what a 32-bit float can hold

struct Reader {
    SourcePtr source;
    Diags& diags;
    Material out{};

    ObjectReader object(const Value& value, std::string pointer, std::string what, std::vector<std::string_view> keys) {
        return {source, value, std::move(pointer), std::move(what), std::move(keys), diags};
    }

    void parameter(const json::Member& member, const std::string& pointer);
    void texture(const json::Member& member, const std::string& pointer);
    SamplerDecl sampler(const Value& value, const std::string& pointer);
    void stage(const Value& value, const std::string& pointer);
    std::optional<LayerDecl> layer(const Value& value, const std::string& pointer);
    std::optional<FieldEntry> field(ObjectReader& reader, const LayerKind& kind, std::size_t index);
    void surface(const Value& value, const std::string& pointer);
    void document(const Value& root);
};

void Reader::parameter(const json::Member& member, const std::string& pointer) {
    ObjectReader reader = object(member.value, pointer, "a parameter", {"type", "default", "range", "label", "unit"});
    constexpr std::size_t kCounts[] = {1, 2, 3, 4, 3};
    auto type = reader.choice("type", {"float", "vec2", "vec3", "vec4", "color"}, true);
    ParameterDecl decl{.name = {member.key, {member.key_span, pointer}}, .type = static_cast<ParameterType>(type.value_or(0))};
    decl.label = reader.string("label").value_or("");
    decl.unit = reader.string("unit").value_or("");
    if (auto range = reader.numbers("range", 2, kAnyNumber, false, false)) {
        decl.range = {range->numbers[0], range->numbers[1]};
        if (range->numbers[0] > range->numbers[1]) {
            reader.error(Code::out_of_range, reader.at("range", *reader.get("range")),
                         fmt::format("'range' is {} to {}, expected the smaller number first", range->numbers[0], range->numbers[1]));
            decl.range.reset();
        }
    }
    Range limits = decl.range ? Range{(*decl.range)[0], (*decl.range)[1]} : kAnyNumber;
    if (reader.get("default", true) && type) {
        auto fallback = reader.numbers("default", kCounts[*type], limits, false, false);
        if (fallback) std::copy(fallback->numbers.begin(), fallback->numbers.end(), decl.fallback.begin());
    }
    // One with a fault is kept, so that its uses are not reported too.
    decl.faulty = !type;
    out.parameters.push_back(std::move(decl));
}

SamplerDecl Reader::sampler(const Value& value, const std::string& pointer) {
    ObjectReader reader = object(value, pointer, "a sampler", {"wrap", "wrap_s", "wrap_t", "filter", "mip_filter", "anisotropy"});
    SamplerDecl decl;
    auto wrap = [&](std::string_view key, Wrap fallback) {
        return static_cast<Wrap>(reader.choice(key, {"repeat", "clamp", "mirror"}).value_or(static_cast<std::size_t>(fallback)));
    };
    Wrap both = wrap("wrap", Wrap::repeat);
    decl.wrap_s = wrap("wrap_s", both);
    decl.wrap_t = wrap("wrap_t", both);
    decl.filter = static_cast<Filter>(reader.choice("filter", {"nearest", "linear"}).value_or(1));
    decl.mip_filter = static_cast<Filter>(reader.choice("mip_filter", {"nearest", "linear"}).value_or(1));
    decl.anisotropy = static_cast<int>(reader.integer("anisotropy", {1, 16}).value_or(1));
    return decl;
}

void Reader::texture(const json::Member& member, const std::string& pointer) {
    ObjectReader reader =
        object(member.value, pointer, "a texture", {"file", "encoding", "green", "zero", "color_space", "sampler"});
    TextureDecl decl{.name = {member.key, {member.key_span, pointer}}, .file = {}, .color_space = {}, .sampler = {}};
    auto file = reader.string("file", true);
    if (file) decl.file = {*file, reader.at("file", *reader.get("file"))};
    auto encoding = reader.choice("encoding", {"tangent_normal", "tangent_normal_xy"}, true);
    decl.encoding = static_cast<ir::TextureEncoding>(encoding.value_or(0));
    decl.green_up = reader.choice("green", {"up", "down"}).value_or(0) == 0;
    decl.zero = reader.one_of_numbers("zero", {127, 127.5, 128}).value_or(127.5);
    if (const Value* space = reader.get("color_space")) {
        decl.color_space = {static_cast<ColorSpace>(reader.choice("color_space", {"linear", "srgb"}).value_or(0)),
                            reader.at("color_space", *space)};
    }
    if (const Value* settings = reader.get("sampler")) decl.sampler = sampler(*settings, pointer + "/sampler");
    // A texture with a fault is kept, so that layers which name it are not reported too.
    out.textures.push_back(std::move(decl));
}

std::optional<FieldEntry> Reader::field(ObjectReader& reader, const LayerKind& kind, std::size_t index) {
    const Field& row = kind.fields[index];
    const Value* value = reader.get(row.name, row.required);
    if (!value) return std::nullopt;
    FieldEntry entry{.field = index, .at = reader.at(row.name, *value), .number = {}, .word = {}};
    switch (row.kind) {
        case FieldKind::texture: {
            auto word = reader.name(row.name);
            if (!word) return std::nullopt;
            entry.word = *word;
            return entry;
        }
        case FieldKind::uv_set: {
            auto set = reader.integer(row.name, {0, 7});
            if (!set) return std::nullopt;
            entry.index = *set;
            return entry;
        }
        case FieldKind::choice: {
            auto choice = reader.choice(row.name, row.choices, false);
            if (!choice) return std::nullopt;
            entry.index = static_cast<std::uint32_t>(*choice);
            return entry;
        }
        case FieldKind::number:
        case FieldKind::pair: {
            bool pair = row.kind == FieldKind::pair;
            auto number = reader.numbers(row.name, pair ? 2 : 1, {row.minimum, row.maximum}, pair, true);
            if (!number) return std::nullopt;
            entry.number = *number;
            return entry;
        }
    }
    return std::nullopt;
}

std::optional<LayerDecl> Reader::layer(const Value& value, const std::string& pointer) {
    // The kind decides which keys there are, so it is looked up first.
    const Value* kind_value = value.kind == json::Kind::object ? value.find("kind") : nullptr;
    const LayerKind* kind = nullptr;
    std::vector<std::string_view> names;
    for (const LayerKind* k : layers::all_kinds()) names.push_back(k->name);
    if (kind_value && kind_value->kind == json::Kind::string) {
        kind = layers::find_kind(kind_value->string);
        if (!kind) {
            std::string hint = did_you_mean(kind_value->string, names);
            if (hint.empty()) hint = fmt::format(", expected {}", one_of(names));
            diags.error(Code::unknown_kind, {source, kind_value->span, pointer + "/kind"},
                        fmt::format("unknown layer kind '{}'{}", printable(kind_value->string), hint));
            return std::nullopt;
        }
    }
    std::vector<std::string_view> keys = {"id", "kind"};
    if (kind) {
        for (const Field& row : kind->fields) keys.push_back(row.name);
    } else if (value.kind == json::Kind::object) {
        for (const json::Member& member : value.members) keys.push_back(member.key);  // unknowable without a kind
    }
    ObjectReader reader = object(value, pointer, kind ? fmt::format("a layer of kind '{}'", kind->name) : "a layer", keys);
    if (!reader.string("kind", true) || !kind) return std::nullopt;
    LayerDecl decl{.id = {}, .kind = kind, .at = reader.at(), .entries = {}};
    if (auto id = reader.name("id")) decl.id = {*id, reader.at("id", *reader.get("id"))};
    for (std::size_t i = 0; i < kind->fields.size(); ++i) {
        if (auto entry = field(reader, *kind, i)) decl.entries.push_back(std::move(*entry));
    }
    return decl;
}

void Reader::stage(const Value& value, const std::string& pointer) {
    ObjectReader reader = object(value, pointer, "an entry of 'bump'", {"id", "layers"});
    if (!reader.ok()) return;
    StageDecl decl{.id = {}, .at = reader.at(), .layers = {}};
    if (auto id = reader.name("id")) decl.id = {*id, reader.at("id", *reader.get("id"))};
    for (const auto& [item, item_pointer] : reader.array("layers", true)) {
        if (auto found = layer(*item, item_pointer)) decl.layers.push_back(std::move(*found));
    }
    out.bump.push_back(std::move(decl));
}

void Reader::surface(const Value& value, const std::string& pointer) {
    ObjectReader reader = object(value, pointer, "'surface'", {"base_color", "metallic", "roughness", "two_sided"});
    auto set = [&](Located<NumberOrParameter>& slot, std::string_view key, std::size_t count) {
        if (auto found = reader.numbers(key, count, {0, 1}, false, true)) slot = {*found, reader.at(key, *reader.get(key))};
    };
    set(out.surface.base_color, "base_color", 3);
    set(out.surface.metallic, "metallic", 1);
    set(out.surface.roughness, "roughness", 1);
    out.surface.two_sided = static_cast<TwoSided>(reader.choice("two_sided", {"off", "mirror", "flip"}).value_or(0));
}

void Reader::document(const Value& root) {
    ObjectReader reader = object(root, "", "a material",
                                 {"$schema", "version", "name", "description", "parameters", "textures", "bump", "surface"});
    if (!reader.ok()) return;
    reader.string("$schema");
    if (auto version = reader.integer("version", {1, 1e6}, true); version && *version != kVersion) {
        reader.error(Code::unsupported_version, reader.at("version", *reader.get("version")),
                     fmt::format("'version' is {}, expected {}", *version, kVersion));
    }
    out.name = reader.name("name").value_or("");
    out.description = reader.string("description").value_or("");
    for (const auto& [member, pointer] : reader.named("parameters")) parameter(*member, pointer);
    for (const auto& [member, pointer] : reader.named("textures")) texture(*member, pointer);
    for (const auto& [item, pointer] : reader.array("bump")) stage(*item, pointer);
    if (const Value* value = reader.get("surface")) surface(*value, "/surface");
}

SurfaceDecl default_surface() {
    SurfaceDecl surface;
    surface.base_color.value.numbers = {0.5, 0.5, 0.5};
    surface.metallic.value.numbers = {0};
    surface.roughness.value.numbers = {0.5};
    return surface;
}

}  // namespace

Material read(const json::Document& document, Diags& diags) {
    Reader reader{document.source, diags};
    reader.out.source = document.source;
    reader.out.surface = default_surface();
    reader.document(document.root);
    return std::move(reader.out);
}

}  // namespace sg::material

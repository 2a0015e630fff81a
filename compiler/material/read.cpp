#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ir/lighting.hpp"
#include "material/reader.hpp"

namespace sg::material {
using json::Value;

void Reader::parameter_value(ObjectReader& reader, std::string_view key, ParameterDecl& decl) {
    Range limits = decl.range ? Range{(*decl.range)[0], (*decl.range)[1]} : kAnyNumber;
    switch (decl.type) {
        case ParameterType::boolean:
            if (auto value = reader.boolean(key)) decl.fallback = {*value ? 1.0 : 0.0};
            return;
        case ParameterType::integer: {
            auto value = reader.numbers(key, 1, limits, false, "");
            if (value && (*value)[0] != std::floor((*value)[0])) {
                reader.error(Code::wrong_type, reader.at(key, *reader.get(key)),
                             fmt::format("expected an integer for '{}', found {}", key, (*value)[0]));
            } else if (value) {
                decl.fallback = {(*value)[0]};
            }
            return;
        }
        case ParameterType::texture:
            if (auto value = reader.name(key)) decl.texture = {*value, reader.at(key, *reader.get(key))};
            return;
        default:
            break;
    }
    constexpr std::size_t kCounts[] = {1, 2, 3, 4, 3};
    const bool matrix = decl.type == ParameterType::matrix;
    auto values =
        reader.numbers(key, matrix ? 16 : kCounts[static_cast<std::size_t>(decl.type)], limits, false, "");
    if (values) std::copy(values->begin(), values->end(), decl.fallback.begin());
}

void Reader::parameter(const json::Member& member, const std::string& pointer) {
    ObjectReader reader =
        object(member.value, pointer, "a parameter", {"type", "default", "range", "label", "unit"});
    auto type = reader.choice(
        "type", {"float", "vec2", "vec3", "vec4", "color", "bool", "int", "mat4", "texture"}, true);
    ParameterDecl decl{.name = {member.key, {member.key_span, pointer}},
                       .type = static_cast<ParameterType>(type.value_or(0))};
    decl.label = reader.string("label").value_or("");
    decl.unit = reader.string("unit").value_or("");
    bool ranged = decl.type != ParameterType::boolean && decl.type != ParameterType::matrix &&
                  decl.type != ParameterType::texture;
    if (auto range = reader.numbers("range", 2, kAnyNumber, false, "")) {
        decl.range = {(*range)[0], (*range)[1]};
        At place = reader.at("range", *reader.get("range"));
        if ((*range)[0] > (*range)[1]) {
            reader.error(Code::out_of_range, place,
                         fmt::format("'range' is {} to {}, expected the smaller number first", (*range)[0],
                                     (*range)[1]));
            decl.range.reset();
        } else if (decl.type == ParameterType::integer &&
                   ((*range)[0] != std::floor((*range)[0]) || (*range)[1] != std::floor((*range)[1]))) {
            reader.error(Code::wrong_type, place,
                         fmt::format("'range' is {} to {}, expected integers for a parameter of type 'int'",
                                     (*range)[0], (*range)[1]));
            decl.range.reset();
        } else if (!ranged) {
            reader.error(Code::unused_setting, place,
                         fmt::format("'range' means nothing for a parameter of type '{}'",
                                     parameter_type_name(decl.type)));
            decl.range.reset();
        }
    }
    if (reader.get("default", true) && type) parameter_value(reader, "default", decl);
    // One with a fault is kept, so that its uses are not reported too.
    decl.faulty = !type;
    out.parameters.push_back(std::move(decl));
}

SamplerDecl Reader::sampler(const Value& value, const std::string& pointer) {
    ObjectReader reader = object(value, pointer, "a sampler",
                                 {"wrap", "wrap_s", "wrap_t", "filter", "mip_filter", "anisotropy"});
    SamplerDecl decl;
    auto wrap = [&](std::string_view key, Wrap fallback) {
        return static_cast<Wrap>(
            reader.choice(key, {"repeat", "clamp", "mirror"}).value_or(static_cast<std::size_t>(fallback)));
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
        object(member.value, pointer, "a texture",
               {"file", "encoding", "swizzle", "green", "zero", "range", "color_space", "sampler"});
    TextureDecl decl{.name = {member.key, {member.key_span, pointer}}};
    auto place = [&](std::string_view key) { return reader.at(key, *reader.get(key)); };
    if (auto file = reader.string("file", true)) decl.file = {*file, place("file")};
    auto encoding = reader.choice("encoding", ir::encoding_names(), true);
    decl.encoding = static_cast<ir::TextureEncoding>(encoding.value_or(0));
    decl.faulty = !encoding;
    if (auto swizzle = reader.string("swizzle")) decl.swizzle = {*swizzle, place("swizzle")};
    if (auto green = reader.choice("green", {"up", "down"})) decl.green_up = {*green == 0, place("green")};
    if (auto zero = reader.one_of_numbers("zero", {127, 127.5, 128})) decl.zero = {*zero, place("zero")};
    if (auto range = reader.number("range", {1e-6, 128})) decl.range = {*range, place("range")};
    if (auto space = reader.choice("color_space", {"linear", "srgb"})) {
        decl.color_space = {static_cast<ColorSpace>(*space), place("color_space")};
    }
    if (const Value* settings = reader.get("sampler"))
        decl.sampler = sampler(*settings, pointer + "/sampler");
    // A texture with a fault is kept, so that layers which name it are not reported too.
    out.textures.push_back(std::move(decl));
}

void Reader::surface(const Value& value, const std::string& pointer) {
    std::vector<std::string_view> keys = {"lighting"}, models;
    for (const layers::Field& field : layers::surface_fields()) keys.push_back(field.name);
    keys.insert(keys.end(), {"alpha_test", "two_sided"});
    ObjectReader reader = object(value, pointer, "'surface'", keys);
    for (const ir::LightingModel& model : ir::all_lighting_models()) models.push_back(model.name);
    auto lighting = reader.choice("lighting", models, false);
    out.surface.lighting = static_cast<std::uint32_t>(lighting.value_or(0));
    out.surface.unlit = !lighting && reader.get("lighting");
    out.surface.entries = entries(reader, layers::surface_fields());
    out.surface.alpha_test = reader.number("alpha_test", {0, 1});
    out.surface.two_sided =
        static_cast<TwoSided>(reader.choice("two_sided", {"off", "mirror", "flip"}).value_or(0));
}

void Reader::budget(const Value& value, const std::string& pointer) {
    ObjectReader reader = object(value, pointer, "'budget'", {kCostNames.begin(), kCostNames.end()});
    for (std::size_t i = 0; i < kCostNames.size(); ++i) {
        auto limit = reader.integer(kCostNames[i], {0, 1e9});
        if (limit)
            out.budget[i] =
                Located<std::uint32_t>{*limit, reader.at(kCostNames[i], *reader.get(kCostNames[i]))};
    }
}

// It says nothing of its own, beside a key that is nearly "extends": what its parameters are stands
// elsewhere.
bool Reader::means_an_instance(const Value& root) {
    static constexpr std::string_view kExtends[] = {"extends"};
    for (std::string_view own : {"textures", "nodes", "bump", "surface", "budget"}) {
        if (root.find(own)) return false;
    }
    return std::any_of(root.members.begin(), root.members.end(),
                       [](const json::Member& member) { return !nearest(member.key, kExtends).empty(); });
}

void Reader::document(const Value& root) {
    // One with "extends" is read as an instance.
    ObjectReader reader = object(root, "", "a material",
                                 {"$schema", "version", "name", "description", "extends", "parameters",
                                  "textures", "nodes", "bump", "surface", "budget"});
    if (!reader.ok()) return;
    header(reader);
    if (means_an_instance(root)) return;
    for (const auto& [member, pointer] : reader.named("parameters")) parameter(*member, pointer);
    for (const auto& [member, pointer] : reader.named("textures")) texture(*member, pointer);
    named_nodes(reader);
    for (const auto& [item, pointer] : reader.array("bump")) stage(*item, pointer);
    if (const Value* value = reader.get("surface")) surface(*value, "/surface");
    if (const Value* value = reader.get("budget")) budget(*value, "/budget");
}

void Reader::header(ObjectReader& reader) {
    reader.string("$schema");
    const Value* version = reader.get("version");
    const bool whole =
        version && version->kind == json::Kind::number && std::floor(version->number) == version->number;
    if (!whole) {
        reader.integer("version", kAnyNumber, true);  // says what is wrong
    } else if (version->number != kVersion) {
        reader.error(Code::unsupported_version, reader.at("version", *version),
                     fmt::format("'version' is {}, expected {}", version->number, kVersion));
    }
    out.name = reader.name("name").value_or("");
    out.description = reader.string("description").value_or("");
}

Material read(const json::Document& document, Diags& diags) {
    Reader reader{document.source, diags};
    reader.out.source = document.source;
    reader.document(document.root);
    return std::move(reader.out);
}

}  // namespace sg::material

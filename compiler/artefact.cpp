#include "artefact.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "base/files.hpp"
#include "base/ice.hpp"
#include "function_manifest.hpp"
#include "host_manifest.hpp"
#include "ir/lighting.hpp"
#include "target/usage.hpp"

namespace sg {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kFormat = "surfgrad-artefact";
constexpr int kManifestVersion = 1;

std::string_view word(material::Wrap wrap) {
    constexpr std::string_view kWords[] = {"repeat", "clamp", "mirror"};
    return kWords[static_cast<std::size_t>(wrap)];
}
std::string_view word(material::Filter filter) {
    return filter == material::Filter::nearest ? "nearest" : "linear";
}
std::string_view word(material::TwoSided two_sided) {
    constexpr std::string_view kWords[] = {"off", "mirror", "flip"};
    return kWords[static_cast<std::size_t>(two_sided)];
}
std::string_view word(emit::BindingKind kind) {
    constexpr std::string_view kWords[] = {"uniform_buffer", "texture", "sampler"};
    return kWords[static_cast<std::size_t>(kind)];
}

using NamedFiles = std::vector<std::pair<std::string, std::string>>;

// Where a text has a binding of the SPIR-V, in the words of its language.
Json slot_json(const target::Slot& slot, const target::Target& target) {
    Json out = {{"set", slot.set}, {"binding", slot.binding}, {"kind", word(slot.kind)}, {"name", slot.name}};
    switch (target.language) {
        case target::Language::hlsl:
            out["register"] = fmt::format("{}{}", "bts"[static_cast<std::size_t>(slot.kind)], slot.index);
            out["space"] = slot.space;
            break;
        case target::Language::msl:
            out["index"] = slot.index;
            break;
        default:
            out[slot.kind == emit::BindingKind::texture ? "unit" : "index"] = slot.index;
            if (slot.kind == emit::BindingKind::texture) out["sampler_binding"] = slot.sampler_binding;
    }
    return out;
}

Json text_json(const std::string& file, const CrossFile& text) {
    const target::CrossText& cross = text.cross;
    Json out = {{"target", text.target->name},
                {"file", file},
                {"hash", content_hash(cross.text)},
                {"function", cross.function}};
    out["bindings"] = Json::array();
    for (const target::Slot& slot : cross.slots) out["bindings"].push_back(slot_json(slot, *text.target));
    if (text.stage != target::Stage::vertex) return out;
    const char* key = text.target->language == target::Language::hlsl ? "semantic" : "variable";
    out["vertex_inputs"] = Json::array();
    for (const target::Attribute& a : cross.attributes)
        out["vertex_inputs"].push_back({{"location", a.location}, {key, a.name}});
    return out;
}

Json stage_json(const ArtefactInput& input, const CompiledEntry& entry, target::Stage stage,
                NamedFiles& files) {
    bool vertex = stage == target::Stage::vertex;
    const target::Words& words = vertex ? entry.vertex : entry.fragment;
    std::string stem = fmt::format("{}.{}.{}", input.stem, entry.entry->name, vertex ? "vert" : "frag");
    Json out = {{"stage", vertex ? "vert" : "frag"}};
    if (input.ships_spirv) {
        std::string bytes = target::bytes(words);
        out["file"] = stem + ".spv";
        out["hash"] = content_hash(bytes);
        files.emplace_back(stem + ".spv", std::move(bytes));
    }
    out["instructions"] = target::instruction_count(words);
    for (const CrossFile& text : entry.texts) {
        if (text.stage != stage) continue;
        std::string file = fmt::format("{}.{}.{}", stem, text.target->name, text.target->extension);
        out["targets"].push_back(text_json(file, text));
        files.emplace_back(std::move(file), text.cross.text);
    }
    return out;
}

Json bindings_json(const emit::EntryInterface& interface) {
    Json out = Json::array();
    for (const emit::Binding& b : interface.bindings) {
        Json stages = Json::array();
        if (b.in_vertex) stages.push_back("vert");
        if (b.in_fragment) stages.push_back("frag");
        out.push_back({{"set", b.set},
                       {"binding", b.binding},
                       {"kind", word(b.kind)},
                       {"name", b.name},
                       {"stages", stages}});
    }
    return out;
}

Json vertex_inputs_json(const emit::EntryInterface& interface) {
    Json out = Json::array();
    for (const emit::VertexInput& input : emit::vertex_inputs(interface.varyings)) {
        out.push_back({{"name", input.name}, {"location", input.location}, {"format", input.format}});
    }
    return out;
}

Json outputs_json(const emit::EntryPoint& entry) {
    Json out = Json::array();
    for (const emit::Attachment& attachment : entry.attachments) {
        out.push_back({{"name", attachment.name}, {"location", out.size()}, {"format", "float4"}});
        if (!attachment.format.empty()) out.back()["attachment"] = attachment.format;
    }
    return out;
}

Json entry_json(const ArtefactInput& input, const CompiledEntry& entry, NamedFiles& files) {
    Json stages = Json::array();
    for (auto stage : {target::Stage::vertex, target::Stage::fragment})
        stages.push_back(stage_json(input, entry, stage, files));
    Json views = Json::array();
    for (const emit::View& v : entry.shaders.interface.views) {
        views.push_back(
            {{"name", v.name}, {"number", v.number}, {"components", v.components}, {"kind", v.kind}});
    }
    return {{"name", entry.entry->name},
            {"stages", stages},
            {"vertex_inputs", vertex_inputs_json(entry.shaders.interface)},
            {"bindings", bindings_json(entry.shaders.interface)},
            {"outputs", outputs_json(*entry.entry)},
            {"texture_reads", target::usage(entry.fragment).texture_reads},
            {"views", views}};
}

Json parameter_block_json(const ArtefactInput& input) {
    Json parameters = Json::array();
    for (std::size_t i = 0; i < input.material->parameters.size(); ++i) {
        const material::CheckedParameter& p = input.material->parameters[i];
        Json fallback = Json::array();
        for (std::size_t k = 0; k < material::number_count(p.type); ++k) fallback.push_back(p.fallback[k]);
        Json row = {{"name", p.name},
                    {"type", material::parameter_type_name(p.type)},
                    {"offset", input.interface->parameters[i].offset},
                    {"default", fallback}};
        if (p.range) row["range"] = {(*p.range)[0], (*p.range)[1]};
        row["label"] = p.label;
        row["unit"] = p.unit;
        parameters.push_back(row);
    }
    Json out = {
        {"set", 1}, {"binding", 0}, {"size", input.interface->block_size}, {"parameters", parameters}};
    out.update(Json::parse(host_json(*input.module, *input.material, *input.interface)));
    return out;
}

Json textures_json(const ArtefactInput& input) {
    Json out = Json::array();
    for (const emit::TextureSlot& slot : input.interface->textures) {
        const material::CheckedTexture& t = input.material->textures[slot.texture];
        out.push_back({{"name", t.name},
                       {"file", t.file},
                       {"hash", t.hash},
                       {"set", 1},
                       {"binding", slot.binding},
                       {"sampler_binding", input.interface->samplers[slot.sampler].binding},
                       {"encoding", ir::encoding_name(t.encoding)},
                       {"green", t.facts.green_up ? "up" : "down"},
                       {"zero", t.facts.zero},
                       {"color_space", t.color_space == material::ColorSpace::srgb ? "srgb" : "linear"}});
        if (!t.parameter.empty()) {
            out.back()["parameter"] = t.parameter;
            out.back()["label"] = t.label;
        }
        if (t.facts.swizzle != layers::TextureFacts{}.swizzle) {
            std::string letters;
            for (std::uint32_t channel : t.facts.swizzle) letters += "rgba"[channel];
            out.back()["swizzle"] = letters;
        }
    }
    return out;
}

// What was read beside the material itself and its textures.
Json sources_json(const ArtefactInput& input) {
    Json out = Json::array();
    for (const auto& [file, hash] : input.material->bases) out.push_back({{"file", file}, {"hash", hash}});
    for (const material::CheckedShader& shader : input.material->shaders)
        out.push_back({{"file", shader.file}, {"hash", shader.hash}});
    return out;
}

Json samplers_json(const ArtefactInput& input) {
    Json out = Json::array();
    for (const emit::SamplerSlot& slot : input.interface->samplers) {
        const material::SamplerDecl& s = (*input.samplers)[slot.group];
        out.push_back({{"set", 1},
                       {"binding", slot.binding},
                       {"wrap_s", word(s.wrap_s)},
                       {"wrap_t", word(s.wrap_t)},
                       {"filter", word(s.filter)},
                       {"mip_filter", word(s.mip_filter)},
                       {"anisotropy", s.anisotropy}});
    }
    return out;
}

}  // namespace

std::string_view generator_name() {
    return "surfgrad " SURFGRAD_VERSION;
}

std::vector<std::pair<std::string, std::string>> artefact_files(const ArtefactInput& input) {
    NamedFiles files;
    Json entries = Json::array();
    for (const CompiledEntry& entry : *input.entries) entries.push_back(entry_json(input, entry, files));
    Json manifest = {{"format", kFormat},
                     {"version", kManifestVersion},
                     {"generator", generator_name()},
                     {"name", input.material->name},
                     {"stem", input.stem},
                     {"source", {{"file", input.source_file}, {"hash", input.source_hash}}},
                     {"two_sided", word(input.material->surface.two_sided)},
                     {"lighting", ir::all_lighting_models()[input.material->surface.lighting].name},
                     {"entry_points", entries}};
    if (!input.material->shaders.empty() || !input.material->bases.empty())
        manifest["sources"] = sources_json(input);
    if (input.interface->block_size > 0) manifest["parameter_block"] = parameter_block_json(input);
    manifest["textures"] = textures_json(input);
    manifest["samplers"] = samplers_json(input);
    if (input.function)
        manifest["function"] =
            Json::parse(function_json(*input.function, input.stem, *input.material, *input.interface, files));
    files.emplace_back(input.stem + ".json", manifest.dump(2) + "\n");
    return files;
}

}  // namespace sg

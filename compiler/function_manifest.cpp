#include "function_manifest.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/files.hpp"

namespace sg {
namespace {

using Json = nlohmann::ordered_json;

// As the manifest names types everywhere: "vec3" is "float3".
std::string type_word(std::string_view glsl) {
    return glsl.starts_with("vec") ? fmt::format("float{}", glsl.back()) : std::string(glsl);
}

Json field_json(const emit::FunctionField& field) {
    return {{"name", field.name}, {"type", type_word(field.type)}, {"meaning", field.meaning}};
}

Json inputs_json(const emit::MaterialFunction& function) {
    Json out = Json::array();
    for (const emit::FunctionField& field : emit::function_inputs()) {
        if (std::find(function.inputs.begin(), function.inputs.end(), field.name) != function.inputs.end())
            out.push_back(field_json(field));
    }
    return out;
}

Json results_json() {
    Json out = Json::array();
    for (const emit::FunctionField& field : emit::function_results()) out.push_back(field_json(field));
    return out;
}

Json parameters_json(const std::string& type, const material::CheckedMaterial& material,
                     const emit::MaterialInterface& interface) {
    Json members = Json::array();
    for (std::size_t i = 0; i < interface.parameters.size(); ++i) {
        Json row = {{"name", interface.parameters[i].member}};
        if (i < interface.first_derived) {
            row["parameter"] = material.parameters[i].name;
        } else {
            row["derived"] = i - interface.first_derived;
        }
        members.push_back(std::move(row));
    }
    return {{"type", type}, {"members", members}};
}

Json resources_json(const emit::MaterialFunction& function) {
    Json out = Json::array();
    for (const emit::FunctionResource& r : function.resources) {
        bool texture = r.kind == emit::BindingKind::texture;
        Json row = {
            {"kind", texture ? "texture" : "sampler"}, {"argument", r.argument}, {"binding", r.binding}};
        if (texture) row["sampler_binding"] = r.sampler_binding;
        out.push_back(row);
    }
    return out;
}

}  // namespace

std::string function_json(const CompiledFunction& compiled, const std::string& stem,
                          const material::CheckedMaterial& material, const emit::MaterialInterface& interface,
                          std::vector<std::pair<std::string, std::string>>& files) {
    const emit::MaterialFunction& function = compiled.function;
    Json out = {{"name", function.name}, {"inputs", inputs_json(function)}, {"results", results_json()}};
    if (!function.parameters_type.empty())
        out["parameters"] = parameters_json(function.parameters_type, material, interface);
    out["resources"] = resources_json(function);
    out["texts"] = Json::array();
    for (const FunctionText& text : compiled.texts) {
        bool vulkan = text.target->language == target::Language::spirv;
        std::string file = fmt::format("{}.{}.{}.{}", stem, emit::kFunctionEntry, text.target->name,
                                       vulkan ? "glsl" : text.target->extension);
        out["texts"].push_back({{"target", text.target->name},
                                {"file", file},
                                {"hash", content_hash(text.text)},
                                {"signature", text.signature}});
        files.emplace_back(std::move(file), text.text);
    }
    return out.dump();
}

}  // namespace sg

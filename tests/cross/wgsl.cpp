#include "tests/cross/wgsl.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "target/spirv.hpp"
#include "tests/cross/browser.hpp"
#include "tests/cross/process.hpp"
#include "tests/support/golden.hpp"

namespace sg::cross {
namespace {

using Json = nlohmann::json;

// Chromium carries SwiftShader, a Vulkan driver that shares nothing with Mesa.
constexpr const char* kFlags = "--enable-unsafe-webgpu --use-webgpu-adapter=swiftshader";

// A shader that naga wrote, or its words.
struct Written {
    std::string text, refusal;
};

// What Dawn has to say about files, by name; one run of node.
std::map<std::string, std::string> dawn_faults(const std::filesystem::path& folder,
                                               const std::vector<std::string>& names) {
    std::string files;
    for (const std::string& name : names) files += fmt::format(" '{}'", (folder / name).string());
    const Outcome outcome = run(fmt::format("node '{}/check_wgsl.mjs' {} 2>&1", SG_WGSL_DIR, files));
    std::map<std::string, std::string> out;
    for (const std::string& name : names) {
        const std::size_t at = outcome.text.find((folder / name).string() + ":");
        if (at != std::string::npos) out[name] = outcome.text.substr(at, outcome.text.find('\n', at) - at);
    }
    if (outcome.text.find("checked\n") == std::string::npos)
        throw std::runtime_error("node: " + outcome.text);
    return out;
}

// Every shader of a sample by "<entry>.<stage>"; one run of node per sample.
const std::map<std::string, Written>& written(const Sample& sample) {
    static std::map<std::pair<std::string, std::vector<std::uint32_t>>, std::map<std::string, Written>> all;
    auto [at, fresh] = all.try_emplace({sample.name, sample.artefact.entry("normal")->fragment.words});
    if (!fresh) return at->second;
    const auto folder = scratch() / fmt::format("wgsl-{}-{}", sample.name, all.size());
    std::filesystem::create_directories(folder);
    std::string files;
    std::vector<std::string> names;
    for (const runtime::EntryPoint& entry : sample.artefact.entries) {
        for (const auto& [stage, shader] :
             {std::pair{"vert", &entry.vertex}, std::pair{"frag", &entry.fragment}}) {
            names.push_back(entry.name + "." + stage);
            write_file(folder / names.back(), target::bytes(shader->words));
            files += fmt::format(" '{}'", (folder / names.back()).string());
        }
    }
    Outcome outcome =
        run(fmt::format("node '{}/spirv_to_wgsl.mjs' '{}' {} 2>&1", SG_WGSL_DIR, folder.string(), files));
    if (outcome.exit_code != 0) throw std::runtime_error("node: " + outcome.text);
    std::vector<std::string> texts;
    for (const std::string& name : names) {
        at->second[name] = {test::read_file(folder / (name + ".wgsl")),
                            test::read_file(folder / (name + ".refused"))};
        if (!at->second[name].refusal.empty()) {
            at->second[name].refusal.insert(0, "naga: ");
        } else {
            texts.push_back(name + ".wgsl");
        }
    }
    for (const auto& [name, fault] : dawn_faults(folder, texts))
        at->second[name.substr(0, name.size() - 5)].refusal = "Dawn: " + fault;
    return at->second;
}

Json sampler_json(const runtime::gpu::SamplerState& state) {
    constexpr const char* kWraps[] = {"repeat", "mirror-repeat", "clamp-to-edge"};
    const char* filter = state.linear ? "linear" : "nearest";
    return {{"addressModeU", kWraps[static_cast<std::size_t>(state.wrap_s)]},
            {"addressModeV", kWraps[static_cast<std::size_t>(state.wrap_t)]},
            {"magFilter", filter},
            {"minFilter", filter}};
}

Json drawing_json(const Drawing& drawing, Json& textures) {
    Json out = {{"vertex", drawing.vertex.text},
                {"fragment", drawing.fragment.text},
                {"indices", base64(drawing.indices)},
                {"cull", drawing.cull_back},
                {"attachments", drawing.attachments}};
    for (const Attribute& a : drawing.attributes) {
        out["attributes"].push_back(
            {{"location", a.location}, {"components", a.components}, {"values", base64(a.values)}});
    }
    for (const Slot& slot : drawing.fragment.slots) {
        Json row = {{"set", slot.set}, {"binding", slot.binding}, {"kind", slot.kind}};
        if (slot.kind == "uniform_buffer") row["bytes"] = base64(drawing.blocks[slot.set]);
        if (slot.kind == "sampler") row["sampler"] = sampler_json(drawing.samplers.at(slot.binding));
        if (slot.kind == "texture") {
            const TextureView& view = drawing.textures.at(slot.binding);
            const asset::Image& image = view.chain->front();
            std::string key = fmt::format("{} {}", static_cast<const void*>(view.chain), view.srgb);
            if (!textures.contains(key))
                textures[key] = {
                    {"width", image.width}, {"height", image.height}, {"bytes", base64(linear_texels(view))}};
            row["texture"] = key;
        }
        out["slots"].push_back(row);
    }
    return out;
}

}  // namespace

const target::Target& wgsl_recipe() {
    static constexpr target::Target kRecipe{"wgsl (recipe)", "wgsl", "wgsl", target::Language::spirv, 0, "",
                                            "WGSL by naga"};
    return kRecipe;
}

std::string wgsl_missing() {
    static const std::string kMissing = [] {
        if (!has_program("node")) return std::string("no node");
        for (const char* package : {"naga-wasm@30.1.0", "webgpu@0.6.2"}) {
            const std::string name = package;
            if (!std::filesystem::exists(SG_WGSL_DIR "/node_modules/" + name.substr(0, name.find('@'))))
                return "no npm package " + name;
        }
        if (browser().empty()) return std::string("no chromium-headless-shell and no chromium");
        if (!has_swiftshader()) return std::string("no SwiftShader beside Chromium");
        std::string body = body_of("document.body.textContent = !!navigator.gpu", kFlags);
        return body == "true" ? "" : browser() + " has no WebGPU here";
    }();
    return kMissing;
}

std::string dawn_refusal(const std::string& text) {
    write_file(scratch() / "alone.wgsl", text);
    const auto faults = dawn_faults(scratch(), {"alone.wgsl"});
    return faults.empty() ? "" : faults.begin()->second.substr((scratch() / "alone.wgsl").string().size());
}

Drawing wgsl_drawing(const Sample& sample, const Shown& shown) {
    Drawing out = drawing(sample, wgsl_recipe(), shown);
    for (auto [stage, name] : {std::pair{&out.vertex, ".vert"}, std::pair{&out.fragment, ".frag"}}) {
        const Written& shader = written(sample).at(std::string(shown.entry) + name);
        if (!shader.refusal.empty()) throw std::runtime_error(sample.name + ": " + shader.refusal);
        stage->text = shader.text;
    }
    return out;
}

std::string wgsl_refusal(const Sample& sample, std::vector<std::string>& texts) {
    for (const auto& [name, shader] : written(sample)) {
        if (!shader.refusal.empty()) return name + ": " + shader.refusal;
    }
    for (const auto& [name, shader] : written(sample)) {
        const std::string entry = name.substr(0, name.find('.'));
        if (entry == "debug") texts.push_back(shader.text);
    }
    return "";
}

PageOutcome wgsl_draw(const std::vector<Drawing>& drawings, const std::vector<std::string>& texts) {
    PageOutcome out;
    for (std::span<const Drawing> page : pages_of(drawings)) {
        const auto modules = page.data() + page.size() == drawings.data() + drawings.size()
                                 ? texts
                                 : std::vector<std::string>{};  // in the last page
        Json input = {
            {"side", kSide}, {"textures", Json::object()}, {"drawings", Json::array()}, {"modules", modules}};
        for (const Drawing& drawing : page)
            input["drawings"].push_back(drawing_json(drawing, input["textures"]));
        out.add(run_page(input.dump(), {"bytes.js", "webgpu.js"}, kFlags, page.size(), modules.size()));
    }
    return out;
}

}  // namespace sg::cross

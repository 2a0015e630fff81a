#include "stages.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/ice.hpp"
#include "custom_shaders.hpp"
#include "json/json.hpp"
#include "material/instance.hpp"
#include "opt/optimise.hpp"
#include "target/usage.hpp"

namespace sg {

std::optional<material::CheckedMaterial> read_and_check(const SourcePtr& source, const material::Roots& roots,
                                                        Files& files, Diags& diags) {
    std::optional<json::Document> document = json::parse(source, diags);
    if (!document) return std::nullopt;
    std::size_t before = diags.error_count();
    const std::filesystem::path folder = roots.folders.empty() ? "." : roots.folders.front();
    const std::filesystem::path name = std::filesystem::path(source->name).filename();
    material::Material read =
        material::read_whole(*document, files.canonical(folder / name), roots, files, diags);
    if (read.incomplete) return std::nullopt;
    std::optional<material::CheckedMaterial> checked = material::check(read, files, roots, diags);
    return diags.error_count() == before ? std::move(checked) : std::nullopt;
}

std::optional<material::CheckedMaterial> read_and_verify(const CompileRequest& request, Files& files,
                                                         const target::ShaderLibrary& library, Diags& diags) {
    auto checked = read_and_check(request.source, {request.roots}, files, diags);
    if (checked && !verify_shaders(*checked, request.defines, library, request.source, diags))
        return std::nullopt;
    return checked;
}

SamplerGroups group_samplers(const material::CheckedMaterial& material) {
    SamplerGroups out;
    for (const material::CheckedTexture& texture : material.textures) {
        auto it = std::find(out.settings.begin(), out.settings.end(), texture.sampler);
        out.group.push_back(static_cast<std::uint32_t>(it - out.settings.begin()));
        if (it == out.settings.end()) out.settings.push_back(texture.sampler);
    }
    return out;
}

target::Words to_spirv(const std::string& text, const std::string& name, target::Stage stage,
                       const target::ShaderLibrary& library, const target::SpirvOptions& options) {
    std::string fault;
    std::optional<target::Words> words = target::compile_glsl(text, name, stage, library, options, fault);
    if (!words) SG_UNREACHABLE(fmt::format("generated GLSL does not compile: {}\n{}", fault, text));
    return std::move(*words);
}

ForwardCost forward_cost(const target::Words& fragment) {
    const target::Usage used = target::usage(fragment);
    return {static_cast<std::uint32_t>(target::instruction_count(fragment)), used.texture_reads,
            used.input_numbers()};
}

ForwardCost forward_cost(const ir::Module& module, const emit::MaterialInterface& interface,
                         const std::string& stem, const target::ShaderLibrary& library,
                         const target::SpirvOptions& options) {
    const emit::EntryPoint& entry = *emit::find_entry_point("forward");
    emit::Shaders shaders =
        emit::emit_glsl(opt::select_outputs(module, emit::needed_outputs(entry, module)), entry, interface);
    return forward_cost(
        to_spirv(shaders.fragment, stem + ".forward.frag", target::Stage::fragment, library, options));
}

void hold_to_budget(const ForwardCost& cost, const material::Budget& budget, const SourcePtr& source,
                    Diags& diags) {
    constexpr std::string_view kThings[] = {"instructions", "texture reads", "numbers from the vertex stage"};
    for (std::size_t i = 0; i < cost.size(); ++i) {
        const auto& limit = budget[i];
        if (!limit || cost[i] <= limit->value) continue;
        const std::string takes = fmt::format("takes {} {}", cost[i], kThings[i]);
        if (limit->at.pointer.empty()) {
            diags.error(Code::over_budget,
                        fmt::format("--budget {}={}: the forward shader of '{}' {}", material::kCostNames[i],
                                    limit->value, printable(source->name), takes));
        } else {
            diags.error(Code::over_budget, {source, limit->at.span, limit->at.pointer},
                        fmt::format("the forward shader {}, 'budget' allows {}", takes, limit->value));
        }
    }
}

}  // namespace sg

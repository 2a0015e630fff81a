#include "compile.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "artefact.hpp"
#include "cross_entry.hpp"
#include "emit/glsl.hpp"
#include "function_entry.hpp"
#include "opt/optimise.hpp"
#include "stages.hpp"
#include "target/usage.hpp"

namespace sg {
namespace {

bool ships(const CompileRequest& request, target::Language language) {
    return std::any_of(request.targets.begin(), request.targets.end(),
                       [&](const target::Target* t) { return t->language == language; });
}

bool ships_texts(const CompileRequest& request) {
    return std::any_of(request.targets.begin(), request.targets.end(),
                       [](const target::Target* t) { return t->language != target::Language::spirv; });
}

// Optimising the SPIR-V may find inputs and resources that the result does not depend on: the vertex stage
// stops handing them over and the manifest stops asking for them. Texts of other targets keep all, for their
// compilers optimise later.
void keep_used(emit::Shaders& shaders, const ir::Module& module, const emit::EntryPoint& entry,
               const target::Words& fragment) {
    const target::Usage used = target::usage(fragment);
    std::erase_if(shaders.interface.varyings,
                  [&](const emit::Varying& v) { return !used.inputs.contains(emit::varying_location(v)); });
    for (emit::Binding& b : shaders.interface.bindings)
        b.in_fragment = used.bindings.contains({b.set, b.binding});
    std::erase_if(shaders.interface.bindings,
                  [](const emit::Binding& b) { return !b.in_vertex && !b.in_fragment; });
    shaders.vertex = emit::emit_vertex(module, entry, shaders.interface.varyings);
}

std::optional<CompiledEntry> compile_entry(const CompileRequest& request, const emit::EntryPoint& entry,
                                           const ir::Module& module, const emit::MaterialInterface& interface,
                                           const target::ShaderLibrary& library, Diags& diags) {
    ir::Module selected = opt::select_outputs(module, emit::needed_outputs(entry, module));
    emit::Shaders shaders = emit::emit_glsl(selected, entry, interface);
    std::string name = fmt::format("{}.{}", request.stem, entry.name);
    target::Words fragment =
        to_spirv(shaders.fragment, name + ".frag", target::Stage::fragment, library, request.spirv);
    if (!ships_texts(request)) keep_used(shaders, selected, entry, fragment);
    target::Words vertex =
        to_spirv(shaders.vertex, name + ".vert", target::Stage::vertex, library, request.spirv);
    auto texts = cross_entry(shaders, name, request.targets, interface, library, diags);
    if (!texts) return std::nullopt;
    return CompiledEntry{&entry, std::move(shaders), std::move(vertex), std::move(fragment),
                         std::move(*texts)};
}

bool wanted(const CompileRequest& request, std::string_view entry) {
    const auto& names = request.entries;
    return names.empty() || std::find(names.begin(), names.end(), entry) != names.end();
}

bool has_limits(const material::Budget& budget) {
    return std::any_of(budget.begin(), budget.end(), [](const auto& limit) { return limit.has_value(); });
}

}  // namespace

bool check_material(const CompileRequest& request, Files& files, const target::ShaderLibrary& library,
                    Diags& diags) {
    return read_and_verify(request, files, library, diags).has_value();
}

std::optional<Compiled> compile_material(const CompileRequest& request, Files& files,
                                         const target::ShaderLibrary& library, Diags& diags) {
    std::optional<material::CheckedMaterial> checked = read_and_verify(request, files, library, diags);
    if (!checked) return std::nullopt;

    std::size_t before = diags.error_count();
    ir::Module lowered = material::lower(*checked, material::Custom::called, request.numbers);
    ir::Module optimised = request.optimise_ir ? opt::optimise(lowered, request.skipped_rule) : lowered;
    SamplerGroups samplers = group_samplers(*checked);
    emit::MaterialInterface interface = emit::material_interface(optimised, samplers.group);

    Compiled out{.ir = ir::print(lowered), .reference_ir = "", .optimised_ir = ir::print(optimised)};
    if (material::has_reference(*checked))
        out.reference_ir = ir::print(material::lower(*checked, material::Custom::replaced));
    std::vector<CompiledEntry> entries;
    for (const emit::EntryPoint& entry : emit::all_entry_points()) {
        if (!wanted(request, entry.name)) continue;
        std::optional<CompiledEntry> compiled =
            compile_entry(request, entry, optimised, interface, library, diags);
        if (!compiled) continue;
        std::string name(entry.name);
        out.glsl.push_back({name + ".vert", compiled->shaders.vertex});
        out.glsl.push_back({name + ".frag", compiled->shaders.fragment});
        out.spirv_assembly.push_back({name + ".vert", target::disassemble(compiled->vertex)});
        out.spirv_assembly.push_back({name + ".frag", target::disassemble(compiled->fragment)});
        entries.push_back(std::move(*compiled));
    }
    std::optional<CompiledFunction> function;
    if (wanted(request, emit::kFunctionEntry)) {
        function = compile_function(optimised, interface, request.stem, request.targets, library, diags);
        if (function)
            out.glsl.push_back(
                {std::string(emit::kFunctionEntry), function->function.comment + function->function.text});
    }
    if (has_limits(checked->budget) || has_limits(request.budget)) {
        auto forward = std::find_if(entries.begin(), entries.end(),
                                    [](const CompiledEntry& e) { return e.entry->name == "forward"; });
        // It counts for every build, also one that leaves the forward entry out.
        ForwardCost cost = forward != entries.end()
                               ? forward_cost(forward->fragment)
                               : forward_cost(optimised, interface, request.stem, library, request.spirv);
        hold_to_budget(cost, checked->budget, checked->source, diags);
        hold_to_budget(cost, request.budget, request.source, diags);
    }
    if (diags.error_count() != before) return std::nullopt;
    std::string file = std::filesystem::path(request.source->name).filename().string();
    out.files = artefact_files({request.stem, file, content_hash(request.source->text), &*checked, &optimised,
                                &interface, &samplers.settings, &entries, function ? &*function : nullptr,
                                ships(request, target::Language::spirv)});
    return out;
}

}  // namespace sg

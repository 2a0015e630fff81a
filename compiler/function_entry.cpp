#include "function_entry.hpp"

#include <fmt/core.h>

#include "opt/optimise.hpp"
#include "shader_source.hpp"
#include "target/cross.hpp"
#include "target/function_text.hpp"
#include "target/lacks.hpp"

namespace sg {
namespace {

// GLSL's types by other names are the cross-compiler's affair; these two are shared by all materials.
constexpr std::string_view kShared[] = {"SgMaterialInputs", "SgMaterialResult"};

std::string shader_that_calls(const emit::MaterialFunction& function) {
    return "#version 450\n#extension GL_GOOGLE_include_directive : require\n" + function.text + "\n" +
           function.caller;
}

}  // namespace

std::optional<CompiledFunction> compile_function(const ir::Module& module,
                                                 const emit::MaterialInterface& interface,
                                                 const std::string& stem,
                                                 std::span<const target::Target* const> targets,
                                                 const target::ShaderLibrary& library, Diags& diags) {
    CompiledFunction out{
        emit::emit_function(opt::select_outputs(module, emit::function_outputs()), interface, stem), {}};
    const std::string shader = shader_that_calls(out.function);
    const std::string name = fmt::format("{}.{}", stem, emit::kFunctionEntry);
    ShaderSource source(shader, name, target::Stage::fragment, library);
    const target::Words& plain = source.plain_words();
    const std::size_t before = diags.error_count();
    for (const target::Target* target : targets) {
        std::string missing = target::missing_feature(plain, *target);
        if (!missing.empty()) {
            diags.error(Code::target_lacks,
                        fmt::format("'{}' {}, which {} cannot express", name, missing, target->name));
            continue;
        }
        std::string fault;
        auto text = target->language == target::Language::spirv
                        ? target::without_includes(out.function.text, library)
                        : target::cross_compile_function(source.words(*target), *target, out.function.suffix,
                                                         kShared, fault);
        if (!text) {
            cannot_write(name, *target, out.function.has_user_glsl, fault, diags);
            continue;
        }
        std::string signature = target::signature_of(*text, out.function.name);
        out.texts.push_back({target, out.function.comment + "\n" + *text, std::move(signature)});
    }
    if (diags.error_count() != before) return std::nullopt;
    return out;
}

}  // namespace sg

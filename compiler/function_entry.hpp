// The entry point `function` of one material: its text in the languages that were asked for.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/diag.hpp"
#include "emit/function.hpp"
#include "target/shader_library.hpp"
#include "target/targets.hpp"

namespace sg {

struct FunctionText {
    const target::Target* target = nullptr;
    std::string text;       // to be included
    std::string signature;  // of the function, in the text's language
};

struct CompiledFunction {
    emit::MaterialFunction function;
    std::vector<FunctionText> texts;  // in the order of the targets; for spirv GLSL for Vulkan
};

// `module` is the whole optimised one. Empty exactly when it added an error (target_lacks).
std::optional<CompiledFunction> compile_function(const ir::Module& module,
                                                 const emit::MaterialInterface& interface,
                                                 const std::string& stem,
                                                 std::span<const target::Target* const> targets,
                                                 const target::ShaderLibrary& library, Diags& diags);

}  // namespace sg

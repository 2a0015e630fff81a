// What the compiler did with a material and what each layer costs, as text for people: same input, same
// bytes.
#pragma once

#include <optional>
#include <string>

#include "compile.hpp"

namespace sg {

// The IR before and after the optimiser with the rule behind each line that changed, then a table of layers:
// what the forward fragment shader costs less when a layer is left out. Empty exactly when it added an error.
std::optional<std::string> explain_material(const CompileRequest& request, Files& files,
                                            const target::ShaderLibrary& library, Diags& diags);

// Of it, the IR before and after alone.
std::string explain_module(const ir::Module& before, std::string_view skipped_rule = "");

}  // namespace sg

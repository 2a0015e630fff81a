// Modules with one thing wrong: what the oracle must notice.
#pragma once

#include <span>
#include <string_view>

#include "ir/ir.hpp"

namespace sg::oracle {

// Changes one value of the module, which keeps it valid, or says that there is nothing to change.
struct ModuleMutant {
    std::string_view name;
    bool (*apply)(ir::Module& module, ir::Value& value);
};
std::span<const ModuleMutant> all_module_mutants();

// At the last place where it applies: what is near the outputs is not hidden behind other values. False if
// there is none.
bool apply_last(const ModuleMutant& mutant, ir::Module& module);

}  // namespace sg::oracle

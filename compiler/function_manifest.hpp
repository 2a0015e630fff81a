// What the manifest says of the entry point `function`. The fields are documented in compiler/artefacts.md.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "function_entry.hpp"
#include "material/checked.hpp"

namespace sg {

// JSON text. Adds the function's texts to `files`, by name and bytes.
std::string function_json(const CompiledFunction& compiled, const std::string& stem,
                          const material::CheckedMaterial& material, const emit::MaterialInterface& interface,
                          std::vector<std::pair<std::string, std::string>>& files);

}  // namespace sg

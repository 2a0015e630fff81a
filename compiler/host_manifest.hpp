// What the manifest's parameter block says of the numbers that the host computes. The fields and the grammar
// of expressions are documented in compiler/artefacts.md.
#pragma once

#include <string>

#include "emit/interface.hpp"
#include "material/checked.hpp"

namespace sg {

// JSON text of an object: "derived" and "steps", each absent without any, and "default_bytes".
std::string host_json(const ir::Module& module, const material::CheckedMaterial& material,
                      const emit::MaterialInterface& interface);

}  // namespace sg

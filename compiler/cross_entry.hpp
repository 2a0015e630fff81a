// The shaders of one entry point in the languages that were asked for.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "artefact.hpp"
#include "base/diag.hpp"

namespace sg {

// `name` is "brick.forward". Empty exactly when it added an error (target_lacks). Targets that are no text
// are left out.
std::optional<std::vector<CrossFile>> cross_entry(const emit::Shaders& shaders, const std::string& name,
                                                  std::span<const target::Target* const> targets,
                                                  const emit::MaterialInterface& interface,
                                                  const target::ShaderLibrary& library, Diags& diags);

}  // namespace sg

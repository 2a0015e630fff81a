// The material's parameter block, filled from the manifest's defaults and the user's settings.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/diag.hpp"
#include "runtime/artefact.hpp"

namespace sg::runtime {

// Each setting is "NAME=VALUE" or "NAME=VALUE,VALUE,..." with as many numbers as the type has. Empty without
// a block. Fails with unknown_material_parameter, or bad_argument for a text that is no such value or lies
// outside the range.
std::optional<std::vector<std::byte>> pack_parameters(const Artefact& artefact,
                                                      std::span<const std::string> settings, Diags& diags);

// What follows from the parameters, one entry per derived parameter of the block.
std::vector<Numbers> derived_numbers(const ParameterBlock& block, std::span<const Numbers> parameters);

// Numbers separated by commas, all finite, nothing else around them; none if the text is anything else.
std::optional<std::vector<double>> parse_numbers(std::string_view text);

}  // namespace sg::runtime

// Lighting models of the entry point `forward`: one row per model, and one file,
// shader_lib/lighting/<name>.glsl, with the struct of the row and `vec3 sg_<name>_radiance(<struct> surface,
// vec3 n, SgLights lights)`.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ir/ir.hpp"

namespace sg::ir {

struct LightingModel {
    std::string_view name;     // in JSON, IR, GLSL and file
    std::string_view surface;  // GLSL struct of what it is told
    std::string_view doc;
    std::vector<Output> inputs;  // the members of the struct, by their names
};
std::span<const LightingModel> all_lighting_models();  // the first is the default
// By its name; its index is what a module holds.
std::optional<std::uint32_t> find_lighting_model(std::string_view name);

// Whether the model is told it. What no model is told (opacity) belongs to all of them.
bool has_input(const LightingModel& model, Output input);

}  // namespace sg::ir

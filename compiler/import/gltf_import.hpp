// glTF materials become materials of this project.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/diag.hpp"
#include "base/files.hpp"

namespace sg::import {

// Names relative to the output folder, with their bytes.
using ImportedFiles = std::vector<std::pair<std::filesystem::path, std::string>>;

// One "<material>.json" for each material of a .gltf or .glb, and "textures/<picture>" for each picture that
// they use. Read are the core materials (glTF 2.0, 3.9), KHR_texture_transform and
// KHR_materials_emissive_strength; each other extension of a material adds a warning (import_left_out).
// Errors are those of asset::read_gltf_materials.
std::optional<ImportedFiles> import_gltf(Files& files, const std::filesystem::path& path, Diags& diags);

}  // namespace sg::import

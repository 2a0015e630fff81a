// Meshes made ready for an entry point.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "asset/mesh.hpp"
#include "base/diag.hpp"
#include "runtime/artefact.hpp"

namespace sg::runtime {

// The mesh with every attribute that the entry point reads. Missing tangents are made from uv0. Any other
// missing attribute adds mesh_attribute, which names the attribute, the mesh and the material.
std::optional<asset::Mesh> prepare_mesh(const asset::Mesh& mesh, const EntryPoint& entry,
                                        std::string_view material, Diags& diags);

// The attribute's floats as they lie in a vertex buffer; empty if the mesh does not have it.
std::span<const std::byte> attribute_bytes(const asset::Mesh& mesh, std::string_view name);

}  // namespace sg::runtime

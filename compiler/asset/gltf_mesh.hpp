// One glTF primitive becomes one mesh. Internal to this folder.
#pragma once

#include <optional>

#include "asset/gltf_accessor.hpp"
#include "asset/mesh.hpp"

namespace tinygltf {
struct Primitive;
}

namespace sg::asset {

// Nothing, with reader.reason, if the primitive is damaged; a mesh without indices if it holds no triangles.
std::optional<Mesh> read_primitive(AccessorReader& reader, const tinygltf::Primitive& primitive);

}  // namespace sg::asset

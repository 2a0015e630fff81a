// Triangle meshes and the scenes that glTF files hold, in this project's conventions.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/diag.hpp"
#include "base/files.hpp"

namespace sg::asset {

// Indexed triangles, counter-clockwise front faces. An attribute is absent (empty) or has one entry per
// vertex.
struct Mesh {
    std::string name;
    std::string material;              // name of the glTF material, "" without one
    std::vector<glm::vec3> positions;  // object space
    std::vector<glm::vec3> normals;    // unit
    std::vector<glm::vec4> tangents;   // xyz unit; w +1 or -1: bitangent = w * cross(N, T) points to +t
    std::vector<glm::vec4> colors;     // linear
    std::array<std::vector<glm::vec2>, 8> uvs;  // origin at the upper left, t grows downward
    std::vector<std::uint32_t> indices;         // multiple of 3
};

// One mesh drawn with one transform; a negative determinant is a mirrored instance.
struct Instance {
    std::string node;  // the glTF node's name
    std::size_t mesh = 0;
    glm::mat4 world_from_object{1.0f};
};

struct Scene {
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
};

// Reads .gltf or .glb with its buffers through `files`. Indexed and plain triangles, strips and fans; sparse
// and interleaved accessors; every uv set; node hierarchies. Missing normals become flat normals
// (glTF 2.0, 3.7.2.1). glTF's tangent w is negated: there w * cross(N, T) points towards decreasing t. Lines
// and points are left out. A damaged file adds errors (mesh_format, mesh_empty) and gives nothing; never
// crashes on hostile bytes.
std::optional<Scene> read_gltf(Files& files, const std::filesystem::path& path, Diags& diags);

}  // namespace sg::asset

#include "runtime/vertices.hpp"

#include <fmt/core.h>

#include "runtime/mesh/tangents.hpp"

namespace sg::runtime {
namespace {

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}

}  // namespace

std::span<const std::byte> attribute_bytes(const asset::Mesh& mesh, std::string_view name) {
    if (name == "position") return bytes_of(mesh.positions);
    if (name == "normal") return bytes_of(mesh.normals);
    if (name == "tangent") return bytes_of(mesh.tangents);
    if (name == "color") return bytes_of(mesh.colors);
    if (name.size() == 3 && name.starts_with("uv") && name[2] >= '0' && name[2] <= '7') {
        return bytes_of(mesh.uvs[static_cast<std::size_t>(name[2] - '0')]);
    }
    return {};
}

std::optional<asset::Mesh> prepare_mesh(const asset::Mesh& mesh, const EntryPoint& entry,
                                        std::string_view material, Diags& diags) {
    std::optional<asset::Mesh> out = mesh;
    bool complete = true;
    auto require = [&](std::string_view name, std::string_view purpose) {
        if (!attribute_bytes(mesh, name).empty()) return true;
        diags.error(Code::mesh_attribute,
                    fmt::format("mesh '{}' has no '{}', which material '{}' needs{}", printable(mesh.name),
                                name, printable(material), purpose));
        return complete = false;
    };
    for (const VertexInput& input : entry.inputs) {
        if (input.name == "tangent" && mesh.tangents.empty()) {
            constexpr std::string_view kPurpose = " to make tangents";
            bool has_normals = require("normal", kPurpose);
            if (require("uv0", kPurpose) && has_normals) make_tangents(*out, 0);
        } else {
            require(input.name, "");
        }
    }
    if (!complete) return std::nullopt;
    return out;
}

}  // namespace sg::runtime

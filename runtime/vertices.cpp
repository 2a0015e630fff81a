#include "runtime/vertices.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

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
    std::string shown =
        mesh.name.empty() ? "a mesh without a name" : fmt::format("mesh '{}'", printable(mesh.name));
    std::vector<std::string_view> missing;
    auto require = [&](std::string_view name, std::string_view purpose) {
        if (!attribute_bytes(mesh, name).empty()) return;
        if (std::find(missing.begin(), missing.end(), name) != missing.end()) return;
        missing.push_back(name);
        std::string text = fmt::format("{} has no '{}', which material '{}' needs{}", shown, name,
                                       printable(material), purpose);
        // The parts of one mesh share its name: once is enough.
        bool said = std::any_of(diags.all().begin(), diags.all().end(),
                                [&](const Diagnostic& other) { return other.message == text; });
        if (!said) diags.error(Code::mesh_attribute, text);
    };
    bool needs_tangents = false;
    for (const VertexInput& input : entry.inputs) {
        bool is_tangent = input.name == "tangent" && mesh.tangents.empty();
        needs_tangents = needs_tangents || is_tangent;
        if (!is_tangent) require(input.name, "");
    }
    if (needs_tangents) {
        require("normal", " to make tangents");
        require("uv0", " to make tangents");
    }
    if (!missing.empty()) return std::nullopt;
    if (needs_tangents) make_tangents(*out, 0);
    return out;
}

}  // namespace sg::runtime

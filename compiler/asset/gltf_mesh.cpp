#include "asset/gltf_mesh.hpp"

#include <fmt/core.h>

#include <cstring>
#include <numeric>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

namespace sg::asset {
namespace {

// glm vectors of the attribute, or nothing where it is absent. False if it is damaged or has a wrong count.
template <class Vector>
bool read_attribute(AccessorReader& reader, const tinygltf::Primitive& primitive, const std::string& name,
                    std::size_t count, bool may_be_narrower, std::vector<Vector>& out) {
    const auto it = primitive.attributes.find(name);
    if (it == primitive.attributes.end()) return true;
    constexpr int kWidth = Vector::length();
    std::vector<float> numbers;
    if (!reader.read_floats(it->second, kWidth, may_be_narrower, numbers)) return false;
    const std::size_t found = numbers.size() / kWidth;
    if (found != count) {
        reader.reason = fmt::format("attribute {} has {} elements, expected {} as POSITION has",
                                    printable(name), found, count);
        return false;
    }
    out.resize(count);
    if (count > 0) std::memcpy(out.data(), numbers.data(), numbers.size() * sizeof(float));
    return true;
}

bool read_attributes(AccessorReader& reader, const tinygltf::Primitive& primitive, Mesh& mesh) {
    std::vector<float> positions;
    if (!reader.read_floats(primitive.attributes.at("POSITION"), 3, false, positions)) return false;
    const std::size_t count = positions.size() / 3;
    mesh.positions.resize(count);
    if (count > 0) std::memcpy(mesh.positions.data(), positions.data(), positions.size() * sizeof(float));
    bool ok = read_attribute(reader, primitive, "NORMAL", count, false, mesh.normals) &&
              read_attribute(reader, primitive, "TANGENT", count, false, mesh.tangents) &&
              read_attribute(reader, primitive, "COLOR_0", count, true, mesh.colors);
    for (std::size_t set = 0; ok && set < mesh.uvs.size(); ++set)
        ok = read_attribute(reader, primitive, fmt::format("TEXCOORD_{}", set), count, false, mesh.uvs[set]);
    return ok;
}

void add_triangle(std::vector<std::uint32_t>& out, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) out.insert(out.end(), {a, b, c});
}

// glTF 2.0, 3.7.2.1: the corners of strips and fans in their order.
std::vector<std::uint32_t> triangles_of(const std::vector<std::uint32_t>& corners, int mode) {
    std::vector<std::uint32_t> out;
    if (mode == TINYGLTF_MODE_TRIANGLES)
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
            add_triangle(out, corners[i], corners[i + 1], corners[i + 2]);
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP)
        for (std::size_t i = 0; i + 2 < corners.size(); ++i)
            add_triangle(out, corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]);
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
        for (std::size_t i = 0; i + 2 < corners.size(); ++i)
            add_triangle(out, corners[i + 1], corners[i + 2], corners[0]);
    return out;
}

bool read_triangles(AccessorReader& reader, const tinygltf::Primitive& primitive, Mesh& mesh) {
    std::vector<std::uint32_t> corners;
    if (primitive.indices >= 0) {
        if (!reader.read_indices(primitive.indices, corners)) return false;
    } else {
        corners.resize(mesh.positions.size());
        std::iota(corners.begin(), corners.end(), 0u);
    }
    for (const std::uint32_t corner : corners) {
        if (corner < mesh.positions.size()) continue;
        reader.reason = fmt::format("index {} is out of range, expected less than {} vertices", corner,
                                    mesh.positions.size());
        return false;
    }
    mesh.indices = triangles_of(corners, primitive.mode);
    return true;
}

// Twice the triangle's area along its normal, in double: long edges must not overflow.
glm::dvec3 triangle_normal(const Mesh& mesh, std::size_t first_corner) {
    const glm::dvec3 p0 = mesh.positions[mesh.indices[first_corner]];
    const glm::dvec3 p1 = mesh.positions[mesh.indices[first_corner + 1]];
    const glm::dvec3 p2 = mesh.positions[mesh.indices[first_corner + 2]];
    return glm::cross(p1 - p0, p2 - p0);
}

// Unit, or +Z for a vector without a direction.
glm::vec3 unit_or_z(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0, 0, 1);
}

template <class T>
void unshare(std::vector<T>& attribute, const std::vector<std::uint32_t>& indices) {
    if (attribute.empty()) return;
    std::vector<T> out;
    out.reserve(indices.size());
    for (const std::uint32_t i : indices) out.push_back(attribute[i]);
    attribute = std::move(out);
}

// glTF 2.0, 3.7.2.1: without normals, flat ones; stored tangents then have no meaning.
void make_flat(Mesh& mesh) {
    mesh.tangents.clear();
    unshare(mesh.positions, mesh.indices);
    unshare(mesh.colors, mesh.indices);
    for (auto& uv : mesh.uvs) unshare(uv, mesh.indices);
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        mesh.normals.insert(mesh.normals.end(), 3, unit_or_z(triangle_normal(mesh, i)));
}

// Normals become unit; one without a direction takes the mean of its triangles.
void mend_normals(Mesh& mesh) {
    std::vector<glm::dvec3> sums;
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
        const glm::dvec3 normal = mesh.normals[v];
        if (glm::length(normal) > 0.0) {
            mesh.normals[v] = unit_or_z(normal);
            continue;
        }
        if (sums.empty()) {
            sums.resize(mesh.positions.size());
            for (std::size_t i = 0; i < mesh.indices.size(); ++i)
                sums[mesh.indices[i]] += triangle_normal(mesh, i / 3 * 3);
        }
        mesh.normals[v] = unit_or_z(sums[v]);
    }
}

// Tangents become unit and w changes to this project's sign; one without a direction becomes perpendicular to
// N.
void mend_tangents(Mesh& mesh) {
    for (std::size_t v = 0; v < mesh.tangents.size(); ++v) {
        glm::vec4& tangent = mesh.tangents[v];
        glm::dvec3 direction = glm::vec3(tangent);
        if (!(glm::length(direction) > 0.0)) {
            const glm::dvec3 n = mesh.normals[v];
            direction = glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
        }
        tangent = glm::vec4(unit_or_z(direction), tangent.w < 0.0f ? 1.0f : -1.0f);
    }
}

}  // namespace

std::optional<Mesh> read_primitive(AccessorReader& reader, const tinygltf::Primitive& primitive) {
    Mesh mesh;
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES || !primitive.attributes.count("POSITION")) return mesh;
    if (!read_attributes(reader, primitive, mesh) || !read_triangles(reader, primitive, mesh))
        return std::nullopt;
    if (mesh.indices.empty()) return Mesh{};
    if (mesh.normals.empty()) make_flat(mesh);
    mend_normals(mesh);
    mend_tangents(mesh);
    return mesh;
}

}  // namespace sg::asset

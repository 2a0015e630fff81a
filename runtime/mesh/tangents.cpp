#include "runtime/mesh/tangents.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace sg::runtime {
namespace {

// A uv triangle whose sides are more nearly parallel than this counts as one without area.
constexpr double kLeastSine = 1e-6;

// dP/ds and dP/dt of one triangle.
struct Derivatives {
    glm::dvec3 s{0.0};
    glm::dvec3 t{0.0};
};

// Lengyel 7.37, from the sides at the first corner; nothing for uvs without area.
std::optional<Derivatives> triangle_derivatives(const asset::Mesh& mesh, const std::vector<glm::vec2>& uvs,
                                                const std::uint32_t* corners) {
    const glm::dvec3 p0 = mesh.positions[corners[0]];
    const glm::dvec3 e1 = glm::dvec3(mesh.positions[corners[1]]) - p0;
    const glm::dvec3 e2 = glm::dvec3(mesh.positions[corners[2]]) - p0;
    const glm::dvec2 w0 = uvs[corners[0]];
    const glm::dvec2 w1 = glm::dvec2(uvs[corners[1]]) - w0;
    const glm::dvec2 w2 = glm::dvec2(uvs[corners[2]]) - w0;
    const double determinant = w1.x * w2.y - w2.x * w1.y;
    if (!(std::abs(determinant) > kLeastSine * glm::length(w1) * glm::length(w2))) return std::nullopt;
    return Derivatives{(e1 * w2.y - e2 * w1.y) / determinant, (e2 * w1.x - e1 * w2.x) / determinant};
}

// What a vertex has gathered from triangles of one handedness.
struct Sum {
    glm::dvec3 s{0.0};
    bool used = false;
};

// The sums of one vertex: [0] right-handed (cross(dP/ds, dP/dt) along the normal), [1] left-handed.
using Sums = std::array<Sum, 2>;

// Which of the two a corner belongs to; -1 for a corner of a triangle without area.
using Sides = std::vector<int>;

Sides accumulate(const asset::Mesh& mesh, const std::vector<glm::vec2>& uvs, std::vector<Sums>& sums) {
    Sides sides(mesh.indices.size(), -1);
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        const auto derivatives = triangle_derivatives(mesh, uvs, &mesh.indices[first]);
        if (!derivatives) continue;
        for (std::size_t corner = first; corner < first + 3; ++corner) {
            const std::uint32_t vertex = mesh.indices[corner];
            const glm::dvec3 normal = mesh.normals[vertex];
            sides[corner] = glm::dot(glm::cross(derivatives->s, derivatives->t), normal) > 0.0 ? 0 : 1;
            Sum& sum = sums[vertex][static_cast<std::size_t>(sides[corner])];
            sum.s += derivatives->s;
            sum.used = true;
        }
    }
    return sides;
}

glm::vec4 tangent_of(const Sum& sum, const glm::vec3& unit_normal, float w) {
    const glm::dvec3 n = unit_normal;
    glm::dvec3 tangent = sum.s - glm::dot(sum.s, n) * n;
    if (!(glm::length(tangent) > 1e-9 * glm::length(sum.s)))
        tangent = glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    const double length = glm::length(tangent);
    return {length > 0.0 ? glm::vec3(tangent / length) : glm::vec3(1, 0, 0), w};
}

template <class T>
void copy_entry(std::vector<T>& attribute, std::uint32_t entry) {
    if (attribute.empty()) return;
    const T value = attribute[entry];
    attribute.push_back(value);
}

std::uint32_t copy_vertex(asset::Mesh& mesh, std::uint32_t vertex) {
    copy_entry(mesh.positions, vertex);
    copy_entry(mesh.normals, vertex);
    copy_entry(mesh.tangents, vertex);
    copy_entry(mesh.colors, vertex);
    for (auto& uv : mesh.uvs) copy_entry(uv, vertex);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

}  // namespace

bool make_tangents(asset::Mesh& mesh, int uv_set) {
    const std::size_t count = mesh.positions.size();
    if (uv_set < 0 || static_cast<std::size_t>(uv_set) >= mesh.uvs.size() || mesh.normals.size() != count ||
        mesh.uvs[static_cast<std::size_t>(uv_set)].size() != count)
        return false;
    std::vector<Sums> sums(count);
    const Sides sides = accumulate(mesh, mesh.uvs[static_cast<std::size_t>(uv_set)], sums);
    mesh.tangents.assign(count, glm::vec4(0.0f));
    std::vector<std::uint32_t> left_copy(count);
    for (std::uint32_t v = 0; v < count; ++v) {
        const bool only_left = sums[v][1].used && !sums[v][0].used;
        mesh.tangents[v] = tangent_of(sums[v][only_left ? 1 : 0], mesh.normals[v], only_left ? -1.0f : 1.0f);
        left_copy[v] = v;
        if (!sums[v][0].used || !sums[v][1].used) continue;
        left_copy[v] = copy_vertex(mesh, v);
        mesh.tangents.back() = tangent_of(sums[v][1], mesh.normals[v], -1.0f);
    }
    for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner)
        if (sides[corner] == 1) mesh.indices[corner] = left_copy[mesh.indices[corner]];
    return true;
}

}  // namespace sg::runtime

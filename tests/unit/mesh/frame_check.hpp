// Numerical dP/ds and dP/dt of single triangles, for checks that do not trust the code under test.
#pragma once

#include <glm/glm.hpp>

#include "asset/mesh.hpp"

namespace sg::test {

struct TriangleFrame {
    glm::dvec3 face_normal;  // not unit; towards the side from which the corners are counter-clockwise
    glm::dvec3 ds;           // dP/ds
    glm::dvec3 dt;           // dP/dt
    double uv_area = 0.0;    // twice the signed area
};

// P is linear in the uvs over a triangle: both derivatives follow from two sides.
inline TriangleFrame triangle_frame(const asset::Mesh& mesh, std::size_t first, std::size_t uv_set) {
    const std::uint32_t* i = &mesh.indices[first];
    const glm::dvec3 p0 = mesh.positions[i[0]], p1 = mesh.positions[i[1]], p2 = mesh.positions[i[2]];
    const auto& uv = mesh.uvs[uv_set];
    const glm::dvec2 a = glm::dvec2(uv[i[1]]) - glm::dvec2(uv[i[0]]),
                     b = glm::dvec2(uv[i[2]]) - glm::dvec2(uv[i[0]]);
    const glm::dmat2 inverse = glm::inverse(glm::dmat2(a, b));
    return {glm::cross(p1 - p0, p2 - p0), (p1 - p0) * inverse[0][0] + (p2 - p0) * inverse[0][1],
            (p1 - p0) * inverse[1][0] + (p2 - p0) * inverse[1][1], a.x * b.y - b.x * a.y};
}

inline double cosine(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::dot(a, b) / (glm::length(a) * glm::length(b));
}

// w * cross(N, T), which must point to +t.
inline glm::dvec3 bitangent(const asset::Mesh& mesh, std::uint32_t vertex) {
    const glm::dvec4 tangent = mesh.tangents[vertex];
    return tangent.w * glm::cross(glm::dvec3(mesh.normals[vertex]), glm::dvec3(tangent));
}

}  // namespace sg::test

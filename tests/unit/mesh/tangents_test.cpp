// Vertex tangents from triangles: against the exact ones, on mirrored charts, and without any uv area.
#include "runtime/mesh/tangents.hpp"

#include <gtest/gtest.h>

#include "runtime/mesh/shapes.hpp"
#include "tests/unit/mesh/frame_check.hpp"

namespace sg::runtime {
namespace {

using asset::Mesh;
using test::cosine;

TEST(Tangents, AgreeWithTheExactOnes) {
    std::vector<Mesh> meshes{make_sphere(128, 64, true), make_torus(128, 64, 1.0f, 0.4f, true)};
    for (const std::string_view name : shape_names()) meshes.push_back(*make_shape(name));
    for (const Mesh& exact : meshes) {
        Mesh mesh = exact;
        ASSERT_TRUE(make_tangents(mesh));
        ASSERT_EQ(mesh.positions.size(), exact.positions.size()) << exact.name << ": nothing to split";
        for (std::size_t v = 0; v < mesh.tangents.size(); ++v) {
            EXPECT_GT(cosine(glm::vec3(mesh.tangents[v]), glm::vec3(exact.tangents[v])), 0.998)
                << exact.name << v;
            EXPECT_EQ(mesh.tangents[v].w, exact.tangents[v].w) << exact.name;
        }
    }
}

TEST(Tangents, OfTheSecondSetPointAlongIt) {
    Mesh mesh = *make_shape("torus");
    ASSERT_TRUE(make_tangents(mesh, 1));
    for (std::size_t first = 0; first < mesh.indices.size(); first += 3) {
        const test::TriangleFrame frame = test::triangle_frame(mesh, first, 1);
        const std::uint32_t v = mesh.indices[first];
        EXPECT_GT(cosine(frame.ds, glm::vec3(mesh.tangents[v])), 0.99);
        EXPECT_GT(cosine(frame.dt, test::bitangent(mesh, v)), 0.99);
        EXPECT_EQ(mesh.tangents[v].w, 1.0f);
    }
}

TEST(Tangents, AMirroredChartIsSplitAlongItsAxis) {
    Mesh mesh = make_plane(4, false);
    for (glm::vec2& uv : mesh.uvs[0])
        uv.x = std::abs(2.0f * uv.x - 1.0f);  // the left half mirrors the right one
    const std::size_t before = mesh.positions.size();
    ASSERT_TRUE(make_tangents(mesh));
    EXPECT_EQ(mesh.positions.size(), before + 5) << "the five vertices on the axis";
    EXPECT_EQ(mesh.normals.size(), before + 5);
    EXPECT_EQ(mesh.uvs[1].size(), before + 5);
    for (std::size_t first = 0; first < mesh.indices.size(); first += 3) {
        const test::TriangleFrame frame = test::triangle_frame(mesh, first, 0);
        for (std::size_t corner = first; corner < first + 3; ++corner) {
            const std::uint32_t v = mesh.indices[corner];
            EXPECT_NEAR(cosine(frame.ds, glm::vec3(mesh.tangents[v])), 1.0, 1e-6);
            EXPECT_NEAR(cosine(frame.dt, test::bitangent(mesh, v)), 1.0, 1e-6);
        }
    }
}

TEST(Tangents, TrianglesWithoutUvAreaDoNoHarm) {
    Mesh mesh = make_plane(2, false);
    for (std::size_t v = 0; v < 3; ++v) mesh.uvs[0][v] = glm::vec2(0.0f, 0.5f);  // the upper row collapses
    ASSERT_TRUE(make_tangents(mesh));
    for (auto& uv : mesh.uvs[0]) uv = glm::vec2(0.25f);
    Mesh flat = mesh;
    ASSERT_TRUE(make_tangents(flat));
    for (const Mesh* each : {&mesh, &flat}) {
        for (std::size_t v = 0; v < each->tangents.size(); ++v) {
            EXPECT_NEAR(glm::length(glm::vec3(each->tangents[v])), 1.0f, 1e-6f);
            EXPECT_NEAR(glm::dot(glm::vec3(each->tangents[v]), each->normals[v]), 0.0f, 1e-6f);
            EXPECT_EQ(std::abs(each->tangents[v].w), 1.0f);
        }
    }
}

TEST(Tangents, WithoutNormalsOrUvsNothingChanges) {
    Mesh mesh = make_plane(1, false);
    mesh.tangents.clear();
    EXPECT_FALSE(make_tangents(mesh, 3));
    EXPECT_FALSE(make_tangents(mesh, 8));
    EXPECT_FALSE(make_tangents(mesh, -1));
    mesh.normals.clear();
    EXPECT_FALSE(make_tangents(mesh, 0));
    EXPECT_TRUE(mesh.tangents.empty());
}

}  // namespace
}  // namespace sg::runtime

// The convention of the built-in shapes, checked by finite differences over every triangle.
#include "runtime/mesh/shapes.hpp"

#include <gtest/gtest.h>

#include <set>

#include "runtime/mesh/smooth.hpp"
#include "tests/unit/mesh/frame_check.hpp"

namespace sg::runtime {
namespace {

using asset::Mesh;
using test::cosine;

struct Case {
    std::string name;
    Mesh mesh;
    float w;
    bool closed;
    // Where the lines of s and t cross at other angles than 90 degrees, a bitangent is not dP/dt: 40 degrees
    // at most on these shapes.
    bool skewed = false;
};

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const std::string_view name : shape_names())
        cases.push_back({std::string(name), *make_shape(name), -1, name != "plane",
                         name == "rounded_cube" || name == "rock"});
    cases.push_back({"mirrored plane", make_plane(3, true), 1, false});
    cases.push_back({"mirrored sphere", make_sphere(96, 48, true), 1, true});
    cases.push_back({"mirrored torus", make_torus(96, 48, 2.0f, 0.5f, true), 1, true});
    return cases;
}

TEST(Shapes, AttributesAreWhole) {
    for (const auto& [name, mesh, w, closed, skewed] : all_cases()) {
        const std::size_t count = mesh.positions.size();
        ASSERT_EQ(mesh.normals.size(), count) << name;
        ASSERT_EQ(mesh.tangents.size(), count) << name;
        ASSERT_EQ(mesh.uvs[0].size(), count) << name;
        ASSERT_EQ(mesh.uvs[1].size(), count) << name;
        ASSERT_EQ(mesh.uvs[2].size(), count) << name;
        ASSERT_EQ(mesh.colors.size(), count) << name;
        std::set<std::uint32_t> used(mesh.indices.begin(), mesh.indices.end());
        EXPECT_EQ(used.size(), count) << name;
        EXPECT_LT(*used.rbegin(), count) << name;
        for (std::size_t v = 0; v < count; ++v) {
            EXPECT_NEAR(glm::length(mesh.normals[v]), 1.0f, 1e-6f) << name;
            EXPECT_NEAR(glm::length(glm::vec3(mesh.tangents[v])), 1.0f, 1e-6f) << name;
            EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[v]), mesh.normals[v]), 0.0f, 1e-6f) << name;
            EXPECT_EQ(mesh.tangents[v].w, w) << name;
        }
    }
}

TEST(Shapes, EveryCornerAgreesWithFiniteDifferences) {
    for (const auto& [name, mesh, w, closed, skewed] : all_cases()) {
        for (std::size_t first = 0; first < mesh.indices.size(); first += 3) {
            const test::TriangleFrame frame = test::triangle_frame(mesh, first, 0);
            ASSERT_GT(glm::length(frame.face_normal), 1e-9) << name << " has a triangle without area";
            for (std::size_t corner = first; corner < first + 3; ++corner) {
                const std::uint32_t v = mesh.indices[corner];
                ASSERT_GT(cosine(frame.face_normal, mesh.normals[v]), 0.99) << name << ": winding";
                ASSERT_GT(cosine(frame.ds, glm::vec3(mesh.tangents[v])), 0.99)
                    << name << ": tangent at " << first;
                ASSERT_GT(cosine(frame.dt, test::bitangent(mesh, v)), skewed ? 0.76 : 0.99)
                    << name << ": w at " << first;
            }
        }
    }
}

TEST(Shapes, TheSecondSetIsTurnedAndMirrored) {
    for (const auto& [name, mesh, w, closed, skewed] : all_cases()) {
        for (std::size_t first = 0; first < mesh.indices.size(); first += 3) {
            const test::TriangleFrame second = test::triangle_frame(mesh, first, 1);
            ASSERT_GT(second.uv_area, 0.0)
                << name << ": an upright picture has negative area, its mirror image positive";
            for (std::size_t corner = first; corner < first + 3; ++corner) {
                const std::uint32_t v = mesh.indices[corner];
                ASSERT_GT(cosine(second.ds, test::bitangent(mesh, v)), skewed ? 0.76 : 0.99)
                    << name << ": s of set 1 runs along t";
                ASSERT_LT(std::abs(cosine(second.ds, glm::vec3(mesh.tangents[v]))), skewed ? 0.65 : 0.1)
                    << name;
            }
        }
    }
}

// Volume enclosed, by the divergence theorem: positive only if all triangles face outward, exact only without
// holes.
double volume(const Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                         c = mesh.positions[mesh.indices[i + 2]];
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sum;
}

TEST(Shapes, SizesAreAsDocumented) {
    constexpr double kPi = 3.14159265358979;
    EXPECT_NEAR(volume(*make_shape("cube")), 8.0, 1e-6);
    EXPECT_NEAR(volume(*make_shape("sphere")), 4.0 / 3.0 * kPi, 0.01);
    EXPECT_NEAR(volume(*make_shape("torus")), 2 * kPi * kPi * 0.16, 0.02);
    // Two boxes' overlap, edges and corners: the cube of side 2 less what rounding takes.
    constexpr double kInner = 1.5, kR = 0.25;
    EXPECT_NEAR(volume(*make_shape("rounded_cube", 2)),
                kInner * kInner * kInner + 6 * kInner * kInner * kR + 3 * kInner * kPi * kR * kR +
                    4.0 / 3 * kPi * kR * kR * kR,
                0.01);
    const Mesh plane = *make_shape("plane");
    EXPECT_EQ(plane.positions.front(), glm::vec3(-1, 1, 0));
    EXPECT_EQ(plane.positions.back(), glm::vec3(1, -1, 0));
    EXPECT_EQ(plane.uvs[0].front(), glm::vec2(0, 0));
    EXPECT_FALSE(make_shape("teapot"));
}

// Where the formulas of README.md put known points of the picture.
TEST(Shapes, ThePictureIsUprightAndFacesZ) {
    for (const char* name : {"sphere", "torus"}) {
        const Mesh mesh = *make_shape(name);
        int found = 0;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            if (mesh.uvs[0][v] != glm::vec2(0.5f, 0.5f)) continue;
            ++found;
            EXPECT_NEAR(glm::distance(mesh.normals[v], glm::vec3(0, 0, 1)), 0.0f, 1e-6f) << name;
            EXPECT_NEAR(glm::distance(glm::vec3(mesh.tangents[v]), glm::vec3(1, 0, 0)), 0.0f, 1e-6f) << name;
            EXPECT_NEAR(mesh.positions[v].z, std::string(name) == "torus" ? 1.4f : 1.0f, 1e-6f) << name;
        }
        EXPECT_EQ(found, 1) << name;
    }
}

TEST(Shapes, SeamsCloseExactly) {
    for (const auto& [name, mesh, w, closed, skewed] : all_cases()) {
        if (!closed || name == "cube" || name == "rounded_cube") continue;
        std::set<std::array<float, 3>> at_zero, at_one;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const glm::vec3 p = mesh.positions[v];
            if (mesh.uvs[0][v].x == 0.0f) at_zero.insert({p.x, p.y, p.z});
            if (mesh.uvs[0][v].x == 1.0f) at_one.insert({p.x, p.y, p.z});
        }
        EXPECT_EQ(at_zero, at_one) << name;
    }
}

// Every vertex lies on the smooth surface behind its mesh, with that surface's normal and coordinates.
TEST(Shapes, StandForTheirSmoothSurfaces) {
    for (const std::string_view name : shape_names()) {
        const auto shape = smooth_shape(name);
        EXPECT_EQ(shape.has_value(), name != "cube");
        if (!shape) continue;
        const Mesh mesh = *make_shape(name);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            Foot near;
            near.st = mesh.uvs[0][v];
            near.chart = static_cast<int>(v * 6 / mesh.positions.size());  // faces one after the other
            const Foot foot = foot_of(*shape, mesh.positions[v], &near);
            ASSERT_LT(glm::distance(foot.position, glm::dvec3(mesh.positions[v])), 1e-6) << name;
            ASSERT_LT(glm::distance(foot.normal, glm::dvec3(mesh.normals[v])), 1e-6) << name;
            const bool pole = (name == "sphere" || name == "rock") && (near.st.y == 0 || near.st.y == 1);
            ASSERT_LT(pole ? 0 : glm::distance(foot.st, near.st), 1e-6) << name;
        }
    }
}

// The smooth surfaces' normals are those of their own positions, by differences.
TEST(Shapes, SmoothNormalsArePerpendicular) {
    for (const SmoothShape shape : {SmoothShape::plane, SmoothShape::sphere, SmoothShape::torus,
                                    SmoothShape::rounded_cube, SmoothShape::rock}) {
        for (int i = 0; i < 500; ++i) {
            const glm::dvec3 p(std::sin(1.3 * i), std::cos(2.1 * i), 1.2 * std::sin(0.7 * i + 1));
            const Foot foot = foot_of(shape, 1.1 * glm::normalize(p));
            const double h = 1e-5;
            for (const glm::dvec3 axis : {glm::dvec3(h, 0, 0), glm::dvec3(0, h, 0), glm::dvec3(0, 0, h)}) {
                const glm::dvec3 step = foot_of(shape, foot.position + axis, &foot).position -
                                        foot_of(shape, foot.position - axis, &foot).position;
                EXPECT_NEAR(glm::dot(step, foot.normal), 0, 1e-9);
            }
        }
    }
}

TEST(Shapes, DetailMakesThemFiner) {
    for (const std::string_view name : shape_names()) {
        const std::size_t once = make_shape(name)->indices.size(),
                          twice = make_shape(name, 2)->indices.size();
        // A globe's poles are rings of triangles: 2 slices (stacks - 1) of them in all.
        const bool globe = name == "sphere" || name == "rock";
        EXPECT_EQ(twice, globe ? 3 * 2 * 256 * 127u : name == "cube" ? once : once * 4) << name;
    }
}

TEST(Shapes, TinyCountsAreRaised) {
    EXPECT_EQ(make_plane(0, false).indices.size(), 6u);
    EXPECT_EQ(make_sphere(-4, 0, false).indices.size(), 18u);
    EXPECT_EQ(make_torus(0, 0, 1.0f, 0.4f, false).indices.size(), 54u);
}

}  // namespace
}  // namespace sg::runtime

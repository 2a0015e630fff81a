#include "tests/render/meshes.hpp"

#include <map>
#include <numbers>

#include "runtime/mesh/shapes.hpp"

namespace sg::truth {
namespace {

constexpr int kAround = 1024, kAlong = 256;  // sphere and torus
constexpr int kPlaneQuads = 8;
constexpr int kCylinderSlices = 12,
              kCylinderRows = 4;  // coarse on purpose: interpolated normals are up to 0.9 % short

asset::Mesh make_cylinder() {
    asset::Mesh mesh;
    mesh.name = "cylinder";
    const Surface surface{Shape::cylinder};
    for (int row = 0; row <= kCylinderRows; ++row) {
        for (int column = 0; column <= kCylinderSlices; ++column) {
            const glm::dvec2 st(double(column) / kCylinderSlices, double(row) / kCylinderRows);
            mesh.positions.emplace_back(surface.position(st));
            mesh.normals.emplace_back(surface.normal(st));
            mesh.tangents.emplace_back(glm::vec3(glm::normalize(surface.along_s(st))), -1.0f);
            mesh.uvs[0].emplace_back(st);
            mesh.uvs[1].emplace_back(st.y, st.x);
        }
    }
    for (std::uint32_t row = 0; row < kCylinderRows; ++row) {
        for (std::uint32_t column = 0; column < kCylinderSlices; ++column) {
            const std::uint32_t upper = row * (kCylinderSlices + 1) + column,
                                lower = upper + kCylinderSlices + 1;
            for (std::uint32_t i : {upper, lower, lower + 1, upper, lower + 1, upper + 1})
                mesh.indices.push_back(i);
        }
    }
    return mesh;
}

// Both halves share the vertices in the middle, where s turns round.
asset::Mesh folded(asset::Mesh mesh) {
    for (glm::vec2& uv : mesh.uvs[0]) uv = glm::vec2(Chart{0, Unwrap::folded}.from_surface(uv));
    mesh.tangents.clear();
    return mesh;
}

asset::Mesh make(Shape shape, Unwrap unwrap) {
    const bool mirror_u = unwrap == Unwrap::mirrored;
    if (unwrap == Unwrap::folded) return folded(runtime::make_plane(kPlaneQuads, false));
    switch (shape) {
        case Shape::plane:
            return runtime::make_plane(kPlaneQuads, mirror_u);
        case Shape::sphere:
            return runtime::make_sphere(kAround, kAlong, mirror_u);
        case Shape::torus:
            return runtime::make_torus(kAround, kAlong, 1.0f, 0.4f, mirror_u);
        case Shape::cylinder:
            return make_cylinder();
    }
    return {};
}

}  // namespace

Tessellation tessellation_of(Shape shape) {
    constexpr double kPi = std::numbers::pi;
    switch (shape) {
        case Shape::plane:
            return {0, 0, 2.0 / kPlaneQuads};
        case Shape::sphere:
            return {2 * kPi / kAround, kPi / kAlong, 2 * kPi / kAround};
        case Shape::torus:
            return {2 * kPi / kAround, 2 * kPi / kAlong, 2 * kPi / kAround};
        case Shape::cylinder:
            return {kPi / kCylinderSlices, 0, kPi / kCylinderSlices};
    }
    return {};
}

const asset::Mesh& mesh_of(Shape shape, Unwrap unwrap) {
    static std::map<std::pair<Shape, Unwrap>, asset::Mesh> meshes;
    auto [at, fresh] = meshes.try_emplace({shape, unwrap});
    if (fresh) at->second = make(shape, unwrap);
    return at->second;
}

}  // namespace sg::truth

#include "runtime/mesh/shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "runtime/mesh/smooth.hpp"

namespace sg::runtime {
namespace {

constexpr std::array<std::string_view, 6> kNames{"plane", "sphere", "torus", "cube", "rounded_cube", "rock"};
constexpr double kTau = glm::two_pi<double>();

// A point of a chart with its exact frame.
struct Point {
    glm::dvec3 position;
    glm::dvec3 normal;
    glm::dvec3 along_s;  // unit dP/ds
};

// From 0 to 1 and back, without a seam.
float band(double x) {
    return static_cast<float>(0.5 - 0.5 * std::cos(kTau * x));
}

// On each of these charts cross(N, dP/ds) points to -t, as in an upright picture seen from its front.
std::uint32_t add_vertex(asset::Mesh& mesh, const Point& point, glm::dvec2 st, bool mirror_u) {
    const double sign = mirror_u ? -1.0 : 1.0;
    mesh.positions.emplace_back(point.position);
    mesh.normals.emplace_back(point.normal);
    mesh.tangents.emplace_back(glm::vec3(sign * point.along_s), static_cast<float>(-sign));
    mesh.uvs[0].emplace_back(mirror_u ? 1.0 - st.x : st.x, st.y);
    mesh.uvs[1].emplace_back(st.y, st.x);
    mesh.uvs[2].emplace_back(st.x + st.y, st.y - st.x);
    mesh.colors.emplace_back(band(st.x), band(st.y), band(st.x - 0.25), 1.0f);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void add_triangle(asset::Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

// Quads of a grid of vertices, columns + 1 in a row, rows downwards.
void add_quads(asset::Mesh& mesh, std::uint32_t first, int columns, int rows) {
    const auto pitch = static_cast<std::uint32_t>(columns + 1);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t upper =
                first + static_cast<std::uint32_t>(row) * pitch + static_cast<std::uint32_t>(column);
            const std::uint32_t lower = upper + pitch;
            add_triangle(mesh, upper, lower, lower + 1);
            add_triangle(mesh, upper, lower + 1, upper + 1);
        }
    }
}

// Vertices of the rows first_row..last_row of a chart, (columns + 1) in each, and the quads between them.
template <class Chart>
void add_grid(asset::Mesh& mesh, int columns, int rows, int first_row, int last_row, bool mirror_u,
              Chart chart) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int row = first_row; row <= last_row; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const glm::dvec2 st(static_cast<double>(column) / columns, static_cast<double>(row) / rows);
            add_vertex(mesh, chart(st), st, mirror_u);
        }
    }
    add_quads(mesh, first, columns, last_row - first_row);
}

// Exactly closed at s = 0 and 1, which an angle of pi is not.
glm::dvec2 sin_cos_around(double turns) {
    if (std::abs(turns) == 0.5) return {0.0, -1.0};
    return {std::sin(kTau * turns), std::cos(kTau * turns)};
}

Point sphere_point(glm::dvec2 st) {
    const glm::dvec2 around = sin_cos_around(st.x - 0.5);
    const double ring = st.y == 0.0 || st.y == 1.0 ? 0.0 : std::sin(0.5 * kTau * st.y);
    const glm::dvec3 p(ring * around.x, std::cos(0.5 * kTau * st.y), ring * around.y);
    return {p, p, {around.y, 0.0, -around.x}};
}

Point torus_point(glm::dvec2 st, double R, double r) {
    const glm::dvec2 around = sin_cos_around(st.x - 0.5);
    const glm::dvec2 tube = sin_cos_around(0.5 - st.y);
    const glm::dvec3 normal(tube.y * around.x, tube.x, tube.y * around.y);
    return {glm::dvec3(R * around.x, 0.0, R * around.y) + r * normal, normal, {around.y, 0.0, -around.x}};
}

// On the sphere's chart; the tangent follows from dP/ds = R dd/ds + d (gradient . dd/ds).
Point rock_point(glm::dvec2 st) {
    const Point unit = sphere_point(st);
    const RockRadius r = rock_radius(unit.position);
    const Foot foot = foot_of(SmoothShape::rock, unit.position);
    const glm::dvec3 along = r.value * unit.along_s + unit.position * glm::dot(r.gradient, unit.along_s);
    return {foot.position, foot.normal, glm::normalize(along)};
}

// A sphere's grid of quads, with a ring of triangles at each pole.
template <class Chart>
void add_globe(asset::Mesh& mesh, int slices, int stacks, bool mirror_u, Chart chart) {
    slices = std::max(slices, 3);
    stacks = std::max(stacks, 2);
    add_grid(mesh, slices, stacks, 1, stacks - 1, mirror_u, chart);
    const auto last_row = static_cast<std::uint32_t>((stacks - 2) * (slices + 1));
    for (int slice = 0; slice < slices; ++slice) {
        const auto column = static_cast<std::uint32_t>(slice);
        const glm::dvec2 north((slice + 0.5) / slices, 0.0), south(north.x, 1.0);
        add_triangle(mesh, add_vertex(mesh, chart(north), north, mirror_u), column, column + 1);
        add_triangle(mesh, add_vertex(mesh, chart(south), south, mirror_u), last_row + column + 1,
                     last_row + column);
    }
}

asset::Mesh named(std::string_view name) {
    asset::Mesh mesh;
    mesh.name = name;
    return mesh;
}

}  // namespace

std::span<const std::string_view> shape_names() {
    return kNames;
}

std::optional<asset::Mesh> make_shape(std::string_view name, int detail) {
    if (name == "plane") return make_plane(16 * detail, false);
    if (name == "sphere") return make_sphere(128 * detail, 64 * detail, false);
    if (name == "torus") return make_torus(128 * detail, 64 * detail, 1.0f, 0.4f, false);
    if (name == "cube") return make_cube();
    if (name == "rounded_cube") return make_rounded_cube(64 * detail);
    if (name == "rock") return make_rock(128 * detail, 64 * detail);
    return std::nullopt;
}

asset::Mesh make_plane(int n, bool mirror_u) {
    n = std::max(n, 1);
    asset::Mesh mesh = named("plane");
    add_grid(mesh, n, n, 0, n, mirror_u, [](glm::dvec2 st) {
        return Point{{2.0 * st.x - 1.0, 1.0 - 2.0 * st.y, 0.0}, {0, 0, 1}, {1, 0, 0}};
    });
    return mesh;
}

asset::Mesh make_sphere(int slices, int stacks, bool mirror_u) {
    asset::Mesh mesh = named("sphere");
    add_globe(mesh, slices, stacks, mirror_u, sphere_point);
    return mesh;
}

asset::Mesh make_rock(int slices, int stacks) {
    asset::Mesh mesh = named("rock");
    add_globe(mesh, slices, stacks, false, rock_point);
    return mesh;
}

asset::Mesh make_torus(int major_segments, int minor_segments, float R, float r, bool mirror_u) {
    major_segments = std::max(major_segments, 3);
    minor_segments = std::max(minor_segments, 3);
    asset::Mesh mesh = named("torus");
    add_grid(mesh, major_segments, minor_segments, 0, minor_segments, mirror_u, [R, r](glm::dvec2 st) {
        return torus_point(st, static_cast<double>(R), static_cast<double>(r));
    });
    return mesh;
}

asset::Mesh make_cube() {
    asset::Mesh mesh = named("cube");
    for (int i = 0; i < 6; ++i) {
        const CubeFace& face = cube_face(i);
        add_grid(mesh, 1, 1, 0, 1, false, [&](glm::dvec2 st) {
            return Point{face.normal + (2.0 * st.x - 1.0) * face.right + (1.0 - 2.0 * st.y) * face.up,
                         face.normal, face.right};
        });
    }
    return mesh;
}

asset::Mesh make_rounded_cube(int n) {
    asset::Mesh mesh = named("rounded_cube");
    n = std::max(n, 2);
    for (int i = 0; i < 6; ++i) {
        const glm::dvec3 right = cube_face(i).right;
        add_grid(mesh, n, n, 0, n, false, [&](glm::dvec2 st) {
            const Foot foot = rounded_cube_point(i, st);
            return Point{foot.position, foot.normal,
                         glm::normalize(right - glm::dot(right, foot.normal) * foot.normal)};
        });
    }
    return mesh;
}

}  // namespace sg::runtime

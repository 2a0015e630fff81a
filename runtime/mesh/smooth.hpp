// The smooth surfaces that the built-in meshes stand for, in double precision: what a proof displaces.
// README.md beside this file has the formulas.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string_view>

namespace sg::runtime {

enum class SmoothShape { plane, sphere, torus, rounded_cube, rock };

// The smooth surface behind a built-in mesh; none for a name without one (the cube's edges have no normal).
std::optional<SmoothShape> smooth_shape(std::string_view name);

// A point of a surface.
struct Foot {
    glm::dvec3 position{0};      // object space
    glm::dvec3 normal{0, 0, 1};  // unit, outward
    glm::dvec2 st{0};            // uvs[0]; uvs[1] is (t, s)
    int chart = 0;               // of the rounded cube: the face, in the order of the cube's
};

// The point of the surface that belongs to a point near it: the nearest one, on the rock the one on the same
// ray from the middle. Smooth in `point`. With `near`, s and t continue those of `near` across a seam or the
// edge of a chart, so that their differences mean something.
Foot foot_of(SmoothShape shape, glm::dvec3 point, const Foot* near = nullptr);

// Of the rounded cube: radius of its edges (the cube has side 2).
inline constexpr double kEdgeRadius = 0.25;
// A face of the cubes: outward normal, and the directions of -t ("up") and +s ("right").
struct CubeFace {
    glm::dvec3 normal, right, up;
};
const CubeFace& cube_face(int face);  // 0 to 5: +X, -X, +Y, -Y, +Z, -Z
// The point of the rounded cube that the point c of the cube's surface moves to.
Foot rounded_cube_point(int face, glm::dvec2 st);

// Radius of the rock in a unit direction, and its gradient with respect to the direction's coordinates.
struct RockRadius {
    double value = 1;
    glm::dvec3 gradient{0};
};
RockRadius rock_radius(glm::dvec3 direction);

}  // namespace sg::runtime

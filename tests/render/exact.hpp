// Bumped surfaces by calculus, in double: what the tests hold rendered normals against. Shares nothing with
// the library or the meshes but the published formulas of runtime/mesh/README.md.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace sg::truth {

enum class Shape { plane, sphere, torus, cylinder };

// A surface with orthogonal parameter lines: dP/ds, dP/dt and the normal are perpendicular to each other
// everywhere. plane, sphere, torus (R = 1, r = 0.4): runtime/mesh/README.md. cylinder: the half with radius 1
// about the Y axis that faces +Z, P = (sin a, 1 - 2t, cos a), a = pi (s - 1/2); the tests' own.
struct Surface {
    Shape shape = Shape::plane;

    [[nodiscard]] glm::dvec3 position(glm::dvec2 st) const;
    [[nodiscard]] glm::dvec3 along_s(glm::dvec2 st) const;  // dP/ds, not unit
    [[nodiscard]] glm::dvec3 along_t(glm::dvec2 st) const;
    [[nodiscard]] glm::dvec3 normal(glm::dvec2 st) const;  // unit, outward
    // The (s, t) whose normal ray goes through the point: exact also for points on a facet below the surface.
    [[nodiscard]] glm::dvec2 inverse(glm::dvec3 point) const;
};

// A height over a chart with period 1 in both coordinates: a sum of amplitude * sin(2 pi (i x + j y) +
// phase), times sin^2(pi c[taper_axis]) where an axis is given, so that it dies out at a sphere's poles.
struct Wave {
    double amplitude = 0;
    int i = 0, j = 0;
    double phase = 0;
};
struct Height {
    std::vector<Wave> waves;
    int taper_axis = -1;

    [[nodiscard]] double value(glm::dvec2 c) const;
    [[nodiscard]] glm::dvec2 gradient(glm::dvec2 c) const;
};

// A uv set: uv0 is (s, t), mirrored (1 - s, t), folded (|2s - 1|, t), whose left half is mirrored and whose
// right half is not; uv1 is (t, s) whatever uv0 is.
enum class Unwrap { straight, mirrored, folded };
struct Chart {
    int uv_set = 0;
    Unwrap unwrap = Unwrap::straight;

    [[nodiscard]] glm::dvec2 from_surface(glm::dvec2 st) const;
    [[nodiscard]] glm::dvec2 to_surface(glm::dvec2 c) const;  // of a folded chart, in the right half
    [[nodiscard]] double rate(glm::dvec2 st) const;  // of the coordinate that belongs to s, against s
};

// One bump: H(s, t) = strength / k * height(tiling * chart(s, t)), with k = |tiling.x| = |tiling.y|.
struct Bump {
    Height height;
    Chart chart;
    glm::dvec2 tiling{1};
    double strength = 1;
};

// (dH/ds, dH/dt) at (s, t), by the chain rule.
glm::dvec2 height_gradient(const Bump& bump, glm::dvec2 st);

// What the bump's texture holds at c: the slope of its height along the unit directions of its own +s and +t.
glm::dvec2 texture_slope(const Surface& surface, const Bump& bump, glm::dvec2 c);

enum class Side { front, mirror, flip };  // front: seen from outside, or one-sided

// The unit normal of the surface displaced by the sum of the bumps (first order in H, as Eq 5 and Eq 7 say):
// g from g.dP/ds = dH/ds, g.dP/dt = dH/dt, g.n = 0. front: n - g; mirror: -n - g; flip: -(n - g).
//   point: in object space. world: the linear part of the placement, which must leave dP/ds and dP/dt
//   perpendicular; n stays on the outer side. TBN style keeps slopes, not heights: each derivative of H grows
//   with the length of its dP.
glm::dvec3 bumped_normal(const Surface& surface, const std::vector<Bump>& bumps, glm::dvec3 point, Side side,
                         const glm::dmat3& world = glm::dmat3(1));

// Degrees between two vectors; 180 where one is not finite or zero.
double angle_degrees(glm::dvec3 a, glm::dvec3 b);

}  // namespace sg::truth

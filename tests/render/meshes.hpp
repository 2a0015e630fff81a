// The meshes of the analytic cases, and how fine they are.
#pragma once

#include "asset/mesh.hpp"
#include "tests/render/exact.hpp"

namespace sg::truth {

// Angles that one quad spans along s and t, radians; 0 on flat directions. edge: its shorter side, world
// units.
struct Tessellation {
    double da = 0, db = 0, edge = 0;
};
Tessellation tessellation_of(Shape shape);

// A folded unwrap (plane alone) has no tangents.
const asset::Mesh& mesh_of(Shape shape, Unwrap unwrap);

}  // namespace sg::truth

// From a surface gradient to a normal.
#pragma once

#include "ir/reference/checked.hpp"

namespace sg::ref {

dvec3 resolve(dvec3 n, dvec3 g);
// The parts one after another: derivative, gradient, resolve.
dvec3 resolve_vertex_map(dvec3 vertex_normal, dvec4 vertex_tangent, double facing, dvec3 m, dvec2 strength);
dvec3 resolve_volume(dvec3 n, dvec3 gradient);
dvec3 resolve_towards(dvec3 n, dvec3 wanted, double part);
dvec3 flip(dvec3 resolved, double facing);
dvec3 invert(dvec3 n, dvec3 resolved);

}  // namespace sg::ref

// Tangent frames and the surface gradients that they give.
#pragma once

#include "ir/reference/frame.hpp"
#include "ir/reference/uv.hpp"

namespace sg::ref {

struct Basis {
    dvec3 tangent{0.0}, bitangent{0.0};
};

Basis basis_vertex(dvec3 vertex_normal, dvec4 vertex_tangent);
// Zero vectors where the coordinates or the footprint have no area.
Basis basis_uv(const Frame& frame, const Uv& uv);
Basis basis_resolved(const Basis& basis, dvec3 n);
Basis basis_mirror(const Basis& basis, dvec2 scale);
dvec3 surfgrad_from_tbn(dvec2 d, const Basis& basis);

// How the surface moves per unit of s and of t: the tangents themselves, neither unit nor perpendicular.
struct Tangents {
    dvec3 per_s{0.0}, per_t{0.0};
};
Tangents tangents_of(const Frame& frame, const Uv& uv);

}  // namespace sg::ref

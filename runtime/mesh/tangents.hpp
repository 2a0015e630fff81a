// Vertex tangents from a uv set, by Lengyel, Foundations of Game Engine Development 2, section 7.5,
// Listing 7.4.
#pragma once

#include "asset/mesh.hpp"

namespace sg::runtime {

// Replaces mesh.tangents: the sum of dP/ds over a vertex' triangles, made perpendicular to the normal, unit;
// w such that w * cross(N, T) points to +t. Where triangles of both handednesses share a vertex (the seam of
// a mirrored chart), the vertex is split: the left-handed triangles move to a copy at the end of the mesh, so
// nothing averages to zero. Triangles whose uvs have no area are skipped; a vertex without any other gets
// some perpendicular with w = 1. False, and nothing changed, if the mesh has no normals or not that uv set (0
// to 7).
bool make_tangents(asset::Mesh& mesh, int uv_set = 0);

}  // namespace sg::runtime

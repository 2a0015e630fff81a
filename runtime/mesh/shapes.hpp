// The meshes that are built in: exact normals, exact tangents, three uv sets, colours. README.md beside this
// file has the formulas.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "asset/mesh.hpp"

namespace sg::runtime {

// "plane", "sphere", "torus", "cube", "rounded_cube" or "rock" at its default tessellation, `detail` times
// as fine along both directions; nothing for another name.
std::optional<asset::Mesh> make_shape(std::string_view name, int detail = 1);
std::span<const std::string_view> shape_names();

// Every maker fills normals, tangents, colours, uvs[0] = (s, t), uvs[1] = (t, s), a chart turned by 90
// degrees and mirrored, and uvs[2] = (s + t, t - s), one turned by 45. The tangents belong to uvs[0].
// `mirror_u` replaces uvs[0] by (1 - s, t), with tangent and w to match. Lengths are in object units; counts
// below 1 (plane), 3 (around) or 2 (stacks) are raised to that.

// n x n quads on the square of side 2 in XY, facing +Z.
asset::Mesh make_plane(int n, bool mirror_u);
// Radius 1 around the origin.
asset::Mesh make_sphere(int slices, int stacks, bool mirror_u);
// A tube of radius r around the circle of radius R about the Y axis.
asset::Mesh make_torus(int major_segments, int minor_segments, float R, float r, bool mirror_u);
// Side 2, four vertices per face, each face with the whole picture upright and unmirrored.
asset::Mesh make_cube();
// The cube with edges of radius 0.25; n x n quads per face.
asset::Mesh make_rounded_cube(int n);
// A lumpy ball, about 1 in radius.
asset::Mesh make_rock(int slices, int stacks);

}  // namespace sg::runtime

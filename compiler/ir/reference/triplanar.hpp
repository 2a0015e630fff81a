// Three images projected along the axes, in double precision: each plane's coordinate is a linear map of the
// position, its gradient the transpose of that map.
#pragma once

#include "ir/reference/uv.hpp"

namespace sg::ref {

enum class Hand { right, left };
enum class Origin { upper_left, lower_left };

struct TriplanarUv {
    Uv x, y, z;
};

// k >= 0. A zero or not-a-number normal counts as (0, 0, 1).
dvec3 triplanar_weights(dvec3 n, double k);
TriplanarUv triplanar_uv(dvec3 p, dvec3 dpdx, dvec3 dpdy, Hand hand, Origin origin);
dvec3 triplanar_gradient(dvec3 weights, dvec2 d_x, dvec2 d_y, dvec2 d_z, Hand hand, Origin origin);
// One plane alone; axis: 0, 1, 2.
Uv planar_uv(dvec3 p, dvec3 dpdx, dvec3 dpdy, int axis, Hand hand, Origin origin);
dvec3 planar_gradient(dvec2 d, int axis, Hand hand, Origin origin);

}  // namespace sg::ref

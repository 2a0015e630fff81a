// The surface under a pixel, in double precision.
#pragma once

#include "ir/reference/checked.hpp"

namespace sg::ref {

struct Frame {
    dvec3 position, normal, dpdx, dpdy, sigma_x, sigma_y;
    double flip_sign = 1.0;
};

dvec3 reject(dvec3 v, dvec3 n);
Frame frame(dvec3 position, dvec3 dpdx, dvec3 dpdy, dvec3 n);
// Zero where the footprint has no area.
double frame_inverse_area(const Frame& frame);
Frame frame_resolved(const Frame& frame, dvec3 n);
dvec3 base_normal(dvec3 vertex_normal);
dvec3 mirror_normal(dvec3 n, double facing);

}  // namespace sg::ref

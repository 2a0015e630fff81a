// Decal projectors in double precision: coordinates, their gradients, falloffs and how decals add up.
#pragma once

#include "ir/reference/uv.hpp"

namespace sg::ref {

struct Decal {
    dvec3 local{0.0};
    Uv uv{};
    dvec3 grad_s{0.0}, grad_t{0.0};  // of uv.st, in the space of the position
};

// projector: affine, to projector space.
Decal decal_box(const dmat4& projector, dvec3 position, dvec3 dpdx, dvec3 dpdy);
Decal decal_cone(const dmat4& projector, dvec3 position, dvec3 dpdx, dvec3 dpdy);
Decal decal_sphere(const dmat4& projector, dvec3 position, dvec3 dpdx, dvec3 dpdy);

// 1 in the middle of the shape, smoothly 0 over the outer `edge` of it.
double decal_fade(double reach, double edge);
double decal_falloff_box(dvec3 local, double edge);
double decal_falloff_cone(dvec3 local, double edge);
double decal_falloff_sphere(dvec3 local, double edge);
double decal_falloff_capsule(dvec3 local, double half_length, double edge);
double decal_falloff_wedge(dvec3 local, double edge);
double decal_angle_fade(dvec3 n, dvec3 towards, double cos_full, double cos_none);

dvec3 decal_gradient_scaled(dvec2 d, const Decal& decal, dvec2 dim, double height);
dvec3 decal_gradient(dvec2 d, const Decal& decal);
dvec3 decal_gradient_along(dvec2 d, dvec3 axis_s, dvec3 axis_t);
// v over the larger of its length and 1e-15: zero stays zero.
dvec3 unit_or_shorter(dvec3 v);
dvec3 decal_add(dvec3 sum, dvec3 gradient, double alpha);
dvec3 decal_mask(dvec3 sum, dvec3 gradient, double alpha);

}  // namespace sg::ref

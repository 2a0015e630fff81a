// What the method replaces, in double precision.
#pragma once

#include "ir/reference/frame.hpp"
#include "ir/reference/triplanar.hpp"

namespace sg::ref {

dvec3 legacy_perlin_normal(dvec3 n, dvec3 gradient);
dvec3 legacy_triplanar_normal(dvec3 n, dvec3 weights, dvec3 m_x, dvec3 m_y, dvec3 m_z, Hand hand,
                              Origin origin);
dvec3 legacy_decal_normal(dvec3 n, dvec3 axis_s, dvec3 axis_t, dvec3 towards, dvec2 d, double alpha);
dmat3 legacy_tbn(dvec3 normal, dvec4 tangent);

struct TangentVectors {
    dvec3 view, light;
};
TangentVectors legacy_tangent_vectors(dvec3 position, dvec3 normal, dvec4 tangent, dvec3 camera, dvec3 light);
dvec3 legacy_object_normal(dvec3 m, dvec3 normal, dvec4 tangent);

struct Phong {
    double diffuse = 0.0, specular = 0.0;
};
Phong legacy_phong(dvec3 m, dvec3 light, dvec3 view, double exponent);

}  // namespace sg::ref

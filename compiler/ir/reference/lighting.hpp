// The lighting models in double precision.
#pragma once

#include "ir/reference/frame.hpp"

namespace sg::ref {

struct Lights {
    dvec3 view, light, radiance, ambient;
};

struct GgxSurface {
    dvec3 base_color;
    double metallic = 0.0, roughness = 0.5, occlusion = 1.0;
    dvec3 emission;
};
double sin2_between(dvec3 a, dvec3 b);  // unit vectors; 1 from 90 degrees on
double ggx_distribution(double sin2_h, double alpha);
double ggx_visibility(double cos_l, double cos_v, double alpha);
dvec3 fresnel(dvec3 f0, double cos_d);
dvec3 ggx(const GgxSurface& surface, dvec3 n, dvec3 view, dvec3 light, dvec3 radiance);
dvec3 ggx_radiance(const GgxSurface& surface, dvec3 n, const Lights& lights);

struct PhongSurface {
    dvec3 base_color, specular;
    double shininess = 8.0, occlusion = 1.0;
    dvec3 emission;
};
dvec3 phong_radiance(const PhongSurface& surface, dvec3 n, const Lights& lights);

}  // namespace sg::ref

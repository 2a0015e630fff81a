// Parallax in double precision: where on a displaced surface the eye looks.
#pragma once

#include <functional>

#include "ir/reference/frame.hpp"
#include "ir/reference/texture.hpp"
#include "ir/reference/uv.hpp"

namespace sg::ref {

struct Parallax {
    dvec2 offset{0.0};
    double height = 0.0;
};

dvec3 parallax_direction(const Frame& frame, const Uv& uv, dvec3 direction);
dvec2 parallax_offset(dvec3 view, double height);
dvec2 parallax_scale(double scale, int steps, dvec2 dim);
dvec2 parallax_steps(const TextureSource& map, const Sampler& sampler, dvec2 decode, const Uv& uv,
                     dvec2 stride, int steps);
double parallax_height(const TextureSource& map, const Sampler& sampler, dvec2 heights, dvec2 st,
                       double level);
// What the march saw, and how firm it is: the hit; the smallest distance between ray and surface at a step,
// on whose sign hangs which step ends the march; how much an error of a distance moves the height of the hit.
struct March {
    Parallax hit;
    double closest = 0.0;
    double amplification = 1.0;
};
March parallax_march(const TextureSource& map, const Sampler& sampler, dvec2 heights, dvec2 st, dvec3 view,
                     double level, int steps);
// The same over anything that gives texels: 0 to 1 at a coordinate.
March parallax_march(const std::function<double(dvec2)>& texel, dvec2 heights, dvec2 st, dvec3 view,
                     int steps);
dvec2 parallax_pixels(const Uv& uv, dvec2 offset);
dvec3 parallax_position(const Frame& frame, dvec2 pixels, double height);
dvec3 parallax_normal(dvec3 n, dvec3 dndx, dvec3 dndy, dvec2 pixels);
Uv parallax_uv(const Uv& uv, dvec2 offset);
Uv parallax_detail_uv(const Frame& frame, const Uv& uv, dvec2 pixels, dvec3 dpdx, dvec3 dpdy);

}  // namespace sg::ref

// Texture coordinates with their screen derivatives.
#pragma once

#include "ir/reference/checked.hpp"

namespace sg::ref {

struct Uv {
    dvec2 st, dx, dy;
};

Uv uv_scale(const Uv& uv, dvec2 scale);
Uv uv_transform(const Uv& uv, dvec2 scale, double rotation, dvec2 offset);
// Coordinates that span no area: there is no way back from st to the screen.
bool is_degenerate(const Uv& uv);
double uv_level(const Uv& uv, dvec2 dim);

}  // namespace sg::ref

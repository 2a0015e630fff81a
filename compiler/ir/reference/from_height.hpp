// Scale-dependent surface gradients from heights.
#pragma once

#include "ir/reference/frame.hpp"
#include "ir/reference/texture.hpp"
#include "ir/reference/uv.hpp"

namespace sg::ref {

dvec3 surfgrad_from_screen_height(const Frame& frame, dvec2 dh);
dvec2 screen_height_from_deriv(const Uv& uv, dvec2 dim, dvec2 d);
dvec3 surfgrad_from_height(const Frame& frame, const Uv& uv, dvec2 dim, dvec2 d);
dvec2 screen_height_three_tap(const TextureSource& height, const Sampler& sampler, const Uv& uv);

}  // namespace sg::ref

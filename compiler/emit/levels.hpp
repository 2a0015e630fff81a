// Which texture reads may leave the level of detail to the hardware.
#pragma once

#include <vector>

#include "ir/ir.hpp"

namespace sg::emit {

// By value: a coordinate whose derivatives are what the hardware finds itself from the neighbouring pixels,
// for it is a linear function, the same for every pixel, of one that the vertex stage hands over. False for
// all where a ray was followed: behind parallax no derivative may be taken.
std::vector<bool> follows_the_pixels(const ir::Module& module);

}  // namespace sg::emit

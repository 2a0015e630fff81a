// Screen derivatives of a position on a plane: how the point where a pixel's ray meets the plane moves.
#pragma once

#include "ir/reference/frame.hpp"

namespace sg::ref {

struct ScreenDerivatives {
    dvec3 dpdx, dpdy;
};

// Towards the viewer: n, or its mirror image if it faces away.
dvec3 facing_normal(dvec3 n, dvec3 view);
// Of the plane with the normal n through `position`; relative_from_screen: (x px, y px, depth, 1) to relative
// space.
ScreenDerivatives analytic_derivatives(dvec3 position, dvec3 n, const dmat4& relative_from_screen);
Frame frame_rebuilt(dvec3 position, dvec3 n, double facing, dvec3 view, const dmat4& relative_from_screen);

}  // namespace sg::ref

// From a surface gradient to a normal.
#pragma once

#include "ir/reference/checked.hpp"

namespace sg::ref {

dvec3 resolve(dvec3 n, dvec3 g);
dvec3 flip(dvec3 resolved, double facing);
dvec3 invert(dvec3 n, dvec3 resolved);

}  // namespace sg::ref

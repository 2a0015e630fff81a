#include "ir/reference/resolve.hpp"

namespace sg::ref {

dvec3 resolve(dvec3 n, dvec3 g) {
    const dvec3 bumped = n - g;
    const double length = std::hypot(bumped.x, bumped.y, bumped.z);
    return length > 1e-15 && std::isfinite(length) ? normalized(bumped) : n;
}

dvec3 flip(dvec3 resolved, double facing) {
    return facing < 0.0 ? -resolved : resolved;
}

// Half a turn about n: the part along n stays, the part across changes its sign.
dvec3 invert(dvec3 n, dvec3 resolved) {
    const dvec3 along = n * glm::dot(n, resolved);
    const dvec3 across = resolved - along;
    return along - across;
}

}  // namespace sg::ref

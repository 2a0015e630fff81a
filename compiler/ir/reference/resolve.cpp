#include "ir/reference/resolve.hpp"

#include "ir/reference/deriv.hpp"
#include "ir/reference/from_normal.hpp"
#include "ir/reference/from_volume.hpp"
#include "ir/reference/tbn.hpp"

namespace sg::ref {

dvec3 resolve(dvec3 n, dvec3 g) {
    const dvec3 bumped = n - g;
    const double length = std::hypot(bumped.x, bumped.y, bumped.z);
    return length > 1e-15 && std::isfinite(length) ? normalized(bumped) : n;
}

dvec3 resolve_vertex_map(dvec3 vertex_normal, dvec4 vertex_tangent, double facing, dvec3 m, dvec2 strength) {
    const dvec2 d = strength * deriv_from_normal_xyz(m);
    const dvec3 n = mirror_normal(base_normal(vertex_normal), facing);
    return resolve(n, surfgrad_from_tbn(d, basis_vertex(vertex_normal, vertex_tangent)));
}

dvec3 resolve_volume(dvec3 n, dvec3 gradient) {
    return resolve(n, surfgrad_from_volume(n, gradient));
}

dvec3 resolve_towards(dvec3 n, dvec3 wanted, double part) {
    return resolve(n, part * surfgrad_from_normal(n, wanted));
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

#include "ir/reference/tbn.hpp"

namespace sg::ref {

Basis basis_vertex(dvec3 vertex_normal, dvec4 vertex_tangent) {
    const double length = std::hypot(vertex_normal.x, vertex_normal.y, vertex_normal.z);
    if (!(length > 1e-15 && length < 1e15)) return {};
    const dvec3 tangent(vertex_tangent);
    const dvec3 across =
        vertex_tangent.w < 0.0 ? glm::cross(tangent, vertex_normal) : glm::cross(vertex_normal, tangent);
    return {tangent / length, across / length};
}

// dP/d(x,y) = dP/d(s,t) d(s,t)/d(x,y), solved for dP/d(s,t).
Tangents tangents_of(const Frame& frame, const Uv& uv) {
    const glm::dmat2 screen_from_st = glm::inverse(glm::dmat2(uv.dx, uv.dy));
    return {frame.sigma_x * screen_from_st[0].x + frame.sigma_y * screen_from_st[0].y,
            frame.sigma_x * screen_from_st[1].x + frame.sigma_y * screen_from_st[1].y};
}

Basis basis_uv(const Frame& frame, const Uv& uv) {
    const double area = std::abs(glm::determinant(glm::dmat2(uv.dx, uv.dy)));
    if (is_degenerate(uv)) return {};
    const Tangents raw = tangents_of(frame, uv);
    if (!(glm::length(raw.per_s) * area > 1e-18)) return {};
    // What the step along s loses to the projection must leave a direction.
    const dvec2 column = glm::inverse(glm::dmat2(uv.dx, uv.dy))[0];
    const dvec3 step = frame.dpdx * column.x + frame.dpdy * column.y;
    if (!(glm::length(raw.per_s) > 1e-3 * std::abs(glm::dot(step, frame.normal)))) return {};
    const dvec3 tangent = normalized(raw.per_s);
    // Of the two directions across, the one on the side of growing t.
    const dvec3 across = glm::cross(frame.normal, tangent);
    return {tangent, glm::dot(across, raw.per_t) < 0.0 ? -across : across};
}

Basis basis_resolved(const Basis& basis, dvec3 n) {
    const dvec3 across = glm::cross(n, basis.tangent);  // as long as the part of T that survives
    if (!(glm::length(across) > 1e-3 * glm::length(basis.tangent)) || !(glm::length(across) > 1e-15))
        return {};
    const dvec3 unit_across = normalized(across);
    return {glm::cross(unit_across, n),
            glm::dot(unit_across, basis.bitangent) < 0.0 ? -unit_across : unit_across};
}

Basis basis_mirror(const Basis& basis, dvec2 scale) {
    return {scale.x < 0.0 ? -basis.tangent : basis.tangent,
            scale.y < 0.0 ? -basis.bitangent : basis.bitangent};
}

dvec3 surfgrad_from_tbn(dvec2 d, const Basis& basis) {
    return glm::dmat2x3(basis.tangent, basis.bitangent) * d;
}

}  // namespace sg::ref

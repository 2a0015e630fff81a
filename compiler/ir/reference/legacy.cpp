#include "ir/reference/legacy.hpp"

#include <algorithm>

namespace sg::ref {
namespace {

dvec3 unit_or(dvec3 v, dvec3 otherwise) {
    const double square = glm::dot(v, v);
    return square > 1e-30 && square < 1e30 ? normalized(v) : otherwise;
}

}  // namespace

dvec3 legacy_perlin_normal(dvec3 n, dvec3 gradient) {
    return unit_or(n - gradient, n);
}

// The leans of the three maps, laid along the planes' axes in space and added to the normal.
dvec3 legacy_triplanar_normal(dvec3 n, dvec3 weights, dvec3 m_x, dvec3 m_y, dvec3 m_z, Hand hand,
                              Origin origin) {
    const dvec3 lean = weights.x * planar_gradient(dvec2(m_x), 0, hand, origin) +
                       weights.y * planar_gradient(dvec2(m_y), 1, hand, origin) +
                       weights.z * planar_gradient(dvec2(m_z), 2, hand, origin);
    return unit_or(n + lean, n);
}

dvec3 legacy_decal_normal(dvec3 n, dvec3 axis_s, dvec3 axis_t, dvec3 towards, dvec2 d, double alpha) {
    const dvec3 projected = unit_or(towards - d.x * axis_s - d.y * axis_t, towards);
    return unit_or((1.0 - alpha) * n + alpha * projected, n);
}

dmat3 legacy_tbn(dvec3 normal, dvec4 tangent) {
    const dvec3 n = unit_or(normal, {0.0, 0.0, 1.0});
    const dvec3 given(tangent), along = given - n * glm::dot(n, given);
    const bool usable = glm::length(along) > 1e-6 * glm::length(given);
    const dvec3 t = usable ? normalized(along) : dvec3(0.0);
    return {t, glm::cross(n, t) * (tangent.w < 0.0 ? -1.0 : 1.0), n};
}

TangentVectors legacy_tangent_vectors(dvec3 position, dvec3 normal, dvec4 tangent, dvec3 camera,
                                      dvec3 light) {
    const dvec3 t(tangent), b = glm::cross(normal, t) * tangent.w;
    auto seen = [&](dvec3 v) { return dvec3(glm::dot(t, v), glm::dot(b, v), glm::dot(normal, v)); };
    return {seen(camera - position), seen(light - position)};
}

dvec3 legacy_object_normal(dvec3 m, dvec3 normal, dvec4 tangent) {
    const dmat3 frame = legacy_tbn(normal, tangent);
    return unit_or(frame[0] * m.x + frame[1] * m.y + frame[2] * m.z, frame[2]);
}

Phong legacy_phong(dvec3 m, dvec3 light, dvec3 view, double exponent) {
    const double facing = glm::dot(m, light);
    const double mirrored = glm::dot(-glm::reflect(light, m), view);
    return {std::clamp(facing, 0.0, 1.0), mirrored > 0.0 ? std::min(power(mirrored, exponent), 1.0) : 0.0};
}

}  // namespace sg::ref

#include "ir/reference/decal.hpp"

#include <algorithm>
#include <array>

namespace sg::ref {
namespace {

dvec3 local_of(const dmat4& projector, dvec3 position) {
    return dvec3(projector * dvec4(position, 1.0));
}

// The gradient of dot(axis, local) with respect to the position.
dvec3 gradient_along(const dmat4& projector, dvec3 axis) {
    return glm::transpose(dmat3(projector)) * axis;
}

Decal with_gradients(dvec3 local, dvec2 st, dvec3 grad_s, dvec3 grad_t, dvec3 dpdx, dvec3 dpdy) {
    auto change = [&](dvec3 step) { return dvec2(glm::dot(grad_s, step), glm::dot(grad_t, step)); };
    return {local, {st, change(dpdx), change(dpdy)}, grad_s, grad_t};
}

// A cube's face as Vulkan's table has it: the directions of s, of t (downward) and of the face.
struct Face {
    dvec3 s, t, ahead;
};

// (1 + s / ahead) / 2 and the same for t, by the quotient rule; nothing where the face is not ahead.
Decal central(const dmat4& projector, dvec3 local, const Face& face, dvec3 dpdx, dvec3 dpdy) {
    const double ahead = glm::dot(face.ahead, local);
    if (!(ahead > 1e-6)) return {local, {dvec2(0.5), dvec2(0.0), dvec2(0.0)}, dvec3(0.0), dvec3(0.0)};
    const dvec3 grad_ahead = gradient_along(projector, face.ahead);
    auto quotient = [&](dvec3 axis) { return glm::dot(axis, local) / ahead; };
    auto gradient = [&](dvec3 axis) {
        return (gradient_along(projector, axis) * ahead - glm::dot(axis, local) * grad_ahead) /
               (2.0 * ahead * ahead);
    };
    const dvec2 st = 0.5 + 0.5 * dvec2(quotient(face.s), quotient(face.t));
    return with_gradients(local, st, gradient(face.s), gradient(face.t), dpdx, dpdy);
}

Face face_of(dvec3 direction) {
    static const std::array<Face, 6> faces = {{{{0, 0, -1}, {0, -1, 0}, {1, 0, 0}},
                                               {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}},
                                               {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                               {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                               {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
                                               {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}};
    // The last of equals: z before y before x.
    return *std::max_element(faces.begin(), faces.end(), [&](const Face& a, const Face& b) {
        return glm::dot(a.ahead, direction) <= glm::dot(b.ahead, direction);
    });
}

double largest(dvec3 v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

Decal decal_box(const dmat4& projector, dvec3 position, dvec3 dpdx, dvec3 dpdy) {
    const dvec3 local = local_of(projector, position);
    return with_gradients(local, (dvec2(local) + 1.0) / 2.0, gradient_along(projector, {1, 0, 0}) / 2.0,
                          gradient_along(projector, {0, 1, 0}) / 2.0, dpdx, dpdy);
}

Decal decal_cone(const dmat4& projector, dvec3 position, dvec3 dpdx, dvec3 dpdy) {
    return central(projector, local_of(projector, position), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, dpdx, dpdy);
}

Decal decal_sphere(const dmat4& projector, dvec3 position, dvec3 dpdx, dvec3 dpdy) {
    const dvec3 local = local_of(projector, position);
    return central(projector, local, face_of(local), dpdx, dpdy);
}

double decal_fade(double reach, double edge) {
    if (!(reach < 1.0)) return 0.0;
    const double t = edge > 1e-6 ? std::min((1.0 - reach) / edge, 1.0) : std::min((1.0 - reach) / 1e-6, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double decal_falloff_box(dvec3 local, double edge) {
    return decal_fade(largest(local), edge);
}

double decal_falloff_cone(dvec3 local, double edge) {
    if (!(local.z > 1e-6)) return 0.0;
    return decal_fade(std::max(std::hypot(local.x, local.y) / local.z, local.z), edge);
}

double decal_falloff_sphere(dvec3 local, double edge) {
    return decal_fade(std::hypot(local.x, local.y, local.z), edge);
}

// The distance to the nearest point of the axis.
double decal_falloff_capsule(dvec3 local, double half_length, double edge) {
    const dvec3 nearest(0.0, 0.0, std::clamp(local.z, -half_length, half_length));
    return decal_fade(glm::distance(local, nearest), edge);
}

double decal_falloff_wedge(dvec3 local, double edge) {
    if (!(local.z > 1e-6)) return 0.0;
    return decal_fade(largest({local.x / local.z, local.y, local.z}), edge);
}

double decal_angle_fade(dvec3 n, dvec3 towards, double cos_full, double cos_none) {
    const double facing = glm::dot(n, towards);
    if (!(facing > cos_none)) return 0.0;
    return std::min((facing - cos_none) / std::max(cos_full - cos_none, 1e-6), 1.0);
}

dvec3 decal_gradient_scaled(dvec2 d, const Decal& decal, dvec2 dim, double height) {
    return height * (d.x * dim.x * decal.grad_s + d.y * dim.y * decal.grad_t);
}

dvec3 decal_gradient(dvec2 d, const Decal& decal) {
    auto unit = [](dvec3 v) { return glm::dot(v, v) > 1e-30 ? normalized(v) : dvec3(0.0); };
    return d.x * unit(decal.grad_s) + d.y * unit(decal.grad_t);
}

dvec3 decal_gradient_along(dvec2 d, dvec3 axis_s, dvec3 axis_t) {
    return d.x * axis_s + d.y * axis_t;
}

dvec3 unit_or_shorter(dvec3 v) {
    return v / std::max(std::hypot(v.x, v.y, v.z), 1e-15);
}

dvec3 decal_add(dvec3 sum, dvec3 gradient, double alpha) {
    return alpha > 0.0 ? sum + alpha * gradient : sum;
}

dvec3 decal_mask(dvec3 sum, dvec3 gradient, double alpha) {
    if (!(alpha > 0.0)) return sum;
    return alpha < 1.0 ? sum + alpha * (gradient - sum) : gradient;
}

}  // namespace sg::ref

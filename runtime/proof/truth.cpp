#include "runtime/proof/truth.hpp"

#include <algorithm>
#include <cmath>

namespace sg::proof {
namespace {

using glm::dmat2;
using glm::dmat3;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using runtime::Foot;

constexpr double kStep = 1.5e-5;  // of the object's unit length

dvec3 linear(const glm::dmat4& m, dvec3 v) {
    return dmat3(m) * v;
}
dvec3 affine(const glm::dmat4& m, dvec3 p) {
    return dvec3(m * dvec4(p, 1));
}

// Where the pixel's line of sight meets the plane through `point`.
dvec3 on_plane(const glm::dmat4& relative_from_screen, dvec2 pixel, dvec3 point, dvec3 normal) {
    const dvec4 near4 = relative_from_screen * dvec4(pixel, 0, 1);
    const dvec4 far4 = relative_from_screen * dvec4(pixel, 1, 1);
    const dvec3 from = dvec3(near4) / near4.w, along = dvec3(far4) / far4.w - from;
    return from + along * (glm::dot(point - from, normal) / glm::dot(along, normal));
}

// The largest |dn| / |dp| of all directions, from changes of points and normals along two: the square root of
// the larger eigenvalue of the one's squares by the other's.
double largest_curvature(dvec3 px, dvec3 py, dvec3 nx, dvec3 ny) {
    auto squares = [](dvec3 a, dvec3 b) {
        return dmat2(glm::dot(a, a), glm::dot(a, b), glm::dot(a, b), glm::dot(b, b));
    };
    const dmat2 m = glm::inverse(squares(px, py)) * squares(nx, ny);
    const double half = (m[0][0] + m[1][1]) / 2;
    return std::sqrt(std::max(half + std::sqrt(std::max(half * half - glm::determinant(m), 0.0)), 0.0));
}

double sine_between(dvec3 a, dvec3 b) {
    return glm::length(glm::cross(a, b));  // of unit vectors
}
double arcsine(double sine) {
    return sine < 1 ? std::asin(sine) * 57.29577951308232 : 180;
}

}  // namespace

// The pixel's point with its tangent plane and everything that all points of the square share.
struct Truth::Square {
    Foot middle;
    dvec3 right{0}, up{0};  // unit, object space, across the normal
    double facing = 1;
    dvec3 dpdx{0}, dpdy{0};  // world
    dvec3 sight{0};          // from the camera, unit
    dvec3 object_dx{0}, object_dy{0};
    dvec2 st_dx{0}, st_dy{0};
};

Truth::Truth(const ir::Module& module, const ir::Bindings& bindings, std::map<std::string, Partner> partners,
             const Sight& sight)
    : partners_(std::move(partners)),
      source_(relief_source(module)),
      module_(source_ ? without_relief(module) : module),
      heights_(module_, bindings, partners_),
      evaluator_(module_, bindings),
      sight_(sight),
      normal_from_object_(glm::transpose(glm::inverse(dmat3(sight.world_from_object)))),
      object_from_world_(glm::inverse(sight.world_from_object)) {
    if (source_) relief_.emplace(module_, *source_, bindings, partners_, sight);
    ir::ValueId at = module_.output(ir::Output::normal);
    while (at.valid()) {
        const ir::Value& value = module_.at(at);
        if (value.op == ir::Op::flip) flips_ = true;
        if (value.op == ir::Op::mirror_normal) mirrors_ = true;
        if (value.op == ir::Op::resolve) stages_.push_back(value.operands[1]);
        const bool chained =
            value.op == ir::Op::flip || value.op == ir::Op::mirror_normal || value.op == ir::Op::resolve;
        at = chained ? value.operands[0] : ir::ValueId{};
    }
    std::reverse(stages_.begin(), stages_.end());
}

std::optional<NoHeight> Truth::missing() const {
    std::optional<NoHeight> found = relief_ ? relief_->missing() : std::nullopt;
    for (ir::ValueId stage : stages_) {
        if (!found) found = heights_.missing(stage);
    }
    if (found && source_) found->value.index -= kFlatShift;
    return found;
}

Truth::Square Truth::square_at(dvec3 point, dvec2 pixel, dvec3 sight) const {
    Square out;
    out.middle = foot_of(sight_.shape, affine(object_from_world_, point + sight_.camera));
    const dvec3 n = out.middle.normal;
    out.right = glm::normalize(glm::cross(n, std::abs(n.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
    out.up = glm::cross(n, out.right);
    const dvec3 world_n = glm::normalize(normal_from_object_ * n);
    out.sight = glm::normalize(sight);
    out.facing = glm::dot(sight, world_n) > 0 ? -1 : 1;
    const dvec3 foot = affine(sight_.world_from_object, out.middle.position) - sight_.camera;
    auto seen = [&](double x, double y) {
        return on_plane(sight_.relative_from_screen, pixel + dvec2(x, y), foot, world_n);
    };
    out.dpdx = seen(0.5, 0) - seen(-0.5, 0);
    out.dpdy = seen(0, 0.5) - seen(0, -0.5);
    out.object_dx = linear(object_from_world_, out.dpdx);
    out.object_dy = linear(object_from_world_, out.dpdy);
    auto st_along = [&](dvec3 direction) {
        const dvec3 step = kStep * direction;
        return (foot_of(sight_.shape, out.middle.position + step, &out.middle).st -
                foot_of(sight_.shape, out.middle.position - step, &out.middle).st) /
               (2 * kStep);
    };
    const dvec2 by_right = st_along(out.right), by_up = st_along(out.up);
    auto st_change = [&](dvec3 d) { return glm::dot(d, out.right) * by_right + glm::dot(d, out.up) * by_up; };
    out.st_dx = st_change(out.object_dx);
    out.st_dy = st_change(out.object_dy);
    return out;
}

// The tangent towards +s, by the inverse of the change of (s, t) along two directions of the plane.
static dvec4 tangent_at(runtime::SmoothShape shape, const Foot& foot) {
    const dvec3 n = foot.normal;
    const dvec3 right = glm::normalize(glm::cross(n, std::abs(n.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
    const dvec3 up = glm::cross(n, right);
    auto change = [&](dvec3 d) {
        return (foot_of(shape, foot.position + kStep * d, &foot).st -
                foot_of(shape, foot.position - kStep * d, &foot).st) /
               (2 * kStep);
    };
    const dmat2 plane_from_st = glm::inverse(dmat2(change(right), change(up)));
    const dvec3 s = plane_from_st[0].x * right + plane_from_st[0].y * up;
    const dvec3 t = plane_from_st[1].x * right + plane_from_st[1].y * up;
    return {glm::normalize(s), glm::dot(glm::cross(n, s), t) < 0 ? -1.0 : 1.0};
}

ir::PixelInputs Truth::inputs_at(const Square& square, const Foot& foot) const {
    ir::PixelInputs out;
    const dvec3 world = affine(sight_.world_from_object, foot.position);
    out.position = world - sight_.camera;
    out.vertex_normal = glm::normalize(normal_from_object_ * foot.normal);
    const dvec4 tangent = tangent_at(sight_.shape, foot);
    const double mirrored = glm::determinant(dmat3(sight_.world_from_object)) < 0 ? -1 : 1;
    out.vertex_tangent =
        dvec4(glm::normalize(linear(sight_.world_from_object, dvec3(tangent))), mirrored * tangent.w);
    out.uvs[0] = {foot.st, square.st_dx, square.st_dy};
    auto swapped = [](dvec2 v) { return dvec2(v.y, v.x); };
    out.uvs[1] = {swapped(foot.st), swapped(square.st_dx), swapped(square.st_dy)};
    out.dpdx = square.dpdx;
    out.dpdy = square.dpdy;
    out.facing = square.facing;
    out.object = {foot.position, square.object_dx, square.object_dy};
    out.world = {world, square.dpdx, square.dpdy};
    out.time = sight_.time;
    out.world_from_object = dmat3(sight_.world_from_object);
    out.normal_from_object = normal_from_object_;
    out.object_origin = affine(sight_.world_from_object, dvec3(0)) - sight_.camera;
    // The line of sight of this pixel, whatever the projection.
    out.camera = {false, sight_.camera, square.sight, sight_.relative_from_screen};
    return out;
}

ir::PixelInputs Truth::lifted_inputs(const Square& square, const Foot& foot) const {
    ir::PixelInputs out = inputs_at(square, foot);
    if (!relief_) return out;
    const dvec3 n = (mirrors_ ? square.facing : 1.0) * out.vertex_normal;
    out.position += relief_->height(foot) * n;
    out.world.p = out.position + sight_.camera;
    out.object.p = affine(object_from_world_, out.world.p);
    return out;
}

bool Truth::look(Square& square, dvec3 point, dvec2 pixel, dvec3 sight) {
    if (!relief_) return true;
    if (square.facing < 0 && !mirrors_) return false;  // the inner side of the relief
    relief_->focus(square.st_dx, square.st_dy, square.facing);
    if (!relief_->placed()) {
        auto values = [&](dvec2 st) {
            Foot foot = square.middle;
            foot.st = st;
            return evaluator_.run(inputs_at(square, foot));
        };
        const auto origin = values({0, 0}), along_s = values({1, 0}), along_t = values({0, 1});
        relief_->place(origin, along_s, along_t);
    }
    const auto foot = relief_->seen(point + sight_.camera, square.sight, square.middle);
    if (!foot) return false;
    square = square_at(affine(sight_.world_from_object, foot->position) - sight_.camera, pixel, sight);
    return true;
}

ir::PixelInputs Truth::inputs(dvec3 point, dvec2 pixel, dvec3 sight) const {
    const Square square = square_at(point, pixel, sight);
    return inputs_at(square, square.middle);
}

// A diamond of points: each stage needs the neighbours of those that the next one needs.
dvec3 Truth::displaced_normal(const Square& square, bool held, TrueNormal& out) {
    const int reach = static_cast<int>(stages_.size()), side = 2 * reach + 1;
    const auto index = [&](int x, int y) { return static_cast<std::size_t>((y + reach) * side + x + reach); };
    const auto count = static_cast<std::size_t>(side * side);
    const double outward = mirrors_ && square.facing < 0 ? -1 : 1;
    std::vector<dvec3> points(count), normals(count);
    std::vector<std::vector<double>> heights(stages_.size(), std::vector<double>(count));
    std::vector<ir::Datum> middle;
    if (held) middle = evaluator_.run(lifted_inputs(square, square.middle));
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            if (std::abs(x) + std::abs(y) > reach) continue;
            const dvec3 place =
                square.middle.position + kStep * (1.0 * x * square.right + 1.0 * y * square.up);
            const Foot foot = foot_of(sight_.shape, place, &square.middle);
            const auto& values = evaluator_.run(lifted_inputs(square, foot));
            points[index(x, y)] = linear(sight_.world_from_object, foot.position - square.middle.position);
            normals[index(x, y)] = outward * glm::normalize(normal_from_object_ * foot.normal);
            for (std::size_t k = 0; k < stages_.size(); ++k)
                heights[k][index(x, y)] = heights_.of(stages_[k], values, held ? middle : values) +
                                          (relief_ && k == 0 ? relief_->bias() : 0);
        }
    }
    const std::size_t middle_index = index(0, 0), looked_up = relief_ ? 1 : 0;
    const std::vector<double> along = changes_along(square, normals[middle_index]);
    dvec3 first_point(0.0), first_normal = normals[middle_index];  // where volumes are looked up
    double first_curvature = 0;
    out.left_out = 0;
    for (std::size_t k = 0; k < stages_.size(); ++k) {
        const dvec3 before = normals[middle_index];
        const double curvature = largest_curvature(
            points[index(1, 0)] - points[index(-1, 0)], points[index(0, 1)] - points[index(0, -1)],
            normals[index(1, 0)] - normals[index(-1, 0)], normals[index(0, 1)] - normals[index(0, -1)]);
        if (k <= looked_up) {
            first_point = points[middle_index];
            first_normal = before;
            first_curvature = curvature;
        }
        const double bent = std::abs(heights[k][middle_index]) * curvature +
                            glm::distance(points[middle_index], first_point) * first_curvature;
        for (std::size_t i = 0; i < count; ++i) points[i] += heights[k][i] * normals[i];
        const int inner = reach - static_cast<int>(k) - 1;
        for (int y = -inner; y <= inner; ++y) {
            for (int x = -inner; x <= inner; ++x) {
                if (std::abs(x) + std::abs(y) > inner) continue;
                const dvec3 n = glm::cross(points[index(x + 1, y)] - points[index(x - 1, y)],
                                           points[index(x, y + 1)] - points[index(x, y - 1)]);
                dvec3& normal = normals[index(x, y)];
                // A placement of negative determinant turns the cross product, not the outer side.
                const double mirrored = glm::determinant(dmat3(sight_.world_from_object)) < 0 ? -1 : 1;
                normal = glm::normalize(outward * mirrored * n);
            }
        }
        const dvec3 after = normals[middle_index];
        out.left_out += arcsine(bent * sine_between(before, after)) +
                        arcsine(std::abs(along[k]) * sine_between(first_normal, before) *
                                std::abs(glm::dot(before, after)));
    }
    out.moved = glm::length(points[middle_index]);
    const dvec3 normal = normals[middle_index];
    return flips_ && square.facing < 0 ? -normal : normal;
}

std::vector<double> Truth::changes_along(const Square& square, dvec3 normal) {
    std::vector<double> out(stages_.size(), 0);
    if (stages_.size() < 2) return out;
    for (double side : {1.0, -1.0}) {
        ir::PixelInputs inputs = lifted_inputs(square, square.middle);
        inputs.position += side * kStep * normal;
        inputs.world.p += side * kStep * normal;
        inputs.object.p = affine(object_from_world_, inputs.world.p);
        const auto& values = evaluator_.run(inputs);
        for (std::size_t k = 1; k < stages_.size(); ++k)
            out[k] += side * heights_.of(stages_[k], values, values) / (2 * kStep);
    }
    return out;
}

TrueNormal Truth::at(dvec3 point, dvec2 pixel, dvec3 sight, bool held) {
    Square square = square_at(point, pixel, sight);
    TrueNormal out;
    if (!look(square, point, pixel, sight)) return out;
    const bool turned = (mirrors_ || flips_) && square.facing < 0;
    out.base = (turned ? -1.0 : 1.0) * glm::normalize(normal_from_object_ * square.middle.normal);
    out.normal = displaced_normal(square, false, out);
    if (held) out.held = displaced_normal(square, true, out);
    return out;
}

}  // namespace sg::proof

#include "runtime/proof/relief.hpp"

#include <algorithm>
#include <cmath>

namespace sg::proof {
namespace {

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using ir::Op;
using runtime::Foot;

// The march's steps from the highest to the lowest height; bisection halves the last one to 1e-9 of that.
// Between steps a relief narrower than a 64th of the way may be missed.
constexpr int kSteps = 64, kHalvings = 24;
// Rays along the surface end after 32 times the relief's depth: below 1.8 degrees.
constexpr double kLeastCosine = 1.0 / 32;

bool varies(const ir::Module& module, ir::ValueId id) {
    const ir::Value& value = module.at(id);
    if (value.op == Op::constant || value.op == Op::parameter || value.op == Op::time) return false;
    if (value.operands.empty() || ir::info(value.op).attribute == ir::Attribute::Texture) return true;
    return std::any_of(value.operands.begin(), value.operands.end(),
                       [&](ir::ValueId operand) { return varies(module, operand); });
}

// A set of the mesh, scaled and turned by what is the same everywhere.
bool is_placed(const ir::Module& module, ir::ValueId id) {
    const ir::Value& value = module.at(id);
    if (value.op == Op::uv_set) return true;
    if (value.op != Op::uv_scale && value.op != Op::uv_transform) return false;
    for (std::size_t i = 1; i < value.operands.size(); ++i) {
        if (varies(module, value.operands[i])) return false;
    }
    return is_placed(module, value.operands[0]);
}

}  // namespace

std::optional<ReliefSource> relief_source(const ir::Module& module) {
    for (std::uint32_t i = 0; i < module.values.size(); ++i) {
        const ir::Value& value = module.values[i];
        const ir::ValueId id{i};
        if (value.op == Op::parallax_occlusion)
            return ReliefSource{id, value.operands[0], value.operands[2], value.index};
        if (value.op == Op::parallax_steps) return ReliefSource{id, value.operands[1], {}, value.index};
        if (value.op != Op::parallax_offset) continue;
        const ir::Value& height = module.at(value.operands[1]);
        return ReliefSource{id, height.operands[0], height.operands[1], height.index};
    }
    return std::nullopt;
}

ir::Module without_relief(const ir::Module& module) {
    ir::Module out = module;
    out.values.clear();
    ir::Builder builder(out);
    const ir::ValueId no_heights = builder.constant(ir::Type::Vec2, {0, 0}),
                      no_step = builder.constant(ir::Type::Scalar, {0});
    for (ir::Value value : module.values) {
        for (ir::ValueId& operand : value.operands) operand.index += kFlatShift;
        if (value.op == Op::parallax_occlusion) value.operands[2] = no_heights;
        if (value.op == Op::parallax_height) value.operands[1] = no_heights;
        if (value.op == Op::parallax_steps) value.operands[2] = no_step;
        out.values.push_back(std::move(value));
    }
    for (ir::OutputBinding& output : out.outputs) output.value.index += kFlatShift;
    return out;
}

Relief::Relief(const ir::Module& flat, const ReliefSource& source, const ir::Bindings& bindings,
               const std::map<std::string, Partner>& partners, const Sight& sight)
    : flat_(flat),
      source_{{source.op.index + kFlatShift},
              {source.uv.index + kFlatShift},
              source.heights.valid() ? ir::ValueId{source.heights.index + kFlatShift} : ir::ValueId{},
              source.texture},
      shape_(sight.shape),
      world_from_object_(sight.world_from_object),
      object_from_world_(glm::inverse(sight.world_from_object)),
      normal_from_object_(glm::transpose(glm::inverse(dmat3(sight.world_from_object)))) {
    const auto found = partners.find(flat.textures[source.texture].name);
    if (!source.heights.valid() && found != partners.end()) partner_ = &found->second;
    texels_ = partner_ ? partner_->heights : bindings.textures[source.texture];
}

std::optional<NoHeight> Relief::missing() const {
    if (!source_.heights.valid() && partner_ == nullptr)
        return NoHeight{source_.op,
                        "it holds tangent planes, and the heights that it was baked from are not given"};
    if (source_.heights.valid() && varies(flat_, source_.heights))
        return NoHeight{source_.op, "the strength of its parallax varies over the surface"};
    if (!is_placed(flat_, source_.uv))
        return NoHeight{source_.op, "the coordinate of its parallax is not one of the mesh"};
    return std::nullopt;
}

void Relief::place(const std::vector<ir::Datum>& origin, const std::vector<ir::Datum>& along_s,
                   const std::vector<ir::Datum>& along_t) {
    auto st = [&](const std::vector<ir::Datum>& values) {
        return std::get<ref::Uv>(values[source_.uv.index]).st;
    };
    placed_ = true;
    origin_ = st(origin);
    from_st_ = glm::dmat2(st(along_s) - origin_, st(along_t) - origin_);
    // A map of tangent planes has its middle on the mesh.
    const dvec2 heights = partner_ ? dvec2(partner_->length, -partner_->length / 2)
                                   : std::get<dvec2>(origin[source_.heights.index]);
    scale_ = heights.x;
    bias_ = heights.y;
}

void Relief::focus(dvec2 st_dx, dvec2 st_dy, double outward) {
    outward_ = outward;
    footprint_ = {dvec2(0), from_st_ * st_dx, from_st_ * st_dy};
}

double Relief::height(const Foot& foot) const {
    return bias_ +
           scale_ * smooth_height(texels_, {origin_ + from_st_ * foot.st, footprint_.dx, footprint_.dy});
}

// A point's place over the smooth surface: its foot, how high it is, and how far above the displaced one.
struct Relief::Above {
    Foot foot;
    double height = 0, gap = 0;
};

// The foot in world space, where the normals of a stretched object are not those of the nearest points.
Relief::Above Relief::above(dvec3 point, const Foot& near) const {
    Above out;
    out.foot = foot_of(shape_, dvec3(object_from_world_ * dvec4(point, 1)), &near);
    for (int i = 0; i < 8; ++i) {
        const dvec3 n = outward_ * glm::normalize(normal_from_object_ * out.foot.normal);
        const dvec3 away = point - dvec3(world_from_object_ * dvec4(out.foot.position, 1));
        out.height = glm::dot(away, n);
        if (glm::length(away - out.height * n) < 1e-10) break;
        out.foot = foot_of(shape_, dvec3(object_from_world_ * dvec4(point - out.height * n, 1)), &near);
    }
    out.gap = out.height - height(out.foot);
    return out;
}

std::optional<Foot> Relief::seen(dvec3 from, dvec3 along, const Foot& near) const {
    const double top = bias_ + std::max(scale_, 0.0), bottom = bias_ + std::min(scale_, 0.0);
    const dvec3 n = glm::normalize(normal_from_object_ * near.normal);
    const double cosine = std::max(std::abs(glm::dot(along, n)), kLeastCosine);
    // Catmull-Rom overshoots by at most an eighth at a step.
    const double slack = 0.13 * (top - bottom), step = (top - bottom + 2 * slack) / kSteps / cosine;
    double before = -(top + slack) / cosine;
    if (step <= 0) return near;
    for (int i = 1; i <= 2 * kSteps; ++i) {
        double after = -(top + slack) / cosine + i * step;
        if (above(from + after * along, near).gap > 0) {
            before = after;
            continue;
        }
        for (int k = 0; k < kHalvings; ++k) {
            const double middle = (before + after) / 2;
            (above(from + middle * along, near).gap > 0 ? before : after) = middle;
        }
        return above(from + after * along, near).foot;
    }
    return std::nullopt;
}

}  // namespace sg::proof

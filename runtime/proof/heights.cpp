#include "runtime/proof/heights.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/ice.hpp"

namespace sg::proof {
namespace {

using ir::Op;
using ref::dvec2;
using ref::dvec3;

constexpr const char* kOwnFunction = "it is a function of its own, whose height is not known";
constexpr const char* kEarlierNormal = "it leads back to another normal, which is no height of its own";
constexpr const char* kTwoNormals = "it blends two normals, which is no sum of heights";

const std::vector<HeightRow>& rows() {
    static const std::vector<HeightRow> kRows = {
        {Op::sample, HeightRule::partner},
        {Op::swizzle, HeightRule::pass},
        {Op::decode_normal_xyz, HeightRule::pass},
        {Op::decode_normal_xy, HeightRule::pass},
        {Op::decode_object_normal, HeightRule::pass},
        {Op::decode_world_normal, HeightRule::pass},
        {Op::decode_derivative, HeightRule::pass},
        {Op::normal_from_object, HeightRule::pass},
        {Op::direction_of, HeightRule::none, 0, kEarlierNormal},
        {Op::deriv_from_height, HeightRule::texel},
        {Op::deriv_from_height_hq, HeightRule::texel},
        {Op::deriv_from_normal_xyz, HeightRule::pass},
        {Op::deriv_from_normal_xy, HeightRule::pass},
        {Op::deriv_green_up, HeightRule::pass},
        {Op::normal_from_deriv, HeightRule::none, 0, kTwoNormals},
        {Op::deriv_from_map_normal, HeightRule::none, 0, kTwoNormals},
        {Op::combine_whiteout, HeightRule::none, 0, kTwoNormals},
        {Op::combine_udn, HeightRule::none, 0, kTwoNormals},
        {Op::combine_rnm, HeightRule::none, 0, kTwoNormals},
        {Op::combine_reoriented, HeightRule::none, 0, kTwoNormals},
        {Op::pair_first, HeightRule::none, 0, kTwoNormals},
        {Op::pair_second, HeightRule::none, 0, kTwoNormals},
        {Op::scale_deriv, HeightRule::scale},
        {Op::add_deriv, HeightRule::sum},
        {Op::triplanar_gradient, HeightRule::planes},
        {Op::noise_gradient, HeightRule::pass, 1},
        {Op::noise_perlin, HeightRule::noise},
        {Op::noise_fractal_sum, HeightRule::noise},
        {Op::noise_turbulence, HeightRule::noise},
        {Op::noise_power, HeightRule::noise},
        {Op::decal_gradient, HeightRule::pass},
        {Op::decal_gradient_along, HeightRule::pass},
        {Op::gradient_from_object, HeightRule::pass},
        {Op::gradient_from_world, HeightRule::pass},
        {Op::scale_volgrad, HeightRule::scale},
        {Op::add_volgrad, HeightRule::sum},
        {Op::mix_volgrad, HeightRule::mix},
        {Op::zero_surfgrad, HeightRule::zero},
        {Op::surfgrad_from_height, HeightRule::pass, 2},
        {Op::surfgrad_from_three_taps, HeightRule::texel, 1},
        {Op::surfgrad_from_normal, HeightRule::pass, 1},
        {Op::surfgrad_from_volume, HeightRule::pass, 1},
        {Op::surfgrad_from_tbn, HeightRule::pass},
        {Op::scale_surfgrad, HeightRule::scale},
        {Op::add_surfgrad, HeightRule::sum},
        {Op::mask_surfgrad, HeightRule::mask},
        {Op::mix_surfgrad, HeightRule::mix},
        {Op::custom_deriv, HeightRule::none, 0, kOwnFunction},
        {Op::custom_gradient, HeightRule::none, 0, kOwnFunction},
        {Op::custom_surfgrad, HeightRule::none, 0, kOwnFunction},
    };
    return kRows;
}

const HeightRow* row_of(Op op) {
    static const std::vector<const HeightRow*> kByOp = [] {
        std::vector<const HeightRow*> out(ir::all_ops().size(), nullptr);
        for (const HeightRow& row : rows()) out[static_cast<std::size_t>(row.op)] = &row;
        return out;
    }();
    return kByOp[static_cast<std::size_t>(op)];
}

// Which operands a rule takes heights from.
std::vector<int> height_operands(const HeightRow& row) {
    switch (row.rule) {
        case HeightRule::pass:
            return {row.operand};
        case HeightRule::scale:
            return {1};
        case HeightRule::mask:
            return {0};
        case HeightRule::sum:
        case HeightRule::mix:
            return {0, 1};
        case HeightRule::planes:
            return {1, 2, 3};
        default:
            return {};
    }
}

// Catmull-Rom's weights of the texels at -1, 0, 1, 2 for a place t between 0 and 1.
std::array<double, 4> catmull_rom(double t) {
    const double tt = t * t, ttt = tt * t;
    return {(-ttt + 2 * tt - t) / 2, (3 * ttt - 5 * tt + 2) / 2, (-3 * ttt + 4 * tt + t) / 2, (ttt - tt) / 2};
}

ref::Wrap wrap_of(ir::Sampled::Wrap wrap) {
    if (wrap == ir::Sampled::Wrap::mirror) return ref::Wrap::mirror;
    return wrap == ir::Sampled::Wrap::clamp ? ref::Wrap::clamp : ref::Wrap::repeat;
}

double bicubic(const ir::Sampled& heights, dvec2 st, int level) {
    const ref::Sampler sampler{wrap_of(heights.wrap_s), wrap_of(heights.wrap_t)};
    const dvec2 place = st * dvec2(heights.texels->size(level)) - 0.5, corner = glm::floor(place);
    const auto across = catmull_rom(place.x - corner.x), down = catmull_rom(place.y - corner.y);
    double sum = 0;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            const glm::ivec2 texel = glm::ivec2(corner) + glm::ivec2(x - 1, y - 1);
            sum += across[static_cast<std::size_t>(x)] * down[static_cast<std::size_t>(y)] *
                   ref::texel_at(*heights.texels, sampler, texel, level).x;
        }
    }
    return sum;
}

}  // namespace

std::span<const HeightRow> all_height_rows() {
    return rows();
}

double smooth_height(const ir::Sampled& heights, const ref::Uv& uv) {
    const double last = heights.texels->levels() - 1;
    double level = std::clamp(ref::uv_level(uv, dvec2(heights.texels->size(0))), 0.0, last);
    if (heights.mips == ir::Sampled::Mips::none) level = 0;
    if (heights.mips == ir::Sampled::Mips::nearest) level = std::ceil(level + 0.5) - 1;
    const int fine = static_cast<int>(level);
    const double t = level - fine;
    const double here = bicubic(heights, uv.st, fine);
    return t > 0 ? (1 - t) * here + t * bicubic(heights, uv.st, fine + 1) : here;
}

std::optional<NoHeight> Heights::missing(ir::ValueId gradient) const {
    std::vector<ir::ValueId> open{gradient};
    std::vector<bool> seen(module_.values.size(), false);
    while (!open.empty()) {
        const ir::ValueId id = open.back();
        open.pop_back();
        if (seen[id.index]) continue;
        seen[id.index] = true;
        const ir::Value& value = module_.at(id);
        const HeightRow* row = row_of(value.op);
        if (row == nullptr) return NoHeight{id, "no height is known for this operation"};
        if (row->rule == HeightRule::none) return NoHeight{id, row->why};
        if (row->rule == HeightRule::partner && !partners_.contains(module_.textures[value.index].name))
            return NoHeight{id, "it holds slopes, and the heights that it was baked from are not given"};
        for (int i : height_operands(*row)) open.push_back(value.operands[static_cast<std::size_t>(i)]);
    }
    return std::nullopt;
}

double Heights::of(ir::ValueId id, const std::vector<ir::Datum>& values,
                   const std::vector<ir::Datum>& weights) const {
    const ir::Value& value = module_.at(id);
    const HeightRow* row = row_of(value.op);
    SG_ASSERT(row != nullptr);
    auto operand = [&](int i) { return value.operands[static_cast<std::size_t>(i)]; };
    auto height = [&](int i) { return of(operand(i), values, weights); };
    auto weight = [&](int i) { return std::get<double>(weights[operand(i).index]); };
    auto uv = [&](int i) -> const ref::Uv& { return std::get<ref::Uv>(values[operand(i).index]); };
    switch (row->rule) {
        case HeightRule::zero:
            return 0;
        case HeightRule::texel:
            return smooth_height(bindings_.textures[value.index], uv(row->operand));
        case HeightRule::partner: {
            const Partner& partner = partners_.at(module_.textures[value.index].name);
            return partner.length * smooth_height(partner.heights, uv(0));
        }
        case HeightRule::noise:
            return std::get<ref::Noise>(values[id.index]).value;
        case HeightRule::pass:
            return height(row->operand);
        case HeightRule::scale:
            return weight(0) * height(1);
        case HeightRule::sum:
            return height(0) + height(1);
        case HeightRule::mask:
            return height(0) * weight(1);
        case HeightRule::mix:
            return height(0) + weight(2) * (height(1) - height(0));
        case HeightRule::planes: {
            const auto& share = std::get<dvec3>(weights[operand(0).index]);
            double sum = 0;
            for (int i = 0; i < 3; ++i) sum += share[i] == 0 ? 0 : share[i] * height(i + 1);
            return sum;
        }
        case HeightRule::none:
            break;
    }
    SG_UNREACHABLE("a height was asked for that is missing");
}

}  // namespace sg::proof

#include "opt/interval.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace sg::opt {
namespace {

using ir::Op;
using ir::Value;

constexpr Interval kShare{0, 1};

// From the smallest to the largest of these; where one is none (0 times endless), nothing is known.
Interval spanned(std::initializer_list<double> ends) {
    for (double end : ends) {
        if (std::isnan(end)) return {};
    }
    return {std::min(ends), std::max(ends)};
}

Interval product(Interval a, Interval b) {
    return spanned({a.least * b.least, a.least * b.most, a.most * b.least, a.most * b.most});
}

// What texels hold: compiler/artefacts.md.
Interval texel(const Rewriter& rewriter, const Value& channel) {
    const Value* texel = &rewriter.at(channel.operands[0]);
    std::uint32_t stored = channel.index;
    if (texel->op == Op::swizzle) {
        stored = ir::swizzle_channels(texel->index)[stored];
        texel = &rewriter.at(texel->operands[0]);
    }
    if (texel->op != Op::sample) return {};
    const ir::TextureEncoding encoding = rewriter.texture(*texel).encoding;
    const bool alpha = encoding == ir::TextureEncoding::color && stored == 3;
    return alpha || encoding == ir::TextureEncoding::mask ? kShare : Interval{};
}

Interval smaller(Interval a, Interval b) {
    return {std::min(a.least, b.least), std::min(a.most, b.most)};
}
Interval larger(Interval a, Interval b) {
    return {std::max(a.least, b.least), std::max(a.most, b.most)};
}

Interval computed(Op op, const std::array<Interval, 3>& x) {
    switch (op) {
        case Op::add:
            return spanned({x[0].least + x[1].least, x[0].most + x[1].most});
        case Op::subtract:
            return spanned({x[0].least - x[1].most, x[0].most - x[1].least});
        case Op::multiply:
            return product(x[0], x[1]);
        case Op::minimum:
            return smaller(x[0], x[1]);
        case Op::maximum:
            return larger(x[0], x[1]);
        case Op::clamp:
            return smaller(larger(x[0], x[1]), x[2]);
        case Op::mix:
            if (!x[2].within(0, 1)) return {};
            return {std::min(x[0].least, x[1].least), std::max(x[0].most, x[1].most)};
        default:
            return {};
    }
}

bool is_computed(Op op) {
    return op == Op::add || op == Op::subtract || op == Op::multiply || op == Op::minimum ||
           op == Op::maximum || op == Op::clamp || op == Op::mix;
}

}  // namespace

Interval interval_of(const Rewriter& rewriter, ir::ValueId id, int depth) {
    const Value& value = rewriter.at(id);
    if (is_computed(value.op) && depth > 0) {
        std::array<Interval, 3> operands;
        for (std::size_t k = 0; k < value.operands.size(); ++k)
            operands[k] = interval_of(rewriter, value.operands[k], depth - 1);
        return computed(value.op, operands);
    }
    switch (value.op) {
        case Op::constant:
            return {value.number[0], value.number[0]};
        case Op::parameter: {
            const auto& range = rewriter.parameter(value).range;
            return range ? Interval{(*range)[0], (*range)[1]} : Interval{};
        }
        case Op::channel:
            return texel(rewriter, value);
        case Op::facing:
            return {-1, 1};
        case Op::decal_falloff_box:
        case Op::decal_falloff_cone:
        case Op::decal_falloff_sphere:
        case Op::decal_falloff_capsule:
        case Op::decal_falloff_wedge:
        case Op::decal_angle_fade:
        case Op::smoothstep:
            return kShare;
        default:
            return {};
    }
}

}  // namespace sg::opt

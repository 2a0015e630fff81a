// The height that a value of the IR is the gradient of.
//
// The IR holds gradients; what is displaced is a height. One table says, for each operation that gives a
// texel, a derivative or a gradient, how its height follows from those of its operands: a height map's is the
// texel, a noise's its value, sums and factors pass through. Slopes (normal maps) have no heights of their
// own: their *partner* is the height map that they were baked from.
//
// Between texels a height is the Catmull-Rom interpolant, which goes through the texels and has a continuous
// slope: it belongs to none of the methods that it judges. It is read at the level of detail of the pixel
// (mixed from two levels), so that it holds as much detail as what is judged.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "ir/evaluate.hpp"

namespace sg::proof {

// The height map that a map of slopes was baked from, and the length of its value 1 in world units (of a map
// with "scale": "displacement": in texels). Placed, tiled and wrapped as the map itself.
struct Partner {
    ir::Sampled heights;
    double length = 1;
};

// Whose height follows from what. `self`: from the value itself. `pass`, `scale`, ...: operands by position.
enum class HeightRule { none, zero, texel, partner, noise, pass, scale, sum, mask, mix, planes };
struct HeightRow {
    ir::Op op;
    HeightRule rule;
    int operand = 0;       // pass, texel (its uv): which operand
    const char* why = "";  // none: why there is no height
};
std::span<const HeightRow> all_height_rows();

// Why a gradient has no height: the value that breaks the chain.
struct NoHeight {
    ir::ValueId value;
    const char* why = "";
};

class Heights {
public:
    // All must outlive it. Partners by the texture's name.
    Heights(const ir::Module& module, const ir::Bindings& bindings, std::map<std::string, Partner> partners)
        : module_(module), bindings_(bindings), partners_(std::move(partners)) {}

    // Nothing where the gradient has a height; else the first value that has none.
    [[nodiscard]] std::optional<NoHeight> missing(ir::ValueId gradient) const;

    // The height whose gradient this value is, world units. `values`: of a run of the evaluator. Factors
    // (strengths, masks, shares of planes) come from `weights`, which is `values` too for the displaced
    // surface, or those of one place, to hold them constant.
    [[nodiscard]] double of(ir::ValueId gradient, const std::vector<ir::Datum>& values,
                            const std::vector<ir::Datum>& weights) const;

private:
    const ir::Module& module_;
    const ir::Bindings& bindings_;
    std::map<std::string, Partner> partners_;
};

// The Catmull-Rom interpolant of the red channel.
double smooth_height(const ir::Sampled& heights, const ref::Uv& uv);

}  // namespace sg::proof

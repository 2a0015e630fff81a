// Mip chains that mean the right thing: colours average in linear light, normal maps average slopes.
#pragma once

#include <array>
#include <vector>

#include "asset/image.hpp"

namespace sg::runtime {

// How the texels of level 0 are to be understood. Which way green points does not matter here: averaging
// slopes and encoding them again commutes with a change of sign.
struct MipRule {
    enum class Kind { color, slopes_xyz, slopes_xy };
    Kind kind = Kind::color;
    bool srgb =
        false;  // color only: rgb is sRGB encoded and averages in linear light; alpha is always linear
    double zero = 127.5;  // slopes only: the 8-bit code that means 0, one of 127, 127.5 and 128
    std::array<int, 4> channels{0, 1, 2, 3};  // slopes only: where x, y, z and the rest stand; all different
};

// Level 0 (returned untouched) down to 1x1, each level max(1, floor(n/2)) per side, box filtered with exact
// areas, also for odd sizes. Sums are kept in double from level to level; only the texels that are handed out
// are rounded. slopes_*: averages -x/z and -y/z (each at most 128) and writes the unit normal of the mean;
// channels that carry no normal (alpha; blue of slopes_xy) average as plain numbers. A texel that is not a
// number counts as 0.
std::vector<asset::Image> mip_chain(const asset::Image& base, const MipRule& rule);

}  // namespace sg::runtime

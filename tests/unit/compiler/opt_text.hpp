// Modules as text, and what the optimiser makes of them.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "ir/text.hpp"
#include "opt/optimise.hpp"

namespace sg::opt {

// What most modules of these tests begin with: a normal map on vertex tangents, %0 to %7.
inline const std::string kTexture = "texture 0 \"t\" tangent_normal\n";
inline const std::string kSurface =
    "%0 = vertex_normal : VertexNormal\n%1 = base_normal %0 : Normal\n%2 = vertex_tangent : VertexTangent\n"
    "%3 = basis_vertex %0 %2 : Basis\n%4 = uv_set 0 : Uv\n%5 = sample 0 %4 : Texel\n"
    "%6 = decode_normal_xyz 127.5 %5 : TangentNormal\n%7 = deriv_from_normal_xyz %6 : Deriv\n";

// The optimised module, without its first line; a rule may be left out. Of a text that is no module: what is
// wrong with it.
inline std::string optimised(std::string_view text, std::string_view skipped = "") {
    std::string fault;
    auto module = ir::parse(text, fault);
    if (!module) return fault;
    EXPECT_EQ(ir::verify(*module), "");
    std::string printed = ir::print(optimise(*module, skipped));
    return printed.substr(printed.find('\n') + 1);
}

}  // namespace sg::opt

// What explain says of each line: the whole text, and that no blame is wrong.
#include "explain.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "ir/text.hpp"
#include "opt/optimise.hpp"

namespace sg {
namespace {

ir::Module parsed(const std::string& text) {
    std::string fault;
    auto module = ir::parse(text, fault);
    EXPECT_TRUE(module) << fault;
    return module ? *module : ir::Module{};
}

// A bump of strength 2 * 3 p, and one of strength 0. Often the last use goes elsewhere than the first: the 2
// is folded with the 3 and still needed by a smooth step, 6 and p go to the host in the end, and the bump is
// projected until the second one vanishes.
const std::string kSmall = R"(module "small"
texture 0 "t" tangent_normal
parameter 0 "p" : Scalar
%0 = vertex_normal : VertexNormal
%1 = base_normal %0 : Normal
%2 = vertex_tangent : VertexTangent
%3 = basis_vertex %0 %2 : Basis
%4 = uv_set 0 : Uv
%5 = sample 0 %4 : Texel
%6 = decode_normal_xy 127.5 %5 : TangentNormalXy
%7 = deriv_from_normal_xy %6 : Deriv
%8 = constant 2 : Scalar
%9 = constant 3 : Scalar
%10 = multiply %8 %9 : Scalar
%11 = surfgrad_from_tbn %7 %3 : SurfGrad
%12 = scale_surfgrad %10 %11 : SurfGrad
%13 = parameter 0 : Scalar
%14 = scale_surfgrad %13 %12 : SurfGrad
%15 = constant 0 : Scalar
%16 = time : Scalar
%17 = smoothstep %15 %8 %16 : Scalar
%18 = multiply %15 %17 : Scalar
%19 = surfgrad_from_tbn %7 %3 : SurfGrad
%20 = scale_surfgrad %18 %19 : SurfGrad
%21 = add_surfgrad %14 %20 : SurfGrad
%22 = resolve %1 %21 : Normal 'normal'
output normal = %22
output uv 0 = %4
)";

// The twin of a line may be what a rule made of another line, which is nothing like it.
TEST(Explain, NamesWhatALineIsTheSameAs) {
    const std::string text = explain_module(
        parsed("module \"twins\"\n%0 = facing : Scalar\n%1 = constant 2 : Scalar\n%2 = constant 3 : Scalar\n"
               "%3 = multiply %1 %2 : Scalar\n%4 = constant 6 : Scalar\n%5 = constant 6 : Scalar\n"
               "%6 = multiply %0 %3 : Scalar\n%7 = multiply %4 %6 : Scalar\n%8 = add %5 %7 : Scalar\n"
               "output metallic = %8\n"));
    EXPECT_NE(
        text.find("%4 = constant 6 : Scalar                                                  # now %1: the "
                  "same as what fold_numbers made of %3\n"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("%3 = multiply %1 %2 : Scalar                                              # now %1: "
                        "fold_numbers\n"),
              std::string::npos)
        << text;
}

TEST(Explain, NamesTheRuleThatTookTheLastUseAway) {
    EXPECT_EQ(explain_module(parsed(kSmall)), R"(# Before the optimiser: 23 values

module "small"
texture 0 "t" tangent_normal
parameter 0 "p" : Scalar
%0 = vertex_normal : VertexNormal                                         # now %0
%1 = base_normal %0 : Normal                                              # now %1
%2 = vertex_tangent : VertexTangent                                       # now %2
%3 = basis_vertex %0 %2 : Basis                                           # now %3
%4 = uv_set 0 : Uv                                                        # now %4
%5 = sample 0 %4 : Texel                                                  # now %5
%6 = decode_normal_xy 127.5 %5 : TangentNormalXy                          # now %6
%7 = deriv_from_normal_xy %6 : Deriv                                      # now %7
%8 = constant 2 : Scalar                                                  # gone: times_nothing of %18
%9 = constant 3 : Scalar                                                  # gone: fold_numbers of %10
%10 = multiply %8 %9 : Scalar                                             # gone: fold_numbers, then parameters_on_host of %14
%11 = surfgrad_from_tbn %7 %3 : SurfGrad                                  # gone: scale_to_nothing of %20
%12 = scale_surfgrad %10 %11 : SurfGrad                                   # gone: scale_before_projection, then scale_before_projection of %14
%13 = parameter 0 : Scalar                                                # gone: parameters_on_host of %14
%14 = scale_surfgrad %13 %12 : SurfGrad                                   # now %10: scale_before_projection, one_factor, parameters_on_host
%15 = constant 0 : Scalar                                                 # gone: scale_to_nothing of %20
%16 = time : Scalar                                                       # gone: times_nothing of %18
%17 = smoothstep %15 %8 %16 : Scalar                                      # gone: times_nothing of %18
%18 = multiply %15 %17 : Scalar                                           # gone: times_nothing, then scale_to_nothing of %20
%19 = surfgrad_from_tbn %7 %3 : SurfGrad                                  # gone: scale_to_nothing of %20
%20 = scale_surfgrad %18 %19 : SurfGrad                                   # gone: scale_to_nothing, then add_nothing of %21
%21 = add_surfgrad %14 %20 : SurfGrad                                     # now %10: add_nothing
%22 = resolve %1 %21 : Normal 'normal'                                    # now %11
output normal = %22
output uv 0 = %4

# After it: 12 values

module "small"
texture 0 "t" tangent_normal
parameter 0 "p" : Scalar
host %0 = constant 6 : Scalar
host %1 = parameter 0 : Scalar
host %2 = multiply %1 %0 : Scalar
derived 0 "multiply" : Scalar = %2
%0 = vertex_normal : VertexNormal                                         # was %0
%1 = base_normal %0 : Normal                                              # was %1
%2 = vertex_tangent : VertexTangent                                       # was %2
%3 = basis_vertex %0 %2 : Basis                                           # was %3
%4 = uv_set 0 : Uv                                                        # was %4
%5 = sample 0 %4 : Texel                                                  # was %5
%6 = decode_normal_xy 127.5 %5 : TangentNormalXy                          # was %6
%7 = deriv_from_normal_xy %6 : Deriv                                      # was %7
%8 = derived 0 : Scalar                                                   # was %14: parameters_on_host
%9 = scale_deriv %8 %7 : Deriv                                            # was %14: one_factor
%10 = surfgrad_from_tbn %9 %3 : SurfGrad                                  # was %14: scale_before_projection
%11 = resolve %1 %10 : Normal 'normal'                                    # was %22
output normal = %11
output uv 0 = %4
)");
}

}  // namespace
}  // namespace sg

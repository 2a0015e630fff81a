#include <fmt/core.h>

#include <algorithm>

#include "tests/unit/compiler/opt_text.hpp"

namespace sg::opt {
namespace {

// What has no room in the block stays in the shader, and a second run finds nothing more to do.
TEST(Opt, TheBlockOfDerivedParametersIsBounded) {
    std::string text =
        "parameter 0 \"p\" : Scalar\n%0 = parameter 0 : Scalar\n%1 = facing : Scalar\n%2 = add %0 %1 : "
        "Scalar\n";
    int last = 2;
    // Each product of p is the host's, each sum with the facing is the shader's.
    for (int i = 0; i < 300; ++i) {
        text += fmt::format(
            "%{} = constant {} : Scalar\n%{} = multiply %0 %{} : Scalar\n%{} = add %{} %{} : Scalar\n",
            last + 1, i + 2, last + 2, last + 1, last + 3, last, last + 2);
        last += 3;
    }
    text += fmt::format("output metallic = %{}\n", last);
    std::string fault;
    const ir::Module once = optimise(*ir::parse(text, fault));
    EXPECT_EQ(once.derived.size(), 256u);
    auto products = [](const ir::Module& module) {
        return std::count_if(module.values.begin(), module.values.end(),
                             [](const ir::Value& v) { return v.op == ir::Op::multiply; });
    };
    EXPECT_EQ(products(once), 44);
    EXPECT_EQ(ir::print(optimise(once)), ir::print(once));
}

TEST(Opt, WhatTheHostComputesIsVerified) {
    auto faults = [](const std::string& text) {
        std::string fault;
        auto module = ir::parse("parameter 0 \"p\" : Scalar\n" + text, fault);
        return module ? ir::verify(*module) : fault;
    };
    EXPECT_EQ(
        faults("host %0 = parameter 0 : Scalar\nderived 0 \"d\" : Scalar = %0\n%0 = derived 0 : Scalar\n"),
        "");
    EXPECT_EQ(faults("host %0 = facing : Scalar\n"), "host %0: 'facing' is nothing that the host computes\n");
    EXPECT_EQ(faults("host %0 = parameter 1 : Scalar\n"), "host %0: no such parameter\n");
    EXPECT_EQ(faults("derived 0 \"d\" : Scalar = %0\n"), "derived d: is no value of the host of its type\n");
    EXPECT_EQ(faults("host %0 = parameter 0 : Scalar\nderived 0 \"d\" : Color = %0\n"),
              "derived d: is no value of the host of its type\n");
    EXPECT_EQ(faults("%0 = derived 0 : Scalar\n"), "%0: no such derived number\n");
    EXPECT_EQ(
        faults("host %0 = parameter 0 : Scalar\nderived 0 \"d\" : Scalar = %0\n%0 = derived 0 : Color\n"),
        "%0: derived 'd' is Scalar, the value is Color\n");
}

// Of what may be endless or no number, 0 times it is not known.
TEST(Opt, OnlyNumbersWithABoundVanishUnderZero) {
    auto vanishes = [](const std::string& factor, const std::string& encoding) {
        const std::string text = "texture 0 \"t\" " + encoding +
                                 "\nparameter 0 \"free\" : Scalar\nparameter 1 \"bounded\" : Scalar 0 8\n"
                                 "%0 = uv_set 0 : Uv\n%1 = sample 0 %0 : Texel\n" +
                                 factor +
                                 "%4 = constant 0 : Scalar\n%5 = multiply %3 %4 : Scalar\noutput metallic = "
                                 "%5\n";
        return optimised(text).find("%0 = constant 0 : Scalar\noutput metallic = %0\n") != std::string::npos;
    };
    const std::string red = "%2 = constant 3 : Scalar\n%3 = channel 0 %1 : Scalar\n";
    const std::string alpha = "%2 = constant 3 : Scalar\n%3 = channel 3 %1 : Scalar\n";
    EXPECT_TRUE(vanishes(red, "mask"));
    EXPECT_FALSE(vanishes(red, "height"));
    EXPECT_FALSE(vanishes(red, "color"));
    EXPECT_TRUE(vanishes(alpha, "color"));
    EXPECT_TRUE(vanishes("%2 = parameter 1 : Scalar\n%3 = add %2 %2 : Scalar\n", "mask"));
    EXPECT_FALSE(vanishes("%2 = parameter 0 : Scalar\n%3 = maximum %2 %2 : Scalar\n", "mask"));
    EXPECT_FALSE(vanishes("%2 = time : Scalar\n%3 = minimum %2 %2 : Scalar\n", "mask"));
    EXPECT_TRUE(vanishes("%2 = time : Scalar\n%3 = smoothstep %2 %2 %2 : Scalar\n", "mask"));
}

TEST(Opt, NegativeTilingKeepsItsOwnBasis) {
    std::string text = kTexture + kSurface +
                       "%8 = position : Position\n%9 = frame %8 %1 : Frame\n%10 = constant 2 -3 : Vec2\n"
                       "%11 = uv_scale %4 %10 : Uv\n%12 = basis_uv %9 %11 : Basis\n"
                       "%13 = surfgrad_from_tbn %7 %12 : SurfGrad\noutput gradient = %13\n";
    EXPECT_NE(optimised(text).find("uv_scale"), std::string::npos);
}

// What a range says of a parameter holds as if it were written; without one, or with 0 in it, nothing is
// known.
TEST(Opt, ParametersKeepToTheirRanges) {
    const std::string rest =
        "%8 = parameter 0 : Vec2\n%9 = basis_mirror %3 %8 : Basis\n%10 = surfgrad_from_tbn %7 %9 : SurfGrad\n"
        "output gradient = %10\n";
    auto mirrors = [&](const std::string& parameter) {
        return optimised(kTexture + parameter + kSurface + rest).find("basis_mirror") != std::string::npos;
    };
    EXPECT_FALSE(mirrors("parameter 0 \"tiling\" : Vec2 0.5 8\n"));
    EXPECT_TRUE(mirrors("parameter 0 \"tiling\" : Vec2 0 8\n"));
    EXPECT_TRUE(mirrors("parameter 0 \"tiling\" : Vec2\n"));
}

// A mask that may leave 0 to 1 is cut; texels of masks, alphas, falloffs and what their products give cannot.
TEST(Opt, SharesAreNotCut) {
    // `lines` end with the mask.
    auto cut = [&](const std::string& declarations, const std::string& lines) {
        const auto mask = 7 + std::count(lines.begin(), lines.end(), '\n');
        return optimised(fmt::format(
                             "{}{}{}%{} = surfgrad_from_tbn %7 %3 : SurfGrad\n%{} = mask_surfgrad %{} %{} : "
                             "SurfGrad\noutput gradient = %{}\n",
                             declarations, kSurface, lines, mask + 1, mask + 2, mask + 1, mask, mask + 2))
                   .find("clamp") != std::string::npos;
    };
    auto channel = [&](const std::string& encoding, int of) {
        return cut(fmt::format("{}texture 1 \"m\" {}\n", kTexture, encoding),
                   fmt::format("%8 = sample 1 %4 : Texel\n%9 = channel {} %8 : Scalar\n", of));
    };
    EXPECT_FALSE(channel("mask", 0));
    EXPECT_FALSE(channel("color", 3));
    EXPECT_TRUE(channel("color", 0));
    EXPECT_TRUE(channel("height", 0));
    auto parameter = [&](const std::string& range) {
        return cut(kTexture + "parameter 0 \"p\" : Scalar" + range + "\n", "%8 = parameter 0 : Scalar\n");
    };
    EXPECT_FALSE(parameter(" 0 1"));
    EXPECT_TRUE(parameter(" 0 1.5"));
    EXPECT_TRUE(parameter(" -0.5 1"));
    EXPECT_TRUE(parameter(""));
    const std::string share = "%8 = facing : Scalar\n%9 = smoothstep %8 %8 %8 : Scalar\n";
    EXPECT_FALSE(cut(kTexture, share + "%10 = multiply %9 %9 : Scalar\n%11 = mix %9 %10 %9 : Scalar\n"));
    EXPECT_TRUE(cut(kTexture, share + "%10 = add %9 %9 : Scalar\n%11 = multiply %9 %10 : Scalar\n"));
    const std::string line = share + "%10 = constant 0.5 : Scalar\n%11 = constant 1 : Scalar\n";
    EXPECT_FALSE(cut(kTexture, line + "%12 = multiply %9 %10 : Scalar\n%13 = subtract %11 %12 : Scalar\n"));
    EXPECT_FALSE(cut(kTexture, line + "%12 = multiply %9 %10 : Scalar\n%13 = add %12 %10 : Scalar\n"));
    EXPECT_TRUE(cut(kTexture, line + "%12 = multiply %9 %10 : Scalar\n%13 = subtract %12 %10 : Scalar\n"));
    EXPECT_TRUE(cut(kTexture, line + "%12 = mix %9 %11 %8 : Scalar\n"));
    EXPECT_FALSE(cut(kTexture, line + "%12 = minimum %8 %11 : Scalar\n%13 = maximum %12 %10 : Scalar\n"));
}

TEST(Opt, OneProjectionReachesPastOtherLayers) {
    // layers 1 and 2 share the vertex basis; layer 0 has a basis of its own in front of them.
    std::string text = kTexture + kSurface +
                       "%8 = position : Position\n%9 = frame %8 %1 : Frame\n%10 = basis_uv %9 %4 : Basis\n"
                       "%11 = surfgrad_from_tbn %7 %10 : SurfGrad\n%12 = surfgrad_from_tbn %7 %3 : SurfGrad\n"
                       "%13 = constant 5 : Scalar\n%14 = scale_deriv %13 %7 : Deriv\n"
                       "%15 = surfgrad_from_tbn %14 %3 : SurfGrad\n%16 = add_surfgrad %11 %12 : SurfGrad\n"
                       "%17 = add_surfgrad %16 %15 : SurfGrad\noutput gradient = %17\n";
    std::string after = optimised(text);
    std::size_t projections = 0;
    for (std::size_t at = after.find("surfgrad_from_tbn"); at != std::string::npos;
         at = after.find("surfgrad_from_tbn", at + 1))
        ++projections;
    EXPECT_EQ(projections, 2u) << after;
    EXPECT_NE(after.find("add_deriv"), std::string::npos) << after;
}

std::size_t count_of(std::string_view what, std::string_view text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(what); at != std::string_view::npos; at = text.find(what, at + 1))
        ++count;
    return count;
}

// One bump of the vertex basis, others of bases of their own, and a last one that shares the first's; also
// where that stands within a sum, as a group is.
TEST(Opt, OneProjectionReachesPastManyLayers) {
    auto projections = [](std::size_t between, bool grouped) {
        std::string text = kTexture + kSurface +
                           "%8 = position : Position\n%9 = frame %8 %1 : Frame\n"
                           "%10 = surfgrad_from_tbn %7 %3 : SurfGrad\n";
        std::size_t next = 11, sum = 10;
        auto line = [&](const std::string& value) {
            text += fmt::format("%{} = {}\n", next, value);
            return next++;
        };
        auto own_basis = [&](std::size_t set) {
            const std::size_t uv = line(fmt::format("uv_set {} : Uv", set));
            const std::size_t basis = line(fmt::format("basis_uv %9 %{} : Basis", uv));
            return line(fmt::format("surfgrad_from_tbn %7 %{} : SurfGrad", basis));
        };
        for (std::size_t i = 0; i < between; ++i)
            sum = line(fmt::format("add_surfgrad %{} %{} : SurfGrad", sum, own_basis(i)));
        const std::size_t five = line("constant 5 : Scalar");
        const std::size_t deriv = line(fmt::format("scale_deriv %{} %7 : Deriv", five));
        std::size_t last = line(fmt::format("surfgrad_from_tbn %{} %3 : SurfGrad", deriv));
        if (grouped) last = line(fmt::format("add_surfgrad %{} %{} : SurfGrad", last, own_basis(between)));
        sum = line(fmt::format("add_surfgrad %{} %{} : SurfGrad", sum, last));
        const std::string after = optimised(text + fmt::format("output gradient = %{}\n", sum));
        return count_of("surfgrad_from_tbn", after);
    };
    for (std::size_t between : {0u, 1u, 2u, 3u, 6u}) {
        EXPECT_EQ(projections(between, false), between + 1);
        EXPECT_EQ(projections(between, true), between + 2);
    }
}

// A factor of 0 hides no endless bump; a mask does.
TEST(Opt, MasksOfWhatMayBeEndlessStay) {
    auto masks = [&](const std::string& exponent) {
        return count_of(
            "mask_surfgrad",
            optimised(kTexture + "parameter 0 \"p\" : Scalar 0 4\nparameter 1 \"q\" : Scalar\n" + kSurface +
                      "%8 = facing : Scalar\n%9 = " + exponent +
                      " : Scalar\n%10 = power %8 %9 : Scalar\n%11 = scale_deriv %10 %7 : Deriv\n"
                      "%12 = surfgrad_from_tbn %11 %3 : SurfGrad\n%13 = mask_surfgrad %12 %8 : SurfGrad\n"
                      "output gradient = %13\n"));
    };
    EXPECT_EQ(masks("constant 2"), 0u);
    EXPECT_EQ(masks("parameter 0"), 0u);
    EXPECT_EQ(masks("parameter 1"), 1u);
    EXPECT_EQ(masks("constant -2"), 1u);
}

TEST(Opt, VolumeGradientsAddBeforeOneProjection) {
    std::string text =
        "%0 = vertex_normal : VertexNormal\n%1 = base_normal %0 : Normal\n%2 = volume_object : Volume\n"
        "%3 = noise_perlin %2 : Noise\n%4 = constant 2 : Scalar\n%5 = noise_gradient %4 %3 : LocalGrad\n"
        "%6 = gradient_from_object %5 : VolGrad\n%7 = surfgrad_from_volume %1 %6 : SurfGrad\n"
        "%8 = gradient_from_world %5 : VolGrad\n%9 = surfgrad_from_volume %1 %8 : SurfGrad\n"
        "%10 = add_surfgrad %7 %9 : SurfGrad\noutput gradient = %10\n";
    EXPECT_TRUE(
        optimised(text).ends_with("%8 = add_volgrad %6 %7 : VolGrad\n%9 = surfgrad_from_volume %1 %8 : "
                                  "SurfGrad\noutput gradient = %9\n"))
        << optimised(text);
}

TEST(Opt, EqualValuesBecomeOne) {
    std::string text = kTexture + kSurface +
                       "%8 = sample 0 %4 : Texel\n%9 = decode_normal_xyz 127.5 %8 : TangentNormal\n"
                       "%10 = deriv_from_normal_xyz %9 : Deriv\n%11 = add_deriv %7 %10 : Deriv\n"
                       "%12 = surfgrad_from_tbn %11 %3 : SurfGrad\noutput gradient = %12\n";
    EXPECT_TRUE(optimised(text).ends_with(
        "%7 = add_deriv %6 %6 : Deriv\n%8 = surfgrad_from_tbn %7 %2 : SurfGrad\noutput gradient = %8\n"));
}

TEST(Opt, WhatNoLayerNeedsIsNotShown) {
    std::string text =
        kTexture + kSurface + "output normal = %1\noutput uv 0 = %4\noutput basis_vertex = %3\n";
    EXPECT_EQ(
        optimised(text),
        kTexture + "%0 = vertex_normal : VertexNormal\n%1 = base_normal %0 : Normal\noutput normal = %1\n");
}

// A layer that another covers, one that adds nothing, and one that shows.
TEST(Opt, LayersThatAddNothingAreNotShown) {
    const std::string text =
        kTexture + "texture 1 \"covered\" tangent_normal\n" + kSurface +
        "layer \"covered\" normal_map\n%8 = sample 1 %4 : Texel\n"
        "%9 = decode_normal_xyz 127.5 %8 : TangentNormal\n%10 = deriv_from_normal_xyz %9 : Deriv\n"
        "%11 = surfgrad_from_tbn %10 %3 : SurfGrad\nlayer \"none\" normal_map\n"
        "%12 = surfgrad_from_tbn %7 %3 : SurfGrad\n%13 = constant 0 : Scalar\n"
        "%14 = scale_surfgrad %13 %12 : SurfGrad\nlayer \"shown\" normal_map\n"
        "%15 = surfgrad_from_tbn %7 %3 : SurfGrad\nlayer none\n%16 = constant 1 : Scalar\n"
        "%17 = add_surfgrad %11 %14 : SurfGrad\n%18 = mix_surfgrad %17 %15 %16 : SurfGrad\n"
        "output gradient = %18\noutput layer \"covered\" normal_map = %11\n"
        "output layer \"none\" normal_map = %14\noutput layer \"shown\" normal_map = %15\n";
    const std::string after = optimised(text);
    EXPECT_NE(after.find("output layer \"shown\" normal_map = "), std::string::npos) << after;
    EXPECT_EQ(after.find("covered\" normal_map = "), std::string::npos) << after;
    EXPECT_EQ(after.find("none\" normal_map = "), std::string::npos) << after;
    EXPECT_EQ(after.find("sample 1"), std::string::npos) << after;
}

// What rules make of a layer, and resolves behind it, do not take its view away.
TEST(Opt, LayersOfEveryResolveAreShown) {
    const std::string text =
        kTexture + kSurface +
        "layer \"bricks\" normal_map\n%8 = surfgrad_from_tbn %7 %3 : SurfGrad\nlayer none\n"
        "%9 = resolve %1 %8 : Normal\nlayer \"grain\" noise\n%10 = volume_object : Volume\n"
        "%11 = noise_perlin %10 : Noise\n%12 = constant 2 : Scalar\n%13 = noise_gradient %12 %11 : "
        "LocalGrad\n"
        "%14 = gradient_from_object %13 : VolGrad\n%15 = surfgrad_from_volume %9 %14 : SurfGrad\nlayer none\n"
        "%16 = resolve %9 %15 : Normal\noutput normal = %16\noutput layer \"bricks\" normal_map = %8\n"
        "output layer \"grain\" noise = %15\n";
    const std::string after = optimised(text);
    EXPECT_NE(after.find("output layer \"bricks\" normal_map = "), std::string::npos) << after;
    EXPECT_NE(after.find("output layer \"grain\" noise = "), std::string::npos) << after;
}

// Two channels of one texture, each read by a node of its own; the third coordinate is another.
TEST(Optimise, ReadsATextureOncePerCoordinate) {
    EXPECT_EQ(
        optimised("texture 0 \"t\" mask\n"
                  "%0 = uv_set 0 : Uv\n%1 = constant 3 3 : Vec2\n%2 = uv_scale %0 %1 : Uv\n"
                  "%3 = sample 0 %2 : Texel 'first'\n%4 = channel 0 %3 : Scalar\n"
                  "%5 = constant 3 3 : Vec2\n%6 = uv_scale %0 %5 : Uv\n%7 = sample 0 %6 : Texel 'second'\n"
                  "%8 = channel 1 %7 : Scalar\n%9 = sample 0 %0 : Texel\n%10 = channel 1 %9 : Scalar\n"
                  "output metallic = %4\noutput roughness = %8\noutput occlusion = %10\n"),
        "texture 0 \"t\" mask\n"
        "%0 = uv_set 0 : Uv\n%1 = constant 3 3 : Vec2\n%2 = uv_scale %0 %1 : Uv\n"
        "%3 = sample 0 %2 : Texel 'first'\n%4 = channel 0 %3 : Scalar\n%5 = channel 1 %3 : Scalar\n"
        "%6 = sample 0 %0 : Texel\n%7 = channel 1 %6 : Scalar\n"
        "output metallic = %4\noutput roughness = %5\noutput occlusion = %7\n");
}

}  // namespace
}  // namespace sg::opt

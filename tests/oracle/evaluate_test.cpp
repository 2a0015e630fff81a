// The interpreter by itself: a whole table, one module by hand, the sampler's settings, linear cost.
#include "ir/evaluate.hpp"

#include <gtest/gtest.h>

#include <set>

#include "ir/evaluate_ops.hpp"
#include "ir/text.hpp"
#include "tests/oracle/memory_texture.hpp"

namespace sg::ir {
namespace {

TEST(Evaluate, EveryOperationHasARowOfItsWidths) {
    for (const OpInfo& op : all_ops()) {
        const EvaluateRow* row = evaluate_row(op.op);
        if (!row) {
            ADD_FAILURE() << "no row in compiler/ir/evaluate_ops.cpp for the operation " << op.name;
            continue;
        }
        std::vector<std::string_view> expected;
        for (Type type : op.operands) expected.push_back(info(type).glsl);
        EXPECT_EQ(row->operands, expected) << op.name;
        EXPECT_EQ(row->result, op.result == Type::Any ? "Datum" : info(op.result).glsl) << op.name;
    }
    EXPECT_EQ(all_evaluate_rows().size(), all_ops().size());
}

TEST(Evaluate, EveryTypeHasADatum) {
    const std::set<std::string_view> known(kDatumGlsl.begin(), kDatumGlsl.end());
    for (const TypeInfo& type : all_types()) {
        EXPECT_TRUE(type.glsl.empty() || known.contains(type.glsl)) << type.name;
    }
}

TEST(Evaluate, ComponentsComeInTheOrderOfTheFields) {
    EXPECT_EQ(components(2.5), (std::vector<double>{2.5}));
    EXPECT_EQ(components(ref::Uv{{1, 2}, {3, 4}, {5, 6}}), (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(components(ref::Basis{{1, 2, 3}, {4, 5, 6}}), (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(components(ref::Frame{}).size(), 19u);
}

// A plane with z as normal, T = x and B = -y, one texel everywhere: d = -(0.6, 0) / 0.8, twice as strong.
TEST(Evaluate, OneModuleByHand) {
    std::string fault;
    const auto module = parse(
        "texture 0 \"t\" tangent_normal\nparameter 0 \"strength\" : Scalar\n"
        "%0 = vertex_normal : VertexNormal\n%1 = base_normal %0 : Normal\n%2 = position : Position\n"
        "%3 = frame %2 %1 : Frame\n%4 = uv_set 2 : Uv\n%5 = constant -3 2 : Vec2\n%6 = uv_scale %4 %5 : Uv\n"
        "%7 = sample 0 %6 : Texel\n%8 = decode_normal_xyz 127.5 %7 : TangentNormal\n"
        "%9 = deriv_from_normal_xyz %8 : Deriv\n%10 = parameter 0 : Scalar\n%11 = scale_deriv %10 %9 : "
        "Deriv\n"
        "%12 = basis_uv %3 %6 : Basis\n%13 = surfgrad_from_tbn %11 %12 : SurfGrad\n%14 = resolve %1 %13 : "
        "Normal\n"
        "output normal = %14\noutput gradient = %13\noutput uv 2 = %6\n",
        fault);
    ASSERT_TRUE(module) << fault;
    ASSERT_EQ(verify(*module), "");
    const ref::MemoryTexture texels = oracle::one_texel({0.8, 0.5, 0.9, 1.0});
    Evaluator evaluator(*module, {{{.texels = &texels}}, {2.0}});
    PixelInputs pixel;
    pixel.vertex_normal = {0, 0, 7};
    pixel.uvs[2] = {{0.25, 0.5}, {0.01, 0}, {0, 0.01}};
    EXPECT_EQ(evaluator.run(pixel).size(), module->values.size());

    const auto uv = std::get<ref::Uv>(evaluator.output(Output::uv, 2));
    EXPECT_EQ(uv.st, ref::dvec2(-0.75, 1.0));
    EXPECT_EQ(uv.dy, ref::dvec2(0.0, 0.02));
    // +s runs towards -x; d.x = -0.75 doubled along T = (-1, 0, 0).
    EXPECT_LT(glm::length(std::get<ref::dvec3>(evaluator.output(Output::gradient)) - ref::dvec3(1.5, 0, 0)),
              1e-14);
    const ref::dvec3 normal = glm::normalize(ref::dvec3(-1.5, 0, 1));
    EXPECT_LT(glm::length(std::get<ref::dvec3>(evaluator.output(Output::normal)) - normal), 1e-14);
}

// Texels 0, 1, 2, 3 in a row, one level more that holds 0.5 and 2.5.
ref::MemoryTexture ramp() {
    ref::MemoryTexture texture;
    texture.chain.resize(2);
    texture.chain[0].size = {4, 1};
    texture.chain[1].size = {2, 1};
    for (double x : {0.0, 1.0, 2.0, 3.0}) texture.chain[0].texels.emplace_back(x);
    for (double x : {0.5, 2.5}) texture.chain[1].texels.emplace_back(x);
    return texture;
}

TEST(Evaluate, SamplersWrapAsVulkanSays) {
    const ref::MemoryTexture texture = ramp();
    auto at = [&](Sampled::Wrap wrap, bool linear, double s) {
        const Sampled sampled{&texture, wrap, Sampled::Wrap::repeat, linear};
        return sampled.at({{s, 0.5}, {0.01, 0}, {0, 0}}).x;
    };
    using enum Sampled::Wrap;
    EXPECT_DOUBLE_EQ(at(repeat, true, 0.25), 0.5);
    EXPECT_DOUBLE_EQ(at(repeat, true, 1.0), 1.5);  // between the last and the first
    EXPECT_DOUBLE_EQ(at(clamp, true, 1.0), 3.0);
    EXPECT_DOUBLE_EQ(at(clamp, true, -5.0), 0.0);
    EXPECT_DOUBLE_EQ(at(mirror, true, 1.0), 3.0);
    EXPECT_DOUBLE_EQ(at(mirror, true, 1.25), 2.5);
    EXPECT_DOUBLE_EQ(at(mirror, true, -0.25), 0.5);
    EXPECT_DOUBLE_EQ(at(mirror, true, 2.25), 0.5);
    EXPECT_DOUBLE_EQ(at(repeat, false, 0.49), 1.0);
    EXPECT_DOUBLE_EQ(at(repeat, false, -0.1), 3.0);
    EXPECT_DOUBLE_EQ(at(mirror, false, -0.3), 1.0);
}

TEST(Evaluate, SamplersChooseTheirLevel) {
    const ref::MemoryTexture texture = ramp();
    auto at = [&](Sampled::Mips mips, double texels, double bias) {
        Sampled sampled{.texels = &texture, .mips = mips, .lod_bias = bias};
        return sampled.at({{0.125, 0.5}, {0, 0}, {texels / 4, 0}})
            .x;  // 0 on level 0; 0.75 from 2.5 and 0.5 on level 1
    };
    const double coarse = 0.75 * 0.5 + 0.25 * 2.5;
    using enum Sampled::Mips;
    EXPECT_DOUBLE_EQ(at(linear, 1, 0), 0.0);
    EXPECT_DOUBLE_EQ(at(linear, 0.2, 0), 0.0);
    EXPECT_DOUBLE_EQ(at(linear, 2, 0), coarse);
    EXPECT_DOUBLE_EQ(at(linear, 64, 0), coarse);
    EXPECT_NEAR(at(linear, std::sqrt(2.0), 0), coarse / 2, 1e-12);
    EXPECT_DOUBLE_EQ(at(linear, 1, 0.5), coarse / 2);
    EXPECT_DOUBLE_EQ(at(nearest, 1, 0.5), 0.0);
    EXPECT_DOUBLE_EQ(at(nearest, 1, 0.51), coarse);
    EXPECT_DOUBLE_EQ(at(none, 2, 0), 0.0);
}

}  // namespace
}  // namespace sg::ir

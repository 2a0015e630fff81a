#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "emit/body.hpp"
#include "emit/function.hpp"
#include "emit/glsl.hpp"
#include "emit/names.hpp"
#include "ir/text.hpp"

namespace sg::emit {
namespace {

TEST(Names, KeepTheirPromises) {
    Names names;
    EXPECT_EQ(names.unique("m_", "wall"), "m_wall");
    EXPECT_EQ(names.unique("m_", "wall"), "m_wall_2");
    EXPECT_EQ(names.unique("m_", "a b"), "m_a_b");
    EXPECT_EQ(names.unique("m_", "a.b"), "m_a_b_2");
    EXPECT_EQ(names.unique("m_", "a__b"), "m_a_b_3");
    EXPECT_EQ(names.unique("m_", "\u00e9"), "m_x");
    EXPECT_EQ(names.unique("m_", ""), "m_x_2");
    EXPECT_EQ(names.unique("m_", "float4"), "m_float4");
    EXPECT_EQ(names.unique("m_", "end_"), "m_end");
    EXPECT_EQ(names.unique("m_", std::string(500, 'a')).size(), 50u);
}

TEST(Names, CommentsStayOneLine) {
    EXPECT_EQ(comment_text("a\nb\\ \u00e9*/"), "a?b? ??*/");
}

TEST(Names, LiteralsAreFloats) {
    EXPECT_EQ(float_literal(1), "1.0");
    EXPECT_EQ(float_literal(-0.1), "-0.1");
    EXPECT_EQ(float_literal(1e-7), "1e-07");
    EXPECT_EQ(float_literal(16777216), "16777216.0");
    EXPECT_EQ(float_literal(1e30), "1e+30");
}

std::string body_of(std::string_view text) {
    std::string fault;
    auto module = ir::parse(text, fault);
    EXPECT_TRUE(module) << fault;
    std::vector<std::uint32_t> groups(module->textures.size(), 0);
    MaterialInterface material = material_interface(*module, groups);
    Body body(*module, material);
    return body.text() + "-> " + body.operand(module->outputs[0].value);
}

TEST(Body, ValuesThatAreUsedOnceGetNoName) {
    EXPECT_EQ(
        body_of("%0 = vertex_normal : VertexNormal\n%1 = base_normal %0 : Normal\noutput normal = %1\n"),
        "-> sg_base_normal(sg_in_normal)");
}

TEST(Body, ParenthesesOnlyWhereTheTreeNeedsThem) {
    constexpr std::string_view kHead =
        "%0 = zero_surfgrad : SurfGrad\n%1 = constant 2 : Scalar\n%2 = constant 3 : Scalar\n";
    auto tail = [&](std::string lines) { return body_of(std::string(kHead) + lines); };
    EXPECT_EQ(tail("%3 = add_surfgrad %0 %0 : SurfGrad\n%4 = scale_surfgrad %1 %3 : SurfGrad\noutput "
                   "gradient = %4\n"),
              "-> 2.0 * (vec3(0.0) + vec3(0.0))");
    EXPECT_EQ(tail("%3 = scale_surfgrad %1 %0 : SurfGrad\n%4 = add_surfgrad %0 %3 : SurfGrad\noutput "
                   "gradient = %4\n"),
              "-> vec3(0.0) + 2.0 * vec3(0.0)");
    EXPECT_EQ(tail("%3 = scale_surfgrad %1 %0 : SurfGrad\n%4 = scale_surfgrad %2 %3 : SurfGrad\noutput "
                   "gradient = %4\n"),
              "-> 3.0 * (2.0 * vec3(0.0))");
    EXPECT_EQ(
        tail(
            "%3 = add_surfgrad %0 %0 : SurfGrad\n%4 = add_surfgrad %3 %0 : SurfGrad\noutput gradient = %4\n"),
        "-> vec3(0.0) + vec3(0.0) + vec3(0.0)");
}

TEST(Interface, BlocksFollowStd140) {
    std::string fault;
    auto module = ir::parse(
        "parameter 0 \"a\" : Scalar\nparameter 1 \"b\" : Vec3\nparameter 2 \"c\" : Scalar\nparameter 3 \"d\" "
        ": Vec2\n"
        "parameter 4 \"e\" : Vec4\n",
        fault);
    ASSERT_TRUE(module) << fault;
    MaterialInterface material = material_interface(*module, {});
    std::vector<std::uint32_t> offsets;
    for (const ParameterSlot& slot : material.parameters) offsets.push_back(slot.offset);
    EXPECT_EQ(offsets, (std::vector<std::uint32_t>{0, 16, 28, 32, 48}));
    EXPECT_EQ(material.block_size, 64u);
}

TEST(Interface, TexturesThatSampleAlikeShareASampler) {
    std::string fault;
    auto module = ir::parse(
        "texture 0 \"a\" tangent_normal\ntexture 1 \"unused\" tangent_normal\ntexture 2 \"b\" "
        "tangent_normal\n"
        "texture 3 \"c\" tangent_normal\n%0 = uv_set 0 : Uv\n%1 = sample 0 %0 : Texel\n%2 = sample 2 %0 : "
        "Texel\n"
        "%3 = sample 3 %0 : Texel\n",
        fault);
    ASSERT_TRUE(module) << fault;
    const std::uint32_t groups[] = {0, 1, 1, 0};
    MaterialInterface material = material_interface(*module, groups);
    ASSERT_EQ(material.textures.size(), 3u);
    EXPECT_EQ(material.textures[1].binding, 2u);
    ASSERT_EQ(material.samplers.size(), 2u);
    EXPECT_EQ(material.samplers[1].binding, 5u);
    EXPECT_EQ(material.textures[2].sampler, 0u);
    EXPECT_EQ(material.texture(1), nullptr);
}

TEST(EntryPoints, AreFoundByName) {
    EXPECT_EQ(find_entry_point("normal")->name, "normal");
    EXPECT_EQ(find_entry_point("none"), nullptr);
}

// What the stages give must come through the function's arguments.
TEST(Function, HasAWordingForAllThatTheStagesGive) {
    for (const ir::OpInfo& op : ir::all_ops()) {
        const auto rows = function_wordings();
        auto row =
            std::find_if(rows.begin(), rows.end(), [&](const FunctionWording& w) { return w.op == op.op; });
        bool of_stage = is_varying(op.op) || op.include.starts_with("stage/") ||
                        op.glsl.find("sg_in_") != op.glsl.npos || op.glsl.find("_block") != op.glsl.npos;
        EXPECT_EQ(row != rows.end(), of_stage) << op.name << ": compiler/emit/function.cpp, kWordings";
        if (row == rows.end()) continue;
        EXPECT_FALSE(row->include.starts_with("stage/")) << op.name;
    }
}

TEST(Function, ReadsOnlyFieldsThatExist) {
    for (const FunctionWording& row : function_wordings()) {
        const std::string glsl(row.glsl), mark = "sg_inputs.";
        for (std::size_t at = glsl.find(mark); at != glsl.npos; at = glsl.find(mark, at + 1)) {
            std::string name;
            for (std::size_t i = at + mark.size();
                 i < glsl.size() && (std::isalnum(glsl[i]) || glsl[i] == '_'); ++i)
                name += glsl[i];
            if (name == "uv") continue;  // the set follows
            const auto fields = function_inputs();
            EXPECT_TRUE(std::any_of(fields.begin(), fields.end(), [&](const auto& f) {
                return f.name == name;
            })) << name;
        }
    }
}

}  // namespace
}  // namespace sg::emit

// The manifest's expressions of parameters: read, refused, computed.
#include "runtime/expression.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstring>

#include "runtime/parameters.hpp"
#include "tests/unit/runtime/sample_artefact.hpp"

namespace sg::runtime {
namespace {

// The sample's block (tint: color at 0, gain: float at 12) with one derived parameter behind it.
std::string manifest(const std::string& expression, const std::string& type = "vec4",
                     const std::string& steps = "[]", int offset = 16) {
    std::string text = test::sample_manifest();
    const std::string block = "\"size\": 16, \"parameters\"";
    const std::size_t at = text.find(block);
    EXPECT_NE(at, std::string::npos);
    return text.replace(
        at, block.size(),
        fmt::format(R"("size": 32, "steps": {}, "derived": [{{"name": "d", "type": "{}", "offset": {}, )"
                    R"("default": [0], "expression": {}}}], "parameters")",
                    steps, type, offset, expression));
}

// The derived numbers for tint = 0.25, 0.5, 2 and gain = 3.
std::vector<float> computed(const std::string& text) {
    Diags diags;
    auto artefact = read_manifest(text, "m.json", diags);
    if (!artefact) return {};
    auto block = pack_parameters(*artefact, std::vector<std::string>{"tint=0.25,0.5,2", "gain=3"}, diags);
    if (!block) return {};
    std::vector<float> out(artefact->parameters->derived.at(0).count);
    std::memcpy(out.data(), block->data() + 16, out.size() * sizeof(float));
    return out;
}

using Floats = std::vector<float>;

TEST(Expression, EachWord) {
    EXPECT_EQ(computed(manifest(R"(["add", "$tint", 1])", "color")), (Floats{1.25f, 1.5f, 3}));
    EXPECT_EQ(computed(manifest(R"(["subtract", 1, "$gain"])", "float")), Floats{-2});
    EXPECT_EQ(computed(manifest(R"(["multiply", "$tint", [2, 3, 4]])", "color")), (Floats{0.5f, 1.5f, 8}));
    EXPECT_EQ(computed(manifest(R"(["divide", "$gain", 2])", "float")), Floats{1.5f});
    EXPECT_EQ(computed(manifest(R"(["divide", "$gain", 0])", "float")), Floats{0});
    EXPECT_EQ(computed(manifest(R"(["minimum", "$tint", 0.5])", "color")), (Floats{0.25f, 0.5f, 0.5f}));
    EXPECT_EQ(computed(manifest(R"(["maximum", "$tint", 0.5])", "color")), (Floats{0.5f, 0.5f, 2}));
    EXPECT_EQ(computed(manifest(R"(["mix", "$gain", 7, 0.25])", "float")), Floats{4});
    EXPECT_EQ(computed(manifest(R"(["clamp", "$tint", 0.3, 1])", "color")), (Floats{0.3f, 0.5f, 1}));
    EXPECT_EQ(computed(manifest(R"(["clamp", 0.5, 1, 0])", "float")), Floats{0});  // the upper bound wins
    EXPECT_EQ(computed(manifest(R"(["smoothstep", 0, 2, "$tint"])", "color")),
              (Floats{0.04296875f, 0.15625f, 1}));
    EXPECT_EQ(computed(manifest(R"(["smoothstep", 3, 3, "$gain"])", "float")), Floats{1});
    EXPECT_EQ(computed(manifest(R"(["power", "$gain", 2])", "float")), Floats{9});
    EXPECT_EQ(computed(manifest(R"(["power", -1, 2])", "float")), Floats{0});
    EXPECT_EQ(computed(manifest(R"(["channel", "$tint", 1])", "float")), Floats{0.5f});
    EXPECT_EQ(computed(manifest(R"(["rgb", [1, 2, 3, 4]])", "color")), (Floats{1, 2, 3}));
    EXPECT_EQ(computed(manifest(R"(["unit", [3, 0, -4]])", "color")), (Floats{0.6f, 0, -0.8f}));
    EXPECT_EQ(computed(manifest(R"(["unit", [0, 0, 0]])", "color")), (Floats{0, 0, 0}));
    EXPECT_EQ(computed(manifest(R"(["unit", [0, 5e-16, 0]])", "color")), (Floats{0, 0.5f, 0}));
    EXPECT_EQ(expression_words().size(), 10u);
}

TEST(Expression, StepsNumbersAndWhatABlockHolds) {
    EXPECT_EQ(computed(manifest(R"(["multiply", "#1", "#0"])", "float",
                                R"([["add", "$gain", 1], ["multiply", "#0", 10]])")),
              Floats{160});
    EXPECT_EQ(computed(manifest("[1, 2, 3, 4]")), (Floats{1, 2, 3, 4}));
    EXPECT_EQ(computed(manifest("5")), (Floats{5, 5, 5, 5}));  // a single number stands for all
    EXPECT_EQ(computed(manifest(R"(["power", 1e200, "$gain"])", "float")), Floats{3.40282347e38f});
    EXPECT_EQ(computed(manifest(R"(["subtract", ["power", 1e200, 2], ["power", 1e200, 2]])", "float")),
              Floats{0});
}

// Each with the whole first line behind the place.
TEST(Expression, WhatIsRefused) {
    auto message = [](const std::string& text) {
        Diags diags;
        EXPECT_FALSE(read_manifest(text, "m.json", diags)) << text.substr(0, 2000);
        return diags.has_errors() ? diags.all()[0].message : "";
    };
    const std::string at = "'/parameter_block/derived/0/expression";
    EXPECT_EQ(
        message(manifest(R"(["sine", 1])")),
        at + "/0' is 'sine', expected 'add', 'subtract', 'multiply', 'divide', 'minimum', 'maximum', 'mix', "
             "'clamp', 'smoothstep', 'power', 'channel', 'rgb', 'row' or 'unit'");
    EXPECT_EQ(message(manifest(R"(["add", 1])")), at + "/0' must have 2 behind it");
    EXPECT_EQ(message(manifest(R"(["channel", "$tint"])")), at + "/0' must have 2 behind it");
    EXPECT_EQ(message(manifest(R"("$tont")")),
              at + "' is '$tont', neither '$' with a parameter nor '#' with an earlier step");
    EXPECT_EQ(message(manifest(R"("#0")")),
              at + "' is '#0', neither '$' with a parameter nor '#' with an earlier step");
    EXPECT_EQ(message(manifest(R"(["add", "$tint", [1, 2]])", "color")),
              at + "' mixes vectors of different lengths");
    EXPECT_EQ(message(manifest(R"(["channel", "$tint", 3])", "float")),
              at + "' mixes vectors of different lengths");
    EXPECT_EQ(message(manifest(R"(["rgb", "$gain"])", "color")), at + "' mixes vectors of different lengths");
    EXPECT_EQ(message(manifest(R"(["unit", "$gain"])", "color")),
              at + "' mixes vectors of different lengths");
    EXPECT_EQ(message(manifest("[]")), at + "' must hold one to four values");
    EXPECT_EQ(message(manifest("{}")), at + "' must be a text");
    EXPECT_EQ(message(manifest(R"("$tint")", "float")),
              "'/parameter_block/derived/0' is of 3 numbers, expected 1");
    EXPECT_EQ(message(manifest("1", "vec4", "[]", 20)),
              "'/parameter_block/derived/0' lies outside its block");
    EXPECT_EQ(
        message(manifest("1", "vec4", R"(["#0"])")),
        "'/parameter_block/steps/0' is '#0', neither '$' with a parameter nor '#' with an earlier step");
}

// The sample's block with a matrix behind its two parameters, and a derived number behind that.
std::string with_matrix(const std::string& expression) {
    std::string text = test::sample_manifest();
    auto replace = [&](const std::string& from, const std::string& to) {
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos);
        text.replace(at, from.size(), to);
    };
    replace("\"size\": 16, \"parameters\": [",
            fmt::format(R"("size": 96, "derived": [{{"name": "d", "type": "float", "offset": 80, )"
                        R"("default": [0], "expression": {}}}], "parameters": [)"
                        R"({{"name": "place", "type": "mat4", "offset": 16, )"
                        R"("default": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16]}}, )",
                        expression));
    return text;
}

TEST(Expression, OfAMatrixOnlyRowsAreTaken) {
    Diags diags;
    auto artefact = read_manifest(with_matrix(R"(["multiply", "$gain", 2])"), "m.json", diags);
    ASSERT_TRUE(artefact) << render(diags);
    auto floats = [&](const std::vector<std::string>& settings) {
        auto block = pack_parameters(*artefact, settings, diags);
        std::vector<float> out(block ? 24 : 0);
        if (block) std::memcpy(out.data(), block->data(), out.size() * sizeof(float));
        return out;
    };
    EXPECT_EQ(floats({"gain=3"}),
              (Floats{1, 1, 1, 3, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 6, 0, 0, 0}));
    EXPECT_EQ(floats({"place=0,1,0,0,-1,0,0,0,0,0,1,0,0.5,2,-3,1"}),
              (Floats{1, 1, 1, 0.5f, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0.5f, 2, -3, 1, 1, 0, 0, 0}));
    auto row = read_manifest(with_matrix(R"(["channel", ["row", "$place", 2], 1])"), "m.json", diags);
    ASSERT_TRUE(row) << render(diags);
    auto block = pack_parameters(*row, {}, diags);
    float derived = 0;
    std::memcpy(&derived, block->data() + 80, sizeof derived);
    EXPECT_EQ(derived, 7);
    EXPECT_FALSE(diags.has_errors());
    EXPECT_TRUE(floats({"place=1,0,0,0"}).empty());
    EXPECT_EQ(diags.all().back().message,
              "parameter 'place' is a mat4: expected 16 numbers separated by commas, not '1,0,0,0'");

    auto message = [](const std::string& expression) {
        Diags refused;
        EXPECT_FALSE(read_manifest(with_matrix(expression), "m.json", refused)) << expression;
        return refused.has_errors() ? refused.all()[0].message : "";
    };
    const std::string at = "'/parameter_block/derived/0/expression/1";
    EXPECT_EQ(message(R"(["channel", "$place", 0])"),
              at + "' is '$place', a matrix, of which an expression only takes a 'row'");
    EXPECT_EQ(message(R"(["channel", ["row", "$gain", 0], 0])"),
              at + "/1' is '$gain', expected a parameter that is a matrix");
    EXPECT_EQ(message(R"(["channel", ["row", "$place", 3], 0])"), at + "/2' must be a number from 0 to 2");
}

}  // namespace
}  // namespace sg::runtime

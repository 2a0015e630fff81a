// Graphs that no one writes by hand: deep, and with so much sharing that their tree would be exponential.
#include <gtest/gtest.h>

#include "base/limits.hpp"
#include "emit/glsl.hpp"
#include "opt/optimise.hpp"
#include "stages.hpp"
#include "tests/bench/graphs.hpp"

namespace sg {
namespace {

constexpr std::size_t kNodes = 20000;

std::string fragment_of(std::string text) {
    MemoryFiles files;
    Diags diags;
    auto checked = read_and_check(std::make_shared<Source>(Source{"graph.json", std::move(text)}), {{"/m"}},
                                  files, diags);
    EXPECT_TRUE(checked) << render(diags);
    if (!checked) return "";
    const emit::EntryPoint& entry = *emit::find_entry_point("forward");
    ir::Module module = opt::optimise(material::lower(*checked));
    EXPECT_GE(module.values.size(), kNodes);
    return emit::emit_glsl(opt::select_outputs(module, emit::needed_outputs(entry, module)), entry,
                           emit::material_interface(module, {}))
        .fragment;
}

TEST(LargeGraphs, DeepAndShared) {
    EXPECT_LT(fragment_of(bench::shared_graph(kNodes)).size(), 60 * kNodes);
}

TEST(LargeGraphs, WithoutNames) {
    EXPECT_LT(fragment_of(bench::nameless_graph(kNodes)).size(), 60 * kNodes);
}

// As many parameters of a type as `count`, and what the checker says of them.
std::string check_parameters(const std::string& type, const std::string& value, std::size_t count) {
    std::string text = R"({ "version": 1, "parameters": {)";
    for (std::size_t i = 0; i < count; ++i)
        text += (i > 0 ? ",\n\"p" : "\n\"p") + std::to_string(i) + R"(": { "type": ")" + type +
                R"(", "default": )" + value + " }";
    MemoryFiles files;
    Diags diags;
    auto checked = read_and_check(std::make_shared<Source>(Source{"many.json", text + " } }\n"}), {{"/m"}},
                                  files, diags);
    if (checked) {
        const auto interface = emit::material_interface(opt::optimise(material::lower(*checked)), {});
        EXPECT_LE(interface.block_size, kMaxBlockBytes);
    }
    return render(diags);
}

TEST(LargeBlocks, AreRefusedAtTheParameterThatGoesBeyond) {
    const std::string matrix = "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]";
    EXPECT_EQ(check_parameters("mat4", matrix, 192), "");
    EXPECT_EQ(check_parameters("mat4", matrix, 194),
              "many.json:194:1: error: 12416 bytes of parameters, expected at most 12288 [SG1208]\n"
              "\"p192\": { \"type\": \"mat4\", \"default\": " +
                  matrix +
                  " },\n"
                  "^^^^^^\n"
                  "    at /parameters/p192: use fewer\n");
    EXPECT_EQ(check_parameters("float", "0", 3072), "");
    EXPECT_NE(check_parameters("float", "0", 3073), "");
    EXPECT_EQ(check_parameters("color", "[0, 0, 0]", 768), "");
    EXPECT_NE(check_parameters("color", "[0, 0, 0]", 769), "");
}

// A full block still has room for all that is derived.
TEST(LargeBlocks, HaveRoomForWhatIsDerived) {
    std::string text = R"({ "version": 1, "parameters": {)";
    for (std::size_t i = 0; i < 768; ++i)
        text += (i > 0 ? ", \"p" : " \"p") + std::to_string(i) +
                R"(": { "type": "color", "default": [0, 0, 0] })";
    text += R"( }, "nodes": { "n0": "$p0")";
    for (std::size_t i = 1; i < 768; ++i) {
        const std::string number = std::to_string(i);
        text += ", \"m" + number + R"(": { "op": "multiply_color", "a": "$p)" + number + R"(", "b": "$p)" +
                std::to_string(i - 1) + R"(" }, "n)" + number + R"(": { "op": "add_color", "a": "@n)" +
                std::to_string(i - 1) + R"(", "b": { "op": "multiply_color", "a": "@m)" + number +
                R"(", "b": { "op": "vertex_rgb" } } })";
    }
    text += R"( }, "surface": { "emission": "@n767" } })";
    MemoryFiles files;
    Diags diags;
    auto checked =
        read_and_check(std::make_shared<Source>(Source{"many.json", text}), {{"/m"}}, files, diags);
    ASSERT_TRUE(checked) << render(diags);
    const ir::Module module = opt::optimise(material::lower(*checked));
    EXPECT_EQ(module.derived.size(), 256u);
    EXPECT_EQ(emit::material_interface(module, {}).block_size, kMaxBlockBytes);
}

}  // namespace
}  // namespace sg

#include <gtest/gtest.h>

#include "target/spirv.hpp"

namespace sg::target {
namespace {

constexpr std::string_view kHead = "#version 450\n#extension GL_GOOGLE_include_directive : require\n";

std::string fault_of(const std::string& body) {
    std::string fault;
    ShaderLibrary library{{{"lib/a.glsl", "float sg_a() { return b; }\n"}}};
    auto words = compile_glsl(std::string(kHead) + body, "x.frag", Stage::fragment, library, {}, fault);
    return words ? "fine" : fault;
}

TEST(Spirv, FaultsNameTheirFileAndLine) {
    EXPECT_EQ(fault_of("void main() {\n  float x = y;\n}\n"), "x.frag:4: 'y' : undeclared identifier ");
    EXPECT_EQ(fault_of("#include \"lib/a.glsl\"\nvoid main() {}\n"),
              "lib/a.glsl:1: 'b' : undeclared identifier ");
    EXPECT_NE(fault_of("#include \"lib/none.glsl\"\nvoid main() {}\n").find("x.frag:3:"), std::string::npos);
    EXPECT_EQ(fault_of("void main() {}\n"), "fine");
}

TEST(Spirv, EveryLibraryFileCompilesAlone) {
    ShaderLibrary library = embedded_library();
    ASSERT_GT(library.files.size(), 8u);
    for (const auto& [name, text] : library.files) {
        Stage stage = name == "stage/vertex.glsl" ? Stage::vertex : Stage::fragment;
        std::string fault;
        EXPECT_TRUE(compile_glsl(std::string(kHead) + "#include \"" + name + "\"\nvoid main() {}\n", name,
                                 stage, library, {}, fault))
            << fault;
    }
}

TEST(Spirv, OptimisingDoesNotGrowAndValidates) {
    std::string text = std::string(kHead) +
                       "#include \"surfgrad/resolve.glsl\"\nlayout(location = 0) in vec3 n;\nlayout(location "
                       "= 0) out vec4 o;\n"
                       "void main() { o = vec4(sg_resolve(n, n.yzx), 1.0); }\n";
    ShaderLibrary library = embedded_library();
    std::string fault;
    auto raw = compile_glsl(text, "t", Stage::fragment, library, {.optimise = Optimise::none}, fault);
    auto fast = compile_glsl(text, "t", Stage::fragment, library, {.optimise = Optimise::speed}, fault);
    auto small = compile_glsl(text, "t", Stage::fragment, library, {.optimise = Optimise::size}, fault);
    ASSERT_TRUE(raw && fast && small) << fault;
    EXPECT_LT(instruction_count(*fast), instruction_count(*raw));
    EXPECT_LT(small->size(), fast->size());  // names are gone
    EXPECT_EQ(disassemble(*small).find("OpName"), std::string::npos);
    EXPECT_EQ(bytes(*fast).size(), fast->size() * 4);
    EXPECT_EQ(bytes(*fast).substr(0, 4), "\x03\x02\x23\x07");
}

TEST(Spirv, ValidatorRefusesGarbage) {
    Words words{0x07230203, 0x00010300, 0, 5, 0, 0xFFFFFFFF};
    EXPECT_NE(validate(words), "");
}

}  // namespace
}  // namespace sg::target

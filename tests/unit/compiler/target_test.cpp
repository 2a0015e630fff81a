#include <gtest/gtest.h>

#include "target/spirv.hpp"
#include "target/usage.hpp"

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

// Every kind of read, and every kind of query.
TEST(Spirv, ReadsAreCountedAndQueriesAreNot) {
    const std::string head =
        "#extension GL_ARB_sparse_texture2 : require\n"
        "layout(set = 0, binding = 0) uniform sampler2D t;\n"
        "layout(set = 0, binding = 1) uniform sampler2DShadow d;\n"
        "layout(location = 0) in vec2 p;\n"
        "layout(location = 0) out vec4 o;\n";
    auto reads = [&](const std::string& expression) {
        std::string fault;
        auto words = compile_glsl(std::string(kHead) + head + "void main() { vec4 v = vec4(0.0); o = vec4(" +
                                      expression + ") + v; }\n",
                                  "t", Stage::fragment, {}, {}, fault);
        EXPECT_TRUE(words) << fault;
        return words ? usage(*words).texture_reads : 0;
    };
    for (const char* one :
         {"texture(t, p)", "textureLod(t, p, 0.0)", "textureGrad(t, p, p, p)", "texture(d, p.xyx)",
          "textureLod(d, p.xyx, 0.0)", "textureProj(t, p.xyx)", "textureProjLod(t, p.xyx, 0.0)",
          "textureProj(d, p.xyxy)", "textureProjLod(d, p.xyxy, 0.0)", "texelFetch(t, ivec2(p), 0)",
          "textureGather(t, p)", "textureGather(d, p, 0.5)", "sparseTextureARB(t, p, v)",
          "sparseTextureLodARB(t, p, 0.0, v)", "sparseTexelFetchARB(t, ivec2(p), 0, v)",
          "sparseTextureGatherARB(t, p, v)", "sparseTextureGatherARB(d, p, 0.5, v)",
          "vec4(sparseTexelsResidentARB(sparseTextureARB(t, p, v)))"}) {
        EXPECT_EQ(reads(one), 1u) << one;
    }
    for (const char* none :
         {"textureSize(t, int(p.x)), p", "textureQueryLod(t, p), p", "textureQueryLevels(t)", "p, p"}) {
        EXPECT_EQ(reads(none), 0u) << none;
    }
    EXPECT_EQ(reads("texture(t, p) + texture(t, p.yx) * textureGather(t, p)"), 3u);
}

TEST(Spirv, InputsAreCountedAsTheModuleKeepsThem) {
    std::string fault;
    auto words = compile_glsl(std::string(kHead) +
                                  "layout(location = 0) in float a;\nlayout(location = 2) in vec2 b;\n"
                                  "layout(location = 3) in vec4 c;\nlayout(location = 5) in vec3 unused;\n"
                                  "layout(location = 6) flat in ivec3 d;\n"
                                  "layout(location = 0) out vec4 o;\n"
                                  "void main() { o = vec4(a, b, c.w) + 0.0 * unused.xyzz + gl_FragCoord + "
                                  "vec4(d, 0.0); }\n",
                              "t", Stage::fragment, {}, {}, fault);
    ASSERT_TRUE(words) << fault;
    const Usage used = usage(*words);
    EXPECT_EQ(used.inputs, (std::map<std::uint32_t, std::uint32_t>{{0, 1}, {2, 2}, {3, 4}, {6, 3}}));
    EXPECT_EQ(used.input_numbers(), 10u);
}

TEST(Spirv, ValidatorRefusesGarbage) {
    Words words{0x07230203, 0x00010300, 0, 5, 0, 0xFFFFFFFF};
    EXPECT_NE(validate(words), "");
}

}  // namespace
}  // namespace sg::target

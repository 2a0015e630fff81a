// GLSL of the user's own: what is refused never reaches a shader, what is accepted always compiles, whatever
// names it uses.
#include <gtest/gtest.h>

#include <random>

#include "compile.hpp"
#include "custom/user_glsl.hpp"
#include "tests/support/golden.hpp"

namespace sg {
namespace {

const target::ShaderLibrary kLibrary = target::embedded_library();

std::string material(const std::string& layers) {
    return R"({ "version": 1, "textures": { "x": { "file": "x.png", "encoding": "height" } },
  "parameters": { "x": { "type": "float", "default": 1 } },
  "bump": [ { "layers": [ )" +
           layers + " ] } ] }\n";
}

std::string layer(const std::string& file, const std::string& function, const std::string& arguments) {
    return R"({ "id": "x", "kind": "custom", "file": ")" + file + R"(", "function": ")" + function +
           R"(", "returns": "surface_gradient", "arguments": [ )" + arguments + " ] }";
}

struct Result {
    std::optional<Compiled> compiled;
    std::string messages;
};
Result compile(const std::string& json, std::map<std::string, std::string> shaders,
               std::vector<std::pair<std::string, std::string>> defines = {},
               std::vector<std::string> targets = {"spirv"}) {
    MemoryFiles files;
    files.contents["/m/x.png"] = "";
    for (auto& [name, text] : shaders) files.contents["/m/" + name] = text;
    CompileRequest request{.source = std::make_shared<Source>(Source{"wall.json", json}),
                           .stem = "wall",
                           .roots = {"/m"},
                           .entries = {"normal"},
                           .targets = target::select_targets(targets),
                           .defines = std::move(defines)};
    Diags diags;
    auto out = compile_material(request, files, kLibrary, diags);
    EXPECT_EQ(out.has_value(), !diags.has_errors());
    return {std::move(out), render(diags)};
}

std::string fragment(const Result& result) {
    return result.compiled ? result.compiled->glsl.at(1).text : result.messages;
}

// Names that the generated text uses itself, and names of the language that the file takes for its own.
TEST(CustomGlsl, NamesCollideWithNothing) {
    const std::string text = R"(
#define vec4(x) vec3(x)
struct SurfaceGradient { vec3 m_x; };
const float s_0 = 1.0, p_x = 2.0;
float t_x(float m_x) { return m_x * s_0; }
float mix(float a, float b) { return a * b + p_x; }
vec3 m_x(SgFrame m_normal, texture2D x, sampler s, SgUv uv, float sg_material) {
    SurfaceGradient out_value = SurfaceGradient(t_x(mix(sg_material, uv.st.x)) * textureGrad(sampler2D(x, s), uv.st, uv.dx, uv.dy).xyz);
    return out_value.m_x;
}
)";
    const std::string call = R"("frame", { "texture": "x" }, { "uv": 0 }, "$x")";
    Result result = compile(material(layer("a.glsl", "m_x", call)), {{"a.glsl", text}});
    ASSERT_TRUE(result.compiled) << result.messages;
    EXPECT_NE(fragment(result).find("const float c_s_0 = 1.0, c_p_x = 2.0;"), std::string::npos);
}

// A texture alone is handed over; with anything beside it, it is read.
TEST(CustomGlsl, ATextureIsHandedOverOrRead) {
    auto messages = [](const std::string& types, const std::string& argument) {
        const std::string json = R"({ "version": 1,
  "textures": { "x": { "file": "x.png", "encoding": "color" } },
  "bump": [ { "layers": [ )" + layer("a.glsl", "f", "\"frame\", " + argument) +
                                 " ] } ] }\n";
        return compile(json, {{"a.glsl", "vec3 f(SgFrame frame, " + types + ") { return vec3(0); }\n"}})
            .messages;
    };
    EXPECT_EQ(messages("texture2D t, sampler s", R"({ "texture": "x" })"), "");
    EXPECT_EQ(messages("float x", R"({ "texture": "x", "channel": "r" })"), "");
    EXPECT_EQ(messages("float x", R"({ "texture": "x", "channel": "r", "uv": 1 })"), "");
    EXPECT_EQ(messages("vec3 x", R"({ "texture": "x", "uv": 1 })"), "");
    EXPECT_EQ(messages("vec3 x", R"({ "uv": 1, "texture": "x" })"), "");
    EXPECT_EQ(messages("vec3 x", R"({ "texture": "x", "tiling": 2 })"), "");
    EXPECT_NE(messages("vec3 x", R"({ "texture": "x" })"), "");
}

// The macro of a struct's member is renamed with the rest; a member behind a dot is not.
TEST(CustomGlsl, MembersKeepTheirNames) {
    const std::string text =
        "const float position = 2.0;\nvec3 f(SgFrame frame) { return position * frame.position; }\n";
    Result result = compile(material(layer("a.glsl", "f", "\"frame\"")), {{"a.glsl", text}});
    EXPECT_NE(fragment(result).find("return c_position * frame.position;"), std::string::npos)
        << fragment(result);
}

TEST(CustomGlsl, TwoFilesMayUseOneName) {
    auto text = [](const char* number) {
        return std::string("float helper() { return ") + number +
               "; }\nvec3 f(SgFrame frame) { return helper() * frame.sigma_x; }\n";
    };
    std::string second = layer("b.glsl", "f", "\"frame\"");
    second.replace(second.find("\"x\""), 3, "\"y\"");
    Result result = compile(material(layer("a.glsl", "f", "\"frame\"") + ", " + second),
                            {{"a.glsl", text("1.0")}, {"b.glsl", text("2.0")}});
    EXPECT_NE(fragment(result).find("float c2_helper() { return 2.0; }"), std::string::npos)
        << fragment(result);
    EXPECT_NE(fragment(result).find("c2_f(m_frame)"), std::string::npos) << fragment(result);
}

TEST(CustomGlsl, MacrosOfTheCommandLine) {
    const std::string text =
        "#ifndef DEPTH\n#define DEPTH 1.0\n#endif\nvec3 f(SgFrame frame) { return DEPTH * frame.sigma_x; }\n";
    const std::string json = material(layer("a.glsl", "f", "\"frame\""));
    EXPECT_EQ(fragment(compile(json, {{"a.glsl", text}}, {{"UNUSED", "1"}})).find("UNUSED"),
              std::string::npos);
    std::string defined = fragment(compile(json, {{"a.glsl", text}}, {{"DEPTH", "2.0"}}));
    EXPECT_NE(defined.find("#define c_DEPTH 2.0\n"), std::string::npos) << defined;
    EXPECT_EQ(compile(json, {{"a.glsl", text}}, {{"DEPTH", "2.0.0.0"}}).messages.substr(0, 15),
              "a.glsl:4:32: er");
    std::string last = fragment(compile(json, {{"a.glsl", text}}, {{"DEPTH", "2.0"}, {"DEPTH", "3.0"}}));
    EXPECT_EQ(last.find("#define c_DEPTH 2.0\n"), std::string::npos) << last;
    EXPECT_NE(last.find("#define c_DEPTH 3.0\n"), std::string::npos) << last;
    EXPECT_EQ(custom::define_fault("DEPTH", "2.0 + (1.0)"), "");
    for (auto [name, value] : {std::pair{"sg_x", "1"},
                               {"1X", "1"},
                               {"A B", "1"},
                               {"", "1"},
                               {"X(a)", "a"},
                               {"X", "1\n#define Y"},
                               {"X", "1 // "},
                               {"X", "\\"},
                               {"X", "dFdx(1.0)"},
                               {"X", "}"},
                               {"X", ") ("},
                               {"X", "#"},
                               {"X", "\"a\""},
                               {"main", "1"}}) {
        EXPECT_NE(custom::define_fault(name, value), "") << name << "=" << value;
    }
}

// What one language lacks is that language's error, not ours.
TEST(CustomGlsl, ThatATargetCannotExpress) {
    const std::string text =
        "vec3 f(vec3 n, texture2D x, sampler s, SgUv uv) { return textureGather(sampler2D(x, s), uv.st, "
        "1).xyz; }\n";
    const std::string json = material(layer("a.glsl", "f", R"("normal", { "texture": "x" }, { "uv": 0 })"));
    EXPECT_TRUE(compile(json, {{"a.glsl", text}}).compiled);
    EXPECT_EQ(
        compile(json, {{"a.glsl", text}}, {}, {"essl300"}).messages,
        "error: 'wall.normal' gathers texels of another channel than red, with offsets or with a comparison "
        "(textureGather), which essl300 cannot express [SG1401]\n");
}

TEST(CustomGlsl, WithoutEquivalentHasNoReference) {
    const std::string text = "vec3 f(SgFrame frame) { return frame.sigma_x; }\n";
    std::string call = layer("a.glsl", "f", "\"frame\"");
    Result without = compile(material(call), {{"a.glsl", text}});
    ASSERT_TRUE(without.compiled) << without.messages;
    EXPECT_EQ(without.compiled->reference_ir, "");
    call.insert(call.size() - 2, R"(, "equivalent": { "kind": "noise" })");
    Result with = compile(material(call), {{"a.glsl", text}});
    ASSERT_TRUE(with.compiled) << with.messages;
    EXPECT_NE(with.compiled->reference_ir.find("noise_fractal_sum"), std::string::npos);
    EXPECT_EQ(with.compiled->reference_ir.find("custom_"), std::string::npos);
    EXPECT_EQ(with.compiled->ir.find("noise_"), std::string::npos);
}

// A generated shader brings what the arguments need and no more.
TEST(CustomGlsl, TypesOfTheLibraryNeedTheirFile) {
    const std::string text =
        "vec3 f(vec3 n, float x) {\n    SgBasis basis;\n    return basis.tangent * x;\n}\n";
    const std::string json = material(layer("a.glsl", "f", "\"normal\", \"$x\""));
    EXPECT_EQ(
        compile(json, {{"a.glsl", text}}).messages,
        R"(a.glsl:2:5: error: 'SgBasis' : undeclared identifier; #include "surfgrad/tbn.glsl" declares it [SG1601]
    SgBasis basis;
    ^^^^^^^
    fix the text at the place that the caret marks; the words are glslang's
)");
    EXPECT_TRUE(compile(json, {{"a.glsl", "#include \"surfgrad/tbn.glsl\"\n" + text}}).compiled);
}

// ---- where messages point ----

// What is said of a file whose function `f` a layer calls with a point of object space.
std::string said_of(const std::string& text) {
    std::string json = material(layer("a.glsl", "f", "\"object\""));
    const std::string_view gives = "surface_gradient";
    json.replace(json.find(gives), gives.size(), "volume_gradient");
    return compile(json, {{"a.glsl", text}}).messages;
}
// A message of glslang's at a place of that file.
std::string glsl_fault(const std::string& number, const std::string& what, const std::string& line,
                       std::size_t column, std::size_t width) {
    return "a.glsl:" + number + ":" + std::to_string(column) + ": error: " + what + " [SG1601]\n" + line +
           "\n" + std::string(column - 1, ' ') + std::string(width, '^') +
           "\n    fix the text at the place that the caret marks; the words are glslang's\n";
}
const std::string kNoSemicolon = "syntax error, unexpected RIGHT_BRACE, expecting COMMA or SEMICOLON";

TEST(CustomGlsl, AMessageIsWhole) {
    EXPECT_EQ(said_of("vec3 f(SgVolume o) {\n    vec2 a = o.p;\n    return o.p;\n}\n"),
              glsl_fault("2",
                         "'=' :  cannot convert from ' global highp 3-component vector of float' to ' temp "
                         "highp 2-component vector of float'",
                         "    vec2 a = o.p;", 12, 1));
}

TEST(CustomGlsl, TheLastLineNeedsNoBreak) {
    const std::string text = "vec3 f(SgVolume o) {\n    return o.p\n}";
    EXPECT_EQ(said_of(text), glsl_fault("3", kNoSemicolon, "}", 1, 1));
    EXPECT_EQ(said_of(text + "\n"), said_of(text));
    EXPECT_EQ(said_of("vec3 f(SgVolume o) { return o.p; } // the end"), "");
}

TEST(CustomGlsl, AConditionThatIsNotEnded) {
    const std::string f = "vec3 f(SgVolume o) { return o.p; }\n";
    EXPECT_EQ(said_of("#if 1\n" + f), glsl_fault("1", "missing #endif", "#if 1", 1, 5));
    EXPECT_EQ(said_of("#ifdef FOO\n#if 1\n#endif\n" + f),
              glsl_fault("1", "missing #endif", "#ifdef FOO", 1, 10));
    EXPECT_EQ(said_of("#if 1\n" + f + "  # if 2 // three\n"),
              glsl_fault("3", "missing #endif", "  # if 2 // three", 3, 6));
}

TEST(CustomGlsl, AConditionThatLeavesTheFunctionOut) {
    EXPECT_EQ(
        said_of("#if FOO\nvec3 f(SgVolume o) {\n    return o.p;\n}\n#endif\n"),
        R"(wall.json:3:88: error: the layer calls 'vec3 f(SgVolume)', which 'a.glsl' does not have under its conditions and macros (#if, #define) [SG1603]
 "id": "x", "kind": "custom", "file": "a.glsl", "function": "f", "returns": "volume_gradient", "arguments": [ "object" ]
                                                            ^^^
    at /bump/0/layers/0/function: make the function and the layer's "arguments" and "returns" agree
a.glsl:2:6: note: 'vec3 f(SgVolume)' is here
vec3 f(SgVolume o) {
     ^
)");
    EXPECT_EQ(said_of("vec3 f(SgVolume o) {\n    return o.p;\n#if 0\n}\n#endif\n"),
              glsl_fault("5",
                         "syntax error, unexpected LEFT_BRACE, expecting SEMICOLON (behind the end of the "
                         "file)",
                         "#endif", 2, 5));
}

// What the linker says names no line.
TEST(CustomGlsl, FunctionsThatCannotBeLinked) {
    const std::string self = "float r(float x) { return r(x); }";
    EXPECT_EQ(said_of(self + "\nvec3 f(SgVolume o) { return o.p * r(1.0); }\n"),
              glsl_fault("1", "Recursion detected: 'r' calls itself", self, 7, 1));
    EXPECT_EQ(said_of("float b(float x);\nfloat a(float x) { return b(x); }\n"
                      "float b(float x) { return a(x); }\nvec3 f(SgVolume o) { return o.p; }\n"),
              glsl_fault("3", "Recursion detected: 'b' calls 'a' in a circle",
                         "float b(float x) { return a(x); }", 7, 1));
    EXPECT_EQ(said_of("vec3 g(float x);\nvec3 f(SgVolume o) { return g(1.0); }\n"),
              glsl_fault("1", "No function definition (body) found: 'g'", "vec3 g(float x);", 6, 1));
}

// glslang tells the line alone.
TEST(CustomGlsl, ThePlaceOnALine) {
    const std::string head = "vec3 f(SgVolume o) { ", tail = "return o.p; }";
    auto line = [&](const std::string& before, const std::string& at, const std::string& behind,
                    const std::string& what) {
        const std::string text = head + before + at + behind;
        EXPECT_EQ(said_of(text + "\n"),
                  glsl_fault("1", what, text, head.size() + before.size() + 1, at.size()));
    };
    line("return o.p ", "}", "", kNoSemicolon);
    line("{ } return o.p ", "}", " vec3 g() { return vec3(1.0); }", kNoSemicolon);
    line("vec3 a = o.p; vec2 b ", "=", " a; " + tail,
         "'=' :  cannot convert from ' temp highp 3-component vector of float' to ' temp highp 2-component "
         "vector of float'");
    line("float a = 1.0; a", "+=-", "vec2(1.0); " + tail,
         "'assign' :  cannot convert from ' const 2-component vector of float' to ' temp highp float'");
    line("float x = 1.0; /* x */ float ", "x", " = 2.0; " + tail, "'x' : redefinition");
    line("return o.p * length(1.0) * ", "length", "(length(1.0), length(2.0)); }",
         "'length' : no matching overloaded function found");
    line("float a = ", "08", "; " + tail, "octal literal digit too large");
    EXPECT_EQ(said_of("#define A 1\n#define A 2 // two\n" + head + tail),
              glsl_fault("2", "'#define' : Macro redefined; different substitutions: A", "#define A 2 // two",
                         1, 11));
}

TEST(CustomGlsl, AnIncludeBetweenBrackets) {
    auto said = [](const std::string& line, const std::string& column, const std::string& what,
                   const std::string& carets) {
        EXPECT_EQ(said_of(line + "\nvec3 f(SgVolume o) { return o.p; }\n"),
                  "a.glsl:1:" + column + ": error: " + what + " [SG1602]\n" + line + "\n" + carets +
                      "\n    write functions of their arguments, structs and constants; include files of "
                      "surfgrad/ only\n");
    };
    said("#include <surfgrad/volume.glsl>", "10",
         "cannot include '<surfgrad/volume.glsl>', expected quotes: \"surfgrad/volume.glsl\"",
         "         ^^^^^^^^^^^^^^^^^^^^^^");
    said("#include <math.h>", "10",
         "cannot include '<math.h>', expected a file of the library between quotes", "         ^^^^^^^^");
    said("#include", "2", "'#include' of nothing, expected a file of the library", " ^^^^^^^");
}

TEST(CustomGlsl, AByteOrderMarkIsSkipped) {
    const std::string mark = "\xEF\xBB\xBF", line = "vec3 f(SgVolume o) { return o.q; }";
    EXPECT_EQ(said_of(mark + "vec3 f(SgVolume o) { return o.p; }\n"), "");
    EXPECT_EQ(said_of(mark + line), glsl_fault("1", "'q' : no such field in structure 'o'", line, 31, 1));
}

// An accepted file that did not compile behind the check would end this process with exit code 3.
TEST(CustomGlsl, RandomDamageIsRefusedOrCompiles) {
    const std::string good = test::read_file(test::source_dir() / "materials/shaders/custom.glsl");
    const std::string json = test::read_file(test::source_dir() / "materials/custom.json");
    const std::string pieces[] = {
        "#",     "\\\n", "/*",  "*/",    "//",   "\n#if 0\n", "\n#endif\n", "#define dents ",
        "{",     "}",    "(",   ")",     ";",    "float ",    "vec3 m_x;",  "sg_",
        "const", "gl_",  "\"",  "\x01",  "main", "layout",    "dFdx",       "return ",
        "0x",    "##",   "in ", "inout", "[",    "]",         "struct A {", "uniform "};
    unsigned seed = std::random_device{}();
    if (const char* wanted = std::getenv("SG_SEED")) seed = static_cast<unsigned>(std::stoul(wanted));
    SCOPED_TRACE("SG_SEED=" + std::to_string(seed));
    std::mt19937 random(seed);
    auto pick = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    std::size_t accepted = 0;
    for (int round = 0; round < 400; ++round) {
        std::string text = good;
        for (std::size_t k = pick(2) + 1; k > 0; --k) {
            std::size_t at = pick(text.size());
            switch (pick(4)) {
                case 0:
                    text[at] = static_cast<char>(pick(256));
                    break;
                case 1:
                    text.erase(at, pick(12) + 1);
                    break;
                case 2:
                    text.insert(at, text.substr(pick(text.size()), pick(12)));
                    break;
                default:
                    text.insert(at, pieces[pick(std::size(pieces))]);
            }
        }
        std::map<std::string, std::string> files{{"shaders/custom.glsl", text},
                                                 {"textures/weave_normal.png", ""},
                                                 {"textures/pebble_height.png", ""}};
        accepted += compile(json, files).compiled ? 1 : 0;
    }
    EXPECT_GT(accepted, 20u);
    EXPECT_LT(accepted, 390u);
}

}  // namespace
}  // namespace sg

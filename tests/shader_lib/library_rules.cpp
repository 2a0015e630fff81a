// What holds for every file of shader_lib/surfgrad/ and lighting/: compiles alone, declares nothing that
// belongs to a stage, prefixes its names, documents every function, and returns once per function.
#include <gtest/gtest.h>

#include <sstream>

#include "glsl.hpp"
#include "library_index.hpp"

namespace sg::proof {
namespace {

// The text without comments, so that prose may use any word.
std::string code_of(const std::string& file) {
    std::istringstream lines(library_text(file));
    std::string code;
    for (std::string line; std::getline(lines, line);) code += line.substr(0, line.find("//")) + "\n";
    return code;
}

TEST(Library, EveryFileCompilesAlone) {
    for (const std::string& file : library_files()) {
        const std::string text =
            "#extension GL_GOOGLE_include_directive : require\n#include \"" + file + "\"\n";
        EXPECT_EQ(compile_glsl(text + "layout(location = 0) out vec4 o; void main() { o = vec4(0.0); }",
                               Stage::fragment)
                      .log,
                  "")
            << file;
        EXPECT_EQ(compile_glsl(text + "layout(local_size_x = 1) in; void main() {}", Stage::compute).log, "")
            << file;
    }
}

TEST(Library, FilesMayBeIncludedTwiceAndTogether) {
    std::string text;
    for (int twice = 0; twice < 2; ++twice) {
        for (const std::string& file : library_files()) text += "#include \"" + file + "\"\n";
    }
    EXPECT_EQ(compile_glsl(text + "layout(local_size_x = 1) in; void main() {}").log, "");
}

TEST(Library, NothingOfAStageAndNothingThatSomeTargetLacks) {
    for (const std::string& file : library_files()) {
        const std::string code = code_of(file);
        for (const char* word :
             {"dFdx", "dFdy", "fwidth", "gl_", "uniform", "layout", "isnan", "isinf", "textureQueryLod",
              "textureGatherOffsets", " fma(", "frexp", "outerProduct", "double", "texture("}) {
            EXPECT_EQ(code.find(word), std::string::npos) << file << " uses " << word;
        }
    }
}

TEST(Library, EveryFunctionSaysWhatItCostsAndReturnsOnce) {
    for (const auto& [function, file] : library_functions()) {
        EXPECT_NE(doc_comment(file, function).find("Cost:"), std::string::npos) << function << " in " << file;
    }
    for (const std::string& file : library_files()) {
        std::istringstream lines(code_of(file));
        int returns = 0;
        for (std::string line; std::getline(lines, line);) {
            if (line.find("return ") != std::string::npos) ++returns;
            if (!line.empty() && line[0] == '}') {
                EXPECT_LE(returns, 1) << file << " returns twice before '" << line << "'";
                returns = 0;
            } else if (!line.empty() && line[0] != ' ' && line.ends_with("}")) {
                returns = 0;
            }
        }
    }
}

}  // namespace
}  // namespace sg::proof

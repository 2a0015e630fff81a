// The house rules, enforced: who may include whom, how long functions and files may be, where third parties
// may be seen, what shader files may hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "tests/support/golden.hpp"

namespace sg {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFileLines = 500;
constexpr std::size_t kMaxFunctionLines = 80;

std::vector<fs::path> files(std::initializer_list<const char*> folders, std::set<std::string> extensions) {
    std::vector<fs::path> out;
    for (const char* folder : folders) {
        for (const auto& entry : fs::recursive_directory_iterator(test::source_dir() / folder)) {
            if (entry.is_regular_file() && extensions.count(entry.path().extension().string()))
                out.push_back(entry.path());
        }
    }
    std::sort(out.begin(), out.end());
    return out;
}

std::string below_root(const fs::path& path) {
    return path.lexically_relative(test::source_dir()).generic_string();
}

std::vector<std::string> lines(const fs::path& path) {
    std::istringstream stream(test::read_file(path));
    std::vector<std::string> out;
    for (std::string line; std::getline(stream, line);) out.push_back(line);
    return out;
}

std::vector<std::string> includes(const fs::path& path, char open = '"') {
    std::vector<std::string> out;
    std::string mark = std::string("#include ") + open;
    for (const std::string& line : lines(path)) {
        if (!line.starts_with(mark)) continue;
        std::size_t end = line.find(open == '"' ? '"' : '>', mark.size());
        out.push_back(line.substr(mark.size(), end - mark.size()));
    }
    return out;
}

// The layering table of compiler/README.md.
const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"base", {}},
    {"json", {"base"}},
    {"custom", {"base"}},
    {"asset", {"base"}},
    {"ir", {"base"}},
    {"layers", {"base", "ir"}},
    {"material", {"base", "json", "ir", "asset", "layers"}},
    {"opt", {"base", "ir"}},
    {"emit", {"base", "ir"}},
    {"target", {"base", "emit"}},
    {"import", {"base", "json", "asset"}},
};

TEST(House, CompilerFoldersIncludeDownwardsOnly) {
    for (const fs::path& path : files({"compiler"}, {".cpp", ".hpp", ".def"})) {
        std::string folder = *fs::path(below_root(path)).lexically_relative("compiler").begin();
        auto row = kMayInclude.find(folder);
        if (row == kMayInclude.end()) {
            EXPECT_TRUE(folder.find('.') != folder.npos)
                << below_root(path) << ": the folder is not in the layering table";
            continue;  // compiler/*.cpp may include all of compiler/
        }
        for (const std::string& include : includes(path)) {
            std::string target = *fs::path(include).begin();
            EXPECT_TRUE(target == folder || row->second.count(target))
                << below_root(path) << " includes " << include;
        }
    }
}

TEST(House, RuntimeKnowsTheManifestOnly) {
    const std::set<std::string> allowed = {"base", "json", "asset", "runtime"};
    for (const fs::path& path : files({"runtime"}, {".cpp", ".hpp"})) {
        bool proof = below_root(path).starts_with("runtime/proof/");
        for (const std::string& include : includes(path)) {
            std::string target = *fs::path(include).begin();
            EXPECT_TRUE(allowed.count(target) || (proof && target == "ir"))
                << below_root(path) << " includes " << include;
        }
    }
}

// Headers that cost seconds to compile stay in the files that need them.
TEST(House, HeavyHeadersStayInTheirFacades) {
    const std::map<std::string, std::set<std::string>> facades = {
        {"nlohmann/",
         {"compiler/json/json.cpp", "compiler/artefact.cpp", "compiler/function_manifest.cpp",
          "compiler/host_manifest.cpp", "compiler/import/gltf_import.cpp", "compiler/sarif.cpp",
          "compiler/schema.cpp", "runtime/manifest.cpp"}},
        {"glslang/", {"compiler/target/spirv.cpp"}},
        {"spirv-tools/", {"compiler/target/spirv.cpp"}},
        {"spirv_cross/", {"compiler/target/cross.cpp"}},
        {"CLI/", {"compiler/main.cpp", "runtime/cli.cpp", "materials/generate/main.cpp"}},
    };
    for (const fs::path& path : files({"compiler", "runtime", "materials"}, {".cpp", ".hpp"})) {
        for (const std::string& include : includes(path, '<')) {
            for (const auto& [prefix, allowed] : facades) {
                if (!include.starts_with(prefix)) continue;
                EXPECT_TRUE(allowed.count(below_root(path)))
                    << below_root(path) << " includes <" << include << ">";
            }
        }
    }
}

TEST(House, FilesAreShort) {
    for (const fs::path& path : files({"compiler", "runtime", "shader_lib", "materials", "tests"},
                                      {".cpp", ".hpp", ".glsl", ".def", ".txt", ".cmake"})) {
        if (below_root(path).starts_with("tests/errors/cases/")) continue;
        EXPECT_LE(lines(path).size(), kMaxFileLines) << below_root(path);
    }
}

// Counts lines from a line that opens a function's body to the one that closes it: our formatter ends the
// first with
// '{' and puts the closing brace at the same indent. Lambdas count as part of the function around them.
bool opens_function(const std::string& line) {
    bool body = line.ends_with(") {") || line.ends_with(") const {") || line.ends_with(") override {");
    std::size_t indent = line.find_first_not_of(' ');
    if (!body || indent > 4 || line.find("](") != std::string::npos) return false;
    for (const char* word : {"for (", "if (", "while (", "switch (", "} else"}) {
        if (line.compare(indent, std::string_view(word).size(), word) == 0) return false;
    }
    return true;
}

TEST(House, FunctionsAreShort) {
    std::size_t functions = 0;
    for (const fs::path& path :
         files({"compiler", "runtime", "shader_lib", "materials", "tests"}, {".cpp", ".hpp", ".glsl"})) {
        if (below_root(path).starts_with("tests/golden/")) continue;  // as long as the material
        std::vector<std::string> text = lines(path);
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (!opens_function(text[i])) continue;
            ++functions;
            std::string close = text[i].substr(0, text[i].find_first_not_of(' ')) + "}";
            std::size_t end = i + 1;
            while (end < text.size() && text[end] != close) ++end;
            EXPECT_LE(end - i + 1, kMaxFunctionLines) << below_root(path) << ":" << i + 1;
        }
    }
    EXPECT_GT(functions, 400u);  // the pattern still finds them
}

// shader_lib/surfgrad: pure functions. No uniforms, layouts, screen derivatives, built-in inputs, early
// returns.
TEST(House, LibraryFilesArePure) {
    for (const fs::path& path :
         files({"shader_lib/surfgrad", "shader_lib/function", "shader_lib/lighting"}, {".glsl"})) {
        std::size_t returns = 0;
        for (std::string line : lines(path)) {
            line = line.substr(0, line.find("//"));
            for (const char* word :
                 {"uniform ", "layout(", "dFdx", "dFdy", "fwidth", "gl_", "textureQueryLod", "isnan"}) {
                EXPECT_EQ(line.find(word), std::string::npos) << below_root(path) << ": " << line;
            }
            returns += line.find("return") != std::string::npos ? 1 : 0;
            EXPECT_LE(returns, 1u) << below_root(path) << ": " << line;
            if (!line.empty() && line[0] != ' ' && line.find('}') != std::string::npos)
                returns = 0;  // a function ends
        }
    }
}

TEST(House, LibraryFilesIncludeTheLibraryOnly) {
    for (const fs::path& path : files({"shader_lib"}, {".glsl"})) {
        bool stage = below_root(path).starts_with("shader_lib/stage/");
        bool lighting = below_root(path).starts_with("shader_lib/lighting/");
        for (const std::string& include : includes(path)) {
            bool good = include.starts_with("surfgrad/") || (stage && include.starts_with("stage/")) ||
                        ((stage || lighting) && include.starts_with("lighting/"));
            EXPECT_TRUE(good) << below_root(path) << " includes " << include;
        }
    }
}

}  // namespace
}  // namespace sg

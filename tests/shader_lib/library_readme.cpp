// shader_lib/README.md: its table of functions is the library's own words, its example compiles. SG_ACCEPT=1
// writes the table anew.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "glsl.hpp"
#include "library_index.hpp"

namespace sg::proof {
namespace {

constexpr const char* kReadme = SG_SOURCE_DIR "/shader_lib/README.md";
constexpr std::string_view kBegin = "<!-- functions: begin -->\n", kEnd = "<!-- functions: end -->\n";

// The `//` lines at a place as one line of prose.
std::string prose(const std::string& comment) {
    std::istringstream lines(comment);
    std::string out;
    for (std::string line; std::getline(lines, line);) {
        std::size_t begin = line.find_first_not_of("/ ");
        if (begin != std::string::npos) out += (out.empty() ? "" : " ") + line.substr(begin);
    }
    return out;
}

std::string without_stop(std::string text) {
    while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
    return text;
}

// What follows `word` up to the next sentence, "" without it.
std::string sentence_after(const std::string& text, const std::string& word) {
    std::size_t at = text.rfind(word);
    if (at == std::string::npos) return "";
    std::string rest = text.substr(at + word.size());
    return without_stop(rest.substr(0, rest.find(". ")));
}

std::string source_of(const std::string& file, const std::string& comment) {
    const std::string own = sentence_after(comment, "Source: ");
    if (!own.empty()) return own;
    const std::string text = library_text(file);
    const std::string head = prose(text.substr(0, text.find("#ifndef")));
    const std::string one = sentence_after(head, "Source: ");
    return one.empty() ? sentence_after(head, "Sources: ") : one;
}

// Function -> instructions, as surfgrad-bench-library printed them.
std::map<std::string, std::string> measured_costs() {
    std::ifstream stream(SG_SOURCE_DIR "/tests/shader_lib/costs.txt");
    std::map<std::string, std::string> out;
    for (std::string function, cost; stream >> function >> cost;) out[function] = cost;
    return out;
}

std::string function_table() {
    const std::map<std::string, std::string> costs = measured_costs();
    std::string out = "| function | file | navi21 instructions | source |\n|---|---|---|---|\n";
    std::map<std::string, std::vector<std::string>> by_file;
    for (const auto& [function, file] : library_functions()) by_file[file].push_back(function);
    for (const auto& [file, functions] : by_file) {
        for (const std::string& function : functions) {
            const std::string comment = prose(doc_comment(file, function));
            const std::string source = source_of(file, comment);
            const auto cost = costs.find(function);
            EXPECT_TRUE(cost != costs.end())
                << function << " has no line in costs.txt: run surfgrad-bench-library";
            EXPECT_FALSE(source.empty()) << function << " does not say its source, nor does " << file;
            out += fmt::format("| `{}` | {} | {} | {} |\n", function, file.substr(file.find('/') + 1),
                               cost == costs.end() ? "" : cost->second, source);
        }
    }
    return out;
}

std::string readme() {
    std::ifstream stream(kReadme, std::ios::binary);
    EXPECT_TRUE(stream.is_open()) << kReadme;
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

TEST(LibraryReadme, ListsEveryFunctionWithItsCostAndSource) {
    std::string text = readme();
    const std::size_t begin = text.find(kBegin), end = text.find(kEnd);
    ASSERT_TRUE(begin != std::string::npos && end != std::string::npos && begin < end);
    const std::size_t from = begin + kBegin.size();
    const std::string table = function_table();
    if (std::getenv("SG_ACCEPT") != nullptr) {
        std::ofstream(kReadme, std::ios::binary) << text.replace(from, end - from, table);
        return;
    }
    EXPECT_EQ(text.substr(from, end - from), table) << "SG_ACCEPT=1 writes the table anew";
}

TEST(LibraryReadme, TheExampleOfAnEngineCompiles) {
    const std::string text = readme(), fence = "```glsl\n#version 450\n";
    const std::size_t begin = text.find(fence);
    ASSERT_NE(begin, std::string::npos);
    const std::size_t from = begin + fence.size();
    const std::string example = text.substr(from, text.find("```", from) - from);
    EXPECT_EQ(compile_glsl(example, Stage::fragment).log, "") << example;
    EXPECT_NE(example.find("surfgrad/"), std::string::npos);
}

}  // namespace
}  // namespace sg::proof

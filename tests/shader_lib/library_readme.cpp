// What the library says of its functions: costs.txt is what the driver makes of them, the comments repeat it,
// shader_lib/README.md's table holds both and each function's source, and its example compiles. SG_ACCEPT=1
// writes costs.txt, the numbers in the comments and the table anew.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "glsl.hpp"
#include "library_index.hpp"
#include "tests/bench/gpu_statistics.hpp"

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

bool accepts() {
    return std::getenv("SG_ACCEPT") != nullptr;
}

constexpr const char* kCosts = SG_SOURCE_DIR "/tests/shader_lib/costs.txt";

// "RADV" -> its version, function -> instructions: what surfgrad-bench-library printed.
using Costs = std::map<std::string, std::string>;
Costs costs_in(std::istream& stream) {
    Costs out;
    for (std::string function, cost; stream >> function >> cost;) out[function] = cost;
    return out;
}
Costs measured_costs() {
    std::ifstream stream(kCosts);
    return costs_in(stream);
}

// What surfgrad-bench-library prints now; "" where the driver is missing.
std::string counted_now() {
    const std::string command = std::string("env ") + bench::kGpuEnvironment +
                                " '" SG_BINARY_DIR "/surfgrad-bench-library' 2>/dev/null";
    FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return "";
    std::string out;
    char part[4096];
    while (std::fgets(part, sizeof part, pipe) != nullptr) out += part;
    return ::pclose(pipe) == 0 ? out : "";
}

TEST(LibraryCosts, AreWhatTheDriverMakesOfTheFunctions) {
    const std::string now = counted_now();
    if (now.empty())
        GTEST_SKIP() << "costs.txt is not counted again: there is no RADV (Mesa's driver for AMD) here";
    std::istringstream stream(now);
    Costs counted = costs_in(stream), written = measured_costs();
    if (accepts()) {
        std::ofstream(kCosts, std::ios::binary) << now;
        return;
    }
    if (counted["RADV"] != written["RADV"]) {
        GTEST_SKIP() << "costs.txt is not counted again: it holds the counts of RADV " << written["RADV"]
                     << ", this is " << counted["RADV"];
    }
    for (const auto& [function, cost] : counted) {
        EXPECT_EQ(written[function], cost) << function << "; SG_ACCEPT=1 counts anew";
    }
    EXPECT_EQ(written.size(), counted.size());
}

// Where the digits of "Cost: 41 instructions" stand in a library file, for the comment above a function.
std::pair<std::size_t, std::size_t> cost_digits(const std::string& text, const std::string& file,
                                                const std::string& function) {
    const std::string comment = doc_comment(file, function), word = "Cost: ";
    const std::size_t above = text.find(comment + definition(file, function));
    const std::size_t in_comment = comment.rfind(word);
    if (above == std::string::npos || in_comment == std::string::npos) return {0, 0};
    const std::size_t begin = above + in_comment + word.size();
    std::size_t end = begin;
    while (std::isdigit(static_cast<unsigned char>(text[end])) != 0) ++end;
    return text.compare(end, 12, " instruction") != 0 ? std::pair{begin, begin} : std::pair{begin, end};
}

TEST(LibraryCosts, StandInTheComments) {
    Costs written = measured_costs();
    for (const auto& [function, file] : library_functions()) {
        std::string text = library_text(file);
        const auto [begin, end] = cost_digits(text, file, function);
        ASSERT_LT(begin, end) << function << " in " << file << " does not say 'Cost: N instructions'";
        if (accepts()) {
            text.replace(begin, end - begin, written[function]);
            std::ofstream(SG_SOURCE_DIR "/shader_lib/" + file, std::ios::binary) << text;
        } else {
            EXPECT_EQ(text.substr(begin, end - begin), written[function])
                << function << " in " << file << "; SG_ACCEPT=1 writes it anew";
        }
    }
}

// A listing, an equation, a section, a rule: not a book.
bool names_a_place(const std::string& source) {
    for (const char* word : {"Eq ", "Listing ", "section", "Figure ", "Table ", "rule", "Lengyel 7.", "KHR_",
                             "Perlin 19", "Perlin 20", "Geiss", "Welsh", "workshop 4", "Tatarchuk"}) {
        if (source.find(word) != std::string::npos) return true;
    }
    return false;
}

std::string function_table() {
    const Costs costs = measured_costs();
    std::string out = "| function | file | navi21 instructions | source |\n|---|---|---|---|\n";
    std::map<std::string, std::vector<std::string>> by_file;
    for (const auto& [function, file] : library_functions()) by_file[file].push_back(function);
    for (const auto& [file, functions] : by_file) {
        for (const std::string& function : functions) {
            const std::string comment = prose(doc_comment(file, function));
            const std::string source = sentence_after(comment, "Source: ");
            const auto cost = costs.find(function);
            EXPECT_TRUE(cost != costs.end())
                << function << " has no line in costs.txt: run surfgrad-bench-library";
            EXPECT_TRUE(names_a_place(source))
                << function << " in " << file << " does not say which equation, listing "
                << "or section it is of: '" << source << "'";
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
    if (accepts()) {
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

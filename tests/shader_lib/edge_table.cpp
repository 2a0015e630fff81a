// The edge cases of the specification, letters A to L, function by function: edges/<concept>.txt names for
// every function of shader_lib/surfgrad/<concept>.glsl and every letter either the tests that show the
// behaviour or the reason why the letter does not apply. A missing cell, an unknown function and an unknown
// test all fail.
//
//   * K - no texture is read                    for every function of the concept
//   sg_basis_uv                                 from here on for this function, before the rows with a star
//     C Basis.AllMirrorings Basis.Rotated       one or more tests, Suite.Name
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "library_index.hpp"

namespace sg::proof {
namespace {

constexpr std::string_view kLetters = "ABCDEFGHIJKL";

// (function or "*", letter) -> the cell's text.
using Cells = std::map<std::pair<std::string, char>, std::string>;

std::string concept_of(const std::string& file) {
    return file.substr(file.find('/') + 1, file.rfind('.') - file.find('/') - 1);
}

void read_row(const std::string& row_function, const std::string& line, Cells& cells) {
    const std::size_t at = line.find_first_not_of(' ');
    const bool well_formed =
        line.size() > at + 2 && kLetters.find(line[at]) != std::string_view::npos && line[at + 1] == ' ';
    ASSERT_TRUE(well_formed) << "not a cell: '" << line << "'";
    bool fresh = cells.emplace(std::pair{row_function, line[at]}, line.substr(at + 2)).second;
    EXPECT_TRUE(fresh) << row_function << " has two cells " << line[at];
}

Cells read_cells(const std::string& concept_name) {
    std::ifstream stream(SG_SOURCE_DIR "/tests/shader_lib/edges/" + concept_name + ".txt");
    EXPECT_TRUE(stream.is_open()) << "no tests/shader_lib/edges/" << concept_name << ".txt";
    Cells cells;
    std::string function;
    for (std::string line; std::getline(stream, line);) {
        if (line.empty() || line[0] == '#') continue;
        if (line.starts_with("* ")) {
            read_row("*", line.substr(2), cells);
        } else if (line[0] == ' ') {
            read_row(function, line, cells);
        } else {
            function = line;
        }
    }
    return cells;
}

std::set<std::string> registered_tests() {
    std::set<std::string> out;
    const auto& unit = *testing::UnitTest::GetInstance();
    for (int s = 0; s < unit.total_test_suite_count(); ++s) {
        const auto& suite = *unit.GetTestSuite(s);
        for (int t = 0; t < suite.total_test_count(); ++t) {
            out.insert(std::string(suite.name()) + "." + suite.GetTestInfo(t)->name());
        }
    }
    return out;
}

void check_cell(const std::string& what, const std::string& cell, const std::set<std::string>& tests) {
    if (cell.starts_with("- ")) {
        EXPECT_GT(cell.size(), 12u) << what << " gives no reason";
        return;
    }
    std::istringstream names(cell);
    for (std::string name; names >> name;) {
        EXPECT_TRUE(tests.contains(name)) << what << " names no test of this program: " << name;
    }
}

TEST(EdgeTable, EveryFunctionAnswersEveryLetter) {
    const std::set<std::string> tests = registered_tests();
    std::map<std::string, Cells> tables;
    for (const auto& [function, file] : library_functions()) {
        auto [table, fresh] = tables.try_emplace(concept_of(file));
        if (fresh) table->second = read_cells(table->first);
        for (char letter : kLetters) {
            auto cell = table->second.find({function, letter});
            if (cell == table->second.end()) cell = table->second.find({"*", letter});
            const std::string what = function + " " + letter;
            if (cell == table->second.end()) {
                ADD_FAILURE() << what << ": no cell";
            } else {
                check_cell(what, cell->second, tests);
            }
        }
    }
}

TEST(EdgeTable, NamesOnlyFunctionsThatExist) {
    const auto functions = library_functions();
    for (const std::string& file : library_files()) {
        for (const auto& [place, cell] : read_cells(concept_of(file))) {
            if (place.first == "*") continue;
            auto found = functions.find(place.first);
            EXPECT_TRUE(found != functions.end() && found->second == file)
                << place.first << " is not in " << file;
        }
    }
}

}  // namespace
}  // namespace sg::proof

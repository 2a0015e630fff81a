// The edge cases of the specification, letters A to L, function by function: edges/<concept>.txt
// (cell_table.hpp) names for every function of shader_lib/surfgrad/<concept>.glsl and every letter either the
// tests that show the behaviour or the reason why the letter does not apply. A missing cell, an unknown
// function and an unknown test fail the build (CMakeLists.txt runs EdgeTable.* after the link).
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <sstream>

#include "cell_table.hpp"
#include "library_index.hpp"

namespace sg::proof {
namespace {

constexpr std::array<std::string_view, 12> kLetters = {"A", "B", "C", "D", "E", "F",
                                                       "G", "H", "I", "J", "K", "L"};

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

TEST(EdgeTable, EveryFunctionAnswersEveryLetter) {
    EXPECT_EQ(all_faults("edges", kLetters), "");
}

TEST(EdgeTable, NamesTestsOfThisProgram) {
    const std::set<std::string> tests = registered_tests();
    for (const std::string& file : library_files()) {
        for (const auto& [place, cell] : read_table("edges", concept_of(file), kLetters).cells) {
            std::istringstream names(cell.starts_with("- ") ? "" : cell);
            for (std::string name; names >> name;) {
                EXPECT_TRUE(tests.contains(name))
                    << place.first << " " << place.second << " names no test of this program: " << name;
            }
        }
    }
}

TEST(EdgeTable, NoCellCanBeTakenOut) {
    for (const std::string& file : library_files()) {
        const CellTable whole = read_table("edges", concept_of(file), kLetters);
        for (const auto& [place, cell] : whole.cells) {
            CellTable without = whole;
            without.cells.erase(place);
            EXPECT_FALSE(faults_of(without, file, kLetters).empty()) << place.first << " " << place.second;
        }
    }
}

}  // namespace
}  // namespace sg::proof

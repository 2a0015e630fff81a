// A mistake of each kind in each function: mutants/<concept>.txt (cell_table.hpp) holds for every function of
// shader_lib/surfgrad/<concept>.glsl and every kind either a mutant or the reason why the function has
// nothing of that kind. The head of a function names the cases that must notice. Each mutant is a test; a
// missing cell fails the build, as in edge_table.cpp.
//
//   sg_reject: reject
//     sign | v - dot => v + dot         what stands once in the function becomes what follows the arrow
//
// The kinds:
//   sign        a sign in the formula, or of its result, turned
//   green       the direction of t turned: the second component of a coordinate or a derivative
//   w           a factor of handedness or side lost: w, a determinant, flip_sign, facing, hand
//   axis        two axes, components or like arguments exchanged
//   projection  a projection onto a plane or a direction left out
#include <gtest/gtest.h>

#include <array>
#include <sstream>

#include "cell_table.hpp"
#include "harness.hpp"
#include "library_index.hpp"

namespace sg::proof {
namespace {

constexpr std::array<std::string_view, 5> kKinds = {"sign", "green", "w", "axis", "projection"};

struct KindMutant {
    std::string function, kind, cases;
    std::string file, find, replace;
};
void PrintTo(const KindMutant& mutant, std::ostream* out) {
    *out << mutant.kind << " of " << mutant.function;
}

std::vector<KindMutant> kind_mutants() {
    std::vector<KindMutant> out;
    for (const std::string& file : library_files()) {
        CellTable table = read_table("mutants", concept_of(file), kKinds);
        for (const auto& [place, cell] : table.cells) {
            const std::size_t arrow = cell.find(" => ");
            if (!cell.starts_with("| ") || arrow == std::string::npos) continue;
            out.push_back({place.first, place.second, table.heads[place.first], file,
                           cell.substr(2, arrow - 2), cell.substr(arrow + 4)});
        }
    }
    return out;
}

TEST(MutantTable, EveryFunctionAnswersEveryKind) {
    EXPECT_EQ(all_faults("mutants", kKinds), "");
}

TEST(MutantTable, ACellIsAMutantOrAReason) {
    for (const std::string& file : library_files()) {
        for (const auto& [place, cell] : read_table("mutants", concept_of(file), kKinds).cells) {
            const bool mutant = cell.starts_with("| ") && cell.find(" => ") != std::string::npos;
            EXPECT_TRUE(mutant || cell.starts_with("- "))
                << place.first << " " << place.second << ": " << cell;
            EXPECT_TRUE(!mutant || place.first != "*") << "a mutant of every function of " << file;
        }
    }
}

TEST(MutantTable, NoCellCanBeTakenOut) {
    for (const std::string& file : library_files()) {
        const CellTable whole = read_table("mutants", concept_of(file), kKinds);
        for (const auto& [place, cell] : whole.cells) {
            CellTable without = whole;
            without.cells.erase(place);
            EXPECT_FALSE(faults_of(without, file, kKinds).empty()) << place.first << " " << place.second;
        }
    }
}

class MutantsByKind : public testing::TestWithParam<KindMutant> {};

TEST_P(MutantsByKind, AreNoticed) {
    const KindMutant& mutant = GetParam();
    std::string whole = definition(mutant.file, mutant.function), mistaken = whole;
    const std::size_t at = whole.find(mutant.find);
    ASSERT_TRUE(at != std::string::npos && whole.find(mutant.find, at + 1) == std::string::npos)
        << "'" << mutant.find << "' does not stand exactly once in\n"
        << whole;
    mistaken.replace(at, mutant.find.size(), mutant.replace);
    const Mutant applied{mutant.file, whole, mistaken};
    std::string noticed;
    std::istringstream names(mutant.cases);
    for (std::string name; names >> name;) {
        const Case* item = find_case(name);
        ASSERT_NE(item, nullptr) << "there is no case " << name;
        const std::vector<float> inputs = draw_inputs(*item, kMutantCount);
        noticed += compare(*item, inputs, evaluate(*item, inputs, &applied)).violation;
    }
    EXPECT_NE(noticed, "") << mutant.cases << " holds although '" << mutant.find << "' became '"
                           << mutant.replace << "'; SG_SEED=" << run_seed();
}

std::string test_name(const testing::TestParamInfo<KindMutant>& tested) {
    return tested.param.function + "_" + tested.param.kind;
}
INSTANTIATE_TEST_SUITE_P(Library, MutantsByKind, testing::ValuesIn(kind_mutants()), test_name);

}  // namespace
}  // namespace sg::proof

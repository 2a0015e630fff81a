// The documents say what is: tables are compared with the rows that they describe, paths and commands exist.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "base/diag.hpp"
#include "emit/function.hpp"
#include "emit/glsl.hpp"
#include "ir/host.hpp"
#include "ir/ir.hpp"
#include "kinds.hpp"
#include "layers/kind.hpp"
#include "opt/optimise.hpp"
#include "tests/support/golden.hpp"

namespace sg {
namespace {

namespace fs = std::filesystem;

std::string document(const char* path) {
    std::string text = test::read_file(test::source_dir() / path);
    EXPECT_FALSE(text.empty()) << path;
    return text;
}

TEST(Readme, EveryDiagnosticIsListedWithCauseAndMend) {
    std::string text = document("compiler/README.md");
    for (const CodeInfo& info : all_codes()) {
        std::string row = "| SG" + std::to_string(static_cast<int>(info.code)) + " | " +
                          std::string(info.cause) + " | " + std::string(info.mend) + " |";
        EXPECT_NE(text.find(row), std::string::npos) << "missing line:\n" << row;
    }
}

TEST(Readme, ThePageOfKindsIsFresh) {
    test::expect_golden("../materials/kinds.md", kinds_markdown());
}

TEST(Readme, EveryRuleAndEntryPointIsListed) {
    std::string text = document("compiler/README.md");
    for (const opt::Rule& rule : opt::all_rules()) {
        std::string row = "| `" + std::string(rule.name) + "` | " + std::string(rule.reason) + " |";
        EXPECT_NE(text.find(row), std::string::npos) << "missing line:\n" << row;
    }
    std::string artefacts = document("compiler/artefacts.md");
    for (const emit::EntryPoint& entry : emit::all_entry_points()) {
        EXPECT_NE(artefacts.find("| `" + std::string(entry.name) + "` |"), std::string::npos) << entry.name;
    }
}

// With as many letters as a word has operands.
TEST(Readme, EveryWordOfExpressionsIsListed) {
    const std::string text = document("compiler/artefacts.md");
    for (const ir::HostOp& op : ir::all_host_ops()) {
        if (op.word.empty()) continue;
        // A form of its own, such as ["rgb", EXPRESSION], has its row among the expressions.
        if (text.find(fmt::format("| `[\"{}\", ", op.word)) != std::string::npos) continue;
        EXPECT_TRUE(op.costs) << op.word;
        const std::size_t at = text.find(fmt::format("| `{}` | ", op.word));
        ASSERT_NE(at, std::string::npos) << op.word;
        const std::size_t from = text.find(" | ", at) + 3;
        const std::size_t letters = (text.find(" | ", from) - from + 1) / 2;
        EXPECT_EQ(letters, ir::info(op.op).operands.size()) << op.word;
    }
}

TEST(Readme, EveryFieldOfTheFunctionIsListed) {
    std::string text = document("compiler/function.md");
    for (const auto& fields : {emit::function_inputs(), emit::function_results()}) {
        for (const emit::FunctionField& field : fields) {
            std::string row =
                "| `" + field.name + "` | `" + std::string(field.type) + "` | " + field.meaning + " |";
            EXPECT_NE(text.find(row), std::string::npos) << "missing line:\n" << row;
        }
    }
}

TEST(Readme, EverySampleIsListed) {
    const std::string text = document("materials/README.md");
    int found = 0;
    for (const auto& entry : fs::directory_iterator(test::source_dir() / "materials")) {
        if (entry.path().extension() != ".json") continue;
        ++found;
        const std::string name = entry.path().filename().string();
        EXPECT_NE(text.find("(" + name + ")"), std::string::npos) << "not in the table of samples: " << name;
    }
    EXPECT_GE(found, 20);
}

// A kind is compared with the surface that is really displaced; the one that leads back to a normal bumps
// nothing.
TEST(Readme, EveryLayerKindHasAProof) {
    const std::string cases = document("tests/proof/kinds.cpp");
    for (const layers::LayerKind* kind : layers::all_kinds()) {
        if (kind->name == "earlier_normal") continue;
        EXPECT_NE(cases.find(fmt::format("\"kind\": \"{}\"", kind->name)), std::string::npos)
            << "no case in tests/proof/kinds.cpp: " << kind->name;
    }
}

TEST(Readme, EveryMakeTargetExists) {
    std::string makefile = document("Makefile");
    std::string text = document("README.md");
    std::regex command("`make ([a-z]+)`|\nmake ([a-z]+)");
    int found = 0;
    for (std::sregex_iterator it(text.begin(), text.end(), command), end; it != end; ++it, ++found) {
        std::string target = (*it)[1].matched ? (*it)[1] : (*it)[2];
        EXPECT_NE(makefile.find("\n" + target + ":"), std::string::npos) << "make " << target;
    }
    EXPECT_GE(found, 2);
}

TEST(Readme, EveryPathThatIsNamedExists) {
    std::regex link("\\]\\(([A-Za-z0-9_./-]+)\\)");
    for (const char* path : {"README.md", "compiler/README.md", "runtime/README.md", "shader_lib/README.md",
                             "materials/README.md"}) {
        std::string text = document(path);
        fs::path folder = (test::source_dir() / path).parent_path();
        for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
            EXPECT_TRUE(fs::exists(folder / (*it)[1].str())) << path << " names " << (*it)[1];
        }
    }
}

TEST(Readme, CiRunsTheTestCommandOfTheReadme) {
    EXPECT_NE(document("README.md").find("\nmake test\n"), std::string::npos);
    EXPECT_NE(document(".ci/run").find("make test"), std::string::npos);
}

// What the project says of itself names no path outside the repository.
TEST(Readme, NothingPointsOutside) {
    for (const auto& entry : fs::recursive_directory_iterator(test::source_dir() / "compiler")) {
        if (!entry.is_regular_file()) continue;
        EXPECT_EQ(test::read_file(entry.path()).find("../shared"), std::string::npos) << entry.path();
    }
}

}  // namespace
}  // namespace sg

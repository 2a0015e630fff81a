// Budgets: what a compile says that costs more than was allowed, whole.
#include <gtest/gtest.h>

#include "compile.hpp"
#include "tests/support/golden.hpp"

namespace sg {
namespace {

// Two reads of one texture that share nothing else; the shader interpolates position, normal and uv 0.
std::string material(const std::string& budget) {
    return R"({
  "version": 1,
  "textures": { "a": { "file": "a.png", "encoding": "tangent_normal" } },
  )" + budget +
           R"(
  "bump": [ { "layers": [ { "kind": "normal_map", "texture": "a" }, { "kind": "normal_map", "texture": "a", "tiling": 2 } ] } ]
}
)";
}

std::string compile(const std::string& text, const material::Budget& budget = {},
                    std::vector<std::string> entries = {}) {
    MemoryFiles files;
    files.contents["/m/a.png"] = "";
    CompileRequest request{.source = std::make_shared<Source>(Source{"wall.json", text}),
                           .stem = "wall",
                           .roots = {"/m"},
                           .entries = std::move(entries),
                           .budget = budget};
    Diags diags;
    auto out = compile_material(request, files, target::embedded_library(), diags);
    EXPECT_EQ(out.has_value(), !diags.has_errors());
    EXPECT_EQ(diags.exit_code(), out ? 0 : 1);
    return render(diags);
}

TEST(Budget, OfTheMaterial) {
    std::string text =
        material(R"("budget": { "instructions": 100000, "texture_reads": 1, "interpolants": 7 },)");
    EXPECT_EQ(compile(text),
              "wall.json:4:56: error: the forward shader takes 2 texture reads, 'budget' allows 1 [SG1402]\n"
              "  \"budget\": { \"instructions\": 100000, \"texture_reads\": 1, \"interpolants\": 7 },\n"
              "                                                       ^\n"
              "wall.json:4:75: error: the forward shader takes 8 numbers from the vertex stage, 'budget' "
              "allows 7 [SG1402]\n"
              "  \"budget\": { \"instructions\": 100000, \"texture_reads\": 1, \"interpolants\": 7 },\n"
              "                                                                          ^\n");
}

TEST(Budget, ThatIsJustMet) {
    EXPECT_EQ(compile(material(R"("budget": { "texture_reads": 2, "interpolants": 8 },)")), "");
}

// The number of instructions follows the versions of glslang and SPIRV-Tools: only the words around it stand
// here.
TEST(Budget, OfTheCommandLineForAnyEntry) {
    material::Budget budget;
    budget[static_cast<std::size_t>(material::Cost::instructions)] = material::Located<std::uint32_t>{3, {}};
    std::string found = compile(material(""), budget, {"normal"});
    EXPECT_TRUE(found.starts_with("wall.json:1:1: error: the forward shader takes ")) << found;
    EXPECT_NE(found.find(" instructions, --budget allows 3 [SG1402]\n{\n^\n"), std::string::npos) << found;
    budget[0]->value = 100000;
    EXPECT_EQ(compile(material(""), budget, {"normal"}), "");
}

}  // namespace
}  // namespace sg

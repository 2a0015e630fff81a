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
              "    at /budget/texture_reads: drop or simplify a layer (`surfgradc explain` tells what each "
              "costs), or allow more\n"
              "wall.json:4:75: error: the forward shader takes 8 numbers from the vertex stage, 'budget' "
              "allows 7 [SG1402]\n"
              "  \"budget\": { \"instructions\": 100000, \"texture_reads\": 1, \"interpolants\": 7 },\n"
              "                                                                          ^\n"
              "    at /budget/interpolants: drop or simplify a layer (`surfgradc explain` tells what each "
              "costs), or allow more\n");
}

TEST(Budget, OfTheMaterialThatIsExtended) {
    MemoryFiles files;
    files.contents["/m/base.json"] = "{ \"version\": 1,\n  \"budget\": { \"interpolants\": 0 } }\n";
    CompileRequest request{.source = std::make_shared<Source>(
                               Source{"wall.json", R"({ "version": 1, "extends": "base.json" })"}),
                           .stem = "wall",
                           .roots = {"/m"},
                           .entries = {"normal"}};
    Diags diags;
    EXPECT_FALSE(compile_material(request, files, target::embedded_library(), diags));
    EXPECT_EQ(
        render(diags),
        "base.json:2:31: error: the forward shader takes 6 numbers from the vertex stage, 'budget' allows 0 "
        "[SG1402]\n"
        "  \"budget\": { \"interpolants\": 0 } }\n"
        "                              ^\n"
        "    at /budget/interpolants: drop or simplify a layer (`surfgradc explain` tells what each costs), "
        "or allow more\n");
}

TEST(Budget, ThatIsJustMet) {
    EXPECT_EQ(compile(material(R"("budget": { "texture_reads": 2, "interpolants": 8 },)")), "");
}

// One layer, seven reads.
TEST(Budget, OfReadsWithinOneLayer) {
    EXPECT_EQ(compile(R"({ "version": 1,
  "budget": { "texture_reads": 2 },
  "textures": { "a": { "file": "a.png", "encoding": "height" } },
  "bump": [ { "layers": [ { "kind": "height_map", "texture": "a", "method": "hq" } ] } ] })"),
              "wall.json:2:32: error: the forward shader takes 7 texture reads, 'budget' allows 2 [SG1402]\n"
              "  \"budget\": { \"texture_reads\": 2 },\n"
              "                               ^\n"
              "    at /budget/texture_reads: drop or simplify a layer (`surfgradc explain` tells what each "
              "costs), or allow more\n");
}

// A budget of the command line has no place in the file.
TEST(Budget, OfTheCommandLineForAnyEntry) {
    using enum material::Cost;
    auto limited = [](material::Cost cost, std::uint32_t limit) {
        material::Budget out;
        out[static_cast<std::size_t>(cost)] = material::Located<std::uint32_t>{limit, {}};
        return out;
    };
    material::Budget budget = limited(texture_reads, 1);
    budget[static_cast<std::size_t>(interpolants)] = material::Located<std::uint32_t>{0, {}};
    EXPECT_EQ(
        compile(material(""), budget, {"normal"}),
        "error: --budget texture_reads=1: the forward shader of 'wall.json' takes 2 texture reads [SG1402]\n"
        "error: --budget interpolants=0: the forward shader of 'wall.json' takes 8 numbers from the vertex "
        "stage [SG1402]\n");
    // The number of instructions follows the versions of glslang and SPIRV-Tools: only the words around it
    // stand here.
    const std::string found = compile(material(""), limited(instructions, 3), {"normal"});
    EXPECT_TRUE(found.starts_with("error: --budget instructions=3: the forward shader of 'wall.json' takes "))
        << found;
    EXPECT_TRUE(found.ends_with(" instructions [SG1402]\n")) << found;
    EXPECT_EQ(compile(material(""), limited(instructions, 100000), {"normal"}), "");
}

}  // namespace
}  // namespace sg

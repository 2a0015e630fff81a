// Every sample in every target draws the picture that its SPIR-V draws; wrong texts do not; the table in the
// docs says so.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>

#include "tests/cross/mutants.hpp"
#include "tests/cross/results.hpp"
#include "tests/cross/wgsl.hpp"
#include "tests/support/golden.hpp"

namespace sg::cross {
namespace {

// Small, and between them: matrices of the object, sizes of textures, parameters, two samplers, back faces.
constexpr const char* kGolden[] = {"height_map", "layered", "normal_map", "object_normal_map", "planar"};

std::vector<const target::Target*> text_targets() {
    std::vector<const target::Target*> out;
    for (const target::Target& target : target::all_targets()) {
        if (target.language != target::Language::spirv) out.push_back(&target);
    }
    return out;
}

bool within(const Difference& d, const Limit& limit) {
    return d.both > 10 * d.edges && d.largest <= limit.largest && d.p999 <= limit.p999 &&
           d.one_alone <= limit.one_alone;
}

std::string words(const Difference& d) {
    return fmt::format("largest {:.2e} ({:.2e} on edges), 99.9 % {:.2e}, {} pixels in both, {} in one alone",
                       d.largest, d.on_edge, d.p999, d.both, d.one_alone);
}

class EverySample : public testing::TestWithParam<std::string> {};

TEST_P(EverySample, DrawsWhatItsSpirvDraws) {
    std::string skipped;
    for (const Result& row : results()) {
        if (row.sample != GetParam()) continue;
        if (!row.skipped.empty()) {
            skipped += fmt::format("{}: {}; ", row.target->name, row.skipped);
            continue;
        }
        EXPECT_EQ(row.refusal, "") << row.target->name;
        std::size_t planes = 0;
        for (const Shown* what : shots_of(*row.target)) planes += what->planes.size();
        EXPECT_EQ(row.shots.size(), planes) << row.target->name;
        for (const Shot& shot : row.shots) {
            const std::string text =
                fmt::format("{} {} {} {}: {}\n", row.sample, row.target->name, shot.shown->name,
                            shot.shown->planes[shot.plane], words(shot.difference));
            fmt::print("{}", text);
            EXPECT_TRUE(within(shot.difference, limit_of(*row.target, *shot.shown, sample(row.sample))))
                << text;
        }
    }
    if (!skipped.empty()) GTEST_SKIP() << skipped;
}
INSTANTIATE_TEST_SUITE_P(Materials, EverySample, testing::ValuesIn(sample_names()),
                         [](const auto& row) { return row.param; });

std::vector<const target::Target*> every_target() {
    auto out = text_targets();
    out.insert(out.begin(), target::find_target("spirv"));
    out.push_back(&wgsl_recipe());
    return out;
}

class EveryTarget : public testing::TestWithParam<const target::Target*> {};

TEST_P(EveryTarget, CatchesMistakes) {
    const target::Target& target = *GetParam();
    if (!missing_tool(target).empty()) GTEST_SKIP() << missing_tool(target);
    std::vector<Drawing> drawings;
    std::vector<std::string> names;
    for (Mutant& mutant : mutants(target)) {
        names.push_back(mutant.name);
        drawings.push_back(std::move(mutant.drawing));
    }
    auto pictures = draw_all(drawings);
    for (std::size_t i = 0; i < names.size(); ++i) {
        ASSERT_EQ(pictures[i].refusal, "") << names[i];
        const Shown& what = *drawings[i].shown;
        bool caught = false;
        for (std::size_t plane = 0; plane < what.planes.size(); ++plane) {
            const Difference d = difference(drawings[i], pictures[i], plane);
            const Limit limit = limit_of(target, what, *drawings[i].sample);
            fmt::print("{}, {}, {}: {}\n", target.name, names[i], what.planes[plane], words(d));
            caught |=
                !within(d, limit) && (d.p999 > 20 * limit.p999 || d.one_alone > 20 * (1 + limit.one_alone));
        }
        EXPECT_TRUE(caught) << names[i] << ": not caught, or too close";
    }
}

// Every text of a sample in a target, without the targets' names.
std::string all_texts(const Sample& sample, const target::Target& target) {
    const std::string mark = "." + std::string(target.name) + ".";
    std::string out;
    for (const auto& [name, text] : sample.texts) {
        std::size_t at = name.find(mark);
        if (at != name.npos) out += fmt::format("==== {} ====\n{}\n", name.substr(0, at), text);
    }
    return out;
}

TEST_P(EveryTarget, GoldenTexts) {
    const target::Target& target = *GetParam();
    if (&target == &wgsl_recipe()) GTEST_SKIP() << "surfgradc writes no WGSL";
    for (const char* name : kGolden) {
        std::string text = all_texts(shipped(name), target);
        for (const target::Target* other : text_targets()) {
            if (other == &target) break;
            if (all_texts(shipped(name), *other) == text) text = fmt::format("as {}\n", other->name);
        }
        test::expect_golden(fmt::format("cross/golden/{}.{}.texts", name, target.name), text);
    }
}
INSTANTIATE_TEST_SUITE_P(Targets, EveryTarget, testing::ValuesIn(every_target()), [](const auto& row) {
    return std::string(row.param->language == target::Language::spirv ? row.param->group : row.param->name);
});

// That every sample's WGSL is accepted says something: what is wrong is not.
TEST(Cross, DawnRefusesWrongWgsl) {
    if (!wgsl_missing().empty()) GTEST_SKIP() << wgsl_missing();
    EXPECT_EQ(dawn_refusal("@fragment fn main() -> @location(0) vec4f {\n    return vec4f(1.0);\n}\n"), "");
    EXPECT_EQ(
        dawn_refusal("@fragment fn main() -> @location(0) vec4f {\n    return vec3f(1.0);\n}\n"),
        ":2:5: return statement type must match its function return type, returned 'vec3<f32>', expected "
        "'vec4<f32>'");
}

TEST(Cross, ValidationLayersHaveNothingToSay) {
    results();
    EXPECT_EQ(validation_messages(), std::vector<std::string>{});
}

std::string cell(const Result& row, const Shown& what, std::size_t plane) {
    for (const Shot& shot : row.shots) {
        if (shot.shown == &what && shot.plane == plane)
            return fmt::format(" {:.1e} ({:.1e}) |", shot.difference.largest, shot.difference.p999);
    }
    return " - |";
}

// "largest (99.9 %)" for each plane of each picture.
std::string table() {
    std::string out = "| sample | target | accepted by | drawn by |", line = "|---|---|---|---|";
    for (const Shown& what : all_shown()) {
        for (std::string_view plane : what.planes) {
            out += what.planes.size() > 1 ? fmt::format(" `{}`, {} |", what.name, plane)
                                          : fmt::format(" `{}` |", what.name);
            line += "---|";
        }
    }
    out += "\n" + line + "\n";
    for (const Result& row : results()) {
        out += fmt::format("| {} | `{}` | {} | {} |", row.sample, row.target->name,
                           row.refusal.empty() ? accepted_by(*row.target) : "**refused**",
                           drawn_by(*row.target));
        for (const Shown& what : all_shown()) {
            for (std::size_t plane = 0; plane < what.planes.size(); ++plane) out += cell(row, what, plane);
        }
        out += "\n";
    }
    return out;
}

// Differences follow the versions of the drivers: the committed ones are compared by their presence alone.
std::string without_numbers(const std::string& text) {
    return std::regex_replace(text, std::regex("\\d\\.\\de[+-]\\d\\d"), "n");
}

TEST(Cross, TheTableInTheDocsIsWhatWasMeasured) {
    for (const Result& row : results()) {
        if (!row.skipped.empty()) GTEST_SKIP() << row.target->name << ": " << row.skipped;
    }
    const auto path = test::source_dir() / "compiler/targets.md";
    const std::string document = test::read_file(path), mark = "| sample | target |";
    const std::size_t begin = document.find(mark);
    ASSERT_NE(begin, document.npos);
    std::size_t end = document.find("\n\n", begin);
    end = end == document.npos ? document.size() : end + 1;
    if (std::getenv("SG_ACCEPT")) {
        std::ofstream(path, std::ios::binary) << document.substr(0, begin) << table() << document.substr(end);
        return;
    }
    EXPECT_EQ(without_numbers(document.substr(begin, end - begin)), without_numbers(table()))
        << "the table in compiler/targets.md is stale (a sample, a target or a tool is new): "
           "SG_ACCEPT=1 build/release/test_cross --gtest_filter='Cross.*' writes it anew";
}

}  // namespace
}  // namespace sg::cross

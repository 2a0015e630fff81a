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

constexpr const char* kSample = "layered";  // of the mutants and of the golden texts

std::vector<const target::Target*> text_targets() {
    std::vector<const target::Target*> out;
    for (const target::Target& target : target::all_targets()) {
        if (target.language != target::Language::spirv) out.push_back(&target);
    }
    return out;
}

bool within(const Difference& d, const Limit& limit) {
    return d.both > 0 && d.largest <= limit.largest && d.p999 <= limit.p999 && d.one_alone <= limit.one_alone;
}

std::string words(const Difference& d) {
    return fmt::format("largest {:.2e}, 99.9 % {:.2e}, {} pixels in both, {} in one alone", d.largest, d.p999,
                       d.both, d.one_alone);
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
        fmt::print("{} {}: {}\n", row.sample, row.target->name, words(row.difference));
        EXPECT_EQ(row.refusal, "") << row.target->name;
        EXPECT_TRUE(within(row.difference, limit_of(*row.target)))
            << row.target->name << ": " << words(row.difference);
    }
    if (!skipped.empty()) GTEST_SKIP() << skipped;
}
INSTANTIATE_TEST_SUITE_P(Materials, EverySample, testing::ValuesIn(sample_names()),
                         [](const auto& row) { return row.param; });

std::vector<const target::Target*> text_targets_and_wgsl() {
    auto out = text_targets();
    out.push_back(&wgsl_recipe());
    return out;
}

class EveryTarget : public testing::TestWithParam<const target::Target*> {};

TEST_P(EveryTarget, CatchesMistakes) {
    const target::Target& target = *GetParam();
    if (!missing_tool(target).empty()) GTEST_SKIP() << missing_tool(target);
    std::vector<Drawing> drawings;
    std::vector<std::string> names;
    for (Mutant& mutant : mutants(sample(kSample), target)) {
        names.push_back(mutant.name);
        drawings.push_back(std::move(mutant.drawing));
    }
    auto pictures = draw_all(drawings);
    for (std::size_t i = 0; i < names.size(); ++i) {
        ASSERT_FALSE(pictures[i].empty()) << names[i];
        Difference d = compare(expected(sample(kSample), target), pictures[i]);
        fmt::print("{}, {}: {}\n", target.name, names[i], words(d));
        EXPECT_FALSE(within(d, limit_of(target))) << names[i];
        EXPECT_TRUE(d.p999 > 20 * limit_of(target).p999 ||
                    d.one_alone > 20 * (1 + limit_of(target).one_alone))
            << names[i] << ": too close";
    }
}

TEST_P(EveryTarget, GoldenText) {
    for (const auto& [name, text] : sample(kSample).texts) {
        bool shown = name.find(".normal.") != name.npos &&
                     name.find("." + std::string(GetParam()->name) + ".") != name.npos;
        if (shown) test::expect_golden("cross/golden/" + name, text);
    }
}
INSTANTIATE_TEST_SUITE_P(Targets, EveryTarget, testing::ValuesIn(text_targets_and_wgsl()),
                         [](const auto& row) {
                             return std::string(row.param->language == target::Language::spirv
                                                    ? row.param->group
                                                    : row.param->name);
                         });

TEST(Cross, ValidationLayersHaveNothingToSay) {
    results();
    EXPECT_EQ(validation_messages(), std::vector<std::string>{});
}

std::string table() {
    std::string out =
        "| sample | target | accepted by | drawn by | largest difference | 99.9 % "
        "|\n|---|---|---|---|---|---|\n";
    for (const Result& row : results()) {
        out += fmt::format("| {} | `{}` | {} | {} | {:.1e} | {:.1e} |\n", row.sample, row.target->name,
                           row.refusal.empty() ? accepted_by(*row.target) : "**refused**",
                           drawn_by(*row.target), row.difference.largest, row.difference.p999);
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
        << "cmake --build build/release --target accept writes it anew";
}

}  // namespace
}  // namespace sg::cross

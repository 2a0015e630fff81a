// Levels of detail that a text leaves to the hardware. All else here is drawn with explicit ones (sample()).
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <regex>

#include "tests/cross/results.hpp"
#include "tests/cross/wgsl.hpp"

namespace sg::cross {
namespace {

using target::Language;

// Of the normals that both pictures show.
double middle_angle(const Pixels& a, const Pixels& b) {
    std::vector<double> angles;
    for (std::size_t i = 0; i < kPlane; i += 4) {
        if (a[i + 3] == 0 || b[i + 3] == 0) continue;
        const glm::dvec3 p(a[i], a[i + 1], a[i + 2]), q(b[i], b[i + 1], b[i + 2]);
        angles.push_back(std::atan2(glm::length(glm::cross(p, q)), glm::dot(p, q)));
    }
    const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
    std::nth_element(angles.begin(), middle, angles.end());
    return angles.size() > 5000 ? *middle : NAN;
}

Drawing changed(Drawing drawing, const char* pattern, const char* with) {
    const std::string text = std::regex_replace(drawing.fragment.text, std::regex(pattern), with);
    EXPECT_NE(text, drawing.fragment.text) << pattern;
    drawing.fragment.text = text;
    return drawing;
}

Drawing half_a_level_finer(const Drawing& own) {
    return changed(own, "uv\\.st, uv\\.dx, uv\\.dy\\)", "uv.st, 0.70710678 * uv.dx, 0.70710678 * uv.dy)");
}
Drawing biased(const Drawing& hardware) {
    if (hardware.target->language == Language::hlsl)
        return changed(hardware, "Sample\\(filtering, uv\\.st\\)", "SampleBias(filtering, uv.st, -0.5)");
    return changed(hardware, "texture\\(image, uv\\.st\\)", "texture(image, uv.st, -0.5)");
}

// Metal is drawn with level 0 alone.
std::vector<const target::Target*> targets_with_levels() {
    std::vector<const target::Target*> out;
    for (const target::Target& target : target::all_targets()) {
        if (target.language != Language::spirv && target.language != Language::msl) out.push_back(&target);
    }
    return out;
}

class HardwareLevels : public testing::TestWithParam<const target::Target*> {};

// What the hardware's choice moves normals by, in the middle, against what half a level does: less than a
// quarter, so an eighth of a level. A bias of half a level is not.
TEST_P(HardwareLevels, AreThoseOfTheDerivatives) {
    const target::Target& target = *GetParam();
    if (!missing_tool(target).empty()) GTEST_SKIP() << missing_tool(target);
    constexpr const char* kSamples[] = {"normal_map", "two_unwraps", "layered"};
    std::vector<Drawing> drawings;
    for (const char* name : kSamples) {
        const Drawing own = drawing(sample(name), target), hardware = drawing(shipped(name), target);
        for (const Drawing& each : {own, half_a_level_finer(own), hardware, biased(hardware)})
            drawings.push_back(each);
    }
    const std::vector<Drawn> drawn = draw_all(drawings);
    for (std::size_t i = 0; i < drawn.size(); i += 4) {
        for (std::size_t k = i; k < i + 4; ++k) ASSERT_EQ(drawn[k].refusal, "");
        const double half = middle_angle(drawn[i].pixels, drawn[i + 1].pixels);
        const double hardware = middle_angle(drawn[i].pixels, drawn[i + 2].pixels) / half;
        const double wrong = middle_angle(drawn[i].pixels, drawn[i + 3].pixels) / half;
        fmt::print(
            "{}, {}: half a level {:.4f} degrees; the hardware's choice {:.3f} of it, with a bias of -0.5 "
            "{:.3f}\n",
            target.name, kSamples[i / 4], half * 57.29578, hardware, wrong);
        EXPECT_LT(hardware, 0.25);
        EXPECT_GT(wrong, 0.25);
        EXPECT_GT(half * 57.29578, 1e-3);
    }
}
INSTANTIATE_TEST_SUITE_P(Targets, HardwareLevels, testing::ValuesIn(targets_with_levels()),
                         [](const auto& row) { return std::string(row.param->name); });

// Where level 0 alone is drawn nothing is left to choose: what was shipped draws the same.
TEST(HardwareLevels, DoNotCountAtLevelZero) {
    for (const char* name : {"msl21", "msl23", "wgsl"}) {
        const target::Target& target =
            std::string_view(name) == "wgsl" ? wgsl_recipe() : *target::find_target(name);
        if (!missing_tool(target).empty()) continue;
        std::vector<Drawing> drawings;
        for (const char* of : {"layered", "perforated"})
            drawings.push_back(&target == &wgsl_recipe() ? wgsl_drawing(shipped(of), shown("normal"))
                                                         : drawing(shipped(of), target));
        const std::vector<Drawn> drawn = draw_all(drawings);
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            ASSERT_EQ(drawn[i].refusal, "") << name;
            const Difference d = difference(drawings[i], drawn[i], 0);
            const Limit limit = limit_of(target, shown("normal"), *drawings[i].sample);
            EXPECT_LE(d.largest, limit.largest) << name;
            EXPECT_LE(d.p999, limit.p999) << name;
            EXPECT_GT(d.both, 1000u) << name;
        }
    }
}

}  // namespace
}  // namespace sg::cross

// Every sample in every target: accepted by which tool, drawn by what, how far from the SPIR-V.
#pragma once

#include <string>
#include <vector>

#include "tests/cross/scene.hpp"

namespace sg::cross {

// How far a plane of a picture is from the SPIR-V's.
struct Shot {
    const Shown* shown = nullptr;
    std::size_t plane = 0;
    Difference difference;
};
struct Result {
    std::string sample;
    const target::Target* target = nullptr;
    std::string skipped;      // "" or why nothing was checked
    std::string refusal;      // "" or a tool's words about any entry point
    std::vector<Shot> shots;  // in the order of shots_of
};

// What is drawn in a target: everything; but in WGSL no `debug`, which SwiftShader compiles for long (it is
// compiled by Chromium alone), and
// nothing without a SPIR-V; of spirv, which the others are compared with, the function alone, in Vulkan's
// GLSL.
std::vector<const Shown*> shots_of(const target::Target& target);

// Samples by name, in each the targets in their order. Made once, on the first call.
const std::vector<Result>& results();

// How far a picture in a target may be from the SPIR-V's; the derivation stands at the definition.
struct Limit {
    double largest = 0, p999 = 0;
    std::size_t one_alone = 0;  // pixels
};
Limit limit_of(const target::Target& target, const Shown& shown = shown("normal"));
// The same for a sample: a ray that is marched magnifies what a rounding does.
Limit limit_of(const target::Target& target, const Shown& shown, const Sample& sample);

// The tools of a target, for people.
std::string_view accepted_by(const target::Target& target);
std::string_view drawn_by(const target::Target& target);

// "" or why a target cannot be checked here.
std::string missing_tool(const target::Target& target);

// Draws each. All of one target.
struct Drawn {
    Pixels pixels;  // empty where a text was refused
    std::string refusal;
    std::vector<bool> on_edge;  // for Measure
};
std::vector<Drawn> draw_all(const std::vector<Drawing>& drawings);
// What to compare a drawing of `sample` with.
const Pixels& expected(const Sample& sample, const target::Target& target,
                       const Shown& shown = shown("normal"));

// How fast what is shown changes where a normal or a colour does, by pixel; empty: as fast.
std::vector<double> unit_of(const Sample& sample, const target::Target& target, const Shown& shown);
// From what is expected, of one plane, in that unit.
Difference difference(const Drawing& drawing, const Drawn& drawn, std::size_t plane);

}  // namespace sg::cross

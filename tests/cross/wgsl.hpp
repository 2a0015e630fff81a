// The documented way to WGSL: naga (npm naga-wasm) reads our SPIR-V, Chromium's WebGPU draws what it writes.
#pragma once

#include "tests/cross/browser.hpp"

namespace sg::cross {

// Stands for the recipe among the targets. It is none: surfgradc does not write it.
const target::Target& wgsl_recipe();

// "" or why the recipe cannot be followed here.
std::string wgsl_missing();

// An entry point in WGSL. Throws with naga's words where it cannot be written.
Drawing wgsl_drawing(const Sample& sample, const Shown& shown = shown("normal"));
// "" or naga's words about any entry point; else those that are not drawn add their texts to `texts`.
std::string wgsl_refusal(const Sample& sample, std::vector<std::string>& texts);

// Compared with base_sample(): level 0 of each texture alone. `texts` are compiled alone.
PageOutcome wgsl_draw(const std::vector<Drawing>& drawings, const std::vector<std::string>& texts);

}  // namespace sg::cross

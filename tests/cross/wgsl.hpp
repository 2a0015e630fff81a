// The documented way to WGSL: naga (npm naga-wasm) reads our SPIR-V, Dawn (npm webgpu) accepts what it
// writes, Chromium's WebGPU draws it.
#pragma once

#include "tests/cross/browser.hpp"

namespace sg::cross {

// Stands for the recipe among the targets. It is none: surfgradc does not write it.
const target::Target& wgsl_recipe();

// "" or why the recipe cannot be followed here.
std::string wgsl_missing();

// "" or the place and words of Dawn (npm webgpu) about a text.
std::string dawn_refusal(const std::string& text);

// An entry point in WGSL. Throws with naga's words where it cannot be written.
Drawing wgsl_drawing(const Sample& sample, const Shown& shown = shown("normal"));
// "" or naga's or Dawn's words about any entry point; else those that are not drawn add their texts to
// `texts`.
std::string wgsl_refusal(const Sample& sample, std::vector<std::string>& texts);

// Compared with base_sample(): level 0 of each texture alone. `texts` are compiled alone.
PageOutcome wgsl_draw(const std::vector<Drawing>& drawings, const std::vector<std::string>& texts);

}  // namespace sg::cross

// What a language cannot say: found in the SPIR-V before it is written, for SPIRV-Cross refuses some of it in
// its own words and writes some of it wrong.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "target/targets.hpp"

namespace sg::target {

// "" or what the shader does that the target cannot express, as in "asks for the level of detail of a
// texture". `words` are those of the source without the target's prelude.
std::string missing_feature(std::span<const std::uint32_t> words, const Target& target);

}  // namespace sg::target

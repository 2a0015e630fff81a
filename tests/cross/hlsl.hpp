// HLSL back to SPIR-V through glslang's HLSL front end. It runs as a child process, for it can crash.
#pragma once

#include "tests/cross/scene.hpp"

namespace sg::cross {

// Every binding is moved from its register to the set and binding that the manifest states for it. Throws with
// glslang's words where it refuses the text.
ShaderWords hlsl_to_words(const Drawing& drawing);

// "" or what glslang's HLSL front end says to a text.
std::string hlsl_refusal(const std::string& text, bool vertex);

}  // namespace sg::cross

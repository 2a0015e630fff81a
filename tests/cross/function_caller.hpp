// An engine's fragment shader, made of the one of `forward`: it keeps the declarations and calls the
// material's function in the place of everything else.
#pragma once

#include <string>

#include "tests/cross/scene.hpp"

namespace sg::cross {

// `text` is the fragment shader of `forward` in that target; for spirv the generated GLSL. What it shows
// becomes the normal that the function returns.
void call_function(std::string& text, const Sample& sample, const target::Target& target);

// The function itself.
const std::string& function_text(const Sample& sample, const target::Target& target);

}  // namespace sg::cross

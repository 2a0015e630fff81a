// Text work for the entry point `function`: what an engine includes in a shader of its own.
#pragma once

#include <string>
#include <string_view>

#include "target/shader_library.hpp"

namespace sg::target {

// GLSL with each file of the library that it includes in its place, once, behind what that one includes. The
// files keep their guards: two such texts can stand in one shader.
std::string without_includes(std::string_view text, const ShaderLibrary& library);

// The structs, constants and functions of a cross-compiled shader, without its resources, inputs, outputs and
// entry point. What does not end in `suffix` is not this function's alone (types that all materials share,
// helpers of the cross-compiler): it gets a guard.
std::string declarations_for_inclusion(std::string_view text, std::string_view suffix);

// The declaration of a function in a text: from its result to the closing parenthesis, on one line; "" if
// absent.
std::string signature_of(std::string_view text, std::string_view function);

}  // namespace sg::target

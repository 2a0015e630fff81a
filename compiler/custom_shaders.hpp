// The user's GLSL, verified alone: what it may say, that it compiles, that its functions are what the layers
// call.
#pragma once

#include <span>
#include <string>
#include <utility>

#include "base/diag.hpp"
#include "material/checked.hpp"
#include "target/shader_library.hpp"

namespace sg {

using Defines = std::vector<std::pair<std::string, std::string>>;  // name and value of macros

// Fills in CheckedShader::text. False exactly when it added an error.
bool verify_shaders(material::CheckedMaterial& material, const Defines& defines,
                    const target::ShaderLibrary& library, const SourcePtr& json, Diags& diags);

}  // namespace sg

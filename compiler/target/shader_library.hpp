// The GLSL library as text by include name ("surfgrad/frame.glsl").
#pragma once

#include <map>
#include <string>

namespace sg::target {

struct ShaderLibrary {
    std::map<std::string, std::string> files;
};

// The files of shader_lib/ as they were when the compiler was built.
ShaderLibrary embedded_library();

}  // namespace sg::target

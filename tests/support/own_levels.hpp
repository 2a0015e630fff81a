// The library with every level of detail by the pixel's own derivatives, as the interpreter has it. Where a
// text leaves the level to the hardware, that may be of another of 2x2 pixels (Vulkan 1.1, 15.3), or of the
// driver's own logarithm; that it is about the same is shown by itself.
#pragma once

#include <stdexcept>

#include "target/shader_library.hpp"

namespace sg::test {

// `factor`: "" or what the derivatives are multiplied with, as "0.5 * ".
inline target::ShaderLibrary with_own_levels(const std::string& factor = "") {
    target::ShaderLibrary library = target::embedded_library();
    std::string& text = library.files["stage/fragment.glsl"];
    const std::string hardware = "return texture(sampler2D(image, filtering), uv.st);";
    const std::size_t at = text.find(hardware);
    if (at == std::string::npos) throw std::runtime_error("the library changed: " + hardware);
    text.replace(
        at, hardware.size(),
        "return textureGrad(sampler2D(image, filtering), uv.st, " + factor + "uv.dx, " + factor + "uv.dy);");
    return library;
}

}  // namespace sg::test

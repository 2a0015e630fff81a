// Drawing with Mesa's OpenGL and OpenGL ES without a window: EGL on the surfaceless platform.
#pragma once

#include "tests/cross/scene.hpp"

namespace sg::cross {

// "" or why there is no such context here. OpenGL 4.5 for GLSL, OpenGL ES 3.1 for ESSL.
std::string gl_missing(target::Language language);

// Fed exactly as the manifest says and with GL's own conventions: depth -1..1, rows bottom to top,
// counter-clockwise fronts. Throws with the driver's words where it refuses a text.
Pixels gl_draw(const Drawing& drawing);

// "" or what the driver says to a pair of shaders.
std::string gl_refusal(const std::string& vertex, const std::string& fragment, target::Language language);

}  // namespace sg::cross

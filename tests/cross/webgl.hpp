// Drawing with WebGL 2: pages that headless Chromium opens once, many drawings in each.
#pragma once

#include "tests/cross/browser.hpp"

namespace sg::cross {

// "" or why there is no such browser here.
std::string webgl_missing();

// Throws where the browser gives no answer.
PageOutcome webgl_draw(const std::vector<Drawing>& drawings);

}  // namespace sg::cross

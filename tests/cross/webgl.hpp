// Drawing with WebGL 2: one page that headless Chromium opens once, all drawings in it.
#pragma once

#include "tests/cross/scene.hpp"

namespace sg::cross {

// "" or why there is no such browser here.
std::string webgl_missing();

struct ShaderPair {
    std::string vertex, fragment;
};
struct WebglOutcome {
    std::vector<Pixels> pictures;        // of the drawings; empty where it was refused
    std::vector<std::string> refusals;   // "" or the browser's words: of the drawings, then of the pairs
};
// Pairs are compiled and linked alone. Throws where the browser gives no answer.
WebglOutcome webgl_draw(const std::vector<Drawing>& drawings, const std::vector<ShaderPair>& pairs);

}  // namespace sg::cross

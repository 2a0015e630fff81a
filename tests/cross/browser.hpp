// Headless Chromium: a page that draws while it is opened, and leaves its pictures as text in its body.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/cross/scene.hpp"

namespace sg::cross {

std::string browser();  // the program's name, or ""

std::string base64(const void* data, std::size_t size);
template <typename T>
std::string base64(const std::vector<T>& values) {
    return base64(values.data(), values.size() * sizeof(T));
}

// What the body says of a page with that script in it.
std::string body_of(const std::string& script, const std::string& flags);

struct PageOutcome {
    std::vector<Pixels> pictures;       // of the first `drawings` lines; empty where it was refused
    std::vector<std::string> refusals;  // "" or the browser's words, by line
    void add(PageOutcome&& other);
};
// What one page draws: it keeps all that it made until it ends. One page at least.
std::vector<std::span<const Drawing>> pages_of(std::span<const Drawing> drawings);
// Runs files of this folder, in order, over `const input`; they leave a line per drawing and per further
// check.
PageOutcome run_page(const std::string& input, const std::vector<std::string>& scripts,
                     const std::string& flags, std::size_t drawings, std::size_t further);

}  // namespace sg::cross

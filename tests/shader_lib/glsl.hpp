// GLSL text to SPIR-V words for the tests of the shader library, with the library read from disk and, for a
// mutant, one text in it replaced.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sg::proof {

// A deliberate mistake: in `file` (under shader_lib/, say "surfgrad/tbn.glsl") the first `find` becomes
// `replace`.
struct Mutant {
    std::string file;
    std::string find;
    std::string replace;
};

// The text of a library file. Ends the process when it cannot be read: a test without its library means
// nothing.
std::string library_text(const std::string& file);

// The text of a library file with the mutant applied; empty when `find` does not occur exactly once.
std::optional<std::string> mutated_text(const Mutant& mutant);

enum class Stage { compute, fragment };

struct Compiled {
    std::vector<std::uint32_t> words;  // empty on failure
    std::string log;                   // the compiler's own words on failure
};
// `text` begins after the #version line. Vulkan 1.1 rules, #version 450. Includes resolve below shader_lib/.
Compiled compile_glsl(const std::string& text, Stage stage = Stage::compute, const Mutant* mutant = nullptr);

}  // namespace sg::proof

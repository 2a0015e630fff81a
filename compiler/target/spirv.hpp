// GLSL text to SPIR-V words: glslang, spirv-opt and spirv-val in process. The only file that sees any of
// them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "target/shader_library.hpp"

namespace sg::target {

enum class Stage { vertex, fragment, compute };

enum class Optimise {
    none,
    speed,
    size,  // as speed, and names are stripped
};

struct SpirvOptions {
    Optimise optimise = Optimise::speed;
    bool debug_info = false;  // sources and lines
};

using Words = std::vector<std::uint32_t>;

// Compiles for Vulkan 1.1 (SPIR-V 1.3) and validates the result. `#include` finds the library's files alone;
// `name` stands for the text in messages. An empty result has the first fault in `fault` ("name:line: what").
// Thread-safe; the first call in a process costs about 0.15 s (glslang reads its built-in declarations).
std::optional<Words> compile_glsl(std::string_view text, std::string_view name, Stage stage,
                                  const ShaderLibrary& library, const SpirvOptions& options,
                                  std::string& fault);

// A text in several parts, each with a name and lines of its own.
struct GlslPart {
    std::string_view name;
    std::string_view text;
};
struct GlslFault {
    std::string part;        // its name, or that of a file of the library
    std::uint32_t line = 0;  // from 1; 0: nowhere
    std::string what;
    std::vector<std::string> details;  // what the lines behind that one say, where the linker is at fault
};
// Reads and links, no more: the first fault.
std::optional<GlslFault> check_glsl(std::span<const GlslPart> parts, Stage stage,
                                    const ShaderLibrary& library);

// The steps of compile_glsl, to measure them.
std::optional<Words> front_end(std::string_view text, std::string_view name, Stage stage,
                               const ShaderLibrary& library, bool debug_info, std::string& fault);
std::optional<Words> run_optimizer(const Words& words, Optimise level, std::string& fault);

// "" or what spirv-val says for Vulkan 1.1.
std::string validate(std::span<const std::uint32_t> words);

// Assembly text with friendly names, without the header's comment lines.
std::string disassemble(std::span<const std::uint32_t> words);

// Instructions that do work: all but names, decorations, types, constants and other declarations.
std::size_t instruction_count(std::span<const std::uint32_t> words);

// The words as the bytes of a .spv file, little-endian.
std::string bytes(std::span<const std::uint32_t> words);

}  // namespace sg::target

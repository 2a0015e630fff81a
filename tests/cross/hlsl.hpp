// HLSL back to SPIR-V through glslang's HLSL front end. It runs as a child process, for it can crash.
#pragma once

#include "tests/cross/scene.hpp"

namespace sg::cross {

// Every binding is moved from its register to the set and binding that the manifest states for it. Throws
// with glslang's words where it refuses the text.
ShaderWords hlsl_to_words(const Drawing& drawing);

struct HlslText {
    std::string text;
    bool vertex = false;
};
// "" or what glslang's HLSL front end says, by text; two child processes at a time.
std::vector<std::string> hlsl_refusals(const std::vector<HlslText>& texts);

// An engine's own shader with a file that it includes, and registers as `slots` has them. Its locations
// follow the order of its varyings, and those of vertex attributes the semantics; clip space is Vulkan's.
// Throws.
struct HlslInclude {
    std::string file, text;
};
std::vector<std::uint32_t> hlsl_engine(const std::string& text, const HlslInclude& include,
                                       const std::string& entry, bool vertex, const std::vector<Slot>& slots);

}  // namespace sg::cross

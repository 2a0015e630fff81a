// SPIR-V to the text of another language: SPIRV-Cross in process. The only file that sees it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emit/interface.hpp"
#include "target/spirv.hpp"
#include "target/targets.hpp"

namespace sg::target {

// Where the text has what the SPIR-V has at (set, binding).
struct Slot {
    emit::BindingKind kind{};
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
    std::string name;         // in the text: of the block, or of the variable
    std::uint32_t index = 0;  // HLSL: register; Metal: index; GL: binding point of a block, unit of a texture
    std::uint32_t space = 0;  // HLSL
    std::uint32_t sampler_binding = 0;  // GL: the binding of the sampler that the texture is read with
};

struct Attribute {
    std::uint32_t location = 0;
    std::string name;  // HLSL: the semantic; GL: the variable
};

struct CrossText {
    std::string text;
    std::string function;               // that the text's entry point is called
    std::vector<Slot> slots;            // what the text uses, by set and binding; GL has no samplers alone
    std::vector<Attribute> attributes;  // of a vertex shader, by location
};

// `words` have names and are not optimised, so that the text reads as the library does. The numbers of the
// slots are those of the material, alike for all stages and entry points. Every target but spirv.
// Nothing, and why, for what the language cannot say and missing_feature does not know: the user's GLSL alone
// can hold that.
std::optional<CrossText> cross_compile(const Words& words, Stage stage, const Target& target,
                                       const emit::MaterialInterface& material, std::string& fault);

// A shader that does nothing but call one function: that function and what it needs, to be included in an
// engine's shader. Whatever is not in `shared` gets `suffix` behind its name, so that no two such texts
// collide. `words` as above. Every target but spirv.
std::optional<std::string> cross_compile_function(const Words& words, const Target& target,
                                                  std::string_view suffix,
                                                  std::span<const std::string_view> shared,
                                                  std::string& fault);

}  // namespace sg::target

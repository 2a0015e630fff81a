// THE table of targets: what `surfgradc compile --target` takes and how each is written.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sg::target {

enum class Language { spirv, hlsl, msl, glsl, essl };

struct Target {
    std::string_view name;       // "hlsl60"; part of the file's name
    std::string_view group;      // "hlsl": all of its targets
    std::string_view extension;  // "hlsl"
    Language language{};
    std::uint32_t version = 0;  // as SPIRV-Cross counts: shader model 60, Metal 20300, GLSL 450
    std::string_view prelude;   // GLSL lines in front of the source that say what the target lacks otherwise
    std::string_view doc;
};

std::span<const Target> all_targets();
const Target* find_target(std::string_view name);

// Every word that a list of targets may hold: names and groups.
std::vector<std::string> target_words();
// The targets that the words name, in the table's order, each once.
std::vector<const Target*> select_targets(std::span<const std::string> words);

// The text of a shader with the target's prelude behind its first directives.
std::string with_prelude(std::string_view glsl, const Target& target);

}  // namespace sg::target

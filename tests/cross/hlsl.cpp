#include "tests/cross/hlsl.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <regex>
#include <stdexcept>

#include "tests/cross/process.hpp"
#include "tests/support/golden.hpp"

namespace sg::cross {
namespace {

constexpr std::uint32_t kTextures = 100,
                        kSamplers = 200;  // glslang has one number space: t and s are shifted apart

// glslang numbers locations in the order of appearance and does not look at TEXCOORDn. It copies a constant
// table wherever one of its numbers is read, which a driver takes half a minute to compile; a variable it
// does not copy.
std::string for_glslang(const std::string& text) {
    static const std::regex kSemantic("(\\n\\s*)(\\w+ \\w+ : TEXCOORD)(\\d+);");
    static const std::regex kTable("static const (\\w+ \\w+\\[)");
    return std::regex_replace(std::regex_replace(text, kSemantic, "$1[[vk::location($3)]] $2$3;"), kTable,
                              "static $1");
}

std::string options(bool vertex) {
    return fmt::format("-D -V --target-env vulkan1.1 -S {} -e main --stb {} --ssb {} {}",
                       vertex ? "vert" : "frag", kTextures, kSamplers, vertex ? "--invert-y" : "");
}

// The (set, binding) of what stands at a register.
const Slot& slot_at(const std::vector<Slot>& slots, std::uint32_t shifted, std::uint32_t space) {
    std::string kind = shifted >= kSamplers ? "sampler" : shifted >= kTextures ? "texture" : "uniform_buffer";
    std::uint32_t index = shifted % kTextures;
    for (const Slot& slot : slots) {
        if (slot.kind == kind && slot.index == index && slot.space == space) return slot;
    }
    throw std::runtime_error(
        fmt::format("the manifest has no {} at register {}, space {}", kind, index, space));
}

void move_bindings(std::vector<std::uint32_t>& words, const std::vector<Slot>& slots) {
    constexpr std::uint32_t kDecorate = 71, kBinding = 33, kSet = 34;
    struct Place {
        std::uint32_t* set = nullptr;
        std::uint32_t* binding = nullptr;
    };
    std::map<std::uint32_t, Place> places;
    for (std::size_t i = 5; i < words.size(); i += std::max(1u, words[i] >> 16u)) {
        if ((words[i] & 0xFFFFu) != kDecorate) continue;
        if (words[i + 2] == kBinding) places[words[i + 1]].binding = &words[i + 3];
        if (words[i + 2] == kSet) places[words[i + 1]].set = &words[i + 3];
    }
    for (auto& [id, place] : places) {
        if (!place.set || !place.binding) throw std::runtime_error("a resource without a register");
        const Slot& slot = slot_at(slots, *place.binding, *place.set);
        *place.binding = slot.binding;
        *place.set = slot.set;
    }
}

std::vector<std::uint32_t> read_words(const std::filesystem::path& file, const std::vector<Slot>& slots) {
    const std::string bytes = test::read_file(file);
    std::vector<std::uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), words.size() * 4);
    move_bindings(words, slots);
    return words;
}

// Texts by the file that they were written to: many targets, samples and drawings share them.
std::map<std::string, std::string>& files() {
    static std::map<std::string, std::string> instance;
    return instance;
}

std::vector<std::uint32_t> to_words(const Stage& stage, bool vertex) {
    std::string refusal = hlsl_refusals({{stage.text, vertex}}).at(0);
    if (!refusal.empty()) throw std::runtime_error(refusal);
    return read_words(files().at(stage.text) + ".spv", stage.slots);
}

}  // namespace

ShaderWords hlsl_to_words(const Drawing& drawing) {
    return {to_words(drawing.vertex, true), to_words(drawing.fragment, false)};
}

std::vector<std::string> hlsl_refusals(const std::vector<HlslText>& texts) {
    std::string commands;
    for (const HlslText& text : texts) {
        auto [at, fresh] =
            files().try_emplace(text.text, (scratch() / fmt::format("text{}.hlsl", files().size())).string());
        if (!fresh) continue;
        write_file(at->second, for_glslang(text.text));
        commands += fmt::format("glslangValidator {} -o {}.spv {} > {}.log 2>&1 || echo refused >> {}.log\n",
                                options(text.vertex), at->second, at->second, at->second, at->second);
    }
    write_file(scratch() / "commands", commands);
    if (!commands.empty())
        run(fmt::format("xargs -P 2 -d '\\n' -n 1 sh -c < '{}'", (scratch() / "commands").string()));
    std::vector<std::string> out;
    for (const HlslText& text : texts) {
        std::string log = test::read_file(files().at(text.text) + ".log");
        out.push_back(log.find("refused\n") == log.npos && !log.empty() ? "" : "glslang: " + log);
    }
    return out;
}

std::vector<std::uint32_t> hlsl_engine(const std::string& text, const HlslInclude& include,
                                       const std::string& entry, bool vertex,
                                       const std::vector<Slot>& slots) {
    static const std::pair<const char*, int> kAttributes[] = {
        {"POSITION", 0}, {"NORMAL", 1}, {"TANGENT", 2}, {"TEXCOORD0", 4}, {"TEXCOORD1", 5}};
    std::string located = text;
    for (const auto& [semantic, location] : kAttributes) {
        const std::regex row(fmt::format("(\\w+ \\w+ : {};)", semantic));
        located = std::regex_replace(located, row, fmt::format("[[vk::location({})]] $1", location));
    }
    const auto source = scratch() / "engine.hlsl", result = scratch() / "engine.spv";
    write_file(source, located);
    write_file(scratch() / include.file, include.text);
    const Outcome outcome =
        run(fmt::format("glslangValidator -D -V --target-env vulkan1.1 -S {} -e main --source-entrypoint {} "
                        "--stb {} --ssb {} '-I{}' "
                        "-o '{}' '{}' 2>&1",
                        vertex ? "vert" : "frag", entry, kTextures, kSamplers, scratch().string(),
                        result.string(), source.string()));
    if (outcome.exit_code != 0) throw std::runtime_error("glslang: " + outcome.text);
    return read_words(result, slots);
}

}  // namespace sg::cross

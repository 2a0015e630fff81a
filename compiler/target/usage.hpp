// What a SPIR-V module still uses after optimising: inputs, resources and how many reads of textures.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>

namespace sg::target {

struct Usage {
    // Location of each stage input, and how many numbers it is.
    std::map<std::uint32_t, std::uint32_t> inputs;
    std::set<std::pair<std::uint32_t, std::uint32_t>> bindings;  // set and binding of resources
    // Instructions that sample, gather or fetch texels; each counts once, however often a loop runs it. A
    // query (of the size, of the level) reads no texel.
    std::uint32_t texture_reads = 0;

    // Of all inputs together.
    [[nodiscard]] std::uint32_t input_numbers() const;
};

// `words` must be valid.
Usage usage(std::span<const std::uint32_t> words);

}  // namespace sg::target

// What a SPIR-V module still uses after optimising.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <utility>

namespace sg::target {

struct Usage {
    std::set<std::uint32_t> inputs;                              // locations of stage inputs
    std::set<std::pair<std::uint32_t, std::uint32_t>> bindings;  // set and binding of resources
};

// `words` must be valid.
Usage usage(std::span<const std::uint32_t> words);

}  // namespace sg::target

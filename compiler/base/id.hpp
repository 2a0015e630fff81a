// Typed indices: an Id<Value> cannot be mistaken for an Id<Texture>, prints as a number and owns nothing.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>

namespace sg {

template <class Tag>
struct Id {
    std::uint32_t index = std::numeric_limits<std::uint32_t>::max();

    [[nodiscard]] bool valid() const { return index != std::numeric_limits<std::uint32_t>::max(); }
    auto operator<=>(const Id&) const = default;
};

}  // namespace sg

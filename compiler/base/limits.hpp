// Bounds that the compiler keeps to and the runtime relies on.
#pragma once

#include <cstdint>

namespace sg {

// Of a uniform block: what every device takes.
inline constexpr std::uint32_t kMaxBlockBytes = 1u << 14u;
// Derived parameters in it; those that find no room stay in the shader.
inline constexpr std::uint32_t kMaxDerived = 256;

}  // namespace sg

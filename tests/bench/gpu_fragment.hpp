// What a fragment shader costs on the GPU of gpu_statistics.hpp.
#pragma once

#include "gpu_statistics.hpp"

namespace sg::bench {

// Any fragment shader of Vulkan 1.1, fed by a vertex shader that hands every input through, so that nothing
// is constant.
std::optional<GpuStatistics> fragment_statistics(std::span<const std::uint32_t> words);

}  // namespace sg::bench

// What a shader costs on a GPU that need not be there: Mesa's RADV compiles for AMD without a device.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace sg::bench {

struct GpuStatistics {
    std::uint64_t instructions = 0;
    std::uint64_t inverse_throughput = 0;  // the compiler's estimate, cycles
    std::uint64_t vector_registers = 0;
    std::uint64_t waves = 0;  // that a SIMD can hold at once
};

// A compute shader (entry "main"; one descriptor set: binding 0 and 1 storage buffers, 2 a uniform block,
// 3 a texture2D, 4 a sampler; it need not use them all).
// Wants the environment kGpuEnvironment from the start of the process; empty where that driver is missing or
// refuses.
std::optional<GpuStatistics> gpu_statistics(std::span<const std::uint32_t> words);

// The version of that driver, "22.3.6" say; "" where it is missing. Other versions count otherwise.
std::string gpu_driver_version();

// Shell assignments that make this process see RADV's null device alone.
inline constexpr const char* kGpuEnvironment =
    "RADV_FORCE_FAMILY=navi21 RADV_DEBUG=nocache "
    "VK_ICD_FILENAMES=/usr/share/vulkan/icd.d/radeon_icd.x86_64.json";

}  // namespace sg::bench

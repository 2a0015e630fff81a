// What the files gpu_*.cpp share: the null device and what it tells of a pipeline.
#pragma once

#include <vulkan/vulkan.h>

#include "gpu_statistics.hpp"

namespace sg::bench {

// Null where the driver is missing or refuses. Lives until the process ends.
VkDevice gpu_device();

// Of a pipeline that was made with VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR.
std::optional<GpuStatistics> pipeline_statistics(VkDevice device, VkPipeline pipeline,
                                                 VkShaderStageFlagBits stage);

}  // namespace sg::bench

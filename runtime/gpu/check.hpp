// Results of Vulkan calls become diagnostics.
#pragma once

#include <vulkan/vulkan.h>

#include <string>
#include <string_view>

#include "base/diag.hpp"

namespace sg::runtime::gpu {

// "VK_ERROR_DEVICE_LOST", or the number of a result without a name here.
std::string result_name(VkResult result);

// True on VK_SUCCESS; otherwise adds vulkan_failed, which names the call and the result.
bool check(VkResult result, std::string_view call, Diags& diags);

}  // namespace sg::runtime::gpu

// Descriptor sets: what is bound where, the layout made from it, and sets that hold it.
#pragma once

#include <vulkan/vulkan.h>

#include <optional>
#include <span>
#include <vector>

#include "base/diag.hpp"
#include "runtime/gpu/device.hpp"
#include "runtime/gpu/handle.hpp"

namespace sg::runtime::gpu {

// The layout of one set; an empty list makes an empty layout.
std::optional<OwnedSetLayout> make_set_layout(const Device& device,
                                              std::span<const VkDescriptorSetLayoutBinding> bindings,
                                              Diags& diags);

// Exactly one of buffer, view and sampler is set, as `kind` says.
struct Binding {
    std::uint32_t binding = 0;
    VkDescriptorType kind = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize offset = 0;
    VkDeviceSize range = VK_WHOLE_SIZE;
    VkImageView view = VK_NULL_HANDLE;  // in VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL
    VkSampler sampler = VK_NULL_HANDLE;
};

// Sets of one pool; they live as long as it does.
class DescriptorSets {
public:
    // One set per entry of `sets`, written in that order; layouts[i] is the layout of sets[i].
    static std::optional<DescriptorSets> create(const Device& device,
                                                std::span<const VkDescriptorSetLayout> layouts,
                                                const std::vector<std::vector<Binding>>& sets, Diags& diags);
    [[nodiscard]] VkDescriptorSet operator[](std::size_t index) const { return sets_[index]; }

private:
    OwnedDescriptorPool pool_;
    std::vector<VkDescriptorSet> sets_;
};

}  // namespace sg::runtime::gpu

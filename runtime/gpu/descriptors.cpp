#include "runtime/gpu/descriptors.hpp"

#include <map>

#include "base/ice.hpp"
#include "runtime/gpu/check.hpp"

namespace sg::runtime::gpu {
namespace {

std::vector<VkDescriptorPoolSize> pool_sizes(const std::vector<std::vector<Binding>>& sets) {
    std::map<VkDescriptorType, std::uint32_t> counts;
    for (const auto& set : sets) {
        for (const Binding& binding : set) ++counts[binding.kind];
    }
    if (counts.empty()) counts[VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER] = 1;  // a pool must hold something
    std::vector<VkDescriptorPoolSize> out;
    for (auto [kind, count] : counts) out.push_back({kind, count});
    return out;
}

void write(VkDevice device, VkDescriptorSet set, const Binding& binding) {
    VkDescriptorBufferInfo buffer{binding.buffer, binding.offset, binding.range};
    VkDescriptorImageInfo image{binding.sampler, binding.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    auto info = make_info<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
    info.dstSet = set;
    info.dstBinding = binding.binding;
    info.descriptorCount = 1;
    info.descriptorType = binding.kind;
    info.pBufferInfo = binding.buffer != VK_NULL_HANDLE ? &buffer : nullptr;
    info.pImageInfo = binding.buffer == VK_NULL_HANDLE ? &image : nullptr;
    vkUpdateDescriptorSets(device, 1, &info, 0, nullptr);
}

}  // namespace

std::optional<OwnedSetLayout> make_set_layout(const Device& device,
                                              std::span<const VkDescriptorSetLayoutBinding> bindings,
                                              Diags& diags) {
    auto info =
        make_info<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    info.bindingCount = static_cast<std::uint32_t>(bindings.size());
    info.pBindings = bindings.data();
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    if (!check(vkCreateDescriptorSetLayout(device.get(), &info, nullptr, &layout),
               "vkCreateDescriptorSetLayout", diags)) {
        return std::nullopt;
    }
    return OwnedSetLayout(device.get(), layout);
}

std::optional<DescriptorSets> DescriptorSets::create(const Device& device,
                                                     std::span<const VkDescriptorSetLayout> layouts,
                                                     const std::vector<std::vector<Binding>>& sets,
                                                     Diags& diags) {
    SG_ASSERT(layouts.size() == sets.size() && !sets.empty());
    std::vector<VkDescriptorPoolSize> sizes = pool_sizes(sets);
    auto info = make_info<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    info.maxSets = static_cast<std::uint32_t>(sets.size());
    info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    info.pPoolSizes = sizes.data();
    VkDescriptorPool pool = VK_NULL_HANDLE;
    if (!check(vkCreateDescriptorPool(device.get(), &info, nullptr, &pool), "vkCreateDescriptorPool",
               diags)) {
        return std::nullopt;
    }
    DescriptorSets made;
    made.pool_ = {device.get(), pool};
    made.sets_.resize(sets.size());
    auto allocation = make_info<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
    allocation.descriptorPool = pool;
    allocation.descriptorSetCount = static_cast<std::uint32_t>(sets.size());
    allocation.pSetLayouts = layouts.data();
    if (!check(vkAllocateDescriptorSets(device.get(), &allocation, made.sets_.data()),
               "vkAllocateDescriptorSets", diags)) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < sets.size(); ++i) {
        for (const Binding& binding : sets[i]) write(device.get(), made.sets_[i], binding);
    }
    return made;
}

}  // namespace sg::runtime::gpu

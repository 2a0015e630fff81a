#include "runtime/gpu/buffer.hpp"

#include <cstring>

#include "base/ice.hpp"
#include "runtime/gpu/check.hpp"

namespace sg::runtime::gpu {

std::optional<Buffer> Buffer::create(const Device& device, std::size_t size, VkBufferUsageFlags usage,
                                     Diags& diags) {
    SG_ASSERT(size > 0);
    auto info = make_info<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = size;
    info.usage = usage;
    VkBuffer handle = VK_NULL_HANDLE;
    if (!check(vkCreateBuffer(device.get(), &info, nullptr, &handle), "vkCreateBuffer", diags))
        return std::nullopt;
    Buffer made;
    made.buffer_ = {device.get(), handle};
    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(device.get(), handle, &needs);
    auto memory = device.allocate(
        needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT, diags);
    if (!memory) return std::nullopt;
    made.memory_ = std::move(*memory);
    VkDeviceMemory block = made.memory_.get();
    if (!check(vkBindBufferMemory(device.get(), handle, block, 0), "vkBindBufferMemory", diags))
        return std::nullopt;
    void* mapped = nullptr;
    if (!check(vkMapMemory(device.get(), block, 0, size, 0, &mapped), "vkMapMemory", diags))
        return std::nullopt;
    made.bytes_ = {static_cast<std::byte*>(mapped), size};
    return made;
}

std::optional<Buffer> Buffer::create(const Device& device, std::span<const std::byte> contents,
                                     VkBufferUsageFlags usage, Diags& diags) {
    auto made = create(device, contents.size(), usage, diags);
    if (made) std::memcpy(made->bytes_.data(), contents.data(), contents.size());
    return made;
}

}  // namespace sg::runtime::gpu

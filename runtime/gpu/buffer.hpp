// Buffers that the processor sees: host-visible, coherent, mapped while they live.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <optional>
#include <span>

#include "base/diag.hpp"
#include "runtime/gpu/device.hpp"
#include "runtime/gpu/handle.hpp"

namespace sg::runtime::gpu {

class Buffer {
public:
    // `size` in bytes, at least 1. Contents are undefined.
    static std::optional<Buffer> create(const Device& device, std::size_t size, VkBufferUsageFlags usage,
                                        Diags& diags);
    // As create, filled with `contents`.
    static std::optional<Buffer> create(const Device& device, std::span<const std::byte> contents,
                                        VkBufferUsageFlags usage, Diags& diags);

    [[nodiscard]] VkBuffer get() const { return buffer_.get(); }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    // The mapped memory. Commands read and write it as well: touch it only while none run.
    [[nodiscard]] std::span<std::byte> bytes() const { return bytes_; }

private:
    OwnedMemory memory_;  // freed after the buffer: members are destroyed in reverse order
    OwnedBuffer buffer_;
    std::span<std::byte> bytes_;
};

}  // namespace sg::runtime::gpu

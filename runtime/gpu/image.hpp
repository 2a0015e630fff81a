// Images in device memory: textures with their mip levels, and attachments.
#pragma once

#include <vulkan/vulkan.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/diag.hpp"
#include "runtime/gpu/device.hpp"
#include "runtime/gpu/handle.hpp"
#include "runtime/gpu/sampler_state.hpp"

namespace sg::runtime::gpu {

// One mip level, tightly packed rows, upper row first.
struct Level {
    VkExtent2D extent{};
    std::span<const std::byte> texels;
};

class Image {
public:
    // A two-dimensional texture, uploaded and ready to be sampled. levels[i] is mip level i; each has half
    // the size of the one before, rounded down, at least 1. Fails with vulkan_failed, also where the device
    // cannot filter `format` or hold the size.
    static std::optional<Image> create_texture(const Device& device, VkFormat format,
                                               const std::vector<Level>& levels, Diags& diags);
    // One level without contents.
    static std::optional<Image> create_attachment(const Device& device, VkFormat format, VkExtent2D extent,
                                                  VkImageUsageFlags usage, VkImageAspectFlags aspect,
                                                  Diags& diags);

    [[nodiscard]] VkImage get() const { return image_.get(); }
    [[nodiscard]] VkImageView view() const { return view_.get(); }

private:
    static std::optional<Image> create(const Device& device, const VkImageCreateInfo& info,
                                       VkImageAspectFlags aspect, Diags& diags);
    bool upload(const Device& device, const std::vector<Level>& levels, Diags& diags);

    OwnedMemory memory_;
    OwnedImage image_;
    OwnedImageView view_;
};

std::optional<OwnedSampler> make_sampler(const Device& device, const SamplerState& state, Diags& diags);

}  // namespace sg::runtime::gpu

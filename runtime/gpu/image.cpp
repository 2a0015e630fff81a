#include "runtime/gpu/image.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>

#include "base/ice.hpp"
#include "runtime/gpu/buffer.hpp"
#include "runtime/gpu/check.hpp"

namespace sg::runtime::gpu {
namespace {

VkImageCreateInfo image_info(VkFormat format, VkExtent2D extent, std::size_t levels,
                             VkImageUsageFlags usage) {
    auto info = make_info<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {extent.width, extent.height, 1};
    info.mipLevels = static_cast<std::uint32_t>(levels);
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = usage;
    return info;
}

// Refuses what the device cannot hold before a driver is asked for it.
bool check_format(const Device& device, const VkImageCreateInfo& info, VkFormatFeatureFlags features,
                  Diags& diags) {
    VkFormatProperties format{};
    vkGetPhysicalDeviceFormatProperties(device.physical(), info.format, &format);
    if ((format.optimalTilingFeatures & features) != features) {
        diags.error(Code::vulkan_failed, fmt::format("device '{}' cannot filter textures of format {}",
                                                     device.name(), static_cast<int>(info.format)));
        return false;
    }
    std::uint32_t limit = device.limits().maxImageDimension2D;
    if (info.extent.width <= limit && info.extent.height <= limit) return true;
    diags.error(Code::vulkan_failed,
                fmt::format("an image of {}x{} is beyond the limit of device '{}', {}x{}", info.extent.width,
                            info.extent.height, device.name(), limit, limit));
    return false;
}

void barrier(VkCommandBuffer commands, const VkImageMemoryBarrier& what, VkPipelineStageFlags from,
             VkPipelineStageFlags to) {
    vkCmdPipelineBarrier(commands, from, to, 0, 0, nullptr, 0, nullptr, 1, &what);
}

// Staging memory with all levels behind each other, each at a multiple of 16 bytes (the size of the largest
// texel).
struct Staging {
    std::size_t size = 0;
    std::vector<VkBufferImageCopy> copies;

    explicit Staging(const std::vector<Level>& levels) {
        for (std::size_t i = 0; i < levels.size(); ++i) {
            VkBufferImageCopy copy{};
            copy.bufferOffset = size;
            copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, static_cast<std::uint32_t>(i), 0, 1};
            copy.imageExtent = {levels[i].extent.width, levels[i].extent.height, 1};
            copies.push_back(copy);
            size += (levels[i].texels.size() + 15) / 16 * 16;
        }
    }
};

VkSamplerAddressMode address_mode(Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat:
            return VK_SAMPLER_ADDRESS_MODE_REPEAT;
        case Wrap::mirror:
            return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
        case Wrap::clamp:
            return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    }
    SG_UNREACHABLE("a wrap mode without a case");
}

}  // namespace

std::optional<Image> Image::create(const Device& device, const VkImageCreateInfo& info,
                                   VkImageAspectFlags aspect, Diags& diags) {
    VkImage image = VK_NULL_HANDLE;
    if (!check(vkCreateImage(device.get(), &info, nullptr, &image), "vkCreateImage", diags))
        return std::nullopt;
    Image made;
    made.image_ = {device.get(), image};
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(device.get(), image, &needs);
    auto memory = device.allocate(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, diags);
    if (!memory) return std::nullopt;
    made.memory_ = std::move(*memory);
    VkResult bound = vkBindImageMemory(device.get(), image, made.memory_.get(), 0);
    if (!check(bound, "vkBindImageMemory", diags)) return std::nullopt;
    auto view_info = make_info<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
    view_info.image = image;
    view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view_info.format = info.format;
    view_info.subresourceRange = {aspect, 0, info.mipLevels, 0, 1};
    VkImageView view = VK_NULL_HANDLE;
    VkResult viewed = vkCreateImageView(device.get(), &view_info, nullptr, &view);
    if (!check(viewed, "vkCreateImageView", diags)) return std::nullopt;
    made.view_ = {device.get(), view};
    return made;
}

bool Image::upload(const Device& device, const std::vector<Level>& levels, Diags& diags) {
    Staging staging(levels);
    auto buffer = Buffer::create(device, staging.size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, diags);
    if (!buffer) return false;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        std::memcpy(buffer->bytes().data() + staging.copies[i].bufferOffset, levels[i].texels.data(),
                    levels[i].texels.size());
    }
    auto what = make_info<VkImageMemoryBarrier>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER);
    what.srcQueueFamilyIndex = what.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    what.image = get();
    what.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, static_cast<std::uint32_t>(levels.size()), 0, 1};
    auto record = [&](VkCommandBuffer commands) {
        what.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
        what.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
        barrier(commands, what, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT);
        vkCmdCopyBufferToImage(commands, buffer->get(), get(), what.newLayout,
                               static_cast<std::uint32_t>(staging.copies.size()), staging.copies.data());
        what.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
        what.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
        what.oldLayout = what.newLayout;
        what.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
        constexpr VkPipelineStageFlags kReaders = VK_PIPELINE_STAGE_VERTEX_SHADER_BIT |
                                                  VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT |
                                                  VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
        barrier(commands, what, VK_PIPELINE_STAGE_TRANSFER_BIT, kReaders);
    };
    return device.submit(record, diags);
}

std::optional<Image> Image::create_texture(const Device& device, VkFormat format,
                                           const std::vector<Level>& levels, Diags& diags) {
    SG_ASSERT(!levels.empty());
    VkImageCreateInfo info = image_info(format, levels[0].extent, levels.size(),
                                        VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    constexpr VkFormatFeatureFlags kFeatures =
        VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
    if (!check_format(device, info, kFeatures, diags)) return std::nullopt;
    auto made = create(device, info, VK_IMAGE_ASPECT_COLOR_BIT, diags);
    if (!made || !made->upload(device, levels, diags)) return std::nullopt;
    return made;
}

std::optional<Image> Image::create_attachment(const Device& device, VkFormat format, VkExtent2D extent,
                                              VkImageUsageFlags usage, VkImageAspectFlags aspect,
                                              Diags& diags) {
    VkImageCreateInfo info = image_info(format, extent, 1, usage);
    if (!check_format(device, info, 0, diags)) return std::nullopt;
    return create(device, info, aspect, diags);
}

std::optional<OwnedSampler> make_sampler(const Device& device, const SamplerState& state, Diags& diags) {
    auto info = make_info<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
    info.magFilter = info.minFilter = state.linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    info.mipmapMode = state.mip_filter == MipFilter::linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR
                                                            : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.addressModeU = address_mode(state.wrap_s);
    info.addressModeV = address_mode(state.wrap_t);
    info.addressModeW = VK_SAMPLER_ADDRESS_MODE_REPEAT;
    info.maxLod = state.mip_filter == MipFilter::none
                      ? 0.25f
                      : VK_LOD_CLAMP_NONE;  // 0.25: Vulkan's table for GL_LINEAR
    info.anisotropyEnable = state.anisotropy > 1 && device.has_anisotropy() ? VK_TRUE : VK_FALSE;
    info.maxAnisotropy =
        std::clamp(static_cast<float>(state.anisotropy), 1.0f, device.limits().maxSamplerAnisotropy);
    VkSampler sampler = VK_NULL_HANDLE;
    if (!check(vkCreateSampler(device.get(), &info, nullptr, &sampler), "vkCreateSampler", diags))
        return std::nullopt;
    return OwnedSampler(device.get(), sampler);
}

}  // namespace sg::runtime::gpu

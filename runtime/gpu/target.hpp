// What is drawn into: any number of 32-bit float RGBA and 32-bit depth, cleared, drawn once and read back.
#pragma once

#include <vulkan/vulkan.h>

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/diag.hpp"
#include "runtime/gpu/buffer.hpp"
#include "runtime/gpu/device.hpp"
#include "runtime/gpu/handle.hpp"
#include "runtime/gpu/image.hpp"

namespace sg::runtime::gpu {

class Target {
public:
    static std::optional<Target> create(const Device& device, VkExtent2D extent, std::uint32_t colors,
                                        Diags& diags);

    [[nodiscard]] VkExtent2D extent() const { return extent_; }
    [[nodiscard]] std::uint32_t colors() const { return static_cast<std::uint32_t>(colors_.size()); }
    [[nodiscard]] VkRenderPass pass() const { return pass_.get(); }
    // Clears colour to zero and depth to one, records the draws, and waits until the result can be read.
    bool draw(const Device& device, const std::function<void(VkCommandBuffer)>& record, Diags& diags);
    // Of the last draw, upper row first; valid until the next one.
    [[nodiscard]] std::span<const float> rgba(std::uint32_t color) const;  // 4 per pixel
    [[nodiscard]] std::span<const float> depth() const;  // 1 per pixel; exactly 1 where nothing was drawn

private:
    Target(VkExtent2D extent, std::vector<Image> colors, Image depth, std::vector<Buffer> color_copies,
           Buffer depth_copy)
        : extent_(extent),
          colors_(std::move(colors)),
          depth_(std::move(depth)),
          color_copies_(std::move(color_copies)),
          depth_copy_(std::move(depth_copy)) {}
    bool make_pass(const Device& device, Diags& diags);
    bool make_framebuffer(const Device& device, Diags& diags);
    void copy_back(VkCommandBuffer commands) const;

    VkExtent2D extent_{};
    std::vector<Image> colors_;
    Image depth_;
    std::vector<Buffer> color_copies_;
    Buffer depth_copy_;
    OwnedRenderPass pass_;
    OwnedFramebuffer framebuffer_;
};

}  // namespace sg::runtime::gpu

#include "runtime/gpu/target.hpp"

#include <array>

#include "runtime/gpu/check.hpp"

namespace sg::runtime::gpu {
namespace {

constexpr VkFormat kColorFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;

// Cleared at the start, ready to be copied at the end.
VkAttachmentDescription attachment(VkFormat format) {
    VkAttachmentDescription out{};
    out.format = format;
    out.samples = VK_SAMPLE_COUNT_1_BIT;
    out.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    out.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    out.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    out.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    out.finalLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    return out;
}

// The clear waits for the layout change; the copy waits for the draws.
std::array<VkSubpassDependency, 2> dependencies() {
    constexpr VkPipelineStageFlags kStages = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT |
                                             VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT |
                                             VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT;
    constexpr VkAccessFlags kWrites =
        VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
    constexpr VkAccessFlags kReads =
        VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
    VkSubpassDependency begin{VK_SUBPASS_EXTERNAL, 0, kStages, kStages, kWrites, kWrites | kReads, 0};
    VkSubpassDependency end{0,       VK_SUBPASS_EXTERNAL,         kStages, VK_PIPELINE_STAGE_TRANSFER_BIT,
                            kWrites, VK_ACCESS_TRANSFER_READ_BIT, 0};
    return {begin, end};
}

void copy_image(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, VkExtent2D extent,
                VkBuffer to) {
    VkBufferImageCopy copy{};
    copy.imageSubresource = {aspect, 0, 0, 1};
    copy.imageExtent = {extent.width, extent.height, 1};
    vkCmdCopyImageToBuffer(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to, 1, &copy);
}

std::span<const float> floats(const Buffer& buffer) {
    return {reinterpret_cast<const float*>(buffer.bytes().data()), buffer.size() / sizeof(float)};
}

}  // namespace

bool Target::make_pass(const Device& device, Diags& diags) {
    std::vector<VkAttachmentDescription> attachments(colors(), attachment(kColorFormat));
    attachments.push_back(attachment(kDepthFormat));
    std::vector<VkAttachmentReference> references;
    for (std::uint32_t i = 0; i < colors(); ++i)
        references.push_back({i, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL});
    VkAttachmentReference depth{colors(), VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = colors();
    subpass.pColorAttachments = references.data();
    subpass.pDepthStencilAttachment = &depth;
    std::array waits = dependencies();
    auto info = make_info<VkRenderPassCreateInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO);
    info.attachmentCount = static_cast<std::uint32_t>(attachments.size());
    info.pAttachments = attachments.data();
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    info.dependencyCount = waits.size();
    info.pDependencies = waits.data();
    VkRenderPass pass = VK_NULL_HANDLE;
    if (!check(vkCreateRenderPass(device.get(), &info, nullptr, &pass), "vkCreateRenderPass", diags))
        return false;
    pass_ = {device.get(), pass};
    return true;
}

bool Target::make_framebuffer(const Device& device, Diags& diags) {
    std::vector<VkImageView> views;
    for (const Image& color : colors_) views.push_back(color.view());
    views.push_back(depth_.view());
    auto info = make_info<VkFramebufferCreateInfo>(VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO);
    info.renderPass = pass_.get();
    info.attachmentCount = static_cast<std::uint32_t>(views.size());
    info.pAttachments = views.data();
    info.width = extent_.width;
    info.height = extent_.height;
    info.layers = 1;
    VkFramebuffer made = VK_NULL_HANDLE;
    if (!check(vkCreateFramebuffer(device.get(), &info, nullptr, &made), "vkCreateFramebuffer", diags))
        return false;
    framebuffer_ = {device.get(), made};
    return true;
}

std::optional<Target> Target::create(const Device& device, VkExtent2D extent, std::uint32_t colors,
                                     Diags& diags) {
    constexpr VkImageUsageFlags kCopied = VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    const std::size_t pixels = std::size_t{extent.width} * extent.height;
    std::vector<Image> images;
    std::vector<Buffer> copies;
    for (std::uint32_t i = 0; i < colors; ++i) {
        auto color = Image::create_attachment(device, kColorFormat, extent,
                                              kCopied | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                                              VK_IMAGE_ASPECT_COLOR_BIT, diags);
        auto copy = Buffer::create(device, pixels * 4 * sizeof(float), kUsage, diags);
        if (!color || !copy) return std::nullopt;
        images.push_back(std::move(*color));
        copies.push_back(std::move(*copy));
    }
    auto depth = Image::create_attachment(device, kDepthFormat, extent,
                                          kCopied | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                                          VK_IMAGE_ASPECT_DEPTH_BIT, diags);
    if (!depth) return std::nullopt;
    auto depth_copy = Buffer::create(device, pixels * sizeof(float), kUsage, diags);
    if (!depth_copy) return std::nullopt;
    Target made(extent, std::move(images), std::move(*depth), std::move(copies), std::move(*depth_copy));
    if (!made.make_pass(device, diags) || !made.make_framebuffer(device, diags)) return std::nullopt;
    return made;
}

void Target::copy_back(VkCommandBuffer commands) const {
    for (std::size_t i = 0; i < colors_.size(); ++i)
        copy_image(commands, colors_[i].get(), VK_IMAGE_ASPECT_COLOR_BIT, extent_, color_copies_[i].get());
    copy_image(commands, depth_.get(), VK_IMAGE_ASPECT_DEPTH_BIT, extent_, depth_copy_.get());
    auto barrier = make_info<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier,
                         0, nullptr, 0, nullptr);
}

bool Target::draw(const Device& device, const std::function<void(VkCommandBuffer)>& record, Diags& diags) {
    std::vector<VkClearValue> clear(colors() + 1);
    clear.back().depthStencil.depth = 1;
    auto begin = make_info<VkRenderPassBeginInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO);
    begin.renderPass = pass_.get();
    begin.framebuffer = framebuffer_.get();
    begin.renderArea.extent = extent_;
    begin.clearValueCount = static_cast<std::uint32_t>(clear.size());
    begin.pClearValues = clear.data();
    auto whole = [&](VkCommandBuffer commands) {
        vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
        record(commands);
        vkCmdEndRenderPass(commands);
        copy_back(commands);
    };
    return device.submit(whole, diags);
}

std::span<const float> Target::rgba(std::uint32_t color) const {
    return floats(color_copies_[color]);
}
std::span<const float> Target::depth() const {
    return floats(depth_copy_);
}

}  // namespace sg::runtime::gpu

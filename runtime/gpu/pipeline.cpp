#include "runtime/gpu/pipeline.hpp"

#include <array>

#include "base/ice.hpp"
#include "runtime/gpu/check.hpp"

namespace sg::runtime::gpu {
namespace {

std::optional<OwnedShaderModule> make_module(const Device& device, std::span<const std::uint32_t> words,
                                             Diags& diags) {
    auto info = make_info<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    VkShaderModule module = VK_NULL_HANDLE;
    if (!check(vkCreateShaderModule(device.get(), &info, nullptr, &module), "vkCreateShaderModule", diags)) {
        return std::nullopt;
    }
    return OwnedShaderModule(device.get(), module);
}

VkPipelineShaderStageCreateInfo stage_info(VkShaderStageFlagBits stage, VkShaderModule module) {
    auto info =
        make_info<VkPipelineShaderStageCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO);
    info.stage = stage;
    info.module = module;
    info.pName = "main";
    return info;
}

VkFormat float_format(std::uint32_t components) {
    switch (components) {
        case 2:
            return VK_FORMAT_R32G32_SFLOAT;
        case 3:
            return VK_FORMAT_R32G32B32_SFLOAT;
        case 4:
            return VK_FORMAT_R32G32B32A32_SFLOAT;
        default:
            SG_UNREACHABLE("a vertex input of other than 2 to 4 floats");
    }
}

// The two arrays that describe the vertex buffers, and the structure that points at them.
struct VertexLayout {
    std::vector<VkVertexInputBindingDescription> bindings;
    std::vector<VkVertexInputAttributeDescription> attributes;
    VkPipelineVertexInputStateCreateInfo info = make_info<VkPipelineVertexInputStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);

    explicit VertexLayout(std::span<const VertexInput> inputs) {
        for (const VertexInput& input : inputs) {
            auto stride = static_cast<std::uint32_t>(input.components * sizeof(float));
            bindings.push_back({input.location, stride, VK_VERTEX_INPUT_RATE_VERTEX});
            attributes.push_back({input.location, input.location, float_format(input.components), 0});
        }
        info.vertexBindingDescriptionCount = static_cast<std::uint32_t>(bindings.size());
        info.pVertexBindingDescriptions = bindings.data();
        info.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size());
        info.pVertexAttributeDescriptions = attributes.data();
    }
    VertexLayout(const VertexLayout&) = delete;
    VertexLayout& operator=(const VertexLayout&) = delete;
};

// The states that are the same for every material but the faces that are drawn; its members point at each
// other.
struct FixedStates {
    VkPipelineInputAssemblyStateCreateInfo assembly = make_info<VkPipelineInputAssemblyStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
    VkViewport area{};
    VkRect2D scissor{};
    VkPipelineViewportStateCreateInfo viewport =
        make_info<VkPipelineViewportStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
    VkPipelineRasterizationStateCreateInfo raster = make_info<VkPipelineRasterizationStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
    VkPipelineMultisampleStateCreateInfo samples = make_info<VkPipelineMultisampleStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
    VkPipelineDepthStencilStateCreateInfo depth = make_info<VkPipelineDepthStencilStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO);
    std::vector<VkPipelineColorBlendAttachmentState> attachments;
    VkPipelineColorBlendStateCreateInfo blend = make_info<VkPipelineColorBlendStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);

    explicit FixedStates(const DrawState& state) {
        assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
        area = {0, 0, static_cast<float>(state.extent.width), static_cast<float>(state.extent.height), 0, 1};
        if (state.negative_viewport) {
            area.y = area.height;
            area.height = -area.height;
        }
        scissor.extent = state.extent;
        viewport.viewportCount = viewport.scissorCount = 1;
        viewport.pViewports = &area;
        viewport.pScissors = &scissor;
        raster.cullMode = state.cull_back ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_NONE;
        const bool clockwise = state.mirrored != state.negative_viewport;
        raster.frontFace = clockwise ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE;
        raster.lineWidth = 1;
        samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
        depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
        depth.depthCompareOp = VK_COMPARE_OP_LESS;
        VkPipelineColorBlendAttachmentState attachment{};
        attachment.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                                    VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
        attachments.assign(state.colors, attachment);
        blend.attachmentCount = state.colors;
        blend.pAttachments = attachments.data();
    }
    FixedStates(const FixedStates&) = delete;
    FixedStates& operator=(const FixedStates&) = delete;
};

}  // namespace

std::optional<OwnedPipelineLayout> make_pipeline_layout(const Device& device,
                                                        std::span<const VkDescriptorSetLayout> sets,
                                                        Diags& diags) {
    auto info = make_info<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    info.setLayoutCount = static_cast<std::uint32_t>(sets.size());
    info.pSetLayouts = sets.data();
    VkPipelineLayout layout = VK_NULL_HANDLE;
    if (!check(vkCreatePipelineLayout(device.get(), &info, nullptr, &layout), "vkCreatePipelineLayout",
               diags)) {
        return std::nullopt;
    }
    return OwnedPipelineLayout(device.get(), layout);
}

std::optional<OwnedPipeline> make_compute_pipeline(const Device& device, VkPipelineLayout layout,
                                                   std::span<const std::uint32_t> words, Diags& diags) {
    auto module = make_module(device, words, diags);
    if (!module) return std::nullopt;
    auto info = make_info<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
    info.stage = stage_info(VK_SHADER_STAGE_COMPUTE_BIT, module->get());
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    VkResult result = vkCreateComputePipelines(device.get(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
    if (!check(result, "vkCreateComputePipelines", diags)) return std::nullopt;
    return OwnedPipeline(device.get(), pipeline);
}

std::optional<OwnedPipeline> make_draw_pipeline(const Device& device, const DrawState& state, Diags& diags) {
    auto vertex = make_module(device, state.vertex_words, diags);
    auto fragment = make_module(device, state.fragment_words, diags);
    if (!vertex || !fragment) return std::nullopt;
    std::array stages = {stage_info(VK_SHADER_STAGE_VERTEX_BIT, vertex->get()),
                         stage_info(VK_SHADER_STAGE_FRAGMENT_BIT, fragment->get())};
    const VertexLayout vertices(state.inputs);
    const FixedStates fixed(state);
    auto info = make_info<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
    info.stageCount = stages.size();
    info.pStages = stages.data();
    info.pVertexInputState = &vertices.info;
    info.pInputAssemblyState = &fixed.assembly;
    info.pViewportState = &fixed.viewport;
    info.pRasterizationState = &fixed.raster;
    info.pMultisampleState = &fixed.samples;
    info.pDepthStencilState = &fixed.depth;
    info.pColorBlendState = &fixed.blend;
    info.layout = state.layout;
    info.renderPass = state.pass;
    VkPipeline pipeline = VK_NULL_HANDLE;
    VkResult result = vkCreateGraphicsPipelines(device.get(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
    if (!check(result, "vkCreateGraphicsPipelines", diags)) return std::nullopt;
    return OwnedPipeline(device.get(), pipeline);
}

}  // namespace sg::runtime::gpu

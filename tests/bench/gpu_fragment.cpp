#include "gpu_fragment.hpp"

#include <fmt/format.h>

#include <map>
#include <spirv_cross/spirv_cross.hpp>
#include <vector>

#include "gpu_device.hpp"
#include "target/shader_library.hpp"
#include "target/spirv.hpp"

namespace sg::bench {
namespace {

// What the shader takes in and gives out, read from its words.
struct Interface {
    std::map<std::uint32_t, std::uint32_t> inputs;                                // location, components
    std::map<std::uint32_t, std::vector<VkDescriptorSetLayoutBinding>> bindings;  // by set
    std::uint32_t outputs = 0;
};

Interface interface_of(std::span<const std::uint32_t> words) {
    const spirv_cross::Compiler shader(words.data(), words.size());
    const spirv_cross::ShaderResources found = shader.get_shader_resources();
    Interface out;
    auto number = [&](const spirv_cross::Resource& r, spv::Decoration what) {
        return shader.get_decoration(r.id, what);
    };
    for (const auto& r : found.stage_inputs) {
        out.inputs[number(r, spv::DecorationLocation)] = shader.get_type(r.base_type_id).vecsize;
    }
    auto add = [&](const auto& resources, VkDescriptorType type) {
        for (const auto& r : resources) {
            out.bindings[number(r, spv::DecorationDescriptorSet)].push_back(
                {number(r, spv::DecorationBinding), type, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr});
        }
    };
    add(found.uniform_buffers, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
    add(found.sampled_images, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
    add(found.separate_images, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE);
    add(found.separate_samplers, VK_DESCRIPTOR_TYPE_SAMPLER);
    out.outputs = static_cast<std::uint32_t>(found.stage_outputs.size());
    return out;
}

target::Words vertex_words(const Interface& interface) {
    std::string declarations, copies;
    for (const auto& [location, components] : interface.inputs) {
        const std::string type = components == 1 ? "float" : fmt::format("vec{}", components);
        declarations += fmt::format(
            "layout(location = {0}) in {1} a{0};\nlayout(location = {0}) out {1} v{0};\n", location, type);
        copies += fmt::format("    v{0} = a{0};\n", location);
    }
    const std::string text = fmt::format(
        "#version 450\n{}layout(location = 31) in vec4 place;\nvoid main() {{\n{}    gl_Position = "
        "place;\n}}\n",
        declarations, copies);
    std::string fault;
    auto words = target::compile_glsl(text, "vertex", target::Stage::vertex, {}, {}, fault);
    if (!words) fmt::print(stderr, "{}\n", fault);
    return words.value_or(target::Words{});
}

VkShaderModule make_module(VkDevice device, std::span<const std::uint32_t> words) {
    VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    VkShaderModule module = VK_NULL_HANDLE;
    vkCreateShaderModule(device, &info, nullptr, &module);
    return module;
}

VkPipelineLayout make_layout(VkDevice device, Interface& interface) {
    std::vector<VkDescriptorSetLayout> sets;
    const std::uint32_t count = interface.bindings.empty() ? 0 : interface.bindings.rbegin()->first + 1;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto& bindings = interface.bindings[i];
        VkDescriptorSetLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
        info.bindingCount = static_cast<std::uint32_t>(bindings.size());
        info.pBindings = bindings.data();
        vkCreateDescriptorSetLayout(device, &info, nullptr, &sets.emplace_back());
    }
    VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.setLayoutCount = count;
    info.pSetLayouts = sets.data();
    VkPipelineLayout layout = VK_NULL_HANDLE;
    vkCreatePipelineLayout(device, &info, nullptr, &layout);
    return layout;
}

VkRenderPass make_pass(VkDevice device, std::uint32_t outputs) {
    VkAttachmentDescription attachment{.format = VK_FORMAT_R16G16B16A16_SFLOAT,
                                       .samples = VK_SAMPLE_COUNT_1_BIT};
    attachment.finalLayout = VK_IMAGE_LAYOUT_GENERAL;
    const std::vector<VkAttachmentDescription> attachments(outputs, attachment);
    std::vector<VkAttachmentReference> references;
    for (std::uint32_t i = 0; i < outputs; ++i)
        references.push_back({i, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL});
    VkSubpassDescription subpass{.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS};
    subpass.colorAttachmentCount = outputs;
    subpass.pColorAttachments = references.data();
    VkRenderPassCreateInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
    info.attachmentCount = outputs;
    info.pAttachments = attachments.data();
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    VkRenderPass pass = VK_NULL_HANDLE;
    vkCreateRenderPass(device, &info, nullptr, &pass);
    return pass;
}

VkPipelineShaderStageCreateInfo stage_of(VkDevice device, VkShaderStageFlagBits stage,
                                         std::span<const std::uint32_t> words) {
    VkPipelineShaderStageCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    info.stage = stage;
    info.module = make_module(device, words);
    info.pName = "main";
    return info;
}

VkPipeline make_pipeline(VkDevice device, std::span<const std::uint32_t> fragment) {
    Interface interface = interface_of(fragment);
    const target::Words vertex = vertex_words(interface);
    const VkPipelineShaderStageCreateInfo stages[] = {
        stage_of(device, VK_SHADER_STAGE_VERTEX_BIT, vertex),
        stage_of(device, VK_SHADER_STAGE_FRAGMENT_BIT, fragment)};
    std::vector<VkVertexInputAttributeDescription> attributes;
    for (const auto& [location, components] : interface.inputs)
        attributes.push_back({location, 0, VK_FORMAT_R32G32B32A32_SFLOAT, 16 * location});
    attributes.push_back({31, 0, VK_FORMAT_R32G32B32A32_SFLOAT, 16 * 31});
    const VkVertexInputBindingDescription binding{0, 512, VK_VERTEX_INPUT_RATE_VERTEX};
    VkPipelineVertexInputStateCreateInfo input{.sType =
                                                   VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    input.vertexBindingDescriptionCount = 1;
    input.pVertexBindingDescriptions = &binding;
    input.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size());
    input.pVertexAttributeDescriptions = attributes.data();
    VkPipelineInputAssemblyStateCreateInfo assembly{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    const VkViewport viewport{0, 0, 512, 512, 0, 1};
    const VkRect2D scissor{{0, 0}, {512, 512}};
    const VkPipelineViewportStateCreateInfo view{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
        .viewportCount = 1,
        .pViewports = &viewport,
        .scissorCount = 1,
        .pScissors = &scissor};
    VkPipelineRasterizationStateCreateInfo raster{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    raster.lineWidth = 1;
    const VkPipelineMultisampleStateCreateInfo samples{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
    const std::vector<VkPipelineColorBlendAttachmentState> targets(interface.outputs,
                                                                   {.colorWriteMask = 0xF});
    VkPipelineColorBlendStateCreateInfo blend{.sType =
                                                  VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    blend.attachmentCount = interface.outputs;
    blend.pAttachments = targets.data();
    VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
    info.flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
    info.stageCount = 2;
    info.pStages = stages;
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &view;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pColorBlendState = &blend;
    info.layout = make_layout(device, interface);
    info.renderPass = make_pass(device, interface.outputs);
    VkPipeline pipeline = VK_NULL_HANDLE;
    vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
    return pipeline;
}

}  // namespace

std::optional<GpuStatistics> fragment_statistics(std::span<const std::uint32_t> words) {
    const VkDevice device = gpu_device();
    if (device == VK_NULL_HANDLE) return std::nullopt;
    const VkPipeline pipeline = make_pipeline(device, words);
    if (pipeline == VK_NULL_HANDLE) return std::nullopt;
    return pipeline_statistics(device, pipeline, VK_SHADER_STAGE_FRAGMENT_BIT);
}

}  // namespace sg::bench

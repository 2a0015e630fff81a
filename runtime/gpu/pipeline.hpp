// Pipelines: one compute shader, or a vertex and a fragment shader that draw triangles.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/diag.hpp"
#include "runtime/gpu/device.hpp"
#include "runtime/gpu/handle.hpp"

namespace sg::runtime::gpu {

std::optional<OwnedPipelineLayout> make_pipeline_layout(const Device& device,
                                                        std::span<const VkDescriptorSetLayout> sets,
                                                        Diags& diags);

// The entry function is "main".
std::optional<OwnedPipeline> make_compute_pipeline(const Device& device, VkPipelineLayout layout,
                                                   std::span<const std::uint32_t> words, Diags& diags);

// Vertex attributes are tightly packed, each in its own buffer, whose binding number is the attribute's
// location.
struct VertexInput {
    std::uint32_t location = 0;
    std::uint32_t components = 3;  // floats, 2 to 4
};

struct DrawState {
    std::span<const std::uint32_t> vertex_words;    // entry function "main"
    std::span<const std::uint32_t> fragment_words;  // entry function "main"
    std::span<const VertexInput> inputs;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkRenderPass pass = VK_NULL_HANDLE;
    VkExtent2D extent{};
    bool cull_back = true;
    bool mirrored = false;           // clockwise triangles face front
    bool negative_viewport = false;  // its height is negative: y grows upward on the screen
    std::uint32_t colors = 1;        // attachments
};
// Triangles, depth test "less", no blending.
std::optional<OwnedPipeline> make_draw_pipeline(const Device& device, const DrawState& state, Diags& diags);

}  // namespace sg::runtime::gpu

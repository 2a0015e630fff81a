#include "runtime/compute.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "base/ice.hpp"
#include "runtime/gpu/buffer.hpp"
#include "runtime/gpu/descriptors.hpp"
#include "runtime/gpu/device.hpp"
#include "runtime/gpu/image.hpp"
#include "runtime/gpu/pipeline.hpp"

namespace sg::runtime {
namespace {

constexpr std::size_t kLocalSize = 64;
constexpr std::array kKinds = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                               VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER};

// The buffers of one part, in the order of their bindings.
struct Buffers {
    gpu::Buffer inputs, outputs, control;
};

std::optional<Buffers> make_buffers(const gpu::Device& device, std::span<const float> inputs,
                                    std::size_t output_floats, std::size_t count, Diags& diags) {
    constexpr VkBufferUsageFlags kStorage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    std::array<std::uint32_t, 4> control = {static_cast<std::uint32_t>(count)};
    auto in = gpu::Buffer::create(device, std::as_bytes(inputs), kStorage, diags);
    auto out = gpu::Buffer::create(device, output_floats * sizeof(float), kStorage, diags);
    auto uniform = gpu::Buffer::create(device, std::as_bytes(std::span(control)),
                                       VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, diags);
    if (!in || !out || !uniform) return std::nullopt;
    return Buffers{std::move(*in), std::move(*out), std::move(*uniform)};
}

struct BoundTexture {
    const gpu::Image* image;
    gpu::OwnedSampler sampler;
};

std::optional<std::vector<BoundTexture>> bind_textures(const gpu::Device& device,
                                                       std::span<const ComputeTexture> textures,
                                                       Diags& diags) {
    std::vector<BoundTexture> out;
    for (const ComputeTexture& texture : textures) {
        auto sampler = gpu::make_sampler(device, texture.sampling, diags);
        if (!sampler) return std::nullopt;
        out.push_back({texture.image, std::move(*sampler)});
    }
    return out;
}

std::vector<VkDescriptorSetLayoutBinding> layout_bindings(std::size_t textures) {
    std::vector<VkDescriptorType> kinds(kKinds.begin(), kKinds.end());
    for (std::size_t i = 0; i < textures; ++i) {
        kinds.insert(kinds.end(), {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, VK_DESCRIPTOR_TYPE_SAMPLER});
    }
    std::vector<VkDescriptorSetLayoutBinding> out;
    for (VkDescriptorType kind : kinds) {
        out.push_back(
            {static_cast<std::uint32_t>(out.size()), kind, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
    }
    return out;
}

// Makes what the shader wrote visible to the processor.
void flush_to_host(VkCommandBuffer commands) {
    auto barrier = gpu::make_info<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
    barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                         &barrier, 0, nullptr, 0, nullptr);
}

}  // namespace

struct Compute::State {
    gpu::Device& device;
    gpu::OwnedSetLayout set_layout;
    gpu::OwnedPipelineLayout layout;
    gpu::OwnedPipeline pipeline;
    std::vector<BoundTexture> textures;

    // Everything that one part binds.
    [[nodiscard]] std::vector<gpu::Binding> bindings_of(const Buffers& buffers) const {
        std::vector<gpu::Binding> out = {{0, kKinds[0], buffers.inputs.get()},
                                         {1, kKinds[1], buffers.outputs.get()},
                                         {2, kKinds[2], buffers.control.get()}};
        for (const BoundTexture& texture : textures) {
            auto next = static_cast<std::uint32_t>(out.size());
            out.push_back(
                {.binding = next, .kind = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, .view = texture.image->view()});
            out.push_back(
                {.binding = next + 1, .kind = VK_DESCRIPTOR_TYPE_SAMPLER, .sampler = texture.sampler.get()});
        }
        return out;
    }

    // The greatest number of elements that one dispatch can hold.
    [[nodiscard]] std::size_t part_size(std::size_t floats_per_element) const {
        const VkPhysicalDeviceLimits& limits = device.limits();
        std::size_t by_groups = std::size_t{limits.maxComputeWorkGroupCount[0]} * kLocalSize;
        std::size_t by_bytes = limits.maxStorageBufferRange / (floats_per_element * sizeof(float));
        return std::min(by_groups, by_bytes);
    }

    bool run_part(std::span<const float> inputs, std::span<float> outputs, std::size_t count,
                  Diags& diags) const {
        auto buffers = make_buffers(device, inputs, outputs.size(), count, diags);
        if (!buffers) return false;
        VkDescriptorSetLayout set = set_layout.get();
        auto sets = gpu::DescriptorSets::create(device, {&set, 1}, {bindings_of(*buffers)}, diags);
        if (!sets) return false;
        auto record = [&](VkCommandBuffer commands) {
            VkDescriptorSet bound = (*sets)[0];
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.get());
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout.get(), 0, 1, &bound, 0,
                                    nullptr);
            vkCmdDispatch(commands, static_cast<std::uint32_t>((count + kLocalSize - 1) / kLocalSize), 1, 1);
            flush_to_host(commands);
        };
        if (!device.submit(record, diags)) return false;
        std::memcpy(outputs.data(), buffers->outputs.bytes().data(), outputs.size_bytes());
        return true;
    }
};

Compute::Compute(std::unique_ptr<State> state) : state_(std::move(state)) {}
Compute::Compute(Compute&&) noexcept = default;
Compute::~Compute() = default;

std::optional<Compute> Compute::create(gpu::Device& device, std::span<const std::uint32_t> words,
                                       Diags& diags, std::span<const ComputeTexture> textures) {
    auto bound = bind_textures(device, textures, diags);
    if (!bound) return std::nullopt;
    auto set_layout = gpu::make_set_layout(device, layout_bindings(textures.size()), diags);
    if (!set_layout) return std::nullopt;
    VkDescriptorSetLayout set = set_layout->get();
    auto layout = gpu::make_pipeline_layout(device, {&set, 1}, diags);
    if (!layout) return std::nullopt;
    auto pipeline = gpu::make_compute_pipeline(device, layout->get(), words, diags);
    if (!pipeline) return std::nullopt;
    return Compute(std::unique_ptr<State>(new State{device, std::move(*set_layout), std::move(*layout),
                                                    std::move(*pipeline), std::move(*bound)}));
}

bool Compute::run(std::span<const float> inputs, std::size_t floats_per_input, std::span<float> outputs,
                  std::size_t floats_per_output, std::size_t count, Diags& diags) {
    SG_ASSERT(floats_per_input > 0 && floats_per_output > 0);
    SG_ASSERT(inputs.size() == count * floats_per_input && outputs.size() == count * floats_per_output);
    std::size_t part = state_->part_size(std::max(floats_per_input, floats_per_output));
    for (std::size_t begin = 0; begin < count; begin += part) {
        std::size_t size = std::min(part, count - begin);
        if (!state_->run_part(inputs.subspan(begin * floats_per_input, size * floats_per_input),
                              outputs.subspan(begin * floats_per_output, size * floats_per_output), size,
                              diags)) {
            return false;
        }
    }
    return true;
}

}  // namespace sg::runtime

#include "runtime/render.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

#include "base/ice.hpp"
#include "runtime/blocks.hpp"
#include "runtime/gpu/buffer.hpp"
#include "runtime/gpu/descriptors.hpp"
#include "runtime/gpu/device.hpp"
#include "runtime/gpu/image.hpp"
#include "runtime/gpu/pipeline.hpp"
#include "runtime/gpu/target.hpp"
#include "runtime/vertices.hpp"

namespace sg::runtime {
namespace {

constexpr std::size_t kSets = 3;  // frame, material, object

struct DeviceMesh {
    std::vector<gpu::Buffer> attributes;  // as the entry point's inputs
    std::optional<gpu::Buffer> indices;
    std::uint32_t index_count = 0;
};

std::optional<DeviceMesh> upload_mesh(const gpu::Device& device, const asset::Mesh& mesh,
                                      const EntryPoint& entry, Diags& diags) {
    DeviceMesh out;
    for (const VertexInput& input : entry.inputs) {
        auto bytes = attribute_bytes(mesh, input.name);
        auto buffer = gpu::Buffer::create(device, bytes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, diags);
        if (!buffer) return std::nullopt;
        out.attributes.push_back(std::move(*buffer));
    }
    out.index_count = static_cast<std::uint32_t>(mesh.indices.size());
    auto bytes = std::as_bytes(std::span(mesh.indices));
    out.indices = gpu::Buffer::create(device, bytes, VK_BUFFER_USAGE_INDEX_BUFFER_BIT, diags);
    if (!out.indices) return std::nullopt;
    return out;
}

VkFormat texture_format(asset::TexelFormat format, bool srgb) {
    switch (format) {
        case asset::TexelFormat::unorm8:
            return srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM;
        case asset::TexelFormat::unorm16:
            return VK_FORMAT_R16G16B16A16_UNORM;
        case asset::TexelFormat::float32:
            return VK_FORMAT_R32G32B32A32_SFLOAT;
    }
    SG_UNREACHABLE("a texel format without a case");
}

std::optional<gpu::Image> upload_texture(const gpu::Device& device, const std::vector<asset::Image>& chain,
                                         bool srgb, Diags& diags) {
    std::vector<gpu::Level> levels;
    for (const asset::Image& image : chain) {
        levels.push_back({{image.width, image.height}, std::as_bytes(std::span(image.bytes))});
    }
    return gpu::Image::create_texture(device, texture_format(chain[0].format, srgb), levels, diags);
}

VkDescriptorType descriptor_type(BindingSlot::Kind kind) {
    switch (kind) {
        case BindingSlot::Kind::uniform_buffer:
            return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        case BindingSlot::Kind::texture:
            return VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
        case BindingSlot::Kind::sampler:
            return VK_DESCRIPTOR_TYPE_SAMPLER;
    }
    SG_UNREACHABLE("a binding kind without a case");
}

}  // namespace

struct Renderer::State {
    gpu::Device& device;
    const Artefact& artefact;
    const Scene& scene;
    const RenderOptions& options;
    const EntryPoint& entry;
    Bounds bounds;

    std::vector<DeviceMesh> meshes;
    std::map<std::uint32_t, gpu::Image> images;           // by binding in set 1
    std::map<std::uint32_t, gpu::OwnedSampler> samplers;  // by binding in set 1
    std::optional<gpu::Buffer> frame, material, objects;
    std::size_t object_stride = 0;
    std::array<gpu::OwnedSetLayout, kSets> set_layouts;
    gpu::OwnedPipelineLayout layout;
    std::optional<gpu::Target> target;
    gpu::OwnedPipeline pipeline, mirrored_pipeline;
    std::optional<gpu::DescriptorSets> sets;  // frame, material, then one per instance

    bool make_meshes(Diags& diags);
    bool make_textures(const TextureSet& textures, Diags& diags);
    bool make_blocks(Diags& diags);
    bool make_layouts(Diags& diags);
    bool make_pipelines(Diags& diags);
    bool make_sets(Diags& diags);
    [[nodiscard]] bool uses(std::uint32_t binding) const;
    [[nodiscard]] std::vector<gpu::Binding> set_bindings(std::uint32_t set, std::size_t instance) const;
    void record(VkCommandBuffer commands) const;
    [[nodiscard]] Picture read_target(std::uint32_t color) const;
};

bool Renderer::State::make_meshes(Diags& diags) {
    const asset::Scene& content = scene.content;
    meshes.resize(content.meshes.size());
    bool complete = true;
    for (std::size_t i = 0; i < content.meshes.size(); ++i) {
        bool drawn = std::any_of(content.instances.begin(), content.instances.end(),
                                 [&](const asset::Instance& instance) { return instance.mesh == i; });
        if (!drawn || content.meshes[i].indices.empty()) continue;
        auto ready = prepare_mesh(content.meshes[i], entry, artefact.name, diags);
        auto uploaded = ready ? upload_mesh(device, *ready, entry, diags) : std::nullopt;
        if (uploaded) meshes[i] = std::move(*uploaded);
        complete = complete && uploaded;
    }
    return complete;
}

bool Renderer::State::uses(std::uint32_t binding) const {
    return std::any_of(entry.bindings.begin(), entry.bindings.end(),
                       [&](const BindingSlot& slot) { return slot.set == 1 && slot.binding == binding; });
}

bool Renderer::State::make_textures(const TextureSet& textures, Diags& diags) {
    SG_ASSERT(textures.chains.size() == artefact.textures.size());
    for (std::size_t i = 0; i < artefact.textures.size(); ++i) {
        const TextureSlot& slot = artefact.textures[i];
        if (!uses(slot.binding)) continue;
        auto image = upload_texture(device, textures.chains[i], slot.srgb, diags);
        if (!image) return false;
        images.emplace(slot.binding, std::move(*image));
    }
    for (const SamplerSlot& slot : artefact.samplers) {
        auto sampler = gpu::make_sampler(device, slot.state, diags);
        if (!sampler) return false;
        samplers.emplace(slot.binding, std::move(*sampler));
    }
    return true;
}

bool Renderer::State::make_blocks(Diags& diags) {
    constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
    frame = gpu::Buffer::create(device, sizeof(FrameBlock), kUsage, diags);
    if (!options.parameters.empty())
        material = gpu::Buffer::create(device, options.parameters, kUsage, diags);
    std::size_t alignment = std::max<std::size_t>(device.limits().minUniformBufferOffsetAlignment, 16);
    object_stride = (sizeof(ObjectBlock) + alignment - 1) / alignment * alignment;
    const auto& instances = scene.content.instances;
    objects = gpu::Buffer::create(device, object_stride * std::max<std::size_t>(instances.size(), 1), kUsage,
                                  diags);
    if (!frame || !objects || (!options.parameters.empty() && !material)) return false;
    for (std::size_t i = 0; i < instances.size(); ++i) {
        ObjectBlock block = object_block(scene.camera, instances[i].world_from_object);
        std::memcpy(objects->bytes().data() + i * object_stride, &block, sizeof(block));
    }
    return true;
}

bool Renderer::State::make_layouts(Diags& diags) {
    std::array<VkDescriptorSetLayout, kSets> handles{};
    for (std::uint32_t set = 0; set < kSets; ++set) {
        std::vector<VkDescriptorSetLayoutBinding> bindings;
        for (const BindingSlot& slot : entry.bindings) {
            if (slot.set != set) continue;
            VkShaderStageFlags stages = 0;
            if (slot.in_vertex) stages |= VK_SHADER_STAGE_VERTEX_BIT;
            if (slot.in_fragment) stages |= VK_SHADER_STAGE_FRAGMENT_BIT;
            bindings.push_back({slot.binding, descriptor_type(slot.kind), 1, stages, nullptr});
        }
        auto made = gpu::make_set_layout(device, bindings, diags);
        if (!made) return false;
        set_layouts[set] = std::move(*made);
        handles[set] = set_layouts[set].get();
    }
    auto made = gpu::make_pipeline_layout(device, handles, diags);
    if (made) layout = std::move(*made);
    return made.has_value();
}

bool Renderer::State::make_pipelines(Diags& diags) {
    VkExtent2D extent{options.width * options.supersample, options.height * options.supersample};
    target = gpu::Target::create(device, extent, static_cast<std::uint32_t>(entry.outputs.size()), diags);
    if (!target) return false;
    std::vector<gpu::VertexInput> inputs;
    for (const VertexInput& input : entry.inputs) inputs.push_back({input.location, input.components});
    gpu::DrawState state;
    state.vertex_words = entry.vertex.words;
    state.fragment_words = entry.fragment.words;
    state.inputs = inputs;
    state.layout = layout.get();
    state.pass = target->pass();
    state.extent = extent;
    state.cull_back = !artefact.two_sided;
    state.negative_viewport = options.negative_viewport;
    state.colors = target->colors();
    for (bool mirrored : {false, true}) {
        const auto& all = scene.content.instances;
        bool needed = std::any_of(all.begin(), all.end(), [&](const asset::Instance& instance) {
            return is_mirrored(instance.world_from_object) == mirrored;
        });
        if (!needed) continue;
        state.mirrored = mirrored;
        auto made = gpu::make_draw_pipeline(device, state, diags);
        if (!made) return false;
        (mirrored ? mirrored_pipeline : pipeline) = std::move(*made);
    }
    return true;
}

std::vector<gpu::Binding> Renderer::State::set_bindings(std::uint32_t set, std::size_t instance) const {
    std::vector<gpu::Binding> out;
    for (const BindingSlot& slot : entry.bindings) {
        if (slot.set != set) continue;
        gpu::Binding binding;
        binding.binding = slot.binding;
        binding.kind = descriptor_type(slot.kind);
        if (slot.kind == BindingSlot::Kind::texture) {
            binding.view = images.at(slot.binding).view();
        } else if (slot.kind == BindingSlot::Kind::sampler) {
            binding.sampler = samplers.at(slot.binding).get();
        } else if (set == 2) {
            binding.buffer = objects->get();
            binding.offset = instance * object_stride;
            binding.range = sizeof(ObjectBlock);
        } else {
            binding.buffer = set == 0 ? frame->get() : material->get();
        }
        out.push_back(binding);
    }
    return out;
}

bool Renderer::State::make_sets(Diags& diags) {
    std::vector<VkDescriptorSetLayout> layouts = {set_layouts[0].get(), set_layouts[1].get()};
    std::vector<std::vector<gpu::Binding>> contents = {set_bindings(0, 0), set_bindings(1, 0)};
    for (std::size_t i = 0; i < scene.content.instances.size(); ++i) {
        layouts.push_back(set_layouts[2].get());
        contents.push_back(set_bindings(2, i));
    }
    sets = gpu::DescriptorSets::create(device, layouts, contents, diags);
    return sets.has_value();
}

void Renderer::State::record(VkCommandBuffer commands) const {
    for (std::size_t i = 0; i < scene.content.instances.size(); ++i) {
        const asset::Instance& instance = scene.content.instances[i];
        const DeviceMesh& mesh = meshes[instance.mesh];
        if (!mesh.indices) continue;  // it has no triangles
        bool mirrored = is_mirrored(instance.world_from_object);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                          (mirrored ? mirrored_pipeline : pipeline).get());
        std::array bound = {(*sets)[0], (*sets)[1], (*sets)[2 + i]};
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout.get(), 0, bound.size(),
                                bound.data(), 0, nullptr);
        for (std::size_t a = 0; a < mesh.attributes.size(); ++a) {
            VkBuffer buffer = mesh.attributes[a].get();
            VkDeviceSize offset = 0;
            vkCmdBindVertexBuffers(commands, entry.inputs[a].location, 1, &buffer, &offset);
        }
        vkCmdBindIndexBuffer(commands, mesh.indices->get(), 0, VK_INDEX_TYPE_UINT32);
        vkCmdDrawIndexed(commands, mesh.index_count, 1, 0, 0, 0);
    }
}

// An entry without outputs shows its depth.
Picture Renderer::State::read_target(std::uint32_t color) const {
    VkExtent2D extent = target->extent();
    Picture out{asset::make_image(extent.width, extent.height, asset::TexelFormat::float32), {}};
    if (target->colors() > 0) {
        const std::span<const float> rgba = target->rgba(color);
        std::memcpy(out.values.bytes.data(), rgba.data(), rgba.size_bytes());
    }
    for (std::uint32_t i = 0; target->colors() == 0 && i < target->depth().size(); ++i) {
        const float depth = target->depth()[i];
        for (int c = 0; c < 4; ++c)
            out.values.set(i % extent.width, i / extent.width, c, c == 3 ? (depth < 1 ? 1.0 : 0.0) : depth);
    }
    for (float depth : target->depth()) out.coverage.push_back(depth < 1 ? 1.0f : 0.0f);
    return out;
}

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

std::optional<Renderer> Renderer::create(gpu::Device& device, const Artefact& artefact,
                                         const TextureSet& textures, const Scene& scene,
                                         const RenderOptions& options, std::string_view entry, Diags& diags) {
    SG_ASSERT(artefact.entry(entry) != nullptr && options.width > 0 && options.height > 0 &&
              options.supersample > 0);
    std::unique_ptr<State> state(
        new State{device, artefact, scene, options, *artefact.entry(entry), bounds_of(scene.content)});
    bool ok = state->make_meshes(diags) && state->make_textures(textures, diags) &&
              state->make_blocks(diags) && state->make_layouts(diags) && state->make_pipelines(diags) &&
              state->make_sets(diags);
    if (!ok) return std::nullopt;
    return Renderer(std::move(state));
}

std::optional<Picture> Renderer::draw(const DebugView& view, Diags& diags) {
    VkExtent2D extent = state_->target->extent();
    FrameBlock block = frame_block(state_->scene, state_->bounds, extent.width, extent.height,
                                   state_->options.time, view.number, state_->options.negative_viewport);
    std::memcpy(state_->frame->bytes().data(), &block, sizeof(block));
    auto record = [&](VkCommandBuffer commands) { state_->record(commands); };
    if (!state_->target->draw(state_->device, record, diags)) return std::nullopt;
    const std::uint32_t color = state_->entry.views.empty() ? view.number : 0;  // else the shader chooses
    return shrink(state_->read_target(color), state_->options.supersample, view.components == 4);
}

std::optional<Picture> render(gpu::Device& device, const Artefact& artefact, const TextureSet& textures,
                              const Scene& scene, const View& view, const RenderOptions& options,
                              Diags& diags) {
    auto renderer = Renderer::create(device, artefact, textures, scene, options, view.entry, diags);
    if (!renderer) return std::nullopt;
    return renderer->draw(view.view, diags);
}

}  // namespace sg::runtime

// Evaluates a compute shader over arrays of floats: the door through which tests ask a shader for numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "base/diag.hpp"
#include "runtime/gpu/sampler_state.hpp"

namespace sg::runtime {

namespace gpu {
class Device;
class Image;
}  // namespace gpu

// A texture that the shader may read, and how. The image must outlive the Compute.
struct ComputeTexture {
    const gpu::Image* image = nullptr;
    gpu::SamplerState sampling;
};

// The shader's side, set 0: binding 0 a storage buffer of inputs, binding 1 a storage buffer of outputs (both
// std430 arrays of float), binding 2 a uniform block that starts with `uint count`; local size 64 in x, one
// invocation per element, entry function "main":
//
//   layout(local_size_x = 64) in;
//   layout(set = 0, binding = 0, std430) readonly buffer Inputs { float inputs[]; };
//   layout(set = 0, binding = 1, std430) writeonly buffer Outputs { float outputs[]; };
//   layout(set = 0, binding = 2, std140) uniform Control { uint count; };
//   void main() { uint i = gl_GlobalInvocationID.x; if (i >= count) return; ... }
//
// Texture i, if any, is bound as a texture2D at 3 + 2 i with its sampler at 4 + 2 i.
// No thread-safety. The device must outlive it.
class Compute {
public:
    // Fails with vulkan_failed. The words must be valid SPIR-V for Vulkan 1.1; they are not checked here.
    static std::optional<Compute> create(gpu::Device& device, std::span<const std::uint32_t> words,
                                         Diags& diags, std::span<const ComputeTexture> textures = {});
    Compute(Compute&&) noexcept;
    ~Compute();

    // inputs holds count * floats_per_input, outputs count * floats_per_output; each element is independent.
    // Runs in parts where a device's limits ask for it (then gl_GlobalInvocationID counts within the part).
    bool run(std::span<const float> inputs, std::size_t floats_per_input, std::span<float> outputs,
             std::size_t floats_per_output, std::size_t count, Diags& diags);

private:
    struct State;
    explicit Compute(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace sg::runtime

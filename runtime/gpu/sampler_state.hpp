// How a texture is sampled, without a word of Vulkan.
#pragma once

namespace sg::runtime::gpu {

enum class Wrap { repeat, mirror, clamp };
enum class MipFilter { none, nearest, linear };

struct SamplerState {
    Wrap wrap_s = Wrap::repeat;
    Wrap wrap_t = Wrap::repeat;
    bool linear = true;  // within a level
    MipFilter mip_filter = MipFilter::linear;
    double anisotropy = 1;  // samples, 1 to 16; 1 turns it off; capped by the device's limit
};

}  // namespace sg::runtime::gpu

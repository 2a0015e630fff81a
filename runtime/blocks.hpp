// The uniform blocks of sets 0 and 2, byte for byte as compiler/artefacts.md lists them.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>

#include "runtime/scene.hpp"

namespace sg::runtime {

struct FrameBlock {
    glm::mat4 clip_from_relative;
    glm::mat4 relative_from_screen;
    glm::vec4 camera_position;
    glm::vec4 view_direction;
    glm::vec4 light_direction;
    glm::vec4 light_radiance;
    glm::vec4 ambient_radiance;
    glm::vec4 time_view;
};
static_assert(sizeof(FrameBlock) == 224 && offsetof(FrameBlock, camera_position) == 128 &&
              offsetof(FrameBlock, time_view) == 208);

struct ObjectBlock {
    glm::mat4 relative_from_object;
    glm::mat4 normal_from_object;
};
static_assert(sizeof(ObjectBlock) == 128);

// `time` in seconds; `view` is the number of a debug view. Width and height in pixels, of what is drawn.
FrameBlock frame_block(const Scene& scene, const Bounds& bounds, double width, double height, double time,
                       std::uint32_t view, bool negative_viewport = false);
ObjectBlock object_block(const Camera& camera, const glm::mat4& world_from_object);
// A negative determinant.
bool is_mirrored(const glm::mat4& world_from_object);

}  // namespace sg::runtime

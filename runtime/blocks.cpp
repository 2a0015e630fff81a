#include "runtime/blocks.hpp"

#include <algorithm>
#include <cmath>

namespace sg::runtime {

FrameBlock frame_block(const Scene& scene, const Bounds& bounds, double width, double height, double time,
                       std::uint32_t view, bool negative_viewport) {
    CameraMatrices matrices = camera_matrices(scene.camera, bounds, width, height);
    if (negative_viewport) {  // y px is that much from the lower edge
        matrices.relative_from_screen[3] += height * matrices.relative_from_screen[1];
        matrices.relative_from_screen[1] *= -1;
    }
    FrameBlock out{};
    out.clip_from_relative = glm::mat4(matrices.clip_from_relative);
    out.relative_from_screen = glm::mat4(matrices.relative_from_screen);
    const bool perspective = scene.camera.ortho_height <= 0;
    out.camera_position = glm::vec4(glm::vec3(scene.camera.position), perspective ? 1 : 0);
    out.view_direction = perspective ? glm::vec4(0) : glm::vec4(glm::vec3(matrices.direction), 0);
    out.light_direction = glm::vec4(glm::vec3(glm::normalize(scene.light.direction)), 0);
    out.light_radiance = glm::vec4(glm::vec3(scene.light.radiance), 0);
    out.ambient_radiance = glm::vec4(glm::vec3(scene.light.ambient), 0);
    out.time_view = glm::vec4(static_cast<float>(time), static_cast<float>(view), 0, 0);
    return out;
}

bool is_mirrored(const glm::mat4& world_from_object) {
    return glm::determinant(glm::dmat3(glm::dmat4(world_from_object))) < 0;
}

// As artefacts.md says. Beyond 1e15 the vertex stage's squares would leave a float's range.
glm::dmat3 normal_matrix(const glm::dmat3& m) {
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double det = glm::dot(m[0], cofactors[0]);
    const double lengths = glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]);
    double largest = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(cofactors[column][row]));
    const bool invertible = std::abs(det) > 1e-6 * lengths && largest < 1e15 * std::abs(det);
    return cofactors * (invertible ? 1 / det : det < 0 ? -1.0 : 1.0);
}

ObjectBlock object_block(const Camera& camera, const glm::mat4& world_from_object) {
    glm::dmat4 relative(world_from_object);
    relative[3] -= glm::dvec4(camera.position, 0);
    glm::dmat4 normal(normal_matrix(glm::dmat3(relative)));
    normal[3][3] = is_mirrored(world_from_object) ? -1 : 1;
    return {glm::mat4(relative), glm::mat4(normal)};
}

}  // namespace sg::runtime

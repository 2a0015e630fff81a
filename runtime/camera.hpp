// Cameras, and the numbers of the frame and object blocks that follow from them. All in double; rounded once.
#pragma once

#include <glm/glm.hpp>

#include "asset/mesh.hpp"

namespace sg::runtime {

// A box and a sphere around what is drawn, in world space.
struct Bounds {
    glm::dvec3 lower{0};
    glm::dvec3 upper{0};
    glm::dvec3 center{0};  // of the sphere
    double radius = 0;     // never 0: at least a little more than nothing
};
Bounds bounds_of(const asset::Scene& scene);

struct Camera {
    glm::dvec3 position{0, 0, 1};  // world space
    glm::dvec3 target{0};          // what stands in the middle of the picture; not the position
    double fov_degrees = 30;       // vertical, between 0 and 180; perspective only
    double ortho_height = 0;       // world units from the lower to the upper edge; 0 makes it perspective
};

// A three-quarter view from the right, above and in front, that holds the whole sphere. `aspect` is width /
// height.
Camera default_camera(const Bounds& bounds, double aspect);

// Relative world space has world axes and its origin at the camera.
struct CameraMatrices {
    glm::dmat4 clip_from_relative{1};    // Vulkan clip space: y down, depth 0 to 1
    glm::dmat4 relative_from_screen{1};  // from (x px, y px, depth, 1), homogeneous
    glm::dvec3 direction{0, 0, -1};      // unit, where the camera looks
};
// The picture's upper edge is the side of +Y, or of -Z where the camera looks up or down. The depth range
// holds the bounds.
CameraMatrices camera_matrices(const Camera& camera, const Bounds& bounds, double width, double height);

}  // namespace sg::runtime

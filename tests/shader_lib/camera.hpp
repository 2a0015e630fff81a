// Cameras of every kind that the analytic derivatives must bear, in double precision.
#pragma once

#include "harness.hpp"

namespace sg::proof {

enum class Depth { standard, reversed, reversed_infinite };

// As packed floats, so that a test's reference rebuilds exactly the camera that was drawn.
struct Camera {
    static constexpr std::size_t kFloats = 11;

    glm::dmat3 world_from_view{1.0};  // columns right, up, back; kept as the angles below
    double yaw = 0, pitch = 0, roll = 0;
    double half_height =
        0.5;  // tangent of half the vertical angle, or half the height of an orthographic view
    glm::dvec2 viewport{1920, 1080};
    double near = 0.1, far = 30000.0;
    Depth depth = Depth::standard;
    bool orthographic = false;
    double down = 1.0;  // +1: y grows downward on the screen (Vulkan); -1: a viewport of negative height

    void pack(Draw& in, std::size_t at) const;
    static Camera unpack(const In& in, std::size_t at);

    glm::dmat4 clip_from_relative() const;
    glm::dmat4 relative_from_screen() const;
    // Unit, towards the viewer.
    glm::dvec3 view(glm::dvec3 position) const {
        return orthographic ? world_from_view[2] : -glm::normalize(position);
    }
};

// A camera and, in view of it, a point at `distance` along the view direction.
Camera draw_camera(Random& random);
glm::dvec3 draw_point(Random& random, const Camera& camera, double distance);

}  // namespace sg::proof

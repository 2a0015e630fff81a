#include "runtime/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sg::runtime {
namespace {

constexpr double kDegree = 0.017453292519943295;

struct DepthRange {
    double nearest, farthest;
};

// A tenth of slack on both sides, so that nothing touches the planes; the ratio stays below 10,000.
DepthRange depth_range(const Camera& camera, const Bounds& bounds, const glm::dvec3& direction) {
    double middle = glm::dot(bounds.center - camera.position, direction);
    double reach = bounds.radius * 1.1;
    double farthest = std::max(middle + reach, bounds.radius * 0.1);
    if (camera.ortho_height > 0) return {middle - reach, farthest};
    return {std::max(middle - reach, farthest * 1e-4), farthest};
}

glm::dmat4 perspective(double fov_degrees, double aspect, DepthRange range) {
    double focal = 1 / std::tan(fov_degrees * kDegree / 2);
    glm::dmat4 out(0);
    out[0][0] = focal / aspect;
    out[1][1] = -focal;
    out[2][2] = range.farthest / (range.nearest - range.farthest);
    out[2][3] = -1;
    out[3][2] = range.nearest * range.farthest / (range.nearest - range.farthest);
    return out;
}

glm::dmat4 orthographic(double height, double aspect, DepthRange range) {
    glm::dmat4 out(1);
    out[0][0] = 2 / (height * aspect);
    out[1][1] = -2 / height;
    out[2][2] = 1 / (range.nearest - range.farthest);
    out[3][2] = range.nearest / (range.nearest - range.farthest);
    return out;
}

// Rows are the camera's right, up and backward axes.
glm::dmat4 view_from_relative(const glm::dvec3& direction) {
    glm::dvec3 up = std::abs(direction.y) > 0.9999 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    glm::dvec3 right = glm::normalize(glm::cross(direction, up));
    up = glm::cross(right, direction);
    return glm::transpose(
        glm::dmat4(glm::dvec4(right, 0), glm::dvec4(up, 0), glm::dvec4(-direction, 0), {0, 0, 0, 1}));
}

}  // namespace

Bounds bounds_of(const asset::Scene& scene) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Bounds out{glm::dvec3(kInfinity), glm::dvec3(-kInfinity)};
    auto for_each_point = [&](auto&& use) {
        for (const asset::Instance& instance : scene.instances) {
            glm::dmat4 world(instance.world_from_object);
            for (const glm::vec3& p : scene.meshes[instance.mesh].positions)
                use(glm::dvec3(world * glm::dvec4(p, 1)));
        }
    };
    for_each_point([&](const glm::dvec3& p) {
        out.lower = glm::min(out.lower, p);
        out.upper = glm::max(out.upper, p);
    });
    if (!(out.lower.x <= out.upper.x)) out.lower = out.upper = glm::dvec3(0);
    out.center = (out.lower + out.upper) * 0.5;
    for_each_point(
        [&](const glm::dvec3& p) { out.radius = std::max(out.radius, glm::distance(p, out.center)); });
    out.radius = std::max(out.radius, 1e-6);
    return out;
}

Camera default_camera(const Bounds& bounds, double aspect) {
    Camera camera;
    double half = camera.fov_degrees * kDegree / 2;
    double narrower = aspect < 1 ? std::atan(std::tan(half) * aspect) : half;
    double distance = bounds.radius / std::sin(narrower) * 1.04;
    camera.target = bounds.center;
    camera.position = bounds.center + glm::normalize(glm::dvec3(0.5, 0.6, 1)) * distance;
    return camera;
}

CameraMatrices camera_matrices(const Camera& camera, const Bounds& bounds, double width, double height) {
    CameraMatrices out;
    out.direction = glm::normalize(camera.target - camera.position);
    DepthRange range = depth_range(camera, bounds, out.direction);
    double aspect = width / height;
    glm::dmat4 clip_from_view = camera.ortho_height > 0 ? orthographic(camera.ortho_height, aspect, range)
                                                        : perspective(camera.fov_degrees, aspect, range);
    out.clip_from_relative = clip_from_view * view_from_relative(out.direction);
    glm::dmat4 clip_from_screen(1);
    clip_from_screen[0][0] = 2 / width;
    clip_from_screen[1][1] = 2 / height;
    clip_from_screen[3] = {-1, -1, 0, 1};
    out.relative_from_screen = glm::inverse(out.clip_from_relative) * clip_from_screen;
    return out;
}

}  // namespace sg::runtime

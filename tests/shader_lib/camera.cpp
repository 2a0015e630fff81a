#include "camera.hpp"

namespace sg::proof {
namespace {

glm::dmat3 rotation(double yaw, double pitch, double roll) {
    auto turn = [](double angle, int a, int b) {
        glm::dmat3 m(1.0);
        m[a][a] = std::cos(angle), m[a][b] = std::sin(angle);
        m[b][a] = -std::sin(angle), m[b][b] = std::cos(angle);
        return m;
    };
    return turn(yaw, 0, 2) * turn(pitch, 1, 2) * turn(roll, 0, 1);
}

// Clip z and w as rows over the view depth (positive in front) and 1.
struct DepthRows {
    double z_depth, z_one;
};
DepthRows depth_rows(const Camera& c) {
    if (c.orthographic) {
        const double scale = 1.0 / (c.far - c.near);
        return c.depth == Depth::standard ? DepthRows{scale, -c.near * scale}
                                          : DepthRows{-scale, c.far * scale};
    }
    if (c.depth == Depth::reversed_infinite) return {0.0, c.near};
    const double scale = c.far / (c.far - c.near);
    if (c.depth == Depth::standard) return {scale, -c.near * scale};
    return {1.0 - scale, c.near * scale};
}

}  // namespace

void Camera::pack(Draw& in, std::size_t at) const {
    const double values[kFloats] = {yaw,
                                    pitch,
                                    roll,
                                    half_height,
                                    viewport.x,
                                    viewport.y,
                                    near,
                                    far,
                                    static_cast<double>(depth),
                                    orthographic ? 1.0 : 0.0,
                                    down};
    for (std::size_t k = 0; k < kFloats; ++k) in.put(at + k, values[k]);
}

Camera Camera::unpack(const In& in, std::size_t at) {
    Camera c;
    c.yaw = in[at], c.pitch = in[at + 1], c.roll = in[at + 2];
    c.world_from_view = rotation(c.yaw, c.pitch, c.roll);
    c.half_height = in[at + 3], c.viewport = in.v2(at + 4);
    c.near = in[at + 6], c.far = in[at + 7];
    c.depth = static_cast<Depth>(static_cast<int>(in[at + 8]));
    c.orthographic = in[at + 9] != 0.0, c.down = in[at + 10];
    return c;
}

glm::dmat4 Camera::clip_from_relative() const {
    const DepthRows rows = depth_rows(*this);
    const double width = half_height * viewport.x / viewport.y;
    glm::dmat4 clip_from_view(0.0);  // view space looks along -z
    clip_from_view[0][0] = 1.0 / width;
    clip_from_view[1][1] = -down / half_height;
    clip_from_view[2][2] = -rows.z_depth;
    clip_from_view[3][2] = rows.z_one;
    clip_from_view[2][3] = orthographic ? 0.0 : -1.0;
    clip_from_view[3][3] = orthographic ? 1.0 : 0.0;
    return clip_from_view * glm::dmat4(glm::transpose(world_from_view));
}

glm::dmat4 Camera::relative_from_screen() const {
    glm::dmat4 screen_from_clip(1.0);
    screen_from_clip[0][0] = 0.5 * viewport.x, screen_from_clip[3][0] = 0.5 * viewport.x;
    screen_from_clip[1][1] = 0.5 * viewport.y, screen_from_clip[3][1] = 0.5 * viewport.y;
    return glm::inverse(screen_from_clip * clip_from_relative());
}

Camera draw_camera(Random& random) {
    std::vector<float> floats(Camera::kFloats);
    Draw in(floats);
    Camera c;
    c.yaw = random.uniform(-3.0, 3.0), c.pitch = random.uniform(-1.5, 1.5),
    c.roll = random.uniform(-3.0, 3.0);
    c.orthographic = random.below(4) == 0;
    c.half_height = c.orthographic ? random.magnitude(0.1, 1000.0) : random.uniform(0.1, 1.5);
    c.viewport = {256 + random.below(3840), 256 + random.below(2160)};
    c.near = random.magnitude(0.05, 1.0), c.far = random.uniform(25000.0, 50000.0);
    c.depth = static_cast<Depth>(random.below(c.orthographic ? 2 : 3));
    c.down = random.sign();
    c.pack(in, 0);
    return Camera::unpack(In(floats), 0);
}

glm::dvec3 draw_point(Random& random, const Camera& c, double distance) {
    const double reach = c.orthographic ? 1.0 : distance, width = c.half_height * c.viewport.x / c.viewport.y;
    return c.world_from_view * glm::dvec3(random.uniform(-1.0, 1.0) * width * reach,
                                          random.uniform(-1.0, 1.0) * c.half_height * reach, -distance);
}

}  // namespace sg::proof

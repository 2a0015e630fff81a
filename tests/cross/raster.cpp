#include "tests/cross/raster.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sg::cross {
namespace {

constexpr std::int64_t kSub = 256;  // steps per pixel
constexpr int kWidth = static_cast<int>(kSide);

struct Corner {
    const RasterVertex* vertex = nullptr;
    double x = 0, y = 0, depth = 0, over_w = 0;  // pixels from the upper left corner
    std::int64_t fixed_x = 0, fixed_y = 0;
};

Corner corner_of(const RasterVertex& vertex) {
    const double w = double{vertex.position[3]};
    if (!(w > 0)) throw std::runtime_error("the scene must lie in front of the camera");
    Corner out{&vertex};
    out.over_w = 1 / w;
    out.x = (vertex.position[0] / w * 0.5 + 0.5) * kWidth;
    out.y = (0.5 - vertex.position[1] / w * 0.5) * kWidth;
    out.depth = vertex.position[2] / w;
    out.fixed_x = std::llround(out.x * kSub);
    out.fixed_y = std::llround(out.y * kSub);
    return out;
}

// Twice the area to the right of the edge a -> b, y down; positive inside a clockwise triangle.
std::int64_t edge(const Corner& a, const Corner& b, std::int64_t x, std::int64_t y) {
    return (b.fixed_x - a.fixed_x) * (y - a.fixed_y) - (b.fixed_y - a.fixed_y) * (x - a.fixed_x);
}

bool covers(const Corner (&c)[3], int px, int py) {
    const std::int64_t x = px * kSub + kSub / 2, y = py * kSub + kSub / 2;
    for (int i = 0; i < 3; ++i) {
        const Corner &a = c[i], &b = c[(i + 1) % 3];
        const std::int64_t side = edge(a, b, x, y);
        bool top_left = b.fixed_y < a.fixed_y || (b.fixed_y == a.fixed_y && b.fixed_x > a.fixed_x);
        if (side < 0 || (side == 0 && !top_left)) return false;
    }
    return true;
}

// Within a step of an edge: where a corner is rounded the other way, the pixel goes to the neighbour.
bool is_on_edge(const Corner (&c)[3], int px, int py) {
    const std::int64_t x = px * kSub + kSub / 2, y = py * kSub + kSub / 2;
    bool near = false;
    for (int i = 0; i < 3; ++i) {
        const Corner &a = c[i], &b = c[(i + 1) % 3];
        const auto side = static_cast<double>(edge(a, b, x, y));
        const double length = std::hypot(b.fixed_x - a.fixed_x, b.fixed_y - a.fixed_y);
        if (side < -length) return false;
        near |= side <= length;
    }
    return near;
}

struct Weights {
    double of[3];
};
// Barycentric in the plane of the screen, also outside of the triangle.
Weights weights_at(const Corner (&c)[3], double x, double y) {
    Weights out{};
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const Corner &a = c[(i + 1) % 3], &b = c[(i + 2) % 3];
        out.of[i] = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
        sum += out.of[i];
    }
    for (double& weight : out.of) weight /= sum;
    return out;
}

void interpolate(const Corner (&c)[3], const Weights& weights, SgNumbers& out) {
    double scale[3], sum = 0;
    for (int i = 0; i < 3; ++i) sum += scale[i] = weights.of[i] * c[i].over_w;
    for (int location = 0; location < 16; ++location) {
        for (int k = 0; k < 4; ++k) {
            double value = 0;
            for (int i = 0; i < 3; ++i) value += scale[i] * double{c[i].vertex->varyings[location][k]};
            out[location][k] = static_cast<float>(value / sum);
        }
    }
}

struct Canvas {
    std::size_t attachments = 1;
    Pixels pixels = Pixels(std::max<std::size_t>(attachments, 1) * kPlane);
    std::vector<double> depth = std::vector<double>(kPlane / 4, 1.0);
    std::vector<bool> on_edge = std::vector<bool>(kPlane / 4);

    void write(std::size_t pixel, double at_depth, const SgColors& colors, int of_quad) {
        depth[pixel] = at_depth;
        for (std::size_t i = 0; i < attachments; ++i)
            std::copy_n(colors[i][of_quad], 4, &pixels[i * kPlane + 4 * pixel]);
        if (attachments > 0) return;
        std::fill_n(&pixels[4 * pixel], 3, static_cast<float>(at_depth));
        pixels[4 * pixel + 3] = 1;
    }
};

void shade_quad(Canvas& canvas, const Corner (&c)[3], int left, int top, bool front,
                const SgBindings& bindings, SgFragmentFunction fragment) {
    bool wanted[4];
    double depth[4];
    SgNumbers varyings[4];
    for (int i = 0; i < 4; ++i) {
        const int x = left + i % 2, y = top + i / 2;
        const Weights weights = weights_at(c, x + 0.5, y + 0.5);
        depth[i] = weights.of[0] * c[0].depth + weights.of[1] * c[1].depth + weights.of[2] * c[2].depth;
        const auto at = static_cast<std::size_t>(y * kWidth + x);
        wanted[i] = covers(c, x, y) && depth[i] < canvas.depth[at];
        if (is_on_edge(c, x, y)) canvas.on_edge[at] = true;
        interpolate(c, weights, varyings[i]);
    }
    if (std::none_of(std::begin(wanted), std::end(wanted), [](bool w) { return w; })) return;
    SgColors colors;
    bool discarded[4];
    fragment(bindings, varyings, front, colors, discarded);
    for (int i = 0; i < 4; ++i) {
        if (!wanted[i] || discarded[i]) continue;
        canvas.write(static_cast<std::size_t>((top + i / 2) * kWidth + left + i % 2), depth[i], colors, i);
    }
}

// The first and last pixel, on quads, that a range of steps can touch.
std::pair<int, int> quads(std::int64_t low, std::int64_t high) {
    int from = static_cast<int>(std::clamp<std::int64_t>(low / kSub - 1, 0, kWidth - 1)) & ~1;
    int to = static_cast<int>(std::clamp<std::int64_t>(high / kSub + 1, 0, kWidth - 1)) | 1;
    return {from, to};
}

}  // namespace

MetalPicture rasterise(const std::vector<RasterVertex>& vertices, const Drawing& drawing,
                       const SgBindings& bindings, SgFragmentFunction fragment) {
    Canvas canvas{drawing.attachments};
    const std::vector<std::uint32_t>& indices = drawing.indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        Corner c[3] = {corner_of(vertices[indices[i]]), corner_of(vertices[indices[i + 1]]),
                       corner_of(vertices[indices[i + 2]])};
        const std::int64_t area = edge(c[0], c[1], c[2].fixed_x, c[2].fixed_y);
        const bool front = area < 0;  // counter-clockwise to the eye, y down
        if (area == 0 || (drawing.cull_back && !front)) continue;
        if (front) std::swap(c[1], c[2]);
        const auto [x0, x1] = quads(std::min({c[0].fixed_x, c[1].fixed_x, c[2].fixed_x}),
                                    std::max({c[0].fixed_x, c[1].fixed_x, c[2].fixed_x}));
        const auto [y0, y1] = quads(std::min({c[0].fixed_y, c[1].fixed_y, c[2].fixed_y}),
                                    std::max({c[0].fixed_y, c[1].fixed_y, c[2].fixed_y}));
        for (int y = y0; y <= y1; y += 2) {
            for (int x = x0; x <= x1; x += 2) shade_quad(canvas, c, x, y, front, bindings, fragment);
        }
    }
    return {std::move(canvas.pixels), std::move(canvas.on_edge)};
}

}  // namespace sg::cross

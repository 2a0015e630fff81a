#include "ir/reference/parallax.hpp"

#include <algorithm>

namespace sg::ref {

// direction = a dpdx + b dpdy + c n: the coordinate changes by a dx + b dy.
dvec3 parallax_direction(const Frame& frame, const Uv& uv, dvec3 direction) {
    const dmat3 axes(frame.dpdx, frame.dpdy, frame.normal);
    const double along_n = glm::dot(direction, frame.normal);
    const double area = std::abs(glm::determinant(axes));
    if (!(area > 1e-5 * glm::length(frame.dpdx) * glm::length(frame.dpdy))) return {0.0, 0.0, along_n};
    const dvec3 parts = glm::inverse(axes) * direction;
    return {parts.x * uv.dx + parts.y * uv.dy, along_n};
}

dvec2 parallax_offset(dvec3 view, double height) {
    return dvec2(view) * height;
}

dvec2 parallax_scale(double scale, int steps, dvec2 dim) {
    const double per_step = scale / 2.0 / std::max(steps, 1);
    return {per_step / dim.x, per_step / dim.y};
}

dvec2 parallax_steps(const TextureSource& map, const Sampler& sampler, dvec2 decode, const Uv& uv,
                     dvec2 stride, int steps) {
    dvec2 offset(0.0);
    for (int i = 0; i < steps; ++i) {
        offset += stride * (decode.y + decode.x * sample_grad(map, sampler, uv.st + offset, uv.dx, uv.dy).x);
    }
    return offset;
}

double parallax_height(const TextureSource& map, const Sampler& sampler, dvec2 heights, dvec2 st,
                       double level) {
    return heights.x * sample_lod(map, sampler, st, level).x + heights.y;
}

March parallax_march(const TextureSource& map, const Sampler& sampler, dvec2 heights, dvec2 st, dvec3 view,
                     double level, int steps) {
    return parallax_march([&](dvec2 at) { return sample_lod(map, sampler, at, level).x; }, heights, st, view,
                          steps);
}

March parallax_march(const std::function<double(dvec2)>& texel, dvec2 heights, dvec2 st, dvec3 view,
                     int steps) {
    const dvec2 run = dvec2(view) / std::max(view.z, 1.0 / 32.0);
    const double top = heights.y + std::max(heights.x, 0.0), bottom = heights.y + std::min(heights.x, 0.0);
    March march{{}, INFINITY, 1.0};
    double previous = 0.0;
    for (int i = 0; i <= steps; ++i) {
        const double ray = top + (bottom - top) * i / steps;
        const double gap = ray - (heights.x * texel(st + ray * run) + heights.y);
        march.closest = std::min(march.closest, std::abs(gap));
        march.hit = {ray * run, ray};
        if (gap <= 0.0) {
            // Where the line through the two gaps crosses zero.
            const double before = top + (bottom - top) * (i - 1) / steps;
            const double crossing = i > 0 ? ray + (before - ray) * gap / (gap - previous) : ray;
            march.hit = {crossing * run, crossing};
            if (i > 0) march.amplification += (before - ray) / (previous - gap);
            break;
        }
        previous = gap;
    }
    return march;
}

// offset = right dx + down dy.
dvec2 parallax_pixels(const Uv& uv, dvec2 offset) {
    const glm::dmat2 steps(uv.dx, uv.dy);
    if (is_degenerate(uv)) return dvec2(0.0);
    return glm::inverse(steps) * offset;
}

dvec3 parallax_position(const Frame& frame, dvec2 pixels, double height) {
    return frame.position + reject(pixels.x * frame.dpdx + pixels.y * frame.dpdy, frame.normal) +
           height * frame.normal;
}

dvec3 parallax_normal(dvec3 n, dvec3 dndx, dvec3 dndy, dvec2 pixels) {
    const dvec3 moved = n + pixels.x * dndx + pixels.y * dndy;
    return glm::dot(moved, moved) > 1e-6 ? normalized(moved) : n;
}

Uv parallax_uv(const Uv& uv, dvec2 offset) {
    return {uv.st + offset, uv.dx, uv.dy};
}

Uv parallax_detail_uv(const Frame& frame, const Uv& uv, dvec2 pixels, dvec3 dpdx, dvec3 dpdy) {
    return {uv.st + glm::dmat2(uv.dx, uv.dy) * pixels, dvec2(parallax_direction(frame, uv, dpdx)),
            dvec2(parallax_direction(frame, uv, dpdy))};
}

}  // namespace sg::ref

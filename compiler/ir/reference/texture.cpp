#include "ir/reference/texture.hpp"

#include <algorithm>

namespace sg::ref {
namespace {

int into(int i, int size, Wrap wrap) {
    if (wrap == Wrap::clamp) return std::clamp(i, 0, size - 1);
    int period = wrap == Wrap::mirror ? 2 * size : size;
    int rest = ((i % period) + period) % period;
    return rest < size ? rest : period - 1 - rest;
}

}  // namespace

dvec4 texel_at(const TextureSource& texture, const Sampler& sampler, glm::ivec2 texel, int level) {
    glm::ivec2 size = texture.size(level);
    return texture.fetch({into(texel.x, size.x, sampler.wrap_s), into(texel.y, size.y, sampler.wrap_t)},
                         level);
}

dvec4 sample_bilinear(const TextureSource& texture, const Sampler& sampler, dvec2 st, int level) {
    SG_ASSERT(std::isfinite(st.x) && std::isfinite(st.y));
    dvec2 position = st * dvec2(texture.size(level)) - 0.5;
    dvec2 corner = glm::floor(position);
    dvec2 t = position - corner;
    glm::ivec2 at(corner);
    dvec4 sum(0.0);
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 2; ++i) {
            double weight = (i == 1 ? t.x : 1.0 - t.x) * (j == 1 ? t.y : 1.0 - t.y);
            sum += weight * texel_at(texture, sampler, at + glm::ivec2(i, j), level);
        }
    }
    return sum;
}

dvec4 sample_lod(const TextureSource& texture, const Sampler& sampler, dvec2 st, double lod) {
    const int last = texture.levels() - 1;
    double level = lod > 0.0 ? std::min(lod, static_cast<double>(last)) : 0.0;
    int fine = static_cast<int>(level);
    int coarse = std::min(fine + 1, last);
    double t = level - fine;
    dvec4 below = sample_bilinear(texture, sampler, st, fine);
    return t > 0.0 ? (1.0 - t) * below + t * sample_bilinear(texture, sampler, st, coarse) : below;
}

dvec4 sample_grad(const TextureSource& texture, const Sampler& sampler, dvec2 st, dvec2 dx, dvec2 dy) {
    dvec2 size(texture.size(0));
    double footprint = std::max(glm::length(size * dx), glm::length(size * dy));
    return sample_lod(texture, sampler, st, footprint > 1.0 ? std::log2(footprint) : 0.0);
}

}  // namespace sg::ref

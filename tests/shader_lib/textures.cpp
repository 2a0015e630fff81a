#include "textures.hpp"

namespace sg::proof {
namespace {

using Texel = std::function<glm::dvec4(glm::ivec2 texel, glm::ivec2 size)>;

std::shared_ptr<const CaseTexture> make_texture(glm::ivec2 size, bool levels, ref::Wrap wrap,
                                                const Texel& texel) {
    auto out = std::make_shared<CaseTexture>();
    out->sampler = {wrap, wrap};
    while (true) {
        ref::MemoryTexture::Level level{size, {}};
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) level.texels.emplace_back(glm::vec4(texel({x, y}, size)));
        }
        out->image.chain.push_back(std::move(level));
        if (!levels || size == glm::ivec2(1)) return out;
        size = glm::max(size / 2, glm::ivec2(1));
    }
}

}  // namespace

std::shared_ptr<const CaseTexture> height_texture(glm::ivec2 size, bool levels,
                                                  const std::function<double(double u, double v)>& height) {
    return make_texture(size, levels, ref::Wrap::clamp, [&](glm::ivec2 texel, glm::ivec2 of) {
        const glm::dvec2 at = (glm::dvec2(texel) + 0.5) / glm::dvec2(of) * glm::dvec2(size) - 0.5;
        return glm::dvec4(height(at.x, at.y), 0.0, 0.0, 1.0);
    });
}

std::shared_ptr<const CaseTexture> random_texture(glm::ivec2 size, bool levels, ref::Wrap wrap) {
    Random random("texture");
    return make_texture(size, levels, wrap, [&](glm::ivec2, glm::ivec2) {
        return glm::dvec4(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0), random.uniform(0.0, 1.0),
                          random.uniform(0.0, 1.0));
    });
}

}  // namespace sg::proof

#include "tests/oracle/memory_texture.hpp"

#include <algorithm>

namespace sg::oracle {

ref::MemoryTexture one_texel(ref::dvec4 texel) {
    ref::MemoryTexture texture;
    texture.chain.push_back({{1, 1}, {texel}});
    return texture;
}

ref::MemoryTexture random_texture(std::mt19937_64& random, glm::ivec2 size) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    ref::MemoryTexture texture;
    while (true) {
        ref::MemoryTexture::Level level{size, {}};
        for (int i = 0; i < size.x * size.y; ++i) {
            level.texels.emplace_back(unit(random), unit(random), 0.6 + 0.4 * unit(random), unit(random));
        }
        texture.chain.push_back(std::move(level));
        if (size == glm::ivec2(1)) return texture;
        size = {std::max(size.x / 2, 1), std::max(size.y / 2, 1)};
    }
}

ref::MemoryTexture random_texture(std::mt19937_64& random, glm::ivec2 size, ir::TextureEncoding encoding) {
    using enum ir::TextureEncoding;
    const bool any_sign = encoding == height || encoding == derivative || encoding == color;
    ref::MemoryTexture texture = random_texture(random, size);
    for (auto& level : texture.chain) {
        for (auto& texel : level.texels) {
            if (!any_sign) continue;
            const double alpha = texel.a;
            texel = {2.0 * texel.r - 1.0, 2.0 * texel.g - 1.0, 5.0 * texel.b - 4.0, 2.0 * texel.a - 1.0};
            if (encoding == color) texel.a = alpha;
        }
    }
    return texture;
}

}  // namespace sg::oracle

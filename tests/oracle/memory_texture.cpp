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

}  // namespace sg::oracle

// Textures in double precision: what a perfect sampler reads.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "ir/reference/checked.hpp"

namespace sg::ref {

// Where texels come from. Implementations need no bounds checks: texel lies in [0, size(level)).
struct TextureSource {
    virtual ~TextureSource() = default;
    virtual dvec4 fetch(glm::ivec2 texel, int level) const = 0;
    virtual glm::ivec2 size(int level) const = 0;
    virtual int levels() const = 0;
};

enum class Wrap { repeat, clamp, mirror };

struct Sampler {
    Wrap wrap_s = Wrap::repeat;
    Wrap wrap_t = Wrap::repeat;
};

// The texel at any integer position, wrapped or clamped into the level.
dvec4 texel_at(const TextureSource& texture, const Sampler& sampler, glm::ivec2 texel, int level);
// Bilinear within one level. st: normalised, texel centres at (i + 0.5)/size.
dvec4 sample_bilinear(const TextureSource& texture, const Sampler& sampler, dvec2 st, int level);
// Trilinear. lod: any number; clamped to the levels that exist.
dvec4 sample_lod(const TextureSource& texture, const Sampler& sampler, dvec2 st, double lod);
// Trilinear at the isotropic level of detail of two gradients (of st, per pixel).
dvec4 sample_grad(const TextureSource& texture, const Sampler& sampler, dvec2 st, dvec2 dx, dvec2 dy);

// Texels in memory, one array per level.
struct MemoryTexture : TextureSource {
    struct Level {
        glm::ivec2 size;
        std::vector<dvec4> texels;  // rows from the top
    };
    std::vector<Level> chain;

    dvec4 fetch(glm::ivec2 texel, int level) const override {
        const Level& at = chain[static_cast<std::size_t>(level)];
        return at.texels[static_cast<std::size_t>(texel.y) * static_cast<std::size_t>(at.size.x) +
                         static_cast<std::size_t>(texel.x)];
    }
    glm::ivec2 size(int level) const override { return chain[static_cast<std::size_t>(level)].size; }
    int levels() const override { return static_cast<int>(chain.size()); }
};

}  // namespace sg::ref

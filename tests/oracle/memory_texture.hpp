// Texels for the interpreter.
#pragma once

#include <random>

#include "ir/ir.hpp"
#include "ir/reference/texture.hpp"

namespace sg::oracle {

ref::MemoryTexture one_texel(ref::dvec4 texel);
// A full chain whose levels have nothing to do with each other.
ref::MemoryTexture random_texture(std::mt19937_64& random, glm::ivec2 size);
// The same with all that a texture of this encoding may hold: masks and the alpha of colours 0 to 1, heights,
// derivatives and colours of float files -1 to 1.
ref::MemoryTexture random_texture(std::mt19937_64& random, glm::ivec2 size, ir::TextureEncoding encoding);

}  // namespace sg::oracle

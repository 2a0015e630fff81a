// Texels for the interpreter.
#pragma once

#include <random>

#include "ir/reference/texture.hpp"

namespace sg::oracle {

ref::MemoryTexture one_texel(ref::dvec4 texel);
// A full chain whose levels have nothing to do with each other.
ref::MemoryTexture random_texture(std::mt19937_64& random, glm::ivec2 size);

}  // namespace sg::oracle

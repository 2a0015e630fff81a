// Texts with one mistake in them, as a cross-compiler or an engine could make it.
#pragma once

#include "tests/cross/scene.hpp"

namespace sg::cross {

struct Mutant {
    std::string name;
    Drawing drawing;
};
// Of a sample with two textures or more; also for wgsl_recipe(). Throws where a text holds no place for a
// mistake.
std::vector<Mutant> mutants(const Sample& sample, const target::Target& target);

}  // namespace sg::cross

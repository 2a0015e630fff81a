// Texts with one mistake in them, as a cross-compiler or an engine could make it.
#pragma once

#include "tests/cross/scene.hpp"

namespace sg::cross {

struct Mutant {
    std::string name;
    Drawing drawing;
};
// Also for wgsl_recipe(). Throws where a text holds no place for a mistake.
std::vector<Mutant> mutants(const target::Target& target);

}  // namespace sg::cross

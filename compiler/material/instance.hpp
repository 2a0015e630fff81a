// Materials that extend others: the same structure, other values of parameters.
#pragma once

#include "material/find_file.hpp"
#include "material/material.hpp"

namespace sg::material {

// Reads a material; one that extends another becomes that one with its parameters' values in place. `file` is
// where the document lies, with links followed. Reports as `read` does, in each file of the chain.
Material read_whole(const json::Document& document, const std::filesystem::path& file, const Roots& roots,
                    Files& files, Diags& diags);

}  // namespace sg::material

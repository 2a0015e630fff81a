// Files that a material names: looked up below its folder and the -I roots, never outside them.
#pragma once

#include <optional>
#include <string>

#include "base/files.hpp"
#include "material/material.hpp"

namespace sg::material {

// Where files may be: the material's own folder first, then each -I root.
struct Roots {
    std::vector<std::filesystem::path> folders;
};

struct FoundFile {
    std::string bytes;
    std::filesystem::path path;  // with links followed
};
// Reports why not.
std::optional<FoundFile> find_file(const std::string& written, const At& at, const SourcePtr& source,
                                   const Roots& roots, Files& files, Diags& diags);

}  // namespace sg::material

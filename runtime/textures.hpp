// The pictures that an artefact names, read and reduced, still in the processor's memory.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "asset/image.hpp"
#include "base/diag.hpp"
#include "base/files.hpp"
#include "runtime/artefact.hpp"

namespace sg::runtime {

// One mip chain per texture of the artefact, in its order; level 0 is the file's picture.
struct TextureSet {
    std::vector<std::vector<asset::Image>> chains;
};

// Settings "NAME=FILE" of parameters of type texture put another file, encoded alike, in the place of the
// texture that the parameter stands for. Gives the settings that are left.
std::vector<std::string> exchange_textures(Artefact& artefact, std::span<const std::string> settings);

// Files are looked up below `root` and never outside it. Fails with file_missing, path_escapes or what
// read_image reports; a picture whose hash differs from the manifest's is only a warning.
std::optional<TextureSet> load_textures(Files& files, const Artefact& artefact,
                                        const std::filesystem::path& root, Diags& diags);

}  // namespace sg::runtime

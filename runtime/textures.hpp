// The pictures that an artefact names, read and reduced, still in the processor's memory.
#pragma once

#include <filesystem>
#include <optional>
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

// Files are looked up below `root` and never outside it. Fails with file_missing, path_escapes or what
// read_image reports; a picture whose hash differs from the manifest's is only a warning.
std::optional<TextureSet> load_textures(Files& files, const Artefact& artefact,
                                        const std::filesystem::path& root, Diags& diags);

}  // namespace sg::runtime

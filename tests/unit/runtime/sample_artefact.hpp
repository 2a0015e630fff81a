// A small artefact made by hand, as compiler/artefacts.md asks: the runtime's tests need no compiler.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "asset/image.hpp"
#include "base/files.hpp"

namespace sg::runtime::test {

// 64x64: upper left red, upper right green, lower left blue, lower right white, with a dark frame.
asset::Image paint();

// The manifest "sample.json", its shaders and its texture, below `folder`. Entries: forward (paint times the
// parameters tint and gain) and debug with the views position, base-normal, uv0, uv0-derivatives, tangent,
// unprojected and facing.
std::vector<std::pair<std::filesystem::path, std::string>> sample_files(const std::filesystem::path& folder,
                                                                        const std::string& two_sided = "off");
// The manifest's text alone.
std::string sample_manifest(const std::string& two_sided = "off");

}  // namespace sg::runtime::test

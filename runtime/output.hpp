// Pictures as files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/diag.hpp"
#include "runtime/picture.hpp"
#include "runtime/tonemap.hpp"
#include "runtime/views.hpp"

namespace sg::runtime {

enum class PictureFormat { png, exr, pfm };
// By the extension, in any case; none for another.
std::optional<PictureFormat> picture_format(const std::filesystem::path& path);

struct DisplayOptions {
    double exposure = 0;  // stops
    ViewSpace space;
};
// PNG: for the eye (tonemap.hpp). EXR: raw floats; a view of four components keeps its alpha as data and gets
// a layer "coverage" beside it. PFM: raw rgb, the background is 0.
std::string picture_bytes(const Picture& picture, const DebugView& view, PictureFormat format,
                          const DisplayOptions& display);

// A multi-layer EXR: one layer per view, named as the view, and a layer "coverage" with one channel.
std::string layered_exr(const std::vector<View>& views, std::vector<Picture> pictures);

}  // namespace sg::runtime

// One reader per family of image files; asset/image.hpp chooses among them. Internal to this folder.
#pragma once

#include <optional>
#include <string_view>

#include "asset/image.hpp"

namespace sg::asset {

constexpr std::uint32_t kMaxImageSide = 16384;

// What a reader needs to name a file in its messages.
struct ImageSource {
    std::string_view bytes;
    std::string_view name;
    const Place& place;
};

std::optional<Image> read_png(const ImageSource& source, Diags& diags);
std::optional<Image> read_with_stb(const ImageSource& source, Diags& diags);  // JPEG, TGA, BMP
std::optional<Image> read_hdr(const ImageSource& source, Diags& diags);
std::optional<Image> read_exr(const ImageSource& source, Diags& diags);
std::optional<Image> read_pfm(const ImageSource& source, Diags& diags);

// "cannot read 'wall.png' as an image: REASON", SG2001.
void report_bad_image(const ImageSource& source, std::string_view reason, Diags& diags);
// True if both sides are within 1..kMaxImageSide; else adds an error (SG2001 for no texels, SG2002).
bool check_image_size(const ImageSource& source, std::uint64_t width, std::uint64_t height, Diags& diags);

}  // namespace sg::asset

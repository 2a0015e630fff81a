// Image files behind one narrow header: what is on disk becomes RGBA texels, and pictures become files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diag.hpp"

namespace sg::asset {

enum class TexelFormat { unorm8, unorm16, float32 };  // of each of the four channels

// Row 0 is the upper row. Always four channels; missing ones read 0, 0, 1 (a grey image fills rgb).
struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    TexelFormat format = TexelFormat::unorm8;
    std::vector<std::uint8_t> bytes;  // width * height * 4 channels, native endian, tightly packed

    [[nodiscard]] std::size_t bytes_per_texel() const;
    // Channel c of texel (x, y) as a number: unorm formats divided by their maximum.
    [[nodiscard]] double at(std::uint32_t x, std::uint32_t y, int c) const;
    void set(std::uint32_t x, std::uint32_t y, int c, double value);  // clamps and rounds for unorm formats
};
Image make_image(std::uint32_t width, std::uint32_t height, TexelFormat format);

// PNG (8 or 16 bit), JPEG, TGA, BMP, HDR, EXR, PFM, told apart by content. `name` stands in messages. A
// damaged or foreign file adds an error (image_format, image_limit) at `place` and gives nothing; never
// crashes on hostile bytes.
std::optional<Image> read_image(std::string_view bytes, std::string_view name, const Place& place,
                                Diags& diags);

// What a PNG says of its numbers by a chunk sRGB, or else gAMA. Nothing is decoded.
struct PngColors {
    std::string_view chunk;  // "sRGB" or "gAMA"
    double gamma = 0.0;      // of gAMA: 1 is linear, 2.2 is near sRGB

    [[nodiscard]] bool linear() const { return gamma > 0.95 && gamma < 1.05; }
};
// Empty for a PNG without these chunks and for other formats.
std::optional<PngColors> png_colors(std::string_view bytes);

// 8-bit RGBA PNG of a unorm8 image, deterministic bytes.
std::string png_bytes(const Image& image);
// 16-bit RGBA PNG of a unorm16 image.
std::string png16_bytes(const Image& image);
// Portable float map, three channels (alpha is dropped), little-endian, rows bottom to top as the format
// demands.
std::string pfm_bytes(const Image& image);

// One named layer of a multi-layer EXR; channels are named "<layer>.R" and so on, or "R" where the name is
// "".
struct ExrLayer {
    std::string name;
    int channels = 4;  // 1 to 4 of the image are written
    Image image;       // float32; all layers of one size
};
// 32-bit float channels, ZIP compression, deterministic bytes.
std::string exr_bytes(const std::vector<ExrLayer>& layers);
// The layers of an EXR by channel prefix; for tests and tools.
std::optional<std::vector<ExrLayer>> read_exr_layers(std::string_view bytes, std::string_view name,
                                                     Diags& diags);

}  // namespace sg::asset

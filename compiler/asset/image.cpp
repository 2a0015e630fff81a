#include "asset/image.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "asset/image_readers.hpp"
#include "base/ice.hpp"

namespace sg::asset {
namespace {

std::size_t bytes_per_channel(TexelFormat format) {
    switch (format) {
        case TexelFormat::unorm8:
            return 1;
        case TexelFormat::unorm16:
            return 2;
        case TexelFormat::float32:
            return 4;
    }
    SG_UNREACHABLE("unknown texel format");
}

std::size_t channel_offset(const Image& image, std::uint32_t x, std::uint32_t y, int c) {
    SG_ASSERT(x < image.width && y < image.height && c >= 0 && c < 4);
    return (static_cast<std::size_t>(y) * image.width + x) * image.bytes_per_texel() +
           static_cast<std::size_t>(c) * bytes_per_channel(image.format);
}

// Rounds half up; what is not a number becomes 0.
template <class T>
T to_unorm(double value, double maximum) {
    if (!(value > 0.0)) return 0;
    return static_cast<T>(std::floor(std::min(value, 1.0) * maximum + 0.5));
}

bool starts_with(std::string_view bytes, std::string_view magic) {
    return bytes.substr(0, magic.size()) == magic;
}

}  // namespace

std::size_t Image::bytes_per_texel() const {
    return 4 * bytes_per_channel(format);
}

double Image::at(std::uint32_t x, std::uint32_t y, int c) const {
    const std::uint8_t* from = bytes.data() + channel_offset(*this, x, y, c);
    if (format == TexelFormat::unorm8) return *from / 255.0;
    if (format == TexelFormat::unorm16) {
        std::uint16_t code;
        std::memcpy(&code, from, sizeof code);
        return code / 65535.0;
    }
    float value;
    std::memcpy(&value, from, sizeof value);
    return static_cast<double>(value);
}

void Image::set(std::uint32_t x, std::uint32_t y, int c, double value) {
    std::uint8_t* to = bytes.data() + channel_offset(*this, x, y, c);
    if (format == TexelFormat::unorm8) {
        *to = to_unorm<std::uint8_t>(value, 255.0);
    } else if (format == TexelFormat::unorm16) {
        const auto code = to_unorm<std::uint16_t>(value, 65535.0);
        std::memcpy(to, &code, sizeof code);
    } else {
        const auto number = static_cast<float>(value);
        std::memcpy(to, &number, sizeof number);
    }
}

Image make_image(std::uint32_t width, std::uint32_t height, TexelFormat format) {
    Image image;
    image.width = width;
    image.height = height;
    image.format = format;
    image.bytes.resize(static_cast<std::size_t>(width) * height * image.bytes_per_texel());
    return image;
}

void report_bad_image(const ImageSource& source, std::string_view reason, Diags& diags) {
    diags.error(Code::image_format, source.place,
                fmt::format("cannot read '{}' as an image: {}", printable(source.name), reason));
}

bool check_image_size(const ImageSource& source, std::uint64_t width, std::uint64_t height, Diags& diags) {
    if (width == 0 || height == 0) {
        report_bad_image(source, "it has no texels", diags);
        return false;
    }
    if (width <= kMaxImageSide && height <= kMaxImageSide) return true;
    diags.error(Code::image_limit, source.place,
                fmt::format("'{}' is {} x {} texels, expected at most {} per side", printable(source.name),
                            width, height, kMaxImageSide));
    return false;
}

std::optional<Image> read_image(std::string_view bytes, std::string_view name, const Place& place,
                                Diags& diags) {
    const ImageSource source{bytes, name, place};
    if (bytes.empty()) {
        report_bad_image(source, "the file is empty", diags);
        return std::nullopt;
    }
    if (starts_with(bytes, "\x89PNG")) return read_png(source, diags);
    if (starts_with(bytes, "\x76\x2f\x31\x01")) return read_exr(source, diags);
    if (starts_with(bytes, "PF") || starts_with(bytes, "Pf")) return read_pfm(source, diags);
    if (starts_with(bytes, "#?")) return read_hdr(source, diags);
    return read_with_stb(source, diags);
}

}  // namespace sg::asset

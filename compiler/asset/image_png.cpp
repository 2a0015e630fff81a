#include <fmt/core.h>
#include <lodepng.h>

#include <bit>
#include <cstdlib>
#include <memory>

#include "asset/image.hpp"
#include "asset/image_readers.hpp"
#include "base/ice.hpp"

namespace sg::asset {
namespace {

constexpr double kGammaOfLinear = 100000;  // in a gAMA chunk, which holds 100000 / gamma
constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kChunkFrame = 12;         // of a chunk, what is not data
constexpr std::uint64_t kMostInflation = 1032;  // bytes that one byte of a deflate stream can become

struct Free {
    void operator()(unsigned char* p) const { std::free(p); }
};

const unsigned char* data_of(std::string_view bytes) {
    return reinterpret_cast<const unsigned char*>(bytes.data());
}

// Of the first four bytes.
std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t out = 0;
    for (const char c : bytes.substr(0, 4)) out = out << 8 | static_cast<unsigned char>(c);
    return out;
}

// PNG keeps 16-bit numbers big-endian.
void swap_pairs_if_little(std::vector<std::uint8_t>& bytes) {
    if constexpr (std::endian::native == std::endian::little) {
        for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) std::swap(bytes[i], bytes[i + 1]);
    }
}

bool plausible_size(const ImageSource& source, unsigned width, unsigned height, const lodepng::State& state) {
    const std::uint64_t bits = lodepng_get_bpp(&state.info_png.color);
    return std::uint64_t{width} * height * bits / 8 <= source.bytes.size() * kMostInflation;
}

std::string encode(const Image& image, const std::vector<std::uint8_t>& pixels, unsigned bit_depth) {
    lodepng::State state;
    state.info_raw.colortype = LCT_RGBA;
    state.info_raw.bitdepth = bit_depth;
    state.info_png.color.colortype = LCT_RGBA;
    state.info_png.color.bitdepth = bit_depth;
    state.encoder.auto_convert = 0;
    state.encoder.filter_strategy = LFS_MINSUM;
    state.encoder.zlibsettings.windowsize = 32768;
    std::vector<unsigned char> out;
    const unsigned failure = lodepng::encode(out, pixels, image.width, image.height, state);
    SG_ASSERT(failure == 0);
    return {out.begin(), out.end()};
}

}  // namespace

std::optional<Image> read_png(const ImageSource& source, Diags& diags) {
    const unsigned char* bytes = data_of(source.bytes);
    lodepng::State state;
    unsigned width = 0, height = 0;
    if (unsigned failure = lodepng_inspect(&width, &height, &state, bytes, source.bytes.size())) {
        report_bad_image(source, fmt::format("damaged PNG ({})", lodepng_error_text(failure)), diags);
        return std::nullopt;
    }
    if (!check_image_size(source, width, height, diags)) return std::nullopt;
    if (!plausible_size(source, width, height, state)) {
        report_bad_image(source,
                         fmt::format("damaged PNG ({} bytes cannot hold {} x {} texels)", source.bytes.size(),
                                     width, height),
                         diags);
        return std::nullopt;
    }
    const bool wide = state.info_png.color.bitdepth == 16;
    state.info_raw.colortype = LCT_RGBA;
    state.info_raw.bitdepth = wide ? 16 : 8;
    unsigned char* raw = nullptr;
    const unsigned failure = lodepng_decode(&raw, &width, &height, &state, bytes, source.bytes.size());
    const std::unique_ptr<unsigned char, Free> pixels(raw);
    if (failure) {
        report_bad_image(source, fmt::format("damaged PNG ({})", lodepng_error_text(failure)), diags);
        return std::nullopt;
    }
    Image image = make_image(width, height, wide ? TexelFormat::unorm16 : TexelFormat::unorm8);
    image.bytes.assign(raw, raw + image.bytes.size());
    if (wide) swap_pairs_if_little(image.bytes);
    return image;
}

// A chunk is its length, its type, as many bytes, and a checksum; those of the colours stand before the
// texels.
std::optional<PngColors> png_colors(std::string_view bytes) {
    if (!bytes.starts_with(kSignature)) return std::nullopt;
    bytes.remove_prefix(kSignature.size());
    std::optional<PngColors> gamma;
    while (bytes.size() >= kChunkFrame) {
        const std::string_view type = bytes.substr(4, 4);
        const std::size_t length = big_endian(bytes);
        if (type == "IDAT" || length > bytes.size() - kChunkFrame) break;
        if (type == "sRGB") return PngColors{"sRGB", 0.0};
        if (type == "gAMA" && length == 4 && big_endian(bytes.substr(8)) > 0)
            gamma = PngColors{"gAMA", kGammaOfLinear / big_endian(bytes.substr(8))};
        bytes.remove_prefix(kChunkFrame + length);
    }
    return gamma;
}

std::string png_bytes(const Image& image) {
    SG_ASSERT(image.format == TexelFormat::unorm8);
    return encode(image, image.bytes, 8);
}

std::string png16_bytes(const Image& image) {
    SG_ASSERT(image.format == TexelFormat::unorm16);
    std::vector<std::uint8_t> pixels = image.bytes;
    swap_pairs_if_little(pixels);
    return encode(image, pixels, 16);
}

}  // namespace sg::asset

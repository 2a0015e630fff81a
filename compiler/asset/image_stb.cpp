#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "asset/image_readers.hpp"

// Private copies of the functions: other libraries carry their own stb_image.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
// Zeroed memory: the packaged version decodes with Huffman tables that a damaged JPEG never defined.
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(memory, size) std::realloc(memory, size)
#define STBI_FREE(memory) std::free(memory)
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#include <stb/stb_image.h>

namespace sg::asset {
namespace {

struct Free {
    void operator()(void* p) const { stbi_image_free(p); }
};

// Texels that one byte of each format can stand for at most, generously: progressive JPEG spends at least a
// bit per 8x8 block, run lengths of TGA reach 128 texels. Keeps a few hostile bytes from asking for
// gigabytes.
constexpr std::uint64_t kMostTexelsPerByte = 512;

constexpr int kMostCodes = 255;  // of one Huffman table; those of 8-bit JPEGs have at most 162

bool plausible_size(const ImageSource& source, int width, int height) {
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) <=
           source.bytes.size() * kMostTexelsPerByte;
}

// The packaged stb_image trusts the code counts of a JPEG's Huffman tables and would write past its arrays.
// Every such segment that it can meet starts with FF C4; this walks their tables as it does.
bool huffman_tables_fit(std::string_view bytes) {
    auto byte = [&](std::size_t at) { return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0; };
    for (std::size_t at = bytes.find("\xff\xc4"); at != std::string_view::npos;
         at = bytes.find("\xff\xc4", at + 1)) {
        int left = byte(at + 2) * 256 + byte(at + 3) - 2;
        std::size_t table = at + 4;
        while (left > 0 && byte(table) >> 4 <= 1 && (byte(table) & 15) <= 3) {
            int codes = 0;
            for (std::size_t i = 1; i <= 16; ++i) codes += byte(table + i);
            if (codes > kMostCodes) return false;
            table += 17 + static_cast<std::size_t>(codes);
            left -= 17 + codes;
        }
    }
    return true;
}

const stbi_uc* data_of(const ImageSource& source) {
    return reinterpret_cast<const stbi_uc*>(source.bytes.data());
}
int size_of(const ImageSource& source) {
    return static_cast<int>(source.bytes.size());
}

}  // namespace

std::optional<Image> read_with_stb(const ImageSource& source, Diags& diags) {
    if (source.bytes.size() > 0x7fffffffu) {
        diags.error(Code::image_limit, source.place,
                    fmt::format("'{}' has {} bytes, expected less than 2 GiB", printable(source.name),
                                source.bytes.size()));
        return std::nullopt;
    }
    if (source.bytes.starts_with("\xff\xd8") && !huffman_tables_fit(source.bytes)) {
        report_bad_image(source, "damaged JPEG (a Huffman table has more than 255 codes)", diags);
        return std::nullopt;
    }
    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(data_of(source), size_of(source), &width, &height, &channels)) {
        report_bad_image(source, "expected PNG, JPEG, EXR, PFM, HDR, TGA or BMP", diags);
        return std::nullopt;
    }
    if (!check_image_size(source, static_cast<std::uint64_t>(std::max(width, 0)),
                          static_cast<std::uint64_t>(std::max(height, 0)), diags))
        return std::nullopt;
    if (!plausible_size(source, width, height)) {
        report_bad_image(source,
                         fmt::format("damaged file ({} bytes cannot hold {} x {} texels)",
                                     source.bytes.size(), width, height),
                         diags);
        return std::nullopt;
    }
    const std::unique_ptr<stbi_uc, Free> texels(
        stbi_load_from_memory(data_of(source), size_of(source), &width, &height, &channels, 4));
    if (!texels) {
        report_bad_image(source, fmt::format("damaged file ({})", stbi_failure_reason()), diags);
        return std::nullopt;
    }
    Image image = make_image(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height),
                             TexelFormat::unorm8);
    std::memcpy(image.bytes.data(), texels.get(), image.bytes.size());
    return image;
}

}  // namespace sg::asset

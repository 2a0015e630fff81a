#include <fmt/core.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "asset/image.hpp"
#include "asset/image_readers.hpp"
#include "base/ice.hpp"

namespace sg::asset {
namespace {

struct Header {
    int channels = 3;
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    bool little_endian = true;
    std::size_t data = 0;  // offset of the first float
};

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// The next run of characters that are not white space; "" at the end.
std::string_view next_word(std::string_view bytes, std::size_t& at) {
    while (at < bytes.size() && is_space(bytes[at])) ++at;
    const std::size_t begin = at;
    while (at < bytes.size() && !is_space(bytes[at])) ++at;
    return bytes.substr(begin, at - begin);
}

template <class Number>
bool parse(std::string_view word, Number& out) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), out);
    return error == std::errc{} && end == word.data() + word.size();
}

// "PF" or "Pf", width, height, scale (its sign is the byte order), then one white space before the numbers.
std::optional<Header> parse_header(std::string_view bytes) {
    Header header;
    std::size_t at = 0;
    const std::string_view magic = next_word(bytes, at);
    if (magic != "PF" && magic != "Pf") return std::nullopt;
    header.channels = magic == "PF" ? 3 : 1;
    double scale = 0.0;
    if (!parse(next_word(bytes, at), header.width) || !parse(next_word(bytes, at), header.height) ||
        !parse(next_word(bytes, at), scale) || !(std::abs(scale) > 0.0) || at >= bytes.size())
        return std::nullopt;
    header.little_endian = scale < 0.0;
    header.data = at + 1;
    return header;
}

float load_float(const char* from, bool little_endian) {
    std::array<char, 4> raw{from[0], from[1], from[2], from[3]};
    if (little_endian != (std::endian::native == std::endian::little)) raw = {raw[3], raw[2], raw[1], raw[0]};
    return std::bit_cast<float>(raw);
}

}  // namespace

std::optional<Image> read_pfm(const ImageSource& source, Diags& diags) {
    const std::optional<Header> header = parse_header(source.bytes);
    if (!header) {
        report_bad_image(source, "damaged PFM header, expected 'PF' or 'Pf', width, height and scale", diags);
        return std::nullopt;
    }
    if (!check_image_size(source, header->width, header->height, diags)) return std::nullopt;
    const std::uint64_t texel_size = 4u * static_cast<unsigned>(header->channels);
    const std::uint64_t expected = header->width * header->height * texel_size;
    if (source.bytes.size() - header->data < expected) {
        report_bad_image(source,
                         fmt::format("damaged PFM ({} bytes of numbers, expected {})",
                                     source.bytes.size() - header->data, expected),
                         diags);
        return std::nullopt;
    }
    Image image = make_image(static_cast<std::uint32_t>(header->width),
                             static_cast<std::uint32_t>(header->height), TexelFormat::float32);
    const char* from = source.bytes.data() + header->data;
    for (std::uint32_t row = image.height; row-- > 0;) {
        for (std::uint32_t x = 0; x < image.width; ++x, from += texel_size) {
            for (int c = 0; c < 3; ++c)
                image.set(x, row, c,
                          load_float(from + 4 * (header->channels == 3 ? c : 0), header->little_endian));
            image.set(x, row, 3, 1.0);
        }
    }
    return image;
}

std::string pfm_bytes(const Image& image) {
    std::string out = fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
    for (std::uint32_t row = image.height; row-- > 0;) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                auto raw = std::bit_cast<std::array<char, 4>>(static_cast<float>(image.at(x, row, c)));
                if constexpr (std::endian::native == std::endian::big) raw = {raw[3], raw[2], raw[1], raw[0]};
                out.append(raw.data(), raw.size());
            }
        }
    }
    return out;
}

}  // namespace sg::asset

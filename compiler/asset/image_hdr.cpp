// Radiance HDR by hand: the packaged stb_image never returns from a file that is cut off.
#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <vector>

#include "asset/image_readers.hpp"

namespace sg::asset {
namespace {

constexpr std::uint64_t kMostTexelsPerByte =
    127;  // of one run of one channel, and more than four of them need

struct Header {
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    std::size_t data = 0;  // offset of the first scan line
};

std::string_view next_line(std::string_view bytes, std::size_t& at) {
    const std::size_t begin = std::min(at, bytes.size());
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    at = end + 1;
    return bytes.substr(begin, end - begin);
}

// The number after `prefix`, which `text` then starts behind.
bool take_number(std::string_view& text, std::string_view prefix, std::uint64_t& out) {
    if (!text.starts_with(prefix)) return false;
    text.remove_prefix(prefix.size());
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return error == std::errc{};
}

// "" or what is wrong. Lines of settings up to an empty one, then the size, upper row first.
std::string parse_header(std::string_view bytes, Header& header) {
    std::size_t at = 0;
    bool rgbe = false;
    while (true) {
        if (at >= bytes.size()) return "the header does not end";
        const std::string_view line = next_line(bytes, at);
        if (line.empty()) break;
        if (line.starts_with("FORMAT=")) rgbe = line == "FORMAT=32-bit_rle_rgbe";
    }
    if (!rgbe) return "expected FORMAT=32-bit_rle_rgbe";
    std::string_view size = next_line(bytes, at);
    if (!take_number(size, "-Y ", header.height) || !take_number(size, " +X ", header.width) || !size.empty())
        return "expected a size as '-Y height +X width'";
    header.data = at;
    return "";
}

// Fills one scan line, four bytes a texel. False if the bytes end or a run is too long.
class LineReader {
public:
    LineReader(std::string_view bytes, std::size_t at) : bytes_(bytes), at_(at) {}

    bool read(std::vector<std::uint8_t>& line) {
        const std::size_t width = line.size() / 4;
        if (at_ > bytes_.size() || bytes_.size() - at_ < 4) return false;
        const bool packed = width >= 8 && width < 32768 && byte(0) == 2 && byte(1) == 2 &&
                            static_cast<std::size_t>(byte(2) * 256 + byte(3)) == width;
        if (!packed) return read_flat(line);
        at_ += 4;
        for (std::size_t channel = 0; channel < 4; ++channel)
            if (!read_runs(line, channel)) return false;
        return true;
    }

private:
    [[nodiscard]] std::uint8_t byte(std::size_t offset) const {
        return static_cast<std::uint8_t>(bytes_[at_ + offset]);
    }

    bool read_flat(std::vector<std::uint8_t>& line) {
        if (bytes_.size() - at_ < line.size()) return false;
        for (std::size_t i = 0; i < line.size(); ++i) line[i] = byte(i);
        at_ += line.size();
        return true;
    }

    // A count above 128 repeats one byte, another count stands before that many bytes.
    bool read_runs(std::vector<std::uint8_t>& line, std::size_t channel) {
        const std::size_t width = line.size() / 4;
        for (std::size_t x = 0; x < width;) {
            if (bytes_.size() - at_ < 2) return false;
            const bool repeated = byte(0) > 128;
            const std::size_t count = repeated ? byte(0) - 128u : byte(0);
            const std::size_t stored = repeated ? 1 : count;
            if (count == 0 || count > width - x || bytes_.size() - at_ - 1 < stored) return false;
            for (std::size_t i = 0; i < count; ++i)
                line[4 * (x + i) + channel] = byte(1 + (repeated ? 0 : i));
            at_ += 1 + stored;
            x += count;
        }
        return true;
    }

    std::string_view bytes_;
    std::size_t at_;
};

// Mantissas of 8 bits under a common exponent; exponent 0 is black.
void set_texel(Image& image, std::uint32_t x, std::uint32_t y, const std::uint8_t* rgbe) {
    const double scale = rgbe[3] == 0 ? 0.0 : std::ldexp(1.0, rgbe[3] - 136);
    for (int c = 0; c < 3; ++c) image.set(x, y, c, rgbe[c] * scale);
    image.set(x, y, 3, 1.0);
}

}  // namespace

std::optional<Image> read_hdr(const ImageSource& source, Diags& diags) {
    Header header;
    if (const std::string reason = parse_header(source.bytes, header); !reason.empty()) {
        report_bad_image(source, fmt::format("damaged HDR ({})", reason), diags);
        return std::nullopt;
    }
    if (!check_image_size(source, header.width, header.height, diags)) return std::nullopt;
    const bool plausible = header.width * header.height <= source.bytes.size() * kMostTexelsPerByte;
    Image image = plausible ? make_image(static_cast<std::uint32_t>(header.width),
                                         static_cast<std::uint32_t>(header.height), TexelFormat::float32)
                            : Image{};
    LineReader reader(source.bytes, header.data);
    std::vector<std::uint8_t> line(4 * header.width);
    for (std::uint32_t y = 0; y < header.height; ++y) {
        if (!plausible || !reader.read(line)) {
            report_bad_image(source, fmt::format("damaged HDR (scan line {})", y), diags);
            return std::nullopt;
        }
        for (std::uint32_t x = 0; x < image.width; ++x) set_texel(image, x, y, &line[4 * x]);
    }
    return image;
}

}  // namespace sg::asset

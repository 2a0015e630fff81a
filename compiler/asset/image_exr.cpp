// EXR through tinyexr. Only single-part scan line files are taken, and their table of chunks is checked here
// before tinyexr decodes them: each block of lines must be present exactly once and lie inside the file.
#include <fmt/core.h>
#include <tinyexr.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>

#include "asset/image.hpp"
#include "asset/image_readers.hpp"
#include "base/ice.hpp"

namespace sg::asset {
namespace {

constexpr std::size_t kVersionSize = 8;                  // magic number and version
constexpr std::uint64_t kMostDecodedBytes = 1ull << 32;  // of all channels together
constexpr std::uint64_t kMostInflation = 1032;           // bytes that one byte of a deflate stream can become
constexpr std::size_t kLongestName = 31;                 // of a channel, without the "long names" flag

struct OwnedHeader {
    EXRHeader header;
    OwnedHeader() { InitEXRHeader(&header); }
    ~OwnedHeader() { FreeEXRHeader(&header); }
    OwnedHeader(const OwnedHeader&) = delete;
    OwnedHeader& operator=(const OwnedHeader&) = delete;
};

struct OwnedImage {
    EXRImage image;
    OwnedImage() { InitEXRImage(&image); }
    ~OwnedImage() { FreeEXRImage(&image); }
    OwnedImage(const OwnedImage&) = delete;
    OwnedImage& operator=(const OwnedImage&) = delete;
};

const unsigned char* data_of(const ImageSource& source) {
    return reinterpret_cast<const unsigned char*>(source.bytes.data());
}

// tinyexr's words, which then are freed.
std::string take_message(const char* message) {
    std::string text = message ? printable(message) : "no reason given";
    if (message) FreeEXRErrorMessage(message);
    return text;
}

template <class T>
T load(std::string_view bytes, std::uint64_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

std::int64_t lines_per_block(int compression) {
    if (compression == TINYEXR_COMPRESSIONTYPE_ZIP) return 16;
    return compression == TINYEXR_COMPRESSIONTYPE_PIZ ? 32 : 1;
}

// "" or what is wrong with the table of chunks.
std::string check_chunks(const ImageSource& source, const EXRHeader& header, std::int64_t height) {
    const std::int64_t lines = lines_per_block(header.compression_type);
    const auto blocks = static_cast<std::uint64_t>((height + lines - 1) / lines);
    const std::uint64_t size = source.bytes.size();
    const std::uint64_t table = kVersionSize + header.header_len;
    if (table > size || blocks * 8 > size - table) return "the table of chunks is cut off";
    if (header.chunk_count > 0 && static_cast<std::uint64_t>(header.chunk_count) != blocks)
        return fmt::format("{} chunks, expected {}", header.chunk_count, blocks);
    std::vector<bool> seen(blocks);
    for (std::uint64_t i = 0; i < blocks; ++i) {
        const auto at = load<std::uint64_t>(source.bytes, table + 8 * i);
        if (at < table || at > size || size - at < 8) return "a chunk lies outside the file";
        const auto length = load<std::int32_t>(source.bytes, at + 4);
        if (length <= 0 || static_cast<std::uint64_t>(length) > size - at - 8)
            return "a chunk lies outside the file";
        const std::int64_t line =
            std::int64_t{load<std::int32_t>(source.bytes, at)} - header.data_window.min_y;
        if (line < 0 || line >= height || line % lines != 0 || seen[static_cast<std::size_t>(line / lines)])
            return "a chunk has a wrong line number";
        seen[static_cast<std::size_t>(line / lines)] = true;
    }
    return "";
}

// "" or why the channels cannot be read.
std::string check_channels(const ImageSource& source, const EXRHeader& header, std::uint64_t texels) {
    if (header.num_channels <= 0) return "no channels";
    std::uint64_t texel_size = 0;
    for (int i = 0; i < header.num_channels; ++i) {
        const EXRChannelInfo& channel = header.channels[i];
        if (channel.x_sampling != 1 || channel.y_sampling != 1)
            return "subsampled channels, expected full ones";
        if (channel.pixel_type < 0 || channel.pixel_type > 2) return "a channel of an unknown type";
        texel_size += channel.pixel_type == TINYEXR_PIXELTYPE_HALF ? 2 : 4;
    }
    if (texels * 4 * static_cast<std::uint64_t>(header.num_channels) > kMostDecodedBytes)
        return fmt::format("{} channels are too many for its size", header.num_channels);
    if (header.compression_type < TINYEXR_COMPRESSIONTYPE_NONE ||
        header.compression_type > TINYEXR_COMPRESSIONTYPE_PIZ)
        return "unsupported compression, expected none, RLE, ZIPS, ZIP or PIZ";
    const bool deflated = header.compression_type != TINYEXR_COMPRESSIONTYPE_PIZ;
    if (deflated && texels * texel_size > source.bytes.size() * kMostInflation)
        return "too few bytes for its size";
    return "";
}

bool parse_header(const ImageSource& source, EXRHeader& header, Diags& diags) {
    EXRVersion version{};
    if (ParseEXRVersionFromMemory(&version, data_of(source), source.bytes.size()) != TINYEXR_SUCCESS) {
        report_bad_image(source, "damaged EXR (bad version)", diags);
        return false;
    }
    if (version.tiled || version.non_image || version.multipart) {
        report_bad_image(source, "a tiled, deep or multi-part EXR, expected scan lines in one part", diags);
        return false;
    }
    const char* message = nullptr;
    if (ParseEXRHeaderFromMemory(&header, &version, data_of(source), source.bytes.size(), &message) !=
        TINYEXR_SUCCESS) {
        report_bad_image(source, fmt::format("damaged EXR ({})", take_message(message)), diags);
        return false;
    }
    return true;
}

bool check_header(const ImageSource& source, const EXRHeader& header, Diags& diags) {
    const EXRBox2i& window = header.data_window;
    const std::int64_t width = std::int64_t{window.max_x} - window.min_x + 1;
    const std::int64_t height = std::int64_t{window.max_y} - window.min_y + 1;
    if (!check_image_size(source, static_cast<std::uint64_t>(std::max<std::int64_t>(width, 0)),
                          static_cast<std::uint64_t>(std::max<std::int64_t>(height, 0)), diags))
        return false;
    std::string reason = check_channels(source, header, static_cast<std::uint64_t>(width * height));
    if (reason.empty()) reason = check_chunks(source, header, height);
    if (!reason.empty()) report_bad_image(source, fmt::format("damaged or foreign EXR ({})", reason), diags);
    return reason.empty();
}

// Channel numbers of one layer by the last part of their names.
using Suffixes = std::map<std::string, int>;

// The file's channels in the order in which they fill rgba; one channel alone is grey.
std::vector<int> order_channels(const Suffixes& suffixes) {
    for (const std::string_view alphabet : {"RGBA", "XYZ", "UV"}) {
        if (!suffixes.count(std::string(1, alphabet[0]))) continue;
        std::vector<int> order;
        for (const char letter : alphabet) {
            const auto it = suffixes.find(std::string(1, letter));
            if (it == suffixes.end()) break;
            order.push_back(it->second);
        }
        return order;
    }
    const auto luminance = suffixes.find("Y");
    return {luminance != suffixes.end() ? luminance->second : suffixes.begin()->second};
}

double channel_value(const EXRHeader& header, const EXRImage& image, int channel, std::size_t texel) {
    const unsigned char* from = image.images[channel] + 4 * texel;
    if (header.pixel_types[channel] == TINYEXR_PIXELTYPE_UINT) {
        std::uint32_t number;
        std::memcpy(&number, from, sizeof number);
        return number;
    }
    float number;
    std::memcpy(&number, from, sizeof number);
    return static_cast<double>(number);
}

ExrLayer make_layer(const std::string& name, const Suffixes& suffixes, const EXRHeader& header,
                    const EXRImage& exr) {
    const std::vector<int> order = order_channels(suffixes);
    ExrLayer layer{name, static_cast<int>(order.size()),
                   make_image(static_cast<std::uint32_t>(exr.width), static_cast<std::uint32_t>(exr.height),
                              TexelFormat::float32)};
    for (std::uint32_t y = 0; y < layer.image.height; ++y) {
        for (std::uint32_t x = 0; x < layer.image.width; ++x) {
            const std::size_t texel = static_cast<std::size_t>(y) * layer.image.width + x;
            for (int c = 0; c < 4; ++c) {
                double value = c == 3 ? 1.0 : 0.0;
                if (c < layer.channels)
                    value = channel_value(header, exr, order[static_cast<std::size_t>(c)], texel);
                if (c < 3 && layer.channels == 1) value = channel_value(header, exr, order[0], texel);
                layer.image.set(x, y, c, value);
            }
        }
    }
    return layer;
}

std::map<std::string, Suffixes> group_channels(const EXRHeader& header) {
    std::map<std::string, Suffixes> layers;
    for (int i = 0; i < header.num_channels; ++i) {
        const std::string full = header.channels[i].name;
        const std::size_t dot = full.rfind('.');
        if (dot == std::string::npos)
            layers[""][full] = i;
        else
            layers[full.substr(0, dot)][full.substr(dot + 1)] = i;
    }
    return layers;
}

std::optional<std::vector<ExrLayer>> read_layers(const ImageSource& source, Diags& diags) {
    OwnedHeader owned;
    EXRHeader& header = owned.header;
    if (!parse_header(source, header, diags) || !check_header(source, header, diags)) return std::nullopt;
    for (int i = 0; i < header.num_channels; ++i)
        if (header.pixel_types[i] == TINYEXR_PIXELTYPE_HALF)
            header.requested_pixel_types[i] = TINYEXR_PIXELTYPE_FLOAT;
    OwnedImage exr;
    exr.image.num_channels = header.num_channels;  // tinyexr sets it last, but frees by it when it fails
    const char* message = nullptr;
    if (LoadEXRImageFromMemory(&exr.image, &header, data_of(source), source.bytes.size(), &message) !=
        TINYEXR_SUCCESS) {
        InitEXRImage(&exr.image);  // what it held has been freed, its pointers stayed
        report_bad_image(source, fmt::format("damaged EXR ({})", take_message(message)), diags);
        return std::nullopt;
    }
    std::vector<ExrLayer> layers;
    for (const auto& [name, suffixes] : group_channels(header))
        layers.push_back(make_layer(name, suffixes, header, exr.image));
    return layers;
}

// One channel of a layer as a plane of floats, under the name that it has in the file.
struct Plane {
    std::string name;
    std::vector<float> values;
};

Plane make_plane(const ExrLayer& layer, int channel) {
    Plane plane;
    plane.name = (layer.name.empty() ? "" : layer.name + ".") + "RGBA"[channel];
    SG_ASSERT(plane.name.size() <= kLongestName);
    plane.values.reserve(static_cast<std::size_t>(layer.image.width) * layer.image.height);
    for (std::uint32_t y = 0; y < layer.image.height; ++y)
        for (std::uint32_t x = 0; x < layer.image.width; ++x)
            plane.values.push_back(static_cast<float>(layer.image.at(x, y, channel)));
    return plane;
}

std::string encode(std::vector<Plane>& planes, const Image& size) {
    const std::size_t count = planes.size();
    std::vector<unsigned char*> pointers(count);
    std::vector<EXRChannelInfo> channels(count);
    std::vector<int> types(count, TINYEXR_PIXELTYPE_FLOAT);
    for (std::size_t i = 0; i < count; ++i) {
        pointers[i] = reinterpret_cast<unsigned char*>(planes[i].values.data());
        channels[i] = {};
        planes[i].name.copy(channels[i].name, kLongestName);
    }
    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = static_cast<int>(count);
    header.channels = channels.data();
    header.pixel_types = types.data();
    header.requested_pixel_types = types.data();
    header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
    EXRImage image;
    InitEXRImage(&image);
    image.num_channels = header.num_channels;
    image.images = pointers.data();
    image.width = static_cast<int>(size.width);
    image.height = static_cast<int>(size.height);
    unsigned char* memory = nullptr;
    const char* message = nullptr;
    const std::size_t length = SaveEXRImageToMemory(&image, &header, &memory, &message);
    SG_ASSERT(length > 0);
    std::string out(reinterpret_cast<const char*>(memory), length);
    std::free(memory);
    return out;
}

}  // namespace

std::optional<std::vector<ExrLayer>> read_exr_layers(std::string_view bytes, std::string_view name,
                                                     Diags& diags) {
    const Place nowhere;
    return read_layers(ImageSource{bytes, name, nowhere}, diags);
}

// Of several layers the unnamed one, else the first by name.
std::optional<Image> read_exr(const ImageSource& source, Diags& diags) {
    std::optional<std::vector<ExrLayer>> layers = read_layers(source, diags);
    if (!layers) return std::nullopt;
    return std::move(layers->front().image);
}

std::string exr_bytes(const std::vector<ExrLayer>& layers) {
    SG_ASSERT(!layers.empty());
    std::vector<Plane> planes;
    for (const ExrLayer& layer : layers) {
        SG_ASSERT(layer.image.width == layers[0].image.width && layer.image.height == layers[0].image.height);
        for (int c = 0; c < layer.channels; ++c) planes.push_back(make_plane(layer, c));
    }
    // The format wants its channels sorted by name.
    std::sort(planes.begin(), planes.end(), [](const Plane& a, const Plane& b) { return a.name < b.name; });
    return encode(planes, layers[0].image);
}

}  // namespace sg::asset

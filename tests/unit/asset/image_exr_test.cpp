// EXR: layers and their order, damaged files.
#include <gtest/gtest.h>

#include <cmath>

#include "asset/image.hpp"

namespace sg::asset {
namespace {

Image numbers(double offset) {
    Image image = make_image(33, 21, TexelFormat::float32);
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x)
            for (int c = 0; c < 4; ++c) image.set(x, y, c, offset + std::sin(x * 0.7 + y * 1.3 + c));
    return image;
}

std::vector<ExrLayer> sample_layers() {
    return {{"uv", 2, numbers(5)}, {"", 4, numbers(0)}, {"normal", 3, numbers(-9)}, {"id", 1, numbers(100)}};
}

std::optional<Image> read(std::string_view bytes, Diags& diags) {
    return read_image(bytes, "a.exr", Place{}, diags);
}

TEST(Exr, LayersRoundTripExactly) {
    const std::string bytes = exr_bytes(sample_layers());
    EXPECT_EQ(bytes, exr_bytes(sample_layers()));
    Diags diags;
    const auto layers = read_exr_layers(bytes, "a.exr", diags);
    ASSERT_TRUE(layers) << render(diags);
    ASSERT_EQ(layers->size(), 4u);
    for (const ExrLayer& expected : sample_layers()) {
        const auto found =
            std::find_if(layers->begin(), layers->end(), [&](auto& l) { return l.name == expected.name; });
        ASSERT_NE(found, layers->end()) << expected.name;
        EXPECT_EQ(found->channels, expected.channels);
        for (int c = 0; c < expected.channels; ++c)
            EXPECT_EQ(found->image.at(32, 20, c), expected.image.at(32, 20, c)) << expected.name << c;
    }
}

TEST(Exr, ChannelNamesAreSortedInTheFile) {
    const std::string bytes = exr_bytes(sample_layers());
    std::size_t last = 0;
    for (const std::string name :
         {"A", "B", "G", "R", "id.R", "normal.B", "normal.G", "normal.R", "uv.G", "uv.R"}) {
        const std::size_t at = bytes.find('\0' + name + '\0', last ? last : bytes.find("chlist"));
        ASSERT_NE(at, std::string::npos) << name;
        last = at;
    }
}

TEST(Exr, ReadImageTakesTheUnnamedLayerAndFillsGrey) {
    Diags diags;
    const auto image = read(exr_bytes(sample_layers()), diags);
    ASSERT_TRUE(image) << render(diags);
    EXPECT_EQ(image->bytes, numbers(0).bytes);
    const auto grey = read(exr_bytes({{"id", 1, numbers(100)}}), diags);
    ASSERT_TRUE(grey) << render(diags);
    EXPECT_EQ(grey->at(3, 4, 2), numbers(100).at(3, 4, 0));
    EXPECT_EQ(grey->at(3, 4, 3), 1.0);
}

TEST(Exr, EveryPrefixIsRefused) {
    const std::string bytes = exr_bytes(sample_layers());
    for (std::size_t length = 0; length < bytes.size(); length += length < 1200 ? 1 : 97) {
        Diags diags;
        EXPECT_FALSE(read(std::string_view(bytes).substr(0, length), diags)) << length;
        EXPECT_EQ(diags.error_count(), 1u);
    }
}

// A simple generator, so that each machine damages the same bytes.
struct Lcg {
    std::uint64_t state = 12345;
    std::uint32_t next() {
        return static_cast<std::uint32_t>((state = state * 6364136223846793005ull + 1442695040888963407ull) >>
                                          33);
    }
};

TEST(Exr, DamagedBytesGiveAValueOrOneError) {
    const std::string bytes = exr_bytes(sample_layers());
    Lcg random;
    for (int round = 0; round < 3000; ++round) {
        std::string damaged = bytes;
        const std::size_t span = round % 2 ? 600 : damaged.size();  // the header as often as the rest
        for (int k = 0; k < 3; ++k) damaged[random.next() % span] = static_cast<char>(random.next());
        Diags diags;
        const auto image = read(damaged, diags);
        EXPECT_EQ(diags.error_count(), image ? 0u : 1u);
    }
}

}  // namespace
}  // namespace sg::asset

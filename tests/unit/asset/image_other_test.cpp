// TGA, BMP and HDR: tiny files by hand, and the same files damaged.
#include <gtest/gtest.h>

#include "asset/image.hpp"

namespace sg::asset {
namespace {

std::string bytes_of(std::initializer_list<int> values) {
    std::string out;
    for (const int v : values) out.push_back(static_cast<char>(v));
    return out;
}

// 2 x 1 texels, (1, 2, 3) and (4, 5, 6); all three formats keep or encode blue first where they can.
std::string tga() {
    return bytes_of({0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 24, 0x20, 3, 2, 1, 6, 5, 4});
}

std::string bmp() {
    return "BM" + bytes_of({62, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0, 40, 0,
                            0,  0, 2, 0, 0, 0, 1, 0, 0,  0, 1, 0, 24, 0}) +
           std::string(24, '\0') + bytes_of({3, 2, 1, 6, 5, 4, 0, 0});
}

// Mantissas 128, 64, 0 with exponent 129: 1, 0.5, 0; then all zero.
std::string hdr() {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + bytes_of({128, 64, 0, 129, 0, 0, 0, 0});
}

std::optional<Image> read(std::string_view bytes, Diags& diags) {
    return read_image(bytes, "a", Place{}, diags);
}

TEST(OtherImages, TgaAndBmpGiveTheSameTexels) {
    for (const std::string& bytes : {tga(), bmp()}) {
        Diags diags;
        const auto image = read(bytes, diags);
        ASSERT_TRUE(image) << render(diags);
        EXPECT_EQ(image->format, TexelFormat::unorm8);
        EXPECT_EQ(image->bytes, (std::vector<std::uint8_t>{1, 2, 3, 255, 4, 5, 6, 255}));
    }
}

TEST(OtherImages, HdrGivesFloats) {
    Diags diags;
    const auto image = read(hdr(), diags);
    ASSERT_TRUE(image) << render(diags);
    EXPECT_EQ(image->format, TexelFormat::float32);
    EXPECT_EQ(image->at(0, 0, 0), 1.0);
    EXPECT_EQ(image->at(0, 0, 1), 0.5);
    EXPECT_EQ(image->at(1, 0, 0), 0.0);
    EXPECT_EQ(image->at(1, 0, 3), 1.0);
}

// Whether the file gave a value and no error, or one error and no value.
bool value_or_error(std::string_view bytes) {
    Diags diags;
    const bool value = read(bytes, diags).has_value();
    return diags.error_count() == (value ? 0u : 1u);
}

TEST(OtherImages, HdrRunsAreUnpacked) {
    const std::string runs = bytes_of({2, 2, 0, 8, 136, 128, 8, 1, 2, 3, 4, 5, 6, 7, 8, 136, 0, 136, 129});
    Diags diags;
    const auto image = read("#?RGBE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1\n\n-Y 2 +X 8\n" + runs + runs, diags);
    ASSERT_TRUE(image) << render(diags);
    EXPECT_EQ(image->at(0, 1, 0), 1.0);
    EXPECT_EQ(image->at(7, 1, 1), 8.0 / 128.0);
    EXPECT_EQ(image->at(7, 1, 2), 0.0);
    EXPECT_FALSE(read("#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 8\n" + runs, diags));
    EXPECT_EQ(diags.all().at(0).message, "cannot read 'a' as an image: damaged HDR (scan line 1)");
}

TEST(OtherImages, EveryDamagedByteGivesAValueOrOneError) {
    for (const std::string& bytes : {tga(), bmp(), hdr()}) {
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            for (const int value : {0, 1, 8, 16, 32, 127, 128, 255}) {
                std::string damaged = bytes;
                damaged[i] = static_cast<char>(value);
                EXPECT_TRUE(value_or_error(damaged)) << i << ' ' << value;
            }
            EXPECT_TRUE(value_or_error(std::string_view(bytes).substr(0, i))) << i;
        }
    }
}

TEST(OtherImages, AJpegWithTooManyCodesIsRefused) {
    const std::string frame = bytes_of({0xff, 0xd8, 0xff, 0xc0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0});
    const std::string table =
        bytes_of({0xff, 0xc4, 0xff, 0xff, 0x00}) + std::string(16, '\x40') + std::string(2000, '\1');
    Diags diags;
    EXPECT_FALSE(read(frame + table, diags));
    EXPECT_EQ(diags.all().at(0).message,
              "cannot read 'a' as an image: damaged JPEG (a Huffman table has more than 255 codes)");
}

}  // namespace
}  // namespace sg::asset

// Images: what each writer writes its reader reads, and what is damaged is refused with a whole sentence.
#include "asset/image.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sg::asset {
namespace {

Image gradient(std::uint32_t width, std::uint32_t height, TexelFormat format) {
    Image image = make_image(width, height, format);
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            for (int c = 0; c < 4; ++c)
                image.set(x, y, c, (x + 3.0 * y + 7.0 * c) / (width + 3.0 * height + 21.0));
    return image;
}

std::optional<Image> read(std::string_view bytes, Diags& diags) {
    return read_image(bytes, "a.png", Place{}, diags);
}

std::string only_message(const Diags& diags) {
    return diags.all().size() == 1 ? render(diags.all()[0]) : "not one message but " + render(diags);
}

TEST(Image, ClampsAndRoundsUnormTexels) {
    Image image = make_image(2, 1, TexelFormat::unorm8);
    image.set(1, 0, 0, 2.0);
    image.set(1, 0, 1, -1.0);
    image.set(1, 0, 2, 0.5);
    image.set(1, 0, 3, std::nan(""));
    EXPECT_EQ(image.bytes, (std::vector<std::uint8_t>{0, 0, 0, 0, 255, 0, 128, 0}));
}

TEST(Image, PngRoundTripsAt8And16Bits) {
    for (const TexelFormat format : {TexelFormat::unorm8, TexelFormat::unorm16}) {
        const Image image = gradient(37, 19, format);
        const std::string bytes = format == TexelFormat::unorm8 ? png_bytes(image) : png16_bytes(image);
        Diags diags;
        const auto back = read(bytes, diags);
        ASSERT_TRUE(back) << render(diags);
        EXPECT_EQ(back->width, 37u);
        EXPECT_EQ(back->format, format);
        EXPECT_EQ(back->bytes, image.bytes);
        EXPECT_FALSE(png_colors(bytes));
        EXPECT_EQ(bytes, format == TexelFormat::unorm8 ? png_bytes(image) : png16_bytes(image));
    }
}

TEST(Image, PfmRoundTripsWithTheUpperRowFirst) {
    const Image image = gradient(5, 4, TexelFormat::float32);
    Diags diags;
    const auto back = read(pfm_bytes(image), diags);
    ASSERT_TRUE(back) << render(diags);
    for (std::uint32_t y = 0; y < 4; ++y)
        for (std::uint32_t x = 0; x < 5; ++x)
            for (int c = 0; c < 3; ++c) EXPECT_EQ(back->at(x, y, c), image.at(x, y, c));
    EXPECT_EQ(back->at(4, 3, 3), 1.0);
}

TEST(Image, PfmReadsBothByteOrdersAndGrey) {
    const std::string little = std::string("Pf\n2 1\n-1.0\n") + std::string("\0\0\x80\x3f\0\0\0\x40", 8);
    const std::string big = std::string("Pf 2 1 1 ") + std::string("\x3f\x80\0\0\x40\0\0\0", 8);
    for (const std::string& bytes : {little, big}) {
        Diags diags;
        const auto image = read(bytes, diags);
        ASSERT_TRUE(image) << render(diags);
        EXPECT_EQ(image->at(0, 0, 0), 1.0);
        EXPECT_EQ(image->at(1, 0, 2), 2.0);
        EXPECT_EQ(image->at(1, 0, 3), 1.0);
    }
}

TEST(Image, RefusesDamagedFilesInWholeSentences) {
    const std::pair<std::string, std::string> cases[] = {
        {"", "error: cannot read 'a.png' as an image: the file is empty [SG2001]\n"},
        {"hello",
         "error: cannot read 'a.png' as an image: expected PNG, JPEG, EXR, PFM, HDR, TGA or BMP [SG2001]\n"},
        {"PF 2 x 1\n",
         "error: cannot read 'a.png' as an image: damaged PFM header, expected 'PF' or 'Pf', width, height "
         "and scale [SG2001]\n"},
        {"PF 2 2 -1\n1234",
         "error: cannot read 'a.png' as an image: damaged PFM (4 bytes of numbers, expected 48) [SG2001]\n"},
        {"PF 0 2 -1\n", "error: cannot read 'a.png' as an image: it has no texels [SG2001]\n"},
        {"PF 20000 2 -1\n",
         "error: 'a.png' is 20000 x 2 texels, expected at most 16384 per side [SG2002]\n"}};
    for (const auto& [bytes, expected] : cases) {
        Diags diags;
        EXPECT_FALSE(read(bytes, diags));
        EXPECT_EQ(only_message(diags), expected);
    }
}

TEST(Image, EveryPrefixOfAPngIsRefused) {
    const std::string bytes = png_bytes(gradient(9, 9, TexelFormat::unorm8));
    for (std::size_t length = 0; length + 12 < bytes.size(); ++length) {
        Diags diags;
        EXPECT_FALSE(read(std::string_view(bytes).substr(0, length), diags)) << length;
        EXPECT_EQ(diags.error_count(), 1u);
    }
}

TEST(Image, AFewBytesCannotAskForGigabytes) {
    std::string bytes = png_bytes(gradient(9, 9, TexelFormat::unorm8));
    bytes[18] = bytes[22] = 0x3f;  // width and height 0x3f09; the checksum of the header no longer fits
    Diags diags;
    EXPECT_FALSE(read(bytes, diags));
}

}  // namespace
}  // namespace sg::asset

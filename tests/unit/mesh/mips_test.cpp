// Mip chains: mean slopes survive, flat stays flat, colours average as light.
#include "runtime/mips.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>

namespace sg::runtime {
namespace {

using asset::Image;
using asset::make_image;
using asset::TexelFormat;
using Kind = MipRule::Kind;

double code_of(double value, double zero) {
    return (zero + value * (zero == 127.5 ? 127.5 : 127.0)) / 255.0;
}
double value_of(double texel, double zero) {
    return (255.0 * texel - zero) / (zero == 127.5 ? 127.5 : 127.0);
}

// A map whose texel (x, y) has slopes (a + b x, c + d y).
Image ramp(std::uint32_t width, std::uint32_t height, TexelFormat format, double zero, bool two_channels) {
    Image image = make_image(width, height, format);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const double sx = -0.5 + 1.5 * x / width, sy = 0.25 - 0.75 * y / height;
            const double length = std::sqrt(1 + sx * sx + sy * sy);
            image.set(x, y, 0, code_of(-sx / length, zero));
            image.set(x, y, 1, code_of(-sy / length, zero));
            image.set(x, y, 2, two_channels ? 0.0 : code_of(1 / length, zero));
            image.set(x, y, 3, 1.0);
        }
    }
    return image;
}

glm::dvec2 mean_slope(const Image& image, const MipRule& rule) {
    glm::dvec2 sum(0.0);
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const double nx = value_of(image.at(x, y, 0), rule.zero),
                         ny = value_of(image.at(x, y, 1), rule.zero);
            const double nz = rule.kind == Kind::slopes_xy ? std::sqrt(1 - nx * nx - ny * ny)
                                                           : value_of(image.at(x, y, 2), rule.zero);
            sum += glm::dvec2(-nx / nz, -ny / nz);
        }
    }
    return sum / (1.0 * image.width * image.height);
}

TEST(Mips, SizesHalveDownToOne) {
    const auto chain = mip_chain(make_image(37, 5, TexelFormat::unorm8), {});
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sizes;
    for (const Image& level : chain) sizes.emplace_back(level.width, level.height);
    EXPECT_EQ(sizes, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{
                         {37, 5}, {18, 2}, {9, 1}, {4, 1}, {2, 1}, {1, 1}}));
    EXPECT_EQ(mip_chain(make_image(1, 1, TexelFormat::unorm8), {}).size(), 1u);
}

TEST(Mips, MeanSlopesSurviveAllLevels) {
    for (const auto& [width, height] : {std::pair{64u, 32u}, {37u, 53u}, {1u, 33u}, {100u, 1u}, {3u, 3u}}) {
        for (const double zero : {127.0, 127.5, 128.0}) {
            for (const Kind kind : {Kind::slopes_xyz, Kind::slopes_xy}) {
                for (const TexelFormat format :
                     {TexelFormat::unorm8, TexelFormat::unorm16, TexelFormat::float32}) {
                    const MipRule rule{kind, false, zero};
                    const auto chain =
                        mip_chain(ramp(width, height, format, zero, kind == Kind::slopes_xy), rule);
                    const glm::dvec2 expected = mean_slope(chain[0], rule);
                    const double tolerance = format == TexelFormat::unorm8    ? 0.012
                                             : format == TexelFormat::unorm16 ? 5e-5
                                                                              : 1e-6;
                    for (const Image& level : chain) {
                        const glm::dvec2 found = mean_slope(level, rule);
                        EXPECT_NEAR(found.x, expected.x, tolerance)
                            << width << 'x' << height << " at " << level.width;
                        EXPECT_NEAR(found.y, expected.y, tolerance)
                            << width << 'x' << height << " at " << level.height;
                    }
                    EXPECT_EQ(chain[0].bytes,
                              ramp(width, height, format, zero, kind == Kind::slopes_xy).bytes);
                }
            }
        }
    }
}

TEST(Mips, FlatStaysFlat) {
    for (const auto& [zero, code, blue] :
         {std::tuple{127.0, 127, 254}, {127.5, 128, 255}, {127.5, 127, 255}, {128.0, 128, 255}}) {
        for (const Kind kind : {Kind::slopes_xyz, Kind::slopes_xy}) {
            Image image = make_image(13, 6, TexelFormat::unorm8);
            for (std::size_t i = 0; i < image.bytes.size(); i += 4) {
                image.bytes[i] = image.bytes[i + 1] = static_cast<std::uint8_t>(code);
                image.bytes[i + 2] = static_cast<std::uint8_t>(blue);
                image.bytes[i + 3] = 255;
            }
            for (const Image& level : mip_chain(image, {kind, false, zero}))
                for (std::size_t i = 0; i < level.bytes.size(); ++i)
                    ASSERT_EQ(level.bytes[i], image.bytes[i % 4])
                        << zero << ' ' << code << " at " << level.width;
        }
    }
}

// What normalising averaged vectors gets wrong: slopes 0 and 1 average to 1/2, not to tan(22.5 degrees).
TEST(Mips, AveragesSlopesNotVectors) {
    Image image = make_image(2, 1, TexelFormat::float32);
    const double diagonal = std::sqrt(0.5);
    for (int c = 0; c < 3; ++c) {
        image.set(0, 0, c, code_of(c == 2 ? 1.0 : 0.0, 127.5));
        image.set(1, 0, c, code_of(c == 1 ? 0.0 : c == 0 ? -diagonal : diagonal, 127.5));
    }
    const MipRule rule{Kind::slopes_xyz, false, 127.5};
    EXPECT_NEAR(mean_slope(mip_chain(image, rule)[1], rule).x, 0.5, 1e-6);
}

TEST(Mips, LyingAndMissingNormalsStayFinite) {
    Image image = make_image(2, 2, TexelFormat::float32);
    image.set(0, 0, 0, 1.0);                              // (1, -1, -1) after decoding
    image.set(1, 0, 0, std::nan(""));                     // not a number
    for (int c = 0; c < 3; ++c) image.set(0, 1, c, 0.5);  // (0, 0, 0)
    for (const Kind kind : {Kind::slopes_xyz, Kind::slopes_xy, Kind::color})
        for (const Image& level : mip_chain(image, {kind, false, 127.5}))
            for (int c = 0; c < 4 && level.width == 1; ++c) EXPECT_TRUE(std::isfinite(level.at(0, 0, c)));
}

TEST(Mips, ColoursAverageInLinearLight) {
    Image image = make_image(2, 1, TexelFormat::unorm8);
    for (int c = 0; c < 4; ++c) image.set(1, 0, c, 1.0);
    EXPECT_EQ(mip_chain(image, {Kind::color, true, 127.5})[1].bytes,
              (std::vector<std::uint8_t>{188, 188, 188, 128}));
    EXPECT_EQ(mip_chain(image, {Kind::color, false, 127.5})[1].bytes,
              (std::vector<std::uint8_t>{128, 128, 128, 128}));
}

TEST(Mips, OddSizesWeighByArea) {
    Image image = make_image(3, 1, TexelFormat::float32);
    for (std::uint32_t x = 0; x < 3; ++x) image.set(x, 0, 0, x == 1 ? 3.0 : 0.0);
    EXPECT_NEAR(mip_chain(image, {})[1].at(0, 0, 0), 1.0, 1e-7);
    image = make_image(5, 1, TexelFormat::float32);
    image.set(2, 0, 0, 5.0);  // shared half and half by two texels that cover 2.5 each
    EXPECT_NEAR(mip_chain(image, {})[1].at(0, 0, 0), 1.0, 1e-7);
    EXPECT_NEAR(mip_chain(image, {})[1].at(1, 0, 0), 1.0, 1e-7);
}

}  // namespace
}  // namespace sg::runtime

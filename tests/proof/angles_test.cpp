// Angles as numbers and as pictures.
#include "runtime/proof/angles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sg::proof {
namespace {

runtime::Picture picture(std::vector<glm::dvec4> pixels) {
    runtime::Picture out{
        asset::make_image(static_cast<std::uint32_t>(pixels.size()), 1, asset::TexelFormat::float32), {}};
    for (std::uint32_t x = 0; x < pixels.size(); ++x) {
        for (int c = 0; c < 4; ++c) out.values.set(x, 0, c, pixels[x][c]);
        out.coverage.push_back(pixels[x].w > 0 ? 1.0f : 0.0f);
    }
    return out;
}

TEST(Angles, BetweenTwoPictures) {
    const Angles angles =
        angles_between(picture({{0, 0, 1, 1}, {0, 0, 2, 1}, {0, 0, 0, 0}, {1, 0, 0, 1}, {1, 0, 0, 1}}),
                       picture({{0, 1, 1, 1}, {0, 0, 1, 1}, {0, 0, 0, 0}, {0, 0, 0, 0}, {NAN, 0, 0, 1}}));
    EXPECT_NEAR(angles.at(0, 0), 45, 1e-5);
    EXPECT_EQ(angles.at(1, 0), 0);
    EXPECT_TRUE(std::isnan(angles.at(2, 0)));
    EXPECT_EQ(angles.at(3, 0), 180);
    EXPECT_EQ(angles.at(4, 0), 180);
}

TEST(Angles, AsNumbers) {
    std::vector<double> degrees{NAN};
    for (int i = 100; i >= 0; --i) degrees.push_back(i);
    const Numbers n = numbers_of(degrees);
    EXPECT_EQ(n.median, 50);
    EXPECT_EQ(n.p95, 95);
    EXPECT_EQ(n.p99, 99);
    EXPECT_EQ(n.max, 100);
    EXPECT_EQ(n.count, 101u);
    EXPECT_EQ(text_of(n), "median 50  p95 95  p99 99  max 100 degrees, 101 pixels");
    EXPECT_EQ(text_of(numbers_of({})), "median 0  p95 0  p99 0  max 0 degrees, 0 pixels");
}

TEST(Angles, ScalesAreRound) {
    EXPECT_EQ(round_scale(0), 0.01);
    EXPECT_EQ(round_scale(0.011), 0.02);
    EXPECT_EQ(round_scale(0.2), 0.2);
    EXPECT_EQ(round_scale(3), 5);
    EXPECT_EQ(round_scale(49), 50);
    EXPECT_EQ(round_scale(51), 90);
    EXPECT_EQ(round_scale(91), 180);
}

TEST(Angles, AsAMapThatGetsLighter) {
    Angles angles(100, 2);
    for (std::uint32_t x = 0; x < 90; ++x) angles.at(x, 0) = x * 0.1;
    const asset::Image map = angle_map(angles, 5);
    EXPECT_EQ(map.width, 100u);
    EXPECT_EQ(map.height, 24u);  // with the scale
    double before = -1;
    for (std::uint32_t x = 0; x < 100; ++x) {
        EXPECT_EQ(map.at(x, 0, 3), x < 90 ? 1 : 0);
        const double light = 0.3 * map.at(x, 0, 0) + 0.6 * map.at(x, 0, 1) + 0.1 * map.at(x, 0, 2);
        if (x < 90) {
            EXPECT_TRUE(x <= 50 ? light > before : light == before) << x;
            before = light;
        }
        EXPECT_EQ(map.at(x, 12, 3), 1);
    }
    EXPECT_EQ(angle_map(Angles(40, 2), 5).height, 2u);
}

}  // namespace
}  // namespace sg::proof

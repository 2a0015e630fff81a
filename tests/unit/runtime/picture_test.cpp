// Cameras, blocks and what turns numbers into pictures, without a device.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/blocks.hpp"
#include "runtime/output.hpp"

namespace sg::runtime {
namespace {

Bounds unit_bounds() {
    return {glm::dvec3(-1), glm::dvec3(1), glm::dvec3(0), std::sqrt(3.0)};
}

glm::dvec3 screen(const CameraMatrices& m, const Camera& camera, const glm::dvec3& world) {
    glm::dvec4 clip = m.clip_from_relative * glm::dvec4(world - camera.position, 1);
    return glm::dvec3(clip) / clip.w;
}

TEST(Camera, RightIsRightUpIsUpNearIsNear) {
    for (double ortho : {0.0, 4.0}) {
        Camera camera{{0, 0, 6}, {0, 0, 0}, 30, ortho};
        CameraMatrices m = camera_matrices(camera, unit_bounds(), 200, 100);
        EXPECT_NEAR(glm::length(glm::dvec2(screen(m, camera, {0, 0, 0}))), 0, 1e-15);
        EXPECT_GT(screen(m, camera, {1, 0, 0}).x, 0);
        EXPECT_LT(screen(m, camera, {0, 1, 0}).y, 0) << "Vulkan's y points down";
        double front = screen(m, camera, {0, 0, 1}).z, back = screen(m, camera, {0, 0, -1}).z;
        EXPECT_LT(0, front);
        EXPECT_LT(front, back);
        EXPECT_LT(back, 1);
        EXPECT_NEAR(screen(m, camera, {0.5, 0, 0}).x * 2, -screen(m, camera, {0, 0.5, 0}).y, 1e-12)
            << "aspect";
    }
}

TEST(Camera, LooksStraightDownWithoutFalling) {
    Camera camera{{0, 5, 0}, {0, 0, 0}};
    CameraMatrices m = camera_matrices(camera, unit_bounds(), 100, 100);
    EXPECT_LT(screen(m, camera, {0, 0, -1}).y, 0) << "-Z is at the upper edge";
    EXPECT_GT(screen(m, camera, {1, 0, 0}).x, 0);
}

TEST(Camera, TheDefaultOneHoldsTheBounds) {
    for (double aspect : {0.3, 1.0, 2.5}) {
        Camera camera = default_camera(unit_bounds(), aspect);
        CameraMatrices m = camera_matrices(camera, unit_bounds(), 1000 * aspect, 1000);
        for (int corner = 0; corner < 8; ++corner) {
            glm::dvec3 p(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            glm::dvec3 s = screen(m, camera, p);
            EXPECT_LE(std::max(std::abs(s.x), std::abs(s.y)), 1.0);
        }
    }
}

TEST(Blocks, NormalsStayPerpendicularUnderSkewAndMirror) {
    glm::mat4 world(glm::vec4(1, 0.5f, 0, 0), glm::vec4(0.25f, 2, 0, 0), glm::vec4(0, 0.3f, -0.5f, 0),
                    glm::vec4(7, 8, 9, 1));
    ObjectBlock block = object_block(Camera{{1, 2, 3}, {0, 0, 0}}, world);
    EXPECT_TRUE(is_mirrored(world));
    EXPECT_EQ(block.normal_from_object[3][3], -1);
    EXPECT_EQ(block.relative_from_object[3], glm::vec4(6, 6, 6, 1));
    glm::vec3 n(1, 2, 3), along(3, 0, -1);  // perpendicular
    glm::vec3 new_n = glm::mat3(block.normal_from_object) * n, new_along = glm::mat3(world) * along;
    EXPECT_NEAR(glm::dot(new_n, new_along), 0, 1e-5);
    EXPECT_GT(glm::dot(new_n, glm::mat3(world) * n), 0) << "it must stay on its side";
}

// By hand: the inverse transpose of a shear with a scale; cofactors where there is none; what a float can
// square.
TEST(Blocks, TheNormalMatrixIsTheInverseTranspose) {
    auto matrix = [](glm::vec3 x, glm::vec3 y, glm::vec3 z) {
        const glm::mat4 world(glm::vec4(x, 0), glm::vec4(y, 0), glm::vec4(z, 0), glm::vec4(0, 0, 0, 1));
        return glm::mat3(object_block(Camera{{1, 2, 3}, {0, 0, 0}}, world).normal_from_object);
    };
    EXPECT_EQ(matrix({2, 0, 0}, {1, 4, 0}, {0, 0, -0.5f}),
              glm::mat3(0.5f, -0.125f, 0, 0, 0.25f, 0, 0, 0, -2));
    EXPECT_EQ(matrix({3, 0, 0}, {0, 2, 0}, {0, 0, 0}), glm::mat3(0, 0, 0, 0, 0, 0, 0, 0, 6)) << "flattened";
    EXPECT_EQ(matrix({1, 0, 0}, {0, -1, 0}, {0, 0, 1e-20f})[2], glm::vec3(0, 0, 1)) << "nearly flattened";
    EXPECT_EQ(matrix({0, 0, 0}, {0, 0, 0}, {0, 0, 0}), glm::mat3(0)) << "gone";
}

TEST(ToneCurve, RisesFromBlackToWhite) {
    EXPECT_EQ(tone_curve(0), 0);
    EXPECT_EQ(tone_curve(-1), 0);
    EXPECT_EQ(tone_curve(std::numeric_limits<double>::quiet_NaN()), 0);
    EXPECT_EQ(tone_curve(std::numeric_limits<double>::infinity()), 1);
    EXPECT_NEAR(tone_curve(1), 2.54 / 3.16, 1e-12);
    for (double x = 0; x < 20; x += 0.01) EXPECT_LE(tone_curve(x), tone_curve(x + 0.01));
    EXPECT_NEAR(srgb_encode(0.0031308), 12.92 * 0.0031308, 1e-6);
    EXPECT_NEAR(srgb_encode(1), 1, 1e-12);
    EXPECT_NEAR(srgb_encode(0.2140411), 0.5, 1e-6);
}

// Two pixels: a drawn one with the given value, and background.
Picture two_pixels(const glm::dvec4& value) {
    Picture picture{asset::make_image(2, 1, asset::TexelFormat::float32), {1, 0}};
    for (int c = 0; c < 4; ++c) picture.values.set(0, 0, c, value[c]);
    return picture;
}

TEST(Display, MapsEachKindAsDocumented) {
    auto shown = [](const glm::dvec4& value, DebugView view) {
        asset::Image image = values_to_display(two_pixels(value), view, {unit_bounds(), {0, 0, 4}});
        EXPECT_EQ(image.at(1, 0, 3), 0);
        EXPECT_EQ(image.at(0, 0, 3), 1);
        return glm::ivec3(std::lround(image.at(0, 0, 0) * 255), std::lround(image.at(0, 0, 1) * 255),
                          std::lround(image.at(0, 0, 2) * 255));
    };
    EXPECT_EQ(shown({0, 1, -1, 1}, {"normal", 0, 3, ViewKind::direction}), glm::ivec3(128, 255, 0));
    EXPECT_EQ(shown({1, 0.2, -5, 1}, {"position", 0, 3, ViewKind::position}), glm::ivec3(255, 153, 0));
    EXPECT_EQ(shown({2.6, -0.2, 9, 1}, {"uv0", 0, 2, ViewKind::uv}), glm::ivec3(153, 204, 0));
    EXPECT_EQ(shown({-2, 1, 0, 1}, {"gradient", 0, 3, ViewKind::vector}), glm::ivec3(0, 191, 128));
}

TEST(Display, LitPicturesAreOpaqueOverGrey) {
    asset::Image image = lit_to_display(two_pixels({1, 0, 0, 1}), 0);
    EXPECT_NEAR(image.at(0, 0, 0), srgb_encode(2.54 / 3.16), 0.003);
    EXPECT_EQ(image.at(0, 0, 1), 0);
    EXPECT_EQ(image.at(1, 0, 3), 1);
    EXPECT_EQ(image.at(1, 0, 0), image.at(1, 0, 2));
    EXPECT_GT(image.at(1, 0, 0), 0.1);
}

TEST(Output, FourComponentViewsKeepTheirAlpha) {
    std::string bytes = picture_bytes(two_pixels({1, 2, 3, 4}), {"uv0-derivatives", 0, 4, ViewKind::vector},
                                      PictureFormat::exr, {});
    Diags diags;
    auto layers = asset::read_exr_layers(bytes, "x.exr", diags);
    ASSERT_TRUE(layers) << render(diags);
    ASSERT_EQ(layers->size(), 2u);
    for (const asset::ExrLayer& layer : *layers) {
        bool raw = layer.name.empty();
        EXPECT_EQ(layer.name, raw ? "" : "coverage");
        EXPECT_EQ(layer.image.at(0, 0, raw ? 3 : 0), raw ? 4 : 1);
    }
}

TEST(Shrink, AveragesOverWhatIsDrawn) {
    Picture picture{asset::make_image(2, 2, asset::TexelFormat::float32), {1, 0, 1, 0}};
    for (std::uint32_t y = 0; y < 2; ++y) {
        picture.values.set(0, y, 0, 2.0 + y);
        picture.values.set(0, y, 3, 1);
        picture.values.set(1, y, 0, 100);  // not drawn: must not count
    }
    Picture small = shrink(picture, 2, false);
    EXPECT_EQ(small.values.at(0, 0, 0), 2.5);
    EXPECT_EQ(small.values.at(0, 0, 3), 0.5);
    EXPECT_EQ(small.coverage, std::vector<float>{0.5f});
    EXPECT_EQ(shrink(picture, 2, true).values.at(0, 0, 3), 1);
}

}  // namespace
}  // namespace sg::runtime

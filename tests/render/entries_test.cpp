// The entry points beside forward, normal and debug: what a G-buffer holds is what the others show, and a
// depth pass covers the same pixels.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/mesh/shapes.hpp"
#include "tests/render/workshop.hpp"

namespace sg::truth {
namespace {

constexpr std::uint32_t kSide = 96;

runtime::Scene sphere_scene() {
    runtime::Scene scene;
    scene.content.meshes.push_back(*runtime::make_shape("sphere"));
    scene.content.instances.push_back({"sphere", 0});
    scene.camera = runtime::default_camera(runtime::bounds_of(scene.content), 1);
    return scene;
}

// `alpha`: what the surface says of opacity and its test.
Made made_of(const std::string& alpha) {
    const std::string json = R"({ "version": 1,
  "textures": { "moss": { "file": "textures/moss_mask.png", "encoding": "mask" },
                "brick": { "file": "textures/brick_normal.png", "encoding": "tangent_normal" } },
  "bump": [ { "layers": [ { "kind": "normal_map", "texture": "brick", "tiling": [4, 2] } ] } ],
  "surface": { "base_color": [0.25, 0.5, 0.75], "metallic": 0.125, "roughness": 0.375, "occlusion": 0.875,
               "emission": [2, 3, 4])" +
                             alpha + " } }";
    return make({json, sample_files(), {"gbuffer", "normal", "depth"}, true});
}

double alpha_at(const runtime::Picture& picture, std::uint32_t x, std::uint32_t y) {
    return picture.values.at(x, y, 3);
}

TEST(EntryPoints, TheGBufferHoldsWhatTheMaterialSays) {
    const Made made = made_of("");
    const runtime::Scene scene = sphere_scene();
    auto view = [&](const char* name) { return draw(made, scene, name, kSide, kSide); };
    const runtime::Picture color = view("gbuffer:base_color"), normal = view("gbuffer:normal"),
                           surface = view("gbuffer:surface"), emission = view("gbuffer:emission"),
                           expected = view("normal");
    std::size_t pixels = 0;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            ASSERT_EQ(covered(normal, x, y), covered(expected, x, y));
            if (!covered(normal, x, y)) continue;
            ++pixels;
            // The same expressions, compiled beside others: some units in the last place.
            ASSERT_LE(glm::length(rgb(normal, x, y) - rgb(expected, x, y)), 1e-6);
            ASSERT_EQ(alpha_at(normal, x, y), 0.375);
            ASSERT_EQ(rgb(color, x, y), glm::dvec3(0.25, 0.5, 0.75));
            ASSERT_EQ(alpha_at(color, x, y), 1.0);
            ASSERT_EQ(rgb(surface, x, y), glm::dvec3(0.125, 0.875, 0));
            ASSERT_EQ(rgb(emission, x, y), glm::dvec3(2, 3, 4));
        }
    }
    EXPECT_GT(pixels, kSide * kSide / 4);
    EXPECT_EQ(validation_messages(), std::vector<std::string>{});
}

TEST(EntryPoints, ADepthPassDropsWhatTheOthersDrop) {
    const runtime::Scene scene = sphere_scene();
    auto covered_pixels = [&](const Made& made, const char* name) {
        return draw(made, scene, name, kSide, kSide).coverage;
    };
    const Made whole = made_of(""),
               holed = made_of(
                   R"(, "opacity": { "texture": "moss", "channel": "r", "tiling": 3 }, "alpha_test": 0.5)");
    EXPECT_EQ(covered_pixels(whole, "depth"), covered_pixels(whole, "normal"));
    EXPECT_EQ(covered_pixels(holed, "depth"), covered_pixels(holed, "normal"));
    EXPECT_EQ(covered_pixels(holed, "depth"), covered_pixels(holed, "gbuffer:base_color"));
    EXPECT_NE(covered_pixels(holed, "depth"), covered_pixels(whole, "depth"));
    EXPECT_EQ(validation_messages(), std::vector<std::string>{});
}

}  // namespace
}  // namespace sg::truth

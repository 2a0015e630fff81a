// The entry point `forward` against the lighting models in double precision: normals, positions and the
// surface's inputs are what the other entry points show.
#include <gtest/gtest.h>

#include <fmt/core.h>

#include "ir/reference/lighting.hpp"
#include "runtime/mesh/shapes.hpp"
#include "tests/render/workshop.hpp"

namespace sg::truth {
namespace {

constexpr std::uint32_t kSide = 96;
constexpr double kUlp = 1.0 / (1 << 24);

runtime::Scene blob_scene() {
    runtime::Scene scene;
    scene.content.meshes.push_back(*runtime::make_shape("rock"));
    scene.content.instances.push_back({"rock", 0});
    scene.camera = runtime::default_camera(runtime::bounds_of(scene.content), 1);
    scene.light = {{-0.5, 0.8, 0.6}, {1.1, 0.9, 0.7}, {0.09, 0.1, 0.2}};
    return scene;
}

// What a pixel's radiance is made of, as the views show it.
struct Pixel {
    glm::dvec3 n, base_color;
    double metallic = 0, roughness = 0, occlusion = 0;
    glm::dvec3 emission;
    ref::Lights lights;
};

struct Views {
    runtime::Picture lit, normal, position, base_color, surface, emission;
};
Views views_of(const Made& made, const runtime::Scene& scene) {
    auto view = [&](const char* name) { return draw(made, scene, name, kSide, kSide); };
    return {view("lit"),
            view("gbuffer:normal"),
            view("position"),
            view("gbuffer:base_color"),
            view("gbuffer:surface"),
            view("gbuffer:emission")};
}

// The largest difference between the picture and `expected`, over the pixels of the surface.
double largest_difference(const Recipe& recipe, glm::dvec3 (*expected)(const Pixel&)) {
    const runtime::Scene scene = blob_scene();
    const Views v = views_of(make(recipe), scene);
    double largest = 0;
    std::size_t pixels = 0;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            if (!covered(v.lit, x, y)) continue;
            ++pixels;
            const glm::dvec3 surface = rgb(v.surface, x, y);
            const Pixel pixel{rgb(v.normal, x, y),
                              rgb(v.base_color, x, y),
                              surface.x,
                              v.normal.values.at(x, y, 3),
                              surface.y,
                              rgb(v.emission, x, y),
                              {-glm::normalize(rgb(v.position, x, y)), glm::normalize(scene.light.direction),
                               scene.light.radiance, scene.light.ambient}};
            const glm::dvec3 off = glm::abs(rgb(v.lit, x, y) - expected(pixel));
            largest = std::max({largest, off.x, off.y, off.z});
        }
    }
    EXPECT_GT(pixels, kSide * kSide / 4);
    show(v.lit, "lighting");
    return largest;
}

Recipe workshop() {
    std::map<std::string, std::string> files = sample_files();
    std::string json = files.at("workshop_phong.json");
    return {json, std::move(files), {"forward", "gbuffer", "debug"}, true};
}

// The workshop's exponent is 8, and the colour map tints its highlight.
glm::dvec3 phong(const Pixel& p) {
    return ref::phong_radiance({p.base_color, p.base_color, 8, p.occlusion, p.emission}, p.n, p.lights);
}

// 44 roundings (tests/shader_lib/prove_lighting.cpp) times 1 + shininess, of light up to 1.1; normal,
// position and colour come from other shaders, whose normals differ by 1e-6 (entries_test.cpp), which the
// exponent multiplies.
constexpr double kPhongBound = 1.1 * 9 * (44 * kUlp + 1e-6);

TEST(Lighting, PhongIsTheWorkshops) {
    const double largest = largest_difference(workshop(), phong);
    fmt::print("  largest difference {:.2e}, bound {:.2e}\n", largest, kPhongBound);
    EXPECT_LE(largest, kPhongBound);
    EXPECT_EQ(validation_messages(), std::vector<std::string>{});
}

// Its g-buffer holds the GGX highlight of the same width: (2 * 8 + 1)^(-1/4).
TEST(Lighting, PhongIsNoMetalAndAsRoughAsItsHighlightIsWide) {
    const Made made = make(workshop());
    const Views v = views_of(made, blob_scene());
    ASSERT_TRUE(covered(v.normal, kSide / 2, kSide / 2) || covered(v.lit, kSide / 2, kSide / 2));
    EXPECT_NEAR(v.normal.values.at(kSide / 2, kSide / 2, 3), 0.49247, 1e-5);
    EXPECT_EQ(rgb(v.surface, kSide / 2, kSide / 2), glm::dvec3(0, 1, 0));
}

TEST(Lighting, GgxIsTheModels) {
    const Recipe recipe{R"({ "version": 1,
  "textures": { "brick": { "file": "textures/brick_normal.png", "encoding": "tangent_normal" } },
  "bump": [ { "layers": [ { "kind": "normal_map", "texture": "brick", "tiling": [4, 2] } ] } ],
  "surface": { "base_color": [0.25, 0.5, 0.75], "metallic": 0.125, "roughness": 0.375, "occlusion": 0.875,
               "emission": [0.2, 0.3, 0.1] } })",
                        sample_files(),
                        {"forward", "gbuffer", "debug"},
                        true};
    const double largest = largest_difference(recipe, [](const Pixel& p) {
        return ref::ggx_radiance({p.base_color, p.metallic, p.roughness, p.occlusion, p.emission}, p.n,
                                 p.lights);
    });
    // alpha 0.14: the lobe is at most 1 / alpha^2 = 51 / 4 as bright as a mirror's share of 0.15, and a
    // direction that is off by 1e-6 moves it by 2 / alpha of that.
    const double bound = 1.1 * 51.0 / 4 * 0.15 * (2 / 0.14) * (1e-6 + 20 * kUlp);
    fmt::print("  largest difference {:.2e}, bound {:.2e}\n", largest, bound);
    EXPECT_LE(largest, bound);
}

// Each would be another picture.
TEST(Lighting, AnotherModelIsNoticed) {
    auto half_shiny = [](const Pixel& p) {
        return ref::phong_radiance({p.base_color, p.base_color, 7, p.occlusion, p.emission}, p.n, p.lights);
    };
    auto white = [](const Pixel& p) {
        return ref::phong_radiance({p.base_color, glm::dvec3(1), 8, p.occlusion, p.emission}, p.n, p.lights);
    };
    auto ggx = [](const Pixel& p) {
        return ref::ggx_radiance({p.base_color, p.metallic, p.roughness, p.occlusion, p.emission}, p.n,
                                 p.lights);
    };
    for (glm::dvec3 (*wrong)(const Pixel&) : {+half_shiny, +white, +ggx})
        EXPECT_GT(largest_difference(workshop(), wrong), 100 * kPhongBound);
}

}  // namespace
}  // namespace sg::truth

// Every sample of materials/: the optimisers change nothing that can be seen, nor does the order of layers,
// and the validation layers have nothing to say.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "runtime/mesh/shapes.hpp"
#include "tests/render/workshop.hpp"

namespace sg::truth {
namespace {

constexpr std::uint32_t kSide = 128;

const std::map<std::string, std::string>& files() {
    static const std::map<std::string, std::string> kFiles = sample_files();
    return kFiles;
}

// Materials alone; the textures' folder may hold other JSON.
std::vector<std::string> sample_names() {
    std::vector<std::string> out;
    for (const auto& [path, bytes] : files()) {
        if (path.ends_with(".json") && path.find('/') == std::string::npos) out.push_back(path);
    }
    return out;
}

runtime::Scene torus_scene() {
    runtime::Scene scene;
    scene.content.meshes.push_back(*runtime::make_shape("torus"));
    scene.content.instances.push_back({"torus", 0});
    scene.camera = runtime::default_camera(runtime::bounds_of(scene.content), 1);
    return scene;
}

// Of one component: absolute up to 1, relative above, as a highlight's radiance has no upper limit.
double largest_difference(const runtime::Picture& a, const runtime::Picture& b) {
    double largest = 0;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            if (covered(a, x, y) != covered(b, x, y)) return INFINITY;
            const glm::dvec3 d =
                glm::abs(rgb(a, x, y) - rgb(b, x, y)) / glm::max(glm::abs(rgb(a, x, y)), glm::dvec3(1));
            if (!(d.x + d.y + d.z < INFINITY)) return INFINITY;
            largest = std::max({largest, d.x, d.y, d.z});
        }
    }
    return largest;
}

std::size_t covered_count(const runtime::Picture& picture) {
    return static_cast<std::size_t>(std::count(picture.coverage.begin(), picture.coverage.end(), 1.0f));
}

// What reordered roundings may do: some tens of them in gradients. The sharpest highlight, water's of alpha =
// 0.15^2, changes by up to 2 / alpha = 90 times what its normal turns by, which is about 1e-7.
constexpr double kAlike = 1e-5;

// One view by both: whether they differ by no more than the roundings do.
void expect_alike(const std::string& name, const Made& plain, const Made& optimised,
                  const runtime::Scene& scene, const std::string& view) {
    const runtime::Picture a = draw(plain, scene, view, kSide, kSide),
                           b = draw(optimised, scene, view, kSide, kSide);
    EXPECT_GT(covered_count(a), kSide * kSide / 5) << view;
    const double difference = largest_difference(a, b);
    fmt::print("{} {}: optimised and plain differ by {:.2e}\n", name, view, difference);
    EXPECT_LE(difference, kAlike) << view;
    if (view == "lit") show(b, name + ".lit");
}

class Samples : public testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] Recipe recipe(bool optimise = true) const {
        return {files().at(GetParam()), files(), {"forward", "normal", "debug"}, optimise};
    }
};

TEST_P(Samples, RenderAlikeOptimisedAndNot) {
    const Made plain = make(recipe(false)), optimised = make(recipe(true));
    const runtime::Scene scene = torus_scene();
    for (const char* view : {"normal", "lit", "gradient"})
        expect_alike(GetParam(), plain, optimised, scene, view);
    EXPECT_EQ(validation_messages(), std::vector<std::string>{});
}

TEST_P(Samples, EveryDebugViewDrawsFiniteNumbers) {
    const Made made = make(recipe());
    const runtime::Scene scene = torus_scene();
    for (const runtime::View& view : runtime::all_views(made.artefact)) {
        const runtime::Picture picture = draw(made, scene, view.view.name, kSide, kSide);
        EXPECT_LT(largest_difference(picture, picture), 1e-30) << view.view.name;
    }
    EXPECT_EQ(validation_messages(), std::vector<std::string>{});
}

// The views of its layers, drawn alone, add up to the sum that is resolved.
TEST(Layers, AddUpToTheGradient) {
    const Made made = make({files().at("layered.json"), files(), {"debug"}});
    const runtime::Scene scene = torus_scene();
    const runtime::Picture sum = draw(made, scene, "gradient", kSide, kSide);
    std::vector<runtime::Picture> layers;
    for (const char* id : {"ramps", "pebbles", "grain", "scratches"})
        layers.push_back(draw(made, scene, std::string("layer:") + id, kSide, kSide));
    double largest = 0, smallest_layer = INFINITY;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            if (!covered(sum, x, y)) continue;
            glm::dvec3 added(0);
            for (const runtime::Picture& layer : layers) added += glm::dvec3(rgb(layer, x, y));
            largest = std::max(largest, glm::distance(added, glm::dvec3(rgb(sum, x, y))));
        }
    }
    for (const runtime::Picture& layer : layers) {
        double steepest = 0;
        for (std::uint32_t i = 0; i < kSide * kSide; ++i)
            steepest = std::max(steepest, glm::length(glm::dvec3(rgb(layer, i % kSide, i / kSide))));
        smallest_layer = std::min(smallest_layer, steepest);
    }
    EXPECT_LE(largest, 1e-5);  // roundings of gradients up to 8
    EXPECT_GT(smallest_layer, 0.05) << "a layer without a bump shows nothing";
}

// Surface gradients add: the order of layers is that of a sum of floats, a few units in the last place.
// Layers that mix cover what lies before them, so that their order means something.
TEST_P(Samples, OrderOfLayersDoesNotMatter) {
    nlohmann::json material = nlohmann::json::parse(files().at(GetParam()));
    if (material.contains("extends")) GTEST_SKIP() << GetParam() << " has the layers of its base";
    if (files().at(GetParam()).find("\"blend\": \"mix\"") != std::string::npos) {
        GTEST_SKIP() << GetParam() << " mixes layers, which has an order";
    }
    for (auto& stage : material["bump"]) std::reverse(stage["layers"].begin(), stage["layers"].end());
    Recipe reversed = recipe();
    reversed.json = material.dump();
    const runtime::Scene scene = torus_scene();
    const double difference = largest_difference(draw(make(recipe()), scene, "normal", kSide, kSide),
                                                 draw(make(reversed), scene, "normal", kSide, kSide));
    fmt::print("{}: layers reversed differ by {:.2e}\n", GetParam(), difference);
    EXPECT_LE(difference, 1e-6);
}

std::string test_name(const testing::TestParamInfo<std::string>& row) {
    const std::size_t slash = row.param.rfind('/') + 1;
    std::string name = row.param.substr(slash, row.param.find('.') - slash);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Materials, Samples, testing::ValuesIn(sample_names()), test_name);

class PaperFigures : public testing::TestWithParam<std::string> {};

TEST_P(PaperFigures, RenderAlikeOptimisedAndNot) {
    auto made = [](bool optimise) { return make({files().at(GetParam()), files(), {"normal"}, optimise}); };
    expect_alike(GetParam(), made(false), made(true), torus_scene(), "normal");
    EXPECT_EQ(validation_messages(), std::vector<std::string>{});
}

INSTANTIATE_TEST_SUITE_P(Materials, PaperFigures, testing::ValuesIn(figure_materials()), test_name);

}  // namespace
}  // namespace sg::truth

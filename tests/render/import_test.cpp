// The Khronos sample TextureTransformMultiTest, imported: each kind of texture on a square whose coordinates
// KHR_texture_transform turns by a quarter, shrinks and moves, on uv 0 and on uv 1, beside a square that has
// the coordinates so from the start. Seen: the same half arrow on all three; with the rotation turned
// the other way round, a part of the ring. The model's transforms miss the coordinates of the third
// square by 3 texels of 512 in t (0.2191 against 0.2251), so that is shown from a little aside.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "import/gltf_import.hpp"
#include "tests/render/workshop.hpp"

namespace sg::truth {
namespace {

const char* const kModel =
    SG_SOURCE_DIR "/../shared/data/gltf/khronos/TextureTransformMultiTest/TextureTransformMultiTest.gltf";
constexpr std::uint32_t kSide = 96;
constexpr double kShown = 0.17;  // world units; the squares have 0.2
// Of the third square 0.2182 units of t are 0.2 units along -x.
constexpr double kAside = (0.2250512 - 0.2190511) / 0.2182 * 0.2;

class TextureTransforms : public testing::Test {
protected:
    void SetUp() override {
        RealFiles files;
        if (!files.exists(kModel)) GTEST_SKIP() << "the shared test data is not here: " << kModel;
        Diags diags;
        auto content = asset::read_gltf(files, kModel, diags);
        auto imported = import::import_gltf(files, kModel, diags);
        ASSERT_TRUE(content && imported) << render(diags);
        content_ = std::move(*content);
        for (auto& [name, bytes] : *imported) files_[name.generic_string()] = std::move(bytes);
    }

    // The square that has a material, drawn with it; `change` edits the material's text first.
    template <class Change>
    runtime::Picture square(const std::string& material, const std::string& view, double aside,
                            Change change) {
        auto json = nlohmann::json::parse(files_.at(material + ".json"));
        change(json);
        Made made = make({json.dump(), files_, {"normal", "forward"}});
        runtime::Scene scene;
        scene.content = content_;
        std::erase_if(scene.content.instances, [&](const asset::Instance& instance) {
            return content_.meshes[instance.mesh].material != material;
        });
        glm::dvec3 middle(scene.content.instances.at(0).world_from_object[3]);
        middle.x += aside;
        scene.camera.target = middle;
        scene.camera.position = middle + glm::dvec3(0, 0, 1);
        scene.camera.ortho_height = kShown;
        return draw(made, scene, view, kSide, kSide);
    }
    runtime::Picture square(const std::string& material, const std::string& view, double aside = 0) {
        runtime::Picture picture = square(material, view, aside, [](nlohmann::json&) {});
        show(picture, "transform_" + material + "_" + view);
        return picture;
    }

    asset::Scene content_;
    std::map<std::string, std::string> files_;
};

// The share of the pixels whose colours are further apart than 0.02.
double differing(const runtime::Picture& a, const runtime::Picture& b) {
    std::size_t count = 0;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x)
            count += glm::length(rgb(a, x, y) - rgb(b, x, y)) > 0.02 ? 1u : 0u;
    }
    return static_cast<double>(count) / (kSide * kSide);
}

// Every rotation the other way round.
void turn_back(nlohmann::json& json) {
    if (json.is_object() && json.contains("rotation")) json["rotation"] = -json["rotation"].get<double>();
    if (json.is_structured())
        for (nlohmann::json& part : json) turn_back(part);
}

// Clearcoat and unlit squares are no business of the language.
const char* const kKinds[] = {"BaseColor", "Emission", "Normal", "MetalRough", "Occlusion"};

TEST_F(TextureTransforms, TurnLikeTheSquareThatNeedsNone) {
    for (const std::string kind : kKinds) {
        const std::string view = kind == "Normal" ? "normal" : "lit";
        const runtime::Picture wanted = square(kind + "SampleMat", view, kAside);
        for (const std::string set : {"0", "1"}) {
            // What is left is rounding of the coordinates: 1e-6 of the tile, a two-thousandth of a texel.
            const double same = differing(square(kind + "Test" + set + "Mat", view), wanted);
            EXPECT_LT(same, 0.001) << kind << " on uv " << set;
            const double other_way =
                differing(square(kind + "Test" + set + "Mat", view, 0, turn_back), wanted);
            fmt::print("{} on uv {}: {:.2f} % of the pixels differ, turned the other way {:.1f} %\n", kind,
                       set, 100 * same, 100 * other_way);
            EXPECT_GT(other_way, 0.1) << kind << " on uv " << set;
        }
    }
}

}  // namespace
}  // namespace sg::truth

// The Khronos sample NormalTangentTest: fifteen pairs of hemispheres, on the left as geometry, on the right
// as a normal map on a flat square. Each row of five turns its uvs by another angle. The model has no
// tangents, so both ways are tried: from uv derivatives, and made for the vertices. Seen in both pictures:
// the left and the right of each pair have the same colours as normals, and lit from the upper left the same
// highlight and the same shade, but for the thin rim where the geometry meets its square. With green turned,
// the right ones of the first, third and fifth row become dents, lit from below or from the right; the second
// and fourth row still look right, as their uvs run along the light: hence the numbers.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/render/truth.hpp"

namespace sg::truth {
namespace {

const char* const kModel =
    SG_SOURCE_DIR "/../shared/data/gltf/khronos/NormalTangentTest/NormalTangentTest.glb";

constexpr std::uint32_t kSide = 512;
constexpr double kUnits = 2.56;      // world units across the picture: 200 pixels a unit
constexpr std::uint32_t kTwin = 64;  // pixels from a hemisphere to its twin: 0.32 units
constexpr int kColumns = 3, kRows = 5;
constexpr double kPitchX = 0.8, kPitchY = 0.4;  // from pair to pair; the first square is at (-0.96, 0.8)

std::uint32_t word(const std::string& bytes, std::size_t at) {
    std::uint32_t out = 0;
    std::memcpy(&out, bytes.data() + at, 4);
    return out;
}

// The bytes of the picture that the first material names as its normal map: GLB container, JSON chunk, buffer
// view.
std::string embedded_normal_map(const std::string& glb) {
    const std::size_t json_size = word(glb, 12), binary = 20 + json_size + 8;
    const auto json = nlohmann::json::parse(glb.substr(20, json_size));
    const auto& texture = json["textures"][json["materials"][0]["normalTexture"]["index"].get<std::size_t>()];
    const auto& image = json["images"][texture["source"].get<std::size_t>()];
    const auto& view = json["bufferViews"][image["bufferView"].get<std::size_t>()];
    return glb.substr(binary + view["byteOffset"].get<std::size_t>(), view["byteLength"].get<std::size_t>());
}

class KhronosPairs : public testing::Test {
protected:
    void SetUp() override {
        RealFiles files;
        if (!files.exists(kModel)) GTEST_SKIP() << "the shared test data is not here: " << kModel;
        Diags diags;
        auto content = asset::read_gltf(files, kModel, diags);
        ASSERT_TRUE(content) << render(diags);
        normal_map_ = embedded_normal_map(files.read(kModel).bytes);
        scene_.content = std::move(*content);
        scene_.camera.position = {0, -0.125, 5};
        scene_.camera.target = {0, -0.125, 0};
        scene_.camera.ortho_height = kUnits;
    }
    // Of one pair after the other, row by row: the angles between the two halves, pixel by pixel.
    std::vector<Percentiles> compare(const std::string& basis, const std::string& green, double zero,
                                     const target::ShaderLibrary& library = target::embedded_library());
    std::string normal_map_;
    bool library_is_altered_ = false;  // no pictures of that
    runtime::Scene scene_;
};

// The pair that holds a pixel on its left half, row by row, or -1.
int pair_at(std::uint32_t x, std::uint32_t y) {
    const double wx = (x + 0.5) / kSide * kUnits - kUnits / 2,
                 wy = kUnits / 2 - (y + 0.5) / kSide * kUnits - 0.125;
    const double column = std::round((wx + 0.96) / kPitchX), row = std::round((0.8 - wy) / kPitchY);
    const bool inside =
        std::abs(wx + 0.96 - column * kPitchX) < 0.15 && std::abs(0.8 - row * kPitchY - wy) < 0.15;
    const bool valid = inside && column >= 0 && column < kColumns && row >= 0 && row < kRows;
    return valid ? static_cast<int>(row) * kColumns + static_cast<int>(column) : -1;
}

std::vector<Percentiles> KhronosPairs::compare(const std::string& basis, const std::string& green,
                                               double zero, const target::ShaderLibrary& library) {
    const nlohmann::json material = {
        {"version", 1},
        {"textures",
         {{"map", {{"file", "map.png"}, {"encoding", "tangent_normal"}, {"green", green}, {"zero", zero}}}}},
        {"bump", {{{"layers", {{{"kind", "normal_map"}, {"texture", "map"}, {"basis", basis}}}}}}}};
    Made made = make({material.dump(), {{"map.png", normal_map_}}, {"normal", "debug", "forward"}}, library);
    if (!library_is_altered_) show(draw(made, scene_, "lit", kSide, kSide), "khronos_lit_" + basis + green);
    for (auto& chain : made.textures.chains)
        chain.resize(1);  // the normal at the point, not the mean over a pixel
    const runtime::Picture mapped = draw(made, scene_, "normal", kSide, kSide);
    const runtime::Picture geometry = draw(made, scene_, "base-normal", kSide, kSide);
    if (!library_is_altered_) show(mapped, "khronos_normal_" + basis + green);
    std::vector<std::vector<double>> angles(kColumns * kRows);
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x + kTwin < kSide; ++x) {
            const int pair = pair_at(x, y);
            const bool dome = pair >= 0 && covered(geometry, x, y) && rgb(geometry, x, y).z < std::cos(0.05);
            if (dome)
                angles[static_cast<std::size_t>(pair)].push_back(
                    angle_degrees(rgb(geometry, x, y), rgb(mapped, x + kTwin, y)));
        }
    }
    std::vector<Percentiles> out;
    for (auto& values : angles) out.push_back(percentiles(std::move(values)));
    return out;
}

// Half of the pixels may not be further apart than this, degrees.
//   8 bits: a decoded component is off by up to 1/255 either way, evenly; two of them, across the normal,
//   turn it by an angle of the Rayleigh kind with sigma = 2/255/sqrt(12), whose median is 1.177 sigma = 0.153
//   degrees (filtering only averages that). Facets: over a facet whose vertex normals span the angle e, the
//   interpolated normal is up to e^2/8, on average 2/3 of that, too short before it is normalised, which tips
//   it outward by as much times tan(tilt).
double median_bound(const asset::Scene& content) {
    const double bits = 1.1774 * 2 / 255 / std::sqrt(12.0) * 180 / 3.141592653589793;
    std::vector<double> spans, tilts;
    const asset::Mesh& mesh = content.meshes[0];
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 a(mesh.normals[mesh.indices[i + k]]),
                b(mesh.normals[mesh.indices[i + (k + 1) % 3]]);
            const double span = angle_degrees(a, b) / 180 * 3.141592653589793;
            if (span < 1e-3) continue;  // the flat squares
            spans.push_back(span);
            tilts.push_back(std::hypot(a.x, a.y) / std::abs(a.z));
        }
    }
    const double span = percentiles(spans).median,
                 facets = 2.0 / 3 * span * span / 8 * percentiles(tilts).median;
    return bits + facets * 180 / 3.141592653589793;
}

// The largest median of the fifteen pairs.
double worst(const std::vector<Percentiles>& pairs, const char* what) {
    double median = 0, p99 = 0;
    for (const Percentiles& pair : pairs) {
        EXPECT_GT(pair.count, 1000u);
        median = std::max(median, pair.median);
        p99 = std::max(p99, pair.p99);
    }
    fmt::print(
        "NormalTangentTest {}: worst pair's median {:.3f}, p99 {:.2f} (the rim, where the geometry has an "
        "edge)\n",
        what, median, p99);
    return median;
}

TEST_F(KhronosPairs, MapsLookLikeTheirGeometricTwins) {
    const double bound = median_bound(scene_.content);
    fmt::print("NormalTangentTest bound {:.3f}\n", bound);
    EXPECT_LT(bound, 0.3);
    EXPECT_LE(worst(compare("uv", "up", 127.5), "uv"), bound);
    EXPECT_LE(worst(compare("vertex", "up", 127.5), "vertex"), bound);
}

// Even the zero of the encoding shows: 128 for 127.5 turns everything by 0.32 degrees.
TEST_F(KhronosPairs, NoWrongMeaningOfTheMapPasses) {
    const double bound = median_bound(scene_.content);
    EXPECT_GT(worst(compare("uv", "down", 127.5), "uv, green turned"), bound);
    EXPECT_GT(worst(compare("vertex", "up", 128), "vertex, another zero"), bound);
}

TEST_F(KhronosPairs, NoWrongSignInTheLibraryPasses) {
    const double bound = median_bound(scene_.content);
    library_is_altered_ = true;
    auto mutant = [](const char* name, const std::string& text, const std::string& wrong) {
        target::ShaderLibrary library = target::embedded_library();
        std::string& file = library.files[name];
        const std::size_t at = file.find(text);
        EXPECT_NE(at, std::string::npos) << "the library changed: '" << text << "'";
        if (at != std::string::npos) file.replace(at, text.size(), wrong);
        return library;
    };
    const auto turned_w = mutant("surfgrad/resolve.glsl", "vertex_tangent.w < 0.0 ? -lean.y : lean.y",
                                 "vertex_tangent.w < 0.0 ? lean.y : -lean.y");
    const auto turned_t = mutant("surfgrad/tbn.glsl", "det < 0.0 ? -frame.flip_sign : frame.flip_sign",
                                 "det < 0.0 ? frame.flip_sign : -frame.flip_sign");
    EXPECT_GT(worst(compare("vertex", "up", 127.5, turned_w), "vertex, w turned"), bound);
    EXPECT_GT(worst(compare("uv", "up", 127.5, turned_t), "uv, t turned"), bound);
}

}  // namespace
}  // namespace sg::truth

// Real and exact assets of the shared test data, drawn and measured. Skipped where the data is not here.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "import/gltf_import.hpp"
#include "runtime/mesh/shapes.hpp"
#include "runtime/proof/angles.hpp"
#include "tests/proof/shared_data.hpp"

namespace sg::proof {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kTau = 6.283185307179586;
constexpr std::uint32_t kPixels = 160;

runtime::Scene file_scene(const std::string& file) {
    RealFiles files;
    Diags diags;
    runtime::Scene out;
    auto content = asset::read_gltf(files, kData + file, diags);
    if (!content) throw std::runtime_error(render(diags));
    out.content = std::move(*content);
    out.camera = runtime::default_camera(runtime::bounds_of(out.content), 1);
    return out;
}

// ---- heights and slopes in closed form ----

// h = 0.5 + the sum of a cos(2 pi (m u + n v) + phase), v downwards.
struct Formula {
    struct Term {
        double a, m, n, phase;
    };
    std::vector<Term> terms;
    double scale = 0;
    [[nodiscard]] dvec2 gradient(dvec2 uv) const {
        dvec2 out(0);
        for (const Term& t : terms)
            out -= t.a * std::sin(kTau * (t.m * uv.x + t.n * uv.y) + t.phase) * kTau * dvec2(t.m, t.n);
        return out;
    }
    // The largest share of a slope that derivatives of filtered texels lose: 1/6 (difference over two texels)
    // + 1/4 (the lines beside it) + 1/8 (between derivatives) of the square of the angle that a texel spans,
    // per axis.
    [[nodiscard]] double lost(double side) const {
        double most = 0;
        for (const Term& t : terms) most = std::max({most, std::abs(t.m), std::abs(t.n)});
        return (1.0 / 6 + 1.0 / 4 + 1.0 / 8) * std::pow(kTau * most / side, 2);
    }
};
Formula formula_of(const std::string& file, const char* terms) {
    const auto json = nlohmann::json::parse(bytes_of(file));
    Formula out;
    for (const auto& t : json.at(terms))
        out.terms.push_back({t.at("a"), t.at("m"), t.at("n"), t.at("phase")});
    out.scale = json.at("displacement_scale_s");
    return out;
}

struct Case {
    std::string folder;
    double side;
    int bits;
};
const Case kPairs[] = {{"made/height-normal/waves_256/", 256, 16},
                       {"made/height-normal/steep_128/", 128, 16},
                       {"made/height-normal/waves_256/", 256, 8},
                       {"made/height-normal/steep_128/", 128, 8}};

// The exact pairs on a plane of side 2, which is twice their square: heights count twice, slopes are the
// same.
TEST(ExactPairs, HeightsGiveTheNormalsThatWereBakedFromThem) {
    SG_NEEDS("made/height-normal/waves_256/params.json");
    runtime::Scene scene;
    scene.content.meshes.push_back(runtime::make_plane(4, false));
    scene.content.instances.push_back({"", 0, glm::mat4(1)});
    scene.camera.position = {0, 0, 3};
    scene.camera.ortho_height = 1.0;  // magnified: a quarter of the tile
    for (const Case& pair : kPairs) {
        const Formula formula = formula_of(pair.folder + "params.json", "terms");
        const truth::Made height =
            one_layer(fmt::format("{}height{}.png", pair.folder, pair.bits), R"("encoding": "height")",
                      fmt::format(R"("kind": "height_map", "strength": {})", 2 * formula.scale));
        const truth::Made map = one_layer(fmt::format("{}normal_gl{}.png", pair.folder, pair.bits),
                                          R"("encoding": "tangent_normal")", R"("kind": "normal_map")");
        auto draw = [&](const truth::Made& made, const char* view) {
            return truth::draw(made, scene, view, kPixels, kPixels);
        };
        const runtime::Picture from_height = draw(height, "normal"), from_map = draw(map, "normal"),
                               uv = draw(map, "uv0");
        std::vector<double> height_error, map_error;
        double steepest = 0;
        for (std::uint32_t y = 0; y < kPixels; ++y) {
            for (std::uint32_t x = 0; x < kPixels; ++x) {
                const dvec2 slope = formula.scale * formula.gradient(dvec2(truth::rgb(uv, x, y)));
                const dvec3 exact(-slope.x, slope.y, 1);
                steepest = std::max(steepest, glm::length(slope));
                height_error.push_back(angle_degrees(truth::rgb(from_height, x, y), exact));
                map_error.push_back(angle_degrees(truth::rgb(from_map, x, y), exact));
            }
        }
        // Half a step of the texels on both sides of a difference over two of them; the map's step, times 1 +
        // slope^2.
        const double levels = pair.bits == 16 ? 65535 : 255;
        const double quantum = formula.scale * pair.side / levels / 2;
        const double bound = (steepest * formula.lost(pair.side) + 2 * quantum) * 57.3;
        const double map_bound =
            (1 + steepest * steepest) * (steepest * formula.lost(pair.side) + 3.0 / levels) * 57.3;
        const Numbers h = numbers_of(height_error), m = numbers_of(map_error),
                      both = numbers_of(angles_between(from_height, from_map).degrees);
        fmt::print("{} {} bits: heights {} (bound {:.3f})\n  map {} (bound {:.3f})\n  apart {}\n",
                   pair.folder, pair.bits, text_of(h), bound, text_of(m), map_bound, text_of(both));
        EXPECT_LT(h.p99, bound);
        EXPECT_LT(m.p99, map_bound);
        EXPECT_LT(both.p99, bound + map_bound);
        // A mutant: green turned.
        const truth::Made turned = one_layer(pair.folder + "normal_dx8.png",
                                             R"("encoding": "tangent_normal")", R"("kind": "normal_map")");
        EXPECT_GT(numbers_of(angles_between(from_height, draw(turned, "normal")).degrees).median,
                  (pair.bits == 16 ? 10 : 2) * both.p99);
    }
}

// The exact torus: its object-space map, its tangent-space map and its heights against their formula.
TEST(ExactTorus, ThreeMapsOneSurface) {
    const std::string folder = "made/object-space/";
    SG_NEEDS(folder + "torus.json");
    const Formula formula = formula_of(folder + "torus.json", "h_terms");
    runtime::Scene scene = file_scene(folder + "torus.glb");
    struct Map {
        const char *file, *texture, *layer;
    };
    const Map maps[] = {
        {"torus_object_normal16.png", R"("encoding": "object_normal")", R"("kind": "object_normal_map")"},
        {"torus_tangent_normal8.png", R"("encoding": "tangent_normal")", R"("kind": "normal_map")"},
        {"torus_height16.png", R"("encoding": "height")", R"("kind": "height_map", "strength": 0.03)"}};
    // The mesh has facets and a pixel covers several texels: what is asserted is that most of each tilt is
    // there, in its direction; a missing bump would be off by the whole tilt, a wrong sign by twice that.
    for (const Map& map : maps) {
        const truth::Made made = one_layer(folder + map.file, map.texture, map.layer);
        const runtime::Picture normals = truth::draw(made, scene, "normal", kPixels, kPixels),
                               uv = truth::draw(made, scene, "uv0", kPixels, kPixels);
        std::vector<double> errors, bare;
        for (std::uint32_t y = 0; y < kPixels; ++y) {
            for (std::uint32_t x = 0; x < kPixels; ++x) {
                if (!truth::covered(normals, x, y)) continue;
                const dvec2 st(truth::rgb(uv, x, y));
                const double a = kTau * st.x, b = kTau * (1 - st.y), ring = 1 + 0.4 * std::cos(b);
                const dvec3 n(std::cos(b) * std::cos(a), std::sin(b), -std::cos(b) * std::sin(a));
                const dvec3 along_u = dvec3(-std::sin(a), 0, -std::cos(a)) / (kTau * ring);
                const dvec3 along_v =
                    dvec3(std::sin(b) * std::cos(a), -std::cos(b), -std::sin(b) * std::sin(a)) / (kTau * 0.4);
                const dvec2 slope = formula.scale * formula.gradient(st);
                const dvec3 exact = n - slope.x * along_u - slope.y * along_v;
                errors.push_back(angle_degrees(truth::rgb(normals, x, y), exact));
                bare.push_back(angle_degrees(n, exact));
            }
        }
        const Numbers found = numbers_of(errors), tilt = numbers_of(bare);
        fmt::print("{}: {}, tilt {}\n", map.file, text_of(found), text_of(tilt));
        EXPECT_GT(found.count, 3000u);
        EXPECT_GT(tilt.median, 5 * found.median);
    }
}

// Models whose tangent-space map was baked into object space: both must shade alike where a texel belongs
// to one place of the model, which a mask tells. Between the charts they do not (1 % of the pixels of
// the bottle is off by 30 degrees and more). Coarser levels mix charts, which face everywhere in object space
// (5 % off by 8 degrees and more): only the first level is read.
struct Baked {
    const char *name, *model, *map;
};
void PrintTo(const Baked& baked, std::ostream* out) {
    *out << baked.name;
}
const Baked kBaked[] = {
    {"WaterBottle", "gltf/khronos/WaterBottle/WaterBottle.gltf",
     "gltf/khronos/WaterBottle/WaterBottle_normal.png"},
    // It has no tangents: they are computed.
    {"BoomBox", "materialx/resources/Geometry/boombox.glb",
     "materialx/resources/Materials/Examples/GltfPbr/boombox/BoomBox_normal.png"},
};
class ObjectSpace : public testing::TestWithParam<Baked> {};

TEST_P(ObjectSpace, AgreesWithTangentSpace) {
    const std::string name = GetParam().name;
    SG_NEEDS("object-space/" + name + "_object_normal.png");
    SG_NEEDS(GetParam().model);
    const runtime::Scene scene = file_scene(GetParam().model);
    truth::Made tangent = one_layer(GetParam().map, R"("encoding": "tangent_normal")",
                                    R"("kind": "normal_map", "basis": "vertex")");
    truth::Made object = one_layer("object-space/" + name + "_object_normal.png",
                                   R"("encoding": "object_normal")", R"("kind": "object_normal_map")");
    const truth::Made bare = truth::make({R"({"version": 1})", {}, {"normal", "debug"}});
    Diags diags;
    const asset::Image mask =
        asset::read_image(bytes_of("object-space/" + name + "_mask.png"), "mask", {}, diags).value();
    auto draw = [&](const truth::Made& made, const char* view = "normal") {
        return truth::draw(made, scene, view, kPixels, kPixels);
    };
    const Numbers coarse = numbers_of(angles_between(draw(tangent), draw(object)).degrees);
    for (truth::Made* made : {&tangent, &object}) made->textures.chains[0].resize(1);
    const runtime::Picture first = draw(tangent), second = draw(object), plain = draw(bare),
                           uv = draw(tangent, "uv0");
    auto inside = [&](dvec2 st) {
        for (int i = 0; i < 9; ++i) {
            const dvec2 at = st * dvec2(mask.width, mask.height) + dvec2(i % 3 - 1, i / 3 - 1);
            const auto x = static_cast<std::int64_t>(std::floor(at.x)),
                       y = static_cast<std::int64_t>(std::floor(at.y));
            if (x < 0 || y < 0 || x >= mask.width || y >= mask.height) return false;
            if (mask.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0) < 0.5) return false;
        }
        return true;
    };
    std::vector<double> masked, all, bumps;
    for (std::uint32_t y = 0; y < kPixels; ++y) {
        for (std::uint32_t x = 0; x < kPixels; ++x) {
            if (!truth::covered(first, x, y)) continue;
            const double angle = angle_degrees(truth::rgb(first, x, y), truth::rgb(second, x, y));
            all.push_back(angle);
            if (!inside(dvec2(truth::rgb(uv, x, y)))) continue;
            masked.push_back(angle);
            bumps.push_back(angle_degrees(truth::rgb(first, x, y), truth::rgb(plain, x, y)));
        }
    }
    const Numbers apart = numbers_of(masked), bump = numbers_of(bumps);
    fmt::print("{}: apart {}\n  without the mask {}\n  with all levels {}\n  bumps {}\n", name,
               text_of(apart), text_of(numbers_of(all)), text_of(coarse), text_of(bump));
    // Two maps of 8 bits: half a step of 1/127.5 in three channels each, 0.8 degrees.
    EXPECT_GT(apart.count, 3000u);
    EXPECT_LT(apart.p95, 0.8);
    EXPECT_GT(bump.p95, 3 * apart.p95);
}
INSTANTIATE_TEST_SUITE_P(Models, ObjectSpace, testing::ValuesIn(kBaked),
                         [](const auto& row) { return std::string(row.param.name); });

// A plane seen from behind: with glTF's rule the whole normal turns.
TEST(TwoSidedPlane, TurnsItsNormalBehind) {
    const std::string folder = "gltf/khronos/TwoSidedPlane/TwoSidedPlane";
    SG_NEEDS(folder + ".gltf");
    runtime::Scene scene = file_scene(folder + ".gltf");
    const truth::Made made = one_layer(folder + "_Normal.png", R"("encoding": "tangent_normal")",
                                       R"("kind": "normal_map")", R"(, "surface": {"two_sided": "flip"})");
    const auto bounds = runtime::bounds_of(scene.content);
    dvec3 axis(0);
    for (int i = 0; i < 3; ++i) {
        if (bounds.upper[i] - bounds.lower[i] < 0.01 * bounds.radius) axis[i] = 1;
    }
    ASSERT_EQ(glm::length(axis), 1);
    std::map<std::pair<int, int>, dvec3> seen;
    double worst = 0;
    std::size_t compared = 0;
    for (double side : {1.0, -1.0}) {
        scene.camera.target = bounds.center;
        scene.camera.position = bounds.center + side * axis * 4.0 * bounds.radius;
        scene.camera.ortho_height = bounds.radius;
        const runtime::Picture normals = truth::draw(made, scene, "normal", kPixels, kPixels),
                               uv = truth::draw(made, scene, "uv0", kPixels, kPixels);
        for (std::uint32_t y = 0; y < kPixels; ++y) {
            for (std::uint32_t x = 0; x < kPixels; ++x) {
                if (!truth::covered(normals, x, y)) continue;
                const dvec3 n = truth::rgb(normals, x, y);
                EXPECT_GT(glm::dot(n, side * axis), 0);
                // The same place: the same coordinate to a 4096th of the map.
                const dvec2 st(truth::rgb(uv, x, y));
                const std::pair<int, int> key(static_cast<int>(std::lround(st.x * 4096)),
                                              static_cast<int>(std::lround(st.y * 4096)));
                if (side > 0) seen[key] = n;
                if (side > 0 || !seen.contains(key)) continue;
                worst = std::max(worst, angle_degrees(-n, seen[key]));
                ++compared;
            }
        }
    }
    fmt::print("TwoSidedPlane: {} places seen from both sides, at most {:.4f} degrees apart\n", compared,
               worst);
    EXPECT_GT(compared, 500u);
    EXPECT_LT(worst, 0.5);
}

// Two copies of one mesh, one of them mirrored by its node: seen in a mirror, it is the other.
TEST(NegativeScale, MirroredNodesFaceOutward) {
    const std::string file = "gltf/khronos/NegativeScaleTest/NegativeScaleTest.glb";
    SG_NEEDS(file);
    const runtime::Scene scene = file_scene(file);
    std::size_t mirrored = 0;
    for (const asset::Instance& instance : scene.content.instances)
        mirrored += glm::determinant(glm::mat3(instance.world_from_object)) < 0 ? 1 : 0;
    EXPECT_GT(mirrored, 0u);
    const truth::Made bare = truth::make({R"({"version": 1})", {}, {"normal", "debug"}});
    const runtime::Picture normals = truth::draw(bare, scene, "normal", kPixels, kPixels),
                           positions = truth::draw(bare, scene, "position", kPixels, kPixels);
    std::size_t count = 0, away = 0;
    for (std::uint32_t y = 0; y < kPixels; ++y) {
        for (std::uint32_t x = 0; x < kPixels; ++x) {
            if (!truth::covered(normals, x, y)) continue;
            ++count;
            away += glm::dot(truth::rgb(normals, x, y), truth::rgb(positions, x, y)) > 0 ? 1 : 0;
        }
    }
    fmt::print("NegativeScaleTest: {} of {} instances mirrored; {} of {} pixels face away\n", mirrored,
               scene.content.instances.size(), away, count);
    EXPECT_GT(count, 500u);
    EXPECT_LT(away, count / 100);  // interpolated normals at silhouettes
}

// ---- which coordinate places which picture ----

// A colour of a picture at a coordinate, as a sampler without further levels gives it: linear, repeated.
dvec3 colour_at(const asset::Image& image, dvec2 st) {
    auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    auto texel = [&](double x, double y) {
        auto wrapped = [](double at, std::uint32_t size) {
            return static_cast<std::uint32_t>(at - std::floor(at / size) * size);
        };
        const std::uint32_t column = wrapped(x, image.width), row = wrapped(y, image.height);
        dvec3 out;
        for (int c = 0; c < 3; ++c) out[c] = linear(image.at(column, row, c));
        return out;
    };
    const dvec2 place = st * dvec2(image.width, image.height) - 0.5, corner = glm::floor(place),
                t = place - corner;
    return glm::mix(glm::mix(texel(corner.x, corner.y), texel(corner.x + 1, corner.y), t.x),
                    glm::mix(texel(corner.x, corner.y + 1), texel(corner.x + 1, corner.y + 1), t.x), t.y);
}

// The model's base colour lies on its first coordinates, its emission on the second: imported, each pixel has
// the colours of its two pictures at these two coordinates, and not at each other's. Sixteen bits of target
// and weights of a 256th between texels: differences below 0.02.
TEST(MultiUv, EachPictureLiesOnItsOwnSet) {
    const std::string folder = "gltf/khronos/MultiUVTest/";
    SG_NEEDS(folder + "MultiUVTest.gltf");
    RealFiles files;
    Diags diags;
    auto imported = import::import_gltf(files, kData + folder + "MultiUVTest.gltf", diags);
    ASSERT_TRUE(imported) << render(diags);
    truth::Recipe recipe;
    for (auto& [name, bytes] : *imported) recipe.files[name.generic_string()] = std::move(bytes);
    recipe.json = recipe.files.at("Material.json");
    recipe.entries = {"gbuffer", "debug"};
    truth::Made made = truth::make(recipe);
    for (auto& chain : made.textures.chains) chain.resize(1);
    const runtime::Scene scene = file_scene(folder + "MultiUVTest.gltf");
    auto draw = [&](const std::string& view) { return truth::draw(made, scene, view, kPixels, kPixels); };
    const runtime::Picture shown[] = {draw("gbuffer:base_color"), draw("gbuffer:emission")},
                           uv[] = {draw("uv0"), draw("uv1")};
    const asset::Image picture[] = {asset::read_image(bytes_of(folder + "uv0.png"), "0", {}, diags).value(),
                                    asset::read_image(bytes_of(folder + "uv1.png"), "1", {}, diags).value()};
    for (int map : {0, 1}) {
        for (int set : {0, 1}) {
            std::size_t count = 0, wrong = 0;
            for (std::uint32_t y = 0; y < kPixels; ++y) {
                for (std::uint32_t x = 0; x < kPixels; ++x) {
                    if (!truth::covered(shown[map], x, y)) continue;
                    const dvec3 expected = colour_at(picture[map], dvec2(truth::rgb(uv[set], x, y)));
                    ++count;
                    wrong += glm::length(truth::rgb(shown[map], x, y) - expected) > 0.02 ? 1 : 0;
                }
            }
            fmt::print("MultiUVTest: {} at coordinates {}: {} of {} pixels differ\n",
                       map ? "emission" : "base colour", set, wrong, count);
            EXPECT_GT(count, 5000u);
            if (map == set)
                EXPECT_LT(wrong, count / 100);  // where a coordinate jumps between faces
            else
                EXPECT_GT(wrong, count / 10);
        }
    }
}

}  // namespace
}  // namespace sg::proof

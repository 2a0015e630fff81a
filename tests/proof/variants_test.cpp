// Every kind of bump, drawn in every way that must not matter, held to the truth and to each other.
//
// Heights are a fiftieth of those of kinds.cpp and a pixel is smaller than a texel, so that little may be
// off:
//
// - The mesh: its interpolated normals are off without any bump, and that much is measured beside it. Between
//   vertices edges of e = 1/80 apart a normal is off by e^2 |n''| / 8: on the rock, whose waves sum up to
//   |n''| = 34, by 0.04 degrees at most; nowhere more may count as the mesh's.
// - Of first order in the height: heights move the surface along its curved normal, tilt x height x
// curvature.
// - Tangents along the edges of facets that turn by 2 pi / 512: by that share of the tilt, on the torus only.
// - Filters, of waves of a third of 256 texels, an angle of w = 2 pi 3 / 256 a texel: derivatives of filtered
//   texels (1/6 + 1/4 + 1/8) w^2 = 0.3 %; a difference to the next texel is that of half a texel further, w /
//   2 = 3.7 %, that to the next pixel of half a texel and half a pixel, a third of a texel at most: 4.9 %.
//
// Blends of two normals and functions of one's own have no height: theirs are the truths of materials that
// they equal, blends for slopes of 0.03 at most, but for the square of that.
//
// So the 95th percentile of the error is below those shares of the 95th percentile of the tilt. No bump would
// be off by all of the tilt, a wrong sign by twice that.
#include "tests/proof/variants.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "runtime/proof/angles.hpp"

namespace sg::proof {
namespace {

using runtime::Picture;
using runtime::SmoothShape;

constexpr double kDegrees = 57.29577951308232, kTau = 6.283185307179586;
constexpr double kMesh = 0.04;                       // degrees
constexpr double kTurn = kTau / 512;                 // share
constexpr double kWave = kTau * 3 / kVariantTexels;  // radians
constexpr double kUlp = 1.1920929e-7;

double filter_share(const std::string& kind) {
    if (kind == "height_map_forward") return kWave / 2;
    if (kind == "height_map_screen") return kWave / 2 * 4 / 3;
    return (1.0 / 6 + 1.0 / 4 + 1.0 / 8) * kWave * kWave;
}

struct Verdict {
    bool holds = false;
    double tilt = 0, mesh = 0;  // 95th percentiles
    std::string text;
};
Verdict judge(DrawnKind& kind, const KindCase& c, const Picture& normals, const Variant& variant) {
    const DrawnKind::Errors found = kind.against_truth(normals, variant.change);
    const Numbers error = numbers_of(found.error), tilt = numbers_of(found.tilt),
                  mesh = numbers_of(found.bare);
    const double share =
        found.moved * found.curvature + filter_share(c.name) + (c.shape == SmoothShape::torus ? kTurn : 0);
    const double bound = std::min(mesh.p95, kMesh) + share * tilt.p95;
    return {error.count > 100 && error.p95 <= bound, tilt.p95, std::min(mesh.p95, kMesh),
            fmt::format("{:28} {:21} p95 {:.4f}, bound {:.4f} = mesh {:.4f} + {:.4f} of the tilt {:.3f}",
                        c.name, variant.name, error.p95, bound, mesh.p95, share, tilt.p95)};
}

// ---- pictures against each other ----

// What rounding leaves: coordinates and positions relative to the camera, up to 5.6 units away, over a pixel
// of 0.003 units and 0.0004 of the coordinate, four roundings each; and a dozen of vectors of unit length.
double rounding(double tilt) {
    return kUlp * (tilt * 4 * (5.6 / 0.003 + 1 / 0.0004) + 16 * kDegrees);
}

glm::dvec3 mirrored(glm::dvec3 n) {
    return {-n.x, n.y, n.z};
}

// Degrees per pixel between a picture and what another says that it must be.
template <class Expected>
Numbers apart(const Picture& picture, Expected expected) {
    std::vector<double> out;
    for (std::uint32_t y = 0; y < picture.values.height; ++y) {
        for (std::uint32_t x = 0; x < picture.values.width; ++x) {
            const std::optional<glm::dvec3> other = expected(x, y);
            if (truth::covered(picture, x, y) && other)
                out.push_back(angle_degrees(truth::rgb(picture, x, y), *other));
        }
    }
    return numbers_of(out);
}

// The mean of four pixels of a picture of twice the size, where all of them show something.
auto mean_of_four(const Picture& large) {
    return [&large](std::uint32_t x, std::uint32_t y) -> std::optional<glm::dvec3> {
        glm::dvec3 sum(0);
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t lx = 2 * x + i % 2, ly = 2 * y + i / 2;
            if (!truth::covered(large, lx, ly)) return std::nullopt;
            sum += truth::rgb(large, lx, ly);
        }
        return sum;
    };
}
auto mirror_image(const Picture& other) {
    return [&other](std::uint32_t x, std::uint32_t y) -> std::optional<glm::dvec3> {
        const std::uint32_t from = other.values.width - 1 - x;
        if (!truth::covered(other, from, y)) return std::nullopt;
        return mirrored(truth::rgb(other, from, y));
    };
}
auto same_place(const Picture& other) {
    return [&other](std::uint32_t x, std::uint32_t y) -> std::optional<glm::dvec3> {
        if (!truth::covered(other, x, y)) return std::nullopt;
        return truth::rgb(other, x, y);
    };
}

const target::ShaderLibrary& library() {
    static const target::ShaderLibrary kLibrary = target::embedded_library();
    return kLibrary;
}

void expect_below(double found, double bound, const std::string& kind, const char* what) {
    const std::string text =
        fmt::format("{:28} against plain: {:21} {:.6f}, bound {:.6f}", kind, what, found, bound);
    fmt::print("{}\n", text);
    EXPECT_LE(found, bound) << text;
}

// What stands in the world does not turn with the object.
bool in_the_world(const KindCase& c) {
    return c.material.find(R"("space": "world")") != std::string::npos;
}

class Drawn : public testing::TestWithParam<KindCase> {};

TEST_P(Drawn, IsTrueHoweverItIsDrawn) {
    const KindCase& c = GetParam();
    DrawnKind kind(c, library());
    std::map<Change, Picture> pictures;
    double tilt = 0, mesh = 0;
    for (const Variant& variant : all_variants()) {
        const Picture& normals = pictures[variant.change] = kind.normals(variant.change);
        truth::show(normals, c.name + "_" + variant.name);
        const Verdict verdict = judge(kind, c, normals, variant);
        fmt::print("{}\n", verdict.text);
        EXPECT_TRUE(verdict.holds) << verdict.text;
        tilt = std::max(tilt, verdict.tilt);
        if (variant.change == Change::plain) mesh = verdict.mesh;
    }
    const Picture& plain = pictures[Change::plain];
    // Differences to the next texel, or pixel, go the other way.
    const double turned = rounding(tilt) + kWave * tilt;
    expect_below(apart(pictures[Change::mirrored_uv], same_place(plain)).p99,
                 c.name == "height_map_forward" ? turned : rounding(tilt), c.name, "mirrored uvs");
    expect_below(apart(pictures[Change::turned], same_place(plain)).p99,
                 c.name == "height_map_screen" ? turned : rounding(tilt), c.name, "negative viewport");
    if (!in_the_world(c))
        expect_below(apart(pictures[Change::negative], mirror_image(plain)).p99,
                     c.name == "height_map_screen" ? turned : rounding(tilt), c.name, "negative scale");
    // A pixel and four of half its size straddle the borders of facets differently, and creases: those of
    // turbulence, in three or four sizes, run through more than a twentieth of the pixels.
    const Numbers size = apart(plain, mean_of_four(pictures[Change::twice]));
    const bool creased = c.name == "noise_turbulence" || c.name == "custom";
    expect_below(creased ? size.median : size.p95,
                 rounding(tilt) + mesh + (kTurn + filter_share(c.name)) * tilt, c.name,
                 "twice the resolution");
}

INSTANTIATE_TEST_SUITE_P(Kinds, Drawn, testing::ValuesIn(all_kind_cases()),
                         [](const auto& row) { return row.param.name; });
INSTANTIATE_TEST_SUITE_P(KindsWithoutHeights, Drawn, testing::ValuesIn(equal_kind_cases()),
                         [](const auto& row) { return row.param.name; });

// ---- wrong shaders ----

struct Mutant {
    std::string name, file, text, wrong, kind;
    Change change;
};
std::ostream& operator<<(std::ostream& out, const Mutant& m) {
    return out << m.name;
}
const std::vector<Mutant> kMutants = {
    {"mirrored_uvs_are_ignored", "surfgrad/tbn.glsl", "float det = uv.dx.x * uv.dy.y - uv.dx.y * uv.dy.x;",
     "float det = abs(uv.dx.x * uv.dy.y - uv.dx.y * uv.dy.x);", "normal_map", Change::mirrored_uv},
    {"w_is_ignored", "surfgrad/resolve.glsl", "vertex_tangent.w < 0.0 ? -lean.y : lean.y", "-lean.y",
     "normal_map_from_the_vertex", Change::mirrored_uv},
    {"mirrored_instance_keeps_w", "stage/vertex.glsl", "tangent.w * sg_object_block.normal_from_object[3][3]",
     "tangent.w", "normal_map_from_the_vertex", Change::negative},
    {"sign_of_the_area_is_lost", "surfgrad/from_height.glsl", "return sg_frame_inverse_area(frame)",
     "return abs(sg_frame_inverse_area(frame))", "height_map_hq", Change::inside_mirror},
    {"normals_go_through_the_matrix_of_positions", "stage/vertex.glsl",
     "mat3(sg_object_block.normal_from_object) * normal",
     "mat3(sg_object_block.relative_from_object) * normal", "noise_perlin", Change::stretched},
    {"gradients_go_through_the_matrix_of_positions", "stage/object.glsl",
     "mat3(sg_object_block.normal_from_object) * gradient",
     "mat3(sg_object_block.relative_from_object) * gradient", "triplanar", Change::stretched},
    {"object_normals_go_through_the_matrix_of_positions", "stage/object.glsl",
     "return mat3(sg_object_block.normal_from_object) * v;",
     "return mat3(sg_object_block.relative_from_object) * v;", "object_normal_map", Change::stretched},
    {"mirror_does_nothing", "surfgrad/frame.glsl", "return facing * n;", "return n;", "decal_box",
     Change::inside_mirror},
    {"flip_does_nothing", "surfgrad/resolve.glsl", "return facing * resolved;", "return resolved;", "planar",
     Change::inside_flip},
    {"flip_sign_is_forgotten", "surfgrad/tbn.glsl", "det < 0.0 ? -frame.flip_sign : frame.flip_sign",
     "det < 0.0 ? -1.0 : 1.0", "derivative_map", Change::inside_mirror},
    {"steepness_of_one_resolution", "surfgrad/from_height.glsl", "return sg_frame_inverse_area(frame)",
     "return 1e5", "height_map_hq", Change::twice},
    // Right as long as y grows downward on the screen.
    {"flip_sign_of_y_downward", "surfgrad/tbn.glsl", "det < 0.0 ? -frame.flip_sign : frame.flip_sign",
     "det < 0.0 ? 1.0 : -1.0", "normal_map", Change::turned},
    {"area_of_y_downward", "surfgrad/from_height.glsl", "return sg_frame_inverse_area(frame)",
     "return -abs(sg_frame_inverse_area(frame))", "height_map_screen", Change::turned},
    {"uv_derivatives_are_swapped", "stage/fragment.glsl", "dFdxFine(st), dFdyFine(st)",
     "dFdyFine(st), dFdxFine(st)", "normal_map_on_uv1", Change::ortho},
};

class DrawnWrong : public testing::TestWithParam<Mutant> {};

TEST_P(DrawnWrong, IsNoticed) {
    const Mutant& m = GetParam();
    target::ShaderLibrary library = target::embedded_library();
    std::string& text = library.files[m.file];
    const std::size_t at = text.find(m.text);
    ASSERT_NE(at, std::string::npos) << "the library changed";
    text.replace(at, m.text.size(), m.wrong);
    for (const KindCase& c : all_kind_cases()) {
        if (c.name != m.kind) continue;
        DrawnKind kind(c, library);
        const Variant& variant = all_variants()[static_cast<std::size_t>(m.change)];
        const Verdict verdict = judge(kind, c, kind.normals(m.change), variant);
        fmt::print("{:48} {}\n", m.name, verdict.text);
        EXPECT_FALSE(verdict.holds);
        if (m.change != Change::turned) continue;
        const Verdict plain = judge(kind, c, kind.normals(Change::plain), all_variants()[0]);
        EXPECT_TRUE(plain.holds) << plain.text;
    }
}

INSTANTIATE_TEST_SUITE_P(Mutants, DrawnWrong, testing::ValuesIn(kMutants),
                         [](const auto& row) { return row.param.name; });

// ---- order ----

// The layers of the first stage and one more, written from first to last and from last to first, drawn as
// written (not optimised).
Numbers turned_round(const KindCase& c, bool as_stages) {
    auto draw = [&](bool backwards) {
        auto json = nlohmann::json::parse(variant_json(c, false));
        auto& layers = json["bump"][0]["layers"];
        layers.push_back({{"kind", "noise"}, {"function", "perlin"}, {"frequency", 3}, {"strength", 0.05}});
        if (backwards) std::reverse(layers.begin(), layers.end());
        if (as_stages) {
            const nlohmann::json second = layers.back();
            layers.erase(layers.size() - 1);
            nlohmann::json stage;
            stage["layers"].push_back(second);
            json["bump"].push_back(stage);
        }
        DrawnKind kind(c, library());
        return kind.normals(Change::plain, json.dump());
    };
    const Picture first = draw(false);
    return numbers_of(angles_between(first, draw(true)).degrees);
}

class Order : public testing::TestWithParam<KindCase> {};

// Sums of gradients do not care for order but for the rounding of an addition. What is mixed in does: it
// replaces what stands before it, and nothing after.
TEST_P(Order, OfLayersDoesNotMatterWithinAStage) {
    const Numbers found = turned_round(GetParam(), false);
    fmt::print("{:28} {}\n", GetParam().name, text_of(found));
    if (GetParam().name == "mix")
        EXPECT_GT(found.median, 0.1);
    else
        EXPECT_LT(found.max, 4 * kUlp * kDegrees);
}
INSTANTIATE_TEST_SUITE_P(Kinds, Order, testing::ValuesIn(all_kind_cases()),
                         [](const auto& row) { return row.param.name; });
INSTANTIATE_TEST_SUITE_P(KindsWithoutHeights, Order, testing::ValuesIn(equal_kind_cases()),
                         [](const auto& row) { return row.param.name; });

// The control: as two stages order does matter, for the second stands on the first's normal.
TEST(Order, OfStagesMatters) {
    for (const KindCase& c : all_kind_cases()) {
        if (c.name != "normal_map" && c.name != "triplanar") continue;
        EXPECT_GT(turned_round(c, true).p95, 1e-3) << c.name;
    }
}

}  // namespace
}  // namespace sg::proof

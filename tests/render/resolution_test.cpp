// TBN-style strength depends neither on the picture's resolution nor on the camera's distance: the same point
// of the surface gets the same normal.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include "runtime/mesh/shapes.hpp"
#include "tests/render/truth.hpp"

namespace sg::truth {
namespace {

// Both uv sets with tangents from derivatives, whose size is what resolution and distance change.
// Orthographic, so that the camera's distance leaves every pixel on its point; textures have one level.
Case test_case(Eye eye) {
    Case c{"resolution", Shape::torus, {{.strength = 0.7}, {.uv = 1, .height = 1, .strength = 0.8}}};
    c.eye = eye;
    c.orthographic = true;
    return c;
}

// Pixel (x, y) of a picture against pixel (k x + k / 2, k y + k / 2) of one k times as large, k odd: one and
// the same point.
std::vector<double> differences(const runtime::Picture& small, const runtime::Picture& large,
                                std::uint32_t k) {
    std::vector<double> out;
    for (std::uint32_t y = 0; y < kPixels; ++y) {
        for (std::uint32_t x = 0; x < kPixels; ++x) {
            const std::uint32_t lx = k * x + k / 2, ly = k * y + k / 2;
            if (covered(small, x, y) != covered(large, lx, ly)) out.push_back(180);
            if (covered(small, x, y) && covered(large, lx, ly))
                out.push_back(angle_degrees(rgb(small, x, y), rgb(large, lx, ly)));
        }
    }
    return out;
}

// Facets of about two pixels, so that few points lie on a border: coordinates are snapped to 1/256 of a
// pixel, and where a smaller facet starts would depend on the size of the picture for some in a hundred
// points.
constexpr int kAround = 128, kAlong = 64, kFiner = 8;  // against the torus of the analytic cases
runtime::Scene coarse_scene(const Case& c) {
    runtime::Scene scene = scene_of(c);
    scene.content.meshes[0] = runtime::make_torus(kAround, kAlong, 1.0f, 0.4f, false);
    return scene;
}

// The two pictures see the same facet of the same surface through the same texel, so only rounding is left,
// of both (its bound is that of the finer facets: larger ones have a smaller one). A point on the border of
// two facets may fall to either in one picture: at most the whole tangent turn of a facet, twice.
void expect_within(const Percentiles& found, double arithmetic, double basis, const char* what) {
    fmt::print("{}: median {:.5f} p99 {:.5f} (bound {:.5f}) max {:.5f} (bound {:.5f}) of {}\n", what,
               found.median, found.p99, arithmetic, found.max, arithmetic + 2 * kFiner * basis, found.count);
    EXPECT_GT(found.count, 2000u);
    EXPECT_LE(found.median, arithmetic / 2) << what;
    EXPECT_LE(found.p99, arithmetic) << what;
    EXPECT_LE(found.max, arithmetic + 2 * kFiner * basis) << what;
}

TEST(Resolution, ThreeTimesThePixelsGiveTheSameNormals) {
    const Case c = test_case(Eye::front);
    const Made made = make_case(c, target::embedded_library());
    const runtime::Scene scene = coarse_scene(c);
    const runtime::Picture small = draw(made, scene, "normal", kPixels, kPixels);
    const runtime::Picture large = draw(made, scene, "normal", 3 * kPixels, 3 * kPixels);
    expect_within(percentiles(differences(small, large, 3)), 2 * bound_of(c).arithmetic, bound_of(c).basis,
                  "3x the pixels");
}

TEST(Resolution, FourTimesTheDistanceGivesTheSameNormals) {
    const Case near = test_case(Eye::front), far = test_case(Eye::far);
    const Made made = make_case(near, target::embedded_library());
    const runtime::Picture a = draw(made, coarse_scene(near), "normal", kPixels, kPixels);
    const runtime::Picture b = draw(made, coarse_scene(far), "normal", kPixels, kPixels);
    const double arithmetic = bound_of(near).arithmetic + bound_of(far).arithmetic;
    expect_within(percentiles(differences(a, b, 1)), arithmetic, bound_of(near).basis, "4x the distance");
}

}  // namespace
}  // namespace sg::truth

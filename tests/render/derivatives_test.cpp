// Screen derivatives on a plane: what the rasteriser's differences give (the debug views dpdx and dpdy,
// dFdxFine) against the analytic ones of ir/reference, for both kinds of camera, from both sides.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include "ir/reference/analytic_derivatives.hpp"
#include "runtime/camera.hpp"
#include "runtime/mesh/shapes.hpp"
#include "tests/render/workshop.hpp"

namespace sg::truth {
namespace {

constexpr std::uint32_t kSide = 64;

struct Row {
    std::string name;
    runtime::Camera camera;
};
std::ostream& operator<<(std::ostream& out, const Row& row) {
    return out << row.name;
}

const std::vector<Row> kRows = {
    {"facing", {.position = {0, 0, 3}, .target = {0, 0, 0}, .fov_degrees = 30}},
    {"slanted", {.position = {2, 1.5, 1.5}, .target = {0, 0, 0}, .fov_degrees = 40}},
    {"grazing", {.position = {2.6, 0, 0.35}, .target = {0, 0, 0}, .fov_degrees = 40}},
    {"from_behind", {.position = {-1.5, 1, -2}, .target = {0, 0, 0}, .fov_degrees = 40}},
    {"orthographic", {.position = {2, 1, 2}, .target = {0, 0, 0}, .ortho_height = 2.2}},
};

class Derivatives : public testing::TestWithParam<Row> {};

// Differences within a quad are taken between the centres of two pixels; the analytic derivative is that of
// one of them. Over one pixel a perspective derivative changes by about 2 |dpdx| / distance of itself: 64
// pixels over a view of 40 degrees make that 1 % at 3 units and more where the plane runs away from the eye.
// So each difference must lie within 1 % of the analytic derivative half a step beside it: at the middle
// between the two pixels.
TEST_P(Derivatives, OfTheRasteriserAreTheAnalyticOnes) {
    const Made made = make({R"({ "version": 1, "surface": { "two_sided": "mirror" } })", {}, {"debug"}});
    runtime::Scene scene;
    scene.content.meshes.push_back(runtime::make_plane(4, false));
    scene.content.instances.push_back({"plane", 0, glm::mat4(1.0f)});
    scene.camera = GetParam().camera;
    const runtime::Picture position = draw(made, scene, "position", kSide, kSide);
    const runtime::Picture dpdx = draw(made, scene, "dpdx", kSide, kSide),
                           dpdy = draw(made, scene, "dpdy", kSide, kSide);
    const auto matrices =
        runtime::camera_matrices(scene.camera, runtime::bounds_of(scene.content), kSide, kSide);

    double worst = 0;
    std::size_t count = 0;
    for (std::uint32_t y = 0; y + 1 < kSide; y += 2) {
        for (std::uint32_t x = 0; x + 1 < kSide; x += 2) {
            if (!covered(position, x, y) || !covered(position, x + 1, y) || !covered(position, x, y + 1))
                continue;
            const glm::dvec3 here = rgb(position, x, y);
            auto apart = [&](const runtime::Picture& found, glm::dvec3 there, bool across) {
                const auto exact =
                    ref::analytic_derivatives(0.5 * (here + there), {0, 0, 1}, matrices.relative_from_screen);
                const glm::dvec3 want = across ? exact.dpdx : exact.dpdy;
                worst = std::max(worst, glm::distance(rgb(found, x, y), want) / glm::length(want));
            };
            apart(dpdx, rgb(position, x + 1, y), true);
            apart(dpdy, rgb(position, x, y + 1), false);
            ++count;
        }
    }
    fmt::print("{}: at most {:.4f} % apart at {} quads\n", GetParam().name, 100 * worst, count);
    EXPECT_GT(count, 60u);
    EXPECT_LT(worst, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Cameras, Derivatives, testing::ValuesIn(kRows),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace sg::truth

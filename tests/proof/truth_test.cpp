// The truth against surfaces whose normals are known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "ir/reference/noise.hpp"
#include "runtime/proof/angles.hpp"
#include "tests/proof/subject.hpp"

namespace sg::proof {
namespace {

using glm::dvec2;
using glm::dvec3;
using runtime::SmoothShape;

constexpr double kTau = 6.283185307179586;
// Central differences with the step of truth.hpp are off by (2 pi h / L)^2 / 6 of the slope; heights here
// have no wave shorter than 1/8 and slopes below 2: 3e-9 rad. Rounding: 1e-16 / 1.5e-5 = 1e-11 rad for the
// first stage; for a second one the noise of the first normal, divided by the step, times the height: 1e-7.
constexpr double kFirst = 1e-6, kSecond = 1e-5;  // degrees

const char* const kNoise = R"({"version": 1, "bump": [{"layers": [
    {"kind": "noise", "function": "perlin", "frequency": 3, "strength": 0.1}]}]})";

ref::Noise noise_at(dvec3 p) {
    ref::Noise n = ref::noise_perlin(3.0 * p);
    return {0.1 * n.value, 0.3 * n.gradient};
}

// A height over a sphere moves it to (1 + H) d: its normal is (1 + H) d - grad_S H.
TEST(Truth, OfASphereInClosedForm) {
    Subject subject(kNoise);
    Truth truth = subject.truth(SmoothShape::sphere);
    for (const Glance& glance : glances(SmoothShape::sphere, 500, 1)) {
        const dvec3 d = glance.point + glance_camera().position;
        const ref::Noise n = noise_at(d);
        const dvec3 across = n.gradient - glm::dot(n.gradient, d) * d;
        const dvec3 expected = (1 + n.value) * d - across;
        const TrueNormal found = truth.at(glance.point, glance.pixel, glance.point);
        ASSERT_LT(angle_degrees(found.normal, expected), kFirst);
        ASSERT_GT(angle_degrees(found.normal, dvec3((1 + n.value) * d + across)) + 1e-3,
                  angle_degrees(found.normal, expected));
    }
}

// The graph of a function over the plane, and its mirror image from behind.
TEST(Truth, OfAPlaneOnBothSides) {
    for (const std::string side : {"off", "mirror", "flip"}) {
        std::string json = kNoise;
        json.insert(json.size() - 1, R"(, "surface": {"two_sided": ")" + side + "\"}");
        Subject subject(json);
        Truth truth = subject.truth(SmoothShape::plane);
        for (const Glance& glance : glances(SmoothShape::plane, 100, 2)) {
            const ref::Noise n = noise_at(glance.point + glance_camera().position);
            const dvec3 front(-n.gradient.x, -n.gradient.y, 1), back(-n.gradient.x, -n.gradient.y, -1);
            EXPECT_LT(angle_degrees(truth.at(glance.point, glance.pixel, glance.point).normal, front),
                      kFirst);
            if (side == "off") continue;
            const dvec3 behind = truth.at(glance.point, glance.pixel, -glance.point).normal;
            EXPECT_LT(angle_degrees(behind, side == "mirror" ? back : -front), kFirst) << side;
        }
    }
}

// A height in the world on a turned, stretched, mirrored sphere: its image is the ellipsoid x' A x = 1 moved
// along its own normal by H; its normal is -(normal derivative) by differences of a few thousandths.
TEST(Truth, OfAPlacedSphere) {
    glm::dmat4 world = glm::rotate(glm::dmat4(1), 0.7, glm::normalize(dvec3(1, 2, 3)));
    world = glm::scale(world, dvec3(-1.2, 0.7, 1.0));
    Subject subject(R"({"version": 1, "bump": [{"layers": [
        {"kind": "noise", "function": "perlin", "space": "world", "frequency": 2, "strength": 0.05}]}]})");
    Truth truth = subject.truth(SmoothShape::sphere, world);
    const glm::dmat3 linear(world), normals = glm::transpose(glm::inverse(linear));
    auto displaced = [&](dvec3 d) {
        const dvec3 p = linear * glm::normalize(d);
        return p + 0.05 * ref::noise_perlin(2.0 * p).value * glm::normalize(normals * glm::normalize(d));
    };
    for (const Glance& glance : glances(SmoothShape::sphere, 200, 3)) {
        const dvec3 d = glance.point + glance_camera().position;
        const dvec3 a = glm::normalize(glm::cross(d, dvec3(0.3, 0.8, -0.5))), b = glm::cross(d, a);
        const double h = 1e-4;
        dvec3 expected = glm::cross(displaced(d + h * a) - displaced(d - h * a),
                                    displaced(d + h * b) - displaced(d - h * b));
        expected *= glm::dot(expected, normals * d) < 0 ? -1 : 1;
        const dvec3 point = linear * d - glance_camera().position;
        // A pixel that is seen edge-on covers so much that noise fades out.
        if (std::abs(glm::dot(glm::normalize(point), glm::normalize(normals * d))) < 0.1) continue;
        // Differences of 1e-4: (2 pi 2e-4)^2 / 6 of the slope.
        EXPECT_LT(angle_degrees(truth.at(point, glance.pixel, point).normal, expected), 1e-4);
    }
}

// A second stage of constant height makes a parallel surface, which has the first one's normals.
TEST(Truth, OfAChainThatEndsInAParallelSurface) {
    std::string json = kNoise;
    json.replace(json.find("]}]"), 3, R"(]}, {"layers": [{"kind": "height_map", "texture": "flat"}]}])");
    json.insert(1, R"("textures": {"flat": {"file": "any.png", "encoding": "height"}}, )");
    Subject chain(json, {{"flat", [](dvec2) { return ref::dvec4(0.04); }}}), first(kNoise);
    Truth of_chain = chain.truth(SmoothShape::torus), of_first = first.truth(SmoothShape::torus);
    for (const Glance& glance : glances(SmoothShape::torus, 200, 4)) {
        EXPECT_LT(angle_degrees(of_chain.at(glance.point, glance.pixel, glance.point).normal,
                                of_first.at(glance.point, glance.pixel, glance.point).normal),
                  kSecond);
    }
}

// Weights are part of the height unless they are held: H = w h has the gradient w grad h + h grad w.
TEST(Truth, WeightsVaryUnlessHeld) {
    Subject subject(R"({"version": 1, "nodes": {"half": {"op": "multiply", "a": {"op": "height"}, "b": 0.4},
        "w": {"op": "add", "a": "@half", "b": 0.5}}, "bump": [{"layers": [
        {"kind": "noise", "function": "perlin", "frequency": 3, "strength": 0.1, "mask": "@w"}]}]})");
    Truth truth = subject.truth(SmoothShape::plane);
    for (const Glance& glance : glances(SmoothShape::plane, 100, 5)) {
        const dvec3 p = glance.point + glance_camera().position;
        const ref::Noise n = noise_at(p);
        const double w = 0.5 + 0.4 * p.y;
        const TrueNormal found = truth.at(glance.point, glance.pixel, glance.point, true);
        const dvec3 held(-w * n.gradient.x, -w * n.gradient.y, 1);
        EXPECT_LT(angle_degrees(found.held, held), kFirst);
        EXPECT_LT(angle_degrees(found.normal, held - dvec3(0, 0.4 * n.value, 0)), kFirst);
    }
}

// Heights between texels go through the texels, with the slope of central differences at them.
TEST(Heights, SmoothHeightGoesThroughTheTexels) {
    FunctionTexture wave([](dvec2 st) { return ref::dvec4(std::sin(kTau * 3 * st.x) * st.y); });
    wave.side = 32;
    ir::Sampled sampled;
    sampled.texels = &wave;
    auto at = [&](double x, double y) { return smooth_height(sampled, {dvec2(x, y) / 32.0, {}, {}}); };
    for (int x = 2; x < 30; ++x) {
        EXPECT_NEAR(at(x + 0.5, 7.5), wave.fetch({x, 7}, 0).x, 1e-12);
        EXPECT_NEAR((at(x + 0.5 + 1e-6, 7.5) - at(x + 0.5 - 1e-6, 7.5)) / 2e-6,
                    (wave.fetch({x + 1, 7}, 0).x - wave.fetch({x - 1, 7}, 0).x) / 2, 1e-6);
    }
}

// Each operation on the way from a texture or a noise to a surface gradient says what its height is, or why
// it has none.
TEST(Heights, EveryOperationHasARow) {
    std::map<ir::Op, int> rows;
    for (const HeightRow& row : all_height_rows()) ++rows[row.op];
    using enum ir::Type;
    for (const ir::OpInfo& op : ir::all_ops()) {
        const bool bump = op.result == Deriv || op.result == DerivPair || op.result == MapNormal ||
                          op.result == LocalGrad || op.result == VolGrad || op.result == SurfGrad ||
                          op.result == TangentNormal || op.result == TangentNormalXy ||
                          op.result == Direction || op.result == ObjectDirection || op.result == Noise ||
                          op.result == Texel;
        EXPECT_EQ(rows[op.op], bump ? 1 : 0) << op.name;
    }
}

}  // namespace
}  // namespace sg::proof

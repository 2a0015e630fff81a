// The reference itself: its derivatives against finite differences, its inverses against its positions.
#include "tests/render/exact.hpp"

#include <gtest/gtest.h>

namespace sg::truth {
namespace {

constexpr double kStep =
    1e-5;  // central differences: truncation ~ step^2 * third derivative ~ 1e-7, rounding ~ 1e-11
constexpr double kNear = 2e-6;

const std::vector<glm::dvec2> kPlaces = {{0.13, 0.21}, {0.37, 0.83}, {0.61, 0.44}, {0.92, 0.67}};

TEST(Exact, SurfacesHaveTheirDerivativesNormalsAndInverses) {
    for (Shape shape : {Shape::plane, Shape::sphere, Shape::torus, Shape::cylinder}) {
        const Surface surface{shape};
        for (glm::dvec2 st : kPlaces) {
            const glm::dvec2 ds(kStep, 0), dt(0, kStep);
            const glm::dvec3 s = (surface.position(st + ds) - surface.position(st - ds)) / (2 * kStep);
            const glm::dvec3 t = (surface.position(st + dt) - surface.position(st - dt)) / (2 * kStep);
            EXPECT_LT(glm::distance(s, surface.along_s(st)), kNear);
            EXPECT_LT(glm::distance(t, surface.along_t(st)), kNear);
            EXPECT_LT(glm::distance(glm::normalize(glm::cross(t, s)), surface.normal(st)), kNear);
            EXPECT_NEAR(glm::dot(surface.along_s(st), surface.along_t(st)), 0, 1e-12);
            EXPECT_LT(glm::distance(surface.inverse(surface.position(st)), st), 1e-12);
            EXPECT_LT(glm::distance(surface.inverse(surface.position(st) - 0.01 * surface.normal(st)), st),
                      1e-12);
        }
    }
}

TEST(Exact, HeightsHaveTheirGradients) {
    const Height plain{{{0.03, 2, 1, 0.4}, {0.02, 1, -2, 1.1}}, -1};
    for (int taper : {-1, 0, 1}) {
        const Height height{plain.waves, taper};
        for (Chart chart : {Chart{0}, Chart{1}, Chart{0, Unwrap::mirrored}, Chart{0, Unwrap::folded}}) {
            for (glm::dvec2 tiling : {glm::dvec2(1, 1), glm::dvec2(-3, 3)}) {
                const Bump bump{height, chart, tiling, -0.7};
                auto value = [&](glm::dvec2 st) {
                    return bump.strength * bump.height.value(tiling * bump.chart.from_surface(st)) /
                           std::abs(tiling.x);
                };
                for (glm::dvec2 st : kPlaces) {
                    const glm::dvec2 ds(kStep, 0), dt(0, kStep);
                    const glm::dvec2 found((value(st + ds) - value(st - ds)) / (2 * kStep),
                                           (value(st + dt) - value(st - dt)) / (2 * kStep));
                    EXPECT_LT(glm::distance(found, height_gradient(bump, st)), kNear);
                }
            }
        }
    }
}

// The resolved normal is that of the surface P + H n for small H: cross products of differences, to first
// order in H.
TEST(Exact, BumpedNormalsAreThoseOfTheDisplacedSurface) {
    constexpr double kTiny = 1e-4;  // of the heights; the neglected terms are H times curvature, 1e-6
    for (Shape shape : {Shape::plane, Shape::sphere, Shape::torus, Shape::cylinder}) {
        const Surface surface{shape};
        const Bump bump{{{{0.03, 2, 1, 0.4}, {0.02, 1, -2, 1.1}}, -1}, {}, {1, 1}, kTiny};
        auto moved = [&](glm::dvec2 st) {
            return surface.position(st) + kTiny * bump.height.value(st) * surface.normal(st);
        };
        for (glm::dvec2 st : kPlaces) {
            const glm::dvec2 ds(kStep, 0), dt(0, kStep);
            const glm::dvec3 expected =
                glm::cross(moved(st + dt) - moved(st - dt), moved(st + ds) - moved(st - ds));
            const glm::dvec3 found = bumped_normal(surface, {bump}, surface.position(st), Side::front);
            EXPECT_LT(glm::distance(glm::normalize(expected), found) / kTiny, 0.01)
                << static_cast<int>(shape);
        }
    }
}

// A placement that turns, mirrors and scales evenly moves the whole picture of the surface with it.
TEST(Exact, BumpedNormalsGoAlongWithAnEvenPlacement) {
    const glm::dmat3 turn(glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0),
                          glm::dvec3(0, -1, 0));  // and a reflection
    for (Shape shape : {Shape::plane, Shape::sphere, Shape::torus}) {
        const Surface surface{shape};
        const Bump bump{{{{0.03, 2, 1, 0.4}, {0.02, 1, -2, 1.1}}, -1}, {}, {1, 1}, 1};
        for (glm::dvec2 st : kPlaces) {
            const glm::dvec3 point = surface.position(st);
            const glm::dvec3 expected = turn * bumped_normal(surface, {bump}, point, Side::mirror);
            EXPECT_LT(
                glm::distance(bumped_normal(surface, {bump}, point, Side::mirror, 3.0 * turn), expected),
                1e-12);
        }
    }
}

}  // namespace
}  // namespace sg::truth

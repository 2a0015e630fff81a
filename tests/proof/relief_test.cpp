// The truth behind parallax against surfaces that are known in closed form: where a ray meets them, and their
// normal there.
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
// A hit is halved down to 1e-9 of the relief; slopes are those of truth_test.cpp.
constexpr double kExact = 1e-5;  // degrees

std::string material(double strength, double zero_level, const std::string& more = "") {
    return R"({"version": 1, "textures": {"h": {"file": "any.png", "encoding": "height"}}, "bump": [
        {"parallax": {"kind": "occlusion", "texture": "h", "strength": )" +
           std::to_string(strength) + R"(, "zero_level": )" + std::to_string(zero_level) +
           R"(}, "layers": [{"kind": "height_map", "texture": "h", "strength": )" + std::to_string(strength) +
           "}]}" + more + "]}";
}

std::map<std::string, std::function<ref::dvec4(dvec2)>> level(double value) {
    return {{"h", [value](dvec2) { return ref::dvec4(value); }}};
}

// A level height makes a sphere of a sphere; rays that pass the smaller one see nothing.
TEST(Relief, OfASphereIsASphere) {
    const dvec3 eye = glance_camera().position;
    struct Row {
        double strength, zero, texel;
    };
    for (const Row& row : {Row{0.2, 0.75, 0.25}, Row{0.2, 0, 0.5}, Row{-0.3, 1, 0.5}}) {
        Subject subject(material(row.strength, row.zero), level(row.texel));
        Truth truth = subject.truth(SmoothShape::sphere);
        ASSERT_FALSE(truth.missing());
        const double radius = 1 + row.strength * (row.texel - row.zero);
        std::size_t hits = 0, misses = 0;
        for (const Glance& glance : glances(SmoothShape::sphere, 300, 1)) {
            const dvec3 ray = glm::normalize(glance.point);
            const double middle = glm::dot(-eye, ray),
                         under = radius * radius - glm::dot(eye, eye) + middle * middle;
            const TrueNormal found = truth.at(glance.point, glance.pixel, glance.point);
            if (under < -1e-6) {
                EXPECT_EQ(found.normal, dvec3(0));
            }
            if (under < 1e-6) ++misses;
            if (under < 1e-6) continue;
            ++hits;
            const dvec3 hit = eye + (middle - std::sqrt(under)) * ray;
            ASSERT_LT(angle_degrees(found.normal, hit), kExact) << radius;
            EXPECT_NEAR(found.moved, std::abs(radius - 1), 1e-9);
        }
        EXPECT_GT(hits, 200u);
        if (radius < 0.9) {
            EXPECT_GT(misses, 5u);
        }
    }
}

// Waves over a plane: the first crossing of a ray that is looked at in 20,000 places.
TEST(Relief, OfAPlaneHidesWhatLiesBehindItsWaves) {
    auto wave = [](double s) { return 0.5 + 0.5 * std::sin(kTau * 6 * s); };
    Subject subject(material(0.15, 0.5), {{"h", [&](dvec2 st) { return ref::dvec4(wave(st.x)); }}});
    const dvec3 eye(-3, 0.1, 1);
    const runtime::Camera camera{eye, dvec3(0), 30, 0};
    const auto matrices = camera_matrices(camera, {dvec3(-1), dvec3(1), dvec3(0), 1.5}, 4096, 4096);
    Truth truth =
        subject.truth(Sight{SmoothShape::plane, glm::dmat4(1), eye, matrices.relative_from_screen, 0});
    std::size_t hidden = 0;
    for (int i = 0; i < 200; ++i) {
        const dvec3 seen(-0.9 + 0.009 * i, 0.05 * std::sin(i), 0), ray = glm::normalize(seen - eye);
        auto gap = [&](double t) {
            const dvec3 p = seen + t * ray;
            return p.z - 0.15 * (wave((p.x + 1) / 2) - 0.5);
        };
        const double start = -0.0751 / -ray.z, step = 2 * 0.0751 / -ray.z / 20000;
        double t = start;
        while (gap(t) > 0) t += step;
        const dvec3 hit = seen + t * ray;
        // Where the ray only grazes a crest a step decides whether it is met.
        const double slope = 0.15 * 0.5 * kTau * 3 * std::cos(kTau * 6 * (hit.x + 1) / 2);
        const dvec3 expected = glm::normalize(dvec3(-slope, 0, 1));
        const dvec3 point = seen - eye;
        const glm::dvec4 clip = matrices.clip_from_relative * glm::dvec4(point, 1);
        const dvec2 pixel = (dvec2(clip) / clip.w + 1.0) * 2048.0;
        const dvec3 found = truth.at(point, pixel, point).normal;
        if (std::abs(glm::dot(expected, ray)) < 0.03) continue;
        // A step of the scan turns the normal by as much as the wave bends over it.
        EXPECT_LT(angle_degrees(found, expected), 0.05) << i;
        const double below = 0.15 * 0.5 * kTau * 3 * std::cos(kTau * 6 * (seen.x + 1) / 2);
        hidden += angle_degrees(dvec3(-below, 0, 1), expected) > 5 ? 1 : 0;
    }
    EXPECT_GT(hidden, 100u);  // without parallax the answer would be another
}

// The offset surface of an ellipsoid: its normal tells the point of the ellipsoid, from which the ray is h
// away.
TEST(Relief, OfAPlacedSphereLiesOnItsRay) {
    glm::dmat4 world = glm::rotate(glm::dmat4(1), 0.7, glm::normalize(dvec3(1, 2, 3)));
    world = glm::scale(world, dvec3(-1.2, 0.7, 1.0));
    Subject subject(material(0.2, 1), level(0.5));
    Truth truth = subject.truth(SmoothShape::sphere, world);
    const glm::dmat3 linear(world);
    std::size_t hits = 0;
    for (const Glance& glance : glances(SmoothShape::sphere, 200, 3)) {
        const dvec3 eye = glance_camera().position, point = linear * (glance.point + eye) - eye;
        if (glm::dot(glm::transpose(glm::inverse(linear)) * (glance.point + eye), point) > 0) continue;
        const TrueNormal found = truth.at(point, glance.pixel, point);
        if (found.normal == dvec3(0)) continue;
        // The ellipsoid's point of that normal: M M^T n / |M^T n|.
        const dvec3 local = glm::transpose(linear) * found.normal;
        const dvec3 hit = linear * glm::normalize(local) - 0.1 * found.normal - eye;
        EXPECT_LT(glm::length(glm::cross(hit, glm::normalize(point))), 1e-6);
        ++hits;
    }
    EXPECT_GT(hits, 80u);
}

// A second stage on a volume is looked up on the surface that is seen, here a plane that lies deeper.
TEST(Relief, CarriesTheStagesBehindIt) {
    const double depth = 0.3;
    Subject subject(material(2 * depth, 1, R"(, {"layers": [{"kind": "noise", "function": "perlin",
        "space": "world", "frequency": 3, "strength": 0.1}]})"),
                    level(0.5));
    Truth truth = subject.truth(SmoothShape::plane);
    const dvec3 eye = glance_camera().position;
    double least = 180;
    for (const Glance& glance : glances(SmoothShape::plane, 100, 5)) {
        const dvec3 hit = eye + glance.point * ((eye.z + depth) / -glance.point.z);
        const dvec3 g = 0.3 * ref::noise_perlin(3.0 * hit).gradient;
        const dvec3 found = truth.at(glance.point, glance.pixel, glance.point).normal;
        EXPECT_LT(angle_degrees(found, dvec3(-g.x, -g.y, 1)), 1e-4);
        const dvec3 mesh = 0.3 * ref::noise_perlin(3.0 * (eye + glance.point)).gradient;
        least = std::min(least, angle_degrees(found, dvec3(-mesh.x, -mesh.y, 1)));
    }
    EXPECT_GT(least, 1e-3);
}

// What has no truth says why.
TEST(Relief, IsMissingWhereNothingIsKnown) {
    const std::string tangents =
        R"({"version": 1, "textures": {"h": {"file": "any.png", "encoding": "parallax_map"}},
        "bump": [{"parallax": {"kind": "steps", "texture": "h", "strength": 0.1}, "layers": [
        {"kind": "noise", "function": "perlin", "strength": 0}]}]})";
    Subject without(tangents);
    Truth none = without.truth(SmoothShape::plane);
    ASSERT_TRUE(none.missing());
    EXPECT_STREQ(none.missing()->why,
                 "it holds tangent planes, and the heights that it was baked from are not given");
    EXPECT_EQ(without.module().at(none.missing()->value).op, ir::Op::parallax_steps);
    Subject with(tangents);
    with.give_partner(
        "h", [](dvec2) { return 0.75; }, 0.2);
    Truth known = with.truth(SmoothShape::sphere);
    EXPECT_FALSE(known.missing());
    // 0.2 (0.75 - 1/2) above the sphere.
    const dvec3 eye = glance_camera().position;
    for (const Glance& glance : glances(SmoothShape::sphere, 20, 1)) {
        const dvec3 ray = glm::normalize(glance.point);
        const double middle = glm::dot(-eye, ray);
        const dvec3 hit =
            eye + (middle - std::sqrt(1.05 * 1.05 - glm::dot(eye, eye) + middle * middle)) * ray;
        EXPECT_LT(angle_degrees(known.at(glance.point, glance.pixel, glance.point).normal, hit), kExact);
    }
}

}  // namespace
}  // namespace sg::proof

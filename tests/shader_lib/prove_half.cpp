// Letter J: derivatives, slopes and gradients stored as 16-bit floats (a round trip through packHalf2x16,
// which is what lavapipe's ignorance of mediump would hide), read again and resolved.
//
// h = 2^-11 is half a unit in the last place of a 16-bit float. Stored slopes are off by h of their size; a
// resolve turns that into an angle of at most h |g| / (1 + |g|^2) times |g|'s own share, so that h stays the
// bound, whatever the slope.
#include "draws.hpp"
#include "ir/reference/deriv.hpp"
#include "ir/reference/from_normal.hpp"
#include "ir/reference/from_volume.hpp"
#include "ir/reference/resolve.hpp"

namespace sg::proof {
namespace {

constexpr double kHalfUlp = 1.0 / (1 << 11);
constexpr const char* kHalf = R"(
vec2 half_of(vec2 v) { return unpackHalf2x16(packHalf2x16(v)); }
vec3 half_of(vec3 v) { return vec3(half_of(v.xy), half_of(v.zz).x); }
)";

std::vector<Case> cases() {
    return {
        {.name = "half_deriv",
         .blunt = "stored in 16 bits",
         .include = "surfgrad/deriv.glsl surfgrad/tbn.glsl surfgrad/resolve.glsl",
         .inputs = 3,
         .outputs = 3,
         .glsl = "vec2 d = half_of(sg_deriv_clamped(sg_deriv_from_normal_xyz(v3(0))));"
                 "SgBasis level = SgBasis(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0));"
                 "put(0, sg_resolve(vec3(0.0, 0.0, 1.0), sg_surfgrad_from_tbn(d, level)));",
         .draw = [](Random& random, Draw& in) { in.put(0, random.direction()); },
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::normal_from_deriv(ref::deriv_from_normal_xyz(in.v3(0))));
             },
         // Slopes below 2^-14 are denormal, off by 2^-25 in all.
         .bound = {.absolute = 2.0 * kHalfUlp},
         .property = unit,
         .declarations = kHalf},
        {.name = "half_gradient_from_normal",
         .blunt = "stored in 16 bits",
         .include = "surfgrad/from_normal.glsl surfgrad/resolve.glsl",
         .inputs = 6,
         .outputs = 3,
         .glsl = "put(0, sg_resolve(v3(0), half_of(sg_surfgrad_from_normal(v3(0), v3(3)))));",
         .draw = [](Random& random,
                    Draw& in) { in.put(0, random.direction()), in.put(3, random.direction()); },
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::resolve(in.v3(0), ref::surfgrad_from_normal(in.v3(0), in.v3(3))));
             },
         // Three components, each off by h of its size: sqrt(3) h of the length; doubled for the rounded n.
         .bound = {.absolute = 4.0 * kHalfUlp},
         .property = [](const In&, const In& out) { return is_unit(out.v3(0)) ? "" : "not unit"; },
         .declarations = kHalf},
        {.name = "half_gradient_from_volume",
         .include = "surfgrad/from_volume.glsl surfgrad/resolve.glsl",
         .inputs = 6,
         .outputs = 3,
         // 16384 is within the range of 16 bits: the cut gradient survives storing where the raw one is
         // endless.
         .glsl = "put(0, sg_resolve(v3(0), half_of(sg_surfgrad_from_volume(v3(0), v3(3)))));",
         .draw =
             [](Random& random, Draw& in) {
                 in.put(0, random.direction()), in.put(3, random.direction() * random.magnitude(1e-2, 1e8));
             },
         .property =
             [](const In& in, const In& out) {
                 if (!is_unit(out.v3(0))) return "not unit";
                 // |g| h along n, over |g|.
                 return glm::dot(out.v3(0), in.v3(0)) >= -2.0 * kHalfUlp ? "" : "inward";
             },
         .mutants = {{"surfgrad/from_volume.glsl",
                      "return sg_reject(SG_MAX_VOLUME_GRADIENT / largest * gradient, n);",
                      "return 10.0 * SG_MAX_VOLUME_GRADIENT / largest * gradient;"}},
         .declarations = kHalf},
    };
}

SG_PROVE(HalfStorage, cases());

// What the references assert: neither pow nor normalize may leave its domain, whatever a driver makes of it.
TEST(CheckedDeathTest, NormalizeOfZeroAndPowOfNothingPositiveEndTheReference) {
    testing::GTEST_FLAG(death_test_style) = "threadsafe";
    EXPECT_EXIT(ref::normalized(glm::dvec3(0.0)), testing::ExitedWithCode(3), "assertion failed");
    EXPECT_EXIT(ref::normalized(glm::dvec3(std::nan(""), 0.0, 1.0)), testing::ExitedWithCode(3),
                "assertion failed");
    EXPECT_EXIT(ref::power(0.0, 0.0), testing::ExitedWithCode(3), "assertion failed");
    EXPECT_EXIT(ref::power(-0.2, 3.0), testing::ExitedWithCode(3), "assertion failed");
    EXPECT_EXIT(ref::root(-1e-9), testing::ExitedWithCode(3), "assertion failed");
}

}  // namespace
}  // namespace sg::proof

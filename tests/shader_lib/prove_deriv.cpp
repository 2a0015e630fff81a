// Tangent-space normals and derivatives (shader_lib/surfgrad/deriv.glsl) against double precision.
#include "harness.hpp"
#include "ir/reference/deriv.hpp"
#include "published.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/deriv.glsl";

void draw_tangent_normal(Random& random, Draw& in) {
    glm::dvec3 m = random.direction() * random.magnitude(1e-3, 1.0);
    if (random.below(4) == 0) m.z *= random.magnitude(1e-6, 1.0);  // steep: some beyond the clamp
    in.put(0, m);
}

std::string within_slope(const In&, const In& out) {
    const double limit = ref::kMaxSlope * (1.0 + 4.0 * kUlp);
    return std::abs(out[0]) <= limit && std::abs(out[1]) <= limit ? "" : "beyond 128";
}

std::vector<Case> cases() {
    const std::string kVec2 = "vec2 texel, float zero) {\n    return ";
    const std::string kVec3 = "vec3 texel, float zero) {\n    return ";
    const std::string kExact =
        "zero == 127.5 ? 2.0 * texel - 1.0 : clamp((255.0 * texel - zero) / min(zero, 255.0 - zero)";
    return {
        {.name = "decode_signed",
         .include = kFile,
         .inputs = 4,
         .outputs = 5,
         .glsl = "put(0, sg_decode_signed(v2(0), f(3))); put(2, sg_decode_signed(v3(0), f(3)));",
         .draw =
             [](Random& random, Draw& in) {
                 for (std::size_t k = 0; k < 3; ++k) in.put(k, random.uniform(0.0, 1.0));
                 in.put(3, 127.0 + 0.5 * random.below(3));
             },
         .reference =
             [](const In& in, Expect& out) {
                 for (std::size_t k = 0; k < 5; ++k)
                     out.put(k, ref::decode_signed(in[k < 2 ? k : k - 2], in[3]));
             },
         // 255 texel rounds at 255 u, the difference loses it to the zero code: 255 u / 127, twice for the
         // doubling.
         .bound = {.absolute = 6 * kUlp, .relative = 4 * kUlp},
         .mutants = {{kFile, kVec2 + kExact,
                      kVec2 + "zero == 127.5 ? 2.0 * texel - 1.0 : clamp((255.0 * texel - zero) / 127.5"},
                     {kFile, kVec3 + "zero == 127.5 ? 2.0 * texel - 1.0 : clamp((255.0 * texel - zero)",
                      kVec3 + "zero == 127.5 ? 2.0 * texel - 1.0 : clamp((255.0 * texel - 127.5)"},
                     {kFile, kVec3 + "zero == 127.5 ? 2.0 * texel - 1.0",
                      kVec3 + "zero == 127.5 ? 2.0 * texel"}}},
        {.name = "deriv_from_normal_xyz",
         .include = kFile,
         .inputs = 3,
         .outputs = 2,
         .glsl = "put(0, sg_deriv_from_normal_xyz(v3(0)));",
         .draw = draw_tangent_normal,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::deriv_from_normal_xyz(in.v3(0))); },
         // Two divisions.
         .bound = {.absolute = 1e-30, .relative = 4 * kUlp},
         .property = within_slope,
         .mutants = {{kFile, "vec3 magnitude = abs(m);", "vec3 magnitude = vec3(abs(m.xy), m.z);"},
                     {kFile, "max(magnitude.x, magnitude.y) / SG_MAX_SLOPE", "magnitude.x / SG_MAX_SLOPE"}}},
    };
}

void draw_derivative(Random& random, Draw& in) {
    in.put(0, glm::dvec2(random.sign() * random.magnitude(1e-4, 128.0),
                         random.sign() * random.magnitude(1e-4, 128.0)));
    in.put(2, random.magnitude(0.25, 128.0));
}

std::vector<Case> conversion_cases() {
    return {
        {.name = "deriv_from_normal_xy",
         .include = kFile,
         .inputs = 2,
         .outputs = 2,
         .glsl = "put(0, sg_deriv_from_normal_xy(v2(0)));",
         .draw =
             [](Random& random, Draw& in) {
                 // Up to length sqrt(2): channels of -1..1 that no unit vector has.
                 const double length = random.coin() ? random.uniform(0.0, 1.0)
                                                     : 1.0 - random.sign() * random.magnitude(1e-6, 0.4);
                 in.put(0, random.direction2() * length);
             },
         .reference = [](const In& in, Expect& out) { out.put(0, ref::deriv_from_normal_xy(in.v2(0))); },
         // The inverse root (2) and the product (1).
         .bound = {.absolute = 1e-30, .relative = 6 * kUlp},
         // 1 - x^2 - y^2 loses 4 roundings of 1: z^2 is known to 4 u / z^2, half of it reaches the root.
         .condition =
             [](const In& in) {
                 const double left =
                     std::max(1.0 - glm::dot(in.v2(0), in.v2(0)), 1.0 / (ref::kMaxSlope * ref::kMaxSlope));
                 return 1.0 / left;
             },
         .mutants = {{kFile, "1.0 / (SG_MAX_SLOPE * SG_MAX_SLOPE)", "1e-7"},
                     {kFile, "inversesqrt(max(1.0 - dot(m, m)", "(1.0 / max(1.0 - dot(m, m)"}}},
        {.name = "deriv_green_up",
         .include = kFile,
         .inputs = 3,
         .outputs = 2,
         .glsl = "put(0, sg_deriv_green_up(v2(0)));",
         .draw = draw_derivative,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::deriv_green_up(in.v2(0))); },
         .bound = {.absolute = 1e-30}},  // a sign
        {.name = "normal_from_deriv",
         .include = kFile,
         .inputs = 3,
         .outputs = 3,
         .glsl = "put(0, sg_normal_from_deriv(v2(0)));",
         .draw = draw_derivative,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::normal_from_deriv(in.v2(0))); },
         .bound = {.absolute = 12 * kUlp},  // a normalisation
         .property = [](const In&, const In& out) { return is_unit(out.v3(0)) ? "" : "not unit"; },
         .mutants = {{kFile, "normalize(vec3(-d, 1.0))", "vec3(-d, 1.0)"}}},
        {.name = "normal_from_deriv_is_the_inverse",
         .include = kFile,
         .inputs = 3,
         .outputs = 2,
         .glsl = "put(0, sg_deriv_from_normal_xyz(sg_normal_from_deriv(v2(0))));",
         .draw = draw_derivative,
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, in.v2(0) * std::min(1.0, 128.0 / std::max(std::abs(in[0]), std::abs(in[1]))));
             },
         .bound = {.absolute = 1e-30,
                   .relative = 10 * kUlp}},  // products with one inverse root, which cancels, and a division
    };
}

std::vector<Case> stored_cases() {
    return {
        {.name = "deriv_clamped",
         .include = kFile,
         .inputs = 2,
         .outputs = 2,
         .glsl = "put(0, sg_deriv_clamped(v2(0)));",
         .draw = [](Random& random, Draw& in) { in.put(0, random.wild()), in.put(1, random.wild()); },
         .reference = [](const In& in, Expect& out) { out.put(0, ref::deriv_clamped(in.v2(0))); },
         .bound = {.absolute = 1e-37},  // copies; what is below 1e-38 may vanish
         .property = within_slope,
         // Lavapipe's clamp takes not-a-number to its lower end (toolchain.md 6).
         .mutants = {{kFile, "vec2(number.x ? clamp(d.x, -SG_MAX_SLOPE, SG_MAX_SLOPE) : 0.0",
                      "vec2(clamp(d.x, -SG_MAX_SLOPE, SG_MAX_SLOPE)"},
                     {kFile, "number.y ? clamp(d.y, -SG_MAX_SLOPE, SG_MAX_SLOPE) : 0.0",
                      "number.y ? d.y : 0.0"}}},
        {.name = "deriv_from_map",
         .include = kFile,
         .inputs = 3,
         .outputs = 2,
         .glsl = "put(0, sg_deriv_from_map(v2(0), f(2)));",
         .draw =
             [](Random& random, Draw& in) {
                 in.put(0, glm::dvec2(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)));
                 in.put(2, random.magnitude(0.25, 256.0));
             },
         .reference = [](const In& in, Expect& out) { out.put(0, ref::deriv_from_map(in.v2(0), in[2])); },
         .bound = {.absolute = 1e-30, .relative = 2 * kUlp},  // one product
         .property = within_slope,
         .mutants = {{kFile, "sg_deriv_clamped(value * range)", "sg_deriv_clamped(value)"},
                     {kFile, "sg_deriv_clamped(value * range)", "value * range"}}},
        {.name = "map_from_deriv",
         .include = kFile,
         .inputs = 3,
         .outputs = 2,
         .glsl = "put(0, sg_map_from_deriv(v2(0), f(2)));",
         .draw = draw_derivative,
         .reference = [](const In& in, Expect& out) { out.put(0, ref::map_from_deriv(in.v2(0), in[2])); },
         .bound = {.absolute = 1e-30, .relative = 2 * kUlp},  // one division
         .mutants = {{kFile, "clamp(d / range, -1.0, 1.0)", "d / range"},
                     {kFile, "clamp(d / range, -1.0, 1.0)", "clamp(d * range, -1.0, 1.0)"}}},
    };
}

std::vector<Case> other_cases() {
    return joined(conversion_cases(), stored_cases());
}

// Every 8-bit texel and every zero code, not a sample of them.
TEST(DerivEdges, EveryTexelDecodesToItsCodeOverItsRange) {
    const Case item = {.name = "codes",
                       .include = kFile,
                       .inputs = 2,
                       .outputs = 2,
                       .glsl = "put(0, sg_decode_signed(vec2(f(0) / 255.0), f(1)));"};
    for (const auto& [zero, range] : {std::pair{127.5, 127.5}, {128.0, 127.0}, {127.0, 127.0}}) {
        std::vector<float> inputs;
        for (int code = 0; code < 256; ++code)
            inputs.insert(inputs.end(), {static_cast<float>(code), static_cast<float>(zero)});
        const std::vector<float> got = evaluate(item, inputs);
        for (int code = 0; code < 256; ++code) {
            // The bound of the case decode_signed.
            EXPECT_NEAR(got[static_cast<std::size_t>(2 * code)], std::clamp((code - zero) / range, -1.0, 1.0),
                        10 * kUlp)
                << code;
        }
    }
}

TEST(DerivEdges, TheCommonFlatTexelLeansByAFifthOfADegreeUnlessItsZeroIs128) {
    const Case item = {.name = "flat",
                       .include = kFile,
                       .inputs = 4,
                       .outputs = 2,
                       .glsl = "put(0, sg_deriv_from_normal_xyz(sg_decode_signed(v3(0) / 255.0, f(3))));"};
    const std::vector<float> d =
        evaluate(item, std::vector<float>{128, 128, 255, 127.5f, 128, 128, 255, 128});
    EXPECT_NEAR(std::atan(d[0]) * 57.29578, -0.22, 0.005);
    EXPECT_NEAR(std::atan(std::hypot(d[0], d[1])) * 57.29578, 0.32, 0.005);
    EXPECT_EQ(d[2], 0.0f);
}

std::vector<float> deriv_of(std::vector<float> m) {
    return evaluate(cases()[1], m);
}

TEST(DerivEdges, ZeroHeightOfTheNormalIsSteepestInTheLargerComponent) {
    EXPECT_EQ(deriv_of({0.5f, 0.25f, 0.0f}), (std::vector<float>{-128, -64}));
    EXPECT_EQ(deriv_of({-0.25f, 1.0f, 0.0f}), (std::vector<float>{32, -128}));
}

TEST(DerivEdges, InwardCountsAsOutward) {
    EXPECT_EQ(deriv_of({0.3f, -0.2f, -0.1f}), deriv_of({0.3f, -0.2f, 0.1f}));
}

TEST(DerivEdges, AveragedNormalsKeepTheRatio) {
    const std::vector<float> full = deriv_of({0.6f, 0.0f, 0.8f}), averaged = deriv_of({0.3f, 0.0f, 0.4f});
    EXPECT_NEAR(full[0], averaged[0], 4 * kUlp);
}

TEST(DerivEdges, NoNormalIsFlat) {
    EXPECT_EQ(deriv_of({0.0f, 0.0f, 0.0f}), (std::vector<float>{0, 0}));
}

TEST(DerivEdges, NotANumberStaysWithItsTexel) {
    const float nan = std::nanf("");
    const Case item = {.name = "nan",
                       .include = std::string(kFile) + " surfgrad/resolve.glsl",
                       .inputs = 3,
                       .outputs = 3,
                       .glsl =
                           "vec2 d = sg_deriv_from_normal_xyz(v3(0)); put(0, sg_resolve(vec3(0.0, 0.0, 1.0), "
                           "vec3(d, 0.0)));"};
    for (const auto& m : {std::vector<float>{nan, 0, 1}, {0, nan, 1}, {0, 0, nan}, {nan, nan, nan}}) {
        EXPECT_TRUE(is_unit(In(evaluate(item, m)).v3(0)));
    }
}

// Defect 3, first half: in our words, -m.xy over the larger of |z| and a 128th of the larger of |x| and |y|,
// unguarded.
TEST(DerivPublished, NoNormalIsNotANumber) {
    Case item = cases()[1];
    item.draw = [](Random&, Draw& in) { in.put(0, glm::dvec3(0.0)); };
    item.property = {};
    expect_only_library_holds(
        item, "vec2 published(vec3 m) { vec3 a = abs(m); return -m.xy / max(a.z, max(a.x, a.y) / 128.0); }",
        "put(0, published(v3(0)));");
}

// Defect 4: the guard of the two-channel form is some small number, in place of 1/16384.
TEST(DerivPublished, TwoChannelsGoFarBeyondASlopeOf128) {
    expect_only_library_holds(
        other_cases()[0], "vec2 published(vec2 m) { return -m / sqrt(max(1.1920929e-7, 1.0 - dot(m, m))); }",
        "put(0, published(v2(0)));");
}

SG_PROVE(Deriv, cases());
SG_PROVE(DerivForms, other_cases());

}  // namespace
}  // namespace sg::proof

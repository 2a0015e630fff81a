// Noise (shader_lib/surfgrad/noise.glsl) against double precision, and double precision against differences.
#include "ir/reference/noise.hpp"

#include <fmt/format.h>

#include "noise_draws.hpp"
#include "published.hpp"
#include "skipped.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/noise.glsl";

void draw_octaves(Random& random, Draw& in) {
    in.put(0, draw_point(random));
    in.put(3, random.below(8) == 0 ? 0.0 : random.magnitude(1e-3, 2.0));
    in.put(4, random.below(kOctaves + 1));
}

std::string vanishes(const In& in, const In& out) {
    const bool gone = in[3] >= 1.0 || in[4] < 1.0;
    if (gone && (out[0] != 0.0 || out.v3(1) != glm::dvec3(0.0)))
        return "a footprint of one cell leaves something";
    return std::abs(out[0]) < 2.0 ? "" : "beyond 2";
}

Case perlin() {
    return {.name = "noise_perlin",
            .include = kFile,
            .inputs = 3,
            .outputs = 4,
            .glsl = "SgNoise n = sg_noise_perlin(v3(0)); put(0, n.value); put(1, n.gradient);",
            .draw = [](Random& random, Draw& in) { in.put(0, draw_point(random)); },
            .reference = [](const In& in, Expect& out) { put_noise(out, ref::noise_perlin(in.v3(0))); },
            .bound = {.absolute = kGradientRoundings * kUlp},
            .property =
                [](const In& in, const In& out) {
                    const double error = std::abs(out[0] - ref::noise_perlin(in.v3(0)).value);
                    if (!(error <= kValueRoundings * kUlp)) return fmt::format("value off by {}", error);
                    const bool bounded = std::abs(out[0]) <= 1.0 + 1e-6 && glm::length(out.v3(1)) < 4.0;
                    return std::string(bounded ? "" : "value beyond 1 or gradient beyond 4");
                },
            .mutants = {{kFile, "uvec3(0x7777004cu, 0x5f007777u, 0x005f5f13u)",
                         "uvec3(0x5f007777u, 0x7777004cu, 0x005f5f13u)"},
                        {kFile, "uvec2(h, h >> 8u) + i.y", "uvec2(h, h + 1u) + i.y"},
                        {kFile, "uvec4(h0, h0 >> 8u, h1, h1 >> 8u) + i.z",
                         "uvec4(h0, h0 >> 8u, h1, h1 >> 8u) + i.y"},
                        {kFile, "word >> (8u * (i & 1u))", "word"},
                        {kFile, "0x89a097u", "0x89a197u"},
                        {kFile, "uvec3(ivec3(cell)) & 255u", "uvec3(abs(cell)) & 255u"},
                        {kFile, "f * 6.0 - 15.0", "f * 6.0 - 14.0"},
                        {kFile, "15.0 * slope * slope * across", "-15.0 * slope * slope * across"},
                        {kFile, "0.5 * sum.xyz + 15.0 * slope * slope * across", "0.5 * sum.xyz"},
                        {kFile, "dz0 + fade.x * (dz1 - dz0)", "dz0 + fade.y * (dz1 - dz0)"},
                        {kFile, "h00 >> 8u, vec3(f.xy, g.z)", "h00 >> 8u, f"}}};
}

Case octaves(const char* name, const char* function) {
    return {.name = name,
            .include = kFile,
            .inputs = 5,
            .outputs = 4,
            .glsl = fmt::format(
                "SgNoise n = {}(v3(0), f(3), int(f(4))); put(0, n.value); put(1, n.gradient);", function),
            .draw = draw_octaves,
            // The gradients add, so do their errors; the filter's curve and its product round 4 times, times
            // |gradient| < 4.
            .bound = {.absolute = (kGradientRoundings + 4 * 4) * kUlp},
            .condition = [](const In& in) { return std::max(1.0, in[4]); },
            .property = vanishes};
}

Case fractal_sum() {
    Case item = octaves("noise_fractal_sum", "sg_noise_fractal_sum");
    item.reference = [](const In& in, Expect& out) {
        put_noise(out, ref::noise_fractal_sum(in.v3(0), in[3], static_cast<int>(in[4])));
    };
    item.mutants = {{kFile, "weight / frequency * octave.value;", "weight * octave.value;"},
                    {kFile, "sum.gradient += weight * octave.gradient;",
                     "sum.gradient += weight * frequency * octave.gradient;"},
                    {kFile, "smoothstep(0.5, 1.0, footprint)", "smoothstep(0.5, 2.0, footprint)"},
                    {kFile, "1.0 - smoothstep(0.5, 1.0, footprint)", "1.0"}};
    return item;
}

Case turbulence() {
    Case item = octaves("noise_turbulence", "sg_noise_turbulence");
    item.reference = [](const In& in, Expect& out) {
        put_noise(out, ref::noise_turbulence(in.v3(0), in[3], static_cast<int>(in[4])));
    };
    // Where an octave's sign is lost in rounding, either side of the corner is right: nothing is asserted but
    // finite.
    item.condition = [](const In& in) {
        return on_a_corner(in.v3(0), in[3], static_cast<int>(in[4])) ? INFINITY : std::max(1.0, in[4]);
    };
    item.mutants = {{kFile, "sign(octave.value) * octave.gradient", "octave.gradient"},
                    {kFile, "weight / frequency * abs(octave.value)", "weight / frequency * octave.value"},
                    {kFile, "weight / frequency * abs(octave.value)", "weight * abs(octave.value)"}};
    return item;
}

// pow(f, k) = exp2(k log2 f) on a GPU: log2 is off by 8 kUlp absolute (5e-7), the product rounds relative to
// its size, an error in the exponent is one relative in the result, exp2 adds 6 kUlp; four roundings around
// it.
Case dented() {
    return {
        .name = "noise_power",
        .include = kFile,
        .inputs = 5,
        .outputs = 4,
        .glsl =
            "SgNoise n = sg_noise_power(SgNoise(f(0), v3(1)), f(4)); put(0, n.value); put(1, n.gradient);",
        .draw =
            [](Random& random, Draw& in) {
                in.put(0, random.below(16) == 0 ? 0.0 : random.uniform(-0.25, 2.0));
                if (random.below(8) == 0) in.put(0, random.magnitude(1e-12, 1e-2));  // where k < 1 is steep
                in.put(1, random.direction() * random.uniform(0.0, 4.0));
                in.put(4, random.below(8) == 0 ? random.below(4) : random.uniform(0.0, 6.0));
            },
        .reference =
            [](const In& in, Expect& out) {
                put_noise(out, ref::noise_power({in[0], in.v3(1)}, in[4]));
            },
        .bound = {.absolute = 1e-30, .relative = 10 * kUlp},
        .condition =
            [](const In& in) {
                const double f = in[0] > 0.0 ? in[0] : 1.0;
                return 1.0 + (in[4] + 1.0) * (1.0 + std::abs(std::log2(f)));
            },
        .property =
            [](const In& in, const In& out) {
                const bool dead = in[0] <= 0.0 && (out[0] != 0.0 || out.v3(1) != glm::dvec3(0.0));
                const bool steep = glm::length(out.v3(1)) > 128.001 * glm::length(in.v3(1));
                return std::string(dead ? "something below zero"
                                        : (steep || !is_finite(out.v3(1)) ? "too steep" : ""));
            },
        .mutants = {{kFile, "min(k * below, SG_NOISE_MAX_SLOPE)", "k * below"},
                    {kFile, "min(k * below,", "min(below,"},
                    {kFile, "pow(base, k - 1.0)", "pow(base, k)"},
                    {kFile, "bool positive = f.value > 0.0;", "bool positive = true;"}}};
}

// Values and gradients on both sides of a cell's face: continuous with curvature below 64, also where the
// table wraps.
Case across_faces() {
    return {
        .name = "noise_across_faces",
        .include = kFile,
        .inputs = 6,
        .outputs = 8,
        .glsl =
            "SgNoise a = sg_noise_perlin(v3(0)); put(0, a.value); put(1, a.gradient);"
            "SgNoise b = sg_noise_perlin(v3(3)); put(4, b.value); put(5, b.gradient);",
        .draw =
            [](Random& random, Draw& in) {
                glm::dvec3 p = random.within(2.0);
                const int axis = random.below(3);
                const double face = random.coin() ? 256.0 * (random.below(5) - 2) : random.below(600) - 300;
                p[axis] = face - random.magnitude(1e-4, 1e-3);
                in.put(0, p);
                p[axis] = face + random.magnitude(1e-4, 1e-3);
                in.put(3, p);
            },
        .property =
            [](const In& in, const In& out) {
                const double apart = glm::length(in.v3(3) - in.v3(0));
                const double value = std::abs(out[4] - out[0]), slope = glm::length(out.v3(5) - out.v3(1));
                const bool joined = value <= 4.0 * apart + 1e-5 && slope <= 64.0 * apart + 4e-5;
                return joined ? std::string()
                              : fmt::format("a step of {} and {} over {}", value, slope, apart);
            },
        .mutants = {{kFile, "uvec3(ivec3(cell)) & 255u", "uvec3(clamp(cell, 0.0, 255.0))"},
                    {kFile, "f * 6.0 - 15.0", "f * 6.0 - 14.0"}}};
}

// 256 cells further all is the same to the last bit (both points are exact in 24 bits).
Case period() {
    return {.name = "noise_period",
            .include = kFile,
            .inputs = 6,
            .outputs = 8,
            .glsl =
                "SgNoise a = sg_noise_perlin(v3(0)); put(0, a.value); put(1, a.gradient);"
                "SgNoise b = sg_noise_perlin(v3(0) + v3(3)); put(4, b.value); put(5, b.gradient);",
            .draw =
                [](Random& random, Draw& in) {
                    in.put(0, glm::round(random.within(512.0) * 1024.0) / 1024.0);
                    in.put(3, 256.0 * glm::round(random.within(4.0)));
                },
            .property =
                [](const In&, const In& out) {
                    const bool same = out[0] == out[4] && out.v3(1) == out.v3(5);
                    return std::string(same ? "" : "not periodic");
                },
            .mutants = {{kFile, "uvec3(ivec3(cell)) & 255u", "uvec3(cell - 255.0 * floor(cell / 255.0))"}}};
}

std::vector<Case> cases() {
    return {perlin(), fractal_sum(), turbulence(), dented(), across_faces(), period()};
}

SG_PROVE(Noise, cases());

TEST(Noise, GoldenVectors) {
    const Case item = perlin();
    const std::vector<float> points = {0.5f, 0.5f, 0.5f, 1.25f, 2.5f, 3.75f};
    const double golden[] = {-0.25,        -0.6875,      0.25,        0.0,
                             -0.038363457, -0.482643127, 0.214346170, -0.403125763};
    const std::vector<float> shader = evaluate(item, points);
    const ref::Noise exact[] = {ref::noise_perlin({0.5, 0.5, 0.5}), ref::noise_perlin({1.25, 2.5, 3.75})};
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_NEAR(shader[i], golden[i], 1e-5) << i;
        const ref::Noise& n = exact[i / 4];
        EXPECT_NEAR(i % 4 == 0 ? n.value : n.gradient[static_cast<int>(i % 4) - 1], golden[i], 1e-9) << i;
    }
}

// The central difference of a height over 2e-5, which is exact to 1e-9 for a curvature's slope below 60.
template <typename Height>
glm::dvec3 difference(Height height, glm::dvec3 p) {
    constexpr double kStep = 1e-5;
    glm::dvec3 out;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0.0);
        step[axis] = kStep;
        out[axis] = (height(p + step) - height(p - step)) / (2.0 * kStep);
    }
    return out;
}

TEST(NoiseReference, GradientsAreDifferencesOfHeights) {
    Random random("differences");
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 p = draw_point(random);
        const double footprint = random.magnitude(1e-3, 1.0);
        const double k = random.uniform(0.5, 4.0);
        auto perlin_at = [](glm::dvec3 q) { return ref::noise_perlin(q); };
        auto sum_at = [&](glm::dvec3 q) { return ref::noise_fractal_sum(q, footprint, 4); };
        auto dented_at = [&](glm::dvec3 q) {
            return ref::noise_power(ref::noise_turbulence(q, footprint, 4), k);
        };
        auto turbulence_at = [&](glm::dvec3 q) { return ref::noise_turbulence(q, footprint, 4); };
        auto apart = [&](auto noise) {
            return glm::length(noise(p).gradient -
                               difference([&](glm::dvec3 q) { return noise(q).value; }, p));
        };
        EXPECT_LT(apart(perlin_at), 1e-6);
        EXPECT_LT(apart(sum_at), 1e-6);
        bool corner = false;  // within a step of an octave's zero
        for (int octave = 0; octave < 4; ++octave) {
            corner |= std::abs(ref::noise_perlin(std::ldexp(1.0, octave) * p).value) < 1e-3;
        }
        if (corner) continue;
        EXPECT_LT(apart(turbulence_at), 1e-6);
        if (turbulence_at(p).value > 0.05) {
            EXPECT_LT(apart(dented_at), 1e-6);
        }
    }
}

TEST(Noise, FewPointsLieOnACorner) {
    expect_few_skipped(turbulence(), 0.01);
}

// A point or footprint that is no number: noise is NaN at worst, which the resolve rejects, and a NaN
// footprint shows nothing.
TEST(Noise, AnyPointIsHarmless) {
    Case item = turbulence();
    item.glsl = "SgNoise n = sg_noise_turbulence(v3(0), f(3), 4); put(0, n.value); put(1, n.gradient);";
    for (float footprint : {1.0f, 3.0f, INFINITY, NAN}) {
        for (float value : evaluate(item, std::vector<float>{0.3f, 0.4f, 0.5f, footprint, 4.0f}))
            EXPECT_EQ(value, 0.0f);
    }
    Case resolved = item;
    resolved.include += " surfgrad/resolve.glsl";
    resolved.outputs = 3;
    resolved.glsl = "put(0, sg_resolve(vec3(0.0, 0.0, 1.0), sg_noise_fractal_sum(v3(0), f(3), 4).gradient));";
    for (float far : {1e8f, 1e30f, -3e38f, INFINITY, NAN}) {
        const std::vector<float> n = evaluate(resolved, std::vector<float>{0.3f, far, 0.5f, 0.01f, 4.0f});
        EXPECT_TRUE(is_unit({n[0], n[1], n[2]})) << far;
    }
}

// Defect 10: four evaluations and a fine step give rounding, not a gradient.
TEST(NoisePublished, TurbulenceByDifferences) {
    expect_only_library_holds(turbulence(), R"(
        float height(vec3 p, float footprint, int octaves) { return sg_noise_turbulence(p, footprint, octaves).value; }
        )",
                              R"(
        vec3 p = v3(0); float w = f(3), e = 1e-4; int n = int(f(4));
        float h = height(p, w, n);
        put(0, h);
        put(1, vec3(height(p + vec3(e, 0, 0), w, n) - h, height(p + vec3(0, e, 0), w, n) - h,
                    height(p + vec3(0, 0, e), w, n) - h) / e);
        )");
}

}  // namespace
}  // namespace sg::proof

// Places in a volume with their derivatives (shader_lib/surfgrad/volume.glsl) against double precision.
#include <fmt/format.h>

#include "ir/reference/noise.hpp"
#include "ir/reference/triplanar.hpp"
#include "ir/reference/volume_space.hpp"
#include "noise_draws.hpp"
#include "skipped.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/volume.glsl";
constexpr const char* kVolume = "SgVolume(v3(0), v3(3), v3(6))";

using ref::Hand;
using ref::Origin;

Hand hand(double sign) {
    return sign > 0.0 ? Hand::left : Hand::right;
}
Origin origin(double sign) {
    return sign > 0.0 ? Origin::lower_left : Origin::upper_left;
}

// Two steps of a pixel, either the longer: from far below one octave's cell to beyond it; some stand still.
void draw_steps(Random& random, Draw& in) {
    const double size = random.below(8) == 0 ? 0.0 : random.magnitude(1e-3, 2.0);
    in.put(3, size * random.direction());
    in.put(6, size * random.magnitude(0.2, 1.0) * random.direction());
    if (random.coin()) {
        const glm::dvec3 longer(in.floats()[3], in.floats()[4], in.floats()[5]);
        const glm::dvec3 shorter(in.floats()[6], in.floats()[7], in.floats()[8]);
        in.put(3, shorter);
        in.put(6, longer);
    }
}

void draw_noise(Random& random, Draw& in) {
    in.put(0, draw_point(random));
    draw_steps(random, in);
    in.put(9, random.below(kOctaves + 1));
}

double footprint(const In& in) {
    return std::max(glm::length(in.v3(3)), glm::length(in.v3(6)));
}
int octaves(const In& in) {
    return static_cast<int>(in[9]);
}

// An octave as in noise.glsl. Its weight falls by 3 per cell of footprint at most, and a footprint of at most
// one cell is off by 8 roundings (volume_space.glsl): 24 more, times |gradient| < 4.
constexpr double kOctaveRoundings = kGradientRoundings + 4 * 4 + 4 * 24;

Case scale() {
    return {.name = "volume_scale",
            .include = kFile,
            .inputs = 10,
            .outputs = 9,
            .glsl = fmt::format("SgVolume a = sg_volume_scale({}, f(9));", kVolume) +
                    "put(0, a.p); put(3, a.dx); put(6, a.dy);",
            .draw =
                [](Random& random, Draw& in) {
                    in.put(0, random.within(100.0));
                    draw_steps(random, in);
                    in.put(9, random.sign() * random.magnitude(0.01, 100.0));
                },
            .reference =
                [](const In& in, Expect& out) {
                    for (std::size_t k = 0; k < 9; k += 3) out.put(k, in[9] * in.v3(k));
                },
            .bound = {.absolute = 1e-30, .relative = 2 * kUlp},  // one product
            .mutants = {{kFile, "frequency * volume.p", "volume.p"},
                        {kFile, "frequency * volume.dx, frequency * volume.dy", "volume.dx, volume.dy"},
                        {kFile, "frequency * volume.dx", "volume.dx / frequency"}}};
}

Case noise(const char* name, const char* call, int octave_count) {
    return {
        .name = name,
        .blunt =
            "the footprint's rounding is in the bound; the functions of noise.glsl have the formulas alone",
        .include = kFile,
        .inputs = 10,
        .outputs = 4,
        .glsl = fmt::format("SgNoise n = {}; put(0, n.value); put(1, n.gradient);",
                            fmt::format(fmt::runtime(call), kVolume)),
        .draw = draw_noise,
        .bound = {.absolute = octave_count * kOctaveRoundings * kUlp}};
}

Case perlin() {
    Case item = noise("volume_perlin", "sg_volume_perlin({})", 1);
    item.reference = [](const In& in, Expect& out) {
        const ref::Noise n = ref::noise_perlin(in.v3(0));
        const double weight = ref::octave_weight(footprint(in));
        out.put(0, weight * n.value);
        out.put(1, weight * n.gradient);
    };
    item.property = [](const In& in, const In& out) {
        const bool gone = footprint(in) < 1.0 + 1e-5 || (out[0] == 0.0 && out.v3(1) == glm::dvec3(0.0));
        return std::string(gone ? "" : "a pixel of one cell leaves something");
    };
    constexpr const char* kCall = "sg_noise_fractal_sum(volume.p, sg_footprint(volume.dx, volume.dy), 1)";
    item.mutants = {{kFile, kCall, "sg_noise_fractal_sum(volume.p, sg_footprint(volume.dx, volume.dy), 2)"},
                    {kFile, kCall, "sg_noise_fractal_sum(volume.p, sg_footprint(volume.dx, volume.dx), 1)"},
                    {kFile, kCall, "sg_noise_fractal_sum(volume.p, sg_footprint(volume.dy, volume.dy), 1)"},
                    {kFile, kCall, "sg_noise_turbulence(volume.p, sg_footprint(volume.dx, volume.dy), 1)"},
                    {kFile, kCall, "sg_noise_perlin(volume.p)"}};
    return item;
}

// The mistakes of a function that hands on `call`.
std::vector<Mutant> mistaken(const std::string& right, const std::string& other) {
    const std::string call = right + "(volume.p, sg_footprint(volume.dx, volume.dy), octaves)";
    return {{kFile, call, right + "(volume.p, sg_footprint(volume.dx, volume.dy), octaves + 1)"},
            {kFile, call, right + "(volume.p, sg_footprint(volume.dx, volume.dx), octaves)"},
            {kFile, call, right + "(volume.p, sg_footprint(volume.dy, volume.dy), octaves)"},
            {kFile, call, right + "(volume.p, 0.0, octaves)"},
            {kFile, call, other + "(volume.p, sg_footprint(volume.dx, volume.dy), octaves)"}};
}

Case fractal_sum() {
    Case item = noise("volume_fractal_sum", "sg_volume_fractal_sum({}, int(f(9)))", kOctaves);
    item.reference = [](const In& in, Expect& out) {
        put_noise(out, ref::noise_fractal_sum(in.v3(0), footprint(in), octaves(in)));
    };
    item.mutants = mistaken("sg_noise_fractal_sum", "sg_noise_turbulence");
    return item;
}

Case turbulence() {
    Case item = noise("volume_turbulence", "sg_volume_turbulence({}, int(f(9)))", kOctaves);
    item.reference = [](const In& in, Expect& out) {
        put_noise(out, ref::noise_turbulence(in.v3(0), footprint(in), octaves(in)));
    };
    // As in prove_noise.cpp: either side of a corner is right.
    item.condition = [](const In& in) {
        return on_a_corner(in.v3(0), footprint(in), octaves(in)) ? INFINITY : 1.0;
    };
    item.mutants = mistaken("sg_noise_turbulence", "sg_noise_fractal_sum");
    return item;
}

Case coordinates() {
    return {.name = "volume_triplanar_uv",
            .include = kFile,
            .inputs = 11,
            .outputs = 18,
            .glsl = fmt::format("SgTriplanarUv a = sg_volume_triplanar_uv({}, f(9), f(10));", kVolume) +
                    "put(0, a.x.st); put(2, a.x.dx); put(4, a.x.dy);"
                    "put(6, a.y.st); put(8, a.y.dx); put(10, a.y.dy);"
                    "put(12, a.z.st); put(14, a.z.dx); put(16, a.z.dy);",
            .draw =
                [](Random& random, Draw& in) {
                    in.put(0, random.within(100.0));
                    draw_steps(random, in);
                    in.put(9, random.sign());
                    in.put(10, random.sign());
                },
            .reference =
                [](const In& in, Expect& out) {
                    const ref::TriplanarUv uv =
                        ref::triplanar_uv(in.v3(0), in.v3(3), in.v3(6), hand(in[9]), origin(in[10]));
                    std::size_t at = 0;
                    for (const ref::Uv& plane : {uv.x, uv.y, uv.z}) {
                        out.put(at, plane.st), out.put(at + 2, plane.dx), out.put(at + 4, plane.dy);
                        at += 6;
                    }
                },
            .bound = {},  // signs and a choice of components: exact
            .mutants = {{kFile, "volume.dx, volume.dy, hand, origin", "volume.dx, volume.dy, origin, hand"}}};
}

// As weights of a triplanar lookup they leave one plane's gradient, and nothing of the others.
Case axes() {
    return {.name = "axes",
            .include = kFile,
            .inputs = 8,
            .outputs = 9,
            .glsl =
                "put(0, sg_triplanar_gradient(sg_axis_x(), v2(0), v2(2), v2(4), f(6), f(7)));"
                "put(3, sg_triplanar_gradient(sg_axis_y(), v2(0), v2(2), v2(4), f(6), f(7)));"
                "put(6, sg_triplanar_gradient(sg_axis_z(), v2(0), v2(2), v2(4), f(6), f(7)));",
            .draw =
                [](Random& random, Draw& in) {
                    for (std::size_t k = 0; k < 6; ++k) in.put(k, random.uniform(-4.0, 4.0));
                    in.put(6, random.sign());
                    in.put(7, random.sign());
                },
            .reference =
                [](const In& in, Expect& out) {
                    for (int axis = 0; axis < 3; ++axis) {
                        const auto k = static_cast<std::size_t>(axis);
                        out.put(3 * k, ref::planar_gradient(in.v2(2 * k), axis, hand(in[6]), origin(in[7])));
                    }
                },
            .bound = {},  // the weights are 0 and 1
            .mutants = {{kFile, "vec3(1.0, 0.0, 0.0)", "vec3(1.0, 1.0, 0.0)"},
                        {kFile, "vec3(1.0, 0.0, 0.0)", "vec3(0.0, 0.0, 1.0)"},
                        {kFile, "vec3(0.0, 1.0, 0.0)", "vec3(1.0, 0.0, 0.0)"},
                        {kFile, "vec3(0.0, 1.0, 0.0)", "vec3(0.0, 0.5, 0.0)"},
                        {kFile, "vec3(0.0, 0.0, 1.0)", "vec3(0.0, 1.0, 0.0)"}}};
}

std::vector<Case> cases() {
    return {scale(), perlin(), fractal_sum(), turbulence(), coordinates(), axes()};
}

SG_PROVE(Volume, cases());

TEST(Volume, FewPointsLieOnACorner) {
    expect_few_skipped(turbulence(), 0.01);
}

// Twice the frequency in a volume of half the size shows the same noise: what a lookup shows does not depend
// on where scaling is done.
TEST(Volume, ScalingIsALookupElsewhere) {
    Case item{.name = "scaled_lookup",
              .include = kFile,
              .inputs = 9,
              .outputs = 8,
              .glsl = fmt::format("SgVolume a = {}; ", kVolume) +
                      "SgVolume half_size = SgVolume(0.5 * a.p, 0.5 * a.dx, 0.5 * a.dy);"
                      "SgNoise n = sg_volume_fractal_sum(a, 4);"
                      "SgNoise m = sg_volume_fractal_sum(sg_volume_scale(half_size, 2.0), 4);"
                      "put(0, n.value); put(1, n.gradient); put(4, m.value); put(5, m.gradient);",
              .draw = [](Random& random, Draw& in) {
                  in.put(0, draw_point(random));
                  draw_steps(random, in);
              }};
    const std::vector<float> out = evaluate(item, draw_inputs(item, 1000));
    ASSERT_EQ(out.size(), 8000u);
    int seen = 0;
    for (std::size_t at = 0; at < out.size(); at += 8) {
        for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(out[at + k], out[at + 4 + k]) << "lookup " << at / 8;
        seen += out[at] != 0.0f ? 1 : 0;
    }
    EXPECT_GT(seen, 500) << "most pixels are smaller than a cell";
}

// A place or a step that is no number: not-a-number at worst, which the resolve rejects; a footprint that is
// no number or infinite shows nothing.
TEST(Volume, AnyPlaceIsHarmless) {
    Case item = fractal_sum();
    item.include += " surfgrad/resolve.glsl";
    item.outputs = 4;
    item.glsl = fmt::format("SgNoise n = sg_volume_turbulence({}, 4);", kVolume) +
                "put(0, sg_resolve(vec3(0.0, 0.0, 1.0), n.gradient)); put(3, n.value);";
    for (float far : {1e30f, -3e38f, INFINITY, NAN}) {
        std::vector<float> in(10, 0.01f);
        in[1] = far;
        const std::vector<float> n = evaluate(item, in);
        EXPECT_TRUE(is_unit({n[0], n[1], n[2]})) << far;
        std::vector<float> wide(10, 0.3f);
        wide[4] = far;
        const std::vector<float> flat = evaluate(item, wide);
        EXPECT_TRUE(is_unit({flat[0], flat[1], flat[2]})) << far;
    }
}

}  // namespace
}  // namespace sg::proof

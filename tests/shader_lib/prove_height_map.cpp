// Derivatives straight from height maps (shader_lib/surfgrad/height_map.glsl and the reads of
// from_height.glsl and sample.glsl) against double precision, on textures of sizes that are no powers of two.
#include "draws.hpp"
#include "ir/reference/from_height.hpp"
#include "ir/reference/height_map.hpp"
#include "published.hpp"
#include "textures.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/height_map.glsl";
constexpr const char* kSampleUv = "SgUv(v2(0), v2(2), v2(4))";

const std::shared_ptr<const CaseTexture>& rough() {
    static const auto texture = random_texture({204, 150}, true, ref::Wrap::repeat);
    return texture;
}

ref::Uv sampled_uv(const In& in) {
    return {in.v2(0), in.v2(2), in.v2(4)};
}

// A footprint of 2^-2 to 2^5 texels.
void draw_sampled_uv(Random& random, Draw& in) {
    const glm::dvec2 along = random.direction2(), size(204.0, 150.0);
    in.put(0, glm::dvec2(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)));
    in.put(2, along * random.magnitude(0.25, 32.0) / size);
    in.put(4, random.direction2() * random.magnitude(0.25, 32.0) / size);
}

// A level of detail within a step of 0.001 of an end of the fade, as often as not.
void draw_at_the_fade(Random& random, Draw& in) {
    draw_sampled_uv(random, in);
    if (random.coin()) return;
    const double level = (random.coin() ? 0.05 : 0.5) - random.uniform(0.0, 0.002);
    in.put(2, random.direction2() * std::exp2(level) / glm::dvec2(204.0, 150.0));
    in.put(4, glm::dvec2(0.0));
}

// Rounding moves a position of p texels by 2 to 3 u p, and one that repeats by as much as at the far edge;
// heights in 0..1 change by at most 1 a texel.
double texels_from_origin(const In& in) {
    return 2.0 + 204.0 * std::max({1.0, std::abs(in[0]), std::abs(in[1])});
}

// Why these bounds are wide: the arithmetic by itself is deriv_from_heights_4x4 and sg_uv_level, which are
// not.
constexpr const char* kPlaceIsRounded =
    "a place is off by two roundings of 204 texels, of heights that change by 1 a texel";
constexpr const char* kDriversLevel = "the driver's level of detail is off by up to 0.05";
// Two reads of 3 roundings each.
constexpr Bound kForward = {.absolute = 12 * kUlp};
// A read at a level of detail that is off by 2e-6 (log2 twice, halved; exp2), between levels that differ by
// at most 1.
constexpr double kLevelOff = 4e-6;

std::vector<Case> read_cases() {
    return {
        {.name = "sample",
         .blunt = kDriversLevel,
         .include = "surfgrad/sample.glsl",
         .inputs = 6,
         .outputs = 4,
         .glsl = std::string("put(0, sg_sample(image_0, sampler_0, ") + kSampleUv + "));",
         .draw = draw_sampled_uv,
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::sample_grad(rough()->image, rough()->sampler, in.v2(0), in.v2(2), in.v2(4)));
             },
         // The driver's level of detail is off by up to 0.05 (its log2 is approximate); levels differ by at
         // most 1.
         .bound = {.absolute = 0.05},
         .mutants =
             {
                 {"surfgrad/sample.glsl", "uv.dx, uv.dy", "vec2(0.0), vec2(0.0)"},
             },
         .textures = {rough()}},
        {.name = "screen_height_three_tap",
         .blunt = kDriversLevel,
         .include = "surfgrad/from_height.glsl",
         .inputs = 6,
         .outputs = 2,
         .glsl = std::string("put(0, sg_screen_height_three_tap(image_0, sampler_0, ") + kSampleUv + "));",
         .draw = draw_sampled_uv,
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::screen_height_three_tap(rough()->image, rough()->sampler, sampled_uv(in)));
             },
         .bound = {.absolute = 0.1},  // two such reads
         .mutants =
             {
                 {"surfgrad/from_height.glsl", "uv.st + uv.dx", "uv.st - uv.dx"},
             },
         .textures = {rough()}},
    };
}

std::vector<Case> plain_height_cases() {
    return {
        {.name = "deriv_from_height_level",
         .blunt = kPlaceIsRounded,
         .include = kFile,
         .inputs = 3,
         .outputs = 2,
         .glsl = "put(0, sg_deriv_from_height_level(image_0, sampler_0, v2(0), f(2)));",
         .draw =
             [](Random& random, Draw& in) {
                 in.put(0, glm::dvec2(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)));
                 in.put(2, random.uniform(-2.0, 6.0));
             },
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::deriv_from_height_level(rough()->image, rough()->sampler, in.v2(0), in[2]));
             },
         .bound = kForward,
         .condition = texels_from_origin,
         .mutants =
             {
                 {kFile, "float used = max(level, 0.0);", "float used = level;"},
                 {kFile, "vec2(right - here, below - here) / texels", "vec2(right - here, below - here)"},
                 {kFile, "st + vec2(size.x, 0.0)", "st - vec2(size.x, 0.0)"},
             },
         .textures = {rough()}},
        {.name = "deriv_from_height",
         .blunt = kPlaceIsRounded,
         .include = kFile,
         .inputs = 6,
         .outputs = 2,
         .glsl = std::string("put(0, sg_deriv_from_height(image_0, sampler_0, ") + kSampleUv + "));",
         .draw = draw_sampled_uv,
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::deriv_from_height(rough()->image, rough()->sampler, sampled_uv(in)));
             },
         .bound = {.absolute = kForward.absolute + kLevelOff / 200.0},  // texels_from_origin is above 200
         .condition = texels_from_origin,
         .mutants = {{kFile, "filtering, uv.st, sg_uv_level(uv, dim));", "filtering, uv.st, 0.0);"}},
         .textures = {rough()}},
        {.name = "deriv_from_height_smooth",
         .blunt = kPlaceIsRounded,
         .include = kFile,
         .inputs = 2,
         .outputs = 2,
         .glsl = "put(0, sg_deriv_from_height_smooth(image_0, sampler_0, v2(0)));",
         .draw =
             [](Random& random, Draw& in) {
                 in.put(0, glm::dvec2(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)));
             },
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::deriv_from_height_smooth(rough()->image, rough()->sampler, in.v2(0)));
             },
         .bound = kForward,  // the derivative itself changes by at most 2 a texel
         .condition = texels_from_origin,
         .mutants = {{kFile, "(corner + 2.0) / dim", "(corner + 1.0) / dim"},
                     {kFile, "vec4(upper_left.wz, upper_right.wz)", "vec4(upper_left.zw, upper_right.zw)"},
                     {kFile, "vec4(lower_left.wz, lower_right.wz)", "vec4(lower_left.xy, lower_right.xy)"}},
         .textures = {rough()}},
    };
}

std::vector<Case> fine_height_cases() {
    return {
        {.name = "deriv_from_height_hq",
         .blunt = kPlaceIsRounded,
         .include = kFile,
         .inputs = 6,
         .outputs = 2,
         .glsl = std::string("put(0, sg_deriv_from_height_hq(image_0, sampler_0, ") + kSampleUv + "));",
         .draw = draw_sampled_uv,
         .reference =
             [](const In& in, Expect& out) {
                 out.put(0, ref::deriv_from_height_hq(rough()->image, rough()->sampler, sampled_uv(in)));
             },
         // The fade magnifies the level's error by 1 / 0.45.
         .bound = {.absolute = 2.0 * kForward.absolute + kLevelOff / 0.45 / 200.0},
         .condition = texels_from_origin,
         .mutants = {{kFile, "uv.st), weight)", "uv.st), weight * weight)"},
                     {kFile, "mix(d, sg_deriv", "mix(0.5 * d, sg_deriv"}},
         .textures = {rough()}},
        {.name = "deriv_from_height_hq_is_continuous",
         .include = kFile,
         .inputs = 6,
         .outputs = 2,
         // A footprint and one that is larger by a thousandth of an octave.
         .glsl = std::string("SgUv uv = ") + kSampleUv +
                 "; SgUv wider = SgUv(uv.st, exp2(0.001) * uv.dx, exp2(0.001) * uv.dy);"
                 "put(0, sg_deriv_from_height_hq(image_0, sampler_0, wider) - "
                 "sg_deriv_from_height_hq(image_0, sampler_0, uv));",
         .draw = draw_at_the_fade,
         .reference = [](const In&, Expect& out) { out.put(0, glm::dvec2(0.0)); },
         // The fade changes by 0.001 / 0.45 between two values in -1..1; a step and its levels by 0.001 of
         // such.
         .bound = {.absolute = 2.0 * 0.001 / 0.45 + 0.002},
         .mutants = {{kFile,
                      "return clamp((SG_HEIGHT_FADE_END - level) / (SG_HEIGHT_FADE_END - "
                      "SG_HEIGHT_FADE_BEGIN), 0.0, 1.0);",
                      "return level < SG_HEIGHT_FADE_END ? 1.0 : 0.0;"}},
         .textures = {rough()}},
    };
}

std::vector<Case> height_cases() {
    return joined(plain_height_cases(), fine_height_cases());
}

std::vector<Case> arithmetic_cases() {
    return {
        {.name = "deriv_from_heights_4x4",
         .include = kFile,
         .inputs = 18,
         .outputs = 2,
         .glsl = "put(0, sg_deriv_from_heights_4x4(v4(0), v4(4), v4(8), v4(12), v2(16)));",
         .draw =
             [](Random& random, Draw& in) {
                 for (std::size_t k = 0; k < 16; ++k) in.put(k, random.uniform(-1.0, 1.0));
                 in.put(16, random.uniform(0.0, 1.0)), in.put(17, random.uniform(0.0, 1.0));
             },
         .reference =
             [](const In& in, Expect& out) {
                 ref::Heights4x4 heights{};
                 for (std::size_t k = 0; k < 16; ++k) heights[k / 4][k % 4] = in[k];
                 out.put(0, ref::deriv_from_heights_4x4(heights, in.v2(16)));
             },
         .bound = {.absolute =
                       24 * kUlp},  // weights (2) and two dot products of four terms (5 each), all below 1
         .mutants = {{kFile, "1.0 + s.x, 1.0 + t.x", "1.0 + t.x, 1.0 + s.x"}}},
        {.name = "height_smooth_weight",
         .include = kFile,
         .inputs = 1,
         .outputs = 1,
         .glsl = "put(0, sg_height_smooth_weight(f(0)));",
         .draw = [](Random& random, Draw& in) { in.put(0, random.uniform(-1.0, 1.0)); },
         .reference = [](const In& in, Expect& out) { out.put(0, ref::height_smooth_weight(in[0])); },
         .bound = {.absolute = 12 * kUlp},  // a difference and a division by 0.45 of rounded constants
         .mutants = {{kFile, "(SG_HEIGHT_FADE_END - level)", "(level - SG_HEIGHT_FADE_BEGIN)"}}},
    };
}

SG_PROVE(HeightMapReads, read_cases());
SG_PROVE(HeightMap, height_cases());
SG_PROVE(HeightMapArithmetic, arithmetic_cases());

// A case of height_cases() on another texture and with another expectation.
Case exact_case(std::size_t of, std::shared_ptr<const CaseTexture> texture,
                std::function<glm::dvec2(glm::dvec2)> slope) {
    Case item = height_cases()[of];
    item.textures = {std::move(texture)};
    const glm::dvec2 size(item.textures[0]->image.size(0));
    item.draw = [=](Random& random, Draw& in) {
        // In texels, far enough from the edges for every kernel; no footprint larger than four texels.
        const glm::dvec2 texel(random.uniform(6.0, size.x - 12.0), random.uniform(6.0, size.y - 12.0));
        in.put(0, (texel + 0.5) / size);
        if (in.size() == 3) in.put(2, random.uniform(-2.0, 2.0));
        if (in.size() == 6)
            in.put(2, random.direction2() / size * random.magnitude(0.01, 4.0)), in.put(4, glm::dvec2(0.0));
    };
    item.reference = [=](const In& in, Expect& out) { out.put(0, slope(in.v2(0) * size - 0.5)); };
    return item;
}

void expect_exact(const Case& item) {
    const std::vector<float> inputs = draw_inputs(item, kMutantCount);
    EXPECT_EQ(compare(item, inputs, evaluate(item, inputs)).violation, "") << "SG_SEED=" << run_seed();
}

TEST(HeightMapEdges, ARampGivesItsSlopeAtAnyPlaceAndLevel) {
    const auto ramp = height_texture({48, 40}, true, [](double u, double v) { return u / 64.0 - v / 128.0; });
    for (std::size_t of = 0; of < 4; ++of) {
        expect_exact(exact_case(of, ramp, [](glm::dvec2) { return glm::dvec2(1.0 / 64.0, -1.0 / 128.0); }));
    }
}

TEST(HeightMapEdges, ASquareGivesTwiceItsRootUnderMagnification) {
    const auto bowl =
        height_texture({40, 40}, true, [](double u, double v) { return (u * u - 3.0 * v * v) / 4096.0; });
    expect_exact(
        exact_case(2, bowl, [](glm::dvec2 p) { return glm::dvec2(2.0 * p.x, -6.0 * p.y) / 4096.0; }));
}

TEST(HeightMapEdges, ATextureWithOneLevelGivesItsSlopeToo) {
    const auto ramp = height_texture({48, 40}, false, [](double u, double v) { return u / 64.0 + v / 64.0; });
    for (std::size_t of = 0; of < 4; ++of) {
        expect_exact(exact_case(of, ramp, [](glm::dvec2) { return glm::dvec2(1.0 / 64.0); }));
    }
}

TEST(HeightMapEdges, MagnificationShowsNoFacets) {
    // Within a texel the forward difference over a texel changes continuously; over the footprint it would be
    // constant.
    Case item = height_cases()[0];
    const glm::dvec2 size(204.0, 150.0);
    constexpr int kTexels = 40;
    std::vector<float> inputs;
    for (int i = 0; i < 2 * kTexels; ++i) {
        const glm::dvec2 st = (glm::dvec2(50.6 + 2 * (i / 2) + 0.3 * (i % 2), 60.7) + 0.5) / size;
        inputs.insert(inputs.end(), {static_cast<float>(st.x), static_cast<float>(st.y), -6.0f});
    }
    const std::vector<float> d = evaluate(item, inputs);
    int changes = 0;
    for (std::size_t i = 0; i < kTexels; ++i) changes += std::abs(d[4 * i + 2] - d[4 * i]) > 1e-3f ? 1 : 0;
    // The heights are random: about one texel in a hundred is so flat that nothing changes there.
    EXPECT_GT(changes, kTexels / 2);
}

// Defect 2: the gather at a texel's centre picks either neighbour. In our words: f the floor of the position,
// the gather at (f + 0.5)/dim with offsets of one texel.
TEST(HeightMapPublished, GathersAtTexelCentresAreATexelOff) {
    expect_only_library_holds(height_cases()[2], R"(
vec2 published(vec2 st) {
    vec2 dim = vec2(textureSize(sampler2D(image_0, sampler_0), 0));
    vec2 position = st * dim - 0.5;
    vec2 corner = floor(position);
    vec2 centre = (corner + 0.5) / dim;
    vec4 a = textureGatherOffset(sampler2D(image_0, sampler_0), centre, ivec2(-1, -1));
    vec4 b = textureGatherOffset(sampler2D(image_0, sampler_0), centre, ivec2(1, -1));
    vec4 c = textureGatherOffset(sampler2D(image_0, sampler_0), centre, ivec2(-1, 1));
    vec4 d = textureGatherOffset(sampler2D(image_0, sampler_0), centre, ivec2(1, 1));
    return sg_deriv_from_heights_4x4(vec4(a.wz, b.wz), vec4(a.xy, b.xy), vec4(c.wz, d.wz), vec4(c.xy, d.xy), position - corner);
}
)",
                              "put(0, published(v2(0)));");
}

// Defect 12: the second of the two equations, as printed, is for dH/du once more: it gives dH/dv.
TEST(HeightMapPublished, TheSecondEquationIsForTheOtherDirection) {
    expect_only_library_holds(
        arithmetic_cases()[0], "",
        "vec2 d = sg_deriv_from_heights_4x4(v4(0), v4(4), v4(8), v4(12), v2(16)); put(0, d.yx);");
}

}  // namespace
}  // namespace sg::proof

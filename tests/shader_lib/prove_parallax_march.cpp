// Marching through height maps (shader_lib/surfgrad/parallax.glsl) against double precision, on a map whose
// sizes are no powers of two.
#include <fmt/format.h>

#include "draws.hpp"
#include "ir/reference/parallax.hpp"
#include "skipped.hpp"
#include "textures.hpp"

namespace sg::proof {
namespace {

constexpr const char* kFile = "surfgrad/parallax.glsl";

constexpr glm::ivec2 kSize(61, 48);

// Rolling hills from 0.05 to 0.95 with slopes below 0.2 per texel, repeated; levels of detail for the march.
const std::shared_ptr<const CaseTexture>& hills(bool levels) {
    auto make = [](bool with_levels) {
        return height_texture(kSize, with_levels, [](double u, double v) {
            return 0.5 + 0.25 * std::sin(0.4 * u + 0.3) * std::cos(0.3 * v) +
                   0.2 * std::sin(0.21 * u - 0.5 * v);
        });
    };
    static const auto flat = make(false), chain = make(true);
    return levels ? chain : flat;
}

// Inputs: 0 st, 2 stride, 4 steps, 5 dx, 7 dy.
Case steps() {
    return {
        .name = "parallax_steps",
        .include = kFile,
        .inputs = 9,
        .outputs = 2,
        .glsl =
            "put(0, sg_parallax_steps(image_0, sampler_0, vec2(2.0, -1.0), SgUv(v2(0), v2(5), v2(7)), "
            "v2(2), int(f(4))));",
        .draw =
            [](Random& random, Draw& in) {
                in.put(0, glm::dvec2(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)));
                in.put(2, random.direction2() * random.magnitude(1e-4, 0.03));
                in.put(4, random.below(7));
                in.put(5, random.direction2() * random.magnitude(1e-5, 1e-2));
                in.put(7, random.direction2() * random.magnitude(1e-5, 1e-2));
            },
        .reference =
            [](const In& in, Expect& out) {
                const CaseTexture& map = *hills(false);
                out.put(0, ref::parallax_steps(map.image, map.sampler, {2.0, -1.0},
                                               {in.v2(0), in.v2(5), in.v2(7)}, in.v2(2),
                                               static_cast<int>(in[4])));
            },
        // A read: the place is off by 3 roundings of 61 texels, times a slope of 0.4 of the decoded
        // value, and 8 of the filter; every step, times the stride, and doubled. An error of place grows
        // by stride * 61 * 0.4 a step.
        .bound = {.absolute = 2 * kUlp},
        .condition =
            [](const In& in) {
                const double stride = glm::length(in.v2(2)), reach = std::max(in[0], in[1]) + in[4] * stride;
                return in[4] * stride * (3 * 61 * 0.4 * reach + 8) * std::pow(1.0 + 61 * 0.4 * stride, in[4]);
            },
        .mutants = {{kFile, "uv.st + offset, uv.dx, uv.dy).x", "uv.st, uv.dx, uv.dy).x"},
                    {kFile, "(decode.x * texel + decode.y) * stride", "decode.x * texel * stride"},
                    {kFile, "offset += (decode.x", "offset -= (decode.x"}},
        .textures = {hills(false)}};
}

// Inputs: 0 st, 2 view, 5 level, 6 heights, 8 steps.
constexpr const char* kMarch =
    "SgParallax hit = sg_parallax_occlusion(image_0, sampler_0, v2(6), v2(0), v3(2), f(5), int(f(8)));";

void draw_march(Random& random, Draw& in) {
    in.put(0, glm::dvec2(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)));
    glm::dvec3 view = random.direction();
    in.put(2, glm::dvec3(view.x, view.y, std::abs(view.z)) *
                  glm::dvec3(random.magnitude(0.2, 2.0), random.magnitude(0.2, 2.0), 1.0));
    in.put(5, random.coin() ? 0.0 : random.uniform(0.0, 3.0));
    const double scale = random.sign() * random.magnitude(0.005, 0.2);
    in.put(6, glm::dvec2(scale, -scale * (random.coin() ? 1.0 : random.uniform(0.0, 1.0))));
    in.put(8, 1 + random.below(40));
}

ref::March march_of(const In& in) {
    const CaseTexture& map = *hills(true);
    return ref::parallax_march(map.image, map.sampler, in.v2(6), in.v2(0), in.v3(2), in[5],
                               static_cast<int>(in[8]));
}

// A distance of ray and surface: 8 roundings of the heights and of the filter, the place 3 roundings of its
// texels times a slope of 0.2, the level of detail.
double gap_error(const In& in, double run) {
    const double texels = 61.0 * (1.0 + 0.4 * run);
    return std::abs(in[6]) * (12.0 + 0.2 * 4.0 * texels) * kUlp +
           (in[5] > 0.0 ? 1e-6 * std::abs(in[6]) : 0.0);
}

double march_condition(const In& in) {
    const double run = glm::length(in.v2(2)) / std::max(in[4], 1.0 / 32.0);
    const ref::March march = march_of(in);
    const double gap = 2.0 * gap_error(in, run);
    // Which step ends the march is then a matter of rounding.
    return march.closest < gap ? INFINITY
                               : (1.0 + run) * (gap * march.amplification + 8.0 * std::abs(in[6]) * kUlp);
}

Case occlusion() {
    return {.name = "parallax_occlusion",
            .blunt = "a place is off by roundings of 61 texels; parallax_ramp has the formula alone",
            .include = kFile,
            .inputs = 9,
            .outputs = 3,
            .glsl = std::string(kMarch) + "put(0, hit.offset); put(2, hit.height);",
            .draw = draw_march,
            .reference =
                [](const In& in, Expect& out) {
                    const ref::March march = march_of(in);
                    out.put(0, march.hit.offset);
                    out.put(2, march.hit.height);
                },
            .bound = {.absolute = 1.0},  // march_condition is the whole bound
            .condition = march_condition,
            .property =
                [](const In& in, const In& out) {
                    const double top = in[7] + std::max(in[6], 0.0), bottom = in[7] + std::min(in[6], 0.0);
                    return out[2] <= top + 1e-6 && out[2] >= bottom - 1e-6 ? "" : "beyond top or bottom";
                },
            .mutants = {{kFile, "heights.y + heights.x * textureLod", "heights.x * textureLod"},
                        {kFile, "float top = heights.y + max(heights.x, 0.0);",
                         "float top = heights.y + heights.x;"},
                        {kFile, "view.xy / max(view.z, SG_PARALLAX_MIN_COSINE)",
                         "-view.xy / max(view.z, SG_PARALLAX_MIN_COSINE)"},
                        {kFile, "gap < 0.0 ? clamp(gap / (gap - gap_before), 0.0, 1.0) : 0.0", "0.0"},
                        {kFile, "top - float(i) * drop", "top - float(i + 1) * drop"},
                        {kFile, "filtering), st, level).x", "filtering), st, 0.0).x"}},
            .textures = {hills(true)}};
}

// The point that is shown lies on the ray of the eye: P' - P is a multiple of the view. Inputs: as occlusion,
// then 9 frame, 18 uv's steps, 22 direction towards the viewer.
Case on_the_ray() {
    return {
        .name = "parallax_on_the_ray",
        .include = kFile,
        .inputs = 25,
        .outputs = 3,
        .glsl =
            "SgFrame frame = sg_frame(vec3(0.0), v3(12), v3(15), v3(9)); SgUv uv = SgUv(v2(0), v2(18), "
            "v2(20));"
            "vec3 view = sg_parallax_direction(frame, uv, v3(22));"
            "SgParallax hit = sg_parallax_occlusion(image_0, sampler_0, v2(6), uv.st, view, f(5), int(f(8)));"
            "put(0, sg_parallax_position(frame, sg_parallax_pixels(uv, hit.offset), hit.height));",
        .draw =
            [](Random& random, Draw& in) {
                draw_march(random, in);
                const glm::dvec3 n = random.direction(), along = tangent_of(random, n),
                                 across = glm::cross(n, along);
                in.put(9, n);
                in.put(12, 0.01 * along);
                in.put(15, 0.01 * (across + random.uniform(-1.0, 1.0) * along));
                const glm::dvec2 s = random.direction2();
                in.put(18, 0.01 * s);
                in.put(20, 0.01 * random.sign() * (glm::dvec2(-s.y, s.x) + random.uniform(-1.0, 1.0) * s));
                const glm::dvec3 view = random.direction();
                in.put(22, glm::dot(view, n) < 0.0 ? -view : view);
            },
        .property =
            [](const In& in, const In& out) {
                const glm::dvec3 view = in.v3(22), moved = out.v3(0);
                const double rise = glm::dot(view, in.v3(9));
                if (rise < 0.04)
                    return std::string(is_finite(moved) ? "" : "not finite");  // held at the least rise
                // 60 roundings of st's way there and back over steps with squints up to 1.5, once more over
                // the rise.
                const double allowed = 200 * kUlp * 0.2 / rise;
                const double beside = glm::length(glm::cross(moved, view));
                return beside <= allowed ? std::string()
                                         : fmt::format("{} beside the ray, allowed {}", beside, allowed);
            },
        .mutants = {{kFile, "return SgParallax(height * per_height, height);",
                     "return SgParallax(-height * per_height, height);"},
                    {kFile, "return SgParallax(height * per_height, height);",
                     "return SgParallax(height * view.xy, height);"},
                    {kFile, "height * frame.normal;", "-height * frame.normal;"}},
        .textures = {hills(true)}};
}

// A ramp is hit exactly, whatever the number of steps: the last step's line is the ramp.
Case ramp() {
    static const auto texture =
        height_texture({64, 64}, false, [](double u, double) { return (u + 0.5) / 64.0; });
    return {
        .name = "parallax_ramp",
        .include = kFile,
        .inputs = 9,
        .outputs = 1,
        .glsl = std::string(kMarch) + "put(0, hit.height);",
        .draw =
            [](Random& random, Draw& in) {
                in.put(0, glm::dvec2(random.uniform(0.3, 0.7), 0.5));
                in.put(2, glm::dvec3(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                     random.uniform(0.5, 1.0)));
                in.put(5, 0.0);
                const double scale = random.magnitude(0.01, 0.1);
                in.put(6, glm::dvec2(scale, -scale));
                in.put(8, 1 + random.below(32));
            },
        // scale (s + y run) - scale = y, for the height y.
        .reference = [](const In& in,
                        Expect& out) { out.put(0, in[6] * (in[0] - 1.0) / (1.0 - in[6] * in[2] / in[4])); },
        // 16 roundings of numbers below 0.1, through a crossing at least as steep as 0.8 to 1; 64 texels of
        // place.
        .bound = {.absolute = 0.1 * (16 + 3 * 64.0 / 64.0) * 3 * kUlp},
        .mutants = {{kFile, "gap < 0.0 ? clamp(gap / (gap - gap_before), 0.0, 1.0) : 0.0", "0.5"}},
        .textures = {texture}};
}

// The same with a mip chain, at footprints of 1 to 16 texels along one axis.
Case steps_at_levels(bool whole) {
    Case item = steps();
    item.name = whole ? "parallax_steps_at_whole_levels" : "parallax_steps_between_levels";
    item.draw = [whole, draw = item.draw](Random& random, Draw& in) {
        draw(random, in);
        const double texels = whole ? 1 << random.below(5) : random.magnitude(1.0, 16.0);
        in.put(5, glm::dvec2(texels / kSize.x, 0.0)), in.put(7, glm::dvec2(0.0, 0.5 * texels / kSize.y));
    };
    item.reference = [](const In& in, Expect& out) {
        const CaseTexture& map = *hills(true);
        out.put(0, ref::parallax_steps(map.image, map.sampler, {2.0, -1.0}, {in.v2(0), in.v2(5), in.v2(7)},
                                       in.v2(2), static_cast<int>(in[4])));
    };
    // Whole levels: as above, and a rounded footprint is off the level by 1e-6, between levels that differ by
    // at most 2. Between them the driver's level is off by up to 0.05.
    item.bound.absolute += (whole ? 1e-6 : 0.05) * 2.0 / 8.0;  // the condition is above 8 strides
    if (!whole) item.blunt = "the driver's level of detail is approximate; whole levels are exact";
    item.textures = {hills(true)};
    item.mutants = {{kFile, "uv.st + offset, uv.dx, uv.dy).x", "uv.st + offset, vec2(0.0), vec2(0.0)).x"}};
    return item;
}

// Inputs: 0 st, 2 heights, 4 level.
Case height() {
    return {.name = "parallax_height",
            .include = kFile,
            .inputs = 5,
            .outputs = 1,
            .glsl = "put(0, sg_parallax_height(image_0, sampler_0, v2(2), v2(0), f(4)));",
            .draw =
                [](Random& random, Draw& in) {
                    in.put(0, glm::dvec2(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)));
                    in.put(2, glm::dvec2(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)));
                    in.put(4, random.uniform(-1.0, 6.0));
                },
            .reference =
                [](const In& in, Expect& out) {
                    const CaseTexture& map = *hills(true);
                    out.put(0, ref::parallax_height(map.image, map.sampler, in.v2(2), in.v2(0), in[4]));
                },
            // A place off by 3 roundings of 61 texels, times a slope of 0.2, and 8 of the filter; a product
            // and a sum (2); all of heights below 0.6; doubled.
            .bound = {.absolute = 2 * 0.6 * (3 * 61 * 0.2 + 10) * kUlp},
            .textures = {hills(true)}};
}

std::vector<Case> cases() {
    return {height(),     steps(), steps_at_levels(true), steps_at_levels(false), occlusion(),
            on_the_ray(), ramp()};
}

SG_PROVE(ParallaxMarch, cases());

TEST(ParallaxMarch, FewMarchesHangOnRounding) {
    expect_few_skipped(occlusion(), 0.01);
}

// Texels that are not numbers: the march goes on to the bottom, and all stays finite.
TEST(ParallaxMarch, TexelsThatAreNotNumbers) {
    Case item = occlusion();
    item.textures = {height_texture({4, 4}, false, [](double, double) { return NAN; })};
    const std::vector<float> in = {0.5f, 0.5f, 0.3f, 0.2f, 0.8f, 0.0f, 0.1f, -0.1f, 8.0f};
    const std::vector<float> out = evaluate(item, in);
    EXPECT_NEAR(out[2], -0.1, 1e-6);
    EXPECT_TRUE(std::isfinite(out[0]) && std::isfinite(out[1]));
}

// At and below the horizon: as at 1.8 degrees above it, and finite.
TEST(ParallaxMarch, BelowTheHorizon) {
    const Case item = occlusion();
    for (float z : {0.0f, -0.5f, 0.03125f}) {
        const std::vector<float> out =
            evaluate(item, std::vector<float>{0.5f, 0.5f, 0.3f, 0.2f, z, 0.0f, 0.1f, -0.1f, 16.0f});
        const std::vector<float> least =
            evaluate(item, std::vector<float>{0.5f, 0.5f, 0.3f, 0.2f, 0.03125f, 0.0f, 0.1f, -0.1f, 16.0f});
        EXPECT_EQ(out, least);
    }
}

// Lengyel's map and scale: a flat map of height h, n_z = 1, moves by s h' v / r with h' = h - 1/2, in any
// number of steps.
TEST(ParallaxMarch, StepsWithLengyelsScale) {
    for (int k : {1, 2, 4, 8}) {
        const auto flat = height_texture({4, 4}, false, [](double, double) { return 0.75; });
        const glm::dvec2 view(0.3, -0.4), dim(128.0, 64.0);
        const glm::dvec2 stride = view * ref::parallax_scale(24.0, k, dim);
        const glm::dvec2 offset =
            ref::parallax_steps(flat->image, flat->sampler, {2.0, -1.0}, {{0.5, 0.5}, {}, {}}, stride, k);
        EXPECT_LT(glm::length(offset - 24.0 * 0.25 * view / dim), 1e-12) << k;
    }
}

}  // namespace
}  // namespace sg::proof

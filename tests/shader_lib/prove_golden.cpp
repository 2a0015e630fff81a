// The golden vectors of the specification (section 5): worked by hand in double precision, held by the GLSL
// to 1e-5.
#include "harness.hpp"

namespace sg::proof {
namespace {

struct Golden {
    const char* name;
    const char* include;
    const char* glsl;  // an expression over the inputs
    std::vector<float> inputs;
    std::vector<float> expected;
};

const float kR14 = static_cast<float>(1.0 / std::sqrt(14.0));

const Golden kGoldens[] = {
    {"flat", "surfgrad/deriv.glsl", "sg_deriv_from_normal_xyz(v3(0))", {0, 0, 1}, {0, 0}},
    {"leans_to_s", "surfgrad/deriv.glsl", "sg_deriv_from_normal_xyz(v3(0))", {0.6f, 0, 0.8f}, {-0.75f, 0}},
    {"leans_to_both",
     "surfgrad/deriv.glsl",
     "sg_deriv_from_normal_xyz(v3(0))",
     {0.6f, 0.48f, 0.64f},
     {-0.9375f, -0.75f}},
    {"green_up",
     "surfgrad/deriv.glsl",
     "sg_deriv_green_up(sg_deriv_from_normal_xyz(v3(0)))",
     {0.6f, 0.48f, 0.64f},
     {-0.9375f, 0.75f}},
    {"level", "surfgrad/deriv.glsl", "sg_deriv_from_normal_xyz(v3(0))", {1, 0, 0}, {-128, 0}},
    {"unnormalised", "surfgrad/deriv.glsl", "sg_deriv_from_normal_xyz(v3(0))", {0.3f, -0.2f, 0.1f}, {-3, 2}},
    {"two_channels",
     "surfgrad/deriv.glsl",
     "sg_deriv_from_normal_xy(v2(0))",
     {0.8f, 0.6f},
     {-102.4f, -76.8f}},
    {"two_channels_too_long", "surfgrad/deriv.glsl", "sg_deriv_from_normal_xy(v2(0))", {1, 1}, {-128, -128}},
    {"from_normal",
     "surfgrad/from_normal.glsl",
     "sg_surfgrad_from_normal(v3(0), v3(3))",
     {kR14, 2 * kR14, 3 * kR14, 0, 0, 1},
     {0.2672612f, 0.5345225f, -0.4454354f}},
    {"from_normal_resolved",
     "surfgrad/from_normal.glsl surfgrad/resolve.glsl",
     "sg_resolve(v3(0), sg_surfgrad_from_normal(v3(0), v3(3)))",
     {kR14, 2 * kR14, 3 * kR14, 0, 0, 1},
     {0, 0, 1}},
    {"from_inward_normal_resolved",
     "surfgrad/from_normal.glsl surfgrad/resolve.glsl",
     "sg_resolve(v3(0), sg_surfgrad_from_normal(v3(0), v3(3)))",
     {kR14, 2 * kR14, 3 * kR14, 0, 0, -1},
     {0.4285714f, 0.8571429f, 0.2857143f}},
    {"from_volume",
     "surfgrad/from_volume.glsl",
     "sg_surfgrad_from_volume(v3(0), v3(3))",
     {kR14, 2 * kR14, 3 * kR14, 1, 0, 0},
     {0.9285714f, -0.1428571f, -0.2142857f}},
    {"screen_height",
     "surfgrad/from_height.glsl",
     "sg_surfgrad_from_screen_height(sg_frame(vec3(0.0), v3(0), v3(3), v3(6)), v2(9))",
     {0.01f, 0, 0.002f, 0, -0.01f, 0.001f, -0.1951800f, 0.0975900f, 0.9759001f, 0.003f, -0.004f},
     {0.2961905f, 0.4019048f, 0.0190476f}},
    {"pd",
     "surfgrad/combine.glsl",
     "sg_combine_pd(normalize(v3(0)), normalize(v3(3)))",
     {0.3f, 0.1f, 0.9f, -0.2f, 0.4f, 0.8f},
     {0.0709277f, 0.5201367f, 0.8511328f}},
    {"additive_is_pd",
     "surfgrad/combine.glsl",
     "sg_combine_additive(normalize(v3(0)), normalize(v3(3)))",
     {0.3f, 0.1f, 0.9f, -0.2f, 0.4f, 0.8f},
     {0.0709277f, 0.5201367f, 0.8511328f}},
    {"weighted_by_ones_is_pd",
     "surfgrad/combine.glsl",
     "sg_combine_weighted(normalize(v3(0)), normalize(v3(3)), vec2(1.0))",
     {0.3f, 0.1f, 0.9f, -0.2f, 0.4f, 0.8f},
     {0.0709277f, 0.5201367f, 0.8511328f}},
    {"rnm",
     "surfgrad/combine.glsl",
     "sg_combine_rnm(normalize(v3(0)), normalize(v3(3)))",
     {0.3f, 0.1f, 0.9f, -0.2f, 0.4f, 0.8f},
     {0.0599892f, 0.5291715f, 0.8463917f}},
    {"height_4x4_upper_left",
     "surfgrad/height_map.glsl",
     "sg_deriv_from_heights_4x4(v4(0), v4(4), v4(8), v4(12), v2(16))",
     {0, 1, 0, 2, 3, 5, 1, 0, 2, 2, 4, 1, 1, 0, 3, 3, 0, 0},
     {-0.25f, 1}},
    {"height_4x4_lower_right",
     "surfgrad/height_map.glsl",
     "sg_deriv_from_heights_4x4(v4(0), v4(4), v4(8), v4(12), v2(16))",
     {0, 1, 0, 2, 3, 5, 1, 0, 2, 2, 4, 1, 1, 0, 3, 3, 1, 1},
     {-0.5f, 0.25f}},
};

class GoldenVectors : public testing::TestWithParam<Golden> {};

void PrintTo(const Golden& golden, std::ostream* out) {
    *out << golden.name;
}

TEST_P(GoldenVectors, Hold) {
    const Golden& golden = GetParam();
    Case item = {.name = golden.name,
                 .include = golden.include,
                 .inputs = static_cast<int>(golden.inputs.size()),
                 .outputs = static_cast<int>(golden.expected.size()),
                 .glsl = std::string("put(0, ") + golden.glsl + ");"};
    const std::vector<float> got = evaluate(item, golden.inputs);
    for (std::size_t k = 0; k < got.size(); ++k) {
        // 1e-5 of 1, and of the number itself where it is larger.
        EXPECT_NEAR(got[k], golden.expected[k], 1e-5 * std::max(1.0f, std::abs(golden.expected[k])))
            << "output " << k;
    }
}

INSTANTIATE_TEST_SUITE_P(Section5, GoldenVectors, testing::ValuesIn(kGoldens),
                         [](const auto& golden) { return std::string(golden.param.name); });

}  // namespace
}  // namespace sg::proof

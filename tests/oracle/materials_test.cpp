// Every sample material: what lavapipe draws is what the interpreter computes, and wrong shaders or wrong
// modules do not pass for right.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "tests/oracle/material_oracle.hpp"
#include "tests/oracle/module_mutants.hpp"
#include "tests/render/workshop.hpp"
#include "tests/support/own_levels.hpp"

namespace sg::oracle {
namespace {

std::string report(const std::string& name, const Comparison& c) {
    return fmt::format(
        "{:44} median {:.6f} (bound {:.6f})  p99.9 {:.6f} (bound {:.6f})  {:.3f} % beyond their own  of {} "
        "pixels, {:.3f} % undecided\n",
        name, c.median, c.median_bound, c.p999, c.p999_bound, 100 * c.beyond, c.pixels, 100 * c.undecided);
}

const std::vector<ir::PixelInputs>& inputs_of(const std::string& sample, Seen seen) {
    static std::map<std::pair<std::string, Seen>, std::vector<ir::PixelInputs>> inputs;
    auto [at, fresh] = inputs.try_emplace({sample, seen});
    if (fresh) at->second = draw_inputs(sample, seen);
    return at->second;
}

// Wrong shaders and modules are wrong everywhere: a part of the pixels tells.
constexpr std::size_t kStride = 3;
// Of modules with more values, too.
constexpr std::size_t kLarge = 100;

class Silence : public testing::Environment {
public:
    void TearDown() override { EXPECT_EQ(validation_messages(), std::vector<std::string>{}); }
};
const testing::Environment* const kSilence =
    testing::AddGlobalTestEnvironment(new Silence);  // gtest deletes it

// Of the pixels that tell of a wrong module of a sample: about 500, or 170 of a large one.
constexpr std::size_t kWrongStride = 7;
constexpr std::size_t kWrongModules = 2;  // noticed ones that are enough; each costs a comparison
// The share of pixels beyond their own bound from which on a module is wrong: ten times what one that holds
// may have, for so few pixels.
constexpr double kWrongBeyond = 0.01;

// How many modules that are wrong in one place are noticed, of the table's rows from the last on. The right
// one is not.
std::size_t notice_wrong_modules(const Material& material, const std::string& sample,
                                 const std::vector<ref::dvec3>& normals, std::size_t stride) {
    auto beyond = [&](const ir::Module& module, std::string_view name) {
        const Comparison c = compare(material, module, inputs_of(sample, Seen::outside), normals, stride);
        EXPECT_GT(c.pixels, 100u);
        fmt::print("  {}", report(std::string(name), c));
        return c.beyond > kWrongBeyond;
    };
    EXPECT_FALSE(beyond(material.module, "right"));
    const auto start = std::chrono::steady_clock::now();
    std::size_t noticed = 0;
    const auto mutants = all_module_mutants();
    for (auto mutant = mutants.rbegin(); mutant != mutants.rend() && noticed < kWrongModules; ++mutant) {
        ir::Module wrong = material.module;
        if (!apply_last(*mutant, wrong)) continue;
        EXPECT_EQ(ir::verify(wrong), "") << mutant->name;
        noticed += beyond(wrong, mutant->name) ? 1 : 0;
    }
    fmt::print("  wrong modules took {:.1f} s\n",
               std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return noticed;
}

class MaterialOracle : public testing::TestWithParam<std::string> {};

TEST_P(MaterialOracle, RenderAgreesWithTheInterpreter) {
    const std::string& sample = GetParam();
    for (Seen seen : {Seen::outside, Seen::inside}) {
        if (seen == Seen::inside && inputs_of(sample, seen).empty()) continue;  // one-sided
        for (Levels levels : {Levels::first, Levels::all}) {
            const Material material(sample, levels);
            if (material.module.values.empty()) GTEST_SKIP() << "a custom layer has no equivalent";
            // Each input and each read is moved by itself: the time grows with the square of a module's size.
            const std::size_t part = material.module.values.size() > kLarge ? kStride : 1;
            // At the first level the shipped text, for there the hardware has nothing to choose.
            const target::ShaderLibrary library =
                levels == Levels::first ? target::embedded_library() : test::with_own_levels();
            const std::vector<ref::dvec3> normals = draw_normals(sample, seen, levels, library);
            const Comparison c = compare(material, material.module, inputs_of(sample, seen), normals,
                                         seen == Seen::outside ? part : 2 * part);
            const std::string text =
                report(fmt::format("{}{}{}", sample, seen == Seen::outside ? "" : ", back faces",
                                   levels == Levels::first ? ", first level" : ", all levels"),
                       c);
            fmt::print("{}", text);
            EXPECT_TRUE(c.holds()) << text;
            // A bound that says nothing would not be worth its derivation.
            // (Near a pole a map changes by up to 3 degrees within the level that a driver may be off.)
            // (Behind parallax, a ray that grazes the surface moves the hit by many times what rounding does
            // to heights.)
            const bool grazes = std::any_of(material.module.values.begin(), material.module.values.end(),
                                            [](const ir::Value& v) { return ir::looks_along_ray(v.op); });
            EXPECT_LT(c.p999_bound, levels == Levels::all ? 3.0 : grazes ? 0.15 : 0.05);
            if (seen == Seen::outside && levels == Levels::first) {
                EXPECT_GT(notice_wrong_modules(material, sample, normals, kWrongStride * part), 0u);
            }
        }
    }
}

std::string test_name(const testing::TestParamInfo<std::string>& row) {
    const std::size_t slash = row.param.rfind('/') + 1;
    return row.param.substr(slash, row.param.find('.') - slash);
}

INSTANTIATE_TEST_SUITE_P(Samples, MaterialOracle, testing::ValuesIn(all_samples()), test_name);

class FigureOracle : public testing::TestWithParam<std::string> {};

TEST_P(FigureOracle, RenderAgreesWithTheInterpreter) {
    const std::string& sample = GetParam();
    const Material material(sample, Levels::first);
    const std::vector<ref::dvec3> normals =
        draw_normals(sample, Seen::outside, Levels::first, target::embedded_library());
    const Comparison c =
        compare(material, material.module, inputs_of(sample, Seen::outside), normals, kStride);
    const std::string text = report(sample, c);
    fmt::print("{}", text);
    EXPECT_TRUE(c.holds()) << text;
    std::size_t bumped = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const ref::dvec3 base = glm::normalize(inputs_of(sample, Seen::outside)[i].vertex_normal);
        bumped += glm::distance(normals[i], base) > 0.01 ? 1 : 0;
    }
    fmt::print("  {} of {} pixels have a bump\n", bumped, normals.size());
    EXPECT_GT(bumped, 30u);
}

INSTANTIATE_TEST_SUITE_P(PaperFigures, FigureOracle, testing::ValuesIn(truth::figure_materials()), test_name);

// ---- wrong shaders ----

struct ShaderMutant {
    std::string name;
    std::string file;  // of the shader library
    std::string text;  // must stand there exactly once, so that this table cannot rot
    std::string wrong;
    std::string sample;
    Levels levels = Levels::first;
};
std::ostream& operator<<(std::ostream& out, const ShaderMutant& m) {
    return out << m.name;
}

const std::vector<ShaderMutant> kShaderMutants = {
    {"flip_sign_is_forgotten", "surfgrad/tbn.glsl", "det < 0.0 ? -frame.flip_sign : frame.flip_sign",
     "det < 0.0 ? -1.0 : 1.0", "normal_map.json"},
    {"vertex_frame_not_scaled", "surfgrad/tbn.glsl", "square < 1e30 ? inversesqrt(square) : 0.0;",
     "square < 1e30 ? 1.0 : 0.0;", "two_unwraps.json"},
    {"bitangent_from_the_unit_normal", "surfgrad/tbn.glsl", "side * cross(", "side / scale * cross(",
     "two_unwraps.json"},
    {"negative_tiling_keeps_the_tangent", "surfgrad/tbn.glsl", "scale.x < 0.0 ? -basis.tangent",
     "scale.x < 0.0 ? basis.tangent", "layered.json"},
    {"green_is_not_flipped", "surfgrad/deriv.glsl", "return vec2(d.x, -d.y);", "return d;",
     "normal_map.json"},
    {"slope_of_xy_not_divided_by_z", "surfgrad/deriv.glsl", "return -m * inversesqrt(", "return -m * (",
     "two_unwraps.json"},
    {"zero_is_always_127_and_a_half", "surfgrad/deriv.glsl",
     "vec3 sg_decode_signed(vec3 texel, float zero) {\n    return zero == 127.5 ? 2.0 * texel - 1.0 : "
     "clamp((255.0 * texel - zero) /",
     "vec3 sg_decode_signed(vec3 texel, float zero) {\n    return clamp((255.0 * texel - 127.5) /",
     "two_unwraps.json"},
    {"resolve_adds", "surfgrad/resolve.glsl", "n - g;", "n + g;", "normal_map.json"},
    {"slopes_a_ten_thousandth_too_steep", "surfgrad/resolve.glsl", "n - g;", "n - 1.0001 * g;",
     "normal_map.json"},
    {"base_normal_is_not_normalised", "surfgrad/frame.glsl", "usable ? vertex_normal * inversesqrt(square)",
     "usable ? vertex_normal", "normal_map.json"},
    {"uv_derivatives_are_swapped", "stage/fragment.glsl", "dFdxFine(st), dFdyFine(st)",
     "dFdyFine(st), dFdxFine(st)", "normal_map.json"},
    {"cone_without_the_quotient_rule", "surfgrad/decal.glsl", "(row_s - slope.x * row_ahead)", "row_s",
     "decal.json"},
    {"decal_at_any_angle", "surfgrad/decal.glsl", "facing > cos_none ? t : 0.0",
     "facing > cos_none ? 1.0 : 0.0", "decal.json"},
    {"decal_fades_linearly", "surfgrad/decal.glsl", "t * t * (3.0 - 2.0 * t)", "t", "decal.json"},
    {"whiteout_of_one_height", "surfgrad/combine.glsl", "float z = a.z * b.z;", "float z = a.z;",
     "normal_blend.json"},
    {"reoriented_the_other_way", "surfgrad/combine.glsl", "vec3 u = vec3(-b.xy, b.z);",
     "vec3 u = vec3(b.xy, b.z);", "normal_blend.json"},
    {"parallax_goes_the_other_way", "surfgrad/parallax.glsl", "{ return height * view.xy; }",
     "{ return -height * view.xy; }", "parallax_offset.json"},
    {"march_ends_at_a_step", "surfgrad/parallax.glsl", "float height = ray + back * drop;",
     "float height = ray;", "parallax_occlusion.json"},
    {"the_mesh_keeps_its_normal", "surfgrad/parallax.glsl", "n + pixels.x * dndx + pixels.y * dndy", "n",
     "parallax_occlusion.json"},
    {"half_a_parallax_map_is_lost", "surfgrad/parallax.glsl", "(decode.x * texel + decode.y)",
     "max(decode.x * texel + decode.y, 0.0)", "parallax_steps.json"},
    {"detail_stays_where_the_mesh_is", "surfgrad/parallax.glsl",
     "uv.st + pixels.x * uv.dx + pixels.y * uv.dy", "uv.st", "parallax_detail.json"},
    {"world_forgets_the_camera", "stage/world.glsl", "relative.p + sg_frame_block.camera_position.xyz",
     "relative.p", "planar.json"},
    {"world_behind_parallax_forgets_the_camera", "stage/moved.glsl",
     "frame.position + sg_frame_block.camera_position.xyz", "frame.position", "parallax_dents.json"},
    {"footprints_are_four_times_as_large", "stage/moved.glsl", "frame.dpdx * rows, frame.dpdy * rows",
     "4.0 * frame.dpdx * rows, 4.0 * frame.dpdy * rows", "parallax_dents.json"},
    {"tiling_leaves_dx", "surfgrad/uv.glsl", "uv.st * scale, uv.dx * scale,", "uv.st * scale, uv.dx,",
     "parallax_occlusion.json", Levels::all},
    {"reads_are_half_a_level_too_fine", "surfgrad/sample.glsl", "uv.st, uv.dx, uv.dy);",
     "uv.st, 0.7 * uv.dx, 0.7 * uv.dy);", "parallax_steps.json", Levels::all},
};

class OracleNoticesShader : public testing::TestWithParam<ShaderMutant> {};

TEST_P(OracleNoticesShader, ThatIsWrong) {
    const ShaderMutant& mutant = GetParam();
    target::ShaderLibrary library = target::embedded_library();
    ASSERT_TRUE(library.files.contains(mutant.file));
    std::string& text = library.files[mutant.file];
    const std::size_t at = text.find(mutant.text);
    ASSERT_NE(at, std::string::npos) << "the library changed: '" << mutant.text << "'";
    ASSERT_EQ(text.find(mutant.text, at + 1), std::string::npos)
        << "the library changed: '" << mutant.text << "'";
    text.replace(at, mutant.text.size(), mutant.wrong);
    const Material material(mutant.sample, mutant.levels);
    const Comparison c = compare(material, material.module, inputs_of(mutant.sample, Seen::outside),
                                 draw_normals(mutant.sample, Seen::outside, mutant.levels, library), kStride);
    fmt::print("{}", report(mutant.name, c));
    EXPECT_GT(c.pixels, 1000u);
    EXPECT_FALSE(c.holds());
}

INSTANTIATE_TEST_SUITE_P(Library, OracleNoticesShader, testing::ValuesIn(kShaderMutants),
                         [](const auto& row) { return row.param.name; });

// ---- levels of detail that the hardware finds ----

double middle_angle(const std::vector<ref::dvec3>& a, const std::vector<ref::dvec3>& b) {
    std::vector<double> angles;
    for (std::size_t i = 0; i < a.size(); ++i)
        angles.push_back(std::atan2(glm::length(glm::cross(a[i], b[i])), glm::dot(a[i], b[i])));
    const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
    std::nth_element(angles.begin(), middle, angles.end());
    return *middle;
}

// What the hardware's choice moves normals by, in the middle, against what half a level does: less than a
// quarter, so an eighth of a level (the driver's logarithm alone is up to 0.043 of a level off). A bias of
// half a level is not.
TEST(HardwareLevels, AreThoseOfTheDerivatives) {
    for (const char* sample :
         {"normal_map.json", "two_unwraps.json", "triplanar.json", "planar.json", "layered.json"}) {
        const auto draw = [&](const target::ShaderLibrary& library) {
            return draw_normals(sample, Seen::outside, Levels::all, library);
        };
        target::ShaderLibrary biased = target::embedded_library();
        std::string& text = biased.files["stage/fragment.glsl"];
        text.replace(text.find("uv.st);"), 7, "uv.st, -0.5);");
        const std::vector<ref::dvec3> own = draw(test::with_own_levels());
        const double half_a_level = middle_angle(own, draw(test::with_own_levels("0.70710678 * ")));
        const double hardware = middle_angle(own, draw(target::embedded_library())) / half_a_level;
        const double wrong = middle_angle(own, draw(biased)) / half_a_level;
        fmt::print(
            "{:20} half a level {:.4f} degrees; the hardware's choice {:.3f} of it, with a bias of -0.5 "
            "{:.3f}\n",
            sample, half_a_level * 57.29578, hardware, wrong);
        EXPECT_LT(hardware, 0.25) << sample;
        EXPECT_GT(wrong, 0.25) << sample;
        EXPECT_GT(half_a_level, 1e-3 / 57.29578) << sample;
    }
}

// A user's function that is not what its equivalent says.
TEST(OracleNoticesGlsl, ThatIsWrong) {
    const std::pair<std::string, std::string> mutants[] = {
        {"frequency * sg_noise_power", "1.002 * frequency * sg_noise_power"},
        {"kZero = 128.0", "kZero = 127.5"},
        {"sg_uv_scale(uv, tiling)", "sg_uv_scale(uv, 1.01 * tiling)"},
        {"return sg_surfgrad_from_height", "return -sg_surfgrad_from_height"},
    };
    const Material material("custom.json", Levels::first);
    const std::string file = "shaders/custom.glsl", good = truth::sample_files().at(file);
    for (const auto& [text, wrong] : mutants) {
        std::string bad = good;
        const std::size_t at = bad.find(text);
        ASSERT_NE(at, std::string::npos) << text;
        bad.replace(at, text.size(), wrong);
        const Comparison c = compare(material, material.module, inputs_of("custom.json", Seen::outside),
                                     draw_normals("custom.json", Seen::outside, Levels::first,
                                                  target::embedded_library(), {{file, bad}}),
                                     kStride);
        fmt::print("{}", report(wrong, c));
        EXPECT_GT(c.pixels, 1000u);
        EXPECT_FALSE(c.holds());
    }
}

// ---- wrong modules ----

// The sample with an operation of nearly every kind, seen from both sides: each wrong module breaks one at
// least.
TEST(OracleNoticesModule, ThatIsWrong) {
    const std::string sample = "layered.json";
    const Material material(sample, Levels::first);
    std::size_t applied = 0;
    std::map<std::string_view, bool> noticed;
    for (Seen seen : {Seen::outside, Seen::inside}) {
        const std::vector<ref::dvec3> normals =
            draw_normals(sample, seen, Levels::first, target::embedded_library());
        for (const ModuleMutant& mutant : all_module_mutants()) {
            ir::Module wrong = material.module;
            if (noticed[mutant.name] || !apply_last(mutant, wrong)) continue;
            applied += seen == Seen::outside ? 1 : 0;
            ASSERT_EQ(ir::verify(wrong), "") << mutant.name;
            const Comparison c = compare(material, wrong, inputs_of(sample, seen), normals, kStride);
            fmt::print("{}", report(std::string(mutant.name), c));
            noticed[mutant.name] = c.pixels > 1000 && !c.holds();
        }
    }
    const auto count =
        std::count_if(noticed.begin(), noticed.end(), [](const auto& row) { return row.second; });
    EXPECT_EQ(static_cast<std::size_t>(count), applied);
    EXPECT_GE(applied, 10u);
}

}  // namespace
}  // namespace sg::oracle

// surfgrad-render --view error and --compare as their users meet them.
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <regex>

#include "asset/image.hpp"
#include "base/files.hpp"

namespace sg::proof {
namespace {

struct Result {
    int exit_code = -1;
    std::string text;  // stdout and stderr
};

const char* const kNoise = R"({"version": 1, "name": "grain", "bump": [{"layers": [
    {"id": "grain", "kind": "noise", "function": "perlin", "frequency": 4, "strength": 0.02}]}]})";
const char* const kNegative = R"({"version": 1, "name": "grain", "bump": [{"layers": [
    {"id": "grain", "kind": "noise", "function": "perlin", "frequency": 4, "strength": -0.02}]}]})";
const char* const kMap =
    R"({"version": 1, "textures": {"map": {"file": "map.png", "encoding": "tangent_normal"}},
    "bump": [{"layers": [{"id": "dents", "kind": "normal_map", "texture": "map"}]}]})";
const char* const kBlend =
    R"({"version": 1, "textures": {"map": {"file": "map.png", "encoding": "tangent_normal"}},
    "bump": [{"layers": [{"id": "both", "kind": "normal_blend", "texture": "map", "second_texture": "map", "method": "rnm"}]}]})";

class ErrorView : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(SG_BINARY_DIR) / "tests" / "error_view" /
                  testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::remove_all(folder_);
        asset::Image flat = asset::make_image(8, 8, asset::TexelFormat::unorm8);
        for (std::uint32_t i = 0; i < 64; ++i) {
            for (int c = 0; c < 4; ++c) flat.set(i % 8, i / 8, c, c < 2 ? 127.5 / 255 : 1);
        }
        ASSERT_EQ(files_.write_all({{folder_ / "noise.json", kNoise},
                                    {folder_ / "negative.json", kNegative},
                                    {folder_ / "map.json", kMap},
                                    {folder_ / "blend.json", kBlend},
                                    {folder_ / "map.png", asset::png_bytes(flat)}}),
                  "");
    }
    Result run(const std::string& arguments, const std::string& program = "surfgrad-render") {
        std::string command =
            "cd '" + folder_.string() + "' && '" SG_BINARY_DIR "/" + program + "' " + arguments + " 2>&1";
        Result result;
        FILE* pipe = popen(command.c_str(), "r");
        if (pipe == nullptr) return result;
        char part[4096];
        while (std::size_t size = fread(part, 1, sizeof(part), pipe)) result.text.append(part, size);
        int status = pclose(pipe);
        if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
        return result;
    }
    void expect(const std::string& arguments, int code, const std::string& text) {
        const Result result = run(arguments);
        EXPECT_EQ(result.text, text);
        EXPECT_EQ(result.exit_code, code);
    }
    // The numbers of the line that a run prints first.
    struct Line {
        double median = -1, p95 = -1, p99 = -1, max = -1, pixels = -1;
    };
    Line numbers(const std::string& arguments, int code = 0) {
        const Result result = run(arguments);
        EXPECT_EQ(result.exit_code, code) << result.text;
        std::smatch m;
        const std::regex line("^median (\\S+)  p95 (\\S+)  p99 (\\S+)  max (\\S+) degrees, (\\d+) pixels\n");
        if (!std::regex_search(result.text, m, line)) {
            ADD_FAILURE() << result.text;
            return {};
        }
        return {std::stod(m[1]), std::stod(m[2]), std::stod(m[3]), std::stod(m[4]), std::stod(m[5])};
    }

    RealFiles files_;
    std::filesystem::path folder_;
};

// Heights of 0.02 units with waves of a quarter: tilts to 20 degrees. What bump mapping leaves out is the
// tilt times height over radius of curvature, on a plane nothing: there, roundings of positions (1e-7 over
// differences of a pixel's 0.02) and facets.
TEST_F(ErrorView, MeasuresHowFarANormalIsFromTheDisplacedSurface) {
    const Line plane = numbers("noise.json --view error --mesh plane --size 96 -o map.png");
    EXPECT_LT(plane.max, 0.02);
    EXPECT_GT(plane.pixels, 2000);
    const Line sphere = numbers("noise.json --view error --mesh sphere --detail 4 --size 96 -o map.exr");
    EXPECT_LT(sphere.p99, 20 * 0.02);
    EXPECT_GT(sphere.median, plane.median);
    for (const char* mesh : {"torus", "rounded_cube", "rock"})
        EXPECT_LT(numbers(std::string("noise.json --view error --size 64 --detail 4 --mesh ") + mesh).median,
                  0.5);
    Diags diags;
    const auto png = asset::read_image(files_.read(folder_ / "map.png").bytes, "map.png", {}, diags);
    ASSERT_TRUE(png);
    EXPECT_EQ(png->height, 96u + 22u);
    const auto exr = asset::read_image(files_.read(folder_ / "map.exr").bytes, "map.exr", {}, diags);
    ASSERT_TRUE(exr);
    EXPECT_GT(exr->at(48, 48, 3), 0);
}

TEST_F(ErrorView, TakesHeightsForAMapOfSlopes) {
    // The heights are flat; the map's 8-bit codes are 0.32 degrees off (128 is not the middle).
    EXPECT_NEAR(numbers("map.json --view error --mesh plane --size 32 --height-of map=map.png:0.1").max,
                0.317, 0.01);
    expect("map.json --view error --mesh plane --size 32", 1,
           "error: layer 'dents' (normal_map), texture 'map' has no height: it holds slopes, and the heights "
           "that it was baked from are not given [SG2107]\n");
    expect("map.json --view error --height-of mat=map.png", 1,
           "error: --height-of: the material has no texture 'mat', did you mean 'map'? [SG1201]\n");
    expect(
        "map.json --view error --height-of map=map.png:x", 2,
        "error: --height-of: expected TEXTURE=FILE or TEXTURE=FILE:LENGTH, not 'map=map.png:x' [SG2105]\n");
    expect("blend.json --view error --mesh plane", 1,
           "error: layer 'both' (normal_blend) has no height: it blends two normals, which is no sum of "
           "heights [SG2107]\n");
}

TEST_F(ErrorView, SaysWhatItCannotJudge) {
    expect("noise.json --view error --mesh cube --size 32", 1,
           "error: 'cube' stands for no smooth surface that could be displaced [SG2108]\n");
    EXPECT_EQ(run("compile noise.json -o out", "surfgradc").exit_code, 0);
    expect("out/noise.json --view error --size 32", 1,
           "error: 'noise.ir' is not beside the manifest [SG2109]\n");
    EXPECT_EQ(run("compile noise.json -o out --emit ir", "surfgradc").exit_code, 0);
    EXPECT_LT(numbers("out/noise.json --view error --mesh plane --size 32").max, 0.1);
    EXPECT_EQ(files_.write_all({{folder_ / "out" / "noise.ir", "module \"grain\"\n%0 = nothing : Scalar\n"}}),
              "");
    expect("out/noise.json --view error --size 32", 1,
           "noise.ir:2:1: error: unknown operation 'nothing' [SG2112]\n%0 = nothing : "
           "Scalar\n^^^^^^^^^^^^^^^^^^^^^\n"
           "    compile the material again with --emit ir; a text of your own: give the operation what it "
           "takes\n");
}

TEST_F(ErrorView, ComparesMaterialsArtefactsAndPictures) {
    EXPECT_EQ(numbers("noise.json --compare noise.json --size 64").max, 0);
    EXPECT_GT(numbers("noise.json --compare negative.json --size 64 -o map.png").median, 2);
    EXPECT_EQ(run("noise.json --view normal --size 64 -o a.exr").text, "");
    EXPECT_EQ(run("noise.json --view normal --size 32 -o small.pfm").text, "");
    EXPECT_EQ(numbers("a.exr --compare noise.json --size 64").max, 0);
    EXPECT_EQ(numbers("noise.json --compare a.exr --size 64").max, 0);
    EXPECT_EQ(numbers("a.exr --compare a.exr").max, 0);
    expect("a.exr --compare small.pfm", 1,
           "error: 'a.exr' has 64x64 pixels, but 'small.pfm' has 32x32 [SG2110]\n");
    expect(
        "noise.json --compare map.png", 1,
        "error: 'map.png' does not hold floats, expected normals as .exr or .pfm, as surfgrad-render --view "
        "normal writes them [SG2110]\n");
}

TEST_F(ErrorView, FailsAboveTheLargestAngleAllowed) {
    numbers("noise.json --view error --mesh plane --size 32 --max-angle 1");
    numbers("noise.json --compare negative.json --size 32 --max-angle 60:median");
    const Result result = run("noise.json --compare negative.json --mesh plane --size 32 --max-angle 1:p95");
    EXPECT_EQ(result.exit_code, 1);
    // The angle itself is not ours to fix in a text.
    const std::string message = result.text.substr(result.text.find('\n') + 1);
    double angle = 0;
    ASSERT_EQ(std::sscanf(message.c_str(), "error: the 95th percentile is %lf", &angle), 1) << message;
    EXPECT_GT(angle, 1);
    const std::string shown = fmt::format("{:.4g}", angle);
    EXPECT_EQ(message, "error: the 95th percentile is " + shown +
                           " degrees, more than the 1 that --max-angle allows [SG2106]\n");
}

TEST_F(ErrorView, SaysWhatIsWrongWithItsArguments) {
    expect("noise.json -o a.png --max-angle 1", 2,
           "error: --max-angle and --error-scale: expected --view error or --compare beside them [SG2105]\n");
    expect("noise.json --view error --max-angle 1:most", 2,
           "error: --max-angle: expected DEGREES or DEGREES:median, :p95, :p99 or :max, not '1:most' "
           "[SG2105]\n");
    expect("noise.json --view error --error-scale 0", 2,
           "error: --error-scale: expected more than 0 and at most 180 degrees, not '0' [SG2105]\n");
    expect("noise.json --view error --compare negative.json", 2,
           "error: --compare: expected another view than error beside it [SG2105]\n");
    expect("noise.json --view error --dump-inputs a.exr", 2,
           "error: --dump-inputs: expected neither --view error nor --compare beside it [SG2105]\n");
    expect("noise.json -o a.png --height-of map=map.png", 2,
           "error: --height-of: expected --view error beside it [SG2105]\n");
    expect("noise.json --view error --supersample 2", 2,
           "error: --supersample: expected 1 where angles are measured [SG2105]\n");
}

}  // namespace
}  // namespace sg::proof

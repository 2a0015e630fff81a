// surfgrad-render as its users meet it: arguments in, text, files and exit code out.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "asset/image.hpp"
#include "base/files.hpp"
#include "tests/unit/runtime/sample_artefact.hpp"

namespace sg::runtime {
namespace {

struct Result {
    int exit_code = -1;
    std::string text;  // stdout and stderr
};

// `environment`: NAME=VALUE ..., for this run alone.
Result run_in(const std::filesystem::path& folder, const std::string& arguments,
              const std::string& environment = "") {
    std::string command = "cd '" + folder.string() + "' && env " + environment +
                          " '" SG_BINARY_DIR "/surfgrad-render' " + arguments + " 2>&1";
    Result result;
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return result;
    char part[4096];
    while (std::size_t size = fread(part, 1, sizeof(part), pipe)) result.text.append(part, size);
    int status = pclose(pipe);
    if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
    return result;
}

class Program : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(SG_BINARY_DIR) / "tests" / "program_test" /
                  testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::remove_all(folder_);
        ASSERT_EQ(files_.write_all(test::sample_files(folder_)), "");
    }
    Result run(const std::string& arguments, const std::string& environment = "") {
        return run_in(folder_, arguments, environment);
    }
    asset::Image read(const std::string& name) {
        Diags diags;
        auto image = asset::read_image(files_.read(folder_ / name).bytes, name, {}, diags);
        EXPECT_TRUE(image) << sg::render(diags);
        return image.value_or(asset::make_image(1, 1, asset::TexelFormat::unorm8));
    }
    void expect(const std::string& arguments, int code, const std::string& text,
                const std::string& environment = "") {
        Result result = run(arguments, environment);
        EXPECT_EQ(result.text, text);
        EXPECT_EQ(result.exit_code, code);
    }

    RealFiles files_;
    std::filesystem::path folder_;
};

TEST_F(Program, DrawsAPictureInEachFormatCleanly) {
    for (std::string name : {"lit.png", "lit.exr", "lit.pfm"}) {
        expect("sample.json -o " + name + " --size 96x64 --mesh plane --validate", 0, "");
        asset::Image image = read(name);
        EXPECT_EQ(image.width, 96u);
        EXPECT_EQ(image.height, 64u);
    }
}

TEST_F(Program, SameArgumentsSameBytes) {
    expect("sample.json -o a.png --size 64", 0, "");
    expect("sample.json -o b.png --size 64", 0, "");
    EXPECT_EQ(files_.read(folder_ / "a.png").bytes, files_.read(folder_ / "b.png").bytes);
}

TEST_F(Program, SaysWhatIsWrongWithItsArguments) {
    expect("sample.json", 2, "error: nothing to write: give -o FILE or --dump-inputs FILE [SG2105]\n");
    expect("sample.json -o a.exr --dump-inputs ./a.exr", 2,
           "error: --dump-inputs: expected another file than -o, not './a.exr' [SG2105]\n");
    expect("-o a.png", 2, "error: no artefact and no material is given; see --help [SG2105]\n");
    expect("sample.json -o a.gif", 2,
           "error: --output: expected a file that ends in .png, .exr or .pfm, not 'a.gif' [SG2105]\n");
    expect("sample.json -o a.png --size 0x10", 2,
           "error: --size: expected WIDTHxHEIGHT, each from 1 to 16384, not '0x10' [SG2105]\n");
    expect("sample.json -o a.png --camera 1,2,3:1,2,3", 2,
           "error: --camera: expected X,Y,Z:X,Y,Z or X,Y,Z:X,Y,Z:FOV (two different points, 0.1 to 170 "
           "degrees), not "
           "'1,2,3:1,2,3' [SG2105]\n");
    expect("sample.json -o a.png --light 0,0,0", 2,
           "error: --light: expected X,Y,Z, not all 0, not '0,0,0' [SG2105]\n");
    expect(
        "sample.json -o a.png --mesh sphre", 2,
        "error: 'sphre' is neither a built-in shape ('plane', 'sphere', 'torus', 'cube', 'rounded_cube' or "
        "'rock') nor a file, did you mean 'sphere'? [SG2105]\n");
    expect("sample.json -o a.png --param gain=x", 2,
           "error: parameter 'gain' is a float: expected 1 number separated by commas, not 'x' [SG2105]\n");
    expect("sample.json -o a.png --param gain=9", 2,
           "error: parameter 'gain' must be from 0 to 4, not 9 [SG2105]\n");
    expect("sample.json -o a.png --mesh-material steel", 2,
           "error: --mesh-material: the shape 'sphere' has no materials, expected a --mesh FILE.gltf or "
           "FILE.glb "
           "[SG2105]\n");
    std::ofstream(folder_ / "a.gltf")
        << R"({"asset":{"version":"2.0"},"materials":[{"name":"steel"}],"accessors":[{"componentType":5126,)"
           R"("type":"VEC3","count":3,"bufferView":0}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":)"
           R"([{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
           R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],"meshes":[{"primitives":[{"material":0,)"
           R"("attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}]})";
    expect(
        "sample.json -o a.png --mesh a.gltf --mesh-material steal", 2,
        "error: --mesh-material: 'a.gltf' has no material 'steal', expected 'steel', did you mean 'steel'? "
        "[SG2105]\n");
    EXPECT_EQ(run("--no-such-option").exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.png"));
}

TEST_F(Program, SaysWhatAMaterialDoesNotHave) {
    expect("sample.json -o a.png --view base-normals", 1,
           "error: material 'sample' has no view 'base-normals', did you mean 'base-normal'? (it has 'lit', "
           "'position', "
           "'base-normal', 'uv0', 'uv0-derivatives', 'tangent', 'unprojected' or 'facing') [SG2103]\n");
    expect("sample.json -o a.png --param gian=1", 1,
           "error: material 'sample' has no parameter 'gian', did you mean 'gain'? (it has 'tint' or 'gain') "
           "[SG2104]\n");
}

TEST_F(Program, FindsTexturesBelowTheirRoot) {
    std::filesystem::rename(folder_ / "pictures", folder_ / "elsewhere");
    expect("sample.json -o a.png", 1,
           "error: texture 'paint' is missing: no file 'pictures/paint.png' below '.'; --texture-root names "
           "another "
           "folder [SG1301]\n");
    std::filesystem::create_directory(folder_ / "root");
    std::filesystem::rename(folder_ / "elsewhere", folder_ / "root/pictures");
    expect("sample.json -o a.png --size 16 --texture-root root", 0, "");
    expect("--texture-root root sample.json -o a.png --size 16", 0, "");
    for (const std::string root : {"nowhere", "sample.json"})
        expect("sample.json -o b.png --texture-root " + root, 2,
               "error: --texture-root: expected a folder, not '" + root + "' [SG2105]\n");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "b.png"));
}

// Options that may be repeated take one value each, so that the file may stand behind them.
TEST_F(Program, AFileMayStandBehindAnyOption) {
    expect("--param gain=0.5 --param tint=1,0,0 sample.json --size 16 -o a.png", 0, "");
    expect("sample.json --param tint=1,0,0 --param gain=0.5 --size 16 -o b.png", 0, "");
    EXPECT_TRUE(files_.read(folder_ / "a.png").bytes == files_.read(folder_ / "b.png").bytes);
    expect("-o c.png --height-of paint=a.png sample.json", 2,
           "error: --height-of: expected --view error beside it [SG2105]\n");
}

// A texture parameter: the picture is that of the instance which has the same values.
TEST_F(Program, ExchangesTextures) {
    const std::string base = "'" SG_SOURCE_DIR "/materials/switches.json' --size 64 ";
    const std::string values = "--param painted=false --param repeats=2 --param depth=0.6 ";
    expect("'" SG_SOURCE_DIR "/materials/switches_worn.json' --size 64 -o instance.pfm", 0, "");
    expect(base + values + "--param bumps=textures/ramp_normal.png -o exchanged.pfm", 0, "");
    expect(base + values + "-o bricks.pfm", 0, "");
    EXPECT_TRUE(files_.read(folder_ / "instance.pfm").bytes == files_.read(folder_ / "exchanged.pfm").bytes);
    EXPECT_FALSE(files_.read(folder_ / "instance.pfm").bytes == files_.read(folder_ / "bricks.pfm").bytes);
    expect(base + "--param bumps=textures/none.png -o a.png", 1,
           "error: texture '$bumps' is missing: no file 'textures/none.png' below '" SG_SOURCE_DIR
           "/materials'; --texture-root names another folder [SG1301]\n");
    expect(
        base + "--param bump=textures/ramp_normal.png -o a.png", 1,
        "error: material 'painted bricks' has no parameter 'bump', did you mean 'bumps'? (it has 'painted', "
        "'repeats', 'depth', 'paint' or 'bumps') [SG2104]\n");
}

TEST_F(Program, WarnsOfAChangedTexture) {
    asset::Image other = asset::make_image(2, 2, asset::TexelFormat::unorm8);
    ASSERT_EQ(files_.write_all({{folder_ / "pictures/paint.png", asset::png_bytes(other)}}), "");
    expect("sample.json -o a.png --size 16", 0,
           "warning: texture 'pictures/paint.png' has changed since the material was compiled [SG2102]\n");
}

TEST_F(Program, DumpsEveryInputAsALayer) {
    expect("sample.json --dump-inputs all.exr --size 32", 0, "");
    Diags diags;
    auto layers = asset::read_exr_layers(files_.read(folder_ / "all.exr").bytes, "all.exr", diags);
    ASSERT_TRUE(layers) << sg::render(diags);
    std::vector<std::string> names;
    for (const asset::ExrLayer& layer : *layers) names.push_back(layer.name);
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"base-normal", "coverage", "facing", "position", "tangent",
                                               "unprojected", "uv0", "uv0-derivatives"}));
}

TEST_F(Program, AMaterialIsCompiledFirst) {
    expect("'" SG_SOURCE_DIR "/materials/normal_map.json' -o a.png --size 32 --validate", 0, "");
    EXPECT_EQ(read("a.png").width, 32u);
}

// A material whose numbers the host hands over is the same picture.
TEST_F(Program, NumbersAreBakedOrUniforms) {
    for (const std::string name : {"mossy_rock", "layered"}) {
        const std::string draw = "'" SG_SOURCE_DIR "/materials/" + name + ".json' --size 96 ";
        expect(draw + "-o baked.png --numbers baked", 0, "");
        expect(draw + "-o uniforms.png --numbers uniforms", 0, "");
        expect(draw + "-o default.png", 0, "");
        const std::string baked = files_.read(folder_ / "baked.png").bytes;
        EXPECT_TRUE(baked == files_.read(folder_ / "uniforms.png").bytes) << name;
        EXPECT_TRUE(baked == files_.read(folder_ / "default.png").bytes) << name;
    }
    expect("sample.json -o a.png --numbers uniforms", 2,
           "error: --numbers: expected a material, 'sample.json' is an artefact that was compiled before "
           "[SG2105]\n");
    EXPECT_EQ(run("sample.json -o a.png --numbers lifted").exit_code, 2);
}

// A program in surfgradc's place writes down what it is asked for.
TEST_F(Program, NumbersArePassedOn) {
    namespace fs = std::filesystem;
    fs::create_directory(folder_ / "bin");
    fs::copy_file(SG_BINARY_DIR "/surfgrad-render", folder_ / "bin/surfgrad-render");
    std::ofstream(folder_ / "bin/surfgradc")
        << "#!/bin/sh\necho \"$*\" > '" << (folder_ / "asked").string() << "'\nexit 1\n";
    fs::permissions(folder_ / "bin/surfgradc", fs::perms::owner_all);
    ASSERT_EQ(files_.write_all({{folder_ / "m.json", "{ \"version\": 1 }"}}), "");
    auto asked = [&](const std::string& options) {
        const std::string command =
            "cd '" + folder_.string() + "' && bin/surfgrad-render m.json -o a.png " + options;
        EXPECT_NE(std::system(command.c_str()), 0);
        return files_.read(folder_ / "asked").bytes;
    };
    EXPECT_TRUE(asked("--numbers uniforms").ends_with(" --numbers uniforms\n"));
    EXPECT_EQ(asked("").find("--numbers"), std::string::npos);
}

TEST_F(Program, TheCompilersMessagesAndExitCodeArePassedOn) {
    ASSERT_EQ(files_.write_all({{folder_ / "bad.json", "{ \"version\": 1, \"bmup\": [] }"}}), "");
    Result result = run("bad.json -o a.png");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.text.find("bad.json:1:17: error: "), std::string::npos) << result.text;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.png"));
}

TEST_F(Program, UnknownDevicesAreASystemFailure) {
    Result result = run("sample.json -o a.png --device nothing-like-this");
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_EQ(result.text.substr(0, result.text.find('\n')),
              "error: no usable device has 'nothing-like-this' in its name [SG2202]");
}

TEST_F(Program, AMissingDriverIsASystemFailure) {
    expect("sample.json -o a.png", 4,
           "error: no Vulkan driver answers (VK_ERROR_INCOMPATIBLE_DRIVER) [SG2201]\n",
           "VK_ICD_FILENAMES=/no/such/driver.json VK_DRIVER_FILES=/no/such/driver.json");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.png"));
}

TEST_F(Program, AMissingValidationLayerIsASystemFailure) {
    std::filesystem::create_directory(folder_ / "no-layers");
    expect("sample.json -o a.png --validate", 4,
           "error: the validation layer 'VK_LAYER_KHRONOS_validation' is not installed [SG2205]\n",
           "VK_LAYER_PATH=no-layers");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.png"));
}

}  // namespace
}  // namespace sg::runtime

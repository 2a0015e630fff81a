// surfgradc as a user runs it: arguments, files, exit codes, the same bytes from any folder.
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <map>

#include "tests/support/golden.hpp"

namespace sg {
namespace {

namespace fs = std::filesystem;

struct Outcome {
    int exit_code = -1;
    std::string text;  // standard output and standard error
};

Outcome run(const fs::path& folder, const std::string& arguments) {
    std::string command = fmt::format("cd '{}' && '{}' {} 2>&1", folder.string(), SG_SURFGRADC, arguments);
    FILE* pipe = ::popen(command.c_str(), "r");
    Outcome out;
    std::array<char, 4096> buffer{};
    for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        out.text.append(buffer.data(), n);
    int status = ::pclose(pipe);
    out.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return out;
}

std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> out;
    if (!fs::exists(folder)) return out;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file())
            out[entry.path().lexically_relative(folder).string()] = test::read_file(entry.path());
    }
    return out;
}

class Cli : public testing::Test {
protected:
    void SetUp() override {
        root_ = fs::temp_directory_path() / fmt::format("surfgrad-cli-{}", ::getpid());
        fs::remove_all(root_);
        copy_to(root_ / "one");
    }
    void TearDown() override { fs::remove_all(root_); }

    static void copy_to(const fs::path& folder) {
        fs::create_directories(folder);
        fs::copy(test::source_dir() / "materials", folder / "materials", fs::copy_options::recursive);
    }
    void write(const fs::path& file, const std::string& text) {
        std::ofstream(root_ / file, std::ios::binary) << text;
    }

    fs::path root_;
};

TEST_F(Cli, SameBytesFromTwoFolders) {
    copy_to(root_ / "two/deeper");
    for (const char* sample : {"normal_map", "two_unwraps", "layered"}) {
        std::string emit = " --emit ir,opt-ir,glsl,spvasm";
        Outcome one = run(root_ / "one", fmt::format("compile materials/{}.json -o out{}", sample, emit));
        Outcome two =
            run(root_ / "two", fmt::format("compile '{}' -o '{}'{}",
                                           (root_ / "two/deeper/materials" / sample).string() + ".json",
                                           (root_ / "two/out").string(), emit));
        EXPECT_EQ(one.exit_code, 0) << one.text;
        EXPECT_EQ(two.exit_code, 0) << two.text;
    }
    auto one = contents(root_ / "one/out"), two = contents(root_ / "two/out");
    EXPECT_GE(one.size(), 3u * (1 + 6 + 6 + 6 + 2));
    EXPECT_EQ(one, two);
}

TEST_F(Cli, WritesWhatWasAskedFor) {
    EXPECT_EQ(run(root_ / "one", "compile materials/normal_map.json -o out --entry normal --emit ir,glsl")
                  .exit_code,
              0);
    std::vector<std::string> names;
    for (const auto& [name, bytes] : contents(root_ / "one/out")) names.push_back(name);
    EXPECT_EQ(names, (std::vector<std::string>{"normal_map.ir", "normal_map.json",
                                               "normal_map.normal.frag.glsl", "normal_map.normal.frag.spv",
                                               "normal_map.normal.vert.glsl", "normal_map.normal.vert.spv"}));
}

TEST_F(Cli, BadInputWritesNothingAndExitsWith1) {
    write("one/bad.json", "{ \"version\": 1, \"bmup\": [] }");
    Outcome out = run(root_ / "one", "compile bad.json -o out --color never");
    EXPECT_EQ(out.exit_code, 1);
    EXPECT_EQ(out.text,
              "bad.json:1:17: error: unknown key 'bmup' in a material, did you mean 'bump'? [SG1101]\n"
              "{ \"version\": 1, \"bmup\": [] }\n"
              "                ^^^^^^\n"
              "    at /bmup: remove the key or use the name that is suggested\n");
    EXPECT_FALSE(fs::exists(root_ / "one/out"));
}

TEST_F(Cli, OneBadFileDoesNotStopTheOthers) {
    write("one/bad.json", "{}");
    Outcome out = run(root_ / "one", "compile bad.json none.json materials/normal_map.json -o out");
    EXPECT_EQ(out.exit_code, 1);
    EXPECT_NE(out.text.find("error: file 'none.json' does not exist [SG1301]\n"), std::string::npos)
        << out.text;
    EXPECT_NE(out.text.find("bad.json:1:1: error: a material needs the key 'version' [SG1102]\n"),
              std::string::npos);
    EXPECT_TRUE(fs::exists(root_ / "one/out/normal_map.json"));
}

TEST_F(Cli, NothingIsOverwrittenThatWasNotAsked) {
    fs::path one = root_ / "one";
    std::string before = test::read_file(one / "materials/normal_map.json");
    Outcome out = run(one, "compile materials/normal_map.json -o materials");
    EXPECT_EQ(out.exit_code, 1);
    EXPECT_EQ(out.text,
              "error: 'materials/normal_map.json' would write 'materials/normal_map.json', which is an "
              "input; choose another folder with -o [SG1305]\n");
    EXPECT_EQ(test::read_file(one / "materials/normal_map.json"), before);
    EXPECT_FALSE(fs::exists(one / "materials/normal_map.forward.vert.spv"));
    fs::copy(one / "materials", one / "other", fs::copy_options::recursive);
    out = run(one, "compile materials/normal_map.json other/normal_map.json -o out");
    EXPECT_EQ(out.exit_code, 1);
    EXPECT_NE(out.text.find("'other/normal_map.json' would write 'out/normal_map.forward.vert.spv', as "
                            "'materials/normal_map.json' does"),
              std::string::npos)
        << out.text;
}

// A file's name stands in messages of the GLSL compiler, never in the program.
TEST_F(Cli, NamesOfFilesAreNotCode) {
    std::string name = "x\" \n#define inversesqrt(x) (x)\n#line 1 \"y";
    fs::copy_file(root_ / "one/materials/normal_map.json", root_ / "one/materials" / (name + ".json"));
    fs::path one = root_ / "one";
    EXPECT_EQ(run(one, "compile materials/normal_map.json -o plain --entry normal").exit_code, 0);
    Outcome out = run(one, "compile materials/x*.json -o odd --entry normal");
    EXPECT_EQ(out.exit_code, 0) << out.text;
    auto plain = contents(one / "plain"), odd = contents(one / "odd");
    EXPECT_EQ(odd.at(name + ".normal.frag.spv").size(), plain.at("normal_map.normal.frag.spv").size());
}

TEST_F(Cli, ImportsGltf) {
    write("one/lamp.gltf",
          R"({"asset":{"version":"2.0"},"materials":[{"name":"lamp","emissiveFactor":[1,1,0]}]})");
    EXPECT_EQ(run(root_ / "one", "import lamp.gltf -o made").exit_code, 0);
    EXPECT_EQ(run(root_ / "one", "compile made/lamp.json -o out --entry forward").exit_code, 0);
    // The file's own folder is refused where a material would take the place of the input.
    write("one/lamp.json", R"({"asset":{"version":"2.0"},"materials":[{"name":"lamp"}]})");
    Outcome clash = run(root_ / "one", "import lamp.json -o . --color never");
    EXPECT_EQ(clash.exit_code, 1);
    EXPECT_EQ(
        clash.text,
        "error: 'lamp.json' would write './lamp.json', which is an input; choose another folder with -o "
        "[SG1305]\n");
}

TEST_F(Cli, ExitCodes) {
    fs::path one = root_ / "one";
    EXPECT_EQ(run(one, "").exit_code, 2);
    EXPECT_EQ(run(one, "compile").exit_code, 2);
    EXPECT_EQ(run(one, "compile materials/normal_map.json -o out --entry lit").exit_code, 2);
    EXPECT_EQ(run(one, "compile materials/normal_map.json -o out -O0 -Os").exit_code, 2);
    EXPECT_EQ(run(one, "compile materials/normal_map.json -o out --budget interpolants").exit_code, 2);
    EXPECT_EQ(run(one, "compile materials/normal_map.json -o out --budget texture_reads=0,interpolants=64")
                  .exit_code,
              1);
    EXPECT_EQ(run(one, "explain materials/normal_map.json").exit_code, 0);
    EXPECT_EQ(run(one, "explain none.json").exit_code, 1);
    EXPECT_EQ(run(one, "frobnicate").exit_code, 2);
    EXPECT_EQ(run(one, "compile materials/normal_map.json -o out -O3").exit_code, 2);
    EXPECT_FALSE(fs::exists(one / "out"));
    EXPECT_EQ(run(one, "--help").exit_code, 0);
    EXPECT_EQ(run(one, "compile --help").exit_code, 0);
    EXPECT_EQ(run(one, "--version").text, "surfgrad 0.1.0\n");
    EXPECT_EQ(run(one, "check materials/layered.json").exit_code, 0);
    write("one/file", "in the way");
    Outcome out = run(one, "compile materials/normal_map.json -o file/out");
    EXPECT_EQ(out.exit_code, 4) << out.text;
    EXPECT_NE(out.text.find("[SG1304]"), std::string::npos) << out.text;
}

TEST_F(Cli, StandardInput) {
    Outcome out = run(root_ / "one/materials", "compile - --name wall.json -o ../out < normal_map.json");
    EXPECT_EQ(out.exit_code, 0) << out.text;
    EXPECT_TRUE(fs::exists(root_ / "one/out/wall.json"));
    EXPECT_EQ(run(root_ / "one", "check - --color never < /dev/null").text,
              "stdin:1:1: error: syntax error while parsing value - unexpected end of input; expected '[', "
              "'{', or a literal [SG1001]\n\n^\n"
              "    fix the text at the place that the caret marks\n");
}

TEST_F(Cli, FurtherRootsAndJsonMessages) {
    fs::create_directories(root_ / "one/other");
    fs::rename(root_ / "one/materials/textures", root_ / "one/other/textures");
    EXPECT_EQ(run(root_ / "one", "check materials/normal_map.json").exit_code, 1);
    EXPECT_EQ(run(root_ / "one", "check materials/normal_map.json -I other").exit_code, 0);
    Outcome out = run(root_ / "one", "check materials/normal_map.json --diagnostics json");
    EXPECT_TRUE(out.text.starts_with("{\"severity\":\"error\",\"code\":\"SG1301\"")) << out.text;
    EXPECT_EQ(std::count(out.text.begin(), out.text.end(), '\n'), 1);
}

// A log that code hosts read: rules, places as lines, bytes and pointers, notes as related places.
TEST_F(Cli, MessagesAsSarif) {
    write("one/a b.json",
          "{ \"version\": 1,\n  \"bump\": [ { \"id\": \"x\", \"layers\": [] }, { \"id\": \"x\", "
          "\"layers\": [] } ] }\n");
    Outcome out = run(root_ / "one", "check 'a b.json' --diagnostics sarif");
    EXPECT_EQ(out.exit_code, 1);
    EXPECT_EQ(out.text, test::read_file(test::source_dir() / "tests/cli/golden/faults.sarif"));
    EXPECT_NE(
        run(root_ / "one", "check materials/noise.json --diagnostics sarif").text.find("\"results\": []"),
        std::string::npos);
}

// Materials that differ in numbers alone are one shader where that is asked for, and two where it is not.
TEST_F(Cli, NumbersAsUniformsShareOneShader) {
    std::string text = test::read_file(root_ / "one/materials/noise.json");
    const std::size_t at = text.find("\"strength\": 0.");
    ASSERT_NE(at, std::string::npos);
    text.insert(at + 14, "3");  // 0.05 becomes 0.305, say
    write("one/materials/other.json", text);
    for (const std::string option : {"", " --numbers baked", " --numbers uniforms"}) {
        Outcome out = run(root_ / "one", "compile materials/noise.json materials/other.json -o out" + option);
        EXPECT_EQ(out.exit_code, 0) << out.text;
        const bool equal = test::read_file(root_ / "one/out/noise.forward.frag.spv") ==
                           test::read_file(root_ / "one/out/other.forward.frag.spv");
        EXPECT_EQ(equal, option == " --numbers uniforms") << option;
    }
    EXPECT_NE(test::read_file(root_ / "one/out/noise.json"), test::read_file(root_ / "one/out/other.json"));
    EXPECT_EQ(run(root_ / "one", "compile materials/noise.json -o out --numbers lifted").exit_code, 2);
}

// An option takes one value, or one list, each time; the files may stand behind it.
TEST_F(Cli, OptionsLeaveTheFilesAlone) {
    fs::path one = root_ / "one";
    write("one/bad.json", "{ \"version\": 1, \"bmup\": [] }");
    fs::create_directories(one / "other");
    const std::string unknown = "bad.json:1:17: error: unknown key 'bmup' in a material, did you mean";
    for (const std::string options : {"-I materials", "-I materials -I other", "-D TWO", "-D TWO=2"}) {
        Outcome out = run(one, "check " + options + " bad.json materials/normal_map.json");
        EXPECT_EQ(out.exit_code, 1) << options;
        EXPECT_EQ(out.text.find(unknown), 0u) << options << "\n" << out.text;
    }
    for (const std::string options :
         {"--target spirv", "--target hlsl,msl --target spirv", "--entry normal", "--entry normal,depth",
          "--emit ir", "--emit ir,glsl --emit spvasm", "--budget texture_reads=9",
          "--budget texture_reads=9 --budget interpolants=99"}) {
        fs::remove_all(one / "out");
        Outcome out = run(one, "compile " + options + " materials/normal_map.json -o out");
        EXPECT_EQ(out.exit_code, 0) << options << "\n" << out.text;
        EXPECT_TRUE(fs::exists(one / "out/normal_map.json")) << options;
    }
    EXPECT_EQ(run(one,
                  "compile --budget texture_reads=0 --budget interpolants=64 materials/normal_map.json "
                  "-o out")
                  .exit_code,
              1);
    EXPECT_EQ(
        run(one, "compile --emit ir --emit glsl --entry normal materials/normal_map.json -o two").exit_code,
        0);
    EXPECT_TRUE(fs::exists(one / "two/normal_map.ir"));
    EXPECT_TRUE(fs::exists(one / "two/normal_map.normal.frag.glsl"));
}

TEST_F(Cli, ARootIsAFolder) {
    fs::path one = root_ / "one";
    for (const std::string root : {"nowhere", "materials/normal_map.json"}) {
        Outcome out = run(one, "check materials/normal_map.json -I " + root);
        EXPECT_EQ(out.exit_code, 2);
        EXPECT_EQ(out.text, "surfgradc: -I: '" + root +
                                "' is no folder\nsurfgradc check --help tells what is expected\n");
    }
}

TEST_F(Cli, WrongWordsNameTheNearest) {
    fs::path one = root_ / "one";
    EXPECT_EQ(run(one, "chek a.json").text,
              "surfgradc: unknown command 'chek', did you mean 'check'?\nsurfgradc --help tells what is "
              "expected\n");
    EXPECT_EQ(
        run(one, "frobnicate").text,
        "surfgradc: unknown command 'frobnicate', expected 'compile', 'check', 'explain', 'import', 'kinds', "
        "'schema', 'codes', '--help' or '--version'\nsurfgradc --help tells what is expected\n");
    EXPECT_EQ(run(one, "compile materials/noise.json -o out --targt=spirv").text,
              "surfgradc: The following argument was not expected: --targt=spirv, did you mean '--target'?\n"
              "surfgradc compile --help tells what is expected\n");
    EXPECT_EQ(run(one, "compile materials/noise.json -o out --entry lit").text,
              "surfgradc: --entry: lit not in {forward,gbuffer,normal,depth,debug,function}\n"
              "surfgradc compile --help tells what is expected\n");
    Outcome folder = run(one, "check materials");
    EXPECT_EQ(folder.text, "error: 'materials' is a folder, expected a file [SG1301]\n");
    EXPECT_EQ(folder.exit_code, 1);
}

TEST_F(Cli, TablesArePrinted) {
    EXPECT_NE(run(root_, "kinds").text.find("normal_map: a tangent-space normal map on a uv set\n"),
              std::string::npos);
    EXPECT_NE(run(root_, "codes").text.find("SG1105: a layer kind that does not exist\n"), std::string::npos);
}

}  // namespace
}  // namespace sg

#include "runtime/artefact.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "base/files.hpp"
#include "runtime/parameters.hpp"
#include "tests/unit/runtime/sample_artefact.hpp"

namespace sg::runtime {
namespace {

// The sample's files in memory, with one text of its manifest replaced.
MemoryFiles sample_with(const std::string& from, const std::string& to) {
    MemoryFiles files;
    EXPECT_EQ(files.write_all(test::sample_files("dir")), "");
    std::string& manifest = files.contents["dir/sample.json"];
    std::size_t at = manifest.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at != std::string::npos) manifest.replace(at, from.size(), to);
    return files;
}

void expect_errors(MemoryFiles files, const std::string& text) {
    Diags diags;
    EXPECT_FALSE(read_artefact(files, "dir/sample.json", diags));
    EXPECT_EQ(render(diags), text);
    EXPECT_EQ(diags.exit_code(), 1);
}

TEST(Artefact, ReadsWhatTheManifestSays) {
    MemoryFiles files = sample_with("\"off\"", "\"flip\"");
    Diags diags;
    auto artefact = read_artefact(files, "dir/sample.json", diags);
    ASSERT_TRUE(artefact) << render(diags);
    EXPECT_EQ(artefact->name, "sample");
    EXPECT_TRUE(artefact->two_sided);
    ASSERT_NE(artefact->entry("debug"), nullptr);
    EXPECT_EQ(artefact->entry("debug")->views.size(), 7u);
    EXPECT_EQ(artefact->entry("gbuffer"), nullptr);
    EXPECT_GT(artefact->entry("forward")->fragment.words.size(), 100u);
    EXPECT_TRUE(artefact->textures.at(0).srgb);
    EXPECT_EQ(artefact->parameters->parameters.at(1).offset, 12u);
}

TEST(Artefact, RefusesWhatIsNoManifest) {
    for (std::string text :
         {"", "{}", "[1]", "\"surfgrad-artefact\"", "{\"format\": 7}", "{\"format\": \"other\"}"}) {
        MemoryFiles files;
        files.contents["dir/sample.json"] = text;
        expect_errors(files, "error: dir/sample.json: not a surfgrad manifest [SG2101]\n");
    }
}

TEST(Artefact, NamesTheValueThatIsWrong) {
    const std::string head = "error: dir/sample.json: ";
    expect_errors(sample_with("\"version\": 1", "\"version\": 2"),
                  head + "'/version' must be a number from 1 to 1 [SG2101]\n");
    expect_errors(sample_with("\"two_sided\": \"off\"", "\"two_sided\": \"on\""),
                  head + "'/two_sided' is 'on', expected 'off', 'mirror' or 'flip' [SG2101]\n");
    expect_errors(sample_with("\"two_sided\"", "\"sides\""), head + "'/two_sided' is missing [SG2101]\n");
    expect_errors(sample_with("\"offset\": 12", "\"offset\": 16"),
                  head + "'/parameter_block/parameters/1' lies outside its block [SG2101]\n");
    expect_errors(sample_with("\"default\": [1, 1, 1]", "\"default\": [1]"),
                  head + "'/parameter_block/parameters/0' must have a default of 3 numbers [SG2101]\n");
    expect_errors(
        sample_with("sample.forward.vert.spv", "../vert.spv"),
        head + "'/entry_points/0/stages/0/file' must be the name of a file beside the manifest [SG2101]\n");
    expect_errors(
        sample_with("\"location\": 4, \"format\": \"float2\"", "\"location\": 4, \"format\": \"float3\""),
        head + "'/entry_points/0/vertex_inputs/3' must be float2 at location 4 [SG2101]\n");
    expect_errors(
        sample_with("\"binding\": 2, \"kind\": \"sampler\"", "\"binding\": 3, \"kind\": \"sampler\""),
        head +
            "'/entry_points' uses binding 3 of set 1 for something that the manifest does not describe "
            "[SG2101]\n");
}

TEST(Artefact, ReportsAllOfItsErrors) {
    MemoryFiles files = sample_with("\"two_sided\": \"off\"", "\"two_sided\": 3");
    std::string& manifest = files.contents["dir/sample.json"];
    manifest.replace(manifest.find("\"anisotropy\": 1"), 15, "\"anisotropy\": 0");
    expect_errors(
        files,
        "error: dir/sample.json: '/two_sided' must be a text [SG2101]\n"
        "error: dir/sample.json: '/samplers/0/anisotropy' must be a number from 1 to 16 [SG2101]\n");
}

TEST(Artefact, NoticesAShaderThatIsNotItsOwn) {
    MemoryFiles files = sample_with("\"off\"", "\"off\"");
    std::string& shader = files.contents["dir/sample.debug.frag.spv"];
    std::string expected = content_hash(shader);
    shader.back() = static_cast<char>(shader.back() + 1);
    std::string text =
        "error: 'sample.debug.frag.spv' is not the shader that the manifest names: its hash is " +
        content_hash(shader) + ", expected " + expected + " [SG2102]\n";
    expect_errors(files, text);
    shader = "text";
    files.contents["dir/sample.json"].replace(files.contents["dir/sample.json"].find(expected),
                                              expected.size(), content_hash(shader));
    expect_errors(files, "error: 'sample.debug.frag.spv' is not a SPIR-V file [SG2102]\n");
}

TEST(Parameters, StartFromTheDefaultsAndTakeSettings) {
    MemoryFiles files = sample_with("\"off\"", "\"off\"");
    Diags diags;
    auto artefact = read_artefact(files, "dir/sample.json", diags);
    ASSERT_TRUE(artefact);
    auto floats = [&](std::vector<std::string> settings) {
        auto block = pack_parameters(*artefact, settings, diags);
        std::vector<float> out(4);
        if (block) std::memcpy(out.data(), block->data(), 16);
        return out;
    };
    EXPECT_EQ(floats({}), (std::vector<float>{1, 1, 1, 0.5f}));
    EXPECT_EQ(floats({"gain=2", "tint=0.25,0,-1e1"}), (std::vector<float>{0.25f, 0, -10, 2}));
    EXPECT_FALSE(diags.has_errors());
    for (std::string bad :
         {"gain", "gain=", "gain=1,", "gain=1 ", "gain=nan", "gain=1e999", "tint=1,2", "gain=-1"}) {
        std::size_t before = diags.error_count();
        EXPECT_FALSE(pack_parameters(*artefact, std::vector<std::string>{bad}, diags)) << bad;
        EXPECT_EQ(diags.error_count(), before + 1) << bad;
    }
}

}  // namespace
}  // namespace sg::runtime

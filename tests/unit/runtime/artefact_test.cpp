#include "runtime/artefact.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "base/files.hpp"
#include "runtime/parameters.hpp"
#include "runtime/textures.hpp"
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
         {"{}", "[1]", "\"surfgrad-artefact\"", "{\"format\": 7}", "{\"format\": \"other\"}"}) {
        MemoryFiles files;
        files.contents["dir/sample.json"] = text;
        EXPECT_FALSE(is_manifest(text));
        expect_errors(files, "error: 'dir/sample.json' is not a surfgrad manifest [SG2101]\n");
    }
    EXPECT_FALSE(is_manifest(""));
    EXPECT_TRUE(is_manifest(test::sample_manifest()));
}

// The first line of the only message, without the place in front.
void expect_message(const std::string& from, const std::string& to, const std::string& message) {
    MemoryFiles files = sample_with(from, to);
    Diags diags;
    EXPECT_FALSE(read_artefact(files, "dir/sample.json", diags));
    ASSERT_EQ(diags.error_count(), 1u) << render(diags);
    EXPECT_EQ(diags.all()[0].message, message);
    EXPECT_EQ(diags.all()[0].code, Code::manifest_format);
    EXPECT_TRUE(diags.all()[0].place.source);
}

TEST(Artefact, NamesTheValueThatIsWrong) {
    expect_message("\"version\": 1", "\"version\": 2",
                   "'/version' must be 1, the version that this program reads");
    expect_message("\"two_sided\": \"off\"", "\"two_sided\": \"on\"",
                   "'/two_sided' is 'on', expected 'off', 'mirror' or 'flip'");
    expect_message("\"two_sided\"", "\"sides\"", "'/' has no 'two_sided'");
    expect_message("\"offset\": 12", "\"offset\": 16",
                   "'/parameter_block/parameters/1' lies outside its block");
    expect_message("\"default\": [1, 1, 1]", "\"default\": [1]",
                   "'/parameter_block/parameters/0' must have a default of 3 numbers");
    expect_message("sample.forward.vert.spv", "../vert.spv",
                   "'/entry_points/0/stages/0/file' must be the name of a file beside the manifest");
    expect_message("\"location\": 4, \"format\": \"float2\"", "\"location\": 4, \"format\": \"float3\"",
                   "'/entry_points/0/vertex_inputs/3' must be float2 at location 4");
    expect_message(
        "\"binding\": 2, \"kind\": \"sampler\"", "\"binding\": 3, \"kind\": \"sampler\"",
        "'/entry_points' uses binding 3 of set 1 for something that the manifest does not describe");
}

TEST(Artefact, ReportsAllOfItsErrorsInTheirPlaces) {
    MemoryFiles files = sample_with("\"two_sided\": \"off\"", "\"two_sided\": 3");
    std::string& manifest = files.contents["dir/sample.json"];
    manifest.replace(manifest.find("\"anisotropy\": 1"), 15, "\"anisotropy\": 0");
    expect_errors(files, R"(dir/sample.json:2:61: error: '/two_sided' must be a text [SG2101]
"source": {"file": "sample.json", "hash": ""}, "two_sided": 3,
                                                            ^
    at /two_sided: compile the material again
dir/sample.json:27:63: error: '/samplers/0/anisotropy' must be a number from 1 to 16 [SG2101]
    "filter": "linear", "mip_filter": "linear", "anisotropy": 0}]}
                                                              ^
    at /samplers/0/anisotropy: compile the material again
)");
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

// Damaged manifests are read or refused; the sanitisers watch.
TEST(Artefact, SurvivesDamage) {
    const std::string whole = test::sample_manifest();
    const std::vector<std::string> pieces = {"-1",   "1e300",       "null", "[]", "{}",
                                             "\"\"", "\"\\u0000\"", "true", ","};
    std::mt19937 random(7);
    int refused = 0;
    for (int round = 0; round < 3000; ++round) {
        std::string text = whole;
        std::size_t from = text.find_first_of("0123456789[{\"", random() % text.size());
        if (from == std::string::npos) continue;
        std::size_t size = std::min<std::size_t>(1 + random() % 12, text.size() - from);
        text.replace(from, size, pieces[random() % pieces.size()]);
        Diags diags;
        auto artefact = read_manifest(text, "x.json", diags);
        EXPECT_EQ(artefact.has_value(), !diags.has_errors());
        if (artefact) pack_parameters(*artefact, std::vector<std::string>{"tint=1,2,3"}, diags);
        refused += artefact ? 0 : 1;
    }
    EXPECT_GT(refused, 1000);
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

// By what the manifest says, whatever the texture is called.
TEST(Parameters, OfTexturesExchangeTheirFiles) {
    for (const std::string name : {"paint", "$paint"}) {
        MemoryFiles files = sample_with(
            R"("paint", "file")", "\"" + name + R"(", "parameter": "picture", "label": "Picture", "file")");
        Diags diags;
        auto artefact = read_artefact(files, "dir/sample.json", diags);
        ASSERT_TRUE(artefact) << render(diags);
        using Settings = std::vector<std::string>;
        EXPECT_EQ(exchange_textures(*artefact, Settings{"paint=a.png", "gain=1"}),
                  (Settings{"paint=a.png", "gain=1"}));
        EXPECT_EQ(artefact->textures.at(0).file, "pictures/paint.png");
        EXPECT_EQ(exchange_textures(*artefact, Settings{"picture=a.png", "gain=1"}), Settings{"gain=1"});
        EXPECT_EQ(artefact->textures.at(0).file, "a.png");
        EXPECT_FALSE(pack_parameters(*artefact, Settings{"paint=a.png"}, diags));
        EXPECT_EQ(render(diags),
                  "error: material 'sample' has no parameter 'paint', did you mean 'tint'? (it has 'tint', "
                  "'gain' or 'picture') "
                  "[SG2104]\n");
    }
}

}  // namespace
}  // namespace sg::runtime

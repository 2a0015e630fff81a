// Layers without an id get a name that no other layer or entry has, whatever those are called.
#include <gtest/gtest.h>

#include "stages.hpp"
#include "tests/support/golden.hpp"

namespace sg {
namespace {

const std::string kNoise = R"({ "kind": "noise" })";
const std::string kDents = R"({ "kind": "custom", "file": "a.glsl", "function": "f",
  "returns": "volume_gradient", "arguments": ["object"])";

// The ids of the layers of a stage, by the module that is lowered.
std::vector<std::string> ids(const std::string& layers, material::Custom custom = material::Custom::called) {
    MemoryFiles files;
    files.contents["/m/a.glsl"] = "vec3 f(SgVolume p) { return p.position; }\n";
    Diags diags;
    auto checked =
        read_and_check(std::make_shared<Source>(Source{
                           "wall.json", R"({ "version": 1, "bump": [ { "layers": [ )" + layers + " ] } ] }"}),
                       {{"/m"}}, files, diags);
    EXPECT_TRUE(checked) << render(diags);
    std::vector<std::string> out;
    if (!checked) return out;
    const ir::Module module = material::lower(*checked, custom);
    for (const ir::Layer& layer : module.layers) out.push_back(layer.id);
    std::size_t shown = 0;
    for (const ir::OutputBinding& output : module.outputs)
        shown += output.output == ir::Output::layer ? 1u : 0u;
    EXPECT_EQ(shown, out.size());
    return out;
}

using Ids = std::vector<std::string>;

TEST(LayerIds, CountFromOne) {
    EXPECT_EQ(ids(kNoise + ", { \"kind\": \"group\", \"layers\": [ " + kNoise + " ] }, " + kNoise),
              (Ids{"layer 1", "layer 2", "layer 3", "layer 4"}));
}

TEST(LayerIds, AvoidThoseThatAreWritten) {
    auto named = [](const std::string& id) { return R"({ "kind": "noise", "id": ")" + id + "\" }"; };
    EXPECT_EQ(ids(named("layer 2") + ", " + kNoise), (Ids{"layer 2", "unnamed layer 2"}));
    EXPECT_EQ(ids(kNoise + ", " + named("layer 1")), (Ids{"unnamed layer 1", "layer 1"}));
    EXPECT_EQ(ids(named("layer 3") + ", { \"kind\": \"group\", \"layers\": [ " + kNoise +
                  " ], \"id\": \"a\" }, " + named("unnamed layer 3")),
              (Ids{"layer 3", "a", "unnamed unnamed layer 3", "unnamed layer 3"}));
    EXPECT_EQ(ids(named("parallax") + ", " + named("layer 1")), (Ids{"parallax", "layer 1"}));
    EXPECT_EQ(ids(kDents + ", \"equivalent\": " + kNoise + " }, " + named("equivalent 1"),
                  material::Custom::replaced),
              (Ids{"unnamed equivalent 1", "equivalent 1"}));
}

// What stands for a function is in no shader beside it.
TEST(LayerIds, AnEquivalentNeitherNamesNorCounts) {
    const std::string equivalent =
        R"(, "equivalent": { "kind": "group", "layers": [ )" + kNoise + ", " + kNoise + " ] } }, ";
    EXPECT_EQ(ids(kDents + " }, " + kNoise), ids(kDents + equivalent + kNoise));
    EXPECT_EQ(ids(kDents + equivalent + kNoise, material::Custom::replaced),
              (Ids{"equivalent 1", "equivalent 2", "equivalent 3", "layer 2"}));
    std::string many = kDents + equivalent + kNoise;
    for (std::size_t i = 2; i < material::kMaxLayers; ++i) many += ", " + kNoise;
    EXPECT_EQ(ids(many).size(), material::kMaxLayers);
}

TEST(LayerIds, TheFirstBeyondTheLimitIsRefused) {
    std::string text = R"({ "version": 1, "bump": [ { "layers": [
)";
    for (std::size_t i = 0; i < material::kMaxLayers; ++i) text += kNoise + ",\n";
    text += kNoise + ", " + kNoise + "] } ] }\n";
    MemoryFiles files;
    Diags diags;
    EXPECT_FALSE(read_and_check(std::make_shared<Source>(Source{"wall.json", text}), {{"/m"}}, files, diags));
    EXPECT_EQ(render(diags),
              "wall.json:258:1: error: 258 layers, expected at most 256 [SG1208]\n"
              "{ \"kind\": \"noise\" }, { \"kind\": \"noise\" }] } ] }\n"
              "^^^^^^^^^^^^^^^^^^^\n"
              "    at /bump/0/layers/256: use fewer\n");
}

TEST(LayerIds, SoIsTheFirstTextureBeyondTheirs) {
    std::string textures, layers;
    for (std::size_t i = 0; i <= material::kMaxTextures; ++i) {
        const std::string separator = i > 0 ? ",\n" : "\n", name = std::to_string(i);
        textures += separator + "\"" + name + R"(": { "file": "a.png", "encoding": "height" })";
        layers += separator + R"({ "kind": "height_map", "texture": ")" + name + "\" }";
    }
    MemoryFiles files;
    files.contents["/m/a.png"] = "";
    Diags diags;
    const std::string text = R"({ "version": 1, "textures": {)" + textures +
                             R"( }, "bump": [ { "layers": [)" + layers + " ] } ] }\n";
    EXPECT_FALSE(read_and_check(std::make_shared<Source>(Source{"wall.json", text}), {{"/m"}}, files, diags));
    EXPECT_EQ(render(diags),
              "wall.json:66:1: error: 65 textures that are used, expected at most 64 [SG1208]\n"
              "\"64\": { \"file\": \"a.png\", \"encoding\": \"height\" } }, \"bump\": [ { \"layers\": [\n"
              "^^^^\n"
              "    at /textures/64: use fewer\n");
}

}  // namespace
}  // namespace sg

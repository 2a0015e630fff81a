// Numbers lifted to uniforms: materials that differ in them share their shaders and look as if compiled
// alone.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "ir/text.hpp"
#include "runtime/mesh/shapes.hpp"
#include "runtime/parameters.hpp"
#include "tests/render/workshop.hpp"

namespace sg::oracle {
namespace {

using Json = nlohmann::ordered_json;
using layers::Numbers;

const std::map<std::string, std::string>& files() {
    static const std::map<std::string, std::string> kFiles = truth::sample_files();
    return kFiles;
}

// The names of all samples that are whole materials.
std::vector<std::string> whole_samples() {
    std::vector<std::string> out;
    for (const auto& [path, text] : files()) {
        if (!path.ends_with(".json") || path.find('/') != path.npos) continue;
        if (!Json::parse(text).contains("extends")) out.push_back(path);
    }
    return out;
}

// Every number that the options say may be lifted becomes another one. What is left out while it does nothing
// stays.
void change(Json& value, const std::string& key = "", bool coordinate = false) {
    static const std::set<std::string> kStructure = {"version",    "octaves", "steps",     "min_steps",
                                                     "max_steps",  "set",     "budget",    "textures",
                                                     "parameters", "channel", "components"};
    if (kStructure.count(key)) return;
    if (value.is_structured()) {
        for (auto& [name, item] : value.items())
            change(item, value.is_array() ? key : name, coordinate || name.ends_with("uv"));
    } else if (value.is_number() && key != "uv" && key != "second_uv") {
        const double number = value;
        const bool tiling = coordinate || key == "tiling" || key == "second_tiling";
        if (tiling && (number == 0 || number == 1)) return;
        value = number == 0 ? 0.03 : 0.93 * number;
    }
}

using Shaders = std::map<std::string, std::string>;
Shaders shaders_of(const std::string& json, Numbers numbers, const std::vector<std::string>& entries,
                   std::string* lowered = nullptr) {
    static const target::ShaderLibrary kLibrary = target::embedded_library();
    MemoryFiles memory;
    for (const auto& [path, bytes] : files()) memory.contents["in/" + path] = bytes;
    CompileRequest request{.source = std::make_shared<Source>(Source{"case.json", json})};
    request.stem = "case";
    request.roots = {"in"};
    request.entries = entries;
    request.numbers = numbers;
    Diags diags;
    auto compiled = compile_material(request, memory, kLibrary, diags);
    if (!compiled) throw std::runtime_error(json + "\n" + render(diags));
    Shaders out;
    for (auto& [name, bytes] : compiled->files) {
        if (name.ends_with(".spv")) out[name] = std::move(bytes);
    }
    if (lowered) *lowered = compiled->ir;
    return out;
}

TEST(Numbers, SamplesWithOtherNumbersShareTheirShaders) {
    for (const std::string& sample : whole_samples()) {
        const std::string& text = files().at(sample);
        Json other = Json::parse(text);
        for (const char* part : {"nodes", "bump", "surface"}) {
            if (other.contains(part)) change(other[part], part);
        }
        if (other == Json::parse(text)) continue;  // it states no number but defaults of parameters
        std::string lowered, fault;
        const Shaders a = shaders_of(text, Numbers::uniforms, {"forward", "gbuffer"}, &lowered);
        EXPECT_EQ(a.size(), 4u);
        EXPECT_TRUE(a == shaders_of(other.dump(), Numbers::uniforms, {"forward", "gbuffer"})) << sample;
        EXPECT_FALSE(shaders_of(text, Numbers::baked, {"forward"}) ==
                     shaders_of(other.dump(), Numbers::baked, {"forward"}))
            << sample;
        auto module = ir::parse(lowered, fault);
        ASSERT_TRUE(module) << fault;
        EXPECT_EQ(ir::print(*module), lowered);
        EXPECT_FALSE(module->derived.empty()) << sample;
    }
}

// One edit of a small material.
struct Edit {
    const char* what;
    const char* from;
    const char* to;
    bool shares;
};
constexpr const char* kMaterial = R"({
  "version": 1,
  "textures": { "a": { "file": "textures/brick_normal.png", "encoding": "tangent_normal", "zero": 127 } },
  "bump": [ { "layers": [
    { "kind": "normal_map", "texture": "a", "uv": { "set": 0, "scale": 2, "rotation": 30 }, "tiling": 3, "strength": 0.5 },
    { "kind": "noise", "octaves": 2, "frequency": 5, "strength": 0.01 } ] } ],
  "surface": { "roughness": 0.4, "alpha_test": 0.5 } })";
constexpr Edit kEdits[] = {
    {"a strength", "\"strength\": 0.5", "\"strength\": 0", true},
    {"a strength of 1", "\"strength\": 0.5", "\"strength\": 1", true},
    {"a tiling", "\"tiling\": 3", "\"tiling\": [7, 2]", true},
    {"a frequency", "\"frequency\": 5", "\"frequency\": 1", true},
    {"a scale", "\"scale\": 2", "\"scale\": [0.5, 3]", true},
    {"a rotation", "\"rotation\": 30", "\"rotation\": -10", true},
    {"the surface", "\"roughness\": 0.4", "\"roughness\": 0, \"metallic\": 1, \"base_color\": [0, 1, 0.5]",
     true},
    {"the alpha test", "\"alpha_test\": 0.5", "\"alpha_test\": 0", true},
    {"the picture", "brick_normal", "pebble_normal", true},
    {"octaves", "\"octaves\": 2", "\"octaves\": 3", false},
    {"a mirroring tiling", "\"tiling\": 3", "\"tiling\": -3", false},
    {"a tiling that does nothing", "\"tiling\": 3", "\"tiling\": 1", false},
    {"a rotation that does nothing", "\"rotation\": 30", "\"rotation\": 0", false},
    {"the code of zero", "\"zero\": 127", "\"zero\": 128", false},
    {"the uv set", "\"set\": 0", "\"set\": 1", false},
    {"no strength", ", \"strength\": 0.5", "", false},
    {"no alpha test", ", \"alpha_test\": 0.5", "", false},
};

TEST(Numbers, StructureIsNotLifted) {
    const Shaders plain = shaders_of(kMaterial, Numbers::uniforms, {"forward"});
    for (const Edit& edit : kEdits) {
        std::string text = kMaterial;
        const std::size_t at = text.find(edit.from);
        ASSERT_NE(at, text.npos) << edit.what;
        text.replace(at, std::string_view(edit.from).size(), edit.to);
        EXPECT_EQ(plain == shaders_of(text, Numbers::uniforms, {"forward"}), edit.shares) << edit.what;
    }
}

TEST(Numbers, ThereIsAnEnd) {
    Json layers = Json::array();
    for (int i = 0; i < 100; ++i)
        layers.push_back(
            {{"kind", "noise"}, {"octaves", 1}, {"frequency", 1 + i}, {"strength", 0.01 * (i + 1)}});
    const Json material = {{"version", 1}, {"bump", {{{"layers", layers}}}}};
    std::string lowered, fault;
    shaders_of(material.dump(), Numbers::uniforms, {"depth"}, &lowered);
    EXPECT_EQ(ir::parse(lowered, fault)->derived.size(), 128u);
}

// ---- pictures ----

runtime::Picture drawn(const truth::Made& made) {
    runtime::Scene scene;
    scene.content.meshes.push_back(*runtime::make_shape("torus"));
    scene.content.instances.push_back({"", 0, glm::mat4(1)});
    scene.camera.position = glm::normalize(glm::dvec3(0.5, 0.9, 1)) * 5.6;
    scene.camera.fov_degrees = 30;
    return truth::draw(made, scene, "normal", 48, 40);
}

// The largest difference of any pixel's normal.
double apart(const runtime::Picture& a, const runtime::Picture& b) {
    double out = 0;
    for (std::uint32_t y = 0; y < a.values.height; ++y) {
        for (std::uint32_t x = 0; x < a.values.width; ++x)
            out = std::max(out, glm::length(truth::rgb(a, x, y) - truth::rgb(b, x, y)));
    }
    return out;
}

// The shader of one material with the block of the other draws the other, up to the roundings of what a
// compiler folds in double precision and a shader does not: some 1e-7 of each slope.
TEST(Numbers, OneShaderDrawsBothMaterials) {
    for (const char* sample : {"mossy_rock.json", "decal.json"}) {
        const std::string& text = files().at(sample);
        Json other = Json::parse(text);
        for (const char* part : {"nodes", "bump"}) change(other[part], part);
        truth::Made lifted = truth::make({.json = text, .files = files(), .numbers = Numbers::uniforms});
        const truth::Made lifted_other =
            truth::make({.json = other.dump(), .files = files(), .numbers = Numbers::uniforms});
        const auto own = drawn(lifted);
        const auto baked = drawn(truth::make({.json = text, .files = files()}));
        lifted.parameters = lifted_other.parameters;  // the shaders of the one, the numbers of the other
        const auto exchanged = drawn(lifted);
        const auto baked_other = drawn(truth::make({.json = other.dump(), .files = files()}));
        const double first = apart(own, baked), second = apart(exchanged, baked_other);
        fmt::print("{}: {:.1e} and {:.1e}, the materials are {:.2f} apart\n", sample, first, second,
                   apart(baked, baked_other));
        EXPECT_LE(first, 1e-5) << sample;
        EXPECT_LE(second, 1e-5) << sample;
        EXPECT_GT(apart(baked, baked_other), 0.01) << sample;
    }
}

}  // namespace
}  // namespace sg::oracle

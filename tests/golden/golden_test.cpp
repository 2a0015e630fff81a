// Every sample in materials/: golden IR, optimised IR, GLSL and manifest; every shader valid; the same bytes
// again.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "compile.hpp"
#include "emit/glsl.hpp"
#include "emit/names.hpp"
#include "explain.hpp"
#include "ir/lighting.hpp"
#include "ir/text.hpp"
#include "layers/kind.hpp"
#include "tests/support/golden.hpp"
#include "text_faults.hpp"

namespace sg {
namespace {

namespace fs = std::filesystem;

// The samples, and of the paper's figures the materials without the GLSL of older methods.
std::vector<fs::path> samples() {
    std::vector<fs::path> out;
    for (const auto& entry : fs::directory_iterator(test::source_dir() / "materials")) {
        if (entry.path().extension() == ".json") out.push_back(entry.path());
    }
    for (const auto& entry : fs::directory_iterator(test::source_dir() / "materials/figures")) {
        const bool material =
            entry.path().extension() == ".json" && entry.path().stem().extension() != ".figure";
        if (material && test::read_file(entry.path()).find("\"custom\"") == std::string::npos)
            out.push_back(entry.path());
    }
    std::sort(out.begin(), out.end());
    return out;
}

CompileRequest request_for(const fs::path& path) {
    return {.source = std::make_shared<Source>(Source{path.filename().string(), test::read_file(path)}),
            .stem = path.stem().string(),
            .roots = {path.parent_path(), test::source_dir() / "materials"}};
}

Compiled compile(const fs::path& path, target::Optimise optimise = target::Optimise::speed) {
    RealFiles files;
    Diags diags;
    CompileRequest request = request_for(path);
    request.spirv.optimise = optimise;
    request.optimise_ir = optimise != target::Optimise::none;
    auto out = compile_material(request, files, target::embedded_library(), diags);
    EXPECT_EQ(render(diags), "");  // nor a warning
    return out ? std::move(*out) : Compiled{};
}

// The shaders' hashes follow the versions of glslang and SPIRV-Tools, the function's every word of the
// library; what they hash is golden as GLSL.
std::string without_shader_hashes(const std::string& manifest) {
    static const std::regex kHash("((\\.spv|\\.function\\.[^\"]*)\",\\s*\"hash\": )\"xxh3:[0-9a-f]{32}\"");
    return std::regex_replace(manifest, kHash, "$1\"...\"");
}

// The names that a material's author gave, as locals.
struct KnownLocals {
    std::set<std::string> layers, nodes, all;
    std::set<std::string> comments;  // of the layers
};
KnownLocals known_locals(const std::string& ir_text) {
    std::string fault;
    std::optional<ir::Module> module = ir::parse(ir_text, fault);
    EXPECT_TRUE(module) << fault;
    KnownLocals out;
    for (const ir::Layer& layer : module->layers) {
        out.layers.insert(emit::Names().unique("m_", layer.id));
        out.comments.insert(fmt::format("{}: {}{}{}", emit::comment_text(layer.id), layer.kind,
                                        layer.group.empty() ? "" : " in ", emit::comment_text(layer.group)));
    }
    for (const ir::Value& value : module->values) {
        if (value.is_node) out.nodes.insert(emit::Names().unique("m_", value.name));
    }
    out.all = out.layers;
    out.all.insert(out.nodes.begin(), out.nodes.end());
    return out;
}

void expect_as_by_hand(const NamedText& glsl, const KnownLocals& known) {
    EXPECT_EQ(test::local_used_once(glsl.text, known.all), "") << glsl.name;
    EXPECT_EQ(test::scattered_layer(glsl.text, known.layers, known.nodes), "") << glsl.name;
    if (glsl.name == "forward.frag") {
        EXPECT_EQ(test::unnamed_layer(glsl.text, known.comments), "");
    }
    EXPECT_EQ(test::stuttering_name(glsl.text), "") << glsl.name;
    EXPECT_EQ(test::computed_twice(glsl.text), "") << glsl.name;
    EXPECT_EQ(test::comment_twice(glsl.text), "") << glsl.name;
    EXPECT_EQ(test::long_line(glsl.text), "") << glsl.name;
    EXPECT_EQ(test::idle_arithmetic(glsl.text), "") << glsl.name;
}

class Sample : public testing::TestWithParam<fs::path> {};

TEST_P(Sample, Golden) {
    std::string stem = GetParam().stem().string();
    Compiled out = compile(GetParam());
    test::expect_golden("golden/" + stem + "/lowered.ir", out.ir);
    test::expect_golden("golden/" + stem + "/optimised.ir", out.optimised_ir);
    const KnownLocals known = known_locals(out.optimised_ir);
    for (const NamedText& t : out.glsl) {
        test::expect_golden("golden/" + stem + "/" + t.name + ".glsl", t.text);
        expect_as_by_hand(t, known);
    }
    test::expect_golden("golden/" + stem + "/manifest.json", without_shader_hashes(out.files.back().second));
}

TEST_P(Sample, EveryShaderIsValidAtEveryLevel) {
    for (auto level : {target::Optimise::none, target::Optimise::speed, target::Optimise::size}) {
        Compiled out = compile(GetParam(), level);
        std::size_t shaders = 0;
        for (const auto& [name, bytes] : out.files) {
            if (!name.ends_with(".spv")) continue;
            target::Words words(bytes.size() / 4);
            std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(words.data()));
            EXPECT_EQ(target::validate(words), "") << name;
            ++shaders;
        }
        EXPECT_EQ(shaders, 2 * emit::all_entry_points().size());
    }
}

// An alpha test ends some of the pixels between which derivatives are taken.
TEST_P(Sample, NoDerivativeInstructionStandsBehindAnAlphaTest) {
    for (const NamedText& t : compile(GetParam()).glsl) {
        const std::size_t discarded = t.text.find("discard;");
        if (discarded == t.text.npos) continue;
        for (const char* call : {"sg_stage_uv(", "sg_stage_volume(", "sg_stage_volume_in_world(",
                                 "sg_stage_frame(", "sg_stage_normal_derivatives(", "sg_stage_sample("}) {
            const std::size_t last = t.text.rfind(call);
            EXPECT_TRUE(last == t.text.npos || last < discarded) << t.name << ": " << call;
        }
    }
}

// Neighbouring pixels see other places behind parallax.
TEST_P(Sample, NoDerivativeInstructionStandsBehindParallax) {
    for (const NamedText& t : compile(GetParam()).glsl) {
        const std::size_t main = t.text.find("void main()"), looked = t.text.find("sg_parallax_", main);
        if (main == t.text.npos || looked == t.text.npos) continue;
        for (const ir::OpInfo& op : ir::all_ops()) {
            if (!ir::takes_screen_derivatives(op.op)) continue;
            const std::string call(op.glsl.substr(0, op.glsl.find('(') + 1));
            const std::size_t last = t.text.rfind(call);
            EXPECT_TRUE(last == t.text.npos || last < looked) << t.name << ": " << call;
        }
    }
}

// No sample has a layer that adds nothing.
TEST_P(Sample, EveryLayerHasItsView) {
    auto views = [](const std::string& text) {
        std::string fault;
        const auto module = ir::parse(text, fault);
        EXPECT_TRUE(module) << fault;
        std::vector<std::uint32_t> out;
        for (const ir::OutputBinding& o : module->outputs) {
            if (o.output == ir::Output::layer) out.push_back(o.set);
        }
        return out;
    };
    const Compiled compiled = compile(GetParam());
    EXPECT_EQ(views(compiled.optimised_ir), views(compiled.ir));
}

TEST_P(Sample, SameBytesTwice) {
    EXPECT_EQ(compile(GetParam()).files, compile(GetParam()).files);
}

INSTANTIATE_TEST_SUITE_P(Materials, Sample, testing::ValuesIn(samples()),
                         [](const auto& sample) { return sample.param.stem().string(); });

// Instructions follow the versions of glslang and SPIRV-Tools; of reads and interpolants those only drop dead
// ones.
std::string without_instructions(const std::string& explained) {
    static const std::regex kColumn("(\n.{51}) +(-?\\d+ \\(\\d+ - -?\\d+\\)|\\d+)");
    return std::regex_replace(explained, kColumn, "$1 ...");
}

TEST(Samples, OneIsExplained) {
    RealFiles files;
    Diags diags;
    fs::path path = test::source_dir() / "materials/noise.json";
    auto text = explain_material(request_for(path), files, target::embedded_library(), diags);
    ASSERT_TRUE(text) << render(diags);
    EXPECT_EQ(text, explain_material(request_for(path), files, target::embedded_library(), diags));
    test::expect_golden("golden/noise/explain.txt", without_instructions(*text));
}

// An instance changes values, not structure.
TEST(Samples, AnInstanceSharesItsShaders) {
    auto shaders = [](const char* name) {
        std::vector<std::string> out;
        for (const auto& [file, bytes] : compile(test::source_dir() / "materials" / name).files) {
            if (file.ends_with(".spv")) out.push_back(bytes);
        }
        return out;
    };
    EXPECT_EQ(shaders("switches.json").size(), 2 * emit::all_entry_points().size());
    EXPECT_EQ(shaders("switches.json"), shaders("switches_worn.json"));
}

// Its layout belongs to the material, not to the entry points that happen to read it.
TEST(Samples, ABlockThatNoShaderReadsIsDescribed) {
    auto manifest = [](const std::string& type, const std::string& value) {
        MemoryFiles files;
        files.contents["/m/a.png"] = "";
        Diags diags;
        auto out = compile_material(
            {.source = std::make_shared<Source>(Source{
                 "wall.json",
                 R"({ "version": 1, "parameters": { "p": { "type": ")" + type + R"(", "default": )" + value +
                     R"( } }, "textures": { "a": { "file": "a.png", "encoding": "height" } } })"}),
             .stem = "wall",
             .roots = {"/m"},
             .entries = {"depth", "normal"}},
            files, target::embedded_library(), diags);
        EXPECT_TRUE(out) << render(diags);
        return out ? out->files.back().second : "";
    };
    const std::string unread = manifest("float", "0.5");
    EXPECT_NE(unread.find("\"parameter_block\""), std::string::npos);
    EXPECT_EQ(unread.find("SgMaterialBlock"), std::string::npos);
    EXPECT_EQ(manifest("texture", "\"a\"").find("\"parameter_block\""), std::string::npos);
}

TEST(Samples, EveryLayerKindHasOne) {
    std::set<std::string> stems;
    for (const fs::path& path : samples()) stems.insert(path.stem().string());
    EXPECT_GE(stems.size(), 3u);
    for (const layers::LayerKind* kind : layers::all_kinds()) {
        EXPECT_TRUE(stems.count(std::string(kind->name))) << "materials/" << kind->name << ".json is missing";
    }
    for (const layers::ParallaxKind& kind : layers::all_parallax_kinds()) {
        EXPECT_TRUE(stems.count(fmt::format("parallax_{}", kind.name)))
            << "materials/parallax_" << kind.name << ".json is missing";
    }
}

TEST(Samples, EveryLightingModelHasOne) {
    std::string manifests;
    for (const fs::path& path : samples())
        manifests += test::read_file(test::source_dir() / "tests/golden" / path.stem() / "manifest.json");
    for (const ir::LightingModel& model : ir::all_lighting_models()) {
        EXPECT_NE(manifests.find(fmt::format("\"lighting\": \"{}\"", model.name)), std::string::npos)
            << "no sample has the lighting '" << model.name << "'";
        const fs::path file = test::source_dir() / fmt::format("shader_lib/lighting/{}.glsl", model.name);
        EXPECT_NE(test::read_file(file).find(fmt::format("sg_{}_radiance({} ", model.name, model.surface)),
                  std::string::npos)
            << file;
    }
}

TEST(Samples, NoGoldenWithoutItsSample) {
    std::set<std::string> stems;
    for (const fs::path& path : samples()) stems.insert(path.stem().string());
    for (const auto& entry : fs::directory_iterator(test::source_dir() / "tests/golden")) {
        EXPECT_TRUE(!entry.is_directory() || stems.count(entry.path().filename().string())) << entry.path();
    }
}

}  // namespace
}  // namespace sg

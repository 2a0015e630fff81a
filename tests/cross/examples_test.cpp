// The examples of compiler/function.md: whole shaders of engines that call a material's function.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include "target/spirv.hpp"
#include "tests/cross/function_caller.hpp"
#include "tests/cross/gl.hpp"
#include "tests/cross/hlsl.hpp"
#include "tests/cross/metal.hpp"
#include "tests/cross/process.hpp"
#include "tests/cross/results.hpp"
#include "tests/support/golden.hpp"

namespace sg::cross {
namespace {

constexpr const char* kMaterial = "layered";

std::string example(const std::string& file) {
    return test::read_file(test::source_dir() / "compiler/examples" / file);
}

const std::string& function_in(const char* target) {
    return function_text(sample(kMaterial), *target::find_target(target));
}

// Nothing but the function's text can be included.
std::vector<std::uint32_t> glsl_words(const std::string& file, target::Stage stage) {
    target::ShaderLibrary only;
    only.files["layered.function.spirv.glsl"] = function_in("spirv");
    std::string fault;
    auto words = target::compile_glsl(example(file), file, stage, only, {}, fault);
    EXPECT_EQ(fault, "");
    return words.value_or(std::vector<std::uint32_t>{});
}

void expect_the_normal_of_its_entry(const ShaderWords& words) {
    const Difference d = compare(reference(sample(kMaterial)), render_words(sample(kMaterial), words));
    fmt::print("largest {:.2e}, 99.9 % {:.2e}, {} pixels\n", d.largest, d.p999, d.both);
    EXPECT_GT(d.both, 5000u);
    EXPECT_EQ(d.one_alone, 0u);
    // An engine's vertex shader rounds in its own way. What is off in the frame counts as often as the
    // steepest slope says that the library lets through, 128.
    EXPECT_LE(d.largest, 128 * limit_of(*target::find_target("spirv")).largest);
}

TEST(Example, VulkanDrawsTheNormal) {
    expect_the_normal_of_its_entry({glsl_words("vulkan.vert", target::Stage::vertex),
                                    glsl_words("vulkan.frag", target::Stage::fragment)});
}

TEST(Example, Direct3dDrawsTheNormal) {
    const target::Target& target = *target::find_target("hlsl60");
    if (!missing_tool(target).empty()) GTEST_SKIP() << missing_tool(target);
    const Drawing bound =
        drawing(sample(kMaterial), target);  // the example has the registers of the manifest
    const std::string text = example("direct3d.hlsl");
    const HlslInclude include{"layered.function.hlsl60.hlsl", function_in("hlsl60")};
    expect_the_normal_of_its_entry({hlsl_engine(text, include, "vertex_main", true, bound.vertex.slots),
                                    hlsl_engine(text, include, "pixel_main", false, bound.fragment.slots)});
}

TEST(Example, MetalIsAccepted) {
    if (!metal_missing().empty()) GTEST_SKIP() << metal_missing();
    std::string text = example("metal.metal");
    const std::string include = "#include \"layered.function.msl23.metal\"\n";
    ASSERT_NE(text.find(include), text.npos);
    text.replace(text.find(include), include.size(), function_in("msl23"));
    EXPECT_EQ(metal_refusals({text}).at(0), "");
    const std::size_t call = text.find("sg_material_layered(inputs, parameters, ramp");
    ASSERT_NE(call, text.npos);
    text.replace(text.find("inputs, parameters", call), 18, "parameters, inputs");
    EXPECT_NE(metal_refusals({text}).at(0), "");
}

std::string glsl_fault(const std::string& declarations) {
    const std::string text = "#version 450\n" + declarations + "void main() {}\n";
    std::string fault;
    target::compile_glsl(text, "two", target::Stage::fragment, {}, {}, fault);
    return fault;
}

// The functions of two materials in one shader of each language.
void expect_that_both_fit(const Sample& one, const Sample& other) {
    auto both = [&](const char* name) {
        const target::Target& target = *target::find_target(name);
        return function_text(one, target) + function_text(other, target);
    };
    EXPECT_EQ(glsl_fault(both("spirv")), "");
    if (has_program("glslangValidator")) {
        EXPECT_EQ(hlsl_refusals({{both("hlsl50") + "void main() {}\n", false}}).at(0), "");
    }
    if (metal_missing().empty()) {
        EXPECT_EQ(metal_refusals({both("msl21")}).at(0), "");
    }
    for (const char* name : {"glsl450", "essl310"}) {
        const target::Target& target = *target::find_target(name);
        if (!missing_tool(target).empty()) continue;
        const std::string version =
            target.language == target::Language::glsl ? "#version 450\n" : "#version 310 es\n";
        EXPECT_EQ(gl_refusal(version + "void main() { gl_Position = vec4(0.0); }\n",
                             version + both(name) + "void main() {}\n", target.language),
                  "");
    }
}

TEST(Example, TwoMaterialsFitIntoOneShader) {
    expect_that_both_fit(sample("noise"), sample("decal"));
}

// What is a material's alone ends in its stem, and so may names of the library: sg_parallax_occlusion,
// sg_uv_scale, sg_resolve. They must stay apart, from each other and from another material's.
TEST(Example, AStemMayBeTheEndOfALibraryName) {
    const target::ShaderLibrary library = target::embedded_library();
    const std::pair<const char*, const char*> kStems[] = {
        {"parallax_dents", "parallax_occlusion"}, {"layered", "uv_scale"}, {"layered", "resolve"}};
    for (const auto& [name, stem] : kStems) {
        SCOPED_TRACE(stem);
        const Sample renamed = make_sample(name, stem, library);
        expect_that_both_fit(renamed, sample("parallax_detail"));
        expect_that_both_fit(sample("noise"), renamed);
        // Nor does it change what is drawn.
        for (const char* language : {"spirv", "hlsl50", "glsl450"}) {
            const target::Target& target = *target::find_target(language);
            if (!missing_tool(target).empty()) continue;
            const auto drawn = draw_all({drawing(renamed, target, shown("function"))});
            ASSERT_EQ(drawn.at(0).refusal, "");
            const Difference d = compare(reference(sample(name)), drawn.at(0).pixels);
            const Limit limit = limit_of(target, shown("function"), sample(name));
            fmt::print("{} as {}, {}: largest {:.2e}, 99.9 % {:.2e}\n", name, stem, language, d.largest,
                       d.p999);
            EXPECT_GT(d.both, 5000u);
            EXPECT_LE(d.largest, limit.largest);
            EXPECT_LE(d.p999, limit.p999);
        }
    }
}

}  // namespace
}  // namespace sg::cross

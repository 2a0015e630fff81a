// The function in Metal's language, run on the processor over the pixels of a picture, against the
// interpreter in double precision: what goes in is the same to the last bit, so that what differs is the
// text's own rounding.
#include <dlfcn.h>
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <regex>

#include "runtime/parameters.hpp"
#include "tests/cross/metal/driver.hpp"
#include "tests/cross/metal_source.hpp"
#include "tests/cross/process.hpp"
#include "tests/oracle/material_oracle.hpp"
#include "tests/render/workshop.hpp"
#include "tests/support/golden.hpp"

namespace sg::cross {
namespace {

using Json = nlohmann::json;
using oracle::Levels;
using oracle::Seen;
using ref::dvec3;

// Every third pixel of one side, level 0 of the textures.
constexpr std::size_t kStride = 3;

struct Compiled {
    std::string text;  // Metal 2.3
    Json function, manifest;
};

Compiled compile(const std::string& sample) {
    MemoryFiles files;
    const auto all = truth::sample_files();
    for (const auto& [path, bytes] : all) files.contents["in/" + path] = bytes;
    CompileRequest request;
    request.source = std::make_shared<Source>(Source{sample, all.at(sample)});
    request.stem = "sample";
    request.roots = {"in"};
    request.entries = {"function"};
    request.targets = {target::find_target("msl23")};
    Diags diags;
    auto made = compile_material(request, files, target::embedded_library(), diags);
    if (!made) throw std::runtime_error(render(diags));
    Compiled out;
    for (const auto& [name, bytes] : made->files) {
        if (name.ends_with(".metal")) out.text = bytes;
        if (name.ends_with(".json")) out.manifest = Json::parse(bytes);
    }
    out.function = out.manifest.at("function");
    return out;
}

// ---- calling it ----

constexpr std::size_t kInputs = 64, kResults = 8, kParameters = 32;
using Inputs = float[kInputs][4];
using Results = float[kResults][4];
using Parameters = float[kParameters][16];  // a matrix by its columns
using Call = void (*)(const SgBindings&, const Inputs&, const Parameters&, Results&);

// The text and a function of C that calls it: inputs, parameters and results by their place in the manifest.
std::string source_of(const Compiled& compiled, const std::string& text) {
    const Json& function = compiled.function;
    if (function.at("inputs").size() > kInputs || function.at("results").size() > kResults ||
        (function.contains("parameters") && function["parameters"]["members"].size() > kParameters))
        throw std::runtime_error("a function with more numbers than the tests can hand over");
    std::string out = metal_source({text}, false) + "using namespace sg_text_0;\n";
    out += fmt::format(
        "extern \"C\" void sg_call(const SgBindings& bindings, const float (&inputs)[{}][4], const float "
        "(&parameters)[{}][16], float (&results)[{}][4]) {{\n    SgMaterialInputs given = {{}};\n",
        kInputs, kParameters, kResults);
    std::size_t place = 0;
    for (const auto& input : function.at("inputs"))
        out +=
            fmt::format("    sg_load(given.{}, inputs[{}]);\n", input.at("name").get<std::string>(), place++);
    std::string arguments = "given";
    if (function.contains("parameters")) {
        place = 0;
        out += fmt::format("    {} set = {{}};\n", function["parameters"]["type"].get<std::string>());
        for (const auto& member : function["parameters"]["members"])
            out += fmt::format("    sg_load(set.{}, parameters[{}]);\n", member["name"].get<std::string>(),
                               place++);
        arguments += ", set";
    }
    std::size_t textures = 0, samplers = 0;
    for (const auto& resource : function.at("resources")) {
        bool texture = resource.at("kind") == "texture";
        arguments += fmt::format(", sg_{0}(bindings.{0}s[{1}])", texture ? "texture" : "sampler",
                                 texture ? textures++ : samplers++);
    }
    out += fmt::format("    SgMaterialResult made = {}({});\n", function.at("name").get<std::string>(),
                       arguments);
    place = 0;
    for (const auto& result : function.at("results"))
        out += fmt::format("    sg_store(made.{}, results[{}]);\n", result.at("name").get<std::string>(),
                           place++);
    return out + "}\n";
}

class Library {
public:
    explicit Library(const std::string& source) {
        static int count = 0;
        const auto file = scratch() / fmt::format("function{}.cpp", count),
                   so = scratch() / fmt::format("function{}.so", count++);
        write_file(file, source);
        const Outcome outcome =
            run(fmt::format("clang++ -std=c++17 -w -Xclang -cl-single-precision-constant -ffp-contract=off "
                            "-O1 -shared -fPIC -I '{}' "
                            "'{}' -o '{}' 2>&1",
                            (test::source_dir() / "tests/cross/metal").string(), file.string(), so.string()));
        if (outcome.exit_code != 0) throw std::runtime_error("clang: " + outcome.text.substr(0, 2000));
        handle_ = ::dlopen(so.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!handle_) throw std::runtime_error(::dlerror());
        call = reinterpret_cast<Call>(::dlsym(handle_, "sg_call"));
    }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    ~Library() { ::dlclose(handle_); }
    Call call = nullptr;

private:
    void* handle_ = nullptr;
};

// ---- what it is fed ----

dvec3 rounded(dvec3 v) {
    return dvec3(glm::vec3(v));
}

// As the function takes them, and as the interpreter does.
std::vector<ir::PixelInputs> pixels_of(const std::string& sample, Seen seen) {
    std::vector<ir::PixelInputs> out;
    const auto all = oracle::draw_inputs(sample, seen);
    for (std::size_t i = 0; i < all.size(); i += kStride) {
        ir::PixelInputs pixel = all[i];
        pixel.vertex_normal = rounded(pixel.vertex_normal);
        pixel.vertex_tangent = glm::dvec4(glm::vec4(pixel.vertex_tangent));
        out.push_back(pixel);
    }
    return out;
}

// What only parallax asks for.
std::optional<glm::dvec4> camera_input(const ir::PixelInputs& pixel, const std::string& name) {
    const ir::PixelCamera& camera = pixel.camera;
    if (name == "object_origin") return glm::dvec4(pixel.object_origin, 0);
    if (name == "base_normal_dx") return glm::dvec4(pixel.dndx, 0);
    if (name == "base_normal_dy") return glm::dvec4(pixel.dndy, 0);
    if (name == "camera_position") return glm::dvec4(camera.position, 0);
    if (name == "to_viewer")
        return camera.perspective ? glm::dvec4(0, 0, 0, 1) : glm::dvec4(-camera.direction, 0);
    if (name == "screen_x") return camera.relative_from_screen[0];
    if (name == "screen_y") return camera.relative_from_screen[1];
    // The last row of the inverse gives the homogeneous weight, whatever the viewport.
    if (name == "clip_w") return glm::transpose(glm::inverse(camera.relative_from_screen))[3];
    return std::nullopt;
}

glm::dvec4 input_of(const ir::PixelInputs& pixel, const std::string& name) {
    if (const auto given = camera_input(pixel, name)) return *given;
    const bool along_x = name.ends_with("_dx"), along_y = name.ends_with("_dy");
    const std::string base = name.substr(0, name.size() - (along_x || along_y ? 3 : 0));
    auto pick = [&](auto p, auto dx, auto dy) { return along_x ? dx : along_y ? dy : p; };
    if (base == "position") return {pick(pixel.position, pixel.dpdx, pixel.dpdy), 0};
    if (base == "normal") return {pixel.vertex_normal, 0};
    if (base == "tangent") return pixel.vertex_tangent;
    if (base == "color") return pixel.vertex_color;
    if (base == "facing") return {pixel.facing, 0, 0, 0};
    if (base == "time") return {pixel.time, 0, 0, 0};
    if (base == "object_position") return {pick(pixel.object.p, pixel.object.dx, pixel.object.dy), 0};
    if (base == "world_position") return {pick(pixel.world.p, pixel.world.dx, pixel.world.dy), 0};
    if (base.starts_with("object_")) return {pixel.world_from_object[base.back() - 'x'], 0};
    if (!base.starts_with("uv")) throw std::runtime_error("no input " + name);
    const ref::Uv& uv = pixel.uvs[static_cast<std::size_t>(base.back() - '0')];
    return {pick(uv.st, uv.dx, uv.dy), 0, 0};
}

// The textures' texels as floats, and samplers, in the order of the arguments.
struct Bound {
    SgBindings bindings{};
    std::vector<std::vector<float>> texels;
};
void bind(const Compiled& compiled, const oracle::Material& material, Bound& out) {
    std::size_t textures = 0, samplers = 0;
    std::map<std::uint32_t, ir::Sampled> sampler_at;
    for (const auto& resource : compiled.function.at("resources")) {
        const auto binding = resource.at("binding").get<std::uint32_t>();
        if (resource.at("kind") == "sampler") {
            const ir::Sampled& s = sampler_at.at(binding);
            constexpr int kWords[] = {0, 1, 2};  // repeat, mirror, clamp in both
            out.bindings.samplers[samplers++] = {kWords[static_cast<std::size_t>(s.wrap_s)],
                                                 kWords[static_cast<std::size_t>(s.wrap_t)],
                                                 s.linear ? 1 : 0};
            continue;
        }
        std::string name;
        for (const auto& row : compiled.manifest.at("textures"))
            if (row.at("binding") == binding) name = row.at("name");
        for (std::size_t i = 0; i < material.module.textures.size(); ++i) {
            if (material.module.textures[i].name != name || !material.bindings.textures[i].texels) continue;
            const auto& level = material.textures[i].chain.front();
            out.texels.emplace_back();
            for (const auto& texel : level.texels)
                for (int c = 0; c < 4; ++c) out.texels.back().push_back(static_cast<float>(texel[c]));
            out.bindings.textures[textures++] = {out.texels.back().data(), level.size.x, level.size.y};
            sampler_at[resource.at("sampler_binding")] = material.bindings.textures[i];
            break;
        }
    }
}

// Behind the parameters, what follows from them.
void derive(const Compiled& compiled, const oracle::Material& material, Parameters& parameters) {
    Diags diags;
    const auto artefact = runtime::read_manifest(compiled.manifest.dump(), "manifest", diags);
    if (!artefact) throw std::runtime_error(render(diags));
    if (!artefact->parameters) return;
    std::vector<runtime::Numbers> given;
    const std::size_t first = material.bindings.parameters.size();
    for (std::size_t i = 0; i < first; ++i) {
        given.push_back({.count = ir::components(material.bindings.parameters[i]).size()});
        for (std::size_t c = 0; c < given.back().count; ++c) given.back().at[c] = double{parameters[i][c]};
    }
    const auto derived = runtime::derived_numbers(*artefact->parameters, given);
    for (std::size_t i = 0; i < derived.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) parameters[first + i][c] = runtime::stored(derived[i][c]);
    }
}

struct Made {
    std::vector<dvec3> normals;
    std::vector<std::array<std::array<float, 4>, kResults>> results;
};

Made run_function(const Compiled& compiled, const std::string& text, const oracle::Material& material,
                  const std::vector<ir::PixelInputs>& pixels) {
    const Library library(source_of(compiled, text));
    Bound bound;
    bind(compiled, material, bound);
    Parameters parameters{};
    for (std::size_t i = 0; i < material.bindings.parameters.size(); ++i) {
        const auto values = ir::components(material.bindings.parameters[i]);
        for (std::size_t c = 0; c < values.size(); ++c) parameters[i][c] = static_cast<float>(values[c]);
    }
    derive(compiled, material, parameters);
    Made out;
    for (const ir::PixelInputs& pixel : pixels) {
        Inputs inputs{};
        std::size_t place = 0;
        for (const auto& input : compiled.function.at("inputs")) {
            const glm::dvec4 value = input_of(pixel, input.at("name"));
            for (int c = 0; c < 4; ++c) inputs[place][c] = static_cast<float>(value[c]);
            ++place;
        }
        Results results{};
        library.call(bound.bindings, inputs, parameters, results);
        out.results.emplace_back();
        std::memcpy(out.results.back().data(), results, sizeof(results));
        out.normals.emplace_back(results[0][0], results[0][1], results[0][2]);
    }
    return out;
}

// The largest difference of any result but the normal.
double other_results(const Compiled& compiled, const oracle::Material& material,
                     const std::vector<ir::PixelInputs>& pixels, const Made& made) {
    ir::Evaluator evaluator(material.module, material.bindings);
    double largest = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        evaluator.run(pixels[i]);
        std::size_t place = 0;
        for (const auto& result : compiled.function.at("results")) {
            const std::size_t at = place++;
            const std::string name = result.at("name");
            for (ir::Output output : ir::all_outputs()) {
                if (at == 0 || ir::output_name(output) != name || !material.module.output(output).valid())
                    continue;
                const auto values = ir::components(evaluator.output(output));
                for (std::size_t c = 0; c < values.size(); ++c) {
                    const double d = std::abs(values[c] - double{made.results[i][at][c]});
                    largest = d <= largest ? largest : d;
                }
            }
        }
    }
    return largest;
}

std::string report(const std::string& name, const oracle::Comparison& c) {
    return fmt::format(
        "{:40} median {:.6f} (bound {:.6f})  p99.9 {:.6f} (bound {:.6f})  {:.3f} % beyond their own of {}\n",
        name, c.median, c.median_bound, c.p999, c.p999_bound, 100 * c.beyond, c.pixels);
}

class MetalFunction : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        if (!has_program("clang++")) GTEST_SKIP() << "no clang++";
    }
};

// The bound of each pixel is derived in tests/oracle/deviation.cpp.
TEST_P(MetalFunction, IsWhatTheInterpreterComputes) {
    const std::string& sample = GetParam();
    const Compiled compiled = compile(sample);
    const oracle::Material material(sample, Levels::first);
    const auto pixels = pixels_of(sample, Seen::outside);
    const Made made = run_function(compiled, compiled.text, material, pixels);
    const oracle::Comparison c = oracle::compare(material, material.module, pixels, made.normals);
    fmt::print("{}", report(sample, c));
    EXPECT_TRUE(c.holds()) << report(sample, c);
    EXPECT_EQ(c.beyond, 0.0) << "the largest of them, too, stays below its own bound";
    // Behind parallax, a ray that grazes the surface moves the hit by many times what rounding does to
    // heights.
    const bool grazes = std::any_of(material.module.values.begin(), material.module.values.end(),
                                    [](const ir::Value& v) { return ir::looks_along_ray(v.op); });
    EXPECT_LT(c.p999_bound, grazes ? 0.15 : 0.05);
    // Colours and numbers lie in 0 to 1. A coordinate up to 10 is off by 4 roundings, which over 256 texels
    // of 1 each is 4 2^-24 10 256 = 6.1e-4 of a channel; all other roundings, a hundred of 2^-24, are nothing
    // beside it.
    const double others = other_results(compiled, material, pixels, made);
    fmt::print("{:40} other results: {:.2e}\n", sample, others);
    EXPECT_LT(others, 6.2e-4);
}
INSTANTIATE_TEST_SUITE_P(Samples, MetalFunction, testing::ValuesIn(oracle::all_samples()),
                         [](const auto& row) { return row.param.substr(0, row.param.find('.')); });

struct Mutant {
    const char *name, *sample, *pattern, *wrong;
};
std::ostream& operator<<(std::ostream& out, const Mutant& m) {
    return out << m.name;
}
class WrongMetalFunction : public testing::TestWithParam<Mutant> {};

TEST_P(WrongMetalFunction, IsNoticed) {
    if (!has_program("clang++")) GTEST_SKIP() << "no clang++";
    const Mutant& mutant = GetParam();
    const Compiled compiled = compile(mutant.sample);
    const std::string wrong = std::regex_replace(compiled.text, std::regex(mutant.pattern), mutant.wrong);
    ASSERT_NE(wrong, compiled.text);
    const oracle::Material material(mutant.sample, Levels::first);
    const auto pixels = pixels_of(mutant.sample, Seen::outside);
    const oracle::Comparison c = oracle::compare(material, material.module, pixels,
                                                 run_function(compiled, wrong, material, pixels).normals);
    fmt::print("{}", report(mutant.name, c));
    EXPECT_GT(c.pixels, 1000u);
    EXPECT_FALSE(c.holds());
}
INSTANTIATE_TEST_SUITE_P(
    Texts, WrongMetalFunction,
    testing::Values(Mutant{"resolve_adds", "layered.json", "= n - g;", "= n + g;"},
                    Mutant{"slopes_a_ten_thousandth_too_steep", "normal_map.json", "= n - g;",
                           "= n - g * 1.0001;"},
                    Mutant{"derivatives_swapped", "normal_map.json", "sg_inputs.uv0_dx, sg_inputs.uv0_dy",
                           "sg_inputs.uv0_dy, sg_inputs.uv0_dx"},
                    Mutant{"t_flipped", "layered.json", "sample\\(filtering, uv.st,",
                           "sample(filtering, float2(uv.st.x, 1.0 - uv.st.y),"},
                    Mutant{"textures_swapped", "layered.json", "t_ramp, texture2d<float> t_pebble",
                           "t_pebble, texture2d<float> t_ramp"},
                    Mutant{"side_forgotten", "layered.json", "= sg_inputs.facing;", "= -sg_inputs.facing;"}),
    [](const auto& row) { return row.param.name; });

TEST(MetalFunctionRun, ValidationLayersHaveNothingToSay) {
    EXPECT_EQ(oracle::validation_messages(), std::vector<std::string>{});
}

}  // namespace
}  // namespace sg::cross

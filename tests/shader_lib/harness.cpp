#include "harness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <sstream>

#include "base/diag.hpp"
#include "base/ice.hpp"
#include "runtime/compute.hpp"
#include "runtime/gpu/device.hpp"
#include "runtime/gpu/image.hpp"

namespace sg::proof {
namespace {

runtime::gpu::Device& device() {
    static Diags diags;
    static std::optional<runtime::gpu::Device> made = runtime::gpu::Device::create({}, diags);
    if (!made) std::cerr << render(diags);
    SG_ASSERT(made);
    return *made;
}

constexpr const char* kPrologue = R"(
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Inputs { float proof_in[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { float proof_out[]; };
layout(set = 0, binding = 2, std140) uniform Count { uint proof_count; };
uint in_at, out_at;
float f(int k) { return proof_in[in_at + k]; }
vec2 v2(int k) { return vec2(f(k), f(k + 1)); }
vec3 v3(int k) { return vec3(f(k), f(k + 1), f(k + 2)); }
vec4 v4(int k) { return vec4(v3(k), f(k + 3)); }
mat3 m3(int k) { return mat3(v3(k), v3(k + 3), v3(k + 6)); }
mat4 m4(int k) { return mat4(v4(k), v4(k + 4), v4(k + 8), v4(k + 12)); }
void put(int k, float x) { proof_out[out_at + k] = x; }
void put(int k, vec2 v) { put(k, v.x); put(k + 1, v.y); }
void put(int k, vec3 v) { put(k, v.xy); put(k + 2, v.z); }
void put(int k, vec4 v) { put(k, v.xyz); put(k + 3, v.w); }
)";

std::string texture_declarations(std::size_t count) {
    std::string out;
    for (std::size_t i = 0; i < count; ++i) {
        out += fmt::format("layout(set = 0, binding = {}) uniform texture2D image_{};\n", 3 + 2 * i, i);
        out += fmt::format("layout(set = 0, binding = {}) uniform sampler sampler_{};\n", 4 + 2 * i, i);
    }
    return out;
}

std::optional<runtime::gpu::Image> upload(const ref::MemoryTexture& texture, Diags& diags) {
    std::vector<std::vector<glm::vec4>> texels;
    std::vector<runtime::gpu::Level> levels;
    for (const auto& level : texture.chain) {
        texels.emplace_back(level.texels.begin(), level.texels.end());
        VkExtent2D extent{static_cast<std::uint32_t>(level.size.x), static_cast<std::uint32_t>(level.size.y)};
        levels.push_back({extent, std::as_bytes(std::span<const glm::vec4>(texels.back()))});
    }
    return runtime::gpu::Image::create_texture(device(), VK_FORMAT_R32G32B32A32_SFLOAT, levels, diags);
}

runtime::gpu::SamplerState sampling_of(const ref::Sampler& sampler) {
    auto wrap = [](ref::Wrap w) {
        return w == ref::Wrap::clamp ? runtime::gpu::Wrap::clamp : runtime::gpu::Wrap::repeat;
    };
    return {.wrap_s = wrap(sampler.wrap_s), .wrap_t = wrap(sampler.wrap_t)};
}

bool run_words(const Case& item, std::span<const std::uint32_t> words, std::span<const float> inputs,
               std::span<float> outputs, Diags& diags) {
    std::vector<runtime::gpu::Image> images;
    images.reserve(item.textures.size());
    std::vector<runtime::ComputeTexture> textures;
    for (const auto& texture : item.textures) {
        auto image = upload(texture->image, diags);
        if (!image) return false;
        images.push_back(std::move(*image));
        textures.push_back({&images.back(), sampling_of(texture->sampler)});
    }
    auto compute = runtime::Compute::create(device(), words, diags, textures);
    const auto in_size = static_cast<std::size_t>(item.inputs);
    return compute && compute->run(inputs, in_size, outputs, static_cast<std::size_t>(item.outputs),
                                   inputs.size() / in_size, diags);
}

std::string listed(std::span<const float> floats) {
    std::string out;
    for (float x : floats) out += fmt::format("{}{:.9g}", out.empty() ? "" : ", ", x);
    return out;
}

// The bound at one input, or the reason why the results break the case's property.
struct Verdict {
    double sensitivity = std::numeric_limits<double>::infinity();
    double ratio = 0.0;
    double error = 0.0;
    std::string reason;
};

Verdict judge(const Case& item, const In& in, std::span<const float> out, std::vector<double>& expected) {
    Verdict verdict;
    if (item.property) verdict.reason = item.property(in, In(out));
    if (!item.reference) return verdict;
    Expect expect(expected);
    item.reference(in, expect);
    const double condition = item.condition ? item.condition(in) : 1.0;
    for (std::size_t k = 0; k < out.size(); ++k) {
        const double error = std::abs(out[k] - expected[k]);
        const double allowed =
            condition * (item.bound.absolute + item.bound.relative * std::abs(expected[k]));
        // Not-a-number compares false with everything: it takes the failing branch.
        const double ratio = error <= allowed ? (error > 0.0 ? error / allowed : 0.0)
                                              : (error > allowed ? error / allowed : INFINITY);
        verdict.error = std::max(verdict.error, error);
        if (expected[k] != 0.0)
            verdict.sensitivity = std::min(verdict.sensitivity, allowed / std::abs(expected[k]));
        if (!(ratio > verdict.ratio)) continue;
        verdict.ratio = ratio;
        if (ratio > 1.0) {
            verdict.reason += fmt::format("output {}: {:.9g}, double says {:.17g}, allowed {:.3g}; ", k,
                                          out[k], expected[k], allowed);
        }
    }
    return verdict;
}

}  // namespace

std::uint64_t run_seed() {
    static const std::uint64_t seed = [] {
        if (const char* given = std::getenv("SG_SEED"))
            return std::uint64_t{std::strtoull(given, nullptr, 10)};
        const std::uint64_t value = std::random_device{}();
        std::cout << "SG_SEED=" << value << std::endl;
        setenv("SG_SEED", std::to_string(value).c_str(), 1);  // the children of death tests draw the same
        return value;
    }();
    return seed;
}

Random::Random(std::string_view name) {
    std::uint64_t hash = 1469598103934665603ull;
    for (char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
    std::seed_seq sequence{run_seed(), run_seed() >> 32, hash, hash >> 32};
    engine_.seed(sequence);
}

std::string shader_text(const Case& item) {
    std::string text = kPrologue;
    std::istringstream files(item.include);
    for (std::string file; files >> file;) text += "#include \"" + file + "\"\n";
    text += texture_declarations(item.textures.size()) + item.declarations;
    text += "void proof_case() {\n" + item.glsl + "\n}\n";
    text += fmt::format(R"(void main() {{
    uint i = gl_GlobalInvocationID.x;
    if (i < proof_count) {{
        in_at = i * {}u;
        out_at = i * {}u;
        proof_case();
    }}
}}
)",
                        item.inputs, item.outputs);
    return text;
}

std::vector<float> evaluate(const Case& item, std::span<const float> inputs, const Mutant* mutant) {
    const std::size_t count = inputs.size() / static_cast<std::size_t>(item.inputs);
    std::vector<float> outputs(count * static_cast<std::size_t>(item.outputs));
    Compiled compiled = compile_glsl(shader_text(item), Stage::compute, mutant);
    if (compiled.words.empty()) {
        ADD_FAILURE() << item.name << " does not compile:\n" << compiled.log << shader_text(item);
        return outputs;
    }
    Diags diags;
    const bool ran = run_words(item, compiled.words, inputs, outputs, diags);
    if (!ran) ADD_FAILURE() << item.name << " does not run:\n" << render(diags);
    return outputs;
}

Worst compare(const Case& item, std::span<const float> inputs, std::span<const float> outputs) {
    Worst worst;
    const auto in_size = static_cast<std::size_t>(item.inputs),
               out_size = static_cast<std::size_t>(item.outputs);
    std::vector<double> expected(out_size);
    for (std::size_t i = 0; i * in_size < inputs.size(); ++i) {
        auto in = inputs.subspan(i * in_size, in_size);
        auto out = outputs.subspan(i * out_size, out_size);
        Verdict verdict = judge(item, In(in), out, expected);
        worst.ratio = std::max(worst.ratio, verdict.ratio);
        worst.error = std::max(worst.error, verdict.error);
        worst.sensitivity = std::min(worst.sensitivity, verdict.sensitivity);
        if (!verdict.reason.empty() && worst.violation.empty()) {
            worst.violation =
                fmt::format("{}\n  input {{{}}}\n  output {{{}}}", verdict.reason, listed(in), listed(out));
        }
    }
    return worst;
}

std::vector<float> draw_inputs(const Case& item, std::size_t count) {
    Random random(item.name);
    const auto size = static_cast<std::size_t>(item.inputs);
    std::vector<float> inputs(count * size);
    for (std::size_t i = 0; i < count; ++i) {
        Draw draw(std::span<float>(inputs).subspan(i * size, size));
        item.draw(random, draw);
    }
    return inputs;
}

bool is_finite(glm::dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
bool is_unit(glm::dvec3 v, double tolerance) {
    return std::abs(glm::length(v) - 1.0) <= tolerance;
}

std::vector<MutantOf> mutants_of(const std::vector<Case>& cases) {
    std::vector<MutantOf> out;
    for (const Case& item : cases) {
        for (const Mutant& mutant : item.mutants) out.push_back({item, mutant});
    }
    return out;
}

namespace {

std::vector<std::function<std::vector<Case>()>>& case_lists() {
    static std::vector<std::function<std::vector<Case>()>> lists;
    return lists;
}

}  // namespace

bool add_cases(std::function<std::vector<Case>()> cases) {
    case_lists().push_back(std::move(cases));
    return true;
}

const std::vector<Case>& all_cases() {
    static const std::vector<Case> all = [] {
        std::vector<Case> out;
        for (const auto& list : case_lists()) out = joined(std::move(out), list());
        return out;
    }();
    return all;
}

const Case* find_case(const std::string& name) {
    const std::vector<Case>& all = all_cases();
    auto found = std::find_if(all.begin(), all.end(), [&](const Case& item) { return item.name == name; });
    return found == all.end() ? nullptr : &*found;
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
    return info.param.name;
}
std::string mutant_name(const testing::TestParamInfo<MutantOf>& info) {
    const Case& item = info.param.item;
    std::size_t number = 1;
    while (item.mutants[number - 1].find != info.param.mutant.find ||
           item.mutants[number - 1].replace != info.param.mutant.replace) {
        ++number;
    }
    return item.name + "_" + std::to_string(number);
}

TEST_P(AgainstDouble, Holds) {
    const Case& item = GetParam();
    ASSERT_TRUE(item.reference || item.property) << "the case asserts nothing";
    std::vector<float> inputs = draw_inputs(item, item.count);
    Worst worst = compare(item, inputs, evaluate(item, inputs));
    EXPECT_EQ(worst.violation, "") << "SG_SEED=" << run_seed();
    if (item.blunt.empty() && std::isfinite(worst.sensitivity)) {
        EXPECT_LE(worst.sensitivity, kNoticed) << "the bound hides formulas that are off by that";
    }
    std::cout << fmt::format("  {:<40} largest error {:.2e}, {:.0f} % of what is allowed; notices {:.1e}\n",
                             item.name, worst.error, 100.0 * worst.ratio, worst.sensitivity);
}

TEST_P(Mutants, AreNoticed) {
    const auto& [item, mutant] = GetParam();
    ASSERT_TRUE(mutated_text(mutant))
        << "'" << mutant.find << "' does not stand exactly once in " << mutant.file;
    std::vector<float> inputs = draw_inputs(item, kMutantCount);
    Worst worst = compare(item, inputs, evaluate(item, inputs, &mutant));
    EXPECT_NE(worst.violation, "") << item.name << " holds although '" << mutant.find << "' became '"
                                   << mutant.replace << "'; SG_SEED=" << run_seed();
}

}  // namespace sg::proof

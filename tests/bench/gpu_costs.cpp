// surfgrad-bench-gpu: what each sample's forward fragment shader costs, in SPIR-V instructions that do work
// and on an AMD GPU that need not be there: as lowered, as shipped, and without each rule of the optimiser in
// turn; at the end, what each rule saves over all samples. Then a material against a shader that was written
// by hand to do the same, where its folder is present.
#include <fmt/format.h>

#include <cstdlib>

#include "base/ice.hpp"
#include "custom_shaders.hpp"
#include "gpu_fragment.hpp"
#include "opt/optimise.hpp"
#include "samples.hpp"
#include "stages.hpp"

namespace sg::bench {
namespace {

struct Cost {
    std::size_t spirv = 0;
    GpuStatistics gpu;
};

Cost cost_of(const target::Words& fragment) {
    auto gpu = fragment_statistics(fragment);
    SG_ASSERT(gpu.has_value());
    return {target::instruction_count(fragment), *gpu};
}

// How a sample's module is treated.
struct Treatment {
    bool optimise = true;
    std::string_view without;
};

class Sample {
public:
    explicit Sample(const std::filesystem::path& path) : stem_(path.stem().string()) {
        RealFiles files;
        Diags diags;
        const SourcePtr source = source_of(path);
        auto checked = read_and_check(source, {{path.parent_path()}}, files, diags);
        if (!checked || !verify_shaders(*checked, {}, target::embedded_library(), source, diags))
            SG_UNREACHABLE(render(diags));
        lowered_ = material::lower(*checked);
        groups_ = group_samplers(*checked).group;
    }

    [[nodiscard]] target::Words fragment(const Treatment& treatment,
                                         const target::ShaderLibrary& library) const {
        ir::Module module = treatment.optimise ? opt::optimise(lowered_, treatment.without) : lowered_;
        const emit::EntryPoint& entry = *emit::find_entry_point("forward");
        emit::MaterialInterface interface = emit::material_interface(module, groups_);
        emit::Shaders shaders = emit::emit_glsl(
            opt::select_outputs(module, emit::needed_outputs(entry, module)), entry, interface);
        return to_spirv(shaders.fragment, stem_ + ".frag", target::Stage::fragment, library, {});
    }

private:
    std::string stem_;
    ir::Module lowered_;
    std::vector<std::uint32_t> groups_;
};

double percent(std::uint64_t now, std::uint64_t before) {
    return 100.0 * (static_cast<double>(now) / static_cast<double>(before) - 1.0);
}

// What a rule of the optimiser is worth: all samples without it against all with it. Negative: it costs.
struct Worth {
    std::size_t samples = 0;  // that it changes
    std::int64_t spirv = 0, gpu = 0;
    std::int64_t largest = 0;  // of the GPU's instructions, in one sample
    std::string where;

    void count(const Cost& without, const Cost& with, const std::string& sample) {
        const auto saved = static_cast<std::int64_t>(without.gpu.instructions - with.gpu.instructions);
        ++samples;
        spirv += static_cast<std::int64_t>(without.spirv - with.spirv);
        gpu += saved;
        if (saved > largest) largest = saved, where = sample;
    }
};

// By opt::all_rules().
void print_sample(const std::filesystem::path& path, const target::ShaderLibrary& library,
                  std::vector<Worth>& worths) {
    const std::string stem = path.stem().string();
    const Sample sample(path);
    const Cost lowered = cost_of(sample.fragment({.optimise = false}, library)),
               ours = cost_of(sample.fragment({}, library));
    fmt::print("{:<24} {:>7} ->{:>6} {:>7} ->{:>6} {:>+5.0f}% {:>6} ->{:>5} {:>4} ->{:>3}\n", stem,
               lowered.spirv, ours.spirv, lowered.gpu.instructions, ours.gpu.instructions,
               percent(ours.gpu.instructions, lowered.gpu.instructions), lowered.gpu.vector_registers,
               ours.gpu.vector_registers, lowered.gpu.waves, ours.gpu.waves);
    const std::span<const opt::Rule> rules = opt::all_rules();
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const Cost without = cost_of(sample.fragment({.without = rules[i].name}, library));
        if (without.spirv == ours.spirv && without.gpu.instructions == ours.gpu.instructions) continue;
        worths[i].count(without, ours, stem);
        fmt::print("  without {:<30} {:>8} {:>22} {:>14} {:>9}\n", rules[i].name, without.spirv,
                   without.gpu.instructions, without.gpu.vector_registers, without.gpu.waves);
    }
}

void print_rules(const std::vector<Worth>& worths) {
    fmt::print("\n{:<30} {:>8} {:>14} {:>20}  {}\n", "what each rule saves", "samples", "SPIR-V in all",
               "navi21 instructions", "the most of these");
    for (std::size_t i = 0; i < worths.size(); ++i) {
        const Worth& worth = worths[i];
        const std::string most = worth.largest > 0    ? fmt::format("{} ({})", worth.largest, worth.where)
                                 : worth.samples == 0 ? "nothing here: see its row in opt_rules_test.cpp"
                                                      : "none";
        fmt::print("{:<30} {:>8} {:>14} {:>20}  {}\n", opt::all_rules()[i].name, worth.samples, worth.spirv,
                   worth.gpu, most);
    }
}

void print_samples(const target::ShaderLibrary& library) {
    fmt::print("{:<24} {:>16} {:>22} {:>14} {:>9}\n", "forward fragment shader", "SPIR-V",
               "navi21 instructions", "VGPRs", "waves");
    std::vector<Worth> worths(opt::all_rules().size());
    for (const auto& path : samples()) print_sample(path, library, worths);
    print_rules(worths);
}

// ---- against shaders that were written by hand ----

std::filesystem::path hand_folder() {
    return std::filesystem::path(SG_SOURCE_DIR) / "../shared/bench";
}

void replace(std::string& text, std::string_view what, std::string_view with) {
    const std::size_t at = text.find(what);
    if (at == std::string::npos) SG_UNREACHABLE(fmt::format("nothing to replace: {}", what));
    text.replace(at, what.size(), with);
}

// The hand-written shader with this project's lighting (the ambient term included) and noise, and colour as
// its only output, so that the rest is what differs.
std::string with_our_parts(std::string text) {
    replace(text, "#include \"sg_lib.glsl\"\n",
            "#include \"sg_lib.glsl\"\n#include \"lighting/ggx.glsl\"\n#include \"surfgrad/noise.glsl\"\n"
            "vec3 our_shade(vec3 n, vec3 v, vec3 l, vec3 color, float roughness, float metallic) {\n"
            "    return sg_ggx_radiance(SgGgxSurface(color, metallic, roughness, 1.0, vec3(0.0)), n,\n"
            "                           SgLights(v, l, frame.lightColor.rgb, frame.ambient.rgb));\n}\n"
            "vec4 our_turbulence(vec3 p, float footprint, int octaves) {\n"
            "    SgNoise noise = sg_noise_turbulence(p, footprint, octaves);\n"
            "    return vec4(noise.gradient, noise.value);\n}\n");
    replace(text, "    vec4 lightColor;\n", "    vec4 lightColor;\n    vec4 ambient;\n");
    replace(text, "sgShade(", "our_shade(");
    const std::size_t lit = text.find("c * frame.lightColor.rgb + 0.03 * ");
    SG_ASSERT(lit != std::string::npos);
    text.replace(lit, text.find(',', lit) - lit, "c");
    if (text.find("sgTurbulence(") != std::string::npos) replace(text, "sgTurbulence(", "our_turbulence(");
    if (const std::size_t second = text.find("    oNormal ="); second != std::string::npos) {
        text.erase(second, text.find('\n', second) - second);
        replace(text, "layout(location = 1) out vec4 oNormal;", "");
    }
    return text;
}

// The hand-written shader reads behind parallax as if neighbouring pixels saw one surface there, which this
// project refuses. Here these reads are given the derivatives of its own rebuilt frame.
std::string with_gradients_behind_parallax(std::string text) {
    replace(text, "vec3 p = s.worldPos * params.triScale.xyz;",
            "vec3 p = s.worldPos * params.triScale.xyz;\n"
            "    vec3 step_x = sg_dPdx * params.triScale.xyz, step_y = sg_dPdy * params.triScale.xyz;");
    for (std::string plane : {"zy", "xz", "xy"})
        replace(text, fmt::format("texture(tTri, p.{})", plane),
                fmt::format("textureGrad(tTri, p.{0}, step_x.{0}, step_y.{0})", plane));
    replace(text, "vec2 st = lp.xy + 0.5;",
            "vec2 st = lp.xy + 0.5;\n"
            "    vec2 step_x = (w2l * vec4(sg_dPdx, 0.0)).xy, step_y = (w2l * vec4(sg_dPdy, 0.0)).xy;");
    replace(text, "texture(tc, st)", "textureGrad(tc, st, step_x, step_y)");
    replace(text, "texture(tn, st)", "textureGrad(tn, st, step_x, step_y)");
    return text;
}

void print_row(const char* what, const Cost& cost, const Cost& hand) {
    fmt::print("  {:<52} SPIR-V {:>5}, navi21 {:>5} instructions ({:.2f}), {:>3} VGPRs, {} waves\n", what,
               cost.spirv, cost.gpu.instructions,
               static_cast<double>(cost.gpu.instructions) / static_cast<double>(hand.gpu.instructions),
               cost.gpu.vector_registers, cost.gpu.waves);
}

void compare(const std::string& letter, target::ShaderLibrary library) {
    const auto file = hand_folder() / (letter + ".frag");
    const auto material = sample_folder() / ("bench_" + letter + ".json");
    fmt::print("\nmaterials/bench_{}.json against a shader of the same meaning, written by hand:\n", letter);
    if (!std::filesystem::exists(file)) {
        fmt::print("  not compared: there is no {}\n", file.lexically_normal().string());
        return;
    }
    library.files["sg_lib.glsl"] = text_of(hand_folder() / "sg_lib.glsl");
    auto hand = [&](const std::string& text) {
        return cost_of(to_spirv(text, letter + ".frag", target::Stage::fragment, library, {}));
    };
    const Sample sample(material);
    const std::string text = text_of(file);
    const Cost as_written = hand(text), same_parts = hand(with_our_parts(text));
    print_row("by hand, as written", as_written, as_written);
    print_row("ours, as shipped", cost_of(sample.fragment({}, library)), as_written);
    print_row("by hand, with our lighting, noise and outputs", same_parts, same_parts);
    print_row("ours", cost_of(sample.fragment({}, library)), same_parts);
    if (text.find("sgParallaxOcclusion") == std::string::npos) return;
    const Cost derived = hand(with_gradients_behind_parallax(with_our_parts(text)));
    print_row("by hand, likewise, with gradients behind parallax", derived, derived);
    print_row("ours", cost_of(sample.fragment({}, library)), derived);
}

int run(bool samples) {
    const target::ShaderLibrary library = target::embedded_library();
    if (!fragment_statistics(Sample(sample_folder() / "normal_map.json").fragment({}, library))) {
        fmt::print("navi21: Mesa's RADV is not here; nothing counted\n");
        return 0;
    }
    if (samples) print_samples(library);
    for (const char* letter : {"a", "b", "c"}) compare(letter, library);
    return 0;
}

}  // namespace
}  // namespace sg::bench

int main(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "--gpu") return sg::bench::run(argc == 2);
    // The choice of drivers is made once per process.
    const std::string again = fmt::format("{} '{}' --gpu", sg::bench::kGpuEnvironment, argv[0]);
    return std::system(again.c_str()) == 0 ? 0 : 1;
}

// surfgrad-bench-turbulence: what the analytic gradient of turbulence costs, against finite differences from
// four evaluations at equal octaves. Prints lavapipe's time and the instructions that RADV makes for an AMD
// GPU. The four evaluations are of this library's own noise, of which the compiler drops the gradient:
// nothing is made dear on purpose.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string_view>
#include <vector>

#include "gpu_statistics.hpp"
#include "runtime/compute.hpp"
#include "runtime/gpu/device.hpp"
#include "tests/shader_lib/glsl.hpp"

namespace sg::bench {
namespace {

constexpr std::size_t kPoints = 1 << 17;
constexpr int kRounds = 9;

struct Kernel {
    const char* name;
    const char* glsl;  // declares vec4 kernel(vec3 p, float footprint): gradient and value
};

constexpr std::array kKernels = {
    Kernel{"nothing", "vec4 kernel(vec3 p, float footprint) { return vec4(p, footprint); }"},
    Kernel{"analytic", R"(
vec4 kernel(vec3 p, float footprint) {
    SgNoise n = sg_noise_turbulence(p, footprint, OCTAVES);
    return vec4(n.gradient, n.value);
})"},
    Kernel{"four evaluations", R"(
float height(vec3 p, float footprint) { return sg_noise_turbulence(p, footprint, OCTAVES).value; }
vec4 kernel(vec3 p, float footprint) {
    const float e = 0.001;
    float h = height(p, footprint);
    return vec4((vec3(height(p + vec3(e, 0.0, 0.0), footprint), height(p + vec3(0.0, e, 0.0), footprint),
                      height(p + vec3(0.0, 0.0, e), footprint)) - h) / e, h);
})"}};

// OCTAVES is a constant, as in a material where it is written down.
std::vector<std::uint32_t> words_of(const Kernel& kernel, int octaves) {
    const std::string text = fmt::format("#define OCTAVES {}\n", octaves) + R"(
#include "surfgrad/noise.glsl"
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Inputs { vec4 bench_in[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { vec4 bench_out[]; };
layout(set = 0, binding = 2, std140) uniform Control { uint bench_count; };
)" + kernel.glsl + R"(
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < bench_count) bench_out[i] = kernel(bench_in[i].xyz, bench_in[i].w);
}
)";
    proof::Compiled compiled = proof::compile_glsl(text);
    if (compiled.words.empty()) std::cerr << compiled.log;
    return compiled.words;
}

// Points with a footprint that shows every octave.
std::vector<float> random_points() {
    std::mt19937 engine(1);
    std::uniform_real_distribution<float> anywhere(-100.0f, 100.0f);
    std::vector<float> out(4 * kPoints);
    for (float& x : out) x = anywhere(engine);
    for (std::size_t i = 3; i < out.size(); i += 4) out[i] = 0.0f;
    return out;
}

using Times = std::array<double, kKernels.size()>;

// The least time in milliseconds of each kernel, measured in turn, so that a busy machine is busy for all.
std::optional<Times> lavapipe_times(runtime::gpu::Device& device, int octaves, Diags& diags) {
    std::vector<runtime::Compute> computes;
    for (const Kernel& kernel : kKernels) {
        auto compute = runtime::Compute::create(device, words_of(kernel, octaves), diags);
        if (!compute) return std::nullopt;
        computes.push_back(std::move(*compute));
    }
    const std::vector<float> inputs = random_points();
    std::vector<float> outputs(inputs.size());
    Times least;
    least.fill(1e30);
    for (int round = 0; round < kRounds; ++round) {
        for (std::size_t k = 0; k < computes.size(); ++k) {
            const auto begin = std::chrono::steady_clock::now();
            if (!computes[k].run(inputs, 4, outputs, 4, kPoints, diags)) return std::nullopt;
            const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
            least[k] = std::min(least[k], spent.count());
        }
    }
    return least;
}

int print_lavapipe() {
    Diags diags;
    auto device = runtime::gpu::Device::create({.name = "llvmpipe"}, diags);
    for (int octaves : {1, 4, 6}) {
        const auto times = device ? lavapipe_times(*device, octaves, diags) : std::nullopt;
        if (!times) {
            std::cerr << render(diags);
            return 1;
        }
        // What any kernel pays for buffers and submission is not the noise's.
        const double analytic = (*times)[1] - (*times)[0], differences = (*times)[2] - (*times)[0];
        fmt::print("lavapipe, {} octaves: analytic {:.1f} ms, four evaluations {:.1f} ms, {:.2f} times\n",
                   octaves, analytic, differences, differences / analytic);
    }
    return 0;
}

// Octaves are a loop, so that their number does not show here.
int print_gpu() {
    std::array<GpuStatistics, kKernels.size()> all;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto statistics = gpu_statistics(words_of(kKernels[k], 4));
        if (!statistics) {
            fmt::print("navi21: Mesa's RADV is not here; nothing counted\n");
            return 0;
        }
        all[k] = *statistics;
    }
    auto print = [&](const char* what, std::uint64_t GpuStatistics::*count) {
        const std::uint64_t analytic = all[1].*count - all[0].*count,
                            differences = all[2].*count - all[0].*count;
        fmt::print("navi21: analytic {} {}, four evaluations {}, {:.2f} times\n", analytic, what, differences,
                   static_cast<double>(differences) / static_cast<double>(analytic));
    };
    print("instructions", &GpuStatistics::instructions);
    print("cycles (estimated, one octave)", &GpuStatistics::inverse_throughput);
    return 0;
}

}  // namespace
}  // namespace sg::bench

int main(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "--gpu") return sg::bench::print_gpu();
    // The choice of drivers is made once per process: the GPU's numbers come from another.
    const std::string again = fmt::format("{} '{}' --gpu", sg::bench::kGpuEnvironment, argv[0]);
    const int counted = std::system(again.c_str());
    return sg::bench::print_lavapipe() + (counted == 0 ? 0 : 1);
}

// surfgrad-bench-compile: the stages of a warm compile of every sample, the forward fragment shader's where a
// stage works on a shader. Thread CPU time; compare minima and ratios, for the machine is shared.
#include <benchmark/benchmark.h>

#include "base/ice.hpp"
#include "json/json.hpp"
#include "opt/optimise.hpp"
#include "samples.hpp"
#include "stages.hpp"

namespace sg::bench {
namespace {

// A sample with the result of every stage.
struct Stages {
    SourcePtr source;
    material::Roots roots;
    RealFiles files;
    Diags diags;
    target::ShaderLibrary library = target::embedded_library();
    json::Document document;
    material::Material read;
    material::CheckedMaterial checked;
    ir::Module lowered, optimised;
    emit::MaterialInterface interface;
    emit::Shaders shaders;
    target::Words raw, words;
    std::string fault;

    explicit Stages(const std::filesystem::path& path)
        : source(source_of(path)), roots{{path.parent_path()}} {
        document = *json::parse(source, diags);
        read = material::read(document, diags);
        auto found = material::check(read, files, roots, diags);
        if (!found) SG_UNREACHABLE(render(diags));
        checked = std::move(*found);
        lowered = material::lower(checked);
        optimised = opt::optimise(lowered);
        interface = emit::material_interface(optimised, group_samplers(checked).group);
        emit();
        front_end();
        spirv_opt();
    }
    void emit() {
        const emit::EntryPoint& entry = *emit::find_entry_point("forward");
        shaders = emit::emit_glsl(opt::select_outputs(optimised, emit::needed_outputs(entry, optimised)),
                                  entry, interface);
    }
    void front_end() {
        auto made = target::front_end(shaders.fragment, "forward.frag", target::Stage::fragment, library,
                                      false, fault);
        if (!made) SG_UNREACHABLE(fault);
        raw = std::move(*made);
    }
    void spirv_opt() {
        auto made = target::run_optimizer(raw, target::Optimise::speed, fault);
        if (!made) SG_UNREACHABLE(fault);
        words = std::move(*made);
    }
};

struct Row {
    const char* name;
    void (*run)(Stages& stages);
};
constexpr Row kRows[] = {
    {"parse", [](Stages& s) { s.document = *json::parse(s.source, s.diags); }},
    {"read", [](Stages& s) { s.read = material::read(s.document, s.diags); }},
    {"check", [](Stages& s) { s.checked = *material::check(s.read, s.files, s.roots, s.diags); }},
    {"lower", [](Stages& s) { s.lowered = material::lower(s.checked); }},
    {"optimise", [](Stages& s) { s.optimised = opt::optimise(s.lowered); }},
    {"emit", [](Stages& s) { s.emit(); }},
    {"front end", [](Stages& s) { s.front_end(); }},
    {"spirv-opt", [](Stages& s) { s.spirv_opt(); }},
    {"spirv-val", [](Stages& s) { s.fault = target::validate(s.words); }},
};

}  // namespace
}  // namespace sg::bench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    std::vector<std::unique_ptr<sg::bench::Stages>> all;
    for (const auto& path : sg::bench::samples()) {
        all.push_back(std::make_unique<sg::bench::Stages>(path));
        sg::bench::Stages& stages = *all.back();
        for (const sg::bench::Row& row : sg::bench::kRows) {
            auto loop = [&stages, &row](benchmark::State& state) {
                for (auto _ : state) row.run(stages);
            };
            benchmark::RegisterBenchmark((path.stem().string() + "/" + row.name).c_str(), loop)
                ->Unit(benchmark::kMicrosecond)
                ->MinTime(0.05);
        }
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

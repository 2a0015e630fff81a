// surfgrad-bench-graph: whether the compiler's own stages take time linear in a material's nodes. Graphs with
// heavy sharing, of 1,000 to 30,000 nodes; printed is the processor time per node, the least of several runs.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <array>

#include "graphs.hpp"
#include "json/json.hpp"
#include "opt/optimise.hpp"
#include "stages.hpp"

namespace sg::bench {
namespace {

constexpr int kRounds = 3;
constexpr std::array<std::string_view, 7> kStages = {"parse",    "read", "check", "lower",
                                                     "optimise", "emit", "all"};
using Times = std::array<double, kStages.size()>;  // seconds

double now() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Run {
    Times times{};
    std::size_t values = 0, text = 0;  // of the optimised IR; bytes of the fragment shader
};
Run run_once(const SourcePtr& source) {
    MemoryFiles files;
    Diags diags;
    Run out;
    double begin = now(), last = begin;
    std::size_t stage = 0;
    auto lap = [&] {
        double t = now();
        out.times[stage++] = t - last;
        last = t;
    };
    auto document = json::parse(source, diags);
    lap();
    material::Material read = material::read(*document, diags);
    lap();
    auto checked = material::check(read, files, {{"/m"}}, diags);
    if (!checked) fmt::print(stderr, "{}", render(diags));
    lap();
    ir::Module lowered = material::lower(*checked);
    lap();
    ir::Module optimised = opt::optimise(lowered);
    lap();
    const emit::EntryPoint& entry = *emit::find_entry_point("forward");
    emit::MaterialInterface interface = emit::material_interface(optimised, {});
    emit::Shaders shaders = emit::emit_glsl(
        opt::select_outputs(optimised, emit::needed_outputs(entry, optimised)), entry, interface);
    lap();
    out.times[stage] = last - begin;
    out.values = optimised.values.size();
    out.text = shaders.fragment.size();
    return out;
}

void curve(const char* title, std::string (*make)(std::size_t)) {
    fmt::print("{}\n{:>8}", title, "nodes");
    for (std::string_view stage : kStages) fmt::print(" {:>9}", stage);
    fmt::print(" {:>9} {:>12}   (microseconds per node)\n", "values", "text/node");
    for (std::size_t count : {1000u, 3000u, 10000u, 30000u}) {
        auto source = std::make_shared<Source>(Source{"graph.json", make(count)});
        Run best = run_once(source);
        for (int round = 1; round < kRounds; ++round) {
            Run again = run_once(source);
            for (std::size_t k = 0; k < kStages.size(); ++k)
                best.times[k] = std::min(best.times[k], again.times[k]);
        }
        fmt::print("{:>8}", count);
        for (double t : best.times) fmt::print(" {:>9.3f}", 1e6 * t / static_cast<double>(count));
        fmt::print(" {:>9} {:>12.1f}\n", best.values,
                   static_cast<double>(best.text) / static_cast<double>(count));
    }
}

}  // namespace
}  // namespace sg::bench

int main() {
    sg::bench::curve("Each node refers to the two before it:", sg::bench::shared_graph);
    sg::bench::curve("Nodes without names, written in place, 50 deep:", sg::bench::nameless_graph);
}

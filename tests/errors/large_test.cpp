// Graphs that no one writes by hand: deep, and with so much sharing that their tree would be exponential.
#include <gtest/gtest.h>

#include "emit/glsl.hpp"
#include "opt/optimise.hpp"
#include "stages.hpp"
#include "tests/bench/graphs.hpp"

namespace sg {
namespace {

constexpr std::size_t kNodes = 20000;

std::string fragment_of(std::string text) {
    MemoryFiles files;
    Diags diags;
    auto checked = read_and_check(std::make_shared<Source>(Source{"graph.json", std::move(text)}), {{"/m"}},
                                  files, diags);
    EXPECT_TRUE(checked) << render(diags);
    if (!checked) return "";
    const emit::EntryPoint& entry = *emit::find_entry_point("forward");
    ir::Module module = opt::optimise(material::lower(*checked));
    EXPECT_GE(module.values.size(), kNodes);
    return emit::emit_glsl(opt::select_outputs(module, emit::needed_outputs(entry, module)), entry,
                           emit::material_interface(module, {}))
        .fragment;
}

TEST(LargeGraphs, DeepAndShared) {
    EXPECT_LT(fragment_of(bench::shared_graph(kNodes)).size(), 60 * kNodes);
}

TEST(LargeGraphs, WithoutNames) {
    EXPECT_LT(fragment_of(bench::nameless_graph(kNodes)).size(), 60 * kNodes);
}

}  // namespace
}  // namespace sg

// What the optimiser may not change: random modules mean the same before and after, with all rules and
// without each in turn. The same comparison notices rewrites that are wrong.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "ir/text.hpp"
#include "opt/optimise.hpp"
#include "tests/oracle/memory_texture.hpp"
#include "tests/oracle/module_mutants.hpp"
#include "tests/oracle/random_module.hpp"

namespace sg::oracle {
namespace {

using ir::Module;
using ir::Op;
using ir::Type;
using ir::ValueId;

// A random module with what it reads, and what it means at a few pixels.
struct Subject {
    RandomModule made;
    std::vector<ref::MemoryTexture> textures;
    std::vector<ir::PixelInputs> pixels;
    std::vector<ir::Bindings> bindings;  // one
};

Subject make_subject(std::uint64_t index) {
    std::seed_seq sequence{run_seed(), run_seed() >> 32U, index};
    std::mt19937_64 random(sequence);
    Subject out{random_module(random), {}, {}, {}};
    out.textures = {random_texture(random, {8, 4}), random_texture(random, {5, 7})};
    for (int i = 0; i < 3; ++i) out.pixels.push_back(random_pixel(random));
    return out;
}

ir::Bindings bindings_of(const Subject& subject) {
    return {{{.texels = &subject.textures[0]},
             {.texels = &subject.textures[1], .wrap_s = ir::Sampled::Wrap::mirror}},
            subject.made.parameters};
}

// The largest component of any derivative or gradient: sums of terms of this size carry its rounding, however
// small the sum. Never below 1, the size of a normal.
double largest_term(const Module& module, const std::vector<ir::Datum>& values) {
    double largest = 1.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Type type = module.values[i].type;
        if (type != Type::Deriv && type != Type::SurfGrad && type != Type::VolGrad) continue;
        for (double x : ir::components(values[i])) largest = std::max(largest, std::abs(x));
    }
    return largest;
}

// Whether a step is so sharp that rounding decides on which side of it a value lies.
bool jumps(const Module& module, const std::vector<ir::Datum>& values) {
    auto number = [&](ir::ValueId id) { return std::get<double>(values[id.index]); };
    return std::any_of(module.values.begin(), module.values.end(), [&](const ir::Value& v) {
        return v.op == Op::smoothstep && std::abs(number(v.operands[0]) - number(v.operands[1])) < 1e-6;
    });
}

// The largest difference of any output that `after` still has, in units of the largest term; infinite where
// one of the two is not a number.
double difference(const Subject& subject, const Module& before, const Module& after) {
    ir::Evaluator first(before, bindings_of(subject)), second(after, bindings_of(subject));
    double worst = 0.0;
    for (const ir::PixelInputs& pixel : subject.pixels) {
        const std::vector<ir::Datum>& values = first.run(pixel);
        if (jumps(before, values)) continue;
        const double scale = largest_term(before, values);
        second.run(pixel);
        for (const ir::OutputBinding& output : after.outputs) {
            const std::vector<double> a = ir::components(first.output(output.output, output.set));
            const std::vector<double> b = ir::components(second.output(output.output, output.set));
            for (std::size_t i = 0; i < a.size(); ++i) {
                const double size = std::max(scale, std::abs(a[i])), apart = std::abs(a[i] - b[i]) / size;
                worst = std::isfinite(apart) ? std::max(worst, apart) : INFINITY;
            }
        }
    }
    return worst;
}

constexpr double kEqual = 1e-12;
constexpr std::uint64_t kModules = 5000;

TEST(OptimiserMeaning, RandomModulesVerify) {
    std::map<Op, std::size_t> seen;
    for (std::uint64_t i = 0; i < 100; ++i) {
        const Module module = make_subject(i).made.module;
        ASSERT_EQ(ir::verify(module), "") << ir::print(module);
        for (const ir::Value& value : module.values) ++seen[value.op];
    }
    for (const ir::OpInfo& op : ir::all_ops()) EXPECT_GT(seen[op.op], 0u) << op.name << " is never generated";
}

TEST(OptimiserMeaning, StaysWithAllRulesAndWithoutEach) {
    double worst = 0.0;
    std::map<std::string_view, std::size_t> fired;
    for (std::uint64_t i = 0; i < kModules; ++i) {
        const Subject subject = make_subject(i);
        const Module& before = subject.made.module;
        const Module all = opt::optimise(before);
        const std::string all_text = ir::print(all);
        auto check = [&](const Module& after, std::string_view skipped) {
            const double apart = difference(subject, before, after);
            worst = std::max(worst, apart);
            ASSERT_LE(apart, kEqual) << "module " << i << " without rule '" << skipped
                                     << "', SG_SEED=" << run_seed() << "\n"
                                     << ir::print(before) << "\nbecomes\n"
                                     << ir::print(after);
        };
        ASSERT_NO_FATAL_FAILURE(check(all, ""));
        for (const opt::Rule& rule : opt::all_rules()) {
            const Module without = opt::optimise(before, rule.name);
            ASSERT_NO_FATAL_FAILURE(check(without, rule.name));
            if (ir::print(without) != all_text) ++fired[rule.name];
        }
    }
    fmt::print("{} modules, largest difference {:.1e} (allowed {:.1e})\n", kModules, worst, kEqual);
    for (const opt::Rule& rule : opt::all_rules()) {
        fmt::print("  {:32} changed {} modules\n", rule.name, fired[rule.name]);
        EXPECT_GE(fired[rule.name], 3u) << rule.name << " is hardly tried";
    }
}

// ---- wrong rewrites ----

TEST(OptimiserMeaning, WrongRewritesAreNoticed) {
    std::map<std::string_view, std::array<std::size_t, 2>> counts;  // applied, noticed
    for (std::uint64_t i = 0; i < 3 * kModules; ++i) {
        const Subject subject = make_subject(i);
        const Module good = opt::optimise(subject.made.module);
        for (const ModuleMutant& mutant : all_module_mutants()) {
            Module wrong = good;
            if (!apply_last(mutant, wrong)) continue;
            ASSERT_EQ(ir::verify(wrong), "") << mutant.name;
            auto& [times, noticed] = counts[mutant.name];
            ++times;
            if (difference(subject, subject.made.module, wrong) > kEqual) ++noticed;
        }
    }
    // Not every change means something: a parameter may be 1, a gradient that is scaled may be zero, so may a
    // factor behind it. That many modules notice is enough.
    for (const ModuleMutant& mutant : all_module_mutants()) {
        const auto [times, noticed] = counts[mutant.name];
        fmt::print("  {:44} noticed in {} of {} modules\n", mutant.name, noticed, times);
        EXPECT_GE(noticed, 50u) << mutant.name;
    }
}

}  // namespace
}  // namespace sg::oracle

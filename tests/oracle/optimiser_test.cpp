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
    const glm::ivec2 sizes[] = {{8, 4}, {5, 7}};
    for (const ir::Texture& texture : out.made.module.textures)
        out.textures.push_back(random_texture(random, sizes[out.textures.size() % 2], texture.encoding));
    for (int i = 0; i < 3; ++i) out.pixels.push_back(random_pixel(random));
    return out;
}

ir::Bindings bindings_of(const Subject& subject) {
    constexpr ir::Sampled::Wrap kWraps[] = {ir::Sampled::Wrap::repeat, ir::Sampled::Wrap::mirror};
    ir::Bindings out{{}, subject.made.parameters};
    for (const ref::MemoryTexture& texels : subject.textures)
        out.textures.push_back({.texels = &texels, .wrap_s = kWraps[out.textures.size() % 2]});
    return out;
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

// Whether rounding may decide how many steps a march has, or at which it ends.
bool near_next_step(const Module& module, const std::vector<ir::Datum>& values, const ir::Value& v) {
    constexpr double kNear = 1e-9;
    const ValueId count = v.operands.back();
    const double steps = std::get<double>(values[count.index]);
    const Op op = module.at(count).op;
    const bool exact = op == Op::constant || op == Op::parameter;
    if (!exact && std::abs(steps - std::round(steps)) < kNear) return true;
    const auto* march = std::get_if<ref::March>(&values[static_cast<std::size_t>(&v - module.values.data())]);
    return march && march->closest < kNear;
}

// Whether a rebuilt frame is seen at less than about 3 degrees: the reference's differences over a part of a
// pixel (a hundredth of the distance, random_pixel) lose digits with the square of what the pixel covers.
bool edge_on(const ref::Frame& frame) {
    const double pixel = 0.01 * glm::length(frame.position);
    return std::max(glm::length(frame.dpdx), glm::length(frame.dpdy)) > 20 * pixel;
}

// Whether a step is so sharp that it makes rounding large, or lets it decide on which side of the step a
// value lies: narrower than a thousandth of what steps over it.
bool jumps(const Module& module, const std::vector<ir::Datum>& values) {
    constexpr double kNarrow = 1e-3;
    auto number = [&](const ir::Value& v, std::size_t i) {
        return std::get<double>(values[v.operands[i].index]);
    };
    return std::any_of(module.values.begin(), module.values.end(), [&](const ir::Value& v) {
        switch (v.op) {
            case Op::smoothstep:
                return std::abs(number(v, 1) - number(v, 0)) <
                       kNarrow * std::max(1.0, std::abs(number(v, 2)));
            case Op::parallax_steps:
            case Op::parallax_occlusion:
                return near_next_step(module, values, v);
            case Op::frame_rebuilt:
                return edge_on(
                    std::get<ref::Frame>(values[static_cast<std::size_t>(&v - module.values.data())]));
            case Op::decal_angle_fade:
                return std::abs(number(v, 2) - number(v, 3)) < kNarrow;
            case Op::decal_falloff_box:
            case Op::decal_falloff_cone:
            case Op::decal_falloff_sphere:
            case Op::decal_falloff_capsule:
            case Op::decal_falloff_wedge:
                return number(v, v.operands.size() - 1) < kNarrow;
            default:
                return false;
        }
    });
}

// The pixel with its inputs about 45 roundings off, to one side or the other.
ir::PixelInputs nudged(const ir::PixelInputs& pixel, std::uint32_t variant) {
    std::minstd_rand random(variant + 1);
    ir::PixelInputs out = pixel;
    auto nudge = [&](auto& vector, int components) {
        for (int i = 0; i < components; ++i) vector[i] *= random() % 2 == 0 ? 1 + 1e-14 : 1 - 1e-14;
    };
    nudge(out.position, 3);
    nudge(out.vertex_normal, 3);
    nudge(out.vertex_tangent, 3);
    for (ref::Uv& uv : out.uvs) {
        for (ref::dvec2* part : {&uv.st, &uv.dx, &uv.dy}) nudge(*part, 2);
    }
    nudge(out.dpdx, 3);
    nudge(out.dpdy, 3);
    nudge(out.vertex_color, 4);
    nudge(out.dndx, 3);
    nudge(out.dndy, 3);
    nudge(out.object_origin, 3);
    nudge(out.camera.position, 3);
    for (int column = 0; column < 4; ++column) nudge(out.camera.relative_from_screen[column], 4);
    for (ir::Volume* volume : {&out.object, &out.world}) {
        for (ref::dvec3* part : {&volume->p, &volume->dx, &volume->dy}) nudge(*part, 3);
    }
    return out;
}

constexpr double kEqual = 1e-12;

using Components = std::vector<std::vector<double>>;  // of each output of a module
Components outputs_of(ir::Evaluator& evaluator, const Module& outputs, const ir::PixelInputs& pixel) {
    evaluator.run(pixel);
    Components out;
    for (const ir::OutputBinding& o : outputs.outputs)
        out.push_back(ir::components(evaluator.output(o.output, o.set)));
    return out;
}

// The largest difference of any component beyond what it moves by `moved`, in units of its size; infinite
// where something is not a number.
double excess(const Components& a, const Components& b, const Components& moved, double scale) {
    double worst = 0.0;
    for (std::size_t o = 0; o < a.size(); ++o) {
        for (std::size_t i = 0; i < a[o].size(); ++i) {
            const double beyond = std::abs(a[o][i] - b[o][i]) - std::abs(a[o][i] - moved[o][i]);
            worst = std::isfinite(beyond) ? std::max(worst, beyond / std::max(scale, std::abs(a[o][i])))
                                          : INFINITY;
        }
    }
    return worst;
}

// How far apart two modules are in any output that `after` still has. Of an ill-conditioned value, rounding
// may change as much as it changes with its inputs: what a nudge of these does as well is not counted.
double difference(const Subject& subject, const Module& before, const Module& after) {
    constexpr std::uint32_t kNudges = 24;
    ir::Evaluator first(before, bindings_of(subject)), second(after, bindings_of(subject));
    double worst = 0.0;
    for (const ir::PixelInputs& pixel : subject.pixels) {
        const std::vector<ir::Datum>& values = first.run(pixel);
        if (jumps(before, values)) continue;
        const double scale = largest_term(before, values);
        const Components a = outputs_of(first, after, pixel), b = outputs_of(second, after, pixel);
        double apart = excess(a, b, a, scale);
        for (std::uint32_t i = 0; i < kNudges && !(apart <= kEqual); ++i) {
            apart = std::min(apart, excess(a, b, outputs_of(first, after, nudged(pixel, i)), scale));
        }
        worst = std::max(worst, apart);
    }
    return worst;
}

constexpr std::uint64_t kModules = 5000;

TEST(OptimiserMeaning, RandomModulesVerify) {
    std::map<Op, std::size_t> seen;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const Module module = make_subject(i).made.module;
        ASSERT_EQ(ir::verify(module), "") << ir::print(module);
        for (const ir::Value& value : module.values) ++seen[value.op];
    }
    for (const ir::OpInfo& op : ir::all_ops()) {
        if (op.attribute == ir::Attribute::Function) continue;  // they have no reference
        EXPECT_GT(seen[op.op], 0u) << op.name << " is never generated";
    }
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

// What an output that is left needed is gone because of a rule, and that rule was applied where the log says.
TEST(OptimiserMeaning, EveryLossHasItsRule) {
    std::size_t losses = 0;
    for (std::uint64_t i = 0; i < 500; ++i) {
        const Module before = make_subject(i).made.module;
        opt::Log log;
        const Module after = opt::optimise(before, "", &log);
        std::vector<bool> needed(before.values.size());
        for (const ir::OutputBinding& o : before.outputs) {
            for (const ir::OutputBinding& left : after.outputs)
                if (o.output == left.output && o.set == left.set) needed[o.value.index] = true;
        }
        for (std::size_t v = before.values.size(); v-- > 0;) {
            if (!needed[v]) continue;
            for (ValueId operand : before.values[v].operands) needed[operand.index] = true;
        }
        for (std::size_t v = 0; v < before.values.size(); ++v) {
            if (log.after[v].valid()) continue;
            const opt::Loss& loss = log.losses[v];
            EXPECT_TRUE(!needed[v] || !loss.rule.empty()) << "%" << v << "\n" << ir::print(before);
            if (loss.rule.empty()) continue;
            ++losses;
            EXPECT_TRUE(std::any_of(
                log.uses.begin(), log.uses.end(),
                [&](const opt::RuleUse& use) { return use.rule == loss.rule && use.before == loss.before; }))
                << loss.rule << " of %" << loss.before.index << ", SG_SEED=" << run_seed();
        }
    }
    EXPECT_GT(losses, 500u);
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

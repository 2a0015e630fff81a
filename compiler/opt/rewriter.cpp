#include <algorithm>
#include <bit>
#include <utility>

#include "base/ice.hpp"
#include "opt/interval.hpp"
#include "opt/optimise.hpp"

namespace sg::opt {

using ir::Op;
using ir::Value;
using ir::ValueId;

namespace {

bool equal(const Value& a, const Value& b) {
    return a.op == b.op && a.type == b.type && a.operands == b.operands && a.index == b.index &&
           a.number == b.number;
}

}  // namespace

Rewriter::Rewriter(const ir::Module& declarations, std::string_view skipped, Log* log)
    : skipped_(skipped), log_(log), buckets_(64) {
    module_.name = declarations.name;
    module_.lighting = declarations.lighting;
    module_.textures = declarations.textures;
    module_.parameters = declarations.parameters;
    module_.host = declarations.host;
    module_.derived = declarations.derived;
    module_.shaders = declarations.shaders;
    module_.functions = declarations.functions;
    module_.layers = declarations.layers;
}

const Value* Rewriter::operand(const Value& value, std::size_t index, Op op) const {
    const Value& found = module_.at(value.operands[index]);
    return found.op == op ? &found : nullptr;
}

std::size_t Rewriter::hash(const Value& value) const {
    std::uint64_t h = static_cast<std::uint64_t>(value.op) * 0x9E3779B97F4A7C15u + value.index;
    auto mix = [&h](std::uint64_t x) { h = (h ^ x) * 0xFF51AFD7ED558CCDu + (h >> 29u); };
    for (ValueId id : value.operands) mix(id.index);
    for (double n : value.number) mix(std::bit_cast<std::uint64_t>(n));
    return h ^ (h >> 32u);
}

void Rewriter::grow() {
    std::vector<std::vector<std::uint32_t>> bigger(buckets_.size() * 2);
    for (const auto& bucket : buckets_) {
        for (std::uint32_t i : bucket) bigger[hash(module_.values[i]) % bigger.size()].push_back(i);
    }
    buckets_ = std::move(bigger);
}

bool Rewriter::finds_endless(const Value& value) const {
    if (ir::info(value.op).attribute == ir::Attribute::Function) return true;
    if (value.type == ir::Type::Normal) return false;  // a resolve guards it
    if (value.op == Op::power && !(interval_of(*this, value.operands[1]).least >= 0)) return true;
    return std::any_of(value.operands.begin(), value.operands.end(),
                       [&](ValueId operand) { return endless_[operand.index]; });
}

// Notes the rule in front of those that it led to.
ValueId Rewriter::apply(const Rule& rule, const Value& value) {
    if (!log_) return rule.apply(*this, value);
    const ValueId before{static_cast<std::uint32_t>(log_->after.size())};
    const std::size_t at = log_->uses.size(), removal = removals_.size();
    removals_.push_back({{rule.name, before}, value.operands});
    const std::string_view outer = std::exchange(maker_, rule.name);
    const ValueId better = rule.apply(*this, value);
    maker_ = outer;
    if (better.valid()) {
        log_->uses.insert(log_->uses.begin() + static_cast<std::ptrdiff_t>(at),
                          {rule.name, value.op, before});
    } else {
        removals_.resize(removal);
    }
    return better;
}

ValueId Rewriter::add(Value value) {
    for (const Rule& rule : all_rules()) {
        if (rule.name == skipped_ || std::find(rule.ops.begin(), rule.ops.end(), value.op) == rule.ops.end())
            continue;
        if (ValueId better = apply(rule, value); better.valid()) return better;
    }
    if (module_.values.size() > buckets_.size()) grow();
    std::vector<std::uint32_t>& bucket = buckets_[hash(value) % buckets_.size()];
    for (std::uint32_t i : bucket) {
        if (equal(module_.values[i], value)) return {i};
    }
    auto index = static_cast<std::uint32_t>(module_.values.size());
    bucket.push_back(index);
    if (log_) log_->origins.push_back({{static_cast<std::uint32_t>(log_->after.size())}, maker_});
    endless_.push_back(finds_endless(value));
    module_.values.push_back(std::move(value));
    return {index};
}

ValueId Rewriter::add(Op op, std::vector<ValueId> operands, const Value& like) {
    return add(Value{.op = op,
                     .type = info(op).result,
                     .operands = std::move(operands),
                     .name = like.name,
                     .is_node = like.is_node,
                     .layer = like.layer});
}

namespace {

// Drops values that no output needs and closes the gaps. `renamed`: the new id of every value, invalid if
// dropped.
ir::Module compact(ir::Module module, std::vector<ValueId>& renamed) {
    std::vector<bool> live(module.values.size(), false);
    for (const ir::OutputBinding& output : module.outputs) live[output.value.index] = true;
    for (std::size_t i = module.values.size(); i-- > 0;) {
        if (!live[i]) continue;
        for (ValueId operand : module.values[i].operands) live[operand.index] = true;
    }
    renamed.assign(module.values.size(), {});
    std::vector<Value> kept;
    for (std::size_t i = 0; i < module.values.size(); ++i) {
        if (!live[i]) continue;
        Value value = std::move(module.values[i]);
        for (ValueId& operand : value.operands) operand = renamed[operand.index];
        renamed[i] = {static_cast<std::uint32_t>(kept.size())};
        kept.push_back(std::move(value));
    }
    for (ir::OutputBinding& output : module.outputs) output.value = renamed[output.value.index];
    module.values = std::move(kept);
    return module;
}

ir::Module compact(ir::Module module) {
    std::vector<ValueId> renamed;
    return compact(std::move(module), renamed);
}

// What a value asks the outside for: an input, a texel, a noise, a function of the user. Of its texture,
// surfgrad_from_height asks the size alone.
bool is_source(const ir::Module& module, const Value& value) {
    const bool input = value.operands.empty() && value.op != Op::constant && value.op != Op::zero_surfgrad;
    const bool reads = value.op != Op::surfgrad_from_height && !ir::textures_of(module, value).empty();
    return input || reads || value.type == ir::Type::Noise ||
           ir::info(value.op).attribute == ir::Attribute::Function;
}

// A layer by itself is shown as long as it bumps and some normal needs it: so the debug entry asks for no
// more than the others.
void drop_dead_layers(ir::Module& module) {
    auto is_layer = [](const ir::OutputBinding& o) { return o.output == ir::Output::layer; };
    ir::Module without = module;
    std::erase_if(without.outputs, is_layer);
    std::vector<ValueId> needed;
    compact(std::move(without), needed);
    std::vector<bool> asks(module.values.size(), false);  // for more than the others
    for (std::size_t i = 0; i < module.values.size(); ++i) {
        const Value& value = module.values[i];
        asks[i] = !needed[i].valid() && is_source(module, value);
        for (ValueId operand : value.operands) asks[i] = asks[i] || asks[operand.index];
    }
    std::erase_if(module.outputs, [&](const ir::OutputBinding& o) {
        return is_layer(o) && (asks[o.value.index] || module.at(o.value).op == Op::zero_surfgrad);
    });
}

// Notes of values that are dropped which removal took their last use away: their own, or that of what they
// were needed for.
void note_losses(Log& log, const ir::Module& module, const std::vector<Removal>& removals,
                 const std::vector<ValueId>& renamed) {
    std::vector<std::size_t> last(module.values.size(), 0);  // by value: from 1; 0 for none
    for (std::size_t r = 0; r < removals.size(); ++r) {
        for (ValueId operand : removals[r].operands) last[operand.index] = r + 1;
    }
    for (std::size_t i = module.values.size(); i-- > 0;) {
        if (renamed[i].valid()) continue;
        for (ValueId operand : module.values[i].operands)
            last[operand.index] = std::max(last[operand.index], last[i]);
    }
    log.losses.resize(log.after.size());
    for (std::size_t i = 0; i < log.after.size(); ++i) {
        const ValueId after = log.after[i];
        if (after.valid() && !renamed[after.index].valid() && last[after.index] > 0)
            log.losses[i] = removals[last[after.index] - 1].why;
    }
}

// What a rule on the whole module took away: the operands of the values that it changed.
std::vector<Removal> removals_by(const Rule& rule, const ir::Module& before, const ir::Module& after,
                                 const Log& log) {
    SG_ASSERT(before.values.size() == after.values.size());
    std::vector<Removal> out;
    for (std::size_t i = 0; i < before.values.size(); ++i) {
        if (before.values[i].operands != after.values[i].operands)
            out.push_back({{rule.name, log.origins[i].before}, before.values[i].operands});
    }
    return out;
}

// The log speaks of the rewritten module until here.
void rename(Log& log, const std::vector<ValueId>& renamed) {
    for (ValueId& after : log.after) after = after.valid() ? renamed[after.index] : after;
    std::vector<Origin> kept;
    for (std::size_t i = 0; i < renamed.size(); ++i) {
        if (renamed[i].valid()) kept.push_back(log.origins[i]);
    }
    log.origins = std::move(kept);
}

}  // namespace

ir::Module optimise(const ir::Module& module, std::string_view skipped_rule, Log* log) {
    if (log) *log = {};
    Rewriter rewriter(module, skipped_rule, log);
    std::vector<ValueId> renamed;
    for (Value value : module.values) {
        for (ValueId& operand : value.operands) operand = renamed[operand.index];
        renamed.push_back(rewriter.add(std::move(value)));
        if (log) log->after.push_back(renamed.back());
    }
    ir::Module out = rewriter.take();
    out.outputs = module.outputs;
    for (ir::OutputBinding& output : out.outputs) output.value = renamed[output.value.index];
    drop_dead_layers(out);
    // What the vertex stage hands over is worth showing only while some layer needs them.
    auto only_shown = [&](const ir::OutputBinding& o) {
        return is_interpolated(o.output) || o.output == ir::Output::basis_vertex ||
               o.output == ir::Output::vertex_color || o.output == ir::Output::normal_derivatives;
    };
    ir::Module needed = out;
    std::erase_if(needed.outputs, only_shown);
    needed = compact(std::move(needed));
    auto used = [&](const ir::OutputBinding& o) {
        const Value& shown = out.at(o.value);
        return std::any_of(needed.values.begin(), needed.values.end(), [&](const Value& value) {
            return value.op == shown.op && value.index == shown.index;
        });
    };
    std::erase_if(out.outputs, [&](const ir::OutputBinding& o) { return only_shown(o) && !used(o); });
    auto drop_unneeded = [&](const ir::Module& before, const std::vector<Removal>& removals) {
        out = compact(std::move(out), renamed);
        if (!log) return;
        note_losses(*log, before, removals, renamed);
        rename(*log, renamed);
    };
    drop_unneeded(log ? out : ir::Module{}, rewriter.removals());
    for (const Rule& rule : all_rules()) {
        if (!rule.whole || rule.name == skipped_rule) continue;
        const ir::Module before = log ? out : ir::Module{};
        out = rule.whole(std::move(out), rule, log);
        drop_unneeded(before, log ? removals_by(rule, before, out, *log) : std::vector<Removal>{});
    }
    std::string faults = ir::verify(out);
    if (!faults.empty()) SG_UNREACHABLE("optimising made a bad module:\n" + faults);
    return out;
}

ir::Module select_outputs(const ir::Module& module, std::span<const ir::Output> outputs) {
    ir::Module out = module;
    std::erase_if(out.outputs, [&](const ir::OutputBinding& o) {
        for (ir::Output wanted : outputs) {
            if (o.output == wanted) return false;
        }
        return true;
    });
    return compact(std::move(out));
}

}  // namespace sg::opt

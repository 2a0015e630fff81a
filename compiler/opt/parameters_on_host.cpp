// Expressions of parameters alone become derived parameters: the host computes them once.
#include <algorithm>

#include "base/limits.hpp"
#include "ir/host.hpp"
#include "opt/optimise.hpp"

namespace sg::opt {
namespace {

using ir::Op;
using ir::Value;
using ir::ValueId;

bool is_number_of_the_engine(const Value& value) {
    return value.op == Op::parameter || value.op == Op::derived;
}

// What is known of each value of a module, by its index.
struct Facts {
    std::vector<bool> on_host;  // the host could compute it
    std::vector<bool> varies;   // it depends on a parameter
    std::vector<bool> root;     // the host shall compute it, and the shader needs it
};

Facts facts_of(const ir::Module& module) {
    const std::size_t count = module.values.size();
    Facts out{std::vector<bool>(count), std::vector<bool>(count), std::vector<bool>(count)};
    for (std::size_t i = 0; i < count; ++i) {
        const Value& value = module.values[i];
        out.varies[i] = is_number_of_the_engine(value);
        out.on_host[i] = value.op == Op::constant || out.varies[i] || ir::host_op(value.op) != nullptr;
        for (ValueId operand : value.operands) {
            out.on_host[i] = out.on_host[i] && out.on_host[operand.index];
            out.varies[i] = out.varies[i] || out.varies[operand.index];
        }
    }
    // From the last to the first: what the shader still computes needs its operands.
    std::vector<bool> needed(count);
    for (const ir::OutputBinding& output : module.outputs) needed[output.value.index] = true;
    for (std::size_t i = count; i-- > 0;) {
        if (!needed[i]) continue;
        const ir::HostOp* host = ir::host_op(module.values[i].op);
        out.root[i] = out.on_host[i] && out.varies[i] && host && host->costs;
        if (out.root[i]) continue;
        for (ValueId operand : module.values[i].operands) needed[operand.index] = true;
    }
    // Those that find no room stay in the shader, with all that they stand on.
    std::size_t room = kMaxDerived - std::min<std::size_t>(kMaxDerived, module.derived.size());
    for (std::size_t i = 0; i < count; ++i) {
        if (out.root[i] && room == 0) out.root[i] = false;
        if (out.root[i]) --room;
    }
    return out;
}

// Copies the roots and what they stand on to Module::host, each value once.
void copy_to_host(ir::Module& module, const Facts& facts) {
    std::vector<bool> wanted = facts.root;
    for (std::size_t i = module.values.size(); i-- > 0;) {
        if (!wanted[i]) continue;
        for (ValueId operand : module.values[i].operands) wanted[operand.index] = true;
    }
    std::vector<ValueId> place(module.values.size());
    for (std::size_t i = 0; i < module.values.size(); ++i) {
        if (!wanted[i]) continue;
        Value value = module.values[i];
        if (value.op == Op::derived) {
            place[i] = module.derived[value.index].host;
            continue;
        }
        for (ValueId& operand : value.operands) operand = place[operand.index];
        place[i] = {static_cast<std::uint32_t>(module.host.size())};
        if (facts.root[i]) {
            const std::string in = value.layer.valid() ? module.layers[value.layer.index].id + "_" : "";
            const std::string_view hint = value.name.empty() ? ir::info(value.op).name : value.name;
            module.derived.push_back({in + std::string(hint), value.type, place[i]});
        }
        value.layer = {};
        module.host.push_back(std::move(value));
    }
}

void note(Log& log, const ir::Module& module, const Facts& facts, std::string_view rule) {
    for (std::size_t i = 0; i < module.values.size(); ++i) {
        if (!facts.root[i]) continue;
        log.uses.push_back({rule, module.values[i].op, log.origins[i].before});
        log.origins[i].rule = rule;
    }
    std::stable_sort(log.uses.begin(), log.uses.end(),
                     [](const RuleUse& a, const RuleUse& b) { return a.before.index < b.before.index; });
}

}  // namespace

namespace {

// Keeps those that the shader still reads, and what the host needs for them.
ir::Module drop_unread(ir::Module module) {
    std::vector<bool> read(module.derived.size()), wanted(module.host.size());
    for (const Value& value : module.values) {
        if (value.op == Op::derived) read[value.index] = true;
    }
    for (std::size_t i = 0; i < read.size(); ++i) {
        if (read[i]) wanted[module.derived[i].host.index] = true;
    }
    for (std::size_t i = module.host.size(); i-- > 0;) {
        if (!wanted[i]) continue;
        for (ValueId operand : module.host[i].operands) wanted[operand.index] = true;
    }
    std::vector<Value> host;
    std::vector<ValueId> place(module.host.size());
    for (std::size_t i = 0; i < module.host.size(); ++i) {
        if (!wanted[i]) continue;
        for (ValueId& operand : module.host[i].operands) operand = place[operand.index];
        place[i] = {static_cast<std::uint32_t>(host.size())};
        host.push_back(std::move(module.host[i]));
    }
    std::vector<ir::Derived> derived;
    std::vector<std::uint32_t> index(read.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        if (!read[i]) continue;
        index[i] = static_cast<std::uint32_t>(derived.size());
        module.derived[i].host = place[module.derived[i].host.index];
        derived.push_back(std::move(module.derived[i]));
    }
    for (Value& value : module.values) {
        if (value.op == Op::derived) value.index = index[value.index];
    }
    module.host = std::move(host);
    module.derived = std::move(derived);
    return module;
}

}  // namespace

ir::Module parameters_on_host(ir::Module module, const Rule& rule, Log* log) {
    const Facts facts = facts_of(module);
    auto first = static_cast<std::uint32_t>(module.derived.size());
    copy_to_host(module, facts);
    if (module.derived.size() == first) return drop_unread(std::move(module));
    if (log) note(*log, module, facts, rule.name);
    for (std::size_t i = 0; i < module.values.size(); ++i) {
        Value& value = module.values[i];
        if (facts.root[i])
            value = {.op = Op::derived,
                     .type = value.type,
                     .index = first++,
                     .name = value.name,
                     .layer = value.layer};
    }
    return drop_unread(std::move(module));
}

}  // namespace sg::opt

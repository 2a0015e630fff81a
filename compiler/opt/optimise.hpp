// The optimiser: named rules on the algebra of gradients, applied while the module is rebuilt once from first
// to last value, so that the cost is linear. Equal values become one; what no output needs is dropped at the
// end.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "ir/ir.hpp"

namespace sg::opt {

class Rewriter;
struct Log;

// A rule looks at one value whose operands are already rewritten. It gives the value to use instead, or an
// invalid id where it does not apply. What it gives must be equal for every input, up to rounding, while no
// volume gradient is longer than a projection lets pass (16384).
struct Rule {
    std::string_view name;
    std::string_view reason;
    std::vector<ir::Op> ops;  // the operations that it is tried on
    ir::ValueId (*apply)(Rewriter& rewriter, const ir::Value& value);
    // Instead of `apply`: looks at the whole module behind all other rules, when only what is needed is left.
    ir::Module (*whole)(ir::Module module, const Rule& rule, Log* log) = nullptr;
};
std::span<const Rule> all_rules();

// A rule that was applied: while the value `before` of the given module was rewritten, on an operation. Rules
// that were applied to what a rule made stand behind it.
struct RuleUse {
    std::string_view rule;
    ir::Op op{};
    ir::ValueId before;
};

// Where a value of the optimised module comes from.
struct Origin {
    ir::ValueId before;
    std::string_view rule;  // that made it; "" where it only was copied
};

// Why nothing needs a value any more: the rule that took its last use away, and the value of the given module
// on which that was applied. "": nothing needed it from the beginning.
struct Loss {
    std::string_view rule;
    ir::ValueId before;
};

// What became of what; for people.
struct Log {
    std::vector<RuleUse> uses;  // by `before`
    std::vector<ir::ValueId>
        after;  // by value of the given module: what stands for it; invalid where nothing needs it
    std::vector<Loss> losses;     // by value of the given module: of those that nothing stands for
    std::vector<Origin> origins;  // by value of the optimised module
};

// A rule was applied in place of a value with these operands, which lose this use.
struct Removal {
    Loss why;
    std::vector<ir::ValueId> operands;
};

class Rewriter {
public:
    // `skipped` names a rule that is left out, to measure what it is worth; "" for none. `log`: null for
    // none.
    Rewriter(const ir::Module& declarations, std::string_view skipped, Log* log = nullptr);
    // The id of this value in the new module: by a rule, an equal value, or a new one.
    ir::ValueId add(ir::Value value);
    ir::ValueId add(ir::Op op, std::vector<ir::ValueId> operands, const ir::Value& like);
    [[nodiscard]] const ir::Value& at(ir::ValueId id) const { return module_.at(id); }
    [[nodiscard]] const ir::Parameter& parameter(const ir::Value& value) const {
        return module_.parameters[value.index];
    }
    // What a value of Op::sample reads.
    [[nodiscard]] const ir::Texture& texture(const ir::Value& value) const {
        return module_.textures[value.index];
    }
    [[nodiscard]] const ir::Derived& derived(const ir::Value& value) const {
        return module_.derived[value.index];
    }
    // The operand's value if it is of this operation, else null.
    [[nodiscard]] const ir::Value* operand(const ir::Value& value, std::size_t index, ir::Op op) const;
    // Whether it may be endless or not a number while textures and parameters are numbers: of a user's
    // function, of a power that may be negative, and of what is computed of these up to a normal.
    [[nodiscard]] bool may_be_endless(ir::ValueId id) const { return endless_[id.index]; }
    ir::Module take() { return std::move(module_); }
    // In the order of time; with a log only.
    [[nodiscard]] const std::vector<Removal>& removals() const { return removals_; }

private:
    ir::Module module_;
    std::string_view skipped_;
    Log* log_;
    std::string_view maker_;  // the innermost rule at work
    std::vector<Removal> removals_;
    std::vector<std::vector<std::uint32_t>> buckets_;
    std::vector<bool> endless_;  // by value
    ir::ValueId apply(const Rule& rule, const ir::Value& value);
    [[nodiscard]] std::size_t hash(const ir::Value& value) const;
    [[nodiscard]] bool finds_endless(const ir::Value& value) const;
    void grow();
};

// All rules, merging of equal values, dropping of unused ones.
ir::Module optimise(const ir::Module& module, std::string_view skipped_rule = "", Log* log = nullptr);

// The rule of this name (parameters_on_host.cpp).
ir::Module parameters_on_host(ir::Module module, const Rule& rule, Log* log);

// The module with these outputs alone and only the values that they need.
ir::Module select_outputs(const ir::Module& module, std::span<const ir::Output> outputs);

}  // namespace sg::opt

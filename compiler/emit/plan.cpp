#include "emit/plan.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "emit/levels.hpp"

namespace sg::emit {
namespace {

using ir::Attribute;
using ir::Type;
using ir::Value;
using ir::ValueId;

// Values that are as short as a name: they are written out at each use.
bool is_trivial(const Value& value) {
    switch (value.op) {
        case ir::Op::position:
        case ir::Op::vertex_normal:
        case ir::Op::vertex_tangent:
        case ir::Op::constant:
        case ir::Op::parameter:
        case ir::Op::derived:
        case ir::Op::vertex_color:
        case ir::Op::splat:
        case ir::Op::color:
        case ir::Op::zero_surfgrad:
        case ir::Op::gradient_from_world:
        case ir::Op::direction_of:
        case ir::Op::swizzle:
        case ir::Op::channel_of:
        case ir::Op::rgb_of:
        case ir::Op::noise_value:
        case ir::Op::triplanar_axis:
        case ir::Op::planar_weights:
        case ir::Op::decal_uv:
        case ir::Op::hit_offset:
        case ir::Op::hit_height:
        case ir::Op::pair_first:
        case ir::Op::pair_second:
            return true;
        default:
            return false;
    }
}

// What a layer may give: a bump in one of its forms, or the normal that it was merged into.
bool is_bump(const Value& value) {
    const Type type = value.type;
    return type == Type::SurfGrad || type == Type::VolGrad || type == Type::LocalGrad ||
           type == Type::Deriv || type == Type::TangentNormal || value.op == ir::Op::resolve_towards;
}

// How often a row's text writes an operand.
std::uint32_t times_written(std::string_view glsl, std::size_t operand) {
    const char place[] = {'{', static_cast<char>('0' + operand), '}', 0};
    std::uint32_t times = 0;
    for (std::size_t at = glsl.find(place); at != std::string_view::npos; at = glsl.find(place, at + 1))
        ++times;
    return times;
}

class Planner {
public:
    Planner(const ir::Module& module, Wording (*wording)(ir::Op))
        : module_(module), wording_(wording), count_(module.values.size()) {}

    Plan run() {
        find_levels();
        find_early();
        find_results();
        count_uses();
        choose_locals();
        place_locals();
        return std::move(plan_);
    }

private:
    [[nodiscard]] std::uint32_t times(const Value& value, std::size_t operand) const {
        bool called = ir::info(value.op).attribute == Attribute::Function;
        return called ? 1 : times_written(wording_(value.op).glsl, operand);
    }

    // A function is called from anywhere: it knows no neighbouring pixels.
    void find_levels() {
        plan_.hardware_level.assign(count_, false);
        if (wording_ != stage_wording) return;
        const std::vector<bool> follows = follows_the_pixels(module_);
        for (std::size_t i = 0; i < count_; ++i) {
            const Value& value = module_.values[i];
            plan_.hardware_level[i] = value.op == ir::Op::sample && follows[value.operands[0].index];
        }
    }

    // Screen derivatives, the mesh's normal, and what they stand on.
    void find_early() {
        early_.assign(count_, false);
        for (std::size_t i = count_; i-- > 0;) {
            const Value& value = module_.values[i];
            const bool of_mesh =
                value.op == ir::Op::base_normal || (value.op == ir::Op::mirror_normal &&
                                                    module_.at(value.operands[0]).op == ir::Op::base_normal);
            if (of_mesh || ir::takes_screen_derivatives(value.op)) early_[i] = true;
            if (!early_[i]) continue;
            for (ValueId operand : module_.values[i].operands) early_[operand.index] = true;
        }
    }

    // The last bump that leaves a layer is what the layer gives.
    void find_results() {
        plan_.layer_result.assign(count_, false);
        std::vector<ValueId> last(module_.layers.size());
        auto leaves = [&](ValueId id) {
            while (is_trivial(module_.at(id)) && !module_.at(id).operands.empty() &&
                   module_.at(module_.at(id).operands[0]).layer == module_.at(id).layer)
                id = module_.at(id).operands[0];
            const Value& value = module_.at(id);
            if (!value.layer.valid() || is_trivial(value) || !is_bump(value)) return;
            ValueId& result = last[value.layer.index];
            if (!result.valid() || result.index < id.index) result = id;
        };
        for (const Value& value : module_.values) {
            for (ValueId operand : value.operands) {
                if (module_.at(operand).layer != value.layer) leaves(operand);
            }
        }
        for (const ir::OutputBinding& output : module_.outputs) leaves(output.value);
        for (ValueId result : last) {
            if (result.valid()) plan_.layer_result[result.index] = true;
        }
    }

    void count_uses() {
        uses_.assign(count_, 0);
        // What an alpha test compares is an output as well; a function leaves the test to its caller.
        bool tested_and_shown = wording_ == stage_wording && module_.output(ir::Output::cutoff).valid() &&
                                module_.output(ir::Output::base_color).valid();
        for (const ir::OutputBinding& output : module_.outputs) {
            bool taken_apart = output.output == ir::Output::frame || output.output == ir::Output::uv ||
                               output.output == ir::Output::volume ||
                               output.output == ir::Output::normal_derivatives ||
                               output.output == ir::Output::basis_vertex;
            if (output.output == ir::Output::opacity) taken_apart = tested_and_shown;
            uses_[output.value.index] += taken_apart ? 2 : 1;
        }
        // A trivial value is written out at each use, and its operands with it.
        for (std::size_t i = count_; i-- > 0;) {
            const Value& value = module_.values[i];
            std::uint32_t copies = is_trivial(value) ? std::min(uses_[i], 2u) : 1;
            for (std::size_t k = 0; k < value.operands.size(); ++k)
                uses_[value.operands[k].index] += copies * times(value, k);
        }
    }

    void choose_locals() {
        is_local_.assign(count_, false);
        // Parallax moves each pixel by itself, and an alpha test ends some of them: derivatives between
        // neighbours are taken before either, in a statement of their own. A function is handed them.
        std::vector<bool> apart(count_, false);
        const bool tests = module_.output(ir::Output::cutoff).valid();
        const bool looks = std::any_of(module_.values.begin(), module_.values.end(),
                                       [](const Value& v) { return ir::looks_along_ray(v.op); });
        if (wording_ == stage_wording && (tests || looks)) {
            for (std::size_t i = 0; i < count_; ++i)
                apart[i] = ir::takes_screen_derivatives(module_.values[i].op);
        }
        choose_locals(apart);
        if (!tests) return;
        const std::vector<bool> behind = behind_locals();
        for (std::size_t i = 0; i < count_; ++i)
            apart[i] = apart[i] || (plan_.hardware_level[i] && behind[i]);
        choose_locals(apart);
    }

    void choose_locals(const std::vector<bool>& apart) {
        std::vector<std::size_t> letters(count_);
        for (std::size_t i = 0; i < count_; ++i) {
            const Value& value = module_.values[i];
            letters[i] = wording_(value.op).glsl.size() + 8;
            for (std::size_t k = 0; k < value.operands.size(); ++k)
                letters[i] += times(value, k) * letters[value.operands[k].index];
            if (is_trivial(value)) continue;
            // A part of a local is as short as a name, but less telling than a node's.
            const bool part =
                wording_(value.op).glsl.starts_with("{0}.") && is_local_[value.operands[0].index];
            is_local_[i] = apart[i] || (uses_[i] > 1 && (!part || value.is_node)) || plan_.layer_result[i] ||
                           (value.is_node && !part) || letters[i] > kLongestExpression;
            if (is_local_[i]) letters[i] = 16;
        }
    }

    // What is written behind all locals, in the lines that use the outputs.
    [[nodiscard]] std::vector<bool> behind_locals() const {
        std::vector<bool> out(count_, false);
        for (const ir::OutputBinding& output : module_.outputs) out[output.value.index] = true;
        for (std::size_t i = count_; i-- > 0;) {
            if (!out[i] || is_local_[i]) continue;
            for (ValueId operand : module_.values[i].operands) out[operand.index] = true;
        }
        return out;
    }

    // A place is 2 b + 1 among the lines of the layer that comes b-th (from 1), 2 b in front of them.
    void place_locals() {
        const std::vector<std::size_t> block = blocks();
        const std::size_t behind_all = 2 * module_.layers.size() + 2;
        auto own_place = [&](std::size_t i) {  // of locals with a place of their own
            return early_[i] ? 0 : 2 * block[module_.values[i].layer.index] + 1;
        };
        auto has_own = [&](std::size_t i) {
            return early_[i] || (is_local_[i] && module_.values[i].layer.valid());
        };
        // In front of the first layer that needs it.
        std::vector<std::size_t> place(count_, behind_all);
        for (std::size_t i = count_; i-- > 0;) {
            if (has_own(i)) place[i] = own_place(i);
            for (ValueId operand : module_.values[i].operands)
                place[operand.index] = std::min(place[operand.index], place[i] / 2 * 2);
        }
        // But never in front of what it stands on itself.
        std::vector<std::vector<Local>> sorted(behind_all + 1);
        for (std::size_t i = 0; i < count_; ++i) {
            std::size_t earliest = is_local_[i] ? place[i] : 0;
            for (ValueId operand : module_.values[i].operands)
                earliest = std::max(earliest, place[operand.index]);
            place[i] = earliest;
            if (is_local_[i]) sorted[earliest].push_back({i, {}});
        }
        for (std::size_t layer = 0; layer < block.size(); ++layer) {
            for (Local& local : sorted[2 * block[layer] + 1])
                local.layer = {static_cast<std::uint32_t>(layer)};
        }
        for (const auto& locals : sorted)
            plan_.locals.insert(plan_.locals.end(), locals.begin(), locals.end());
    }

    // By layer: which one it is of those that have locals, in the module's order.
    [[nodiscard]] std::vector<std::size_t> blocks() const {
        std::vector<std::size_t> out(module_.layers.size(), 0);
        std::size_t last = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            ir::LayerId layer = module_.values[i].layer;
            if (is_local_[i] && !early_[i] && layer.valid() && out[layer.index] == 0)
                out[layer.index] = ++last;
        }
        return out;
    }

    const ir::Module& module_;
    Wording (*wording_)(ir::Op);
    std::size_t count_;
    std::vector<bool> early_, is_local_;
    std::vector<std::uint32_t> uses_;
    Plan plan_;
};

}  // namespace

Wording stage_wording(ir::Op op) {
    return {ir::info(op).glsl, ir::info(op).include};
}

Plan plan_of(const ir::Module& module, Wording (*wording)(ir::Op)) {
    return Planner(module, wording).run();
}

}  // namespace sg::emit

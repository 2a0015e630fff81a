#include "host_manifest.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/ice.hpp"
#include "ir/evaluate.hpp"
#include "ir/host.hpp"

namespace sg {
namespace {

using Json = nlohmann::ordered_json;
using ir::Op;
using ir::Value;
using ir::ValueId;

constexpr std::size_t kMaxDepth = 16;  // of an expression; deeper ones are cut into steps

Json numbers(const Value& value) {
    const std::size_t count = ir::component_count(value.type);
    if (count == 1) return value.number[0];
    Json out = Json::array();
    for (std::size_t i = 0; i < count; ++i) out.push_back(value.number[i]);
    return out;
}

// Writes Module::host as expressions. What is used twice is a step, so that the text is as long as the graph.
class Expressions {
public:
    explicit Expressions(const ir::Module& module) : module_(module), uses_(module.host.size()) {
        for (const Value& value : module.host) {
            for (ValueId operand : value.operands) ++uses_[operand.index];
        }
        for (const ir::Derived& derived : module.derived) ++uses_[derived.host.index];
        std::vector<std::size_t> depth(module.host.size());
        for (std::size_t i = 0; i < module.host.size(); ++i) {
            const Value& value = module.host[i];
            for (ValueId operand : value.operands) depth[i] = std::max(depth[i], depth[operand.index] + 1);
            texts_.push_back(written(value));
            const ir::HostOp* op = ir::host_op(value.op);
            if (!op || !op->costs || (uses_[i] < 2 && depth[i] < kMaxDepth)) continue;
            steps.push_back(std::move(texts_[i]));
            texts_[i] = fmt::format("#{}", steps.size() - 1);
            depth[i] = 0;
        }
    }
    [[nodiscard]] const Json& of(ValueId host) const { return texts_[host.index]; }
    Json steps = Json::array();

private:
    Json written(const Value& value) {
        if (value.op == Op::constant) return numbers(value);
        if (value.op == Op::parameter) return "$" + module_.parameters[value.index].name;
        const ir::HostOp* op = ir::host_op(value.op);
        SG_ASSERT(op != nullptr);
        if (op->word.empty()) return texts_[value.operands[0].index];
        Json out = Json::array({op->word});
        for (ValueId operand : value.operands) out.push_back(texts_[operand.index]);
        if (ir::info(value.op).attribute != ir::Attribute::None) out.push_back(value.index);
        return out;
    }

    const ir::Module& module_;
    std::vector<std::size_t> uses_;
    std::vector<Json> texts_;
};

// What a block can hold: the nearest finite float, 0 for what is no number.
float stored(double value) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    return std::isnan(value) ? 0.0F : static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

std::vector<float> stored(const ir::Datum& datum) {
    std::vector<float> out;
    for (double number : ir::components(datum)) out.push_back(stored(number));
    return out;
}

// By parameter, then by derived parameter.
std::vector<std::vector<float>> default_values(const ir::Module& module,
                                               const material::CheckedMaterial& material) {
    std::vector<std::vector<float>> out;
    ir::Bindings bindings;
    for (const material::CheckedParameter& p : material.parameters) {
        ir::Type type = material::ir_type(p.type);
        out.push_back(stored(ir::datum_of(type, p.fallback)));
        std::array<double, 16> rounded{};
        std::copy(out.back().begin(), out.back().end(), rounded.begin());
        bindings.parameters.push_back(ir::datum_of(type, rounded));
    }
    for (const ir::Datum& datum : ir::derived_values(ir::with_stored_numbers(module), bindings))
        out.push_back(stored(datum));
    return out;
}

std::string hexadecimal(const emit::MaterialInterface& interface,
                        const std::vector<std::vector<float>>& values) {
    std::vector<std::uint8_t> block(interface.block_size);
    for (std::size_t i = 0; i < values.size(); ++i) {
        std::size_t at = interface.parameters[i].offset;
        for (float number : values[i]) {
            const auto bits = std::bit_cast<std::uint32_t>(number);
            for (unsigned shift = 0; shift < 32; shift += 8)
                block[at++] = static_cast<std::uint8_t>(bits >> shift & 0xFFu);
        }
    }
    std::string out;
    for (std::uint8_t byte : block) out += fmt::format("{:02x}", byte);
    return out;
}

std::string_view type_word(ir::Type type) {
    return type == ir::Type::Color ? "color" : ir::info(type).glsl;
}

}  // namespace

std::string host_json(const ir::Module& module, const material::CheckedMaterial& material,
                      const emit::MaterialInterface& interface) {
    const auto values = default_values(module, material);
    const std::size_t given = material.parameters.size();
    Expressions expressions(module);
    Json out = Json::object();
    for (std::size_t i = 0; i < module.derived.size(); ++i) {
        const ir::Derived& derived = module.derived[i];
        out["derived"].push_back({{"name", derived.name},
                                  {"member", interface.parameters[given + i].member},
                                  {"type", type_word(derived.type)},
                                  {"offset", interface.parameters[given + i].offset},
                                  {"default", values[given + i]},
                                  {"expression", expressions.of(derived.host)}});
    }
    if (!expressions.steps.empty()) out["steps"] = std::move(expressions.steps);
    out["default_bytes"] = hexadecimal(interface, values);
    return out.dump();
}

}  // namespace sg

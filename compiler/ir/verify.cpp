#include <fmt/core.h>

#include <cmath>

#include "base/ice.hpp"
#include "ir/host.hpp"
#include "ir/ir.hpp"

namespace sg::ir {
namespace {

using Where = ModuleFault::Where;

struct Verifier {
    const Module& module;
    std::vector<ModuleFault> faults{};

    void fault(Where where, std::string what) { faults.push_back({where, std::move(what)}); }

    void operands(std::size_t i, const Value& value, const OpInfo& row, Where where) {
        if (row.attribute == Attribute::Function && value.index >= module.functions.size()) return;
        const std::vector<Type> types = operand_types(module, value);
        if (value.operands.size() != types.size()) {
            fault(where, fmt::format("'{}' takes {} operands, found {}", row.name, types.size(),
                                     value.operands.size()));
            return;
        }
        for (std::size_t k = 0; k < value.operands.size(); ++k) {
            ValueId operand = value.operands[k];
            if (operand.index >= i) {
                fault(where, fmt::format("operand {} is not an earlier value", k));
                continue;
            }
            Type found = module.at(operand).type;
            if (found != types[k]) {
                fault(where, fmt::format("'{}' takes {} as operand {}, found {} (%{})", row.name,
                                         info(types[k]).name, k, info(found).name, operand.index));
            }
        }
    }

    void attribute(const Value& value, const OpInfo& row, Where where) {
        switch (row.attribute) {
            case Attribute::Set:
                if (value.index > 7) fault(where, fmt::format("uv set {} is not in 0..7", value.index));
                break;
            case Attribute::Texture:
                if (value.index >= module.textures.size()) fault(where, "no such texture");
                break;
            case Attribute::Parameter:
                if (value.index >= module.parameters.size()) {
                    fault(where, "no such parameter");
                } else if (module.parameters[value.index].type != value.type) {
                    fault(where,
                          fmt::format("parameter '{}' is {}, the value is {}",
                                      module.parameters[value.index].name,
                                      info(module.parameters[value.index].type).name, info(value.type).name));
                }
                break;
            case Attribute::Zero:
                if (!(value.number[0] >= 127.0 && value.number[0] <= 128.0)) {
                    fault(where, fmt::format("zero {} is not in 127..128", value.number[0]));
                }
                break;
            case Attribute::Number:
                for (double n : value.number) {
                    if (!std::isfinite(n)) fault(where, "a constant is not finite");
                }
                break;
            case Attribute::Count:
                below(value, 65, "count", where);
                break;
            case Attribute::Channel:
            case Attribute::Corner:
                below(value, 4, "channel or corner", where);
                break;
            case Attribute::Swizzle:
                below(value, 256, "swizzle", where);
                break;
            case Attribute::Axis:
                below(value, 3, "axis", where);
                break;
            case Attribute::Function:
                if (value.index >= module.functions.size()) {
                    fault(where, "no such function");
                    break;
                }
                for (std::uint32_t texture : textures_of(module, value)) {
                    if (texture >= module.textures.size()) fault(where, "no such texture");
                }
                if (module.functions[value.index].shader >= module.shaders.size())
                    fault(where, "no such shader");
                break;
            case Attribute::Derived:
                if (value.index >= module.derived.size()) {
                    fault(where, "no such derived number");
                } else if (module.derived[value.index].type != value.type) {
                    fault(where,
                          fmt::format("derived '{}' is {}, the value is {}", module.derived[value.index].name,
                                      info(module.derived[value.index].type).name, info(value.type).name));
                }
                break;
            case Attribute::None:
                break;
        }
    }

    // What the host computes depends on parameters alone.
    void host() {
        const Module program{.parameters = module.parameters, .values = module.host};
        Verifier inner{program};
        for (std::size_t i = 0; i < module.host.size(); ++i) {
            const Op op = module.host[i].op;
            if (op == Op::constant || op == Op::parameter || host_op(op)) {
                inner.value(i);
            } else {
                inner.fault({Where::Of::value, i},
                            fmt::format("'{}' is nothing that the host computes", info(op).name));
            }
        }
        for (ModuleFault& found : inner.faults)
            fault({Where::Of::host, found.where.index}, std::move(found.what));
        for (std::size_t i = 0; i < module.derived.size(); ++i) {
            const Derived& derived = module.derived[i];
            if (derived.host.index >= module.host.size() ||
                module.host[derived.host.index].type != derived.type)
                fault({Where::Of::derived, i}, "is no value of the host of its type");
        }
    }

    void below(const Value& value, std::uint32_t limit, std::string_view what, Where where) {
        if (value.index >= limit)
            fault(where, fmt::format("{} {} is not in 0..{}", what, value.index, limit - 1));
    }

    void value(std::size_t i) {
        const Value& v = module.values[i];
        const OpInfo& row = info(v.op);
        const Where where{Where::Of::value, i};
        if (row.result != Type::Any && v.type != row.result) {
            fault(where, fmt::format("'{}' gives {}, the value is {}", row.name, info(row.result).name,
                                     info(v.type).name));
        }
        const bool matrix = v.op == Op::parameter && v.type == Type::Projector;
        if (row.result == Type::Any && component_count(v.type) == 0 && !matrix) {
            fault(where, fmt::format("'{}' cannot give {}", row.name, info(v.type).name));
        }
        if (v.layer.valid() && v.layer.index >= module.layers.size()) fault(where, "no such layer");
        operands(i, v, row, where);
        attribute(v, row, where);
    }

    // Neighbouring pixels see other places of a surface behind parallax: differences between them mean
    // nothing.
    void derivatives_after_parallax() {
        std::size_t looked = 0;
        while (looked < module.values.size() && !looks_along_ray(module.values[looked].op)) ++looked;
        for (std::size_t i = looked; i < module.values.size(); ++i) {
            const Op op = module.values[i].op;
            if (!takes_screen_derivatives(op)) continue;
            fault({Where::Of::value, i},
                  fmt::format("'{}' takes screen derivatives behind parallax ('{}', %{})", info(op).name,
                              info(module.values[looked].op).name, looked));
        }
    }

    void output(std::size_t i) {
        const OutputBinding& binding = module.outputs[i];
        const Where where{Where::Of::output, i};
        if (binding.value.index >= module.values.size()) {
            fault(where, "no such value");
            return;
        }
        Type found = module.at(binding.value).type;
        if (found != output_type(binding.output)) {
            fault(where, fmt::format("takes {}, found {} (%{})", info(output_type(binding.output)).name,
                                     info(found).name, binding.value.index));
        }
        const bool of_uv = binding.output == Output::uv || binding.output == Output::moved_uv;
        const bool of_layer = binding.output == Output::layer;
        if (of_layer ? binding.set >= module.layers.size()
                     : binding.set > (of_uv                              ? 7u
                                      : binding.output == Output::volume ? 1u
                                                                         : 0u))
            fault(where, of_layer ? "has no such layer" : "has no such number");
        for (std::size_t j = 0; j < i; ++j) {
            if (module.outputs[j].output == binding.output && module.outputs[j].set == binding.set) {
                fault(where, "is set twice");
            }
        }
    }
};

std::string name_of(const Module& module, Where where) {
    switch (where.of) {
        case Where::Of::value:
            return fmt::format("%{}", where.index);
        case Where::Of::host:
            return fmt::format("host %{}", where.index);
        case Where::Of::derived:
            return "derived " + module.derived[where.index].name;
        case Where::Of::output:
            return fmt::format("output {}", output_name(module.outputs[where.index].output));
    }
    SG_UNREACHABLE("a kind of place that is none");
}

}  // namespace

std::vector<ModuleFault> faults_of(const Module& module) {
    Verifier verifier{module};
    verifier.host();
    for (std::size_t i = 0; i < module.values.size(); ++i) verifier.value(i);
    verifier.derivatives_after_parallax();
    for (std::size_t i = 0; i < module.outputs.size(); ++i) verifier.output(i);
    return std::move(verifier.faults);
}

std::string verify(const Module& module) {
    std::string out;
    for (const ModuleFault& found : faults_of(module))
        out += fmt::format("{}: {}\n", name_of(module, found.where), found.what);
    return out;
}

}  // namespace sg::ir

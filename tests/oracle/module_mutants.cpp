#include "tests/oracle/module_mutants.hpp"

#include <algorithm>

namespace sg::oracle {
namespace {

using ir::Module;
using ir::Op;
using ir::Type;
using ir::ValueId;

// Every use of the value becomes one of its operand.
bool forward(Module& module, const ir::Value& value, std::size_t operand) {
    const auto self = static_cast<std::uint32_t>(&value - module.values.data());
    const ValueId instead = value.operands[operand];
    for (ir::Value& user : module.values)
        std::replace(user.operands.begin(), user.operands.end(), ValueId{self}, instead);
    for (ir::OutputBinding& output : module.outputs) {
        if (output.value == ValueId{self}) output.value = instead;
    }
    return true;
}

// The operand becomes another earlier value of its type.
bool exchange(Module& module, ir::Value& value, std::size_t operand) {
    const ValueId old = value.operands[operand];
    const auto self = static_cast<std::uint32_t>(&value - module.values.data());
    for (std::uint32_t i = 0; i < self; ++i) {
        if (i == old.index || module.values[i].type != module.at(old).type) continue;
        value.operands[operand] = {i};
        return true;
    }
    return false;
}

template <Op op, std::size_t operand>
bool forwarded(Module& module, ir::Value& value) {
    return value.op == op && forward(module, value, operand);
}
template <Op op, std::size_t operand>
bool exchanged(Module& module, ir::Value& value) {
    return value.op == op && exchange(module, value, operand);
}
bool tiling_is_negated(Module&, ir::Value& value) {
    if (value.op != Op::constant || value.type != Type::Vec2 || value.number[0] == 0.0) return false;
    value.number[0] = -value.number[0];
    return true;
}
bool zero_is_another(Module&, ir::Value& value) {
    if (value.op != Op::decode_normal_xyz && value.op != Op::decode_normal_xy) return false;
    value.number[0] = value.number[0] == 128.0 ? 127.0 : 128.0;
    return true;
}

bool derived_is_another(Module& module, ir::Value& value) {
    if (value.op != Op::derived) return false;
    for (std::uint32_t i = 0; i < module.derived.size(); ++i) {
        if (i == value.index || module.derived[i].type != value.type) continue;
        value.index = i;
        return true;
    }
    return false;
}
// The host adds where it should multiply.
bool host_adds(Module& module, ir::Value& value) {
    if (value.op != Op::derived) return false;
    ir::Value& host = module.host[module.derived[value.index].host.index];
    if (host.op != Op::multiply) return false;
    host.op = Op::add;
    return true;
}

constexpr ModuleMutant kMutants[] = {
    {"a scale of a derivative is dropped", forwarded<Op::scale_deriv, 1>},
    {"a scale of a gradient is dropped", forwarded<Op::scale_surfgrad, 1>},
    {"the second derivative of a sum is dropped", forwarded<Op::add_deriv, 0>},
    {"the first gradient of a sum is dropped", forwarded<Op::add_surfgrad, 1>},
    {"the bump is not resolved", forwarded<Op::resolve, 0>},
    {"green stays up", forwarded<Op::deriv_green_up, 0>},
    {"any tiling shares the basis", forwarded<Op::basis_mirror, 0>},
    {"tiling is dropped", forwarded<Op::uv_scale, 0>},
    {"a back face stays a front face", forwarded<Op::mirror_normal, 0>},
    {"a projection takes another derivative", exchanged<Op::surfgrad_from_tbn, 0>},
    {"a projection takes another basis", exchanged<Op::surfgrad_from_tbn, 1>},
    {"a basis takes another coordinate", exchanged<Op::basis_uv, 1>},
    {"a read takes another coordinate", exchanged<Op::sample, 0>},
    {"a factor becomes negative", tiling_is_negated},
    {"the code of zero is another", zero_is_another},
    {"a derived number is another", derived_is_another},
    {"the host adds where it should multiply", host_adds},
};

}  // namespace

std::span<const ModuleMutant> all_module_mutants() {
    return kMutants;
}

bool apply_last(const ModuleMutant& mutant, Module& module) {
    return std::any_of(module.values.rbegin(), module.values.rend(),
                       [&](ir::Value& value) { return mutant.apply(module, value); });
}

}  // namespace sg::oracle

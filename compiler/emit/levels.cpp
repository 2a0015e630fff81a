#include "emit/levels.hpp"

#include <algorithm>

namespace sg::emit {
namespace {

using ir::Op;
using ir::Value;

// The same number for every pixel.
bool is_uniform(const Value& value, const std::vector<bool>& uniform) {
    switch (value.op) {
        case Op::constant:
        case Op::parameter:
        case Op::derived:
        case Op::time:
            return true;
        default:
            return !value.operands.empty() && ir::info(value.op).attribute == ir::Attribute::None &&
                   std::all_of(value.operands.begin(), value.operands.end(),
                               [&](ir::ValueId id) { return uniform[id.index]; });
    }
}

// The operand that this operation maps linearly, the others being uniform; SIZE_MAX where it does no such
// thing.
std::size_t mapped_operand(Op op) {
    switch (op) {
        case Op::uv_scale:
        case Op::uv_transform:
        case Op::volume_scale:
        case Op::triplanar_uv:
        case Op::triplanar_axis:
        case Op::decal_uv:
            return 0;
        case Op::decal_box:
            return 1;
        default:
            return SIZE_MAX;
    }
}

bool is_mapped(const Value& value, const std::vector<bool>& follows, const std::vector<bool>& uniform) {
    const std::size_t mapped = mapped_operand(value.op);
    if (mapped == SIZE_MAX || !follows[value.operands[mapped].index]) return false;
    for (std::size_t k = 0; k < value.operands.size(); ++k)
        if (k != mapped && !uniform[value.operands[k].index]) return false;
    return true;
}

}  // namespace

std::vector<bool> follows_the_pixels(const ir::Module& module) {
    std::vector<bool> follows(module.values.size(), false), uniform(module.values.size(), false);
    for (std::size_t i = 0; i < module.values.size(); ++i) {
        const Value& value = module.values[i];
        if (ir::looks_along_ray(value.op)) return std::vector<bool>(module.values.size(), false);
        uniform[i] = is_uniform(value, uniform);
        const bool given =
            value.op == Op::uv_set || value.op == Op::volume_object || value.op == Op::volume_world;
        follows[i] = given || is_mapped(value, follows, uniform);
    }
    return follows;
}

}  // namespace sg::emit

// What the host computes before it draws: expressions of parameters alone (Module::host, Module::derived).
#pragma once

#include <span>
#include <string_view>

#include "ir/ir.hpp"

namespace sg::ir {

// An operation that may stand in Module::host, beside constants and parameters.
struct HostOp {
    Op op{};
    std::string_view word;  // in the manifest's grammar; "" for one that changes the type and no number
    bool costs = true;      // whether a shader pays for it; channels and the like are free
};
std::span<const HostOp> all_host_ops();
const HostOp* host_op(Op op);  // null where the host cannot compute it

}  // namespace sg::ir

#include "ir/host.hpp"

#include <algorithm>

namespace sg::ir {
namespace {

// Words act on each component; a single number acts on all of them (compiler/artefacts.md).
constexpr HostOp kHostOps[] = {
    {Op::add, "add"},
    {Op::subtract, "subtract"},
    {Op::multiply, "multiply"},
    {Op::divide, "divide"},
    {Op::minimum, "minimum"},
    {Op::maximum, "maximum"},
    {Op::mix, "mix"},
    {Op::clamp, "clamp"},
    {Op::smoothstep, "smoothstep"},
    {Op::power, "power"},
    {Op::add_color, "add"},
    {Op::multiply_color, "multiply"},
    {Op::mix_color, "mix"},
    {Op::channel_of, "channel", false},
    {Op::rgb_of, "rgb", false},
    {Op::projector_axis, "row", false},
    {Op::unit, "unit"},
    {Op::grey, "", false},
    {Op::color, "", false},
};

}  // namespace

std::span<const HostOp> all_host_ops() {
    return kHostOps;
}

const HostOp* host_op(Op op) {
    auto at =
        std::find_if(std::begin(kHostOps), std::end(kHostOps), [&](const HostOp& h) { return h.op == op; });
    return at == std::end(kHostOps) ? nullptr : at;
}

}  // namespace sg::ir

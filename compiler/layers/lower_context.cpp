#include "layers/lower_context.hpp"

#include <fmt/core.h>

#include <utility>

namespace sg::layers {

using ir::Op;
using ir::ValueId;

// Makes a value outside any layer, once. Calls nest: the layer comes back when the outermost is done.
template <class Make>
ValueId LowerContext::shared(ValueId& slot, Make make) {
    if (slot.valid()) return slot;
    ir::LayerId before = std::exchange(layer_, ir::LayerId{});
    builder_.set_layer(layer_);
    slot = make();
    set_layer(before);
    return slot;
}

ValueId LowerContext::vertex_normal() {
    return shared(vertex_normal_, [&] { return builder_.add(Op::vertex_normal); });
}

ValueId LowerContext::facing() {
    return shared(facing_, [&] { return builder_.add(Op::facing, {}, "facing"); });
}

ValueId LowerContext::normal() {
    return shared(normal_, [&] {
        ValueId base = builder_.add(Op::base_normal, {vertex_normal()}, "base_normal");
        return mirror_ ? builder_.add(Op::mirror_normal, {base, facing()}, "base_normal") : base;
    });
}

ValueId LowerContext::frame() {
    return shared(frame_, [&] {
        ValueId n = normal();
        return builder_.add(Op::frame, {builder_.add(Op::position), n}, "frame");
    });
}

ValueId LowerContext::basis_vertex() {
    return shared(basis_vertex_, [&] {
        ValueId n = vertex_normal();
        return builder_.add(Op::basis_vertex, {n, builder_.add(Op::vertex_tangent)}, "basis_vertex");
    });
}

ValueId LowerContext::uv(std::uint32_t set) {
    return shared(uvs_[set], [&] { return builder_.add_indexed(Op::uv_set, set, {}, fmt::format("uv{}", set)); });
}

ValueId LowerContext::number(const FieldValue& value) {
    return value.parameter.valid() ? builder_.parameter(value.parameter)
                                   : builder_.constant(ir::Type::Scalar, {value.number[0]});
}

ValueId LowerContext::pair(const FieldValue& value) {
    if (!value.parameter.valid()) return builder_.constant(ir::Type::Vec2, {value.number[0], value.number[1]});
    ValueId parameter = builder_.parameter(value.parameter);
    bool scalar = builder_.module().at(parameter).type == ir::Type::Scalar;
    return scalar ? builder_.add(Op::splat, {parameter}) : parameter;
}

ValueId LowerContext::normal_map_deriv(ir::TextureId texture, ValueId uv) {
    const TextureFacts& facts = facts_[texture.index];
    bool xyz = builder_.module().textures[texture.index].encoding == ir::TextureEncoding::tangent_normal;
    ValueId texel = builder_.add_indexed(Op::sample, texture.index, {uv}, "texel");
    ValueId m = builder_.add_zero(xyz ? Op::decode_normal_xyz : Op::decode_normal_xy, facts.zero, texel, "m");
    ValueId deriv = builder_.add(xyz ? Op::deriv_from_normal_xyz : Op::deriv_from_normal_xy, {m}, "deriv");
    return facts.green_up ? builder_.add(Op::deriv_green_up, {deriv}, "deriv") : deriv;
}

}  // namespace sg::layers

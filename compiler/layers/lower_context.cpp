#include "layers/lower_context.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "base/ice.hpp"

namespace sg::layers {

using ir::Op;
using ir::Type;
using ir::ValueId;

namespace {

constexpr std::size_t kMaxLifted = 128;  // those behind them stay in the shader: a block has bounds

}  // namespace

LowerContext::LowerContext(ir::Builder& builder, std::vector<TextureFacts> facts,
                           std::vector<NodeInstance> nodes, Sides sides, Numbers numbers)
    : builder_(builder),
      facts_(std::move(facts)),
      nodes_(std::move(nodes)),
      node_values_(nodes_.size()),
      sides_(sides),
      numbers_(numbers) {}

namespace {

bool is_tiled(const FieldValue& tiling) {
    return tiling.parameter.valid() || tiling.number[0] != 1 || tiling.number[1] != 1;
}

}  // namespace

void LowerContext::set_layer(ir::LayerId layer) {
    layer_ = layer;
    builder_.set_layer(layer);
}

void LowerContext::begin_stage(ValueId resolved_normal) {
    normals_.push_back(resolved_normal);
    frames_.emplace_back();
    bases_.emplace_back();
    forget_stage();
}

void LowerContext::begin_entry(ValueId resolved_normal, std::string_view id) {
    stage_surface_ = id.empty() ? "bumped" : id;
    entry_normals_.push_back(resolved_normal);
    begin_stage(resolved_normal);
}

std::string LowerContext::of_stage(std::string_view hint) const {
    return stage_surface_ + (stage_surface_.empty() ? "" : "_") + std::string(hint);
}

// Nodes may look at the normal: those of the next stage see the new one.
void LowerContext::forget_stage() {
    node_values_.assign(nodes_.size(), {});
    detail_frame_ = {};
}

void LowerContext::begin_surface() {
    surface_ = true;
    if (on_detail()) node_values_.assign(nodes_.size(), {});
}

ValueId LowerContext::vertex_normal() {
    return shared(vertex_normal_, [&] { return builder_.add(Op::vertex_normal); });
}

ValueId LowerContext::mesh_position() {
    return shared(position_, [&] { return builder_.add(Op::position); });
}

ValueId LowerContext::facing() {
    return shared(facing_, [&] { return builder_.add(Op::facing, {}, "facing"); });
}

ValueId LowerContext::time() {
    return shared(time_, [&] { return builder_.add(Op::time, {}, "time"); });
}

ValueId LowerContext::vertex_color() {
    return shared(vertex_color_, [&] { return builder_.add(Op::vertex_color); });
}

ValueId LowerContext::normal() {
    return shared(normals_.back(), [&] {
        ValueId base = builder_.add(Op::base_normal, {vertex_normal()}, "base_normal");
        return sides_ == Sides::mirror ? builder_.add(Op::mirror_normal, {base, facing()}, "base_normal")
                                       : base;
    });
}

ValueId LowerContext::surface_normal() {
    std::size_t first = moved() ? moved_in_ - 1 : 0;
    return first + 1 == normals_.size() ? normal() : normals_[first];
}

ValueId LowerContext::first_frame() {
    return shared(frames_.front(), [&] {
        ValueId n = normals_.size() == 1 ? normal() : normals_.front();
        return builder_.add(Op::frame, {mesh_position(), n}, "frame");
    });
}

ValueId LowerContext::frame() {
    if (frames_.size() == 1) return first_frame();
    if (on_detail() && follows_) return detail_frame();
    return shared(frames_.back(), [&] {
        return builder_.add(Op::frame_resolved, {first_frame(), normal()}, of_stage("frame"));
    });
}

ValueId LowerContext::basis_vertex() {
    ValueId tangents = shared(vertex_tangents_, [&] {
        ValueId n = vertex_normal();
        return builder_.add(Op::basis_vertex, {n, builder_.add(Op::vertex_tangent)}, "basis_vertex");
    });
    if (bases_.size() == 1) return tangents;
    return shared(bases_.back(), [&] {
        return builder_.add(Op::basis_resolved, {tangents, normal()}, of_stage("basis_vertex"));
    });
}

ValueId LowerContext::uv_set(std::uint32_t set) {
    return shared(uv_sets_[set],
                  [&] { return builder_.add_indexed(Op::uv_set, set, {}, fmt::format("uv{}", set)); });
}

const void* LowerContext::lookup_of(const Coordinate& c) {
    return same_lookup({static_cast<double>(c.set), c.scale[0], c.scale[1], c.rotation, c.offset[0],
                        c.offset[1], c.speed[0], c.speed[1]});
}

ValueId LowerContext::scale_of(const Coordinate& c) {
    return written(Type::Vec2, {c.scale[0], c.scale[1]}, "scale", {lookup_of(c), 0});
}

ValueId LowerContext::uv(const Coordinate& c) {
    ValueId base = base_uv(c.set);
    if (c.is_plain()) return base;
    const void* lookup = lookup_of(c);
    ValueId scale = scale_of(c);
    bool moves = c.speed != std::array{0.0, 0.0};
    if (c.rotation == 0 && c.offset == std::array{0.0, 0.0} && !moves)
        return builder_.add(Op::uv_scale, {base, scale}, "uv");
    ValueId offset = written(Type::Vec2, {c.offset[0], c.offset[1]}, "offset", {lookup, 1});
    if (moves) {
        ValueId speed = written(Type::Vec2, {c.speed[0], c.speed[1]}, "speed", {lookup, 2});
        offset = builder_.add(Op::drift, {offset, speed, time()}, "drift");
    }
    ValueId rotation = written(c.rotation * std::numbers::pi / 180, "rotation", {lookup, 3});
    return builder_.add(Op::uv_transform, {base, scale, rotation, offset}, "uv");
}

// What parallax looked along goes straight to what is seen.
ValueId LowerContext::uv(const Coordinate& coordinate, const FieldValue& tiling) {
    if (!is_tiled(tiling)) return uv(coordinate);
    if (looked_along(coordinate, tiling)) return seen_uv();
    ValueId base = uv(coordinate);
    return builder_.add(Op::uv_scale, {base, pair(tiling)}, "uv");
}

ValueId LowerContext::mesh_volume(Space space) {
    bool object = space == Space::object;
    return shared(volumes_[static_cast<std::size_t>(space)], [&] {
        return builder_.add(object ? Op::volume_object : Op::volume_world, {}, object ? "object" : "world");
    });
}

ValueId LowerContext::constant(double number) {
    return builder_.constant(Type::Scalar, {number});
}

ValueId LowerContext::written(Type type, const std::array<double, 4>& number, std::string_view name,
                              NumberPlace place) {
    ir::Module& module = builder_.module();
    if (numbers_ == Numbers::baked) return builder_.constant(type, number);
    auto [slot, fresh] = slots_.try_emplace({place.at, place.part}, module.derived.size());
    if (fresh) {
        if (module.derived.size() >= kMaxLifted) {
            slots_.erase(slot);
            return builder_.constant(type, number);
        }
        std::string owner(layer_.valid() ? std::string_view(module.layers[layer_.index].id) : node_);
        builder_.lift(type, number, owner + (owner.empty() ? "" : "_") + std::string(name));
    }
    return builder_.derived(slot->second);
}

ValueId LowerContext::number(const FieldValue& value) {
    if (value.node.valid()) return node(value.node, Type::Scalar);
    if (value.parameter.valid()) return builder_.parameter(value.parameter);
    return written(value.number[0], value.field, {&value});
}

ValueId LowerContext::pair(const FieldValue& value) {
    if (!value.parameter.valid()) {
        const void* lookup = same_lookup({value.number[0], value.number[1]});
        return written(Type::Vec2, {value.number[0], value.number[1]}, value.field, {lookup});
    }
    ValueId parameter = builder_.parameter(value.parameter);
    bool scalar = builder_.module().at(parameter).type == Type::Scalar;
    return scalar ? builder_.add(Op::splat, {parameter}) : parameter;
}

ValueId LowerContext::color(const FieldValue& value) {
    if (value.node.valid()) return node(value.node, Type::Color);
    if (!value.parameter.valid()) {
        return written(Type::Color, {value.number[0], value.number[1], value.number[2]}, value.field,
                       {&value});
    }
    ValueId parameter = builder_.parameter(value.parameter);
    bool is_color = builder_.module().at(parameter).type == Type::Color;
    return is_color ? parameter : builder_.add(Op::color, {parameter});
}

// Each node is lowered once per stage, so that sharing costs nothing.
ValueId LowerContext::lowered(NodeId id) {
    const NodeInstance& instance = nodes_[id.index];
    return shared(node_values_[id.index], [&] {
        ++depth_;
        std::string_view outer = std::exchange(node_, instance.name);
        bool outer_follows = follow_parallax(follows_parallax(instance.values));
        ValueId made = instance.kind->lower(*this, instance.values);
        follow_parallax(outer_follows);
        node_ = outer;
        --depth_;
        ir::Value& last = builder_.module().values[made.index];
        if (!last.is_node && !instance.name.empty()) {
            last.name = instance.name;
            last.is_node = true;
        }
        return made;
    });
}

// All that a node stands on, with a stack of its own.
void LowerContext::lower_operands(NodeId id) {
    std::vector<NodeId> open{id};
    while (!open.empty()) {
        NodeId top = open.back(), next;
        for (const FieldValue& value : nodes_[top.index].values) {  // nodes have no arguments
            if (value.node.valid() && !node_values_[value.node.index].valid()) next = value.node;
        }
        if (next.valid()) {
            open.push_back(next);
            continue;
        }
        open.pop_back();
        if (top != id) lowered(top);
    }
}

ValueId LowerContext::node(NodeId id, Type wanted) {
    constexpr std::size_t kDeep =
        200;  // nodes calling each other; the program's stack holds no more than thousands
    if (depth_ >= kDeep && !node_values_[id.index].valid()) lower_operands(id);
    ValueId value = lowered(id);
    if (builder_.module().at(value).type == wanted) return value;
    SG_ASSERT(wanted == Type::Color);  // the check refuses a colour where a number is wanted
    return builder_.add(Op::grey, {value});
}

MapPlace LowerContext::place_map(const Coordinate& coordinate, const FieldValue& tiling, bool from_vertex) {
    MapPlace place;
    if (from_vertex) {
        place.vertex_basis = basis_vertex();
    } else {
        frame();
    }
    bool tiled = is_tiled(tiling), seen = tiled && looked_along(coordinate, tiling);
    place.uv = seen ? seen_uv() : uv(coordinate);
    auto turn = [&](ValueId scale) {
        // A negative tiling mirrors the picture, so +s and +t turn; tangents from the uv see that by
        // themselves.
        if (from_vertex)
            place.vertex_basis = builder_.add(Op::basis_mirror, {place.vertex_basis, scale}, "basis");
    };
    if (coordinate.scale != std::array{1.0, 1.0}) turn(scale_of(coordinate));
    if (tiled) {
        ValueId scale = pair(tiling);
        if (!seen) place.uv = builder_.add(Op::uv_scale, {place.uv, scale}, "uv");
        turn(scale);
    }
    return place;
}

ValueId LowerContext::basis_of(const MapPlace& place) {
    return place.vertex_basis.valid() ? place.vertex_basis
                                      : builder_.add(Op::basis_uv, {frame(), place.uv}, "basis");
}

ValueId LowerContext::texel(ir::TextureId texture, ValueId uv, std::string name) {
    // Of several outside of layers each is known by its texture.
    if (!layer_.valid()) name = fmt::format("{}_{}", builder_.module().textures[texture.index].name, name);
    ValueId stored = builder_.add_indexed(Op::sample, texture.index, {uv}, std::move(name));
    const TextureFacts& f = facts_[texture.index];
    if (f.swizzle == TextureFacts{}.swizzle) return stored;
    return builder_.add_indexed(Op::swizzle, ir::swizzle_of(f.swizzle), {stored});
}

ValueId LowerContext::map_deriv(ir::TextureId texture, ValueId uv) {
    using enum ir::TextureEncoding;
    const TextureFacts& f = facts_[texture.index];
    ir::TextureEncoding encoding = builder_.module().textures[texture.index].encoding;
    ValueId texel = this->texel(texture, uv);
    ValueId deriv;
    if (encoding == derivative) {
        deriv = builder_.add_zero(Op::decode_derivative, f.zero, {texel, written(f.range, "range", {&f})},
                                  "deriv");
    } else {
        bool xyz = encoding == tangent_normal;
        ValueId m =
            builder_.add_zero(xyz ? Op::decode_normal_xyz : Op::decode_normal_xy, f.zero, {texel}, "m");
        deriv = builder_.add(xyz ? Op::deriv_from_normal_xyz : Op::deriv_from_normal_xy, {m}, "deriv");
    }
    return f.green_up ? builder_.add(Op::deriv_green_up, {deriv}, "deriv") : deriv;
}

ValueId LowerContext::call(Op op, std::uint32_t shader, const std::string& name,
                           std::span<const Argument> arguments) {
    ir::Function function{.name = name, .shader = shader, .arguments = {}};
    std::vector<ValueId> operands;
    for (const Argument& a : arguments) {
        function.arguments.push_back(
            {a.type, a.kind == Argument::Kind::texture ? ir::TextureId{a.index} : ir::TextureId{}});
        switch (a.kind) {
            case Argument::Kind::surface:
                operands.push_back(surface_arguments()[a.index].lower(*this));
                break;
            case Argument::Kind::uv:
                operands.push_back(uv(a.uv));
                break;
            case Argument::Kind::numbers:
                operands.push_back(written(a.type, a.number, "argument", {&a}));
                break;
            case Argument::Kind::parameter:
                operands.push_back(builder_.parameter(a.parameter));
                break;
            case Argument::Kind::node:
                operands.push_back(node(a.node, a.type));
                break;
            case Argument::Kind::texture:
                break;
        }
    }
    auto& functions = builder_.module().functions;
    auto same = std::find(functions.begin(), functions.end(), function);
    auto index = static_cast<std::uint32_t>(same - functions.begin());
    if (same == functions.end()) functions.push_back(std::move(function));
    return builder_.add_indexed(op, index, std::move(operands), name);
}

ValueId LowerContext::surfgrad_from_local(ValueId local_gradient, Space space) {
    ValueId gradient = builder_.add(
        space == Space::object ? Op::gradient_from_object : Op::gradient_from_world, {local_gradient});
    return builder_.add(Op::surfgrad_from_volume, {normal(), gradient});
}

}  // namespace sg::layers

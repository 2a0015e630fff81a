#include "emit/interface.hpp"

#include <algorithm>

#include "base/ice.hpp"
#include "base/limits.hpp"
#include "emit/names.hpp"

namespace sg::emit {
const TextureSlot* MaterialInterface::texture(std::uint32_t index) const {
    auto it = std::find_if(textures.begin(), textures.end(),
                           [&](const TextureSlot& t) { return t.texture == index; });
    return it == textures.end() ? nullptr : &*it;
}

MaterialInterface material_interface(const ir::Module& module, std::span<const std::uint32_t> sampler_group) {
    MaterialInterface out;
    Names members, variables;
    std::uint32_t offset = 0;
    auto add = [&](std::string_view prefix, const std::string& name, ir::Type type) {
        const ir::Std140 layout = ir::std140(type);
        offset = ir::aligned(offset, layout.alignment);
        out.parameters.push_back({members.unique(prefix, name), type, offset});
        offset += layout.size;
    };
    for (const ir::Parameter& parameter : module.parameters) add("p_", parameter.name, parameter.type);
    out.first_derived = out.parameters.size();
    for (const ir::Derived& derived : module.derived) add("d_", derived.name, derived.type);
    out.block_size = ir::aligned(offset, 16);
    SG_ASSERT(out.block_size <= kMaxBlockBytes);  // the checker leaves room for what is derived

    std::vector<bool> sampled(module.textures.size(), false);
    for (const ir::Value& value : module.values) {
        for (std::uint32_t texture : ir::textures_of(module, value)) sampled[texture] = true;
    }
    std::uint32_t binding = 1;
    for (std::uint32_t i = 0; i < module.textures.size(); ++i) {
        if (sampled[i])
            out.textures.push_back({variables.unique("t_", module.textures[i].name), i, binding++, 0});
    }
    for (TextureSlot& slot : out.textures) {
        std::uint32_t group = sampler_group[slot.texture];
        auto it = std::find_if(out.samplers.begin(), out.samplers.end(),
                               [&](const SamplerSlot& s) { return s.group == group; });
        if (it == out.samplers.end()) {
            out.samplers.push_back(
                {variables.unique("s_", std::to_string(out.samplers.size())), group, binding++});
            it = out.samplers.end() - 1;
        }
        slot.sampler = static_cast<std::uint32_t>(it - out.samplers.begin());
    }
    return out;
}

bool reads_block(ir::Attribute attribute) {
    return attribute == ir::Attribute::Parameter || attribute == ir::Attribute::Derived;
}

bool is_varying(ir::Op op) {
    switch (op) {
        case ir::Op::position:
        case ir::Op::vertex_normal:
        case ir::Op::vertex_tangent:
        case ir::Op::vertex_color:
        case ir::Op::uv_set:
        case ir::Op::volume_object:
            return true;
        default:
            return false;
    }
}

VertexInput vertex_input(const Varying& varying) {
    static constexpr std::string_view kUvNames[] = {"uv0", "uv1", "uv2", "uv3", "uv4", "uv5", "uv6", "uv7"};
    switch (varying.source) {
        case ir::Op::vertex_normal:
            return {"normal", "float3", "vec3", 1};
        case ir::Op::vertex_tangent:
            return {"tangent", "float4", "vec4", 2};
        case ir::Op::vertex_color:
            return {"color", "float4", "vec4", 3};
        case ir::Op::uv_set:
            return {kUvNames[varying.set], "float2", "vec2", 4 + varying.set};
        default:
            SG_ASSERT(is_varying(varying.source));
            return {"position", "float3", "vec3", 0};
    }
}

std::vector<VertexInput> vertex_inputs(std::span<const Varying> varyings) {
    std::vector<VertexInput> out{vertex_input({ir::Op::position, 0})};
    for (const Varying& varying : varyings) {
        VertexInput input = vertex_input(varying);
        if (input.location != out.front().location) out.push_back(input);
    }
    return out;
}

// The numbers of the vertex attributes; the position in object space stands behind them.
std::uint32_t varying_location(const Varying& varying) {
    if (varying.source == ir::Op::volume_object) return 12;
    return vertex_input(varying).location;
}

std::string_view varying_name(const Varying& varying) {
    if (varying.source == ir::Op::volume_object) return "object_position";
    return vertex_input(varying).name;
}

}  // namespace sg::emit
